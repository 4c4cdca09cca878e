//! Solver from a start to the minimum: damped steps in a trust region, followed by undamped steps.
//!
//! Far from the minimum: Levenberg-Marquardt in Moré's trust region (1978, as in MINPACK) on scaled
//! columns, where steps are accepted by the true cost. Near the minimum the cost is too flat to
//! judge a step: undamped Gauss-Newton terminates by the length of the step alone.

use super::{Blocks, Factor, Loss, Options, Problem, Rows, Termination, TrustRegion, norm};
use etalon_base::interruption::checkpoint;

/// Result of the solver.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Parameters.
    pub x: Vec<f64>,
    /// Residuals at `x`.
    pub residuals: Vec<f64>,
    /// Minimised cost: sum of squares of the residuals, or of their losses. If residuals are
    /// divided by their standard uncertainties, it is a chi-square.
    pub cost: f64,
    /// Factor of the Jacobian at `x`, with columns divided by `scale`; `None` if it could not be
    /// computed, or with a loss, whose weights would not match the residuals.
    pub factor: Option<Factor>,
    /// Likewise of the rows before the rows of prior knowledge; `None` without prior knowledge, or
    /// with blocks.
    pub measured: Option<Factor>,
    /// Jacobian at `x`, or at a point within rounding of it, in the layout of
    /// [`Problem::jacobian`].
    pub jacobian: Vec<f64>,
    /// Norms of the columns of the Jacobian.
    pub scale: Vec<f64>,
    /// Number of steps.
    pub iterations: usize,
    /// Reason of the termination.
    pub termination: Termination,
}

impl Solution {
    /// (JᵀJ)⁻¹, n × n row by row: the covariance if residuals are divided by their standard
    /// uncertainties. `None` if J is rank-deficient.
    pub fn covariance(&self) -> Option<Vec<f64>> {
        covariance(self.factor.as_ref()?, &self.scale)
    }
}

/// (JᵀJ)⁻¹, row by row, from the factor of J with columns divided by `scale`; `None` if J is
/// rank-deficient.
pub fn covariance(factor: &Factor, scale: &[f64]) -> Option<Vec<f64>> {
    let n = factor.columns();
    let local = factor.inverse_normal()?;
    Some((0..n * n).map(|k| local[k] / (scale[k / n] * scale[k % n])).collect())
}

/// Minimises the sum of squares of the residuals of `problem` from `start`.
pub fn solve(problem: &impl Problem, start: &[f64], options: Options) -> Solution {
    let n = start.len();
    let mut run = Run::new(problem, start, options);
    let mut termination = Termination::TooFewEquations;
    if run.residuals.len() >= n {
        // undamped steps start early if the linear model is good; if they do not shrink, damped
        // steps continue
        for near in [1e-3, 1e-8] {
            termination = damped(&mut run, near);
            if !termination.is_success() || n == 0 || termination == Termination::ResidualsZero {
                break;
            }
            termination = finish(&mut run);
            if termination != Termination::NoImprovementPossible {
                break;
            }
        }
    }
    Solution {
        cost: run.evaluate_cost(&run.residuals),
        factor: run.factor.filter(|_| options.loss == Loss::Squares),
        measured: run.measured.filter(|_| options.loss == Loss::Squares),
        jacobian: run.jacobian,
        x: run.x,
        residuals: run.residuals,
        scale: run.scale,
        iterations: run.iterations,
        termination,
    }
}

/// Linear part of a problem at one point.
#[derive(Clone, Debug)]
pub struct Linearised {
    /// Elements of the Jacobian, row by row.
    pub jacobian: Vec<f64>,
    /// Factor of the Jacobian, with columns divided by `scale`.
    pub factor: Factor,
    /// Norms of the columns of the Jacobian.
    pub scale: Vec<f64>,
}

impl Linearised {
    /// Linear part of `problem` at `x`.
    pub fn new(problem: &impl Problem, x: &[f64]) -> Self {
        let width = problem.blocks().map_or(x.len(), Blocks::width);
        let mut jacobian = vec![0.0; problem.residual_count() * width];
        problem.jacobian(x, &mut jacobian);
        let rows = Rows { numbers: &jacobian, n: x.len(), blocks: problem.blocks() };
        let scale = rows.norms();
        Self { factor: rows.factor(&vec![0.0; problem.residual_count()], &scale), scale, jacobian }
    }
}

