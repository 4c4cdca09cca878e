//! Five-bar: two arms A1 B1 C and A2 B2 C in the plane, with the tool E fixed to the link B2 C
//! (thesis, chapter 4). Includes its limits: singularities and the distance to them, joint limits,
//! and collisions of links.
//!
//! The model has twelve parameters (thesis, section 4.3). Joint values are the two encoder angles,
//! followed by the assembly mode.

use super::keys::{Description, Reader};
use super::{
    Definition, Faults, Joint, JointRange, Key, Kinematics, Model, Outline, Parameter, Parametrised, PlanarPose,
    Quantity, Robot, Role, State,
};
use super::{REACH, in_plane, in_space, meaning, root};
use etalon_base::catalogue::Phrase;
use etalon_base::expression::{Formula, Recorded};
use etalon_base::phrase;
use etalon_base::pose::Pose;
use etalon_base::pose::Vector;
use etalon_base::scalar::Scalar;
use etalon_base::sketch::{Sketch, StrokeKind};
use std::f64::consts::PI;

const PARAMETERS: usize = 12;
/// Names, quantities, roles, nominal values and meanings (thesis, eq. 4.24; x_o and y_o: table
/// 4.1).
const TABLE: [(&str, Quantity, Role, f64, &str); PARAMETERS] = [
    ("l11", Quantity::Length, Role::Robot, 230.0, meaning("meaning-proximal-link-1")),
    ("l12", Quantity::Length, Role::Robot, 230.0, meaning("meaning-distal-link-1")),
    ("l21", Quantity::Length, Role::Robot, 230.0, meaning("meaning-proximal-link-2")),
    ("l22", Quantity::Length, Role::Robot, 230.0, meaning("meaning-distal-link-2")),
    ("d", Quantity::Length, Role::Robot, 275.0, meaning("meaning-motor-distance")),
    ("l23", Quantity::Length, Role::Robot, 230.0, meaning("meaning-tool-distance")),
    ("gamma", Quantity::Angle, Role::Robot, 0.0, meaning("meaning-tool-angle")),
    ("delta1", Quantity::Angle, Role::Robot, 0.0, meaning("meaning-encoder-1-offset")),
    ("delta2", Quantity::Angle, Role::Robot, 0.0, meaning("meaning-encoder-2-offset")),
    ("x_o", Quantity::Length, Role::Base, 263.0, meaning("meaning-motors-middle-x")),
    ("y_o", Quantity::Length, Role::Base, 75.0, meaning("meaning-motors-middle-y")),
    ("phi", Quantity::Angle, Role::Base, 0.0, meaning("meaning-motor-direction")),
];

/// Five-bar with twelve parameters.
pub(super) const MODEL: Model = Model::new::<FiveBarLimits>("five_bar");

impl Description for FiveBarLimits {
    const STATES_GEOMETRY: bool = false;

    fn read(keys: &mut Reader) -> Self {
        let none = Self::default();
        let limits = keys.table(Key::plain("reach", REACH), |keys| {
            let limits = [
                keys.optional(Key::angle("theta1", "Smallest and largest encoder angle of joint 1.")),
                keys.optional(Key::angle("theta2", "Smallest and largest encoder angle of joint 2.")),
            ];
            let clearance_mm = keys.optional(Key::length(
                "clearance",
                "Smallest distance between the proximal link of one arm and the distal link of the other; 0 forbids crossing links.",
            ));
            let margins = [
                keys.optional(Key::angle(
                    "type1_margin",
                    "Smallest angle of an arm from the stretched or folded position (type 1 singularity).",
                )),
                keys.optional(Key::angle(
                    "type2_margin",
                    "Smallest angle between the distal links and a common line (type 2 singularity).",
                )),
            ];
            (limits, clearance_mm, margins)
        });
        let ([first, second], clearance_mm, [type1, type2]) = limits;
        Self {
            limits_rad: [first.unwrap_or(none.limits_rad[0]), second.unwrap_or(none.limits_rad[1])],
            clearance_mm,
            type1_margin_rad: type1.unwrap_or(none.type1_margin_rad),
            type2_margin_rad: type2.unwrap_or(none.type2_margin_rad),
        }
    }

    fn build(&self, _targets: &[String]) -> Result<Box<dyn Robot>, Faults> {
        Ok(Box::new(FiveBar::default().with_limits(*self)))
    }
}

