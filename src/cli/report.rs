//! `etalon report`

use super::{Verdict, print_written};
use crate::document::{GeometricDocument, Iso9283Document};
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
        let optional = |name: &str| folder.join(name).is_file();
        let iso9283: Option<Iso9283Document> =
            optional("iso9283.json").then(|| document(folder, "iso9283.json")).transpose()?;
        let (campaign, import) = (document(folder, "campaign.json")?, document(folder, "import.json")?);
        let (features, frames) = (document(folder, "features.json")?, document(folder, "frames.json")?);
        let path = folder.join("report.html");
        if let Some(iso9283) = iso9283.as_ref().filter(|_| !optional("parameters.json")) {
            let html = report::test_html(&report::TestReport {
                campaign: &campaign,
                import: &import,
                features: &features,
                frames: &frames,
                iso9283,
            })?;
            files::write(&path, html.as_bytes())?;
            print_written(vec![path.display().to_string()], self.json)?;
            return Ok(Verdict::Met);
        }
        let errors = evaluate::from_table(&table::read_parquet(&folder.join("residuals.parquet"))?)?;
        let geometric: Option<GeometricDocument> =
            optional("geometric.json").then(|| document(folder, "geometric.json")).transpose()?;
        let html = report::html(&report::Report {
            campaign: &campaign,
            import: &import,
            features: &features,
            frames: &frames,
            parameters: &document(folder, "parameters.json")?,
            accuracy: &document(folder, "accuracy.json")?,
            errors: &errors,
            geometric: geometric.as_ref(),
            iso9283: iso9283.as_ref(),
        })?;
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
