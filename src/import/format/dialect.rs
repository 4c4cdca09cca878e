//! How a delimited text is to be read: stated by the campaign, never guessed in silence.

use super::columns::{Columns, Role};
use super::text::{AngleUnit, CoordinateType, Header, Missing, Thousands};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A table of text, or a sheet of a workbook. Exactly one of `delimiter`, `widths` and `sheet` states what separates the columns.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Dialect {
    /// What separates columns.
    pub delimiter: Option<Delimiter>,
    /// Width of each column in characters, where nothing separates the columns.
    pub widths: Vec<usize>,
    /// Name of the sheet of an Excel workbook.
    pub sheet: Option<String>,
    /// Decimal mark.
    pub decimal: Decimal,
    /// Mark between groups of three digits.
    pub thousands: Option<Thousands>,
    /// What each column contains: from the left, or by the names of the header.
    pub columns: Columns,
    /// For files of several coordinate types: what `c1`, `c2`, `c3` are, by the content of the column `type`.
    pub types: BTreeMap<String, Vec<Role>>,
    /// Unit of azimuth, zenith and elevation; required with them.
    pub angle_unit: Option<AngleUnit>,
    /// Confirms the coordinate type of `columns` where the values look like another one.
    pub coordinates: Option<CoordinateType>,
    /// Number of rows before the data, or words of the row before the data.
    pub header: Header,
    /// Beginning of lines that are skipped.
    pub comment: Option<String>,
    /// Cells that mean "not measured".
    pub missing: Missing,
    /// Row that ends the data.
    pub end: Option<String>,
}

/// What separates columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
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
    /// A vertical bar.
    #[serde(rename = "|", alias = "bar")]
    Bar,
}

impl Delimiter {
    /// The byte, for delimiters that are one.
    pub fn byte(self) -> Option<u8> {
        match self {
            Self::Blank => None,
            Self::Tab => Some(b'\t'),
            Self::Comma => Some(b','),
            Self::Semicolon => Some(b';'),
            Self::Bar => Some(b'|'),
        }
    }

    /// As the campaign states it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Blank => "blank",
            Self::Tab => "tab",
            Self::Comma => ",",
            Self::Semicolon => ";",
            Self::Bar => "|",
        }
    }
}

/// Decimal mark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
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

/// Length unit of an export.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
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
