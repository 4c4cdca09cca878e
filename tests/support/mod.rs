//! What several suites of tests share.
#![allow(dead_code)] // each suite uses a part

pub mod arms;
pub mod five_bar;
pub mod linearised;
pub mod scratch;
pub mod tracker;

/// The reference data, or `None` after saying that the test is skipped.
pub fn reference_data(folder: &str) -> Option<std::path::PathBuf> {
    match std::env::var_os("ETALON_REFERENCE") {
        Some(root) => {
            let path = std::path::PathBuf::from(root).join(folder);
            assert!(path.is_dir(), "ETALON_REFERENCE has no folder {folder}");
            Some(path)
        }
        None => {
            println!("skipped: ETALON_REFERENCE is not set, {folder} is not there to test against");
            None
        }
    }
}
