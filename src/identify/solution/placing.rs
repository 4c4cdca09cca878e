//! Base and targets of an arm at unknown positions.
//!
//! With the rotation of the base given, positions are linear in the rest: 24 rotations of a cube,
//! and the nominal one, are tried in closed form, the best few refined on a subset of the poses,
//! and the best of those taken.

use crate::Result;
use crate::model::effects::Effects;
use crate::model::prior::{DIFFUSE, Prior};
use crate::model::residuals::Residuals;
use crate::solution::identifiability::Analysis;
use crate::{Observation, ResidualKind, Settings};
use etalon_base::pose::{Pose, Vector, centroid, cross, minus, norm, turning_axes};
use etalon_math::statistics::rms;
use etalon_math::{Factor, Options, ParameterPrior, Problem, Termination, WithPriors};
use etalon_robots::{FreeBase, Quantity, Robot, base_pose};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::FRAC_PI_2;

const REFINED: usize = 4;
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
    /// Root mean square (mm) of the residual distances.
    pub rms_mm: f64,
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
    // a target without a reading has no place to find
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
    let sightings = Sighting::from_observations(arm, observations, nominal);
    let turned = |r: &[f64; 3]| linear_start(&sightings, nominal, places, *r);
    let mut candidates: Vec<(f64, Vec<f64>)> = rotations(nominal, places).iter().filter_map(turned).collect();
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    let spread = spread_mm(observations);
    let points = observations.iter().flat_map(|o| o.targets.iter().flatten()).count().max(1) as f64;
    let mut best: Option<Placed> = None;
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
            best = best.or_else(|| problem.as_stated(points));
            continue;
        }
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let options = Options { iterations: 50, step: 1e-6, ..Options::default() };
        let found = etalon_math::solve(&problem, &x, options);
        // what the poses hardly determine stays within a rough estimate, not where errors of the
        // nominal robot carry it
        let error_mm = (found.cost / points).sqrt();
        let rough = |(k, &i): (usize, &usize)| {
            let u = DIFFUSE * robot.parameters()[i].known_within();
            ParameterPrior { parameter: k, value: nominal[i], weight: error_mm / u }
        };
        let priors: Vec<ParameterPrior> = free.iter().enumerate().map(rough).collect();
        let solution = etalon_math::solve(&WithPriors::new(&problem, &priors), &found.x, options);
        let rms_mm = (problem.squares(&solution.x) / points).sqrt();
        let moved = solution.termination.is_success() || solution.termination == Termination::IterationLimit;
        if moved && best.as_ref().is_none_or(|b| rms_mm < b.rms_mm) {
            best = Some(Placed { rms_mm, values: problem.all(&solution.x) });
            // a wrong minimum is off by much of the arm's reach, the right one by the robot's
            // errors
            if rms_mm < 0.01 * spread {
                break;
            }
        }
    }
    Ok(best)
}

/// Root mean square distance of the measured positions from their mean.
pub(crate) fn spread_mm(observations: &[Observation]) -> f64 {
    let all: Vec<_> = observations.iter().flat_map(|o| o.targets.iter().flatten().copied()).collect();
    let mean = centroid(&all).unwrap_or_default();
    rms(all.iter().map(|p| norm(minus(*p, mean))))
}

/// Candidate rotation vectors of the base: those of the 24 rotations that map a cube onto itself,
/// and the nominal one; held components keep their nominal values in all.
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

/// A target measured in a pose.
struct Sighting {
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
        let of_pose = |o: &Observation| {
            let seen = o.targets.iter().enumerate().filter_map(|(k, at)| {
                let measured = (*at)?;
                let base_t_flange = arm.flange(&in_base, &o.joints, k);
                Some(Self { base_t_flange, place: arm.target_place(k), measured })
            });
            seen.collect::<Vec<_>>()
        };
        observations.iter().flat_map(of_pose).collect()
    }
}

/// The problem of finding some of the parameters of base and targets: p = b + R(ω) (R_i r_k + t_i).
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

    /// Sum of the squared residuals.
    fn squares(&self, x: &[f64]) -> f64 {
        let mut r = vec![0.0; self.residual_count()];
        self.residuals(x, &mut r);
        r.iter().map(|v| v * v).sum()
    }

    /// Residual of the values as they are; `None` if it is not finite.
    fn as_stated(&self, points: f64) -> Option<Placed> {
        let rms_mm = (self.squares(&[]) / points).sqrt();
        rms_mm.is_finite().then(|| Placed { rms_mm, values: self.values.to_vec() })
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
