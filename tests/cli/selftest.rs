//! `etalon selftest`: it passes here, notices slips, and compares a frozen campaign digit by digit.

use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::documents::{Language, Presentation, SelftestDocument};
use etalon::report::Renderer;
use etalon::run::selftest::performance::performance;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::LazyLock;

fn run(scratch: &Scratch, arguments: &[&str]) -> Output {
    let program = crate::support::program();
    Command::new(program).arg("selftest").args(arguments).current_dir(scratch.root()).output().unwrap()
}

fn document(output: &Output) -> SelftestDocument {
    let text = String::from_utf8_lossy(&output.stdout);
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{e}: {text} {}", String::from_utf8_lossy(&output.stderr)))
}

/// One run for several tests.
static PASSED: LazyLock<(Option<i32>, SelftestDocument)> = LazyLock::new(|| {
    let output = run(&Scratch::with(&[]), &["--json"]);
    (output.status.code(), document(&output))
});

#[test]
fn this_installation_passes_and_says_what_was_compared() {
    let (code, document) = &*PASSED;
    let failed: Vec<_> = document.requirements.iter().flat_map(|r| &r.checks).filter(|c| !c.pass).collect();
    assert!(failed.is_empty(), "{failed:#?}");
    assert!(*code == Some(0) && document.pass);
    let ids: Vec<&str> = document.requirements.iter().map(|r| r.id.as_str()).collect();
    let all = [
        "fits",
        "solver",
        "frames",
        "kinematics",
        "identification",
        "uncertainty",
        "standards",
        "coverage",
        "formats",
        "exports",
        "threads",
    ];
    assert!(all.iter().all(|id| ids.contains(id)), "{ids:?}");
    let checks: usize = document.requirements.iter().map(|r| r.checks.len()).sum();
    assert!(checks > 150, "{checks}");
    let program = Path::new(crate::support::program());
    assert_eq!(document.program.sha256, etalon::base::files::sha256_of_file(program).ok());
    let polars = document.packages.iter().find(|p| p.name == "polars").unwrap();
    assert!(polars.sha256.as_ref().is_some_and(|hash| hash.len() == 64));
    assert!(document.reference.iter().all(|file| file.pass) && document.reference.len() > 8);
}

#[test]
fn a_wrong_digit_a_swapped_pair_and_a_wrong_unit_each_fail_a_comparison() {
    let (_, document) = &*PASSED;
    for id in ["fits", "solver", "frames", "kinematics", "identification", "uncertainty", "standards", "formats"] {
        let of = |kind: &str| {
            document
                .must_fail
                .iter()
                .filter(|m| m.id == id && m.slip.phrase().is_some_and(|slip| slip.id == kind))
                .count()
        };
        let kinds = ["selftest-wrong-digit", "selftest-swapped", "selftest-wrong-unit"];
        assert!(kinds.iter().all(|kind| of(kind) > 0), "{id}");
    }
    let missed: Vec<_> = document.must_fail.iter().filter(|m| !m.pass).collect();
    assert!(missed.is_empty(), "{missed:#?}");
    // a slip fails what it concerns, not everything
    assert!(document.must_fail.iter().any(|m| m.failed < m.checks));
}

