//! `etalon validate` and `etalon verify`: parameters that were identified before, on other data.

use super::{etalon, text};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use serde_json::Value;
use std::path::Path;
use std::process::Output;

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {}", text(&output.stderr)))
}

fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

/// A copy of a sample that was run, and its folder.
fn run(sample: &str) -> Scratch {
    let folder = copy_sample(sample);
    let ran = etalon(&folder.path(), &["run", "."]);
    assert!(ran.status.code().is_some_and(|code| code < 2), "{}", text(&ran.stderr));
    folder
}

fn document(folder: &Path, name: &str) -> Value {
    crate::support::document(&folder.join("out").join(name))
}

#[test]
fn parameters_judged_on_their_own_campaign_leave_its_errors() {
    let folder = run("prexyt-cmm");
    let accuracy = document(&folder.path(), "accuracy.json");
    let of = |more: &[&str]| {
        let judged = etalon(&folder.path(), &[&["validate", ".", "--json"], more].concat());
        (json(&judged), code(&judged))
    };
    let statistics = |document: &Value, set: usize, when: &str| -> Vec<f64> {
        let errors = document["sets"][set]["errors"].as_array().unwrap();
        let numbers = ["mean", "rms", "p95", "max"];
        errors.iter().flat_map(|e| numbers.map(|n| e[when][n].as_f64().unwrap())).collect()
    };
    let (given, exit) = of(&["--parameters", "out/parameters.json", "--frames", "given"]);
    assert_eq!(exit, Some(0));
    let (refit, _) = of(&["--parameters", "out/parameters.json"]);
    let (nominal, exit) = of(&[]);
    // the limits of the sample are for a robot that is calibrated
    assert_eq!(exit, Some(1));
    for set in 0..2 {
        for (a, b) in statistics(&given, set, "after").iter().zip(statistics(&accuracy, set, "after")) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
        // base and targets were found with the others: fitted alone they stay
        for (a, b) in statistics(&refit, set, "after").iter().zip(statistics(&accuracy, set, "after")) {
            assert!((a - b).abs() < 1e-4, "{a} {b}");
        }
        for when in ["before", "after"] {
            assert_eq!(statistics(&nominal, set, when), statistics(&accuracy, set, "before"));
        }
    }
    assert!(given["given"]["p_value"].as_f64().unwrap() > 0.001 && refit["given"]["p_value"].is_null());
    assert!(refit["definition"].as_str().unwrap().has_phrase("values-given-refit"));
}

#[test]
fn parameters_of_one_instrument_are_judged_on_the_campaign_of_another() {
    let cmm = run("prexyt-cmm");
    let arm = copy_sample("prexyt-faroarm");
    let parameters = cmm.path().join("out/parameters.json").display().to_string();
    let judged = etalon(&arm.path(), &["validate", ".", "--parameters", &parameters, "--json"]);
    assert_eq!(code(&judged), Some(0), "{}", text(&judged.stderr));
    let position = &json(&judged)["sets"][1]["errors"][0];
    let rms = |when: &str| position[when]["rms"].as_f64().unwrap();
    assert!(rms("after") < 0.25 * rms("before"), "{position}");
    // parameters of another robot are refused by name, and so is another document
    let other = run("dextar");
    let foreign = other.path().join("out/parameters.json").display().to_string();
    let refused = etalon(&arm.path(), &["validate", ".", "--parameters", &foreign]);
    assert!(code(&refused) == Some(2) && text(&refused.stderr).contains("error[parameters-of-other-robot]"));
    // a swapped sign of the actuators leaves more than nominal ones do
    let text_of = std::fs::read_to_string(&parameters).unwrap();
    let mut wrong: Value = serde_json::from_str(&text_of).unwrap();
    for entry in wrong["parameters"].as_array_mut().unwrap() {
        let (value, nominal) = (entry["value"].as_f64().unwrap(), entry["nominal"].as_f64().unwrap());
        entry["value"] = (2.0 * nominal - value).into();
    }
    std::fs::write(arm.path().join("wrong.json"), wrong.to_string()).unwrap();
    let warned = etalon(&arm.path(), &["validate", ".", "--parameters", "wrong.json"]);
    assert!(text(&warned.stderr).contains("error[given-parameters-worse]"), "{}", text(&warned.stderr));
    assert_eq!(code(&warned), Some(1), "worse than nominal by more than noise");
}

