//! From distances of points to least squares: one element states its distance and derivative, and this states the rest.

use super::cloud::Cloud;
use super::element::{Element, refuse};
use super::result::{Covariance, Fit, QUANTITIES};
use crate::message::Result;
use crate::pose::Vector;
use crate::solve::{self, Options, Problem, Termination};

/// An element with `N` parameters that gives `K` distances a point, in normalised coordinates.
pub(super) trait Surface<const N: usize, const K: usize> {
    /// Signed distances of `q` and their derivatives by the parameters.
    fn distances(&self, x: &[f64; N], q: Vector) -> [(f64, [f64; N]); K];

    /// How point, direction, radius, minor radius and apex angle move with each parameter (order of [`Covariance`]).
    fn quantities(&self, x: &[f64; N]) -> [[f64; QUANTITIES]; N];
}

/// Where least squares ended.
pub(super) struct Refined<const N: usize, const K: usize> {
    pub x: [f64; N],
    /// Distances in normalised units, without weights.
    pub distances: Vec<[f64; K]>,
    /// Sum of their weighted squares.
    pub cost: f64,
    pub degrees_of_freedom: usize,
    /// Covariance of x, held parameters with zeros; `None` without redundancy.
    pub covariance: Option<[[f64; N]; N]>,
    pub condition: f64,
    pub iterations: usize,
    pub termination: Termination,
}

struct Distances<'a, S, const N: usize, const K: usize> {
    surface: &'a S,
    cloud: &'a Cloud,
    start: [f64; N],
    free: Vec<usize>,
}

impl<S: Surface<N, K>, const N: usize, const K: usize> Distances<'_, S, N, K> {
    /// All parameters, the held ones at their start.
    fn all(&self, free: &[f64]) -> [f64; N] {
        let mut x = self.start;
        for (&i, v) in self.free.iter().zip(free) {
            x[i] = *v;
        }
        x
    }
}

impl<S: Surface<N, K>, const N: usize, const K: usize> Problem for Distances<'_, S, N, K> {
    fn residual_count(&self) -> usize {
        K * self.cloud.points.len()
    }

    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        let x = self.all(x);
        for (i, (r, &q)) in r.chunks_exact_mut(K).zip(&self.cloud.points).enumerate() {
            let root = self.cloud.root(i);
            for (r, (distance, _)) in r.iter_mut().zip(self.surface.distances(&x, q)) {
                *r = root * distance;
            }
        }
    }

    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        let x = self.all(x);
        let n = self.free.len();
        for (i, (rows, &q)) in jacobian.chunks_exact_mut(K * n).zip(&self.cloud.points).enumerate() {
            let root = self.cloud.root(i);
            for (row, (_, derivative)) in rows.chunks_exact_mut(n).zip(self.surface.distances(&x, q)) {
                for (j, &k) in row.iter_mut().zip(&self.free) {
                    *j = root * derivative[k];
                }
            }
        }
    }
}

/// Minimises the sum of squared distances from `start`, the parameters marked in `free` moving.
pub(super) fn refine<S: Surface<N, K>, const N: usize, const K: usize>(
    surface: &S,
    cloud: &Cloud,
    start: [f64; N],
    free: [bool; N],
    options: Options,
) -> Refined<N, K> {
    let free: Vec<usize> = (0..N).filter(|&i| free[i]).collect();
    let problem = Distances { surface, cloud, start, free };
    let start: Vec<f64> = problem.free.iter().map(|&i| problem.start[i]).collect();
    let solution = solve::solve(&problem, &start, options);
    let x = problem.all(&solution.x);
    let cost = solution.cost();
    let degrees_of_freedom = problem.residual_count().saturating_sub(problem.free.len());
    let variance = cost / degrees_of_freedom as f64;
    let covariance = solution.covariance().filter(|_| degrees_of_freedom > 0).map(|local| {
        let mut covariance = [[0.0; N]; N];
        let rows = local.chunks_exact(problem.free.len().max(1));
        for (&i, row) in problem.free.iter().zip(rows) {
            for (&j, v) in problem.free.iter().zip(row) {
                covariance[i][j] = v * variance;
            }
        }
        covariance
    });
    let distances = cloud.points.iter().map(|&q| surface.distances(&x, q).map(|(d, _)| d)).collect();
    Refined {
        x,
        distances,
        cost,
        degrees_of_freedom,
        covariance,
        condition: solution.factor.as_ref().map_or(f64::INFINITY, |f| solve::svd(f).condition()),
        iterations: solution.iterations,
        termination: solution.termination,
    }
}

