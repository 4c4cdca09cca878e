//! Coplanarity of mean positions (thesis, 2.4): the barycentres of a planar robot should lie in one
//! plane.

use crate::iso9283::pose::test::PoseTest;
use crate::iso9283::statistics::sample::mean_position;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, cross, dot, minus, norm, unit};
use etalon_base::{error, phrase};

/// Mean positions compared with their least-squares plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Coplanarity {
    /// Unit normal of the plane.
    pub normal: Vector,
    /// Signed distance of each mean position from the plane.
    pub deviations_mm: Vec<f64>,
    /// Peak to valley.
    pub flatness_mm: f64,
}

/// Evaluates coplanarity of at least four non-collinear poses.
pub fn coplanarity(poses_mm: &[Vec<Vector>]) -> Result<Coplanarity> {
    if poses_mm.len() < 4 {
        let of = phrase!("characteristic", name = "coplanarity");
        return Err(error!("too-few-of", of, sets = phrase!("poses", count = poses_mm.len()), least = 4).into());
    }
    for points in poses_mm {
        crate::iso9283::statistics::sample::positions(points, 1, "coplanarity")?;
    }
    let means: Vec<Vector> = poses_mm.iter().map(|points| mean_position(points)).collect();
    let plane = etalon_fit::plane(&means, &etalon_fit::FitSettings::default())?;
    let normal = plane.geometry.direction.and_then(unit).unwrap_or_default();
    let deviations_mm: Vec<f64> = means.iter().map(|p| dot(minus(*p, plane.geometry.point_mm), normal)).collect();
    let (low, high) = deviations_mm.iter().fold((0.0f64, 0.0f64), |(l, h), d| (l.min(*d), h.max(*d)));
    Ok(Coplanarity { normal, deviations_mm, flatness_mm: high - low })
}

/// Distance (mm, non-negative) of each of four mean positions from the plane of the other three
/// (thesis, 2.4).
pub fn from_the_others(poses_mm: &[Vec<Vector>; 4]) -> Result<[f64; 4]> {
    for points in poses_mm {
        crate::iso9283::statistics::sample::positions(points, 1, "coplanarity")?;
    }
    let means = [0, 1, 2, 3].map(|i| mean_position(&poses_mm[i]));
    let mut distances_mm = [0.0; 4];
    for (i, distance_mm) in distances_mm.iter_mut().enumerate() {
        let [a, b, c] = [1, 2, 3].map(|k| means[(i + k) % 4]);
        let (ab, ac) = (minus(b, a), minus(c, a));
        let normal = cross(ab, ac);
        // three points define a plane if they deviate from a line by a thousandth of their distance
        if norm(normal) <= 1e-3 * norm(ab) * norm(ac) {
            return Err(error!("coplanar-poses-on-line").into());
        }
        *distance_mm = unit(normal).map_or(0.0, |n| dot(minus(means[i], a), n).abs());
    }
    Ok(distances_mm)
}

/// Peak to valley of the mean positions of a test about their plane; `None` for planar robots, and
/// with fewer than four poses or collinear poses.
pub fn flatness(test: &PoseTest) -> Result<Option<f64>> {
    if !test.spatial || test.poses.len() < 4 {
        return Ok(None);
    }
    let means: Vec<Vec<Vector>> = test.poses.iter().map(|p| p.positions_mm(|_| true)).collect();
    Ok(coplanarity(&means).ok().map(|c| c.flatness_mm))
}
