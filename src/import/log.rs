//! Logs: pose, cycle or time, and the joints with the units that the campaign states.

use super::logs::{self, Columns, Values};
use super::standstill;
use crate::base::message::{Message, Result, Stated};
use crate::base::table::{ASSEMBLY, LABEL};
use crate::document::Source;
use crate::import::format::Log;
use crate::math::robots::{Joint, Quantity};
use polars::prelude::{Column, DataFrame};

/// Keys of `columns` that bring the time, and seconds in one of their unit.
const TIMES: [(&str, f64); 3] = [("time_s", 1.0), ("time_ms", 1e-3), ("time_ns", 1e-9)];

/// Factor from a unit to mm or deg.
fn factor(unit: &str, quantity: Quantity) -> Option<f64> {
    match (quantity, unit) {
        (Quantity::Length, "mm") | (Quantity::Angle, "deg") => Some(1.0),
        (Quantity::Length, "m") => Some(1000.0),
        (Quantity::Length, "um") => Some(0.001),
        (Quantity::Angle, "rad") => Some(180.0 / std::f64::consts::PI),
        _ => None,
    }
}

/// Whether a key of `columns` states this joint, in whatever unit: `q1_deg`, `q1_rad`.
pub fn is_joint_column(key: &str, joint: &Joint) -> bool {
    key.rsplit_once('_').is_some_and(|(name, unit)| name == joint.name && factor(unit, joint.quantity).is_some())
}

/// Whether a key of `columns` is one that the log of any robot can have.
pub(crate) fn is_common_column(key: &str) -> bool {
    ["pose", "cycle", LABEL, ASSEMBLY].contains(&key) || TIMES.iter().any(|(name, _)| *name == key)
}

/// What a key of `columns` becomes: the name of the column in the table, and the factor of its values.
pub(crate) fn meaning(key: &str) -> Option<(String, f64)> {
    if let Some((_, seconds)) = TIMES.iter().find(|(name, _)| *name == key) {
        return Some(("time_s".to_owned(), *seconds));
    }
    if is_common_column(key) {
        return Some((key.to_owned(), 1.0));
    }
    let (name, unit) = key.rsplit_once('_')?;
    let quantity = [Quantity::Length, Quantity::Angle].into_iter().find(|q| factor(unit, *q).is_some())?;
    Some((format!("{name}_{}", quantity.unit()), factor(unit, quantity)?))
}

/// Reads a log: `row line pose cycle time_s label` where stated, and the joints in mm or deg; and what is to be said of
/// it. Where the campaign states when the robot stands, one row for each standstill with `from_s` and `to_s`.
pub(crate) fn read(stated: Stated, log: &Log, text: &str, source: &mut Source) -> Result<(DataFrame, Vec<Message>)> {
    let Columns { rows, lines, columns, said } = logs::columns(stated, log, text, source)?;
    let count = rows.len();
    let mut table = vec![Column::new("row".into(), rows.clone()), Column::new("line".into(), lines)];
    if log.pose.is_some() {
        table.push(Column::new("pose".into(), rows.clone()));
    }
    if let Some(period_s) = log.period_s {
        table.push(Column::new("time_s".into(), rows.iter().map(|r| (r - 1) as f64 * period_s).collect::<Vec<_>>()));
    }
    for (name, values) in columns {
        table.push(match values {
            Values::Text(texts) => Column::new(name.as_str().into(), texts),
            Values::Real(values) if name == "pose" || name == "cycle" => {
                Column::new(name.as_str().into(), values.iter().map(|v| *v as i64).collect::<Vec<_>>())
            }
            Values::Real(values) => Column::new(name.as_str().into(), values),
        });
    }
    let table = DataFrame::new(count, table)?;
    Ok(match &log.standstill {
        Some(still) => (standstill::reduce(stated, log, still, &table, source)?, said),
        None => (table, said),
    })
}
