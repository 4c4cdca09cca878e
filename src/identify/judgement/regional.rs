//! Misfit as a field over joint space: model errors are alike at neighbouring poses.
//!
//! A reading of target k at pose i is off by f(qᵢ) + e: f is a Gaussian process, independent along
//! each axis of the world and common to all targets of a pose, with a Matérn covariance v (1 + d)
//! exp(−d), d = √3 |qᵢ − qⱼ| / ℓ (smoothness 3/2; Rasmussen & Williams 2006, eq. 4.17); e is white.
//! The variances and the length ℓ are those of largest restricted likelihood (REML; Patterson &
//! Thompson 1971; Harville 1977), in which the parameters that were identified are integrated out.

use crate::model::elimination::{Remaining, carried, transposed_times};
use crate::model::residuals::Residuals;
use etalon_robots::Quantity;
use nalgebra::{Cholesky, DMatrix, DMatrixView, DVector, SymmetricEigen};
use rayon::prelude::*;

/// Candidate lengths ℓ (rad); for prismatic joints, shares of half their range.
const LENGTHS: [f64; 5] = [0.3, 0.7, 1.5, 3.0, 6.0];
/// Candidate ratios of the variance of the field to that of a white residual.
const RATIOS: [f64; 7] = [0.1, 0.4, 1.6, 6.4, 25.0, 100.0, 400.0];
/// Maximum number of poses from which length and variances are estimated.
const ESTIMATED_FROM: usize = 64;
/// Number of poses whose mutual covariances are summed at once.
const SUMMED: usize = 200;
/// Fall of −2 ln L that noise alone exceeds in one of a hundred campaigns: chi-square of two more
/// parameters, variance and length.
const SIGNIFICANT: f64 = 9.21;
/// Rise of −2 ln L up to which variance and length are compatible with the best ones, at a level of
/// 0.1 % (chi-square of two).
const AS_PROBABLE: f64 = 13.82;
/// Maximum number of iterations per eigenvalue, for which two are usual.
const EIGEN_STEPS: usize = 100;
/// Minimum number of poses for a field.
const FEWEST: usize = 8;

/// The field in the residuals of a solution.
pub(crate) struct Field {
    /// Fᵀ Jᵀ V J F of the readings with the covariance V of the field, and with that of the white
    /// rest.
    parts: [DMatrix<f64>; 2],
    /// Effective degrees of freedom of both variances.
    degrees: [f64; 2],
}

/// A pose: its joint values and the rows of its readings.
struct Pose {
    joints: Vec<f64>,
    /// First row and number of readings.
    first: usize,
    readings: usize,
}

/// Rows along one axis, with one column for each parameter and the residuals as the last column:
/// sums over the readings of a pose.
struct Sums {
    axes: Vec<DMatrix<f64>>,
}

/// Variances and length with their −2 ln L.
#[derive(Clone, Copy)]
struct Estimate {
    improbability: f64,
    white: f64,
    ratio: f64,
    length: f64,
    /// Sum of the variances of the parameters from the field, relative to those of the columns.
    spread: f64,
}

impl Field {
    /// Field of residuals; the Jacobian has one row per residual. `None` if readings are not
    /// coordinates in one unit, or if no field is detected.
    pub fn new(problem: &Residuals, remaining: &Remaining) -> Option<Self> {
        let Remaining { residuals, jacobian, root } = remaining;
        let poses = poses(problem)?;
        let n = jacobian.len() / residuals.len();
        let dimension = problem.robot.dimension();
        let rows = Rows { residuals, jacobian, n, dimension };
        let sample = near_each_other(&poses);
        let sums = rows.sums(&sample, |p| 1.0 / (p.readings as f64).sqrt());
        let stated = rows.stated(problem.measured_count());
        let found = estimate(&sample, &sums, &stated)?;
        let least = problem.noise(None).powi(2);
        let (variance, white) = (found.ratio * found.white, found.white.max(least));

        let step = poses.len().div_ceil(SUMMED);
        let some: Vec<&Pose> = poses.iter().step_by(step).collect();
        // J F has orthogonal columns: sums of its squares keep the digits of all parameters
        let white_jacobian = transposed_times(root.as_view(), DMatrixView::from_slice(jacobian, n, residuals.len()));
        let rows = Rows { jacobian: white_jacobian.as_slice(), ..rows };
        let correlation = correlation(&some, found.length);
        let share = (poses.len() as f64 / some.len() as f64).powi(2);
        let mut of_field = DMatrix::zeros(n, n);
        for axis in rows.sums(&some, |_| 1.0).axes {
            let axis = axis.columns(0, n);
            of_field += transposed_times(axis, (&correlation * axis).as_view()) * (share * variance);
        }
        // means of a pose have the white variance, differences from these their own
        let all: Vec<&Pose> = poses.iter().collect();
        let means = rows.sums(&all, |p| 1.0 / (p.readings as f64).sqrt());
        let count = problem.measured_count();
        let differences = rows.differences(&means, count).max(least);
        let measured = white_jacobian.columns(0, count);
        let mut of_means = DMatrix::zeros(n, n);
        means.axes.iter().for_each(|axis| of_means += transposed_times(axis.columns(0, n), axis.columns(0, n)));
        let of_rest = (measured * measured.transpose() - &of_means) * differences + of_means * white;
        let degrees = degrees(&sample, &found, dimension, n);
        Some(Self { parts: [of_field, of_rest], degrees })
    }

