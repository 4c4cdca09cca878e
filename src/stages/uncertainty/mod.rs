//! Uncertainty of results: bounds for answers that may be loaded, and distributions of a campaign.

pub(crate) mod bounds;
pub mod monte_carlo;
