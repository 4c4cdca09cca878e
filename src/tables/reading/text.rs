//! Parts of a form in addition to its marks: encoding, header, missing values.

use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use schemars::JsonSchema;
use serde::de::{self, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// Character encoding. Default: the encoding of the byte-order mark, otherwise UTF-8.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(transform = crate::schema::accept_aliases)]
pub enum Encoding {
    /// UTF-8, with a byte-order mark or without.
    #[serde(rename = "utf-8", alias = "utf8", alias = "ascii")]
    #[schemars(extend("aliases" = ["utf8", "ascii"]))]
    Utf8,
    /// UTF-16, the low byte first.
    #[serde(rename = "utf-16le")]
    Utf16Le,
    /// UTF-16, the high byte first.
    #[serde(rename = "utf-16be")]
    Utf16Be,
    /// Western European Windows.
    #[serde(rename = "windows-1252", alias = "cp1252")]
    #[schemars(extend("aliases" = ["cp1252"]))]
    Windows1252,
    /// Central European Windows.
    #[serde(rename = "windows-1250", alias = "cp1250")]
    #[schemars(extend("aliases" = ["cp1250"]))]
    Windows1250,
    /// Cyrillic Windows.
    #[serde(rename = "windows-1251", alias = "cp1251")]
    #[schemars(extend("aliases" = ["cp1251"]))]
    Windows1251,
    /// Japanese Windows.
    #[serde(rename = "shift_jis", alias = "cp932")]
    #[schemars(extend("aliases" = ["cp932"]))]
    ShiftJis,
    /// Japanese Unix.
    #[serde(rename = "euc-jp")]
    EucJp,
    /// Simplified Chinese.
    #[serde(rename = "gb18030", alias = "gbk", alias = "gb2312", alias = "cp936")]
    #[schemars(extend("aliases" = ["gbk", "gb2312", "cp936"]))]
    Gb18030,
    /// Traditional Chinese.
    #[serde(rename = "big5", alias = "cp950")]
    #[schemars(extend("aliases" = ["cp950"]))]
    Big5,
    /// Korean.
    #[serde(rename = "euc-kr", alias = "cp949")]
    #[schemars(extend("aliases" = ["cp949"]))]
    EucKr,
}

impl Encoding {
    /// Spelling in campaign.toml.
    pub fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "utf-8",
            Self::Utf16Le => "utf-16le",
            Self::Utf16Be => "utf-16be",
            Self::Windows1252 => "windows-1252",
            Self::Windows1250 => "windows-1250",
            Self::Windows1251 => "windows-1251",
            Self::ShiftJis => "shift_jis",
            Self::EucJp => "euc-jp",
            Self::Gb18030 => "gb18030",
            Self::Big5 => "big5",
            Self::EucKr => "euc-kr",
        }
    }
}

/// Header of a table, after which the data begin.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum Header {
    /// Number of rows before the data; empty lines and comments do not count.
    Rows(usize),
    /// Words of the last line before the data.
    Words(Vec<String>),
}

impl Default for Header {
    fn default() -> Self {
        Self::Rows(0)
    }
}

etalon_base::schema_by_hand!(Header, _ => schemars::json_schema!({ "anyOf": [
    { "type": "integer", "minimum": 0 },
    { "type": "boolean" },
    { "type": "string" },
    { "type": "array", "items": { "type": "string" } },
] }));

impl<'de> Deserialize<'de> for Header {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct RowsOrWords;
        impl<'de> Visitor<'de> for RowsOrWords {
            type Value = Header;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("how many rows come before the data, or words of the row before them")
            }
            fn visit_str<E: de::Error>(self, words: &str) -> Result<Header, E> {
                match words.trim() {
                    "" => Err(E::invalid_value(de::Unexpected::Str(words), &self)),
                    _ => Ok(Header::Words(vec![words.to_owned()])),
                }
            }
            fn visit_bool<E: de::Error>(self, named: bool) -> Result<Header, E> {
                Ok(Header::Rows(usize::from(named)))
            }
            fn visit_i64<E: de::Error>(self, rows: i64) -> Result<Header, E> {
                let wrong = || E::invalid_value(de::Unexpected::Signed(rows), &self);
                usize::try_from(rows).map(Header::Rows).map_err(|_| wrong())
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Header, A::Error> {
                let mut words: Vec<String> = Vec::new();
                while let Some(word) = seq.next_element()? {
                    words.push(word);
                }
                match words.iter().all(|w| w.trim().is_empty()) {
                    true => Err(de::Error::custom(phrase!("header-without-words"))),
                    false => Ok(Header::Words(words)),
                }
            }
        }
        deserializer.deserialize_any(RowsOrWords)
    }
}

/// Default cells that mean "not measured"; a cell of stars is an overflow.
pub const NOT_MEASURED: [&str; 12] =
    ["", "-", "--", "---", "N/A", "n/a", "#N/A", "nan", "1.#QNAN", "-1.#IND", "*", "0 0 0"];

/// Cells that mean "not measured", in addition to empty ones.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct Missing(Vec<String>);

impl Default for Missing {
    fn default() -> Self {
        Self(NOT_MEASURED.map(str::to_owned).to_vec())
    }
}

impl Missing {
    /// `true` if a cell means "not measured", as every empty one does.
    pub fn says(&self, cell: &str) -> bool {
        let stars = cell.bytes().all(|b| b == b'*');
        cell.is_empty() || self.0.iter().any(|marker| cell.eq_ignore_ascii_case(marker) || marker == "*" && stars)
    }

    /// Returns the reason for leaving out a row, if its cell in this column means "not measured".
    pub fn reason(&self, column: &str, cell: &str) -> Option<Phrase> {
        self.says(cell).then(|| match cell {
            "" => phrase!("row-cell-empty", column),
            _ => phrase!("row-not-measured", column, cell),
        })
    }

    /// `true` if coordinates that are all zero mean "not measured".
    pub fn origin(&self) -> bool {
        self.0.iter().any(|marker| marker == "0 0 0")
    }

    /// Spelling in campaign.toml.
    pub fn markers(&self) -> &[String] {
        &self.0
    }
}
