//! Noise of measured positions that the observations show without a model of the robot: the scatter
//! of readings at the same joint values, or, where joints hardly move, about positions that are
//! linear in the joint values.

use crate::Observation;
use crate::solution::placing::spread_mm;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_robots::Robot;

/// Minimum degrees of freedom of an estimated noise, in positions.
const FEWEST: usize = 5;
/// Maximum share of the spread of all positions that is noise; more is a wrong join of joint values
/// and points.
const LARGEST_SHARE: f64 = 0.05;
/// Maximum part of the motion of the nominal robot that is not linear in the joint values, as a
/// share of the motion, where joints hardly move.
const NON_LINEAR: f64 = 1e-3;

/// Readings of one target.
#[derive(Default)]
struct Readings {
    joints: Vec<Vec<f64>>,
    measured_mm: Vec<Vector>,
    predicted_mm: Vec<Vector>,
}

/// Sum of squares (mm²) over all coordinates, and degrees of freedom in positions.
#[derive(Clone, Copy, Default)]
struct Squares {
    sum: f64,
    degrees: usize,
}

impl Squares {
    fn add(&mut self, other: Self) {
        self.sum += other.sum;
        self.degrees += other.degrees;
    }
}

/// Standard uncertainty (mm) of a coordinate: `stated_mm`, or more if the observations show more.
pub fn observed_noise_mm(robot: &dyn Robot, observations: &[Observation], stated_mm: f64) -> f64 {
    let Some(noise_mm) = noise_mm(robot, observations) else { return stated_mm };
    stated_mm.max(noise_mm)
}

fn noise_mm(robot: &dyn Robot, observations: &[Observation]) -> Option<f64> {
    let all = readings(robot, observations);
    let mut squares = Squares::default();
    all.iter().for_each(|target| squares.add(repeats(target)));
    let mut is_still = false;
    if squares.degrees < FEWEST {
        squares = Squares::default();
        let (mut bent, mut moved) = (0.0, 0.0);
        for target in &all {
            squares.add(about_linear(&target.joints, &target.measured_mm));
            bent += about_linear(&target.joints, &target.predicted_mm).sum;
            moved += about_mean(&target.predicted_mm);
        }
        is_still = bent <= NON_LINEAR.powi(2) * moved;
        if !is_still || squares.degrees < FEWEST {
            return None;
        }
    }
    let noise_mm = (squares.sum / (robot.dimension() * squares.degrees) as f64).sqrt();
    let moves = all.iter().any(|target| about_mean(&target.predicted_mm) > 0.0) && !is_still;
    let is_noise = !moves || noise_mm <= LARGEST_SHARE * spread_mm(observations);
    Some(noise_mm).filter(|v| v.is_finite() && is_noise)
}

/// Readings of each target that has any.
fn readings(robot: &dyn Robot, observations: &[Observation]) -> Vec<Readings> {
    let nominal = robot.nominal();
    let mut all: Vec<Readings> = (0..robot.targets().len()).map(|_| Readings::default()).collect();
    for o in observations {
        for (k, at) in o.targets.iter().enumerate() {
            let (Some(at), Some(target)) = (at, all.get_mut(k)) else { continue };
            target.joints.push(o.joints.clone());
            target.measured_mm.push(*at);
            target.predicted_mm.push(robot.position(&nominal, &o.joints, k));
        }
    }
    all.retain(|target| !target.joints.is_empty());
    all
}

/// Scatter of readings at the very same joint values about their mean.
fn repeats(target: &Readings) -> Squares {
    let mut order: Vec<usize> = (0..target.joints.len()).collect();
    let joints = |i: usize| &target.joints[i];
    let compare = |a: &usize, b: &usize| {
        let different = joints(*a).iter().zip(joints(*b)).map(|(p, q)| p.total_cmp(q));
        different.into_iter().find(|o| o.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    };
    order.sort_by(compare);
    let mut squares = Squares::default();
    for group in order.chunk_by(|a, b| compare(a, b).is_eq()) {
        let points: Vec<Vector> = group.iter().map(|&i| target.measured_mm[i]).collect();
        squares.add(Squares { sum: about_mean(&points), degrees: points.len() - 1 });
    }
    squares
}

/// Sum of squared distances from the mean (mm²).
fn about_mean(points: &[Vector]) -> f64 {
    let mean = centroid(points).unwrap_or_default();
    points.iter().map(|p| norm(minus(*p, mean)).powi(2)).sum()
}

/// Scatter of points about the function linear in the joint values that fits them best.
fn about_linear(joints: &[Vec<f64>], points_mm: &[Vector]) -> Squares {
    let n = points_mm.len();
    let Some(columns) = joints.first().map(Vec::len) else { return Squares::default() };
    let centred = |values: Vec<f64>| {
        let mean = values.iter().sum::<f64>() / n as f64;
        values.into_iter().map(|v| v - mean).collect::<Vec<f64>>()
    };
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(p, q)| p * q).sum::<f64>();
    // an orthonormal basis of the changes of the joints (Gram-Schmidt, twice)
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let project = |mut v: Vec<f64>, basis: &[Vec<f64>]| {
        for e in basis.iter().chain(basis) {
            let along = product(&v, e);
            v.iter_mut().zip(e).for_each(|(v, e)| *v -= along * e);
        }
        v
    };
    for k in 0..columns {
        let column = centred(joints.iter().map(|q| q[k]).collect());
        let length = product(&column, &column).sqrt();
        let rest = project(column, &basis);
        let left = product(&rest, &rest).sqrt();
        if left > 1e-6 * length && left > 0.0 {
            basis.push(rest.into_iter().map(|v| v / left).collect());
        }
    }
    let of_axis = |i: usize| project(centred(points_mm.iter().map(|p| p[i]).collect()), &basis);
    let sum = (0..3).map(|i| of_axis(i).iter().map(|v| v * v).sum::<f64>()).sum();
    Squares { sum, degrees: n.saturating_sub(1 + basis.len()) }
}
