//! Robots and tables in memory that a command is given in place of files.

use crate::stages::table_file::TableFile;
use etalon_base::files;
use etalon_base::message::Problems;
use etalon_campaign::RobotFile;
use std::collections::BTreeMap;

/// A table as CSV text with a header.
#[derive(Clone, Copy, Debug)]
pub struct Table<'a> {
    /// Name for messages and for the list of inputs.
    pub name: &'a str,
    /// Text, with commas and decimal points.
    pub text: &'a str,
}

impl Table<'_> {
    pub(super) fn parse(&self) -> std::result::Result<TableFile, Problems> {
        TableFile::parse(self.name, self.text)
    }
}

/// A robot and a table.
#[derive(Clone, Copy, Debug)]
pub struct Inputs<'a> {
    /// The robot.
    pub robot: &'a RobotFile,
    /// Name and text of its robot.toml.
    pub stated: Table<'a>,
    /// Measured observations, or candidates.
    pub table: Table<'a>,
}

impl Inputs<'_> {
    /// SHA-256 of the inputs by name.
    pub(super) fn inputs(&self) -> BTreeMap<String, String> {
        let described = self.robot.description().map(|(name, text)| Table { name, text });
        let all = [self.stated, self.table].into_iter().chain(described);
        all.map(|text| (text.name.to_owned(), files::sha256(text.text.as_bytes()))).collect()
    }
}
