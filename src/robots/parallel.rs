//! Platforms on legs: common part of hexapods and deltas.
//!
//! Each leg is a rod between a point of the base and a point of the platform. Its length is an
//! equation between the pose of the platform, the joints and the parameters of the leg. Exact
//! derivatives follow by the implicit function theorem, independent of the method that found the
//! pose. The platform is the flange of a robot with a free base: parameters of base and targets
//! come first, then the parameters of each leg.

use super::{
    Definition, FreeBase, Joint, JointRange, Kinematics, Outline, Parameter, Quantity, Robot, Role, base_and_targets,
    base_pose, limit_violation, meaning, normal_equations, pose_outputs, square,
};
use etalon_base::catalogue::Phrase;
use etalon_base::expression::{Formula, Recorded};
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, cross, minus, norm, turning_axes};
use etalon_base::scalar::{Dual, Scalar};
use etalon_base::sketch::{Sketch, StrokeKind};
use nalgebra::{Matrix6, Vector6};
use std::fmt::Debug;

/// Maximum number of parameters of a leg, plus one for its joint.
const MOST: usize = 10;
/// Number of parameters of the base.
const BASE: usize = 6;

/// A leg at a joint value (mm).
#[derive(Clone, Copy, Debug)]
pub(super) struct Rod<T = f64> {
    /// End on the base, in the base frame.
    pub base_mm: Vector<T>,
    /// End on the platform, in the frame of the platform.
    pub platform_mm: Vector<T>,
    /// Length of the rod.
    pub length_mm: T,
}

impl<T: Scalar> Rod<T> {
    /// Distance of the ends minus the length.
    pub fn gap(&self, platform: &Pose<T>) -> T {
        let (a, b) = (platform.apply(self.platform_mm), self.base_mm);
        let d = [0, 1, 2].map(|i| a[i] - b[i]);
        (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt() - self.length_mm
    }

    /// End on a platform that does not rotate, in the base frame.
    pub fn shifted(&self, platform: &Pose<T>) -> Vector<T> {
        let (a, t) = (self.platform_mm, platform.translation_mm);
        [0, 1, 2].map(|i| a[i] + t[i])
    }

    /// Derivative of the length with respect to a small translation (mm) and rotation (rad) of the
    /// platform in the base.
    fn lengthens(&self, platform: &Pose<T>) -> [T; 6] {
        let (end, b) = (platform.apply(self.platform_mm), self.base_mm);
        let [x, y, z] = [0, 1, 2].map(|i| end[i] - b[i]);
        let length = (x * x + y * y + z * z).sqrt();
        let along = [x, y, z].map(|v| v / length);
        let turn = cross(platform.rotate(self.platform_mm), along);
        [along[0], along[1], along[2], turn[0], turn[1], turn[2]]
    }
}

/// A parameter of each leg.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegParameter {
    /// Name, where `#` stands for the number of the leg, from 1.
    pub name: &'static str,
    pub quantity: Quantity,
    pub meaning: &'static str,
}

/// Legs of a model.
pub(super) trait Legs: Clone + Debug + Send + Sync {
    /// Name of the model.
    const MODEL: &'static str;
    /// Parameters of each leg, in order; at most nine.
    const PARAMETERS: &'static [LegParameter];
    /// Joint of each leg.
    const JOINT: LegParameter;
    /// Number of legs: six, or three for a platform that does not rotate.
    const COUNT: usize;
    /// Branches of the inverse kinematics of each leg.
    const BRANCHES: &'static [f64] = &[1.0];

    /// Rod of a leg, from 0, at the leg's own parameters and joint value.
    fn rod<T: Scalar>(&self, leg: usize, p: &[T], q: T) -> Rod<T>;

    /// Pose of the platform in the base on rods with fixed ends, if there is a closed form.
    fn direct<T: Scalar>(&self, _rods: &[Rod<T>]) -> Option<Pose<T>> {
        None
    }

    /// Pose of the platform in the base.
    fn place(&self, legs: &LegValues<'_, Self>, joints: &[f64]) -> Option<Pose> {
        self.direct(&legs.rods(joints))
    }

