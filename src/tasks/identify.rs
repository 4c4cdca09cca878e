//! Task of `etalon identify`.

use super::bound::BoundOption;
use super::checks::{angle_order, check_uncertainty, needs};
use super::inputs::Inputs;
use super::model::ModelOptions;
use super::text_format::TableFormat;
use crate::stages::calibrate::evaluation::Judgement;
use crate::stages::calibrate::findings::Findings;
use crate::stages::calibrate::identification::state_positions;
use crate::stages::calibrate::selection::Input;
use crate::stages::calibrate::solution::{Basis, Solution};
use crate::stages::evaluate::errors::point_errors;
use crate::stages::evaluate::sets::Sets;
use crate::stages::join::Observations;
use crate::stages::judge::circumstances::hold_constant;
use crate::stages::kinds::{self, Observed, RowDefaults};
use crate::stages::observe::exclusions::{Exclusion, excluded_rows};
use crate::stages::observe::repeats::stale;
use crate::stages::remedies::remedied;
use crate::stages::table_file::TableFile;
use crate::stages::uncertainty::bounds::open_set_up;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::warning;
use etalon_campaign::Exclude;
use etalon_documents::{ParametersDocument, PointError, parameters_document, untested_mistakes, warning_messages};
use etalon_identify::{ResidualKind, Settings, Systematic, weigh};
use etalon_robots::Robot;
use serde::Deserialize;

/// Options of an identification.
#[derive(Clone, Debug, Default, clap::Args, Deserialize)]
#[serde(default)]
pub struct IdentifyOptions {
    /// Standard uncertainty (k = 1) of a measured coordinate in micrometres; by default estimated
    /// from the residuals.
    #[arg(long, value_name = "UM")]
    pub standard_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) in micrometres common to all rows with equal coordinates.
    /// Example: a ball that is measured once and touched in several working modes. The other
    /// uncertainty is then of the contact.
    #[arg(long, value_name = "UM", requires = "standard_uncertainty_um")]
    pub common_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) of a measured orientation about any axis in degrees, if the
    /// table has no `urot_deg`.
    #[arg(long, value_name = "DEG")]
    pub rotation_uncertainty_deg: Option<f64>,
    /// Order of the angles `a_deg`, `b_deg`, `c_deg` of an orientation: "zyx" (successively about
    /// the axes of the body), "fixed xyz" ...
    #[arg(long, value_name = "ORDER")]
    pub orientation: Option<String>,
    /// Minimise residuals of poses (thesis, eq. 3.26) instead of targets; planar robots only.
    #[arg(long)]
    pub pose_residuals: bool,
    /// Omit the readings of poses with a reason, which the result repeats: "13, home: ball loose";
    /// may be repeated.
    #[arg(long, value_name = "POSES: REASON")]
    pub exclude: Vec<String>,
    /// Omit data rows, counted from 1, with a reason: "17-19: beam broken"; may be repeated.
    #[arg(long, value_name = "ROWS: REASON")]
    pub exclude_rows: Vec<String>,
    /// Options for reading the table.
    #[command(flatten)]
    #[serde(flatten)]
    pub format: TableFormat,
    /// Identified parameters.
    #[command(flatten)]
    #[serde(flatten)]
    pub model: ModelOptions,
    /// Bound of the uncertainties.
    #[command(flatten)]
    #[serde(flatten)]
    pub bound: BoundOption,
}

/// Identified parameters, and the errors of the readings from which they are identified.
#[derive(Debug)]
pub struct Identified {
    /// `parameters.json`.
    pub document: ParametersDocument,
    /// Errors of each reading, before and after.
    pub errors: Vec<PointError>,
}

