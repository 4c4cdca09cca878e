//! Where the solver ended.

use super::{Factor, Loss, Side, Step, Termination, svd};

/// Singular values below this part of the largest are rounding: the rank does not count them.
const RANK_TOLERANCE: f64 = 1e-13;

/// Where the solver ended, and how.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The parameters.
    pub x: Vec<f64>,
    /// Residuals at `x`.
    pub residuals: Vec<f64>,
    /// Factor of the Jacobian at `x`, of its columns that are [free](Self::free), divided by `scale`; `None` if no
    /// factor could be formed.
    pub factor: Option<Factor>,
    /// Norms of the free columns of the Jacobian.
    pub scale: Vec<f64>,
    /// For every parameter, whether it lies on a bound that keeps the cost from falling further.
    pub sides: Vec<Side>,
    /// What a residual cost, and how many residuals at the end were priors.
    pub(super) loss: (Loss, usize),
    /// Steps taken.
    pub iterations: usize,
    /// Why it stopped.
    pub termination: Termination,
    /// Every step that was tried, in order.
    pub log: Vec<Step>,
}

impl Solution {
    /// What a Jacobian at `x` foretells where nothing is measured yet: its factor, its columns divided by `scale`.
    pub fn foretold(x: Vec<f64>, residuals: Vec<f64>, factor: Factor, scale: Vec<f64>) -> Self {
        Self {
            sides: vec![Side::Free; x.len()],
            x,
            residuals,
            factor: Some(factor),
            scale,
            loss: (Loss::Squares, 0),
            iterations: 0,
            termination: Termination::ResidualsZero,
            log: Vec::new(),
        }
    }

    /// Sum of squares of the residuals, or of their losses: what was minimised. A chi-square where residuals were
    /// divided by their standard uncertainties.
    pub fn cost(&self) -> f64 {
        let (loss, priors) = self.loss;
        loss.sum(&self.residuals, priors)
    }

    /// Indices of the parameters that lie on no bound.
    pub fn free(&self) -> Vec<usize> {
        self.sides.iter().enumerate().filter(|(_, s)| **s == Side::Free).map(|(i, _)| i).collect()
    }

    /// Residuals less free parameters; a prior counts as a residual.
    pub fn degrees_of_freedom(&self) -> usize {
        self.residuals.len().saturating_sub(self.free().len())
    }

    /// (JᵀJ)⁻¹, n × n row by row: the covariance where residuals were divided by their standard uncertainties.
    /// Rows and columns of parameters on a bound are zero: they count as held. `None` where the rank is not full.
    ///
    /// With a loss it is Huber's estimate K² (Σψ²/(m − n)) / (Σψ'/m)² (JᵀJ)⁻¹ (Huber 1981, 7.6), which contains the
    /// scatter of the residuals, and the rows of priors as they are.
    pub fn covariance(&self) -> Option<Vec<f64>> {
        let free = self.free();
        let local = self.factor.as_ref()?.inverse_normal()?;
        let widening = self.widening();
        let n = self.x.len();
        let mut covariance = vec![0.0; n * n];
        for (a, &i) in free.iter().enumerate() {
            for (b, &j) in free.iter().enumerate() {
                covariance[i * n + j] = widening * local[a * free.len() + b] / (self.scale[a] * self.scale[b]);
            }
        }
        Some(covariance)
    }

    /// By how much a loss makes the covariance larger than that of residuals of variance one.
    fn widening(&self) -> f64 {
        let (loss, priors) = self.loss;
        let measured = &self.residuals[..self.residuals.len().saturating_sub(priors)];
        let (m, n) = (measured.len() as f64, self.free().len() as f64);
        if loss == Loss::Squares || m <= n {
            return 1.0;
        }
        let mean = measured.iter().map(|&r| loss.curvature(r)).sum::<f64>() / m;
        let variance = measured.iter().map(|&r| (loss.curvature(r) - mean).powi(2)).sum::<f64>() / m;
        let k = 1.0 + n / m * variance / (mean * mean);
        let pulls: f64 = measured.iter().map(|&r| loss.pull(r).powi(2)).sum();
        k * k * pulls / (m - n) / (mean * mean)
    }

    /// Number of free parameters, or combinations of them, that the residuals determine.
    pub fn rank(&self) -> Option<usize> {
        self.factor.as_ref().map(|f| svd(f).rank(RANK_TOLERANCE))
    }

    /// Largest over smallest singular value of the free columns of the Jacobian, each of length one.
    pub fn condition(&self) -> Option<f64> {
        self.factor.as_ref().map(|f| svd(f).condition())
    }
}