/// Returns the solution of a problem that differs little from a problem with this linear part at
/// `start`. Takes undamped steps by the current gradient and that factor, until a step is below
/// `near` times the first. With `is_same`, the linear part has the Jacobian at `start`.
/// `None` if steps do not shrink tenfold.
pub fn solve_near(
    problem: &impl Problem,
    start: &[f64],
    linearised: &Linearised,
    is_same: bool,
    near: f64,
) -> Option<Vec<f64>> {
    let mut run = Run::new(problem, start, Options::default());
    run.scale.clone_from(&linearised.scale);
    let mut residuals = vec![0.0; run.residuals.len()];
    let (mut first, mut last) = (None, f64::INFINITY);
    loop {
        match first {
            None if is_same => run.jacobian.copy_from_slice(&linearised.jacobian),
            _ => run.differentiate(),
        }
        let step = linearised.factor.solve_normal(run.rows(), run.target(), &linearised.scale)?;
        let size = run.relative(&step);
        if size.is_nan() || size > 0.1 * last {
            return None;
        }
        let trial: Vec<f64> = run.x.iter().zip(&step).map(|(x, s)| x + s).collect();
        if size <= near * *first.get_or_insert(size) {
            return Some(trial);
        }
        run.problem.residuals(&trial, &mut residuals);
        let cost = run.evaluate_cost(&residuals);
        run.go_to(trial, &mut residuals, cost);
        last = size;
    }
}

/// Steps in a trust region until a step is shorter than 1e-8, or shorter than `near`, undamped, and
/// as good as predicted.
fn damped<P: Problem>(run: &mut Run<'_, P>, near: f64) -> Termination {
    let mut trial_residuals = vec![0.0; run.residuals.len()];
    let mut largest = vec![0.0; run.x.len()];
    let (mut region, mut fresh): (Option<TrustRegion>, bool) = (None, false);
    while run.iterations < run.options.iterations {
        checkpoint();
        if !fresh {
            // scales only grow (Moré, eq. 6.1), so that the region does not expand when a column
            // vanishes
            run.differentiate();
            if let Err(stopped) = run.factorise(Some(&mut largest)) {
                return stopped;
            }
            if run.cost == 0.0 {
                return Termination::ResidualsZero;
            }
            fresh = true;
        }
        let Some(factor) = &run.factor else { return Termination::NotANumber };
        if norm(&factor.qtb) <= run.options.gradient * run.cost.sqrt() {
            return Termination::GradientVanished;
        }
        let region = region.get_or_insert_with(|| TrustRegion::new(run.scaled_length(&run.x)));
        let Some(step) = region.step(factor) else { return Termination::RankDeficient };
        let unscaled: Vec<f64> = step.p.iter().zip(&run.scale).map(|(p, d)| p / d).collect();
        let size = run.relative(&unscaled);
        let mut trial: Vec<f64> = run.x.iter().zip(&unscaled).map(|(x, s)| x - s).collect();
        if step.is_damped
            && run.iterations >= CURVED
            && let Some(bend) = bend(run, &step.factor(factor), &unscaled)
        {
            trial.iter_mut().zip(bend).for_each(|(x, bend)| *x += bend);
        }
        run.problem.residuals(&trial, &mut trial_residuals);
        let trial_cost = run.evaluate_cost(&trial_residuals);
        let ratio = region.judge(&step, run.cost, trial_cost);
        if ratio > 1e-4 {
            run.go_to(trial, &mut trial_residuals, trial_cost);
            fresh = false;
            if size < 1e-8 || size < near && !step.is_damped && (ratio - 1.0).abs() < 0.1 {
                return Termination::StepVanished;
            }
        } else if size < 1e-8 || !region.is_open() {
            return Termination::NoImprovementPossible;
        }
    }
    Termination::IterationLimit
}

/// Number of damped steps after which the path counts as curved.
const CURVED: usize = 20;
/// Share of a step at which the second derivative along the step is evaluated.
const AHEAD: f64 = 0.1;
/// Maximum ratio of correction to step; beyond it the second order adds no information.
const MOST_BEND: f64 = 0.75;

