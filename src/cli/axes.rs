//! Command `etalon axes`.

use super::text_format::TableFormat;
use super::{Verdict, check_positive, print, print_text, remark};
use crate::stages::sweeps::{self, SweepsStated, TableConvention};
use etalon_documents::{AxesDocument, AxisEntry, to_json};
use std::fmt::Write;
use std::path::PathBuf;

/// Find the axes of joints from sweeps of one joint at a time, and a robot without a nominal model
/// (circle-point analysis).
#[derive(Debug, clap::Args)]
#[command(after_help = "Table:
  joint (the swept joint; empty in rows of check poses), x_mm, y_mm, z_mm, target,
  and, if known, the values of all joints (q1_deg or q1_rad, lift_mm or lift_m ...)

Without joint values, every sweep must start from the pose in which joint values are zero, and run in
positive direction.")]
pub struct AxesCommand {
    /// Table of the sweeps (CSV).
    table: PathBuf,
    /// Joints from the base; by default in the order of their numbers (q1, q2 ...).
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    joints: Vec<String>,
    /// Prismatic joints without a column of joint values, whose unit would show it; all others are
    /// revolute.
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    prismatic: Vec<String>,
    /// Joints that were swept in negative direction, without joint values.
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    backwards: Vec<String>,
    /// Standard uncertainty (k = 1) of a measured coordinate in micrometres; by default from the
    /// residuals of each sweep.
    #[arg(long, value_name = "UM")]
    standard_uncertainty_um: Option<f64>,
    /// Convention of robot.toml.
    #[arg(long, value_enum, default_value_t)]
    convention: TableConvention,
    /// Print robot.toml instead of the axes.
    #[arg(long, conflicts_with = "json")]
    toml: bool,
    #[command(flatten)]
    format: TableFormat,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

impl AxesCommand {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        check_positive("--standard-uncertainty-um", self.standard_uncertainty_um)?;
        let file = self.format.read_poses(&self.table)?;
        let stated = SweepsStated {
            joints: self.joints,
            prismatic: self.prismatic,
            backwards: self.backwards,
            standard_uncertainty_mm: self.standard_uncertainty_um.map(|u| u / 1000.0),
            convention: self.convention,
        };
        let document = sweeps::axes(&file, &stated)?;
        if !self.json {
            remark(&document.messages);
        }
        match (self.json, self.toml) {
            (true, _) => print(to_json(&document)?)?,
            (false, false) => print_text(&text(&document))?,
            (false, true) => match &document.robot {
                Some(robot) => print_text(&robot.robot_toml)?,
                None => return Ok(Verdict::NotRun),
            },
        }
        Ok(Verdict::Met)
    }
}

/// Axes as text.
fn text(document: &AxesDocument) -> String {
    let mut text = String::new();
    document.axes.iter().for_each(|axis| axis_text(axis, &mut text));
    if let Some(robot) = &document.robot {
        let at = robot.base_xyz_mm;
        let _ = writeln!(text, "base ({})\n  origin       {}", robot.base_rule, vector(&at, 4, " mm"));
        for target in &robot.targets {
            let u = target.standard_uncertainty_mm.iter().map(|u| u * u).sum::<f64>().sqrt();
            let at = vector(&target.xyz_mm, 4, " mm");
            let _ = writeln!(text, "target `{}` on the flange\n  point        {at}  (u = {u:.4} mm)", target.target);
        }
    }
    for check in &document.checks {
        let (d, u) = (check.distance_mm, check.standard_uncertainty_mm);
        let _ =
            writeln!(text, "check pose, line {}: {d:.4} mm from the robot  (u = {u:.4} mm a component)", check.line);
    }
    text
}

fn vector(v: &[f64; 3], decimals: usize, unit: &str) -> String {
    format!("{:.*} {:.*} {:.*}{unit}", decimals, v[0], decimals, v[1], decimals, v[2])
}

fn axis_text(axis: &AxisEntry, text: &mut String) {
    let kind = if axis.prismatic { "slides" } else { "turns" };
    let aside = if axis.set_aside.is_empty() { String::new() } else { format!(", {} set aside", axis.set_aside.len()) };
    let _ = writeln!(text, "{} {kind}: {} readings{aside}", axis.joint, axis.readings);
    let u = axis.direction_standard_uncertainty_deg;
    let _ = writeln!(text, "  direction    {}  (u = {u:.5} deg)", vector(&axis.direction, 7, ""));
    if let Some(u) = axis.point_standard_uncertainty_mm {
        let _ = writeln!(text, "  point        {}  (u = {u:.4} mm)", vector(&axis.point_mm, 4, " mm"));
    }
    for path in &axis.paths {
        let _ = match (path.radius_mm, path.radius_standard_uncertainty_mm, path.arc_deg) {
            (Some(radius), Some(u), Some(arc)) => {
                writeln!(text, "  `{}`  radius {radius:.4} mm (u = {u:.4} mm), arc {arc:.1} deg", path.target)
            }
            _ => writeln!(text, "  `{}`  length {:.2} mm", path.target, path.length_mm.unwrap_or_default()),
        };
        let [radial, face] = [path.radial_error_motion_mm, path.face_error_motion_mm].map(|v| 1000.0 * v);
        let names = if axis.prismatic { ["straightness", "and"] } else { ["radial error motion", "face error motion"] };
        let _ = writeln!(text, "    {} {radial:.1} um, {} {face:.1} um", names[0], names[1]);
    }
    if let (Some(axial), Some(tilt)) = (axis.axial_error_motion_mm, axis.tilt_error_motion_deg) {
        let _ = writeln!(text, "  axial error motion {:.1} um, tilt error motion {tilt:.5} deg", 1000.0 * axial);
    }
    if let (Some(ratio), Some(rms)) = (axis.ratio, axis.motion_rms) {
        let unit = if axis.prismatic { "mm" } else { "deg" };
        let _ = writeln!(text, "  motion       {ratio:.6} x joint value, difference {rms:.5} {unit} (rms)");
    }
}
