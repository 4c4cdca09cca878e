//! Tests of ISO 9283 inside a campaign: the same numbers as the command's, all of them in the report, and what is wrong told.

use super::reports::{column, text_of_pdf, workbook};
use super::{etalon, judged, rows, text, text_of};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use calamine::Data;
use etalon::documents::{Conformity, Iso9283ComplianceDocument, Iso9283Document, Iso9283Drift, Iso9283Pose};
use std::fmt::Write;

fn ran(scratch: &Scratch) -> String {
    let done = etalon(scratch.root(), &["run", "campaign"]);
    assert!(done.status.success(), "{}", text_of(&done));
    text(&done.stdout)
}

fn answered<T: serde::de::DeserializeOwned>(scratch: &Scratch, arguments: &[&str]) -> T {
    let done = etalon(&scratch.path(), &[&["iso9283"][..], arguments, &["--json"]].concat());
    serde_json::from_slice(&done.stdout).unwrap_or_else(|e| panic!("{e}: {}", text_of(&done)))
}

#[test]
fn a_campaign_of_tables_says_what_the_command_says_of_them() {
    let scratch = copy_sample("pose-test");
    let shown = ran(&scratch);
    let of_campaign: Iso9283Document = scratch.document("iso9283.json");
    let tables = ["poses.csv", "--commanded", "commanded.csv", "--reference", "reference.csv"];
    let stated = ["--rotation-order", "Rz(c) Ry(b) Rx(a)", "--drift-set", "5", "--expanded-uncertainty-um", "10"];
    let limits = ["--ap-limit-mm", "0.4", "--rp-limit-mm", "0.1", "--all"];
    let of_command: Iso9283Document = answered(&scratch, &[&tables[..], &stated, &limits].concat());
    assert!(of_campaign.poses.len() == 5 && of_campaign.poses == of_command.poses);
    assert!(of_campaign.distances.len() == 10 && of_campaign.distances == of_command.distances);
    assert!(of_campaign.drifts.len() == 5 && of_campaign.drifts == of_command.drifts);
    assert!(
        of_campaign.recorded.reference.len() == 3 && of_campaign.recorded.reference == of_command.recorded.reference
    );
    assert!(of_campaign.limits.len() == 2 && of_campaign.limits == of_command.limits);
    // AP warms up, so its interval gives no risk; RP has one
    let risks: Vec<bool> = of_campaign.limits.iter().map(|l| l.risk().is_some()).collect();
    assert_eq!(risks, [false, true], "{:?}", of_campaign.limits);
    assert!(of_campaign.poses.iter().all(|p| p.ap_interval_contains_sets));
    // the pose that drifts most, over the six sets of five cycles
    assert!(shown.has_phrase("action-warm-up-drift pose=5 sets=6"), "{shown}");
    let loads: Iso9283ComplianceDocument = scratch.document("iso9283-compliance.json");
    assert_eq!(loads, answered(&scratch, &["--compliance", "loads.csv"]));
    assert!(judged(&shown, "largest pose accuracy", "pass"), "{shown}");
    assert!(rows(&shown).iter().any(|row| row.starts_with("+x 1.83 ")), "{shown}");
    assert!(shown.contains("(ILAC-G8:09/2019, 4.2.3): all 5 poses conform."), "{shown}");
    // what its README says was put in: P5 is off by 0.30 mm, and warms up by 60 µm
    let p5 = &of_campaign.poses[4];
    assert!((0.32..0.37).contains(&p5.ap_mm.unwrap()), "{:?}", p5.ap_mm);
    assert!(of_campaign.drifts.iter().all(|d| (0.01..0.06).contains(&d.dap_mm)), "{:?}", of_campaign.drifts);
    assert!(of_campaign.recorded.reference[2].moved_mm > of_campaign.recorded.reference[1].moved_mm);
}

