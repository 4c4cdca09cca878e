//! How much of an element has points.

use super::axis::Chart;
use super::cloud::Cloud;
use super::lanes::{Lanes, Points, less, square};
use super::stream::Gather;
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
    let sectors = cloud.gather(Sectors { chart, centre, ends: [[f64::INFINITY, f64::NEG_INFINITY]; SECTORS] });
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

/// First and last point of each sector.
#[derive(Clone)]
struct Sectors<'a> {
    chart: &'a Chart,
    centre: Vector,
    ends: [[f64; 2]; SECTORS],
}

impl Gather for Sectors<'_> {
    type Sum = [[f64; 2]; SECTORS];

    #[inline(always)]
    fn take(&mut self, q: Points, _: Lanes) {
        let [x, y, _] = self.chart.seen(q, self.centre);
        let part = x * (x.abs() + y.abs()).inverse_or_zero();
        for (part, y) in part.0.into_iter().zip(y.0) {
            let turn = if y < 0.0 { 3.0 + part } else { 1.0 - part };
            let index = (turn * (SECTORS / 4) as f64) as usize;
            let [first, last] = &mut self.ends[index.min(SECTORS - 1)];
            *first = first.min(turn);
            *last = last.max(turn);
        }
    }

    fn close(self) -> Self::Sum {
        self.ends
    }

    fn join(mut first: Self::Sum, next: Self::Sum) -> Self::Sum {
        for (a, b) in first.iter_mut().zip(next) {
            *a = [a[0].min(b[0]), a[1].max(b[1])];
        }
        first
    }
}

/// Full angle of the cap about the mean direction that holds all directions from `centre`.
pub(super) fn cap_coverage(cloud: &Cloud, centre: Vector) -> f64 {
    let mean = cloud.gather(Directions { centre, sum: Points::default() });
    let Some(mean) = unit(mean) else { return TAU };
    let chord = cloud.gather(Chord { centre, mean, square: Lanes::default() });
    // half the angle between two directions has half their distance for its sine
    4.0 * (chord.sqrt() / 2.0).min(1.0).asin()
}

/// Unit vectors from `centre` to points.
#[inline(always)]
fn directions(q: Points, centre: Vector) -> Points {
    let [x, y, z] = less(q, centre);
    let inverse = square([x, y, z]).sqrt().inverse_or_zero();
    [x * inverse, y * inverse, z * inverse]
}

/// Sum of the directions from `centre`.
#[derive(Clone)]
struct Directions {
    centre: Vector,
    sum: Points,
}

impl Gather for Directions {
    type Sum = Vector;

    #[inline(always)]
    fn take(&mut self, q: Points, w: Lanes) {
        for (sum, g) in self.sum.iter_mut().zip(directions(q, self.centre)) {
            *sum = *sum + w.presence() * g;
        }
    }

    fn close(self) -> Vector {
        self.sum.map(Lanes::sum)
    }

    fn join(a: Vector, b: Vector) -> Vector {
        [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
    }
}

/// Largest squared distance of a direction from their mean.
#[derive(Clone)]
struct Chord {
    centre: Vector,
    mean: Vector,
    square: Lanes,
}

impl Gather for Chord {
    type Sum = f64;

    #[inline(always)]
    fn take(&mut self, q: Points, _: Lanes) {
        self.square = self.square.max(square(less(directions(q, self.centre), self.mean)));
    }

    fn close(self) -> f64 {
        self.square.most()
    }

    fn join(a: f64, b: f64) -> f64 {
        a.max(b)
    }
}
