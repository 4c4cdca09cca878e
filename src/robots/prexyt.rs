//! PreXYT: a planar parallel table with three actuators (thesis, chapter 3).
//!
//! The model has thirteen parameters after the reduction of section 3.4, or fifteen before it, with
//! `delta1`, `alpha`, `h` and `d1` as separate parameters. An additional parameter `l_kl`, the
//! distance of the balls K and L, is needed for residuals of single balls.

use super::keys::{Description, Reader};
use super::{
    Definition, Faults, Joint, JointRange, Key, Kinematics, Model, Outline, Parameter, PlanarPose, Platform, Quantity,
    RailTable, Robot, Role,
};
use super::{REACH, in_plane, in_space, meaning};
use etalon_base::catalogue::Phrase;
use etalon_base::expression::{Formula, Recorded};
use etalon_base::phrase;
use etalon_base::pose::Pose;
use etalon_base::scalar::{Dual, Scalar, constants, duals};
use etalon_base::sketch::{Sketch, StrokeKind};
use std::f64::consts::FRAC_PI_2;

const PARAMETERS: usize = 16;
/// Names, quantities, roles, nominal values and meanings (thesis, table 3.3; l_kl is twice the
/// nominal x_C).
const COMMON: [(&str, Quantity, Role, f64, &str); 14] = [
    ("beta", Quantity::Angle, Role::Robot, 0.0, meaning("meaning-rail-3-angle")),
    ("gamma", Quantity::Angle, Role::Robot, 0.0, meaning("meaning-guide-angle")),
    ("epsilon_theta", Quantity::Angle, Role::Target, 0.0, meaning("meaning-ball-line-angle")),
    ("s", Quantity::Length, Role::Robot, 394.0, meaning("meaning-rail-3-distance")),
    ("d3", Quantity::Length, Role::Robot, 0.0, meaning("meaning-carriage-3-place")),
    ("d", Quantity::Length, Role::Robot, 116.0, meaning("meaning-carriage-1-place")),
    ("x_c", Quantity::Length, Role::Target, 73.0, meaning("meaning-centre-along-balls")),
    ("y_c", Quantity::Length, Role::Target, -73.0, meaning("meaning-centre-across-balls")),
    ("x_o", Quantity::Length, Role::Base, 22.5, meaning("meaning-base-origin-x")),
    ("y_o", Quantity::Length, Role::Base, -30.5, meaning("meaning-base-origin-y")),
    ("delta", Quantity::Ratio, Role::Robot, 1.0, meaning("meaning-carriage-1-travel")),
    ("delta2", Quantity::Ratio, Role::Robot, 1.0, meaning("meaning-carriage-2-travel")),
    ("delta3", Quantity::Ratio, Role::Robot, 1.0, meaning("meaning-carriage-3-travel")),
    ("l_kl", Quantity::Length, Role::Target, 146.0, meaning("meaning-ball-distance")),
];

/// Thirteen parameters.
pub(super) const REDUCED: Model = Model::new::<Table<false>>("prexyt");
/// Fifteen parameters.
pub(super) const FULL: Model = Model::new::<Table<true>>("prexyt_full");

/// Description of a PreXYT: travel of each actuator from zero (mm). `FULL` selects the model before
/// the reduction of section 3.4.
struct Table<const FULL: bool>(Option<[f64; 3]>);

/// Reads the travel of each actuator from zero (mm).
pub(super) fn travel_mm(keys: &mut Reader) -> Option<[f64; 3]> {
    keys.table(Key::plain("reach", REACH), |keys| {
        keys.optional(Key::length("travel", "Travel of each actuator from zero."))
    })
}

impl<const FULL: bool> Description for Table<FULL> {
    const STATES_GEOMETRY: bool = false;
    const HAS_PLATFORM: bool = true;

    fn read(keys: &mut Reader) -> Self {
        Self(travel_mm(keys))
    }

    fn build(&self, _targets: &[String]) -> Result<Box<dyn Robot>, Faults> {
        Ok(Box::new(Prexyt::new(FULL).with_travel(self.0)))
    }
}

