//! Poses whose joint values were swapped: two rows of a log, or two names of poses.

use crate::judgement::diagnosis::{OUTLIER, Reading, ReadingSource, RobustFit};
use crate::{Condition, Observation};
use etalon_base::pose::norm;
use etalon_base::pose_name::PoseName;
use etalon_robots::Robot;

/// Residual with the exchange, relative to that without it, that other errors of a pose may leave,
/// and its largest value.
const EXPLAINED: [f64; 2] = [0.1, 0.5];
/// Maximum number of outlying poses that are compared in pairs.
const MOST: usize = 60;

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

/// Pairs of outlying poses that are no outliers with the joint values of each other.
pub fn exchanged_poses(
    robot: &dyn Robot,
    observations: &[Observation],
    conditions: &[Condition],
    robust: &RobustFit,
) -> Vec<[PoseName; 2]> {
    let data = Data { robot, observations, conditions, values: &robust.values };
    let mut outlying = data.outlying(robust);
    let mut pairs = Vec::new();
    while let Some(first) = outlying.pop() {
        let explains = |second: &Visit| {
            [(&first, second), (second, &first)].into_iter().all(|(visit, other)| {
                let (with, without) = (data.left(visit, other.joints), data.left(visit, visit.joints));
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
