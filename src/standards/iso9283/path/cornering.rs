//! Cornering deviations (ISO 9283:1998 8.5, unverified against a bought copy): round-off CR,
//! overshoot CO and stabilisation path length.

use crate::iso9283::motion::stream::Stream;
use crate::iso9283::path::commanded::{CommandPoint, Corner};
use crate::iso9283::path::passes::{Pass, check};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, dot, minus, norm, unit};

/// Cornering deviations, the worst of all passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cornering {
    /// CR: smallest distance of the attained path from the corner.
    pub round_off_mm: f64,
    /// CO: largest distance from the second leg on the side away from the first leg; zero without
    /// overshoot.
    pub overshoot_mm: f64,
    /// Length along the second leg from which the attained path stays within the limit; `None`
    /// without a limit, and if the path leaves it up to the middle of the leg.
    pub stabilisation_mm: Option<f64>,
}

/// Evaluates a corner for at least one pass; samples from the middle of the first leg to the middle
/// of the second count.
pub fn cornering(
    stream: &Stream,
    passes: &[Pass],
    points: &[CommandPoint],
    corner: &Corner,
    limit_mm: Option<f64>,
) -> Result<Cornering> {
    check(passes, points, 1, "cornering")?;
    let [from_mm, at_mm, to_mm] = corner.along_mm;
    let within = |p: &CommandPoint| p.along_mm >= from_mm && p.along_mm <= to_mm;
    let first = points.iter().position(within).filter(|&i| points[i].along_mm < at_mm);
    let last = points.iter().rposition(within).filter(|&i| points[i].along_mm > at_mm);
    let (Some(first), Some(last)) = (first, last) else {
        return Err(error!("corner-without-points").into());
    };
    // direction away from the first leg
    let along = dot(corner.incoming, corner.outgoing);
    let far = unit([0, 1, 2].map(|k| corner.incoming[k] - along * corner.outgoing[k])).unwrap_or_default();
    let mut worst = Cornering { round_off_mm: 0.0, overshoot_mm: 0.0, stabilisation_mm: limit_mm.map(|_| 0.0) };
    for pass in passes {
        // both planes were passed, even if there are few samples between them
        let ends = [first, last].map(|i| [pass.crossings[i].position_mm]);
        let driven = ends[0].iter().chain(&stream.positions_mm()[pass.samples(first, last)]).chain(&ends[1]);
        let relative: Vec<Vector> = driven.map(|p| minus(*p, corner.position_mm)).collect();
        let nearest = relative.windows(2).map(|d| to_segment(d[0], d[1])).fold(f64::INFINITY, f64::min);
        let beyond = relative.iter().filter(|d| dot(**d, far) > 0.0).map(|d| off(*d, corner.outgoing));
        worst.round_off_mm = worst.round_off_mm.max(nearest);
        worst.overshoot_mm = worst.overshoot_mm.max(beyond.fold(0.0, f64::max));
        let stable = limit_mm.and_then(|limit| stable_after_mm(&relative, corner.outgoing, limit));
        worst.stabilisation_mm = worst.stabilisation_mm.zip(stable).map(|(a, b)| a.max(b));
    }
    Ok(worst)
}

/// Distance of the corner from the segment between two samples, both relative to the corner.
fn to_segment(from: Vector, to: Vector) -> f64 {
    let way = minus(to, from);
    let share = (-dot(from, way) / dot(way, way)).clamp(0.0, 1.0);
    if share.is_nan() { norm(from) } else { norm([0, 1, 2].map(|k| from[k] + share * way[k])) }
}

/// Distance from the line along the second leg.
fn off(d: Vector, outgoing: Vector) -> f64 {
    let along = dot(d, outgoing);
    norm([0, 1, 2].map(|k| d[k] - along * outgoing[k]))
}

/// Position along the second leg at which the attained path last leaves the limit.
fn stable_after_mm(relative: &[Vector], outgoing: Vector, limit_mm: f64) -> Option<f64> {
    let last = relative.iter().rposition(|d| off(*d, outgoing) > limit_mm);
    match last {
        None => Some(0.0),
        Some(i) if i + 1 < relative.len() => Some(dot(relative[i + 1], outgoing).max(0.0)),
        Some(_) => None,
    }
}
