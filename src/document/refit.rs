//! What `etalon fit` says about the probe, and about the values that a file states.

use crate::base::pose::Vector;
use crate::math::fit::{Compensation, Side};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The probe whose centres were fitted, and the fit before compensation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitProbe {
    /// Radius of the probe.
    pub radius_mm: f64,
    /// `inside`, `outside` or `towards`.
    pub side: String,
    /// For a plane or line the direction from it to the probe.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub towards: Option<Vector>,
    /// What the side was told from, where the file says it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub side_from: Option<String>,
    /// Point or centre before compensation.
    pub uncompensated_point_mm: Vector,
    /// Radius before compensation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncompensated_radius_mm: Option<f64>,
    /// Radius of the tube of a torus before compensation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncompensated_minor_radius_mm: Option<f64>,
}

impl FitProbe {
    /// What a fit was compensated by.
    pub fn new(compensation: &Compensation) -> Self {
        let (side, towards) = match compensation.probe.side {
            Side::Inside => ("inside", None),
            Side::Outside => ("outside", None),
            Side::Towards(d) => ("towards", Some(d)),
        };
        Self {
            radius_mm: compensation.probe.radius_mm,
            side: side.to_owned(),
            towards,
            side_from: None,
            uncompensated_point_mm: compensation.point_mm,
            uncompensated_radius_mm: compensation.radius_mm,
            uncompensated_minor_radius_mm: compensation.minor_radius_mm,
        }
    }
}

/// What a file states of a feature, and how far the fit is from it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitStated {
    /// Id of the feature in the file.
    pub id: String,
    /// Stated location or point of the axis.
    pub point_mm: Option<Vector>,
    /// Stated normal or direction.
    pub direction: Option<Vector>,
    /// Stated radius.
    pub radius_mm: Option<f64>,
    /// Stated radius of the tube of a torus.
    pub minor_radius_mm: Option<f64>,
    /// Stated full angle of a cone.
    pub apex_angle_deg: Option<f64>,
    /// Distance of the stated point from the fitted centre, axis, line or plane.
    pub point_apart_mm: Option<f64>,
    /// Angle between stated and fitted direction.
    pub direction_apart_deg: Option<f64>,
    /// Fitted less stated radius.
    pub radius_less_stated_mm: Option<f64>,
    /// Fitted less stated radius of the tube.
    pub minor_radius_less_stated_mm: Option<f64>,
    /// Fitted less stated full angle.
    pub apex_angle_less_stated_deg: Option<f64>,
}
