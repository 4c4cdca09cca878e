//! Mistakes in single readings that explain why they contradict the others: swapped joint values of
//! two poses (two rows of a log, or two names), and a coordinate with another decimal mark or sign.

use super::MOST_PARAMETERS;
use crate::judgement::diagnosis::{OUTLIER, Reading, ReadingSource, RobustFit};
use crate::solution::start::located;
use crate::{Condition, Observation, Settings, fit_frames, wanted_frames};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::{minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_robots::Robot;

/// Residual with the change, relative to that without it, that other errors of a pose may leave,
/// and its largest value.
const EXPLAINED: [f64; 2] = [0.1, 0.5];
/// Maximum number of outlying poses that are compared in pairs.
const MOST: usize = 60;
/// Largest power of ten between two positions of a decimal mark.
const DIGITS: i32 = 6;

/// Mistakes in single readings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadingSlips {
    /// Pairs of outlying poses that are no outliers with the joint values of each other.
    pub exchanged: Vec<[PoseName; 2]>,
    /// Coordinates of outlying positions that agree with the others after one change.
    pub coordinates: Vec<WrongCoordinate>,
}

/// A coordinate that agrees with the other readings after a change of its decimal mark or sign.
#[derive(Clone, Debug, PartialEq)]
pub struct WrongCoordinate {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the repeat.
    pub cycle: i64,
    /// Name of the target.
    pub target: String,
    /// Index of the axis.
    pub axis: usize,
    /// Measured coordinate (mm).
    pub measured_mm: f64,
    /// Coordinate after the change (mm).
    pub changed_mm: f64,
}

impl WrongCoordinate {
    /// Text of the catalogue: "x of P at pose 33 is 14518790 mm, and 1451.879 mm agrees".
    pub fn phrase(&self) -> Phrase {
        let Self { pose, cycle, target, measured_mm, changed_mm, .. } = self;
        let axis = ["x", "y", "z"].get(self.axis).copied().unwrap_or_default();
        phrase!("wrong-coordinate", axis, target, pose, cycle, measured_mm, changed_mm)
    }
}

/// All readings at the same joint values.
struct Visit<'a> {
    pose: PoseName,
    joints: &'a [f64],
    readings: Vec<&'a Reading>,
}

/// Data of a robust fit.
struct Data<'a> {
    robot: &'a dyn Robot,
    observations: &'a [Observation],
    conditions: &'a [Condition],
    values: &'a [f64],
}

impl<'a> Data<'a> {
    fn joints(&self, reading: &Reading) -> &'a [f64] {
        match reading.source {
            ReadingSource::Position(i) => &self.observations[i].joints,
            ReadingSource::Condition(i) => &self.conditions[i].joints,
        }
    }

    /// Largest residual of a visit with other joint values, in standard deviations.
    fn left(&self, visit: &Visit, joints: &[f64]) -> f64 {
        let left = |reading: &&Reading| match reading.source {
            ReadingSource::Position(i) => {
                let other = Observation { joints: joints.to_vec(), ..self.observations[i].clone() };
                let mut misses = other.misses(self.robot, self.values);
                misses.find(|(target, _)| *target == reading.target).map_or(0.0, |(_, miss)| norm(miss))
            }
            ReadingSource::Condition(i) => {
                let other = Condition { joints: joints.to_vec(), ..self.conditions[i].clone() };
                norm(other.error(self.robot, self.values))
            }
        };
        visit.readings.iter().map(|r| left(r) / r.deviation).fold(0.0, f64::max)
    }

    /// Visits with an outlying reading, in the order of the data.
    fn outlying(&self, robust: &'a RobustFit) -> Vec<Visit<'a>> {
        let mut outliers: Vec<&Reading> = robust.outliers().iter().collect();
        outliers.sort_by_key(|reading| reading.source);
        let mut visits: Vec<Visit> = Vec::new();
        for outlier in outliers {
            let (pose, joints) = (outlier.pose, self.joints(outlier));
            let is_here = |r: &&Reading| r.pose == pose && r.cycle == outlier.cycle && self.joints(r) == joints;
            let is_new = visits.iter().all(|visit| !visit.readings.iter().any(|r| r.source == outlier.source));
            if is_new && visits.len() < MOST {
                visits.push(Visit { pose, joints, readings: robust.readings.iter().filter(is_here).collect() });
            }
        }
        visits
    }
}

