//! Copies of samples that a test may change.

use super::root;
use super::said::Says;
use etalon::documents::{ManifestDocument, ParametersDocument};
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder that goes away with the test.
pub struct Scratch(tempfile::TempDir);

impl Scratch {
    /// A campaign of these files.
    pub fn with(files: &[(&str, &str)]) -> Self {
        let scratch = Self(tempfile::tempdir().unwrap());
        std::fs::create_dir_all(scratch.path().join("exports")).unwrap();
        for (name, text) in files {
            std::fs::write(scratch.path().join(name), text).unwrap();
        }
        scratch
    }

    /// The folder that holds the campaign's.
    pub fn root(&self) -> &Path {
        self.0.path()
    }

    /// The campaign's folder.
    pub fn path(&self) -> PathBuf {
        self.0.path().join("campaign")
    }

    /// A document of the campaign's output folder.
    pub fn document<T: DeserializeOwned>(&self, name: &str) -> T {
        super::document(&self.path().join("out").join(name))
    }

    /// A document of the campaign's output folder as JSON.
    pub fn json(&self, name: &str) -> serde_json::Value {
        self.document(name)
    }

    /// The identified parameters.
    pub fn parameters(&self) -> ParametersDocument {
        self.document("parameters.json")
    }

    /// Replaces text in a file of the campaign; the text must be there.
    pub fn replace(&self, file: &str, from: &str, to: &str) {
        let path = self.path().join(file);
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.contains(from), "{file} does not hold {from:?}");
        std::fs::write(path, text.replace(from, to)).unwrap();
    }
}

/// Writes the manifest of an output folder again, as if the run had written its files as they are.
pub fn stamp(out: &Path) {
    let files = std::fs::read_dir(out).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file());
    let stamped = files.map(|path| {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        (name, etalon::base::files::sha256(&std::fs::read(path).unwrap()))
    });
    let manifest = ManifestDocument::new(stamped.filter(|(name, _)| name != ManifestDocument::NAME).collect());
    std::fs::write(out.join(ManifestDocument::NAME), serde_json::to_vec(&manifest).unwrap()).unwrap();
}

/// A copy of a sample campaign without its output.
pub fn copy_sample(name: &str) -> Scratch {
    let scratch = Scratch(tempfile::tempdir().unwrap());
    let from = root().join("samples").join(name);
    std::fs::create_dir_all(scratch.path().join("exports")).unwrap();
    for file in [
        "campaign.toml",
        "robot.toml",
        "truth.toml",
        "encoders.csv",
        "observations.csv",
        "poses.csv",
        "reference.csv",
        "loads.csv",
        "exports/world.txt",
        "exports/plate.txt",
        "exports/poses.txt",
        "exports/geometric.txt",
        "exports/visits.txt",
        "exports/motion.csv",
        "path.csv",
        "commanded.csv",
        "arm.urdf",
        "two_arms.urdf",
        "two_hands.urdf",
    ] {
        if from.join(file).exists() {
            std::fs::copy(from.join(file), scratch.path().join(file)).unwrap();
        }
    }
    scratch
}

/// `etalon ARGS` in the folder above the campaign's: exit code and stderr.
pub fn said(scratch: &Scratch, arguments: &[&str]) -> (Option<i32>, String) {
    let output = Command::new(crate::support::program()).args(arguments).current_dir(scratch.root()).output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

/// Exit code and stderr of `etalon COMMAND campaign`.
pub fn etalon(scratch: &Scratch, command: &str) -> (Option<i32>, String) {
    said(scratch, &[command, "campaign"])
}

/// What `etalon COMMAND campaign` says on stderr; it must end with `code`, and all `parts` must be said.
pub fn ends(scratch: &Scratch, command: &str, code: i32, parts: &[&str]) -> String {
    let (ended, said) = etalon(scratch, command);
    assert_eq!(ended, Some(code), "{said}");
    for part in parts {
        assert!(said.says(part), "{part:?} is not said:\n{said}");
    }
    said
}

/// The robot of the CMM sample, the true values of its parameters, and the joint values of its log, row by row.
pub fn cmm_truth() -> (Box<dyn etalon::robots::Robot>, Vec<f64>, Vec<[f64; 3]>) {
    let scratch = copy_sample("prexyt-cmm");
    let robot = etalon::campaign::read_robot(&scratch.path().join("robot.toml")).unwrap();
    let robot = robot.build(&["K".to_owned(), "L".to_owned()]).unwrap();
    let truth = etalon::simulate::Truth::read(&scratch.path().join("truth.toml")).unwrap();
    let value = |p: &etalon::robots::Parameter| p.quantity.inward(truth.parameters[&p.name]);
    let values = robot.parameters().iter().map(value).collect();
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let joints = |line: &str| {
        let q: Vec<f64> = line.split(',').skip(2).map(|cell| cell.parse().unwrap()).collect();
        [q[0], q[1], q[2]]
    };
    let joints = log.lines().skip(1).map(joints).collect();
    (robot, values, joints)
}
