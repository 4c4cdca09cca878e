//! URDF files that are wrong: each error names the file, the line and what to do.

use super::ends;
use crate::support::scratch::{Scratch, copy_sample};

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
        ("xyz=\"0 0 0.36\"", "xyz=\"0 0 ${length}\"", vec!["error[xacro-undefined]", "arm.urdf:"]),
        (
            "<link name=\"wrist_2_link\">",
            "<xacro:arm/><link name=\"wrist_2_link\">",
            vec!["error[xacro-construct]", "`<xacro:arm>`", "arm.urdf > ", "arm-expanded.urdf"],
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

/// Link names of a file whose only link is named by an expression, or the id of the first error.
fn expanded(head: &str, value: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("arm.urdf.xacro");
    let rest = "<link name=\"b\"/><joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/></joint>";
    let robot = format!("<robot>{head}<link name=\"a\"/><link name=\"={value}\"/>{rest}</robot>");
    std::fs::write(&path, robot).unwrap();
    match etalon::campaign::read_urdf(&path, &[]) {
        Ok((_, text)) => {
            let (_, rest) = text.text.split_once("<link name=\"=").unwrap();
            rest.split('"').next().unwrap().to_owned()
        }
        Err(problems) => problems.0[0].id.to_string(),
    }
}

/// The right-hand sides are the output of xacro 2.1.1.
#[test]
fn expressions_are_those_of_xacro() {
    let head = "<xacro:arg name=\"q\" default=\"7\"/><xacro:property name=\"a\" value=\"2\"/>\
        <xacro:property name=\"b\" value=\"0.25\"/><xacro:property name=\"c\" value=\"left\"/>\
        <xacro:property name=\"d\" value=\"${a*b}\"/><xacro:property name=\"e\" value=\"${a} ${b}\"/>\
        <xacro:property name=\"t\" value=\"true\"/><xacro:property name=\"f\" value=\"'12'\"/>\
        <xacro:property name=\"g\" value=\" 5 \"/><xacro:property name=\"u\" value=\"$(arg q)\"/>";
    for (value, expected) in [
        ("${1+2}", "3"),
        ("${4/2}", "2.0"),
        ("${1/3}", "0.3333333333333333"),
        ("${-2**2}", "-4"),
        ("${2**3**2}", "512"),
        ("${2**-1}", "0.5"),
        ("${10-2-3}", "5"),
        ("${math.pi/4}", "0.7853981633974483"),
        ("${radians(90)}", "1.5707963267948966"),
        ("${atan2(1,2)}", "0.4636476090008061"),
        ("${1e20} ${1e-7}", "1e+20 1e-07"),
        ("${(1+2)*(3-4)}", "-3"),
        ("${a - -b}", "2.25"),
        ("${c}_${a}", "left_2"),
        ("${c + 'x'}", "leftx"),
        ("${d} ${e}", "0.5 2 0.25"),
        ("${t} ${f} ${g+1} ${u+1}", "True 12 6 8"),
        ("$${a} $$(arg q) $$${a} a$b", "${a} $(arg q) $${a} a$b"),
        ("${nothing}", "xacro-undefined"),
        ("$(arg nothing)", "xacro-argument-missing"),
        ("$(env HOME)", "xacro-construct"),
        ("${xacro.load_yaml('x')}", "xacro-construct"),
        ("${1 if a else 2}", "xacro-construct"),
        ("${a[0]}", "xacro-construct"),
        ("${1/0}", "xacro-construct"),
        ("${2**999999999}", "xacro-construct"),
        ("${((((((((((((((((((((((((((((((((((1))))))))))))))))))))))))))))))))))}", "xacro-value-too-long"),
    ] {
        assert_eq!(expanded(head, value), expected, "{value}");
    }
    let doubled: String =
        (1..60).map(|i| format!("<xacro:property name=\"p{i}\" value=\"${{p{0}}}${{p{0}}}\"/>", i - 1)).collect();
    let doubled = format!("<xacro:property name=\"p0\" value=\"0123456789\"/>{doubled}");
    assert_eq!(expanded(&doubled, "${p59}"), "xacro-value-too-long");
    assert_eq!(expanded(&doubled, "${p20}"), "xacro-value-too-long");
    let own = "<xacro:property name=\"a\" value=\"${b}\"/><xacro:property name=\"b\" value=\"${a}\"/>";
    assert_eq!(expanded(own, "${a}"), "xacro-recursion");
    for head in ["<xacro:if value=\"1\"/>", "<xacro:macro name=\"m\"><link name=\"x\"/></xacro:macro><xacro:m/>"] {
        assert_eq!(expanded(head, ""), "xacro-construct");
    }
    assert_eq!(expanded("<xacro:macro name=\"m\"><link name=\"${x}\"/></xacro:macro>", "l"), "l", "never called");
    assert_eq!(expanded("<xacro:include filename=\"arm.urdf.xacro\"/>", ""), "xacro-include-loop");
    assert_eq!(expanded("<xacro:include filename=\"$(find nowhere_at_all)/x\"/>", ""), "xacro-package");
    assert_eq!(expanded("<xacro:include filename=\"missing.xacro\"/>", ""), "xacro-include-unreadable");
    assert_eq!(expanded("<xacro:include filename=\"missing.xacro\" optional=\"true\"/>", "l"), "l");
}

/// Includes that double must end: 2³¹ links would be the whole.
#[test]
fn includes_within_each_other_are_limited() {
    let folder = tempfile::tempdir().unwrap();
    for i in 0..40 {
        let next = format!("<xacro:include filename=\"{}.xacro\"/>", i + 1);
        std::fs::write(folder.path().join(format!("{i}.xacro")), format!("<robot>{next}{next}</robot>")).unwrap();
    }
    let problems = etalon::campaign::read_urdf(&folder.path().join("0.xacro"), &[]).unwrap_err();
    assert_eq!(problems.0[0].id, "xacro-too-many-files");
}

#[test]
fn a_campaign_runs_on_xacro_as_on_the_urdf_that_it_stands_for() {
    let plain = copy_sample("column-arm");
    let scratch = copy_sample("column-arm");
    let text = std::fs::read_to_string(scratch.path().join("arm.urdf")).unwrap();
    let names = "<robot name=\"column_arm\">";
    let head = format!(
        "{names}<xacro:arg name=\"prefix\"/><xacro:property name=\"p\" value=\"$(arg prefix)\"/>\
         <xacro:include filename=\"parts/lengths.xacro\"/>"
    );
    let xacro = text.replace(names, &head).replace("\"elbow\"", "\"${p}ow\"");
    let xacro = xacro.replace("xyz=\"0 0 0.36\"", "xyz=\"0 0 ${forearm / 1000}\"");
    assert_ne!(xacro, text.replace(names, &head));
    std::fs::remove_file(scratch.path().join("arm.urdf")).unwrap();
    std::fs::write(scratch.path().join("arm.urdf.xacro"), &xacro).unwrap();
    std::fs::create_dir(scratch.path().join("parts")).unwrap();
    let lengths = "<robot>\n<xacro:property name=\"forearm\" value=\"360.0\"/>\n</robot>";
    std::fs::write(scratch.path().join("parts/lengths.xacro"), lengths).unwrap();
    scratch.replace("robot.toml", "file = \"arm.urdf\"", "file = \"arm.urdf.xacro\"\narguments = [\"prefix:=elb\"]");
    for scratch in [&plain, &scratch] {
        ends(scratch, "run", 0, &[]);
    }
    let parameters = |scratch: &Scratch| {
        let text = std::fs::read_to_string(scratch.path().join("out/parameters.json")).unwrap();
        serde_json::from_str::<serde_json::Value>(&text).unwrap()["parameters"].clone()
    };
    assert_eq!(parameters(&plain), parameters(&scratch));
    // every file that was read is among the inputs
    let import = std::fs::read_to_string(scratch.path().join("out/import.json")).unwrap();
    assert!(import.contains("\"arm.urdf.xacro\"") && import.contains("\"parts/lengths.xacro\""), "{import}");
    // an included file in another folder would not be archived with the campaign
    std::fs::rename(scratch.path().join("parts/lengths.xacro"), scratch.root().join("lengths.xacro")).unwrap();
    scratch.replace("arm.urdf.xacro", "parts/lengths.xacro", "../lengths.xacro");
    ends(&scratch, "check", 2, &["error[path-outside]"]);
    for (from, to, id) in [
        ("prefix:=elb", "prefx:=elb", "xacro-argument-missing"),
        ("prefix:=elb\"", "prefix:=elb\", \"more:=1\"", "xacro-argument-unknown"),
        ("prefix:=elb", "prefix=elb", "xacro-argument-form"),
    ] {
        let changed = scratch.path().join("robot.toml");
        let text = std::fs::read_to_string(&changed).unwrap();
        scratch.replace("robot.toml", from, to);
        ends(&scratch, "check", 2, &[&format!("error[{id}]")]);
        std::fs::write(changed, text).unwrap();
    }
}
