//! A table of observations as CSV: one row per pose, repeat and target, a column per joint with its unit.

use crate::base::message::{Message, Place, Problems, Result};
use crate::base::pose_name::{PoseName, two_spellings};
use crate::base::table::pose_column;
use crate::import::format::Decimal;
use crate::import::format::Delimiter;
use crate::import::lexer::{Row, WHOLE, number, pose_name, rows};
use crate::import::logs::meaning;
use polars::prelude::{Column, DataFrame, NamedFrom, Series};

/// Reads a table of observations (commas, decimal point, a header): its columns, and `line` with the line of each row.
///
/// `pose` holds names of poses, `cycle` whole numbers, columns whose name ends in a unit numbers (empty cells are missing values),
/// others text. Every row of another width and every cell that does not read is an error with its place.
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
            let named = poses(file, &all, i, &mut problems);
            columns.push(pose_column("pose", &named));
            continue;
        }
        let whole = name == "cycle";
        let mut values: Vec<Option<f64>> = Vec::with_capacity(all.len());
        for (row, field) in all.iter().zip(texts) {
            let odd = |v: &f64| whole && (v.fract() != 0.0 || v.abs() > WHOLE);
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

/// The names of poses in column `at`, each in one spelling.
fn poses(file: &str, rows: &[Row], at: usize, problems: &mut Problems) -> Vec<Option<PoseName>> {
    let mut name = |row: &Row| match row.field(at) {
        "" => None,
        field => {
            pose_name(field, Decimal::Point).map_err(|message| problems.0.push(message.at(row.cell(file, at)))).ok()
        }
    };
    let names: Vec<Option<PoseName>> = rows.iter().map(&mut name).collect();
    if let Some((message, row)) = two_spellings(names.iter().copied()) {
        problems.0.push(message.at(rows[row].cell(file, at)));
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pose_has_one_spelling() {
        let table = observations("o.csv", "pose,x_mm\n07,1\n7,2\nP7,3\nhome,4\n").unwrap();
        let names: Vec<String> = crate::base::table::poses(&table).unwrap().iter().map(ToString::to_string).collect();
        assert_eq!(names, ["7", "7", "P7", "home"]);
        let error = observations("o.csv", "pose,x_mm\nP01,1\nA1,2\nP1,2\n").unwrap_err().to_string();
        assert!(error.contains("`P01` and `P1` differ only in") && error.contains("o.csv:4"), "{error}");
    }
}
