//! Candidates from a table: poses with joint values, or positions that the robot finds its own joint values for.

use crate::identify::{Observation, stated_modes};
use crate::message::{Message, Result};
use crate::robots::Robot;
use crate::table;
use polars::prelude::DataFrame;
use std::collections::BTreeMap;

/// Configurations that may be measured, in the order of the table: those of one pose stand together.
pub fn configurations(robot: &dyn Robot, table: &DataFrame) -> Result<Vec<Observation>> {
    let poses = table::integers(table, "pose")?;
    let all = if robot.joints().iter().all(|j| table.column(&j.column()).is_err()) && table.column("x_mm").is_ok() {
        from_positions(robot, table, &poses)?
    } else {
        from_joints(robot, table, &poses)?
    };
    if all.is_empty() {
        return Err(Message::error("there are no candidates").into());
    }
    let mut by_pose: BTreeMap<i64, Vec<Observation>> = BTreeMap::new();
    for o in all {
        by_pose.entry(o.pose).or_default().push(o);
    }
    let number = |(k, o): (usize, Observation)| Observation { cycle: k as i64 + 1, ..o };
    Ok(by_pose.into_values().flat_map(|of_pose| of_pose.into_iter().enumerate().map(number)).collect())
}

/// One configuration a row; rows that differ in the target alone are one configuration of several targets.
fn from_joints(robot: &dyn Robot, table: &DataFrame, poses: &[i64]) -> Result<Vec<Observation>> {
    let modes = stated_modes(robot, table)?;
    let names = if table.column("target").is_ok() { Some(table::texts(table, "target")?) } else { None };
    let mut columns = Vec::new();
    for joint in robot.joints() {
        let column = table::numbers(table, &joint.column())?;
        columns.push(column.into_iter().map(|v| joint.quantity.inward(v)).collect::<Vec<f64>>());
    }
    let mut all: Vec<Observation> = Vec::new();
    let mut places = BTreeMap::new();
    for (row, &pose) in poses.iter().enumerate() {
        let mut joints: Vec<f64> = columns.iter().map(|c| c[row]).collect();
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
            all.push(Observation { pose, cycle: 1, joints, targets: vec![seen; robot.targets().len()] });
            all.len() - 1
        });
        if let Some(name) = names.as_ref().map(|n| &n[row]) {
            let target = robot.targets().iter().position(|t| t == name).ok_or_else(|| {
                let message =
                    Message::error(format!("pose {pose} of the candidates: `{name}` is no target of this robot"));
                message.hint_names(name, robot.targets().iter().map(String::as_str))
            })?;
            all[k].targets[target] = Some([0.0; 3]);
        }
    }
    Ok(all)
}

/// Positions of the tool in the world: every way to reach them is a configuration.
fn from_positions(robot: &dyn Robot, table: &DataFrame, poses: &[i64]) -> Result<Vec<Observation>> {
    let nominal = robot.nominal();
    let mut all = Vec::new();
    for (&pose, position) in poses.iter().zip(table::coordinates(table)?) {
        for joints in robot.configurations(&nominal, position) {
            all.push(Observation { pose, cycle: 1, joints, targets: vec![Some(position); robot.targets().len()] });
        }
    }
    if all.is_empty() {
        return Err(Message::error(format!(
            "no position is reached by the `{}`, or its inverse is not known",
            robot.model()
        ))
        .hint("state joint values, one column per joint with its unit")
        .into());
    }
    Ok(all)
}
