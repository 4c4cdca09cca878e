//! Choice of effects and parameters: selection, left-out poses, recommendation.

pub mod cross_validation;
pub mod recommendation;
pub mod selection;
pub(super) mod undescribed_effects;
