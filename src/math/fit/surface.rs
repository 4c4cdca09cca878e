//! From distances of points to a fit: one element states its distance and derivative, and this states the rest.

use super::cloud::Cloud;
use super::coverage::Coverage;
use super::descend::Refined;
use super::element::{Element, refuse};
use super::f64x8::{F64x8, Points};
use super::result::{Covariance, Fit, QUANTITIES, Residuals};
use crate::base::message::Result;
use crate::base::pose::Vector;
use crate::math::solve::{Termination, svd};

/// An element with `N` parameters that gives `K` distances a point, in normalised coordinates.
pub(super) trait Surface<const N: usize, const K: usize>: Copy + Sync {
    /// The parameter that is always held, where there is one (a cylinder's point along its axis): no sum is made of it.
    const IDLE: usize = usize::MAX;

    /// Signed distances of the points `q` and their derivatives by the parameters, in the middle of the chart.
    fn distances(&self, x: &[f64; N], q: Points) -> [(F64x8, [F64x8; N]); K];

    /// The same element in the chart about itself.
    fn recharted(&self, x: &[f64; N]) -> (Self, [f64; N]);

    /// How point, direction, radius, minor radius and apex angle move with each parameter (order of [`Covariance`]).
    fn quantities(&self, x: &[f64; N]) -> [[f64; QUANTITIES]; N];
}

/// Above this condition of the scaled Jacobian a double has no digit left for the worst-known parameter.
const CONDITION_LIMIT: f64 = 1e12;

impl<S, const N: usize> Refined<S, N> {
    /// Largest over smallest singular value of the Jacobian with columns of length one.
    pub fn condition(&self) -> f64 {
        self.factor.as_ref().map_or(f64::INFINITY, |f| svd(f).condition())
    }

    /// Covariance of x, held parameters with zeros; `None` without redundancy.
    pub fn covariance(&self, degrees_of_freedom: usize) -> Option<[[f64; N]; N]> {
        let inverse = self.factor.as_ref().filter(|_| degrees_of_freedom > 0)?.inverse_normal()?;
        let variance = self.cost / degrees_of_freedom as f64;
        let mut covariance = [[0.0; N]; N];
        let rows = inverse.chunks_exact(self.free.len().max(1));
        for ((&i, row), a) in self.free.iter().zip(rows).zip(&self.scale) {
            for ((&j, v), b) in self.free.iter().zip(row).zip(&self.scale) {
                covariance[i][j] = v * variance / (a * b);
            }
        }
        Some(covariance)
    }

    /// The result so far, or why there is none.
    pub fn to_fit<const K: usize, C: Coverage>(
        &self,
        element: Element,
        cloud: &Cloud,
        point: Vector,
        coverage: C,
    ) -> Result<Fit>
    where
        S: Surface<N, K>,
    {
        let condition = self.condition();
        let known = condition <= CONDITION_LIMIT;
        if !self.termination.is_success() || !known || self.x.iter().any(|x| !x.is_finite()) {
            cloud.numbers(element)?;
            let ended = if known { self.termination } else { Termination::RankDeficient };
            return Err(refuse(
                format!("no {element} could be fitted: {ended}"),
                format!("points that determine a {element}"),
                "look at the points: too short an arc, too straight, or another element; else hold the radius or the axis",
            ));
        }
        let by_parameter = self.surface.quantities(&self.x);
        let degrees_of_freedom = (K * cloud.len()).saturating_sub(self.free.len());
        let (residuals, covered) = Residuals::and(
            cloud,
            #[inline(always)]
            |q| self.surface.distances(&self.x, q).map(|(d, _)| d),
            coverage,
        );
        if !(residuals.squares * cloud.scale_mm).is_finite() {
            cloud.numbers(element)?;
        }
        let covariance = self.covariance(degrees_of_freedom);
        Ok(Fit {
            degrees_of_freedom,
            covariance: covariance.map(|c| propagate(&c, &by_parameter, cloud.scale_mm)),
            coverage_rad: Some(C::angle_rad(covered)),
            condition,
            method: "orthogonal distance, Gauss-Newton in a trust region",
            iterations: self.iterations,
            termination: self.termination,
            ..Fit::new(element, cloud, point, residuals)
        })
    }
}

