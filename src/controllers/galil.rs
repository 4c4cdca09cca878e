//! Galil DMC: parameters as variables of a program, in units for which the controller's fixed-point
//! numbers are fine enough.
//!
//! A variable has four bytes before the point and two after it (DMC-2x00 manual): lengths are in
//! µm, angles in 1E-6 deg, ratios in 1E-6. The inverse kinematics of a PreXYT keeps factors of
//! lengths multiplied by a thousand or a million: a tangent in steps of 1/65536 would have an error
//! of 3 µm at a lever of 400 mm.

use super::decimals::fixed;
use super::{About, ExportInput, Exporter, value};
use etalon_base::error;
use etalon_base::message::{Message, Problems, Result};
use etalon_documents::ParameterEntry;
use std::collections::BTreeSet;
use std::fmt::Write;

/// DMC commands.
pub(super) struct Galil;

/// Steps of a variable per unit.
const STEPS: f64 = 65_536.0;
/// Maximum value of a variable.
const LARGEST: f64 = 2_147_483_647.0;
/// Maximum rounding of a value relative to its standard uncertainty.
const SHARE: f64 = 0.1;
/// Maximum length of a variable's name.
const LONGEST: usize = 8;

impl Exporter for Galil {
    fn about(&self) -> About<'_> {
        About::controller("galil", "etalon_parameters.dmc")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let header = given.header("um, 1E-6 deg, 1E-6; a variable is a multiple of 1/65536")?;
        let mut out: String = header.iter().map(|line| format!("REM {line}\n")).collect();
        out += "#CALPAR\n";
        let mut problems = Problems::default();
        let names = variables(given.parameters.parameters.iter().map(|p| p.name.as_str()));
        for (p, name) in given.parameters.parameters.iter().zip(names) {
            match fixed_point(p) {
                Ok(Fixed { value, rounding }) => {
                    let unit = printed_unit(p);
                    let name_of = super::comment(&p.name);
                    let _ = writeln!(out, "REM {name_of} in {unit}, rounding {rounding:.1e} {unit}\n{name}={value}");
                }
                Err(message) => problems.0.push(message),
            }
        }
        problems.check()?;
        out += "EN\n";
        if given.robot.is_some_and(|robot| robot.model() == "prexyt") {
            out += &prexyt(given)?;
        }
        Ok(out.into_bytes())
    }
}

/// Inverse kinematics of a PreXYT (thesis, eq. 3.12 to 3.14), in operations from left to right.
/// `KWTAN` is tan θ by its series, accurate to 1E-9 within 20 degrees. KWE1 to KWE3 are the excess
/// of inverse ratios over one, KWBETA and KWGAMMA are tangents; all are in 1E-6.
const PREXYT: &str = "\
#PREXYT
REM JS#PREXYT: joint values KWR1, KWR2, KWR3 in um of the platform at KWX, KWY in um and
REM KWT in 1E-6 deg in the base, 20 deg at most, off by less than 0.05 um within 700 mm
REM KWOK is 1 where it is
KWOK=0
IF (@ABS[KWT]<=20000000)
KWOK=1
ENDIF
KWRAD=KWT/57295.779513
KWSQ=KWRAD*KWRAD/1000
KWTAN=KWSQ*1.455834/1000+3.592128
KWTAN=KWTAN*KWSQ/1000+8.863236
KWTAN=KWTAN*KWSQ/1000+21.869489
KWTAN=KWTAN*KWSQ/1000+53.968254
KWTAN=KWTAN*KWSQ/1000+133.333333
KWTAN=KWTAN*KWSQ/1000+333.333333
KWTAN=KWTAN*KWSQ/1000+1000
KWTAN=KWTAN*KWRAD/1000
KWR1=KWX-KWD-(KWY/1000*KWGAMMA/1000)
KWR1=KWR1/1000*KWE1/1000+KWR1
KWR2=KWY-(KWX/1000*KWTAN)
KWR2=KWR2/1000*KWE2/1000+KWR2
KWTILT=KWTAN*KWBETA/1000
KWTILT=KWTILT*1000/(KWTILT/1000+1000)
KWR3=KWS-KWX/1000*KWTAN+KWY-KWD3
KWR3=KWR3-(KWR3/1000*KWTILT/1000)
KWR3=KWR3/1000*KWE3/1000+KWR3
EN
";
/// Maximum tilt of a rail, deviation of a ratio from one, and length, in units of the program;
/// products stay within the range of a variable.
const MOST_TILT: f64 = 1e5;
const MOST_RATIO: f64 = 5e5;
const MOST_LENGTH: f64 = 2e6;

