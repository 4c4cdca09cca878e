//! `etalon` turns a folder of coordinate measurements into calibrated robot parameters that one can defend.
//!
//! A campaign goes in (exports of a measuring system, encoder logs, one `campaign.toml`); frames, identified parameters
//! with uncertainties, errors before and after, a report and files for the controller come out. This page is the map.
//!
//! # The stages
//!
//! ```text
//! exports ──import──► points ──fit──► features ──frames──► frames ─┐
//! logs ────import──► joints ─────────────────────────────────────┴─join──► observations
//! observations ──identify──► parameters ──evaluate──► accuracy ──► report · export
//! robot model ──plan──► poses to measure
//! robot model ──simulate──► exports and logs with a known truth
//! ```
//!
//! [`run::pipeline`] is this diagram on one screen. Every stage is a function from the documents before it to the document
//! after it: none reads a file that another stage did not name, none prints, none reads the clock.
//!
//! # The modules
//!
//! | module | contents | may name |
//! | --- | --- | --- |
//! | [`base`] | messages, files, tables, poses, dual numbers, random numbers, patterns of names | nothing |
//! | [`math`] | least squares, fits of elements, robots, identification, the geometric method, choice of poses | `base` |
//! | [`document`] | the types of every JSON document, and their schemas | the above |
//! | [`iso9283`] | the characteristics of ISO 9283, one a file, each with its clause | the above |
//! | [`import`] | formats of exports and logs, one file each; tables of observations, poses and recordings | the above |
//! | [`campaign`] | `campaign.toml` and `robot.toml`: the keys, where each value is, what is wrong with it | the above |
//! | [`stages`] | one stage a file, each from documents to the next document | the above |
//! | [`report`] | the sections of a report and the four forms in which they are drawn | `base`, `document` |
//! | [`export`] | one controller format a file | `base`, `document` |
//! | [`compare`] | several campaigns side by side | `base` to `iso9283` |
//! | [`simulate`] | a truth becomes exports and logs, written by the formats themselves | `base` to `stages` |
//! | [`run`] | the pipeline, the check before it, the output folder | all but `compare`, `simulate`, `cli` |
//! | [`cli`] | one command a file | all |
//!
//! `tests/architecture.rs` holds this table: every `crate::` path of every file, and no circle among files.
//!
//! # Conventions
//!
//! Millimetres and radians inside; every name carries its unit. `world_T_base` is the pose of the base in the world;
//! chains read from left to right. Angles leave the program in degrees. Every formula names its source; "thesis" is
//! A. Joubair, "Contribution à l'amélioration de la précision absolue des robots parallèles", ÉTS Montréal, 2012, and
//! equation numbers are its.
//!
//! # Two ways in
//!
//! A campaign on disk: [`campaign::Campaign::read`], then [`run::pipeline::run`]. Or data in memory:
//!
#![doc = concat!("```ignore\n", include_str!("../tests/in_memory.rs"), "```")]
#![forbid(unsafe_code)]
#![allow(non_snake_case)] // world_T_base: frames in names

pub use etalon_base as base;
pub use etalon_campaign as campaign;
pub use etalon_compare as compare;
pub use etalon_controllers as controllers;
pub use etalon_documents as documents;
pub use etalon_fit as fit;
pub use etalon_formats as formats;
pub use etalon_identify as identify;
pub use etalon_math as math;
pub use etalon_report as report;
pub use etalon_robots as robots;
pub use etalon_standards as standards;

pub mod cli;
pub mod run;
pub mod simulate;
pub mod stages;
