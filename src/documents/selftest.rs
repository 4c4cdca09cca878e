//! Answer of `etalon selftest`: validation of an installation.

use super::Provenance;
use crate::worded::worded;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Validation of an installation: the program and its machine, comparisons with reference values,
/// and seeded faults that the comparisons must notice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SelftestDocument {
    /// Schema and version: `etalon/selftest/1`.
    pub schema: String,
    /// `true` if everything passed.
    pub pass: bool,
    /// The program.
    pub program: SelftestProgram,
    /// The machine.
    pub machine: Machine,
    /// Files of the reference data in the program, with their hashes.
    pub reference: Vec<ReferenceFile>,
    /// `true` if the reference data of NIST are present in the folder `ETALON_REFERENCE`.
    pub reference_folder: bool,
    /// Requirements with their tests.
    pub requirements: Vec<SelftestRequirement>,
    /// Seeded faults in the reference data, each of which must fail a comparison.
    pub must_fail: Vec<SelftestMustFail>,
    /// Comparison of the laboratory's own campaign with its stored result; null if none was given.
    #[serde(default)]
    pub performance: Option<SelftestPerformance>,
    /// Packages of which program, build scripts and tests are built (Cargo.lock).
    pub packages: Vec<LockedPackage>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

impl SelftestDocument {
    /// Value of `schema`.
    pub const SCHEMA: &str = "etalon/selftest/1";
}

/// Program file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SelftestProgram {
    /// Version of etalon.
    pub version: String,
    /// SHA-256 of the program file; null if the file cannot be read.
    pub sha256: Option<String>,
    /// Given SHA-256 (`--program-sha256`); null if none was given.
    pub expected_sha256: Option<String>,
    /// `true` if the file could be read and has the given hash.
    pub pass: bool,
}

/// Machine on which a program runs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// Operating system: `linux`, `windows`, `macos` ...
    pub system: String,
    /// Architecture of the processor: `x86_64`, `aarch64` ...
    pub architecture: String,
    /// Number of threads that the system offers.
    pub threads: usize,
}

/// File of the reference data.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReferenceFile {
    /// Name of the file.
    pub name: String,
    /// SHA-256 of the file in the program.
    pub sha256: String,
    /// SHA-256 that the program gives.
    pub expected_sha256: String,
    /// `true` if both agree.
    pub pass: bool,
}

/// A requirement with its tests.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SelftestRequirement {
    /// Name of the requirement: `fits`, `solver`, `frames` ...
    pub id: String,
    /// Requirement, in English.
    #[serde(flatten, with = "SelftestRequirementRequirement")]
    pub requirement: Worded,
    /// `true` if there are tests, and all passed.
    pub pass: bool,
    /// Tests.
    pub checks: Vec<SelftestCheck>,
}

worded! {
    /// Requirement, in English.
    translated text SelftestRequirementRequirement: requirement, requirement_phrase
}

/// Comparison of a value with its reference. Of several values, the one with the largest deviation
/// is listed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SelftestCheck {
    /// Test, in English.
    #[serde(flatten, with = "SelftestCheckTest")]
    pub test: Worded,
    /// Source of the reference value.
    pub source: String,
    /// Unit of the values; empty for pure numbers.
    pub unit: String,
    /// Reference value; null if the test could not be made.
    pub expected: Option<f64>,
    /// Value of this installation; null if it is not finite.
    pub found: Option<f64>,
    /// `found` minus `expected`.
    pub deviation: Option<f64>,
    /// Largest permissible absolute deviation.
    pub permissible: f64,
    /// `true` if the deviation is permissible.
    pub pass: bool,
}

worded! {
    /// Test, in English.
    translated text SelftestCheckTest: test, test_phrase
}

/// A seeded fault in the reference data, with which the tests of a requirement were repeated.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SelftestMustFail {
    /// Name of the requirement.
    pub id: String,
    /// Seeded fault, in English.
    #[serde(flatten, with = "SelftestMustFailSlip")]
    pub slip: Worded,
    /// Number of tests.
    pub checks: usize,
    /// Number of tests that failed.
    pub failed: usize,
    /// `true` if at least one test failed, as it must.
    pub pass: bool,
}

worded! {
    /// Seeded fault, in English.
    translated text SelftestMustFailSlip: slip, slip_phrase
}

/// Comparison of a campaign with its stored `parameters.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SelftestPerformance {
    /// Name of the campaign.
    pub campaign: String,
    /// Stored document.
    pub expected: String,
    /// Number of compared parameters.
    pub compared: usize,
    /// Permissible difference of a value in its standard uncertainty, and relative difference of a
    /// standard uncertainty.
    pub tolerance_of_uncertainty: f64,
    /// Permissible relative difference of a value without uncertainty.
    pub relative_tolerance: f64,
    /// `true` if nothing moved.
    pub pass: bool,
    /// Values that moved by more than rounding.
    pub moved: Vec<MovedValue>,
    /// Known differences between the documents that may be the cause, in English.
    #[serde(flatten, with = "SelftestPerformanceCauses")]
    pub causes: Vec<Worded>,
}

worded! {
    /// Known differences between the documents that may be the cause, in English.
    translated list SelftestPerformanceCauses: causes, cause_phrases
}

/// A value that differs from its stored value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovedValue {
    /// Name of the parameter; empty for a value of the whole identification.
    pub parameter: String,
    /// `value`, `standard_uncertainty` or `rms`.
    pub quantity: String,
    /// Unit.
    pub unit: String,
    /// Stored value; null if the document has none.
    pub before: Option<f64>,
    /// Value now; null if this program gives no value.
    pub after: Option<f64>,
    /// Absolute difference over the stored standard uncertainty; null without an uncertainty.
    pub over_uncertainty: Option<f64>,
}

/// A package in Cargo.lock.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LockedPackage {
    /// Name of the package.
    pub name: String,
    /// Version.
    pub version: String,
    /// SHA-256 of the package's archive; null for the crates of etalon.
    pub sha256: Option<String>,
}
