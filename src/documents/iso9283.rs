//! ISO 9283: poses, recorded motions, compliance, and the layout of a test.

use super::{Conformity, LimitVerdict};
use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

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
    pub limits: Vec<LimitVerdict>,
    /// Measurements of the reference targets by which positions were carried back, where there are any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub reference: Vec<Iso9283Epoch>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
}

impl Iso9283Document {
    /// Characteristics of the poses alone.
    pub fn of_poses(self) -> Self {
        Self {
            distances: Vec::new(),
            approaches: Vec::new(),
            drifts: Vec::new(),
            exchangeability_mm: None,
            coplanarity_mm: None,
            reference: Vec::new(),
            ..self
        }
    }
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
    /// Name of the pose.
    pub pose: PoseName,
    /// Distance from the plane.
    pub distance_mm: f64,
}

/// One visit of one pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Visit {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the cycle.
    pub cycle: i64,
    /// How the pose was approached; null for the first visit of all.
    pub approach: Option<String>,
    /// Attained position.
    pub attained_mm: etalon_base::pose::Vector,
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
    /// Name of the pose.
    pub pose: PoseName,
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
    /// 95 % interval of AP by parametric bootstrap, and with the instrument's uncertainty where that is stated; null with fewer than
    /// three visits.
    pub ap_interval: Option<Iso9283Interval>,
    /// 95 % interval of RP, likewise.
    pub rp_interval: Option<Iso9283Interval>,
    /// 95 % interval of AP in closed form, of the sampling alone.
    pub ap_interval_analytic: Option<Iso9283Interval>,
    /// 95 % interval of RP in closed form, of the sampling alone.
    pub rp_interval_analytic: Option<Iso9283Interval>,
    /// Where the next position lies with 95 % probability; null with fewer than five visits (planar robots: four).
    pub ellipsoid: Option<Iso9283Ellipsoid>,
    /// RP without the instrument's noise, where visits were read several times.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rp_without_noise_mm: Option<f64>,
    /// Standard deviation of one reading, by coordinate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub noise_mm: Option<etalon_base::pose::Vector>,
    /// AP judged by the stated limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ap_conformity: Option<Conformity>,
    /// RP likewise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rp_conformity: Option<Conformity>,
    /// The instrument's expanded uncertainty of a position (k = 2) over AP, where it is stated.
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
    pub semi_axes_mm: etalon_base::pose::Vector,
    /// Their unit vectors.
    pub axes: [etalon_base::pose::Vector; 3],
}

/// Distance between two poses (7.3).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Distance {
    /// The two poses.
    pub poses: [PoseName; 2],
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
    /// Name of the pose.
    pub pose: PoseName,
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
    /// The column `approach`, or the previous pose.
    pub name: String,
    /// Visits.
    pub cycles: usize,
    /// Barycentre.
    pub mean_mm: etalon_base::pose::Vector,
    /// Barycentre minus commanded position; null where none was commanded.
    pub deviation_mm: Option<etalon_base::pose::Vector>,
    /// RP within this approach; null with a single visit.
    pub rp_mm: Option<f64>,
    /// Radius of the smallest sphere (planar robots: circle) that holds its positions.
    pub enclosing_radius_mm: Option<f64>,
}

/// Drift of one pose (7.6).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Drift {
    /// Name of the pose.
    pub pose: PoseName,
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

/// One of each kind of test that there is.
#[derive(Clone, Debug, Default)]
pub struct Characteristics {
    /// Poses that were visited: iso9283.json.
    pub poses: Option<Iso9283Document>,
    /// Recorded motions: iso9283-streams.json.
    pub streams: Option<Iso9283StreamsDocument>,
    /// Static compliance: iso9283-compliance.json.
    pub compliance: Option<Iso9283ComplianceDocument>,
}

impl Characteristics {
    /// Whether nothing was tested.
    pub fn none(&self) -> bool {
        self.poses.is_none() && self.streams.is_none() && self.compliance.is_none()
    }

    /// Everything that is remarked of them.
    pub fn messages(&self) -> impl Iterator<Item = &Message> {
        let poses = self.poses.iter().flat_map(|d| &d.messages);
        let streams = self.streams.iter().flat_map(Iso9283StreamsDocument::messages);
        poses.chain(streams).chain(self.compliance.iter().flat_map(|d| &d.messages))
    }

    /// Limits that are judged.
    pub fn limits(&self) -> impl Iterator<Item = &LimitVerdict> {
        self.poses.iter().flat_map(|d| &d.limits)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.poses.is_none() && self.streams.is_none() && self.compliance.is_none()
    }
}

