//! Offset and rate of two clocks from the speeds of a motion that both recorded: the measured speed
//! of a target, and its speed by the nominal robot at the joint values of the log.
//!
//! Speeds do not depend on the frame of the instrument. The offset with the largest correlation is
//! refined by least squares; the uncertainties follow from the residuals (GUM G.3.3).

use super::clock::{Clock, LARGEST_RATE};
use etalon_base::message::Message;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, phrase};

/// Minimum correlation of the speeds of one motion.
const SMALLEST_CORRELATION: f64 = 0.8;
/// A second offset with this part of the largest correlation leaves the choice open.
const RIVAL: f64 = 0.97;
/// Maximum number of speeds that are compared at each offset.
const COMPARED: usize = 2000;
/// Maximum number of spans with a mean speed each, in which offsets are searched.
const SPANS: usize = 4096;
/// Maximum number of steps of the refinement.
const STEPS: usize = 20;
/// Maximum step of the offset at which the refinement ends (s).
const CONVERGED_S: f64 = 1e-9;
/// Minimum number of speeds of a recording.
const FEWEST: usize = 20;

/// Speeds of a motion at increasing times.
#[derive(Clone, Debug, Default)]
pub struct Speeds {
    times_s: Vec<f64>,
    speeds_mm_s: Vec<f64>,
}

impl Speeds {
    /// Speeds between neighbouring positions, at the middle of their times.
    pub fn new(times_s: &[f64], positions_mm: &[Vector]) -> Self {
        let mut speeds = Self::default();
        for (times, positions) in times_s.windows(2).zip(positions_mm.windows(2)) {
            let (span, way) = (times[1] - times[0], norm(minus(positions[1], positions[0])));
            if span > 0.0 && way.is_finite() {
                speeds.times_s.push(0.5 * (times[0] + times[1]));
                speeds.speeds_mm_s.push(way / span);
            }
        }
        speeds
    }

    /// Speed at a time, between two neighbours; `None` outside of the recording.
    fn interpolated(&self, time_s: f64) -> Option<f64> {
        let after = self.times_s.partition_point(|t| *t < time_s);
        let (before, after) = (after.checked_sub(1)?, (after < self.times_s.len()).then_some(after)?);
        let share = (time_s - self.times_s[before]) / (self.times_s[after] - self.times_s[before]);
        Some(self.speeds_mm_s[before] + share * (self.speeds_mm_s[after] - self.speeds_mm_s[before]))
    }

    fn span(&self) -> Option<(f64, f64)> {
        Some((*self.times_s.first()?, *self.times_s.last()?))
    }

    /// Median time between neighbouring speeds.
    fn step_s(&self) -> f64 {
        let steps = self.times_s.windows(2).map(|pair| pair[1] - pair[0]);
        etalon_math::statistics::median(steps).unwrap_or(1.0)
    }

    /// Mean speeds of equal spans from a time on; NaN for a span without a speed.
    fn means(&self, from_s: f64, step_s: f64, span_s: f64) -> Vec<f64> {
        let mut sums = vec![(0.0, 0.0); (span_s / step_s) as usize + 1];
        for (t, v) in self.times_s.iter().zip(&self.speeds_mm_s) {
            if let Some((sum, count)) = sums.get_mut(((t - from_s) / step_s) as usize) {
                (*sum, *count) = (*sum + v, *count + 1.0);
            }
        }
        sums.into_iter().map(|(sum, count)| sum / count).collect()
    }

    /// At most this number of times and speeds, evenly spread.
    fn thinned(&self, most: usize) -> impl Iterator<Item = (f64, f64)> + Clone + '_ {
        let every = self.times_s.len().div_ceil(most).max(1);
        self.times_s.iter().copied().zip(self.speeds_mm_s.iter().copied()).step_by(every)
    }
}

/// Clock of the measurement relative to the clock of the log, from speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionClock {
    /// The clock; its rate is 0 if the speeds do not show one.
    pub clock: Clock,
    /// Standard uncertainty of the offset at the reference (s).
    pub offset_uncertainty_s: f64,
    /// Standard uncertainty of the rate.
    pub rate_uncertainty: f64,
    /// Correlation of the speeds at this offset and rate.
    pub correlation: f64,
}

