//! Kinematics of LinuxCNC's `genhexkins`: both ends of the six legs. Lengths at joint value zero
//! are offsets of the joints.

use super::template::render;
use super::{Exporter, Given};
use etalon_base::message::Result;
use etalon_base::phrase;
use minijinja::context;
use minijinja::value::Serde;
use std::collections::BTreeMap;

/// HAL commands.
pub(super) struct HexapodHal;

impl Exporter for HexapodHal {
    fn file_name(&self) -> &'static str {
        "genhexkins.hal"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        if robot.model() != "hexapod" {
            return Err(super::other_robot("linuxcnc-hexapod", robot, phrase!("kind-hexapod")).into());
        }
        let values: BTreeMap<&str, f64> = robot.parameters().iter().map(|p| p.name.as_str()).zip(values).collect();
        let values = context! { header => given.header("mm")?, values => Serde(values) };
        render(include_str!("templates/genhexkins.hal.j2"), values).map(String::into_bytes)
    }
}
