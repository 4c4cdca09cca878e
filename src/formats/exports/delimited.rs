//! Delimited text: rows of columns in a dialect, which the campaign contains or names.

use super::stamps;
use super::{About, ExportFormat, ExportRow, Plain, Recognised, Text, WriteError, Writing};
use crate::dialect::{ColumnRole, Columns, CoordinateType, Dialect, Unit, coordinate_type};
use crate::points::{Line, Names, Point, SharedText};
use etalon_base::angle_order::AngleOrder;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Place, Problems};
use etalon_base::pose::{Pose, Vector, norm};
use etalon_base::{error, phrase};
use etalon_tables::filter::{Filter, no_row_selected};
use etalon_tables::lexer::pose_name;
use etalon_tables::lexer::{self, PlainColumn, Row, WHOLE, each_row, marked, parsed, written_out};
use etalon_tables::sheet::{column, header, header_of_numbers, number};
use etalon_tables::{ColumnSource, Decimal, Delimiter, Encoding, Expression, Form, Header, stated_units};
use std::borrow::Cow;
use std::f64::consts::{PI, TAU};

/// Delimited text in a given dialect.
pub(super) struct Delimited;

impl ExportFormat for Delimited {
    fn about(&self) -> About {
        About { by_rows: true, ..About::default() }
    }

    fn unit(&self, text: &str, dialect: &Dialect) -> Option<Unit> {
        stated_unit(text, dialect)
    }

    fn read(&self, text: &Text, dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        point_rows(text.file, text.whole, dialect, unit)
    }

    /// Header rows, the last of which names the columns, and the data.
    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        write(rows, how)
    }

    /// The head is read as the strict reader reads it, and must be without fault.
    fn plain(&self, dialect: &Dialect, start: &str, unit: Unit) -> Option<Plain> {
        let utf8 = dialect.form.encoding.is_none_or(|encoding| encoding == Encoding::Utf8);
        if !utf8 || dialect.form.comment.is_some() || !dialect.check().is_empty() {
            return None;
        }
        let text = SharedText::from(start);
        let mut problems = Problems::default();
        let begun = begin("", &text, dialect, unit, &mut problems).ok().filter(|_| problems.0.is_empty())?;
        let plain = Plain::new(dialect.form.delimiter(), dialect.form.decimal(), &begun.reader.plain()?);
        let first = begun.first?;
        let bytes = first.text.as_ptr() as usize - text.as_ptr() as usize;
        Some(Plain { above: (bytes, first.line as u32 - 1), may_be_angles: dialect.coordinates.is_none(), ..plain })
    }
}

/// A named dialect.
pub struct NamedDialect {
    pub name: &'static str,
    pub recognise: fn(&str) -> Option<Recognised>,
    pub dialect: fn() -> Dialect,
}