/// G C Gᵀ, with lengths brought from normalised units to mm (JCGM 102:2011, 6.2.1.3).
pub(super) fn propagate<const N: usize>(
    local: &[[f64; N]; N],
    by_parameter: &[[f64; QUANTITIES]; N],
    scale_mm: f64,
) -> Covariance {
    let unit = |q: usize| if q < 3 || q == 6 || q == 7 { scale_mm } else { 1.0 };
    let mut covariance = [[0.0; QUANTITIES]; QUANTITIES];
    for (i, gi) in by_parameter.iter().enumerate() {
        for (j, gj) in by_parameter.iter().enumerate() {
            for (p, row) in covariance.iter_mut().enumerate() {
                for (q, c) in row.iter_mut().enumerate() {
                    *c += gi[p] * unit(p) * local[i][j] * gj[q] * unit(q);
                }
            }
        }
    }
    Covariance(covariance)
}

#[cfg(test)]
mod tests {
    use super::super::axis::Chart;
    use super::super::ball::{Ball, Disc};
    use super::super::circle3d::Ring;
    use super::super::cone::Funnel;
    use super::super::cylinder::Tube;
    use super::super::torus::Bend;
    use super::*;

    /// Fourth-order central difference of every distance by every parameter but the held ones, through a new chart.
    fn derivatives_agree<S: Surface<N, K>, const N: usize, const K: usize>(
        name: &str,
        surface: &S,
        x: [f64; N],
        held: &[usize],
    ) {
        for q in [[0.7, -0.4, 0.9], [-0.2, 0.8, -0.6], [0.31, 0.17, 0.05]] {
            let q = q.map(F64x8::all);
            let analytic = surface.distances(&x, q);
            for j in (0..N).filter(|j| !held.contains(j)) {
                let h = 1e-3;
                let shifted = |k: f64| {
                    let mut x = x;
                    x[j] += k * h;
                    let (surface, x) = surface.recharted(&x);
                    surface.distances(&x, q).map(|(distance, _)| distance.0[0])
                };
                let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(shifted);
                for k in 0..K {
                    let numeric = (a[k] - 8.0 * b[k] + 8.0 * c[k] - d[k]) / (12.0 * h);
                    let analytic = analytic[k].1[j].0[0];
                    assert!(
                        (analytic - numeric).abs() < 1e-9,
                        "{name}: row {k} parameter {j}: {analytic} and {numeric}"
                    );
                }
            }
        }
    }

    #[test]
    fn jacobians_are_the_numeric_derivatives() {
        let chart = Chart::new([0.3, -0.5, 0.8]);
        derivatives_agree("ball", &Ball, [0.1, -0.2, 0.3, 0.8], &[]);
        derivatives_agree("circle", &Disc { chart }, [0.1, -0.2, 0.8], &[]);
        derivatives_agree("circle in space", &Ring { chart }, [0.1, -0.2, 0.05, 0.0, 0.0, 0.8], &[]);
        // the point of cylinder and cone is kept at the foot of the centroid
        derivatives_agree("cylinder", &Tube { chart }, [0.1, -0.2, 0.0, 0.0, 0.0, 0.8], &[2]);
        derivatives_agree("cone", &Funnel { chart }, [0.1, -0.2, 0.0, 0.0, 0.0, 0.8, 0.4], &[2]);
        derivatives_agree("torus", &Bend { chart }, [0.1, -0.2, 0.05, 0.0, 0.0, 0.8, 0.3], &[]);
    }

    /// How the reported quantities move when the parameters do, by laying a new chart about the moved axis.
    #[test]
    fn quantities_move_as_stated() {
        let chart = Chart::new([0.3, -0.5, 0.8]);
        let reported = |surface: &Funnel, x: &[f64; 7]| {
            let (moved, y) = surface.recharted(x);
            let p = moved.chart.point(y[0], y[1], y[2]);
            let d = moved.chart.d0;
            [p[0], p[1], p[2], d[0], d[1], d[2], y[5] / y[6].cos(), 0.0, 2.0 * y[6]]
        };
        let (surface, x) = (Funnel { chart }, [0.1, -0.2, 0.0, 0.0, 0.0, 0.8, 0.4]);
        let stated = surface.quantities(&x);
        for j in [0, 1, 3, 4, 5, 6] {
            let shifted = |h: f64| {
                let mut x = x;
                x[j] += h;
                reported(&surface, &x)
            };
            let (less, more) = (shifted(-1e-5), shifted(1e-5));
            for q in 0..QUANTITIES {
                let numeric = (more[q] - less[q]) / 2e-5;
                assert!(
                    (numeric - stated[j][q]).abs() < 1e-9,
                    "parameter {j} quantity {q}: {numeric} {}",
                    stated[j][q]
                );
            }
        }
    }
}
