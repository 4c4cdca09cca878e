//! Intervals of AP and RP by parametric bootstrap: tests with the same number of cycles are drawn
//! with the observed scatter.
//!
//! The draws come from a given seed and are shared by all poses of a test, so that equal data give
//! equal intervals.

use crate::iso9283::pose::accuracy::PoseAccuracy;
use crate::iso9283::pose::repeatability::PoseRepeatability;
use crate::iso9283::statistics::interval::{Interval, TAIL};
use crate::iso9283::statistics::sample::{mean_position, spread};
use crate::iso9283::statistics::scatter::{FARTHEST, Scatter};
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::pose::{Vector, minus};

/// Simulated tests of unit scatter.
#[derive(Clone, Debug)]
pub struct Bootstrap {
    cycles: usize,
    /// Squared coordinates of all draws about the true mean.
    squares: Vec<Vector>,
    /// Squared coordinates about the mean of their test, `cycles` per test.
    centred: Vec<Vector>,
    /// Mean over standard deviation of each test along each coordinate: error of a mean in units of
    /// the observed scatter.
    students: Vec<Vector>,
}

/// Stream of the generator; each purpose has a stream of its own.
const STREAM: u64 = 9283;

impl Bootstrap {
    /// Draws `draws` simulated tests of `cycles` cycles (at least 3) from `seed`.
    pub fn new(cycles: usize, draws: usize, seed: u64) -> Result<Self> {
        crate::iso9283::statistics::sample::positions(&vec![[0.0; 3]; cycles], 3, "bootstrap")?;
        let mut noise = Noise::new(seed, STREAM);
        let mut all = Self { cycles, squares: Vec::new(), centred: Vec::new(), students: Vec::new() };
        let squared = |p: Vector| p.map(|x| x * x);
        for _ in 0..draws {
            let test: Vec<Vector> = (0..cycles).map(|_| [(); 3].map(|()| noise.gaussian(1.0))).collect();
            let mean = mean_position(&test);
            all.squares.extend(test.iter().map(|p| squared(*p)));
            all.centred.extend(test.iter().map(|p| squared(minus(*p, mean))));
            let deviation = |k: usize| spread(&test.iter().map(|p| p[k]).collect::<Vec<_>>()).deviation;
            all.students.push([0, 1, 2].map(|k| mean[k] / deviation(k)));
        }
        Ok(all)
    }

    /// 95 % interval of RP. The ratio of drawn to true RP hardly depends on the scatter, and is
    /// inverted.
    pub fn repeatability(&self, attained_mm: &[Vector], found: &PoseRepeatability) -> Result<Interval> {
        crate::iso9283::statistics::sample::positions(attained_mm, self.cycles, "bootstrap")?;
        let variances = Scatter::new(attained_mm).drawn_together;
        let truth = mean_and_three_deviations(&self.squares, variances);
        if truth.is_nan() || truth <= 0.0 {
            return Ok(Interval { low_mm: found.rp_mm, high_mm: found.rp_mm });
        }
        let tests = self.centred.chunks_exact(self.cycles);
        let mut ratios: Vec<f64> = tests.map(|test| mean_and_three_deviations(test, variances) / truth).collect();
        let mut end = |share: f64| found.rp_mm / quantile(&mut ratios, share);
        Ok(Interval { low_mm: end(1.0 - TAIL), high_mm: end(TAIL) })
    }

    /// 95 % interval of AP: accuracies for which the observed AP is at either end of the draws. The
    /// interval contains zero if chance alone explains the deviation of the mean.
    pub fn accuracy(&self, attained_mm: &[Vector], found: &PoseAccuracy) -> Result<Interval> {
        crate::iso9283::statistics::sample::positions(attained_mm, self.cycles, "bootstrap")?;
        let scatter = Scatter::new(attained_mm);
        let mean = scatter.along(found.deviation_mm);
        let sigma = scatter.found.map(f64::sqrt);
        let errors: Vec<Vector> = self.students.iter().map(|t| [0, 1, 2].map(|k| t[k] * sigma[k])).collect();
        let found_squared = found.ap_mm * found.ap_mm;
        // share of the draws beyond the observed value for this true position
        let beyond = |truth: Vector| {
            let beyond = |e: &&Vector| square([truth[0] + e[0], truth[1] + e[1], truth[2] + e[2]]) > found_squared;
            errors.iter().filter(beyond).count() as f64 / errors.len() as f64
        };
        let end = |share: f64| {
            let (mut near, mut far) = (FARTHEST, -FARTHEST);
            // to one millionth; the draws resolve less
            for _ in 0..26 {
                let middle = 0.5 * (near + far);
                if beyond(scatter.plausible(mean, middle)) > share { far = middle } else { near = middle }
            }
            square(scatter.plausible(mean, 0.5 * (near + far))).sqrt()
        };
        let (low_mm, high_mm) = (end(TAIL), end(1.0 - TAIL));
        // the remainder at the end of the search is rounding
        Ok(Interval { low_mm: if low_mm < 1e-9 * found.ap_mm { 0.0 } else { low_mm }, high_mm })
    }
}

/// Mean + 3 s of radii, from squared coordinates of unit scatter.
fn mean_and_three_deviations(squares: &[Vector], v: Vector) -> f64 {
    let n = squares.len() as f64;
    let (mut sum, mut sum_of_squares) = (0.0, 0.0);
    for p in squares {
        let square = p[0] * v[0] + p[1] * v[1] + p[2] * v[2];
        sum += square.sqrt();
        sum_of_squares += square;
    }
    sum / n + 3.0 * ((sum_of_squares - sum * sum / n).max(0.0) / (n - 1.0)).sqrt()
}

fn square(d: Vector) -> f64 {
    d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
}

/// Nearest order statistic; NaN without values.
pub(crate) fn quantile(values: &mut [f64], share: f64) -> f64 {
    let rank = (share * (values.len() as f64 - 1.0)).round() as usize;
    if rank < values.len() { *values.select_nth_unstable_by(rank, f64::total_cmp).1 } else { f64::NAN }
}
