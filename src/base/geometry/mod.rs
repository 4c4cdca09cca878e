//! Angles, poses, numbers with derivatives, line drawings.

pub mod angle;
pub mod angle_order;
pub mod pose;
pub mod scalar;
pub mod sketch;
