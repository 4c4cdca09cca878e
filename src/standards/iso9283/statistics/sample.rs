//! Means and standard deviations that are exact for equal values, and angles without jumps.

use etalon_base::angle::Turn;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, phrase};

/// Rejects fewer than `least` positions, and non-finite positions.
pub(crate) fn positions(points: &[Vector], least: usize, characteristic: &str) -> Result<()> {
    if points.len() < least {
        return Err(error!(
            "too-few-positions",
            of = phrase!("characteristic", name = characteristic),
            count = points.len(),
            least
        )
        .into());
    }
    match points.iter().position(|&p| !norm(p).is_finite()) {
        Some(i) => {
            let of = phrase!("characteristic", name = characteristic);
            Err(error!("position-not-finite", of, number = i + 1).into())
        }
        None => Ok(()),
    }
}

/// Mean and standard deviation of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampleSpread {
    /// Mean; NaN without values.
    pub mean: f64,
    /// Standard deviation with n − 1; NaN with fewer than two values.
    pub deviation: f64,
}

/// Mean and standard deviation, computed relative to the first value.
pub fn spread(values: &[f64]) -> SampleSpread {
    let n = values.len() as f64;
    let first = values.first().copied().unwrap_or(f64::NAN);
    let mean = first + values.iter().map(|v| v - first).sum::<f64>() / n;
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    let deviation = if values.len() < 2 { f64::NAN } else { (squares / (n - 1.0)).sqrt() };
    SampleSpread { mean, deviation }
}

/// Existing coordinates: x, y and, in space, z.
pub(crate) fn coordinates(p: Vector, spatial: bool) -> Vec<f64> {
    p[..if spatial { 3 } else { 2 }].to_vec()
}

/// Mean position, computed relative to the first position; NaN without positions.
pub(crate) fn mean_position(points: &[Vector]) -> Vector {
    [0, 1, 2].map(|k| spread(&points.iter().map(|p| p[k]).collect::<Vec<_>>()).mean)
}

/// Covariance of positions with n − 1 (mm²).
pub(crate) fn covariance(points: &[Vector]) -> [[f64; 3]; 3] {
    let mean = mean_position(points);
    let mut sum = [[0.0; 3]; 3];
    for p in points {
        let d = minus(*p, mean);
        for (row, a) in sum.iter_mut().zip(d) {
            row.iter_mut().zip(d).for_each(|(s, b)| *s += a * b);
        }
    }
    sum.map(|row| row.map(|s| s / (points.len() as f64 - 1.0)))
}

/// Wraps an angle or a difference of angles to −π to π.
pub fn wrapped(angle_rad: f64) -> f64 {
    Turn::RADIANS.difference(angle_rad, 0.0)
}

/// Angles of one pose without jumps of 2π: each is within half a turn of the first.
pub fn unwrapped(angles_rad: &[f64]) -> Vec<f64> {
    Turn::RADIANS.about_first(angles_rad)
}

/// Angles along a motion without jumps of 2π: each is within half a turn of the previous one.
pub(crate) fn followed(angles_rad: &[f64]) -> Vec<f64> {
    Turn::RADIANS.followed(angles_rad)
}