impl ExportFormat for NamedDialect {
    fn about(&self) -> About {
        About { name: self.name, ..Delimited.about() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        (self.recognise)(text)
    }

    fn dialect(&self) -> Dialect {
        (self.dialect)()
    }

    fn unit(&self, text: &str, dialect: &Dialect) -> Option<Unit> {
        self.recognise(text).and_then(|found| Unit::named(found.unit?)).or_else(|| stated_unit(text, dialect))
    }

    fn read(&self, text: &Text, dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        Delimited.read(text, dialect, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        Delimited.write(rows, how)
    }

    fn plain(&self, dialect: &Dialect, start: &str, unit: Unit) -> Option<Plain> {
        Delimited.plain(dialect, start, unit)
    }
}

impl NamedDialect {
    /// Columns that only the name of the dialect gives.
    const fn simple(name: &'static str, dialect: fn() -> Dialect) -> Self {
        Self { name, recognise: |_| None, dialect }
    }
}

pub(super) fn columns_in(delimiter: Delimiter, columns: &[ColumnRole]) -> Dialect {
    Dialect { form: Form::delimited(delimiter), columns: columns.to_vec().into(), ..Dialect::default() }
}

/// numpy.savetxt and most viewers of point clouds.
pub(super) const XYZ: NamedDialect =
    NamedDialect::simple("xyz", || columns_in(Delimiter::Blank, &[ColumnRole::X, ColumnRole::Y, ColumnRole::Z]));
/// Columns of [`XYZ`] with directions.
pub(super) const XYZIJK: NamedDialect = NamedDialect::simple("xyzijk", || {
    columns_in(
        Delimiter::Blank,
        &[ColumnRole::X, ColumnRole::Y, ColumnRole::Z, ColumnRole::I, ColumnRole::J, ColumnRole::K],
    )
});
/// Names and coordinates between commas.
pub(super) const NAME_XYZ: NamedDialect = NamedDialect::simple("name-xyz-csv", || {
    columns_in(Delimiter::Comma, &[ColumnRole::Label, ColumnRole::X, ColumnRole::Y, ColumnRole::Z])
});
/// Trackers' lists of stationary points, whose further fields may be empty.
pub(super) const TRACKER: NamedDialect = NamedDialect::simple("tracker-semicolon", || {
    columns_in(Delimiter::Semicolon, &[ColumnRole::Label, ColumnRole::X, ColumnRole::Y, ColumnRole::Z])
});

/// Maximum difference from 1 of the length of a direction.
const DIRECTION: f64 = 0.01;

/// Points of a text (mm), with its problems.
pub(crate) fn point_rows(file: &str, text: &SharedText, dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
    let wrong = Problems(dialect.check());
    if !wrong.0.is_empty() {
        return (Vec::new(), wrong);
    }
    let mut problems = Problems::default();
    let points = points(file, text, dialect, unit, &mut problems).unwrap_or_else(|wrong| {
        problems.0.extend(wrong);
        Vec::new()
    });
    problems.0.sort_by_key(|m| m.place.as_ref().map(|p| (p.line, p.column)));
    (points, problems)
}

/// Number of columns without a meaning in a dialect, and number of all columns with a heading or a
/// value in the first row; columns that `is_read` names by heading or number are read.
///
/// `None` if computed columns or filters name columns as well, or the columns cannot be resolved.
pub(crate) fn columns_not_read(
    text: &str,
    dialect: &Dialect,
    is_read: impl Fn(usize, Option<&str>) -> bool,
) -> Option<[usize; 2]> {
    if !dialect.check().is_empty() || dialect.form.is_filtered() {
        return None;
    }
    let mut rows = each_row("", text, &dialect.form).flatten();
    let header = header(&mut rows, &dialect.header()).ok()?;
    let first = rows.next()?;
    let Resolved { roles, computed, .. } = resolved("", header.as_ref(), dialect, Some(&first)).ok()?;
    let heading = |i: usize| header.as_ref().and_then(|row| row.fields.get(i)).map(AsRef::as_ref);
    let cell = |i: usize| first.fields.get(i).map(AsRef::as_ref);
    let width = first.fields.len().max(header.as_ref().map_or(0, |row| row.fields.len()));
    let filled = (0..width).filter(|i| [heading(*i), cell(*i)].iter().flatten().any(|text: &&str| !text.is_empty()));
    let columns: Vec<usize> = filled.collect();
    let unread = |i: &&usize| {
        let role = roles.get(**i).copied().unwrap_or(ColumnRole::Skip);
        role == ColumnRole::Skip && !is_read(**i, heading(**i))
    };
    computed.is_empty().then(|| [columns.iter().filter(unread).count(), columns.len()])
}

/// Reader of the data rows of a text, below its head.
struct Begun<'a, L> {
    reader: Reader<'a>,
    /// Lines of the data.
    lines: L,
    /// First data row.
    first: Option<Row<'a>>,
    /// Least number of cells of a row: cells behind the last one of a row of a sheet are empty, and
    /// not written.
    least: usize,
}

/// Reads the head of a text; an error of the header stops the reading.
fn begin<'a>(
    file: &'a str,
    text: &'a SharedText,
    dialect: &'a Dialect,
    unit: Unit,
    problems: &mut Problems,
) -> Result<Begun<'a, impl Iterator<Item = (usize, &'a str)> + use<'a>>, Vec<Message>> {
    let form = &dialect.form;
    let of_sheet = || each_row(file, text, form).flatten().map(|row| row.fields.len()).max().unwrap_or(0);
    let least = if form.sheet.is_some() { of_sheet() } else { 0 };
    let split = |(number, line)| split_line(file, number, line, form, least);
    let mut lines = lexer::lines(text, form);
    let mut rows = lines.by_ref().filter_map(|line| split(line).map_err(|message| problems.0.push(message)).ok());
    let header = header(&mut rows, &dialect.header()).map_err(|message| vec![message.at(Place::file(file))])?;
    let first = lines.clone().find_map(|line| split(line).ok());
    let Resolved { roles, computed, width } = resolved(file, header.as_ref(), dialect, first.as_ref())?;
    let filter = Filter::new(file, form, header.as_ref())?;
    let start = first.as_ref().map_or(0, |row| row.line);
    problems.0.extend(other_unit(&Above { file, text, start, header: header.as_ref(), roles: &roles }, dialect, unit));
    problems.0.extend(header.as_ref().and_then(|header| header_with_data(file, header, dialect, &roles)));
    let reader = Reader { file, text, dialect, unit, header, roles, computed, width, filter };
    Ok(Begun { reader, lines, first, least })
}

/// Splits a numbered line into cells, and adds empty cells up to the number `least`.
fn split_line<'t>(file: &str, number: usize, line: &'t str, form: &Form, least: usize) -> Result<Row<'t>, Message> {
    let mut row = lexer::row(file, number, line, form)?;
    row.fields.resize(least.max(row.fields.len()), Cow::Borrowed(""));
    Ok(row)
}

/// Reads the points of the data rows between header and end. Stops at an error of the header.
fn points(
    file: &str,
    text: &SharedText,
    dialect: &Dialect,
    unit: Unit,
    problems: &mut Problems,
) -> Result<Vec<Point>, Vec<Message>> {
    let form = &dialect.form;
    let Begun { reader, mut lines, least, .. } = begin(file, text, dialect, unit, problems)?;
    let split = |(number, line)| split_line(file, number, line, form, least);
    let plain = reader.plain();
    let (mut points, mut names) = (Vec::new(), Names::default());
    while let Some((number, line)) = lines.next() {
        if let Some(point) = plain.as_ref().and_then(|plain| reader.plain_point(plain, number, line, &mut names)) {
            points.push(point);
            continue;
        }
        let mut row = match split((number, line)) {
            Ok(row) => row,
            Err(message) => {
                problems.0.push(message);
                continue;
            }
        };
        if let Some(end) = form.end.as_ref().filter(|end| row.ends(end)) {
            if let Some(row) = lines.find_map(|line| split(line).ok()) {
                problems.0.push(error!("rows-after-end", end).at(row.place(file)));
            }
            break;
        }
        reader.add_computed(&mut row, problems);
        points.extend(reader.point(&row, &mut names, problems));
    }
    if form.is_filtered() && !points.is_empty() && points.iter().all(|point| point.is_left_out) {
        problems.0.push(no_row_selected(file, reader.header.as_ref()));
    }
    problems.0.extend(reader.looks_spherical(&points));
    Ok(points)
}

/// Lines above the data of a text.
struct Above<'a> {
    file: &'a str,
    text: &'a str,
    /// Line of the first data row.
    start: usize,
    header: Option<&'a Row<'a>>,
    roles: &'a [ColumnRole],
}

/// Statement of a unit of lengths: the unit, its words, and their place.
struct StatedLength {
    unit: &'static str,
    how: String,
    place: Place,
}

