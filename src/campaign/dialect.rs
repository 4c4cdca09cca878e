//! How a delimited text is to be read: stated by the campaign, never guessed in silence.

use super::Reader;
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

/// Format of an export.
#[derive(Clone, Debug, PartialEq)]
pub enum Format {
    /// PolyWorks point text: `name x y z [i j k]`, blank-separated, decimal point; name optional, quoted if it has blanks.
    Polyworks,
    /// QIF 2.0, 2.1 or 3.0: measured features and their points, labelled by the name of the feature.
    Qif,
    /// A format with a reader of its own, and its decimal mark.
    Own(Reader, Decimal),
    /// Delimited text.
    Delimited(Dialect),
}

/// A delimited text.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dialect {
    /// What separates columns.
    pub delimiter: Delimiter,
    /// Decimal mark.
    #[serde(default)]
    pub decimal: Decimal,
    /// What each column holds, from the left; more columns than stated are refused.
    pub columns: Vec<Role>,
    /// Rows before the data.
    #[serde(default)]
    pub header: usize,
    /// Lines that start with this are skipped.
    pub comment: Option<String>,
}

/// What separates columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
pub enum Delimiter {
    /// Any number of blanks or tabs.
    #[serde(rename = "blank", alias = " ")]
    Blank,
    /// A tab.
    #[serde(rename = "tab", alias = "\t")]
    Tab,
    /// A comma.
    #[serde(rename = ",", alias = "comma")]
    Comma,
    /// A semicolon.
    #[serde(rename = ";", alias = "semicolon")]
    Semicolon,
}

impl Delimiter {
    /// The byte, for delimiters that are one.
    pub fn byte(self) -> Option<u8> {
        match self {
            Self::Blank => None,
            Self::Tab => Some(b'\t'),
            Self::Comma => Some(b','),
            Self::Semicolon => Some(b';'),
        }
    }

    /// As the campaign states it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Blank => "blank",
            Self::Tab => "tab",
            Self::Comma => ",",
            Self::Semicolon => ";",
        }
    }
}

/// Decimal mark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
pub enum Decimal {
    /// `1.5`
    #[default]
    #[serde(rename = ".", alias = "point")]
    Point,
    /// `1,5`
    #[serde(rename = ",", alias = "comma")]
    Comma,
}

impl Decimal {
    /// As the campaign states it.
    pub fn name(self) -> &'static str {
        if self == Self::Point { "." } else { "," }
    }
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Label of the point.
    Label,
    /// Name of the target.
    Target,
    /// Number of the pose.
    Pose,
    /// Number of the repeat.
    Cycle,
    /// Coordinate.
    X,
    /// Coordinate.
    Y,
    /// Coordinate.
    Z,
    /// Time in seconds.
    TimeS,
    /// Not read.
    #[serde(rename = "-", alias = "skip")]
    Skip,
}

/// Length unit of an export.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
pub enum Unit {
    /// Millimetre.
    #[serde(rename = "mm")]
    Millimetre,
    /// Metre.
    #[serde(rename = "m")]
    Metre,
    /// Micrometre.
    #[serde(rename = "um")]
    Micrometre,
    /// Inch: 25.4 mm exactly.
    #[serde(rename = "inch", alias = "in")]
    Inch,
}

impl Unit {
    /// Millimetres in one of the unit.
    pub fn in_mm(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Metre => 1000.0,
            Self::Micrometre => 0.001,
            Self::Inch => 25.4,
        }
    }

    /// As the campaign states it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Metre => "m",
            Self::Micrometre => "um",
            Self::Inch => "inch",
        }
    }
}

impl<'de> Deserialize<'de> for Format {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NameOrDialect;
        impl<'de> Visitor<'de> for NameOrDialect {
            type Value = Format;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                write!(
                    f,
                    "\"polyworks\", \"qif\", \"{}\" or {{ delimiter = .., decimal = .., columns = [..] }}",
                    Reader::names().collect::<Vec<_>>().join("\", \"")
                )
            }
            fn visit_str<E: de::Error>(self, name: &str) -> Result<Format, E> {
                match name {
                    "polyworks" => Ok(Format::Polyworks),
                    "qif" => Ok(Format::Qif),
                    _ => {
                        let own = Reader::stated(name).map(|(reader, decimal)| Format::Own(reader, decimal));
                        own.ok_or_else(|| E::invalid_value(de::Unexpected::Str(name), &self))
                    }
                }
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Format, A::Error> {
                Ok(Format::Delimited(Dialect::deserialize(de::value::MapAccessDeserializer::new(map))?))
            }
        }
        deserializer.deserialize_any(NameOrDialect)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Polyworks => f.write_str("PolyWorks text"),
            Self::Qif => f.write_str("QIF"),
            Self::Own(reader, Decimal::Point) => f.write_str(reader.in_words()),
            Self::Own(reader, Decimal::Comma) => write!(f, "{}, decimal `,`", reader.in_words()),
            Self::Delimited(d) => {
                write!(
                    f,
                    "delimited by `{}`, decimal `{}`, {} header rows",
                    d.delimiter.name(),
                    d.decimal.name(),
                    d.header
                )
            }
        }
    }
}
