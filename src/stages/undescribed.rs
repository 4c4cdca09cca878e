//! Readings that an identified robot does not describe: whose they are, and what they have in common.

use crate::stages::remedies::WRONG_READINGS;
use etalon_base::message::Message;
use etalon_base::pose::{Pose, centroid, minus, norm};
use etalon_documents::{PointError, PoseSet};
use etalon_fit::rotation_onto;
use etalon_math::statistics::rms;
use std::collections::{BTreeMap, BTreeSet};

/// A calibrated model leaves thousandths of the workspace; more than this share of it is another robot.
const LEFT: f64 = 0.02;
/// A motion of the frame explains errors of which it leaves less than this share.
const EXPLAINS: f64 = 0.2;
/// Readings or targets that a message names.
const NAMED: usize = 5;

/// An error where the positions of `set` are not those of the identified robot: what is seen, and where. A cause is named only where the
/// errors show it. `calibration_fits` if the calibration poses do not show the same.
pub(super) fn undescribed(set: PoseSet, errors: &[PointError], calibration_fits: bool) -> Option<Message> {
    let of: Vec<&PointError> = errors.iter().filter(|e| e.set == set).collect();
    let after_mm = rms(of.iter().map(|e| norm(e.after_mm)));
    let middle = centroid(&of.iter().map(|e| e.at_mm).collect::<Vec<_>>()).unwrap_or_default();
    let spread_mm = rms(of.iter().map(|e| norm(minus(e.at_mm, middle))));
    let most_mm = LEFT * spread_mm;
    if after_mm <= most_mm || of.len() < 2 {
        return None;
    }
    let far: Vec<&PointError> = of.iter().copied().filter(|e| norm(e.after_mm) > most_mm).collect();
    let what = format!(
        "the model does not describe these measurements: on the {set} poses {after_mm:.3} mm are left (root mean square) of \
         positions that spread over {spread_mm:.1} mm; {} of {} readings are off by more than {most_mm:.1} mm",
        far.len(),
        of.len()
    );
    let hint = if let Some(targets) = targets_alone(&of, &far) {
        format!("all readings of {targets} are off, and no others: check its labels, and whether it was moved")
    } else if 2 * far.len() < of.len() {
        format!("{}: {WRONG_READINGS}", named(far))
    } else if !calibration_fits {
        "check units, order and signs of the joints, the nominal parameters, and how log and points are joined"
            .to_owned()
    } else if let Some((motion_mm, left_mm)) = moved(&of).filter(|(_, left_mm)| *left_mm < EXPLAINS * after_mm) {
        format!(
            "one motion of the frame by {motion_mm:.1} mm leaves {left_mm:.3} mm: base or measuring system has moved between \
             calibration and validation poses"
        )
    } else {
        "the calibration poses fit, and no motion of the frame explains the others: check whether log and exports of the validation poses \
         are of the same poses (a log of another campaign, or poses that are numbered otherwise)"
            .to_owned()
    };
    Some(Message::error(what).hint(hint))
}

/// The targets all of whose readings are far, where no reading of another one is and there are others.
fn targets_alone(of: &[&PointError], far: &[&PointError]) -> Option<String> {
    let mut counts: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    of.iter().for_each(|e| counts.entry(&e.target).or_default()[0] += 1);
    far.iter().for_each(|e| counts.entry(&e.target).or_default()[1] += 1);
    let alone = counts.values().all(|[all, far]| far == all || *far == 0) && counts.values().any(|c| c[1] == 0);
    let names: Vec<String> = counts.iter().filter(|(_, c)| c[1] > 0).map(|(name, _)| format!("`{name}`")).collect();
    alone.then(|| names.iter().take(NAMED).cloned().collect::<Vec<_>>().join(", "))
}

/// Far readings, the farthest first, with the poses of all.
fn named(mut far: Vec<&PointError>) -> String {
    far.sort_by(|a, b| norm(b.after_mm).total_cmp(&norm(a.after_mm)));
    let text =
        |e: &&PointError| format!("{:.1} mm ({}, pose {}, cycle {})", norm(e.after_mm), e.target, e.pose, e.cycle);
    let poses: BTreeSet<_> = far.iter().map(|e| e.pose).collect();
    let first: Vec<String> = far.iter().take(NAMED).map(text).collect();
    let more = if far.len() > NAMED { format!(", ... in {} poses", poses.len()) } else { String::new() };
    format!("{}{more}", first.join(", "))
}

/// How far the motion of the frame that explains the errors best moves their middle, and what it leaves (root mean square), mm.
fn moved(of: &[&PointError]) -> Option<(f64, f64)> {
    let measured: Vec<_> = of.iter().map(|e| e.at_mm).collect();
    let predicted: Vec<_> = of.iter().map(|e| minus(e.at_mm, e.after_mm)).collect();
    let (to, from) = (centroid(&measured)?, centroid(&predicted)?);
    let pairs = predicted.iter().zip(&measured).map(|(p, m)| (minus(*p, from), minus(*m, to)));
    let turn = Pose { rotation: rotation_onto(pairs.clone()), translation_mm: [0.0; 3] };
    let left = rms(pairs.map(|(p, m)| norm(minus(m, turn.rotate(p)))));
    Some((norm(minus(to, from)), left))
}
