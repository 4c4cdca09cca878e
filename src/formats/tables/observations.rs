//! Tables of observations: one row per pose, repeat and target, a column per joint with its unit.

use crate::dialect::ambiguous_thousands;
use crate::dialect::{
    Cells, ColumnSource, Constant, Decimal, Delimiter, Dialect, Expression, FromRow, Header, Missing, Thousands,
};
use crate::filter::{Filter, no_row_selected};
use crate::guess::{guesses, two_commas_in};
use crate::lexer::{Row, WHOLE, column_index, marked, parsed, pose_name, split};
use crate::logs::{meaning, one_column, row_width, words_missing};
use crate::table::{
    self, COVARIANCES, FLANGE, MATRIX, QUATERNION, TEXTS, UNCERTAINTIES, XYZ, failed, frame, pose_column,
};
use etalon_base::cell::is_formula;
use etalon_base::error;
use etalon_base::message::{Place, Problems, Result};
use etalon_base::pose_name::{PoseName, two_spellings};
use polars::prelude::{Column, DataFrame, NamedFrom, Series};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Layout of a table that differs from the tables of this program.
#[derive(Clone, Debug)]
pub struct TableLayout {
    /// Delimiter of the columns.
    pub delimiter: Delimiter,
    /// Decimal mark.
    pub decimal: Decimal,
    /// Mark between groups of three digits.
    pub thousands: Option<Thousands>,
    /// Header rows before the data; the last one names the columns.
    pub header: Header,
    /// Beginning of lines that are skipped.
    pub comment: Option<String>,
    /// Cells that mean "not measured", in addition to empty cells.
    pub missing: Missing,
    /// Sources of columns with other headings and of computed columns.
    pub columns: BTreeMap<String, ColumnSource>,
    /// `true` if columns that the file lacks are left out, for several tables with one layout.
    pub lenient: bool,
    /// `true` for a sheet of a workbook, which omits trailing empty cells.
    pub is_sheet: bool,
    /// `true` for observations, whose columns are known and which have a repeat.
    pub is_of_observations: bool,
    /// Columns with the same cell in all rows.
    pub constants: BTreeMap<String, Constant>,
    /// Filter: only rows with one of these cells in each of these columns are read.
    pub only: BTreeMap<String, Cells>,
    /// Filter: rows with one of these cells in one of these columns are left out.
    pub without: BTreeMap<String, Cells>,
    /// Coverage factor of the columns of uncertainties, if they are expanded.
    pub coverage_factor: Option<f64>,
    /// Target of all rows, for a table without the column.
    pub target: Option<String>,
    /// Pose of each row, for a table without the column.
    pub pose: Option<FromRow>,
}

impl Default for TableLayout {
    fn default() -> Self {
        Self {
            delimiter: Delimiter::Comma,
            decimal: Decimal::Point,
            thousands: None,
            header: Header::Rows(1),
            comment: None,
            missing: Missing::default(),
            columns: BTreeMap::new(),
            lenient: false,
            is_sheet: false,
            is_of_observations: true,
            constants: BTreeMap::new(),
            only: BTreeMap::new(),
            without: BTreeMap::new(),
            coverage_factor: None,
            target: None,
            pose: None,
        }
    }
}

