//! `etalon compare`

use super::reports::tool;
use super::{etalon, text};
use crate::support::said::Says;
use crate::support::scratch::{copy_sample, stamp};
use calamine::{Reader, Xlsx};
use etalon::documents::{CompareDocument, CompareFamily};
use std::path::Path;
use std::process::Output;

/// Two runs of the synthetic CMM sample: a robot, and the same with `s` changed by 20 µm and measured anew.
fn two(folder: &Path) {
    for (name, seed, s) in [("spring", None, None), ("autumn", Some("seed = 2026"), Some("s = 393.95"))] {
        let scratch = copy_sample("prexyt-cmm");
        let date = if s.is_some() { "2026-10-01" } else { "2026-04-01" };
        scratch.replace("campaign.toml", "robot = ", &format!("date = \"{date}\"\nrobot = "));
        if let (Some(seed), Some(s)) = (seed, s) {
            let truth = std::fs::read_to_string(scratch.path().join("truth.toml")).unwrap();
            let line = |start: &str| truth.lines().find(|l| l.starts_with(start)).unwrap().to_owned();
            scratch.replace("truth.toml", &line("seed"), seed);
            scratch.replace("truth.toml", &line("s "), s);
            assert!(etalon(scratch.root(), &["simulate", "campaign"]).status.success());
        }
        assert!(etalon(scratch.root(), &["run", "campaign"]).status.success());
        std::fs::rename(scratch.path(), folder.join(name)).unwrap();
    }
}

fn refused(output: &Output, parts: &[&str]) {
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    parts.iter().for_each(|part| assert!(said.contains(part), "no {part:?} in {said}"));
}

#[test]
fn a_parameter_that_changed_is_found_and_what_cannot_be_compared_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    two(at);
    let done = etalon(at, &["compare", "spring", "autumn/out", "--json", "--report", "compare.html"]);
    assert!(done.status.success(), "{}", text(&done.stderr));
    let document: CompareDocument = serde_json::from_slice(&done.stdout).unwrap();
    let changed: Vec<&str> = document
        .trends
        .iter()
        .filter(|t| t.family == CompareFamily::Robot && t.changes[0].significant == Some(true))
        .map(|t| t.name.english())
        .collect();
    assert_eq!(changed, ["s"]);
    let s = document.trends.iter().find(|t| t.name.english() == "s").unwrap();
    let change = s.changes[0];
    assert!(change.low.unwrap() < 0.0195 && change.high.unwrap() > 0.0195, "{change:?}");
    assert!(document.together[0].significant);
    assert_eq!(document.campaigns[0].date.as_deref(), Some("2026-04-01"));
    let html = std::fs::read_to_string(at.join("compare.html")).unwrap();
    assert!(html.contains("Parameter s") && html.contains("2026-10-01") && html.contains("<svg"));
    assert!(!html.contains("http://") && !html.contains("https://"));
    assert_eq!(html.matches("<script").count(), 1);
    let other = ["compare.pdf", "compare.xlsx", "vergleich.html"].map(|file| ["--report", file]).concat();
    let german = [&["compare", "spring", "autumn", "--language", "de"][..], &other].concat();
    assert!(etalon(at, &german).status.success());
    let page = std::fs::read_to_string(at.join("vergleich.html")).unwrap();
    assert!(page.contains("<html lang=\"de\">") && page.contains("Parameter des Roboters"));
    assert!(std::fs::read(at.join("compare.pdf")).unwrap().starts_with(b"%PDF-1.7"));
    if let Some(attached) = tool("qpdf", &["--show-attachment=compare.json", "{}"], &at.join("compare.pdf")) {
        assert_eq!(serde_json::from_str::<CompareDocument>(&attached).unwrap().trends, document.trends);
    }
    let mut book: Xlsx<_> = calamine::open_workbook(at.join("compare.xlsx")).unwrap();
    let changes = book.worksheet_range("Änderungen").unwrap();
    assert_eq!(changes.rows().count(), 1 + document.trends.iter().map(|t| t.changes.len()).sum::<usize>());
    refused(&etalon(at, &["compare", "spring", "autumn", "--report", "a.txt"]), &["`a.txt`", "ends in .html"]);
    let shown = text(&etalon(at, &["compare", "spring/campaign.toml", "autumn"]).stdout);
    assert!(shown.has_phrase("parameters-of-robot") && shown.contains("  CHANGED"), "{shown}");
    // as order, so sign
    let back = etalon(at, &["compare", "autumn", "spring", "--json"]);
    assert!(text(&back.stderr).contains("warning[campaigns-out-of-order]"), "{}", text(&back.stderr));
    let back: CompareDocument = serde_json::from_slice(&back.stdout).unwrap();
    let back = back.trends.iter().find(|t| t.name.english() == "s").unwrap().changes[0];
    assert!((back.change + change.change).abs() < 1e-12 && (back.p.unwrap() - change.p.unwrap()).abs() < 1e-12);

    refused(&etalon(at, &["compare", "spring", "spring"]), &["[campaign-twice]", "`spring`"]);
    refused(&etalon(at, &["compare", "spring", "./spring/out/"]), &["[campaign-twice]", "`./spring/out/`"]);
    refused(&etalon(at, &["compare", "spring", "nowhere"]), &["[not-an-output-folder]", "nowhere", "hint: "]);
    let edit = |file: &str, from: &str, to: &str| {
        let path = at.join("autumn/out").join(file);
        let whole = std::fs::read_to_string(&path).unwrap();
        assert!(whole.contains(from), "{file} has no {from}");
        std::fs::write(&path, whole.replacen(from, to, 1)).unwrap();
        stamp(&at.join("autumn/out"));
        let output = etalon(at, &["compare", "spring", "autumn"]);
        std::fs::write(&path, whole).unwrap();
        stamp(&at.join("autumn/out"));
        output
    };
    refused(
        &edit("parameters.json", "etalon/parameters/2", "etalon/parameters/1"),
        &["error[document-schema-other]", "`etalon/parameters/1`", "expected: "],
    );
    refused(&edit("parameters.json", "\"prexyt\"", "\"serial\""), &["error[models-differ]"]);
    refused(
        &edit("parameters.json", "\"name\": \"s\"", "\"name\": \"stretch\""),
        &["different parameters: s, stretch"],
    );
    refused(&edit("parameters.json", "{", "["), &["parameters.json", "run the campaign again"]);
    let named = |name: &str| edit("campaign.json", "\"robot\": \"PreXYT\"", &format!("\"robot\": \"{name}\""));
    refused(&named("PreXYT 2"), &["[robots-differ]", "PreXYT 2"]);
    std::fs::remove_file(at.join("autumn/out/accuracy.json")).unwrap();
    refused(&etalon(at, &["compare", "spring", "autumn"]), &["accuracy.json"]);
}

