//! Pose that a controller displays before and after a file is loaded.

use crate::stages::calibrate::identification::IdentifiedSolution;
use etalon_base::pose::{Pose, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_documents::{DisplayedPose, LoadingCheck, PoseSet};
use etalon_formats::table::ASSEMBLY;
use etalon_robots::{Kinematics, Robot};

/// Displays at the measured pose where these values change the position most; `None` for a robot
/// without kinematics of a whole pose.
pub fn loading_check(robot: &dyn Robot, solution: &IdentifiedSolution, values: &[f64]) -> Option<LoadingCheck> {
    let (arm, nominal) = (robot.kinematics()?, robot.nominal());
    let displays = |joints: &[f64]| Some([arm.tool_pose(&nominal, joints)?, arm.tool_pose(values, joints)?]);
    let change = |[before, after]: &[Pose; 2]| norm(minus(after.translation_mm, before.translation_mm));
    let poses = measured(solution).filter_map(|(pose, joints)| Some((pose, joints, displays(joints)?)));
    let (pose, joints, [before, after]) = poses.max_by(|a, b| change(&a.2).total_cmp(&change(&b.2)))?;
    let (joints, joint_values) = named(arm, joints).unzip();
    Some(LoadingCheck { pose, joints, joint_values, before: displayed(&before), after: displayed(&after) })
}

/// Deciding poses with their joint values.
fn measured(solution: &IdentifiedSolution) -> impl Iterator<Item = (PoseName, &[f64])> {
    let of_set = |set: PoseSet| {
        let (observations, conditions) = solution.sets.observations_and_conditions(set);
        let observed = observations.iter().map(|o| (o.pose, &o.joints[..]));
        observed.chain(conditions.iter().map(|c| (c.pose, &c.joints[..])))
    };
    let validates = of_set(PoseSet::Validation).next().is_some();
    of_set(if validates { PoseSet::Validation } else { PoseSet::Calibration })
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
