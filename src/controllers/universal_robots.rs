//! Calibration of a Universal Robots arm as the ROS description packages load it (`kinematics_params_file`: ur_description,
//! ur_calibration).

use super::{Exporter, Given, roll_pitch_yaw};
use etalon_base::message::{Message, Result};
use std::fmt::Write;

/// YAML, the frame of each joint in that of the one before, in metres and radians.
pub(super) struct UniversalRobots;

const LINKS: [&str; 6] = ["shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"];

impl Exporter for UniversalRobots {
    fn file_name(&self) -> &'static str {
        "universal_robots_calibration.yaml"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        let chain = robot.joint_chain(&values).filter(|c| c.joints.len() == 6 && c.joints.iter().all(|j| !j.prismatic));
        let chain = chain.ok_or_else(|| {
            let message = Message::error(format!("`{}` is not an arm of six joints that turn", robot.model()));
            message.hint("this format is that of Universal Robots' arms")
        })?;
        let header = given.header_of_geometry("m, rad")?;
        let mut out = String::new();
        for line in &header {
            let _ = writeln!(out, "# {line}");
        }
        for (name, joint) in LINKS.iter().zip(&chain.joints).filter(|(_, joint)| joint.gain != 1.0) {
            let _ = writeln!(out, "# not in this format: the joint of {name} moves {:?} times its value", joint.gain);
        }
        out += "kinematics:\n";
        for (name, joint) in LINKS.iter().zip(&chain.joints) {
            let [x, y, z] = joint.origin.translation_mm.map(|mm| mm / 1000.0);
            let [roll, pitch, yaw] = roll_pitch_yaw(&joint.origin);
            let _ = writeln!(out, "  {name}:\n    x: {x:?}\n    y: {y:?}\n    z: {z:?}");
            let _ = writeln!(out, "    roll: {roll:?}\n    pitch: {pitch:?}\n    yaw: {yaw:?}");
        }
        // the driver compares it with that of the controller's own calibration
        let hash = header.last().and_then(|line| line.rsplit(' ').next()).unwrap_or_default();
        let number = u64::from_str_radix(hash.get(..16).unwrap_or_default(), 16).unwrap_or_default();
        let _ = writeln!(out, "  hash: calib_{number}");
        Ok(out.into_bytes())
    }
}
