//! Orientations where angles cannot be evaluated one by one (not in the standard). Near the
//! orientation at which the first and the last of three rotations have the same axis, noise of the
//! orientation is amplified in both angles: a repeatability of 0.02° becomes one of 270°. Rotation
//! vectors have no such orientation; they replace the angles there.

use crate::iso9283::pose::directions::farthest;
use crate::iso9283::pose::rotations::RotationOrder;
use crate::iso9283::pose::test::{AttainedPose, PoseTest, TestedPose};
use crate::iso9283::statistics::sample::{spread, unwrapped, wrapped};
use etalon_base::pose::{Pose, Vector, norm};
use etalon_math::statistics::rms;

/// Amplification of an error of the orientation in two angles from which on they are not evaluated.
const AMPLIFIED: f64 = 10.0;
/// Standard deviations of the orientation within which the axes may coincide.
const REACHED: f64 = 3.0;
/// Ratio of the deviations of two angles to the deviations of their sum or difference, and of the
/// third angle, from which on the two vary together.
const TOGETHER: f64 = 5.0;
/// Minimum deviation (rad) of two such angles about a third one near 0° or 180°, at which many
/// correct orientations lie: no robot scatters by half a degree.
const IMPLAUSIBLE_RAD: f64 = 0.5 * std::f64::consts::PI / 180.0;
/// Difference (rad) of an angle beyond rounding: another solution of the same orientation.
const OTHER_SOLUTION_RAD: f64 = 1e-6;

/// Angles of a pose that are not separable: two rotations have nearly the same axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inseparable {
    /// The two angles: 0, 1, 2 for a, b, c.
    pub angles: [usize; 2],
    /// `true` if this follows from the given order of the rotations; `false` if the two angles
    /// are seen to vary together, by far more than their sum or difference.
    pub is_stated: bool,
}

/// Accuracy and repeatability of an orientation by rotation vectors about fixed axes (rad).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RotationCharacteristics {
    /// Rotation from the commanded to the mean orientation; absent without a commanded one.
    pub deviation_rad: Option<Vector>,
    /// Three standard deviations of the rotations from the mean orientation, about each axis;
    /// absent with a single visit.
    pub repeatability_rad: Option<Vector>,
}

/// Mean orientation: the rotation vectors from it to all orientations add up to zero.
pub fn mean_orientation(all: &[Pose]) -> Option<Pose> {
    let mut mean = *all.first()?;
    for _ in 0..50 {
        let from = |pose: &Pose| pose.then(&mean.inverse()).rotation_vector_rad();
        let sum = all.iter().map(from).fold([0.0; 3], |sum, v| [0, 1, 2].map(|i| sum[i] + v[i]));
        let step = sum.map(|v| v / all.len() as f64);
        mean = Pose::from_rotation_vector(step).then(&mean);
        if norm(step) < 1e-13 {
            break;
        }
    }
    Some(mean)
}

/// Three standard deviations about each fixed axis of the rotations from the mean orientation.
fn repeatability_rad(all: &[Pose], mean: &Pose) -> Vector {
    let turned: Vec<Vector> = all.iter().map(|pose| pose.then(&mean.inverse()).rotation_vector_rad()).collect();
    [0, 1, 2].map(|i| 3.0 * spread(&turned.iter().map(|v| v[i]).collect::<Vec<_>>()).deviation)
}

/// Returns the two angles that vary together if the order of the rotations is unknown: by far more
/// than their sum or difference and than the third angle, whose mean is near a multiple of a right
/// angle. `deviations_rad` are a, b, c minus their commanded or mean values (rad).
pub fn varying_together(deviations_rad: &[Vector], means_rad: Vector) -> Option<[usize; 2]> {
    let size = |of: &dyn Fn(&Vector) -> f64| rms(deviations_rad.iter().map(of));
    let together = |[p, q, middle]: &[usize; 3]| {
        let (first, last) = (size(&|d| d[*p]), size(&|d| d[*q]));
        let joint = size(&|d| wrapped(d[*p] - d[*q])).min(size(&|d| wrapped(d[*p] + d[*q])));
        let (sine, cosine) = means_rad[*middle].sin_cos();
        let is_near =
            cosine.abs() * AMPLIFIED <= 1.0 || sine.abs() * AMPLIFIED <= 1.0 && first.min(last) >= IMPLAUSIBLE_RAD;
        let least = first.min(last);
        is_near && least > 0.0 && least >= TOGETHER * joint.max(size(&|d| d[*middle]))
    };
    [[0, 2, 1], [0, 1, 2], [1, 2, 0]].iter().find(|of| together(of)).map(|[p, q, _]| [*p, *q])
}

