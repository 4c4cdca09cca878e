//! Options for reading a text of points.

use super::table_file::TableFile;
use etalon_base::error;
use etalon_base::message::Problems;
use etalon_formats::dialect::FromRow;
use etalon_formats::dialect::{ColumnRole, ColumnSource, Decimal, Delimiter, Dialect, Header, Missing, Unit};
use etalon_formats::{Format, TableLayout};
use std::path::Path;

/// Unit and columns of a text.
#[derive(Debug, clap::Args)]
pub(super) struct TextFormat {
    /// Length unit of the files: `mm`, `m`, `um` or `inch`; never guessed (QIF states its own).
    #[arg(long)]
    unit: Option<String>,
    /// Contents of the columns, e.g. label,x,y,z; `-` for an unused column.
    #[arg(long, value_delimiter = ',', requires = "delimiter", allow_hyphen_values = true)]
    columns: Vec<String>,
    /// Delimiter: blank, tab, comma, semicolon or bar.
    #[arg(long, requires = "columns")]
    delimiter: Option<String>,
    /// Decimal mark: point or comma.
    #[arg(long, default_value = "point", requires = "columns")]
    decimal: String,
    /// Number of rows before the data.
    #[arg(long, default_value_t = 0, requires = "columns")]
    header: usize,
}

impl TextFormat {
    /// `true` if columns are stated.
    pub fn stated(&self) -> bool {
        self.delimiter.is_some()
    }

    /// Stated unit, if any.
    pub fn stated_unit(&self) -> Result<Option<Unit>, Problems> {
        self.unit.as_deref().map(|name| word("--unit", name)).transpose()
    }

    /// Mandatory unit.
    pub fn unit(&self) -> Result<Unit, Problems> {
        self.stated_unit()?.ok_or_else(|| error!("option-unit-missing").into())
    }

    /// Stated columns, by default PolyWorks text.
    pub fn format(&self) -> Result<Format, Problems> {
        let Some(delimiter) = &self.delimiter else { return Ok(Format::default()) };
        let columns = self.columns.iter().map(|c| word::<ColumnRole>("--columns", c)).collect::<Result<Vec<_>, _>>()?;
        Ok(Format::from(Dialect {
            delimiter: Some(word::<Delimiter>("--delimiter", delimiter)?),
            decimal: word::<Decimal>("--decimal", &self.decimal)?,
            columns: columns.into(),
            header: Header::Rows(self.header),
            ..Dialect::default()
        }))
    }
}

/// Options for reading a table of observations.
#[derive(Debug, clap::Args)]
pub(super) struct TableFormat {
    /// Delimiter of the columns: comma, semicolon, tab, bar or blank.
    #[arg(long, default_value = "comma")]
    delimiter: String,
    /// Decimal mark: point or comma.
    #[arg(long, default_value = "point")]
    decimal: String,
    /// Character encoding, if no byte-order mark states it.
    #[arg(long)]
    encoding: Option<String>,
    /// Sheet of a workbook (.xlsx), or topic of a recording (MCAP), that contains the table.
    #[arg(long, visible_alias = "topic", value_name = "NAME", conflicts_with_all = ["delimiter", "decimal", "encoding"])]
    sheet: Option<String>,
    /// Source of a column that has another name in the file; may be repeated.
    ///
    /// A heading (q1_deg=J1), a number (q1_deg=3), or an expression ("x_mm=x_t - x_dif").
    #[arg(long = "column", value_name = "NAME=HEADING")]
    columns: Vec<String>,
    /// The table has no header: columns are given by number (--column q1_deg=3).
    #[arg(long)]
    no_header: bool,
    /// Cells that mean "not measured", in place of the usual ones (an empty cell, nan, N/A ...).
    #[arg(long, value_name = "TEXT,...", value_delimiter = ',', allow_hyphen_values = true)]
    missing: Option<Vec<String>>,
    /// Beginning of lines to skip.
    #[arg(long, value_name = "TEXT", allow_hyphen_values = true)]
    comment: Option<String>,
    /// Target of all rows of a table without such a column.
    #[arg(long, value_name = "NAME")]
    target: Option<String>,
    /// `row` if the number of the data row is the number of the pose, for a table without such a
    /// column.
    #[arg(long, value_name = "ROW")]
    pose: Option<String>,
}

impl TableFormat {
    /// Reads the table in the file.
    pub fn read(&self, path: &Path) -> Result<TableFile, Problems> {
        self.table(path, false)
    }

    /// A table of poses, which has no column `cycle` where it states commanded ones.
    pub fn read_poses(&self, path: &Path) -> Result<TableFile, Problems> {
        self.table(path, true)
    }

    /// The table in a text.
    pub fn parse(&self, name: &str, text: &str) -> Result<TableFile, Problems> {
        TableFile::parse_with(name, text, &self.layout(false)?)
    }

    fn table(&self, path: &Path, lenient: bool) -> Result<TableFile, Problems> {
        let layout = self.layout(lenient)?;
        let encoding = self.encoding.as_deref().map(|name| word("--encoding", name)).transpose()?;
        TableFile::observations(path, &etalon_formats::bytes_of(path)?, layout, encoding, self.sheet.as_deref())
    }

    fn layout(&self, lenient: bool) -> Result<TableLayout, Problems> {
        let column = |text: &String| match text.split_once('=') {
            Some((name, source)) => Ok((name.trim().to_owned(), source_of(source.trim()))),
            None => Err(Problems::from(error!("column-option-malformed", text))),
        };
        Ok(TableLayout {
            delimiter: word("--delimiter", &self.delimiter)?,
            decimal: word("--decimal", &self.decimal)?,
            columns: self.columns.iter().map(column).collect::<Result<_, _>>()?,
            header: Header::Rows(usize::from(!self.no_header)),
            comment: self.comment.clone(),
            missing: self.missing.clone().map(missing).transpose()?.unwrap_or_default(),
            lenient,
            target: self.target.clone(),
            pose: self.pose.as_deref().map(|row| word::<FromRow>("--pose", row)).transpose()?,
            ..TableLayout::default()
        })
    }
}

/// Texts of cells that mean "not measured".
fn missing(texts: Vec<String>) -> Result<Missing, Problems> {
    type Texts = serde::de::value::SeqDeserializer<std::vec::IntoIter<String>, serde::de::value::Error>;
    let found = <Missing as serde::Deserialize>::deserialize(Texts::new(texts.into_iter()));
    found.map_err(|e| error!("option-refused", option = "--missing", reason = e.to_string()).into())
}

/// A number of a column, or a heading or an expression.
fn source_of(text: &str) -> ColumnSource {
    match text.parse::<usize>() {
        Ok(number) if number > 0 => ColumnSource::Number(number),
        _ => text.into(),
    }
}

/// A word of an option, as the campaign spells it.
pub(super) fn word<T: serde::de::DeserializeOwned>(option: &str, text: &str) -> Result<T, Problems> {
    let value = serde::de::value::StrDeserializer::<serde::de::value::Error>::new(text);
    T::deserialize(value).map_err(|e| error!("option-refused", option, reason = e.to_string()).into())
}
