//! From a recorded motion to its characteristics by ISO 9283.

pub mod overshoot;
pub mod posing_time;
pub mod stabilisation;
pub mod standstill;
mod stated;
pub mod stream;

use crate::iso9283::motion::overshoot::overshoot_mm;
use crate::iso9283::motion::posing_time::{Posing, posing};
use crate::iso9283::motion::stabilisation::{Arrival, arrival, stabilisation_time_s, watched};
use crate::iso9283::motion::standstill::{Standstill, Stillness, places_mm, standstills, visited};
use crate::iso9283::motion::stream::{Recording, Stream};
use crate::iso9283::path::{CORNER_RAD, Driven, PathSettings};
use crate::iso9283::pose::repeatability::pose_repeatability;
use crate::iso9283::pose::test::CommandedPose;
use etalon_base::message::{Message, Result, count};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_documents::{Iso9283Arrival, Iso9283Posing, Iso9283Settling, Iso9283Standstill, Iso9283StreamDocument};
use etalon_math::statistics::mean;
pub use stated::Stated;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Arrivals of a pose that are reported with their course: the standard's cycles.
const SHOWN_ARRIVALS: usize = 3;
/// At least this long, with at most so many samples.
const SHOWN_S: f64 = 0.2;
const SHOWN_SAMPLES: usize = 200;

/// What the recording does not state.
#[derive(Clone, Debug)]
pub struct Settings {
    /// What counts as standing.
    pub still: Stillness,
    /// How near a standstill is to its pose, and an attained path to the commanded one.
    pub near_mm: f64,
    /// Limit band of 7.4 and 7.5; without it there are none.
    pub band_mm: Option<f64>,
    /// Commanded poses with their numbers; without them places are numbered as they come.
    pub poses: Option<Vec<CommandedPose>>,
    /// Commanded path.
    pub path: Option<PathSettings>,
    /// Where times come from, in words.
    pub time: String,
    /// Seed of the bootstrap intervals.
    pub seed: u64,
}

/// All characteristics of the recording.
pub fn evaluate(recording: &Recording, settings: &Settings) -> Result<Iso9283StreamDocument> {
    let stream = &recording.stream;
    let mut messages = Vec::new();
    if !recording.left_out.is_empty() {
        let lines: Vec<String> = recording.left_out.iter().take(10).map(usize::to_string).collect();
        let what = format!("{} left out: no robot moves as fast", count(recording.left_out.len(), "sample"));
        messages.push(Message::warning(what).hint(format!("look at line {}", lines.join(", "))));
    }
    if settings.path.as_ref().is_some_and(|p| p.weave.is_some() && p.velocity_mm_s.is_some()) {
        let message =
            Message::warning("the commanded velocity is not compared: the path is the centre line of a weave");
        messages.push(message.hint("velocities are those of a path that is driven without weaving"));
    }
    let stood = standstills(stream, &settings.still)?;
    let places: Vec<CommandedPose> = match &settings.poses {
        Some(poses) => poses.clone(),
        None => (1..)
            .zip(places_mm(&stood, settings.near_mm))
            .map(|(number, position_mm): (i64, _)| CommandedPose { pose: number.into(), position_mm })
            .collect(),
    };
    let visits = visits(&stood, &places, settings.near_mm);
    let standing = standing(recording, &stood, &visits, settings.band_mm, &mut messages);
    let time_s = stream.time_s();
    let mut document = Iso9283StreamDocument {
        schema: "etalon/iso9283-stream/1".to_owned(),
        conventions: conventions(recording, settings),
        samples: stream.len(),
        left_out: recording.left_out.clone(),
        duration_s: time_s[time_s.len() - 1] - time_s[0],
        settling: settling(&standing),
        arrivals: arrivals(stream, &stood, &standing),
        posing: moves(&standing),
        standstills: standing.into_iter().map(|s| s.standstill).collect(),
        path: None,
        weaving: None,
        messages,
    };
    if let Some(path) = &settings.path {
        let driven = Driven::new(recording, path, settings.near_mm)?;
        match &path.weave {
            Some(weave) => document.weaving = Some(driven.weaving(weave)?),
            None => document.path = Some(driven.path(settings.band_mm, settings.seed)?),
        }
        document.messages.extend(driven.warnings());
    }
    Ok(document)
}

