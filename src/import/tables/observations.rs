//! A table of observations as CSV: one row per pose, repeat and target, a column per joint with its unit.

use crate::base::message::{Message, Place, Problems, Result};
use crate::base::pose_name::{PoseName, two_spellings};
use crate::base::table::{COVARIANCES, UNCERTAINTIES, XYZ, pose_column};
use crate::import::format::{Decimal, Delimiter, Dialect, two_commas};
use crate::import::guess::guesses;
use crate::import::lexer::{Row, WHOLE, number, pose_name, rows};
use crate::import::logs::meaning;
use polars::prelude::{Column, DataFrame, NamedFrom, Series};
use std::borrow::Cow;

/// Marks of a table: what separates its columns, and the decimal mark.
#[derive(Clone, Copy, Debug)]
pub struct Marks {
    /// What separates the columns.
    pub delimiter: Delimiter,
    /// Decimal mark.
    pub decimal: Decimal,
}

impl Default for Marks {
    fn default() -> Self {
        Self { delimiter: Delimiter::Comma, decimal: Decimal::Point }
    }
}

/// Reads a table of observations (commas, decimal point, a header): [`observations_with`].
pub fn observations(file: &str, text: &str) -> Result<DataFrame> {
    observations_with(file, text, Marks::default())
}

/// Reads a table of observations with a header: its columns, and `line` with the line of each row.
///
/// `pose` holds names of poses, `cycle` whole numbers, columns whose name ends in a unit numbers (empty cells are missing values),
/// others text. Every row of another width and every cell that does not read is an error with its place.
pub fn observations_with(file: &str, text: &str, marks: Marks) -> Result<DataFrame> {
    if (marks.delimiter, marks.decimal) == (Delimiter::Comma, Decimal::Comma) {
        return Err(two_commas().at(Place::file(file)).into());
    }
    let mut all = rows(file, text, marks.delimiter)?;
    if all.len() < 2 {
        return Err(Message::error("the table has no rows").at(Place::file(file)).expected("a header and rows").into());
    }
    if all[0].fields.len() == 1
        && let Some(Dialect { delimiter: Some(delimiter), decimal, .. }) =
            guesses(text, None).first().map(|g| &g.dialect)
        && *delimiter != marks.delimiter
    {
        let message = Message::error(format!("separated by `{}`, the rows have one column", marks.delimiter.name()));
        let hint = format!(
            "`{}` with decimal `{}` separates them: `etalon identify` reads them so with --delimiter and --decimal; or save the \
             table with commas and decimal points",
            delimiter.name(),
            decimal.name()
        );
        return Err(message.at(all[0].place(file)).hint(hint).into());
    }
    let mut header = all.remove(0);
    let factors: Vec<f64> = header.fields.iter_mut().map(in_mm).collect();
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
        if meaning(name).is_none() && !COVARIANCES.contains(&name.as_ref()) {
            columns.push(Series::new(name.as_ref().into(), texts.collect::<Vec<_>>()).into());
            continue;
        }
        if name == "pose" {
            let named = poses(file, &all, i, marks.decimal, &mut problems);
            columns.push(pose_column("pose", &named));
            continue;
        }
        let whole = name == "cycle";
        let mut values: Vec<Option<f64>> = Vec::with_capacity(all.len());
        for (row, field) in all.iter().zip(texts) {
            let odd = |v: &f64| whole && (v.fract() != 0.0 || v.abs() > WHOLE);
            let value = match number(field, marks.decimal) {
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
            false => {
                let in_unit =
                    |value: Option<f64>| value.map(|value| if factors[i] == 1.0 { value } else { value * factors[i] });
                Series::new(name.as_ref().into(), values.into_iter().map(in_unit).collect::<Vec<_>>()).into()
            }
        });
    }
    problems.0.sort_by_key(|m| m.place.as_ref().map(|p| (p.line, p.column)));
    problems.check()?;
    Ok(DataFrame::new(all.len(), columns)?)
}

/// Gives a column of coordinates or of their uncertainties its name in millimetres (`x_m` is `x_mm`), and what takes its values there.
fn in_mm(name: &mut Cow<str>) -> f64 {
    let known = |name: &str| XYZ.contains(&name) || UNCERTAINTIES.contains(&name);
    match meaning(name) {
        Some((millimetres, factor)) if known(&millimetres) => {
            *name = Cow::Owned(millimetres);
            factor
        }
        _ => 1.0,
    }
}

/// The names of poses in column `at`, each in one spelling.
fn poses(file: &str, rows: &[Row], at: usize, decimal: Decimal, problems: &mut Problems) -> Vec<Option<PoseName>> {
    let mut name = |row: &Row| match row.field(at) {
        "" => None,
        field => pose_name(field, decimal).map_err(|message| problems.0.push(message.at(row.cell(file, at)))).ok(),
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
