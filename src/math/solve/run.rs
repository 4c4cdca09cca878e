//! The point at hand while the solver runs, with all that was computed there.

use super::{Factor, Options, Problem, Step, StepKind, Termination};

/// Norm of each of the `n` columns of a row-by-row matrix; 1 for a column of zeros.
pub(crate) fn column_norms(jacobian: &[f64], n: usize) -> Vec<f64> {
    let mut squares = vec![0.0; n];
    for row in jacobian.chunks_exact(n.max(1)) {
        for (s, j) in squares.iter_mut().zip(row) {
            *s += j * j;
        }
    }
    squares.into_iter().map(|s: f64| if s > 0.0 { s.sqrt() } else { 1.0 }).collect()
}

/// Root of the sum of squares.
pub(super) fn norm(v: &[f64]) -> f64 {
    sum_of_squares(v).sqrt()
}

pub(super) fn sum_of_squares(v: &[f64]) -> f64 {
    v.iter().map(|v| v * v).sum()
}

pub(super) struct Run<'a, P> {
    pub problem: &'a P,
    pub options: Options,
    pub x: Vec<f64>,
    pub residuals: Vec<f64>,
    pub cost: f64,
    /// Jacobian at `x`, its rows weighed by the loss.
    pub jacobian: Vec<f64>,
    /// Residuals at `x`, weighed by the loss; empty where there is none.
    weighed: Vec<f64>,
    /// Factor of the Jacobian at `x` or, near the end, at an earlier point.
    pub factor: Option<Factor>,
    pub scale: Vec<f64>,
    pub iterations: usize,
    pub log: Vec<Step>,
}

impl<'a, P: Problem> Run<'a, P> {
    pub fn new(problem: &'a P, start: &[f64], options: Options) -> Self {
        let (m, n) = (problem.residual_count(), start.len());
        let mut residuals = vec![0.0; m];
        problem.residuals(start, &mut residuals);
        let mut run = Self {
            problem,
            options,
            x: start.to_vec(),
            residuals,
            cost: 0.0,
            jacobian: vec![0.0; m * n],
            weighed: Vec::new(),
            factor: None,
            scale: vec![1.0; n],
            iterations: 0,
            log: Vec::new(),
        };
        run.cost = run.cost_of(&run.residuals);
        run
    }

    pub fn cost_of(&self, residuals: &[f64]) -> f64 {
        self.options.loss.sum(residuals, self.problem.prior_count())
    }

    /// Goes to `x`, where the residuals are in `residuals`; these take the old ones.
    pub fn go_to(&mut self, x: Vec<f64>, residuals: &mut Vec<f64>, cost: f64) {
        self.x = x;
        std::mem::swap(&mut self.residuals, residuals);
        self.cost = cost;
        self.iterations += 1;
    }

    /// The Jacobian at `x`.
    pub fn differentiate(&mut self) {
        self.problem.jacobian(&self.x, &mut self.jacobian);
        let loss = self.options.loss;
        if loss != super::Loss::Squares {
            self.weighed.clone_from(&self.residuals);
            loss.weigh(&mut self.weighed, &mut self.jacobian, self.x.len(), self.problem.prior_count());
        }
    }

    /// Right-hand side that goes with `jacobian`.
    pub fn target(&self) -> &[f64] {
        if self.options.loss == super::Loss::Squares { &self.residuals } else { &self.weighed }
    }

    /// Factors the Jacobian at hand, with columns divided by their norms or, if `largest` is given, by the largest
    /// norms so far; an error if a number in it is not finite.
    pub fn factorise(&mut self, largest: Option<&mut Vec<f64>>) -> Result<(), Termination> {
        self.scale = column_norms(&self.jacobian, self.x.len());
        if self.scale.iter().any(|s| !s.is_finite()) || !self.cost.is_finite() {
            return Err(Termination::NotANumber);
        }
        if let Some(largest) = largest {
            largest.iter_mut().zip(&self.scale).for_each(|(kept, now)| *kept = f64::max(*kept, *now));
            self.scale.clone_from(largest);
        }
        self.factor = Some(Factor::new(&self.jacobian, self.target(), &self.scale));
        Ok(())
    }

    /// Length of an unscaled step relative to the parameters, both in the scale of the columns.
    pub fn relative(&self, step: &[f64]) -> f64 {
        let scaled = |v: &[f64]| v.iter().zip(&self.scale).map(|(v, d)| (v * d).powi(2)).sum::<f64>().sqrt();
        scaled(step) / (scaled(&self.x) + f64::MIN_POSITIVE)
    }

    /// Notes a step about to be taken or refused; `gradient` is the norm of Qᵀr.
    pub fn note(&mut self, kind: StepKind, step: f64, gradient: f64, (radius, damping): (f64, f64)) {
        let gradient = gradient / self.cost.sqrt();
        self.log.push(Step { iteration: self.iterations, kind, cost: self.cost, step, gradient, radius, damping });
    }
}
