//! Laws of campaigns side by side.

pub(super) mod parameters;
