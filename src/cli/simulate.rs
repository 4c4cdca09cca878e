//! Command `etalon simulate`.

use super::{Output, Verdict};
use crate::simulate::Truth;
use etalon_base::phrase;
use etalon_campaign::Campaign;
use std::path::PathBuf;

/// Write the exports, logs and observations of a campaign for a robot with known parameters and
/// given noise.
#[derive(Debug, clap::Args)]
pub struct Simulate {
    /// Folder of the campaign, or its campaign.toml.
    campaign: PathBuf,
    /// True parameters and measurements; by default truth.toml in the folder of the campaign.
    #[arg(long, value_name = "FILE")]
    truth: Option<PathBuf>,
    /// Seed of the noise, instead of the seed in the truth.
    #[arg(long)]
    seed: Option<u64>,
    /// Print the names of the files written as JSON.
    #[arg(long)]
    json: bool,
}

impl Simulate {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let campaign = Campaign::read(&self.campaign)?;
        let mut truth = Truth::read(&self.truth.unwrap_or_else(|| campaign.folder.join("truth.toml")))?;
        truth.seed = self.seed.unwrap_or(truth.seed);
        for error in truth.unmodelled.iter().flat_map(|unmodelled| unmodelled.stated()) {
            out.say(phrase!("unmodelled-said", error));
        }
        out.print_written(crate::simulate::simulate(&campaign, &truth)?, self.json)?;
        Ok(Verdict::Met)
    }
}
