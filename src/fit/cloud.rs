//! Preparation of points for computation: checks, shift to the centroid, scaling to size one, and
//! sums over blocks.
//!
//! At 1 m from the origin a double resolves 1e-13 mm; squares of such coordinates would lose
//! everything below 1e-5 mm. The scale is a power of two, so scaling is exact. Points are not
//! copied: every sum is computed by [`Cloud::gather`], block by block in parallel, and combined in
//! the order of the blocks. The result is therefore bit-identical for any number of threads, and
//! memory does not depend on the number of points. Eight points are summed at a time, in registers
//! of the machine's width. Operations are fused exactly where [`F64x8::plus`] is used, and no
//! register width reorders operations, so sums are bit-identical on all machines.

use super::element::{self, Element, FitSettings};
use super::f64x8::{F64x8, LANES, Points, along};
use super::packed::PackedPoints;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, cross, dot, unit};
use etalon_math::symmetric_eigen;
use pulp::Arch;
use rayon::prelude::*;
use std::borrow::Cow;

/// Number of points of the sample from which starts are found. Clouds with more than four times as
/// many points are thinned for the start.
pub(super) const SAMPLE: usize = 1024;
/// Maximum coordinate: squares of larger values overflow (mm).
const LARGEST_MM: f64 = 1e100;

/// Number of points per block; constant, so that sums do not depend on the number of threads.
const BLOCK: usize = 4096;
/// Number of blocks whose sums are held at a time.
const BLOCKS: usize = 256;

/// Accumulator of the points of a block, and combination of the sums of blocks.
pub(super) trait Gather: Clone + Sync {
    /// Sum of a block.
    type Sum: Send;

    /// Adds eight points with their weights. The last group may be padded with copies of a point of
    /// weight zero. To be inlined, so that the accumulator stays in registers.
    fn take(&mut self, q: Points, w: F64x8);

    fn close(self) -> Self::Sum;

    fn join(first: Self::Sum, next: Self::Sum) -> Self::Sum;
}

/// Accumulates nothing.
impl Gather for () {
    type Sum = ();

    #[inline(always)]
    fn take(&mut self, _: Points, _: F64x8) {}

    fn close(self) {}

    fn join((): (), (): ()) {}
}

/// Two accumulators in one pass over the points.
impl<A: Gather, B: Gather> Gather for (A, B) {
    type Sum = (A::Sum, B::Sum);

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        self.0.take(q, w);
        self.1.take(q, w);
    }

    fn close(self) -> Self::Sum {
        (self.0.close(), self.1.close())
    }

    fn join(first: Self::Sum, next: Self::Sum) -> Self::Sum {
        (A::join(first.0, next.0), B::join(first.1, next.1))
    }
}

/// Storage of the coordinates of points.
#[derive(Clone, Debug)]
pub enum Source<'a> {
    /// Points in space (mm).
    Space(Cow<'a, [Vector]>),
    /// Points in a plane (mm).
    Plane(&'a [[f64; 2]]),
    /// Points in space in half the memory.
    Packed(&'a PackedPoints),
}

impl<'a> From<&'a [Vector]> for Source<'a> {
    fn from(points: &'a [Vector]) -> Self {
        Self::Space(points.into())
    }
}

impl<'a> From<&'a Vec<Vector>> for Source<'a> {
    fn from(points: &'a Vec<Vector>) -> Self {
        Self::Space(points.into())
    }
}

impl<'a> From<&'a PackedPoints> for Source<'a> {
    fn from(points: &'a PackedPoints) -> Self {
        Self::Packed(points)
    }
}

impl Source<'_> {
    /// Number of points.
    pub fn len(&self) -> usize {
        match self {
            Self::Space(points) => points.len(),
            Self::Plane(points) => points.len(),
            Self::Packed(points) => points.len(),
        }
    }

    /// `true` if there are no points.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Point `i`; z = 0 for points in a plane.
    pub fn at(&self, i: usize) -> Vector {
        match self {
            Self::Space(points) => points[i],
            Self::Plane(points) => [points[i][0], points[i][1], 0.0],
            Self::Packed(points) => points.at(i),
        }
    }

    /// All points in space (mm), without a copy of points that lie so in memory.
    pub fn in_space(&self) -> Cow<'_, [Vector]> {
        match self {
            Self::Space(points) => Cow::Borrowed(points),
            _ => (0..self.len()).map(|i| self.at(i)).collect(),
        }
    }
}

