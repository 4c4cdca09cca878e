//! Proof that no choice is better, or a bound on the best choice: candidates may be taken in parts,
//! the optimum over parts bounds every whole choice, and branch and bound closes the gap.

use super::criterion::{Below, Pool, Tangent};
use super::search::{Choice, exchange};
use etalon_base::interruption::checkpoint;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Rounding tolerance: a node is closed if it cannot exceed the best choice by more than this.
const BETTER: f64 = 1.0 + 1e-9;
/// Termination of a relaxation: a number of steps, or a relative distance of the bound from the
/// value reached.
#[derive(Clone, Copy)]
pub(super) struct End {
    pub(super) steps: usize,
    /// Fraction of the criterion.
    close: f64,
}

/// End of the relaxation at the root, and at each node below.
const ROOT: End = End { steps: 500, close: 1e-7 };
pub(super) const BELOW: End = End { steps: 20, close: 1e-6 };
/// Number of the last values of the criterion above whose smallest a step has to end.
const MEMORY: usize = 8;
/// Share of the rise by the gradient that a step has to reach.
const SUFFICIENT: f64 = 1e-4;
/// Maximum number of halvings of a step.
const HALVINGS: usize = 30;
/// Number of bisections of the common reduction of shares: their interval falls below rounding.
const BISECTIONS: usize = 60;
/// Maximum change of the length of a step from one to the next, as a factor.
const LONGER: f64 = 100.0;

/// The best choice found, and the bound that is shown for it.
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

/// The relaxation of all choices of a number of candidates.
pub struct Root {
    count: usize,
    relaxed: Relaxed,
}

impl Root {
    /// Relaxes the choice of `count` candidates; `None` if no bound is known.
    pub fn new(pool: &Pool, count: usize) -> Option<Self> {
        let fixed = vec![Fixed::Free; pool.candidates.len()];
        relax(pool, &fixed, count, None, ROOT).map(|relaxed| Self { count, relaxed })
    }

    /// Upper bound of the criterion over all choices.
    pub fn bound(&self) -> f64 {
        self.relaxed.bound
    }

    /// Examines up to `nodes` nodes, those with the largest bound first, and calls `progress` with
    /// their number.
    pub fn prove(self, pool: &Pool, first: Choice, nodes: usize, progress: impl Fn(usize)) -> Proven {
        let Self { count, relaxed } = self;
        let relaxation = relaxed.bound.max(first.value);
        let mut best = first;
        let mut looked = 0;
        let mut open = BinaryHeap::new();
        open.extend(node(relaxed, vec![Fixed::Free; pool.candidates.len()], count, best.value, 0));
        while let Some(Node { bound, fixed, weights, .. }) = open.pop() {
            checkpoint();
            progress(looked);
            if bound <= best.value * BETTER {
                open.clear();
                break;
            }
            if looked >= nodes {
                return Proven { bound: bound.min(relaxation), best, relaxation, nodes: looked };
            }
            if let Some(whole) = decided(&fixed, count) {
                let choice = Choice::new(pool, whole);
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
                    let choice = Choice::new(pool, whole);
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
                    let choice = exchange(pool, &Choice::new(pool, chosen));
                    if choice.value > best.value * BETTER {
                        best = choice;
                    }
                }
                let relaxed = Relaxed { bound: relaxed.bound.min(bound), ..relaxed };
                open.extend(node(relaxed, fixed, count, best.value, looked));
            }
        }
        Proven { bound: best.value, best, relaxation, nodes: looked }
    }
}

/// Returns the only remaining choice; `None` if several remain.
fn decided(fixed: &[Fixed], count: usize) -> Option<Vec<usize>> {
    let with = |what: Fixed| fixed.iter().enumerate().filter(move |(_, f)| **f == what).map(|(i, _)| i);
    let taken = with(Fixed::In).count();
    match count - taken.min(count) {
        0 => Some(with(Fixed::In).collect()),
        rest if with(Fixed::Free).count() == rest => Some(with(Fixed::In).chain(with(Fixed::Free)).collect()),
        _ => None,
    }
}

/// Returns a node if its bound exceeds the best known choice, and decides candidates by this bound.
/// A candidate is excluded if no choice with it exceeds the best known choice. It is included if no
/// choice without it does.
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

