//! Identify: observations become parameters, and errors before and after.

use crate::stages::checks::{reliability_summary, robust_message, robust_summary, trends, with_reliability};
use crate::stages::commanded::commanded;
use crate::stages::distance::{far_or_near, validation_distance};
use crate::stages::evaluate::{self, ErrorUncertainty, Sets};
use crate::stages::exclusions::{Exclusion, exclude};
use crate::stages::join::{Joined, Observations};
use crate::stages::joint_range::{self, Joints};
use crate::stages::kinds::{Observed, RowDefaults};
use crate::stages::plausible::plausibility;
use crate::stages::remedies::{readings_to_check, remedied};
use crate::stages::repeats::stale;
use crate::stages::table_file::{in_campaign, in_files};
use crate::stages::tool::Expected;
use etalon_base::message::{Message, Problems, Result, count};
use etalon_base::pose_name::PoseName;
use etalon_campaign::{Campaign, Identify, OutlierRule, Selection, Selections};
use etalon_documents::parameters_document;
use etalon_documents::{AccuracyDocument, FramePose, FramesDocument, ParametersDocument, PointError, WorldFrame};
use etalon_formats::table;
use etalon_identify::{Condition, FrameError, Identification, Kind, Observation, RobustFit, Settings, Systematic};
use etalon_robots::Robot;
use std::collections::{BTreeMap, BTreeSet};
use toml::Spanned;

/// What a campaign identifies.
#[derive(Clone, Debug)]
pub struct Identified {
    /// Identified parameters.
    pub parameters: ParametersDocument,
    /// Errors before and after, summarised.
    pub accuracy: AccuracyDocument,
    /// Errors of every observation.
    pub errors: Vec<PointError>,
    /// The observations that were used.
    pub sets: Sets,
    /// What they were weighed with.
    pub settings: Settings,
    /// What the solver found.
    pub found: Identification,
    /// What it takes to identify again.
    pub again: Again,
}

/// What it takes to identify the same observations again.
#[derive(Clone, Debug)]
pub struct Again {
    systematic: Systematic,
    /// Nominal parameters with base and targets fitted.
    pub before: Vec<f64>,
}

impl Identified {
    /// Identifies again with these parameters held at their nominal values.
    ///
    /// # Errors
    /// If the solver fails.
    pub fn without(&self, robot: &dyn Robot, held: &[String]) -> Result<Identification> {
        let hold = self.settings.hold.iter().chain(held).cloned().collect();
        let settings = Settings { hold, ..self.settings.clone() };
        let Again { systematic, before } = &self.again;
        etalon_identify::identify_with(robot, &self.sets.calibration, &settings, before, systematic).map_err(remedied)
    }

    /// Fits base and targets again to a robot with these parameters.
    ///
    /// # Errors
    /// If the solver fails.
    pub fn with_frames(&self, robot: &dyn Robot, values: &[f64]) -> Result<Vec<f64>> {
        etalon_identify::refit_frames(robot, &self.sets.calibration, &self.settings, values).map_err(remedied)
    }
}

