//! Parameters as constants of PLCs, LREAL: a list of global constants of TwinCAT (`.TcGVL`), PLCopen XML for CODESYS, and a data block of
//! Siemens SCL.

use super::xml::{Element, element, leaf};
use super::{Exporter, Given, comment};
use crate::base::files;
use crate::base::message::{Message, Result};
use crate::document::to_json;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Global variable list of a TwinCAT 3 project.
pub(super) struct TwinCat;

/// Global variable list of PLCopen XML (TC6, version 2.0), as CODESYS imports it.
pub(super) struct PlcOpen;

/// Data block of SCL, for S7-1200 and S7-1500.
pub(super) struct Scl;

/// A parameter by its name in a PLC.
struct Constant<'a> {
    name: String,
    /// A real literal of IEC 61131-3.
    value: String,
    unit: &'a str,
}

/// Parameters by names that differ in more than capitals.
fn constants<'a>(given: &Given<'a>) -> Result<Vec<Constant<'a>>> {
    let mut seen = BTreeMap::new();
    let mut all = Vec::new();
    for p in &given.parameters.parameters {
        let name = format!("c_{}", super::c_header::identifier(&p.name).to_ascii_lowercase());
        if let Some(other) = seen.insert(name.clone(), &p.name) {
            let what = format!("parameters `{other}` and `{}` are both `{name}` in a PLC", p.name);
            return Err(Message::error(what).hint("rename one of them, or use another format").into());
        }
        all.push(Constant { name, value: super::code::real_literal(p.value), unit: &p.unit });
    }
    Ok(all)
}

impl Exporter for TwinCat {
    fn file_name(&self) -> &'static str {
        "GVL_Etalon.TcGVL"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let mut list: String = given.header("mm, deg, 1")?.iter().map(|line| format!("// {line}\n")).collect();
        list += "{attribute 'qualified_only'}\nVAR_GLOBAL CONSTANT\n";
        for Constant { name, value, unit } in constants(given)? {
            let _ = writeln!(list, "\t{name} : LREAL := {value}; // {}", comment(unit));
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

impl Exporter for PlcOpen {
    fn file_name(&self) -> &'static str {
        "etalon_parameters_plcopen.xml"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let header = given.header("mm, deg, 1")?;
        let version = &given.parameters.provenance.version;
        // PLCopen asks for times, and no clock is looked at
        let time = "1980-01-01T00:00:00";
        let file = element("fileHeader", [])
            .with("companyName", "etalon")
            .with("productName", "etalon")
            .with("productVersion", version)
            .with("creationDateTime", time);
        let scaling = |name| element(name, [element("scaling", []).with("x", 1).with("y", 1)]);
        let coordinates = element("coordinateInfo", [scaling("fbd"), scaling("ld"), scaling("sfc")]);
        let content = element("contentHeader", [coordinates]).with("name", "Etalon").with("modificationDateTime", time);
        let variable = |Constant { name, value, unit }: Constant| {
            let simple = element("simpleValue", []).with("value", value);
            let unit = leaf("xhtml", unit).with("xmlns", "http://www.w3.org/1999/xhtml");
            let parts = [
                element("type", [element("LREAL", [])]),
                element("initialValue", [simple]),
                element("documentation", [unit]),
            ];
            element("variable", parts).with("name", name)
        };
        let list = element("globalVars", constants(given)?.into_iter().map(variable));
        let list = list.with("name", "GVL_Etalon").with("constant", true);
        let data = element("data", [list])
            .with("name", "http://www.3s-software.com/plcopenxml/globalvars")
            .with("handleUnknown", "implementation");
        let empty = |name, inside: &[&'static str]| element(name, inside.iter().map(|name| element(name, [])));
        let parts: [Element; 5] = [
            file,
            content,
            empty("types", &["dataTypes", "pous"]),
            // CODESYS refuses a configuration of the name that it gives itself
            empty("instances", &["configurations"]),
            element("addData", [data]),
        ];
        let root = element("project", parts).with("xmlns", "http://www.plcopen.org/xml/tc6_0200");
        root.document(&header).map_err(|e| Message::error(format!("cannot write the constants: {e}")).into())
    }
}

impl Exporter for Scl {
    fn file_name(&self) -> &'static str {
        "etalon_parameters.scl"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let mut out: String = given.header("mm, deg, 1")?.iter().map(|line| format!("// {line}\n")).collect();
        out += "DATA_BLOCK \"Etalon\"\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\nNON_RETAIN\n   STRUCT\n";
        for Constant { name, value, unit } in constants(given)? {
            let _ = writeln!(out, "      {name} : LReal := {value};   // {}", comment(unit));
        }
        Ok((out + "   END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n").into_bytes())
    }
}
