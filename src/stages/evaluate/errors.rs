//! Errors before and after: measured minus predicted, separately for calibration and validation
//! poses.

use crate::stages::evaluate::sets::Sets;
use crate::stages::join::ObservationTime;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_documents::ErrorQuantity::Position;
use etalon_documents::{PointError, PoseSet};
use etalon_identify::{Condition, Observation};
use etalon_math::statistics::rms;
use etalon_robots::{Robot, State};
use std::collections::BTreeMap;

/// Errors of every observation of both sets with two sets of parameters.
pub fn point_errors(robot: &dyn Robot, sets: &Sets, before: &[f64], after: &[f64]) -> Vec<PointError> {
    BeforeAfter { robot, before, after }.errors(sets)
}

/// Root mean square (mm) of the position errors of all targets; `None` without any.
pub fn position_rms_mm(robot: &dyn Robot, observations: &[Observation], values: &[f64]) -> Option<f64> {
    let of = |o: &Observation| -> Vec<f64> {
        let measured = o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)));
        measured.map(|(k, at)| norm(minus(at, robot.position(values, &o.joints, k)))).collect()
    };
    let errors: Vec<f64> = observations.iter().flat_map(of).collect();
    (!errors.is_empty()).then(|| rms(errors))
}

/// Root mean square (mm) of a coordinate's residual from the mean over the targets of its pose,
/// with n − 1 for n targets; `None` where no observation shows several targets.
pub fn within_poses_rms_mm(robot: &dyn Robot, observations: &[Observation], values: &[f64]) -> Option<f64> {
    let of = |o: &Observation| -> Option<(f64, usize)> {
        let measured = o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)));
        let left: Vec<_> = measured.map(|(k, at)| minus(at, robot.position(values, &o.joints, k))).collect();
        let mean = centroid(&left)?;
        Some((left.iter().map(|r| norm(minus(*r, mean)).powi(2)).sum(), left.len() - 1))
    };
    let all = observations.iter().filter_map(of).fold((0.0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    let degrees = (robot.dimension() * all.1) as f64;
    (degrees > 0.0).then(|| (all.0 / degrees).sqrt())
}

/// Replaces the errors after calibration by the errors of a robot with a residual field.
pub fn correct(errors: &mut [PointError], corrected: &dyn Robot, sets: &Sets, after: &[f64]) {
    let others = point_errors(corrected, sets, after, after);
    for (error, other) in errors.iter_mut().zip(others) {
        (error.after_mm, error.after_deg) = (other.after_mm, other.after_deg);
    }
}

/// A robot with all parameters before and after an identification.
#[derive(Clone, Copy)]
struct BeforeAfter<'a> {
    robot: &'a dyn Robot,
    before: &'a [f64],
    after: &'a [f64],
}

