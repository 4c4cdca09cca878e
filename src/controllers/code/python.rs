//! Python without dependencies but `math`.

use super::{Notation, formulas, interface, kept, parenthesised, statements};
use crate::{Exporter, Given};
use etalon_base::message::Result;
use std::fmt::Write;

/// A module of functions.
pub(crate) struct PythonCode;

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

/// Newton's method, steps of at most half a radian or millimetre.
const INVERSE: &str = "
def inverse(pose, start):
    \"\"\"Joint values, mm and rad, of a pose: x, y, z, r11, r12 ... r33, looked for from `start`.
    None where the pose is not reached to 1e-9 mm and 1e-12 rad.\"\"\"
    q, longest = list(start), 1.0
    n = len(q)
    for search in range(101):
        at = linearised(q)
        e = [pose[i] - at[i] for i in range(3)] + [0.0, 0.0, 0.0]
        same = 0.0
        for i in range(3):
            u, v = at[3 + i:12:3], pose[3 + i:12:3]
            same += u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
            e[3] += 500.0 * (u[1] * v[2] - u[2] * v[1])
            e[4] += 500.0 * (u[2] * v[0] - u[0] * v[2])
            e[5] += 500.0 * (u[0] * v[1] - u[1] * v[0])
        if search == 100 or longest < 1e-13:
            near = sqrt(sum(v * v for v in e[:3])) < 1e-9 and sqrt(sum(v * v for v in e[3:])) < 1e-9
            return q if near and same > 2.0 else None
        rows = [[at[12 + 6 * j + r] * (1.0 if r < 3 else 1000.0) for r in range(6)] for j in range(n)] + [e]
        a = [[sum(rows[i][r] * rows[j][r] for r in range(6)) for j in range(n + 1)] for i in range(n)]
        trace = sum(a[i][i] for i in range(n))
        for i in range(n):
            a[i][i] += 1e-14 * trace
        for k in range(n):
            best = max(range(k, n), key=lambda i: abs(a[i][k]))
            a[k], a[best] = a[best], a[k]
            for i in range(n):
                factor = 0.0 if i == k else a[i][k] / a[k][k]
                a[i] = [x - factor * y for x, y in zip(a[i], a[k])]
        step = [a[i][n] / a[i][i] for i in range(n)]
        longest = max(abs(s) for s in step)
        q = [v + min(1.0, 0.5 / longest if longest > 0.5 else 1.0) * s for v, s in zip(q, step)]
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
                "linearised" => out = out + "\n" + INVERSE,
                "step" => out = out + "\n" + DIRECT,
                _ => {}
            }
        }
        Ok(out.into_bytes())
    }
}
