//! Nonlinear least squares: a [`Problem`] provides residuals and their exact Jacobian, and
//! [`solve`] finds the parameters. The result includes the reason of the termination
//! ([`Termination`]) and the covariance.
//!
//! Every step is solved with a triangular factor of the scaled columns from an orthogonal
//! factorisation. The fits of elements, which are well conditioned, use normal equations where no
//! accuracy is lost. Prior knowledge adds rows ([`WithPriors`]); a [`Loss`] reduces the influence
//! of outliers.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

mod blocks;
mod eigen;
mod factor;
mod least_squares;
mod loss;
mod priors;
mod quadratic;
pub mod statistics;
mod svd;
mod trust_region;

pub use blocks::{Blocks, OWN, Rows};
pub use eigen::{smallest_eigenvector, symmetric_eigen};
pub use factor::Factor;
pub use least_squares::{Linearised, Solution, solve};
pub use least_squares::{column_norms, covariance, factor_at, linearised_at, solve_near};
pub use loss::Loss;
pub use priors::{ParameterPrior, WithPriors};
pub use quadratic::Quadratic;
pub use svd::{Svd, svd};
pub use trust_region::{TrustRegion, norm};

use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use std::fmt;

/// Residuals r(x) of `m` equations in `n` parameters, and their Jacobian; the sum of squares of r
/// is minimised.
///
/// Residuals are divided by their standard uncertainties, so that the sum of squares is a
/// chi-square.
pub trait Problem {
    /// Number m of residuals.
    fn residual_count(&self) -> usize;

    /// Writes the m residuals at `x` into `r`.
    fn residuals(&self, x: &[f64], r: &mut [f64]);

    /// Writes the m × n Jacobian dr/dx at `x` into `jacobian`, row by row; in the layout of
    /// [`Self::blocks`] if there are blocks.
    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]);

    /// Blocks of columns that occur in few rows only.
    fn blocks(&self) -> Option<&Blocks> {
        None
    }

    /// Number of residuals at the end that are prior knowledge, which no [`Loss`] reduces.
    fn prior_count(&self) -> usize {
        0
    }
}

/// Termination criteria, and loss of a residual.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Maximum number of iterations.
    pub iterations: usize,
    /// Convergence tolerance: relative step.
    pub step: f64,
    /// Convergence tolerance: cosine of the angle between residuals and Jacobian columns.
    pub gradient: f64,
    /// Loss of a residual; a loss other than its square reduces the influence of outliers.
    pub loss: Loss,
}

impl Default for Options {
    fn default() -> Self {
        Self { iterations: 2000, step: 1e-14, gradient: 1e-15, loss: Loss::Squares }
    }
}

/// Reason of the solver's termination.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Termination {
    /// Converged: the last step did not change the parameters.
    StepVanished,
    /// Converged to a stationary point: the residuals are orthogonal to every column of the
    /// Jacobian.
    GradientVanished,
    /// Converged: the residuals are zero to rounding.
    ResidualsZero,
    /// Converged to rounding: no shorter step lowers the sum of squares.
    NoImprovementPossible,
    /// Iteration limit reached.
    IterationLimit,
    /// A residual or derivative is not finite, at the start or on the way.
    NotANumber,
    /// Rank-deficient Jacobian: not all parameters are separately identifiable.
    RankDeficient,
    /// Fewer equations than parameters.
    TooFewEquations,
}

impl Termination {
    /// `true` if the parameters may be used.
    pub fn is_success(self) -> bool {
        use Termination::{GradientVanished, NoImprovementPossible, ResidualsZero, StepVanished};
        matches!(self, StepVanished | GradientVanished | ResidualsZero | NoImprovementPossible)
    }

    /// The reason in words.
    pub fn phrase(self) -> Phrase {
        match self {
            Self::StepVanished => phrase!("solver-step-vanished"),
            Self::GradientVanished => phrase!("solver-gradient-vanished"),
            Self::ResidualsZero => phrase!("solver-residuals-zero"),
            Self::NoImprovementPossible => phrase!("solver-rounding"),
            Self::IterationLimit => phrase!("solver-iteration-limit"),
            Self::NotANumber => phrase!("solver-not-finite"),
            Self::RankDeficient => phrase!("solver-rank-deficient"),
            Self::TooFewEquations => phrase!("solver-too-few-equations"),
        }
    }
}

impl fmt::Display for Termination {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.phrase().fmt(f)
    }
}