fn conventions(recording: &Recording, settings: &Settings) -> Vec<String> {
    let mut conventions = vec![
        settings.time.clone(),
        format!(
            "standing: within {} mm of the mean for {} s or longer; a pose is visited within {} mm; its position is the \
             mean of the middle half of the standstill",
            settings.still.radius_mm, settings.still.duration_s, settings.near_mm
        ),
        "clauses 7.4, 7.5, 8, 9 and 11 were not compared with a bought copy of the standard".to_owned(),
    ];
    if let Some(band) = settings.band_mm {
        conventions.push(format!("limit band: {band} mm about the mean of the standstill"));
    }
    if let Some(path) = &settings.path {
        let mut text = format!(
            "path: normal planes at {} command points, the middles of equal parts; the last crossing of each within {} mm",
            path.points, settings.near_mm
        );
        if path.velocity_mm_s.is_some() && path.weave.is_none() {
            let _ = write!(text, "; velocities between them in the central {} %", 100.0 * path.central);
        }
        if !path.path.corners(CORNER_RAD).is_empty() {
            let _ = write!(
                text,
                "; none within {} mm of a corner (at most a quarter of its leg), which is reported by itself",
                settings.near_mm
            );
        }
        conventions.push(text);
        if path.weave.is_none() {
            conventions.push(
                "AT and RT: intervals by parametric bootstrap over the passes, of the AT and RT of infinitely many; in simulated \
                 tests of ten passes they hold the truth in 90 to 98 % by the kind of scatter"
                    .to_owned(),
            );
        }
    }
    if !recording.angles.is_empty() {
        let names: Vec<&str> = recording.angles.iter().map(|&k| ["a", "b", "c"][k]).collect();
        conventions.push(format!("angles {} are followed along the motion and treated each alone", names.join(", ")));
    }
    conventions
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

/// A standstill in the document, and its arrival.
struct Standing {
    standstill: Iso9283Standstill,
    arrival: Option<Arrival>,
    posing: Option<Posing>,
}

fn standing(
    recording: &Recording,
    stood: &[Standstill],
    visits: &[Option<(PoseName, i64)>],
    band_mm: Option<f64>,
    messages: &mut Vec<Message>,
) -> Vec<Standing> {
    let stream = &recording.stream;
    let axes = if recording.spatial { 3 } else { 2 };
    let mut unsettled = Vec::new();
    let mut all = Vec::new();
    for (i, s) in stood.iter().enumerate() {
        let before = i.checked_sub(1).map(|i| &stood[i]);
        let arrived = band_mm.and_then(|band| arrival(stream, before, s, band));
        let from_s = stream.time_s()[s.samples.start];
        if band_mm.is_some() && arrived.is_none() && s.samples.start > 0 {
            unsettled.push(format!("{from_s:.3}"));
        }
        let posing = before.zip(arrived).map(|(before, arrived)| posing(stream, before, s, &arrived));
        all.push(Standing {
            standstill: Iso9283Standstill {
                pose: visits[i].map(|v| v.0),
                cycle: visits[i].map(|v| v.1),
                from_s,
                to_s: stream.time_s()[s.samples.end - 1],
                samples: s.samples.len(),
                mean_mm: s.mean_mm[..axes].to_vec(),
                mean_deg: s.angles_rad.iter().map(|a| a.to_degrees()).collect(),
                noise_mm: pose_repeatability(&stream.positions_mm()[s.middle()]).ok().map(|r| r.rp_mm),
                stabilisation_s: arrived.map(|arrival| arrival.stabilisation_s),
                overshoot_mm: arrived.map(|arrived| overshoot_mm(stream, before, s, &arrived)),
                posing_s: posing.map(|p| p.time_s),
            },
            arrival: arrived,
            posing,
        });
    }
    if !unsettled.is_empty() {
        let what = format!("arrivals that do not settle within the limit band: at {} s", unsettled.join(", "));
        messages.push(Message::warning(what).hint("the band must be wider than the noise of the standing robot"));
    }
    all
}

fn settling(standing: &[Standing]) -> Vec<Iso9283Settling> {
    let mut by_pose: BTreeMap<PoseName, (Vec<Arrival>, f64)> = BTreeMap::new();
    for s in standing {
        let (Some(pose), Some(arrival), Some(overshoot)) = (s.standstill.pose, s.arrival, s.standstill.overshoot_mm)
        else {
            continue;
        };
        let (arrivals, largest) = by_pose.entry(pose).or_default();
        arrivals.push(arrival);
        *largest = largest.max(overshoot);
    }
    let settled = |(pose, (arrivals, overshoot_mm)): (PoseName, (Vec<Arrival>, f64))| {
        let stabilisation_s = stabilisation_time_s(&arrivals)?;
        Some(Iso9283Settling { pose, arrivals: arrivals.len(), stabilisation_s, overshoot_mm })
    };
    by_pose.into_iter().filter_map(settled).collect()
}

/// The first arrivals at each pose, until twice the time that they took to settle.
fn arrivals(stream: &Stream, stood: &[Standstill], standing: &[Standing]) -> Vec<Iso9283Arrival> {
    let mut all: Vec<Iso9283Arrival> = Vec::new();
    for (i, (s, standing)) in stood.iter().zip(standing).enumerate() {
        let (Some(arrival), Some(pose), Some(cycle)) =
            (standing.arrival, standing.standstill.pose, standing.standstill.cycle)
        else {
            continue;
        };
        if all.iter().filter(|a| a.pose == pose).count() == SHOWN_ARRIVALS {
            continue;
        }
        let entered_s = stream.time_s()[arrival.entered];
        let last_s = entered_s + (2.0 * arrival.stabilisation_s).max(SHOWN_S);
        let end = watched(i.checked_sub(1).map(|i| &stood[i]), s).end;
        let shown: Vec<usize> = (arrival.entered..end).take_while(|&k| stream.time_s()[k] <= last_s).collect();
        let shown = || shown.iter().step_by(shown.len().div_ceil(SHOWN_SAMPLES).max(1));
        all.push(Iso9283Arrival {
            pose,
            cycle,
            time_s: shown().map(|&k| stream.time_s()[k] - entered_s).collect(),
            away_mm: shown().map(|&k| norm(minus(stream.positions_mm()[k], s.mean_mm))).collect(),
        });
    }
    all
}

fn moves(standing: &[Standing]) -> Vec<Iso9283Posing> {
    let mut by_pair: BTreeMap<(PoseName, PoseName), Vec<Posing>> = BTreeMap::new();
    for pair in standing.windows(2) {
        if let (Some(from), Some(to), Some(posing)) = (pair[0].standstill.pose, pair[1].standstill.pose, pair[1].posing)
        {
            by_pair.entry((from, to)).or_default().push(posing);
        }
    }
    let mean_move = |((from, to), moves): ((PoseName, PoseName), Vec<Posing>)| {
        let mean = |of: fn(&Posing) -> f64| mean(moves.iter().map(of));
        Iso9283Posing {
            from,
            to,
            moves: moves.len(),
            distance_mm: mean(|p| p.distance_mm),
            posing_s: mean(|p| p.time_s),
        }
    };
    by_pair.into_iter().map(mean_move).collect()
}
