//! Tables whose columns are known: observations, visits, recordings, reference targets.

pub mod coordinates;
pub mod observations;
pub mod recording;
pub mod reference_targets;
pub mod visits;
