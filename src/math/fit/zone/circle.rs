//! Minimum zone of a circle in the plane: the two concentric circles closest together that hold the points between them.
//!
//! R² − r² = max(|p|² − 2 c·p) − min(|p|² − 2 c·p) is a linear Chebyshev problem in the centre c. It grows from its
//! minimum by at least κ a length, and R + r by at most 2: where κ ≥ 2 (R − r) the ring of least area is the narrowest of
//! all, which holds for whatever is round. Otherwise the plane is searched square by square. Far away a ring is a strip,
//! so that the narrowest strip bounds the search.

use super::super::cloud::{Cloud, Source};
use super::super::element::{Element, Settings, refuse};
use super::chebyshev::{fence, growth, least_spread};
use super::hull::narrowest_strip;
use super::{MinimumZone, SLACK, sides};
use crate::base::message::Result;
use std::collections::VecDeque;
use std::rc::Rc;

/// Squares of centres, and points seen from one, that are looked at before the proof is given up.
const SQUARES: usize = 20_000;
const LOOKS: usize = 10_000_000;

/// Centres farther away, in sizes of the points, are not looked for: such an arc is straight to a ten-thousandth, and the
/// rounding of its radius shows in its form.
const FARTHEST: f64 = 1e4;

/// Minimum zone of a circle in the plane, of at least three points that are not on one line.
///
/// Two points hold the outer circle and two the inner, in turns around it (Rivlin 1979). An error where a line is as
/// good: the centre would be at infinity.
pub fn minimum_zone_circle2d(points: &[[f64; 2]]) -> Result<MinimumZone> {
    let cloud = Cloud::new(Element::Circle2d, Source::Plane(points), &Settings::default())?;
    let flat: Vec<[f64; 2]> = cloud.points().map(|q| [q[0], q[1]]).collect();
    let Some((best, verified, iterations)) = narrowest(&flat) else {
        return Err(refuse(
            "no minimum zone of a circle: the points lie as close to a line as to any circle",
            "points on an arc that is higher than its form deviation",
            "measure a longer arc, or look for the minimum zone of a line",
        ));
    };
    let distances = distances(&flat, best.center);
    let (zone, middle) = MinimumZone::between(Element::Circle2d, &distances, cloud.scale_mm);
    Ok(MinimumZone {
        point_mm: cloud.to_mm([best.center[0], best.center[1], 0.0]).map(|x| x + 0.0),
        radius_mm: Some(middle * cloud.scale_mm),
        verified,
        iterations,
        ..zone
    })
}

/// A centre that no other near it is narrower than.
#[derive(Clone, Copy)]
struct Place {
    center: [f64; 2],
    width: f64,
    /// Distance within which no centre is narrower.
    hold: f64,
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn distances(points: &[[f64; 2]], center: [f64; 2]) -> Vec<f64> {
    points.iter().map(|&p| distance(p, center)).collect()
}

/// Rows of the linear problem about `center`: the distance of a point is d − u·δ to first order and never less.
fn rows_about(points: &[[f64; 2]], center: [f64; 2]) -> Vec<[f64; 3]> {
    let row = |p: &[f64; 2]| {
        let d = distance(*p, center);
        let back = |k: usize| if d > 0.0 { (center[k] - p[k]) / d } else { 0.0 };
        [back(0), back(1), d]
    };
    points.iter().map(row).collect()
}

fn width_of(rows: &[[f64; 3]]) -> (f64, f64) {
    let (low, high) = rows.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), r| (l.min(r[2]), h.max(r[2])));
    (high - low, low)
}

/// From one linear problem to the next, with steps halved until the ring is narrower, until the centre stays.
fn descend(points: &[[f64; 2]], from: [f64; 2]) -> Place {
    let mut center = from;
    let mut rows = rows_about(points, center);
    for _ in 0..100 {
        let (width, _) = width_of(&rows);
        let Some(level) = least_spread(&rows, f64::INFINITY) else { break };
        let halved = (0..40).map(|k| level.slope.map(|s| s * 0.5f64.powi(k)));
        let mut tried = halved.map(|step| {
            let center = [center[0] + step[0], center[1] + step[1]];
            (center, rows_about(points, center))
        });
        let Some(next) = tried.find(|(c, rows)| c[0].hypot(c[1]) < FARTHEST && width_of(rows).0 < width) else { break };
        (center, rows) = next;
    }
    let (low, high, lower, upper) = sides(&rows.iter().map(|row| row[2]).collect::<Vec<_>>());
    let flat = |side: &[usize]| side.iter().map(|&i| [rows[i][0], rows[i][1]]).collect::<Vec<_>>();
    // a distance is bent by at most e²/2 (r − e) at e from here
    let k = growth(&flat(&upper), &flat(&lower)).max(0.0);
    Place { center, width: high - low, hold: 2.0 * k * low / (1.0 + 2.0 * k) }
}

