//! Validation: given parameters judged on the data of a campaign, without identification of the
//! robot.

use crate::stages::calibrate::selection::Selected;
use crate::stages::calibrate::solution::Basis;
use crate::stages::evaluate::accuracy::{self, ErrorUncertainty, Judged, RobotValues};
use crate::stages::evaluate::errors::{correct, point_errors};
use crate::stages::evaluate::sets::Sets;
use crate::stages::judge::set_up::check_set_up;
use crate::stages::remedies::remedied;
use crate::stages::verify::earlier_parameters::{
    PoseErrors, other_nominal, parameters_from_document, robot_values, worse_than_nominal,
};
use crate::stages::verify::expected_deviation::ExpectedDeviation;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result, Severity};
use etalon_base::pose::norm;
use etalon_base::{error, phrase, warning};
use etalon_campaign::Campaign;
use etalon_documents::{
    AccuracyDocument, FieldDocument, FieldSummary, FrameOrigin, ParameterJudgement, ParametersDocument, PointError,
};
use etalon_identify::{Comparison, Corrected, IdentifiedParameters, JointField, Settings};
use etalon_robots::{Correction, Robot, Role};

/// Errors of given parameters, and remarks for the reader.
#[derive(Clone, Debug)]
pub struct Validated {
    /// Errors before and after.
    pub accuracy: AccuracyDocument,
    /// Warnings, with remedies.
    pub messages: Vec<Message>,
}

/// Parameters that are judged.
#[derive(Clone, Copy, Debug)]
pub struct Validation<'a> {
    /// Identified parameters; `None` for nominal ones.
    pub document: Option<&'a ParametersDocument>,
    /// Residual field that belongs to the parameters.
    pub field: Option<&'a FieldDocument>,
    /// Origin of base and targets.
    pub frames: FrameOrigin,
}

/// Judges the parameters of a document, or nominal ones, on the `selected` observations of a
/// campaign.
pub fn validate(
    campaign: &Campaign,
    selected: Selected,
    robot: &mut dyn Robot,
    judged: Validation,
) -> Result<Validated> {
    let Validation { document, frames, .. } = judged;
    let Selected { basis, mut targets, mut messages, .. } = selected;
    let Basis { mut sets, settings, systematic } = basis;
    if frames == FrameOrigin::Given {
        // all places are given
        sets = std::mem::take(&mut targets).with_readings(&sets);
    }
    if frames == FrameOrigin::Prior && document.is_none() {
        return Err(error!("prior-of-nominal").into());
    }
    messages.extend(check_set_up(robot, &sets.calibration, &settings)?);
    messages.extend(document.and_then(|document| other_nominal(robot, document)));
    let mut values = Values::new(robot, document, frames, &sets, &settings)?;
    let robot: &dyn Robot = robot;
    let field = judged.field.map(|field| field.field(robot)).transpose()?;
    if let (Some(field), FrameOrigin::Refit) = (&field, frames) {
        let corrected = Corrected::new(robot, field);
        let after = etalon_identify::refit_frames(&corrected, &sets.calibration, &settings, &values.after);
        values.after = after.map_err(remedied)?;
    }
    let locations = targets.locate(robot, &mut values.before, &mut values.after)?;
    messages.extend(locations.message(robot, &sets)?);
    let mut errors = point_errors(robot, &sets, &values.before, &values.after);
    if let Some(field) = &field {
        correct(&mut errors, &Corrected::new(robot, field), &sets, &values.after);
        messages.extend(beyond_field(field, &sets));
    }
    errors.extend(targets.errors(robot, &values.before, &values.after, &locations));
    let set_up = match frames {
        FrameOrigin::Given => Vec::new(),
        FrameOrigin::Refit | FrameOrigin::Prior => {
            etalon_identify::wanted_frames(robot, &sets.calibration, &settings).map_err(remedied)?
        }
    };
    let all = targets.with_readings(&sets);
    let judged = Judged { robot, values: &values.after, set_up: &set_up, sets: &all, settings: &settings };
    let uncertainty = ErrorUncertainty::new(campaign, judged, &systematic)?;
    let mut accuracy = accuracy::evaluate(robot, &errors, &campaign.file.limits, uncertainty);
    accuracy.placed_apart = locations.documents(robot);
    // targets that are located by these poses would have too small errors
    let corrected = field.as_ref().map(|field| Corrected::new(robot, field));
    let after: &dyn Robot = corrected.as_ref().map_or(robot, |corrected| corrected);
    let located = Judged { robot: after, sets: &sets, ..judged };
    let before = RobotValues { robot, values: &values.before };
    accuracy.relative = accuracy::relative(campaign, located, before, &systematic)?;
    accuracy.definition = definition(accuracy.definition.phrase().cloned(), document.is_some(), frames).into();
    let consistency = document.filter(|_| frames != FrameOrigin::Refit && sets.calibration_conditions.is_empty());
    let p_value = consistency.map(|document| p_value(robot, document, &sets, &settings)).transpose()?.flatten();
    accuracy.field = field.map(|field| FieldSummary::from_field(robot, &field));
    let (squares, readings) = by_pose(&accuracy, &errors);
    messages.extend(worse_than_nominal(&squares, readings));
    let refused = messages.iter().any(|message| message.severity == Severity::Error);
    accuracy.given = Some(ParameterJudgement { frames, p_value, refused });
    Ok(Validated { accuracy, messages })
}

