//! `campaign.json`: administrative data of the campaign, test conditions, and presentation of the
//! report.

use super::{DecisionRule, WrittenFile};
use etalon_base::country::Country;
use etalon_base::pose::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Administrative data of the campaign, for the head of a report.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CampaignSummary {
    /// Name of the campaign.
    pub name: String,
    /// Name of the robot, if its file contains one.
    #[serde(default)]
    pub robot: Option<String>,
    /// Statements about the measurements.
    #[serde(flatten)]
    pub measurements: MeasurementSummary,
    /// Measuring instrument.
    #[serde(flatten)]
    pub instrument: InstrumentSummary,
    /// Statements about the limits.
    #[serde(flatten)]
    pub limits: LimitsSummary,
    /// Repeatability of the robot in returning to a measured point, if given.
    pub contact: Option<ContactSummary>,
    /// Temperature during the measurements.
    #[serde(flatten)]
    pub temperature: TemperatureSummary,
    /// Conditions of a test.
    #[serde(default)]
    pub conditions: Conditions,
    /// Last day on which the calibration is valid, as given: year-month-day.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub valid_until: Option<String>,
    /// Controller files that the run wrote.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub controller_files: Vec<WrittenFile>,
    /// Identification of the report.
    #[serde(default)]
    pub issue: Issue,
    /// Presentation of the report.
    #[serde(default)]
    pub report: Presentation,
}

/// Statements about the measurements of a campaign.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeasurementSummary {
    /// Explanation of synthetic data; absent for measured data.
    pub synthetic: Option<String>,
    /// Remarks.
    pub notes: Option<String>,
    /// Date as given.
    pub date: Option<String>,
    /// Operator as given.
    pub operator: Option<String>,
}

/// Statements about the limits of a campaign.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LimitsSummary {
    /// Decision rule for limits, as given.
    #[serde(default)]
    pub decision_rule: Option<DecisionRule>,
    /// Specification, drawing or agreement that the limits come from, as given.
    #[serde(rename = "limits_specification", default, skip_serializing_if = "Option::is_none")]
    pub specification: Option<String>,
}

/// Measuring instrument of a campaign.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct InstrumentSummary {
    /// Measuring instrument.
    #[serde(rename = "instrument")]
    pub name: Option<String>,
    /// Expanded uncertainty of one coordinate.
    pub expanded_uncertainty_um: Option<f64>,
    /// Coverage factor of `expanded_uncertainty_um`.
    pub coverage_factor: Option<f64>,
    /// Expanded uncertainty of a position, if given.
    #[serde(default)]
    pub expanded_position_uncertainty_um: Option<f64>,
}

/// Temperature during the measurements of a campaign.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TemperatureSummary {
    /// Temperature during the campaign.
    #[serde(rename = "temperature_c")]
    pub stated_c: Option<f64>,
    /// Lowest and highest temperature (°C) that rows of the exports contain.
    #[serde(rename = "temperature_range_c", default, skip_serializing_if = "Option::is_none")]
    pub range_c: Option<[f64; 2]>,
}

/// Campaign to which an answer refers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CampaignReference {
    /// Name of the campaign.
    pub name: String,
    /// Name of the robot, if its file contains one.
    pub robot: Option<String>,
    /// Date as given.
    pub date: Option<String>,
    /// Measuring instrument.
    pub instrument: Option<String>,
    /// Explanation of synthetic data; absent for measured data.
    pub synthetic: Option<String>,
}

impl From<CampaignSummary> for CampaignReference {
    fn from(summary: CampaignSummary) -> Self {
        let CampaignSummary { name, robot, measurements, instrument, .. } = summary;
        let MeasurementSummary { date, synthetic, .. } = measurements;
        Self { name, robot, date, instrument: instrument.name, synthetic }
    }
}

/// Repeatability of the robot in returning to a measured point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ContactSummary {
    /// Half-width of the interval within which one coordinate repeats.
    pub repeatability_um: f64,
    /// Half-width in standard deviations.
    pub coverage_factor: f64,
}

/// Identification of a report (ISO/IEC 17025:2017, 7.8.2.1). A report shows missing entries as "not
/// given".
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Issue {
    /// Number of the report, unique in the laboratory.
    pub number: Option<String>,
    /// Number and date of the report that this report amends or replaces, and the reason.
    pub amends: Option<String>,
    /// Name and contact of the customer.
    pub customer: Option<String>,
    /// Country in which the calibration was made (ISO 3166-1).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub country: Option<Country>,
    /// Date of issue.
    pub issued: Option<String>,
    /// Person who authorises the report: name and function.
    pub authorised_by: Option<String>,
    /// Results that an external provider obtained.
    pub external_results: Option<String>,
}

