//! Pose that a controller displays before and after a file is loaded.

use crate::stages::calibrate::identification::IdentifiedSolution;
use etalon_base::pose::{Pose, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_documents::{DisplayedPose, FileInput, InputsCheck, LoadingCheck, PoseSet, ReadingQuantity};
use etalon_formats::table::ASSEMBLY;
use etalon_formats::tables::joints::stated_columns;
use etalon_robots::{Circumstance, Kinematics, Parameter, Robot, Role};

/// Smallest change (mm) of a position that a display shows.
const SHOWN_MM: f64 = 0.01;

/// Pose of a link by values of the parameters and of the joints.
type Display<'a> = Box<dyn Fn(&[f64], &[f64]) -> Option<Pose> + 'a>;

/// A link with its pose; the only chain of a robot has no name.
struct Displayed<'a> {
    link: Option<String>,
    pose: Display<'a>,
}

/// Displays at the measured pose where these values change the position most; `None` for a robot
/// without kinematics of a whole pose. A display knows joint values alone: no load, no torque, no
/// temperature, no direction of approach, and no tilt of the base.
pub fn loading_check(robot: &dyn Robot, solution: &IdentifiedSolution, values: &[f64]) -> Option<LoadingCheck> {
    let (all, nominal) = (displays(robot), robot.nominal());
    let change = |[before, after]: &[Pose; 2]| norm(minus(after.translation_mm, before.translation_mm));
    let count = robot.joints().len() + usize::from(robot.has_assembly_modes());
    let known = measured(solution).map(|(pose, state)| (pose, &state[..count.min(state.len())]));
    let poses = known.flat_map(|(pose, joints)| all.iter().map(move |display| (pose, joints, display)));
    let shown = poses.filter_map(|(pose, joints, display)| {
        Some((pose, joints, display, [(display.pose)(&nominal, joints)?, (display.pose)(values, joints)?]))
    });
    let (pose, joints, display, [before, after]) = shown.max_by(|a, b| change(&a.3).total_cmp(&change(&b.3)))?;
    let tolerance_mm = rounding_mm(robot, &|joints| (display.pose)(values, joints), joints);
    let mastered = robot.kinematics().and_then(|arm| mastered(arm, [&nominal[..], values], joints));
    let mastered = mastered.map_or_else(Vec::new, |shifted| named(robot, &shifted).map(|(_, value)| value).collect());
    let (joints, joint_values) = named(robot, joints).unzip();
    let with_inputs = with_inputs(robot, solution, &|state| (display.pose)(values, state));
    let (before, after, link) = (displayed(&before), displayed(&after), display.link.clone());
    Some(LoadingCheck {
        pose,
        link,
        joints,
        joint_values,
        before,
        after,
        mastered_joint_values: mastered,
        tolerance_mm,
        with_inputs,
    })
}

/// Pose at the measured pose where the inputs in addition to joint values change the position most;
/// `None` if they change no position by more than the display shows.
fn with_inputs(
    robot: &dyn Robot,
    solution: &IdentifiedSolution,
    pose_at: &dyn Fn(&[f64]) -> Option<Pose>,
) -> Option<InputsCheck> {
    let count = robot.joints().len() + usize::from(robot.has_assembly_modes());
    let known = measured(solution).filter(|(_, state)| state.len() > count && state.iter().all(|v| v.is_finite()));
    let changed = known.filter_map(|(pose, state)| {
        let [at, alone] = [pose_at(state)?, pose_at(&state[..count])?];
        Some((pose, state, at, norm(minus(at.translation_mm, alone.translation_mm))))
    });
    let (pose, state, at, effect_mm) = changed.max_by(|a, b| a.3.total_cmp(&b.3))?;
    if effect_mm < SHOWN_MM {
        return None;
    }
    let directions = robot.approached().iter().map(|&joint| robot.joints()[joint].direction_column());
    let inputs = directions.chain(stated_columns(robot)).zip(state[count..].iter().copied()).collect();
    let joint_values = named(robot, state).map(|(_, value)| value).collect();
    Some(InputsCheck { pose, joint_values, inputs, after: displayed(&at), effect_mm })
}

/// Poses of a robot in its base frame: of its flange, tool link or platform, or of the link at the
/// end of each branch.
fn displays(robot: &dyn Robot) -> Vec<Displayed<'_>> {
    if let Some(arm) = robot.kinematics() {
        return vec![Displayed { link: None, pose: Box::new(|values, joints| arm.tool_pose(values, joints)) }];
    }
    let Some(arm) = robot.free_base() else { return Vec::new() };
    let of_branch = |(branch, link): (usize, &String)| {
        let target = (0..robot.targets().len()).find(|&target| robot.target_branch(target) == branch)?;
        let pose = move |values: &[f64], joints: &[f64]| Some(arm.flange(&without_base(robot, values), joints, target));
        Some(Displayed { link: Some(link.clone()), pose: Box::new(pose) })
    };
    robot.branches().iter().enumerate().filter_map(of_branch).collect()
}

/// Values of the parameters with the base frame as the world.
fn without_base(robot: &dyn Robot, values: &[f64]) -> Vec<f64> {
    let of_base = |p: &Parameter, value: f64| if p.role == Role::Base { 0.0 } else { value };
    robot.parameters().iter().zip(values).map(|(p, &value)| of_base(p, value)).collect()
}

/// Inputs in addition to joint values, on which these values of the parameters depend.
pub fn file_inputs(robot: &dyn Robot, values: &[f64]) -> Vec<FileInput> {
    let is_needed = |stated: Circumstance| {
        robot.parameters().iter().zip(values).any(|(p, value)| *value != 0.0 && p.depends_on(stated))
    };
    let input = |(stated, column): (Circumstance, String)| {
        let quantity = ReadingQuantity::from(stated);
        let neutral = match quantity {
            ReadingQuantity::Temperature => robot.reference_temperature_c().unwrap_or_default(),
            _ => 0.0,
        };
        is_needed(stated).then_some(FileInput { column, quantity, neutral })
    };
    robot.circumstances().iter().copied().zip(stated_columns(robot)).filter_map(input).collect()
}

/// Largest change (mm) of the displayed position that rounding causes: of the announced joint
/// values, and of the display.
fn rounding_mm(robot: &dyn Robot, pose: &dyn Fn(&[f64]) -> Option<Pose>, joints: &[f64]) -> Option<f64> {
    let half = |decimals: usize| 0.5 * 10f64.powi(-i32::try_from(decimals).unwrap_or(i32::MAX));
    let at = pose(joints)?.translation_mm;
    let by_joint = robot.joints().iter().enumerate().filter_map(|(k, joint)| {
        let mut moved = joints.to_vec();
        moved[k] += joint.quantity.inward(half(LoadingCheck::JOINT_DECIMALS));
        Some(norm(minus(pose(&moved)?.translation_mm, at)))
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
fn named(robot: &dyn Robot, values: &[f64]) -> impl Iterator<Item = (String, f64)> {
    let joints = robot.joints();
    let mode = values.get(joints.len()).filter(|_| robot.has_assembly_modes()).map(|mode| (ASSEMBLY.to_owned(), *mode));
    joints.iter().zip(values).map(|(joint, q)| (joint.column(), joint.quantity.outward(*q))).chain(mode)
}

fn displayed(pose: &Pose) -> DisplayedPose {
    DisplayedPose { xyz_mm: pose.translation_mm, quaternion: pose.quaternion() }
}
