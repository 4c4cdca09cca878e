// The robot in three dimensions: drawn on demand, never in a permanent loop.

import {
  BufferGeometry,
  Color,
  Float32BufferAttribute,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  PerspectiveCamera,
  Scene as World,
  Vector3,
  WebGLRenderer,
} from "three";
import type { IUniform, Object3D } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { isDark, rgb, type Rgb } from "./colours";
import { button, fill, h, unique } from "./dom";
import { partMeshes, Solid } from "./meshes";
import { length, quantity, significant } from "./numbers";
import { describe, painter, type Painter } from "./paint";
import { arrows, dots, ellipsoids, halfAxes, lines, spheres, tubes, type Copies } from "./shaders";
import { after, isShown, on, pointsOf, scene, select, store } from "./store";
import type { Pose, Scene, Vector } from "./types";
import { t } from "./words";

/** Poses whose chains are drawn at once. */
const CHAINS = 400;
/** Ellipsoids that are drawn at once. */
const ELLIPSOIDS = 1500;
/** Points from which arrows are lines. */
const MANY = 2500;
/** Triangles of meshes from which they are left out while turning, if pictures take too long. */
const DENSE = 12000;
/** Share of a tube's thickness inside a mesh. */
const INSIDE = 0.3;
/** Distance (px) within which a pointer hits a point. */
const NEAR = 16;
/** Time (ms) after the last movement until the fine picture is drawn. */
const STILL = 220;
/** Time (ms) of a picture from which fewer pixels are drawn while turning. */
const SLOW = 42;

interface Look {
  background: string;
  links: Rgb[];
  axis: Rgb;
  target: Rgb;
  quiet: Rgb;
  grid: string;
  chain: string;
  chosen: Rgb;
}

const look = (): Look =>
  isDark()
    ? {
        background: "#15181c",
        links: [rgb("#9fb0c2"), rgb("#75879b")],
        axis: rgb("#c9a86a"),
        target: rgb("#8fb7a5"),
        quiet: rgb("#6b7580"),
        grid: "#2b323a",
        chain: "#8ea3b8",
        chosen: rgb("#ff6ee0"),
      }
    : {
        background: "#fbfcfd",
        links: [rgb("#7b8fa6"), rgb("#9db0c4")],
        axis: rgb("#b08a3c"),
        target: rgb("#6fa08b"),
        quiet: rgb("#a9b2bc"),
        grid: "#dfe4e9",
        chain: "#5f7388",
        chosen: rgb("#c4009c"),
      };

