//! Reference poses: positions of the flange at a few joint values, which distinguish robots of one
//! model even if their parameters have the same names and nominal values.

use super::{Circumstance, Quantity, Robot, Role};
use etalon_base::pose::Vector;

/// Points on the flange (mm): the origin, and one on each of two axes.
const POINTS: [Vector; 3] = [[0.0; 3], [100.0, 0.0, 0.0], [0.0, 100.0, 0.0]];

/// Number of joint positions.
const POSITIONS: usize = 3;

/// Joint positions that are tried. Lengths of legs grow by a twelfth each time, so that a parallel
/// robot of any size reaches some of them.
const TRIED: usize = 90;

/// Joint values (mm or rad), and the points of the flange there in the frame of the base (mm).
#[derive(Clone, Debug, PartialEq)]
pub struct ReferencePose {
    /// Index of the branch that carries the flange.
    pub branch: usize,
    /// Joint values (mm or rad).
    pub joints: Vec<f64>,
    /// Points at the given parameters (mm).
    pub points_mm: [Vector; 3],
    /// Points with each parameter of the robot increased by 0.1 mm, 0.1 deg or 0.0001: effects
    /// whose parameters are zero show here (mm).
    pub varied_mm: [Vector; 3],
}

/// Reference poses of a robot at parameters, of each branch; fewer where the robot reaches few of
/// the joint positions that are tried.
pub fn reference_poses(robot: &dyn Robot, parameters: &[f64]) -> Vec<ReferencePose> {
    let of_branch = |branch: usize| {
        let pose = move |joints: Vec<f64>| reference_pose(robot, parameters, branch, joints);
        (0..TRIED).filter_map(move |k| pose(tried(robot, k))).take(POSITIONS)
    };
    (0..robot.branches().len().max(1)).flat_map(of_branch).collect()
}

/// Reference pose of a branch at joint values; `None` if the robot has no pose there.
pub fn reference_pose(robot: &dyn Robot, parameters: &[f64], branch: usize, joints: Vec<f64>) -> Option<ReferencePose> {
    let varied: Vec<f64> =
        robot.parameters().iter().zip(parameters).map(|(p, v)| v + step(p.role, p.quantity)).collect();
    let points_mm = points(robot, parameters, branch, &joints)?;
    let varied_mm = points(robot, &varied, branch, &joints)?;
    Some(ReferencePose { branch, joints, points_mm, varied_mm })
}

/// Increase of a parameter (mm, rad or 1).
fn step(role: Role, quantity: Quantity) -> f64 {
    match (role, quantity) {
        (Role::Robot, Quantity::Length) => 0.1,
        (Role::Robot, Quantity::Angle) => 0.1f64.to_radians(),
        (Role::Robot, Quantity::Ratio) => 1e-4,
        (Role::Base | Role::Target | Role::Fixture, _) => 0.0,
    }
}

/// Joint position number `k`: all joints near one value, which differs from position to position.
fn tried(robot: &dyn Robot, k: usize) -> Vec<f64> {
    // multiples of the golden ratio are spread evenly over (-2, 2) rad
    let angle = 4.0 * ((k as f64 + 1.0) * 0.618_033_988_749_895).fract() - 2.0;
    let length = 10.0 * 1.08f64.powi(k as i32);
    let value = |(i, joint): (usize, &super::Joint)| match joint.quantity {
        Quantity::Angle => angle + 0.1 * i as f64,
        Quantity::Length | Quantity::Ratio => length * (1.0 + 0.02 * i as f64),
    };
    robot.joints().iter().enumerate().map(value).collect()
}

/// Points of the flange in the frame of the base.
fn points(robot: &dyn Robot, parameters: &[f64], branch: usize, joints: &[f64]) -> Option<[Vector; 3]> {
    let mut state = joints.to_vec();
    state.extend(robot.has_assembly_modes().then_some(1.0));
    state.extend(robot.approached().iter().map(|_| 1.0));
    state.extend(robot.circumstances().iter().map(|value| match value {
        Circumstance::PayloadMass => 5.0,
        Circumstance::PayloadCentre(_) => 50.0,
        Circumstance::Torque(_) => 20.0,
        Circumstance::Temperature => 30.0,
    }));
    let pose = match robot.kinematics() {
        Some(arm) => arm.tool_pose(parameters, &state)?,
        None => {
            let target = (0..robot.targets().len()).find(|&target| robot.target_branch(target) == branch)?;
            let arm = robot.free_base()?;
            super::base_pose(parameters).inverse().then(&arm.flange(parameters, &state, target))
        }
    };
    let points = POINTS.map(|point| pose.apply(point));
    points.as_flattened().iter().all(|v| v.is_finite()).then_some(points)
}
