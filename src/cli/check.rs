//! `etalon check`

use super::{Verdict, print, say};
use crate::campaign::{Campaign, check};
use std::path::PathBuf;

/// Find everything that is wrong with a campaign, without computing
#[derive(Debug, clap::Args)]
pub struct Check {
    /// Folder of the campaign, or its campaign.toml
    campaign: PathBuf,
    /// Print what was read and refused as JSON
    #[arg(long)]
    json: bool,
}

impl Check {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let (campaign, mut problems) = Campaign::recover(&self.campaign)?;
        let Some(campaign) = campaign else { return Err(problems.into()) };
        let imported = match check(&campaign) {
            Ok(imported) if problems.0.is_empty() => imported,
            Ok(_) => return Err(problems.into()),
            Err(more) => {
                problems.0.extend(more.0);
                return Err(problems.into());
            }
        };
        let document = &imported.document;
        for message in &document.messages {
            say(format_args!("{message}\n"));
        }
        if self.json {
            print(crate::output::to_json(document)?)?;
        } else {
            for source in document.sources.iter().filter(|s| s.rows_read > 0) {
                let refused = source.refused.len();
                print(format!("{}: {} rows, {refused} refused ({})\n", source.file, source.rows_read, source.dialect))?;
            }
            print(format!("{}: nothing is wrong\n", campaign.path))?;
        }
        Ok(Verdict::Met)
    }
}
