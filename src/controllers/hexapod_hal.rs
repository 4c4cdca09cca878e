//! Kinematics of LinuxCNC's `genhexkins`: the joints of six legs at either end. Lengths at joint value zero go to the joints.

use super::{Exporter, Given, value};
use etalon_base::message::{Message, Result};
use std::fmt::Write;

/// HAL commands.
pub(super) struct HexapodHal;

impl Exporter for HexapodHal {
    fn file_name(&self) -> &'static str {
        "genhexkins.hal"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        if robot.model() != "hexapod" {
            let message = Message::error(format!("`{}` is not a hexapod", robot.model()));
            return Err(message.hint("`genhexkins` of LinuxCNC computes platforms on six legs only").into());
        }
        let of = |name: String| value(robot, &values, &name);
        let mut out = String::new();
        for line in given.header("mm")? {
            let _ = writeln!(out, "# {line}");
        }
        for leg in 0..6 {
            let number = leg + 1;
            let _ = writeln!(
                out,
                "# joint {leg}: its position in LinuxCNC is the joint value + {:?}: add that to its HOME_OFFSET",
                of(format!("leg{number}_l0"))?
            );
            for (end, letter) in [("base", 'b'), ("platform", 'a')] {
                for axis in ["x", "y", "z"] {
                    let at = of(format!("leg{number}_{letter}{axis}"))?;
                    let _ = writeln!(out, "setp genhexkins.{end}.{leg}.{axis} {at:?}");
                }
            }
        }
        Ok(out.into_bytes())
    }
}
