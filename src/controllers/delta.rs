//! Deltas in the formats of controllers. In Klipper and RepRapFirmware, towers are vertical and on
//! one circle, each with its own direction, rod and end stop; in LinuxCNC three legs are equal.
//! Properties that a format cannot hold are in its header.
//!
//! Any three vertical towers are on a circle; the frame of the controller is at its centre, rotated
//! to match the towers.

use super::decimals::all_fixed;
use super::template::render;
use super::{About, ExportInput, Exporter, value};
use etalon_base::angle::Turn;
use etalon_base::message::{Message, Result};
use etalon_base::pose::Pose;
use etalon_base::{error, phrase};
use etalon_robots::{Parameter, Quantity, Robot, Role};
use minijinja::context;
use minijinja::value::Serde;
use serde::Serialize;

/// A firmware of printers, in which towers are vertical.
pub(super) struct Printer {
    name: &'static str,
    file_name: &'static str,
    template: &'static str,
}

/// Klipper's `[printer] kinematics: delta`.
pub(super) const KLIPPER: Printer = Printer {
    name: "klipper-delta",
    file_name: "klipper_delta.cfg",
    template: include_str!("templates/klipper_delta.cfg.j2"),
};
/// RepRapFirmware's `M665` and `M666`.
pub(super) const REP_RAP: Printer = Printer {
    name: "reprap-delta",
    file_name: "reprap_delta.g",
    template: include_str!("templates/reprap_delta.g.j2"),
};
/// LinuxCNC's `lineardeltakins` and `rotarydeltakins`.
pub(super) struct DeltaHal;

/// Frame of all files.
const FRAME: &str = "base of the robot, the base in the world of the campaign is not in this file";
/// Directions of the towers in both firmwares (deg).
const TOWERS_DEG: [f64; 3] = [210.0, 330.0, 90.0];
/// Shift of the platform that shows the position of a tower (mm).
const STEP_MM: f64 = 1.0;

/// Vertical towers in the frame of a controller.
#[derive(Serialize)]
struct Towers {
    /// Centre of the circle in the base frame (mm).
    centre_mm: [f64; 2],
    /// Rotation of the controller's frame in the base frame (deg).
    turned_deg: f64,
    radius_mm: f64,
    /// Corrections of [`TOWERS_DEG`].
    corrections_deg: [f64; 3],
    angles_deg: [f64; 3],
    rods_mm: [f64; 3],
    /// Height of the centred platform at joint value zero.
    heights_mm: [f64; 3],
    /// Properties that the format cannot hold.
    lost: Vec<String>,
}

