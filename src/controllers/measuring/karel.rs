//! Karel (FANUC) as source (`.kl`), which `ktrans` translates: joint values in deg by
//! `CNV_REL_JPOS`, and `MOVE TO`. Statements: FANUC KAREL Reference Manual MARRCRLRF04071E
//! (`CNV_REL_JPOS`, `MOVE TO`, `DELAY`, `DOUT`).

use super::{ARM, MeasuringLanguage, MeasuringProgram, Output, identifier, plain, rounded};
use crate::decimals::fixed;

pub(super) struct Karel;

/// Number of decimals of an angle (deg). A REAL of Karel has 24 bits, 1e-5 deg of 180 deg.
const DECIMALS: usize = 4;
/// Maximum number of characters of a program's name.
const NAME: usize = 12;

/// Moves to joint values, or ends where they cannot be a position.
const MOVE: &str = "ROUTINE drive(a, b, c, d, e, f : REAL)
BEGIN
  joints[1] = a
  joints[2] = b
  joints[3] = c
  joints[4] = d
  joints[5] = e
  joints[6] = f
  CNV_REL_JPOS(joints, goal, status)
  IF status <> 0 THEN
    ABORT
  ENDIF
  MOVE TO goal
END drive
";

impl MeasuringLanguage for Karel {
    fn outputs(&self) -> Output {
        Output::Number([1, 65535])
    }

    fn attained(&self, value: f64, _: f64) -> f64 {
        rounded(value, DECIMALS)
    }

    fn text(&self, program: &MeasuringProgram) -> String {
        let name = identifier(program.name, NAME).to_ascii_uppercase();
        let mut out = vec![format!("PROGRAM {name}"), program.comments("--").trim_end().to_owned(), "VAR".to_owned()];
        let variables = ["joints : ARRAY[6] OF REAL", "goal : JOINTPOS", "status : INTEGER"];
        out.extend(variables.map(|variable| format!("  {variable}")));
        out.extend([MOVE, "BEGIN\n  $MOTYPE = JOINT\n  $TERMTYPE = FINE"].map(str::to_owned));
        for stop in &program.stops {
            // a quotation mark ends a text
            let label = plain(&stop.label).replace('\'', "?");
            out.extend([format!("  -- pose {label}"), format!("  WRITE('pose {label}', CR)")]);
            for joints in stop.approach.iter().chain([&stop.joints]) {
                let values: Vec<String> = joints.iter().take(ARM).map(|&q| fixed(q, DECIMALS)).collect();
                out.push(format!("  drive({})", values.join(", ")));
            }
            let state = |is_on: bool| if is_on { "ON" } else { "OFF" };
            let set = |output: &str, is_on: bool| format!("  DOUT[{output}] = {}", state(is_on));
            out.extend(program.waits(|seconds| format!("  DELAY {:.0}", 1000.0 * seconds), set));
        }
        out.push(format!("END {name}"));
        out.join("\n") + "\n"
    }
}
