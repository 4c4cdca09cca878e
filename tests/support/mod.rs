//! What several suites of tests share.
#![allow(dead_code)] // each suite uses a part

pub mod arms;
pub mod five_bar;
pub mod linearised;
pub mod scratch;
mod skipped;
pub mod tracker;

pub use skipped::skipped;

use etalon::base::folder::Durability;
use etalon::base::message::Problems;
use etalon::campaign::Campaign;
use etalon::run::pipeline::{self, Outcome, Wanted};

/// The program that the tests start.
pub fn program() -> &'static str {
    env!("CARGO_BIN_EXE_etalon")
}

/// What a campaign gives without its reports, which take most of the time of a run.
pub fn documents_of(campaign: &Campaign) -> Result<Outcome, Problems> {
    pipeline::run_for(campaign, Wanted::Documents, Durability::Later)
}

/// The reference data, or `None` after saying that the test is skipped; where `CI` is set it fails.
pub fn reference_data(folder: &str) -> Option<std::path::PathBuf> {
    match std::env::var_os("ETALON_REFERENCE") {
        Some(root) => {
            let path = std::path::PathBuf::from(root).join(folder);
            assert!(path.is_dir(), "ETALON_REFERENCE has no folder {folder}");
            Some(path)
        }
        None => {
            skipped("ETALON_REFERENCE");
            None
        }
    }
}
