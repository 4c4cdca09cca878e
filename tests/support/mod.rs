//! What several suites of tests share.
#![allow(dead_code)] // each suite uses a part

pub mod arms;
pub mod controller_files;
pub mod five_bar;
pub mod linearised;
pub mod pages;
pub mod said;
pub mod samples;
pub mod scratch;
mod skipped;
pub mod tracker;

pub use skipped::skipped;

use etalon::base::folder::Durability;
use etalon::base::message::Problems;
use etalon::campaign::Campaign;
use etalon::run::pipeline::{self, Outcome, Wanted};
use serde::de::DeserializeOwned;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// The folder of this checkout, as the runner of the tests states it: what was compiled in another
/// checkout with the same build folder would name that one.
pub fn root() -> &'static Path {
    static ROOT: OnceLock<PathBuf> = OnceLock::new();
    let stated = || std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    ROOT.get_or_init(|| PathBuf::from(stated()))
}

/// The program that the tests start: the one that was built with them, or `ETALON_PROGRAM`.
pub fn program() -> &'static str {
    static PROGRAM: OnceLock<Option<String>> = OnceLock::new();
    let stated = PROGRAM.get_or_init(|| std::env::var("ETALON_PROGRAM").ok());
    stated.as_deref().unwrap_or(env!("CARGO_BIN_EXE_etalon"))
}

/// A document from its file.
pub fn document<T: DeserializeOwned>(path: &Path) -> T {
    let bytes = std::fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_slice(&bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// How a process ended.
#[derive(Debug)]
pub struct Ended {
    /// Exit code; `None` of a process that was killed.
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
    /// Peak of its resident memory, bytes.
    pub peak: f64,
}

/// Runs a process to its end; `None` where it takes longer, and is killed.
pub fn run_for(command: &mut Command, limit: Duration) -> Option<Ended> {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).stdin(Stdio::null()).spawn().unwrap();
    let read = |mut stream: Box<dyn Read + Send>| {
        std::thread::spawn(move || {
            let mut bytes = Vec::new();
            let _ = stream.read_to_end(&mut bytes);
            String::from_utf8_lossy(&bytes).into_owned()
        })
    };
    let (stdout, stderr) = (read(Box::new(child.stdout.take().unwrap())), read(Box::new(child.stderr.take().unwrap())));
    let (begun, mut peak) = (Instant::now(), 0.0);
    let code = loop {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kib = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
        peak = f64::max(peak, kib.unwrap_or(0.0) * 1024.0);
        match child.try_wait().unwrap() {
            Some(ended) => break ended.code(),
            None if begun.elapsed() > limit => {
                let _ = child.kill();
                let _ = child.wait();
                return None;
            }
            None => std::thread::sleep(Duration::from_millis(2)),
        }
    };
    Some(Ended { code, stdout: stdout.join().unwrap(), stderr: stderr.join().unwrap(), peak })
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