/// Identifies the robot from the observations of the first log; other logs are compared with it. `inputs` are the files and
/// their SHA-256.
pub fn identify(
    campaign: &Campaign,
    stated: &Identify,
    robot: &mut dyn Robot,
    joined: &Joined,
    frames: &FramesDocument,
    inputs: &BTreeMap<String, String>,
) -> Result<Identified> {
    let selected = select(campaign, stated, robot, joined)?.leave_unplaced_out(robot)?;
    let robot: &dyn Robot = robot;
    let Selected { mut sets, settings, poses, selections, mut messages } = selected;
    let systematic = campaign.systematic(robot, frame_errors(&frames.world));
    let mut solved = Solved::new(robot, &sets, &settings, &systematic)?;
    if stated.outliers == OutlierRule::Exclude {
        let readings: usize = sets.calibration.iter().map(|o| o.targets.iter().flatten().count()).sum();
        let fewest = (readings as f64 * (1.0 - MOST_OUTLIERS)).ceil() as usize;
        while let Some(left_out) = leave_outliers_out(robot, &mut sets.calibration, fewest, &settings, &solved.found)? {
            messages.push(left_out);
            solved = Solved::new(robot, &sets, &settings, &systematic)?;
        }
    }
    for (name, log) in joined.observations.iter().skip(1) {
        let observations = log.positions(robot, &mut messages)?;
        let mut theirs = Observed { observations, settings: campaign.settings(stated) };
        exclude(&Exclusion::of_campaign(campaign, stated), robot, &mut theirs)?;
        let others = evaluate::split(&theirs, &poses, &selections);
        let theirs = etalon_identify::identify(robot, &others.calibration, &settings).map_err(remedied)?;
        let first = LogFit { name: &campaign.file.logs[0].name, sets: &sets, found: &solved.found };
        let other = LogFit { name, sets: &others, found: &theirs };
        let warnings =
            [compare_logs(robot, &first, &other, first.name), compare_logs(robot, &other, &first, first.name)];
        solved.found.warnings.extend(warnings.into_iter().flatten().map(Into::into));
    }
    if campaign.file.synthetic.is_none() {
        messages.extend(commanded(robot, &solved.before, &sets.calibration));
    }
    let mut errors = solved.judge(robot, &sets, &settings, messages);
    let Solved { before, mut found } = solved;
    let uncertainty = ErrorUncertainty::of(campaign, robot, &sets, &settings);
    let mut accuracy = evaluate::evaluate(robot, &errors, &campaign.file.limits, uncertainty)?;
    accuracy.validation_distance = validation_distance(robot, &sets);
    if evaluate::with_times(&mut errors, &joined.observations[0].1.times()?) {
        accuracy.joints.push(table::TIME.to_owned());
    }
    found.warnings.extend(accuracy.validation_distance.as_ref().and_then(far_or_near).map(Into::into));
    if sets.validation_conditions.is_empty() {
        let budgets = etalon_identify::figure_budgets(robot, &sets.validation, &settings, &found, &systematic)
            .map_err(remedied)?;
        accuracy.budget = evaluate::budgets(budgets.unwrap_or_default());
    }
    let tool = campaign.file.tool.map(|tool| tool.point());
    let at_tool = |problems: Problems| problems.at(&campaign.place_of(&["tool"]));
    let expected = Expected::new(robot, tool, &sets, &settings, &before, &found, &accuracy)?;
    if tool.is_some() || robot.platform().is_some() {
        accuracy.tool = expected.accuracy(&sets, &accuracy).map_err(at_tool)?;
        accuracy.map = expected.map(&sets).map_err(at_tool)?;
    }
    let robust = etalon_identify::robust_comparison(robot, &sets.calibration, &settings, &found).map_err(remedied)?;
    found.warnings.extend(robust.as_ref().and_then(|robust| robust_message(robot, robust)).map(Into::into));
    let mut parameters = parameters_document(robot, &settings, &before, &found, inputs);
    parameters.robust = robust.map(|robust| robust_summary(robot, &robust));
    if let Some(reliability) =
        etalon_identify::reliability(robot, &sets.calibration, &settings, &found).map_err(remedied)?
    {
        with_reliability(robot, &reliability, &mut errors);
        parameters.reliability = reliability_summary(robot, &reliability);
    }
    let base = robot.kinematics().and_then(|k| k.base_in_world(&found.values)).filter(|_| robot.platform().is_none());
    accuracy.trends = trends(&errors, &accuracy.joints, base.map_or([0.0; 3], |base| base.translation_mm));
    let again = Again { systematic, before };
    Ok(Identified { parameters, accuracy, errors, sets, settings, found, again })
}

/// Parameters of the nominal robot with base and targets fitted, and what the solver finds from there.
pub struct Solved {
    /// All parameters before.
    pub before: Vec<f64>,
    /// Those after.
    pub found: Identification,
}

impl Solved {
    /// Identifies from the calibration observations.
    pub fn new(robot: &dyn Robot, sets: &Sets, settings: &Settings, systematic: &Systematic) -> Result<Self> {
        let before = etalon_identify::fit_frames(robot, &sets.calibration, settings).map_err(remedied)?;
        let found = etalon_identify::identify_with(robot, &sets.calibration, settings, &before, systematic);
        Ok(Self { before, found: found.map_err(remedied)? })
    }

    /// Errors before and after. What shows that the result can be no robot comes first among its warnings, then what is `said`.
    pub fn judge(
        &mut self,
        robot: &dyn Robot,
        sets: &Sets,
        settings: &Settings,
        said: Vec<Message>,
    ) -> Vec<PointError> {
        let Self { before, found } = self;
        let errors = evaluate::errors(robot, sets, before, &found.values);
        found.warnings.splice(0..0, said.into_iter().map(Into::into));
        let messages = plausibility(robot, &sets.calibration, settings, before, found, &errors);
        found.warnings.splice(0..0, messages.into_iter().map(Into::into));
        errors
    }
}

