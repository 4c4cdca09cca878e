//! Least squares from a start to the minimum by Gauss-Newton in a trust region, with one pass over
//! all points per step; and conversion of the minimum to a fit.
//!
//! Points are processed in blocks that leave only the sums of the normal equations, so memory does
//! not depend on their number. Centred, scaled and relative to the element's own axis, the problem
//! is well conditioned. The accuracy of the result is the accuracy of the gradient, not of the
//! factor that divides it. Where the normal equations do lose digits (short arcs), a second pass
//! accumulates an orthogonal factor.
//!
//! [`math::solve`](etalon_math) is not used because it stores a row for every equation and keeps
//! its parameters in one chart. For a cylinder of 100,000 points it needs 20 ms from a good start,
//! compared with 2 ms here including the search for a start; for a million points 6 s and 0.6 s.
//! The radii agree to 4e-15 mm. Factor and trust region are shared.
//!
//! After each step the chart is centred again on the element, so that a surface provides
//! derivatives at the centre of its chart only. (NPL's LSGE similarly rotates the axis to z in each
//! iteration.)

use super::cloud::{Cloud, Gather, SAMPLE};
use super::coverage::Coverage;
use super::element::Element;
use super::f64x8::{F64x8, LANES, Points};
use super::result::{Fit, FitPrecision, FitSolver, QUANTITIES, Residuals, propagate};
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_math::{Factor, Termination, TrustRegion, norm, svd};

/// Element with `N` parameters and `K` distances per point, in normalised coordinates.
pub(super) trait Surface<const N: usize, const K: usize>: Copy + Sync {
    /// Parameter that is always held, if any (position of a cylinder's point along its axis); no
    /// sums are computed for it.
    const IDLE: usize = usize::MAX;

    /// Signed distances of the points `q` and their derivatives with respect to the parameters, at
    /// the centre of the chart.
    fn distances(&self, x: &[f64; N], q: Points) -> [(F64x8, [F64x8; N]); K];

    /// Centres the chart on the element.
    fn recharted(&self, x: &[f64; N]) -> (Self, [f64; N]);

    /// Returns the residual of points with these distances: the first, unless all together are one
    /// distance.
    #[inline(always)]
    fn residual(distances: [F64x8; K]) -> F64x8 {
        distances[0]
    }

    /// Derivatives of point, direction, radius, minor radius and apex angle with respect to each
    /// parameter (order of [`ElementCovariance`]).
    fn quantities(&self, x: &[f64; N]) -> [[f64; QUANTITIES]; N];
}

/// Condition number of the scaled Jacobian above which a double has no correct digit for the least
/// certain parameter.
const CONDITION_LIMIT: f64 = 1e12;

/// Maximum size of the sample that improves a start, and ratio of all points to the sample.
const LARGEST_SAMPLE: usize = 16_384;
const THINNED: usize = 32;
/// Pivot of the scaled normal equations below which their step has fewer than six correct digits.
const LEAST_PIVOT: f64 = 1e-9;
/// Convergence tolerance: step relative to the parameters.
const STEP: f64 = f64::EPSILON;
/// Convergence tolerance: cosine of the angle between residuals and Jacobian.
const GRADIENT: f64 = 1e-15;
/// Maximum number of iterations of a fit; a search uses fewer for each start.
pub(super) const ITERATIONS: usize = 2000;

/// Final state of least squares.
pub(super) struct Refined<S, const N: usize> {
    pub surface: S,
    pub x: [f64; N],
    /// Weighted sum of squared distances.
    pub cost: f64,
    /// Indices of the free parameters.
    pub free: Vec<usize>,
    /// Factor of the Jacobian of the free parameters, with columns divided by `scale`.
    pub factor: Option<Factor>,
    pub scale: Vec<f64>,
    /// Weighted sums of products of derivatives with respect to all parameters.
    pub products: [[f64; N]; N],
    pub iterations: usize,
    pub termination: Termination,
}

