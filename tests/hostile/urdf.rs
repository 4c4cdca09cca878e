//! URDF files that are wrong: each error names the file, the line and what to do.

use super::ends;
use crate::support::scratch::copy_sample;
use etalon::base::catalogue::Argument;
use etalon::base::message::Message;

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
            vec!["error[urdf-number-count] attribute=xyz count=2", "expected: 3 numbers"],
        ),
        ("xyz=\"0 -0.1 0.4\"", "xyz=\"0 -100 400\"", vec!["[urdf-origin-far] away_m=412"]),
        ("rpy=\"0.1 0 0\"", "rpy=\"90 0 0\"", vec!["error[urdf-angles-beyond-turn]", "radians"]),
        ("xyz=\"0 0 0.36\"", "xyz=\"0 0 O.36\"", vec!["[urdf-not-number] word=O.36", "arm.urdf:"]),
        ("xyz=\"0 0 0.36\"", "xyz=\"0 0 ${length}\"", vec!["[urdf-not-number] word=${length}", "arm.urdf:"]),
        (
            "<link name=\"wrist_2_link\">",
            "<xacro:arm/><link name=\"wrist_2_link\">",
            vec!["error[xacro-construct]", "`<xacro:arm>`", "arm.urdf:92", "arm.urdf > ", "arm-expanded.urdf"],
        ),
        (
            "<link name=\"wrist_2_link\">",
            "<link name=\"wrist_2_link\"><visual><xacro:mesh name=\"arm\"/></visual>",
            vec!["error[xacro-construct]", "`<xacro:mesh>`"],
        ),
        ("name=\"wrist_1\" type=\"revolute\"", "name=\"wrist_1\" type=\"planar\"", vec!["[urdf-joint-kind]"]),
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
            vec!["[bending-on-moving-base] link=column_height", "robot.toml:6"],
        ),
        ("\"elbow\"]", "\"elbo\"]", vec!["[joint-reference-wrong] fault=unknown-name joint=elbo", "robot.toml:6"]),
        ("\"elbow\"]", "9]", vec!["[joint-reference-wrong] fault=unknown-number joint=9"]),
        ("model = \"urdf\"", "model = \"serial\"", vec!["[key-of-other-model] key=file"]),
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
    ends(&scratch, "check", 2, &["error[xacro-construct]"]);
}

/// The hint is the command with the names of the files, and `init` refuses the file too.
#[test]
fn a_xacro_file_is_refused_with_the_command_that_expands_it() {
    let scratch = copy_sample("column-arm");
    let text = std::fs::read_to_string(scratch.path().join("arm.urdf")).unwrap();
    let xacro = text.replace("</robot>", "<xacro:include filename=\"parts.xacro\"/></robot>");
    std::fs::write(scratch.path().join("arm.urdf.xacro"), &xacro).unwrap();
    scratch.replace("robot.toml", "file = \"arm.urdf\"", "file = \"arm.urdf.xacro\"");
    ends(&scratch, "check", 2, &["error[xacro-construct]", "arm.urdf.xacro > "]);
    for (name, expected) in [
        ("arm.urdf.xacro", "xacro arm.urdf.xacro > arm.urdf"),
        ("arm.xacro", "xacro arm.xacro > arm.urdf"),
        ("arm.xml", "xacro arm.xml > arm-expanded.urdf"),
        ("two arms.urdf.xacro", "xacro 'two arms.urdf.xacro' > 'two arms.urdf'"),
    ] {
        let path = scratch.path().join(name);
        std::fs::write(&path, &xacro).unwrap();
        let problems = etalon::campaign::read_urdf(&path).unwrap_err();
        let folder = format!("{}/", scratch.path().display());
        let command = |message: &Message| match &message.arguments["command"] {
            Argument::Text(text) => text.replace(&folder, ""),
            other => panic!("{other:?}"),
        };
        assert!(problems.0[0].is("xacro-construct", &[("construct", &"<xacro:include>")]), "{problems:?}");
        assert_eq!(command(&problems.0[0]), expected, "{name}");
    }
}
