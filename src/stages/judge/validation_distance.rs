//! Distances of the validation poses from the calibration poses: given errors apply at such
//! distances.

use crate::stages::evaluate::sets::Sets;
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_base::warning;
use etalon_documents::{PoseSet, ValidationDistance};
use etalon_math::statistics::median;
use etalon_robots::Robot;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Distance, in spacings of the calibration poses, below which a validation pose repeats a
/// calibration pose, whose errors the fit reduced.
const REPEATED: f64 = 0.1;

/// Maximum scatter of joint values of repeats of a pose, as a share of their range.
const SCATTER: f64 = 1e-3;

/// Distances in joint space, each joint scaled by its range over the calibration poses; `None`
/// without validation poses, or with fewer than two distinct calibration poses.
pub fn validation_distance(robot: &dyn Robot, sets: &Sets) -> Option<ValidationDistance> {
    let count = robot.joints().len();
    let measured = |set: PoseSet| -> Vec<(PoseName, Vec<f64>)> {
        let (observations, conditions) = sets.observations_and_conditions(set);
        let of_positions = observations.iter().map(|o| (o.pose, &o.joints));
        // distances, contacts and surfaces have no observation of a position
        let all = of_positions.chain(conditions.iter().map(|c| (c.pose, &c.joints)));
        all.filter_map(|(pose, joints)| Some((pose, joints.get(..count)?.to_vec()))).collect()
    };
    let [calibration, validation] = [PoseSet::Calibration, PoseSet::Validation].map(measured);
    let all: Vec<&Vec<f64>> = calibration.iter().map(|(_, joints)| joints).collect();
    let ranges: Vec<(f64, f64)> = (0..count)
        .map(|j| all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |r, q| (r.0.min(q[j]), r.1.max(q[j]))))
        .collect();
    let space = JointSpace { ranges };
    // Repeats of a pose, whose joint values scatter, are one; so are equal joint values under
    // several numbers.
    let distinct = |measured: Vec<(PoseName, Vec<f64>)>| -> Vec<Vec<f64>> {
        let mut of_pose: BTreeMap<PoseName, Vec<Vec<f64>>> = BTreeMap::new();
        for (pose, q) in measured {
            let known = of_pose.entry(pose).or_default();
            if known.iter().all(|k| space.distance(k, &q) > SCATTER) {
                known.push(q);
            }
        }
        let bits = |q: Vec<f64>| (q.iter().map(|q| q.to_bits()).collect::<Vec<_>>(), q);
        of_pose.into_values().flatten().map(bits).collect::<BTreeMap<_, _>>().into_values().collect()
    };
    let (mut calibration, validation) = (distinct(calibration), distinct(validation));
    divide(&mut calibration, 0);
    let nearest = |from: &[Vec<f64>]| -> Vec<f64> {
        from.par_iter().map(|q| space.nearest(q, &calibration, 0, f64::INFINITY)).collect()
    };
    let spacing = median(nearest(&calibration)).filter(|s| *s > 0.0 && s.is_finite())?;
    let distances = nearest(&validation);
    let outside = |q: &&Vec<f64>| q.iter().zip(&space.ranges).any(|(q, (low, high))| q < low || q > high);
    Some(ValidationDistance {
        largest: distances.iter().copied().reduce(f64::max)? / spacing,
        median: median(distances)? / spacing,
        poses: validation.len(),
        outside: validation.iter().filter(outside).count(),
    })
}

/// Joint space, each joint scaled by its range over the calibration poses.
struct JointSpace {
    ranges: Vec<(f64, f64)>,
}

impl JointSpace {
    /// Distance of two points along an axis alone.
    fn along(&self, a: &[f64], b: &[f64], axis: usize) -> f64 {
        let (low, high) = self.ranges[axis];
        if high > low { (a[axis] - b[axis]) / (high - low) } else { 0.0 }
    }

    /// Distance of two points.
    fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        (0..self.ranges.len()).map(|axis| self.along(a, b, axis).powi(2)).sum::<f64>().sqrt()
    }

    /// Distance from `q` to the nearest other one of `divided` points, or `best` if that is
    /// smaller.
    fn nearest(&self, q: &[f64], divided: &[Vec<f64>], axis: usize, mut best: f64) -> f64 {
        let Some(middle) = divided.get(divided.len() / 2) else { return best };
        let (below, above) = (&divided[..divided.len() / 2], &divided[divided.len() / 2 + 1..]);
        if !std::ptr::eq(q.as_ptr(), middle.as_ptr()) {
            best = best.min(self.distance(q, middle));
        }
        let (near, far) = if q[axis] < middle[axis] { (below, above) } else { (above, below) };
        let next = (axis + 1) % q.len();
        best = self.nearest(q, near, next, best);
        if self.along(q, middle, axis).abs() <= best { self.nearest(q, far, next, best) } else { best }
    }
}

