//! Search for a choice: greedy (the thesis' procedure), and exchange from several starts.

use super::criterion::{Below, Candidate, Criterion, Pool, Tangent, inner};
use super::packed::{packed_weights, product};
use etalon_base::interruption::checkpoint;
use etalon_base::noise::Noise;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// Minimum improvement of the criterion by an exchange, above rounding.
const IMPROVEMENT: f64 = 1.0 + 1e-10;

/// A set of candidates and its criterion.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// Indices of the candidates, in the order of choosing for greedy choices.
    pub chosen: Vec<usize>,
    /// Criterion, the square of the index.
    pub value: f64,
}

impl Choice {
    /// Creates the choice of these candidates.
    pub fn new(pool: &Pool, chosen: Vec<usize>) -> Self {
        let value = pool.criterion.value(pool, pool.information(&chosen), pool.configurations(&chosen));
        Self { chosen, value }
    }
}

/// Value of a set with one more candidate: the set is decomposed once, candidates follow by
/// low-rank updates.
struct Base<'a> {
    pool: &'a Pool,
    criterion: Criterion,
    information: DMatrix<f64>,
    configurations: usize,
    /// Inverse, the same as weights of inner products, and (JᵀJ)⁻¹ W (JᵀJ)⁻¹ for criteria that
    /// are variances.
    inverse: DMatrix<f64>,
    weights: Vec<f64>,
    kernel: DMatrix<f64>,
    log_determinant: f64,
    variance: f64,
}

impl<'a> Base<'a> {
    fn new(pool: &'a Pool, criterion: Criterion, chosen: &[usize]) -> Option<Self> {
        let information = pool.information(chosen);
        let factor = pool.factor(information.clone())?;
        let inverse = factor.inverse();
        let (kernel, variance) = match criterion {
            Criterion::A => (&inverse * &inverse, inverse.trace()),
            Criterion::I => (&inverse * &pool.workspace * &inverse, inner(&inverse, &pool.workspace)),
            _ => (DMatrix::zeros(0, 0), 0.0),
        };
        Some(Self {
            pool,
            criterion,
            configurations: pool.configurations(chosen),
            kernel,
            log_determinant: factor.ln_determinant(),
            variance,
            weights: packed_weights(&inverse),
            inverse,
            information,
        })
    }

    /// The determinant's criterion with `candidate` added, which increases its logarithm by `gain`.
    fn with_determinant(&self, candidate: &Candidate, gain: f64) -> f64 {
        let mean = ((self.log_determinant + gain) / self.pool.parameters as f64).exp();
        let configurations = self.configurations + candidate.configurations;
        if self.criterion == Criterion::O1 { mean / configurations as f64 } else { mean }
    }

    /// `true` if the criterion with candidate `i` added is certainly below `value`, by a bound that
    /// costs less: of all matrices of one trace, the determinant of a multiple of the identity is
    /// the largest.
    fn is_at_most(&self, i: usize, value: f64) -> bool {
        if !matches!(self.criterion, Criterion::O1 | Criterion::D) {
            return false;
        }
        let candidate = &self.pool.candidates[i];
        let rows = candidate.columns.ncols() as f64;
        let trace = self.pool.contributions.product(&self.weights, i);
        self.with_determinant(candidate, rows * (trace / rows).ln_1p()) < value
    }

    /// The criterion with candidate `i` added.
    fn with(&self, i: usize) -> f64 {
        let candidate = &self.pool.candidates[i];
        let configurations = self.configurations + candidate.configurations;
        match self.criterion {
            Criterion::O1 | Criterion::D => self.with_determinant(candidate, log_update(&self.inverse, candidate)),
            Criterion::A | Criterion::I => {
                // Sherman, Morrison & Woodbury: the variance falls by tr((I + J M⁻¹ Jᵀ)⁻¹ J K Jᵀ)
                let j = &candidate.rows;
                let mut small = j * &self.inverse * j.transpose();
                (0..small.nrows()).for_each(|i| small[(i, i)] += 1.0);
                let falls = j * &self.kernel * j.transpose();
                small.cholesky().map_or(0.0, |s| 1.0 / (self.variance - s.solve(&falls).trace()))
            }
            _ => self.criterion.value(self.pool, &self.information + self.pool.information(&[i]), configurations),
        }
    }
}

