//! `manifest.json`: which files a run wrote, so that a folder that is mixed or damaged is found out.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The files of an output folder, all of one run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ManifestDocument {
    /// `etalon/manifest/1`
    pub schema: String,
    /// Version of etalon.
    pub version: String,
    /// SHA-256 of every file, by its name.
    pub files: BTreeMap<String, String>,
}

impl ManifestDocument {
    /// Its name in the output folder.
    pub const NAME: &str = "manifest.json";

    /// Of these files.
    pub fn new(files: BTreeMap<String, String>) -> Self {
        Self { schema: "etalon/manifest/1".to_owned(), version: env!("CARGO_PKG_VERSION").to_owned(), files }
    }
}
