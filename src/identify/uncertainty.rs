//! How well parameters are known: covariance, chi-square, observability, and parameters that are hardly told apart.

use super::residuals::Residuals;
use super::{Identification, ResidualKind, Settings, Settled, Status};
use crate::message::Message;
use crate::robots::{Quantity, Robot};
use crate::solve::{Factor, Problem, Solution, Svd, svd};
use nalgebra::{DMatrix, Matrix3x4, Vector3};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Singular values of the Jacobian and the indices made of them (eq. 1.19 to 1.25).
///
/// The indices are those of the Jacobian in mm per mm and mm per rad, without weights; the condition number is that of
/// the Jacobian with its columns divided by their norms.
#[derive(Clone, Debug, PartialEq)]
pub struct Observability {
    /// O1 to O5. O1 is (σ1…σm)^(1/m) / √n with m parameters and n poses (Sun & Hollerbach 2008).
    pub indices: [f64; 5],
    /// Condition number with scaled columns.
    pub condition: f64,
    /// Number of parameters told apart.
    pub rank: usize,
}

/// Parameters that the data can hardly tell apart: their uncertainties are large and cancel each other.
#[derive(Clone, Debug, PartialEq)]
pub struct WeakGroup {
    /// Indices of the parameters.
    pub parameters: Vec<usize>,
    /// Their predicted standard uncertainties (mm, rad, 1).
    pub standard_uncertainties: Vec<f64>,
    /// Largest correlation among them, by size.
    pub correlation: f64,
}

/// Parameters are hardly told apart where their uncertainty alone would move the targets by more than this many times
/// what the instrument resolves (root mean square over all residuals).
const WEAK_EFFECT: f64 = 10.0;
/// Share of a weak singular vector above which a parameter is named.
const WEAK_MEMBER: f64 = 0.3;
/// Probability with which a chi-square test rejects a right model.
const REJECT: f64 = 1e-3;

/// What a settled solution means.
pub(super) fn conclude(
    robot: &dyn Robot,
    settings: &Settings,
    problem: &Residuals,
    wanted: &[usize],
    settled: Settled,
) -> Identification {
    let Settled { values, groups, solution, iterations, .. } = settled;
    let solution = &solution;
    let (m, n) = (problem.residual_count(), problem.free.len());
    let dof = m - n;
    let variance_of_residuals = if dof > 0 { solution.cost() / dof as f64 } else { 0.0 };
    let sandwich = settings.standard_uncertainty_mm.and_then(|u| pose_covariance(problem, solution, u));
    let (mut covariance, chi_square) = match (settings.kind, settings.standard_uncertainty_mm) {
        (ResidualKind::Pose, Some(_)) => sandwich.map_or((Vec::new(), None), |(c, chi)| (c, Some(chi))),
        (_, Some(_)) => (solution.covariance().unwrap_or_default(), Some(solution.cost())),
        (_, None) => {
            let scaled = |c: Vec<f64>| c.into_iter().map(|v| v * variance_of_residuals).collect();
            (solution.covariance().map(scaled).unwrap_or_default(), None)
        }
    };
    let mut warnings = Vec::new();
    let model_factor = match chi_square {
        Some(chi) if dof > 0 && exceeds(chi, dof) => {
            let factor = chi / dof as f64;
            warnings.push(
                Message::warning(format!(
                    "residuals are {:.1} times what the instrument's uncertainty explains (chi-square {chi:.0} for {dof} \
                     degrees of freedom): standard uncertainties are enlarged by that factor",
                    factor.sqrt()
                ))
                .hint("the robot has errors that the model does not describe, or the stated uncertainty is too small"),
            );
            factor
        }
        _ => 1.0,
    };
    covariance.iter_mut().for_each(|c| *c *= model_factor);
    let (observability, weak) = observe(problem, solution, &covariance);
    let group = |g: &super::Group| {
        let names: Vec<&str> = g.with.iter().map(|&i| robot.parameters()[i].name.as_str()).collect();
        let held = &robot.parameters()[g.held].name;
        if names.is_empty() {
            Message::warning(format!("the data do not see `{held}`: it is held at its nominal value"))
        } else {
            Message::warning(format!(
                "the data cannot tell apart `{held}` and `{}`: `{held}` is held at its nominal value",
                names.join("`, `")
            ))
        }
    };
    warnings.extend(groups.iter().map(group));
    warnings.extend(weak.iter().map(|w| weak_message(robot, w)));
    let status = |i| match () {
        () if problem.free.contains(&i) => Status::Identified,
        () if wanted.contains(&i) => Status::NotIdentifiable,
        () => Status::Fixed,
    };
    Identification {
        status: (0..values.len()).map(status).collect(),
        values,
        free: problem.free.clone(),
        covariance,
        model_factor,
        groups,
        weak,
        observability,
        rms: (solution.cost() / m.max(1) as f64).sqrt() * problem.unit,
        max: solution.residuals.iter().fold(0.0f64, |w, r| w.max(r.abs())) * problem.unit,
        degrees_of_freedom: dof,
        chi_square,
        iterations,
        termination: solution.termination,
        warnings,
    }
}

/// Whether chi-square is too large for the degrees of freedom.
fn exceeds(chi_square: f64, dof: usize) -> bool {
    ChiSquared::new(dof as f64).is_ok_and(|d| d.sf(chi_square) < REJECT)
}

