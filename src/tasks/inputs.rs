//! Tables and robots that a task is given: files, or texts in memory.

use crate::stages::table_file::TableFile;
use etalon_base::message::Result;
use etalon_base::{error, files};
use etalon_campaign::RobotFile;
use etalon_formats::TableReading;
use etalon_tables::{ColumnSource, Form, TableLayout};
use std::collections::BTreeMap;
use std::path::Path;

/// A table.
#[derive(Clone, Copy, Debug)]
pub enum Table<'a> {
    /// A file.
    File(&'a Path),
    /// A sheet of a workbook, or a topic of a recording.
    Sheet {
        /// The file.
        path: &'a Path,
        /// Name of the sheet or topic.
        sheet: &'a str,
    },
    /// CSV text with a header.
    Text {
        /// Name for messages and for the list of inputs.
        name: &'a str,
        /// Text, with commas and decimal points; marks of files do not apply.
        text: &'a str,
    },
    /// One of several tables, with headings of its own.
    Headed {
        /// The table.
        table: &'a Table<'a>,
        /// Sources of columns that have another name in this table, `NAME=HEADING`.
        columns: &'a [String],
    },
}

impl Table<'_> {
    /// Name for messages and for the list of inputs.
    pub(super) fn name(&self) -> String {
        match self {
            Self::File(path) | Self::Sheet { path, .. } => path.display().to_string(),
            Self::Text { name, .. } => (*name).to_owned(),
            Self::Headed { table, .. } => table.name(),
        }
    }

    /// Reads a table without options.
    pub(crate) fn read(&self) -> Result<TableFile> {
        match self {
            Self::File(path) => TableFile::read(path),
            Self::Text { name, text } => TableFile::parse(name, text),
            Self::Sheet { .. } | Self::Headed { .. } => self.read_as(&TableReading::default()),
        }
    }

    /// Reads a table in a layout. Marks, encoding and sheet of the layout concern files.
    pub(super) fn read_as(self, reading: &TableReading) -> Result<TableFile> {
        let with_form = |form: Form| {
            let layout = TableLayout { form, ..reading.layout.clone() };
            TableReading { layout, ..reading.clone() }
        };
        let form = &reading.layout.form;
        match self {
            Self::File(path) => TableFile::observations(path, &etalon_formats::read_bytes(path)?, reading),
            Self::Sheet { path, sheet } => {
                let reading = with_form(Form { sheet: Some(sheet.to_owned()), ..form.clone() });
                TableFile::observations(path, &etalon_formats::read_bytes(path)?, &reading)
            }
            Self::Text { name, text } => TableFile::parse_with(name, text, &with_form(form.without_marks())),
            Self::Headed { table, columns } => {
                let mut reading = reading.clone();
                for text in columns {
                    let (name, source) = named("column", text)?;
                    reading.layout.columns.insert(name, parse_column_source(source));
                }
                table.read_as(&reading)
            }
        }
    }

    /// Name, and SHA-256 of the contents.
    pub(super) fn hashed(&self) -> Result<(String, String)> {
        let sha256 = match self {
            Self::File(path) | Self::Sheet { path, .. } => files::sha256(&files::read(path)?),
            Self::Text { text, .. } => files::sha256(text.as_bytes()),
            Self::Headed { table, .. } => return table.hashed(),
        };
        Ok((self.name(), sha256))
    }
}

/// A robot and a table.
#[derive(Clone, Copy, Debug)]
pub struct Inputs<'a> {
    /// The robot.
    pub robot: &'a RobotFile,
    /// Its robot.toml.
    pub stated: Table<'a>,
    /// Measured observations, or candidates.
    pub table: Table<'a>,
}

impl Inputs<'_> {
    /// SHA-256 of the inputs by name.
    pub(super) fn sha256_by_name(&self) -> Result<BTreeMap<String, String>> {
        let mut all = self.robot_sha256_by_name()?;
        all.extend([self.table.hashed()?]);
        Ok(all)
    }

    /// SHA-256 of the files of the robot by name.
    pub(super) fn robot_sha256_by_name(&self) -> Result<BTreeMap<String, String>> {
        let mut all = BTreeMap::from([self.stated.hashed()?]);
        match self.stated {
            Table::File(_) | Table::Sheet { .. } | Table::Headed { .. } => {
                all.extend(files::sha256_by_name(self.robot.description_path())?)
            }
            Table::Text { .. } => {
                let described = self.robot.description();
                all.extend(described.map(|(name, text)| (name.to_owned(), files::sha256(text.as_bytes()))));
            }
        }
        Ok(all)
    }
}

/// Name and value of an option `NAME=VALUE`.
pub(super) fn named<'a>(option: &str, text: &'a str) -> Result<(String, &'a str)> {
    match text.split_once('=') {
        Some((name, value)) => Ok((name.trim().to_owned(), value.trim())),
        None => Err(error!("column-option-malformed", option, text).into()),
    }
}

/// A number of a column, or a heading or an expression.
pub(super) fn parse_column_source(text: &str) -> ColumnSource {
    match text.parse::<usize>() {
        Ok(number) if number > 0 => ColumnSource::Number(number),
        _ => text.into(),
    }
}
