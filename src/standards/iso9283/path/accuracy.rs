//! Path accuracy AT (ISO 9283:1998 8.2, unverified against a bought copy), also on reorientation
//! (8.4): largest distance of the mean attained path from the commanded path, in the normal planes
//! of the command points.

use crate::iso9283::path::commanded::{CommandPoint, CommandedPath};
use crate::iso9283::path::passes::{Pass, angles_at, check, positions_at};
use crate::iso9283::pose::accuracy::angle_accuracy_rad;
use crate::iso9283::statistics::sample::mean_position;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};

/// Path accuracy AT.
#[derive(Clone, Debug, PartialEq)]
pub struct PathAccuracy {
    /// AT_p.
    pub at_mm: f64,
    /// Command point of the largest distance.
    pub worst: usize,
    /// Mean attained position at each command point.
    pub means_mm: Vec<Vector>,
    /// Distance of each mean position from its command point.
    pub deviations_mm: Vec<f64>,
}

/// AT_p of at least one pass.
pub fn path_accuracy(passes: &[Pass], points: &[CommandPoint]) -> Result<PathAccuracy> {
    check(passes, points, 1, "path-accuracy")?;
    let means_mm: Vec<Vector> = (0..points.len()).map(|i| mean_position(&positions_at(passes, i))).collect();
    let deviations_mm: Vec<f64> = means_mm.iter().zip(points).map(|(m, p)| norm(minus(*m, p.position_mm))).collect();
    let (worst, at_mm) = largest(&deviations_mm);
    Ok(PathAccuracy { at_mm, worst, means_mm, deviations_mm })
}

/// AT_a, AT_b or AT_c (rad): largest absolute difference of mean and commanded angle number
/// `angle`; NaN if it was not measured.
pub fn path_angle_accuracy_rad(passes: &[Pass], points: &[CommandPoint], angle: usize) -> f64 {
    let deviation = |(i, point): (usize, &CommandPoint)| {
        let commanded = point.angles_rad.get(angle).copied().unwrap_or(f64::NAN);
        angle_accuracy_rad(&angles_at(passes, i, angle), commanded).abs()
    };
    points.iter().enumerate().map(deviation).fold(f64::NAN, f64::max)
}

/// AT_p on reorientation (8.4): AT_p of a path with changing commanded angles, by the same formula.
pub fn path_accuracy_on_reorientation(
    passes: &[Pass],
    points: &[CommandPoint],
    path: &CommandedPath,
) -> Result<PathAccuracy> {
    if !path.turned_rad().iter().any(|turned| *turned > 0.0) {
        return Err(error!("path-without-reorientation").into());
    }
    path_accuracy(passes, points)
}

/// Index and value of the first largest value.
pub(crate) fn largest(values: &[f64]) -> (usize, f64) {
    let larger = |a: (usize, f64), (i, v): (usize, &f64)| if *v > a.1 { (i, *v) } else { a };
    values.iter().enumerate().fold((0, 0.0), larger)
}
