//! Command `etalon verify`.

use super::report::Reports;
use super::{Output, Verdict, progress};
use crate::run::documents::{read_loaded_parameters, read_parameters_and_run};
use crate::stages::verify::earlier_parameters::{mastered, unknown_geometry};
use crate::tasks::validity;
use crate::tasks::{Inputs, Table, VerifyOptions, plan_verification, verify_new};
use etalon_base::files;
use etalon_base::message::Message;
use etalon_campaign::read_robot;
use etalon_documents::{CampaignReference, CampaignSummary, Presentation, to_json};
use etalon_report::Renderer;
use std::path::PathBuf;

/// Check whether identified parameters still apply, from a few measured poses.
///
/// Nothing is identified. The observations (positions, orientations, distances, contacts and other
/// kinds) are compared with the values that the parameters predict. The difference is judged by the
/// uncertainty of the measurement, of the parameters, and of the model in the calibration.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Answers: the parameters are valid; the base has moved; the zero of a joint has moved; another change.
The answer also states the motions that these poses detect with a probability of 95 %.
The probability that an unchanged robot is judged changed is at most 5 %.

Exit code 1 if the parameters are no longer valid."
)]
pub struct Verify {
    /// Observations of the calibration's targets: CSV with pose,cycle,target,x_mm,y_mm[,z_mm] in
    /// the same world frame, and one column per joint with its unit. Rows may be of other kinds
    /// that the calibration observed (docs/observations.md). Or a campaign, whose exports and logs
    /// are read.
    #[arg(required_unless_present = "candidates")]
    observations: Option<PathBuf>,
    #[command(flatten)]
    choice: ChoiceOptions,
    /// Robot file.
    #[arg(long, value_name = "FILE")]
    robot: PathBuf,
    /// Identified parameters.
    #[arg(long, value_name = "FILE")]
    parameters: PathBuf,
    /// Controller file of the calibration whose joint zeros the controller has loaded as mastering
    /// values: its joint values contain them.
    #[arg(long, value_name = "FILE")]
    mastered: Option<PathBuf>,
    #[command(flatten)]
    options: VerifyOptions,
    #[command(flatten)]
    reports: Reports,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

/// Options of the choice of poses to measure.
#[derive(Clone, Debug, clap::Args)]
struct ChoiceOptions {
    /// Candidates, instead of observations, from which the poses that detect the smallest changes
    /// are chosen: a table as for `etalon plan`.
    #[arg(long, value_name = "FILE", conflicts_with = "observations")]
    candidates: Option<PathBuf>,
    /// Number of candidates to choose.
    #[arg(long, value_name = "N", default_value_t = 8, requires = "candidates")]
    positions: usize,
}

impl Verify {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        self.options.check()?;
        let given =
            [Some(&self.robot), Some(&self.parameters), self.observations.as_ref(), self.choice.candidates.as_ref()];
        self.reports.check(given.into_iter().flatten())?;
        let robot = &read_robot(&self.robot)?;
        let (mut document, run) = read_parameters_and_run(&self.parameters)?;
        if let Some(file) = &self.mastered {
            let loaded = read_loaded_parameters(&self.parameters, Some(file))?;
            mastered(robot.build(&robot.targets_or("tool"))?, &mut document, &loaded);
        }
        let calibrated = run.as_ref().map(|run| run.path("observations.csv"));
        let campaign = run.and_then(|run| run.json::<CampaignSummary>("campaign.json").ok());
        out.remark(validity::expired(&document, campaign.as_ref()).as_slice());
        out.remark(unknown_geometry(&document, &files::sha256(&files::read(&self.robot)?)).as_slice());
        let parameters = files::sha256_by_name([&self.parameters])?;
        let presentation = self.reports.over(Presentation::default())?;
        let inputs = |table| Inputs { robot, stated: Table::File(&self.robot), table: Table::File(table) };
        if let Some(observations) = &self.observations {
            let mut found = verify_new(&inputs(observations), &document, &self.options, calibrated.as_deref())?;
            found.provenance.inputs.extend(parameters);
            found.calibration = campaign.map(CampaignReference::from);
            return self.answer(&found, &found.messages, &Renderer::verification(&found, presentation)?, out);
        }
        // clap demands one of both
        let Some(candidates) = &self.choice.candidates else { return Ok(Verdict::Met) };
        let positions = self.choice.positions;
        let mut found = plan_verification(&inputs(candidates), &document, &self.options, positions, &mut progress)?;
        found.provenance.inputs.extend(parameters);
        self.answer(&found, &found.messages, &Renderer::verification_plan(&found, presentation)?, out)
    }

    fn answer(
        &self,
        document: &impl serde::Serialize,
        messages: &[Message],
        renderer: &Renderer,
        out: &Output,
    ) -> anyhow::Result<Verdict> {
        if !self.json {
            out.remark(messages);
        }
        self.reports.write(renderer)?;
        out.answer(renderer, self.json.then(|| to_json(document)).transpose()?)
    }
}