/// Determines the offset of the clocks, and with `rate` their rate, from the speeds of the same
/// targets in the measurement and in the log.
///
/// # Errors
/// Fails if the speeds are too few, do not correlate, or correlate at several offsets.
pub fn offset_by_motion(measured: &[Speeds], logged: &[Speeds], rate: bool) -> Result<MotionClock, Message> {
    let pairs: Vec<(&Speeds, &Speeds)> = measured.iter().zip(logged).filter(|(m, _)| !m.times_s.is_empty()).collect();
    let count: usize = pairs.iter().map(|(m, _)| m.times_s.len()).sum();
    let span = |all: Vec<&Speeds>| {
        let spans = all.into_iter().filter_map(Speeds::span);
        spans.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
    };
    let (all_measured, all_logged) = pairs.iter().copied().unzip();
    let (Some(of_measured), Some(of_log)) = (span(all_measured), span(all_logged)) else {
        return Err(error!("clock-motion-short", count));
    };
    if count < FEWEST || pairs.iter().any(|(_, logged)| logged.times_s.len() < FEWEST) {
        return Err(error!("clock-motion-short", count));
    }
    let start = best_offset(&pairs, of_measured, of_log)?;
    let reference_s = (0.5 * (of_measured.0 + of_measured.1) - start).clamp(of_log.0, of_log.1);
    let found = refined(&pairs, start, reference_s, rate);
    match found {
        Some(found) if found.clock.rate.abs() > LARGEST_RATE => {
            Err(error!("clock-rate-none", most_ppm = 1e6 * LARGEST_RATE))
        }
        Some(found) if found.correlation >= SMALLEST_CORRELATION => Ok(found),
        found => Err(error!("clock-motion-unlike", correlation = found.map_or(0.0, |found| found.correlation))),
    }
}

/// Offset with the largest correlation, of all offsets at which half of the shorter recording lies
/// within the longer one: first with mean speeds of equal intervals, then with shorter intervals
/// about the best offset.
fn best_offset(pairs: &[(&Speeds, &Speeds)], measured: (f64, f64), log: (f64, f64)) -> Result<f64, Message> {
    let finest = pairs.iter().map(|(m, l)| m.step_s().max(l.step_s())).fold(f64::INFINITY, f64::min);
    let spans = [measured.1 - measured.0, log.1 - log.0];
    let step = finest.max(spans[0].max(spans[1]) / SPANS as f64);
    let binned: Vec<[Vec<f64>; 2]> =
        pairs.iter().map(|(m, l)| [m.means(measured.0, step, spans[0]), l.means(log.0, step, spans[1])]).collect();
    let half = (0.5 * spans[0].min(spans[1]) / step) as i64;
    let lags: Vec<i64> = (half - (spans[1] / step) as i64..=(spans[0] / step) as i64 - half).collect();
    let offset = |k: usize| measured.0 - log.0 + step * lags[k] as f64;
    let all: Vec<f64> = lags.iter().map(|lag| lagged(&binned, *lag)).collect();
    let best = (0..all.len()).max_by(|a, b| all[*a].total_cmp(&all[*b])).unwrap_or(0);
    if all.get(best).is_none_or(|value| *value < 0.5 * SMALLEST_CORRELATION) {
        return Err(error!("clock-motion-unlike", correlation = all.get(best).copied().unwrap_or(0.0).max(0.0)));
    }
    // maxima apart from the best one: the correlation falls off between them
    let is_peak = |k: usize| {
        let beside = [k.checked_sub(1), Some(k + 1)].into_iter().flatten().filter_map(|k| all.get(k));
        beside.into_iter().all(|other| all[k] >= *other)
    };
    let apart = |k: usize| {
        let between = &all[k.min(best)..=k.max(best)];
        between.iter().any(|value| *value < 0.9 * all[best] * RIVAL)
    };
    let rivals: Vec<usize> =
        (0..all.len()).filter(|k| all[*k] > RIVAL * all[best] && is_peak(*k) && apart(*k)).collect();
    if rivals.is_empty() {
        let (mut found, mut width) = (offset(best), step);
        let most = (COMPARED / pairs.len().max(1)).max(FEWEST);
        while width > 0.25 * finest {
            width *= 0.25;
            let tried = (-6..=6).map(|k| found + width * f64::from(k));
            let rated = tried.map(|at| (at, correlation(pairs, &Clock::with_offset(at), most)));
            found = rated.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(found, |best| best.0);
        }
        return Ok(found);
    }
    let mut offsets: Vec<f64> = rivals.iter().chain([&best]).map(|k| offset(*k)).collect();
    offsets.sort_by(f64::total_cmp);
    let ranges: Vec<_> =
        offsets.iter().take(6).map(|o| phrase!("range-of-seconds", low_s = o - step, high_s = o + step)).collect();
    Err(error!("clock-motion-several", count = offsets.len(), ranges))
}

