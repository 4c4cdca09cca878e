//! Page one: next steps that are true, and the fields to complete.

use super::demo::{Documents, point};
use super::demo_iso9283;
use crate::campaign::contents;
use crate::*;
use etalon_documents::{
    Action, ActionKind, DecisionRule, LimitQuantity, LimitVerdict, PoseSet, RobustPose, RobustSummary, WrittenFile,
};

fn kinds(actions: &[Action]) -> Vec<ActionKind> {
    actions.iter().map(|a| a.action).collect()
}

fn actions(documents: &Documents) -> Vec<Action> {
    documents.results().verdict.actions
}

fn file(format: &str, file: &str) -> WrittenFile {
    WrittenFile { format: format.to_owned(), file: file.to_owned(), is_for_controllers: false, sha256: None }
}

/// Measured data with one controller file, all limits met.
fn measured() -> Documents {
    let mut documents = Documents::demo();
    documents.campaign.measurements.synthetic = None;
    documents.campaign.controller_files = vec![file("json", "controller.json"), file("csv", "controller.csv")];
    documents.parameters.messages.clear();
    documents.import.messages.clear();
    documents
}

#[test]
fn a_file_is_to_be_loaded_only_if_the_verdict_allows_it() {
    let mut documents = measured();
    let first = &actions(&documents)[0];
    assert_eq!((first.action, first.file.as_deref()), (ActionKind::Load, Some("controller.json")));
    let set = documents.accuracy.sets.last().unwrap();
    let e = set.leading().unwrap();
    assert!((first.gain_mm.unwrap() - (e.before.rms - e.after.rms)).abs() < 1e-12);
    // the way back follows at once
    assert_eq!(actions(&documents)[1].action, ActionKind::Verify);
    // no controller loads a JSON file
    assert!(first.what.phrase().unwrap().id == "action-load-or-compensate", "{first:?}");
    let load = first.reason.phrase().cloned().unwrap();
    let unit = |key: &str| match &load.arguments[key] {
        etalon_base::catalogue::Argument::Text(text) => text.split(' ').next_back().unwrap().to_owned(),
        other => panic!("{other:?}"),
    };
    assert_eq!(unit("expected"), unit("nominal"), "{load:?}");
    let of_controller = WrittenFile { is_for_controllers: true, ..file("twincat", "etalon.st") };
    documents.campaign.controller_files.push(of_controller);
    let first = &actions(&documents)[0];
    assert_eq!(first.file.as_deref(), Some("etalon.st"));
    assert!(first.what.phrase().unwrap().id == "action-load", "{first:?}");
    documents.campaign.measurements.synthetic = Some("simulated".to_owned());
    let synthetic = &actions(&documents)[0];
    assert!(synthetic.what.english().contains("not into a robot"), "{synthetic:?}");
    let failed = LimitVerdict::judge(LimitQuantity::PositionMaxMm, 0.01, 0.0442, Some(0.001), DecisionRule::Guarded);
    documents.accuracy.limits[0] = failed;
    let all = actions(&documents);
    assert!(kinds(&all).contains(&ActionKind::MeetLimit) && !kinds(&all).contains(&ActionKind::Load), "{all:?}");
    let worst = documents.errors.iter().filter(|e| e.set == PoseSet::Validation && e.quantity == Default::default());
    let size = |e: &&etalon_documents::PointError| etalon_base::pose::norm(e.after_mm);
    let worst = worst.max_by(|a, b| size(a).total_cmp(&size(b))).map(|e| e.pose);
    let meet = all.iter().find(|a| a.action == ActionKind::MeetLimit).unwrap();
    if let Some(worst) = worst {
        assert!(meet.what.english().contains(&format!("pose {worst}")), "{meet:?}");
    }
    // in words, not as a key
    let what = meet.what.phrase().unwrap();
    let limit = etalon_base::phrase!("limit-position-max");
    assert_eq!(what.arguments["limit"], etalon_base::catalogue::Argument::Phrase(limit));
    assert!(!meet.what.english().contains("position_max"), "{meet:?}");
    let reason = meet.reason.phrase().unwrap();
    assert_eq!(reason.id, "action-meet-limit-reason");
    assert_eq!(reason.arguments["beyond"], etalon_base::catalogue::Argument::Text("34.2 µm".to_owned()));
}

#[test]
fn a_file_that_is_no_better_than_nominal_is_not_to_be_loaded() {
    let mut documents = measured();
    for set in &mut documents.accuracy.sets {
        set.errors.iter_mut().for_each(|e| e.after.rms = 0.99 * e.before.rms);
    }
    let all = kinds(&actions(&documents));
    assert!(!all.contains(&ActionKind::Load) && all.contains(&ActionKind::KeepNominal), "{all:?}");
}