/// Each answer is written as a page, a workbook and, where there is one, a PDF, in every language.
#[test]
fn answers_are_written_as_reports_in_every_language() {
    let folder = run("prexyt-cmm");
    // measured anew: copies of readings verify nothing
    let anew = observations(&folder.path(), |header, cells| add(header, cells, "x_mm", 1e-4));
    std::fs::write(folder.path().join("few.csv"), anew).unwrap();
    let verify = ["verify", "few.csv", "--robot", "robot.toml", "--parameters", "out/parameters.json"];
    let validate = ["validate", ".", "--parameters", "out/parameters.json"];
    let titles = [
        (&verify[..], "Verification of identified parameters", "berprüfung identifizierter", "rification de"),
        (&validate[..], "Validation of given parameters", "Validierung", "Validation de"),
        (&["recommend", "."][..], "Recommendation of parameters to load", "Empfehlung", "Recommandation"),
        (
            &["uncertainty", ".", "--draws", "100", "--resamples", "0"][..],
            "Uncertainties of",
            "Unsicherheiten",
            "Incertitudes",
        ),
    ];
    for (command, english, german, french) in titles {
        let mut pages = Vec::new();
        for (language, title) in [("en", english), ("de", german), ("fr", french)] {
            let written = ["--report", "answer.html", "--report", "answer.xlsx", "--language", language];
            let done = etalon(&folder.path(), &[command, &written].concat());
            assert_eq!(code(&done), Some(0), "{command:?}: {}", text(&done.stderr));
            let page = std::fs::read_to_string(folder.path().join("answer.html")).unwrap();
            assert!(page.contains(title) && text(&done.stdout).contains(title), "{command:?} {language}");
            // explanations of messages are in English
            let worded = |line: &str| !line.contains("<code id=\"message-") && line.contains("<bdi lang=\"en\">");
            assert!(!page.lines().any(worded) || language == "en", "{command:?} {language}: not translated");
            assert!(std::fs::read(folder.path().join("answer.xlsx")).unwrap().starts_with(b"PK"));
            pages.push(page);
        }
        assert!(pages[1] != pages[0] && pages[2] != pages[0]);
        let refused = etalon(&folder.path(), &[command, &["--report", "answer.txt"]].concat());
        assert!(code(&refused) == Some(2) && text(&refused.stderr).says("error[not-a-report]"));
    }
    let over = etalon(&folder.path(), &[&validate[..], &["--report", "out/../out/report.html"]].concat());
    assert_eq!(code(&over), Some(0), "a report of before is no input");
}

#[test]
fn base_and_targets_with_a_prior_are_between_given_and_refitted_ones() {
    let cmm = run("prexyt-cmm");
    let arm = copy_sample("prexyt-faroarm");
    let parameters = document(&cmm.path(), "parameters.json");
    let judged = |frames: &str, factor: f64| {
        let mut scaled = parameters.clone();
        for row in scaled["covariance"].as_array_mut().unwrap() {
            row.as_array_mut().unwrap().iter_mut().for_each(|v| *v = (factor * v.as_f64().unwrap()).into());
        }
        std::fs::write(arm.path().join("scaled.json"), scaled.to_string()).unwrap();
        let more = ["validate", ".", "--parameters", "scaled.json", "--frames", frames, "--json"];
        let output = etalon(&arm.path(), &more);
        assert!(code(&output).is_some_and(|code| code < 2), "{}", text(&output.stderr));
        json(&output)
    };
    let rms = |answer: &Value| answer["sets"][0]["errors"][0]["after"]["rms"].as_f64().unwrap();
    let (given, refit) = (rms(&judged("given", 1.0)), rms(&judged("refit", 1.0)));
    // what is certain stays, and what is not is fitted
    let [certain, prior, vague] = [1e-12, 1.0, 1e12].map(|factor| rms(&judged("prior", factor)));
    assert!(
        (certain / given - 1.0).abs() < 1e-6 && (vague / refit - 1.0).abs() < 1e-3,
        "{certain} {given} {vague} {refit}"
    );
    assert!(refit < prior && prior < given, "{refit} {prior} {given}");
    assert!(judged("prior", 1.0)["given"]["p_value"].is_number());
    let nominal = etalon(&arm.path(), &["validate", ".", "--frames", "prior"]);
    assert!(code(&nominal) == Some(2) && text(&nominal.stderr).contains("error[prior-of-nominal]"));
}