/// Characteristics of ISO 9283:1998 of a recorded motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283StreamDocument {
    /// `etalon/iso9283-stream/1`
    pub schema: String,
    /// Thresholds, where times come from, and what is not verified against the standard, in words.
    pub conventions: Vec<String>,
    /// Samples that count.
    pub samples: usize,
    /// Lines of samples that no robot reaches from the one before, and that do not count.
    pub left_out: Vec<usize>,
    /// From the first sample to the last.
    pub duration_s: f64,
    /// Every standstill, in the order of time.
    pub standstills: Vec<Iso9283Standstill>,
    /// Arrivals by pose; empty without a limit band.
    pub settling: Vec<Iso9283Settling>,
    /// Stabilisation: the first arrivals at each pose; empty without a limit band.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub arrivals: Vec<Iso9283Arrival>,
    /// Moves between poses; empty without a limit band.
    pub posing: Vec<Iso9283Posing>,
    /// The commanded path, where one is stated and it is not a weave.
    pub path: Option<Iso9283Path>,
    /// The weave, where one is stated.
    pub weaving: Option<Iso9283Weaving>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
}

/// A standstill.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Standstill {
    /// Number of the pose that is visited; null where it is near none.
    pub pose: Option<PoseName>,
    /// Which visit of that pose it is, from 1.
    pub cycle: Option<i64>,
    /// First sample.
    pub from_s: f64,
    /// Last sample.
    pub to_s: f64,
    /// Samples.
    pub samples: usize,
    /// Mean position of the middle half: x, y and, where there is one, z.
    pub mean_mm: Vec<f64>,
    /// Means of the angles that exist, in the order a, b, c.
    pub mean_deg: Vec<f64>,
    /// Mean radius and three standard deviations of the samples of the middle half: noise of instrument and hold.
    pub noise_mm: Option<f64>,
    /// Stabilisation time of the arrival (7.4); null without a limit band, and where the band is never entered or kept.
    pub stabilisation_s: Option<f64>,
    /// Overshoot of the arrival (7.5); null without a limit band.
    pub overshoot_mm: Option<f64>,
    /// Posing time from the previous standstill (9); null without a limit band.
    pub posing_s: Option<f64>,
}

/// Arrivals at one pose (7.4, 7.5).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Settling {
    /// Name of the pose.
    pub pose: PoseName,
    /// Arrivals that settled.
    pub arrivals: usize,
    /// Mean stabilisation time.
    pub stabilisation_s: f64,
    /// Largest overshoot; zero where no arrival left the limit band again.
    pub overshoot_mm: f64,
}

/// Moves from one pose to another (9).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Posing {
    /// Where they begin.
    pub from: PoseName,
    /// Where they end.
    pub to: PoseName,
    /// How many.
    pub moves: usize,
    /// Mean attained distance.
    pub distance_mm: f64,
    /// Mean posing time.
    pub posing_s: f64,
}

/// A commanded path and its passes (8).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Path {
    /// Passes through all command points.
    pub passes: usize,
    /// Passes that were begun and not ended.
    pub incomplete: usize,
    /// Length of the commanded path.
    pub length_mm: f64,
    /// Whether commanded angles change along it: AT is then that of 8.4.
    pub reorientation: bool,
    /// AT_p (8.2): largest distance of the mean path from the commanded one.
    pub at_mm: f64,
    /// 95 % interval of AT_p by parametric bootstrap over the passes; null with fewer than three.
    #[serde(default)]
    pub at_interval: Option<Iso9283Interval>,
    /// Where on the path AT_p is attained.
    pub at_along_mm: f64,
    /// AT of the angles that exist, in the order a, b, c.
    pub at_angles_deg: Vec<f64>,
    /// RT_p (8.3): largest mean radius + 3 s; null with a single pass.
    pub rt_mm: Option<f64>,
    /// 95 % interval of the RT_p of infinitely many passes. RT_p may be above it: the largest of many values that
    /// scatter is too large.
    #[serde(default)]
    pub rt_interval: Option<Iso9283Interval>,
    /// Where on the path RT_p is attained.
    pub rt_along_mm: Option<f64>,
    /// RT of the angles that exist; empty with a single pass.
    pub rt_angles_deg: Vec<f64>,
    /// Velocity, where the commanded one is stated.
    pub velocity: Option<Iso9283Velocity>,
    /// Corners of the commanded path.
    pub corners: Vec<Iso9283Corner>,
    /// The command points.
    pub points: Vec<Iso9283PathPoint>,
}

/// One command point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283PathPoint {
    /// Length of the path up to here.
    pub along_mm: f64,
    /// Commanded position: x, y and, where there is one, z.
    pub commanded_mm: Vec<f64>,
    /// Mean attained position in its normal plane.
    pub mean_mm: Vec<f64>,
    /// Distance between the two.
    pub deviation_mm: f64,
    /// Mean radius + 3 s of the passes; null with a single one.
    pub rt_mm: Option<f64>,
}

/// Velocity over the central part of the path (8.6).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Velocity {
    /// Commanded.
    pub commanded_mm_s: f64,
    /// Mean over all passes.
    pub mean_mm_s: f64,
    /// AV.
    pub av_percent: f64,
    /// RV; null with a single pass.
    pub rv_percent: Option<f64>,
    /// FV: what the instrument's noise makes of it is in it.
    pub fv_mm_s: f64,
}