/// Minimises the sum of squared distances from `start` over the parameters marked in `free`.
pub(super) fn refine<S: Surface<N, K>, const N: usize, const K: usize>(
    surface: S,
    cloud: &Cloud,
    start: [f64; N],
    free: [bool; N],
) -> Refined<S, N> {
    if cloud.len() <= 4 * SAMPLE {
        return descend(surface, cloud, start, free, ITERATIONS);
    }
    let few = cloud.thinned((cloud.len() / THINNED).clamp(SAMPLE, LARGEST_SAMPLE));
    let near = descend(surface, &few, start, free, ITERATIONS);
    let (surface, start) = if near.termination.is_success() { (near.surface, near.x) } else { (surface, start) };
    descend(surface, cloud, start, free, ITERATIONS)
}

/// Like [`refine`] on all points from the first step, with at most `iterations` iterations.
pub(super) fn descend<S: Surface<N, K>, const N: usize, const K: usize>(
    surface: S,
    cloud: &Cloud,
    start: [f64; N],
    free: [bool; N],
    iterations: usize,
) -> Refined<S, N> {
    let (surface, x) = surface.recharted(&start);
    let mut here = Refined {
        surface,
        x,
        cost: f64::NAN,
        free: (0..N).filter(|&i| free[i]).collect(),
        scale: Vec::new(),
        factor: None,
        products: [[0.0; N]; N],
        iterations: 0,
        termination: Termination::TooFewEquations,
    };
    if K * cloud.len() >= here.free.len() {
        here.termination = here.converge(cloud, iterations);
    }
    here
}

impl<S, const N: usize> Refined<S, N> {
    /// Iterates until convergence.
    fn converge<const K: usize>(&mut self, cloud: &Cloud, iterations: usize) -> Termination
    where
        S: Surface<N, K>,
    {
        let (cost, linear) = linearise(&self.surface, &self.x, cloud, &self.free);
        self.take(cost, linear);
        let (mut region, mut last): (Option<TrustRegion>, f64) = (None, f64::INFINITY);
        while self.iterations < iterations {
            let Some(factor) = self.factor.as_ref().filter(|_| self.cost.is_finite()) else {
                return Termination::NotANumber;
            };
            if self.cost == 0.0 {
                return Termination::ResidualsZero;
            }
            if norm(&factor.qtb) <= GRADIENT * self.cost.sqrt() {
                return Termination::GradientVanished;
            }
            let extent = norm(&self.free.iter().zip(&self.scale).map(|(&i, d)| self.x[i] * d).collect::<Vec<_>>());
            let region = region.get_or_insert_with(|| TrustRegion::new(extent));
            let Some(step) = region.step(factor) else { return Termination::RankDeficient };
            let size = step.length / (extent + f64::MIN_POSITIVE);
            if !step.is_damped && size >= last && last < 1e-6 {
                // steps have reached rounding
                return Termination::StepVanished;
            }
            let mut trial = self.x;
            for ((&i, p), d) in self.free.iter().zip(&step.p).zip(&self.scale) {
                trial[i] -= p / d;
            }
            let (surface, trial) = self.surface.recharted(&trial);
            // expected next step: steps shrink at the previous rate, but no faster than the
            // curvature of the residuals allows
            let bend = (self.cost / cloud.len() as f64).sqrt();
            // for noise rather than form deviation, the curvature terms of n points partly cancel:
            // a share of 1/√n remains
            let noise = bend / (cloud.len() as f64).sqrt();
            let left = size * f64::max(size / last, noise);
            if !step.is_damped && left <= STEP && size * bend <= 16.0 * STEP && size < 1e-6 {
                // the linear model is exact for such a step, so that its remaining cost needs no
                // pass over the points
                (self.surface, self.x, self.cost) = (surface, trial, factor.rest);
                self.iterations += 1;
                return Termination::StepVanished;
            }
            let (cost, linear) = linearise(&surface, &trial, cloud, &self.free);
            // near the minimum the cost is too flat to judge a step: decreasing steps are
            // sufficient
            let close = !step.is_damped && size < 1e-6 && size < last && cost <= self.cost * (1.0 + 1e-6);
            if close {
                region.open(&step);
            }
            if close || region.judge(&step, self.cost, cost) > 1e-4 {
                (self.surface, self.x) = (surface, trial);
                self.take(cost, linear);
                self.iterations += 1;
                last = if step.is_damped { f64::INFINITY } else { size };
            } else if size < 1e-8 || !region.is_open() {
                return Termination::NoImprovementPossible;
            }
        }
        Termination::IterationLimit
    }

