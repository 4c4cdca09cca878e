//! Calibration of a Universal Robots arm in the format of the ROS description packages
//! (`kinematics_params_file`: ur_description, ur_calibration).

use super::template::render;
use super::{Exporter, Given, is_geometry, roll_pitch_yaw};
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_robots::{ChainJoint, Parameter};
use minijinja::value::Serde;
use minijinja::{Value, context};

/// YAML with the frame of each joint in the previous one (m, rad).
pub(super) struct UniversalRobots;

const LINKS: [&str; 6] = ["shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"];

impl Exporter for UniversalRobots {
    fn file_name(&self) -> &'static str {
        "universal_robots_calibration.yaml"
    }

    fn holds(&self, parameter: &Parameter, _given: &Given) -> bool {
        is_geometry(parameter)
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        let chain = robot.joint_chain(&values).filter(|c| c.joints.len() == 6 && c.joints.iter().all(|j| !j.prismatic));
        let chain = chain.ok_or_else(|| super::other_robot("universal-robots", robot, phrase!("kind-six-axis-arm")))?;
        let joint = |(link, joint): (&&'static str, &ChainJoint)| {
            let (xyz, rpy) = (joint.origin.translation_mm.map(|mm| mm / 1000.0), roll_pitch_yaw(&joint.origin));
            context! { link => link.to_string(), xyz => Serde(xyz), rpy => Serde(rpy), gain => joint.gain }
        };
        let joints: Vec<Value> = LINKS.iter().zip(&chain.joints).map(joint).collect();
        let mut header = given.header_of_geometry("m, rad")?;
        header
            .push("ur_description reads this file (kinematics_params_file); the controller itself does not".to_owned());
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
