//! Python code with `math` as the only dependency.

use super::{Function, Notation, formulas};
use crate::template::{literal, render};
use crate::{About, ExportInput, Exporter};
use etalon_base::message::Result;
use minijinja::context;
use minijinja::value::Serde;

/// A module of functions.
pub(crate) struct PythonCode;

struct Python;

impl Notation for Python {
    fn constant(&self, value: f64) -> String {
        literal(value)
    }
    fn call(&self, function: &str, operands: &[&str]) -> String {
        format!("{function}({})", operands.join(", "))
    }
    fn keep(&self, number: usize, value: &str) -> String {
        format!("    t[{number}] = {value}\n")
    }
}

impl Exporter for PythonCode {
    fn about(&self) -> About<'_> {
        About::code("python-kinematics", "etalon_kinematics.py")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let functions: Vec<Function> = formulas(given)?.iter().map(|formula| Function::new(formula, &Python)).collect();
        let values = context! { header => given.header_of_code("mm, rad")?, functions => Serde(functions) };
        render(include_str!("../templates/kinematics.py.j2"), values).map(String::into_bytes)
    }
}
