//! KRL (KUKA): `PTP {A1 .., A6 .., E1 ..}` in deg and mm, with an exact stop (KUKA System Software,
//! operating and programming instructions).

use super::{ARM, MeasuringLanguage, MeasuringProgram, Moves, Output, decimal, plain};
use crate::commands::identifier;
use std::fmt::Write;

pub(super) struct Krl;

impl MeasuringLanguage for Krl {
    fn moves(&self) -> Moves {
        Moves::Arm { external: 6 }
    }

    fn outputs(&self) -> Output {
        Output::Number([1, 4096])
    }

    fn text(&self, program: &MeasuringProgram) -> String {
        // program and file have the same name
        let mut out = format!("DEF {}( )\n", identifier(program.name, 24));
        out += &program.comments(";");
        out += "DECL INT I\nBAS (#INITMOV,0)\nFOR I=1 TO 6\n$VEL_AXIS[I]=10\nENDFOR\n";
        for stop in &program.stops {
            let _ = writeln!(out, "; pose {}", plain(&stop.label));
            for joints in stop.approach.iter().chain([&stop.joints]) {
                let (external, arm) = joints.split_at(program.external());
                let arm = arm.iter().take(ARM).zip(1..).map(|(q, i)| format!("A{i} {}", decimal(*q)));
                let external = external.iter().zip(1..).map(|(q, i)| format!("E{i} {}", decimal(*q)));
                let _ = writeln!(out, "PTP {{{}}}", arm.chain(external).collect::<Vec<_>>().join(","));
            }
            let state = |is_on: bool| if is_on { "TRUE" } else { "FALSE" };
            let set = |output: &str, is_on: bool| format!("$OUT[{output}]={}", state(is_on));
            let waits = program.waits(|seconds| format!("WAIT SEC {}", decimal(seconds)), set);
            waits.iter().for_each(|line| out += &format!("{line}\n"));
        }
        out + "END\n"
    }
}
