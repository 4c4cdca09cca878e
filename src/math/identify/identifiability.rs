//! Which parameters are separately identifiable: rank of the scaled Jacobian, column by column in the model's order; and
//! the least-squares solution at which the same parameters are held as those it was found with.

use super::diagnosis::{diagnose_failure, nothing_left};
use super::residuals::Residuals;
use super::{Observation, Settings};
use crate::base::message::{Message, Result};
use crate::math::robots::{Parameter, Quantity, Robot, Role};
use crate::math::solve::{self, Factor, Options, Prior, Problem, Solution, WithPriors, column_norms};
use std::f64::consts::TAU;

/// A column of the scaled Jacobian that lies this near to the span of the columns before it adds nothing: far above
/// rounding (1e-15), far below what any useful set of poses has (1/condition, about 1/100: Schröer, cited in
/// Nahvi & Hollerbach 1996).
pub const RANK_TOLERANCE: f64 = 1e-9;
/// A column below this fraction of the largest is not seen by the data.
const UNSEEN: f64 = 1e-12;
/// Share of a dependence above which a parameter belongs to the group.
const MEMBER: f64 = 1e-4;
/// Correlation, by size, above which a parameter is named beside one that is known uselessly badly.
const CORRELATED: f64 = 0.5;

/// Parameters that are not separately identifiable; the last of them is held.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Index of the parameter that is held at its nominal value.
    pub held: usize,
    /// Indices of the parameters it is not separable from; empty where the data do not depend on `held` at all.
    pub with: Vec<usize>,
    /// Standard uncertainty (mm, rad, 1) that `held` would have if it were identified, where that is merely useless: the
    /// parameters would be separable with less noise.
    pub useless_uncertainty: Option<f64>,
}

/// Standard uncertainty beyond which data say less of a parameter than the drawing does, or, of base and targets, less
/// than a look at them (mm, rad, 1).
fn useless_beyond(parameter: &Parameter) -> f64 {
    match (parameter.role, parameter.quantity) {
        (Role::Robot, Quantity::Length) => 10.0,
        (Role::Robot, Quantity::Angle) => 2f64.to_radians(),
        (Role::Robot, Quantity::Ratio) => 0.05,
        (_, Quantity::Length) => 100.0,
        (_, _) => 0.2,
    }
}

/// Rank and groups at one set of parameter values.
pub(super) struct Analysis {
    pub groups: Vec<Group>,
}

impl Analysis {
    /// Analyses the Jacobian of `problem` at `values` (all parameters of the robot), where a residual has the standard
    /// deviation `noise` (in the residuals' own unit; 0 where it is not known).
    pub fn at(problem: &Residuals, values: &[f64], noise: f64) -> Self {
        let free = &problem.free;
        let n = free.len();
        let m = problem.residual_count();
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let mut jacobian = vec![0.0; m * n];
        problem.jacobian(&x, &mut jacobian);
        let norms = column_norms(&jacobian, n);
        let factor = Factor::new(&jacobian, &vec![0.0; m], &norms);
        // column_norms gives 1 for a column of zeros: its R is zero too
        let size = |j: usize| (0..=j).map(|i| factor.r(i, j).powi(2)).sum::<f64>().sqrt() * norms[j];
        let largest = (0..n).map(size).fold(0.0, f64::max);
        let mut basis: Vec<(usize, Vec<f64>)> = Vec::new();
        let mut groups = Vec::new();
        for j in 0..n {
            if size(j) <= UNSEEN * largest {
                groups.push(Group { held: free[j], with: Vec::new(), useless_uncertainty: None });
                continue;
            }
            let column: Vec<f64> = (0..n).map(|i| factor.r(i, j)).collect();
            let (shares, rest) = split(&column, &basis);
            let distance = rest.iter().map(|v| v * v).sum::<f64>().sqrt();
            if distance > RANK_TOLERANCE {
                basis.push((j, rest.into_iter().map(|v| v / distance).collect()));
                continue;
            }
            let weights = weights(&shares, &basis, &factor);
            let member = |(k, w): (usize, &f64)| (w.abs() > MEMBER).then_some(free[basis[k].0]);
            groups.push(Group {
                held: free[j],
                with: weights.iter().enumerate().filter_map(member).collect(),
                useless_uncertainty: None,
            });
        }
        let kept = basis.into_iter().map(|(j, _)| j).collect();
        groups.extend(useless(problem, &factor, &norms, kept, noise));
        Self { groups }
    }

