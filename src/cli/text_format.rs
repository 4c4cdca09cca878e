//! Options for reading a text of points.

use super::table_file::TableFile;
use etalon_base::error;
use etalon_base::message::Problems;
use etalon_formats::dialect::FromRow;
use etalon_formats::dialect::{ColumnRole, Decimal, Delimiter, Dialect, Header, Unit};
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
    /// Sheet of a workbook (.xlsx) that contains the table.
    #[arg(long, value_name = "NAME", conflicts_with_all = ["delimiter", "decimal", "encoding"])]
    sheet: Option<String>,
    /// Heading in the file of a column whose heading differs from its name: q1_deg=J1; may be
    /// repeated.
    #[arg(long = "column", value_name = "NAME=HEADING")]
    columns: Vec<String>,
    /// Target of all rows, for a table without such a column.
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
        let column = |text: &String| match text.split_once('=') {
            Some((name, heading)) => Ok((name.trim().to_owned(), heading.trim().to_owned())),
            None => Err(Problems::from(error!("column-option-malformed", text))),
        };
        let layout = TableLayout {
            delimiter: word("--delimiter", &self.delimiter)?,
            decimal: word("--decimal", &self.decimal)?,
            columns: self.columns.iter().map(column).collect::<Result<_, _>>()?,
            target: self.target.clone(),
            pose: self.pose.as_deref().map(|row| word::<FromRow>("--pose", row)).transpose()?,
        };
        let encoding = self.encoding.as_deref().map(|name| word("--encoding", name)).transpose()?;
        TableFile::observations(path, &etalon_formats::bytes_of(path)?, layout, encoding, self.sheet.as_deref())
    }
}

/// Parses a word of an option in the spelling of campaigns.
pub(super) fn word<T: serde::de::DeserializeOwned>(option: &str, text: &str) -> Result<T, Problems> {
    let value = serde::de::value::StrDeserializer::<serde::de::value::Error>::new(text);
    T::deserialize(value).map_err(|e| error!("option-refused", option, reason = e.to_string()).into())
}
