//! Covariance of effective parameters by a jackknife over regions of joint space.
//!
//! A model without an effect leaves a misfit that is alike at neighbouring poses. Least squares
//! then estimates effective parameters, which describe the robot best over the region of the
//! measured poses (White 1982). The scatter of the estimate from region to region is their
//! uncertainty. Each region is omitted once, to first order (delete-a-group jackknife, CR3 in Bell
//! & McCaffrey 2002): C = F (Σ h hᵀ) Fᵀ with h = Qᵀ (I − Q Qᵀ)⁻¹ r, Q = J F of the region's rows, F
//! Fᵀ = (Jᵀ J)⁻¹.
//!
//! Few regions show the scatter of slow misfit but not every direction of the parameters. The sum
//! is therefore the mean over several divisions, and is shrunk towards a common factor of the
//! classical covariance (Ledoit & Wolf 2004, J. Multivar. Anal. 88, 365). Both make it a continuous
//! function of the data. docs/decisions/0013 compares the alternatives.

use crate::model::elimination::{Remaining, carried, transposed_times};
use crate::model::residuals::Residuals;
use etalon_base::noise::Noise;
use etalon_base::pose_name::PoseName;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rayon::prelude::*;

/// Number of regions that poses are divided into.
const REGIONS: usize = 8;
/// Minimum number of poses of a region.
const POSES: usize = 2;
/// Minimum number of regions.
const FEWEST: usize = 4;
/// Number of divisions: one by the order of measurement, the others along random directions of
/// joint space.
const DIVISIONS: usize = 8;
/// Seed of the random directions.
const SEED: u64 = 60;
/// Minimum share (1 − leverage) of an error that a residual may show; a region that determines a
/// direction almost alone counts with this share.
pub(crate) const SHOWN: f64 = 0.05;

/// Scatter of the parameters between regions, and between series.
pub(crate) struct Regional {
    /// Σ h hᵀ, the covariance in the coordinates in which Jᵀ J is the identity.
    middle: DMatrix<f64>,
    /// Effective degrees of freedom of each variance.
    degrees: Vec<f64>,
    /// Scatter between series, if there are several.
    pub between: Option<BetweenSeries>,
}

/// Scatter of the identified parameters between series (set-ups, days, files) beyond the scatter
/// between regions of one series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BetweenSeries {
    /// Number of series.
    pub series: usize,
    /// Share of the variances of the parameters that it contributes, in the mean.
    pub share: f64,
}

/// A pose: its joint values in units of their scatter, and its rows.
struct Pose {
    joints: Vec<f64>,
    rows: Vec<usize>,
}

impl Regional {
    /// Scatter of the parameters of a linear problem; `None` without parameters, with fewer than
    /// eight poses, or if a reading is common to several poses.
    pub fn new(problem: &Residuals, remaining: &Remaining, series: &[Vec<PoseName>]) -> Option<Self> {
        let parts = divisions(problem)?;
        let Remaining { residuals, jacobian, root } = remaining;
        let (n, measured) = (Some(root.nrows()).filter(|n| *n > 0)?, problem.measured_count());
        let q = DMatrix::from_row_slice(measured, n, &jacobian[..measured * n]) * root;
        let scatter = |rows: &Vec<usize>| influence(&q, residuals, rows);
        let steps: Vec<DMatrix<f64>> = parts
            .par_iter()
            .map(|part| DMatrix::from_columns(&part.iter().map(scatter).collect::<Vec<DVector<f64>>>()))
            .collect();
        let shrunk: Vec<(DMatrix<f64>, f64)> = steps.iter().map(shrink).collect();
        let mean = |all: &mut dyn Iterator<Item = f64>| all.sum::<f64>() / DIVISIONS as f64;
        let middle = shrunk.iter().fold(DMatrix::zeros(n, n), |sum, (m, _)| sum + m) / DIVISIONS as f64;
        let share = mean(&mut shrunk.iter().map(|(_, share)| *share));
        let degrees = Degrees { q: &q, root, parts: &parts, rows: q.nrows() }.all(share);
        let found = Self { middle, degrees, between: None };
        let steps: Vec<DVector<f64>> = rows_of_series(problem, series).iter().map(scatter).collect();
        Some(if steps.len() > 1 { found.with_series(&DMatrix::from_columns(&steps), root) } else { found })
    }

