//! Offset and rate of two clocks from the speeds of a motion that both recorded: the measured speed
//! of a target, and its speed by the nominal robot at the joint values of the log.
//!
//! Speeds depend on the place of the target on the robot, and not on the frame of the instrument.
//! The offset with the largest correlation is refined by least squares together with the places of
//! the targets; the uncertainties follow from the residuals (GUM G.3.3).

use super::clock::{Clock, LARGEST_RATE};
use etalon_base::message::Message;
use etalon_base::pose::{Vector, dot, minus, norm};
use etalon_base::{error, phrase};
use nalgebra::{DMatrix, DVector};

/// Minimum correlation of the speeds of one motion.
const SMALLEST_CORRELATION: f64 = 0.8;
/// Part of the largest correlation of a maximum that is tried with the places of the targets free.
const PEAK: f64 = 0.7;
/// Maximum number of these maxima.
const PEAKS: usize = 8;
/// A second offset that leaves less than this times the unexplained part leaves the choice open.
const RIVAL: f64 = 2.0;
/// Unexplained part of speeds that counts as none.
const LEAST_UNEXPLAINED: f64 = 1e-6;
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
/// Standard uncertainty (mm) of a coordinate of a place on the robot that nobody stated.
const UNKNOWN_PLACE_MM: f64 = 1000.0;
/// Maximum time between neighbouring positions of a measurement, in medians of these times: the
/// instrument did not see the motion in a longer gap, for instance between two standstills.
const LONGEST_GAP: f64 = 3.0;
/// Smallest standard deviation of speeds (mm/s) for the weight of stated places.
const LEAST_SPREAD_MM_S: f64 = 1e-3;

/// Positions of a target at increasing times.
#[derive(Clone, Debug, Default)]
pub struct Track {
    pub times_s: Vec<f64>,
    pub positions_mm: Vec<Vector>,
}

/// Positions of a target by the log, at its stated place on the robot.
#[derive(Clone, Debug, Default)]
pub struct Way {
    pub track: Track,
    /// Derivatives of each position by the coordinates of the place. The position is linear in
    /// these coordinates.
    pub by_place: Vec<Vec<Vector>>,
    /// Standard uncertainties (mm) of the coordinates of the place; infinite if nobody stated it.
    pub place_uncertainties_mm: Vec<f64>,
}

impl Way {
    /// Position at a time and its derivatives by the coordinates of the place, between two rows;
    /// `None` outside of the recording.
    fn at(&self, time_s: f64, place_mm: &[f64]) -> Option<(Vector, Vec<Vector>)> {
        let times = &self.track.times_s;
        let after = times.partition_point(|t| *t < time_s);
        let (before, after) = (after.checked_sub(1)?, (after < times.len()).then_some(after)?);
        let share = (time_s - times[before]) / (times[after] - times[before]);
        let between = |a: Vector, b: Vector| [0, 1, 2].map(|k| a[k] + share * (b[k] - a[k]));
        let derivative = |k: usize| between(self.by_place[before][k], self.by_place[after][k]);
        let derivatives: Vec<Vector> = (0..place_mm.len()).map(derivative).collect();
        let mut position = between(self.track.positions_mm[before], self.track.positions_mm[after]);
        for (derivative, place) in derivatives.iter().zip(place_mm) {
            (0..3).for_each(|k| position[k] += derivative[k] * place);
        }
        Some((position, derivatives))
    }
}

/// Speeds of a motion at increasing times.
#[derive(Clone, Debug, Default)]
struct Speeds {
    times_s: Vec<f64>,
    speeds_mm_s: Vec<f64>,
}

