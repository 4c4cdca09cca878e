//! Parameters as a MATLAB function, which Octave reads too.

use super::{Exporter, Given};
use etalon_base::message::{Message, Result};
use std::collections::BTreeMap;
use std::fmt::Write;

/// A function that returns a struct: a field for each parameter, and the covariance of those that are identified.
pub(super) struct Matlab;

/// Longest name that MATLAB keeps (`namelengthmax`).
const LONGEST: usize = 63;

impl Exporter for Matlab {
    fn file_name(&self) -> &'static str {
        "etalon_parameters.m"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let mut out = "function p = etalon_parameters()\n".to_owned();
        out += "% ETALON_PARAMETERS  Identified parameters: value, standard uncertainty ([]: not identified), nominal value, unit.\n";
        for line in given.header("mm, deg, 1")? {
            let _ = writeln!(out, "% {line}");
        }
        let mut seen = BTreeMap::new();
        for p in &given.parameters.parameters {
            let field = identifier(&p.name);
            if let Some(other) = seen.insert(field.clone(), &p.name) {
                let what = format!("parameters `{other}` and `{}` are both `{field}` in MATLAB", p.name);
                return Err(Message::error(what).hint("rename one of them, or use another format").into());
            }
            let u = p.standard_uncertainty.map_or_else(|| "[]".to_owned(), |u| format!("{u:?}"));
            let _ = writeln!(
                out,
                "p.{field} = struct('value', {:?}, 'u', {u}, 'nominal', {:?}, 'unit', '{}');",
                p.value, p.nominal, p.unit
            );
        }
        let names: Vec<String> = given.parameters.identified().map(|p| format!("'{}'", identifier(&p.name))).collect();
        let row = |row: &Vec<f64>| row.iter().map(|v| format!("{v:?}")).collect::<Vec<_>>().join(", ");
        let rows: Vec<String> = given.parameters.covariance.iter().map(row).collect();
        let _ = writeln!(out, "p.identified = {{{}}};\np.covariance = [{}];", names.join(", "), rows.join("; "));
        Ok((out + "end\n").into_bytes())
    }
}

/// Letters, digits and underscores, beginning with a letter.
fn identifier(name: &str) -> String {
    let safe = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let mut all: String = name.chars().map(safe).collect();
    if !all.starts_with(|c: char| c.is_ascii_alphabetic()) {
        all.insert_str(0, "p_");
    }
    all.truncate(LONGEST);
    all
}
