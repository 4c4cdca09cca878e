//! A determination that was repeated.

use super::readings::Readings;
use super::uncertain::Uncertain;
use crate::math::identify::chi_square_exceeds;

/// Mean and standard deviation (n − 1; zero of a single value) of values; `None` without any.
pub fn mean_and_deviation(values: &[f64]) -> Option<(f64, f64)> {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    (n > 0.0).then(|| (mean, if n > 1.0 { (squares / (n - 1.0)).sqrt() } else { 0.0 }))
}

/// Repeated determinations of one quantity, their mean the result.
#[derive(Clone, Debug)]
pub struct Repeated {
    /// Each determination.
    pub values: Vec<Uncertain>,
    /// Their mean.
    pub mean: Uncertain,
}

/// How repeats scatter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeats {
    /// Standard deviation of the determinations; zero of a single one.
    pub standard_deviation: f64,
    /// What the points' own uncertainties make of it.
    pub expected: f64,
    /// Variance of the mean that the points do not explain: zero unless chi-square rejects them.
    pub excess_variance: f64,
}

impl Repeated {
    /// The mean of determinations.
    pub fn new(values: Vec<Uncertain>) -> Self {
        let mean = Uncertain::mean(&values);
        Self { values, mean }
    }

    /// How the repeats scatter, against what their points say. What all share (base frame, C) cancels between them.
    pub fn repeats(&self, readings: &Readings) -> Repeats {
        let u = readings.standard_uncertainties_mm();
        let n = self.values.len();
        let plain: Vec<f64> = self.values.iter().map(|v| v.value).collect();
        let standard_deviation = mean_and_deviation(&plain).map_or(0.0, |m| m.1);
        let own = self.values.iter().map(|v| Uncertain::linear(0.0, [(1.0, v), (-1.0, &self.mean)]));
        let expected_variance = own.map(|v| v.covariance(&v, u)).sum::<f64>() / n.saturating_sub(1).max(1) as f64;
        let dof = n.saturating_sub(1);
        let variance = standard_deviation * standard_deviation;
        let rejected = dof > 0 && chi_square_exceeds(dof as f64 * variance / expected_variance, dof);
        let excess_variance = if rejected { (variance - expected_variance).max(0.0) / n as f64 } else { 0.0 };
        Repeats { standard_deviation, expected: expected_variance.sqrt(), excess_variance }
    }

    /// Standard uncertainty of the mean: from the points, and from what the repeats scatter beyond them.
    pub fn standard_uncertainty(&self, readings: &Readings) -> f64 {
        let u = readings.standard_uncertainties_mm();
        (self.mean.covariance(&self.mean, u) + self.repeats(readings).excess_variance).sqrt()
    }
}
