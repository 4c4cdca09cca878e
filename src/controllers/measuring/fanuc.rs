//! TP (FANUC) as text (`.ls`): `J P[n] 10% FINE` to joint values in deg, as ROBOGUIDE and
//! controllers with the ASCII upload option load it. Layout of public programs: see
//! `docs/planning.md`.

use super::{ARM, MeasuringLanguage, MeasuringProgram, Output, identifier, lines, plain, rounded};
use crate::decimals::fixed;
use std::fmt::Write;

pub(super) struct Fanuc;

/// Number of decimals of an angle (deg).
const DECIMALS: usize = 3;
/// Maximum number of characters of a remark, and of a message on the pendant.
const REMARK: usize = 32;
const MESSAGE: usize = 24;

impl MeasuringLanguage for Fanuc {
    fn outputs(&self) -> Output {
        Output::Number([1, 65535])
    }

    fn attained(&self, value: f64, _: f64) -> f64 {
        rounded(value, DECIMALS)
    }

    fn text(&self, program: &MeasuringProgram) -> String {
        let mut points = Vec::new();
        let mut steps: Vec<String> = Vec::new();
        steps.extend(lines(&program.header, REMARK).map(|line| format!("  !{line} ;")));
        steps.extend(["  UFRAME_NUM=0 ;".to_owned(), "  UTOOL_NUM=1 ;".to_owned()]);
        for stop in &program.stops {
            let label = plain(&stop.label);
            steps.push(format!("  !{} ;", cut(&format!("pose {label}"), REMARK)));
            steps.push(format!("  MESSAGE[{}] ;", cut(&format!("pose {label}"), MESSAGE)));
            for joints in stop.approach.iter().chain([&stop.joints]) {
                points.push(joints);
                steps.push(format!("J P[{}] 10% FINE    ;", points.len()));
            }
            let state = |is_on: bool| if is_on { "ON" } else { "OFF" };
            let set = |output: &str, is_on: bool| format!("  DO[{output}]={} ;", state(is_on));
            steps.extend(program.waits(|seconds| format!("  WAIT {seconds:6.2}(sec) ;"), set));
        }
        let mut out = format!("/PROG  {}\n/ATTR\n", identifier(program.name, 8).to_ascii_uppercase());
        out += "OWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"ETALON\";\n";
        let _ = writeln!(out, "LINE_COUNT\t= {};", steps.len());
        out += "PROTECT\t\t= READ_WRITE;\nTCD:  STACK_SIZE\t= 0,\n      TASK_PRIORITY\t= 50,\n      TIME_SLICE\t= 0,\n";
        out += "      BUSY_LAMP_OFF\t= 0,\n      ABORT_REQUEST\t= 0,\n      PAUSE_REQUEST\t= 0;\n";
        out += "DEFAULT_GROUP\t= 1,*,*,*,*;\nCONTROL_CODE\t= 00000000 00000000;\n/MN\n";
        for (number, step) in steps.iter().enumerate() {
            let _ = writeln!(out, "{:4}:{step}", number + 1);
        }
        out += "/POS\n";
        for (number, joints) in points.iter().enumerate() {
            let values =
                joints.iter().take(ARM).zip(1..).map(|(q, i)| format!("\tJ{i}= {:>9} deg", fixed(*q, DECIMALS)));
            let values: Vec<String> = values.collect();
            let rows: Vec<String> = values.chunks(3).map(|row| row.join(",")).collect();
            let _ = writeln!(out, "P[{}]{{\n   GP1:\n\tUF : 0, UT : 1,\t\n{}\n}};", number + 1, rows.join(",\n"));
        }
        out + "/END\n"
    }
}

fn cut(text: &str, most: usize) -> String {
    text.chars().take(most).collect()
}
