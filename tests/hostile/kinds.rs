//! Tables of several kinds of observations: every slip is refused by name, with its line.

use crate::support::said::{Says, has};
use crate::support::scratch::{copy_sample, ends};
use etalon::base::phrase;
use std::process::Command;

const ROBOT: &str = r#"model = "serial"
joint = [
    { alpha_deg = 0, a_mm = 0, theta_deg = 0, d_mm = 290 },
    { alpha_deg = -90, a_mm = 0, theta_deg = -90, d_mm = 0 },
    { alpha_deg = 0, a_mm = 270, theta_deg = 0, d_mm = 0 },
]
"#;
const HEADER: &str = "kind,pose,cycle,target,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,qw,qx,qy,qz,distance_mm,other,socket,plane,axis,offset_mm,u_mm,urot_deg";

/// The error of a table that holds `rows`.
fn error(header: &str, rows: &str, more: &[&str]) -> String {
    error_of(ROBOT, header, rows, more)
}

fn error_of(robot: &str, header: &str, rows: &str, more: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), robot).unwrap();
    std::fs::write(folder.path().join("o.csv"), format!("{header}\n{rows}\n")).unwrap();
    let output = Command::new(crate::support::program())
        .current_dir(folder.path())
        .args(["identify", "--robot", "robot.toml", "--observations", "o.csv"])
        .args(more)
        .output()
        .unwrap();
    let error = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{rows}: {error}");
    error
}

#[test]
fn slips_are_refused_with_their_line() {
    // of several rows this one would be left out
    let alone = error(HEADER, "contact,1,1,ball,1,,3,,,,,,,,,,A,,,,0.02,", &[]);
    assert!(alone.contains("error[joint-value-missing]"), "{alone}");
    let good = "contact,1,1,ball,1,2,3,,,,,,,,,,A,,,,0.02,";
    for (row, parts) in [
        ("contcat,1,1,ball,1,2,3,,,,,,,,,,A,,,,0.02,", &["[kind-unknown]", "`contcat`", "did you mean `contact`"][..]),
        ("contact,1,1,ball,1,2,3,,,,,,,,,,,,,,0.02,", &["error[column-empty]", "`socket`"]),
        ("contact,1,1,ball,1,2,3,,,,,,,,,,ball,,,,0.02,", &["error[fixed-point-on-robot]: `ball`"]),
        ("contact,1,1,ball,1,2,3,,,,,,,,,,A,,,,-0.02,", &["error[uncertainty-not-positive]: `u_mm` = -0.02"]),
        ("contact,1,1,ball,1,2,3,,,,,,,,,,A,,,,,", &["error[uncertainty-missing]", "--standard-uncertainty-um"]),
        ("distance,1,1,ball,1,2,3,,,,,,,,-300,E,,,,,0.02,", &["error[distance-not-positive]"]),
        ("distance,1,1,ball,1,2,3,,,,,,,,300,,,,,,0.02,", &["error[column-empty]", "`other`"]),
        (
            "pose,1,1,ball,1,2,3,1,2,3,0.9,0,0,0.9,,,,,,,0.02,0.01",
            &["error[table-quaternion-length]", "1.27", "qw is the scalar part"],
        ),
        ("pose,1,1,ball,1,2,3,1,2,3,1,0,,0,,,,,,,0.02,0.01", &["error[orientation-missing]"]),
        (
            "pose,1,1,ball,1,2,3,1,2,3,1,0,0,0,,,,,,,0.02,",
            &["error[uncertainty-missing]", "--rotation-uncertainty-deg"],
        ),
        ("plane,1,1,ball,1,2,3,,,,,,,,,,,table,,12.7,0.02,", &["error[surface-axis-missing]", "`table`"]),
        ("plane,1,1,ball,1,2,3,,,,,,,,,,,table,z,,0.02,", &["error[number-missing]: `offset_mm`"]),
        ("contact,,,A,,,,,,,,,,,,,B,,,,0.02,", &["error[row-without-pose] kind=contact"]),
        ("distance,,,A,,,,,,,,,,,300,A,,,,,0.02,", &["error[distance-to-itself] name=A"]),
        ("point,,,A,,,,1,2,,,,,,,,,,,,0.02,", &["error[place-missing] point=A"]),
    ] {
        let error = error(HEADER, &format!("{good}\n{row}"), &[]);
        for part in parts.iter().chain(&["o.csv:3"]) {
            assert!(error.says(part), "{row}\nlacks {part:?}:\n{error}");
        }
    }
}