impl Towers {
    fn new(given: &ExportInput, format: &str) -> Result<Self> {
        let (robot, values) = given.robot()?;
        let arm = robot
            .kinematics()
            .filter(|_| has_towers(robot))
            .ok_or_else(|| super::other_robot(format, robot, phrase!("kind-delta-towers")))?;
        let numbered = |name: &str| -> Result<[f64; 3]> {
            Ok([
                value(robot, &values, &format!("{name}_1"))?,
                value(robot, &values, &format!("{name}_2"))?,
                value(robot, &values, &format!("{name}_3"))?,
            ])
        };
        let (rods_mm, offsets) = (numbered("rod")?, numbered("offset")?);
        // squared horizontal distances from the towers to three positions of the platform determine
        // the towers
        let squares = |x: f64, y: f64| -> Result<[f64; 3]> {
            let ways = arm.all_joints(&values, &Pose { translation_mm: [x, y, 0.0], ..Pose::identity() });
            let joints = ways.first().ok_or_else(|| error!("platform-out-of-reach"))?;
            Ok([0, 1, 2].map(|i| rods_mm[i].powi(2) - (joints[i] + offsets[i]).powi(2)))
        };
        let (middle, along, across) = (squares(0.0, 0.0)?, squares(STEP_MM, 0.0)?, squares(0.0, STEP_MM)?);
        let place = |i: usize, moved: &[f64; 3]| (middle[i] - moved[i] + STEP_MM * STEP_MM) / (2.0 * STEP_MM);
        let at = [0, 1, 2].map(|i| [place(i, &along), place(i, &across)]);
        let centre_mm = centre(at);
        let from = at.map(|[x, y]| [x - centre_mm[0], y - centre_mm[1]]);
        let radius_mm = from[0][0].hypot(from[0][1]);
        let angles = from.map(|[x, y]| y.atan2(x).to_degrees());
        let off = [0, 1, 2].map(|i| Turn::DEGREES.near(angles[i] - TOWERS_DEG[i], angles[0] - TOWERS_DEG[0]));
        let turned_deg = off.iter().sum::<f64>() / 3.0;
        let corrections_deg = off.map(|v| v - turned_deg);
        if corrections_deg.iter().any(|v| v.abs() > 30.0) {
            return Err(error!("tower-order", format).into());
        }
        let heights_mm = [0, 1, 2].map(|i| offsets[i] - (rods_mm[i].powi(2) - radius_mm.powi(2)).sqrt());
        let tilts = robot.parameters().iter().zip(&values).filter(|(p, v)| is_tilt(p) && **v != 0.0);
        let lost = tilts.map(|(p, v)| format!("{} = {:.6} deg", p.name, v.to_degrees())).collect();
        let angles_deg = [0, 1, 2].map(|i| TOWERS_DEG[i] + corrections_deg[i]);
        let turned_deg = wrap_deg(turned_deg);
        Ok(Self { centre_mm, turned_deg, radius_mm, corrections_deg, angles_deg, rods_mm, heights_mm, lost })
    }

    /// Header lines of a file.
    fn header(&self, given: &ExportInput) -> Result<Vec<String>> {
        let [x, y, turned] = all_fixed([self.centre_mm[0], self.centre_mm[1], self.turned_deg], 6);
        let mut lines = given.header("mm, deg")?;
        lines.push(format!("frame of this file in the base: x {x} mm, y {y} mm, turned by {turned} deg about z"));
        if !self.lost.is_empty() {
            lines.push(format!("not in this format, whose towers are vertical: {}", self.lost.join(", ")));
        }
        Ok(lines)
    }
}

/// `true` for a delta on towers.
fn has_towers(robot: &dyn Robot) -> bool {
    robot.model() == "delta_linear"
}

/// `true` for the tilt angle of a tower.
fn is_tilt(p: &Parameter) -> bool {
    p.role == Role::Robot && p.quantity == Quantity::Angle
}

/// Angle wrapped to (−180, 180] deg.
fn wrap_deg(angle: f64) -> f64 {
    Turn::DEGREES.difference(angle, 0.0)
}

/// Centre of the circle through three points.
fn centre([a, b, c]: [[f64; 2]; 3]) -> [f64; 2] {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let (uu, vv) = (u[0] * u[0] + u[1] * u[1], v[0] * v[0] + v[1] * v[1]);
    let twice = 2.0 * (u[0] * v[1] - u[1] * v[0]);
    [a[0] + (v[1] * uu - u[1] * vv) / twice, a[1] + (u[0] * vv - v[0] * uu) / twice]
}

impl Exporter for Printer {
    fn about(&self) -> About<'_> {
        // the only angles of a leg are the tilts of its tower
        About { frame: FRAME, holds: |p| !is_tilt(p), ..About::controller(self.name, self.file_name) }
    }

    fn unsuited_robot(&self, robot: &dyn Robot) -> Option<Message> {
        (!has_towers(robot)).then(|| super::other_robot(self.name, robot, phrase!("kind-delta-towers")))
    }

    fn written(&self, _given: &ExportInput, robot: &dyn Robot, values: &[f64]) -> Vec<f64> {
        robot.parameters().iter().zip(values).map(|(p, &value)| if is_tilt(p) { 0.0 } else { value }).collect()
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let towers = Towers::new(given, self.name)?;
        let mean = towers.heights_mm.iter().sum::<f64>() / 3.0;
        let end_stops = Serde(towers.heights_mm.map(|v| v - mean));
        let values = context! { header => towers.header(given)?, towers => Serde(&towers), mean, end_stops };
        render(self.template, values).map(String::into_bytes)
    }
}

