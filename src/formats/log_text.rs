//! Text of the file of a log: of a table, a sheet, a topic or arrays.

use super::exports::Format;
use super::input::{file_text, read_bytes};
use super::logs::Log;
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_tables::ColumnSource;
use std::path::Path;

impl Log {
    /// Reads the text of the file, and its bytes.
    ///
    /// # Errors
    /// Fails if the file cannot be read, is not text of this encoding, or lacks the sheet.
    pub fn text(&self, path: &Path) -> Result<(String, Vec<u8>)> {
        let bytes = read_bytes(path)?;
        let named = self.columns.values().filter_map(|column| match &column.at {
            ColumnSource::Heading(name) => Some(name.as_str()),
            ColumnSource::Number(_) => None,
        });
        if let Some(text) = self.format.table(&bytes, &named.collect::<Vec<_>>()) {
            let file = path.display().to_string();
            return Ok((text.map_err(|message| message.within(phrase!("in-file", file)))?, bytes));
        }
        let format = Format::from(self.form.clone());
        Ok((file_text(path, &bytes, self.form.encoding, &format)?, bytes))
    }
}
