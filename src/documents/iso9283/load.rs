//! Static compliance (ISO 9283:1998 10).

use super::all;
use crate::mirror::mirror;
use crate::worded::worded;
use etalon_base::message::Message;
use etalon_base::worded::Worded;
use etalon_base::{phrase, warning};
use etalon_standards::iso9283::load::{CYCLES, DirectionalCompliance};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Static compliance (10).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283ComplianceDocument {
    /// Schema and version: `etalon/iso9283-compliance/1`.
    pub schema: String,
    /// Method, and the statement that the clause is not verified against the standard.
    #[serde(flatten, with = "Iso9283ComplianceConventions")]
    pub conventions: Vec<Worded>,
    /// One per direction, in the order of the table.
    pub directions: Vec<Iso9283Compliance>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
}

worded! {
    /// Method, and the statement that the clause is not verified against the standard.
    list Iso9283ComplianceConventions: conventions, convention_phrases
}

mirror! {
    /// Compliance in one direction.
    struct Iso9283Compliance of DirectionalCompliance as d {
        /// `+x`, `-x` ...
        direction: String,
        /// Number of readings under load.
        readings: usize,
        /// Number of repeats.
        cycles: usize,
        /// Largest force.
        force_n: f64,
        /// Slope of the displacement along the force over the force.
        compliance_mm_n: f64 = d.compliance.compliance_mm_n,
        /// Standard uncertainty of the compliance from the scatter about the line; null with a
        /// single reading.
        standard_uncertainty_mm_n: Option<f64> = Some(d.compliance.standard_uncertainty_mm_n).filter(|u| u.is_finite()),
        /// Largest displacement along the force.
        largest_mm: f64 = d.compliance.largest_mm,
        /// Largest distance of a reading from the line.
        off_line_mm: f64 = d.compliance.off_line_mm,
    }
}

impl Iso9283ComplianceDocument {
    /// Creates the document of all directions in which the robot was loaded.
    pub fn new(found: Vec<DirectionalCompliance>) -> Self {
        let short: Vec<&str> = found.iter().filter(|d| d.cycles < CYCLES).map(|d| d.direction).collect();
        let warning = || warning!("few-cycles-of-direction", least = CYCLES, count = short.len(), directions = short);
        let conventions = [phrase!("convention-compliance"), phrase!("convention-compliance-clause")];
        Self {
            schema: "etalon/iso9283-compliance/1".to_owned(),
            conventions: conventions.map(Worded::from).into(),
            messages: (!short.is_empty()).then(warning).into_iter().collect(),
            directions: all(found),
        }
    }
}
