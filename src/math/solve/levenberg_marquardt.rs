//! Levenberg-Marquardt in a trust region, and in bounds where there are any.
//!
//! The trust region is Moré's (1978, as in MINPACK) on scaled columns; a step is accepted by the true cost. Where the
//! step leaves the bounds, the linear problem with the same damping is solved in the box instead, so that every step
//! is the best of its model and a point without one satisfies the Karush-Kuhn-Tucker conditions (Kanzow, Yamashita &
//! Fukushima 2004).

use super::run::{Run, norm, sum_of_squares};
use super::trust_region::{in_box, trust_region_step};
use super::{Bounds, Factor, Problem, Side, StepKind, Termination};

/// A step of the linear model, in scaled parameters and downhill by minus itself.
struct Proposal {
    p: Vec<f64>,
    damping: f64,
    /// Half the slope of the cost along it, and the decrease that the model predicts.
    slope: f64,
    predicted: f64,
    /// Where it ends; empty where no bound was met.
    ends: Vec<Side>,
}

/// Steps in a trust region until one is shorter than 1e-8, or shorter than `near`, undamped, and as good as predicted.
pub(super) fn damped<P: Problem>(run: &mut Run<'_, P>, bounds: Option<&Bounds>, near: f64) -> Termination {
    let mut trial_residuals = vec![0.0; run.residuals.len()];
    let mut largest = vec![0.0; run.x.len()];
    let (mut radius, mut damping, mut fresh) = (f64::NAN, 0.0, false);
    let mut sides = vec![Side::Free; run.x.len()];
    let mut gradient = 0.0;
    while run.iterations < run.options.iterations {
        if !fresh {
            // scales only grow (Moré, eq. 6.1), so that the region does not open where a column fades
            run.differentiate();
            if let Err(stopped) = run.factorise(Some(&mut largest)) {
                return stopped;
            }
            if run.cost == 0.0 {
                return Termination::ResidualsZero;
            }
            if radius.is_nan() {
                let start = run.x.iter().zip(&run.scale).map(|(x, d)| (x * d).powi(2)).sum::<f64>().sqrt();
                radius = if start > 0.0 { start } else { 1.0 };
            }
        }
        let Some(factor) = &run.factor else { return Termination::NotANumber };
        if !fresh {
            if let Some(bounds) = bounds {
                sides = bounds.sides(&run.x, &factor.multiply_transposed(&factor.qtb));
            }
            gradient = norm(&on_free(factor, &sides).qtb);
            fresh = true;
        }
        if gradient <= run.options.gradient * run.cost.sqrt() {
            return Termination::GradientVanished;
        }
        let Some(step) = propose(run, factor, bounds, &sides, radius, damping) else {
            return Termination::RankDeficient;
        };
        damping = step.damping;
        let length = norm(&step.p);
        let unscaled: Vec<f64> = step.p.iter().zip(&run.scale).map(|(p, d)| p / d).collect();
        let size = run.relative(&unscaled);
        let mut trial: Vec<f64> = run.x.iter().zip(&unscaled).map(|(x, s)| x - s).collect();
        if let Some(bounds) = bounds {
            trial = onto(bounds, trial, &step.ends);
        }
        run.problem.residuals(&trial, &mut trial_residuals);
        let trial_cost = run.cost_of(&trial_residuals);
        let lowered = run.cost - trial_cost;
        let ratio = if trial_cost.is_finite() { lowered / step.predicted } else { f64::NEG_INFINITY };
        let tried_in = (radius, damping);
        if ratio < 0.25 {
            let shorten = if trial_cost.is_finite() && trial_cost < 100.0 * run.cost {
                // minimum of the parabola through both costs and the slope (MINPACK's choice)
                (if ratio >= 0.0 { 0.5 } else { 0.5 * step.slope / (step.slope - 0.5 * lowered) }).clamp(0.1, 0.5)
            } else {
                0.1
            };
            radius = shorten * radius.min(10.0 * length);
            damping /= shorten;
        } else if damping == 0.0 || ratio >= 0.75 {
            radius = 2.0 * length;
            damping *= 0.5;
        }
        // a step cut short by a bound that it meets says nothing about the minimum
        let whole = step.ends.is_empty() || step.ends == sides;
        if ratio > 1e-4 {
            run.note(StepKind::Damped, size, gradient, tried_in);
            run.go_to(trial, &mut trial_residuals, trial_cost);
            fresh = false;
            if whole && (size < 1e-8 || size < near && tried_in.1 == 0.0 && (ratio - 1.0).abs() < 0.1) {
                return Termination::StepVanished;
            }
        } else {
            run.note(StepKind::Refused, size, gradient, tried_in);
            if size < 1e-8 || !radius.is_normal() {
                return Termination::NoImprovementPossible;
            }
        }
    }
    Termination::LostPatience
}