    /// Covariance of the parameters from the readings, A⁻¹ Jᵀ V J A⁻¹ with A⁻¹ = F Fᵀ, and the
    /// effective degrees of freedom of each variance (Satterthwaite; GUM G.4.1).
    pub fn covariance(&self, root: &DMatrix<f64>) -> (Vec<f64>, Vec<f64>) {
        let parts = self.parts.each_ref().map(|part| carried(root, part));
        let degrees = |k: usize| {
            let [field, rest] = parts.each_ref().map(|part| part[(k, k)].max(0.0));
            (field + rest).powi(2) / (field.powi(2) / self.degrees[0] + rest.powi(2) / self.degrees[1])
        };
        ((&parts[0] + &parts[1]).as_slice().to_vec(), (0..root.nrows()).map(degrees).collect())
    }
}

/// Poses with readings; `None` if residuals are not coordinates, or have their own covariances.
fn poses(problem: &Residuals) -> Option<Vec<Pose>> {
    if !problem.is_coordinates() || problem.is_whitened() || problem.is_weighted() {
        return None;
    }
    let (joints, dimension) = (problem.robot.joints(), problem.robot.dimension());
    let mut row = 0;
    let mut all = Vec::new();
    for (values, rows) in problem.coordinate_rows() {
        if rows > 0 {
            all.push(Pose { joints: values[..joints.len()].to_vec(), first: row, readings: rows / dimension });
        }
        row += rows;
    }
    let sliding = (0..joints.len()).filter(|&j| joints[j].quantity == Quantity::Length);
    for j in sliding {
        let end = |pick: fn(f64, f64) -> f64| all.iter().map(|p| p.joints[j]).reduce(pick).unwrap_or(0.0);
        let half = 0.5 * (end(f64::max) - end(f64::min));
        all.iter_mut().for_each(|p| p.joints[j] /= if half > 0.0 { half } else { 1.0 });
    }
    (all.len() >= FEWEST).then_some(all)
}

/// Subset of many poses that is spread over all poses, each with its nearest neighbour: it shows
/// both length scales and noise.
fn near_each_other(poses: &[Pose]) -> Vec<&Pose> {
    if poses.len() <= ESTIMATED_FROM {
        return poses.iter().collect();
    }
    let step = poses.len().div_ceil(ESTIMATED_FROM / 2);
    let mut taken = vec![false; poses.len()];
    (0..poses.len()).step_by(step).for_each(|k| taken[k] = true);
    for k in (0..poses.len()).step_by(step) {
        let others = (0..poses.len()).filter(|&j| !taken[j]).map(|j| (distance(&poses[k], &poses[j]), j));
        if let Some((_, nearest)) = others.min_by(|a, b| a.0.total_cmp(&b.0)) {
            taken[nearest] = true;
        }
    }
    poses.iter().zip(taken).filter(|(_, taken)| *taken).map(|(pose, _)| pose).collect()
}

fn distance(a: &Pose, b: &Pose) -> f64 {
    a.joints.iter().zip(&b.joints).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

fn correlation(poses: &[&Pose], length: f64) -> DMatrix<f64> {
    let mut all = DMatrix::identity(poses.len(), poses.len());
    for (i, j) in (0..poses.len()).flat_map(|j| (0..j).map(move |i| (i, j))) {
        let d = 3f64.sqrt() * distance(poses[i], poses[j]) / length;
        (all[(i, j)], all[(j, i)]) = ((1.0 + d) * (-d).exp(), (1.0 + d) * (-d).exp());
    }
    all
}

/// All residuals and their Jacobian.
struct Rows<'a> {
    residuals: &'a [f64],
    jacobian: &'a [f64],
    n: usize,
    dimension: usize,
}

