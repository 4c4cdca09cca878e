//! Base and targets of an arm at unknown positions.
//!
//! With the rotation of the base given, positions are linear in the rest: 24 rotations of a cube,
//! and the nominal one, are tried in closed form, the best few refined on a subset of the poses,
//! and the best of those taken.

use crate::Result;
use crate::judgement::robust::CAUCHY;
use crate::model::effects::Effects;
use crate::model::prior::{DIFFUSE, Prior};
use crate::model::residuals::Residuals;
use crate::solution::identifiability::Analysis;
use crate::{Observation, ResidualKind, Settings};
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector, centroid, cross, minus, norm, turning_axes};
use etalon_math::statistics::{median, rms};
use etalon_math::{Factor, Loss, Options, ParameterPrior, Problem, Solution, Termination, WithPriors};
use etalon_robots::{FreeBase, Quantity, Robot, base_pose};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::FRAC_PI_2;

const REFINED: usize = 4;
/// Share of the spread of the measurements below which the solution of a placement is the right
/// minimum.
const RIGHT_MINIMUM: f64 = 0.01;
/// Distance from base and targets, in medians of all distances, beyond which a sighting may be
/// wrong: the largest of a thousand normal errors in space is 3.3 medians away.
const GROSS: f64 = 5.0;
/// Number of poses up to which one wrong pose makes all others as far, by least squares.
const MASKED: usize = 12;
/// Number of draws of poses, and minimum number of poses of a draw: a draw is without a wrong pose
/// in 13 % of all cases if 40 % of the poses are wrong.
const DRAWS: usize = 40;
const FEWEST_DRAWN: usize = 4;
const DRAWS_STREAM: u64 = 23;
/// Number of M-estimates, each with the scale of the previous one.
const M_STEPS: usize = 4;
/// Standard deviation of a coordinate over the median distance in space (Maxwell distribution).
const OF_DISTANCE: f64 = 0.65;
const STEPS: Options = Options { iterations: 50, step: 1e-6, gradient: 1e-15, loss: Loss::Squares };
/// Share of the sightings, the nearest ones, that show how far the nominal robot is off.
const MOST: f64 = 0.8;
/// Number of targets that is sufficient to find the base.
pub(crate) const MOST_TARGETS: usize = 12;
/// Share of the spread of the measurements that the nominal robot must explain: errors of robots
/// are millimetres.
pub(crate) const UNEXPLAINED: f64 = 0.1;
/// Coordinates of targets, unweighted.
pub(crate) static PLAIN: Settings = Settings {
    kind: ResidualKind::Targets,
    standard_uncertainty_mm: None,
    common_uncertainty_mm: None,
    hold: Vec::new(),
    rigid: Vec::new(),
    conditions: Vec::new(),
    known: Vec::new(),
    prior: Prior::None,
    effects: Effects::All,
    series: Vec::new(),
};

/// At most `count` of the observations, spread over all.
pub(crate) fn spread_over(observations: &[Observation], count: usize) -> Vec<Observation> {
    observations.iter().step_by(observations.len().div_ceil(count).max(1)).cloned().collect()
}

/// Base and targets that explain observations best, and the residual.
pub(crate) struct Placed {
    /// Root mean square (mm) of the distances of most readings: of the nearest 80 %.
    pub left_mm: f64,
    /// All parameters.
    pub values: Vec<f64>,
}

/// Base and targets (the parameters `places`) of an arm whose other parameters are `nominal`;
/// `None` if no solution is found.
///
/// Of many targets a few, those with the most readings, show where the base is.
pub(crate) fn place(
    robot: &dyn Robot,
    arm: &dyn FreeBase,
    observations: &[Observation],
    nominal: &[f64],
    places: &[usize],
) -> Result<Option<Placed>> {
    let few = with_few_targets(robot, observations);
    let shown = few.as_ref().map_or(observations, |few| &few.0);
    // the place of a target without a reading is not sought
    let parameters: BTreeSet<usize> = measured_parameters(robot, shown).into_iter().collect();
    let places: Vec<usize> = places.iter().copied().filter(|i| parameters.contains(i)).collect();
    let mut placed = place_all(robot, arm, shown, nominal, &places)?;
    if let (Some(placed), Some((_, others))) = (&mut placed, &few) {
        place_targets(arm, observations, others, &mut placed.values);
    }
    Ok(placed)
}