/// The PreXYT with its nominal parameters.
///
/// # Examples
///
/// ```
/// use etalon_robots::{Prexyt, Robot};
/// use std::f64::consts::FRAC_PI_4;
///
/// let robot = Prexyt::default();
/// let nominal = robot.nominal();
///
/// // rails 2 and 3 are 394 mm apart: carriages that differ by 394 mm turn the platform by 45°
/// let pose = robot.direct(&nominal, &[100.0, 50.0, 444.0]);
/// assert!((pose.theta_rad - FRAC_PI_4).abs() < 1e-12);
///
/// // carriage 1 stands at x = 116 mm when its actuator is at zero; y = 50 mm + x tan 45°
/// assert!((pose.x_mm - 216.0).abs() < 1e-9);
/// assert!((pose.y_mm - 266.0).abs() < 1e-9);
/// ```
#[derive(Clone, Debug)]
pub struct Prexyt {
    definition: Definition,
    full: bool,
    travel_mm: Option<[f64; 3]>,
}

impl Default for Prexyt {
    fn default() -> Self {
        Self::new(false)
    }
}

impl Prexyt {
    /// Creates the model of thirteen parameters or, if `full`, the model before the reduction of
    /// section 3.4.
    pub fn new(full: bool) -> Self {
        let mut parameters: Vec<Parameter> = COMMON
            .iter()
            .map(|&(name, quantity, role, nominal, meaning)| {
                Parameter::new(name, quantity, role, nominal).meaning(meaning)
            })
            .collect();
        (parameters[8].axis, parameters[9].axis) = (Some(0), Some(1));
        if full {
            parameters[5].name = "d1".into();
            parameters[10].name = "delta1".into();
            let alpha = Parameter::new("alpha", Quantity::Angle, Role::Robot, 0.0);
            parameters.push(alpha.meaning(meaning("meaning-rail-1-angle")));
            let h = Parameter::new("h", Quantity::Length, Role::Robot, 0.0);
            parameters.push(h.meaning(meaning("meaning-rail-1-distance")));
        }
        let joints = ["rho1", "rho2", "rho3"].map(|name| Joint { name: name.into(), quantity: Quantity::Length });
        let targets = vec!["K".into(), "L".into()];
        let model = if full { "prexyt_full" } else { "prexyt" };
        let definition = Definition { model, dimension: 2, parameters, joints: joints.into(), targets };
        Self { definition, full, travel_mm: None }
    }

    /// Sets the travel of the actuators from zero.
    #[must_use]
    pub fn with_travel(self, travel_mm: Option<[f64; 3]>) -> Self {
        Self { travel_mm, ..self }
    }

    /// Values of delta and d of the reduced model (thesis, section 3.4, below eq. 3.10).
    fn reduced<T: Scalar>(&self, p: &[T]) -> (T, T) {
        if !self.full {
            return (p[10], p[5]);
        }
        let (gamma, d1, delta1, alpha, h) = (p[1], p[5], p[10], p[14], p[15]);
        let one = T::from(1.0);
        let delta = delta1 * alpha.sin_cos().1 * (one - alpha.tan() * gamma.tan());
        (delta, d1 - h * gamma.tan())
    }

    /// Direct kinematics: pose of the platform in the base frame (thesis, eq. 3.8, 3.11, 3.10).
    pub fn direct<T: Scalar>(&self, p: &[T], rho: &[T]) -> PlanarPose<T> {
        let (gamma, delta2) = (p[1], p[11]);
        let (delta, d) = self.reduced(p);
        let [[_, y2], [run, y3]] = self.revolutes(p, rho);
        let rise = y3 - y2;
        let theta = rise.atan2(run); // eq. 3.8
        let (tan_theta, tan_gamma) = (rise / run, gamma.tan());
        let one = T::from(1.0);
        let x = (rho[0] * delta + d + delta2 * rho[1] * tan_gamma) / (one - tan_gamma * tan_theta); // eq. 3.11
        let y = delta2 * rho[1] + x * tan_theta; // eq. 3.10
        PlanarPose { x_mm: x, y_mm: y, theta_rad: theta }
    }

