//! The walk of a campaign through the stages, each of which computes its result from the results of
//! the previous stages.

use super::controller_formats::ControllerFormats;
use super::{names, statements};
use crate::stages::calibrate::identification::{Identified, identify};
use crate::stages::calibrate::preview::preview;
use crate::stages::calibrate::selection::{CampaignData, check_selections};
use crate::stages::gather::{self, Gathered};
use crate::stages::geometric;
use crate::stages::iso9283::{self, TestData};
use crate::stages::join::{self, Joined};
use crate::stages::judge::frame_checks;
use crate::stages::kinds;
use crate::stages::observe::frames;
use etalon_base::message::{Problems, Result, Severity};
use etalon_base::pattern::matches_pattern;
use etalon_base::pose_name::PoseName;
use etalon_campaign::Campaign;
use etalon_documents::{
    Characteristics, FeaturesDocument, FramesDocument, GeometricDocument, ImportDocument, JointTravel, Presentation,
    SourceKind, Uncontrolled,
};
use etalon_formats::Point;
use etalon_report::branding;
use etalon_robots::Robot;
use std::borrow::Cow;
use std::collections::BTreeSet;

/// Extent of the walk through a campaign, and the effect of a stage that fails on the following
/// ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Mode {
    /// To its results; a stage that fails ends the walk.
    #[default]
    Run,
    /// To its observations; likewise.
    Observe,
    /// To the solver; every error is collected, and later stages are tried on the valid part of
    /// their input.
    Check,
}

/// A campaign on its walk through the stages, with their results so far.
#[derive(Default)]
pub(super) struct Walk {
    mode: Mode,
    /// Errors that have not ended the walk.
    pub problems: Problems,
    pub inputs: Inputs,
    pub robot: Option<Box<dyn Robot>>,
    pub features: Option<FeaturesDocument>,
    pub frames: Option<FramesDocument>,
    pub tested: Characteristics,
    pub joined: Option<Joined>,
    /// Travel of the joints in the calibration poses, for a check.
    joints: Vec<JointTravel>,
    pub identified: Option<Identified>,
    pub geometric: Option<GeometricDocument>,
}

/// Contents of the files that a campaign names.
#[derive(Default)]
pub(super) struct Inputs {
    /// Points, joint values, and the list of inputs, with warnings.
    pub gathered: Gathered,
    /// Tables and recordings of tests to ISO 9283.
    tests: TestData,
    /// Measurements of the geometric calibration, if the campaign has one.
    measured: Option<geometric::Gathered>,
    /// Formats of files for controllers.
    pub formats: ControllerFormats,
    /// Language, logo and templates of the report.
    pub presentation: Option<Presentation>,
    /// State after reading: all files are read, and the robot has the parameters that they need.
    is_read: bool,
    /// Features and frames are given, and every label that they name is present.
    is_named: bool,
}

/// A campaign as far as its observations.
pub struct Observed {
    /// Points, joint values, and the list of inputs, with the warnings of all stages.
    pub gathered: Gathered,
    /// The robot.
    pub robot: Box<dyn Robot>,
    /// The world.
    pub frames: FramesDocument,
    /// Measurements that met joint values.
    pub joined: Joined,
}

/// Takes a campaign with an identification as far as its observations.
///
/// # Errors
/// Reports all errors of its statements and files, or the errors of the first stage that fails.
pub fn observed(campaign: &Campaign) -> Result<Observed> {
    let mut walk = Walk::sound(campaign, Mode::Observe)?;
    walk.on(campaign)?;
    match (walk.robot, walk.frames, walk.joined) {
        (Some(robot), Some(frames), Some(joined)) => {
            Ok(Observed { gathered: walk.inputs.gathered, robot, frames, joined })
        }
        _ => Err(walk.problems),
    }
}

/// Findings of a check before a run identifies.
#[derive(Default)]
pub struct Checked {
    /// List of inputs, with all warnings.
    pub inputs: ImportDocument,
    /// Every error.
    pub problems: Problems,
    /// Travel of the joints in the calibration poses.
    pub joints: Vec<JointTravel>,
    /// Errors that no reading can show.
    pub not_controlled: Vec<Uncontrolled>,
}

/// Checks all that can stop a run before it identifies: the list of inputs with all warnings, and
/// every error.
pub fn everything(campaign: &Campaign) -> (ImportDocument, Problems) {
    let Checked { inputs, problems, .. } = checked(campaign);
    (inputs, problems)
}

/// [`everything`], and how far the joints move.
pub fn checked(campaign: &Campaign) -> Checked {
    let mut walk = Walk::gather(campaign, Mode::Check);
    let ended = walk.on(campaign);
    walk.problems.keep(ended);
    let not_controlled = walk.frames.map(|frames| frames.not_controlled).unwrap_or_default();
    let Walk { inputs, problems, joints, .. } = walk;
    Checked { inputs: inputs.gathered.document, problems, joints, not_controlled }
}

impl Walk {
    /// Gathers the files; an error ends the walk.
    pub fn sound(campaign: &Campaign, mode: Mode) -> Result<Self> {
        let mut walk = Self::gather(campaign, mode);
        std::mem::take(&mut walk.problems).check()?;
        Ok(walk)
    }

