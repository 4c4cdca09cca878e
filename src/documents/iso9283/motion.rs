//! Recorded motions (ISO 9283:1998 7.4, 7.5, 9).

use super::pose::{misplacement, not_separable};
use super::{Iso9283Path, Iso9283Weaving, all, degrees};
use crate::mirror::mirror;
use crate::worded::worded;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use etalon_base::{error, phrase, warning};
use etalon_standards::iso9283::misplacement::{misplaced_motion, misplaced_path};
use etalon_standards::iso9283::motion::by_pose::{Course, Moves, Settling, courses, moves, settling};
use etalon_standards::iso9283::motion::stream::Recording;
use etalon_standards::iso9283::motion::{MotionSettings, Standing, standing};
use etalon_standards::iso9283::path::velocity::PathVelocity;
use etalon_standards::iso9283::path::{CORNER_RAD, Driven, PASSES, PassError, PathSettings};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Recorded motions of a campaign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283StreamsDocument {
    /// Schema and version: `etalon/iso9283-streams/1`.
    pub schema: String,
    /// One per `[[stream]]`.
    pub streams: Vec<Iso9283NamedStream>,
}

impl Iso9283StreamsDocument {
    /// Messages of all recordings.
    pub fn messages(&self) -> impl Iterator<Item = &Message> {
        self.streams.iter().flat_map(|s| &s.stream.messages)
    }
}

/// A recorded motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283NamedStream {
    /// Name in the campaign.
    pub name: String,
    /// File, as in the campaign.
    pub file: String,
    /// Limit band, if given.
    pub band_mm: Option<f64>,
    /// Characteristics of the recording.
    pub stream: Iso9283StreamDocument,
}

/// Characteristics of ISO 9283:1998 of a recorded motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283StreamDocument {
    /// Schema and version: `etalon/iso9283-stream/1`.
    pub schema: String,
    /// Thresholds, origin of times, and clauses that are not verified against the standard, in
    /// words.
    #[serde(flatten, with = "Iso9283StreamConventions")]
    pub conventions: Vec<Worded>,
    /// Number of evaluated samples.
    pub samples: usize,
    /// Lines of samples that are omitted because no robot moves there from the previous sample in
    /// time.
    pub left_out: Vec<usize>,
    /// Time from the first to the last sample.
    pub duration_s: f64,
    /// All standstills in the order of time.
    pub standstills: Vec<Iso9283Standstill>,
    /// Arrivals by pose; empty without a limit band.
    pub settling: Vec<Iso9283Settling>,
    /// First arrivals at each pose, for the chart of stabilisation; empty without a limit band.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub arrivals: Vec<Iso9283Arrival>,
    /// Moves between poses; empty without a limit band.
    pub posing: Vec<Iso9283Posing>,
    /// Characteristics of the commanded path, if a path without weaving is given.
    pub path: Option<Iso9283Path>,
    /// Characteristics of the weave, if given.
    pub weaving: Option<Iso9283Weaving>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
}

worded! {
    /// Thresholds, origin of times, and clauses that are not verified against the standard, in
    /// words.
    list Iso9283StreamConventions: conventions, convention_phrases
}

mirror! {
    /// A standstill.
    struct Iso9283Standstill of Standing as s {
        /// Name of the visited pose; null if no pose is near.
        pose: Option<PoseName> = s.visit.map(|v| v.0),
        /// Number of the visit of that pose, from 1.
        cycle: Option<i64> = s.visit.map(|v| v.1),
        /// Time of the first sample.
        from_s: f64,
        /// Time of the last sample.
        to_s: f64,
        /// Number of samples.
        samples: usize = s.standstill.samples.len(),
        /// Mean position of the middle half: x, y and, if measured, z.
        mean_mm: Vec<f64>,
        /// Means of the measured angles, in the order a, b, c; angles of the middle sample if two
        /// of them are not separable.
        mean_deg: Vec<f64> = degrees(&s.standstill.angles_rad),
        /// Noise of the instrument and of the robot at standstill: mean radius plus three standard
        /// deviations of the samples of the middle half.
        noise_mm: Option<f64>,
        /// Stabilisation time of the arrival (7.4); null without a limit band, and if the position
        /// does not enter or stay within the band.
        stabilisation_s: Option<f64> = s.arrival.map(|a| a.stabilisation_s),
        /// Overshoot of the arrival (7.5); null without a limit band.
        overshoot_mm: Option<f64>,
        /// Posing time from the previous standstill (9); null without a limit band.
        posing_s: Option<f64> = s.posing.map(|p| p.time_s),
    }
}

