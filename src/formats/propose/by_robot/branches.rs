//! Targets of a robot with several branches: the chain whose kinematics fit the points of each.

use crate::propose::kinematics::{Outcome, Sample, test};
use crate::propose::several::{Keys, Part, best_join};
use crate::propose::table::{Table, joint_columns};
use etalon_base::message::Result;
use etalon_robots::Robot;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Fit of the points of a target to the nominal kinematics of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TargetFit {
    /// The chain reproduces the points with this residual (mm, root mean square).
    Reproduced(f64),
    /// The chain does not reproduce the points.
    Contradicted,
    /// The rows are too few, or in one plane.
    Untested,
}

/// Tests the points of each target in the files against each chain. Only columns that are headed by
/// the names of the joints count, with their units and without reversed directions.
///
/// # Errors
/// Fails if a file is missing, or is not a table.
pub fn fit_targets(paths: &[PathBuf], chains: &[&dyn Robot]) -> Result<BTreeMap<String, Vec<TargetFit>>> {
    let parts = Part::all(paths, None)?;
    let mut rows: BTreeMap<String, Vec<TargetFit>> = BTreeMap::new();
    for export in &parts {
        let Some(targets) = export.targets() else { continue };
        let mut names = targets.clone();
        names.sort_unstable();
        names.dedup();
        for name in names.into_iter().filter(|name| !name.is_empty()) {
            let of_target: Vec<usize> = (0..targets.len()).filter(|row| targets[*row] == name).collect();
            let fits = chains.iter().map(|chain| fit(*chain, export, &of_target, &parts));
            let fits: Vec<TargetFit> = fits.collect();
            rows.entry(name).and_modify(|known| merge(known, &fits)).or_insert(fits);
        }
    }
    Ok(rows)
}

/// Combines the fits of one target in two files.
fn merge(known: &mut [TargetFit], more: &[TargetFit]) {
    for (known, more) in known.iter_mut().zip(more) {
        *known = match (*known, *more) {
            (TargetFit::Untested, fit) | (fit, TargetFit::Untested) => fit,
            (TargetFit::Reproduced(a), TargetFit::Reproduced(b)) => TargetFit::Reproduced(a.max(b)),
            _ => TargetFit::Contradicted,
        };
    }
}

fn fit(chain: &dyn Robot, export: &Part, of_target: &[usize], parts: &[Part]) -> TargetFit {
    let sample = sample(chain, export, of_target, parts);
    match sample.map(|sample| test(chain, &sample.finite(), false)) {
        Some(Outcome::Reproduced(reading) | Outcome::Ambiguous(reading, _)) => TargetFit::Reproduced(reading.rms_mm),
        Some(Outcome::Contradicted(_)) => TargetFit::Contradicted,
        Some(Outcome::Untested) | None => TargetFit::Untested,
    }
}

/// Points of one target with the joints of a chain: in the same rows, or in the rows of a log.
fn sample(chain: &dyn Robot, export: &Part, of_target: &[usize], parts: &[Part]) -> Option<Sample> {
    let (points, found) = export.read.as_ref()?;
    let [Some(x), Some(y), Some(z)] = found.points.first()?.columns else { return None };
    let own = joint_columns(chain, points).map(|columns| (points, columns, (0..points.rows).map(|i| (i, i)).collect()));
    let is_log = |part: &&Part| part.document.kind == "log";
    let (joints, columns, pairs) =
        own.or_else(|| parts.iter().filter(is_log).find_map(|log| joined(chain, export, log)))?;
    let pairs: Vec<(usize, usize)> = pairs.into_iter().filter(|(row, _)| of_target.contains(row)).collect();
    let values =
        |table: &Table, column: usize, row: usize| table.columns[column].values.get(row).copied().unwrap_or(f64::NAN);
    Some(Sample {
        joints: columns.iter().map(|c| pairs.iter().map(|(_, row)| values(joints, *c, *row)).collect()).collect(),
        stated: columns.iter().map(|c| joints.columns[*c].heading.unit).collect(),
        points: [x, y, z].map(|c| pairs.iter().map(|(row, _)| values(points, c, *row)).collect()),
        targets: vec![0; pairs.len()],
    })
}

/// Table of a log with the columns of the joints, and the rows of export and log that belong
/// together.
type Joined<'p> = (&'p Table, Vec<usize>, Vec<(usize, usize)>);

fn joined<'p>(chain: &dyn Robot, export: &Part, log: &'p Part) -> Option<Joined<'p>> {
    let (table, _) = log.read.as_ref()?;
    let columns = joint_columns(chain, table)?;
    Some((table, columns, best_join(None, export, &Keys::new(export), log)?.pairs))
}
