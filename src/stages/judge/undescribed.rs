//! Readings that an identified robot does not describe: their targets, and their common property.

use crate::stages::remedies::reading;
use crate::stages::truncated;
use etalon_base::catalogue::{Argument, Phrase};
use etalon_base::message::Message;
use etalon_base::pose::{Pose, centroid, minus, norm};
use etalon_base::{error, phrase};
use etalon_documents::{PointError, PoseSet};
use etalon_fit::rotation_onto;
use etalon_math::statistics::rms;
use std::collections::BTreeMap;

/// Maximum error as a share of the workspace: errors of calibrated models are thousandths of it;
/// more is another robot.
const LEFT: f64 = 0.02;
/// Maximum share of the errors that remains after a motion of the frame that explains them.
const EXPLAINS: f64 = 0.2;
/// Maximum number of readings or targets in a message.
const NAMED: usize = 5;

/// Fit of the calibration poses, as evidence about errors of the validation poses.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum CalibrationFit {
    /// They fit, with redundant coordinates.
    Fits,
    /// They fit without a redundant coordinate: other positions of base and targets fit equally
    /// well.
    Unchecked,
    /// They do not fit, or are the poses in question.
    Unknown,
}

/// Returns an error if the positions of `set` do not agree with the identified robot: the
/// observation, and its place. A cause is named only if the errors show it.
pub(crate) fn undescribed(set: PoseSet, errors: &[PointError], calibration: CalibrationFit) -> Option<Message> {
    let of: Vec<&PointError> = errors.iter().filter(|e| e.set == set).collect();
    let after_mm = rms(of.iter().map(|e| norm(e.after_mm)));
    let middle = centroid(&of.iter().map(|e| e.at_mm).collect::<Vec<_>>()).unwrap_or_default();
    let spread_mm = rms(of.iter().map(|e| norm(minus(e.at_mm, middle))));
    let most_mm = LEFT * spread_mm;
    if after_mm <= most_mm || of.len() < 2 {
        return None;
    }
    let far: Vec<&PointError> = of.iter().copied().filter(|e| norm(e.after_mm) > most_mm).collect();
    let count = far.len();
    let hint = undescribed_hint(&of, far, calibration, after_mm);
    let (set, total, limit_mm) = (set.name(), of.len(), most_mm);
    let message = error!("measurements-undescribed", set, after_mm, spread_mm, count, total, limit_mm);
    Some(message.hint(hint))
}

/// Returns the common property of the errors of `of`; `far` are the readings beyond the limit.
fn undescribed_hint(of: &[&PointError], far: Vec<&PointError>, calibration: CalibrationFit, after_mm: f64) -> Phrase {
    if let Some(targets) = targets_alone(of, &far) {
        return phrase!("undescribed-targets", targets);
    }
    if 2 * far.len() < of.len() {
        return phrase!("undescribed-readings", readings = named(far), remedy = phrase!("check-readings"));
    }
    match calibration {
        CalibrationFit::Unknown => return phrase!("undescribed-set-up"),
        CalibrationFit::Unchecked => return phrase!("undescribed-unchecked"),
        CalibrationFit::Fits => {}
    }
    match moved(of).filter(|(_, left_mm)| *left_mm < EXPLAINS * after_mm) {
        Some((motion_mm, left_mm)) => phrase!("undescribed-frame-moved", motion_mm, left_mm),
        None => phrase!("undescribed-other-poses"),
    }
}

/// The targets all of whose readings are far, if no reading of another target is and there are
/// other targets.
fn targets_alone(of: &[&PointError], far: &[&PointError]) -> Option<Vec<Argument>> {
    let mut counts: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    of.iter().for_each(|e| counts.entry(&e.target).or_default()[0] += 1);
    far.iter().for_each(|e| counts.entry(&e.target).or_default()[1] += 1);
    let alone = counts.values().all(|[all, far]| far == all || *far == 0) && counts.values().any(|c| c[1] == 0);
    let names = counts.iter().filter(|(_, c)| c[1] > 0).map(|(name, _)| format!("`{name}`"));
    alone.then(|| truncated(names, NAMED))
}

/// Far readings, the farthest first.
fn named(mut far: Vec<&PointError>) -> Vec<Argument> {
    far.sort_by(|a, b| norm(b.after_mm).total_cmp(&norm(a.after_mm)));
    truncated(far.iter().map(|e| reading(norm(e.after_mm), &e.target, e.pose, e.cycle)), NAMED)
}

/// Distance (mm) by which the best motion of the frame moves the middle of the readings, and the
/// errors that it leaves (root mean square, mm).
fn moved(of: &[&PointError]) -> Option<(f64, f64)> {
    let measured: Vec<_> = of.iter().map(|e| e.at_mm).collect();
    let predicted: Vec<_> = of.iter().map(|e| minus(e.at_mm, e.after_mm)).collect();
    let (to, from) = (centroid(&measured)?, centroid(&predicted)?);
    let pairs = predicted.iter().zip(&measured).map(|(p, m)| (minus(*p, from), minus(*m, to)));
    let turn = Pose { rotation: rotation_onto(pairs.clone()), translation_mm: [0.0; 3] };
    let left = rms(pairs.map(|(p, m)| norm(minus(m, turn.rotate(p)))));
    Some((norm(minus(to, from)), left))
}
