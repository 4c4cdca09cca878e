//! `[[export]]`: a file of a measuring system, and how it is to be read.

use super::format::{Encoding, FromRow, Unit};
use super::formats::Format;
use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

/// A file of a measuring system.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Export {
    /// Name of the file.
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// Format of the file: a name, or a table of text key by key.
    pub format: Format,
    /// Encoding of its characters; UTF-8, or that of its byte-order mark, if absent.
    pub encoding: Option<Encoding>,
    /// Length unit of the file.
    pub unit: Unit,
    /// Pattern of the labels, with `{target}`, `{pose}` and `{cycle}`.
    #[schemars(with = "Option<String>")]
    pub label: Option<Spanned<String>>,
    /// Target of all rows, where the file does not name it.
    pub target: Option<String>,
    /// `row`: the number of the data row is the number of the pose.
    pub pose: Option<FromRow>,
}
