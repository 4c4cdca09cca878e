//! Robots as functions of their parameters: direct and inverse kinematics with exact Jacobians.
//!
//! Each model is one file, which holds its equations, written once and generic over the [`Scalar`],
//! and the [`Key`]s of its description; [`MODELS`] lists it in one line. Abilities of some models
//! are separate traits: [`Platform`], [`RailTable`], [`FreeBase`]. Lengths are in millimetres,
//! angles in radians.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

mod chains;
mod delta;
mod description;
mod five_bar;
mod hexapod;
mod outline;
mod parallel;
mod prexyt;
mod reference;
mod serial;

use chains::{branches, chain, compensation, conventions, inverse};
use description::{definition, fault, keys, published, tables, urdf};

pub use compensation::{Calibrated, Compensated, Correction};
pub use conventions::SerialJoint;
pub use definition::{Circumstance, Definition, Effect, Joint, Parameter, Quantity, Role, meaning};
pub use fault::{At, Fault, FaultKind, Faults, JointFault, TreeFault};
pub use five_bar::{FiveBar, FiveBarLimits, InverseSolution, Linkage, SingularityDistance, WORKING_MODES};
pub use keys::{Absence, JointRef, Key, Model, Shape, Value, Values};
pub use outline::{Outline, OutlineLine};
pub use prexyt::Prexyt;
pub use published::{PUBLISHED, PublishedArm};
pub use reference::{ReferencePose, reference_pose, reference_poses};
pub use serial::Serial;
pub use tables::{
    AxisLine, AxisTable, LostTilt, NEAR_PARALLEL_RAD, TableConvention, frame, link_frames, modified_table,
    standard_table,
};
pub use urdf::{Link, Mimic, Tree, TreeChain, TreeJoint};

use etalon_base::catalogue::Phrase;
use etalon_base::expression::Formula;
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_base::scalar::Scalar;
use etalon_base::sketch::Sketch;

/// All models.
pub const MODELS: [&Model; 8] = [
    &prexyt::REDUCED,
    &prexyt::FULL,
    &five_bar::MODEL,
    &conventions::MODEL,
    &urdf::MODEL,
    &hexapod::MODEL,
    &delta::ROTARY,
    &delta::LINEAR,
];

/// Range of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointRange {
    /// Lower and upper limit (mm or rad).
    Limits([f64; 2]),
    /// Continuous rotation.
    Endless,
    /// The robot file contains no limits.
    Unstated,
}

impl JointRange {
    /// Converts given limits; equal infinite limits mean continuous rotation.
    fn from_limits(limits: Option<[f64; 2]>) -> Self {
        match limits {
            Some([lower, upper]) if lower.is_infinite() && upper.is_infinite() => Self::Endless,
            Some(ends) if ends[0] < ends[1] => Self::Limits(ends),
            _ => Self::Unstated,
        }
    }
}

