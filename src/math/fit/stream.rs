//! Sums over all points of a cloud: block by block in parallel, eight points at a time, in registers as wide as the
//! machine has them. What is fused ([`F64x8::plus`]) is so on every machine and nothing else is, and no width reorders an
//! operation, so sums have the same bytes everywhere.

use super::cloud::{Cloud, Source};
use super::f64x8::{F64x8, LANES, Points};
use pulp::Arch;
use rayon::prelude::*;

/// Points that one thread sums up: fixed, so that sums do not depend on the number of threads.
const BLOCK: usize = 4096;
/// Blocks whose sums are held at a time.
const BLOCKS: usize = 256;

/// What is gathered from the points of a block, and how the sums of blocks are joined.
pub(super) trait Gather: Clone + Sync {
    /// What a block comes to.
    type Sum: Send;

    /// Takes up eight points with their weights. The last eight may be filled up with copies of a point that weigh
    /// nothing. To be inlined, so that what is gathered stays in registers.
    fn take(&mut self, q: Points, w: F64x8);

    fn close(self) -> Self::Sum;

    fn join(first: Self::Sum, next: Self::Sum) -> Self::Sum;
}

/// Nothing.
impl Gather for () {
    type Sum = ();

    #[inline(always)]
    fn take(&mut self, _: Points, _: F64x8) {}

    fn close(self) {}

    fn join((): (), (): ()) {}
}

/// Two things in one look at the points.
impl<A: Gather, B: Gather> Gather for (A, B) {
    type Sum = (A::Sum, B::Sum);

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        self.0.take(q, w);
        self.1.take(q, w);
    }

    fn close(self) -> Self::Sum {
        (self.0.close(), self.1.close())
    }

    fn join(first: Self::Sum, next: Self::Sum) -> Self::Sum {
        (A::join(first.0, next.0), B::join(first.1, next.1))
    }
}

impl Cloud<'_> {
    /// Gathers over all normalised points, from a copy of `start` for each block, joined in the order of the points.
    pub fn gather<G: Gather>(&self, start: G) -> G::Sum {
        let machine = Arch::new();
        let block = |k: usize| {
            let range = k * BLOCK..self.len().min((k + 1) * BLOCK);
            let gathered = start.clone();
            match &self.source {
                Source::Space(points) => machine.dispatch(
                    #[inline(always)]
                    || self.pass(range.start, &points[range], gathered),
                ),
                Source::Plane(points) => machine.dispatch(
                    #[inline(always)]
                    || self.pass(range.start, &points[range], gathered),
                ),
            }
        };
        let blocks = self.len().div_ceil(BLOCK);
        if blocks <= 1 {
            return block(0);
        }
        let joined = (0..blocks).step_by(BLOCKS).filter_map(|from| {
            let sums: Vec<G::Sum> = (from..blocks.min(from + BLOCKS)).into_par_iter().map(block).collect();
            sums.into_iter().reduce(G::join)
        });
        joined.reduce(G::join).unwrap_or_else(|| start.clone().close())
    }

    /// Normalises `points` (in the plane or in space), of which the first is number `first`, eight by eight.
    #[inline(always)]
    fn pass<G: Gather, const D: usize>(&self, first: usize, points: &[[f64; D]], mut gathered: G) -> G::Sum {
        let (centre, factor) = (self.centre_mm, 1.0 / self.scale_mm);
        // without weights a multiplication by one is none
        let plain = if self.weights.is_some() { 0 } else { points.len() / LANES * LANES };
        for eight in points[..plain].as_chunks::<LANES>().0 {
            let mut group = Points::default();
            for k in 0..D {
                group[k] = (F64x8(eight.map(|p| p[k])) - centre[k]) * factor;
            }
            gathered.take(group, F64x8::all(1.0));
        }
        for from in (plain..points.len()).step_by(LANES) {
            let (mut group, mut weights) = (Points::default(), F64x8::default());
            for i in 0..LANES {
                let p = points[(from + i).min(points.len() - 1)];
                for k in 0..D {
                    group[k].0[i] = (p[k] - centre[k]) * factor;
                }
                if from + i < points.len() {
                    weights.0[i] = self.weight(first + from + i);
                }
            }
            gathered.take(group, weights);
        }
        gathered.close()
    }
}
