//! Command `etalon kinematics`.

use super::{Output, Verdict};
use crate::run::documents::read_loaded_parameters;
use crate::stages::observe::joint_range::{self, Joints};
use crate::stages::table_file::TableFile;
use crate::tasks::kinematics::identified;
use crate::tasks::{Arm, Table, TableFormat, inverse, whole_pose};
use etalon_base::cell;
use etalon_base::message::{Problems, Result};
use etalon_base::pose::Pose;
use etalon_base::{error, phrase, warning};
use etalon_campaign::read_robot;
use etalon_documents::{KinematicsDocument, KinematicsEntry, UnreachablePose, to_json};
use etalon_formats::table::{ASSEMBLY, QUATERNION, XYZ};
use etalon_formats::tables::joints::{joint_column, stated_modes};
use etalon_robots::{Kinematics, Role};
use std::path::PathBuf;

/// Tolerance of a quaternion's length: the file contains only a few decimals.
const LENGTH_ONE: f64 = 1e-3;

/// Compute poses of the tool from joint values, or joint values from poses.
///
/// Poses describe flange, tool link, platform or tool in the robot's base frame.
#[derive(Debug, clap::Args)]
#[command(after_help = "Tables:
  direct   pose and the joints (q1_deg or q1_rad, lift_m ...); assembly (+1 or -1) of a five-bar
  inverse  pose, x_mm, y_mm, z_mm, qw, qx, qy, qz; joint values of a row select its --nearest solution

At a singular pose joints can move without moving the tool: stderr names them, and the answer has the solution nearest to the start.
Exit code 1 if a pose is out of reach; the answer contains the other poses.")]
pub struct KinematicsCommand {
    /// Direction of the computation.
    #[arg(value_enum)]
    direction: Direction,
    /// Table of joint values or poses (CSV).
    table: PathBuf,
    /// Robot file.
    #[arg(long, value_name = "FILE")]
    robot: PathBuf,
    /// Identified parameters; nominal by default.
    #[arg(long, value_name = "FILE")]
    parameters: Option<PathBuf>,
    /// Controller file of the run of these parameters, or a copy of it, whose values are used: the
    /// display of the controller after loading.
    #[arg(long, value_name = "FILE", requires = "parameters")]
    loaded: Option<PathBuf>,
    /// One solution per pose: the nearest to the joints of its row, or of the previous row.
    #[arg(long)]
    nearest: bool,
    #[command(flatten)]
    format: TableFormat,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Direction {
    /// Joint values to poses.
    Direct,
    /// Poses to joint values.
    Inverse,
}

impl KinematicsCommand {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        // the model needs a target, whose position differs from the tool's
        let file = read_robot(&self.robot)?;
        let robot = file.build(&file.targets_or("tool"))?;
        let mut values = robot.nominal();
        if let Some(path) = &self.parameters {
            let document = read_loaded_parameters(path, self.loaded.as_deref())?;
            values = identified(robot.as_ref(), &document, path)?;
            // the display of a controller knows no tilt of its base, which gravity acts on
            let parameters = robot.parameters().iter().zip(&mut values).filter(|_| self.loaded.is_some());
            parameters.filter(|(p, _)| p.role == Role::Base).for_each(|(p, value)| *value = p.nominal);
        }
        let arm = Arm { model: whole_pose(robot.as_ref())?, values: &values };
        let file = self.format.read_other(Table::File(&self.table))?;
        let mut document = KinematicsDocument {
            schema: "etalon/kinematics/1".to_owned(),
            robot: arm.model.model().to_owned(),
            joints: joint_names(arm.model),
            poses: Vec::new(),
            unreachable: Vec::new(),
        };
        match self.direction {
            Direction::Direct => direct(arm, &file, &mut document),
            Direction::Inverse => self.inverse(arm, &file, &mut document),
        }
        .map_err(|problems| file.place(problems))?;
        let said = |u: &UnreachablePose| warning!("pose-unreachable", pose = u.pose, reason = u.reason);
        let families = document.poses.iter().filter(|entry| !entry.free_joints.is_empty());
        let families = families.map(|entry| warning!("pose-singular", pose = entry.pose, joints = entry.free_joints));
        out.remark(&document.unreachable.iter().map(said).chain(families).collect::<Vec<_>>());
        let verdict = Verdict::new(document.unreachable.is_empty());
        let inverse = self.direction == Direction::Inverse;
        let answer = if self.json { to_json(&document)? } else { csv(&document, inverse).into_bytes() };
        out.print_with(answer, verdict)
    }

    fn inverse(&self, arm: Arm, file: &TableFile, document: &mut KinematicsDocument) -> Result<()> {
        let (Arm { model, values }, names) = (arm, file.table.poses()?);
        let starts = starts(model, file)?.unwrap_or_default();
        let poses = poses(model, file)?;
        let solutions = inverse(arm, &poses, &starts, self.nearest)?;
        for ((pose, name), found) in poses.iter().zip(names).zip(solutions) {
            let found = found.unwrap_or_else(|reason| {
                document.unreachable.push(UnreachablePose::new(name, reason));
                Vec::new()
            });
            // each pose of a redundant arm leaves joints free
            let redundant = model.joints().len() > 6;
            for joints in found {
                let free = if redundant { Vec::new() } else { model.free_joints(values, &joints) };
                let free_joints = free.into_iter().map(|joint| model.joints()[joint].name.clone()).collect();
                document.poses.push(KinematicsEntry { free_joints, ..entry(model, name, &joints, pose) });
            }
        }
        Ok(())
    }
}

/// Columns of joint values and of the assembly mode.
pub(super) fn joint_names(arm: &dyn Kinematics) -> Vec<String> {
    let modes = arm.has_assembly_modes().then(|| ASSEMBLY.to_owned());
    arm.joints().iter().map(|joint| joint.column()).chain(modes).collect()
}

