//! Choosing: one after the other (the thesis' way), and exchange from several starts.

use super::criterion::Criterion;
use super::pool::{Candidate, Pool, inner};
use crate::noise::Noise;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// An exchange must improve the criterion by more than rounding does.
const IMPROVEMENT: f64 = 1.0 + 1e-10;

/// A set of candidates and the criterion of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// Indices of the candidates; greedy choices in the order of choosing.
    pub chosen: Vec<usize>,
    /// Criterion, the square of the index.
    pub value: f64,
}

impl Choice {
    /// The choice of these candidates.
    pub fn of(pool: &Pool, criterion: Criterion, chosen: Vec<usize>) -> Self {
        let value = criterion.value(pool, pool.information(&chosen), pool.configurations(&chosen));
        Self { chosen, value }
    }
}

/// What one more candidate makes of a set: the set is decomposed once, candidates come by updates of low rank.
struct Base<'a> {
    pool: &'a Pool,
    criterion: Criterion,
    information: DMatrix<f64>,
    configurations: usize,
    /// inverse, and (JᵀJ)⁻¹ W (JᵀJ)⁻¹ for variances
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
        let weight = (criterion == Criterion::I).then(|| pool.workspace.clone());
        let weight = weight.unwrap_or_else(|| DMatrix::identity(pool.parameters, pool.parameters));
        Some(Self {
            pool,
            criterion,
            configurations: pool.configurations(chosen),
            kernel: &inverse * &weight * &inverse,
            log_determinant: factor.ln_determinant(),
            variance: inner(&inverse, &weight),
            inverse,
            information,
        })
    }

    /// The criterion with `candidate` added.
    fn with(&self, candidate: &Candidate) -> f64 {
        let configurations = self.configurations + candidate.configurations;
        match self.criterion {
            Criterion::O1 | Criterion::D => {
                let log_determinant = self.log_determinant + log_update(&self.inverse, candidate);
                let mean = (log_determinant / self.pool.parameters as f64).exp();
                if self.criterion == Criterion::O1 { mean / configurations as f64 } else { mean }
            }
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

/// log det(I + J M⁻¹ Jᵀ), by which the determinant grows.
fn log_update(inverse: &DMatrix<f64>, candidate: &Candidate) -> f64 {
    let j = &candidate.rows;
    let mut small = (j * inverse) * j.transpose();
    (0..small.nrows()).for_each(|i| small[(i, i)] += 1.0);
    small.cholesky().map_or(0.0, |s| s.ln_determinant())
}

/// Adds the best candidate to `start`, one after the other, until `count` are chosen (section 4.5).
///
/// As long as those chosen cannot tell all parameters apart, the determinant decides, whatever the criterion.
pub fn greedy(pool: &Pool, criterion: Criterion, start: &[usize], count: usize) -> Choice {
    let mut chosen = start.to_vec();
    while chosen.len() < count.min(pool.candidates.len()) {
        let best = |by: Criterion| best_of(&Base::new(pool, by, &chosen)?, &chosen);
        match best(criterion).filter(|b| b.0 > 0.0).or_else(|| best(Criterion::D)) {
            Some((_, candidate)) => chosen.push(candidate),
            None => break,
        }
    }
    Choice::of(pool, criterion, chosen)
}

/// The best candidate that is not chosen yet, with its criterion; of equal ones the first.
fn best_of(base: &Base, chosen: &[usize]) -> Option<(f64, usize)> {
    let free = (0..base.pool.candidates.len()).filter(|i| !chosen.contains(i));
    free.map(|i| (base.with(&base.pool.candidates[i]), i)).fold(None, |best, now| match best {
        Some((value, _)) if now.0 <= value => best,
        _ => Some(now),
    })
}

/// Exchanges one candidate at a time for a better one until none is left (Fedorov 1972, modified by Cook & Nachtsheim
/// 1980: each place in turn).
pub fn exchange(pool: &Pool, criterion: Criterion, start: &Choice) -> Choice {
    let mut best = start.clone();
    let mut changed = true;
    while changed {
        changed = false;
        for place in 0..best.chosen.len() {
            let mut rest = best.chosen.clone();
            rest.swap_remove(place);
            let Some(base) = Base::new(pool, criterion, &rest) else { continue };
            let Some((value, candidate)) = best_of(&base, &best.chosen) else { continue };
            if value <= best.value * IMPROVEMENT {
                continue;
            }
            let mut chosen = best.chosen.clone();
            chosen[place] = candidate;
            let exchanged = Choice::of(pool, criterion, chosen);
            if exchanged.value > best.value * IMPROVEMENT {
                best = exchanged;
                changed = true;
            }
        }
    }
    best
}

/// The best exchange from `first` and from `starts` random sets of as many candidates.
pub fn exchange_from_many(pool: &Pool, criterion: Criterion, first: &[Choice], starts: u64, seed: u64) -> Choice {
    let count = first.first().map_or(0, |c| c.chosen.len());
    let random = |trial: u64| {
        let mut noise = Noise::new(seed, trial);
        let mut left: Vec<usize> = (0..pool.candidates.len()).collect();
        let mut draw = || {
            let at = ((noise.uniform(0.5) + 0.5) * left.len() as f64) as usize;
            left.swap_remove(at.min(left.len() - 1))
        };
        Choice::of(pool, criterion, (0..count.min(pool.candidates.len())).map(|_| draw()).collect())
    };
    let all: Vec<Choice> = first.iter().cloned().chain((0..starts).map(random)).collect();
    let found: Vec<Choice> = all.par_iter().map(|start| exchange(pool, criterion, start)).collect();
    let better = |a: Choice, b: Choice| if b.value > a.value * IMPROVEMENT { b } else { a };
    found.into_iter().reduce(better).unwrap_or(Choice { chosen: Vec::new(), value: 0.0 })
}
