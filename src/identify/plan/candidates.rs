//! Candidates from a table: poses with joint values, or positions that the robot finds its own joint values for.

use crate::{Observation, joint_values, stated_modes};
use etalon_base::message::{Message, Result, count};
use etalon_base::pose_name::PoseName;
use etalon_base::table;
use etalon_robots::{Joint, Robot};
use polars::prelude::DataFrame;
use std::collections::BTreeMap;

/// Configurations that may be measured.
#[derive(Clone, Debug)]
pub struct Candidates {
    /// In the order of the table; those of one pose stand together.
    pub observations: Vec<Observation>,
    /// Which are left out because they are out of reach with nominal parameters ([`Robot::limit_violation`]).
    pub beyond: Option<Message>,
}

/// The candidates of a table.
pub fn configurations(robot: &dyn Robot, table: &DataFrame) -> Result<Candidates> {
    let poses = table::poses(table)?;
    let stated = |j: &Joint| table.get_column_names().iter().any(|name| j.factor(name).is_some());
    let by_joints = robot.joints().iter().any(stated) || table.column("x_mm").is_err();
    let all = if by_joints { from_joints(robot, table, &poses)? } else { from_positions(robot, table, &poses)? };
    let nominal = robot.nominal();
    let mut beyond = Vec::new();
    let mut by_pose: BTreeMap<PoseName, Vec<Observation>> = BTreeMap::new();
    for o in all {
        match robot.limit_violation(&nominal, &o.joints) {
            Some(why) => beyond.push(format!("pose {} ({why})", o.pose)),
            None => by_pose.entry(o.pose).or_default().push(o),
        }
    }
    if by_pose.is_empty() {
        let mut message = Message::error("there are no candidates");
        if let Some(first) = beyond.first() {
            message = Message::error(format!("no candidate is within reach: {first}"));
        }
        return Err(message.into());
    }
    let number = |(k, o): (usize, Observation)| Observation { cycle: k as i64 + 1, ..o };
    let observations = by_pose.into_values().flat_map(|of_pose| of_pose.into_iter().enumerate().map(number)).collect();
    Ok(Candidates { observations, beyond: out_of_reach(&beyond) })
}

fn out_of_reach(beyond: &[String]) -> Option<Message> {
    const SHOWN: usize = 5;
    let more = if beyond.len() > SHOWN { ", ..." } else { "" };
    let shown = beyond.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
    let what = format!("{} out of reach, never chosen: {shown}{more}", count(beyond.len(), "configuration"));
    (!beyond.is_empty()).then(|| Message::warning(what))
}

/// One configuration a row; rows that differ in the target alone are one configuration of several targets.
fn from_joints(robot: &dyn Robot, table: &DataFrame, poses: &[PoseName]) -> Result<Vec<Observation>> {
    let modes = stated_modes(robot, table)?;
    let names = if table.column("target").is_ok() { Some(table::texts(table, "target")?) } else { None };
    let values = joint_values(robot, table, &[])?;
    let mut all: Vec<Observation> = Vec::new();
    let mut places = BTreeMap::new();
    for (row, (&pose, mut joints)) in poses.iter().zip(values).enumerate() {
        if joints.iter().any(|q| !q.is_finite()) {
            return Err(Message::error(format!(
                "pose {pose} of the candidates: a joint value is missing or not a number"
            ))
            .into());
        }
        if robot.has_assembly_modes() {
            joints.push(modes[row].ok_or_else(|| {
                Message::error(format!("pose {pose} of the candidates does not state its assembly mode"))
                    .expected("1 or -1 in the column `assembly`")
                    .hint("candidates may also be positions: `pose,x_mm,y_mm` without joints gives all working modes")
            })?);
        }
        let key = (pose, joints.iter().map(|q| q.to_bits()).collect::<Vec<_>>());
        let k = *places.entry(key).or_insert_with(|| {
            let seen = if names.is_some() { None } else { Some([0.0; 3]) };
            all.push(Observation {
                pose,
                cycle: 1,
                joints,
                targets: vec![seen; robot.targets().len()],
                ..Observation::default()
            });
            all.len() - 1
        });
        if let Some(name) = names.as_ref().map(|n| &n[row]) {
            let target = robot.targets().iter().position(|t| t == name).ok_or_else(|| {
                let message =
                    Message::error(format!("pose {pose} of the candidates: `{name}` is not a target of this robot"));
                message.hint_names(name, robot.targets().iter().map(String::as_str))
            })?;
            all[k].targets[target] = Some([0.0; 3]);
        }
    }
    Ok(all)
}

/// Positions of the tool in the world: every way to reach them is a configuration.
fn from_positions(robot: &dyn Robot, table: &DataFrame, poses: &[PoseName]) -> Result<Vec<Observation>> {
    let nominal = robot.nominal();
    let mut all = Vec::new();
    for (&pose, position) in poses.iter().zip(table::coordinates(table)?) {
        for joints in robot.inverse_all(&nominal, position).unwrap_or_default() {
            all.push(Observation {
                pose,
                cycle: 1,
                joints,
                targets: vec![Some(position); robot.targets().len()],
                ..Observation::default()
            });
        }
    }
    if all.is_empty() {
        return Err(Message::error(format!(
            "no position is reached by the `{}`, or the model has no inverse",
            robot.model()
        ))
        .hint("state joint values, one column per joint with its unit")
        .into());
    }
    Ok(all)
}
