//! Tests by ISO 9283: tables, labelled points and recorded motions become characteristics.

pub mod characteristics;
pub mod load;
pub mod motion;
pub mod plan;
pub mod pose;
pub(crate) mod pose_tables;
pub mod repeatability;
pub mod streams;

/// The 25 % rule takes the expanded uncertainty with this coverage factor.
pub(crate) const COVERAGE_FACTOR: f64 = 2.0;
