//! Offset and rate of two clocks from the standstills of the robot, in which every measurement was
//! taken.

use etalon_base::message::Message;
use etalon_base::{error, phrase};
use std::collections::BTreeMap;

/// Maximum number of ranges of offsets in a message.
const SHOWN: usize = 6;

/// Offsets at which every measurement falls into a standstill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OffsetRange {
    /// Time of the measurement minus time of the log: the middle of those offsets.
    pub offset_s: f64,
    /// Half the width of the range of these offsets: largest error of the middle.
    pub half_width_s: f64,
}

/// Clock of the measurement relative to the clock of the log.
///
/// `measured = logged + offset_s + rate * (logged - reference_s)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Time of the measurement minus time of the log, at the reference.
    pub offset_s: f64,
    /// Relative rate of the clock of the measurement minus 1.
    pub rate: f64,
    /// Time of the log at which the offset holds.
    pub reference_s: f64,
}

impl Clock {
    /// Creates a clock of equal rate.
    pub fn with_offset(offset_s: f64) -> Self {
        Self { offset_s, rate: 0.0, reference_s: 0.0 }
    }

    /// Returns the time of the log at a time of the measurement.
    pub fn log_time_s(&self, measured_s: f64) -> f64 {
        let equal = measured_s - self.offset_s;
        if self.rate == 0.0 { equal } else { self.reference_s + (equal - self.reference_s) / (1.0 + self.rate) }
    }
}

/// Maximum difference of the rates of two clocks: both are driven by quartz crystals.
///
/// IEEE 802.1AS-2020, B.1.1 allows 100 ppm for a clock in a network; crystals of controllers and
/// instruments are specified within 50 ppm each. A log that needs more is another log.
pub const LARGEST_RATE: f64 = 100e-6;

/// Step of the rates that are tried for the assignment of times to standstills.
const RATE_STEP: f64 = 1e-6;

/// Offset and rate at which every measurement falls into a standstill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OffsetAndRate {
    /// The clock; its rate is 0 if an offset alone fits.
    pub clock: Clock,
    /// Lowest and highest rate that fit.
    pub rates: [f64; 2],
    /// Standard uncertainty of the rate.
    pub rate_uncertainty: f64,
    /// Standard uncertainty of the offset at the reference (s).
    pub offset_uncertainty_s: f64,
}

/// Returns the offset and the rate at which every time lies within one of the standstills, which
/// are in order and apart.
///
/// All offsets and rates that fit one assignment of times to standstills form a convex polygon:
/// two straight lines a time bound it. Every point of the polygon is equally likely, so that the
/// estimate is its centroid and the uncertainties are its standard deviations (GUM 4.3.7). A rate
/// is significant if the polygon excludes 0.
///
/// # Errors
/// Fails if no offset and rate within [`LARGEST_RATE`] fit, or if times fit several standstills.
pub fn offset_and_rate(times_s: &[f64], standstills: &[(f64, f64)]) -> Result<OffsetAndRate, Message> {
    let (Some(first), Some(last)) = (standstills.first(), standstills.last()) else {
        return Err(error!("times-missing", of = "log"));
    };
    let reference_s = 0.5 * (first.0 + last.1);
    let times = distinct(times_s)?;
    let mut assigned: BTreeMap<Vec<usize>, (f64, f64)> = BTreeMap::new();
    let steps = (LARGEST_RATE / RATE_STEP).round() as i32;
    for step in -steps..=steps {
        let rate = f64::from(step) * RATE_STEP;
        let scaled = |s: f64| s + rate * (s - reference_s);
        let scaled: Vec<(f64, f64)> = standstills.iter().map(|(from, to)| (scaled(*from), scaled(*to))).collect();
        for (low, high) in shared(&times, &scaled).unwrap_or_default() {
            let offset_s = 0.5 * (low + high);
            let standstill = |t: &f64| scaled.partition_point(|s| s.0 <= t - offset_s).saturating_sub(1);
            assigned.entry(times.iter().map(standstill).collect()).or_insert((offset_s, rate));
        }
    }
    let all: Vec<_> = assigned.iter().collect();
    let [(assignment, start)] = all[..] else {
        if assigned.is_empty() {
            return Err(error!("clock-rate-none", most_ppm = 1e6 * LARGEST_RATE));
        }
        let offsets: Vec<_> =
            assigned.values().map(|(o, _)| phrase!("range-of-seconds", low_s = o, high_s = o)).collect();
        return Err(error!(
            "clock-offsets-several",
            count = offsets.len(),
            ranges = &offsets[..offsets.len().min(SHOWN)]
        ));
    };
    let fits: Vec<(f64, (f64, f64))> = times.iter().copied().zip(assignment.iter().map(|&i| standstills[i])).collect();
    let polygon = polygon(&fits, reference_s, start.0);
    let rates = polygon.iter().fold([f64::MAX, f64::MIN], |[low, high], v| [low.min(v[1]), high.max(v[1])]);
    let (mean, deviation) = moments(&polygon);
    let rate = if rates[0] <= 0.0 && rates[1] >= 0.0 { 0.0 } else { mean[1] };
    Ok(OffsetAndRate {
        clock: Clock { offset_s: mean[0], rate, reference_s },
        rates,
        rate_uncertainty: deviation[1],
        offset_uncertainty_s: deviation[0],
    })
}

