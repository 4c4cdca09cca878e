//! A table of observations as CSV: one row per pose, repeat and target, a column per joint with its unit.

use crate::dialect::{Decimal, Delimiter, Dialect, FromRow, two_commas};
use crate::guess::guesses;
use crate::lexer::{Row, WHOLE, number, pose_name, rows};
use crate::logs::meaning;
use crate::table::{COVARIANCES, QUATERNION, TEXTS, UNCERTAINTIES, XYZ, failed, frame, pose_column};
use etalon_base::cell::is_formula;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose_name::{PoseName, two_spellings};
use polars::prelude::{Column, DataFrame, NamedFrom, Series};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// How a table of observations is laid out, where it is not as this program writes one.
#[derive(Clone, Debug)]
pub struct TableLayout {
    /// What separates the columns.
    pub delimiter: Delimiter,
    /// Decimal mark.
    pub decimal: Decimal,
    /// The heading in the file of each column that is called otherwise there.
    pub columns: BTreeMap<String, String>,
    /// The target of all rows, of a table without such a column.
    pub target: Option<String>,
    /// The pose of each row, of a table without such a column.
    pub pose: Option<FromRow>,
}

impl Default for TableLayout {
    fn default() -> Self {
        let (delimiter, decimal) = (Delimiter::Comma, Decimal::Point);
        Self { delimiter, decimal, columns: BTreeMap::new(), target: None, pose: None }
    }
}

impl TableLayout {
    /// Gives columns the names that they have here.
    fn rename(&self, file: &str, header: &mut Row) -> Result<()> {
        let mut problems = Problems::default();
        let headings: Vec<String> = header.fields.iter().map(|field| field.trim().to_owned()).collect();
        for (name, heading) in &self.columns {
            let known = meaning(name).is_some()
                || [&TEXTS[..], &QUATERNION, &COVARIANCES].iter().any(|names| names.contains(&name.as_str()));
            let column = headings.iter().position(|h| h == heading);
            let message = match column {
                _ if !known => Message::error(format!("`{name}` is not a column of observations")).hint(
                    "coordinates and joints end with their unit: x_mm, q1_deg; docs/observations.md has all columns",
                ),
                None => Message::error(format!("the header names no `{heading}`"))
                    .hint_names(heading, headings.iter().map(String::as_str)),
                Some(i) if header.fields[i] != headings[i] => {
                    Message::error(format!("`{heading}` is stated to be `{}` and `{name}`", header.fields[i]))
                }
                Some(i) => {
                    header.fields[i] = Cow::Owned(name.clone());
                    continue;
                }
            };
            problems.0.push(message.at(header.place(file)));
        }
        problems.check().map(drop)
    }

    /// Adds the columns that every observation needs, where the table has none.
    fn complete(&self, file: &str, mut table: DataFrame) -> Result<DataFrame> {
        let height = table.height();
        let has = |name: &str| table.column(name).is_ok();
        for (name, stated) in [("target", self.target.is_some()), ("pose", self.pose.is_some())] {
            if stated && has(name) {
                let message = Message::error(format!("`{name}` is stated, and the table has such a column"));
                return Err(message.at(Place::file(file)).hint("state one of them").into());
            }
        }
        let mut added: Vec<Column> = Vec::new();
        if let Some(target) = &self.target {
            added.push(Series::new("target".into(), vec![target.as_str(); height]).into());
        }
        if let Some(from) = self.pose {
            let named: Vec<_> = (1..=height as i64).map(|row| Some(PoseName::from(from.number(row)))).collect();
            added.push(pose_column("pose", &named));
        }
        if !has("cycle") {
            added.push(Series::new("cycle".into(), vec![1i64; height]).into());
        }
        table.hstack_mut(&added).map_err(failed)?;
        Ok(table)
    }
}

/// Reads a table with commas, decimal points and a header: its columns, and `line` with the line of each row.
///
/// `pose` holds names of poses, `cycle` whole numbers, columns whose name ends in a unit numbers (empty cells are missing values),
/// others text. Every row of another width and every cell that does not read is an error with its place.
pub fn observations(file: &str, text: &str) -> Result<DataFrame> {
    read(file, text, &TableLayout::default())
}

/// [`observations`] in another layout: repeats are 1 where the table has no column `cycle`.
pub fn observations_with(file: &str, text: &str, layout: &TableLayout) -> Result<DataFrame> {
    layout.complete(file, read(file, text, layout)?)
}

fn read(file: &str, text: &str, layout: &TableLayout) -> Result<DataFrame> {
    if (layout.delimiter, layout.decimal) == (Delimiter::Comma, Decimal::Comma) {
        return Err(two_commas().at(Place::file(file)).into());
    }
    let mut all = rows(file, text, layout.delimiter)?;
    if all.len() < 2 {
        return Err(Message::error("the table has no rows").at(Place::file(file)).expected("a header and rows").into());
    }
    if all[0].fields.len() == 1
        && let Some(Dialect { delimiter: Some(delimiter), decimal, .. }) =
            guesses(text, None).first().map(|g| &g.dialect)
        && *delimiter != layout.delimiter
    {
        let message = Message::error(format!("separated by `{}`, the rows have one column", layout.delimiter.name()));
        let hint = format!(
            "`{}` with decimal `{}` separates them: state `delimiter` and `decimal` in [observations], or --delimiter and --decimal; or \
             save the table with commas and decimal points",
            delimiter.name(),
            decimal.name()
        );
        return Err(message.at(all[0].place(file)).hint(hint).into());
    }
    let mut header = all.remove(0);
    layout.rename(file, &mut header)?;
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
        if meaning(name).is_none() && ![&COVARIANCES[..], &QUATERNION].iter().any(|n| n.contains(&name.as_ref())) {
            columns.push(Series::new(name.as_ref().into(), texts.collect::<Vec<_>>()).into());
            continue;
        }
        if name == "pose" {
            let named = poses(file, &all, i, layout.decimal, &mut problems);
            columns.push(pose_column("pose", &named));
            continue;
        }
        let whole = name == "cycle";
        let mut values: Vec<Option<f64>> = Vec::with_capacity(all.len());
        for (row, field) in all.iter().zip(texts) {
            let odd = |v: &f64| whole && (v.fract() != 0.0 || v.abs() > WHOLE);
            let value = match number(field, layout.decimal) {
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
    refuse_formulas(file, &header, &all, &mut problems);
    problems.0.sort_by_key(|m| m.place.as_ref().map(|p| (p.line, p.column)));
    problems.check()?;
    frame(all.len(), columns)
}

/// Errors about names that a spreadsheet would take for formulas: they are written to tables again.
fn refuse_formulas(file: &str, header: &Row, rows: &[Row], problems: &mut Problems) {
    let named = |i: &usize| TEXTS.contains(&header.field(*i));
    for (i, row) in (0..header.fields.len()).filter(named).flat_map(|i| rows.iter().map(move |row| (i, row))) {
        let (column, name) = (header.field(i), row.field(i));
        if is_formula(name) {
            let message = Message::error(format!("the {column} `{name}` would be a formula in a spreadsheet"));
            problems.0.push(message.at(row.cell(file, i)).hint("give it another name"));
        }
    }
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
        let names: Vec<String> = crate::table::poses(&table).unwrap().iter().map(ToString::to_string).collect();
        assert_eq!(names, ["7", "7", "P7", "home"]);
        let error = observations("o.csv", "pose,x_mm\nP01,1\nA1,2\nP1,2\n").unwrap_err().to_string();
        assert!(error.contains("`P01` and `P1` differ only in") && error.contains("o.csv:4"), "{error}");
    }
}
