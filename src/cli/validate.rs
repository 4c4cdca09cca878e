//! Command `etalon validate`.

use super::report::Reports;
use super::{Output, Verdict};
use crate::run::documents::{read_field, read_parameters};
use crate::run::validation::validate;
use crate::run::walk::presentation;
use crate::stages::verify::validation::{Validated, Validation};
use etalon_base::files;
use etalon_campaign::Campaign;
use etalon_documents::{FrameOrigin, to_json};
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
    /// Origin of base and targets.
    #[arg(long, value_enum, default_value_t = FrameOrigin::Refit)]
    frames: FrameOrigin,
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
        let document = self.parameters.as_deref().map(read_parameters).transpose()?;
        let field = match (&self.field, &self.parameters) {
            (Some(field), Some(parameters)) => Some(read_field(field, parameters)?),
            _ => None,
        };
        let judged = Validation { document: document.as_ref(), field: field.as_ref(), frames: self.frames };
        let Validated { mut accuracy, messages } = validate(&campaign, judged)?;
        if let Some(provenance) = &mut accuracy.provenance {
            provenance.inputs.extend(files::sha256_by_name(&self.parameters)?);
            provenance.inputs.extend(files::sha256_by_name(&self.field)?);
        }
        let presentation = self.reports.over(presentation(&campaign)?)?;
        out.remark_in(presentation.language, &messages);
        let renderer = Renderer::validation(&accuracy, presentation)?;
        self.reports.write(&renderer)?;
        out.answer(&renderer, self.json.then(|| to_json(&accuracy)).transpose()?)
    }
}