/// A robot whose targets are observed by a measuring system.
///
/// # Examples
///
/// ```
/// use etalon_robots::{Prexyt, Robot};
///
/// let robot: &dyn Robot = &Prexyt::default();
/// assert_eq!(robot.targets(), ["K", "L"]);
/// assert_eq!(robot.joints()[0].column(), "rho1_mm");
///
/// // the balls K and L of the table are 146 mm apart, along x where carriages 2 and 3 are level
/// let (nominal, joints_mm) = (robot.nominal(), [100.0, 200.0, 200.0]);
/// let [k, l] = [0, 1].map(|target| robot.position(&nominal, &joints_mm, target));
/// assert!((l[0] - k[0] - 146.0).abs() < 1e-9 && (l[1] - k[1]).abs() < 1e-9);
/// ```
pub trait Robot: Send + Sync {
    /// Short name of the model: `prexyt`, `five_bar`, `serial` ...
    fn model(&self) -> &'static str {
        self.definition().model
    }

    /// Model, parameters, joints and targets.
    fn definition(&self) -> &Definition;

    /// Mutable access to the definition.
    fn definition_mut(&mut self) -> &mut Definition;

    /// Parameters, in the order of all slices of parameters.
    fn parameters(&self) -> &[Parameter] {
        &self.definition().parameters
    }

    /// Joints, in the order of all slices of joint values.
    fn joints(&self) -> &[Joint] {
        &self.definition().joints
    }

    /// Names of the targets on the moving part.
    fn targets(&self) -> &[String] {
        &self.definition().targets
    }

    /// Number of coordinates measured per target: 2 for planar robots (x, y), otherwise 3.
    fn dimension(&self) -> usize {
        self.definition().dimension
    }

    /// Writes the positions of all targets in the world (mm), `dimension` values per target.
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]);

    /// Writes ∂ positions / ∂ parameters, row by row: (targets × dimension) × parameters.
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]);

    /// Calls `write` with the derivatives of target positions, like
    /// [`Parametrised::target_derivatives`].
    fn target_derivatives(
        &self,
        parameters: &[f64],
        joints: &[f64],
        targets: &[usize],
        write: &mut dyn FnMut(usize, usize, Vector),
    ) {
        let (n, d) = (parameters.len(), self.dimension());
        let mut all = vec![0.0; d * self.targets().len() * n];
        self.jacobian(parameters, joints, &mut all);
        for &k in targets {
            let own = &all[d * k * n..];
            let component = |i: usize, j: usize| if i < d { own[i * n + j] } else { 0.0 };
            (0..n).for_each(|j| write(k, j, [0, 1, 2].map(|i| component(i, j))));
        }
    }

    /// Writes ∂ positions / ∂ joint values, row by row: (targets × dimension) × joints. Bending is
    /// evaluated at the joint values themselves.
    fn joint_jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]);

    /// Function that returns the bending loads at joint values, independent of the parameters, each
    /// as a fraction of its largest value. `None` for models without bending.
    fn loads(&self) -> Option<Loads<'_>> {
        None
    }

    /// Binds parameters for many evaluations, so that everything depending on parameters alone is
    /// computed once.
    fn parametrised<'a>(&'a self, parameters: &'a [f64]) -> Box<dyn Parametrised + 'a> {
        Box::new(Anew { robot: self, parameters })
    }

    /// `true` if joint values leave two possible positions. The assembly mode, +1 or −1, then
    /// follows the joints in every slice of joint values.
    fn has_assembly_modes(&self) -> bool {
        false
    }

    /// Indices of the joints with direction of approach. For each of them, +1 (from below) or −1
    /// (from above) follows the joint values; without these values the middle of the backlash is
    /// used.
    fn approached(&self) -> &[usize] {
        &[]
    }

    /// Values that each reading gives besides: they follow the joint values and the directions of
    /// [`Robot::approached`]. Without these values there is no payload and no torque, and the
    /// temperature is the reference temperature.
    fn circumstances(&self) -> &[Circumstance] {
        &[]
    }

    /// Temperature (°C) to which lengths and zeros refer; `None` without effects of the
    /// temperature.
    fn reference_temperature_c(&self) -> Option<f64> {
        None
    }

    /// Links that carry the targets of a robot with several branches; empty for a single chain.
    fn branches(&self) -> &[String] {
        &[]
    }

    /// Index of the branch that carries a target. Targets of one branch are a rigid body.
    fn target_branch(&self, _target: usize) -> usize {
        0
    }

    /// Joints that move the base of the chain, and the frame of the measurements with it.
    fn joints_of_base(&self) -> &[String] {
        &[]
    }

    /// All solutions of the inverse kinematics for a position of the only target in the world, as
    /// joint values followed by the assembly mode. `None` for models whose inverse is not valid
    /// everywhere.
    fn inverse_all(&self, _parameters: &[f64], _position: Vector) -> Option<Vec<Vec<f64>>> {
        None
    }

    /// Solution of [`Self::inverse_all`] that is nearest to the joint values `near`, independent of
    /// its limits; `None` if the position is out of reach.
    fn inverse(&self, _parameters: &[f64], _near: &[f64], _position: Vector) -> Option<Vec<f64>> {
        None
    }

    /// Description of the given limit that joint values, followed by the assembly mode, violate,
    /// if any.
    fn limit_violation(&self, _parameters: &[f64], _joints: &[f64]) -> Option<Phrase> {
        None
    }

    /// Range of a joint, by its index, as given in the robot file.
    fn joint_range(&self, _joint: usize) -> JointRange {
        JointRange::Unstated
    }

    /// Nominal motion of a joint per unit of its logged value; differs from 1 if the motor is
    /// logged.
    fn nominal_gain(&self, _joint: usize) -> f64 {
        1.0
    }

    /// The robot as a planar platform whose pose is measured by two targets.
    fn platform(&self) -> Option<&dyn Platform> {
        None
    }

    /// The robot as a table that the geometric method calibrates.
    fn rail_table(&self) -> Option<&dyn RailTable> {
        None
    }

    /// The robot as a spatial robot with an arbitrary base.
    fn free_base(&self) -> Option<&dyn FreeBase> {
        None
    }

    /// The robot with inverse kinematics of a whole pose.
    fn kinematics(&self) -> Option<&dyn Kinematics> {
        None
    }

    /// Places elements that follow from the nominal geometry, such as the frames at which links
    /// tilt; to be called when the nominal values of a robot file have replaced the values of the
    /// model.
    fn settle(&mut self) {}

    /// Joints in sequence, for robots that are a single chain.
    fn joint_chain(&self, _parameters: &[f64]) -> Option<JointChain> {
        None
    }

    /// Motion of a joint at commanded joint values with its own errors: lead, gain, zero,
    /// harmonics, bending (mm or rad). `None` for models whose joints have no such errors.
    fn joint_travel(&self, parameters: &[f64], joints: &[f64], joint: usize) -> Option<f64> {
        let lead = |table: &dyn RailTable| {
            let [x, y] = table.travel(parameters, joint + 1);
            x.hypot(y) * joints[joint]
        };
        let own = || self.free_base()?.joint_value(parameters, joints, joint, &mut |_, _| {});
        self.rail_table().map(lead).or_else(own)
    }

    /// Robots that may be meant instead: robots that the same numbers describe in other
    /// conventions, and published robots of the same build. Each with its description.
    fn alternatives(&self) -> Vec<(Phrase, Box<dyn Robot>)> {
        Vec::new()
    }

    /// Origin of the base in the world (mm); zero for coordinates that the model does not have.
    fn base_origin(&self, parameters: &[f64]) -> Vector {
        let mut origin = [0.0; 3];
        let base = self.parameters().iter().zip(parameters).filter(|(p, _)| p.role == Role::Base);
        for (p, &value) in base.filter(|(p, _)| p.quantity == Quantity::Length) {
            p.axis.into_iter().for_each(|axis| origin[axis] = value);
        }
        origin
    }

    /// Drawings of the model with its parameters, from its nominal geometry.
    fn sketches(&self) -> Vec<Sketch> {
        Vec::new()
    }

    /// The robot as lines in the world at joint values; empty if the joint values admit no pose.
    fn outline(&self, _parameters: &[f64], _joints: &[f64]) -> Outline {
        Outline::default()
    }

    /// Frames of the moving parts in the world at joint values: `base`, and the part behind each
    /// joint by its name, in the frame that the joint moves; empty for a model without such frames.
    fn part_frames(&self, _parameters: &[f64], _joints: &[f64]) -> Vec<(String, Pose)> {
        Vec::new()
    }

    /// Hint at measurements that make these parameters separately identifiable, if the model knows
    /// any.
    fn remedy(&self, _parameters: &[usize]) -> Option<Phrase> {
        None
    }

    /// Parameters of all effects that the robot's description may add.
    fn optional_parameters(&self) -> Vec<OptionalParameter> {
        Vec::new()
    }

    /// Index of a parameter by name.
    fn index(&self, name: &str) -> Option<usize> {
        self.parameters().iter().position(|p| p.name == name)
    }

    /// Nominal values of all parameters.
    fn nominal(&self) -> Vec<f64> {
        self.parameters().iter().map(|p| p.nominal).collect()
    }

    /// Position of one target in space; planar robots have z = 0.
    fn position(&self, parameters: &[f64], joints: &[f64], target: usize) -> Vector {
        let d = self.dimension();
        let mut all = vec![0.0; d * self.targets().len()];
        self.positions(parameters, joints, &mut all);
        let mut p = [0.0; 3];
        p[..d].copy_from_slice(&all[target * d..][..d]);
        p
    }
}

