//! Join by label: the log contains the measured point that the robot touches. A plate is measured
//! once; after that, only encoders are read.

use super::unmatched::At;
use super::{Remarks, Row, export_covariance};
use etalon_base::message::{Problems, Result};
use etalon_base::pose::{Pose, Vector};
use etalon_base::{error, phrase, warning};
use etalon_campaign::Campaign;
use etalon_documents::FramesDocument;
use etalon_fit::rotation_onto;
use etalon_formats::{JointLog, Point};
use etalon_identify::{Covariance, turned};
use etalon_math::statistics;
use etalon_robots::Robot;
use std::collections::{BTreeMap, BTreeSet};

/// One observation for every row of the log: the robot's only target is at the point that the row
/// names. A point that was measured several times counts as its mean; all its observations then
/// have the very same coordinates.
pub(super) fn by_label(
    campaign: &Campaign,
    points: &[Point],
    frames: &FramesDocument,
    log: &JointLog,
    robot: &dyn Robot,
) -> Result<(Vec<Row>, Remarks)> {
    let name = &log.name;
    if robot.targets().len() != 1 {
        return Err(error!("join-by-label-targets", count = robot.targets().len()).into());
    }
    let Some(frame) = frames.world.poses.iter().find(|f| f.pose.is_none()) else {
        return Err(error!("join-by-label-frame").into());
    };
    let measured = means(campaign, points);
    let world_T_export = frame.export_T_world.inverse();
    let (mut problems, mut rows) = (Problems::default(), Vec::new());
    let mut used = BTreeSet::new();
    let mut remarks = Remarks::default();
    let is_posed = has_poses(log, &measured, &mut remarks);
    for row in &log.rows {
        let label = row.label.as_deref().unwrap_or_default();
        used.insert(label);
        let Some(mean) = measured.get(label) else {
            let message = error!("label-not-measured", label).at(At::log(log, row).place());
            problems.0.push(message.hint_names(label, measured.keys().copied()));
            continue;
        };
        rows.push(Row {
            pose: row.pose.or(Some(row.row.into())),
            cycle: row.cycle.or(Some(1)),
            target: 0,
            world_mm: world_T_export.apply(mean.at_mm),
            orientation: mean.body.filter(|_| is_posed).map(|body| world_T_export.then(&body).quaternion()),
            station: None,
            covariance_mm2: mean.covariance_mm2.map(|c| turned(&c, &world_T_export.rotation)),
            time_s: row.time_s,
            assembly: row.assembly,
            joints: row.joints.clone(),
            line: Some(row.line),
        });
    }
    problems.check()?;
    let frame_points: BTreeSet<&str> = crate::stages::gather::used_labels(campaign).into_iter().collect();
    let idle = |label: &&str| !used.contains(label) && !frame_points.contains(label);
    let idle: BTreeSet<&str> = measured.keys().copied().filter(idle).collect();
    if let Some(first) = idle.first() {
        remarks.messages.push(warning!("points-untouched", log = name, count = idle.len(), label = first));
        let reason = phrase!("no-row-touches", log = name);
        let alone = points.iter().filter(|p| idle.contains(&*p.label));
        remarks.unmatched.extend(alone.map(|p| At::point(p).unmatched(p.label.to_string(), &reason)));
    }
    Ok((rows, remarks))
}

/// `true` if the orientations of labels are orientations of the body on the robot: the log names
/// each label once. A label that is named again is a place that the robot touches, and the
/// orientation belongs to the place.
fn has_poses(log: &JointLog, measured: &BTreeMap<&str, Mean>, remarks: &mut Remarks) -> bool {
    let mut times: BTreeMap<&str, usize> = BTreeMap::new();
    let with_body = |label: &&str| measured.get(label).is_some_and(|mean| mean.body.is_some());
    for label in log.rows.iter().filter_map(|row| row.label.as_deref()).filter(with_body) {
        *times.entry(label).or_default() += 1;
    }
    let again = times.iter().find(|(_, times)| **times > 1);
    if let Some((label, count)) = again {
        remarks.messages.push(warning!("label-orientations-unused", log = log.name, label, count));
    }
    again.is_none()
}

/// The mean of the points of one label, in the coordinates of the exports.
struct Mean {
    at_mm: Vector,
    /// Orientation of the measured body, if a point has one.
    body: Option<Pose>,
    /// Covariance of the coordinates, if all of the points have one.
    covariance_mm2: Option<Covariance>,
}

fn means<'p>(campaign: &Campaign, points: &'p [Point]) -> BTreeMap<&'p str, Mean> {
    let mut by_label: BTreeMap<&str, Vec<&Point>> = BTreeMap::new();
    for point in points {
        by_label.entry(&point.label).or_default().push(point);
    }
    let mean = |all: Vec<&Point>| {
        let n = all.len() as f64;
        let stated: Option<Vec<Covariance>> = all.iter().map(|point| export_covariance(campaign, point)).collect();
        let of_mean = |c: &[Covariance], i: usize, j: usize| c.iter().map(|c| c[i][j]).sum::<f64>() / (n * n);
        Mean {
            body: mean_body(&all),
            at_mm: [0, 1, 2].map(|axis| statistics::mean(all.iter().map(|point| point.xyz_mm[axis]))),
            covariance_mm2: stated.map(|c| [0, 1, 2].map(|i| [0, 1, 2].map(|j| of_mean(&c, i, j)))),
        }
    };
    by_label.into_iter().map(|(label, all)| (label, mean(all))).collect()
}

/// Mean orientation of the measured bodies: the least sum of squares of the chordal distances
/// (Moakher 2002).
fn mean_body(all: &[&Point]) -> Option<Pose> {
    let bodies: Vec<Pose> =
        all.iter().filter_map(|point| point.orientation.as_ref()).map(|q| Pose::from_quaternion(*q)).collect();
    let axes = bodies.iter().flat_map(|body| (0..3).map(|k| (Pose::identity().axis(k), body.axis(k))));
    (!bodies.is_empty()).then(|| Pose { rotation: rotation_onto(axes), translation_mm: [0.0; 3] })
}
