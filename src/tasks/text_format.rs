//! Options for reading tables and texts of points: the keys of campaign.toml as options.

use super::call::pairs;
use super::inputs::{Table, named, parse_column_source};
use crate::stages::table_file::TableFile;
use etalon_base::error;
use etalon_base::message::Problems;
use etalon_formats::dialect::{ColumnRole, Columns, Dialect, Unit};
use etalon_formats::{Format, TableReading};
use etalon_tables::{Cells, ColumnSource, Constant, Form, Header, Missing, TableLayout};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Options of every table and text.
#[derive(Clone, Debug, Default, PartialEq, clap::Args, Deserialize)]
#[serde(default)]
pub struct TextForm {
    #[command(flatten)]
    #[serde(flatten)]
    cells: CellForm,
    #[command(flatten)]
    #[serde(flatten)]
    rows: RowForm,
}

/// Options for the cells of a table: marks and encoding of a text, or a sheet.
#[derive(Clone, Debug, Default, PartialEq, clap::Args, Deserialize)]
#[serde(default)]
struct CellForm {
    /// Delimiter of the columns: comma, semicolon, tab, bar or blank.
    #[arg(long)]
    delimiter: Option<String>,
    /// Widths of the columns (characters), for columns without a delimiter.
    #[arg(long, value_name = "WIDTH,...", value_delimiter = ',', conflicts_with_all = ["delimiter", "sheet"])]
    widths: Vec<usize>,
    /// Decimal mark: point or comma.
    #[arg(long)]
    decimal: Option<String>,
    /// Mark between groups of three digits: comma, point, apostrophe or blank.
    #[arg(long, value_name = "MARK")]
    thousands: Option<String>,
    /// Character encoding, if no byte-order mark gives it.
    #[arg(long)]
    encoding: Option<String>,
    /// Sheet of a workbook (.xlsx), or topic of a recording (MCAP), that contains the table.
    #[arg(long, visible_alias = "topic", value_name = "NAME", conflicts_with_all = ["delimiter", "encoding"])]
    sheet: Option<String>,
}

/// Options for the rows and columns of a table: header, names, missing cells, and rows to read.
#[derive(Clone, Debug, Default, PartialEq, clap::Args, Deserialize)]
#[serde(default)]
struct RowForm {
    /// Rows before the data: a number, or words of the last one, which names the columns.
    #[arg(long, value_name = "ROWS")]
    header: Option<String>,
    /// The table has no header: columns are given by number (--column q1_deg=3).
    #[arg(long, conflicts_with = "header")]
    no_header: bool,
    /// Source of a column that has another name in the file; may be repeated.
    ///
    /// A heading (q1_deg=J1), a number (q1_deg=3), or an expression ("x_mm=x_t - x_dif"). Where
    /// several tables have different headings, give each: the heading that a table has applies.
    #[arg(long = "column", value_name = "NAME=HEADING")]
    #[serde(rename = "column", deserialize_with = "pairs")]
    named: Vec<String>,
    /// Cells that mean "not measured", instead of the usual ones (an empty cell, nan, N/A ...).
    #[arg(long, value_name = "TEXT,...", value_delimiter = ',', allow_hyphen_values = true)]
    missing: Option<Vec<String>>,
    /// Beginning of lines to skip.
    #[arg(long, value_name = "TEXT", allow_hyphen_values = true)]
    comment: Option<String>,
    /// First cell of the row that ends the data.
    #[arg(long, value_name = "TEXT", allow_hyphen_values = true)]
    end: Option<String>,
    /// Read only rows with one of these cells in this column; may be repeated.
    #[arg(long, value_name = "COLUMN=CELL,...")]
    #[serde(deserialize_with = "pairs")]
    only: Vec<String>,
    /// Leave out rows with one of these cells in this column; may be repeated.
    #[arg(long, value_name = "COLUMN=CELL,...")]
    #[serde(deserialize_with = "pairs")]
    without: Vec<String>,
}

impl TextForm {
    /// Given form.
    fn form(&self) -> Result<Form, Problems> {
        let Self { cells, rows } = self;
        Ok(Form {
            delimiter: stated("--delimiter", cells.delimiter.as_deref())?,
            widths: cells.widths.clone(),
            decimal: stated("--decimal", cells.decimal.as_deref())?,
            thousands: stated("--thousands", cells.thousands.as_deref())?,
            encoding: stated("--encoding", cells.encoding.as_deref())?,
            sheet: cells.sheet.clone(),
            header: rows.header(),
            comment: rows.comment.clone(),
            end: rows.end.clone(),
            missing: rows.missing.clone().map(missing).transpose()?.unwrap_or_default(),
            only: filter("only", &rows.only)?,
            without: filter("without", &rows.without)?,
        })
    }

