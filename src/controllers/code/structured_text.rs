//! Structured Text (IEC 61131-3) with LREAL: functions and function blocks as data, which TwinCAT,
//! CODESYS and others read as text, PLCopen as XML, and Siemens as SCL.

use super::{Notation, formulas, interface, kept, statements};
use crate::template::real_literal;
use crate::{About, ExportInput, Exporter};
use etalon_base::expression::Formula;
use etalon_base::message::Result;
use std::fmt::Write;

/// Function blocks.
pub(crate) struct StructuredText;

/// A function or a function block.
pub(crate) struct Unit {
    pub name: String,
    pub comment: String,
    pub inputs: Vec<Variable>,
    /// Outputs; empty for a function, which returns an LREAL.
    pub outputs: Vec<Variable>,
    pub locals: Vec<Variable>,
    /// Statements; names of other units start with ETALON_ or FB_Etalon.
    pub body: String,
}

pub(crate) struct Variable {
    pub name: &'static str,
    pub kind: VariableKind,
}

pub(crate) enum VariableKind {
    Real,
    Integer,
    Truth,
    /// LREALs with indices from 0 to these maxima.
    Array(Vec<usize>),
    /// An instance of a function block.
    Block(&'static str),
}

struct Iec;

impl Notation for Iec {
    fn constant(&self, value: f64) -> String {
        let text = real_literal(value);
        if value.is_sign_negative() { format!("({text})") } else { text }
    }
    fn call(&self, function: &str, operands: &[&str]) -> String {
        match (function, operands) {
            ("atan2", [y, x]) => format!("ETALON_ATAN2(y := {y}, x := {x})"),
            ("wrap", [angle]) => format!("ETALON_WRAP(angle := {angle})"),
            _ => format!("{}({})", function.to_ascii_uppercase(), operands.join(", ")),
        }
    }
    /// The square root of a negative number stops a controller; it is replaced by zero with an
    /// invalid output.
    fn keep(&self, number: usize, value: &str) -> String {
        match value.strip_prefix("SQRT(").and_then(|rest| rest.strip_suffix(')')) {
            Some(of) => format!(
                "IF {of} < 0.0 THEN\n  valid := FALSE;\n  t[{number}] := 0.0;\nELSE\n  t[{number}] := {value};\nEND_IF;\n"
            ),
            None => format!("t[{number}] := {value};\n"),
        }
    }
}

/// Angle of the vector (x, y) (rad).
const ATAN2: &str = "\
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
";
/// Angle between −2π and 2π wrapped to −π ... π.
const WRAP: &str = "\
IF angle > 3.141592653589793 THEN
  ETALON_WRAP := angle - 6.283185307179586;
ELSIF angle < -3.141592653589793 THEN
  ETALON_WRAP := angle + 6.283185307179586;
ELSE
  ETALON_WRAP := angle;
END_IF;
";

/// Newton's method with the recorded step. `{N}` is the number of joints, `{L}` the index of the
/// last joint, `{I}` the last input of the step.
const INVERSE: &str = "\
q := start;
valid := FALSE;
FOR i := 0 TO 11 DO
  inside[i] := pose[i];
END_FOR;
FOR search := 0 TO 99 DO
  linearised(q := q);
  FOR i := 12 TO {I} DO
    inside[i] := linearised.out[i - 12];
  END_FOR;
  correction(q := inside);
  FOR i := 0 TO {L} DO
    q[i] := q[i] + correction.out[i];
  END_FOR;
  valid := correction.out[{N} + 1] < 1.0E-9 AND correction.out[{N} + 2] < 1.0E-9 AND correction.out[{N} + 3] > 2.0;
  IF correction.out[{N}] < 1.0E-13 THEN
    RETURN;
  END_IF;
END_FOR;
";

/// Newton steps to the pose while they are large.
const DIRECT: &str = "\
FOR i := 0 TO 11 DO
  inside[i] := start[i];
END_FOR;
FOR i := 0 TO {L} DO
  inside[12 + i] := q[i];
END_FOR;
valid := FALSE;
FOR search := 0 TO 99 DO
  iteration(q := inside);
  FOR i := 0 TO 11 DO
    inside[i] := iteration.out[i];
    out[i] := iteration.out[i];
  END_FOR;
  IF iteration.out[12] < 1.0E-10 THEN
    valid := TRUE;
    RETURN;
  END_IF;
END_FOR;
";

impl Unit {
    fn function(name: &str, comment: &str, inputs: &[&'static str], body: &str) -> Self {
        let inputs = inputs.iter().map(|name| Variable { name, kind: VariableKind::Real }).collect();
        let (name, comment, body) = (name.to_owned(), comment.to_owned(), body.to_owned());
        Self { name, comment, inputs, outputs: Vec::new(), locals: Vec::new(), body }
    }

    pub fn is_function(&self) -> bool {
        self.outputs.is_empty()
    }

    /// Variables by the keyword of their list.
    pub fn lists(&self) -> impl Iterator<Item = (&'static str, &[Variable])> {
        let lists = [("VAR_INPUT", &self.inputs), ("VAR_OUTPUT", &self.outputs), ("VAR", &self.locals)];
        lists.into_iter().filter(|(_, list)| !list.is_empty()).map(|(word, list)| (word, list.as_slice()))
    }

    /// Function block of a formula.
    fn function_block(formula: &Formula) -> Self {
        let (mut body, outputs) = statements(formula, &Iec);
        let (first, rest) = formula.name.split_at(1);
        body.insert_str(0, "valid := TRUE;\n");
        for (i, name) in outputs.iter().enumerate() {
            let _ = writeln!(body, "out[{i}] := {name};");
        }
        Self {
            name: format!("FB_Etalon{}{rest}", first.to_ascii_uppercase()),
            comment: interface(formula),
            inputs: vec![array("q", &[formula.inputs.len()])],
            outputs: vec![array("out", &[outputs.len()]), Variable { name: "valid", kind: VariableKind::Truth }],
            locals: vec![array("t", &[kept(formula)])],
            body,
        }
    }

    /// Function block of the search for joint values by Newton corrections.
    fn inverse(formula: &Formula) -> Self {
        let (inputs, joints) = (formula.inputs.len(), formula.outputs.len() - 4);
        let block = |name, of| Variable { name, kind: VariableKind::Block(of) };
        let blocks = [block("linearised", "FB_EtalonLinearised"), block("correction", "FB_EtalonCorrection")];
        let (last, input) = ((joints - 1).to_string(), (inputs - 1).to_string());
        Self {
            name: "FB_EtalonInverse".to_owned(),
            comment: "Joint values (mm and rad) of a pose x, y, z, r11, r12 ... r33, with starting values start; valid if the pose \
                      is reached to 1e-9 mm and 1e-12 rad."
                .to_owned(),
            inputs: vec![array("pose", &[12]), array("start", &[joints])],
            outputs: vec![array("q", &[joints]), Variable { name: "valid", kind: VariableKind::Truth }],
            locals: blocks.into_iter().chain([array("inside", &[inputs])]).chain(integers(&["i", "search"])).collect(),
            body: INVERSE.replace("{N}", &joints.to_string()).replace("{L}", &last).replace("{I}", &input),
        }
    }

    /// Function block of Newton steps to a pose.
    fn direct(formula: &Formula) -> Self {
        let joints = formula.inputs.len() - 12;
        let block = Variable { name: "iteration", kind: VariableKind::Block("FB_EtalonStep") };
        Self {
            name: "FB_EtalonDirect".to_owned(),
            comment: "Pose x, y, z, r11, r12 ... r33 of the platform at joint values (mm and rad), with the starting pose start; \
                      valid if it is found to 1e-9 mm."
                .to_owned(),
            inputs: vec![array("q", &[joints]), array("start", &[12])],
            outputs: vec![array("out", &[12]), Variable { name: "valid", kind: VariableKind::Truth }],
            locals: [block, array("inside", &[12 + joints])].into_iter().chain(integers(&["i", "search"])).collect(),
            body: DIRECT.replace("{L}", &(joints - 1).to_string()),
        }
    }
}

fn array(name: &'static str, counts: &[usize]) -> Variable {
    Variable { name, kind: VariableKind::Array(counts.iter().map(|n| n - 1).collect()) }
}

fn integers(names: &'static [&'static str]) -> impl Iterator<Item = Variable> {
    names.iter().map(|name| Variable { name, kind: VariableKind::Integer })
}

/// Functions and function blocks of the robot with its identified parameters, each after the blocks
/// that it calls.
pub(crate) fn units(given: &ExportInput) -> Result<Vec<Unit>> {
    let mut all = vec![
        Unit::function("ETALON_ATAN2", "Angle of the vector (x, y), rad.", &["y", "x"], ATAN2),
        Unit::function("ETALON_WRAP", "Reduces an angle between -2 pi and 2 pi to -pi ... pi.", &["angle"], WRAP),
    ];
    for formula in formulas(given)? {
        all.push(Unit::function_block(&formula));
        match formula.name {
            "correction" => all.push(Unit::inverse(&formula)),
            "step" => all.push(Unit::direct(&formula)),
            _ => {}
        }
    }
    Ok(all)
}

/// Name of a type; Siemens writes some in mixed case, and types of blocks in quotation marks.
fn type_name(kind: &VariableKind, siemens: bool) -> String {
    let real = if siemens { "LReal" } else { "LREAL" };
    match kind {
        VariableKind::Real => real.to_owned(),
        VariableKind::Integer => if siemens { "Int" } else { "INT" }.to_owned(),
        VariableKind::Truth => if siemens { "Bool" } else { "BOOL" }.to_owned(),
        VariableKind::Array(last) => {
            let ranges: Vec<String> = last.iter().map(|last| format!("0..{last}")).collect();
            format!("{}[{}] OF {real}", if siemens { "Array" } else { "ARRAY" }, ranges.join(", "))
        }
        VariableKind::Block(name) if siemens => format!("\"{name}\""),
        VariableKind::Block(name) => (*name).to_owned(),
    }
}

fn declarations(unit: &Unit, siemens: bool) -> String {
    let mut out = String::new();
    for (word, list) in unit.lists() {
        let _ = writeln!(out, "{word}");
        for Variable { name, kind } in list {
            let _ = writeln!(out, "  {name} : {};", type_name(kind, siemens));
        }
        out += "END_VAR\n";
    }
    out
}

impl Exporter for StructuredText {
    fn about(&self) -> About<'_> {
        About::code("structured-text", "etalon_kinematics.st")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let mut out: String = given.header_of_code("mm, rad")?.iter().map(|line| format!("(* {line} *)\n")).collect();
        for unit in units(given)? {
            let (word, of) = if unit.is_function() { ("FUNCTION", " : LREAL") } else { ("FUNCTION_BLOCK", "") };
            let Unit { name, comment, body, .. } = &unit;
            let _ =
                write!(out, "\n(* {comment} *)\n{word} {name}{of}\n{}{body}END_{word}\n", declarations(&unit, false));
        }
        Ok(out.into_bytes())
    }
}

