//! Selection of the observations of a campaign: exclusions, sets of poses, and weights.

use crate::stages::calibrate::solution::Basis;
use crate::stages::calibrate::validation_targets::ValidationTargets;
use crate::stages::evaluate::sets::split;
use crate::stages::join::{Joined, Observations};
use crate::stages::judge::circumstances::{contradicted_load, hold_constant};
use crate::stages::kinds::{Observed, RowDefaults};
use crate::stages::observe::exclusions::{Exclusion, exclude};
use crate::stages::observe::joint_range::{self, Joints};
use crate::stages::observe::repeats::stale;
use crate::stages::remedies::remedied;
use crate::stages::table_file::in_campaign;
use crate::stages::truncated;
use etalon_base::angle_order::AngleOrder;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{AnsweredBy, Message, Place, Problems, Result};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, Identify, Selection, Selections};
use etalon_documents::{FramePose, FramesDocument, WorldFrame};
use etalon_identify::{FrameError, Settings};
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Data of a campaign for an identification.
#[derive(Clone, Copy)]
pub struct CampaignData<'a> {
    /// Campaign.
    pub campaign: &'a Campaign,
    /// Data of the campaign about the identification.
    pub stated: &'a Identify,
    /// Observations of each log.
    pub joined: &'a Joined,
    /// World frame.
    pub frames: &'a FramesDocument,
}

/// The observations of a campaign in its sets, and their weights.
pub struct Selected {
    /// Basis of the identification.
    pub basis: Basis,
    /// Targets and fixtures without calibration readings; their readings are in neither set.
    pub targets: ValidationTargets,
    /// Division of the poses into sets.
    pub division: Division,
    /// Warnings.
    pub messages: Vec<Message>,
}

/// Division of poses into sets.
pub struct Division {
    /// Measured poses, which give each pose its index.
    pub measured: BTreeSet<PoseName>,
    /// Selections of the campaign.
    pub selections: Selections,
}

/// Selects the observations of the first log by the data of the campaign; fixed points and surfaces
/// in them become parameters of `robot`.
///
/// # Errors
/// Fails if observations contradict each other or the data of the campaign.
pub fn select(data: CampaignData, robot: &mut dyn Robot) -> Result<Selected> {
    let CampaignData { campaign, stated, joined, frames } = data;
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
    let mut sets = split(&observed, &measured, &selections);
    let series = selections.calibration_series(indices(&poses, &measured));
    messages.extend(uncalibrated_series(stated, &series));
    let conditions = sets.calibration_conditions.clone();
    let mut settings = Settings { conditions, series, ..observed.settings };
    let weighted = etalon_identify::weigh(&observed.observations, robot.dimension(), &mut settings);
    messages.extend(weighted.map_err(|error| remedied(error).at(&campaign.key_place(&["identify", "residuals"])))?);
    messages.extend(hold_constant(robot, &sets, &mut settings));
    messages.extend(contradicted_load(campaign, robot, &sets));
    let targets = ValidationTargets::take(robot, &mut sets, &mut settings);
    let systematic = campaign.systematic(robot, frame_errors(&frames.world));
    let basis = Basis { sets, settings, systematic };
    Ok(Selected { basis, targets, division: Division { measured, selections }, messages })
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

/// Observations, and the settings of a campaign or of options for them.
pub(crate) struct Input<'a> {
    pub observations: &'a Observations,
    pub without: RowDefaults,
    pub settings: Settings,
    pub exclusions: Vec<Exclusion>,
    /// Adds the places in the observations to problems.
    pub place: Box<dyn Fn(Problems) -> Problems + 'a>,
}

impl<'a> Input<'a> {
    /// Observations of a campaign.
    pub fn new(campaign: &'a Campaign, stated: &Identify, observations: &'a Observations) -> Result<Self> {
        let settings = campaign.settings(stated);
        let without = RowDefaults {
            length_mm: settings.standard_uncertainty_mm,
            rotation_rad: campaign.file.instrument.rotation_uncertainty_rad(),
            // tables contain their own; exports are in the world already
            order: export_order(campaign),
        };
        let place = |problems: Problems| {
            match &campaign.file.observations[..] {
                [] => in_campaign(problems, &campaign.path),
                [only] => problems.at(&Place::file(only.file.get_ref().as_str())),
                // the rows name their files
                _ => problems,
            }
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

/// Order of the angles in the exports of a campaign, if all exports with angles have the same
/// order.
pub(crate) fn export_order(campaign: &Campaign) -> Option<AngleOrder> {
    let orders = campaign.file.exports.iter().filter_map(|export| export.format.dialect.rotation.as_deref());
    let orders: BTreeSet<&str> = orders.collect();
    let order = orders.first().filter(|_| orders.len() == 1)?;
    order.parse().ok()
}

/// Poses with their indices among all measured poses.
pub(crate) fn indices(
    poses: &BTreeSet<PoseName>,
    measured: &BTreeSet<PoseName>,
) -> impl Iterator<Item = (usize, PoseName)> {
    measured.iter().copied().enumerate().filter(|(_, pose)| poses.contains(pose))
}

/// Errors of selections and tables without a measured pose, and of overlapping sets; `all` are
/// the poses before exclusion, which count for indices and which series may name.
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
    let numbered = || indices(poses, all);
    if !numbered().any(|(i, pose)| selections.calibrates(pose, i)) {
        problems.0.push(without_pose("calibration", poses).at(campaign.place(&identify.calibration)));
    }
    if let Some(text) = &identify.validation {
        if !numbered().any(|(i, pose)| selections.validates(pose, i)) {
            problems.0.push(without_pose("validation", poses).at(campaign.place(text)));
        }
        let shared: Vec<String> = numbered()
            .filter(|&(i, pose)| selections.calibrates(pose, i) && selections.validates(pose, i))
            .map(|(_, pose)| pose.to_string())
            .collect();
        if !shared.is_empty() {
            problems.0.push(error!("sets-overlap", poses = truncated(shared, 20)).at(campaign.place(text)));
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

/// Error about a selection of which no pose is measured.
fn without_pose(set: &str, poses: &BTreeSet<PoseName>) -> Message {
    let hint = measured(poses);
    error!("selection-without-pose", set).answered_by(AnsweredBy::Measurements).hint(hint)
}

/// Warning about series without a calibration pose.
pub(crate) fn uncalibrated_series(stated: &Identify, series: &[Vec<PoseName>]) -> Option<Message> {
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
            without_pose("series", poses)
        } else if !shared.is_empty() {
            error!("series-overlap", poses = truncated(shared, 20))
        } else {
            continue;
        };
        problems.push(problem.at(campaign.place(text)));
    }
    let Some(first) = identify.series.first().filter(|_| problems.is_empty()) else { return problems };
    let forgotten = of.iter().enumerate().filter(|(i, (pose, of))| of.is_empty() && selections.calibrates(*pose, *i));
    let forgotten: Vec<String> = forgotten.map(|(_, (pose, _))| pose.to_string()).collect();
    let calibrating =
        selections.calibration_series(indices(poses, poses)).iter().filter(|poses| !poses.is_empty()).count();
    let problem = if !forgotten.is_empty() {
        error!("series-incomplete", poses = truncated(forgotten, 20))
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
