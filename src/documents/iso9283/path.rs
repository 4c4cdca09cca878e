//! Commanded paths and weaves (ISO 9283:1998 8, 11).

use super::{Iso9283Interval, all, degrees};
use crate::mirror::mirror;
use etalon_standards::iso9283::path::velocity::PathVelocity;
use etalon_standards::iso9283::path::weaving::WeaveCharacteristics;
use etalon_standards::iso9283::path::{PathCharacteristics, PathCorner, PathPoint};

mirror! {
    /// A commanded path and its passes (8).
    struct Iso9283Path of PathCharacteristics as p {
        /// Number of passes through all command points.
        passes: usize,
        /// Number of unfinished passes.
        incomplete: usize,
        /// Length of the commanded path.
        length_mm: f64,
        /// `true` if commanded angles change along the path; AT is then evaluated by 8.4.
        reorientation: bool,
        /// AT_p (8.2): largest distance between the mean path and the commanded path.
        at_mm: f64 = p.at.position.at_mm,
        /// 95 % interval of AT_p by parametric bootstrap over the passes; null with fewer than
        /// three.
        #[serde(default)]
        at_interval: Option<Iso9283Interval> = p.at.interval.map(Into::into),
        /// Position of AT_p along the path.
        at_along_mm: f64 = p.points[p.at.position.worst].along_mm,
        /// AT of the measured angles, in the order a, b, c; empty if two of them are not separable.
        at_angles_deg: Vec<f64> = degrees(&p.at.angles_rad),
        /// RT_p (8.3): largest mean radius plus three standard deviations; null with a single pass.
        rt_mm: Option<f64> = p.rt.position.as_ref().map(|r| r.rt_mm),
        /// 95 % interval of the RT_p of infinitely many passes. RT_p may exceed it, because the
        /// largest of many scattered values is biased upwards.
        #[serde(default)]
        rt_interval: Option<Iso9283Interval> = p.rt.interval.map(Into::into),
        /// Position of RT_p along the path.
        rt_along_mm: Option<f64> = p.rt.position.as_ref().map(|r| p.points[r.worst].along_mm),
        /// RT of the measured angles; empty with a single pass, and if two of them are not
        /// separable.
        rt_angles_deg: Vec<f64> = degrees(&p.rt.angles_rad),
        /// Velocity, if the commanded velocity is given.
        velocity: Option<Iso9283Velocity> = p.velocity.map(Into::into),
        /// Corners of the commanded path.
        corners: Vec<Iso9283Corner> = all(p.corners),
        /// Command points.
        points: Vec<Iso9283PathPoint> = all(p.points),
    }
}

mirror! {
    /// One command point.
    struct Iso9283PathPoint of PathPoint {
        /// Length of the path up to this point.
        along_mm: f64,
        /// Commanded position: x, y and, if spatial, z.
        commanded_mm: Vec<f64>,
        /// Mean attained position in the normal plane of the point.
        mean_mm: Vec<f64>,
        /// Distance between mean attained and commanded position.
        deviation_mm: f64,
        /// Mean radius plus three standard deviations of the passes; null with a single pass.
        rt_mm: Option<f64>,
    }
}

mirror! {
    /// Velocity over the central part of the path (8.6).
    struct Iso9283Velocity of PathVelocity as v {
        /// Commanded velocity.
        commanded_mm_s: f64,
        /// Mean velocity of all passes.
        mean_mm_s: f64,
        /// AV: path velocity accuracy.
        av_percent: f64,
        /// RV: path velocity repeatability; null with a single pass.
        rv_percent: Option<f64> = Some(v.rv_percent).filter(|rv| rv.is_finite()),
        /// FV: path velocity fluctuation, including the instrument's noise.
        fv_mm_s: f64,
    }
}

mirror! {
    /// A corner of the commanded path (8.5).
    struct Iso9283Corner of PathCorner as c {
        /// Commanded corner: x, y and, if spatial, z.
        position_mm: Vec<f64>,
        /// CR: round-off.
        cr_mm: f64 = c.driven.round_off_mm,
        /// CO: overshoot.
        co_mm: f64 = c.driven.overshoot_mm,
        /// Length along the second leg until the path stays within the limit band; null without a
        /// band, and if the path never stays within it.
        stabilisation_mm: Option<f64> = c.driven.stabilisation_mm,
    }
}

mirror! {
    /// A weave (11): means of all passes.
    struct Iso9283Weaving of WeaveCharacteristics {
        /// Number of passes of the centre line.
        passes: usize,
        /// Number of turns counted in all passes.
        turns: usize,
        /// Commanded stroke from side to side.
        commanded_stroke_mm: f64,
        /// Attained stroke.
        stroke_mm: f64,
        /// Commanded frequency: full swings per second.
        commanded_frequency_hz: f64,
        /// Attained frequency.
        frequency_hz: f64,
        /// WS: attained minus commanded stroke (% of the commanded stroke).
        ws_percent: f64,
        /// WF: attained minus commanded frequency (% of the commanded frequency).
        wf_percent: f64,
    }
}
