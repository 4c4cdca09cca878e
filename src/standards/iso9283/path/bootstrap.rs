//! Intervals of AT and RT (not in the standard) by parametric bootstrap over whole passes, which
//! preserves the correlation of neighbouring command points.
//!
//! AT and RT are maxima over the path, and the maximum of many scattered values is biased upwards:
//! for ten passes with uniform scatter along the path, RT is 20 to 40 % above the RT of infinitely
//! many passes. Intervals for single points ignore this bias. Here, tests with the same number of
//! passes are drawn, their maxima are evaluated in the same way, and the relation is inverted. RT
//! may therefore lie above its own interval. No closed form is known that applies to all kinds of
//! paths.

use crate::iso9283::path::accuracy::PathAccuracy;
use crate::iso9283::path::commanded::CommandPoint;
use crate::iso9283::path::passes::{Pass, check, positions_at};
use crate::iso9283::path::repeatability::PathRepeatability;
use crate::iso9283::pose::noise_free::repeatability_of_scatter;
use crate::iso9283::statistics::bootstrap::quantile;
use crate::iso9283::statistics::interval::{Interval, TAIL};
use crate::iso9283::statistics::sample::{covariance, mean_position, spread};
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::pose::{Vector, minus, norm};
use etalon_math::statistics::mean;
use etalon_math::symmetric_eigen;

/// Simulated tests from a given seed.
#[derive(Clone, Copy, Debug)]
pub struct PathBootstrap {
    /// Number of draws.
    pub draws: usize,
    /// Seed of the generator.
    pub seed: u64,
}

/// Stream of the generator; each purpose has a stream of its own.
const STREAM: u64 = 8283;
/// Maximum number of command points, evenly chosen and including the worst; neighbouring points are
/// similar.
const POINTS: usize = 100;

/// Tail probability for AT at either end; with 2.5 %, the intervals of simulated tests of ten
/// passes contain the truth in 93 % instead of 95 %.
const AT_TAIL: f64 = 0.018;
/// Tail probability at the lower end for RT. With few passes, neighbouring points look more similar
/// than they are, which hides a part of the bias; with 2.5 %, the intervals of simulated tests are
/// above the truth in up to 11 %.
const RT_LOW_TAIL: f64 = 0.01;

impl PathBootstrap {
    /// 95 % interval of AT_p from at least three passes: the common factors of the mean path's
    /// deviation at which the observed AT_p is at either end of the draws. The errors follow
    /// Student's distribution, with the shape of the scatter of the passes.
    pub fn accuracy(&self, passes: &[Pass], points: &[CommandPoint], found: &PathAccuracy) -> Result<Interval> {
        check(passes, points, 3, "path-accuracy-interval")?;
        let chosen = chosen(points.len(), found.worst);
        let deviations: Vec<Vector> = chosen.iter().map(|&i| minus(found.means_mm[i], points[i].position_mm)).collect();
        let rests = rests(passes, &chosen);
        let mut noise = Noise::new(self.seed, STREAM);
        let n = passes.len();
        let mut error = || {
            let weights: Vec<f64> = (0..n).map(|_| noise.gaussian(1.0)).collect();
            let chi_square: f64 = (1..n).map(|_| noise.gaussian(1.0).powi(2)).sum();
            combined(&rests, &weights, 1.0 / (n as f64 * chi_square).sqrt())
        };
        let errors: Vec<Vec<Vector>> = (0..self.draws).map(|_| error()).collect();
        // share of the draws beyond the observed value if the mean path deviates by `factor` times
        // its deviation
        let beyond = |factor: f64| {
            let goes = |e: &&Vec<Vector>| {
                let mut both = e.iter().zip(&deviations);
                both.any(|(e, d)| norm([0, 1, 2].map(|k| factor * d[k] + e[k])) > found.at_mm)
            };
            errors.iter().filter(goes).count() as f64 / errors.len() as f64
        };
        let end = |share: f64| {
            let (mut near, mut far) = (0.0, 1.0);
            // multiples of a zero deviation never grow
            for _ in 0..60 {
                if beyond(far) > share {
                    break;
                }
                (near, far) = (far, 2.0 * far);
            }
            for _ in 0..40 {
                let middle = 0.5 * (near + far);
                if beyond(middle) > share { far = middle } else { near = middle }
            }
            near * found.at_mm
        };
        if found.at_mm == 0.0 {
            return Ok(Interval { low_mm: 0.0, high_mm: 0.0 });
        }
        let low_mm = if beyond(0.0) > AT_TAIL { 0.0 } else { end(AT_TAIL) };
        Ok(Interval { low_mm, high_mm: end(1.0 - AT_TAIL) })
    }