/// Checked points in normalised coordinates, with their spread.
#[derive(Clone)]
pub(super) struct Cloud<'a> {
    pub(super) source: Source<'a>,
    pub(super) weights: Option<Cow<'a, [f64]>>,
    /// Largest weight, and mean of the weights divided by it.
    weight_unit: [f64; 2],
    /// Weighted centroid (mm).
    pub centre_mm: Vector,
    /// Length of one normalised unit (mm). The largest coordinate difference from the centroid is
    /// between 1/2 and 1 unit.
    pub scale_mm: f64,
    /// Roots of the weighted sums of squares along `axes`, descending.
    pub spread: Vector,
    /// Principal directions, longest first; right-handed.
    pub axes: [Vector; 3],
    /// Stated standard uncertainty of the distance of a point of mean weight, if any.
    pub standard_uncertainty_mm: Option<f64>,
}

impl<'a> Cloud<'a> {
    /// Checks that `points` determine `element`.
    pub fn new(element: Element, points: Source<'a>, settings: &FitSettings<'a>) -> Result<Self> {
        let mut cloud =
            Self::surveyed(element.name(), element.minimum_points(), points, settings.weights, element.rough())?;
        cloud.standard_uncertainty_mm = settings.standard_uncertainty_mm;
        // a held axis or radius needs one dimension less, but at least two about an axis
        let held = usize::from(settings.axis.is_some()).min(element.span() - 1);
        cloud.spans(element.name(), element.span() - held)?;
        Ok(cloud)
    }

    /// Points relative to a given centre, for sums only.
    pub fn about(centre: Vector, points: &'a [Vector]) -> Self {
        Self {
            source: Source::Space(points.into()),
            weights: None,
            weight_unit: [1.0; 2],
            centre_mm: centre,
            scale_mm: 1.0,
            spread: [0.0; 3],
            axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            standard_uncertainty_mm: None,
        }
    }

    /// Checks number and coordinates of points, and computes centroid and spread.
    pub fn centred(name: &str, minimum: usize, source: Source<'a>) -> Result<Self> {
        Self::surveyed(name, minimum, source, None, None)
    }

    /// Computes centroid and spread, from a sample if the sample spans `rough` dimensions;
    /// coordinates are then not checked.
    fn surveyed(
        name: &str,
        minimum: usize,
        source: Source<'a>,
        weights: Option<&'a [f64]>,
        rough: Option<usize>,
    ) -> Result<Self> {
        let count = source.len();
        if count < minimum {
            return Err(error!("too-few-points", count, element = element::name(name), minimum).into());
        }
        let weight_unit = weight_unit(name, count, weights)?;
        let first = if count > 0 { source.at(0) } else { [0.0; 3] };
        let mut cloud = Self { source, weights: weights.map(Cow::Borrowed), weight_unit, ..Self::about(first, &[]) };
        cloud.survey(name, rough)?;
        Ok(cloud)
    }

    /// Computes centre, scale and principal directions: from a sample first, then from all points
    /// along the directions of the sample. A small spread beside a large one is then a sum of
    /// squares of small numbers, and accurate to rounding. (Jacobi's rotations determine the
    /// eigenvalues of a scaled diagonally dominant matrix to relative accuracy: Demmel & Veselić
    /// 1992.)
    fn survey(&mut self, name: &str, rough_dimensions: Option<usize>) -> Result<()> {
        let few = Cloud { weights: None, ..self.thinned(SAMPLE) };
        let rough = few.gather(Survey::along(self.axes));
        // non-finite coordinates are found in the pass over all points
        if rough.is_usable() {
            self.take_up(rough, few.len());
            let wide =
                |dimensions: usize| self.spread[..dimensions].iter().all(|s| *s > 0.1 * self.spread[0] && *s > 0.0);
            if few.len() < self.len() && rough_dimensions.is_some_and(wide) {
                return Ok(());
            }
        }
        for round in 0..3 {
            let all = self.gather(Survey::along(self.axes));
            if round == 0 {
                self.check(name, &all)?;
            }
            if self.take_up(all, self.len()) {
                break;
            }
        }
        Ok(())
    }

