//! Nonlinear least squares: a [`Problem`] gives residuals and their exact Jacobian, [`solve`] finds the parameters,
//! and the answer says in words how it ended ([`Termination`]), with rank, condition, covariance and every step.
//!
//! Every step is solved on a triangular factor with scaled columns, from an orthogonal factorisation; the fits of
//! elements, which are well conditioned, take it from normal equations where that loses nothing. Parameters may be
//! bounded ([`solve_within`]) or held ([`Held`]), rows weighed ([`Weighted`]), prior knowledge added ([`WithPriors`]), and
//! outliers told to pull less ([`Loss`]).

mod bounds;
mod eigen;
mod factor;
mod gauss_newton;
mod least_squares;
mod levenberg_marquardt;
mod log;
mod loss;
mod options;
mod problem;
mod rows;
mod run;
mod solution;
mod svd;
mod termination;
mod trust_region;

pub use bounds::{Bounds, Side};
pub use eigen::symmetric_eigen;
pub use factor::Factor;
pub use least_squares::{solve, solve_within};
pub use log::{Step, StepKind};
pub use loss::Loss;
pub use options::Options;
pub use problem::Problem;
pub use rows::{Held, Prior, Weighted, WithPriors};
pub(crate) use run::column_norms;
pub use solution::Solution;
pub use svd::{Svd, svd};
pub use termination::Termination;
pub(crate) use trust_region::trust_region_step;
