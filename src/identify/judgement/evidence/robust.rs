//! A robust fit in addition to the plain one: parameters with a low weight for readings far from
//! the others, and the poses that disagree with the rest.

use crate::Result;
use crate::judgement::regional;
use crate::model::residuals::{OF_MEDIAN, ResidualKind, Residuals};
use crate::{Identification, Observation, Settings};
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::{mean, median};
use etalon_math::{Loss, Options, Problem, covariance, factor_at, solve};
use etalon_robots::Robot;
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};
use std::collections::BTreeMap;

/// Constant of the Cauchy loss with which the estimate of normal residuals has [`EFFICIENCY`]
/// (Holland & Welsch 1977, Robust regression using iteratively reweighted least-squares).
pub(crate) const CAUCHY: f64 = 2.385;
/// Variance of the plain estimate over the variance of the robust one, for normal residuals.
const EFFICIENCY: f64 = 0.95;
/// Significance level at which a parameter or a pose disagrees.
const SIGNIFICANCE: f64 = 0.01;
/// Number of fits, each with the scale of the previous one.
const FITS: usize = 3;
/// Cap of the residuals, in standard deviations, in the scatter of the poses: gross errors must not
/// make the difference that they cause look probable.
const CLIPPED: f64 = 2.5;

/// A parameter in both fits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RobustChange {
    /// Index of the parameter.
    pub parameter: usize,
    /// Robust minus plain value (mm, rad, 1).
    pub difference: f64,
    /// Standard uncertainty of this difference without wrong readings (mm, rad, 1).
    pub u: f64,
}

impl RobustChange {
    /// Absolute difference over its standard uncertainty.
    pub fn over_u(&self) -> f64 {
        (self.difference / self.u).abs()
    }
}

/// Weight and residual of a pose in a robust fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseWeight {
    /// The pose.
    pub pose: PoseName,
    /// Smallest weight of its residuals, from 0 to 1: 1 / (1 + (r / c σ)²).
    pub weight: f64,
    /// Residual with this weight, over σ.
    pub residual_over_sigma: f64,
}

/// Results of a robust fit, for comparison with the least-squares fit.
#[derive(Clone, Debug, PartialEq)]
pub struct RobustComparison {
    /// All parameters of the robot from the robust fit (mm, rad, 1).
    pub values: Vec<f64>,
    /// The identified parameters, in their order.
    pub changes: Vec<RobustChange>,
    /// Limit of a difference over its standard uncertainty. With a correct model no parameter
    /// exceeds this limit, with a probability of 99 %.
    pub critical: f64,
    /// The poses, in ascending order of their weight.
    pub poses: Vec<PoseWeight>,
    /// Limit of a residual over σ. With a correct model no residual exceeds this limit, with a
    /// probability of 99 %.
    pub critical_residual: f64,
    /// Standard deviation σ (mm) of a coordinate from most residuals, or the given one if that is
    /// larger.
    pub sigma_mm: f64,
}

impl RobustComparison {
    /// The constant c of the Cauchy loss.
    pub const CONSTANT: f64 = CAUCHY;

    /// The parameter with the largest difference, if the difference is significant.
    pub fn significant(&self) -> Option<&RobustChange> {
        let largest = self.changes.iter().max_by(|a, b| a.over_u().total_cmp(&b.over_u()))?;
        (largest.over_u() > self.critical).then_some(largest)
    }

    /// Poses that disagree with the other poses, the worst first.
    pub fn disagreeing(&self) -> &[PoseWeight] {
        let beyond = self.poses.iter().take_while(|p| p.residual_over_sigma > self.critical_residual);
        &self.poses[..beyond.count()]
    }
}

