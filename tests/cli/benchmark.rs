//! `etalon benchmark`: predicted measurements, and the scores of predictions.

use super::{etalon, text};
use std::path::Path;

/// Four rows at three poses; errors of positions 3-4-0, 0-0-0, 1-2-2 and 0-0-1 tenths of a millimetre, of orientations 0.1 deg about z.
const TRUTH: &str = "pose,target,x_mm,y_mm,z_mm,qw,qx,qy,qz\n\
    1,a,100,200,300,1,0,0,0\n1,b,110,200,300,1,0,0,0\n2,a,-50,20,30,0,1,0,0\n3,a,0,0,0,0.5,0.5,0.5,0.5\n";

/// The score of predictions of [`TRUTH`]; `more` are the other columns in the order of the rows 3, 1b, 2, 1a.
fn score(head: &str, more: [&str; 4]) -> serde_json::Value {
    let folder = tempfile::tempdir().unwrap();
    let rows = ["3,a,0,0,0.1", "1,b,110,200,300", "2,a,-49.9,20.2,30.2", "1,a,100.3,200.4,300"];
    let rows: String = rows.iter().zip(more).map(|(row, more)| format!("{row}{more}\n")).collect();
    std::fs::write(folder.path().join("p.csv"), format!("pose,target,x_mm,y_mm,z_mm{head}\n{rows}")).unwrap();
    std::fs::write(folder.path().join("t.csv"), TRUTH).unwrap();
    let output = etalon(folder.path(), &["benchmark", "score", "p.csv", "--truth", "t.csv", "--json"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let plain = etalon(folder.path(), &["benchmark", "score", "p.csv", "--truth", "t.csv"]);
    assert!(text(&plain.stdout).contains("position, mm"), "{}", text(&plain.stdout));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn close(found: &serde_json::Value, expected: f64) {
    assert!((found.as_f64().unwrap() - expected).abs() < 1e-9, "{found} {expected}");
}

#[test]
fn errors_of_positions_by_hand() {
    let found = score("", [""; 4]);
    let position = &found["position"];
    // sizes 0.5, 0, 0.3 and 0.1; the 95th percentile is 0.85 of the way from 0.3 to 0.5
    close(&position["errors"]["mean"], 0.225);
    close(&position["errors"]["rms"], (0.35f64 / 4.0).sqrt());
    close(&position["errors"]["p95"], 0.47);
    close(&position["errors"]["max"], 0.5);
    assert!(position.get("intervals").is_none() && found.get("orientation").is_none(), "{found}");
    assert_eq!((found["poses"].as_u64(), found["rows"].as_u64()), (Some(3), Some(4)));
}

#[test]
fn intervals_of_positions_are_those_of_scipy() {
    // 12 coordinates; within ±0.195996 lie all but 0.3 and 0.4 of pose 1 and 0.2 and 0.2 of pose 2
    let found = score(",u_mm", [",0.1"; 4]);
    let intervals = &found["position"]["intervals"];
    let half = 0.195_996_398_454_005_4; // 0.1 scipy.stats.norm.ppf(0.975)
    close(&intervals["coverage"], 8.0 / 12.0);
    close(&intervals["mean_width"], 2.0 * half);
    close(&intervals["mean_score"], 2.0 * half + 40.0 / 12.0 * (0.3 + 0.4 + 0.2 + 0.2 - 4.0 * half));
    // poses have 4 of 6, 1 of 3 and 3 of 3: Σ (a − 2/3 b)² = 0 + 1 + 1; times 3/2, over 12
    close(&intervals["coverage_standard_uncertainty"], 3f64.sqrt() / 12.0);
    // scipy.stats.beta.ppf(0.025, 2, 2) and beta.ppf(0.975, 3, 1): two of three poses
    close(&intervals["coverage_interval"][0], 0.094_299_324_050_246_09);
    close(&intervals["coverage_interval"][1], 0.991_596_241_340_387_4);
    // the same as ends, and as a covariance; scipy.stats.chi2.ppf(0.95, 3) = 7.814728: 25, 0, 9, 1 hundredths over 0.01
    let [low, high] = [-half, half];
    let ends = |x: f64, y: f64, z: f64| {
        let ends = [x + low, x + high, y + low, y + high, z + low, z + high];
        ends.iter().map(|v| format!(",{v:?}")).collect::<String>()
    };
    let rows = [ends(0.0, 0.0, 0.1), ends(110.0, 200.0, 300.0), ends(-49.9, 20.2, 30.2), ends(100.3, 200.4, 300.0)];
    let again = score(",x_low_mm,x_high_mm,y_low_mm,y_high_mm,z_low_mm,z_high_mm", rows.each_ref().map(String::as_str));
    close(&again["position"]["intervals"]["mean_score"], intervals["mean_score"].as_f64().unwrap());
    let again = score(",cxx_mm2,cxy_mm2,cxz_mm2,cyy_mm2,cyz_mm2,czz_mm2", [",0.01,0,0,0.01,0,0.01"; 4]);
    close(&again["position"]["intervals"]["mean_score"], intervals["mean_score"].as_f64().unwrap());
    close(&again["position"]["ellipsoid_coverage"], 0.5);
}

#[test]
fn orientations_are_compared_by_their_angle() {
    // turned by 0.1 deg about z of the world: (cos, 0, 0, sin) of 0.05 deg times the measured quaternion
    let (c, s) = (0.05f64.to_radians().cos(), 0.05f64.to_radians().sin());
    let turned = [[0.5 * c - 0.5 * s, 0.5 * c - 0.5 * s, 0.5 * c + 0.5 * s, 0.5 * c + 0.5 * s], [1.0, 0.0, 0.0, 0.0]];
    let turned = [turned[0], turned[1], [0.0, c, s, 0.0], [c, 0.0, 0.0, s]];
    let rows = turned.map(|q| format!(",{:?},{:?},{:?},{:?},0.03", q[0], q[1], q[2], q[3]));
    let found = score(",qw,qx,qy,qz,urot_deg", rows.each_ref().map(String::as_str));
    let orientation = &found["orientation"];
    close(&orientation["errors"]["mean"], 0.075);
    close(&orientation["errors"]["max"], 0.1);
    // of 12 components three are beyond 1.96 · 0.03 deg
    close(&orientation["intervals"]["coverage"], 0.75);
    assert_eq!(orientation["unit"], "deg");
}

/// The score of a calibration of the sample at its own poses, with stated uncertainties, and its parameters.
fn own_score(um: &str, deg: &str) -> [serde_json::Value; 2] {
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/probe-poses");
    let folder = tempfile::tempdir().unwrap();
    let [robot, table] = ["robot.toml", "observations.csv"].map(|file| sample.join(file).display().to_string());
    let rows = std::fs::read_to_string(&table).unwrap();
    let row = |(i, line): (usize, &str)| format!("{},{line}\n", if i == 0 { "kind" } else { "pose" });
    std::fs::write(folder.path().join("o.csv"), rows.lines().enumerate().map(row).collect::<String>()).unwrap();
    let options = ["--standard-uncertainty-um", um, "--rotation-uncertainty-deg", deg, "--json"];
    let identify = ["identify", "--robot", &robot, "--observations", "o.csv"];
    let output = etalon(folder.path(), &[&identify[..], &options].concat());
    std::fs::write(folder.path().join("parameters.json"), &output.stdout).unwrap();
    let parameters: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let predict = ["benchmark", "predict", &table, "--robot", &robot, "--parameters", "parameters.json"];
    let output = etalon(folder.path(), &predict);
    assert!(output.status.success(), "{}", text(&output.stderr));
    std::fs::write(folder.path().join("p.csv"), &output.stdout).unwrap();
    let output = etalon(folder.path(), &[&predict[..], &["--json"]].concat());
    let listed: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(listed["predictions"].as_array().unwrap().len(), rows.lines().count() - 1);
    let output = etalon(folder.path(), &["benchmark", "score", "p.csv", "--truth", &table, "--json"]);
    [serde_json::from_slice(&output.stdout).unwrap(), parameters]
}

/// At its own poses the prediction of a calibration has the residuals of the calibration.
#[test]
fn predictions_have_the_residuals_of_the_calibration() {
    let [found, parameters] = own_score("30", "0.01");
    let residuals = &parameters["residuals"];
    close(&found["position"]["errors"]["rms"], residuals["position_rms_mm"].as_f64().unwrap());
    let turned = residuals["conditions"].as_array().unwrap().iter().find(|c| c["quantity"] == "orientation").unwrap();
    close(&found["orientation"]["errors"]["rms"], 3f64.sqrt() * turned["rms"].as_f64().unwrap());
}

/// Intervals of 95 % hold, also if the uncertainties are stated ten times too small.
#[test]
fn intervals_hold_if_uncertainties_are_stated_too_small() {
    for (um, deg) in [("30", "0.01"), ("3", "0.001")] {
        let [found, _] = own_score(um, deg);
        for quantity in ["position", "orientation"] {
            let held = found[quantity]["intervals"]["coverage"].as_f64().unwrap();
            assert!((0.90..=0.995).contains(&held), "{um} um, {deg} deg: {quantity} {held}");
        }
    }
}

/// Ten times too large a stated uncertainty is a warning, and intervals follow the residuals.
#[test]
fn intervals_follow_the_residuals_if_the_uncertainty_is_stated_too_large() {
    let [right, large] = [("30", "0.01"), ("300", "0.1")].map(|(um, deg)| own_score(um, deg));
    let messages = large[1]["messages"].as_array().unwrap();
    assert!(messages.iter().any(|m| m["id"] == "instrument-uncertainty-too-large"), "{messages:?}");
    for quantity in ["position", "orientation"] {
        let [right, large] = [&right[0], &large[0]].map(|found| found[quantity]["intervals"].clone());
        let width = |found: &serde_json::Value| found["mean_width"].as_f64().unwrap();
        assert!((width(&large) / width(&right) - 1.0).abs() < 0.15, "{quantity}: {large} beside {right}");
        assert!(large["coverage"].as_f64().unwrap() < 0.995, "{quantity}: {large}");
    }
}