    /// Adds the parameters of the first leg to a drawing of the platform.
    fn sketch(&self, p: &[f64], q: f64, platform: &Pose, sketch: &mut Sketch);

    /// Points of a leg in the base before its rod, at the leg's own parameters and joint value.
    fn limb(&self, _leg: usize, _p: &[f64], _q: f64) -> Vec<Vector> {
        Vec::new()
    }

    /// Joint value of a leg at a pose of the platform, on branch 1 or, for legs with two branches,
    /// −1; NaN if the leg does not reach.
    fn joint_at<T: Scalar>(&self, leg: usize, p: &[T], platform: &Pose<T>, branch: T) -> T;
}

/// Legs with their parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegValues<'a, L, T = f64> {
    pub legs: &'a L,
    /// Parameters of all legs, one leg after the other.
    pub parameters: &'a [T],
}

impl<L: Legs, T: Scalar> LegValues<'_, L, T> {
    /// Parameters of one leg.
    fn leg_parameters(&self, leg: usize) -> &[T] {
        let n = L::PARAMETERS.len();
        &self.parameters[leg * n..][..n]
    }

    /// All rods.
    pub fn rods(&self, joints: &[T]) -> Vec<Rod<T>> {
        (0..L::COUNT).map(|leg| self.legs.rod(leg, self.leg_parameters(leg), joints[leg])).collect()
    }
}

/// Derivatives of the rod lengths with respect to a small translation (mm) and rotation (rad) of
/// the platform in the base, one row per rod. For three rods, rows of the rotation alone follow.
pub(super) fn lengthening(rods: &[Rod], platform: &Pose) -> Matrix6<f64> {
    let mut matrix = Matrix6::identity();
    for (i, rod) in rods.iter().enumerate() {
        rod.lengthens(platform).into_iter().enumerate().for_each(|(k, v)| matrix[(i, k)] = v);
    }
    matrix
}

/// Newton step to the pose of the platform on six rods, and its size (mm). Large steps are smoothly
/// shortened to half a radian. The next step corrects the rounding of the normal equations.
fn newton_step<T: Scalar>(rods: &[Rod<T>], platform: &Pose<T>) -> (Pose<T>, T) {
    // rotations are in mm of the longest lever, so that all unknowns have the same scale
    let lever = rods.iter().map(|rod| norm(rod.platform_mm.map(Scalar::value))).fold(0.0, f64::max);
    let scale = |k: usize| if k < 3 { 1.0 } else { 1.0 / lever };
    let rows: Vec<Vec<T>> = rods
        .iter()
        .map(|rod| {
            let own = rod.lengthens(platform).into_iter().enumerate().map(|(k, v)| v * scale(k));
            own.chain([-rod.gap(platform)]).collect()
        })
        .collect();
    let by: Vec<T> = normal_equations(&rows, 0.0).enumerate().map(|(k, v)| v * scale(k)).collect();
    let shorter = T::from(1.0) / (square(&by[3..]) * 4.0 + 1.0).sqrt();
    let size = (square(&by[..3]) + square(&by[3..]) * (lever * lever)).sqrt();
    let [x, y, z, p, q, r] = [0, 1, 2, 3, 4, 5].map(|k| by[k] * shorter);
    let t = platform.translation_mm;
    let turned = Pose { translation_mm: [T::from(0.0); 3], ..cayley([p, q, r]) }.then(platform);
    (Pose { translation_mm: [t[0] + x, t[1] + y, t[2] + z], ..turned }, size)
}

/// Rotation matrix of a small rotation vector without trigonometry (Cayley).
fn cayley<T: Scalar>([x, y, z]: Vector<T>) -> Pose<T> {
    let [a, b, c, one] = [x * 0.5, y * 0.5, z * 0.5, T::from(1.0)];
    let factor = T::from(2.0) / (a * a + b * b + c * c + 1.0);
    let rotation = [
        [one - factor * (b * b + c * c), factor * (a * b - c), factor * (a * c + b)],
        [factor * (a * b + c), one - factor * (a * a + c * c), factor * (b * c - a)],
        [factor * (a * c - b), factor * (b * c + a), one - factor * (a * a + b * b)],
    ];
    Pose { rotation, ..Pose::identity() }
}

