//! Smallest enclosing circle and sphere, exact to rounding.
//!
//! The farthest point outside the ball is added to the support points, and the smallest ball of
//! these at most five points is found by trying every subset (pivot rule of Gärtner 1999, "Fast and
//! robust smallest enclosing balls", ESA'99, with enumeration instead of Welzl's recursion of
//! 1991). The radius grows in every step, so the algorithm terminates, without recursion or
//! shuffling. Four corners of a square determine the centre in the third direction to 1e-9 only;
//! therefore subsets are judged, and near ties decided, in 106 bits.

use crate::cloud::{Cloud, Source};
use crate::double_double::{DoubleDouble, DoubleDoubleVector, dot, exact, minus, plus_times};
use etalon_base::message::Result;
use etalon_base::pose::Vector;

/// A smallest enclosing circle or sphere.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosing {
    /// Centre; z is zero for a circle in the plane.
    pub center_mm: Vector,
    /// Radius: distance of the farthest point.
    pub radius_mm: f64,
    /// Indices of the support points, ascending: one (all points identical) to four.
    pub support: Vec<usize>,
    /// Number of points that were added to the support.
    pub iterations: usize,
}

/// Finds the smallest circle that encloses all points of the plane; at least one point is needed.
pub fn enclosing_circle(points: &[[f64; 2]]) -> Result<Enclosing> {
    let lifted: Vec<Vector> = points.iter().map(|p| [p[0], p[1], 0.0]).collect();
    let cloud = Cloud::centred("enclosing-circle", 1, Source::Plane(points))?;
    Ok(smallest(&lifted, &cloud, 3))
}

/// Finds the smallest sphere that encloses all points; at least one point is needed.
pub fn enclosing_sphere(points: &[Vector]) -> Result<Enclosing> {
    let cloud = Cloud::centred("enclosing-sphere", 1, Source::Space(points.into()))?;
    Ok(smallest(points, &cloud, 4))
}

/// Maximum number of steps that leave the radius unchanged; 106 bits decide nearly everything, this
/// limit the rest. Smaller radii cannot return, so the algorithm terminates.
const STALLS: usize = 20;

struct Ball {
    center: DoubleDoubleVector,
    /// Squared distance of the farthest of the points for which the ball was found.
    squared: DoubleDouble,
    support: Vec<usize>,
}

/// Finds the smallest ball; `most` is the maximum number of support points: dimension plus one.
fn smallest(points_mm: &[Vector], cloud: &Cloud, most: usize) -> Enclosing {
    // scaling by a power of two is exact, a shift to the centroid would not be
    let points: Vec<Vector> = points_mm.iter().map(|p| p.map(|x| x / cloud.scale_mm)).collect();
    let middle = exact(cloud.centre_mm.map(|x| x / cloud.scale_mm));
    let first = farthest(&points, middle).map_or(0, |(i, _)| i);
    let mut ball = Ball { center: point(&points, first), squared: DoubleDouble::default(), support: vec![first] };
    let (mut iterations, mut stalled) = (0, 0);
    let mut best: Option<(DoubleDouble, DoubleDoubleVector, Vec<usize>)> = None;
    while let Some((outside, reach)) = farthest(&points, ball.center) {
        if best.as_ref().is_none_or(|b| reach < b.0) {
            best = Some((reach, ball.center, ball.support.clone()));
        }
        if reach <= ball.squared || ball.support.contains(&outside) || stalled > STALLS {
            break;
        }
        ball.support.push(outside);
        let larger = by_subsets(&points, &ball.support, most);
        stalled += usize::from(larger.squared <= ball.squared);
        ball = larger;
        iterations += 1;
    }
    let (reach, center, mut support) = best.unwrap_or((ball.squared, ball.center, ball.support));
    support.sort_unstable();
    Enclosing {
        center_mm: center.map(|x| x.hi * cloud.scale_mm),
        radius_mm: reach.hi.sqrt() * cloud.scale_mm,
        support,
        iterations,
    }
}

