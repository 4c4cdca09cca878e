//! Data of a judgement: observations of every kind, with the settings under which they are judged.

use crate::solution::placing::{readings, spread_over, with_few_targets};
use crate::{Between, Condition, Kind, Known, Observation, Orientation, ResidualKind, Separation, Settings};
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector};
use etalon_base::pose_name::PoseName;
use etalon_robots::{Quantity, Robot, Role};
use std::collections::{BTreeMap, BTreeSet};

/// Number of poses on which changes are tried: at least, and at most if points that the robot
/// touches or points to are unknown (each of them needs several poses), or if a pose has fewer
/// residuals than a position.
const POSES: usize = 32;
const MOST_POSES: usize = 96;

/// Number of poses elsewhere at which robots are compared, and their stream of random numbers.
const PROBES: usize = 12;
const PROBES_STREAM: u64 = 24;

/// Observations, and the settings with further ones.
#[derive(Clone)]
pub(crate) struct Data {
    /// Positions of targets, without covariances: the misfit of a model is common to all.
    pub observations: Vec<Observation>,
    /// Settings, with the conditions.
    pub settings: Settings,
    /// Index of each condition in the campaign.
    pub numbers: Vec<usize>,
    /// Sum of the logarithms of the factors by which the lengths were multiplied: the density of
    /// the data as measured is that of the changed data times all factors.
    pub log_factors: f64,
}

impl Data {
    /// The data of a campaign: residuals of targets, and the targets with the most readings.
    pub fn new(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Self {
        let few = with_few_targets(robot, observations);
        let mut observations = few.map_or_else(|| observations.to_vec(), |few| few.0);
        observations.iter_mut().for_each(|o| o.covariances_mm2.clear());
        let settings = Settings {
            kind: ResidualKind::Targets,
            common_uncertainty_mm: None,
            rigid: Vec::new(),
            series: Vec::new(),
            ..settings.clone()
        };
        let numbers = (0..settings.conditions.len()).collect();
        Self { observations, settings, numbers, log_factors: 0.0 }
    }

    /// `true` for the same readings of the same poses.
    pub fn is_same(&self, other: &Self) -> bool {
        self.observations == other.observations && self.settings.conditions == other.settings.conditions
    }

    /// Poses in the order of their first observation.
    pub fn poses(&self) -> Vec<PoseName> {
        let all = self.observations.iter().map(|o| o.pose).chain(self.settings.conditions.iter().map(|c| c.pose));
        let mut seen = BTreeSet::new();
        all.filter(|pose| seen.insert(*pose)).collect()
    }

    /// Some of the data, spread over all poses: enough to try changes.
    pub fn subset(&self, robot: &dyn Robot) -> Self {
        let points = |c: &Condition| {
            c.kind.equation().unknowns().iter().any(|&i| {
                robot.parameters().get(i).is_some_and(|p| p.role == Role::Fixture) && !c.kind.is_orientation()
            })
        };
        if self.settings.conditions.is_empty() {
            return Self { observations: spread_over(&self.observations, POSES), ..self.clone() };
        }
        let poses = self.poses();
        let coordinates = robot.dimension() * self.observations.iter().flat_map(|o| o.targets.iter().flatten()).count();
        let residuals = coordinates + self.settings.conditions.iter().map(|c| c.kind.rows()).sum::<usize>();
        let enough = robot.dimension() * POSES * poses.len() / residuals.max(1);
        let is_unknown = self.settings.conditions.iter().any(points);
        let count = if is_unknown { MOST_POSES } else { enough.clamp(POSES, MOST_POSES) };
        let kept: BTreeSet<PoseName> = poses.iter().step_by(poses.len().div_ceil(count).max(1)).copied().collect();
        let mut some = self.clone();
        some.observations.retain(|o| kept.contains(&o.pose));
        some.retain_conditions(|c| kept.contains(&c.pose));
        some
    }

    /// The data of the target with the most readings; all data where no position is measured.
    pub fn with_one_target(mut self, robot: &dyn Robot) -> Self {
        let Some((most, _)) = self.readings(robot).into_iter().max_by_key(|(_, count)| *count) else { return self };
        for o in &mut self.observations {
            let others = o.targets.iter_mut().enumerate().filter(|(k, _)| *k != most);
            others.for_each(|(_, at)| *at = None);
        }
        self.observations.retain(|o| o.targets.iter().any(Option::is_some));
        self.retain_conditions(|c| c.target == most);
        self
    }

    /// Pose and target of every reading.
    pub fn places_of_readings(&self) -> BTreeSet<(PoseName, usize)> {
        let seen = |o: &Observation| {
            let targets = o.targets.iter().enumerate().filter(|(_, at)| at.is_some());
            targets.map(|(target, _)| (o.pose, target)).collect::<Vec<_>>()
        };
        let conditions = self.settings.conditions.iter().map(|c| (c.pose, c.target));
        self.observations.iter().flat_map(seen).chain(conditions).collect()
    }

    /// The data without the readings of a target at a pose.
    pub fn without(&self, pose: PoseName, target: usize) -> Self {
        let mut data = self.clone();
        data.observations.iter_mut().filter(|o| o.pose == pose).for_each(|o| o.targets[target] = None);
        data.observations.retain(|o| o.targets.iter().any(Option::is_some));
        data.retain_conditions(|c| (c.pose, c.target) != (pose, target));
        data
    }

    fn retain_conditions(&mut self, mut keep: impl FnMut(&mut Condition) -> bool) {
        let kept: Vec<bool> = self.settings.conditions.iter_mut().map(&mut keep).collect();
        let (mut conditions, mut numbers) = (kept.iter(), kept.iter());
        self.settings.conditions.retain(|_| conditions.next() == Some(&true));
        self.numbers.retain(|_| numbers.next() == Some(&true));
    }

    /// Poses around the measured ones: each joint turned by up to half a radian, or moved by 50 mm.
    pub fn elsewhere(&self, robot: &dyn Robot) -> Self {
        let mut noise = Noise::new(PROBES_STREAM, 0);
        let mut probes = self.clone();
        probes.observations.truncate(PROBES);
        if probes.observations.is_empty() {
            let of_conditions = self.settings.conditions.iter().take(PROBES);
            let observation = |c: &Condition| Observation { joints: c.joints.clone(), ..Observation::default() };
            probes.observations = of_conditions.map(observation).collect();
        }
        for o in &mut probes.observations {
            for (q, joint) in o.joints.iter_mut().zip(robot.joints()) {
                *q += noise.uniform(if joint.quantity == Quantity::Angle { 0.5 } else { 50.0 });
            }
        }
        probes
    }

    /// Joint values of the observations of positions.
    pub fn joints(&self) -> Vec<Vec<f64>> {
        self.observations.iter().map(|o| o.joints.clone()).collect()
    }

    /// Applies `how` to the joint values of every observation.
    pub fn change_joints(&mut self, how: &dyn Fn(&mut [f64])) {
        self.observations.iter_mut().for_each(|o| how(&mut o.joints));
        self.settings.conditions.iter_mut().for_each(|c| how(&mut c.joints));
    }

    /// Applies `how` to every measured point.
    pub fn change_points(&mut self, how: &dyn Fn(&mut Vector)) {
        self.observations.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()).for_each(how);
        self.settings.conditions.iter_mut().filter_map(|c| c.kind.point_mm()).for_each(how);
    }

