//! Answer of `etalon cell`.

use crate::Provenance;
use etalon_base::message::{Message, Severity};
use etalon_base::pose::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Frames and points of a robot cell from controller poses and measurements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CellDocument {
    /// Schema and version: `etalon/cell/1`.
    pub schema: String,
    /// Version and inputs.
    pub provenance: Provenance,
    /// Problem that is solved: `tool-point`, `tool-reflector`, `tool-axes`, `hand-eye`, `object`,
    /// `three-points`, `linear-axis` or `rotary-axis`.
    pub solve: String,
    /// Number of readings.
    pub readings: usize,
    /// Identified frames; the first one is the answer.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub frames: Vec<CellFrameEntry>,
    /// Identified points; without frames the first one is the answer.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<CellPointEntry>,
    /// Identified external axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axis: Option<CellAxisEntry>,
    /// Standard deviations of the residuals: positions, then orientations.
    pub noise: Vec<CellNoise>,
    /// Residuals in the order of the rows.
    pub residuals: Vec<CellResidualEntry>,
    /// Warnings, and errors for which the answer must not be loaded.
    pub messages: Vec<Message>,
}

impl CellDocument {
    /// Errors for which the answer must not be loaded.
    pub fn errors(&self) -> impl Iterator<Item = &Message> {
        self.messages.iter().filter(|m| m.severity == Severity::Error)
    }
}

/// Frame in its reference frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CellFrameEntry {
    /// Name: `tool`, `sensor`, `object`, `base`, `world`, `target` or `axis`.
    pub name: String,
    /// Reference frame: `flange`, `base`, `world` or `points` (the frame of the measured points).
    pub reference: String,
    /// Position (mm).
    pub xyz_mm: Vector,
    /// Orientation: unit quaternion w, x, y, z.
    pub quaternion: [f64; 4],
    /// Standard uncertainties of the position; absent without redundancy or given uncertainty.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_uncertainty_mm: Option<Vector>,
    /// Standard uncertainties of a small rotation about the axes of the reference frame (deg).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_uncertainty_deg: Option<Vector>,
    /// Covariance of the position (mm) and of a small rotation (rad) about the axes of the
    /// reference frame, 6 × 6, in this order.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub covariance: Option<[[f64; 6]; 6]>,
}

/// Point in its reference frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CellPointEntry {
    /// Name: `tool` or `fixed`.
    pub name: String,
    /// Reference frame: `flange` or `base`.
    pub reference: String,
    /// Position (mm).
    pub xyz_mm: Vector,
    /// Standard uncertainties; absent without redundancy or given uncertainty.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_uncertainty_mm: Option<Vector>,
    /// Covariance (mm²), 3 × 3.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub covariance_mm2: Option<[[f64; 3]; 3]>,
}

/// External axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CellAxisEntry {
    /// `true` if the axis slides.
    pub prismatic: bool,
    /// Unit direction of positive motion in the frame of the measured points.
    pub direction: Vector,
    /// Covariance of the direction, 3 × 3.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction_covariance: Option<[[f64; 3]; 3]>,
    /// Motion per unit of the axis value.
    pub scale: f64,
    /// Standard uncertainty of the scale.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale_standard_uncertainty: Option<f64>,
    /// Radius of the first target (mm); absent for a prismatic axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_mm: Option<f64>,
}

/// Standard deviation of positions or orientations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CellNoise {
    /// `position` (mm) or `orientation` (deg).
    pub measure: String,
    /// Number of equations.
    pub equations: usize,
    /// Equations minus the parameters that they determine.
    pub redundancy: f64,
    /// Standard deviation of the residuals (mm or deg); absent without redundancy.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_deviation: Option<f64>,
    /// Source of the uncertainties: `stated`, or `residuals`.
    pub uncertainties_from: String,
}

/// Residual of a reading.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CellResidualEntry {
    /// Line of the reading.
    pub line: usize,
    /// `position` (mm) or `orientation` (deg).
    pub measure: String,
    /// Measured minus predicted; for orientations a rotation vector.
    pub residual: Vector,
    /// Length of the residual.
    pub length: f64,
    /// Probability of a residual at least as large by noise; absent without redundancy.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probability: Option<f64>,
}
