// What the page shows at present, and who is told if it changes.

import type { Point, Scene, State, Watch, WhatIf, WhatIfAsked } from "./types";

export interface View {
  /** `after`, `before`, `time`, `target`, `set`, or `joint:INDEX`. */
  colour: string;
  set: string;
  target: string;
  before: boolean;
  after: boolean;
  ellipsoids: boolean;
  meshes: boolean;
  chains: boolean;
  magnification: number;
}

export type Topic = "state" | "scene" | "selection" | "view" | "what" | "watch" | "busy" | "online" | "dark" | "gone";

let listeners: { topics: Topic[]; listen: () => void; lasts: boolean }[] = [];

/** Calls a function at each change. A layout that is replaced takes its listeners with it. */
export function on(topics: Topic[], listen: () => void, lasts = false): void {
  listeners.push({ topics, listen, lasts });
}

export function tell(topic: Topic): void {
  for (const { topics, listen } of [...listeners]) if (topics.includes(topic)) listen();
}

/** Ends the present layout. */
export function leave(): void {
  tell("gone");
  listeners = listeners.filter(entry => entry.lasts);
}

export const store = {
  state: null as State | null,
  /** The page has no server: it is a file. */
  offline: false,
  /** The server has ended. */
  ended: false,
  /** Index of the selected pose, and of the selected point (−1: all points of the pose). */
  pose: 0,
  point: -1,
  view: {
    colour: "after",
    set: "",
    target: "",
    before: false,
    after: true,
    ellipsoids: true,
    meshes: true,
    chains: false,
    magnification: 100,
  } as View,
  asked: {} as WhatIfAsked,
  what: null as WhatIf | null,
  watch: null as Watch | null,
  busy: null as { text: string; share?: number } | null,
};

/** The scene that is drawn: that of the measurement in progress, or that of the result. */
export const scene = (): Scene | undefined => store.watch?.scene ?? store.state?.scene;

/** Indices of the points of each pose. */
let pointsByPose: number[][] = [];
let indexed: Scene | undefined;

export function pointsOf(pose: number): number[] {
  const shown = scene();
  if (shown !== indexed) {
    indexed = shown;
    pointsByPose = shown ? shown.poses.map(() => []) : [];
    shown?.points.forEach((point, i) => pointsByPose[point.pose]?.push(i));
  }
  return pointsByPose[pose] ?? [];
}

export function select(pose: number, point = -1): void {
  const count = scene()?.poses.length ?? 0;
  if (count === 0) return;
  const clamped = Math.max(0, Math.min(count - 1, pose));
  if (clamped === store.pose && point === store.point) return;
  store.pose = clamped;
  store.point = point;
  tell("selection");
}

export function selectPose(id: string): void {
  const at = scene()?.poses.findIndex(pose => pose.id === id) ?? -1;
  if (at >= 0) select(at);
}

/** The magnification was chosen by hand, and stays. */
let isMagnified = false;

/** Magnification at which the arrows that are shown can be seen beside the robot. */
export function magnify(): void {
  const shown = scene();
  if (!shown || isMagnified) return;
  const isBefore = store.view.before || !shown.points.some(point => point.after);
  const ends = shown.poses.slice(0, 200).flatMap(pose => pose.strokes.flatMap(stroke => stroke.points));
  const sizes = [0, 1, 2].map(i => {
    const values = ends.map(end => end[i]);
    return Math.max(...values) - Math.min(...values);
  });
  const longest = shown.points.reduce((most, point) => {
    const um = isBefore ? point.magnitude_before_um : point.magnitude_after_um;
    return point.used && um !== undefined ? Math.max(most, um) : most;
  }, 0);
  const wanted = (0.07 * Math.hypot(...sizes) * 1000) / longest;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const rounded = power * ([5, 2].find(n => wanted / power >= n) ?? 1);
  const isFound = Number.isFinite(rounded) && rounded > 0 && ends.length > 1;
  store.view.magnification = isFound ? Math.min(1e5, Math.max(1, rounded)) : shown.magnification || 100;
}

export function change(view: Partial<View>): void {
  if (view.magnification !== undefined) isMagnified = true;
  Object.assign(store.view, view);
  if (view.before !== undefined || view.after !== undefined) magnify();
  tell("view");
}

/** Whether a point passes the filters. */
export function isShown(point: Point): boolean {
  const { set, target } = store.view;
  if (target && point.target !== target) return false;
  return !set || scene()?.poses[point.pose]?.set === set;
}

export const targets = (): string[] => [...new Set(scene()?.points.map(point => point.target) ?? [])];
export const sets = (): string[] => [...new Set(scene()?.poses.map(pose => pose.set) ?? [])];

let whatScene: Scene | undefined;
let whatPoints = new Map<string, WhatIf["points"][number]>();
let whatOf: WhatIf | null = null;

/** Error of a point after calibration: of the what-if result if there is one. */
export function after(point: Point): Pick<Point, "after" | "magnitude_after_um"> {
  if (!store.what) return point;
  if (whatOf !== store.what || whatScene !== scene()) {
    whatOf = store.what;
    whatScene = scene();
    whatPoints = new Map(store.what.points.map(p => [`${p.pose} ${p.target}`, p]));
  }
  return whatPoints.get(`${point.pose} ${point.target}`) ?? point;
}

export interface Worst {
  point: number;
  um: number;
}

/** Largest error after calibration of the judged set: validation if there is one. */
export function worst(): Worst | null {
  const shown = scene();
  if (!shown) return null;
  const judged = shown.poses.some(pose => pose.set === "validation") ? "validation" : "calibration";
  let found: Worst | null = null;
  shown.points.forEach((point, i) => {
    const um = after(point).magnitude_after_um;
    if (um === undefined || !point.used || shown.poses[point.pose]?.set !== judged) return;
    if (!found || um > found.um) found = { point: i, um };
  });
  return found;
}
