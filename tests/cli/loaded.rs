//! A controller file that is loaded: the verdict is about its values, and the tests after loading agree with it.

use super::{etalon, text_of};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, ends};
use etalon::documents::{
    Acceptance, AccuracyDocument, ActionKind, CampaignSummary, ControllersDocument, Effect, LeftOutErrors, LoadAnswer,
    LoadingCheck, Reason, VerdictDocument,
};
use etalon::run::pipeline::evaluate;
use std::collections::{BTreeMap, BTreeSet};

/// Zeros of joints alone, as ABB, KUKA and FANUC take them.
const ZEROS: &str = "{# holds: theta_* #}\n{% for p in parameters %}\n{{ p.name }}={{ p.value }}\n{% endfor %}\n";

/// An arm whose controller takes zeros; its limit is 0.4 mm.
fn arm() -> Scratch {
    let scratch = copy_sample("second-encoders");
    std::fs::write(scratch.path().join("zeros.ini.j2"), ZEROS).unwrap();
    scratch.replace("campaign.toml", "controllers = [\"json\"]", "controllers = [\"json\", \"zeros.ini.j2\"]");
    scratch
}

fn check_of(scratch: &Scratch) -> LoadingCheck {
    let campaign: CampaignSummary = scratch.document("campaign.json");
    campaign.controller_files.into_iter().find(|file| file.file == "zeros.ini").unwrap().check.unwrap()
}

/// Geometry and gains that zeros cannot replace leave 0.8 mm (RMS), and 90 µm with all parameters.
#[test]
fn a_file_of_zeros_is_judged_by_its_own_errors() {
    let scratch = arm();
    ends(&scratch, "run", 1, &[]);
    let verdict: VerdictDocument = scratch.document("verdict.json");
    let controllers: ControllersDocument = scratch.document("controllers.json");
    let written = controllers.files[0].deciding().unwrap().written;
    assert_eq!((verdict.verdict, verdict.judged_file.as_deref()), (Some(Acceptance::Fail), Some("zeros.ini")));
    assert_eq!(verdict.limits[0].value, Some(written.max_mm));
    assert!(written.max_mm > 1.0 && written.rms_mm > 0.5, "{written:?}");
    assert_eq!(verdict.loading.unwrap().answer, LoadAnswer::Resolve);
    let campaign: CampaignSummary = scratch.document("campaign.json");
    let file = campaign.controller_files.iter().find(|file| file.file == "zeros.ini").unwrap();
    let omitted = &file.omitted_effects;
    assert!(omitted.contains(&Effect::Geometry) && omitted.contains(&Effect::Gains), "{omitted:?}");
    assert!(!omitted.contains(&Effect::Zeros), "{omitted:?}");
    assert!(verdict.actions.iter().all(|step| step.action != ActionKind::Load), "{:?}", verdict.actions);
    let meet = verdict.actions.iter().find(|step| step.action == ActionKind::MeetLimit).unwrap();
    assert_eq!(meet.what.phrase().unwrap().id, "action-use-all-parameters");
    // the same robot with all parameters
    scratch.replace("campaign.toml", "[\"json\", \"zeros.ini.j2\"]", "[\"json\"]");
    ends(&scratch, "run", 0, &[]);
    let verdict: VerdictDocument = scratch.document("verdict.json");
    assert!(verdict.judged_file.is_none() && verdict.limits[0].value.unwrap() < 0.4, "{verdict:?}");
}

