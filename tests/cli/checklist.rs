//! The lists that an assessor goes through: ISO/IEC 17025:2017, 7.8.2.1 a to p, with 7.8.4.1, 7.8.6 and 7.8.8 for calibrations, and the
//! report clause of ISO 9283:1998. Each line names the place in the report where it is found.

use super::reports::tool;
use super::{etalon, text_of};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};

/// Clause, what it asks for, section of the page (`""`: outside of all), and the text there.
type Line = (&'static str, &'static str, &'static str, &'static str);

const STATED: &str = r#"
date = "2026-01-31"
operator = "N. N."
temperature_c = 20.0

[report]
number = "2026-017"
amends = "2026-012: serial number corrected"
customer = "Robots Ltd, 2 Side Street"
issued = "2026-02-14"
authorised_by = "B. Roy, head of the laboratory"
external_results = "none"

[conditions]
laboratory = "Metrology laboratory, 1 Main Street"
place = "hall 3"
robot_maker = "ETS"
robot_type = "PreXYT mark 1"
robot_serial_number = "SN 0007"
robot_received = "2026-01-20"
robot_state = "as found"
controller = "Galil DMC-2133"
mounting = "floor"
measurement_point = "centre of ball K"
load_kg = 0.5
load_centre_mm = [0.0, 0.0, 30.0]
velocities_percent = [100]
environment = "air-conditioned"
humidity_percent = 45
warm_up_minutes = 60
instrument_calibration = "certificate 123"
traceability = "national length standard"
deviations = ["one velocity only"]
"#;

const ISO_17025: &[Line] = &[
    ("7.8.2.1 a", "title", "", "<h1>"),
    ("7.8.2.1 b", "name and address of the laboratory", "conditions", "1 Main Street"),
    ("7.8.2.1 c", "location of the activities", "conditions", "hall 3"),
    ("7.8.2.1 d", "unique identification", "conditions", "2026-017"),
    ("7.8.2.1 d", "clear identification of the end", "", "End of report <bdi>2026-017</bdi>"),
    ("7.8.2.1 e", "name and contact of the customer", "conditions", "2 Side Street"),
    ("7.8.2.1 f", "method", "conditions", "by least squares; etalon "),
    ("7.8.2.1 g", "item: manufacturer", "conditions", "ETS"),
    ("7.8.2.1 g", "item: type", "conditions", "PreXYT mark 1"),
    ("7.8.2.1 g", "item: unambiguous identification", "conditions", "SN 0007"),
    ("7.8.2.1 g", "item: condition", "conditions", "as found"),
    ("7.8.2.1 h", "date of receipt", "conditions", "2026-01-20"),
    ("7.8.2.1 i", "date of performance", "conditions", "date of the measurements"),
    ("7.8.2.1 j", "date of issue", "conditions", "2026-02-14"),
    ("7.8.2.1 k", "sampling: which poses", "errors", "validation: "),
    ("7.8.2.1 l", "relate only to the item", "", "These results relate only to the item tested."),
    ("7.8.2.1 m", "results with units", "errors", "µm"),
    ("7.8.2.1 n", "deviations from the method", "conditions", "one velocity only"),
    ("7.8.2.1 n", "exclusions", "import", "rejected"),
    ("7.8.2.1 o", "who authorises", "conditions", "B. Roy"),
    ("7.8.2.1 o", "who authorises, to sign", "signatures", "Approved by"),
    ("7.8.2.1 p", "results of external providers", "conditions", "results of external providers"),
    ("7.8.4.1 a", "uncertainty of the results", "parameters", "U = 2u"),
    ("7.8.4.1 b", "conditions that influence the results", "conditions", "air-conditioned"),
    ("7.8.4.1 c", "traceability", "conditions", "national length standard"),
    ("7.8.4.1 d", "before and after an adjustment", "errors", "before"),
    ("7.8.4.1 e", "statement of conformity", "verdict", "limits of the campaign are met"),
    ("7.8.6.2", "the decision rule that was applied", "limits", "Decision rule: guarded acceptance"),
    ("7.8.8.2", "amendment: of which report, and why", "conditions", "serial number corrected"),
];

const ISO_9283: &[Line] = &[
    ("12", "manufacturer", "conditions", "ETS"),
    ("12", "type", "conditions", "PreXYT mark 1"),
    ("12", "serial number", "conditions", "SN 0007"),
    ("12", "controller", "conditions", "Galil DMC-2133"),
    ("12", "date", "conditions", "date of the measurements"),
    ("12", "tester", "signatures", "Tested by"),
    ("6.2", "mounting", "conditions", "floor"),
    ("6.3", "warm-up", "conditions", "60 min"),
    ("6.4", "environment", "conditions", "45 %"),
    ("6.5", "measurement point", "conditions", "centre of ball K"),
    ("6.6", "instrument and its uncertainty", "conditions", "U = "),
    ("6.7", "load and its centre", "conditions", "0.5 kg"),
    ("6.8", "velocity", "conditions", "100 % of the rated velocity"),
    ("6.9", "poses and cycles", "conditions", "visits each"),
    ("7", "RP", "repeatability", "RP"),
    ("12", "deviations from the standard", "conditions", "one velocity only"),
];

