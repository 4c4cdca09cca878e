//! Tables whose columns are known: observations, tests of poses, recordings, reference targets.

pub mod coordinates;
pub mod joints;
pub mod observations;
pub mod pose_test;
pub mod recording;
pub mod reference_targets;
