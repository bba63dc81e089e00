// One robot, large.
import { answerOf, depthOf, pictureOf } from "./api";
import { Cloud } from "./cloud";
import { el, toggle } from "./dom";
import { labelsOf } from "./masks";
import { drawFrame, type Shown } from "./overlay";
import { Stages } from "./stages";
import { ObjectTable } from "./table";
import type { Frame, RobotLine } from "./types";

interface Seen {
  line: RobotLine;
  frame: Frame;
  picture: ImageBitmap | null;
  depth: Uint16Array | null;
}

const MAX_KEPT = 30;
const SWITCHES: [keyof Shown, string][] = [
  ["masks", "m"],
  ["boxes", "b"],
  ["labels", "l"],
  ["grasps", "g"],
  ["rejected", "r"],
  ["seeds", "e"],
  ["saliency", "s"],
];

export class RobotView {
  readonly element: HTMLElement;
  onDepth: (wanted: boolean) => void = () => {};
  onBack: () => void = () => {};
  private readonly picture = el("canvas", { id: "picture", role: "img" });
  private readonly facts = el("span", { class: "soft", id: "facts" });
  private readonly reasons = el("ul", { class: "reasons", id: "reasons" });
  private readonly table = new ObjectTable();
  private readonly stages = new Stages();
  private readonly left: HTMLElement;
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly shown: Shown = { masks: true, boxes: true, labels: true, grasps: false, rejected: false, seeds: false, saliency: false };
  private readonly kept: Seen[] = [];
  private cloud: Cloud | null = null;
  private at = -1;
  private stopped = false;
  private busy = false;
  private newest: RobotLine | null = null;
  private chosen = 0;
  private labels = new Uint8Array();

  constructor(readonly robot: string) {
    const back = el("button", { type: "button", title: "key Escape" }, "← all robots");
    back.addEventListener("click", () => this.onBack());
    const bar = el("div", { class: "bar", role: "toolbar", "aria-label": "what is shown" }, back, ...this.makeButtons());
    this.left = el("div", {}, el("div", { class: "view" }, this.picture));
    const right = el("div", {}, this.reasons, el("h3", {}, "Objects"), this.table.element, this.stages.element);
    this.element = el("section", { "aria-label": robot }, el("h2", {}, robot), this.facts, bar, el("div", { class: "close" }, this.left, right));
    this.table.onHover = (label) => this.choose(label);
    this.picture.addEventListener("pointermove", (event) => this.choose(this.labelAt(event)));
    this.picture.addEventListener("pointerleave", () => this.choose(0));
  }

  private makeButtons(): HTMLButtonElement[] {
    const add = (label: string, key: string, on: boolean, change: (on: boolean) => void) => {
      const button = toggle(label, key, on, change);
      this.buttons.set(key, button);
      return button;
    };
    const switches = SWITCHES.map(([name, key]) =>
      add(name, key, this.shown[name], (on) => {
        this.shown[name] = on;
        this.draw();
      }),
    );
    const step = (label: string, key: string, by: number) => {
      const button = el("button", { type: "button", title: `key ${key}` }, label);
      button.addEventListener("click", () => this.step(by));
      this.buttons.set(key, button);
      return button;
    };
    return [
      ...switches,
      add("3D", "3", false, (on) => this.showCloud(on)),
      add("stop", " ", false, (on) => this.stop(on)),
      step("◀", ",", -1),
      step("▶", ".", 1),
    ];
  }

  // True where the key means something here.
  onKey(key: string): boolean {
    if (key === "Escape") this.onBack();
    else if (this.buttons.has(key)) this.buttons.get(key)!.click();
    else return false;
    return true;
  }

  update(line: RobotLine): void {
    if (this.newest && line.id <= this.newest.id) return;
    this.newest = line;
    this.stages.add(line);
    void this.fetch();
  }

  private async fetch(): Promise<void> {
    const line = this.newest;
    if (this.busy || !line || this.kept[this.kept.length - 1]?.line.id === line.id) return;
    this.busy = true;
    try {
      const seen = await this.load(line);
      if (seen) this.keep(seen);
    } catch {
      // the page says elsewhere that the observer is away
    } finally {
      this.busy = false;
    }
    if (this.newest !== line) void this.fetch();
  }

  private async load(line: RobotLine): Promise<Seen | null> {
    const [frame, picture, depth] = await Promise.all([
      answerOf(this.robot, line.id),
      line.has_picture ? pictureOf("picture", this.robot, line.id) : null,
      this.cloud ? depthOf(this.robot, line.id) : null,
    ]);
    return frame ? { line, frame, picture, depth } : null;
  }

  private keep(seen: Seen): void {
    this.kept.push(seen);
    if (this.kept.length > MAX_KEPT && !this.stopped) this.kept.shift()?.picture?.close();
    if (this.kept.length > 2 * MAX_KEPT) {
      this.kept.shift()?.picture?.close();
      this.at = Math.max(0, this.at - 1);
    }
    if (!this.stopped) this.show(this.kept.length - 1);
  }

  private stop(on: boolean): void {
    this.stopped = on;
    if (!on && this.kept.length > 0) this.show(this.kept.length - 1);
  }

  private step(by: number): void {
    if (!this.stopped) this.buttons.get(" ")!.click();
    this.show(Math.min(this.kept.length - 1, Math.max(0, this.at + by)));
  }

  private get seen(): Seen | undefined {
    return this.kept[this.at];
  }

  private show(at: number): void {
    this.at = at;
    const seen = this.seen;
    if (!seen) return;
    const { line, frame, depth, picture } = seen;
    const detections = frame.detections;
    this.labels = detections ? labelsOf(detections.objects, detections.width, detections.height) : new Uint8Array();
    this.facts.textContent = `frame ${line.frame_id || "without a name"} · ${line.took_ms.toFixed(0)} ms · ${line.rate_hz.toFixed(1)} a second · ${line.objects} objects`;
    this.reasons.replaceChildren(...line.reasons.map((text) => el("li", {}, text)));
    this.table.show(frame);
    this.draw();
    if (this.cloud && depth && picture) this.cloud.show(frame, depth, picture);
    this.picture.dataset.id = String(line.id);
    this.picture.dataset.shownAt = String(Date.now());
    this.picture.dataset.answeredAt = String(line.answered_at_ms);
  }

  private draw(): void {
    if (!this.seen) return;
    drawFrame(this.picture, this.seen.picture, this.seen.frame, this.shown, this.chosen);
    const count = this.seen.line.objects;
    this.picture.setAttribute("aria-label", `what ${this.robot} sees, with ${count} objects; the table tells them`);
    this.table.choose(this.chosen);
  }

  private choose(label: number): void {
    if (label === this.chosen) return;
    this.chosen = label;
    this.draw();
    this.cloud?.choose(label);
  }

  private labelAt(event: PointerEvent): number {
    const bounds = this.picture.getBoundingClientRect();
    const x = Math.floor(((event.clientX - bounds.left) / bounds.width) * this.picture.width);
    const y = Math.floor(((event.clientY - bounds.top) / bounds.height) * this.picture.height);
    return this.labels[y * this.picture.width + x] ?? 0;
  }

  private showCloud(on: boolean): void {
    this.cloud?.element.remove();
    this.cloud = on ? new Cloud() : null;
    if (this.cloud) this.left.append(this.cloud.element);
    this.onDepth(on);
  }
}
