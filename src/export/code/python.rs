//! Python without dependencies but `math`.

use super::{Notation, formulas, interface, kept, parenthesised, statements};
use crate::base::message::Result;
use crate::export::{Exporter, Given};
use std::fmt::Write;

/// A module of functions.
pub(in crate::export) struct PythonCode;

struct Python;

impl Notation for Python {
    fn constant(&self, value: f64) -> String {
        parenthesised(value)
    }
    fn call(&self, function: &str, operands: &[&str]) -> String {
        format!("{function}({})", operands.join(", "))
    }
    fn keep(&self, number: usize, value: &str) -> String {
        format!("    t[{number}] = {value}\n")
    }
}

const WRAP: &str = "
def wrap(angle):
    return angle - 2.0 * pi if angle > pi else angle + 2.0 * pi if angle < -pi else angle
";

/// Newton's method with the recorded step.
const INVERSE: &str = "
def inverse(pose, start):
    \"\"\"Joint values, mm and rad, of a pose: x, y, z, r11, r12 ... r33, looked for from `start`.
    None where the pose is not reached to 1e-9 mm and 1e-12 rad.\"\"\"
    q = list(start)
    for search in range(100):
        *by, size, position, orientation, agreement = correction(list(pose) + linearised(q))
        q = [v + s for v, s in zip(q, by)]
        if size < 1e-13:
            break
    return q if position < 1e-9 and orientation < 1e-9 and agreement > 2.0 else None
";

const DIRECT: &str = "
def direct(q, start):
    \"\"\"Pose x, y, z, r11, r12 ... r33 of the platform at joint values, mm and rad, looked for from the pose `start`.
    None where it is not found to 1e-9 mm.\"\"\"
    pose = list(start)
    for search in range(100):
        *pose, size = step(pose + list(q))
        if size < 1e-10:
            return pose
    return None
";

impl Exporter for PythonCode {
    fn file_name(&self) -> &'static str {
        "etalon_kinematics.py"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let mut out: String = given.header_of_code("mm, rad")?.iter().map(|line| format!("# {line}\n")).collect();
        out += "from math import atan2, cos, pi, sin, sqrt\n\n";
        out += WRAP;
        for formula in formulas(given)? {
            let (body, outputs) = statements(&formula, &Python);
            let (name, steps) = (formula.name, kept(&formula));
            let _ = write!(out, "\n\n# {}\ndef {name}(q):\n    t = [0.0] * {steps}\n{body}", interface(&formula));
            let _ = writeln!(out, "    return [{}]", outputs.join(", "));
            match formula.name {
                "correction" => out = out + "\n" + INVERSE,
                "step" => out = out + "\n" + DIRECT,
                _ => {}
            }
        }
        Ok(out.into_bytes())
    }
}
