//! `etalon` turns a folder of coordinate measurements into calibrated robot parameters with
//! uncertainties.
//!
//! The input is a campaign: exports of a measuring system, encoder logs and one `campaign.toml`.
//! The output consists of frames, identified parameters with uncertainties, errors before and after
//! calibration, a report, and files for the controller.
//!
//! # Where things are
//!
//! Each module below is a crate of the workspace, except [`stages`], [`simulate`], [`run`],
//! [`tasks`], [`session`] and [`cli`], which belong to the program. `docs/architecture.md` lists
//! the crates with their dependencies, and follows one measured point from the export to the
//! report. [`run::walk`] shows the order of the stages.
//!
//! | crate | contents |
//! | --- | --- |
//! | [`base`] | messages, files, poses, dual numbers, random numbers |
//! | [`math`] | linear algebra, nonlinear least squares, statistics |
//! | [`fit`] | geometric elements, minimum zones, point clouds |
//! | [`robots`] | kinematic models |
//! | [`identify`] | identification, uncertainty, diagnosis, choice of poses, geometric method |
//! | [`standards`] | ISO 9283, ISO 230-2, decision rules |
//! | [`documents`] | JSON documents and their schemas |
//! | [`tables`] | the form of a table, and its rows |
//! | [`formats`] | exports, logs and observations |
//! | [`campaign`] | `campaign.toml` and `robot.toml` |
//! | [`report`] | sections, charts and four renderers |
//! | [`controllers`] | files that controllers load |
//! | [`compare`] | several campaigns side by side |
//! | [`view`] | the page of `etalon view`, and its server |
//!
//! # Conventions
//!
//! Millimetres and radians inside; every name carries its unit. `world_T_base` is the pose of the
//! base in the world; chains read from left to right. Angles leave the program in degrees. Every
//! formula names its source; "thesis" and its equation numbers refer to A. Joubair, "Contribution à
//! l'amélioration de la précision absolue des robots parallèles", ÉTS Montréal, 2012.
//!
//! # Two ways in
//!
//! A campaign on disk: [`campaign::Campaign::read`], then [`run::pipeline::run`]. Or data in
//! memory:
//!
#![doc = concat!("```ignore\n", include_str!("../tests/in_memory.rs"), "```")]
#![forbid(unsafe_code)]
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

#[cfg(not(feature = "schemas"))]
extern crate etalon_schemaless as schemars;

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
pub use etalon_tables as tables;
pub use etalon_view as view;

pub mod cli;
pub mod run;
pub mod session;
pub mod simulate;
pub mod stages;
pub mod tasks;
