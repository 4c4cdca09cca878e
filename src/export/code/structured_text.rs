//! Structured Text (IEC 61131-3): function blocks on LREAL, for TwinCAT, CODESYS and the like.

use super::{Notation, formulas, interface, kept, statements};
use crate::base::message::Result;
use crate::export::{Exporter, Given};
use std::fmt::Write;

/// Function blocks.
pub(in crate::export) struct StructuredText;

struct Iec;

/// A real literal of IEC 61131-3 has a point, and digits on both sides of it.
pub(in crate::export) fn real_literal(value: f64) -> String {
    let text = format!("{value:?}");
    match text.split_once('e') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.0E{exponent}"),
        Some((digits, exponent)) => format!("{digits}E{exponent}"),
        None => text,
    }
}

impl Notation for Iec {
    fn constant(&self, value: f64) -> String {
        let text = real_literal(value);
        if value.is_sign_negative() { format!("({text})") } else { text }
    }
    fn call(&self, function: &str, operands: &[&str]) -> String {
        let function = match function {
            "atan2" => "ETALON_ATAN2".to_owned(),
            "wrap" => "ETALON_WRAP".to_owned(),
            other => other.to_ascii_uppercase(),
        };
        format!("{function}({})", operands.join(", "))
    }
    /// The root of a negative number stops a controller: it is zero, and the output not valid.
    fn keep(&self, number: usize, value: &str) -> String {
        match value.strip_prefix("SQRT(").and_then(|rest| rest.strip_suffix(')')) {
            Some(of) => format!(
                "IF {of} < 0.0 THEN\n  valid := FALSE;\n  t[{number}] := 0.0;\nELSE\n  t[{number}] := {value};\nEND_IF;\n"
            ),
            None => format!("t[{number}] := {value};\n"),
        }
    }
}

const FUNCTIONS: &str = "
(* Angle of the vector (x, y), rad. *)
FUNCTION ETALON_ATAN2 : LREAL
VAR_INPUT
  y : LREAL;
  x : LREAL;
END_VAR
IF ABS(x) >= ABS(y) THEN
  IF x = 0.0 THEN
    ETALON_ATAN2 := 0.0;
  ELSIF x > 0.0 THEN
    ETALON_ATAN2 := ATAN(y / x);
  ELSIF y < 0.0 THEN
    ETALON_ATAN2 := ATAN(y / x) - 3.141592653589793;
  ELSE
    ETALON_ATAN2 := ATAN(y / x) + 3.141592653589793;
  END_IF;
ELSIF y > 0.0 THEN
  ETALON_ATAN2 := 1.5707963267948966 - ATAN(x / y);
ELSE
  ETALON_ATAN2 := -1.5707963267948966 - ATAN(x / y);
END_IF;
END_FUNCTION

(* An angle between -2 pi and 2 pi brought to -pi ... pi. *)
FUNCTION ETALON_WRAP : LREAL
VAR_INPUT
  angle : LREAL;
END_VAR
IF angle > 3.141592653589793 THEN
  ETALON_WRAP := angle - 6.283185307179586;
ELSIF angle < -3.141592653589793 THEN
  ETALON_WRAP := angle + 6.283185307179586;
ELSE
  ETALON_WRAP := angle;
END_IF;
END_FUNCTION
";

/// Newton's method, steps of at most half a radian or millimetre; `{N}`, `{L}` and `{J}` are the joints, the last of them, and the last
/// output of the linearised kinematics.
const INVERSE: &str = "
(* Joint values, mm and rad, of a pose: x, y, z, r11, r12 ... r33, looked for from `start`; valid where the pose is reached to 1e-9 mm and
   1e-12 rad. *)
FUNCTION_BLOCK FB_EtalonInverse
VAR_INPUT
  pose : ARRAY[0..11] OF LREAL;
  start : ARRAY[0..{L}] OF LREAL;
END_VAR
VAR_OUTPUT
  q : ARRAY[0..{L}] OF LREAL;
  valid : BOOL;
END_VAR
VAR
  linearised : FB_EtalonLinearised;
  reached : ARRAY[0..{J}] OF LREAL;
  a : ARRAY[0..{L}, 0..{N}] OF LREAL;
  e : ARRAY[0..5] OF LREAL;
  same : LREAL;
  longest : LREAL;
  trace : LREAL;
  factor : LREAL;
  kept : LREAL;
  i : INT;
  j : INT;
  k : INT;
  row : INT;
  best : INT;
  search : INT;
