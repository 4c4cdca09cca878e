//! Sums over all points of a cloud: block by block in parallel, eight points at a time.

use super::cloud::{Cloud, Source};
use super::lanes::{LANES, Lanes, Points};
use crate::pose::Vector;
use rayon::prelude::*;

/// Points that one thread sums up: fixed, so that sums do not depend on the number of threads.
const BLOCK: usize = 4096;
/// Blocks whose sums are held at a time.
const BLOCKS: usize = 256;

impl Cloud<'_> {
    /// Lets `each` take up the normalised points, eight at a time with their weights, into a copy of `start` for each
    /// block; `close` makes the sum of a block and `merge` joins them in the order of the points.
    ///
    /// The last eight may be filled up with copies of a point that weigh nothing.
    pub fn sum<A: Clone + Sync, B: Send>(
        &self,
        start: A,
        each: impl Fn(&mut A, Points, Lanes) + Sync,
        close: impl Fn(A) -> B + Sync,
        merge: impl Fn(B, B) -> B,
    ) -> B {
        let block = |k: usize| {
            let mut sums = start.clone();
            let range = k * BLOCK..self.len().min((k + 1) * BLOCK);
            match &self.source {
                Source::Space(points) => self.pass(range.start, &points[range], |p| *p, |q, w| each(&mut sums, q, w)),
                Source::Plane(points) => {
                    self.pass(range.start, &points[range], |p| [p[0], p[1], 0.0], |q, w| each(&mut sums, q, w));
                }
            }
            close(sums)
        };
        let blocks = self.len().div_ceil(BLOCK);
        if blocks <= 1 {
            return block(0);
        }
        let joined = (0..blocks).step_by(BLOCKS).filter_map(|from| {
            let sums: Vec<B> = (from..blocks.min(from + BLOCKS)).into_par_iter().map(block).collect();
            sums.into_iter().reduce(&merge)
        });
        joined.reduce(&merge).unwrap_or_else(|| close(start.clone()))
    }

    /// Normalises `points`, of which the first is number `first`, and gives them on eight by eight.
    #[inline(always)]
    fn pass<P>(
        &self,
        first: usize,
        points: &[P],
        coordinates: impl Fn(&P) -> Vector,
        mut each: impl FnMut(Points, Lanes),
    ) {
        let (centre, factor) = (self.centre_mm, 1.0 / self.scale_mm);
        let normalised = |p: &P| {
            let p = coordinates(p);
            [0, 1, 2].map(|k| (p[k] - centre[k]) * factor)
        };
        // without weights a multiplication by one is none
        let plain = if self.weights.is_some() { 0 } else { points.len() / LANES * LANES };
        for eight in points[..plain].as_chunks::<LANES>().0 {
            let mut group = Points::default();
            for (i, p) in eight.iter().enumerate() {
                let q = normalised(p);
                for k in 0..3 {
                    group[k].0[i] = q[k];
                }
            }
            each(group, Lanes::all(1.0));
        }
        for from in (plain..points.len()).step_by(LANES) {
            let (mut group, mut weights) = (Points::default(), Lanes::default());
            for i in 0..LANES {
                let q = normalised(&points[(from + i).min(points.len() - 1)]);
                for k in 0..3 {
                    group[k].0[i] = q[k];
                }
                if from + i < points.len() {
                    weights.0[i] = self.weight(first + from + i);
                }
            }
            each(group, weights);
        }
    }
}