    /// Pose of the platform, and its derivatives with respect to each parameter: [`Self::direct`]
    /// differentiated in closed form.
    fn pose_derivatives(&self, p: &[f64], rho: &[f64]) -> (PlanarPose, [[f64; 3]; PARAMETERS]) {
        let pose = self.direct(p, rho);
        let [[_, y2], [run, y3]] = self.revolutes(p, rho);
        let (sin_beta, cos_beta) = p[0].sin_cos();
        let (tan_beta, tan_gamma, tan_theta) = (p[0].tan(), p[1].tan(), (y3 - y2) / run);
        let reach3 = p[12] * rho[2];
        let by_gamma = 1.0 + tan_gamma * tan_gamma;
        let none = Change::default();
        let mut changes = [none; PARAMETERS];
        changes[0] =
            Change { run: -reach3 * cos_beta - p[4] * (1.0 + tan_beta * tan_beta), y3: -reach3 * sin_beta, ..none };
        changes[1] = Change { tan_gamma: by_gamma, ..none };
        changes[3] = Change { run: 1.0, ..none };
        changes[4] = Change { run: -tan_beta, y3: 1.0, ..none };
        changes[5] = Change { along: 1.0, ..none };
        changes[10] = Change { along: rho[0], ..none };
        changes[11] = Change { y2: rho[1], ..none };
        changes[12] = Change { run: -rho[2] * sin_beta, y3: rho[2] * cos_beta, ..none };
        if self.full {
            // delta = delta1 (cos alpha - sin alpha tan gamma), d = d1 - h tan gamma
            let ((sin, cos), travel, h) = (p[14].sin_cos(), p[10] * rho[0], p[15]);
            changes[1].along = -(travel * sin + h) * by_gamma;
            changes[10].along = rho[0] * (cos - sin * tan_gamma);
            changes[14].along = -travel * (sin + cos * tan_gamma);
            changes[15].along = -tan_gamma;
        }
        let derivatives = changes.map(|change| {
            let by_tan_theta = (change.y3 - change.y2 - tan_theta * change.run) / run;
            let turned = tan_gamma * by_tan_theta + tan_theta * change.tan_gamma;
            let along = change.along + tan_gamma * change.y2 + y2 * change.tan_gamma;
            let x = (along + pose.x_mm * turned) / (1.0 - tan_gamma * tan_theta); // eq. 3.11
            let y = change.y2 + pose.x_mm * by_tan_theta + tan_theta * x; // eq. 3.10
            [x, y, by_tan_theta / (1.0 + tan_theta * tan_theta)]
        });
        (pose, derivatives)
    }

    /// Axes of revolute joints 2 and 3 in the base frame; theta is the direction from joint 2 to
    /// joint 3 (thesis, eq. 3.8).
    fn revolutes<T: Scalar>(&self, p: &[T], rho: &[T]) -> [[T; 2]; 2] {
        let [beta, s, d3] = [p[0], p[3], p[4]];
        let (sin_beta, cos_beta) = beta.sin_cos();
        let reach3 = p[12] * rho[2];
        let second = [T::from(0.0), p[11] * rho[1]];
        [second, [s - reach3 * sin_beta - d3 * beta.tan(), reach3 * cos_beta + d3]]
    }

    /// Inverse kinematics: actuator values for a pose of the platform in the base frame (thesis,
    /// eq. 3.12 to 3.14).
    pub fn inverse<T: Scalar>(&self, p: &[T], pose: PlanarPose<T>) -> [T; 3] {
        let [beta, gamma, _, s, d3] = [p[0], p[1], p[2], p[3], p[4]];
        let (delta, d) = self.reduced(p);
        let PlanarPose { x_mm: x, y_mm: y, theta_rad } = pose;
        let t = theta_rad.tan();
        let (sin_beta, cos_beta) = beta.sin_cos();
        let rho2 = (y - x * t) / p[11]; // eq. 3.12
        let rho3 = (t * (s - d3 * beta.tan() - x) + y - d3) / (p[12] * (cos_beta + sin_beta * t)); // eq. 3.13
        let rho1 = (x - d - y * gamma.tan()) / delta; // eq. 3.14
        [rho1, rho2, rho3]
    }