    /// Sources of the columns by name.
    fn columns(&self) -> Result<BTreeMap<String, ColumnSource>, Problems> {
        let all = self.rows.named.iter();
        all.map(|text| named("column", text).map(|(name, source)| (name, parse_column_source(source)))).collect()
    }

    /// Sources of the columns of one of several tables: of several headings for one column, the
    /// heading that the table has.
    fn columns_in_table(
        &self,
        table: Table,
        reading: &TableReading,
    ) -> Result<BTreeMap<String, ColumnSource>, Problems> {
        let mut all: BTreeMap<String, Vec<ColumnSource>> = BTreeMap::new();
        for text in &self.rows.named {
            let (name, source) = named("column", text)?;
            all.entry(name).or_default().push(parse_column_source(source));
        }
        let has = |name: &str, source: &ColumnSource| {
            let columns = BTreeMap::from([(name.to_owned(), source.clone())]);
            let layout = TableLayout { columns, constants: BTreeMap::new(), ..reading.layout.clone() };
            let read = table.read_as(&TableReading { layout, ..reading.clone() });
            read.is_ok_and(|read| read.table.has(name))
        };
        let mut columns = BTreeMap::new();
        for (name, sources) in all {
            let own: Vec<&ColumnSource> = match &sources[..] {
                [_] => sources.iter().collect(),
                _ => sources.iter().filter(|source| has(&name, source)).collect(),
            };
            if let [ColumnSource::Heading(first), ColumnSource::Heading(second), ..] = own[..] {
                let file = table.name();
                return Err(error!("option-column-ambiguous", column = name, file, first, second).into());
            }
            columns.extend(own.first().copied().or(sources.last()).map(|source| (name, source.clone())));
        }
        Ok(columns)
    }

    /// Table in the names of etalon, with any columns.
    fn reading(&self) -> Result<TableReading, Problems> {
        let (form, columns) = (self.form()?, self.columns()?);
        Ok(TableReading::any(TableLayout { form, columns, ..TableLayout::default() }))
    }

    /// Reads a table in the names of etalon, one of several for which the options are given.
    pub(crate) fn read(&self, table: Table) -> Result<TableFile, Problems> {
        self.one_of_several(table, self.reading()?)
    }

    /// Reads one of several tables for which the options are given; columns that it does not have
    /// are omitted.
    fn one_of_several(&self, table: Table, reading: TableReading) -> Result<TableFile, Problems> {
        let mut reading = TableReading { lenient: true, ..reading };
        reading.layout.columns = self.columns_in_table(table, &reading)?;
        table.read_as(&reading)
    }
}

impl RowForm {
    /// Given header, if any.
    fn header(&self) -> Option<Header> {
        let stated = self.header.as_deref().map(|text| match text.trim().parse() {
            Ok(rows) => Header::Rows(rows),
            Err(_) => Header::Words(vec![text.to_owned()]),
        });
        stated.or_else(|| self.no_header.then_some(Header::Rows(0)))
    }
}

/// Unit and columns of a text of points.
#[derive(Clone, Debug, Default, clap::Args, Deserialize)]
#[serde(default)]
pub struct TextFormat {
    /// Length unit of the files: `mm`, `m`, `um` or `inch`; needed for a file that does not give
    /// its unit, and never guessed.
    #[arg(long)]
    unit: Option<String>,
    /// Contents of the columns from the left, e.g. label,x,y,z; `-` for an unused column.
    #[arg(long, value_delimiter = ',', allow_hyphen_values = true)]
    columns: Vec<String>,
    /// Unit of azimuth, zenith and elevation: deg, rad or gon.
    #[arg(long, value_name = "UNIT")]
    angle_unit: Option<String>,
    #[command(flatten)]
    #[serde(flatten)]
    form: TextForm,
}

impl TextFormat {
    /// `true` if the contents of the columns are given from the left.
    pub(crate) fn in_order(&self) -> bool {
        !self.columns.is_empty()
    }

    /// `true` if a form of text is given.
    pub(crate) fn stated(&self) -> bool {
        let CellForm { delimiter, widths, decimal, sheet, .. } = &self.form.cells;
        self.in_order()
            || delimiter.is_some()
            || !widths.is_empty()
            || decimal.is_some()
            || sheet.is_some()
            || !self.form.rows.named.is_empty()
    }

