//! The five-bar: two arms A1 B1 C and A2 B2 C in the plane, the tool E fixed to the link B2 C (thesis, chapter 4).
//!
//! Twelve parameters (section 4.3). Joint values are the two encoder angles and, behind them, the assembly mode.

use super::{Definition, Joint, Parameter, Quantity, Reach, Robot, Role};
use crate::base::pose::Vector;
use crate::base::scalar::{Dual, Scalar, duals};

const PARAMETERS: usize = 12;
/// Names, quantities, roles and nominal values (eq. 4.24; x_o and y_o: table 4.1).
const TABLE: [(&str, Quantity, Role, f64); PARAMETERS] = [
    ("l11", Quantity::Length, Role::Robot, 230.0),
    ("l12", Quantity::Length, Role::Robot, 230.0),
    ("l21", Quantity::Length, Role::Robot, 230.0),
    ("l22", Quantity::Length, Role::Robot, 230.0),
    ("d", Quantity::Length, Role::Robot, 275.0),
    ("l23", Quantity::Length, Role::Robot, 230.0),
    ("gamma", Quantity::Angle, Role::Robot, 0.0),
    ("delta1", Quantity::Angle, Role::Robot, 0.0),
    ("delta2", Quantity::Angle, Role::Robot, 0.0),
    ("x_o", Quantity::Length, Role::Base, 263.0),
    ("y_o", Quantity::Length, Role::Base, 75.0),
    ("phi", Quantity::Angle, Role::Base, 0.0),
];

/// Branch indices ζ1, ζ2 of the four working modes.
pub const WORKING_MODES: [[f64; 2]; 4] = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];

/// The five-bar with its nominal parameters and what it reaches.
#[derive(Clone, Debug)]
pub struct FiveBar {
    definition: Definition,
    pub(super) reach: Reach,
}

/// Joints of the mechanism in the base frame (mm).
#[derive(Clone, Copy, Debug)]
pub struct Linkage<T = f64> {
    /// Elbow of arm 1.
    pub b1: [T; 2],
    /// Elbow of arm 2.
    pub b2: [T; 2],
    /// Where the arms meet.
    pub c: [T; 2],
    /// The tool.
    pub e: [T; 2],
}

impl Default for FiveBar {
    fn default() -> Self {
        let parameters = TABLE.map(|(name, quantity, role, nominal)| Parameter::new(name, quantity, role, nominal));
        let joints = ["theta1", "theta2"].map(|name| Joint { name: name.into(), quantity: Quantity::Angle });
        let definition =
            Definition { parameters: parameters.into(), joints: joints.into(), targets: vec!["tool".into()] };
        Self { definition, reach: Reach::default() }
    }
}

impl FiveBar {
    /// The same robot with other nominal values.
    pub fn with_nominal(mut self, values: &[f64]) -> Self {
        self.definition = self.definition.with_nominal(values);
        self
    }

    /// The same robot with other limits.
    pub fn with_reach(mut self, reach: Reach) -> Self {
        self.reach = reach;
        self
    }

    /// Direct kinematics in the base frame for encoder angles (rad) and the assembly mode ξ, +1 or −1; not a number where
    /// the arms do not meet (eq. 4.1 to 4.7, θ = encoder + δ).
    pub fn direct<T: Scalar>(&self, p: &[T], q: [T; 2], assembly: f64) -> Linkage<T> {
        let [l11, l12, l21, l22, d, l23, gamma, delta1, delta2] = [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|i| p[i]);
        let (sin1, cos1) = (q[0] + delta1).sin_cos();
        let (sin2, cos2) = (q[1] + delta2).sin_cos();
        let b1 = [l11 * cos1 - d * 0.5, l11 * sin1]; // eq. 4.4
        let b2 = [l21 * cos2 + d * 0.5, l21 * sin2]; // eq. 4.2
        let between = minus(b2, b1); // eq. 4.7
        let c = plus(b1, meet(between, l12, l22, assembly)); // eq. 4.3, 4.5, 4.6
        let e = plus(b2, turn(minus(c, b2), gamma, l23 / l22)); // eq. 4.1
        Linkage { b1, b2, c, e }
    }

    /// Inverse kinematics: encoder angles (rad) that bring the tool to `e` (base frame) with the branch indices ζ1, ζ2; not
    /// a number where an arm does not reach (eq. 4.8 to 4.19).
    pub fn inverse<T: Scalar>(&self, p: &[T], e: [T; 2], branches: [f64; 2]) -> [T; 2] {
        let [l11, l12, l21, l22, d, l23, gamma, delta1, delta2] = [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|i| p[i]);
        let half = d * 0.5;
        // the thesis' branch turns clockwise, the assembly mode counterclockwise
        let a2_b2 = meet([e[0] - half, e[1]], l21, l23, -branches[1]); // eq. 4.15 to 4.18
        let b2 = [a2_b2[0] + half, a2_b2[1]]; // eq. 4.14
        let c = plus(b2, turn(minus(e, b2), -gamma, l22 / l23)); // eq. 4.13
        let a1_b1 = meet([c[0] + half, c[1]], l11, l12, -branches[0]); // eq. 4.9 to 4.12
        let angle = |v: [T; 2], delta: T| wrap(v[1].atan2(v[0]) - delta); // eq. 4.8, 4.19
        [angle(a1_b1, delta1), angle(a2_b2, delta2)]
    }

