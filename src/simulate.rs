//! Exports and logs of a robot with known parameters and stated noise, in the formats that a campaign reads.

use crate::campaign::{Campaign, Column, Dialect, Format, Role};
use crate::files;
use crate::message::{Message, Place, Result};
use crate::noise::Noise;
use crate::pose::{Pose, Vector};
use crate::robots::{PlanarPose, Robot};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt::Write;

/// `truth.toml`: what is true, and what is measured.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Truth {
    /// Seed of the noise.
    pub seed: u64,
    /// Repeats of every pose.
    pub cycles: i64,
    /// Gaussian noise of one coordinate (one standard deviation); by default the instrument's standard uncertainty.
    pub noise_um: Option<f64>,
    /// Digits after the decimal mark in the exports.
    #[serde(default = "six")]
    pub decimals: usize,
    /// Height of the targets of a planar robot above the plane.
    #[serde(default)]
    pub target_height_mm: f64,
    /// Where the world stands in the coordinates of the exports.
    pub export_T_world: Placement,
    /// True parameters by name, in mm, deg and 1; those not given are nominal.
    pub parameters: BTreeMap<String, f64>,
    /// Points of features, in the world.
    #[serde(default, rename = "point")]
    pub points: Vec<LabelledPoint>,
    /// Poses, numbered from 1 in the order given.
    pub poses: Vec<Poses>,
}

fn six() -> usize {
    6
}

/// Position and orientation (Rz Ry Rx).
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Placement {
    /// Position.
    pub xyz_mm: Vector,
    /// Angles about x, y, z.
    pub rpy_deg: Vector,
}

/// A point of a feature.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LabelledPoint {
    /// Its label.
    pub label: String,
    /// The export it goes to.
    pub export: String,
    /// Where it is in the world.
    pub at_mm: Vector,
    /// How often it is measured.
    #[serde(default = "once")]
    pub repeats: usize,
}

fn once() -> usize {
    1
}

/// A set of poses.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Poses {
    /// Joint values in mm or deg.
    #[serde(default)]
    pub joints: Vec<Vec<f64>>,
    /// Circles of platform positions in the base frame, commanded through the nominal inverse kinematics.
    #[serde(default)]
    pub circles: Vec<Circle>,
    /// Orientations at each of those positions.
    #[serde(default)]
    pub theta_deg: Vec<f64>,
}

/// Positions spread evenly on a circle, from its +x side counterclockwise.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Circle {
    /// Centre.
    pub center_mm: [f64; 2],
    /// Diameter.
    pub diameter_mm: f64,
    /// Number of positions.
    pub count: usize,
}

/// Writes every export and log that `campaign` names; gives their names.
pub fn simulate(campaign: &Campaign, truth: &Truth) -> Result<Vec<String>> {
    if campaign.file.synthetic.is_none() {
        return Err(Message::error("the campaign does not say that it is synthetic: its files may be measured ones")
            .hint("state `synthetic = \"how the data are made\"` in campaign.toml: every report repeats it")
            .into());
    }
    let robot = campaign.build_robot()?;
    let mut values = robot.nominal();
    for (name, value) in &truth.parameters {
        let names = robot.parameters().iter().map(|p| p.name.as_str());
        let i = robot.index(name).ok_or_else(|| {
            Message::error(format!("[parameters] names `{name}`, which is no parameter of this robot"))
                .hint_names(name, names)
        })?;
        values[i] = robot.parameters()[i].quantity.inward(*value);
    }
    let joints = joint_values(robot.as_ref(), truth)?;
    let sigma_mm = truth.noise_um.map_or(campaign.file.instrument.standard_uncertainty_mm(), |um| um / 1000.0);
    let rpy = truth.export_T_world.rpy_deg.map(f64::to_radians);
    let export_T_world = Pose::from_xyz_rpy(truth.export_T_world.xyz_mm, rpy);
    let mut written = Vec::new();
    for (stream, export) in campaign.file.exports.iter().enumerate() {
        // one stream of noise per file: adding a file changes no other
        let mut noise = Noise::new(truth.seed, stream as u64);
        let mut measure =
            |p: Vector| export_T_world.apply(p).map(|v| (v + noise.gaussian(sigma_mm)) / export.unit.in_mm());
        let file = export.file.get_ref();
        let mut rows: Vec<(String, Vector)> = Vec::new();
        for point in truth.points.iter().filter(|p| p.export == *file) {
            for _ in 0..point.repeats {
                rows.push((point.label.clone(), measure(point.at_mm)));
            }
        }
        if let Some(pattern) = &export.label {
            for cycle in 1..=truth.cycles {
                for (i, q) in joints.iter().enumerate() {
                    for (k, target) in robot.targets().iter().enumerate() {
                        let mut p = robot.position(&values, q, k);
                        p[2] += truth.target_height_mm;
                        let label = pattern.get_ref().replace("{target}", target);
                        let label =
                            label.replace("{pose}", &(i + 1).to_string()).replace("{cycle}", &cycle.to_string());
                        rows.push((label, measure(p)));
                    }
                }
            }
        }
        if rows.is_empty() {
            let message = Message::error(format!("nothing in the truth goes to the export `{file}`"));
            return Err(message
                .hint("add a [[point]] with this `export`, or `label` to the export in the campaign")
                .into());
        }
        files::write(&campaign.resolve(&export.file)?, export_text(&rows, &export.format, truth.decimals).as_bytes())?;
        written.push(file.clone());
    }
    for log in &campaign.file.logs {
        let text = log_text(robot.as_ref(), log, &joints, truth.cycles)
            .map_err(|m| m.at(Place::span(campaign.path.as_str(), &campaign.text, log.file.span())))?;
        files::write(&campaign.resolve(&log.file)?, text.as_bytes())?;
        written.push(log.file.get_ref().clone());
    }
    Ok(written)
}

