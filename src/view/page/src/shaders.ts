// Instanced solids with light computed per vertex: cheap where no graphics processor is at hand.

import {
  CylinderGeometry,
  DoubleSide,
  DynamicDrawUsage,
  FrontSide,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  ShaderMaterial,
  IcosahedronGeometry,
  ConeGeometry,
  BufferGeometry,
  Float32BufferAttribute,
} from "three";
import type { IUniform } from "three";
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

/** A mesh whose instances are described by attributes of these sizes. */
export class Instances<Name extends string> {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  private readonly attributes = {} as Record<Name, InstancedBufferAttribute>;

  constructor(base: BufferGeometry, material: ShaderMaterial, sizes: Record<Name, number>, capacity: number) {
    const geometry = new InstancedBufferGeometry();
    geometry.index = base.index;
    for (const name of Object.keys(base.attributes)) geometry.setAttribute(name, base.getAttribute(name));
    for (const name of Object.keys(sizes) as Name[]) {
      const attribute = new InstancedBufferAttribute(new Float32Array(capacity * sizes[name]), sizes[name]);
      attribute.setUsage(DynamicDrawUsage);
      this.attributes[name] = attribute;
      geometry.setAttribute(name, attribute);
    }
    geometry.instanceCount = 0;
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
  }

  array(name: Name): Float32Array {
    return this.attributes[name].array as Float32Array;
  }

  changed(...names: Name[]): void {
    for (const name of names) this.attributes[name].needsUpdate = true;
  }

  get count(): number {
    return this.mesh.geometry.instanceCount;
  }

  set count(count: number) {
    this.mesh.geometry.instanceCount = count;
    this.mesh.visible = count > 0;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

type Uniforms = Record<string, IUniform<number>>;

/** Unit sphere of 20 faces, or of four times as many per level; its positions are its normals. */
function ball(detail: number): BufferGeometry {
  const geometry = new IcosahedronGeometry(1, detail);
  geometry.deleteAttribute("normal");
  geometry.deleteAttribute("uv");
  return mergeVertices(geometry);
}

/** Spheres: `at`, `tint`, and `size` in units. */
export function spheres(capacity: number, detail: number, unit: IUniform<number>): Instances<"at" | "tint" | "size"> {
  const material = new ShaderMaterial({
    uniforms: { unit },
    vertexShader: /* glsl */ `
      attribute vec3 at; attribute vec3 tint; attribute float size; uniform float unit;
      ${LIGHT}
      void main() {
        shade = lit(tint, position);
        gl_Position = projectionMatrix * viewMatrix * vec4(at + position * (size * unit), 1.0);
      }`,
    fragmentShader: PLAIN,
    side: FrontSide,
  });
  return new Instances(ball(detail), material, { at: 3, tint: 3, size: 1 }, capacity);
}

/** Tubes between two points, `size` in mm. */
export function tubes(capacity: number): Instances<"start" | "end" | "tint" | "size"> {
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
  return new Instances(base, material, { start: 3, end: 3, tint: 3, size: 1 }, capacity);
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

/** Arrows: `at`, `vector` (mm, before magnification), `tint`, `size` in units (0 hides). */
export function arrows(
  capacity: number,
  sides: number,
  uniforms: Uniforms,
): Instances<"at" | "vector" | "tint" | "size"> {
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
  return new Instances(arrowBase(sides), material, { at: 3, vector: 3, tint: 3, size: 1 }, capacity);
}

/** Ellipsoids by their half axes (mm, before magnification). */
export function ellipsoids(
  capacity: number,
  detail: number,
  uniforms: Uniforms,
): Instances<"at" | "a" | "b" | "c" | "tint"> {
  const material = new ShaderMaterial({
    uniforms,
    vertexShader: /* glsl */ `
      attribute vec3 at; attribute vec3 a; attribute vec3 b; attribute vec3 c; attribute vec3 tint;
      uniform float magnification;
      varying vec3 shade; varying float rim;
      void main() {
        vec3 place = at + (a * position.x + b * position.y + c * position.z) * magnification;
        vec3 n = a * (position.x / max(dot(a, a), 1e-18)) + b * (position.y / max(dot(b, b), 1e-18))
          + c * (position.z / max(dot(c, c), 1e-18));
        vec4 seen = viewMatrix * vec4(place, 1.0);
        vec3 inView = normalize((viewMatrix * vec4(normalize(n), 0.0)).xyz);
        rim = 1.0 - abs(dot(inView, normalize(-seen.xyz)));
        shade = tint;
        gl_Position = projectionMatrix * seen;
      }`,
    fragmentShader: /* glsl */ `
      varying vec3 shade; varying float rim;
      void main() { gl_FragColor = vec4(shade, 0.13 + 0.5 * rim * rim); }`,
    transparent: true,
    depthWrite: false,
  });
  return new Instances(ball(detail), material, { at: 3, a: 3, b: 3, c: 3, tint: 3 }, capacity);
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