/// Branch indices ζ1 and ζ2 of the four working modes.
pub const WORKING_MODES: [[f64; 2]; 4] = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];

/// Five-bar with its nominal parameters and its limits.
///
/// # Examples
///
/// ```
/// use etalon_robots::{FiveBar, Robot};
/// use std::f64::consts::FRAC_PI_2;
///
/// let robot = FiveBar::default();
/// let mut parameters = robot.nominal();
/// parameters[robot.index("d").expect("the distance of the motors")] = 276.0; // mm
///
/// // the proximal links (230 mm) point along y and their ends are 276 mm apart; above them the
/// // distal links (230 mm) close a triangle of height √(230² - 138²) = 184 mm
/// let linkage = robot.direct(&parameters, [FRAC_PI_2, FRAC_PI_2], 1.0);
/// let [x_mm, y_mm] = linkage.e;
/// assert!(x_mm.abs() < 1e-9 && (y_mm - (230.0 + 184.0)).abs() < 1e-9);
/// ```
#[derive(Clone, Debug)]
pub struct FiveBar {
    definition: Definition,
    limits: FiveBarLimits,
}

/// Points of the mechanism in the base frame (mm).
#[derive(Clone, Copy, Debug)]
pub struct Linkage<T = f64> {
    /// Elbow of arm 1.
    pub b1: [T; 2],
    /// Elbow of arm 2.
    pub b2: [T; 2],
    /// Common end of both arms.
    pub c: [T; 2],
    /// Tool.
    pub e: [T; 2],
}

/// Limits of a five-bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiveBarLimits {
    /// Smallest and largest encoder angles.
    pub limits_rad: [[f64; 2]; 2],
    /// Minimum distance between the centre lines of the proximal link of one arm and the distal
    /// link of the other (A1B1 and B2C, A2B2 and B1C). With 0 these links must not cross; with
    /// `None` all links pass over each other.
    pub clearance_mm: Option<f64>,
    /// Minimum angle from a stretched or folded arm (type 1).
    pub type1_margin_rad: f64,
    /// Minimum angle from aligned distal links (type 2).
    pub type2_margin_rad: f64,
}

impl Default for FiveBarLimits {
    /// No limits except that singularities are avoided by more than rounding.
    fn default() -> Self {
        Self { limits_rad: [[-PI, PI]; 2], clearance_mm: None, type1_margin_rad: 1e-6, type2_margin_rad: 1e-6 }
    }
}

/// Angular distance to singularities: deviation of two links from alignment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingularityDistance {
    /// Distance to type 1, a stretched or folded arm: arm 1 (A1B1 and B1C), arm 2 (A2B2 and B2E).
    pub type1_rad: [f64; 2],
    /// Distance to type 2, aligned distal links B1C and B2C, where the tool moves with locked
    /// joints.
    pub type2_rad: f64,
}

/// A solution of the inverse kinematics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InverseSolution {
    /// Working mode: branch indices ζ1 and ζ2.
    pub branches: [f64; 2],
    /// Encoder angles in (−π, π].
    pub joints_rad: [f64; 2],
    /// Assembly mode ξ of this solution.
    pub assembly: f64,
}

impl Default for FiveBar {
    fn default() -> Self {
        let mut parameters = TABLE.map(|(name, quantity, role, nominal, meaning)| {
            Parameter::new(name, quantity, role, nominal).meaning(meaning)
        });
        (parameters[9].axis, parameters[10].axis) = (Some(0), Some(1));
        let joints = ["theta1", "theta2"].map(|name| Joint { name: name.into(), quantity: Quantity::Angle });
        let definition = Definition {
            model: "five_bar",
            dimension: 2,
            parameters: parameters.into(),
            joints: joints.into(),
            targets: vec!["tool".into()],
        };
        Self { definition, limits: FiveBarLimits::default() }
    }
}

impl FiveBar {
    /// Replaces the limits.
    pub fn with_limits(mut self, limits: FiveBarLimits) -> Self {
        self.limits = limits;
        self
    }

    /// Direct kinematics in the base frame from encoder angles (rad) and assembly mode ξ (+1 or
    /// −1); NaN if the arms do not meet (thesis, eq. 4.1 to 4.7, where θ = encoder angle + δ).
    pub fn direct<T: Scalar>(&self, p: &[T], q: [T; 2], assembly: impl Into<T>) -> Linkage<T> {
        let proximal = [0, 1].map(|arm| direction(q[arm] + p[7 + arm]));
        closed(p, proximal, direction(p[6]), assembly.into())
    }

