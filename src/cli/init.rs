//! `etalon init`

use super::{Verdict, print_written};
use crate::base::files;
use crate::base::message::{Message, Problems};
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
        let mut texts = vec![("campaign.toml", CAMPAIGN.to_owned()), ("robot.toml", ROBOT.to_owned())];
        if self.synthetic {
            texts[0].1 = CAMPAIGN.replace(SYNTHETIC, MADE);
            texts.push(("truth.toml", TRUTH.to_owned()));
        }
        let paths: Vec<PathBuf> = texts.iter().map(|(name, _)| self.folder.join(name)).collect();
        if let Some(path) = paths.iter().find(|path| path.exists()) {
            let message = Message::error(format!("`{}` is there already", path.display()));
            return Err(Problems::from(message.hint("name a new folder")).into());
        }
        for (path, (_, text)) in paths.iter().zip(&texts) {
            files::write(path, text.as_bytes())?;
        }
        print_written(paths.iter().map(|path| path.display().to_string()).collect(), self.json)?;
        Ok(Verdict::Met)
    }
}
