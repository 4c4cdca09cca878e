//! One verdict in every output and in the exit code, by the decision rule that the campaign states.

use super::reports::tool;
use super::{etalon, text, text_of};
use crate::support::scratch::{Scratch, copy_sample};
use calamine::{Reader, Xlsx};
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

/// By ISO 14253-1 what U leaves open is not met; simple acceptance does not ask for U, shared risk wants it small.
#[test]
fn a_worse_instrument_changes_the_statement_of_conformity() {
    let rule = |name: &str| format!("decision_rule = \"{name}\"");
    for (um, rule, code, verdict, named) in [
        ("10", String::new(), 0, "met", "guarded acceptance (ISO 14253-1)"),
        ("90", String::new(), 1, "undecided", "guarded acceptance (ISO 14253-1)"),
        ("90", rule("guarded"), 1, "undecided", "guarded acceptance (ISO 14253-1)"),
        ("90", rule("simple-acceptance"), 0, "met", "simple acceptance (ILAC-G8:09/2019, 4.2.1)"),
        ("90", rule("shared-risk"), 1, "undecided", "shared risk (JCGM 106:2012, 8.2.1)"),
    ] {
        let (scratch, ended, shown) = ran(um, &rule);
        assert_eq!(ended, Some(code), "{um} {rule}\n{shown}");
        let sentence = shown.lines().nth(1).unwrap();
        assert!(sentence.ends_with(&format!(": {verdict}).")), "{um} {rule}: {sentence}");
        // √2 times U of a coordinate, in the plane
        let expanded = um.parse::<f64>().unwrap() * 2f64.sqrt();
        assert!(sentence.contains(&format!(" ± {expanded:.0} µm")), "{sentence}");
        assert!(shown.contains(&format!("Decision rule: {named}.")), "{shown}");
        let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
        assert_eq!(html.contains("The campaign states no rule; this one then applies."), rule.is_empty(), "{rule}");
    }
}

#[test]
fn every_output_has_the_same_sentence() {
    let (scratch, code, shown) = ran("10", "");
    let sentence = shown.lines().nth(1).unwrap();
    assert!(code == Some(0) && sentence.starts_with("The largest position error at 51 validation poses fell from "));
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
    for (language, part) in [("fr", "(limite 44 µm : respectée)."), ("de", "(Grenzwert 44 µm: eingehalten).")] {
        let written = etalon(scratch.root(), &["report", "campaign/out", "--language", language]);
        assert!(written.status.success(), "{}", text_of(&written));
        let page = std::fs::read_to_string(out.join("report.html")).unwrap();
        assert!(page.contains(part) && page.contains(" ± 14 µm"), "{language}");
        assert!(page.contains("± 2u") && !page.contains("intervalles à 95 %"), "{language}: U is k = 2, not 95 %");
    }
}

/// Twelve parameters of a hexapod are taken up by base and targets, and many are weak: two remarks, of which one is routine.
#[test]
fn remarks_that_are_alike_are_one_and_routine_ones_are_in_their_section() {
    let scratch = copy_sample("hexapod");
    let run = etalon(scratch.root(), &["run", "campaign"]);
    let said = String::from_utf8(run.stderr).unwrap();
    assert!(run.status.success() && said.lines().filter(|l| l.starts_with("warning")).count() == 2, "{said}");
    let joined = "12 parameters are not separately identifiable from base and targets";
    assert!(
        said.find("are weakly identifiable").unwrap() < said.find(joined).unwrap(),
        "routine ones come last: {said}"
    );
    let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    let section = |id: &str| {
        let from = html.split_once(&format!("<section id=\"{id}\">")).unwrap().1;
        from.split_once("</section>").unwrap().0.to_owned()
    };
    let (messages, parameters) = (section("messages"), section("parameters"));
    assert!(messages.contains("Should know") && messages.matches("class=\"box warning\"").count() == 1, "{messages}");
    assert!(!messages.contains(joined) && parameters.contains(joined) && parameters.contains("Routine remarks"));
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
            ("en", "not a certificate", "guarded acceptance (ISO 14253-1)", "SYNTHETIC DATA"),
            (
                "fr",
                "sans valeur de certificat",
                "acceptation avec bande de garde (ISO 14253-1)",
                "DONNÉES SYNTHÉTIQUES",
            ),
            ("de", "kein ", "Annahme mit Schutzabstand (ISO 14253-1)", "SYNTHETISCHE DATEN"),
        ] {
            let written = etalon(scratch.root(), &["report", "campaign/out", "--certificate", "--language", language]);
            assert!(written.status.success(), "{}", text_of(&written));
            let html = std::fs::read_to_string(scratch.path().join("out/certificate.html")).unwrap();
            let heading = html.split("<h1>").nth(1).unwrap().split("</h1>").next().unwrap();
            assert!(heading.contains(title) && html.contains(rule), "{sample} {language}: {heading}");
            assert!(html.contains(&format!("data-draft=\"{mark}\"")), "{sample} {language}");
            assert!(html.contains("id=\"signatures\"") && html.contains("class=\"end\""), "{sample} {language}");
            let file = scratch.path().join("out/certificate.pdf");
            let Some(text) = tool("pdftotext", &["{}", "-"], &file).filter(|_| cfg!(feature = "pdf")) else { continue };
            let marked = |page: &str| mark.split(' ').all(|word| page.contains(word));
            assert!(text.trim_end_matches('\u{c}').split('\u{c}').all(marked), "{sample} {language}: {text}");
        }
    }
}
