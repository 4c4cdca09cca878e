//! Commanded paths and weaves (ISO 9283:1998 8, 11).

use super::{Iso9283Interval, coordinates, degrees};
use etalon_standards::iso9283::path::commanded::{CommandPoint, Corner};
use etalon_standards::iso9283::path::cornering::Cornering;
use etalon_standards::iso9283::path::velocity::PathVelocity;
use etalon_standards::iso9283::path::weaving::{Weave, Weaving};
use etalon_standards::iso9283::path::{Driven, PathCharacteristics};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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

impl Iso9283Path {
    /// Characteristics of a driven path of length `length_mm`.
    pub(super) fn new(driven: &Driven, found: PathCharacteristics, length_mm: f64, spatial: bool) -> Self {
        let (points, repeated) = (&driven.points, found.repeatability.as_ref());
        let point = |(i, p): (usize, &CommandPoint)| Iso9283PathPoint {
            along_mm: p.along_mm,
            commanded_mm: coordinates(p.position_mm, spatial),
            mean_mm: coordinates(found.accuracy.means_mm[i], spatial),
            deviation_mm: found.accuracy.deviations_mm[i],
            rt_mm: repeated.map(|r| r.points_mm[i]),
        };
        let corner = |(corner, found): &(Corner, Cornering)| Iso9283Corner {
            position_mm: coordinates(corner.position_mm, spatial),
            cr_mm: found.round_off_mm,
            co_mm: found.overshoot_mm,
            stabilisation_mm: found.stabilisation_mm,
        };
        Self {
            passes: driven.passes.complete.len(),
            incomplete: driven.passes.incomplete,
            length_mm,
            reorientation: driven.reorients(),
            at_mm: found.accuracy.at_mm,
            at_interval: found.at_interval.map(Into::into),
            at_along_mm: points[found.accuracy.worst].along_mm,
            at_angles_deg: degrees(&found.angle_accuracy_rad),
            rt_mm: repeated.map(|r| r.rt_mm),
            rt_interval: found.rt_interval.map(Into::into),
            rt_along_mm: repeated.map(|r| points[r.worst].along_mm),
            rt_angles_deg: degrees(&found.angle_repeatability_rad),
            velocity: found.velocity.map(Into::into),
            corners: found.corners.iter().map(corner).collect(),
            points: points.iter().enumerate().map(point).collect(),
        }
    }
}

impl From<PathVelocity> for Iso9283Velocity {
    fn from(v: PathVelocity) -> Self {
        Self {
            commanded_mm_s: v.commanded_mm_s,
            mean_mm_s: v.mean_mm_s,
            av_percent: v.av_percent,
            rv_percent: Some(v.rv_percent).filter(|rv| rv.is_finite()),
            fv_mm_s: v.fv_mm_s,
        }
    }
}

impl Iso9283Weaving {
    /// Means of a weave over the passes of its centre line.
    pub(super) fn new(weave: &Weave, passes: &[Weaving]) -> Self {
        let mean = |of: fn(&Weaving) -> f64| passes.iter().map(of).sum::<f64>() / passes.len() as f64;
        Self {
            passes: passes.len(),
            turns: passes.iter().map(|w| w.turns).sum(),
            commanded_stroke_mm: weave.stroke_mm,
            stroke_mm: mean(|w| w.stroke_mm),
            commanded_frequency_hz: weave.frequency_hz,
            frequency_hz: mean(|w| w.frequency_hz),
            ws_percent: mean(|w| w.ws_percent),
            wf_percent: mean(|w| w.wf_percent),
        }
    }
}
