//! Output folders that earlier versions wrote are read by today's program.

use crate::support::root;
use crate::support::scratch::copy_sample;
use crate::support::{documents_of, program};
use etalon::campaign::Campaign;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Folders in a folder, in order.
fn folders(root: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root).unwrap().flatten().map(|entry| entry.path());
    let mut folders: Vec<PathBuf> = entries.filter(|path| path.is_dir()).collect();
    folders.sort();
    folders
}

/// Stored output folders of all versions.
fn stored() -> Vec<PathBuf> {
    let root = root().join("tests/documents");
    folders(&root).iter().flat_map(|version| folders(version)).collect()
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for file in std::fs::read_dir(from).unwrap().flatten() {
        std::fs::copy(file.path(), to.join(file.file_name())).unwrap();
    }
}

/// Versions of the documents in an output folder, for example `etalon/accuracy/1`.
fn versions(folder: &Path) -> BTreeSet<String> {
    let files = std::fs::read_dir(folder).unwrap().flatten().map(|entry| entry.path());
    let documents = files.filter(|path| path.extension().is_some_and(|extension| extension == "json"));
    let version = |path: PathBuf| {
        let document: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
        document["schema"].as_str().map(str::to_owned)
    };
    documents.filter_map(version).collect()
}

/// Runs a command, which must succeed; returns its stdout.
fn etalon(folder: &Path, arguments: &[&str]) -> String {
    let output = Command::new(program()).args(arguments).current_dir(folder).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn stored_folders_are_read() {
    let all = stored();
    assert!(!all.is_empty());
    for stored in all {
        let scratch = tempfile::tempdir().unwrap();
        let root = scratch.path();
        ["then", "again"].iter().for_each(|name| copy(&stored, &root.join(name)));
        etalon(root, &["report", "then"]);
        let report = std::fs::read_to_string(root.join("then/report.html")).unwrap();
        let campaign: Value = crate::support::document(&stored.join("campaign.json"));
        assert!(report.contains(campaign["name"].as_str().unwrap()), "{}", stored.display());
        etalon(root, &["compare", "again", "then"]);
        if !stored.join("parameters.json").is_file() {
            continue;
        }
        etalon(root, &["export", "again/parameters.json", "--format", "csv", "--to", "exported"]);
        // the values that were exported then
        let values = |folder: &str| {
            let text = std::fs::read_to_string(root.join(folder).join("controller.csv")).unwrap();
            let rows = text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
            rows.map(|row| (row[0].clone(), row[3].parse::<f64>().unwrap())).collect::<Vec<_>>()
        };
        assert_eq!(values("again"), values("exported"), "{}", stored.display());
    }
}

/// A document of a new version needs a stored folder of that version.
#[test]
fn every_version_that_is_written_is_stored() {
    let stored: BTreeSet<String> = stored().iter().flat_map(|folder| versions(folder)).collect();
    for sample in ["prexyt-geometric", "pose-test", "prexyt-repeatability"] {
        let scratch = copy_sample(sample);
        documents_of(&Campaign::read(&scratch.path()).unwrap()).unwrap();
        let missing: Vec<String> = versions(&scratch.path().join("out")).difference(&stored).cloned().collect();
        assert!(
            missing.is_empty(),
            "{sample}: store an output folder with {missing:?} in tests/documents (see its README)"
        );
    }
}