/// Above this condition of the scaled Jacobian a double has no digit left for the worst-known parameter.
const CONDITION_LIMIT: f64 = 1e12;

impl<const N: usize, const K: usize> Refined<N, K> {
    /// The result so far, or why there is none.
    pub fn into_fit<S: Surface<N, K>>(
        self,
        element: Element,
        surface: &S,
        cloud: &Cloud,
        point: Vector,
    ) -> Result<Fit> {
        let known = self.condition <= CONDITION_LIMIT;
        if !self.termination.is_success() || !known || self.x.iter().any(|x| !x.is_finite()) {
            let ended = if known { self.termination } else { Termination::RankDeficient };
            return Err(refuse(
                format!("no {element} could be fitted: {ended}"),
                format!("points that determine a {element}"),
                "look at the points: too short an arc, too straight, or another element; else hold the radius or the axis",
            ));
        }
        let by_parameter = surface.quantities(&self.x);
        let residuals = self.distances.iter().filter_map(|d| d.first().copied()).collect();
        Ok(Fit {
            degrees_of_freedom: self.degrees_of_freedom,
            covariance: self.covariance.map(|c| propagate(&c, &by_parameter, cloud.scale_mm)),
            condition: self.condition,
            method: "orthogonal distance, Levenberg-Marquardt with Gauss-Newton finish",
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
    use super::super::ball::Ball;
    use super::super::circle3d::Ring;
    use super::super::cone::Funnel;
    use super::super::cylinder::Tube;
    use super::super::torus::Bend;
    use super::*;

    /// Fourth-order central difference of every distance by every parameter.
    fn derivatives_agree<S: Surface<N, K>, const N: usize, const K: usize>(name: &str, surface: &S, x: [f64; N]) {
        for q in [[0.7, -0.4, 0.9], [-0.2, 0.8, -0.6], [0.31, 0.17, 0.05]] {
            let analytic = surface.distances(&x, q);
            for j in 0..N {
                let h = 1e-3;
                let shifted = |k: f64| {
                    let mut x = x;
                    x[j] += k * h;
                    surface.distances(&x, q)
                };
                let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(shifted);
                for k in 0..K {
                    let numeric = (a[k].0 - 8.0 * b[k].0 + 8.0 * c[k].0 - d[k].0) / (12.0 * h);
                    let error = (analytic[k].1[j] - numeric).abs();
                    assert!(error < 1e-9, "{name}: row {k} parameter {j}: {} and {numeric}", analytic[k].1[j]);
                }
            }
        }
    }

    #[test]
    fn jacobians_are_the_numeric_derivatives() {
        let chart = Chart::new([0.3, -0.5, 0.8]);
        // away from the middle of the chart, so that no term is multiplied by zero
        derivatives_agree("ball", &Ball, [0.1, -0.2, 0.3, 0.8]);
        derivatives_agree("circle in space", &Ring { chart }, [0.1, -0.2, 0.05, 0.2, -0.3, 0.8]);
        derivatives_agree("cylinder", &Tube { chart }, [0.1, -0.2, 0.05, 0.2, -0.3, 0.8]);
        derivatives_agree("cone", &Funnel { chart }, [0.1, -0.2, 0.05, 0.2, -0.3, 0.8, 0.4]);
        derivatives_agree("torus", &Bend { chart }, [0.1, -0.2, 0.05, 0.2, -0.3, 0.8, 0.3]);
    }

    /// How the reported quantities move when the parameters do, by laying a new chart about the moved axis.
    #[test]
    fn quantities_move_as_stated() {
        use super::super::axis::Axial;
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
