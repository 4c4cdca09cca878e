//! `[[export]]`: a file of a measuring system, and how it is to be read.

use super::format::{Encoding, FromRow, Unit};
use super::formats::Format;
use serde::Deserialize;
use toml::Spanned;

/// A file of a measuring system.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Export {
    /// The file.
    pub file: Spanned<String>,
    /// Its format.
    pub format: Format,
    /// How its bytes become characters; UTF-8, or what its byte-order mark says, if it is absent.
    pub encoding: Option<Encoding>,
    /// Its length unit: never guessed.
    pub unit: Unit,
    /// How a label names target, pose and cycle, e.g. `{target}_{pose}_{cycle}`.
    pub label: Option<Spanned<String>>,
    /// The target that all rows are of, where the file does not name it.
    pub target: Option<String>,
    /// `"row"`: the number of the data row is the number of the pose.
    pub pose: Option<FromRow>,
}
