//! Text of a robot.toml of a serial arm, from its axes.

use etalon_base::pose::Pose;
use etalon_robots::{AxisLine, AxisTable};
use std::fmt::Write;

/// Decimals of lengths (mm), and of angles (deg) and directions: below the resolution of any
/// measuring system, so that the text holds the numbers exactly.
const DECIMALS: [usize; 2] = [9, 13];

/// Number without trailing zeros.
fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let short = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

fn list(values: [f64; 3], decimals: usize) -> String {
    values.map(|v| number(v, decimals)).join(", ")
}

/// Head of the file: comments, name and model.
fn head(name: &str, comments: &[String], convention: &str) -> String {
    let mut text = String::new();
    comments.iter().flat_map(|c| c.lines()).for_each(|line| {
        let _ = writeln!(text, "# {line}");
    });
    let name = toml::Value::String(name.to_owned());
    let _ = writeln!(text, "name = {name}\nmodel = \"serial\"\nconvention = \"{convention}\"");
    text
}

/// robot.toml of screw axes in the base at joint values zero (`poe`).
pub fn screws_text(name: &str, comments: &[String], axes: &[AxisLine], flange: &Pose) -> String {
    let [lengths, angles] = DECIMALS;
    let mut text = head(name, comments, "poe");
    let degrees = flange.rpy_rad().map(f64::to_degrees);
    let _ = writeln!(text, "flange_xyz_mm = [{}]", list(flange.translation_mm, lengths));
    let _ = writeln!(text, "flange_rpy_deg = [{}]\njoint = [", list(degrees, angles));
    for axis in axes {
        let _ = write!(text, "    {{ direction = [{}]", list(axis.direction, angles));
        let _ = match axis.prismatic {
            true => writeln!(text, ", prismatic = true }},"),
            false => writeln!(text, ", point_mm = [{}] }},", list(axis.point_mm, lengths)),
        };
    }
    text + "]\n"
}

/// robot.toml of a Denavit-Hartenberg table: modified (`mdh`) or standard (`dh`).
pub fn table_text(name: &str, comments: &[String], modified: bool, table: &AxisTable) -> String {
    let [lengths, angles] = DECIMALS;
    let mut text = head(name, comments, if modified { "mdh" } else { "dh" });
    text += "joint = [\n";
    for joint in &table.joints {
        let [alpha, theta] = [joint.alpha_rad, joint.theta_rad].map(|v| number(v.to_degrees(), angles));
        let [a, d] = [joint.a_mm, joint.d_mm].map(|v| number(v, lengths));
        let _ = write!(text, "    {{ alpha_deg = {alpha}, a_mm = {a}, theta_deg = {theta}, d_mm = {d}");
        if joint.prismatic {
            text += ", prismatic = true";
        }
        if joint.parallel {
            text += ", parallel = true";
        }
        text += " },\n";
    }
    text + "]\n"
}
