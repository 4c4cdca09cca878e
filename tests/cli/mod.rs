//! The command line: what README.md and docs/ show is what the program prints, and every command does what it says.

mod actions;
mod axes;
mod axis_table;
mod benchmark;
mod book;
mod bounds;
mod cell;
mod checklist;
mod compare;
mod compensate;
mod controller_files;
mod fit;
mod five_bar;
mod given;
mod in_memory;
mod iso230;
mod iso9283;
mod iso9283_campaign;
mod iso9283_commands;
mod iso9283_poses;
mod kinematics;
mod loaded;
mod numbers;
mod plan;
mod plan_generate;
mod platforms;
mod report;
mod reports;
mod robot;
mod selftest;
mod shown;
mod streams;
mod study;
mod tables;
mod talk;
mod tracim;
mod verdict;
mod verified;
mod view;

use crate::support::root;
use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use etalon::base::catalogue::IntoArgument;
use std::path::Path;
use std::process::{Command, Output};

#[test]
fn transcripts() {
    trycmd::TestCases::new()
        .register_bin("etalon", Path::new(crate::support::program()))
        .case("README.md")
        .case("docs/*.md");
}

fn etalon(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(crate::support::program()).args(arguments).current_dir(folder).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Rows of the tables of a terminal, a blank between cells.
fn rows(shown: &str) -> Vec<String> {
    shown.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

/// Whether the table of limits has a verdict on a limit.
fn judged(shown: &str, limit: &str, verdict: &str) -> bool {
    rows(shown).iter().any(|row| row.starts_with(&format!("{limit} ")) && row.ends_with(&format!(" {verdict}")))
}

/// Schemas that `etalon init mine` writes for editors.
const SCHEMAS: &str = "mine/schemas/campaign.toml.schema.json\nmine/schemas/robot.toml.schema.json\n";

/// The files for an editor name schemas that exist and that the program contains.
#[test]
fn init_names_the_schemas_of_its_files() {
    let folder = tempfile::tempdir().unwrap();
    for options in [&["init", "mine", "--synthetic"][..], &["init", "arm", "--robot", "ur5e"]] {
        assert!(etalon(folder.path(), options).status.success());
        for name in ["campaign.toml", "robot.toml"] {
            let campaign = folder.path().join(options[1]);
            let text = std::fs::read_to_string(campaign.join(name)).unwrap();
            let schema = text.lines().next().and_then(|line| line.strip_prefix("#:schema ./")).expect("a first line");
            let stated = std::fs::read(campaign.join(schema)).unwrap();
            assert!(stated == etalon(folder.path(), &["schema", name]).stdout, "{schema}");
        }
    }
}

#[test]
fn init_takes_the_robot_of_a_urdf() {
    let folder = tempfile::tempdir().unwrap();
    let urdf = root().join("samples/column-arm/arm.urdf");
    let made = etalon(folder.path(), &["init", "mine", "--urdf", urdf.to_str().unwrap()]);
    assert_eq!(
        text(&made.stdout),
        format!("mine/campaign.toml\nmine/robot.toml\nmine/arm.urdf\n{SCHEMAS}"),
        "{}",
        text(&made.stderr)
    );
    let robot = std::fs::read_to_string(folder.path().join("mine/robot.toml")).unwrap();
    assert!(robot.contains("base_link = \"base_link\"") && robot.contains("tool_link = \"tool\""), "{robot}");
    // as written it lacks only its files; with the files of the sample, whose labels match, it is calibrated
    let checked = etalon(folder.path(), &["check", "mine"]);
    let said = text(&checked.stderr);
    assert!(
        checked.status.code() == Some(2)
            && said.lines().filter(|l| l.starts_with("error")).count() == said.matches("error[input-missing]").count(),
        "{said}"
    );
    std::fs::create_dir(folder.path().join("mine/exports")).unwrap();
    let sample = urdf.parent().unwrap();
    std::fs::copy(sample.join("exports/poses.txt"), folder.path().join("mine/exports/poses.csv")).unwrap();
    std::fs::copy(sample.join("encoders.csv"), folder.path().join("mine/joints.csv")).unwrap();
    let campaign = folder.path().join("mine/campaign.toml");
    let in_metres = std::fs::read_to_string(&campaign).unwrap().replace("unit = \"mm\"", "unit = \"m\" ");
    std::fs::write(&campaign, in_metres).unwrap();
    let checked = etalon(folder.path(), &["check", "mine"]);
    assert_eq!(checked.status.code(), Some(0), "{}", text(&checked.stderr));
    let not_one = etalon(folder.path(), &["init", "other", "--urdf", "mine/robot.toml"]);
    assert!(not_one.status.code() == Some(2) && !folder.path().join("other").exists(), "{}", text(&not_one.stderr));
    let joint = |name: &str, [parent, child]: [&str; 2]| {
        format!(
            "<joint name=\"{name}\" type=\"revolute\"><parent link=\"{parent}\"/><child link=\"{child}\"/></joint>\n"
        )
    };
    let ring = [joint("one", ["a", "b"]), joint("two", ["b", "a"])].concat();
    let ring = format!("<robot name=\"ring\">\n<link name=\"a\"/><link name=\"b\"/>\n{ring}</robot>\n");
    std::fs::write(folder.path().join("ring.urdf"), ring).unwrap();
    let said = text(&etalon(folder.path(), &["init", "ring", "--urdf", "ring.urdf"]).stderr);
    assert!(said.contains("[urdf-loop]") && said.contains("ring.urdf:3:1"), "{said}");
}

/// Every robot of the table has a campaign that lacks its files alone.
#[test]
fn init_has_the_geometry_of_robots() {
    let folder = tempfile::tempdir().unwrap();
    let unknown = text(&etalon(folder.path(), &["init", "x", "--robot", "ur6"]).stderr);
    let names = unknown
        .lines()
        .find_map(|line| line.split_once("expected: ").map(|(_, names)| names))
        .expect("names")
        .to_owned();
    assert!(names.split(", ").count() >= 19, "{names}");
    for name in names.split(", ") {
        let made = etalon(folder.path(), &["init", name, "--robot", name]);
        assert!(made.status.success(), "{}", text(&made.stderr));
        let robot = std::fs::read_to_string(folder.path().join(name).join("robot.toml")).unwrap();
        assert!(robot.contains("# Source: "), "{robot}");
        let said = text(&etalon(folder.path(), &["check", name]).stderr);
        let errors: Vec<&str> = said.lines().filter(|l| l.starts_with("error")).collect();
        assert!(errors.len() == 2 && errors.iter().all(|e| e.contains("[input-missing]")), "{name}: {said}");
    }
    let joints = "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,0,0,0,0,0,0\n2,20,-30,40,50,-60,70\n";
    std::fs::write(folder.path().join("q.csv"), joints).unwrap();
    let poses = |robot: &str| -> Vec<Vec<f64>> {
        let csv = text(&etalon(folder.path(), &["kinematics", "direct", "q.csv", "--robot", robot]).stdout);
        csv.lines().skip(1).map(|line| line.split(',').map(|v| v.parse().unwrap()).collect()).collect()
    };
    let near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    // a2 + a3, d4 + d6 and d1 - d5
    let ur5e = &poses("ur5e/robot.toml")[0];
    assert!(near(&ur5e[1..4], &[-817.2, -232.9, 62.8]), "{ur5e:?}");
    // the axes of the URDF and the table by the drawing
    let drawn = root().join("samples/abb-irb120/robot.toml");
    let (urdf, drawn) = (poses("irb120/robot.toml"), poses(drawn.to_str().unwrap()));
    assert!(urdf.iter().zip(&drawn).all(|(a, b)| near(&a[1..4], &b[1..4])), "{urdf:?} {drawn:?}");
    let Some(arm) = crate::reference_data("robots/hilti_column") else { return };
    // the same arm as its user has it, with quarter turns rounded to 0.2 mrad
    let robot = format!(
        "model = \"urdf\"\nfile = '{}'\nbase_link = \"dsr_base_0\"\ntool_link = \"dsr_link6\"\n",
        arm.join("trailblazer.urdf").display()
    );
    std::fs::write(folder.path().join("doosan.toml"), robot).unwrap();
    let named: Vec<String> = (1..=6).map(|i| format!("dsr_joint{i}_deg")).collect();
    let renamed = joints.replace("q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg", &named.join(","));
    let table = poses("m1013/robot.toml");
    std::fs::write(folder.path().join("q.csv"), renamed).unwrap();
    let (urdf, near) = (poses("doosan.toml"), |a: f64, b: f64| (a - b).abs() < 1.0);
    assert!(urdf.iter().zip(&table).all(|(a, b)| (1..4).all(|i| near(a[i], b[i]))), "{urdf:?} {table:?}");
}

#[test]
fn init_writes_a_campaign_that_only_lacks_its_files() {
    let folder = tempfile::tempdir().unwrap();
    let made = etalon(folder.path(), &["init", "mine"]);
    assert_eq!(text(&made.stdout), format!("mine/campaign.toml\nmine/robot.toml\n{SCHEMAS}"));
    let checked = etalon(folder.path(), &["check", "mine"]);
    let said = text(&checked.stderr);
    assert_eq!(checked.status.code(), Some(2));
    let errors: Vec<&str> = said.lines().filter(|l| l.starts_with("error")).collect();
    assert_eq!(errors.len(), 3, "{said}");
    assert!(errors.iter().all(|e| e.contains("[input-missing]") && e.contains("`mine/")), "{said}");
    // it never writes over a campaign
    let again = etalon(folder.path(), &["init", "mine"]);
    assert_eq!(again.status.code(), Some(2));
    assert!(text(&again.stderr).contains("error[file-exists]"));
}

#[test]
fn a_synthetic_campaign_simulates_checks_and_runs() {
    let folder = tempfile::tempdir().unwrap();
    let done = |arguments: &[&str]| {
        let output = etalon(folder.path(), arguments);
        assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
        text(&output.stdout)
    };
    let written = format!("mine/campaign.toml\nmine/robot.toml\nmine/truth.toml\n{SCHEMAS}");
    assert_eq!(done(&["init", "--synthetic", "mine"]), written);
    assert_eq!(done(&["simulate", "mine"]), "exports/world.txt\nexports/poses.txt\nencoders.csv\n");
    // the template's dialect: a header row, and 29 poses of K and L in 3 repeats below it
    let checked = done(&["check", "mine"]);
    assert!(checked.contains(
        "exports/poses.txt: 174 rows, 0 rejected ({ delimiter = \";\", decimal = \",\", header = 1, columns"
    ));
    let ran = done(&["run", "mine"]);
    assert!(judged(&ran, "largest position error", "pass") && ran.contains("calibration: 8 poses, 24 errors"), "{ran}");
    // what `formats` proposes for the simulated file is what the campaign states
    let proposed = done(&["formats", "mine/exports/poses.txt"]);
    let stated =
        "format = { delimiter = \";\", decimal = \",\", header = 1, columns = [\"label\", \"x\", \"y\", \"z\"] }";
    assert!(proposed.contains(stated), "{proposed}");
}

#[test]
fn simulate_writes_over_no_measured_campaign() {
    let folder = tempfile::tempdir().unwrap();
    assert!(etalon(folder.path(), &["init", "mine"]).status.success());
    std::fs::copy("samples/prexyt-cmm/truth.toml", folder.path().join("mine/truth.toml")).unwrap();
    let refused = etalon(folder.path(), &["simulate", "mine"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text_of(&refused).contains("[campaign-not-synthetic]"));
    assert!(!folder.path().join("mine/encoders.csv").exists());
}

/// What a command answers with `--json`, as the document that its schema describes.
fn answer<T: serde::de::DeserializeOwned>(folder: &Path, arguments: &[&str], code: i32) -> T {
    let output = etalon(folder, arguments);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{arguments:?}: {e}: {}", text(&output.stdout)))
}

#[test]
fn every_command_that_answers_does_so_in_json() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let files = |arguments: &[&str]| answer::<etalon::documents::WrittenDocument>(at, arguments, 0).files;
    let written = files(&["init", "--synthetic", "c", "--json"]);
    assert_eq!(written[..3], ["c/campaign.toml", "c/robot.toml", "c/truth.toml"]);
    assert_eq!(written[3..], SCHEMAS.replace("mine/", "c/").lines().collect::<Vec<_>>());
    assert_eq!(files(&["simulate", "c", "--json"]), ["exports/world.txt", "exports/poses.txt", "encoders.csv"]);
    answer::<etalon::documents::AccuracyDocument>(at, &["run", "c", "--json"], 0);
    let mut reports = vec!["c/out/report.html", "c/out/report.pdf", "c/out/report.xlsx"];
    reports.retain(|name| cfg!(feature = "pdf") || !name.ends_with("pdf"));
    assert_eq!(files(&["report", "c/out", "--json"]), reports);
    let exported = files(&["export", "c/out/parameters.json", "--format", "csv", "--to", "k", "--json"]);
    assert_eq!(exported, ["k/controller.csv"]);
    let formats: etalon::documents::FormatsDocument = answer(at, &["formats", "c/exports/poses.txt", "--json"], 0);
    let best = &formats.readings[0];
    assert_eq!((best.delimiter.as_deref().unwrap_or(""), best.decimal.as_str(), best.header), (";", ",", 1));
    assert_eq!(best.columns, ["label", "x", "y", "z"]);
    assert!(formats.toml.contains("unit = \"?\""));
    let schema: serde_json::Value = answer(at, &["schema", "check", "--json"], 0);
    assert_eq!(schema["title"], "CheckDocument");
}

#[test]
fn check_answers_in_json_what_is_right_and_what_is_wrong() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("exports/world.txt", "rail2_b ", "rail2_z ");
    let check =
        |code| answer::<etalon::documents::CheckDocument>(scratch.root(), &["check", "campaign", "--json"], code);
    let found = check(2);
    let [error] = &found.errors[..] else { panic!("{found:?}") };
    assert_eq!((error.id.as_str(), error.what.contains("`rail2_b`")), ("label-unknown", true));
    assert_eq!(error.file.as_deref(), Some("campaign/campaign.toml"));
    assert_eq!((error.line, error.column), (Some(31), Some(21)));
    assert_eq!(error.text.as_deref(), Some("plane = [\"rail2_a\", \"rail2_b\", \"rail3_a\"]"));
    assert!(error.hint.as_deref().is_some_and(|h| h.starts_with("did you mean `rail2_")), "{error:?}");
    // errors of the TOML file and of its data together
    scratch.replace("campaign.toml", "coverage_factor = 2", "coverage_factor = \"two\"");
    let found = check(2);
    let wrong = found.errors.iter().find(|e| e.line == Some(8)).unwrap();
    assert_eq!(wrong.expected.as_deref(), Some("a number"));
    // a label that nothing uses is a warning
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("exports/poses.txt", "K_1_1 ", "K_1_1_x ");
    let found = answer::<etalon::documents::CheckDocument>(scratch.root(), &["check", "campaign", "--json"], 0);
    assert!(found.errors.is_empty());
    let [warning, lacking] = &found.warnings[..] else { panic!("{found:?}") };
    assert_eq!((lacking.id.as_str(), &lacking.arguments["poses"]), ("targets-missing", &"1".argument()), "{lacking:?}");
    assert_eq!((warning.file.as_deref(), warning.line), (Some("exports/poses.txt"), Some(1)));
    assert_eq!(found.sources.iter().map(|s| s.rows_read).collect::<Vec<_>>(), [0, 0, 25, 590, 295]);
    // no campaign at all is an answer too
    let found = answer::<etalon::documents::CheckDocument>(scratch.root(), &["check", "nowhere", "--json"], 2);
    assert_eq!(found.errors[0].id, "campaign-missing", "{found:?}");
}

#[test]
fn formats_proposes_and_asks() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("p.txt"), "Name;X;Y;Z\nK_1_1;1,25;2,5;-3,75\n").unwrap();
    let proposed = etalon(folder.path(), &["formats", "p.txt"]);
    let said = text(&proposed.stdout);
    assert!(said.contains("format = { delimiter = \";\", decimal = \",\", header = 1,"), "{said}");
    assert!(said.contains("unit = \"?\""), "{said}");

    // a unit in the header is the file's, and another one is refused
    std::fs::write(folder.path().join("p.txt"), "Name;X [in];Y [in];Z [in]\nK;1.25;2.5;-3.75\n").unwrap();
    let said = text(&etalon(folder.path(), &["formats", "p.txt"]).stdout);
    assert!(said.contains("unit = \"inch\"") && !said.contains("QUESTION: the unit"), "{said}");
    let table = [
        "fit",
        "line",
        "p.txt",
        "--delimiter",
        "semicolon",
        "--header",
        "1",
        "--columns",
        "label,x,y,z",
        "--unit",
        "mm",
    ];
    let refused = etalon(folder.path(), &table);
    assert!(text(&refused.stderr).says("error[unit-differs] of_file=inch how=X [in]"), "{}", text(&refused.stderr));

    // a number before the coordinates is none of them, and what is not read is told
    std::fs::write(folder.path().join("p.txt"), "1 10.1 20.2 30.3\n2 10.5 20.5 30.5\n").unwrap();
    let said = text(&etalon(folder.path(), &["formats", "p.txt"]).stdout);
    assert!(said.contains("columns = [\"-\", \"x\", \"y\", \"z\"]"), "{said}");
    assert!(said.has_phrase("doubt-columns-not-read columns=1"), "{said}");
}

