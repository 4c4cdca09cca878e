//! One verdict in every output and in the exit code, by the decision rule that the campaign states.

use super::reports::tool;
use super::{etalon, text, text_of};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use calamine::{Reader, Xlsx};
use etalon::base::phrase;
use etalon::documents::{Acceptance, AccuracyDocument, ErrorQuantity, Figure, LimitQuantity, Reason, VerdictDocument};
use std::io::Cursor;

/// Exit code and terminal text of a run of the CMM sample with these statements.
fn ran(um: &str, rule: &str) -> (Scratch, Option<i32>, String) {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "expanded_uncertainty_um = 2.7", &format!("expanded_uncertainty_um = {um}"));
    scratch.replace("campaign.toml", "[limits]", &format!("[limits]\n{rule}"));
    let run = etalon(scratch.root(), &["run", "campaign"]);
    assert!(run.status.code() < Some(2), "{}", text_of(&run));
    (scratch, run.status.code(), text(&run.stdout))
}

/// By guarded acceptance what U leaves open is not met; simple acceptance does not ask for U, shared risk wants it small.
#[test]
fn a_worse_instrument_changes_the_statement_of_conformity() {
    let rule = |name: &str| format!("decision_rule = \"{name}\"");
    for (um, rule, code, verdict, named) in [
        ("10", String::new(), 0, "pass", "guarded acceptance (ILAC-G8:09/2019, 4.2.3)"),
        ("90", String::new(), 1, "undecided", "guarded acceptance (ILAC-G8:09/2019, 4.2.3)"),
        ("90", rule("guarded"), 1, "undecided", "guarded acceptance (ILAC-G8:09/2019, 4.2.3)"),
        ("90", rule("simple-acceptance"), 0, "pass", "simple acceptance (ILAC-G8:09/2019, 4.2.1)"),
        ("90", rule("shared-risk"), 1, "undecided", "shared risk (JCGM 106:2012, 8.2.1)"),
    ] {
        let (scratch, ended, shown) = ran(um, &rule);
        assert_eq!(ended, Some(code), "{um} {rule}\n{shown}");
        let sentence = shown.lines().find(|line| line.starts_with("Largest position error at")).unwrap();
        assert!(sentence.contains(&format!("limit 44 µm: {verdict}")), "{um} {rule}: {sentence}");
        // the risk of simple acceptance is stated
        assert_eq!(sentence.has_phrase("limit-margin"), rule.contains("simple"), "{sentence}");
        let accuracy: AccuracyDocument = scratch.document("accuracy.json");
        let limit = &accuracy.limits[0];
        let u = limit.expanded_uncertainty.unwrap();
        // Limits and budget have one uncertainty
        let budget =
            accuracy.budget.iter().find(|b| b.figure == Figure::Max && b.quantity == ErrorQuantity::Position).unwrap();
        assert!((u / (2.0 * budget.standard_uncertainty_mm) - 1.0).abs() < 1e-12, "{u}");
        // the centre of two balls is known better than one ball, and not better than their mean
        let of_coordinate = 1e-3 * um.parse::<f64>().unwrap();
        assert!((0.7 * of_coordinate..1.5 * of_coordinate).contains(&u), "{um}: {u}");
        let judged: VerdictDocument = scratch.document("verdict.json");
        let expected = if verdict == "pass" { Acceptance::Pass } else { Acceptance::Undecided };
        assert_eq!((judged.verdict, i32::from(judged.exit_code)), (Some(expected), code), "{um} {rule}");
        assert!(shown.contains(&format!("Decision rule: {named}.")), "{shown}");
        let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
        assert_eq!(html.has_phrase("decision-rule-by-default"), rule.is_empty(), "{rule}");
    }
}

#[test]
fn every_output_has_the_same_sentence() {
    let (scratch, code, shown) = ran("10", "");
    let sentence = shown.lines().nth(2).unwrap();
    assert!(code == Some(0) && sentence.starts_with("Largest position error at 51 validation poses"), "{shown}");
    let out = scratch.path().join("out");
    assert!(std::fs::read_to_string(out.join("report.html")).unwrap().contains(sentence));
    let mut book = Xlsx::new(Cursor::new(std::fs::read(out.join("report.xlsx")).unwrap())).unwrap();
    let first = book.worksheet_range_at(0).unwrap().unwrap();
    assert!(first.rows().flatten().any(|cell| cell.to_string().contains(sentence)));
    if cfg!(feature = "pdf")
        && let Some(words) = tool("pdftotext", &["{}", "-"], &out.join("report.pdf"))
    {
        assert!(words.split_whitespace().collect::<Vec<_>>().join(" ").contains(sentence), "{words}");
    }
    for (language, part) in [("fr", "limite 44\u{a0}µm\u{a0}: conforme."), ("de", "Grenzwert 44\u{a0}µm: bestanden.")]
    {
        let written = etalon(scratch.root(), &["report", "campaign/out", "--language", language]);
        assert!(written.status.success(), "{}", text_of(&written));
        let page = std::fs::read_to_string(out.join("report.html")).unwrap();
        assert!(page.contains(part) && page.contains(" ± "), "{language}");
        assert!(page.contains("± 2u") && !page.contains("intervalles à 95 %"), "{language}: U is k = 2, not 95 %");
    }
}