/// The observations of a campaign in its sets, and what weighs them.
pub struct Selected {
    /// Observations by set.
    pub sets: Sets,
    /// Settings of an identification on the calibration poses.
    pub settings: Settings,
    poses: BTreeSet<PoseName>,
    selections: Selections,
    /// Warnings.
    pub messages: Vec<Message>,
}

/// Targets that a message names.
const NAMED: usize = 5;

impl Selected {
    /// Leaves targets that are measured at validation poses alone out of the validation, and holds their places: no calibration
    /// reading places them, so that an error of theirs says nothing of the robot.
    ///
    /// # Errors
    /// If nothing else is measured at the validation poses.
    pub fn leave_unplaced_out(mut self, robot: &dyn Robot) -> Result<Self> {
        let Some(arm) = robot.free_base() else { return Ok(self) };
        let Self { sets, settings, messages, .. } = &mut self;
        let mut placed = vec![false; robot.targets().len()];
        let measured =
            |o: &Observation| -> Vec<usize> { (0..o.targets.len()).filter(|&k| o.targets[k].is_some()).collect() };
        let places = |c: &&Condition| !c.kind.is_orientation() && !matches!(c.kind, Kind::Joint { .. });
        sets.calibration.iter().flat_map(measured).for_each(|k| placed[k] = true);
        sets.calibration_conditions.iter().filter(places).for_each(|c| placed[c.target] = true);
        let of_conditions = sets.validation_conditions.iter().filter(places).map(|c| c.target);
        let seen = sets.validation.iter().flat_map(measured).chain(of_conditions);
        let unplaced: BTreeSet<usize> = seen.filter(|&k| !placed[k]).collect();
        if unplaced.is_empty() {
            return Ok(self);
        }
        for o in &mut sets.validation {
            o.targets.iter_mut().zip(&placed).filter(|(_, placed)| !**placed).for_each(|(target, _)| *target = None);
        }
        sets.validation.retain(|o| o.targets.iter().any(Option::is_some));
        sets.validation_conditions.retain(|c| placed[c.target] || matches!(c.kind, Kind::Joint { .. }));
        let names: Vec<String> = unplaced.iter().take(NAMED).map(|&k| format!("`{}`", robot.targets()[k])).collect();
        let more = if unplaced.len() > NAMED { ", ..." } else { "" };
        let what = format!(
            "{} measured at validation poses alone: {}{more}; no calibration pose places them, and they are not judged",
            count(unplaced.len(), "target"),
            names.join(", ")
        );
        let hint = "measure them at calibration poses too, or move a pose where they are measured to `calibration`";
        if sets.validation.is_empty() && sets.validation_conditions.is_empty() {
            return Err(Message::error(format!("{what}: nothing is left to validate with")).hint(hint).into());
        }
        messages.push(Message::warning(what).to_decide().hint(hint));
        let of_place = |k: usize| (0..3).map(move |axis| arm.target_place(k) + axis);
        settings.hold.extend(unplaced.into_iter().flat_map(of_place).map(|i| robot.parameters()[i].name.clone()));
        Ok(self)
    }
}

/// What a campaign selects of the observations of its first log; what they refer to is added to the parameters of `robot`.
pub fn select(campaign: &Campaign, stated: &Identify, robot: &mut dyn Robot, joined: &Joined) -> Result<Selected> {
    let mut messages = Vec::new();
    let observed = Input::of(campaign, stated, &joined.observations[0].1)?.observed(robot, &mut messages)?;
    let robot: &dyn Robot = robot;
    messages.extend(stale(robot, &observed.observations));
    let poses = observed.poses();
    check_selections(campaign, &poses)?;
    let selections = campaign.selections(stated)?;
    let sets = evaluate::split(&observed, &poses, &selections);
    let mut settings = Settings { conditions: sets.calibration_conditions.clone(), ..observed.settings };
    let weighted = etalon_identify::weigh(&observed.observations, robot.dimension(), &mut settings);
    messages.extend(weighted.map_err(|error| remedied(error).at(&campaign.place_of(&["identify", "residuals"])))?);
    Ok(Selected { sets, settings, poses, selections, messages })
}

/// The uncertainties of the world frame: what each pose has by itself, and what all have in common.
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