/// The display that the report announces is the one that `etalon kinematics` computes, before and after loading.
#[test]
fn the_display_after_loading_is_that_of_the_file() {
    let scratch = arm();
    scratch.replace("campaign.toml", "position_max_mm = 0.4", "position_max_mm = 5.0");
    ends(&scratch, "run", 0, &[]);
    let written = || ["controller.json", "zeros.ini"].map(|file| scratch.path().join("out").join(file));
    let first = written().map(|file| std::fs::read(file).unwrap());
    scratch.replace(
        "campaign.toml",
        "[instrument]",
        "[conditions]\ncontroller_backup = \"before.ini\"\n\n[instrument]",
    );
    let missing = ends(&scratch, "run", 2, &["campaign.toml:"]);
    assert!(missing.contains("before.ini"), "{missing}");
    std::fs::write(scratch.path().join("before.ini"), "theta_2=0\n").unwrap();
    ends(&scratch, "run", 0, &[]);
    // a file that is loaded already keeps its hash when the way back is named
    assert_eq!(written().map(|file| std::fs::read(file).unwrap()), first);
    let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    // sha256sum
    assert!(html.contains("before.ini, SHA-256 4ea600a1"), "the hash of the backup");
    let LoadingCheck { joints, joint_values, before, after, mastered_joint_values, tolerance_mm, .. } =
        check_of(&scratch);
    let display_at = |values: &[f64], more: &[&str]| {
        let values: Vec<String> = values.iter().map(f64::to_string).collect();
        let table = format!("pose,{}\n1,{}\n", joints.join(","), values.join(","));
        std::fs::write(scratch.path().join("joints.csv"), table).unwrap();
        let direct = ["kinematics", "direct", "joints.csv", "--robot", "robot.toml"];
        let output = etalon(&scratch.path(), &[&direct[..], more].concat());
        assert!(output.status.success(), "{}", text_of(&output));
        let csv = String::from_utf8(output.stdout).unwrap();
        csv.lines().nth(1).unwrap().split(',').skip(1).map(|v| v.parse().unwrap()).collect::<Vec<f64>>()
    };
    let loaded = ["--parameters", "out/parameters.json", "--loaded", "out/zeros.ini"];
    // mastering changes the joint values, with which nominal parameters give the same display
    let states = [
        (&joint_values[..], &[][..], before),
        (&joint_values[..], &loaded[..], after),
        (&mastered_joint_values[..], &[][..], after),
    ];
    for (values, more, expected) in states {
        let found = display_at(values, more);
        let expected: Vec<f64> = expected.xyz_mm.into_iter().chain(expected.quaternion).collect();
        assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?} {expected:?}");
    }
    assert!((before.xyz_mm[0] - after.xyz_mm[0]).abs() > 0.01, "{before:?} {after:?}");
    // joint values as the report prints them move the display by less than its tolerance
    let printed: Vec<f64> = joint_values.iter().map(|value| format!("{value:.3}").parse().unwrap()).collect();
    let apart = display_at(&printed[..], &loaded[..])
        .iter()
        .zip(after.xyz_mm)
        .map(|(a, b)| (a - b).powi(2))
        .sum::<f64>()
        .sqrt();
    let tolerance_mm = tolerance_mm.unwrap();
    assert!(apart < tolerance_mm && tolerance_mm < 0.1, "{apart} {tolerance_mm}");
    // the contents of a file decide which file of the run it is, not its name
    std::fs::copy(scratch.path().join("out/zeros.ini"), scratch.path().join("sent by mail.txt")).unwrap();
    let copied = ["--parameters", "out/parameters.json", "--loaded", "sent by mail.txt"];
    assert!(display_at(&joint_values, &copied).iter().zip(after.xyz_mm).all(|(a, b)| (a - b).abs() < 1e-9));
    std::fs::write(scratch.path().join("zeros.ini"), "theta_2=0\n").unwrap();
    for other in ["zeros.ini", "other.ini"] {
        let loaded = ["--parameters", "out/parameters.json", "--loaded", other];
        let direct = ["kinematics", "direct", "joints.csv", "--robot", "robot.toml"];
        let refused = text_of(&etalon(&scratch.path(), &[&direct[..], &loaded].concat()));
        assert!(refused.says(&format!("error[file-not-of-run] file={other}")), "{other}: {refused}");
    }
}

