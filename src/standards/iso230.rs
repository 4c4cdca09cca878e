//! Positioning of a linear axis to ISO 230-2:2014 with Amendment 1:2016 (terms and formulas of
//! clause 3): deviations of measured from programmed positions, approached n times from either
//! direction.

use crate::outlying::{FarReading, Readings, far_readings};
use etalon_math::statistics::{mean, standard_deviation};

/// Number of runs in each direction, and of positions, of a test of an axis (read in published
/// reports, not in the standard).
pub const RUNS: usize = 5;

/// Deviations of the runs to one position from one direction, in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Runs {
    /// Programmed position of the axis.
    pub position_mm: f64,
    /// `true` for positive direction (↑).
    pub is_forward: bool,
    /// Measured minus programmed position.
    pub deviations_mm: Vec<f64>,
}

/// Run that is far from all other runs of its position and direction, and from the runs before and
/// after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutlyingRun {
    /// Programmed position of the axis.
    pub position_mm: f64,
    /// `true` for positive direction (↑).
    pub is_forward: bool,
    /// Number of the run, from 1.
    pub run: usize,
    /// Distance from the median deviation.
    pub distance_mm: f64,
    /// Median distance of the runs from the median deviation.
    pub median_mm: f64,
}

/// Returns the runs that are far from the others, the farthest first. The standard excludes no run.
pub fn outlying_runs(runs: &[Runs]) -> Vec<OutlyingRun> {
    let group = |r: &Runs| {
        let readings = Readings::new(r.deviations_mm.iter().map(|d| [*d, 0.0, 0.0]).collect())?;
        Some(((r.position_mm, r.is_forward), readings))
    };
    let (places, groups): (Vec<(f64, bool)>, Vec<Readings>) = runs.iter().filter_map(group).unzip();
    let outlying = |FarReading { group, reading, distance_mm, median_mm }: FarReading| {
        let (position_mm, is_forward) = places[group];
        OutlyingRun { position_mm, is_forward, run: reading + 1, distance_mm, median_mm }
    };
    let mut found: Vec<OutlyingRun> = far_readings(&groups, 1).into_iter().map(outlying).collect();
    found.sort_by(|a, b| b.distance_mm.total_cmp(&a.distance_mm));
    found
}

/// Number of times that a table contains the same runs digit for digit; `None` if the runs differ,
/// or do not scatter.
pub fn repeated_runs(runs: &[Runs]) -> Option<usize> {
    let count = runs.first()?.deviations_mm.len();
    let repeat = |times: &usize| {
        let own = count / times;
        let is_repeated = |r: &Runs| (own..count).all(|i| r.deviations_mm[i] == r.deviations_mm[i - own]);
        count % times == 0 && own > 1 && runs.iter().all(is_repeated)
    };
    let scatters = |r: &Runs| r.deviations_mm.iter().any(|d| *d != r.deviations_mm[0]);
    let alike = runs.iter().all(|r| r.deviations_mm.len() == count);
    (alike && runs.iter().any(scatters)).then(|| (2..=count).rev().find(repeat))?
}

/// Runs to one position from one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// Number of runs n.
    pub runs: usize,
    /// Mean unidirectional positioning deviation x̄i.
    pub mean_mm: f64,
    /// Estimator of the unidirectional positioning repeatability si, with n − 1.
    pub estimator_mm: f64,
    /// Unidirectional positioning repeatability Ri = 4 si.
    pub repeatability_mm: f64,
}

/// One position of the axis, approached from both directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisPosition {
    /// Programmed position.
    pub position_mm: f64,
    /// Approach in positive direction (↑).
    pub forward: Approach,
    /// Approach in negative direction (↓).
    pub backward: Approach,
    /// Mean bidirectional positioning deviation x̄i = (x̄i↑ + x̄i↓) / 2.
    pub mean_mm: f64,
    /// Reversal error Bi = x̄i↑ − x̄i↓.
    pub reversal_mm: f64,
    /// Bidirectional positioning repeatability Ri = max(2 si↑ + 2 si↓ + |Bi|, Ri↑, Ri↓).
    pub repeatability_mm: f64,
}

