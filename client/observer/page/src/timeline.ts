// What the history holds of one robot: a bar a frame, as high as it has objects, and a line a minute.
import { counted, el } from "./dom";
import { observerNow, spanOf } from "./pace";
import type { Reel } from "./reel";

const MAX_MINUTES = 120; // of which each has its line
const REDUCED = 10; // objects of a full bar, at least

export class Timeline {
  readonly element: HTMLElement;
  onSeek: (time: number) => void = () => {};
  onStep: (by: number) => void = () => {};
  onEnd: (isNewest: boolean) => void = () => {};
  private readonly canvas = el("canvas", { id: "timeline", role: "slider", tabindex: "0", "aria-label": "time" });
  private readonly text = el("span", { class: "soft", id: "moment" });
  private dragging = false;

  constructor(private readonly reel: Reel) {
    this.element = el("div", { class: "timeline" }, this.canvas, this.text);
    this.canvas.addEventListener("pointerdown", (event) => {
      this.dragging = true;
      this.canvas.setPointerCapture(event.pointerId);
      this.onSeek(this.timeAt(event));
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (this.dragging) this.onSeek(this.timeAt(event));
    });
    for (const end of ["pointerup", "pointercancel"] as const) this.canvas.addEventListener(end, () => (this.dragging = false));
    this.canvas.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
      if (by) this.onStep(by);
      else if (event.key === "Home" || event.key === "End") this.onEnd(event.key === "End");
      else return;
      event.preventDefault();
    });
  }

  private range(): [number, number] {
    const to = observerNow() * 1000;
    const span = Math.max(1, this.reel.history.minutes) * 60e6;
    const first = this.reel.history.ids[0] ?? to;
    // Of a robot that is silent the last minutes, whenever those were.
    return [Math.min(to - span, first), to];
  }

  private timeAt(event: PointerEvent): number {
    const bounds = this.canvas.getBoundingClientRect();
    const [from, to] = this.range();
    return from + ((event.clientX - bounds.left) / bounds.width) * (to - from);
  }

  draw(): void {
    const { ids, objects, problems } = this.reel.history;
    const { clientWidth, clientHeight } = this.canvas;
    this.canvas.width = clientWidth;
    this.canvas.height = clientHeight;
    const context = this.canvas.getContext("2d")!;
    const style = getComputedStyle(this.canvas);
    const [good, bad, line, grid] = ["--accent", "--bad", "--text", "--line"].map((name) => style.getPropertyValue(name));
    const [from, to] = this.range();
    const x = (time: number) => ((time - from) / (to - from)) * clientWidth;
    context.fillStyle = grid;
    for (let minute = to; minute > from && to - from < MAX_MINUTES * 60e6; minute -= 60e6) context.fillRect(x(minute), 0, 1, clientHeight);
    // Not all of them as arguments of one call, which may be too many.
    const most = objects.reduce((a, b) => Math.max(a, b), REDUCED);
    ids.forEach((id, i) => {
      const height = problems[i] ? clientHeight : (0.15 + (0.85 * objects[i]) / most) * clientHeight;
      context.fillStyle = problems[i] ? bad : good;
      context.fillRect(x(id), clientHeight - height, Math.max(1, clientWidth / 1200), height);
    });
    const now = this.reel.current?.line.came_at_us;
    if (now) {
      context.fillStyle = line;
      context.fillRect(x(now) - 1.5, 0, 3, clientHeight);
    }
    this.say(from, to, now ?? to);
  }

  private say(from: number, to: number, now: number): void {
    const ago = `${spanOf(observerNow() - now / 1000)} ago`;
    const clock = new Date(now / 1000).toLocaleTimeString();
    const { ids, problem, shortage } = this.reel.history;
    const short = shortage ? `; it ${shortage}` : "";
    if (!this.reel.isListed) this.text.textContent = "the history is being read";
    else this.text.textContent = problem ? `nothing is recorded: ${problem}` : `${clock}, ${ago} · ${counted(ids.length, "frame")} recorded${short}`;
    this.text.classList.toggle("bad", problem !== "");
    this.canvas.setAttribute("aria-valuemin", String(Math.round(from / 1e6)));
    this.canvas.setAttribute("aria-valuemax", String(Math.round(to / 1e6)));
    this.canvas.setAttribute("aria-valuenow", String(Math.round(now / 1e6)));
    this.canvas.setAttribute("aria-valuetext", ago);
  }
}
