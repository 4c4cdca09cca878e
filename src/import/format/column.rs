//! A column of a log, and how what stands in it becomes a joint value.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;
use std::fmt;

/// A column of a log: `"name in the header"`, a number from 1, or a table with more about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Which column.
    pub at: ColumnAt,
    /// Which of several columns of that name, from 1.
    pub occurrence: Option<usize>,
    /// What one count of an encoder is worth, in the unit of the key.
    pub per_count: Option<f64>,
    /// The count at which the joint is at zero.
    pub zero_count: Option<f64>,
}

/// The name of a column in the header, or its number from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ColumnAt {
    /// Name in the header.
    Name(String),
    /// Number from 1.
    Number(usize),
}

impl From<ColumnAt> for Column {
    fn from(at: ColumnAt) -> Self {
        Self { at, occurrence: None, per_count: None, zero_count: None }
    }
}

/// A column of a log: exactly one of `name` and `number`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "ColumnTable")]
struct Stated {
    /// Name of the column in the header.
    name: Option<String>,
    /// Number of the column, from 1.
    number: Option<usize>,
    /// Which of several columns of this name, from 1.
    occurrence: Option<usize>,
    /// Joint value of one encoder count, in the unit of the joint.
    per_count: Option<f64>,
    /// Encoder count at which the joint is at zero.
    zero_count: Option<f64>,
}

impl JsonSchema for Column {
    fn schema_name() -> Cow<'static, str> {
        "Column".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<Stated>();
        json_schema!({ "anyOf": [{ "type": "string" }, { "type": "integer", "minimum": 1 }, table] })
    }
}

impl<'de> Deserialize<'de> for Column {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NameOrNumber;
        impl<'de> Visitor<'de> for NameOrNumber {
            type Value = Column;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("the name of a column, or its number from 1, or { name = .., occurrence = .. }")
            }
            fn visit_str<E: de::Error>(self, name: &str) -> Result<Column, E> {
                Ok(ColumnAt::Name(name.to_owned()).into())
            }
            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Column, E> {
                let wrong = || E::invalid_value(de::Unexpected::Signed(number), &self);
                let at = usize::try_from(number).ok().filter(|n| *n > 0).map(ColumnAt::Number);
                at.map(Column::from).ok_or_else(wrong)
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Column, A::Error> {
                let stated = Stated::deserialize(de::value::MapAccessDeserializer::new(map))?;
                let Stated { name, number, occurrence, per_count, zero_count } = stated;
                let at = match (name, number) {
                    (Some(name), None) => ColumnAt::Name(name),
                    (None, Some(number)) if number > 0 && occurrence.is_none() => ColumnAt::Number(number),
                    _ => return Err(de::Error::custom("a column has either a `name` or a `number` from 1")),
                };
                if occurrence == Some(0) || per_count.is_some_and(|c| c == 0.0 || !c.is_finite()) {
                    return Err(de::Error::custom("`occurrence` counts from 1, and `per_count` is not 0"));
                }
                if zero_count.is_some() && per_count.is_none() {
                    return Err(de::Error::custom("`zero_count` means nothing without `per_count`"));
                }
                Ok(Column { at, occurrence, per_count, zero_count })
            }
        }
        deserializer.deserialize_any(NameOrNumber)
    }
}

/// A number that is the number of its row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FromRow {
    /// Counted from 1 over the data rows of the file, refused ones included.
    Row,
}
