//! Tables of observations: one row per pose, repeat and target, a column per joint with its unit.

use crate::logs::meaning;
use crate::table::{self, COVARIANCES, FLANGE, MATRIX, QUATERNION, TEXTS, Table, UNCERTAINTIES, Values, XYZ};
use etalon_base::cell::is_formula;
use etalon_base::error;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose_name::{PoseName, two_spellings};
use etalon_tables::lexer::{Row, column_index, pose_name};
use etalon_tables::sheet::{Sheet, column};
use etalon_tables::{ColumnSource, Expression, TableLayout};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Table to read: its layout, and what it contains.
#[derive(Clone, Debug, Default)]
pub struct TableReading {
    /// Layout of the table.
    pub layout: TableLayout,
    /// `true` if columns that the file does not contain are omitted, for several tables with one
    /// layout.
    pub lenient: bool,
    /// `true` for tables of poses, loads or joints, whose columns may have any name; other tables
    /// contain observations, with known columns and a repeat.
    pub any_columns: bool,
    /// Coverage factor of the columns of uncertainties, if they are expanded.
    pub coverage_factor: Option<f64>,
    /// Target of all rows, for a table without the column.
    pub target: Option<String>,
}

impl TableReading {
    /// Rules for reading a table of poses, loads or joints, whose columns may have any name.
    pub fn any(layout: TableLayout) -> Self {
        Self { layout, any_columns: true, ..Self::default() }
    }
}

/// `true` if a column of observations has this name.
fn is_known(name: &str) -> bool {
    meaning(name).is_some()
        || [&TEXTS[..], &QUATERNION, &MATRIX, &COVARIANCES].iter().any(|names| names.contains(&name))
}

/// Column to read: its name in the program, and the source of its cells.
struct ReadColumn<'t> {
    name: Cow<'t, str>,
    from: Expression,
}

