//! `manifest.json`: files that a run wrote, so that a mixed or damaged folder can be detected.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Files of an output folder, all of one run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ManifestDocument {
    /// Schema and version: `etalon/manifest/1`.
    pub schema: String,
    /// Version of etalon.
    pub version: String,
    /// SHA-256 of every file, by file name.
    pub files: BTreeMap<String, String>,
}

impl ManifestDocument {
    /// File name in the output folder.
    pub const NAME: &str = "manifest.json";

    /// Creates the manifest of `files`.
    pub fn new(files: BTreeMap<String, String>) -> Self {
        Self { schema: "etalon/manifest/1".to_owned(), version: env!("CARGO_PKG_VERSION").to_owned(), files }
    }
}
