//! Distances of a point from a fitted element as a prediction: their derivatives with respect to
//! the quantities of the element give the part of their variance that the element contributes.
//!
//! A distance is a function of point, direction, radii and angle of the element, whose covariance
//! the fit has. The rule G C Gᵀ therefore holds for all elements (JCGM 102:2011, 6.2.1.3), inside
//! and outside the fitted points.

use super::chart::Chart;
use super::element::Element;
use super::result::{Fit, QUANTITIES};
use etalon_base::pose::{Vector, dot, minus, norm};

/// Derivatives with respect to the quantities of an element, in the order of
/// [`ElementCovariance`](super::ElementCovariance).
type Gradient = [f64; QUANTITIES];

/// Distances of a point that a fit minimises: one, or two for a line or circle in space.
pub(super) struct Offsets {
    /// Distances (mm); the second is zero for elements with one.
    pub distances: [f64; 2],
    gradients: [Gradient; 2],
}

impl Offsets {
    /// Length of the shortest connection of the point and the element (mm).
    pub fn length(&self) -> f64 {
        self.distances[0].hypot(self.distances[1])
    }

    /// Covariance (mm²) of the distances from the covariance of the element.
    pub fn covariance(&self, fit: &Fit) -> [[f64; 2]; 2] {
        let Some(c) = fit.precision.covariance.as_ref().map(|c| &c.0) else { return [[0.0; 2]; 2] };
        let through =
            |g: &Gradient| -> Gradient { std::array::from_fn(|q| c.iter().zip(g).map(|(row, v)| row[q] * v).sum()) };
        let [a, b] = [through(&self.gradients[0]), through(&self.gradients[1])];
        let product = |u: &Gradient, v: &Gradient| u.iter().zip(v).map(|(x, y)| x * y).sum::<f64>();
        let [first, second] = &self.gradients;
        [[product(&a, first), product(&a, second)], [product(&b, first), product(&b, second)]]
    }
}

/// Number of distances of a point.
pub(super) fn equations(element: Element) -> usize {
    if matches!(element, Element::Circle3d | Element::Line) { 2 } else { 1 }
}

/// Gradient with respect to point and direction, and radius, minor radius and apex angle.
fn gradient(point: Vector, direction: Vector, sizes: [f64; 3]) -> Gradient {
    let mut all = [0.0; QUANTITIES];
    all[..3].copy_from_slice(&point);
    all[3..6].copy_from_slice(&direction);
    all[6..].copy_from_slice(&sizes);
    all
}

fn times(factor: f64, v: Vector) -> Vector {
    v.map(|x| factor * x)
}

fn plus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] + b[k])
}