    /// Multiplies every measured length: points, coordinates and distances.
    pub fn scale_lengths(&mut self, dimension: usize, factor: f64) {
        self.scale_places(dimension, factor);
        self.scale_distances(factor);
    }

    /// Multiplies every measured point and coordinate.
    pub fn scale_places(&mut self, dimension: usize, factor: f64) {
        let targets: Vec<usize> = (0..self.observations.first().map_or(0, |o| o.targets.len())).collect();
        self.scale_points(&targets, dimension, factor);
        self.scale_conditions(factor, |kind| !is_distance(kind));
    }

    /// Multiplies every measured distance.
    pub fn scale_distances(&mut self, factor: f64) {
        self.scale_conditions(factor, is_distance);
    }

    fn scale_conditions(&mut self, factor: f64, is_scaled: impl Fn(&Kind) -> bool) {
        let conditions = self.settings.conditions.iter_mut().filter(|c| is_scaled(&c.kind));
        let count = conditions.flat_map(|c| c.kind.lengths_mm()).map(|v| *v *= factor).count();
        self.log_factors += count as f64 * factor.ln();
    }

    /// `true` if distances are measured.
    pub fn has_distances(&self) -> bool {
        self.settings.conditions.iter().any(|c| is_distance(&c.kind))
    }

    /// Multiplies the measured points of these targets.
    pub fn scale_points(&mut self, targets: &[usize], dimension: usize, factor: f64) {
        let points = self.observations.iter_mut().flat_map(|o| o.targets.iter_mut().enumerate());
        let points = points.filter(|(k, _)| targets.contains(k)).filter_map(|(_, point)| point.as_mut());
        let count = points.map(|p| *p = p.map(|v| v * factor)).count();
        self.log_factors += (dimension * count) as f64 * factor.ln();
    }

