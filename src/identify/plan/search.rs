//! Search for a choice: greedy (the thesis' procedure), and exchange from several starts.

use super::criterion::{Candidate, Criterion, Pool, inner};
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
    pub fn of(pool: &Pool, chosen: Vec<usize>) -> Self {
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
    /// Inverse, and (JᵀJ)⁻¹ W (JᵀJ)⁻¹ for criteria that are variances.
    inverse: DMatrix<f64>,
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

    /// The criterion with `candidate` added.
    fn with(&self, candidate: &Candidate) -> f64 {
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
            _ => self.criterion.value(self.pool, &self.information + &candidate.information, configurations),
        }
    }
}

/// log det(I + J M⁻¹ Jᵀ), the increase of the logarithm of the determinant.
fn log_update(inverse: &DMatrix<f64>, candidate: &Candidate) -> f64 {
    let j = &candidate.rows;
    let mut small = (j * inverse) * j.transpose();
    (0..small.nrows()).for_each(|i| small[(i, i)] += 1.0);
    small.cholesky().map_or(0.0, |s| s.ln_determinant())
}

/// Adds the best candidate to `start`, one after the other, until `count` are chosen (section 4.5).
/// Until the chosen ones determine all parameters, the determinant decides, for every criterion.
///
/// As long as those chosen do not determine all parameters, the determinant decides, whatever the
/// criterion.
pub fn greedy(pool: &Pool, start: &[usize], count: usize) -> Choice {
    let mut chosen = start.to_vec();
    let mut gains = vec![f64::INFINITY; pool.candidates.len()];
    while chosen.len() < count.min(pool.candidates.len()) {
        let mut best = |by: Criterion| {
            let base = Base::new(pool, by, &chosen)?;
            match by {
                Criterion::O1 | Criterion::D => best_determinant(&base, &chosen, &mut gains),
                _ => best_of(&base, &chosen),
            }
        };
        match best(pool.criterion).filter(|b| b.0 > 0.0).or_else(|| best(Criterion::D)) {
            Some((_, candidate)) => chosen.push(candidate),
            None => break,
        }
    }
    Choice::of(pool, chosen)
}

/// [`best_of`] for determinants without examining all candidates: `gains` are the last computed
/// increases of the logarithm, which are upper bounds because increases fall with every chosen
/// candidate (Minoux 1978).
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
fn best_of(base: &Base, chosen: &[usize]) -> Option<(f64, usize)> {
    let free = (0..base.pool.candidates.len()).filter(|i| !chosen.contains(i));
    free.map(|i| (base.with(&base.pool.candidates[i]), i)).fold(None, |best, now| match best {
        Some((value, _)) if now.0 <= value => best,
        _ => Some(now),
    })
}

/// Exchanges one candidate at a time for a better one until none is left (Fedorov 1972, modified by
/// Cook & Nachtsheim 1980: each position in turn).
pub fn exchange(pool: &Pool, start: &Choice) -> Choice {
    let mut best = start.clone();
    let mut changed = true;
    while changed {
        changed = false;
        for place in 0..best.chosen.len() {
            let mut rest = best.chosen.clone();
            rest.swap_remove(place);
            let Some(base) = Base::new(pool, pool.criterion, &rest) else { continue };
            let Some((value, candidate)) = best_of(&base, &best.chosen) else { continue };
            if value <= best.value * IMPROVEMENT {
                continue;
            }
            let mut chosen = best.chosen.clone();
            chosen[place] = candidate;
            let exchanged = Choice::of(pool, chosen);
            if exchanged.value > best.value * IMPROVEMENT {
                best = exchanged;
                changed = true;
            }
        }
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
        Choice::of(pool, (0..count.min(pool.candidates.len())).map(|_| draw()).collect())
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
