//! Serial arms: modified Denavit-Hartenberg parameters (Craig 1986) with Hayati's angle for near-parallel axes
//! (Hayati & Mirmirani 1985), joint offsets and gains, optionally bending under gravity and coupling of the wrist.
//!
//! A chain is a sequence of elementary motions, each linear in the parameters once the joints are known. Position and
//! Jacobian come from the same sequence: the derivative by a rotation is axis × lever, by a translation the axis (Corke,
//! "A simple and systematic approach to assigning Denavit–Hartenberg parameters", 2007).

use super::{Definition, Description, FreeBase, Joint, Model, Parameter, Quantity, Robot, Role};
use crate::base::message::{Message, Place, Problems, Result};
use crate::base::pose::{Pose, Vector, cross, dot, minus, norm, unit};
use crate::base::scalar::Scalar;
use crate::math::solve;
use schemars::JsonSchema;
use serde::Deserialize;

/// Serial arm.
pub(super) const MODEL: Model = Model::new::<Keys>(
    "serial",
    &[&["joint"], &["gravity"], &["bending"], &["coupling"], &["base_turn_y_deg"]],
    &["joint", "alpha_deg", "alpha_rad", "a_mm", "a_m", "theta_deg", "theta_rad", "d_mm", "d_m"],
);

/// Axes whose twist is below this are near-parallel: d is replaced by Hayati's beta (3 degrees).
const NEAR_PARALLEL_RAD: f64 = 0.052;

/// Keys of a serial arm in robot.toml.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Keys {
    /// Joints of a serial arm, from the base.
    #[serde(default, rename = "joint")]
    joints: Vec<JointKeys>,
    /// Direction of gravity in the base of a serial arm.
    #[serde(default = "down")]
    gravity: Vector,
    /// Numbers of the joints of a serial arm that bend under gravity, from 1.
    #[serde(default)]
    bending: Vec<usize>,
    /// Coupled joints of a serial arm: pairs of a joint and the joint that moves it, from 1.
    #[serde(default)]
    coupling: Vec<(usize, usize)>,
    /// Rotation about the y axis of the world before base_rx, base_ry and base_rz of a serial arm.
    #[serde(default)]
    base_turn_y_deg: f64,
}

fn down() -> Vector {
    [0.0, 0.0, -1.0]
}

/// A joint of a serial arm by its nominal modified Denavit-Hartenberg parameters (Craig), from the base. Its alpha, a, theta and d
/// must be stated, each in one of its two units.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct JointKeys {
    /// Twist of the previous link.
    alpha_deg: Option<f64>,
    /// The same in radians.
    alpha_rad: Option<f64>,
    /// Length of the previous link.
    a_mm: Option<f64>,
    /// The same in metres.
    a_m: Option<f64>,
    /// Joint offset.
    theta_deg: Option<f64>,
    /// The same in radians.
    theta_rad: Option<f64>,
    /// Link offset.
    d_mm: Option<f64>,
    /// The same in metres.
    d_m: Option<f64>,
    /// The joint is prismatic.
    #[serde(default)]
    prismatic: bool,
    /// Near-parallel to the previous axis: Hayati's beta replaces d. By default so below 3 degrees of twist.
    parallel: Option<bool>,
}

impl JointKeys {
    /// The joint, the first of the arm or a later one; `place` is that of its table.
    fn joint(&self, first: bool, place: &Place) -> Result<SerialJoint> {
        let mut problems = Problems::default();
        let mut either = |keys: [&str; 2], stated: [Option<f64>; 2]| match stated {
            [Some(value), None] | [None, Some(value)] => value,
            [one, _] => {
                let [key, other] = keys;
                let what = match one {
                    Some(_) => format!("`{key}` and `{other}` state the same: leave one of them out"),
                    None => format!("the key `{key}` is missing in `joint`"),
                };
                problems.0.push(Message::error(what).at(place.clone()));
                0.0
            }
        };
        let alpha_rad = either(["alpha_deg", "alpha_rad"], [self.alpha_deg.map(f64::to_radians), self.alpha_rad]);
        let a_mm = either(["a_mm", "a_m"], [self.a_mm, self.a_m.map(|m| 1000.0 * m)]);
        let theta_rad = either(["theta_deg", "theta_rad"], [self.theta_deg.map(f64::to_radians), self.theta_rad]);
        let d_mm = either(["d_mm", "d_m"], [self.d_mm, self.d_m.map(|m| 1000.0 * m)]);
        let near = !first && alpha_rad.sin().abs() < NEAR_PARALLEL_RAD && !self.prismatic;
        let parallel = self.parallel.unwrap_or(near);
        problems.check()?;
        Ok(SerialJoint { alpha_rad, a_mm, theta_rad, d_mm, prismatic: self.prismatic, parallel })
    }
}

