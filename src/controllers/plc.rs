//! Parameters as constants of PLCs, LREAL: a list of global constants of TwinCAT (`.TcGVL`), PLCopen XML for CODESYS, and a data block of
//! Siemens SCL; PLCopen and SCL hold the kinematics as function blocks too, where the robot is named.

use super::code::{Kind, Unit, Variable, scl, units};
use super::xml::{Element, block, element, leaf};
use super::{Exporter, Given, comment};
use etalon_base::message::{Message, Result};
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
        let id = given.identifier()?;
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
        let header = given.header_of_code("mm, deg, 1")?;
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
        let pous = kinematics(given)?.into_iter().map(pou);
        let parts: [Element; 5] = [
            file,
            content,
            element("types", [element("dataTypes", []), element("pous", pous)]),
            // CODESYS refuses a configuration of the name that it gives itself
            element("instances", [element("configurations", [])]),
            element("addData", [data]),
        ];
        let root = element("project", parts).with("xmlns", "http://www.plcopen.org/xml/tc6_0200");
        root.document(&header).map_err(|e| Message::error(format!("cannot write the constants: {e}")).into())
    }
}

/// Functions and function blocks of the kinematics, where the robot is named.
fn kinematics(given: &Given) -> Result<Vec<Unit>> {
    given.robot.map_or_else(|| Ok(Vec::new()), |_| units(given))
}

/// A function or function block in PLCopen XML.
fn pou(unit: Unit) -> Element {
    const XHTML: &str = "http://www.w3.org/1999/xhtml";
    let of = |kind: &Kind| match kind {
        Kind::Real => element("LREAL", []),
        Kind::Integer => element("INT", []),
        Kind::Truth => element("BOOL", []),
        Kind::Block(name) => element("derived", []).with("name", name),
        Kind::Array(last) => {
            let range = |last: &usize| element("dimension", []).with("lower", 0).with("upper", last);
            let base = element("baseType", [element("LREAL", [])]);
            element("array", last.iter().map(range).chain([base]))
        }
    };
    let variable = |v: &Variable| element("variable", [element("type", [of(&v.kind)])]).with("name", v.name);
    let returned = unit.is_function().then(|| element("returnType", [of(&Kind::Real)]));
    let list = |(word, list): (&str, &[Variable])| {
        let name = match word {
            "VAR_INPUT" => "inputVars",
            "VAR_OUTPUT" => "outputVars",
            _ => "localVars",
        };
        element(name, list.iter().map(variable))
    };
    let interface = element("interface", returned.into_iter().chain(unit.lists().map(list)));
    let body = element("body", [element("ST", [block("xhtml", &unit.body).with("xmlns", XHTML)])]);
    let about = element("documentation", [leaf("xhtml", &unit.comment).with("xmlns", XHTML)]);
    let kind = if unit.is_function() { "function" } else { "functionBlock" };
    element("pou", [interface, body, about]).with("name", &unit.name).with("pouType", kind)
}

impl Exporter for Scl {
    fn file_name(&self) -> &'static str {
        "etalon_parameters.scl"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let mut out: String = given.header_of_code("mm, deg, 1")?.iter().map(|line| format!("// {line}\n")).collect();
        out += "DATA_BLOCK \"Etalon\"\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\nNON_RETAIN\n   STRUCT\n";
        for Constant { name, value, unit } in constants(given)? {
            let _ = writeln!(out, "      {name} : LReal := {value};   // {}", comment(unit));
        }
        out += "   END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
        Ok((out + &scl(&kinematics(given)?)).into_bytes())
    }
}