/// All parameters, before and after.
struct Values {
    before: Vec<f64>,
    after: Vec<f64>,
}

impl Values {
    fn new(
        robot: &mut dyn Robot,
        document: Option<&ParametersDocument>,
        frames: FrameOrigin,
        sets: &Sets,
        settings: &Settings,
    ) -> Result<Self> {
        let nominal = robot.nominal();
        if frames == FrameOrigin::Given {
            let Some(document) = document else {
                return Ok(Self { before: stated(robot)?, after: nominal });
            };
            let after = parameters_from_document(robot, document)?.values;
            let entry = |name: &str| document.parameters.iter().find(|entry| entry.name == name);
            let earlier = robot.parameters().iter().map(|p| match entry(&p.name) {
                Some(entry) if p.role != Role::Robot => p.quantity.inward(entry.before),
                _ => p.nominal,
            });
            return Ok(Self { before: earlier.collect(), after });
        }
        let before = etalon_identify::fit_frames(robot, &sets.calibration, settings).map_err(remedied)?;
        if let (FrameOrigin::Prior, Some(document)) = (frames, document) {
            return Ok(Self { before, after: with_prior(robot, document, sets, settings)? });
        }
        let Some(document) = document else { return Ok(Self { after: before.clone(), before }) };
        let values = robot_values(robot, document, &[Role::Robot])?;
        robot.definition_mut().set_nominal(&values);
        let after = etalon_identify::fit_frames(robot, &sets.calibration, settings);
        robot.definition_mut().set_nominal(&nominal);
        Ok(Self { before, after: after.map_err(remedied)? })
    }
}

/// The given parameters with the most probable base and targets, given their covariance and the
/// calibration poses.
fn with_prior(robot: &dyn Robot, document: &ParametersDocument, sets: &Sets, settings: &Settings) -> Result<Vec<f64>> {
    if !sets.calibration_conditions.is_empty() {
        return Err(error!("prior-of-conditions").into());
    }
    let all = parameters_from_document(robot, document)?;
    let n = all.free.len();
    let kept: Vec<usize> = (0..n).filter(|&k| robot.parameters()[all.free[k]].role != Role::Robot).collect();
    let covariance =
        kept.iter().flat_map(|&i| kept.iter().map(move |&j| (i, j))).map(|(i, j)| all.covariance[i * n + j]);
    let frames = IdentifiedParameters {
        covariance: covariance.collect(),
        free: kept.iter().map(|&k| all.free[k]).collect(),
        values: all.values,
    };
    let noise = expected_deviation(robot, document, settings)?;
    let (misfit, settings) = (noise.misfit(&[]), noise.applied(Settings::default()));
    let observations = &sets.calibration;
    let calibration = Comparison { robot, observations, settings: &settings, given: &frames, misfit: &misfit };
    calibration.most_probable().map_err(remedied)
}