impl Rows<'_> {
    /// Sums of the rows of each pose along each axis, times what `scale` gives.
    fn sums(&self, poses: &[&Pose], scale: impl Fn(&Pose) -> f64) -> Sums {
        let n = self.n;
        let mut axes = vec![DMatrix::zeros(poses.len(), n + 1); self.dimension];
        for (i, pose) in poses.iter().enumerate() {
            let scale = scale(pose);
            for (k, row) in (pose.first..pose.first + pose.readings * self.dimension).enumerate() {
                let axis = &mut axes[k % self.dimension];
                let here = &self.jacobian[row * n..][..n];
                here.iter().enumerate().for_each(|(j, v)| axis[(i, j)] += scale * v);
                axis[(i, n)] += scale * self.residuals[row];
            }
        }
        Sums { axes }
    }

    /// Rows after the readings: stated values and nominal values.
    fn stated(&self, measured: usize) -> DMatrix<f64> {
        let count = self.residuals.len() - measured;
        let of = |i: usize, j: usize| match j {
            j if j < self.n => self.jacobian[(measured + i) * self.n + j],
            _ => self.residuals[measured + i],
        };
        DMatrix::from_fn(count, self.n + 1, of)
    }

    /// Variance of readings about the means of their poses; 0 with one reading per pose.
    fn differences(&self, means: &Sums, measured: usize) -> f64 {
        let of_means: f64 = means.axes.iter().map(|axis| axis.column(self.n).norm_squared()).sum();
        let rows = measured - means.axes.iter().map(DMatrix::nrows).sum::<usize>();
        let squares: f64 = self.residuals[..measured].iter().map(|r| r * r).sum();
        if rows > 0 { (squares - of_means).max(0.0) / rows as f64 } else { 0.0 }
    }
}

/// The estimate of largest restricted likelihood; `None` if white residuals are equally probable.
fn estimate(poses: &[&Pose], sums: &Sums, stated: &DMatrix<f64>) -> Option<Estimate> {
    let readings: Vec<f64> = poses.iter().map(|p| (p.readings as f64).sqrt()).collect();
    let white = improbability(&DVector::zeros(poses.len()), sums, stated)?;
    let n = stated.ncols() - 1;
    let squares: Vec<f64> = (0..n)
        .map(|k| sums.axes.iter().map(|axis| axis.column(k).norm_squared()).sum::<f64>().max(f64::MIN_POSITIVE))
        .collect();
    let of_length = |&length: &f64| {
        let correlation = correlation(poses, length);
        let of_axis = |axis: &DMatrix<f64>| -> f64 {
            let moved = &correlation * axis.columns(0, n);
            (0..n).map(|k| moved.column(k).dot(&axis.column(k)) / squares[k]).sum()
        };
        let spread: f64 = sums.axes.iter().map(of_axis).sum();
        let shared = DMatrix::from_fn(poses.len(), poses.len(), |i, j| readings[i] * readings[j] * correlation[(i, j)]);
        let most = EIGEN_STEPS * poses.len();
        let Some(SymmetricEigen { eigenvectors, eigenvalues }) = SymmetricEigen::try_new(shared, f64::EPSILON, most)
        else {
            return Vec::new();
        };
        let turned = |axis: &DMatrix<f64>| transposed_times(eigenvectors.as_view(), axis.as_view());
        let turned = Sums { axes: sums.axes.iter().map(turned).collect() };
        let of_ratio = |&ratio: &f64| {
            let (improbability, white) = improbability(&(&eigenvalues * ratio), &turned, stated)?;
            Some(Estimate { improbability, white, ratio, length, spread: ratio * white * spread })
        };
        RATIOS.iter().filter_map(of_ratio).collect::<Vec<Estimate>>()
    };
    let all: Vec<Estimate> = LENGTHS.par_iter().flat_map_iter(of_length).collect();
    let best = all.iter().min_by(|a, b| a.improbability.total_cmp(&b.improbability))?;
    if white.0 - best.improbability <= SIGNIFICANT {
        return None;
    }
    // of those that are as probable but for chance, the one that leaves most uncertain
    let as_probable = all.iter().filter(|e| e.improbability <= best.improbability + AS_PROBABLE);
    as_probable.max_by(|a, b| a.spread.total_cmp(&b.spread)).copied()
}