    /// Inverse kinematics: encoder angles (rad) that bring the tool to `e` (base frame) with branch
    /// indices ζ1 and ζ2; NaN if an arm does not reach (thesis, eq. 4.8 to 4.19).
    pub fn inverse<T: Scalar>(&self, p: &[T], e: [T; 2], branches: [impl Into<T>; 2]) -> [T; 2] {
        let branches = branches.map(Into::into);
        let [l11, l12, l21, l22, d, l23, gamma, delta1, delta2] = [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|i| p[i]);
        let half = d * 0.5;
        // the branch of the thesis turns clockwise, the assembly mode counterclockwise
        let a2_b2 = intersect_links([e[0] - half, e[1]], l21, l23, -branches[1]); // eq. 4.15 to 4.18
        let b2 = [a2_b2[0] + half, a2_b2[1]]; // eq. 4.14
        let c = plus(b2, turn(minus(e, b2), -gamma, l22 / l23)); // eq. 4.13
        let a1_b1 = intersect_links([c[0] + half, c[1]], l11, l12, -branches[0]); // eq. 4.9 to 4.12
        let angle = |v: [T; 2], delta: T| (v[1].atan2(v[0]) - delta).wrapped(); // eq. 4.8, 4.19
        [angle(a1_b1, delta1), angle(a2_b2, delta2)]
    }

    /// Transforms a point from the world to the base frame (inverse of thesis, eq. 4.21).
    pub fn to_base<T: Scalar>(&self, p: &[T], point: [T; 2]) -> [T; 2] {
        turn(minus(point, [p[9], p[10]]), -p[11], T::from(1.0))
    }

    /// Assembly mode ξ in which encoder angles `q` bring the tool nearest to `e` (base frame).
    pub fn assembly_at(&self, p: &[f64], q: [f64; 2], e: [f64; 2]) -> f64 {
        let off = |assembly: f64| {
            let reached = self.direct(p, q, assembly).e;
            (reached[0] - e[0]).hypot(reached[1] - e[1])
        };
        if off(-1.0) < off(1.0) { -1.0 } else { 1.0 }
    }

    /// Distance of a configuration to singularities.
    pub fn singularity_distance(&self, p: &[f64], at: &Linkage) -> SingularityDistance {
        let half = 0.5 * p[4];
        let (arm1, arm2) = (from([-half, 0.0], at.b1), from([half, 0.0], at.b2));
        SingularityDistance {
            type1_rad: [from_line(arm1, from(at.b1, at.c)), from_line(arm2, from(at.b2, at.e))],
            type2_rad: from_line(from(at.b1, at.c), from(at.b2, at.c)),
        }
    }

    /// Description of the limit that forbids a configuration, if any: reach, joint limits, margins
    /// or clearance.
    pub fn violation(&self, p: &[f64], q: [f64; 2], at: &Linkage) -> Option<Phrase> {
        let FiveBarLimits { limits_rad, clearance_mm, type1_margin_rad, type2_margin_rad } = self.limits;
        if !at.e.iter().all(|v| v.is_finite()) {
            return Some(phrase!("arms-do-not-meet"));
        }
        let outside = |(_, (q, [least, greatest])): &(usize, (f64, [f64; 2]))| !(*least..=*greatest).contains(q);
        if let Some((i, (q, ends))) = q.into_iter().zip(limits_rad).enumerate().find(outside) {
            let [q, least, greatest] = [q, ends[0], ends[1]].map(f64::to_degrees);
            let joint = format!("theta{}", i + 1);
            return Some(phrase!("angle-beyond-limits", joint, q, least, greatest));
        }
        let far = self.singularity_distance(p, at);
        let type1_rad = far.type1_rad[0].min(far.type1_rad[1]);
        for (name, found, margin) in [("1", type1_rad, type1_margin_rad), ("2", far.type2_rad, type2_margin_rad)] {
            if found.is_nan() || found < margin {
                let [found, margin] = [found, margin].map(f64::to_degrees);
                return Some(phrase!("singularity-near", kind = name, found, margin));
            }
        }
        let least = clearance_mm?;
        let found = self.clearance_mm(p, at);
        (found.is_nan() || found <= least).then(|| phrase!("links-near", found, least))
    }