/// Identifies the parameters of a robot from a table of observations.
///
/// # Errors
/// Fails for a table that does not belong to the robot or does not determine the parameters.
pub fn identify(inputs: &Inputs, options: &IdentifyOptions) -> anyhow::Result<Identified> {
    options.check()?;
    let mut observed = options.format.read(inputs.table)?;
    let mut messages = options.leave_rows_out(&mut observed)?;
    let observed = observed;
    let here = |problems: Problems| observed.place(problems);
    let targets = kinds::targets(&observed.table, &inputs.robot.branches()).map_err(here)?;
    let mut robot = inputs.robot.build(&targets).map_err(here)?;
    let settings = options.settings();
    let without = RowDefaults {
        length_mm: settings.standard_uncertainty_mm,
        rotation_rad: options.rotation_uncertainty_deg.map(f64::to_radians),
        order: angle_order("--orientation", options.orientation.as_deref())?,
    };
    let exclusions = options.exclusions()?;
    let observations = &Observations::Table(observed.table.clone());
    let input = Input { observations, without, settings, exclusions, place: Box::new(here) };
    let Observed { observations, mut settings } = input.observed(robot.as_mut(), &mut messages)?;
    messages.extend(weigh(&observations, robot.dimension(), &mut settings).map_err(remedied).map_err(here)?);
    messages.extend(stale(robot.as_ref(), &observations));
    let calibration_conditions = settings.conditions.clone();
    let sets = Sets { calibration: observations, calibration_conditions, ..Sets::default() };
    messages.extend(hold_constant(robot.as_ref(), &sets, &mut settings));
    let robot: &dyn Robot = robot.as_ref();
    let solution = Solution::new(robot, Basis { sets, settings, systematic: Systematic::default() });
    // a column that is not read may explain the failure
    let solution = solution.map_err(|problems| Problems(messages.iter().cloned().chain(problems.0).collect()))?;
    let Judgement { plausibility, untested, .. } = Judgement::new(robot, &solution);
    let Solution { basis: Basis { sets, settings, .. }, before, found } = &solution;
    let bound = open_set_up(robot, &sets.calibration, settings, found, options.bound.stated()?);
    let findings = Findings { bound, plausibility, observations: messages, ..Findings::default() };
    let mut document = parameters_document(robot, settings, before, found, &inputs.sha256_by_name()?);
    document.links = inputs.robot.links(robot);
    document.messages = warning_messages(&findings.ordered(&found.warnings));
    document.untested = untested_mistakes(&untested);
    state_positions(&mut document, robot, &sets.calibration, [before, &found.values]);
    let errors = point_errors(robot, sets, before, &found.values);
    Ok(Identified { document, errors })
}

impl IdentifyOptions {
    fn check(&self) -> Result<()> {
        check_uncertainty("--standard-uncertainty-um", self.standard_uncertainty_um)?;
        check_uncertainty("--common-uncertainty-um", self.common_uncertainty_um)?;
        match self.common_uncertainty_um.is_some() && self.standard_uncertainty_um.is_none() {
            true => Err(needs("common_uncertainty_um", "standard_uncertainty_um")),
            false => Ok(()),
        }
    }

    fn settings(&self) -> Settings {
        Settings {
            kind: if self.pose_residuals { ResidualKind::Pose } else { ResidualKind::Targets },
            common_uncertainty_mm: self.common_uncertainty_um.map(|u| u / 1000.0),
            ..self.model.settings(self.standard_uncertainty_um)
        }
    }

    /// Rules of `--exclude`.
    fn exclusions(&self) -> Result<Vec<Exclusion>> {
        let rule = |text: &String| {
            let (poses, reason) = Exclusion::parse_option("--exclude", text)?;
            let rule = Exclude { poses: Some(poses), reason, ..Exclude::default() };
            Ok(Exclusion { rule, place: Place::file("--exclude") })
        };
        self.exclude.iter().map(rule).collect()
    }

    /// Removes the rows of `--exclude-rows` from the table, and reports them with their reasons.
    fn leave_rows_out(&self, observed: &mut TableFile) -> Result<Vec<Message>> {
        let mut left_out = vec![false; observed.table.height()];
        let mut messages = Vec::new();
        for text in &self.exclude_rows {
            let (rows, reason) = Exclusion::parse_option("--exclude-rows", text)?;
            let excluded = excluded_rows(&rows, &reason, 1..=left_out.len() as i64)?;
            excluded.iter().for_each(|row| left_out[*row as usize - 1] = true);
            messages.push(warning!("excluded-rows", count = excluded.len(), rows = rows.to_string(), reason));
        }
        observed.leave_out(&left_out);
        Ok(messages)
    }
}