    /// Positions of the balls K and L in the world: thesis, eq. 3.17 and 3.19 solved for K, and L
    /// at the distance `l_kl`.
    pub fn balls<T: Scalar>(&self, p: &[T], rho: &[T]) -> [[T; 2]; 2] {
        let pose = self.direct(p, rho);
        let (sin, cos) = (pose.theta_rad + p[2]).sin_cos();
        let (x_c, y_c, x_o, y_o, l_kl) = (p[6], p[7], p[8], p[9], p[13]);
        let k = [pose.x_mm + x_o - (x_c * cos - y_c * sin), pose.y_mm + y_o - (x_c * sin + y_c * cos)];
        [k, [k[0] + l_kl * cos, k[1] + l_kl * sin]]
    }

    /// Pose of the platform in the base frame, as measured by the balls K and L (thesis, eq. 3.17
    /// to 3.19).
    pub fn measured<T: Scalar>(&self, p: &[T], k: [T; 2], l: [T; 2]) -> PlanarPose<T> {
        let (dx, dy) = (l[0] - k[0], l[1] - k[1]);
        let length = (dx * dx + dy * dy).sqrt();
        let (cos, sin) = (dx / length, dy / length);
        let (x_c, y_c, x_o, y_o) = (p[6], p[7], p[8], p[9]);
        PlanarPose {
            x_mm: k[0] + x_c * cos - y_c * sin - x_o,
            y_mm: k[1] + x_c * sin + y_c * cos - y_o,
            theta_rad: dy.atan2(dx) - p[2],
        }
    }

    /// Estimated minus measured pose: summands of eq. 3.26 of the thesis (mm, mm, rad).
    pub fn pose_residual<T: Scalar>(&self, p: &[T], rho: &[T], k: [T; 2], l: [T; 2]) -> [T; 3] {
        let (estimated, measured) = (self.direct(p, rho), self.measured(p, k, l));
        [
            estimated.x_mm - measured.x_mm,
            estimated.y_mm - measured.y_mm,
            (estimated.theta_rad - measured.theta_rad).wrapped(),
        ]
    }
}

/// Derivatives by one parameter of the quantities from which the pose follows.
#[derive(Clone, Copy, Default)]
struct Change {
    /// Revolute joint 2 along y, and revolute joint 3 along x and y.
    y2: f64,
    run: f64,
    y3: f64,
    /// Carriage 1 along x.
    along: f64,
    tan_gamma: f64,
}