/// Correction of a step in a curved valley: half the geodesic acceleration along the step
/// (Transtrum & Sethna 2012, arXiv:1201.5885, eq. 10 and 15). `step` is to be subtracted, `factor`
/// belongs to the damped problem. `None` if the second order is no improvement.
fn bend<P: Problem>(run: &Run<'_, P>, factor: &Factor, step: &[f64]) -> Option<Vec<f64>> {
    if run.options.loss != Loss::Squares {
        return None;
    }
    let ahead: Vec<f64> = run.x.iter().zip(step).map(|(x, s)| x - AHEAD * s).collect();
    let mut second = vec![0.0; run.residuals.len()];
    run.problem.residuals(&ahead, &mut second);
    let along = run.rows().multiply(step);
    for ((second, now), along) in second.iter_mut().zip(&run.residuals).zip(along) {
        *second = 2.0 / AHEAD * ((*second - now) / AHEAD + along);
    }
    let acceleration = factor.solve_normal(run.rows(), &second, &run.scale)?;
    let bends = 2.0 * run.scaled_length(&acceleration) <= MOST_BEND * run.scaled_length(step);
    bends.then(|| acceleration.iter().map(|a| 0.5 * a).collect())
}

/// Continues with undamped steps while each step is shorter than the previous step.
///
/// The gradient always belongs to the current Jacobian; its factor is reused from an earlier point
/// while steps shrink tenfold.
fn finish<P: Problem>(run: &mut Run<'_, P>) -> Termination {
    let mut last = f64::INFINITY;
    let mut residuals = vec![0.0; run.residuals.len()];
    let mut termination = Termination::NoImprovementPossible;
    for _ in 0..100 {
        run.differentiate();
        let taken_over = run.factor.as_ref().filter(|_| last < 1e-3);
        let step = taken_over.and_then(|f| f.solve_normal(run.rows(), run.target(), &run.scale));
        let step = match step.filter(|step| run.relative(step) < 0.1 * last) {
            Some(step) => step,
            None => {
                if let Err(stopped) = run.factorise(None) {
                    return stopped;
                }
                match fresh_step(run) {
                    Some(step) => step,
                    None => return Termination::RankDeficient,
                }
            }
        };
        let size = run.relative(&step);
        if size >= last {
            if last < 1e-6 {
                termination = Termination::StepVanished;
            }
            break;
        }
        let trial: Vec<f64> = run.x.iter().zip(&step).map(|(x, s)| x + s).collect();
        run.problem.residuals(&trial, &mut residuals);
        let cost = run.evaluate_cost(&residuals);
        if cost > run.cost * (1.0 + 1e-6) + f64::MIN_POSITIVE {
            break;
        }
        run.go_to(trial, &mut residuals, cost);
        last = size;
        if size <= run.options.step {
            termination = Termination::StepVanished;
            break;
        }
    }
    // the current Jacobian is at the solution, or at a point within rounding of it
    run.factorise_with_prior().err().unwrap_or(termination)
}

/// Undamped step from the current factor in unscaled parameters, with the sign of a descent.
fn fresh_step<P>(run: &Run<'_, P>) -> Option<Vec<f64>> {
    let step = run.factor.as_ref()?.solve()?;
    Some(step.iter().zip(&run.scale).map(|(s, d)| -s / d).collect())
}

/// Norms of the `n` columns of a row-by-row matrix; 1 for a zero column.
pub fn column_norms(jacobian: &[f64], n: usize) -> Vec<f64> {
    Rows { numbers: jacobian, n, blocks: None }.norms()
}

/// Factor of the Jacobian of `problem` at `x` with columns divided by their norms, and the norms.
pub fn factor_at(problem: &impl Problem, x: &[f64]) -> (Factor, Vec<f64>) {
    linearised_at(problem, x, &vec![0.0; problem.residual_count()])
}

/// Like [`factor_at`], with a right-hand side of one number per residual.
pub fn linearised_at(problem: &impl Problem, x: &[f64], right: &[f64]) -> (Factor, Vec<f64>) {
    let width = problem.blocks().map_or(x.len(), Blocks::width);
    let mut jacobian = vec![0.0; problem.residual_count() * width];
    problem.jacobian(x, &mut jacobian);
    let rows = Rows { numbers: &jacobian, n: x.len(), blocks: problem.blocks() };
    let norms = rows.norms();
    (rows.factor(right, &norms), norms)
}

