//! The way from a start to the minimum: steps in a trust region, then an undamped finish.

use super::gauss_newton::finish;
use super::levenberg_marquardt::damped;
use super::run::Run;
use super::{Bounds, Factor, Held, Loss, Options, Problem, Side, Solution, Termination};

/// Minimises the sum of squares of the residuals of `problem` from `start`.
pub fn solve(problem: &impl Problem, start: &[f64], options: Options) -> Solution {
    let n = start.len();
    let mut run = Run::new(problem, start, options);
    let mut termination = Termination::TooFewEquations;
    if run.residuals.len() >= n {
        // undamped steps take over early where the linear model is good; where they do not shrink, damped ones go on
        for near in [1e-3, 1e-8] {
            termination = damped(&mut run, None, near);
            if !termination.is_success() || n == 0 || termination == Termination::ResidualsZero {
                break;
            }
            termination = finish(&mut run);
            if termination != Termination::NoImprovementPossible {
                break;
            }
        }
    }
    solution(run, termination, vec![Side::Free; n])
}

/// [`solve`] with every parameter kept between its bounds; `start` is moved there first.
///
/// The finish is undamped in the parameters that no bound holds. Parameters beyond the last bound are free.
pub fn solve_within(problem: &impl Problem, start: &[f64], bounds: &Bounds, options: Options) -> Solution {
    let n = start.len();
    let bounds = &bounds.widened(n);
    let mut run = Run::new(problem, &bounds.project(start), options);
    let mut sides = vec![Side::Free; n];
    let mut termination = Termination::TooFewEquations;
    // each round ends at a stationary point of a set of free parameters, lower than the round before
    for round in 0..2 * n + 2 {
        termination = damped(&mut run, Some(bounds), if round == 0 { 1e-3 } else { 1e-8 });
        sides = sides_at(&mut run, bounds);
        if !termination.is_success() || termination == Termination::ResidualsZero {
            break;
        }
        let free: Vec<usize> = (0..n).filter(|&i| sides[i] == Side::Free).collect();
        let part = Held::new(problem, &run.x, &free);
        let mut finished = Run::new(&part, &part.chosen(&run.x), options);
        let ended = finish(&mut finished);
        let x = part.all(&finished.x);
        if !bounds.holds(&x) {
            continue;
        }
        (run.x, run.residuals, run.cost) = (x, finished.residuals, finished.cost);
        run.iterations += finished.iterations;
        run.log.append(&mut finished.log);
        let before = std::mem::replace(&mut sides, sides_at(&mut run, bounds));
        if sides == before && ended != Termination::NoImprovementPossible {
            termination = ended;
            break;
        }
    }
    solution(run, termination, sides)
}

/// Which parameters a bound holds back at the point of `run`.
fn sides_at<P: Problem>(run: &mut Run<'_, P>, bounds: &Bounds) -> Vec<Side> {
    run.differentiate();
    let n = run.x.len();
    let mut gradient = vec![0.0; n];
    for (row, r) in run.jacobian.chunks_exact(n.max(1)).zip(run.target()) {
        gradient.iter_mut().zip(row).for_each(|(g, j)| *g += j * r);
    }
    bounds.sides(&run.x, &gradient)
}

/// What is told of the point at hand: its factor is of the free columns, and of the Jacobian without weights of a loss.
fn solution<P: Problem>(mut run: Run<'_, P>, termination: Termination, sides: Vec<Side>) -> Solution {
    let n = run.x.len();
    let loss = run.options.loss;
    let free: Vec<usize> = (0..n).filter(|&i| sides[i] == Side::Free).collect();
    if run.factor.is_some() && (loss != Loss::Squares || free.len() < n) {
        let part = Held::new(run.problem, &run.x, &free);
        let mut jacobian = vec![0.0; run.residuals.len() * free.len()];
        part.jacobian(&part.chosen(&run.x), &mut jacobian);
        run.scale = super::column_norms(&jacobian, free.len());
        run.factor = Some(Factor::new(&jacobian, &run.residuals, &run.scale));
    }
    Solution {
        loss: (loss, run.problem.prior_count()),
        x: run.x,
        residuals: run.residuals,
        factor: run.factor,
        scale: run.scale,
        sides,
        iterations: run.iterations,
        termination,
        log: run.log,
    }
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
