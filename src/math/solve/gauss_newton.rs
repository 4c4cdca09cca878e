//! Undamped Gauss-Newton: the finish.
//!
//! Near the minimum the cost is too flat to judge a step, so the step alone is looked at: it stops on step, never on
//! cost.

use super::run::{Run, norm};
use super::{Problem, StepKind, Termination};

/// Goes on while every step is shorter than the one before.
///
/// The gradient is always that of the Jacobian at hand; its factor is taken over from an earlier point as long as steps
/// shrink tenfold with it.
pub(super) fn finish<P: Problem>(run: &mut Run<'_, P>) -> Termination {
    let mut last = f64::INFINITY;
    let mut residuals = vec![0.0; run.residuals.len()];
    let mut termination = Termination::NoImprovementPossible;
    for _ in 0..100 {
        run.differentiate();
        let taken_over = run.factor.as_ref().filter(|_| last < 1e-3);
        let step = taken_over.and_then(|f| f.solve_normal(&run.jacobian, run.target(), &run.scale));
        let (step, kind) = match step.filter(|step| run.relative(step) < 0.1 * last) {
            Some(step) => (step, StepKind::FactorTakenOver),
            None => {
                if let Err(stopped) = run.factorise(None) {
                    return stopped;
                }
                match fresh_step(run) {
                    Some(step) => (step, StepKind::GaussNewton),
                    None => return Termination::RankDeficient,
                }
            }
        };
        let size = run.relative(&step);
        let fresh = run.factor.as_ref().filter(|_| kind == StepKind::GaussNewton);
        let gradient = fresh.map_or(f64::NAN, |f| norm(&f.qtb));
        let undamped = (f64::INFINITY, 0.0);
        if size >= last {
            run.note(StepKind::Refused, size, gradient, undamped);
            if last < 1e-6 {
                termination = Termination::StepVanished;
            }
            break;
        }
        let trial: Vec<f64> = run.x.iter().zip(&step).map(|(x, s)| x + s).collect();
        run.problem.residuals(&trial, &mut residuals);
        let cost = run.cost_of(&residuals);
        if cost > run.cost * (1.0 + 1e-6) + f64::MIN_POSITIVE {
            run.note(StepKind::Refused, size, gradient, undamped);
            break;
        }
        run.note(kind, size, gradient, undamped);
        run.go_to(trial, &mut residuals, cost);
        last = size;
        if size <= run.options.step {
            termination = Termination::StepVanished;
            break;
        }
    }
    // the Jacobian at hand is that of the solution, or of a point closer to it than rounding can tell
    run.factorise(None).err().unwrap_or(termination)
}

/// The step that solves the factor at hand, in unscaled parameters; the sign makes it a descent.
fn fresh_step<P>(run: &Run<'_, P>) -> Option<Vec<f64>> {
    let step = run.factor.as_ref()?.solve()?;
    Some(step.iter().zip(&run.scale).map(|(s, d)| -s / d).collect())
}