/// A length between two points says nothing of a position, and has the uncertainty of a length.
#[test]
fn each_kind_of_observation_has_its_own_error_uncertainty_and_limit() {
    for (sample, key, quantity, expanded_mm) in [
        ("two-arms", "distance_max_mm", ErrorQuantity::Distance, 0.020),
        ("draw-wire", "distance_max_mm", ErrorQuantity::Distance, 0.100),
        ("surfaces", "surface_max_mm", ErrorQuantity::Surface, 0.040),
    ] {
        let scratch = copy_sample(sample);
        let run = etalon(scratch.root(), &["run", "campaign"]);
        assert_eq!(run.status.code(), Some(0), "{sample}: {}", text_of(&run));
        let accuracy: AccuracyDocument = scratch.document("accuracy.json");
        let set = accuracy.sets.last().unwrap();
        assert!(
            set.error_statistics(ErrorQuantity::Position).is_none() && set.error_statistics(quantity).is_some(),
            "{sample}: {set:?}"
        );
        let u = accuracy.limits[0].expanded_uncertainty.unwrap();
        // that of one length as stated, with base, targets and fixtures beside it: not √3 times as much
        assert!((expanded_mm..1.5 * expanded_mm).contains(&u), "{sample}: {u}");
        assert!(!text(&run.stdout).contains("osition error"), "{sample}: {}", text(&run.stdout));
        // a limit of what was not measured
        scratch.replace("campaign.toml", key, "position_max_mm");
        let run = etalon(scratch.root(), &["run", "campaign"]);
        assert_eq!(run.status.code(), Some(1), "{sample}: {}", text_of(&run));
        assert!(text(&run.stdout).contains("Not assessable"), "{sample}: {}", text(&run.stdout));
        let verdict: VerdictDocument = scratch.document("verdict.json");
        assert_eq!(verdict.verdict, Some(Acceptance::Undecided), "{sample}");
        assert_eq!(verdict.reasons, [Reason::NotAssessable { limit: LimitQuantity::PositionMaxMm }], "{sample}");
    }
}

/// All limits of the sample are proven, by an instrument that is too coarse, on a cold robot.
#[test]
fn preconditions_of_iso_9283_are_reservations_of_the_verdict() {
    let scratch = copy_sample("pose-test");
    let run = etalon(scratch.root(), &["run", "campaign"]);
    assert_eq!(run.status.code(), Some(0), "{}", text_of(&run));
    let verdict: VerdictDocument = scratch.document("verdict.json");
    assert_eq!(verdict.verdict, Some(Acceptance::Conditional));
    let coarse = Reason::InstrumentTooCoarse { poses: [1, 2, 3, 4].map(Into::into).to_vec() };
    assert!(verdict.reasons.contains(&coarse) && verdict.reasons.contains(&Reason::NoWarmUp), "{verdict:?}");
    assert!(verdict.reasons.iter().any(|r| matches!(r, Reason::DriftNotSettled { .. })), "{verdict:?}");
    let shown = text(&run.stdout);
    assert!(shown.contains("Verdict: pass with reservations.") && shown.contains("Reservations: "), "{shown}");
    let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    assert!(html.contains("<div class=\"box warning\"><p><strong class=\"head\">Verdict: pass with reservations."));
    // warmed up, with an instrument ten times as good, and drift of no interest
    scratch.replace("campaign.toml", "warm_up_minutes = 0", "warm_up_minutes = 60");
    scratch.replace("campaign.toml", "expanded_uncertainty_um = 10", "expanded_uncertainty_um = 1");
    scratch.replace("campaign.toml", "drift_set = 5 ", "# drift_set = 5");
    let run = etalon(scratch.root(), &["run", "campaign"]);
    let verdict: VerdictDocument = scratch.document("verdict.json");
    // that positions drift is then a warning alone
    let open = Reason::OpenWarnings { ids: vec!["positions-drift".to_owned()] };
    assert_eq!((run.status.code(), &verdict.reasons[..]), (Some(0), &[open][..]), "{verdict:?}");
}

