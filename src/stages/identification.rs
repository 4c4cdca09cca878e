//! Identification: from observations to parameters, and errors before and after.

use crate::stages::apart::Apart;
use crate::stages::bounds::open_set_up;
use crate::stages::checks::{reliability_summary, robust_message, robust_summary, trends, with_reliability};
use crate::stages::circumstances::hold_constant;
use crate::stages::commanded::commanded;
use crate::stages::controlled::base_elsewhere;
use crate::stages::cross_validation::{proven, undescribed_bending, unused};
use crate::stages::distance::{far_or_near, validation_distance};
use crate::stages::evaluate::{self, ErrorUncertainty, Judged, Sets};
use crate::stages::excitation::{still_joints, travels, unmoved};
use crate::stages::exclusions::{Exclusion, exclude};
use crate::stages::field;
use crate::stages::first_tilt;
use crate::stages::influence::influences;
use crate::stages::join::{Joined, Observations};
use crate::stages::joint_range::{self, Joints};
use crate::stages::kinds::{Observed, RowDefaults};
use crate::stages::plausible::plausibility;
use crate::stages::remedies::{outliers_excluded, remedied};
use crate::stages::repeats::stale;
use crate::stages::shown;
use crate::stages::solved::Solved;
use crate::stages::table_file::{in_campaign, in_files};
use crate::stages::tool::Expected;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Problems, Result, Severity};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, EffectRule, Identify, NamedEffects, OutlierRule, Selection, Selections, StatedPoses};
use etalon_documents::parameters_document;
use etalon_documents::{
    AccuracyDocument, Conformity, EffectProof, FieldDocument, FramePose, FramesDocument, JointTravel, LimitVerdict,
    ParametersDocument, PointError, WorldFrame,
};
use etalon_formats::table;
use etalon_identify::{
    Effects, Fitted, FrameError, Identification, Observation, RobustFit, Settings, Systematic, ToolPoint,
    ToolPrediction, UncertaintyBound,
};
use etalon_robots::Robot;
use std::collections::{BTreeMap, BTreeSet};
use toml::Spanned;

/// Result of the identification of a campaign.
#[derive(Clone, Debug)]
pub struct Identified {
    /// Identified parameters.
    pub parameters: ParametersDocument,
    /// Errors before and after, summarised.
    pub accuracy: AccuracyDocument,
    /// Errors of every observation.
    pub errors: Vec<PointError>,
    /// Observations used.
    pub sets: Sets,
    /// Settings and weights of the identification.
    pub settings: Settings,
    /// Result of the solver.
    pub found: Identification,
    /// Residual field, if one was asked for and proved; the hash of the parameters is known when
    /// they are written.
    pub field: Option<FieldDocument>,
    /// Input for another identification.
    pub again: Again,
}

/// Input for another identification from the same observations.
#[derive(Clone, Debug)]
pub struct Again {
    systematic: Systematic,
    /// Nominal parameters with base and targets fitted.
    pub before: Vec<f64>,
    apart: Apart,
}

impl Identified {
    /// Errors of all observations with other values of the parameters.
    ///
    /// # Errors
    /// Fails if targets cannot be placed.
    pub fn errors_with(&self, robot: &dyn Robot, values: &[f64]) -> Result<Vec<PointError>> {
        let Again { apart, before, .. } = &self.again;
        let mut errors = evaluate::errors(robot, &self.sets, before, values);
        let (mut before, mut values) = (before.clone(), values.to_vec());
        let placed = apart.placed(robot, &mut before, &mut values)?;
        errors.extend(apart.errors(robot, &before, &values, &placed));
        Ok(errors)
    }

    /// Identifies again with these parameters held at their nominal values.
    ///
    /// # Errors
    /// Fails if the solver fails.
    pub fn without(&self, robot: &dyn Robot, held: &[String]) -> Result<Identification> {
        let hold = self.settings.hold.iter().chain(held).cloned().collect();
        let settings = Settings { hold, ..self.settings.clone() };
        let Again { systematic, before, .. } = &self.again;
        etalon_identify::identify_with(robot, &self.sets.calibration, &settings, before, systematic).map_err(remedied)
    }