impl TableLayout {
    /// Layout of a table of poses, loads or joints, whose columns may have any name.
    pub fn with_any_columns() -> Self {
        Self { is_of_observations: false, ..Self::default() }
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

impl TableLayout {
    /// Returns the columns to read of a table with this header.
    fn read_columns<'t>(&self, file: &str, header: Option<&Row<'t>>, width: usize) -> Result<Vec<ReadColumn<'t>>> {
        let mut problems = Problems::default();
        let headings: Vec<Cow<str>> =
            header.map(|row| row.fields.iter().map(|f| Cow::from(f.trim().to_owned())).collect()).unwrap_or_default();
        let place = || header.map_or_else(|| Place::file(file), |row| row.place(file));
        let mut names: Vec<Cow<'t, str>> = header.map(|row| row.fields.clone()).unwrap_or_default();
        let mut renamed: Vec<Option<&str>> = vec![None; width];
        let mut computed: Vec<ReadColumn> = Vec::new();
        for (name, source) in &self.columns {
            let known = !self.is_of_observations || Self::is_own(name);
            let at = match source {
                ColumnSource::Heading(heading) => headings.iter().position(|h| h == heading),
                ColumnSource::Number(number) => Some(number - 1).filter(|at| *at < width),
            };
            let message = match (at, source) {
                _ if !known => error!("observation-column-unknown", column = name),
                (Some(at), _) => match renamed[at] {
                    Some(other) => {
                        let heading = headings.get(at).map_or_else(|| format!("${}", at + 1), ToString::to_string);
                        error!("column-stated-twice", column = heading, first = other, second = name)
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
                (None, ColumnSource::Number(number)) => {
                    error!("column-number-unknown", number, columns = width)
                }
                (None, ColumnSource::Heading(text)) if Expression::is_likely(text) => {
                    let parsed = Expression::parse(text, &headings);
                    match parsed.and_then(|from| from.check_columns(width).map(|()| from)) {
                        Ok(from) => {
                            computed.push(ReadColumn { name: Cow::Owned(name.clone()), from });
                            continue;
                        }
                        Err(message) => message,
                    }
                }
                (None, ColumnSource::Heading(_)) if self.lenient => continue,
                (None, ColumnSource::Heading(heading)) => {
                    error!("column-unknown", column = heading).hint_names(heading, headings.iter().map(AsRef::as_ref))
                }
            };
            problems.0.push(message.at(place()));
        }
        let named = !self.columns.is_empty();
        for (i, name) in names.iter().enumerate().filter(|(i, name)| names[..*i].contains(name)) {
            // headings of unread columns may be equal
            if !named || is_known(name) {
                let message = error!("heading-twice", column = name.as_ref());
                problems.0.push(header.map_or(message.clone(), |row| message.at(row.cell(file, i))));
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
        served.extend(self.only.keys().chain(self.without.keys()).filter_map(|name| column_index(name, header).ok()));
        let serves = |column: &ReadColumn| {
            matches!(column.from, Expression::Column(at) if served.contains(&at))
                && !Self::is_own(&column.name)
                && !self.columns.contains_key(column.name.as_ref())
        };
        all.retain(|column| computed.iter().all(|other| other.name != column.name) && !serves(column));
        all.extend(computed);
        Ok(all)
    }

    /// `true` if tables of etalon have a column of this name.
    fn is_own(name: &str) -> bool {
        is_known(name) || TEXT_COLUMNS.contains(&name) || name == FORCE
    }

    /// Adds the columns that every observation needs, and the constant columns.
    fn complete(&self, file: &str, mut table: DataFrame) -> Result<DataFrame> {
        let height = table.height();
        let mut constants: Vec<(&str, String)> =
            self.constants.iter().map(|(name, constant)| (name.as_str(), constant.cell())).collect();
        constants.extend(self.target.as_ref().map(|target| ("target", target.clone())));
        let mut added: Vec<Column> = Vec::new();
        for (name, cell) in constants {
            if table.column(name).is_ok() || added.iter().any(|column| column.name() == name) {
                return Err(error!("stated-and-in-table", key = name).at(Place::file(file)).into());
            }
            if (name, cell.as_str()) == ("cycle", VISIT) {
                added.push(Series::new(name.into(), visits(&table)?).into());
                continue;
            }
            let mut named = Cow::Borrowed(name);
            let factor = in_mm(&mut named, self.coverage_factor);
            added.push(match cell.parse::<f64>().ok().filter(|_| is_numeric(name)) {
                Some(number) => Series::new(named.as_ref().into(), vec![factor * number; height]).into(),
                None => Series::new(named.as_ref().into(), vec![cell.as_str(); height]).into(),
            });
        }
        let has_cycle = table.column("cycle").is_ok() || added.iter().any(|column| column.name() == "cycle");
        if !has_cycle && self.is_of_observations {
            added.push(Series::new("cycle".into(), vec![1i64; height]).into());
        }
        table.hstack_mut(&added).map_err(failed)?;
        Ok(table)
    }
}

/// Constant of the column `cycle` of tables whose rows are in the order of measurement: the n-th
/// row of a pose and target is cycle n.
const VISIT: &str = "visit";

/// Counts the rows of each pose and target from 1.
fn visits(table: &DataFrame) -> Result<Vec<i64>> {
    let poses: Vec<String> = table::poses(table)?.iter().map(ToString::to_string).collect();
    let targets = if table.column("target").is_ok() { table::texts(table, "target")? } else { Vec::new() };
    let mut counts = BTreeMap::new();
    let visit = |(row, pose)| {
        let count = counts.entry((pose, targets.get(row))).or_insert(0);
        *count += 1;
        *count
    };
    Ok(poses.into_iter().enumerate().map(visit).collect())
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

/// Reads a table with commas, decimal points and a header. The column `line` has the line of each
/// row.
///
/// The column `pose` has names of poses, `cycle` whole numbers. Columns whose name ends in a unit
/// have numbers (empty cells are missing values), other columns text.
///
/// # Errors
/// Reports rows with another number of fields, and unreadable cells, with their places.
pub fn observations(file: &str, text: &str) -> Result<DataFrame> {
    read(file, text, &TableLayout::default())
}

/// Reads a table in another layout. Without a column `cycle`, all repeats are 1.
pub fn observations_with(file: &str, text: &str, layout: &TableLayout) -> Result<DataFrame> {
    layout.complete(file, read(file, text, layout)?)
}

/// Returns the header and the data rows of a table.
fn data_rows<'t>(file: &str, text: &'t str, layout: &TableLayout) -> Result<(Option<Row<'t>>, Vec<Row<'t>>)> {
    if (layout.delimiter, layout.decimal) == (Delimiter::Comma, Decimal::Comma) {
        return Err(two_commas_in(text).at(Place::file(file)).into());
    }
    if let Some(message) = ambiguous_thousands(Some(layout.delimiter), layout.decimal, layout.thousands) {
        return Err(message.at(Place::file(file)).into());
    }
    let dialect = Dialect { delimiter: Some(layout.delimiter), comment: layout.comment.clone(), ..Dialect::default() };
    let (mut all, problems) = split(file, text, &dialect);
    problems.check()?;
    let before = match &layout.header {
        Header::Rows(count) => Some(*count),
        Header::Words(words) => {
            all.iter().position(|row| words.iter().all(|word| row.text.contains(word.as_str()))).map(|at| at + 1)
        }
    };
    let Some(before) = before else {
        return Err(words_missing(&layout.header).at(Place::file(file)).into());
    };
    if all.len() < before + 1 {
        return Err(error!("data-rows-missing").at(Place::file(file)).into());
    }
    if all[0].fields.len() == 1
        && before > 0
        && let Some(guess) = guesses(text, None).first().map(|guess| &guess.dialect)
        && guess.delimiter.is_some_and(|delimiter| delimiter != layout.delimiter)
    {
        return Err(one_column(layout.delimiter, Some(guess)).at(all[0].place(file)).into());
    }
    if layout.is_sheet {
        let width = all.iter().skip(before.saturating_sub(1)).map(|row| row.fields.len()).max().unwrap_or(0);
        all.iter_mut().for_each(|row| row.fields.resize(width, Cow::Borrowed("")));
    }
    let data = all.split_off(before);
    let header = all.pop();
    if let Some(row) = header.as_ref().filter(|row| holds_numbers(row, layout)) {
        return Err(error!("header-holds-numbers").at(row.place(file)).into());
    }
    Ok((header, data))
}

/// `true` if the row that should name the columns holds numbers, and `columns` names none of them.
fn holds_numbers(header: &Row, layout: &TableLayout) -> bool {
    let numbers =
        header.fields.iter().filter(|field| parsed(field.trim(), layout.decimal, layout.thousands).is_some()).count();
    let stated = |field: &Cow<str>| {
        layout
            .columns
            .values()
            .any(|source| matches!(source, ColumnSource::Heading(heading) if heading == field.trim()))
    };
    2 * numbers > header.fields.len() && !header.fields.iter().any(stated)
}

fn read(file: &str, text: &str, layout: &TableLayout) -> Result<DataFrame> {
    let (header, all) = data_rows(file, text, layout)?;
    let width = header.as_ref().or(all.first()).map_or(0, |row| row.fields.len());
    let mut columns = layout.read_columns(file, header.as_ref(), width)?;
    let factors: Vec<f64> = columns.iter_mut().map(|column| in_mm(&mut column.name, layout.coverage_factor)).collect();
    let mut problems = Problems::default();
    let like = if header.is_some() { "header" } else { "first-row" };
    let wrong = all.iter().filter(|row| row.fields.len() != width);
    problems.0.extend(wrong.map(|row| row_width(file, row, width, like)));
    let kept = kept(file, layout, header.as_ref(), &all)?;
    let (numbers, all): (Vec<i64>, Vec<Row>) = (1..).zip(all).filter(|(number, _)| kept[*number as usize - 1]).unzip();
    let mut made: Vec<Column> =
        vec![Series::new("line".into(), all.iter().map(|row| row.line as i64).collect::<Vec<i64>>()).into()];
    for (column, factor) in columns.iter().zip(factors).filter(|(column, _)| column.name != "line") {
        made.push(made_column(file, &all, column, (layout, factor), &mut problems));
    }
    if let Some(from) = layout.pose {
        let named: Vec<_> = numbers.iter().map(|row| Some(PoseName::from(from.number(*row)))).collect();
        match columns.iter().any(|column| column.name == "pose") {
            true => {
                problems.0.push(error!("stated-and-in-table", key = "pose").at(Place::file(file)));
            }
            false => made.push(pose_column("pose", &named)),
        }
    }
    refuse_formulas(file, &columns, &all, &mut problems);
    problems.0.sort_by_key(|m| m.place.as_ref().map(|p| (p.line, p.column)));
    problems.check()?;
    frame(all.len(), made)
}

/// Applies the filters `only` and `without`: `true` for each row that is read.
fn kept(file: &str, layout: &TableLayout, header: Option<&Row>, rows: &[Row]) -> Result<Vec<bool>> {
    let filter = Filter::new(file, [&layout.only, &layout.without], header, (layout.decimal, layout.thousands))
        .map_err(Problems)?;
    let kept: Vec<bool> = rows.iter().map(|row| filter.refuses(row).is_none()).collect();
    if !rows.is_empty() && !kept.contains(&true) {
        return Err(no_row_selected(file, header).into());
    }
    Ok(kept)
}

/// Returns the values of one column, and reports cells that cannot be read.
fn made_column(
    file: &str,
    rows: &[Row],
    column: &ReadColumn,
    (layout, factor): (&TableLayout, f64),
    problems: &mut Problems,
) -> Column {
    let name = column.name.as_ref();
    let at = if let Expression::Column(at) = column.from { at } else { usize::MAX };
    if !is_numeric(name) {
        return Series::new(name.into(), rows.iter().map(|row| row.field(at)).collect::<Vec<_>>()).into();
    }
    if name == "pose" {
        return pose_column("pose", &poses(file, rows, at, layout.decimal, problems));
    }
    let whole = name == "cycle";
    let mut values: Vec<Option<f64>> = Vec::with_capacity(rows.len());
    for row in rows {
        let cell = |at: usize| match row.field(at) {
            field if layout.missing.says(field) => Ok(None),
            field => marked(field, layout.decimal, layout.thousands).map(Some),
        };
        let odd = |v: f64| whole && (v.fract() != 0.0 || v.abs() > WHOLE);
        let value = match column.from.value(&cell) {
            Ok(Some(value)) if !value.is_finite() => Err((at, error!("computed-not-finite", column = name, value))),
            Ok(Some(value)) if odd(value) => {
                let shown = row.fields.get(at).map_or_else(|| value.to_string(), ToString::to_string);
                Err((at, error!("not-whole-number", value = shown, column = name)))
            }
            read => read,
        };
        values.push(value.unwrap_or_else(|(at, message)| {
            let place = if at < row.fields.len() { row.cell(file, at) } else { row.place(file) };
            problems.0.push(message.at(place));
            None
        }));
    }
    match whole {
        true => Series::new(name.into(), values.iter().map(|v| v.map(|v| v as i64)).collect::<Vec<_>>()).into(),
        false => {
            let in_unit = |value: Option<f64>| value.map(|value| if factor == 1.0 { value } else { value * factor });
            Series::new(name.into(), values.into_iter().map(in_unit).collect::<Vec<_>>()).into()
        }
    }
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
        assert!(
            ["[pose-name-two-spellings]", "`P01`", "`P1`"].iter().all(|part| error.contains(part))
                && error.contains("o.csv:4"),
            "{error}"
        );
    }

    #[test]
    fn visits_of_a_pose_are_counted_by_target() {
        let mut layout = TableLayout::default();
        layout.constants.insert("cycle".to_owned(), serde_json::from_str("\"visit\"").unwrap());
        let text = "pose,target,x_mm\n1,A,0\n1,B,0\n2,A,0\n1,A,0\n2,A,0\n1,A,0\n";
        let table = observations_with("o.csv", text, &layout).unwrap();
        assert_eq!(table::integers(&table, "cycle").unwrap(), [1, 1, 1, 2, 2, 3]);
        let error = observations_with("o.csv", &text.replace("pose", "cycle"), &layout).unwrap_err();
        assert!(error.0[0].is("stated-and-in-table", &[("key", &"cycle")]), "{error}");
    }
}
