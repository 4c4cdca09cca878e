//! Figures of reports as SVG, with texts for pointers and screen readers. `svg` draws elements and
//! legends, `axis` scales, `chart` the frame of figures with two axes, `workspace` the frame of
//! planes and space; each other file is one figure.

pub(super) mod against;
pub(super) mod arrows;
mod axis;
pub(super) mod bullets;
pub(super) mod by_pose;
mod chart;
pub(super) mod chosen;
pub(super) mod correlation;
pub(super) mod cube;
pub(super) mod curve;
pub(super) mod curves;
pub(super) mod distances;
pub(super) mod forest;
pub(super) mod held_out;
pub(super) mod histogram;
pub(super) mod influence;
pub(super) mod intervals;
pub(super) mod map;
pub(super) mod multiples;
pub(super) mod overlay;
pub(super) mod parameter_errors;
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
pub(super) mod workspace;

/// Names that most figures use.
mod layer {
    pub(super) use super::axis::{Axis, drawable, largest, range};
    pub(super) use super::chart::Chart;
    pub(super) use super::points;
    pub(super) use super::svg::{CALIBRATION, COLOURS, Look, NARROW, Place, Shape, Svg, VALIDATION, WIDE, widest};
    pub(super) use super::workspace::{Seen, Workspace, XY};
    pub(super) use crate::model::Figure;
    pub(super) use crate::number;
    pub(super) use crate::words::{Words, names, tr};
    pub(super) use etalon_base::catalogue::Phrase;
    pub(super) use etalon_base::pose::{Vector, centroid, minus, norm};
    pub(super) use etalon_base::pose_name::PoseName;
    pub(super) use etalon_documents::{ErrorQuantity, LimitVerdict, PointError, PoseSet};
}
