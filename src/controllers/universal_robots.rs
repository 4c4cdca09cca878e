//! Calibration of a Universal Robots arm in the format of the ROS description packages
//! (`kinematics_params_file`: ur_description, ur_calibration).

use super::template::render;
use super::{About, ExportInput, Exporter, is_geometry, six_axes};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm};
use etalon_base::{phrase, warning};
use etalon_robots::{ChainJoint, JointChain, Robot, link_frames};
use minijinja::value::Serde;
use minijinja::{Value, context};
use std::f64::consts::PI;

/// Maximum shift (mm) and rotation (cells of the rotation matrix) of a flange that is attributed to
/// rounding.
const ROUNDING: f64 = 1e-9;
/// Maximum deviation (deg) of neighbouring axes from parallel or perpendicular: production
/// tolerances of arms are far below.
const LARGEST_TILT_DEG: f64 = 5.0;
/// Maximum distance of axes that meet, and smallest length of a link, relative to the length of
/// upper arm and forearm together. Links and offsets of UR3 to UR20 have at least 0.09 of it.
const NONE: f64 = 0.03;

/// YAML with the frame of each joint in the previous one (m, rad).
pub(super) struct UniversalRobots;

const LINKS: [&str; 6] = ["shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"];

impl Exporter for UniversalRobots {
    /// The driver in ROS reads the file; the controller does not.
    fn about(&self) -> About<'_> {
        About {
            frame: "base of the maker: z along axis 1, shoulder above the origin, the base in the world of the campaign is not in this file",
            states_controller_hash: true,
            holds: is_geometry,
            ..About::laboratory("universal-robots", "universal_robots_calibration.yaml")
        }
    }

    fn unsuited_robot(&self, robot: &dyn Robot) -> Option<Message> {
        six_axes(self.name(), robot, &robot.nominal()).err()
    }

    fn concern(&self, given: &ExportInput) -> Option<Message> {
        let robot = given.robot?;
        let chain = six_axes(self.name(), robot, &robot.nominal()).ok()?;
        let difference = difference(&chain)?;
        Some(warning!("file-of-other-structure", format = self.name(), difference))
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        let nominal = six_axes(self.name(), robot, &robot.nominal())?;
        let chain = six_axes(self.name(), robot, &values)?;
        let [before, arm] = MakersArm::both(&nominal, &chain);
        let joint = |(link, (pose, joint)): (&&'static str, (&Pose, &ChainJoint))| {
            let (xyz, rpy) = (pose.translation_mm.map(|mm| mm / 1000.0), pose.rpy_rad());
            context! { link => link.to_string(), xyz => Serde(xyz), rpy => Serde(rpy), gain => joint.gain }
        };
        let joints: Vec<Value> = LINKS.iter().zip(arm.joints.iter().zip(&chain.joints)).map(joint).collect();
        let mut header = given.header_of_geometry("m, rad")?;
        header
            .push("ur_description reads this file (kinematics_params_file); the controller itself does not".to_owned());
        header.extend(self.concern(given).map(|_| "the axes of this arm differ from Universal Robots arms".to_owned()));
        header.extend(listed(&Pose::identity(), &arm.base).map(|(xyz, rpy)| {
            format!("base of this file in the base of the robot file: xyz {xyz} mm, rpy {rpy} deg; move the robot there in its scene")
        }));
        let teach = if listed(&before.flange, &arm.flange).is_some() { ": teach tools again" } else { "" };
        header.extend(listed(&Pose::identity(), &arm.flange).map(|(xyz, rpy)| {
            format!("flange in the frame of wrist_3: xyz {xyz} mm, rpy {rpy} deg; ur_description has the nominal flange there{teach}")
        }));
        let hash = match given.controller_hash {
            Some(hash) => hash.to_owned(),
            None => {
                header.push(
                    "the hash is that of etalon, not of the robot: ur_robot_driver reports a mismatch".to_owned(),
                );
                let sha256 = given.sha256()?;
                format!("calib_{}", u64::from_str_radix(sha256.get(..16).unwrap_or_default(), 16).unwrap_or_default())
            }
        };
        let values = context! { header, joints, hash };
        render(include_str!("templates/universal_robots.yaml.j2"), values).map(String::into_bytes)
    }
}

/// Height of the shoulder and length of the last link of an arm of the maker (mm).
struct Lengths {
    shoulder: f64,
    last: f64,
}