/// A test of poses says nothing about the geometry of the robot, and needs no file of it; without a name its title is what it tests, and when.
#[test]
fn a_test_of_poses_needs_no_robot_and_no_name() {
    let (with, without) = (copy_sample("pose-test"), copy_sample("pose-test"));
    ran(&with);
    without.replace("campaign.toml", "robot = \"robot.toml\"\n", "");
    without.replace("campaign.toml", "name = \"Test of poses by ISO 9283 (synthetic)\"\n", "");
    std::fs::remove_file(without.path().join("robot.toml")).unwrap();
    let checked = etalon(without.root(), &["check", "campaign"]);
    assert!(checked.status.success(), "{}", text_of(&checked));
    let shown = ran(&without);
    let title = shown.lines().next().unwrap();
    assert_eq!(title, "Test of six axes, rated load 3 kg (invented), 2026-03-02");
    let [one, other]: [Iso9283Document; 2] = [&with, &without].map(|scratch| scratch.document("iso9283.json"));
    assert_eq!(one, other);
    // an identification does need it
    let calibrated = copy_sample("prexyt-cmm");
    calibrated.replace("campaign.toml", "robot = \"robot.toml\"\n", "");
    let refused = etalon(calibrated.root(), &["check", "campaign"]);
    assert!(text_of(&refused).says("error[key-missing] key=robot"), "{}", text_of(&refused));
}

#[test]
fn the_report_shows_every_characteristic_in_html_pdf_and_workbook() {
    let scratch = copy_sample("pose-test");
    ran(&scratch);
    let report = scratch.path().join("out/report.html");
    let html = std::fs::read_to_string(&report).unwrap();
    let ids = ["accuracy", "repeatability", "drift", "compliance"];
    ids.iter().for_each(|id| assert!(html.contains(&format!(" id=\"{id}\"")), "{id}"));
    let parts = [
        "Positioning accuracy",
        "Orientation",
        "Distances between poses",
        "Uncertainty of RP",
        "RP without noise",
        "AP by set",
        "RP by set",
        "Reference targets",
        "7.2.1",
        "7.2.2",
        "7.3",
        "7.6",
        "1998, 10",
        "conforming",
        "Test report according to ISO 9283:1998: AP, RP, ",
        "frame of the tables at the first measurement of the reference targets",
    ];
    parts.iter().for_each(|part| assert!(html.contains(part), "{part}"));
    assert!(!html.has_phrase("accuracy-not-tested") && !html.contains("id=\"streams\""));
    // the nests move before cycles 11 and 21
    for phrase in ["set-up-corrected steps=2", "risk-without-coverage", "visits-from-one-pose visits=30 unknown=1"] {
        assert!(html.has_phrase(phrase), "{phrase}");
    }
    if let Some(words) = text_of_pdf(&scratch.path().join("out/report.pdf")) {
        let said = words.split_whitespace().collect::<Vec<_>>().join(" ");
        for part in
            ["Positioning accuracy", "Distances between poses", "Drift", "stabilised after set", "Static compliance"]
        {
            assert!(said.says(part), "{part}: {said}");
        }
    }
    let found: Iso9283Document = scratch.document("iso9283.json");
    let mut book = workbook(&scratch);
    let mut numbers = |sheet: &str, title: &str| -> Vec<f64> {
        column(&mut book, sheet, title).iter().map(|c| calamine::DataType::as_f64(c).unwrap()).collect()
    };
    let of = |value: fn(&Iso9283Pose) -> Option<f64>| found.poses.iter().filter_map(value).collect::<Vec<f64>>();
    assert_eq!(numbers("ISO 9283 poses", "AP [mm]"), of(|p| p.ap_mm));
    assert_eq!(numbers("ISO 9283 poses", "AP c [deg]"), of(|p| p.ap_c_deg));
    assert_eq!(
        numbers("ISO 9283 drift", "AP [mm]"),
        found.drifts.iter().flat_map(|d| d.ap_mm.clone()).collect::<Vec<_>>()
    );
    let moved: Vec<f64> = found.recorded.reference.iter().map(|e| e.moved_mm).collect();
    assert_eq!(numbers("ISO 9283 reference targets", "moved [mm]"), moved);
    assert_eq!(numbers("ISO 9283 compliance", "compliance [mm/N]").len(), 6);
    for language in ["fr", "de"] {
        assert!(etalon(scratch.root(), &["report", "campaign/out", "--language", language]).status.success());
        let page = std::fs::read_to_string(&report).unwrap();
        assert!(page.contains(if language == "fr" { "Dérive" } else { "Statische Nachgiebigkeit" }), "{language}");
    }
    assert!(etalon(scratch.root(), &["report", "campaign/out"]).status.success());
    assert_eq!(std::fs::read_to_string(&report).unwrap(), html, "the report is made again from the documents alone");
}

