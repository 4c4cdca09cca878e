//! Laws of compensation.

pub(super) mod compensation;
