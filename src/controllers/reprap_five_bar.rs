//! `M669 K9` of RepRapFirmware: a five-bar. Its angles are counted from the x axis of the world.

use super::{Exporter, Given, value};
use etalon_base::message::{Message, Result};
use std::fmt::Write;

/// G-code.
pub(super) struct RepRapFiveBar;

/// Decimals of the numbers: those of a float.
const DECIMALS: usize = 5;

impl Exporter for RepRapFiveBar {
    fn file_name(&self) -> &'static str {
        "reprap_five_bar.g"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let (robot, values) = given.robot()?;
        if robot.model() != "five_bar" {
            let message = Message::error(format!("`{}` is not a five-bar", robot.model()));
            return Err(message.hint("`M669 K9` of RepRapFirmware computes five-bars only").into());
        }
        let of = |name: &str| value(robot, &values, name);
        let placed = |name: &str| {
            let entry = given.parameters.parameters.iter().find(|entry| entry.name == name);
            entry.map(|entry| entry.value).ok_or_else(|| Message::error(format!("the parameters have no `{name}`")))
        };
        let (x, y, phi_deg) = (placed("x_o")?, placed("y_o")?, placed("phi")?);
        let (sin, cos) = phi_deg.to_radians().sin_cos();
        let half = 0.5 * of("d")?;
        let number = |v: f64| format!("{v:.DECIMALS$}");
        let both = |a: f64, b: f64| format!("{}:{}", number(a), number(b));
        let (gamma, l22, l23) = (of("gamma")?, of("l22")?, of("l23")?);
        let mut out = String::new();
        for line in given.header("mm, deg")? {
            let _ = writeln!(out, "; {line}");
        }
        if gamma != 0.0 {
            let _ = writeln!(
                out,
                "; not in this format: gamma = {:.6} deg; the tool is {:.6} mm beside the line of its link",
                gamma.to_degrees(),
                l23 * gamma.sin()
            );
        }
        let beyond = l23 * gamma.cos() - l22;
        if beyond < 0.0 {
            let _ = writeln!(
                out,
                "; not in this format: the tool is {:.6} mm before the joint of the distal links",
                -beyond
            );
        }
        let _ = writeln!(
            out,
            "; L2, both elbows outwards and the tool beyond the line from the left to the right one, is the only working and assembly mode; \
             B: the switches are at encoder value zero, else add theirs"
        );
        let home = |delta: f64| delta.to_degrees() + phi_deg;
        let _ = writeln!(
            out,
            "M669 K9 X{} Y{} P{} D{}:{}:{} L2 B{}",
            both(x - half * cos, x + half * cos),
            both(y - half * sin, y + half * sin),
            both(of("l11")?, of("l21")?),
            both(of("l12")?, l22),
            number(0.0),
            number(beyond.max(0.0)),
            both(home(of("delta1")?), home(of("delta2")?)),
        );
        Ok(out.into_bytes())
    }
}