impl BeforeAfter<'_> {
    /// Errors of every observation of both sets.
    fn errors(&self, sets: &Sets) -> Vec<PointError> {
        let Self { robot, before, after } = *self;
        let mut all = Vec::new();
        for set in PoseSet::ALL {
            let (observations, conditions) = sets.observations_and_conditions(set);
            for o in observations {
                match robot.platform() {
                    Some(platform) => {
                        let [Some(k), Some(l)] = o.targets[..] else { continue };
                        let pair = [[k[0], k[1]], [l[0], l[1]]];
                        let error = |p: &[f64]| platform.pose_error(p, &o.joints, pair).map(|r| -r);
                        let (b, a) = (error(before), error(after));
                        let at = platform.measured_pose(after, pair);
                        all.push(PointError {
                            set,
                            pose: o.pose,
                            cycle: o.cycle,
                            target: "C".to_owned(),
                            quantity: Position,
                            at_mm: [at.x_mm, at.y_mm, 0.0],
                            before_mm: [b[0], b[1], 0.0],
                            after_mm: [a[0], a[1], 0.0],
                            before_deg: Some(b[2].to_degrees()),
                            after_deg: Some(a[2].to_degrees()),
                            joints: logged(robot, &o.joints),
                            control: Default::default(),
                        });
                    }
                    None => all.extend(self.target_errors(o, set)),
                }
            }
            for condition in conditions {
                self.condition_error(condition, set, &mut all);
            }
        }
        all
    }

    /// Adds the error of a condition: of an orientation the angle, beside the position error of the
    /// same target.
    fn condition_error(&self, condition: &Condition, set: PoseSet, all: &mut Vec<PointError>) {
        let Self { robot, before, after } = *self;
        let target = &robot.targets()[condition.target];
        let (b, a) = (condition.error(robot, before), condition.error(robot, after));
        if condition.kind.is_orientation() {
            let same = |e: &&mut PointError| {
                e.set == set && e.pose == condition.pose && e.cycle == condition.cycle && e.target == *target
            };
            if let Some(error) = all.iter_mut().rev().find(same) {
                error.before_deg = Some(norm(b).to_degrees());
                error.after_deg = Some(norm(a).to_degrees());
            }
            return;
        }
        // the value of a joint is not an error of a target
        let Some(kind) = condition.kind.error_kind() else { return };
        all.push(PointError {
            set,
            pose: condition.pose,
            cycle: condition.cycle,
            target: target.clone(),
            quantity: kind.into(),
            at_mm: robot.position(after, &condition.joints, condition.target),
            before_mm: b,
            after_mm: a,
            before_deg: None,
            after_deg: None,
            joints: logged(robot, &condition.joints),
            control: Default::default(),
        });
    }

    /// Errors of each target of a pose in space; with three or more on one branch, the rotation
    /// that remains between them.
    fn target_errors(&self, o: &Observation, set: PoseSet) -> Vec<PointError> {
        let Self { robot, before, after } = *self;
        let seen: Vec<(usize, Vector)> = o.targets.iter().enumerate().filter_map(|(k, t)| Some((k, (*t)?))).collect();
        let seen = &seen[..];
        let of_branch = |i: usize| {
            let same = move |k: &usize| robot.target_branch(seen[*k].0) == robot.target_branch(seen[i].0);
            (0..seen.len()).filter(same)
        };
        let predict = |p: &[f64]| -> Vec<Vector> { seen.iter().map(|s| robot.position(p, &o.joints, s.0)).collect() };
        let (b, a) = (predict(before), predict(after));
        // a rotation needs three targets that are not on one line
        let turned = |of_all: &[Vector], i: usize| {
            // one rotation a pose and branch: with its first target
            let first = of_branch(i).next() == Some(i);
            let (from, to): (Vec<Vector>, Vec<Vector>) =
                of_branch(i).filter(|_| first).map(|k| (of_all[k], seen[k].1)).unzip();
            let fitted = etalon_fit::rigid(&from, &to).ok()?;
            Some(fitted.to_T_from.angle_rad().to_degrees())
        };
        let error = |i: usize| PointError {
            set: set.to_owned(),
            pose: o.pose,
            cycle: o.cycle,
            target: robot.targets()[seen[i].0].clone(),
            quantity: Position,
            at_mm: seen[i].1,
            before_mm: minus(seen[i].1, b[i]),
            after_mm: minus(seen[i].1, a[i]),
            before_deg: turned(&b, i),
            after_deg: turned(&a, i),
            joints: logged(robot, &o.joints),
            control: Default::default(),
        };
        (0..seen.len()).map(error).collect()
    }
}

/// Errors of the measured points without orientations, for many sets of parameters.
pub(crate) struct PointErrors<'a> {
    robot: &'a dyn Robot,
    sets: &'a Sets,
    /// Loads at each observation; empty if bending is not modelled.
    loads: Vec<Vec<f64>>,
}

impl<'a> PointErrors<'a> {
    pub fn new(robot: &'a dyn Robot, sets: &'a Sets) -> Self {
        let observations = || PoseSet::ALL.into_iter().flat_map(|set| sets.observations_and_conditions(set).0);
        let loads = robot.loads().map_or_else(Vec::new, |at| observations().map(|o| at(&o.joints)).collect());
        Self { robot, sets, loads }
    }

