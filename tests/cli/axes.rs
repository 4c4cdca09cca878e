//! `etalon axes`: sweeps of one joint at a time give axes and a robot without a nominal model.

use super::{etalon, text};
use crate::support::said::Says;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::campaign::read_robot;
use etalon::documents::{AxesDocument, AxesRobot};
use etalon::robots::AxisLine;
use std::fmt::Write;
use std::path::Path;

/// Four axes of an arm whose base is turned in the world (synthetic).
fn arm() -> Vec<AxisLine> {
    let axis = |direction, point_mm, prismatic| AxisLine { direction, point_mm, prismatic };
    let base = Pose::from_xyz_rpy([1500.0, -400.0, 250.0], [0.02, -0.03, 0.7]);
    let axes = [
        axis([0.0, 0.0, 1.0], [0.0, 0.0, 0.0], false),
        axis([0.0, 1.0, 0.0], [60.0, 0.0, 290.0], false),
        axis([0.0, 1.0, 0.001].map(|v: f64| v / 1.000_000_5), [60.0, 0.0, 560.0], false),
        axis([1.0, 0.0, 0.0], [300.0, 0.0, 600.0], true),
    ];
    axes.iter().map(|a| a.moved(&base)).collect()
}

const TARGET: Vector = [1950.0, -100.0, 900.0];

fn position(joints: &[f64]) -> Vector {
    arm().iter().zip(joints).fold(Pose::identity(), |pose, (a, q)| pose.then(&a.motion(*q))).apply(TARGET)
}

/// Rows of the four sweeps: swept joint, position, joint values (rad, mm).
fn rows() -> Vec<(usize, Vector, [f64; 4])> {
    let mut noise = Noise::new(7, 0);
    let mut rows = Vec::new();
    for joint in 0..4 {
        for i in 0..24 {
            let mut q = [0.0; 4];
            q[joint] = f64::from(i) * if joint == 3 { 20.0 } else { 0.06 };
            rows.push((joint, position(&q).map(|v| v + noise.gaussian(0.01)), q));
        }
    }
    rows
}

fn table(rows: &[(usize, Vector, [f64; 4])], values: bool) -> String {
    let mut out = "joint,x_mm,y_mm,z_mm".to_owned() + if values { ",q1_deg,q2_deg,q3_deg,q4_mm\n" } else { "\n" };
    for (joint, p, q) in rows {
        let name = if *joint < 4 { format!("q{}", joint + 1) } else { String::new() };
        let _ = write!(out, "{name},{:.5},{:.5},{:.5}", p[0], p[1], p[2]);
        if values {
            let [a, b, c] = [0, 1, 2].map(|k| q[k].to_degrees());
            let _ = write!(out, ",{a:.9},{b:.9},{c:.9},{}", q[3]);
        }
        out.push('\n');
    }
    out
}

fn run(table: &str, arguments: &[&str]) -> (Option<i32>, Vec<u8>, String) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("sweeps.csv"), table).unwrap();
    let output = etalon(folder.path(), &[&["axes", "sweeps.csv"], arguments].concat());
    (output.status.code(), output.stdout, text(&output.stderr))
}

fn document(table: &str, arguments: &[&str]) -> AxesDocument {
    let (code, out, err) = run(table, &[arguments, &["--json"]].concat());
    assert_eq!(code, Some(0), "{err}");
    serde_json::from_slice(&out).unwrap()
}

/// Distance of the robot of a document from the truth at joint values, mm.
fn miss_mm(document: &AxesDocument, joints: &[f64]) -> f64 {
    let robot = document.robot.as_ref().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("robot.toml");
    std::fs::write(&path, &robot.robot_toml).unwrap();
    let built = read_robot(Path::new(&path)).unwrap().build(&["tool".to_owned()]).unwrap();
    let pose = built.kinematics().unwrap().tool_pose(&built.nominal(), joints).unwrap();
    let base = Pose { translation_mm: robot.base_xyz_mm, ..Pose::from_quaternion(robot.base_quaternion) };
    norm(minus(base.then(&pose).apply(robot.targets[0].xyz_mm), position(joints)))
}