/// Distances of the ends of rods minus their lengths (mm).
pub(super) fn gaps(rods: &[Rod], platform: &Pose) -> Vector6<f64> {
    let mut gaps = Vector6::zeros();
    rods.iter().enumerate().for_each(|(i, rod)| gaps[i] = rod.gap(platform));
    gaps
}

/// A platform on legs, with its nominal parameters and joint limits.
#[derive(Clone, Debug)]
pub(super) struct Parallel<L> {
    definition: Definition,
    legs: L,
    /// Limits of each joint (rad or mm).
    limits: Vec<Option<[f64; 2]>>,
}

impl<L: Legs> Parallel<L> {
    /// Creates the robot; `nominal` holds the parameters of the legs one after the other.
    pub fn new(legs: L, nominal: &[f64], limits: Vec<Option<[f64; 2]>>, targets: &[String]) -> Self {
        let mut parameters = base_and_targets(targets);
        let numbered = |name: &str, leg: usize| name.replace('#', &(leg + 1).to_string());
        for (leg, nominal) in nominal.chunks_exact(L::PARAMETERS.len()).enumerate() {
            let own = L::PARAMETERS.iter().zip(nominal);
            parameters.extend(
                own.map(|(p, &v)| Parameter::new(numbered(p.name, leg), p.quantity, Role::Robot, v).meaning(p.meaning))
                    .map(|p| p.with_joint(leg)),
            );
        }
        let joint = |leg: usize| Joint { name: numbered(L::JOINT.name, leg), quantity: L::JOINT.quantity };
        let joints = (0..L::COUNT).map(joint).collect();
        let definition = Definition { model: L::MODEL, dimension: 3, parameters, joints, targets: targets.to_vec() };
        Self { definition, legs, limits }
    }

    /// Index of the first parameter of the legs.
    fn first(&self) -> usize {
        BASE + 3 * self.targets().len()
    }

    fn values<'a>(&'a self, parameters: &'a [f64]) -> LegValues<'a, L> {
        LegValues { legs: &self.legs, parameters: &parameters[self.first()..] }
    }

    /// Pose of the platform in the base frame.
    pub fn place(&self, parameters: &[f64], joints: &[f64]) -> Option<Pose> {
        let pose = self.legs.place(&self.values(parameters), joints)?;
        pose.rotation.as_flattened().iter().chain(&pose.translation_mm).all(|v| v.is_finite()).then_some(pose)
    }

    /// Pose of the platform and its derivatives.
    fn moving(&self, parameters: &[f64], joints: &[f64]) -> Option<(Pose, Twists)> {
        let platform = self.place(parameters, joints)?;
        Some((platform, self.twists(parameters, joints, &platform)?))
    }

    /// Position of a target on the platform.
    fn on_platform(&self, parameters: &[f64], target: usize) -> Vector {
        let place = self.target_place(target);
        [parameters[place], parameters[place + 1], parameters[place + 2]]
    }

    /// Derivatives of the pose of the platform.
    fn twists(&self, parameters: &[f64], joints: &[f64], platform: &Pose) -> Option<Twists> {
        let values = self.values(parameters);
        let inverse = lengthening(&values.rods(joints), platform).try_inverse()?;
        let (mut twists, still) = (Twists::default(), constant(platform));
        for (leg, &q) in joints.iter().enumerate().take(L::COUNT) {
            let own = values.leg_parameters(leg);
            let p: Vec<Dual<MOST>> = own.iter().enumerate().map(|(k, &v)| Dual::variable(v, k)).collect();
            let gap = self.legs.rod(leg, &p, Dual::variable(q, own.len())).gap(&still);
            let by = |k: usize| {
                let of = |row: usize| -inverse[(row, leg)] * gap.gradient[k];
                Twist { shift: [of(0), of(1), of(2)], turn: [of(3), of(4), of(5)] }
            };
            twists.by_parameters.extend((0..own.len()).map(by));
            twists.by_joints.push(by(own.len()));
        }
        Some(twists)
    }
}

