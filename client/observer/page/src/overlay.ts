// The picture with what was found, drawn pixel for pixel of the frame where that is not too wide.
import { project } from "./lens";
import { maskImage } from "./masks";
import { cssOf } from "./palette";
import type { Bounds, Detections, Frame, Grasp, Vector3 } from "./types";

export interface Shown {
  masks: boolean;
  boxes: boolean;
  labels: boolean;
  grasps: boolean;
  rejected: boolean;
  seeds: boolean;
  saliency: boolean;
}

const MASK_ALPHA = 110;

export function drawFrame(
  canvas: HTMLCanvasElement,
  picture: ImageBitmap | OffscreenCanvas | null,
  frame: Frame,
  shown: Shown,
  chosen: number,
  mostWide = Infinity, // pixels of the canvas
): void {
  const detections = frame.detections;
  const width = detections?.width || picture?.width || 4;
  const height = detections?.height || picture?.height || 3;
  const zoom = Math.min(1, mostWide / width);
  const [wide, high] = [Math.round(width * zoom), Math.round(height * zoom)];
  if (canvas.width !== wide) canvas.width = wide;
  if (canvas.height !== high) canvas.height = high;
  const context = canvas.getContext("2d")!;
  context.setTransform(wide / width, 0, 0, high / height, 0, 0);
  context.clearRect(0, 0, width, height);
  if (picture) context.drawImage(picture, 0, 0, width, height);
  if (!detections) return;
  if (shown.saliency) drawSaliency(context, detections);
  if (shown.masks) drawLayer(context, maskImage(detections.objects, width, height, MASK_ALPHA));
  const scale = Math.max(1, width / 640);
  context.font = `600 ${Math.round(14 * scale)}px system-ui, sans-serif`;
  for (const object of detections.objects) {
    const is = object.label === chosen;
    context.strokeStyle = cssOf(object.label);
    context.lineWidth = (is ? 4 : 2) * scale;
    if (shown.boxes || is) strokeBounds(context, object.bounding_box);
    if (shown.labels) drawLabel(context, object.label, object.bounding_box, scale);
  }
  if (shown.rejected) drawRejected(context, detections, scale);
  if (shown.seeds) drawSeeds(context, detections, scale);
  if (shown.grasps) drawGrasps(context, frame, chosen, scale);
}

function drawLayer(context: CanvasRenderingContext2D, image: ImageData): void {
  const layer = new OffscreenCanvas(image.width, image.height);
  layer.getContext("2d")!.putImageData(image, 0, 0);
  context.drawImage(layer, 0, 0);
}

function strokeBounds(context: CanvasRenderingContext2D, box: Bounds): void {
  context.strokeRect(box.x + 0.5, box.y + 0.5, box.width - 1, box.height - 1);
}

function drawLabel(context: CanvasRenderingContext2D, label: number, box: Bounds, scale: number) {
  const text = String(label);
  const width = context.measureText(text).width + 8 * scale;
  const height = 18 * scale;
  context.fillStyle = cssOf(label);
  context.fillRect(box.x, Math.max(0, box.y - height), width, height);
  context.fillStyle = "#000";
  context.fillText(text, box.x + 4 * scale, Math.max(0, box.y - height) + 14 * scale);
}

// To be read on any picture.
function drawOutlined(context: CanvasRenderingContext2D, text: string, x: number, y: number): void {
  context.save();
  context.setLineDash([]);
  context.strokeStyle = "#000";
  context.lineWidth *= 2;
  context.strokeText(text, x, y);
  context.restore();
  context.fillText(text, x, y);
}

function drawRejected(context: CanvasRenderingContext2D, detections: Detections, scale: number) {
  context.save();
  context.setLineDash([5 * scale, 4 * scale]);
  context.lineWidth = 1.5 * scale;
  context.strokeStyle = context.fillStyle = "#ff8a80";
  context.font = `${Math.round(12 * scale)}px system-ui, sans-serif`;
  for (const { bounding_box, probability } of detections.rejected) {
    strokeBounds(context, bounding_box);
    drawOutlined(context, `${Math.round(100 * probability)} %`, bounding_box.x + 2, bounding_box.y + bounding_box.height - 3);
  }
  context.restore();
}

function drawSeeds(context: CanvasRenderingContext2D, detections: Detections, scale: number): void {
  context.fillStyle = "#fff";
  context.strokeStyle = "#000";
  context.lineWidth = scale;
  for (const { x, y } of detections.seeds) {
    context.beginPath();
    context.arc(x, y, 3 * scale, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
}

function drawSaliency(context: CanvasRenderingContext2D, detections: Detections): void {
  for (const map of detections.saliency_maps) {
    const bytes = Uint8Array.from(atob(map.data), (c) => c.charCodeAt(0));
    const image = new ImageData(map.width, map.height);
    bytes.forEach((value, i) => image.data.set([255, 40, 40, value * 0.6], 4 * i));
    drawLayer(context, image);
  }
}

function drawGrasps(context: CanvasRenderingContext2D, frame: Frame, chosen: number, scale: number) {
  const camera = frame.intrinsics;
  if (!camera || !frame.detections) return;
  const at = (point: Vector3) => project(camera, point);
  context.lineWidth = 2.5 * scale;
  for (const object of frame.detections.objects) {
    if (chosen && object.label !== chosen) continue;
    const grasp = object.grasps[0]; // the likeliest
    if (!grasp) continue;
    context.strokeStyle = "#fff";
    for (const [from, to] of handLines(grasp)) {
      if (from.z < 0.01 || to.z < 0.01) continue;
      context.beginPath();
      context.moveTo(...at(from));
      context.lineTo(...at(to));
      context.stroke();
    }
  }
}

// A hand as lines, in the camera frame: both fingers, what joins them, and the way it moves in.
export function handLines(grasp: Grasp, fingerLength = 0.04): [Vector3, Vector3][] {
  const { tool_center_point: tip, approach, closing } = grasp;
  const point = (along: number, back: number): Vector3 => ({
    x: tip.x + along * closing.x - back * approach.x,
    y: tip.y + along * closing.y - back * approach.y,
    z: tip.z + along * closing.z - back * approach.z,
  });
  const half = grasp.opening_m > 0 ? grasp.opening_m / 2 + 0.01 : 0.015;
  return [
    [point(-half, 0), point(-half, fingerLength)],
    [point(half, 0), point(half, fingerLength)],
    [point(-half, fingerLength), point(half, fingerLength)],
    [point(0, fingerLength), point(0, 2.5 * fingerLength)],
  ];
}
