//! Laws of least squares.

pub(super) mod nist_strd;
pub(super) mod solving;