    /// `true` if a place is measured or touched: orientations alone do not locate a base.
    pub fn has_places(&self) -> bool {
        !self.observations.is_empty() || self.settings.conditions.iter().any(|c| !c.kind.is_orientation())
    }

    /// `true` if the position of a target is measured.
    pub fn has_positions(&self) -> bool {
        self.observations.iter().any(|o| o.targets.iter().any(Option::is_some))
    }

    /// `true` if a length is measured.
    pub fn has_lengths(&self) -> bool {
        self.has_positions() || self.settings.conditions.iter().any(|c| c.kind.clone().lengths_mm().next().is_some())
    }

    /// The joint values of each pose taken from the previous (-1) or next (1) pose, in the order of
    /// the poses, or of their names if several kinds of observations alternate; the first or last
    /// pose has no neighbour and is omitted.
    pub fn shifted(&self, shift: isize) -> Self {
        let mut poses = self.poses();
        if !self.settings.conditions.is_empty() {
            poses.sort();
        }
        let joints_at = |pose: PoseName| {
            let seen = self.observations.iter().find(|o| o.pose == pose).map(|o| &o.joints);
            seen.or_else(|| self.settings.conditions.iter().find(|c| c.pose == pose).map(|c| &c.joints))
        };
        let all: BTreeMap<PoseName, Option<Vec<f64>>> = poses
            .iter()
            .enumerate()
            .map(|(k, pose)| {
                let other = k.checked_add_signed(shift).and_then(|k| poses.get(k));
                (*pose, other.and_then(|pose| joints_at(*pose)).cloned())
            })
            .collect();
        let mut shifted = self.clone();
        let other = |pose: PoseName, joints: &mut Vec<f64>| match all.get(&pose) {
            Some(Some(other)) => {
                joints.clone_from(other);
                true
            }
            _ => false,
        };
        shifted.observations.retain_mut(|o| other(o.pose, &mut o.joints));
        shifted.retain_conditions(|c| other(c.pose, &mut c.joints));
        shifted
    }

    /// Orientations in the world, by pose, cycle and target.
    fn bodies(&self) -> BTreeMap<(PoseName, i64, usize), Pose> {
        let body = |c: &Condition| match c.kind {
            Kind::Orientation(Orientation { frame_T_body, station: None, .. }) => {
                Some(((c.pose, c.cycle, c.target), frame_T_body))
            }
            _ => None,
        };
        self.settings.conditions.iter().filter_map(body).collect()
    }

    /// `true` if position and orientation of a target are measured together.
    pub fn has_poses(&self) -> bool {
        let bodies = self.bodies();
        let seen = |o: &Observation, k: usize| o.targets[k].is_some() && bodies.contains_key(&(o.pose, o.cycle, k));
        self.observations.iter().any(|o| (0..o.targets.len()).any(|k| seen(o, k)))
    }

    /// Inverts every measured pose: its position and its orientation.
    pub fn invert_poses(&mut self) {
        let bodies = self.bodies();
        for o in &mut self.observations {
            for (k, at) in o.targets.iter_mut().enumerate() {
                if let (Some(p), Some(body)) = (at, bodies.get(&(o.pose, o.cycle, k))) {
                    *p = body.inverse().rotate(p.map(|v| -v));
                }
            }
        }
        for c in &mut self.settings.conditions {
            if let Kind::Orientation(observed) = &mut c.kind
                && observed.station.is_none()
            {
                observed.frame_T_body = observed.frame_T_body.inverse();
            }
        }
    }

    /// Targets with at least one position, and the number of positions of each.
    pub fn readings(&self, robot: &dyn Robot) -> Vec<(usize, usize)> {
        readings(robot, &self.observations)
    }

    /// Known points and surfaces that targets touch, or from which distances are measured: the
    /// first parameter of each, with a condition. Unknown ones are names for unknown places.
    pub fn known_fixtures(&self) -> BTreeMap<usize, Kind> {
        let known: BTreeSet<usize> = self.settings.known.iter().flat_map(Known::points).collect();
        let touched = self.settings.conditions.iter().filter_map(|c| Some((c.kind.touched()?, c.kind)));
        touched.filter(|(first, _)| known.contains(first)).collect()
    }

    /// Exchanges two points or surfaces that targets touch.
    pub fn exchange_fixtures(&mut self, [one, other]: [&Kind; 2]) {
        for c in &mut self.settings.conditions {
            if c.kind.touched() == one.touched() {
                c.kind.touch(other);
            } else if c.kind.touched() == other.touched() {
                c.kind.touch(one);
            }
        }
    }

