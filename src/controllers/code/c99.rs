//! C99 without dependencies but `math.h`.

use super::{Notation, formulas, interface, kept, parenthesised, statements};
use crate::{Exporter, Given};
use etalon_base::expression::Formula;
use etalon_base::message::Result;
use std::fmt::Write;

/// A file of functions.
pub(crate) struct C99;

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

/// Newton's method, steps of at most half a radian or millimetre.
const INVERSE: &str = "
/* Joint values, mm and rad, of a pose: x, y, z, r11, r12 ... r33. `q` is where they are looked for, and what is found.
   1 where the pose is reached to 1e-9 mm and 1e-12 rad, else 0. */
int etalon_inverse(const double pose[12], double q[ETALON_JOINTS])
{
    enum { N = ETALON_JOINTS };
    double at[12 + 6 * N], a[N][N + 1], e[6], same, trace, longest = 1.0;
    int i, j, k, r, best, search;
    for (search = 0; ; search++) {
        etalon_linearised(q, at);
        same = 0.0;
        for (i = 0; i < 3; i++) {
            e[i] = pose[i] - at[i];
            e[3 + i] = 0.0;
        }
        for (i = 0; i < 3; i++) {
            const double *u = at + 3 + i, *v = pose + 3 + i;
            same += u[0] * v[0] + u[3] * v[3] + u[6] * v[6];
            e[3] += 500.0 * (u[3] * v[6] - u[6] * v[3]);
            e[4] += 500.0 * (u[6] * v[0] - u[0] * v[6]);
            e[5] += 500.0 * (u[0] * v[3] - u[3] * v[0]);
        }
        if (search == 100 || longest < 1e-13) {
            return sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) < 1e-9
                && sqrt(e[3] * e[3] + e[4] * e[4] + e[5] * e[5]) < 1e-9 && same > 2.0;
        }
        trace = 0.0;
        for (i = 0; i < N; i++) {
            for (j = 0; j <= N; j++) {
                a[i][j] = 0.0;
                for (r = 0; r < 6; r++) {
                    double scale = r < 3 ? 1.0 : 1000.0;
                    double right = j < N ? scale * at[12 + 6 * j + r] : e[r];
                    a[i][j] += scale * at[12 + 6 * i + r] * right;
                }
            }
            trace += a[i][i];
        }
        for (i = 0; i < N; i++) {
            a[i][i] += 1e-14 * trace;
        }
        for (k = 0; k < N; k++) {
            best = k;
            for (i = k + 1; i < N; i++) {
                if (fabs(a[i][k]) > fabs(a[best][k])) {
                    best = i;
                }
            }
            for (j = k; j <= N; j++) {
                double swap = a[k][j];
                a[k][j] = a[best][j];
                a[best][j] = swap;
            }
            for (i = 0; i < N; i++) {
                double factor = i == k ? 0.0 : a[i][k] / a[k][k];
                for (j = k; j <= N; j++) {
                    a[i][j] -= factor * a[k][j];
                }
            }
        }
        longest = 0.0;
        for (i = 0; i < N; i++) {
            a[i][N] /= a[i][i];
            longest = fabs(a[i][N]) > longest ? fabs(a[i][N]) : longest;
        }
        for (i = 0; i < N; i++) {
            q[i] += (longest > 0.5 ? 0.5 / longest : 1.0) * a[i][N];
        }
    }
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
pub(crate) fn functions(formulas: &[Formula]) -> String {
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
            "linearised" => {
                out += "\nint etalon_inverse(const double pose[12], double q[ETALON_JOINTS]);\n";
                out += INVERSE;
            }
            "step" => out += DIRECT,
            _ => {}
        }
    }
    out
}