/// Observations of the [`MOST_TARGETS`] targets with the most readings, and the other targets;
/// `None` if there are no others.
pub(crate) fn with_few_targets(
    robot: &dyn Robot,
    observations: &[Observation],
) -> Option<(Vec<Observation>, BTreeSet<usize>)> {
    let mut targets = readings(robot, observations);
    if targets.len() <= MOST_TARGETS {
        return None;
    }
    targets.sort_by_key(|(_, readings)| std::cmp::Reverse(*readings));
    let others: BTreeSet<usize> = targets.split_off(MOST_TARGETS).into_iter().map(|t| t.0).collect();
    let mut few = observations.to_vec();
    for o in &mut few {
        others.iter().for_each(|&k| o.targets[k] = None);
    }
    Some((few, others))
}

/// Indices of all parameters without the places of targets that have no reading.
pub(crate) fn measured_parameters(robot: &dyn Robot, observations: &[Observation]) -> Vec<usize> {
    let mut hidden: BTreeSet<usize> = BTreeSet::new();
    if let Some(arm) = robot.free_base() {
        hidden.extend((0..robot.targets().len()).flat_map(|k| target_parameters(arm, k)));
        for (k, _) in readings(robot, observations) {
            target_parameters(arm, k).for_each(|i| _ = hidden.remove(&i));
        }
    }
    (0..robot.parameters().len()).filter(|i| !hidden.contains(i)).collect()
}

/// Indices of the three coordinates of a target among the parameters.
fn target_parameters(arm: &dyn FreeBase, target: usize) -> std::ops::Range<usize> {
    let first = arm.target_place(target);
    first..first + 3
}

/// Targets with at least one reading, and the number of readings of each.
pub(crate) fn readings(robot: &dyn Robot, observations: &[Observation]) -> Vec<(usize, usize)> {
    let mut readings = vec![0; robot.targets().len()];
    for o in observations {
        o.targets.iter().enumerate().for_each(|(k, at)| readings[k] += usize::from(at.is_some()));
    }
    readings.into_iter().enumerate().filter(|(_, readings)| *readings > 0).collect()
}

/// Places targets on the flange at the mean position of their readings.
pub(crate) fn place_targets(
    arm: &dyn FreeBase,
    observations: &[Observation],
    targets: &BTreeSet<usize>,
    values: &mut [f64],
) {
    let mut on_flange: BTreeMap<usize, Vec<Vector>> = BTreeMap::new();
    for o in observations {
        for &k in targets {
            let in_flange = |at| arm.flange(values, &o.joints, k).inverse().apply(at);
            on_flange.entry(k).or_default().extend(o.targets[k].map(in_flange));
        }
    }
    for (k, at) in on_flange {
        if let Some(place) = centroid(&at) {
            values[arm.target_place(k)..][..3].copy_from_slice(&place);
        }
    }
}