/// Conditions of a test (ISO 9283:1998, 6 and 12). A report shows missing entries as "not stated".
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Conditions {
    /// Name and address of the laboratory.
    pub laboratory: Option<String>,
    /// Place of the measurements, if outside the laboratory.
    pub place: Option<String>,
    /// Robot under test.
    #[serde(flatten)]
    pub robot: TestedRobot,
    /// Measured point of the robot or tool.
    pub measurement_point: Option<String>,
    /// Load and velocities.
    #[serde(flatten)]
    pub motion: TestMotion,
    /// Room, air, vibrations, electromagnetic fields.
    pub environment: Option<String>,
    /// Relative humidity.
    pub humidity_percent: Option<f64>,
    /// Duration of motion before the test.
    pub warm_up_minutes: Option<f64>,
    /// Certificate of the instrument's calibration, and its date.
    pub instrument_calibration: Option<String>,
    /// Standards to which the instrument's calibration is traceable, and the laboratory that
    /// establishes traceability.
    pub traceability: Option<String>,
    /// Deviations from the standard; an empty list says that there were no deviations.
    pub deviations: Option<Vec<String>>,
}

/// Robot under test.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct TestedRobot {
    /// Description of the robot.
    #[serde(rename = "robot")]
    pub description: Option<String>,
    /// Manufacturer of the robot.
    #[serde(rename = "robot_maker")]
    pub maker: Option<String>,
    /// Type of the robot.
    #[serde(rename = "robot_type")]
    pub model: Option<String>,
    /// Serial number of the robot.
    #[serde(rename = "robot_serial_number")]
    pub serial_number: Option<String>,
    /// Date on which the robot was received for the test.
    #[serde(rename = "robot_received")]
    pub received: Option<String>,
    /// State of the robot: repaired, adjusted, as found.
    #[serde(rename = "robot_state")]
    pub state: Option<String>,
    /// Make, type and software version of the controller.
    pub controller: Option<String>,
    /// File that the controller has before the calibration is loaded. The report gives its SHA-256:
    /// the way back.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub controller_backup: Option<String>,
    /// Mounting of the robot.
    pub mounting: Option<String>,
}

/// Load and velocities of a test.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct TestMotion {
    /// Mass of the load at the mechanical interface.
    pub load_kg: Option<f64>,
    /// Centre of mass of the load, relative to the mechanical interface.
    pub load_centre_mm: Option<Vector>,
    /// Velocities of the test (% of the rated velocity).
    pub velocities_percent: Option<Vec<f64>>,
    /// Path velocities of the test.
    pub velocities_mm_s: Option<Vec<f64>>,
}

impl Conditions {
    /// Keys and values of the numbers that must be positive.
    pub fn positive(&self) -> Vec<(&'static str, f64)> {
        let TestMotion { velocities_percent, velocities_mm_s, .. } = &self.motion;
        let lists = [("velocities_percent", velocities_percent), ("velocities_mm_s", velocities_mm_s)];
        let listed = lists.into_iter().flat_map(|(key, list)| list.iter().flatten().map(move |v| (key, *v)));
        listed.chain(self.humidity_percent.map(|v| ("humidity_percent", v))).collect()
    }

    /// Keys and values of the numbers that must not be negative.
    pub fn not_negative(&self) -> Vec<(&'static str, f64)> {
        let stated = [("load_kg", self.motion.load_kg), ("warm_up_minutes", self.warm_up_minutes)];
        stated.into_iter().filter_map(|(key, value)| Some((key, value?))).collect()
    }
}

/// Language of a report. Texts of the campaign are not translated; messages of the program stay in
/// English.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Language {
    /// English.
    #[default]
    En,
    /// French.
    Fr,
    /// German.
    De,
}

impl Language {
    /// Language code of HTML (ISO 639-1).
    pub fn code(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::Fr => "fr",
            Self::De => "de",
        }
    }
}

/// Complete presentation of a report: the output folder suffices to write the report again.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Presentation {
    /// Language of the report.
    pub language: Language,
    /// The laboratory's logo as a data URI (SVG or PNG).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub logo: Option<String>,
    /// The laboratory's own templates: texts by file name.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub templates: BTreeMap<String, String>,
}