impl TableReading {
    /// Returns the columns to read of a sheet.
    fn read_columns<'t>(&self, sheet: &Sheet<'t>) -> Result<Vec<ReadColumn<'t>>> {
        self.check_direction(sheet)?;
        let mut problems = Problems::default();
        let TableLayout { columns, form, .. } = &self.layout;
        let header = sheet.header.as_ref();
        let mut names: Vec<Cow<'t, str>> = sheet.headings().to_vec();
        let mut renamed: Vec<Option<&str>> = vec![None; sheet.width()];
        let mut computed: Vec<ReadColumn> = Vec::new();
        for (name, source) in columns {
            let found = match self.any_columns || is_native_column(name) {
                true => column(source, header, sheet.width()),
                false => Err(error!("observation-column-unknown", column = name)),
            };
            let message = match found {
                Ok(Expression::Column(at)) => match renamed[at] {
                    Some(first) => {
                        let heading = sheet.headings().get(at).map(|heading| heading.trim().to_owned());
                        let heading = heading.unwrap_or_else(|| format!("${}", at + 1));
                        error!("column-stated-twice", column = heading, first, second = name)
                    }
                    None => {
                        renamed[at] = Some(name);
                        if let Some(heading) = names.get_mut(at) {
                            *heading = Cow::Owned(name.clone());
                        } else {
                            computed.push(ReadColumn { name: Cow::Owned(name.clone()), from: Expression::Column(at) });
                        }
                        continue;
                    }
                },
                Ok(from) => {
                    computed.push(ReadColumn { name: Cow::Owned(name.clone()), from });
                    continue;
                }
                Err(_) if self.lenient && sheet.lacks(source) => continue,
                Err(message) => message,
            };
            problems.0.push(message.at(header.map_or_else(|| Place::file(sheet.file), |row| row.place(sheet.file))));
        }
        for (i, name) in names.iter().enumerate().filter(|(i, name)| names[..*i].contains(name)) {
            // headings of unread columns may be equal
            if columns.is_empty() || is_known(name) {
                let message = error!("heading-twice", column = name.as_ref());
                problems.0.push(header.map_or(message.clone(), |row| message.at(row.cell(sheet.file, i))));
            }
        }
        problems.check()?;
        let mut all: Vec<ReadColumn> = Vec::new();
        for (i, name) in names.into_iter().enumerate() {
            if all.iter().all(|column| column.name != name) {
                all.push(ReadColumn { name, from: Expression::Column(i) });
            }
        }
        // a computed column replaces a column with its name; columns that serve an expression or a
        // filter alone are read by it
        let mut served: Vec<usize> = Vec::new();
        computed.iter().for_each(|column| column.from.add_columns(&mut served));
        served.extend(form.only.keys().chain(form.without.keys()).filter_map(|name| column_index(name, header).ok()));
        let serves = |column: &ReadColumn| {
            matches!(column.from, Expression::Column(at) if served.contains(&at))
                && !is_native_column(&column.name)
                && !columns.contains_key(column.name.as_ref())
        };
        all.retain(|column| computed.iter().all(|other| other.name != column.name) && !serves(column));
        all.extend(computed);
        Ok(all)
    }

    /// Rejects columns that are given by the headings of the table instead of the names of etalon.
    fn check_direction(&self, sheet: &Sheet) -> std::result::Result<(), Message> {
        let has = |name: &str| sheet.headings().iter().any(|heading| heading.trim() == name);
        // `-x_mm` is an expression of the column itself
        let is_name = |text: &str| !text.starts_with(['-', '(']) && table::is_native_column(text);
        let inverted = |(name, source): (&'_ String, &'_ ColumnSource)| match source {
            ColumnSource::Heading(heading) if has(name) && !has(heading) && is_name(heading) => {
                Some((heading.clone(), name.clone()))
            }
            _ => None,
        };
        let inverted: Vec<(String, String)> = self.layout.columns.iter().filter_map(inverted).collect();
        let pairs: Vec<(&str, &str)> = inverted.iter().map(|(name, heading)| (&**name, &**heading)).collect();
        let hint = table::state_columns(&pairs);
        match pairs.is_empty() {
            true => Ok(()),
            false => Err(error!("columns-inverted").hint(hint).at(sheet.place())),
        }
    }

    /// Adds the columns that every observation needs, and the constant columns.
    fn complete(&self, mut table: Table) -> Result<Table> {
        let height = table.height();
        let mut constants: Vec<(&str, String)> =
            self.layout.constants.iter().map(|(name, constant)| (name.as_str(), constant.cell())).collect();
        constants.extend(self.target.as_ref().map(|target| ("target", target.clone())));
        for (name, cell) in constants {
            let mut named = Cow::Borrowed(name);
            let factor = in_mm(&mut named, self.coverage_factor);
            if table.has(name) || table.has(&named) || name == "line" {
                return Err(error!("stated-and-in-table", key = name).at(Place::file(table.file())).into());
            }
            let values = match cell.parse::<f64>().ok().filter(|_| is_numeric(name)) {
                _ if (name, cell.as_str()) == ("cycle", VISIT) => Values::Whole(visits(&table)?),
                Some(number) => Values::Numbers(vec![Some(factor * number); height]),
                None => Values::Texts(vec![Some(cell); height]),
            };
            table.set(named, values);
        }
        if !table.has("cycle") && !self.any_columns {
            table.set("cycle", Values::Whole(vec![Some(1); height]));
        }
        Ok(table)
    }
}

/// `true` if tables of etalon have a column of this name.
fn is_native_column(name: &str) -> bool {
    is_known(name) || TEXT_COLUMNS.contains(&name) || name == FORCE
}

/// Constant of the column `cycle` of tables whose rows are in the order of measurement: the n-th
/// row of a pose and target is cycle n.
const VISIT: &str = "visit";

/// Counts the rows of each pose and target from 1.
fn visits(table: &Table) -> Result<Vec<Option<i64>>> {
    let targets = if table.has("target") { table.texts("target")? } else { Vec::new() };
    let mut counts = BTreeMap::new();
    let visit = |(row, pose)| {
        let count = counts.entry((pose, targets.get(row))).or_insert(0);
        *count += 1;
        Some(*count)
    };
    Ok(table.poses()?.into_iter().enumerate().map(visit).collect())
}