impl Keys {
    /// What is wrong with numbers of joints and names of targets.
    fn check(&self, targets: &[String], place: &dyn Fn(&[&str]) -> Place) -> Problems {
        let n = self.joints.len();
        let mut problems = Problems::default();
        let mut wrong = |key: &str, i: usize, what: String| {
            let message = Message::error(what).at(place(&[key, &i.to_string()]));
            problems.0.push(message.expected(format!("joints from 1 to {n}, each once")));
        };
        for (i, &j) in self.bending.iter().enumerate() {
            if j == 0 || j > n {
                wrong("bending", i, format!("there is no joint {j}"));
            } else if self.bending[..i].contains(&j) {
                wrong("bending", i, format!("joint {j} is there twice"));
            }
        }
        for (i, pair) in self.coupling.iter().enumerate() {
            if let Some(j) = [pair.0, pair.1].into_iter().find(|&j| j == 0 || j > n) {
                wrong("coupling", i, format!("there is no joint {j}"));
            } else if pair.0 == pair.1 {
                wrong("coupling", i, format!("joint {} is coupled with itself: that is its gain", pair.0));
            } else if self.coupling[..i].contains(pair) {
                wrong("coupling", i, format!("the pair {}, {} is there twice", pair.0, pair.1));
            }
        }
        if targets.is_empty() {
            problems.0.push(Message::error("a serial arm needs at least one target").hint("name them in `targets`"));
        }
        if targets.iter().any(|target| target == "base") {
            let what = "no target can be called `base`: its parameters would be those of the robot's base";
            problems.0.push(Message::error(what).hint("give the target another name in label or columns"));
        }
        problems
    }
}

impl Description for Keys {
    fn states_geometry(&self) -> bool {
        true
    }

    fn build(&self, targets: &[String], place: &dyn Fn(&[&str]) -> Place) -> Result<Box<dyn Robot>> {
        if self.joints.is_empty() {
            return Err(Message::error("a serial arm needs its joints")
                .at(place(&["joint"]))
                .hint("add one [[joint]] with alpha_deg, a_mm, theta_deg, d_mm per joint, from the base")
                .into());
        }
        let (mut joints, mut problems) = (Vec::new(), self.check(targets, place));
        for (i, keys) in self.joints.iter().enumerate() {
            joints.extend(problems.keep(keys.joint(i == 0, &place(&["joint", &i.to_string()]))));
        }
        problems.check()?;
        let gravity = unit(self.gravity).ok_or_else(|| {
            Message::error("`gravity` has no direction")
                .at(place(&["gravity"]))
                .expected("a direction in the base, e.g. [0, 0, -1]")
        })?;
        let serial = Serial::new(&joints, targets, gravity, &self.bending, &self.coupling);
        Ok(Box::new(serial.with_base_turn_y(self.base_turn_y_deg.to_radians())))
    }
}

/// Nominal modified Denavit-Hartenberg parameters of one joint: Rx(alpha) Tx(a) [Ry(beta)] Rz(theta + q) Tz(d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SerialJoint {
    /// Twist of the link before this joint, rad.
    pub alpha_rad: f64,
    /// Length of the link before this joint, mm.
    pub a_mm: f64,
    /// Joint offset, rad.
    pub theta_rad: f64,
    /// Link offset, mm.
    pub d_mm: f64,
    /// The joint moves along its axis instead of turning about it.
    pub prismatic: bool,
    /// Its axis is nearly parallel to the one before: Hayati's beta replaces d.
    pub parallel: bool,
}

