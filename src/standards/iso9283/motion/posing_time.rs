//! Minimum posing time (ISO 9283:1998 9, unverified against a bought copy): time from leaving a
//! pose to standing at the next, including stabilisation.

use crate::iso9283::motion::stabilisation::{Arrival, away_mm};
use crate::iso9283::motion::standstill::Standstill;
use crate::iso9283::motion::stream::Stream;
use etalon_base::pose::{Vector, minus, norm};
use std::ops::Range;

/// One move from a standstill to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Posing {
    /// Straight distance between the standstills.
    pub distance_mm: f64,
    /// Length of the attained path, in steps longer than the limit band, which noise does not
    /// lengthen.
    pub path_mm: f64,
    /// Time from the last sample within the limit band of the first pose to the arrival that
    /// resolves at the second.
    pub time_s: f64,
}

/// Evaluates the move to a standstill whose arrival is known.
pub fn posing(stream: &Stream, from: &Standstill, to: &Standstill, arrival: &Arrival) -> Posing {
    // the robot may move within the band before it leaves: the last sample within the band counts
    let start = from.middle().start;
    let back = away_mm(stream, start..arrival.settled, from.mean_mm).rev().position(|d| d <= arrival.band_mm);
    let left = back.map_or(start, |back| arrival.settled - 1 - back);
    Posing {
        distance_mm: norm(minus(to.mean_mm, from.mean_mm)),
        path_mm: path_mm(stream, left..arrival.settled, [from.mean_mm, to.mean_mm], arrival.band_mm),
        time_s: stream.time_s()[arrival.settled] - stream.time_s()[left],
    }
}

/// Length of the path from one standstill to another through these samples, in steps of at least
/// `step_mm`.
fn path_mm(stream: &Stream, samples: Range<usize>, ends_mm: [Vector; 2], step_mm: f64) -> f64 {
    let [mut last, end] = ends_mm;
    let mut length_mm = 0.0;
    for p in &stream.positions_mm()[samples] {
        let step = norm(minus(*p, last));
        if step >= step_mm {
            length_mm += step;
            last = *p;
        }
    }
    length_mm + norm(minus(end, last))
}