/// Returns all (offset, rate) at which each time is within its standstill, as the vertices of a
/// convex polygon. `near_s` is an offset that fits.
fn polygon(fits: &[(f64, (f64, f64))], reference_s: f64, near_s: f64) -> Vec<[f64; 2]> {
    let span = fits.iter().map(|(_, (from, to))| (to - from) + LARGEST_RATE * 2.0 * (to - reference_s).abs());
    let wide = 1.0 + span.fold(0.0, f64::max);
    let (low, high, most) = (near_s - wide, near_s + wide, LARGEST_RATE);
    let mut vertices = vec![[low, -most], [high, -most], [high, most], [low, most]];
    for (t, (from, to)) in fits {
        // offset + rate * (from - reference) <= t - from, and >= t - to with the end
        clip(&mut vertices, |v| t - from - v[0] - v[1] * (from - reference_s));
        clip(&mut vertices, |v| v[0] + v[1] * (to - reference_s) - (t - to));
    }
    vertices
}

/// Cuts a convex polygon at the line where a linear function is 0, and keeps the part where it is
/// positive (Sutherland and Hodgman 1974).
fn clip(vertices: &mut Vec<[f64; 2]>, inside: impl Fn(&[f64; 2]) -> f64) {
    let mut kept = Vec::with_capacity(vertices.len() + 1);
    for (i, here) in vertices.iter().enumerate() {
        let next = &vertices[(i + 1) % vertices.len()];
        let (a, b) = (inside(here), inside(next));
        if a >= 0.0 {
            kept.push(*here);
        }
        if (a < 0.0) != (b < 0.0) {
            let share = a / (a - b);
            kept.push([0, 1].map(|k| here[k] + share * (next[k] - here[k])));
        }
    }
    *vertices = kept;
}

/// Returns mean and standard deviation of a uniform distribution over a convex polygon.
fn moments(vertices: &[[f64; 2]]) -> ([f64; 2], [f64; 2]) {
    let Some(origin) = vertices.first() else { return ([f64::NAN; 2], [f64::NAN; 2]) };
    let from = |v: &[f64; 2]| [0, 1].map(|k| v[k] - origin[k]);
    let (mut area, mut first, mut second) = (0.0, [0.0; 2], [0.0; 2]);
    for pair in vertices[1..].windows(2) {
        let (a, b) = (from(&pair[0]), from(&pair[1]));
        let part = 0.5 * (a[0] * b[1] - a[1] * b[0]).abs();
        area += part;
        for k in 0..2 {
            let sum = a[k] + b[k];
            first[k] += part * sum / 3.0;
            second[k] += part * (a[k] * a[k] + b[k] * b[k] + sum * sum) / 12.0;
        }
    }
    if area == 0.0 {
        let n = vertices.len() as f64;
        let mean = [0, 1].map(|k| vertices.iter().map(|v| v[k]).sum::<f64>() / n);
        return (mean, [0.0; 2]);
    }
    let mean = first.map(|sum| sum / area);
    let deviation = [0, 1].map(|k| (second[k] / area - mean[k] * mean[k]).max(0.0).sqrt());
    ([0, 1].map(|k| origin[k] + mean[k]), deviation)
}

/// Finite times in ascending order, each once; an error without such a time.
fn distinct(times_s: &[f64]) -> Result<Vec<f64>, Message> {
    let mut times: Vec<f64> = times_s.iter().copied().filter(|t| t.is_finite()).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    if times.is_empty() { Err(error!("times-missing", of = "points")) } else { Ok(times) }
}

/// The ranges of offsets at which every time lies within a standstill.
///
/// An offset suits a time t if it is within [t - to, t - from] of some standstill; one that suits
/// all times is in the intersection of their sets.
fn shared(times: &[f64], standstills: &[(f64, f64)]) -> Result<Vec<(f64, f64)>, Message> {
    let suits =
        |t: &f64| -> Vec<(f64, f64)> { standstills.iter().rev().map(|(from, to)| (t - to, t - from)).collect() };
    let mut shared = times.first().map(suits).unwrap_or_default();
    for (i, t) in times.iter().enumerate().skip(1) {
        let left = both(&shared, &suits(t));
        if left.is_empty() {
            return Err(error!("clock-offset-none", count = i, last_s = times[i - 1], first_s = t));
        }
        shared = left;
    }
    Ok(shared)
}

