//! Judgement of observations and results: messages about a wrong set-up, and about parameters that
//! no robot can have.

pub(crate) mod checks;
pub(crate) mod circumstances;
pub(crate) mod commanded;
pub(crate) mod excitation;
pub(crate) mod first_tilt;
pub mod frame_checks;
pub mod plausible;
pub(crate) mod readings;
pub(crate) mod set_up;
pub(crate) mod undescribed;
pub mod validation_distance;