impl Relaxed {
    fn new(shares: &Shares) -> Self {
        let [above, below] = shares.parts.clone();
        Self { bound: shares.bound, weights: shares.weights.clone(), above, below }
    }
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
        // mostly the earlier share, partly an even one: scaled to the sum, the result is below 1 if
        // both are
        (Fixed::Free, Some(w)) if sum > rest => 0.9 * w[i] * rest / sum + 0.1 * even,
        (Fixed::Free, Some(w)) if sum < free as f64 => {
            let fill = (rest - sum) / (free as f64 - sum);
            0.9 * (w[i] + (1.0 - w[i]) * fill) + 0.1 * even
        }
        (Fixed::Free, _) => even,
    };
    (0..fixed.len()).map(share).collect()
}

/// The criterion at one list of shares, with its gradient and the bound that follows.
struct Shares {
    weights: Vec<f64>,
    /// Criterion of the shares.
    value: f64,
    /// Derivative of the logarithm of the criterion by each share.
    slopes: Vec<f64>,
    /// Bound over all choices.
    bound: f64,
    /// Contributions of each candidate to numerator and denominator of the bound.
    parts: [Vec<f64>; 2],
}

/// A relaxation: the choices that it bounds.
struct Problem<'a> {
    pool: &'a Pool,
    fixed: &'a [Fixed],
    count: usize,
}

impl Problem<'_> {
    /// Tangent of the criterion at shares; `None` if they are singular or no bound is known.
    fn tangent(&self, weights: &[f64]) -> Option<Tangent> {
        let configurations = weights.iter().zip(&self.pool.candidates).map(|(w, c)| w * c.configurations as f64).sum();
        self.pool.criterion.tangent(self.pool, &self.pool.weighted(weights), configurations)
    }

    fn shares(&self, weights: Vec<f64>, tangent: &Tangent) -> Shares {
        // the ridge's contribution is distributed over the chosen candidates
        let ridge = self.pool.ridge * tangent.above.trace() / self.count as f64;
        let mut above = self.pool.contributions.products(&tangent.above);
        above.iter_mut().for_each(|a| *a += ridge);
        let below = denominators(self.pool, tangent, self.count);
        let denominator: f64 = weights.iter().zip(&below).map(|(w, b)| w * b).sum();
        let falls = if matches!(tangent.below, Below::One) { 0.0 } else { denominator.recip() };
        let slopes = above.iter().zip(&below).map(|(a, b)| a / tangent.numerator - b * falls).collect();
        let bound = largest_quotient(&above, &below, self.fixed, self.count, tangent.value);
        Shares { weights, value: tangent.value, slopes, bound, parts: [above, below] }
    }

    /// The nearest shares with the right sum, each between 0 and 1: all free ones are reduced by
    /// the same number, which is bisected.
    fn project(&self, mut weights: Vec<f64>) -> Vec<f64> {
        let is_free = |i: &usize| self.fixed[*i] == Fixed::Free;
        let free: Vec<usize> = (0..weights.len()).filter(is_free).collect();
        let taken = self.fixed.iter().filter(|f| **f == Fixed::In).count();
        let rest = self.count.saturating_sub(taken) as f64;
        let reduced = |by: f64| free.iter().map(|&i| (weights[i] - by).clamp(0.0, 1.0)).sum::<f64>();
        let values = free.iter().map(|&i| weights[i]);
        let mut low = values.clone().fold(f64::INFINITY, f64::min) - 1.0;
        let mut high = values.fold(f64::NEG_INFINITY, f64::max);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if reduced(middle) > rest { low = middle } else { high = middle }
        }
        free.iter().for_each(|&i| weights[i] = (weights[i] - high).clamp(0.0, 1.0));
        weights
    }

    /// The next shares: the whole way, or the first half of it that does not fall below `least`,
    /// the smallest of the last logarithms of the criterion (Grippo, Lampariello & Lucidi 1986).
    fn step(&self, now: &Shares, way: &[f64], rise: f64, least: f64) -> Option<Shares> {
        let mut share = 1.0;
        for _ in 0..HALVINGS {
            let weights: Vec<f64> = now.weights.iter().zip(way).map(|(w, d)| (w + share * d).clamp(0.0, 1.0)).collect();
            match self.tangent(&weights) {
                Some(t) if t.value.ln() >= least + SUFFICIENT * share * rise => return Some(self.shares(weights, &t)),
                _ => share *= 0.5,
            }
        }
        None
    }
}

