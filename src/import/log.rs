//! Encoder logs as CSV: pose, cycle or time, and the joints with the units that the campaign states.

use super::delimited::{Row, WHOLE, cell_place, number, rows};
use super::formats::propose;
use crate::campaign::{Campaign, Column, Log};
use crate::document::Source;
use crate::message::{Message, Place, Problems, Result};
use crate::robots::{Joint, Quantity};
use crate::table::{ASSEMBLY, LABEL};
use polars::prelude::{DataFrame, NamedFrom, Series};

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

/// What a key of `columns` becomes: the name of the column in the table, and the factor of its values.
pub(crate) fn meaning(key: &str) -> Option<(String, f64)> {
    match key {
        "pose" | "cycle" | "time_s" | LABEL | ASSEMBLY => Some((key.to_owned(), 1.0)),
        _ => {
            let (name, unit) = key.rsplit_once('_')?;
            let quantity = [Quantity::Length, Quantity::Angle].into_iter().find(|q| factor(unit, *q).is_some())?;
            Some((format!("{name}_{}", quantity.unit()), factor(unit, quantity)?))
        }
    }
}

/// Reads a log: `row line pose cycle time_s label` where stated, and the joints in mm or deg.
pub(super) fn read(campaign: &Campaign, log: &Log, text: &str, source: &mut Source) -> Result<DataFrame> {
    let file = log.file.get_ref().as_str();
    source.dialect = format!("delimited by `{}`, decimal `{}`", log.delimiter.name(), log.decimal.name());
    let mut all = rows(file, text, log.delimiter, None)?;
    let header = if log.header && !all.is_empty() { Some(all.remove(0)) } else { None };
    if all.is_empty() {
        return Err(Message::error(format!("log `{file}` holds no rows"))
            .at(campaign.place(&log.file))
            .hint("record it again, or state `header = false` if its only row holds values")
            .into());
    }
    source.rows_read = all.len();
    let mut problems = Problems::default();
    let lines: Vec<&str> = text.lines().collect();
    let width = header.as_ref().unwrap_or(&all[0]).fields.len();
    for row in all.iter().filter(|r| r.fields.len() != width) {
        let shown = lines.get(row.line - 1).copied().unwrap_or("");
        problems.0.push(
            Message::error(format!("the row has {} fields", row.fields.len()))
                .at(Place::line(file, row.line, shown))
                .expected(format!("{width}, as the first row"))
                .hint("a decimal comma in a file separated by commas? then state `delimiter` and `decimal`"),
        );
    }
    if width == 1 && log.columns.len() > 1 {
        let what = format!("log `{file}` has one column, of which the campaign names {}", log.columns.len());
        let message = Message::error(what)
            .at(Place::line(file, 1, lines.first().copied().unwrap_or("")))
            .expected(format!("columns separated by `{}`, decimal `{}`", log.delimiter.name(), log.decimal.name()));
        let hint = match propose(file, text).readings.first() {
            Some(r) => {
                format!("`delimiter = {:?}` and `decimal = {:?}` read its rows: state them", r.delimiter, r.decimal)
            }
            None => "state `delimiter` and `decimal` of the log, as its rows have them".to_owned(),
        };
        return Err(message.hint(hint).into());
    }
    let count = all.len();
    let counted = |name: &str, f: &dyn Fn(usize, &Row) -> i64| {
        Series::new(name.into(), all.iter().enumerate().map(|(i, r)| f(i, r)).collect::<Vec<i64>>()).into()
    };
    let mut columns = vec![counted("row", &|i, _| i as i64 + 1), counted("line", &|_, r| r.line as i64)];
    if log.pose.is_some() {
        columns.push(counted("pose", &|i, _| i as i64 + 1));
    }
    for (key, column) in &log.columns {
        let at = || campaign.place(key);
        let Some((name, factor)) = meaning(key.get_ref()) else {
            problems.0.push(
                Message::error(format!("`{}` states no unit that a joint can have", key.get_ref())).at(at()).expected(
                    "`pose`, `cycle`, `time_s`, `label`, or a joint with its unit like `q1_deg`, `q1_rad`, `rho1_mm`",
                ),
            );
            continue;
        };
        if columns.iter().any(|c: &polars::prelude::Column| c.name() == name.as_str()) {
            let message = Message::error(format!("`{}` states `{name}` once more", key.get_ref()));
            problems
                .0
                .push(message.at(at()).hint("a joint has one column, and `pose = \"row\"` needs none for the pose"));
            continue;
        }
        let index = match place_of(column, header.as_ref(), width) {
            Ok(index) => index,
            Err(message) => {
                problems.0.push(message.at(at()));
                continue;
            }
        };
        if name == LABEL {
            let cell = |row: &Row| row.fields.get(index).cloned().unwrap_or_default();
            columns.push(Series::new(LABEL.into(), all.iter().map(cell).collect::<Vec<String>>()).into());
            continue;
        }
        let mut values = Vec::with_capacity(count);
        for row in &all {
            let shown = lines.get(row.line - 1).copied().unwrap_or("");
            let cell = row.fields.get(index).map(String::as_str).unwrap_or("");
            match number(cell, log.decimal) {
                Ok(value) => values.push(value * factor),
                Err(message) => {
                    let unread = "every row needs its values: read it from the controller again, or remove the row";
                    let hint = message.hint.clone().unwrap_or_else(|| unread.to_owned());
                    problems.0.push(message.at(cell_place(file, row, shown, index)).hint(hint));
                }
            }
        }
        if name == ASSEMBLY && values.len() == count {
            for (value, row) in values.iter().zip(&all).filter(|(v, _)| v.abs() != 1.0) {
                let shown = lines.get(row.line - 1).copied().unwrap_or("");
                let message = Message::error(format!("{value} is no assembly mode")).expected("1 or -1");
                let hint = "leave the column out of `columns` if it is not known: then the nearer solution is taken";
                problems.0.push(message.at(cell_place(file, row, shown, index)).hint(hint));
            }
        }
        if name == "pose" || name == "cycle" {
            for (value, row) in values.iter().zip(&all).filter(|(v, _)| v.fract() != 0.0 || v.abs() > WHOLE) {
                let shown = lines.get(row.line - 1).copied().unwrap_or("");
                let message = Message::error(format!("{name} {value} is no whole number"));
                problems.0.push(message.at(cell_place(file, row, shown, index)));
            }
            let whole: Vec<i64> = values.iter().map(|v| *v as i64).collect();
            columns.push(Series::new(name.as_str().into(), whole).into());
        } else {
            columns.push(Series::new(name.as_str().into(), values).into());
        }
    }
    problems.check()?;
    Ok(DataFrame::new(count, columns)?)
}

/// Index of a column, by its number or by its name in the header.
fn place_of(column: &Column, header: Option<&Row>, width: usize) -> std::result::Result<usize, Message> {
    match (column, header) {
        (Column::Number(n), _) if *n > width => {
            Err(Message::error(format!("the log has {width} columns, none of them is number {n}")))
        }
        (Column::Number(n), _) => Ok(n - 1),
        (Column::Name(name), Some(header)) => {
            let places: Vec<usize> = (0..header.fields.len()).filter(|&i| header.fields[i] == *name).collect();
            match places[..] {
                [one] => Ok(one),
                [] => Err(Message::error(format!("the header has no column `{name}`"))
                    .hint_names(name, header.fields.iter().map(String::as_str))),
                _ => Err(Message::error(format!("the header names `{name}` {} times", places.len()))
                    .hint("give the number of the column instead of its name")),
            }
        }
        (Column::Name(name), None) => Err(Message::error(format!("the log has no header that could name `{name}`"))
            .hint("give the number of the column instead of its name, or remove `header = false`")),
    }
}