#[test]
fn poses_are_chosen_that_detect_smaller_changes() {
    let folder = run("prexyt-cmm");
    let all = std::fs::read_to_string(folder.path().join("out/observations.csv")).unwrap();
    let header: Vec<&str> = all.lines().next().unwrap().split(',').collect();
    let cycle = header.iter().position(|name| *name == "cycle").unwrap();
    let first = all.lines().skip(1).filter(|line| line.split(',').nth(cycle) == Some("1"));
    let of = |poses: &dyn Fn(&str) -> bool| -> String {
        let kept = first.clone().filter(|line| poses(line.split(',').next().unwrap()));
        header.join(",") + "\n" + &kept.map(|line| format!("{line}\n")).collect::<String>()
    };
    let given = ["--robot", "robot.toml", "--parameters", "out/parameters.json", "--json"];
    let answer = |arguments: &[&str]| {
        let output = etalon(&folder.path(), &[&["verify"], arguments, &given].concat());
        assert!(code(&output).is_some_and(|code| code < 2), "{}", text(&output.stderr));
        json(&output)
    };
    std::fs::write(folder.path().join("candidates.csv"), of(&|_| true)).unwrap();
    let plan = answer(&["--candidates", "candidates.csv", "--positions", "3"]);
    let steps = plan["steps"].as_array().unwrap();
    let chosen: Vec<&str> = steps.iter().map(|s| s["pose"].as_str().unwrap_or_default()).collect();
    let chosen: Vec<String> = match chosen.iter().all(|name| name.is_empty()) {
        true => steps.iter().map(|s| s["pose"].to_string()).collect(),
        false => chosen.into_iter().map(str::to_owned).collect(),
    };
    let least = |document: &Value| -> Vec<f64> {
        document.as_array().unwrap().iter().map(|l| l["value"].as_f64().unwrap_or(1e3)).collect()
    };
    let verified = |poses: &dyn Fn(&str) -> bool| {
        std::fs::write(folder.path().join("few.csv"), of(poses)).unwrap();
        least(&answer(&["few.csv"])["power"]["least"])
    };
    // what the plan states is what a verification with these poses states
    let measured = verified(&|pose| chosen.iter().any(|c| c == pose));
    for (a, b) in least(&steps[2]["least"]).iter().zip(&measured) {
        assert!((a / b - 1.0).abs() < 0.01, "{a} {b}");
    }
    let product = |all: &[f64]| all.iter().map(|v| v.ln()).sum::<f64>();
    for others in [["11", "20", "33"], ["1", "2", "3"], ["9", "30", "59"]] {
        let others = verified(&|pose| others.contains(&pose));
        assert!(product(&measured) < product(&others), "{measured:?} {others:?}");
    }
    let few = [&["verify", "--candidates", "candidates.csv", "--positions", "0"][..], &given].concat();
    let refused = etalon(&folder.path(), &few);
    assert!(code(&refused) == Some(2) && text(&refused.stderr).contains("error[candidate-poses-too-few]"));
}

/// Some rows of the observations of a run, changed.
fn observations(folder: &Path, change: impl Fn(&[&str], &mut Vec<String>)) -> String {
    let all = std::fs::read_to_string(folder.join("out/observations.csv")).unwrap();
    let header: Vec<&str> = all.lines().next().unwrap().split(',').collect();
    let mut out = header.join(",") + "\n";
    let few = ["11", "20", "33", "47", "52", "58"];
    for line in all.lines().skip(1).filter(|line| few.contains(&line.split(',').next().unwrap())) {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        change(&header, &mut cells);
        out += &(cells.join(",") + "\n");
    }
    out
}

fn add(header: &[&str], cells: &mut [String], column: &str, by: f64) {
    let at = header.iter().position(|name| *name == column).unwrap();
    cells[at] = (cells[at].parse::<f64>().unwrap() + by).to_string();
}

/// Answers name campaign, files and synthetic data; residuals belong to positions.
#[test]
fn answers_name_their_campaign_and_files() {
    let folder = run("draw-wire");
    let hash = |name: &str| etalon::base::files::sha256_of_file(&folder.path().join(name)).unwrap();
    let validate = ["validate", ".", "--parameters", "out/parameters.json", "--report", "answer.html", "--json"];
    let answer = json(&etalon(&folder.path(), &validate));
    assert_eq!(answer["campaign"]["name"].as_str(), Some("Draw wires (synthetic)"), "{answer}");
    assert_eq!(answer["provenance"]["inputs"]["observations.csv"].as_str(), Some(hash("observations.csv").as_str()));
    let page = std::fs::read_to_string(folder.path().join("answer.html")).unwrap();
    assert!(page.contains("Synthetic data:") && page.contains(&hash("out/parameters.json")));
    let recommend = etalon(&folder.path(), &["recommend", ".", "--report", "answer.html", "--json"]);
    assert_eq!(json(&recommend)["campaign"]["name"].as_str(), Some("Draw wires (synthetic)"));
    let page = std::fs::read_to_string(folder.path().join("answer.html")).unwrap();
    assert!(page.contains("Synthetic data:") && page.contains(&hash("observations.csv")));
    let drawn = ["uncertainty", ".", "--draws", "100", "--resamples", "0", "--report", "answer.html", "--json"];
    assert_eq!(json(&etalon(&folder.path(), &drawn))["campaign"]["name"].as_str(), Some("Draw wires (synthetic)"));
    let page = std::fs::read_to_string(folder.path().join("answer.html")).unwrap();
    assert!(page.contains("Synthetic data:") && page.contains(&hash("observations.csv")));
    let folder = run("prexyt-cmm");
    std::fs::write(folder.path().join("few.csv"), observations(&folder.path(), |_, _| {})).unwrap();
    let verify = ["verify", "few.csv", "--robot", "robot.toml", "--parameters", "out/parameters.json"];
    let verified = etalon(&folder.path(), &[&verify[..], &["--report", "answer.html", "--json"]].concat());
    let answer = json(&verified);
    let campaign = document(&folder.path(), "campaign.json");
    assert_eq!(answer["calibration"]["name"], campaign["name"], "{answer}");
    // two coordinates a position
    let ratio = answer["position_rms_mm"].as_f64().unwrap() / answer["rms_mm"].as_f64().unwrap();
    assert!((ratio - 2f64.sqrt()).abs() < 1e-12, "{ratio}");
    let page = std::fs::read_to_string(folder.path().join("answer.html")).unwrap();
    let few = etalon::base::files::sha256_of_file(&folder.path().join("few.csv")).unwrap();
    assert!(page.contains(campaign["name"].as_str().unwrap()) && page.contains(&few));
}