    /// Adds the scatter between series to the scatter between regions. A column of `steps` is the
    /// change of the parameters without one series. The added covariance is the jackknife
    /// covariance of the mean over series, scaled so that its trace is the excess over the
    /// regional trace. A set-up moves few parameters (base, targets), so the sum is not shrunk. It
    /// has one degree of freedom fewer than there are series (Satterthwaite; GUM G.4.1).
    fn with_series(mut self, steps: &DMatrix<f64>, root: &DMatrix<f64>) -> Self {
        let series = steps.ncols();
        let of_mean = (series - 1) as f64 / series as f64;
        let within = self.middle.trace();
        let beyond = (1.0 - within / (of_mean * steps.norm_squared()).max(f64::MIN_POSITIVE)).max(0.0);
        let more = steps * steps.transpose() * (of_mean * beyond);
        let [regions, between] = [&self.middle, &more].map(|middle| carried(root, middle));
        let mut shares = Vec::new();
        for (k, degrees) in self.degrees.iter_mut().enumerate() {
            let (a, b) = (regions[(k, k)], between[(k, k)]);
            shares.push(b / (a + b).max(f64::MIN_POSITIVE));
            if b > 0.0 {
                *degrees = (a + b).powi(2) / (a.powi(2) / *degrees + b.powi(2) / (series - 1) as f64);
            }
        }
        let share = shares.iter().sum::<f64>() / shares.len().max(1) as f64;
        self.middle += more;
        self.between = Some(BetweenSeries { series, share });
        self
    }

    /// Covariance of the parameters, row by row, and their effective degrees of freedom.
    pub fn covariance(&self, root: &DMatrix<f64>) -> (Vec<f64>, Vec<f64>) {
        (carried(root, &self.middle).as_slice().to_vec(), self.degrees.clone())
    }
}

/// Rows of each series that has rows, and of the poses that belong to none.
fn rows_of_series(problem: &Residuals, series: &[Vec<PoseName>]) -> Vec<Vec<usize>> {
    let mut rows = vec![Vec::new(); series.len() + 1];
    for (row, pose) in problem.poses().into_iter().enumerate() {
        let of = series.iter().position(|poses| poses.contains(&pose)).unwrap_or(series.len());
        rows[of].push(row);
    }
    rows.retain(|rows| !rows.is_empty());
    rows
}

/// Rows of the regions of each division; `None` with fewer than eight poses, or if a reading is
/// common to several poses.
pub(crate) fn divisions(problem: &Residuals) -> Option<Vec<Vec<Vec<usize>>>> {
    let poses = poses(problem)?;
    let regions = REGIONS.min(poses.len() / POSES);
    (regions >= FEWEST).then(|| (0..DIVISIONS).map(|k| divide(&poses, regions, k)).collect())
}

/// Poses in the order of measurement; `None` if residuals are whitened, so that they belong to
/// several poses.
fn poses(problem: &Residuals) -> Option<Vec<Pose>> {
    if problem.is_whitened() {
        return None;
    }
    let mut all: Vec<Pose> = Vec::new();
    let mut index = std::collections::BTreeMap::new();
    let mut row = 0;
    for (name, joints, rows) in problem.pose_rows() {
        let at = *index.entry(name).or_insert_with(|| {
            all.push(Pose { joints: joints.to_vec(), rows: Vec::new() });
            all.len() - 1
        });
        all[at].rows.extend(row..row + rows);
        row += rows;
    }
    all.retain(|pose| !pose.rows.is_empty());
    let count = all.len() as f64;
    for j in 0..problem.robot.joints().len() {
        let mean = all.iter().map(|pose| pose.joints[j]).sum::<f64>() / count;
        let scatter = (all.iter().map(|pose| (pose.joints[j] - mean).powi(2)).sum::<f64>() / count).sqrt();
        let scale = if scatter > f64::EPSILON * mean.abs() { 1.0 / scatter } else { 0.0 };
        all.iter_mut().for_each(|pose| pose.joints[j] *= scale);
    }
    Some(all)
}