/// Observations, and what a campaign or options state of them.
pub(crate) struct Input<'a> {
    pub observations: &'a Observations,
    pub without: RowDefaults,
    pub settings: Settings,
    pub exclusions: Vec<Exclusion>,
    /// States where problems of the observations are.
    pub place: Box<dyn Fn(Problems) -> Problems + 'a>,
}

impl<'a> Input<'a> {
    /// Observations of a campaign.
    pub fn of(campaign: &'a Campaign, stated: &Identify, observations: &'a Observations) -> Result<Self> {
        let settings = campaign.settings(stated);
        let orientation = campaign.file.observations.iter().find_map(|o| o.orientation.as_ref());
        let order = |text: &Spanned<String>| text.get_ref().parse().map_err(|m: Message| m.at(campaign.place(text)));
        let without = RowDefaults {
            length_mm: settings.standard_uncertainty_mm,
            rotation_rad: campaign.file.instrument.rotation_uncertainty_rad(),
            order: orientation.map(order).transpose()?,
        };
        let place = |problems: Problems| {
            let files: Vec<&str> = campaign.file.observations.iter().map(|o| o.file.get_ref().as_str()).collect();
            if files.is_empty() { in_campaign(problems, &campaign.path) } else { in_files(problems, &files) }
        };
        let exclusions = Exclusion::of_campaign(campaign, stated);
        Ok(Self { observations, without, settings, exclusions, place: Box::new(place) })
    }

    /// What was observed, and what is identified from it: what the rows of a table refer to is added to the parameters of `robot`.
    pub fn read(&self, robot: &mut dyn Robot, messages: &mut Vec<Message>) -> Result<Observed> {
        let checked = match self.observations {
            Observations::Table(table) => joint_range::check_table(robot, table, &self.exclusions, Joints::Measured),
            // the join has checked its rows, by their lines in the log
            Observations::Log(_) => Ok(()),
        };
        let read = |()| self.observations.observed(robot, self.without, self.settings.clone(), messages);
        checked.and_then(read).map_err(&self.place)
    }

    /// The same without what is excluded, which `messages` name.
    pub fn observed(&self, robot: &mut dyn Robot, messages: &mut Vec<Message>) -> Result<Observed> {
        let mut observed = self.read(robot, messages)?;
        messages.extend(exclude(&self.exclusions, robot, &mut observed)?);
        Ok(observed)
    }
}

/// What shows before an identification that the set-up of the first log is wrong: readings that repeat, a nominal robot that is
/// nowhere near the measurements.
pub fn preview(campaign: &Campaign, robot: &mut dyn Robot, joined: &Joined) -> Result<Vec<Message>> {
    let (Some(stated), Some((_, observations))) = (&campaign.file.identify, joined.observations.first()) else {
        return Ok(Vec::new());
    };
    let observed = Input::of(campaign, stated, observations)?.observed(robot, &mut Vec::new())?;
    let mut messages = stale(robot, &observed.observations);
    let set_up = check_set_up(robot, &observed.observations, &observed.settings);
    messages.extend(set_up.err().unwrap_or_default().0);
    Ok(messages)
}

/// An error where the nominal robot is nowhere near the measurements.
pub(super) fn check_set_up(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<()> {
    let problem = || etalon_identify::set_up_problem(robot, observations, settings.coordinate_uncertainty_mm());
    let problem = if observations.is_empty() { None } else { problem() };
    problem.map_or(Ok(()), |problem| Err(etalon_documents::warning_message(&problem).into()))
}

/// Share of the readings that may be left out as outliers: beyond it the model or the set-up is wrong.
const MOST_OUTLIERS: f64 = 0.1;

/// Leaves the outliers of a robust fit out of `observations`, of which `fewest` readings must remain, and names them; `None` where
/// there are none.
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
        let what = "`outliers = \"exclude\"` would leave out more than a tenth of all readings";
        return Err(Message::error(what)
            .hint("the model or the set-up is wrong: see what `outliers = \"keep\"` reports")
            .into());
    }
    for outlier in outliers {
        observations[outlier.observation].targets[outlier.target] = None;
    }
    observations.retain(|o| o.targets.iter().any(Option::is_some));
    let left_out = readings_to_check(&robust, robot);
    Ok(Some(Message::warning(format!("excluded by `outliers = \"exclude\"`: {}", left_out.what))))
}