    fn take(&mut self, cost: f64, linear: Linear<N>) {
        self.cost = cost;
        (self.factor, self.scale, self.products) = (linear.factor, linear.scale, linear.products);
    }

    /// Condition number of the Jacobian with columns scaled to unit length.
    pub fn condition(&self) -> f64 {
        self.factor.as_ref().map_or(f64::INFINITY, |f| svd(f).condition())
    }

    /// Covariance of x from the variance of a distance, with zeros for held parameters.
    pub fn covariance(&self, variance: f64) -> Option<[[f64; N]; N]> {
        let inverse = self.factor.as_ref()?.inverse_normal()?;
        let mut covariance = [[0.0; N]; N];
        let rows = inverse.chunks_exact(self.free.len().max(1));
        for ((&i, row), a) in self.free.iter().zip(rows).zip(&self.scale) {
            for ((&j, v), b) in self.free.iter().zip(row).zip(&self.scale) {
                covariance[i][j] = v * variance / (a * b);
            }
        }
        Some(covariance)
    }

    /// Converts the result to a fit, or returns the reason for failure.
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
            cloud.numbers(element.name())?;
            let termination = if known { self.termination } else { Termination::RankDeficient };
            return Err(error!("element-not-determined", element, termination = termination.phrase()).into());
        }
        let by_parameter = self.surface.quantities(&self.x);
        let degrees_of_freedom = (K * cloud.len()).saturating_sub(self.free.len());
        let (residuals, covered) = Residuals::and(
            cloud,
            #[inline(always)]
            |q| {
                let distances = self.surface.distances(&self.x, q).map(|(d, _)| d);
                (S::residual(distances), distances)
            },
            coverage,
        );
        if !(residuals.squares * cloud.scale_mm).is_finite() {
            cloud.numbers(element.name())?;
        }
        let variance = cloud.variance(self.cost, degrees_of_freedom);
        let covariance = variance.and_then(|variance| self.covariance(variance));
        Ok(Fit {
            precision: FitPrecision {
                covariance: covariance.map(|c| propagate(&c, &by_parameter, cloud.scale_mm)),
                ..FitPrecision::new(cloud, degrees_of_freedom, variance)
            },
            coverage_rad: Some(C::angle_rad(covered)),
            condition,
            solver: FitSolver {
                method: phrase!("method-orthogonal-distance"),
                iterations: self.iterations,
                termination: self.termination,
            },
            ..Fit::new(element, cloud, point, residuals)
        })
    }
}

/// Repeats a block for each index below a constant of at most seven. The repetition is expanded
/// before loop optimisations, which would otherwise split the sums and keep them in memory.
macro_rules! each {
    ($i:ident < $n:ident, $body:block) => {
        each!($i < $n, $body, 0, 1, 2, 3, 4, 5, 6)
    };
    ($i:ident < $n:ident, $body:block, $($index:literal),*) => {
        $(if $index < $n {
            let $i = $index;
            $body
        })*
    };
}

/// Accumulates products of derivatives, of derivative and distance, and of distances over the
/// points.
#[derive(Clone)]
struct Normal<'a, S, const N: usize, const K: usize> {
    surface: &'a S,
    x: [f64; N],
    products: [[F64x8; N]; N],
    right: [F64x8; N],
    squares: F64x8,
}

