//! Tasks of `etalon benchmark`: measurements that identified parameters predict, and the score of
//! predictions of any program.

use super::inputs::{Inputs, Table};
use crate::stages::evaluate::accuracy::summarise;
use crate::stages::table_file::TableFile;
use crate::stages::verify::expected_scatter::{ExpectedScatter, variance_factor};
use crate::stages::verify::predicted::Prediction;
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_documents::{
    BenchmarkScoreDocument, IntervalScore, ParametersDocument, PredictedBody, PredictedMeasurement,
    PredictionsDocument, Provenance, QuantityScore,
};
use etalon_formats::table::{COVARIANCES, QUATERNION, UNCERTAINTIES, XYZ};
use etalon_formats::tables::joints::joint_values;
use etalon_math::statistics::{interval_score, mean, ratio_uncertainty};
use nalgebra::{Cholesky, Matrix3, Vector3};
use statrs::distribution::{Beta, ChiSquared, ContinuousCDF, Normal};
use std::collections::BTreeMap;

/// Probability of the intervals that are scored.
const PROBABILITY: f64 = 0.95;

/// Columns with the ends of an interval of each coordinate.
const ENDS: [[&str; 2]; 3] = [["x_low_mm", "x_high_mm"], ["y_low_mm", "y_high_mm"], ["z_low_mm", "z_high_mm"]];

/// Column with the standard uncertainty of an orientation about any axis.
pub(crate) const TURN: &str = "urot_deg";

/// Measurements at the joint values of a table that identified parameters predict. Covariances
/// contain parameters, model and instrument, as `etalon verify` expects them.
///
/// # Errors
/// Fails with parameters of another robot, without a target among them, and without residuals.
pub fn predict(inputs: &Inputs, document: &ParametersDocument) -> Result<PredictionsDocument> {
    let file = &inputs.table.read()?;
    let here = |problems: Problems| file.place(problems);
    let (poses, names) = (file.table.poses().map_err(here)?, file.table.texts("target").map_err(here)?);
    let mut targets: BTreeMap<&str, Prediction> = BTreeMap::new();
    for name in &names {
        if !targets.contains_key(&**name) {
            let stated = Prediction::new(inputs.robot, document, name)?;
            targets.insert(name, stated.with_variance_factor(document, variance_factor(&document.residuals)));
        }
    }
    let Some(robot) = targets.values().next().map(Prediction::robot) else {
        return Err(here(error!("data-rows-missing").into()));
    };
    let expected = ExpectedScatter::from_document(robot, document)?;
    let joints = joint_values(robot, &file.table, &[]).map_err(here)?;
    let one = |((pose, name), joints): ((PoseName, &std::borrow::Cow<str>), Vec<f64>)| {
        let at = &targets[&**name];
        let found = at.at(&joints);
        let mut covariance_mm2 = found.covariance_mm2;
        let [grown, grown_turn] = expected.growth(robot, &joints);
        (0..robot.dimension()).for_each(|i| covariance_mm2[i][i] += grown * expected.coordinate_mm.powi(2));
        let body = at.orientation_at(&joints).zip(expected.orientation_rad).map(|(found, turned_rad)| {
            let trace: f64 = (0..3).map(|i| found.covariance_rad2[i][i]).sum();
            let u_rad = (trace / 3.0 + grown_turn * turned_rad.powi(2)).sqrt();
            PredictedBody { quaternion: found.world_T_body.quaternion(), standard_uncertainty_deg: u_rad.to_degrees() }
        });
        let (target, xyz_mm) = (name.clone().into_owned(), found.position_mm);
        PredictedMeasurement { pose, target, xyz_mm, covariance_mm2, orientation: body }
    };
    let predictions: Vec<PredictedMeasurement> = poses.into_iter().zip(&names).zip(joints).map(one).collect();
    if let Some(row) = predictions.iter().position(|p| p.xyz_mm.iter().any(|v| !v.is_finite())) {
        let message = error!("robot-not-at-joints", parameters = "identified").at(file.table.place(row));
        return Err(here(message.into()));
    }
    Ok(PredictionsDocument {
        schema: "etalon/predictions/1".to_owned(),
        robot: robot.model().to_owned(),
        predictions,
        provenance: provenance(inputs.sha256_by_name()?),
    })
}