    /// Fits base and targets again to a robot with these parameters.
    ///
    /// # Errors
    /// Fails if the solver fails.
    pub fn with_frames(&self, robot: &dyn Robot, values: &[f64]) -> Result<Vec<f64>> {
        etalon_identify::refit_frames(robot, &self.sets.calibration, &self.settings, values).map_err(remedied)
    }
}

/// Identifies the robot from the observations of the first log; other logs are compared with it.
/// The parameters state no input files.
pub fn identify(
    campaign: &Campaign,
    stated: &Identify,
    robot: &mut dyn Robot,
    joined: &Joined,
    frames: &FramesDocument,
) -> Result<Identified> {
    let selected = select(campaign, stated, robot, joined, frames)?;
    identify_selected(campaign, stated, robot, joined, selected)
}

/// Like [`identify`], for a chosen set of parameters: these are held at their nominal values, and
/// all others are free, whatever effects the campaign names.
pub fn identify_chosen(
    campaign: &Campaign,
    stated: &Identify,
    robot: &mut dyn Robot,
    (joined, frames): (&Joined, &FramesDocument),
    held: impl Iterator<Item = String>,
) -> Result<Identified> {
    let mut selected = select(campaign, stated, robot, joined, frames)?;
    selected.settings.hold.extend(held);
    selected.settings.effects = Effects::All;
    let stated = Identify { effects: EffectRule::Named(NamedEffects::All), ..stated.clone() };
    identify_selected(campaign, &stated, robot, joined, selected)
}