/// Where a joint's parameters stand in the list.
#[derive(Clone, Copy, Debug, Default)]
struct Places {
    alpha: usize,
    a: usize,
    /// beta where the axes are nearly parallel, else d
    beta_or_d: usize,
    theta: usize,
    gain: usize,
}

/// A serial arm with its targets and the non-geometric effects that are modelled.
#[derive(Clone, Debug)]
pub struct Serial {
    nominal: Vec<SerialJoint>,
    places: Vec<Places>,
    /// (joint, link, parameter): joint bends under the weight of the link
    bending: Vec<(usize, usize, usize)>,
    /// (joint, by joint, parameter)
    coupling: Vec<(usize, usize, usize)>,
    gravity: Vector,
    base_turn_y_rad: f64,
    definition: Definition,
}

impl Serial {
    /// An arm of `joints` with `targets` on its last link. `bending` lists the joints (from 1) that bend under gravity,
    /// whose direction in the base is `gravity`; `coupling` lists pairs (joint, by which joint), from 1.
    pub fn new(
        joints: &[SerialJoint],
        targets: &[String],
        gravity: Vector,
        bending: &[usize],
        coupling: &[(usize, usize)],
    ) -> Self {
        let mut parameters = Vec::new();
        let mut add = |name: String, quantity, role, nominal| {
            let mut parameter = Parameter::new(name, quantity, role, nominal);
            if role != Role::Robot {
                parameter.tolerance = f64::INFINITY;
            }
            parameters.push(parameter);
            parameters.len() - 1
        };
        use Quantity::{Angle, Length, Ratio};
        for axis in ["x", "y", "z"] {
            add(format!("base_{axis}"), Length, Role::Base, 0.0);
        }
        for axis in ["rx", "ry", "rz"] {
            add(format!("base_{axis}"), Angle, Role::Base, 0.0);
        }
        for target in targets {
            for axis in ["x", "y", "z"] {
                add(format!("{target}_{axis}"), Length, Role::Target, 0.0);
            }
        }
        let mut places = Vec::new();
        for (i, j) in joints.iter().enumerate() {
            let n = i + 1;
            let alpha = add(format!("alpha_{n}"), Angle, Role::Robot, j.alpha_rad);
            let a = add(format!("a_{n}"), Length, Role::Robot, j.a_mm);
            let theta = add(format!("theta_{n}"), Angle, Role::Robot, j.theta_rad);
            let beta_or_d = if j.parallel {
                add(format!("beta_{n}"), Angle, Role::Robot, 0.0)
            } else {
                add(format!("d_{n}"), Length, Role::Robot, j.d_mm)
            };
            places.push(Places { alpha, a, beta_or_d, theta, gain: 0 });
        }
        for (i, place) in places.iter_mut().enumerate() {
            place.gain = add(format!("gain_{}", i + 1), Ratio, Role::Robot, 1.0);
        }
        let pairs = bending.iter().flat_map(|&j| bending.iter().filter(move |&&l| l >= j).map(move |&l| (j, l)));
        let bending =
            pairs.map(|(j, l)| (j - 1, l - 1, add(format!("compliance_{j}_{l}"), Angle, Role::Robot, 0.0))).collect();
        let coupling = coupling
            .iter()
            .map(|&(j, by)| (j - 1, by - 1, add(format!("coupling_{j}_{by}"), Ratio, Role::Robot, 0.0)))
            .collect();
        let names = joints
            .iter()
            .enumerate()
            .map(|(i, j)| Joint { name: format!("q{}", i + 1), quantity: if j.prismatic { Length } else { Angle } });
        Self {
            nominal: joints.to_vec(),
            places,
            bending,
            coupling,
            gravity,
            base_turn_y_rad: 0.0,
            definition: Definition {
                model: "serial",
                dimension: 3,
                parameters,
                joints: names.collect(),
                targets: targets.to_vec(),
            },
        }
    }

