//! Controller files of formats that omit identified parameters: their values, and errors at the
//! measured poses.

use crate::stages::calibrate::identification::IdentifiedSolution;
use etalon_base::message::{Message, Result, Severity};
use etalon_base::phrase;
use etalon_campaign::Campaign;
use etalon_controllers::{ExportInput, Exporter, Statement};
use etalon_documents::{
    AccuracyDocument, AccuracySet, ControllerErrors, ControllerFiles, ControllersDocument, WrittenParameter,
};
use etalon_robots::Robot;

/// Identifies again for each of these formats that omits identified parameters; `None` if no format
/// does.
pub fn identify_again(
    campaign: &Campaign,
    given: &ExportInput,
    robot: &dyn Robot,
    solution: &IdentifiedSolution,
    formats: &[(&str, &dyn Exporter)],
) -> Option<ControllersDocument> {
    let (mut files, mut messages) = (Vec::<ControllerFiles>::new(), Vec::new());
    for &(name, exporter) in formats.iter().filter(|(_, exporter)| exporter.unsuited(given).is_none()) {
        match identify_for_format(campaign, given, robot, solution, exporter) {
            Ok(None) => {}
            Ok(Some(file)) => match files.iter_mut().find(|f| f.left_out == file.left_out && f.values == file.values) {
                Some(same) => same.formats.push(name.to_owned()),
                None => files.push(ControllerFiles { formats: vec![name.to_owned()], ..file }),
            },
            Err(problems) => messages.extend(problems.0.into_iter().map(|m| {
                let message = m.within(phrase!("format-not-identified", format = name));
                Message { severity: Severity::Warning, ..message }
            })),
        }
    }
    let document = ControllersDocument::new(files.clone(), messages.clone());
    messages.extend(judged(&ExportInput { controllers: document.as_ref(), ..*given }, formats));
    ControllersDocument::new(files, messages)
}

/// Errors about files that are worse than nominal, and warnings about files for other robots and
/// files that are hardly better; files with the same errors share a warning.
fn judged(given: &ExportInput, formats: &[(&str, &dyn Exporter)]) -> Vec<Message> {
    let (mut refused, mut near) = (Vec::new(), Vec::<(Statement, Vec<&str>)>::new());
    let mut concerns = Vec::new();
    for &(name, exporter) in formats {
        match given.statement(exporter) {
            Ok(statement) => match statement.refusal(name) {
                Some(refusal) => refused.push(refusal),
                None => {
                    concerns.extend(exporter.cautions(given));
                    match near.iter_mut().find(|(same, _)| same.errors == statement.errors) {
                        Some((_, names)) => names.push(name),
                        None => near.push((statement, vec![name])),
                    }
                }
            },
            Err(problems) => refused.extend(problems.0),
        }
    }
    refused.extend(concerns);
    refused.extend(near.iter().filter_map(|(statement, names)| statement.warning(names)));
    refused
}

/// Values of a format that omits or ties parameters; `None` if the format holds the identified
/// values.
fn identify_for_format(
    campaign: &Campaign,
    given: &ExportInput,
    robot: &dyn Robot,
    solution: &IdentifiedSolution,
    exporter: &dyn Exporter,
) -> Result<Option<ControllerFiles>> {
    let left_out = given.left_out(exporter);
    // others that the data did not determine beside these may be determined without them
    let held: Vec<String> = given.not_held(exporter).collect();
    let again = if left_out.is_empty() { None } else { Some(solution.without(robot, &held)?) };
    let identified = again.as_ref().unwrap_or(&solution.found);
    let tied = exporter.written(given, robot, &identified.values);
    let values = if tied == identified.values { tied } else { solution.with_frames(robot, &tied)? };
    if again.is_none() && values == identified.values {
        return Ok(None);
    }
    let written = robot.parameters().iter().enumerate().map(|(i, p)| WrittenParameter {
        name: p.name.clone(),
        unit: p.quantity.unit().to_owned(),
        value: p.quantity.outward(values[i]),
        standard_uncertainty: (values[i] == identified.values[i])
            .then(|| identified.standard_uncertainty(i).map(|u| p.quantity.outward(u)))
            .flatten(),
    });
    let accuracy = solution.accuracy_with(campaign, robot, &values)?;
    let (errors, deciding_set) = (errors(given, &accuracy), accuracy.sets.last().cloned());
    let limits = accuracy.limits;
    Ok(Some(ControllerFiles { formats: Vec::new(), left_out, values: written.collect(), errors, deciding_set, limits }))
}

/// Errors with nominal, identified and these values, at calibration and validation poses.
fn errors(given: &ExportInput, accuracy: &AccuracyDocument) -> Vec<ControllerErrors> {
    let of_set = |set: &AccuracySet| {
        let written = accuracy.sets.iter().find(|other| other.name == set.name)?;
        let leading = written.error_statistics(set.leading()?.quantity)?;
        ControllerErrors::new(set, Some(&leading.after))
    };
    given.accuracy.iter().flat_map(|accuracy| &accuracy.sets).filter_map(of_set).collect()
}