    /// Smallest distance between the proximal link of one arm and the distal link of the other.
    pub fn clearance_mm(&self, p: &[f64], at: &Linkage) -> f64 {
        let half = 0.5 * p[4];
        let (a1, a2) = ([-half, 0.0], [half, 0.0]);
        let pairs = [[a1, at.b1, at.b2, at.c], [a2, at.b2, at.b1, at.c]];
        pairs.into_iter().map(|[a, b, c, d]| segment_distance(a, b, c, d)).fold(f64::INFINITY, f64::min)
    }

    /// Solutions for all working modes that reach `e` (base frame, mm).
    pub fn reached(&self, p: &[f64], e: [f64; 2]) -> Vec<InverseSolution> {
        let configuration = |branches: [f64; 2]| {
            let joints_rad = self.inverse(p, e, branches);
            let assembly = self.assembly_at(p, joints_rad, e);
            let at = self.direct(p, joints_rad, assembly);
            self.violation(p, joints_rad, &at).is_none().then_some(InverseSolution { branches, joints_rad, assembly })
        };
        WORKING_MODES.into_iter().filter_map(configuration).collect()
    }
}

/// A five-bar with bound parameters.
struct WithParameters<'a, T = f64> {
    p: &'a [T],
    /// Direction of the tool as seen from the distal link.
    tool: [T; 2],
    /// Direction of the base in the world.
    base: [T; 2],
}

impl<'a, T: Scalar> WithParameters<'a, T> {
    fn new(p: &'a [T]) -> Self {
        Self { p, tool: direction(p[6]), base: direction(p[11]) }
    }

    /// Directions of the proximal links, and the points of the mechanism.
    fn linkage(&self, joints: &[f64]) -> ([[T; 2]; 2], Linkage<T>) {
        let assembly = joints.get(2).copied().unwrap_or(1.0);
        let proximal = [0, 1].map(|arm| direction(self.p[7 + arm] + joints[arm]));
        (proximal, closed(self.p, proximal, self.tool, assembly.into()))
    }

    /// The tool in the world.
    fn tool(&self, joints: &[f64]) -> [T; 2] {
        let (_, at) = self.linkage(joints);
        plus([self.p[9], self.p[10]], turn_by(self.base, at.e, T::from(1.0)))
    }
}

impl WithParameters<'_> {
    /// Derivatives of the tool in the world with respect to each parameter.
    ///
    /// The distal links tie C to both elbows: with u = C − B1 and v = C − B2,
    /// u·dC = u·dB1 + l12 dl12 and v·dC = v·dB2 + l22 dl22 (differentials of eq. 4.3).
    fn derivatives(&self, joints: &[f64]) -> [[f64; 2]; PARAMETERS] {
        let p = self.p;
        let ([first, second], Linkage { b1, b2, c, e }) = self.linkage(joints);
        let (u, v, b2_e) = (from(b1, c), from(b2, c), from(b2, e));
        let area = u[0] * v[1] - u[1] * v[0];
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let tied = |by_u: f64, by_v: f64| [(by_u * v[1] - by_v * u[1]) / area, (by_v * u[0] - by_u * v[0]) / area];
        // B2 E turns with B2 C (eq. 4.1)
        let moved = |db2: [f64; 2], dc: [f64; 2]| plus(db2, turn_by(self.tool, minus(dc, db2), p[5] / p[3]));
        let across = |length: f64, along: [f64; 2]| left_normal(along).map(|x| length * x);
        let still = [0.0; 2];
        let in_base = [
            moved(still, tied(dot(u, first), 0.0)),
            moved(still, tied(p[1], 0.0)),
            moved(second, tied(0.0, dot(v, second))),
            minus(moved(still, tied(0.0, p[3])), b2_e.map(|x| x / p[3])),
            moved([0.5, 0.0], tied(-0.5 * u[0], 0.5 * v[0])),
            turn_by(self.tool, v, 1.0 / p[3]),
            left_normal(b2_e),
            moved(still, tied(dot(u, across(p[0], first)), 0.0)),
            moved(across(p[2], second), tied(0.0, dot(v, across(p[2], second)))),
        ];
        let mut all = [still; PARAMETERS];
        all.iter_mut().zip(in_base).for_each(|(all, of_tool)| *all = turn_by(self.base, of_tool, 1.0));
        (all[9], all[10], all[11]) = ([1.0, 0.0], [0.0, 1.0], left_normal(turn_by(self.base, e, 1.0)));
        all
    }
}

