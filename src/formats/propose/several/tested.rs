//! Joined rows against the kinematics of the nominal robot.

use super::keys::Join;
use super::part::Part;
use crate::propose::against::{self, Remarks, described, name_joints};
use crate::propose::kinematics::{Outcome, Sample, test};
use crate::propose::turned;
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_robots::Robot;

/// Tests joined rows against the robot, and writes the lines of both files again.
pub(super) fn by_robot(robot: &dyn Robot, parts: &mut [Part], at: usize, log: usize, join: &Join) -> Result<()> {
    let Some((columns, outcome)) = tested(robot, &parts[at], &parts[log], join) else { return Ok(()) };
    let (Outcome::Reproduced(reading) | Outcome::Ambiguous(reading, _)) = &outcome else {
        if let Outcome::Contradicted(best) = outcome {
            let known = if best.is_some() { "yes" } else { "no" };
            let points = parts[at].document.file.clone();
            let doubt = phrase!("robot-contradicts", points, known, rms_mm = best.unwrap_or(0.0));
            parts[at].doubt(doubt);
        }
        return Ok(());
    };
    let mut flanges = vec![None; parts[at].read.as_ref().map_or(0, |(table, _)| table.rows)];
    if let Some((table, _)) = &parts[log].read {
        for (row, of_log) in &join.pairs {
            flanges[*row] = turned::flange(robot, reading, &|k| table.columns[columns[k]].values[*of_log]);
        }
    }
    let by_kinematics = parts[log].read.as_ref().is_some_and(|(_, found)| found.by_kinematics);
    if !by_kinematics {
        parts[log].again(&mut |table, found| name_joints(robot, &columns, reading, table, found))?;
    }
    parts[at].again(&mut |table, found| {
        let mut remarks = Remarks::default();
        let points = found.points.first().map(|set| set.columns);
        if let Some([Some(x), Some(y), Some(z)]) = points {
            described(table, [x, y, z], reading, true, &mut remarks);
            found.by_kinematics = true;
        }
        remarks.reasons.extend(turned::order(&flanges, &reading.base_R_world, table, found));
        remarks
    })
}

/// Tests the joints of the log with the points of an export; also returns the columns of joints.
pub(super) fn tested(robot: &dyn Robot, export: &Part, log: &Part, join: &Join) -> Option<(Vec<usize>, Outcome)> {
    let ((points, of_export), (joints, of_log)) = (export.read.as_ref()?, log.read.as_ref()?);
    let set = of_export.points.first()?;
    let [Some(x), Some(y), Some(z)] = set.columns else { return None };
    let targets = target_numbers(export, join);
    let outcome = |columns: &[usize], thorough: bool| {
        let values = |c: &usize| join.pairs.iter().map(|(_, l)| joints.columns[*c].values[*l]).collect();
        let sample = Sample {
            joints: columns.iter().map(values).collect(),
            stated: columns.iter().map(|c| joints.columns[*c].heading.unit).collect(),
            points: [x, y, z].map(|c| join.pairs.iter().map(|(e, _)| points.columns[c].values[*e]).collect()),
            targets: targets.clone(),
        };
        test(robot, &sample.finite(), thorough)
    };
    let lists = against::joint_lists(robot, joints, of_log);
    let fits = |columns: &&Vec<usize>| matches!(outcome(columns, false), Outcome::Reproduced(_));
    let chosen = if lists.len() > 1 { lists.iter().find(fits) } else { None };
    let columns = chosen.or(lists.first()).cloned().unwrap_or_else(|| of_log.joint_columns());
    let outcome = outcome(&columns, true);
    Some((columns, outcome))
}

/// Returns the number of the target of each pair.
fn target_numbers(export: &Part, join: &Join) -> Vec<usize> {
    let names = export.targets();
    let mut known: Vec<String> = Vec::new();
    let mut number = |(row, _): &(usize, usize)| {
        let name = names.as_ref().map_or("", |names| names[*row].as_str());
        known.iter().position(|known| known == name).unwrap_or_else(|| {
            known.push(name.to_owned());
            known.len() - 1
        })
    };
    join.pairs.iter().map(&mut number).collect()
}
