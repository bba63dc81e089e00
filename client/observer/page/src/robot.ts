// One robot, large.
import { pickObject } from "./api";
import { Cloud } from "./cloud";
import { counted, el, toggle } from "./dom";
import { Live } from "./live";
import { labelsOf } from "./masks";
import { drawFrame, type Shown } from "./overlay";
import { paceOf } from "./pace";
import { nearestInstead, Reel } from "./reel";
import { Save } from "./save";
import { Stages } from "./stages";
import { ObjectTable } from "./table";
import { Timeline } from "./timeline";
import { Trial } from "./trial";
import type { RobotLine, Seen, Who } from "./types";

const SWITCHES: [keyof Shown, string][] = [
  ["masks", "m"],
  ["boxes", "b"],
  ["labels", "l"],
  ["grasps", "g"],
  ["rejected", "r"],
  ["seeds", "e"],
  ["saliency", "s"],
];

const WITHOUT_HISTORY =
  "No history is kept here. fovea-observer keeps the last minutes of each robot with --history FOLDER " +
  "and --history-token-file FILE: frames can then be stepped back to, saved, and tried with other options.";

const WITHOUT_DEPTH = "Depth comes with frames from when 3D was switched on; this one is older.";

const WITHOUT_WEBGL = "There is no 3D here: the browser has no WebGL 2, or it is switched off.";

function cloudOrNone(): Cloud | null {
  try {
    return new Cloud();
  } catch {
    return null;
  }
}

const mayTry = (me: Who) => me.history !== null && me.rights.includes("try");

export class RobotView {
  readonly element: HTMLElement;
  onDepth: (wanted: boolean) => void = () => {};
  onBack: () => void = () => {};
  private readonly picture = el("canvas", { id: "picture", role: "img" });
  private readonly facts = el("span", { class: "soft", id: "facts" }, "no frame has come since this page was opened");
  private readonly timer = window.setInterval(() => this.tellFacts(), 1000);
  private readonly reasons = el("ul", { class: "reasons", id: "reasons" });
  private readonly table = new ObjectTable();
  private readonly stages = new Stages();
  private readonly left: HTMLElement;
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly shown: Shown = { masks: true, boxes: true, labels: true, grasps: false, rejected: false, seeds: false, saliency: false };
  private readonly live: Live;
  private readonly reel: Reel;
  private readonly timeline: Timeline;
  private readonly save: Save;
  private readonly trial: Trial;
  private readonly told = el("p", { role: "status", id: "picked" });
  private cloud: Cloud | null = null;
  private chosen = 0;
  private labels = new Uint16Array();

  constructor(
    readonly robot: string,
    me: Who,
  ) {
    this.live = new Live(robot, () => this.cloud !== null);
    this.reel = new Reel(robot, me.history !== null, () => this.cloud !== null);
    this.timeline = new Timeline(this.reel);
    this.save = new Save(robot, this.reel);
    this.trial = new Trial(robot);
    const back = el("button", { type: "button", title: "key Escape" }, "← all robots");
    back.addEventListener("click", () => this.onBack());
    const bar = el("div", { class: "bar", role: "toolbar", "aria-label": "what is shown" }, back, ...this.makeButtons(me));
    this.left = el("div", {}, el("div", { class: "view" }, this.picture));
    const right = el("div", {}, this.reasons, el("h3", {}, "Objects"), this.table.element, this.stages.element);
    const past = el("div", { class: "past" }, this.timeline.element);
    if (me.rights.includes("download")) past.append(this.save.element);
    past.hidden = me.history === null;
    const hint = el("p", { class: "soft", id: "no-history" }, WITHOUT_HISTORY);
    hint.hidden = !past.hidden;
    this.element = el("section", { "aria-label": robot }, el("h2", {}, robot), this.facts, bar, past, hint, this.told, el("div", { class: "close" }, this.left, right));
    if (mayTry(me)) this.element.append(this.trial.element);
    if (me.rights.includes("pick")) this.takePicks();
    this.live.onLine = (line) => this.stages.add(line);
    this.live.onFrame = (seen) => this.reel.add(seen);
    this.reel.onShow = (seen) => this.show(seen);
    this.reel.onHistory = () => this.timeline.draw();
    this.timeline.onSeek = (time) => {
      this.hold();
      void this.reel.seek(time);
    };
    this.timeline.onEnd = (isNewest) => {
      this.hold();
      void this.reel.seekEnd(isNewest);
    };
    this.timeline.onStep = (by) => this.step(by);
    if (!past.hidden && me.rights.includes("download")) {
      this.buttons.set("f", this.save.frame);
      this.buttons.set("w", this.save.seconds);
    }
    this.table.onHover = (label) => this.choose(label);
    this.picture.addEventListener("pointermove", (event) => this.choose(this.labelAt(event)));
    this.picture.addEventListener("pointerleave", () => this.choose(0));
  }

