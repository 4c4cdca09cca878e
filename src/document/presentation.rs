//! How a report is dressed: its language, the laboratory's logo and its own templates.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Language of a report. Texts of the campaign stay as they are, messages of the program stay English.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Language {
    /// English.
    #[default]
    En,
    /// French.
    Fr,
    /// German.
    De,
}

impl Language {
    /// As HTML and ISO 639-1 name it.
    pub fn code(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::Fr => "fr",
            Self::De => "de",
        }
    }
}

/// How a report is dressed; whole, so that it can be made again from the output folder alone.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Presentation {
    /// Its language.
    pub language: Language,
    /// The laboratory's logo as a data URI (SVG or PNG).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub logo: Option<String>,
    /// Text of the laboratory's own templates by the name of the file.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub templates: BTreeMap<String, String>,
}
