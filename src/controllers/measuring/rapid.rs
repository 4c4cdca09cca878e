//! RAPID (ABB): `MoveAbsJ` to `[[axes 1 to 6 (deg)], [external axes a to f (mm)]]`, with 9E9 for
//! axes that do not exist (RAPID reference manual, `MoveAbsJ`, `jointtarget`, `WaitTime`, `SetDO`).

use super::{ARM, MeasuringLanguage, MeasuringProgram, Moves, Output, decimal, plain};
use std::fmt::Write;

pub(super) struct Rapid;

/// Number of external axes of a `jointtarget`.
const EXTERNAL: usize = 6;

impl MeasuringLanguage for Rapid {
    fn moves(&self) -> Moves {
        Moves::Arm { external: EXTERNAL }
    }

    fn outputs(&self) -> Output {
        Output::Signal
    }

    fn text(&self, program: &MeasuringProgram) -> String {
        let mut out = program.comments("!") + "MODULE EtalonMeasuring\n  PROC etalon_measure()\n";
        for stop in &program.stops {
            let label = plain(&stop.label);
            let _ = writeln!(out, "    ! pose {label}\n    TPWrite \"pose {label}\";");
            for joints in stop.approach.iter().chain([&stop.joints]) {
                let (external, arm) = joints.split_at(program.external());
                let mut others: Vec<String> = external.iter().copied().map(decimal).collect();
                others.resize(EXTERNAL, "9E+09".to_owned());
                let arm: Vec<String> = arm.iter().take(ARM).copied().map(decimal).collect();
                let _ = writeln!(
                    out,
                    "    MoveAbsJ [[{}],[{}]]\\NoEOffs,v100,fine,tool0;",
                    arm.join(","),
                    others.join(",")
                );
            }
            let set = |output: &str, is_on: bool| format!("    SetDO {output},{};", u8::from(is_on));
            let waits = program.waits(|seconds| format!("    WaitTime \\InPos,{};", decimal(seconds)), set);
            waits.iter().for_each(|line| out += &format!("{line}\n"));
        }
        out + "  ENDPROC\nENDMODULE\n"
    }
}
