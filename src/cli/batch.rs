//! Command `etalon batch`.

use super::report::Branding;
use super::{Output, Verdict, progress};
use crate::run::batch::{Batch as Batched, batch, folders};
use crate::run::pipeline::Wanted;
use etalon_base::catalogue::Phrase;
use etalon_base::files;
use etalon_base::message::printable;
use etalon_base::phrase;
use etalon_documents::to_json;
use etalon_documents::{BatchDocument, BatchEnd, BatchEntry, Presentation};
use std::fmt::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Run many campaigns on all cores, and write their results as one table and one page.
///
/// If a campaign has not changed since its last run, its results are read again. An interrupted
/// batch therefore continues where it stopped. A failed campaign does not stop the others.
#[derive(Debug, clap::Args)]
pub struct Batch {
    /// Campaigns, folders of campaigns, or text files that list campaigns, one per line, relative
    /// to the file.
    #[arg(required = true)]
    campaigns: Vec<PathBuf>,
    /// Omit reports, which `etalon report` can write later, and tables of points, joint values and
    /// observations.
    #[arg(long)]
    documents: bool,
    /// Run a campaign again if its results are older than this file, for example older than the
    /// program.
    #[arg(long, value_name = "FILE")]
    newer_than: Option<PathBuf>,
    /// Folder for batch.parquet and batch.html.
    #[arg(long, value_name = "FOLDER", default_value = ".")]
    to: PathBuf,
    #[command(flatten)]
    branding: Branding,
    /// Print the outcome of each campaign as JSON.
    #[arg(long)]
    json: bool,
}

impl Batch {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let campaigns = folders(&self.campaigns)?;
        let presentation = self.branding.over(Presentation::default())?;
        let age = |path: &PathBuf| std::fs::metadata(path).and_then(|file| file.modified());
        let since = self.newer_than.as_ref().map(age).transpose();
        let since =
            since.map_err(|e| anyhow::anyhow!("{}", phrase!("newer-than-unreadable", reason = e.to_string())))?;
        let wanted = if self.documents { Wanted::Documents } else { Wanted::Reports };
        let ended = AtomicUsize::new(0);
        let said = |entry: &BatchEntry| {
            let ended = ended.fetch_add(1, Ordering::Relaxed) + 1;
            if let Some(message) = &entry.message {
                let (ended, campaign) = (end(entry.ended), printable(&entry.campaign).to_string());
                out.say(format_args!("{}\n{message}\n", phrase!("batch-not-done", ended, campaign)));
            }
            progress(ended, campaigns.len());
        };
        // before the campaigns are run
        let [table, page] = files::places(&self.to, ["batch.parquet", "batch.html"])?;
        let Batched { document, figures } =
            files::write_by(&table, |file| Ok(batch(&campaigns, wanted, since, file, said)?))?;
        files::write_by(&page, |file| etalon_report::batch::write(&document, &figures, &self.to, &presentation, file))?;
        let verdict = match (document.failed, document.not_met) {
            (0, 0) => Verdict::Met,
            (0, _) => Verdict::LimitNotMet,
            _ => Verdict::NotRun,
        };
        let data = if self.json { to_json(&document)? } else { as_text(&document).into_bytes() };
        Ok(out.print_after_writing(data, verdict))
    }
}

/// End of a campaign in words.
fn end(end: BatchEnd) -> Phrase {
    match end {
        BatchEnd::Done => phrase!("batch-done"),
        BatchEnd::NotMet => phrase!("batch-not-met"),
        BatchEnd::Failed => phrase!("batch-failed"),
        BatchEnd::Skipped => phrase!("batch-skipped"),
    }
}

fn as_text(document: &BatchDocument) -> String {
    let mut text = String::new();
    for c in &document.campaigns {
        let ended = if c.output.is_some() && !c.computed {
            phrase!("batch-unchanged", ended = end(c.ended))
        } else {
            end(c.ended)
        };
        let _ = writeln!(text, "{:<40} {ended}", printable(&c.campaign));
    }
    let BatchDocument { done, not_met, failed, skipped, .. } = document;
    let _ = writeln!(text, "{}", phrase!("batch-counts", done, not_met, failed, skipped));
    text
}
