//! C99 code with `math.h` as the only dependency.

use super::{Function, Notation, formulas};
use crate::template::{literal, render};
use crate::{About, ExportInput, Exporter};
use etalon_base::expression::Formula;
use etalon_base::message::Result;
use minijinja::context;
use minijinja::value::Serde;

/// A file of functions.
pub(crate) struct C99;

struct C;

impl Notation for C {
    fn constant(&self, value: f64) -> String {
        literal(value)
    }
    fn call(&self, function: &str, operands: &[&str]) -> String {
        let prefix = if function == "wrap" { "etalon_" } else { "" };
        format!("{prefix}{function}({})", operands.join(", "))
    }
    fn keep(&self, number: usize, value: &str) -> String {
        format!("    t[{number}] = {value};\n")
    }
}

impl Exporter for C99 {
    fn about(&self) -> About<'_> {
        About::code("c-kinematics", "etalon_kinematics.c")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let header = given.header_of_code("mm, rad")?.join("\n * ");
        Ok(format!("/* {header} */\n#include <math.h>\n{}", functions(&formulas(given)?)?).into_bytes())
    }
}

/// Functions of the formulas, each preceded by a declaration.
pub(crate) fn functions(formulas: &[Formula]) -> Result<String> {
    let functions: Vec<Function> = formulas.iter().map(|formula| Function::new(formula, &C)).collect();
    render(include_str!("../templates/kinematics.c.j2"), context! { functions => Serde(functions) })
}
