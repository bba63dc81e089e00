// The times of the stages over the last frames, as stacked bars.
import { el } from "./dom";
import { cssOf, NUM_COLORS } from "./palette";
import type { RobotLine } from "./types";

const MAX_BARS = 120;
// Part of the others, so not stacked with them.
const APART = new Set(["processor_wait"]);

// There are more stages than colours.
const tintOf = (stage: number) => cssOf(stage + 1, stage < NUM_COLORS ? 1 : 0.5);

export class Stages {
  readonly element: HTMLElement;
  private readonly canvas = el("canvas", { id: "stages", role: "img" });
  private readonly legend = el("div", { class: "legend" });
  private readonly bars: RobotLine[] = [];

  constructor() {
    this.element = el("section", {}, el("h3", {}, "Time of each stage"), this.canvas, this.legend);
  }

  add(line: RobotLine): void {
    this.bars.push(line);
    if (this.bars.length > MAX_BARS) this.bars.shift();
    this.draw();
  }

  private draw(): void {
    const names = [...new Set(this.bars.flatMap((bar) => Object.keys(bar.stages)))].filter((n) => !APART.has(n));
    const { clientWidth, clientHeight } = this.canvas;
    this.canvas.width = clientWidth;
    this.canvas.height = clientHeight;
    const context = this.canvas.getContext("2d")!;
    const highest = Math.max(1, ...this.bars.map((bar) => bar.took_ms));
    const width = clientWidth / MAX_BARS;
    this.bars.forEach((bar, i) => {
      let y = clientHeight;
      names.forEach((name, k) => {
        const height = ((bar.stages[name] ?? 0) / highest) * clientHeight;
        context.fillStyle = tintOf(k);
        context.fillRect(i * width, y - height, Math.max(1, width - 1), height);
        y -= height;
      });
    });
    const last = this.bars[this.bars.length - 1];
    this.canvas.setAttribute("aria-label", `the last frame took ${last.took_ms.toFixed(0)} ms, the longest shown ${highest.toFixed(0)} ms`);
    this.legend.replaceChildren(
      el("span", { class: "soft" }, `top = ${highest.toFixed(0)} ms`),
      ...names.map((name, k) => {
        const swatch = el("span", { class: "swatch" });
        swatch.style.background = tintOf(k);
        return el("span", {}, swatch, `${name} ${(last.stages[name] ?? 0).toFixed(1)}`);
      }),
    );
  }
}
