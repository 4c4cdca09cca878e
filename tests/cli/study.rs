//! `etalon study`, and errors of a simulated robot that no parameter describes.

use super::etalon;
use crate::support::root;
use crate::support::said::Says;
use crate::support::scratch::{Scratch, cmm_truth, copy_sample, ends, said};
use etalon::base::pose::{Pose, Vector, minus};
use etalon::documents::{StudiedDesign, StudiesDocument};
use etalon::simulate::Truth;

/// The study of the sample with few draws and commands.
fn study(scratch: &Scratch, changes: &[(&str, &str)]) -> (Option<i32>, String, String) {
    let sample = root().join("samples/prexyt-cmm/study.toml");
    let text = std::fs::read_to_string(sample).unwrap();
    let few = [
        ("draws = 100", "draws = 6"),
        ("count = 1000", "count = 20"),
        ("noise_um = [5.0, 2.5, 1.35]", "noise_um = [5.0, 1.0]"),
    ];
    let text = few.iter().chain(changes).fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    std::fs::write(scratch.path().join("study.toml"), text).unwrap();
    let output = etalon(scratch.root(), &["study", "campaign/study.toml", "--json"]);
    (output.status.code(), super::text(&output.stdout), super::text(&output.stderr))
}

#[test]
fn sets_and_instruments_side_by_side() {
    let scratch = copy_sample("prexyt-cmm");
    let (code, answer, said) = study(&scratch, &[]);
    assert_eq!(code, Some(0), "{said}");
    let found: StudiesDocument = serde_json::from_str(&answer).unwrap();
    assert_eq!((found.designs.len(), found.error.english().contains("base frame")), (8, true));
    let design =
        |name: &str, noise_um: f64| found.designs.iter().find(|d| d.name == name && d.noise_um == noise_um).unwrap();
    let error = |d: &StudiedDesign, quantity: &str| d.after.iter().find(|e| e.quantity == quantity).unwrap().rms.median;
    // table 3.2: the smaller workspace and orientations, the larger the errors; x and y apart
    let position = |name| error(design(name, 5.0), "position");
    assert!(position("Set 1") < position("Set 1_1") && position("Set 1_1") < position("Set 2"), "{answer}");
    assert!(position("Set 2") < position("Set 2_2"));
    assert!(error(design("Set 2_2", 5.0), "x") > 2.0 * error(design("Set 2_2", 5.0), "y"));
    // noise a fifth as large: errors and scatter of parameters too, up to what is not linear
    let ratio = position("Set 1") / error(design("Set 1", 1.0), "position");
    assert!((ratio / 5.0 - 1.0).abs() < 0.02, "{ratio}");
    let three = |noise_um| design("Set 1", noise_um).parameters[5].three_standard_deviations.median;
    assert!((three(5.0) / three(1.0) / 5.0 - 1.0).abs() < 0.02);
    let d = &design("Set 1", 5.0).parameters[5];
    assert!((d.name.as_str(), d.actual) == ("d", 120.473) && (d.mean.median - d.actual).abs() < 0.03, "{d:?}");
    assert!(design("Set 1", 5.0).before[0].rms.median > 1.0);
    assert!(said.contains(" of 8: Set 2_2, 1 um, 6 draws"), "{said}");
}

#[test]
fn what_is_wrong_with_a_study_is_named() {
    let scratch = copy_sample("prexyt-cmm");
    for (from, to, part) in [
        ("beta = 1.204", "betta = 1.204", "[truth-parameter-unknown]"),
        ("[0.0, 300.0, 300.0],", "[0.0, 300.0],", "[truth-joint-count]"),
        ("theta_deg = [12.0, -10.0]", "thetas = [12.0]", "thetas"),
        ("robot = \"robot.toml\"", "robot = \"other.toml\"", "other.toml"),
    ] {
        let (code, _, said) = study(&scratch, &[(from, to)]);
        assert!(code == Some(2) && said.says(part), "{part}: {said}");
    }
}

