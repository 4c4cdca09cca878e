//! How good any choice can be: candidates may be taken in parts, and the best of that bounds every whole choice.

use super::criterion::{Below, Criterion, Tangent};
use super::pool::{Pool, inner};

/// Which candidates a bound is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fixed {
    /// May be taken or left.
    Free,
    /// Is taken.
    In,
    /// Is left.
    Out,
}

/// An upper bound of the criterion over all choices that a [`Fixed`] list allows.
pub struct Relaxed {
    /// The bound.
    pub bound: f64,
    /// Shares of the candidates, the best found in parts.
    pub weights: Vec<f64>,
    /// What each candidate brings at most to the numerator.
    pub above: Vec<f64>,
    /// What each brings to the denominator.
    pub below: Vec<f64>,
}

/// Shares with which to start: those given, brought to what `fixed` allows and to the sum `count`.
pub fn start_weights(fixed: &[Fixed], count: usize, near: Option<&[f64]>) -> Vec<f64> {
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

/// Moves shares from the worst to the best candidate (vertex exchange: Böhning 1986) until the bound is within `close` of
/// what the shares reach, or `steps` are taken. The bound holds wherever it stops.
pub fn relax(
    pool: &Pool,
    criterion: Criterion,
    fixed: &[Fixed],
    count: usize,
    mut weights: Vec<f64>,
    steps: usize,
    close: f64,
) -> Option<Relaxed> {
    let n = pool.candidates.len();
    let mut best: Option<Relaxed> = None;
    for step in 0..=steps {
        let information = pool.weighted(&weights);
        let configurations: f64 = weights.iter().zip(&pool.candidates).map(|(w, c)| w * c.configurations as f64).sum();
        let tangent = criterion.tangent(pool, &information, configurations)?;
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
        let share = line_search(pool, criterion, &information, configurations, (to, from), most);
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

/// The share to move that maximises the criterion: its derivative is brought to zero in [0, `most`].
fn line_search(
    pool: &Pool,
    criterion: Criterion,
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
        let Some(t) = criterion.tangent(pool, &moved, configurations + share * more) else { return -1.0 };
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
        // the secant between both ends; the weight of an end that stays is halved (Illinois: Dowell & Jarratt 1971)
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

/// What each candidate brings to the denominator; constant ones are shared among those chosen.
fn denominators(pool: &Pool, tangent: &Tangent, count: usize) -> Vec<f64> {
    let of = |c: &super::pool::Candidate| match &tangent.below {
        Below::Configurations => c.configurations as f64,
        Below::One => 1.0 / count as f64,
        Below::Largest(p) => inner(p, &c.information),
    };
    pool.candidates.iter().map(of).collect()
}

/// Order of the free candidates by above − λ below, best first.
pub fn ranked(above: &[f64], below: &[f64], fixed: &[Fixed], lambda: f64) -> Vec<(f64, usize)> {
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
