//! Start for cylinder, cone and torus from the points alone: for axes over the hemisphere, a
//! closed-form element about each axis; the most promising starts are followed to their minimum.
//!
//! A single start is not enough: on an arc of 90 degrees the sum of squares has several minima over
//! the axes. Methods that rely on the normal of the plane or on the longest spread end in the wrong
//! minimum.

use crate::chart::Chart;
use crate::cloud::Cloud;
use crate::element::Element;
use crate::solver::{Refined, Surface, descend};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::{Vector, dot};
use etalon_base::{error, phrase, warning};

/// Number of directions over the hemisphere, 8 degrees apart.
const DIRECTIONS: usize = 300;
/// Number of points for judging directions, and for following starts.
const JUDGED: usize = 64;
const SEARCHED: usize = 120;
/// Number of iterations before starts are compared.
const GLANCE: usize = 6;
/// Residuals, relative to the residuals of the best start, beyond which a start is abandoned.
const HOPELESS: f64 = 100.0;
/// Maximum axis position or radius, relative to the size of the cloud; beyond it distances lose
/// eight digits.
const FARTHEST: f64 = 1e8;
/// Number of iterations for starts that are not abandoned.
const PATIENCE: usize = 80;

/// A surface about an axis, whose first parameters are (a, b, h, u, v).
pub(crate) trait Axial<const N: usize, const K: usize>: Surface<N, K> {
    /// Surface whose parameters are in `chart`.
    fn on(chart: Chart) -> Self;

    /// Chart of the parameters.
    fn chart(&self) -> &Chart;

    /// Number of starts followed in the search.
    const STARTS: usize = 8;
}

/// Result of the search.
pub(crate) struct Found<S, const N: usize> {
    pub surface: S,
    pub start: [f64; N],
    /// `true` if a different element of this kind fits the points equally well.
    pub rival: bool,
}

/// Searches over the axes. `about` returns elements about an axis with their sums of squares;
/// `upright` brings a solution to its canonical form, or rejects it.
pub(crate) fn search<S: Axial<N, K>, const N: usize, const K: usize>(
    cloud: &Cloud,
    held: Option<Vector>,
    free: [bool; N],
    about: impl Fn(&[Vector], Chart) -> Vec<(f64, [f64; N])>,
    upright: impl Fn(S, [f64; N]) -> Option<(S, [f64; N])>,
) -> Option<Found<S, N>> {
    let few = cloud.thinned(SEARCHED);
    let judged: Vec<Vector> = cloud.thinned(JUDGED).points().collect();
    let about =
        |axis: Vector| about(&judged, Chart::new(axis)).into_iter().map(move |(cost, start)| (cost, axis, start));
    let starts: Vec<(f64, Vector, [f64; N])> = match held {
        Some(axis) => about(axis).collect(),
        None => best_separated(hemisphere(DIRECTIONS).chain(cloud.axes).flat_map(about).collect(), S::STARTS),
    };
    // smaller sums of squares of normalised coordinates are rounding: the more promising start
    // decides
    let rounding = 1e-28 * few.len() as f64;
    let walk = |iterations: usize, surface: S, start: [f64; N]| {
        let refined = descend(surface, &few, start, free, iterations);
        ((rank(&refined) - rounding).max(0.0), refined.surface, refined.x)
    };
    let settled = |walks: Vec<(f64, S, [f64; N])>| {
        let proper = walks.into_iter().filter_map(|(cost, surface, x)| upright(surface, x).map(|(s, x)| (cost, s, x)));
        let mut proper: Vec<_> = proper.filter(|end| end.0.is_finite()).collect();
        proper.sort_by(|a, b| a.0.total_cmp(&b.0));
        proper
    };
    // a few iterations from each start; only promising starts continue to their minimum
    let starts = starts.into_iter().map(|(_, axis, start)| walk(GLANCE, S::on(Chart::new(axis)), start));
    let mut walked = settled(starts.collect());
    let best = walked.first().map_or(0.0, |w| w.0);
    walked.retain(|w| w.0 <= HOPELESS * HOPELESS * best);
    let ends = settled(walked.into_iter().map(|(_, surface, x)| walk(PATIENCE, surface, x)).collect());
    let mut ends = ends.into_iter();
    let (cost, surface, x) = ends.next()?;
    let rival = ends.any(|(other_cost, other, y)| {
        other_cost <= 1.02 * cost + rounding && differ([surface.chart().d0, other.chart().d0], [&x, &y])
    });
    Some(Found { surface, start: x, rival })
}

/// `true` if two solutions are different elements, `false` if they are one element reached from two
/// starts.
fn differ<const N: usize>([axis, other]: [Vector; 2], [x, y]: [&[f64; N]; 2]) -> bool {
    let sizes = x.iter().zip(y).skip(5).any(|(x, y)| (x.abs() - y.abs()).abs() > 1e-4 * (x.abs() + y.abs()));
    sizes || dot(axis, other).abs() < 1.0 - 1e-6
}

/// Error if no start led to an element.
pub(crate) fn no_start(element: Element) -> Problems {
    error!("element-not-determined", element, termination = phrase!("solver-no-start")).into()
}

/// Warning if a rival was found.
pub(crate) fn rival_warning(element: Element) -> Message {
    warning!("element-ambiguous", element)
}

/// `count` directions spread evenly over a hemisphere (Fibonacci lattice: Swinbank & Purser 2006,
/// Q. J. R. Meteorol. Soc. 132, 1769).
fn hemisphere(count: usize) -> impl Iterator<Item = Vector> {
    let golden_rad = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    (0..count).map(move |i| {
        let z = (i as f64 + 0.5) / count as f64;
        let (sin, cos) = (i as f64 * golden_rad).sin_cos();
        let r = (1.0 - z * z).sqrt();
        [r * cos, r * sin, z]
    })
}

/// Best scored starts in ascending order, with axes at least 15 degrees apart.
fn best_separated<const N: usize>(
    mut scored: Vec<(f64, Vector, [f64; N])>,
    count: usize,
) -> Vec<(f64, Vector, [f64; N])> {
    scored.retain(|s| s.0.is_finite());
    scored.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut chosen: Vec<(f64, Vector, [f64; N])> = Vec::new();
    for start in scored {
        let apart = chosen.iter().all(|c| dot(c.1, start.1).abs() < 15f64.to_radians().cos());
        if chosen.len() < count && apart {
            chosen.push(start);
        }
    }
    chosen
}

/// Cost of a start; infinite if the start failed, or if it diverged until rounding removed its
/// cost.
fn rank<S, const N: usize>(refined: &Refined<S, N>) -> f64 {
    let near = refined.x.iter().all(|x| x.abs() < FARTHEST);
    let usable = near && refined.cost.is_finite() && refined.condition().is_finite();
    if usable { refined.cost } else { f64::INFINITY }
}
