//! Position stabilisation time (ISO 9283:1998 7.4, unverified against a bought copy): from the first entry into the limit
//! band about the attained pose until it is never left again.

use crate::iso9283::motion::standstill::Standstill;
use crate::iso9283::motion::stream::Stream;
use etalon_base::pose::{Vector, minus, norm};
use std::ops::Range;

/// How a robot arrives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// First sample within the limit band.
    pub entered: usize,
    /// First sample after which the band is not left before the standstill's last quarter.
    pub settled: usize,
    /// Stabilisation time.
    pub stabilisation_s: f64,
    /// The limit band.
    pub band_mm: f64,
}

/// Samples in which an arrival is looked at: from the end of the standstill before (or the begin of the recording) to
/// the last quarter of the standstill, where the robot may leave already.
pub fn watched(before: Option<&Standstill>, standstill: &Standstill) -> Range<usize> {
    before.map_or(0, |b| b.samples.end)..standstill.middle().end
}

/// The arrival at a standstill; `None` where the recording begins within the band, and where the band is left again and
/// again: it is narrower than the noise of the standing robot.
pub fn arrival(stream: &Stream, before: Option<&Standstill>, standstill: &Standstill, band_mm: f64) -> Option<Arrival> {
    let watched = watched(before, standstill);
    let within = |i: usize| norm(minus(stream.positions_mm()[i], standstill.mean_mm)) <= band_mm;
    let entered = watched.clone().find(|&i| within(i)).filter(|&i| i > watched.start)?;
    let settled = watched.clone().rev().find(|&i| !within(i)).map_or(watched.start, |i| i + 1);
    // a standstill's middle is the attained position: it must be inside
    (settled <= standstill.middle().start).then(|| {
        let settled = settled.max(entered);
        Arrival { entered, settled, stabilisation_s: stream.time_s()[settled] - stream.time_s()[entered], band_mm }
    })
}

/// Mean stabilisation time over cycles (the standard has three); `None` without any.
pub fn stabilisation_time_s(arrivals: &[Arrival]) -> Option<f64> {
    let sum: f64 = arrivals.iter().map(|a| a.stabilisation_s).sum();
    (!arrivals.is_empty()).then(|| sum / arrivals.len() as f64)
}

/// Position over time against the place where the robot came to stand.
pub(crate) fn away_mm(stream: &Stream, samples: Range<usize>, from_mm: Vector) -> impl DoubleEndedIterator<Item = f64> {
    stream.positions_mm()[samples].iter().map(move |p| norm(minus(*p, from_mm)))
}