/// Identifies the robot from selected observations.
fn identify_selected(
    campaign: &Campaign,
    stated: &Identify,
    robot: &dyn Robot,
    joined: &Joined,
    selected: Selected,
) -> Result<Identified> {
    let Selected { mut sets, mut settings, poses, selections, apart, systematic, mut messages } = selected;
    let proofs = proven_effects(robot, stated, &sets, &mut settings)?;
    let mut solved = Solved::new(robot, &sets, &settings, &systematic)?;
    if stated.outliers == OutlierRule::Exclude {
        messages.extend(solved.exclude_outliers(robot, &mut sets, &settings, &systematic)?);
    }
    for (name, log) in joined.observations.iter().skip(1) {
        let observations = log.positions(robot, &mut messages)?;
        let mut theirs = Observed { observations, settings: campaign.settings(stated) };
        exclude(&Exclusion::from_campaign(campaign, stated), robot, &mut theirs)?;
        let others = evaluate::split(&theirs, &poses, &selections);
        let Fitted { values, rms } = Fitted::new(robot, &others.calibration, &settings).map_err(remedied)?;
        let found = &solved.found;
        let first = LogFit {
            name: &campaign.file.logs[0].name,
            sets: &sets,
            values: &found.values,
            rms_mm: found.residuals.rms,
        };
        let other = LogFit { name, sets: &others, values: &values, rms_mm: rms };
        let warnings =
            [compare_logs(robot, &first, &other, first.name), compare_logs(robot, &other, &first, first.name)];
        solved.found.warnings.extend(warnings.into_iter().flatten().map(Into::into));
    }
    if campaign.file.synthetic.is_none() {
        messages.extend(commanded(robot, &solved.before, &sets.calibration));
    }
    let placed = apart.placed(robot, &mut solved.before, &mut solved.found.values)?;
    messages.extend(placed.message(robot, &sets)?);
    let mut errors = solved.judge(robot, &sets, &settings, messages);
    errors.extend(apart.errors(robot, &solved.before, &solved.found.values, &placed));
    solved.check_bound(robot, &sets, &settings, campaign.uncertainty_bound()?);
    let Solved { before, mut found } = solved;
    let all = apart.beside(&sets);
    let set_up = found.set_up_parameters(robot);
    let judged = Judged { robot, values: &found.values, set_up: &set_up, sets: &all, settings: &settings };
    let uncertainty = ErrorUncertainty::new(campaign, judged, &systematic)?;
    let mut accuracy = evaluate::evaluate(robot, &errors, &campaign.file.limits, uncertainty);
    found.warnings.extend(accuracy.limits.iter().filter_map(not_assessable).map(Into::into));
    accuracy.placed_apart = placed.documents(robot);
    // targets that are located by these poses would have too small errors
    let located = Judged { sets: &sets, ..judged };
    accuracy.relative = evaluate::relative(campaign, located, (robot, &before), &systematic)?;
    accuracy.effects = proofs.unwrap_or_else(|| unused(robot, &sets, &settings, &found));
    accuracy.effects.extend(undescribed_bending(&campaign.robot, robot, &sets, &settings, &found));
    found.warnings.extend(accuracy.effects.iter().filter_map(would_prove).map(Into::into));
    found.warnings.extend(base_elsewhere(campaign, robot, &found.values).map(Into::into));
    let ambiguity = first_tilt::ambiguity(&campaign.robot, robot, &sets, &settings, &found);
    found.warnings.extend(ambiguity.map(Into::into));
    accuracy.validation_distance = validation_distance(robot, &all);
    if evaluate::with_times(&mut errors, &joined.observations[0].1.times()?) {
        accuracy.joints.push(table::TIME.to_owned());
    }
    found.warnings.extend(accuracy.validation_distance.as_ref().and_then(far_or_near).map(Into::into));
    let field = if stated.field { field::search(robot, &sets, &settings, (&mut found, &mut accuracy)) } else { None };
    let tool = campaign.file.tool.map(|tool| tool.point());
    let at_tool = |problems: Problems| problems.at(&campaign.key_place(&["tool"]));
    let point = tool.or_else(|| ToolPoint::centre(robot)).unwrap_or(ToolPoint::FIRST_TARGET);
    let held = etalon_identify::held(robot, &sets.calibration, &settings, &found).map_err(remedied)?;
    let prediction = ToolPrediction { robot, point, before: &before, found: &found, held };
    let expected = Expected::new(prediction, &settings, &accuracy).with_field(field.as_ref(), &accuracy);
    if tool.is_some() || robot.platform().is_some() {
        accuracy.tool = expected.accuracy(&all, &accuracy).map_err(at_tool)?;
        accuracy.map = expected.map(&sets).map_err(at_tool)?;
    }
    let robust = etalon_identify::robust_comparison(robot, &sets.calibration, &settings, &found).map_err(remedied)?;
    found.warnings.extend(robust.as_ref().and_then(|robust| robust_message(robot, robust)).map(Into::into));
    let field = field.map(|field| FieldDocument::new(robot, &found.values, &field, String::new()));
    let mut parameters = parameters_document(robot, &settings, &before, &found, &BTreeMap::new());
    state_positions(&mut parameters, robot, &sets.calibration, [&before, &found.values]);
    parameters.valid_until = campaign.file.valid_until();
    parameters.synthetic = campaign.file.synthetic.clone();
    placed.mark(robot, &found, &mut parameters);
    parameters.robust = robust.map(|robust| robust_summary(robot, &robust));
    if let Some(reliability) =
        etalon_identify::reliability(robot, &sets.calibration, &settings, &found).map_err(remedied)?
    {
        with_reliability(robot, &reliability, &mut errors);
        parameters.reliability = reliability_summary(robot, &reliability);
    }
    let base = robot.kinematics().and_then(|k| k.base_in_world(&found.values)).filter(|_| robot.platform().is_none());
    accuracy.parameter_influences = influences(robot, &all, &found.values, &parameters);
    accuracy.trends = trends(&errors, &accuracy.joints, base.map_or([0.0; 3], |base| base.translation_mm));
    let again = Again { systematic, before, apart };
    Ok(Identified { parameters, accuracy, errors, sets, settings, found, field, again })
}

