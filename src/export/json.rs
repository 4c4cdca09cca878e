//! `etalon/controller/1`: parameters by name, for programs that read JSON.

use super::{Exporter, Given};
use crate::base::message::{Message, Result};
use crate::document::ParameterStatus;
use serde::Serialize;
use std::collections::BTreeMap;

/// JSON, parameters by name.
pub(super) struct Json;

#[derive(Serialize)]
struct Controller<'a> {
    schema: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    warning: Option<String>,
    robot: &'a str,
    parameters: BTreeMap<&'a str, Parameter<'a>>,
    etalon: &'a str,
    /// sha256 by name
    inputs: &'a BTreeMap<String, String>,
}

#[derive(Serialize)]
struct Parameter<'a> {
    value: f64,
    unit: &'a str,
    standard_uncertainty: Option<f64>,
    status: ParameterStatus,
}

impl Exporter for Json {
    fn file_name(&self) -> &'static str {
        "controller.json"
    }

    fn bytes(&self, given: &Given) -> Result<Vec<u8>> {
        let document = given.parameters;
        let parameters = document.parameters.iter().map(|p| {
            let standard_uncertainty = p.standard_uncertainty;
            (p.name.as_str(), Parameter { value: p.value, unit: &p.unit, standard_uncertainty, status: p.status })
        });
        let controller = Controller {
            schema: "etalon/controller/1",
            warning: given.warning(),
            robot: &document.robot,
            parameters: parameters.collect(),
            etalon: &document.provenance.version,
            inputs: &document.provenance.inputs,
        };
        let mut bytes = serde_json::to_vec_pretty(&controller)
            .map_err(|e| Message::error(format!("cannot write the parameters as JSON: {e}")))?;
        bytes.push(b'\n');
        Ok(bytes)
    }
}