    /// Exchanges two targets.
    pub fn exchange_targets(&mut self, pairs: &[(usize, usize)]) {
        for &(i, j) in pairs {
            self.observations.iter_mut().for_each(|o| o.targets.swap(i, j));
            for c in &mut self.settings.conditions {
                c.target = if c.target == i {
                    j
                } else if c.target == j {
                    i
                } else {
                    c.target
                };
            }
        }
    }
}

fn is_distance(kind: &Kind) -> bool {
    matches!(kind, Kind::Distance(_) | Kind::Between(Between { apart: Separation::Distance(_), .. }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Distance;
    use etalon_robots::Prexyt;

    /// Positions at odd poses and distances at even ones; the joint values are the numbers of the
    /// poses.
    fn alternating() -> Data {
        let observation = |pose: i64| Observation {
            pose: pose.into(),
            cycle: 1,
            joints: vec![pose as f64; 3],
            targets: vec![Some([10.0, 20.0, 0.0]), None],
            ..Observation::default()
        };
        let condition = |pose: i64| Condition {
            pose: pose.into(),
            cycle: 1,
            joints: vec![pose as f64; 3],
            target: 0,
            kind: Kind::Distance(Distance { to: 0, distance_mm: 300.0 }),
            standard_uncertainty: 0.02,
        };
        let observations: Vec<Observation> = [1, 3, 5].map(observation).to_vec();
        let settings = Settings { conditions: [2, 4, 6].map(condition).to_vec(), ..Settings::default() };
        Data::new(&Prexyt::default(), &observations, &settings)
    }

    #[test]
    fn the_previous_pose_may_be_of_another_kind() {
        let shifted = alternating().shifted(-1);
        let number = |pose: PoseName, joints: &[f64]| (pose, joints[0]);
        let observed = shifted.observations.iter().map(|o| number(o.pose, &o.joints));
        let all: BTreeMap<PoseName, f64> =
            observed.chain(shifted.settings.conditions.iter().map(|c| number(c.pose, &c.joints))).collect();
        let expected: BTreeMap<PoseName, f64> = (2..=6).map(|pose: i64| (pose.into(), pose as f64 - 1.0)).collect();
        assert_eq!(all, expected);
    }

    #[test]
    fn measured_poses_are_inverted_as_a_whole() {
        let pose = Pose { translation_mm: [100.0, -20.0, 300.0], ..Pose::from_xyz_rpy([0.0; 3], [0.3, -0.7, 1.1]) };
        let mut data = alternating();
        data.observations[0].targets[0] = Some(pose.translation_mm);
        assert!(!data.has_poses());
        let turned =
            Orientation { frame_T_body: Pose { translation_mm: [0.0; 3], ..pose }, station: None, mounting: 0 };
        let same = data.observations[0].clone();
        data.settings.conditions.push(Condition {
            pose: same.pose,
            cycle: same.cycle,
            joints: same.joints,
            target: 0,
            kind: Kind::Orientation(turned),
            standard_uncertainty: 0.001,
        });
        assert!(data.has_poses());
        let mut inverse = data.clone();
        inverse.invert_poses();
        let moved = pose.inverse().translation_mm;
        let found = inverse.observations[0].targets[0].unwrap();
        assert!(moved.iter().zip(found).all(|(a, b)| (a - b).abs() < 1e-9), "{moved:?} {found:?}");
        // a position without an orientation stays, and twice is once
        assert_eq!(inverse.observations[1].targets, data.observations[1].targets);
        inverse.invert_poses();
        let back = inverse.observations[0].targets[0].unwrap();
        assert!(pose.translation_mm.iter().zip(back).all(|(a, b)| (a - b).abs() < 1e-9), "{back:?}");
    }

    #[test]
    fn points_and_distances_have_units_of_their_own() {
        let lengths = |data: &Data| {
            let point = data.observations[0].targets[0].expect("a point");
            let Kind::Distance(distance) = data.settings.conditions[0].kind else { panic!("a distance") };
            (point[0], distance.distance_mm, data.log_factors)
        };
        let (mut points, mut distances, mut all) = (alternating(), alternating(), alternating());
        points.scale_places(2, 10.0);
        distances.scale_distances(10.0);
        all.scale_lengths(2, 10.0);
        let each = 10f64.ln();
        // three points of two coordinates, and three distances
        assert_eq!(lengths(&points), (100.0, 300.0, 6.0 * each));
        assert_eq!(lengths(&distances), (10.0, 3000.0, 3.0 * each));
        let (point, distance, log_factors) = lengths(&all);
        assert!(point == 100.0 && distance == 3000.0 && (log_factors - 9.0 * each).abs() < 1e-12);
    }
}
