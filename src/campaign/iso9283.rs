//! `[repeatability]`, `[poses]`, `[compliance]` and `[[stream]]`: tests of ISO 9283.

use super::Campaign;
use crate::base::message::{Message, Problems};
use crate::import::{Format, format::Unit};
use serde::Deserialize;
use toml::Spanned;

/// Poses that are visited again and again along one trajectory.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RepeatabilityDefinition {
    /// Labels of the visits, e.g. `P{pose}-{cycle}`. Visits of one pose in one cycle bear the same label, in their order.
    pub label: Spanned<String>,
    /// Poses in the order of one cycle; the pose before says how one was approached.
    pub trajectory: Spanned<Vec<i64>>,
    /// Four poses whose mean positions should lie in a plane.
    pub coplanar: Option<Spanned<[i64; 4]>>,
    /// Labels of the measurements at the home position, each after homing, e.g. `home-{cycle}`.
    pub homing: Option<Spanned<String>>,
    /// Commanded poses in the world frame: `pose,x_mm,y_mm[,z_mm]`; without z all is in the plane. Without the file there is
    /// no accuracy, distance or drift.
    pub commanded: Option<Spanned<String>>,
    /// Cycles of one set of a drift test.
    pub drift_set: Option<Spanned<usize>>,
}

impl RepeatabilityDefinition {
    /// Every pattern of labels.
    pub fn patterns(&self) -> impl Iterator<Item = &Spanned<String>> {
        std::iter::once(&self.label).chain(&self.homing)
    }
}

/// Attained and commanded poses. All tables are in one frame of their own.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PosesDefinition {
    /// Attained poses: `pose,cycle,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg][,approach][,robot][,reading]`.
    pub attained: Spanned<String>,
    /// Commanded poses: the same coordinates without `cycle`.
    pub commanded: Spanned<String>,
    /// Reference targets that stand still, measured from time to time: `cycle,target,x_mm,y_mm[,z_mm]`.
    pub reference: Option<Spanned<String>>,
    /// Cycles of one set of a drift test.
    pub drift_set: Option<Spanned<usize>>,
    /// Order of the rotations a, b, c, e.g. `Rz(c) Ry(b) Rx(a)`.
    pub rotation_order: Option<String>,
    /// Seed of the bootstrap intervals.
    #[serde(default = "seed")]
    pub seed: u64,
}

fn seed() -> u64 {
    1
}

/// A loaded robot.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ComplianceDefinition {
    /// `direction,cycle,force_n,x_mm,y_mm[,z_mm]`, in each direction and cycle a row of force 0.
    pub file: Spanned<String>,
}

/// A recorded motion. Recording, path and commanded poses are in one frame: that of the recording.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StreamDefinition {
    /// Name for the report, each once.
    pub name: Spanned<String>,
    /// The recording: `time_s,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg]`, or any text whose `format` and `unit` are stated.
    pub file: Spanned<String>,
    /// Its format, where it is another.
    pub format: Option<Format>,
    /// Its length unit, where `format` is stated: never guessed.
    pub unit: Option<Unit>,
    /// Sampling rate, instead of its time stamps.
    pub rate_hz: Option<f64>,
    /// Standing: all positions within this distance of their mean.
    #[serde(default = "still_mm")]
    pub still_mm: f64,
    /// Standing: for at least this time.
    #[serde(default = "still_s")]
    pub still_s: f64,
    /// How near a standstill is to its pose, and an attained path to the commanded one.
    #[serde(default = "near_mm")]
    pub near_mm: f64,
    /// Limit band for stabilisation time, overshoot and posing time.
    pub band_mm: Option<f64>,
    /// Commanded poses: `pose,x_mm,y_mm[,z_mm]...`
    pub commanded: Option<Spanned<String>>,
    /// Commanded path: the recording's columns without time, a row a point.
    pub path: Option<Spanned<String>>,
    /// Command points on the path.
    #[serde(default = "path_points")]
    pub path_points: usize,
    /// Commanded velocity on the path.
    pub velocity_mm_s: Option<f64>,
    /// Central part of the path over which velocities are compared.
    #[serde(default = "central_percent")]
    pub central_percent: f64,
    /// The path is the centre line of a weave with this stroke from side to side.
    pub weave_stroke_mm: Option<f64>,
    /// Swings there and back by second.
    pub weave_hz: Option<f64>,
    /// The way it swings: x, y and z.
    #[serde(default)]
    pub weave_across: Vec<f64>,
}

fn still_mm() -> f64 {
    0.1
}

fn still_s() -> f64 {
    0.2
}

fn near_mm() -> f64 {
    10.0
}

fn path_points() -> usize {
    50
}

fn central_percent() -> f64 {
    50.0
}

impl StreamDefinition {
    /// A file whose units are not told, or told twice.
    pub fn problems(&self, campaign: &Campaign) -> Problems {
        if self.format.is_some() == self.unit.is_some() {
            return Problems::default();
        }
        let message = Message::error("a recording with a `format` needs its `unit`, and only then one");
        let message = message.hint("without both it is a table time_s,x_mm,y_mm,z_mm, which tells its units");
        message.at(campaign.place(&self.name)).into()
    }
}