#[test]
fn identify_answers_in_json_without_a_campaign() {
    let scratch = copy_sample("prexyt-cmm");
    assert!(etalon(scratch.root(), &["run", "campaign"]).status.success());
    let answered = etalon(
        scratch.root(),
        &[
            "identify",
            "--robot",
            "campaign/robot.toml",
            "--observations",
            "campaign/out/observations.csv",
            "--standard-uncertainty-um",
            "1.35",
            "--hold",
            "bet*",
            "--json",
        ],
    );
    assert!(answered.status.success(), "{}", text(&answered.stderr));
    let document: etalon::documents::ParametersDocument = serde_json::from_slice(&answered.stdout).unwrap();
    assert_eq!(document.parameters[0].name, "beta");
    assert_eq!(document.parameters[0].status, etalon::documents::ParameterStatus::Fixed);
    assert_eq!(document.covariance.len(), 13);
    assert_eq!(document.provenance.inputs.len(), 2);
}

#[test]
fn export_writes_every_format_from_the_document() {
    let scratch = copy_sample("prexyt-cmm");
    assert!(etalon(scratch.root(), &["run", "campaign"]).status.success());
    let arguments = ["export", "campaign/out/parameters.json", "--robot", "campaign/robot.toml", "--to", "controller"];
    let exported = etalon(scratch.root(), &arguments);
    assert!(exported.status.success(), "{}", text(&exported.stderr));
    for file in ["controller.json", "controller.csv", "etalon_parameters.h"] {
        let again = std::fs::read(scratch.root().join("controller").join(file)).unwrap();
        assert!(again == std::fs::read(scratch.path().join("out").join(file)).unwrap(), "{file}");
    }
    let wrong = etalon(scratch.root(), &["export", "campaign/out/parameters.json", "--format", "jsn"]);
    assert!(text(&wrong.stderr).has_phrase("did-you-mean name=json"));
}

