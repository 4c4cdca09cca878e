//! `etalon kinematics`: joint values to poses and back, for every model.

use super::{etalon, text};
use crate::support::root;
use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use std::path::{Path, PathBuf};

/// The answer to a table, its exit code and what stderr says.
fn kinematics(direction: &str, robot: &Path, table: &str, more: &[&str]) -> (String, Option<i32>, String) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("table.csv"), table).unwrap();
    let robot = robot.display().to_string();
    let output = etalon(folder.path(), &[&["kinematics", direction, "table.csv", "--robot", &robot], more].concat());
    (text(&output.stdout), output.status.code(), text(&output.stderr))
}

/// Names and numbers of the rows of a table behind their first column.
fn rows(csv: &str) -> Vec<(String, Vec<f64>)> {
    let row = |line: &str| {
        let mut fields = line.split(',');
        (fields.next().unwrap().to_owned(), fields.map(|v| v.parse().unwrap()).collect())
    };
    csv.lines().skip(1).map(row).collect()
}

/// Columns of one table behind the columns of another, row by row.
fn beside(poses: &str, joints: &str) -> String {
    let line = |(pose, joints): (&str, &str)| format!("{pose},{}\n", joints.split_once(',').unwrap().1);
    poses.lines().zip(joints.lines()).map(line).collect()
}

/// Robots with joint values, and how many ways lead to the first pose where that is known.
fn cases() -> Vec<(PathBuf, &'static str, usize)> {
    vec![
        (
            root().join("samples/prexyt-cmm/robot.toml"),
            "pose,rho1_mm,rho2_mm,rho3_mm\nhome,85,150,170\n2,20,30,240.5\n",
            1,
        ),
        // four working modes, of which limits leave some
        (
            root().join("samples/dextar/robot.toml"),
            "pose,theta1_deg,theta2_deg,assembly\n1,54.36,153.77,-1\nP2,21.404438,27.373336,1\n",
            0,
        ),
        // a spherical wrist: eight ways (Pieper 1968)
        (
            root().join("samples/abb-irb120/robot.toml"),
            "pose,q1_deg,q2_rad,q3_deg,q4_deg,q5_deg,q6_deg\n1,20,0.3,-15,40,35,-70\n2,-40,-0.2,20,-60,50,10\n",
            8,
        ),
        (
            root().join("docs/keys/robot-serial-dh.toml"),
            "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,20,-70,60,-50,40,30\n",
            8,
        ),
        (
            root().join("samples/hexapod/robot.toml"),
            "pose,leg1_mm,leg2_mm,leg3_mm,leg4_mm,leg5_mm,leg6_mm\n1,75,75,75,75,75,75\n2,60.5,71.2,90.3,100.1,80,66\n",
            1,
        ),
        // elbows inwards are beyond the limits of the arms
        (root().join("samples/delta/robot.toml"), "pose,theta1_deg,theta2_deg,theta3_deg\n1,20,30.5,-10\n2,0,0,0\n", 1),
        (root().join("docs/keys/robot-delta_linear.toml"), "pose,rho1_mm,rho2_mm,rho3_mm\n1,400,410,395.5\n", 1),
    ]
}

#[test]
fn joints_to_poses_and_back() {
    for (robot, table, ways) in cases() {
        let (poses, code, said) = kinematics("direct", &robot, table, &[]);
        assert_eq!(code, Some(0), "{said}");
        assert!(poses.starts_with("pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\n"), "{poses}");
        let (back, code, said) = kinematics("inverse", &robot, &poses, &[]);
        assert_eq!(code, Some(0), "{said}");
        let first = rows(&poses)[0].0.clone();
        let found = rows(&back).into_iter().filter(|(pose, _)| *pose == first).count();
        assert!(ways == 0 || found == ways, "{}: {found} ways\n{back}", robot.display());
        // each of them leads to the pose again
        let (again, code, said) = kinematics("direct", &robot, &back, &[]);
        assert_eq!(code, Some(0), "{said}");
        let (poses_of, all) = (rows(&poses), rows(&again));
        for (name, at) in &all {
            let (_, wanted) = poses_of.iter().find(|(pose, _)| pose == name).unwrap();
            let off = at.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-9, "{}: pose {name} is off by {off}", robot.display());
        }
        // and the nearest to the joints that it came from are these
        let radians = table.contains("q2_rad");
        let (nearest, code, said) = kinematics("inverse", &robot, &beside(&poses, table), &["--nearest"]);
        assert_eq!(code, Some(0), "{said}");
        for ((_, found), (_, stated)) in rows(&nearest).iter().zip(rows(table)) {
            for (i, (a, b)) in found.iter().zip(stated).enumerate() {
                let b = if radians && i == 1 { b.to_degrees() } else { b };
                assert!((a - b).abs() < 1e-9, "{}: {nearest}", robot.display());
            }
        }
    }
}

