//! Proof that no choice is better, or a bound on the best choice: candidates may be taken in parts,
//! the optimum over parts bounds every whole choice, and branch and bound closes the gap.

use super::criterion::{Below, Pool, Tangent, inner};
use super::search::{Choice, exchange};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Rounding tolerance: a node is closed if it cannot exceed the best choice by more than this.
const BETTER: f64 = 1.0 + 1e-9;
/// Termination of a relaxation: a number of steps, or a relative distance of the bound from the
/// value reached.
#[derive(Clone, Copy)]
struct End {
    steps: usize,
    /// Fraction of the criterion.
    close: f64,
}

/// End of the relaxation at the root, and at each node below.
const ROOT: End = End { steps: 3000, close: 1e-7 };
const BELOW: End = End { steps: 60, close: 1e-6 };

/// The best choice found, and the bound that is proven for it.
#[derive(Clone, Debug)]
pub struct Proven {
    /// The choice.
    pub best: Choice,
    /// Upper bound of the criterion over all choices.
    pub bound: f64,
    /// Bound by the relaxation alone.
    pub relaxation: f64,
    /// Number of nodes examined.
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

/// Examines up to `nodes` nodes, those with the largest bound first, and calls `progress` with
/// their number; `None` if no bound is known.
pub fn branch_and_bound(pool: &Pool, first: Choice, nodes: usize, progress: impl Fn(usize)) -> Option<Proven> {
    let count = first.chosen.len();
    let root = vec![Fixed::Free; pool.candidates.len()];
    let relaxed = relax(pool, &root, count, None, ROOT)?;
    let relaxation = relaxed.bound.max(first.value);
    let mut best = first;
    let mut looked = 0;
    let mut open = BinaryHeap::new();
    open.extend(node(relaxed, root, count, best.value, 0));
    while let Some(Node { bound, fixed, weights, .. }) = open.pop() {
        progress(looked);
        if bound <= best.value * BETTER {
            open.clear();
            break;
        }
        if looked >= nodes {
            return Some(Proven { bound: bound.min(relaxation), best, relaxation, nodes: looked });
        }
        if let Some(whole) = decided(&fixed, count) {
            let choice = Choice::of(pool, whole);
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
            let open = decided(&fixed, count).is_none();
            let relaxed = open.then(|| relax(pool, &fixed, count, Some(&weights), BELOW)).flatten();
            (fixed, relaxed)
        };
        let (with, without) = rayon::join(|| child(Fixed::In), || child(Fixed::Out));
        for (fixed, relaxed) in [with, without] {
            looked += 1;
            if let Some(whole) = decided(&fixed, count) {
                let choice = Choice::of(pool, whole);
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
                let choice = exchange(pool, &Choice::of(pool, chosen));
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

/// The remaining choice if every candidate is decided.
fn decided(fixed: &[Fixed], count: usize) -> Option<Vec<usize>> {
    let with = |what: Fixed| fixed.iter().enumerate().filter(move |(_, f)| **f == what).map(|(i, _)| i);
    let taken = with(Fixed::In).count();
    match count - taken.min(count) {
        0 => Some(with(Fixed::In).collect()),
        rest if with(Fixed::Free).count() == rest => Some(with(Fixed::In).chain(with(Fixed::Free)).collect()),
        _ => None,
    }
}

/// A node worth examining, after all decisions by its bound: a candidate is excluded if even the
/// best choice with it is below the best known one, and included if even the best choice without it
/// is.
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

/// State of a candidate in a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fixed {
    /// Free: may be taken or left.
    Free,
    /// Taken.
    In,
    /// Left out.
    Out,
}

/// An upper bound of the criterion over all choices that a [`Fixed`] list allows.
struct Relaxed {
    bound: f64,
    /// Shares of the candidates, the best found with fractional candidates.
    weights: Vec<f64>,
    /// Maximum contribution of each candidate to the numerator.
    above: Vec<f64>,
    /// Contribution of each candidate to the denominator.
    below: Vec<f64>,
}

/// Initial shares: the given ones, adapted to `fixed` and to the sum `count`.
fn start_weights(fixed: &[Fixed], count: usize, near: Option<&[f64]>) -> Vec<f64> {
    let taken = fixed.iter().filter(|f| **f == Fixed::In).count();
    let free = fixed.iter().filter(|f| **f == Fixed::Free).count();
    let rest = count.saturating_sub(taken) as f64;
    let even = if free > 0 { rest / free as f64 } else { 0.0 };
    let sum: f64 = near.map_or(0.0, |w| w.iter().zip(fixed).filter(|(_, f)| **f == Fixed::Free).map(|(w, _)| w).sum());
    let share = |i: usize| match (fixed[i], near) {
        (Fixed::In, _) => 1.0,
        (Fixed::Out, _) => 0.0,
        // half of what was there, half even: scaled to the sum, it stays below 1 where both are
        (Fixed::Free, Some(w)) if sum > rest => 0.9 * w[i] * rest / sum + 0.1 * even,
        (Fixed::Free, Some(w)) if sum < free as f64 => {
            let fill = (rest - sum) / (free as f64 - sum);
            0.9 * (w[i] + (1.0 - w[i]) * fill) + 0.1 * even
        }
        (Fixed::Free, _) => even,
    };
    (0..fixed.len()).map(share).collect()
}

/// Moves shares from the worst to the best candidate (vertex exchange: Böhning 1986) until the
/// bound is within `close` of the value of the shares, or `steps` are used. The bound is valid
/// after every step.
fn relax(
    pool: &Pool,
    fixed: &[Fixed],
    count: usize,
    near: Option<&[f64]>,
    End { steps, close }: End,
) -> Option<Relaxed> {
    let mut weights = start_weights(fixed, count, near);
    let n = pool.candidates.len();
    let mut best: Option<Relaxed> = None;
    for step in 0..=steps {
        let information = pool.weighted(&weights);
        let configurations: f64 = weights.iter().zip(&pool.candidates).map(|(w, c)| w * c.configurations as f64).sum();
        let tangent = pool.criterion.tangent(pool, &information, configurations)?;
        // what the ridge adds is shared among those chosen
        let ridge = pool.ridge * tangent.above.trace() / count as f64;
        let above: Vec<f64> = pool.candidates.iter().map(|c| inner(&tangent.above, &c.information) + ridge).collect();
        let below = denominators(pool, &tangent, count);
        let denominator: f64 = weights.iter().zip(&below).map(|(w, b)| w * b).sum();
        let bound = largest_quotient(&above, &below, fixed, count, tangent.value);
        let slope = |i: usize| {
            above[i] / tangent.numerator - if gradient_below(&tangent) { below[i] / denominator } else { 0.0 }
        };
        let free = || (0..n).filter(|&i| fixed[i] == Fixed::Free);
        let to = free().filter(|&i| weights[i] < 1.0).max_by(|&a, &b| slope(a).total_cmp(&slope(b)));
        let from = free().filter(|&i| weights[i] > 0.0).min_by(|&a, &b| slope(a).total_cmp(&slope(b)));
        // what all shares together can still gain, as a fraction of the criterion
        let pair = to.zip(from).filter(|&(to, from)| count as f64 * (slope(to) - slope(from)) > close);
        let reached = tangent.value;
        if best.as_ref().is_none_or(|b| bound < b.bound) {
            best = Some(Relaxed { bound, weights: weights.clone(), above, below });
        }
        let Some((to, from)) = pair else { break };
        if step == steps || bound <= reached * (1.0 + close) {
            break;
        }
        let most = (1.0 - weights[to]).min(weights[from]);
        let share = line_search(pool, &information, configurations, (to, from), most);
        if share >= most {
            // exactly to the end, so that the pair is done with
            let (full, empty) = (weights[to] + most, weights[from] - most);
            weights[to] = if 1.0 - full < 1e-12 { 1.0 } else { full };
            weights[from] = if empty < 1e-12 { 0.0 } else { empty };
        } else {
            weights[to] += share;
            weights[from] -= share;
        }
    }
    best
}

/// The share whose move maximises the criterion: the zero of its derivative in [0, `most`].
fn line_search(
    pool: &Pool,
    information: &nalgebra::DMatrix<f64>,
    configurations: f64,
    (to, from): (usize, usize),
    most: f64,
) -> f64 {
    let direction = &pool.candidates[to].information - &pool.candidates[from].information;
    let more = pool.candidates[to].configurations as f64 - pool.candidates[from].configurations as f64;
    let slope = |share: f64| {
        let moved = information + &direction * share;
        // past where the information is singular nothing rises
        let Some(t) = pool.criterion.tangent(pool, &moved, configurations + share * more) else { return -1.0 };
        let below = match &t.below {
            Below::Configurations => more / (configurations + share * more),
            Below::One => 0.0,
            Below::Largest(p) => inner(p, &direction) / inner(p, &moved),
        };
        inner(&t.above, &direction) / t.numerator - below
    };
    let at_most = slope(most);
    if at_most > 0.0 {
        return most;
    }
    let (mut low, mut high) = ((0.0, slope(0.0)), (most, at_most));
    for _ in 0..22 {
        // the secant between both ends; the weight of an end that stays is halved (Illinois: Dowell
        // & Jarratt 1971)
        let secant = low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1);
        let middle = if secant > low.0 && secant < high.0 { secant } else { 0.5 * (low.0 + high.0) };
        let now = slope(middle);
        if now.abs() <= 1e-6 * low.1.abs().max(high.1.abs()) || high.0 - low.0 <= 1e-7 * most {
            return middle;
        }
        if now > 0.0 {
            (low, high.1) = ((middle, now), 0.5 * high.1);
        } else {
            (high, low.1) = ((middle, now), 0.5 * low.1);
        }
    }
    0.5 * (low.0 + high.0)
}

fn gradient_below(tangent: &Tangent) -> bool {
    !matches!(tangent.below, Below::One)
}

/// Contribution of each candidate to the denominator; constant ones are distributed over the chosen
/// candidates.
fn denominators(pool: &Pool, tangent: &Tangent, count: usize) -> Vec<f64> {
    let of = |c: &super::criterion::Candidate| match &tangent.below {
        Below::Configurations => c.configurations as f64,
        Below::One => 1.0 / count as f64,
        Below::Largest(p) => inner(p, &c.information),
    };
    pool.candidates.iter().map(of).collect()
}

/// Order of the free candidates by above − λ below, best first.
fn ranked(above: &[f64], below: &[f64], fixed: &[Fixed], lambda: f64) -> Vec<(f64, usize)> {
    let free = (0..fixed.len()).filter(|&i| fixed[i] == Fixed::Free);
    let mut gains: Vec<(f64, usize)> = free.map(|i| (above[i] - lambda * below[i], i)).collect();
    gains.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    gains
}

/// The largest Σ above / Σ below over `count` candidates (Dinkelbach 1967).
fn largest_quotient(above: &[f64], below: &[f64], fixed: &[Fixed], count: usize, start: f64) -> f64 {
    let taken: Vec<usize> = (0..fixed.len()).filter(|&i| fixed[i] == Fixed::In).collect();
    let mut lambda = start;
    for _ in 0..50 {
        let rest = count.saturating_sub(taken.len());
        let best = ranked(above, below, fixed, lambda).into_iter().take(rest).map(|(_, i)| i);
        let (a, b) = taken.iter().copied().chain(best).fold((0.0, 0.0), |(a, b), i| (a + above[i], b + below[i]));
        let quotient = a / b;
        // up to rounding the quotient never falls
        if quotient.is_nan() {
            break;
        }
        if quotient <= lambda * (1.0 + 1e-14) {
            return quotient.max(lambda);
        }
        lambda = quotient;
    }
    // no number, no bound
    f64::INFINITY
}