/// A display knows joint values alone: the announced poses are without load, torques, temperature and direction of approach.
#[test]
fn the_announced_display_is_that_of_the_joint_values_alone() {
    for sample in ["elastic-arm", "payload-arm", "rail-arm", "torque-arm", "warming-arm"] {
        let scratch = copy_sample(sample);
        ends(&scratch, "run", 0, &[]);
        let campaign: CampaignSummary = scratch.document("campaign.json");
        let file = campaign.controller_files.iter().find(|file| file.check.is_some()).unwrap();
        // what robot.toml lets bend, drift or expand
        let inputs: BTreeSet<String> = file.inputs.iter().map(|i| format!("{}={}", i.column, i.neutral)).collect();
        let expected: &[&str] = match sample {
            "elastic-arm" | "payload-arm" => &["load_kg=0", "load_x_mm=0", "load_y_mm=0", "load_z_mm=0"],
            "torque-arm" => &["tau2_nm=0", "tau3_nm=0", "tau4_nm=0", "tau5_nm=0"],
            "warming-arm" => &["temperature_c=20"],
            _ => &[],
        };
        assert!(expected.iter().all(|input| inputs.contains(*input)), "{sample}: {inputs:?}");
        assert!(!expected.is_empty() || inputs.is_empty(), "{sample}: {inputs:?}");
        let check = file.check.as_ref().unwrap();
        // effects of load, torques, temperature and backlash at the measured poses, computed by a reader of the report
        let effect_mm = check.with_inputs.as_ref().map_or(0.0, |found| found.effect_mm);
        let (expected_mm, digit_mm) = match sample {
            "elastic-arm" => (1.1, 0.1),
            "payload-arm" => (0.24, 0.005),
            "torque-arm" => (0.97, 0.005),
            "warming-arm" => (0.175, 0.0005),
            _ => (0.26, 0.05),
        };
        assert!((effect_mm - expected_mm).abs() <= digit_mm, "{sample}: {effect_mm} mm");
        let values: Vec<String> = check.joint_values.iter().map(f64::to_string).collect();
        let table = format!("pose,{}\n1,{}\n", check.joints.join(","), values.join(","));
        std::fs::write(scratch.path().join("joints.csv"), table).unwrap();
        let direct = ["kinematics", "direct", "joints.csv", "--robot", "robot.toml"];
        let loaded = ["--parameters", "out/parameters.json", "--loaded", &file.file];
        let output = etalon(&scratch.path(), &[&direct[..], &loaded[..]].concat());
        assert!(output.status.success(), "{sample}: {}", text_of(&output));
        let csv = String::from_utf8(output.stdout).unwrap();
        let found = csv.lines().nth(1).unwrap().split(',').skip(1).map(|v| v.parse::<f64>().unwrap());
        let apart = found.zip(check.after.xyz_mm).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-9, "{sample}: {apart} mm");
    }
}

/// After mastering, the joint values of the controller contain the loaded zeros: the robot is the same.
#[test]
fn a_robot_with_loaded_zeros_is_verified_by_its_new_joint_values() {
    let scratch = arm();
    ends(&scratch, "run", 1, &[]);
    let controllers: ControllersDocument = scratch.document("controllers.json");
    let parameters: etalon::documents::ParametersDocument = scratch.document("parameters.json");
    let change: BTreeMap<String, f64> = controllers.files[0]
        .values
        .iter()
        .filter_map(|v| {
            let nominal = parameters.parameters.iter().find(|p| p.name == v.name)?.nominal;
            Some((format!("q{}_deg", v.name.strip_prefix("theta_")?), v.value - nominal))
        })
        .collect();
    let observed = std::fs::read_to_string(scratch.path().join("observations.csv")).unwrap();
    let heads: Vec<&str> = observed.lines().next().unwrap().split(',').collect();
    let shifted = |line: &str| {
        let cell = |(head, cell): (&&str, &str)| match change.get(*head) {
            Some(change) => format!("{}", cell.parse::<f64>().unwrap() + change),
            None => cell.to_owned(),
        };
        heads.iter().zip(line.split(',')).map(cell).collect::<Vec<_>>().join(",")
    };
    let rows: Vec<String> = observed.lines().skip(1).take(40).map(shifted).collect();
    std::fs::write(scratch.path().join("after.csv"), format!("{}\n{}\n", heads.join(","), rows.join("\n"))).unwrap();
    let verify = ["verify", "after.csv", "--robot", "robot.toml", "--parameters", "out/parameters.json"];
    let without = etalon(&scratch.path(), &verify);
    assert_eq!(without.status.code(), Some(1), "{}", text_of(&without));
    let with = etalon(&scratch.path(), &[&verify[..], &["--mastered", "zeros.ini"]].concat());
    assert_eq!(with.status.code(), Some(0), "{}{}", text_of(&with), String::from_utf8_lossy(&with.stdout));
}

