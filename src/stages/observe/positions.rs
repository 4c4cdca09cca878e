//! Measured positions of a table, and observations from measured positions with a message for every
//! contradiction.

use crate::stages::observe::resolution;
use etalon_base::message::{Message, Place, Result};
use etalon_base::{error, phrase, warning};
use etalon_formats::table::{COVARIANCES, Table, UNCERTAINTIES, XYZ};
use etalon_formats::tables::joints::{joint_values, stated_modes};
use etalon_identify::{
    AssumedModes, Contradiction, Covariance, Distances, Measured, Observation, ObservationError, is_positive_definite,
};
use etalon_robots::Robot;

/// Observations of `robot` from a table with one row per pose, cycle and target. Assembly modes
/// derived from the measurement are in `messages`.
pub fn observations(robot: &dyn Robot, table: &Table, messages: &mut Vec<Message>) -> Result<Vec<Observation>> {
    let table = &*resolution::replace_table_zeros(table, messages)?;
    grouped(robot, &positions(robot, table)?, messages, |row| table.place(row))
}

/// Observations of measured positions; `place` is the file and line of a position.
pub fn grouped(
    robot: &dyn Robot,
    measured: &[Measured],
    messages: &mut Vec<Message>,
    place: impl Fn(usize) -> Place,
) -> Result<Vec<Observation>> {
    match Observation::group(robot, measured) {
        Ok((observations, assumed)) => {
            messages.extend(assumed.map(assumed_modes_warning));
            Ok(observations)
        }
        Err(ObservationError::Contradiction(row, what)) => {
            let m = &measured[row];
            let error = match what {
                Contradiction::NotFinite => error!("table-value-missing"),
                Contradiction::OtherJoints => error!("joints-of-pose-differ"),
                Contradiction::MeasuredTwice => {
                    let message = error!("target-repeated", target = robot.targets()[m.target]);
                    match measured[..row].iter().position(|other| other == m).and_then(|first| place(first).line) {
                        Some(line) => message.hint(phrase!("row-repeats", line)),
                        None => message,
                    }
                }
            };
            Err(error.within(phrase!("in-observation", pose = m.pose, cycle = m.cycle)).at(place(row)).into())
        }
        Err(ObservationError::Empty) => Err(error!("no-observations").into()),
        Err(ObservationError::ArmsApart(pose, cycle)) => {
            Err(error!("arms-apart").within(phrase!("in-observation", pose, cycle)).into())
        }
        Err(ObservationError::BothModes(pose, cycle, d)) => {
            let error = error!("assembly-mode-ambiguous", near_mm = d.near_mm, far_mm = d.far_mm);
            Err(error.within(phrase!("in-observation", pose, cycle)).into())
        }
    }
}

/// Returns a warning about assembly modes derived from the measurement.
fn assumed_modes_warning(assumed: AssumedModes) -> Message {
    let AssumedModes { positive, negative, least_clear: (pose, Distances { near_mm, far_mm }) } = assumed;
    warning!("assembly-modes-assumed", count = positive + negative, positive, negative, pose, near_mm, far_mm)
}

/// The measured positions of a table, in the order of its rows.
fn positions(robot: &dyn Robot, table: &Table) -> Result<Vec<Measured>> {
    let needed = ["pose", "cycle", "target"].into_iter().chain(XYZ[..robot.dimension()].iter().copied());
    let joints = joint_values(robot, table, &needed.collect::<Vec<_>>())?;
    let (poses, cycles) = (table.poses()?, table.integers("cycle")?);
    let (names, xyz) = (table.texts("target")?, table.positions()?);
    let modes = stated_modes(robot, table)?;
    let covariances = covariances(table, robot.dimension())?;
    let position = |(row, joints): (usize, Vec<f64>)| {
        let (pose, cycle, name) = (poses[row], cycles[row], &*names[row]);
        let target = robot.targets().iter().position(|t| t == name).ok_or_else(|| {
            let message = error!("not-of-this-robot", name, kind = "target");
            let message = message.within(phrase!("in-observation", pose, cycle));
            let message = message.at(table.place(row));
            message.hint_names(name, robot.targets().iter().map(String::as_str))
        })?;
        let (at_mm, covariance_mm2, assembly) = (xyz[row], covariances[row], modes[row]);
        Ok(Measured { pose, cycle, target, at_mm, covariance_mm2, joints, assembly, time_s: None })
    };
    joints.into_iter().enumerate().map(position).collect()
}

/// Column of the standard uncertainty of every coordinate (mm).
const ANY_AXIS: &str = "u_mm";

/// Plausible standard uncertainties (mm) of a coordinate.
const PLAUSIBLE_MM: std::ops::RangeInclusive<f64> = 2e-5..=100.0;

/// The covariance of each row's position, by its columns `ux_mm uy_mm [uz_mm]` or `cxx_mm2 cxy_mm2
/// .. czz_mm2`; `None` in rows that leave them empty.
///
/// # Errors
/// Reports rows that state only some of them, impossible values of a coordinate, and covariances
/// that are not positive definite.
fn covariances(table: &Table, dimension: usize) -> Result<Vec<Option<Covariance>>> {
    let has = |names: &[&str]| names.iter().any(|name| table.has(name));
    let is_one = has(&[ANY_AXIS]) && !has(&UNCERTAINTIES) && !has(&COVARIANCES);
    let (by_axis, whole) = (is_one || has(&UNCERTAINTIES), has(&COVARIANCES));
    if !by_axis && !whole {
        return Ok(vec![None; table.height()]);
    }
    if by_axis && whole {
        return Err(error!("uncertainties-twice").at(table.header()).into());
    }
    // rows and columns of the matrix by the order of the names
    let all: Vec<(&str, usize, usize)> = match by_axis {
        true => UNCERTAINTIES.iter().enumerate().map(|(i, name)| (*name, i, i)).collect(),
        false => {
            (0..3).flat_map(|i| (i..3).map(move |j| (i, j))).zip(COVARIANCES).map(|((i, j), n)| (n, i, j)).collect()
        }
    };
    let needed: Vec<_> = all.into_iter().filter(|(_, i, j)| *i.max(j) < dimension).collect();
    let read = || needed.iter().map(|(name, ..)| if is_one { ANY_AXIS } else { *name });
    table.require(read())?;
    let columns = read().map(|name| table.numbers(name)).collect::<Result<Vec<_>>>()?;
    let of_row = |row: usize| -> Result<Option<Covariance>> {
        let at = || table.place(row);
        let values: Vec<f64> = columns.iter().map(|column| column[row]).collect();
        if values.iter().all(|v| v.is_nan()) {
            return Ok(None);
        }
        let mut covariance = [[0.0; 3]; 3];
        for ((name, i, j), value) in needed.iter().zip(&values) {
            let squared = if by_axis { value * value } else { *value };
            if value.is_nan() || i == j && !(PLAUSIBLE_MM.contains(&squared.sqrt()) && *value > 0.0) {
                let message = match value.is_nan() {
                    true => error!("coordinate-uncertainty-missing", column = name),
                    false => error!("coordinate-uncertainty-unusable", column = name, value),
                };
                return Err(message.at(at()).into());
            }
            (covariance[*i][*j], covariance[*j][*i]) = (squared, squared);
        }
        match is_positive_definite(&covariance, dimension) {
            true => Ok(Some(covariance)),
            false => Err(error!("position-covariance-invalid").at(at()).into()),
        }
    };
    (0..table.height()).map(of_row).collect()
}
