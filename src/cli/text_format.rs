//! Options that state how a text of points is read.

use super::table_file::TableFile;
use etalon_base::message::{Message, Problems};
use etalon_formats::dialect::FromRow;
use etalon_formats::dialect::{ColumnRole, Decimal, Delimiter, Dialect, Header, Unit};
use etalon_formats::{Format, TableLayout};
use std::path::Path;

/// Unit and columns of a text.
#[derive(Debug, clap::Args)]
pub(super) struct TextFormat {
    /// Length unit of the files: mm, m, um or inch; never guessed (QIF states its own)
    #[arg(long)]
    unit: Option<String>,
    /// What the columns hold, e.g. label,x,y,z; `-` for a column that is not read
    #[arg(long, value_delimiter = ',', requires = "delimiter", allow_hyphen_values = true)]
    columns: Vec<String>,
    /// blank, tab, comma, semicolon or bar
    #[arg(long, requires = "columns")]
    delimiter: Option<String>,
    /// Decimal mark: point or comma
    #[arg(long, default_value = "point", requires = "columns")]
    decimal: String,
    /// Rows before the data
    #[arg(long, default_value_t = 0, requires = "columns")]
    header: usize,
}

impl TextFormat {
    /// Whether columns are stated.
    pub fn stated(&self) -> bool {
        self.delimiter.is_some()
    }

    /// The unit, where it is stated.
    pub fn stated_unit(&self) -> Result<Option<Unit>, Problems> {
        self.unit.as_deref().map(|name| word("--unit", name)).transpose()
    }

    /// The unit, which must be stated.
    pub fn unit(&self) -> Result<Unit, Problems> {
        self.stated_unit()?.ok_or_else(|| {
            let message = Message::error("the files do not say their length unit");
            message.hint("state it: --unit mm, m, um or inch; it is never guessed").into()
        })
    }

    /// The stated columns, else PolyWorks text.
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

/// How a table of observations is read.
#[derive(Debug, clap::Args)]
pub(super) struct TableFormat {
    /// What separates the columns: comma, semicolon, tab, bar or blank
    #[arg(long, default_value = "comma")]
    delimiter: String,
    /// Decimal mark: point or comma
    #[arg(long, default_value = "point")]
    decimal: String,
    /// Encoding of the characters, where no byte-order mark states it
    #[arg(long)]
    encoding: Option<String>,
    /// Sheet of a workbook (.xlsx) that holds the table
    #[arg(long, value_name = "NAME", conflicts_with_all = ["delimiter", "decimal", "encoding"])]
    sheet: Option<String>,
    /// The heading in the file of a column that is called otherwise there: q1_deg=J1; may be repeated
    #[arg(long = "column", value_name = "NAME=HEADING")]
    columns: Vec<String>,
    /// The target of all rows, of a table without such a column
    #[arg(long, value_name = "NAME")]
    target: Option<String>,
    /// `row`: the number of the data row is the number of the pose, of a table without such a column
    #[arg(long, value_name = "ROW")]
    pose: Option<String>,
}

impl TableFormat {
    /// The table in the file.
    pub fn read(&self, path: &Path) -> Result<TableFile, Problems> {
        let layout = self.layout()?;
        let encoding = self.encoding.as_deref().map(|name| word("--encoding", name)).transpose()?;
        TableFile::observations(path, &etalon_formats::bytes_of(path)?, layout, encoding, self.sheet.as_deref())
    }

    /// The table in a text.
    pub fn parse(&self, name: &str, text: &str) -> Result<TableFile, Problems> {
        TableFile::parse_with(name, text, &self.layout()?)
    }

    fn layout(&self) -> Result<TableLayout, Problems> {
        let column = |text: &String| match text.split_once('=') {
            Some((name, heading)) => Ok((name.trim().to_owned(), heading.trim().to_owned())),
            None => Err(Problems::from(Message::error(format!("--column: `{text}` has no `=`")).expected("q1_deg=J1"))),
        };
        Ok(TableLayout {
            delimiter: word("--delimiter", &self.delimiter)?,
            decimal: word("--decimal", &self.decimal)?,
            columns: self.columns.iter().map(column).collect::<Result<_, _>>()?,
            target: self.target.clone(),
            pose: self.pose.as_deref().map(|row| word::<FromRow>("--pose", row)).transpose()?,
        })
    }
}

/// A word of an option, as the campaign spells it.
pub(super) fn word<T: serde::de::DeserializeOwned>(option: &str, text: &str) -> Result<T, Problems> {
    let value = serde::de::value::StrDeserializer::<serde::de::value::Error>::new(text);
    T::deserialize(value).map_err(|e| Message::error(format!("{option}: {e}")).into())
}