END_VAR
q := start;
longest := 1.0;
valid := FALSE;
FOR search := 0 TO 100 DO
  linearised(q := q);
  reached := linearised.out;
  same := 0.0;
  FOR i := 0 TO 2 DO
    e[i] := pose[i] - reached[i];
    e[3 + i] := 0.0;
  END_FOR;
  FOR i := 0 TO 2 DO
    same := same + reached[3 + i] * pose[3 + i] + reached[6 + i] * pose[6 + i] + reached[9 + i] * pose[9 + i];
    e[3] := e[3] + 500.0 * (reached[6 + i] * pose[9 + i] - reached[9 + i] * pose[6 + i]);
    e[4] := e[4] + 500.0 * (reached[9 + i] * pose[3 + i] - reached[3 + i] * pose[9 + i]);
    e[5] := e[5] + 500.0 * (reached[3 + i] * pose[6 + i] - reached[6 + i] * pose[3 + i]);
  END_FOR;
  IF longest < 1.0E-13 OR search = 100 THEN
    valid := SQRT(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) < 1.0E-9
      AND SQRT(e[3] * e[3] + e[4] * e[4] + e[5] * e[5]) < 1.0E-9 AND same > 2.0;
    RETURN;
  END_IF;
  trace := 0.0;
  FOR i := 0 TO {L} DO
    FOR j := 0 TO {N} DO
      a[i, j] := 0.0;
      FOR row := 0 TO 5 DO
        factor := reached[12 + 6 * i + row];
        IF j = {N} THEN
          kept := e[row];
        ELSE
          kept := reached[12 + 6 * j + row];
        END_IF;
        IF row > 2 THEN
          factor := 1000.0 * factor;
          IF j < {N} THEN
            kept := 1000.0 * kept;
          END_IF;
        END_IF;
        a[i, j] := a[i, j] + factor * kept;
      END_FOR;
    END_FOR;
    trace := trace + a[i, i];
  END_FOR;
  FOR i := 0 TO {L} DO
    a[i, i] := a[i, i] + 1.0E-14 * trace;
  END_FOR;
  FOR k := 0 TO {L} DO
    best := k;
    FOR i := k TO {L} DO
      IF ABS(a[i, k]) > ABS(a[best, k]) THEN
        best := i;
      END_IF;
    END_FOR;
    FOR j := 0 TO {N} DO
      kept := a[k, j];
      a[k, j] := a[best, j];
      a[best, j] := kept;
    END_FOR;
    FOR i := 0 TO {L} DO
      IF i <> k THEN
        factor := a[i, k] / a[k, k];
        FOR j := 0 TO {N} DO
          a[i, j] := a[i, j] - factor * a[k, j];
        END_FOR;
      END_IF;
    END_FOR;
  END_FOR;
  longest := 0.0;
  FOR i := 0 TO {L} DO
    a[i, {N}] := a[i, {N}] / a[i, i];
    longest := MAX(longest, ABS(a[i, {N}]));
  END_FOR;
  factor := 1.0;
  IF longest > 0.5 THEN
    factor := 0.5 / longest;
  END_IF;
  FOR i := 0 TO {L} DO
    q[i] := q[i] + factor * a[i, {N}];
  END_FOR;
END_FOR;
END_FUNCTION_BLOCK
";

impl Exporter for StructuredText {
    fn file_name(&self) -> &'static str {
        "etalon_kinematics.st"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let mut out: String = given.header("mm, rad")?.iter().map(|line| format!("(* {line} *)\n")).collect();
        out += FUNCTIONS;
        for formula in formulas(given)? {
            let (body, outputs) = statements(&formula, &Iec);
            let (first, rest) = formula.name.split_at(1);
            let name = format!("FB_Etalon{}{rest}", first.to_ascii_uppercase());
            let last = [formula.inputs.len(), outputs.len(), kept(&formula)].map(|n| n - 1);
            let arrays = last.map(|last| format!("ARRAY[0..{last}] OF LREAL"));
            let _ = write!(out, "\n(* {} *)\nFUNCTION_BLOCK {name}\n", interface(&formula));
            let _ = write!(
                out,
                "VAR_INPUT\n  q : {};\nEND_VAR\nVAR_OUTPUT\n  out : {};\n  valid : BOOL;\nEND_VAR\n",
                arrays[0], arrays[1]
            );
            let _ = write!(out, "VAR\n  t : {};\nEND_VAR\nvalid := TRUE;\n{body}", arrays[2]);
            for (i, name) in outputs.iter().enumerate() {
                let _ = writeln!(out, "out[{i}] := {name};");
            }
            out += "END_FUNCTION_BLOCK\n";
            if formula.name == "linearised" {
                let joints = formula.inputs.len();
                let numbered = INVERSE.replace("{N}", &joints.to_string()).replace("{L}", &last[0].to_string());
                out += &numbered.replace("{J}", &last[1].to_string());
            }
        }
        Ok(out.into_bytes())
    }
}