impl Robot for Prexyt {
    fn definition(&self) -> &Definition {
        &self.definition
    }
    fn definition_mut(&mut self) -> &mut Definition {
        &mut self.definition
    }
    /// Drawing with exaggerated tilts.
    fn sketches(&self) -> Vec<Sketch> {
        use StrokeKind::{Axis, Length, Part};
        let title = meaning("sketch-table");
        let mut sketch = Sketch::new(title, true);
        let mut p = self.nominal();
        (p[0], p[1], p[2]) = (0.14, 0.16, 0.3);
        let s = p[3];
        p[4] = 0.12 * s;
        let rho = [0.25 * s, 0.3 * s, 0.5 * s];
        let pose = self.direct(&p, &rho);
        let [[x2, y2], [x3, y3]] = self.revolutes(&p, &rho);
        let (second, third, c) = ([x2, y2, 0.0], [x3, y3, 0.0], [pose.x_mm, pose.y_mm, 0.0]);
        let frame = Pose::identity();
        let on_rail = |along: f64| [s - along * p[0].sin() - p[4] * p[0].tan(), along * p[0].cos() + p[4], 0.0];
        let guide = |y: f64| [c[0] + (y - c[1]) * p[1].tan(), y, 0.0];
        sketch.add(Part, "rho2", &[[0.0, -0.1 * s, 0.0], [0.0, 0.8 * s, 0.0]]);
        sketch.add(Part, "rho3", &[on_rail(-0.1 * s), on_rail(0.8 * s)]);
        sketch.add(Part, "rho1", &[[0.1 * s, 0.0, 0.0], [0.85 * s, 0.0, 0.0]]);
        sketch.add(Part, "", &[second, third]);
        sketch.add(Part, "", &[guide(0.0), guide(0.8 * s)]);
        sketch.add(Length, "s", &[[0.0; 3], [s, 0.0, 0.0]]);
        sketch.add(Length, "d3", &[[s, 0.0, 0.0], [s, p[4], 0.0]]);
        sketch.add(Length, if self.full { "d1" } else { "d" }, &[[p[5], 0.0, 0.0], [0.0; 3]]);
        sketch.add(Axis, "", &[[p[5], -0.06 * s, 0.0], [p[5], 0.06 * s, 0.0]]);
        let up = |at: [f64; 3]| Pose { translation_mm: at, ..Pose::identity() }.turn_z(FRAC_PI_2);
        for (name, from, angle) in [("beta", on_rail(0.0), p[0]), ("gamma", guide(0.0), -p[1])] {
            sketch.add(Axis, "", &[from, up(from).shift(0, 0.72 * s).translation_mm]);
            sketch.angle(name, &up(from), 0.66 * s, angle);
        }
        let platform = Pose { translation_mm: c, ..frame }.turn_z(pose.theta_rad);
        let balls = platform.turn_z(p[2]);
        let [k, l] = [0.0, p[13]].map(|along| balls.apply([along - p[6], -p[7], 0.0]));
        let foot = balls.apply([0.0, -p[7], 0.0]);
        sketch.add(Part, "", &[c, k, l, c]);
        sketch.add(Length, "l_kl", &[l, k]);
        sketch.add(Length, "x_c", &[k, foot]);
        sketch.add(Length, "y_c", &[foot, c]);
        sketch.angle("epsilon_theta", &platform, 0.3 * s, p[2]);
        let world = Pose { translation_mm: [-0.22 * s, -0.2 * s, 0.0], ..frame };
        sketch.frame("world", &world, 0.1 * s);
        sketch.frame("base", &frame, 0.1 * s);
        sketch.add(Length, "x_o", &[world.translation_mm, [0.0, -0.2 * s, 0.0]]);
        sketch.add(Length, "y_o", &[[0.0, -0.2 * s, 0.0], [0.0; 3]]);
        vec![sketch]
    }
    /// Rails are drawn to the largest travel, without a given travel to the carriages.
    fn outline(&self, p: &[f64], joints: &[f64]) -> Outline {
        let pose = self.direct(p, joints);
        let [[x2, y2], [x3, y3]] = self.revolutes(p, joints);
        let c = [pose.x_mm, pose.y_mm, 0.0];
        let travel = |i: usize| self.travel_mm.map_or(0.0, |travel| travel[i]).max(1.1 * joints[i]).max(0.5 * p[3]);
        let on_third = |along: f64| [p[3] - along * p[0].sin() - p[4] * p[0].tan(), along * p[0].cos() + p[4], 0.0];
        let guide = |y: f64| [c[0] + (y - c[1]) * p[1].tan(), y, 0.0];
        let mut outline = Outline::default();
        outline.link("base", &[[0.0; 3], [p[3].max(1.1 * guide(0.0)[0]), 0.0, 0.0]]);
        outline.link("base", &[[0.0; 3], [0.0, travel(1), 0.0]]);
        outline.link("base", &[on_third(0.0), on_third(travel(2))]);
        outline.link("rho1", &[guide(0.0), guide(1.1 * c[1].max(travel(1)))]);
        outline.link("platform", &[[x2, y2, 0.0], [x3, y3, 0.0]]);
        let base = Pose { translation_mm: [p[8], p[9], 0.0], ..Pose::identity() };
        let mut outline = outline.moved(&base);
        let [k, l] = self.balls(p, joints).map(|[x, y]| [x, y, 0.0]);
        let c = base.apply(c);
        outline.link("platform", &[c, k, l, c]);
        outline
    }
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        out.copy_from_slice(self.balls(parameters, joints).as_flattened());
    }
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let (pose, by_parameter) = self.pose_derivatives(parameters, joints);
        let (sin, cos) = (pose.theta_rad + parameters[2]).sin_cos();
        let (x_c, y_c, l_kl) = (parameters[6], parameters[7], parameters[13]);
        let (k_turned, l_turned) = ([x_c * sin + y_c * cos, y_c * sin - x_c * cos], [-l_kl * sin, l_kl * cos]);
        let n = parameters.len();
        for (i, [x, y, theta]) in by_parameter.into_iter().enumerate().take(n) {
            let turn = if i == 2 { 1.0 } else { theta };
            let own = match i {
                6 => [-cos, -sin],
                7 => [sin, -cos],
                8 => [1.0, 0.0],
                9 => [0.0, 1.0],
                _ => [0.0; 2],
            };
            let stretch = if i == 13 { [cos, sin] } else { [0.0; 2] };
            for axis in 0..2 {
                let k = [x, y][axis] + own[axis] + k_turned[axis] * turn;
                out[axis * n + i] = k;
                out[(2 + axis) * n + i] = k + stretch[axis] + l_turned[axis] * turn;
            }
        }
    }
    fn joint_jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let balls = self.balls(&constants(parameters), &duals::<3>(joints));
        for (row, value) in out.chunks_exact_mut(3).zip(balls.as_flattened()) {
            row.copy_from_slice(&value.gradient);
        }
    }
    fn limit_violation(&self, _parameters: &[f64], joints: &[f64]) -> Option<Phrase> {
        let ends = self.travel_mm?;
        let off = |(_, (rho, end)): &(usize, (&f64, f64))| !(0.0..=*end).contains(*rho);
        let (i, (rho, end)) = joints.iter().zip(ends).enumerate().find(off)?;
        Some(phrase!("actuator-beyond-travel", actuator = format!("rho{}", i + 1), rho = *rho, end))
    }
    fn joint_range(&self, joint: usize) -> JointRange {
        JointRange::from_limits(self.travel_mm.and_then(|ends| Some([0.0, *ends.get(joint)?])))
    }
    fn nominal_gain(&self, joint: usize) -> f64 {
        // delta, delta2 and delta3 are the gains of the three joints
        let mut gains = self.parameters().iter().filter(|p| p.quantity == Quantity::Ratio);
        gains.nth(joint).map_or(1.0, |p| p.nominal)
    }
    fn platform(&self) -> Option<&dyn Platform> {
        Some(self)
    }
    fn kinematics(&self) -> Option<&dyn Kinematics> {
        Some(self)
    }
    fn rail_table(&self) -> Option<&dyn RailTable> {
        Some(self)
    }
    fn remedy(&self, parameters: &[usize]) -> Option<Phrase> {
        // d (or d1) and x_c act along x and x′: only different |theta| separate them
        (parameters.contains(&6) && parameters.contains(&5)).then(|| phrase!("measure-different-angles"))
    }
}

