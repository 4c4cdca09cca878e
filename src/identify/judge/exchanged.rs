//! Poses whose joint values were swapped: two rows of a log, or two names of poses.

use crate::Observation;
use crate::judgement::diagnosis::{OUTLIER, RobustFit};
use etalon_base::pose::norm;
use etalon_base::pose_name::PoseName;
use etalon_robots::Robot;

/// Residual with the exchange, relative to that without it, that other errors of a pose may leave,
/// and its largest value.
const EXPLAINED: [f64; 2] = [0.1, 0.5];
/// Maximum number of outlying poses that are compared in pairs.
const MOST: usize = 60;

/// Pairs of outlying poses that are no outliers with the joint values of each other.
pub fn exchanged_poses(robot: &dyn Robot, observations: &[Observation], robust: &RobustFit) -> Vec<[PoseName; 2]> {
    let mut outlying: Vec<usize> = robust.outliers().iter().map(|reading| reading.observation).collect();
    outlying.sort_unstable();
    outlying.dedup();
    outlying.truncate(MOST);
    let left_mm = |o: &Observation, joints: &[f64]| {
        let other = Observation { joints: joints.to_vec(), ..o.clone() };
        other.misses(robot, &robust.values).map(|(_, miss)| norm(miss)).fold(0.0, f64::max)
    };
    let mut pairs = Vec::new();
    while let Some(first) = outlying.pop() {
        let explains = |&&second: &&usize| {
            let (a, b) = (&observations[first], &observations[second]);
            [(a, b), (b, a)].into_iter().all(|(o, other)| {
                let (with, without) = (left_mm(o, &other.joints), left_mm(o, &o.joints));
                with < (OUTLIER * robust.scale_mm).max(EXPLAINED[0] * without).min(EXPLAINED[1] * without)
            })
        };
        if let Some(&second) = outlying.iter().rev().find(explains) {
            outlying.retain(|&k| k != second);
            pairs.push([observations[second].pose, observations[first].pose]);
        }
    }
    pairs.reverse();
    pairs
}