/// Columns of texts in tables of poses and loads.
const TEXT_COLUMNS: [&str; 4] = ["approach", "robot", "reading", "direction"];
/// Column of the force of a load (N).
pub const FORCE: &str = "force_n";

/// `true` if cells of the column are numbers, poses or repeats; others are texts.
fn is_numeric(name: &str) -> bool {
    let name = name.strip_prefix(FLANGE).unwrap_or(name);
    meaning(name).is_some()
        || name == FORCE
        || [&COVARIANCES[..], &QUATERNION, &MATRIX].iter().any(|names| names.contains(&name))
}

/// Reads a table with commas, decimal points and a header.
///
/// The column `pose` has names of poses, `cycle` whole numbers. Columns whose name ends in a unit
/// have numbers (empty cells are missing values), other columns text.
///
/// # Errors
/// Reports rows with another number of fields, and unreadable cells, with their places.
pub fn observations(file: &str, text: &str) -> Result<Table> {
    read(file, text, &TableReading::default())
}

/// Reads a table in another layout. Without a column `cycle`, all repeats are 1.
pub fn observations_with(file: &str, text: &str, reading: &TableReading) -> Result<Table> {
    reading.complete(read(file, text, reading)?)
}

fn read(file: &str, text: &str, reading: &TableReading) -> Result<Table> {
    let TableLayout { form, columns: stated, pose, .. } = &reading.layout;
    let stated: Vec<&ColumnSource> = stated.values().collect();
    let mut sheet = Sheet::split(file, text, form, &stated).map_err(|more| more.at(&Place::file(file)))?;
    let mut columns = reading.read_columns(&sheet)?;
    let factors: Vec<f64> = columns.iter_mut().map(|column| in_mm(&mut column.name, reading.coverage_factor)).collect();
    let mut problems = Problems(sheet.field_counts().collect());
    sheet.filtered()?;
    let mut table = Table::from_file(file, sheet.rows.iter().map(|row| row.line));
    for (column, factor) in columns.iter().zip(factors).filter(|(column, _)| column.name != "line") {
        if table.has(&column.name) {
            problems.0.push(error!("heading-twice", column = &*column.name).at(sheet.place()));
        }
        table.set(&*column.name, column.values(&sheet, factor, &mut problems));
    }
    if let Some(from) = pose {
        let named = sheet.rows.iter().map(|row| Some(PoseName::from(from.number(row.number as i64))));
        match table.has("pose") {
            true => problems.0.push(error!("stated-and-in-table", key = "pose").at(Place::file(file))),
            false => table.set("pose", Values::Poses(named.collect())),
        }
    }
    refuse_formulas(file, &columns, &sheet.rows, &mut problems);
    problems.0.sort_by_key(|m| m.place.as_ref().map(|p| (p.line, p.column)));
    problems.check()?;
    Ok(table)
}

impl ReadColumn<'_> {
    /// Returns the values of the column, and reports cells that cannot be read.
    fn values(&self, sheet: &Sheet, factor: f64, problems: &mut Problems) -> Values {
        let (name, from) = (&*self.name, &self.from);
        let at = from.column().unwrap_or(usize::MAX);
        let in_unit = |value: f64| if factor == 1.0 { value } else { value * factor };
        let number = |row: &Row| sheet.number(row, from, name);
        match name {
            _ if !is_numeric(name) => {
                Values::Texts(sheet.rows.iter().map(|row| Some(row.field(at).to_owned())).collect())
            }
            "pose" => Values::Poses(poses(sheet, at, problems)),
            "cycle" => {
                let whole = |row| number(row)?.map(|value| sheet.whole(row, from, name, value)).transpose();
                Values::Whole(kept(sheet.rows.iter().map(whole), problems))
            }
            _ => Values::Numbers(kept(sheet.rows.iter().map(|row| Ok(number(row)?.map(in_unit))), problems)),
        }
    }
}