/// Correlation coefficient of mean speeds of equal spans at a lag of the log.
fn lagged(binned: &[[Vec<f64>; 2]], lag: i64) -> f64 {
    let both = binned.iter().flat_map(|[measured, logged]| {
        measured.iter().enumerate().filter_map(move |(i, a)| {
            let b = logged.get(usize::try_from(i as i64 - lag).ok()?)?;
            Some([*a, *b])
        })
    });
    coefficient(both.filter(|pair| pair.iter().all(|v| v.is_finite())))
}

/// Measured speeds with the speeds of the log at the same time by a clock.
fn paired<'a>(pairs: &'a [(&Speeds, &Speeds)], clock: &'a Clock, most: usize) -> impl Iterator<Item = [f64; 2]> + 'a {
    pairs.iter().flat_map(move |(measured, logged)| {
        let pair = move |(t, v): (f64, f64)| Some([v, logged.interpolated(clock.log_time_s(t))?]);
        measured.thinned(most).filter_map(pair)
    })
}

/// Correlation coefficient of the speeds by a clock.
fn correlation(pairs: &[(&Speeds, &Speeds)], clock: &Clock, most: usize) -> f64 {
    coefficient(paired(pairs, clock, most))
}

/// Correlation coefficient of pairs; 0 for a few, and for values that do not vary.
fn coefficient(pairs: impl Iterator<Item = [f64; 2]>) -> f64 {
    let (mut n, mut sums) = (0.0, [0.0; 5]);
    for [a, b] in pairs {
        n += 1.0;
        for (sum, value) in sums.iter_mut().zip([a, b, a * a, b * b, a * b]) {
            *sum += value;
        }
    }
    let [a, b, aa, bb, ab] = sums;
    let (va, vb) = (n * aa - a * a, n * bb - b * b);
    let varies = va > 1e-9 * n * aa && vb > 1e-9 * n * bb;
    if n < FEWEST as f64 || !varies { 0.0 } else { (n * ab - a * b) / (va * vb).sqrt() }
}