/// Scores predictions against measured values: errors, and coverage, width and interval score of
/// given intervals. Rows belong together by `pose` and `target`.
///
/// # Errors
/// Fails if a measured row has no prediction or several, and if a value is missing.
pub fn score(predictions: Table, truth: Table) -> Result<BenchmarkScoreDocument> {
    let inputs = [predictions, truth].iter().map(Table::hashed).collect::<Result<_>>()?;
    let (predicted, measured) = (predictions.read()?, truth.read()?);
    let rows = matched(&predicted, &measured)?;
    let poses = measured.table.poses().map_err(|problems| measured.place(problems))?;
    let errors = positions(&predicted, &measured, &rows)?;
    let stated = Stated::read(&predicted)?;
    let intervals = stated.map(|stated| {
        let each = |(row, error): (usize, &Vector)| {
            let intervals = stated.intervals(rows[row]);
            intervals.into_iter().zip(*error).map(|(interval, e)| (interval, -e)).collect::<Vec<_>>()
        };
        let all: Vec<_> = errors.iter().enumerate().map(each).collect();
        (interval_scores(&poses, &all), stated.ellipsoid_coverage(&rows, &errors))
    });
    let turned = orientations(&predicted, &measured, &rows)?;
    let mut names = poses.clone();
    names.sort_unstable();
    names.dedup();
    Ok(BenchmarkScoreDocument {
        schema: "etalon/benchmark-score/1".to_owned(),
        poses: names.len(),
        rows: rows.len(),
        position: QuantityScore {
            unit: "mm".to_owned(),
            errors: summarise(errors.iter().map(|e| norm(*e)).collect()),
            intervals: intervals.as_ref().map(|found| found.0),
            ellipsoid_coverage: intervals.and_then(|found| found.1),
        },
        orientation: turned.map(|turned| turned.score(&poses)),
        provenance: provenance(inputs),
    })
}

fn provenance(inputs: BTreeMap<String, String>) -> Provenance {
    Provenance { version: env!("CARGO_PKG_VERSION").to_owned(), inputs, seed: None }
}

/// Row of the prediction of each measured row.
fn matched(predicted: &TableFile, measured: &TableFile) -> Result<Vec<usize>> {
    let keys = |file: &TableFile| -> Result<Vec<(PoseName, String)>> {
        let poses = file.table.poses().map_err(|problems| file.place(problems))?;
        let names = file.table.texts("target").map_err(|problems| file.place(problems))?;
        Ok(poses.into_iter().zip(names.into_iter().map(std::borrow::Cow::into_owned)).collect())
    };
    let mut rows = BTreeMap::new();
    for (row, key) in keys(predicted)?.into_iter().enumerate() {
        if let Some(first) = rows.insert(key.clone(), row) {
            let line = predicted.table.line(first).unwrap_or(0);
            let message = error!("prediction-repeated", pose = key.0, target = key.1, line);
            return Err(predicted.place(message.at(predicted.table.place(row)).into()));
        }
    }
    let wanted = keys(measured)?;
    let missing: Vec<&(PoseName, String)> = wanted.iter().filter(|key| !rows.contains_key(key)).collect();
    if let Some((pose, target)) = missing.first() {
        return Err(error!("predictions-missing", count = missing.len(), pose, target).into());
    }
    Ok(wanted.iter().map(|key| rows[key]).collect())
}

/// Numbers of columns, row by row.
fn numbers<const N: usize>(file: &TableFile, names: [&str; N]) -> Result<Vec<[f64; N]>> {
    let here = |problems: Problems| file.place(problems);
    file.table.require(names).map_err(here)?;
    let mut rows = vec![[0.0; N]; file.table.height()];
    for (k, name) in names.into_iter().enumerate() {
        for (row, value) in file.table.numbers(name).map_err(here)?.into_iter().enumerate() {
            rows[row][k] = value;
        }
    }
    match rows.iter().position(|row| row.iter().any(|v| !v.is_finite())) {
        Some(row) => Err(here(error!("table-value-missing").at(file.table.place(row)).into())),
        None => Ok(rows),
    }
}

