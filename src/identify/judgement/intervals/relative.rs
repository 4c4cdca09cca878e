//! Relative accuracy: errors of the distances between poses, which do not depend on the base.
//!
//! The error of a pair of readings of one target at two poses is the distance of the predicted
//! positions minus the distance of the measured positions. A shift or rotation of the base, or of
//! the frame of all measurements, changes neither. The target has an effect unless both poses have
//! the same orientation. The parameters of the robot are judged: they add no uncertainty.

use crate::judgement::figures::{JudgedErrors, Propagation};
use crate::{Observation, Result, Settings, Systematic};
use etalon_base::noise::Noise;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::{SizeStatistics, SizeSums, UpperTail};
use etalon_robots::Robot;
use std::ops::Range;

/// Maximum number of pairs; of more pairs, an even selection counts.
const MOST_PAIRS: usize = 100_000;
/// Minimum number of steps of the distances; the step is 1, 2 or 5 times a power of ten.
const STEPS: f64 = 5.0;
/// Seed of the selection.
const SEED: u64 = 45;

/// Errors of distances, of all pairs and by steps of the distance.
#[derive(Clone, Debug, PartialEq)]
pub struct RelativeErrors {
    /// Number of pairs of readings of one target at different poses.
    pub available: usize,
    /// All selected pairs.
    pub all: DistanceErrors,
    /// Pairs of each step of the measured distance; steps without pairs are omitted.
    pub steps: Vec<DistanceErrors>,
}

/// Errors of the distances within a range.
#[derive(Clone, Debug, PartialEq)]
pub struct DistanceErrors {
    /// Range of the measured distances (mm): from the first value to below the second.
    pub range_mm: [f64; 2],
    /// Number of pairs.
    pub pairs: usize,
    /// Sizes (mm) of the errors before and after.
    pub sizes_mm: [SizeStatistics; 2],
    /// Standard uncertainties (mm) of root mean square, 95th percentile and maximum after; absent
    /// if no uncertainty is given.
    pub standard_uncertainties_mm: Option<[f64; 3]>,
}

/// One reading of a target.
struct Reading {
    pose: PoseName,
    /// Its residuals.
    rows: Range<usize>,
    /// Each coordinate (mm) of the [`POSITIONS`].
    at: [[f64; POSITIONS]; 3],
}

/// Positions of a reading: measured and predicted, with the parameters before and after. Measured
/// positions of a platform depend on the parameters.
const POSITIONS: usize = 4;
/// Measured position, with the parameters after.
const MEASURED: usize = 1;

impl Reading {
    fn new(pose: PoseName, rows: Range<usize>, measured: [Vector; 2], predicted: [Vector; 2]) -> Self {
        let at = [0, 1, 2].map(|axis| [measured[0], measured[1], predicted[0], predicted[1]].map(|at| at[axis]));
        Self { pose, rows, at }
    }
}

/// A pair of readings.
#[derive(Clone, Copy)]
struct Pair {
    readings: [u32; 2],
    distance_mm: f64,
    /// Predicted minus measured distance (mm) before and after.
    error_mm: [f64; 2],
}

