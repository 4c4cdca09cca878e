//! Readings that an identified robot does not describe: their targets, and their common property.

use crate::stages::remedies::reading;
use crate::stages::truncated;
use etalon_base::catalogue::{Argument, Phrase};
use etalon_base::message::Message;
use etalon_base::pose::{Pose, centroid, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use etalon_documents::{PointError, PoseSet};
use etalon_fit::rotation_onto;
use etalon_math::statistics::rms;
use std::collections::{BTreeMap, BTreeSet};

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
    let hint = shifted_rows(errors, &far).unwrap_or_else(|| undescribed_hint(&of, far, calibration, after_mm));
    let (set, total, limit_mm) = (set.name(), of.len(), most_mm);
    let message = error!("measurements-undescribed", set, after_mm, spread_mm, count, total, limit_mm);
    Some(message.hint(hint))
}

/// Minimum number of poses whose joint values belong to a neighbour.
const FEWEST_SHIFTED: usize = 3;
/// Minimum share of the far readings that the joint values of the neighbours explain.
const MOST_SHIFTED: f64 = 0.8;

/// Statement that the far readings have the joint values of the previous or of the next pose: each
/// position by the joint values is the measured position of that neighbour, among all readings
/// `errors`.
fn shifted_rows(errors: &[PointError], far: &[&PointError]) -> Option<Phrase> {
    let mut measured: BTreeMap<(&str, i64), BTreeMap<PoseName, &PointError>> = BTreeMap::new();
    for e in errors {
        measured.entry((e.target.as_str(), e.cycle)).or_default().insert(e.pose, e);
    }
    let poses: BTreeSet<PoseName> = errors.iter().map(|e| e.pose).collect();
    let neighbours = [("previous", true), ("next", false)].into_iter().filter_map(|(neighbour, is_before)| {
        let other = |pose: PoseName| match is_before {
            true => poses.range(..pose).next_back().copied(),
            false => poses.range(pose..).nth(1).copied(),
        };
        let is_of_neighbour = |e: &&&PointError| {
            let near = other(e.pose).and_then(|pose| measured.get(&(e.target.as_str(), e.cycle))?.get(&pose).copied());
            let off = |near: &PointError| norm(minus(minus(e.at_mm, e.after_mm), near.at_mm));
            near.is_some_and(|near| off(near) < EXPLAINS * norm(e.after_mm))
        };
        let explained: Vec<&&PointError> = far.iter().filter(is_of_neighbour).collect();
        let shifted: BTreeSet<PoseName> = explained.iter().map(|e| e.pose).collect();
        let are_most = explained.len() as f64 >= MOST_SHIFTED * far.len() as f64;
        let (first, last) = (*shifted.first()?, *shifted.last()?);
        let statement = phrase!("undescribed-rows-shifted", first, last, neighbour);
        (are_most && shifted.len() >= FEWEST_SHIFTED).then_some((explained.len(), statement))
    });
    neighbours.max_by_key(|(count, _)| *count).map(|(_, statement)| statement)
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

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::pose::Vector;
    use etalon_documents::{ErrorQuantity, ReadingControl};

    /// Errors of a robot whose poses 8 to 20 have the joint values of the pose `shift` before.
    fn errors(shift: i64) -> Vec<PointError> {
        let at = |pose: i64| -> Vector { [37.0 * (pose % 5) as f64, 11.0 * pose as f64, 0.0] };
        let error = |pose: i64| {
            let predicted = at(if pose < 8 { pose } else { pose - shift });
            PointError {
                set: PoseSet::Validation,
                pose: pose.into(),
                cycle: 1,
                target: "ball".to_owned(),
                quantity: ErrorQuantity::Position,
                at_mm: at(pose),
                before_mm: minus(at(pose), predicted),
                after_mm: minus(at(pose), predicted),
                before_deg: None,
                after_deg: None,
                joints: Vec::new(),
                control: ReadingControl::default(),
            }
        };
        (1..=20).map(error).collect()
    }

    #[test]
    fn a_log_that_lost_or_doubled_a_row_is_named() {
        let hint = |shift: i64| {
            let all = errors(shift);
            let far: Vec<&PointError> = all.iter().filter(|e| norm(e.after_mm) > 1.0).collect();
            shifted_rows(&all, &far)
        };
        let named = |first: i64, last: i64, neighbour: &str| {
            let (first, last) = (PoseName::from(first), PoseName::from(last));
            Some(phrase!("undescribed-rows-shifted", first, last, neighbour))
        };
        assert_eq!(hint(1), named(8, 20, "previous"));
        // the last pose has no next one
        assert_eq!(hint(-1), named(8, 19, "next"));
        assert_eq!(hint(3), None);
        assert!(undescribed(PoseSet::Validation, &errors(1), CalibrationFit::Fits).is_some());
    }
}
