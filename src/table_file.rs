//! A table that a command is given, or a campaign names.

use crate::message::{Problems, Result};
use crate::{files, import, table};
use polars::prelude::DataFrame;
use std::path::Path;

/// A table with the text that it was read from.
#[derive(Clone, Debug)]
pub(crate) struct TableFile {
    /// The file as the user named it.
    pub name: String,
    text: String,
    pub table: DataFrame,
}

impl TableFile {
    pub fn read(path: &Path) -> Result<Self> {
        Self::read_with(path, import::observations)
    }

    /// A text of another form, which `table` makes a table of, given the file's name and the text.
    pub fn read_with(path: &Path, table: impl FnOnce(&str, &str) -> Result<DataFrame>) -> Result<Self> {
        Self::of(path, files::read_text(path)?, table)
    }

    /// The same of the text that the file holds.
    pub fn of(path: &Path, text: String, table: impl FnOnce(&str, &str) -> Result<DataFrame>) -> Result<Self> {
        let name = path.display().to_string();
        Ok(Self { table: table(&name, &text)?, name, text })
    }

    /// The names in the column `target`, each once, in their order.
    pub fn targets(&self) -> Result<Vec<String>> {
        let mut targets: Vec<String> = Vec::new();
        for name in table::texts(&self.table, "target").map_err(|more| self.place(more))? {
            if !targets.contains(&name) {
                targets.push(name);
            }
        }
        Ok(targets)
    }

    /// The table with the name of its file.
    pub fn named(&self) -> (&str, &DataFrame) {
        (&self.name, &self.table)
    }

    /// Problems of the table, with the lines they are about.
    pub fn place(&self, problems: Problems) -> Problems {
        problems.in_text(&self.name, &self.text)
    }
}
