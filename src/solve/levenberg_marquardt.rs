//! Levenberg-Marquardt in a trust region, with an undamped Gauss-Newton finish.
//!
//! The trust region is Moré's (1978, as in MINPACK) on scaled columns; a step is accepted by the true sum of squares.
//! Near the minimum the cost is too flat to judge a step, so the finish looks at the step alone: it stops on step or
//! gradient, never on cost.

use super::{Factor, Problem, Termination};

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Iterations allowed.
    pub iterations: usize,
    /// Relative step below which the parameters no longer change.
    pub step: f64,
    /// Cosine between residuals and Jacobian columns below which they are orthogonal.
    pub gradient: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self { iterations: 2000, step: 1e-14, gradient: 1e-15 }
    }
}

/// Where the solver ended, and how.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The parameters.
    pub x: Vec<f64>,
    /// Residuals at `x`.
    pub residuals: Vec<f64>,
    /// Factor of the Jacobian at `x` with its columns divided by `scale`; `None` if no factor could be formed.
    pub factor: Option<Factor>,
    /// Norms of the columns of the Jacobian.
    pub scale: Vec<f64>,
    /// Steps taken.
    pub iterations: usize,
    /// Why it stopped.
    pub termination: Termination,
}

impl Solution {
    /// Sum of squares of the residuals.
    pub fn cost(&self) -> f64 {
        sum_of_squares(&self.residuals)
    }

    /// (JᵀJ)⁻¹, row by row: the covariance where residuals were divided by their standard uncertainties.
    pub fn covariance(&self) -> Option<Vec<f64>> {
        let mut covariance = self.factor.as_ref()?.inverse_normal()?;
        let n = self.x.len();
        for i in 0..n {
            for j in 0..n {
                covariance[i * n + j] /= self.scale[i] * self.scale[j];
            }
        }
        Some(covariance)
    }
}

/// Norm of each of the `n` columns of a row-by-row matrix; 1 for a column of zeros.
pub(crate) fn column_norms(jacobian: &[f64], n: usize) -> Vec<f64> {
    let mut squares = vec![0.0; n];
    for row in jacobian.chunks_exact(n) {
        for (s, j) in squares.iter_mut().zip(row) {
            *s += j * j;
        }
    }
    squares.into_iter().map(|s: f64| if s > 0.0 { s.sqrt() } else { 1.0 }).collect()
}

fn sum_of_squares(r: &[f64]) -> f64 {
    r.iter().map(|r| r * r).sum()
}

/// Minimises the sum of squares of the residuals of `problem` from `start`.
pub fn solve(problem: &impl Problem, start: &[f64], options: Options) -> Solution {
    let (n, m) = (start.len(), problem.residual_count());
    let mut residuals = vec![0.0; m];
    problem.residuals(start, &mut residuals);
    let mut state = Solution {
        x: start.to_vec(),
        residuals,
        factor: None,
        scale: vec![1.0; n],
        iterations: 0,
        termination: Termination::LostPatience,
    };
    if m < n {
        state.termination = Termination::TooFewEquations;
        return state;
    }
    let mut jacobian = vec![0.0; m * n];
    // undamped steps take over early where the linear model is good; where they do not shrink, damped ones go on
    for near in [1e-3, 1e-8] {
        state.termination = damped(problem, &mut state, &mut jacobian, options, near);
        if !state.termination.is_success() || n == 0 || state.termination == Termination::ResidualsZero {
            break;
        }
        state.termination = finish(problem, &mut state, &mut jacobian, options);
        if state.termination != Termination::NoImprovementPossible {
            break;
        }
    }
    state
}

/// Factors the Jacobian at hand, with columns divided by their norms or, if `largest` is given, by the largest norms so
/// far; an error if a number in it is not finite.
fn factorise(state: &mut Solution, jacobian: &[f64], largest: Option<&mut Vec<f64>>) -> Result<(), Termination> {
    state.scale = column_norms(jacobian, state.x.len());
    if state.scale.iter().any(|s| !s.is_finite()) || !sum_of_squares(&state.residuals).is_finite() {
        return Err(Termination::NotANumber);
    }
    if let Some(largest) = largest {
        largest.iter_mut().zip(&state.scale).for_each(|(kept, now)| *kept = f64::max(*kept, *now));
        state.scale.clone_from(largest);
    }
    state.factor = Some(Factor::new(jacobian, &state.residuals, &state.scale));
    Ok(())
}