    /// The same arm with base_rx, base_ry, base_rz counted after a turn of the world about its y axis, so that a base
    /// whose x axis is upright in the world is not at the singularity of the three angles.
    pub fn with_base_turn_y(mut self, angle_rad: f64) -> Self {
        self.base_turn_y_rad = angle_rad;
        self
    }

    /// The motions from the world to the flange at joint values `q` (rad or mm).
    fn chain(&self, q: &[f64]) -> Chain {
        let mut chain = Chain::default();
        let one = |i: usize| [(i, 1.0)];
        for axis in 0..3 {
            chain.push(Motion::Shift(axis), 0.0, one(axis));
        }
        chain.push(Motion::Turn(1), self.base_turn_y_rad, []);
        for axis in [2, 1, 0] {
            chain.push(Motion::Turn(axis), 0.0, one(3 + axis));
        }
        let levers = self.levers(q);
        for (i, (joint, place)) in self.nominal.iter().zip(&self.places).enumerate() {
            chain.push(Motion::Turn(0), 0.0, one(place.alpha));
            chain.push(Motion::Shift(0), 0.0, one(place.a));
            if joint.parallel {
                chain.push(Motion::Turn(1), 0.0, one(place.beta_or_d));
            }
            // the joint value: gain · q + coupling · q of other joints + compliance · lever of the links
            let coupled = self.coupling.iter().filter(|c| c.0 == i).map(|&(_, by, p)| (p, q[by]));
            let bent = self.bending.iter().zip(&levers).filter(|(b, _)| b.0 == i).map(|(b, &lever)| (b.2, lever));
            let moved = std::iter::once((place.gain, q[i])).chain(coupled).chain(bent);
            let offset = if joint.parallel { None } else { Some((place.beta_or_d, 1.0)) };
            let fixed = if joint.parallel { joint.d_mm } else { 0.0 };
            if joint.prismatic {
                chain.push(Motion::Turn(2), 0.0, one(place.theta));
                chain.push(Motion::Shift(2), fixed, moved.chain(offset));
            } else {
                chain.push(Motion::Turn(2), 0.0, std::iter::once((place.theta, 1.0)).chain(moved));
                chain.push(Motion::Shift(2), fixed, offset);
            }
        }
        chain
    }

    /// For each bending pair (joint, link): the torque of the link's weight about the joint, as a fraction of the
    /// largest (1 when the link is level), on nominal geometry.
    fn levers(&self, q: &[f64]) -> Vec<f64> {
        if self.bending.is_empty() {
            return Vec::new();
        }
        let mut frames = Vec::with_capacity(self.nominal.len());
        let mut pose = Pose::identity();
        let nominal = |i: usize| self.definition.parameters[i].nominal;
        for ((j, place), &q) in self.nominal.iter().zip(&self.places).zip(q) {
            let (turn, slide) = if j.prismatic { (0.0, q) } else { (q, 0.0) };
            let (beta, d) =
                if j.parallel { (nominal(place.beta_or_d), j.d_mm) } else { (0.0, nominal(place.beta_or_d)) };
            pose = pose.turn_x(nominal(place.alpha)).shift(0, nominal(place.a)).turn_y(beta);
            pose = pose.turn_z(nominal(place.theta) + turn).shift(2, d + slide);
            frames.push(pose);
        }
        let lever = |&(joint, link, _): &(usize, usize, usize)| {
            let next = frames.get(link + 1).unwrap_or(&pose);
            let along = unit(minus(next.translation_mm, frames[link].translation_mm)).unwrap_or_default();
            dot(frames[joint].axis(2), cross(along, self.gravity))
        };
        self.bending.iter().map(lever).collect()
    }

    /// Direct kinematics: pose of the flange in the world.
    pub fn direct(&self, parameters: &[f64], q: &[f64]) -> Pose {
        self.chain(q).flange(parameters)
    }

    /// The generic form of [`Robot::positions`]: positions of all targets in the world.
    pub fn target_positions<T: Scalar>(&self, parameters: &[T], q: &[f64]) -> Vec<Vector<T>> {
        let flange = self.chain(q).flange(parameters);
        (0..self.targets().len())
            .map(|k| {
                let place = self.target_place(k);
                flange.apply([parameters[place], parameters[place + 1], parameters[place + 2]])
            })
            .collect()
    }