impl Exporter for DeltaHal {
    fn about(&self) -> About<'_> {
        About { frame: FRAME, ..About::controller("linuxcnc-delta", "deltakins.hal") }
    }

    fn unsuited_robot(&self, robot: &dyn Robot) -> Option<Message> {
        pins(robot.model()).is_empty().then(|| super::other_robot(self.name(), robot, phrase!("kind-delta")))
    }

    /// Only parameters of three equal legs are held.
    fn holds(&self, parameter: &Parameter, given: &ExportInput) -> bool {
        given.robot.is_some_and(|robot| has_pin(pins(robot.model()), stem(&parameter.name)))
    }

    fn written(&self, _given: &ExportInput, robot: &dyn Robot, values: &[f64]) -> Vec<f64> {
        let pins = pins(robot.model());
        let own = |(p, &value): (&Parameter, &f64)| match stem(&p.name) {
            _ if p.role != Role::Robot => value,
            stem if has_pin(pins, stem) => mean(robot, values, stem).unwrap_or(value),
            _ => 0.0,
        };
        robot.parameters().iter().zip(values).map(own).collect()
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        let pins = pins(robot.model());
        // arrangement of the legs in rotarydeltakins-common.h and lineardeltakins-common.h
        let (first, order) = if robot.model() == "delta" { ("-y", "clockwise") } else { ("y", "counterclockwise") };
        let lost = lost(robot, &values, pins);
        let pin = |(pin, names): &Pin| {
            let means = names.iter().map(|name| mean(robot, &values, name)).collect::<Result<Vec<f64>>>()?;
            Ok((*pin, means.into_iter().reduce(|a, b| a - b).unwrap_or_default()))
        };
        let pins = Serde(pins.iter().map(pin).collect::<Result<Vec<_>>>()?);
        let values = context! { header => given.header("mm, deg")?, first, order, lost, pins };
        render(include_str!("templates/deltakins.hal.j2"), values).map(String::into_bytes)
    }
}

/// A pin of LinuxCNC with the names of its parameters; its value is the mean over the legs, or the
/// difference of two such means.
type Pin = (&'static str, &'static [&'static str]);

/// Pins of a model; empty for models other than deltas.
fn pins(model: &str) -> &'static [Pin] {
    match model {
        "delta" => &[
            ("rotarydeltakins.platformradius", &["base_radius"]),
            ("rotarydeltakins.thighlength", &["upper_arm"]),
            ("rotarydeltakins.shinlength", &["rod"]),
            ("rotarydeltakins.footradius", &["platform_radius"]),
        ],
        "delta_linear" => {
            &[("lineardeltakins.R", &["base_radius", "platform_radius"]), ("lineardeltakins.L", &["rod"])]
        }
        _ => &[],
    }
}

/// Name of a parameter without the number of its leg.
fn stem(name: &str) -> &str {
    name.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_')
}

fn has_pin(pins: &[Pin], stem: &str) -> bool {
    pins.iter().any(|(_, names)| names.contains(&stem))
}

/// Mean of a parameter over all legs.
fn mean(robot: &dyn Robot, values: &[f64], name: &str) -> Result<f64> {
    let mut sum = 0.0;
    for leg in 1..=3 {
        sum += value(robot, values, &format!("{name}_{leg}"))?;
    }
    Ok(sum / 3.0)
}

/// Deviations of the parameters from the common values of the legs.
fn lost(robot: &dyn Robot, values: &[f64], pins: &[Pin]) -> Vec<String> {
    let legs = robot.parameters().iter().zip(values).filter(|(p, _)| p.role == Role::Robot);
    let off = legs.filter_map(|(p, &v)| {
        let stem = stem(&p.name);
        let rest = v - if has_pin(pins, stem) { mean(robot, values, stem).ok()? } else { 0.0 };
        (rest.abs() > 1e-9).then(|| format!("{} {:+.6} {}", p.name, p.quantity.outward(rest), p.quantity.unit()))
    });
    off.collect()
}
