//! Branch and bound: the proof that no choice is better, or how far the best is at most.

use super::criterion::Criterion;
use super::pool::Pool;
use super::relaxation::{Fixed, Relaxed, ranked, relax, start_weights};
use super::search::{Choice, exchange};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A node is closed where it cannot be better than the best by more than this: rounding.
const BETTER: f64 = 1.0 + 1e-9;
/// Steps of a relaxation at the root and at each node below.
const STEPS: (usize, usize) = (3000, 60);

/// The best choice found, and what is proven of it.
#[derive(Clone, Debug)]
pub struct Proven {
    /// The choice.
    pub best: Choice,
    /// No choice has a larger criterion than this.
    pub bound: f64,
    /// The same from the relaxation alone.
    pub relaxation: f64,
    /// Nodes looked at.
    pub nodes: usize,
}

struct Node {
    bound: f64,
    fixed: Vec<Fixed>,
    weights: Vec<f64>,
    number: usize,
}

impl PartialEq for Node {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Node {}
impl PartialOrd for Node {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Node {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound).then(other.number.cmp(&self.number))
    }
}

/// Looks at up to `nodes` nodes, those with the largest bound first; `None` where no bound is known.
pub fn branch_and_bound(pool: &Pool, criterion: Criterion, first: Choice, nodes: usize) -> Option<Proven> {
    let count = first.chosen.len();
    let root = vec![Fixed::Free; pool.candidates.len()];
    let weights = start_weights(&root, count, None);
    let relaxed = relax(pool, criterion, &root, count, weights, STEPS.0, 1e-7)?;
    let relaxation = relaxed.bound.max(first.value);
    let mut best = first;
    let mut looked = 0;
    let mut open = BinaryHeap::new();
    open.extend(node(relaxed, root, count, best.value, 0));
    while let Some(Node { bound, fixed, weights, .. }) = open.pop() {
        if bound <= best.value * BETTER {
            open.clear();
            break;
        }
        if looked >= nodes {
            return Some(Proven { bound: bound.min(relaxation), best, relaxation, nodes: looked });
        }
        if let Some(whole) = decided(&fixed, count) {
            let choice = Choice::of(pool, criterion, whole);
            if choice.value > best.value {
                best = choice;
            }
            continue;
        }
        let undecided = |i: &usize| fixed[*i] == Fixed::Free;
        let half = |i: usize| (weights[i] - 0.5).abs();
        let Some(split) = (0..fixed.len()).filter(undecided).min_by(|&a, &b| half(a).total_cmp(&half(b))) else {
            continue;
        };
        let child = |way: Fixed| {
            let mut fixed = fixed.clone();
            fixed[split] = way;
            let start = start_weights(&fixed, count, Some(&weights));
            let open = decided(&fixed, count).is_none();
            let relaxed = open.then(|| relax(pool, criterion, &fixed, count, start, STEPS.1, 1e-6)).flatten();
            (fixed, relaxed)
        };
        let (with, without) = rayon::join(|| child(Fixed::In), || child(Fixed::Out));
        for (fixed, relaxed) in [with, without] {
            looked += 1;
            if let Some(whole) = decided(&fixed, count) {
                let choice = Choice::of(pool, criterion, whole);
                if choice.value > best.value {
                    best = choice;
                }
                continue;
            }
            let Some(relaxed) = relaxed else { continue };
            let rounded = ranked(&relaxed.weights, &vec![0.0; fixed.len()], &fixed, 0.0);
            if looked % 64 == 1 {
                let taken = fixed.iter().enumerate().filter(|(_, f)| **f == Fixed::In).map(|(i, _)| i);
                let chosen: Vec<usize> = taken.chain(rounded.into_iter().map(|(_, i)| i)).take(count).collect();
                let choice = exchange(pool, criterion, &Choice::of(pool, criterion, chosen));
                if choice.value > best.value * BETTER {
                    best = choice;
                }
            }
            let relaxed = Relaxed { bound: relaxed.bound.min(bound), ..relaxed };
            open.extend(node(relaxed, fixed, count, best.value, looked));
        }
    }
    Some(Proven { bound: best.value, best, relaxation, nodes: looked })
}

/// The choice that is left where all is decided.
fn decided(fixed: &[Fixed], count: usize) -> Option<Vec<usize>> {
    let with = |what: Fixed| fixed.iter().enumerate().filter(move |(_, f)| **f == what).map(|(i, _)| i);
    let taken = with(Fixed::In).count();
    match count - taken.min(count) {
        0 => Some(with(Fixed::In).collect()),
        rest if with(Fixed::Free).count() == rest => Some(with(Fixed::In).chain(with(Fixed::Free)).collect()),
        _ => None,
    }
}

/// A node worth looking into, with everything decided that its bound decides: a candidate is out where even the best
/// choice with it stays below the best known, and in where even the best choice without it does.
fn node(relaxed: Relaxed, mut fixed: Vec<Fixed>, count: usize, best: f64, number: usize) -> Option<Node> {
    let Relaxed { bound, weights, above, below } = relaxed;
    let lambda = best * BETTER;
    if bound <= lambda {
        return None;
    }
    let rest = count.saturating_sub(fixed.iter().filter(|f| **f == Fixed::In).count());
    let taken: f64 = (0..fixed.len()).filter(|&i| fixed[i] == Fixed::In).map(|i| above[i] - lambda * below[i]).sum();
    let gains = ranked(&above, &below, &fixed, lambda);
    if rest == 0 || gains.len() < rest {
        return None;
    }
    let total = taken + gains[..rest].iter().map(|g| g.0).sum::<f64>();
    if total <= 0.0 {
        return None;
    }
    let last = gains[rest - 1].0;
    let next = gains.get(rest).map(|g| g.0);
    for (place, (gain, i)) in gains.iter().enumerate() {
        if place >= rest && total - last + gain <= 0.0 {
            fixed[*i] = Fixed::Out;
        } else if place < rest && next.is_some_and(|next| total - gain + next <= 0.0) {
            fixed[*i] = Fixed::In;
        }
    }
    Some(Node { bound, fixed, weights, number })
}
