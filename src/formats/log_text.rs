//! Text of the file of a log: of a table, a sheet, a topic or arrays.

use super::exports::Format;
use super::input::{file_text, read_bytes};
use super::logs::Log;
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_tables::ColumnSource;
use std::path::Path;

/// Text of a log, and the bytes that it was read from.
pub struct LogFile {
    /// Text of the wanted columns.
    pub text: String,
    /// Bytes of the file.
    pub bytes: Vec<u8>,
    /// Names and bytes of the files beside it that contain its numbers.
    pub beside: Vec<(String, Vec<u8>)>,
}

impl Log {
    /// Reads the file.
    ///
    /// # Errors
    /// Fails if the file cannot be read, is not text of this encoding, or lacks the sheet.
    pub fn load(&self, path: &Path) -> Result<LogFile> {
        let bytes = read_bytes(path)?;
        let file = self.format.array_file(path, &bytes)?;
        let named = self.columns.values().filter_map(|column| match &column.at {
            ColumnSource::Heading(name) => Some(name.as_str()),
            ColumnSource::Number(_) => None,
        });
        let text = match self.format.table(&file, &named.collect::<Vec<_>>()) {
            Some(text) => {
                text.map_err(|message| message.within(phrase!("in-file", file = path.display().to_string())))?
            }
            None => file_text(path, &bytes, self.form.encoding, &Format::from(self.form.clone()))?,
        };
        let beside = file.beside;
        Ok(LogFile { text, bytes, beside })
    }
}