/// The base has moved, and one pose was measured wrongly: the motion is named with its share, not as the cause.
#[test]
fn a_motion_that_does_not_explain_everything_is_named() {
    let folder = run("prexyt-cmm");
    let table = observations(&folder.path(), |header, cells| {
        add(header, cells, "x_mm", 0.05);
        if cells[0] == "33" {
            let by = if cells.contains(&"K".to_owned()) { 0.03 } else { -0.03 };
            add(header, cells, "y_mm", by);
        }
    });
    std::fs::write(folder.path().join("few.csv"), table).unwrap();
    let arguments = ["verify", "few.csv", "--robot", "robot.toml", "--parameters", "out/parameters.json", "--json"];
    let answer = json(&etalon(&folder.path(), &arguments));
    let meaning = answer["meaning"].as_str().unwrap();
    assert_eq!((answer["verdict"].as_str(), answer["moved"].is_null()), (Some("other"), true), "{answer}");
    assert!(meaning.has_phrase("base-motion-explains-most") && meaning.contains(" x +0.0"), "{meaning}");
    assert!(!meaning.has_phrase("parameters-no-longer-valid"), "{meaning}");
}

/// Residuals that one of fifty unchanged robots has ask for another measurement; larger ones do not.
#[test]
fn a_doubtful_rejection_asks_for_another_measurement() {
    let folder = run("prexyt-cmm");
    let shifted = |by_mm: f64| {
        let table = observations(&folder.path(), |header, cells| add(header, cells, "rho2_mm", by_mm));
        std::fs::write(folder.path().join("few.csv"), table).unwrap();
        let arguments = ["verify", "few.csv", "--robot", "robot.toml", "--parameters", "out/parameters.json", "--json"];
        let answer = json(&etalon(&folder.path(), &arguments));
        let p = answer["p_value"].as_f64().unwrap();
        (p, answer["meaning_phrase"]["id"].as_str().unwrap().to_owned(), answer)
    };
    let (mut low, mut high) = (0.0, 0.2);
    let (p, id, answer) = loop {
        let by_mm = 0.5 * (low + high);
        let tried = shifted(by_mm);
        match tried.0 {
            p if p > 0.04 => low = by_mm,
            p if p < 0.015 => high = by_mm,
            _ => break tried,
        }
        assert!(high - low > 1e-6, "{low} {high}");
    };
    assert_eq!((id.as_str(), answer["verdict"] == "valid"), ("perhaps-changed", false), "{p}: {answer}");
    let percent = answer["meaning_phrase"]["arguments"]["percent"].as_f64().unwrap();
    assert!((percent - 100.0 * p).abs() < 1e-9, "{answer}");
    let (p, id, _) = shifted(0.2);
    assert!(p < 0.01 && id != "perhaps-changed", "{p} {id}");
}

#[test]
fn a_verification_says_what_has_moved() {
    let folder = run("prexyt-cmm");
    let verify = |table: &str| {
        std::fs::write(folder.path().join("few.csv"), table).unwrap();
        let arguments = ["verify", "few.csv", "--robot", "robot.toml", "--parameters", "out/parameters.json", "--json"];
        etalon(&folder.path(), &arguments)
    };
    // measured anew: copies of readings verify nothing
    let valid = verify(&observations(&folder.path(), |header, cells| add(header, cells, "x_mm", 1e-4)));
    assert_eq!((code(&valid), json(&valid)["verdict"].as_str()), (Some(0), Some("valid")), "{}", text(&valid.stderr));
    // a column that nothing reads is named
    let misspelt = observations(&folder.path(), |header, cells| {
        add(header, cells, "x_mm", 1e-4);
        cells.push("0.01".to_owned());
    });
    let misspelt = verify(&misspelt.replacen('\n', ",uncertainty\n", 1));
    assert!(code(&misspelt) == Some(0) && text(&misspelt.stderr).is_empty(), "{}", text(&misspelt.stderr));
    let messages = json(&misspelt)["messages"].to_string();
    assert!(messages.contains("uncertainty"), "{messages}");
    // a carriage that is elsewhere than its encoder reads
    let slipped = verify(&observations(&folder.path(), |header, cells| add(header, cells, "rho2_mm", -0.2)));
    let answer = json(&slipped);
    assert_eq!((code(&slipped), answer["verdict"].as_str()), (Some(1), Some("joint")), "{answer}");
    let by = &answer["moved"]["by"][0];
    assert!(answer["moved"]["name"] == "rho2" && (by["value"].as_f64().unwrap() - 0.2).abs() < 0.02, "{answer}");
    let shifted = verify(&observations(&folder.path(), |header, cells| {
        add(header, cells, "x_mm", 0.3);
        add(header, cells, "y_mm", -0.2);
    }));
    let answer = json(&shifted);
    assert_eq!((code(&shifted), answer["verdict"].as_str()), (Some(1), Some("base_moved")), "{answer}");
    let by = |i: usize| answer["moved"]["by"][i]["value"].as_f64().unwrap();
    assert!((by(0) - 0.3).abs() < 0.03 && (by(1) + 0.2).abs() < 0.03, "{answer}");
    // one wrong reading is none of these
    let odd = verify(&observations(&folder.path(), |header, cells| {
        if cells[0] == "20" && cells[2] == "K" {
            add(header, cells, "x_mm", 0.4);
        }
    }));
    assert_eq!((code(&odd), json(&odd)["verdict"].as_str()), (Some(1), Some("other")));
}

