//! Starting values: a tracker stands anywhere, so base and targets of a serial arm are found, not assumed.
//!
//! With the rotation of the base given, positions are linear in the rest: 24 rotations of a cube are tried in closed
//! form, the best few refined on a subset of the poses, and the best of those taken.

use super::identifiability::Analysis;
use super::residuals::Residuals;
use super::{Observation, ResidualKind, Settings};
use crate::message::{Message, Result};
use crate::pose::{Pose, centroid, minus, norm};
use crate::robots::{Robot, Role, Serial};
use crate::solve::{self, Factor, Options};
use std::f64::consts::{FRAC_PI_2, TAU};

const SUBSET: usize = 24;
const REFINED: usize = 4;
/// Share of the spread of the measurements that the nominal robot must explain: robots are wrong by millimetres.
const UNEXPLAINED: f64 = 0.1;

/// Starting values of all parameters: nominal, for serial arms with base and targets found from the observations.
/// Those not in `wanted` keep their nominal values.
pub(super) fn start(robot: &dyn Robot, observations: &[Observation], wanted: &[usize]) -> Result<Vec<f64>> {
    let nominal = robot.nominal();
    let Some(serial) = robot.serial() else { return Ok(nominal) };
    let places: Vec<usize> = (0..nominal.len()).filter(|&i| robot.parameters()[i].role != Role::Robot).collect();
    // the robot file states where base and targets are, or the user holds some of them
    if places.iter().any(|&i| nominal[i] != 0.0 || !wanted.contains(&i)) {
        return Ok(nominal);
    }
    let step = observations.len().div_ceil(SUBSET);
    let subset: Vec<Observation> = observations.iter().step_by(step).cloned().collect();
    let mut candidates: Vec<(f64, Vec<f64>)> =
        cube_rotations().iter().filter_map(|base| linear_start(serial, &subset, &nominal, base)).collect();
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    let settings = Settings { kind: ResidualKind::Targets, standard_uncertainty_mm: None, hold: Vec::new() };
    let mut best: Option<(f64, Vec<f64>)> = None;
    for (_, values) in candidates.into_iter().take(REFINED) {
        let all = Residuals::new(robot, &subset, &settings, &places, &values)?;
        let held = Analysis::at(&all, &values).held();
        let free: Vec<usize> = places.iter().copied().filter(|i| !held.contains(i)).collect();
        let problem = Residuals::new(robot, &subset, &settings, &free, &values)?;
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let solution = solve::solve(&problem, &x, Options { step: 1e-6, ..Options::default() });
        if solution.termination.is_success() && best.as_ref().is_none_or(|b| solution.cost() < b.0) {
            best = Some((solution.cost(), problem.all(&solution.x)));
            // a wrong minimum is off by much of the arm's reach, the right one by the robot's errors
            let rms_mm = (solution.cost() / solution.residuals.len() as f64).sqrt();
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
    for angle in &mut values[3..6] {
        *angle -= (*angle / TAU).round() * TAU;
    }
    if (values[4].abs() - FRAC_PI_2).abs() < 0.1 {
        return Err(Message::error(
            "the base stands with its x axis upright in the world: base_rx and base_rz turn about the same axis",
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

/// The 24 rotations that bring a cube to itself.
fn cube_rotations() -> Vec<Pose> {
    let mut all = Vec::new();
    for up in 0..6 {
        let tilted = match up {
            0..4 => Pose::identity().turn_x(f64::from(up) * FRAC_PI_2),
            _ => Pose::identity().turn_y(if up == 4 { FRAC_PI_2 } else { -FRAC_PI_2 }),
        };
        all.extend((0..4).map(|k| tilted.turn_z(f64::from(k) * FRAC_PI_2)));
    }
    all
}

/// With `base` as rotation of the base: R_bᵀ p = c + R_i r_k + t_i is linear in c and the targets r_k.
fn linear_start(serial: &Serial, subset: &[Observation], nominal: &[f64], base: &Pose) -> Option<(f64, Vec<f64>)> {
    let world_T_turned = Pose::identity().turn_y(serial.base_turn_y_rad());
    let columns = 3 + 3 * serial.targets().len();
    let (mut a, mut b) = (Vec::new(), Vec::new());
    let back = world_T_turned.then(base).inverse();
    for o in subset {
        let base_T_flange = world_T_turned.inverse().then(&serial.direct(nominal, &o.joints));
        for (k, measured) in o.targets.iter().enumerate() {
            let Some(measured) = measured else { continue };
            let p_base = back.rotate(*measured);
            for (i, p) in p_base.iter().enumerate() {
                let mut row = vec![0.0; columns];
                row[i] = 1.0;
                row[3 + 3 * k..][..3].copy_from_slice(&base_T_flange.rotation[i]);
                a.extend(row);
                b.push(p - base_T_flange.translation_mm[i]);
            }
        }
    }
    let factor = Factor::new(&a, &b, &vec![1.0; columns]);
    // where base and targets cannot be told apart, the shortest solution
    let x = factor.damped(1e-6).solve()?;
    let mut values = nominal.to_vec();
    values[..3].copy_from_slice(&world_T_turned.then(base).rotate([x[0], x[1], x[2]]));
    values[3..6].copy_from_slice(&base.rpy_rad());
    values[6..3 + columns].copy_from_slice(&x[3..]);
    Some((factor.rest, values))
}
