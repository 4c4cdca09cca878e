//! Rows without a partner, or with two, each with its place.

use etalon_base::catalogue::Phrase;
use etalon_base::message::Place;
use etalon_documents::Unmatched;
use etalon_formats::{JointLog, LogRow, Point};

/// A row of an export or of a log, by its place in the file.
#[derive(Clone, Copy)]
pub(super) struct At<'a> {
    file: &'a str,
    pub line: usize,
}

impl<'a> At<'a> {
    /// Row of a measured point.
    pub fn point(point: &'a Point) -> Self {
        Self { file: &point.export, line: point.line as usize }
    }

    /// Row of a log.
    pub fn log(log: &'a JointLog, row: &LogRow) -> Self {
        Self { file: &log.file, line: row.line }
    }

    /// The row with its key in words and the reason.
    pub fn unmatched(self, key: String, reason: &Phrase) -> Unmatched {
        let (file, line) = (self.file.to_owned(), self.line);
        Unmatched { file, line, key, reason: reason.clone().into() }
    }

    /// Place of the row.
    pub fn place(self) -> Place {
        Place { line: Some(self.line), ..Place::file(self.file) }
    }
}
