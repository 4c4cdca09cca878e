//! From a start to the minimum: Gauss-Newton in a trust region, one look at all points a step.
//!
//! The points pass by in blocks and leave only the sums of the normal equations, so the memory needed does not depend on
//! their number. Centred, scaled and seen along the element's own axis, the problem is well conditioned, and
//! the accuracy of the answer is that of the gradient and not of the factor that divides it. Where the normal equations
//! do lose digits (short arcs), the points pass by again, into an orthogonal factor.
//!
//! That is why this is not [`math::solve`](crate::math::solve), which keeps a row for every equation and its parameters in
//! one chart: a million points would need gigabytes, and a cylinder's axis would leave the middle of its chart. Factor and
//! trust region are the same.
//!
//! After each step the chart is laid about the element anew, so a surface need only know its derivatives in
//! the middle of its chart (as NPL's LSGE turns the axis to z in each iteration).

use super::cloud::Cloud;
use super::f64x8::{F64x8, LANES, Points};
use super::stream::Gather;
use super::surface::Surface;
use crate::math::solve::{Factor, Termination, trust_region_step};

/// Points that a start is found from; of four times as many, not all are looked at before the start is good.
pub(super) const SAMPLE: usize = 1024;
/// Points that make it good, at most, and how many there are for one of them.
const LARGEST_SAMPLE: usize = 16_384;
const THINNED: usize = 32;
/// Below this pivot of the scaled normal equations a step from them has fewer than six digits.
const LEAST_PIVOT: f64 = 1e-9;
/// Step, relative to the parameters, below which they no longer change.
const STEP: f64 = f64::EPSILON;
/// Cosine between residuals and Jacobian below which they are orthogonal.
const GRADIENT: f64 = 1e-15;
/// Iterations of a fit; a search looks at its starts with fewer.
pub(super) const ITERATIONS: usize = 2000;

/// Where least squares ended.
pub(super) struct Refined<S, const N: usize> {
    pub surface: S,
    pub x: [f64; N],
    /// Sum of the weighted squares of the distances.
    pub cost: f64,
    /// Indices of the parameters that were free.
    pub free: Vec<usize>,
    /// Factor of the Jacobian by these, its columns divided by `scale`.
    pub factor: Option<Factor>,
    pub scale: Vec<f64>,
    /// Weighted sums of the products of derivatives, by all parameters.
    pub products: [[f64; N]; N],
    pub iterations: usize,
    pub termination: Termination,
}

/// Minimises the sum of squared distances from `start`, the parameters marked in `free` moving.
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