/// The narrowest place, whether it was proved to be, and how many centres were looked at; `None` where a strip is as
/// narrow, or the arc too flat.
fn narrowest(points: &[[f64; 2]]) -> Option<(Place, bool, usize)> {
    let squared: Vec<[f64; 3]> = points.iter().map(|p| [-2.0 * p[0], -2.0 * p[1], p[0] * p[0] + p[1] * p[1]]).collect();
    let level = least_spread(&squared, f64::INFINITY)?;
    if level.slope[0].hypot(level.slope[1]) >= FARTHEST {
        return None;
    }
    let best = descend(points, level.slope);
    let (_, _, lower, upper) = sides(&distances(points, best.center));
    let flat = |side: &[usize]| side.iter().map(|&i| [squared[i][0], squared[i][1]]).collect::<Vec<_>>();
    if best.width <= SLACK || growth(&flat(&upper), &flat(&lower)) >= 2.0 * best.width {
        return Some((best, true, 1));
    }
    search(points, best)
}

fn search(points: &[[f64; 2]], mut best: Place) -> Option<(Place, bool, usize)> {
    let strip = narrowest_strip(points)?.width;
    let size = distances(points, [0.0; 2]).into_iter().fold(0.0, f64::max);
    // at a distance t from the origin a ring is at most this much narrower than the strip across
    let bend = |t: f64| if t > size { size * size / (2.0 * (t - size)) } else { f64::INFINITY };
    let margin = (strip - best.width).max(1e-3 * size);
    let mut places = vec![best];
    let all = Rc::new(points.to_vec());
    let mut queue = VecDeque::from([([0.0; 2], size + size * size / (2.0 * margin), all)]);
    let (mut looked_at, mut looks) = (1, 0);
    let mut verified = true;
    while let Some((middle, half, points_here)) = queue.pop_front() {
        let radius = half * 2f64.sqrt();
        let inside = |place: &Place| distance(place.center, middle) + radius <= place.hold;
        let goal = best.width.min(strip) - SLACK;
        let nearest = distance(middle, [0.0; 2]) - radius;
        if places.iter().any(inside) || strip - bend(nearest) >= goal {
            continue;
        }
        if looked_at == SQUARES || looks > LOOKS {
            verified = false;
            break;
        }
        looked_at += 1;
        looks += points_here.len();
        let mut rows = rows_about(&points_here, middle);
        let (width, inner) = width_of(&rows);
        // two unit vectors to points of the cloud differ by what it subtends: so much a width changes with a length
        let change = radius * if nearest > size { 2.0 * size / nearest } else { 2.0 };
        if width - change >= goal {
            continue;
        }
        // only these can be the farthest or nearest from a centre in the square
        let reach = |row: &[f64; 3]| row[2] <= inner + change + SLACK || row[2] >= inner + width - change - SLACK;
        let within: Vec<[f64; 2]> = points_here.iter().zip(&rows).filter(|(_, r)| reach(r)).map(|(p, _)| *p).collect();
        let within = Rc::new(within);
        rows.extend(fence(&rows, radius));
        let bent = if inner > radius { radius * radius / (2.0 * (inner - radius)) } else { f64::INFINITY };
        let enough = goal + bent;
        if let Some(level) = least_spread(&rows, enough) {
            if level.spread >= enough {
                continue;
            }
            let there = [middle[0] + level.slope[0], middle[1] + level.slope[1]];
            let near = distance(there, middle) <= 2.0 * radius;
            if near && width_of(&rows_about(&points_here, there)).0 <= best.width + SLACK {
                let found = descend(points, there);
                if found.width < best.width {
                    best = found;
                }
                if !places.iter().any(|place| distance(place.center, found.center) < 1e-9) {
                    places.push(found);
                }
            }
        }
        let quarter = 0.5 * half;
        for (i, j) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
            queue.push_back(([middle[0] + i * quarter, middle[1] + j * quarter], quarter, Rc::clone(&within)));
        }
    }
    (best.width < strip - SLACK).then_some((best, verified, looked_at))
}