/// A parameter that a key of the description adds for some joints.
#[derive(Clone, Debug, PartialEq)]
pub struct OptionalParameter {
    /// Name of the parameter.
    pub name: String,
    /// Key that adds the parameter.
    pub key: &'static str,
    /// Joints that the key names, by number or name.
    pub joints: Vec<String>,
    /// `true` if the key takes the joints as a pair.
    pub is_pair: bool,
}

/// Computes loads at joint values.
pub type Loads<'a> = Box<dyn Fn(&[f64]) -> Vec<f64> + Send + Sync + 'a>;

/// Joint values with the quantities that depend on them alone.
#[derive(Clone, Copy, Debug)]
pub struct State<'a, J = f64> {
    /// Joint values (rad or mm).
    pub joints: &'a [J],
    /// Loads by [`Robot::loads`].
    pub loads: &'a [J],
}

/// A robot with bound parameters.
pub trait Parametrised: Send + Sync {
    /// Writes positions like [`Robot::positions`].
    fn positions(&self, state: State, out: &mut [f64]);

    /// Writes the Jacobian like [`Robot::jacobian`].
    fn jacobian(&self, state: State, out: &mut [f64]);

    /// Writes positions and joint Jacobian together, like [`Robot::positions`] and
    /// [`Robot::joint_jacobian`].
    fn joint_jacobian(&self, state: State, positions: &mut [f64], out: &mut [f64]);