  private makeButtons(me: Who): HTMLButtonElement[] {
    const add = (label: string, key: string, on: boolean, change: (on: boolean) => void) => {
      const button = toggle(label, key, on, change);
      this.buttons.set(key, button);
      return button;
    };
    const switches = SWITCHES.map(([name, key]) =>
      add(name, key, this.shown[name], (on) => {
        this.shown[name] = on;
        this.say(on ? this.whyNothing(name) : "");
        this.draw();
      }),
    );
    const step = (label: string, name: string, key: string, by: number) => {
      const button = el("button", { type: "button", title: `key ${key}`, "aria-label": name }, label);
      button.addEventListener("click", () => this.step(by));
      this.buttons.set(key, button);
      return button;
    };
    return [
      ...switches,
      add("3D", "3", false, (on) => void this.openCloud(on)),
      add("stop", " ", false, (on) => {
        this.say("");
        this.reel.stop(on);
      }),
      step("◀", "the frame before", ",", -1),
      step("▶", "the next frame", ".", 1),
      ...(mayTry(me) ? [add("try", "t", false, (on) => void this.openTrial(on))] : []),
    ];
  }

  // True where the key means something here.
  onKey(key: string, isRepeated: boolean): boolean {
    if (isRepeated && key !== "," && key !== ".") return this.buttons.has(key); // one that is held steps, and does no more
    if (key === "Escape") this.onBack();
    else if (this.buttons.has(key)) this.buttons.get(key)!.click();
    else return false;
    return true;
  }

  update(close: RobotLine | undefined, listed: RobotLine | undefined): void {
    this.live.update(close, listed);
  }

  close(): void {
    this.cloud?.close();
    clearInterval(this.timer);
    this.live.close();
    this.reel.close();
  }

  // A click on an object marks it for the robot, where that has asked for it.
  private takePicks(): void {
    this.picture.classList.add("picks");
    this.picture.addEventListener("click", (event) => void this.pick(this.labelAt(event)));
    this.table.onPick = (label) => void this.pick(label);
  }

  private async pick(label: number): Promise<void> {
    const seen = this.reel.current;
    if (!seen || label === 0) return;
    this.say(`object ${label} is told to ${this.robot}`);
    try {
      const reason = await pickObject(this.robot, seen.line.id, seen.past, label);
      this.say(reason ? `${this.robot} did not get object ${label}: ${reason}` : `${this.robot} got object ${label}`, reason !== "");
    } catch (error) {
      this.say((error as Error).message, true);
    }
  }

  private say(text: string, isBad = false): void {
    this.told.textContent = text;
    this.told.classList.toggle("bad", isBad);
  }

  // With the frame that is shown, as the history has it.
  private async openTrial(on: boolean): Promise<void> {
    if (!on) return this.trial.close();
    this.hold();
    const shown = this.reel.current;
    if (shown?.past) return this.trial.open(shown);
    if (!(await this.reel.toPast())) {
      this.buttons.get("t")!.setAttribute("aria-pressed", "false");
      return this.say(`only frames of the history can be tried, and it holds none of ${this.robot} yet`, true);
    }
    const instead = nearestInstead(shown, Number(this.reel.current?.line.answered_at_ms));
    if (instead) this.say(instead);
  }