mirror! {
    /// Arrivals at one pose (7.4, 7.5).
    struct Iso9283Settling of Settling {
        /// Name of the pose.
        pose: PoseName,
        /// Number of arrivals that settled.
        arrivals: usize,
        /// Mean stabilisation time.
        stabilisation_s: f64,
        /// Expanded uncertainty of this time: scatter of the arrivals, and sampling interval.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        stabilisation_expanded_uncertainty_s: Option<f64>,
        /// Largest overshoot; zero if no arrival left the limit band again.
        overshoot_mm: f64,
        /// Expanded uncertainty of this overshoot: scatter of a sample about the standstill.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        overshoot_expanded_uncertainty_mm: Option<f64>,
    }
}

mirror! {
    /// One arrival, from the first entry into the limit band.
    struct Iso9283Arrival of Course {
        /// Name of the pose.
        pose: PoseName,
        /// Number of the visit of that pose, from 1.
        cycle: i64,
        /// Times since the entry.
        time_s: Vec<f64>,
        /// Distances from the standstill.
        away_mm: Vec<f64>,
    }
}

mirror! {
    /// Moves from one pose to another (9).
    struct Iso9283Posing of Moves as p {
        /// Pose at the start.
        from: PoseName,
        /// Pose at the end.
        to: PoseName,
        /// Number of moves.
        moves: usize,
        /// Mean straight distance between the standstills.
        distance_mm: f64,
        /// Mean length of the attained path, in steps longer than the limit band; absent in
        /// documents of earlier programs.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        path_mm: Option<f64> = Some(p.path_mm),
        /// Mean posing time.
        posing_s: f64,
        /// Expanded uncertainty of this time: scatter of the moves, and sampling interval.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        posing_expanded_uncertainty_s: Option<f64>,
    }
}

impl Iso9283StreamDocument {
    /// Evaluates all characteristics of a recording.
    pub fn evaluate(recording: &Recording, settings: &MotionSettings) -> Result<Self> {
        let stream = &recording.stream;
        let standing = standing(recording, settings)?;
        let time_s = stream.time_s();
        let conventions = conventions(recording, settings);
        let mut document = Self {
            schema: "etalon/iso9283-stream/1".to_owned(),
            conventions: all(conventions),
            samples: stream.len(),
            left_out: recording.left_out.clone(),
            duration_s: time_s[time_s.len() - 1] - time_s[0],
            settling: all(settling(stream, &standing)),
            arrivals: all(courses(stream, &standing)),
            posing: all(moves(stream, &standing)),
            messages: messages(recording, settings, &standing),
            standstills: all(standing),
            path: None,
            weaving: None,
        };
        if let Some(found) = misplaced_motion(recording, settings) {
            document.messages.push(misplacement(&found)?);
        }
        if let Some(path) = &settings.path {
            let driven =
                Driven::new(recording, path, settings.near_mm).map_err(|e| without_pass(e, settings.near_mm))?;
            match &path.weave {
                Some(weave) => document.weaving = Some(driven.weaving(weave)?.into()),
                None => {
                    let found = driven.characteristics(settings.band_mm, settings.seed)?;
                    let place = phrase!("angles-of-path");
                    document.messages.extend(found.inseparable.map(|angles| not_separable(angles, false, place)));
                    document.messages.extend(found.velocity.and_then(|v| far_velocity(&v)));
                    if let Some(shifted) = misplaced_path(&driven.points, &found.at.position.means_mm) {
                        document.messages.push(misplacement(&shifted)?);
                    }
                    document.path = Some(found.into());
                }
            }
            document.messages.extend(path_messages(&driven, path));
        }
        Ok(document)
    }
}

/// Ratio of mean and commanded velocity that no robot has: one is in another unit.
const OTHER_VELOCITY: f64 = 5.0;