/// Lengths of the arms by the maker's tables: d1, |a2|, |a3|, d4, d5, d6 (Universal Robots, "DH
/// parameters for calculations of kinematics and dynamics").
const ARMS: [[f64; 6]; 8] = [
    [151.9, 243.65, 213.25, 112.35, 85.35, 81.9],
    [89.159, 425.0, 392.25, 109.15, 94.65, 82.3],
    [127.3, 612.0, 572.3, 163.941, 115.7, 92.2],
    [151.85, 243.55, 213.2, 131.05, 85.35, 92.1],
    [162.5, 425.0, 392.2, 133.3, 99.7, 99.6],
    [180.7, 612.7, 571.55, 174.15, 119.85, 116.55],
    [180.7, 478.4, 360.0, 174.15, 119.85, 116.55],
    [236.3, 862.0, 728.7, 201.0, 159.3, 154.3],
];
/// Maximum difference (mm) of a nominal length from the maker's.
const SAME_MM: f64 = 2.0;

/// An arm in the frames of the maker's description: each joint turns about z of its frame, and the
/// frames follow the maker's Denavit-Hartenberg table. A chain of such frames holds the arm from
/// its own base to wrist_3.
struct MakersArm {
    /// Base of the description in the base of the robot file.
    base: Pose,
    /// Frames of the joints in the frames before them.
    joints: Vec<Pose>,
    /// Flange in the frame of wrist_3.
    flange: Pose,
}

impl MakersArm {
    /// The nominal and the identified arm, in the same frames.
    ///
    /// The place of the base on axis 1 and the zero of its direction are not part of an arm: the
    /// nominal shoulder is at the maker's height above the base, without rotation. The description
    /// has height and rotation of the shoulder only; other motions of axis 1 belong to the base.
    fn both(nominal: &JointChain, chain: &JointChain) -> [Self; 2] {
        let of_maker = difference(nominal).is_none();
        let [(mut first, nominal_flange), (mut second, flange)] = [nominal, chain].map(|c| frames(c, of_maker));
        let mut height_mm = height(&first[0]);
        if of_maker {
            let makers = first.iter().map(|f| f.translation_mm).collect::<Vec<_>>();
            let lengths = lengths(&makers, first[2].axis(2));
            if let Some(lengths) = &lengths {
                height_mm = lengths.shoulder;
            }
            let (turn, along) = wrist_3(&first, lengths.as_ref().map(|lengths| lengths.last));
            [&mut first, &mut second].into_iter().for_each(|all| all[5] = all[5].turn_z(turn).shift(2, along));
        }
        let base = first[0].shift(2, -height_mm);
        [(first, nominal_flange), (second, flange)].map(|(frames, flange)| {
            let shoulder = base.inverse().then(&frames[0]);
            let [_, _, yaw] = shoulder.rpy_rad();
            let shoulder = Pose::identity().shift(2, shoulder.translation_mm[2]).turn_z(yaw);
            let own = clean(frames[0].then(&shoulder.inverse()));
            let mut joints = vec![shoulder];
            joints.extend(frames.windows(2).map(|pair| pair[0].inverse().then(&pair[1])));
            Self { base: own, joints, flange: clean(frames[5].inverse().then(&flange)) }
        })
    }
}

/// The pose, or the identity if they differ by rounding only.
fn clean(pose: Pose) -> Pose {
    if listed(&Pose::identity(), &pose).is_some() { pose } else { Pose::identity() }
}

/// Height (mm) of a frame above the base, if its axis is the z axis of the base.
fn height(frame: &Pose) -> f64 {
    let ([x, y, z], axis) = (frame.translation_mm, frame.axis(2));
    if x.hypot(y) < ROUNDING && axis[0].hypot(axis[1]) < ROUNDING && axis[2] > 0.0 { z } else { 0.0 }
}

/// Frames of the joints in the base, and the flange: for an arm with the axes of the maker, from
/// the maker's table (alpha 90, 0, 0, 90, -90 deg and negative lengths a), otherwise from the robot
/// file.
fn frames(chain: &JointChain, of_maker: bool) -> (Vec<Pose>, Pose) {
    let (axes, flange) = chain.axes();
    if !of_maker {
        return (chain.frames(&[0.0; 6]), flange);
    }
    let mut frames = link_frames(&axes, &flange);
    for k in 0..5 {
        let (z, next) = (frames[k].axis(2), frames[k + 1].axis(2));
        let wished = match k {
            0 | 3 => cross(z, next),
            4 => cross(next, z),
            _ => minus(frames[k].translation_mm, frames[k + 1].translation_mm),
        };
        if dot(frames[k].axis(0), wished) < 0.0 {
            frames[k] = frames[k].turn_z(PI);
        }
    }
    (frames, flange)
}

/// Lengths of the maker's arm that has these origins of its frames and this direction of axis 3;
/// `None` for an arm of other lengths.
fn lengths(origins: &[Vector], z: Vector) -> Option<Lengths> {
    let between = |k: usize| minus(origins[k + 1], origins[k]);
    let along = dot(between(2), z).abs();
    let own = [norm(between(1)), norm(cross(between(2), z)), along, norm(between(3))];
    let same = |arm: &&[f64; 6]| own.iter().zip(&arm[1..5]).all(|(own, maker)| (own - maker).abs() < SAME_MM);
    let [shoulder, .., last] = *ARMS.iter().find(same)?;
    Some(Lengths { shoulder, last })
}