/// A corner of the commanded path (8.5).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Corner {
    /// The commanded corner: x, y and, where there is one, z.
    pub position_mm: Vec<f64>,
    /// CR: round-off.
    pub cr_mm: f64,
    /// CO: overshoot.
    pub co_mm: f64,
    /// Length along the second leg until it is kept within the limit band; null without a band, and where it is not.
    pub stabilisation_mm: Option<f64>,
}

/// A weave (11), mean of all passes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Weaving {
    /// Passes of the centre line.
    pub passes: usize,
    /// Turns that were counted in all of them.
    pub turns: usize,
    /// Commanded stroke, from side to side.
    pub commanded_stroke_mm: f64,
    /// Attained stroke.
    pub stroke_mm: f64,
    /// Commanded frequency: swings there and back by second.
    pub commanded_frequency_hz: f64,
    /// Attained frequency.
    pub frequency_hz: f64,
    /// WS: attained minus commanded stroke, in per cent of the commanded one.
    pub ws_percent: f64,
    /// WF, of the frequency.
    pub wf_percent: f64,
}

/// One arrival, from the first entry into the limit band on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Arrival {
    /// Name of the pose.
    pub pose: PoseName,
    /// Which visit of that pose it is, from 1.
    pub cycle: i64,
    /// Times since the entry.
    pub time_s: Vec<f64>,
    /// Distances from the standstill.
    pub away_mm: Vec<f64>,
}

/// Recorded motions of a campaign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283StreamsDocument {
    /// `etalon/iso9283-streams/1`
    pub schema: String,
    /// One per `[[stream]]`.
    pub streams: Vec<Iso9283NamedStream>,
}

impl Iso9283StreamsDocument {
    /// What is remarked of any of them.
    pub fn messages(&self) -> impl Iterator<Item = &Message> {
        self.streams.iter().flat_map(|s| &s.stream.messages)
    }
}

/// One of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283NamedStream {
    /// Name in the campaign.
    pub name: String,
    /// File as the campaign names it.
    pub file: String,
    /// Limit band, where one is stated.
    pub band_mm: Option<f64>,
    /// The characteristics of the recording.
    pub stream: Iso9283StreamDocument,
}

/// A test by ISO 9283:1998 laid into a workspace.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283PlanDocument {
    /// `etalon/iso9283-plan/1`
    pub schema: String,
    /// What was chosen how, and what is not verified against the standard, in words.
    pub conventions: Vec<String>,
    /// Side of the cube, of planar robots the square.
    pub side_mm: f64,
    /// Corners C1 to C8, of planar robots C1 to C4.
    pub corners_mm: Vec<Vector>,
    /// Corners of the test plane.
    pub test_plane: String,
    /// Places to visit in order, each list with its name: `poses` (P1 to P5), `linear`, `circle-large`, ...
    pub places: Vec<Iso9283Places>,
    /// Places that the robot does not reach, where one is stated.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub unreached: Vec<Iso9283Unreached>,
    /// Which characteristic is tested how.
    pub programme: Vec<Iso9283Item>,
    /// Loads in per cent of the rated one; the first is mandatory.
    pub loads_percent: Vec<u32>,
}

/// Poses, or a path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Places {
    /// Name of the list, and of the files that hold it.
    pub name: String,
    /// What it is for.
    pub purpose: String,
    /// `x_mm`, `y_mm` and, where they exist, `z_mm`, `a_deg`, `b_deg`, `c_deg` of each, numbered from 1.
    pub points: Vec<BTreeMap<String, f64>>,
    /// Joint values of each, where a robot is stated; null where it does not get there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<Option<BTreeMap<String, f64>>>,
}

/// A place that the stated robot does not reach.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Unreached {
    /// Name of the list.
    pub places: String,
    /// Number of the point in it, from 1.
    pub point: usize,
    /// Why.
    pub reason: String,
}

/// One line of the programme.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Item {
    /// What is tested.
    pub characteristic: String,
    /// Clause.
    pub clause: String,
    /// Poses of a cycle in order, or the path.
    pub visits: String,
    /// Per cent of the rated velocity.
    pub velocities_percent: Vec<u32>,
    /// Cycles for each velocity.
    pub cycles: u32,
    /// Whether the line was read in the standard's text; otherwise it is general knowledge.
    pub read: bool,
}

/// Static compliance (10).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283ComplianceDocument {
    /// `etalon/iso9283-compliance/1`
    pub schema: String,
    /// How it is computed, and that the clause is not verified.
    pub conventions: Vec<String>,
    /// One per direction, in the order of the table.
    pub directions: Vec<Iso9283Compliance>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
}

/// Compliance in one direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Compliance {
    /// `+x`, `-x` ...
    pub direction: String,
    /// Readings under load.
    pub readings: usize,
    /// Repeats.
    pub cycles: usize,
    /// Largest force.
    pub force_n: f64,
    /// Displacement along the force by force.
    pub compliance_mm_n: f64,
    /// Its standard uncertainty from the scatter about the line; null with a single reading.
    pub standard_uncertainty_mm_n: Option<f64>,
    /// Largest displacement along the force.
    pub largest_mm: f64,
    /// Largest distance of a reading from the line.
    pub off_line_mm: f64,
}