/// Predicted minus measured position (mm) of each measured row.
fn positions(predicted: &TableFile, measured: &TableFile, rows: &[usize]) -> Result<Vec<Vector>> {
    let (found, seen) = (numbers(predicted, XYZ)?, numbers(measured, XYZ)?);
    Ok(rows.iter().zip(seen).map(|(&row, seen)| minus(found[row], seen)).collect())
}

/// Uncertainties that predictions of positions state, row by row of the predictions.
enum Stated {
    /// Covariances (mm²): xx, xy, xz, yy, yz, zz.
    Covariances(Vec<[f64; 6]>),
    /// Standard uncertainties (mm).
    Uncertainties(Vec<[f64; 3]>),
    /// Ends (mm) of intervals of positions, relative to the predicted position.
    Ends(Vec<[[f64; 2]; 3]>),
}

impl Stated {
    /// The uncertainties of a table, if it has their columns: ends of intervals, a covariance, or
    /// standard uncertainties.
    fn read(file: &TableFile) -> Result<Option<Self>> {
        let has = |names: &[&str]| names.iter().any(|name| file.table.has(name));
        if has(ENDS.as_flattened()) {
            let [[a, b], [c, d], [e, f]] = ENDS;
            let (ends, xyz) = (numbers(file, [a, b, c, d, e, f])?, numbers(file, XYZ)?);
            let relative = |(ends, at): ([f64; 6], [f64; 3])| {
                std::array::from_fn(|k| [ends[2 * k] - at[k], ends[2 * k + 1] - at[k]])
            };
            return Ok(Some(Self::Ends(ends.into_iter().zip(xyz).map(relative).collect())));
        }
        if has(&COVARIANCES) {
            return Ok(Some(Self::Covariances(numbers(file, COVARIANCES)?)));
        }
        if has(&UNCERTAINTIES) {
            return Ok(Some(Self::Uncertainties(numbers(file, UNCERTAINTIES)?)));
        }
        let common = has(&["u_mm"]).then(|| numbers(file, ["u_mm"])).transpose()?;
        Ok(common.map(|all| Self::Uncertainties(all.into_iter().map(|[u]| [u; 3]).collect())))
    }

    /// Intervals of the coordinates of a row, relative to the prediction.
    fn intervals(&self, row: usize) -> [[f64; 2]; 3] {
        let around = |u: f64| [-u, u].map(|u| normal_factor() * u);
        match self {
            Self::Covariances(all) => [0, 3, 5].map(|k| around(all[row][k].max(0.0).sqrt())),
            Self::Uncertainties(all) => all[row].map(around),
            Self::Ends(all) => all[row],
        }
    }

    /// Returns the share of positions within the ellipsoids of [`PROBABILITY`], for errors of these
    /// rows.
    fn ellipsoid_coverage(&self, rows: &[usize], errors: &[Vector]) -> Option<f64> {
        let Self::Covariances(all) = self else { return None };
        let limit = ChiSquared::new(3.0).ok()?.inverse_cdf(PROBABILITY);
        let is_within = |(&row, error): (&usize, &Vector)| {
            let [xx, xy, xz, yy, yz, zz] = all[row];
            let root = Cholesky::new(Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz))?;
            let error = Vector3::from(*error);
            Some(f64::from(error.dot(&root.solve(&error)) <= limit))
        };
        let within: Option<Vec<f64>> = rows.iter().zip(errors).map(is_within).collect();
        within.map(mean)
    }
}

/// Half width of an interval of [`PROBABILITY`], in standard uncertainties of a normal
/// distribution.
fn normal_factor() -> f64 {
    Normal::standard().inverse_cdf(0.5 + 0.5 * PROBABILITY)
}

