//! Numbers of several words and of several lanes.

pub(super) mod double_double;
pub(super) mod f64x8;
pub(super) mod packed;