impl JudgedErrors<'_> {
    /// Errors of the distances between the judged positions with the robot and parameters
    /// before, and with the judged ones; `None` without two poses of one target. Conditions do
    /// not count.
    ///
    /// # Errors
    /// Fails if residuals cannot be evaluated.
    pub fn distances(
        &self,
        robot_before: &dyn Robot,
        values_before: &[f64],
        settings: &Settings,
        systematic: &Systematic,
    ) -> Result<Option<RelativeErrors>> {
        let groups = self.readings_of_targets(robot_before, values_before);
        let readings: Vec<&Reading> = groups.iter().flatten().collect();
        let (pairs, available) = pairs(&groups, &readings);
        let finite = |p: &Pair| [p.distance_mm, p.error_mm[0], p.error_mm[1]].iter().all(|v| v.is_finite());
        if pairs.is_empty() || !pairs.iter().all(finite) {
            return Ok(None);
        }
        let stated = settings.standard_uncertainty_mm.is_some();
        let propagation = stated.then(|| self.propagation(settings, systematic)).transpose()?;
        let step = step(pairs.iter().map(|p| p.distance_mm).fold(0.0, f64::max));
        let (pairs, ends) = by_step(&pairs, step);
        // the pairs of all steps give the sums and the gradient of all pairs
        let mut whole = Group::new(&pairs, propagation.as_ref());
        let mut steps = Vec::new();
        for (k, [first, end]) in ends.iter().enumerate().filter(|(_, [first, end])| first < end) {
            let mut of_step = Group::new(&pairs[*first..*end], propagation.as_ref());
            of_step.sum(&readings);
            whole.add(&of_step);
            steps.push(of_step.errors([k, k + 1].map(|k| k as f64 * step), &readings));
        }
        let all = whole.errors([0.0, ends.len() as f64 * step], &readings);
        Ok(Some(RelativeErrors { available, steps, all }))
    }

    /// Readings of each target, or of the centre of a platform, in the order of the residuals of
    /// the judged positions.
    fn readings_of_targets(&self, robot_before: &dyn Robot, values_before: &[f64]) -> Vec<Vec<Reading>> {
        let (robot, sides) = (self.robot, [(robot_before, values_before), (self.robot, self.values)]);
        let mut groups: Vec<Vec<Reading>> = Vec::new();
        groups.resize_with(robot.targets().len().max(1), Vec::new);
        let mut row = 0;
        for o in self.observations {
            if let Some(platform) = robot.platform() {
                let [Some(k), Some(l)] = o.targets[..] else { continue };
                let pair = [[k[0], k[1]], [l[0], l[1]]];
                let measured = sides.map(|(_, values)| {
                    let pose = platform.measured_pose(values, pair);
                    [pose.x_mm, pose.y_mm, 0.0]
                });
                let predicted = [0, 1].map(|i| {
                    let error = platform.pose_error(sides[i].1, &o.joints, pair);
                    [measured[i][0] + error[0], measured[i][1] + error[1], 0.0]
                });
                groups[0].push(Reading::new(o.pose, row..row + 2, measured, predicted));
                row += 3;
                continue;
            }
            for (k, at) in measured_targets(o) {
                let predicted = sides.map(|(robot, values)| robot.position(values, &o.joints, k));
                let rows = row..row + robot.dimension();
                groups[k].push(Reading::new(o.pose, rows, [at; 2], predicted));
                row += robot.dimension();
            }
        }
        groups
    }
}

/// Indices and positions of the measured targets.
fn measured_targets(o: &Observation) -> impl Iterator<Item = (usize, Vector)> + '_ {
    o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)))
}

impl Pair {
    fn new(readings: [u32; 2], all: &[&Reading]) -> Self {
        let [a, b] = readings.map(|i| all[i as usize]);
        let mut lengths = [0.0; POSITIONS];
        for (from, to) in a.at.iter().zip(&b.at) {
            lengths.iter_mut().zip(from.iter().zip(to)).for_each(|(sum, (from, to))| *sum += (to - from) * (to - from));
        }
        let [before, distance_mm, predicted_before, predicted] = lengths.map(f64::sqrt);
        Self { readings, distance_mm, error_mm: [predicted_before - before, predicted - distance_mm] }
    }

    /// Adds the derivatives of `weight` times the error with respect to the residuals (predicted
    /// minus measured position).
    fn add(&self, weight: f64, readings: &[&Reading], by: &mut [f64]) {
        let [a, b] = self.readings.map(|i| readings[i as usize]);
        if self.distance_mm > 0.0 {
            let per_mm = weight / self.distance_mm;
            let across = [0, 1, 2].map(|axis| per_mm * (b.at[axis][MEASURED] - a.at[axis][MEASURED]));
            for ((i, j), across) in a.rows.clone().zip(b.rows.clone()).zip(across) {
                by[i] -= across;
                by[j] += across;
            }
        }
    }
}

/// Pairs in the order of the steps of the measured distance, and the first pair and the end of each
/// step.
fn by_step(pairs: &[Pair], step_mm: f64) -> (Vec<Pair>, Vec<[usize; 2]>) {
    let steps: Vec<usize> = pairs.iter().map(|pair| (pair.distance_mm / step_mm) as usize).collect();
    let mut ends: Vec<[usize; 2]> = Vec::new();
    for &k in &steps {
        if k >= ends.len() {
            ends.resize(k + 1, [0; 2]);
        }
        ends[k][1] += 1;
    }
    let mut end = 0;
    for [first, count] in &mut ends {
        (*first, end) = (end, end + *count);
        *count = *first;
    }
    let mut sorted = pairs.to_vec();
    for (pair, &k) in pairs.iter().zip(&steps) {
        let [_, next] = &mut ends[k];
        sorted[*next] = *pair;
        *next += 1;
    }
    (sorted, ends)
}

