//! All sample campaigns, run once for all tests that look at their output.

use super::root;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// A sample that was run.
pub struct Ran {
    pub name: String,
    /// Folder of the campaign, a copy.
    pub folder: PathBuf,
}

impl Ran {
    /// A document of the output folder.
    pub fn document(&self, name: &str) -> serde_json::Value {
        super::document(&self.folder.join("out").join(name))
    }
}

/// Samples whose data are there, in order.
pub fn ran() -> &'static [Ran] {
    static RAN: OnceLock<(tempfile::TempDir, Vec<Ran>)> = OnceLock::new();
    &RAN.get_or_init(run).1
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap().flatten() {
        let (path, to) = (entry.path(), to.join(entry.file_name()));
        match path.is_dir() {
            true if path.ends_with("out") => {}
            true => copy(&path, &to),
            false => drop(std::fs::copy(&path, &to).unwrap()),
        }
    }
}

fn run() -> (tempfile::TempDir, Vec<Ran>) {
    let folder = tempfile::tempdir().unwrap();
    copy(&root().join("samples"), folder.path());
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder.path()).unwrap().flatten() {
        let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
        if path.join("campaign.toml").is_file() {
            let mut command = Command::new(crate::support::program());
            let ended = command.args(["run", "--skip-missing"]).arg(&path).output().unwrap();
            assert!(ended.status.code() < Some(2), "{name}: {}", String::from_utf8_lossy(&ended.stderr));
            if path.join("out/report.html").is_file() {
                all.push(Ran { name, folder: path });
            }
        }
    }
    all.sort_by(|a, b| a.name.cmp(&b.name));
    (folder, all)
}
