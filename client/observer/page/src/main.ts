import { Events, logIn, logOut, who } from "./api";
import { el } from "./dom";
import { setClock } from "./pace";
import { RobotView } from "./robot";
import { Tiles } from "./tiles";
import type { Changes, ServerLine, Who } from "./types";

const main = document.getElementById("main")!;
const servers = document.getElementById("servers")!;
const header = document.getElementById("who")!;
const title = document.title;
const events = new Events();
const pages = new BroadcastChannel("session"); // all of this browser
let tiles: Tiles | null = null;
let me: Who | null = null; // while the page asks for a token
let close: RobotView | null = null;
let hasNews = false; // from the observer, since it was away

// What the address has after "#name="; as it stands where somebody wrote a "%" by hand.
function inAddress(name: string): string {
  const [, text = ""] = new RegExp(`^#${name}=(.*)$`).exec(location.hash) ?? [];
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

function say(lines: ServerLine[]): void {
  const texts = lines.map(({ address, state, problem }) =>
    state === "watching" ? `${address}` : `${address} is ${state}${problem ? `: ${problem}` : ""}`,
  );
  servers.textContent = texts.join(", ");
  servers.classList.toggle("bad", lines.some((line) => line.state !== "watching"));
}

function onChanges(changes: Changes): void {
  hasNews = true;
  setClock(changes.now_us);
  say(changes.servers);
  tiles?.update(changes.robots);
  if (close) close.update(changes.close, changes.robots.find((line) => line.robot === close!.robot));
}

function onState(connected: boolean): void {
  if (connected && !hasNews) servers.textContent = "";
  if (connected) return;
  hasNews = false;
  servers.textContent = "the observer is away; trying again";
  servers.classList.add("bad");
}

function show(): void {
  if (!me || !tiles) return;
  const robot = inAddress("robot");
  const before = close?.robot ?? "";
  if (robot && close?.robot === robot) return;
  close?.close();
  close = robot ? new RobotView(robot, me) : null;
  document.title = robot ? `${robot} – ${title}` : title;
  main.replaceChildren(close ? close.element : tiles.element);
  if (close) {
    close.onBack = () => (location.hash = "");
    close.onDepth = (wanted) => events.open(robot, wanted);
  } else if (before) {
    tiles.focus(before);
  }
  events.open(robot, false);
}

function start(who: Who): void {
  me = who;
  const out = el("button", { type: "button" }, "log out");
  out.addEventListener("click", async () => {
    try {
      await logOut();
      askForToken("");
    } catch {
      servers.textContent = `the observer is away, and ${who.name} is still logged in`;
      servers.classList.add("bad");
    }
  });
  header.replaceChildren(`${who.name} `, out);
  close?.close();
  tiles?.close();
  tiles = new Tiles((robot) => (location.hash = `robot=${encodeURIComponent(robot)}`));
  close = null;
  show();
}

// One cookie is for all pages of a browser: the others go on as whoever it is now.
async function startAnew(token: string): Promise<void> {
  const who = await logIn(token);
  pages.postMessage("");
  start(who);
}

function askForToken(problem: string): void {
  events.stop();
  close?.close();
  close = me = null;
  header.replaceChildren();
  servers.textContent = "";
  document.title = title;
  const input = el("input", { id: "token", type: "password", autocomplete: "current-password", required: "" });
  const failure = el("p", { class: "bad", role: "alert", id: "failure" }, problem);
  const form = el("form", {}, el("label", { for: "token" }, "Token of an observer"), input, el("button", {}, "Log in"), failure);
  form.addEventListener("submit", async (event) => {
    event.preventDefault();
    try {
      await startAnew(input.value);
    } catch (error) {
      failure.textContent = (error as Error).message;
    }
  });
  main.replaceChildren(form);
  input.focus();
}

// "#token=…", as the demo prints it, logs in and does not stay in the address.
async function begin(): Promise<void> {
  const token = inAddress("token");
  if (token) history.replaceState(null, "", location.pathname);
  try {
    if (token) return await startAnew(token);
    const known = await who().catch(() => null);
    if (known) start(known);
    else askForToken("");
  } catch (error) {
    askForToken((error as Error).message);
  }
}

events.onChanges = onChanges;
events.onState = onState;
events.onEnd = () => askForToken("Logged out elsewhere, or the token does not hold any more, or the observer has started anew.");
pages.addEventListener("message", () => void begin());
addEventListener("hashchange", () => {
  if (inAddress("token")) void begin();
  else show();
});
// Browsers keep pages that were left for a while, and six connections for all pages of a host.
addEventListener("pagehide", () => events.stop());
addEventListener("pageshow", (event) => {
  if (event.persisted) location.reload();
});
addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.target instanceof HTMLInputElement) return;
  // On a button, space presses that.
  if (event.key === " " && event.target instanceof HTMLButtonElement) return;
  if (close?.onKey(event.key, event.repeat)) event.preventDefault();
});
void begin();