    /// Indices of the parameters that are held.
    pub fn held(&self) -> Vec<usize> {
        self.groups.iter().map(|g| g.held).collect()
    }
}

/// Of the columns `kept`, those whose parameters would be known uselessly badly: the worst is held, until none is left.
fn useless(problem: &Residuals, factor: &Factor, norms: &[f64], mut kept: Vec<usize>, noise: f64) -> Vec<Group> {
    let mut groups = Vec::new();
    loop {
        let rows: Vec<f64> = (0..norms.len()).flat_map(|i| kept.iter().map(move |&j| factor.r(i, j))).collect();
        let some = Factor::new(&rows, &vec![0.0; norms.len()], &vec![1.0; kept.len()]);
        let Some(inverse) = some.inverse_normal() else { return groups };
        let n = kept.len();
        let u = |k: usize| noise * inverse[k * n + k].sqrt() / norms[kept[k]];
        let excess = |k: usize| u(k) / useless_beyond(&problem.robot.parameters()[problem.free[kept[k]]]);
        let worst = (0..n).filter(|&k| excess(k) > 1.0).max_by(|&a, &b| excess(a).total_cmp(&excess(b)));
        let Some(worst) = worst else { return groups };
        let correlation = |k: usize| inverse[worst * n + k] / (inverse[worst * n + worst] * inverse[k * n + k]).sqrt();
        groups.push(Group {
            held: problem.free[kept[worst]],
            with: (0..n)
                .filter(|&k| k != worst && correlation(k).abs() > CORRELATED)
                .map(|k| problem.free[kept[k]])
                .collect(),
            useless_uncertainty: Some(u(worst)),
        });
        kept.remove(worst);
    }
}

/// Shares of `column` along the orthonormal `basis` and what is left of it (Gram-Schmidt, done twice: Giraud et al. 2005).
fn split(column: &[f64], basis: &[(usize, Vec<f64>)]) -> (Vec<f64>, Vec<f64>) {
    let mut rest = column.to_vec();
    let mut shares = vec![0.0; basis.len()];
    for _ in 0..2 {
        for ((_, q), share) in basis.iter().zip(&mut shares) {
            let along: f64 = q.iter().zip(&rest).map(|(q, r)| q * r).sum();
            rest.iter_mut().zip(q).for_each(|(r, q)| *r -= along * q);
            *share += along;
        }
    }
    (shares, rest)
}

/// The same column as a sum of the columns behind the basis: back substitution in their triangular matrix.
fn weights(shares: &[f64], basis: &[(usize, Vec<f64>)], factor: &Factor) -> Vec<f64> {
    let element = |i: usize, k: usize| -> f64 {
        let column = basis[k].0;
        basis[i].1.iter().enumerate().map(|(row, q)| q * factor.r(row, column)).sum()
    };
    let mut weights = shares.to_vec();
    for k in (0..basis.len()).rev() {
        weights[k] /= element(k, k);
        for i in 0..k {
            weights[i] -= element(i, k) * weights[k];
        }
    }
    weights
}

/// Observations that suffice to come near, if they are spread over all.
const SUBSET: usize = 96;
/// Changes of what is held after which the search ends.
const ROUNDS: usize = 8;
/// Noise that the first, tied solution takes residuals to have.
const ANCHOR_MM: f64 = 0.01;

/// A solution, and what was held to find it.
pub(super) struct Identifiable {
    /// All parameters of the robot.
    pub values: Vec<f64>,
    /// Indices of the free ones.
    pub free: Vec<usize>,
    /// What was held, and why.
    pub groups: Vec<Group>,
    /// The solution in the free parameters.
    pub solution: Solution,
    /// Steps taken in all.
    pub iterations: usize,
}

/// Solves for the `wanted` parameters from `start` (all parameters of the robot).
pub(super) fn solve_identifiable(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
    start: &[f64],
) -> Result<Identifiable> {
    // a subset of many poses brings the parameters near, all poses then take few steps
    let (mut values, mut held) = (start.to_vec(), None);
    if observations.len() > 2 * SUBSET {
        let step = observations.len().div_ceil(SUBSET);
        let subset: Vec<Observation> = observations.iter().step_by(step).cloned().collect();
        if let Ok(near) = rounds(robot, &subset, settings, wanted, values.clone(), None) {
            (values, held) = (near.values, Some(near.groups.iter().map(|g| g.held).collect()));
        }
    }
    let mut found = rounds(robot, observations, settings, wanted, values, held)?;
    // a whole turn more or less is the same robot: the angle nearest to nominal is taken
    for (value, p) in found.values.iter_mut().zip(robot.parameters()) {
        if p.quantity == Quantity::Angle {
            *value -= ((*value - p.nominal) / TAU).round() * TAU;
        }
    }
    found.solution.x = found.free.iter().map(|&i| found.values[i]).collect();
    Ok(found)
}

