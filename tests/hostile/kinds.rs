//! Tables of several kinds of observations: every slip is refused by name, with its line.

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
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), ROBOT).unwrap();
    std::fs::write(folder.path().join("o.csv"), format!("{header}\n{rows}\n")).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_etalon"))
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
    let good = "contact,1,1,ball,1,2,3,,,,,,,,,,A,,,,0.02,";
    for (row, parts) in [
        ("contcat,1,1,ball,1,2,3,,,,,,,,,,A,,,,0.02,", &["`contcat` is not a kind", "did you mean `contact`"][..]),
        ("contact,1,1,ball,1,2,3,,,,,,,,,,,,,,0.02,", &["column `socket` is empty"]),
        ("contact,1,1,ball,1,2,3,,,,,,,,,,ball,,,,0.02,", &["`ball` is a target on the robot, not a fixed point"]),
        ("contact,1,1,ball,1,,3,,,,,,,,,,A,,,,0.02,", &["a joint value is missing"]),
        ("contact,1,1,ball,1,2,3,,,,,,,,,,A,,,,-0.02,", &["`u_mm` = -0.02 is not a standard uncertainty"]),
        ("contact,1,1,ball,1,2,3,,,,,,,,,,A,,,,,", &["no standard uncertainty", "--standard-uncertainty-um"]),
        ("distance,1,1,ball,1,2,3,,,,,,,,-300,E,,,,,0.02,", &["`distance_mm` is missing or not a length"]),
        ("distance,1,1,ball,1,2,3,,,,,,,,300,,,,,,0.02,", &["column `other` is empty"]),
        (
            "pose,1,1,ball,1,2,3,1,2,3,0.9,0,0,0.9,,,,,,,0.02,0.01",
            &["the quaternion has the length 1.27", "scalar first"],
        ),
        ("pose,1,1,ball,1,2,3,1,2,3,1,0,,0,,,,,,,0.02,0.01", &["the orientation is missing"]),
        ("pose,1,1,ball,1,2,3,1,2,3,1,0,0,0,,,,,,,0.02,", &["no standard uncertainty", "--rotation-uncertainty-deg"]),
        ("plane,1,1,ball,1,2,3,,,,,,,,,,,table,,12.7,0.02,", &["the plane `table` needs the axis"]),
        ("plane,1,1,ball,1,2,3,,,,,,,,,,,table,z,,0.02,", &["`offset_mm` is missing"]),
        ("contact,,,A,,,,,,,,,,,,,B,,,,0.02,", &["a row of kind `contact` has no pose"]),
        ("distance,,,A,,,,,,,,,,,300,A,,,,,0.02,", &["a distance from `A` to itself"]),
        ("point,,,A,,,,1,2,,,,,,,,,,,,0.02,", &["the place of `A` is missing"]),
    ] {
        let error = error(HEADER, &format!("{good}\n{row}"), &[]);
        for part in parts.iter().chain(&["o.csv:3"]) {
            assert!(error.contains(part), "{row}\nlacks {part:?}:\n{error}");
        }
    }
}

#[test]
fn slips_in_surfaces_and_joints_are_refused_with_their_line() {
    let header = "kind,pose,cycle,target,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,line,sphere,axis,joint,value_deg,distance_mm,offset_mm,u_mm,urot_deg";
    let good = "line,1,1,ball,1,2,3,,,,post,,z,,,,,0.02,";
    for (row, parts) in [
        ("line,1,1,ball,1,2,3,,,,,,z,,,,,0.02,", &["column `line` is empty"][..]),
        ("line,1,1,ball,1,2,3,,,,post,,,,,,,0.02,", &["the line `post` needs the axis"]),
        ("line,1,1,ball,1,2,3,,,,post,,z,,,,2,0.02,", &["`offset_mm` is of planes and spheres"]),
        ("sphere,1,1,ball,1,2,3,,,,,,,,,,0,0.02,", &["column `sphere` is empty"]),
        ("sphere,1,1,ball,1,2,3,,,,,ball,,,,,0,0.02,", &["`ball` is a target on the robot"]),
        ("sphere,1,1,ball,1,2,3,,,,,dome,,,,,,0.02,", &["`offset_mm` is missing"]),
        ("joints,1,1,,1,2,3,,,,,,,q4,1.0,,,,0.01", &["`q4` is not a joint of this robot"]),
        ("joints,1,1,,1,2,3,,,,,,,q2,,,,,0.01", &["`value_deg` is missing"]),
        ("joints,1,1,,1,2,3,,,,,,,q2,1.0,,,,", &["no standard uncertainty", "--rotation-uncertainty-deg"]),
        ("line,,,a,,,,1,2,,post,,z,,,,,0.02,", &["the place of `a` is missing"]),
        ("sphere,,,dome,,,,,,,,dome,,,,-5,,0.02,", &["`distance_mm` is missing or not a length"]),
    ] {
        let error = error(header, &format!("{good}\n{row}"), &[]);
        for part in parts.iter().chain(&["o.csv:3"]) {
            assert!(error.contains(part), "{row}\nlacks {part:?}:\n{error}");
        }
    }
}

#[test]
fn an_orientation_lacks_no_component() {
    let error =
        error("pose,cycle,target,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm,qx,qy,qz", "1,1,ball,1,2,3,1,2,3,0,0,0", &[]);
    assert!(error.contains("an orientation lacks qw"), "{error}");
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
    let output = Command::new(env!("CARGO_BIN_EXE_etalon")).current_dir(folder.path()).args(args).output().unwrap();
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(error.contains("are for arms in space, not for `five_bar`"), "{error}");
}

#[test]
fn names_of_targets_points_and_planes_do_not_meet_in_a_parameter() {
    let contact = "contact,1,1,ball,1,2,3,,,,,,,,,,A,,,,0.02,";
    for name in ["A", "ball"] {
        let error = error(HEADER, &format!("{contact}\nplane,2,1,ball,1,2,3,,,,,,,,,,,{name},z,0,0.02,"), &[]);
        assert!(error.contains(&format!("`{name}_z` would be the name of two parameters")), "{error}");
    }
}