/// States the position residuals with the parameters before and after identification.
pub fn state_positions(
    document: &mut ParametersDocument,
    robot: &dyn Robot,
    observed: &[Observation],
    [before, after]: [&[f64]; 2],
) {
    let residuals = &mut document.residuals;
    if residuals.kind == etalon_documents::ResidualKind::Targets {
        let known = residuals.position_rms_mm;
        residuals.position_rms_mm = known.or_else(|| evaluate::position_rms_mm(robot, observed, after));
        residuals.position_rms_before_mm = evaluate::position_rms_mm(robot, observed, before);
        residuals.within_poses_rms_mm = evaluate::within_poses_rms_mm(robot, observed, after);
    }
}

/// Warning about a limit whose quantity the poses that decide do not show.
fn not_assessable(limit: &LimitVerdict) -> Option<Message> {
    (limit.conformity == Conformity::NotAssessable)
        .then(|| warning!("limit-not-assessable", limit = limit.name.to_string()))
}

/// Sets the effects that the data prove, if the campaign asks for them, and returns the gain of
/// each.
fn proven_effects(
    robot: &dyn Robot,
    stated: &Identify,
    sets: &Sets,
    settings: &mut Settings,
) -> Result<Option<Vec<EffectProof>>> {
    if stated.effects != EffectRule::Named(NamedEffects::Proven) {
        return Ok(None);
    }
    check_set_up(robot, &sets.calibration, settings)?;
    let (chosen, proofs) = proven(robot, sets, settings)?;
    settings.effects = Effects::These(chosen);
    Ok(Some(proofs))
}

/// Returns a remark on an effect that is not identified but significant.
fn would_prove(proof: &EffectProof) -> Option<Message> {
    let EffectProof { joints, without_mm, with_mm, is_identified, robot_key, .. } = proof;
    if *is_identified {
        return None;
    }
    let effect = format!("{:?}", proof.effect).to_lowercase();
    let message = warning!("effect-would-prove", effect, count = joints.len(), joints, without_mm, with_mm);
    Some(match robot_key {
        Some(line) => message.hint(phrase!("add-lines", lines = [format!("`{line}`")])),
        None => message,
    })
}

impl Solved {
    /// Identifies from the calibration observations.
    pub fn new(robot: &dyn Robot, sets: &Sets, settings: &Settings, systematic: &Systematic) -> Result<Self> {
        unmoved(robot, &sets.calibration, settings, None)?;
        let before = etalon_identify::fit_frames(robot, &sets.calibration, settings).map_err(remedied)?;
        unmoved(robot, &sets.calibration, settings, Some(&before))?;
        let found = etalon_identify::identify_with(robot, &sets.calibration, settings, &before, systematic);
        Ok(Self { before, found: found.map_err(remedied)? })
    }

    /// Excludes outliers from the calibration until none is left, and names them.
    fn exclude_outliers(
        &mut self,
        robot: &dyn Robot,
        sets: &mut Sets,
        settings: &Settings,
        systematic: &Systematic,
    ) -> Result<Vec<Message>> {
        let readings: usize = sets.calibration.iter().map(|o| o.targets.iter().flatten().count()).sum();
        let fewest = (readings as f64 * (1.0 - MOST_OUTLIERS)).ceil() as usize;
        let mut messages = Vec::new();
        while let Some(left_out) = leave_outliers_out(robot, &mut sets.calibration, fewest, settings, &self.found)? {
            messages.push(left_out);
            *self = Self::new(robot, sets, settings, systematic)?;
        }
        Ok(messages)
    }

    /// Adds an error if an uncertainty exceeds its bound.
    pub fn check_bound(&mut self, robot: &dyn Robot, sets: &Sets, settings: &Settings, bound: UncertaintyBound) {
        let open = open_set_up(robot, &sets.calibration, settings, &self.found, bound);
        self.found.warnings.splice(0..0, open.map(Into::into));
    }

