//! A table of observations as CSV: one row per pose, repeat and target, a column per joint with its unit.

use crate::base::message::{Message, Place, Problems, Result};
use crate::import::format::Decimal;
use crate::import::format::Delimiter;
use crate::import::lexer::{Row, WHOLE, number, pose_number, rows};
use crate::import::logs::meaning;
use polars::prelude::{Column, DataFrame, NamedFrom, Series};
use std::collections::BTreeMap;

/// Reads a table of observations (commas, decimal point, a header): its columns, and `line` with the line of each row.
///
/// `pose` and `cycle` hold whole numbers (a pose also a name that ends in one, like `P12`), columns whose name ends in a unit hold
/// numbers (empty cells are missing values), others text. Every row of another width and every cell that does not read is an error
/// with its place.
pub fn observations(file: &str, text: &str) -> Result<DataFrame> {
    let mut all = rows(file, text, Delimiter::Comma)?;
    if all.len() < 2 {
        return Err(Message::error("the table has no rows").at(Place::file(file)).expected("a header and rows").into());
    }
    let header = all.remove(0);
    let mut problems = Problems::default();
    for (i, name) in header.fields.iter().enumerate().filter(|(i, name)| header.fields[..*i].contains(name)) {
        let message = Message::error(format!("the header names `{name}` twice"));
        problems.0.push(message.at(header.cell(file, i)));
    }
    let width = header.fields.len();
    for row in all.iter().filter(|row| row.fields.len() != width) {
        let message = Message::error(format!("the row has {} fields", row.fields.len()));
        problems.0.push(message.at(row.place(file)).expected(format!("{width}, as the header")));
    }
    let mut columns: Vec<Column> =
        vec![Series::new("line".into(), all.iter().map(|row| row.line as i64).collect::<Vec<i64>>()).into()];
    for (i, name) in header.fields.iter().enumerate().filter(|(_, name)| *name != "line") {
        let texts = all.iter().map(|row| row.field(i));
        if meaning(name).is_none() {
            columns.push(Series::new(name.as_ref().into(), texts.collect::<Vec<_>>()).into());
            continue;
        }
        if name == "pose" {
            problems.0.extend(two_names(file, &all, i));
        }
        let whole = name == "pose" || name == "cycle";
        let mut values: Vec<Option<f64>> = Vec::with_capacity(all.len());
        for (row, field) in all.iter().zip(texts) {
            let odd = |v: &f64| whole && (v.fract() != 0.0 || v.abs() > WHOLE);
            let field = if name == "pose" { pose_number(field) } else { field };
            let value = match number(field, Decimal::Point) {
                _ if field.is_empty() => Ok(None),
                Ok(value) if odd(&value) => Err(Message::error(format!("`{field}` is not a whole number"))),
                read => read.map(Some),
            };
            values.push(value.unwrap_or_else(|message| {
                problems.0.push(message.at(row.cell(file, i)));
                None
            }));
        }
        columns.push(match whole {
            true => {
                Series::new(name.as_ref().into(), values.iter().map(|v| v.map(|v| v as i64)).collect::<Vec<_>>()).into()
            }
            false => Series::new(name.as_ref().into(), values).into(),
        });
    }
    problems.0.sort_by_key(|m| m.place.as_ref().map(|p| (p.line, p.column)));
    problems.check()?;
    Ok(DataFrame::new(all.len(), columns)?)
}

/// Errors about poses of one number and different names in column `at`.
fn two_names(file: &str, rows: &[Row], at: usize) -> Vec<Message> {
    let mut names: BTreeMap<&str, &str> = BTreeMap::new();
    let mut errors = Vec::new();
    for row in rows {
        let name = row.field(at);
        let number = pose_number(name);
        let before = &name[..name.len() - number.len()];
        if let Some(other) = names.insert(number.trim_start_matches('0'), before).filter(|other| *other != before) {
            let message = Message::error(format!("`{other}{number}` and `{name}` are both pose {number}"));
            errors.push(message.hint("number the poses from 1 to the last, each once").at(row.cell(file, at)));
        }
    }
    errors
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_names_of_one_pose_are_refused() {
        assert_eq!(observations("o.csv", "pose,x_mm\nP01,1\nP1,2\nP2,3\n").unwrap().height(), 3);
        let said = observations("o.csv", "pose,x_mm\nA1,1\nB1,2\n").unwrap_err().to_string();
        assert!(said.contains("`A1` and `B1` are both pose 1") && said.contains("o.csv:3"), "{said}");
    }
}