/// Maximises the criterion over shares by the spectral projected gradient (Birgin, Martínez &
/// Raydan 2000) until the bound is within `close` of the value of the shares, or `steps` are used.
/// The bound is valid after every step.
fn relax(
    pool: &Pool,
    fixed: &[Fixed],
    count: usize,
    near: Option<&[f64]>,
    End { steps, close }: End,
) -> Option<Relaxed> {
    let problem = Problem { pool, fixed, count };
    let weights = start_weights(fixed, count, near);
    let mut now = problem.shares(weights.clone(), &problem.tangent(&weights)?);
    let mut best = Relaxed::new(&now);
    let mut values = vec![now.value.ln()];
    let steepest = now.slopes.iter().fold(0.0f64, |most, s| most.max(s.abs()));
    let mut stride = 1.0 / steepest;
    for _ in 0..steps {
        checkpoint();
        if best.bound <= now.value * (1.0 + close) {
            break;
        }
        let ahead = problem.project(now.weights.iter().zip(&now.slopes).map(|(w, s)| w + stride * s).collect());
        let way: Vec<f64> = ahead.iter().zip(&now.weights).map(|(a, w)| a - w).collect();
        let rise: f64 = way.iter().zip(&now.slopes).map(|(d, s)| d * s).sum();
        let least = values.iter().rev().take(MEMORY).copied().fold(f64::INFINITY, f64::min);
        let Some(next) = (rise > 0.0).then(|| problem.step(&now, &way, rise, least)).flatten() else { break };
        stride = next_stride(&now, &next, stride);
        values.push(next.value.ln());
        if next.bound < best.bound {
            best = Relaxed::new(&next);
        }
        now = next;
    }
    Some(best)
}

/// Length of the next step from the change of the gradient along the last (Barzilai & Borwein
/// 1988).
fn next_stride(last: &Shares, now: &Shares, stride: f64) -> f64 {
    let (mut square, mut curvature) = (0.0, 0.0);
    for i in 0..now.weights.len() {
        let moved = now.weights[i] - last.weights[i];
        square += moved * moved;
        curvature -= moved * (now.slopes[i] - last.slopes[i]);
    }
    let next = if curvature > 0.0 { square / curvature } else { stride * LONGER };
    next.clamp(stride / LONGER, stride * LONGER)
}

/// Contribution of each candidate to the denominator; constant ones are distributed over the chosen
/// candidates.
fn denominators(pool: &Pool, tangent: &Tangent, count: usize) -> Vec<f64> {
    match &tangent.below {
        Below::Configurations => pool.candidates.iter().map(|c| c.configurations as f64).collect(),
        Below::One => vec![1.0 / count as f64; pool.candidates.len()],
        Below::Largest(by) => pool.contributions.products(by),
    }
}

/// Order of the free candidates by above − λ below, best first.
fn ranked(above: &[f64], below: &[f64], fixed: &[Fixed], lambda: f64) -> Vec<(f64, usize)> {
    foremost(above, below, fixed, lambda, usize::MAX)
}

/// The first `most` of [`ranked`].
fn foremost(above: &[f64], below: &[f64], fixed: &[Fixed], lambda: f64, most: usize) -> Vec<(f64, usize)> {
    let free = (0..fixed.len()).filter(|&i| fixed[i] == Fixed::Free);
    let mut gains: Vec<(f64, usize)> = free.map(|i| (above[i] - lambda * below[i], i)).collect();
    let by = |a: &(f64, usize), b: &(f64, usize)| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1));
    if most < gains.len() {
        gains.select_nth_unstable_by(most, by);
        gains.truncate(most);
    }
    gains.sort_by(by);
    gains
}

/// The largest Σ above / Σ below over `count` candidates (Dinkelbach 1967).
fn largest_quotient(above: &[f64], below: &[f64], fixed: &[Fixed], count: usize, start: f64) -> f64 {
    let taken: Vec<usize> = (0..fixed.len()).filter(|&i| fixed[i] == Fixed::In).collect();
    let mut lambda = start;
    for _ in 0..50 {
        let rest = count.saturating_sub(taken.len());
        let best = foremost(above, below, fixed, lambda, rest).into_iter().map(|(_, i)| i);
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