/// Compares the least-squares fit `found` with a robust fit: the Cauchy loss (M-estimator), started
/// at `found`. The residuals have equal weights and are divided by their scale. `None` if readings
/// have common errors or are poses, if many points are unknown, without degrees of freedom, or
/// without a robust result.
///
/// For normal residuals, the least-squares fit is efficient. The difference then has the variance
/// (1 / 0.95 − 1) u² (Hausman 1978), with the standard uncertainty u of the least-squares fit from
/// σ. If the scatter of the poses gives a larger variance (A⁻¹ Σ hₚ hₚᵀ A⁻¹ with
/// hₚ = Jₚᵀ (ψ(r)/ψ̄' − r)ₚ), that variance is used.
///
/// # Errors
/// Fails if settings and observations do not match.
pub fn robust_comparison(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Result<Option<RobustComparison>> {
    let settings = &settings.as_found(found);
    let problem = Residuals::new(robot, observations, settings, &found.free, &found.values)?;
    let apart = settings.kind == ResidualKind::Targets && !problem.is_whitened() && problem.layout.is_none();
    let dof = found.residuals.degrees_of_freedom;
    if !apart || dof == 0 {
        return Ok(None);
    }
    let plain: Vec<f64> = found.free.iter().map(|&i| found.values[i]).collect();
    Ok(compare(&problem, &plain, dof))
}

fn compare(problem: &Residuals, plain: &[f64], dof: usize) -> Option<RobustComparison> {
    let (m, n) = (problem.residual_count(), plain.len());
    let measured = problem.measured_count();
    let mut residuals = vec![0.0; m];
    let stated = problem.noise(None);
    let mut scale_at = |x: &[f64]| -> Option<(f64, Vec<f64>)> {
        problem.residuals(x, &mut residuals);
        let size = median(residuals[..measured].iter().map(|r| r.abs()))?;
        let shown = OF_MEDIAN * size * (m as f64 / dof as f64).sqrt();
        Some((shown.max(stated), residuals[..measured].to_vec())).filter(|s| s.0.is_finite() && s.0 > 0.0)
    };
    let (mut x, (mut scale, mut r)) = (plain.to_vec(), scale_at(plain)?);
    for _ in 0..FITS {
        let options = Options { step: 1e-9, loss: Loss::Cauchy(CAUCHY * scale), ..Options::default() };
        let solution = solve(problem, &x, options);
        if !solution.termination.is_success() {
            return None;
        }
        x = solution.x;
        let before = scale;
        (scale, r) = scale_at(&x)?;
        if (scale / before - 1.0).abs() < 0.01 {
            break;
        }
    }
    let degrees = (scale > stated).then_some(dof as f64);
    let r: Vec<f64> = r.iter().map(|r| r / scale).collect();
    let u = differences(problem, plain, &r, n)?;
    let change = |k: usize| RobustChange { parameter: problem.free[k], difference: x[k] - plain[k], u: scale * u[k] };
    let mut weights: BTreeMap<PoseName, f64> = BTreeMap::new();
    for (pose, r) in problem.poses().into_iter().zip(&r) {
        let largest = weights.entry(pose).or_default();
        *largest = largest.max(r.abs());
    }
    let weight = |(pose, r): (PoseName, f64)| PoseWeight {
        pose,
        weight: 1.0 / (1.0 + (r / CAUCHY).powi(2)),
        residual_over_sigma: r,
    };
    let mut poses: Vec<PoseWeight> = weights.into_iter().map(weight).collect();
    poses.sort_by(|a, b| b.residual_over_sigma.total_cmp(&a.residual_over_sigma).then(a.pose.cmp(&b.pose)));
    Some(RobustComparison {
        values: problem.all(&x),
        changes: (0..n).map(change).collect(),
        critical: quantile(SIGNIFICANCE, n, degrees),
        poses,
        critical_residual: quantile(SIGNIFICANCE, measured, degrees),
        sigma_mm: scale * problem.unit,
    })
}

/// Returns the bound on the absolute values of `count` quantities of mean zero and unit variance,
/// exceeded with this probability (Šidák 1967).
pub(crate) fn quantile(probability: f64, count: usize, degrees: Option<f64>) -> f64 {
    let tail = -0.5 * ((-probability).ln_1p() / count as f64).exp_m1();
    match degrees.map(|nu| StudentsT::new(0.0, 1.0, nu)) {
        Some(Ok(student)) => -student.inverse_cdf(tail),
        _ => -Normal::standard().inverse_cdf(tail),
    }
}

/// Standard uncertainties of robust minus plain parameters, for residuals `r` in units of their
/// standard deviation.
fn differences(problem: &Residuals, x: &[f64], r: &[f64], n: usize) -> Option<Vec<f64>> {
    let (factor, norms) = factor_at(problem, x);
    let inverse = DMatrix::from_row_slice(n, n, &covariance(&factor, &norms)?);
    let jacobian = problem.jacobian_at(x);
    let loss = Loss::Cauchy(CAUCHY);
    let curvature = mean(r.iter().map(|&r| loss.curvature(r)));
    let step = |row: usize| {
        let j = DVector::from_column_slice(&jacobian[row * n..][..n]);
        // a residual is smaller than the error, as far as the fit follows it
        let redundancy = (1.0 - (&inverse * &j).dot(&j)).max(0.1);
        let r = (r[row] / redundancy.sqrt()).clamp(-CLIPPED, CLIPPED);
        j * (loss.influence(r) / curvature.max(0.5) - r)
    };
    let steps: Vec<DVector<f64>> = (0..r.len()).map(step).collect();
    let divisions = regional::divisions(problem).unwrap_or_else(|| vec![by_cluster(problem)]);
    let mut scatter = vec![0.0; n];
    for parts in &divisions {
        let count = parts.len() as f64;
        let share = count / (count - 1.0).max(1.0) / divisions.len() as f64;
        for part in parts {
            let sum = part.iter().filter_map(|&row| steps.get(row)).fold(DVector::zeros(n), |sum, step| sum + step);
            let step = &inverse * sum;
            scatter.iter_mut().zip(step.iter()).for_each(|(sum, step)| *sum += share * step * step);
        }
    }
    let normal = 1.0 / EFFICIENCY - 1.0;
    let larger = |k: usize| (normal * inverse[(k, k)]).max(scatter[k]).sqrt();
    Some((0..n).map(larger).collect())
}

/// Rows of each cluster.
fn by_cluster(problem: &Residuals) -> Vec<Vec<usize>> {
    let mut rows: BTreeMap<PoseName, Vec<usize>> = BTreeMap::new();
    problem.clusters().into_iter().enumerate().for_each(|(row, cluster)| rows.entry(cluster).or_default().push(row));
    rows.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The efficiency of the constant, by quadrature: (E ψ')² / E ψ² of a normal residual; and
    /// quantiles of tables.
    #[test]
    fn the_constant_costs_five_percent() {
        let loss = Loss::Cauchy(CAUCHY);
        let (mut bend, mut square) = (0.0, 0.0);
        for i in -8000..8000 {
            let r = (f64::from(i) + 0.5) * 1e-3;
            let density = (-0.5 * r * r).exp() / std::f64::consts::TAU.sqrt() * 1e-3;
            bend += loss.curvature(r) * density;
            square += loss.influence(r).powi(2) * density;
        }
        assert!((bend * bend / square - EFFICIENCY).abs() < 5e-4, "{}", bend * bend / square);
        // two-sided 5 % and 1 % of the normal distribution and of Student's with 10 degrees of
        // freedom
        assert!(
            (quantile(0.05, 1, None) - 1.959_964).abs() < 1e-5 && (quantile(0.01, 1, None) - 2.575_829).abs() < 1e-5
        );
        assert!((quantile(0.05, 1, Some(10.0)) - 2.228_139).abs() < 1e-5);
        assert!((quantile(0.05, 10, None) - 2.799_7).abs() < 1e-3, "{}", quantile(0.05, 10, None));
    }
}