    /// Calls `write` with the derivatives of target positions: target, parameter, and derivative in
    /// space. Derivatives of a parameter that occurs several times are to be added; omitted
    /// derivatives are zero.
    fn target_derivatives(&self, state: State, targets: &[usize], write: &mut dyn FnMut(usize, usize, Vector));
}

/// Forward kinematics without caching.
struct Anew<'a, R: ?Sized> {
    robot: &'a R,
    parameters: &'a [f64],
}

impl<R: Robot + ?Sized> Parametrised for Anew<'_, R> {
    fn positions(&self, state: State, out: &mut [f64]) {
        self.robot.positions(self.parameters, state.joints, out);
    }
    fn jacobian(&self, state: State, out: &mut [f64]) {
        self.robot.jacobian(self.parameters, state.joints, out);
    }
    fn joint_jacobian(&self, state: State, positions: &mut [f64], out: &mut [f64]) {
        self.robot.positions(self.parameters, state.joints, positions);
        self.robot.joint_jacobian(self.parameters, state.joints, out);
    }
    fn target_derivatives(&self, state: State, targets: &[usize], write: &mut dyn FnMut(usize, usize, Vector)) {
        self.robot.target_derivatives(self.parameters, state.joints, targets, write);
    }
}

/// Joints in sequence with their geometric errors, without bending.
#[derive(Clone, Debug, PartialEq)]
pub struct JointChain {
    /// Joints, starting from the base.
    pub joints: Vec<ChainJoint>,
    /// Flange in the frame of the last joint.
    pub flange: Pose,
}

/// Joint of a chain, which rotates about or slides along the z axis of its frame.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainJoint {
    /// Frame of the joint at joint value zero, relative to the previous joint or the base.
    pub origin: Pose,
    /// `true` if the joint slides.
    pub prismatic: bool,
    /// Motion of the joint per mm or rad of the logged value.
    pub gain: f64,
}