fn place_all(
    robot: &dyn Robot,
    arm: &dyn FreeBase,
    observations: &[Observation],
    nominal: &[f64],
    places: &[usize],
) -> Result<Option<Placed>> {
    let (sightings, rough) = (Sighting::from_observations(arm, observations, nominal), Rough { robot, nominal });
    let turned = |r: &[f64; 3]| linear_start(&sightings, nominal, places, *r);
    let mut candidates: Vec<(f64, Vec<f64>)> = rotations(nominal, places).iter().filter_map(turned).collect();
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    let spread = spread_mm(observations);
    let mut best: Option<(Placed, Vec<usize>)> = None;
    for (_, mut values) in candidates.into_iter().take(REFINED) {
        let all = Residuals::new(robot, observations, &PLAIN, places, &values)?;
        let held = Analysis::at(&all, &values, 0.0).held();
        // positions are linear in the others: they follow
        let lengths = held.iter().filter(|&&i| robot.parameters()[i].quantity == Quantity::Length);
        lengths.for_each(|&i| values[i] = nominal[i]);
        let free: Vec<usize> = places.iter().copied().filter(|i| !held.contains(i)).collect();
        let problem = Placing { sightings: &sightings, free: &free, values: &values };
        if free.is_empty() {
            // base and targets are known: nothing is to be located
            best = best.or_else(|| problem.as_stated().map(|placed| (placed, free.clone())));
            continue;
        }
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let found = etalon_math::solve(&problem, &x, STEPS);
        let error_mm = (found.cost / sightings.len().max(1) as f64).sqrt();
        let solution = problem.kept_near(rough, &found.x, error_mm, Loss::Squares);
        let placed = Placed::new(&problem, &solution.x);
        let moved = solution.termination.is_success() || solution.termination == Termination::IterationLimit;
        if moved && best.as_ref().is_none_or(|(best, _)| placed.left_mm < best.left_mm) {
            // a wrong minimum is off by much of the arm's reach, the right one by the robot's
            // errors
            let is_right = placed.left_mm < RIGHT_MINIMUM * spread;
            best = Some((placed, free));
            if is_right {
                break;
            }
        }
    }
    Ok(best.map(|(placed, free)| {
        let is_explained = placed.left_mm < UNEXPLAINED * spread;
        by_most(rough, &sightings, &free, placed, is_explained)
    }))
}

/// Base and targets by most of the sightings, where some are far from them by least squares, or few
/// are not near: a high breakdown (Rousseeuw & Leroy 1987, chapter 5), from the solutions of drawn
/// poses that leave the least median distance, followed by an M-estimate.
fn by_most(rough: Rough, sightings: &[Sighting], free: &[usize], placed: Placed, is_explained: bool) -> Placed {
    let problem = Placing { sightings, free, values: &placed.values };
    let distances = problem.distances(&problem.free_values());
    let farthest = distances.iter().copied().fold(0.0, f64::max);
    let mut poses: Vec<&[Sighting]> = sightings.chunk_by(|a, b| a.observation == b.observation).collect();
    let is_masked = poses.len() <= MASKED && !is_explained;
    if free.is_empty() || median(distances).is_none_or(|typical| !is_masked && farthest <= GROSS * typical) {
        return placed;
    }
    let rows = 3 * sightings.len() / poses.len();
    let count = (free.len().div_ceil(rows) + 1).max(FEWEST_DRAWN);
    let mut noise = Noise::new(DRAWS_STREAM, 0);
    let mut best = (median(problem.distances(&problem.free_values())), placed.values.clone());
    for _ in 0..if count < poses.len() { DRAWS } else { 0 } {
        noise.shuffle(&mut poses);
        let drawn: Vec<Sighting> = poses[..count].iter().flat_map(|pose| pose.iter().cloned()).collect();
        let some = Placing { sightings: &drawn, ..problem };
        let found = etalon_math::solve(&some, &problem.free_values(), Options { iterations: 20, ..STEPS });
        let left = median(problem.distances(&found.x));
        if left.zip(best.0).is_some_and(|(left, least)| left < least) {
            best = (left, problem.all(&found.x));
        }
    }
    let mut x: Vec<f64> = free.iter().map(|&i| best.1[i]).collect();
    for _ in 0..M_STEPS {
        let scale_mm = OF_DISTANCE * median(problem.distances(&x)).unwrap_or(0.0);
        let loss = Loss::Cauchy((CAUCHY * scale_mm).max(1e-6));
        x = problem.kept_near(rough, &x, scale_mm, loss).x;
    }
    let robust = Placed::new(&problem, &x);
    if robust.left_mm < placed.left_mm { robust } else { placed }
}

