//! Sums of squares of residuals over their variance: their probability, and the probability that a
//! change increases them.

use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor, StudentsT};
use statrs::function::{beta::beta_reg, gamma::gamma_lr};

/// Source of the variance of the residuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Variance {
    /// Given: sums of squares follow chi-square.
    Stated,
    /// Estimated with these degrees of freedom: ratios of sums of squares follow F.
    Estimated(f64),
    /// Estimated from residuals with a smooth misfit: their squares scatter more than the squares
    /// of noise.
    Misfit {
        /// Effective degrees of freedom.
        degrees: f64,
        /// Effective degrees of freedom of a square.
        share: f64,
    },
}

impl Variance {
    /// Probability that `dof` squares of a correct model exceed `sum`.
    pub fn exceedance(self, sum: f64, dof: usize) -> f64 {
        let k = dof as f64;
        match self {
            _ if dof == 0 => 1.0,
            Self::Stated => ChiSquared::new(k).map_or(f64::NAN, |d| d.sf(sum)),
            Self::Estimated(nu) | Self::Misfit { degrees: nu, .. } => ratio_exceedance(sum / k, k, nu),
        }
    }

    /// Probability as in [`Self::exceedance`] of squares of single residuals, not of changes that
    /// are sums over many of them.
    pub fn exceedance_of_residuals(self, sum: f64, dof: usize) -> f64 {
        let k = dof as f64;
        match self {
            Self::Misfit { degrees, share } if dof > 0 => ratio_exceedance(sum / k, share * k, degrees),
            _ => self.exceedance(sum, dof),
        }
    }

    /// The sum of `dof` squares that a correct model exceeds with `probability`.
    pub fn bound(self, probability: f64, dof: usize) -> f64 {
        bisect(|sum| self.exceedance(sum, dof) < probability)
    }

    /// Probability that a change exceeds `bound`, which adds `noncentrality` to the expected sum of
    /// `dof` squares: noncentral chi-square or F, as a mixture of central ones by Poisson weights
    /// (Johnson, Kotz & Balakrishnan, Continuous Univariate Distributions 2, 29.3 and 30.3).
    pub fn power(self, bound: f64, dof: usize, noncentrality: f64) -> f64 {
        let half = 0.5 * noncentrality;
        let below = |j: f64| {
            let a = 0.5 * dof as f64 + j;
            match self {
                Self::Stated => gamma_lr(a, 0.5 * bound),
                Self::Estimated(nu) | Self::Misfit { degrees: nu, .. } => beta_reg(a, 0.5 * nu, bound / (bound + nu)),
            }
        };
        // weights from the largest, both ways, until they no longer count
        let middle = half.floor();
        let weight = |j: f64| (j * half.ln() - half - statrs::function::gamma::ln_gamma(j + 1.0)).exp();
        if half == 0.0 {
            return 1.0 - below(0.0);
        }
        let up = (0..).map(|i| middle + f64::from(i));
        let down = (1..).map(|i| middle - f64::from(i)).take_while(|j| *j >= 0.0);
        let sum = |all: &mut dyn Iterator<Item = f64>| {
            all.map(|j| (weight(j), j)).take_while(|(w, _)| *w > 1e-14).map(|(w, j)| w * below(j)).sum::<f64>()
        };
        1.0 - sum(&mut { up }) - sum(&mut { down })
    }
}

/// Returns the probability that a ratio of variances with these degrees of freedom exceeds `ratio`.
fn ratio_exceedance(ratio: f64, above: f64, below: f64) -> f64 {
    FisherSnedecor::new(above, below).map_or(f64::NAN, |d| d.sf(ratio.max(0.0)))
}

/// Probabilities of a family of tests, corrected for their number (Holm 1979): whatever the
/// dependence of the tests, no unchanged quantity is called changed with 95 %. In the order of `p`.
pub fn holm(p: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..p.len()).collect();
    order.sort_by(|&a, &b| p[a].total_cmp(&p[b]));
    let mut corrected = vec![1.0; p.len()];
    let mut largest = 0.0f64;
    for (rank, &i) in order.iter().enumerate() {
        largest = largest.max((p.len() - rank) as f64 * p[i]).min(1.0);
        corrected[i] = largest;
    }
    corrected
}

/// Smallest non-negative number for which the condition holds, as it does for all larger ones.
pub(crate) fn bisect(holds: impl Fn(f64) -> bool) -> f64 {
    let mut upper = 1.0;
    while !holds(upper) {
        upper *= 2.0;
        if upper > 1e30 {
            return f64::INFINITY;
        }
    }
    let mut lower = 0.0;
    for _ in 0..100 {
        let middle = 0.5 * (lower + upper);
        if holds(middle) { upper = middle } else { lower = middle }
    }
    upper
}

/// Minimum number of poses for [`exceeds_zero`].
const FEWEST_POSES: usize = 5;
/// Probability that noise alone exceeds zero, for k = 2.
const BY_CHANCE: f64 = 0.02275;

/// `true` if the mean of independent differences, one of each pose, is above zero by more than
/// noise (paired t test, one-sided, with the level of k = 2); `false` with fewer than five poses.
pub fn exceeds_zero(differences: &[f64]) -> bool {
    let n = differences.len() as f64;
    if differences.len() < FEWEST_POSES {
        return false;
    }
    let mean = differences.iter().sum::<f64>() / n;
    let square = differences.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / (n - 1.0);
    let Ok(student) = StudentsT::new(0.0, 1.0, n - 1.0) else { return false };
    mean > student.inverse_cdf(1.0 - BY_CHANCE) * (square / n).sqrt() && mean > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of R 4: qchisq, qf, pchisq and pf with ncp.
    #[test]
    fn tables() {
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
        near(Variance::Stated.bound(0.05, 1), 3.841458820694124);
        near(Variance::Stated.bound(0.05, 10), 18.307038053275146);
        near(Variance::Estimated(20.0).bound(0.05, 1), 4.351243503322893);
        // of one square, the noncentral distribution is that of a shifted normal one
        let normal = |z: f64| 0.5 * statrs::function::erf::erfc(-z / 2f64.sqrt());
        for (bound, noncentrality) in [(3.84, 0.5), (3.84, 12.9), (10.0, 400.0)] {
            let (z, shift) = (f64::sqrt(bound), f64::sqrt(noncentrality));
            let expected = 1.0 - normal(z - shift) + normal(-z - shift);
            near(Variance::Stated.power(bound, 1, noncentrality), expected);
        }
        // an estimate with many degrees of freedom is as good as a statement
        let [stated, estimated] = [Variance::Stated, Variance::Estimated(1e7)].map(|v| v.power(12.0, 6, 9.0));
        assert!((stated - estimated).abs() < 1e-5, "{stated} {estimated}");
        near(Variance::Stated.power(12.0, 6, 0.0), Variance::Stated.exceedance(12.0, 6));
    }
}