impl Kinematics for Prexyt {
    fn tool_pose(&self, p: &[f64], joints: &[f64]) -> Option<Pose> {
        in_space(self.direct(p, joints))
    }
    fn formulas(&self, p: &[f64]) -> Vec<Formula> {
        let p = || p.iter().map(|&v| Recorded::from(v)).collect::<Vec<_>>();
        let names = |names: [&str; 3]| names.map(str::to_owned);
        let (rho, pose) = (names(["rho1", "rho2", "rho3"]), names(["x", "y", "theta"]));
        let direct = Formula::record("direct", &rho, |v| {
            let at = self.direct(&p(), v);
            pose.clone().into_iter().zip([at.x_mm, at.y_mm, at.theta_rad]).collect()
        });
        let inverse = Formula::record("inverse", &pose, |v| {
            let pose = PlanarPose { x_mm: v[0], y_mm: v[1], theta_rad: v[2] };
            rho.clone().into_iter().zip(self.inverse(&p(), pose)).collect()
        });
        vec![direct, inverse]
    }
    fn base_in_world(&self, p: &[f64]) -> Option<Pose> {
        in_space(PlanarPose { x_mm: p[8], y_mm: p[9], theta_rad: 0.0 })
    }
    fn all_joints(&self, p: &[f64], pose: &Pose) -> Vec<Vec<f64>> {
        // tan θ has period π: the platform rotates by less than a right angle (eq. 3.8)
        let pose = in_plane(pose).filter(|pose| pose.theta_rad.abs() < FRAC_PI_2);
        let joints = pose.map(|pose| self.inverse(p, pose).to_vec());
        joints.filter(|q| q.iter().all(|v| v.is_finite())).into_iter().collect()
    }
}

