import type { Changes, Frame, Who } from "./types";

let csrf = "";

export class Refused extends Error {}

async function get(path: string): Promise<Response | null> {
  const response = await fetch(path);
  if (response.status === 401) throw new Refused("not logged in");
  return response.ok ? response : null; // 404: the frame has passed
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

export async function logIn(token: string): Promise<Who> {
  const response = await fetch("/api/login", { method: "POST", body: JSON.stringify({ token }) });
  const answer = await response.json();
  if (!response.ok) throw new Error(answer.error);
  csrf = answer.csrf;
  return answer as Who;
}

export async function logOut(): Promise<void> {
  await fetch("/api/logout", { method: "POST", headers: { "X-Fovea-CSRF": csrf } });
}

export async function answerOf(robot: string, id: number): Promise<Frame | null> {
  const response = await get(ofFrame("answer", robot, id));
  return response ? ((await response.json()) as Frame) : null;
}

export async function pictureOf(kind: "preview" | "picture", robot: string, id: number) {
  const response = await get(ofFrame(kind, robot, id));
  if (!response) return null;
  // Colours as they are: the depth's pixels are matched with these.
  return createImageBitmap(await response.blob(), { colorSpaceConversion: "none" });
}

export async function depthOf(robot: string, id: number): Promise<Uint16Array | null> {
  const response = await get(ofFrame("depth", robot, id));
  return response ? new Uint16Array(await response.arrayBuffer()) : null;
}

// One for the whole page, as browsers have six connections for all pages of a host.
export class Events {
  private source: EventSource | null = null;
  onChanges: (changes: Changes) => void = () => {};
  onState: (connected: boolean) => void = () => {};
  onEnd: () => void = () => {};

  open(close: string, depth: boolean): void {
    this.source?.close();
    const query = close ? `?close=${encodeURIComponent(close)}${depth ? "&depth=1" : ""}` : "";
    const source = new EventSource(`/api/events${query}`);
    source.onopen = () => this.onState(true);
    source.onmessage = (event) => this.onChanges(JSON.parse(event.data) as Changes);
    source.addEventListener("ended", () => this.onEnd());
    source.onerror = () => {
      this.onState(false);
      if (source.readyState === EventSource.CLOSED) this.reopen(source, close, depth);
    };
    this.source = source;
  }

  // The browser gives up where it is answered with an error: the observer may have started anew.
  private reopen(source: EventSource, close: string, depth: boolean): void {
    setTimeout(async () => {
      if (this.source !== source) return;
      const known = await fetch("/api/session").then((r) => r.status !== 401, () => true);
      if (!known) this.onEnd();
      else this.open(close, depth);
    }, 1000);
  }

  stop(): void {
    this.source?.close();
    this.source = null;
  }
}