/// The instrument of the sample, as the command takes it.
const INSTRUMENT: [&str; 2] = ["--expanded-uncertainty-um", "2.7"];

/// The labelled visits of a campaign as the tables of the command, with these coordinates.
fn as_tables(scratch: &Scratch, found: &Iso9283Document, axes: &[usize]) {
    let names = axes.iter().map(|k| ["x_mm", "y_mm", "z_mm"][*k]).collect::<Vec<_>>().join(",");
    let mut table = format!("pose,cycle,approach,{names}\n");
    for v in &found.recorded.visits {
        let place = axes.iter().map(|k| v.attained_mm[*k].to_string()).collect::<Vec<_>>().join(",");
        let _ = writeln!(table, "{},{},{},{place}", v.pose, v.cycle, v.approach.as_deref().unwrap_or("first"));
    }
    std::fs::write(scratch.path().join("visits.csv"), table).unwrap();
}

#[test]
fn labelled_visits_with_commanded_poses_have_the_accuracy_that_the_command_finds() {
    for axes in [&[0, 1, 2][..], &[0, 1]] {
        let scratch = copy_sample("prexyt-repeatability");
        let commanded =
            [[95.4, 117.2, 42.0], [170.3, 229.5, 42.0], [20.4, 229.4, 42.0], [20.1, 4.6, 42.0], [170.1, 4.7, 42.0]];
        let names = axes.iter().map(|k| ["x_mm", "y_mm", "z_mm"][*k]).collect::<Vec<_>>().join(",");
        let row = |(i, p): (usize, &[f64; 3])| {
            format!("{},{}\n", i + 1, axes.iter().map(|k| p[*k].to_string()).collect::<Vec<_>>().join(","))
        };
        let table = format!("pose,{names}\n{}", commanded.iter().enumerate().map(row).collect::<String>());
        std::fs::write(scratch.path().join("positions.csv"), table).unwrap();
        scratch.replace("campaign.toml", "homing = ", "commanded = \"positions.csv\"\ndrift_set = 10\nhoming = ");
        scratch.replace("campaign.toml", "[limits]", "[limits]\naccuracy_max_mm = 500");
        let shown = ran(&scratch);
        let found: Iso9283Document = scratch.document("iso9283.json");
        as_tables(&scratch, &found, axes);
        let same: Iso9283Document = answered(
            &scratch,
            &[&["visits.csv", "--commanded", "positions.csv", "--all", "--drift-set", "10"][..], &INSTRUMENT].concat(),
        );
        for (p, q) in found.poses.iter().zip(&same.poses) {
            let numbers = |p: &Iso9283Pose| [p.ap_mm.unwrap(), p.ap_interval.unwrap().high_mm, p.rp_mm.unwrap()];
            numbers(p).iter().zip(numbers(q)).for_each(|(a, b)| assert!((a - b).abs() < 1e-9, "{p:?} {q:?}"));
            assert_eq!(p.ap_z_mm.is_some(), axes.len() == 3);
            assert_eq!(p.ap_conformity, Some(Conformity::Conforming));
        }
        assert_eq!((found.drifts.len(), same.drifts.len()), (5, 5));
        let differs =
            |(d, e): (&Iso9283Drift, &Iso9283Drift)| (d.dap_mm - e.dap_mm).abs() + (d.drp_mm - e.drp_mm).abs();
        assert!(found.drifts.iter().zip(&same.drifts).map(differs).all(|d| d < 1e-9), "{:?}", found.drifts);
        assert!(!found.robot.coplanarity_of_four.is_empty() && found.recorded.visits[0].attained_mm[2].abs() > 1.0);
        assert!(judged(&shown, "largest pose accuracy", "pass"), "{shown}");
        let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
        assert!(html.contains("vAP"));
        assert!(html.contains("Positioning accuracy") && html.contains("7.2.3") && html.contains("id=\"streams\""));
    }
}