/// Small motion of the platform in the base (mm, rad).
#[derive(Clone, Copy, Debug)]
struct Twist {
    shift: Vector,
    turn: Vector,
}

impl Twist {
    /// Motion of a point at `lever` from the origin of the platform, in the world.
    fn moves(&self, lever: Vector, base: &Pose) -> Vector {
        let by_turn = cross(self.turn, lever);
        base.rotate([0, 1, 2].map(|i| self.shift[i] + by_turn[i]))
    }
}

/// Motion of the platform per unit of each leg parameter, in order, and of each joint.
#[derive(Debug, Default)]
struct Twists {
    by_parameters: Vec<Twist>,
    by_joints: Vec<Twist>,
}

/// A pose without derivatives.
fn constant(pose: &Pose) -> Pose<Dual<MOST>> {
    Pose { rotation: pose.rotation.map(|row| row.map(Dual::from)), translation_mm: pose.translation_mm.map(Dual::from) }
}

/// NaN pose, for joint values that admit no pose.
fn nowhere() -> Pose {
    Pose { rotation: [[f64::NAN; 3]; 3], translation_mm: [f64::NAN; 3] }
}

/// Writes a vector into a column of three rows of length `n`.
fn write(out: &mut [f64], n: usize, column: usize, v: Vector) {
    (0..3).for_each(|i| out[i * n + column] = v[i]);
}

impl<L: Legs> Robot for Parallel<L> {
    fn definition(&self) -> &Definition {
        &self.definition
    }
    fn definition_mut(&mut self) -> &mut Definition {
        &mut self.definition
    }
    fn sketches(&self) -> Vec<Sketch> {
        let parameters = self.nominal();
        let joints: Vec<f64> = self.limits.iter().map(|l| l.map_or(0.0, |[low, high]| 0.5 * (low + high))).collect();
        let Some(platform) = self.place(&parameters, &joints) else { return Vec::new() };
        let title = meaning("sketch-legs");
        let mut sketch = Sketch::new(title, false);
        let values = self.values(&parameters);
        let rods = values.rods(&joints);
        let ends: Vec<Vector> = rods.iter().map(|rod| platform.apply(rod.platform_mm)).collect();
        rods.iter().zip(&ends).for_each(|(rod, end)| sketch.add(StrokeKind::Part, "", &[rod.base_mm, *end]));
        sketch.add(StrokeKind::Part, "", &[&ends[..], &ends[..1]].concat());
        self.legs.sketch(values.leg_parameters(0), joints[0], &platform, &mut sketch);
        let size = sketch.extent_mm();
        sketch.frame("base", &Pose::identity(), 0.14 * size);
        sketch.frame("platform", &platform, 0.1 * size);
        vec![sketch]
    }
    fn outline(&self, parameters: &[f64], joints: &[f64]) -> Outline {
        let Some(platform) = self.place(parameters, joints) else { return Outline::default() };
        let values = self.values(parameters);
        let (mut outline, mut feet, mut ends) = (Outline::default(), Vec::new(), Vec::new());
        for (leg, rod) in values.rods(joints).iter().enumerate() {
            let name = &self.joints()[leg].name;
            let mut limb = self.legs.limb(leg, values.leg_parameters(leg), joints[leg]);
            limb.push(rod.base_mm);
            let end = platform.apply(rod.platform_mm);
            outline.link(name, &limb);
            outline.link(name, &[rod.base_mm, end]);
            feet.extend(limb.first());
            ends.push(end);
        }
        outline.link("base", &[&feet[..], &feet[..1]].concat());
        outline.link("platform", &[&ends[..], &ends[..1]].concat());
        outline.moved(&base_pose(parameters))
    }
    /// Writes NaN if the legs do not meet the platform.
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let flange = self.flange(parameters, joints, 0);
        for (k, out) in out.chunks_exact_mut(3).enumerate() {
            out.copy_from_slice(&flange.apply(self.on_platform(parameters, k)));
        }
    }
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let (n, targets) = (parameters.len(), Vec::from_iter(0..self.targets().len()));
        out.fill(0.0);
        self.target_derivatives(parameters, joints, &targets, &mut |target, column, moved| {
            write(&mut out[3 * target * n..], n, column, moved);
        });
    }
    /// The position of a target depends only on its own coordinates, not on the coordinates of
    /// other targets. NaN if the legs do not meet the platform.
    fn target_derivatives(
        &self,
        parameters: &[f64],
        joints: &[f64],
        targets: &[usize],
        write: &mut dyn FnMut(usize, usize, Vector),
    ) {
        let Some((platform, twists)) = self.moving(parameters, joints) else {
            let all = targets.iter().flat_map(|&k| (0..parameters.len()).map(move |column| (k, column)));
            return all.for_each(|(k, column)| write(k, column, [f64::NAN; 3]));
        };
        let base = base_pose(parameters);
        let flange = base.then(&platform);
        let axes = turning_axes([parameters[3], parameters[4], parameters[5]]);
        for &k in targets {
            let (place, on_platform) = (self.target_place(k), self.on_platform(parameters, k));
            let lever = platform.rotate(on_platform);
            let from_base = base.rotate(platform.apply(on_platform));
            for (i, axis) in axes.into_iter().enumerate() {
                write(k, i, Pose::identity().axis(i));
                write(k, 3 + i, cross(axis, from_base));
                write(k, place + i, flange.axis(i));
            }
            let legs = twists.by_parameters.iter().enumerate();
            legs.for_each(|(j, twist)| write(k, self.first() + j, twist.moves(lever, &base)));
        }
    }
    fn joint_jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let Some((platform, twists)) = self.moving(parameters, joints) else { return out.fill(f64::NAN) };
        let (n, base) = (joints.len(), base_pose(parameters));
        for (k, out) in out.chunks_exact_mut(3 * n).enumerate() {
            let lever = platform.rotate(self.on_platform(parameters, k));
            twists.by_joints.iter().enumerate().for_each(|(j, twist)| write(out, n, j, twist.moves(lever, &base)));
        }
    }
    fn limit_violation(&self, parameters: &[f64], joints: &[f64]) -> Option<Phrase> {
        let apart = || self.place(parameters, joints).is_none().then(|| phrase!("legs-apart"));
        limit_violation(self.joints(), &self.limits, joints).or_else(apart)
    }
    fn joint_range(&self, joint: usize) -> JointRange {
        JointRange::from_limits(self.limits.get(joint).copied().flatten())
    }
    fn free_base(&self) -> Option<&dyn FreeBase> {
        Some(self)
    }
    fn kinematics(&self) -> Option<&dyn Kinematics> {
        Some(self)
    }
}