/// Root mean square distance of the measured positions from their mean.
pub(crate) fn spread_mm(observations: &[Observation]) -> f64 {
    let all: Vec<_> = observations.iter().flat_map(|o| o.targets.iter().flatten().copied()).collect();
    let mean = centroid(&all).unwrap_or_default();
    rms(all.iter().map(|p| norm(minus(*p, mean))))
}

/// Candidate rotation vectors of the base: the 24 rotations that map a cube onto itself, and the
/// nominal rotation; held components keep their nominal values in all.
fn rotations(nominal: &[f64], places: &[usize]) -> Vec<[f64; 3]> {
    let held = |mut angles: [f64; 3]| {
        for (k, angle) in angles.iter_mut().enumerate().filter(|(k, _)| !places.contains(&(3 + k))) {
            *angle = nominal[3 + k];
        }
        angles
    };
    let mut all = vec![[nominal[3], nominal[4], nominal[5]]];
    for up in 0..6 {
        let tilted = match up {
            0..4 => Pose::identity().turn_x(f64::from(up) * FRAC_PI_2),
            _ => Pose::identity().turn_y(if up == 4 { FRAC_PI_2 } else { -FRAC_PI_2 }),
        };
        all.extend((0..4).map(|k| held(tilted.turn_z(f64::from(k) * FRAC_PI_2).rotation_vector_rad())));
    }
    all.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    all.dedup();
    all
}

impl Placed {
    fn new(problem: &Placing, x: &[f64]) -> Self {
        Self { left_mm: rms_of_most(problem.distances(x)), values: problem.all(x) }
    }
}

/// Returns the root mean square of the smallest 80 % of these numbers.
pub(crate) fn rms_of_most(mut all: Vec<f64>) -> f64 {
    all.sort_by(f64::total_cmp);
    let count = (MOST * all.len() as f64).ceil() as usize;
    rms(all.into_iter().take(count))
}

/// A target measured in a pose.
#[derive(Clone)]
struct Sighting {
    /// Index of its observation.
    observation: usize,
    /// The flange in the base.
    base_t_flange: Pose,
    /// Index of the first parameter of the target.
    place: usize,
    measured: Vector,
}

impl Sighting {
    /// All measured targets of an arm whose own parameters are nominal: the joint values determine
    /// the flange relative to the base.
    fn from_observations(arm: &dyn FreeBase, observations: &[Observation], nominal: &[f64]) -> Vec<Self> {
        let mut in_base = nominal.to_vec();
        in_base[..6].fill(0.0);
        let of_pose = |(observation, o): (usize, &Observation)| {
            let seen = o.targets.iter().enumerate().filter_map(|(k, at)| {
                let measured = (*at)?;
                let base_t_flange = arm.flange(&in_base, &o.joints, k);
                Some(Self { observation, base_t_flange, place: arm.target_place(k), measured })
            });
            seen.collect::<Vec<_>>()
        };
        observations.iter().enumerate().flat_map(of_pose).collect()
    }
}

/// A rough estimate of base and targets.
#[derive(Clone, Copy)]
struct Rough<'a> {
    robot: &'a dyn Robot,
    nominal: &'a [f64],
}

/// The problem of finding some of the parameters of base and targets: p = b + R(ω) (R_i r_k + t_i).
#[derive(Clone, Copy)]
struct Placing<'a> {
    sightings: &'a [Sighting],
    free: &'a [usize],
    values: &'a [f64],
}

