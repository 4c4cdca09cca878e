//! Prior knowledge as more rows of a problem.

use super::Problem;

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
