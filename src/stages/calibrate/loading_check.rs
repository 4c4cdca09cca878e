//! Pose that a controller displays before and after a file is loaded.

use crate::stages::calibrate::identification::IdentifiedSolution;
use etalon_base::pose::{Pose, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_documents::{DisplayedPose, LoadingCheck, PoseSet};
use etalon_formats::table::ASSEMBLY;
use etalon_robots::{Kinematics, Robot, Role};

/// Displays at the measured pose where these values change the position most; `None` for a robot
/// without kinematics of a whole pose. A display knows joint values alone: no load, no torque, no
/// temperature, no direction of approach, and no tilt of the base.
pub fn loading_check(robot: &dyn Robot, solution: &IdentifiedSolution, values: &[f64]) -> Option<LoadingCheck> {
    let (arm, nominal) = (robot.kinematics()?, robot.nominal());
    let displays = |joints: &[f64]| Some([arm.tool_pose(&nominal, joints)?, arm.tool_pose(values, joints)?]);
    let change = |[before, after]: &[Pose; 2]| norm(minus(after.translation_mm, before.translation_mm));
    let count = arm.joints().len() + usize::from(arm.has_assembly_modes());
    let known = measured(solution).map(|(pose, state)| (pose, &state[..count.min(state.len())]));
    let poses = known.filter_map(|(pose, joints)| Some((pose, joints, displays(joints)?)));
    let (pose, joints, [before, after]) = poses.max_by(|a, b| change(&a.2).total_cmp(&change(&b.2)))?;
    let tolerance_mm = rounding_mm(arm, values, joints);
    let mastered_joint_values = match mastered(arm, [&nominal[..], values], joints) {
        Some(shifted) => named(arm, &shifted).map(|(_, value)| value).collect(),
        None => Vec::new(),
    };
    let (joints, joint_values) = named(arm, joints).unzip();
    let (before, after) = (displayed(&before), displayed(&after));
    Some(LoadingCheck { pose, joints, joint_values, before, after, mastered_joint_values, tolerance_mm })
}

/// Largest change (mm) of the displayed position that rounding causes: of the announced joint
/// values, and of the display.
fn rounding_mm(arm: &dyn Kinematics, values: &[f64], joints: &[f64]) -> Option<f64> {
    let half = |decimals: usize| 0.5 * 10f64.powi(-i32::try_from(decimals).unwrap_or(i32::MAX));
    let at = arm.tool_pose(values, joints)?.translation_mm;
    let by_joint = arm.joints().iter().enumerate().filter_map(|(k, joint)| {
        let mut moved = joints.to_vec();
        moved[k] += joint.quantity.inward(half(LoadingCheck::JOINT_DECIMALS));
        Some(norm(minus(arm.tool_pose(values, &moved)?.translation_mm, at)))
    });
    Some(by_joint.sum::<f64>() + 3f64.sqrt() * half(LoadingCheck::DISPLAY_DECIMALS))
}

/// Joint values after the zeros of joints have changed from the nominal values without motion;
/// `None` if other parameters of the robot change too.
fn mastered(arm: &dyn Kinematics, [nominal, values]: [&[f64]; 2], joints: &[f64]) -> Option<Vec<f64>> {
    let mut shifted = joints.to_vec();
    let of_robot = arm.parameters().iter().enumerate().filter(|(_, p)| p.role == Role::Robot);
    for (i, _) in of_robot.filter(|(i, _)| values[*i] != nominal[*i]) {
        shifted[arm.zeroed_joint(nominal, joints, i)?] += values[i] - nominal[i];
    }
    (shifted != joints).then_some(shifted)
}

/// Measured poses with their joint values.
fn measured(solution: &IdentifiedSolution) -> impl Iterator<Item = (PoseName, &[f64])> {
    [PoseSet::Calibration, PoseSet::Validation].into_iter().flat_map(|set| {
        let (observations, conditions) = solution.sets.observations_and_conditions(set);
        let observed = observations.iter().map(|o| (o.pose, &o.joints[..]));
        observed.chain(conditions.iter().map(|c| (c.pose, &c.joints[..])))
    })
}

/// Columns of the joints and of the assembly mode, with their values (mm or deg).
fn named(arm: &dyn Kinematics, values: &[f64]) -> impl Iterator<Item = (String, f64)> {
    let joints = arm.joints();
    let mode = values.get(joints.len()).filter(|_| arm.has_assembly_modes()).map(|mode| (ASSEMBLY.to_owned(), *mode));
    joints.iter().zip(values).map(|(joint, q)| (joint.column(), joint.quantity.outward(*q))).chain(mode)
}

fn displayed(pose: &Pose) -> DisplayedPose {
    DisplayedPose { xyz_mm: pose.translation_mm, quaternion: pose.quaternion() }
}