impl Above<'_> {
    /// Units in the headings of lengths.
    fn in_headings(&self, dialect: &Dialect) -> Vec<StatedLength> {
        let of_topic = dialect.form.is_topic().then_some(Unit::Metre);
        let place = || self.header.map_or(Place::file(self.file), |row| row.place(self.file));
        let lengths = self.header.iter().flat_map(|row| self.roles.iter().zip(&row.fields));
        let lengths = lengths.filter(|(role, _)| is_length(role));
        let stated = |(_, name): (&ColumnRole, &Cow<str>)| {
            let unit = of_topic.or_else(|| Unit::from_heading(name))?.name();
            Some(StatedLength { unit, how: name.to_string(), place: place() })
        };
        lengths.filter_map(stated).collect()
    }

    /// Units in a row of units, or in words above the data.
    fn in_words(&self, dialect: &Dialect) -> Vec<StatedLength> {
        let is_of_length = |at: usize| self.roles.get(at).is_some_and(is_length);
        let place = |line: usize| Place::line(self.file, line, self.text.lines().nth(line - 1).unwrap_or_default());
        let stated = stated_units(self.text, &dialect.form, self.start, &is_of_length);
        stated.into_iter().map(|of| StatedLength { unit: of.unit, how: of.how, place: place(of.line) }).collect()
    }
}

/// `true` for a column of lengths.
fn is_length(role: &ColumnRole) -> bool {
    role.is_coordinate() && !role.is_angle()
}

/// Error if the file contains another unit of length than the campaign: in a heading of a length,
/// in a row of units, or in words above the data.
fn other_unit(above: &Above, dialect: &Dialect, unit: Unit) -> Option<Message> {
    let differs = |stated: &StatedLength| stated.unit != unit.name();
    let in_heading = above.in_headings(dialect).into_iter().find(differs);
    let found = in_heading.or_else(|| {
        // of different statements one may be of other columns
        let stated = above.in_words(dialect);
        if stated.iter().all(differs) { stated.into_iter().next() } else { None }
    });
    found.map(|StatedLength { unit: of_file, how, place }| {
        error!("unit-differs", of_file, how, stated = unit.name()).at(place)
    })
}

/// Unit of lengths that a text contains: in the headings of lengths, or else above the data; `None`
/// for different statements.
fn stated_unit(text: &str, dialect: &Dialect) -> Option<Unit> {
    if !dialect.check().is_empty() {
        return None;
    }
    let mut rows = each_row("", text, &dialect.form).flatten();
    let header = header(&mut rows, &dialect.header()).ok()?;
    let first = rows.next()?;
    let Resolved { roles, .. } = resolved("", header.as_ref(), dialect, Some(&first)).ok()?;
    let above = Above { file: "", text, start: first.line, header: header.as_ref(), roles: &roles };
    let mut stated = above.in_headings(dialect);
    if stated.is_empty() {
        stated = above.in_words(dialect);
    }
    let unit = stated.first()?.unit;
    stated.iter().all(|of| of.unit == unit).then(|| Unit::named(unit)).flatten()
}

/// Error if the last row of a header of a given number of rows has numbers in all columns of
/// coordinates, one of them with a decimal mark.
fn header_with_data(file: &str, header: &Row, dialect: &Dialect, roles: &[ColumnRole]) -> Option<Message> {
    let Header::Rows(rows) = dialect.header() else { return None };
    let form = &dialect.form;
    let mark = if form.decimal() == Decimal::Point { '.' } else { ',' };
    let coordinates: Vec<usize> = (0..roles.len()).filter(|at| roles[*at].is_coordinate()).collect();
    let is_number = |at: &usize| parsed(header.field(*at), form.decimal(), form.thousands).is_some();
    let is_data = coordinates.iter().all(is_number) && coordinates.iter().any(|at| header.field(*at).contains(mark));
    is_data.then(|| error!("header-is-data", rows, fewer = rows.saturating_sub(1)).at(header.place(file)))
}

/// Roles of the columns; computed columns follow the columns of the file.
struct Resolved {
    roles: Vec<ColumnRole>,
    computed: Vec<Expression>,
    /// Columns of the file.
    width: usize,
}

fn resolved(
    file: &str,
    header: Option<&Row>,
    dialect: &Dialect,
    first: Option<&Row>,
) -> Result<Resolved, Vec<Message>> {
    let named = match &dialect.columns {
        Columns::InOrder(roles) => {
            let mut roles = roles.clone();
            roles.resize(roles.len().max(dialect.form.widths.len()), ColumnRole::Skip);
            return Ok(Resolved { width: roles.len(), roles, computed: Vec::new() });
        }
        Columns::Named(named) => named,
    };
    let mut computed = Vec::new();
    let width = header.map_or(0, |row| row.fields.len()).max(first.map_or(0, |row| row.fields.len()));
    let mut roles = vec![ColumnRole::Skip; width];
    let mut wrong = Vec::new();
    for (role, source) in named {
        let message = match column(source, header, width) {
            Ok(Expression::Column(at)) if roles[at] == ColumnRole::Skip => {
                roles[at] = *role;
                continue;
            }
            Ok(Expression::Column(at)) => {
                let (first, second) = (roles[at].name(), role.name());
                error!("column-stated-twice", column = format!("${}", at + 1), first, second)
            }
            Ok(expression) => {
                computed.push((*role, expression));
                continue;
            }
            Err(message) => message,
        };
        wrong.push(message.at(header.map_or_else(|| Place::file(file), |row| row.place(file))));
    }
    if !wrong.is_empty() {
        let sources: Vec<&ColumnSource> = named.iter().map(|(_, source)| source).collect();
        let numbers = header.and_then(|row| Some(header_of_numbers(row, &dialect.form, &sources)?.at(row.place(file))));
        return Err(numbers.map_or(wrong, |message| vec![message]));
    }
    let (more, computed): (Vec<ColumnRole>, Vec<Expression>) = computed.into_iter().unzip();
    roles.extend(more);
    Ok(Resolved { roles, computed, width })
}

/// Numbers of a row with their roles; coordinates with their columns, in mm or rad.
#[derive(Default)]
struct Numbers {
    coordinates: Vec<(usize, ColumnRole, f64)>,
    uncertain: Vec<(ColumnRole, f64)>,
    direction: Vec<(ColumnRole, f64)>,
    turned: Vec<(ColumnRole, f64)>,
}