#[test]
fn sweeps_give_a_robot_that_reaches_where_the_truth_does() {
    let with = document(&table(&rows(), true), &[]);
    assert!(with.messages.is_empty() && with.joint_values, "{:?}", with.messages);
    assert_eq!(with.axes.iter().map(|a| a.prismatic).collect::<Vec<_>>(), [false, false, false, true]);
    for (axis, truth) in with.axes.iter().zip(arm()) {
        let off = norm(minus(axis.line.direction, truth.direction)).to_degrees();
        assert!(off < 4.0 * axis.line.direction_standard_uncertainty_deg, "{} {off}", axis.joint);
    }
    let without = document(&table(&rows(), false), &["--prismatic", "q4"]);
    assert!(without.messages.is_empty() && !without.joint_values, "{:?}", without.messages);
    for found in [&with, &without] {
        let miss = miss_mm(found, &[-0.5, 0.9, 0.4, 150.0]);
        assert!(miss > 1e-6 && miss < 0.2, "{miss}");
    }
    // a table loses the tilt of axis 3 against axis 2, 1 mrad, and says so
    let table = document(&table(&rows(), true), &["--convention", "mdh"]);
    assert!(table.messages.iter().any(|m| m.id == "table-tilt-not-held"), "{:?}", table.messages);
    let miss = miss_mm(&table, &[-0.5, 0.9, 0.4, 150.0]);
    assert!(miss > 0.1 && miss < 2.0, "{miss}");
}

/// The robot file states as tolerances what the sweeps determine, and `run` reads them as prior information.
fn states_what_the_sweeps_determine(arguments: &[&str]) -> AxesRobot {
    let found = document(&table(&rows(), true), arguments).robot.unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("robot.toml");
    std::fs::write(&path, &found.robot_toml).unwrap();
    let built = read_robot(Path::new(&path)).unwrap().build(&["tool".to_owned()]).unwrap();
    let n = found.covariance.len();
    assert!(n > 7 && found.parameters.len() > n && found.covariance.iter().all(|row| row.len() == n));
    for (k, p) in found.parameters[..n].iter().enumerate() {
        let built = &built.parameters()[built.index(&p.name).unwrap_or_else(|| panic!("{}", p.name))];
        assert!((built.quantity.outward(built.nominal) - p.value).abs() < 1e-6, "{}: {}", p.name, p.value);
        assert!((found.covariance[k][k].sqrt() / p.standard_uncertainty - 1.0).abs() < 1e-9, "{}", p.name);
        let Some(tolerance) = p.tolerance else { continue };
        assert!(tolerance > 4.3 * p.standard_uncertainty && built.tolerance_is_stated, "{}", p.name);
        // rounded up to two digits
        let stated = built.quantity.outward(built.tolerance);
        assert!(stated >= tolerance * (1.0 - 1e-9) && stated < 1.11 * tolerance, "{}: {stated} {tolerance}", p.name);
    }
    found
}

/// A tilt that a table loses is within the tolerance of Hayati's angle. What a convention fixes has the smallest tolerance: the base
/// stands on axis 1.
#[test]
fn the_robot_file_states_what_the_sweeps_determine() {
    let stated =
        |found: &AxesRobot, name: &str| found.parameters.iter().find(|p| p.name == name).and_then(|p| p.tolerance);
    let found = states_what_the_sweeps_determine(&["--convention", "mdh"]);
    assert!(stated(&found, "beta_3").is_some_and(|t| t > 0.057 && t < 1.0), "{:?}", found.parameters);
    for name in ["alpha_1", "theta_1", "d_1"] {
        assert_eq!(stated(&found, name), Some(1e-6), "{name}");
    }
    let found = states_what_the_sweeps_determine(&[]);
    for name in ["q1_x", "q1_y", "q1_rx", "q1_ry"] {
        assert_eq!(stated(&found, name), Some(1e-6), "{name}");
    }
    // four numbers of a turning axis, two of a sliding one; six place the base
    assert_eq!((found.parameters.len(), found.covariance.len()), (14, 8), "{:?}", found.parameters);
}

#[test]
fn check_poses_test_order_and_signs() {
    let mut rows = rows();
    for q in [[0.3, -0.4, 0.5, 100.0], [-0.6, 0.7, -0.2, 300.0], [1.0, 0.1, 0.8, 30.0]] {
        rows.push((9, position(&q), q));
    }
    let sound = document(&table(&rows, true), &[]);
    assert_eq!(sound.checks.len(), 3);
    assert!(sound.checks.iter().all(|c| c.distance_mm < 6.0 * c.standard_uncertainty_mm) && sound.messages.is_empty());
    // joints 2 and 3 named the other way round: at rest zero only the check poses show it
    let exchanged: Vec<_> = rows
        .iter()
        .map(|(joint, p, q)| (*[0, 2, 1, 3].get(*joint).unwrap_or(&9), *p, [q[0], q[2], q[1], q[3]]))
        .collect();
    let (code, _, err) = run(&table(&exchanged, true), &[]);
    assert!(code == Some(2) && err.says("error[sweeps-exchanged] first=q2 second=q3"), "{err}");
}

