//! Covariance from residuals with errors common to a cluster: a pose, a region of joint space, or a
//! reading.

use crate::model::elimination::{carried, transposed_times};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rayon::prelude::*;
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::collections::BTreeMap;

/// Maximum remaining share of a direction of the parameters without a cluster that determines it
/// alone.
const REST: f64 = 0.01;
/// Degrees of freedom that are too few: Student's t has no standard deviation.
const TOO_FEW: f64 = 2.0;
/// Minimum number of clusters at which a test by their scatter keeps its significance level
/// (Cameron & Miller 2015, section VI).
const ENOUGH: usize = 30;
/// Number of clusters that are in memory at once.
const AT_ONCE: usize = 64;
/// Significance level of the test for common errors.
const REJECT: f64 = 0.01;

/// Uncertainty of the parameters from the scatter of clusters.
pub(crate) struct ByCluster {
    /// Covariance of the parameters, row by row.
    pub covariance: Vec<f64>,
    /// Effective degrees of freedom of each variance.
    pub degrees_of_freedom: Vec<f64>,
    /// Mean over all directions of the variance of the parameters, relative to the variance of
    /// independent residuals of unit variance.
    pub ratio: f64,
    /// Variance of this ratio for independent residuals.
    ratio_variance: f64,
    clusters: usize,
}

impl ByCluster {
    /// From the rows of the Jacobian J, their residuals and F with F Fᵀ = A⁻¹, which is `root`.
    /// Delete-a-group jackknife to first order: A⁻¹ (Σ hₚ hₚᵀ) A⁻¹ with A = JᵀJ and hₚ = Jₚᵀ (I −
    /// Hₚ)^-½ rₚ, where Hₚ = Jₚ A⁻¹ Jₚᵀ is the part of the hat matrix of one cluster: unbiased for
    /// independent residuals, which the fit makes smaller than errors. The degrees of freedom
    /// belong to a multiple of chi-square with the same mean and variance (Bell & McCaffrey 2002;
    /// CR2 in Imbens & Kolesár 2016). `None` where one cluster determines some direction of the
    /// parameters alone.
    pub fn new<C: Copy + Ord>(
        clusters: &[C],
        root: &DMatrix<f64>,
        residuals: &[f64],
        jacobian: &[f64],
    ) -> Option<Self> {
        let n = root.nrows();
        let mut rows: BTreeMap<C, Vec<usize>> = BTreeMap::new();
        clusters.iter().enumerate().for_each(|(row, cluster)| rows.entry(*cluster).or_default().push(row));
        let rows: Vec<Vec<usize>> = rows.into_values().collect();
        let mut steps = DMatrix::zeros(n, n); // Fᵀ (Σ hₚ hₚᵀ) F
        let mut grams = vec![DMatrix::zeros(n, n); n];
        let mut own = vec![0.0; n];
        let (mut squares, mut fourths, mut expected) = (DMatrix::zeros(n, n), 0.0, 0.0);
        for some in rows.chunks(AT_ONCE) {
            let part = |rows: &Vec<usize>| {
                let part = DMatrix::from_fn(rows.len(), n, |i, j| jacobian[rows[i] * n + j]) * root;
                Part::new(part, DVector::from_fn(rows.len(), |i, _| residuals[rows[i]]), root)
            };
            let parts: Vec<Part> = some.par_iter().map(part).collect::<Option<_>>()?;
            for part in &parts {
                steps.ger(1.0, &part.step, &part.step, 1.0);
                squares += transposed_times(part.square_root.as_view(), part.square_root.as_view());
                fourths += part.fourths;
                expected += part.leverage;
                own.iter_mut().zip(&part.own).for_each(|(own, more)| *own += more);
            }
            grams.par_iter_mut().enumerate().for_each(|(i, gram)| {
                let weights: Vec<_> = parts.iter().map(|part| part.weights.column(i)).collect();
                let weights = DMatrix::from_columns(&weights);
                gram.gemm(1.0, &weights, &weights.transpose(), 1.0);
            });
        }
        let covariance = carried(root, &steps);
        let degrees = |i: usize| root.row(i).norm_squared().powi(2) / (own[i] + grams[i].norm_squared());
        Some(Self {
            covariance: covariance.as_slice().to_vec(),
            degrees_of_freedom: (0..n).map(degrees).collect(),
            ratio: steps.trace() / expected,
            clusters: rows.len(),
            ratio_variance: 2.0 * (fourths + squares.norm_squared()) / (expected * expected),
        })
    }

    /// `true` if there are enough clusters for a variance of every parameter.
    pub fn is_usable(&self) -> bool {
        self.degrees_of_freedom.iter().all(|d| *d > TOO_FEW)
    }