/// A quantity of both directions together, and of each direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Directions {
    /// Bidirectional value.
    pub both_mm: f64,
    /// Unidirectional value in positive direction (↑).
    pub forward_mm: f64,
    /// Unidirectional value in negative direction (↓).
    pub backward_mm: f64,
}

/// Positioning of an axis.
///
/// # Examples
///
/// ```
/// use etalon_standards::iso230::{Approach, AxisPosition, AxisPositioning};
///
/// // deviations (nm) at two positions of a stage, approached five times from either side
/// let approach = |nm: [f64; 5]| Approach::new(&nm.map(|d| (d - 0.02) * 1e-6)).expect("two runs");
/// let (up2, up5) = ([-87.0, -97.0, -97.0, -95.0, -82.0], [-100.0, -112.0, -129.0, -109.0, -97.0]);
/// let down2 = [-103.0, -104.0, -95.0, -111.0, -93.0];
/// let down5 = [-104.0, -126.0, -130.0, -141.0, -107.0];
/// let axis = AxisPositioning::new(&[
///     AxisPosition::new(-4.88, approach(up2), approach(down2)), // mm
///     AxisPosition::new(10.48, approach(up5), approach(down5)),
/// ]);
///
/// // B(5) and R(5) in a report of the Paul Scherrer Institute (ecmccfg, fat_sat/report.md)
/// assert!((axis.reversal_mm * 1e6 - 12.2).abs() < 0.01);
/// assert!((axis.repeatability.both_mm * 1e6 - 68.82).abs() < 0.01);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisPositioning {
    /// Reversal error B = max |Bi|.
    pub reversal_mm: f64,
    /// Mean reversal error B̄, the mean of all Bi.
    pub mean_reversal_mm: f64,
    /// Positioning repeatability R = max Ri.
    pub repeatability: Directions,
    /// Systematic positioning error E = max x̄i − min x̄i; the bidirectional value is over all x̄i↑
    /// and x̄i↓.
    pub systematic: Directions,
    /// Mean bidirectional systematic positioning error M = max x̄i − min x̄i of the bidirectional
    /// means.
    pub mean_systematic_mm: f64,
    /// Positioning accuracy A = max (x̄i + 2 si) − min (x̄i − 2 si); the bidirectional value is
    /// over ↑ and ↓.
    pub accuracy: Directions,
}

impl Approach {
    /// Evaluates deviations (mm); `None` for fewer than two.
    pub fn new(deviations_mm: &[f64]) -> Option<Self> {
        let runs = deviations_mm.len();
        let (mean_mm, estimator_mm) = (mean(deviations_mm.iter().copied()), standard_deviation(deviations_mm));
        (runs > 1).then_some(Self { runs, mean_mm, estimator_mm, repeatability_mm: 4.0 * estimator_mm })
    }
}

impl AxisPosition {
    /// Evaluates a position from its runs in both directions.
    pub fn new(position_mm: f64, forward: Approach, backward: Approach) -> Self {
        let reversal_mm = forward.mean_mm - backward.mean_mm;
        let together = 2.0 * (forward.estimator_mm + backward.estimator_mm) + reversal_mm.abs();
        Self {
            position_mm,
            forward,
            backward,
            mean_mm: 0.5 * (forward.mean_mm + backward.mean_mm),
            reversal_mm,
            repeatability_mm: together.max(forward.repeatability_mm).max(backward.repeatability_mm),
        }
    }
}

/// Width of the band from the lowest to the highest value; zero without values.
fn band(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let highest = values.clone().fold(f64::NEG_INFINITY, f64::max);
    let lowest = values.fold(f64::INFINITY, f64::min);
    (highest - lowest).max(0.0)
}