/// After loading, the exports and logs of a copy of the campaign are read like the files of the calibration.
#[test]
fn a_campaign_is_verified_like_its_table_of_observations() {
    let scratch = copy_sample("column-arm");
    ends(&scratch, "run", 0, &[]);
    let verified = |observations: &str| -> serde_json::Value {
        let verify = ["verify", observations, "--robot", "robot.toml", "--parameters", "out/parameters.json", "--json"];
        let output = etalon(&scratch.path(), &verify);
        serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {}", text_of(&output)))
    };
    // eight poses of the calibration
    let rows = |name: &str, count: usize| -> String {
        let text = std::fs::read_to_string(scratch.path().join(name)).unwrap();
        text.lines().take(count).flat_map(|line| [line, "\n"]).collect()
    };
    let (log, measured) = (rows("encoders.csv", 9), rows("out/observations.csv", 25));
    std::fs::write(scratch.path().join("encoders.csv"), &log).unwrap();
    std::fs::write(scratch.path().join("eight.csv"), measured).unwrap();
    let (campaign, table) = (verified("."), verified("eight.csv"));
    assert_eq!(campaign["verdict"], "valid");
    let [of_campaign, of_table] = [&campaign, &table].map(|found| found["p_value"].as_f64().unwrap());
    assert!((of_campaign - of_table).abs() <= 1e-6 * of_table, "{of_campaign} {of_table}");
    // its files are the inputs
    let inputs = campaign["provenance"]["inputs"].as_object().unwrap();
    assert!(inputs.contains_key("encoders.csv") && inputs.contains_key("campaign.toml"), "{inputs:?}");
    // one of the logged zeros moves by 2 mrad
    let heads: Vec<&str> = log.lines().next().unwrap().split(',').collect();
    let joint = heads.iter().position(|head| *head == "elbow").unwrap();
    let moved = |line: &str| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        cells[joint] = format!("{}", cells[joint].parse::<f64>().unwrap() + 0.002);
        cells.join(",")
    };
    let rows: Vec<String> = log.lines().skip(1).map(moved).collect();
    std::fs::write(scratch.path().join("encoders.csv"), format!("{}\n{}\n", heads.join(","), rows.join("\n"))).unwrap();
    let verify = ["verify", ".", "--robot", "robot.toml", "--parameters", "out/parameters.json"];
    assert_eq!(etalon(&scratch.path(), &verify).status.code(), Some(1));
}

/// A pose that is excluded moves no other pose from calibration to validation.
#[test]
fn an_exclusion_does_not_move_the_split() {
    let sets = |excluded: &str| {
        let scratch = copy_sample("prexyt-cmm");
        let by_index = "calibration = \"index mod 2 < 1\"\nvalidation = \"rest\"";
        scratch.replace("campaign.toml", "calibration = \"1-8\"", &format!("{by_index}{excluded}"));
        let text = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
        let kept: Vec<&str> = text.lines().filter(|line| !line.starts_with("validation = \"9-59\"")).collect();
        std::fs::write(scratch.path().join("campaign.toml"), kept.join("\n")).unwrap();
        let campaign = etalon::campaign::Campaign::read(&scratch.path()).unwrap();
        let errors = evaluate(&campaign).unwrap().results.identified.unwrap().errors;
        errors.iter().map(|e| (e.pose, e.set)).collect::<BTreeMap<_, _>>()
    };
    let (all, fewer) = (sets(""), sets("\nexclude = [{ poses = \"4\", reason = \"touched\" }]"));
    assert_eq!(fewer.len() + 1, all.len());
    assert!(fewer.iter().all(|(pose, set)| all[pose] == *set), "{fewer:?}");
}

/// Messages on the terminal are in the language of the report.
#[test]
fn warnings_are_in_the_language_of_the_report() {
    for (language, english) in [("de", false), ("fr", false), ("en", true)] {
        let scratch = copy_sample("second-encoders");
        scratch.replace(
            "campaign.toml",
            "[instrument]",
            &format!("[report]\nlanguage = \"{language}\"\n\n[instrument]"),
        );
        let run = etalon(scratch.root(), &["run", "campaign"]);
        let parameters: etalon::documents::ParametersDocument = scratch.document("parameters.json");
        let shown = text_of(&run);
        let message = &parameters.messages[0];
        assert!(shown.contains(&message.in_language(language).what), "{language}: {shown}");
        assert_eq!(shown.contains(&message.what), english, "{language}: {shown}");
    }
}