/// Links bend by torques of the nominal geometry, as in the identification, in both directions.
#[test]
fn an_elastic_arm_comes_back_with_its_identified_parameters() {
    let scratch = copy_sample("elastic-arm");
    assert!(etalon(scratch.root(), &["run", "campaign"]).status.code() < Some(2));
    let parameters = scratch.path().join("out/parameters.json");
    let more = ["--parameters", parameters.to_str().unwrap()];
    let robot = scratch.path().join("robot.toml");
    let joints = "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,10,-40,70,20,30,40\n2,-50,-70,90,-20,60,10\n";
    let (poses, ..) = kinematics("direct", &robot, joints, &more);
    let (found, code, said) = kinematics("inverse", &robot, &poses, &more);
    assert_eq!(code, Some(0), "{said}");
    let found = rows(&found);
    for (pose, expected) in rows(joints) {
        let solutions = found.iter().filter(|(other, _)| *other == pose);
        let off = |q: &[f64]| q.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let nearest = solutions.map(|(_, q)| off(q)).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-9, "{pose}: {nearest} deg");
    }
}

#[test]
fn an_arm_of_seven_joints_needs_a_start() {
    let robot = root().join("samples/column-arm/robot.toml");
    let table = "pose,lift_m,shoulder_pan_rad,shoulder_lift_rad,elbow_rad,wrist_1_rad,wrist_2_rad,wrist_3_rad\n\
                 a,0.3,0.5,-0.7,-1.6,-0.1,2.5,-2.1\nb,0.31,0.52,-0.7,-1.61,-0.1,2.5,-2.1\n";
    let (poses, code, said) = kinematics("direct", &robot, table, &[]);
    assert_eq!(code, Some(0), "{said}");
    let (_, code, said) = kinematics("inverse", &robot, &poses, &[]);
    assert!(code == Some(2) && said.contains("error[infinite-solutions]") && said.contains("--nearest"), "{said}");
    let (nearest, code, said) = kinematics("inverse", &robot, &beside(&poses, table), &["--nearest", "--json"]);
    assert_eq!(code, Some(0), "{said}");
    let document: etalon::documents::KinematicsDocument = serde_json::from_str(&nearest).unwrap();
    assert_eq!(document.joints[..2], ["lift_mm", "shoulder_pan_deg"]);
    assert!((document.poses[0].joints[0] - 300.0).abs() < 1e-9, "{nearest}");
    // beyond a limit of the URDF
    let high = table.replace("a,0.3,", "a,0.9,");
    let (_, code, said) = kinematics("direct", &robot, &high, &[]);
    assert!(
        code == Some(1) && said.has_phrase("joint-beyond-limits joint=lift q=900 unit=mm lower=0 upper=800"),
        "{said}"
    );
}

#[test]
fn identified_parameters_are_used_and_those_of_another_robot_refused() {
    let robot = root().join("samples/prexyt-cmm/robot.toml");
    // a run of the sample
    let scratch = crate::support::scratch::copy_sample("prexyt-cmm");
    assert!(etalon(&scratch.path(), &["run", ".", "--json"]).status.code() != Some(2));
    let parameters = scratch.path().join("out/parameters.json").display().to_string();
    let joints = "pose,rho1_mm,rho2_mm,rho3_mm\n1,85,150,170\n";
    let (nominal, ..) = kinematics("direct", &robot, joints, &[]);
    let (found, code, said) = kinematics("direct", &robot, joints, &["--parameters", &parameters]);
    assert_eq!(code, Some(0), "{said}");
    let off = (rows(&nominal)[0].1[0] - rows(&found)[0].1[0]).abs();
    assert!(off > 1e-3 && off < 10.0, "{off}");
    let arm = root().join("samples/abb-irb120/robot.toml");
    let joints = "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,1,2,3,4,5,6\n";
    let (_, code, said) = kinematics("direct", &arm, joints, &["--parameters", &parameters]);
    assert!(code == Some(2) && said.contains("error[parameters-of-other-robot]"), "{said}");
}

