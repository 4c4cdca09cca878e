//! Chi-square against its degrees of freedom.

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Probability with which a chi-square test rejects a right model.
pub const REJECT: f64 = 1e-3;

/// Probability that a right model has a chi-square at least this large; `None` without degrees of
/// freedom.
pub fn probability(chi_square: f64, dof: usize) -> Option<f64> {
    ChiSquared::new(dof as f64).ok().map(|d| d.sf(chi_square))
}

/// `true` if chi-square is too large for the degrees of freedom: a right model exceeds the limit
/// once in a thousand times.
pub fn exceeds(chi_square: f64, dof: usize) -> bool {
    probability(chi_square, dof).is_some_and(|p| p < REJECT)
}

/// `true` if chi-square is neither too large nor too small for the degrees of freedom.
pub fn agrees(chi_square: f64, dof: usize) -> bool {
    !exceeds(chi_square, dof) && !falls_short(chi_square, dof)
}

/// `true` if chi-square is too small for the degrees of freedom: the given uncertainty falls below
/// the limit once in a thousand times.
pub(crate) fn falls_short(chi_square: f64, dof: usize) -> bool {
    ChiSquared::new(dof as f64).is_ok_and(|d| d.cdf(chi_square) < REJECT)
}
