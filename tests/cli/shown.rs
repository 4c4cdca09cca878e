//! Everything that pages show is read by the program: blocks of TOML, commands outside of `console` blocks, names of sections.

use crate::support::pages::{Block, blocks, pages, shown};
use crate::support::root;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Errors of a fragment that the rest of its file and the files that it names would remove.
const OF_THE_REST: [&str; 11] = [
    "key-missing",
    "input-missing",
    "export-files-missing",
    "cannot-read-file",
    "limit-without-result",
    "no-target",
    "target-not-exported",
    "column-unknown",
    "feature-unknown",
    "label-unknown",
    "point-or-feature-unknown",
];

/// Robots whose joints the fragments of campaigns name.
const ROBOTS: [&str; 2] = ["samples/prexyt-cmm/robot.toml", "samples/probe-poses/robot.toml"];

/// Ids of the errors of a command.
fn errors(folder: &Path, arguments: &[&str]) -> Vec<String> {
    let ended = Command::new(crate::support::program()).args(arguments).current_dir(folder).output().unwrap();
    let said = String::from_utf8_lossy(&ended.stderr).into_owned();
    let of_line =
        |line: &str| line.strip_prefix("error").map(|rest| rest.split(['[', ']']).nth(1).unwrap_or("usage").to_owned());
    said.lines().filter_map(of_line).collect()
}

/// Errors of a fragment as each of the files that the program reads; an empty list if one of them accepts the fragment.
fn refused(text: &str, table: &toml::Table) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let stated = |key: &str, line: &str| if table.contains_key(key) { String::new() } else { line.to_owned() };
    let instrument = "\n[instrument]\nname = \"t\"\nexpanded_uncertainty_um = 20\ncoverage_factor = 2\n";
    let head = stated("name", "name = \"x\"\n") + &stated("robot", "robot = \"robot.toml\"\n");
    fs::write(at.join("campaign.toml"), head + text + &stated("instrument", instrument)).unwrap();
    let mut all = Vec::new();
    let mut accepts = |kind: &str, found: Vec<String>, allowed: &[&str]| {
        let wrong: BTreeSet<String> = found.into_iter().filter(|id| !allowed.contains(&id.as_str())).collect();
        all.push(format!("as {kind}: {wrong:?}"));
        wrong.is_empty()
    };
    for robot in ROBOTS {
        fs::copy(root().join(robot), at.join("robot.toml")).unwrap();
        if accepts("campaign.toml", errors(at, &["check", "."]), &OF_THE_REST) {
            return Vec::new();
        }
    }
    fs::write(at.join("robot.toml"), text).unwrap();
    fs::write(at.join("joints.csv"), "pose\n1\n").unwrap();
    let found = errors(at, &["kinematics", "direct", "joints.csv", "--robot", "robot.toml"]);
    if accepts("robot.toml", found, &OF_THE_REST) {
        return Vec::new();
    }
    let sample = root().join("samples/torque-arm");
    for file in ["campaign.toml", "robot.toml"] {
        fs::copy(sample.join(file), at.join(file)).unwrap();
    }
    fs::write(at.join("truth.toml"), text).unwrap();
    if accepts("truth.toml", errors(at, &["simulate", "."]), &["key-missing", "table-without-observe"]) {
        return Vec::new();
    }
    all
}

/// `true` if the first line of a block that is no comment is a section or a key of TOML.
fn begins_as_toml(block: &Block) -> bool {
    let first = block.text.lines().map(str::trim).find(|line| !line.is_empty() && !line.starts_with('#')).unwrap_or("");
    let key = |text: &str| text.chars().all(|c| c.is_ascii_alphanumeric() || "_-.".contains(c));
    let stated = first.split_once(" = ").is_some_and(|(name, value)| key(name) && !value.starts_with("etalon."));
    match &block.info {
        Some(info) => info.starts_with("toml"),
        None => first.starts_with('[') || stated && first.parse::<toml::Table>().is_ok(),
    }
}

