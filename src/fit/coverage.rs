//! Part of an element that is covered by points.

use super::chart::Chart;
use super::cloud::Gather;
use super::f64x8::{F64x8, LANES, Points, less, square};
use etalon_base::pose::{Vector, unit};
use std::f64::consts::TAU;
use std::sync::Arc as Shared;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Number of sectors for sorting directions of points; each is 0.9 to 1.8 degrees wide.
const SECTORS: usize = 256;

/// Measure of the part of an element that is covered by points.
pub(super) trait Coverage: Gather {
    /// Covered angle (rad).
    fn angle_rad(sum: Self::Sum) -> f64;
}

/// Covered arc about an axis: full turn minus the largest gap between neighbouring points.
///
/// Gaps wider than a sector are exact, as is the largest gap of fewer than 200 points. Points are
/// sorted by x / (|x| + |y|), which is monotonic in the angle; each sector keeps its first and last
/// point. All blocks share the sectors, so that most points soon change nothing; the order of
/// blocks has no effect.
#[derive(Clone)]
pub(super) struct Arc {
    chart: Chart,
    centre: Vector,
    sectors: Shared<Sectors>,
}

/// First and last point of each sector, as bit patterns, whose order is the order of positive
/// numbers.
pub(super) struct Sectors(Vec<[AtomicU64; 2]>);

impl Default for Sectors {
    fn default() -> Self {
        let none = || [f64::INFINITY, 0.0].map(|turn| AtomicU64::new(turn.to_bits()));
        Self((0..=SECTORS).map(|_| none()).collect())
    }
}

impl Sectors {
    /// Adds turns to their sectors. Not to be inlined, so that the calling code stays in vector
    /// registers.
    #[inline(never)]
    fn take(&self, turns: &[u64; LANES], sectors: &[u64; LANES]) {
        for (turn, sector) in turns.iter().zip(sectors) {
            if let Some([first, last]) = self.0.get((sector & 0xffff) as usize) {
                if *turn < first.load(Relaxed) {
                    first.fetch_min(*turn, Relaxed);
                }
                if *turn > last.load(Relaxed) {
                    last.fetch_max(*turn, Relaxed);
                }
            }
        }
    }
}

impl Arc {
    /// Creates a measure about `point`.
    pub fn about(chart: &Chart, point: Vector) -> Self {
        Self { chart: *chart, centre: chart.coordinates(point), sectors: Shared::default() }
    }
}

impl Coverage for Arc {
    fn angle_rad(sectors: Self::Sum) -> f64 {
        let angle = |turn: f64| {
            let x = if turn <= 2.0 { 1.0 - turn } else { turn - 3.0 };
            let y = (1.0 - x.abs()).copysign(2.0 - turn);
            if turn > 2.0 { TAU + y.atan2(x) } else { y.atan2(x) }
        };
        let ends = sectors.0.iter().map(|ends| [0, 1].map(|k| f64::from_bits(ends[k].load(Relaxed))));
        let taken: Vec<[f64; 2]> = ends.filter(|s| s[0] <= s[1]).map(|s| s.map(angle)).collect();
        let around = match (taken.first(), taken.last()) {
            (Some(first), Some(last)) => first[0] + TAU - last[1],
            _ => TAU,
        };
        TAU - taken.iter().zip(taken.iter().skip(1)).fold(around, |gap, (a, b)| gap.max(b[0] - a[1]))
    }
}

impl Gather for Arc {
    type Sum = Shared<Sectors>;

    #[inline(always)]
    fn take(&mut self, q: Points, _: F64x8) {
        let [x, y, _] = self.chart.seen(q, self.centre);
        let part = x * (x.abs() + y.abs()).inverse_or_zero();
        let turn = F64x8::all(2.0) - (F64x8::all(1.0) + part).with_signs(y);
        // the sum with 2^52 is an integer, held in the last bits
        let sector = (turn * (SECTORS / 4) as f64 + F64x8::all(4_503_599_627_370_496.0)).0.map(f64::to_bits);
        self.sectors.take(&turn.0.map(f64::to_bits), &sector);
    }

    fn close(self) -> Self::Sum {
        self.sectors
    }

    fn join(all: Self::Sum, _: Self::Sum) -> Self::Sum {
        all
    }
}

/// Covered cap of a sphere: full angle about the mean direction that contains all directions from
/// the centre.
#[derive(Clone)]
pub(super) struct Cap {
    centre: Vector,
    radius: f64,
    mean: Option<Vector>,
    square: F64x8,
}

impl Cap {
    /// Creates a measure about `centre` for points mostly near `radius`; `sum` has the mean
    /// direction.
    pub fn about(centre: Vector, radius: f64, sum: Vector) -> Self {
        Self { centre, radius, mean: unit(sum), square: F64x8::default() }
    }
}

impl Coverage for Cap {
    fn angle_rad(chord: f64) -> f64 {
        // the sine of half the angle between two directions is half their distance
        4.0 * (chord.sqrt() / 2.0).min(1.0).asin()
    }
}

/// Largest squared distance of a direction from the mean; without a mean direction the points are
/// all around.
impl Gather for Cap {
    type Sum = f64;

    #[inline(always)]
    fn take(&mut self, q: Points, _: F64x8) {
        let Some(mean) = self.mean else {
            self.square = F64x8::all(4.0);
            return;
        };
        let [x, y, z] = less(q, self.centre);
        let (_, inverse) = square([x, y, z]).roots(self.radius);
        self.square = self.square.max(square(less([x * inverse, y * inverse, z * inverse], mean)));
    }

    fn close(self) -> f64 {
        self.square.most()
    }

    fn join(a: f64, b: f64) -> f64 {
        a.max(b)
    }
}
