//! Command `etalon formats`.

use super::{Verdict, next_step, print};
use etalon_base::message::Result;
use etalon_documents::FormatsDocument;
use etalon_formats::propose_file;
use std::path::PathBuf;

/// Propose how to read files, with reasons and doubts, as lines to paste into campaign.toml.
#[derive(Debug, clap::Args)]
pub struct Formats {
    /// Files to read.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Print all readings as JSON, one document per file.
    #[arg(long)]
    json: bool,
}

impl Formats {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let documents: Vec<FormatsDocument> =
            self.files.iter().map(|file| propose_file(file)).collect::<Result<_>>()?;
        match (&documents[..], self.json) {
            ([one], true) => print(etalon_documents::to_json(one)?)?,
            (_, true) => print(etalon_documents::to_json(&documents)?)?,
            (_, false) => {
                let texts: Vec<&str> = documents.iter().map(|document| document.toml.as_str()).collect();
                print(texts.join("\n"))?;
            }
        }
        next_step(self.json, "paste these lines into campaign.toml; `etalon check FOLDER` tries them");
        Ok(Verdict::Met)
    }
}