/// Reads rows of one file.
struct Reader<'a> {
    file: &'a str,
    text: &'a SharedText,
    dialect: &'a Dialect,
    unit: Unit,
    /// Row that names the columns.
    header: Option<Row<'a>>,
    /// Roles of the columns; computed columns follow the columns of the file.
    roles: Vec<ColumnRole>,
    computed: Vec<Expression>,
    /// Number of columns of the file.
    width: usize,
    filter: Filter<'a>,
}

impl Reader<'_> {
    /// Adds the computed cells of a row; a computed cell is empty if one of its terms was not
    /// measured.
    fn add_computed(&self, row: &mut Row, problems: &mut Problems) {
        if self.computed.is_empty() {
            return;
        }
        let form = &self.dialect.form;
        row.fields.resize(self.width.max(row.fields.len()), Cow::Borrowed(""));
        let mut cells: Vec<String> = Vec::new();
        for expression in &self.computed {
            let value = expression.value(&|at| number(form, row.field(at)));
            let text = value.map(|value| value.map_or_else(String::new, |value| written_out(value, form.decimal())));
            cells.push(text.unwrap_or_else(|(at, message)| {
                problems.0.push(message.at(row.cell(self.file, at)));
                String::new()
            }));
        }
        row.fields.extend(cells.into_iter().map(Cow::Owned));
    }

    /// Columns of plain lines, if every column is a label, x, y, z or skipped, none is computed,
    /// and no number can mean "not measured".
    fn plain(&self) -> Option<Vec<PlainColumn>> {
        let Form { widths, end, sheet, thousands, missing, .. } = &self.dialect.form;
        let (decimal, stated) = (self.dialect.form.decimal(), self.dialect.form.is_filtered() || !widths.is_empty());
        let numeric = missing.markers().iter().any(|marker| parsed(marker, decimal, None).is_some());
        if stated || numeric || !self.computed.is_empty() || end.is_some() || sheet.is_some() || thousands.is_some() {
            return None;
        }
        let axes = [ColumnRole::X, ColumnRole::Y, ColumnRole::Z];
        let column = |role: &ColumnRole| match role {
            ColumnRole::Skip => Some(PlainColumn::Skipped),
            ColumnRole::Label => Some(PlainColumn::Label),
            role => axes.iter().position(|axis| axis == role).map(PlainColumn::Coordinate),
        };
        let columns: Vec<PlainColumn> = self.roles.iter().map(column).collect::<Option<_>>()?;
        let once = |of: PlainColumn, least: usize| (least..=1).contains(&columns.iter().filter(|c| **c == of).count());
        let all = (0..3).all(|axis| once(PlainColumn::Coordinate(axis), 1)) && once(PlainColumn::Label, 0);
        all.then_some(columns)
    }

    /// Reads the point of a plain line; `None` if the line has to be read as a row.
    fn plain_point(&self, columns: &[PlainColumn], number: usize, line: &str, names: &mut Names) -> Option<Point> {
        let form = &self.dialect.form;
        let (label, xyz) = lexer::plain_line(line, form.delimiter(), form.decimal(), columns)?;
        Some(Point::from_line(number, Line::from_part(self.text, line), names.shared(label), xyz, self.unit))
    }

    /// Reads one point. Invalid numbers are reported and leave the point without a position; a row
    /// with other columns than the given ones is reported, and contributes no point.
    fn point(&self, row: &Row, shared: &mut Names, problems: &mut Problems) -> Option<Point> {
        let line = || row.place(self.file);
        let surplus = row.fields.iter().skip(self.roles.len()).any(|f| !f.is_empty());
        if surplus || row.fields.len() < self.roles.iter().rposition(|r| *r != ColumnRole::Skip).map_or(0, |i| i + 1) {
            let expected = phrase!("fields-of-columns", count = self.roles.len());
            let message = error!("row-field-count", fields = row.fields.len(), expected).at(line());
            problems.0.push(message.hint(phrase!("propose-format")));
            return None;
        }
        let roles = match self.row_roles(row) {
            Ok(roles) => roles,
            Err((message, cell)) => {
                problems.0.push(message.at(row.cell(self.file, cell)));
                return None;
            }
        };
        let mut point = Point { line: row.line as u32, text: Line::from_part(self.text, row.text), ..Point::default() };
        let before = problems.0.len();
        let mut wrong = |message: Message, cell: usize| problems.0.push(message.at(row.cell(self.file, cell)));
        let cells = || roles.iter().zip(&row.fields).enumerate().map(|(i, (role, field))| (i, *role, field.as_ref()));
        let mut value = |i: usize, field: &str| {
            let read = marked(field, self.dialect.form.decimal(), self.dialect.form.thousands);
            read.map_err(|message| wrong(message, i)).unwrap_or(f64::NAN)
        };
        let left_out = self.filter.refuses(row);
        let is_left_out = left_out.is_some();
        let reason = left_out
            .or_else(|| self.not_measured(cells().filter(|(_, role, _)| role.is_coordinate()).map(|(_, r, f)| (r, f))));
        let unmeasured = reason.is_some();
        if unmeasured {
            point.refused = reason.map(Box::new);
            point.is_left_out = is_left_out;
        }
        let mut numbers = Numbers::default();
        let (mut names, mut stamp) = (Vec::new(), [None; 2]);
        for (i, role, field) in cells() {
            match role {
                ColumnRole::Label if point.label.is_empty() => point.label = shared.shared(field),
                ColumnRole::Label => point.label = shared.shared(&format!("{}::{field}", point.label)),
                ColumnRole::Target => point.target = Some(shared.shared(field)),
                ColumnRole::TimeS => point.time_s = Some(value(i, field)),
                ColumnRole::TimeMs => point.time_s = Some(value(i, field) / 1e3),
                ColumnRole::TimeUs => point.time_s = Some(value(i, field) / 1e6),
                ColumnRole::TimeNs => point.time_s = Some(value(i, field) / 1e9),
                ColumnRole::Timestamp => stamp[1] = Some((i, field)),
                ColumnRole::Date => stamp[0] = Some((i, field)),
                ColumnRole::TemperatureC if self.dialect.form.missing.says(field) => {}
                ColumnRole::TemperatureC => point.temperature_c = Some(value(i, field)),
                ColumnRole::Deleted if is_deleted(field) => {
                    point.refused.get_or_insert_with(|| Box::new(phrase!("row-marked-deleted", cell = field)));
                    point.is_left_out = true;
                }
                ColumnRole::Pose | ColumnRole::Cycle => names.push((i, role, field)),
                _ if unmeasured => {}
                role if role.is_orientation() && self.dialect.form.missing.says(field) => {}
                role if role.is_orientation() => numbers.turned.push((role, value(i, field))),
                role if role.is_expanded() => numbers.uncertain.push((role, value(i, field))),
                role if role.is_coordinate() => {
                    numbers.coordinates.push((i, role, value(i, field) * self.factor(role)))
                }
                role if role.is_uncertainty() => numbers.uncertain.push((role, value(i, field))),
                ColumnRole::I | ColumnRole::J | ColumnRole::K => numbers.direction.push((role, value(i, field))),
                _ => {}
            }
        }
        for (message, i) in self.names(&mut point, stamp, &names) {
            wrong(message, i);
        }
        if unmeasured {
            return Some(point);
        }
        if problems.0.len() > before {
            point.xyz_mm = [f64::NAN; 3];
            return Some(point);
        }
        self.place(row, &mut point, numbers, problems);
        Some(point)
    }

    /// Sets pose, cycle and time of a point; returns errors with the indices of their cells.
    fn names(
        &self,
        point: &mut Point,
        stamp: [Option<(usize, &str)>; 2],
        names: &[(usize, ColumnRole, &str)],
    ) -> Vec<(Message, usize)> {
        let mut wrong = Vec::new();
        if let [date, Some((i, field))] = stamp {
            match stamps::seconds(date.map_or("", |(_, date)| date), field) {
                Ok(seconds) => point.time_s = Some(seconds),
                Err(message) => wrong.push((message, i)),
            }
        }
        for &(i, role, field) in names {
            if role == ColumnRole::Pose {
                match pose_name(field, self.dialect.form.decimal()) {
                    Ok(pose) => point.pose = Some(pose),
                    Err(message) => wrong.push((message, i)),
                }
                continue;
            }
            point.cycle = field.parse().ok().filter(|v: &i64| v.abs() <= WHOLE as i64);
            if point.cycle.is_none() {
                wrong.push((error!("not-whole-number", value = field, column = role.name()), i));
            }
        }
        wrong
    }

    /// Position, uncertainty, orientation and direction of a point from the numbers of its row.
    fn place(&self, row: &Row, point: &mut Point, numbers: Numbers, problems: &mut Problems) {
        // u1 is of the first coordinate from the left, or of c1
        let Numbers { mut coordinates, mut uncertain, mut direction, mut turned } = numbers;
        coordinates.sort_by_key(|(i, ..)| (self.roles[*i].is_typed().then_some(self.roles[*i] as usize), *i));
        if uncertain.iter().any(|(role, _)| role.is_expanded()) {
            // these are of x, y and z wherever they are
            coordinates.sort_by_key(|(_, role, _)| *role as usize);
        }
        let coordinates: Vec<(ColumnRole, f64)> =
            coordinates.into_iter().map(|(_, role, value)| (role, value)).collect();
        uncertain.sort_by_key(|(role, _)| *role as usize);
        let covered = self.dialect.coverage_factor.unwrap_or(1.0);
        let uncertain: Vec<f64> =
            uncertain.iter().zip(&coordinates).map(|((_, u), (of, _))| u * self.factor(*of) / covered).collect();
        let (place, spread) = cartesian(&coordinates, Some(&uncertain[..]).filter(|u| !u.is_empty()));
        point.xyz_mm = place;
        if spread.is_some() {
            point.standard_uncertainty_mm = spread;
        }
        // a tracker of rigid bodies writes zeros for a body that it does not see
        let unseen = turned.len() == 4 && turned.iter().all(|(_, value)| *value == 0.0) && place == [0.0; 3];
        if unseen && self.dialect.form.missing.origin() {
            point.refused = Some(Box::new(phrase!("row-invisible")));
            return;
        }
        match self.dialect.angle_order().and_then(|order| orientation(&mut turned, order)) {
            Ok(None) => {}
            Ok(turned) => point.orientation = turned,
            Err(message) => problems.0.push(message.at(row.place(self.file))),
        }
        direction.sort_by_key(|(role, _)| *role as usize);
        if let [(_, i), (_, j), (_, k)] = direction[..] {
            match unit_vector([i, j, k]) {
                Ok(direction) => point.direction = Some(direction),
                Err(message) => problems.0.push(message.at(row.place(self.file))),
            }
        }
    }

    /// Roles of the columns in this row, if rows contain their coordinate type; otherwise an error
    /// with the index of its cell.
    fn row_roles(&self, row: &Row) -> Result<Cow<'_, [ColumnRole]>, (Message, usize)> {
        let Some(at) = self.roles.iter().position(|r| *r == ColumnRole::Type) else {
            return Ok(Cow::Borrowed(&self.roles));
        };
        let name = row.field(at);
        let Some(meant) = self.dialect.types.get(name) else {
            let known: Vec<&str> = self.dialect.types.keys().map(String::as_str).collect();
            return Err((error!("coordinate-type-unknown", name, known), at));
        };
        let of = |role: &ColumnRole| {
            match role {
                ColumnRole::C1 => meant.first(),
                ColumnRole::C2 => meant.get(1),
                ColumnRole::C3 => meant.get(2),
                other => Some(other),
            }
            .copied()
        };
        Ok(self.roles.iter().map(|role| of(role).unwrap_or(ColumnRole::Skip)).collect())
    }

    /// From the file's unit to mm or rad.
    fn factor(&self, role: ColumnRole) -> f64 {
        match role.is_angle() {
            true => self.dialect.angle_unit.map_or(1.0, |unit| unit.in_rad()),
            false => self.unit.in_mm(),
        }
    }

    /// Reason if a coordinate of the row was not measured.
    fn not_measured<'r>(&self, cells: impl Iterator<Item = (ColumnRole, &'r str)>) -> Option<Phrase> {
        let cells: Vec<(ColumnRole, &str)> = cells.collect();
        if cells.iter().all(|(_, cell)| cell.is_empty()) {
            return Some(phrase!("row-without-coordinates"));
        }
        cells.into_iter().find_map(|(role, cell)| self.dialect.form.missing.reason(role.name(), cell))
    }

    /// Returns an error if points that are given as Cartesian look like angles and distances.
    fn looks_spherical(&self, points: &[Point]) -> Option<Message> {
        let roles: Vec<ColumnRole> = self.roles.iter().copied().filter(|r| r.is_coordinate()).collect();
        if self.dialect.coordinates.is_some() || coordinate_type(&roles) != Some(CoordinateType::Cartesian) {
            return None;
        }
        let measured = || points.iter().filter(|p| p.refused.is_none() && p.xyz_mm[0].is_finite());
        let first = measured().nth(2).and(measured().next())?;
        let angles = |p: &Point| {
            let [x, y, z] = p.xyz_mm.map(|v| v / self.unit.in_mm());
            // points in m near the instrument have such x and y too: the number of a distance is
            // large
            x.abs() <= TAU && (0.0..=PI).contains(&y) && z > 100.0
        };
        measured().all(angles).then(|| error!("coordinates-look-spherical").at(first.place_in(self.file)))
    }
}

