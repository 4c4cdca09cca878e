//! Nonlinear least squares: a [`Problem`] gives residuals and their exact Jacobian, [`solve`] finds the parameters,
//! and the answer says in words how it ended ([`Termination`]), with rank, singular values and covariance.
//!
//! No normal equations: every step is solved on an orthogonal factorisation with scaled columns.

mod eigen;
mod factor;
mod levenberg_marquardt;
mod problem;
mod svd;
mod termination;

pub use eigen::symmetric_eigen;
pub use factor::Factor;
pub(crate) use levenberg_marquardt::column_norms;
pub use levenberg_marquardt::{Options, Solution, solve};
pub use problem::Problem;
pub use svd::{Svd, svd};
pub use termination::Termination;
