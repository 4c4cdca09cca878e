//! Starting values: a tracker may be anywhere, so base and targets of an arm are found, not assumed.
//!
//! With the rotation of the base given, positions are linear in the rest: 24 rotations of a cube, and the nominal one,
//! are tried in closed form, the best few refined on a subset of the poses, and the best of those taken.

use super::identifiability::Analysis;
use super::residuals::Residuals;
use super::{Observation, ResidualKind, Settings};
use crate::base::message::{Message, Result};
use crate::base::pose::{Pose, centroid, minus, norm};
use crate::math::robots::{FreeBase, Robot, Role};
use crate::math::solve::{self, Factor, Options};
use std::f64::consts::FRAC_PI_2;

const SUBSET: usize = 24;
const REFINED: usize = 4;
/// Share of the spread of the measurements that the nominal robot must explain: robots are wrong by millimetres.
const UNEXPLAINED: f64 = 0.1;

/// Starting values of all parameters: nominal, for robots with a free base with those of base and targets that are `wanted` found
/// from the observations.
pub(super) fn start(robot: &dyn Robot, observations: &[Observation], wanted: &[usize]) -> Result<Vec<f64>> {
    let nominal = robot.nominal();
    let Some(arm) = robot.free_base() else { return Ok(nominal) };
    let places: Vec<usize> = wanted.iter().copied().filter(|&i| robot.parameters()[i].role != Role::Robot).collect();
    let step = observations.len().div_ceil(SUBSET);
    let subset: Vec<Observation> = observations.iter().step_by(step).cloned().collect();
    let mut candidates: Vec<(f64, Vec<f64>)> =
        rotations(&nominal, &places).iter().filter_map(|r| linear_start(arm, &subset, &nominal, &places, *r)).collect();
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    let settings = Settings {
        kind: ResidualKind::Targets,
        standard_uncertainty_mm: None,
        common_uncertainty_mm: None,
        hold: Vec::new(),
    };
    let mut best: Option<(f64, Vec<f64>)> = None;
    for (_, values) in candidates.into_iter().take(REFINED) {
        let all = Residuals::new(robot, &subset, &settings, &places, &values)?;
        let held = Analysis::at(&all, &values, 0.0).held();
        let free: Vec<usize> = places.iter().copied().filter(|i| !held.contains(i)).collect();
        let problem = Residuals::new(robot, &subset, &settings, &free, &values)?;
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let solution = solve::solve(&problem, &x, Options { step: 1e-6, ..Options::default() });
        if solution.termination.is_success() && best.as_ref().is_none_or(|b| solution.cost < b.0) {
            best = Some((solution.cost, problem.all(&solution.x)));
            // a wrong minimum is off by much of the arm's reach, the right one by the robot's errors
            let rms_mm = (solution.cost / solution.residuals.len() as f64).sqrt();
            if rms_mm < 0.01 * spread_mm(&subset) {
                break;
            }
        }
    }
    let (cost, mut values) = best.ok_or_else(|| {
        Message::error("base and targets cannot be found from these poses")
            .expected("at least four poses in which the arm moves in all directions")
            .hint("measure more poses, or state base_x .. base_rz and the targets under [nominal] in the robot file")
    })?;
    let rms_mm = (cost / (3 * subset.iter().flat_map(|o| o.targets.iter().flatten()).count()) as f64).sqrt();
    let spread = spread_mm(&subset);
    if rms_mm > UNEXPLAINED * spread {
        let what = format!(
            "no place of base and targets explains the measurements: {rms_mm:.1} mm are left of {spread:.1} mm"
        );
        return Err(Message::error(what)
            .hint("check units, order, signs and offsets of the joints, and the nominal parameters of the robot")
            .into());
    }
    // the same rotation by angles of which the middle one is at most a right angle
    if (3..6).all(|i| places.contains(&i)) {
        let turned = Pose::identity().turn_z(values[5]).turn_y(values[4]).turn_x(values[3]);
        values[3..6].copy_from_slice(&turned.rpy_rad());
    }
    if (values[4].abs() - FRAC_PI_2).abs() < 0.1 {
        return Err(Message::error(
            "the x axis of the base is upright in the world: base_rx and base_rz turn about the same axis",
        )
        .hint("set `base_turn_y_deg = 90` in the robot file: base_rx, base_ry and base_rz are then counted from there")
        .into());
    }
    Ok(values)
}

/// Root mean square distance of the measured positions from their mean.
fn spread_mm(observations: &[Observation]) -> f64 {
    let all: Vec<_> = observations.iter().flat_map(|o| o.targets.iter().flatten().copied()).collect();
    let mean = centroid(&all).unwrap_or_default();
    (all.iter().map(|p| norm(minus(*p, mean)).powi(2)).sum::<f64>() / all.len().max(1) as f64).sqrt()
}

/// Angles of the base to try: those of the 24 rotations that bring a cube to itself, and the nominal ones; held angles
/// keep their nominal values in all.
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
        all.extend((0..4).map(|k| held(tilted.turn_z(f64::from(k) * FRAC_PI_2).rpy_rad())));
    }
    all.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    all.dedup();
    all
}

/// With the rotation of the base given by its angles: p = b + R (R_i r_k + t_i) is linear in the place b of the base and
/// the targets r_k; those of them not in `places` keep their nominal values. Gives the cost and all parameters.
fn linear_start(
    arm: &dyn FreeBase,
    subset: &[Observation],
    nominal: &[f64],
    places: &[usize],
    angles: [f64; 3],
) -> Option<(f64, Vec<f64>)> {
    let mut values = nominal.to_vec();
    values[..3].fill(0.0);
    values[3..6].copy_from_slice(&angles);
    let free: Vec<usize> = places.iter().copied().filter(|i| !(3..6).contains(i)).collect();
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for o in subset {
        let flange = arm.flange(&values, &o.joints);
        for (k, measured) in o.targets.iter().enumerate() {
            let Some(measured) = measured else { continue };
            let place = arm.target_place(k);
            for (i, p) in measured.iter().enumerate() {
                let coefficient = |j: usize| match j {
                    0..3 => f64::from(u8::from(i == j)),
                    _ if (place..place + 3).contains(&j) => flange.rotation[i][j - place],
                    _ => 0.0,
                };
                let known = (0..3).chain(place..place + 3).filter(|j| !free.contains(j));
                let stated: f64 = known.map(|j| coefficient(j) * nominal[j]).sum();
                a.extend(free.iter().map(|&j| coefficient(j)));
                b.push(p - flange.translation_mm[i] - stated);
            }
        }
    }
    values[..3].copy_from_slice(&nominal[..3]);
    let factor = Factor::new(&a, &b, &vec![1.0; free.len()]);
    if !free.is_empty() {
        // where base and targets are not separable, the shortest solution
        for (&j, x) in free.iter().zip(factor.damped(1e-6).solve()?) {
            values[j] = x;
        }
    }
    Some((factor.rest, values))
}
