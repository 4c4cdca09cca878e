//! Command `etalon check`.

use super::{Output, Verdict, shell_word};
use crate::run::walk::Checked;
use crate::tasks::{check, find};
use etalon_base::message::printable;
use etalon_base::phrase;
use etalon_documents::{JointTravel, Uncontrolled};
use std::path::PathBuf;

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
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        if self.json {
            let document = check(&self.campaign);
            let verdict = if document.errors.is_empty() { Verdict::Met } else { Verdict::NotRun };
            return out.print_with(etalon_documents::to_json(&document)?, verdict);
        }
        let (checked, problems) = find(&self.campaign);
        let Some(found) = checked.filter(|_| problems.0.is_empty()) else { return Err(problems.into()) };
        let Checked { inputs: document, joints, not_controlled, .. } = found;
        out.remark(&document.messages);
        for source in document.sources.iter().filter(|s| s.rows_read > 0) {
            let refused = source.refused.len();
            let (file, dialect) = (printable(&source.file), printable(source.dialect.english()));
            let line = phrase!("check-source", file, rows = source.rows_read, refused, dialect);
            out.print_text(&format!("{line}\n"))?;
        }
        for JointTravel { column, lowest, highest } in &joints {
            out.print_text(&format!("{}: {lowest:.2} .. {highest:.2}\n", printable(column)))?;
        }
        for Uncontrolled { what, keys, .. } in &not_controlled {
            let keys = printable(&keys.join(", "));
            out.print_text(&format!("{}\n", phrase!("check-not-detectable", what, keys)))?;
        }
        let next = format!("`etalon run {}`", shell_word(&self.campaign));
        let path = if self.campaign.is_dir() { self.campaign.join("campaign.toml") } else { self.campaign };
        let file = printable(&path.display().to_string());
        out.print_text(&format!("{}\n", phrase!("check-verdict", file, warnings = document.messages.len())))?;
        out.next_step(self.json, next);
        Ok(Verdict::Met)
    }
}
