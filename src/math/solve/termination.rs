//! How a solver ended, in words that a person can act on.

use serde::{Deserialize, Serialize};
use std::fmt;

/// Why the solver stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
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