/// Warning of a velocity in another unit than mm/s, or of times in another unit than s.
fn far_velocity(v: &PathVelocity) -> Option<Message> {
    let ratio = v.mean_mm_s / v.commanded_mm_s;
    let is_far = !(1.0 / OTHER_VELOCITY..=OTHER_VELOCITY).contains(&ratio);
    let (mean_mm_s, commanded_mm_s) = (v.mean_mm_s, v.commanded_mm_s);
    is_far.then(|| warning!("path-velocity-far", mean_mm_s, commanded_mm_s).to_decide())
}

/// Error of a motion without a pass of its path.
fn without_pass(error: PassError, near_mm: f64) -> Problems {
    let planes = match error {
        PassError::NoPass { planes } => planes,
        PassError::Other(problems) => return problems,
    };
    error!("path-without-pass", planes, near_mm).into()
}

/// Warnings of a recording and its standstills.
fn messages(recording: &Recording, settings: &MotionSettings, standing: &[Standing]) -> Vec<Message> {
    let mut messages = Vec::new();
    if !recording.left_out.is_empty() {
        let lines: Vec<usize> = recording.left_out.iter().copied().take(10).collect();
        messages.push(warning!("samples-too-fast", count = recording.left_out.len(), lines));
    }
    if settings.path.as_ref().is_some_and(|p| p.weave.is_some() && p.velocity_mm_s.is_some()) {
        messages.push(warning!("weave-velocity-not-compared"));
    }
    let locked: Vec<(f64, [usize; 2])> =
        standing.iter().filter_map(|s| Some(((1e3 * s.from_s).round() / 1e3, s.standstill.inseparable?))).collect();
    if let Some((_, angles)) = locked.first() {
        let times_s: Vec<f64> = locked.iter().take(10).map(|(from_s, _)| *from_s).collect();
        messages.push(not_separable(*angles, false, phrase!("angles-of-standstills", count = locked.len(), times_s)));
    }
    let begins = |s: &&Standing| s.arrival.is_none() && s.standstill.samples.start > 0;
    let unsettled = standing.iter().filter(begins).map(|s| (1e3 * s.from_s).round() / 1e3);
    let unsettled: Vec<f64> = unsettled.collect();
    if settings.band_mm.is_some() && !unsettled.is_empty() {
        messages.push(warning!("arrivals-unsettled", times_s = unsettled));
    }
    messages
}

/// Warnings of a path: unfinished passes, and a corner where the velocity should be constant.
fn path_messages(driven: &Driven, path: &PathSettings) -> Vec<Message> {
    let mut messages = Vec::new();
    if driven.passes.incomplete > 0 {
        messages.push(warning!("passes-incomplete", count = driven.passes.incomplete));
    }
    let complete = driven.passes.complete.len();
    if path.weave.is_none() && complete < PASSES {
        messages.push(warning!("few-passes", least = PASSES, count = complete));
    }
    let compared = path.velocity_mm_s.is_some() && path.weave.is_none();
    if let Some(corner) = driven.central_corner().filter(|_| compared) {
        messages.push(warning!("corner-in-central-part", at_mm = corner.along_mm[1]));
    }
    messages
}

fn conventions(recording: &Recording, settings: &MotionSettings) -> Vec<Phrase> {
    let still = settings.still;
    let mut conventions = vec![
        settings.time.clone(),
        phrase!("convention-standing", radius = still.radius_mm, duration = still.duration_s, near = settings.near_mm),
        phrase!("convention-motion-clauses"),
    ];
    if let Some(band) = settings.band_mm {
        conventions.push(phrase!("convention-limit-band", band));
    }
    if let Some(path) = &settings.path {
        conventions.push(phrase!("convention-path", points = path.points, near = settings.near_mm));
        if path.velocity_mm_s.is_some() && path.weave.is_none() {
            conventions.push(phrase!("convention-path-velocities", percent = 100.0 * path.central));
        }
        if !path.path.corners(CORNER_RAD).is_empty() {
            conventions.push(phrase!("convention-path-corners", near = settings.near_mm));
        }
        if path.weave.is_none() {
            conventions.push(phrase!("convention-path-intervals"));
        }
    }
    if !recording.angles.is_empty() {
        let angles: Vec<&str> = recording.angles.iter().map(|&k| ["a", "b", "c"][k]).collect();
        conventions.push(phrase!("convention-angles-of-motion", angles));
    }
    conventions
}
