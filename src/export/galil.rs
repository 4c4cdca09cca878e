//! Galil DMC: parameters as variables of a program, in units in which the controller's fixed point is fine enough.
//!
//! A variable has four bytes before the point and two behind it (DMC-2x00 manual): lengths are in um, angles in 1E-6 deg, ratios in 1E-6.

use super::{Exporter, Given};
use crate::base::message::{Message, Problems, Result};
use crate::document::ParameterEntry;
use std::collections::BTreeMap;
use std::fmt::Write;

/// DMC commands.
pub(super) struct Galil;

/// Steps of a variable for one.
const STEPS: f64 = 65_536.0;
/// Largest variable.
const LARGEST: f64 = 2_147_483_647.0;
/// The rounding of a value may be this much of its standard uncertainty.
const SHARE: f64 = 0.1;
/// Longest name of a variable.
const LONGEST: usize = 8;

impl Exporter for Galil {
    fn file_name(&self) -> &'static str {
        "etalon_parameters.dmc"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let header = given.header("um, 1E-6 deg, 1E-6; a variable is a multiple of 1/65536")?;
        let mut out: String = header.iter().map(|line| format!("REM {line}\n")).collect();
        out += "#CALPAR\n";
        let (mut seen, mut problems) = (BTreeMap::new(), Problems::default());
        for p in &given.parameters.parameters {
            let name = variable(&p.name);
            if let Some(other) = seen.insert(name.clone(), &p.name) {
                let what = format!("parameters `{other}` and `{}` are both `{name}` on a Galil controller", p.name);
                problems.0.push(Message::error(what).hint("rename one of them, or use another format"));
            }
            match fixed_point(p) {
                Ok(Fixed { value, rounding }) => {
                    let unit = if p.unit == "1" { "1E-6" } else { unit(p) };
                    let name_of = super::comment(&p.name);
                    let _ = writeln!(out, "REM {name_of} in {unit}, rounding {rounding:.1e} {unit}\n{name}={value}");
                }
                Err(message) => problems.0.push(message),
            }
        }
        problems.check()?;
        Ok((out + "EN\n").into_bytes())
    }
}

/// A value as the controller holds it, and what is lost.
struct Fixed {
    value: f64,
    rounding: f64,
}

fn unit(p: &ParameterEntry) -> &'static str {
    if p.unit == "mm" { "um" } else { "1E-6 deg" }
}

fn fixed_point(p: &ParameterEntry) -> std::result::Result<Fixed, Message> {
    let scale = if p.unit == "mm" { 1e3 } else { 1e6 };
    let value = (p.value * scale * STEPS).round() / STEPS;
    let rounding = (value - p.value * scale).abs();
    if value.abs() > LARGEST {
        return Err(Message::error(format!("`{}` is too large for a variable of a Galil controller", p.name)));
    }
    match p.standard_uncertainty {
        Some(u) if rounding > SHARE * u * scale => {
            let (rounding, u) = (rounding / scale, u);
            let what = format!(
                "`{}` loses {rounding:.1e} {} on a Galil controller, its uncertainty is {u:.1e}",
                p.name, p.unit
            );
            Err(Message::error(what).hint("use a format of floating-point numbers"))
        }
        _ => Ok(Fixed { value, rounding }),
    }
}

/// KV and the letters and digits of a name: no command has three letters and more.
fn variable(name: &str) -> String {
    let safe = name.chars().filter(char::is_ascii_alphanumeric).map(|c| c.to_ascii_uppercase());
    "KV".chars().chain(safe).take(LONGEST).collect()
}