/// Cells that can be read; the others become problems.
fn kept<T>(
    cells: impl Iterator<Item = std::result::Result<Option<T>, Message>>,
    problems: &mut Problems,
) -> Vec<Option<T>> {
    cells.map(|cell| problems.keep(cell.map_err(Problems::from)).flatten()).collect()
}

/// Reports names that would be formulas in a spreadsheet, because names are written to tables.
fn refuse_formulas(file: &str, columns: &[ReadColumn], rows: &[Row], problems: &mut Problems) {
    let named = |column: &&ReadColumn| TEXTS.contains(&column.name.as_ref());
    for (column, row) in columns.iter().filter(named).flat_map(|column| rows.iter().map(move |row| (column, row))) {
        let Expression::Column(i) = column.from else { continue };
        let (column, name) = (&column.name, row.field(i));
        if is_formula(name) {
            problems.0.push(error!("name-is-formula", column = column.as_ref(), name).at(row.cell(file, i)));
        }
    }
}

/// Renames a column of coordinates or of their uncertainties to mm (`x_m` becomes `x_mm`), and
/// returns the factor of its values. The factor also converts expanded to standard uncertainties.
fn in_mm(name: &mut Cow<str>, coverage_factor: Option<f64>) -> f64 {
    let uncertain = |name: &str| UNCERTAINTIES.contains(&name) || ["u_mm", "urot_deg"].contains(&name);
    let lengths = ["u_mm", "distance_mm", "offset_mm"];
    let known = |name: &str| XYZ.contains(&name) || UNCERTAINTIES.contains(&name) || lengths.contains(&name);
    let Some((there, factor)) = meaning(name) else { return 1.0 };
    let standard = coverage_factor.filter(|_| uncertain(&there)).unwrap_or(1.0);
    match known(&there) {
        true => {
            *name = Cow::Owned(there);
            factor / standard
        }
        false if factor == 1.0 => 1.0 / standard,
        false => 1.0,
    }
}

/// Returns the names of poses in column `at`, each in one spelling.
fn poses(sheet: &Sheet, at: usize, problems: &mut Problems) -> Vec<Option<PoseName>> {
    let mut name = |row: &Row| match row.field(at) {
        "" => None,
        field => pose_name(field, sheet.form.decimal())
            .map_err(|message| problems.0.push(message.at(sheet.cell(row, at))))
            .ok(),
    };
    let names: Vec<Option<PoseName>> = sheet.rows.iter().map(&mut name).collect();
    if let Some((message, row)) = two_spellings(names.iter().copied()) {
        problems.0.push(message.at(sheet.cell(&sheet.rows[row], at)));
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pose_has_one_spelling() {
        let table = observations("o.csv", "pose,x_mm\n07,1\n7,2\nP7,3\nhome,4\n").unwrap();
        let names: Vec<String> = table.poses().unwrap().iter().map(ToString::to_string).collect();
        assert_eq!(names, ["7", "7", "P7", "home"]);
        let error = observations("o.csv", "pose,x_mm\nP01,1\nA1,2\nP1,2\n").unwrap_err().to_string();
        assert!(
            ["[pose-name-two-spellings]", "`P01`", "`P1`"].iter().all(|part| error.contains(part))
                && error.contains("o.csv:4"),
            "{error}"
        );
    }

    #[test]
    fn visits_of_a_pose_are_counted_by_target() {
        let mut layout = TableReading::default();
        layout.layout.constants.insert("cycle".to_owned(), serde_json::from_str("\"visit\"").unwrap());
        let text = "pose,target,x_mm\n1,A,0\n1,B,0\n2,A,0\n1,A,0\n2,A,0\n1,A,0\n";
        let table = observations_with("o.csv", text, &layout).unwrap();
        assert_eq!(table.integers("cycle").unwrap(), [1, 1, 1, 2, 2, 3]);
        let error = observations_with("o.csv", &text.replace("pose", "cycle"), &layout).unwrap_err();
        assert!(error.0[0].is("stated-and-in-table", &[("key", &"cycle")]), "{error}");
    }
}