/// Direct and inverse kinematics of the whole pose of flange, platform or tool in the base frame.
/// Poses of planar robots lie in the plane z = 0.
pub trait Kinematics: Robot {
    /// Pose at joint values; `None` if the joint values admit no pose.
    fn tool_pose(&self, parameters: &[f64], joints: &[f64]) -> Option<Pose>;

    /// Pose of the base in the world by the parameters; `None` if the model has no base.
    fn base_in_world(&self, _parameters: &[f64]) -> Option<Pose> {
        None
    }

    /// Kinematics at these parameters as formulas (mm, rad): `direct`, and either `inverse` in
    /// closed form or `linearised` for Newton's method. Empty for models without formulas.
    fn formulas(&self, _parameters: &[f64]) -> Vec<Formula> {
        Vec::new()
    }

    /// Dimensionless measures that are zero at singularities; their signs distinguish
    /// configurations (working and assembly modes).
    fn singularity_measures(&self, _parameters: &[f64], _joints: &[f64]) -> Vec<f64> {
        Vec::new()
    }

    /// All solutions for a pose, as joint values followed by the assembly mode, independent of
    /// their limits; of a family of solutions one. Angles are in (−π, π], or shifted by full turns
    /// into their limits.
    fn all_joints(&self, parameters: &[f64], pose: &Pose) -> Vec<Vec<f64>>;

    /// Permissible solutions for a pose; of a family of solutions the one nearest to `near`.
    ///
    /// # Errors
    ///
    /// Describes the limit that forbids a solution, or the reason why none exists.
    fn solutions(&self, parameters: &[f64], pose: &Pose, _near: &[f64]) -> Result<Vec<Vec<f64>>, Phrase> {
        let all = self.all_joints(parameters, pose);
        let forbidden = all.iter().find_map(|q| self.limit_violation(parameters, q));
        let within: Vec<Vec<f64>> = all.into_iter().filter(|q| self.limit_violation(parameters, q).is_none()).collect();
        if within.is_empty() { Err(forbidden.unwrap_or_else(|| phrase!("out-of-reach"))) } else { Ok(within) }
    }

    /// Permissible solution nearest to the joint values `near`. These are the answer if they attain
    /// the pose. Angles without limits are in (−π, π], or nearest to a start beyond.
    ///
    /// # Errors
    ///
    /// Describes the limit that forbids the nearest solution, or the reason why none exists.
    fn nearest_joints(&self, parameters: &[f64], pose: &Pose, near: &[f64]) -> Result<Vec<f64>, Phrase> {
        if near.len() >= self.joints().len() + usize::from(self.has_assembly_modes())
            && self.tool_pose(parameters, near).is_some_and(|there| is_same(&there, pose))
            && self.limit_violation(parameters, near).is_none()
        {
            return Ok(near.to_vec());
        }
        nearest(self, parameters, self.all_joints(parameters, pose), near)
    }

    /// Joint whose zero a parameter is: both move the tool alike at these joint values and at
    /// others; `None` for other parameters.
    fn zeroed_joint(&self, parameters: &[f64], joints: &[f64], parameter: usize) -> Option<usize> {
        let quantity = self.parameters().get(parameter)?.quantity;
        let mut changed = parameters.to_vec();
        changed[parameter] += ZERO_STEP;
        let count = self.joints().len();
        // joints with one axis at these joint values have different axes at others
        let elsewhere = joints.iter().enumerate().map(|(k, q)| if k < count { q + 0.1 * (k + 1) as f64 } else { *q });
        let states = [joints.to_vec(), elsewhere.collect()];
        let moves_alike = |&joint: &usize| {
            let alike = states.iter().filter_map(|state| {
                let mut moved = state.clone();
                moved[joint] += ZERO_STEP;
                Some(is_near(&self.tool_pose(&changed, state)?, &self.tool_pose(parameters, &moved)?))
            });
            let alike: Vec<bool> = alike.collect();
            !alike.is_empty() && !alike.contains(&false)
        };
        (0..count).filter(|&joint| self.joints()[joint].quantity == quantity).find(moves_alike)
    }

