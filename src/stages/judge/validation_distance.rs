//! Distances of the validation poses from the calibration poses: given errors apply at such
//! distances.

use crate::stages::evaluate::sets::Sets;
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_base::warning;
use etalon_documents::ValidationDistance;
use etalon_identify::Observation;
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
    let joints = |o: &Observation| o.joints.get(..count).map(<[f64]>::to_vec);
    let all: Vec<Vec<f64>> = sets.calibration.iter().filter_map(joints).collect();
    let ranges: Vec<(f64, f64)> = (0..count)
        .map(|j| all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |r, q| (r.0.min(q[j]), r.1.max(q[j]))))
        .collect();
    let space = JointSpace { ranges };
    // Repeats of a pose, whose joint values scatter, are one; so are equal joint values under
    // several numbers.
    let distinct = |observations: &[Observation]| -> Vec<Vec<f64>> {
        let mut of_pose: BTreeMap<PoseName, Vec<Vec<f64>>> = BTreeMap::new();
        for (pose, q) in observations.iter().filter_map(|o| Some((o.pose, joints(o)?))) {
            let known = of_pose.entry(pose).or_default();
            if known.iter().all(|k| space.distance(k, &q) > SCATTER) {
                known.push(q);
            }
        }
        let bits = |q: Vec<f64>| (q.iter().map(|q| q.to_bits()).collect::<Vec<_>>(), q);
        of_pose.into_values().flatten().map(bits).collect::<BTreeMap<_, _>>().into_values().collect()
    };
    let (mut calibration, validation) = (distinct(&sets.calibration), distinct(&sets.validation));
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
        let none = |validation| Sets { calibration: grid(0.0)[..1].to_vec(), validation, ..Sets::default() };
        assert!(validation_distance(&Prexyt::default(), &none(grid(0.0))).is_none());
    }
}