    /// Returns errors before and after. Warnings that the result is implausible come first, then
    /// those in `said`.
    pub fn judge(
        &mut self,
        robot: &dyn Robot,
        sets: &Sets,
        settings: &Settings,
        said: Vec<Message>,
    ) -> Vec<PointError> {
        let errors = evaluate::errors(robot, sets, &self.before, &self.found.values);
        self.found.warnings.splice(0..0, said.into_iter().map(Into::into));
        let messages = plausibility(robot, &sets.calibration, settings, self, &errors);
        self.found.warnings.splice(0..0, messages.into_iter().map(Into::into));
        errors
    }
}

/// The observations of a campaign in its sets, and their weights.
pub struct Selected {
    /// Observations by set.
    pub sets: Sets,
    /// Settings of an identification on the calibration poses.
    pub settings: Settings,
    /// Readings of targets and fixtures without calibration readings: they are in neither set.
    pub apart: Apart,
    /// Errors common to all readings, or to those of a pose.
    pub systematic: Systematic,
    poses: BTreeSet<PoseName>,
    selections: Selections,
    /// Warnings.
    pub messages: Vec<Message>,
}

/// Selects the observations of the first log by the statements of the campaign; fixed points and
/// surfaces in them become parameters of `robot`.
pub fn select(
    campaign: &Campaign,
    stated: &Identify,
    robot: &mut dyn Robot,
    joined: &Joined,
    frames: &FramesDocument,
) -> Result<Selected> {
    let mut messages = Vec::new();
    let input = Input::new(campaign, stated, &joined.observations[0].1)?;
    let mut observed = input.read(robot, &mut messages)?;
    let measured = observed.poses();
    messages.extend(exclude(&input.exclusions, robot, &mut observed)?);
    let robot: &dyn Robot = robot;
    messages.extend(stale(robot, &observed.observations));
    let poses = observed.poses();
    check_selections(campaign, &poses, &measured)?;
    let selections = campaign.selections(stated)?;
    let mut sets = evaluate::split(&observed, &poses, &selections);
    let series = selections.calibration_series(&poses);
    messages.extend(uncalibrated_series(stated, &series));
    let conditions = sets.calibration_conditions.clone();
    let mut settings = Settings { conditions, series, ..observed.settings };
    let weighted = etalon_identify::weigh(&observed.observations, robot.dimension(), &mut settings);
    messages.extend(weighted.map_err(|error| remedied(error).at(&campaign.key_place(&["identify", "residuals"])))?);
    messages.extend(hold_constant(robot, &sets, &mut settings));
    let apart = Apart::take(robot, &mut sets, &mut settings);
    let systematic = campaign.systematic(robot, frame_errors(&frames.world));
    Ok(Selected { sets, settings, apart, systematic, poses, selections, messages })
}

/// The uncertainties of the world frame: the independent part of each pose, and the common part.
fn frame_errors(world: &WorldFrame) -> Vec<FrameError> {
    let of_pose = |frame: &FramePose| {
        let mut covariance = frame.covariance?;
        for (all, common) in covariance.iter_mut().flatten().zip(world.common_covariance.iter().flatten().flatten()) {
            *all -= common;
        }
        Some(FrameError { pose: frame.pose.zip(frame.cycle), covariance })
    };
    let common = world.common_covariance.map(|covariance| FrameError { pose: None, covariance });
    world.poses.iter().filter_map(of_pose).chain(common).collect()
}

/// Observations, and the statements of a campaign or of options about them.
pub(crate) struct Input<'a> {
    pub observations: &'a Observations,
    pub without: RowDefaults,
    pub settings: Settings,
    pub exclusions: Vec<Exclusion>,
    /// States the places of problems in the observations.
    pub place: Box<dyn Fn(Problems) -> Problems + 'a>,
}

