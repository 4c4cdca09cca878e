//! Files that a controller loads: one format a file, each a pure function of `parameters.json`.
//!
//! All of them write numbers that read back bit for bit, and refuse what must not reach a machine: a value that is not
//! a number, two parameters of one name, parameters of a solver that did not converge or that cannot be a robot.

mod c_header;
mod csv;
mod json;
mod targets;
#[cfg(test)]
mod tests;

pub use targets::{places, targets};

use crate::base::message::{Message, Problems, Result, Severity};
use crate::document::{ParameterEntry, ParameterStatus, ParametersDocument};
use std::collections::BTreeSet;

/// One controller format.
pub trait Exporter {
    /// Name of the file in the output folder.
    fn file_name(&self) -> &'static str;

    /// The bytes of the file.
    fn write(&self, parameters: &ParametersDocument) -> Result<Vec<u8>>;
}

const EXPORTERS: [(&str, &dyn Exporter); 3] =
    [("json", &json::Json), ("csv", &csv::Csv), ("c-header", &c_header::CHeader)];

/// The format of this name.
pub fn by_name(name: &str) -> Option<&'static dyn Exporter> {
    EXPORTERS.iter().find(|(known, _)| *known == name).map(|(_, exporter)| *exporter)
}

/// Names of the files of all formats.
pub fn file_names() -> impl Iterator<Item = &'static str> {
    EXPORTERS.iter().map(|(_, exporter)| exporter.file_name())
}

/// Names of all formats.
pub fn names() -> impl Iterator<Item = &'static str> {
    EXPORTERS.iter().map(|(name, _)| *name)
}

/// Refuses parameters that must not reach a controller.
fn check(document: &ParametersDocument) -> Result<()> {
    let mut problems = Problems::default();
    if !document.solver.termination.is_success() {
        let what = format!("the parameters are not fit for a controller: {}", document.solver.termination);
        problems.0.push(Message::error(what).hint("identify again before exporting"));
    }
    problems.0.extend(document.messages.iter().filter(|m| m.severity == Severity::Error).cloned());
    let mut seen = BTreeSet::new();
    for p in &document.parameters {
        let numbers = [Some(p.value), Some(p.nominal), p.standard_uncertainty];
        if numbers.iter().flatten().any(|v| !v.is_finite()) {
            let what = format!("parameter `{}` has a number that is not finite", p.name);
            problems.0.push(Message::error(what).expected("finite value, nominal value and uncertainty"));
        }
        if !seen.insert(&p.name) {
            problems.0.push(Message::error(format!("there are two parameters `{}`", p.name)));
        }
    }
    problems.check().map(|_| ())
}

/// The status as the documents spell it.
fn status_word(parameter: &ParameterEntry) -> &'static str {
    match parameter.status {
        ParameterStatus::Identified => "identified",
        ParameterStatus::Fixed => "fixed",
        ParameterStatus::NotIdentifiable => "not_identifiable",
    }
}