/// Returns the two angles that vary together among attained values of a, b, c, about their mean or
/// about commanded values; `None` unless all three angles are known.
pub fn seen_together(attained_rad: &[Vec<f64>], commanded_rad: &[f64]) -> Option<[usize; 2]> {
    let [a, b, c] = attained_rad else { return None };
    let about = |center: Vector| {
        let deviation = |i: usize| [a[i] - center[0], b[i] - center[1], c[i] - center[2]].map(wrapped);
        (0..a.len().min(b.len()).min(c.len())).map(deviation).collect::<Vec<_>>()
    };
    let means = [a, b, c].map(|angles| spread(&unwrapped(angles)).mean);
    let of_mean = (a.len() > 2).then(|| varying_together(&about(means), means)).flatten();
    let of_commanded = || varying_together(&about(commanded_rad.try_into().ok()?), means);
    of_mean.or_else(of_commanded)
}

impl PoseTest {
    /// Order of the rotations, if it is given and all three angles are measured.
    pub fn order(&self) -> Option<RotationOrder> {
        self.rotation_order.filter(|_| self.angles == [0, 1, 2])
    }

    /// Replaces angles by the solution of the same orientation that is nearest to the commanded
    /// angles, or to the first attained ones: three rotations reach an orientation in two ways.
    pub fn settle_solutions(&mut self) {
        let Some(order) = self.order() else { return };
        for p in &mut self.poses {
            let commanded: Option<Vector> = p.commanded_rad[..].try_into().ok();
            let first = || p.attained.first().and_then(|v| v.angles_rad[..].try_into().ok());
            let Some(near) = commanded.or_else(first) else { continue };
            for attained in &mut p.attained {
                let mut is_other = false;
                for read in &mut attained.readings_rad {
                    let Ok(angles) = Vector::try_from(&read[..]) else { continue };
                    let nearest = order.angles_rad(&order.pose(angles), near);
                    if (0..3).any(|k| wrapped(nearest[k] - angles[k]).abs() > OTHER_SOLUTION_RAD) {
                        (*read, is_other) = (nearest.to_vec(), true);
                    }
                }
                if is_other {
                    let mean = |k: usize| {
                        spread(&unwrapped(&attained.readings_rad.iter().map(|r| r[k]).collect::<Vec<_>>())).mean
                    };
                    attained.angles_rad = (0..3).map(mean).collect();
                }
            }
        }
    }

    /// Angles of a pose that are not separable, if there are any.
    pub fn inseparable(&self, pose: &TestedPose) -> Option<Inseparable> {
        let Some(order) = self.order() else {
            let attained: Vec<Vec<f64>> = (0..self.angles.len()).map(|k| pose.angles_rad(k, |_| true)).collect();
            let seen = (self.rotation_order.is_none() && self.angles == [0, 1, 2])
                .then(|| seen_together(&attained, &pose.commanded_rad));
            return seen.flatten().map(|angles| Inseparable { angles, is_stated: false });
        };
        let all = pose.orientations(order, |_| true);
        let mean = mean_orientation(&all)?;
        let scatter_rad = rms(all.iter().flat_map(|p| p.then(&mean.inverse()).rotation_vector_rad()));
        let commanded = pose.commanded_orientation(order);
        let sine = commanded.iter().chain([&mean]).map(|p| order.separation(p)).fold(f64::INFINITY, f64::min);
        let is_near = sine * AMPLIFIED <= 1.0 || sine.min(1.0).asin() <= REACHED * scatter_rad;
        let [first, _, last] = order.letters();
        let angles = [first.min(last), first.max(last)];
        is_near.then_some(Inseparable { angles, is_stated: true })
    }

