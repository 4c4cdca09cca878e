//! `[[stream]]`: a recorded motion that ISO 9283 is told of.

use super::Campaign;
use crate::base::message::{Message, Problems};
use crate::import::format::{Format, Unit};
use serde::Deserialize;
use toml::Spanned;

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
