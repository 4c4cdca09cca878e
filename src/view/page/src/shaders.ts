// Solids with light computed per vertex: cheap where no graphics processor is at hand.

import {
  BufferAttribute,
  BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Float32BufferAttribute,
  IcosahedronGeometry,
  LineSegments,
  Mesh,
  PlaneGeometry,
  Points,
  ShaderMaterial,
} from "three";
import type { IUniform, Object3D } from "three";
import { mergeVertices } from "three/addons/utils/BufferGeometryUtils.js";

const LIGHT = /* glsl */ `
varying vec3 shade;
vec3 lit(vec3 colour, vec3 normalInWorld) {
  vec3 n = normalize((viewMatrix * vec4(normalInWorld, 0.0)).xyz);
  float light = 0.58 + 0.42 * max(dot(n, normalize(vec3(0.3, 0.55, 0.8))), 0.0);
  return colour * light;
}
void basis(vec3 d, out vec3 u, out vec3 v) {
  vec3 helper = abs(d.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  u = normalize(cross(helper, d));
  v = cross(d, u);
}`;

const PLAIN = /* glsl */ `
varying vec3 shade;
void main() { gl_FragColor = vec4(shade, 1.0); }`;

/**
 * Solids, lines or points of one kind, described by arrays of these names. Each is a copy of a base with its own vertices:
 * without a graphics processor, an instance of an instanced drawing takes as long as hundreds of vertices.
 */
export class Copies<Name extends string> {
  readonly mesh: Object3D;
  private readonly values = {} as Record<Name, Float32Array>;
  private readonly attributes = {} as Record<Name, BufferAttribute>;
  private readonly geometry = new BufferGeometry();
  /** Vertices of a copy, and indices. */
  private readonly vertices: number;
  private readonly indices: number;
  private shown = 0;

  /** Without a base each copy is one point. */
  constructor(
    private readonly material: ShaderMaterial,
    private readonly sizes: Record<Name, number>,
    private readonly capacity: number,
    base: BufferGeometry | null,
    kind: "faces" | "lines" = "faces",
  ) {
    this.vertices = base?.getAttribute("position").count ?? 1;
    for (const name of Object.keys(base?.attributes ?? {})) {
      const own = base?.getAttribute(name) as BufferAttribute;
      const all = new Float32Array(capacity * own.array.length);
      for (let i = 0; i < capacity; i++) all.set(own.array, i * own.array.length);
      this.geometry.setAttribute(name, new BufferAttribute(all, own.itemSize));
    }
    const index = base?.index?.array;
    this.indices = index?.length ?? this.vertices;
    if (index) {
      const all = new Uint32Array(capacity * index.length);
      for (let i = 0; i < capacity; i++) index.forEach((at, k) => (all[i * index.length + k] = at + i * this.vertices));
      this.geometry.setIndex(new BufferAttribute(all, 1));
    }
    for (const name of Object.keys(sizes) as Name[]) {
      this.values[name] = new Float32Array(capacity * sizes[name]);
      const all = this.vertices === 1 ? this.values[name] : new Float32Array(capacity * this.vertices * sizes[name]);
      this.attributes[name] = new BufferAttribute(all, sizes[name]).setUsage(DynamicDrawUsage);
      this.geometry.setAttribute(name, this.attributes[name]);
    }
    if (!base) this.mesh = new Points(this.geometry, material);
    else this.mesh = kind === "lines" ? new LineSegments(this.geometry, material) : new Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.count = 0;
  }

  /** Values of all copies. */
  array(name: Name): Float32Array {
    return this.values[name];
  }

  changed(...names: Name[]): void {
    for (const name of names) {
      const [values, size, all] = [this.values[name], this.sizes[name], this.attributes[name].array as Float32Array];
      let to = 0;
      if (this.vertices > 1)
        for (let i = 0; i < this.capacity; i++)
          for (let vertex = 0; vertex < this.vertices; vertex++)
            for (let k = 0; k < size; k++) all[to++] = values[i * size + k];
      this.attributes[name].needsUpdate = true;
    }
  }

  get count(): number {
    return this.shown;
  }

