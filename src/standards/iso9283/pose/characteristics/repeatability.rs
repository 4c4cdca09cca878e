//! Pose repeatability RP (ISO 9283:1998 7.2.2; thesis eq. 1.1 to 1.8), and the smallest ball that
//! encloses all positions.

use crate::iso9283::statistics::sample::{mean_position, spread, unwrapped};
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};
use etalon_fit::{enclosing_circle, enclosing_sphere};

/// Repeatability of the positions about their mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseRepeatability {
    /// RP_l: mean radius plus three standard deviations of the radius.
    pub rp_mm: f64,
    /// Mean distance from the barycentre.
    pub mean_radius_mm: f64,
    /// Standard deviation of the distance from the barycentre, with n − 1.
    pub sd_radius_mm: f64,
    /// RP_x, RP_y, RP_z: three standard deviations of each coordinate.
    pub axis_mm: Vector,
    /// RP of the projections onto the xy plane.
    pub plane_mm: f64,
    /// RP of each coordinate alone (thesis, table 2.1).
    pub along_mm: Vector,
    /// Radius of the smallest sphere that encloses all positions.
    pub enclosing_radius_mm: f64,
    /// Radius of the smallest circle that encloses the projections onto the xy plane.
    pub enclosing_circle_radius_mm: f64,
}

/// Evaluates repeatability of position from at least two attained positions.
///
/// # Examples
///
/// ```
/// use etalon_standards::iso9283::pose::repeatability::pose_repeatability;
///
/// // radii of 3, 1, 1 and 3 µm: mean 2 µm, standard deviation √(4/3) µm
/// let attained_mm = [-0.003, -0.001, 0.001, 0.003].map(|x| [x, 0.0, 0.0]);
/// let repeatability = pose_repeatability(&attained_mm)?;
/// assert!((repeatability.mean_radius_mm - 0.002).abs() < 1e-12);
/// assert!((repeatability.rp_mm - 0.001 * (2.0 + 3.0 * (4.0f64 / 3.0).sqrt())).abs() < 1e-12);
/// # Ok::<(), etalon_base::message::Problems>(())
/// ```
pub fn pose_repeatability(attained_mm: &[Vector]) -> Result<PoseRepeatability> {
    crate::iso9283::statistics::sample::positions(attained_mm, 2, "pose-repeatability")?;
    let radius = spread(&radii_mm(attained_mm, &[0, 1, 2]));
    let closeness = |axes: &[usize]| {
        let radius = spread(&radii_mm(attained_mm, axes));
        radius.mean + 3.0 * radius.deviation
    };
    let plane: Vec<[f64; 2]> = attained_mm.iter().map(|p| [p[0], p[1]]).collect();
    Ok(PoseRepeatability {
        rp_mm: closeness(&[0, 1, 2]),
        mean_radius_mm: radius.mean,
        sd_radius_mm: radius.deviation,
        plane_mm: closeness(&[0, 1]),
        along_mm: [0, 1, 2].map(|k| closeness(&[k])),
        axis_mm: [0, 1, 2].map(|k| 3.0 * spread(&attained_mm.iter().map(|p| p[k]).collect::<Vec<_>>()).deviation),
        enclosing_radius_mm: enclosing_sphere(attained_mm)?.radius_mm,
        enclosing_circle_radius_mm: enclosing_circle(&plane)?.radius_mm,
    })
}

/// Distances l_j of the attained positions from their barycentre, in these coordinates (thesis eq.
/// 2.10).
pub(crate) fn radii_mm(attained_mm: &[Vector], axes: &[usize]) -> Vec<f64> {
    let mean = mean_position(attained_mm);
    let along = |d: Vector| [0, 1, 2].map(|k| if axes.contains(&k) { d[k] } else { 0.0 });
    attained_mm.iter().map(|p| norm(along(minus(*p, mean)))).collect()
}

/// RP_a, RP_b or RP_c (rad): three standard deviations; NaN with fewer than two angles.
pub fn angle_repeatability_rad(attained_rad: &[f64]) -> f64 {
    3.0 * spread(&unwrapped(attained_rad)).deviation
}
