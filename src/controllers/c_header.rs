//! Parameters as a C header, for controllers that are compiled: C99 and C++.

use super::{Exporter, Given, status_word};
use etalon_base::message::{Message, Result};
use etalon_documents::ParameterEntry;
use std::collections::BTreeMap;
use std::fmt::Write;

/// C header, one macro a parameter; angles in degrees and in radians.
pub(super) struct CHeader;

impl Exporter for CHeader {
    fn file_name(&self) -> &'static str {
        "etalon_parameters.h"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let document = given.parameters;
        let robot = identifier(&document.robot);
        let header = given.header("mm, deg and rad, 1; u is the standard uncertainty (k = 1)")?.join("\n * ");
        let guard = format!("ETALON_{robot}_PARAMETERS_H");
        let mut out = format!("/* {header}\n */\n#ifndef {guard}\n#define {guard}\n");
        let mut seen = BTreeMap::new();
        for p in &document.parameters {
            let _ = write!(out, "\n/* {}: {} */\n", comment(&p.name), remark(p));
            for (unit, value) in macros(p) {
                let name = format!("ETALON_{robot}_{}_{unit}", identifier(&p.name));
                let _ = writeln!(out, "#define {name} {}", literal(value));
                if let Some(other) = seen.insert(name.clone(), &p.name) {
                    let what = format!("parameters `{other}` and `{}` are both `{name}` in C", p.name);
                    return Err(Message::error(what).hint("rename one of them, or use another format").into());
                }
            }
        }
        let _ = write!(out, "\n#endif /* {guard} */\n");
        Ok(out.into_bytes())
    }
}

fn remark(p: &ParameterEntry) -> String {
    let unit = if p.unit == "1" { "ratio" } else { &p.unit };
    match p.standard_uncertainty {
        Some(u) => format!("{}, u = {u:?} {}", status_word(p), comment(unit)),
        None => format!("{}, {}", status_word(p), comment(unit)),
    }
}

/// Suffix and value of every macro of a parameter.
fn macros(p: &ParameterEntry) -> Vec<(String, f64)> {
    match p.unit.as_str() {
        "deg" => vec![("DEG".to_owned(), p.value), ("RAD".to_owned(), p.value.to_radians())],
        "1" => vec![("RATIO".to_owned(), p.value)],
        unit => vec![(identifier(unit), p.value)],
    }
}

/// The shortest literal that reads back bit for bit; in parentheses where a sign could join an expression.
pub(super) fn literal(value: f64) -> String {
    if value.is_sign_negative() { format!("({value:?})") } else { format!("{value:?}") }
}

/// Capitals, digits and underscores only.
pub(super) fn identifier(name: &str) -> String {
    let safe = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' };
    if name.is_empty() { "_".to_owned() } else { name.chars().map(safe).collect() }
}

/// Text that can neither end a comment, nor join lines, nor spell a trigraph.
pub(crate) fn comment(text: &str) -> String {
    let safe = |c: char| if c.is_ascii_alphanumeric() || " .,-_:()=+".contains(c) { c } else { '_' };
    text.chars().map(safe).collect()
}
