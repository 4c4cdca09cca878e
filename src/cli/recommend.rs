//! Command `etalon recommend`.

use super::report::Reports;
use super::{Output, Verdict, progress};
use crate::run::validation::recommend;
use crate::run::walk::presentation;
use etalon_base::error;
use etalon_base::files;
use etalon_base::message::Problems;
use etalon_campaign::Campaign;
use etalon_documents::to_json;
use etalon_report::Renderer;
use std::path::PathBuf;

/// Recommend identified parameters to be loaded into the controller.
///
/// Effects (zeros, geometry, gains, harmonics, coupling, bending) are tested on poses that are
/// excluded from the identification. A parameter is tested by its change divided by the uncertainty
/// of the change. The recommended parameters are identified again, while all others stay nominal.
#[derive(Debug, clap::Args)]
pub struct Recommend {
    /// Folder of the campaign, or its campaign.toml.
    campaign: PathBuf,
    /// Write the recommended parameters as a new parameters.json, for `etalon export`.
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
    #[command(flatten)]
    reports: Reports,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

impl Recommend {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        if let Some(path) = self.write.as_deref().filter(|path| path.exists()) {
            return Err(Problems::from(error!("file-exists", file = path.display().to_string())).into());
        }
        self.reports.check(&self.write)?;
        let campaign = Campaign::read(&self.campaign)?;
        let found = recommend(&campaign, &mut progress)?;
        let presentation = self.reports.over(presentation(&campaign)?)?;
        out.remark_in(presentation.language, &found.messages);
        if let Some(path) = &self.write {
            files::write(path, &to_json(&found.recommended)?)?;
        }
        let renderer = Renderer::recommendation(&found, presentation)?;
        self.reports.write(&renderer)?;
        out.answer(&renderer, self.json.then(|| to_json(&found)).transpose()?)
    }
}
