//! Kinematics as code: direct and inverse kinematics with the identified parameters, in languages
//! that controllers and programs compile.
//!
//! All languages write the same recorded formulas ([`Formula`]). If the inverse, or the direct
//! kinematics of a hexapod, has no closed form, the code uses Newton's method on these formulas.
//! Near a singular pose of an arm, where solutions lie close to each other, the code returns the
//! one that the steps from the start reach, the program the nearest to the start.

mod c99;
mod python;
mod structured_text;

pub(super) use c99::{C99, functions};
pub(super) use python::PythonCode;
pub(super) use structured_text::{StructuredText, Unit, Variable, VariableKind, scl, units};

use super::ExportInput;
use etalon_base::error;
use etalon_base::expression::{Formula, Operation};
use etalon_base::message::Result;
use serde::Serialize;

/// Formulas of the robot with its identified parameters.
pub(super) fn formulas(given: &ExportInput) -> Result<Vec<Formula>> {
    let (robot, values) = given.robot()?;
    let formulas = robot.kinematics().map(|arm| arm.formulas(&values)).unwrap_or_default();
    if !robot.branches().is_empty() {
        return Err(error!("several-branches", links = robot.branches()).into());
    }
    if formulas.is_empty() {
        return Err(error!("formulas-missing", model = robot.model()).into());
    }
    let finite = |step: &Operation| !matches!(step, Operation::Constant(bits) if !f64::from_bits(*bits).is_finite());
    if !formulas.iter().flat_map(|formula| &formula.steps).all(finite) {
        return Err(error!("formula-constant-not-finite").into());
    }
    Ok(formulas)
}

/// Notation of a language.
trait Notation {
    /// Notation of a number.
    fn constant(&self, value: f64) -> String;

    /// Call of a function with operands, by its name in C.
    fn call(&self, function: &str, operands: &[&str]) -> String;

    /// Statement that stores step `number`.
    fn keep(&self, number: usize, value: &str) -> String;
}

/// A formula in a language, for its template.
#[derive(Serialize)]
pub(super) struct Function {
    name: &'static str,
    /// Inputs and outputs, for a comment.
    about: String,
    inputs: usize,
    outputs: Vec<String>,
    kept: usize,
    /// Statements.
    body: String,
}

impl Function {
    fn new(formula: &Formula, notation: &dyn Notation) -> Self {
        let (body, outputs) = statements(formula, notation);
        let (about, kept) = (interface(formula), kept(formula));
        Self { name: formula.name, about, inputs: formula.inputs.len(), outputs, kept, body }
    }
}

/// Statements of a formula and names of its outputs. Numbers and inputs are written where they are
/// used, all other steps are stored in `t`.
fn statements(formula: &Formula, notation: &dyn Notation) -> (String, Vec<String>) {
    let mut names: Vec<String> = Vec::with_capacity(formula.steps.len());
    let mut out = String::new();
    let mut kept = 0;
    for step in &formula.steps {
        let operands: Vec<&str> = step.operands().map(|i| names[i].as_str()).collect();
        let infix = |sign: &str| operands.join(sign);
        let value = match *step {
            Operation::Constant(bits) => {
                names.push(notation.constant(f64::from_bits(bits)));
                continue;
            }
            Operation::Input(i) => {
                names.push(format!("q[{i}]"));
                continue;
            }
            Operation::Add(..) => infix(" + "),
            Operation::Subtract(..) => infix(" - "),
            Operation::Multiply(..) => infix(" * "),
            Operation::Divide(..) => infix(" / "),
            Operation::Negate(_) => format!("-{}", operands[0]),
            Operation::Sqrt(_) => notation.call("sqrt", &operands),
            Operation::Sin(_) => notation.call("sin", &operands),
            Operation::Cos(_) => notation.call("cos", &operands),
            Operation::Atan2(..) => notation.call("atan2", &operands),
            Operation::Wrap(_) => notation.call("wrap", &operands),
        };
        out += &notation.keep(kept, &value);
        names.push(format!("t[{kept}]"));
        kept += 1;
    }
    let outputs = formula.outputs.iter().map(|(_, i)| names[*i].clone()).collect();
    (out, outputs)
}

/// Number of stored steps, at least one, so that no array is empty.
fn kept(formula: &Formula) -> usize {
    let inline = |step: &&Operation| matches!(step, Operation::Constant(_) | Operation::Input(_));
    (formula.steps.len() - formula.steps.iter().filter(inline).count()).max(1)
}

/// Inputs and outputs of a function, for a comment.
fn interface(formula: &Formula) -> String {
    let names = formula.inputs.join(", ");
    let outputs: Vec<&str> = formula.outputs.iter().map(|(name, _)| name.as_str()).take(12).collect();
    let more = match formula.name {
        "linearised" => ", then of each joint x, y, z, rx, ry, rz by it",
        "correction" => {
            return "correction of a pose and what linearised gives: step of each joint, its size, errors, agreement"
                .into();
        }
        "step" => ", size",
        _ => "",
    };
    super::comment(&format!("{} of {names}: {}{more}", formula.name, outputs.join(", ")))
}