#[test]
fn slips_in_a_table_are_named() {
    let refused = |table: String, arguments: &[&str], id: &str| {
        let (code, out, err) = run(&table, arguments);
        assert!(code == Some(2) && out.is_empty() && err.contains(&format!("error[{id}]")), "{id}: {err}");
    };
    let sound = table(&rows(), true);
    refused(sound.replace("q1_deg", "q1_rad"), &[], "sweep-ratio");
    refused(sound.replace("q4_mm", "q4_m"), &[], "sweep-ratio");
    refused(sound.replace("q1_deg,q2_deg", "q2_deg,q1_deg"), &[], "sweep-other-joint");
    refused(sound.replace("q1,", "X,").replace("q2,", "Y,"), &[], "sweep-order-missing");
    refused(sound.clone(), &["--backwards", "q2"], "sweep-sign-by-values");
    refused(sound.clone(), &["--prismatic", "q7"], "sweep-joint-unknown");
    // a sweep that starts elsewhere has no zero
    let moved: Vec<_> = rows().into_iter().filter(|(joint, _, q)| *joint != 2 || q[2] > 0.0).collect();
    let (code, out, err) = run(&table(&moved, false), &["--prismatic", "q4", "--toml"]);
    assert!(code == Some(2) && out.is_empty() && err.contains("warning[sweep-starts-apart]"), "{err}");
    // one outlier
    let mut outlier = rows();
    outlier[30].1[2] += 3.0;
    let found = document(&table(&outlier, true), &[]);
    assert!(found.messages.iter().any(|m| m.id == "sweep-outliers"), "{:?}", found.messages);
    assert_eq!(found.axes[1].set_aside, [32]);
}

/// Table of one sweep of one joint, at these angles (deg) and with a deviation of the radius (mm).
fn one_sweep(angles: impl Iterator<Item = f64>, radial: impl Fn(f64) -> f64, written: impl Fn(f64) -> f64) -> String {
    let mut noise = Noise::new(13, 0);
    let place = Pose::from_xyz_rpy([700.0, -400.0, 500.0], [0.2, -0.1, 0.6]);
    let mut out = "joint,q1_deg,x_mm,y_mm,z_mm\n".to_owned();
    for angle in angles {
        let (sin, cos) = angle.to_radians().sin_cos();
        let radius = 450.0 + radial(angle.to_radians());
        let p = place.apply([radius * cos, radius * sin, 0.0]).map(|v| v + noise.gaussian(0.0005));
        let _ = writeln!(out, "q1,{:.5},{:.4},{:.4},{:.4}", written(angle), p[0], p[1], p[2]);
    }
    out
}

/// One sweep gives its axis with the uncertainty, and no base beyond it.
#[test]
fn one_sweep_gives_its_axis() {
    let table = one_sweep((0..31).map(|i| 2.0 * f64::from(i) - 30.0), |_| 0.0, |q| q);
    let found = document(&table, &[]);
    let axis = &found.axes[0];
    assert!(found.axes.len() == 1 && axis.line.direction_standard_uncertainty_deg > 0.0);
    let truth = Pose::from_xyz_rpy([0.0; 3], [0.2, -0.1, 0.6]).axis(2);
    let off = norm(minus(axis.line.direction, truth)).to_degrees();
    assert!(off < 5.0 * axis.line.direction_standard_uncertainty_deg, "{off}");
    for convention in ["poe", "mdh", "dh"] {
        let (code, out, err) = run(&table, &["--convention", convention, "--toml"]);
        assert!(code == Some(0) && !out.is_empty(), "{convention}: {err}");
    }
}