/// A copy of the program with one digit of its reference data changed, the hash of another program, and a frozen campaign with a digit
/// of its own changed.
#[test]
fn a_changed_program_and_a_changed_result_are_each_named() {
    let scratch = copy_sample("prexyt-cmm");
    let ran = Command::new(crate::support::program()).args(["run", "campaign"]).current_dir(scratch.root()).output();
    assert!(ran.unwrap().status.success());
    let stored = std::fs::read_to_string(scratch.path().join("out/parameters.json")).unwrap();
    let frozen = scratch.root().join("frozen.json");
    std::fs::write(&frozen, &stored).unwrap();
    let same = performance(&scratch.path(), &frozen).unwrap();
    assert!(same.pass && same.moved.is_empty() && same.causes.is_empty() && same.compared == 14, "{same:?}");
    std::fs::write(&frozen, moved(&stored)).unwrap();
    let program = changed_program(&scratch);
    let own = PASSED.1.program.sha256.clone().unwrap();
    let output = Command::new(&program)
        .args(["selftest", "--json", "--program-sha256", &own, "--campaign", "campaign", "--expected", "frozen.json"])
        .args(["--report", "protocol.html", "--report", "protocol.xlsx", "--language", "fr"])
        .current_dir(scratch.root())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
    let found = document(&output);
    let changed: Vec<&str> = found.reference.iter().filter(|file| !file.pass).map(|file| file.name.as_str()).collect();
    assert!(!found.pass && !found.program.pass && changed == ["published.json"], "{changed:?}");
    assert!(found.program.sha256.is_some_and(|hash| hash != own));
    let found = found.performance.unwrap();
    let [one] = &found.moved[..] else { panic!("{:?}", found.moved) };
    assert!(one.parameter == "s" && one.quantity == "value" && one.over_uncertainty.unwrap() > 1e-6, "{one:?}");
    assert!((one.before.unwrap() - one.after.unwrap()).abs() < 1e-3);
    let causes: Vec<&str> = found.causes.iter().filter_map(|cause| Some(&*cause.phrase()?.id)).collect();
    assert_eq!(causes, ["selftest-other-version", "selftest-other-input"]);
    let page = std::fs::read_to_string(scratch.root().join("protocol.html")).unwrap();
    assert!(page.contains(&own) && page.contains("SHA-256 déclaré") && page.contains("class=\"box bad\""));
    assert!(scratch.root().join("protocol.xlsx").is_file());
    // nothing is written to the campaign by the comparison
    assert_eq!(std::fs::read_to_string(scratch.path().join("out/parameters.json")).unwrap(), stored);
}

/// The program file with one digit of its reference data changed.
fn changed_program(scratch: &Scratch) -> std::path::PathBuf {
    let mut bytes = std::fs::read(crate::support::program()).unwrap();
    let (text, place) = (b"\"start\": [-1.2, 1.0]", 13);
    let at: Vec<usize> = (0..bytes.len() - text.len()).filter(|&i| bytes[i..].starts_with(text)).collect();
    assert_eq!(at.len(), 1, "the number is once in the program");
    bytes[at[0] + place] = b'3';
    let program = scratch.root().join("etalon");
    std::fs::copy(crate::support::program(), &program).unwrap();
    std::fs::write(&program, bytes).unwrap();
    program
}

/// A stored result with another eighth digit of one value, of another version, and with another input.
fn moved(stored: &str) -> String {
    let value = stored.split("\"name\": \"s\"").nth(1).unwrap().split("\"value\": ").nth(1).unwrap();
    let value = value.split(',').next().unwrap();
    let digit = if value[8..].starts_with('5') { "6" } else { "5" };
    let other = format!("{}{digit}{}", &value[..8], &value[9..]);
    let input = stored.split("\"encoders.csv\": \"").nth(1).unwrap().split('"').next().unwrap();
    let changed = stored.replacen(&format!("\"value\": {value}"), &format!("\"value\": {other}"), 1);
    changed.replace(input, &"0".repeat(64)).replace("\"version\": \"0.", "\"version\": \"9.")
}

#[test]
fn a_text_that_is_no_hash_is_refused() {
    let wrong = run(&Scratch::with(&[]), &["--program-sha256", "abc"]);
    let text = String::from_utf8_lossy(&wrong.stderr).into_owned();
    assert!(wrong.status.code() == Some(2) && text.contains("64 hexadecimal digits"), "{text}");
}

#[test]
fn the_protocol_has_the_signatures_before_the_annexes_in_each_language() {
    for (language, title) in [
        (Language::En, "Validation of the installation"),
        (Language::Fr, "Validation de l’installation"),
        (Language::De, "Validierung der Installation"),
    ] {
        let presentation = Presentation { language, ..Presentation::default() };
        let renderer = Renderer::selftest(&PASSED.1, presentation).unwrap();
        let page = String::from_utf8(renderer.file("html").unwrap()).unwrap();
        let place = |part: &str| page.find(part).unwrap_or_else(|| panic!("{title}: {part}"));
        assert!(page.contains(title) && place("<section id=\"requirements\"") < place("<section id=\"signatures\""));
        assert!(place("<section id=\"signatures\"") < place("<section id=\"operation\""));
        assert!(page.contains(PASSED.1.program.sha256.as_deref().unwrap()));
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let missing = Scratch::with(&[]);
    let output = Command::new(crate::support::program())
        .arg("selftest")
        .env("TMPDIR", missing.root().join("missing"))
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(2) && text.says("[selftest-folder-not-written]"), "{text}");
}
