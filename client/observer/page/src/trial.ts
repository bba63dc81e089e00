// Other options on a frame of the history, beside the answer that the robot got. The robot notices
// nothing.
import { optionsOf, tryOptions } from "./api";
import { describe, match, type Pair } from "./compare";
import { counted, el } from "./dom";
import { drawFrame, type Shown } from "./overlay";
import { cssOf } from "./palette";
import type { Detections, Option, Seen } from "./types";

const SHOWN: Shown = { masks: true, boxes: true, labels: true, grasps: false, rejected: false, seeds: false, saliency: false };
const DEFAULT = "default";

export class Trial {
  readonly element: HTMLElement;
  private readonly head = el("h3", {}, "Try other options");
  private readonly before = el("canvas", { id: "before", role: "img", "aria-label": "what was answered" });
  private readonly after = el("canvas", { id: "after", role: "img", "aria-label": "what would be answered" });
  private readonly changes = el("tbody");
  private readonly told = el("p", { role: "status", id: "tried" });
  private readonly command = el("code", { id: "command" });
  private readonly list = el("tbody");
  private readonly find = el("input", { type: "search", id: "find", placeholder: "name or meaning", "aria-label": "find an option" });
  private readonly run = el("button", { type: "button", id: "run" }, "try");
  private seen: Seen | null = null;
  private picture: OffscreenCanvas | null = null; // its own, as that of a frame goes with it
  private profile = DEFAULT;
  private options: Option[] = [];
  private readonly values = new Map<string, number>(); // that are not the robot's
  private busy = false;

  constructor(private readonly robot: string) {
    const copy = el("button", { type: "button" }, "copy");
    copy.addEventListener("click", () => void navigator.clipboard?.writeText(this.command.textContent ?? ""));
    const reset = el("button", { type: "button" }, "as the robot has them");
    reset.addEventListener("click", () => {
      this.values.clear();
      this.fill();
    });
    this.run.addEventListener("click", () => void this.try());
    this.find.addEventListener("input", () => this.fill());
    const heads = (...texts: string[]) => el("thead", {}, el("tr", {}, ...texts.map((text) => el("th", { scope: "col" }, text))));
    this.element = el(
      "section",
      { class: "trial", "aria-label": "try other options" },
      this.head,
      el("div", { class: "bar" }, this.run, reset, this.find),
      el("div", { class: "scroll options" }, el("table", { id: "options" }, heads("option", "value", "range", "meaning"), this.list)),
      this.told,
      el("div", { class: "close" }, el("figure", {}, this.before, el("figcaption", {}, "answered")), el("figure", {}, this.after, el("figcaption", {}, "tried"))),
      el("div", { class: "scroll" }, el("table", { id: "changes" }, heads("object", "tried", "what changed"), this.changes)),
      el("p", {}, this.command, " ", copy),
    );
    this.element.hidden = true;
  }

  get isOpen(): boolean {
    return !this.element.hidden;
  }

  close(): void {
    this.element.hidden = true;
  }

  // Of the history, as only such frames are there as they were sent.
  async open(seen: Seen): Promise<void> {
    this.element.hidden = false;
    if (this.seen?.line.id === seen.line.id && this.options.length > 0) return;
    this.seen = seen;
    this.profile = seen.frame.options?.profile || DEFAULT;
    this.head.textContent = `Try other options on frame ${seen.line.frame_id || "without a name"}`;
    this.told.textContent = "";
    this.changes.replaceChildren();
    this.picture = seen.picture && copyOf(seen.picture);
    drawFrame(this.before, this.picture, seen.frame, SHOWN, 0);
    drawFrame(this.after, this.picture, { ...seen.frame, detections: undefined }, SHOWN, 0);
    try {
      this.options = (await optionsOf(this.robot, seen.line.id)).filter((option) => this.profile in option.defaults);
    } catch (error) {
      this.say((error as Error).message, true);
    }
    this.fill();
  }

