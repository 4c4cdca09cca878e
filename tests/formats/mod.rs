//! Proposals of `etalon formats` for a corpus of synthetic files, whose right readings are stated beside them in `right.toml`.

mod alike;
mod commanded;
mod conventions;
mod drawn;
mod init;
mod public;
pub(crate) mod recordings;
mod robot;
mod several;
mod six_d;
mod strangers;
mod tables;

use crate::support::root;
use etalon::base::message::{Problems, SourceText};
use etalon::documents::{FormatsDocument, Source, SourceKind};
use etalon::formats::{Export, Log, TableReading, file_text, log, observations_with, propose_file};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Exit code and output, stdout before stderr, of the program in a folder.
fn program(at: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output =
        std::process::Command::new(crate::support::program()).args(arguments).current_dir(at).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout) + &text(output.stderr))
}

#[derive(Deserialize)]
struct Corpus {
    file: Vec<Right>,
}

/// The right reading of a file.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Right {
    name: String,
    kind: String,
    format: Option<String>,
    stated: Option<String>,
    unit: Option<String>,
    #[serde(rename = "UNIT")]
    joint_unit: Option<String>,
    first_mm: Vec<[f64; 3]>,
    within: Option<f64>,
    joints: Vec<toml::Value>,
    doubt: bool,
    refused: Option<String>,
    length: Option<String>,
    orientation: Option<String>,
    /// The proposal asks what the file holds, and proposes no columns.
    questions_alone: bool,
}

fn folder() -> PathBuf {
    root().join("tests/formats/corpus")
}

fn corpus() -> Vec<Right> {
    let text = std::fs::read_to_string(folder().join("../right.toml")).unwrap();
    toml::from_str::<Corpus>(&text).unwrap().file
}

/// The lines of a proposal, with what the file cannot state answered.
fn answered(document: &FormatsDocument, right: &Right) -> String {
    let joint = right.joint_unit.as_deref().unwrap_or("deg");
    let length = right.unit.as_deref().or(right.stated.as_deref()).or(right.length.as_deref()).unwrap_or("mm");
    let mut text = document.toml.replace("unit = \"?\"", &format!("unit = \"{length}\""));
    for name in ["x", "y", "z", "distance"] {
        text = text.replace(&format!("{name}_UNIT ="), &format!("{name}_{length} ="));
    }
    for name in ["a", "b", "c"] {
        text = text.replace(&format!("{name}_UNIT ="), &format!("{name}_deg ="));
    }
    text =
        text.replace("rotation = \"?\"", "rotation = \"vector\"").replace("as_exported = \"?\"", "as_exported = true");
    let order = right.orientation.as_deref().unwrap_or("zyx");
    text = text.replace("orientation = \"?\"", &format!("orientation = \"{order}\""));
    text.replace("time_UNIT", "time_s").replace("_UNIT", &format!("_{joint}")).replace("\"?\"", "\"T\"")
}

#[derive(Deserialize)]
struct Proposed {
    #[serde(default, rename = "export")]
    exports: Vec<Export>,
    log: Option<Log>,
    observations: Option<etalon::campaign::ObservationsDefinition>,
}

/// Columns of joints in their order, as lines state them.
fn stated_joints(lines: &toml::Table) -> Vec<toml::Value> {
    let place = ["export", "log", "observations"].iter().find_map(|key| lines.get(*key));
    let Some(place) = place else { return Vec::new() };
    let place = place.as_array().map_or(place, |all| &all[0]);
    let columns = place.get("joints").or(place.get("columns")).and_then(toml::Value::as_table);
    let mut joints: Vec<(usize, toml::Value)> = Vec::new();
    for (key, column) in columns.into_iter().flatten() {
        let number = key.strip_prefix('q').and_then(|rest| rest.split_once('_')).and_then(|(n, _)| n.parse().ok());
        joints.extend(number.map(|number| (number, column.clone())));
    }
    joints.sort_by_key(|(number, _)| *number);
    joints.into_iter().map(|(_, column)| column).collect()
}

fn near(found: [f64; 3], right: [f64; 3], within: f64) -> bool {
    found.iter().zip(right).all(|(a, b)| (a - b).abs() <= within)
}

