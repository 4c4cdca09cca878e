//! Types of all JSON documents. The documents suffice to write a report again.
//!
//! Angles are in degrees, lengths in millimetres. Every name carries its unit, every parameter its
//! own.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

#[cfg(not(feature = "schemas"))]
extern crate etalon_schemaless as schemars;

mod accuracy;
mod actions;
mod answer;
mod axes;
mod axis;
mod batch;
mod benchmark;
mod campaign;
mod cell;
mod compare;
mod compensation;
mod conditioned;
mod controllers;
mod field;
mod fit;
mod frames;
mod geometric;
mod identification;
mod import;
mod iso9283;
mod kinematics;
mod limits;
mod loading;
mod manifest;
mod mirror;
mod names;
mod parameters;
mod plan;
mod readings;
mod recommendation;
mod reference;
mod relative;
mod results;
mod roles;
mod run;
pub mod schema;
mod selftest;
mod study;
mod uncertainty;
mod verdict;
mod verification;
mod worded;

pub use accuracy::*;
pub use actions::{Action, ActionKind, Evidence, WrittenFile};
pub use answer::*;
pub use axes::*;
pub use axis::*;
pub use batch::*;
pub use benchmark::*;
pub use campaign::*;
pub use cell::*;
pub use compare::*;
pub use compensation::*;
pub use controllers::*;
pub use field::*;
pub use fit::*;
pub use frames::*;
pub use geometric::*;
pub use identification::{
    contradicted_places, observability_summary, parameters_document, quantity_residuals, set_up_hint, set_up_phrase,
    untested_mistakes, warning_message, warning_messages,
};
pub use import::*;
pub use iso9283::*;
pub use kinematics::*;
pub use limits::*;
pub use loading::{DisplayedPose, InputsCheck, LOADING_RATIO, LoadAnswer, Loading, LoadingCheck};
pub use manifest::*;
pub use parameters::*;
pub use plan::*;
pub use readings::*;
pub use recommendation::*;
pub use reference::ReferencePose;
pub use relative::*;
pub use results::*;
pub use roles::{Effect, Role};
pub use run::{IdentifiedDocuments, Results};
pub use selftest::*;
pub use study::*;
pub use uncertainty::*;
pub use verdict::{Judged, Reason, VerdictDocument};
pub use verification::*;

use etalon_base::error;
use etalon_base::message::Result;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Origin of numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Version of etalon.
    pub version: String,
    /// SHA-256 of every input, by file name.
    pub inputs: std::collections::BTreeMap<String, String>,
    /// Seed of random numbers, if any were drawn.
    pub seed: Option<u64>,
}

/// Returns a document as JSON text with a final line end.
pub fn to_json<T: Serialize>(document: &T) -> Result<Vec<u8>> {
    let mut bytes = serde_json::to_vec_pretty(document)
        .map_err(|e| error!("cannot-encode", format = "JSON", reason = e.to_string()))?;
    bytes.push(b'\n');
    Ok(bytes)
}