/// The step that solves `factor`, in unscaled parameters; the sign makes it a descent.
fn step_of(factor: &Factor, scale: &[f64]) -> Option<Vec<f64>> {
    Some(factor.solve()?.iter().zip(scale).map(|(s, d)| -s / d).collect())
}

/// Largest step relative to its parameter, both in the scale of the residuals' columns.
fn relative(step: &[f64], x: &[f64], scale: &[f64]) -> f64 {
    let scaled = |v: &[f64]| v.iter().zip(scale).map(|(v, d)| (v * d).powi(2)).sum::<f64>().sqrt();
    scaled(step) / (scaled(x) + f64::MIN_POSITIVE)
}

/// Steps in a trust region until one is shorter than 1e-8, or shorter than `near`, undamped, and as good as predicted.
fn damped(
    problem: &impl Problem,
    state: &mut Solution,
    jacobian: &mut [f64],
    options: Options,
    near: f64,
) -> Termination {
    let mut cost = state.cost();
    let mut trial_residuals = vec![0.0; state.residuals.len()];
    let mut scale = vec![0.0; state.x.len()];
    let (mut radius, mut damping, mut fresh) = (f64::NAN, 0.0, false);
    while state.iterations < options.iterations {
        if !fresh {
            // scales only grow (Moré, eq. 6.1), so that the region does not open where a column fades
            problem.jacobian(&state.x, jacobian);
            if let Err(stopped) = factorise(state, jacobian, Some(&mut scale)) {
                return stopped;
            }
            if cost == 0.0 {
                return Termination::ResidualsZero;
            }
            if radius.is_nan() {
                let start = scaled_norm(&state.x, &scale);
                radius = if start > 0.0 { start } else { 1.0 };
            }
            fresh = true;
        }
        let Some(factor) = &state.factor else { return Termination::NotANumber };
        if sum_of_squares(&factor.qtb).sqrt() <= options.gradient * cost.sqrt() {
            return Termination::GradientVanished;
        }
        let Some((p, used)) = trust_region_step(factor, radius, damping) else { return Termination::RankDeficient };
        damping = used;
        let length = sum_of_squares(&p).sqrt();
        let size = length / (scaled_norm(&state.x, &scale) + f64::MIN_POSITIVE);
        let trial: Vec<f64> = state.x.iter().zip(&p).zip(&scale).map(|((x, p), d)| x - p / d).collect();
        problem.residuals(&trial, &mut trial_residuals);
        let trial_cost = sum_of_squares(&trial_residuals);
        // decrease of the linear model: ‖r‖² − ‖r − J p‖² = ‖R p‖² + 2 λ ‖p‖² for this p (Moré, eq. 4.5)
        let predicted = sum_of_squares(&factor.multiply(&p)) + 2.0 * damping * length * length;
        let ratio = if trial_cost.is_finite() { (cost - trial_cost) / predicted } else { f64::NEG_INFINITY };
        if ratio < 0.25 {
            let shorten = if trial_cost.is_finite() && trial_cost < 100.0 * cost {
                // minimum of the parabola through both costs and the slope (MINPACK's choice)
                let slope = sum_of_squares(&factor.multiply(&p)) + damping * length * length;
                (if ratio >= 0.0 { 0.5 } else { 0.5 * slope / (slope - 0.5 * (cost - trial_cost)) }).clamp(0.1, 0.5)
            } else {
                0.1
            };
            radius = shorten * radius.min(10.0 * length);
            damping /= shorten;
        } else if damping == 0.0 || ratio >= 0.75 {
            radius = 2.0 * length;
            damping *= 0.5;
        }
        if ratio > 1e-4 {
            state.iterations += 1;
            state.x = trial;
            std::mem::swap(&mut state.residuals, &mut trial_residuals);
            cost = trial_cost;
            fresh = false;
            if size < 1e-8 || size < near && used == 0.0 && (ratio - 1.0).abs() < 0.1 {
                return Termination::StepVanished;
            }
        } else if size < 1e-8 || !radius.is_normal() {
            return Termination::NoImprovementPossible;
        }
    }
    Termination::LostPatience
}

