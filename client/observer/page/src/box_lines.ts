// Boxes of objects as lines, in the camera frame.
import * as THREE from "three";
import type { OrientedBox, Vector3 } from "./types";

export const vector = ({ x, y, z }: Vector3) => new THREE.Vector3(x, y, z);

// The twelve edges.
export function boxLines(box: OrientedBox): THREE.Vector3[] {
  const { position, orientation } = box.pose;
  const turn = new THREE.Quaternion(orientation.x, orientation.y, orientation.z, orientation.w);
  const corner = (i: number) =>
    new THREE.Vector3(
      ((i & 1 ? 1 : -1) * box.size.x) / 2,
      ((i & 2 ? 1 : -1) * box.size.y) / 2,
      ((i & 4 ? 1 : -1) * box.size.z) / 2,
    )
      .applyQuaternion(turn)
      .add(vector(position));
  const lines: THREE.Vector3[] = [];
  for (let i = 0; i < 8; ++i) {
    for (const bit of [1, 2, 4]) {
      if ((i & bit) === 0) lines.push(corner(i), corner(i | bit));
    }
  }
  return lines;
}