    /// Rejects non-finite coordinates and coordinates whose square overflows.
    fn check(&self, name: &str, all: &Surveyed) -> Result<()> {
        let corners = [self.to_mm(all.low), self.to_mm(all.high)];
        if self.len() == 0 || (all.is_usable() && !corners.into_iter().flatten().any(outside)) {
            return Ok(());
        }
        self.numbers(name)
    }

    /// Checks points one by one so that the first invalid point can be named.
    pub fn numbers(&self, name: &str) -> Result<()> {
        let Some(i) = (0..self.len()).find(|&i| self.source.at(i).into_iter().any(outside)) else { return Ok(()) };
        let coordinates = format!("{:?}", self.source.at(i));
        Err(error!("point-not-finite", number = i + 1, element = element::name(name), coordinates).into())
    }

    /// Sets centre, scale and axes from `count` points. Returns `true` if the previous axes were
    /// close enough for spreads that are accurate to rounding.
    fn take_up(&mut self, surveyed: Surveyed, count: usize) -> bool {
        let Surveyed { low, high, sum, products: mut moments } = surveyed;
        let n = count.max(1) as f64;
        let combine =
            |axes: &[Vector; 3], v: &Vector| [0, 1, 2].map(|k| (0..3).map(|i| v[i] * axes[i][k]).sum::<f64>());
        let mean = combine(&self.axes, &sum.map(|s| s / n));
        self.centre_mm = self.to_mm(mean);
        for i in 0..3 {
            for j in i..3 {
                moments[i][j] -= sum[i] * sum[j] / n;
                moments[j][i] = moments[i][j];
            }
        }
        let (values, vectors) = symmetric_eigen(moments);
        let turned = [vectors[2], vectors[1]].map(|v| combine(&self.axes, &v));
        self.axes = orthonormal(turned[0], turned[1]);
        let largest = (0..3).map(|k| (high[k] - mean[k]).max(mean[k] - low[k])).fold(0.0, f64::max) * self.scale_mm;
        let before = self.scale_mm;
        if largest > 0.0 {
            // smaller clouds are rejected as a single point; the scale must have a finite inverse
            self.scale_mm = 2f64.powi(largest.max(1e-290).log2().floor() as i32 + 1);
        }
        self.spread = [values[2], values[1], values[0]].map(|v| v.max(0.0).sqrt() * (before / self.scale_mm));
        // axes with a correlation of up to one half cost a third of the small spread, but no digits
        let apart = |i: usize, j: usize| {
            let product = moments[i][i] * moments[j][j];
            moments[i][j].abs() <= 0.5 * product.sqrt() || moments[i][j].abs() <= 4.0 * f64::EPSILON * values[2]
        };
        self.spread[2] > 1e-2 * self.spread[0] || (apart(0, 1) && apart(0, 2) && apart(1, 2))
    }

    /// Rejects points that span fewer than `dimensions` dimensions: identical, collinear, coplanar.
    pub fn spans(&self, name: &str, dimensions: usize) -> Result<()> {
        // spread by rounding of the coordinates, and by rounding of the sums
        let farthest = self.centre_mm.iter().fold(0.0f64, |m, x| m.max(x.abs())) + self.scale_mm;
        let limit = (8.0 * f64::EPSILON * farthest / self.scale_mm).max(1e-13) * (self.len() as f64).sqrt();
        let spanned = self.spread.iter().filter(|&&s| s > limit).count();
        if spanned >= dimensions && self.scale_mm > 1e-100 {
            return Ok(());
        }
        Err(error!("points-degenerate", element = element::name(name), spanned).into())
    }

    /// Variance of a distance in normalised units: as stated, or of residuals with this weighted
    /// sum of squares; `None` without redundancy.
    pub fn variance(&self, squares: f64, degrees_of_freedom: usize) -> Option<f64> {
        let stated = self.standard_uncertainty_mm.map(|u| (u / self.scale_mm).powi(2));
        stated.or_else(|| (degrees_of_freedom > 0).then(|| squares / degrees_of_freedom as f64))
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.source.len()
    }

