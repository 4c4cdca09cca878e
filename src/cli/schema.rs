//! Command `etalon schema`.

use super::{Output, Verdict};
use crate::tasks;

/// Print the JSON Schema of an input file or of a JSON document.
#[derive(Debug, clap::Args)]
#[command(after_help = "Input files, for editors and other programs that write campaigns:
  campaign.toml, robot.toml, study.toml, truth.toml (of a simulation)

Documents of the output folder, by the name of the file without `.json`:
  accuracy, campaign (what the campaign states about itself), controllers, features, field, frames, geometric, import,
  iso9283, iso9283-compliance, iso9283-streams, manifest, parameters, verdict

Answers to `--json` of commands:
  axes, batch, benchmark-score, cell, check, compare, compensation, explanation, fit, formats, iso230, iso9283-plan, iso9283-stream,
  kinematics, plan, predictions, recommendation, selftest, study, uncertainty, verification, verification-plan, written (files that a command wrote)")]
pub struct Schema {
    /// Name of the file or document, e.g. campaign.toml or parameters.
    name: String,
    /// Accepted as for other commands; a schema is always JSON.
    #[arg(long)]
    json: bool,
}

impl Schema {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        out.print(tasks::schema(&self.name)?)?;
        Ok(Verdict::Met)
    }
}
