//! `etalon formats`

use super::{Verdict, print};
use std::path::PathBuf;

/// Propose how to read a delimited text, as lines to paste into campaign.toml
#[derive(Debug, clap::Args)]
pub struct Formats {
    /// The file
    file: PathBuf,
}

impl Formats {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let text = crate::files::read_text(&self.file)?;
        print(crate::import::propose(&self.file.display().to_string(), &text))?;
        Ok(Verdict::Met)
    }
}
