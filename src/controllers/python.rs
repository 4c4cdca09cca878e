//! Parameters as a Python module without dependencies; `numpy.array(covariance)` takes what it holds.

use super::{Exporter, Given, status_word};
use etalon_base::message::{Message, Result};
use std::fmt::Write;

/// Python, dictionaries by the name of the parameter.
pub(super) struct Python;

impl Exporter for Python {
    fn file_name(&self) -> &'static str {
        "etalon_parameters.py"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        // strings of JSON in ASCII are those of Python
        let text = |text: &str| -> Result<String> {
            let quoted =
                serde_json::to_string(text).map_err(|e| Message::error(format!("a name cannot be written: {e}")))?;
            let escaped = |c: char| if c.is_ascii() { c.to_string() } else { format!("\\U{:08x}", u32::from(c)) };
            Ok(quoted.chars().map(escaped).collect())
        };
        let mut out = String::new();
        for line in given.header("mm, deg, 1")? {
            let _ = writeln!(out, "# {line}");
        }
        out += "\n# name: value, standard uncertainty (None: not identified), nominal value, unit, status\nparameters = {\n";
        for p in &given.parameters.parameters {
            let u = p.standard_uncertainty.map_or_else(|| "None".to_owned(), |u| format!("{u:?}"));
            let (name, unit, status) = (text(&p.name)?, text(&p.unit)?, status_word(p));
            let _ = writeln!(out, "    {name}: ({:?}, {u}, {:?}, {unit}, \"{status}\"),", p.value, p.nominal);
        }
        out += "}\n\n# covariance of the identified parameters, in this order\nidentified = [";
        for p in given.parameters.identified() {
            let _ = write!(out, "{}, ", text(&p.name)?);
        }
        out += "]\ncovariance = [\n";
        for row in &given.parameters.covariance {
            let _ = writeln!(out, "    {row:?},");
        }
        Ok((out + "]\n").into_bytes())
    }
}
