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

export class ObjectTable {
  readonly element: HTMLElement;
  onHover: (label: number) => void = () => {};
  onPick: (label: number) => void = () => {};
  private readonly body = el("tbody");

  constructor() {
    const heads = ["object", "what", "sure", "x y z, m", "size, cm", "grasp"];
    const head = el("thead", {}, el("tr", {}, ...heads.map((text) => el("th", { scope: "col" }, text))));
    this.element = el("div", { class: "scroll" }, el("table", { id: "objects" }, head, this.body));
  }

  show(frame: Frame): void {
    this.body.replaceChildren(...(frame.detections?.objects ?? []).map((object) => this.row(object)));
  }

  choose(label: number): void {
    for (const row of this.body.rows) row.classList.toggle("chosen", row.dataset.label === String(label));
  }

  private row(object: FoundObject): HTMLTableRowElement {
    const { position } = object.oriented_box.pose;
    const { size } = object.oriented_box;
    const swatch = el("span", { class: "swatch" });
    swatch.style.background = cssOf(object.label);
    const cells = [
      describe(object),
      `${Math.round(100 * object.confidence)}\u00a0%`,
      [position.x, position.y, position.z].map((value) => value.toFixed(3)).join(" "),
      [size.x, size.y, size.z].map(cm).join(" × "),
      graspText(object),
    ];
    const row = el("tr", { tabindex: "0", "data-label": String(object.label) });
    row.append(el("td", {}, swatch, String(object.label)), ...cells.map((text) => el("td", {}, text)));
    for (const event of ["pointerenter", "focus"]) row.addEventListener(event, () => this.onHover(object.label));
    for (const event of ["pointerleave", "blur"]) row.addEventListener(event, () => this.onHover(0));
    row.addEventListener("keydown", (event) => {
      if (event.key === "Enter") this.onPick(object.label);
    });
    return row;
  }
}
