//! The pictures, as SVG that is made once: what a pointer or a screen reader reads off them is in it.

pub(super) mod against;
pub(super) mod arrows;
mod axis;
pub(super) mod by_pose;
pub(super) mod chart;
pub(super) mod chosen;
pub(super) mod correlation;
pub(super) mod cube;
pub(super) mod curve;
pub(super) mod histogram;
pub(super) mod influence;
pub(super) mod intervals;
mod limit_lines;
pub(super) mod map;
pub(super) mod parameter_errors;
pub(super) mod plane;
pub(super) mod points;
pub(super) mod prediction;
pub(super) mod residuals;
pub(super) mod shares;
pub(super) mod singular;
pub(super) mod sketch;
pub(super) mod svg;
pub(super) mod trend;
mod view;
pub(super) mod visits;