/// log det(I + J M⁻¹ Jᵀ), the increase of the logarithm of the determinant.
fn log_update(inverse: &DMatrix<f64>, candidate: &Candidate) -> f64 {
    let (m, rows) = candidate.columns.shape();
    let row = |k: usize| &candidate.columns.as_slice()[k * m..(k + 1) * m];
    // lower triangle of I + J M⁻¹ Jᵀ, row by row
    let mut small = vec![0.0; rows * rows];
    let mut turned = vec![0.0; m];
    for a in 0..rows {
        turned.fill(0.0);
        for (column, value) in inverse.as_slice().chunks_exact(m).zip(row(a)) {
            turned.iter_mut().zip(column).for_each(|(t, v)| *t += value * v);
        }
        for b in a..rows {
            small[b * rows + a] = product(&turned, row(b)) + if a == b { 1.0 } else { 0.0 };
        }
    }
    log_determinant(&mut small, rows).unwrap_or(0.0)
}

/// Logarithm of the determinant of a positive definite matrix, whose lower triangle becomes its
/// Cholesky factor.
fn log_determinant(lower: &mut [f64], n: usize) -> Option<f64> {
    let mut log = 0.0;
    for j in 0..n {
        for i in j..n {
            let (of_i, of_j) = (i * n, j * n);
            let sum = lower[of_i + j] - (0..j).map(|k| lower[of_i + k] * lower[of_j + k]).sum::<f64>();
            lower[of_i + j] = if i > j { sum / lower[of_j + j] } else { Some(sum.sqrt()).filter(|v| *v > 0.0)? };
        }
        log += 2.0 * lower[j * n + j].ln();
    }
    Some(log)
}

/// Adds the best candidate to `start`, one after the other, until `count` are chosen (section 4.5).
/// Until the chosen ones determine all parameters, the determinant decides, for every criterion.
///
/// As long as those chosen do not determine all parameters, the determinant decides, independent of
/// the criterion.
pub fn greedy(pool: &Pool, start: &[usize], count: usize) -> Choice {
    let mut chosen = start.to_vec();
    let mut gains = vec![f64::INFINITY; pool.candidates.len()];
    while chosen.len() < count.min(pool.candidates.len()) {
        checkpoint();
        let mut best = |by: Criterion| {
            let base = Base::new(pool, by, &chosen)?;
            match by {
                Criterion::O1 | Criterion::D => best_determinant(&base, &chosen, &mut gains),
                _ => best_candidate(&base, &chosen),
            }
        };
        match best(pool.criterion).filter(|b| b.0 > 0.0).or_else(|| best(Criterion::D)) {
            Some((_, candidate)) => chosen.push(candidate),
            None => break,
        }
    }
    Choice::new(pool, chosen)
}

/// [`best_candidate`] for determinants without examining all candidates: `gains` are the last
/// computed increases of the logarithm, which are upper bounds because increases fall with every
/// chosen candidate (Minoux 1978).
fn best_determinant(base: &Base, chosen: &[usize], gains: &mut [f64]) -> Option<(f64, usize)> {
    let candidates = &base.pool.candidates;
    let value = |i: usize, gain: f64| base.with_determinant(&candidates[i], gain);
    let free = (0..candidates.len()).filter(|i| !chosen.contains(i));
    let mut hopes: Vec<(f64, usize)> = free.map(|i| (value(i, gains[i]), i)).collect();
    hopes.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut best: Option<(f64, usize)> = None;
    for (hope, i) in hopes {
        if best.is_some_and(|(value, _)| hope * IMPROVEMENT < value) {
            break;
        }
        gains[i] = log_update(&base.inverse, &candidates[i]);
        let now = value(i, gains[i]);
        if best.is_none_or(|(value, first)| now > value || now == value && i < first) {
            best = Some((now, i));
        }
    }
    best
}

