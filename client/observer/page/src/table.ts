// The objects in words and numbers. What is hovered or focused here is so in the picture, and the
// other way round.
import { el } from "./dom";
import { cssOf } from "./palette";
import type { Frame, FoundObject } from "./types";

const word = (name: string, prefix: string) => name.replace(prefix, "").toLowerCase().replaceAll("_", " ");
const cm = (meters: number) => (100 * meters).toFixed(1);

function describe(object: FoundObject): string {
  const color = object.colors[0] ? word(object.colors[0].name, "COLOR_NAME_") : "";
  const shape = object.shape ? word(object.shape.kind, "SHAPE_KIND_") : "";
  return [color, shape].filter((text) => text && text !== "unspecified").join(" ");
}

function graspText(object: FoundObject): string {
  const grasp = object.grasps[0];
  if (grasp) return `${word(grasp.kind, "GRASP_KIND_")} ${Math.round(100 * grasp.probability)}\u00a0%`;
  return object.no_grasps[0] ? `none: ${word(object.no_grasps[0].reason, "NO_GRASP_REASON_")}` : "none";
}

function cellsOf(object: FoundObject): HTMLTableCellElement[] {
  const { position } = object.oriented_box.pose;
  const { size } = object.oriented_box;
  const swatch = el("span", { class: "swatch" });
  swatch.style.background = cssOf(object.label);
  const texts = [
    describe(object),
    `${Math.round(100 * object.confidence)}\u00a0%`,
    [position.x, position.y, position.z].map((value) => value.toFixed(3)).join(" "),
    [size.x, size.y, size.z].map(cm).join(" × "),
    graspText(object),
  ];
  return [el("td", {}, swatch, String(object.label)), ...texts.map((text) => el("td", {}, text))];
}

export class ObjectTable {
  readonly element: HTMLElement;
  onHover: (label: number) => void = () => {};
  onPick: (label: number) => void = () => {};
  private readonly body = el("tbody");
  private readonly rows = new Map<number, HTMLTableRowElement>(); // by label

  constructor() {
    const heads = ["object", "what", "sure", "x y z, m", "size, cm", "grasp"];
    const head = el("thead", {}, el("tr", {}, ...heads.map((text) => el("th", { scope: "col" }, text))));
    this.element = el("div", { class: "scroll" }, el("table", { id: "objects" }, head, this.body));
  }

  // A row stays while there is an object of its label: the focus would go with it.
  show(frame: Frame): void {
    const objects = frame.detections?.objects ?? [];
    const labels = new Set(objects.map((object) => object.label));
    for (const [label, row] of this.rows) {
      if (labels.has(label)) continue;
      row.remove();
      this.rows.delete(label);
    }
    objects.forEach((object, i) => {
      const row = this.rowOf(object.label);
      row.replaceChildren(...cellsOf(object));
      if (this.body.rows[i] !== row) this.body.insertBefore(row, this.body.rows[i] ?? null);
    });
  }

  choose(label: number): void {
    for (const row of this.body.rows) row.classList.toggle("chosen", row.dataset.label === String(label));
  }

  private rowOf(label: number): HTMLTableRowElement {
    const known = this.rows.get(label);
    if (known) return known;
    const row = el("tr", { tabindex: "0", "data-label": String(label) });
    for (const event of ["pointerenter", "focus"]) row.addEventListener(event, () => this.onHover(label));
    for (const event of ["pointerleave", "blur"]) row.addEventListener(event, () => this.onHover(0));
    row.addEventListener("keydown", (event) => {
      if (event.key === "Enter") this.onPick(label);
    });
    this.rows.set(label, row);
    return row;
  }
}