    /// `true` if the text of a file depends on an encoding or a sheet.
    pub(crate) fn is_of_plain_text(&self) -> bool {
        self.form.cells.encoding.is_none() && self.form.cells.sheet.is_none()
    }

    /// Given unit, if any.
    pub(crate) fn stated_unit(&self) -> Result<Option<Unit>, Problems> {
        self.unit.as_deref().map(|name| word("--unit", name)).transpose()
    }

    /// Unit of a text in a format: as given, or as the text gives it.
    pub(crate) fn unit(&self, format: &Format, text: &str) -> Result<Unit, Problems> {
        let unit = self.stated_unit()?.or_else(|| format.stated_unit(text));
        unit.ok_or_else(|| error!("option-unit-missing").into())
    }

    /// Options of the tables that belong to a recording.
    pub(crate) fn form(&self) -> &TextForm {
        &self.form
    }

    /// Given columns, by default PolyWorks text.
    pub(crate) fn format(&self) -> Result<Format, Problems> {
        if !self.stated() {
            return Ok(Format::default());
        }
        let form = &self.form;
        let roles = self.columns.iter().map(|c| word::<ColumnRole>("--columns", c)).collect::<Result<Vec<_>, _>>()?;
        let columns = match (roles.is_empty(), form.rows.named.is_empty()) {
            (false, false) => return Err(error!("option-columns-twice").into()),
            (_, true) => roles.into(),
            (true, false) => Columns::Named(form.rows.named.iter().map(|text| role(text)).collect::<Result<_, _>>()?),
        };
        let by_heading = matches!(&columns, Columns::Named(named) if named.iter().any(|(_, at)| is_heading(at)));
        let mut form = form.form()?;
        form.header = form.header.or(Some(Header::Rows(usize::from(by_heading))));
        let angle_unit = stated("--angle-unit", self.angle_unit.as_deref())?;
        let dialect = Dialect { form, columns, angle_unit, ..Dialect::default() };
        Problems(dialect.check()).check()?;
        Ok(Format::from(dialect))
    }

    /// Reads the text of a file of points.
    pub(crate) fn text(&self, table: Table, format: &Format) -> Result<String, Problems> {
        match table {
            Table::Text { text, .. } => Ok(text.to_owned()),
            Table::File(path) if self.is_of_plain_text() => etalon_formats::text_in(path, format),
            Table::Headed { table, .. } => self.text(*table, format),
            Table::File(path) | Table::Sheet { path, .. } => {
                let encoding = stated("--encoding", self.form.cells.encoding.as_deref())?;
                etalon_formats::file_text(path, &etalon_formats::read_bytes(path)?, encoding, format)
            }
        }
    }
}

/// Options for reading a table of observations, poses, loads or joints.
#[derive(Clone, Debug, Default, PartialEq, clap::Args, Deserialize)]
#[serde(default)]
pub struct TableFormat {
    #[command(flatten)]
    #[serde(flatten)]
    form: TextForm,
    /// Column with the same value in all rows; may be repeated.
    #[arg(long = "constant", value_name = "NAME=VALUE")]
    #[serde(rename = "constant", deserialize_with = "pairs")]
    constants: Vec<String>,
    /// Coverage factor of the columns of uncertainties, if they are expanded.
    #[arg(long, value_name = "K")]
    coverage_factor: Option<f64>,
    /// Target of all rows of a table without such a column.
    #[arg(long, value_name = "NAME")]
    target: Option<String>,
    /// `row` if the number of the data row is the number of the pose, for a table without such a
    /// column.
    #[arg(long, value_name = "ROW")]
    pose: Option<String>,
}

impl From<&TextForm> for TableFormat {
    fn from(form: &TextForm) -> Self {
        Self { form: form.clone(), ..Self::default() }
    }
}

impl TableFormat {
    /// `true` if no option is given.
    pub(crate) fn is_default(&self) -> bool {
        *self == Self::default()
    }

    /// Reads the table of observations in the file.
    pub(crate) fn read(&self, table: Table) -> Result<TableFile, Problems> {
        table.read_as(&self.reading(false)?)
    }

    /// Reads a table of poses, loads or joints.
    pub(crate) fn read_other(&self, table: Table) -> Result<TableFile, Problems> {
        table.read_as(&self.reading(true)?)
    }

    /// Reads one of several tables of poses; columns that it does not have are omitted.
    pub(crate) fn read_poses(&self, table: Table) -> Result<TableFile, Problems> {
        self.form.one_of_several(table, self.reading(true)?)
    }