/// Orders points so that the middle one divides them along an axis, and each half likewise along
/// the next axis (a k-d tree, Bentley 1975).
fn divide(points: &mut [Vec<f64>], axis: usize) {
    if points.len() > 1 {
        let middle = points.len() / 2;
        points.select_nth_unstable_by(middle, |a, b| a[axis].total_cmp(&b[axis]));
        let (below, above) = points.split_at_mut(middle);
        let next = (axis + 1) % above[0].len();
        divide(below, next);
        divide(&mut above[1..], next);
    }
}

/// Returns a warning if validation poses repeat the calibration poses, or are far from them.
pub fn far_or_near(distance: &ValidationDistance) -> Option<Message> {
    let median = distance.median;
    match () {
        () if median < REPEATED => Some(warning!("validation-repeats-calibration", median, limit = REPEATED)),
        () if median > ValidationDistance::BEYOND => {
            Some(warning!("validation-far", median, limit = ValidationDistance::BEYOND))
        }
        () => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use etalon_identify::{Condition, Coordinate, Kind, Observation};
    use etalon_robots::Prexyt;

    /// Poses of a grid of four by four by four, 10 mm apart, from `first_mm` in each joint.
    fn grid(first_mm: f64) -> Vec<Observation> {
        let joints = |i: usize| [i % 4, i / 4 % 4, i / 16].map(|k| first_mm + 10.0 * k as f64).to_vec();
        (0..64)
            .map(|i| Observation {
                pose: (i as i64).into(),
                cycle: 1,
                joints: joints(i),
                targets: vec![None, None],
                ..Observation::default()
            })
            .collect()
    }

    fn distance(validation: Vec<Observation>) -> ValidationDistance {
        // each pose twice, the second time as the encoders read it back
        let mut again = grid(0.0);
        again.iter_mut().for_each(|o| o.joints.iter_mut().for_each(|q| *q += 1e-13 * *q));
        let calibration = [grid(0.0), again].concat();
        validation_distance(&Prexyt::default(), &Sets { calibration, validation, ..Sets::default() })
            .expect("a distance")
    }

    /// Computed by hand: the centre of a cell is √3/2 of its side from the nearest corner, and 3 of
    /// 4 of these are inside along each joint.
    #[test]
    fn distances_are_multiples_of_the_spacing_of_the_calibration() {
        let between = distance(grid(5.0));
        assert!((between.median - 0.75f64.sqrt()).abs() < 1e-12 && (between.largest - between.median).abs() < 1e-12);
        assert_eq!((between.poses, between.outside), (64, 64 - 27));
        assert!(far_or_near(&between).is_none());
        let near = distance(grid(0.5));
        assert!((near.median - 0.05 * 3f64.sqrt()).abs() < 1e-12);
        assert!(far_or_near(&near).unwrap().is("validation-repeats-calibration", &[]));
        let far = distance(grid(100.0));
        assert!(far.median > 7.0 * 3f64.sqrt() && far.outside == 64);
        assert!(far_or_near(&far).unwrap().is("validation-far", &[]));
        // as one after the other finds them
        let mut noise = Noise::new(1, 0);
        let mut drawn = || (0..300).map(|_| (0..3).map(|_| noise.uniform(1.0)).collect()).collect::<Vec<Vec<f64>>>();
        let (mut divided, others) = (drawn(), drawn());
        divide(&mut divided, 0);
        let space = JointSpace { ranges: vec![(0.0, 1.0); 3] };
        for q in divided.iter().chain(&others) {
            let each = divided.iter().filter(|p| *p != q).map(|p| space.distance(q, p)).fold(f64::INFINITY, f64::min);
            assert_eq!(space.nearest(q, &divided, 0, f64::INFINITY), each);
        }
        // single coordinates, distances and contacts have joint values too
        let conditions = |observations: Vec<Observation>| -> Vec<Condition> {
            let coordinate = |o: Observation| Condition {
                pose: o.pose,
                cycle: o.cycle,
                joints: o.joints,
                target: 0,
                kind: Kind::Coordinate(Coordinate { axis: 0, at_mm: 0.0 }),
                standard_uncertainty: 0.01,
            };
            observations.into_iter().map(coordinate).collect()
        };
        let (calibration_conditions, validation_conditions) = (conditions(grid(0.0)), conditions(grid(5.0)));
        let sets = Sets { calibration_conditions, validation_conditions, ..Sets::default() };
        let of_coordinates = validation_distance(&Prexyt::default(), &sets).expect("a distance");
        assert!((of_coordinates.median - between.median).abs() < 1e-12);
        assert_eq!((of_coordinates.poses, of_coordinates.outside), (64, 64 - 27));
        let none = |validation| Sets { calibration: grid(0.0)[..1].to_vec(), validation, ..Sets::default() };
        assert!(validation_distance(&Prexyt::default(), &none(grid(0.0))).is_none());
    }
}