  private sent(option: Option): number {
    return this.seen?.frame.options?.parameters[option.name] ?? option.defaults[this.profile];
  }

  private fill(): void {
    const wanted = this.find.value.toLowerCase();
    const shown = this.options.filter(({ name, description }) => `${name} ${description}`.toLowerCase().includes(wanted));
    this.list.replaceChildren(...shown.map((option) => this.row(option)));
    this.tellCommand();
  }

  private tellCommand(): void {
    const sets = [...this.values].map(([name, value]) => ` --set ${name}=${value}`).join("");
    this.command.textContent = `fovea detect --input bundle.zip --output tried${sets}`;
  }

  private row(option: Option): HTMLTableRowElement {
    const value = () => String(this.values.get(option.name) ?? this.sent(option));
    // The server says what it takes; the browser only helps.
    const step = option.integral ? "1" : "any";
    const input = el("input", { type: "number", step, value: value(), "aria-label": option.name, "data-option": option.name });
    input.disabled = option.fixed;
    input.addEventListener("change", () => {
      if (Number(input.value) === this.sent(option) || input.value === "") this.values.delete(option.name);
      else this.values.set(option.name, Number(input.value));
      input.value = value();
      row.classList.toggle("chosen", this.values.has(option.name));
      this.tellCommand();
    });
    input.addEventListener("keydown", (event) => {
      if (event.key === "Enter") input.dispatchEvent(new Event("change")), void this.try();
    });
    const meaning = option.fixed ? `${option.description} Fixed by the server's operator.` : option.description;
    const range = `${option.minimum} … ${option.maximum} ${option.unit}`;
    const row = el("tr", {}, el("td", {}, option.name), el("td", {}, input), el("td", {}, range), el("td", { class: "words" }, meaning));
    row.classList.toggle("chosen", this.values.has(option.name));
    return row;
  }

  private async try(): Promise<void> {
    const seen = this.seen;
    if (!seen || this.busy) return;
    this.busy = this.run.disabled = true;
    this.say("the server looks at it once robots leave it time");
    try {
      this.show(seen, await tryOptions(this.robot, seen.line.id, Object.fromEntries(this.values)));
    } catch (error) {
      this.changes.replaceChildren(); // which were those of other options
      this.say((error as Error).message, true);
    } finally {
      this.busy = this.run.disabled = false;
    }
  }

  private show(seen: Seen, tried: Detections): void {
    if (this.seen !== seen) return;
    drawFrame(this.after, this.picture, { ...seen.frame, detections: tried }, SHOWN, 0);
    const before = seen.frame.detections;
    const pairs = before ? match(before, tried) : tried.objects.map((after) => ({ before: null, after, iou: 0 }));
    const changed = pairs.filter((pair) => describe(pair) !== "the same").length;
    this.say(`${counted(before?.objects.length ?? 0, "object")} then, ${tried.objects.length} tried; ${changed === 0 ? "nothing changed" : `${changed} changed`}`);
    this.changes.replaceChildren(...pairs.map((pair) => changeRow(pair)));
  }

  private say(text: string, isBad = false): void {
    this.told.textContent = text;
    this.told.classList.toggle("bad", isBad);
  }
}

function copyOf(picture: ImageBitmap): OffscreenCanvas {
  const copy = new OffscreenCanvas(picture.width, picture.height);
  copy.getContext("2d")!.drawImage(picture, 0, 0);
  return copy;
}

function labelCell(label: number | undefined): HTMLTableCellElement {
  if (label === undefined) return el("td", {}, "–");
  const swatch = el("span", { class: "swatch" });
  swatch.style.background = cssOf(label);
  return el("td", {}, swatch, String(label));
}

function changeRow(pair: Pair): HTMLTableRowElement {
  return el("tr", {}, labelCell(pair.before?.label), labelCell(pair.after?.label), el("td", { class: "words" }, describe(pair)));
}
