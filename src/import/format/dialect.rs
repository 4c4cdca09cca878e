//! How a delimited text is to be read: stated by the campaign, never guessed in silence.

use super::columns::{Columns, Role};
use super::text::{AngleUnit, CoordinateType, Header, Missing, Thousands};
use serde::Deserialize;
use std::collections::BTreeMap;

/// A text of rows and columns. Exactly one of `delimiter`, `widths` and `sheet` says what separates columns.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Dialect {
    /// What separates columns.
    pub delimiter: Option<Delimiter>,
    /// Width of each column in characters, where nothing separates them.
    pub widths: Vec<usize>,
    /// Sheet of an Excel workbook.
    pub sheet: Option<String>,
    /// Decimal mark.
    pub decimal: Decimal,
    /// What stands between groups of three digits.
    pub thousands: Option<Thousands>,
    /// What each column holds.
    pub columns: Columns,
    /// For files that mix coordinate types: what the columns `c1`, `c2`, `c3` are in rows whose `type` says so.
    pub types: BTreeMap<String, Vec<Role>>,
    /// Unit of azimuth, zenith and elevation: never guessed.
    pub angle_unit: Option<AngleUnit>,
    /// Says that the coordinates are what `columns` calls them, whatever they look like.
    pub coordinates: Option<CoordinateType>,
    /// What comes before the data.
    pub header: Header,
    /// Lines that start with this are skipped.
    pub comment: Option<String>,
    /// Cells that say "not measured", instead of those of [`NOT_MEASURED`](super::NOT_MEASURED).
    pub missing: Missing,
    /// A row of this word alone ends the data.
    pub end: Option<String>,
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