  set count(count: number) {
    this.shown = count;
    this.geometry.setDrawRange(0, count * this.indices);
    this.mesh.visible = count > 0;
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}

type Uniforms = Record<string, IUniform<number>>;

/** Unit sphere of 80 faces; its positions are its normals. */
function ball(): BufferGeometry {
  const geometry = new IcosahedronGeometry(1, 1);
  geometry.deleteAttribute("normal");
  geometry.deleteAttribute("uv");
  return mergeVertices(geometry);
}

/** Spheres: `at`, `tint`, and `size` in mm. */
export function spheres(capacity: number): Copies<"at" | "tint" | "size"> {
  const material = new ShaderMaterial({
    vertexShader: /* glsl */ `
      attribute vec3 at; attribute vec3 tint; attribute float size;
      ${LIGHT}
      void main() {
        shade = lit(tint, position);
        gl_Position = projectionMatrix * viewMatrix * vec4(at + position * size, 1.0);
      }`,
    fragmentShader: PLAIN,
  });
  return new Copies(material, { at: 3, tint: 3, size: 1 }, capacity, ball());
}

/** Balls drawn as one point each: `position`, `tint`, and the radius `size` in pixels (0 hides). */
export function dots(capacity: number, uniforms: Uniforms): Copies<"position" | "tint" | "size"> {
  const material = new ShaderMaterial({
    uniforms,
    vertexShader: /* glsl */ `
      attribute vec3 tint; attribute float size;
      uniform float ratio; uniform float distance;
      varying vec3 shade;
      void main() {
        vec4 seen = viewMatrix * vec4(position, 1.0);
        shade = tint;
        gl_PointSize = 2.0 * size * ratio * clamp(distance / max(-seen.z, 1e-6), 0.6, 1.8);
        gl_Position = size > 0.0 ? projectionMatrix * seen : vec4(2.0, 2.0, 2.0, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      varying vec3 shade;
      void main() {
        vec2 at = gl_PointCoord * 2.0 - 1.0;
        float beyond = dot(at, at);
        if (beyond > 1.0) discard;
        vec3 normal = vec3(at.x, -at.y, sqrt(1.0 - beyond));
        gl_FragColor = vec4(shade * (0.62 + 0.38 * max(dot(normal, normalize(vec3(0.3, 0.55, 0.8))), 0.0)), 1.0);
      }`,
  });
  return new Copies(material, { position: 3, tint: 3, size: 1 }, capacity, null);
}

/** Tubes between two points, `size` in mm. */
export function tubes(capacity: number): Copies<"start" | "end" | "tint" | "size"> {
  const material = new ShaderMaterial({
    vertexShader: /* glsl */ `
      attribute vec3 start; attribute vec3 end; attribute vec3 tint; attribute float size;
      ${LIGHT}
      void main() {
        vec3 along = end - start;
        float l = length(along);
        vec3 d = l > 0.0 ? along / l : vec3(0.0, 0.0, 1.0);
        vec3 u; vec3 v;
        basis(d, u, v);
        vec3 n = u * position.x + v * position.z;
        shade = lit(tint, n);
        gl_Position = projectionMatrix * viewMatrix * vec4(mix(start, end, position.y + 0.5) + n * size, 1.0);
      }`,
    fragmentShader: PLAIN,
    side: DoubleSide,
  });
  const base = new CylinderGeometry(1, 1, 1, 10, 1, true);
  return new Copies(material, { start: 3, end: 3, tint: 3, size: 1 }, capacity, base);
}

/** Shaft and head of an arrow of length 1; `part` is 0 on the shaft, 1 on the head. */
function arrowBase(sides: number): BufferGeometry {
  const shaft = new CylinderGeometry(1, 1, 1, sides, 1, true).translate(0, 0.5, 0);
  const head = new ConeGeometry(2.8, 1, sides + 1, 1, true).translate(0, 0.5, 0);
  const geometry = new BufferGeometry();
  const parts = [shaft, head];
  const joined = (name: "position" | "normal"): number[] => parts.flatMap(part => [...part.getAttribute(name).array]);
  geometry.setAttribute("position", new Float32BufferAttribute(joined("position"), 3));
  geometry.setAttribute("normal", new Float32BufferAttribute(joined("normal"), 3));
  const counts = parts.map(part => part.getAttribute("position").count);
  geometry.setAttribute("part", new Float32BufferAttribute(counts.flatMap((n, i) => Array<number>(n).fill(i)), 1));
  const indices = parts.flatMap((part, i) => [...(part.index?.array ?? [])].map(at => at + (i ? counts[0] : 0)));
  geometry.setIndex(indices);
  return geometry;
}

/** Arrows: `at`, `vector` (mm, before magnification), `tint`, `size` in pixels (0 hides). */
export function arrows(capacity: number, uniforms: Uniforms): Copies<"at" | "vector" | "tint" | "size"> {
  const material = new ShaderMaterial({
    uniforms,
    vertexShader: /* glsl */ `
      attribute vec3 at; attribute vec3 vector; attribute vec3 tint; attribute float size; attribute float part;
      uniform float unit; uniform float magnification;
      ${LIGHT}
      void main() {
        float l = length(vector) * magnification;
        vec3 d = l > 0.0 ? normalize(vector) : vec3(0.0, 0.0, 1.0);
        vec3 u; vec3 v;
        basis(d, u, v);
        float head = min(6.5 * unit * size, 0.55 * l);
        float thick = min(unit * size, head / 6.5);
        float along = part < 0.5 ? position.y * (l - head) : l - head + position.y * head;
        vec3 n = u * normal.x + v * normal.z + d * normal.y;
        shade = lit(tint, n);
        vec3 place = at + d * along + (u * position.x + v * position.z) * thick;
        gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
      }`,
    fragmentShader: PLAIN,
    side: DoubleSide,
  });
  return new Copies(material, { at: 3, vector: 3, tint: 3, size: 1 }, capacity, arrowBase(4));
}

/** The same arrows as lines, for thousands of them. */
export function lines(capacity: number, uniforms: Uniforms): Copies<"at" | "vector" | "tint" | "size"> {
  const material = new ShaderMaterial({
    uniforms,
    vertexShader: /* glsl */ `
      attribute vec3 at; attribute vec3 vector; attribute vec3 tint; attribute float size;
      uniform float magnification;
      varying vec3 shade;
      void main() {
        shade = tint;
        vec4 place = vec4(at + vector * (magnification * position.y), 1.0);
        gl_Position = size > 0.0 ? projectionMatrix * viewMatrix * place : vec4(2.0, 2.0, 2.0, 1.0);
      }`,
    fragmentShader: PLAIN,
  });
  const base = new BufferGeometry();
  base.setAttribute("position", new Float32BufferAttribute([0, 0, 0, 0, 1, 0], 3));
  return new Copies(material, { at: 3, vector: 3, tint: 3, size: 1 }, capacity, base, "lines");
}

/** Outlines of ellipsoids, from their half axes (mm, before magnification): one square each. */
export function ellipsoids(capacity: number, uniforms: Uniforms): Copies<"at" | "a" | "b" | "c" | "tint"> {
  const material = new ShaderMaterial({
    uniforms,
    // an ellipsoid with axes A is seen as the ellipse of S = M Mᵀ, M = A in the picture plane; S = L Lᵀ
    vertexShader: /* glsl */ `
      attribute vec3 at; attribute vec3 a; attribute vec3 b; attribute vec3 c; attribute vec3 tint;
      uniform float magnification;
      varying vec3 shade; varying vec2 within;
      void main() {
        vec4 seen = viewMatrix * vec4(at, 1.0);
        mat3 turned = mat3(viewMatrix);
        vec2 p = (turned * a).xy, q = (turned * b).xy, r = (turned * c).xy;
        float xx = p.x * p.x + q.x * q.x + r.x * r.x;
        float xy = p.x * p.y + q.x * q.y + r.x * r.y;
        float yy = p.y * p.y + q.y * q.y + r.y * r.y;
        float l = sqrt(max(xx, 1e-18));
        float m = xy / l;
        float n = sqrt(max(yy - m * m, 1e-18));
        within = position.xy * 2.0;
        seen.xy += magnification * vec2(l * within.x, m * within.x + n * within.y);
        shade = tint;
        gl_Position = projectionMatrix * seen;
      }`,
    fragmentShader: /* glsl */ `
      varying vec3 shade; varying vec2 within;
      void main() {
        float beyond = dot(within, within);
        if (beyond > 1.0) discard;
        gl_FragColor = vec4(shade, 0.14 + 0.4 * beyond * beyond * beyond);
      }`,
    transparent: true,
    depthWrite: false,
  });
  return new Copies(material, { at: 3, a: 3, b: 3, c: 3, tint: 3 }, capacity, new PlaneGeometry(1, 1));
}

/** Half axes of the ellipsoid of a covariance (xx xy xz yy yz zz), for a coverage factor k. */
export function halfAxes(covariance: number[], k: number): [number, number, number][] {
  const [xx, xy, xz, yy, yz, zz] = covariance;
  const m = [
    [xx, xy, xz],
    [xy, yy, yz],
    [xz, yz, zz],
  ];
  const axes = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  // Jacobi rotations (Golub & Van Loan, 8.5)
  for (let sweep = 0; sweep < 12; sweep++)
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ]) {
      if (Math.abs(m[p][q]) < 1e-15 * (Math.abs(m[p][p]) + Math.abs(m[q][q]))) continue;
      const theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
      const tan = Math.sign(theta || 1) / (Math.abs(theta) + Math.hypot(theta, 1));
      const cos = 1 / Math.hypot(tan, 1);
      const sin = tan * cos;
      for (let i = 0; i < 3; i++) [m[i][p], m[i][q]] = [cos * m[i][p] - sin * m[i][q], sin * m[i][p] + cos * m[i][q]];
      for (let i = 0; i < 3; i++) [m[p][i], m[q][i]] = [cos * m[p][i] - sin * m[q][i], sin * m[p][i] + cos * m[q][i]];
      for (let i = 0; i < 3; i++)
        [axes[i][p], axes[i][q]] = [cos * axes[i][p] - sin * axes[i][q], sin * axes[i][p] + cos * axes[i][q]];
    }
  return [0, 1, 2].map(j => {
    const half = k * Math.sqrt(Math.max(0, m[j][j]));
    return axes.map(row => row[j] * half) as [number, number, number];
  });
}