/// Joint values of all poses, in mm and rad.
fn joint_values(robot: &dyn Robot, truth: &Truth) -> Result<Vec<Vec<f64>>> {
    let mut all = Vec::new();
    for poses in &truth.poses {
        for q in &poses.joints {
            if q.len() != robot.joints().len() {
                let what = format!("a pose has {} joint values, the robot {} joints", q.len(), robot.joints().len());
                return Err(Message::error(what).into());
            }
            all.push(q.iter().zip(robot.joints()).map(|(q, j)| j.quantity.inward(*q)).collect());
        }
        for circle in &poses.circles {
            let planar =
                robot.planar().ok_or_else(|| Message::error("`circles` are for planar robots").hint("use `joints`"))?;
            for i in 0..circle.count {
                let angle = std::f64::consts::TAU * i as f64 / circle.count as f64;
                let radius = 0.5 * circle.diameter_mm;
                for theta in &poses.theta_deg {
                    let pose = PlanarPose {
                        x_mm: circle.center_mm[0] + radius * angle.cos(),
                        y_mm: circle.center_mm[1] + radius * angle.sin(),
                        theta_rad: theta.to_radians(),
                    };
                    // what a controller logs: rounded to 0.1 um
                    let q = planar.inverse(&robot.nominal(), pose);
                    all.push(q.iter().map(|q| (q * 1e4).round() / 1e4).collect());
                }
            }
        }
    }
    Ok(all)
}

/// Points in the format of an export.
fn export_text(rows: &[(String, Vector)], format: &Format, decimals: usize) -> String {
    let mut text = String::new();
    for (label, [x, y, z]) in rows {
        match format {
            Format::Polyworks => {
                let label = if label.contains(char::is_whitespace) { format!("\"{label}\"") } else { label.clone() };
                let _ = writeln!(text, "{label} {x:.decimals$} {y:.decimals$} {z:.decimals$}");
            }
            Format::Delimited(dialect) => text.push_str(&delimited_row(label, [*x, *y, *z], dialect, decimals)),
        }
    }
    text
}

fn delimited_row(label: &str, p: Vector, dialect: &Dialect, decimals: usize) -> String {
    let field = |role: &Role| {
        let number = |v: f64| {
            let text = format!("{v:.decimals$}");
            if dialect.decimal == crate::campaign::Decimal::Comma { text.replace('.', ",") } else { text }
        };
        match role {
            Role::Label => label.to_owned(),
            Role::X => number(p[0]),
            Role::Y => number(p[1]),
            Role::Z => number(p[2]),
            _ => String::new(),
        }
    };
    let separator = dialect.delimiter.byte().map_or(' ', char::from);
    dialect.columns.iter().map(field).collect::<Vec<_>>().join(&separator.to_string()) + "\n"
}

/// A log with the columns that the campaign reads.
fn log_text(
    robot: &dyn Robot,
    log: &crate::campaign::Log,
    joints: &[Vec<f64>],
    cycles: i64,
) -> std::result::Result<String, Message> {
    let mut names = Vec::new();
    let mut places = Vec::new();
    for (key, column) in &log.columns {
        let Column::Name(name) = column else {
            return Err(Message::error("only logs with a header can be simulated").hint("name the columns"));
        };
        let key = key.get_ref().as_str();
        let joint = robot.joints().iter().position(|j| j.column() == key);
        if joint.is_none() && key != "pose" && key != "cycle" {
            return Err(Message::error(format!("a simulated log cannot bring `{key}`"))
                .expected("`pose`, `cycle` and the joints in mm or deg"));
        }
        names.push(name.clone());
        places.push((key.to_owned(), joint));
    }
    let separator = log.delimiter.byte().map_or(' ', char::from).to_string();
    let mut text = names.join(&separator) + "\n";
    for cycle in 1..=cycles {
        for (i, q) in joints.iter().enumerate() {
            let cell = |(key, joint): &(String, Option<usize>)| match joint {
                Some(j) => {
                    let text = format!("{:.6}", robot.joints()[*j].quantity.outward(q[*j]));
                    if log.decimal == crate::campaign::Decimal::Comma { text.replace('.', ",") } else { text }
                }
                None if key == "pose" => (i + 1).to_string(),
                None => cycle.to_string(),
            };
            let _ = writeln!(text, "{}", places.iter().map(cell).collect::<Vec<_>>().join(&separator));
        }
    }
    Ok(text)
}
