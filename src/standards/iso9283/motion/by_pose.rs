//! Arrivals and moves of a recording by pose (ISO 9283:1998 7.4, 7.5, 9).

use crate::iso9283::motion::Standing;
use crate::iso9283::motion::posing_time::Posing;
use crate::iso9283::motion::stabilisation::{Arrival, stabilisation_time_s};
use crate::iso9283::motion::stream::Stream;
use etalon_base::pose::{minus, norm};
use etalon_base::pose_name::PoseName;
use std::collections::BTreeMap;

/// Number of arrivals per pose whose course is reported: the number of cycles of the standard.
const SHOWN_ARRIVALS: usize = 3;
/// Minimum duration of a course, and maximum number of its samples.
const SHOWN_S: f64 = 0.2;
const SHOWN_SAMPLES: usize = 200;

/// Arrivals at one pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Settling {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of arrivals that settled.
    pub arrivals: usize,
    /// Mean stabilisation time.
    pub stabilisation_s: f64,
    /// Largest overshoot; zero if no arrival left the limit band again.
    pub overshoot_mm: f64,
}

/// Stabilisation and overshoot by pose.
pub fn settling(standing: &[Standing]) -> Vec<Settling> {
    let mut by_pose: BTreeMap<PoseName, (Vec<Arrival>, f64)> = BTreeMap::new();
    for s in standing {
        let (Some((pose, _)), Some(arrival), Some(overshoot)) = (s.visit, s.arrival, s.overshoot_mm) else { continue };
        let (arrivals, largest) = by_pose.entry(pose).or_default();
        arrivals.push(arrival);
        *largest = largest.max(overshoot);
    }
    let settled = |(pose, (arrivals, overshoot_mm)): (PoseName, (Vec<Arrival>, f64))| {
        let stabilisation_s = stabilisation_time_s(&arrivals)?;
        Some(Settling { pose, arrivals: arrivals.len(), stabilisation_s, overshoot_mm })
    };
    by_pose.into_iter().filter_map(settled).collect()
}

/// Course of one arrival, from the first entry into the limit band.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the visit of that pose, from 1.
    pub cycle: i64,
    /// Times since the entry.
    pub time_s: Vec<f64>,
    /// Distances from the standstill.
    pub away_mm: Vec<f64>,
}

/// Courses of the first arrivals at each pose, up to twice the settling time.
pub fn courses(stream: &Stream, standing: &[Standing]) -> Vec<Course> {
    let mut all: Vec<Course> = Vec::new();
    for s in standing {
        let (Some(arrival), Some((pose, cycle))) = (s.arrival, s.visit) else { continue };
        if all.iter().filter(|a| a.pose == pose).count() == SHOWN_ARRIVALS {
            continue;
        }
        let entered_s = stream.time_s()[arrival.entered];
        let last_s = entered_s + (2.0 * arrival.stabilisation_s).max(SHOWN_S);
        let shown: Vec<usize> =
            (arrival.entered..s.watched.end).take_while(|&k| stream.time_s()[k] <= last_s).collect();
        let shown = || shown.iter().step_by(shown.len().div_ceil(SHOWN_SAMPLES).max(1));
        all.push(Course {
            pose,
            cycle,
            time_s: shown().map(|&k| stream.time_s()[k] - entered_s).collect(),
            away_mm: shown().map(|&k| norm(minus(stream.positions_mm()[k], s.standstill.mean_mm))).collect(),
        });
    }
    all
}

/// Moves from one pose to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Moves {
    /// Pose at the start.
    pub from: PoseName,
    /// Pose at the end.
    pub to: PoseName,
    /// Number of moves.
    pub moves: usize,
    /// Mean attained distance.
    pub distance_mm: f64,
    /// Mean posing time.
    pub posing_s: f64,
}

/// Posing times by pair of poses.
pub fn moves(standing: &[Standing]) -> Vec<Moves> {
    let mut by_pair: BTreeMap<(PoseName, PoseName), Vec<Posing>> = BTreeMap::new();
    for pair in standing.windows(2) {
        if let (Some((from, _)), Some((to, _)), Some(posing)) = (pair[0].visit, pair[1].visit, pair[1].posing) {
            by_pair.entry((from, to)).or_default().push(posing);
        }
    }
    let mean_move = |((from, to), moves): ((PoseName, PoseName), Vec<Posing>)| {
        let mean = |of: fn(&Posing) -> f64| moves.iter().map(of).sum::<f64>() / moves.len() as f64;
        Moves { from, to, moves: moves.len(), distance_mm: mean(|p| p.distance_mm), posing_s: mean(|p| p.time_s) }
    };
    by_pair.into_iter().map(mean_move).collect()
}
