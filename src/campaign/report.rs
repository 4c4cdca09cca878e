//! `[report]`: how the report is dressed.

use crate::document::Language;
use serde::Deserialize;
use toml::Spanned;

/// Language, logo and templates of the report.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ReportDefinition {
    /// Language of the report.
    pub language: Language,
    /// The laboratory's logo, SVG or PNG.
    pub logo: Option<Spanned<String>>,
    /// Folder of templates that replace the built-in ones of the same name.
    pub templates: Option<Spanned<String>>,
}