#[test]
fn what_a_further_station_cannot_state_is_refused_with_its_line() {
    let header = "kind,station,pose,cycle,target,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,qw,qx,qy,qz,u_mm,ux_mm,uy_mm,uz_mm,cxx_mm2,cxy_mm2,cxz_mm2,cyy_mm2,cyz_mm2,czz_mm2,urot_deg";
    for (row, what) in [
        (
            "pose,T2,2,1,ball,1,2,3,1,2,,1,0,0,0,0.02,,,,,,,,,,0.01",
            "error[station-row-unsupported] fault=coordinate station=T2",
        ),
        (
            "point,T2,2,1,ball,1,2,3,1,2,3,,,,,,,,,1e-4,0,0,1e-4,0,1e-4,",
            "error[station-row-unsupported] fault=covariance station=T2",
        ),
        (
            "point,T2,2,1,ball,1,2,3,1,2,3,,,,,,0.01,0.02,0.01,,,,,,,",
            "error[station-row-unsupported] fault=uncertainties station=T2",
        ),
        (
            "point,T2,2,1,ball,1,2,3,1,,3,,,,,0.02,,,,,,,,,,",
            "error[station-row-unsupported] fault=coordinate station=T2",
        ),
    ] {
        let good = "point,T1,1,1,ball,1,2,3,1,2,3,,,,,0.02,,,,,,,,,,";
        let error = error(header, &format!("{good}\n{row}"), &[]);
        assert!(error.says(what) && error.contains("o.csv:3"), "{row}: {error}");
    }
}

#[test]
fn keys_that_were_read_once_or_belong_elsewhere_are_refused_with_what_to_do() {
    let text = error_of(&format!("{ROBOT}base_turn_y_deg = 90.0\n"), "pose,cycle,target,x_mm", "1,1,a,2", &[]);
    assert!(text.contains("[unknown-key]") && text.contains("robot.toml:7"), "{text}");
    assert!(text.has_phrase("key-remedy key=base_turn_y_deg"), "{text}");
}

#[test]
fn backlash_without_a_direction_is_refused_by_name() {
    let robot = format!("{ROBOT}backlash = [2]\n");
    let header = "pose,cycle,target,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm";
    let row = "1,1,ball,1,2,3,1,2,3";
    let text = error_of(&robot, header, row, &[]);
    assert!(text.contains("error[joint-direction-missing]"), "{text}");
    assert!(text.contains("a column `q2_direction`"), "{text}");
    for (direction, what) in
        [("", "`q2_direction` is missing"), ("0", "`q2_direction` is 0"), ("0.4", "`q2_direction` is 0.4")]
    {
        let text = error_of(&robot, &format!("{header},q2_direction"), &format!("{row},1\n{row},{direction}"), &[]);
        assert!(text.says(what) && text.contains("o.csv:3"), "{direction}: {text}");
    }
    let text = error_of(&format!("{ROBOT}backlash = [4]\n"), header, row, &[]);
    assert!(
        text.says("[joint-reference-wrong] fault=unknown-number joint=4") && text.contains("robot.toml:"),
        "{text}"
    );
}

#[test]
fn slips_in_surfaces_and_joints_are_refused_with_their_line() {
    let header = "kind,pose,cycle,target,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,line_name,sphere,axis,joint,value_deg,distance_mm,offset_mm,u_mm,urot_deg";
    let good = "line,1,1,ball,1,2,3,,,,post,,z,,,,,0.02,";
    for (row, parts) in [
        ("line,1,1,ball,1,2,3,,,,,,z,,,,,0.02,", &["error[column-empty]", "`line_name`"][..]),
        ("line,1,1,ball,1,2,3,,,,post,,,,,,,0.02,", &["error[surface-axis-missing]", "`post`"]),
        ("line,1,1,ball,1,2,3,,,,post,,z,,,,2,0.02,", &["error[offset-of-line]"]),
        ("sphere,1,1,ball,1,2,3,,,,,,,,,,0,0.02,", &["error[column-empty]", "`sphere`"]),
        ("sphere,1,1,ball,1,2,3,,,,,ball,,,,,0,0.02,", &["[fixed-point-on-robot]", "`ball`"]),
        ("sphere,1,1,ball,1,2,3,,,,,dome,,,,,,0.02,", &["error[number-missing]: `offset_mm`"]),
        ("joints,1,1,,1,2,3,,,,,,,q4,1.0,,,,0.01", &["error[not-of-this-robot]: `q4`"]),
        ("joints,1,1,,1,2,3,,,,,,,q2,,,,,0.01", &["`value_deg` is missing"]),
        ("joints,1,1,,1,2,3,,,,,,,q2,1.0,,,,", &["error[uncertainty-missing]", "--rotation-uncertainty-deg"]),
        ("line,,,a,,,,1,2,,post,,z,,,,,0.02,", &["error[place-missing] point=a"]),
        ("sphere,,,dome,,,,,,,,dome,,,,-5,,0.02,", &["error[distance-not-positive]"]),
    ] {
        let error = error(header, &format!("{good}\n{row}"), &[]);
        for part in parts.iter().chain(&["o.csv:3"]) {
            assert!(error.says(part), "{row}\nlacks {part:?}:\n{error}");
        }
    }
}