    /// Accuracy and repeatability of the orientation of a pose by rotation vectors; absent unless
    /// the order of the rotations is known.
    pub fn rotation(&self, pose: &TestedPose) -> Option<RotationCharacteristics> {
        let order = self.order()?;
        let all = pose.orientations(order, |_| true);
        let mean = mean_orientation(&all)?;
        let deviation = |commanded: Pose| mean.then(&commanded.inverse()).rotation_vector_rad();
        Some(RotationCharacteristics {
            deviation_rad: pose.commanded_orientation(order).map(deviation),
            repeatability_rad: (all.len() > 1).then(|| repeatability_rad(&all, &mean)),
        })
    }

    /// AD and RD of the angle between the orientations of two poses (rad), of visits in the same
    /// cycles.
    pub fn rotation_distance_rad(&self, first: &TestedPose, second: &TestedPose) -> Option<[f64; 2]> {
        let order = self.order()?;
        let between = |from: &Pose, to: &Pose| from.inverse().then(to).angle_rad();
        let commanded = between(&first.commanded_orientation(order)?, &second.commanded_orientation(order)?);
        let attained = |pair: crate::iso9283::pose::test::PosePair| {
            Some(between(&pair.from.orientation(order)?, &pair.to.orientation(order)?))
        };
        let attained = first.pairs(second).into_iter().map(attained).collect::<Option<Vec<f64>>>()?;
        let attained = spread(&attained);
        Some([attained.mean - commanded, 3.0 * attained.deviation])
    }

    /// vAP of the orientation: largest angle (rad) between the mean orientations of two approaches.
    pub fn rotation_variation_rad(&self, pose: &TestedPose, approaches: &[String]) -> Option<f64> {
        let order = self.order()?;
        let mean = |name: &String| mean_orientation(&pose.orientations(order, |v| v.approach.as_ref() == Some(name)));
        let means = approaches.iter().map(mean).collect::<Option<Vec<Pose>>>()?;
        Some(farthest(means.len(), |h, k| means[h].inverse().then(&means[k]).angle_rad()).0)
    }
}

impl TestedPose {
    /// Commanded orientation, if all three angles are commanded.
    fn commanded_orientation(&self, order: RotationOrder) -> Option<Pose> {
        Some(order.pose(self.commanded_rad[..].try_into().ok()?))
    }

    /// Attained orientations selected by `wanted`, if all three angles are measured.
    fn orientations(&self, order: RotationOrder, wanted: impl Fn(&AttainedPose) -> bool) -> Vec<Pose> {
        self.attained.iter().filter(|v| wanted(v)).filter_map(|v| v.orientation(order)).collect()
    }
}