/// Run-out of some micrometres is reported, and no refusal; the uncertainty is larger than for
/// noise.
#[test]
fn run_out_is_reported() {
    let angles = || (0..120).map(|i| 0.84 * f64::from(i) - 50.0);
    let round = document(&one_sweep(angles(), |_| 0.0, |q| q), &[]);
    let run_out = |q: f64| 0.004 * (7.0 * q).sin() + 0.002 * (11.0 * q).cos();
    let found = document(&one_sweep(angles(), run_out, |q| q), &[]);
    assert!(round.messages.is_empty(), "{:?}", round.messages);
    assert!(found.messages.iter().any(|m| m.id == "sweep-smooth"), "{:?}", found.messages);
    let [u, of_noise] = [&found, &round].map(|d| d.axes[0].line.point_standard_uncertainty_mm.unwrap());
    assert!(u > 3.0 * of_noise && found.axes[0].set_aside.is_empty(), "{u} {of_noise}");
    assert!(found.axes[0].paths[0].radial_error_motion_mm > 0.007);
}

/// A sweep across half a turn, whose values the controller wraps.
#[test]
fn a_sweep_across_half_a_turn_is_one_motion() {
    let table =
        one_sweep((0..40).map(|i| 120.0 + 3.0 * f64::from(i)), |_| 0.0, |q| if q > 180.0 { q - 360.0 } else { q });
    let found = document(&table, &[]);
    assert!(found.messages.is_empty(), "{:?}", found.messages);
    assert!(
        (found.axes[0].motion.ratio.unwrap() - 1.0).abs() < 1e-4 && found.axes[0].motion.motion_rms.unwrap() < 0.01
    );
}

#[test]
fn a_joint_swept_backwards_is_named() {
    let mut rows = rows();
    let mut noise = Noise::new(9, 0);
    for row in rows.iter_mut().filter(|row| row.0 == 1) {
        row.1 = position(&[0.0, -row.2[1], 0.0, 0.0]).map(|v| v + noise.gaussian(0.01));
    }
    let without = table(&rows, false).lines().fold(String::new(), |mut out, line| {
        let more = if line.starts_with("joint") { ",q1_deg,q2_deg,q3_deg,q4_mm" } else { ",,,," };
        let _ = writeln!(out, "{line}{more}");
        out
    });
    let checks: Vec<_> =
        [[0.3, -0.4, 0.5, 100.0], [-0.6, 0.7, -0.2, 300.0], [1.0, 0.1, 0.8, 30.0]].map(|q| (9, position(&q), q)).into();
    let checks = table(&checks, true);
    let (_, checks) = checks.split_once('\n').unwrap();
    let (code, _, err) = run(&(without + checks), &["--prismatic", "q4"]);
    assert!(code == Some(2) && err.contains("error[sweep-reversed]"), "{err}");
}

/// Exit code and messages with these rows changed.
fn with(change: impl Fn(usize, &mut (usize, Vector, [f64; 4])), values: bool, arguments: &[&str]) -> (i32, String) {
    let mut rows = rows();
    rows.iter_mut().enumerate().for_each(|(i, row)| change(i, row));
    let (code, _, err) = run(&table(&rows, values), arguments);
    (code.unwrap(), err)
}

#[test]
fn sweeps_that_are_no_motion_of_one_joint_are_named() {
    let slides = ["--prismatic", "q4"];
    let refused = |(code, err): (i32, String), said: &str| assert!(code == 2 && err.says(said), "{said}: {err}");
    let two = |_: usize, row: &mut (usize, Vector, [f64; 4])| {
        row.2[1] = if row.0 == 0 { 0.1 * row.2[0] } else { row.2[1] };
        row.1 = position(&row.2);
    };
    refused(with(two, true, &[]), "error[sweep-two-joints] joint=q1 also=q2");
    // the only target slips once
    let slipped = |i: usize, row: &mut (usize, Vector, [f64; 4])| {
        if (10..24).contains(&i) {
            [0.3, 0.2, 0.4].iter().zip(&mut row.1).for_each(|(by, v)| *v += by);
        }
    };
    refused(with(slipped, true, &[]), "error[sweep-target-moved] joint=q1 row=12");
    let scattered = |i: usize, row: &mut (usize, Vector, [f64; 4])| {
        if i < 24 && i.is_multiple_of(5) {
            row.1[2] += if i.is_multiple_of(2) { 0.7 } else { -0.7 };
        }
    };
    refused(with(scattered, true, &[]), "error[sweep-many-outliers] joint=q1 aside=5 readings=24");
    let at_rest = |_: usize, row: &mut (usize, Vector, [f64; 4])| row.1 = if row.0 == 0 { TARGET } else { row.1 };
    refused(with(at_rest, false, &slides), "error[sweep-undetermined] joint=q1");
    let straight = table(&rows(), true).replace("q4_mm", "q4_deg");
    let (code, _, err) = run(&straight, &[]);
    refused((code.unwrap(), err), "error[sweep-undetermined] joint=q4");
}

