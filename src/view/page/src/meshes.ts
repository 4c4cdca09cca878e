// Meshes of the robot's parts, as the program packs them.

import { BufferAttribute, BufferGeometry, Mesh, ShaderMaterial } from "three";
import { api } from "./api";
import type { Rgb } from "./colours";
import { store } from "./store";
import type { PartMesh } from "./types";

/** Coordinate that stands for the whole length of a mesh. */
const FINEST = 65535;

const numbers = (text: string): Uint16Array => new Uint16Array(Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer);

/** Points (mm) and triangles of a mesh. */
function unpack({ low, size, points, triangles }: PartMesh): BufferGeometry {
  const place = (v: number, i: number): number => low[i % 3] + (v / FINEST) * size;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(numbers(points), place), 3));
  geometry.setIndex(new BufferAttribute(numbers(triangles), 1));
  return geometry;
}

export interface Unpacked {
  part: string;
  geometry: BufferGeometry;
}

let known = "";
let asked: Promise<Unpacked[]> = Promise.resolve([]);

/** Meshes of these parts: of the exported page, or of the server, which is asked once. */
export function partMeshes(parts: string[]): Promise<Unpacked[]> {
  const key = JSON.stringify(parts);
  if (key !== known) {
    known = key;
    const inside = store.state?.meshes ?? [];
    const packed = store.offline ? Promise.resolve(inside) : api.meshes();
    // without its meshes the robot is drawn as tubes
    asked = packed.then(all => all.map(mesh => ({ part: mesh.part, geometry: unpack(mesh) }))).catch(() => []);
  }
  return asked;
}

/** A part whose faces have the light of their own planes. */
export class Solid {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;

  constructor(
    readonly part: string,
    geometry: BufferGeometry,
  ) {
    this.material = new ShaderMaterial({
      uniforms: { tint: { value: [1, 1, 1] } },
      vertexShader: /* glsl */ `
        varying vec3 seen;
        void main() {
          vec4 at = viewMatrix * modelMatrix * vec4(position, 1.0);
          seen = at.xyz;
          gl_Position = projectionMatrix * at;
        }`,
      fragmentShader: /* glsl */ `
        uniform vec3 tint;
        varying vec3 seen;
        void main() {
          vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
          gl_FragColor = vec4(tint * (0.5 + 0.5 * max(dot(normal, normalize(vec3(0.3, 0.55, 0.8))), 0.0)), 1.0);
        }`,
      side: 2,
    });
    this.mesh = new Mesh(geometry, this.material);
    this.mesh.matrixAutoUpdate = false;
    this.mesh.frustumCulled = false;
  }

  get triangles(): number {
    return (this.mesh.geometry.index?.count ?? 0) / 3;
  }

  /** Moves the part to a frame: 12 numbers, row by row. */
  place(frame: number[], tint: Rgb): void {
    const [a, b, c, x, d, e, f, y, g, h, i, z] = frame;
    this.mesh.matrix.set(a, b, c, x, d, e, f, y, g, h, i, z, 0, 0, 0, 1);
    this.mesh.matrixWorldNeedsUpdate = true;
    this.material.uniforms.tint.value = tint;
  }

  /** The geometry stays: the next scene shows it again. */
  dispose(): void {
    this.material.dispose();
  }
}