#[test]
fn a_campaign_without_its_variable_is_skipped_only_when_asked() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "exports/poses.txt", "$ETALON_NO_SUCH_VARIABLE/poses.txt");
    let refused = etalon(scratch.root(), &["run", "campaign"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("[environment-missing]"));
    let skipped = etalon(scratch.root(), &["run", "--skip-missing", "campaign"]);
    assert!(skipped.status.success() && text(&skipped.stderr).starts_with("skipped: "));
}

#[test]
fn wrong_arguments_are_exit_code_two() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in [&["fly"][..], &["run"], &["run", "nowhere"], &["schema", "parmeters"], &["report", "nowhere"]] {
        let output = etalon(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{arguments:?}");
    }
}

#[test]
fn fit_answers_with_its_unit_and_uncertainty() {
    let folder = tempfile::tempdir().unwrap();
    // NPL-like: points of a sphere of radius 2 inch about (1, 2, 3) inch, in inches, with names
    let mut text = String::new();
    for i in 0..20 {
        let (a, b) = (0.7 * f64::from(i), 0.31 * f64::from(i));
        let p = [1.0 + 2.0 * a.cos() * b.cos(), 2.0 + 2.0 * a.sin() * b.cos(), 3.0 + 2.0 * b.sin()];
        text += &format!("ball;{:.9};{:.9};{:.9}\n", p[0], p[1], p[2]);
    }
    std::fs::write(folder.path().join("s.txt"), &text).unwrap();
    let options = ["--delimiter", "semicolon", "--columns", "label,x,y,z"];
    let run = |rest: &[&str]| {
        let arguments: Vec<&str> = ["fit", "sphere", "s.txt"].iter().chain(&options).chain(rest).copied().collect();
        etalon(folder.path(), &arguments)
    };
    let refused = run(&[]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text_of(&refused).says("error[option-unit-missing]"));
    let answered = run(&["--unit", "inch", "--json"]);
    let document: etalon::documents::FitDocument = serde_json::from_slice(&answered.stdout).unwrap();
    assert_eq!((document.element.as_str(), document.points), ("sphere", 20));
    assert!((document.geometry.radius_mm.unwrap() - 50.8).abs() < 1e-6, "{document:?}");
    let center = document.geometry.center_mm.unwrap();
    assert!(center.iter().zip([25.4, 50.8, 76.2]).all(|(c, e)| (c - e).abs() < 1e-6), "{center:?}");
    assert!(document.standard_uncertainty.unwrap().radius_mm.unwrap() < 1e-6);
    let listed = run(&["--unit", "inch", "--json", "--by-label"]);
    let documents: Vec<etalon::documents::FitDocument> = serde_json::from_slice(&listed.stdout).unwrap();
    assert_eq!(documents[0].label.as_deref(), Some("ball"));
}