/// The best candidate that is not chosen yet, with its criterion; among equal ones the first.
fn best_candidate(base: &Base, chosen: &[usize]) -> Option<(f64, usize)> {
    let free = (0..base.pool.candidates.len()).filter(|i| !chosen.contains(i));
    free.map(|i| (base.with(i), i)).fold(None, |best, now| match best {
        Some((value, _)) if now.0 <= value => best,
        _ => Some(now),
    })
}

/// Upper bounds of the criterion after an exchange, from one tangent: the numerator of a criterion
/// is concave, so that its derivative at the present choice bounds every other choice.
struct Screen {
    tangent: Tangent,
    /// Contribution of each candidate to the numerator, and to a denominator that depends on it.
    above: Vec<f64>,
    below: Vec<f64>,
}

impl Screen {
    /// `None` if no bound is known.
    fn new(pool: &Pool, chosen: &[usize]) -> Option<Self> {
        let information = pool.information(chosen);
        let tangent = pool.criterion.tangent(pool, &information, pool.configurations(chosen) as f64)?;
        let below = match &tangent.below {
            Below::Configurations => pool.candidates.iter().map(|c| c.configurations as f64).collect(),
            Below::One => Vec::new(),
            Below::Largest(by) => pool.contributions.products(by),
        };
        Some(Self { above: pool.contributions.products(&tangent.above), below, tangent })
    }

    /// Candidates that may be better than `least` in exchange for the chosen one at `place`, with
    /// the upper bounds, best first.
    fn hopes(&self, chosen: &[usize], place: usize, least: f64) -> Vec<(f64, usize)> {
        let out = chosen[place];
        let rest = self.tangent.numerator - self.above[out];
        let below: f64 = chosen.iter().filter(|i| **i != out).filter_map(|&i| self.below.get(i)).sum();
        let hope = |i: usize| {
            let denominator = self.below.get(i).map_or(1.0, |b| below + b);
            (rest + self.above[i]) / denominator
        };
        let free = (0..self.above.len()).filter(|i| !chosen.contains(i));
        let mut hopes: Vec<(f64, usize)> = free.map(|i| (hope(i), i)).filter(|(hope, _)| *hope > least).collect();
        hopes.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        hopes
    }
}

/// The best candidate in exchange for the chosen one at `place`, if one may be better; among equal
/// ones the first. Only candidates whose bound is better are evaluated.
fn best_exchange(pool: &Pool, present: &Choice, place: usize, screen: Option<&Screen>) -> Option<(f64, usize)> {
    let chosen = &present.chosen;
    let mut rest = chosen.clone();
    rest.swap_remove(place);
    let Some(screen) = screen else {
        return best_candidate(&Base::new(pool, pool.criterion, &rest)?, chosen);
    };
    let hopes = screen.hopes(chosen, place, present.value * IMPROVEMENT);
    if hopes.is_empty() {
        return None;
    }
    let base = Base::new(pool, pool.criterion, &rest)?;
    let mut best: Option<(f64, usize)> = None;
    for (hope, i) in hopes {
        if best.is_some_and(|(value, _)| hope < value) {
            break;
        }
        let least = best.map_or(present.value, |(value, _)| value);
        if base.is_at_most(i, least) {
            continue;
        }
        let now = base.with(i);
        if best.is_none_or(|(value, first)| now > value || now == value && i < first) {
            best = Some((now, i));
        }
    }
    best
}

