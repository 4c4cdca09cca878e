// The contract between the server and the page. Lengths in mm, angles in deg, errors in µm, times
// in s unless the key says otherwise.

export type Severity = "error" | "warning" | "info";

export interface Message {
  id: string;
  severity: Severity;
  text: string;
  hint?: string;
  where?: { file?: string; line?: number; key?: string; pose?: string };
}

export type Status = "pass" | "fail" | "conditional" | "undecided" | "none";

export interface Verdict {
  status: Status;
  lines: string[];
  next: string[];
}

export interface Parameter {
  name: string;
  unit: string;
  nominal: number;
  identified: number;
  /** Standard uncertainty. */
  uncertainty?: number;
  held: boolean;
  meaning?: string;
  role?: string;
}

export interface Maximum {
  set: string;
  pose: string;
  target?: string;
  value_um: number;
  uncertainty_um?: number;
  limit_um?: number;
  before_um?: number;
}

export interface State {
  version: number;
  etalon: string;
  language: "en" | "de" | "fr";
  mode: "empty" | "proposed" | "campaign";
  name?: string;
  synthetic?: boolean;
  folder: string;
  files: { name: string; bytes: number; role?: string }[];
  messages: Message[];
  verdict?: Verdict;
  downloads: { name: string; label: string; bytes: number }[];
  scene?: Scene;
  parameters?: Parameter[];
  maximum?: Maximum;
  watching?: boolean;
  robots?: string[];
  /** In an exported page; otherwise the server is asked for them. */
  meshes?: PartMesh[];
  split?: { calibration: string; validation: string };
}

export type Vector = [number, number, number];

export interface Scene {
  unit: "mm";
  joints: { name: string; unit: string; lower?: number; upper?: number }[];
  bodies: { name: string }[];
  /** Poses of fixed frames: 16 numbers, row by row. */
  frames: { name: string; pose: number[] }[];
  instrument?: { name: string; at: Vector };
  poses: Pose[];
  points: Point[];
  magnification: number;
  /** Moving parts that have meshes. */
  parts?: string[];
}

/** Mesh of a part in its frame: points and triangles, three numbers of 16 bits each, in base64. */
export interface PartMesh {
  part: string;
  low: Vector;
  /** Length for which the coordinate 65,535 stands. */
  size: number;
  points: string;
  triangles: string;
}

export interface Pose {
  id: string;
  set: "calibration" | "validation" | "test" | "left_out";
  joints: number[];
  time_s?: number;
  strokes: { body: number; kind: "link" | "axis" | "target"; points: Vector[] }[];
  tool?: number[];
  /** Frames of the parts with meshes: 12 numbers each, row by row. */
  parts?: number[][];
}

export interface Point {
  /** Index into the poses of the scene. */
  pose: number;
  target: string;
  kind: string;
  measured: Vector;
  /** Measured minus computed position (µm). */
  before?: Vector;
  after?: Vector;
  magnitude_before_um?: number;
  magnitude_after_um?: number;
  /** Expanded uncertainty of the predicted position (k = 2). */
  uncertainty_um?: number;
  /** Covariance of the predicted position: xx xy xz yy yz zz. */
  covariance_um2?: number[];
  outlier?: boolean;
  used: boolean;
}

export interface WhatIfAsked {
  leave_out_poses?: string[];
  leave_out_targets?: string[];
  hold?: string[];
  free?: string[];
  limit_um?: number;
  calibration?: string;
  validation?: string;
}

export interface WhatIf {
  seconds: number;
  verdict?: Verdict;
  parameters: Parameter[];
  points: Pick<Point, "pose" | "target" | "after" | "magnitude_after_um">[];
  maximum_um: { first: number; now: number; uncertainty?: number };
  /** Changes beyond twice their standard uncertainty. */
  changed: { name: string; by: number; in_u: number }[];
  messages: Message[];
}

export interface Watch {
  received: number;
  planned?: number;
  line: string;
  tone: "good" | "wait" | "bad";
  /** The newest pose; expected: 95 %. */
  latest?: { pose: string; target?: string; error_um?: number; expected_um?: number; agrees: boolean; message?: Message };
  /** Standard uncertainties now and after the remaining poses. */
  parameters?: { name: string; unit: string; value: number; u_now: number; u_end?: number }[];
  next?: { pose: string; joints: number[]; reason: string };
  stop?: { met: boolean; text: string };
  scene?: Scene;
}

export interface Proposal {
  campaign: string;
  robot?: string;
  difference?: string;
  files: {
    name: string;
    columns: { heading: string; taken_for?: string; why?: string }[];
    rows: string[][];
    lines?: string[];
  }[];
  questions: { id: string; text: string; options?: { value: string; label: string }[]; doubt?: string }[];
  messages: Message[];
}