#[test]
fn an_undecided_limit_states_the_uncertainty_that_would_decide() {
    let mut documents = measured();
    // 0.045 ± 0.010 against 0.05: 5 µm would decide
    let open = LimitVerdict::judge(LimitQuantity::PositionMaxMm, 0.05, 0.045, Some(0.01), DecisionRule::Guarded);
    documents.accuracy.limits[0] = open;
    let all = actions(&documents);
    let reduce = all.iter().find(|a| a.action == ActionKind::ReduceUncertainty).unwrap();
    assert!(reduce.reason.english().starts_with("U = 10.0 µm; a decision needs 5.00 µm"), "{reduce:?}");
    assert!(!kinds(&all).contains(&ActionKind::Load), "exit code 1");
}

#[test]
fn outlying_poses_are_measured_again_the_worst_first_and_steps_follow_their_gain() {
    let mut documents = measured();
    documents.errors = (0..40).map(|i| point(i, [10.0 * i as f64, 0.0, 0.0], [0.9; 3], [0.01, 0.0, 0.0])).collect();
    documents.errors.iter_mut().for_each(|e| e.set = PoseSet::Calibration);
    documents.errors[7].after_mm = [0.441, 0.0, 0.0];
    let pose = |pose: i64, residual_over_sigma| RobustPose { pose: pose.into(), weight: 0.01, residual_over_sigma };
    documents.parameters.robust = Some(RobustSummary {
        constant: 2.385,
        sigma_mm: 0.0711,
        parameters: Vec::new(),
        critical: 3.0,
        poses: vec![pose(9, 4.4), pose(7, 6.2), pose(5, 2.0)],
        critical_residual: 4.0,
        disagreeing: 2,
    });
    let all = actions(&documents);
    let again = all.iter().find(|a| a.action == ActionKind::MeasureAgain).unwrap();
    // 6.2 × 0.0711 mm
    assert_eq!(
        (again.what.english(), again.reason.english()),
        ("measure poses 7, 9 again", "pose 7 disagrees with the others: 0.441 mm, 6.2 σ")
    );
    // the way back follows the file that is loaded
    let others = all.iter().filter(|a| a.action != ActionKind::Verify);
    let gains: Vec<f64> = others.map(|a| a.gain_mm.unwrap_or(0.0)).collect();
    assert!(gains.is_sorted_by(|a, b| a >= b) && all.len() <= 5, "{gains:?}");
    // √(0.441² + 39 × 0.01²)/√40 less 0.01
    assert!((again.gain_mm.unwrap() - 0.0604).abs() < 0.0003, "{again:?}");
}

#[test]
fn preconditions_of_a_test_are_steps_in_every_rendering() {
    let mut documents = measured();
    documents.tested = demo_iso9283::whole();
    documents.campaign.conditions.warm_up_minutes = Some(0.0);
    let all = actions(&documents);
    assert_eq!(kinds(&all).iter().filter(|k| **k == ActionKind::WarmUp).count(), 1, "{all:?}");
    let renderer = Renderer::campaign(&documents.results()).unwrap();
    let page = String::from_utf8(renderer.file("html").unwrap()).unwrap();
    let terminal = renderer.terminal();
    let text = "Warm the robot up before the test, and set";
    assert!(page.contains(text) && terminal.contains(text), "{terminal}");
    assert!(terminal.contains("To complete before signing: ") && page.contains("To complete before signing: "));
    let json = serde_json::to_string(&documents.results().verdict).unwrap();
    assert!(json.contains("action-warm-up"), "{json}");
}

#[test]
fn a_report_is_a_draft_until_every_field_is_stated_and_says_so_on_every_page() {
    let documents = measured();
    let page = String::from_utf8(Renderer::campaign(&documents.results()).unwrap().file("html").unwrap()).unwrap();
    assert!(page.contains("data-draft=\"DRAFT\""));
    let mut synthetic = measured();
    synthetic.campaign.measurements.synthetic = Some("simulated".to_owned());
    let page = String::from_utf8(Renderer::campaign(&synthetic.results()).unwrap().file("html").unwrap()).unwrap();
    assert!(page.contains("data-draft=\"SYNTHETIC DATA\""));
}

#[test]
fn the_evidence_comes_before_the_annexes_and_details_are_folded() {
    let documents = Documents::demo();
    let words = Words::default();
    let contents = contents(&documents.results(), &words);
    let order: Vec<(&str, bool)> = contents.sections.iter().map(|s| (s.id.as_str(), s.annex)).collect();
    assert!(order.is_sorted_by_key(|(_, annex)| *annex), "{order:?}");
    for (id, annex) in [("limits", false), ("errors", false), ("budget", false), ("parameters", true), ("fit", true)] {
        assert!(order.contains(&(id, annex)), "{id}: {order:?}");
    }
}