/// Score of intervals of each row, each with the value that it predicts.
fn interval_scores(poses: &[PoseName], rows: &[Vec<([f64; 2], f64)>]) -> IntervalScore {
    let all = || rows.iter().flatten();
    let is_within = |(interval, value): &([f64; 2], f64)| interval[0] <= *value && *value <= interval[1];
    let mut by_pose: BTreeMap<PoseName, [f64; 2]> = BTreeMap::new();
    for (pose, row) in poses.iter().zip(rows) {
        let [within, count] = by_pose.entry(*pose).or_default();
        *within += row.iter().filter(|one| is_within(one)).count() as f64;
        *count += row.len() as f64;
    }
    let uncertainty = ratio_uncertainty(by_pose.values().copied());
    let coverage = mean(all().map(|one| f64::from(is_within(one))));
    IntervalScore {
        probability: PROBABILITY,
        count: all().count(),
        coverage,
        coverage_interval: share_interval(coverage, by_pose.len() as f64),
        coverage_standard_uncertainty: Some(uncertainty).filter(|u| u.is_finite()),
        mean_width: mean(all().map(|(interval, _)| interval[1] - interval[0])),
        mean_score: mean(all().map(|(interval, value)| interval_score(*interval, *value, 1.0 - PROBABILITY))),
    }
}

/// Returns the exact interval of a share of this number of trials, by quantiles of the beta
/// distribution (Clopper & Pearson 1934, Biometrika 26, 404); `None` without trials.
fn share_interval(share: f64, trials: f64) -> Option<[f64; 2]> {
    let (held, missed, tail) = (share * trials, (1.0 - share) * trials, 0.5 * (1.0 - PROBABILITY));
    let quantile = |a, b, p| Beta::new(a, b).ok().map(|of| of.inverse_cdf(p));
    let low = if held > 0.0 { quantile(held, missed + 1.0, tail)? } else { 0.0 };
    let high = if missed > 0.0 { quantile(held + 1.0, missed, 1.0 - tail)? } else { 1.0 };
    (trials > 0.0).then_some([low, high])
}

/// Errors of orientations.
struct Turned {
    /// Rotation vectors (deg) in the world from measured to predicted orientations.
    errors_deg: Vec<Vector>,
    /// Standard uncertainty (deg) about any axis of each row, if the predictions give it.
    uncertainties_deg: Option<Vec<f64>>,
}

/// Errors of the orientations; `None` if the two tables do not both contain orientations.
fn orientations(predicted: &TableFile, measured: &TableFile, rows: &[usize]) -> Result<Option<Turned>> {
    if ![predicted, measured].iter().all(|file| file.table.has(QUATERNION[0])) {
        return Ok(None);
    }
    let turn = |q: [f64; 4]| Pose::from_quaternion(q);
    let (found, seen) = (numbers(predicted, QUATERNION)?, numbers(measured, QUATERNION)?);
    let error = |(&row, seen): (&usize, [f64; 4])| {
        turn(found[row]).then(&turn(seen).inverse()).rotation_vector_rad().map(f64::to_degrees)
    };
    let stated = predicted.table.has(TURN).then(|| numbers(predicted, [TURN])).transpose()?;
    Ok(Some(Turned {
        errors_deg: rows.iter().zip(seen).map(error).collect(),
        uncertainties_deg: stated.map(|all| rows.iter().map(|&row| all[row][0]).collect()),
    }))
}

impl Turned {
    fn score(&self, poses: &[PoseName]) -> QuantityScore {
        let each = |(error, u): (&Vector, &f64)| {
            let half = normal_factor() * u;
            error.map(|e| ([-half, half], -e)).to_vec()
        };
        let intervals = self.uncertainties_deg.as_ref().map(|all| {
            let rows: Vec<_> = self.errors_deg.iter().zip(all).map(each).collect();
            interval_scores(poses, &rows)
        });
        QuantityScore {
            unit: "deg".to_owned(),
            errors: summarise(self.errors_deg.iter().map(|e| norm(*e)).collect()),
            intervals,
            ellipsoid_coverage: None,
        }
    }
}