impl<'a> Input<'a> {
    /// Observations of a campaign.
    pub fn new(campaign: &'a Campaign, stated: &Identify, observations: &'a Observations) -> Result<Self> {
        let settings = campaign.settings(stated);
        let without = RowDefaults {
            length_mm: settings.standard_uncertainty_mm,
            rotation_rad: campaign.file.instrument.rotation_uncertainty_rad(),
            // each table states its own
            order: None,
        };
        let place = |problems: Problems| {
            let files: Vec<&str> = campaign.file.observations.iter().map(|o| o.file.get_ref().as_str()).collect();
            if files.is_empty() { in_campaign(problems, &campaign.path) } else { in_files(problems, &files) }
        };
        let exclusions = Exclusion::from_campaign(campaign, stated);
        Ok(Self { observations, without, settings, exclusions, place: Box::new(place) })
    }

    /// Observations and their settings; fixed points and surfaces in the rows of a table become
    /// parameters of `robot`.
    pub fn read(&self, robot: &mut dyn Robot, messages: &mut Vec<Message>) -> Result<Observed> {
        let checked = match self.observations {
            Observations::Table(table) => joint_range::check_table(robot, table, &self.exclusions, Joints::Measured),
            // the join has checked its rows, by their lines in the log
            Observations::Log(_) => Ok(()),
        };
        let read = |()| self.observations.observed(robot, self.without, self.settings.clone(), messages);
        checked.and_then(read).map_err(&self.place)
    }

    /// Observations without the excluded ones, which `messages` name.
    pub fn observed(&self, robot: &mut dyn Robot, messages: &mut Vec<Message>) -> Result<Observed> {
        let mut observed = self.read(robot, messages)?;
        messages.extend(exclude(&self.exclusions, robot, &mut observed)?);
        Ok(observed)
    }
}

/// Signs of a wrong set-up of the first log before an identification: repeated readings, or a
/// nominal robot far from the measurements.
pub fn preview(campaign: &Campaign, robot: &mut dyn Robot, joined: &Joined) -> Result<Preview> {
    let (Some(stated), Some((_, observations))) = (&campaign.file.identify, joined.observations.first()) else {
        return Ok(Preview::default());
    };
    let mut messages = Vec::new();
    let observed = Input::new(campaign, stated, observations)?.observed(robot, &mut messages)?;
    messages.extend(stale(robot, &observed.observations));
    let set_up = check_set_up(robot, &observed.observations, &observed.settings);
    messages.extend(set_up.err().unwrap_or_default().0);
    // selections that do not read are reported with the statements
    let Ok(selections) = campaign.selections(stated) else { return Ok(Preview { messages, ..Preview::default() }) };
    let poses = observed.poses();
    messages.extend(uncalibrated_series(stated, &selections.calibration_series(&poses)));
    let sets = evaluate::split(&observed, &poses, &selections);
    let mut settings = Settings { conditions: sets.calibration_conditions.clone(), ..observed.settings };
    messages.extend(hold_constant(robot, &sets, &mut settings));
    if messages.iter().all(|message| message.severity != Severity::Error) {
        messages.extend(unmoved(robot, &sets.calibration, &settings, None).err().unwrap_or_default().0);
        messages.extend(still_joints(robot, &sets.calibration, &settings));
    }
    let joints = travels(robot, &sets.calibration, &settings);
    Ok(Preview { messages, joints })
}

/// Findings of a check of observations.
#[derive(Default)]
pub struct Preview {
    /// Errors and warnings.
    pub messages: Vec<Message>,
    /// Ranges of the joints in the calibration poses.
    pub joints: Vec<JointTravel>,
}

