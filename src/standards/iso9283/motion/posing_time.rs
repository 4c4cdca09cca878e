//! Minimum posing time (ISO 9283:1998 9, unverified against a bought copy): time from leaving a
//! pose to standing at the next, including stabilisation.

use crate::iso9283::motion::stabilisation::{Arrival, away_mm};
use crate::iso9283::motion::standstill::Standstill;
use crate::iso9283::motion::stream::Stream;
use etalon_base::pose::{minus, norm};

/// One move from a standstill to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Posing {
    /// Distance between the standstills.
    pub distance_mm: f64,
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
        time_s: stream.time_s()[arrival.settled] - stream.time_s()[left],
    }
}
