//! Commanded paths and weaves (ISO 9283:1998 8, 11).

use super::{Iso9283Interval, all, degrees};
use crate::mirror::mirror;
use etalon_standards::iso9283::path::velocity::PathVelocity;
use etalon_standards::iso9283::path::weaving::WeaveCharacteristics;
use etalon_standards::iso9283::path::{PathCharacteristics, PathCorner, PathPoint};

mirror! {
    /// A commanded path and its passes (8).
    struct Iso9283Path of PathCharacteristics as p {
        /// Passes through all command points.
        passes: usize,
        /// Passes that were begun and not ended.
        incomplete: usize,
        /// Length of the commanded path.
        length_mm: f64,
        /// Whether commanded angles change along it: AT is then that of 8.4.
        reorientation: bool,
        /// AT_p (8.2): largest distance of the mean path from the commanded one.
        at_mm: f64 = p.accuracy.at_mm,
        /// 95 % interval of AT_p by parametric bootstrap over the passes; null with fewer than three.
        #[serde(default)]
        at_interval: Option<Iso9283Interval> = p.at_interval.map(Into::into),
        /// Where on the path AT_p is attained.
        at_along_mm: f64 = p.points[p.accuracy.worst].along_mm,
        /// AT of the angles that exist, in the order a, b, c.
        at_angles_deg: Vec<f64> = degrees(&p.angle_accuracy_rad),
        /// RT_p (8.3): largest mean radius + 3 s; null with a single pass.
        rt_mm: Option<f64> = p.repeatability.as_ref().map(|r| r.rt_mm),
        /// 95 % interval of the RT_p of infinitely many passes. RT_p may be above it: the largest of many values that
        /// scatter is too large.
        #[serde(default)]
        rt_interval: Option<Iso9283Interval> = p.rt_interval.map(Into::into),
        /// Where on the path RT_p is attained.
        rt_along_mm: Option<f64> = p.repeatability.as_ref().map(|r| p.points[r.worst].along_mm),
        /// RT of the angles that exist; empty with a single pass.
        rt_angles_deg: Vec<f64> = degrees(&p.angle_repeatability_rad),
        /// Velocity, where the commanded one is stated.
        velocity: Option<Iso9283Velocity> = p.velocity.map(Into::into),
        /// Corners of the commanded path.
        corners: Vec<Iso9283Corner> = all(p.corners),
        /// The command points.
        points: Vec<Iso9283PathPoint> = all(p.points),
    }
}

mirror! {
    /// One command point.
    struct Iso9283PathPoint of PathPoint {
        /// Length of the path up to here.
        along_mm: f64,
        /// Commanded position: x, y and, where there is one, z.
        commanded_mm: Vec<f64>,
        /// Mean attained position in its normal plane.
        mean_mm: Vec<f64>,
        /// Distance between the two.
        deviation_mm: f64,
        /// Mean radius + 3 s of the passes; null with a single one.
        rt_mm: Option<f64>,
    }
}

mirror! {
    /// Velocity over the central part of the path (8.6).
    struct Iso9283Velocity of PathVelocity as v {
        /// Commanded.
        commanded_mm_s: f64,
        /// Mean over all passes.
        mean_mm_s: f64,
        /// AV.
        av_percent: f64,
        /// RV; null with a single pass.
        rv_percent: Option<f64> = Some(v.rv_percent).filter(|rv| rv.is_finite()),
        /// FV: what the instrument's noise makes of it is in it.
        fv_mm_s: f64,
    }
}

mirror! {
    /// A corner of the commanded path (8.5).
    struct Iso9283Corner of PathCorner as c {
        /// The commanded corner: x, y and, where there is one, z.
        position_mm: Vec<f64>,
        /// CR: round-off.
        cr_mm: f64 = c.driven.round_off_mm,
        /// CO: overshoot.
        co_mm: f64 = c.driven.overshoot_mm,
        /// Length along the second leg until it is kept within the limit band; null without a band, and where it is not.
        stabilisation_mm: Option<f64> = c.driven.stabilisation_mm,
    }
}

mirror! {
    /// A weave (11), mean of all passes.
    struct Iso9283Weaving of WeaveCharacteristics {
        /// Passes of the centre line.
        passes: usize,
        /// Turns that were counted in all of them.
        turns: usize,
        /// Commanded stroke, from side to side.
        commanded_stroke_mm: f64,
        /// Attained stroke.
        stroke_mm: f64,
        /// Commanded frequency: swings there and back by second.
        commanded_frequency_hz: f64,
        /// Attained frequency.
        frequency_hz: f64,
        /// WS: attained minus commanded stroke, in per cent of the commanded one.
        ws_percent: f64,
        /// WF, of the frequency.
        wf_percent: f64,
    }
}
