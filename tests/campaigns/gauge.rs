//! One robot in two descriptions, Denavit-Hartenberg parameters and screw axes, gives equally sound results. Synthetic.

use crate::support::scratch::{copy_sample, etalon};
use etalon::base::noise::Noise;
use etalon::base::pose::Pose;
use serde_json::Value;

/// alpha (deg), a (mm), theta (deg), d (mm) of an invented six-axis arm of 0.9 m reach with a spherical wrist, offset by a shoulder.
const DH: [[f64; 4]; 6] = [
    [-90.0, 75.0, 0.0, 450.0],
    [0.0, 300.0, -90.0, 0.0],
    [-90.0, 80.0, 0.0, 0.0],
    [90.0, 0.0, 0.0, 310.0],
    [-90.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 74.0],
];
/// Standard uncertainty of a coordinate, mm.
const U_MM: f64 = 0.05;

fn dh() -> String {
    let row = |r: &[f64; 4]| {
        format!("    {{ alpha_deg = {}, a_mm = {}, theta_deg = {}, d_mm = {} }},\n", r[0], r[1], r[2], r[3])
    };
    format!("model = \"serial\"\nconvention = \"dh\"\njoint = [\n{}]\n", DH.iter().map(row).collect::<String>())
}

/// The same arm by its axes at zero joints, as `etalon init --robot` writes robots.
fn poe() -> String {
    let mut frame = Pose::identity();
    let mut joints = String::new();
    for [alpha, a, theta, d] in DH {
        let text = |v: [f64; 3]| v.map(|v| format!("{:?}", (1e9 * v).round() / 1e9)).join(", ");
        joints +=
            &format!("    {{ direction = [{}], point_mm = [{}] }},\n", text(frame.axis(2)), text(frame.translation_mm));
        frame = frame.turn_z(theta.to_radians()).shift(2, d).shift(0, a).turn_x(alpha.to_radians());
    }
    let [x, y, z] = frame.translation_mm;
    let [r, p, w] = frame.rpy_rad().map(f64::to_degrees);
    format!(
        "model = \"serial\"\nconvention = \"poe\"\nflange_xyz_mm = [{x:?}, {y:?}, {z:?}]\nflange_rpy_deg = [{r:?}, {p:?}, {w:?}]\njoint = [\n{joints}]\n"
    )
}

/// Exit code, messages, validation error (RMS, mm) and the identified parameters of a run with this robot.toml.
fn run(robot: &str, table: &str) -> (Option<i32>, String, f64, Vec<Value>) {
    let scratch = copy_sample("draw-wire");
    std::fs::write(scratch.path().join("robot.toml"), robot).unwrap();
    std::fs::write(scratch.path().join("observations.csv"), table).unwrap();
    scratch.replace("campaign.toml", "effects = \"all\" # gains of turning joints too\n", "");
    scratch.replace("campaign.toml", "calibration = \"1-60\"", "calibration = \"index mod 2 < 1\"");
    scratch.replace("campaign.toml", "[limits]\ndistance_max_mm = 0.4\n", "");
    let (code, said) = etalon(&scratch, "run");
    let read = |name: &str| -> Value {
        std::fs::read(scratch.path().join("out").join(name))
            .ok()
            .map_or(Value::Null, |b| serde_json::from_slice(&b).unwrap())
    };
    let rms = read("accuracy.json")["sets"][1]["errors"][0]["after"]["rms"].as_f64().unwrap_or(f64::NAN);
    let parameters = read("parameters.json")["parameters"].as_array().cloned().unwrap_or_default();
    (code, said, rms, parameters)
}

/// Positions of a ball at random poses, each joint within a share of its range.
fn table(poses: usize, share: f64, seed: u64) -> String {
    let scratch = copy_sample("draw-wire");
    std::fs::write(scratch.path().join("robot.toml"), dh()).unwrap();
    let file = etalon::campaign::read_robot(&scratch.path().join("robot.toml")).unwrap();
    let robot = file.build(&["ball".to_owned()]).unwrap();
    let mut noise = Noise::new(40, seed);
    let mut values = robot.nominal();
    for (value, p) in values.iter_mut().zip(robot.parameters()) {
        *value += match p.name.split('_').next().unwrap() {
            "base" => noise.uniform(if p.name.contains('r') { 0.4 } else { 800.0 }),
            "ball" => 60.0 + noise.uniform(40.0),
            "a" | "d" => noise.uniform(0.5),
            "gain" => 0.0,
            _ => noise.uniform(2e-3),
        };
    }
    let mut table = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    let middle: [f64; 6] = [0.3, -0.4, 0.5, 0.2, 0.8, -0.3];
    for pose in 1..=poses {
        let ranges = [2.6, 1.0, 1.1, 2.8, 1.7, 3.0];
        let q: Vec<f64> = (0..6).map(|j| (1.0 - share) * middle[j] + share * noise.uniform(ranges[j])).collect();
        let at = robot.position(&values, &q, 0).map(|v| v + noise.gaussian(U_MM));
        let q: Vec<String> = q.iter().map(|q| format!("{:.9}", q.to_degrees())).collect();
        table += &format!("{pose},ball,{},{:.5},{:.5},{:.5}\n", q.join(","), at[0], at[1], at[2]);
    }
    table
}

#[test]
fn screw_axes_and_denavit_hartenberg_parameters_are_equally_sound() {
    for (poses, share, seed) in [(120, 0.25, 2), (30, 1.0, 3), (24, 0.2, 4)] {
        let table = table(poses, share, seed);
        let (by_dh, by_poe) = (run(&dh(), &table), run(&poe(), &table));
        for (name, (code, said, ..)) in [("dh", &by_dh), ("poe", &by_poe)] {
            assert_eq!(*code, Some(0), "{name}, {poses} poses, {share}: {said}");
        }
        println!("{poses} poses, share {share}: dh {:.4}, poe {:.4} mm", by_dh.2, by_poe.2);
        assert!((by_poe.2 / by_dh.2 - 1.0).abs() < 0.15, "{poses} poses, {share}: {} {}", by_dh.2, by_poe.2);
        // no part is anywhere near its tolerance: errors are half a millimetre
        for p in by_poe.3.iter().filter(|p| p["role"] == "robot" && p["unit"] == "mm") {
            let change = p["value"].as_f64().unwrap() - p["nominal"].as_f64().unwrap();
            assert!(change.abs() < 4.0, "{poses} poses, {share}: {p}");
        }
    }
}
