//! The least-squares solution, repeated until the held parameters no longer change.

use crate::judgement::diagnosis::{diagnose_failure, nothing_left};
use crate::model::elimination::Layout;
use crate::model::prior::Prior;
use crate::model::residuals::Residuals;
use crate::solution::estimation::Estimation;
use crate::solution::evidence::most_probable;
use crate::solution::identifiability::{Analysis, Group};
use crate::{Error, Result};
use crate::{Observation, Settings};
use etalon_base::angle::Turn;
use etalon_base::pattern::matches_pattern;
use etalon_math::{Options, Solution, WithPriors};
use etalon_robots::{Effect, Parameter, Quantity, Robot, Role};

/// Number of observations, spread over all, that is sufficient for an approximate solution.
const SUBSET: usize = 96;
/// Maximum number of changes of the held parameters.
const ROUNDS: usize = 8;
/// Maximum number of iterations of one solution: robots near nominal need a dozen.
const ITERATIONS: usize = 600;
/// Assumed noise of the residuals in the first, tied solution.
const ANCHOR_MM: f64 = 0.01;
/// Minimum noise relative to which nominal values count.
const LEAST_NOISE_MM: f64 = 1e-4;
/// Share of the parameters determined by nominal values above which these may keep residuals large.
const BY_NOMINAL: f64 = 0.2;
/// Residuals over their standard uncertainty from which another start is tried for a solution with
/// held geometry.
const UNEXPLAINED: f64 = 1.1;
/// Ratio of the standard deviations of residuals below which another solution is better.
const BETTER: f64 = 0.99;
/// Relative change of the noise below which the weight of nominal values has converged.
const SETTLED: f64 = 0.02;

/// A solution, and the parameters held in it.
pub(crate) struct Identifiable {
    /// All parameters of the robot.
    pub values: Vec<f64>,
    /// Indices of the free ones.
    pub free: Vec<usize>,
    /// Held parameters, with reasons.
    pub groups: Vec<Group>,
    /// Indices of free parameters that the data show only together with others.
    pub by_nominal: Vec<usize>,
    /// The solution in the free parameters.
    pub solution: Solution,
    /// Total number of steps.
    pub iterations: usize,
    /// Weight of nominal values.
    pub prior: Prior,
    /// Factor of the rows of given shapes.
    pub weight: f64,
}

/// A solution of some of the poses, from which the solution of all poses is reached in few steps.
struct Near {
    /// All parameters of the robot.
    values: Vec<f64>,
    /// Indices of held parameters; `None` to choose them at these values.
    held: Option<Vec<usize>>,
    /// Most probable prior there.
    prior: Prior,
}

/// Solves for the `wanted` parameters from `start` (all parameters of the robot).
pub(crate) fn solve_identifiable(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
    start: &[f64],
) -> Result<Identifiable> {
    let estimation = Estimation { robot, observations, settings, wanted };
    // a subset of many poses brings the parameters near, all poses then take few steps; many
    // targets are not all in one
    let mut near = None;
    let many = || Layout::new(robot, wanted, observations, settings).is_some();
    if observations.len() > 2 * SUBSET && !many() {
        let step = observations.len().div_ceil(SUBSET);
        let subset: Vec<Observation> = observations.iter().step_by(step).cloned().collect();
        near = Estimation { observations: &subset, ..estimation }.near(start).ok();
    }
    estimation.whole(start, near)
}

/// Chooses the angles nearest to nominal: a whole turn more or less is the same robot. Components
/// of a rotation vector (free base, targets) are unchanged.
fn whole_turns(robot: &dyn Robot, values: &mut [f64]) {
    let vector = |role: Role| role == Role::Target || role == Role::Base && robot.free_base().is_some();
    for (value, p) in values.iter_mut().zip(robot.parameters()) {
        if p.quantity == Quantity::Angle && !vector(p.role) {
            *value = Turn::RADIANS.near(*value, p.nominal);
        }
    }
}

