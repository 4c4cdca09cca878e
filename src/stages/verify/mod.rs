//! Parameters of an earlier identification against new observations.

pub mod copies;
pub mod earlier_parameters;
pub mod expected_deviation;
pub mod expected_scatter;
pub mod predicted;
pub mod validation;
pub mod verification;
