//! Units of a QIF file: stated once for the file, and by name at single values.

use crate::xml::Node;
use etalon_base::message::Message;
use std::collections::BTreeMap;

/// What the file states about its units. A name of a unit is free text ("mm", "MM", "inch"): only its factor counts.
#[derive(Default)]
pub(super) struct Units {
    mm_in_primary: Option<f64>,
    rad_in_primary: Option<f64>,
    mm_in: BTreeMap<String, f64>,
    rad_in: BTreeMap<String, f64>,
}

impl Units {
    /// Of the file whose document element is `root`.
    pub fn of(root: Node) -> Result<Self, Message> {
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

    /// Millimetres in the file's unit of length; `None` where it states none.
    pub fn mm_in_primary(&self) -> Option<f64> {
        self.mm_in_primary
    }

    /// The file's unit of length is this one where it states none.
    pub fn or_length(&mut self, mm_in_unit: Option<f64>) {
        self.mm_in_primary = self.mm_in_primary.or(mm_in_unit);
    }

    /// Millimetres in the unit of a value: its own, else that of its point set, else that of the file.
    pub fn mm_in(&self, value: Node, set: Option<f64>) -> Result<f64, Message> {
        let named = named(value, "linearUnit", &self.mm_in)?;
        named.or(set).or(self.mm_in_primary).ok_or_else(|| {
            value
                .error("the file does not state its unit of length")
                .expected("`LinearUnit` in `FileUnits/PrimaryUnits`, with its factor")
                .hint("state it: --unit mm, m, um or inch; it is never guessed")
        })
    }

    /// Millimetres in the unit that a point set states for itself; `None` where it states none.
    pub fn mm_in_set(&self, set: Node) -> Result<Option<f64>, Message> {
        let own = set.child("Units").and_then(|units| units.child("LinearUnit"));
        own.map(|unit| factor(unit, "meter").map(|f| f * 1000.0)).transpose()
    }

    /// Radians in the unit of a value.
    pub fn rad_in(&self, value: Node) -> Result<f64, Message> {
        let named = named(value, "angularUnit", &self.rad_in)?;
        named.or(self.rad_in_primary).ok_or_else(|| {
            value
                .error("the file does not state its unit of angle")
                .expected("`AngularUnit` in `FileUnits/PrimaryUnits`, with its factor")
        })
    }
}

/// The unit that a value names for itself.
fn named(value: Node, attribute: &str, units: &BTreeMap<String, f64>) -> Result<Option<f64>, Message> {
    let Some(name) = value.attribute(attribute) else { return Ok(None) };
    units.get(&*name).copied().map(Some).ok_or_else(|| {
        value
            .error(format!("`{name}` is not a unit of this file"))
            .expected("a `UnitName` of `FileUnits`")
            .hint_names(&name, units.keys().map(String::as_str))
    })
}

/// SI units in one of `unit`: S = (X + offset) · factor (QIF 3.0 Units.xsd, UnitConversionType).
fn factor(unit: Node, si: &str) -> Result<f64, Message> {
    if let Some(stated) = unit.child("SIUnitName").filter(|n| n.text() != si) {
        return Err(stated.error(format!("`{}` is no SI unit of this quantity", stated.text())).expected(si));
    }
    let Some(conversion) = unit.child("UnitConversion") else {
        let name = unit.child("UnitName").map_or("", Node::text);
        let is_si = matches!((name, si), ("m" | "meter" | "metre", "meter") | ("rad" | "radian", "radian"));
        let message = unit.error(format!("the unit `{name}` has no factor")).expected("`UnitConversion/Factor`");
        return if is_si { Ok(1.0) } else { Err(message) };
    };
    let number = |name: &str| conversion.child(name).map(Node::numbers).transpose();
    let factor = number("Factor")?.as_deref().and_then(<[f64]>::first).copied().unwrap_or(0.0);
    let offset = number("Offset")?.as_deref().and_then(<[f64]>::first).copied().unwrap_or(0.0);
    if factor > 0.0 && offset == 0.0 {
        return Ok(factor);
    }
    Err(conversion.error(format!("factor {factor}, offset {offset}")).expected("a positive factor without offset"))
}
