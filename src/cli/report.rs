//! `etalon report`

use super::{Verdict, print_written};
use crate::document::GeometricDocument;
use crate::message::{Message, Result};
use crate::{evaluate, files, report, table};
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};

/// Make report.html again from the documents of an output folder
#[derive(Debug, clap::Args)]
pub struct Report {
    /// Folder that `etalon run` wrote
    folder: PathBuf,
    /// Print the names of the files written as JSON
    #[arg(long)]
    json: bool,
}

impl Report {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let folder = &self.folder;
        let errors = evaluate::from_table(&table::read_parquet(&folder.join("residuals.parquet"))?)?;
        let geometric: Option<GeometricDocument> =
            if folder.join("geometric.json").is_file() { Some(document(folder, "geometric.json")?) } else { None };
        let html = report::html(&report::Report {
            campaign: &document(folder, "campaign.json")?,
            import: &document(folder, "import.json")?,
            features: &document(folder, "features.json")?,
            frames: &document(folder, "frames.json")?,
            parameters: &document(folder, "parameters.json")?,
            accuracy: &document(folder, "accuracy.json")?,
            errors: &errors,
            geometric: geometric.as_ref(),
        })?;
        let path = folder.join("report.html");
        files::write(&path, html.as_bytes())?;
        print_written(vec![path.display().to_string()], self.json)?;
        Ok(Verdict::Met)
    }
}

/// A document that an earlier stage wrote.
pub(super) fn document<T: DeserializeOwned>(folder: &Path, name: &str) -> Result<T> {
    let path = folder.join(name);
    let bytes = files::read(&path)?;
    serde_json::from_slice(&bytes).map_err(|e| {
        let what = format!("`{}` is not the document that this version writes: {e}", path.display());
        Message::error(what).hint("run the campaign again").into()
    })
}
