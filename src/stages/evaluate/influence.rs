//! Effect of each identified parameter of a robot at the measured points: displacement of the point
//! that moves most, with everything else unchanged.

use crate::stages::evaluate::errors::PointErrors;
use crate::stages::evaluate::sets::Sets;
use etalon_base::pose::{minus, norm};
use etalon_documents::{ParameterEntry, ParameterInfluence, ParameterStatus, ParametersDocument, Role};
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
    let errors = PointErrors::new(robot, sets);
    let after = errors.with(values);
    let of = |(i, entry): (usize, &ParameterEntry)| {
        let definition = robot.parameters().get(i)?;
        let change = values[i] - definition.nominal;
        let step = if change == 0.0 { STEP } else { change };
        let mut without = values.to_vec();
        without[i] -= step;
        let before = errors.with(&without).into_iter().zip(&after);
        let moved = before.map(|((pose, before), (_, after))| (pose, norm(minus(before, *after))));
        let worst = moved.filter(|(_, moved)| moved.is_finite()).max_by(|a, b| a.1.total_cmp(&b.1))?;
        // displacement by a unit of the document
        let unit_mm = worst.1 / definition.quantity.outward(step).abs();
        Some(ParameterInfluence {
            name: entry.name.clone(),
            pose: worst.0,
            change_mm: definition.quantity.outward(change) * unit_mm,
            standard_uncertainty_mm: entry.standard_uncertainty.map(|u| u * unit_mm),
            tolerance_mm: entry.tolerance.map(|t| t * unit_mm),
        })
        .filter(|found| found.change_mm.is_finite())
    };
    let mut all: Vec<_> = identified.filter_map(of).collect();
    all.sort_by(|a, b| b.change_mm.abs().total_cmp(&a.change_mm.abs()));
    all
}
