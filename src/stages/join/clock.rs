//! The offset of two clocks, from where the robot stood: every measurement was taken while it did.

use etalon_base::message::Message;
use etalon_base::{error, phrase};

/// Ranges of offsets that a message lists.
const SHOWN: usize = 6;

/// Offsets at which every measurement falls into a standstill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OffsetRange {
    /// Time of the measurement minus time of the log: the middle of those offsets.
    pub offset_s: f64,
    /// Half the width of those offsets: how far the middle may be from the truth.
    pub half_width_s: f64,
}

/// The only range of offsets (time of the measurement minus time of the log) at which every time
/// lies within one of the standstills `(from_s, to_s)`, which are in order and apart.
///
/// An offset suits a time t if it is within [t - to, t - from] of some standstill; one that suits
/// all is in what the sets of all times share. No such offset, or several ranges of them, are
/// errors.
pub fn offset(times_s: &[f64], standstills: &[(f64, f64)]) -> Result<OffsetRange, Message> {
    let suits =
        |t: &f64| -> Vec<(f64, f64)> { standstills.iter().rev().map(|(from, to)| (t - to, t - from)).collect() };
    let mut times: Vec<f64> = times_s.iter().copied().filter(|t| t.is_finite()).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let Some(first) = times.first() else { return Err(error!("times-missing", of = "points")) };
    let mut shared = suits(first);
    for (i, t) in times.iter().enumerate().skip(1) {
        let left = both(&shared, &suits(t));
        if left.is_empty() {
            return Err(error!("clock-offset-none", count = i, last_s = times[i - 1], first_s = t));
        }
        shared = left;
    }
    match shared[..] {
        [(low, high)] => Ok(OffsetRange { offset_s: 0.5 * (low + high), half_width_s: 0.5 * (high - low) }),
        _ => {
            let ranges: Vec<_> =
                shared.iter().map(|(low_s, high_s)| phrase!("range-of-seconds", low_s, high_s)).collect();
            let shown = &ranges[..ranges.len().min(SHOWN)];
            Err(error!("clock-offsets-several", count = ranges.len(), ranges = shown))
        }
    }
}

/// Returns the intersection of two ordered lists of ranges.
fn both(one: &[(f64, f64)], other: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let (mut i, mut j, mut shared) = (0, 0, Vec::new());
    while let (Some(a), Some(b)) = (one.get(i), other.get(j)) {
        let (low, high) = (a.0.max(b.0), a.1.min(b.1));
        if low <= high {
            shared.push((low, high));
        }
        if a.1 < b.1 { i += 1 } else { j += 1 }
    }
    shared
}

#[cfg(test)]
mod tests {
    use super::*;

    const STANDS: [(f64, f64); 4] = [(10.0, 12.0), (20.0, 23.0), (27.0, 28.0), (40.0, 44.0)];

    #[test]
    fn measurements_during_standstills_tell_the_offset_within_what_is_left_open() {
        let truth = 1000.25;
        let times: Vec<f64> = [11.0, 21.0, 22.5, 27.5, 41.0].iter().map(|t| t + truth).collect();
        let found = offset(&times, &STANDS).unwrap();
        assert!((found.offset_s - truth).abs() <= found.half_width_s && found.half_width_s <= 0.5, "{found:?}");
        // 27.5 in (27, 28) and 22.5 in (20, 23): from -0.5 to 0.5 about the truth
        assert!((found.offset_s - truth).abs() < 1e-9 && (found.half_width_s - 0.5).abs() < 1e-9);
    }

    #[test]
    fn the_offset_follows_the_clock_and_the_order_of_times_does_not_matter() {
        let times = [41.0, 11.0, 27.5, 21.0];
        let here = offset(&times, &STANDS).unwrap();
        let there = offset(&times.map(|t| t - 500.0), &STANDS).unwrap();
        assert!((here.offset_s - 500.0 - there.offset_s).abs() < 1e-9);
        assert!((here.half_width_s - there.half_width_s).abs() < 1e-9);
    }

    #[test]
    fn several_offsets_or_none_are_errors() {
        let even = [(0.0, 1.0), (10.0, 11.0), (20.0, 21.0)];
        assert!(offset(&[0.5, 10.5], &even).unwrap_err().is("clock-offsets-several", &[("count", &2)]));
        assert!(offset(&[0.5, 10.5, 20.5], &even).is_ok());
        assert!(offset(&[0.5, 5.0, 10.5, 20.5], &even).unwrap_err().is("clock-offset-none", &[]));
        assert!(offset(&[], &even).is_err() && offset(&[1.0], &[]).is_err());
    }
}
