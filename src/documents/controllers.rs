//! `controllers.json`: values of controller files whose format leaves identified parameters out,
//! and position errors with these values.

use super::{AccuracySet, ErrorStatistics, LimitVerdict, ParametersDocument, PoseSet, Statistics};
use etalon_base::message::{Message, Severity};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Controller files of formats that leave identified parameters out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ControllersDocument {
    /// Schema and version: `etalon/controllers/1`.
    pub schema: String,
    /// One entry for each distinct set of written values.
    pub files: Vec<ControllerFiles>,
    /// Files that were not written or are not clearly better than nominal, and parameters that
    /// could not be identified again.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub messages: Vec<Message>,
}

/// Values in the files of one or more formats.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ControllerFiles {
    /// Names of the formats.
    pub formats: Vec<String>,
    /// Identified parameters that the formats cannot contain. They were at nominal when the others
    /// were identified again.
    pub left_out: Vec<String>,
    /// All parameters with their values in the files.
    pub values: Vec<WrittenParameter>,
    /// Position errors, one entry per set of poses: `calibration`, `validation`.
    pub errors: Vec<ControllerErrors>,
    /// Errors of all quantities at the deciding poses, with nominal and with the written values;
    /// absent in output folders of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub deciding_set: Option<AccuracySet>,
    /// Limits of errors, judged with the written values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub limits: Vec<LimitVerdict>,
}

/// A parameter as written to a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrittenParameter {
    /// Name of the parameter.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Value.
    pub value: f64,
    /// Standard uncertainty (k = 1); absent if the value was not identified, or if the format
    /// changes it.
    pub standard_uncertainty: Option<f64>,
}

/// Position errors at one set of poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ControllerErrors {
    /// `calibration` or `validation`.
    #[schemars(with = "String")]
    pub set: PoseSet,
    /// Errors with nominal parameters of the robot.
    pub nominal: PositionErrors,
    /// Errors with all identified parameters.
    pub identified: PositionErrors,
    /// Errors with the written values.
    pub written: PositionErrors,
}

/// Root mean square and maximum of position errors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PositionErrors {
    /// Root mean square (mm).
    pub rms_mm: f64,
    /// Maximum (mm).
    pub max_mm: f64,
}

impl ControllersDocument {
    /// Value of `schema`.
    pub const SCHEMA: &str = "etalon/controllers/1";

    /// Creates the document; `None` if no format leaves anything out.
    pub fn new(files: Vec<ControllerFiles>, messages: Vec<Message>) -> Option<Self> {
        let any = !files.is_empty() || !messages.is_empty();
        any.then(|| Self { schema: Self::SCHEMA.to_owned(), files, messages })
    }

    /// `true` if every file was written.
    pub fn is_complete(&self) -> bool {
        self.messages.iter().all(|m| m.severity != Severity::Error)
    }
}

impl ControllerFiles {
    /// Decisive errors: at validation poses, or at calibration poses in a campaign without
    /// validation.
    pub fn deciding(&self) -> Option<&ControllerErrors> {
        self.errors.last()
    }

    /// The identified parameters, with the written values instead of the identified ones.
    pub fn applied_to(&self, identified: &ParametersDocument) -> ParametersDocument {
        let left_out: Vec<&str> = self.left_out.iter().map(String::as_str).collect();
        let mut document = identified.holding(&left_out);
        let by_name: std::collections::BTreeMap<&str, &WrittenParameter> =
            self.values.iter().map(|v| (v.name.as_str(), v)).collect();
        for p in &mut document.parameters {
            if let Some(written) = by_name.get(p.name.as_str()) {
                (p.value, p.standard_uncertainty, p.determined) = (written.value, written.standard_uncertainty, None);
            }
        }
        document
    }
}

/// Minimum relative decrease of the root mean square that counts as an improvement.
const HARDLY: f64 = 0.05;

impl From<&Statistics> for PositionErrors {
    fn from(statistics: &Statistics) -> Self {
        Self { rms_mm: statistics.rms, max_mm: statistics.max }
    }
}

impl ControllerErrors {
    /// Errors at a set of poses; `written` is `None` if the file contains the identified values.
    pub fn new(set: &AccuracySet, written: Option<&Statistics>) -> Option<Self> {
        let ErrorStatistics { before, after, .. } = set.leading()?;
        let written = written.unwrap_or(after).into();
        Some(Self { set: set.name, nominal: before.into(), identified: after.into(), written })
    }

    /// `true` if the largest error is larger than with nominal parameters, or the root mean square
    /// less than 5 % smaller.
    pub fn is_hardly_better_than_nominal(&self) -> bool {
        self.is_maximum_larger() || self.is_rms_hardly_smaller()
    }

    /// `true` if the root mean square is less than 5 % smaller than with nominal parameters.
    pub fn is_rms_hardly_smaller(&self) -> bool {
        self.written.rms_mm > (1.0 - HARDLY) * self.nominal.rms_mm
    }

    /// `true` if the largest error is larger than with nominal parameters.
    pub fn is_maximum_larger(&self) -> bool {
        self.written.max_mm > self.nominal.max_mm
    }

    /// `true` if the root mean square is larger than with nominal parameters.
    pub fn is_worse_than_nominal(&self) -> bool {
        self.written.rms_mm > self.nominal.rms_mm
    }
}
