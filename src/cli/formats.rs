//! `etalon formats`

use super::{Verdict, next_step, print};
use std::path::PathBuf;

/// Propose how to read a file, with reasons and doubts, as lines to paste into campaign.toml
#[derive(Debug, clap::Args)]
pub struct Formats {
    /// The file
    file: PathBuf,
    /// Print all readings as JSON
    #[arg(long)]
    json: bool,
}

impl Formats {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let document = etalon_formats::propose_file(&self.file)?;
        if self.json {
            print(etalon_documents::to_json(&document)?)?;
        } else {
            print(document.toml)?;
        }
        next_step(self.json, "paste these lines into campaign.toml; `etalon check FOLDER` tries them");
        Ok(Verdict::Met)
    }
}
