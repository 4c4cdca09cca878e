//! Points made fit for computing: checked, shifted to their centroid, scaled to size one, and given out in blocks.
//!
//! At 1 m from the origin a double has 1e-13 mm left; squares of such coordinates would have lost everything below
//! 1e-5 mm. The scale is a power of two, so scaling rounds nothing. No copy of the points is made: every sum over them
//! goes through [`Cloud::gather`], block by block in parallel and put together in the order of the blocks, so that it has
//! the same bytes for any number of threads and needs the same memory for any number of points.

use super::element::{Element, Settings, refuse};
use super::lanes::{Lanes, Points, along};
use super::stream::Gather;
use crate::message::Result;
use crate::pose::{Vector, cross, dot, unit};
use crate::solve::symmetric_eigen;
use std::borrow::Cow;

/// Coordinates beyond this have squares that no double holds; nothing on a robot is 1e97 km away.
const LARGEST_MM: f64 = 1e100;

/// Where the coordinates of points lie.
#[derive(Clone)]
pub(super) enum Source<'a> {
    Space(Cow<'a, [Vector]>),
    Plane(&'a [[f64; 2]]),
}

impl Source<'_> {
    fn len(&self) -> usize {
        match self {
            Self::Space(points) => points.len(),
            Self::Plane(points) => points.len(),
        }
    }

    fn at(&self, i: usize) -> Vector {
        match self {
            Self::Space(points) => points[i],
            Self::Plane(points) => [points[i][0], points[i][1], 0.0],
        }
    }
}

/// Checked points, to be seen in normalised coordinates, with what their spread says.
#[derive(Clone)]
pub(super) struct Cloud<'a> {
    pub(super) source: Source<'a>,
    pub(super) weights: Option<Cow<'a, [f64]>>,
    /// The largest weight, and the mean of the weights divided by it.
    weight_unit: [f64; 2],
    /// Weighted centroid, in mm.
    pub centre_mm: Vector,
    /// Millimetres in one unit of the normalised points: the farthest is between 1/2 and 1 away from the centroid in
    /// some coordinate.
    pub scale_mm: f64,
    /// Root of the weighted sum of squares along `axes`, descending.
    pub spread: Vector,
    /// Principal directions, the longest first; right-handed.
    pub axes: [Vector; 3],
}

impl<'a> Cloud<'a> {
    /// Checks that `points` determine `element`.
    pub fn new(element: Element, points: Source<'a>, settings: &Settings<'a>) -> Result<Self> {
        let cloud = Self::centred(element.name(), element.minimum_points(), points, settings.weights)?;
        // an axis that is held, or a radius, asks for less; two dimensions are still needed about an axis
        let held = usize::from(settings.axis.is_some()).min(element.span() - 1);
        cloud.spans(element, element.span() - held)?;
        Ok(cloud)
    }

    /// Checks count, numbers and weights, and finds centroid and spread.
    pub fn centred(name: &str, minimum: usize, source: Source<'a>, weights: Option<&'a [f64]>) -> Result<Self> {
        let count = source.len();
        if count < minimum {
            return Err(refuse(
                format!("{} {} given for a {name}", count, if count == 1 { "point is" } else { "points are" }),
                format!("at least {minimum} points"),
                "measure more points, or name the ones that belong to the feature",
            ));
        }
        let weight_unit = weight_unit(name, count, weights)?;
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let first = if count > 0 { source.at(0) } else { [0.0; 3] };
        let weights = weights.map(Cow::Borrowed);
        let (scale_mm, spread) = (1.0, [0.0; 3]);
        let mut cloud = Self { source, weights, weight_unit, centre_mm: first, scale_mm, spread, axes };
        let [low, high, sum] = cloud.gather(Bounds::default());
        // a coordinate that is not a number is in no bounds, but in the sum
        let outside = |x: f64| x.is_nan() || x.abs() > LARGEST_MM;
        let finite = (0..3).all(|k| !outside(first[k] + low[k]) && !outside(first[k] + high[k]) && !sum[k].is_nan());
        if count > 0 && !finite {
            let i = (0..count).find(|&i| cloud.source.at(i).into_iter().any(outside)).unwrap_or_default();
            return Err(refuse(
                format!("point {} of the {name} is {:?}", i + 1, cloud.source.at(i)),
                "finite coordinates in millimetres",
                "look at this point in the export",
            ));
        }
        let mean = sum.map(|s| s / count.max(1) as f64);
        cloud.centre_mm = [0, 1, 2].map(|k| first[k] + mean[k]);
        let largest = (0..3).map(|k| (high[k] - mean[k]).max(mean[k] - low[k])).fold(0.0, f64::max);
        if largest > 0.0 {
            // what is smaller is refused as one point, and its scale must have an inverse
            cloud.scale_mm = 2f64.powi(largest.max(1e-290).log2().floor() as i32 + 1);
        }
        cloud.find_axes();
        Ok(cloud)
    }

