//! Model: observations and their residuals, with derivatives and weights.

pub(crate) mod effects;
pub(crate) mod elimination;
pub(crate) mod fixture;
pub(crate) mod frame_error;
pub(crate) mod kinds;
pub(crate) mod observation;
pub(crate) mod prior;
pub(crate) mod residuals;
pub(crate) mod rigid_part;
pub(crate) mod size;
pub(crate) mod solved;
pub(crate) mod weights;
