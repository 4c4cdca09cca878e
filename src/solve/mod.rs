//! Nonlinear least squares: a [`Problem`] gives residuals and their exact Jacobian, [`solve`] finds the parameters,
//! and the answer says in words how it ended ([`Termination`]), with rank, singular values and covariance.
//!
//! Every step is solved on a triangular factor with scaled columns, from an orthogonal factorisation; the fits of
//! elements, which are well conditioned, take it from normal equations where that loses nothing.

mod eigen;
mod factor;
mod levenberg_marquardt;
mod problem;
mod svd;
mod termination;

pub use eigen::symmetric_eigen;
pub use factor::Factor;
pub use levenberg_marquardt::{Options, Solution, solve};
pub(crate) use levenberg_marquardt::{column_norms, trust_region_step};
pub use problem::Problem;
pub use svd::{Svd, svd};
pub use termination::Termination;
