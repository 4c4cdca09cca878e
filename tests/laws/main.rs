//! Laws of the mathematics, and of output folders, and real robots. Many are shown by thousands of simulated
//! measurements or runs: `make test` runs this suite optimised.
#![allow(clippy::print_stdout)] // a test says what it measured

mod base;
mod campaigns;
mod compare;
mod controllers;
mod fit;
mod identify;
mod math;
mod robots;
mod standards;
#[path = "../support/mod.rs"]
mod support;

pub(crate) use support::reference_data;