/// `true` if a cell marks its row as deleted.
fn is_deleted(cell: &str) -> bool {
    ["1", "true", "yes", "y", "x", "deleted", "ja", "oui", "si"].iter().any(|mark| cell.eq_ignore_ascii_case(mark))
}

/// Quaternion of an orientation, of three angles in this order; `None` if all of its cells are
/// missing.
fn orientation(numbers: &mut [(ColumnRole, f64)], order: Option<AngleOrder>) -> Result<Option<[f64; 4]>, Message> {
    numbers.sort_by_key(|(role, _)| *role as usize);
    let Some((first, _)) = numbers.first() else { return Ok(None) };
    let form = ColumnRole::ORIENTATIONS.iter().find(|form| form.contains(first)).copied().unwrap_or(&[]);
    let values: Vec<f64> = numbers.iter().map(|(_, value)| *value).collect();
    if values.len() < form.len() {
        return Err(error!("orientation-incomplete", found = values.len(), needed = form.len()));
    }
    let pose = match values[..] {
        [w, x, y, z] => {
            let length = (w * w + x * x + y * y + z * z).sqrt();
            if !length.is_finite() || (length - 1.0).abs() >= QUATERNION {
                return Err(error!("quaternion-length", target = "`qw`, `qx`, `qy`, `qz`", length));
            }
            Pose::from_quaternion([w, x, y, z])
        }
        [a, b, c] => {
            let factor = if *first == ColumnRole::RxDeg { PI / 180.0 } else { 1.0 };
            let angles = [a, b, c].map(|v| v * factor);
            match order {
                Some(order) => order.pose(angles),
                None => Pose::from_rotation_vector(angles),
            }
        }
        _ => match <[f64; 9]>::try_from(values) {
            Ok(rows) => Pose::from_rotation(rows)?,
            Err(_) => return Ok(None),
        },
    };
    Ok(Some(pose.quaternion()))
}

