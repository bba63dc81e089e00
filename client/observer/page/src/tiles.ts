// All robots, those with problems first.
import { answerOf, pictureOf, RETRY_MS } from "./api";
import { counted, el } from "./dom";
import { drawFrame, type Shown } from "./overlay";
import { isQuiet, paceOf } from "./pace";
import type { RobotLine } from "./types";

const ON_TILES: Shown = { masks: true, boxes: true, labels: false, grasps: false, rejected: false, seeds: false, saliency: false };
const MOST_WIDE = 480; // pixels; whole frames of many robots would take gigabytes
const NEAR: IntersectionObserverInit = { rootMargin: "50%" }; // drawn before it is seen
const PAUSE_MS = 50; // from one picture to the next

class Tile {
  readonly item: HTMLLIElement;
  private readonly canvas = el("canvas", { "aria-hidden": "true" });
  private readonly facts = el("div", { class: "soft" });
  private readonly reason = el("div", { class: "reason bad" });
  private readonly button: HTMLButtonElement;
  private fetched = 0;
  private busy = false;
  private visible = false;

  constructor(
    public line: RobotLine,
    open: (robot: string) => void,
  ) {
    this.button = el("button", { type: "button", class: "tile" }, this.canvas, el("div", {}, el("strong", {}, line.robot), this.facts), this.reason);
    this.button.addEventListener("click", () => open(line.robot));
    this.item = el("li", { "data-robot": line.robot }, this.button);
    new IntersectionObserver((entries) => {
      this.visible = entries[entries.length - 1].isIntersecting;
      if (!this.visible) this.free();
      void this.draw();
    }, NEAR).observe(this.item);
  }

  update(line: RobotLine): void {
    this.line = line;
    this.describe();
    void this.draw();
  }

  // Of what is scrolled away, not of a list that a robot in large covers. What cannot be drawn again
  // stays.
  private free(): void {
    if (!this.item.isConnected || this.canvas.classList.contains("before")) return;
    this.canvas.width = this.canvas.height = 0;
    this.fetched = 0;
  }

  describe(): void {
    const { objects, took_ms, problem, reasons } = this.line;
    this.facts.textContent = `${counted(objects, "object")} · ${took_ms.toFixed(0)} ms · ${paceOf(this.line)}`;
    this.reason.textContent = problem ? (reasons[0] ?? "") : "";
    this.button.classList.toggle("problem", problem);
  }

  // The newest picture only, and one at a time: a slow connection shows fewer.
  private async draw(): Promise<void> {
    const { robot, id } = this.line;
    if (this.busy || !this.visible || this.fetched === id) return;
    this.busy = true;
    let pause = PAUSE_MS;
    try {
      const [frame, picture] = await Promise.all([answerOf(robot, id), this.line.has_picture ? pictureOf("preview", robot, id) : null]);
      if (!this.visible) return; // it is drawn when it is seen again
      if (frame) {
        // Of a frame that was refused there is nothing to see: what was seen before stays, dimmed.
        const isSeen = picture !== null || frame.detections !== undefined;
        this.canvas.classList.toggle("before", !isSeen);
        if (isSeen) drawFrame(this.canvas, picture, frame, ON_TILES, 0, MOST_WIDE);
        this.canvas.dataset.id = String(id);
      }
      this.fetched = id;
    } catch {
      pause = RETRY_MS; // the page says elsewhere that the observer is away
    } finally {
      this.busy = false;
    }
    if (this.fetched !== this.line.id) setTimeout(() => void this.draw(), pause);
  }
}

export class Tiles {
  readonly element: HTMLElement;
  private readonly list = el("ul", { class: "tiles" });
  private readonly hint = el("p", { class: "soft" }, "No robot has sent a frame since this page was opened.");
  private readonly tiles = new Map<string, Tile>();
  private readonly timer: number;

  constructor(private readonly open: (robot: string) => void) {
    this.element = el("section", { "aria-label": "robots" }, this.hint, this.list);
    this.timer = window.setInterval(() => this.tiles.forEach((tile) => tile.describe()), 1000);
  }

  update(lines: RobotLine[]): void {
    for (const line of lines) {
      let tile = this.tiles.get(line.robot);
      if (!tile) {
        tile = new Tile(line, this.open);
        this.tiles.set(line.robot, tile);
      }
      tile.update(line);
    }
    this.hint.hidden = this.tiles.size > 0;
    this.sort();
  }

  close(): void {
    clearInterval(this.timer);
  }

  focus(robot: string): void {
    this.tiles.get(robot)?.item.querySelector("button")?.focus();
  }

  private sort(): void {
    const order = (tile: Tile) => (tile.line.problem ? 0 : isQuiet(tile.line) ? 1 : 2);
    const sorted = [...this.tiles.values()].sort((a, b) => order(a) - order(b) || a.line.robot.localeCompare(b.line.robot));
    // Moved only where they must be, as moving takes the focus away.
    sorted.forEach((tile, i) => {
      if (this.list.children[i] !== tile.item) this.list.insertBefore(tile.item, this.list.children[i] ?? null);
    });
  }
}