#[test]
fn hostile_names_stay_text() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    two(at);
    let hostile = "</td><script>alert(1)</script>\u{202e}\\u001b[31m";
    for name in ["spring", "autumn"] {
        let path = at.join(name).join("out/campaign.json");
        let whole = std::fs::read_to_string(&path).unwrap();
        let mut value: serde_json::Value = serde_json::from_str(&whole).unwrap();
        for key in ["name", "date", "instrument", "robot", "synthetic"] {
            value[key] = serde_json::Value::String(format!("{hostile}\u{1b}[2J\n{key}"));
        }
        std::fs::write(&path, value.to_string()).unwrap();
        stamp(&at.join(name).join("out"));
    }
    let kinds = ["--report", "compare.html", "--report", "compare.pdf", "--report", "compare.xlsx"];
    let output = etalon(at, &[&["compare", "spring", "autumn"][..], &kinds].concat());
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(!text(&output.stdout).contains('\u{1b}'));
    let html = std::fs::read_to_string(at.join("compare.html")).unwrap();
    assert!(html.matches("<script").count() == 1 && !html.contains('\u{1b}'), "a name became markup");
}

#[test]
fn tests_of_repeatability_are_compared_by_pose() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    for name in ["first", "second"] {
        let scratch = copy_sample("prexyt-repeatability");
        assert!(etalon(scratch.root(), &["run", "campaign"]).status.success());
        std::fs::rename(scratch.path(), at.join(name)).unwrap();
    }
    let done = etalon(at, &["compare", "first", "second", "--json"]);
    assert!(done.status.success(), "{}", text(&done.stderr));
    let document: CompareDocument = serde_json::from_slice(&done.stdout).unwrap();
    let count = |family| document.trends.iter().filter(|t| t.family == family).count();
    // AT and RT of the recorded path
    assert_eq!((count(CompareFamily::PathAccuracy), count(CompareFamily::PathRepeatability)), (1, 1));
    // five poses and homings; three coordinates of five poses
    assert_eq!((count(CompareFamily::PoseRepeatability), count(CompareFamily::MeanPosition)), (6, 15));
    assert!(document.trends.iter().flat_map(|t| &t.changes).all(|c| c.change == 0.0 && c.significant == Some(false)));
    assert!(document.robot.is_none());
}
