//! Task of `etalon verify`.

use super::bound::BoundOption;
use super::checks::{angle_order, check_uncertainty};
use super::inputs::{Inputs, Table};
use super::plan::read_candidates;
use super::text_format::TableFormat;
use crate::run::walk::{self, Observed};
use crate::stages::calibrate::selection::export_order;
use crate::stages::join::Observations;
use crate::stages::kinds::{self, RowDefaults};
use crate::stages::observe::joint_range::{self, Joints};
use crate::stages::orientations::AngleOrder;
use crate::stages::table_file::TableFile;
use crate::stages::verify::copies::copies;
use crate::stages::verify::expected_deviation::{angle_uncertainty_rad, unknown_quantity};
use crate::stages::verify::verification::{self, EarlierCalibration};
use etalon_base::message::{Message, Problems, Result};
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, ObservationsDefinition};
use etalon_documents::{ParametersDocument, VerificationDocument, VerificationPlanDocument, VerificationVerdict};
use etalon_identify::Settings;
use etalon_identify::plan::candidates::Candidates;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Options of a verification.
#[derive(Clone, Debug, Default, clap::Args, Deserialize)]
#[serde(default)]
pub struct VerifyOptions {
    /// Standard uncertainty (k = 1) of one measured coordinate in micrometres, if it differs from
    /// the calibration.
    #[arg(long, value_name = "UM")]
    pub standard_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) of a measured orientation about any axis in degrees, if the
    /// table has no `urot_deg`; by default the value of the calibration.
    #[arg(long, value_name = "DEG")]
    pub rotation_uncertainty_deg: Option<f64>,
    /// Order of the angles `a_deg`, `b_deg`, `c_deg` of an orientation: "zyx" (successively about
    /// the axes of the body), "fixed xyz" ...
    #[arg(long, value_name = "ORDER")]
    pub orientation: Option<String>,
    /// Campaign whose `[observations]` describe how the table is read, instead of the options of
    /// tables.
    #[arg(long, value_name = "CAMPAIGN", conflicts_with_all = ["CellForm", "RowForm", "constants", "coverage_factor", "target", "pose", "orientation"])]
    pub like: Option<PathBuf>,
    /// Bound of the uncertainties of a plan.
    #[command(flatten)]
    #[serde(flatten)]
    pub bound: BoundOption,
    /// Options for reading the table.
    #[command(flatten)]
    #[serde(flatten)]
    pub format: TableFormat,
}

/// Observations to verify.
struct ObservedTable {
    file: TableFile,
    /// Order of the angles of orientations.
    order: Option<AngleOrder>,
    /// Standard uncertainty of a coordinate, if not the one of the calibration.
    stated_mm: Option<f64>,
    /// Standard uncertainty of an orientation (rad), likewise.
    stated_rad: Option<f64>,
    /// SHA-256 of the files, by name.
    inputs: BTreeMap<String, String>,
    /// Warnings about the files.
    messages: Vec<Message>,
}

/// Judges from few measured poses whether identified parameters still apply.
///
/// # Errors
/// Fails for a table or parameters that do not belong to the robot.
pub fn verify(inputs: &Inputs, document: &ParametersDocument, options: &VerifyOptions) -> Result<VerificationDocument> {
    verify_new(inputs, document, options, None)
}

/// [`verify`] with the file of the `calibrated` observations, from which copies are told.
///
/// # Errors
/// Fails like [`verify`].
pub fn verify_new(
    inputs: &Inputs,
    document: &ParametersDocument,
    options: &VerifyOptions,
    calibrated: Option<&Path>,
) -> Result<VerificationDocument> {
    options.check()?;
    let ObservedTable { file: observed, order, stated_mm, stated_rad, inputs: files, mut messages } =
        options.observed(inputs)?;
    let here = |problems: Problems| observed.place(problems);
    let targets = kinds::targets(&observed.table, &inputs.robot.branches()).map_err(here)?;
    let mut robot = inputs.robot.build(&targets).map_err(here)?;
    joint_range::check_table(robot.as_ref(), &observed.table, &[], Joints::Measured).map_err(here)?;
    let without = RowDefaults {
        length_mm: stated_mm.or(document.residuals.test.stated_standard_uncertainty_mm),
        rotation_rad: stated_rad.or_else(|| angle_uncertainty_rad(document)),
        order,
    };
    let measured = kinds::observed(robot.as_mut(), &observed.table, without, Settings::default(), &mut messages);
    let measured = measured.map_err(here)?;
    if let Some(unknown) = unknown_quantity(document, &measured.settings.conditions) {
        return Err(here(unknown.into()));
    }
    let calibration = EarlierCalibration::new(robot.as_mut(), document, stated_mm)?;
    // an earlier file that cannot be read says nothing of the new one
    let earlier = calibrated.and_then(|path| Table::File(path).read().ok());
    let copies = earlier.map_or(0, |earlier| copies(&observed.table, &earlier.table));
    let rows = observed.table.height();
    if copies > 0 {
        messages.push(warning!("readings-of-calibration", count = copies, rows).to_decide());
    }
    let mut found = verification::verify(calibration, measured, files)?;
    found.residuals.copies = copies;
    if copies > 0 && found.verdict == VerificationVerdict::Valid {
        found.meaning = phrase!("verified-by-copies", count = copies, rows).into();
    }
    found.messages.splice(0..0, messages);
    Ok(found)
}

