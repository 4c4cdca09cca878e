//! What `etalon iso9283` answers.

use crate::base::message::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Characteristics of ISO 9283:1998 of one test.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Document {
    /// `etalon/iso9283/1`
    pub schema: String,
    /// What angles mean, which cycles count, and what is not verified against the standard, in words.
    pub conventions: Vec<String>,
    /// One per pose, in the order of the commanded poses.
    pub poses: Vec<Iso9283Pose>,
    /// One per pair of poses that were visited in the same cycles.
    pub distances: Vec<Iso9283Distance>,
    /// One per pose that was approached in at least two ways.
    pub approaches: Vec<Iso9283Variation>,
    /// Drift of each pose, where sets are stated.
    pub drifts: Vec<Iso9283Drift>,
    /// Largest distance between barycentres of two robots at any pose, where there are several robots.
    pub exchangeability_mm: Option<f64>,
    /// Peak to valley of the mean positions about their plane; four poses or more, with z.
    pub coplanarity_mm: Option<f64>,
    /// Distance of the mean position of each of four poses from the plane of the other three, where a campaign names them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub coplanarity_of_four: Vec<Iso9283OutOfPlane>,
    /// Homings as visits of one pose, number 0, where a campaign has them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub homing: Option<Iso9283Pose>,
    /// Every visit of a campaign, those of one pose in the order of recording.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub visits: Vec<Iso9283Visit>,
    /// Limits that the campaign states.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub limits: Vec<super::LimitVerdict>,
    /// Measurements of the reference targets by which positions were carried back, where there are any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub reference: Vec<Iso9283Epoch>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
}

/// One measurement of the reference targets.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Epoch {
    /// Cycle from which on it holds.
    pub cycle: i64,
    /// Largest movement of a target since the first.
    pub moved_mm: f64,
    /// Root mean square distance that is left when the targets are carried back.
    pub rms_mm: f64,
}

/// A pose whose mean lies out of the plane of three others (thesis 2.4).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283OutOfPlane {
    /// Number of the pose.
    pub pose: i64,
    /// Distance from the plane.
    pub distance_mm: f64,
}

/// One visit of one pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Visit {
    /// Number of the pose.
    pub pose: i64,
    /// Number of the cycle.
    pub cycle: i64,
    /// How the pose was approached; null for the first visit of all.
    pub approach: Option<String>,
    /// Attained position.
    pub attained_mm: crate::base::pose::Vector,
}

/// Two-sided interval of 95 %.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Interval {
    /// Lower end.
    pub low_mm: f64,
    /// Upper end.
    pub high_mm: f64,
}

/// Accuracy and repeatability of one pose. Coordinates that the robot does not have are absent.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Pose {
    /// Number of the pose.
    pub pose: i64,
    /// Visits counted.
    pub cycles: usize,
    /// AP_p (7.2.1); null where no position was commanded, as its coordinates.
    pub ap_mm: Option<f64>,
    /// AP_x: mean minus commanded.
    pub ap_x_mm: Option<f64>,
    /// AP_y.
    pub ap_y_mm: Option<f64>,
    /// AP_z.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ap_z_mm: Option<f64>,
    /// RP_l (7.2.2): mean radius and three standard deviations; null with a single visit, as all that follows.
    pub rp_mm: Option<f64>,
    /// The same of the projections into xy (thesis, table 2.1).
    pub rp_xy_mm: Option<f64>,
    /// The same of x alone.
    pub rp_along_x_mm: Option<f64>,
    /// The same of y alone.
    pub rp_along_y_mm: Option<f64>,
    /// The same of z alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rp_along_z_mm: Option<f64>,
    /// Mean distance from the barycentre.
    pub mean_radius_mm: Option<f64>,
    /// Standard deviation of that distance.
    pub sd_radius_mm: Option<f64>,
    /// Radius of the smallest sphere (planar robots: circle) that holds all positions.
    pub enclosing_radius_mm: Option<f64>,
    /// Radius of the smallest circle that holds their projections into xy.
    pub enclosing_circle_radius_mm: Option<f64>,
    /// RP_x: three standard deviations.
    pub rp_x_mm: Option<f64>,
    /// RP_y.
    pub rp_y_mm: Option<f64>,
    /// RP_z.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rp_z_mm: Option<f64>,
    /// AP_a.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ap_a_deg: Option<f64>,
    /// AP_b.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ap_b_deg: Option<f64>,
    /// AP_c.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ap_c_deg: Option<f64>,
    /// RP_a: three standard deviations.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rp_a_deg: Option<f64>,
    /// RP_b.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rp_b_deg: Option<f64>,
    /// RP_c.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rp_c_deg: Option<f64>,
    /// 95 % interval of AP by parametric bootstrap; null with fewer than three visits.
    pub ap_interval: Option<Iso9283Interval>,
    /// 95 % interval of RP likewise.
    pub rp_interval: Option<Iso9283Interval>,
    /// 95 % interval of AP in closed form.
    pub ap_interval_analytic: Option<Iso9283Interval>,
    /// 95 % interval of RP in closed form.
    pub rp_interval_analytic: Option<Iso9283Interval>,
    /// Where the next position lies with 95 % probability; null with fewer than five visits (planar robots: four).
    pub ellipsoid: Option<Iso9283Ellipsoid>,
    /// RP without the instrument's noise, where visits were read several times.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rp_without_noise_mm: Option<f64>,
    /// Standard deviation of one reading, by coordinate, likewise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub noise_mm: Option<crate::base::pose::Vector>,
    /// What the interval of AP proves about the stated limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ap_conformity: Option<Iso9283Conformity>,
    /// What the interval of RP proves about the stated limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rp_conformity: Option<Iso9283Conformity>,
    /// The instrument's expanded uncertainty over AP, where it is stated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncertainty_over_ap: Option<f64>,
    /// The instrument's expanded uncertainty over RP.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncertainty_over_rp: Option<f64>,
    /// Whether both are at most a quarter (clause 6).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quarter_rule_met: Option<bool>,
}

