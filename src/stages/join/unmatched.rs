//! Rows that a join leaves alone, or that have two partners, each with its place.

use crate::base::message::{Place, Result};
use crate::base::table;
use crate::document::Unmatched;
use polars::prelude::DataFrame;

/// Collects rows of one table.
pub(super) struct Rows {
    files: Vec<String>,
    lines: Vec<i64>,
}

impl Rows {
    /// The rows of measured points, which name their exports.
    pub fn points(points: &DataFrame) -> Result<Self> {
        Ok(Self { files: table::texts(points, "export")?, lines: table::integers(points, "line")? })
    }

    /// The rows of a log that was read from `file`.
    pub fn log(log: &DataFrame, file: &str) -> Result<Self> {
        let lines = table::integers(log, "line")?;
        Ok(Self { files: vec![file.to_owned(); lines.len()], lines })
    }

    /// One of the rows, with its key in words and what is wrong with it.
    pub fn unmatched(&self, row: usize, key: String, reason: &str) -> Unmatched {
        Unmatched {
            file: self.files.get(row).cloned().unwrap_or_default(),
            line: self.line(row),
            key,
            reason: reason.to_owned(),
        }
    }

    /// Where a row stands.
    pub fn place(&self, row: usize) -> Place {
        Place { line: Some(self.line(row)), ..Place::file(self.files.get(row).cloned().unwrap_or_default()) }
    }

    /// The line of a row, from 1.
    pub fn line(&self, row: usize) -> usize {
        self.lines.get(row).map_or(0, |&line| line.max(0) as usize)
    }
}

/// A key in words: `pose 3, cycle 1`.
pub(super) fn key_in_words(names: &[&str], key: &[i64]) -> String {
    names.iter().zip(key).map(|(name, value)| format!("{name} {value}")).collect::<Vec<_>>().join(", ")
}