    /// Exports and logs become points and joint values, and all that is given is checked on them.
    fn gather(campaign: &Campaign, mode: Mode) -> Self {
        let mut walk = Self { mode, ..Self::default() };
        let (problems, inputs) = (&mut walk.problems, &mut walk.inputs);
        inputs.formats = ControllerFormats::read(campaign, problems);
        statements::check(campaign, problems);
        statements::values(campaign, problems);
        statements::conditions(campaign, problems);
        inputs.presentation = problems.keep(presentation(campaign));
        let before = problems.0.len();
        statements::frames(campaign, problems);
        let (gathered, more) = gather::recover(campaign);
        let whole = |keys: &[&str]| !keys.iter().any(|key| campaign.unread.affects(&[key]));
        inputs.is_read = more.0.is_empty() && whole(&["export", "log", "join"]);
        // a label that is missing may be in a file that did not read
        let opened =
            gathered.document.sources.iter().filter(|s| s.kind == SourceKind::Export && s.rows_read > 0).count();
        let complete = opened == campaign.file.exports.len();
        let not_exported = names::labels(campaign, &gathered, complete, problems);
        inputs.is_named = complete && problems.0.len() == before && whole(&["feature", "frame"]);
        let usable = inputs.is_named && inputs.is_read;
        if let (Some(definition), true) = (&campaign.file.geometric, usable && whole(&["geometric"])) {
            inputs.measured = problems.keep(geometric::gather(campaign, definition, &gathered.points));
        }
        let (tests, wrong) = iso9283::read(campaign);
        if usable && whole(&["repeatability"]) {
            problems.0.extend(iso9283::label_problems(campaign, &tests, &gathered).0);
        }
        problems.0.extend(more.0);
        // rows without a pose are not read: their targets are not missing; and the exports do
        // contain a target whose rows [[rigid]] rejects
        let is_left_out =
            |target: &str| gathered.has_rows_without_pose || gathered.refused_targets.iter().any(|t| t == target);
        not_exported.withdraw(problems, |target, _| is_left_out(target));
        problems.0.extend(wrong.0);
        let branches = campaign.robot.branches();
        let targets = gathered.observations.as_ref();
        let targets = targets.map(|t| kinds::targets(&t.table, &branches).map_err(|more| t.place(more)));
        let targets = targets.and_then(|targets| problems.keep(targets)).unwrap_or_default();
        let unread = gathered.observations.is_none() && !campaign.file.observations.is_empty();
        let built = campaign.try_robot_with(&targets).map_err(|more| names::targets_to_state(more, &gathered, unread));
        walk.robot = problems.keep(built);
        if let Some(robot) = &walk.robot {
            names::robot(campaign, robot.as_ref(), &not_exported, problems);
            inputs.formats.check(campaign, robot.as_ref(), problems);
            let before = problems.0.len();
            names::logs(campaign, robot.as_ref(), problems);
            let all_read = !gathered.has_rows_without_pose && gathered.refused_targets.is_empty();
            let is_joined = campaign.identifies() && campaign.file.observations.is_empty();
            if complete && all_read && is_joined && whole(&["join"]) {
                names::targets(campaign, robot.as_ref(), &gathered, problems);
            }
            // without its joints a log cannot be joined, nor can points without their targets
            inputs.is_read &= problems.0.len() == before;
        }
        (inputs.gathered, inputs.tests) = (gathered, tests);
        walk
    }

    /// Continues through the stages in their order.
    pub fn on(&mut self, campaign: &Campaign) -> Result<()> {
        if campaign.unread.affects(&["export"]) {
            // the unit, or the list of points, is not known
            return Ok(());
        }
        // fit, frames: points become features, and features and targets the world
        self.place(campaign)?;
        // tests: attained poses, recorded motions and loads become characteristics of ISO 9283
        if let (Mode::Run, Some(frames)) = (self.mode, &self.frames) {
            self.tested = iso9283::evaluate(campaign, &self.inputs.tests, &self.inputs.gathered, frames)?;
            self.inputs.gathered.document.sources.append(&mut self.inputs.tests.sources);
        }
        // join: measurements meet joint values
        self.join(campaign)?;
        let document = &mut self.inputs.gathered.document;
        document.messages.extend(self.features.iter().flat_map(|features| features.messages.clone()));
        // select: observations of the poses that are given; a run does so when it identifies
        if self.mode == Mode::Check {
            self.select(campaign);
        }
        if let Some(joined) = &mut self.joined {
            let document = &mut self.inputs.gathered.document;
            document.messages.append(&mut joined.messages);
            document.unmatched.append(&mut joined.unmatched);
        }
        // identify: observations become parameters, and errors before and after
        let (Mode::Run, Some(robot)) = (self.mode, &mut self.robot) else { return Ok(()) };
        if let (Some(stated), Some(joined), Some(frames)) = (&campaign.file.identify, &self.joined, &self.frames) {
            let mut identified = identify(CampaignData { campaign, stated, joined, frames }, robot.as_mut())?;
            identified.documents.parameters.provenance.inputs = self.inputs.gathered.document.inputs();
            self.identified = Some(identified);
        }
        // geometry: balls, a shaft and an arm give the same parameters without a model
        let measured = self.inputs.measured.take();
        let solution = self.identified.as_ref().map(|identified| &identified.solution);
        self.geometric = geometric::calibrate(campaign, robot.as_ref(), measured, solution)?;
        Ok(())
    }

