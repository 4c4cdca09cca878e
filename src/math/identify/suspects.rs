//! Measurements that look mislabelled or wrong: what a fit leaves of them in which outliers pull less.

use super::residuals::Residuals;
use super::{Identification, Observation, ResidualKind, Settings, unseen_by};
use crate::base::message::Message;
use crate::base::pose::{minus, norm};
use crate::math::robots::{Robot, Role};
use crate::math::solve::{self, Loss, Options};
use std::collections::BTreeMap;

/// Measurements that are named.
const NAMED: usize = 3;
/// Constant of the Cauchy loss that costs 5 % of the precision where there are no outliers (Holland & Welsch 1977).
const CAUCHY: f64 = 2.385;
/// Root mean square of normal residuals over their median size.
const MEDIAN: f64 = 1.4826;
/// Fits, each with the scale that the one before it shows.
const FITS: usize = 12;
/// Least scale of residuals in mm: below it nothing is measured.
const LEAST_MM: f64 = 1e-6;

/// What to say of the largest residuals of a robust fit: targets and poses to look at first, where least squares `found`
/// what the instrument does not explain. `None` where no such fit is found.
pub fn suspects(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Option<Message> {
    let mut free = found.free.clone();
    free.extend(unseen_by(robot, settings.kind).filter(|i| !found.free.contains(i)));
    let values = robust(robot, observations, &free, &found.values)?;
    // the worst repeat of each target of each pose
    let mut worst: BTreeMap<(i64, usize), (f64, i64)> = BTreeMap::new();
    for o in observations {
        for (k, measured) in o.targets.iter().enumerate() {
            let Some(measured) = measured else { continue };
            let left_mm = norm(minus(*measured, robot.position(&values, &o.joints, k)));
            let entry = worst.entry((o.pose, k)).or_insert((left_mm, o.cycle));
            if left_mm > entry.0 {
                *entry = (left_mm, o.cycle);
            }
        }
    }
    let mut all: Vec<_> = worst.into_iter().collect();
    all.sort_by(|a, b| b.1.0.total_cmp(&a.1.0));
    let named: Vec<String> = all
        .iter()
        .take(NAMED)
        .map(|((pose, k), (left_mm, cycle))| {
            format!("{left_mm:.4} mm at {} of pose {pose} in cycle {cycle}", robot.targets()[*k])
        })
        .collect();
    let what = format!("a fit in which outliers pull less leaves most, {}", named.join(", "));
    let hint =
        "look there first for exchanged labels and wrong readings; errors of the robot are spread over all poses";
    Some(Message::warning(what).hint(hint))
}

/// Parameters at which the bulk of the measurements is met best: fits with the Cauchy loss, the scale of which follows
/// the median residual down, from the identified and from the nominal parameters.
fn robust(robot: &dyn Robot, observations: &[Observation], free: &[usize], found: &[f64]) -> Option<Vec<f64>> {
    let start = |values: Vec<f64>| {
        let mut best = (median_mm(robot, observations, &values)?, values);
        for _ in 0..FITS {
            let scaled = Settings {
                kind: ResidualKind::Targets,
                standard_uncertainty_mm: Some((MEDIAN * best.0).max(LEAST_MM)),
                common_uncertainty_mm: None,
                hold: Vec::new(),
            };
            let problem = Residuals::new(robot, observations, &scaled, free, &best.1).ok()?;
            let x: Vec<f64> = free.iter().map(|&i| best.1[i]).collect();
            let options = Options { iterations: 50, step: 1e-6, loss: Loss::Cauchy(CAUCHY), ..Options::default() };
            let values = problem.all(&solve::solve(&problem, &x, options).x);
            let median = median_mm(robot, observations, &values)?;
            let settled = median > 0.9 * best.0;
            if median < best.0 {
                best = (median, values);
            }
            if settled {
                break;
            }
        }
        Some(best)
    };
    let mut nominal = found.to_vec();
    for &i in free.iter().filter(|&&i| robot.parameters()[i].role == Role::Robot) {
        nominal[i] = robot.parameters()[i].nominal;
    }
    let all = [found.to_vec(), nominal].into_iter().filter_map(start);
    all.min_by(|a, b| a.0.total_cmp(&b.0)).map(|best| best.1)
}

/// Median size of the differences of coordinates, mm; `None` where one is not a number.
fn median_mm(robot: &dyn Robot, observations: &[Observation], values: &[f64]) -> Option<f64> {
    let mut sizes = Vec::new();
    for o in observations {
        for (k, measured) in o.targets.iter().enumerate() {
            let Some(measured) = measured else { continue };
            let predicted = robot.position(values, &o.joints, k);
            sizes.extend((0..robot.dimension()).map(|i| (measured[i] - predicted[i]).abs()));
        }
    }
    let middle = sizes.len() / 2;
    sizes.iter().all(|s| s.is_finite()).then(|| {
        sizes.sort_by(f64::total_cmp);
        sizes.get(middle).copied()
    })?
}
