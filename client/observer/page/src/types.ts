// What the observer answers: /api/events, and the messages of fovea.v1 as JSON. 64-bit numbers and
// durations are strings there.
export interface Vector3 {
  x: number;
  y: number;
  z: number;
}
export interface Quaternion extends Vector3 {
  w: number;
}
export interface OrientedBox {
  pose: { position: Vector3; orientation: Quaternion };
  size: Vector3;
}
export interface Bounds {
  x: number;
  y: number;
  width: number;
  height: number;
}
export interface Mask {
  bounds: Bounds;
  runs: number[];
}
export interface Grasp {
  tool_center_point: Vector3;
  approach: Vector3;
  closing: Vector3;
  opening_m: number;
  kind: string;
  gripper: string;
  gripper_index: number;
  probability: number;
}
export interface FoundObject {
  label: number;
  confidence: number;
  bounding_box: Bounds;
  oriented_box: OrientedBox;
  mask?: Mask;
  grasps: Grasp[];
  no_grasps: { gripper: string; reason: string }[];
  shape?: { kind: string };
  height_above_support_m?: number;
  colors: { name: string; share: number }[];
}
export interface Detections {
  width: number;
  height: number;
  objects: FoundObject[];
  gravity?: { direction: Vector3; source: string };
  support_surface?: { plane: { normal: Vector3; offset: number } };
  diagnostics?: { messages: string[] };
  rejected: { bounding_box: Bounds; probability: number; reason: string }[];
  seeds: { x: number; y: number }[];
  saliency_maps: { name: string; width: number; height: number; data: string }[];
  grippers: { jaw?: { finger_length_m: number } }[];
}
export interface Intrinsics {
  fx: number;
  fy: number;
  cx: number;
  cy: number;
  distortion?: { model: string; coefficients: number[] };
}
export interface Frame {
  robot: string;
  frame_id: string;
  detections?: Detections;
  error?: { code: number; message: string };
  intrinsics?: Intrinsics;
  options?: { profile: string; parameters: Record<string, number>; return_seeds: boolean; return_saliency_maps: boolean };
  depth?: { width: number; height: number; unit_m: number; intrinsics: Intrinsics };
}
export interface RobotLine {
  robot: string;
  id: number;
  frame_id: string;
  answered_at_ms: string | number;
  came_at_us: number; // to the observer
  took_ms: number;
  rate_hz: number;
  objects: number;
  problem: boolean;
  has_picture: boolean;
  stages: Record<string, number>;
  reasons: string[];
}
export interface ServerLine {
  address: string;
  state: "connecting" | "watching" | "away" | "refused";
  problem: string;
  version: string;
}
export interface Changes {
  now_us: number; // the observer's clock
  servers: ServerLine[];
  robots: RobotLine[];
  close?: RobotLine;
}
export interface Who {
  name: string;
  rights: string[];
  robots: string[];
  csrf: string;
  history: { minutes: number; problem: string; shortage: string } | null; // null: there is none
}
export interface Option {
  name: string;
  unit: string;
  minimum: number;
  maximum: number;
  integral: boolean;
  defaults: Record<string, number>;
  description: string;
  fixed: boolean;
}
// Of one robot, oldest first. An id is when the frame came to the observer, in microseconds.
export interface HistoryList {
  minutes: number;
  problem: string;
  shortage: string; // why it holds less than these minutes
  ids: number[];
  objects: number[];
  problems: number[];
}
// A frame as it is shown, and where it can be asked for.
export interface Seen {
  line: RobotLine;
  frame: Frame;
  picture: ImageBitmap | null;
  depth: Uint16Array | null;
  past: boolean; // of the history
}