#[test]
fn what_is_wrong_with_the_tables_is_told_by_check_and_run_with_its_line() {
    for (file, from, to, parts) in [
        ("commanded.csv", "\n3,300,", "\n3,three hundred,", &["commanded.csv:4", "three hundred"][..]),
        ("commanded.csv", "\n3,300,", "\n2,300,", &["commanded.csv:4", "error[pose-commanded-twice] pose=2"]),
        ("commanded.csv", "\n5,", "\n6,", &["error[pose-not-commanded] pose=5", "poses.csv:10"]),
        ("poses.csv", "\n2,1,1,", "\n2,1,1.5,", &[]),
        ("poses.csv", "\n2,1,1,", "\n2,,1,", &["poses.csv", "cycle"]),
        ("reference.csv", "1,N4,", "1,N5,", &["reference.csv", "error[reference-targets-differ]"]),
        ("loads.csv", "+x,1,3,", "+x,1,-3,", &["loads.csv:3", "error[force-not-a-number]"]),
        ("loads.csv", "+x,1,0,", "+w,1,0,", &["loads.csv:2", "error[load-direction-unknown]"]),
        ("campaign.toml", "\"loads.csv\"", "\"no.csv\"", &["no.csv", "campaign.toml:"]),
        ("campaign.toml", "\"poses.csv\"", "\"../poses.csv\"", &["[path-outside]", "campaign.toml:"]),
        (
            "campaign.toml",
            "drift_set = 5 ",
            "drift_set = 1 ",
            &["error[drift-set-too-small]: `drift_set`", "campaign.toml:"],
        ),
        ("campaign.toml", "drift_set = 5 ", "drift_set = 40 ", &["drift: 0 sets", "campaign.toml:"]),
        ("campaign.toml", "drift_set", "drift_sett", &["[unknown-key]", "`drift_sett`", "drift_set"]),
        ("campaign.toml", "accuracy_max_mm = 0.400", "position_max_mm = 1", &["needs [identify]"]),
        ("campaign.toml", "reference = ", "output = ", &["[unknown-key]", "`output`"]),
    ] {
        let scratch = copy_sample("pose-test");
        let path = scratch.path().join(file);
        let whole = std::fs::read_to_string(&path).unwrap();
        assert!(whole.contains(from), "{file} has no {from}");
        std::fs::write(&path, whole.replacen(from, to, 1)).unwrap();
        for command in ["check", "run"].iter().filter(|_| !parts.is_empty()) {
            let refused = etalon(scratch.root(), &[command, "campaign"]);
            let said = text_of(&refused);
            assert_eq!(refused.status.code(), Some(2), "{command} {to}: {said}");
            parts.iter().for_each(|part| assert!(said.says(part), "{command}: no {part:?} in {said}"));
        }
    }
}

#[test]
fn what_is_wrong_with_commanded_poses_of_labels_is_told_with_its_line() {
    let good = "pose,x_mm,y_mm,z_mm\n1,95,117,42\n2,170,229,42\n3,20,229,42\n4,20,4,42\n5,170,4,42\n";
    for (from, to, parts) in [
        ("3,20,", "3,twenty,", &["positions.csv:4", "twenty"][..]),
        ("3,20,", "2,20,", &["positions.csv:4", "error[pose-commanded-twice] pose=2"]),
        ("3,20,229,42\n", "", &["positions.csv", "error[commanded-pose-missing]"]),
        ("pose,x_mm,y_mm,z_mm", "pose,x_mm,y_mm,a_deg", &["positions.csv", "error[commanded-angle-unmeasured]"]),
        (good, "", &["positions.csv", "error[data-rows-missing]"]),
    ] {
        let scratch = copy_sample("prexyt-repeatability");
        std::fs::write(scratch.path().join("positions.csv"), good.replacen(from, to, 1)).unwrap();
        scratch.replace("campaign.toml", "homing = ", "commanded = \"positions.csv\"\nhoming = ");
        for command in ["check", "run"] {
            let refused = etalon(scratch.root(), &[command, "campaign"]);
            let said = text_of(&refused);
            assert_eq!(refused.status.code(), Some(2), "{command} {to}: {said}");
            parts.iter().for_each(|part| assert!(said.says(part), "{command}: no {part:?} in {said}"));
        }
    }
    // what needs commanded poses says so
    for (from, to, part) in [
        ("homing = ", "drift_set = 10\nhoming = ", "error[drift-without-commanded]"),
        ("repeatability_max_mm", "accuracy_max_mm", "needs [repeatability] with `commanded`, or [poses]"),
        ("[limits]", "[poses]\nattained = \"a.csv\"\ncommanded = \"b.csv\"\n[limits]", "error[attained-poses-twice]"),
    ] {
        let scratch = copy_sample("prexyt-repeatability");
        scratch.replace("campaign.toml", from, to);
        let said = text_of(&etalon(scratch.root(), &["check", "campaign"]));
        assert!(said.says(part) && said.contains("campaign.toml:"), "{said}");
    }
}

