//! Tables 2.2 to 2.4: mean errors of repeated poses, before and after.

use crate::base::message::{Message, Result};
use crate::campaign::{Campaign, GeometricDefinition, Selection};
use crate::document::{MeanError, MethodErrors, PoseRow, PoseTable};
use crate::math::geometric::mean_and_sd;
use crate::math::identify::Observation;
use crate::math::robots::Platform;
use crate::stages::evaluate::Sets;
use std::collections::BTreeMap;

/// One table for each selection of poses; the three sets of parameters are those before, geometric and identified.
pub(super) fn tables(
    campaign: &Campaign,
    definition: &GeometricDefinition,
    robot: &dyn Platform,
    sets: &Sets,
    parameters: [&[f64]; 3],
) -> Result<Vec<PoseTable>> {
    let mut poses: BTreeMap<i64, Vec<&Observation>> = BTreeMap::new();
    for o in sets.calibration.iter().chain(&sets.validation) {
        poses.entry(o.pose).or_default().push(o);
    }
    let mut tables = Vec::new();
    for table in &definition.table {
        let place = || campaign.place(&table.poses);
        let selection = Selection::parse(table.poses.get_ref()).map_err(|m| m.at(place()))?;
        let chosen = poses.iter().enumerate().filter(|(i, (pose, _))| selection.contains(**pose, *i, false));
        let rows: Vec<PoseRow> =
            chosen.filter_map(|(_, (pose, observed))| row(robot, *pose, observed, parameters)).collect();
        if rows.is_empty() {
            let what = format!("at no pose of the table `{}` were K and L measured together", table.title);
            return Err(Message::error(what).at(place()).hint("measure both balls in the same cycle").into());
        }
        tables.push(PoseTable { title: table.title.clone(), rows });
    }
    Ok(tables)
}

/// Mean errors of one pose; `None` where K and L were never measured together.
fn row(robot: &dyn Platform, pose: i64, observed: &[&Observation], parameters: [&[f64]; 3]) -> Option<PoseRow> {
    let errors = |p: &[f64]| -> Vec<[f64; 3]> {
        let error = |o: &&Observation| {
            let [Some(k), Some(l)] = o.targets[..] else { return None };
            // estimated minus measured, turned round
            Some(robot.pose_error(p, &o.joints, [[k[0], k[1]], [l[0], l[1]]]).map(|r| -r))
        };
        observed.iter().filter_map(error).collect()
    };
    let component = |all: &[[f64; 3]], k: usize| mean_and_sd(&all.iter().map(|e| e[k]).collect::<Vec<_>>());
    let mean = |p: &[f64]| {
        let all = errors(p);
        let [x, y, theta] = [component(&all, 0)?, component(&all, 1)?, component(&all, 2)?];
        let mean =
            MeanError { x_mm: x.0, y_mm: y.0, position_mm: x.0.hypot(y.0), orientation_deg: theta.0.to_degrees() };
        Some((mean, x.1.max(y.1), all.len()))
    };
    let [before, geometric, identified] = parameters;
    let command = robot.pose(&robot.nominal(), &observed.first()?.joints);
    let (geometric, standard_deviation_mm, count) = mean(geometric)?;
    Some(PoseRow {
        pose,
        command_mm: [command.x_mm, command.y_mm],
        command_deg: command.theta_rad.to_degrees(),
        count,
        before: mean(before)?.0,
        geometric,
        identified: mean(identified)?.0,
        standard_deviation_mm,
    })
}

/// Largest and root mean square of the mean errors of all tables, by method.
pub(super) fn methods(tables: &[PoseTable]) -> Vec<MethodErrors> {
    let method = |name: &str, of: fn(&PoseRow) -> MeanError| {
        let errors: Vec<MeanError> = tables.iter().flat_map(|t| &t.rows).map(of).collect();
        let squares: f64 = errors.iter().map(|e| e.position_mm.powi(2)).sum();
        MethodErrors {
            name: name.to_owned(),
            position_max_mm: errors.iter().fold(0.0, |m, e| m.max(e.position_mm)),
            position_rms_mm: (squares / errors.len() as f64).sqrt(),
            orientation_max_deg: errors.iter().fold(0.0, |m, e| m.max(e.orientation_deg.abs())),
        }
    };
    if tables.is_empty() {
        return Vec::new();
    }
    vec![method("before", |r| r.before), method("geometric", |r| r.geometric), method("identified", |r| r.identified)]
}
