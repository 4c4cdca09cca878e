//! URScript (Universal Robots): `movej` to a list of six joint values in rad (URScript manual,
//! `movej`, `sleep`, `textmsg`).

use super::{ARM, MeasuringLanguage, MeasuringProgram, plain};
use crate::commands::number_text;
use std::fmt::Write;

pub(super) struct UrScript;

/// Number of decimals of an angle (rad): 1e-8 rad are less than 1e-6 deg.
const DECIMALS: usize = 8;

impl MeasuringLanguage for UrScript {
    fn most_external(&self) -> usize {
        0
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
            let _ = writeln!(out, "  sleep({})", super::decimal(program.dwell_s));
        }
        out + "end\n"
    }
}
