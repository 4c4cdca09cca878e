//! From points and rows of tables to observations: frames, exclusions, and checks of the values.

pub(crate) mod conventions;
pub mod exclusions;
pub mod frames;
pub mod joint_range;
pub(crate) mod labelled_points;
pub mod positions;
pub mod qif_fit;
pub mod repeats;
pub(crate) mod resolution;
