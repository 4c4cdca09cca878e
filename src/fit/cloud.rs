//! Points made fit for computing: checked, shifted to their centroid, scaled to size one.
//!
//! At 1 m from the origin a double has 1e-13 mm left; squares of such coordinates would have lost everything below
//! 1e-5 mm. The scale is a power of two, so scaling rounds nothing.

use super::element::{Element, Settings, refuse};
use crate::message::Result;
use crate::pose::{Vector, minus};
use crate::solve::{Factor, svd};

/// Coordinates beyond this have squares that no double holds; nothing on a robot is 1e97 km away.
const LARGEST_MM: f64 = 1e100;

/// Checked points in normalised coordinates, with what their spread says.
pub(super) struct Cloud {
    /// Weighted centroid, in mm.
    pub centre_mm: Vector,
    /// Millimetres in one unit of `points`.
    pub scale_mm: f64,
    /// The points about the centroid, the farthest between 1/2 and 1 away from it in some coordinate.
    pub points: Vec<Vector>,
    /// Square roots of the weights, their squares with mean one; empty where all weigh the same.
    pub roots: Vec<f64>,
    /// Root of the weighted sum of squares along `axes`, descending.
    pub spread: Vector,
    /// Principal directions, the longest first; right-handed is not promised.
    pub axes: [Vector; 3],
}

impl Cloud {
    /// Checks that `points` determine `element`.
    pub fn new(element: Element, points: &[Vector], settings: &Settings) -> Result<Self> {
        let cloud = Self::centred(element.name(), element.minimum_points(), points, settings.weights)?;
        // an axis that is held, or a radius, asks for less; two dimensions are still needed about an axis
        let held = usize::from(settings.axis.is_some()).min(element.span() - 1);
        cloud.spans(element, element.span() - held, points)?;
        Ok(cloud)
    }

    /// Checks count, numbers and weights, and finds centroid and spread.
    pub fn centred(name: &str, minimum: usize, points: &[Vector], weights: Option<&[f64]>) -> Result<Self> {
        if points.len() < minimum {
            return Err(refuse(
                format!(
                    "{} {} given for a {name}",
                    points.len(),
                    if points.len() == 1 { "point is" } else { "points are" }
                ),
                format!("at least {minimum} points"),
                "measure more points, or name the ones that belong to the feature",
            ));
        }
        if let Some(i) = points.iter().position(|p| !p.iter().all(|x| x.abs() <= LARGEST_MM)) {
            let shown = points.get(i).copied().unwrap_or_default();
            return Err(refuse(
                format!("point {} of the {name} is {shown:?}", i + 1),
                "finite coordinates in millimetres",
                "look at this point in the export",
            ));
        }
        let roots = roots_of(name, points.len(), weights)?;
        let centre_mm = centroid(points, &roots);
        let largest = points.iter().flat_map(|&p| minus(p, centre_mm)).fold(0.0f64, |m, x| m.max(x.abs()));
        let scale_mm = if largest > 0.0 { 2f64.powi(largest.log2().floor() as i32 + 1) } else { 1.0 };
        let points: Vec<Vector> = points.iter().map(|&p| minus(p, centre_mm).map(|x| x / scale_mm)).collect();
        let mut rows: Vec<f64> = points.iter().flatten().copied().collect();
        for (row, root) in rows.chunks_exact_mut(3).zip(&roots) {
            row.iter_mut().for_each(|x| *x *= root);
        }
        let principal = svd(&Factor::new(&rows, &vec![0.0; points.len()], &[1.0; 3]));
        let take = |k: usize| principal.vectors.get(k).and_then(|v| v.first_chunk::<3>()).copied().unwrap_or_default();
        let spread = [0, 1, 2].map(|k| principal.values.get(k).copied().unwrap_or(0.0));
        Ok(Self { centre_mm, scale_mm, points, roots, spread, axes: [take(0), take(1), take(2)] })
    }

    /// Refuses points that span fewer than `dimensions`: identical, on a line, in a plane.
    pub fn spans(&self, name: impl std::fmt::Display, dimensions: usize, points_mm: &[Vector]) -> Result<()> {
        // what rounding of the coordinates alone can spread, and what rounding of the sums can
        let farthest = points_mm.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let limit = (8.0 * f64::EPSILON * farthest / self.scale_mm).max(1e-13) * (self.points.len() as f64).sqrt();
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

    /// Weight of point `i`, as its square root.
    pub fn root(&self, i: usize) -> f64 {
        self.roots.get(i).copied().unwrap_or(1.0)
    }

    /// At most `limit` of the points: enough to look for a start. The golden ratio steps through their order, so that
    /// no rhythm of the scan (points a ring, rings a scan) is met.
    pub fn thinned(&self, limit: usize) -> Self {
        let n = self.points.len();
        let ratio = (5f64.sqrt() - 1.0) / 2.0;
        let pick = |i: usize| if n <= limit { i } else { ((i as f64 * ratio).fract() * n as f64) as usize };
        let chosen = || (0..n.min(limit)).map(pick);
        Self {
            points: chosen().filter_map(|i| self.points.get(i).copied()).collect(),
            roots: chosen().filter_map(|i| self.roots.get(i).copied()).collect(),
            ..*self
        }
    }

    /// Normalised point to millimetres.
    pub fn to_mm(&self, p: Vector) -> Vector {
        let c = self.centre_mm;
        [c[0] + self.scale_mm * p[0], c[1] + self.scale_mm * p[1], c[2] + self.scale_mm * p[2]]
    }
}

fn roots_of(name: &str, count: usize, weights: Option<&[f64]>) -> Result<Vec<f64>> {
    let Some(weights) = weights else { return Ok(Vec::new()) };
    let largest = weights.iter().fold(0.0f64, |m, w| m.max(*w));
    let good = weights.len() == count && weights.iter().all(|w| w.is_finite() && *w > 1e-12 * largest && *w > 0.0);
    if !good {
        return Err(refuse(
            format!("the {} weights of the {name} do not fit its {count} points", weights.len()),
            "one positive finite weight for each point, within a factor 1e12 of each other",
            "use 1/u² of each point; leave a point out instead of giving it no weight",
        ));
    }
    let mean = weights.iter().map(|w| w / largest).sum::<f64>() / count as f64;
    Ok(weights.iter().map(|w| (w / largest / mean).sqrt()).collect())
}

/// Weighted mean, corrected once by the mean of what is left: right to rounding for any number of points.
fn centroid(points: &[Vector], roots: &[f64]) -> Vector {
    let mean_about = |c: Vector| {
        let mut sum = [0.0; 3];
        for (i, &p) in points.iter().enumerate() {
            let w = roots.get(i).map_or(1.0, |r| r * r);
            for (s, x) in sum.iter_mut().zip(minus(p, c)) {
                *s += w * x;
            }
        }
        let n = points.len().max(1) as f64;
        [c[0] + sum[0] / n, c[1] + sum[1] / n, c[2] + sum[2] / n]
    };
    mean_about(mean_about(points.first().copied().unwrap_or_default()))
}
