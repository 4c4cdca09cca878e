//! `[[stream]]`: a recorded motion that ISO 9283 is told of.

use super::{Campaign, Format, Unit};
use crate::message::{Message, Problems};
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
    /// Statements that mean nothing.
    pub fn problems(&self, campaign: &Campaign) -> Problems {
        let place = || campaign.place(&self.name);
        let numbers = [
            ("`rate_hz`", self.rate_hz),
            ("`still_mm`", Some(self.still_mm)),
            ("`still_s`", Some(self.still_s)),
            ("`near_mm`", Some(self.near_mm)),
            ("`band_mm`", self.band_mm),
            ("`velocity_mm_s`", self.velocity_mm_s),
            ("`central_percent`", Some(self.central_percent)),
        ];
        let central = ("`central_percent`", self.central_percent);
        let told = no_test_with(&numbers, central, ("`path_points`", self.path_points)).0;
        let mut problems = Problems(told.into_iter().map(|message| message.at(place())).collect());
        let mut say = |message: Message| problems.0.push(message.at(place()));
        if self.format.is_some() != self.unit.is_some() {
            let message = Message::error("a recording with a `format` needs its `unit`, and only then one");
            say(message.hint("without both it is a table time_s,x_mm,y_mm,z_mm, which tells its units"));
        }
        if self.velocity_mm_s.is_some() && self.path.is_none() {
            say(Message::error("`velocity_mm_s` is that of a `path`").hint("state the file of the commanded path"));
        }
        problems
    }
}

/// What no recorded motion can be tested with: numbers that must be positive, the part of the path in percent, the points
/// along it. Names are as the user writes them.
pub fn no_test_with(numbers: &[(&str, Option<f64>)], central: (&str, f64), points: (&str, usize)) -> Problems {
    let wrong = numbers.iter().filter(|(_, value)| value.is_some_and(|v| !(v > 0.0 && v.is_finite())));
    let mut problems = Problems(wrong.map(|(n, _)| Message::error(format!("{n} must be positive"))).collect());
    if central.1 > 100.0 {
        problems.0.push(Message::error(format!("{} is more than the path", central.0)));
    }
    if !(2..=100_000).contains(&points.1) {
        problems.0.push(Message::error(format!("{} must be 2 to 100000", points.0)));
    }
    problems
}