/// State of the solver: the current point, and everything computed there.
struct Run<'a, P> {
    problem: &'a P,
    options: Options,
    x: Vec<f64>,
    residuals: Vec<f64>,
    cost: f64,
    /// Jacobian at `x`, with rows weighted by the loss.
    jacobian: Vec<f64>,
    /// Residuals at `x`, weighted by the loss; empty without a loss.
    weighed: Vec<f64>,
    /// Factor of the Jacobian at `x` or, near the end, at an earlier point.
    factor: Option<Factor>,
    /// Factor of the rows before the rows of prior knowledge, at the end.
    measured: Option<Factor>,
    scale: Vec<f64>,
    iterations: usize,
}

impl<'a, P: Problem> Run<'a, P> {
    fn new(problem: &'a P, start: &[f64], options: Options) -> Self {
        let (m, n) = (problem.residual_count(), start.len());
        let mut residuals = vec![0.0; m];
        problem.residuals(start, &mut residuals);
        let mut run = Self {
            problem,
            options,
            x: start.to_vec(),
            residuals,
            cost: 0.0,
            jacobian: vec![0.0; m * problem.blocks().map_or(n, Blocks::width)],
            weighed: Vec::new(),
            factor: None,
            measured: None,
            scale: vec![1.0; n],
            iterations: 0,
        };
        run.cost = run.evaluate_cost(&run.residuals);
        run
    }

    fn evaluate_cost(&self, residuals: &[f64]) -> f64 {
        self.options.loss.sum(residuals, self.problem.prior_count())
    }

    /// Moves to `x`, where the residuals are `residuals`; swaps in the old residuals.
    fn go_to(&mut self, x: Vec<f64>, residuals: &mut Vec<f64>, cost: f64) {
        self.x = x;
        std::mem::swap(&mut self.residuals, residuals);
        self.cost = cost;
        self.iterations += 1;
    }

    /// Computes the Jacobian at `x`.
    fn differentiate(&mut self) {
        self.problem.jacobian(&self.x, &mut self.jacobian);
        let loss = self.options.loss;
        if loss != Loss::Squares {
            self.weighed.clone_from(&self.residuals);
            let width = self.problem.blocks().map_or(self.x.len(), Blocks::width);
            loss.weigh(&mut self.weighed, &mut self.jacobian, width, self.problem.prior_count());
        }
    }

