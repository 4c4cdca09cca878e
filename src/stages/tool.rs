//! The error to expect at the tool point.

use super::evaluate::{Sets, summarise};
use crate::base::message::Result;
use crate::base::pose::norm;
use crate::base::pose_name::PoseName;
use crate::document::{AccuracyDocument, Statistics, ToolAccuracy};
use crate::math::identify::{Identification, Settings, ToolFrame, ToolPoint, UncertaintyFrom, held};
use crate::math::robots::Robot;
use std::collections::BTreeSet;

/// Coverage factor of an expanded uncertainty (GUM 6.3.3).
const COVERAGE: f64 = 2.0;

/// The error that the controller will make at `point` with what was `found`, over the poses that are judged; `None` without a
/// covariance. Its variance is the sum of those of the predicted position, of parameters that the data do not
/// determine, of what the model leaves out, and of the point's place.
pub fn tool_accuracy(
    robot: &dyn Robot,
    point: &ToolPoint,
    sets: &Sets,
    settings: &Settings,
    before: &[f64],
    found: &Identification,
    accuracy: &AccuracyDocument,
) -> Result<Option<ToolAccuracy>> {
    let Some(judged) = accuracy.sets.last() else { return Ok(None) };
    let observations = if judged.name == "validation" { &sets.validation } else { &sets.calibration };
    let dimension = robot.dimension() as f64;
    // what is measured beyond the instrument's own error, where the residuals show that there is something
    let measured = judged.errors.iter().find(|e| e.quantity == "position").map_or(0.0, |e| e.after.rms);
    let instrument = dimension * settings.coordinate_uncertainty_mm().powi(2);
    let model_mm = match found.uncertainty_from {
        UncertaintyFrom::Instrument => 0.0,
        _ => (measured.powi(2) - instrument).max(0.0).sqrt(),
    };
    let place_mm = dimension.sqrt() * point.standard_uncertainty_mm;
    let held = held(robot, &sets.calibration, settings, found)?;
    let count = observations.len() as f64;
    let (mut sizes_before, mut sizes) = (Vec::new(), Vec::new());
    let (mut of_parameters, mut of_held) = (0.0, 0.0);
    for o in observations {
        let Some(error) = point.error(robot, o, before, found, &held)? else { return Ok(None) };
        sizes_before.push(norm(error.before_mm));
        sizes.push(error.parameters_mm.hypot(error.held_mm).hypot(model_mm).hypot(place_mm));
        of_parameters += error.parameters_mm.powi(2) / count;
        of_held += error.held_mm.powi(2) / count;
    }
    let after: Statistics = summarise(sizes);
    let which = match point.frame {
        ToolFrame::Platform if point.point_mm == [0.0; 3] => "the platform's centre C".to_owned(),
        ToolFrame::Platform => format!("the point {:?} mm in the frame of the platform", point.point_mm),
        ToolFrame::Flange => format!("the point {:?} mm in the frame of the flange", point.point_mm),
        ToolFrame::Targets => format!("the point {:?} mm in the frame of the targets", point.point_mm),
    };
    Ok(Some(ToolAccuracy {
        definition: format!(
            "error: the true place of {which} in the base frame minus the one that the controller computes; before: predicted with \
             nominal minus with identified parameters; after: expected size (k = 1), from the covariance of the parameters, the tolerance of those \
             that the data do not determine, what the model leaves out beyond the instrument, and the place of the point on the tool; errors of the targets do not show \
             parameters that shift targets and tool alike"
        ),
        point_mm: point.point_mm,
        frame: point.frame,
        set: judged.name.clone(),
        poses: observations.iter().map(|o| o.pose).collect::<BTreeSet<PoseName>>().len(),
        before: summarise(sizes_before),
        after,
        expanded_max_mm: COVERAGE * after.max,
        parameters_mm: of_parameters.sqrt(),
        held_mm: of_held.sqrt(),
        model_mm,
        place_mm,
    }))
}