/// Offset and rate of least squares near an offset; `None` if the speeds do not determine them.
fn refined(pairs: &[(&Speeds, &Speeds)], start: f64, reference_s: f64, rate: bool) -> Option<MotionClock> {
    let mut clock = Clock { offset_s: start, rate: 0.0, reference_s };
    let wide = pairs.iter().map(|(m, l)| m.step_s().max(l.step_s())).fold(0.0, f64::max);
    let fitted = |clock: &Clock, free: usize| {
        // of d v / d offset, which is minus the acceleration, and of the rate
        let (mut normal, mut right, mut squares, mut n) = ([[0.0; 2]; 2], [0.0; 2], 0.0, 0.0);
        for (measured, logged) in pairs {
            for (t, v) in measured.thinned(usize::MAX) {
                let at = clock.log_time_s(t);
                let (Some(a), Some(b), Some(c)) =
                    (logged.interpolated(at - wide), logged.interpolated(at), logged.interpolated(at + wide))
                else {
                    continue;
                };
                let slope = -(c - a) / (2.0 * wide);
                let row = [slope, if free > 1 { slope * (at - reference_s) } else { 0.0 }];
                let residual = v - b;
                squares += residual * residual;
                n += 1.0;
                for i in 0..free {
                    right[i] += row[i] * residual;
                    (0..free).for_each(|j| normal[i][j] += row[i] * row[j]);
                }
            }
        }
        let variance = squares / (n - free as f64);
        let [[a, b], [_, d]] = normal;
        if free == 1 {
            return (a > 0.0 && n > 1.0).then(|| ([right[0] / a, 0.0], [(variance / a).sqrt(), f64::NAN]));
        }
        let determinant = a * d - b * b;
        (determinant > 1e-12 * a * d && n > 2.0).then(|| {
            let step = [(d * right[0] - b * right[1]) / determinant, (a * right[1] - b * right[0]) / determinant];
            (step, [(variance * d / determinant).sqrt(), (variance * a / determinant).sqrt()])
        })
    };
    let solve = |mut clock: Clock, free: usize| {
        let mut uncertainty = [f64::NAN; 2];
        for _ in 0..STEPS {
            let (step, found) = fitted(&clock, free)?;
            (clock.offset_s, clock.rate, uncertainty) =
                (clock.offset_s + step[0].clamp(-wide, wide), clock.rate + step[1], found);
            if step[0].abs() < CONVERGED_S {
                break;
            }
        }
        Some((clock, uncertainty))
    };
    let (of_offset, [mut offset_uncertainty_s, mut rate_uncertainty]) = solve(clock, 1)?;
    clock = of_offset;
    if rate {
        let (with_rate, [u_offset, u_rate]) = solve(clock, 2)?;
        rate_uncertainty = u_rate;
        // a rate within two standard uncertainties is not told from zero
        if with_rate.rate.abs() > 2.0 * u_rate {
            (clock, offset_uncertainty_s) = (with_rate, u_offset);
        }
    }
    let correlation = correlation(pairs, &clock, usize::MAX);
    Some(MotionClock { clock, offset_uncertainty_s, rate_uncertainty, correlation })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Position of a target that never stands still.
    fn position(t: f64) -> Vector {
        let turn = 0.31 * t + 0.4 * (0.13 * t).sin();
        [
            300.0 * turn.cos() + 40.0 * (1.7 * t).sin(),
            250.0 * turn.sin(),
            80.0 * (0.47 * t).sin() + 30.0 * (1.1 * t).cos(),
        ]
    }

    /// Speeds at a rate in Hz from a time on, with a noise of this size (mm) and on another clock.
    fn speeds(from: f64, rate_hz: f64, count: usize, noise_mm: f64, clock: impl Fn(f64) -> f64) -> Speeds {
        let times: Vec<f64> = (0..count).map(|i| from + i as f64 / rate_hz).collect();
        let noisy = |(i, t): (usize, &f64)| {
            let mut p = position(*t);
            p.iter_mut()
                .enumerate()
                .for_each(|(k, v)| *v += noise_mm * ((12.9 * i as f64 + 7.7 * k as f64).sin() * 43_758.5).fract());
            p
        };
        let positions: Vec<Vector> = times.iter().enumerate().map(noisy).collect();
        let shown: Vec<f64> = times.iter().map(|t| clock(*t)).collect();
        Speeds::new(&shown, &positions)
    }

    #[test]
    fn two_recordings_of_one_motion_give_the_offset_with_its_uncertainty() {
        let truth = 1_764_342_000.125;
        let log = speeds(0.0, 250.0, 15_000, 0.0, |t| t);
        for noise in [0.0, 0.02] {
            let tracker = speeds(12.0, 50.0, 1500, noise, |t| t + truth);
            let found = offset_by_motion(&[tracker], std::slice::from_ref(&log), false).unwrap();
            let error = found.clock.offset_s - truth;
            assert!(error.abs() < 1e-3 && error.abs() <= 4.0 * found.offset_uncertainty_s + 2e-4, "{error} {found:?}");
            assert!(found.clock.rate == 0.0 && found.correlation > 0.99, "{found:?}");
        }
    }

    #[test]
    fn a_drift_of_the_clocks_is_found_and_none_is_insignificant() {
        let log = speeds(0.0, 100.0, 120_000, 0.0, |t| t);
        for rate in [60e-6, 0.0] {
            let tracker = speeds(30.0, 20.0, 22_000, 0.02, |t| t + 5.5 + rate * (t - 600.0));
            let found = offset_by_motion(&[tracker], std::slice::from_ref(&log), true).unwrap();
            let error = found.clock.rate - rate;
            assert!(error.abs() < 4e-6 && error.abs() <= 4.0 * found.rate_uncertainty + 1e-6, "{error} {found:?}");
            assert!(found.rate_uncertainty < 5e-6, "{found:?}");
        }
    }

    #[test]
    fn another_motion_a_short_one_and_a_periodic_one_are_refused() {
        let log = speeds(0.0, 100.0, 6000, 0.0, |t| t);
        let other = Speeds::new(
            &(0..1000).map(|i| 0.05 * f64::from(i)).collect::<Vec<f64>>(),
            &(0..1000).map(|i| [f64::from(i * i % 37), f64::from(i % 11), 0.0]).collect::<Vec<Vector>>(),
        );
        let refused = |measured: &Speeds, logged: &Speeds| {
            offset_by_motion(std::slice::from_ref(measured), std::slice::from_ref(logged), false).unwrap_err()
        };
        assert!(refused(&other, &log).is("clock-motion-unlike", &[]));
        let short = speeds(3.0, 50.0, 6, 0.0, |t| t);
        assert!(refused(&short, &log).is("clock-motion-short", &[("count", &5)]));
        let periodic = |from: f64, count: usize| {
            let times: Vec<f64> = (0..count).map(|i| from + 0.02 * i as f64).collect();
            let positions: Vec<Vector> = times.iter().map(|t| [100.0 * (0.5 * t).sin(), 0.0, 0.0]).collect();
            Speeds::new(&times, &positions)
        };
        assert!(refused(&periodic(20.0, 1000), &periodic(0.0, 6000)).is("clock-motion-several", &[]));
    }
}
