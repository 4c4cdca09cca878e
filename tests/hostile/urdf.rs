//! URDF files that are wrong: each error names the file, the line and what to do.

use super::ends;
use crate::support::scratch::copy_sample;

#[test]
fn wrong_urdf_files_are_refused_by_name() {
    let upper = "<mimic joint=\"lift\" multiplier=\"0.5\" offset=\"0.01\"/>";
    for (from, to, parts) in [
        (
            "<link name=\"tool\">",
            "<link name=\"tools\">",
            vec![
                "error[urdf-joint-link-unknown]",
                "[urdf-joint-link-unknown]",
                "`tool`",
                "arm.urdf:113",
                "did you mean `tools`",
            ],
        ),
        ("<child link=\"tool\"/>", "", vec!["joint `flange_to_tool` has no <child", "arm.urdf:113"]),
        (
            "<parent link=\"base_link\"/>",
            "<parent link=\"tool\"/>",
            vec!["[urdf-loop]", "arm.urdf:", "a URDF is a tree"],
        ),
        ("<parent link=\"shoulder_link\"/>", "<parent link=\"flange\"/>", vec!["[urdf-loop]"]),
        (
            "<child link=\"wrist_1_link\"/>",
            "<child link=\"flange\"/>",
            vec!["[urdf-two-parents]", "`flange`", "`wrist_2_link`"],
        ),
        (upper, "<mimic joint=\"lifts\"/>", vec!["mimics `lifts`", "did you mean `lift`"]),
        (upper, "<mimic joint=\"column_upper_joint\"/>", vec!["[urdf-mimics-itself]", "`column_upper_joint`"]),
        (
            "<axis xyz=\"0 1 1\"/>",
            "<axis xyz=\"0 0 0\"/>",
            vec!["[urdf-axis-without-direction]", "`wrist_2`", "arm.urdf:"],
        ),
        (
            "<axis xyz=\"0 1 1\"/>",
            "<axis xyz=\"0 1\"/>",
            vec!["error[urdf-number-count]: `xyz` has 2 numbers", "expected: 3 numbers"],
        ),
        (
            "xyz=\"0 -0.1 0.4\"",
            "xyz=\"0 -100 400\"",
            vec!["[urdf-origin-far]", "412", "divide those of this file by 1000"],
        ),
        ("rpy=\"0.1 0 0\"", "rpy=\"90 0 0\"", vec!["error[urdf-angles-beyond-turn]", "radians"]),
        ("xyz=\"0 0 0.36\"", "xyz=\"0 0 O.36\"", vec!["[urdf-not-number]", "`O.36`", "arm.urdf:"]),
        ("xyz=\"0 0 0.36\"", "xyz=\"0 0 ${length}\"", vec!["xacro arm.urdf.xacro > arm.urdf"]),
        (
            "<link name=\"wrist_2_link\">",
            "<xacro:arm/><link name=\"wrist_2_link\">",
            vec!["[urdf-xacro]", "xacro arm.urdf.xacro > arm.urdf"],
        ),
        ("name=\"wrist_1\" type=\"revolute\"", "name=\"wrist_1\" type=\"planar\"", vec!["joint `wrist_1` is planar"]),
        ("name=\"wrist_1\" type", "name=\"elbow\" type", vec!["[urdf-joint-twice]", "`elbow`"]),
        ("name=\"elbow\" type", "name=\"elbo\" type", vec!["no joint `elbow`"]),
        ("lower=\"-2.6\" upper=\"2.6\"", "lower=\"2.6\" upper=\"-2.6\"", vec!["[urdf-limits-exchanged]", "`elbow`"]),
        ("<robot name=\"column_arm\">", "<sdf>", vec!["arm.urdf"]),
    ] {
        let scratch = copy_sample("column-arm");
        scratch.replace("arm.urdf", from, to);
        ends(&scratch, "check", 2, &parts);
    }
}

#[test]
fn what_robot_toml_states_of_a_urdf_is_checked() {
    for (from, to, parts) in [
        ("file = \"arm.urdf\"", "file = \"arms.urdf\"", vec!["arms.urdf", "robot.toml:3"]),
        (
            "base_link = \"base_link\"",
            "base_link = \"base_lnk\"",
            vec!["[urdf-link-unknown]", "`base_lnk`", "`base_link`", "robot.toml:4"],
        ),
        (
            "base_link = \"base_link\"",
            "base_link = \"column_height\"",
            vec!["[bending-on-moving-base]", "`bending`", "`column_height`", "robot.toml:6"],
        ),
        ("\"elbow\"]", "\"elbo\"]", vec!["[joint-reference-wrong]", "`elbo`", "robot.toml:6"]),
        ("\"elbow\"]", "9]", vec!["[joint-reference-wrong]"]),
        ("model = \"urdf\"", "model = \"serial\"", vec!["[key-of-other-model]", "`file`"]),
    ] {
        let scratch = copy_sample("column-arm");
        scratch.replace("robot.toml", from, to);
        ends(&scratch, "check", 2, &parts);
    }
}

#[test]
fn a_log_without_a_joint_of_the_urdf_is_named() {
    let scratch = copy_sample("column-arm");
    scratch.replace("campaign.toml", "elbow_rad = \"elbow\"\n", "");
    ends(&scratch, "check", 2, &["elbow"]);
    let scratch = copy_sample("column-arm");
    scratch.replace("campaign.toml", "lift_m = ", "column_upper_joint_m = ");
    ends(&scratch, "check", 2, &["lift"]);
}

#[test]
fn a_comment_that_mentions_xacro_refuses_no_file() {
    let scratch = copy_sample("column-arm");
    let text = std::fs::read_to_string(scratch.path().join("arm.urdf")).unwrap();
    let at = text.find("<link").unwrap();
    let commented =
        format!("{}<!-- <xacro:include filename=\"arm.xacro\"/> made by xacro -->\n{}", &text[..at], &text[at..]);
    std::fs::write(scratch.path().join("arm.urdf"), &commented).unwrap();
    ends(&scratch, "check", 0, &[]);
    std::fs::write(scratch.path().join("arm.urdf"), commented.replace("made by xacro -->", "--><xacro:arm/>")).unwrap();
    ends(&scratch, "check", 2, &["[urdf-xacro]"]);
}
