//! C99 without dependencies but `math.h`.

use super::{Notation, formulas, interface, kept, parenthesised, statements};
use crate::base::expression::Formula;
use crate::base::message::Result;
use crate::export::{Exporter, Given};
use std::fmt::Write;

/// A file of functions.
pub(in crate::export) struct C99;

struct C;

impl Notation for C {
    fn constant(&self, value: f64) -> String {
        parenthesised(value)
    }
    fn call(&self, function: &str, operands: &[&str]) -> String {
        let prefix = if function == "wrap" { "etalon_" } else { "" };
        format!("{prefix}{function}({})", operands.join(", "))
    }
    fn keep(&self, number: usize, value: &str) -> String {
        format!("    t[{number}] = {value};\n")
    }
}

const WRAP: &str = "
double etalon_wrap(double angle);

/* An angle between -2 pi and 2 pi brought to -pi ... pi. */
double etalon_wrap(double angle)
{
    const double pi = 3.141592653589793;
    return angle > pi ? angle - 2.0 * pi : angle < -pi ? angle + 2.0 * pi : angle;
}
";

/// Newton's method with the recorded step.
const INVERSE: &str = "
int etalon_inverse(const double pose[12], double q[ETALON_JOINTS]);

/* Joint values, mm and rad, of a pose: x, y, z, r11, r12 ... r33. `q` is where they are looked for, and what is found.
   1 where the pose is reached to 1e-9 mm and 1e-12 rad, else 0. */
int etalon_inverse(const double pose[12], double q[ETALON_JOINTS])
{
    double in[24 + 6 * ETALON_JOINTS], out[ETALON_JOINTS + 4];
    const double *size = out + ETALON_JOINTS;
    int i, search;
    for (i = 0; i < 12; i++) {
        in[i] = pose[i];
    }
    for (search = 0; search < 100; search++) {
        etalon_linearised(q, in + 12);
        etalon_correction(in, out);
        for (i = 0; i < ETALON_JOINTS; i++) {
            q[i] += out[i];
        }
        if (size[0] < 1e-13) {
            break;
        }
    }
    return size[1] < 1e-9 && size[2] < 1e-9 && size[3] > 2.0;
}
";

const DIRECT: &str = "
int etalon_direct(const double q[ETALON_JOINTS], double pose[12]);

/* Pose x, y, z, r11, r12 ... r33 of the platform at joint values, mm and rad. `pose` is where it is looked for, and what is found.
   1 where it is found to 1e-9 mm, else 0. */
int etalon_direct(const double q[ETALON_JOINTS], double pose[12])
{
    double in[12 + ETALON_JOINTS], out[13];
    int i, search;
    for (search = 0; search < 100; search++) {
        for (i = 0; i < 12 + ETALON_JOINTS; i++) {
            in[i] = i < 12 ? pose[i] : q[i - 12];
        }
        etalon_step(in, out);
        for (i = 0; i < 12; i++) {
            pose[i] = out[i];
        }
        if (out[12] < 1e-10) {
            return 1;
        }
    }
    return 0;
}
";

impl Exporter for C99 {
    fn file_name(&self) -> &'static str {
        "etalon_kinematics.c"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let header = given.header_of_code("mm, rad")?.join("\n * ");
        Ok(format!("/* {header} */\n#include <math.h>\n{}", functions(&formulas(given)?)).into_bytes())
    }
}

/// The functions of these formulas, behind a declaration each.
pub(in crate::export) fn functions(formulas: &[Formula]) -> String {
    let mut out = WRAP.to_owned();
    for formula in formulas {
        let (body, outputs) = statements(formula, &C);
        let (inputs, count, steps) = (formula.inputs.len(), outputs.len(), kept(formula));
        let _ = writeln!(out, "\n/* {} */", interface(formula));
        match formula.name {
            "linearised" => out += &format!("#define ETALON_JOINTS {inputs}\n"),
            "step" => out += &format!("#define ETALON_JOINTS {}\n", inputs - 12),
            _ => {}
        }
        let head = format!("void etalon_{}(const double q[{inputs}], double out[{count}])", formula.name);
        let _ = write!(out, "{head};\n{head}\n{{\n    double t[{steps}];\n{body}");
        for (i, name) in outputs.iter().enumerate() {
            let _ = writeln!(out, "    out[{i}] = {name};");
        }
        let used = if body.is_empty() { "    (void)t;\n" } else { "" };
        let _ = writeln!(out, "{used}}}");
        match formula.name {
            "correction" => out += INVERSE,
            "step" => out += DIRECT,
            _ => {}
        }
    }
    out
}