    /// 95 % interval of RT_p from at least three passes. The scatter of a sample varies more along
    /// the path than the true scatter, and few passes do not show by how much. For the lower end
    /// the scatters are therefore shrunk towards their mean, for the upper end they are used as
    /// observed.
    pub fn repeatability(
        &self,
        passes: &[Pass],
        points: &[CommandPoint],
        found: &PathRepeatability,
    ) -> Result<Interval> {
        check(passes, points, 3, "path-repeatability-interval")?;
        let chosen = chosen(points.len(), found.worst);
        let rests = rests(passes, &chosen);
        let n = passes.len();
        let expected = |i: usize| {
            let at: Vec<Vector> = rests.iter().map(|pass| pass[i]).collect();
            repeatability_of_scatter(symmetric_eigen(covariance(&at)).0.map(|v| v.max(0.0)))
        };
        let expected: Vec<f64> = (0..chosen.len()).map(expected).collect();
        let there: Vec<usize> = (0..chosen.len()).filter(|&i| expected[i] > 0.0).collect();
        if there.is_empty() {
            return Ok(Interval { low_mm: found.rt_mm, high_mm: found.rt_mm });
        }
        let mut noise = Noise::new(self.seed, STREAM + 1);
        let mut drawn = || -> Vec<f64> {
            let mut pass = || {
                let weights: Vec<f64> = (0..n).map(|_| noise.gaussian(1.0)).collect();
                combined(&rests, &weights, 1.0 / (n as f64 - 1.0).sqrt())
            };
            let passes: Vec<Vec<Vector>> = (0..n).map(|_| pass()).collect();
            there.iter().map(|&i| mean_and_three_deviations(&passes, i) / expected[i]).collect()
        };
        let ratios: Vec<Vec<f64>> = (0..self.draws).map(|_| drawn()).collect();
        // variation of the scatters by chance alone, and observed variation
        let apart = |values: &[f64]| spread(&values.iter().map(|v| v.ln()).collect::<Vec<_>>()).deviation.powi(2);
        let by_chance = mean(ratios.iter().map(|r| apart(r)));
        let all = apart(&there.iter().map(|&i| found.points_mm[chosen[i]]).collect::<Vec<_>>());
        let share = (1.0 - by_chance / all).max(0.0).sqrt();
        let logs: Vec<f64> = there.iter().map(|&i| expected[i].ln()).collect();
        let mean = spread(&logs).mean;
        // a single point cannot be shrunk
        let share = if share.is_finite() { share } else { 1.0 };
        let truth: Vec<f64> = logs.iter().map(|l| (mean + share * (l - mean)).exp()).collect();
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let as_found: Vec<f64> = there.iter().map(|&i| expected[i]).collect();
        let quantile_of = |truth: &[f64], share: f64| {
            let rt = largest(&mut truth.iter().copied());
            let ratio = |r: &Vec<f64>| largest(&mut r.iter().zip(truth).map(|(r, t)| r * t)) / rt;
            quantile(&mut ratios.iter().map(ratio).collect::<Vec<_>>(), share)
        };
        let low_mm = found.rt_mm / quantile_of(&truth, 1.0 - RT_LOW_TAIL);
        let high_mm = found.rt_mm / quantile_of(&as_found, TAIL);
        Ok(Interval { low_mm, high_mm: high_mm.max(low_mm) })
    }
}

/// Indices of the evaluated command points.
fn chosen(count: usize, worst: usize) -> Vec<usize> {
    let stride = count.div_ceil(POINTS).max(1);
    (0..count).filter(|i| i.is_multiple_of(stride) || *i == worst).collect()
}

/// Deviations of each pass from the mean pass, at the chosen points.
fn rests(passes: &[Pass], chosen: &[usize]) -> Vec<Vec<Vector>> {
    let means: Vec<Vector> = chosen.iter().map(|&i| mean_position(&positions_at(passes, i))).collect();
    let rest =
        |pass: &Pass| chosen.iter().zip(&means).map(|(&i, mean)| minus(pass.crossings[i].position_mm, *mean)).collect();
    passes.iter().map(rest).collect()
}

/// Weighted sum of all deviations, times `scale`.
fn combined(rests: &[Vec<Vector>], weights: &[f64], scale: f64) -> Vec<Vector> {
    let mut sum = vec![[0.0; 3]; rests.first().map_or(0, Vec::len)];
    for (rest, weight) in rests.iter().zip(weights) {
        let weight = scale * weight;
        for (s, r) in sum.iter_mut().zip(rest) {
            (0..3).for_each(|k| s[k] += weight * r[k]);
        }
    }
    sum
}

/// Mean + 3 s of the radii of drawn passes at one point.
fn mean_and_three_deviations(passes: &[Vec<Vector>], point: usize) -> f64 {
    let n = passes.len() as f64;
    let mut mean = [0.0; 3];
    for pass in passes {
        (0..3).for_each(|k| mean[k] += pass[point][k] / n);
    }
    let (mut sum, mut squares) = (0.0, 0.0);
    for pass in passes {
        let radius = norm(minus(pass[point], mean));
        (sum, squares) = (sum + radius, squares + radius * radius);
    }
    sum / n + 3.0 * ((squares - sum * sum / n).max(0.0) / (n - 1.0)).sqrt()
}