    /// Returns the pose and error (mm) of each point with these parameters.
    pub fn with(&self, values: &[f64]) -> Vec<(PoseName, Vector)> {
        let (robot, bound) = (self.robot, self.robot.parametrised(values));
        let d = robot.dimension();
        let mut predicted = vec![0.0; d * robot.targets().len()];
        let mut loads = self.loads.iter();
        let mut all = Vec::new();
        for set in PoseSet::ALL {
            let (observations, conditions) = self.sets.observations_and_conditions(set);
            for o in observations {
                let loads = loads.next().map_or(&[][..], Vec::as_slice);
                if let Some(platform) = robot.platform() {
                    if let [Some(k), Some(l)] = o.targets[..] {
                        let [x, y, _] = platform.pose_error(values, &o.joints, [[k[0], k[1]], [l[0], l[1]]]);
                        all.push((o.pose, [-x, -y, 0.0]));
                    }
                    continue;
                }
                bound.positions(State { joints: &o.joints, loads }, &mut predicted);
                let measured = predicted.chunks_exact(d).zip(&o.targets).filter_map(|(p, at)| Some((p, (*at)?)));
                all.extend(
                    measured.map(|(p, at)| (o.pose, minus(at, [0, 1, 2].map(|i| p.get(i).copied().unwrap_or(0.0))))),
                );
            }
            let of_points = conditions.iter().filter(|c| c.kind.error_kind().is_some());
            all.extend(of_points.map(|c| (c.pose, c.error(robot, values))));
        }
        all
    }
}

/// Adds the time of each observation (s) from the first, as the last of the quantities against
/// which errors are drawn; `true` if there are times.
pub fn with_times(errors: &mut [PointError], times: &[ObservationTime]) -> bool {
    if times.is_empty() {
        return false;
    }
    let first = times.iter().map(|t| t.time_s).filter(|t| t.is_finite()).fold(f64::INFINITY, f64::min);
    // the centre of a platform has the time of its first target
    let mut of_pose = BTreeMap::new();
    let mut of_target = BTreeMap::new();
    for t in times {
        of_pose.entry((t.pose, t.cycle)).or_insert(t.time_s - first);
        of_target.entry((t.pose, t.cycle, t.target.as_str())).or_insert(t.time_s - first);
    }
    for e in errors {
        let own = of_target.get(&(e.pose, e.cycle, e.target.as_str()));
        e.joints.push(own.or(of_pose.get(&(e.pose, e.cycle))).copied().unwrap_or(f64::NAN));
    }
    true
}

/// Values of the joints in mm or deg.
fn logged(robot: &dyn Robot, joints: &[f64]) -> Vec<f64> {
    robot.joints().iter().zip(joints).map(|(joint, value)| joint.quantity.outward(*value)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_error_has_the_time_of_its_target_and_a_platform_that_of_the_pose() {
        let time = |pose: i64, target: &str, time_s| ObservationTime {
            pose: pose.into(),
            cycle: 1,
            target: target.to_owned(),
            time_s,
        };
        let times = [time(1, "a", 1e9), time(1, "b", 1e9 + 2.0), time(2, "a", 1e9 + 60.0)];
        let error = |pose: i64, target: &str| PointError {
            set: PoseSet::Calibration,
            pose: pose.into(),
            cycle: 1,
            target: target.to_owned(),
            quantity: Position,
            at_mm: [0.0; 3],
            before_mm: [0.0; 3],
            after_mm: [0.0; 3],
            before_deg: None,
            after_deg: None,
            joints: vec![7.0],
            control: Default::default(),
        };
        let mut errors = [error(1, "b"), error(2, "C"), error(3, "a")];
        assert!(with_times(&mut errors, &times));
        assert_eq!((&errors[0].joints[..], &errors[1].joints[..]), (&[7.0, 2.0][..], &[7.0, 60.0][..]));
        assert!(errors[2].joints[1].is_nan(), "a pose that was not observed has no time");
        assert!(!with_times(&mut errors, &[]) && errors[0].joints.len() == 2);
    }
}
