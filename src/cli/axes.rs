//! Command `etalon axes`.

use super::{Output, Verdict};
use crate::tasks::{AxesOptions, Table, axes};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Severity;
use etalon_base::phrase;
use etalon_documents::{AxesDocument, AxisEntry, MotionByNoise, to_json};
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
    #[command(flatten)]
    options: AxesOptions,
    /// Print robot.toml instead of the axes.
    #[arg(long, conflicts_with = "json")]
    toml: bool,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

impl AxesCommand {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let document = axes(Table::File(&self.table), &self.options)?;
        if !self.json {
            out.remark(&document.messages);
        }
        let met = document.messages.iter().all(|m| m.severity != Severity::Error);
        match (self.json, self.toml) {
            (true, _) => out.print(to_json(&document)?)?,
            (false, false) => out.print_text(&text(&document))?,
            (false, true) => match &document.robot {
                Some(robot) => out.print_text(&robot.robot_toml)?,
                None if met => return Ok(Verdict::NotRun),
                None => {}
            },
        }
        Ok(Verdict::new(met))
    }
}

/// Axes as text.
fn text(document: &AxesDocument) -> String {
    let mut lines = Vec::new();
    document.axes.iter().for_each(|axis| axis_lines(axis, &mut lines));
    if let Some(robot) = &document.robot {
        lines.push(phrase!("axes-base", rule = robot.base_rule));
        lines.push(phrase!("axes-origin", point = vector(&robot.base_xyz_mm, 4, " mm")));
        for target in &robot.targets {
            let u = target.standard_uncertainty_mm.iter().map(|u| u * u).sum::<f64>().sqrt();
            lines.push(phrase!("axes-target", target = target.target));
            lines.push(phrase!("axes-point", point = vector(&target.xyz_mm, 4, " mm"), u = format!("{u:.4}")));
        }
    }
    for check in &document.checks {
        let [distance, u] = [check.distance_mm, check.standard_uncertainty_mm].map(|v| format!("{v:.4}"));
        lines.push(phrase!("axes-check-pose", line = check.line, distance, u));
    }
    lines.into_iter().map(|line| format!("{line}\n")).collect()
}

fn vector(v: &[f64; 3], decimals: usize, unit: &str) -> String {
    format!("{:.*} {:.*} {:.*}{unit}", decimals, v[0], decimals, v[1], decimals, v[2])
}

/// Expected error motion by noise and its standard uncertainty.
fn by_noise(noise: Option<MotionByNoise>, factor: f64, decimals: usize) -> String {
    noise.map_or_else(String::new, |noise| {
        let [expected, u] = [noise.expected, noise.standard_uncertainty].map(|v| format!("{:.decimals$}", factor * v));
        format!("{expected} ± {u}")
    })
}

fn axis_lines(axis: &AxisEntry, lines: &mut Vec<Phrase>) {
    let kind = if axis.prismatic { "slides" } else { "turns" };
    let (joint, count, aside) = (&axis.joint, axis.readings, axis.set_aside.len());
    lines.push(phrase!("axes-head", joint, kind, count, aside));
    let u = format!("{:.5}", axis.line.direction_standard_uncertainty_deg);
    lines.push(phrase!("axes-direction", direction = vector(&axis.line.direction, 7, ""), u));
    if let Some(u) = axis.line.point_standard_uncertainty_mm {
        lines.push(phrase!("axes-point", point = vector(&axis.line.point_mm, 4, " mm"), u = format!("{u:.4}")));
    }
    for path in &axis.paths {
        let target = &path.target;
        lines.push(match (path.radius_mm, path.radius_standard_uncertainty_mm, path.arc_deg) {
            (Some(radius), Some(u), Some(arc)) => {
                let [radius, u] = [radius, u].map(|v| format!("{v:.4}"));
                phrase!("axes-circle", target, radius, u, arc = format!("{arc:.1}"))
            }
            _ => phrase!("axes-line", target, length = format!("{:.2}", path.length_mm.unwrap_or_default())),
        });
        let motions = [path.radial_error_motion_mm, path.face_error_motion_mm];
        let [radial, face] = motions.map(|v| format!("{:.1}", 1000.0 * v));
        let noise = by_noise(path.by_noise, 1000.0, 1);
        let (radial_noise, face_noise) = (&noise, &noise);
        lines.push(match axis.prismatic {
            true => phrase!("axes-straightness", radial, face, radial_noise, face_noise),
            false => phrase!("axes-error-motions", radial, face, radial_noise, face_noise),
        });
    }
    if let (Some(axial), Some(tilt)) =
        (axis.error_motion.axial_error_motion_mm, axis.error_motion.tilt_error_motion_deg)
    {
        let (axial, tilt) = (format!("{:.1}", 1000.0 * axial), format!("{tilt:.5}"));
        let axial_noise = by_noise(axis.error_motion.axial_by_noise, 1000.0, 1);
        let tilt_noise = by_noise(axis.error_motion.tilt_by_noise, 1.0, 5);
        lines.push(phrase!("axes-axial-and-tilt", axial, tilt, axial_noise, tilt_noise));
    }
    if let (Some(ratio), Some(rms)) = (axis.motion.ratio, axis.motion.motion_rms) {
        let unit = if axis.prismatic { "mm" } else { "deg" };
        let u = format!("{:.6}", axis.motion.ratio_standard_uncertainty.unwrap_or_default());
        lines.push(phrase!("axes-motion", ratio = format!("{ratio:.6}"), u, rms = format!("{rms:.5}"), unit));
    }
}