/// Returns an error if the nominal robot is far from the measurements.
pub(super) fn check_set_up(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<()> {
    let problem = || etalon_identify::set_up_problem(robot, observations, settings.coordinate_uncertainty_mm());
    let problem = if observations.is_empty() { None } else { problem() };
    problem.map_or(Ok(()), |problem| Err(etalon_documents::warning_message(&problem).into()))
}

/// Maximum share of readings excluded as outliers: beyond it the model or the set-up is wrong.
const MOST_OUTLIERS: f64 = 0.1;

/// Excludes the outliers of a robust fit from `observations`, of which at least `fewest` readings
/// must remain, and names them; `None` without outliers.
fn leave_outliers_out(
    robot: &dyn Robot,
    observations: &mut Vec<Observation>,
    fewest: usize,
    settings: &Settings,
    found: &Identification,
) -> Result<Option<Message>> {
    let Some(robust) = RobustFit::new(robot, observations, settings, found) else { return Ok(None) };
    let outliers = robust.outliers();
    if outliers.is_empty() {
        return Ok(None);
    }
    if robust.readings.len() - outliers.len() < fewest {
        return Err(error!("outliers-too-many", share_percent = 100.0 * MOST_OUTLIERS).into());
    }
    for outlier in outliers {
        observations[outlier.observation].targets[outlier.target] = None;
    }
    observations.retain(|o| o.targets.iter().any(Option::is_some));
    Ok(Some(outliers_excluded(&robust, robot)))
}

/// A log, its observations, and the parameters that they give.
struct LogFit<'a> {
    name: &'a str,
    sets: &'a Sets,
    values: &'a [f64],
    /// Root mean square of the residuals (mm).
    rms_mm: f64,
}

/// Returns a warning if the residuals with one log correlate with its difference from another log;
/// `used` is the campaign's choice.
fn compare_logs(robot: &dyn Robot, this: &LogFit, that: &LogFit, used: &str) -> Option<Message> {
    let compared = etalon_identify::compare_logs(robot, this.values, &this.sets.calibration, &that.sets.calibration)?;
    if compared.correlation <= 0.3 {
        return None;
    }
    let of_position = (robot.dimension() as f64).sqrt();
    let message = |log: &LogFit, hint| {
        warning!(
            "log-correlates",
            log = this.name,
            correlation = compared.correlation,
            rms_mm = of_position * this.rms_mm,
            other = that.name,
            other_rms_mm = of_position * that.rms_mm
        )
        .hint(phrase!("use-log", log = log.name, hint))
    };
    Some(match this.name == used {
        true => message(that, "name-first").to_decide(),
        false => message(that, "is-used").routine(),
    })
}

/// Errors of selections and tables without a measured pose, and of overlapping sets; `all` are
/// the poses before exclusion, which series may name.
pub fn check_selections(campaign: &Campaign, poses: &BTreeSet<PoseName>, all: &BTreeSet<PoseName>) -> Result<()> {
    let Some(identify) = &campaign.file.identify else { return Ok(()) };
    // what does not read is reported with the statements
    let Ok(selections) = campaign.selections(identify) else { return Ok(()) };
    let mut problems = Problems::default();
    let stated = std::iter::once((&identify.calibration, &selections.calibration));
    let stated = stated.chain(identify.validation.iter().zip(&selections.validation));
    for (text, selection) in stated.chain(identify.series.iter().zip(&selections.series)) {
        if let Some(name) = selection.mistaken(poses) {
            let message = error!("selected-pose-unmeasured", pose = name).at(campaign.place(text));
            let names: Vec<String> = poses.iter().map(PoseName::to_string).collect();
            problems.0.push(message.hint_names(&name.to_string(), names.iter().map(String::as_str)));
        }
    }
    let numbered = || poses.iter().copied().enumerate();
    let without_pose = |poses_stated: &Spanned<StatedPoses>, set: &str| {
        let hint = measured(poses);
        error!("selection-without-pose", set).at(campaign.place(poses_stated)).hint(hint)
    };
    if !numbered().any(|(i, pose)| selections.calibrates(pose, i)) {
        problems.0.push(without_pose(&identify.calibration, "calibration"));
    }
    if let Some(text) = &identify.validation {
        if !numbered().any(|(i, pose)| selections.validates(pose, i)) {
            problems.0.push(without_pose(text, "validation"));
        }
        let shared: Vec<String> = numbered()
            .filter(|&(i, pose)| selections.calibrates(pose, i) && selections.validates(pose, i))
            .map(|(_, pose)| pose.to_string())
            .collect();
        if !shared.is_empty() {
            problems.0.push(error!("sets-overlap", poses = shown(shared, 20)).at(campaign.place(text)));
        }
    }
    problems.0.extend(series_problems(campaign, identify, &selections, all));
    let in_use = |&(i, pose): &(usize, PoseName)| selections.calibrates(pose, i) || selections.validates(pose, i);
    let used: Vec<PoseName> = numbered().filter(in_use).map(|(_, pose)| pose).collect();
    for table in campaign.file.geometric.iter().flat_map(|g| &g.table) {
        let found = match Selection::parse(table.poses.get_ref()) {
            Ok(selection) if used.iter().enumerate().any(|(i, &pose)| selection.contains(pose, i, false)) => continue,
            Ok(_) => error!("table-selection-empty", title = table.title),
            Err(message) => message,
        };
        problems.0.push(found.at(campaign.place(&table.poses)));
    }
    problems.check().map(|_| ())
}