/// Pairs whose errors are judged together.
struct Group<'a> {
    pairs: &'a [Pair],
    propagation: Option<&'a Propagation>,
    /// Sums of the sizes (mm) of the errors before and after calibration.
    sums: [SizeSums; 2],
    /// Derivatives of half the sum of the squared errors after with respect to the residuals;
    /// empty if no uncertainty is given.
    gradient: Vec<f64>,
}

impl<'a> Group<'a> {
    /// Group without sums.
    fn new(pairs: &'a [Pair], propagation: Option<&'a Propagation>) -> Self {
        let gradient = vec![0.0; propagation.map_or(0, Propagation::residual_count)];
        Self { pairs, propagation, sums: Default::default(), gradient }
    }

    fn sum(&mut self, readings: &[&Reading]) {
        for pair in self.pairs {
            let [before, after] = pair.error_mm;
            self.sums[0].add(before);
            self.sums[1].add(after);
            if self.propagation.is_some() {
                pair.add(after, readings, &mut self.gradient);
            }
        }
    }

    /// Adds the sums of some of its pairs.
    fn add(&mut self, part: &Group) {
        self.sums.iter_mut().zip(&part.sums).for_each(|(sum, by)| sum.join(by));
        self.gradient.iter_mut().zip(&part.gradient).for_each(|(sum, by)| *sum += by);
    }

    fn errors(self, range_mm: [f64; 2], readings: &[&Reading]) -> DistanceErrors {
        let mut sizes = Vec::with_capacity(self.pairs.len());
        let [before, after] = [0, 1].map(|side| {
            sizes.clear();
            sizes.extend(self.pairs.iter().map(|pair| pair.error_mm[side]));
            UpperTail::from_sizes(&mut sizes, 0.95).unwrap_or_default()
        });
        DistanceErrors {
            range_mm,
            pairs: self.pairs.len(),
            sizes_mm: [self.sums[0].statistics(before), self.sums[1].statistics(after)],
            standard_uncertainties_mm: self.propagation.map(|p| self.uncertainties(p, after, readings)),
        }
    }

    /// Standard uncertainties (mm) of root mean square, 95th percentile and maximum of the errors
    /// after.
    fn uncertainties(&self, propagation: &Propagation, after: UpperTail, readings: &[&Reading]) -> [f64; 3] {
        let rms = self.sums[1].statistics(after).rms;
        let mut by = self.gradient.clone();
        if rms > 0.0 {
            by.iter_mut().for_each(|by| *by /= rms * self.pairs.len() as f64);
        }
        let of = |by: &[f64]| propagation.variances(by).iter().map(|(_, variance)| variance).sum::<f64>().sqrt();
        let of_rms = of(&by);
        let mut of_errors = |errors: &[(f64, f64)]| {
            by.fill(0.0);
            for (size, weight) in errors {
                if let Some(pair) = self.pairs.iter().find(|pair| pair.error_mm[1].abs() == *size) {
                    pair.add(weight * pair.error_mm[1].signum(), readings, &mut by);
                }
            }
            of(&by)
        };
        let of_p95 = of_errors(&[(after.low, 1.0 - after.part), (after.high, after.part)]);
        [of_rms, of_p95, of_errors(&[(after.max, 1.0)])]
    }
}