impl Fit {
    /// Distances of a point from the element, with their derivatives.
    pub(super) fn offsets(&self, point_mm: Vector) -> Offsets {
        let mut w = minus(point_mm, self.geometry.point_mm);
        if matches!(self.element, Element::Line2d | Element::Circle2d) {
            w[2] = 0.0;
        }
        let d = self.geometry.direction.unwrap_or([0.0, 0.0, 1.0]);
        let t = dot(w, d);
        let across = plus(w, times(-t, d));
        let rho = norm(across);
        let g = if rho > 0.0 { times(1.0 / rho, across) } else { [0.0; 3] };
        let radius = self.geometry.radius_mm.unwrap_or(0.0);
        let none = gradient([0.0; 3], [0.0; 3], [0.0; 3]);
        let one =
            |distance: f64, gradient: Gradient| Offsets { distances: [distance, 0.0], gradients: [gradient, none] };
        let radial = |factor: f64| gradient(times(-1.0, g), times(-t, g), [factor, 0.0, 0.0]);
        match self.element {
            Element::Line2d => {
                let left = [-d[1], d[0], 0.0];
                one(dot(left, w), gradient(times(-1.0, left), [w[1], -w[0], 0.0], [0.0; 3]))
            }
            Element::Plane => one(t, gradient(times(-1.0, d), w, [0.0; 3])),
            Element::Sphere => {
                let length = norm(w);
                let out = if length > 0.0 { times(-1.0 / length, w) } else { [0.0; 3] };
                one(length - radius, gradient(out, [0.0; 3], [-1.0, 0.0, 0.0]))
            }
            Element::Line => {
                let Chart { e1, e2, .. } = Chart::new(d);
                let [first, second] = [e1, e2].map(|e| gradient(times(-1.0, e), times(-t, e), [0.0; 3]));
                Offsets { distances: [dot(e1, w), dot(e2, w)], gradients: [first, second] }
            }
            Element::Circle2d | Element::Cylinder => one(rho - radius, radial(-1.0)),
            Element::Circle3d => Offsets {
                distances: [rho - radius, t],
                gradients: [radial(-1.0), gradient(times(-1.0, d), w, [0.0; 3])],
            },
            Element::Cone => {
                let (sin, cos) = (self.geometry.apex_angle_rad.unwrap_or(0.0) / 2.0).sin_cos();
                let at = plus(times(-cos, g), times(sin, d));
                let turned = plus(times(-t * cos, g), times(-sin, w));
                let by_angle = -0.5 * ((rho - radius) * sin + t * cos);
                one((rho - radius) * cos - t * sin, gradient(at, turned, [-cos, 0.0, by_angle]))
            }
            Element::Torus => {
                let from_core = (rho - radius).hypot(t);
                let inverse = if from_core > 0.0 { 1.0 / from_core } else { 0.0 };
                let (out, up) = ((rho - radius) * inverse, t * inverse);
                let at = plus(times(-out, g), times(-up, d));
                let turned = plus(times(-t * out, g), times(up, w));
                let minor = self.geometry.minor_radius_mm.unwrap_or(0.0);
                one(from_core - minor, gradient(at, turned, [-out, -1.0, 0.0]))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{FitSettings, element};
    use etalon_base::noise::Noise;
    use etalon_base::pose::unit;

    /// The element moved by `h` along the quantity `q`; directions remain unit vectors.
    fn moved(fit: &Fit, q: usize, h: f64) -> Fit {
        let mut fit = fit.clone();
        match q {
            0..3 => fit.geometry.point_mm[q] += h,
            3..6 => {
                let mut step = [0.0; 3];
                step[q - 3] = h;
                fit.geometry.direction = fit.geometry.direction.and_then(|d| unit(plus(d, step)));
            }
            6 => fit.geometry.radius_mm = fit.geometry.radius_mm.map(|r| r + h),
            7 => fit.geometry.minor_radius_mm = fit.geometry.minor_radius_mm.map(|r| r + h),
            _ => fit.geometry.apex_angle_rad = fit.geometry.apex_angle_rad.map(|a| a + h),
        }
        fit
    }

    #[test]
    fn gradients_are_the_numeric_derivatives() {
        let mut noise = Noise::new(5, 0);
        let mut point = |i: usize| {
            let ((s, c), t) = ((0.7 * i as f64).sin_cos(), (i % 7) as f64 - 3.0);
            [(20.0 + t) * c, (20.0 + t) * s, 2.0 * t].map(|v| v + noise.gaussian(0.1))
        };
        let points: Vec<Vector> = (0..40).map(&mut point).collect();
        for kind in Element::ALL {
            let fit = element(kind, &points, &FitSettings::default()).unwrap();
            let p = [24.0, 7.0, 3.0];
            let sizes = [fit.geometry.radius_mm, fit.geometry.minor_radius_mm, fit.geometry.apex_angle_rad];
            for q in 0..QUANTITIES {
                let flat = matches!(kind, Element::Line2d | Element::Circle2d) && matches!(q, 2 | 5);
                let absent = (3..6).contains(&q) && fit.geometry.direction.is_none() || q > 5 && sizes[q - 6].is_none();
                // the two directions across a line turn with it
                if flat || absent || kind == Element::Line && q > 2 {
                    continue;
                }
                let h = 1e-5;
                let (less, more) = (moved(&fit, q, -h).offsets(p), moved(&fit, q, h).offsets(p));
                for row in 0..2 {
                    let numeric = (more.distances[row] - less.distances[row]) / (2.0 * h);
                    let mut stated = fit.offsets(p).gradients[row][q];
                    if let Some(d) = fit.geometry.direction.filter(|_| (3..6).contains(&q)) {
                        // a unit vector moves perpendicular to itself
                        let g = &fit.offsets(p).gradients[row];
                        stated -= d[q - 3] * dot([g[3], g[4], g[5]], d);
                    }
                    assert!((numeric - stated).abs() < 1e-6, "{kind} {q} {row}: {numeric} {stated}");
                }
            }
        }
    }
}
