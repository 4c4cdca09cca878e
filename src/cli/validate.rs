//! Command `etalon validate`.

use super::report::Reports;
use super::{Output, Verdict};
use crate::run::walk::presentation;
use crate::stages::verify::validation::Validated;
use crate::tasks::{Document, GivenParameters, ValidateOptions, validate};
use etalon_campaign::Campaign;
use etalon_documents::to_json;
use etalon_report::Renderer;
use std::path::PathBuf;

/// Judge given parameters on the data of a campaign.
///
/// For example, parameters from one instrument are compared with measurements of another, or last
/// year's parameters with measurements of today. No parameter of the robot is identified, and only
/// reports are written. The limits of the campaign are judged.
#[derive(Debug, clap::Args)]
#[command(after_help = "Exit code 1 if a limit of the campaign is not met.")]
pub struct Validate {
    /// Folder of the campaign, or its campaign.toml.
    campaign: PathBuf,
    /// Identified parameters; nominal by default.
    #[arg(long, value_name = "FILE")]
    parameters: Option<PathBuf>,
    /// Residual field: field.json of the run that identified the parameters.
    #[arg(long, value_name = "FILE", requires = "parameters")]
    field: Option<PathBuf>,
    #[command(flatten)]
    options: ValidateOptions,
    #[command(flatten)]
    reports: Reports,
    /// Print accuracy.json.
    #[arg(long)]
    json: bool,
}

impl Validate {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let campaign = Campaign::read(&self.campaign)?;
        self.reports.check(&self.parameters)?;
        let field = self.field.as_deref().map(Document::File);
        let given = self.parameters.as_deref().map(|file| GivenParameters { parameters: Document::File(file), field });
        let Validated { accuracy, messages } = validate(&campaign, given, &self.options)?;
        let presentation = self.reports.over(presentation(&campaign)?)?;
        out.remark_in(presentation.language, &messages);
        let renderer = Renderer::validation(&accuracy, presentation)?;
        self.reports.write(&renderer)?;
        out.answer(&renderer, self.json.then(|| to_json(&accuracy)).transpose()?)
    }
}
