//! `etalon` turns a folder of coordinate measurements into calibrated robot parameters that one can defend.
//!
//! A campaign goes in (exports of a measuring system, encoder logs, one `campaign.toml`); frames, identified parameters
//! with uncertainties, errors before and after, a report and files for the controller come out. This page is the map.
//!
//! # The hallway
//!
//! ```text
//! exports ──import──► points ──fit──► features ──frames──► frames ─┐
//! logs ────import──► joints ─────────────────────────────────────┴─join──► observations
//! observations ──identify──► parameters ──evaluate──► accuracy ──► report · export
//! robot model ──plan──► poses to measure
//! robot model ──simulate──► exports and logs with a known truth
//! ```
//!
//! [`pipeline`] is that hallway on one screen. Every stage is a function from the documents before it to the document
//! after it: none reads a file that another stage did not name, none prints, none looks at the clock.
//!
//! # Rooms
//!
//! Mathematics, which knows no file and no campaign:
//! [`scalar`] (numbers that carry derivatives), [`pose`] (rigid transforms), [`solve`] (least squares, singular values),
//! [`fit`] (geometric elements), [`robots`] (direct and inverse kinematics, exact Jacobians), [`identify`] (what the
//! data tell, and how well), [`geometric`] (the same by balls, a shaft and an arm), [`iso9283`] (characteristics of pose
//! tests), [`plan`] (which poses to measure, with a bound), [`noise`] (random numbers from a seed).
//!
//! Doors: [`campaign`] (what the user states), [`import`] (exports and logs become points and joints), [`files`]
//! (whole or not at all), [`cli`].
//!
//! In between: [`table`] (columns and their names), [`frames`] (world frames from features and targets), [`join`]
//! (measurements meet joint values), [`evaluate`] (errors before and after),
//! [`geometry`] (what [`geometric`] makes of a campaign), [`simulate`] (campaigns with a known truth), [`visits`],
//! [`repeatability`] and [`pose_test`] (labelled visits, or tables of them, become characteristics), [`characteristics`] (all
//! that a campaign tests by ISO 9283),
//! [`recording`], [`stream_test`] and [`streams`] (so do recorded motions), [`load_test`] (and a loaded robot's),
//! [`reference_targets`] (drift of the set-up taken out), [`coordinates`] (what
//! their tables share), [`test_plan`] (what to command in such a test), [`compare`] (what changed between campaigns).
//!
//! What comes out: [`document`] (the types behind every JSON document), [`schema`], [`parameters`], [`output`],
//! [`report`] and [`export`], which read documents and nothing else, [`dress`] (a laboratory's logo and templates). [`message`] is how everything says what is wrong.
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
//! A campaign on disk: [`campaign::Campaign::read`], then [`pipeline::run`]. Or data in memory:
//!
//! ```
//! use etalon::math::identify::{Observation, ResidualKind, Settings, identify};
//! use etalon::math::robots::{Prexyt, Robot};
//!
//! let robot = Prexyt::default();
//! let mut truth = robot.nominal();
//! truth[3] = 393.93; // s, mm
//! let joints = [[0.0, 300.0, 300.0], [0.0, 0.0, 256.0], [0.0, 300.0, 44.0], [0.0, 0.0, 0.0], [170.0, 300.0, 300.0],
//!     [170.0, 0.0, 256.0], [170.0, 300.0, 44.0], [170.0, 0.0, 0.0]];
//! let observations: Vec<Observation> = joints
//!     .iter()
//!     .enumerate()
//!     .map(|(i, q)| Observation {
//!         pose: i as i64,
//!         cycle: 1,
//!         joints: q.to_vec(),
//!         targets: robot.balls(&truth, q).map(|[x, y]| Some([x, y, 0.0])).to_vec(),
//!     })
//!     .collect();
//! let settings =
//!     Settings { kind: ResidualKind::Targets, standard_uncertainty_mm: Some(0.002), common_uncertainty_mm: None, hold: Vec::new() };
//! let found = identify(&robot, &observations, &settings)?;
//! assert!((found.values[3] - 393.93).abs() < 1e-9);
//! # Ok::<(), etalon::base::message::Problems>(())
//! ```
#![forbid(unsafe_code)]
#![allow(non_snake_case)] // world_T_base: frames in names

pub mod base;
pub mod campaign;
pub mod cli;
pub mod compare;
pub mod document;
pub mod export;
pub mod import;
pub mod iso9283;
pub mod math;
pub mod report;
pub mod run;
pub mod simulate;
pub mod stages;
