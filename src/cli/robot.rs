//! Command `etalon robot`.

use super::kinematics::identified;
use super::{Verdict, print_text, remark};
use crate::run::documents::read_parameters;
use crate::stages::sweeps::not_held;
use etalon_base::message::{Message, Result};
use etalon_base::{error, phrase, warning};
use etalon_campaign::{RobotHead, UrdfJoint, gains_text, read_robot, screws_text, table_text, urdf_text};
use etalon_robots::{JointChain, JointRange, Robot, Role, modified_table, standard_table};
use std::path::PathBuf;

/// Convert the description of a robot.
#[derive(Debug, clap::Args)]
pub struct RobotCommand {
    #[command(subcommand)]
    task: Task,
}

#[derive(Debug, clap::Subcommand)]
enum Task {
    Convert(Convert),
}

/// Write an arm in another convention; what the convention cannot hold is said on stderr.
#[derive(Debug, clap::Args)]
#[command(after_help = "Conventions:
  poe   screw axes: hold every chain exactly
  mdh   modified Denavit-Hartenberg parameters: no free base, no free flange, no angle between near-parallel axes
  dh    standard Denavit-Hartenberg parameters: the same
  urdf  frames of joints: hold every chain exactly; no gains")]
struct Convert {
    /// Robot file.
    robot: PathBuf,
    /// Convention of the answer.
    #[arg(long, value_enum)]
    to: Target,
    /// Identified parameters, which become the geometry; nominal by default.
    #[arg(long, value_name = "FILE")]
    parameters: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Target {
    /// Screw axes (robot.toml).
    Poe,
    /// Modified Denavit-Hartenberg parameters (robot.toml).
    Mdh,
    /// Standard Denavit-Hartenberg parameters (robot.toml).
    Dh,
    /// Unified Robot Description Format.
    Urdf,
}

impl RobotCommand {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let Task::Convert(convert) = self.task;
        let file = read_robot(&convert.robot)?;
        let mut robot = file.build(&file.targets_or("tool"))?;
        if let Some(path) = &convert.parameters {
            let values = identified(robot.as_ref(), &read_parameters(path)?, path)?;
            robot.definition_mut().set_nominal(&values);
        }
        let (text, messages) = converted(robot.as_ref(), convert.to)?;
        remark(&messages);
        print_text(&text)?;
        Ok(Verdict::Met)
    }
}

/// Text of the robot in a convention, and warnings of what it lacks.
fn converted(robot: &dyn Robot, to: Target) -> Result<(String, Vec<Message>)> {
    if !robot.branches().is_empty() {
        return Err(error!("several-branches", links = robot.branches()).into());
    }
    let chain = robot.joint_chain(&robot.nominal());
    let chain = chain.ok_or_else(|| error!("convert-no-chain", model = robot.model()))?;
    if chain.joints.len() != robot.joints().len() {
        let (axes, joints) = (chain.joints.len(), robot.joints().len());
        return Err(error!("convert-shared-joints", axes, joints).into());
    }
    let names: Vec<String> = robot.joints().iter().map(|joint| joint.name.clone()).collect();
    let limits: Vec<Option<[f64; 2]>> = (0..names.len()).map(|j| range(robot, j)).collect();
    let mut comments = vec![phrase!("converted-by").to_string()];
    if to != Target::Urdf {
        let renamed = (1..).zip(&names).filter(|(i, name)| **name != format!("q{i}"));
        comments.extend(renamed.map(|(i, name)| format!("q{i} is {name}")));
    }
    let head = RobotHead { name: robot.model(), comments: &comments, limits: &limits };
    let mut messages = left_out(robot);
    let gains: Vec<f64> = chain.joints.iter().map(|joint| joint.gain).collect();
    let (axes, flange) = chain.axes();
    let text = match to {
        Target::Poe => screws_text(head, &axes, &flange) + &gains_text(&gains),
        Target::Mdh | Target::Dh => {
            let modified = to == Target::Mdh;
            let table = if modified { modified_table(&axes, &flange) } else { standard_table(&axes, &flange) };
            messages.extend(not_held(&table, &names));
            table_text(head, modified, &table) + &gains_text(&gains)
        }
        Target::Urdf => urdf(&chain, head, &names, &mut messages),
    };
    Ok((text, messages))
}

/// Limits of a joint, if they are stated (rad or mm).
fn range(robot: &dyn Robot, joint: usize) -> Option<[f64; 2]> {
    if let JointRange::Limits(ends) = robot.joint_range(joint) { Some(ends) } else { None }
}

/// Warning of effects that no description of axes holds.
fn left_out(robot: &dyn Robot) -> Vec<Message> {
    let own = robot.parameters().iter().filter(|p| p.role == Role::Robot);
    let other = own.filter(|p| !p.effect.is_rigid());
    let names: Vec<&str> = other.map(|p| p.name.as_str()).collect();
    let message = || warning!("convert-left-out", count = names.len(), names = names.join(", "));
    (!names.is_empty()).then(message).into_iter().collect()
}

fn urdf(chain: &JointChain, head: RobotHead, names: &[String], messages: &mut Vec<Message>) -> String {
    let geared: Vec<&str> =
        chain.joints.iter().zip(names).filter(|(joint, _)| joint.gain != 1.0).map(|(_, name)| name.as_str()).collect();
    if !geared.is_empty() {
        messages.push(warning!("convert-gains-not-held", joints = geared.join(", ")));
    }
    let joints: Vec<UrdfJoint> = chain
        .joints
        .iter()
        .zip(names)
        .zip(head.limits)
        .map(|((joint, name), limits)| UrdfJoint {
            name: name.clone(),
            origin: joint.origin,
            prismatic: joint.prismatic,
            limits: *limits,
        })
        .collect();
    let unlimited: Vec<&str> =
        joints.iter().filter(|j| j.prismatic && j.limits.is_none()).map(|j| j.name.as_str()).collect();
    if !unlimited.is_empty() {
        messages.push(warning!("convert-travel-unknown", joints = unlimited.join(", ")));
    }
    urdf_text(head.name, head.comments, &joints, &chain.flange)
}
