//! A problem with some parameters held, with other weights, or with prior knowledge as more rows.

use super::Problem;

/// A problem in some of its parameters, the others held.
#[derive(Clone, Debug)]
pub struct Held<'a, P> {
    problem: &'a P,
    /// All parameters; those in `free` are replaced.
    at: Vec<f64>,
    free: Vec<usize>,
}

impl<'a, P: Problem> Held<'a, P> {
    /// `problem` in its parameters `free` (indices, ascending), the others held at their values in `at`.
    pub fn new(problem: &'a P, at: &[f64], free: &[usize]) -> Self {
        let free = free.iter().copied().filter(|&i| i < at.len()).collect();
        Self { problem, at: at.to_vec(), free }
    }

    /// All parameters where the free ones are `x`.
    pub fn all(&self, x: &[f64]) -> Vec<f64> {
        let mut all = self.at.clone();
        self.free.iter().zip(x).for_each(|(&i, x)| all[i] = *x);
        all
    }

    /// The free ones of all parameters.
    pub fn chosen(&self, all: &[f64]) -> Vec<f64> {
        self.free.iter().map(|&i| all[i]).collect()
    }
}

impl<P: Problem> Problem for Held<'_, P> {
    fn residual_count(&self) -> usize {
        self.problem.residual_count()
    }

    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        self.problem.residuals(&self.all(x), r);
    }

    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        let n = self.at.len();
        let mut whole = vec![0.0; self.residual_count() * n];
        self.problem.jacobian(&self.all(x), &mut whole);
        for (chosen, row) in jacobian.chunks_exact_mut(self.free.len().max(1)).zip(whole.chunks_exact(n.max(1))) {
            chosen.iter_mut().zip(&self.free).for_each(|(j, &i)| *j = row[i]);
        }
    }

    fn prior_count(&self) -> usize {
        self.problem.prior_count()
    }
}

/// A problem whose squared residuals count with a weight each.
#[derive(Clone, Debug)]
pub struct Weighted<'a, P> {
    problem: &'a P,
    roots: Vec<f64>,
}

impl<'a, P: Problem> Weighted<'a, P> {
    /// `weights` are not negative, one a residual: 1/u² of residuals that were not divided by their u. A residual
    /// beyond the last weight counts as it is.
    pub fn new(problem: &'a P, weights: &[f64]) -> Self {
        Self { problem, roots: weights.iter().map(|w| w.sqrt()).collect() }
    }
}

impl<P: Problem> Problem for Weighted<'_, P> {
    fn residual_count(&self) -> usize {
        self.problem.residual_count()
    }

    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        self.problem.residuals(x, r);
        r.iter_mut().zip(&self.roots).for_each(|(r, root)| *r *= root);
    }

    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        self.problem.jacobian(x, jacobian);
        for (row, root) in jacobian.chunks_exact_mut(x.len().max(1)).zip(&self.roots) {
            row.iter_mut().for_each(|j| *j *= root);
        }
    }

    fn prior_count(&self) -> usize {
        self.problem.prior_count()
    }
}

/// What is known of a parameter before the measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prior {
    /// Index of the parameter.
    pub parameter: usize,
    /// Its expected value.
    pub value: f64,
    /// One over the standard uncertainty of that.
    pub weight: f64,
}

/// A problem with one row (x − value) / u more for every prior: it counts as a residual in chi-square and degrees of
/// freedom.
#[derive(Clone, Debug)]
pub struct WithPriors<'a, P> {
    problem: &'a P,
    priors: Vec<Prior>,
}

impl<'a, P: Problem> WithPriors<'a, P> {
    /// `problem` and what is known before it.
    pub fn new(problem: &'a P, priors: &[Prior]) -> Self {
        Self { problem, priors: priors.to_vec() }
    }
}

impl<P: Problem> Problem for WithPriors<'_, P> {
    fn residual_count(&self) -> usize {
        self.problem.residual_count() + self.priors.len()
    }

    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        let (measured, known) = r.split_at_mut(self.problem.residual_count());
        self.problem.residuals(x, measured);
        for (r, prior) in known.iter_mut().zip(&self.priors) {
            let x = x.get(prior.parameter).copied().unwrap_or(f64::NAN);
            *r = prior.weight * (x - prior.value);
        }
    }

    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        let n = x.len();
        let (measured, known) = jacobian.split_at_mut(self.problem.residual_count() * n);
        self.problem.jacobian(x, measured);
        known.fill(0.0);
        for (row, prior) in known.chunks_exact_mut(n.max(1)).zip(&self.priors) {
            if let Some(j) = row.get_mut(prior.parameter) {
                *j = prior.weight;
            }
        }
    }

    fn prior_count(&self) -> usize {
        self.problem.prior_count() + self.priors.len()
    }
}
