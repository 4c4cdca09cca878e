//! Command `etalon check`.

use super::{Verdict, print_text, print_with, remark};
use crate::run::walk::{Checked, checked};
use etalon_base::message::{Problems, printable};
use etalon_campaign::Campaign;
use etalon_documents::{CheckDocument, JointTravel};
use std::path::{Path, PathBuf};

/// Find all errors of a campaign without computing.
#[derive(Debug, clap::Args)]
pub struct Check {
    /// Folder of the campaign, or its campaign.toml.
    campaign: PathBuf,
    /// Print errors, warnings and imported rows as JSON.
    #[arg(long)]
    json: bool,
}

impl Check {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let (checked, problems) = find(&self.campaign);
        let (imported, joints) = checked.map(|checked| (checked.inputs, checked.joints)).unzip();
        let joints = joints.unwrap_or_default();
        if self.json {
            let (messages, sources) = imported.map(|i| (i.messages, i.sources)).unwrap_or_default();
            let messages = Problems(problems.0.into_iter().chain(messages).collect()).grouped();
            let document = CheckDocument::new(self.campaign.display().to_string(), &messages.0, sources, joints);
            let verdict = if document.errors.is_empty() { Verdict::Met } else { Verdict::NotRun };
            return print_with(etalon_documents::to_json(&document)?, verdict);
        }
        let Some(document) = imported.filter(|_| problems.0.is_empty()) else { return Err(problems.into()) };
        remark(&document.messages);
        for source in document.sources.iter().filter(|s| s.rows_read > 0) {
            let refused = source.refused.len();
            let (file, dialect) = (printable(&source.file), printable(&source.dialect));
            print_text(&format!("{file}: {} rows, {refused} refused ({dialect})\n", source.rows_read))?;
        }
        for JointTravel { column, lowest, highest } in &joints {
            print_text(&format!("{}: {lowest:.2} .. {highest:.2}\n", printable(column)))?;
        }
        let path = if self.campaign.is_dir() { self.campaign.join("campaign.toml") } else { self.campaign };
        let verdict = match document.messages.len() {
            0 => "nothing is wrong".to_owned(),
            1 => "no errors, 1 warning".to_owned(),
            n => format!("no errors, {n} warnings"),
        };
        print_text(&format!("{}: {verdict}\n", printable(&path.display().to_string())))?;
        Ok(Verdict::Met)
    }
}

/// Contents of the campaign's files, and all their problems.
fn find(path: &Path) -> (Option<Checked>, Problems) {
    let (campaign, mut problems) = match Campaign::recover(path) {
        Ok(found) => found,
        Err(problems) => return (None, problems),
    };
    let Some(campaign) = campaign else { return (None, problems) };
    let mut checked = checked(&campaign);
    problems.0.append(&mut checked.problems.0);
    (Some(checked), problems)
}