/// Warning about series without a calibration pose.
fn uncalibrated_series(stated: &Identify, series: &[Vec<PoseName>]) -> Option<Message> {
    let named = stated.series.iter().zip(series).filter(|(_, poses)| poses.is_empty());
    let series: Vec<String> = named.map(|(text, _)| format!("`{}`", text.get_ref())).collect();
    (!series.is_empty()).then(|| warning!("series-without-calibration", series))
}

/// Errors of series without a measured pose, of poses in several series or in none, and of a single
/// series.
fn series_problems(
    campaign: &Campaign,
    identify: &Identify,
    selections: &Selections,
    poses: &BTreeSet<PoseName>,
) -> Vec<Message> {
    let of: Vec<(PoseName, Vec<usize>)> =
        poses.iter().enumerate().map(|(i, &pose)| (pose, selections.series(pose, i))).collect();
    let mut problems = Vec::new();
    for (number, text) in identify.series.iter().enumerate() {
        let shared = of.iter().filter(|(_, of)| of.contains(&number) && of.iter().any(|other| *other < number));
        let shared: Vec<String> = shared.map(|(pose, _)| pose.to_string()).collect();
        let problem = if !of.iter().any(|(_, of)| of.contains(&number)) {
            let hint = measured(poses);
            error!("selection-without-pose", set = "series").hint(hint)
        } else if !shared.is_empty() {
            error!("series-overlap", poses = shown(shared, 20))
        } else {
            continue;
        };
        problems.push(problem.at(campaign.place(text)));
    }
    let Some(first) = identify.series.first().filter(|_| problems.is_empty()) else { return problems };
    let forgotten = of.iter().enumerate().filter(|(i, (pose, of))| of.is_empty() && selections.calibrates(*pose, *i));
    let forgotten: Vec<String> = forgotten.map(|(_, (pose, _))| pose.to_string()).collect();
    let calibrating = selections.calibration_series(poses).iter().filter(|poses| !poses.is_empty()).count();
    let problem = if !forgotten.is_empty() {
        error!("series-incomplete", poses = shown(forgotten, 20))
    } else if calibrating < 2 {
        error!("series-single")
    } else {
        return problems;
    };
    vec![problem.at(campaign.place(first))]
}

/// Poses available for selection.
fn measured(poses: &BTreeSet<PoseName>) -> Phrase {
    match (poses.first(), poses.last()) {
        (Some(first), Some(last)) => phrase!("poses-measured", count = poses.len(), first, last),
        _ => phrase!("poses-unmeasured"),
    }
}