impl AxisPositioning {
    /// Evaluates all positions.
    pub fn new(positions: &[AxisPosition]) -> Self {
        let forward = || positions.iter().map(|p| p.forward);
        let backward = || positions.iter().map(|p| p.backward);
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let limits = |a: Approach| [a.mean_mm - 2.0 * a.estimator_mm, a.mean_mm + 2.0 * a.estimator_mm];
        Self {
            reversal_mm: largest(&mut positions.iter().map(|p| p.reversal_mm.abs())),
            mean_reversal_mm: mean(positions.iter().map(|p| p.reversal_mm)),
            repeatability: Directions {
                both_mm: largest(&mut positions.iter().map(|p| p.repeatability_mm)),
                forward_mm: largest(&mut forward().map(|a| a.repeatability_mm)),
                backward_mm: largest(&mut backward().map(|a| a.repeatability_mm)),
            },
            systematic: Directions {
                both_mm: band(forward().chain(backward()).map(|a| a.mean_mm)),
                forward_mm: band(forward().map(|a| a.mean_mm)),
                backward_mm: band(backward().map(|a| a.mean_mm)),
            },
            mean_systematic_mm: band(positions.iter().map(|p| p.mean_mm)),
            accuracy: Directions {
                both_mm: band(forward().chain(backward()).flat_map(limits)),
                forward_mm: band(forward().flat_map(limits)),
                backward_mm: band(backward().flat_map(limits)),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    /// Deviations (nm) of a stage measured at the Paul Scherrer Institute, and the quantities that
    /// its own program gives (ecmccfg, examples/test/fat_sat/report.md), rounded to 0.1 nm and
    /// 0.01 nm.
    #[test]
    fn a_measured_axis_has_the_quantities_that_another_program_states() {
        let forward = [
            [-81.02, -102.02, -87.02, -92.02, -100.02],
            [-87.02, -97.02, -97.02, -95.02, -82.02],
            [-72.02, -90.02, -88.02, -87.02, -87.02],
            [-102.02, -86.02, -86.02, -93.02, -78.02],
            [-100.02, -112.02, -129.02, -109.02, -97.02],
        ];
        let backward = [
            [-99.02, -94.02, -82.02, -91.02, -94.02],
            [-103.02, -104.02, -95.02, -111.02, -93.02],
            [-86.02, -102.02, -91.02, -76.02, -99.02],
            [-72.02, -92.02, -95.02, -103.02, -81.02],
            [-104.02, -126.02, -130.02, -141.02, -107.02],
        ];
        let approach = |runs: &[f64; 5]| Approach::new(&runs.map(|nm| nm * 1e-6)).unwrap();
        let positions: Vec<AxisPosition> = [-10.0, -4.88, 0.24, 5.36, 10.48]
            .into_iter()
            .zip(forward.iter().zip(&backward))
            .map(|(at, (up, down))| AxisPosition::new(at, approach(up), approach(down)))
            .collect();
        let close = |ours_mm: f64, nm: f64| assert!((ours_mm * 1e6 - nm).abs() < 0.0051, "{} {nm}", ours_mm * 1e6);
        let at = |i: usize| positions[i];
        for (i, [mean, reversal, up, down, both]) in [
            [-92.22, -0.4, 35.17, 25.14, 35.17],
            [-96.42, 9.6, 27.07, 29.18, 37.72],
            [-87.82, 6.0, 29.04, 41.70, 41.70],
            [-88.82, -0.4, 36.00, 48.71, 48.71],
            [-115.52, 12.2, 50.33, 62.90, 68.82],
        ]
        .into_iter()
        .enumerate()
        {
            close(at(i).mean_mm, mean);
            close(at(i).reversal_mm, reversal);
            close(at(i).forward.repeatability_mm, up);
            close(at(i).backward.repeatability_mm, down);
            close(at(i).repeatability_mm, both);
        }
        let axis = AxisPositioning::new(&positions);
        close(axis.reversal_mm, 12.2);
        close(axis.mean_reversal_mm, 5.4);
        close(axis.repeatability.forward_mm, 50.33);
        close(axis.repeatability.backward_mm, 62.90);
        close(axis.systematic.forward_mm, 24.6);
        close(axis.systematic.backward_mm, 33.0);
        close(axis.mean_systematic_mm, 27.7);
        close(axis.accuracy.forward_mm, 64.28);
        close(axis.accuracy.backward_mm, 88.81);
        // for bidirectional values that program takes one of the two directions; expected by
        // definition from its means and estimators:
        close(axis.repeatability.both_mm, 68.82); // R(5) of that program
        close(axis.systematic.both_mm, -84.82 + 121.62);
        // upper limit at position 5↓ is lower than at 3↓: −90.82 + 2 × 10.43; lower limit at 5↓:
        // −121.62 − 2 × 15.73
        assert!((axis.accuracy.both_mm * 1e6 - (-88.62 + 2.0 * 12.18 + 121.62 + 2.0 * 15.73)).abs() < 0.03);
        assert!(axis.accuracy.both_mm >= axis.accuracy.backward_mm && axis.systematic.both_mm >= 33.0e-6);
    }

    #[test]
    fn one_run_has_no_repeatability() {
        assert_eq!((Approach::new(&[1.0]), Approach::new(&[])), (None, None));
    }

    /// Five runs in both directions to five positions, which scatter by 1 µm.
    fn runs(change: impl Fn(f64, bool, usize) -> f64) -> Vec<Runs> {
        let mut noise = Noise::new(9, 0);
        let sides = (0..5).flat_map(|i| [true, false].map(|is_forward| (100.0 * f64::from(i), is_forward)));
        let approach = |(position_mm, is_forward): (f64, bool)| {
            let deviation = |run| noise.gaussian(0.001) + change(position_mm, is_forward, run);
            Runs { position_mm, is_forward, deviations_mm: (0..5).map(deviation).collect() }
        };
        sides.map(approach).collect()
    }

    #[test]
    fn a_run_far_from_the_others_is_named() {
        let wrong =
            |at: f64, is_forward: bool, run: usize| if (at, is_forward, run) == (200.0, false, 3) { 0.2 } else { 0.0 };
        let found = outlying_runs(&runs(wrong));
        let [OutlyingRun { position_mm, is_forward, run, distance_mm, median_mm }] = found[..] else {
            panic!("{found:?}")
        };
        assert_eq!((position_mm, is_forward, run), (200.0, false, 4));
        assert!((distance_mm - 0.2).abs() < 0.005 && median_mm < 0.003, "{distance_mm} {median_mm}");
        // scatter, an axis that expands from run to run, and too few runs to tell
        assert_eq!(outlying_runs(&runs(|_, _, _| 0.0)), []);
        assert_eq!(outlying_runs(&runs(|at, _, run| 1e-4 * at * run as f64)), []);
        let two = runs(wrong).into_iter().map(|r| Runs { deviations_mm: r.deviations_mm[2..4].to_vec(), ..r });
        assert_eq!(outlying_runs(&two.collect::<Vec<_>>()), []);
    }

    #[test]
    fn runs_that_a_table_contains_twice_are_told_from_equal_runs() {
        let once = runs(|_, _, _| 0.0);
        assert_eq!(repeated_runs(&once), None);
        let times = |count: usize| -> Vec<Runs> {
            once.iter().map(|r| Runs { deviations_mm: r.deviations_mm.repeat(count), ..r.clone() }).collect()
        };
        assert_eq!((repeated_runs(&times(2)), repeated_runs(&times(3))), (Some(2), Some(3)));
        // one run more
        let mut more = times(2);
        more[0].deviations_mm.push(0.0);
        assert_eq!(repeated_runs(&more), None);
        // an axis without scatter, as in a simulation
        let still: Vec<Runs> = once.iter().map(|r| Runs { deviations_mm: vec![0.01; 6], ..r.clone() }).collect();
        assert_eq!((repeated_runs(&still), repeated_runs(&[])), (None, None));
    }
}