/// A campaign with nothing but a name, an instrument and these sections.
fn alone(sections: &str) -> Scratch {
    let scratch = copy_sample("pose-test");
    for name in ["motion.csv", "path.csv"] {
        let from = if name == "motion.csv" { "exports/motion.csv" } else { name };
        std::fs::copy(format!("samples/prexyt-repeatability/{from}"), scratch.path().join(name)).unwrap();
    }
    let head = "name = \"alone\"\nrobot = \"robot.toml\"\n[instrument]\nname = \"arm\"\nexpanded_uncertainty_um = 20\ncoverage_factor = 2\n";
    std::fs::write(scratch.path().join("campaign.toml"), format!("{head}{sections}")).unwrap();
    scratch
}

#[test]
fn a_campaign_may_have_recorded_motions_or_loads_and_nothing_else() {
    let stream = "[[stream]]\nname = \"corner\"\nfile = \"motion.csv\"\npath = \"path.csv\"\n";
    let loads = "[compliance]\nfile = \"loads.csv\"\n";
    let planar = "[poses]\nattained = \"p.csv\"\ncommanded = \"c.csv\"\n";
    for (sections, ids, not) in [
        (stream, &["streams"][..], "repeatability"),
        (loads, &["compliance"], "streams"),
        (planar, &["accuracy", "repeatability"], "drift"),
    ] {
        let scratch = alone(sections);
        let table = "pose,cycle,robot,x_mm,y_mm\n1,1,A,0.1,0\n1,2,A,0.2,0\n1,3,A,0.1,0.1\n1,1,B,0.3,0\n1,2,B,0.3,0.1\n1,3,B,0.4,0\n";
        std::fs::write(scratch.path().join("p.csv"), table).unwrap();
        std::fs::write(scratch.path().join("c.csv"), "pose,x_mm,y_mm\n1,0,0\n").unwrap();
        let checked = etalon(scratch.root(), &["check", "campaign"]);
        assert!(checked.status.success(), "{}", text_of(&checked));
        ran(&scratch);
        let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
        ids.iter().for_each(|id| assert!(html.contains(&format!("id=\"{id}\"")), "{sections}: {id}"));
        assert!(!html.contains(&format!("id=\"{not}\"")), "{sections}: {not}");
        assert_eq!(html.contains("Exchangeability"), sections == planar);
        // a document that an earlier run left goes
        assert!(etalon(scratch.root(), &["report", "campaign/out"]).status.success());
        std::fs::copy(alone(loads).path().join("campaign.toml"), scratch.path().join("campaign.toml")).unwrap();
        ran(&scratch);
        let there = |name: &str| scratch.path().join("out").join(name).is_file();
        assert!(there("iso9283-compliance.json") && !there("iso9283.json") && !there("iso9283-streams.json"));
    }
}

/// A pose that was visited once has no repeatability, which is not a repeatability of zero.
#[test]
fn a_limit_that_a_pose_cannot_be_judged_by_is_an_error() {
    let tables = "[poses]\nattained = \"p.csv\"\ncommanded = \"c.csv\"\n";
    let scratch = alone(&format!("{tables}[limits]\nrepeatability_max_mm = 0.0001\n"));
    std::fs::write(scratch.path().join("p.csv"), "pose,cycle,x_mm,y_mm\n1,1,0.1,0\n").unwrap();
    std::fs::write(scratch.path().join("c.csv"), "pose,x_mm,y_mm\n1,0,0\n").unwrap();
    let done = etalon(scratch.root(), &["run", "campaign"]);
    assert_eq!(done.status.code(), Some(2), "{}", text_of(&done));
    assert!(text_of(&done).says("error[limit-without-value] limit=repeatability_max_mm pose=1"), "{}", text_of(&done));
}