#[test]
fn a_minimum_zone_names_the_points_that_hold_it() {
    let folder = tempfile::tempdir().unwrap();
    // corners of a tent 2 mm high on a base of 30 mm x 20 mm, and a point inside
    std::fs::write(folder.path().join("tent.txt"), "0 0 0\n30 0 0\n10 8 1\n0 20 0\n12 9 2\n").unwrap();
    let answered = etalon(folder.path(), &["fit", "plane", "tent.txt", "--unit", "mm", "--minimum-zone", "--json"]);
    let document: etalon::documents::FitDocument = serde_json::from_slice(&answered.stdout).unwrap();
    assert!(
        (document.deviations.form_mm - 2.0).abs() < 1e-12 && (document.deviations.max_mm - 1.0).abs() < 1e-12,
        "{document:?}"
    );
    let contacts = document.deviations.contacts.unwrap();
    assert!(contacts.verified && contacts.upper == [5] && contacts.lower == [1, 2, 4], "{contacts:?}");
    let shown = etalon(folder.path(), &["fit", "plane", "tent.txt", "--unit", "mm", "--minimum-zone"]);
    assert!(text(&shown.stdout).contains("points 5 and 1 2 4"), "{}", text(&shown.stdout));
    // two poles outside, three points of the equator inside: radii 10.1 and 9.9
    let equator = "9.9 0 0\n-4.95 8.573651497465942 0\n-4.95 -8.573651497465942 0\n";
    std::fs::write(folder.path().join("ball.txt"), format!("0 0 10.1\n0 0 -10.1\n{equator}")).unwrap();
    let answered = etalon(folder.path(), &["fit", "sphere", "ball.txt", "--unit", "mm", "--minimum-zone", "--json"]);
    let document: etalon::documents::FitDocument = serde_json::from_slice(&answered.stdout).unwrap();
    assert!(
        (document.deviations.form_mm - 0.2).abs() < 1e-12
            && (document.geometry.radius_mm.unwrap() - 10.0).abs() < 1e-12
    );
    let contacts = document.deviations.contacts.unwrap();
    assert!(contacts.verified && contacts.upper == [1, 2] && contacts.lower == [3, 4, 5], "{contacts:?}");
    let multipliers = contacts.multipliers.unwrap();
    assert!(multipliers.upper.iter().all(|l| (l - 0.5).abs() < 1e-12), "{multipliers:?}");
    assert!(multipliers.lower.iter().all(|l| (l - 1.0 / 3.0).abs() < 1e-12), "{multipliers:?}");
    for element in ["torus", "enclosing-circle"] {
        let refused = etalon(folder.path(), &["fit", element, "tent.txt", "--unit", "mm", "--minimum-zone"]);
        assert_eq!(refused.status.code(), Some(2));
        assert!(text_of(&refused).contains("hint:"), "{}", text_of(&refused));
    }
}

