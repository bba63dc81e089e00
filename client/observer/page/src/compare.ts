// Two answers to one frame, object by object.
import { labelsOf } from "./masks";
import type { Detections, FoundObject } from "./types";

export interface Pair {
  before: FoundObject | null; // null: it is new
  after: FoundObject | null; // null: it is gone
  iou: number; // of the masks
}

const LEAST_IOU = 0.3; // of what is taken for the same thing
const LABELS = 65536; // that masks can have

// Those that cover each other best are one object; what is left is gone, or new.
export function match(before: Detections, after: Detections): Pair[] {
  const { width, height } = before;
  const ours = labelsOf(before.objects, width, height);
  const theirs = labelsOf(after.objects, width, height);
  const area = [new Map<number, number>(), new Map<number, number>()];
  const both = new Map<number, number>();
  const add = (counts: Map<number, number>, key: number) => counts.set(key, (counts.get(key) ?? 0) + 1);
  for (let i = 0; i < ours.length; ++i) {
    if (ours[i]) add(area[0], ours[i]);
    if (theirs[i]) add(area[1], theirs[i]);
    if (ours[i] && theirs[i]) add(both, ours[i] * LABELS + theirs[i]);
  }
  const candidates = [...both].map(([key, count]) => {
    const [a, b] = [Math.floor(key / LABELS), key % LABELS];
    return { a, b, iou: count / (area[0].get(a)! + area[1].get(b)! - count) };
  });
  candidates.sort((one, other) => other.iou - one.iou);
  const pairs: Pair[] = [];
  const [left, right] = [before, after].map((each) => new Map(each.objects.map((object) => [object.label, object])));
  for (const { a, b, iou } of candidates) {
    if (iou < LEAST_IOU || !left.has(a) || !right.has(b)) continue;
    pairs.push({ before: left.get(a)!, after: right.get(b)!, iou });
    left.delete(a);
    right.delete(b);
  }
  for (const object of left.values()) pairs.push({ before: object, after: null, iou: 0 });
  for (const object of right.values()) pairs.push({ before: null, after: object, iou: 0 });
  return pairs.sort((one, other) => (one.before?.label ?? LABELS) - (other.before?.label ?? LABELS));
}

const percent = (share: number) => `${Math.round(100 * share)}\u00a0%`;
const size = ({ oriented_box }: FoundObject) =>
  [oriented_box.size.x, oriented_box.size.y, oriented_box.size.z].map((meters) => (100 * meters).toFixed(1)).join(" × ");

// What changed of one object, in words.
export function describe({ before, after, iou }: Pair): string {
  if (!before) return "new";
  if (!after) return "gone";
  const changes: string[] = [];
  if (iou < 0.9995) changes.push(`${percent(iou)} of the pixels are the same`);
  if (percent(before.confidence) !== percent(after.confidence)) changes.push(`sure ${percent(before.confidence)} → ${percent(after.confidence)}`);
  if (size(before) !== size(after)) changes.push(`${size(before)} → ${size(after)} cm`);
  const [grasp, other] = [before.grasps[0], after.grasps[0]];
  if (Boolean(grasp) !== Boolean(other)) changes.push(grasp ? "no grasp any more" : "has a grasp");
  else if (grasp && percent(grasp.probability) !== percent(other.probability)) changes.push(`grasp ${percent(grasp.probability)} → ${percent(other.probability)}`);
  return changes.length > 0 ? changes.join("; ") : "the same";
}