/// Rows of each region of division `number`. Parts are halved along a random direction of joint
/// space, the largest part first; the first division is along the order of measurement.
fn divide(poses: &[Pose], regions: usize, number: usize) -> Vec<Vec<usize>> {
    let mut noise = Noise::new(SEED, number as u64);
    let mut parts: Vec<Vec<usize>> = vec![(0..poses.len()).collect()];
    while parts.len() < regions {
        let Some(k) = (0..parts.len()).max_by_key(|&k| (parts[k].len(), std::cmp::Reverse(k))) else { break };
        let mut part = parts.swap_remove(k);
        if number > 0 {
            let along: Vec<f64> = poses[0].joints.iter().map(|_| noise.gaussian(1.0)).collect();
            let place = |i: &usize| poses[*i].joints.iter().zip(&along).map(|(q, a)| q * a).sum::<f64>();
            part.sort_by(|a, b| place(a).total_cmp(&place(b)));
        }
        let rest = part.split_off(part.len() / 2);
        parts.extend([part, rest]);
    }
    parts.iter().map(|part| part.iter().flat_map(|&i| poses[i].rows.iter().copied()).collect()).collect()
}

/// Change of the parameters without these rows, in the coordinates in which Jᵀ J is the identity.
fn influence(q: &DMatrix<f64>, residuals: &[f64], rows: &[usize]) -> DVector<f64> {
    let n = q.ncols();
    let mut part = DMatrix::from_fn(rows.len(), n, |i, k| q[(rows[i], k)]);
    let mut r = DVector::from_fn(rows.len(), |i, _| residuals[rows[i]]);
    if rows.len() > n {
        // of many rows the factor has the same products
        let qr = part.qr();
        qr.q_tr_mul(&mut r);
        (part, r) = (qr.r(), r.rows(0, n).into_owned());
    }
    let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(&part * part.transpose());
    let along = eigenvectors.tr_mul(&r);
    let shown = along.zip_map(&eigenvalues, |a, leverage| a / (1.0 - leverage).max(SHOWN));
    part.tr_mul(&(eigenvectors * shown))
}

/// Σ h hᵀ of the columns h, shrunk towards a multiple of the identity, and the share of that
/// multiple: the ratio of the variance of the sum to its distance from the multiple (Ledoit & Wolf
/// 2004, lemma 3.4).
fn shrink(steps: &DMatrix<f64>) -> (DMatrix<f64>, f64) {
    let (n, count) = (steps.nrows() as f64, steps.ncols() as f64);
    let sum = transposed_times(steps.transpose().as_view(), steps.transpose().as_view());
    let mean = sum.trace() / n;
    let fourths: f64 = steps.column_iter().map(|h| h.norm_squared().powi(2)).sum();
    let (variance, distance) = (fourths - sum.norm_squared() / count, sum.norm_squared() - sum.trace().powi(2) / n);
    let share = if distance > 0.0 { (variance / distance).clamp(0.0, 1.0) } else { 1.0 };
    let size = steps.nrows();
    (sum * (1.0 - share) + DMatrix::identity(size, size) * (share * mean), share)
}

/// Effective degrees of freedom for independent residuals (Satterthwaite; GUM G.4.1).
struct Degrees<'a> {
    q: &'a DMatrix<f64>,
    root: &'a DMatrix<f64>,
    /// Rows of the regions of each division.
    parts: &'a [Vec<Vec<usize>>],
    rows: usize,
}

