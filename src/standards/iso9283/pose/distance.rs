//! Distance accuracy AD and repeatability RD between two poses (ISO 9283:1998 7.3, unverified against a bought copy).

use crate::iso9283::statistics::sample::{Spread, spread, unwrapped, wrapped};
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Vector, minus, norm};

/// How well a commanded distance is driven.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// Mean attained distance.
    pub mean_mm: f64,
    /// AD_p: mean attained minus commanded distance.
    pub ad_mm: f64,
    /// AD_x, AD_y, AD_z: the same of the sizes of the coordinate differences.
    pub ad_axis_mm: Vector,
    /// RD_p: three standard deviations of the attained distance.
    pub rd_mm: f64,
    /// RD_x, RD_y, RD_z.
    pub rd_axis_mm: Vector,
}

/// Distance between two poses that were visited in the same cycles, in order: at least two.
pub fn distance(first_mm: &[Vector], second_mm: &[Vector], commanded_mm: [Vector; 2]) -> Result<Distance> {
    crate::iso9283::statistics::sample::positions(first_mm, 2, "distance")?;
    crate::iso9283::statistics::sample::positions(second_mm, 2, "distance")?;
    if first_mm.len() != second_mm.len() {
        let message = Message::error(format!("distance: {} and {} positions", first_mm.len(), second_mm.len()));
        return Err(message.expected("both poses in the same cycles").into());
    }
    let attained: Vec<Vector> = first_mm.iter().zip(second_mm).map(|(p, q)| minus(*p, *q)).collect();
    let commanded = minus(commanded_mm[0], commanded_mm[1]);
    let total = spread(&attained.iter().map(|&d| norm(d)).collect::<Vec<_>>());
    let axes: [Spread; 3] = [0, 1, 2].map(|k| spread(&attained.iter().map(|d| d[k].abs()).collect::<Vec<_>>()));
    Ok(Distance {
        mean_mm: total.mean,
        ad_mm: total.mean - norm(commanded),
        ad_axis_mm: [0, 1, 2].map(|k| axes[k].mean - commanded[k].abs()),
        rd_mm: 3.0 * total.deviation,
        rd_axis_mm: axes.map(|axis| 3.0 * axis.deviation),
    })
}

/// AD_a and RD_a in radians, of the sizes of the differences of one angle; NaN where cycles are too few.
pub fn angle_distance_rad(first_rad: &[f64], second_rad: &[f64], commanded_rad: [f64; 2]) -> (f64, f64) {
    let differences: Vec<f64> = first_rad.iter().zip(second_rad).map(|(a, b)| wrapped(a - b)).collect();
    let attained = spread(&unwrapped(&differences).iter().map(|d| d.abs()).collect::<Vec<_>>());
    (attained.mean - wrapped(commanded_rad[0] - commanded_rad[1]).abs(), 3.0 * attained.deviation)
}