fn text_of(output: &Output) -> String {
    text(&output.stderr)
}

#[test]
fn iso9283_answers_with_a_list_per_pose_and_leaves_out_what_a_robot_does_not_have() {
    let folder = tempfile::tempdir().unwrap();
    let mut poses = "pose,cycle,x_mm,y_mm,c_deg\n".to_owned();
    for cycle in 1..=4 {
        // about (0.3, 0.4) from where it was sent, one of the four corners of a cross of 0.1 mm
        let (dx, dy) = [(0.1, 0.0), (0.0, 0.1), (-0.1, 0.0), (0.0, -0.1)][cycle - 1];
        poses +=
            &format!("1,{cycle},{},{},{}\n", 100.3 + dx, 200.4 + dy, if cycle % 2 == 0 { 179.99 } else { -179.99 });
        poses += &format!("2,{cycle},{},0,0\n", 500.0 + dx);
    }
    std::fs::write(folder.path().join("poses.csv"), &poses).unwrap();
    std::fs::write(folder.path().join("commanded.csv"), "pose,x_mm,y_mm,c_deg\n1,100,200,180\n2,500,0,0\n").unwrap();
    let run = |rest: &[&str]| {
        let fixed = ["iso9283", "poses.csv", "--commanded", "commanded.csv"];
        etalon(folder.path(), &fixed.iter().chain(rest).copied().collect::<Vec<_>>())
    };
    let answered = run(&["--json"]);
    assert!(answered.status.success(), "{}", text_of(&answered));
    let list: Vec<serde_json::Value> = serde_json::from_slice(&answered.stdout).unwrap();
    let near = |key: &str, expected: f64| assert!((list[0][key].as_f64().unwrap() - expected).abs() < 1e-9, "{key}");
    assert_eq!(list.len(), 2);
    for (key, expected) in [
        ("ap_mm", 0.5),
        ("ap_x_mm", 0.3),
        ("ap_y_mm", 0.4),
        ("rp_mm", 0.1),
        ("mean_radius_mm", 0.1),
        ("sd_radius_mm", 0.0),
        ("enclosing_radius_mm", 0.1),
        ("ap_c_deg", 0.0),
        ("rp_c_deg", 3.0 * 0.02 / 3f64.sqrt()),
    ] {
        near(key, expected);
    }
    assert!(["ap_z_mm", "rp_z_mm", "ap_a_deg", "rp_b_deg"].iter().all(|key| list[0].get(key).is_none()));

    let all = run(&["--json", "--all", "--expanded-uncertainty-um", "30"]);
    // 30 µm are more than a quarter of 0.1 mm
    let said = text(&all.stderr);
    assert!(all.status.success() && said.says("warning[instrument-too-coarse] count=2 poses=1, 2"), "{said}");
    let document: etalon::documents::Iso9283Document = serde_json::from_slice(&all.stdout).unwrap();
    assert_eq!((document.distances[0].poses, document.distances[0].cycles), ([1.into(), 2.into()], 4));
    assert!(document.conventions.iter().any(|c| c.english().has_phrase("convention-angles-of-unknown-order")));
    // pose 2 has no AP to verify
    let said = text(&run(&["--expanded-uncertainty-um", "25"]).stderr);
    assert!(said.contains("warning[instrument-too-coarse]"), "{said}");

    for (from, to, said) in [
        ("1,2,", "1,1,", "error[pose-attained-twice] pose=1"),
        ("1,2,", "7,2,", "error[pose-not-commanded] pose=7"),
        ("100.3,", ",", "error[coordinate-missing]"),
        ("x_mm", "x", "error[column-unknown]"),
        ("c_deg", "b_deg", "error[coordinates-differ]"),
    ] {
        std::fs::write(folder.path().join("poses.csv"), poses.replacen(from, to, 1)).unwrap();
        let refused = run(&[]);
        assert_eq!(refused.status.code(), Some(2), "{said}");
        assert!(refused.stdout.is_empty() && text_of(&refused).says(said), "{}", text_of(&refused));
    }
}

