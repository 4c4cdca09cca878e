//! Errors of etalon as Python exceptions.

use etalon_base::message::{Message, Problems};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// An error of a command as `etalon.Error`, with its messages.
pub fn failed(error: anyhow::Error) -> PyErr {
    match error.downcast::<Problems>() {
        Ok(problems) => refused(problems),
        Err(other) => refused(Message::error(format!("{other:#}")).into()),
    }
}

/// Problems of the input as `etalon.Error`.
pub fn refused(problems: Problems) -> PyErr {
    let problems = problems.grouped();
    let text = problems.to_string();
    let raised = Python::attach(|py| {
        let messages = json(&problems.0)?;
        let error = py.import("etalon._errors")?.getattr("Error")?.call1((text.as_str(), messages))?;
        Ok::<_, PyErr>(PyErr::from_value(error))
    });
    raised.unwrap_or_else(|other| other)
}

/// A document as JSON.
pub fn json<T: serde::Serialize>(document: &T) -> PyResult<String> {
    serde_json::to_string(document).map_err(|error| PyRuntimeError::new_err(error.to_string()))
}