/// What is wrong with the proposal for a file.
fn wrong(right: &Right, path: &Path) -> Result<(), String> {
    let proposed = propose_file(path);
    if let Some(word) = &right.refused {
        let said = proposed.err().map(|problems| problems.to_string());
        return match said {
            Some(said) if said.contains(word.as_str()) => Ok(()),
            said => Err(format!("not refused by {word}: {said:?}")),
        };
    }
    let document = proposed.map_err(|problems| problems.to_string())?;
    let shown = |what: String| Err(format!("{what}\n{}", document.toml));
    if document.kind != right.kind {
        return shown(format!("proposed as `{}`, it is `{}`", document.kind, right.kind));
    }
    if right.doubt && document.doubts.is_empty() && document.questions.is_empty() {
        return shown("no doubt is stated".to_owned());
    }
    if right.format.is_some() && document.format != right.format {
        return shown(format!("the format is {:?}", document.format));
    }
    let lines: toml::Table = match toml::from_str(&document.toml) {
        Ok(lines) => lines,
        Err(error) => return shown(format!("the lines do not read: {error}")),
    };
    let units = lines.get("export").and_then(toml::Value::as_array).into_iter().flatten().map(|e| e["unit"].as_str());
    let stated = right.stated.as_deref().or(right.unit.as_ref().map(|_| "?"));
    if units.clone().count() > 0 && !units.clone().all(|unit| unit == stated) {
        return shown(format!("the unit is stated as {:?}", units.collect::<Vec<_>>()));
    }
    if stated_joints(&lines) != right.joints {
        return shown(format!("the joints are {:?}", stated_joints(&lines)));
    }
    let text = answered(&document, right);
    read(path, &text, right).or_else(|said| shown(format!("{said}\n{text}")))
}

/// A log without a file.
fn source() -> Source {
    Source {
        file: String::new(),
        sha256: String::new(),
        sha256_without_backup: None,
        bytes: 0,
        kind: SourceKind::Log,
        dialect: "".into(),
        rows_read: 0,
        refused: Vec::new(),
        standstills: Vec::new(),
    }
}

/// Reads the file as the lines state, and compares the first points.
fn read(path: &Path, lines: &str, right: &Right) -> Result<(), String> {
    let said = |problems: Problems| problems.to_string();
    let proposed: Proposed = toml::from_str(lines).map_err(|error| error.to_string())?;
    let bytes = std::fs::read(path).unwrap();
    let within = right.within.unwrap_or(1e-6);
    let mut first: Vec<[f64; 3]> = Vec::new();
    for export in &proposed.exports {
        let text = file_text(path, &bytes, export.encoding, &export.format).map_err(said)?;
        let (points, problems) = export.format.read("f", &text.into(), export.unit);
        problems.check().map_err(said)?;
        first.extend(points.iter().find(|p| p.refused.is_none()).map(|p| p.xyz_mm));
    }
    if let Some(stated) = &proposed.log {
        let text = stated.load(path).map_err(said)?.text;
        let mut source = source();
        log(SourceText { name: "c", text: lines }, stated, &text, &mut source).map_err(said)?;
    }
    if let Some(stated) = &proposed.observations {
        let text = file_text(path, &bytes, stated.layout.form.encoding, &Default::default()).map_err(said)?;
        let layout: TableReading = stated.reading();
        let table = observations_with("f", &text, &layout).map_err(said)?;
        if !right.first_mm.is_empty() {
            first.extend(table.positions().map_err(said)?.first());
        }
    }
    let all = first.len() == right.first_mm.len();
    let fits = all && first.iter().zip(&right.first_mm).all(|(found, right)| near(*found, *right, within));
    if fits { Ok(()) } else { Err(format!("the first points are {first:?}, not {:?}", right.first_mm)) }
}

#[test]
fn the_right_reading_of_every_file_of_the_corpus_is_proposed() {
    let corpus = corpus();
    let files: BTreeMap<String, ()> =
        std::fs::read_dir(folder()).unwrap().map(|e| (e.unwrap().file_name().into_string().unwrap(), ())).collect();
    let named: BTreeMap<String, ()> = corpus.iter().map(|right| (right.name.clone(), ())).collect();
    assert_eq!(files, named);
    assert!(corpus.len() >= 60, "{}", corpus.len());
    let wrong: Vec<String> = corpus
        .iter()
        .filter_map(|right| {
            wrong(right, &folder().join(&right.name)).err().map(|said| format!("{}: {said}", right.name))
        })
        .collect();
    println!("{} of {} files are proposed right", corpus.len() - wrong.len(), corpus.len());
    // of the others a doubt is stated, and no lines are proposed
    let unread = |said: &&String| said.contains("# DOUBT") && said.contains("no column is a measured coordinate");
    assert!(wrong.iter().all(|said| unread(&said)), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
    assert!(wrong.len() * 20 <= corpus.len(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}

/// A break at the end of a long file is seen: the whole file is read, not its head.
#[test]
fn the_end_of_a_long_file_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("long.csv");
    let row = |i: usize| format!("{i},{:.3},{:.3},{:.3}\n", 1000.5 + i as f64, 2000.25, 300.125);
    let mut text: String = "n,x,y,z\n".to_owned() + &(0..5000).map(row).collect::<String>();
    std::fs::write(&path, &text).unwrap();
    let document = propose_file(&path).unwrap();
    assert_eq!(document.rows, 5000);
    assert!(document.reasons[0].english().starts_with("5000 of 5000 rows"), "{:?}", document.reasons);
    text += "5000,one,two,three\n";
    std::fs::write(&path, &text).unwrap();
    let document = propose_file(&path).unwrap();
    assert!(document.doubts.iter().any(|doubt| doubt.english().contains("line 5002")), "{:?}", document.doubts);
}
