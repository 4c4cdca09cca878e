//! What a least-squares problem must answer.

/// Residuals r(x) of `m` equations in `n` parameters and their Jacobian; the sum of squares of r is minimised.
///
/// Residuals are divided by their standard uncertainties, so that the sum of squares is a chi-square.
pub trait Problem {
    /// Number of residuals, m.
    fn residual_count(&self) -> usize;

    /// Writes the m residuals at `x` into `r`.
    fn residuals(&self, x: &[f64], r: &mut [f64]);

    /// Writes the m × n Jacobian dr/dx at `x` into `jacobian`, row by row.
    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]);

    /// How many of the residuals, the last ones, are prior knowledge: no [`Loss`](super::Loss) weighs them down.
    fn prior_count(&self) -> usize {
        0
    }
}
