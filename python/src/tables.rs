//! Tables of other libraries as CSV text, which etalon's own reader checks.

use crate::errors::refused;
use arrow_cast::display::{ArrayFormatter, FormatOptions};
use etalon_base::message::Message;
use pyo3::prelude::*;
use pyo3_arrow::PyTable;
use std::fmt::Display;

/// The CSV text of a table with the Arrow PyCapsule interface. Numbers keep every digit; a null is an empty cell.
#[pyfunction]
pub fn csv(table: PyTable) -> PyResult<String> {
    let (batches, schema) = table.into_inner();
    let mut text = ::csv::Writer::from_writer(Vec::new());
    text.write_record(schema.fields().iter().map(|field| field.name())).map_err(wrong)?;
    let options = FormatOptions::default();
    for batch in &batches {
        let columns = batch.columns().iter().map(|column| ArrayFormatter::try_new(column.as_ref(), &options));
        let columns = columns.collect::<Result<Vec<_>, _>>().map_err(wrong)?;
        for row in 0..batch.num_rows() {
            text.write_record(columns.iter().map(|column| column.value(row).to_string())).map_err(wrong)?;
        }
    }
    String::from_utf8(text.into_inner().map_err(wrong)?).map_err(wrong)
}

fn wrong(error: impl Display) -> PyErr {
    refused(Message::error(format!("the table cannot be read: {error}")).into())
}