/// Expected deviation of coordinates whose uncertainty the settings state, or else the calibration.
fn expected_deviation(
    robot: &dyn Robot,
    document: &ParametersDocument,
    settings: &Settings,
) -> Result<ExpectedDeviation> {
    let stated_mm = Some(settings.coordinate_uncertainty_mm()).filter(|u| *u > 0.0);
    ExpectedDeviation::from_document(robot, document, stated_mm)
}

/// The nominal parameters, if base and targets are among them.
fn stated(robot: &dyn Robot) -> Result<Vec<f64>> {
    match robot.parameters().iter().find(|p| !p.tolerance.is_finite()) {
        Some(p) => Err(error!("place-without-nominal", parameter = p.name).into()),
        None => Ok(robot.nominal()),
    }
}

/// Probability of errors this large with the given parameters, base and targets, by their
/// uncertainty and the uncertainty of the measurement.
fn p_value(robot: &dyn Robot, document: &ParametersDocument, sets: &Sets, settings: &Settings) -> Result<Option<f64>> {
    let mut observations = sets.calibration.clone();
    let calibrated =
        |o: &etalon_identify::Observation| sets.calibration.iter().any(|c| (c.pose, c.cycle) == (o.pose, o.cycle));
    observations.extend(sets.validation.iter().filter(|o| !calibrated(o)).cloned());
    let parameters = parameters_from_document(robot, document)?;
    let noise = expected_deviation(robot, document, settings)?;
    let (misfit, settings) = (noise.misfit(&[]), noise.applied(Settings::default()));
    let all =
        Comparison { robot, observations: &observations, settings: &settings, given: &parameters, misfit: &misfit };
    Ok(all.p_value(noise.variance).ok())
}

/// Definition of errors for other parameters before and after.
fn definition(of: Option<Phrase>, identified: bool, frames: FrameOrigin) -> Phrase {
    let values = match (identified, frames) {
        (true, FrameOrigin::Refit) => phrase!("values-given-refit"),
        (true, FrameOrigin::Prior) => phrase!("values-given-prior"),
        (true, FrameOrigin::Given) => phrase!("values-given"),
        (false, FrameOrigin::Refit | FrameOrigin::Prior) => phrase!("values-nominal-refit"),
        (false, FrameOrigin::Given) => phrase!("values-nominal"),
    };
    of.unwrap_or_else(|| Phrase::new("error-definition")).with("values", &values)
}

/// Returns a warning if poses are beyond the field, where it fades out.
fn beyond_field(field: &JointField, sets: &Sets) -> Option<Message> {
    let all: Vec<&[f64]> = sets.calibration.iter().chain(&sets.validation).map(|o| o.joints.as_slice()).collect();
    let count = all.iter().filter(|joints| field.share(joints) < 1.0).count();
    (count > 0).then(|| warning!("poses-beyond-field", count, total = all.len()))
}

/// Squared errors of the leading quantity at all measured poses, and the number of readings. The
/// given parameters were identified from neither set.
fn by_pose(accuracy: &AccuracyDocument, errors: &[PointError]) -> (PoseErrors, usize) {
    let leading = accuracy.sets.last().and_then(|set| set.leading()).map(|leading| leading.quantity);
    let (mut all, mut readings) = (PoseErrors::new(), 0);
    for e in errors.iter().filter(|e| Some(e.quantity) == leading) {
        let squares = all.entry(e.pose).or_default();
        squares[0] += norm(e.before_mm).powi(2);
        squares[1] += norm(e.after_mm).powi(2);
        readings += 1;
    }
    (all, readings)
}