fn scaled_norm(x: &[f64], scale: &[f64]) -> f64 {
    x.iter().zip(scale).map(|(x, d)| (x * d).powi(2)).sum::<f64>().sqrt()
}

/// The scaled step of at most `radius` (to a tenth) that lowers the linear model most, and its damping λ
/// (Moré 1978, algorithm 5.5); `None` if no damping makes the factor regular.
pub(crate) fn trust_region_step(factor: &Factor, radius: f64, last_damping: f64) -> Option<(Vec<f64>, f64)> {
    let norm = |p: &[f64]| sum_of_squares(p).sqrt();
    let direction = |f: &Factor, p: &[f64], length: f64| {
        f.forward_substitute(p.iter().map(|p| p / length).collect()).map(|w| sum_of_squares(&w))
    };
    let mut lower = 0.0;
    if let Some(p) = factor.solve() {
        let length = norm(&p);
        if length <= 1.1 * radius {
            return Some((p, 0.0));
        }
        if let Some(w) = direction(factor, &p, length) {
            lower = (length - radius) / radius / w;
        }
    }
    let mut upper = norm(&factor.multiply_transposed(&factor.qtb)) / radius;
    if upper == 0.0 {
        upper = f64::MIN_POSITIVE / radius.min(0.1);
    }
    let mut damping = last_damping.clamp(lower.min(upper), upper);
    if damping == 0.0 {
        damping = (0.001 * upper).max((lower * upper).sqrt());
    }
    for attempt in 0..12 {
        let damped = factor.damped(damping.sqrt());
        let p = damped.solve()?;
        let length = norm(&p);
        let off = length - radius;
        if off.abs() <= 0.1 * radius || attempt == 11 {
            return Some((p, damping));
        }
        let correction = off / radius / direction(&damped, &p, length)?;
        if off > 0.0 {
            lower = f64::max(lower, damping)
        } else {
            upper = upper.min(damping)
        }
        damping = (damping + correction).max(lower);
        if damping > upper || damping <= 0.0 {
            damping = (lower * upper).sqrt().max(0.001 * upper);
        }
    }
    None
}

/// Undamped Gauss-Newton: goes on while every step is shorter than the one before.
///
/// The gradient is always that of the Jacobian at hand; its factor is taken over from an earlier point as long as steps
/// shrink tenfold with it.
fn finish(problem: &impl Problem, state: &mut Solution, jacobian: &mut [f64], options: Options) -> Termination {
    let mut last = f64::INFINITY;
    let mut residuals = vec![0.0; state.residuals.len()];
    let mut termination = Termination::NoImprovementPossible;
    for _ in 0..100 {
        problem.jacobian(&state.x, jacobian);
        let taken_over = state.factor.as_ref().filter(|_| last < 1e-3);
        let step = taken_over.and_then(|f| f.solve_normal(jacobian, &state.residuals, &state.scale));
        let step = match step.filter(|step| relative(step, &state.x, &state.scale) < 0.1 * last) {
            Some(step) => step,
            None => {
                if let Err(stopped) = factorise(state, jacobian, None) {
                    return stopped;
                }
                match state.factor.as_ref().and_then(|f| step_of(f, &state.scale)) {
                    Some(step) => step,
                    None => return Termination::RankDeficient,
                }
            }
        };
        let size = relative(&step, &state.x, &state.scale);
        if size >= last {
            if last < 1e-6 {
                termination = Termination::StepVanished;
            }
            break;
        }
        let trial: Vec<f64> = state.x.iter().zip(&step).map(|(x, s)| x + s).collect();
        problem.residuals(&trial, &mut residuals);
        if sum_of_squares(&residuals) > state.cost() * (1.0 + 1e-6) + f64::MIN_POSITIVE {
            break;
        }
        state.x = trial;
        std::mem::swap(&mut state.residuals, &mut residuals);
        state.iterations += 1;
        last = size;
        if size <= options.step {
            termination = Termination::StepVanished;
            break;
        }
    }
    // the Jacobian at hand is that of the solution, or of a point closer to it than rounding can tell
    factorise(state, jacobian, None).err().unwrap_or(termination)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rosenbrock's valley: the first full step from (-1.2, 1) raises the cost and must be rejected.
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

    /// y = exp(b x) fitted to data it cannot meet: a nonzero residual at the minimum.
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
