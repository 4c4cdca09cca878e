//! Recorded motions: standstills, arrivals and moves between poses.

pub mod by_pose;
pub mod overshoot;
pub mod posing_time;
pub mod stabilisation;
pub mod standstill;
pub mod stream;

use crate::iso9283::motion::overshoot::overshoot_mm;
use crate::iso9283::motion::posing_time::{Posing, posing};
use crate::iso9283::motion::stabilisation::{Arrival, arrival, watched};
use crate::iso9283::motion::standstill::{Standstill, Stillness, places_mm, standstills, visited};
use crate::iso9283::motion::stream::Recording;
use crate::iso9283::path::PathSettings;
use crate::iso9283::pose::repeatability::pose_repeatability;
use crate::iso9283::pose::test::CommandedPose;
use crate::iso9283::statistics::sample::coordinates;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use std::collections::BTreeMap;
use std::ops::Range;

/// Settings that a recording does not contain.
#[derive(Clone, Debug)]
pub struct MotionSettings {
    /// Criterion for standstill.
    pub still: Stillness,
    /// Largest distance of a standstill from its pose, and of an attained path from the commanded
    /// path.
    pub near_mm: f64,
    /// Limit band of 7.4 and 7.5, whose characteristics are omitted without it.
    pub band_mm: Option<f64>,
    /// Commanded poses with their numbers; without them places are numbered in the order of
    /// arrival.
    pub poses: Option<Vec<CommandedPose>>,
    /// Commanded path.
    pub path: Option<PathSettings>,
    /// Origin of the times, in words.
    pub time: Phrase,
    /// Seed of the bootstrap intervals.
    pub seed: u64,
}

/// A standstill, and the arrival at it.
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    /// Visited pose and number of the visit, from 1; `None` if no pose is near.
    pub visit: Option<(PoseName, i64)>,
    /// Standstill.
    pub standstill: Standstill,
    /// Time of the first sample.
    pub from_s: f64,
    /// Time of the last sample.
    pub to_s: f64,
    /// Mean position of the standstill: x, y and, if spatial, z.
    pub mean_mm: Vec<f64>,
    /// Mean radius plus three standard deviations of the samples of the middle half: noise of
    /// instrument and hold.
    pub noise_mm: Option<f64>,
    /// Samples in which the arrival is evaluated.
    pub watched: Range<usize>,
    /// Arrival; `None` without a limit band, and if the position does not enter or stay within the
    /// band.
    pub arrival: Option<Arrival>,
    /// Overshoot of the arrival.
    pub overshoot_mm: Option<f64>,
    /// Move from the previous standstill.
    pub posing: Option<Posing>,
}

/// All standstills of a recording, in the order of time.
pub fn standing(recording: &Recording, settings: &MotionSettings) -> Result<Vec<Standing>> {
    let stream = &recording.stream;
    let stood = standstills(stream, &settings.still)?;
    let places: Vec<CommandedPose> = match &settings.poses {
        Some(poses) => poses.clone(),
        None => (1..)
            .zip(places_mm(&stood, settings.near_mm))
            .map(|(number, position_mm): (i64, _)| CommandedPose { pose: number.into(), position_mm })
            .collect(),
    };
    let visits = visits(&stood, &places, settings.near_mm);
    type Visit<'s> = (&'s Standstill, Option<(PoseName, i64)>);
    let standing = |(i, (s, visit)): (usize, Visit)| {
        let before = i.checked_sub(1).map(|i| &stood[i]);
        let arrived = settings.band_mm.and_then(|band| arrival(stream, before, s, band));
        Standing {
            visit,
            from_s: stream.time_s()[s.samples.start],
            to_s: stream.time_s()[s.samples.end - 1],
            mean_mm: coordinates(s.mean_mm, recording.spatial),
            noise_mm: pose_repeatability(&stream.positions_mm()[s.middle()]).ok().map(|r| r.rp_mm),
            watched: watched(before, s),
            arrival: arrived,
            overshoot_mm: arrived.map(|arrived| overshoot_mm(stream, before, s, &arrived)),
            posing: before.zip(arrived).map(|(before, arrived)| posing(stream, before, s, &arrived)),
            standstill: s.clone(),
        }
    };
    Ok(stood.iter().zip(visits).enumerate().map(standing).collect())
}

/// Pose and number of the visit of each standstill.
fn visits(stood: &[Standstill], places: &[CommandedPose], near_mm: f64) -> Vec<Option<(PoseName, i64)>> {
    let positions: Vec<Vector> = places.iter().map(|p| p.position_mm).collect();
    let mut counts: BTreeMap<PoseName, i64> = BTreeMap::new();
    let mut visit = |place: Option<usize>| {
        let pose = places[place?].pose;
        let cycle = counts.entry(pose).or_default();
        *cycle += 1;
        Some((pose, *cycle))
    };
    visited(stood, &positions, near_mm).into_iter().map(&mut visit).collect()
}