    /// Rows of the current Jacobian.
    fn rows(&self) -> Rows<'_> {
        Rows { numbers: &self.jacobian, n: self.x.len(), blocks: self.problem.blocks() }
    }

    /// Right-hand side for the rows of `jacobian`.
    fn target(&self) -> &[f64] {
        if self.options.loss == Loss::Squares { &self.residuals } else { &self.weighed }
    }

    /// Factors the current Jacobian with columns divided by their norms or, if `largest` is given,
    /// by the largest norms so far; an error if an element is non-finite.
    fn factorise(&mut self, largest: Option<&mut Vec<f64>>) -> Result<(), Termination> {
        self.scale = self.rows().norms();
        if self.scale.iter().any(|s| !s.is_finite()) || !self.cost.is_finite() {
            return Err(Termination::NotANumber);
        }
        if let Some(largest) = largest {
            largest.iter_mut().zip(&self.scale).for_each(|(kept, now)| *kept = f64::max(*kept, *now));
            self.scale.clone_from(largest);
        }
        self.take(self.rows().factor(self.target(), &self.scale))
    }

    /// Like [`Self::factorise`], and keeps the factor of the rows before the rows of prior
    /// knowledge.
    fn factorise_with_prior(&mut self) -> Result<(), Termination> {
        let prior = self.problem.prior_count();
        if prior == 0 || self.problem.blocks().is_some() {
            return self.factorise(None);
        }
        self.scale = self.rows().norms();
        let first = self.residuals.len() - prior;
        let (measured, known) = self.jacobian.split_at(first * self.x.len());
        let (right, of_known) = self.target().split_at(first);
        let measured = Factor::new(measured, right, &self.scale);
        let factor = measured.clone().stack(Factor::new(known, of_known, &self.scale));
        self.measured = Some(measured);
        self.take(factor)
    }

    /// Takes over the factor of the current Jacobian; an error if an element is non-finite.
    fn take(&mut self, factor: Factor) -> Result<(), Termination> {
        let is_finite = factor.is_finite() && self.cost.is_finite();
        self.factor = Some(factor);
        if is_finite { Ok(()) } else { Err(Termination::NotANumber) }
    }

    /// Length of an unscaled step relative to the parameters, both in the scale of the columns.
    fn relative(&self, step: &[f64]) -> f64 {
        self.scaled_length(step) / (self.scaled_length(&self.x) + f64::MIN_POSITIVE)
    }

    /// Length of unscaled parameters in the scale of the columns.
    fn scaled_length(&self, v: &[f64]) -> f64 {
        v.iter().zip(&self.scale).map(|(v, d)| (v * d).powi(2)).sum::<f64>().sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rosenbrock's valley: the first full step from (-1.2, 1) raises the cost and must be
    /// rejected.
    struct Rosenbrock;

    impl Problem for Rosenbrock {
        fn residual_count(&self) -> usize {
            2
        }
        fn residuals(&self, x: &[f64], r: &mut [f64]) {
            r[0] = 10.0 * (x[1] - x[0] * x[0]);
            r[1] = 1.0 - x[0];
        }
        fn jacobian(&self, x: &[f64], j: &mut [f64]) {
            j.copy_from_slice(&[-20.0 * x[0], 10.0, -1.0, 0.0]);
        }
    }

    /// Fit of y = exp(b x) to data that it cannot match: non-zero residuals at the minimum.
    struct Exponential;

    impl Problem for Exponential {
        fn residual_count(&self) -> usize {
            4
        }
        fn residuals(&self, x: &[f64], r: &mut [f64]) {
            for (i, r) in r.iter_mut().enumerate() {
                let t = i as f64;
                *r = x[0] * (x[1] * t).exp() - [1.0, 1.7, 2.5, 4.9][i];
            }
        }
        fn jacobian(&self, x: &[f64], j: &mut [f64]) {
            for (i, j) in j.chunks_exact_mut(2).enumerate() {
                let t = i as f64;
                let e = (x[1] * t).exp();
                j.copy_from_slice(&[e, x[0] * t * e]);
            }
        }
    }

    /// A narrow circular valley with a gentle slope, as for the unknown base of an arm that was
    /// measured along a line.
    struct Ring;

    impl Problem for Ring {
        fn residual_count(&self) -> usize {
            3
        }
        fn residuals(&self, x: &[f64], r: &mut [f64]) {
            r.copy_from_slice(&[1e3 * (x[0].hypot(x[1]) - 1.0), 1e-2 * (x[0] - 1.0), 1e-2 * x[1]]);
        }
        fn jacobian(&self, x: &[f64], j: &mut [f64]) {
            let radius = x[0].hypot(x[1]);
            j.copy_from_slice(&[1e3 * x[0] / radius, 1e3 * x[1] / radius, 1e-2, 0.0, 0.0, 1e-2]);
        }
    }

    #[test]
    fn a_curved_valley_is_followed() {
        let solution = solve(&Ring, &[-0.8, 0.6], Options { iterations: 300, ..Options::default() });
        assert!(solution.termination.is_success(), "{}", solution.termination);
        assert!((solution.x[0] - 1.0).abs() < 1e-9 && solution.x[1].abs() < 1e-6, "{:?}", solution.x);
    }

    #[test]
    fn a_rejected_step_is_not_the_end() {
        let solution = solve(&Rosenbrock, &[-1.2, 1.0], Options::default());
        assert!(solution.termination.is_success(), "{}", solution.termination);
        assert!((solution.x[0] - 1.0).abs() < 1e-14 && (solution.x[1] - 1.0).abs() < 1e-14, "{:?}", solution.x);
    }

    #[test]
    fn the_gradient_vanishes_at_a_minimum_with_residuals() {
        let solution = solve(&Exponential, &[1.0, 0.0], Options::default());
        let mut j = vec![0.0; 8];
        Exponential.jacobian(&solution.x, &mut j);
        for c in 0..2 {
            let gradient: f64 = (0..4).map(|i| j[2 * i + c] * solution.residuals[i]).sum();
            assert!(gradient.abs() < 1e-13, "{gradient}");
        }
        let again = solve(&Exponential, &[1.0, 0.0], Options::default());
        assert_eq!(again.x, solution.x);
    }

    #[test]
    fn too_few_equations_and_nan_are_said() {
        assert_eq!(solve(&Rosenbrock, &[1.0, 1.0, 1.0], Options::default()).termination, Termination::TooFewEquations);
        assert_eq!(solve(&Rosenbrock, &[f64::NAN, 1.0], Options::default()).termination, Termination::NotANumber);
    }
}
