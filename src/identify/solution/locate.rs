//! Targets and fixtures located by their own readings, with the robot and everything else held.

use crate::model::kinds::{Condition, Kind, Known, Orientation, Surface};
use crate::model::residuals::Residuals;
use crate::solution::fixtures::place_seen;
use crate::solution::identifiability::Analysis;
use crate::solution::placing::place_targets;
use crate::{Observation, Result, Settings};
use etalon_math::{Options, covariance, factor_at, solve};
use etalon_robots::{FreeBase, Robot};
use std::collections::{BTreeMap, BTreeSet};

/// Iterations of one placement.
const ITERATIONS: usize = 200;
/// Maximum number of changes of the determined parameters.
const ROUNDS: usize = 6;

/// Targets and fixtures that were located with everything else held.
#[derive(Clone, Debug)]
pub struct Placement {
    /// All parameters (mm, rad, 1).
    pub values: Vec<f64>,
    /// Standard uncertainty (mm, rad) of each parameter that the readings determine, for residuals
    /// of 1 mm, or of the given standard uncertainty of a coordinate if there is one.
    pub uncertainties: BTreeMap<usize, f64>,
    /// Redundancy number of each measured target of each observation: the share of its error that
    /// the residual shows, 1 - h.
    pub observations: Vec<Vec<Option<f64>>>,
    /// Redundancy number of each condition.
    pub conditions: Vec<f64>,
}

impl Condition {
    /// Indices of the parameters of the fixture and of the target on which the condition depends.
    pub fn shows(&self, arm: &dyn FreeBase) -> Vec<Vec<usize>> {
        let equation = self.kind.equation();
        let mut shown = match self.kind {
            Kind::Orientation(Orientation { mounting, station, .. }) => {
                vec![three(mounting).collect(), station.into_iter().flat_map(|first| first..first + 6).collect()]
            }
            _ => vec![equation.unknowns()],
        };
        if equation.depends_on_target() {
            let targets = std::iter::once(self.target).chain(equation.other_target());
            shown.extend(targets.map(|k| three(arm.target_place(k)).collect()));
        }
        shown.retain(|group| !group.is_empty());
        shown
    }
}

impl Known {
    /// Indices of the parameters that the fact locates in the world; a distance or a radius alone
    /// locates nothing.
    pub fn places(&self) -> Vec<usize> {
        match *self {
            Self::Place { point, .. } => three(point).collect(),
            Self::Seen { station, point, .. } => (station..station + 6).chain(three(point)).collect(),
            Self::On { surface, unknowns, .. } => unknowns[..Surface::unknowns(surface)].to_vec(),
            Self::Distance { .. } | Self::Length { .. } => Vec::new(),
        }
    }

    /// `true` if the fact refers to one of these parameters.
    pub fn refers_to(&self, parameters: &BTreeSet<usize>) -> bool {
        self.points().iter().any(|first| parameters.contains(first))
    }
}

impl Observation {
    /// Indices of the parameters of each target that was measured.
    pub fn shows(&self, arm: &dyn FreeBase) -> Vec<Vec<usize>> {
        let measured = (0..self.targets.len()).filter(|&k| self.targets[k].is_some());
        measured.map(|k| three(arm.target_place(k)).collect()).collect()
    }
}

fn three(first: usize) -> std::ops::Range<usize> {
    first..first + 3
}

/// Locates the parameters `places` of targets and fixtures by these readings, with all others at
/// `values`.
///
/// # Errors
/// Fails for a robot without a free base, which has no such parameters, and if residuals cannot be
/// set up.
pub fn locate_points(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    values: &[f64],
    places: &[usize],
) -> Result<Placement> {
    let mut values = values.to_vec();
    let mut placed = Placement {
        uncertainties: BTreeMap::new(),
        observations: observations.iter().map(|o| o.targets.iter().map(|at| at.map(|_| 0.0)).collect()).collect(),
        conditions: vec![0.0; settings.conditions.len()],
        values: values.clone(),
    };
    let Some(arm) = robot.free_base().filter(|_| !places.is_empty()) else { return Ok(placed) };
    let measured: BTreeSet<usize> =
        observations.iter().flat_map(|o| (0..o.targets.len()).filter(|&k| o.targets[k].is_some())).collect();
    let of_place = |k: &usize| places.contains(&arm.target_place(*k));
    let targets: BTreeSet<usize> = measured.iter().copied().filter(of_place).collect();
    place_targets(arm, observations, &targets, &mut values);
    // all others have their places
    let seen = (0..robot.targets().len()).filter(|k| measured.contains(k) || !of_place(k)).collect();
    place_seen(arm, &seen, settings, places, &mut values);
    let Some((free, values)) = solved(robot, observations, settings, values.clone(), places)? else {
        placed.values = values;
        return Ok(placed);
    };
    placed.values = values;
    let problem = Residuals::new(robot, observations, settings, &free, &placed.values)?;
    let x: Vec<f64> = free.iter().map(|&i| placed.values[i]).collect();
    let (factor, scale) = factor_at(&problem, &x);
    let Some(inverse) = covariance(&factor, &scale) else { return Ok(placed) };
    let n = free.len();
    for (k, &i) in free.iter().enumerate() {
        placed.uncertainties.insert(i, inverse[k * n + k].sqrt());
    }
    let jacobian = problem.jacobian_rows(&problem.jacobian_at(&x)).dense();
    let mut redundancy = jacobian.chunks_exact(n).map(|row| 1.0 - leverage(row, &inverse));
    let mut mean = |rows: usize| redundancy.by_ref().take(rows).sum::<f64>() / rows as f64;
    for of_target in placed.observations.iter_mut().flatten().flatten() {
        *of_target = mean(robot.dimension()).clamp(0.0, 1.0);
    }
    for (of_condition, condition) in placed.conditions.iter_mut().zip(&settings.conditions) {
        *of_condition = mean(condition.kind.rows()).clamp(0.0, 1.0);
    }
    Ok(placed)
}

/// Parameters of `places` that the readings determine, and all values at the solution; `None` if
/// they determine none, or the solver fails. Held parameters are chosen again at the solution,
/// because directions that coincide at the start may differ there.
fn solved(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    mut values: Vec<f64>,
    places: &[usize],
) -> Result<Option<(Vec<usize>, Vec<f64>)>> {
    let mut free = Vec::new();
    for _ in 0..ROUNDS {
        let all = Residuals::new(robot, observations, settings, places, &values)?;
        let held = Analysis::at(&all, &values, 0.0).held();
        let now: Vec<usize> = places.iter().copied().filter(|i| !held.contains(i)).collect();
        if now.is_empty() {
            return Ok(None);
        }
        if now == free {
            break;
        }
        free = now;
        let problem = Residuals::new(robot, observations, settings, &free, &values)?;
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let solution = solve(&problem, &x, Options { iterations: ITERATIONS, ..Options::default() });
        if !solution.termination.is_success() {
            return Ok(None);
        }
        values = problem.all(&solution.x);
    }
    Ok(Some((free, values)))
}

/// h = j C jᵀ of a row of the Jacobian with few elements.
fn leverage(row: &[f64], inverse: &[f64]) -> f64 {
    let own: Vec<usize> = (0..row.len()).filter(|&k| row[k] != 0.0).collect();
    own.iter().flat_map(|&i| own.iter().map(move |&j| row[i] * row[j] * inverse[i * row.len() + j])).sum()
}