/// Exchanges one candidate at a time for a better one until none is left (Fedorov 1972, modified by
/// Cook & Nachtsheim 1980: each position in turn).
pub fn exchange(pool: &Pool, start: &Choice) -> Choice {
    let mut best = start.clone();
    let mut screen = Screen::new(pool, &best.chosen);
    let mut unchanged = 0;
    let mut place = 0;
    while unchanged < best.chosen.len() {
        checkpoint();
        unchanged += 1;
        let found = best_exchange(pool, &best, place, screen.as_ref()).filter(|f| f.0 > best.value * IMPROVEMENT);
        if let Some((_, candidate)) = found {
            let mut chosen = best.chosen.clone();
            chosen[place] = candidate;
            let exchanged = Choice::new(pool, chosen);
            if exchanged.value > best.value * IMPROVEMENT {
                best = exchanged;
                screen = Screen::new(pool, &best.chosen);
                unchanged = 0;
            }
        }
        place = (place + 1) % best.chosen.len();
    }
    best
}

/// The best exchange from `first` and from `starts` random sets of as many candidates; `ended` is
/// called after each.
pub fn exchange_from_many(pool: &Pool, first: &[Choice], starts: u64, seed: u64, ended: impl Fn() + Sync) -> Choice {
    let count = first.first().map_or(0, |c| c.chosen.len());
    let random = |trial: u64| {
        let mut noise = Noise::new(seed, trial);
        let mut left: Vec<usize> = (0..pool.candidates.len()).collect();
        let mut draw = || {
            let at = ((noise.uniform(0.5) + 0.5) * left.len() as f64) as usize;
            left.swap_remove(at.min(left.len() - 1))
        };
        Choice::new(pool, (0..count.min(pool.candidates.len())).map(|_| draw()).collect())
    };
    let all: Vec<Choice> = first.iter().cloned().chain((0..starts).map(random)).collect();
    let exchanged = |start: &Choice| {
        let found = exchange(pool, start);
        ended();
        found
    };
    let found: Vec<Choice> = all.par_iter().map(exchanged).collect();
    let better = |a: Choice, b: Choice| if b.value > a.value * IMPROVEMENT { b } else { a };
    found.into_iter().reduce(better).unwrap_or(Choice { chosen: Vec::new(), value: 0.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Exchanges by the definition: every candidate at every place is evaluated.
    fn by_definition(pool: &Pool, start: &Choice) -> Choice {
        let mut best = start.clone();
        let mut changed = true;
        while changed {
            changed = false;
            for place in 0..best.chosen.len() {
                let free = (0..pool.candidates.len()).filter(|i| !best.chosen.contains(i));
                let all = free.map(|i| {
                    let mut chosen = best.chosen.clone();
                    chosen[place] = i;
                    Choice::new(pool, chosen)
                });
                let found = all.max_by(|a, b| a.value.total_cmp(&b.value)).unwrap();
                if found.value > best.value * IMPROVEMENT {
                    (best, changed) = (found, true);
                }
            }
        }
        best
    }

    #[test]
    fn screened_exchanges_end_where_exchanges_by_definition_do() {
        for (criterion, trial) in Criterion::ALL.into_iter().flat_map(|c| (0..4).map(move |t| (c, t))) {
            let mut noise = Noise::new(7, trial);
            let scale: Vec<f64> = (0..4).map(|_| 1.0 + noise.uniform(0.5)).collect();
            let block = |_| {
                let configurations = 1 + ((noise.uniform(1.0) + 1.0) * 1.4) as usize;
                let size = 1.0 + noise.uniform(0.9);
                ((0..8 * configurations).map(|_| size * noise.gaussian(1.0)).collect(), configurations)
            };
            let blocks: Vec<(Vec<f64>, usize)> = (0..15).map(block).collect();
            let pool = Pool::new(&blocks, scale, criterion);
            for first in 0..3 {
                let start = Choice::new(&pool, (0..5).map(|k| (3 * k + first) % 15).collect());
                let (found, expected) = (exchange(&pool, &start), by_definition(&pool, &start));
                assert!((found.value / expected.value - 1.0).abs() < 1e-9, "{criterion:?} {found:?} {expected:?}");
            }
        }
    }
}
