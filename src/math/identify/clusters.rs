//! Covariance from residuals of which those of one cluster have errors in common: a pose, a region of the joints, a reading.

use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::collections::BTreeMap;

/// A cluster without which this little of a direction of the parameters is left determines it alone.
const REST: f64 = 0.01;
/// Effective degrees of freedom that are too few: Student's t has no standard deviation.
const TOO_FEW: f64 = 2.0;
/// Clusters from which a test by their scatter keeps its probability (Cameron & Miller 2015, section VI).
const ENOUGH: usize = 30;
/// Probability with which independent residuals are taken for such that have errors in common.
const REJECT: f64 = 0.01;

/// What the scatter of clusters shows of the parameters' uncertainty.
pub(super) struct ByCluster {
    /// Covariance of the parameters, row by row.
    pub covariance: Vec<f64>,
    /// Effective degrees of freedom of each variance.
    pub degrees_of_freedom: Vec<f64>,
    /// Variance of the parameters, in the mean over all directions, to that of independent residuals of unit variance.
    pub ratio: f64,
    /// Variance of this ratio where residuals are so.
    ratio_variance: f64,
    clusters: usize,
}

impl ByCluster {
    /// From the rows of the Jacobian J, their residuals and A⁻¹, which is `inverse`. Delete-a-group jackknife to first order: A⁻¹ (Σ hₚ hₚᵀ) A⁻¹ with A = JᵀJ and hₚ = Jₚᵀ (I − Hₚ)^-½ rₚ, where Hₚ = Jₚ A⁻¹ Jₚᵀ is the
    /// part of the hat matrix of one cluster: unbiased for independent residuals, which the fit makes smaller than errors. Degrees of
    /// freedom are those of a multiple of chi-square with the same mean and variance (Bell & McCaffrey 2002; CR2 in Imbens & Kolesár
    /// 2016). `None` where one cluster determines some direction of the parameters alone.
    pub fn new<C: Copy + Ord>(clusters: &[C], inverse: &[f64], residuals: &[f64], jacobian: &[f64]) -> Option<Self> {
        let n = inverse.len().isqrt();
        let root = Cholesky::new(DMatrix::from_row_slice(n, n, inverse))?.unpack(); // F, with F Fᵀ = A⁻¹
        let mut rows: BTreeMap<C, Vec<usize>> = BTreeMap::new();
        clusters.iter().enumerate().for_each(|(row, cluster)| rows.entry(*cluster).or_default().push(row));
        let mut steps = DMatrix::zeros(n, n); // Fᵀ (Σ hₚ hₚᵀ) F
        let mut grams = vec![DMatrix::zeros(n, n); n];
        let mut own = vec![0.0; n];
        let (mut squares, mut fourths) = (DMatrix::zeros(n, n), 0.0);
        for rows in rows.values() {
            let part = DMatrix::from_fn(rows.len(), n, |i, j| jacobian[rows[i] * n + j]) * &root;
            let r = DVector::from_fn(rows.len(), |i, _| residuals[rows[i]]);
            let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(part.tr_mul(&part)); // K = Fᵀ JₚᵀJₚ F
            if eigenvalues.iter().any(|k| 1.0 - k < REST) {
                return None;
            }
            let of = |f: fn(f64) -> f64| {
                let scaled = DMatrix::from_fn(n, n, |i, j| eigenvectors[(i, j)] * f(eigenvalues[j]));
                scaled * eigenvectors.transpose()
            };
            let step = of(|k| 1.0 / (1.0 - k).sqrt()) * part.tr_mul(&r);
            steps += &step * step.transpose();
            let square = of(|k| k * k / (1.0 - k));
            fourths += eigenvalues.map(|k| k * k).sum() - square.norm_squared();
            squares += square;
            let (weights, seen) = (of(|k| k / (1.0 - k).sqrt()) * root.transpose(), of(|k| k) * root.transpose());
            for i in 0..n {
                let weight = weights.column(i);
                grams[i] += weight * weight.transpose();
                own[i] += root.row(i).transpose().dot(&seen.column(i)).powi(2) - weight.norm_squared().powi(2);
            }
        }
        let covariance = &root * &steps * root.transpose();
        let degrees = |i: usize| root.row(i).norm_squared().powi(2) / (own[i] + grams[i].norm_squared());
        Some(Self {
            covariance: covariance.as_slice().to_vec(),
            degrees_of_freedom: (0..n).map(degrees).collect(),
            ratio: steps.trace() / n as f64,
            clusters: rows.len(),
            ratio_variance: 2.0 * (fourths + squares.norm_squared()) / (n * n) as f64,
        })
    }

    /// Whether there are clusters enough for a variance of every parameter.
    pub fn is_usable(&self) -> bool {
        self.degrees_of_freedom.iter().all(|d| *d > TOO_FEW)
    }

    /// Whether the ratio is larger than that of independent residuals is once in a hundred times; of few clusters it does not show.
    pub fn exceeds(&self) -> bool {
        let degrees = 2.0 / self.ratio_variance;
        self.clusters >= ENOUGH && ChiSquared::new(degrees).is_ok_and(|d| d.sf(self.ratio * degrees) < REJECT)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::solve::{Options, Problem, Solution, solve};

    fn inverse(solution: &Solution) -> Vec<f64> {
        solution.covariance().unwrap()
    }

    /// A mean of readings.
    struct Mean<'a>(&'a [f64]);

    impl Problem for Mean<'_> {
        fn residual_count(&self) -> usize {
            self.0.len()
        }
        fn residuals(&self, x: &[f64], r: &mut [f64]) {
            r.iter_mut().zip(self.0).for_each(|(r, reading)| *r = x[0] - reading);
        }
        fn jacobian(&self, _: &[f64], jacobian: &mut [f64]) {
            jacobian.fill(1.0);
        }
    }

    /// Of single readings the variance of a mean is s²/n with n − 1 degrees of freedom; of pairs that are alike it is that of the pairs.
    #[test]
    fn the_variance_of_a_mean_by_hand() {
        let (single, twice) = ([1.0, 2.0, 4.0, 9.0], [1.0, 1.0, 2.0, 2.0, 4.0, 4.0, 9.0, 9.0]);
        for (readings, clusters) in [(&single[..], vec![0, 1, 2, 3]), (&twice[..], vec![0, 0, 1, 1, 2, 2, 3, 3])] {
            let solution = solve(&Mean(readings), &[0.0], Options::default());
            let found = ByCluster::new(&clusters, &inverse(&solution), &solution.residuals, &vec![1.0; readings.len()])
                .unwrap();
            let variance = (9.0 + 4.0 + 0.0 + 25.0) / 3.0;
            assert!((found.covariance[0] - variance / 4.0).abs() < 1e-12, "{}", found.covariance[0]);
            assert!((found.degrees_of_freedom[0] - 3.0).abs() < 1e-12 && found.is_usable());
            assert!((found.ratio - readings.len() as f64 * variance / 4.0).abs() < 1e-12);
            assert!(!found.exceeds(), "four clusters are too few");
        }
        let solution = solve(&Mean(&single), &[0.0], Options::default());
        assert!(
            ByCluster::new(&[0; 4], &inverse(&solution), &solution.residuals, &[1.0; 4]).is_none(),
            "one cluster determines the mean alone"
        );
    }
}