    /// `true` if the ratio exceeds the 99 % quantile for independent residuals; few clusters have
    /// no power.
    pub fn exceeds(&self) -> bool {
        let degrees = 2.0 / self.ratio_variance;
        self.clusters >= ENOUGH && ChiSquared::new(degrees).is_ok_and(|d| d.sf(self.ratio * degrees) < REJECT)
    }
}

/// Contribution of one cluster, in the coordinates in which A is the identity. With Q = Jₚ F its
/// matrices are functions of K = QᵀQ. They are computed from the same functions of QQᵀ, which has
/// as many rows as the cluster.
struct Part {
    /// Fᵀ hₚ.
    step: DVector<f64>,
    /// S with SᵀS = K² (1 − K)⁻¹.
    square_root: DMatrix<f64>,
    /// Trace of its part of the hat matrix.
    leverage: f64,
    /// Contribution of its squared residuals to the fourth moments.
    fourths: f64,
    /// K (1 − K)^-½ Fᵀ.
    weights: DMatrix<f64>,
    /// Contribution to the fourth moments of the variance of each parameter.
    own: Vec<f64>,
}

impl Part {
    /// Contribution of the rows `q` with residuals `r`; `None` if they alone determine some
    /// direction.
    fn new(mut q: DMatrix<f64>, mut r: DVector<f64>, root: &DMatrix<f64>) -> Option<Self> {
        if q.nrows() > q.ncols() {
            // of many rows the factor has the same products
            let qr = q.qr();
            qr.q_tr_mul(&mut r);
            (q, r) = (qr.r(), r.rows(0, root.nrows()).into_owned());
        }
        let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(&q * q.transpose());
        if eigenvalues.iter().any(|k| 1.0 - k < REST) {
            return None;
        }
        let scaled = |by: fn(f64) -> f64, rows: &DMatrix<f64>| {
            DMatrix::from_fn(rows.nrows(), rows.ncols(), |i, j| by(eigenvalues[i].max(0.0)) * rows[(i, j)])
        };
        let along = transposed_times(eigenvectors.as_view(), q.as_view());
        let of_parameters = &along * root.transpose();
        let less = |k: f64| 1.0 / (1.0 - k).sqrt();
        let residuals = eigenvectors.tr_mul(&r);
        let weights = transposed_times(along.as_view(), scaled(less, &of_parameters).as_view());
        let squares: f64 = eigenvalues.iter().map(|k| k * k - (k * k / (1.0 - k)).powi(2)).sum();
        let own = (0..root.nrows())
            .map(|i| of_parameters.column(i).norm_squared().powi(2) - weights.column(i).norm_squared().powi(2));
        Some(Self {
            step: along.tr_mul(&DVector::from_fn(residuals.len(), |i, _| less(eigenvalues[i]) * residuals[i])),
            square_root: scaled(|k| (k / (1.0 - k)).sqrt(), &along),
            leverage: eigenvalues.sum(),
            fourths: squares,
            own: own.collect(),
            weights,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_math::{Options, Problem, Solution, solve};

    fn root(solution: &Solution) -> DMatrix<f64> {
        crate::model::elimination::root(solution).unwrap()
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

    /// The variance of a mean of single readings is s²/n with n − 1 degrees of freedom; for pairs
    /// of equal readings it is that of the pairs.
    #[test]
    fn the_variance_of_a_mean_by_hand() {
        let (single, twice) = ([1.0, 2.0, 4.0, 9.0], [1.0, 1.0, 2.0, 2.0, 4.0, 4.0, 9.0, 9.0]);
        for (readings, clusters) in [(&single[..], vec![0, 1, 2, 3]), (&twice[..], vec![0, 0, 1, 1, 2, 2, 3, 3])] {
            let solution = solve(&Mean(readings), &[0.0], Options::default());
            let found =
                ByCluster::new(&clusters, &root(&solution), &solution.residuals, &vec![1.0; readings.len()]).unwrap();
            let variance = (9.0 + 4.0 + 0.0 + 25.0) / 3.0;
            assert!((found.covariance[0] - variance / 4.0).abs() < 1e-12, "{}", found.covariance[0]);
            assert!((found.degrees_of_freedom[0] - 3.0).abs() < 1e-12 && found.is_usable());
            assert!((found.ratio - readings.len() as f64 * variance / 4.0).abs() < 1e-12);
            assert!(!found.exceeds(), "four clusters are too few");
        }
        let solution = solve(&Mean(&single), &[0.0], Options::default());
        assert!(
            ByCluster::new(&[0; 4], &root(&solution), &solution.residuals, &[1.0; 4]).is_none(),
            "one cluster determines the mean alone"
        );
    }
}