/// Functions and function blocks in Siemens SCL, for S7-1200 and S7-1500: variables are preceded by
/// `#`, names of blocks are in quotation marks.
pub(crate) fn scl(units: &[Unit]) -> String {
    let mut out = String::new();
    for unit in units {
        let (word, of) = if unit.is_function() { ("FUNCTION", " : LReal") } else { ("FUNCTION_BLOCK", "") };
        let Unit { name, comment, .. } = unit;
        let _ =
            write!(out, "\n// {comment}\n{word} \"{name}\"{of}\n{{ S7_Optimized_Access := 'TRUE' }}\nVERSION : 0.1\n");
        let _ = write!(out, "{}BEGIN\n{}END_{word}\n", declarations(unit, true), with_marks(unit));
    }
    out
}

/// Statements of a unit with `#` before its variables, and quotation marks around functions.
fn with_marks(unit: &Unit) -> String {
    let own = |word: &str| word == unit.name || unit.lists().any(|(_, list)| list.iter().any(|v| v.name == word));
    let (mut out, mut rest, mut depth) = (String::new(), unit.body.as_str(), 0);
    while let Some(first) = rest.chars().next() {
        let in_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || first.is_ascii_digit() && c == '.';
        let length = rest.find(|c| !in_word(c)).unwrap_or(rest.len()).max(first.len_utf8());
        let (word, behind) = rest.split_at(length);
        rest = behind;
        depth += i32::from(first == '(') - i32::from(first == ')');
        // named arguments of a call are not variables of the unit
        let named = depth > 0 && rest.starts_with(" := ");
        match word {
            _ if own(word) && !named && !out.ends_with('.') => out.extend(["#", word]),
            _ if word.starts_with("ETALON_") => out.extend(["\"", word, "\""]),
            _ => out += word,
        }
    }
    out
}