/// −2 ln of the restricted likelihood without a constant, and the variance of a white residual at
/// its maximum. The rows of `sums` are along the eigenvectors of the covariance of the field;
/// `shared` are its eigenvalues relative to the white variance.
fn improbability(shared: &DVector<f64>, sums: &Sums, stated: &DMatrix<f64>) -> Option<(f64, f64)> {
    let (poses, n) = (shared.len(), stated.ncols() - 1);
    let variances = shared.map(|v| 1.0 + v.max(0.0));
    let weights = variances.map(|v| 1.0 / v.sqrt());
    let mut normal = transposed_times(stated.as_view(), stated.as_view());
    for axis in &sums.axes {
        let white = DMatrix::from_fn(poses, n + 1, |i, k| axis[(i, k)] * weights[i]);
        normal += transposed_times(white.as_view(), white.as_view());
    }
    let information = Cholesky::new(normal.view((0, 0), (n, n)).into_owned())?;
    let right = normal.view((0, n), (n, 1)).into_owned();
    let squares = normal[(n, n)] - right.dot(&information.solve(&right));
    let degrees = (poses * sums.axes.len() + stated.nrows()) as f64 - n as f64;
    let of_information = 2.0 * information.l_dirty().diagonal().iter().map(|v| v.ln()).sum::<f64>();
    let of_field = variances.iter().map(|v| v.ln()).sum::<f64>();
    let determinants = sums.axes.len() as f64 * of_field + of_information;
    let white = squares / degrees;
    (degrees >= 1.0 && white > 0.0).then(|| (degrees * white.ln() + determinants, white))
}

/// Effective degrees of freedom of the variance of the field and of the white residuals: twice the
/// information on its logarithm.
fn degrees(poses: &[&Pose], found: &Estimate, dimension: usize, parameters: usize) -> [f64; 2] {
    let correlation = correlation(poses, found.length) * found.ratio;
    let eigen = correlation.symmetric_eigenvalues();
    let of_field: f64 = eigen.iter().map(|v| (v / (1.0 + v)).powi(2)).sum();
    let of_rest = (poses.len() * dimension) as f64 - parameters as f64;
    [(dimension as f64 * of_field).max(1.0), of_rest.max(1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn poses(readings: usize) -> Vec<Pose> {
        (0..4).map(|i| Pose { joints: vec![0.1 * i as f64], first: readings * i, readings }).collect()
    }

    /// Information of a mean of white readings: 3 ln s² + ln 4 with s² = 10/3. If all share half of
    /// their variance, V = s² (I + 11ᵀ), ln |I + 11ᵀ| = ln 5, and the mean has the information 4/5.
    #[test]
    fn the_restricted_likelihood_of_a_mean_by_hand() {
        let (residuals, jacobian) = ([1.0, -1.0, 2.0, -2.0], [1.0; 4]);
        let rows = Rows { residuals: &residuals, jacobian: &jacobian, n: 1, dimension: 1 };
        let all = poses(1);
        let sums = rows.sums(&all.iter().collect::<Vec<_>>(), |_| 1.0);
        let none = rows.stated(4);
        for (shared, determinants) in [(0.0, 4f64.ln()), (1.0, 5f64.ln() + 0.8f64.ln())] {
            let SymmetricEigen { eigenvectors, eigenvalues } = DMatrix::from_element(4, 4, shared).symmetric_eigen();
            let turned = Sums { axes: sums.axes.iter().map(|axis| eigenvectors.tr_mul(axis)).collect() };
            let (improbability, white) = improbability(&eigenvalues, &turned, &none).unwrap();
            assert!((white - 10.0 / 3.0).abs() < 1e-12, "{white}");
            assert!((improbability - 3.0 * (10f64 / 3.0).ln() - determinants).abs() < 1e-12, "{improbability}");
        }
    }

    /// Two readings of each pose that differ by 2: variance 2 about the means.
    #[test]
    fn differences_within_poses_by_hand() {
        let (residuals, jacobian) = ([1.0, -1.0, 2.0, 0.0, 5.0, 3.0, 0.0, -2.0], [1.0; 8]);
        let rows = Rows { residuals: &residuals, jacobian: &jacobian, n: 1, dimension: 1 };
        let all = poses(2);
        let means = rows.sums(&all.iter().collect::<Vec<_>>(), |p| 1.0 / (p.readings as f64).sqrt());
        assert!((rows.differences(&means, 8) - 2.0).abs() < 1e-12);
    }
}
