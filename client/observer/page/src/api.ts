import { el } from "./dom";
import type { Changes, Detections, Frame, HistoryList, Option, RobotLine, Seen, Who } from "./types";

// Three times what the observer lets pass without a word; and until it takes a page in. Shorter, as
// a browser may try one lost connection after the other.
const SILENCE_MS = 15_000;
const OPENING_MS = 5_000;
export const RETRY_MS = 1000; // where nobody answers

let csrf = "";
let underWay = new AbortController(); // of what is fetched

let onRefused: () => void = () => {};

export class Refused extends Error {}

async function get(path: string): Promise<Response | null> {
  const response = await fetch(path, { signal: underWay.signal });
  if (response.status === 401) {
    onRefused();
    throw new Refused("not logged in");
  }
  return response.ok ? response : null; // 404: the frame has passed
}

// For what somebody waits to be told.
async function ask(path: string, init?: RequestInit): Promise<Response> {
  return fetch(path, init).catch(() => {
    throw new Error("the observer cannot be reached");
  });
}

function ofFrame(kind: string, robot: string, id: number): string {
  return `/api/${kind}?robot=${encodeURIComponent(robot)}&id=${id}`;
}

export async function who(): Promise<Who | null> {
  const response = await fetch("/api/session");
  if (!response.ok) return null;
  const answer = (await response.json()) as Who;
  csrf = answer.csrf;
  return answer;
}

const hasSession = () => fetch("/api/session").then((response) => response.status !== 401, () => true);

export async function logIn(token: string): Promise<Who> {
  const response = await ask("/api/login", { method: "POST", body: JSON.stringify({ token }) });
  const answer = await response.json();
  if (!response.ok) throw new Error(answer.error);
  csrf = answer.csrf;
  return answer as Who;
}

export async function logOut(): Promise<void> {
  const response = await fetch("/api/logout", { method: "POST", headers: { "X-Fovea-CSRF": csrf } });
  if (!response.ok && response.status !== 401) throw new Error((await response.json()).error);
}

export async function historyOf(robot: string): Promise<HistoryList | null> {
  const response = await get(`/api/history?robot=${encodeURIComponent(robot)}`);
  return response ? ((await response.json()) as HistoryList) : null;
}

// A frame of the history with all that is shown of it; null where it has passed.
export async function pastFrame(robot: string, id: number, withDepth: boolean): Promise<Seen | null> {
  const response = await get(ofFrame("history/answer", robot, id));
  if (!response) return null;
  const { line, frame } = (await response.json()) as { line: RobotLine; frame: Frame };
  const [picture, depth] = await Promise.all([
    pictureOf("history/picture", robot, id),
    withDepth ? depthOf(robot, id, "history/depth") : null,
  ]);
  return { line, frame, picture, depth, past: true };
}

// One frame, or those of some seconds around it, as a file for whoever looks into it: its name, and
// when the frame in the middle was answered.
export async function saveBundle(robot: string, at: number, before: number, after: number): Promise<{ name: string; answeredAtMs: number }> {
  const query = `robot=${encodeURIComponent(robot)}&at=${at}&before=${before}&after=${after}`;
  const response = await ask(`/api/history/bundle?${query}`);
  if (!response.ok) throw new Error(response.status === 404 ? "the history holds nothing of that time" : (await response.json()).error);
  const name = /filename="([^"]+)"/.exec(response.headers.get("Content-Disposition") ?? "")?.[1] ?? "bundle.zip";
  const url = URL.createObjectURL(await response.blob());
  el("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
  return { name, answeredAtMs: Number(response.headers.get("Fovea-Answered-At-Ms")) };
}

async function answerOr<Answer>(response: Response): Promise<Answer> {
  const answer = await response.json();
  if (!response.ok) throw new Error(response.status === 404 ? "this frame cannot be had any more" : answer.error);
  return answer as Answer;
}

const post = (path: string, body: unknown) =>
  ask(path, { method: "POST", headers: { "X-Fovea-CSRF": csrf }, body: JSON.stringify(body) });