    /// Inverse kinematics near `start`: joint values at which the flange has the pose `world_T_flange`.
    ///
    /// `None` where the pose cannot be reached to 1e-9 mm and 1e-12 rad from there. The branch is that of `start`.
    pub fn inverse(&self, parameters: &[f64], world_T_flange: &Pose, start: &[f64]) -> Option<Vec<f64>> {
        let mut q = start.to_vec();
        let mut axes = Vec::new();
        for _ in 0..50 {
            let chain = self.chain(&q);
            let reached = chain.trace(parameters, &mut axes);
            let gap = minus(world_T_flange.translation_mm, reached.translation_mm);
            // small rotation from reached to wanted, in the world
            let turn = world_T_flange.then(&reached.inverse()).rotation;
            let small = [turn[2][1] - turn[1][2], turn[0][2] - turn[2][0], turn[1][0] - turn[0][1]].map(|v| 0.5 * v);
            let b: Vec<f64> = gap.iter().chain(&small.map(|v| v * 1000.0)).copied().collect();
            let mut a = vec![0.0; 6 * q.len()];
            for (j, place) in self.places.iter().enumerate() {
                let has_gain = |s: &&Step| chain.terms[s.terms.clone()].iter().any(|t| t.0 == place.gain);
                let k = chain.steps.iter().position(|s| has_gain(&s))?;
                let linear = velocity(chain.steps[k].motion, axes[k], reached.translation_mm);
                let angular = if matches!(chain.steps[k].motion, Motion::Turn(_)) { axes[k].0 } else { [0.0; 3] };
                for i in 0..3 {
                    a[i * q.len() + j] = linear[i] * parameters[place.gain];
                    a[(3 + i) * q.len() + j] = angular[i] * parameters[place.gain] * 1000.0;
                }
            }
            let factor = solve::Factor::new(&a, &b, &vec![1.0; q.len()]);
            let step = factor.solve().or_else(|| factor.damped(1.0).solve())?;
            let longest = step.iter().fold(0.0f64, |m, s| m.max(s.abs()));
            let shorten = if longest > 0.5 { 0.5 / longest } else { 1.0 };
            q.iter_mut().zip(&step).for_each(|(q, s)| *q += shorten * s);
            if longest < 1e-13 {
                break;
            }
        }
        let reached = self.direct(parameters, &q);
        let off = norm(minus(world_T_flange.translation_mm, reached.translation_mm));
        let turned = world_T_flange.inverse().then(&reached).angle_rad();
        (off < 1e-9 && turned < 1e-12).then_some(q)
    }
}

impl Robot for Serial {
    fn definition(&self) -> &Definition {
        &self.definition
    }
    fn definition_mut(&mut self) -> &mut Definition {
        &mut self.definition
    }
    /// Standard Denavit-Hartenberg parameters have twist and length of the link behind the joint, modified ones of the link before it.
    fn other_conventions(&self) -> Vec<(String, Box<dyn Robot>)> {
        let before =
            |i: usize| i.checked_sub(1).map_or((0.0, 0.0), |b| (self.nominal[b].alpha_rad, self.nominal[b].a_mm));
        let joint = |(i, j): (usize, &SerialJoint)| {
            let (alpha_rad, a_mm) = before(i);
            let parallel = i > 0 && alpha_rad.sin().abs() < NEAR_PARALLEL_RAD && !j.prismatic;
            SerialJoint { alpha_rad, a_mm, parallel, ..*j }
        };
        let joints: Vec<SerialJoint> = self.nominal.iter().enumerate().map(joint).collect();
        let other = Self::new(&joints, self.targets(), self.gravity, &[], &[]).with_base_turn_y(self.base_turn_y_rad);
        vec![("the table of joints read as standard Denavit-Hartenberg parameters".into(), Box::new(other))]
    }
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        out.copy_from_slice(self.target_positions(parameters, joints).as_flattened());
    }
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let n = parameters.len();
        out.fill(0.0);
        let chain = self.chain(joints);
        let mut axes = Vec::with_capacity(chain.steps.len());
        let flange = chain.trace(parameters, &mut axes);
        for (k, rows) in out.chunks_exact_mut(3 * n).enumerate() {
            let place = self.target_place(k);
            let point = flange.apply([parameters[place], parameters[place + 1], parameters[place + 2]]);
            for (step, &axis) in chain.steps.iter().zip(&axes) {
                if step.terms.is_empty() {
                    continue;
                }
                let v = velocity(step.motion, axis, point);
                for &(parameter, coefficient) in &chain.terms[step.terms.clone()] {
                    for i in 0..3 {
                        rows[i * n + parameter] += v[i] * coefficient;
                    }
                }
            }
            for axis in 0..3 {
                let direction = flange.axis(axis);
                for i in 0..3 {
                    rows[i * n + place + axis] = direction[i];
                }
            }
        }
    }
    fn free_base(&self) -> Option<&dyn FreeBase> {
        Some(self)
    }
}