/// Coordinates in metres under millimetres: exit code 1 and no robot, by force alone. The hint names the heading of the file, and
/// its conversion gives the robot.
fn unit_is_an_error(small: &str) {
    let own = small.replacen("x_mm,y_mm,z_mm", "X [mm],Y [mm],Z [mm]", 1);
    let slides = ["--prismatic", "q4", "--column", "y_mm=Y [mm]", "--column", "z_mm=Z [mm]", "--column"];
    let (code, out, err) = run(&own, &[&slides[..], &["x_mm=X [mm]", "--toml"]].concat());
    assert!(code == Some(1) && out.is_empty() && err.says("error[sweep-unit]"), "{err}");
    assert!(err.contains("--column 'x_mm=X [mm]*1000'"), "{err}");
    let (code, out, _) = run(&own, &[&slides[..], &["x_mm=X [mm]", "--json"]].concat());
    let found: AxesDocument = serde_json::from_slice(&out).unwrap();
    assert!(code == Some(1) && found.robot.is_none() && found.axes.len() == 4);
    let (code, out, _) = run(&own, &[&slides[..], &["x_mm=X [mm]", "--toml", "--force"]].concat());
    assert!(code == Some(1) && !out.is_empty());
    let converted = [
        "--prismatic",
        "q4",
        "--column",
        "x_mm=X [mm]*1000",
        "--column",
        "y_mm=Y [mm]*1000",
        "--column",
        "z_mm=Z [mm]*1000",
    ];
    let (code, out, err) = run(&own, &[&converted[..], &["--toml"]].concat());
    assert!(code == Some(0) && !out.is_empty(), "{err}");
    let (_, _, err) = run(small, &["--prismatic", "q4"]);
    assert!(err.contains("--column 'x_mm=x_mm*1000'"), "{err}");
}

#[test]
fn sweeps_that_say_little_are_named() {
    let has = |(code, err): (i32, String), said: &str| assert!(code == 0 && err.says(said), "{said}: {err}");
    let mut noise = Noise::new(11, 0);
    let short: Vec<_> = rows()
        .into_iter()
        .map(|(joint, _, q)| (joint, q.map(|v| v / if joint == 3 { 1.0 } else { 12.0 })))
        .map(|(joint, q)| (joint, position(&q).map(|v| v + noise.gaussian(0.01)), q))
        .collect();
    let (code, _, err) = run(&table(&short, true), &[]);
    assert!(code == Some(1) && err.says("warning[sweep-weak] joint=q1"), "{err}");
    assert!(err.says("error[uncertainty-beyond-bound] source=default unit=mm"), "{err}");
    let metres = |_: usize, row: &mut (usize, Vector, [f64; 4])| row.1 = row.1.map(|v| v / 1000.0);
    let mut small = rows();
    small.iter_mut().enumerate().for_each(|(i, row)| metres(i, row));
    unit_is_an_error(&table(&small, false));
    let three: Vec<_> = rows().into_iter().filter(|row| row.0 < 3).collect();
    let (code, _, err) = run(&table(&three, true), &[]);
    has((code.unwrap(), err), "warning[sweep-joint-missing] count=1");
    // joint 1 wobbles smoothly, as on a bearing with run-out
    let wobble = |_: usize, row: &mut (usize, Vector, [f64; 4])| {
        row.1[2] += if row.0 == 0 { 0.15 * (9.0 * row.2[0]).sin() } else { 0.0 };
    };
    has(with(wobble, true, &[]), "warning[sweep-smooth] joint=q1");
    let moved = |_: usize, row: &mut (usize, Vector, [f64; 4])| row.1[1] += if row.0 == 1 { 1.0 } else { 0.0 };
    has(with(moved, true, &[]), "warning[sweeps-disagree] what=sweeps");
    // a check pose with another target
    let q = [0.3, -0.4, 0.5, 100.0];
    let rows = [rows(), vec![(9, position(&q), q)]].concat();
    let named = table(&rows, true).lines().fold(String::new(), |mut out, line| {
        let target = if line.starts_with("joint") {
            "target"
        } else if line.starts_with(',') {
            "B"
        } else {
            "A"
        };
        let _ = writeln!(out, "{line},{target}");
        out
    });
    let (code, _, err) = run(&named, &[]);
    has((code.unwrap(), err), "warning[sweep-target-unswept]");
}