    /// Reads a table that belongs to attained poses: without constant columns, and numbered by its
    /// rows if it has no column `pose`.
    pub(crate) fn read_beside(&self, table: Table) -> Result<TableFile, Problems> {
        let reading = self.reading(true)?;
        let (layout, pose) =
            (TableLayout { constants: BTreeMap::new(), pose: None, ..reading.layout }, reading.layout.pose);
        let reading = TableReading { layout, ..reading };
        let read = self.form.one_of_several(table, reading.clone())?;
        if read.table.has("pose") || pose.is_none() {
            return Ok(read);
        }
        let layout = TableLayout { pose, ..reading.layout };
        self.form.one_of_several(table, TableReading { layout, ..reading })
    }

    /// Names of the columns whose source is given.
    pub(crate) fn named(&self) -> Result<Vec<String>, Problems> {
        Ok(self.form.columns()?.into_keys().collect())
    }

    /// Given source of a column as an operand of an expression, if any.
    pub(crate) fn source(&self, column: &str) -> Result<Option<String>, Problems> {
        Ok(self.form.columns()?.remove(column).map(|source| match source {
            ColumnSource::Number(number) => format!("${number}"),
            // an expression, or a heading with a mark of one
            ColumnSource::Heading(text) if text.contains(['+', '-', '*', '/']) => format!("({text})"),
            ColumnSource::Heading(text) => text,
        }))
    }

    /// Table of observations, or one with any columns.
    fn reading(&self, any_columns: bool) -> Result<TableReading, Problems> {
        let constant = |text: &String| named("constant", text).map(|(name, value)| (name, parse_constant(value)));
        let mut reading = self.form.reading()?;
        reading.layout.constants = self.constants.iter().map(constant).collect::<Result<_, _>>()?;
        reading.layout.pose = stated("--pose", self.pose.as_deref())?;
        let (coverage_factor, target) = (self.coverage_factor, self.target.clone());
        Ok(TableReading { any_columns, coverage_factor, target, ..reading })
    }
}

/// Value of an option, if it is given.
fn stated<T: serde::de::DeserializeOwned>(option: &str, text: Option<&str>) -> Result<Option<T>, Problems> {
    text.map(|text| word(option, text)).transpose()
}

/// Role of a column, and the heading, number or expression that it is.
fn role(text: &str) -> Result<(ColumnRole, ColumnSource), Problems> {
    let (name, source) = named("column", text)?;
    Ok((word("--column", &name)?, parse_column_source(source)))
}

/// `true` for a heading, which needs a header.
fn is_heading(at: &ColumnSource) -> bool {
    matches!(at, ColumnSource::Heading(name) if !name.contains('$'))
}

/// A number, or a text.
fn parse_constant(text: &str) -> Constant {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Constant::Number(number),
        _ => Constant::Text(text.to_owned()),
    }
}

/// Cells by column of the options of a filter.
fn filter(option: &str, stated: &[String]) -> Result<BTreeMap<String, Cells>, Problems> {
    let cells = |text: &str| Cells::Any(text.split(',').map(|cell| parse_constant(cell.trim())).collect());
    stated.iter().map(|text| named(option, text).map(|(column, all)| (column, cells(all)))).collect()
}

/// Texts of cells that mean "not measured".
fn missing(texts: Vec<String>) -> Result<Missing, Problems> {
    type Texts = serde::de::value::SeqDeserializer<std::vec::IntoIter<String>, serde::de::value::Error>;
    let found = <Missing as serde::Deserialize>::deserialize(Texts::new(texts.into_iter()));
    found.map_err(|e| error!("option-refused", option = "--missing", reason = e.to_string()).into())
}

/// Format of an option: a name, or a table of keys as a campaign gives it.
pub(crate) fn stated_format(text: &str) -> Result<Format, Problems> {
    #[derive(Deserialize)]
    struct Stated {
        format: Format,
    }
    if !text.trim_start().starts_with('{') {
        return word("--format", text);
    }
    let refused = |reason: &str| error!("option-refused", option = "--format", reason = reason.trim());
    let stated: Stated = toml::from_str(&format!("format = {text}")).map_err(|e| refused(e.message()))?;
    Problems(stated.format.dialect.check()).check()?;
    Ok(stated.format)
}

/// A word of an option, as the campaign spells it.
pub(crate) fn word<T: serde::de::DeserializeOwned>(option: &str, text: &str) -> Result<T, Problems> {
    let value = serde::de::value::StrDeserializer::<serde::de::value::Error>::new(text);
    T::deserialize(value).map_err(|e| error!("option-refused", option, reason = e.to_string()).into())
}