#[test]
fn tables_that_do_not_fit_are_refused_by_name() {
    let arm = root().join("samples/abb-irb120/robot.toml");
    let xyt = root().join("samples/prexyt-cmm/robot.toml");
    let bars = root().join("samples/dextar/robot.toml");
    let pose = "pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
    let all = [
        ("direct", &arm, "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg\n1,1,2,3,4,5\n".to_owned(), 2, "[column-unknown]"),
        (
            "direct",
            &arm,
            "pose,q1_deg,q2_mm,q3_deg,q4_deg,q5_deg,q6_deg\n1,1,2,3,4,5,6\n".to_owned(),
            2,
            "[column-unknown]",
        ),
        ("direct", &xyt, "pose,rho1_mm,rho2_mm,rho3_mm\n1,1,2,\n".to_owned(), 2, "[table-value-missing]"),
        ("direct", &bars, "pose,theta1_deg,theta2_deg\n1,54.36,153.77\n".to_owned(), 2, "[column-unknown]"),
        ("inverse", &arm, format!("{pose}1,300,0,500,1,1,0,0\n"), 2, "error[table-quaternion-length] length=1.4142"),
        ("inverse", &arm, "pose,x_mm,y_mm,z_mm\n1,300,0,500\n".to_owned(), 2, "[column-unknown]"),
        ("inverse", &arm, format!("{pose}far,3000,0,500,1,0,0,0\n"), 1, "pose far: out of reach"),
        ("inverse", &xyt, format!("{pose}up,200,150,10,1,0,0,0\n"), 1, "pose up: out of reach"),
        ("inverse", &xyt, format!("{pose}1,900,150,0,1,0,0,0\n"), 1, "outside its travel"),
        ("inverse", &bars, format!("{pose}1,900,150,0,1,0,0,0\n"), 1, "pose 1: out of reach"),
    ];
    // metres are metres
    let (in_metres, code, said) =
        kinematics("inverse", &arm, "pose,x_m,y_m,z_m,qw,qx,qy,qz\n1,0.3,0,0.5,1,0,0,0\n", &[]);
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(in_metres, kinematics("inverse", &arm, &format!("{pose}1,300,0,500,1,0,0,0\n"), &[]).0);
    for (direction, robot, table, expected, part) in all {
        let (_, code, said) = kinematics(direction, robot, &table, &[]);
        assert!(code == Some(expected) && said.says(part), "{table}: {code:?} {said}");
    }
}

/// The origins of the URDF added up by hand: mimic joints with multiplier and offset, fixed joints, the tool behind the last one.
#[test]
fn a_urdf_at_zero_joints_is_where_its_origins_put_it() {
    let robot = root().join("samples/column-arm/robot.toml");
    let table = "pose,lift_m,shoulder_pan_rad,shoulder_lift_rad,elbow_rad,wrist_1_rad,wrist_2_rad,wrist_3_rad\n1,0.3,0,0,0,0,0,0\n";
    let (poses, code, said) = kinematics("direct", &robot, table, &[]);
    assert_eq!(code, Some(0), "{said}");
    // column: 0.2 + 0.5 · 0.3 + 0.1 + 0.5 · 0.3 + 0.01 + 0.6 m; the arm leans forward by 45 degrees, its flange is tilted by 0.1 rad
    let (along, aside) = (1040.0 + 30.0 * 0.1f64.cos(), 150.0 - 30.0 * 0.1f64.sin());
    let leant = along / 2f64.sqrt();
    for (found, expected) in rows(&poses)[0].1.iter().zip([180.0 + leant, aside, 1210.0 + leant]) {
        assert!((found - expected).abs() < 1e-9, "{poses}: {expected}");
    }
}

