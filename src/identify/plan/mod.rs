//! Choice of poses to measure: observability indices, choice among candidates, and a bound on the
//! best choice.
//!
//! Maximise a [`Criterion`] of the information JᵀJ over all sets of N candidates. [`search`] finds
//! good sets, [`bound`] proves how far they are from the best at most.

pub mod bound;
pub mod candidates;
pub mod criterion;
mod effort;
pub mod generate;
pub mod obstacles;
pub mod order;
pub mod packed;
pub mod search;
mod study;

pub use criterion::{Criterion, Pool};
pub use search::Choice;
pub use study::{PlaceError, Setting, SizeStudy, reference_point, study};

use crate::Result;
use crate::{Observation, Prediction, Sensitivity, Settings, predict, sensitivity};
use effort::{Searched, search};
use etalon_base::error;
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::mean;
use etalon_robots::Robot;
use rayon::prelude::*;
use search::greedy;

/// Request for a plan: size and effort.
#[derive(Clone, Debug)]
pub struct Request {
    /// Number of candidates to choose.
    pub positions: usize,
    /// Criterion of the choice.
    pub criterion: Criterion,
    /// `true` if every configuration is a separate candidate, instead of all of a pose together.
    pub single: bool,
    /// Numbers of the poses from which the procedure of the thesis starts; empty: two poses that
    /// are far apart.
    pub start: Vec<PoseName>,
    /// Random starts of the exchange; `None`: as many as the problem deserves.
    pub starts: Option<u64>,
    /// Seed of the random starts.
    pub seed: u64,
    /// Maximum number of nodes in branch and bound; `None`: as many as the problem deserves.
    pub nodes: Option<usize>,
}

/// One step of the thesis' procedure, for the curve of figure 4.6.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Candidates chosen so far.
    pub positions: usize,
    /// Configurations of these candidates.
    pub configurations: usize,
    /// The index.
    pub index: f64,
    /// Condition number with scaled columns.
    pub condition: f64,
}

/// Result of the choice.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Configurations of each candidate, as indices of the given observations.
    pub members: Vec<Vec<usize>>,
    /// Sensitivity of the candidates.
    pub sensitivity: Sensitivity,
    /// The choice of the thesis' procedure.
    pub greedy: Vec<usize>,
    /// Its index.
    pub greedy_index: f64,
    /// The best choice found, in ascending order.
    pub chosen: Vec<usize>,
    /// Its index.
    pub index: f64,
    /// Upper bound of the index over all choices; `None` if no bound is known.
    pub bound: Option<f64>,
    /// Bound of the relaxation alone.
    pub relaxation_bound: Option<f64>,
    /// Number of nodes examined by branch and bound.
    pub nodes: usize,
    /// Index and condition number after each step of the thesis' procedure.
    pub curve: Vec<Step>,
    /// Predicted result of an identification from the chosen poses.
    pub prediction: Prediction,
    /// Standard uncertainty of position from the parameters over all candidates: root mean square
    /// and largest, in units of the given uncertainty (or of 1 mm).
    pub workspace: (f64, f64),
}

impl Plan {
    /// Maximum shortfall (%) of the choice against the best possible.
    pub fn at_most_below_percent(&self) -> Option<f64> {
        self.bound.map(|bound| (100.0 * (1.0 - self.index / bound)).max(0.0))
    }

    /// The position of the curve's knee: farthest above the line from its first to its last step
    /// (Satopää et al. 2011).
    pub fn knee(&self) -> Option<Step> {
        let (first, last) = (self.curve.first()?, self.curve.last()?);
        let above = |s: &Step| {
            let along = (s.configurations - first.configurations) as f64
                / (last.configurations - first.configurations).max(1) as f64;
            s.index - first.index - along * (last.index - first.index)
        };
        self.curve.iter().copied().max_by(|a, b| above(a).total_cmp(&above(b)))
    }
}

