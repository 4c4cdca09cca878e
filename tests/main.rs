//! Tests by what they prove.
#![allow(clippy::print_stdout)] // a test says what it measured and what it skipped

mod architecture;
mod browser;
mod campaigns;
mod cli;
mod dependencies;
mod golden;
mod hostile;
mod reference;
mod support;

/// The reference data, or `None` after saying that the test is skipped.
fn reference_data(folder: &str) -> Option<std::path::PathBuf> {
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
