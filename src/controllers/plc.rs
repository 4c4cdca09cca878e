//! Parameters as LREAL constants of PLCs: a TwinCAT list of global constants (`.TcGVL`), PLCopen
//! XML for CODESYS, and a Siemens SCL data block. PLCopen and SCL also contain the kinematics as
//! function blocks, if the robot is known.

use super::code::{Unit, Variable, VariableKind, scl, units};
use super::template::{identifier, real_literal, render};
use super::xml::{Element, block, element, leaf};
use super::{About, ExportInput, Exporter, is_in_code};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_documents::ParameterEntry;
use minijinja::context;
use minijinja::value::Serde;

/// Global variable list of a TwinCAT 3 project.
pub(super) struct TwinCat;

/// Global variable list of PLCopen XML (TC6, version 2.0), as CODESYS imports it.
pub(super) struct PlcOpen;

/// Data block of SCL, for S7-1200 and S7-1500.
pub(super) struct Scl;

/// Names of the constants, which differ in more than case.
fn names(given: &ExportInput) -> Result<Vec<String>> {
    given.names("IEC 61131-3", |p| format!("c_{}", identifier(&p.name).to_ascii_lowercase()))
}

impl Exporter for TwinCat {
    fn about(&self) -> About<'_> {
        About::controller("twincat", "GVL_Etalon.TcGVL")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let (header, parameters) = (given.header("mm, deg, 1")?, Serde(&given.parameters.parameters));
        let values = context! { header, names => names(given)?, parameters, id => given.identifier()? };
        render(include_str!("templates/twincat.xml.j2"), values).map(String::into_bytes)
    }
}

impl Exporter for PlcOpen {
    fn about(&self) -> About<'_> {
        About {
            // The function blocks compute from joint values alone, with the parameters of the list.
            holds: is_in_code,
            ..About::controller("plcopen", "etalon_parameters_plcopen.xml")
        }
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let header = given.header_of_code("mm, deg, 1")?;
        let version = &given.parameters.provenance.version;
        // PLCopen requires times; the clock is not read
        let time = "1980-01-01T00:00:00";
        let file = element("fileHeader", [])
            .with("companyName", "etalon")
            .with("productName", "etalon")
            .with("productVersion", version)
            .with("creationDateTime", time);
        let scaling = |name| element(name, [element("scaling", []).with("x", 1).with("y", 1)]);
        let coordinates = element("coordinateInfo", [scaling("fbd"), scaling("ld"), scaling("sfc")]);
        let content = element("contentHeader", [coordinates]).with("name", "Etalon").with("modificationDateTime", time);
        let variable = |(name, p): (String, &ParameterEntry)| {
            let simple = element("simpleValue", []).with("value", real_literal(p.value));
            let unit = leaf("xhtml", p.printed_unit()).with("xmlns", "http://www.w3.org/1999/xhtml");
            let parts = [
                element("type", [element("LREAL", [])]),
                element("initialValue", [simple]),
                element("documentation", [unit]),
            ];
            element("variable", parts).with("name", name)
        };
        let list = element("globalVars", names(given)?.into_iter().zip(&given.parameters.parameters).map(variable));
        let list = list.with("name", "GVL_Etalon").with("constant", true);
        let data = element("data", [list])
            .with("name", "http://www.3s-software.com/plcopenxml/globalvars")
            .with("handleUnknown", "implementation");
        let pous = kinematics(given)?.into_iter().map(pou);
        let parts: [Element; 5] = [
            file,
            content,
            element("types", [element("dataTypes", []), element("pous", pous)]),
            // CODESYS rejects a configuration with the name that it uses itself
            element("instances", [element("configurations", [])]),
            element("addData", [data]),
        ];
        let root = element("project", parts).with("xmlns", "http://www.plcopen.org/xml/tc6_0200");
        root.document(&header)
            .map_err(|e| error!("cannot-encode", format = "PLCopen XML", reason = e.to_string()).into())
    }
}

/// Functions and function blocks of the kinematics, if the robot is known.
fn kinematics(given: &ExportInput) -> Result<Vec<Unit>> {
    given.robot.map_or_else(|| Ok(Vec::new()), |_| units(given))
}

/// A function or function block in PLCopen XML.
fn pou(unit: Unit) -> Element {
    const XHTML: &str = "http://www.w3.org/1999/xhtml";
    let of = |kind: &VariableKind| match kind {
        VariableKind::Real => element("LREAL", []),
        VariableKind::Integer => element("INT", []),
        VariableKind::Truth => element("BOOL", []),
        VariableKind::Block(name) => element("derived", []).with("name", name),
        VariableKind::Array(last) => {
            let range = |last: &usize| element("dimension", []).with("lower", 0).with("upper", last);
            let base = element("baseType", [element("LREAL", [])]);
            element("array", last.iter().map(range).chain([base]))
        }
    };
    let variable = |v: &Variable| element("variable", [element("type", [of(&v.kind)])]).with("name", v.name);
    let returned = unit.is_function().then(|| element("returnType", [of(&VariableKind::Real)]));
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
    fn about(&self) -> About<'_> {
        About {
            // The function blocks compute from joint values alone, with the parameters of the list.
            holds: is_in_code,
            ..About::controller("siemens-scl", "etalon_parameters.scl")
        }
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let (header, parameters) = (given.header_of_code("mm, deg, 1")?, Serde(&given.parameters.parameters));
        let values = context! { header, names => names(given)?, parameters, kinematics => scl(&kinematics(given)?) };
        render(include_str!("templates/siemens.scl.j2"), values).map(String::into_bytes)
    }
}