/// Maximum rotation of a platform on three legs, which does not rotate (rad).
const TURNED: f64 = 1e-6;
/// Maximum deviation of the platform from a pose when its joint values are converted back (mm or
/// dimensionless).
const BACK: f64 = 1e-6;
/// Share of a rod's length by which rounding of the joint values moves a platform at a singularity
/// (the square root of the rounding).
const ROUNDED: f64 = 3e-7;

impl<L: Legs> Kinematics for Parallel<L> {
    fn tool_pose(&self, parameters: &[f64], joints: &[f64]) -> Option<Pose> {
        self.place(parameters, joints)
    }

    /// Formulas `inverse`, with the branches of legs that have two, and `direct` or, for Newton's
    /// method, `step`.
    fn formulas(&self, parameters: &[f64]) -> Vec<Formula> {
        let joints: Vec<String> = self.joints().iter().map(|joint| joint.name.clone()).collect();
        // the rotation of a platform on three legs is constant
        let count = if L::COUNT == 6 { 12 } else { 3 };
        let names = pose_outputs(&Pose::<f64>::identity()).into_iter().map(|(name, _)| name).take(count);
        let names: Vec<String> = names.collect();
        let pose = |v: &[Recorded]| {
            let platform = Pose { translation_mm: [v[0], v[1], v[2]], ..Pose::identity() };
            let cell = |i: usize, j: usize| v[3 + 3 * i + j];
            match L::COUNT {
                6 => Pose { rotation: [0, 1, 2].map(|i| [0, 1, 2].map(|j| cell(i, j))), ..platform },
                _ => platform,
            }
        };
        let values = || parameters[self.first()..].iter().map(|&v| Recorded::from(v)).collect::<Vec<_>>();
        let legs = &self.legs;
        let two = L::BRANCHES.len() > 1;
        let branches = (1..=L::COUNT).filter(|_| two).map(|leg| format!("branch{leg}"));
        let inverse = Formula::record("inverse", &names.iter().cloned().chain(branches).collect::<Vec<_>>(), |v| {
            let (platform, values) = (pose(v), values());
            let values = LegValues { legs, parameters: &values };
            let branch = |leg: usize| if two { v[names.len() + leg] } else { Recorded::from(1.0) };
            let at = |leg: usize| legs.joint_at(leg, values.leg_parameters(leg), &platform, branch(leg));
            joints.iter().cloned().zip((0..L::COUNT).map(at)).collect()
        });
        let outputs = |pose: &Pose<Recorded>| pose_outputs(pose).into_iter().take(names.len()).collect::<Vec<_>>();
        let mut closed = true;
        let direct = Formula::record("direct", &joints, |q| {
            let place = legs.direct(&LegValues { legs, parameters: &values() }.rods(q));
            closed = place.is_some();
            place.map_or_else(Vec::new, |place| outputs(&place))
        });
        if closed {
            return vec![direct, inverse];
        }
        let inputs = names.iter().chain(&joints).cloned().collect::<Vec<_>>();
        let step = Formula::record("step", &inputs, |v| {
            let rods = LegValues { legs, parameters: &values() }.rods(&v[names.len()..]);
            let (next, size) = newton_step(&rods, &pose(v));
            outputs(&next).into_iter().chain([("size".to_owned(), size)]).collect()
        });
        vec![step, inverse]
    }

