//! INFORM (Yaskawa) as a job (`.jbi`): `MOVJ` to pulses of the motors, the only joint values that
//! every generation of controllers loads. Layout of public jobs: see `docs/planning.md`.

use super::{MeasuringLanguage, MeasuringProgram, Moves, Output, identifier, lines, plain};
use crate::decimals::fixed;

pub(super) struct Inform;

/// Maximum number of characters of a comment or a message.
const TEXT: usize = 32;
/// Date of every job: the controller writes its own when a job is edited.
const DATE: &str = "2000/01/01 00:00";

impl MeasuringLanguage for Inform {
    fn moves(&self) -> Moves {
        // base axes of a control group
        Moves::Arm { external: 3 }
    }

    fn outputs(&self) -> Output {
        Output::Number([1, 4096])
    }

    fn needs_pulses(&self) -> bool {
        true
    }

    fn attained(&self, value: f64, pulses: f64) -> f64 {
        (value * pulses).round() / pulses
    }

    fn text(&self, program: &MeasuringProgram) -> String {
        let external = program.external();
        let pulses = |values: &[f64], of: &[f64]| {
            let all = values.iter().zip(of).map(|(value, pulses)| fixed((value * pulses).round(), 0));
            all.collect::<Vec<_>>().join(",")
        };
        let (mut arm, mut base) = (Vec::new(), Vec::new());
        let mut steps: Vec<String> = lines(&program.header, TEXT).map(|line| format!("'{line}")).collect();
        for stop in &program.stops {
            let label: String = format!("pose {}", plain(&stop.label)).chars().take(TEXT).collect();
            steps.extend([format!("'{label}"), format!("MSG \"{label}\"")]);
            for joints in stop.approach.iter().chain([&stop.joints]) {
                let place = arm.len();
                let (of_base, of_arm) = joints.split_at(external);
                arm.push(format!("C{place:05}={}", pulses(of_arm, &program.stated.pulses[external..])));
                let moved = if external > 0 { format!(" BC{place:05}") } else { String::new() };
                base.extend((external > 0).then(|| format!("BC{place:05}={}", pulses(of_base, program.stated.pulses))));
                steps.push(format!("MOVJ C{place:05}{moved} VJ=10.00 PL=0"));
            }
            let state = |is_on: bool| if is_on { "ON" } else { "OFF" };
            let set = |output: &str, is_on: bool| format!("DOUT OT#({output}) {}", state(is_on));
            steps.extend(program.waits(|seconds| format!("TIMER T={seconds:.2}"), set));
        }
        let mut out = vec!["/JOB".to_owned()];
        out.push(format!("//NAME {}", identifier(program.name, TEXT).to_ascii_uppercase()));
        out.extend(["//POS".to_owned(), format!("///NPOS {},{},0,0,0,0", arm.len(), base.len())]);
        out.extend(["///TOOL 0", "///POSTYPE PULSE", "///PULSE"].map(str::to_owned));
        out.append(&mut arm);
        out.append(&mut base);
        out.extend(["//INST".to_owned(), format!("///DATE {DATE}"), "///ATTR SC,RW".to_owned()]);
        out.push(format!("///GROUP1 RB1{}", if external > 0 { ",BS1" } else { "" }));
        out.push("NOP".to_owned());
        out.append(&mut steps);
        out.push("END".to_owned());
        out.iter().map(|line| format!("{line}\r\n")).collect()
    }
}
