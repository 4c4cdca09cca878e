//! Kinematics of LinuxCNC's `genserkins`: modified Denavit-Hartenberg parameters (Craig) of six
//! revolute joints.
//!
//! The parameters are computed from the axes, independent of the convention of the identification.
//! `genserkins` has no Hayati angle, so that near-parallel axes use their exact, distant common
//! normal. Links before the first joint and after the last are separate frames.

use super::template::render;
use super::{About, ExportInput, Exporter, is_geometry, six_axes};
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm, unit};
use etalon_base::{error, warning};
use etalon_robots::{JointChain, NEAR_PARALLEL_RAD, Robot};
use minijinja::context;
use minijinja::value::Serde;
use serde::Serialize;

/// HAL commands.
pub(super) struct LinuxCnc;

/// Sine of the angle below which two axes have no unique common normal.
const PARALLEL: f64 = 1e-10;
/// Minimum length (mm) of a link with a direction.
const SHORT_MM: f64 = 1.0;

/// A row of the table, with joint offset and gain.
#[derive(Serialize)]
struct LinkParameters {
    alpha_rad: f64,
    a_mm: f64,
    theta_rad: f64,
    d_mm: f64,
    gain: f64,
}

impl Exporter for LinuxCnc {
    fn about(&self) -> About<'_> {
        About {
            frame: "the world of LinuxCNC is the first frame stated below, the base in the world of the campaign is not in this file",
            holds: is_geometry,
            ..About::controller("linuxcnc", "genserkins.hal")
        }
    }

    fn unsuited_robot(&self, robot: &dyn Robot) -> Option<Message> {
        six_axes(self.name(), robot, &robot.nominal()).err()
    }

    fn cautions(&self, given: &ExportInput) -> Vec<Message> {
        let Ok((robot, values)) = given.robot() else { return Vec::new() };
        let chain = six_axes(self.name(), robot, &values).ok();
        let Some((_, rows)) = chain.and_then(|chain| table(&chain)) else { return Vec::new() };
        distant(&rows).into_iter().chain(offsets(&rows)).collect()
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        let chain = six_axes(self.name(), robot, &values)?;
        let (base, rows) = table(&chain).ok_or_else(|| error!("axes-coincide"))?;
        let frame = |name, pose: &Pose| (name, pose.translation_mm, pose.rpy_rad().map(f64::to_degrees));
        let frames = [frame("first frame in the base", &base), frame("flange in the last frame", &chain.flange)];
        let header = given.header_of_geometry("mm, rad; offsets of joints in deg")?;
        let offset = rows.iter().any(|row| row.theta_rad.abs() > OFFSET_RAD);
        let values = context! { header, offset, frames => Serde(frames), rows => Serde(rows) };
        render(include_str!("templates/genserkins.hal.j2"), values).map(String::into_bytes)
    }
}

/// Length of a link offset, relative to the other lengths of an arm, that only a distant common
/// normal of near-parallel axes has.
const DISTANT: f64 = 2.0;
/// Minimum joint offset (rad) that is not rounding.
const OFFSET_RAD: f64 = 1e-12;

/// Warning about near-parallel axes, whose common normal is far from the arm.
fn distant(rows: &[LinkParameters]) -> Option<Message> {
    let parallel = |k: &usize| {
        let sine = rows[*k].alpha_rad.sin().abs();
        sine > PARALLEL && sine < NEAR_PARALLEL_RAD.sin()
    };
    let pairs: Vec<usize> = (1..rows.len()).filter(parallel).collect();
    let beside = |k: usize| pairs.iter().any(|&pair| k == pair || k + 1 == pair);
    let usual: f64 =
        rows.iter().enumerate().map(|(k, r)| r.a_mm.abs() + if beside(k) { 0.0 } else { r.d_mm.abs() }).sum();
    let far = |k: &&usize| rows[**k].d_mm.abs().max(rows[**k - 1].d_mm.abs()) > DISTANT * usual;
    let &second = pairs.iter().find(far)?;
    let away_mm = rows[second].d_mm.abs().max(rows[second - 1].d_mm.abs());
    Some(warning!("linuxcnc-distant-normal", first = second, second = second + 1, away_mm))
}