impl Speeds {
    /// Speeds at the middle of their times.
    fn new(chords: impl Iterator<Item = Chord>) -> Self {
        let mut speeds = Self::default();
        for chord in chords {
            speeds.times_s.push(0.5 * (chord.from_s + chord.to_s));
            speeds.speeds_mm_s.push(chord.speed_mm_s);
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

    fn span(&self) -> Option<[f64; 2]> {
        Some([*self.times_s.first()?, *self.times_s.last()?])
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

/// Mean speed between two neighbouring positions.
#[derive(Clone, Copy)]
struct Chord {
    from_s: f64,
    to_s: f64,
    speed_mm_s: f64,
}

/// Mean speeds between neighbouring positions.
fn chords(track: &Track) -> impl Iterator<Item = Chord> + '_ {
    let neighbours = track.times_s.windows(2).zip(track.positions_mm.windows(2));
    neighbours.filter_map(|(times, positions)| {
        let (span, way) = (times[1] - times[0], norm(minus(positions[1], positions[0])));
        let chord = Chord { from_s: times[0], to_s: times[1], speed_mm_s: way / span };
        (span > 0.0 && way.is_finite()).then_some(chord)
    })
}

/// Mean speeds of a measurement, without the speeds in gaps.
fn measured_chords(track: &Track) -> impl Iterator<Item = Chord> + '_ {
    let spans = track.times_s.windows(2).map(|pair| pair[1] - pair[0]);
    let longest_s = LONGEST_GAP * etalon_math::statistics::median(spans).unwrap_or(f64::INFINITY);
    chords(track).filter(move |chord| chord.to_s - chord.from_s <= longest_s)
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
pub fn offset_by_motion(measured: &[Track], logged: &[Way], rate: bool) -> Result<MotionClock, Message> {
    let tracks: Vec<(&Track, &Way)> = measured.iter().zip(logged).filter(|(m, _)| m.times_s.len() > 1).collect();
    let speeds: Vec<(Speeds, Speeds)> = tracks
        .iter()
        .map(|(m, l)| (Speeds::new(measured_chords(m)), Speeds::new(chords(&l.track))))
        .filter(|(m, _)| !m.times_s.is_empty())
        .collect();
    let pairs: Vec<(&Speeds, &Speeds)> = speeds.iter().map(|(m, l)| (m, l)).collect();
    let count: usize = pairs.iter().map(|(m, _)| m.times_s.len()).sum();
    let span = |all: Vec<&Speeds>| {
        let spans = all.into_iter().filter_map(Speeds::span);
        spans.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
    };
    let (all_measured, all_logged) = pairs.iter().copied().unzip();
    let (Some(of_measured), Some(of_log)) = (span(all_measured), span(all_logged)) else {
        return Err(error!("clock-motion-short", count));
    };
    if count < FEWEST || pairs.iter().any(|(_, logged)| logged.times_s.len() < FEWEST) {
        return Err(error!("clock-motion-short", count));
    }
    let starts = best_offsets(&pairs, of_measured, of_log)?;
    let clock_at = |offset_s: f64| {
        let reference_s = (0.5 * (of_measured[0] + of_measured[1]) - offset_s).clamp(of_log[0], of_log[1]);
        Clock { offset_s, rate: 0.0, reference_s }
    };
    let step_s = pairs.iter().map(|(m, l)| m.step_s().max(l.step_s())).fold(0.0, f64::max);
    let few = Comparison { tracks: tracks.clone(), step_s, every: count.div_ceil(COMPARED) };
    let mut tried: Vec<MotionClock> = starts.iter().filter_map(|start| few.clock(clock_at(*start), false)).collect();
    tried.sort_by(|a, b| b.correlation.total_cmp(&a.correlation));
    let best = tried.first().copied();
    let unlike = || error!("clock-motion-unlike", correlation = best.map_or(0.0, |best| best.correlation));
    let best = best.filter(|best| best.correlation >= SMALLEST_CORRELATION).ok_or_else(unlike)?;
    several(&best, &tried, step_s)?;
    let all = Comparison { tracks, step_s, every: 1 };
    match all.clock(Clock { offset_s: best.clock.offset_s, ..clock_at(best.clock.offset_s) }, rate) {
        Some(found) if found.clock.rate.abs() > LARGEST_RATE => {
            Err(error!("clock-rate-none", most_ppm = 1e6 * LARGEST_RATE))
        }
        Some(found) if found.correlation >= SMALLEST_CORRELATION => Ok(found),
        found => Err(error!("clock-motion-unlike", correlation = found.map_or(0.0, |found| found.correlation))),
    }
}

/// Error if another offset leaves hardly more of the speeds unexplained than the best one.
fn several(best: &MotionClock, tried: &[MotionClock], step_s: f64) -> Result<(), Message> {
    let unexplained = |clock: &MotionClock| 1.0 - clock.correlation.powi(2);
    let is_rival = |other: &&MotionClock| {
        (other.clock.offset_s - best.clock.offset_s).abs() > 2.0 * step_s
            && unexplained(other) < RIVAL * unexplained(best) + LEAST_UNEXPLAINED
    };
    let rivals = tried.iter().filter(is_rival);
    let mut offsets: Vec<f64> = rivals.chain([best]).map(|clock| clock.clock.offset_s).collect();
    offsets.sort_by(f64::total_cmp);
    offsets.dedup_by(|a, b| (*a - *b).abs() <= 2.0 * step_s);
    if offsets.len() < 2 {
        return Ok(());
    }
    let range = |o: &f64| phrase!("range-of-seconds", low_s = o - step_s, high_s = o + step_s);
    let ranges: Vec<_> = offsets.iter().take(6).map(range).collect();
    Err(error!("clock-motion-several", count = offsets.len(), ranges))
}

/// Offsets with the largest correlations, of all offsets at which half of the shorter recording
/// lies within the longer one: first with mean speeds of equal intervals, then with shorter
/// intervals about each of them.
fn best_offsets(pairs: &[(&Speeds, &Speeds)], measured: [f64; 2], log: [f64; 2]) -> Result<Vec<f64>, Message> {
    let finest = pairs.iter().map(|(m, l)| m.step_s().max(l.step_s())).fold(f64::INFINITY, f64::min);
    let spans = [measured, log].map(|[first, last]| last - first);
    let step = finest.max(spans[0].max(spans[1]) / SPANS as f64);
    let binned: Vec<[Vec<f64>; 2]> =
        pairs.iter().map(|(m, l)| [m.means(measured[0], step, spans[0]), l.means(log[0], step, spans[1])]).collect();
    let half = (0.5 * spans[0].min(spans[1]) / step) as i64;
    let lags: Vec<i64> = (half - (spans[1] / step) as i64..=(spans[0] / step) as i64 - half).collect();
    let offset = |k: usize| measured[0] - log[0] + step * lags[k] as f64;
    let all: Vec<f64> = lags.iter().map(|lag| lagged(&binned, *lag)).collect();
    let best = (0..all.len()).max_by(|a, b| all[*a].total_cmp(&all[*b])).unwrap_or(0);
    if all.get(best).is_none_or(|value| *value < 0.5 * SMALLEST_CORRELATION) {
        return Err(error!("clock-motion-unlike", correlation = all.get(best).copied().unwrap_or(0.0).max(0.0)));
    }
    // with the stated places the right offset may not be the largest maximum
    let is_peak = |k: &usize| {
        let beside = [k.checked_sub(1), Some(k + 1)].into_iter().flatten().filter_map(|k| all.get(k));
        all[*k] > PEAK * all[best] && beside.into_iter().all(|other| all[*k] >= *other)
    };
    let mut peaks: Vec<usize> = (0..all.len()).filter(is_peak).collect();
    peaks.sort_by(|a, b| all[*b].total_cmp(&all[*a]));
    let most = (COMPARED / pairs.len().max(1)).max(FEWEST);
    let finer = |k: &usize| {
        let (mut found, mut width) = (offset(*k), step);
        while width > 0.25 * finest {
            width *= 0.25;
            let tried = (-6..=6).map(|k| found + width * f64::from(k));
            let rated = tried.map(|at| (at, correlation(pairs, &Clock::with_offset(at), most)));
            found = rated.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(found, |best| best.0);
        }
        found
    };
    Ok(peaks.iter().take(PEAKS).map(finer).collect())
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

/// Measured positions and positions of the log, target by target.
struct Comparison<'a> {
    tracks: Vec<(&'a Track, &'a Way)>,
    /// Larger median time between neighbouring positions of the two recordings.
    step_s: f64,
    /// One of this number of measured speeds is compared.
    every: usize,
}

/// Clock, and the corrections of the places of all targets (mm).
#[derive(Clone)]
struct Fit {
    clock: Clock,
    places_mm: Vec<Vec<f64>>,
    /// Mean square of the residual speeds (mm²/s²).
    square: f64,
    /// Standard uncertainties of offset and rate.
    uncertainties: [f64; 2],
}

/// Normal equations of the speeds.
struct Normal {
    matrix: DMatrix<f64>,
    right: DVector<f64>,
    squares: f64,
    rows: f64,
}

impl Comparison<'_> {
    /// Offset and rate of least squares near a clock; `None` if the speeds do not determine them.
    fn clock(&self, start: Clock, rate: bool) -> Option<MotionClock> {
        let places_mm = self.tracks.iter().map(|(_, way)| vec![0.0; way.place_uncertainties_mm.len()]).collect();
        let start = Fit { clock: start, places_mm, square: f64::INFINITY, uncertainties: [f64::NAN; 2] };
        let mut found = self.solve(start, 1)?;
        let mut rate_uncertainty = f64::NAN;
        if rate {
            let with_rate = self.solve(found.clone(), 2)?;
            rate_uncertainty = with_rate.uncertainties[1];
            // a rate within two standard uncertainties is not told from zero
            if with_rate.clock.rate.abs() > 2.0 * rate_uncertainty {
                found = with_rate;
            }
        }
        let correlation = coefficient(self.speeds(&found).into_iter());
        let offset_uncertainty_s = found.uncertainties[0];
        Some(MotionClock { clock: found.clock, offset_uncertainty_s, rate_uncertainty, correlation })
    }

    /// Least squares of the offset, with two free values of the rate, and of the places.
    fn solve(&self, mut fit: Fit, free: usize) -> Option<Fit> {
        for _ in 0..STEPS {
            let normal = self.normal(&fit, free)?;
            fit.square = normal.squares / normal.rows;
            let variance = normal.squares / (normal.rows - normal.right.len() as f64).max(1.0);
            let weighted = self.with_stated_places(normal, &fit, free, variance);
            let solved = weighted.matrix.cholesky()?;
            let (step, inverse) = (solved.solve(&weighted.right), solved.inverse());
            fit.uncertainties = [0, 1].map(|k| if k < free { (variance * inverse[(k, k)]).sqrt() } else { f64::NAN });
            let next = self.shorter(&fit, &step, free)?;
            let moved = (next.clock.offset_s - fit.clock.offset_s).abs();
            fit = Fit { uncertainties: fit.uncertainties, ..next };
            if moved < CONVERGED_S {
                break;
            }
        }
        Some(fit)
    }

    /// The step, halved until the residuals are smaller.
    fn shorter(&self, fit: &Fit, step: &DVector<f64>, free: usize) -> Option<Fit> {
        let mut share = 1.0;
        loop {
            let next = self.moved(fit, step, free, share);
            let square = self.square(&next)?;
            if square <= fit.square || share < 0.1 {
                return Some(Fit { square, ..next });
            }
            share *= 0.5;
        }
    }

    fn moved(&self, fit: &Fit, step: &DVector<f64>, free: usize, share: f64) -> Fit {
        let mut next = fit.clone();
        next.clock.offset_s += share * step[0].clamp(-self.step_s, self.step_s);
        next.clock.rate += if free > 1 { share * step[1] } else { 0.0 };
        let places = next.places_mm.iter_mut().flatten();
        places.zip(step.iter().skip(free)).for_each(|(place, step)| *place += share * step);
        next
    }

    /// Mean square of the residual speeds.
    fn square(&self, fit: &Fit) -> Option<f64> {
        let speeds = self.speeds(fit);
        let squares: f64 = speeds.iter().map(|[measured, logged]| (measured - logged).powi(2)).sum();
        (!speeds.is_empty()).then(|| squares / speeds.len() as f64)
    }

    /// Measured speeds with the speeds of the log.
    fn speeds(&self, fit: &Fit) -> Vec<[f64; 2]> {
        let mut all = Vec::new();
        for ((track, way), place) in self.tracks.iter().zip(&fit.places_mm) {
            let pair = |chord: Chord| Some([chord.speed_mm_s, logged_speed(way, chord, &fit.clock, place)?.0]);
            all.extend(measured_chords(track).step_by(self.every.max(1)).filter_map(pair));
        }
        all
    }

    /// Normal equations of offset, rate and places.
    fn normal(&self, fit: &Fit, free: usize) -> Option<Normal> {
        let places: usize = fit.places_mm.iter().map(Vec::len).sum();
        let count = free + places;
        let (mut matrix, mut right) = (DMatrix::zeros(count, count), DVector::zeros(count));
        let (mut squares, mut rows, mut from) = (0.0, 0.0, free);
        let mut row = vec![0.0; count];
        for ((track, way), place) in self.tracks.iter().zip(&fit.places_mm) {
            for chord in measured_chords(track).step_by(self.every.max(1)) {
                let speed = |shift_s: f64| {
                    let clock = Clock { offset_s: fit.clock.offset_s + shift_s, ..fit.clock };
                    logged_speed(way, chord, &clock, place)
                };
                let (Some((before, _)), Some((at, by_place)), Some((behind, _))) =
                    (speed(-self.step_s), speed(0.0), speed(self.step_s))
                else {
                    continue;
                };
                let by_offset = (behind - before) / (2.0 * self.step_s);
                let middle_s = fit.clock.log_time_s(0.5 * (chord.from_s + chord.to_s));
                row.fill(0.0);
                row[0] = by_offset;
                if free > 1 {
                    row[1] = by_offset * (middle_s - fit.clock.reference_s);
                }
                row[from..from + by_place.len()].copy_from_slice(&by_place);
                let used: Vec<usize> = (0..count).filter(|j| row[*j] != 0.0).collect();
                let residual = chord.speed_mm_s - at;
                (squares, rows) = (squares + residual * residual, rows + 1.0);
                for &i in &used {
                    right[i] += row[i] * residual;
                    used.iter().for_each(|&j| matrix[(i, j)] += row[i] * row[j]);
                }
            }
            from += place.len();
        }
        (rows > count as f64).then_some(Normal { matrix, right, squares, rows })
    }

    /// Adds the stated places with their uncertainties.
    fn with_stated_places(&self, mut normal: Normal, fit: &Fit, free: usize, variance: f64) -> Normal {
        let stated = self.tracks.iter().flat_map(|(_, way)| &way.place_uncertainties_mm);
        let variance = variance.max(LEAST_SPREAD_MM_S.powi(2));
        for (i, (u, place)) in (free..).zip(stated.zip(fit.places_mm.iter().flatten())) {
            let weight = variance / u.min(UNKNOWN_PLACE_MM).powi(2);
            normal.matrix[(i, i)] += weight;
            normal.right[i] -= weight * place;
        }
        normal
    }
}

/// Mean speed by the log in the time of a measured one, and its derivatives by the place of the
/// target; `None` outside of the log.
fn logged_speed(way: &Way, chord: Chord, clock: &Clock, place_mm: &[f64]) -> Option<(f64, Vec<f64>)> {
    let span = chord.to_s - chord.from_s;
    let (from, by_place_from) = way.at(clock.log_time_s(chord.from_s), place_mm)?;
    let (to, by_place_to) = way.at(clock.log_time_s(chord.to_s), place_mm)?;
    let change = minus(to, from);
    let length = norm(change);
    let derivative = |(from, to): (&Vector, &Vector)| match length > 0.0 {
        true => dot(change, minus(*to, *from)) / (length * span),
        false => 0.0,
    };
    Some((length / span, by_place_from.iter().zip(&by_place_to).map(derivative).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::pose::Pose;

    /// Position of a target that never stands still.
    fn position(t: f64) -> Vector {
        let turn = 0.31 * t + 0.4 * (0.13 * t).sin();
        [
            300.0 * turn.cos() + 40.0 * (1.7 * t).sin(),
            250.0 * turn.sin(),
            80.0 * (0.47 * t).sin() + 30.0 * (1.1 * t).cos(),
        ]
    }

    /// Positions at a rate in Hz from a time on, with a noise of this size (mm), on another clock.
    fn track(from: f64, rate_hz: f64, count: usize, noise_mm: f64, clock: impl Fn(f64) -> f64) -> Track {
        let times: Vec<f64> = (0..count).map(|i| from + i as f64 / rate_hz).collect();
        let noisy = |(i, t): (usize, &f64)| {
            let mut p = position(*t);
            p.iter_mut()
                .enumerate()
                .for_each(|(k, v)| *v += noise_mm * ((12.9 * i as f64 + 7.7 * k as f64).sin() * 43_758.5).fract());
            p
        };
        let positions_mm: Vec<Vector> = times.iter().enumerate().map(noisy).collect();
        Track { times_s: times.iter().map(|t| clock(*t)).collect(), positions_mm }
    }

    /// Way of a target whose place is known.
    fn known(track: Track) -> Way {
        Way { by_place: vec![Vec::new(); track.times_s.len()], track, place_uncertainties_mm: Vec::new() }
    }

    #[test]
    fn two_recordings_of_one_motion_give_the_offset_with_its_uncertainty() {
        let truth = 1_764_342_000.125;
        let log = known(track(0.0, 250.0, 15_000, 0.0, |t| t));
        for noise in [0.0, 0.02] {
            let tracker = track(12.0, 50.0, 1500, noise, |t| t + truth);
            let found = offset_by_motion(&[tracker], std::slice::from_ref(&log), false).unwrap();
            let error = found.clock.offset_s - truth;
            assert!(error.abs() < 1e-3 && error.abs() <= 4.0 * found.offset_uncertainty_s + 2e-4, "{error} {found:?}");
            assert!(found.clock.rate == 0.0 && found.correlation > 0.99, "{found:?}");
        }
    }

    #[test]
    fn a_drift_of_the_clocks_is_found_and_none_is_insignificant() {
        let log = known(track(0.0, 100.0, 120_000, 0.0, |t| t));
        for rate in [60e-6, 0.0] {
            let tracker = track(30.0, 20.0, 22_000, 0.02, |t| t + 5.5 + rate * (t - 600.0));
            let found = offset_by_motion(&[tracker], std::slice::from_ref(&log), true).unwrap();
            let error = found.clock.rate - rate;
            assert!(error.abs() < 4e-6 && error.abs() <= 4.0 * found.rate_uncertainty + 1e-6, "{error} {found:?}");
            assert!(found.rate_uncertainty < 5e-6, "{found:?}");
        }
    }

    #[test]
    fn another_motion_a_short_one_and_a_periodic_one_are_refused() {
        let log = known(track(0.0, 100.0, 6000, 0.0, |t| t));
        let other = Track {
            times_s: (0..1000).map(|i| 0.05 * f64::from(i)).collect(),
            positions_mm: (0..1000).map(|i| [f64::from(i * i % 37), f64::from(i % 11), 0.0]).collect(),
        };
        let refused = |measured: &Track, logged: &Way| {
            offset_by_motion(std::slice::from_ref(measured), std::slice::from_ref(logged), false).unwrap_err()
        };
        assert!(refused(&other, &log).is("clock-motion-unlike", &[]));
        let short = track(3.0, 50.0, 6, 0.0, |t| t);
        assert!(refused(&short, &log).is("clock-motion-short", &[("count", &5)]));
        let periodic = |from: f64, count: usize| {
            let times_s: Vec<f64> = (0..count).map(|i| from + 0.02 * i as f64).collect();
            let positions_mm: Vec<Vector> = times_s.iter().map(|t| [100.0 * (0.5 * t).sin(), 0.0, 0.0]).collect();
            Track { times_s, positions_mm }
        };
        assert!(refused(&periodic(20.0, 1000), &known(periodic(0.0, 6000))).is("clock-motion-several", &[]));
    }

    /// Measurements in bursts at standstills do not see the motion between them: its mean speed
    /// follows the times of the bursts, and not the clocks.
    #[test]
    fn bursts_at_standstills_show_no_offset() {
        // two seconds at each place, one second to the next one
        let at = |t: f64| {
            let (place, within) = ((t / 3.0).floor(), (t % 3.0 - 2.0).max(0.0));
            let corner = |k: f64| [90.0 * (2.1 * k).sin(), 70.0 * (3.7 * k).cos(), 50.0 * (1.3 * k).sin()];
            let (from, to) = (corner(place), corner(place + 1.0));
            [0, 1, 2].map(|k| from[k] + within * (to[k] - from[k]))
        };
        let positions = |times_s: Vec<f64>, clock_s: f64| Track {
            positions_mm: times_s.iter().map(|t| at(*t).map(|v| v + 0.02 * (977.0 * t).sin())).collect(),
            times_s: times_s.iter().map(|t| t + clock_s).collect(),
        };
        let log = known(positions((0..9000).map(|i| 0.02 * f64::from(i)).collect(), 0.0));
        let whole = positions((0..3000).map(|i| 6.0 + 0.05 * f64::from(i)).collect(), 0.37);
        let found = offset_by_motion(&[whole], std::slice::from_ref(&log), false).unwrap();
        assert!((found.clock.offset_s - 0.37).abs() < 5e-3, "{found:?}");
        let bursts = (2..50).flat_map(|k| (0..10).map(move |i| 3.0 * f64::from(k) + 0.7 + 0.05 * f64::from(i)));
        let bursts = positions(bursts.collect(), 0.37);
        let refused = offset_by_motion(&[bursts], std::slice::from_ref(&log), false).unwrap_err();
        assert!(refused.is("clock-motion-unlike", &[]), "{refused}");
    }

    /// A flange that turns on its way, and a target away from the stated place: the place
    /// on the robot is found with the offset, or the offset is wrong.
    #[test]
    fn a_target_at_another_place_on_the_robot_does_not_shift_the_clock() {
        let turned = |t: f64, v: Vector| {
            let turn = [0.7 * (0.9 * t).sin(), 0.5 * (0.6 * t + 1.0).sin(), 0.8 * (0.35 * t).cos()];
            Pose::from_rotation_vector(turn).rotate(v)
        };
        let place = [120.0, -60.0, 30.0];
        let at = |t: f64, place: Vector| {
            let (p, r) = (position(t), turned(t, place));
            [0, 1, 2].map(|k| p[k] + r[k])
        };
        let times_s: Vec<f64> = (0..6000).map(|i| 0.02 * f64::from(i)).collect();
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let by_place = times_s.iter().map(|t| axes.map(|axis| turned(*t, axis)).to_vec()).collect();
        let positions_mm = times_s.iter().map(|t| at(*t, [0.0; 3])).collect();
        let track = Track { times_s, positions_mm };
        let way = Way { track, by_place, place_uncertainties_mm: vec![f64::INFINITY; 3] };
        let shown: Vec<f64> = (0..600).map(|i| 12.0 + 0.1 * f64::from(i)).collect();
        let positions_mm = shown.iter().map(|t| at(*t, place)).collect();
        let tracker = Track { times_s: shown.iter().map(|t| t + 77.25).collect(), positions_mm };
        let offset = |way: Way| offset_by_motion(std::slice::from_ref(&tracker), &[way], false);
        let found = offset(way.clone()).unwrap();
        let error = found.clock.offset_s - 77.25;
        assert!(error.abs() < 1e-4 && error.abs() <= 4.0 * found.offset_uncertainty_s + 2e-5, "{error} {found:?}");
        // held at the stated place
        let held = offset(Way { place_uncertainties_mm: vec![1e-3; 3], ..way });
        assert!(!held.is_ok_and(|held| (held.clock.offset_s - 77.25).abs() < 5e-3));
    }
}