/// Readings of the simulated poses in the world, with these changes of the truth, in the order of the export.
fn simulated(sample: &str, more: &str) -> Vec<Vector> {
    let scratch = copy_sample(sample);
    let path = scratch.path().join("truth.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let first = text.find("\n[").unwrap();
    std::fs::write(&path, format!("{}\nnoise_um = 0\n{}\n{more}\n", &text[..first], &text[first..])).unwrap();
    ends(&scratch, "simulate", 0, &[]);
    let placed = Truth::read(&path).unwrap().export_T_world;
    let into_world = Pose::from_xyz_rpy(placed.xyz_mm, placed.rpy_deg.map(f64::to_radians)).inverse();
    let export = std::fs::read_to_string(scratch.path().join("exports/poses.txt")).unwrap();
    let row = |line: &str| {
        let xyz: Vec<f64> = line.split([',', ' ']).skip(1).filter_map(|cell| cell.parse().ok()).collect();
        Some(into_world.apply(xyz.get(..3)?.try_into().ok()?))
    };
    export.lines().filter_map(row).collect()
}

#[test]
fn backlash_follows_the_direction_and_heat_grows_from_the_base() {
    let (robot, values, joints) = cmm_truth();
    let plain = simulated("prexyt-cmm", "");
    let lagging = simulated("prexyt-cmm", "[unmodelled]\nbacklash = { rho2 = 0.03 }");
    let warm = simulated("prexyt-cmm", "[unmodelled]\ngrowth_um_per_m_h = 50");
    assert_eq!(plain.len(), 2 * joints.len());
    for (i, q) in joints.iter().enumerate() {
        let up = if i == 0 { 0.0 } else { q[1] - joints[i - 1][1] };
        let lag = if up == 0.0 { 0.0 } else { -0.015 * up.signum() };
        for target in 0..2 {
            let expected = robot.position(&values, &[q[0], q[1] + lag, q[2]], target);
            let off = minus(lagging[2 * i + target], expected);
            assert!(off[0].abs() < 3e-5 && off[1].abs() < 3e-5, "pose {i}: {off:?}");
            let p = plain[2 * i + target];
            let grown = minus(warm[2 * i + target], p);
            // x_o and y_o; turns are ten seconds apart
            let factor = 50e-6 * (10.0 * (i + 1) as f64 / 3600.0);
            let wanted = [factor * (p[0] - values[8]), factor * (p[1] - values[9])];
            assert!((grown[0] - wanted[0]).abs() < 3e-5 && (grown[1] - wanted[1]).abs() < 3e-5, "{grown:?} {wanted:?}");
        }
    }
}

/// Backlash that `simulate` adds to an arm on a column comes back as parameters, by the directions of a log with times.
#[test]
fn simulated_backlash_is_identified_by_the_times_of_the_log() {
    let scratch = copy_sample("column-arm");
    let edit = |file: &str, change: &dyn Fn(String) -> String| {
        let path = scratch.path().join(file);
        std::fs::write(&path, change(std::fs::read_to_string(&path).unwrap())).unwrap();
    };
    let lost = [("shoulder_pan", 0.04), ("shoulder_lift", 0.03), ("wrist_2", 0.02)];
    edit("robot.toml", &|text| text + "backlash = [\"shoulder_pan\", \"shoulder_lift\", \"wrist_2\"]\n");
    let stated: Vec<String> = lost.iter().map(|(joint, gap)| format!("{joint} = {gap}")).collect();
    let quiet =
        |text: String| text.replace("seed = 18", "seed = 18\nnoise_um = 0").replace("decimals = 9", "decimals = 12");
    // gains and bending follow the true joint in the simulated arm, the logged value in the model
    let rigid = |text: String| {
        let own = |line: &&str| !line.starts_with("gain_") && !line.starts_with("compliance_");
        text.lines().filter(own).map(|line| format!("{line}\n")).collect::<String>()
    };
    edit("truth.toml", &|text| rigid(quiet(text)) + &format!("[unmodelled]\nbacklash = {{ {} }}\n", stated.join(", ")));
    ends(&scratch, "simulate", 0, &[]);
    ends(
        &scratch,
        "run",
        2,
        &["error[approach-direction-unknown] log=log joint=shoulder_pan", "`time_s` in `columns`"],
    );
    edit("campaign.toml", &|text| text.replace("[identify]\n", "[identify]\nprior = \"none\"\n"));
    edit("campaign.toml", &|text| text.replace("[log.columns]", "[log.columns]\ntime_s = \"time_s\""));
    ends(&scratch, "simulate", 0, &[]);
    ends(&scratch, "run", 0, &["warning[backlash-direction-unknown]", "`log`"]);
    let text = std::fs::read_to_string(scratch.path().join("out/parameters.json")).unwrap();
    let document: serde_json::Value = serde_json::from_str(&text).unwrap();
    for (joint, gap) in lost {
        let name = format!("backlash_{joint}");
        let found = document["parameters"].as_array().unwrap().iter().find(|p| p["name"] == name.as_str()).unwrap();
        let off = found["value"].as_f64().unwrap() - gap;
        assert!(off.abs() < 1e-9, "{name}: off by {off}");
    }
}

#[test]
fn bending_lowers_a_robot_in_space_by_the_third_power_of_its_reach() {
    let (plain, bent) = (simulated("delta", ""), simulated("delta", "[unmodelled]\nbending_um_at_1_m = 2000"));
    assert!(!plain.is_empty() && plain.len() == bent.len());
    let mut largest = 0.0f64;
    for (p, q) in plain.iter().zip(&bent) {
        let off = minus(*q, *p);
        assert!(off[0].abs() < 3e-4 && off[1].abs() < 3e-4 && off[2] <= 1e-4, "{off:?}");
        largest = largest.max(-off[2]);
    }
    assert!(largest > 1e-3, "{largest}");
}

#[test]
fn errors_that_no_parameter_describes_are_stated_and_refused_by_name() {
    let scratch = copy_sample("prexyt-cmm");
    let truth = std::fs::read_to_string(scratch.path().join("truth.toml")).unwrap();
    let with = |more: &str| {
        std::fs::write(scratch.path().join("truth.toml"), format!("{truth}\n[unmodelled]\n{more}\n")).unwrap()
    };
    with(
        "backlash = { rho2 = 0.03 }\ninterpolation = { rho1 = { amplitude = 0.004, period = 5.08 } }\nhoming = { rho3 = 0.002 }",
    );
    let stated = said(&scratch, &["simulate", "campaign"]).1;
    for part in [
        "errors that no parameter of the model describes: backlash rho2 0.03",
        "interpolation rho1 0.004 every 5.08",
        "homing (standard deviation) rho3 0.002",
    ] {
        assert!(stated.contains(part), "{stated}");
    }
    ends(&scratch, "run", 0, &["the robot has errors that the model does not describe"]);
    for (wrong, part) in [
        ("backlash = { rho4 = 0.03 }", "error[unmodelled-joint-unknown] joint=rho4"),
        ("interpolation = { rho1 = { amplitude = 0.004, period = 0 } }", "error[unmodelled-period]"),
    ] {
        with(wrong);
        ends(&scratch, "simulate", 2, &[part]);
    }
}