    /// Principal directions from the moments of the points, found again along the directions just found: a spread that
    /// is small against another is then a sum of squares of small numbers, and right to rounding (a graded matrix has
    /// its eigenvalues from Jacobi's rotations to relative accuracy: Demmel & Veselić 1992).
    fn find_axes(&mut self) {
        for round in 0..3 {
            let axes = self.axes;
            let moments = self.gather(Moments { axes, products: Default::default(), sum: Default::default() });
            self.take_up(moments);
            let off = |i: usize, j: usize| moments.0[i][j].abs() > 1e-7 * self.spread[0] * self.spread[1];
            let turned = round == 0 || off(0, 1) || off(0, 2) || off(1, 2);
            if self.spread[2] > 1e-2 * self.spread[0] || !turned {
                break;
            }
        }
    }

    /// Turns the axes by what the moments along them say, and takes up what is left of the centroid.
    fn take_up(&mut self, (mut moments, sum): ([[f64; 3]; 3], Vector)) {
        let n = self.len().max(1) as f64;
        let combine =
            |axes: &[Vector; 3], v: &Vector| [0, 1, 2].map(|k| (0..3).map(|i| v[i] * axes[i][k]).sum::<f64>());
        let left = combine(&self.axes, &sum.map(|s| s / n));
        self.centre_mm = self.to_mm(left);
        for i in 0..3 {
            for j in i..3 {
                moments[i][j] -= sum[i] * sum[j] / n;
                moments[j][i] = moments[i][j];
            }
        }
        let (values, vectors) = symmetric_eigen(moments);
        let turned = [vectors[2], vectors[1]].map(|v| combine(&self.axes, &v));
        self.spread = [values[2], values[1], values[0]].map(|v| v.max(0.0).sqrt());
        self.axes = orthonormal(turned[0], turned[1]);
    }

    /// Refuses points that span fewer than `dimensions`: identical, on a line, in a plane.
    pub fn spans(&self, name: impl std::fmt::Display, dimensions: usize) -> Result<()> {
        // what rounding of the coordinates alone can spread, and what rounding of the sums can
        let farthest = self.centre_mm.iter().fold(0.0f64, |m, x| m.max(x.abs())) + self.scale_mm;
        let limit = (8.0 * f64::EPSILON * farthest / self.scale_mm).max(1e-13) * (self.len() as f64).sqrt();
        let spanned = self.spread.iter().filter(|&&s| s > limit).count();
        if spanned >= dimensions && self.scale_mm > 1e-100 {
            return Ok(());
        }
        let (what, expected) = match spanned {
            0 => ("all points are identical", "points apart from each other"),
            1 => ("all points lie on one line", "points that are not on one line"),
            _ => ("all points lie in one plane", "points that are not in one plane"),
        };
        Err(refuse(format!("no {name} can be fitted: {what}"), expected, "spread the points over the feature"))
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.source.len()
    }

    /// Point `i`, normalised.
    pub fn point(&self, i: usize) -> Vector {
        let p = self.source.at(i);
        [0, 1, 2].map(|k| (p[k] - self.centre_mm[k]) / self.scale_mm)
    }

    /// All points, normalised.
    pub fn points(&self) -> impl Iterator<Item = Vector> {
        (0..self.len()).map(|i| self.point(i))
    }

    /// Weight of point `i`; the mean of the weights is one.
    pub fn weight(&self, i: usize) -> f64 {
        self.weights.as_ref().map_or(1.0, |w| w[i] / self.weight_unit[0] / self.weight_unit[1])
    }

