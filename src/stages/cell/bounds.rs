//! Bounds of the uncertainties of an answer: it is loadable within them only.

use super::{CellKind, Found, Task};
use crate::stages::uncertainty::bounds::{Component, beyond_bound};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, norm};
use etalon_documents::CellFrameEntry;
use etalon_identify::cell::{CellFrame, Measure, Quality};
use etalon_identify::{ASSUMED_MM, Extent};
use etalon_robots::Quantity;

/// Region in which an answer was measured.
#[derive(Clone, Debug, Default)]
pub(super) struct Region {
    /// Extent of the positions, or length of the tool, whichever is larger (mm).
    length_mm: f64,
    /// Standard uncertainty of a coordinate, if no residuals show it (mm).
    pub coordinate_mm: Option<f64>,
    /// For each frame the centre of the positions in its reference frame, at which its position is
    /// judged; by default its origin. A frame whose origin is far away is used where it was
    /// measured.
    centres: Vec<Option<Vector>>,
}

impl Region {
    pub fn from_points(points: &[Vector]) -> Self {
        Self { length_mm: Extent::from_points(points, 0.0).length_mm, ..Self::default() }
    }

    /// Returns the region of positions that a tool of this position in the flange takes.
    pub fn from_points_and_tool(points: &[Vector], tool_mm: Vector) -> Self {
        Self { length_mm: Self::from_points(points).length_mm.max(norm(tool_mm)), ..Self::default() }
    }

    pub fn with_uncertainty(self, coordinate_mm: Option<f64>) -> Self {
        Self { coordinate_mm, ..self }
    }

    pub fn with_centres(mut self, centres: impl IntoIterator<Item = Option<Vector>>) -> Self {
        self.centres = centres.into_iter().collect();
        self
    }

    fn extent(&self, coordinate_mm: Option<f64>, orientation_rad: Option<f64>) -> Extent {
        Extent {
            length_mm: self.length_mm,
            coordinate_mm: coordinate_mm.or(self.coordinate_mm).unwrap_or(ASSUMED_MM),
            orientation_rad: orientation_rad.unwrap_or_default(),
        }
    }
}

/// Names of coordinate axes.
const AXES: [&str; 3] = ["x", "y", "z"];

fn position_components(name: &str) -> impl Iterator<Item = Component> + '_ {
    AXES.into_iter().map(move |axis| (phrase!("bound-position", axis, name), Quantity::Length))
}

fn rotation_components(name: &str) -> impl Iterator<Item = Component> + '_ {
    AXES.into_iter().map(move |axis| (phrase!("bound-rotation", axis, name), Quantity::Angle))
}

impl Task<'_> {
    /// Errors about frames, points and axes with a component whose uncertainty exceeds its bound.
    pub(super) fn beyond_bounds(&self, found: &Found, quality: Option<&Quality>) -> Vec<Message> {
        let u = |measure| quality.and_then(|q| q.standard_uncertainty(measure, &self.uncertain));
        let extent = found.region.extent(u(Measure::Position), u(Measure::Orientation));
        let judge = |components: Vec<Component>, covariance: &[f64]| {
            beyond_bound(self.stated.bound, &extent, &components, covariance, self.remedy())
        };
        let frames = found.frames.iter().enumerate().filter_map(|(i, frame)| {
            let centre = found.region.centres.get(i).copied().flatten();
            let covariance = covariance_at(frame, centre)?;
            judge(
                position_components(&frame.name).chain(rotation_components(&frame.name)).collect(),
                covariance.as_flattened(),
            )
        });
        let points = found.points.iter().filter_map(|point| {
            judge(position_components(&point.name).collect(), point.covariance_mm2?.as_flattened())
        });
        let axis = found.axis.as_ref();
        let directions = axis.filter(|axis| axis.prismatic).and_then(|axis| {
            let direction = || AXES.into_iter().map(|axis| (phrase!("bound-direction", axis), Quantity::Angle));
            judge(direction().collect(), axis.direction_covariance?.as_flattened())
        });
        let ratios = axis.and_then(|axis| {
            let variance = axis.scale_standard_uncertainty?.powi(2);
            judge(vec![(phrase!("bound-ratio"), Quantity::Ratio)], &[variance])
        });
        frames.chain(points).chain(directions).chain(ratios).collect()
    }

    /// Measurement that reduces the uncertainty.
    fn remedy(&self) -> Phrase {
        let case = match self.stated.solve {
            CellKind::ToolPoint | CellKind::ToolAxes => "tool",
            CellKind::ToolReflector | CellKind::HandEye => "poses",
            CellKind::Object | CellKind::ThreePoints => "points",
            CellKind::LinearAxis => "travel",
            CellKind::RotaryAxis => "turn",
        };
        phrase!("bound-remedy", case)
    }
}

/// Covariance of a frame at the centre of the measured positions.
fn covariance_at(frame: &CellFrameEntry, centre: Option<Vector>) -> Option<[[f64; 6]; 6]> {
    let pose = Pose { translation_mm: frame.xyz_mm, ..Pose::identity() };
    let covariance = frame.covariance?;
    Some(centre.map_or(covariance, |centre| CellFrame { pose, covariance }.covariance_at(centre)))
}
