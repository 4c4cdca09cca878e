//! Comparisons of the installation with reference values, one file a subject.

pub(super) mod code;
pub(super) mod coverage;
pub(super) mod exports;
pub(super) mod fits;
pub(super) mod frames;
pub(super) mod identification;
pub(super) mod kinematics;
pub(super) mod nist;
pub(super) mod solver;
pub(super) mod standards;
pub(super) mod uncertainty;
