// The frame in 3D, in the camera frame: points straight from the depth image, boxes of objects,
// hands, the support and the way down. Positions are metres, x right, y down, z forward.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { boxLines, vector } from "./box_lines";
import { FRAGMENT, VERTEX } from "./cloud_shader";
import { el } from "./dom";
import { coefficientsOf, modelOf } from "./lens";
import { labelsOf } from "./masks";
import { handLines } from "./overlay";
import { colorOf } from "./palette";
import type { Frame, Vector3 } from "./types";

const PICK_PIXELS = 7;
const HELP = "drag or arrow keys turn, wheel or + and - zoom, with shift they move, Home goes back";
const TURN = 0.08; // radians a key
const ZOOM = 1.1;

function integerTexture(data: Uint16Array, width: number, height: number): THREE.DataTexture {
  const texture = new THREE.DataTexture(data, width, height, THREE.RedIntegerFormat, THREE.UnsignedShortType);
  texture.internalFormat = "R16UI";
  texture.minFilter = texture.magFilter = THREE.NearestFilter;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

export class Cloud {
  readonly element: HTMLElement;
  private readonly canvas = el("canvas", { id: "cloud", tabindex: "0", role: "application", "aria-label": `cloud of points; ${HELP}` });
  private readonly readout = el("output", { id: "point" });
  private readonly why = el("div", { id: "no-cloud", role: "status" });
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  // Turns the camera frame, y down and z forward, into that of three, y up and z backward.
  private readonly world = new THREE.Group();
  private readonly things = new THREE.Group();
  private readonly eye = new THREE.PerspectiveCamera(50, 4 / 3, 0.01, 100);
  private readonly controls: OrbitControls;
  private readonly points: THREE.Points<THREE.BufferGeometry, THREE.ShaderMaterial>;
  private readonly sizes = new ResizeObserver(() => this.redraw());
  private depth = new Uint16Array();
  private frame: Frame | null = null;
  private placed = "";
  private waiting = false;

  constructor() {
    this.element = el("div", { class: "view" }, el("div", { class: "aim" }, this.canvas), this.why, el("div", { class: "soft" }, HELP), this.readout);
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // colours as the camera took them
    this.world.scale.set(1, -1, -1);
    this.points = new THREE.Points(new THREE.BufferGeometry(), this.material());
    this.points.frustumCulled = false;
    this.world.add(this.points, this.things);
    this.scene.add(this.world);
    this.controls = new OrbitControls(this.eye, this.canvas);
    this.controls.addEventListener("change", () => this.redraw());
    this.canvas.addEventListener("pointermove", (event) => this.measure(event));
    this.canvas.addEventListener("keydown", (event) => {
      if (!this.onKey(event.key, event.shiftKey)) return;
      this.measureMiddle();
      event.preventDefault();
    });
    this.canvas.addEventListener("focus", () => this.measureMiddle());
    this.sizes.observe(this.canvas);
  }

  private material(): THREE.ShaderMaterial {
    const uniforms = {
      depth: { value: integerTexture(new Uint16Array(1), 1, 1) },
      labels: { value: integerTexture(new Uint16Array(1), 1, 1) },
      picture: { value: new THREE.Texture() },
      camera: { value: new THREE.Vector4(1, 1, 0, 0) },
      sent: { value: new THREE.Vector4(1, 1, 0, 0) },
      lens: { value: 0 },
      bends: { value: new Array(8).fill(0) },
      unit: { value: 0.001 },
      width: { value: 1 },
      size: { value: 2 },
      chosen: { value: 0 },
    };
    return new THREE.ShaderMaterial({ glslVersion: THREE.GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms });
  }

  show(frame: Frame, depth: Uint16Array, picture: ImageBitmap): void {
    if (!frame.depth || depth.length !== frame.depth.width * frame.depth.height) return;
    this.why.textContent = "";
    this.frame = frame;
    this.depth = depth;
    const { width, height, unit_m, intrinsics } = frame.depth;
    const uniforms = this.points.material.uniforms;
    for (const name of ["depth", "labels", "picture"]) uniforms[name].value.dispose();
    uniforms.depth.value = integerTexture(depth, width, height);
    const labels = labelsOf(frame.detections?.objects ?? [], width, height);
    uniforms.labels.value = integerTexture(labels, width, height);
    const texture = new THREE.Texture(picture);
    texture.minFilter = texture.magFilter = THREE.NearestFilter;
    texture.generateMipmaps = false;
    texture.flipY = false;
    texture.needsUpdate = true;
    uniforms.picture.value = texture;
    uniforms.camera.value.set(intrinsics.fx, intrinsics.fy, intrinsics.cx, intrinsics.cy);
    const sent = frame.intrinsics ?? intrinsics;
    uniforms.sent.value.set(sent.fx, sent.fy, sent.cx, sent.cy);
    uniforms.lens.value = modelOf(sent);
    uniforms.bends.value = coefficientsOf(sent);
    uniforms.unit.value = unit_m;
    uniforms.width.value = width;
    this.points.geometry.setDrawRange(0, width * height);
    this.place(frame);
    this.addThings(frame);
    this.redraw();
  }

  // Nothing, rather than another frame than the one that is shown beside it.
  clear(why: string): void {
    this.why.textContent = why;
    this.frame = null;
    this.points.geometry.setDrawRange(0, 0);
    this.clearThings();
    this.tell(null);
    this.redraw();
  }

  // Browsers have few contexts for 3D, and do not see by themselves that one is not needed any more.
  close(): void {
    this.element.remove();
    this.sizes.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  choose(label: number): void {
    this.points.material.uniforms.chosen.value = label;
    this.redraw();
  }

  // Where the camera stood, with its field of view.
  place(frame: Frame, again = false): void {
    if ((this.placed === frame.robot && !again) || !frame.depth) return;
    this.placed = frame.robot;
    const { height, intrinsics, unit_m } = frame.depth;
    this.eye.fov = (360 / Math.PI) * Math.atan(height / 2 / intrinsics.fy);
    const measured = this.depth.filter((value) => value > 0).sort();
    const middle = (measured[measured.length >> 1] ?? 1000) * unit_m;
    this.eye.position.set(0, 0, 0);
    this.controls.target.set(0, 0, -middle);
    this.controls.update();
  }

  home(): void {
    if (this.frame) this.place(this.frame, true);
    this.redraw();
  }

  // Turns around what is looked at, moves that, or goes nearer; false for other keys.
  private onKey(key: string, moves: boolean): boolean {
    const [right, up] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key] ?? [0, 0];
    const from = this.eye.position.clone().sub(this.controls.target);
    if (key === "Home") this.home();
    else if (key === "+" || key === "=") from.divideScalar(ZOOM);
    else if (key === "-") from.multiplyScalar(ZOOM);
    else if (!right && !up) return false;
    else if (moves) this.move(right, up, from.length() * TURN * 0.5);
    else {
      const around = new THREE.Spherical().setFromVector3(from);
      around.theta += right * TURN;
      around.phi -= up * TURN;
      from.setFromSpherical(around.makeSafe());
    }
    if (key === "Home") return true;
    this.eye.position.copy(this.controls.target).add(from);
    this.controls.update();
    this.redraw();
    return true;
  }

  private move(right: number, up: number, meters: number): void {
    const way = new THREE.Vector3(right, up, 0).applyQuaternion(this.eye.quaternion);
    this.controls.target.addScaledVector(way, meters);
  }

  private clearThings(): void {
    this.things.traverse((thing) => (thing as THREE.LineSegments).geometry?.dispose());
    this.things.clear();
  }

  private addThings(frame: Frame): void {
    this.clearThings();
    const detections = frame.detections;
    for (const object of detections?.objects ?? []) {
      const [r, g, b] = colorOf(object.label);
      this.addLines(boxLines(object.oriented_box), new THREE.Color(r / 255, g / 255, b / 255));
      if (object.grasps[0]) {
        this.addLines(handLines(object.grasps[0]).flatMap(([from, to]) => [vector(from), vector(to)]), new THREE.Color(1, 1, 1));
      }
    }
    if (detections?.support_surface) this.addSupport(detections.support_surface.plane);
    if (detections?.gravity) {
      const start = this.middle();
      const down = new THREE.ArrowHelper(vector(detections.gravity.direction), start, 0.15, 0xff3333, 0.04, 0.02);
      this.things.add(down);
    }
  }

  // A grid of 10 cm in the plane that things stand on, below the middle of them.
  private addSupport(plane: { normal: Vector3; offset: number }): void {
    const normal = vector(plane.normal);
    const middle = this.middle();
    middle.addScaledVector(normal, -(normal.dot(middle) + plane.offset));
    const across = new THREE.Vector3(1, 0, 0).addScaledVector(normal, -normal.x).normalize();
    const along = new THREE.Vector3().crossVectors(normal, across);
    const at = (a: number, b: number) => middle.clone().addScaledVector(across, a).addScaledVector(along, b);
    const reach = 0.4;
    const lines: THREE.Vector3[] = [];
    for (let i = -reach; i <= reach + 1e-6; i += 0.1) {
      lines.push(at(i, -reach), at(i, reach), at(-reach, i), at(reach, i));
    }
    this.addLines(lines, new THREE.Color(0.55, 0.55, 0.6));
  }

  private middle(): THREE.Vector3 {
    const boxes = this.frame?.detections?.objects.map((object) => vector(object.oriented_box.pose.position)) ?? [];
    const sum = boxes.reduce((total, each) => total.add(each), new THREE.Vector3());
    return boxes.length > 0 ? sum.divideScalar(boxes.length) : new THREE.Vector3(0, 0, 1);
  }

  private addLines(corners: THREE.Vector3[], color: THREE.Color): void {
    const geometry = new THREE.BufferGeometry().setFromPoints(corners);
    this.things.add(new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color })));
  }

  private redraw(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      const { clientWidth, clientHeight } = this.canvas;
      if (clientWidth === 0) return;
      this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
      this.renderer.setSize(clientWidth, clientHeight, false);
      this.eye.aspect = clientWidth / clientHeight;
      this.eye.updateProjectionMatrix();
      const pixels = clientHeight * this.renderer.getPixelRatio();
      const focal = pixels / 2 / Math.tan((this.eye.fov * Math.PI) / 360);
      this.points.material.uniforms.size.value = (1.5 * focal) / (this.frame?.depth?.intrinsics.fy ?? focal);
      this.renderer.render(this.scene, this.eye);
    });
  }

  private measure(event: PointerEvent): void {
    const bounds = this.canvas.getBoundingClientRect();
    this.tell(this.pick(event.clientX - bounds.left, event.clientY - bounds.top));
  }

  // Where the cross is that keyboards see.
  private measureMiddle(): void {
    if (this.canvas.matches(":focus-visible")) this.tell(this.pick(this.canvas.clientWidth / 2, this.canvas.clientHeight / 2));
  }

  private tell(point: THREE.Vector3 | null): void {
    this.readout.value = point ? `${point.x.toFixed(3)} ${point.y.toFixed(3)} ${point.z.toFixed(3)} m` : "";
  }

  // The nearest point that is drawn at most some pixels beside this place of the canvas.
  pick(x: number, y: number): THREE.Vector3 | null {
    const shape = this.frame?.depth;
    if (!shape) return null;
    const { clientWidth, clientHeight } = this.canvas;
    this.world.updateMatrixWorld();
    this.eye.updateMatrixWorld();
    const m = new THREE.Matrix4()
      .multiplyMatrices(this.eye.projectionMatrix, this.eye.matrixWorldInverse)
      .multiply(this.world.matrixWorld).elements;
    const { fx, fy, cx, cy } = shape.intrinsics;
    let best: THREE.Vector3 | null = null;
    let least = Infinity;
    for (let i = 0; i < this.depth.length; ++i) {
      if (this.depth[i] === 0) continue;
      const pz = this.depth[i] * shape.unit_m;
      const px = (((i % shape.width) - cx) * pz) / fx;
      const py = ((Math.floor(i / shape.width) - cy) * pz) / fy;
      const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
      if (w <= 0) continue;
      const dx = (((m[0] * px + m[4] * py + m[8] * pz + m[12]) / w + 1) / 2) * clientWidth - x;
      const dy = ((1 - (m[1] * px + m[5] * py + m[9] * pz + m[13]) / w) / 2) * clientHeight - y;
      const away = dx * dx + dy * dy;
      // What is nearer to the eye covers what is behind it; beside it, the closest pixel counts.
      const cost = w + 0.002 * away;
      if (away <= PICK_PIXELS * PICK_PIXELS && cost < least) {
        least = cost;
        best = new THREE.Vector3(px, py, pz);
      }
    }
    return best;
  }
}