/** A renderer, or `null` if the browser cannot draw in three dimensions. */
function createRenderer(): { renderer: WebGLRenderer; isSoftware: boolean } | null {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("webgl2", { antialias: false });
  if (!context) return null;
  const info = context.getExtension("WEBGL_debug_renderer_info");
  const name = String(context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  // without a graphics processor a second context is dear, and smooth edges are too
  if (/swiftshader|llvmpipe|software|basic render/i.test(name))
    return { renderer: new WebGLRenderer({ canvas, context }), isSoftware: true };
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return { renderer: new WebGLRenderer({ antialias: true }), isSoftware: false };
}

interface Label {
  node: HTMLElement;
  at: Vector3;
}

export class Space {
  readonly root: HTMLElement;
  private readonly hint = h("p", { class: "hidden", id: unique("keys") }, t("keys"));
  private readonly stage = h("div", { class: "stage" });
  private readonly legend = h("div", { class: "legend" });
  private readonly tip = h("div", { class: "tip", hidden: true });
  private readonly labelled = h("div", { class: "labels", "aria-hidden": "true" });
  private renderer: WebGLRenderer | null = null;
  private controls: OrbitControls | null = null;
  private readonly camera = new PerspectiveCamera(32, 1, 1, 1e6);
  private readonly world = new World();
  private readonly unit: IUniform<number> = { value: 1 };
  private readonly magnification: IUniform<number> = { value: 1 };
  private drawn: Scene | undefined;
  private parts: { dispose(): void }[] = [];
  private readonly pixels: IUniform<number> = { value: 1 };
  private readonly away: IUniform<number> = { value: 1 };
  private points: Copies<"position" | "tint" | "size"> | null = null;
  private arrowsAfter: Copies<"at" | "vector" | "tint" | "size"> | null = null;
  private arrowsBefore: Copies<"at" | "vector" | "tint" | "size"> | null = null;
  private hulls: Copies<"at" | "a" | "b" | "c" | "tint"> | null = null;
  private pipes: Copies<"start" | "end" | "tint" | "size"> | null = null;
  private knees: Copies<"at" | "tint" | "size"> | null = null;
  private chains: LineSegments | null = null;
  private solids: Solid[] = [];
  private labels: Label[] = [];
  private poseLabels: Label[] = [];
  private radius = 1000;
  private centre = new Vector3();
  /** Points that shall be in the picture. */
  private outline: Vector3[] = [];
  private floor = 0;
  private flat = false;
  private software = false;
  private ratio = 1;
  private asked = false;
  /** The view was turned by hand, and stays. */
  private isTurned = false;
  private moving = false;
  private stillTimer = 0;
  private lastFrame = 0;
  private slow = 0;
  /** Time (ms) of the last picture while turning. */
  private taken = 0;
  /** Ellipsoids, and lines of thousands of points, are left out while turning, since pictures take too long. */
  private isSparse = false;
  private frames = 0;
  private hoverAsked = false;

  constructor() {
    this.root = h("section", { class: "space", "aria-label": t("space") }, this.stage, this.hint);
    let isGone = false;
    on(["gone"], () => {
      isGone = true;
      this.end();
    });
    // tables and charts are shown first: the first context may take a while
    requestAnimationFrame(() => setTimeout(() => !isGone && this.begin()));
  }

  private begin(): void {
    const created = createRenderer();
    if (!created) {
      fill(this.stage, h("p", { class: "note webgl" }, t("webgl")));
      this.stage.classList.add("without");
      return;
    }
    const { renderer, isSoftware } = created;
    this.software = isSoftware;
    this.ratio = isSoftware ? 1 : Math.min(devicePixelRatio, 2);
    this.renderer = renderer;
    renderer.debug.checkShaderErrors = false;
    const canvas = renderer.domElement;
    for (const [name, value] of Object.entries({
      tabindex: "0",
      role: "application",
      "aria-label": t("space"),
      "aria-describedby": this.hint.id,
    }))
      canvas.setAttribute(name, value);
    fill(this.stage, canvas, this.labelled, this.buttons(), this.legend, this.tip);
    this.controls = this.control(canvas);
    this.camera.up.set(0, 0, 1);
    new ResizeObserver(() => this.resize()).observe(this.stage);
    on(["scene", "dark"], () => this.rebuild());
    on(["view", "what"], () => this.restyle());
    on(["view"], () => this.showSelection());
    on(["selection"], () => this.showSelection());
    this.rebuild();
  }

  private control(canvas: HTMLCanvasElement): OrbitControls {
    const controls = new OrbitControls(this.camera, canvas);
    controls.enableDamping = false;
    controls.zoomToCursor = true;
    controls.addEventListener("change", () => this.move());
    controls.addEventListener("start", () => (this.isTurned = true));
    canvas.addEventListener("keydown", event => this.key(event));
    let down: [number, number] | null = null;
    canvas.addEventListener("pointerdown", event => (down = [event.clientX, event.clientY]));
    canvas.addEventListener("click", event => {
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 5) return;
      const point = this.hit(event);
      const shown = scene();
      if (point >= 0 && shown) select(shown.points[point].pose, point);
    });
    canvas.addEventListener("pointermove", event => {
      if (event.buttons || this.hoverAsked) return;
      this.hoverAsked = true;
      requestAnimationFrame(() => {
        this.hoverAsked = false;
        this.hover(event);
      });
    });
    canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
    return controls;
  }

  private buttons(): HTMLElement {
    const views: [string, Vector | null][] = [
      [t("iso"), [0.85, -1.25, 0.7]],
      [t("front"), [0, -1, 0.0001]],
      [t("side"), [1, 0, 0.0001]],
      [t("top"), [0, -0.0001, 1]],
    ];
    const fits = button(t("fit"), () => this.fit(null));
    return h(
      "div",
      { class: "views", role: "group", "aria-label": t("view") },
      fits,
      ...views.map(([label, from]) => button(label, () => this.fit(from))),
    );
  }

  private key(event: KeyboardEvent): void {
    const controls = this.controls;
    if (!controls || event.ctrlKey || event.metaKey || event.altKey) return;
    const [turn, shift] = [0.08, 40];
    const arrow: Record<string, [number, number]> = {
      ArrowLeft: [1, 0],
      ArrowRight: [-1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const by = arrow[event.key];
    if (by && event.shiftKey) controls.pan(by[0] * shift, by[1] * shift);
    else if (by && by[0]) controls.rotateLeft(by[0] * turn);
    else if (by) controls.rotateUp(by[1] * turn);
    else if (event.key === "+" || event.key === "=") this.zoom(1 / 1.15);
    else if (event.key === "-") this.zoom(1.15);
    else if (event.key === "Home") this.fit(null);
    else if (event.key === "PageUp") select(store.pose - 1);
    else if (event.key === "PageDown") select(store.pose + 1);
    else return;
    event.preventDefault();
    this.isTurned = event.key !== "Home" && !event.key.startsWith("Page") ? true : this.isTurned;
    controls.update();
  }

  private zoom(factor: number): void {
    const target = this.controls?.target ?? this.centre;
    this.camera.position.sub(target).multiplyScalar(factor).add(target);
    this.controls?.update();
    this.move();
  }

  /** Shows the whole scene, from a direction or from the present one. */
  private fit(from: Vector | null): void {
    const controls = this.controls;
    if (!controls) return;
    this.isTurned = false;
    const direction = from ? new Vector3(...from) : this.camera.position.clone().sub(controls.target);
    if (direction.lengthSq() === 0) direction.set(0.85, -1.25, 0.7);
    direction.normalize();
    const distance = this.distance(direction);
    const up = new Vector3(0, 0, 1).addScaledVector(direction, -direction.z).normalize();
    const lower = this.covered() * distance * Math.tan((this.camera.fov * Math.PI) / 360);
    controls.target.copy(this.centre).addScaledVector(up, -lower);
    this.camera.position.copy(controls.target).addScaledVector(direction, distance);
    controls.update();
    this.move();
  }

  /** Share of the height that the legend covers at the lower edge. */
  private covered(): number {
    return Math.min(0.35, this.legend.offsetHeight / Math.max(1, this.stage.clientHeight));
  }

  /** Distance from which all that is drawn is in the picture. */
  private distance(back: Vector3): number {
    const right = new Vector3(0, 0, 1).cross(back).normalize();
    const up = back.clone().cross(right);
    const tall = Math.tan((this.camera.fov * Math.PI) / 360) * 0.88 * (1 - this.covered());
    const wide = Math.tan((this.camera.fov * Math.PI) / 360) * this.camera.aspect * 0.93;
    const from = new Vector3();
    let far = this.radius * 0.2;
    for (const point of this.outline) {
      from.subVectors(point, this.centre);
      const depth = from.dot(back);
      far = Math.max(far, Math.abs(from.dot(right)) / wide + depth, Math.abs(from.dot(up)) / tall + depth);
    }
    return far;
  }

  private clear(): void {
    this.parts.forEach(part => part.dispose());
    this.parts = [];
    this.world.clear();
    this.labelled.replaceChildren();
    this.labels = [];
    this.poseLabels = [];
    this.solids = [];
    this.points = this.arrowsAfter = this.arrowsBefore = this.hulls = this.pipes = this.knees = this.chains = null;
  }

  private end(): void {
    this.clear();
    this.renderer?.forceContextLoss();
    this.renderer?.dispose();
    this.renderer = null;
  }

  /** Draws another scene. */
  private rebuild(): void {
    if (!this.renderer) return;
    const shown = scene();
    const first = this.drawn === undefined;
    this.clear();
    this.drawn = shown;
    const colours = look();
    this.renderer.setClearColor(new Color(colours.background));
    if (!shown) return this.draw();
    const before = this.radius;
    const counts = { poses: shown.poses.length, points: shown.points.length };
    const text = t("spaceText", { robot: store.state?.name ?? t("robot"), ...counts });
    this.renderer.domElement.setAttribute("aria-label", text);
    this.measure(shown);
    this.addGround(colours);
    shown.frames.forEach((frame, i) => this.addFrame(frame.name, frame.pose, i < 6));
    if (shown.instrument) this.addInstrument(shown.instrument);
    this.addChains(shown, colours);
    const count = shown.points.length;
    const pointers = count > MANY ? lines : arrows;
    const keep = <N extends string>(part: Copies<N>): Copies<N> => {
      this.parts.push(part);
      this.world.add(part.mesh);
      return part;
    };
    const uniforms = { unit: this.unit, magnification: this.magnification };
    const segments = Math.max(1, ...shown.poses.map(pose => pose.strokes.reduce((n, s) => n + s.points.length, 0)));
    this.pipes = keep(tubes(segments));
    this.knees = keep(spheres(segments));
    this.points = keep(dots(count, { ratio: this.pixels, distance: this.away }));
    this.arrowsBefore = keep(pointers(count, uniforms));
    this.arrowsAfter = keep(pointers(count, uniforms));
    this.hulls = keep(ellipsoids(Math.min(count, ELLIPSOIDS), uniforms));
    this.hulls.mesh.renderOrder = 2;
    shown.points.forEach((point, i) => {
      this.points?.array("position").set(point.measured, 3 * i);
      for (const part of [this.arrowsBefore, this.arrowsAfter]) part?.array("at").set(point.measured, 3 * i);
    });
    this.points.changed("position");
    this.arrowsBefore.changed("at");
    this.arrowsAfter.changed("at");
    this.points.count = this.arrowsBefore.count = this.arrowsAfter.count = count;
    this.restyle();
    this.showSelection();
    void this.addMeshes(shown);
    // a scene that grows keeps the view
    if (first || !this.isTurned || Math.abs(before / this.radius - 1) > 0.5)
      this.fit(first ? (this.flat ? [0.15, -0.45, 1] : [0.85, -1.25, 0.7]) : null);
  }

  /** Adds the meshes of the robot; until then, and without them, it is drawn as tubes. */
  private async addMeshes(shown: Scene): Promise<void> {
    if (!shown.parts?.length) return;
    const meshes = await partMeshes(shown.parts);
    if (this.drawn !== shown || !this.renderer || this.solids.length > 0) return;
    for (const { part, geometry } of meshes) {
      const solid = new Solid(part, geometry);
      this.solids.push(solid);
      this.parts.push(solid);
      this.world.add(solid.mesh);
    }
    this.stage.dataset.meshes = String(this.solids.length);
    this.showSelection();
  }

  /** Centre, radius and floor of what is drawn. */
  private measure(shown: Scene): void {
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = new Vector3(-Infinity, -Infinity, -Infinity);
    const at = new Vector3();
    const take = (p: Vector): void => {
      if (!p.every(Number.isFinite)) return;
      at.fromArray(p);
      low.min(at);
      high.max(at);
    };
    for (const pose of shown.poses) for (const stroke of pose.strokes) stroke.points.forEach(take);
    shown.points.forEach(point => take(point.measured));
    // a frame far away does not make the robot small
    const reach = 0.25 * low.distanceTo(high);
    const [inner, outer] = [low.clone().subScalar(reach), high.clone().addScalar(reach)];
    for (const frame of shown.frames) {
      at.set(frame.pose[3], frame.pose[7], frame.pose[11]);
      if (at.clone().clamp(inner, outer).equals(at)) take(at.toArray());
    }
    if (!(low.x <= high.x)) {
      low.set(-500, -500, -500);
      high.set(500, 500, 500);
    }
    this.centre.addVectors(low, high).multiplyScalar(0.5);
    this.radius = Math.max(1e-3, 0.5 * low.distanceTo(high));
    const step = Math.ceil(shown.poses.length / 300);
    this.outline = shown.poses
      .filter((_, i) => i % step === 0)
      .flatMap(pose => pose.strokes.flatMap(stroke => stroke.points.map(p => new Vector3(...p))));
    if (this.outline.length === 0) this.outline = shown.points.map(point => new Vector3(...point.measured));
    this.floor = low.z;
    this.flat = high.z - low.z < 0.25 * Math.max(high.x - low.x, high.y - low.y);
    this.camera.near = this.radius / 200;
    this.camera.far = this.radius * 60;
    this.camera.updateProjectionMatrix();
    if (this.controls) {
      this.controls.minDistance = this.radius / 40;
      this.controls.maxDistance = this.radius * 14;
    }
  }

  private lines(positions: number[], colour: string, opacity = 1): LineSegments {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
    const material = new LineBasicMaterial({ color: colour, transparent: opacity < 1, opacity });
    const lines = new LineSegments(geometry, material);
    lines.frustumCulled = false;
    this.parts.push(geometry, material);
    this.world.add(lines);
    return lines;
  }

  /** Spacing (mm) of the grid: 1, 2 or 5 times a power of ten. */
  private spacing(): number {
    const wanted = this.radius / 4;
    const power = 10 ** Math.floor(Math.log10(wanted));
    return power * ([5, 2].find(n => wanted / power >= n) ?? 1);
  }

  private addGround(colours: Look): void {
    const step = this.spacing();
    const count = Math.ceil((1.15 * this.radius) / step);
    const [cx, cy] = [this.centre.x, this.centre.y].map(v => Math.round(v / step) * step);
    const positions: number[] = [];
    const reach = count * step;
    for (let i = -count; i <= count; i++) {
      positions.push(cx - reach, cy + i * step, this.floor, cx + reach, cy + i * step, this.floor);
      positions.push(cx + i * step, cy - reach, this.floor, cx + i * step, cy + reach, this.floor);
    }
    this.lines(positions, colours.grid);
  }

  private label(text: string, at: Vector3, kind: string, list = this.labels): void {
    const node = h("span", { class: `label ${kind}` }, text);
    this.labelled.append(node);
    list.push({ node, at: at.clone() });
  }

  private addFrame(name: string, pose: number[], isNamed: boolean): void {
    const matrix = new Matrix4().fromArray(pose).transpose();
    const size = this.radius * 0.11;
    const origin = new Vector3().setFromMatrixPosition(matrix);
    const tints = isDark() ? ["#ff8a5c", "#4ecb9a", "#6fb0ff"] : ["#c0471a", "#00815a", "#0062b0"];
    ["x", "y", "z"].forEach((letter, i) => {
      const tip = new Vector3().setFromMatrixColumn(matrix, i).multiplyScalar(size).add(origin);
      this.lines([...origin.toArray(), ...tip.toArray()], tints[i]);
      if (isNamed) this.label(letter, tip, "letter");
    });
    if (isNamed) this.label(name, origin, "frame");
  }

  private addInstrument(instrument: NonNullable<Scene["instrument"]>): void {
    const at = new Vector3(...instrument.at);
    const s = this.radius * 0.035;
    const tip = at.clone();
    const corners = [0, 1, 2].map(i => {
      const angle = (i * 2 * Math.PI) / 3;
      return new Vector3(at.x + s * Math.cos(angle), at.y + s * Math.sin(angle), at.z - 2.4 * s);
    });
    const positions: number[] = [];
    corners.forEach((corner, i) => {
      positions.push(...tip.toArray(), ...corner.toArray());
      positions.push(...corner.toArray(), ...corners[(i + 1) % 3].toArray());
    });
    this.lines(positions, isDark() ? "#e6c15c" : "#8a6200");
    this.label(t("instrumentAt", { name: instrument.name }), tip, "instrument");
  }

  private addChains(shown: Scene, colours: Look): void {
    const positions: number[] = [];
    const step = Math.max(1, Math.ceil(shown.poses.length / CHAINS));
    for (let i = 0; i < shown.poses.length; i += step)
      for (const stroke of shown.poses[i].strokes) {
        if (stroke.kind === "axis") continue;
        for (let j = 1; j < stroke.points.length; j++) positions.push(...stroke.points[j - 1], ...stroke.points[j]);
      }
    this.chains = this.lines(positions, colours.chain, 0.22);
  }

  /** Colours, filters, magnification. */
  private restyle(): void {
    const shown = this.drawn;
    if (!shown || !this.points || !this.arrowsAfter || !this.arrowsBefore || !this.hulls) return;
    const paint = painter(shown);
    const { quiet } = look();
    this.magnification.value = store.view.magnification;
    const size = this.arrowsAfter.array("size");
    const sizeBefore = this.arrowsBefore.array("size");
    shown.points.forEach((point, i) => {
      const tint = paint.colour(i) ?? quiet;
      this.points?.array("tint").set(tint, 3 * i);
      this.arrowsAfter?.array("tint").set(tint, 3 * i);
      this.arrowsBefore?.array("tint").set(quiet, 3 * i);
      const [a, b] = [after(point).after, point.before];
      this.arrowsAfter?.array("vector").set(a ? a.map(v => v / 1000) : [0, 0, 0], 3 * i);
      this.arrowsBefore?.array("vector").set(b ? b.map(v => v / 1000) : [0, 0, 0], 3 * i);
      const isVisible = isShown(point);
      size[i] = isVisible && a && store.view.after ? 1 : 0;
      sizeBefore[i] = isVisible && b && store.view.before ? 0.8 : 0;
    });
    this.points.changed("tint");
    this.arrowsAfter.changed("tint", "vector", "size");
    this.arrowsBefore.changed("tint", "vector", "size");
    if (this.chains) this.chains.visible = store.view.chains;
    this.showSizes();
    this.showHulls(paint);
    this.showLegend(paint);
    this.ask();
  }

  /** Sizes of points: those of the selected pose are larger. */
  private showSizes(): void {
    const shown = this.drawn;
    if (!shown || !this.points) return;
    const size = this.points.array("size");
    const paint = painter(shown);
    const { chosen, quiet } = look();
    const tint = this.points.array("tint");
    const many = shown.points.length > MANY;
    shown.points.forEach((point, i) => {
      const isChosen = i === store.point || (store.point < 0 && point.pose === store.pose);
      size[i] = !isShown(point) ? 0 : i === store.point ? 7.5 : point.pose === store.pose ? 5.5 : many ? 2.2 : 3;
      tint.set(isChosen ? chosen : (paint.colour(i) ?? quiet), 3 * i);
    });
    this.points.changed("size", "tint");
  }

  private showHulls(paint: Painter): void {
    const [shown, hulls] = [this.drawn, this.hulls];
    if (!shown || !hulls) return;
    const { quiet } = look();
    const chosen = shown.points.length > ELLIPSOIDS ? pointsOf(store.pose) : shown.points.map((_, i) => i);
    let n = 0;
    if (store.view.ellipsoids && store.view.after)
      for (const i of chosen) {
        const point = shown.points[i];
        if (!point.covariance_um2 || point.covariance_um2.length !== 6 || !isShown(point) || n >= ELLIPSOIDS) continue;
        const axes = halfAxes(point.covariance_um2, 2);
        hulls.array("at").set(point.measured, 3 * n);
        (["a", "b", "c"] as const).forEach((name, j) => hulls.array(name).set(axes[j].map(v => v / 1000), 3 * n));
        hulls.array("tint").set(paint.colour(i) ?? quiet, 3 * n);
        n += 1;
      }
    hulls.changed("at", "a", "b", "c", "tint");
    hulls.count = n;
  }

  private showLegend(paint: Painter): void {
    const shown = this.drawn;
    if (!shown) return;
    const factor = significant(store.view.magnification, 2);
    const longest = Math.max(
      0,
      ...[store.view.after ? paint.largest("after") : 0, store.view.before ? paint.largest("before") : 0],
    );
    const grid = t("grid", { spacing: quantity(this.spacing(), "mm", 1) });
    const has = store.view.ellipsoids && shown.points.some(point => point.covariance_um2);
    fill(
      this.legend,
      paint.legend(),
      h("p", {}, `${t("arrowsNote", { factor, longest: length(longest) })} ${grid}.`),
      has && h("p", { class: "more" }, t("ellipsoidsNote", { factor })),
    );
  }

  private showSelection(): void {
    const shown = this.drawn;
    if (!shown) return;
    const pose = shown.poses[store.pose];
    this.showSizes();
    this.showHulls(painter(shown));
    if (pose) this.showRobot(pose);
    this.ask();
  }

  /** Tubes of the robot at a pose. */
  private showRobot(pose: Pose): void {
    const [pipes, knees] = [this.pipes, this.knees];
    if (!pipes || !knees) return;
    const colours = look();
    const thick = this.radius * (this.flat ? 0.012 : 0.02);
    const isSolid = store.view.meshes ? this.placeMeshes(pose, colours) : new Set<string>();
    let [n, m] = [0, 0];
    for (const stroke of pose.strokes) {
      const tint =
        stroke.kind === "axis" ? colours.axis : stroke.kind === "target" ? colours.target : colours.links[stroke.body % 2];
      const inside = isSolid.has(this.drawn?.bodies[stroke.body].name ?? "") ? INSIDE : 1;
      const size = thick * (stroke.kind === "link" ? inside : stroke.kind === "axis" ? 0.42 * inside : 0.24);
      stroke.points.forEach((p, i) => {
        knees.array("at").set(p, 3 * m);
        knees.array("tint").set(tint, 3 * m);
        knees.array("size")[m] = size * (stroke.kind === "link" ? 1.18 : 1);
        m += 1;
        if (i === 0) return;
        pipes.array("start").set(stroke.points[i - 1], 3 * n);
        pipes.array("end").set(p, 3 * n);
        pipes.array("tint").set(tint, 3 * n);
        pipes.array("size")[n] = size;
        n += 1;
      });
    }
    pipes.changed("start", "end", "tint", "size");
    knees.changed("at", "tint", "size");
    pipes.count = n;
    knees.count = m;
    this.poseLabels.forEach(label => label.node.remove());
    this.poseLabels = [];
    const points = pointsOf(store.pose);
    const shown = this.drawn;
    if (shown) for (const i of points.slice(0, 8)) {
      const point = shown.points[i];
      if (isShown(point)) this.label(point.target, new Vector3(...point.measured), "target", this.poseLabels);
    }
  }

  /** Moves the meshes to a pose; returns the names of their parts. */
  private placeMeshes(pose: Pose, colours: Look): Set<string> {
    const names = this.drawn?.parts ?? [];
    for (const solid of this.solids) {
      const at = names.indexOf(solid.part);
      const frame = pose.parts?.[at];
      if (frame) solid.place(frame, colours.links[at % 2]);
    }
    return new Set(this.solids.map(solid => solid.part));
  }

  private place(point: Vector3, width: number, height: number): [number, number, number] {
    const at = point.clone().project(this.camera);
    return [((at.x + 1) / 2) * width, ((1 - at.y) / 2) * height, at.z];
  }

  /** Index of the point under the pointer, or −1. */
  private hit(event: MouseEvent): number {
    const shown = this.drawn;
    const canvas = this.renderer?.domElement;
    if (!shown || !canvas) return -1;
    const box = canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const at = new Vector3();
    let [best, found] = [NEAR, -1];
    shown.points.forEach((point, i) => {
      if (!isShown(point)) return;
      const [px, py, depth] = this.place(at.fromArray(point.measured), box.width, box.height);
      const away = Math.hypot(px - x, py - y);
      if (depth < 1 && away < best) [best, found] = [away, i];
    });
    return found;
  }

  private hover(event: PointerEvent): void {
    const shown = this.drawn;
    const found = this.hit(event);
    const canvas = this.renderer?.domElement;
    if (!shown || !canvas || found < 0) {
      this.tip.hidden = true;
      if (canvas) canvas.style.cursor = "grab";
      return;
    }
    canvas.style.cursor = "pointer";
    this.tip.hidden = false;
    fill(this.tip, describe(shown, found));
    const box = this.stage.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const [width, height] = [this.tip.offsetWidth, this.tip.offsetHeight];
    this.tip.style.left = `${Math.max(4, Math.min(box.width - width - 4, x + 14))}px`;
    this.tip.style.top = `${y + height + 20 > box.height ? Math.max(4, y - height - 10) : y + 14}px`;
  }

  /** Puts the labels beside what they name. Names do not cover each other, nor the buttons. */
  private putLabels(width: number, height: number): void {
    const buttons = this.stage.querySelector<HTMLElement>(".views");
    const taken = buttons ? [[width - buttons.offsetWidth - 12, 0, width, buttons.offsetHeight + 12]] : [];
    const covers = (a: number[], b: number[]) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
    const placed = [...this.poseLabels, ...this.labels].map(({ node, at }) => ({ node, at: this.place(at, width, height) }));
    placed.sort((a, b) => a.at[1] - b.at[1]);
    for (const { node, at } of placed) {
      const [x, y, depth] = at;
      const isInside = depth < 1 && x >= 0 && y >= 0 && x <= width && y <= height;
      let box = [x, y, x + 8 + 7 * (node.textContent?.length ?? 0), y + 17];
      const isLetter = node.classList.contains("letter");
      for (let again = 0; !isLetter && again < 6 && taken.some(other => covers(box, other)); again++)
        box = [box[0], box[1] + 9, box[2], box[3] + 9];
      node.hidden = !isInside || (buttons !== null && covers([x, y - 12, x + 8, y], taken[0]));
      if (!node.hidden && !isLetter) taken.push(box);
      node.style.transform = `translate(${x.toFixed(1)}px, ${box[1].toFixed(1)}px)`;
    }
  }

  private resize(): void {
    const [width, height] = [this.stage.clientWidth, this.stage.clientHeight];
    if (!this.renderer || width === 0 || height === 0) return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(width, height);
    if (!this.isTurned) this.fit(null);
    this.draw();
  }

  /** The camera moved: coarse pictures until it rests. */
  private move(): void {
    this.moving = true;
    clearTimeout(this.stillTimer);
    this.stillTimer = window.setTimeout(() => {
      this.moving = false;
      this.lastFrame = 0;
      this.ask();
    }, Math.max(STILL, 4 * this.taken));
    this.ask();
  }

  private ask(): void {
    if (this.asked || !this.renderer) return;
    this.asked = true;
    requestAnimationFrame(now => {
      this.asked = false;
      this.pace(now);
      this.draw();
    });
  }

  /** Draws fewer pixels while turning if pictures take too long. */
  private pace(now: number): void {
    if (!this.moving) return;
    const taken = this.lastFrame ? now - this.lastFrame : 0;
    this.lastFrame = now;
    if (taken === 0 || taken > 2000) return;
    this.taken = taken;
    this.slow = taken > SLOW ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.slow < 4) return;
    this.slow = 0;
    if (!this.isSparse) this.isSparse = true;
    else this.ratio = Math.max(0.6, this.ratio * 0.8);
  }

  private draw(): void {
    const renderer = this.renderer;
    if (!renderer) return;
    const fine = this.software ? Math.max(1.5, Math.min(2, devicePixelRatio)) : Math.min(2, devicePixelRatio);
    const ratio = this.moving ? this.ratio : fine;
    if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
    const isSparse = this.moving && this.isSparse;
    if (this.hulls) this.hulls.mesh.visible = !isSparse && this.hulls.count > 0;
    const isMany = (this.drawn?.points.length ?? 0) > MANY;
    if (this.arrowsAfter) this.arrowsAfter.mesh.visible = store.view.after && !(isSparse && isMany);
    if (this.arrowsBefore) this.arrowsBefore.mesh.visible = store.view.before && !(isSparse && isMany);
    const isDense = this.solids.reduce((sum, solid) => sum + solid.triangles, 0) > DENSE;
    for (const solid of this.solids) solid.mesh.visible = store.view.meshes && !(isSparse && isDense);
    const [width, height] = [this.stage.clientWidth, this.stage.clientHeight];
    const distance = this.camera.position.distanceTo(this.controls?.target ?? this.centre);
    this.pixels.value = ratio;
    this.away.value = distance;
    // one unit is about one pixel at the distance of the target
    this.unit.value = (2 * distance * Math.tan((this.camera.fov * Math.PI) / 360)) / Math.max(1, height);
    renderer.render(this.world as Object3D as World, this.camera);
    this.putLabels(width, height);
    this.frames += 1;
    renderer.domElement.dataset.frames = String(this.frames);
  }
}
