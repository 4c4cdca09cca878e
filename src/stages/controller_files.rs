//! Controller files: what formats hold that leave identified parameters out, and the errors with it at the measured poses.

use super::evaluate::{self, summarise};
use super::identification::Identified;
use etalon_base::message::{Message, Result, Severity};
use etalon_base::pose::{Vector, norm};
use etalon_controllers::{Exporter, Given};
use etalon_documents::{
    ControllerErrors, ControllerFiles, ControllersDocument, PointError, PoseSet, PositionErrors, WrittenParameter,
};
use etalon_robots::Robot;

/// Identifies again for each of these formats that leaves identified parameters out; `None` if none does.
pub fn identify_again(
    given: &Given,
    robot: &dyn Robot,
    found: &Identified,
    formats: &[(&str, &dyn Exporter)],
) -> Option<ControllersDocument> {
    let (mut files, mut messages) = (Vec::<ControllerFiles>::new(), Vec::new());
    for &(name, exporter) in formats {
        match of_format(given, robot, found, exporter) {
            Ok(None) => {}
            Ok(Some(file)) => match files.iter_mut().find(|f| f.left_out == file.left_out && f.values == file.values) {
                Some(same) => same.formats.push(name.to_owned()),
                None => files.push(ControllerFiles { formats: vec![name.to_owned()], ..file }),
            },
            Err(problems) => messages.extend(problems.0.into_iter().map(|m| {
                let what = format!("parameters of the format `{name}` could not be identified again: {}", m.what);
                Message { what, severity: Severity::Warning, ..m }
            })),
        }
    }
    let mut document = ControllersDocument::new(files, messages)?;
    let given = Given { controllers: Some(&document), ..*given };
    let refused = formats.iter().flat_map(|&(name, exporter)| match given.statement(exporter) {
        Ok(statement) => statement.refusal(name).into_iter().collect(),
        Err(problems) => problems.0,
    });
    let refused: Vec<Message> = refused.collect();
    document.messages.extend(refused);
    Some(document)
}

/// What a format holds that leaves parameters out, or ties others; `None` if it holds what was identified.
fn of_format(
    given: &Given,
    robot: &dyn Robot,
    found: &Identified,
    exporter: &dyn Exporter,
) -> Result<Option<ControllerFiles>> {
    let left_out = given.left_out(exporter);
    // others that the data did not determine beside these may be determined without them
    let held: Vec<String> = given.not_held(exporter).collect();
    let again = if left_out.is_empty() { None } else { Some(found.without(robot, &held)?) };
    let identified = again.as_ref().unwrap_or(&found.found);
    let tied = exporter.written(given, robot, &identified.values);
    let values = if tied == identified.values { tied } else { found.with_frames(robot, &tied)? };
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
    let errors = errors(robot, found, &values);
    Ok(Some(ControllerFiles { formats: Vec::new(), left_out, values: written.collect(), errors }))
}

/// Errors with nominal, identified and these values, at calibration and validation poses.
fn errors(robot: &dyn Robot, found: &Identified, values: &[f64]) -> Vec<ControllerErrors> {
    let written = evaluate::errors(robot, &found.sets, &found.again.before, values);
    let of_set = |set: PoseSet| {
        let of = |errors: &[PointError], size: fn(&PointError) -> Vector| {
            let of_set = errors.iter().filter(|e| e.set == set);
            let statistics = summarise(of_set.map(|e| norm(size(e))).collect());
            PositionErrors { rms_mm: statistics.rms, max_mm: statistics.max }
        };
        ControllerErrors {
            set,
            nominal: of(&found.errors, |e| e.before_mm),
            identified: of(&found.errors, |e| e.after_mm),
            written: of(&written, |e| e.after_mm),
        }
    };
    let measured = |set: &PoseSet| found.errors.iter().any(|e| e.set == *set);
    PoseSet::ALL.into_iter().filter(measured).map(of_set).collect()
}
