//! A start for cylinder, cone and torus from the points alone: axes over the hemisphere, each with the element that
//! a closed solution gives about it; the most promising are followed to their minimum.
//!
//! One start is not enough: on an arc of 90 degrees the sum of squares has several minima over the axes, and a
//! method that trusts the plane's normal or the longest spread ends in the wrong one.

use super::axis::{Axial, Chart, refine_axis};
use super::cloud::Cloud;
use super::element::{Element, refuse};
use super::surface::Refined;
use crate::message::{Message, Problems};
use crate::pose::{Vector, dot};
use crate::solve::Options;

/// Directions tried over the hemisphere, 7 degrees apart.
const DIRECTIONS: usize = 400;
/// Points that the search looks at.
const SEARCHED: usize = 120;
/// Starts that are followed to their minimum.
const FOLLOWED: usize = 8;

/// Where the search ended.
pub(super) struct Found<S, const N: usize> {
    pub surface: S,
    pub start: [f64; N],
    /// Whether a different element of this kind fits the points as well.
    pub rival: bool,
}

/// Searches over the axes. `about` gives the sum of squares and parameters of the best element about an axis, and
/// `upright` brings a solution to its one proper form, or refuses it.
pub(super) fn search<S: Axial<N, K>, const N: usize, const K: usize>(
    cloud: &Cloud,
    held: Option<Vector>,
    free: [bool; N],
    about: impl Fn(&Cloud, Chart) -> (f64, [f64; N]),
    upright: impl Fn(S, [f64; N]) -> Option<(S, [f64; N])>,
    element: impl Fn(Chart) -> S,
) -> Option<Found<S, N>> {
    let few = cloud.thinned(SEARCHED);
    let scored = |axis: Vector| {
        let (cost, start) = about(&few, Chart::new(axis));
        (cost, axis, start)
    };
    let starts: Vec<(Vector, [f64; N])> = match held {
        Some(axis) => vec![(axis, scored(axis).2)],
        None => best_apart(hemisphere(DIRECTIONS).chain(cloud.axes).map(scored).collect(), FOLLOWED),
    };
    let patience = Options { iterations: 80, ..Options::default() };
    let mut ends: Vec<(f64, S, [f64; N])> = Vec::new();
    for (axis, start) in starts {
        let (surface, refined) = refine_axis(element(Chart::new(axis)), &few, start, free, patience);
        let cost = rank(&refined);
        let (surface, x) = surface.recharted(&refined.x);
        ends.extend(upright(surface, x).filter(|_| cost.is_finite()).map(|(surface, x)| (cost, surface, x)));
    }
    // below this, sums of squares of normalised coordinates are rounding: the more promising start decides
    let rounding = 1e-28 * few.points.len() as f64;
    let best =
        ends.iter().enumerate().min_by(|a, b| (a.1.0 - rounding).max(0.0).total_cmp(&(b.1.0 - rounding).max(0.0)))?.0;
    let (cost, surface, x) = ends.swap_remove(best);
    let rival = ends.iter().any(|(other_cost, other, y)| {
        *other_cost <= 1.02 * cost + rounding && differ((&surface.chart().d0, &x), (&other.chart().d0, y))
    });
    Some(Found { surface, start: x, rival })
}

/// Whether two solutions are different elements and not two roads to the same.
fn differ<const N: usize>(a: (&Vector, &[f64; N]), b: (&Vector, &[f64; N])) -> bool {
    let sizes = a.1.iter().zip(b.1).skip(5).any(|(x, y)| (x.abs() - y.abs()).abs() > 1e-4 * (x.abs() + y.abs()));
    sizes || dot(*a.0, *b.0).abs() < 1.0 - 1e-6
}

/// What to say where no start led to an element.
pub(super) fn no_start(element: Element) -> Problems {
    refuse(
        format!("no {element} could be found through the points"),
        format!("points on a {element}"),
        "check that the points belong to this feature; else hold the axis",
    )
}

/// What to say where a rival was found.
pub(super) fn rival_warning(element: Element) -> Message {
    Message::warning(format!("a different {element} fits the points about as well"))
        .hint("measure more points where the element is not yet covered, or hold the axis")
}

/// `count` directions spread evenly over a hemisphere (Fibonacci lattice: Swinbank & Purser 2006, Q. J. R. Meteorol. Soc. 132, 1769).
fn hemisphere(count: usize) -> impl Iterator<Item = Vector> {
    let golden_rad = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    (0..count).map(move |i| {
        let z = (i as f64 + 0.5) / count as f64;
        let (sin, cos) = (i as f64 * golden_rad).sin_cos();
        let r = (1.0 - z * z).sqrt();
        [r * cos, r * sin, z]
    })
}

/// The best of scored starts, lowest first, no two axes of them closer than 15 degrees.
fn best_apart<T>(mut scored: Vec<(f64, Vector, T)>, count: usize) -> Vec<(Vector, T)> {
    scored.retain(|s| s.0.is_finite());
    scored.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut chosen: Vec<(Vector, T)> = Vec::new();
    for (_, axis, start) in scored {
        if chosen.len() < count && chosen.iter().all(|(c, _)| dot(*c, axis).abs() < 15f64.to_radians().cos()) {
            chosen.push((axis, start));
        }
    }
    chosen
}

/// Cost of a start that led somewhere; infinite of one that did not.
fn rank<const N: usize, const K: usize>(refined: &Refined<N, K>) -> f64 {
    let usable = refined.cost.is_finite() && refined.condition.is_finite();
    if usable { refined.cost } else { f64::INFINITY }
}
