//! Chi-square against its degrees of freedom.

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Probability with which a chi-square test rejects a right model.
const REJECT: f64 = 1e-3;

/// `true` if chi-square is too large for the degrees of freedom: a right model exceeds the limit
/// once in a thousand times.
pub fn exceeds(chi_square: f64, dof: usize) -> bool {
    ChiSquared::new(dof as f64).is_ok_and(|d| d.sf(chi_square) < REJECT)
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
