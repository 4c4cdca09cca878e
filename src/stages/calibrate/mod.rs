//! From observations to identified parameters.

pub mod controller_files;
mod effects;
pub mod evaluation;
pub mod findings;
pub mod identification;
pub mod loading_check;
pub(crate) mod log_comparison;
pub mod preview;
pub mod solution;
pub mod validation_targets;

use effects::undescribed_effects;
pub use effects::{cross_validation, recommendation, selection};
