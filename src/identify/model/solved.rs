//! A problem at its solution, from which covariances are computed.

use crate::model::residuals::Residuals;
use etalon_math::{Rows, Solution};

/// Residuals at their solution.
#[derive(Clone, Copy)]
pub(crate) struct Solved<'a> {
    pub problem: &'a Residuals<'a>,
    pub solution: &'a Solution,
    /// Jacobian at the solution, row by row.
    pub jacobian: &'a [f64],
}

impl<'a> Solved<'a> {
    /// Returns the rows of the Jacobian.
    pub fn rows(&self) -> Rows<'a> {
        self.problem.jacobian_rows(self.jacobian)
    }
}
