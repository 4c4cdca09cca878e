//! Laws of the mathematics, and of output folders, and real robots. Many are shown by thousands of simulated
//! measurements or runs: `make test` runs this suite optimised.
#![allow(clippy::print_stdout)] // a test says what it measured

mod arms;
mod budget;
mod chains;
mod common;
mod compare;
mod compensation;
mod conditions;
mod conventions;
mod coverage;
mod enclosing;
#[cfg(unix)]
mod faults;
mod features;
mod fits;
mod fits_covariances;
mod fits_hostile;
mod five_bar;
mod folders;
mod geometric;
mod geometric_campaign;
mod hilti;
mod irb120;
mod iso9283;
mod iso9283_beyond;
mod iso9283_corners;
mod iso9283_layout;
mod iso9283_path_intervals;
mod iso9283_paths;
mod iso9283_stream;
mod iso9283_weaves_and_loads;
mod monte_carlo;
mod mutants;
mod nist_geometry;
mod nist_strd;
mod plans;
mod platforms;
mod prediction;
mod prexyt;
mod probes;
mod qkm;
mod recommendation;
mod rigid;
mod robots;
mod robust;
mod samples;
mod serial;
mod set_ups;
mod solving;
mod stability;
mod standstills;
#[path = "../support/mod.rs"]
mod support;
mod thresholds;
mod tool;
mod verification;
mod zones;
mod zones_in_space;

pub(crate) use support::reference_data;