impl Parametrised for WithParameters<'_> {
    fn positions(&self, state: State, out: &mut [f64]) {
        out.copy_from_slice(&self.tool(state.joints));
    }
    fn jacobian(&self, state: State, out: &mut [f64]) {
        let by_parameter = self.derivatives(state.joints);
        for (axis, row) in out.chunks_exact_mut(PARAMETERS).enumerate() {
            row.iter_mut().zip(&by_parameter).for_each(|(out, by)| *out = by[axis]);
        }
    }
    fn joint_jacobian(&self, state: State, positions: &mut [f64], out: &mut [f64]) {
        self.positions(state, positions);
        // an offset adds to the value of its joint
        let by_parameter = self.derivatives(state.joints);
        for (axis, row) in out.chunks_exact_mut(2).enumerate() {
            row.copy_from_slice(&[by_parameter[7][axis], by_parameter[8][axis]]);
        }
    }
    fn target_derivatives(&self, state: State, targets: &[usize], write: &mut dyn FnMut(usize, usize, Vector)) {
        for &target in targets {
            let by_parameter = self.derivatives(state.joints).into_iter().enumerate();
            by_parameter.for_each(|(parameter, [x, y])| write(target, parameter, [x, y, 0.0]));
        }
    }
}

/// Points of the mechanism from the directions of the proximal links, and from the direction of the
/// tool relative to the distal link (thesis, eq. 4.1 to 4.7).
fn closed<T: Scalar>(p: &[T], [along1, along2]: [[T; 2]; 2], tool: [T; 2], assembly: T) -> Linkage<T> {
    let [l11, l12, l21, l22, d, l23] = [0, 1, 2, 3, 4, 5].map(|i| p[i]);
    let b1 = [l11 * along1[0] - d * 0.5, l11 * along1[1]]; // eq. 4.4
    let b2 = [l21 * along2[0] + d * 0.5, l21 * along2[1]]; // eq. 4.2
    let between = minus(b2, b1); // eq. 4.7
    let c = plus(b1, intersect_links(between, l12, l22, assembly)); // eq. 4.3, 4.5, 4.6
    let e = plus(b2, turn_by(tool, minus(c, b2), l23 / l22)); // eq. 4.1
    Linkage { b1, b2, c, e }
}

fn plus<T: Scalar>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn minus<T: Scalar>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Unit vector at an angle.
fn direction<T: Scalar>(angle: T) -> [T; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos, sin]
}

/// Rotates `v` counterclockwise and scales it.
fn turn<T: Scalar>(v: [T; 2], angle: T, stretch: T) -> [T; 2] {
    turn_by(direction(angle), v, stretch)
}

/// Rotates `v` by the angle of a unit vector and scales it.
fn turn_by<T: Scalar>([cos, sin]: [T; 2], v: [T; 2], stretch: T) -> [T; 2] {
    [stretch * (cos * v[0] - sin * v[1]), stretch * (sin * v[0] + cos * v[1])]
}

/// Rotates `v` counterclockwise by a right angle.
fn left_normal([x, y]: [f64; 2]) -> [f64; 2] {
    [-y, x]
}

/// Vector from the first end of `base` to the meeting point of two links, with lengths `near` from
/// the first end and `far` from the second; on the left of `base` for `side` = +1.
fn intersect_links<T: Scalar>(base: [T; 2], near: T, far: T, side: T) -> [T; 2] {
    let square = base[0] * base[0] + base[1] * base[1];
    let along = (near * near - far * far + square) / (square * 2.0); // eq. 4.5: b1 / d
    let across = root(near * near / square - along * along, 1.0) * side; // eq. 4.5: ξ h / d
    [along * base[0] - across * base[1], along * base[1] + across * base[0]]
}

/// Moves a tool by a nanometre if it is on the axis of motor 2: there a folded arm of equal links
/// turns freely, and has a direction only after the move.
fn off_the_motor(p: &[f64], e: [f64; 2]) -> [f64; 2] {
    let motor = [0.5 * p[4], 0.0];
    if e == motor { [e[0] + 1e-6, e[1]] } else { e }
}

fn from(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [b[0] - a[0], b[1] - a[1]]
}

/// Angle between two directions, modulo reversal.
fn from_line(a: [f64; 2], b: [f64; 2]) -> f64 {
    let cross = a[0] * b[1] - a[1] * b[0];
    let along = a[0] * b[0] + a[1] * b[1];
    cross.abs().atan2(along.abs())
}