export async function optionsOf(robot: string, id: number): Promise<Option[]> {
  return (await answerOr<{ options: Option[] }>(await ask(ofFrame("options", robot, id)))).options;
}

// What would be answered to a frame of the history.
export async function tryOptions(robot: string, id: number, parameters: Record<string, number>): Promise<Detections> {
  const response = await post("/api/try", { robot, id, options: { parameters } });
  return (await answerOr<{ detections: Detections }>(response)).detections;
}

// Marks an object for the robot, and tells whether it got that.
export async function pickObject(robot: string, id: number, past: boolean, label: number): Promise<string> {
  const { delivered, reason } = await answerOr<{ delivered: boolean; reason: string }>(await post("/api/pick", { robot, id, past, label }));
  return delivered ? "" : reason;
}

export async function answerOf(robot: string, id: number): Promise<Frame | null> {
  const response = await get(ofFrame("answer", robot, id));
  return response ? ((await response.json()) as Frame) : null;
}

export async function pictureOf(kind: "preview" | "picture" | "history/picture", robot: string, id: number) {
  const response = await get(ofFrame(kind, robot, id));
  if (!response) return null;
  // Colours as they are: the depth's pixels are matched with these.
  return createImageBitmap(await response.blob(), { colorSpaceConversion: "none" });
}

export async function depthOf(robot: string, id: number, kind = "depth"): Promise<Uint16Array | null> {
  const response = await get(ofFrame(kind, robot, id));
  return response ? new Uint16Array(await response.arrayBuffer()) : null;
}

// One for the whole page, as browsers have six connections for all pages of a host; none while
// nobody sees the page.
export class Events {
  private source: EventSource | null = null;
  private silence = 0; // a timer
  private query: string | null = null; // of what is wanted; null: nothing
  private asking: Promise<boolean> | null = null; // whether there is a session
  onChanges: (changes: Changes) => void = () => {};
  onState: (connected: boolean) => void = () => {};
  onEnd: () => void = () => {};

  constructor() {
    onRefused = () => void this.endUnlessKnown();
    document.addEventListener("visibilitychange", () => {
      if (document.hidden) this.disconnect();
      else this.connect();
    });
  }

  open(close: string, depth: boolean): void {
    this.query = close ? `?close=${encodeURIComponent(close)}${depth ? "&depth=1" : ""}` : "";
    this.connect();
  }

  private connect(): void {
    this.disconnect();
    if (this.query === null || document.hidden) return;
    const source = new EventSource(`/api/events${this.query}`);
    const heard = (patience = SILENCE_MS) => {
      clearTimeout(this.silence);
      this.silence = window.setTimeout(() => this.giveUp(), patience);
    };
    source.onopen = () => {
      heard();
      this.onState(true);
    };
    source.onmessage = (event) => {
      heard();
      this.onChanges(JSON.parse(event.data) as Changes);
    };
    source.addEventListener("alive", () => heard());
    source.addEventListener("ended", () => this.onEnd());
    source.onerror = () => {
      this.onState(false);
      if (source.readyState === EventSource.CLOSED) this.reopen(source);
    };
    this.source = source;
    heard(OPENING_MS);
  }

  // An observer that hangs, and a network that loses everything, end no connection.
  private giveUp(): void {
    this.onState(false);
    underWay.abort();
    underWay = new AbortController();
    this.connect();
  }

  // The browser gives up where it is answered with an error: the observer may have started anew.
  private reopen(source: EventSource): void {
    setTimeout(async () => {
      if (this.source === source && (await this.endUnlessKnown()) && this.source === source) this.connect();
    }, RETRY_MS);
  }

  // Of a browser that has lost its cookie the events go on; one of a log in just now is known. True
  // where the page goes on.
  private async endUnlessKnown(): Promise<boolean> {
    if (this.query === null) return false;
    this.asking ??= hasSession().finally(() => (this.asking = null));
    const known = await this.asking;
    if (!known && this.query !== null) this.onEnd();
    return known;
  }

  stop(): void {
    this.query = null;
    this.disconnect();
  }

  private disconnect(): void {
    clearTimeout(this.silence);
    this.source?.close();
    this.source = null;
  }
}