/// Poses with orientations, in the table that the campaign describes: own rows are valid, and a joint whose zero has moved is named.
#[test]
fn a_verification_takes_orientations_in_the_table_of_the_campaign() {
    let folder = run("probe-poses");
    let table = std::fs::read_to_string(folder.path().join("observations.csv")).unwrap();
    let verify = |table: &str| {
        std::fs::write(folder.path().join("few.csv"), table).unwrap();
        let arguments = [
            "verify",
            "few.csv",
            "--robot",
            "robot.toml",
            "--parameters",
            "out/parameters.json",
            "--like",
            ".",
            "--json",
        ];
        etalon(&folder.path(), &arguments)
    };
    let few = |change: &dyn Fn(&mut Vec<String>)| -> String {
        let (head, rows) = table.split_once('\n').unwrap();
        let row = |line: &str| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            change(&mut cells);
            cells.join(",")
        };
        let rows: Vec<String> = rows.lines().step_by(2).take(15).map(row).collect();
        format!("{head}\n{}\n", rows.join("\n"))
    };
    let q5 = table.split(',').position(|name| name == "q5_deg").unwrap();
    let moved =
        |by_deg: f64| verify(&few(&|cells| cells[q5] = (cells[q5].parse::<f64>().unwrap() + by_deg).to_string()));
    // measured anew: copies of readings verify nothing
    let valid = moved(1e-5);
    assert_eq!((code(&valid), json(&valid)["verdict"].as_str()), (Some(0), Some("valid")), "{}", text(&valid.stderr));
    // the wrist turns the probe, which the orientations show
    let slipped = moved(0.3);
    let answer = json(&slipped);
    assert_eq!((code(&slipped), answer["verdict"].as_str()), (Some(1), Some("joint")), "{answer}");
    assert_eq!(answer["moved"]["name"], "q5", "{answer}");
    let orientation = |answer: &serde_json::Value| {
        let found = &answer["conditions"][0];
        assert_eq!(
            (found["quantity"].as_str(), found["unit"].as_str()),
            (Some("orientation"), Some("deg")),
            "{answer}"
        );
        found["rms"].as_f64().unwrap() / found["expected_rms"].as_f64().unwrap()
    };
    assert!((0.7..1.3).contains(&orientation(&json(&valid))) && orientation(&answer) > 5.0, "{answer}");
    // the campaign states the table: options beside it would count for nothing
    let both = ["verify", "few.csv", "--robot", "robot.toml", "--parameters", "out/parameters.json", "--like", "."];
    for option in [&["--delimiter", ";"][..], &["--coverage-factor", "2"], &["--orientation", "zyx"]] {
        assert_eq!(code(&etalon(&folder.path(), &[&both[..], option].concat())), Some(2), "{option:?}");
    }
    // orientations alone may contradict the calibration
    let turned = verify(&few(&|cells| {
        let at = cells.len() - 4;
        let [w, x, y, z] = [0, 1, 2, 3].map(|k| cells[at + k].parse::<f64>().unwrap());
        let (c, s) = (0.5f64.to_radians().cos(), 0.5f64.to_radians().sin());
        let turned = [c * w - s * x, c * x + s * w, c * y + s * z, c * z - s * y];
        turned.iter().enumerate().for_each(|(k, v)| cells[at + k] = v.to_string());
    }));
    assert_eq!(code(&turned), Some(1), "{}", json(&turned));
}

#[test]
fn a_verification_refuses_what_it_cannot_compare() {
    let folder = run("prexyt-cmm");
    let good = observations(&folder.path(), |_, _| {});
    let refused = |table: &str, more: &[&str]| {
        std::fs::write(folder.path().join("few.csv"), table).unwrap();
        let arguments = ["verify", "few.csv", "--robot", "robot.toml", "--parameters", "out/parameters.json"];
        let output = etalon(&folder.path(), &[&arguments[..], more].concat());
        assert_eq!(code(&output), Some(2), "{}", text(&output.stdout));
        text(&output.stderr)
    };
    assert!(refused(&good.replace(",K,", ",M,"), &[]).contains("`M`"));
    assert!(refused(&good.replace("pose,", "kind,").replace('\n', "\npoint,"), &[]).contains("error"));
    assert!(refused(&good.replace("rho1_mm", "rho1_deg"), &[]).contains("rho1"));
    // an orientation that the robot does not have
    let with_angle = observations(&folder.path(), |_, cells| cells.push("0".to_owned()));
    let with_angles = with_angle.replacen('\n', ",rx_rad\n", 1);
    assert!(refused(&with_angles, &[]).contains("error"));
    // inches, and actuators that are exchanged
    let inch = observations(&folder.path(), |header, cells| {
        for column in ["x_mm", "y_mm"] {
            let at = header.iter().position(|name| *name == column).unwrap();
            cells[at] = (cells[at].parse::<f64>().unwrap() / 25.4).to_string();
        }
    });
    assert!(refused(&inch, &[]).contains("error"));
    assert!(
        refused(&good.replace("rho2_mm", "rho").replace("rho3_mm", "rho2_mm").replace("rho,", "rho3_mm,"), &[])
            .contains("error")
    );
    assert!(refused(&good, &["--standard-uncertainty-um", "0.0027"]).has_phrase("uncertainty-implausible"));
}

