//! What may be chosen; the default fits every problem met so far.

use super::Loss;

/// When to stop, and how a residual counts.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Iterations allowed.
    pub iterations: usize,
    /// Relative step below which the parameters no longer change.
    pub step: f64,
    /// Cosine between residuals and Jacobian columns below which they are orthogonal.
    pub gradient: f64,
    /// What a residual costs: its square, unless outliers are to pull less.
    pub loss: Loss,
}

impl Default for Options {
    fn default() -> Self {
        Self { iterations: 2000, step: 1e-14, gradient: 1e-15, loss: Loss::Squares }
    }
}
