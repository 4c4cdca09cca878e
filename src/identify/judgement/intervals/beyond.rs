//! Growth of the errors of predictions beyond the measured values of a joint.
//!
//! A model without an effect fits the measured region. Beyond it the effect continues, and the
//! effective parameters do not follow: residuals understate the errors there. The errors at one
//! half of the values of a joint, predicted from the other half, show how fast they grow. To first
//! order the errors of held-out rows are e = (I − H)⁻¹ r with their part H of the hat matrix (Cook
//! & Weisberg 1982, chapter 2). Independent errors of variance s² have E(e eᵀ) = s² (I − H)⁻¹; the
//! excess over its trace is the growth of the misfit.

use crate::judgement::regional::SHOWN;
use crate::model::elimination::{Remaining, transposed_times};
use crate::model::residuals::Residuals;
use etalon_robots::Quantity;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Minimum number of poses in each half.
const POSES: usize = 8;

/// Growth of the errors of predictions beyond the measured values of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extrapolation {
    /// Index of the joint.
    pub joint: usize,
    /// Smallest and largest measured value (mm or rad).
    pub range: [f64; 2],
    /// Root-mean-square distance (mm or rad) of the held-out values from the other half.
    pub distance: f64,
    /// Excess variance of a coordinate at this distance, relative to the residual variance.
    pub position: f64,
    /// Excess variance of an orientation at this distance, likewise; zero without orientations.
    pub orientation: f64,
}

impl Extrapolation {
    /// Excess variances of a coordinate and of an orientation at a value of the joint, relative to
    /// the residual variances. The standard deviation grows with the distance from the measured
    /// values; turns of a revolute joint are equivalent.
    pub fn excess(&self, quantity: Quantity, value: f64) -> [f64; 2] {
        let share = (self.beyond(quantity, value) / self.distance).powi(2);
        [self.position * share, self.orientation * share]
    }

    /// Distance of a value of the joint from the measured values.
    fn beyond(&self, quantity: Quantity, value: f64) -> f64 {
        let [low, high] = self.range;
        let outside = |value: f64| (low - value).max(value - high).max(0.0);
        match quantity {
            Quantity::Angle => {
                let above = low + (value - low).rem_euclid(TAU);
                outside(above).min(outside(above - TAU))
            }
            _ => outside(value),
        }
    }
}

/// Rows of the poses, by their joint values.
struct Pose {
    joints: Vec<f64>,
    rows: Vec<usize>,
}

/// Growth for each joint whose halves have enough poses and show an excess; none if a reading is
/// common to several poses.
pub(crate) fn extrapolations(problem: &Residuals, remaining: &Remaining) -> Vec<Extrapolation> {
    if problem.is_whitened() {
        return Vec::new();
    }
    let mut by_name: BTreeMap<_, Pose> = BTreeMap::new();
    let mut row = 0;
    for (name, joints, rows) in problem.pose_rows() {
        let pose = by_name.entry(name).or_insert_with(|| Pose { joints: joints.to_vec(), rows: Vec::new() });
        pose.rows.extend(row..row + rows);
        row += rows;
    }
    let poses: Vec<Pose> = by_name.into_values().filter(|pose| !pose.rows.is_empty()).collect();
    let (n, measured) = (remaining.root.nrows(), problem.measured_count());
    let q = DMatrix::from_row_slice(measured, n, &remaining.jacobian[..measured * n]) * &remaining.root;
    let is_angle: Vec<bool> = problem.sizes().map(|size| size.is_none()).collect();
    let coordinates = problem.coordinate_count();
    let kind = |row: usize| (row >= coordinates).then(|| is_angle.get(row).copied().unwrap_or(false));
    let all = Predicted {
        q,
        residuals: &remaining.residuals,
        kinds: (0..measured).map(|row| Kind::new(kind(row))).collect(),
    };
    let own = all.variances();
    let joints: Vec<usize> = (0..problem.robot.joints().len()).collect();
    joints.into_par_iter().filter_map(|joint| extrapolation(&all, own, &poses, joint)).collect()
}

/// Growth beyond the values of one joint.
fn extrapolation(all: &Predicted, own: [f64; 2], poses: &[Pose], joint: usize) -> Option<Extrapolation> {
    let mut values: Vec<f64> = poses.iter().map(|pose| pose.joints[joint]).collect();
    values.sort_unstable_by(f64::total_cmp);
    let [low, high] = [*values.first()?, *values.last()?];
    // equal values stay in one half
    let middle = values[values.len() / 2];
    let below = values.partition_point(|v| *v < middle);
    let split = if below >= POSES { middle } else { *values.get(values.partition_point(|v| *v <= middle))? };
    let (lower, upper): (Vec<&Pose>, Vec<&Pose>) = poses.iter().partition(|pose| pose.joints[joint] < split);
    if lower.len().min(upper.len()) < POSES {
        return None;
    }
    let last = lower.iter().map(|pose| pose.joints[joint]).fold(f64::NEG_INFINITY, f64::max);
    let mut sums = [Sums::default(); 2];
    let mut squares = 0.0;
    for (half, edge) in [(&lower, split), (&upper, last)] {
        squares += half.iter().map(|pose| (pose.joints[joint] - edge).powi(2)).sum::<f64>();
        let rows: Vec<usize> = half.iter().flat_map(|pose| pose.rows.iter().copied()).collect();
        all.add_left_out(&rows, &mut sums);
    }
    let distance = (squares / poses.len() as f64).sqrt();
    let [position, orientation] = [0, 1].map(|kind| sums[kind].excess(own[kind]));
    let is_shown = distance > 0.0 && position.max(orientation) > 0.0;
    is_shown.then_some(Extrapolation { joint, range: [low, high], distance, position, orientation })
}

