//! Tables of other libraries as CSV text, which etalon's own reader checks, and tables of etalon as
//! columns.

use crate::errors::{json, refused};
use arrow_cast::display::{ArrayFormatter, FormatOptions};
use etalon::formats::table::{Table, Values};
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

/// The names and values of the columns of a table as JSON; null for an empty cell.
pub fn columns(table: Table) -> PyResult<String> {
    let values = |values: Values| match values {
        Values::Numbers(all) => serde_json::to_value(all),
        Values::Whole(all) => serde_json::to_value(all),
        Values::Poses(all) => serde_json::to_value(all),
        Values::Texts(all) => serde_json::to_value(all),
    };
    let columns = table.into_columns().into_iter().map(|(name, all)| Ok((name, values(all)?)));
    json(&columns.collect::<Result<Vec<_>, _>>().map_err(|error: serde_json::Error| wrong(error))?)
}

fn wrong(error: impl Display) -> PyErr {
    refused(Message::error(format!("the table cannot be read: {error}")).into())
}
