//! Command `etalon identify`.

use super::bound::BoundOption;
use super::inputs::Inputs;
use super::table_file::TableFile;
use super::text_format::TableFormat;
use super::{Verdict, answer, remark};
use crate::stages::calibrate::evaluation::Judgement;
use crate::stages::calibrate::findings::Findings;
use crate::stages::calibrate::identification::state_positions;
use crate::stages::calibrate::selection::Input;
use crate::stages::calibrate::solution::{Basis, Solution};
use crate::stages::evaluate::sets::Sets;
use crate::stages::join::Observations;
use crate::stages::judge::circumstances::hold_constant;
use crate::stages::kinds::{self, Observed, RowDefaults};
use crate::stages::observe::exclusions::{Exclusion, excluded_rows};
use crate::stages::observe::repeats::stale;
use crate::stages::remedies::remedied;
use crate::stages::uncertainty::bounds::open_set_up;
use etalon_base::files;
use etalon_base::message::{Message, Place, Problems};
use etalon_base::{error, warning};
use etalon_campaign::{Exclude, PLAUSIBLE_EXPANDED_UM, RobotFile, read_robot};
use etalon_documents::to_json;
use etalon_documents::{Effect, ParametersDocument, parameters_document, warning_messages};
use etalon_formats::table::{ASSEMBLY, COVARIANCES, TIME, UNCERTAINTIES};
use etalon_formats::tables::joints::stated_columns;
use etalon_identify::{Effects, Prior, ResidualKind, Settings, Systematic, weigh};
use etalon_report::Renderer;
use etalon_robots::Robot;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Identify the parameters of a robot from a table of observations, without a campaign.
#[derive(Debug, clap::Args)]
pub struct IdentifyCommand {
    /// Robot file.
    #[arg(long)]
    robot: PathBuf,
    /// Observations: CSV with pose,cycle,target,x_mm,y_mm[,z_mm] and one column per joint with its
    /// unit. The column `kind` adds poses, distances, contacts, surfaces and joint values
    /// (docs/observations.md).
    #[arg(long)]
    observations: PathBuf,
    #[command(flatten)]
    uncertainty: UncertaintyOptions,
    /// Order of the angles `a_deg`, `b_deg`, `c_deg` of an orientation: "zyx" (successively about
    /// the axes of the body), "fixed xyz" ...
    #[arg(long, value_name = "ORDER")]
    orientation: Option<String>,
    /// Minimise residuals of poses (thesis, eq. 3.26) instead of targets; planar robots only.
    #[arg(long)]
    pose_residuals: bool,
    /// Omit the readings of poses with a reason, which the result repeats: "13, home: ball loose";
    /// may be repeated.
    #[arg(long, value_name = "POSES: REASON")]
    exclude: Vec<String>,
    /// Omit data rows, counted from 1, with a reason: "17-19: beam broken"; may be repeated.
    #[arg(long, value_name = "ROWS: REASON")]
    exclude_rows: Vec<String>,
    #[command(flatten)]
    format: TableFormat,
    #[command(flatten)]
    model: ModelOptions,
    #[command(flatten)]
    bound: BoundOption,
    /// Print parameters.json instead of a table.
    #[arg(long)]
    json: bool,
}

/// Options of the identified parameters.
#[derive(Clone, Debug, clap::Args)]
struct ModelOptions {
    /// Hold a parameter at its nominal value; `*` stands for any text; may be repeated.
    #[arg(long, value_name = "NAME")]
    hold: Vec<String>,
    /// Use of nominal values: as observations with their tolerances, or as starting values of plain
    /// least squares.
    #[arg(long, value_enum, default_value_t)]
    prior: PriorOption,
    /// Effects to identify: `all`, or a list of zeros, geometry, gains, harmonics, backlash,
    /// coupling, bending, payload, torque, expansion, drift, lateral, pedestal; by default all
    /// effects in the robot file except gains of revolute joints of arms and payload to
    /// pedestal.
    #[arg(long, value_parser = effects, value_name = "EFFECTS", default_value = "usual")]
    effects: Effects,
}

/// Stated uncertainties of the measurements.
#[derive(Clone, Debug, clap::Args)]
struct UncertaintyOptions {
    /// Standard uncertainty (k = 1) of a measured coordinate in micrometres; by default estimated
    /// from the residuals.
    #[arg(long, value_name = "UM")]
    standard_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) in micrometres common to all rows with equal coordinates: a
    /// ball that is measured once and touched in several working modes. The other uncertainty is
    /// then that of the contact.
    #[arg(long, value_name = "UM", requires = "standard_uncertainty_um")]
    common_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) of a measured orientation about any axis in degrees, if the
    /// table has no `urot_deg`.
    #[arg(long, value_name = "DEG")]
    rotation_uncertainty_deg: Option<f64>,
}

