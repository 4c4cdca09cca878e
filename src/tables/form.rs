//! Form of a table: how its text is split, and which of its rows are read. Every section and every
//! command with a table has these keys, with the same meaning.

use crate::from_row::FromRow;
use crate::marks::{Decimal, Delimiter, Thousands, two_commas};
use crate::source::{Cells, ColumnSource, Constant};
use crate::text::{Encoding, Header, Missing};
use etalon_base::error;
use etalon_base::message::Message;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;

/// `true` for the name of a topic. Names of sheets of a workbook cannot contain `/`.
pub fn is_topic(name: &str) -> bool {
    name.starts_with('/')
}

/// Form of the text or of the sheet of a table.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Form {
    /// Delimiter of the columns; in a table a comma, if nothing else is given.
    pub delimiter: Option<Delimiter>,
    /// Width of each column (characters), for columns without a delimiter.
    pub widths: Vec<usize>,
    /// Decimal mark; in a workbook, the decimal mark of text cells.
    #[schemars(extend("default" = "."))]
    pub decimal: Option<Decimal>,
    /// Mark between groups of three digits.
    pub thousands: Option<Thousands>,
    /// Character encoding, if no byte-order mark gives it.
    #[schemars(extend("default" = "utf-8"))]
    pub encoding: Option<Encoding>,
    /// Sheet of a workbook that contains the table, or as `topic` the topic of a recording (MCAP);
    /// delimiter and encoding do not apply.
    #[serde(alias = "topic")]
    pub sheet: Option<String>,
    /// Rows before the data; the last of them names the columns. A number, `true` (one), `false`
    /// (none), or words of the row. The default is 1, or 0 if `columns` is a list without names.
    pub header: Option<Header>,
    /// Beginning of lines that are skipped.
    pub comment: Option<String>,
    /// Cells that mean "not measured", in addition to empty ones.
    pub missing: Missing,
    /// First cell of the row that ends the data.
    pub end: Option<String>,
    /// Filter of the rows: only rows with one of these cells in each of these columns (a heading,
    /// or `$3`) are read. Other rows are listed as excluded.
    pub only: BTreeMap<String, Cells>,
    /// Filter of the rows: rows with one of these cells in one of these columns are omitted.
    pub without: BTreeMap<String, Cells>,
}

impl Form {
    /// This form for a text with commas and decimal points: without marks, encoding and sheet.
    #[must_use]
    pub fn without_marks(&self) -> Self {
        let (header, comment, missing, end) = (&self.header, &self.comment, &self.missing, &self.end);
        Self {
            header: header.clone(),
            comment: comment.clone(),
            missing: missing.clone(),
            end: end.clone(),
            only: self.only.clone(),
            without: self.without.clone(),
            ..Self::default()
        }
    }

    /// Form of a text with this delimiter.
    pub fn delimited(delimiter: Delimiter) -> Self {
        Self { delimiter: Some(delimiter), ..Self::default() }
    }

    /// Delimiter of the columns of a table: the cells of a sheet become a text with tabs.
    pub fn delimiter(&self) -> Delimiter {
        self.delimiter.unwrap_or(if self.sheet.is_some() { Delimiter::Tab } else { Delimiter::Comma })
    }

    /// Decimal mark.
    pub fn decimal(&self) -> Decimal {
        self.decimal.unwrap_or_default()
    }

    /// Header of a table, which names its columns.
    pub fn header(&self) -> Header {
        self.header.clone().unwrap_or(Header::Rows(1))
    }

    /// `true` if rows are omitted by their cells.
    pub fn is_filtered(&self) -> bool {
        !(self.only.is_empty() && self.without.is_empty())
    }

    /// `true` for a topic of a recording.
    pub fn is_topic(&self) -> bool {
        self.sheet.as_deref().is_some_and(is_topic)
    }

    /// Key that is given together with `sheet` and does not apply to it.
    pub fn meaningless_beside_sheet(&self) -> Option<&'static str> {
        let text = [
            ("delimiter", self.delimiter.is_some()),
            ("widths", !self.widths.is_empty()),
            ("encoding", self.encoding.is_some()),
        ];
        let cells = [("decimal", self.decimal.is_some()), ("thousands", self.thousands.is_some())];
        let of_topic = cells.into_iter().filter(|_| self.is_topic());
        let stated = text.into_iter().chain(of_topic).find(|(_, stated)| *stated);
        stated.filter(|_| self.sheet.is_some()).map(|(key, _)| key)
    }

    /// Error of marks that cannot be told apart: a comma or another mark with two meanings.
    pub fn ambiguous_marks(&self, delimiter: Option<Delimiter>) -> Option<Message> {
        if (delimiter, self.decimal()) == (Some(Delimiter::Comma), Decimal::Comma) {
            return Some(two_commas());
        }
        let thousands = self.thousands?;
        let is_delimiter = delimiter.is_some_and(|d| d.name() == thousands.name())
            || (thousands == Thousands::Blank && delimiter == Some(Delimiter::Blank));
        let other = match thousands.name() == self.decimal().name() {
            true => "decimal",
            false if is_delimiter => "delimiter",
            false => return None,
        };
        Some(error!("thousands-mark-ambiguous", mark = thousands.name(), other))
    }

    /// This form, completed by another one: the marks, the encoding, the comments and the missing
    /// cells of a section apply to its tables.
    pub fn or(&self, section: &Self) -> Self {
        if self.sheet.is_some() {
            return self.clone();
        }
        let is_split = self.delimiter.is_some() || !self.widths.is_empty();
        let is_text = is_split || self.decimal.is_some() || self.encoding.is_some();
        let is_usual = self.missing == Missing::default();
        Self {
            delimiter: if is_split { self.delimiter } else { section.delimiter },
            widths: if is_split { self.widths.clone() } else { section.widths.clone() },
            decimal: self.decimal.or(section.decimal),
            thousands: self.thousands.or(section.thousands),
            encoding: self.encoding.or(section.encoding),
            sheet: section.sheet.clone().filter(|_| !is_text),
            comment: self.comment.clone().or_else(|| section.comment.clone()),
            end: self.end.clone().or_else(|| section.end.clone()),
            missing: if is_usual { section.missing.clone() } else { self.missing.clone() },
            ..self.clone()
        }
    }
}

/// Form of a table with a heading for each column, and the columns that it has or lacks.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(default)]
pub struct TableLayout {
    /// Form of the text.
    #[serde(flatten)]
    pub form: Form,
    /// Source of each column that has another name in the file: a heading, a number from 1, or an
    /// expression (`x_t - x_dif`).
    pub columns: BTreeMap<String, ColumnSource>,
    /// Columns with the same value in all rows, e.g. `cycle = 1`; `cycle = "visit"` counts the rows
    /// of each pose and target.
    pub constants: BTreeMap<String, Constant>,
    /// Pose number from the number of the data row, for a table without the column: `row`, or
    /// `row + 100` with an offset.
    pub pose: Option<FromRow>,
}

impl TableLayout {
    /// This layout in a section with another one, whose marks apply where it gives none.
    pub fn or(&self, section: &Self) -> Self {
        Self { form: self.form.or(&section.form), ..self.clone() }
    }
}