/// Ellipsoid about the mean position, flat in directions without scatter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Ellipsoid {
    /// Semi-axes, the longest first.
    pub semi_axes_mm: crate::base::pose::Vector,
    /// Their unit vectors.
    pub axes: [crate::base::pose::Vector; 3],
}

/// Conformity with a limit by ISO 14253-1's decision rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Iso9283Conformity {
    /// The whole interval is within the limit.
    Conforming,
    /// The whole interval is beyond the limit.
    NotConforming,
    /// The limit is within the interval: neither is proved.
    Neither,
}

/// Distance between two poses (7.3).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Distance {
    /// The two poses.
    pub poses: [i64; 2],
    /// Cycles that have both.
    pub cycles: usize,
    /// AD_p: mean attained minus commanded distance.
    pub ad_mm: f64,
    /// AD_x, AD_y and, where there is one, AD_z.
    pub ad_axes_mm: Vec<f64>,
    /// RD_p: three standard deviations.
    pub rd_mm: f64,
    /// RD_x, RD_y and, where there is one, RD_z.
    pub rd_axes_mm: Vec<f64>,
    /// AD of the angles that exist, in the order a, b, c.
    pub ad_angles_deg: Vec<f64>,
    /// RD of the angles that exist.
    pub rd_angles_deg: Vec<f64>,
}

/// One pose approached in several ways (7.2.3).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Variation {
    /// Number of the pose.
    pub pose: i64,
    /// vAP_p: largest distance between barycentres of two approaches.
    pub vap_mm: f64,
    /// The two that are farthest apart.
    pub between: [String; 2],
    /// vAP of the angles that exist, in the order a, b, c.
    pub vap_angles_deg: Vec<f64>,
    /// Every approach by itself.
    pub approaches: Vec<Iso9283Approach>,
}

/// Visits by one approach.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Approach {
    /// What the column `approach` says, or the pose before.
    pub name: String,
    /// Visits.
    pub cycles: usize,
    /// Barycentre.
    pub mean_mm: crate::base::pose::Vector,
    /// Barycentre minus commanded position; null where none was commanded.
    pub deviation_mm: Option<crate::base::pose::Vector>,
    /// RP within this approach; null with a single visit.
    pub rp_mm: Option<f64>,
    /// Radius of the smallest sphere (planar robots: circle) that holds its positions.
    pub enclosing_radius_mm: Option<f64>,
}

/// Drift of one pose (7.6).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Drift {
    /// Number of the pose.
    pub pose: i64,
    /// AP of each set.
    pub ap_mm: Vec<f64>,
    /// RP of each set.
    pub rp_mm: Vec<f64>,
    /// |AP at the start - AP at the end|.
    pub dap_mm: f64,
    /// |RP at the start - RP at the end|.
    pub drp_mm: f64,
    /// Number of sets after which AP had settled.
    pub settled_after: Option<usize>,
}