#[test]
fn a_wrong_set_up_is_neither_judged_nor_recommended() {
    let folder = copy_sample("prexyt-cmm");
    folder.replace("campaign.toml", "rho2_mm = \"RP2\", rho3_mm = \"RP3\"", "rho2_mm = \"RP3\", rho3_mm = \"RP2\"");
    for command in ["validate", "recommend"] {
        let refused = etalon(&folder.path(), &[command, "."]);
        let said = text(&refused.stderr);
        assert!(code(&refused) == Some(2) && said.contains("`rho2` and `rho3` swapped"), "{command}: {said}");
    }
}

#[test]
fn a_recommendation_is_the_answer_of_the_run() {
    // a synthetic table of which only gamma, d3 and delta are not as drawn
    let folder = copy_sample("prexyt-cmm");
    for (from, to) in [
        ("beta = -0.0142", "beta = 0.0"),
        ("s = 393.9288", "s = 394.0"),
        ("d = 116.2344", "d = 116.0"),
        ("delta2 = 0.9996", "delta2 = 1.0"),
        ("delta3 = 0.9998", "delta3 = 1.0"),
    ] {
        folder.replace("truth.toml", from, to);
    }
    let simulated = etalon(&folder.path(), &["simulate", "."]);
    assert_eq!(code(&simulated), Some(0), "{}", text(&simulated.stderr));
    let loading = || document(&folder.path(), "verdict.json")["loading"].clone();
    assert_eq!(code(&etalon(&folder.path(), &["run", "."])), Some(0));
    let answer = etalon(&folder.path(), &["recommend", ".", "--json", "--write", "recommended.json"]);
    assert_eq!(code(&answer), Some(0), "{}", text(&answer.stderr));
    let answer = json(&answer);
    assert_eq!((&answer["loading"], &answer["loading"]["answer"]), (&loading(), &Value::from("load")));
    assert_eq!(answer["loading"]["file"], "controller.json");
    // the parameters of the run are those that are recommended
    assert!(answer["parameters"].as_array().unwrap().iter().all(|p| p["verdict"] == "load"), "{answer}");
    let rms = |which: &str| answer["held_out"][which]["rms"].as_f64().unwrap();
    assert!(rms("recommended") == rms("all") && rms("all") < 0.1 * rms("none"), "{}", answer["held_out"]);
    assert_eq!(answer["recommended"]["parameters"], document(&folder.path(), "parameters.json")["parameters"]);
    // the robot is at the values that simulated it
    let identified = answer["recommended"]["parameters"].as_array().unwrap();
    let entry = |name: &str| identified.iter().find(|p| p["name"] == name).unwrap();
    assert!((entry("d3")["value"].as_f64().unwrap() - 0.8528).abs() < 0.005, "{}", entry("d3"));
    let exported = etalon(&folder.path(), &["export", "recommended.json", "--format", "json"]);
    assert_eq!(code(&exported), Some(0), "{}", text(&exported.stderr));
    // the same at once, with the campaign and its robot
    let at_once = ["export", ".", "--parameters", "recommended", "--format", "python-kinematics", "--format", "json"];
    let refused = etalon(&folder.path(), &at_once);
    assert!(code(&refused) == Some(2) && text(&refused.stderr).contains("--to"), "{}", text(&refused.stderr));
    let exported = etalon(&folder.path(), &[&at_once[..], &["--to", "at_once"]].concat());
    assert_eq!(code(&exported), Some(0), "{}", text(&exported.stderr));
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    let controller: serde_json::Value = serde_json::from_str(&read("at_once/controller.json")).unwrap();
    let loaded = |name: &str| {
        let all = controller["parameters"].as_object().unwrap();
        all[name]["value"].as_f64().unwrap_or_else(|| panic!("{controller}"))
    };
    assert_eq!(loaded("d3"), entry("d3")["value"].as_f64().unwrap());
    assert!(read("at_once/etalon_kinematics.py").contains("# campaign: "));
    // nothing is written over
    let refused = etalon(&folder.path(), &["recommend", ".", "--write", "robot.toml"]);
    assert!(code(&refused) == Some(2) && text(&refused.stderr).contains("error[file-exists]"));
    // a table as drawn: nothing is invented
    for (from, to) in
        [("gamma = 0.0828", "gamma = 0.0"), ("d3 = 0.8528", "d3 = 0.0"), ("delta = 0.9992", "delta = 1.0")]
    {
        folder.replace("truth.toml", from, to);
    }
    assert_eq!(code(&etalon(&folder.path(), &["simulate", "."])), Some(0));
    assert_eq!(code(&etalon(&folder.path(), &["run", "."])), Some(0));
    assert_eq!(loading()["answer"], "keep_nominal");
    let steps = document(&folder.path(), "verdict.json")["actions"].clone();
    let is = |kind: &str| steps.as_array().unwrap().iter().any(|step| step["action"] == kind);
    assert!(is("keep_nominal") && !is("load"), "{steps}");
    let nothing = json(&etalon(&folder.path(), &["recommend", ".", "--json"]));
    let parameters = nothing["parameters"].as_array().unwrap();
    assert!(parameters.iter().all(|p| p["verdict"] == "hold"), "{}", nothing["parameters"]);
    assert_eq!(nothing["held_out"]["recommended"], nothing["held_out"]["none"]);
}

