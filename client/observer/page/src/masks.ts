import { colorOf } from "./palette";
import type { FoundObject, Mask } from "./types";

// Calls `run` with each run of object pixels: row, first column and how many, in the image.
export function forEachRun(mask: Mask, run: (y: number, x: number, length: number) => void): void {
  const { x, y, width } = mask.bounds;
  let at = 0;
  mask.runs.forEach((length, index) => {
    let left = index % 2 === 1 ? length : 0; // background first
    let from = at;
    while (left > 0) {
      const column = from % width;
      const here = Math.min(left, width - column);
      run(y + Math.floor(from / width), x + column, here);
      from += here;
      left -= here;
    }
    at += length;
  });
}

// The label of each pixel, 0 = none.
export function labelsOf(objects: FoundObject[], width: number, height: number): Uint16Array {
  const labels = new Uint16Array(width * height);
  for (const object of objects) {
    if (!object.mask) continue;
    forEachRun(object.mask, (y, x, n) => labels.fill(object.label, y * width + x, y * width + x + n));
  }
  return labels;
}

// Pixels of masks in their colours, to be drawn over the picture.
export function maskImage(objects: FoundObject[], width: number, height: number, alpha: number) {
  const image = new ImageData(width, height);
  for (const object of objects) {
    if (!object.mask) continue;
    const [r, g, b] = colorOf(object.label);
    forEachRun(object.mask, (y, x, n) => {
      for (let i = 4 * (y * width + x), end = i + 4 * n; i < end; i += 4) {
        image.data[i] = r;
        image.data[i + 1] = g;
        image.data[i + 2] = b;
        image.data[i + 3] = alpha;
      }
    });
  }
  return image;
}
