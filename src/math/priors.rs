//! Prior knowledge as additional rows of a problem.

use super::{Blocks, Problem};

/// Knowledge about a parameter before the measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterPrior {
    /// Index of the parameter.
    pub parameter: usize,
    /// Expected value of the parameter.
    pub value: f64,
    /// Inverse of the standard uncertainty of the value.
    pub weight: f64,
}

/// A problem with an additional row (x − value) / u for every prior, which counts as a residual in
/// chi-square and degrees of freedom.
#[derive(Clone, Debug)]
pub struct WithPriors<'a, P> {
    problem: &'a P,
    priors: Vec<ParameterPrior>,
    blocks: Option<Blocks>,
}

impl<'a, P: Problem> WithPriors<'a, P> {
    /// Adds priors to `problem`.
    pub fn new(problem: &'a P, priors: &[ParameterPrior]) -> Self {
        let blocks = problem.blocks().map(|b| b.with_single_rows(priors.iter().map(|prior| prior.parameter)));
        Self { problem, priors: priors.to_vec(), blocks }
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
        let width = self.blocks.as_ref().map_or(x.len(), Blocks::width);
        let (measured, known) = jacobian.split_at_mut(self.problem.residual_count() * width);
        self.problem.jacobian(x, measured);
        known.fill(0.0);
        for (row, prior) in known.chunks_exact_mut(width.max(1)).zip(&self.priors) {
            let place =
                self.blocks.as_ref().map_or(Some(prior.parameter), |b| Some(b.column_place(prior.parameter)?.1));
            if let Some(j) = place.and_then(|place| row.get_mut(place)) {
                *j = prior.weight;
            }
        }
    }

    fn blocks(&self) -> Option<&Blocks> {
        self.blocks.as_ref()
    }

    fn prior_count(&self) -> usize {
        self.problem.prior_count() + self.priors.len()
    }
}