/// Only a run can show the errors that no reading shows, and each has a line.
#[test]
fn check_lists_what_no_reading_can_show() {
    let scratch = copy_sample("prexyt-cmm");
    let checked = etalon(scratch.root(), &["check", "campaign", "--json"]);
    let checked: serde_json::Value = serde_json::from_slice(&checked.stdout).unwrap();
    let ran = etalon(scratch.root(), &["run", "campaign"]);
    assert!(ran.status.code().is_some_and(|code| code < 2), "{}", text_of(&ran));
    let frames = std::fs::read(scratch.path().join("out/frames.json")).unwrap();
    let frames: serde_json::Value = serde_json::from_slice(&frames).unwrap();
    let listed = checked["not_controlled"].as_array().unwrap();
    assert!(!listed.is_empty() && checked["not_controlled"] == frames["not_controlled"], "{checked}");
    let said = text(&etalon(scratch.root(), &["check", "campaign"]).stdout);
    assert_eq!(said.matches("[frame.world] nominal_mm").count(), 1, "{said}");
}

#[test]
fn a_test_of_repeatability_runs_without_identifying_and_its_report_is_made_again() {
    let scratch = copy_sample("prexyt-repeatability");
    let ran = etalon(scratch.root(), &["run", "campaign"]);
    assert!(ran.status.success(), "{}", text_of(&ran));
    let said = text(&ran.stdout);
    for part in ["exceeds 25 % of RP at every pose", "from the plane of the other three"] {
        assert!(said.says(part), "{part}: {said}");
    }
    assert!(rows(&said).iter().any(|row| row.starts_with("homing ") && row.contains("10 1.6 0.0 to 2.7")), "{said}");
    assert!(judged(&said, "5", "not met") && judged(&said, "largest pose repeatability RP", "pass"), "{said}");
    let report = scratch.path().join("out/report.html");
    let first = std::fs::read(&report).unwrap();
    assert!(text(&first).contains("from pose 5 (29)") && text(&first).contains("Synthetic data"));
    std::fs::remove_file(&report).unwrap();
    assert!(etalon(scratch.root(), &["report", "campaign/out"]).status.success());
    assert!(std::fs::read(&report).unwrap() == first);
    let json = etalon(scratch.root(), &["run", "campaign", "--json"]);
    let document: etalon::documents::Iso9283Document = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!((document.recorded.visits.len(), document.poses.len()), (240, 5));

    scratch.replace("campaign.toml", "repeatability_max_mm = 0.040", "repeatability_max_mm = 0.010");
    assert_eq!(etalon(scratch.root(), &["run", "campaign"]).status.code(), Some(1));
    let checked = etalon(scratch.root(), &["check", "campaign"]);
    assert!(
        checked.status.success() && text(&checked.stdout).has_phrase("check-verdict warnings=0"),
        "{}",
        text_of(&checked)
    );
}