/// Pairs of readings of one target at different poses: all of them, or an even selection. Also the
/// number of all pairs. `readings` are the readings of all groups.
fn pairs(groups: &[Vec<Reading>], readings: &[&Reading]) -> (Vec<Pair>, usize) {
    let count: usize = groups.iter().map(|group| pair_count(group.len())).sum();
    let mut available = count;
    let mut indices = selection(count).peekable();
    let (mut chosen, mut first, mut start) = (Vec::with_capacity(count.min(MOST_PAIRS)), 0, 0);
    for group in groups {
        let mut poses: Vec<PoseName> = group.iter().map(|r| r.pose).collect();
        poses.sort_unstable();
        available -= poses.chunk_by(|a, b| a == b).map(|same| pair_count(same.len())).sum::<usize>();
        let end = start + pair_count(group.len());
        let mut choose = |[i, j]: [usize; 2]| {
            if group[i].pose != group[j].pose {
                chosen.push(Pair::new([i, j].map(|k| (first + k) as u32), readings));
            }
        };
        if count <= MOST_PAIRS {
            (1..group.len()).for_each(|j| (0..j).for_each(|i| choose([i, j])));
        } else {
            let mut j = 1;
            while let Some(index) = indices.next_if(|index| *index < end) {
                let pair = pair_at(index - start, j);
                j = pair[1];
                choose(pair);
            }
        }
        first += group.len();
        start = end;
    }
    (chosen, available)
}

/// Number of pairs of `n` items.
fn pair_count(n: usize) -> usize {
    n * n.saturating_sub(1) / 2
}

/// Indices of a list of pairs in ascending order: all, or one at random in each of
/// [`MOST_PAIRS`] equal parts.
fn selection(count: usize) -> impl Iterator<Item = usize> {
    let mut noise = Noise::new(SEED, 0);
    let part = count as f64 / MOST_PAIRS as f64;
    let index = move |k: usize| match count <= MOST_PAIRS {
        true => k,
        false => (((k as f64 + 0.5 + noise.uniform(0.5)) * part) as usize).min(count - 1),
    };
    // neighbouring parts may share the index at their common end
    let mut last = None;
    (0..count.min(MOST_PAIRS)).map(index).filter(move |index| last.replace(*index) != Some(*index))
}

/// Pair i < j at an index of the list (0, 1), (0, 2), (1, 2), (0, 3) ...; `j` is at least `from`.
fn pair_at(index: usize, from: usize) -> [usize; 2] {
    let mut j = from;
    while pair_count(j + 1) <= index {
        j += 1;
    }
    [index - pair_count(j), j]
}

/// Returns the width of the classes of distances from zero to `largest_mm`: 1, 2 or 5 times a power
/// of ten.
fn step(largest_mm: f64) -> f64 {
    let least = (largest_mm / STEPS).max(f64::MIN_POSITIVE);
    let decade = 10f64.powf(least.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|step| *step <= least).unwrap_or(decade)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_of_pairs_has_each_pair_once_and_the_selection_is_even() {
        let listed: Vec<[usize; 2]> = (0..pair_count(5)).map(|index| pair_at(index, 1)).collect();
        let expected: Vec<[usize; 2]> = (0..5).flat_map(|j| (0..j).map(move |i| [i, j])).collect();
        assert_eq!(listed, expected);
        for n in [3_000usize, 100_000, 60_000_000] {
            let last = pair_count(n) - 1;
            assert_eq!((pair_at(last, n - 9), pair_at(last + 1, n - 1)), ([n - 2, n - 1], [0, n]));
        }
        assert!(selection(MOST_PAIRS).eq(0..MOST_PAIRS));
        let few: Vec<usize> = selection(7 * MOST_PAIRS + 3).collect();
        assert!((MOST_PAIRS / 100 * 99..=MOST_PAIRS).contains(&few.len()));
        assert!(few.windows(2).all(|pair| pair[0] < pair[1]) && selection(7 * MOST_PAIRS + 3).eq(few.iter().copied()));
        // in steps of a part, anywhere in the whole list
        let place = |index: usize| (index as f64 / (7.0 + 3.0 / MOST_PAIRS as f64)).fract();
        let mean = few.iter().map(|index| place(*index)).sum::<f64>() / few.len() as f64;
        assert!(few.windows(2).all(|pair| pair[1] - pair[0] < 15) && (mean - 0.5).abs() < 0.005, "{mean}");
    }

    #[test]
    fn steps_are_round_and_at_least_five() {
        for (largest, width) in [(1000.0, 200.0), (999.0, 100.0), (260.0, 50.0), (24.0, 2.0), (5.0, 1.0)] {
            assert!((step(largest) / width - 1.0).abs() < 1e-12, "{largest}: {}", step(largest));
            assert!(largest / step(largest) >= 5.0 - 1e-9 && largest / step(largest) < 13.0);
        }
        assert!(step(0.0) > 0.0);
    }
}
