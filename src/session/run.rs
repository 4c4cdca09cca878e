//! A run of the campaign, with the files that the page offers.

use crate::run::{output, pipeline, results};
use crate::session::words;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::phrase;
use etalon_campaign::Campaign;
use etalon_documents::Results;
use etalon_report::verdict_in_words;
use etalon_view::{Download, Verdict};
use std::path::{Path, PathBuf};

/// Results of a run for the page.
pub(super) struct Ran {
    /// Output folder.
    pub folder: PathBuf,
    pub messages: Vec<Message>,
    pub verdict: Verdict,
    pub downloads: Vec<Download>,
}

impl Ran {
    /// Runs a campaign.
    ///
    /// # Errors
    /// Fails like [`pipeline::run`].
    pub fn new(campaign: &Campaign, progress: &dyn Fn(Phrase)) -> Result<Self> {
        progress(phrase!("view-run-begins"));
        let found = pipeline::evaluate(campaign)?;
        progress(phrase!("view-run-writes"));
        let outcome = pipeline::write_evaluated(campaign, found)?;
        Ok(Self::from_results(campaign.output()?, &outcome.results))
    }

    /// Results in the output folder, if they belong to the current files.
    pub fn stored(campaign: &Campaign) -> Option<Self> {
        let documents = output::current(campaign, "verdict.json")?;
        let read = results::read(&documents).ok()?;
        Some(Self::from_results(campaign.output().ok()?, &read))
    }

    fn from_results(folder: PathBuf, results: &Results) -> Self {
        let words = verdict_in_words(results);
        let verdict =
            Verdict { status: words::status(results.verdict.verdict), lines: words.sentences, next: words.steps };
        let downloads = downloads(&folder, results);
        Self { folder, messages: results.messages().cloned().collect(), verdict, downloads }
    }
}

/// Reports and controller files of the output folder.
fn downloads(folder: &Path, results: &Results) -> Vec<Download> {
    let language = results.campaign.report.language.code();
    let reports = etalon_report::kinds().map(|kind| {
        let label = phrase!("view-download-report", kind = kind.to_uppercase());
        (format!("report.{kind}"), label)
    });
    let written = results.campaign.controller_files.iter();
    let written = written.map(|file| (file.file.clone(), phrase!("view-download-file")));
    let offered = |(name, label): (String, Phrase)| {
        let bytes = std::fs::metadata(folder.join(&name)).ok().filter(std::fs::Metadata::is_file)?.len();
        Some(Download { name, label: label.text(language), bytes })
    };
    reports.chain(written).filter_map(offered).collect()
}
