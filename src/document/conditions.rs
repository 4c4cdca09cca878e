//! What a test report of ISO 9283 asks for beside its numbers.

use crate::base::pose::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Conditions of a test, as `[conditions]` of the campaign states them (ISO 9283:1998, 6 and 12). What is absent is not
/// stated, and the report says so.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Conditions {
    /// Who tests: name and address.
    pub laboratory: Option<String>,
    /// Make, type and serial number of the robot.
    pub robot: Option<String>,
    /// Make, type and software version of the controller.
    pub controller: Option<String>,
    /// How and on what the robot is mounted.
    pub mounting: Option<String>,
    /// The point of robot or tool that was measured.
    pub measurement_point: Option<String>,
    /// Mass of the load at the mechanical interface.
    pub load_kg: Option<f64>,
    /// Its centre of mass from the mechanical interface.
    pub load_centre_mm: Option<Vector>,
    /// Velocities of the test in per cent of the rated one.
    pub velocities_percent: Option<Vec<f64>>,
    /// The same as path velocities.
    pub velocities_mm_s: Option<Vec<f64>>,
    /// Room, air, vibrations, electromagnetic fields.
    pub environment: Option<String>,
    /// Relative humidity.
    pub humidity_percent: Option<f64>,
    /// How long the robot moved before the test.
    pub warm_up_minutes: Option<f64>,
    /// Certificate of the instrument's calibration, and its date.
    pub instrument_calibration: Option<String>,
    /// What was done otherwise than the standard says; an empty list states that there is nothing.
    pub deviations: Option<Vec<String>>,
}

impl Conditions {
    /// Keys and values of the numbers that must be positive.
    pub fn positive(&self) -> Vec<(&'static str, f64)> {
        let lists = [("velocities_percent", &self.velocities_percent), ("velocities_mm_s", &self.velocities_mm_s)];
        let listed = lists.into_iter().flat_map(|(key, list)| list.iter().flatten().map(move |v| (key, *v)));
        listed.chain(self.humidity_percent.map(|v| ("humidity_percent", v))).collect()
    }

    /// Keys and values of the numbers that may be zero, and not less.
    pub fn not_negative(&self) -> Vec<(&'static str, f64)> {
        let stated = [("load_kg", self.load_kg), ("warm_up_minutes", self.warm_up_minutes)];
        stated.into_iter().filter_map(|(key, value)| Some((key, value?))).collect()
    }
}