/// The page of a sample with these statements in place of its own.
fn page(sample: &str, stated: &str) -> (Scratch, String) {
    page_of(sample, stated, true)
}

/// The same, of data that are called synthetic or measured.
fn page_of(sample: &str, stated: &str, synthetic: bool) -> (Scratch, String) {
    let scratch = copy_sample(sample);
    let file = scratch.path().join("campaign.toml");
    let mut table: toml::Table = std::fs::read_to_string(&file).unwrap().parse().unwrap();
    table.remove("conditions");
    if !synthetic {
        table.remove("synthetic");
    }
    table.extend(stated.parse::<toml::Table>().unwrap());
    std::fs::write(&file, table.to_string()).unwrap();
    let run = etalon(scratch.root(), &["run", "campaign"]);
    assert!(run.status.success(), "{}", text_of(&run));
    let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    (scratch, html)
}

fn section<'a>(html: &'a str, id: &str) -> &'a str {
    let from = html.split_once(&format!("<section id=\"{id}\"")).map(|(_, rest)| rest);
    from.and_then(|rest| rest.split_once("</section>")).map_or("", |(section, _)| section)
}

#[test]
fn every_line_of_the_lists_is_at_its_place() {
    for (sample, lines) in [("prexyt-cmm", ISO_17025), ("prexyt-repeatability", ISO_9283)] {
        let (scratch, html) = page(sample, STATED);
        for (clause, what, place, text) in lines {
            let found = if place.is_empty() { html.as_str() } else { section(&html, place) };
            assert!(found.contains(text), "{clause}, {what}: no {text:?} in section {place:?} of {sample}");
        }
        assert!(!section(&html, "conditions").contains("ot stated"), "{sample}: {}", section(&html, "conditions"));
        let file = scratch.path().join("out/report.pdf");
        let Some(words) = tool("pdftotext", &["-layout", "{}", "-"], &file).filter(|_| cfg!(feature = "pdf")) else {
            continue;
        };
        let pages: Vec<&str> = words.trim_end_matches('\u{c}').split('\u{c}').collect();
        for (i, text) in pages.iter().enumerate() {
            assert!(
                text.contains("2026-017") && text.contains(&format!("page {} of {}", i + 1, pages.len())),
                "{text}"
            );
        }
        let last = pages[pages.len() - 1];
        assert!(last.has_phrase("end-of-report") && last.contains("2026-017"), "{last}");
    }
}

/// The checklist names what is missing with its key, and a certificate is a draft until nothing is.
#[test]
fn a_certificate_of_complete_measured_data_is_no_draft() {
    let rule = "\n[limits]\nposition_max_mm = 0.044\ndecision_rule = \"guarded\"\nspecification = \"drawing 4711\"\n";
    let whole = format!("{STATED}{rule}");
    for (stated, missing) in [(whole.clone(), None), (whole.replace("issued =", "# issued ="), Some("report.issued"))] {
        let (scratch, html) = page_of("prexyt-cmm", &stated, false);
        assert_eq!(section(&html, "checklist").is_empty(), missing.is_none(), "{}", section(&html, "checklist"));
        let written = etalon(scratch.root(), &["report", "campaign/out", "--certificate"]);
        assert!(written.status.success(), "{}", text_of(&written));
        let certificate = std::fs::read_to_string(scratch.path().join("out/certificate.html")).unwrap();
        assert_eq!(certificate.contains("data-draft="), missing.is_some());
        assert_eq!(certificate.contains("<h1><bdi>Calibration certificate</bdi></h1>"), missing.is_none());
        assert!(section(&certificate, "checklist").contains(missing.unwrap_or_default()));
    }
}

/// Of a calibration as of a test; the robot is called by its name, not by its model.
#[test]
fn what_is_not_stated_is_said_to_be_not_stated() {
    for sample in ["prexyt-cmm", "prexyt-repeatability"] {
        let (_scratch, html) = page(sample, "");
        let lists = section(&html, "conditions").split("Not stated, besides the fields to complete before signing: ");
        let lists: Vec<&str> = lists.skip(1).filter_map(|list| list.split('<').next()).collect();
        let mut not_stated: Vec<&str> = lists.iter().flat_map(|list| list.trim_end_matches('.').split(", ")).collect();
        // fields to complete have a row each, with their keys
        not_stated.extend(section(&html, "checklist").split(['<', '>']).map(str::trim));
        assert_eq!(lists.len(), 2, "{sample}: of the report, and of the conditions");
        for what in [
            "report number",
            "laboratory",
            "place of the measurements",
            "customer",
            "manufacturer",
            "type",
            "serial number",
            "state of the robot",
            "date of receipt",
            "date of issue",
            "results of external providers",
            "authorised by",
            "controller",
            "mounting",
            "measurement point",
            "load",
            "velocities",
            "warm-up before the test",
            "traceability",
            "deviations from the method",
        ] {
            assert!(not_stated.contains(&what), "{sample}: {what} is not among {not_stated:?}");
        }
        assert!(html.has_phrase("rule-not-stated") && !html.contains("of robot prexyt"), "{sample}");
    }
}