/// The only range of offsets (time of the measurement minus time of the log) at which every time
/// lies within one of the standstills `(from_s, to_s)`, which are in order and apart.
///
/// No such offset, or several ranges of them, are errors.
pub fn offset(times_s: &[f64], standstills: &[(f64, f64)]) -> Result<OffsetRange, Message> {
    let shared = shared(&distinct(times_s)?, standstills)?;
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

    /// Times of measurements in standstills of odd lengths at odd times, on a clock of this offset
    /// and rate.
    fn measured(offset_s: f64, rate: f64) -> (Vec<f64>, Vec<(f64, f64)>) {
        let starts = (0..40).map(|i| 90.0 * f64::from(i) + 7.0 * f64::from(i * i % 11));
        let stands: Vec<(f64, f64)> =
            starts.clone().zip(0..).map(|(s, i)| (s, s + 2.0 + 0.1 * f64::from(i % 5))).collect();
        // the first within a tenth of a second of the start, the second of the end, and so on
        let at = |(i, (from, to)): (usize, &(f64, f64))| if i % 2 == 0 { from + 0.05 } else { to - 0.05 };
        let logged = stands.iter().enumerate().map(at);
        (logged.map(|t| t + offset_s + rate * (t - 1800.0)).collect(), stands)
    }

    #[test]
    fn a_rate_is_found_with_its_uncertainty_where_no_offset_fits() {
        for (offset_s, rate) in [(1000.25, 80e-6), (-3.0e9, -60e-6), (0.0, 95e-6)] {
            let (times, stands) = measured(offset_s, rate);
            assert!(offset(&times, &stands).is_err());
            let found = offset_and_rate(&times, &stands).unwrap();
            assert!(found.rates[0] <= rate && rate <= found.rates[1], "{found:?}");
            assert!((found.clock.rate - rate).abs() <= 3.5 * found.rate_uncertainty, "{found:?}");
            assert!(found.rate_uncertainty < 25e-6 && found.offset_uncertainty_s < 0.05, "{found:?}");
            for t in &times {
                let logged = found.clock.log_time_s(*t);
                assert!(
                    stands.iter().any(|(from, to)| *from - 1e-6 <= logged && logged <= *to + 1e-6),
                    "{t} {found:?}"
                );
            }
        }
    }

    #[test]
    fn a_rate_of_nothing_is_insignificant_and_one_beyond_crystals_is_refused() {
        let (times, stands) = measured(12.5, 5e-6);
        let found = offset_and_rate(&times, &stands).unwrap();
        assert!(found.clock.rate == 0.0 && found.rates[0] < 0.0 && found.rates[1] > 5e-6, "{found:?}");
        let (times, stands) = measured(12.5, 250e-6);
        assert!(offset_and_rate(&times, &stands).unwrap_err().is("clock-rate-none", &[]));
        // the log of another run: its standstills are at other times
        let (times, _) = measured(12.5, 0.0);
        let other: Vec<(f64, f64)> =
            (0..40).map(|i| 91.0 * f64::from(i) + 5.0 * f64::from(i * i % 7)).map(|s| (s, s + 2.2)).collect();
        assert!(offset_and_rate(&times, &other).unwrap_err().is("clock-rate-none", &[]));
        assert!(offset_and_rate(&[], &stands).is_err() && offset_and_rate(&times, &[]).is_err());
    }

    #[test]
    fn standstills_at_equal_intervals_stay_ambiguous() {
        let even: Vec<(f64, f64)> = (0..10).map(|i| (10.0 * f64::from(i), 10.0 * f64::from(i) + 1.0)).collect();
        assert!(offset_and_rate(&[0.5, 10.5, 20.5], &even).unwrap_err().is("clock-offsets-several", &[]));
    }

    #[test]
    fn moments_are_those_of_a_rectangle_and_a_triangle() {
        let (mean, deviation) = moments(&[[1.0, 2.0], [4.0, 2.0], [4.0, 8.0], [1.0, 8.0]]);
        // a rectangular distribution of width w: w / sqrt(12) (GUM 4.3.7)
        assert!((mean[0] - 2.5).abs() < 1e-12 && (mean[1] - 5.0).abs() < 1e-12);
        assert!(
            (deviation[0] - 3.0 / 12_f64.sqrt()).abs() < 1e-12 && (deviation[1] - 6.0 / 12_f64.sqrt()).abs() < 1e-12
        );
        // x of the triangle (0, 0), (1, 0), (0, 1): mean 1/3, variance 1/18
        let (mean, deviation) = moments(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        assert!((mean[0] - 1.0 / 3.0).abs() < 1e-12 && (deviation[0] - (1.0_f64 / 18.0).sqrt()).abs() < 1e-12);
    }
}