    /// Combinations of the solutions of single legs that bring the platform to the pose, excluding
    /// its other assembly modes.
    fn all_joints(&self, parameters: &[f64], pose: &Pose) -> Vec<Vec<f64>> {
        if L::COUNT < 6 && pose.angle_rad() > TURNED {
            return Vec::new();
        }
        let values = self.values(parameters);
        let mut all = vec![Vec::new()];
        for leg in 0..L::COUNT {
            let at = |branch: &f64| self.legs.joint_at(leg, values.leg_parameters(leg), pose, *branch);
            let ways: Vec<f64> = L::BRANCHES.iter().map(at).filter(|q| q.is_finite()).collect();
            all = all.iter().flat_map(|q: &Vec<f64>| ways.iter().map(|w| [&q[..], &[*w]].concat())).collect();
        }
        all.retain(|q| {
            let there = self.place(parameters, q);
            let rod_mm = values.rods(q).iter().fold(0.0, |most: f64, rod| most.max(rod.length_mm));
            there.is_some_and(|there| {
                let off = there.rotation.as_flattened().iter().zip(pose.rotation.as_flattened());
                norm(minus(there.translation_mm, pose.translation_mm)) < BACK.max(ROUNDED * rod_mm)
                    && off.into_iter().all(|(a, b)| (a - b).abs() < BACK)
            })
        });
        all
    }
}

impl<L: Legs> FreeBase for Parallel<L> {
    fn flange(&self, parameters: &[f64], joints: &[f64], _target: usize) -> Pose {
        self.place(parameters, joints).map_or_else(nowhere, |platform| base_pose(parameters).then(&platform))
    }
    fn flange_turns(&self, parameters: &[f64], joints: &[f64], _target: usize, out: &mut [f64]) {
        let n = parameters.len();
        let Some((_, twists)) = self.moving(parameters, joints) else { return out.fill(f64::NAN) };
        out.fill(0.0);
        let base = base_pose(parameters);
        let axes = turning_axes([parameters[3], parameters[4], parameters[5]]);
        (0..3).for_each(|i| write(out, n, 3 + i, axes[i]));
        let turns = twists.by_parameters.iter().map(|twist| base.rotate(twist.turn)).enumerate();
        turns.for_each(|(j, turn)| write(out, n, self.first() + j, turn));
    }
}
