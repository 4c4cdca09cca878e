//! `etalon report`: the same page again, in another language, with another dress.

use super::{etalon, text};
use crate::support::program;
use crate::support::samples::{Ran, ran};
use crate::support::scratch::copy_sample;
use etalon::campaign::Campaign;
use etalon::documents::{Language, Results};
use etalon::report::Renderer;
use etalon::run::documents::Documents;
use etalon::run::{pipeline, results};
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

#[test]
fn the_report_is_made_again_as_the_campaign_dresses_it_and_as_the_command_does() {
    let scratch = copy_sample("prexyt-repeatability");
    let done = |arguments: &[&str]| {
        let output = etalon(scratch.root(), arguments);
        assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
        std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap_or_default()
    };
    done(&["report", "--write-templates", "campaign/own"]);
    let entries = std::fs::read_dir(scratch.path().join("own")).unwrap();
    let mut templates: Vec<_> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    templates.sort();
    let built_in = [
        "batch.html",
        "blocks.html",
        "head.html",
        "picture.css",
        "report.html",
        "report.typ",
        "signatures.html",
        "style.html",
    ];
    assert_eq!(templates, built_in);
    let signatures = scratch.path().join("own/signatures.html");
    std::fs::write(&signatures, "<p>Sealed: {{ \"tested-by\"|t }}</p>\n").unwrap();
    std::fs::write(scratch.path().join("logo.svg"), "<svg xmlns=\"http://www.w3.org/2000/svg\"/>").unwrap();
    scratch.replace(
        "campaign.toml",
        "[instrument]",
        "[report]\nlanguage = \"fr\"\nlogo = \"logo.svg\"\ntemplates = \"own\"\n\n[instrument]",
    );
    let page = done(&["run", "campaign"]);
    for part in ["<html lang=\"fr\">", "src=\"data:image&#x2f;svg+xml;base64,PHN2Z", "<p>Sealed: Essai réalisé par</p>"]
    {
        assert!(page.contains(part), "{part}");
    }
    assert_eq!(done(&["report", "campaign/out"]), page);
    let german = done(&["report", "campaign/out", "--language", "de"]);
    assert!(german.contains("<html lang=\"de\">") && german.contains("<p>Sealed: Geprüft von</p>"));
    // templates as they are written make the page as it is built in
    std::fs::remove_file(&signatures).unwrap();
    let dressed = done(&["report", "campaign/out", "--language", "en", "--templates", "campaign/own"]);
    assert!(dressed.contains("Approved by") && !dressed.contains("Sealed"));
    let again = etalon(scratch.root(), &["report", "--write-templates", "campaign/own"]);
    assert_eq!(again.status.code(), Some(2));
    assert!(text(&again.stderr).contains("error[file-exists]"));
}

/// SHA-256 of the files of a folder.
fn hashes(folder: &Path) -> BTreeMap<String, String> {
    let files = std::fs::read_dir(folder).unwrap().flatten().filter(|entry| entry.path().is_file());
    let hash = |path: &Path| etalon::base::files::sha256(&std::fs::read(path).unwrap());
    files.map(|entry| (entry.file_name().into_string().unwrap(), hash(&entry.path()))).collect()
}

/// The page of results in a language.
fn page(results: &Results, language: Language) -> Vec<u8> {
    let mut results = results.clone();
    results.campaign.report.language = language;
    Renderer::campaign(&results).unwrap().file("html").unwrap()
}

/// Samples whose results are computed again, and whose pages are compared in every language.
const COMPUTED_AGAIN: [&str; 3] = ["pose-test", "hexapod", "two-hands"];

#[test]
fn every_stored_folder_gives_the_verdict_and_the_report_of_its_run() {
    for Ran { name, folder } in ran() {
        // other tests look at the folder of the run
        let copy = tempfile::tempdir().unwrap();
        let out = copy.path().join("out");
        std::fs::create_dir(&out).unwrap();
        for entry in std::fs::read_dir(folder.join("out")).unwrap().flatten() {
            std::fs::copy(entry.path(), out.join(entry.file_name())).unwrap();
        }
        let written = hashes(&out);
        let output = Command::new(program()).arg("report").arg(&out).output().unwrap();
        assert!(output.status.success(), "{name}: {}", text(&output.stderr));
        assert_eq!(hashes(&out), written, "{name}");
        if COMPUTED_AGAIN.contains(&name.as_str()) {
            check_computed(name, folder, &out);
        }
    }
    assert!(ran().len() >= 18, "{} samples", ran().len());
}

fn check_computed(name: &str, campaign: &Path, out: &Path) {
    let mut computed = pipeline::evaluate(&Campaign::read(campaign).unwrap()).unwrap().results;
    let stored = results::read(&Documents::open(out).unwrap()).unwrap();
    // a run writes files with these hashes
    for (computed, stored) in computed.campaign.controller_files.iter_mut().zip(&stored.campaign.controller_files) {
        assert_eq!((&computed.file, computed.sha256.is_none()), (&stored.file, stored.sha256.is_some()), "{name}");
        computed.sha256.clone_from(&stored.sha256);
    }
    assert_eq!(stored.verdict, computed.verdict, "{name}");
    for language in [Language::En, Language::Fr, Language::De] {
        assert!(page(&stored, language) == page(&computed, language), "{name}, {language:?}");
    }
}
