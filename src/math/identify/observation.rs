//! Observations: where the targets were, and what the joints said.

use super::assembly::{assign_modes, stated_modes};
use crate::base::message::{Message, Place, Result};
use crate::base::pose::Vector;
use crate::base::table;
use crate::math::robots::{Joint, Robot};
use polars::prelude::DataFrame;

/// One pose of one cycle: joint values and the targets that were measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// Number of the pose.
    pub pose: i64,
    /// Number of the repeat.
    pub cycle: i64,
    /// Joint values in mm or rad, in the robot's order, and behind them the assembly mode of robots that have several.
    pub joints: Vec<f64>,
    /// Measured positions in the world in mm, in the order of the robot's targets; `None` where not measured.
    pub targets: Vec<Option<Vector>>,
}

impl Observation {
    /// Observations of `robot` from the tidy table (one row per pose, cycle and target), in the order of the table.
    ///
    /// Robots with assembly modes may bring several working modes to one pose and cycle: other joint values are then
    /// another observation. What was taken from the measurement is told in `messages`.
    pub fn from_table(robot: &dyn Robot, table: &DataFrame, messages: &mut Vec<Message>) -> Result<Vec<Self>> {
        let needed = ["pose", "cycle", "target", table::XYZ[0], table::XYZ[1]].map(str::to_owned);
        table::require(table, &[&needed[..], &robot.joints().iter().map(Joint::column).collect::<Vec<_>>()].concat())?;
        let poses = table::integers(table, "pose")?;
        let cycles = table::integers(table, "cycle")?;
        let names = table::texts(table, "target")?;
        let xyz = table::coordinates(table)?;
        if robot.dimension() == 3 && table::numbers(table, table::XYZ[2])?.iter().any(|z| z.is_nan()) {
            return Err(Message::error("observations of a robot in space lack `z_mm`").into());
        }
        let mut joints = Vec::new();
        for joint in robot.joints() {
            let column = table::numbers(table, &joint.column())?;
            joints.push(column.into_iter().map(|v| joint.quantity.inward(v)).collect::<Vec<f64>>());
        }
        let stated = stated_modes(robot, table)?;
        let mut observations: Vec<Self> = Vec::new();
        let mut modes = Vec::new();
        let mut place = std::collections::BTreeMap::new();
        let lines = if table.column("line").is_ok() { table::integers(table, "line")? } else { Vec::new() };
        let line = |row: usize| Place { line: lines.get(row).map(|l| *l as usize), ..Place::default() };
        for row in 0..table.height() {
            let what = || format!("pose {} cycle {} of the observations", poses[row], cycles[row]);
            let target = robot.targets().iter().position(|t| *t == names[row]).ok_or_else(|| {
                let message = Message::error(format!("{}: `{}` is no target of this robot", what(), names[row]));
                message.at(line(row)).hint_names(&names[row], robot.targets().iter().map(String::as_str))
            })?;
            let here: Vec<f64> = joints.iter().map(|j| j[row]).collect();
            if here.iter().chain(&xyz[row]).any(|v| !v.is_finite()) {
                let message = Message::error(format!("{}: a value is missing or not a number", what()));
                return Err(message.at(line(row)).into());
            }
            let mode = if robot.has_assembly_modes() { here.iter().map(|q| q.to_bits()).collect() } else { Vec::new() };
            let k = *place.entry((poses[row], cycles[row], mode)).or_insert_with(|| {
                modes.push(stated[row]);
                observations.push(Self {
                    pose: poses[row],
                    cycle: cycles[row],
                    joints: here.clone(),
                    targets: vec![None; robot.targets().len()],
                });
                observations.len() - 1
            });
            if observations[k].joints != here {
                let message = Message::error(format!("{}: its rows disagree on the joint values", what()));
                return Err(message.at(line(row)).into());
            }
            if observations[k].targets[target].replace(xyz[row]).is_some() {
                return Err(Message::error(format!("{}: target `{}` occurs twice", what(), names[row]))
                    .at(line(row))
                    .hint("number repeats in the column `cycle`")
                    .into());
            }
        }
        if observations.is_empty() {
            return Err(Message::error("there are no observations").into());
        }
        if robot.has_assembly_modes() {
            messages.extend(assign_modes(robot, &mut observations, &modes)?);
        }
        Ok(observations)
    }
}