  // Of these the page has what the robot asked for, and nothing else.
  private whyNothing(name: keyof Shown): string {
    const options = this.reel.current?.frame.options;
    const isAsked = { seeds: options?.return_seeds, saliency: options?.return_saliency_maps }[name as string] ?? true;
    return isAsked ? "" : `${this.robot} did not ask for ${name} with this frame, so there is none to be shown`;
  }

  // What is shown stays.
  private hold(): void {
    if (!this.reel.stopped) this.buttons.get(" ")!.click();
  }

  private step(by: number): void {
    this.hold();
    void this.reel.step(by);
  }

  private show(seen: Seen): void {
    const { line, frame, past } = seen;
    const detections = frame.detections;
    this.labels = detections ? labelsOf(detections.objects, detections.width, detections.height) : new Uint16Array();
    this.tellFacts();
    this.reasons.replaceChildren(...line.reasons.map((text) => el("li", {}, text)));
    this.table.show(frame);
    this.draw();
    this.showCloud(seen);
    this.timeline.draw();
    const tries = this.buttons.get("t")?.getAttribute("aria-pressed") === "true";
    if (past && tries) void this.trial.open(seen);
    this.picture.dataset.id = String(line.id);
    this.picture.dataset.past = String(past);
    this.picture.dataset.shownAt = String(Date.now());
    this.picture.dataset.answeredAt = String(line.answered_at_ms);
  }

  // Of the frame that is shown, and how often others come by now.
  private tellFacts(): void {
    const seen = this.reel.current;
    if (!seen) return;
    const { frame_id, took_ms, objects } = seen.line;
    const pace = seen.past ? "of the history" : paceOf(this.live.listed ?? seen.line);
    this.facts.textContent = `frame ${frame_id || "without a name"} · ${took_ms.toFixed(0)} ms · ${pace} · ${counted(objects, "object")}`;
  }

  private draw(): void {
    const seen = this.reel.current;
    if (!seen) return;
    drawFrame(this.picture, seen.picture, seen.frame, this.shown, this.chosen);
    this.picture.setAttribute("aria-label", `what ${this.robot} sees, with ${counted(seen.line.objects, "object")}; the table tells them`);
    this.table.choose(this.chosen);
  }

  private choose(label: number): void {
    if (label === this.chosen) return;
    this.chosen = label;
    this.draw();
    this.cloud?.choose(label);
  }

  private labelAt(event: MouseEvent): number {
    const bounds = this.picture.getBoundingClientRect();
    const x = Math.floor(((event.clientX - bounds.left) / bounds.width) * this.picture.width);
    const y = Math.floor(((event.clientY - bounds.top) / bounds.height) * this.picture.height);
    return this.labels[y * this.picture.width + x] ?? 0;
  }

  private async openCloud(on: boolean): Promise<void> {
    this.cloud?.close();
    this.cloud = on ? cloudOrNone() : null;
    if (on && !this.cloud) {
      this.buttons.get("3")!.setAttribute("aria-pressed", "false");
      return this.say(WITHOUT_WEBGL, true);
    }
    if (this.cloud) this.left.append(this.cloud.element);
    this.onDepth(on);
    const shown = this.reel.current;
    if (!on || !shown) return;
    if (shown.past) return this.reel.again();
    this.showCloud(shown);
    // What stands still has its depth in the history alone.
    if (this.reel.stopped && !shown.depth && (await this.reel.toPast())) {
      this.say(nearestInstead(shown, Number(this.reel.current?.line.answered_at_ms)));
    }
  }

  private showCloud({ frame, depth, picture }: Seen): void {
    if (depth && picture) this.cloud?.show(frame, depth, picture);
    else this.cloud?.clear(WITHOUT_DEPTH);
  }
}