impl FreeBase for Serial {
    fn flange(&self, parameters: &[f64], joints: &[f64]) -> Pose {
        self.direct(parameters, joints)
    }
    fn target_place(&self, target: usize) -> usize {
        6 + 3 * target
    }
}

/// A rotation about, or a translation along, an axis of the moving frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Motion {
    /// Rotation about axis 0, 1 or 2, in radians.
    Turn(usize),
    /// Translation along axis 0, 1 or 2, in millimetres.
    Shift(usize),
}

/// One motion by `constant` + Σ coefficient · parameter.
#[derive(Clone, Debug)]
struct Step {
    motion: Motion,
    constant: f64,
    /// Range of this step in [`Chain::terms`].
    terms: std::ops::Range<usize>,
}

/// The motions from the world to the flange for one set of joint values.
#[derive(Clone, Debug, Default)]
struct Chain {
    steps: Vec<Step>,
    /// (parameter, coefficient)
    terms: Vec<(usize, f64)>,
}

impl Chain {
    /// Adds a motion by `constant` + Σ coefficient · parameter.
    fn push(&mut self, motion: Motion, constant: f64, terms: impl IntoIterator<Item = (usize, f64)>) {
        let first = self.terms.len();
        self.terms.extend(terms);
        self.steps.push(Step { motion, constant, terms: first..self.terms.len() });
    }

    /// Amount of a step.
    fn amount<T: Scalar>(&self, step: &Step, p: &[T]) -> T {
        let start = T::from(step.constant);
        self.terms[step.terms.clone()].iter().fold(start, |sum, &(i, c)| sum + p[i] * c)
    }

    /// Pose of the flange in the world.
    fn flange<T: Scalar>(&self, p: &[T]) -> Pose<T> {
        self.steps.iter().fold(Pose::identity(), |pose, step| advance(pose, step.motion, self.amount(step, p)))
    }

    /// Pose of the flange, and of each step its axis in the world with a point on it before the motion.
    fn trace(&self, p: &[f64], axes: &mut Vec<(Vector, Vector)>) -> Pose {
        axes.clear();
        self.steps.iter().fold(Pose::identity(), |pose, step| {
            let (Motion::Turn(axis) | Motion::Shift(axis)) = step.motion;
            axes.push((pose.axis(axis), pose.translation_mm));
            advance(pose, step.motion, self.amount(step, p))
        })
    }
}

fn advance<T: Scalar>(pose: Pose<T>, motion: Motion, amount: T) -> Pose<T> {
    match motion {
        Motion::Turn(0) => pose.turn_x(amount),
        Motion::Turn(1) => pose.turn_y(amount),
        Motion::Turn(_) => pose.turn_z(amount),
        Motion::Shift(axis) => pose.shift(axis, amount),
    }
}

/// Velocity of a point of the flange when a step moves by one.
fn velocity(motion: Motion, (axis, origin): (Vector, Vector), point: Vector) -> Vector {
    match motion {
        Motion::Turn(_) => cross(axis, minus(point, origin)),
        Motion::Shift(_) => axis,
    }
}
