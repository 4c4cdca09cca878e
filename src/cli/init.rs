//! `etalon init`

use super::{Verdict, print_written};
use crate::base::files;
use std::path::PathBuf;

/// Write a commented campaign to start from
#[derive(Debug, clap::Args)]
pub struct Init {
    /// New folder of the campaign
    folder: PathBuf,
    /// Add a truth, from which `etalon simulate` writes the exports and logs
    #[arg(long)]
    synthetic: bool,
    /// Print the names of the files written as JSON
    #[arg(long)]
    json: bool,
}

const CAMPAIGN: &str = include_str!("init/campaign.toml");
const ROBOT: &str = include_str!("init/robot.toml");
const TRUTH: &str = include_str!("init/truth.toml");

/// In the template, a comment.
const SYNTHETIC: &str = "# synthetic = \"how the data were made\"";
const MADE: &str = "synthetic = \"made by `etalon simulate` from truth.toml; nobody measured them\"";

impl Init {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let mut texts = vec![("campaign.toml", CAMPAIGN.into()), ("robot.toml", ROBOT.into())];
        if self.synthetic {
            texts[0].1 = CAMPAIGN.replace(SYNTHETIC, MADE).into_bytes();
            texts.push(("truth.toml", TRUTH.into()));
        }
        print_written(files::write_new(&self.folder, &texts)?, self.json)?;
        Ok(Verdict::Met)
    }
}
