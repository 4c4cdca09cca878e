//! Command `etalon verify`.

use super::bound::BoundOption;
use super::identify::{check_uncertainty, unread};
use super::inputs::Inputs;
use super::plan::read_candidates;
use super::report::Reports;
use super::text_format::TableFormat;
use super::{Verdict, answer, progress, remark, validity};
use crate::run::documents::read_parameters_and_run;
use crate::stages::kinds::{self, RowDefaults};
use crate::stages::observe::joint_range::{self, Joints};
use crate::stages::orientations::AngleOrder;
use crate::stages::table_file::TableFile;
use crate::stages::verify::earlier_parameters::unknown_geometry;
use crate::stages::verify::expected_deviation::{orientation_uncertainty_rad, unknown_quantity};
use crate::stages::verify::verification::{EarlierCalibration, plan, verify};
use etalon_base::error;
use etalon_base::files;
use etalon_base::message::{Message, Place, Problems};
use etalon_campaign::{Campaign, RobotFile, read_robot};
use etalon_documents::{
    CampaignReference, CampaignSummary, ParametersDocument, Presentation, VerificationDocument, to_json,
};
use etalon_identify::Settings;
use etalon_identify::plan::candidates::Candidates;
use etalon_report::Renderer;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Check whether identified parameters still apply, from a few measured poses.
///
/// Nothing is identified. The measured positions and orientations are compared with the values that
/// the parameters predict. The difference is judged by the uncertainty of the measurement, of the
/// parameters, and of the model in the calibration.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Answers: the parameters are valid; the base has moved; the zero of a joint has moved; another change.
The answer also states the motions that these poses detect with a probability of 95 %.
The probability that an unchanged robot is judged changed is at most 5 %.

Exit code 1 if the parameters are no longer valid."
)]
pub struct Verify {
    /// Observations of the calibration's targets: CSV with pose,cycle,target,x_mm,y_mm[,z_mm] in
    /// the same world frame, and one column per joint with its unit; also of other kinds that the
    /// calibration observed (docs/observations.md).
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
    /// Standard uncertainty (k = 1) of one measured coordinate in micrometres, if it differs from
    /// the calibration.
    #[arg(long, value_name = "UM")]
    standard_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) of a measured orientation about any axis in degrees, if the
    /// table has no `urot_deg`; by default the value of the calibration.
    #[arg(long, value_name = "DEG")]
    rotation_uncertainty_deg: Option<f64>,
    /// Order of the angles `a_deg`, `b_deg`, `c_deg` of an orientation: "zyx" (successively about
    /// the axes of the body), "fixed xyz" ...
    #[arg(long, value_name = "ORDER")]
    orientation: Option<String>,
    /// Campaign whose `[observations]` state how the table is read, in place of the options of
    /// tables.
    #[arg(long, value_name = "CAMPAIGN", conflicts_with_all = ["CellForm", "RowForm", "constants", "coverage_factor", "target", "pose", "orientation"])]
    like: Option<PathBuf>,
    #[command(flatten)]
    bound: BoundOption,
    #[command(flatten)]
    format: TableFormat,
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

/// Observations to verify.
struct ObservedTable {
    file: TableFile,
    /// Order of the angles of orientations.
    order: Option<AngleOrder>,
}

