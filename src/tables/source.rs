//! Sources of columns and filters of rows, for tables of every kind.

use schemars::JsonSchema;
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

/// Source of a column: a heading, a number from 1, or an expression of columns of the row, such as
/// `x_t - x_dif`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ColumnSource {
    /// Heading of the file, or an expression if the file has no such heading.
    Heading(String),
    /// Number of the column, from 1.
    Number(usize),
}

impl From<&str> for ColumnSource {
    fn from(heading: &str) -> Self {
        Self::Heading(heading.to_owned())
    }
}

etalon_base::schema_by_hand!(ColumnSource, _ => {
    let description = "A heading of the file, the number of a column from 1, or an expression of columns: `x_t - x_dif`, `25.4 * $3`.";
    schemars::json_schema!({ "description": description, "anyOf": [{ "type": "string" }, { "type": "integer", "minimum": 1 }] })
});

impl<'de> Deserialize<'de> for ColumnSource {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Any;
        impl Visitor<'_> for Any {
            type Value = ColumnSource;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a heading, the number of a column from 1, or an expression like \"x_t - x_dif\"")
            }
            fn visit_str<E: de::Error>(self, text: &str) -> Result<ColumnSource, E> {
                Ok(text.trim().into())
            }
            fn visit_i64<E: de::Error>(self, number: i64) -> Result<ColumnSource, E> {
                let at = usize::try_from(number).ok().filter(|n| *n > 0);
                at.map(ColumnSource::Number).ok_or_else(|| E::invalid_value(de::Unexpected::Signed(number), &self))
            }
        }
        deserializer.deserialize_any(Any)
    }
}

/// Value of a column that is equal in all rows: a text or a number.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Constant {
    /// A text.
    Text(String),
    /// A number.
    Number(f64),
}

impl Constant {
    /// Returns the text of the cell, with a decimal point.
    pub fn cell(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Number(number) => number.to_string(),
        }
    }
}

/// Cells that select rows: one, or several of which one has to match.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Cells {
    /// One cell.
    One(Constant),
    /// Any of these cells.
    Any(Vec<Constant>),
}

/// Writes the cells as TOML.
impl fmt::Display for Cells {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let one = |constant: &Constant| match constant {
            Constant::Text(text) => toml::Value::from(text.as_str()).to_string(),
            Constant::Number(number) => format!("{number:?}"),
        };
        match self {
            Self::One(cell) => f.write_str(&one(cell)),
            Self::Any(all) => write!(f, "[{}]", all.iter().map(one).collect::<Vec<_>>().join(", ")),
        }
    }
}

impl Cells {
    /// `true` if a cell is one of these cells, as a text or as an equal number. `number` reads a
    /// number in the marks of the table; a given number may also have a decimal point.
    pub fn contain(&self, cell: &str, number: impl Fn(&str) -> Option<f64>) -> bool {
        let cell = cell.trim();
        let of_cell = number(cell);
        let same = |constant: &Constant| {
            let stated = match constant {
                Constant::Number(value) => Some(*value),
                Constant::Text(text) => number(text).or_else(|| text.parse().ok()),
            };
            constant.cell() == cell || stated.zip(of_cell).is_some_and(|(a, b)| a == b)
        };
        match self {
            Self::One(one) => same(one),
            Self::Any(all) => all.iter().any(same),
        }
    }
}
