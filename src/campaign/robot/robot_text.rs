//! Text of a robot.toml of a serial arm, from its axes.

use etalon_base::pose::Pose;
use etalon_robots::{AxisLine, AxisTable, LostTilt, TableConvention};
use std::fmt::Write;

/// Decimals of lengths (mm), of angles (deg) and of directions: below the resolution of any
/// measuring system, so that the text is exact.
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

/// Limits of a joint as a key: travel of a sliding one.
fn limits(limits: Option<&Option<[f64; 2]>>, prismatic: bool) -> String {
    let Some(Some(ends)) = limits else { return String::new() };
    if ends.iter().any(|v| !v.is_finite()) {
        return String::new();
    }
    let (key, scale) = if prismatic { ("travel_mm", 1.0) } else { ("limits_deg", 1f64.to_degrees()) };
    let [lower, upper] = ends.map(|v| number(v * scale, DECIMALS[0]));
    format!(", {key} = [{lower}, {upper}]")
}

/// Head of a robot.toml: name, comments, and limits of the joints (rad or mm).
#[derive(Clone, Copy, Debug, Default)]
pub struct RobotHead<'a> {
    /// Name of the robot.
    pub name: &'a str,
    /// Comments above the keys.
    pub comments: &'a [String],
    /// Limits by joint; none beyond the end of the list.
    pub limits: &'a [Option<[f64; 2]>],
}

/// robot.toml of screw axes in the base at joint values zero (`poe`).
pub fn screws_text(about: RobotHead, axes: &[AxisLine], flange: &Pose) -> String {
    let [lengths, angles] = DECIMALS;
    let mut text = head(about.name, about.comments, "poe");
    let degrees = flange.rpy_rad().map(f64::to_degrees);
    let _ = writeln!(text, "flange_xyz_mm = [{}]", list(flange.translation_mm, lengths));
    let _ = writeln!(text, "flange_rpy_deg = [{}]\njoint = [", list(degrees, angles));
    for (i, axis) in axes.iter().enumerate() {
        let _ = write!(text, "    {{ direction = [{}]", list(axis.direction, angles));
        match axis.prismatic {
            true => text += ", prismatic = true",
            false => text += &format!(", point_mm = [{}]", list(axis.point_mm, lengths)),
        }
        let _ = writeln!(text, "{} }},", limits(about.limits.get(i), axis.prismatic));
    }
    text + "]\n"
}

/// robot.toml of a Denavit-Hartenberg table.
pub fn table_text(about: RobotHead, convention: TableConvention, table: &AxisTable) -> String {
    let [lengths, angles] = DECIMALS;
    let mut text = head(about.name, about.comments, convention.key());
    text += "joint = [\n";
    for (i, joint) in table.joints.iter().enumerate() {
        let [alpha, theta] = [joint.alpha_rad, joint.theta_rad].map(|v| number(v.to_degrees(), angles));
        let [a, d] = [joint.a_mm, joint.d_mm].map(|v| number(v, lengths));
        let _ = write!(text, "    {{ alpha_deg = {alpha}, a_mm = {a}, theta_deg = {theta}, d_mm = {d}");
        if joint.prismatic {
            text += ", prismatic = true";
        }
        if joint.parallel {
            text += ", parallel = true";
        }
        text += &limits(about.limits.get(i), joint.prismatic);
        text += " },\n";
    }
    text + "]\n"
}

/// Joint of a URDF: name, origin in the previous link, and what it does.
#[derive(Clone, Debug)]
pub struct UrdfJoint {
    /// Name of the joint.
    pub name: String,
    /// Frame of the joint in the previous link; its axis is z.
    pub origin: Pose,
    /// `true` if the joint slides.
    pub prismatic: bool,
    /// Smallest and largest value (rad or mm); `None` without limits.
    pub limits: Option<[f64; 2]>,
}

/// Text in an attribute of XML.
fn attribute(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Origin of a frame in a URDF (m, rad).
fn origin(pose: &Pose) -> String {
    let xyz = pose.translation_mm.map(|mm| number(mm / 1000.0, 12)).join(" ");
    let rpy = pose.rpy_rad().map(|v| number(v, 15)).join(" ");
    format!("<origin xyz=\"{xyz}\" rpy=\"{rpy}\"/>")
}

/// URDF of a chain from the link `base_link` to the link `tool`; URDF demands limits, so sliding
/// joints without limits get one metre to either side.
pub fn urdf_text(name: &str, comments: &[String], joints: &[UrdfJoint], flange: &Pose) -> String {
    let lines: String = comments.iter().map(|c| format!("  {}\n", c.replace("--", "__"))).collect();
    let mut text = format!("<?xml version=\"1.0\"?>\n<!--\n{lines}-->\n<robot name=\"{}\">\n", attribute(name));
    text += "  <link name=\"base_link\"/>\n";
    let mut parent = "base_link".to_owned();
    for (i, joint) in joints.iter().enumerate() {
        let child = format!("link_{}", i + 1);
        let (kind, limit) = match (joint.prismatic, joint.limits.filter(|l| l.iter().all(|v| v.is_finite()))) {
            (true, limits) => ("prismatic", Some(limits.unwrap_or([-1000.0, 1000.0]).map(|v| v / 1000.0))),
            (false, Some(limits)) => ("revolute", Some(limits)),
            (false, None) => ("continuous", None),
        };
        let limit = limit.map_or_else(String::new, |[lower, upper]| {
            let [lower, upper] = [lower, upper].map(|v| number(v, 12));
            format!("\n    <limit lower=\"{lower}\" upper=\"{upper}\" effort=\"0\" velocity=\"0\"/>")
        });
        let _ = writeln!(
            text,
            "  <joint name=\"{}\" type=\"{kind}\">\n    {}\n    <parent link=\"{parent}\"/>\n    <child link=\"{child}\"/>\n    \
             <axis xyz=\"0 0 1\"/>{limit}\n  </joint>\n  <link name=\"{child}\"/>",
            attribute(&joint.name),
            origin(&joint.origin),
        );
        parent = child;
    }
    let _ = writeln!(
        text,
        "  <joint name=\"flange\" type=\"fixed\">\n    {}\n    <parent link=\"{parent}\"/>\n    <child link=\"tool\"/>\n  </joint>\n  \
         <link name=\"tool\"/>\n</robot>",
        origin(flange)
    );
    text
}

/// Nominal values that a robot.toml of a serial arm has beside its joints: gains other than one,
/// and Hayati's angles of a table.
pub fn nominal_text(gains: &[f64], tilts: &[LostTilt]) -> String {
    let gains = (1..).zip(gains).filter(|(_, gain)| **gain != 1.0).map(|(i, gain)| ("gain", i, *gain));
    let tilts = tilts.iter().map(|tilt| ("beta", tilt.row + 1, tilt.angle_rad.to_degrees()));
    let stated: String =
        gains.chain(tilts).map(|(name, i, value)| format!("{name}_{i} = {}\n", number(value, 15))).collect();
    if stated.is_empty() { stated } else { format!("\n[nominal]\n{stated}") }
}
