//! Marks of a text: the delimiter of its columns, and the marks of its numbers.

use etalon_base::error;
use etalon_base::message::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Delimiter of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(transform = crate::schema::accept_aliases)]
pub enum Delimiter {
    /// Any number of blanks or tabs.
    #[serde(rename = "blank", alias = " ")]
    #[schemars(extend("aliases" = [" "]))]
    Blank,
    /// A tab.
    #[serde(rename = "tab", alias = "\t")]
    #[schemars(extend("aliases" = ["\t"]))]
    Tab,
    /// A comma.
    #[serde(rename = ",", alias = "comma")]
    #[schemars(extend("aliases" = ["comma"]))]
    Comma,
    /// A semicolon.
    #[serde(rename = ";", alias = "semicolon")]
    #[schemars(extend("aliases" = ["semicolon"]))]
    Semicolon,
    /// A vertical bar.
    #[serde(rename = "|", alias = "bar")]
    #[schemars(extend("aliases" = ["bar"]))]
    Bar,
}

impl Delimiter {
    /// Returns the byte of the delimiter; `None` for blanks.
    pub fn byte(self) -> Option<u8> {
        match self {
            Self::Blank => None,
            Self::Tab => Some(b'\t'),
            Self::Comma => Some(b','),
            Self::Semicolon => Some(b';'),
            Self::Bar => Some(b'|'),
        }
    }

    /// Name in campaign.toml.
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
#[schemars(transform = crate::schema::accept_aliases)]
pub enum Decimal {
    /// Point: `1.5`.
    #[default]
    #[serde(rename = ".", alias = "point")]
    #[schemars(extend("aliases" = ["point"]))]
    Point,
    /// Comma: `1,5`.
    #[serde(rename = ",", alias = "comma")]
    #[schemars(extend("aliases" = ["comma"]))]
    Comma,
}

impl Decimal {
    /// Byte of the mark.
    pub fn byte(self) -> u8 {
        match self {
            Self::Point => b'.',
            Self::Comma => b',',
        }
    }

    /// Name in campaign.toml.
    pub fn name(self) -> &'static str {
        if self == Self::Point { "." } else { "," }
    }
}

/// Mark between groups of three digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(transform = crate::schema::accept_aliases)]
pub enum Thousands {
    /// Comma: `1,234.5`.
    #[serde(rename = ",", alias = "comma")]
    #[schemars(extend("aliases" = ["comma"]))]
    Comma,
    /// Point: `1.234,5`.
    #[serde(rename = ".", alias = "point")]
    #[schemars(extend("aliases" = ["point"]))]
    Point,
    /// Apostrophe: `1'234.5`.
    #[serde(rename = "'", alias = "apostrophe")]
    #[schemars(extend("aliases" = ["apostrophe"]))]
    Apostrophe,
    /// Blank: `1 234.5`, also with a no-break, narrow or thin blank.
    #[serde(rename = " ", alias = "blank")]
    #[schemars(extend("aliases" = ["blank"]))]
    Blank,
}

impl Thousands {
    /// Spelling in campaign.toml.
    pub fn name(self) -> &'static str {
        match self {
            Self::Comma => ",",
            Self::Point => ".",
            Self::Apostrophe => "'",
            Self::Blank => " ",
        }
    }

    /// `true` if the character is this mark.
    pub fn is(self, c: char) -> bool {
        match self {
            Self::Comma => c == ',',
            Self::Point => c == '.',
            Self::Apostrophe => matches!(c, '\'' | '\u{2019}'),
            Self::Blank => matches!(c, ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}'),
        }
    }
}

/// Returns the error that a comma separates columns and marks decimals.
pub fn two_commas() -> Message {
    error!("comma-ambiguous")
}
