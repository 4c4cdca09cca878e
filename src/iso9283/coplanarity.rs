//! Coplanarity of mean positions (thesis 2.4): a planar robot's barycentres should lie in one plane.

use super::sample::mean_position;
use crate::fit;
use crate::message::{Message, Result};
use crate::pose::{Vector, dot, minus, unit};

/// Mean positions against their least-squares plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Coplanarity {
    /// Unit normal of the plane.
    pub normal: Vector,
    /// Distance of each mean position from it, with its sign.
    pub deviations_mm: Vec<f64>,
    /// Peak to valley.
    pub flatness_mm: f64,
}

/// Coplanarity of at least four poses that do not lie on a line.
pub fn coplanarity(poses_mm: &[Vec<Vector>]) -> Result<Coplanarity> {
    if poses_mm.len() < 4 {
        let message = Message::error(format!("coplanarity: {} poses", poses_mm.len()));
        return Err(message.expected("at least four: three lie in a plane anyhow").into());
    }
    for points in poses_mm {
        super::positions(points, 1, "coplanarity")?;
    }
    let means: Vec<Vector> = poses_mm.iter().map(|points| mean_position(points)).collect();
    let plane = fit::plane(&means)?;
    let normal = plane.direction.and_then(unit).unwrap_or_default();
    let deviations_mm: Vec<f64> = means.iter().map(|p| dot(minus(*p, plane.point_mm), normal)).collect();
    let (low, high) = deviations_mm.iter().fold((0.0f64, 0.0f64), |(l, h), d| (l.min(*d), h.max(*d)));
    Ok(Coplanarity { normal, deviations_mm, flatness_mm: high - low })
}
