//! Documents as they are committed. `ETALON_UPDATE=1 make test` writes them again.

mod keys;
mod motion;
mod pose_test;

use crate::support::root;
use crate::support::scratch::copy_sample;
use etalon::base::catalogue::{Entry, entries};
use etalon::documents::{Explanation, ExplanationDocument};
use std::collections::BTreeSet;

fn compare(path: &str, text: &str) {
    let path = root().join(path);
    if std::env::var_os("ETALON_UPDATE").is_some() {
        std::fs::write(&path, text).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(committed == text, "{} is not current: run with ETALON_UPDATE=1 and look at what changed", path.display());
}

#[test]
fn every_committed_schema_has_a_name() {
    let program = std::process::Command::new(crate::support::program()).args(["schema", "--help"]).output().unwrap();
    let help = String::from_utf8(program.stdout).unwrap();
    let all = [etalon::campaign::SCHEMAS, etalon::simulate::SCHEMAS, etalon::documents::schema::SCHEMAS].concat();
    for (name, _) in &all {
        assert!(help.split([' ', ',', '\n']).any(|word| word == *name), "`{name}` is not in `etalon schema --help`");
    }
    let stated: BTreeSet<String> = all.iter().map(|(name, _)| format!("{name}.schema.json")).collect();
    let files = std::fs::read_dir(root().join("schemas")).unwrap();
    assert_eq!(files.map(|file| file.unwrap().file_name().into_string().unwrap()).collect::<BTreeSet<_>>(), stated);
}

/// Messages that first campaigns often cause, in the order of the work.
const FREQUENT: [&str; 20] = [
    "key-open",
    "key-missing",
    "unknown-key",
    "input-missing",
    "column-unknown",
    "header-is-data",
    "unit-differs",
    "labels-unused",
    "keys-unmatched",
    "nominal-robot-far",
    "placement-unexplained",
    "set-up-contradicted",
    "tolerance-exceeded",
    "residuals-exceed-uncertainty",
    "outliers",
    "reference-moved",
    "effect-would-prove",
    "parameters-fixed-by-frames",
    "parameter-groups-weakly-identifiable",
    "uncertainty-beyond-bound",
];

/// Parts of the page of messages: the crate that reports them, and the title.
const PARTS: [(&str, &str); 17] = [
    ("base", "Files and values"),
    ("campaign", "campaign.toml and robot.toml"),
    ("cli", "Commands and options"),
    ("compare", "Comparison of campaigns"),
    ("controllers", "Controller files"),
    ("documents", "Documents"),
    ("exports", "Exports"),
    ("fit", "Elements"),
    ("formats", "Tables, logs and recordings"),
    ("identify", "Identification"),
    ("reporting", "Reports"),
    ("run", "Runs and output folders"),
    ("selftest", "Self-test"),
    ("simulate", "Simulation"),
    ("stages", "From points to results"),
    ("standards", "ISO 9283 and ISO 230-2"),
    ("view", "The page of etalon view"),
];

#[test]
fn the_page_of_messages_is_current() {
    let explained: Vec<_> = entries().into_iter().filter(Entry::is_message).collect();
    let mut page =
        "# Messages\n\nGenerated from the catalogue (`src/base/messages`). `etalon explain ID` prints the same.\n"
            .to_owned();
    page += "\n## Often in a first campaign\n\n";
    for id in FREQUENT {
        let entry = explained.iter().find(|entry| entry.id == id).unwrap_or_else(|| panic!("no message `{id}`"));
        page += &format!("- [`{id}`](#{id}): {}\n", entry.meaning);
    }
    let mut part = "";
    for (entry, message) in explained.iter().zip(ExplanationDocument::new(&explained).messages) {
        if entry.file != part {
            part = entry.file;
            let title = PARTS.iter().find(|(file, _)| *file == part).map(|(_, title)| *title);
            page += &format!("\n## {}\n", title.unwrap_or_else(|| panic!("no title for `{part}`")));
        }
        let Explanation { id, text, expected, hint, meaning, reason, action, example } = message;
        page += &format!("\n### {id}\n\n> {text}\n");
        page.extend(expected.map(|text| format!(">\n> expected: {text}\n")));
        page.extend(hint.map(|text| format!(">\n> hint: {text}\n")));
        page += &format!("\n{meaning} {reason}\n\n- Typical case: {example}\n- What to do: {action}\n");
    }
    compare("docs/messages.md", &escaped(&page));
}

#[test]
fn the_page_of_options_is_current() {
    let mut page = "# Options of all commands\n\nGenerated from the help of the program. `etalon COMMAND --help` prints the same; \
                    [Commands](commands.md) explains the commands by task.\n"
        .to_owned();
    add_help(&[], &mut page);
    assert!(page.matches("\n## ").count() > 30, "{page}");
    compare("docs/options.md", &page);
}

/// The docstrings have the arguments of each function.
#[test]
fn the_page_of_python_functions_is_current() {
    let mut python = std::process::Command::new("python3");
    let ended = python.arg(root().join("python/generate_reference.py")).arg("-").output();
    let Ok(ended) = ended else { return crate::support::skipped("python3") };
    assert!(ended.status.success(), "{}", String::from_utf8_lossy(&ended.stderr));
    compare("docs/functions.md", &String::from_utf8(ended.stdout).unwrap());
}

/// Help of a command, then of its subcommands, in Markdown.
fn add_help(names: &[&str], page: &mut String) {
    let mut program = std::process::Command::new(crate::support::program());
    let ended = program.args(names).arg("--help").env_remove("COLUMNS").output().unwrap();
    let help = String::from_utf8(ended.stdout).unwrap();
    let help: String = help.lines().map(|line| line.trim_end().to_owned() + "\n").collect();
    *page += &format!("\n## {}\n\n```text\n{help}```\n", [&["etalon"][..], names].concat().join(" "));
    // the program lists its commands by task, before its options
    let list = match names {
        [] => help.split("\nOptions:").next(),
        _ => help.split("\nCommands:\n").nth(1).and_then(|rest| rest.split("\n\n").next()),
    };
    let rows = list.unwrap_or_default().lines().filter_map(|line| line.strip_prefix("  "));
    let commands = rows.filter(|row| row.starts_with(|c: char| c.is_ascii_lowercase()));
    for name in commands.filter_map(|row| row.split(' ').next()).filter(|name| *name != "help") {
        add_help(&[names, &[name]].concat(), page);
    }
}

/// Markdown in which `<` outside of code is text and begins no HTML element.
fn escaped(markdown: &str) -> String {
    let line = |line: &str| {
        let parts = line.split('`').enumerate();
        let parts = parts.map(|(i, part)| if i % 2 == 0 { part.replace('<', "\\<") } else { part.to_owned() });
        parts.collect::<Vec<_>>().join("`")
    };
    markdown.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// Documents that hold no computed number: the same bytes on every machine.
#[test]
fn documents_of_the_cmm_sample() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("exports/poses.txt", "K_1_1 ", "K_1_1_x ");
    let row = std::fs::read_to_string(scratch.path().join("exports/poses.txt")).unwrap();
    let second = row.lines().nth(1).unwrap().to_owned();
    scratch.replace("exports/poses.txt", &second, "L_1_1 0.0 0.0 0.0");
    let program = std::process::Command::new(crate::support::program())
        .args(["run", "campaign"])
        .current_dir(scratch.root())
        .output()
        .unwrap();
    assert!(program.status.success(), "{}", String::from_utf8_lossy(&program.stderr));
    for name in ["campaign.json", "import.json"] {
        let text = std::fs::read_to_string(scratch.path().join("out").join(name)).unwrap();
        compare(&format!("tests/golden/{name}"), &without_file_hashes(name, text));
    }
}

/// campaign.json without the checksums of controller files, which change with every digit of a parameter.
fn without_file_hashes(name: &str, text: String) -> String {
    if name != "campaign.json" {
        return text;
    }
    let document: serde_json::Value = serde_json::from_str(&text).unwrap();
    let files = document["controller_files"].as_array().unwrap();
    assert!(files.iter().all(|file| file["sha256"].as_str().is_some_and(|hash| hash.len() == 64)), "{text}");
    let hashes: Vec<String> = files.iter().map(|file| file["sha256"].as_str().unwrap().to_owned()).collect();
    hashes.iter().fold(text, |text, hash| text.replace(hash.as_str(), "SHA-256"))
}
