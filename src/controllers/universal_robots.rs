//! Calibration of a Universal Robots arm in the format of the ROS description packages
//! (`kinematics_params_file`: ur_description, ur_calibration).

use super::template::render;
use super::{Exporter, Given, is_geometry, roll_pitch_yaw, six_axes};
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Pose, minus, norm};
use etalon_robots::{ChainJoint, Parameter};
use minijinja::value::Serde;
use minijinja::{Value, context};

/// Largest shift (mm) and rotation (cells of the rotation matrix) of a flange that is attributed to
/// rounding.
const ROUNDING: f64 = 1e-9;

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
            let (xyz, rpy) = (joint.origin.translation_mm.map(|mm| mm / 1000.0), roll_pitch_yaw(&joint.origin));
            context! { link => link.to_string(), xyz => Serde(xyz), rpy => Serde(rpy), gain => joint.gain }
        };
        let joints: Vec<Value> = LINKS.iter().zip(&chain.joints).map(joint).collect();
        let mut header = given.header_of_geometry("m, rad")?;
        header
            .push("ur_description reads this file (kinematics_params_file); the controller itself does not".to_owned());
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
    let angles = roll_pitch_yaw(flange).map(f64::to_degrees);
    (shift > ROUNDING || turn > ROUNDING).then(|| (listed(flange.translation_mm), listed(angles)))
}
