//! The command line: what README.md shows is what the program prints, and every command does what it says.

use crate::scratch::copy_sample;
use std::path::Path;
use std::process::{Command, Output};

#[test]
fn transcripts() {
    trycmd::TestCases::new().case("README.md");
}

fn etalon(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_etalon")).args(arguments).current_dir(folder).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn init_writes_a_campaign_that_only_lacks_its_files() {
    let folder = tempfile::tempdir().unwrap();
    let made = etalon(folder.path(), &["init", "mine"]);
    assert_eq!(text(&made.stdout), "mine/campaign.toml\nmine/robot.toml\n");
    let checked = etalon(folder.path(), &["check", "mine"]);
    let said = text(&checked.stderr);
    assert_eq!(checked.status.code(), Some(2));
    let errors: Vec<&str> = said.lines().filter(|l| l.starts_with("error: ")).collect();
    assert_eq!(errors.len(), 3, "{said}");
    assert!(errors.iter().all(|e| e.starts_with("error: there is no file `mine/")), "{said}");
    // it never writes over a campaign
    let again = etalon(folder.path(), &["init", "mine"]);
    assert_eq!(again.status.code(), Some(2));
    assert!(text(&again.stderr).contains("is there already"));
}

#[test]
fn formats_proposes_and_asks() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("p.txt"), "Name;X;Y;Z\nK_1_1;1,25;2,5;-3,75\n").unwrap();
    let proposed = etalon(folder.path(), &["formats", "p.txt"]);
    let said = text(&proposed.stdout);
    assert!(said.contains("format = { delimiter = \";\", decimal = \",\", header = 1,"), "{said}");
    assert!(said.contains("unit = \"?\""), "{said}");
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
    let document: etalon::document::ParametersDocument = serde_json::from_slice(&answered.stdout).unwrap();
    assert_eq!(document.parameters[0].name, "beta");
    assert_eq!(document.parameters[0].status, etalon::document::ParameterStatus::Fixed);
    assert_eq!(document.covariance.len(), 13);
    assert_eq!(document.provenance.inputs.len(), 2);
}

#[test]
fn export_writes_every_format_from_the_document() {
    let scratch = copy_sample("prexyt-cmm");
    assert!(etalon(scratch.root(), &["run", "campaign"]).status.success());
    let exported = etalon(scratch.root(), &["export", "campaign/out/parameters.json", "--to", "controller"]);
    assert!(exported.status.success(), "{}", text(&exported.stderr));
    for file in ["controller.json", "controller.csv", "etalon_parameters.h"] {
        let again = std::fs::read(scratch.root().join("controller").join(file)).unwrap();
        assert!(again == std::fs::read(scratch.path().join("out").join(file)).unwrap(), "{file}");
    }
    let wrong = etalon(scratch.root(), &["export", "campaign/out/parameters.json", "--format", "jsn"]);
    assert!(text(&wrong.stderr).contains("did you mean `json`?"));
}

#[test]
fn a_campaign_without_its_variable_is_skipped_only_when_asked() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "exports/poses.txt", "$ETALON_NO_SUCH_VARIABLE/poses.txt");
    let refused = etalon(scratch.root(), &["run", "campaign"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("the environment has no `ETALON_NO_SUCH_VARIABLE`"));
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
    assert!(text_of(&refused).contains("never guessed"));
    let answered = run(&["--unit", "inch", "--json"]);
    let document: etalon::document::FitDocument = serde_json::from_slice(&answered.stdout).unwrap();
    assert_eq!((document.element.as_str(), document.points), ("sphere", 20));
    assert!((document.radius_mm.unwrap() - 50.8).abs() < 1e-6, "{document:?}");
    let center = document.center_mm.unwrap();
    assert!(center.iter().zip([25.4, 50.8, 76.2]).all(|(c, e)| (c - e).abs() < 1e-6), "{center:?}");
    assert!(document.standard_uncertainty.unwrap().radius_mm.unwrap() < 1e-6);
    let listed = run(&["--unit", "inch", "--json", "--by-label"]);
    let documents: Vec<etalon::document::FitDocument> = serde_json::from_slice(&listed.stdout).unwrap();
    assert_eq!(documents[0].label.as_deref(), Some("ball"));
}

fn text_of(output: &Output) -> String {
    text(&output.stderr)
}
