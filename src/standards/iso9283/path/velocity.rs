//! Path velocity accuracy AV, repeatability RV and fluctuation FV (ISO 9283:1998 8.6, unverified
//! against a bought copy), in the central part of the path without acceleration.

use crate::iso9283::path::commanded::CommandPoint;
use crate::iso9283::path::passes::{Pass, check};
use crate::iso9283::statistics::sample::spread;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{minus, norm};

/// Path velocity characteristics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathVelocity {
    /// Commanded velocity.
    pub commanded_mm_s: f64,
    /// Mean velocity: mean over the passes of the mean velocity of each pass.
    pub mean_mm_s: f64,
    /// AV: mean minus commanded velocity (% of the commanded velocity).
    pub av_percent: f64,
    /// RV: three standard deviations of the mean velocities of the passes (% of the commanded
    /// velocity); NaN with a single pass.
    pub rv_percent: f64,
    /// FV: largest difference between two velocities within one pass, including the instrument's
    /// noise.
    pub fv_mm_s: f64,
}

/// Evaluates velocities between neighbouring command points in the central `share` of the path (0
/// to 1), which contains at least two points. Intervals across a corner, where command points are
/// omitted, do not count.
pub fn path_velocity(
    passes: &[Pass],
    points: &[CommandPoint],
    commanded_mm_s: f64,
    share: f64,
) -> Result<PathVelocity> {
    check(passes, points, 1, "path-velocity")?;
    if !(commanded_mm_s > 0.0 && commanded_mm_s.is_finite()) {
        return Err(error!("velocity-not-positive").into());
    }
    let (from, to) = central(points, share);
    let part_mm = (1..points.len()).map(|i| points[i].along_mm - points[i - 1].along_mm).fold(f64::INFINITY, f64::min);
    let neighbours = |i: usize| points[i + 1].along_mm - points[i].along_mm < 1.5 * part_mm;
    if (from..to).filter(|&i| neighbours(i)).count() < 2 {
        return Err(error!("velocity-too-few-points").into());
    }
    let velocities = |pass: &Pass| -> Vec<f64> {
        let pairs = (from..to).filter(|&i| neighbours(i)).map(|i| (&pass.crossings[i], &pass.crossings[i + 1]));
        pairs.map(|(a, b)| norm(minus(b.position_mm, a.position_mm)) / (b.time_s - a.time_s)).collect()
    };
    let all: Vec<Vec<f64>> = passes.iter().map(velocities).collect();
    let means = spread(&all.iter().map(|v| spread(v).mean).collect::<Vec<_>>());
    let fluctuation = |v: &Vec<f64>| {
        let (low, high) = v.iter().fold((f64::MAX, f64::MIN), |(l, h), &v| (l.min(v), h.max(v)));
        high - low
    };
    Ok(PathVelocity {
        commanded_mm_s,
        mean_mm_s: means.mean,
        av_percent: (means.mean - commanded_mm_s) / commanded_mm_s * 100.0,
        rv_percent: 3.0 * means.deviation / commanded_mm_s * 100.0,
        fv_mm_s: all.iter().map(fluctuation).fold(0.0, f64::max),
    })
}

/// First and last command point of the central share of the path.
pub fn central(points: &[CommandPoint], share: f64) -> (usize, usize) {
    // command points are the midpoints of equal parts, so the first is as far from the start as the
    // last from the end, unless a leg is shorter than a part
    let length = points[0].along_mm + points[points.len() - 1].along_mm;
    let edge = 0.5 * (1.0 - share) * length - 1e-9 * length;
    let inside = |p: &CommandPoint| p.along_mm >= edge && p.along_mm <= length - edge;
    let first = points.iter().position(inside).unwrap_or_default();
    (first, points.iter().rposition(inside).unwrap_or_default())
}