impl Estimation<'_> {
    /// Solution in which every parameter has its value next to nominal, and rigid parts stay rigid.
    fn whole(&self, start: &[f64], near: Option<Near>) -> Result<Identifiable> {
        let Self { robot, observations, settings, .. } = *self;
        let mut found = self.solve(start, near)?;
        if let Some(other) = self.freed(start, &found)? {
            found = other;
        }
        if settings.prior == Prior::None && !settings.rigid.is_empty() {
            // residuals show how far errors of the robot exceed the instrument's: the parts stay
            // rigid beside them
            let problem = Residuals::new(robot, observations, settings, &found.free, &found.values)?;
            let (weight, before) = (problem.noise(Some(&found.solution)), found.iterations);
            let held = found.groups.iter().map(|g| g.held).collect();
            let settings = settings.with_weight(weight);
            found = Estimation { settings: &settings, ..*self }.rounds(found.values, Some(held))?;
            found.weight = weight;
            found.iterations += before;
        }
        whole_turns(robot, &mut found.values);
        found.solution.x = found.free.iter().map(|&i| found.values[i]).collect();
        Ok(found)
    }

    /// Solves from `start` (all parameters of the robot), or from a solution of some of the poses.
    fn solve(&self, start: &[f64], near: Option<Near>) -> Result<Identifiable> {
        match (self.settings.prior, near) {
            (Prior::None, Some(near)) => self.rounds(near.values, near.held),
            (Prior::None, None) => self.rounds(start.to_vec(), None),
            (Prior::Tolerances { .. }, near) => Ok(self.with_prior(start, near, ROUNDS)?.0),
        }
    }

    /// Solution from the one in which the geometry that the settings hold is free; `None` if it is
    /// not better than the solution `found`, if that solution explains the data, or if the held
    /// geometry may cause the residuals.
    ///
    /// The link between nearly parallel axes has its length only at one height. With a held length
    /// the data determine this height through the small tilt: from a start with the tilt of the
    /// other sign, the height runs away, and the residuals stay.
    fn freed(&self, start: &[f64], found: &Identifiable) -> Result<Option<Identifiable>> {
        let Self { robot, observations, settings, wanted } = *self;
        let held = |p: &Parameter| settings.hold.iter().any(|pattern| matches_pattern(pattern, &p.name));
        let is_length =
            |p: &Parameter| p.role == Role::Robot && p.effect == Effect::Geometry && p.tolerance.is_finite() && held(p);
        let parameters = robot.parameters();
        let freed: Vec<usize> =
            (0..parameters.len()).filter(|i| wanted.contains(i) || is_length(&parameters[*i])).collect();
        if freed.len() == wanted.len() || robot.free_base().is_none() {
            return Ok(None);
        }
        let misfit = |found: &Identifiable| -> Result<f64> {
            Ok(Residuals::new(robot, observations, settings, &found.free, &found.values)?.noise(Some(&found.solution)))
        };
        let before = misfit(found)?;
        if settings.standard_uncertainty_mm.is_some() && before < UNEXPLAINED {
            return Ok(None);
        }
        // the held geometry is redundant at the solution, but not at nominal
        let plain = settings.without_prior();
        let redundant = |free: &[usize], values: &[f64]| -> Result<usize> {
            let problem = Residuals::new(robot, observations, &plain, &by_rank(robot, free), values)?;
            Ok(Analysis::at(&problem, values, 0.0).groups.len())
        };
        let more =
            |values: &[f64]| Ok::<_, Error>(redundant(&freed, values)?.saturating_sub(redundant(wanted, values)?));
        if more(&found.values)? <= more(start)? {
            return Ok(None);
        }
        let Ok(mut near) = (Estimation { wanted: &freed, ..*self }).near(start) else { return Ok(None) };
        freed.iter().filter(|i| !wanted.contains(i)).for_each(|&i| near.values[i] = start[i]);
        let Ok(other) = self.solve(start, Some(Near { held: None, ..near })) else { return Ok(None) };
        Ok((misfit(&other)? < BETTER * before).then_some(other))
    }

    /// Returns a solution near the solution of all poses.
    fn near(&self, start: &[f64]) -> Result<Near> {
        let (found, prior) = match self.settings.prior {
            Prior::None => (self.rounds(start.to_vec(), None)?, Prior::None),
            // weight and scale change once more with all poses
            Prior::Tolerances { .. } => self.with_prior(start, None, 1)?,
        };
        Ok(Near { held: Some(held_by(&found.groups)), values: found.values, prior })
    }

    /// Solves with nominal values as readings: parameters that are redundant in the data alone are
    /// held, everything else is well posed. Nominal values are weighted relative to the noise of
    /// the residuals, if it exceeds the given one. Returns the solution after at most `most`
    /// rounds, and the most probable prior there.
    fn with_prior(&self, start: &[f64], near: Option<Near>, most: usize) -> Result<(Identifiable, Prior)> {
        let Self { robot, observations, settings, wanted } = *self;
        let plain = settings.without_prior();
        let order = by_rank(robot, wanted);
        let recombined = self.recombined();
        let analyse = |values: &[f64], weight: f64| -> Result<Analysis> {
            let plain = plain.with_weight(weight);
            let analysis = |observations: &[Observation], free: &[usize]| -> Result<Analysis> {
                Ok(Analysis::by_prior(&Residuals::new(robot, observations, &plain, free, values)?, values))
            };
            let Some(more) = &recombined else { return analysis(observations, &order) };
            let never = analysis(more, &order)?;
            let measured = analysis(observations, &without(&order, &never.held()))?;
            Ok(never.with_nominal(measured))
        };
        let stated = settings.standard_uncertainty_mm;
        let mut weight = if stated.is_some() { 1.0 } else { ANCHOR_MM };
        let mut scale = 1.0;
        let (mut values, mut held) = match near {
            Some(near) => {
                if let Prior::Tolerances { weight: noise, scale: probable } = near.prior {
                    (weight, scale) = (noise, probable);
                }
                let held = near.held.map_or_else(|| Ok(held_by(&analyse(&near.values, weight)?.groups)), Ok);
                let held: Result<Vec<usize>> = held;
                (near.values, held?)
            }
            None => (start.to_vec(), held_by(&analyse(start, weight)?.groups)),
        };
        let mut iterations = 0;
        for round in 1.. {
            let free = without(wanted, &held);
            if free.is_empty() {
                return Err(nothing_left(robot, observations, settings, start));
            }
            hold(robot, &held, start, &mut values);
            let prior = Prior::Tolerances { weight, scale };
            let weighted = Settings { prior, ..settings.with_weight(weight) };
            // unknowns without tolerance are expected where the search began
            let problem = Residuals::new(robot, observations, &weighted, &free, start)?.holding(&values);
            let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
            let solution = etalon_math::solve(&problem, &x, Options { iterations: ITERATIONS, ..Options::default() });
            iterations += solution.iterations;
            values = problem.all(&solution.x);
            if !solution.termination.is_success() {
                return Err(diagnose_failure(self, start, solution.termination));
            }
            let least = problem.noise(None).max(LEAST_NOISE_MM / problem.unit);
            let shown = problem.noise(Some(&solution)).max(least);
            let data = plain.with_weight(shown);
            let data = Residuals::new(robot, observations, &data, &free, &values)?;
            let by_nominal = problem.undetermined(&solution) > BY_NOMINAL * free.len() as f64;
            let probable = most_probable(&data, start, &solution, [least, shown], by_nominal);
            let (noise, probable) = (probable.noise, probable.scale);
            let settled = (noise / weight - 1.0).abs() < SETTLED && probable == scale;
            if settled || round == most {
                let Analysis { groups, by_nominal } = analyse(&values, noise)?;
                let now = held_by(&groups);
                if now == held || round == most {
                    let next = Prior::Tolerances { weight: noise, scale: probable };
                    let found = Identifiable { values, free, groups, by_nominal, solution, iterations, weight, prior };
                    return Ok((found, next));
                }
                held = now;
            }
            (weight, scale) = (noise, probable);
        }
        unreachable!("the last round returns")
    }

    /// Solves with redundant and useless parameters held, until the same parameters are redundant
    /// at the solution; `held` is a first guess of them.
    fn rounds(&self, start: Vec<f64>, held: Option<Vec<usize>>) -> Result<Identifiable> {
        let Self { robot, observations, settings, .. } = *self;
        let mut values = start.clone();
        let mut iterations = 0;
        let mut wanted = self.wanted.to_vec();
        // what a solution showed to be useless stays held: at nominal it may look better than it is
        let mut useless: Vec<Group> = Vec::new();
        let mut held = match held {
            Some(held) => held,
            None => {
                let near = self.anchored(&values)?;
                values = near.0;
                useless = near.1.iter().filter(|g| g.useless_uncertainty.is_some()).cloned().collect();
                held_by(&near.1)
            }
        };
        for _round in 0..ROUNDS {
            let free = without(&wanted, &held);
            if free.is_empty() {
                return Err(nothing_left(robot, observations, settings, &start));
            }
            hold(robot, &held, &start, &mut values);
            let problem = Residuals::new(robot, observations, settings, &free, &values)?;
            let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
            let solution = etalon_math::solve(&problem, &x, Options { iterations: ITERATIONS, ..Options::default() });
            iterations += solution.iterations;
            values = problem.all(&solution.x);
            if !solution.termination.is_success() {
                return Err(diagnose_failure(self, &start, solution.termination));
            }
            wanted.retain(|&i| useless.iter().all(|g| g.held != i));
            let all = problem.with_free_parameters(settings, &by_rank(robot, &wanted), &values)?;
            let (new, redundant): (Vec<Group>, Vec<Group>) = Analysis::at(&all, &values, all.noise(Some(&solution)))
                .groups
                .into_iter()
                .partition(|g| g.useless_uncertainty.is_some());
            useless.extend(new);
            let groups = [useless.clone(), redundant].concat();
            let now = held_by(&groups);
            if now == held {
                return Ok(Identifiable {
                    values,
                    free,
                    groups,
                    by_nominal: Vec::new(),
                    solution,
                    iterations,
                    weight: 1.0,
                    prior: settings.prior,
                });
            }
            held = now;
        }
        Err(Error::Unsteady)
    }

    /// A first solution near the start, and the parameters to hold there. Each parameter has its
    /// useful uncertainty as prior uncertainty, so undetermined parameters keep their values
    /// instead of diverging.
    fn anchored(&self, start: &[f64]) -> Result<(Vec<f64>, Vec<Group>)> {
        let Self { robot, observations, settings, wanted } = *self;
        let all = Residuals::new(robot, observations, settings, &by_rank(robot, wanted), start)?;
        let analysis = Analysis::at(&all, start, 0.0);
        let free = without(wanted, &held_by(&analysis.groups));
        if free.is_empty() {
            return Err(nothing_left(robot, observations, settings, start));
        }
        let residuals = all.with_free_parameters(settings, &free, start)?;
        let x: Vec<f64> = free.iter().map(|&i| start[i]).collect();
        let weight = |&i: &usize| ANCHOR_MM / residuals.unit / robot.parameters()[i].known_within();
        let prior = |(parameter, i)| etalon_math::ParameterPrior { parameter, value: x[parameter], weight: weight(i) };
        let priors: Vec<etalon_math::ParameterPrior> = free.iter().enumerate().map(prior).collect();
        let solution =
            etalon_math::solve(&WithPriors::new(&residuals, &priors), &x, Options { step: 1e-3, ..Options::default() });
        if !solution.termination.is_success() {
            return Ok((start.to_vec(), analysis.groups));
        }
        let values = residuals.all(&solution.x);
        let noise = all.noise(Some(&solution));
        Ok((values.clone(), Analysis::at(&all, &values, noise).groups))
    }
}

/// Sets held parameters to their nominal values. Base and targets of an arm have none and keep the
/// values of `start`.
fn hold(robot: &dyn Robot, held: &[usize], start: &[f64], values: &mut [f64]) {
    for &i in held {
        let p = &robot.parameters()[i];
        values[i] = if p.tolerance.is_finite() { p.nominal } else { start[i] };
    }
}

/// Parameters of an arm in the order in which they absorb inseparable effects: fixtures and
/// mountings, which come last in its list, before its own.
fn by_rank(robot: &dyn Robot, wanted: &[usize]) -> Vec<usize> {
    let mut order = wanted.to_vec();
    if robot.free_base().is_some() {
        order.sort_by_key(|&i| robot.parameters()[i].role == Role::Robot);
    }
    order
}

fn without(wanted: &[usize], held: &[usize]) -> Vec<usize> {
    wanted.iter().copied().filter(|i| !held.contains(i)).collect()
}

/// Parameters that `groups` hold, in the model's order.
fn held_by(groups: &[Group]) -> Vec<usize> {
    let mut held: Vec<usize> = groups.iter().map(|g| g.held).collect();
    held.sort_unstable();
    held
}
