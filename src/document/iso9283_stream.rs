//! What `etalon iso9283 --stream` answers.

use super::Iso9283Interval;
use crate::base::message::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
    /// How the robot came to stand: the first arrivals at each pose; empty without a limit band.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub arrivals: Vec<Iso9283Arrival>,
    /// Moves between poses; empty without a limit band.
    pub posing: Vec<Iso9283Posing>,
    /// The commanded path, where one is stated and it is no weave.
    pub path: Option<Iso9283Path>,
    /// The weave, where one is stated.
    pub weaving: Option<Iso9283Weaving>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
}

/// The robot stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Standstill {
    /// Number of the pose that is visited; null where it is near none.
    pub pose: Option<i64>,
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
    /// Overshoot of the arrival (7.5), null likewise.
    pub overshoot_mm: Option<f64>,
    /// Time from leaving the standstill before to standing here (9), null likewise.
    pub posing_s: Option<f64>,
}

/// Arrivals at one pose (7.4, 7.5).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Settling {
    /// Number of the pose.
    pub pose: i64,
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
    pub from: i64,
    /// Where they end.
    pub to: i64,
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
    /// 95 % interval of the RT_p of infinitely many passes, likewise. RT_p may lie above it: the largest of many values that
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
    /// Mean attained position in its normal plane, likewise.
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
    /// WF, of the frequency likewise.
    pub wf_percent: f64,
}

/// One arrival, from the first entry into the limit band on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Arrival {
    /// Number of the pose.
    pub pose: i64,
    /// Which visit of that pose it is, from 1.
    pub cycle: i64,
    /// Times since the entry.
    pub time_s: Vec<f64>,
    /// Distances from where the robot came to stand.
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
    /// What the recording tells.
    pub stream: Iso9283StreamDocument,
}
