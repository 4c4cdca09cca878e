//! Minimum zone of a plane: the two parallel planes closest together that hold the points between them.
//!
//! Seen from a direction d, every direction is d + a e1 + b e2, and the heights of the points over the plane square to
//! it vary by g(a, b) / √(1 + a² + b²), where g is that of a linear Chebyshev problem. Its minimum is narrower still,
//! until it is where it was sought. There g ≥ w + κ r at a distance r, so that nothing within 2 κ w / (w² − κ²) is
//! narrower, and nothing at all where κ ≥ w: the points are flat. Otherwise the other directions are proved wider part by
//! part: in a triangle of directions within ρ of its middle the width is at least that of the linear problem times cos ρ.

use super::super::axis::Chart;
use super::super::cloud::{Cloud, Source};
use super::super::element::{Element, Settings};
use super::super::result::largest_component_positive;
use super::chebyshev::{extremes, fence, growth, least_spread};
use super::{MinimumZone, SLACK, sides};
use crate::base::message::Result;
use crate::base::pose::{Vector, dot, minus, norm, unit};
use std::collections::VecDeque;
use std::rc::Rc;

/// Triangles of directions, and points seen from one, that are looked at before the proof is given up.
const TRIANGLES: usize = 20_000;
const LOOKS: usize = 10_000_000;

/// Minimum zone of a plane, of at least three points that are not on one line.
///
/// Three points hold one side and one between them the other, or two and two that cross (Houle & Toussaint 1988).
pub fn minimum_zone_plane(points: &[Vector]) -> Result<MinimumZone> {
    let cloud = Cloud::new(Element::Plane, Source::Space(points.into()), &Settings::default())?;
    let normalised: Vec<Vector> = cloud.points().collect();
    let start = descend(&normalised, cloud.axes[2]);
    let (best, verified, iterations) = prove(&normalised, start);
    let normal = largest_component_positive(best.normal);
    let heights: Vec<f64> = normalised.iter().map(|&q| dot(q, normal)).collect();
    let (zone, middle) = MinimumZone::between(Element::Plane, &heights, cloud.scale_mm);
    Ok(MinimumZone {
        point_mm: cloud.to_mm(normal.map(|x| x * middle)),
        direction: Some(normal),
        verified,
        iterations,
        ..zone
    })
}

/// A direction that no other near it is narrower than.
#[derive(Clone, Copy)]
struct Place {
    normal: Vector,
    width: f64,
    /// Least growth of the variation with the tangent of the angle from here.
    growth: f64,
}

impl Place {
    /// Cosine of the angle within which no direction is narrower than this one.
    fn cosine_of_hold(&self) -> f64 {
        let (w, k) = (self.width, self.growth);
        if k >= w {
            return 0.0;
        }
        if k <= 0.0 {
            return 1.0;
        }
        let tangent = 2.0 * k * w / ((w - k) * (w + k));
        1.0 / tangent.hypot(1.0)
    }

    fn holds(&self, direction: Vector) -> bool {
        dot(self.normal, direction).abs() >= self.cosine_of_hold()
    }
}

fn seen_from(points: &[Vector], chart: &Chart) -> Vec<[f64; 3]> {
    points.iter().map(|&q| chart.coordinates(q)).collect()
}

/// From one linear problem to the next until the direction stays.
fn descend(points: &[Vector], from: Vector) -> Place {
    let mut chart = Chart::new(from);
    for _ in 0..100 {
        let Some(level) = least_spread(&seen_from(points, &chart), f64::INFINITY) else { break };
        let [a, b] = level.slope;
        chart = Chart::new(chart.point(a, b, 1.0));
        if a.hypot(b) < 1e-15 {
            break;
        }
    }
    let rows = seen_from(points, &chart);
    let heights: Vec<f64> = rows.iter().map(|row| row[2]).collect();
    let (low, high, lower, upper) = sides(&heights);
    let flat = |side: &[usize]| side.iter().map(|&i| [rows[i][0], rows[i][1]]).collect::<Vec<_>>();
    Place { normal: chart.d0, width: high - low, growth: growth(&flat(&upper), &flat(&lower)) }
}

/// The narrowest place, whether it was proved to be, and how many directions were looked at.
fn prove(points: &[Vector], start: Place) -> (Place, bool, usize) {
    let mut best = start;
    if best.width <= SLACK || best.growth >= best.width {
        return (best, true, 1);
    }
    let mut places = vec![best];
    let pole = [0.0, 0.0, 1.0];
    let around = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
    let all = Rc::new(points.to_vec());
    // opposite directions are the same plane: half the octahedron is all
    let octants = (0..4).map(|k| ([pole, around[k], around[(k + 1) % 4]], Rc::clone(&all)));
    let mut queue: VecDeque<([Vector; 3], Rc<Vec<Vector>>)> = octants.collect();
    let (mut looked_at, mut looks) = (1, 0);
    while let Some((corners, points_here)) = queue.pop_front() {
        if places.iter().any(|place| corners.iter().all(|&c| place.holds(c))) {
            continue;
        }
        if looked_at == TRIANGLES || looks > LOOKS {
            return (best, false, looked_at);
        }
        looked_at += 1;
        looks += points_here.len();
        let [p, q, r] = corners;
        let Some(middle) = unit(sum(sum(p, q), r)) else { continue };
        let cosine = corners.iter().fold(1.0f64, |m, &c| m.min(dot(c, middle)));
        let tangent = (1.0 / (cosine * cosine) - 1.0).max(0.0).sqrt();
        let chart = Chart::new(middle);
        let mut rows = seen_from(&points_here, &chart);
        let within = Rc::new(extreme_within(&points_here, &rows, tangent));
        rows.extend(fence(&rows, tangent));
        let enough = (best.width - SLACK) / cosine;
        if let Some(level) = least_spread(&rows, enough) {
            if level.spread >= enough {
                continue;
            }
            let [a, b] = level.slope;
            let width_there = level.spread / a.hypot(b).hypot(1.0);
            if a.hypot(b) <= 2.0 * tangent && width_there <= best.width + SLACK {
                let found = descend(points, chart.point(a, b, 1.0));
                if found.width < best.width {
                    best = found;
                }
                if !places.iter().any(|place| dot(place.normal, found.normal).abs() > 1.0 - 1e-12) {
                    places.push(found);
                }
            }
        }
        let half = |a: Vector, b: Vector| unit(sum(a, b)).unwrap_or(a);
        let (pq, qr, rp) = (half(p, q), half(q, r), half(r, p));
        queue.extend([[p, pq, rp], [pq, q, qr], [rp, qr, r], [pq, qr, rp]].map(|part| (part, Rc::clone(&within))));
    }
    (best, true, looked_at)
}

/// The points that can be highest or lowest seen from a direction whose angle to that of `rows` has at most this
/// tangent: no farther below the highest than their distance from it times the tangent.
fn extreme_within(points: &[Vector], rows: &[[f64; 3]], tangent: f64) -> Vec<Vector> {
    let (low, high) = extremes(rows, [0.0; 2]);
    let may_reach = |i: usize, end: usize| {
        (rows[i][2] - rows[end][2]).abs() <= tangent * norm(minus(points[i], points[end])) + SLACK
    };
    (0..points.len()).filter(|&i| may_reach(i, low) || may_reach(i, high)).map(|i| points[i]).collect()
}

fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
