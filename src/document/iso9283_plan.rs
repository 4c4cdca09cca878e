//! What `etalon iso9283 --plan` and `etalon iso9283 --compliance` answer.

use crate::base::message::Message;
use crate::base::pose::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A test by ISO 9283:1998 laid into a workspace.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283PlanDocument {
    /// `etalon/iso9283-plan/1`
    pub schema: String,
    /// What was chosen how, and what is not verified against the standard, in words.
    pub conventions: Vec<String>,
    /// Side of the cube, of planar robots the square.
    pub side_mm: f64,
    /// Corners C1 to C8, of planar robots C1 to C4.
    pub corners_mm: Vec<Vector>,
    /// Corners of the test plane.
    pub test_plane: String,
    /// Places to visit in order, each list with its name: `poses` (P1 to P5), `linear`, `circle-large`, ...
    pub places: Vec<Iso9283Places>,
    /// Places that the robot does not reach, where one is stated.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub unreached: Vec<Iso9283Unreached>,
    /// Which characteristic is tested how.
    pub programme: Vec<Iso9283Item>,
    /// Loads in per cent of the rated one; the first is mandatory.
    pub loads_percent: Vec<u32>,
}

/// Poses, or a path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Places {
    /// Name of the list, and of the files that hold it.
    pub name: String,
    /// What it is for.
    pub purpose: String,
    /// `x_mm`, `y_mm` and, where they exist, `z_mm`, `a_deg`, `b_deg`, `c_deg` of each, numbered from 1.
    pub points: Vec<BTreeMap<String, f64>>,
    /// Joint values of each, where a robot is stated; null where it does not get there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<Option<BTreeMap<String, f64>>>,
}

/// A place that the stated robot does not reach.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Unreached {
    /// Name of the list.
    pub places: String,
    /// Number of the point in it, from 1.
    pub point: usize,
    /// Why.
    pub reason: String,
}

/// One line of the programme.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Item {
    /// What is tested.
    pub characteristic: String,
    /// Clause.
    pub clause: String,
    /// Poses of a cycle in order, or the path.
    pub visits: String,
    /// Per cent of the rated velocity.
    pub velocities_percent: Vec<u32>,
    /// Cycles for each velocity.
    pub cycles: u32,
    /// Whether the line was read in the standard's text; otherwise it is general knowledge.
    pub read: bool,
}

/// Static compliance (10).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283ComplianceDocument {
    /// `etalon/iso9283-compliance/1`
    pub schema: String,
    /// How it is computed, and that the clause is not verified.
    pub conventions: Vec<String>,
    /// One per direction, in the order of the table.
    pub directions: Vec<Iso9283Compliance>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
}

/// Compliance in one direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Compliance {
    /// `+x`, `-x` ...
    pub direction: String,
    /// Readings under load.
    pub readings: usize,
    /// Repeats.
    pub cycles: usize,
    /// Largest force.
    pub force_n: f64,
    /// Displacement along the force by force.
    pub compliance_mm_n: f64,
    /// Its standard uncertainty from the scatter about the line; null with a single reading.
    pub standard_uncertainty_mm_n: Option<f64>,
    /// Largest displacement along the force.
    pub largest_mm: f64,
    /// Largest distance of a reading from the line.
    pub off_line_mm: f64,
}
