// The times of the stages over the last minutes, as stacked bars: the mean of each two seconds.
import { el } from "./dom";
import { cssOf, NUM_COLORS } from "./palette";
import type { RobotLine } from "./types";

const MAX_BARS = 90;
const BAR_MS = 2000;
// Part of the others, so not stacked with them.
const APART = new Set(["processor_wait"]);

// There are more stages than colours.
const tintOf = (stage: number) => cssOf(stage + 1, stage < NUM_COLORS ? 1 : 0.5);

interface Bar {
  slot: number; // since 1970, in units of BAR_MS
  frames: number;
  took_ms: number; // of the slowest frame
  stages: Record<string, number>; // means, in ms
}

function addTo(bar: Bar, line: RobotLine): void {
  bar.frames += 1;
  bar.took_ms = Math.max(bar.took_ms, line.took_ms);
  for (const name of new Set([...Object.keys(bar.stages), ...Object.keys(line.stages)])) {
    const mean = bar.stages[name] ?? 0;
    bar.stages[name] = mean + ((line.stages[name] ?? 0) - mean) / bar.frames;
  }
}

export class Stages {
  readonly element: HTMLElement;
  private readonly canvas = el("canvas", { id: "stages", role: "img" });
  private readonly legend = el("div", { class: "legend" });
  private bars: Bar[] = [];

  constructor() {
    this.element = el("section", {}, el("h3", {}, "Time of each stage"), this.canvas, this.legend);
  }

  add(line: RobotLine): void {
    const slot = Math.floor(Number(line.answered_at_ms) / BAR_MS);
    if (this.bars[this.bars.length - 1]?.slot !== slot) this.bars.push({ slot, frames: 0, took_ms: 0, stages: {} });
    addTo(this.bars[this.bars.length - 1], line);
    this.bars = this.bars.filter((bar) => bar.slot > slot - MAX_BARS && bar.slot <= slot);
    this.draw(line);
  }

  private draw(last: RobotLine): void {
    const names = [...new Set(this.bars.flatMap((bar) => Object.keys(bar.stages)))].filter((n) => !APART.has(n));
    const { clientWidth, clientHeight } = this.canvas;
    this.canvas.width = clientWidth;
    this.canvas.height = clientHeight;
    const context = this.canvas.getContext("2d")!;
    const highest = Math.max(1, ...this.bars.map((bar) => bar.took_ms));
    const width = clientWidth / MAX_BARS;
    const newest = this.bars[this.bars.length - 1].slot;
    this.bars.forEach((bar) => {
      const left = clientWidth - (newest - bar.slot + 1) * width;
      let y = clientHeight;
      names.forEach((name, k) => {
        const height = ((bar.stages[name] ?? 0) / highest) * clientHeight;
        context.fillStyle = tintOf(k);
        context.fillRect(left, y - height, Math.max(1, width - 1), height);
        y -= height;
      });
    });
    const minutes = (MAX_BARS * BAR_MS) / 60_000;
    this.canvas.setAttribute("aria-label", `the last frame took ${last.took_ms.toFixed(0)} ms, the longest of ${minutes} minutes ${highest.toFixed(0)} ms`);
    this.legend.replaceChildren(
      el("span", { class: "soft" }, `${minutes} minutes, top = ${highest.toFixed(0)} ms`),
      ...names.map((name, k) => {
        const swatch = el("span", { class: "swatch" });
        swatch.style.background = tintOf(k);
        return el("span", {}, swatch, `${name} ${(last.stages[name] ?? 0).toFixed(1)} ms`);
      }),
    );
  }
}