impl Placing<'_> {
    /// All parameters with the free ones at `x`.
    fn all(&self, x: &[f64]) -> Vec<f64> {
        let mut values = self.values.to_vec();
        for (&i, &x) in self.free.iter().zip(x) {
            values[i] = x;
        }
        values
    }

    /// Residual distance of each sighting, mm.
    fn distances(&self, x: &[f64]) -> Vec<f64> {
        let mut r = vec![0.0; self.residual_count()];
        self.residuals(x, &mut r);
        r.chunks_exact(3).map(|r| norm([r[0], r[1], r[2]])).collect()
    }

    /// The free parameters as they are.
    fn free_values(&self) -> Vec<f64> {
        self.free.iter().map(|&i| self.values[i]).collect()
    }

    /// The values as they are; `None` if a residual is not finite.
    fn as_stated(&self) -> Option<Placed> {
        let placed = Placed::new(self, &[]);
        placed.left_mm.is_finite().then_some(placed)
    }

    /// Solution from `x`. Parameters that the poses hardly determine stay within a rough estimate,
    /// whereas errors of the nominal robot (`error_mm`) could move them far.
    fn kept_near(&self, rough: Rough, x: &[f64], error_mm: f64, loss: Loss) -> Solution {
        let prior = |(k, &i): (usize, &usize)| {
            let u = DIFFUSE * rough.robot.parameters()[i].known_within();
            ParameterPrior { parameter: k, value: rough.nominal[i], weight: error_mm / u }
        };
        let priors: Vec<ParameterPrior> = self.free.iter().enumerate().map(prior).collect();
        etalon_math::solve(&WithPriors::new(self, &priors), x, Options { loss, ..STEPS })
    }
}

impl Problem for Placing<'_> {
    fn residual_count(&self) -> usize {
        3 * self.sightings.len()
    }

    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        let values = self.all(x);
        let base = base_pose(&values);
        for (sighting, r) in self.sightings.iter().zip(r.chunks_exact_mut(3)) {
            let at = base.apply(sighting.base_t_flange.apply(three(&values, sighting.place)));
            r.copy_from_slice(&minus(at, sighting.measured));
        }
    }

    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        let values = self.all(x);
        let base = base_pose(&values);
        let turning = turning_axes(three(&values, 3));
        let n = self.free.len();
        for (sighting, rows) in self.sightings.iter().zip(jacobian.chunks_exact_mut(3 * n)) {
            let world_t_flange = base.then(&sighting.base_t_flange);
            let at = world_t_flange.apply(three(&values, sighting.place));
            for (column, &j) in self.free.iter().enumerate() {
                let by = match j {
                    0..3 => unit_vector(j),
                    3..6 => cross(turning[j - 3], minus(at, base.translation_mm)),
                    _ if (sighting.place..sighting.place + 3).contains(&j) => world_t_flange.axis(j - sighting.place),
                    _ => [0.0; 3],
                };
                (0..3).for_each(|i| rows[i * n + column] = by[i]);
            }
        }
    }
}

fn three(values: &[f64], first: usize) -> Vector {
    [values[first], values[first + 1], values[first + 2]]
}

fn unit_vector(axis: usize) -> Vector {
    [0, 1, 2].map(|i| f64::from(u8::from(i == axis)))
}

/// Solves for the position of the base and the targets, which are linear for a given rotation of
/// the base; those not in `places` keep their nominal values. Returns the cost and all parameters.
fn linear_start(
    sightings: &[Sighting],
    nominal: &[f64],
    places: &[usize],
    angles: [f64; 3],
) -> Option<(f64, Vec<f64>)> {
    let mut values = nominal.to_vec();
    values[3..6].copy_from_slice(&angles);
    let free: Vec<usize> = places.iter().copied().filter(|i| !(3..6).contains(i)).collect();
    free.iter().for_each(|&i| values[i] = 0.0);
    let problem = Placing { sightings, free: &free, values: &values };
    let (m, origin) = (problem.residual_count(), vec![0.0; free.len()]);
    let (mut a, mut b) = (vec![0.0; m * free.len()], vec![0.0; m]);
    problem.residuals(&origin, &mut b);
    if free.is_empty() {
        return Some((b.iter().map(|r| r * r).sum(), values));
    }
    problem.jacobian(&origin, &mut a);
    b.iter_mut().for_each(|r| *r = -*r);
    let factor = Factor::new(&a, &b, &vec![1.0; free.len()]);
    // where base and targets are not separable, the shortest solution
    for (&j, x) in free.iter().zip(factor.damped(1e-6).solve()?) {
        values[j] = x;
    }
    Some((factor.rest, values))
}