impl Degrees<'_> {
    /// Degrees of all parameters. The variance of a mean over divisions is ρᵀ M ρ with the row ρ of
    /// F: a sum of squares of bᵀ r, one b a region. Two of them have the product of their common
    /// rows. The common factor has the degrees of freedom of all directions together.
    fn all(&self, share: f64) -> Vec<f64> {
        let labels: Vec<Vec<usize>> = self.parts.iter().map(|parts| self.labels(parts)).collect();
        let sensitivities = self.q * self.root.transpose();
        let degrees: Vec<f64> = (0..self.root.nrows())
            .into_par_iter()
            .map(|k| self.degrees_of_sum(&labels, sensitivities.column(k).map(|v| v * v).as_slice()))
            .collect();
        let of_factor: f64 = degrees.iter().sum();
        let all = |d: f64| 1.0 / ((1.0 - share).powi(2) / d + share.powi(2) / of_factor);
        degrees.into_iter().map(all).collect()
    }

    /// Region of each row.
    fn labels(&self, parts: &[Vec<usize>]) -> Vec<usize> {
        let mut labels = vec![0; self.rows];
        parts.iter().enumerate().for_each(|(k, rows)| rows.iter().for_each(|&row| labels[row] = k));
        labels
    }

    /// Degrees of a sum in which the rows have these weights.
    fn degrees_of_sum(&self, labels: &[Vec<usize>], weights: &[f64]) -> f64 {
        let mut squares = 0.0;
        for (a, first) in labels.iter().enumerate() {
            for second in &labels[..=a] {
                let mut common = [0.0; REGIONS * REGIONS];
                for ((&i, &j), w) in first.iter().zip(second).zip(weights) {
                    common[i * REGIONS + j] += w;
                }
                let sum: f64 = common.iter().map(|c| c * c).sum();
                squares += if std::ptr::eq(first, second) { sum } else { 2.0 * sum };
            }
        }
        let total: f64 = weights.iter().sum::<f64>() * labels.len() as f64;
        total * total / squares
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two regions with influences (1, 0) and (0, 2): Σ h hᵀ = diag(1, 4), its mean 2.5; fourth
    /// powers 17, variance 17 − 17/2, distance 17 − 25/2: the share is beyond 1.
    #[test]
    fn the_share_of_the_common_factor_by_hand() {
        let (all, share) = shrink(&DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 2.0]));
        assert_eq!((all, share), (DMatrix::from_diagonal_element(2, 2, 2.5), 1.0));
        // eight equal influences have no variance: nothing is shrunk
        let (all, share) = shrink(&DMatrix::from_fn(2, 8, |i, _| [1.0, 0.0][i]));
        assert_eq!((all, share), (DMatrix::from_row_slice(2, 2, &[8.0, 0.0, 0.0, 0.0]), 0.0));
    }

    /// The mean of readings 0, 0, 6, 6 in two regions: residuals −3, −3, 3, 3. Without the first
    /// region the mean is 6, 3 away from 3; h in units of F = 1/2 is −6.
    #[test]
    fn the_influence_of_a_region_is_the_change_without_it() {
        let q = DMatrix::from_element(4, 1, 0.5);
        let h = influence(&q, &[-3.0, -3.0, 3.0, 3.0], &[0, 1]);
        assert!((h[0] + 6.0).abs() < 1e-12, "{}", h[0]);
    }

    /// Two series that change the parameters by (±1, 0): the mean over both varies by 1/2 · 2. The
    /// regions have 0.1 in each of two directions; 1 − 0.2 / 1 of the sum is between series. Of the
    /// first variance 0.8 has one degree of freedom, 0.1 has 8; 8/9 and 0 are 4/9 in the mean.
    #[test]
    fn the_scatter_between_two_series_by_hand() {
        let within =
            Regional { middle: DMatrix::from_diagonal_element(2, 2, 0.1), degrees: vec![8.0; 2], between: None };
        let (steps, root) = (DMatrix::from_row_slice(2, 2, &[1.0, -1.0, 0.0, 0.0]), DMatrix::identity(2, 2));
        let found = within.with_series(&steps, &root);
        let BetweenSeries { series, share } = found.between.expect("two series");
        assert!(series == 2 && (share - 4.0 / 9.0).abs() < 1e-12, "{share}");
        assert!((found.middle - DMatrix::from_diagonal(&DVector::from_vec(vec![0.9, 0.1]))).norm() < 1e-12);
        let degrees = 0.81 / (0.01 / 8.0 + 0.64);
        assert!((found.degrees[0] - degrees).abs() < 1e-9 && found.degrees[1] == 8.0, "{:?}", found.degrees);
        // series that differ less than regions add nothing
        let within = Regional { middle: DMatrix::identity(2, 2), degrees: vec![8.0; 2], between: None };
        let found = within.with_series(&steps, &root);
        assert_eq!((found.between.expect("two series").share, found.middle), (0.0, DMatrix::identity(2, 2)));
    }

    /// One division into eight regions of equal weight has eight degrees of freedom.
    #[test]
    fn degrees_of_freedom_of_one_division() {
        let q = DMatrix::from_element(16, 1, 0.25);
        let root = DMatrix::from_element(1, 1, 0.25);
        let parts = vec![(0..8).map(|k| vec![2 * k, 2 * k + 1]).collect::<Vec<_>>()];
        let degrees = Degrees { q: &q, root: &root, parts: &parts, rows: 16 }.all(0.0);
        assert!((degrees[0] - 8.0).abs() < 1e-12, "{degrees:?}");
    }
}
