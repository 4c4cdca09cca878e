//! URScript (Universal Robots): `movej` to a list of six joint values in rad (URScript manual,
//! `movej`, `sleep`, `textmsg`,
//! `set_standard_digital_out`).

use super::{ARM, MeasuringLanguage, MeasuringProgram, Output, plain};
use crate::commands::number_text;
use std::fmt::Write;

pub(super) struct UrScript;

/// Number of decimals of an angle (rad): 1e-8 rad are less than 1e-6 deg.
const DECIMALS: usize = 8;

impl MeasuringLanguage for UrScript {
    fn outputs(&self) -> Output {
        Output::Number([0, 7])
    }

    fn text(&self, program: &MeasuringProgram) -> String {
        let mut out = program.comments("#") + "def etalon_measure():\n";
        for stop in &program.stops {
            let label = plain(&stop.label);
            let _ = writeln!(out, "  # pose {label}\n  textmsg(\"pose {label}\")");
            for joints in stop.approach.iter().chain([&stop.joints]) {
                let values = joints.iter().take(ARM).map(|q| number_text(q.to_radians(), DECIMALS));
                let _ = writeln!(out, "  movej([{}], a=0.5, v=0.2)", values.collect::<Vec<_>>().join(", "));
            }
            let state = |is_on: bool| if is_on { "True" } else { "False" };
            let set = |output: &str, is_on: bool| format!("  set_standard_digital_out({output}, {})", state(is_on));
            let waits = program.waits(|seconds| format!("  sleep({})", super::decimal(seconds)), set);
            waits.iter().for_each(|line| out += &format!("{line}\n"));
        }
        out + "end\n"
    }
}
