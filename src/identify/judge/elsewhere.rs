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
    /// The data as stated.
    pub data: &'a Data,
    /// Joint values of the poses.
    pub joints: Vec<Vec<f64>>,
}

impl Elsewhere<'_> {
    /// Flange at each pose, as stated and as changed, with the parameters of each; `None` for
    /// robots without a flange.
    fn flanges(&self, slip: &Slip, [stated, changed]: [&[f64]; 2]) -> Option<Vec<[Pose; 2]>> {
        let (arm, other) = (self.robot.free_base()?, slip.robot(self.robot).free_base()?);
        let target = self.data.readings(self.robot).first().map_or(0, |reading| reading.0);
        let pair = |(q, changed_q): (&Vec<f64>, &Vec<f64>)| {
            [arm.flange(stated, q, target), other.flange(changed, changed_q, target)]
        };
        Some(self.joints.iter().zip(&slip.elsewhere).map(pair).collect())
    }

    /// Largest difference (mm, rad) of the flange, as stated and as changed, beyond a motion common
    /// to all poses; `None` for robots without a flange.
    pub fn flange_difference(&self, slip: &Slip, values: [&[f64]; 2]) -> Option<(f64, f64)> {
        let pairs = self.flanges(slip, values)?;
        differences(pairs.iter().map(|[stated, changed]| stated.inverse().then(changed)))
    }

    /// `true` if free base or targets take up a change of the joints whatever the robot does, such
    /// as an offset of the first or the last joint: it is no mistake that anything could show.
    pub fn is_absorbed(&self, slip: &Slip, values: &[f64]) -> bool {
        let Self { robot, data, joints } = self;
        let (Some(arm), Some(pairs)) = (robot.free_base(), self.flanges(slip, [values, values])) else {
            return false;
        };
        let Ok(free) = wanted_frames(*robot, &data.observations, &data.settings) else { return false };
        if pairs.is_empty() || slip.elsewhere == *joints {
            return false;
        }
        let is_same = |differs: Option<(f64, f64)>| differs.is_some_and(|(mm, rad)| mm < EXACT && rad < EXACT);
        let by_targets = || is_same(differences(pairs.iter().map(|[stated, changed]| stated.inverse().then(changed))));
        let by_base = || is_same(differences(pairs.iter().map(|[stated, changed]| changed.then(&stated.inverse()))));
        let places = data.readings(*robot).into_iter().flat_map(|(k, _)| arm.target_place(k)..arm.target_place(k) + 3);
        let targets_free = places.into_iter().all(|i| free.contains(&i));
        // without a measured world, that of the base is the only one
        let is_base_free = !tied_to_world(&data.observations, &data.settings) || (0..6).all(|i| free.contains(&i));
        targets_free && by_targets() || is_base_free && by_base()
    }
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