/// Joint values of a table (rad or mm), row by row, followed by the assembly mode.
pub(super) fn joint_values(arm: &dyn Kinematics, file: &TableFile) -> Result<Vec<Vec<f64>>> {
    let columns: Vec<(String, f64)> =
        arm.joints().iter().map(|joint| joint_column(joint, &file.table)).collect::<Result<_>>()?;
    file.table.require(columns.iter().map(|(name, _)| name))?;
    let mut rows = vec![Vec::new(); file.table.height()];
    for (column, factor) in columns {
        for (row, value) in rows.iter_mut().zip(file.table.numbers(&column)?) {
            row.push(factor * value);
        }
    }
    if arm.has_assembly_modes() {
        file.table.require([ASSEMBLY])?;
        for (row, mode) in rows.iter_mut().zip(stated_modes(arm, &file.table)?) {
            row.push(mode.unwrap_or(f64::NAN));
        }
    }
    complete(file, &rows)?;
    joint_range::check_table(arm, &file.table, &[], Joints::Proposed)?;
    Ok(rows)
}

/// Checks that all values are finite.
fn complete(file: &TableFile, rows: &[Vec<f64>]) -> Result<()> {
    let odd = rows.iter().enumerate().filter(|(_, row)| row.iter().any(|v| !v.is_finite()));
    let message = |(i, _)| error!("table-value-missing").at(file.table.place(i));
    Problems(odd.map(message).collect()).check().map(drop)
}

/// Starting points of the search for solutions: the joints of the table, if any.
pub(super) fn starts(arm: &dyn Kinematics, file: &TableFile) -> Result<Option<Vec<Vec<f64>>>> {
    let has = arm.joints().iter().any(|joint| file.table.names().any(|name| joint.factor(name).is_some()));
    has.then(|| joint_values(arm, file)).transpose()
}

/// Poses of a table.
pub(super) fn poses(arm: &dyn Kinematics, file: &TableFile) -> Result<Vec<Pose>> {
    let planar = arm.dimension() == 2;
    let needed: &[&str] = if planar { &XYZ[..2] } else { &XYZ };
    let turned = QUATERNION.iter().any(|name| file.table.has(name)) || arm.platform().is_some() || !planar;
    let quaternion: &[&str] = if turned { &QUATERNION } else { &[] };
    file.table.require(needed.iter().chain(quaternion))?;
    let xyz = file.table.positions()?;
    let mut columns = Vec::new();
    for name in quaternion {
        columns.push(file.table.numbers(name)?);
    }
    let number = |(i, at): (usize, &[f64; 3])| {
        at.iter().copied().chain(columns.iter().map(|column| column[i])).collect::<Vec<f64>>()
    };
    let rows: Vec<Vec<f64>> = xyz.iter().enumerate().map(number).collect();
    complete(file, &rows)?;
    let mut problems = Problems::default();
    let pose = |(i, row): (usize, &Vec<f64>)| {
        let q = [3, 4, 5, 6].map(|i| row.get(i).copied().unwrap_or(if i == 3 { 1.0 } else { 0.0 }));
        let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
        if (length - 1.0).abs() > LENGTH_ONE {
            problems.0.push(error!("table-quaternion-length", length).at(file.table.place(i)));
        }
        Pose { translation_mm: [row[0], row[1], row[2]], ..Pose::from_quaternion(q) }
    };
    let poses = rows.iter().enumerate().map(pose).collect();
    problems.check().map(|_| poses)
}

fn direct(arm: Arm, file: &TableFile, document: &mut KinematicsDocument) -> Result<()> {
    let (Arm { model, values }, names) = (arm, file.table.poses()?);
    for (pose, joints) in names.into_iter().zip(joint_values(model, file)?) {
        match model.tool_pose(values, &joints) {
            Some(at) => {
                document.poses.push(entry(model, pose, &joints, &at));
                let reason = model.limit_violation(values, &joints);
                document.unreachable.extend(reason.map(|reason| UnreachablePose::new(pose, reason)));
            }
            None => {
                document.unreachable.push(UnreachablePose::new(pose, phrase!("joints-admit-no-pose")));
            }
        }
    }
    Ok(())
}

fn entry(arm: &dyn Kinematics, pose: etalon_base::pose_name::PoseName, joints: &[f64], at: &Pose) -> KinematicsEntry {
    let outward = arm.joints().iter().zip(joints).map(|(joint, &q)| joint.quantity.outward(q));
    let joints = outward.chain(joints.get(arm.joints().len()).copied()).collect();
    let (xyz_mm, quaternion) = (at.translation_mm, at.quaternion());
    KinematicsEntry { pose, joints, xyz_mm, quaternion, free_joints: Vec::new() }
}

/// Answer as a table: poses, or joint values.
fn csv(document: &KinematicsDocument, inverse: bool) -> String {
    let mut out = "pose".to_owned();
    let columns: Vec<&str> = match inverse {
        true => document.joints.iter().map(String::as_str).collect(),
        false => XYZ.iter().chain(&QUATERNION).copied().collect(),
    };
    columns.iter().for_each(|name| out += &format!(",{name}"));
    out.push('\n');
    for row in &document.poses {
        let values: Vec<f64> = match inverse {
            true => row.joints.clone(),
            false => row.xyz_mm.iter().chain(&row.quaternion).copied().collect(),
        };
        out += &cell(&row.pose.to_string());
        values.iter().for_each(|v| out += &format!(",{v:?}"));
        out.push('\n');
    }
    out
}

/// Escapes a text for a cell of a CSV table.
pub(super) fn cell(text: &str) -> String {
    let text = cell::cell(text);
    if text.contains([',', '"', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}
