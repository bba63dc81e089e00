// How a lens bends rays away from the pinhole model: the same numbers here and in the shader.
import type { Intrinsics, Vector3 } from "./types";

const FISHEYE = "DISTORTION_MODEL_KANNALA_BRANDT";

// 0 = none, 1 = Brown–Conrady, 2 = Kannala–Brandt.
export function modelOf(camera: Intrinsics): number {
  if (!camera.distortion || camera.distortion.coefficients.every((each) => each === 0)) return 0;
  return camera.distortion.model === FISHEYE ? 2 : 1;
}

// Eight numbers, in OpenCV's order.
export function coefficientsOf(camera: Intrinsics): number[] {
  const given = camera.distortion?.coefficients ?? [];
  return Array.from({ length: 8 }, (_, i) => given[i] ?? 0);
}

function bend(camera: Intrinsics, x: number, y: number): [number, number] {
  const model = modelOf(camera);
  if (model === 0) return [x, y];
  const [a, b, c, d, e, f, g, h] = coefficientsOf(camera);
  const r2 = x * x + y * y;
  if (model === 2) {
    const r = Math.sqrt(r2);
    const theta = Math.atan(r);
    const t2 = theta * theta;
    const scale = r > 1e-6 ? (theta * (1 + t2 * (a + t2 * (b + t2 * (c + t2 * d))))) / r : 1;
    return [x * scale, y * scale];
  }
  const radial = (1 + r2 * (a + r2 * (b + r2 * e))) / (1 + r2 * (f + r2 * (g + r2 * h)));
  return [x * radial + 2 * c * x * y + d * (r2 + 2 * x * x), y * radial + c * (r2 + 2 * y * y) + 2 * d * x * y];
}

// The pixel of the image as it was sent.
export function project(camera: Intrinsics, point: Vector3): [number, number] {
  const [x, y] = bend(camera, point.x / point.z, point.y / point.z);
  return [camera.fx * x + camera.cx, camera.fy * y + camera.cy];
}

export const BEND_IN_SHADER = `
uniform int lens;
uniform float bends[8];
vec2 bend(vec2 ray) {
  float r2 = dot(ray, ray);
  if (lens == 1) {
    float radial = (1.0 + r2 * (bends[0] + r2 * (bends[1] + r2 * bends[4]))) / (1.0 + r2 * (bends[5] + r2 * (bends[6] + r2 * bends[7])));
    return ray * radial + vec2(
      2.0 * bends[2] * ray.x * ray.y + bends[3] * (r2 + 2.0 * ray.x * ray.x),
      bends[2] * (r2 + 2.0 * ray.y * ray.y) + 2.0 * bends[3] * ray.x * ray.y);
  }
  float r = sqrt(r2);
  if (lens == 0 || r < 1e-6) return ray;
  float theta = atan(r);
  float t2 = theta * theta;
  return ray * (theta * (1.0 + t2 * (bends[0] + t2 * (bends[1] + t2 * (bends[2] + t2 * bends[3])))) / r);
}`;