/// Twelve parameters of a hexapod are taken up by base and targets, and many are weak: two remarks, of which one is routine.
#[test]
fn remarks_that_are_alike_are_one_and_routine_ones_are_in_their_section() {
    let scratch = copy_sample("hexapod");
    let run = etalon(scratch.root(), &["run", "campaign"]);
    let said = String::from_utf8(run.stderr).unwrap();
    assert!(run.status.success() && said.lines().filter(|l| l.starts_with("warning")).count() == 2, "{said}");
    let joined = phrase!("parameters-fixed-by-frames", count = 12, parameters = "").to_string();
    let joined = joined.trim_end();
    assert!(
        said.find("[parameter-groups-weakly-identifiable]").unwrap() < said.find(joined).unwrap(),
        "routine ones come last: {said}"
    );
    let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    let section = |id: &str| {
        let from = html.split_once(&format!("<section id=\"{id}\"")).unwrap().1;
        from.split_once("</section>").unwrap().0.to_owned()
    };
    let (messages, parameters) = (section("messages"), section("parameters"));
    assert!(messages.contains("Should know") && messages.matches("class=\"box warning\"").count() == 1, "{messages}");
    assert!(!messages.contains(joined) && parameters.contains(joined) && parameters.contains("Further remarks"));
    let mut book = Xlsx::new(Cursor::new(std::fs::read(scratch.path().join("out/report.xlsx")).unwrap())).unwrap();
    let sheet = book.worksheet_range("Messages").unwrap();
    let ranks: Vec<String> = sheet.rows().map(|row| row[1].to_string()).collect();
    assert_eq!(ranks.iter().filter(|rank| *rank == "routine").count(), 1, "{ranks:?}");
}

#[test]
fn the_quarter_rule_takes_the_uncertainty_of_a_position() {
    let scratch = copy_sample("pose-test");
    let ratios = |scratch: &Scratch| {
        let run = etalon(scratch.root(), &["run", "campaign"]);
        assert!(run.status.code() < Some(2), "{}", text_of(&run));
        let text = std::fs::read_to_string(scratch.path().join("out/iso9283.json")).unwrap();
        let document: etalon::documents::Iso9283Document = serde_json::from_str(&text).unwrap();
        let poses = document.poses.iter();
        poses.map(|p| p.uncertainty_over_rp.unwrap() * p.rp_mm.unwrap()).collect::<Vec<f64>>()
    };
    ratios(&scratch).into_iter().for_each(|u| assert!((u - 0.010 * 3f64.sqrt()).abs() < 1e-12, "{u}"));
    let stated = "expanded_uncertainty_um = 10\nexpanded_position_uncertainty_um = 12";
    scratch.replace("campaign.toml", "expanded_uncertainty_um = 10", stated);
    ratios(&scratch).into_iter().for_each(|u| assert!((u - 0.012).abs() < 1e-12, "{u}"));
}

/// In each language what ISO/IEC 17025:2017, 7.8.4 asks of a certificate. Synthetic data make none: the title and a mark on every page say so.
#[test]
fn synthetic_data_make_no_certificate() {
    for sample in ["prexyt-cmm", "prexyt-repeatability"] {
        let scratch = copy_sample(sample);
        assert!(etalon(scratch.root(), &["run", "campaign"]).status.success());
        for (language, title, rule, mark) in [
            ("en", "not a certificate", "guarded acceptance (ILAC-G8:09/2019, 4.2.3)", "SYNTHETIC DATA"),
            (
                "fr",
                "sans valeur de certificat",
                "acceptation avec bande de garde (ILAC-G8:09/2019, 4.2.3)",
                "DONNÉES SYNTHÉTIQUES",
            ),
            ("de", "kein ", "Annahme mit Schutzabstand (ILAC-G8:09/2019, 4.2.3)", "SYNTHETISCHE DATEN"),
        ] {
            let written = etalon(scratch.root(), &["report", "campaign/out", "--certificate", "--language", language]);
            assert!(written.status.success(), "{}", text_of(&written));
            let html = std::fs::read_to_string(scratch.path().join("out/certificate.html")).unwrap();
            let html = html.replace("&#x2f;", "/");
            let heading = html.split("<h1>").nth(1).unwrap().split("</h1>").next().unwrap();
            assert!(heading.contains(title) && html.contains(rule), "{sample} {language}: {heading}");
            assert!(html.contains(&format!("data-draft=\"{mark}\"")), "{sample} {language}");
            assert!(html.contains("id=\"signatures\"") && html.contains("class=\"end\""), "{sample} {language}");
            let file = scratch.path().join("out/certificate.pdf");
            let Some(text) = tool("pdftotext", &["{}", "-"], &file).filter(|_| cfg!(feature = "pdf")) else { continue };
            // letters of the mark, which are turned, are not read as a word
            assert!(text.contains(title), "{sample} {language}: {text}");
        }
    }
}
