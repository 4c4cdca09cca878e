//! `etalon/controller/1`: parameters by name, for programs that read JSON.

use super::{About, ExportInput, Exporter};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_documents::ParameterStatus;
use serde::Serialize;
use std::collections::BTreeMap;

/// JSON, parameters by name.
pub(super) struct Json;

#[derive(Serialize)]
struct Controller<'a> {
    schema: &'static str,
    etalon: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    warning: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    synthetic: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    campaign: Option<&'a str>,
    name: &'a str,
    /// Model of the robot.
    robot: &'a str,
    /// SHA-256 of parameters.json.
    parameters_sha256: String,
    /// Temperature (°C) to which lengths and zeros refer.
    #[serde(skip_serializing_if = "Option::is_none")]
    reference_temperature_c: Option<f64>,
    parameters: BTreeMap<&'a str, Parameter<'a>>,
    /// SHA-256 by file name.
    inputs: &'a BTreeMap<String, String>,
}

#[derive(Serialize)]
struct Parameter<'a> {
    value: f64,
    unit: &'a str,
    /// Unit with the load or temperature to which the value refers.
    #[serde(skip_serializing_if = "Option::is_none")]
    full_unit: Option<&'a str>,
    standard_uncertainty: Option<f64>,
    status: ParameterStatus,
}

impl Exporter for Json {
    fn about(&self) -> About<'_> {
        About::laboratory("json", "controller.json")
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let document = given.parameters;
        let parameters = document.parameters.iter().map(|p| {
            let standard_uncertainty = p.standard_uncertainty;
            let full_unit = p.full_unit.as_deref();
            let status = p.status;
            (p.name.as_str(), Parameter { value: p.value, unit: &p.unit, full_unit, standard_uncertainty, status })
        });
        let controller = Controller {
            schema: "etalon/controller/1",
            etalon: &document.provenance.version,
            warning: given.caution(),
            synthetic: given.synthetic(),
            campaign: given.summary.map(|summary| summary.name.as_str()),
            name: given.robot_name(),
            robot: &document.robot,
            parameters_sha256: given.sha256()?,
            reference_temperature_c: document.reference_temperature_c,
            parameters: parameters.collect(),
            inputs: &document.provenance.inputs,
        };
        let mut bytes = serde_json::to_vec_pretty(&controller)
            .map_err(|e| error!("cannot-encode", format = "JSON", reason = e.to_string()))?;
        bytes.push(b'\n');
        Ok(bytes)
    }
}