/// Maximum difference from 1 of the length of a quaternion with three digits.
const QUATERNION: f64 = 2e-3;

/// Position of a point (mm) from coordinates (mm and rad) in the order of their columns, and its
/// standard uncertainties in x, y and z. Coordinates are independent, to first order; covariances
/// of x, y and z are omitted.
fn cartesian(of: &[(ColumnRole, f64)], uncertain: Option<&[f64]>) -> (Vector, Option<Vector>) {
    let get = |role: ColumnRole| of.iter().find(|(r, _)| *r == role).map(|(_, value)| *value);
    let turn = if get(ColumnRole::AzimuthClockwise).is_some() { -1.0 } else { 1.0 };
    let azimuth = turn * get(ColumnRole::Azimuth).or(get(ColumnRole::AzimuthClockwise)).unwrap_or(0.0);
    let (s, c) = azimuth.sin_cos();
    let (place, derivative): (Vector, &dyn Fn(ColumnRole) -> Vector) =
        match (get(ColumnRole::Radius), get(ColumnRole::Distance)) {
            (Some(radius), _) => {
                ([radius * c, radius * s, get(ColumnRole::Z).unwrap_or(0.0)], &move |role| match role {
                    ColumnRole::Radius => [c, s, 0.0],
                    ColumnRole::Z => [0.0, 0.0, 1.0],
                    _ => [-turn * radius * s, turn * radius * c, 0.0],
                })
            }
            (_, Some(distance)) => {
                // sine and cosine of the angle from the z axis, and which way it grows
                let (away, along, grows) = match (get(ColumnRole::Zenith), get(ColumnRole::Elevation)) {
                    (Some(zenith), _) => (zenith.sin(), zenith.cos(), 1.0),
                    (_, elevation) => (elevation.unwrap_or(0.0).cos(), elevation.unwrap_or(0.0).sin(), -1.0),
                };
                ([distance * away * c, distance * away * s, distance * along], &move |role| match role {
                    ColumnRole::Distance => [away * c, away * s, along],
                    ColumnRole::Zenith | ColumnRole::Elevation => {
                        [grows * distance * along * c, grows * distance * along * s, -grows * distance * away]
                    }
                    _ => [-turn * distance * away * s, turn * distance * away * c, 0.0],
                })
            }
            _ => {
                ([ColumnRole::X, ColumnRole::Y, ColumnRole::Z].map(|axis| get(axis).unwrap_or(0.0)), &|role| match role
                {
                    ColumnRole::X => [1.0, 0.0, 0.0],
                    ColumnRole::Y => [0.0, 1.0, 0.0],
                    _ => [0.0, 0.0, 1.0],
                })
            }
        };
    let spread = |u: &[f64]| {
        let share =
            |axis: usize| of.iter().zip(u).map(|((role, _), u)| (derivative(*role)[axis] * u).powi(2)).sum::<f64>();
        [0, 1, 2].map(|axis| share(axis).sqrt())
    };
    (place, uncertain.map(spread))
}

