//! Command `etalon uncertainty`.

use super::report::Reports;
use super::{Output, Verdict, progress};
use crate::run::validation::uncertainty;
use crate::run::walk::presentation;
use crate::stages::uncertainty::monte_carlo::Draws;
use etalon_campaign::Campaign;
use etalon_documents::to_json;
use etalon_report::Renderer;
use std::path::PathBuf;

/// Compute distributions of a campaign's results by Monte Carlo and bootstrap.
///
/// Every uncertain quantity of the campaign is drawn randomly (JCGM 101): points of frames,
/// targets, scale, temperature, homing. Frames and parameters are identified again from each draw.
/// The draws are compared with the linear uncertainties of `etalon run`. The bootstrap resamples
/// the measured poses and cycles, and omits tolerances. Only reports are written.
#[derive(Debug, clap::Args)]
pub struct Uncertainty {
    /// Folder of the campaign, or its campaign.toml.
    campaign: PathBuf,
    /// Maximum number of draws; fewer are used once two digits of all standard uncertainties are
    /// stable.
    #[arg(long, default_value_t = 20_000, value_parser = clap::value_parser!(u32).range(100..=10_000_000))]
    draws: u32,
    /// Number of resamples of poses and cycles; 0 for none.
    #[arg(long, default_value_t = 1_000, value_parser = clap::value_parser!(u32).range(0..=1_000_000))]
    resamples: u32,
    /// Seed of the draws; equal seeds give equal numbers on any number of threads.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    #[command(flatten)]
    reports: Reports,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

impl Uncertainty {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let campaign = Campaign::read(&self.campaign)?;
        self.reports.check(None)?;
        let draws = Draws { most: self.draws as usize, resamples: self.resamples as usize, seed: self.seed };
        let document = uncertainty(&campaign, draws, &mut progress)?;
        let presentation = self.reports.over(presentation(&campaign)?)?;
        out.remark_in(presentation.language, &document.messages);
        let json = if self.json { Some(to_json(&document)?) } else { None };
        let renderer = Renderer::uncertainty(&document, presentation)?;
        self.reports.write(&renderer)?;
        out.answer(&renderer, json)
    }
}