impl<S: Surface<N, K>, const N: usize, const K: usize> Gather for Normal<'_, S, N, K> {
    type Sum = ([[f64; N]; N], [f64; N], f64);

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        for (distance, row) in self.surface.distances(&self.x, q) {
            each!(i < N, {
                if i != S::IDLE {
                    let weighted = w * row[i];
                    each!(j < N, {
                        if j >= i && j != S::IDLE {
                            self.products[i][j] = self.products[i][j].plus(weighted, row[j]);
                        }
                    });
                    self.right[i] = self.right[i].plus(weighted, distance);
                }
            });
            self.squares = self.squares.plus(w * distance, distance);
        }
    }

    fn close(self) -> Self::Sum {
        (self.products.map(|row| row.map(F64x8::sum)), self.right.map(F64x8::sum), self.squares.sum())
    }

    fn join(a: Self::Sum, b: Self::Sum) -> Self::Sum {
        let products = std::array::from_fn(|i| std::array::from_fn(|j| a.0[i][j] + b.0[i][j]));
        (products, std::array::from_fn(|i| a.1[i] + b.1[i]), a.2 + b.2)
    }
}

/// Condensed Jacobian: sums of products of all parameters, and the factor of the free parameters
/// with the norms of its columns; no factor if a number in it is non-finite.
struct Linear<const N: usize> {
    products: [[f64; N]; N],
    factor: Option<Factor>,
    scale: Vec<f64>,
}

/// Sum of squares and Jacobian at `x`.
fn linearise<S: Surface<N, K>, const N: usize, const K: usize>(
    surface: &S,
    x: &[f64; N],
    cloud: &Cloud,
    free: &[usize],
) -> (f64, Linear<N>) {
    let zero = F64x8::default();
    let (products, right, squares) =
        cloud.gather(Normal { surface, x: *x, products: [[zero; N]; N], right: [zero; N], squares: zero });
    let product = |i: usize, j: usize| products[i.min(j)][i.max(j)];
    let column = |&i: &usize| if product(i, i) > 0.0 { product(i, i).sqrt() } else { 1.0 };
    let scale: Vec<f64> = free.iter().map(column).collect();
    let normal: Vec<f64> =
        free.iter().flat_map(|&i| free.iter().map(move |&j| (i, j))).map(|(i, j)| product(i, j)).collect();
    let right: Vec<f64> = free.iter().map(|&i| right[i]).collect();
    if !normal.iter().chain(&right).all(|v| v.is_finite()) {
        return (squares, Linear { products, factor: None, scale });
    }
    let factor = Factor::from_normal(&normal, &right, squares, &scale, LEAST_PIVOT);
    let factor = factor.unwrap_or_else(|| orthogonal_factor(surface, x, cloud, free, &scale));
    (squares, Linear { products, factor: Some(factor), scale })
}

/// Factor by Householder reflections, block by block of the points.
fn orthogonal_factor<S: Surface<N, K>, const N: usize, const K: usize>(
    surface: &S,
    x: &[f64; N],
    cloud: &Cloud,
    free: &[usize],
    scale: &[f64],
) -> Factor {
    cloud.gather(Rows { surface, x: *x, free, scale, rows: Vec::new(), right: Vec::new() })
}

/// Weighted rows of the Jacobian of a block, with the distances.
#[derive(Clone)]
struct Rows<'a, S, const N: usize, const K: usize> {
    surface: &'a S,
    x: [f64; N],
    free: &'a [usize],
    scale: &'a [f64],
    rows: Vec<f64>,
    right: Vec<f64>,
}

impl<S: Surface<N, K>, const N: usize, const K: usize> Gather for Rows<'_, S, N, K> {
    type Sum = Factor;

    fn take(&mut self, q: Points, w: F64x8) {
        let root = w.sqrt();
        for (distance, row) in self.surface.distances(&self.x, q) {
            self.right.extend((root * distance).0);
            self.rows.extend((0..LANES).flat_map(|k| self.free.iter().map(move |&j| root.0[k] * row[j].0[k])));
        }
    }

    fn close(self) -> Factor {
        Factor::new(&self.rows, &self.right, self.scale)
    }

    fn join(first: Factor, next: Factor) -> Factor {
        first.stack(next)
    }
}