/// Covariance of unweighted pose residuals whose noise comes from the balls: A⁻¹ (Σ Jᵀ S Sᵀ J u²) A⁻¹ with A = JᵀJ,
/// and chi-square with the residuals weighted by (S Sᵀ u²)⁻¹.
fn pose_covariance(problem: &Residuals, solution: &Solution, u: f64) -> Option<(Vec<f64>, f64)> {
    let sensitivities = problem.ball_sensitivities(&solution.x)?;
    let n = solution.x.len();
    let mut jacobian = vec![0.0; problem.residual_count() * n];
    problem.jacobian(&solution.x, &mut jacobian);
    let inverse = DMatrix::from_row_slice(n, n, &solution.covariance()?);
    let mut middle = DMatrix::zeros(n, n);
    let mut chi_square = 0.0;
    for ((rows, r), s) in jacobian.chunks_exact(3 * n).zip(solution.residuals.chunks_exact(3)).zip(&sensitivities) {
        let noise = u * Matrix3x4::from_fn(|i, j| s[i][j]); // S u
        let by_ball = noise.transpose() * DMatrix::from_row_slice(3, n, rows); // u Sᵀ J
        middle += by_ball.tr_mul(&by_ball);
        let r = Vector3::from_column_slice(r);
        chi_square += r.dot(&(noise * noise.transpose()).cholesky()?.solve(&r));
    }
    let covariance = &inverse * middle * &inverse;
    Some((covariance.as_slice().to_vec(), chi_square))
}

fn observe(problem: &Residuals, solution: &Solution, covariance: &[f64]) -> (Observability, Vec<WeakGroup>) {
    let n = problem.free.len();
    let empty = Observability { indices: [f64::NAN; 5], condition: f64::NAN, rank: 0 };
    let Some(factor) = &solution.factor else { return (empty, Vec::new()) };
    let scaled = svd(factor);
    let unscaled = svd(&unscale(factor, &solution.scale, problem.unit));
    let poses = problem.pose_count();
    let observability = Observability {
        indices: indices(&unscaled, poses),
        condition: scaled.condition(),
        rank: scaled.rank(super::RANK_TOLERANCE),
    };
    let u = |k: usize| covariance.get(k * n + k).map_or(f64::NAN, |v| v.sqrt());
    let correlation = |i: usize, j: usize| covariance.get(i * n + j).map_or(f64::NAN, |c| c / (u(i) * u(j)));
    let rows = problem.residual_count() as f64;
    let weak = (0..n)
        .filter(|&k| 1.0 / (scaled.values[k] * rows.sqrt()) > WEAK_EFFECT)
        .map(|k| {
            let members: Vec<usize> = (0..n).filter(|&j| scaled.vectors[k][j].abs() > WEAK_MEMBER).collect();
            let pairs = members.iter().flat_map(|&i| members.iter().filter(move |&&j| j > i).map(move |&j| (i, j)));
            let strongest =
                pairs.map(|(i, j)| correlation(i, j)).fold(0.0f64, |a, b| if b.abs() > a.abs() { b } else { a });
            WeakGroup {
                standard_uncertainties: members.iter().map(|&j| u(j)).collect(),
                parameters: members.into_iter().map(|j| problem.free[j]).collect(),
                correlation: strongest,
            }
        })
        .collect();
    (observability, weak)
}

/// The factor of the Jacobian without column scaling and weights.
fn unscale(factor: &Factor, scale: &[f64], unit: f64) -> Factor {
    let n = scale.len();
    let rows: Vec<f64> = (0..n * n).map(|k| factor.r(k / n, k % n) * unit).collect();
    let inverse: Vec<f64> = scale.iter().map(|s| 1.0 / s).collect();
    Factor::new(&rows, &vec![0.0; n], &inverse)
}

/// O1 to O5 from the singular values (eq. 1.19, 1.20, 1.22, 1.23, 1.25).
fn indices(svd: &Svd, poses: usize) -> [f64; 5] {
    let (Some(&largest), Some(&smallest)) = (svd.values.first(), svd.values.last()) else { return [f64::NAN; 5] };
    let m = svd.values.len() as f64;
    let mean_log = svd.values.iter().map(|s| s.ln()).sum::<f64>() / m;
    let harmonic: f64 = svd.values.iter().map(|s| 1.0 / s).sum();
    [
        mean_log.exp() / (poses as f64).sqrt(),
        smallest / largest,
        smallest,
        smallest * smallest / largest,
        1.0 / harmonic,
    ]
}

fn weak_message(robot: &dyn Robot, weak: &WeakGroup) -> Message {
    let parameters: Vec<_> = weak.parameters.iter().map(|&i| &robot.parameters()[i]).collect();
    let names: Vec<&str> = parameters.iter().map(|p| p.name.as_str()).collect();
    let say = |(p, &u): (&&crate::robots::Parameter, &f64)| match p.quantity {
        Quantity::Ratio => format!("u({}) = {u:.2e}", p.name),
        quantity => format!("u({}) = {:.3} {}", p.name, quantity.outward(u), quantity.unit()),
    };
    let uncertainties: Vec<String> = parameters.iter().zip(&weak.standard_uncertainties).map(say).collect();
    let what = format!(
        "these poses can hardly tell apart `{}`: predicted standard uncertainties {} (correlation {:.6})",
        names.join("` and `"),
        uncertainties.join(", "),
        weak.correlation
    );
    let remedy =
        robot.remedy(&names).unwrap_or("measure poses in which these parameters act differently, or hold one of them");
    Message::warning(what).hint(remedy)
}