    /// Joints that can move without moving the flange, if the solution at these joint values is one
    /// of a family: the joints of a singular pose, or all joints of a redundant arm.
    fn free_joints(&self, _parameters: &[f64], _joints: &[f64]) -> Vec<usize> {
        Vec::new()
    }
}

/// Change (mm or rad) of a parameter that is compared with the same change of a joint value.
const ZERO_STEP: f64 = 0.01;

/// `true` if two poses of tools some metres away are equal within rounding.
fn is_near(a: &Pose, b: &Pose) -> bool {
    norm(minus(a.translation_mm, b.translation_mm)) <= 1e-8 && a.inverse().then(b).angle_rad() <= 1e-11
}

/// `true` if two poses are equal within rounding.
fn is_same(a: &Pose, b: &Pose) -> bool {
    norm(minus(a.translation_mm, b.translation_mm)) <= 1e-12 && a.inverse().then(b).angle_rad() <= 1e-14
}

/// Names and values of a pose: x, y, z, and the rotation matrix row by row.
fn pose_outputs<T: Scalar>(pose: &Pose<T>) -> Vec<(String, T)> {
    let place = ["x", "y", "z"].map(str::to_owned).into_iter().zip(pose.translation_mm);
    let cells = (0..9).map(|i| (format!("r{}{}", i / 3 + 1, i % 3 + 1), pose.rotation[i / 3][i % 3]));
    place.chain(cells).collect()
}

/// Square root of a difference of quantities of the order of `scale`; zero for a difference that is
/// negative by rounding, as at a stretched leg.
fn root<T: Scalar>(v: T, scale: f64) -> T {
    const ROUNDING: f64 = 1e-13;
    if (-ROUNDING * scale..0.0).contains(&v.value()) { T::from(0.0) } else { v.sqrt() }
}

/// Sum of squares.
fn square<T: Scalar>(v: &[T]) -> T {
    v.iter().fold(T::from(0.0), |sum, v| sum + *v * *v)
}

/// Least-squares solution of rows that end with their right-hand side. Normal equations need no
/// pivots and are free of branches, so that formulas can record them. `damping` is added to the
/// diagonal, as a share of its sum.
fn normal_equations<T: Scalar>(rows: &[Vec<T>], damping: f64) -> impl Iterator<Item = T> {
    let n = rows.first().map_or(0, |row| row.len() - 1);
    let product = |i: usize, j: usize| rows.iter().fold(T::from(0.0), |sum, row| sum + row[i] * row[j]);
    let mut a: Vec<Vec<T>> = (0..n).map(|i| (0..=n).map(|j| product(i, j)).collect()).collect();
    let damped = (0..n).fold(T::from(0.0), |sum, i| sum + a[i][i]) * damping;
    (0..n).for_each(|i| a[i][i] = a[i][i] + damped);
    for k in 0..n {
        let pivot = a[k].clone();
        for (_, row) in a.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot[k];
            (k + 1..=n).for_each(|j| row[j] = row[j] - factor * pivot[j]);
        }
    }
    (0..n).map(move |k| a[k][n] / a[k][k])
}

/// Nearest permissible solution among `all`; 1 m counts as 1 rad, and assembly modes do not count.
fn nearest<R: Robot + ?Sized>(
    robot: &R,
    parameters: &[f64],
    mut all: Vec<Vec<f64>>,
    near: &[f64],
) -> Result<Vec<f64>, Phrase> {
    let scale = |joint: &Joint| if joint.quantity == Quantity::Angle { 1.0 } else { 1.0 / chain::TURNED_MM };
    let scales: Vec<f64> = robot.joints().iter().map(scale).collect();
    let distance =
        |q: &Vec<f64>| q.iter().zip(near).zip(&scales).map(|((a, b), scale)| (scale * (a - b)).powi(2)).sum::<f64>();
    all.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    let violation = |q: &Vec<f64>| robot.limit_violation(parameters, q);
    let why = all.first().and_then(violation);
    let within = all.into_iter().find(|q| violation(q).is_none());
    within.ok_or_else(|| why.unwrap_or_else(|| phrase!("out-of-reach")))
}

