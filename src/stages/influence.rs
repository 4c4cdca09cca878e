//! Effect of each identified parameter of a robot at the measured points: displacement of the point
//! that moves most, with everything else unchanged.

use crate::stages::evaluate::{self, Sets};
use etalon_base::pose::{minus, norm};
use etalon_documents::{ParameterEntry, ParameterInfluence, ParameterStatus, ParametersDocument, PointError, Role};
use etalon_robots::Robot;

/// Step of a parameter that has not changed, in its internal unit.
const STEP: f64 = 1e-4;

/// Influence of every identified parameter of the robot, the largest change first.
pub fn influences(
    robot: &dyn Robot,
    sets: &Sets,
    values: &[f64],
    document: &ParametersDocument,
) -> Vec<ParameterInfluence> {
    let entries = document.parameters.iter().enumerate();
    let identified = entries.filter(|(_, p)| p.role == Role::Robot && p.status == ParameterStatus::Identified);
    let mut all: Vec<_> = identified.filter_map(|(i, p)| influence(robot, sets, values, (i, p))).collect();
    all.sort_by(|a, b| b.change_mm.abs().total_cmp(&a.change_mm.abs()));
    all
}

fn influence(
    robot: &dyn Robot,
    sets: &Sets,
    values: &[f64],
    (i, entry): (usize, &ParameterEntry),
) -> Option<ParameterInfluence> {
    let definition = robot.parameters().get(i)?;
    let change = values[i] - definition.nominal;
    let step = if change == 0.0 { STEP } else { change };
    let mut without = values.to_vec();
    without[i] -= step;
    let moved = |e: &PointError| norm(minus(e.before_mm, e.after_mm));
    let errors = evaluate::errors(robot, sets, &without, values);
    let worst = errors.iter().filter(|e| moved(e).is_finite()).max_by(|a, b| moved(a).total_cmp(&moved(b)))?;
    // displacement by a unit of the document
    let unit_mm = moved(worst) / definition.quantity.outward(step).abs();
    Some(ParameterInfluence {
        name: entry.name.clone(),
        pose: worst.pose,
        change_mm: definition.quantity.outward(change) * unit_mm,
        standard_uncertainty_mm: entry.standard_uncertainty.map(|u| u * unit_mm),
        tolerance_mm: entry.tolerance.map(|t| t * unit_mm),
    })
    .filter(|found| found.change_mm.is_finite())
}