#[test]
fn an_orientation_lacks_no_component() {
    let error =
        error("pose,cycle,target,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,qx,qy,qz", "1,1,ball,1,2,3,1,2,3,0,0,0", &[]);
    assert!(error.says("error[orientation-columns-missing] missing=qw"), "{error}");
}

#[test]
fn planar_robots_have_positions_only() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("robot.toml"),
        "model = \"five_bar\"\n[nominal]\nl11 = 230\nl12 = 230\nl21 = 230\nl22 = 230\nd = 275\nl23 = 230\n",
    )
    .unwrap();
    let table = "kind,pose,cycle,target,theta1_deg,theta2_deg,x_mm,y_mm,socket,u_mm\ncontact,1,1,tool,10,20,,,A,0.02\n";
    std::fs::write(folder.path().join("o.csv"), table).unwrap();
    let args = ["identify", "--robot", "robot.toml", "--observations", "o.csv", "--standard-uncertainty-um", "20"];
    let output = Command::new(crate::support::program()).current_dir(folder.path()).args(args).output().unwrap();
    let error = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert!(error.contains("error[observations-need-arm]") && error.contains("`five_bar`"), "{error}");
}

#[test]
fn names_of_targets_points_and_planes_do_not_meet_in_a_parameter() {
    let contact = "contact,1,1,ball,1,2,3,,,,,,,,,,A,,,,0.02,";
    for name in ["A", "ball"] {
        let error = error(HEADER, &format!("{contact}\nplane,2,1,ball,1,2,3,,,,,,,,,,,{name},z,0,0.02,"), &[]);
        assert!(error.says(&format!("error[parameter-name-doubled] name={name}_z")), "{error}");
    }
}

/// robot.toml of an arm by its table.
fn robot_toml(rows: &[[f64; 4]]) -> String {
    let joint = |[alpha, a, theta, d]: &[f64; 4]| {
        format!("[[joint]]\nalpha_deg = {alpha}\na_mm = {a}\ntheta_deg = {theta}\nd_mm = {d}\n")
    };
    format!("model = \"serial\"\n{}", rows.iter().map(joint).collect::<String>())
}

/// Angles about z, y and z, each about the turned axis.
fn zyz_rad(body: &etalon::base::pose::Pose) -> Vec<f64> {
    let r = body.rotation;
    vec![r[1][2].atan2(r[0][2]), r[2][2].acos(), r[2][1].atan2(-r[2][0])]
}