/// Smallest distance between two segments; zero if they cross.
fn segment_distance(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> f64 {
    let side = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        let (u, v) = (from(p, q), from(p, r));
        u[0] * v[1] - u[1] * v[0]
    };
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    let to = |p: [f64; 2], a: [f64; 2], b: [f64; 2]| {
        let (u, v) = (from(a, b), from(a, p));
        let t = ((u[0] * v[0] + u[1] * v[1]) / (u[0] * u[0] + u[1] * u[1])).clamp(0.0, 1.0);
        (v[0] - t * u[0]).hypot(v[1] - t * u[1])
    };
    to(c, a, b).min(to(d, a, b)).min(to(a, c, d)).min(to(b, c, d))
}

impl Kinematics for FiveBar {
    /// Pose of the tool with the orientation of the base, as the tool has no orientation of its
    /// own.
    fn tool_pose(&self, p: &[f64], joints: &[f64]) -> Option<Pose> {
        let assembly = joints.get(2).copied().unwrap_or(1.0);
        let [x_mm, y_mm] = FiveBar::direct(self, p, [joints[0], joints[1]], assembly).e;
        in_space(PlanarPose { x_mm, y_mm, theta_rad: 0.0 })
    }
    /// Formulas with the branch indices ζ1 and ζ2 as working modes.
    fn formulas(&self, p: &[f64]) -> Vec<Formula> {
        let p = || p.iter().map(|&v| Recorded::from(v)).collect::<Vec<_>>();
        let names = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<String>>();
        let direct = Formula::record("direct", &names(&["theta1", "theta2", "assembly"]), |v| {
            let e = FiveBar::direct(self, &p(), [v[0], v[1]], v[2]).e;
            names(&["x", "y"]).into_iter().zip(e).collect()
        });
        let inverse = Formula::record("inverse", &names(&["x", "y", "branch1", "branch2"]), |v| {
            let q = FiveBar::inverse(self, &p(), [v[0], v[1]], [v[2], v[3]]);
            names(&["theta1", "theta2"]).into_iter().zip(q).collect()
        });
        vec![direct, inverse]
    }
    fn base_in_world(&self, p: &[f64]) -> Option<Pose> {
        in_space(PlanarPose { x_mm: p[9], y_mm: p[10], theta_rad: p[11] })
    }
    /// Sines between the links of each arm (working mode), and the assembly mode.
    fn singularity_measures(&self, p: &[f64], joints: &[f64]) -> Vec<f64> {
        let assembly = joints.get(2).copied().unwrap_or(1.0);
        let Linkage { b1, b2, c, e } = FiveBar::direct(self, p, [joints[0], joints[1]], assembly);
        let half = 0.5 * p[4];
        let sine = |a: [f64; 2], b: [f64; 2]| (a[0] * b[1] - a[1] * b[0]) / (a[0].hypot(a[1]) * b[0].hypot(b[1]));
        vec![sine(from([-half, 0.0], b1), from(b1, c)), sine(from([half, 0.0], b2), from(b2, e)), assembly]
    }
    fn all_joints(&self, p: &[f64], pose: &Pose) -> Vec<Vec<f64>> {
        let Some(PlanarPose { x_mm, y_mm, .. }) = in_plane(pose) else { return Vec::new() };
        let e = off_the_motor(p, [x_mm, y_mm]);
        let way = |branches: [f64; 2]| {
            let q = FiveBar::inverse(self, p, e, branches);
            q.iter().all(|v| v.is_finite()).then(|| vec![q[0], q[1], self.assembly_at(p, q, e)])
        };
        WORKING_MODES.into_iter().filter_map(way).collect()
    }
}