#[test]
fn tests_of_poses_are_compared_over_campaigns() {
    let (first, second) = (copy_sample("pose-test"), copy_sample("pose-test"));
    let table = std::fs::read_to_string(second.path().join("commanded.csv")).unwrap();
    std::fs::write(second.path().join("commanded.csv"), table.replace("500,100,", "500.5,100,")).unwrap();
    second.replace("campaign.toml", "accuracy_max_mm = 0.400", "accuracy_max_mm = 0.8");
    ran(&first);
    ran(&second);
    let compared = etalon(first.root(), &["compare", "campaign", second.path().to_str().unwrap(), "--json"]);
    let said = text(&compared.stdout);
    assert!(compared.status.success() && said.contains("AP, pose 2") && said.contains("RP, pose 1"), "{said}");
}

#[test]
fn a_missed_limit_of_iso_9283_beside_an_identification_that_meets_its_own_is_missed_in_every_output() {
    let (scratch, poses) = (copy_sample("prexyt-cmm"), copy_sample("pose-test"));
    for table in ["poses.csv", "commanded.csv"] {
        std::fs::copy(poses.path().join(table), scratch.path().join(table)).unwrap();
    }
    let tables = "[poses]\nattained = \"poses.csv\"\ncommanded = \"commanded.csv\"\n\n[limits]";
    scratch.replace("campaign.toml", "[limits]", &format!("{tables}\naccuracy_max_mm = 0.001"));
    let done = etalon(scratch.root(), &["run", "campaign"]);
    let shown = text(&done.stdout);
    assert_eq!(done.status.code(), Some(1), "{shown}");
    for (limit, verdict) in [
        ("largest position error", "pass"),
        ("largest orientation error", "pass"),
        ("largest pose accuracy AP", "FAIL"),
    ] {
        assert!(judged(&shown, limit, verdict), "{limit}: {shown}");
    }
    let said = "1 of 3 limits of the campaign is not met. Decision rule: guarded acceptance (ILAC-G8:09/2019, 4.2.3).";
    assert!(shown.lines().any(|line| line == said), "{shown}");
    let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    let verdict = html.split_once("<section id=\"verdict\">").unwrap().1.split_once("</div>").unwrap().0;
    assert!(verdict.contains("box bad") && verdict.replace("&#x2f;", "/").contains(said), "{verdict}");
    assert!(html.has_phrase("limit-accuracy-max") && !html.has_phrase("limits-all-met"));
    if let Some(words) = text_of_pdf(&scratch.path().join("out/report.pdf")) {
        let first = words.split('\u{c}').next().unwrap();
        let begins = said.split(" (").next().unwrap();
        assert!(first.contains(begins) && !words.has_phrase("limits-all-met"), "{first}");
    }
    let mut book = workbook(&scratch);
    let summary = column(&mut book, "Summary", "value");
    assert!(matches!(&summary[0], Data::String(verdict) if verdict.contains(said)), "{summary:?}");
    let verdicts = column(&mut book, "Limits", "verdict");
    assert_eq!(verdicts, ["pass", "pass", "fail"].map(|text| Data::String(text.to_owned())));
    // made again from the documents, it says the same
    assert!(etalon(scratch.root(), &["report", "campaign/out"]).status.success());
    assert_eq!(std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap(), html);
}

/// Arguments of the command that evaluates what the campaign of a sample does, with this limit.
fn arguments<'a>(sample: &str, limit_mm: &'a str) -> Vec<&'a str> {
    let tables = match sample {
        "pose-test" => {
            "poses.csv --commanded commanded.csv --reference reference.csv --rp-limit-mm 0.1 --expanded-uncertainty-um 10 --ap-limit-mm"
        }
        _ => "visits.csv --commanded positions.csv --expanded-uncertainty-um 2.7 --rp-limit-mm",
    };
    let order =
        if sample == "pose-test" { &["--rotation-order", "Rz(c) Ry(b) Rx(a)", "--drift-set", "5"][..] } else { &[] };
    tables.split(' ').chain([limit_mm]).chain(order.iter().copied()).collect()
}

