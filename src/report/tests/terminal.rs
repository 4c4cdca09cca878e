//! Terminal: verdict and tables of the same sections as in the files.

use super::demo::Documents;
use super::page::with_text;
use super::{demo_iso9283, demo_streams};
use crate::*;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::{ActionKind, Conformity, Iso9283Pose, Language};

fn terminal(documents: &Documents) -> String {
    Renderer::campaign(&documents.results()).unwrap().terminal()
}

/// Documents with an identification, poses, loads and a recorded motion.
fn everything() -> Documents {
    let mut documents = Documents::demo();
    documents.tested = demo_iso9283::whole();
    documents.tested.streams = Some(demo_streams::streams());
    documents
}

#[test]
fn a_campaign_shows_its_verdict_and_every_kind_of_result_in_aligned_columns() {
    let shown = terminal(&everything());
    let parts = [
        "(limit within the uncertainty): largest pose accuracy AP. Decision rule: guarded acceptance (ILAC-G8:09/2019, 4.2.3).\n",
        "\n\nNext steps\n1. ",
        "\n\nTo complete before signing: ",
        "\nLimits\n",
        "\nErrors before and after\nvalidation: ",
        "\nFurther errors\ncalibration: ",
        "\nAccuracy\nPositioning accuracy\n",
        "\nRepeatability\nUncertainty of RP\n",
        "\nDrift\n",
        "\nRecorded motion\nsquare\n",
        "\nStatic compliance\n",
    ];
    parts.iter().for_each(|part| assert!(shown.contains(part), "{part}: {shown}"));
    let table: Vec<&str> = shown.split("\nLimits\n").nth(1).unwrap().lines().take(5).collect();
    let judged = |row: &&str| ["verdict", "pass", "UNDECIDED"].iter().find_map(|word| row.rfind(word));
    let verdicts = table.iter().map(judged);
    assert!(verdicts.clone().all(|at| at.is_some() && at == verdicts.clone().next().unwrap()), "{table:?}");
    // contents reserved for files
    for part in ["Provenance", "Warnings and remarks", "definition", "Frames and features", "SHA-256"] {
        assert!(!shown.contains(part), "{part}: {shown}");
    }
}

/// Without limits nothing decides: the page says so first, and asks for them before a file is
/// loaded.
#[test]
fn missing_limits_come_first() {
    let mut documents = Documents::demo();
    documents.accuracy.limits.clear();
    // readings that decide a parameter would be settled first
    documents.parameters.robust = None;
    let shown = terminal(&documents);
    let at = |part: &str| shown.find(part).unwrap_or_else(|| panic!("{part}: {shown}"));
    let no_limits = tr!(Words::default(), "the-campaign-states-no-limits");
    assert!(at(&no_limits) < at("Largest "), "{shown}");
    let step = |documents: &Documents, number: usize| documents.results().verdict.actions[number - 1].action;
    assert_eq!(step(&documents, 1), ActionKind::StateLimits);
    // an implausible result fails without limits, and its cause is the first step
    let mut cause = documents.parameters.messages[0].clone();
    (cause.severity, cause.rank) = (etalon_base::message::Severity::Error, etalon_base::message::Rank::Decide);
    cause.id = "tolerance-exceeded".into();
    documents.parameters.messages.push(cause);
    assert!(!self::terminal(&documents).contains(&no_limits), "{shown}");
    assert_eq!(step(&documents, 2), ActionKind::StateLimits);
}

#[test]
fn the_exit_code_follows_the_printed_verdict() {
    let mut documents = everything();
    let conform = |p: &mut Iso9283Pose| p.ap_conformity = p.rp_conformity;
    documents.tested.poses.as_mut().unwrap().poses.iter_mut().for_each(conform);
    let mut judge = |conformity| {
        let limit = &mut documents.tested.poses.as_mut().unwrap().limits[0];
        *limit = limit.clone().with(conformity);
        Renderer::campaign(&documents.results()).unwrap()
    };
    assert!(judge(Conformity::Conforming).passes());
    let renderer = judge(Conformity::NotConforming);
    assert!(!renderer.passes() && renderer.terminal().contains("FAIL"));
    // in a test without a campaign every pose must conform
    let mut alone = demo_iso9283::whole();
    let says =
        |alone: &Characteristics, said: &Phrase| Renderer::test(alone).terminal().contains(&Words::default().tr(said));
    assert!(!Renderer::test(&alone).passes());
    assert!(says(&alone, &phrase!("poses-undecided", count = 2, poses = "1, 2")));
    let poses = alone.poses.as_mut().unwrap();
    poses.poses.iter_mut().for_each(conform);
    poses.limits[0] = poses.limits[0].clone().with(Conformity::Conforming);
    assert!(Renderer::test(&alone).passes() && says(&alone, &phrase!("all-poses-conform", count = 2)));
}

#[test]
fn a_report_speaks_its_language_on_the_terminal() {
    let mut documents = everything();
    documents.campaign.report.language = Language::De;
    assert!(terminal(&documents).contains("\nGrenzwerte\n"), "{}", terminal(&documents));
}

#[test]
fn no_name_moves_the_cursor() {
    let shown = terminal(&with_text("a\u{1b}[2J\u{2068}\r\u{7}"));
    assert!(shown.contains("a\u{fffd}[2J") && !shown.contains(|c: char| c.is_control() && c != '\n'));
    assert!(!shown.contains('\u{2068}'));
}

/// Long texts are wrapped between words, so that their table fits a terminal of 100 columns.
#[test]
fn tables_of_long_texts_fit_a_terminal() {
    let long = "elements agree ".repeat(14);
    let requirement = |text: &str| {
        let phrase = etalon_base::phrase!("own-hint", text);
        serde_json::json!({"id": "", "requirement": text, "requirement_phrase": phrase, "pass": true, "checks": []})
    };
    let document = serde_json::json!({
        "schema": "etalon/selftest/1", "pass": true, "reference": [], "reference_folder": false,
        "program": {"version": "", "sha256": null, "expected_sha256": null, "pass": true},
        "machine": {"system": "", "architecture": "", "threads": 2},
        "requirements": [requirement(long.trim_end()), requirement("short")], "must_fail": [], "packages": [],
        "provenance": {"version": "", "inputs": {}},
    });
    let document = serde_json::from_value(document).unwrap();
    let shown = Renderer::selftest(&document, Presentation::default()).unwrap().terminal();
    let rows: Vec<&str> = shown.lines().skip_while(|line| !line.starts_with("requirement ")).collect();
    assert!(rows.len() > 3 && rows.iter().all(|row| row.chars().count() <= 100), "{shown}");
    assert_eq!(rows.iter().flat_map(|row| row.matches("agree")).count(), 14, "{shown}");
    // numbers and verdict are on the first line of a row
    let judged: Vec<&&str> = rows.iter().filter(|row| row.ends_with("  pass")).collect();
    assert!(judged.len() == 2 && judged[0] == &rows[1] && judged[1].starts_with("short "), "{shown}");
}
