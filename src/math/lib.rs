//! Nonlinear least squares: a [`Problem`] gives residuals and their exact Jacobian, [`solve`] finds the parameters,
//! and the answer states in words how it ended ([`Termination`]), with its covariance.
//!
//! Every step is solved on a triangular factor with scaled columns, from an orthogonal factorisation; the fits of
//! elements, which are well conditioned, take it from normal equations where that loses nothing. ParameterPrior knowledge adds
//! rows ([`WithPriors`]), a [`Loss`] reduces the influence of outliers.
#![allow(non_snake_case)] // world_T_base: frames in names

mod blocks;
mod eigen;
mod factor;
mod least_squares;
mod loss;
mod priors;
pub mod statistics;
mod svd;
mod trust_region;

pub use blocks::{Blocks, OWN, Rows};
pub use eigen::{smallest_eigenvector, symmetric_eigen};
pub use factor::Factor;
pub use least_squares::{Solution, solve};
pub use least_squares::{column_norms, covariance, factor_at, linearised_at, solve_near};
pub use loss::Loss;
pub use priors::{ParameterPrior, WithPriors};
pub use svd::{Svd, svd};
pub use trust_region::{TrustRegion, norm};

use std::fmt;

/// Residuals r(x) of `m` equations in `n` parameters and their Jacobian; the sum of squares of r is minimised.
///
/// Residuals are divided by their standard uncertainties, so that the sum of squares is a chi-square.
pub trait Problem {
    /// Number of residuals, m.
    fn residual_count(&self) -> usize;

    /// Writes the m residuals at `x` into `r`.
    fn residuals(&self, x: &[f64], r: &mut [f64]);

    /// Writes the m × n Jacobian dr/dx at `x` into `jacobian`, row by row; of a problem with [`Self::blocks`] as these say.
    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]);

    /// Columns that only few rows have.
    fn blocks(&self) -> Option<&Blocks> {
        None
    }

    /// How many of the residuals, the last ones, are prior knowledge: no [`Loss`] weighs them down.
    fn prior_count(&self) -> usize {
        0
    }
}

/// When to stop, and how a residual counts.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Iterations allowed.
    pub iterations: usize,
    /// Relative step below which the parameters no longer change.
    pub step: f64,
    /// Cosine between residuals and Jacobian columns below which they are orthogonal.
    pub gradient: f64,
    /// What a residual costs: its square, unless outliers are to have less influence.
    pub loss: Loss,
}

impl Default for Options {
    fn default() -> Self {
        Self { iterations: 2000, step: 1e-14, gradient: 1e-15, loss: Loss::Squares }
    }
}

/// Why the solver stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Termination {
    /// The last step no longer changed the parameters.
    StepVanished,
    /// The residuals are orthogonal to every column of the Jacobian: a stationary point.
    GradientVanished,
    /// The residuals are zero to rounding.
    ResidualsZero,
    /// No shorter step lowers the sum of squares: rounding limits the result.
    NoImprovementPossible,
    /// The iterations allowed were used up.
    LostPatience,
    /// A residual or derivative is not a number at the start or on the way.
    NotANumber,
    /// The Jacobian has dependent columns: not all parameters are separately identifiable.
    RankDeficient,
    /// There are fewer equations than parameters.
    TooFewEquations,
}

impl Termination {
    /// Whether the parameters may be used.
    pub fn is_success(self) -> bool {
        use Termination::{GradientVanished, NoImprovementPossible, ResidualsZero, StepVanished};
        matches!(self, StepVanished | GradientVanished | ResidualsZero | NoImprovementPossible)
    }
}

impl fmt::Display for Termination {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::StepVanished => "converged: the last step no longer changed the parameters",
            Self::GradientVanished => "converged: the residuals are orthogonal to the Jacobian",
            Self::ResidualsZero => "converged: the residuals are zero to rounding",
            Self::NoImprovementPossible => "converged as far as rounding allows: no shorter step lowers the residuals",
            Self::LostPatience => "not converged within the iterations allowed: check the starting values",
            Self::NotANumber => "stopped: a residual is not a number, check the starting values and the data",
            Self::RankDeficient => "stopped: some parameters are not separately identifiable, hold one of them",
            Self::TooFewEquations => "stopped: fewer equations than parameters, measure more poses or hold parameters",
        })
    }
}
