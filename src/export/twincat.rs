//! TwinCAT: parameters as a list of global constants (`.TcGVL`), LREAL.

use super::{Exporter, Given};
use crate::base::files;
use crate::base::message::{Message, Result};
use crate::document::to_json;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Global variable list of a TwinCAT 3 project.
pub(super) struct TwinCat;

impl Exporter for TwinCat {
    fn file_name(&self) -> &'static str {
        "GVL_Etalon.TcGVL"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let mut list: String = given.header("mm, deg, 1")?.iter().map(|line| format!("// {line}\n")).collect();
        list += "{attribute 'qualified_only'}\nVAR_GLOBAL CONSTANT\n";
        let mut seen = BTreeMap::new();
        for p in &given.parameters.parameters {
            let name = format!("c_{}", super::c_header::identifier(&p.name).to_ascii_lowercase());
            if let Some(other) = seen.insert(name.clone(), &p.name) {
                let what = format!("parameters `{other}` and `{}` are both `{name}` in TwinCAT", p.name);
                return Err(Message::error(what).hint("rename one of them, or use another format").into());
            }
            let (value, unit) = (super::code::real_literal(p.value), super::comment(&p.unit));
            let _ = writeln!(list, "\t{name} : LREAL := {value}; // {unit}");
        }
        list += "END_VAR\n";
        // the same parameters have the same number: the first 128 bits of their hash
        let hash = files::sha256(&to_json(given.parameters)?);
        let part = |from: usize, to: usize| hash.get(from..to).unwrap_or_default();
        let id = [part(0, 8), part(8, 12), part(12, 16), part(16, 20), part(20, 32)].join("-");
        let text = format!(
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<TcPlcObject Version=\"1.1.0.1\" ProductVersion=\"3.1.4024.12\">\n  \
             <GVL Name=\"GVL_Etalon\" Id=\"{{{id}}}\">\n    <Declaration><![CDATA[{list}]]></Declaration>\n  </GVL>\n</TcPlcObject>\n"
        );
        Ok(text.into_bytes())
    }
}