/// Chooses among the configurations `observations` (see `configurations`). `progress` is called
/// with the number of completed steps and their maximum.
///
/// # Examples
///
/// ```
/// use etalon_identify::{Observation, Settings, plan::{Criterion, Request, plan}};
/// use etalon_robots::{Prexyt, Robot};
///
/// // the gain of carriage 2 alone is free: it shows most where the carriage is farthest from zero
/// let (robot, criterion) = (Prexyt::default(), Criterion::D);
/// let candidates = [300.0, 0.0, 100.0, 200.0].map(|rho2| {
///     let (joints, targets) = (vec![85.0, rho2, rho2], vec![Some([0.0; 3]); 2]); // mm
///     Observation { pose: (rho2 as i64).into(), joints, targets, ..Observation::default() }
/// });
/// let names = robot.parameters().iter().map(|p| p.name.clone()).filter(|n| n != "delta2");
/// let settings = Settings { hold: names.collect(), ..Settings::default() };
/// let (single, start, starts, seed, nodes) = (false, vec![], None, 1, None);
/// let request = Request { positions: 2, criterion, single, start, starts, seed, nodes };
/// let plan = plan(&robot, &candidates, &settings, &request, &|_, _| {})?;
/// assert_eq!(plan.chosen, [0, 3]);
/// assert_eq!(plan.at_most_below_percent(), Some(0.0), "proven: no choice is better");
/// # Ok::<(), etalon_identify::Error>(())
/// ```
pub fn plan(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    request: &Request,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Plan> {
    let known = sensitivity(robot, observations, settings)?;
    let members = group(observations, request.single);
    if request.positions == 0 || request.positions > members.len() {
        let (positions, candidates) = (request.positions, members.len());
        return Err(error!("too-many-positions", positions, candidates).into());
    }
    let pool = candidate_pool(&known, &members, request.criterion);
    let begin = begin(robot, observations, &members, request)?;
    let longest = (2 * request.positions).max(request.positions + 8).min(members.len());
    let steps = greedy(&pool, &begin, longest).chosen;
    let thesis = Choice::new(&pool, steps[..request.positions].to_vec());
    let free = greedy(&pool, &[], request.positions);
    let take = |chosen: &[usize]| -> Vec<Observation> {
        chosen.iter().flat_map(|&c| members[c].iter().map(|&k| observations[k].clone())).collect()
    };
    let first = [thesis.clone(), free];
    let check = |found: &Choice| predict(robot, &take(&found.chosen), settings, &known.free).map(|_| ());
    let Searched { best, proven } = search(&pool, &first, request, progress, check)?;
    let mut chosen = best.chosen;
    chosen.sort_unstable();
    let prediction = predict(robot, &take(&chosen), settings, &known.free)?;
    let step = |count: usize| {
        let now = Choice::new(&pool, steps[..count].to_vec());
        let condition = predict(robot, &take(&steps[..count]), settings, &known.free).ok()?.observability?.condition;
        let configurations = pool.configurations(&now.chosen);
        Some(Step { positions: count, configurations, index: request.criterion.index(&pool, now.value), condition })
    };
    let counts: Vec<usize> = (begin.len().max(1)..=steps.len()).collect();
    let curve: Vec<Option<Step>> = counts.into_par_iter().map(step).collect();
    let index = |square: f64| request.criterion.index(&pool, square);
    Ok(Plan {
        curve: curve.into_iter().flatten().collect(),
        greedy_index: index(thesis.value),
        greedy: thesis.chosen,
        index: index(best.value),
        bound: proven.as_ref().map(|p| index(p.bound)),
        relaxation_bound: proven.as_ref().map(|p| index(p.relaxation)),
        nodes: proven.as_ref().map_or(0, |p| p.nodes),
        workspace: workspace(&known, &prediction, robot.dimension()),
        chosen,
        prediction,
        members,
        sensitivity: known,
    })
}

/// The index of other poses, by their numbers; configurations that are not candidates do not count.
pub fn index_of_poses(plan: &Plan, observations: &[Observation], criterion: Criterion, poses: &[PoseName]) -> f64 {
    let pool = candidate_pool(&plan.sensitivity, &plan.members, criterion);
    let of = |m: &Vec<usize>| m.iter().any(|&k| poses.contains(&observations[k].pose));
    let chosen = (0..plan.members.len()).filter(|&c| of(&plan.members[c])).collect();
    criterion.index(&pool, Choice::new(&pool, chosen).value)
}

/// Configurations that are measured together: all of a pose, or single ones.
fn group(observations: &[Observation], single: bool) -> Vec<Vec<usize>> {
    let mut members: Vec<Vec<usize>> = Vec::new();
    for (k, o) in observations.iter().enumerate() {
        match members.last_mut() {
            Some(last) if !single && observations[last[0]].pose == o.pose => last.push(k),
            _ => members.push(vec![k]),
        }
    }
    members
}

/// Information of the candidates, with columns scaled for the criterion.
pub fn candidate_pool(known: &Sensitivity, members: &[Vec<usize>], criterion: Criterion) -> Pool {
    let m = known.free.len();
    let mut first = vec![0];
    first.extend(known.rows.iter().scan(0, |sum, rows| {
        *sum += rows;
        Some(*sum)
    }));
    let block = |of: &Vec<usize>| {
        let rows = of.iter().flat_map(|&k| &known.jacobian[first[k] * m..first[k + 1] * m]).copied().collect();
        (rows, of.len())
    };
    let scale = if criterion.scales_columns() { etalon_math::column_norms(&known.jacobian, m) } else { vec![1.0; m] };
    Pool::new(&members.iter().map(block).collect::<Vec<_>>(), scale, criterion)
}

/// Start of the thesis' procedure: the given poses, or the two farthest apart of the poses with
/// most solutions.
fn begin(
    robot: &dyn Robot,
    observations: &[Observation],
    members: &[Vec<usize>],
    request: &Request,
) -> Result<Vec<usize>> {
    let pose = |c: usize| observations[members[c][0]].pose;
    if !request.start.is_empty() {
        if let Some(unknown) = request.start.iter().find(|p| (0..members.len()).all(|c| pose(c) != **p)) {
            return Err(error!("start-pose-unknown", pose = *unknown).into());
        }
        let begin: Vec<usize> = (0..members.len()).filter(|&c| request.start.contains(&pose(c))).collect();
        if begin.len() > request.positions {
            return Err(error!("start-too-large", start = begin.len(), positions = request.positions).into());
        }
        return Ok(begin);
    }
    if request.single || request.positions < 2 {
        return Ok(Vec::new());
    }
    let nominal = robot.nominal();
    let most = members.iter().map(Vec::len).max().unwrap_or(0);
    let full: Vec<usize> = (0..members.len()).filter(|&c| members[c].len() == most).collect();
    let place = |c: usize| robot.position(&nominal, &observations[members[c][0]].joints, 0);
    let places: Vec<_> = full.iter().map(|&c| place(c)).collect();
    let apart = |(i, j): (usize, usize)| etalon_base::pose::norm(etalon_base::pose::minus(places[i], places[j]));
    let pairs = (0..full.len()).flat_map(|i| (i + 1..full.len()).map(move |j| (i, j)));
    let farthest = pairs.fold(None, |best: Option<((usize, usize), f64)>, pair| match best {
        Some((_, distance)) if apart(pair) <= distance => best,
        _ => Some((pair, apart(pair))),
    });
    Ok(farthest.map_or(Vec::new(), |((i, j), _)| vec![full[i], full[j]]))
}

/// Standard uncertainty of position over all candidates: root mean square and largest.
fn workspace(known: &Sensitivity, prediction: &Prediction, dimension: usize) -> (f64, f64) {
    let m = known.free.len();
    let variance = |row: &[f64]| -> f64 {
        (0..m).map(|i| row[i] * (0..m).map(|j| prediction.covariance[i * m + j] * row[j]).sum::<f64>()).sum()
    };
    let squares: Vec<f64> =
        known.jacobian.chunks_exact(dimension * m).map(|p| p.chunks_exact(m).map(variance).sum()).collect();
    (mean(squares.iter().copied()).sqrt(), squares.iter().fold(0.0f64, |w, s| w.max(*s)).sqrt())
}
