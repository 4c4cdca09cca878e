//! Distance of the target from a fixed point.

use super::{At, Condition, Equation, Kind, SHORTEST, place, point};
use etalon_base::pose::{Vector, centroid, dot, minus, norm, unit};
use etalon_math::Factor;
use etalon_math::statistics::mean;
use etalon_robots::FreeBase;
use std::collections::BTreeMap;

/// Distance from a fixed point. Residual: |p − q| − d (mm).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// First of the three coordinates of the point.
    pub to: usize,
    /// The distance.
    pub distance_mm: f64,
}

impl Distance {
    /// Unit vector from the point to the target.
    fn along(&self, at: &At) -> Vector {
        unit(minus(at.position, point(at.values, self.to))).unwrap_or_default()
    }
}

impl Equation for Distance {
    fn unknowns(&self) -> Vec<usize> {
        (self.to..self.to + 3).collect()
    }

    fn residuals(&self, at: &At, out: &mut [f64]) {
        out[0] = norm(minus(at.position, point(at.values, self.to))) - self.distance_mm;
    }

    fn jacobian(&self, at: &At, moved: &[f64], out: &mut [f64]) {
        let (n, along) = (at.values.len(), self.along(at));
        (0..n).for_each(|j| out[j] = (0..3).map(|i| along[i] * moved[i * n + j]).sum());
        (0..3).for_each(|i| out[self.to + i] -= along[i]);
    }

    fn in_world(&self, at: &At, residuals: Vector) -> Vector {
        self.along(at).map(|v| v * residuals[0])
    }

    fn by_scale(&self, _: &[f64]) -> Vector {
        [-self.distance_mm, 0.0, 0.0]
    }

    fn has_length(&self) -> bool {
        true
    }
}

/// Points from their distances to targets: differences of squares are linear in the point.
pub(crate) fn trilaterate_points(
    arm: &dyn FreeBase,
    conditions: &[Condition],
    is_unknown: impl Fn(usize) -> bool,
    values: &mut [f64],
) {
    let mut points: BTreeMap<usize, Vec<(Vector, f64)>> = BTreeMap::new();
    for c in conditions {
        if let Kind::Distance(Distance { to, distance_mm }) = c.kind {
            points.entry(to).or_default().push((place(arm, c, values), distance_mm));
        }
    }
    for (to, all) in points.into_iter().filter(|p| is_unknown(p.0)) {
        let places: Vec<Vector> = all.iter().map(|p| p.0).collect();
        let Some(centre) = centroid(&places) else { continue };
        let square = |(p, d): &(Vector, f64)| {
            let p = minus(*p, centre);
            0.5 * (dot(p, p) - d * d)
        };
        let mean = mean(all.iter().map(square));
        let rows: Vec<f64> = places.iter().flat_map(|p| minus(*p, centre)).collect();
        let right: Vec<f64> = all.iter().map(|p| square(p) - mean).collect();
        if let Some(found) = Factor::new(&rows, &right, &[1.0; 3]).damped(SHORTEST).solve() {
            (0..3).for_each(|i| values[to + i] = centre[i] + found[i]);
        }
    }
}
