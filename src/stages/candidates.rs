//! Candidates of a table: poses with joint values, or positions for which the robot computes joint
//! values.

use crate::stages::remedies::remedied;
use etalon_base::message::Result;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use etalon_formats::table::{Table, XYZ};
use etalon_formats::tables::joints::{joint_values, stated_modes};
use etalon_identify::Observation;
use etalon_identify::plan::candidates::{Candidates, within_limits};
use etalon_robots::{Joint, Robot};
use std::collections::BTreeMap;

/// Candidates of a table within the reach of the robot.
pub fn configurations(robot: &dyn Robot, table: &Table) -> Result<Candidates> {
    let poses = table.poses()?;
    let stated = |j: &Joint| table.names().any(|name| j.factor(name).is_some());
    let by_joints = robot.joints().iter().any(stated) || !table.has(XYZ[0]);
    let all = if by_joints { from_joints(robot, table, &poses)? } else { from_positions(robot, table, &poses)? };
    within_limits(robot, all).map_err(remedied)
}

/// One configuration a row; rows that differ only in the target are one configuration of several
/// targets.
fn from_joints(robot: &dyn Robot, table: &Table, poses: &[PoseName]) -> Result<Vec<Observation>> {
    let modes = stated_modes(robot, table)?;
    let names = table.has("target").then(|| table.texts("target")).transpose()?;
    let values = joint_values(robot, table, &[])?;
    let mut all: Vec<Observation> = Vec::new();
    let mut places = BTreeMap::new();
    for (row, (&pose, mut joints)) in poses.iter().zip(values).enumerate() {
        if joints.iter().any(|q| !q.is_finite()) {
            return Err(error!("joint-value-missing").within(phrase!("in-candidate", pose)).into());
        }
        if robot.has_assembly_modes() {
            joints
                .push(modes[row].ok_or_else(|| error!("assembly-mode-missing").within(phrase!("in-candidate", pose)))?);
        }
        let key = (pose, joints.iter().map(|q| q.to_bits()).collect::<Vec<_>>());
        let k = *places.entry(key).or_insert_with(|| {
            let seen = if names.is_some() { None } else { Some([0.0; 3]) };
            let targets = vec![seen; robot.targets().len()];
            all.push(Observation { pose, cycle: 1, joints, targets, ..Observation::default() });
            all.len() - 1
        });
        if let Some(name) = names.as_ref().map(|n| &*n[row]) {
            let target = robot.targets().iter().position(|t| t == name).ok_or_else(|| {
                let message = error!("not-of-this-robot", name, kind = "target");
                let message = message.within(phrase!("in-candidate", pose));
                message.hint_names(name, robot.targets().iter().map(String::as_str))
            })?;
            all[k].targets[target] = Some([0.0; 3]);
        }
    }
    Ok(all)
}

/// Positions of the tool in the world: every solution is a configuration.
fn from_positions(robot: &dyn Robot, table: &Table, poses: &[PoseName]) -> Result<Vec<Observation>> {
    let nominal = robot.nominal();
    let mut all = Vec::new();
    for (&pose, position) in poses.iter().zip(table.positions()?) {
        for joints in robot.inverse_all(&nominal, position).unwrap_or_default() {
            let targets = vec![Some(position); robot.targets().len()];
            all.push(Observation { pose, cycle: 1, joints, targets, ..Observation::default() });
        }
    }
    if all.is_empty() {
        return Err(error!("candidate-positions-unreachable", model = robot.model()).into());
    }
    Ok(all)
}