/// The factor in the elements that no bound holds.
fn on_free<'f>(factor: &'f Factor, sides: &[Side]) -> std::borrow::Cow<'f, Factor> {
    let free: Vec<usize> = (0..factor.n).filter(|&i| sides[i] == Side::Free).collect();
    if free.len() == factor.n {
        return std::borrow::Cow::Borrowed(factor);
    }
    std::borrow::Cow::Owned(factor.columns(&free, &vec![0.0; factor.n]))
}

fn propose<P: Problem>(
    run: &Run<'_, P>,
    factor: &Factor,
    bounds: Option<&Bounds>,
    sides: &[Side],
    radius: f64,
    damping: f64,
) -> Option<Proposal> {
    let (best, damping) = trust_region_step(&on_free(factor, sides), radius, damping)?;
    let mut best = best.into_iter();
    let p: Vec<f64> = sides.iter().map(|s| if *s == Side::Free { best.next().unwrap_or(0.0) } else { 0.0 }).collect();
    if let Some(bounds) = bounds {
        let scaled =
            |bound: &[f64]| -> Vec<f64> { (0..p.len()).map(|i| (run.x[i] - bound[i]) * run.scale[i]).collect() };
        let (lower, upper) = (scaled(&bounds.upper), scaled(&bounds.lower));
        let inside = (0..p.len()).all(|i| lower[i] <= p[i] && p[i] <= upper[i]);
        if !inside || sides.iter().any(|s| *s != Side::Free) {
            let solved = in_box(&factor.damped(damping.sqrt()), &lower, &upper);
            // dependent columns without damping: the step cut at the bounds still goes downhill if it is short
            let (p, ends) = solved.unwrap_or_else(|| {
                let cut: Vec<f64> = (0..p.len()).map(|i| p[i].max(lower[i]).min(upper[i])).collect();
                (cut, sides.to_vec())
            });
            let along = factor.multiply(&p);
            let slope: f64 = along.iter().zip(&factor.qtb).map(|(a, b)| a * b).sum();
            let predicted = 2.0 * slope - sum_of_squares(&along);
            // p counts downhill by its negative, so its lower side is the upper bound of the parameter
            let ends = ends.into_iter().map(Side::opposite).collect();
            return Some(Proposal { p, damping, slope, predicted, ends });
        }
    }
    // decrease of the linear model: ‖r‖² − ‖r − J p‖² = ‖R p‖² + 2 λ ‖p‖² for this p (Moré, eq. 4.5)
    let (moved, length) = (sum_of_squares(&factor.multiply(&p)), norm(&p));
    let predicted = moved + 2.0 * damping * length * length;
    Some(Proposal { p, damping, slope: moved + damping * length * length, predicted, ends: Vec::new() })
}

/// `trial` between the bounds, and exactly on those where the step ends.
fn onto(bounds: &Bounds, trial: Vec<f64>, ends: &[Side]) -> Vec<f64> {
    let mut trial = bounds.project(&trial);
    for (i, end) in ends.iter().enumerate() {
        match end {
            Side::Free => {}
            Side::Lower => trial[i] = bounds.lower[i],
            Side::Upper => trial[i] = bounds.upper[i],
        }
    }
    trial
}