/// Distance (deg or mm) of a joint value from its limit that is a rounding error of the solution.
const ROUNDING: f64 = 1e-6;

/// Description of the joint value beyond its limits (rad or mm), if any.
fn limit_violation(joints: &[Joint], limits: &[Option<[f64; 2]>], values: &[f64]) -> Option<Phrase> {
    let beyond = |(joint, (q, limit)): (&Joint, (&f64, &Option<[f64; 2]>))| {
        let [lower, upper] = (*limit)?.map(|v| joint.quantity.outward(v));
        let (q, unit) = (joint.quantity.outward(*q), joint.quantity.unit());
        let name = &joint.name;
        (!(lower - ROUNDING..=upper + ROUNDING).contains(&q))
            .then(|| phrase!("joint-beyond-limits", joint = name, q, unit, lower, upper))
    };
    joints.iter().zip(values.iter().zip(limits)).find_map(beyond)
}

/// Faults in the targets of a spatial robot.
fn wrong_targets(targets: &[String]) -> Faults {
    let mut faults = Faults::default();
    if targets.is_empty() {
        faults.add(At::Nowhere, FaultKind::NoTarget);
    }
    if targets.iter().any(|target| target == "base") {
        faults.add(At::Nowhere, FaultKind::TargetCalledBase);
    }
    faults
}

/// Meaning of the table of limits, common to several models.
const REACH: &str = "Limits of the joints, and of the links of a five-bar. A limit that is not stated does not apply.";

/// Maximum deviation of a pose from the plane (mm or dimensionless).
const PLANAR: f64 = 1e-6;

/// Converts a pose to the plane; `None` if it is out of the plane.
fn in_plane(pose: &Pose) -> Option<PlanarPose> {
    let ([x_mm, y_mm, z_mm], r) = (pose.translation_mm, &pose.rotation);
    let tilted = z_mm.abs() > PLANAR || 1.0 - r[2][2] > PLANAR;
    (!tilted).then(|| PlanarPose { x_mm, y_mm, theta_rad: r[1][0].atan2(r[0][0]) })
}

/// Converts a planar pose to a pose in space.
fn in_space(pose: PlanarPose) -> Option<Pose> {
    let flat = Pose { translation_mm: [pose.x_mm, pose.y_mm, 0.0], ..Pose::identity() };
    let pose = flat.turn_z(pose.theta_rad);
    pose.rotation.as_flattened().iter().chain(&pose.translation_mm).all(|v| v.is_finite()).then_some(pose)
}

/// Position (mm) and orientation (rad) in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarPose<T = f64> {
    /// x in millimetres.
    pub x_mm: T,
    /// y in millimetres.
    pub y_mm: T,
    /// Orientation in radians.
    pub theta_rad: T,
}

/// A platform that moves in the plane, whose pose in the base frame follows from the joints or from
/// two targets.
pub trait Platform: Robot {
    /// Pose at joint values.
    fn pose(&self, parameters: &[f64], joints: &[f64]) -> PlanarPose;

    /// Joint values of a pose, independent of their limits.
    fn joints_at(&self, parameters: &[f64], pose: PlanarPose) -> Vec<f64>;

    /// Transforms a point from the world to the base frame.
    fn in_base(&self, parameters: &[f64], world: [f64; 2]) -> [f64; 2];

    /// Pose measured by the two targets.
    fn measured_pose(&self, parameters: &[f64], targets: [[f64; 2]; 2]) -> PlanarPose;

