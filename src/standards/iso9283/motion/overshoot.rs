//! Position overshoot OV (ISO 9283:1998 7.5, unverified against a bought copy): distance from the
//! attained pose after the first entry into the limit band.

use crate::iso9283::motion::stabilisation::{Arrival, away_mm, watched};
use crate::iso9283::motion::standstill::Standstill;
use crate::iso9283::motion::stream::Stream;

/// Overshoot OV_j of one arrival: largest distance from the attained pose after the first entry;
/// zero if the limit band is not left.
pub fn overshoot_mm(stream: &Stream, before: Option<&Standstill>, standstill: &Standstill, arrival: &Arrival) -> f64 {
    let after = arrival.entered..watched(before, standstill).end;
    let farthest = away_mm(stream, after, standstill.mean_mm).fold(0.0, f64::max);
    if farthest > arrival.band_mm { farthest } else { 0.0 }
}
