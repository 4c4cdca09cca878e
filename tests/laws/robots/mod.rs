//! Laws of kinematic models and conventions.

pub(super) mod chains;
pub(super) mod conventions;
pub(super) mod five_bar;
pub(super) mod models;
pub(super) mod platforms;
pub(super) mod screw_axes;
pub(super) mod serial;
pub(super) mod singular;