/// Mistakes in single readings that explain the outliers of a robust fit. The observations and
/// conditions belong to the readings of that fit.
pub fn reading_slips(
    robot: &dyn Robot,
    observations: &[Observation],
    conditions: &[Condition],
    robust: &RobustFit,
) -> ReadingSlips {
    let data = Data { robot, observations, conditions, values: &robust.values };
    let coordinates: Vec<WrongCoordinate> =
        robust.outliers().iter().take(MOST).filter_map(|reading| data.wrong_coordinate(reading)).collect();
    ReadingSlips { exchanged: data.exchanged_poses(robust), coordinates }
}

/// Mistakes in single readings that the nominal robot shows, with base, targets and fixtures
/// located by most of the readings.
pub fn nominal_reading_slips(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> ReadingSlips {
    let slips = || {
        let free = wanted_frames(robot, observations, settings).ok()?;
        if free.len() > MOST_PARAMETERS {
            return None;
        }
        let start = match robot.free_base() {
            Some(arm) => located(robot, arm, observations, settings, &free).ok()??.values,
            None => fit_frames(robot, observations, settings).ok()?,
        };
        let robust = RobustFit::from_start(robot, observations, settings, &free, &start)?;
        let is_robot = robust.is_possible(robot, observations, settings);
        is_robot.then(|| reading_slips(robot, observations, &settings.conditions, &robust))
    };
    slips().unwrap_or_default()
}

impl Data<'_> {
    fn exchanged_poses(&self, robust: &RobustFit) -> Vec<[PoseName; 2]> {
        let mut outlying = self.outlying(robust);
        let mut pairs = Vec::new();
        while let Some(first) = outlying.pop() {
            let explains = |second: &Visit| {
                [(&first, second), (second, &first)].into_iter().all(|(visit, other)| {
                    let (with, without) = (self.left(visit, other.joints), self.left(visit, visit.joints));
                    with < OUTLIER.max(EXPLAINED[0] * without).min(EXPLAINED[1] * without)
                })
            };
            if let Some(k) = outlying.iter().rposition(explains) {
                pairs.push([outlying.remove(k).pose, first.pose]);
            }
        }
        pairs.reverse();
        pairs
    }

    /// The coordinate of an outlying position whose change explains the position best, if one does.
    fn wrong_coordinate(&self, reading: &Reading) -> Option<WrongCoordinate> {
        let ReadingSource::Position(i) = reading.source else { return None };
        let o = &self.observations[i];
        let at = o.targets.get(reading.target).copied().flatten()?;
        let place = self.robot.position(self.values, &o.joints, reading.target);
        let factors = || (1..=DIGITS).flat_map(|k| [10f64.powi(k), 10f64.powi(-k)]).chain([-1.0]);
        let changes = (0..self.robot.dimension()).flat_map(|axis| factors().map(move |factor| (axis, factor)));
        let with = |(axis, factor): (usize, f64)| {
            let mut changed = at;
            changed[axis] *= factor;
            (norm(minus(changed, place)) / reading.deviation, axis, changed[axis])
        };
        let (left, axis, changed_mm) = changes.map(with).min_by(|a, b| a.0.total_cmp(&b.0))?;
        let is_explained = left < OUTLIER.min(EXPLAINED[0] * reading.over_deviation());
        is_explained.then(|| WrongCoordinate {
            pose: reading.pose,
            cycle: reading.cycle,
            target: self.robot.targets()[reading.target].clone(),
            axis,
            measured_mm: at[axis],
            changed_mm,
        })
    }
}
