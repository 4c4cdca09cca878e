//! G-code (LinuxCNC, grblHAL): `G53 G1` to the values of joints, for machines whose axes are their
//! joints: trivial kinematics, or kinematics switched to identity (LinuxCNC documentation: G-codes
//! G1, G4, G53; M-codes M64, M65).

use super::{MeasuringLanguage, MeasuringProgram, Moves, Output, decimal, plain};
use std::fmt::Write;

pub(super) struct Gcode;

impl MeasuringLanguage for Gcode {
    fn moves(&self) -> Moves {
        Moves::Axes
    }

    fn outputs(&self) -> Output {
        Output::Number([0, 63])
    }

    fn text(&self, program: &MeasuringProgram) -> String {
        let comment = |text: &str| plain(text).replace(['(', ')'], " ");
        let mut out: String = program.header.iter().map(|line| format!("({})\n", comment(line))).collect();
        out += "G21 G90 G94 F600\n";
        for stop in &program.stops {
            let label = comment(&stop.label);
            let _ = writeln!(out, "(pose {label})\n(MSG, pose {label})");
            for joints in stop.approach.iter().chain([&stop.joints]) {
                let words =
                    program.stated.axes.chars().zip(joints).map(|(letter, q)| format!(" {letter}{}", decimal(*q)));
                let _ = writeln!(out, "G53 G1{}", words.collect::<String>());
            }
            let set = |output: &str, is_on: bool| format!("{} P{output}", if is_on { "M64" } else { "M65" });
            let waits = program.waits(|seconds| format!("G4 P{}", decimal(seconds)), set);
            waits.iter().for_each(|line| out += &format!("{line}\n"));
        }
        out + "M2\n"
    }
}