/// Kind of a row: position, orientation, or another.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Position = 0,
    Orientation = 1,
    Other = 2,
}

impl Kind {
    /// Kind of a coordinate (`None`), or of a condition that is an angle or a length.
    fn new(is_angle: Option<bool>) -> Self {
        match is_angle {
            None => Self::Position,
            Some(true) => Self::Orientation,
            Some(false) => Self::Other,
        }
    }
}

/// Sums over held-out rows of one kind.
#[derive(Clone, Copy, Default)]
struct Sums {
    count: f64,
    /// Squares of the errors.
    squares: f64,
    /// Expected squares of independent errors of unit variance.
    expected: f64,
}

impl Sums {
    /// Mean excess over independent errors, relative to the residual variance.
    fn excess(&self, variance: f64) -> f64 {
        let excess = (self.squares / variance - self.expected) / self.count;
        if excess.is_finite() { excess.max(0.0) } else { 0.0 }
    }
}

/// Rows of a linear problem in the coordinates in which Jᵀ J is the identity.
struct Predicted<'a> {
    q: DMatrix<f64>,
    residuals: &'a [f64],
    kinds: Vec<Kind>,
}

impl Predicted<'_> {
    /// Residual variances of positions and orientations, with their leverage.
    fn variances(&self) -> [f64; 2] {
        [Kind::Position, Kind::Orientation].map(|kind| {
            let rows = || (0..self.q.nrows()).filter(|&row| self.kinds[row] == kind);
            let free: f64 = rows().map(|row| 1.0 - self.q.row(row).norm_squared()).sum();
            rows().map(|row| self.residuals[row].powi(2)).sum::<f64>() / free
        })
    }

    /// Adds the errors of rows that are predicted from all others.
    fn add_left_out(&self, rows: &[usize], sums: &mut [Sums; 2]) {
        let n = self.q.ncols();
        let part = DMatrix::from_fn(rows.len(), n, |i, k| self.q[(rows[i], k)]);
        let r = DVector::from_fn(rows.len(), |i, _| self.residuals[rows[i]]);
        let SymmetricEigen { eigenvectors, eigenvalues } =
            SymmetricEigen::new(transposed_times(part.as_view(), part.as_view()));
        let inverse = eigenvalues.map(|leverage| 1.0 / (1.0 - leverage).max(SHOWN));
        // e = r + Q (I − QᵀQ)⁻¹ Qᵀ r
        let along = part * eigenvectors;
        let errors = &r + &along * along.tr_mul(&r).component_mul(&inverse);
        for (i, &row) in rows.iter().enumerate() {
            if let Some(sums) = sums.get_mut(self.kinds[row] as usize) {
                sums.count += 1.0;
                sums.squares += errors[i].powi(2);
                sums.expected += 1.0 + along.row(i).iter().zip(inverse.iter()).map(|(a, f)| a * a * f).sum::<f64>();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The line y = b x through four points: held-out rows have the errors of the line through the
    /// others.
    #[test]
    fn left_out_errors_are_those_of_the_other_rows() {
        let (x, y) = ([1.0, 2.0, 3.0, 4.0], [1.0, 2.5, 2.0, 6.0]);
        let all: f64 = x.iter().map(|x| x * x).sum();
        let slope = x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>() / all;
        let residuals: Vec<f64> = x.iter().zip(y).map(|(x, y)| slope * x - y).collect();
        let q = DMatrix::from_iterator(4, 1, x.iter().map(|x| x / all.sqrt()));
        let found = Predicted { q, residuals: &residuals, kinds: vec![Kind::Position; 4] };
        let mut sums = [Sums::default(); 2];
        found.add_left_out(&[2, 3], &mut sums);
        // through the first two: b = (1 + 5) / 5
        let b = 6.0 / 5.0;
        let by_hand: f64 = [(3.0, 2.0), (4.0, 6.0)].map(|(x, y): (f64, f64)| (b * x - y).powi(2)).iter().sum();
        assert!((sums[0].squares - by_hand).abs() < 1e-9, "{} {by_hand}", sums[0].squares);
        // variances of predictions 1 + x² / 5, but for the part that the clamp keeps
        assert!((sums[0].expected - (2.0 + 25.0 / 5.0)).abs() < 1e-9, "{}", sums[0].expected);
        assert_eq!((sums[0].count, sums[1].count), (2.0, 0.0));
    }

    #[test]
    fn errors_grow_with_the_distance_beyond_the_measured_values() {
        let found = Extrapolation { joint: 0, range: [-1.0, 1.0], distance: 0.5, position: 3.0, orientation: 0.0 };
        let excess = |value: f64| found.excess(Quantity::Angle, value)[0];
        assert_eq!([excess(0.0), excess(1.0), excess(-1.0)], [0.0; 3]);
        assert!((excess(1.5) - 3.0).abs() < 1e-12 && (excess(-2.0) - 12.0).abs() < 1e-12);
        // a turn further is the same place, and the nearer end counts
        assert!((excess(1.5 - TAU) - 3.0).abs() < 1e-12 && (excess(1.5 + TAU) - 3.0).abs() < 1e-12);
        assert!((excess(TAU - 1.5) - 3.0).abs() < 1e-12 && excess(TAU + 0.5) < 1e-12);
        assert!((found.excess(Quantity::Length, 7.0)[0] - 3.0 * 144.0).abs() < 1e-9);
    }
}
