//! How much of an element has points.

use super::axis::Chart;
use super::cloud::Cloud;
use super::lanes::{Lanes, less, square};
use crate::pose::{Vector, unit};
use std::f64::consts::TAU;

/// Sectors that the directions of points are sorted into: of 0.2 to 0.5 degrees.
const SECTORS: usize = 1024;

/// The full turn less the largest gap between neighbouring points, seen along the axis of `chart` about `point`.
///
/// A gap wider than a sector is found exactly, and of fewer than 800 points every largest gap is. The points are sorted by
/// x / (|x| + |y|), which grows and falls with the angle.
pub(super) fn arc_coverage(cloud: &Cloud, chart: &Chart, point: Vector) -> f64 {
    let centre = chart.coordinates(point);
    let sectors = cloud.sum(
        [[f64::INFINITY, f64::NEG_INFINITY]; SECTORS],
        |sectors, q, _| {
            let [x, y, _] = chart.seen(q, centre);
            let part = x * (x.abs() + y.abs()).inverse_or_zero();
            for (part, y) in part.0.into_iter().zip(y.0) {
                let turn = if y < 0.0 { 3.0 + part } else { 1.0 - part };
                let index = (turn * (SECTORS / 4) as f64) as usize;
                let [first, last] = &mut sectors[index.min(SECTORS - 1)];
                *first = first.min(turn);
                *last = last.max(turn);
            }
        },
        |sectors| sectors,
        |mut a, b| {
            for (a, b) in a.iter_mut().zip(b) {
                *a = [a[0].min(b[0]), a[1].max(b[1])];
            }
            a
        },
    );
    let angle = |turn: f64| {
        let x = if turn <= 2.0 { 1.0 - turn } else { turn - 3.0 };
        let y = (1.0 - x.abs()).copysign(2.0 - turn);
        if turn > 2.0 { TAU + y.atan2(x) } else { y.atan2(x) }
    };
    let taken: Vec<[f64; 2]> = sectors.into_iter().filter(|s| s[0] <= s[1]).map(|s| s.map(angle)).collect();
    let around = match (taken.first(), taken.last()) {
        (Some(first), Some(last)) => first[0] + TAU - last[1],
        _ => TAU,
    };
    TAU - taken.iter().zip(taken.iter().skip(1)).fold(around, |gap, (a, b)| gap.max(b[0] - a[1]))
}

/// Full angle of the cap about the mean direction that holds all directions from `centre`.
pub(super) fn cap_coverage(cloud: &Cloud, centre: Vector) -> f64 {
    let directions = |q| {
        let w = less(q, centre);
        let inverse = square(w).sqrt().inverse_or_zero();
        w.map(|x| x * inverse)
    };
    let sum = cloud.sum(
        [Lanes::default(); 3],
        |sum, q, w| {
            for (sum, g) in sum.iter_mut().zip(directions(q)) {
                *sum = *sum + w.presence() * g;
            }
        },
        |sum| sum.map(Lanes::sum),
        |a, b| [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
    );
    let Some(mean) = unit(sum) else { return TAU };
    let chord = cloud.sum(
        Lanes::default(),
        |chord, q, _| *chord = chord.max(square(less(directions(q), mean))),
        Lanes::most,
        f64::max,
    );
    // half the angle between two directions has half their distance for its sine
    4.0 * (chord.sqrt() / 2.0).min(1.0).asin()
}