/// Parameters that hold what robot.toml does not describe are refused with the lines to add.
#[test]
fn keys_that_given_parameters_need_are_required_of_robot_toml() {
    let folder = run("rail-arm");
    let robot = std::fs::read_to_string(folder.path().join("robot.toml")).unwrap();
    let key = |name: &str| robot.lines().find(|line| line.starts_with(name)).unwrap();
    for (less, lines) in [
        (&["harmonics"][..], &["`harmonics = [2, 3]`"][..]),
        (&["backlash", "harmonics"], &["`backlash = [2, 3, 4]`", "`harmonics = [2, 3]`"]),
    ] {
        let mut text = robot.clone();
        less.iter().for_each(|name| text = text.replace(key(name), ""));
        std::fs::write(folder.path().join("less.toml"), text).unwrap();
        let observed =
            ["verify", "out/observations.csv", "--robot", "less.toml", "--parameters", "out/parameters.json"];
        let exported = ["export", "out/parameters.json", "--robot", "less.toml", "--to", "files", "--format", "json"];
        for command in [&observed[..], &exported] {
            let refused = etalon(&folder.path(), command);
            let said = text_of(&refused);
            assert_eq!(code(&refused), Some(2), "{said}");
            let parts = [&["error[parameters-undescribed]", "to robot.toml"][..], lines].concat();
            assert!(parts.iter().all(|part| said.says(part)), "{command:?}: {said}");
        }
    }
    // a part of a key is completed
    let part = robot.replace(key("harmonics"), "harmonics = [3]");
    std::fs::write(folder.path().join("robot.toml"), part).unwrap();
    let refused = etalon(&folder.path(), &["validate", ".", "--parameters", "out/parameters.json"]);
    let said = text_of(&refused);
    assert!(code(&refused) == Some(2) && said.contains("`harmonics = [2, 3]`"), "{said}");
    assert!(said.contains("`harmonic_2_sin1`") && !said.contains("`harmonic_3_sin1`"), "{said}");
}

fn text_of(output: &Output) -> String {
    text(&output.stderr)
}

/// Positions, distances from an anchor and values of a second encoder, of an arm of three axes whose lengths are off. Synthetic.
fn mixed_kinds() -> Scratch {
    use etalon::base::noise::Noise;
    use etalon::base::pose::{minus, norm};
    let folder = copy_sample("draw-wire");
    let joint = |[alpha, a, theta, d]: [f64; 4]| {
        format!("    {{ alpha_deg = {alpha}, a_mm = {a}, theta_deg = {theta}, d_mm = {d} }},\n")
    };
    let joints = [[0.0, 0.0, 0.0, 290.0], [-90.0, 0.0, -90.0, 0.0], [0.0, 270.0, 0.0, 0.0]].map(joint).concat();
    std::fs::write(folder.path().join("robot.toml"), format!("model = \"serial\"\njoint = [\n{joints}]\n")).unwrap();
    let robot = etalon::campaign::read_robot(&folder.path().join("robot.toml")).unwrap();
    let robot = robot.build(&["ball".to_owned()]).unwrap();
    let mut values = robot.nominal();
    for (name, error) in [("ball_x", 150.0), ("ball_y", 20.0), ("ball_z", 30.0), ("a_3", 0.8), ("theta_3", 0.004)] {
        values[robot.index(name).unwrap()] += error;
    }
    let (mut noise, u) = (Noise::new(40, 11), 0.05);
    let mut table = "kind,pose,target,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,other,distance_mm,u_mm\n".to_owned();
    for pose in 1..=36 {
        let q: Vec<f64> = (0..3).map(|_| noise.uniform(1.4)).collect();
        let at = robot.position(&values, &q, 0);
        let q = q.iter().map(|q| format!("{:.12}", q.to_degrees())).collect::<Vec<_>>().join(",");
        if pose % 3 == 0 {
            let d = norm(minus(at, [900.0, 400.0, 60.0])) + noise.gaussian(u);
            table += &format!("distance,{pose},ball,{q},,,,anchor,{d:.6},{u}\n");
        } else {
            let [x, y, z] = at.map(|v| v + noise.gaussian(u));
            table += &format!("point,{pose},ball,{q},{x:.6},{y:.6},{z:.6},,,{u}\n");
        }
    }
    std::fs::write(folder.path().join("observations.csv"), table).unwrap();
    folder.replace("campaign.toml", "calibration = \"1-60\"\nvalidation = \"rest\"", "calibration = \"all\"");
    folder
}

