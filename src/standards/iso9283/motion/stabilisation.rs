//! Position stabilisation time (ISO 9283:1998 7.4, unverified against a bought copy): time from the
//! first entry into the limit band about the attained pose until the band is no longer left.

use crate::iso9283::motion::standstill::Standstill;
use crate::iso9283::motion::stream::Stream;
use etalon_base::pose::{Vector, minus, norm};
use std::ops::Range;

/// Arrival of a robot at a standstill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// First sample within the limit band.
    pub entered: usize,
    /// First sample from which the band is not left before the last quarter of the standstill.
    pub settled: usize,
    /// Stabilisation time.
    pub stabilisation_s: f64,
    /// Limit band.
    pub band_mm: f64,
}

/// Samples in which an arrival is evaluated: from the end of the previous standstill (or the start
/// of the recording) to the last quarter of the standstill, in which the robot may be leaving.
pub fn watched(before: Option<&Standstill>, standstill: &Standstill) -> Range<usize> {
    before.map_or(0, |b| b.samples.end)..standstill.middle().end
}

/// Evaluates the arrival at a standstill. `None` if the recording starts within the band, or if the
/// band is repeatedly left because it is narrower than the noise of the standing robot.
pub fn arrival(stream: &Stream, before: Option<&Standstill>, standstill: &Standstill, band_mm: f64) -> Option<Arrival> {
    let watched = watched(before, standstill);
    let within = |i: usize| norm(minus(stream.positions_mm()[i], standstill.mean_mm)) <= band_mm;
    let entered = watched.clone().find(|&i| within(i)).filter(|&i| i > watched.start)?;
    let settled = watched.clone().rev().find(|&i| !within(i)).map_or(watched.start, |i| i + 1);
    // the middle of the standstill is the attained position, so it must be inside
    (settled <= standstill.middle().start).then(|| {
        let settled = settled.max(entered);
        Arrival { entered, settled, stabilisation_s: stream.time_s()[settled] - stream.time_s()[entered], band_mm }
    })
}

/// Mean stabilisation time over cycles (three in the standard); `None` without arrivals.
pub fn stabilisation_time_s(arrivals: &[Arrival]) -> Option<f64> {
    let sum: f64 = arrivals.iter().map(|a| a.stabilisation_s).sum();
    (!arrivals.is_empty()).then(|| sum / arrivals.len() as f64)
}

/// Distances of the positions from the standstill over time.
pub(crate) fn away_mm(stream: &Stream, samples: Range<usize>, from_mm: Vector) -> impl DoubleEndedIterator<Item = f64> {
    stream.positions_mm()[samples].iter().map(move |p| norm(minus(*p, from_mm)))
}