/// The direction, if its length is 1.
fn unit_vector(ijk: Vector) -> Result<Vector, Message> {
    let length = norm(ijk);
    if (length - 1.0).abs() <= DIRECTION {
        return Ok(ijk);
    }
    let [i, j, k] = ijk;
    let message = error!("direction-not-unit", i, j, k, length);
    let of_angles = norm(ijk.map(|angle| angle.to_radians().cos()));
    let is_angles = (of_angles - 1.0).abs() <= DIRECTION;
    let hint = if is_angles { phrase!("skip-direction-angles") } else { phrase!("skip-columns") };
    Err(message.hint(hint))
}

/// Header rows, the last of which names the columns, and the data.
fn write(rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
    let (dialect, decimals) = (how.dialect, how.decimals);
    let columns = named_columns(&dialect.columns)?;
    let unsupported = |kind: &str| WriteError::Unsupported(error!("format-not-simulated", kind));
    let delimiter = dialect.form.delimiter.ok_or_else(|| unsupported("fixed"))?;
    if !dialect.types.is_empty() {
        return Err(unsupported("types"));
    }
    let line = |field: &mut dyn FnMut(&ColumnRole, &str) -> String| {
        let fields: Vec<String> = columns.iter().map(|(role, name)| field(role, name)).collect();
        lexer::line(&fields, delimiter, dialect.form.comment.as_deref())
    };
    let mut all = String::new();
    if let Some(mark) = &dialect.form.comment {
        // as SpatialAnalyzer heads its ASCII points
        let headings: Vec<&str> = columns.iter().map(|(_, name)| name.as_str()).collect();
        all += &format!("{mark} AXES = CARTESIAN: X,  Y,  Z ({})\n", how.unit.name());
        all += &format!("{mark} {}\n\n", headings.join(",  "));
    }
    let header = if let Header::Rows(rows) = dialect.header() { rows } else { 1 };
    for remaining in (0..header).rev() {
        all += &line(&mut |_, name| if remaining == 0 { name.to_owned() } else { "simulated".to_owned() })?;
    }
    let number = |value, digits| lexer::written(value, digits, dialect.form.decimal());
    let in_unit = |rad: f64| rad / dialect.angle_unit.map_or(1.0, |unit| unit.in_rad());
    for row in rows {
        let mut skipped = how.skipped.iter();
        let mut skip = || skipped.next().map_or("-", String::as_str).to_owned();
        let [x, y, z] = row.xyz;
        // an angle needs more digits than a length
        let angle = |rad: f64| number(in_unit(rad), decimals + 6);
        all += &line(&mut |role, _| match role {
            ColumnRole::Label => row.label.clone(),
            ColumnRole::Target => row.target.clone(),
            ColumnRole::Pose => row.pose.to_string(),
            ColumnRole::Cycle => row.cycle.to_string(),
            ColumnRole::X => number(x, decimals),
            ColumnRole::Y => number(y, decimals),
            ColumnRole::Z => number(z, decimals),
            ColumnRole::Radius => number(x.hypot(y), decimals),
            ColumnRole::Distance => number(x.hypot(y).hypot(z), decimals),
            ColumnRole::Azimuth => angle(y.atan2(x)),
            ColumnRole::AzimuthClockwise => angle(-y.atan2(x)),
            ColumnRole::Zenith => angle(x.hypot(y).atan2(z)),
            ColumnRole::Elevation => angle(z.atan2(x.hypot(y))),
            ColumnRole::I | ColumnRole::J => number(0.0, decimals),
            ColumnRole::K => number(1.0, decimals),
            ColumnRole::TimeS => number(row.time_s, 6),
            _ => skip(),
        })?;
    }
    all += &dialect.form.end.iter().map(|end| format!("{end}\n")).collect::<String>();
    Ok(all)
}