#[test]
fn each_block_of_toml_is_read_by_the_program() {
    let (mut wrong, mut read) = (Vec::new(), 0);
    for page in pages() {
        for block in blocks(&fs::read_to_string(&page).unwrap()).iter().filter(|block| begins_as_toml(block)) {
            let found = match block.text.parse::<toml::Table>() {
                Ok(table) => refused(&block.text, &table),
                Err(e) => vec![e.to_string()],
            };
            read += 1;
            if !found.is_empty() {
                wrong.push(format!("{}:{}: {}", shown(&page), block.line, found.join("; ")));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(read >= 20, "{read} blocks");
}

#[test]
fn a_fragment_with_an_unknown_key_is_refused() {
    let table = |text: &str| text.parse::<toml::Table>().unwrap();
    for text in
        ["[iso9283]\nband_mm = 0.1\n", "[identify]\ncalibration = 3\n", "model = \"serial\"\nconvention = \"abc\"\n"]
    {
        assert!(!refused(text, &table(text)).is_empty(), "{text}");
    }
    let text = "[identify]\ncalibration = \"1-8\"\n";
    assert_eq!(refused(text, &table(text)), Vec::<String>::new());
}

/// Commands of a block that is not run elsewhere, in one line each.
fn commands(block: &Block) -> Vec<String> {
    if block.info.as_deref().is_some_and(|info| info != "sh") {
        return Vec::new();
    }
    let lines = block.text.replace("\\\n", " ");
    let command = |line: &str| {
        let line = line.trim().trim_start_matches("$ ");
        let command = line.split(['#', '>', '|']).next()?.trim();
        command.starts_with("etalon ").then(|| command.to_owned())
    };
    lines.lines().filter_map(command).collect()
}

/// The files of most commands do not exist, so they end before they compute; a wrong name or value of an option ends them earlier.
#[test]
fn each_command_has_options_of_the_program() {
    let folder = tempfile::tempdir().unwrap();
    let program = Path::new(crate::support::program()).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let (mut wrong, mut read) = (Vec::new(), 0);
    for page in pages() {
        for block in blocks(&fs::read_to_string(&page).unwrap()) {
            for command in commands(&block).iter().filter(|command| !command.contains("selftest --report")) {
                let mut bash = Command::new("bash");
                let ended = bash.args(["-c", command]).current_dir(folder.path()).env("PATH", &path).output().unwrap();
                let said = String::from_utf8_lossy(&ended.stderr).into_owned();
                read += 1;
                if said.lines().any(|line| line.starts_with("error: ")) {
                    wrong.push(format!("{}:{}: {command}\n{said}", shown(&page), block.line));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(read >= 40, "{read} commands");
}

/// Sections in the text of pages (`[frame.world]`, `[[export]]`) are sections of the schemas of input files.
#[test]
fn sections_named_in_prose_exist() {
    let (mut wrong, mut read) = (Vec::new(), 0);
    let inputs = [etalon::campaign::SCHEMAS, etalon::simulate::SCHEMAS].concat();
    let named: BTreeSet<String> = inputs.iter().flat_map(|(_, text)| properties(text)).collect();
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        let prose: String = text.split("```").step_by(2).collect();
        for code in prose.split('`').skip(1).step_by(2) {
            let name = code.strip_prefix("[[").and_then(|rest| rest.strip_suffix("]]"));
            let name = name.or_else(|| code.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')));
            let is_name =
                |name: &&str| !name.is_empty() && name.chars().all(|c| c.is_ascii_lowercase() || "._".contains(c));
            for part in name.filter(is_name).into_iter().flat_map(|name| name.split('.')) {
                read += 1;
                if !named.contains(part) {
                    wrong.push(format!("{}: `{code}`", shown(&page)));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(read >= 100, "{read} names");
}

/// All names of keys in a schema.
fn properties(schema: &str) -> BTreeSet<String> {
    fn walk(value: &serde_json::Value, found: &mut BTreeSet<String>) {
        if let Some(properties) = value["properties"].as_object() {
            found.extend(properties.keys().cloned());
        }
        match value {
            serde_json::Value::Object(all) => all.values().for_each(|value| walk(value, found)),
            serde_json::Value::Array(all) => all.iter().for_each(|value| walk(value, found)),
            _ => {}
        }
    }
    let mut found = BTreeSet::new();
    walk(&serde_json::from_str(schema).unwrap(), &mut found);
    found
}
