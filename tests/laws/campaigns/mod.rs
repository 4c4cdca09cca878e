//! Laws of real robots and samples from files to results.

pub(super) mod hilti;
pub(super) mod irb120;
pub(super) mod mutants;
pub(super) mod prexyt;
pub(super) mod qkm;
pub(super) mod samples;
pub(super) mod standstills;