/// Arm like a UR5e, at a pose whose row states the joints that reach it; joint 5 is zero, so that joints 2, 3, 4 and 6 turn about
/// parallel axes.
const PARALLEL_WRIST: &str = "name = \"R\"\nmodel = \"serial\"\nconvention = \"dh\"\njoint = [
    { alpha_deg = 90.0, a_mm = 0.0, theta_deg = 0.0, d_mm = 162.5 },
    { alpha_deg = 0.0, a_mm = -425.0, theta_deg = 0.0, d_mm = 0.0 },
    { alpha_deg = 0.0, a_mm = -392.2, theta_deg = 0.0, d_mm = 0.0 },
    { alpha_deg = 90.0, a_mm = 0.0, theta_deg = 0.0, d_mm = 133.3 },
    { alpha_deg = -90.0, a_mm = 0.0, theta_deg = 0.0, d_mm = 99.7 },
    { alpha_deg = 0.0, a_mm = 0.0, theta_deg = 0.0, d_mm = 99.6 },
]\n";

#[test]
fn joints_that_reach_a_singular_pose_are_the_nearest() {
    let folder = tempfile::tempdir().unwrap();
    let robot = folder.path().join("robot.toml");
    std::fs::write(&robot, PARALLEL_WRIST).unwrap();
    let table = "pose,x_mm,y_mm,z_mm,qw,qx,qy,qz,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n\
        1,-435.3001533163469,-406.2833019883045,334.0417093293287,0.6830127018922196,0.7044160264027587,\
        0.061628416716219436,0.18301270189221938,20,-70,90,-40,0,30\n";
    let stated = [20.0, -70.0, 90.0, -40.0, 0.0, 30.0];
    let is_stated = |q: &[f64]| q.iter().zip(stated).all(|(a, b)| (a - b).abs() < 1e-6);
    let (nearest, code, said) = kinematics("inverse", &robot, table, &["--nearest"]);
    assert!(code == Some(0) && rows(&nearest).len() == 1 && is_stated(&rows(&nearest)[0].1), "{nearest} {said}");
    assert!(said.says("warning[pose-singular] pose=1"), "{said}");
    // all solutions: few, among them the family of the row by its member nearest to the row
    let (all, code, said) = kinematics("inverse", &robot, table, &["--json"]);
    let document: etalon::documents::KinematicsDocument = serde_json::from_str(&all).unwrap();
    assert!(code == Some(0) && document.poses.len() <= 8, "{all} {said}");
    let own = document.poses.iter().find(|entry| is_stated(&entry.joints)).unwrap();
    assert_eq!(own.free_joints, ["q2", "q3", "q4", "q6"]);
    // each solution leads to the pose
    let (csv, ..) = kinematics("inverse", &robot, table, &[]);
    let (back, code, _) = kinematics("direct", &robot, &csv, &[]);
    assert_eq!(code, Some(0));
    for (_, at) in rows(&back) {
        assert!((at[0] + 435.3001533163469).abs() < 1e-5 && (at[2] - 334.0417093293287).abs() < 1e-5, "{back}");
    }
}

/// A search that finds no solution says how many starts it had; a distance beyond the arm is out of reach.
#[test]
fn out_of_reach_is_said_where_it_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    let robot = folder.path().join("robot.toml");
    std::fs::write(&robot, PARALLEL_WRIST).unwrap();
    let head = "pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
    let (_, code, said) = kinematics("inverse", &robot, &format!("{head}far,2000,0,162.5,1,0,0,0\n"), &["--nearest"]);
    assert!(
        code == Some(1) && said.contains("pose far: ") && said.has_phrase("out-of-reach-by away_mm=2006.6"),
        "{said}"
    );
    // on the axis of joint 1, nearer than the offset of the arm lets it come
    let (_, code, said) = kinematics("inverse", &robot, &format!("{head}in,0,0,700,1,0,0,0\n"), &["--nearest"]);
    assert!(code == Some(1) && said.contains("pose in: ") && said.has_phrase("no-solution-found"), "{said}");
}