fn point(points: &[Vector], i: usize) -> DoubleDoubleVector {
    exact(points.get(i).copied().unwrap_or_default())
}

/// Index and squared distance of the point farthest from `center`: found in doubles, ties within
/// rounding are decided in 106 bits.
fn farthest(points: &[Vector], center: DoubleDoubleVector) -> Option<(usize, DoubleDouble)> {
    let c = center.map(|x| x.hi);
    let rough = |p: &Vector| (p[0] - c[0]).powi(2) + (p[1] - c[1]).powi(2) + (p[2] - c[2]).powi(2);
    let largest = points.iter().map(rough).fold(0.0, f64::max);
    // a coordinate difference has an error of half a unit of the coordinates, independent of the
    // size of the ball
    let size = points.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    let doubt = 16.0 * f64::EPSILON * (largest + size * largest.sqrt()) + (4.0 * f64::EPSILON * size).powi(2);
    let close = points.iter().enumerate().filter(|(_, p)| rough(p) >= largest - doubt);
    let measured = close.map(|(i, &p)| (i, squared_distance(exact(p), center)));
    measured.reduce(|best, next| if next.1 > best.1 { next } else { best })
}

fn squared_distance(p: DoubleDoubleVector, q: DoubleDoubleVector) -> DoubleDouble {
    let w = minus(p, q);
    dot(w, w)
}

/// Smallest ball of at most five points: among the balls through each subset, the one with the
/// smallest distance of its centre to the farthest point. The true centre is among the candidates,
/// and each candidate is judged by the points that it encloses.
fn by_subsets(points: &[Vector], joined: &[usize], most: usize) -> Ball {
    let nowhere = [DoubleDouble::default(); 3];
    let mut best = Ball { center: nowhere, squared: DoubleDouble::from(f64::INFINITY), support: joined.to_vec() };
    for size in 1..=most {
        for mask in (1u32..1 << joined.len()).filter(|mask| mask.count_ones() as usize == size) {
            let support: Vec<usize> =
                joined.iter().enumerate().filter(|(k, _)| mask >> k & 1 == 1).map(|(_, &i)| i).collect();
            let corners: Vec<DoubleDoubleVector> = support.iter().map(|&i| point(points, i)).collect();
            let Some(center) = through(&corners) else { continue };
            let reaches = joined.iter().map(|&i| squared_distance(point(points, i), center));
            let squared = reaches.fold(DoubleDouble::default(), |m, d| if d > m { d } else { m });
            // a larger subset must be better by more than the rounding of 106 bits
            if squared < best.squared - best.squared * DoubleDouble::from(1e-30) || best.squared.hi.is_infinite() {
                best = Ball { center, squared, support };
            }
        }
    }
    best
}

/// Returns the centre of the smallest ball through all of these points, in their span; `None` if
/// the points are dependent.
///
/// Solves x·v = |v|²/2 for every edge v from the first point, one orthogonal direction after the
/// other (Gärtner 1999, 3).
fn through(corners: &[DoubleDoubleVector]) -> Option<DoubleDoubleVector> {
    let (&base, others) = corners.split_first()?;
    let mut x = [DoubleDouble::default(); 3];
    let mut directions: Vec<DoubleDoubleVector> = Vec::new();
    for &corner in others {
        let v = minus(corner, base);
        let mut across = v;
        for w in &directions {
            across = plus_times(across, DoubleDouble::default() - dot(across, *w) / dot(*w, *w), *w);
        }
        let (length, height) = (dot(v, v), dot(across, across));
        // even 106 bits do not resolve a further dimension here
        if height.hi <= 1e-50 * length.hi || height.hi.is_nan() {
            return None;
        }
        let missing = length * DoubleDouble::from(0.5) - dot(v, x);
        x = plus_times(x, missing / height, across);
        directions.push(across);
    }
    Some(plus_times(base, DoubleDouble::from(1.0), x))
}