/// Solves with redundant and useless parameters held, until the same are redundant at the solution; `held` is a first guess of them.
fn rounds(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
    start: Vec<f64>,
    held: Option<Vec<usize>>,
) -> Result<Identifiable> {
    let mut values = start.clone();
    let mut iterations = 0;
    let (asked, mut wanted) = (wanted, wanted.to_vec());
    // what a solution showed to be useless stays held: at nominal it may look better than it is
    let mut useless: Vec<Group> = Vec::new();
    let mut held = match held {
        Some(held) => held,
        None => {
            let near = anchored(robot, observations, settings, &wanted, &values)?;
            values = near.0;
            useless = near.1.iter().filter(|g| g.useless_uncertainty.is_some()).cloned().collect();
            held_by(&near.1)
        }
    };
    for _round in 0..ROUNDS {
        let free = without(&wanted, &held);
        if free.is_empty() {
            return Err(nothing_left(robot, observations, &start).into());
        }
        for &i in &held {
            values[i] = robot.parameters()[i].nominal;
        }
        let problem = Residuals::new(robot, observations, settings, &free, &values)?;
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let solution = solve::solve(&problem, &x, Options::default());
        iterations += solution.iterations;
        values = problem.all(&solution.x);
        if !solution.termination.is_success() {
            return Err(diagnose_failure(robot, observations, settings, asked, &start, solution.termination));
        }
        wanted.retain(|&i| useless.iter().all(|g| g.held != i));
        let all = Residuals::new(robot, observations, settings, &wanted, &values)?;
        let (new, redundant): (Vec<Group>, Vec<Group>) = Analysis::at(&all, &values, all.noise(Some(&solution)))
            .groups
            .into_iter()
            .partition(|g| g.useless_uncertainty.is_some());
        useless.extend(new);
        let groups = [useless.clone(), redundant].concat();
        let now = held_by(&groups);
        if now == held {
            return Ok(Identifiable { values, free, groups, solution, iterations });
        }
        held = now;
    }
    Err(Message::error("which parameters are separately identifiable changes from step to step")
        .hint("hold parameters in [identify], or measure more poses")
        .into())
}

fn without(wanted: &[usize], held: &[usize]) -> Vec<usize> {
    wanted.iter().copied().filter(|i| !held.contains(i)).collect()
}

/// What `groups` hold, in the model's order.
fn held_by(groups: &[Group]) -> Vec<usize> {
    let mut held: Vec<usize> = groups.iter().map(|g| g.held).collect();
    held.sort_unstable();
    held
}

/// A first solution tied to the start, each parameter as loosely as it may be known before it is useless, and what must
/// be held there: what the data do not determine stays where it is, instead of running away.
fn anchored(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
    start: &[f64],
) -> Result<(Vec<f64>, Vec<Group>)> {
    let all = Residuals::new(robot, observations, settings, wanted, start)?;
    let analysis = Analysis::at(&all, start, 0.0);
    let free = without(wanted, &held_by(&analysis.groups));
    if free.is_empty() {
        return Err(nothing_left(robot, observations, start).into());
    }
    let residuals = Residuals::new(robot, observations, settings, &free, start)?;
    let x: Vec<f64> = free.iter().map(|&i| start[i]).collect();
    let weight = |&i: &usize| ANCHOR_MM / residuals.unit / useless_beyond(&robot.parameters()[i]);
    let prior = |(parameter, i)| Prior { parameter, value: x[parameter], weight: weight(i) };
    let priors: Vec<Prior> = free.iter().enumerate().map(prior).collect();
    let solution =
        solve::solve(&WithPriors::new(&residuals, &priors), &x, Options { step: 1e-3, ..Options::default() });
    if !solution.termination.is_success() {
        return Ok((start.to_vec(), analysis.groups));
    }
    let values = residuals.all(&solution.x);
    let noise = all.noise(Some(&solution));
    Ok((values.clone(), Analysis::at(&all, &values, noise).groups))
}
