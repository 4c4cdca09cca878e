//! Path repeatability RT (ISO 9283:1998 8.3, unverified against a bought copy): largest mean radius
//! plus three standard deviations of the passes about their mean, in the normal planes of the
//! command points.

use crate::iso9283::path::accuracy::largest;
use crate::iso9283::path::commanded::CommandPoint;
use crate::iso9283::path::passes::{Pass, angles_at, check, positions_at};
use crate::iso9283::pose::repeatability::{angle_repeatability_rad, radii_mm};
use crate::iso9283::statistics::sample::spread;
use etalon_base::message::Result;

/// Path repeatability RT.
#[derive(Clone, Debug, PartialEq)]
pub struct PathRepeatability {
    /// RT_p.
    pub rt_mm: f64,
    /// Command point of the largest value.
    pub worst: usize,
    /// Mean radius plus three standard deviations at each command point.
    pub points_mm: Vec<f64>,
}

/// RT_p of at least two passes.
pub fn path_repeatability(passes: &[Pass], points: &[CommandPoint]) -> Result<PathRepeatability> {
    check(passes, points, 2, "path-repeatability")?;
    let at = |i: usize| {
        let radius = spread(&radii_mm(&positions_at(passes, i), &[0, 1, 2]));
        radius.mean + 3.0 * radius.deviation
    };
    let points_mm: Vec<f64> = (0..points.len()).map(at).collect();
    let (worst, rt_mm) = largest(&points_mm);
    Ok(PathRepeatability { rt_mm, worst, points_mm })
}

/// RT_a, RT_b or RT_c (rad): largest three standard deviations of angle number `angle`; NaN if it
/// was not measured.
pub fn path_angle_repeatability_rad(passes: &[Pass], points: &[CommandPoint], angle: usize) -> f64 {
    let at = |i: usize| angle_repeatability_rad(&angles_at(passes, i, angle));
    (0..points.len()).map(at).fold(f64::NAN, f64::max)
}