impl Platform for Prexyt {
    fn pose(&self, p: &[f64], joints: &[f64]) -> PlanarPose {
        self.direct(p, joints)
    }
    fn joints_at(&self, p: &[f64], pose: PlanarPose) -> Vec<f64> {
        self.inverse(p, pose).to_vec()
    }
    fn in_base(&self, p: &[f64], [x, y]: [f64; 2]) -> [f64; 2] {
        [x - p[8], y - p[9]]
    }
    fn measured_pose(&self, p: &[f64], [k, l]: [[f64; 2]; 2]) -> PlanarPose {
        self.measured(p, k, l)
    }
    fn pose_error(&self, p: &[f64], joints: &[f64], [k, l]: [[f64; 2]; 2]) -> [f64; 3] {
        self.pose_residual(p, joints, k, l)
    }
    fn pose_error_jacobian(&self, p: &[f64], joints: &[f64], [k, l]: [[f64; 2]; 2]) -> Vec<f64> {
        let (_, mut by_parameter) = self.pose_derivatives(p, joints);
        // what the balls measure depends on their places, the base and epsilon_theta
        let length = (l[0] - k[0]).hypot(l[1] - k[1]);
        let (cos, sin) = ((l[0] - k[0]) / length, (l[1] - k[1]) / length);
        by_parameter[2] = [0.0, 0.0, 1.0];
        by_parameter[6..10].copy_from_slice(&[[-cos, -sin, 0.0], [sin, -cos, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        (0..3).flat_map(|row| by_parameter[..p.len()].iter().map(move |by| by[row])).collect()
    }
    fn pose_error_by_targets(&self, p: &[f64], [k, l]: [[f64; 2]; 2]) -> [[f64; 4]; 3] {
        let balls: [Dual<4>; 4] = std::array::from_fn(|i| Dual::variable([k[0], k[1], l[0], l[1]][i], i));
        let measured = self.measured(&constants(p), [balls[0], balls[1]], [balls[2], balls[3]]);
        [measured.x_mm, measured.y_mm, measured.theta_rad].map(|measured| (-measured).gradient)
    }
    fn target_distance(&self) -> usize {
        13
    }
}

impl RailTable for Prexyt {
    fn travel_mm(&self) -> Option<[f64; 3]> {
        self.travel_mm
    }
    fn pivots(&self, p: &[f64], rho: &[f64; 3]) -> [[f64; 2]; 2] {
        self.revolutes(p, rho).map(|[x, y]| [x + p[8], y + p[9]])
    }
    fn centre(&self, p: &[f64], rho: &[f64; 3]) -> [f64; 2] {
        let pose = self.direct(p, rho);
        [pose.x_mm + p[8], pose.y_mm + p[9]]
    }
    // eq. 3.7; without alpha, actuator 1 travels delta along x, as seen at C
    fn travel(&self, p: &[f64], actuator: usize) -> [f64; 2] {
        match actuator {
            1 => {
                let (sin, cos) = p.get(14).filter(|_| self.full).map_or((0.0, 1.0), |alpha| alpha.sin_cos());
                [p[10] * cos, p[10] * sin]
            }
            2 => [0.0, p[11]],
            _ => [-p[12] * p[0].sin(), p[12] * p[0].cos()],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares derivatives in closed form with derivatives by dual numbers.
    #[test]
    fn derivatives_are_those_of_dual_numbers() {
        for full in [false, true] {
            let robot = Prexyt::new(full);
            let mut p = robot.nominal();
            p.iter_mut().enumerate().for_each(|(i, p)| *p += 0.02 * (1.0 + i as f64).sin());
            let n = p.len();
            for rho in [[0.0, 10.0, 44.0], [85.0, 150.0, 170.0], [170.0, 300.0, 255.0], [20.0, 40.0, 430.0]] {
                let near = |found: &[f64], duals: &[Dual<PARAMETERS>]| {
                    let expected = duals.iter().flat_map(|dual| &dual.gradient[..n]);
                    found
                        .iter()
                        .zip(expected)
                        .for_each(|(a, b)| assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "{a} {b}"));
                };
                let mut balls = vec![0.0; 4 * n];
                robot.jacobian(&p, &rho, &mut balls);
                near(&balls, robot.balls(&duals(&p), &constants(&rho)).as_flattened());
                let (k, l) = ([150.0, 130.0], [290.0, 160.0]);
                let [at_k, at_l] = [k, l].map(|ball| ball.map(Dual::from));
                let duals = robot.pose_residual(&duals(&p), &constants(&rho), at_k, at_l);
                near(&robot.pose_error_jacobian(&p, &rho, [k, l]), &duals);
            }
        }
    }
}