    /// Normalised point `i`.
    pub fn point(&self, i: usize) -> Vector {
        let p = self.source.at(i);
        [0, 1, 2].map(|k| (p[k] - self.centre_mm[k]) / self.scale_mm)
    }

    /// All normalised points.
    pub fn points(&self) -> impl Iterator<Item = Vector> {
        (0..self.len()).map(|i| self.point(i))
    }

    /// Weight of point `i`, relative to the mean weight.
    pub fn weight(&self, i: usize) -> f64 {
        self.weights.as_ref().map_or(1.0, |w| w[i] / self.weight_unit[0] / self.weight_unit[1])
    }

    /// Sample of at most `limit` points for a start. Steps by the golden ratio avoid any period of
    /// the scan (points per ring, rings per scan).
    pub fn thinned(&self, limit: usize) -> Cloud<'static> {
        let n = self.len();
        let ratio = (5f64.sqrt() - 1.0) / 2.0;
        let pick = |i: usize| if n <= limit { i } else { ((i as f64 * ratio).fract() * n as f64) as usize };
        let chosen = || (0..n.min(limit)).map(pick);
        Cloud {
            source: Source::Space(chosen().map(|i| self.point(i)).collect()),
            weights: self.weights.is_some().then(|| chosen().map(|i| self.weight(i)).collect()),
            weight_unit: [1.0; 2],
            centre_mm: [0.0; 3],
            scale_mm: 1.0,
            ..*self
        }
    }

    /// Converts a normalised point to millimetres.
    pub fn to_mm(&self, p: Vector) -> Vector {
        let c = self.centre_mm;
        [c[0] + self.scale_mm * p[0], c[1] + self.scale_mm * p[1], c[2] + self.scale_mm * p[2]]
    }
}

fn outside(x: f64) -> bool {
    x.is_nan() || x.abs() > LARGEST_MM
}

/// Unit vectors along `x`, perpendicular to `x` towards `y`, and perpendicular to both.
fn orthonormal(x: Vector, y: Vector) -> [Vector; 3] {
    let x = unit(x).unwrap_or([1.0, 0.0, 0.0]);
    let along = dot(x, y);
    let y = unit([0, 1, 2].map(|k| y[k] - along * x[k])).unwrap_or([0.0, 1.0, 0.0]);
    [x, y, cross(x, y)]
}

/// Largest weight, and mean of the weights divided by it.
fn weight_unit(name: &str, count: usize, weights: Option<&[f64]>) -> Result<[f64; 2]> {
    let Some(weights) = weights else { return Ok([1.0; 2]) };
    let largest = weights.iter().fold(0.0f64, |m, w| m.max(*w));
    let good = weights.len() == count && weights.iter().all(|w| w.is_finite() && *w > 1e-12 * largest && *w > 0.0);
    if !good {
        let element = element::name(name);
        return Err(error!("weights-unusable", weights = weights.len(), element, points = count).into());
    }
    Ok([largest, weights.iter().map(|w| w / largest).sum::<f64>() / count as f64])
}

/// Accumulates bounds of the coordinates, and weighted sums of the coordinates along `axes` and of
/// their products.
#[derive(Clone)]
struct Survey {
    axes: [Vector; 3],
    low: Points,
    high: Points,
    sum: Points,
    products: [Points; 3],
}

/// Result of a [`Survey`].
struct Surveyed {
    low: Vector,
    high: Vector,
    sum: Vector,
    products: [Vector; 3],
}

impl Surveyed {
    /// `true` if all coordinates are finite; non-finite coordinates do not affect the bounds, but
    /// the sums.
    fn is_usable(&self) -> bool {
        self.low.iter().chain(&self.high).chain(&self.sum).all(|x| x.is_finite())
    }
}

impl Survey {
    fn along(axes: [Vector; 3]) -> Self {
        let (low, high) = ([F64x8::all(f64::INFINITY); 3], [F64x8::all(f64::NEG_INFINITY); 3]);
        Self { axes, low, high, sum: Points::default(), products: Default::default() }
    }
}