/// Orientations of a probe in one form or another: the same robot, and where the order of angles is not stated, the one that fits is named.
#[test]
fn orientations_in_any_form_are_the_same() {
    use crate::support::arms::{SIX_AXES, serial};
    use etalon::base::noise::Noise;
    use etalon::base::pose::Pose;
    use etalon::robots::{FreeBase, Robot};
    let robot = serial(&SIX_AXES, &["probe"], &[]);
    let mut truth = robot.nominal();
    truth[..9].copy_from_slice(&[900.0, -300.0, 150.0, 0.3, -0.2, 1.1, 40.0, -20.0, 65.0]);
    let mut noise = Noise::new(18, 9);
    let mounting = Pose::from_rotation_vector([0.4, -1.1, 0.7]);
    let poses: Vec<(Vec<f64>, Pose, [f64; 3])> = (0..24)
        .map(|_| {
            let joints = [2.8, 1.0, 1.0, 2.6, 1.9, 3.0].map(|range| noise.uniform(range)).to_vec();
            let body = robot
                .flange(&truth, &joints, 0)
                .then(&mounting)
                .then(&Pose::from_rotation_vector([0; 3].map(|_| noise.gaussian(1e-4))));
            let at = robot.position(&truth, &joints, 0).map(|v| v + noise.gaussian(0.02));
            (joints, body, at)
        })
        .collect();
    let robot_toml = robot_toml(&SIX_AXES);
    let run = |columns: &str, numbers: &dyn Fn(&Pose) -> Vec<f64>, more: &[&str]| {
        let mut table =
            format!("pose,cycle,target,q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad,x_mm,y_mm,z_mm,{columns}\n");
        for (i, (joints, body, at)) in poses.iter().enumerate() {
            let cells = joints.iter().copied().chain(*at).chain(numbers(body)).map(|v| v.to_string());
            table += &format!("{},1,probe,{}\n", i + 1, cells.collect::<Vec<_>>().join(","));
        }
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("robot.toml"), &robot_toml).unwrap();
        std::fs::write(folder.path().join("o.csv"), table).unwrap();
        let output = Command::new(crate::support::program())
            .current_dir(folder.path())
            .args(["identify", "--robot", "robot.toml", "--observations", "o.csv", "--standard-uncertainty-um", "20"])
            .args(["--rotation-uncertainty-deg", "0.0057", "--hold", "gain_*", "--hold", "a_*", "--json"])
            .args(more)
            .output()
            .unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let values = |(code, answer, error): (Option<i32>, String, String)| -> Vec<f64> {
        assert_eq!(code, Some(0), "{error}");
        let document: serde_json::Value = serde_json::from_str(&answer).unwrap();
        document["parameters"].as_array().unwrap().iter().map(|p| p["value"].as_f64().unwrap()).collect()
    };
    // roll, pitch, yaw: about x, y, z of the world in this order
    let rpy = |body: &Pose| body.rpy_rad().map(f64::to_degrees).to_vec();
    let expected = values(run("qw,qx,qy,qz", &|body| body.quaternion().to_vec(), &[]));
    for (columns, numbers, order) in [
        (
            "rx_rad,ry_rad,rz_rad",
            &(|body: &Pose| body.rotation_vector_rad().to_vec()) as &dyn Fn(&Pose) -> Vec<f64>,
            None,
        ),
        ("a_deg,b_deg,c_deg", &rpy, Some("fixed xyz")),
        ("c_deg,b_deg,a_deg", &rpy, Some("zyx")),
        ("a_rad,b_rad,c_rad", &zyz_rad, Some("zyz")),
    ] {
        let stated: Vec<&str> = order.into_iter().flat_map(|order| ["--orientation", order]).collect();
        let found = values(run(columns, numbers, &stated));
        for (a, b) in found.iter().zip(&expected) {
            assert!((a - b).abs() < 1e-6, "{columns} {order:?}: {a} {b}");
        }
        let Some(order) = order else { continue };
        let (code, _, error) = run(columns, numbers, &[]);
        assert_eq!(code, Some(2), "{error}");
        let named = ["error[angle-order-missing]", "o.csv:1", &format!("`{order}`: residual 0.0")];
        named.iter().for_each(|part| assert!(error.says(part), "{order} lacks {part:?}: {error}"));
        assert!(!error.contains("`yzx`") && !error.contains("`xyx`"), "{error}");
    }
    let (code, _, error) = run("a_deg,b_deg,c_deg", &rpy, &["--orientation", "xyz"]);
    assert!(
        code == Some(2) && has(&error, &phrase!("orientation-slip", slip = "order", name = "fixed xyz")),
        "{code:?} {error}"
    );
    let (code, _, error) = run("a_deg,b_deg,c_deg", &rpy, &["--orientation", "rpy"]);
    assert!(code == Some(2) && error.contains("[angle-order-unknown]"), "{error}");
    let (code, _, error) = run("a_deg,b_deg,c_deg,qw", &|body| [rpy(body), vec![1.0]].concat(), &[]);
    assert!(code == Some(2) && error.contains("[orientations-twice]"), "{error}");
}

/// A row that lost the name of its station would be the world by itself.
#[test]
fn a_row_without_its_station_is_named() {
    let scratch = copy_sample("turntable");
    let file = scratch.path().join("observations.csv");
    let text = std::fs::read_to_string(&file).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    assert!(lines[200].contains(",north,"), "{}", lines[200]);
    lines[200] = lines[200].replace(",north,", ",,");
    std::fs::write(&file, lines.join("\n") + "\n").unwrap();
    ends(&scratch, "check", 2, &["error[station-missing]", "observations.csv:201"]);
}
