//! Command `etalon robot`.

use super::{Output, Verdict};
use crate::run::documents::read_parameters;
use crate::stages::sweeps::not_held;
use crate::tasks::kinematics::identified;
use etalon_base::message::{Message, Result};
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, minus, norm};
use etalon_base::{error, phrase, warning};
use etalon_campaign::{
    RobotHead, UrdfJoint, nominal_text, parse_robot, parse_urdf_robot, read_robot, screws_text, table_text, urdf_text,
};
use etalon_robots::{AxisTable, ChainJoint, JointChain, JointRange, Robot, Role, TableConvention};
use std::f64::consts::PI;
use std::path::{Path, PathBuf};

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

/// Write an arm in another convention; a warning lists what the convention cannot express.
#[derive(Debug, clap::Args)]
#[command(after_help = "Conventions:
  poe   screw axes: hold every chain exactly
  mdh   modified Denavit-Hartenberg parameters: hold the axes exactly; no free base, no free flange
  dh    standard Denavit-Hartenberg parameters: the same
  urdf  frames of joints: hold every chain exactly; no gains

The answer is read again and compared with the robot at drawn joint values before it is printed.")]
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
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let Task::Convert(convert) = self.task;
        let file = read_robot(&convert.robot)?;
        let mut robot = file.build(&file.targets_or("tool"))?;
        if let Some(path) = &convert.parameters {
            let values = identified(robot.as_ref(), &read_parameters(path)?, path)?;
            robot.definition_mut().set_nominal(&values);
        }
        let (text, messages) = converted(robot.as_ref(), convert.to)?;
        out.remark(&messages);
        out.print_text(&text)?;
        Ok(Verdict::Met)
    }
}

/// Text of the robot in a convention, and warnings about what it cannot express.
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
    let mut messages = left_out(robot);
    let gains: Vec<f64> = chain.joints.iter().map(|joint| joint.gain).collect();
    let chain = chain.near_arm();
    let (axes, flange) = chain.axes();
    let convention = match to {
        Target::Mdh => Some(TableConvention::Modified),
        Target::Dh => Some(TableConvention::Standard),
        Target::Poe | Target::Urdf => None,
    };
    let table = convention.map(|convention| convention.table(&axes, &flange));
    comments.extend(table.iter().flat_map(constant_frames));
    let head = RobotHead { name: robot.model(), comments: &comments, limits: &limits };
    let text = match (to, convention.zip(table.as_ref())) {
        (Target::Urdf, _) => urdf(&chain, head, &names, &mut messages),
        (_, None) => screws_text(head, &axes, &flange) + &nominal_text(&gains, &[]),
        (_, Some((convention, table))) => {
            messages.extend(not_held(table));
            table_text(head, convention, table) + &nominal_text(&gains, &table.tilts)
        }
    };
    let [base, end] = table.map_or([Pose::identity(); 2], |table| [table.base, table.flange]);
    let read = |q: &[f64], again: &JointChain| base.then(&again.flange_at(q)).then(&end);
    compare(&chain, &limits, &again(&text, to)?, &read)?;
    Ok((text, messages))
}

/// Comments with the constant frames of a table that are not the base and the flange of the robot.
fn constant_frames(table: &AxisTable) -> impl Iterator<Item = String> {
    let listed = |pose: &Pose| {
        let rpy_deg = pose.rpy_rad().map(f64::to_degrees);
        [pose.translation_mm, rpy_deg].map(|v| v.map(|v| format!("{v:.9}")).join(" "))
    };
    let moved = |pose: &Pose| *pose != Pose::identity();
    let base = Some(table.base).filter(moved).map(|pose| {
        let [xyz_mm, rpy_deg] = listed(&pose);
        phrase!("convert-base-of-table", xyz_mm, rpy_deg).to_string()
    });
    let flange = Some(table.flange).filter(moved).map(|pose| {
        let [xyz_mm, rpy_deg] = listed(&pose);
        phrase!("convert-flange-of-table", xyz_mm, rpy_deg).to_string()
    });
    base.into_iter().chain(flange)
}

/// Reads the text of a converted robot, as etalon reads its file.
fn again(text: &str, to: Target) -> Result<JointChain> {
    let file = match to {
        Target::Urdf => parse_urdf_robot(text, ["base_link", "tool"])?,
        _ => parse_robot(Path::new("stdout"), text)?,
    };
    let robot = file.build(&["tool".to_owned()])?;
    let chain = robot.joint_chain(&robot.nominal());
    chain.ok_or_else(|| error!("convert-no-chain", model = robot.model()).into())
}

/// Number of drawn joint values at which a converted robot is compared with the robot, and seed of
/// the draws.
const COMPARED: usize = 50;
const SEED: u64 = 59;
/// Travel (mm) of a prismatic joint without limits in the comparison.
const TRAVEL_MM: f64 = 500.0;
/// Maximum difference of positions (mm) and of orientations (rad) by rounding of the text.
const LARGEST_MM: f64 = 1e-5;
const LARGEST_RAD: f64 = 1e-8;

/// Compares a robot with its converted description at drawn joint values within the limits.
///
/// # Errors
/// Fails if the flanges differ by more than rounding.
fn compare(
    chain: &JointChain,
    limits: &[Option<[f64; 2]>],
    again: &JointChain,
    read: &dyn Fn(&[f64], &JointChain) -> Pose,
) -> Result<()> {
    // a URDF has no gains
    let gains: Vec<f64> = chain.joints.iter().zip(&again.joints).map(|(one, two)| one.gain / two.gain).collect();
    let (mut noise, mut largest) = (Noise::new(SEED, 0), [0.0_f64; 2]);
    for _ in 0..COMPARED {
        let draw = |(joint, limit): (&ChainJoint, &Option<[f64; 2]>)| {
            let free = if joint.prismatic { TRAVEL_MM } else { PI };
            let stated = limit.filter(|ends| ends.iter().all(|v| v.is_finite()));
            let [lower, upper] = stated.unwrap_or([-free, free]);
            0.5 * (lower + upper) + noise.uniform(0.5 * (upper - lower))
        };
        let q: Vec<f64> = chain.joints.iter().zip(limits).map(draw).collect();
        let turned: Vec<f64> = q.iter().zip(&gains).map(|(q, gain)| q * gain).collect();
        let (one, two) = (chain.flange_at(&q), read(&turned, again));
        let off_mm = norm(minus(one.translation_mm, two.translation_mm));
        largest = [largest[0].max(off_mm), largest[1].max(one.inverse().then(&two).angle_rad())];
    }
    let [off_mm, off_rad] = largest;
    if off_mm <= LARGEST_MM && off_rad <= LARGEST_RAD {
        return Ok(());
    }
    Err(error!("convert-not-reproduced", off_mm, off_deg = off_rad.to_degrees()).into())
}

/// Limits of a joint, if it has limits (rad or mm).
fn range(robot: &dyn Robot, joint: usize) -> Option<[f64; 2]> {
    if let JointRange::Limits(ends) = robot.joint_range(joint) { Some(ends) } else { None }
}

/// Warning about effects that no description of axes can express.
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