/// Rotation about z (rad) and shift along z (mm) from the last frame of an arm to the frame of the
/// maker, which has x of the previous frame and its origin at the maker's distance from wrist_2.
fn wrist_3(frames: &[Pose], distance_mm: Option<f64>) -> (f64, f64) {
    let (last, before) = (&frames[5], &frames[4]);
    let (x, y) = (dot(before.axis(0), last.axis(0)), dot(before.axis(0), last.axis(1)));
    let turn = y.atan2(x);
    let along = dot(minus(last.translation_mm, before.translation_mm), last.axis(2));
    let shift = distance_mm.map_or(0.0, |mm| mm.copysign(along) - along);
    (if turn.abs() < ROUNDING { 0.0 } else { turn }, if shift.abs() < ROUNDING { 0.0 } else { shift })
}

/// Position (mm) and angles (deg) of a frame that is not where `other` is.
fn listed(other: &Pose, frame: &Pose) -> Option<(String, String)> {
    let shift = norm(minus(frame.translation_mm, other.translation_mm));
    let cells = frame.rotation.as_flattened().iter().zip(other.rotation.as_flattened());
    let turn = cells.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let listed = |v: [f64; 3]| v.map(|v| format!("{v:?}")).join(" ");
    let angles = frame.rpy_rad().map(f64::to_degrees);
    (shift > ROUNDING || turn > ROUNDING).then(|| (listed(frame.translation_mm), listed(angles)))
}

/// Line of a joint axis.
struct Line {
    point_mm: Vector,
    /// Unit vector.
    direction: Vector,
}

/// First difference between these axes and the axes of a Universal Robots arm; `None` for such an
/// arm.
///
/// Axes 2, 3 and 4 are parallel, all other neighbours perpendicular; axis 1 meets axis 2, axis 5
/// meets axes 4 and 6 at different points, and these points are outside the plane of axis 1 and the
/// arm (Universal Robots, "DH parameters for calculations of kinematics and dynamics"). These are
/// properties of neighbouring axes, independent of the convention and the zeros of the joints.
fn difference(chain: &JointChain) -> Option<Phrase> {
    let mut frames: Vec<Pose> = Vec::new();
    for joint in &chain.joints {
        frames.push(frames.last().map_or(joint.origin, |last| last.then(&joint.origin)));
    }
    let axes: Vec<Line> = frames.iter().map(|f| Line { point_mm: f.translation_mm, direction: f.axis(2) }).collect();
    for (i, expected) in [90.0, 0.0, 0.0, 90.0, 90.0].into_iter().enumerate() {
        let deg = dot(axes[i].direction, axes[i + 1].direction).abs().min(1.0).acos().to_degrees();
        if (deg - expected).abs() > LARGEST_TILT_DEG {
            return Some(phrase!("structure-angle", first = i + 1, second = i + 2, deg, expected));
        }
    }
    let links = [1, 2].map(|i| beside(minus(axes[i + 1].point_mm, axes[i].point_mm), axes[i].direction));
    let none_mm = NONE * (links[0] + links[1]);
    if let Some(i) = links.iter().position(|link| *link <= none_mm) {
        return Some(phrase!("structure-no-link", first = i + 2, second = i + 3, mm = links[i]));
    }
    for i in [0, 3, 4] {
        let (z, next) = (axes[i].direction, axes[i + 1].direction);
        let mm = dot(minus(axes[i + 1].point_mm, axes[i].point_mm), cross(z, next)).abs();
        if mm > none_mm {
            return Some(phrase!("structure-apart", first = i + 1, second = i + 2, mm));
        }
    }
    let [wrist, last] = [foot(&axes[4], &axes[3]), foot(&axes[4], &axes[5])];
    let mm = norm(minus(last, wrist));
    if mm <= none_mm {
        return Some(phrase!("structure-wrist-meets", mm));
    }
    let mm = dot(minus(wrist, axes[0].point_mm), axes[1].direction).abs();
    (mm <= none_mm).then(|| phrase!("structure-wrist-in-plane", mm))
}

/// Distance of a point from an axis through the origin.
fn beside(point: Vector, z: Vector) -> f64 {
    norm(cross(point, z))
}

/// Point of the first axis that is nearest to the second, which is not parallel.
fn foot(first: &Line, second: &Line) -> Vector {
    let common = cross(first.direction, second.direction);
    let offset = minus(second.point_mm, first.point_mm);
    let along = dot(cross(offset, second.direction), common) / dot(common, common);
    [0, 1, 2].map(|i| first.point_mm[i] + along * first.direction[i])
}
