//! Agreement with the reference campaigns, whose parameters, covariance and errors were computed in 110 digits by a program that shares
//! nothing with etalon. Synthetic.

use crate::support::documents_of;
use crate::support::root;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::campaign::Campaign;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Number of reference campaigns.
const CAMPAIGNS: usize = 12;

fn archive() -> PathBuf {
    root().join("samples/reference")
}

/// Names of the reference campaigns.
fn names() -> Vec<String> {
    let folders =
        std::fs::read_dir(archive()).unwrap().flatten().filter(|entry| entry.path().join("certified.json").exists());
    let mut names: Vec<String> = folders.map(|entry| entry.file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn read(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

fn certified(name: &str) -> Value {
    read(&archive().join(name).join("certified.json"))
}

fn items(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

/// Errors of a run over the maximum permissible errors, by name.
struct Shares(Vec<(String, f64)>);

impl Shares {
    /// Runs the campaign and compares its documents.
    fn of(scratch: &Scratch, certified: &Value) -> Self {
        documents_of(&Campaign::read(&scratch.path()).unwrap()).unwrap();
        let [parameters, accuracy] =
            ["parameters", "accuracy"].map(|name| read(&scratch.path().join(format!("out/{name}.json"))));
        let mut shares = Self(Vec::new());
        shares.parameters(certified, &parameters);
        shares.covariance(&certified["covariance"], &parameters);
        shares.residuals(&certified["residuals"], &parameters["residuals"]);
        shares.errors(certified, &accuracy);
        shares
    }

    fn add(&mut self, name: String, found: &Value, expected: &Value, permissible: f64) {
        self.0.push((name, (number(found) - number(expected)).abs() / permissible));
    }

    fn parameters(&mut self, certified: &Value, found: &Value) {
        let found: BTreeMap<&str, &Value> = items(&found["parameters"]).iter().map(|p| (text(&p["name"]), p)).collect();
        for expected in items(&certified["parameters"]) {
            let name = text(&expected["name"]);
            let (found, mpe) = (found[name], number(&expected["mpe"]));
            assert_eq!(found["status"], expected["status"], "{name}");
            assert_eq!(found["unit"], expected["unit"], "{name}");
            for key in ["value", "before"] {
                if let Some(expected) = expected.get(key) {
                    self.add(format!("{name} {key}"), &found[key], expected, mpe);
                }
            }
        }
    }

    fn covariance(&mut self, certified: &Value, found: &Value) {
        let identified = items(&found["parameters"]).iter().filter(|p| p["status"] == "identified");
        let place: BTreeMap<&str, usize> = identified.map(|p| text(&p["name"])).zip(0..).collect();
        let names: Vec<&str> = items(&certified["parameters"]).iter().map(text).collect();
        let (rows, relative) = (items(&certified["lower_triangle"]), number(&certified["mpe_relative"]));
        let variance = |i: usize| number(&rows[i][i]);
        for (i, a) in names.iter().enumerate() {
            for (j, b) in names.iter().enumerate().take(i + 1) {
                let permissible = relative * (variance(i) * variance(j)).sqrt();
                self.add(
                    format!("covariance {a} {b}"),
                    &found["covariance"][place[a]][place[b]],
                    &rows[i][j],
                    permissible,
                );
            }
        }
    }

    fn residuals(&mut self, certified: &Value, found: &Value) {
        let relative = number(&certified["mpe_relative"]);
        for (key, own) in [("rms_mm", "rms"), ("chi_square", "chi_square")] {
            self.add(key.to_owned(), &found[own], &certified[key], relative * number(&certified[key]));
        }
        assert_eq!(number(&found["degrees_of_freedom"]), number(&certified["degrees_of_freedom"]).round());
    }

    fn errors(&mut self, certified: &Value, found: &Value) {
        for expected in items(&certified["errors"]) {
            let set = items(&found["sets"]).iter().find(|set| set["name"] == expected["set"]).unwrap();
            let found = items(&set["errors"]).iter().find(|e| e["quantity"] == expected["quantity"]).unwrap();
            assert_eq!((&found["unit"], &found["count"]), (&expected["unit"], &expected["count"]));
            for side in ["before", "after"] {
                for (key, value) in expected.get(side).and_then(Value::as_object).into_iter().flatten() {
                    let name = format!("{} {} {side} {key}", text(&expected["set"]), text(&expected["quantity"]));
                    self.add(name, &found[side][key], value, number(&expected["mpe"]));
                }
            }
        }
    }

    /// The largest share and its name; a share that is not a number is the largest.
    fn worst(&self) -> &(String, f64) {
        let size = |share: f64| if share.is_nan() { f64::INFINITY } else { share };
        self.0.iter().max_by(|a, b| size(a.1).total_cmp(&size(b.1))).unwrap()
    }
}

#[test]
fn every_reference_campaign_has_its_certified_values() {
    let names = names();
    assert_eq!(names.len(), CAMPAIGNS, "{names:?}");
    for name in names {
        let certified = certified(&name);
        for (file, sha256) in certified["files"].as_object().unwrap() {
            let bytes = std::fs::read(archive().join(&name).join(file)).unwrap();
            assert_eq!(etalon::base::files::sha256(&bytes), text(sha256), "{name}/{file}");
        }
        let shares = Shares::of(&copy_sample(&format!("reference/{name}")), &certified);
        let (value, share) = shares.worst();
        println!("{name}: {} values; largest error over the permissible one: {share:.1e} ({value})", shares.0.len());
        assert!(*share <= 1.0, "{name}: {value} is off by {share} permissible errors");
    }
}

#[test]
fn one_changed_digit_is_beyond_the_permissible_errors() {
    let name = "prexyt-clean";
    let scratch = copy_sample(&format!("reference/{name}"));
    assert!(Shares::of(&scratch, &certified(name)).worst().1 <= 1.0);
    // in a certified value: 1e-8 of a length
    for (list, key) in [("parameters", "value"), ("parameters", "before")] {
        let mut changed = certified(name);
        let entry = &mut changed[list][3];
        entry[key] = (number(&entry[key]) * (1.0 + 1e-8)).into();
        assert!(Shares::of(&scratch, &changed).worst().1 > 1.0, "{key}");
    }
    let mut changed = certified(name);
    let element = &mut changed["covariance"]["lower_triangle"][4][2];
    *element = (number(element) * (1.0 + 1e-7)).into();
    assert!(Shares::of(&scratch, &changed).worst().1 > 1.0);
    // in the last digit of one reading
    let table = std::fs::read_to_string(scratch.path().join("observations.csv")).unwrap();
    let row = table.lines().nth(1).unwrap();
    let last = row.chars().last().unwrap().to_digit(10).unwrap();
    let moved = format!("{}{}", &row[..row.len() - 1], (last + 1) % 10);
    scratch.replace("observations.csv", row, &moved);
    assert!(Shares::of(&scratch, &certified(name)).worst().1 > 1.0);
}

/// The archive has every campaign, the programs and checksums, and the same bytes wherever it is made.
#[test]
fn the_archive_is_complete_and_reproducible() {
    let made = |folder: &Path| {
        let script = root().join("tests/reference/campaigns/archive.sh");
        let output = Command::new("bash").arg(script).arg(folder).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        folder.join("etalon-reference-1.tar.gz")
    };
    let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    let [one, other] = [0, 1].map(|i| made(folders[i].path()));
    assert!(std::fs::read(&one).unwrap() == std::fs::read(other).unwrap());
    let bash = |command: &str| {
        let output = Command::new("bash").args(["-c", command]).current_dir(folders[0].path()).output().unwrap();
        assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    bash("tar xzf etalon-reference-1.tar.gz && cd etalon-reference-1 && sha256sum -c --quiet SHA256SUMS");
    let files = bash("cd etalon-reference-1 && find . -type f");
    for name in names() {
        assert!(files.contains(&format!("./{name}/certified.json")), "{name}");
    }
    for file in
        ["README.md", "LICENSE", "CITATION.cff", "program/make.py", "program/compare.py", "program/kinematics.py"]
    {
        assert!(files.contains(&format!("./{file}\n")), "{file}");
    }
    assert!(!bash("cat etalon-reference-1/README.md").contains("samples/reference"));
}