/// 2026-03-01 at noon (`date -u -d`), SOURCE_DATE_EPOCH 1772366400.
#[test]
fn a_date_after_today_is_a_warning_that_no_document_contains() {
    let scratch = copy_sample("prexyt-cmm");
    let name = "name = \"PreXYT, CMM (synthetic)\"";
    scratch.replace("campaign.toml", name, &format!("{name}\ndate = \"2062-03-02\""));
    let mut command = std::process::Command::new(crate::support::program());
    command.args(["run", "campaign"]).current_dir(scratch.root()).env("SOURCE_DATE_EPOCH", "1772366400");
    let run = command.output().unwrap();
    assert_eq!(run.status.code(), Some(0), "{}", text_of(&run));
    let shown = text_of(&run);
    assert!(shown.says("warning[date-in-future] key=date date=2062-03-02 today=2026-03-01"), "{shown}");
    assert!(!std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap().contains("date-in-future"));
}

/// A URDF contains no zeros of joints: base and targets alone are as good as nominal parameters. The geometry of nine poses is better, as held-out
/// poses prove.
#[test]
fn an_effect_that_few_poses_prove_comes_before_nominal_parameters() {
    let scratch = copy_sample("column-arm");
    scratch.replace("campaign.toml", "calibration = \"1-60\"\nvalidation = \"61-80\"", "calibration = \"1-9\"");
    scratch.replace("campaign.toml", "[limits]\nposition_max_mm = 0.15", "");
    scratch.replace("campaign.toml", "effects = \"all\"", "effects = [\"zeros\"]");
    ends(&scratch, "run", 0, &[]);
    let verdict: VerdictDocument = scratch.document("verdict.json");
    let loading = verdict.loading.unwrap();
    assert_eq!((loading.answer, &loading.effects[..]), (LoadAnswer::IdentifyFurther, &[Effect::Geometry][..]));
    let step = verdict.actions.iter().find(|step| step.action == ActionKind::AddEffect).unwrap();
    scratch.replace("campaign.toml", "effects = [\"zeros\"]", step.line.as_deref().unwrap());
    let errors = || -> LeftOutErrors { scratch.document::<AccuracyDocument>("accuracy.json").left_out.unwrap() };
    let before = errors();
    let again = etalon(scratch.root(), &["run", "campaign"]);
    assert!(again.status.code() < Some(2), "{}", text_of(&again));
    assert!(errors().identified.rms < 0.7 * before.nominal.rms, "{before:?} {:?}", errors());
}

/// Ten poses of an arm that bends: its zeros and lengths absorb the bending at these poses, and not at others.
#[test]
fn parameters_of_few_poses_that_absorb_errors_of_the_model_are_not_loaded() {
    let scratch = copy_sample("elastic-arm");
    scratch.replace("campaign.toml", "calibration = \"1-60\"", "calibration = \"1-10\"");
    scratch.replace("campaign.toml", "[limits]\nposition_max_mm = 0.15", "");
    scratch.replace("campaign.toml", "effects = \"proven\"", "effects = \"usual\"");
    let rms = |accuracy: &AccuracyDocument| accuracy.sets.last().unwrap().leading().unwrap().after.rms;
    ends(&scratch, "run", 0, &[]);
    let judged: AccuracyDocument = scratch.document("accuracy.json");
    scratch.replace("campaign.toml", "validation = \"rest\"", "");
    ends(&scratch, "run", 1, &[]);
    let (accuracy, verdict): (AccuracyDocument, VerdictDocument) =
        (scratch.document("accuracy.json"), scratch.document("verdict.json"));
    // other poses have several times the errors of the calibration poses
    assert!(rms(&judged) > 5.0 * rms(&accuracy), "{} {}", rms(&judged), rms(&accuracy));
    assert!(verdict.reasons.iter().any(|reason| matches!(reason, Reason::ErrorsUnknown { .. })), "{verdict:?}");
    assert_ne!(verdict.loading.unwrap().answer, LoadAnswer::Load);
    assert!(verdict.actions.iter().any(|step| step.action == ActionKind::AddValidation), "{:?}", verdict.actions);
}