#[test]
fn recommend_judges_every_kind_by_one_measure_of_error() {
    let folder = mixed_kinds();
    let answered = etalon(&folder.path(), &["recommend", ".", "--json"]);
    assert_eq!(code(&answered), Some(0), "{}", text(&answered.stderr));
    let answer = json(&answered);
    let steps = answer["steps"].as_array().unwrap();
    let accepted: Vec<&Value> = steps.iter().filter(|s| s["accepted"] == true).collect();
    assert!(accepted.len() > 1, "{steps:?}");
    // poses that were used and poses that were not, by the same measure, without a factor of √3
    for step in &accepted {
        let [used, left_out] = ["rms_mm", "held_out_rms_mm"].map(|name| step[name].as_f64().unwrap());
        assert!((0.8..1.6).contains(&(left_out / used)), "{used} {left_out}");
    }
    let last = accepted.last().unwrap()["held_out_rms_mm"].as_f64().unwrap();
    assert!(last < 0.2, "{last}");
}

/// Effects that are chosen by poses that are left out, and those that would have been.
#[test]
fn proven_effects_are_identified_and_others_are_named() {
    let folder = copy_sample("prexyt-cmm");
    let accuracy = |rule: &str, said: &[&str]| {
        let path = folder.path().join("campaign.toml");
        let sample = std::fs::read_to_string(&path).unwrap();
        let kept: Vec<&str> = sample.lines().filter(|line| !line.starts_with("effects = ")).collect();
        std::fs::write(&path, kept.join("\n").replace("[identify]", &format!("[identify]\n{rule}"))).unwrap();
        let ran = etalon(&folder.path(), &["run", "."]);
        assert!(code(&ran).is_some_and(|code| code < 2), "{}", text(&ran.stderr));
        for part in said {
            assert!(text(&ran.stderr).says(part), "{part}: {}", text(&ran.stderr));
        }
        document(&folder.path(), "accuracy.json")
    };
    folder.replace(
        "campaign.toml",
        "calibration = \"1-8\"\nvalidation = \"9-59\"",
        "calibration = \"1-24\"\nvalidation = \"25-59\"",
    );
    let all = accuracy("effects = \"proven\"", &[]);
    let effects = all["effects"].as_array().unwrap();
    assert!(!effects.is_empty() && effects.iter().all(|e| e["is_identified"] == true), "{effects:?}");
    for e in effects {
        assert!(e["with_mm"].as_f64().unwrap() < e["without_mm"].as_f64().unwrap(), "{e}");
    }
    // as `recommend` has it
    let answer = json(&etalon(&folder.path(), &["recommend", ".", "--json"]));
    let accepted =
        answer["steps"].as_array().unwrap().iter().filter(|s| s["accepted"] == true && !s["effect"].is_null());
    let accepted: Vec<&Value> = accepted.map(|s| &s["effect"]).collect();
    assert_eq!(accepted, effects.iter().map(|e| &e["effect"]).collect::<Vec<_>>());
    // what the campaign leaves out, and the data prove
    let said = ["geometry", "[effect-would-prove]"];
    let without = accuracy("effects = [\"zeros\", \"gains\"]", &said);
    let geometry = without["effects"].as_array().unwrap().iter().find(|e| e["effect"] == "geometry").unwrap();
    assert!(geometry["is_identified"] == false, "{geometry}");
    assert!(geometry["with_mm"].as_f64().unwrap() < 0.5 * geometry["without_mm"].as_f64().unwrap(), "{geometry}");
    // the advised line brings what is said at the same left-out poses
    let line = geometry["campaign_line"].as_str().unwrap();
    assert_eq!(line, "effects = [\"zeros\", \"geometry\", \"gains\"]");
    let reached = accuracy(line, &[])["left_out"]["identified"]["rms"].as_f64().unwrap();
    let promised = geometry["with_mm"].as_f64().unwrap();
    assert!((reached / promised - 1.0).abs() < 0.1, "{reached} {promised}");
}

#[test]
fn what_was_not_drawn_is_not_said_to_contain_anything() {
    let folder = copy_sample("prexyt-cmm");
    // an instrument that is said to be much better than it is: the model seems to misfit
    folder.replace("campaign.toml", "expanded_uncertainty_um = ", "expanded_uncertainty_um = 0.1 # ");
    let said = |more: &[&str]| {
        let answered = etalon(&folder.path(), &[&["uncertainty", ".", "--draws", "100"], more].concat());
        assert_eq!(code(&answered), Some(0), "{}", text(&answered.stderr));
        text(&answered.stdout).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let without = said(&["--resamples", "0"]);
    assert!(without.has_phrase("draws-without-model-report") && !without.contains("bootstrap"), "{without}");
}
