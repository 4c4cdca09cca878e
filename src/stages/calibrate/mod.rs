//! From observations to identified parameters.

pub mod controller_files;
pub mod cross_validation;
pub mod evaluation;
pub mod findings;
pub mod identification;
pub mod loading_check;
pub(crate) mod log_comparison;
pub mod preview;
pub mod recommendation;
pub mod selection;
pub mod solution;
mod undescribed_effects;
pub mod validation_targets;