/// [`refine`] on all points from the first step, with at most so many iterations.
pub(super) fn descend<S: Surface<N, K>, const N: usize, const K: usize>(
    surface: S,
    cloud: &Cloud,
    start: [f64; N],
    free: [bool; N],
    iterations: usize,
) -> Refined<S, N> {
    let free: Vec<usize> = (0..N).filter(|&i| free[i]).collect();
    let (surface, x) = surface.recharted(&start);
    let (cost, linear) = linearise(&surface, &x, cloud, &free);
    let mut here = Refined {
        surface,
        x,
        cost,
        free,
        scale: Vec::new(),
        factor: None,
        products: [[0.0; N]; N],
        iterations: 0,
        termination: Termination::LostPatience,
    };
    if K * cloud.len() < here.free.len() {
        here.termination = Termination::TooFewEquations;
        return here;
    }
    here.take(linear);
    let (mut radius, mut damping, mut last) = (f64::NAN, 0.0, f64::INFINITY);
    while here.iterations < iterations {
        let Some(factor) = here.factor.as_ref().filter(|_| here.cost.is_finite()) else {
            here.termination = Termination::NotANumber;
            break;
        };
        if here.cost == 0.0 {
            here.termination = Termination::ResidualsZero;
            break;
        }
        if norm(&factor.qtb) <= GRADIENT * here.cost.sqrt() {
            here.termination = Termination::GradientVanished;
            break;
        }
        let extent = norm(&here.free.iter().zip(&here.scale).map(|(&i, d)| here.x[i] * d).collect::<Vec<_>>());
        if radius.is_nan() {
            radius = if extent > 0.0 { extent } else { 1.0 };
        }
        let Some((p, used)) = trust_region_step(factor, radius, damping) else {
            here.termination = Termination::RankDeficient;
            break;
        };
        damping = used;
        let length = norm(&p);
        let size = length / (extent + f64::MIN_POSITIVE);
        if used == 0.0 && size >= last && last < 1e-6 {
            // steps are rounding
            here.termination = Termination::StepVanished;
            break;
        }
        let mut trial = here.x;
        for ((&i, p), d) in here.free.iter().zip(&p).zip(&here.scale) {
            trial[i] -= p / d;
        }
        let (surface, trial) = here.surface.recharted(&trial);
        // what the next step would be: steps shrink as the last ones did, and no faster than residuals bend the way
        let bend = (here.cost / cloud.len() as f64).sqrt();
        // (those of many points that are noise, and not form, make up for each other: √n of them are left of n)
        let noise = bend / (cloud.len() as f64).sqrt();
        let left = size * f64::max(size / last, noise);
        if used == 0.0 && left <= STEP && size * bend <= 16.0 * STEP && size < 1e-6 {
            // no look at the points is needed to know what is left: the linear model is exact for such a step
            (here.surface, here.x, here.cost) = (surface, trial, factor.rest);
            here.iterations += 1;
            here.termination = Termination::StepVanished;
            break;
        }
        let (cost, linear) = linearise(&surface, &trial, cloud, &here.free);
        // decrease of the linear model: ‖r‖² − ‖r − J p‖² = ‖R p‖² + 2 λ ‖p‖² for this p (Moré 1978, eq. 4.5)
        let slope = norm(&factor.multiply(&p)).powi(2);
        let predicted = slope + 2.0 * damping * length * length;
        let ratio = if cost.is_finite() { (here.cost - cost) / predicted } else { f64::NEG_INFINITY };
        // near the minimum the cost is too flat to judge a step: there it is enough that steps shrink
        let close = used == 0.0 && size < 1e-6 && size < last && cost <= here.cost * (1.0 + 1e-6);
        if close {
            radius = 2.0 * length;
        } else if ratio < 0.25 {
            let shorten = if ratio >= 0.0 { 0.5 } else { 0.1 };
            radius = shorten * radius.min(10.0 * length);
            damping /= shorten;
        } else if damping == 0.0 || ratio >= 0.75 {
            radius = 2.0 * length;
            damping *= 0.5;
        }
        if close || ratio > 1e-4 {
            (here.surface, here.x, here.cost) = (surface, trial, cost);
            here.take(linear);
            here.iterations += 1;
            last = if used == 0.0 { size } else { f64::INFINITY };
        } else if size < 1e-8 || !radius.is_normal() {
            here.termination = Termination::NoImprovementPossible;
            break;
        }
    }
    here
}

impl<S, const N: usize> Refined<S, N> {
    fn take(&mut self, linear: Linear<N>) {
        (self.factor, self.scale, self.products) = (linear.factor, linear.scale, linear.products);
    }
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The same for each index below a constant of at most seven, written out before the compiler looks for loops: it would
/// otherwise take the sums apart and keep them in memory.
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

/// Sums over the points of the products of derivatives, of derivative and distance, and of distances.
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

/// The Jacobian, as what is left of it: sums of products by all parameters, and the factor by the free ones with the norms
/// of its columns. No factor where a number in it is not finite.
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

/// The factor by Householder reflections, block by block of the points.
fn orthogonal_factor<S: Surface<N, K>, const N: usize, const K: usize>(
    surface: &S,
    x: &[f64; N],
    cloud: &Cloud,
    free: &[usize],
    scale: &[f64],
) -> Factor {
    cloud.gather(Rows { surface, x: *x, free, scale, rows: Vec::new(), right: Vec::new() })
}

/// The rows of the Jacobian of a block, weighted, and the distances.
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
