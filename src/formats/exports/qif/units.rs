//! Units of a QIF file: given once for the file, and by name at single values.

use crate::dialect::Unit;
use crate::xml::Node;
use etalon_base::error;
use etalon_base::message::Message;
use std::collections::BTreeMap;

/// Units of a file. The name of a unit is free text ("mm", "MM", "inch"): only its factor matters.
#[derive(Default)]
pub(super) struct Units {
    mm_in_primary: Option<f64>,
    rad_in_primary: Option<f64>,
    mm_in: BTreeMap<String, f64>,
    rad_in: BTreeMap<String, f64>,
}

impl Units {
    /// Reads the units of the file with the document element `root`.
    pub fn read(root: Node) -> Result<Self, Message> {
        let mut units = Self::default();
        let Some(stated) = root.child("FileUnits") else { return Ok(units) };
        for group in stated.children() {
            for unit in group.children() {
                let (si, names) = match unit.name() {
                    "LinearUnit" => ("meter", &mut units.mm_in),
                    "AngularUnit" => ("radian", &mut units.rad_in),
                    _ => continue,
                };
                let factor = factor(unit, si)? * if si == "meter" { 1000.0 } else { 1.0 };
                let name = unit.child("UnitName").map_or("", Node::text);
                names.insert(name.to_owned(), factor);
                if group.name() == "PrimaryUnits" {
                    let primary = if si == "meter" { &mut units.mm_in_primary } else { &mut units.rad_in_primary };
                    *primary = Some(factor);
                }
            }
        }
        Ok(units)
    }

    /// Millimetres in the file's unit of length; `None` if it is not given.
    pub fn mm_in_primary(&self) -> Option<f64> {
        self.mm_in_primary
    }

    /// Sets the file's unit of length, if the file does not contain one.
    pub fn or_length(&mut self, mm_in_unit: Option<f64>) {
        self.mm_in_primary = self.mm_in_primary.or(mm_in_unit);
    }

    /// Millimetres in the unit of a value: its own unit, or the unit of its point set, or the unit
    /// of the file.
    pub fn mm_in(&self, value: Node, set: Option<f64>) -> Result<f64, Message> {
        let named = named(value, "linearUnit", &self.mm_in)?;
        let missing = || error!("file-unit-missing", quantity = "length", record = "LinearUnit").at(value.place());
        named.or(set).or(self.mm_in_primary).ok_or_else(missing)
    }

    /// Millimetres in the unit that a point set itself gives; `None` if it gives none.
    pub fn mm_in_set(&self, set: Node) -> Result<Option<f64>, Message> {
        let own = set.child("Units").and_then(|units| units.child("LinearUnit"));
        own.map(|unit| factor(unit, "meter").map(|f| f * 1000.0)).transpose()
    }

    /// Radians in the unit of a value.
    pub fn rad_in(&self, value: Node) -> Result<f64, Message> {
        let named = named(value, "angularUnit", &self.rad_in)?;
        let missing = || error!("file-unit-missing", quantity = "angle", record = "AngularUnit").at(value.place());
        named.or(self.rad_in_primary).ok_or_else(missing)
    }
}

/// Unit given at a value itself.
fn named(value: Node, attribute: &str, units: &BTreeMap<String, f64>) -> Result<Option<f64>, Message> {
    let Some(name) = value.attribute(attribute) else { return Ok(None) };
    let known: Vec<&str> = units.keys().map(String::as_str).collect();
    let unknown = || error!("unit-unknown", unit = *name, units = known).at(value.place());
    units.get(&*name).copied().map(Some).ok_or_else(unknown)
}

/// SI units in one of `unit`: S = (X + offset) · factor (QIF 3.0 Units.xsd, UnitConversionType).
fn factor(unit: Node, si: &str) -> Result<f64, Message> {
    if let Some(stated) = unit.child("SIUnitName").filter(|n| n.text() != si) {
        return Err(error!("unit-unknown", unit = stated.text(), units = [si]).at(stated.place()));
    }
    let Some(conversion) = unit.child("UnitConversion") else {
        let name = unit.child("UnitName").map_or("", Node::text);
        let is_si = matches!((name, si), ("m" | "meter" | "metre", "meter") | ("rad" | "radian", "radian"));
        let missing = || error!("record-missing", parent = name, record = "UnitConversion/Factor").at(unit.place());
        return is_si.then_some(1.0).ok_or_else(missing);
    };
    let number = |name: &str| conversion.child(name).map(Node::numbers).transpose();
    let factor = number("Factor")?.as_deref().and_then(<[f64]>::first).copied().unwrap_or(0.0);
    let offset = number("Offset")?.as_deref().and_then(<[f64]>::first).copied().unwrap_or(0.0);
    if factor > 0.0 && offset == 0.0 {
        return Ok(factor);
    }
    Err(error!("unit-factor-invalid", factor, offset).at(conversion.place()))
}

/// Name of a unit of length by its millimetres; another unit is shown with its factor.
pub(super) fn name(mm: f64) -> String {
    let unit = Unit::ALL.into_iter().find(|unit| (unit.in_mm() / mm - 1.0).abs() < 1e-9);
    unit.map_or_else(|| format!("{mm} mm"), |unit| unit.name().to_owned())
}