#[test]
fn a_campaign_and_the_command_give_one_verdict_of_the_same_data() {
    // conforming, undecided and not conforming; the command proves by intervals, and so does the campaign
    for (sample, key, limits) in [
        ("pose-test", "accuracy_max_mm = 0.400", ["0.4", "0.35", "0.2"]),
        ("prexyt-repeatability", "repeatability_max_mm = 0.040", ["0.04", "0.0145", "0.003"]),
    ] {
        for (limit_mm, verdict) in limits.into_iter().zip(["pass", "UNDECIDED", "FAIL"]) {
            let conforms = verdict == "pass";
            let scratch = copy_sample(sample);
            let name = key.split(' ').next().unwrap();
            scratch.replace("campaign.toml", key, &format!("{name} = {limit_mm}"));
            let run = etalon(scratch.root(), &["run", "campaign"]);
            let found: Iso9283Document = scratch.document("iso9283.json");
            if sample == "prexyt-repeatability" {
                as_tables(&scratch, &found, &[0, 1, 2]);
                let rows = (1..=5).map(|pose| format!("{pose},0,0,0\n")).collect::<String>();
                std::fs::write(scratch.path().join("positions.csv"), format!("pose,x_mm,y_mm,z_mm\n{rows}")).unwrap();
            }
            let command = arguments(sample, limit_mm);
            let done = etalon(&scratch.path(), &[&["iso9283"][..], &command].concat());
            let code = Some(i32::from(!conforms));
            assert_eq!((run.status.code(), done.status.code()), (code, code), "{sample} {limit_mm}");
            let mut same: serde_json::Value = answered(&scratch, &command);
            // drifts are in a document with the poses
            let same = if same.is_object() { same["poses"].take() } else { same };
            let same: Vec<Iso9283Pose> = serde_json::from_value(same).unwrap();
            for (p, q) in found.poses.iter().zip(&same) {
                assert_eq!((p.rp_conformity, p.quarter_rule_met), (q.rp_conformity, q.quarter_rule_met));
                assert!((p.rp_mm.unwrap() - q.rp_mm.unwrap()).abs() < 1e-9);
                assert!(sample != "pose-test" || (p.ap_conformity, p.ap_mm) == (q.ap_conformity, q.ap_mm));
            }
            let limit = found.limits.iter().find(|l| l.name.to_string() == name).unwrap();
            assert_eq!(limit.met, conforms, "{sample} {limit_mm}");
            // the name of a limit is as wide as the other columns let it be
            let of_limit = |row: &String| row.starts_with("largest pose") && row.contains(&format!(" {limit_mm} "));
            let shown = rows(&text(&run.stdout));
            assert!(shown.iter().any(|row| of_limit(row) && row.ends_with(verdict)), "{sample}: {shown:?}");
        }
    }
}

#[test]
fn a_worse_instrument_widens_the_intervals_and_proves_less() {
    let scratch = copy_sample("pose-test");
    let tables = ["poses.csv", "--commanded", "commanded.csv", "--rotation-order", "Rz(c) Ry(b) Rx(a)", "--all"];
    let with = |um: &str, limit_mm: &str| -> Iso9283Document {
        answered(&scratch, &[&tables[..], &["--expanded-uncertainty-um", um, "--ap-limit-mm", limit_mm]].concat())
    };
    let limit_mm = with("10", "1").poses[0].ap_interval.unwrap().high_mm + 0.001;
    let [fine, coarse] = ["10", "90"].map(|um| with(um, &limit_mm.to_string()).poses.swap_remove(0));
    let (a, b, ap) = (fine.ap_interval.unwrap(), coarse.ap_interval.unwrap(), fine.ap_mm.unwrap());
    // both ends by hand: sampling and instrument as the root of the sum of squares
    let sampling = ((a.high_mm - ap).powi(2) - 0.010f64.powi(2)).sqrt();
    assert!((b.high_mm - (ap + sampling.hypot(0.090))).abs() < 1e-12, "{a:?} {b:?}");
    assert!(b.low_mm < a.low_mm && coarse.rp_interval.unwrap().low_mm < fine.rp_interval.unwrap().low_mm);
    assert_eq!(fine.ap_conformity, Some(Conformity::Conforming));
    assert_eq!(coarse.ap_conformity, Some(Conformity::Neither));
}
