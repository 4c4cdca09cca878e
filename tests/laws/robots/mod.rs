//! Laws of kinematic models and conventions.

pub(super) mod chains;
pub(super) mod conventions;
pub(super) mod five_bar;
pub(super) mod platforms;
pub(super) mod robots;
pub(super) mod serial;