/// Warning about joint offsets, which `genserkins` does not have, with the displacement of the
/// flange at joint values zero if they are ignored.
fn offsets(rows: &[LinkParameters]) -> Option<Message> {
    let reached = |share: f64| {
        let link = |pose: Pose, r: &LinkParameters| {
            pose.turn_x(r.alpha_rad).shift(0, r.a_mm).turn_z(share * r.theta_rad).shift(2, r.d_mm)
        };
        rows.iter().fold(Pose::identity(), link).translation_mm
    };
    let listed = |(k, row): (usize, &LinkParameters)| format!("{k}: {:?}", row.theta_rad.to_degrees());
    let stated = rows.iter().enumerate().filter(|(_, row)| row.theta_rad.abs() > OFFSET_RAD).map(listed);
    let offsets_deg: Vec<String> = stated.collect();
    let off_mm = norm(minus(reached(1.0), reached(0.0)));
    (!offsets_deg.is_empty()).then(|| warning!("linuxcnc-joint-offsets", offsets_deg = offsets_deg.join(", "), off_mm))
}

/// First frame in the base, and parameters of each joint; `None` if two axes coincide.
fn table(chain: &JointChain) -> Option<(Pose, Vec<LinkParameters>)> {
    let mut frames: Vec<Pose> = Vec::new();
    for joint in &chain.joints {
        frames.push(frames.last().map_or(joint.origin, |last| last.then(&joint.origin)));
    }
    // the first frame is the frame of the base, moved to the first axis
    let (point, z) = (frames[0].translation_mm, frames[0].axis(2));
    let along = dot(point, z);
    let origin = [0, 1, 2].map(|i| point[i] - along * z[i]);
    let x = unit(across([1.0, 0.0, 0.0], z)).or_else(|| unit(across([0.0, 1.0, 0.0], z)))?;
    let base = frame(origin, x, z);
    let (mut rows, mut link, mut x, mut foot) = (Vec::new(), (0.0, 0.0), x, origin);
    for (i, here) in frames.iter().enumerate() {
        let z = here.axis(2);
        // feet of the next common normal on this axis and on the next
        let (next_x, leaves, arrives) = match frames.get(i + 1) {
            Some(next) => normal(here, next, foot, x)?,
            None => (here.axis(0), here.translation_mm, here.translation_mm),
        };
        let theta_rad = dot(cross(x, next_x), z).atan2(dot(x, next_x));
        let (d_mm, gain) = (dot(minus(leaves, foot), z), chain.joints[i].gain);
        rows.push(LinkParameters { alpha_rad: link.0, a_mm: link.1, theta_rad, d_mm, gain });
        if let Some(next) = frames.get(i + 1) {
            let turned = next.axis(2);
            let alpha_rad = dot(cross(z, turned), next_x).atan2(dot(z, turned));
            link = (alpha_rad, dot(minus(arrives, leaves), next_x));
        }
        (x, foot) = (next_x, arrives);
    }
    Some((base, rows))
}

/// Direction of the common normal of two axes, and its feet on both; for parallel axes the normal
/// through `foot`.
fn normal(here: &Pose, next: &Pose, foot: Vector, x: Vector) -> Option<(Vector, Vector, Vector)> {
    let (z, turned) = (here.axis(2), next.axis(2));
    let between = minus(next.translation_mm, here.translation_mm);
    let common = cross(z, turned);
    if norm(common) < PARALLEL {
        let direct = minus(next.translation_mm, foot);
        let direct = across(direct, z);
        return Some((unit(direct)?, foot, [0, 1, 2].map(|i| foot[i] + direct[i])));
    }
    let square = dot(common, common);
    let (s, t) = (dot(cross(between, turned), common) / square, dot(cross(between, z), common) / square);
    let leaves = [0, 1, 2].map(|i| here.translation_mm[i] + s * z[i]);
    let arrives = [0, 1, 2].map(|i| next.translation_mm[i] + t * turned[i]);
    let normal = unit(common)?;
    let length = dot(minus(arrives, leaves), normal);
    // lengths are positive; a link without length has the direction of the previous axis
    let sign = if length.abs() > SHORT_MM { length } else { dot(normal, x) };
    Some((normal.map(|v| v * 1f64.copysign(sign)), leaves, arrives))
}

/// Component of a vector perpendicular to a direction.
fn across(v: Vector, z: Vector) -> Vector {
    let along = dot(v, z);
    [0, 1, 2].map(|i| v[i] - along * z[i])
}

fn frame(origin: Vector, x: Vector, z: Vector) -> Pose {
    let y = cross(z, x);
    Pose { rotation: [0, 1, 2].map(|i| [x[i], y[i], z[i]]), translation_mm: origin }
}
