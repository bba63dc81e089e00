// Points straight from the depth image, with the colours of the picture.
import { BEND_IN_SHADER } from "./lens";

export const VERTEX = `
precision highp usampler2D;
uniform usampler2D depth;
uniform sampler2D picture;
uniform usampler2D labels;
uniform vec4 camera; // fx, fy, cx, cy of the depth, which is without distortion
uniform vec4 sent; // of the picture
${BEND_IN_SHADER}
uniform float unit;
uniform int width;
uniform float size;
uniform uint chosen;
out vec3 tint;
void main() {
  ivec2 pixel = ivec2(gl_VertexID % width, gl_VertexID / width);
  float z = float(texelFetch(depth, pixel, 0).r) * unit;
  vec2 ray = (vec2(pixel) - camera.zw) / camera.xy;
  // Picture and masks are in the pixels that were sent.
  ivec2 at = ivec2(floor(bend(ray) * sent.xy + sent.zw + 0.5));
  ivec2 size_of_picture = textureSize(picture, 0);
  bool is_inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size_of_picture));
  tint = is_inside ? texelFetch(picture, at, 0).rgb : vec3(0.2);
  bool is_chosen = is_inside && all(lessThan(at, textureSize(labels, 0))) && texelFetch(labels, at, 0).r == chosen;
  if (chosen > 0u && !is_chosen) tint *= 0.35;
  vec3 point = vec3(ray * z, z);
  gl_Position = z > 0.0 ? projectionMatrix * modelViewMatrix * vec4(point, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
  gl_PointSize = clamp(size / gl_Position.w, 1.0, 12.0);
}`;
export const FRAGMENT = `
precision highp float;
in vec3 tint;
out vec4 color;
void main() { color = vec4(tint, 1.0); }`;