/// Chooses the poses to measure among candidates for a verification: the poses that detect the
/// smallest changes.
///
/// # Errors
/// Fails for a table or parameters that do not belong to the robot.
pub fn plan_verification(
    inputs: &Inputs,
    document: &ParametersDocument,
    options: &VerifyOptions,
    positions: usize,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<VerificationPlanDocument> {
    options.check()?;
    let table = options.format.read_other(inputs.table)?;
    let (mut robot, Candidates { observations, limit_violations }) = read_candidates(inputs.robot, &table)?;
    let calibration = EarlierCalibration::new(robot.as_mut(), document, options.standard_uncertainty_mm())?;
    let calibration = calibration.with_bound(options.bound.stated()?);
    let mut found = verification::plan(calibration, observations, positions, inputs.sha256_by_name()?, progress)?;
    found.messages.extend(limit_violations);
    Ok(found)
}

impl VerifyOptions {
    /// Checks the options before anything is read.
    pub(crate) fn check(&self) -> Result<()> {
        check_uncertainty("--standard-uncertainty-um", self.standard_uncertainty_um)
    }

    fn standard_uncertainty_mm(&self) -> Option<f64> {
        self.standard_uncertainty_um.map(|u| u / 1000.0)
    }

    fn rotation_uncertainty_rad(&self) -> Option<f64> {
        self.rotation_uncertainty_deg.map(f64::to_radians)
    }

    /// The observations as options, the campaign of `--like` or their own campaign state them.
    fn observed(&self, inputs: &Inputs) -> Result<ObservedTable> {
        if let Table::File(path) = inputs.table
            && (path.is_dir() || path.extension().is_some_and(|end| end == "toml"))
        {
            return self.observed_campaign(path, inputs);
        }
        let (file, order) = match &self.like {
            None => {
                let order = angle_order("--orientation", self.orientation.as_deref())?;
                (self.format.read(inputs.table)?, order)
            }
            Some(folder) => table_like(folder, inputs.table)?,
        };
        let (stated_mm, stated_rad) = (self.standard_uncertainty_mm(), self.rotation_uncertainty_rad());
        Ok(ObservedTable { file, order, stated_mm, stated_rad, inputs: inputs.sha256_by_name()?, messages: Vec::new() })
    }

    /// The observations of a campaign: of its exports and logs, or of its table.
    fn observed_campaign(&self, path: &Path, inputs: &Inputs) -> Result<ObservedTable> {
        if self.like.is_some() || self.orientation.is_some() || !self.format.is_default() {
            return Err(error!("options-of-table-for-campaign", campaign = path.display().to_string()).into());
        }
        let campaign = Campaign::read(path)?;
        let Observed { gathered, joined, .. } = walk::observed(&campaign)?;
        let order = match &campaign.file.observations[..] {
            [] => export_order(&campaign),
            [stated, ..] => order_in_campaign(&campaign, stated)?,
        };
        // a run identifies from the first log
        let table = joined.observations.into_iter().next().map(|(_, observations)| match observations {
            Observations::Table(table) => table,
            log @ Observations::Log(_) => log.into_table(),
        });
        let mut files = inputs.robot_sha256_by_name()?;
        files.extend(gathered.document.inputs());
        Ok(ObservedTable {
            file: TableFile::in_memory(&campaign.path, table.unwrap_or_default()),
            order,
            stated_mm: self.standard_uncertainty_mm().or(Some(campaign.coordinate_uncertainty_mm())),
            stated_rad: self.rotation_uncertainty_rad().or(campaign.file.instrument.rotation_uncertainty_rad()),
            inputs: files,
            messages: gathered.document.messages,
        })
    }
}

/// Order of the angles in the observations of a campaign.
fn order_in_campaign(campaign: &Campaign, stated: &ObservationsDefinition) -> Result<Option<AngleOrder>> {
    let order = |text: &toml::Spanned<String>| {
        let order = text.get_ref().parse::<AngleOrder>();
        order.map_err(|message: Message| Problems::from(message.at(campaign.place(text))))
    };
    stated.orientation.as_ref().map(order).transpose()
}

/// A table that is read like the observations of a campaign, with the order of its angles.
fn table_like(folder: &Path, table: Table) -> Result<(TableFile, Option<AngleOrder>)> {
    let campaign = Campaign::read(folder)?;
    let name = || folder.display().to_string();
    match &campaign.file.observations[..] {
        [stated] => {
            let order = order_in_campaign(&campaign, stated)?;
            Ok((table.read_as(&stated.reading())?, order))
        }
        [] => Err(error!("campaign-without-observations", campaign = name()).into()),
        several => {
            let count = several.len();
            Err(error!("campaign-with-several-observations", campaign = name(), count).into())
        }
    }
}