    /// At most `limit` of the points: enough to look for a start. The golden ratio steps through their order, so that
    /// no rhythm of the scan (points a ring, rings a scan) is met.
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

    /// Normalised point to millimetres.
    pub fn to_mm(&self, p: Vector) -> Vector {
        let c = self.centre_mm;
        [c[0] + self.scale_mm * p[0], c[1] + self.scale_mm * p[1], c[2] + self.scale_mm * p[2]]
    }
}

/// Unit vectors along `x`, across it towards `y`, and square to both.
fn orthonormal(x: Vector, y: Vector) -> [Vector; 3] {
    let x = unit(x).unwrap_or([1.0, 0.0, 0.0]);
    let along = dot(x, y);
    let y = unit([0, 1, 2].map(|k| y[k] - along * x[k])).unwrap_or([0.0, 1.0, 0.0]);
    [x, y, cross(x, y)]
}

/// The largest weight, and the mean of the weights divided by it.
fn weight_unit(name: &str, count: usize, weights: Option<&[f64]>) -> Result<[f64; 2]> {
    let Some(weights) = weights else { return Ok([1.0; 2]) };
    let largest = weights.iter().fold(0.0f64, |m, w| m.max(*w));
    let good = weights.len() == count && weights.iter().all(|w| w.is_finite() && *w > 1e-12 * largest && *w > 0.0);
    if !good {
        return Err(refuse(
            format!("the {} weights of the {name} do not fit its {count} points", weights.len()),
            "one positive finite weight for each point, within a factor 1e12 of each other",
            "use 1/u² of each point; leave a point out instead of giving it no weight",
        ));
    }
    Ok([largest, weights.iter().map(|w| w / largest).sum::<f64>() / count as f64])
}

/// Smallest and largest coordinates and weighted sum of them, all as differences from `centre_mm`.
#[derive(Clone)]
struct Bounds {
    low: Points,
    high: Points,
    sum: Points,
}

impl Default for Bounds {
    fn default() -> Self {
        let (low, high) = ([Lanes::all(f64::INFINITY); 3], [Lanes::all(f64::NEG_INFINITY); 3]);
        Self { low, high, sum: Points::default() }
    }
}

impl Gather for Bounds {
    type Sum = [Vector; 3];

    #[inline(always)]
    fn take(&mut self, q: Points, w: Lanes) {
        for (k, q) in q.into_iter().enumerate() {
            self.low[k] = self.low[k].min(q);
            self.high[k] = self.high[k].max(q);
            self.sum[k] = self.sum[k] + w * q;
        }
    }

    fn close(self) -> Self::Sum {
        [self.low.map(Lanes::least), self.high.map(Lanes::most), self.sum.map(Lanes::sum)]
    }

    fn join([a, b, c]: Self::Sum, [low, high, sum]: Self::Sum) -> Self::Sum {
        let each = |f: fn(f64, f64) -> f64, x: Vector, y: Vector| [0, 1, 2].map(|k| f(x[k], y[k]));
        [each(f64::min, a, low), each(f64::max, b, high), each(|x, y| x + y, c, sum)]
    }
}

/// Weighted sums of coordinates along `axes` and of their products.
#[derive(Clone)]
struct Moments {
    axes: [Vector; 3],
    products: [[Lanes; 3]; 3],
    sum: [Lanes; 3],
}

impl Gather for Moments {
    type Sum = ([[f64; 3]; 3], Vector);

    #[inline(always)]
    fn take(&mut self, q: Points, w: Lanes) {
        let [a, b, c] = self.axes;
        let q = [along(q, a), along(q, b), along(q, c)];
        for i in 0..3 {
            let weighted = w * q[i];
            self.sum[i] = self.sum[i] + weighted;
            for (product, other) in self.products[i][i..].iter_mut().zip(&q[i..]) {
                *product = *product + weighted * *other;
            }
        }
    }

    fn close(self) -> Self::Sum {
        (self.products.map(|row| row.map(Lanes::sum)), self.sum.map(Lanes::sum))
    }

    fn join(a: Self::Sum, b: Self::Sum) -> Self::Sum {
        let products = [0, 1, 2].map(|i| [0, 1, 2].map(|j| a.0[i][j] + b.0[i][j]));
        (products, [0, 1, 2].map(|i| a.1[i] + b.1[i]))
    }
}
