//! Weights of components with variances of largest restricted likelihood.

use nalgebra::{Cholesky, DMatrix, DVector};

/// Number of steps in which variances are estimated.
const STEPS: usize = 40;
/// Minimum variance of a component relative to its start.
const VANISHED: f64 = 1e-9;

/// Weights of components.
#[derive(Clone, Debug)]
pub(super) struct Solved {
    /// Independent weights.
    pub weights: DVector<f64>,
    /// Their covariance.
    pub covariance: DMatrix<f64>,
    /// Prior standard deviation of each component (rad or mm).
    pub priors: Vec<f64>,
    /// Variance of a white residual (mm²).
    pub white: f64,
    /// −2 ln of the restricted likelihood without a constant.
    pub improbability: f64,
    /// Mean variance of each component at the rows, relative to the white variance.
    pub effects: Vec<f64>,
}

/// −2 ln of the restricted likelihood of white residuals without a constant.
pub(super) fn white_improbability(squares: f64, degrees: f64) -> f64 {
    degrees * (squares / degrees).ln() + degrees
}

/// Estimates weights and variances of components with `sizes` columns each. Columns and residuals
/// are projected. Variances follow MacKay's fixed point (1992, Neural Comput. 4, 415). `None` if
/// the equations are singular.
pub(super) fn solve(columns: &DMatrix<f64>, sizes: &[usize], residuals: &DVector<f64>, degrees: f64) -> Option<Solved> {
    let gram = columns.tr_mul(columns);
    let right = columns.tr_mul(residuals);
    let squares = residuals.norm_squared();
    let m = gram.nrows();
    let owner: Vec<usize> = sizes.iter().enumerate().flat_map(|(c, &size)| vec![c; size]).collect();
    let power = |c: usize| (0..m).filter(|&k| owner[k] == c).map(|k| gram[(k, k)]).sum::<f64>();
    let start: Vec<f64> = (0..sizes.len()).map(|c| 0.5 * squares / power(c) / sizes.len() as f64).collect();
    let (mut variances, mut white) = (start.clone(), 0.5 * squares / degrees);
    let mut found = None;
    for _ in 0..STEPS {
        let mut information = &gram / white;
        (0..m).for_each(|k| information[(k, k)] += 1.0 / variances[owner[k]]);
        let root = Cholesky::new(information)?;
        let covariance = root.inverse();
        let weights = &covariance * &right / white;
        let log: f64 = root.l_dirty().diagonal().iter().map(|v| 2.0 * v.ln()).sum();
        let log = log + owner.iter().map(|&c| variances[c].ln()).sum::<f64>();
        let quadratic = (squares - right.dot(&weights)) / white;
        let improbability = degrees * white.ln() + log + quadratic;
        let priors = variances.iter().map(|v| v.sqrt()).collect();
        let effect = |(c, s2): (usize, &f64)| power(c) * s2 / degrees / white;
        let effects = variances.iter().enumerate().map(effect).collect();
        let (weights_now, covariance_now) = (weights.clone(), covariance.clone());
        found =
            Some(Solved { weights: weights_now, covariance: covariance_now, priors, white, improbability, effects });
        let left = squares - 2.0 * right.dot(&weights) + weights.dot(&(&gram * &weights));
        let mut determined = 0.0;
        for (c, variance) in variances.iter_mut().enumerate() {
            let own = || (0..m).filter(|&k| owner[k] == c);
            let of_data = sizes[c] as f64 - own().map(|k| covariance[(k, k)]).sum::<f64>() / *variance;
            determined += of_data;
            *variance = own().map(|k| weights[k].powi(2)).sum::<f64>() / of_data.max(1e-3);
            *variance = variance.max(VANISHED * start[c]);
        }
        white = (left / (degrees - determined).max(1.0)).max(f64::MIN_POSITIVE);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One component of two orthonormal columns among ten residuals: the weights are shrunk by
    /// s²/(s² + σ²), and the likelihood is that of two Gaussian variables of variance s² + σ² and
    /// eight of variance σ².
    #[test]
    fn two_orthonormal_columns_by_hand() {
        let columns = DMatrix::from_fn(10, 2, |i, k| if i == k { 1.0 } else { 0.0 });
        let residuals = DVector::from_vec(vec![5.0, -3.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0]);
        let found = solve(&columns, &[2], &residuals, 10.0).expect("solved");
        // s² + σ² = (25 + 9)/2, σ² = 1
        let s2 = found.priors[0].powi(2);
        assert!((found.white - 1.0).abs() < 1e-3 && (s2 - 16.0).abs() < 1e-2, "{s2} {}", found.white);
        assert!((found.weights[0] - 5.0 * 16.0 / 17.0).abs() < 1e-2);
        let by_hand = 2.0 * 17f64.ln() + 34.0 / 17.0 + 8.0;
        assert!((found.improbability - by_hand).abs() < 1e-3, "{} {by_hand}", found.improbability);
    }
}