impl IdentifyCommand {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        self.check()?;
        let robot_file = read_robot(&self.robot)?;
        let observed = self.format.read(&self.observations)?;
        let inputs =
            files::sha256_by_name([&self.robot, &self.observations].into_iter().chain(robot_file.description_path()))?;
        let document = self.identified(&robot_file, observed, &inputs)?;
        if !self.json {
            remark(&document.messages);
        }
        answer(&Renderer::identification(&document), self.json.then(|| to_json(&document)).transpose()?)
    }

    /// The answer from a table in memory.
    pub(super) fn in_memory(&self, given: &Inputs) -> anyhow::Result<ParametersDocument> {
        self.check()?;
        let observed = self.format.parse(given.table.name, given.table.text)?;
        self.identified(given.robot, observed, &given.inputs())
    }

    fn check(&self) -> Result<(), Problems> {
        check_uncertainty("--standard-uncertainty-um", self.uncertainty.standard_uncertainty_um)?;
        check_uncertainty("--common-uncertainty-um", self.uncertainty.common_uncertainty_um)
    }

    fn identified(
        &self,
        robot_file: &RobotFile,
        mut observed: TableFile,
        inputs: &BTreeMap<String, String>,
    ) -> anyhow::Result<ParametersDocument> {
        let mut messages = self.leave_rows_out(&mut observed)?;
        let observed = observed;
        let here = |problems: Problems| observed.place(problems);
        let targets = kinds::targets(&observed.table, &robot_file.branches()).map_err(here)?;
        let mut robot = robot_file.build(&targets).map_err(here)?;
        messages.extend(unread(robot.as_ref(), &observed));
        let settings = Settings {
            kind: if self.pose_residuals { ResidualKind::Pose } else { ResidualKind::Targets },
            standard_uncertainty_mm: self.uncertainty.standard_uncertainty_um.map(|u| u / 1000.0),
            common_uncertainty_mm: self.uncertainty.common_uncertainty_um.map(|u| u / 1000.0),
            hold: self.model.hold.clone(),
            prior: self.model.prior.into(),
            effects: self.model.effects.clone(),
            ..Settings::default()
        };
        let order = self.orientation.as_deref().map(str::parse).transpose();
        let without = RowDefaults {
            length_mm: settings.standard_uncertainty_mm,
            rotation_rad: self.uncertainty.rotation_uncertainty_deg.map(f64::to_radians),
            order: order.map_err(|m: Message| Problems::from(m.at(Place::file("--orientation"))))?,
        };
        let exclusions = self.exclusions()?;
        let observations = &Observations::Table(observed.table.clone());
        let input = Input { observations, without, settings, exclusions, place: Box::new(here) };
        let Observed { observations, mut settings } = input.observed(robot.as_mut(), &mut messages)?;
        messages.extend(weigh(&observations, robot.dimension(), &mut settings).map_err(remedied).map_err(here)?);
        messages.extend(stale(robot.as_ref(), &observations));
        let calibration_conditions = settings.conditions.clone();
        let sets = Sets { calibration: observations, calibration_conditions, ..Sets::default() };
        messages.extend(hold_constant(robot.as_ref(), &sets, &mut settings));
        let robot: &dyn Robot = robot.as_ref();
        let solution = Solution::new(robot, Basis { sets, settings, systematic: Systematic::default() })?;
        let Judgement { plausibility, .. } = Judgement::new(robot, &solution);
        let Solution { basis: Basis { sets, settings, .. }, before, found } = &solution;
        let bound = open_set_up(robot, &sets.calibration, settings, found, self.bound.stated()?);
        let findings = Findings { bound, plausibility, observations: messages, ..Findings::default() };
        let mut document = parameters_document(robot, settings, before, found, inputs);
        document.messages = warning_messages(&findings.ordered(&found.warnings));
        state_positions(&mut document, robot, &sets.calibration, [before, &found.values]);
        Ok(document)
    }

    /// Rules of `--exclude`.
    fn exclusions(&self) -> Result<Vec<Exclusion>, Problems> {
        let rule = |text: &String| {
            let (poses, reason) = Exclusion::parse_option("--exclude", text)?;
            let rule = Exclude { poses: Some(poses), reason, ..Exclude::default() };
            Ok(Exclusion { rule, place: Place::file("--exclude") })
        };
        self.exclude.iter().map(rule).collect()
    }

    /// Removes the rows of `--exclude-rows` from the table, and reports them with their reasons.
    fn leave_rows_out(&self, observed: &mut TableFile) -> Result<Vec<Message>, Problems> {
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

/// Parses the effects of an option.
pub(super) fn effects(text: &str) -> Result<Effects, String> {
    let one = |name: &str| <Effect as clap::ValueEnum>::from_str(name.trim(), false);
    match text {
        "usual" => Ok(Effects::Usual),
        "all" => Ok(Effects::All),
        list => Ok(Effects::These(list.split(',').map(|name| Ok(one(name)?.into())).collect::<Result<_, String>>()?)),
    }
}

/// Use of nominal values.
#[derive(Clone, Copy, Debug, Default, clap::ValueEnum)]
pub(super) enum PriorOption {
    /// Observations with the standard uncertainty t/√3 of their tolerance t.
    #[default]
    Tolerances,
    /// Starting values only.
    None,
}

impl From<PriorOption> for Prior {
    fn from(option: PriorOption) -> Self {
        match option {
            PriorOption::Tolerances => Self::TOLERANCES,
            PriorOption::None => Self::None,
        }
    }
}

/// Rejects values that cannot be the standard uncertainty of a coordinate in micrometres.
pub(super) fn check_uncertainty(option: &str, stated_um: Option<f64>) -> Result<(), Problems> {
    if stated_um.is_none_or(|u| PLAUSIBLE_EXPANDED_UM.contains(&(2.0 * u))) {
        return Ok(());
    }
    Err(error!("uncertainty-implausible", option).into())
}

/// Warning about unused columns.
pub(super) fn unread(robot: &dyn Robot, observed: &TableFile) -> Option<Message> {
    let stated = stated_columns(robot);
    let joints = observed.table.names().filter(|name| {
        robot.joints().iter().any(|joint| joint.factor(name).is_some() || *name == joint.direction_column())
    });
    let known = ["pose", "cycle", "target", ASSEMBLY, TIME]
        .into_iter()
        .chain(UNCERTAINTIES)
        .chain(COVARIANCES)
        .chain(kinds::columns());
    let known = known.chain(stated.iter().map(String::as_str));
    observed.table.unread(&known.chain(joints).collect::<Vec<_>>())
}