    /// A point of the base frame in the world (eq. 4.21).
    pub fn to_world<T: Scalar>(&self, p: &[T], point: [T; 2]) -> [T; 2] {
        plus([p[9], p[10]], turn(point, p[11], T::from(1.0)))
    }

    /// A point of the world in the base frame.
    pub fn to_base<T: Scalar>(&self, p: &[T], point: [T; 2]) -> [T; 2] {
        turn(minus(point, [p[9], p[10]]), -p[11], T::from(1.0))
    }

    /// The assembly mode ξ in which encoder angles `q` bring the tool to `e` of the base frame: the nearer one.
    pub fn assembly_at(&self, p: &[f64], q: [f64; 2], e: [f64; 2]) -> f64 {
        let off = |assembly: f64| {
            let reached = self.direct(p, q, assembly).e;
            (reached[0] - e[0]).hypot(reached[1] - e[1])
        };
        if off(-1.0) < off(1.0) { -1.0 } else { 1.0 }
    }

    fn tool<T: Scalar>(&self, p: &[T], joints: &[f64]) -> [T; 2] {
        let assembly = joints.get(2).copied().unwrap_or(1.0);
        self.to_world(p, self.direct(p, [T::from(joints[0]), T::from(joints[1])], assembly).e)
    }
}

fn plus<T: Scalar>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn minus<T: Scalar>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// `v` turned counterclockwise and stretched.
fn turn<T: Scalar>(v: [T; 2], angle: T, stretch: T) -> [T; 2] {
    let (sin, cos) = angle.sin_cos();
    [stretch * (cos * v[0] - sin * v[1]), stretch * (sin * v[0] + cos * v[1])]
}

/// From one end of `base`, where two links of lengths `near` and `far` from its two ends meet: on its left for `side` = +1.
fn meet<T: Scalar>(base: [T; 2], near: T, far: T, side: f64) -> [T; 2] {
    let square = base[0] * base[0] + base[1] * base[1];
    let along = (near * near - far * far + square) / (square * 2.0); // eq. 4.5: b1 / d
    let across = (near * near / square - along * along).sqrt() * side; // eq. 4.5: ξ h / d
    [along * base[0] - across * base[1], along * base[1] + across * base[0]]
}

/// An angle brought to (−π, π], derivative kept.
fn wrap<T: Scalar>(angle: T) -> T {
    angle + (-(angle.value() / std::f64::consts::TAU).round() * std::f64::consts::TAU)
}

impl Robot for FiveBar {
    fn model(&self) -> &'static str {
        "five_bar"
    }
    fn definition(&self) -> &Definition {
        &self.definition
    }
    fn dimension(&self) -> usize {
        2
    }
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&self.tool(parameters, joints));
    }
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let tool = self.tool::<Dual<PARAMETERS>>(&duals(parameters), joints);
        for (row, value) in out.chunks_exact_mut(PARAMETERS).zip(tool) {
            row.copy_from_slice(&value.gradient);
        }
    }
    fn has_assembly_modes(&self) -> bool {
        true
    }
    fn configurations(&self, parameters: &[f64], position: Vector) -> Vec<Vec<f64>> {
        let e = self.to_base(parameters, [position[0], position[1]]);
        let reached = self.reached(parameters, e).into_iter();
        reached.map(|c| vec![c.joints_rad[0], c.joints_rad[1], c.assembly]).collect()
    }
    fn reach(&self, parameters: &[f64], near: &[f64], position: Vector) -> Option<Vec<f64>> {
        let e = self.to_base(parameters, [position[0], position[1]]);
        let off = |q: &[f64; 2]| q.iter().zip(near).map(|(q, n)| wrap(q - n).abs()).sum::<f64>();
        let ways = WORKING_MODES.map(|branches| self.inverse(parameters, e, branches));
        let whole = ways.into_iter().filter(|q| q.iter().all(|q| q.is_finite()));
        let q = whole.min_by(|a, b| off(a).total_cmp(&off(b)))?;
        Some(vec![q[0], q[1], self.assembly_at(parameters, q, e)])
    }
    fn beyond(&self, parameters: &[f64], joints: &[f64]) -> Option<String> {
        let &[theta1, theta2, assembly] = joints else { return None };
        self.forbidden(parameters, [theta1, theta2], &self.direct(parameters, [theta1, theta2], assembly))
    }
    fn remedy(&self, _names: &[&str]) -> Option<&'static str> {
        Some("measure every position in all working modes that reach it, and positions all around the workspace")
    }
}