/// Role of each column, with its name in the header.
fn named_columns(stated: &Columns) -> Result<Vec<(ColumnRole, String)>, WriteError> {
    match stated {
        Columns::InOrder(roles) => Ok(roles.iter().map(|role| (*role, role.name().to_owned())).collect()),
        Columns::Named(named) => {
            let name = |(role, column): &(ColumnRole, ColumnSource)| match column {
                ColumnSource::Heading(name) => Ok((*role, name.clone())),
                ColumnSource::Number(_) => {
                    Err(WriteError::Unsupported(error!("format-not-simulated", kind = "numbers")))
                }
            };
            named.iter().map(name).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ColumnRole::*;

    /// Lines of label and coordinates are read without rows of fields; an end mark sends each line
    /// to the reader of rows.
    #[test]
    fn plain_lines_are_read_as_rows_are() {
        let cells = [
            "a",
            "",
            " b ",
            "\"q,r\"",
            "\"s",
            "x y",
            "\"t\"\"u\"",
            "1",
            "-2.5",
            "1e3",
            "+4",
            "-",
            "nan",
            "3.",
            ".5",
            "1.2.3",
            "7 ",
        ];
        let by_comma = columns_in(Delimiter::Comma, &[Label, X, Skip, Y, Z]);
        let by_blank = columns_in(Delimiter::Blank, &[Z, X, Y]);
        let mut draws = etalon_base::noise::Noise::new(1, 0);
        let (mut read, mut refused) = (0, 0);
        for (dialect, separator, width) in [(by_comma, ",", 5), (by_blank, " ", 3)] {
            for _ in 0..8000 {
                let mut cell = |_| cells[(draws.uniform(0.5).abs() * 2.0 * cells.len() as f64) as usize % cells.len()];
                let line: Vec<&str> = (0..width).map(&mut cell).collect();
                let text: SharedText = format!("n,1,,-2.5,3\n{}\r\n1 2 3\n", line.join(separator)).as_str().into();
                let form = Form { end: Some("never".to_owned()), ..dialect.form.clone() };
                let by_rows = Dialect { form, ..dialect.clone() };
                let [plain, rows] = [&dialect, &by_rows].map(|d| point_rows("f", &text, d, Unit::Inch));
                // NaN differs from itself
                assert_eq!(format!("{plain:?}"), format!("{rows:?}"), "{line:?}");
                read += plain.0.len();
                refused += plain.1.0.len();
            }
        }
        assert!(read > 16_000 && refused > 8000, "{read} {refused}");
    }

    /// Three kinds of coordinates of (3, -4, 12): distance 13, radius 5.
    #[test]
    fn the_same_point_in_every_kind_of_coordinates() {
        let azimuth = (-4.0f64).atan2(3.0);
        let zenith = (12.0f64 / 13.0).acos();
        let up = std::f64::consts::FRAC_PI_2 - zenith;
        for of in [
            [(X, 3.0), (Y, -4.0), (Z, 12.0)],
            [(Radius, 5.0), (Azimuth, azimuth), (Z, 12.0)],
            [(Z, 12.0), (AzimuthClockwise, -azimuth), (Radius, 5.0)],
            [(Azimuth, azimuth), (Zenith, zenith), (Distance, 13.0)],
            [(Distance, 13.0), (AzimuthClockwise, -azimuth), (Elevation, up)],
        ] {
            let place = cartesian(&of, None).0;
            let off = place.iter().zip([3.0, -4.0, 12.0]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-14 * 13.0, "{of:?}: {place:?}");
        }
    }

    #[test]
    fn uncertainties_follow_numeric_derivatives() {
        let u = [2e-6, 3e-6, 0.004];
        for of in [
            [(Azimuth, 0.7), (Zenith, 1.2), (Distance, 3000.0)],
            [(AzimuthClockwise, 0.7), (Elevation, -0.4), (Distance, 3000.0)],
            [(AzimuthClockwise, 2.7), (Radius, 500.0), (Z, 7.0)],
            [(Z, 0.7), (X, 1.2), (Y, 3000.0)],
        ] {
            let (_, found) = cartesian(&of, Some(&u));
            let mut expected = [0.0f64; 3];
            for j in 0..3 {
                let step = |h: f64| {
                    let mut moved = of;
                    moved[j].1 += h;
                    cartesian(&moved, None).0
                };
                let h = 1e-6 * of[j].1.abs();
                let (before, after) = (step(-h), step(h));
                (0..3).for_each(|axis| expected[axis] += ((after[axis] - before[axis]) / (2.0 * h) * u[j]).powi(2));
            }
            for (found, expected) in found.unwrap().iter().zip(expected) {
                assert!((found - expected.sqrt()).abs() < 1e-7 * expected.sqrt().max(1e-4), "{of:?}");
            }
        }
    }

    /// Reads points in a dialect of commas with these rows of a header and columns.
    fn read(text: &str, header: usize, columns: &str, unit: Unit) -> (Vec<Point>, Problems) {
        let roles = columns.split(',').map(|name| {
            let name = serde::de::value::StrDeserializer::<serde::de::value::Error>::new(name);
            serde::Deserialize::deserialize(name).unwrap()
        });
        let form = Form { header: Some(Header::Rows(header)), ..Form::delimited(Delimiter::Comma) };
        let dialect = Dialect { form, columns: roles.collect::<Vec<ColumnRole>>().into(), ..Dialect::default() };
        point_rows("f", &text.into(), &dialect, unit)
    }

    #[test]
    fn a_unit_anywhere_above_the_data_is_compared_with_the_stated_one() {
        for head in ["-,m,m,m\n", "Unit,[m],[m],[m]\n", "Length Units,Meters\n", "units: m\n", "UNITS=M\n"] {
            let text = format!("{head}Name,X,Y,Z\nA,1.5,2.5,3.5\n");
            let (_, problems) = read(&text, 2, "label,x,y,z", Unit::Millimetre);
            assert!(problems.0[0].is("unit-differs", &[("of_file", &"m"), ("stated", &"mm")]), "{head}: {problems:?}");
            assert_eq!(problems.0[0].place.as_ref().and_then(|place| place.line), Some(1));
            assert!(read(&text, 2, "label,x,y,z", Unit::Metre).1.0.is_empty());
        }
        // two statements, of which one agrees
        let text = "units: m\nunit = mm\nA,1.5,2.5,3.5\n";
        assert!(read(text, 2, "label,x,y,z", Unit::Millimetre).1.0.is_empty());
    }

    #[test]
    fn a_header_that_takes_a_data_row_is_an_error() {
        let text = "take 3\n\nX,Y,Z\n1.5,2.5,3.5\n4.5,5.5,6.5\n";
        let (_, problems) = read(text, 3, "x,y,z", Unit::Millimetre);
        assert!(problems.0[0].is("header-is-data", &[("rows", &3), ("fewer", &2)]), "{problems:?}");
        assert_eq!(read(text, 2, "x,y,z", Unit::Millimetre).0.len(), 2);
        // numbers may be headings
        assert!(read("1,2,3\n1.5,2.5,3.5\n", 1, "x,y,z", Unit::Millimetre).1.0.is_empty());
    }

    #[test]
    fn a_body_that_the_tracker_does_not_see_is_not_measured() {
        let text = "0,0,0,0,0,0,0\n1.5,2.5,3.5,1,0,0,0\n";
        let (points, problems) = read(text, 0, "x,y,z,qw,qx,qy,qz", Unit::Millimetre);
        assert!(problems.0.is_empty(), "{problems:?}");
        assert!(points[0].refused.as_ref().is_some_and(|reason| reason.id == "row-invisible"));
        assert!(points[1].refused.is_none() && points[1].orientation.is_some());
        let (_, problems) = read("1.5,2.5,3.5,0,0,0,0\n", 0, "x,y,z,qw,qx,qy,qz", Unit::Millimetre);
        assert!(problems.0[0].is("quaternion-length", &[]), "{problems:?}");
    }
}