impl Robot for FiveBar {
    fn definition(&self) -> &Definition {
        &self.definition
    }
    fn definition_mut(&mut self) -> &mut Definition {
        &mut self.definition
    }
    /// Drawing with half-open arms and the tool beside C, so that every parameter is visible.
    fn sketches(&self) -> Vec<Sketch> {
        use StrokeKind::{Axis, Length, Part};
        let title = meaning("sketch-five-bar");
        let mut sketch = Sketch::new(title, true);
        let mut p = self.nominal();
        (p[5], p[6]) = (1.3 * p[3], 0.5);
        let meeting = |q: [f64; 2]| [1.0, -1.0].map(|mode| self.direct(&p, q, mode)).map(|at| (q, at));
        let all = [[2.1, 1.1], [1.8, 1.3], [1.6, 1.5], [1.3, 1.8]].into_iter().flat_map(meeting);
        // C on the far side of the motors
        let mut away = all.filter(|(_, at)| at.e[0].is_finite() && at.c[1] > at.b1[1].max(at.b2[1]));
        let Some((q, at)) = away.next() else {
            return Vec::new();
        };
        let [a1, a2] = [-0.5, 0.5].map(|share| [share * p[4], 0.0, 0.0]);
        let [b1, b2, c, e] = [at.b1, at.b2, at.c, at.e].map(|[x, y]| [x, y, 0.0]);
        sketch.add(Part, "", &[a1, b1, c, b2, a2]);
        sketch.add(Part, "", &[b2, e, c]);
        for (name, ends) in [
            ("l11", [a1, b1]),
            ("l12", [b1, c]),
            ("l21", [b2, a2]),
            ("l22", [c, b2]),
            ("l23", [b2, e]),
            ("d", [a2, a1]),
        ] {
            sketch.add(Length, name, &ends);
        }
        let size = sketch.extent_mm();
        for (name, from, angle) in [("theta1 + delta1", a1, q[0] + p[7]), ("theta2 + delta2", a2, q[1] + p[8])] {
            let frame = Pose { translation_mm: from, ..Pose::identity() };
            sketch.add(Axis, "", &[from, frame.shift(0, 0.2 * size).translation_mm]);
            sketch.angle(name, &frame, 0.14 * size, angle);
        }
        let to_c = (c[1] - b2[1]).atan2(c[0] - b2[0]);
        let elbow = Pose { translation_mm: b2, ..Pose::identity() }.turn_z(to_c);
        sketch.angle("gamma", &elbow, 0.3 * size, p[6]);
        sketch.frame("base", &Pose::identity(), 0.12 * size);
        let world = Pose { translation_mm: [-p[9], -p[10], 0.0], ..Pose::identity() };
        sketch.frame("world", &world, 0.12 * size);
        sketch.add(Length, "x_o", &[world.translation_mm, [0.0, -p[10], 0.0]]);
        sketch.add(Length, "y_o", &[[0.0, -p[10], 0.0], [0.0; 3]]);
        sketch.add(Axis, "phi", &[[0.0; 3], [0.3 * size, 0.0, 0.0]]);
        vec![sketch]
    }
    fn outline(&self, p: &[f64], joints: &[f64]) -> Outline {
        let assembly = joints.get(2).copied().unwrap_or(1.0);
        let at = FiveBar::direct(self, p, [joints[0], joints[1]], assembly);
        let [a1, a2] = [-0.5, 0.5].map(|share| [share * p[4], 0.0, 0.0]);
        let [b1, b2, c, e] = [at.b1, at.b2, at.c, at.e].map(|[x, y]| [x, y, 0.0]);
        let mut outline = Outline::default();
        outline.link("base", &[a1, a2]);
        outline.link(&self.joints()[0].name, &[a1, b1]);
        outline.link(&self.joints()[1].name, &[a2, b2]);
        outline.link("distal 1", &[b1, c]);
        outline.link("distal 2", &[c, b2, e, c]);
        match self.base_in_world(p) {
            Some(base) => outline.moved(&base),
            None => Outline::default(),
        }
    }
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        WithParameters::new(parameters).positions(State { joints, loads: &[] }, out);
    }
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        WithParameters::new(parameters).jacobian(State { joints, loads: &[] }, out);
    }
    fn joint_jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        WithParameters::new(parameters).joint_jacobian(State { joints, loads: &[] }, &mut [0.0; 2], out);
    }
    fn parametrised<'a>(&'a self, parameters: &'a [f64]) -> Box<dyn Parametrised + 'a> {
        Box::new(WithParameters::new(parameters))
    }
    fn position(&self, parameters: &[f64], joints: &[f64], _target: usize) -> Vector {
        let [x, y] = WithParameters::new(parameters).tool(joints);
        [x, y, 0.0]
    }
    fn kinematics(&self) -> Option<&dyn Kinematics> {
        Some(self)
    }
    fn has_assembly_modes(&self) -> bool {
        true
    }
    fn inverse_all(&self, parameters: &[f64], position: Vector) -> Option<Vec<Vec<f64>>> {
        let e = self.to_base(parameters, [position[0], position[1]]);
        let reached = self.reached(parameters, e).into_iter();
        Some(reached.map(|c| vec![c.joints_rad[0], c.joints_rad[1], c.assembly]).collect())
    }
    fn inverse(&self, parameters: &[f64], near: &[f64], position: Vector) -> Option<Vec<f64>> {
        let e = self.to_base(parameters, [position[0], position[1]]);
        let off = |q: &[f64; 2]| q.iter().zip(near).map(|(q, n)| (q - n).wrapped().abs()).sum::<f64>();
        let ways = WORKING_MODES.map(|branches| self.inverse(parameters, e, branches));
        let whole = ways.into_iter().filter(|q| q.iter().all(|q| q.is_finite()));
        let q = whole.min_by(|a, b| off(a).total_cmp(&off(b)))?;
        Some(vec![q[0], q[1], self.assembly_at(parameters, q, e)])
    }
    fn limit_violation(&self, parameters: &[f64], joints: &[f64]) -> Option<Phrase> {
        let &[theta1, theta2, assembly] = joints else { return None };
        self.violation(parameters, [theta1, theta2], &self.direct(parameters, [theta1, theta2], assembly))
    }
    fn joint_range(&self, joint: usize) -> JointRange {
        let ends = self.limits.limits_rad.get(joint).copied();
        JointRange::from_limits(ends.filter(|ends| *ends != FiveBarLimits::default().limits_rad[0]))
    }
    fn remedy(&self, _parameters: &[usize]) -> Option<Phrase> {
        Some(phrase!("measure-all-working-modes"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::scalar::{Dual, duals};

    #[test]
    fn distances_of_segments() {
        let far = segment_distance([0.0, 0.0], [10.0, 0.0], [3.0, 4.0], [3.0, 9.0]);
        assert_eq!(far, 4.0);
        assert_eq!(segment_distance([0.0, 0.0], [10.0, 0.0], [3.0, -4.0], [3.0, 9.0]), 0.0);
        assert_eq!(segment_distance([0.0, 0.0], [10.0, 0.0], [13.0, 4.0], [20.0, 9.0]), 5.0);
    }

    /// Compares derivatives in closed form with derivatives by dual numbers, in all working and
    /// assembly modes.
    #[test]
    fn derivatives_are_those_of_dual_numbers() {
        let robot = FiveBar::default();
        let mut p = robot.nominal();
        let off = [0.3, -0.2, 0.1, 0.4, -0.5, 7.0, 0.05, -0.02, 0.03, 1.0, -2.0, 0.2];
        p.iter_mut().zip(off).for_each(|(p, off)| *p += off);
        let (mut compared, mut out) = (0, [0.0; 2 * PARAMETERS]);
        for k in 0..400 {
            let [q1, q2] = [0.17, 0.37].map(|step| (step * f64::from(k)).wrapped());
            let joints = [q1, q2, if k % 2 == 0 { 1.0 } else { -1.0 }];
            let tool = WithParameters::<Dual<PARAMETERS>>::new(&duals(&p)).tool(&joints);
            robot.jacobian(&p, &joints, &mut out);
            if !tool[0].value.is_finite() {
                continue;
            }
            for (row, dual) in out.chunks_exact(PARAMETERS).zip(tool) {
                let largest = dual.gradient.iter().fold(1.0, |most: f64, g| most.max(g.abs()));
                row.iter().zip(dual.gradient).for_each(|(a, b)| assert!((a - b).abs() < 1e-12 * largest, "{a} {b}"));
            }
            compared += 1;
        }
        assert!(compared > 100, "{compared}");
    }

    #[test]
    fn stretched_and_in_line_is_singular() {
        let robot = FiveBar::default();
        let p = robot.nominal();
        // with elbows 460 mm apart the distal links are aligned (type 2); this is 1e-4 rad inside
        let q = (92.5f64 / 230.0).acos();
        let at = robot.direct(&p, [PI - q - 1e-4, q + 1e-4], 1.0);
        assert!(robot.singularity_distance(&p, &at).type2_rad < 0.03);
        // arm 2 aligned with the tool (type 1)
        let at = Linkage { e: [137.5 + 2.0 * (at.b2[0] - 137.5), 2.0 * at.b2[1]], ..at };
        assert!(robot.singularity_distance(&p, &at).type1_rad[1] < 1e-12);
    }
}
