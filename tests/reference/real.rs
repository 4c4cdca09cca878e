//! `make real` with the files of the reference folder instead of the network.

use crate::support::root;
use std::path::Path;
use std::process::{Command, Output};

/// Runs the script on the files in `source`.
fn real(source: &Path, folder: &Path) -> Output {
    let script = root().join("tests/real/real.sh");
    let arguments = [Path::new(env!("CARGO_BIN_EXE_etalon")), folder];
    Command::new(script).args(arguments).env("REAL_SOURCE", source).output().unwrap()
}

#[test]
fn public_campaigns_reproduce_their_published_figures() {
    if crate::reference_data("robots/irb120_faro_ets").is_none() {
        return;
    }
    let source = std::env::var("ETALON_REFERENCE").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let output = real(Path::new(&source), folder.path());
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{text}");
    // seven figures of the arm, and RP of three reflectors in three series
    assert_eq!(text.lines().filter(|line| line.contains(", mm ")).count(), 16, "{text}");
}

#[test]
fn a_public_file_with_another_digit_is_refused() {
    if crate::reference_data("robots/irb120_faro_ets").is_none() {
        return;
    }
    let (source, folder) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let from = std::env::var("ETALON_REFERENCE").unwrap();
    // the first file of the list
    let name = "robots/irb120_faro_ets/full_raw/measured_base_1.txt";
    let mut bytes = std::fs::read(Path::new(&from).join(name)).unwrap();
    let digit = bytes.iter().position(u8::is_ascii_digit).unwrap();
    bytes[digit] = if bytes[digit] == b'1' { b'2' } else { b'1' };
    std::fs::create_dir_all(source.path().join(name).parent().unwrap()).unwrap();
    std::fs::write(source.path().join(name), bytes).unwrap();
    let output = real(source.path(), folder.path());
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(text.contains(name) && text.contains("SHA-256"), "{text}");
}