fn prexyt(given: &ExportInput) -> Result<String> {
    let (robot, values) = given.robot()?;
    let of = |name: &str| value(robot, &values, name);
    let (beta, d3) = (of("beta")?, of("d3")?);
    let constants = [
        ("KWBETA", beta.tan() * 1e6, MOST_TILT),
        ("KWGAMMA", of("gamma")?.tan() * 1e6, MOST_TILT),
        ("KWE1", (1.0 / of("delta")? - 1.0) * 1e6, MOST_RATIO),
        ("KWE2", (1.0 / of("delta2")? - 1.0) * 1e6, MOST_RATIO),
        ("KWE3", (1.0 / (of("delta3")? * beta.cos()) - 1.0) * 1e6, MOST_RATIO),
        ("KWD", of("d")? * 1e3, MOST_LENGTH),
        ("KWD3", d3 * 1e3, MOST_LENGTH),
        ("KWS", (of("s")? - d3 * beta.tan()) * 1e3, MOST_LENGTH),
    ];
    let mut out = "REM constants of #PREXYT\n#PRXCON\n".to_owned();
    for (name, value, most) in constants {
        // NaN is rejected too
        if value.abs() <= most {
            let _ = writeln!(out, "{name}={}", fixed(value, 6));
        } else {
            return Err(error!("galil-constant-too-large", name, value, most).into());
        }
    }
    Ok(out + "EN\n" + PREXYT)
}

/// A value in the controller, and its rounding.
struct Fixed {
    value: f64,
    rounding: f64,
}

fn unit(p: &ParameterEntry) -> &'static str {
    if p.unit == "mm" { "um" } else { "1E-6 deg" }
}

/// Unit of a variable, with the load or temperature to which the value refers.
fn printed_unit(p: &ParameterEntry) -> String {
    let reference = || p.full_unit.as_deref().and_then(|full| full.strip_prefix(p.unit.as_str()));
    match (&p.full_unit, p.unit.as_str()) {
        (Some(full), "1") => super::comment(&format!("1E-6 {full}")),
        (None, "1") => "1E-6".to_owned(),
        _ => super::comment(&format!("{}{}", unit(p), reference().unwrap_or_default())),
    }
}

fn fixed_point(p: &ParameterEntry) -> std::result::Result<Fixed, Message> {
    let scale = if p.unit == "mm" { 1e3 } else { 1e6 };
    let value = (p.value * scale * STEPS).round() / STEPS;
    let rounding = (value - p.value * scale).abs();
    if value.abs() > LARGEST {
        return Err(error!("galil-value-too-large", parameter = p.name));
    }
    match p.standard_uncertainty {
        Some(u) if rounding > SHARE * u * scale => {
            let (rounding, unit) = (rounding / scale, &p.unit);
            Err(error!("galil-rounding", parameter = p.name, rounding, unit, uncertainty = u))
        }
        _ => Ok(Fixed { value, rounding }),
    }
}

/// Variables of all names; the last characters of a variable that is taken become a number.
fn variables<'n>(names: impl Iterator<Item = &'n str>) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let free = |name: &'n str| {
        let own = variable(name);
        let numbered = (2..).map(|number: usize| {
            let number = number.to_string();
            own.chars().take(LONGEST - number.len()).chain(number.chars()).collect()
        });
        let name = std::iter::once(own.clone()).chain(numbered).find(|name: &String| taken.insert(name.clone()));
        name.unwrap_or(own)
    };
    names.map(free).collect()
}

/// KV with the letters and digits of a name; no command has three or more letters.
fn variable(name: &str) -> String {
    let safe = name.chars().filter(char::is_ascii_alphanumeric).map(|c| c.to_ascii_uppercase());
    "KV".chars().chain(safe).take(LONGEST).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_eight_characters_are_distinct() {
        let names = ["base_rx", "theta_2", "compliance_2_load", "compliance_3_load", "compliance_2", "KV"];
        let found = variables(names.into_iter());
        assert_eq!(found, ["KVBASERX", "KVTHETA2", "KVCOMPLI", "KVCOMPL2", "KVCOMPL3", "KVKV"]);
    }
}