impl AttainedPose {
    /// Mean orientation of all readings, if all three angles are measured.
    fn orientation(&self, order: RotationOrder) -> Option<Pose> {
        let reading = |angles: &Vec<f64>| Some(order.pose(angles[..].try_into().ok()?));
        mean_orientation(&self.readings_rad.iter().map(reading).collect::<Option<Vec<_>>>()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use std::f64::consts::{FRAC_PI_2, PI};

    const ZYX: &str = "Rz(c) Ry(b) Rx(a)";

    /// Thirty visits of an orientation with 0.005° of noise about each axis, and the true rotation
    /// from the commanded to the mean orientation.
    fn test_at(order: &str, commanded: Vector, stated: bool) -> PoseTest {
        let (mut noise, order) = (Noise::new(6, 1), RotationOrder::parse(order).unwrap());
        let visit = |cycle: i64| {
            let off = [0.0002, -0.0001, 0.0003].map(|mean| mean + noise.gaussian(0.005f64.to_radians()));
            let pose = Pose::from_rotation_vector(off).then(&order.pose(commanded));
            // as a controller reports it: within half a turn, at the singularity as they come
            let is_locked = order.separation(&order.pose(commanded)) < 0.1;
            let near = if is_locked { [noise.uniform(PI), commanded[1], noise.uniform(PI)] } else { commanded };
            let angles = order.angles_rad(&pose, near).map(wrapped);
            AttainedPose {
                cycle,
                position_mm: [0.0; 3],
                angles_rad: angles.to_vec(),
                approach: None,
                robot: String::new(),
                readings_mm: vec![[0.0; 3]],
                readings_rad: vec![angles.to_vec()],
            }
        };
        let attained = (1..=30).map(visit).collect();
        let (commanded_mm, commanded_rad) = (Some([0.0; 3]), commanded.to_vec());
        PoseTest {
            poses: vec![TestedPose { pose: 1.into(), commanded_mm, commanded_rad, attained }],
            spatial: true,
            angles: vec![0, 1, 2],
            rotation_order: stated.then_some(order),
            warnings: Vec::new(),
        }
    }

    /// Rotation vectors at the singular orientation agree with rotation vectors at any other
    /// orientation. The two angles are named, with and without a given order.
    #[test]
    fn rotation_vectors_replace_angles_at_the_singular_orientation() {
        let deg = f64::to_radians;
        for (order, middle, is_near) in [
            (ZYX, FRAC_PI_2, true),
            (ZYX, -FRAC_PI_2, true),
            (ZYX, deg(89.99), true),
            (ZYX, deg(86.0), true),
            (ZYX, deg(-91.0), true),
            (ZYX, deg(45.0), false),
            (ZYX, 0.0, false),
            (ZYX, deg(80.0), false),
            ("Rz(a) Ry(b) Rx(c)", deg(90.002), true),
            ("Rz(a) Ry(b) Rz(c)", 0.0, true),
            ("Rz(a) Ry(b) Rz(c)", PI, true),
            ("Rz(a) Ry(b) Rz(c)", FRAC_PI_2, false),
        ] {
            let test = test_at(order, [deg(30.0), middle, deg(-100.0)], true);
            let pose = &test.poses[0];
            let expected = is_near.then_some(Inseparable { angles: [0, 2], is_stated: true });
            assert_eq!(test.inseparable(pose), expected, "{order} {middle}");
            let found = test.rotation(pose).unwrap();
            let (off, rp) = (found.deviation_rad.unwrap(), found.repeatability_rad.unwrap());
            // 0.005° / √30, and 3 × 0.005° within the 99.9 % interval of 30 values
            for (off, mean) in off.iter().zip([0.0002, -0.0001, 0.0003]) {
                assert!((off - mean).abs() < 4.0 * deg(0.005) / f64::sqrt(30.0), "{order} {middle}: {off}");
            }
            assert!(rp.iter().all(|rp| (deg(0.008)..deg(0.024)).contains(rp)), "{order} {middle}: {rp:?}");
            let unstated = test_at(order, [deg(30.0), middle, deg(-100.0)], false);
            let seen = unstated.inseparable(&unstated.poses[0]);
            assert_eq!(seen, expected.map(|e| Inseparable { is_stated: false, ..e }), "{order} {middle}");
        }
    }

    /// A controller may report either of the two solutions of one orientation; the angles are
    /// converted to the solution near the commanded one.
    #[test]
    fn other_solutions_of_an_orientation_are_brought_near() {
        let mut test = test_at(ZYX, [0.5, 0.7, 3.1], true);
        let sound = test.clone();
        for attained in test.poses[0].attained.iter_mut().step_by(2) {
            let [a, b, c] = attained.angles_rad[..] else { panic!() };
            attained.angles_rad = [a + PI, PI - b, c + PI].map(wrapped).to_vec();
            attained.readings_rad = vec![attained.angles_rad.clone()];
        }
        test.settle_solutions();
        for (found, sound) in test.poses[0].attained.iter().zip(&sound.poses[0].attained) {
            let off = found.angles_rad.iter().zip(&sound.angles_rad).map(|(a, b)| wrapped(a - b).abs());
            assert!(off.fold(0.0, f64::max) < 1e-9, "{found:?} {sound:?}");
        }
        // correct angles remain as they were read
        let mut again = sound.clone();
        again.settle_solutions();
        assert_eq!(again, sound);
    }

    /// Angles of correct data of unknown order are not accused at any orientation.
    #[test]
    fn sound_angles_of_unknown_order_are_separable() {
        let mut noise = Noise::new(9, 2);
        for _ in 0..2000 {
            let middle = [0.0, FRAC_PI_2, -FRAC_PI_2, PI, noise.uniform(PI)][(noise.uniform(0.5) * 5.0 + 2.5) as usize];
            let n = 3 + (noise.uniform(0.5).abs() * 20.0) as usize;
            let mut angle = |mean: f64| (0..n).map(|_| wrapped(mean + noise.gaussian(1e-4))).collect::<Vec<_>>();
            let attained = [angle(PI), angle(middle), angle(0.3)];
            assert_eq!(seen_together(&attained, &[PI, middle, 0.3]), None, "{attained:?}");
        }
    }
}
