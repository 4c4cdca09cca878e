//! Tables and robots that a task is given: files, or texts in memory.

use super::text_format;
use crate::stages::table_file::TableFile;
use etalon_base::files;
use etalon_base::message::Result;
use etalon_campaign::RobotFile;
use etalon_formats::TableReading;
use etalon_tables::{Form, TableLayout};
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
            Self::Sheet { path, sheet } => {
                let layout =
                    TableLayout { form: Form::with_sheet(Some((*sheet).to_owned())), ..TableLayout::default() };
                let reading = TableReading { layout, ..TableReading::default() };
                TableFile::observations(path, &etalon_formats::read_bytes(path)?, &reading)
            }
            Self::Text { name, text } => TableFile::parse(name, text),
            Self::Headed { .. } => text_format::read(*self, &TableReading::default()),
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
