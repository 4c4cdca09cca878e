//! Cells with the references of a row: of a table, or of a truth that is simulated.

use etalon_base::message::{Message, Result};
use etalon_base::{error, phrase};
use etalon_formats::table::{ANGLE_ORDER, TEXTS, Table};
use etalon_identify::Fixture;
use etalon_robots::Robot;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Column of the name of the station of the instrument that measured a point.
pub(super) const STATION: &str = "station";
/// Axes of the world.
const AXES: [&str; 3] = ["x", "y", "z"];

/// A name, or a number in the unit of its column.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Cell {
    /// A name.
    Text(String),
    /// A number.
    Number(f64),
}

/// Cells of a truth by column, in addition to the columns of every kind.
pub type ByColumn = BTreeMap<String, Cell>;

/// The text in a column, if any.
pub fn text<'a>(cells: &'a ByColumn, column: &str) -> Option<&'a str> {
    match cells.get(column) {
        Some(Cell::Text(text)) => Some(text),
        _ => None,
    }
}

/// Schema of the cells given by a truth, by column.
#[cfg(feature = "schemas")]
pub fn stated_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let texts = names().map(|name| (name, generator.subschema_for::<Option<String>>()));
    let mut properties: serde_json::Map<String, _> =
        texts.map(|(name, schema)| (name.to_owned(), schema.to_value())).collect();
    for name in super::KINDS.iter().flat_map(|kind| kind.facts().stated) {
        properties.insert((*name).to_owned(), generator.subschema_for::<Option<f64>>().to_value());
    }
    schemars::json_schema!({ "type": "object", "properties": properties })
}

/// Columns of names, in addition to the columns of every kind.
pub fn names() -> impl Iterator<Item = &'static str> {
    TEXTS.into_iter().filter(|name| !["kind", "target", ANGLE_ORDER].contains(name))
}

/// Cells of a row by column, in addition to the columns of every kind.
#[derive(Clone, Debug)]
pub enum Others<'t> {
    /// Row of a table, by its index.
    Row(&'t Table, usize),
    /// Values of a truth.
    Truth(ByColumn),
}

/// The cells of a row with its references.
#[derive(Clone, Debug)]
pub struct Cells<'t> {
    /// Name of the kind.
    pub kind: String,
    /// Name of the target.
    pub target: String,
    /// Station, if it is not the one whose frame is the world.
    pub station: Option<String>,
    /// Other cells.
    pub others: Others<'t>,
}

impl Cells<'_> {
    /// The text in a column, if any.
    pub fn text(&self, column: &str) -> Option<&str> {
        match &self.others {
            Others::Row(table, row) => table.text(*row, column),
            Others::Truth(cells) => text(cells, column),
        }
    }

    /// The number in a column, if there is such a column; NaN if the cell is empty.
    pub(super) fn number(&self, column: &str) -> Option<f64> {
        match &self.others {
            Others::Row(table, row) => table.values(column).map(|values| values.number(*row)),
            Others::Truth(cells) => match cells.get(column) {
                Some(Cell::Number(number)) => Some(*number),
                _ => None,
            },
        }
    }

    /// `true` if the cells are part of a truth.
    fn in_truth(&self) -> bool {
        matches!(self.others, Others::Truth(_))
    }

    fn missing(&self, column: &str) -> Message {
        match self.in_truth() {
            true => error!("observe-key-missing", kind = self.kind, column),
            false => error!("column-empty", column),
        }
    }

    /// The name in a column.
    pub(super) fn name(&self, column: &str) -> Result<&str> {
        Ok(self.text(column).filter(|name| !name.is_empty()).ok_or_else(|| self.missing(column))?)
    }

    /// The first parameter of the fixed point that a column names.
    pub(super) fn point(&self, column: &str, robot: &mut dyn Robot) -> Result<usize> {
        let name = self.name(column)?;
        check_fixed(name, robot)?;
        Ok(Fixture::Point(name).add_to(robot))
    }

    /// The target of another branch that a column names, if it is one; an error for a target of
    /// the same branch.
    pub(super) fn other_target(&self, column: &str, robot: &dyn Robot) -> Result<Option<usize>> {
        let index = |name: &str| robot.targets().iter().position(|target| target == name);
        let name = self.name(column)?;
        let Some(other) = index(name).filter(|_| !robot.branches().is_empty()) else { return Ok(None) };
        match index(&self.target) {
            Some(own) if robot.target_branch(own) != robot.target_branch(other) => Ok(Some(other)),
            _ => Err(error!("target-of-same-branch", target = self.target, name).into()),
        }
    }

    /// The first parameter of the station.
    pub(super) fn station(&self, robot: &mut dyn Robot) -> Result<Option<usize>> {
        let Some(name) = &self.station else { return Ok(None) };
        check_fixed(name, robot)?;
        Ok(Some(Fixture::Station(name).add_to(robot)))
    }

    /// The axis of the world in the column `axis`; `missing` is the error of a table without it.
    pub(super) fn axis(&self, missing: impl FnOnce() -> Message) -> Result<usize> {
        let axis = AXES.iter().position(|axis| self.text("axis") == Some(axis));
        Ok(axis.ok_or_else(|| match self.in_truth() {
            true => self.missing("axis").expected(phrase!("axis-of-world")),
            false => missing(),
        })?)
    }

    /// The length in the column `distance_mm`.
    pub(super) fn distance(&self) -> Result<f64> {
        let wrong = || error!("distance-not-positive");
        Ok(self.number("distance_mm").filter(|d| d.is_finite() && *d > 0.0).ok_or_else(wrong)?)
    }
}

/// Returns an error about the name of a fixed point that is a target on the robot.
pub(super) fn check_fixed(name: &str, robot: &dyn Robot) -> Result<()> {
    match robot.targets().iter().any(|target| target == name) || name == "base" {
        true => Err(error!("fixed-point-on-robot", name).into()),
        false => Ok(()),
    }
}