    fn place(&mut self, campaign: &Campaign) -> Result<()> {
        let reads = |p: &Point| p.xyz_mm.iter().all(|v| v.is_finite());
        // what is placed and joined has no coordinate that does not read
        let unreadable: Vec<Point> = self.inputs.gathered.points.extract_if(.., |p| !reads(p)).collect();
        let points = &self.inputs.gathered.points;
        let affected = |name: &str| unreadable.iter().any(|p| matches_pattern(name, &p.label));
        let mut whole = Cow::Borrowed(campaign);
        if self.mode == Mode::Check {
            // features whose points all read
            let present = |name: &str| points.iter().any(|p| matches_pattern(name, &p.label));
            whole.to_mut().file.features.retain(|_, feature| {
                let labels = feature.element().map_or(&[][..], |(_, labels)| labels);
                labels.iter().all(|label| present(label.get_ref()) && !affected(label.get_ref()))
            });
        }
        self.features = self.mode.keep(&mut self.problems, frames::fit_features(&whole, points))?;
        if let Some(features) = &self.features
            && self.inputs.is_named
            && !gather::used_labels(campaign).into_iter().any(affected)
        {
            let planar = self.robot.as_ref().is_some_and(|robot| robot.dimension() == 2);
            let frames = frames::make_frames(campaign, points, features, planar);
            self.frames = self.mode.keep(&mut self.problems, frames)?;
            if let Some(frames) = &mut self.frames {
                frames.not_controlled = frame_checks::not_controlled(campaign, self.robot.as_deref(), features);
                self.mode.keep(&mut self.problems, frame_checks::check_nominal(campaign, points, frames))?;
            }
        }
        Ok(())
    }

    fn join(&mut self, campaign: &Campaign) -> Result<()> {
        let (Some(robot), true, true) = (&self.robot, self.inputs.is_read, campaign.identifies()) else {
            return Ok(());
        };
        if statements::lacks_standstills(campaign) {
            return Ok(());
        }
        let joined = match &self.frames {
            Some(frames) => join::joined(campaign, &self.inputs.gathered, frames, robot.as_ref()).map(Some),
            None => join::counts(campaign, &self.inputs.gathered, robot.as_ref()).map(|()| None),
        };
        self.joined = self.mode.keep(&mut self.problems, joined)?.flatten();
        Ok(())
    }

    /// Checks the set-up and the selections of poses; without a join, poses are selected from all
    /// points.
    fn select(&mut self, campaign: &Campaign) {
        let mut poses: BTreeSet<PoseName> = self.inputs.gathered.all_points().filter_map(|p| p.pose).collect();
        if let (Some(robot), Some(joined)) = (&mut self.robot, &self.joined) {
            let shown = self.problems.keep(preview(campaign, robot.as_mut(), joined)).unwrap_or_default();
            let (errors, warnings): (Vec<_>, Vec<_>) =
                shown.messages.into_iter().partition(|message| message.severity == Severity::Error);
            self.joints = shown.joints;
            self.problems.0.extend(errors);
            self.inputs.gathered.document.messages.extend(warnings);
            let first = joined.observations.first();
            poses = first.and_then(|(_, first)| first.poses().ok()).unwrap_or_default();
        }
        // a join by time may find no pose before the log is read; without any pose the cause is
        // reported already
        let without = poses.is_empty() && self.problems.0.iter().any(|m| m.severity == Severity::Error);
        if !campaign.unread.affects(&["identify"]) && (self.inputs.is_read || !poses.is_empty()) && !without {
            self.problems.keep(check_selections(campaign, &poses, &poses));
        }
    }
}

impl Mode {
    /// The value of a stage, or its failure: an error that ends the walk, or one of the collected
    /// ones.
    fn keep<T>(self, problems: &mut Problems, result: Result<T>) -> Result<Option<T>> {
        match self {
            Self::Check => Ok(problems.keep(result)),
            Self::Run | Self::Observe => result.map(Some),
        }
    }
}

/// Language, logo and templates of the report, read and checked.
pub fn presentation(campaign: &Campaign) -> Result<Presentation> {
    let stated = &campaign.file.report;
    let mut presentation = Presentation { language: stated.language, ..Presentation::default() };
    if let Some(file) = &stated.logo {
        let logo = branding::logo(&campaign.resolve(file)?);
        presentation.logo = Some(logo.map_err(|more| more.at(&campaign.place(file)))?);
    }
    if let Some(folder) = &stated.templates {
        let read = branding::templates(&campaign.resolve(folder)?);
        presentation.templates = read.map_err(|more| more.at(&campaign.place(folder)))?;
    }
    etalon_report::check_templates(&presentation)?;
    Ok(presentation)
}