/// A log, its observations and what they identify.
struct LogFit<'a> {
    name: &'a str,
    sets: &'a Sets,
    found: &'a Identification,
}

/// A warning where the residuals with one log correlate with its difference from another; `used` is the campaign's choice.
fn compare_logs(robot: &dyn Robot, this: &LogFit, that: &LogFit, used: &str) -> Option<Message> {
    let compared =
        etalon_identify::compare_logs(robot, &this.found.values, &this.sets.calibration, &that.sets.calibration)?;
    if compared.correlation <= 0.3 {
        return None;
    }
    let what = format!(
        "with log `{}`, residuals correlate with the difference of the two logs, r = {:.2}: their root mean square is {:.3} mm, \
         with log `{}` {:.3} mm",
        this.name, compared.correlation, this.found.rms, that.name, that.found.rms
    );
    let message = Message::warning(what);
    Some(match this.name == used {
        true => message.to_decide().hint(format!("identify with log `{}`: name it first", that.name)),
        false => message.routine().hint(format!("log `{}` is the one to use, as this campaign does", that.name)),
    })
}

/// Errors where a selection or a table takes none of these poses, or calibration and validation share some.
pub fn check_selections(campaign: &Campaign, poses: &BTreeSet<PoseName>) -> Result<()> {
    let Some(identify) = &campaign.file.identify else { return Ok(()) };
    // what does not read is reported with the statements
    let Ok(selections) = campaign.selections(identify) else { return Ok(()) };
    let mut problems = Problems::default();
    let stated = [
        (Some(&identify.calibration), Some(&selections.calibration)),
        (identify.validation.as_ref(), selections.validation.as_ref()),
    ];
    for (text, selection) in stated.into_iter().filter_map(|(text, selection)| Some((text?, selection?))) {
        if let Some(name) = selection.mistaken(poses) {
            let message = Message::error(format!("`{name}` names no pose that was measured")).at(campaign.place(text));
            let names: Vec<String> = poses.iter().map(PoseName::to_string).collect();
            problems.0.push(message.hint_names(&name.to_string(), names.iter().map(String::as_str)));
        }
    }
    let numbered = || poses.iter().copied().enumerate();
    if !numbered().any(|(i, pose)| selections.calibrates(pose, i)) {
        let message = Message::error("`calibration` selects no pose that was measured");
        problems.0.push(message.at(campaign.place(&identify.calibration)).hint(measured(poses)));
    }
    if let Some(text) = &identify.validation {
        if !numbered().any(|(i, pose)| selections.validates(pose, i)) {
            let message = Message::error("`validation` selects no pose that was measured");
            problems.0.push(message.at(campaign.place(text)).hint(measured(poses)));
        }
        let shared: Vec<String> = numbered()
            .filter(|&(i, pose)| selections.calibrates(pose, i) && selections.validates(pose, i))
            .map(|(_, pose)| pose.to_string())
            .collect();
        if !shared.is_empty() {
            let shown = shared.iter().take(20).cloned().collect::<Vec<_>>().join(", ");
            let more = if shared.len() > 20 { ", ..." } else { "" };
            let what = format!("poses in both calibration and validation: {shown}{more}");
            let message = Message::error(what).at(campaign.place(text));
            problems.0.push(message.hint("`validation = \"rest\"` takes all that calibration does not"));
        }
    }
    let in_use = |&(i, pose): &(usize, PoseName)| selections.calibrates(pose, i) || selections.validates(pose, i);
    let used: Vec<PoseName> = numbered().filter(in_use).map(|(_, pose)| pose).collect();
    for table in campaign.file.geometric.iter().flat_map(|g| &g.table) {
        let found = match Selection::parse(table.poses.get_ref()) {
            Ok(selection) if used.iter().enumerate().any(|(i, &pose)| selection.contains(pose, i, false)) => continue,
            Ok(_) => Message::error(format!("the table `{}` has no pose that was measured", table.title))
                .hint("a table shows poses of `calibration` and `validation`"),
            Err(message) => message,
        };
        problems.0.push(found.at(campaign.place(&table.poses)));
    }
    problems.check().map(|_| ())
}

/// Which poses there are to select from.
fn measured(poses: &BTreeSet<PoseName>) -> String {
    match (poses.first(), poses.last()) {
        (Some(first), Some(last)) => {
            format!("{} are measured and joined, from {first} to {last}", count(poses.len(), "pose"))
        }
        _ => "no pose is measured and joined".to_owned(),
    }
}
