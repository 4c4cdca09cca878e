//! Error motions that noise alone gives: a perfect axis has these too.

use super::{Sweep, SweepFit};
use etalon_base::noise::Noise;
use etalon_base::pose::{Vector, cross};
use nalgebra::{DMatrix, Matrix2};
use statrs::distribution::{ContinuousCDF, Normal};

/// Value that noise alone gives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ByNoise {
    /// Expected value.
    pub expected: f64,
    /// Standard deviation: standard uncertainty of the measured value by noise.
    pub deviation: f64,
}

impl ByNoise {
    fn new(values: &[f64], scale: f64) -> Self {
        let count = values.len().max(1) as f64;
        let mean = values.iter().sum::<f64>() / count;
        let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / count;
        Self { expected: scale * mean, deviation: scale * variance.sqrt() }
    }
}

/// Error motions that noise alone gives, in the units of [`super::ErrorMotion`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NoiseMotion {
    /// Radial and face error motion of each path (mm): residuals have equal noise in both.
    pub paths: Vec<ByNoise>,
    /// Axial error motion (mm).
    pub axial: Option<ByNoise>,
    /// Tilt error motion (rad).
    pub tilt: Option<ByNoise>,
}

/// Steps of each of the two integrals over the largest and the smallest value.
const GRID: usize = 64;
/// Number of draws of the largest tilt.
const DRAWS: usize = 300;
/// Maximum number of steps of a drawn sweep: the largest of more values hardly differs.
const MOST_STEPS: usize = 500;

/// Range of n standard normal values (David and Nagaraja, Order statistics, 2.3): the largest of n
/// uniform values is v^(1/n), and the smallest of the others follows in the same way.
pub(super) fn range_of_normal(n: usize, scale: f64) -> ByNoise {
    let Ok(normal) = Normal::new(0.0, 1.0) else { return ByNoise::default() };
    if n < 2 {
        return ByNoise::default();
    }
    let at = |k: usize| (k as f64 + 0.5) / GRID as f64;
    let mut ranges = Vec::with_capacity(GRID * GRID);
    for k in 0..GRID {
        let above = -(at(k).ln() / n as f64).exp_m1();
        let largest = -normal.inverse_cdf(above);
        for l in 0..GRID {
            let smallest = (1.0 - above) * -(at(l).ln() / (n - 1) as f64).exp_m1();
            ranges.push(largest - normal.inverse_cdf(smallest));
        }
    }
    ByNoise::new(&ranges, scale)
}

/// Covariance of the translation along the axis and of the tilt, for unit noise of each coordinate
/// of a rigid body of points (axis along z at the origin).
fn rigid_body_covariance(points: &[Vector]) -> Option<(f64, Matrix2<f64>)> {
    let mut jacobian = DMatrix::zeros(3 * points.len(), 6);
    for (i, p) in points.iter().enumerate() {
        for k in 0..3 {
            let unit: Vector = std::array::from_fn(|j| f64::from(u8::from(j == k)));
            let turned = cross(unit, *p);
            for j in 0..3 {
                jacobian[(3 * i + j, k)] = unit[j];
                jacobian[(3 * i + j, 3 + k)] = turned[j];
            }
        }
    }
    let covariance = (jacobian.transpose() * jacobian).try_inverse()?;
    let tilt = Matrix2::from_fn(|i, j| covariance[(3 + i, 3 + j)]);
    Some((covariance[(2, 2)].max(0.0), tilt))
}

/// Largest of n tilts about their mean.
fn largest_tilt(n: usize, covariance: Matrix2<f64>, scale: f64) -> Option<ByNoise> {
    let root = covariance.cholesky()?.l();
    let steps = n.min(MOST_STEPS);
    let mut noise = Noise::new(0, 0);
    let draw = |_| {
        let all: Vec<[f64; 2]> = (0..steps)
            .map(|_| {
                let (a, b) = (noise.gaussian(1.0), noise.gaussian(1.0));
                [root[(0, 0)] * a, root[(1, 0)] * a + root[(1, 1)] * b]
            })
            .collect();
        let mean = [0, 1].map(|k| all.iter().map(|t| t[k]).sum::<f64>() / steps as f64);
        all.iter().map(|t| (t[0] - mean[0]).hypot(t[1] - mean[1])).fold(0.0, f64::max)
    };
    Some(ByNoise::new(&(0..DRAWS).map(draw).collect::<Vec<_>>(), scale))
}

/// Error motions by noise of `u_mm` of a coordinate; `body` is the rigid body of the targets and
/// the number of its steps.
pub(super) fn noise_motion(sweep: &Sweep, fit: &SweepFit, body: Option<(&[Vector], usize)>, u_mm: f64) -> NoiseMotion {
    let used = sweep.readings.iter().zip(&fit.used).filter(|(_, used)| **used).count().max(1);
    // the fit absorbs a part of the noise
    let left = (fit.degrees_of_freedom as f64 / (2 * used) as f64).sqrt();
    let paths = fit.paths.iter().map(|path| range_of_normal(path.readings, u_mm * left)).collect();
    let of_axis = body.and_then(|(points, steps)| Some((rigid_body_covariance(points)?, steps)));
    NoiseMotion {
        paths,
        axial: of_axis.map(|((variance, _), steps)| range_of_normal(steps, u_mm * variance.sqrt())),
        tilt: of_axis.and_then(|((_, covariance), steps)| largest_tilt(steps, covariance, u_mm)),
    }
}
