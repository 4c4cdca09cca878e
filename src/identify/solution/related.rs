//! Slips of joints in campaigns of conditions alone, such as contacts and distances between two
//! hands: no position is measured, so slips are judged by the residuals of the conditions.

use crate::judgement::chi_square::exceeds;
use crate::warning::{Origin, SetUpError};
use crate::{Identification, NestedFit, Settings, fit_frames};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_robots::{Parameter, Robot, Role};
use rayon::prelude::*;

/// Number of changes that are fitted with all parameters: those that bring the nominal robot
/// nearest.
const FITS: usize = 6;
/// Maximum sum of squares of the nominal robot with a change that is fitted with all parameters:
/// relative to the sum without a change, and to that of the best change.
const NEARER: [f64; 2] = [0.25, 9.0];
/// Maximum number of named changes.
const NAMED: usize = 3;

/// The reversed joint or the exchanged pair of joints that explains the conditions by a robot near
/// its nominal values; `None` if they are explained so without a change, or by no change.
pub fn condition_slip(robot: &dyn Robot, settings: &Settings, found: &Identification) -> Option<SetUpError> {
    let stated = found.residuals.chi_square?;
    if !exceeds(stated, found.residuals.degrees_of_freedom) && is_near_nominal(robot, &found.values) {
        return None;
    }
    let rows: usize = settings.conditions.iter().map(|c| c.kind.rows()).sum();
    let mm = |squares: f64| settings.coordinate_uncertainty_mm() * (squares / rows as f64).sqrt();
    let of = |start: &[f64], settings: &Settings| -> f64 {
        settings.conditions.iter().map(|c| c.error(robot, start).iter().map(|v| v * v).sum::<f64>()).sum()
    };
    let unchanged = fit_frames(robot, &[], settings).map_or(f64::INFINITY, |start| of(&start, settings));
    let nearest = |(what, settings): (Phrase, Settings)| {
        let start = fit_frames(robot, &[], &settings).ok()?;
        let left = of(&start, &settings);
        Some((left, what, settings, start)).filter(|near| near.0.is_finite())
    };
    let mut near: Vec<(f64, Phrase, Settings, Vec<f64>)> =
        changes(robot, settings).into_par_iter().filter_map(nearest).collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    let best = near.first()?.0;
    near.retain(|near| near.0 < NEARER[0] * unchanged && near.0 <= NEARER[1] * best);
    near.truncate(FITS);
    let explains = |(_, what, settings, start): (f64, Phrase, Settings, Vec<f64>)| {
        let fit = NestedFit::new(robot, &[], &settings, &start).ok()?;
        let explains = !exceeds(fit.squares, fit.degrees_of_freedom.round() as usize);
        // where no length is measured, links of length zero close any loop
        let explains = explains && is_near_nominal(robot, &fit.values);
        explains.then_some((fit.squares, what))
    };
    let mut all: Vec<(f64, Phrase)> = near.into_par_iter().filter_map(explains).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let changed_mm = mm(all.first()?.0);
    let changes = all.into_iter().take(NAMED).map(|(_, what)| (what, Origin::Named)).collect();
    Some(SetUpError { changes, stated_mm: mm(stated), changed_mm })
}

/// `true` if no parameter of the robot is farther from its nominal value than its tolerance.
fn is_near_nominal(robot: &dyn Robot, values: &[f64]) -> bool {
    let near = |(p, v): (&Parameter, &f64)| p.role != Role::Robot || (v - p.nominal).abs() <= p.tolerance;
    robot.parameters().iter().zip(values).all(near)
}

/// Conditions with one joint reversed, or two exchanged, and the change.
fn changes(robot: &dyn Robot, settings: &Settings) -> Vec<(Phrase, Settings)> {
    let joints = robot.joints();
    let name = |i: usize| format!("`{}`", joints[i].name);
    let mut all = Vec::new();
    let mut change = |what: Phrase, how: &dyn Fn(&mut [f64])| {
        let mut changed = settings.clone();
        changed.conditions.iter_mut().for_each(|c| how(&mut c.joints));
        all.push((what, changed));
    };
    for i in 0..joints.len() {
        change(phrase!("slip-reversed", joint = name(i)), &|q| q[i] = -q[i]);
        for j in i + 1..joints.len() {
            if joints[i].quantity == joints[j].quantity {
                change(phrase!("slip-exchanged", first = name(i), second = name(j)), &|q| q.swap(i, j));
            }
        }
    }
    all
}
