//! Arrivals and moves of a recording by pose (ISO 9283:1998 7.4, 7.5, 9).

use crate::iso9283::motion::Standing;
use crate::iso9283::motion::posing_time::Posing;
use crate::iso9283::motion::stabilisation::{Arrival, stabilisation_time_s};
use crate::iso9283::motion::stream::Stream;
use crate::iso9283::statistics::repeats::mean_uncertainty;
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
    /// Expanded uncertainty of this time: scatter of the arrivals, and sampling interval.
    pub stabilisation_expanded_uncertainty_s: Option<f64>,
    /// Largest overshoot; zero if no arrival left the limit band again.
    pub overshoot_mm: f64,
    /// Expanded uncertainty of this overshoot: scatter of a sample about the standstill, without
    /// the motion between two samples.
    pub overshoot_expanded_uncertainty_mm: Option<f64>,
}

/// Stabilisation and overshoot by pose.
pub fn settling(stream: &Stream, standing: &[Standing]) -> Vec<Settling> {
    let mut by_pose: BTreeMap<PoseName, Vec<(&Standing, Arrival, f64)>> = BTreeMap::new();
    for s in standing {
        if let (Some((pose, _)), Some(arrival), Some(overshoot)) = (s.visit, s.arrival, s.overshoot_mm) {
            by_pose.entry(pose).or_default().push((s, arrival, overshoot));
        }
    }
    let settled = |(pose, found): (PoseName, Vec<(&Standing, Arrival, f64)>)| {
        let arrivals: Vec<Arrival> = found.iter().map(|(_, arrival, _)| *arrival).collect();
        let times: Vec<f64> = arrivals.iter().map(|arrival| arrival.stabilisation_s).collect();
        let (farthest, _, overshoot_mm) = found.into_iter().max_by(|a, b| a.2.total_cmp(&b.2))?;
        Some(Settling {
            pose,
            arrivals: arrivals.len(),
            stabilisation_s: stabilisation_time_s(&arrivals)?,
            stabilisation_expanded_uncertainty_s: mean_uncertainty(&times, interval_s(stream)),
            overshoot_mm,
            overshoot_expanded_uncertainty_mm: scatter_mm(stream, farthest)
                .filter(|_| overshoot_mm > 0.0)
                .map(|u| 2.0 * u),
        })
    };
    by_pose.into_iter().filter_map(settled).collect()
}

/// Median interval of the samples.
fn interval_s(stream: &Stream) -> f64 {
    let mut steps: Vec<f64> = stream.time_s().windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    steps[steps.len() / 2]
}

/// Standard deviation (mm) of a coordinate of a sample about the mean of the standstill, with the
/// uncertainty of this mean (GUM 4.2.2, 4.2.3): noise of the instrument and of the standing robot.
fn scatter_mm(stream: &Stream, standing: &Standing) -> Option<f64> {
    let samples = &stream.positions_mm()[standing.standstill.middle()];
    let (n, dimension) = (samples.len() as f64, standing.mean_mm.len() as f64);
    let squares: f64 = samples.iter().map(|p| norm(minus(*p, standing.standstill.mean_mm)).powi(2)).sum();
    (samples.len() > 1).then(|| (squares / ((n - 1.0) * dimension) * (1.0 + 1.0 / n)).sqrt())
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
    /// Mean straight distance between the standstills.
    pub distance_mm: f64,
    /// Mean length of the attained path.
    pub path_mm: f64,
    /// Mean posing time.
    pub posing_s: f64,
    /// Expanded uncertainty of this time: scatter of the moves, and sampling interval.
    pub posing_expanded_uncertainty_s: Option<f64>,
}

/// Posing times by pair of poses.
pub fn moves(stream: &Stream, standing: &[Standing]) -> Vec<Moves> {
    let mut by_pair: BTreeMap<(PoseName, PoseName), Vec<Posing>> = BTreeMap::new();
    for pair in standing.windows(2) {
        if let (Some((from, _)), Some((to, _)), Some(posing)) = (pair[0].visit, pair[1].visit, pair[1].posing) {
            by_pair.entry((from, to)).or_default().push(posing);
        }
    }
    let mean_move = |((from, to), moves): ((PoseName, PoseName), Vec<Posing>)| {
        let mean = |of: fn(&Posing) -> f64| moves.iter().map(of).sum::<f64>() / moves.len() as f64;
        let times: Vec<f64> = moves.iter().map(|posing| posing.time_s).collect();
        Moves {
            from,
            to,
            moves: moves.len(),
            distance_mm: mean(|p| p.distance_mm),
            path_mm: mean(|p| p.path_mm),
            posing_s: mean(|p| p.time_s),
            posing_expanded_uncertainty_s: mean_uncertainty(&times, interval_s(stream)),
        }
    };
    by_pair.into_iter().map(mean_move).collect()
}