    /// Estimated minus measured pose (mm, mm, rad).
    fn pose_error(&self, parameters: &[f64], joints: &[f64], targets: [[f64; 2]; 2]) -> [f64; 3];

    /// Derivatives of [`Self::pose_error`] with respect to the parameters: 3 rows of all
    /// parameters.
    fn pose_error_jacobian(&self, parameters: &[f64], joints: &[f64], targets: [[f64; 2]; 2]) -> Vec<f64>;

    /// Derivatives of [`Self::pose_error`] with respect to the coordinates of the targets: 3 rows
    /// of 4. They do not depend on the joints.
    fn pose_error_by_targets(&self, parameters: &[f64], targets: [[f64; 2]; 2]) -> [[f64; 4]; 3];

    /// Index of the parameter for the distance between the two targets, which poses do not
    /// determine.
    fn target_distance(&self) -> usize;
}

/// A platform on carriages on rails, as calibrated by the geometric method (thesis, chapter 2).
pub trait RailTable: Platform {
    /// Travel of each actuator from zero, if given.
    fn travel_mm(&self) -> Option<[f64; 3]>;

    /// Travel of a carriage along x and y per millimetre commanded; the actuator is 1, 2 or 3.
    fn travel(&self, parameters: &[f64], actuator: usize) -> [f64; 2];

    /// Axes of revolute joints 2 and 3 in the world.
    fn pivots(&self, parameters: &[f64], joints: &[f64; 3]) -> [[f64; 2]; 2];

    /// Centre C of the platform in the world.
    fn centre(&self, parameters: &[f64], joints: &[f64; 3]) -> [f64; 2];
}

/// Pose of the base in the world of a robot with a [`FreeBase`]. Its first six parameters are
/// position (mm) and rotation vector (rad).
pub fn base_pose(parameters: &[f64]) -> Pose {
    let [x, y, z, rx, ry, rz] = std::array::from_fn(|i| parameters[i]);
    Pose { translation_mm: [x, y, z], ..Pose::from_rotation_vector([rx, ry, rz]) }
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// First parameters of a robot with a [`FreeBase`].
fn base_and_targets(targets: &[String]) -> Vec<Parameter> {
    let of = |prefix: String, quantity, role| {
        (0..3).map(move |axis| Parameter::free(format!("{prefix}{}", AXES[axis]), quantity, role, axis))
    };
    let base = [(Quantity::Length, "base_"), (Quantity::Angle, "base_r")];
    let base = base.into_iter().flat_map(|(quantity, prefix)| of(prefix.to_owned(), quantity, Role::Base));
    base.chain(targets.iter().flat_map(|target| of(format!("{target}_"), Quantity::Length, Role::Target))).collect()
}

/// A spatial robot whose base and targets are identified. Its first six parameters are `base_x`,
/// `base_y`, `base_z`, `base_rx`, `base_ry`, `base_rz`; three parameters per target follow, its
/// position on the flange.
pub trait FreeBase: Robot {
    /// Pose in the world of the flange that carries a target.
    fn flange(&self, parameters: &[f64], joints: &[f64], target: usize) -> Pose;

    /// Index of the first parameter of a target.
    fn target_place(&self, target: usize) -> usize {
        6 + 3 * target
    }

    /// Motion of a joint at logged joint values with its errors (mm or rad); equals the joint value
    /// at nominal parameters. Calls `write` with the derivatives with respect to parameters, to be
    /// added. `None` for models without such errors.
    fn joint_value(
        &self,
        _parameters: &[f64],
        _joints: &[f64],
        _joint: usize,
        _write: &mut dyn FnMut(usize, f64),
    ) -> Option<f64> {
        None
    }

    /// Writes the rotation of the flange that carries a target per unit of each parameter: rotation
    /// vectors in the world (rad), 3 rows of all parameters.
    fn flange_turns(&self, parameters: &[f64], joints: &[f64], target: usize, out: &mut [f64]);
}