impl Gather for Survey {
    type Sum = Surveyed;

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        let [a, b, c] = self.axes;
        let [x, y, z] = [along(q, a), along(q, b), along(q, c)];
        let [wx, wy, wz] = [w * x, w * y, w * z];
        self.low = [self.low[0].min(q[0]), self.low[1].min(q[1]), self.low[2].min(q[2])];
        self.high = [self.high[0].max(q[0]), self.high[1].max(q[1]), self.high[2].max(q[2])];
        self.sum = [self.sum[0] + wx, self.sum[1] + wy, self.sum[2] + wz];
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = &mut self.products;
        (*xx, *xy, *xz) = (xx.plus(wx, x), xy.plus(wx, y), xz.plus(wx, z));
        (*yy, *yz, *zz) = (yy.plus(wy, y), yz.plus(wy, z), zz.plus(wz, z));
    }

    fn close(self) -> Surveyed {
        Surveyed {
            low: self.low.map(F64x8::least),
            high: self.high.map(F64x8::most),
            sum: self.sum.map(F64x8::sum),
            products: self.products.map(|row| row.map(F64x8::sum)),
        }
    }

    fn join(a: Surveyed, b: Surveyed) -> Surveyed {
        let each = |f: fn(f64, f64) -> f64, x: Vector, y: Vector| [0, 1, 2].map(|k| f(x[k], y[k]));
        let add = |x, y| each(|x, y| x + y, x, y);
        Surveyed {
            low: each(f64::min, a.low, b.low),
            high: each(f64::max, a.high, b.high),
            sum: add(a.sum, b.sum),
            products: [0, 1, 2].map(|i| add(a.products[i], b.products[i])),
        }
    }
}

impl Cloud<'_> {
    /// Accumulates all normalised points, with a copy of `start` for each block; sums are combined
    /// in the order of the points.
    pub fn gather<G: Gather>(&self, start: G) -> G::Sum {
        let machine = Arch::new();
        let block = |k: usize| {
            let range = k * BLOCK..self.len().min((k + 1) * BLOCK);
            // a single layout for all sources: sums are compiled once for each kind of machine
            let points: Cow<[Vector]> = match &self.source {
                Source::Space(points) => Cow::Borrowed(&points[range.clone()]),
                Source::Plane(points) => points[range.clone()].iter().map(|&[x, y]| [x, y, 0.0]).collect(),
                Source::Packed(points) => Cow::Owned(points.range(range.clone())),
            };
            let gathered = start.clone();
            machine.dispatch(
                #[inline(always)]
                || self.pass(range.start, &points, gathered),
            )
        };
        let blocks = self.len().div_ceil(BLOCK);
        if blocks <= 1 {
            return block(0);
        }
        let joined = (0..blocks).step_by(BLOCKS).filter_map(|from| {
            let sums: Vec<G::Sum> = (from..blocks.min(from + BLOCKS)).into_par_iter().map(block).collect();
            sums.into_iter().reduce(G::join)
        });
        joined.reduce(G::join).unwrap_or_else(|| start.clone().close())
    }

    /// Normalises `points` in groups of eight; the first is number `first`.
    #[inline(always)]
    fn pass<G: Gather>(&self, first: usize, points: &[Vector], mut gathered: G) -> G::Sum {
        let (centre, factor) = (self.centre_mm, 1.0 / self.scale_mm);
        // without weights, multiplying by one is omitted
        let plain = if self.weights.is_some() { 0 } else { points.len() / LANES * LANES };
        for eight in points[..plain].as_chunks::<LANES>().0 {
            let mut group = Points::default();
            for k in 0..3 {
                group[k] = (F64x8(eight.map(|p| p[k])) - centre[k]) * factor;
            }
            gathered.take(group, F64x8::all(1.0));
        }
        for from in (plain..points.len()).step_by(LANES) {
            let (mut group, mut weights) = (Points::default(), F64x8::default());
            for i in 0..LANES {
                let p = points[(from + i).min(points.len() - 1)];
                for k in 0..3 {
                    group[k].0[i] = (p[k] - centre[k]) * factor;
                }
                if from + i < points.len() {
                    weights.0[i] = self.weight(first + from + i);
                }
            }
            gathered.take(group, weights);
        }
        gathered.close()
    }
}
