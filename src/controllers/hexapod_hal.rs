//! Kinematics of LinuxCNC's `genhexkins`: both ends of the six legs. Lengths at joint value zero
//! are offsets of the joints.

use super::template::render;
use super::{About, ExportInput, Exporter};
use etalon_base::message::{Message, Result};
use etalon_base::phrase;
use etalon_robots::Robot;
use minijinja::context;
use minijinja::value::Serde;
use std::collections::BTreeMap;

/// HAL commands.
pub(super) struct HexapodHal;

impl Exporter for HexapodHal {
    fn about(&self) -> About<'_> {
        About {
            frame: "the world of LinuxCNC is the base of the robot, the base in the world of the campaign is not in this file",
            ..About::controller("linuxcnc-hexapod", "genhexkins.hal")
        }
    }

    fn unsuited_robot(&self, robot: &dyn Robot) -> Option<Message> {
        (robot.model() != "hexapod").then(|| super::other_robot(self.name(), robot, phrase!("kind-hexapod")))
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        let values: BTreeMap<&str, f64> = robot.parameters().iter().map(|p| p.name.as_str()).zip(values).collect();
        let values = context! { header => given.header("mm")?, values => Serde(values) };
        render(include_str!("templates/genhexkins.hal.j2"), values).map(String::into_bytes)
    }
}
