//! Poses elsewhere, at which a robot is compared with and without a change of its set-up.

use super::data::Data;
use super::hypotheses::Slip;
use crate::{tied_to_world, wanted_frames};
use etalon_base::pose::{Pose, norm};
use etalon_robots::Robot;

/// Differences (mm, rad) of the flange by rounding.
const EXACT: f64 = 1e-6;

/// Poses around the measured ones, at which robots are compared.
pub(super) struct Elsewhere<'a> {
    pub robot: &'a dyn Robot,
    /// The data as given.
    pub data: &'a Data,
    /// Joint values of the poses.
    pub joints: Vec<Vec<f64>>,
}

impl Elsewhere<'_> {
    /// Targets at which the flange is compared: one of each branch.
    fn targets(&self) -> Vec<usize> {
        let branches = self.robot.branches().len();
        if branches < 2 {
            return vec![self.data.readings(self.robot).first().map_or(0, |reading| reading.0)];
        }
        let targets = 0..self.robot.targets().len();
        (0..branches).filter_map(|branch| targets.clone().find(|k| self.robot.target_branch(*k) == branch)).collect()
    }

    /// Flange of each branch at each pose, as given and as changed, with the parameters of each;
    /// `None` for robots without a flange.
    fn flanges(&self, slip: &Slip, [stated, changed]: [&[f64]; 2]) -> Option<Vec<Vec<[Pose; 2]>>> {
        let (arm, other) = (self.robot.free_base()?, slip.robot(self.robot).free_base()?);
        let poses = || self.joints.iter().zip(&slip.elsewhere);
        let pairs = |target: usize| {
            poses()
                .map(|(q, changed_q)| [arm.flange(stated, q, target), other.flange(changed, changed_q, target)])
                .collect()
        };
        Some(self.targets().into_iter().map(pairs).collect())
    }

    /// Largest difference (mm, rad) of a flange, as given and as changed, beyond a motion common
    /// to all poses; `None` for robots without a flange.
    pub fn flange_difference(&self, slip: &Slip, values: [&[f64]; 2]) -> Option<(f64, f64)> {
        let branches = self.flanges(slip, values)?;
        let each = branches.iter().filter_map(|pairs| differences(pairs.iter().map(at_targets)));
        each.reduce(|(mm, rad), other| (mm.max(other.0), rad.max(other.1)))
    }

    /// `true` if free base or targets absorb a change of the joints at all poses, such as an offset
    /// of the first or the last joint: no measurement can show such a mistake.
    pub fn is_absorbed(&self, slip: &Slip, values: &[f64]) -> bool {
        let Self { robot, data, joints } = self;
        let (Some(arm), Some(branches)) = (robot.free_base(), self.flanges(slip, [values, values])) else {
            return false;
        };
        let Ok(free) = wanted_frames(*robot, &data.observations, &data.settings) else { return false };
        if slip.elsewhere.is_empty() || slip.elsewhere == *joints {
            return false;
        }
        let is_same = |differs: Option<(f64, f64)>| differs.is_some_and(|(mm, rad)| mm < EXACT && rad < EXACT);
        let by_targets = || branches.iter().all(|pairs| is_same(differences(pairs.iter().map(at_targets))));
        // a base moves all branches alike
        let by_base = || is_same(differences(branches.iter().flatten().map(at_base)));
        let places = data.readings(*robot).into_iter().flat_map(|(k, _)| arm.target_place(k)..arm.target_place(k) + 3);
        let targets_free = places.into_iter().all(|i| free.contains(&i));
        // without a measured world, the frame of the base is the only one
        let is_base_free = !tied_to_world(&data.observations, &data.settings) || (0..6).all(|i| free.contains(&i));
        targets_free && by_targets() || is_base_free && by_base()
    }
}

/// Motion of the flange, in its own frame as given.
fn at_targets([stated, changed]: &[Pose; 2]) -> Pose {
    stated.inverse().then(changed)
}

/// Motion of the flange, in the frame of the base.
fn at_base([stated, changed]: &[Pose; 2]) -> Pose {
    changed.then(&stated.inverse())
}

/// Largest difference (mm, rad) of motions from the first one; `None` without a motion.
fn differences(motions: impl Iterator<Item = Pose>) -> Option<(f64, f64)> {
    let all: Vec<Pose> = motions.collect();
    let first = all.first()?.inverse();
    let larger = |(mm, rad): (f64, f64), pose: Pose| {
        (norm(pose.translation_mm).max(mm), norm(pose.rotation_vector_rad()).max(rad))
    };
    Some(all.iter().map(|pose| first.then(pose)).fold((0.0, 0.0), larger))
}