impl Verify {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        check_uncertainty("--standard-uncertainty-um", self.standard_uncertainty_um)?;
        let given =
            [Some(&self.robot), Some(&self.parameters), self.observations.as_ref(), self.choice.candidates.as_ref()];
        self.reports.check(given.into_iter().flatten())?;
        let robot_file = read_robot(&self.robot)?;
        let (document, run) = read_parameters_and_run(&self.parameters)?;
        let campaign = run.and_then(|run| run.json::<CampaignSummary>("campaign.json").ok());
        remark(validity::expired(&document, campaign.as_ref()).as_slice());
        remark(unknown_geometry(&document, &files::sha256(&files::read(&self.robot)?)).as_slice());
        let Some(observations) = &self.observations else { return self.plan(&robot_file, &document) };
        let observed = self.table(observations)?;
        let inputs = files::sha256_by_name(
            [&self.robot, &self.parameters, observations].into_iter().chain(robot_file.description_path()),
        )?;
        let mut found = self.verified(&robot_file, &document, &observed, inputs)?;
        found.calibration = campaign.map(CampaignReference::from);
        if !self.json {
            remark(&found.messages);
        }
        let renderer = Renderer::verification(&found, self.reports.over(Presentation::default())?)?;
        self.reports.write(&renderer)?;
        answer(&renderer, self.json.then(|| to_json(&found)).transpose()?)
    }

    /// The answer from observations in memory. Nothing is written.
    pub(super) fn in_memory(
        &self,
        given: &Inputs,
        document: &ParametersDocument,
    ) -> anyhow::Result<VerificationDocument> {
        check_uncertainty("--standard-uncertainty-um", self.standard_uncertainty_um)?;
        let file = self.format.parse(given.table.name, given.table.text)?;
        let observed = ObservedTable { file, order: self.order()? };
        Ok(self.verified(given.robot, document, &observed, given.inputs())?)
    }

    fn verified(
        &self,
        robot_file: &RobotFile,
        document: &ParametersDocument,
        observed: &ObservedTable,
        inputs: BTreeMap<String, String>,
    ) -> Result<VerificationDocument, Problems> {
        let ObservedTable { file: observed, order } = observed;
        let here = |problems: Problems| observed.place(problems);
        let targets = kinds::targets(&observed.table, &robot_file.branches()).map_err(here)?;
        let mut robot = robot_file.build(&targets).map_err(here)?;
        let mut messages: Vec<Message> = unread(robot.as_ref(), observed).into_iter().collect();
        joint_range::check_table(robot.as_ref(), &observed.table, &[], Joints::Measured).map_err(here)?;
        let stated_mm = self.standard_uncertainty_um.map(|u| u / 1000.0);
        let stated_rad = self.rotation_uncertainty_deg.map(f64::to_radians);
        let without = RowDefaults {
            length_mm: stated_mm.or(document.residuals.test.stated_standard_uncertainty_mm),
            rotation_rad: stated_rad.or_else(|| orientation_uncertainty_rad(document)),
            order: *order,
        };
        let measured = kinds::observed(robot.as_mut(), &observed.table, without, Settings::default(), &mut messages);
        let measured = measured.map_err(here)?;
        if let Some(unknown) = unknown_quantity(document, &measured.settings.conditions) {
            return Err(here(unknown.into()));
        }
        let calibration = EarlierCalibration::new(robot.as_mut(), document, stated_mm)?;
        let mut found = verify(calibration, measured, inputs)?;
        found.messages.splice(0..0, messages);
        Ok(found)
    }
}

/// The order of angles in a text that is at `place`.
fn order(text: &str, place: Place) -> Result<AngleOrder, Problems> {
    text.parse().map_err(|m: Message| Problems::from(m.at(place)))
}

impl Verify {
    /// The table of a file, and the order of the angles of its orientations, as options or the
    /// campaign of `--like` state them.
    fn table(&self, path: &Path) -> Result<ObservedTable, Problems> {
        let Some(folder) = &self.like else {
            return Ok(ObservedTable { file: self.format.read(path)?, order: self.order()? });
        };
        let campaign = Campaign::read(folder)?;
        let name = || folder.display().to_string();
        let stated = match &campaign.file.observations[..] {
            [stated] => stated,
            [] => return Err(error!("campaign-without-observations", campaign = name()).into()),
            several => {
                let count = several.len();
                return Err(error!("campaign-with-several-observations", campaign = name(), count).into());
            }
        };
        let of_campaign = |text: &toml::Spanned<String>| order(text.get_ref(), campaign.place(text));
        let order = stated.orientation.as_ref().map(of_campaign).transpose()?;
        let file = TableFile::observations(path, &etalon_formats::read_bytes(path)?, &stated.reading())?;
        Ok(ObservedTable { file, order })
    }

    /// Order of the angles of an orientation, from the option.
    fn order(&self) -> Result<Option<AngleOrder>, Problems> {
        self.orientation.as_ref().map(|text| order(text, Place::file("--orientation"))).transpose()
    }

    /// Chooses candidates to measure.
    fn plan(&self, robot_file: &RobotFile, document: &ParametersDocument) -> anyhow::Result<Verdict> {
        let Some(candidates) = &self.choice.candidates else { return Ok(Verdict::Met) };
        let table = self.format.read_other(candidates)?;
        let (mut robot, Candidates { observations, limit_violations }) = read_candidates(robot_file, &table)?;
        let inputs = files::sha256_by_name(
            [&self.robot, &self.parameters, candidates].into_iter().chain(robot_file.description_path()),
        )?;
        let stated_mm = self.standard_uncertainty_um.map(|u| u / 1000.0);
        let calibration =
            EarlierCalibration::new(robot.as_mut(), document, stated_mm)?.with_bound(self.bound.stated()?);
        let mut found = plan(calibration, observations, self.choice.positions, inputs, &mut progress)?;
        found.messages.extend(limit_violations);
        if !self.json {
            remark(&found.messages);
        }
        let renderer = Renderer::verification_plan(&found, self.reports.over(Presentation::default())?)?;
        self.reports.write(&renderer)?;
        answer(&renderer, self.json.then(|| to_json(&found)).transpose()?)
    }
}
