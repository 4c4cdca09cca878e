//! Calibration of a Universal Robots arm in the format of the ROS description packages
//! (`kinematics_params_file`: ur_description, ur_calibration).

use super::template::render;
use super::{Exporter, Given, is_geometry, six_axes};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm};
use etalon_base::{phrase, warning};
use etalon_robots::{ChainJoint, JointChain, Parameter};
use minijinja::value::Serde;
use minijinja::{Value, context};

/// Largest shift (mm) and rotation (cells of the rotation matrix) of a flange that is attributed to
/// rounding.
const ROUNDING: f64 = 1e-9;
/// Largest deviation (deg) of neighbouring axes from parallel or perpendicular: production
/// tolerances of arms are far below.
const LARGEST_TILT_DEG: f64 = 5.0;
/// Largest distance of axes that meet, and smallest length of a link, relative to the length of
/// upper arm and forearm together. Links and offsets of UR3 to UR20 have at least 0.09 of it.
const NONE: f64 = 0.03;

/// YAML with the frame of each joint in the previous one (m, rad).
pub(super) struct UniversalRobots;

const LINKS: [&str; 6] = ["shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"];

impl Exporter for UniversalRobots {
    fn name(&self) -> &'static str {
        "universal-robots"
    }

    fn file_name(&self) -> &'static str {
        "universal_robots_calibration.yaml"
    }

    fn unsuited(&self, given: &Given) -> Option<Message> {
        let robot = given.robot?;
        six_axes(self.name(), robot, &robot.nominal()).err()
    }

    fn concern(&self, given: &Given) -> Option<Message> {
        let robot = given.robot?;
        let chain = six_axes(self.name(), robot, &robot.nominal()).ok()?;
        let difference = difference(&chain)?;
        Some(warning!("file-of-other-structure", format = self.name(), difference))
    }

    fn states_controller_hash(&self) -> bool {
        true
    }

    fn holds(&self, parameter: &Parameter, _given: &Given) -> bool {
        is_geometry(parameter)
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        let chain = six_axes(self.name(), robot, &values)?;
        let joint = |(link, joint): (&&'static str, &ChainJoint)| {
            let (xyz, rpy) = (joint.origin.translation_mm.map(|mm| mm / 1000.0), joint.origin.rpy_rad());
            context! { link => link.to_string(), xyz => Serde(xyz), rpy => Serde(rpy), gain => joint.gain }
        };
        let joints: Vec<Value> = LINKS.iter().zip(&chain.joints).map(joint).collect();
        let mut header = given.header_of_geometry("m, rad")?;
        header
            .push("ur_description reads this file (kinematics_params_file); the controller itself does not".to_owned());
        header.extend(
            self.concern(given).map(|_| "the axes of this arm are not those of Universal Robots arms".to_owned()),
        );
        let nominal = six_axes(self.name(), robot, &robot.nominal())?;
        header.extend(moved(&nominal.flange, &chain.flange).map(|(xyz, rpy)| {
            format!("flange in the frame of wrist_3: xyz {xyz} mm, rpy {rpy} deg; ur_description has the nominal flange: teach tools again")
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

/// Position (mm) and angles (deg) of a flange that is not at its nominal position after the last
/// joint: the file has no frame for it.
fn moved(nominal: &Pose, flange: &Pose) -> Option<(String, String)> {
    let shift = norm(minus(flange.translation_mm, nominal.translation_mm));
    let cells = flange.rotation.as_flattened().iter().zip(nominal.rotation.as_flattened());
    let turn = cells.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let listed = |v: [f64; 3]| v.map(|v| format!("{v:?}")).join(" ");
    let angles = flange.rpy_rad().map(f64::to_degrees);
    (shift > ROUNDING || turn > ROUNDING).then(|| (listed(flange.translation_mm), listed(angles)))
}

/// First difference of the axes from those of a Universal Robots arm; `None` for such an arm.
///
/// Axes 2, 3 and 4 are parallel, all other neighbours perpendicular; axis 1 meets axis 2, axis 5
/// meets axes 4 and 6 at different points, and these lie beside the plane of axis 1 and the arm
/// (Universal Robots, "DH parameters for calculations of kinematics and dynamics"). These are
/// properties of neighbouring axes, whatever the convention and the zeros of the joints.
fn difference(chain: &JointChain) -> Option<Phrase> {
    let mut frames: Vec<Pose> = Vec::new();
    for joint in &chain.joints {
        frames.push(frames.last().map_or(joint.origin, |last| last.then(&joint.origin)));
    }
    let axes: Vec<(Vector, Vector)> = frames.iter().map(|f| (f.translation_mm, f.axis(2))).collect();
    for (i, expected) in [90.0, 0.0, 0.0, 90.0, 90.0].into_iter().enumerate() {
        let deg = dot(axes[i].1, axes[i + 1].1).abs().min(1.0).acos().to_degrees();
        if (deg - expected).abs() > LARGEST_TILT_DEG {
            return Some(phrase!("structure-angle", first = i + 1, second = i + 2, deg, expected));
        }
    }
    let links = [1, 2].map(|i| beside(minus(axes[i + 1].0, axes[i].0), axes[i].1));
    let none_mm = NONE * (links[0] + links[1]);
    if let Some(i) = links.iter().position(|link| *link <= none_mm) {
        return Some(phrase!("structure-no-link", first = i + 2, second = i + 3, mm = links[i]));
    }
    for i in [0, 3, 4] {
        let (z, next) = (axes[i].1, axes[i + 1].1);
        let mm = dot(minus(axes[i + 1].0, axes[i].0), cross(z, next)).abs();
        if mm > none_mm {
            return Some(phrase!("structure-apart", first = i + 1, second = i + 2, mm));
        }
    }
    let [wrist, last] = [foot(axes[4], axes[3]), foot(axes[4], axes[5])];
    let mm = norm(minus(last, wrist));
    if mm <= none_mm {
        return Some(phrase!("structure-wrist-meets", mm));
    }
    let mm = dot(minus(wrist, axes[0].0), axes[1].1).abs();
    (mm <= none_mm).then(|| phrase!("structure-wrist-in-plane", mm))
}

/// Distance of a point from an axis through the origin.
fn beside(point: Vector, z: Vector) -> f64 {
    norm(cross(point, z))
}

/// Point of the first axis that is nearest to the second, which is not parallel.
fn foot(first: (Vector, Vector), second: (Vector, Vector)) -> Vector {
    let common = cross(first.1, second.1);
    let along = dot(cross(minus(second.0, first.0), second.1), common) / dot(common, common);
    [0, 1, 2].map(|i| first.0[i] + along * first.1[i])
}
