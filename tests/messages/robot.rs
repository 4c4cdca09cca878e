//! Messages about robot.toml and URDF files.

use super::{CHECK, Case, hold};

const R: &str = "robot.toml";
const CMM: &str = "prexyt-cmm";
const DH: &str = "draw-wire";
const SCREWS: &str = "probe-poses";
const U: &str = "arm.urdf";
const URDF: &str = "column-arm";
const HANDS: &str = "two-hands";
const O: &str = "observations.csv";
const ELBOW: &str = "<joint name=\"elbow\" type=\"revolute\">";
const PAN: &str = "    <child link=\"shoulder_link\"/>\n";

const KEYS: &[Case] = &[
    ("nominal-missing", CMM, &[(R, "s = 394.0\n", "")], CHECK),
    ("nominal-unknown parameter=s9", CMM, &[(R, "[nominal]", "[nominal]\ns9 = 1.0")], CHECK),
    ("nominal-length-not-positive parameter=l11", "dextar", &[(R, "l11 = 230.0", "l11 = -230.0")], CHECK),
    ("key-of-other-model key=rod_mm", CMM, &[(R, "[nominal]", "rod_mm = 400.0\n[nominal]")], CHECK),
    ("tolerance-not-positive parameter=a_2", DH, &[(R, "convention", "tolerance = { a_2 = 0 }\nconvention")], CHECK),
    ("tolerance-unknown parameter=a_99", DH, &[(R, "convention", "tolerance = { a_99 = 1 }\nconvention")], CHECK),
    ("joint-key-missing key=a_mm", DH, &[(R, "a_mm = 270, ", "")], CHECK),
    ("joint-axis-without-direction", SCREWS, &[(R, "{ direction = [0, 0, 1]", "{ direction = [0, 0, 0]")], CHECK),
    ("not-denavit-hartenberg key=point_mm", DH, &[(R, "a_mm = 270,", "a_mm = 270, point_mm = [0, 0, 0],")], CHECK),
    ("flange-missing", SCREWS, &[(R, "flange_xyz_mm = [374, 0, 630]\n", "")], CHECK),
    ("flange-of-table", DH, &[(R, "convention", "flange_xyz_mm = [374, 0, 630]\nconvention")], CHECK),
    ("joint-reference-wrong fault=unknown-number", DH, &[(R, "convention", "coupling = [[7, 4]]\nconvention")], CHECK),
    ("range-exchanged", DH, &[(R, "a_mm = 270,", "a_mm = 270, limits_deg = [170, -170],")], CHECK),
    ("range-of-other-motion", "rail-arm", &[(R, "prismatic = true", "prismatic = true, limits_deg = [0, 1]")], CHECK),
    (
        "hexapod-singular",
        "hexapod",
        &[
            (R, "platform_mm = [96.418, -114.907, 0.0]", "platform_mm = [295.442, -52.094, 0.0]"),
            (R, "platform_mm = [96.418, 114.907, 0.0]", "platform_mm = [295.442, 52.094, 0.0]"),
            (R, "platform_mm = [51.303, 140.954, 0.0]", "platform_mm = [-102.606, 281.908, 0.0]"),
            (R, "platform_mm = [-147.721, 26.047, 0.0]", "platform_mm = [-192.836, 229.813, 0.0]"),
            (R, "platform_mm = [-147.721, -26.047, 0.0]", "platform_mm = [-192.836, -229.813, 0.0]"),
            (R, "platform_mm = [51.303, -140.954, 0.0]", "platform_mm = [-102.606, -281.908, 0.0]"),
        ],
        CHECK,
    ),
    ("no-target", "delta", &[("campaign.toml", "targets = [\"SMR_1\", \"SMR_2\", \"SMR_3\"]", "targets = []")], CHECK),
    (
        "target-called-base",
        "delta",
        &[("campaign.toml", "\"SMR_3\"]", "\"base\"]"), ("exports/poses.txt", "SMR_3_", "base_")],
        CHECK,
    ),
    ("bending-on-moving-base", "two-arms", &[(R, "base_link", "bending = [\"left_q2\"]\nbase_link")], CHECK),
    ("tool-link-missing", URDF, &[(R, "tool_link = \"tool\"", "")], CHECK),
    ("tool-link-beside-branches", HANDS, &[(R, "base_link", "tool_link = \"left_hand\"\nbase_link")], CHECK),
    ("target-on-two-branches target=L1", HANDS, &[(R, "[\"R1\", \"R2\"]", "[\"R1\", \"R2\", \"L1\"]")], CHECK),
    ("target-on-no-branch target=R2", HANDS, &[(R, "\"R1\", \"R2\"", "\"R1\"")], CHECK),
    ("payload-in-branches joint=torso_yaw", HANDS, &[(R, "base_link", "payload = [\"torso_yaw\"]\nbase_link")], CHECK),
    ("elastic-in-branches key=pedestal", HANDS, &[(R, "base_link", "pedestal = true\nbase_link")], CHECK),
    ("bending-in-branches joint=torso_yaw", HANDS, &[(R, "base_link", "bending = [\"torso_yaw\"]\nbase_link")], CHECK),
    (
        "coupling-across-branches joint=left_1",
        HANDS,
        &[(R, "base_link", "coupling = [[\"left_1\", \"right_1\"]]\nbase_link")],
        CHECK,
    ),
    (
        "several-branches",
        HANDS,
        &[("t.csv", "", "torso_yaw_deg\n1\n")],
        "kinematics direct @/t.csv --robot @/robot.toml",
    ),
    ("target-of-same-branch name=L2", HANDS, &[(O, "+", "bar,81,L1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,L2,,,,,\n")], CHECK),
    (
        "bar-without-other-hand name=anchor",
        HANDS,
        &[(O, "+", "bar,81,L1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,anchor,,,,,\n")],
        CHECK,
    ),
    ("bar-length-at-pose", HANDS, &[(O, "+", "bar,81,L1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,R1,,,,650,\n")], CHECK),
    (
        "rigid-across-branches",
        HANDS,
        &[("campaign.toml", "[limits]", "[[rigid]]\ntargets = [\"L1\", \"R1\"]\ntolerance_mm = 1.0\n[limits]")],
        CHECK,
    ),
    ("bending-without-mass", URDF, &[(U, "<inertial>", "<!--"), (U, "</inertial>", "-->")], CHECK),
];

const FILES: &[Case] = &[
    (
        "urdf-axis-without-direction joint=wrist_2",
        URDF,
        &[(U, "<axis xyz=\"0 1 1\"/>", "<axis xyz=\"0 0 0\"/>")],
        CHECK,
    ),
    ("urdf-joint-kind joint=elbow", URDF, &[(U, ELBOW, "<joint name=\"elbow\" type=\"planar\">")], CHECK),
    ("urdf-link-unknown link=tool9", URDF, &[(R, "\"tool\"", "\"tool9\"")], CHECK),
    (
        "urdf-mimic-unknown joint=elbow",
        URDF,
        &[(U, ELBOW, "<joint name=\"elbow\" type=\"revolute\"><mimic joint=\"q9\"/>")],
        CHECK,
    ),
    (
        "urdf-mimics-several joint=elbow",
        URDF,
        &[(U, ELBOW, "<joint name=\"elbow\" type=\"revolute\"><mimic joint=\"wrist_1\"/><mimic joint=\"wrist_2\"/>")],
        CHECK,
    ),
    (
        "urdf-mimics-itself joint=elbow",
        URDF,
        &[(U, ELBOW, "<joint name=\"elbow\" type=\"revolute\"><mimic joint=\"elbow\"/>")],
        CHECK,
    ),
    ("urdf-nothing-moves", URDF, &[(R, "tool_link = \"tool\"", "tool_link = \"column_base\"")], CHECK),
    (
        "urdf-no-path",
        URDF,
        &[(U, "</robot>", "<link name=\"alone\"/></robot>"), (R, "\"base_link\"", "\"alone\"")],
        CHECK,
    ),
    (
        "urdf-two-parents link=elbow_link",
        URDF,
        &[
            (U, PAN, "    <child link=\"elbow_link\"/>\n"),
            (U, "<child link=\"forearm_link\"/>", "<child link=\"elbow_link\"/>"),
            (U, "\"forearm_link\"", "\"elbow_link\""),
        ],
        CHECK,
    ),
    (
        "urdf-loop",
        URDF,
        &[(
            U,
            "</robot>",
            "<joint name=\"back\" type=\"fixed\"><parent link=\"tool\"/><child link=\"base_link\"/></joint></robot>",
        )],
        CHECK,
    ),
    ("urdf-origin-far joint=elbow", URDF, &[(U, "xyz=\"0 -0.1 0.4\"", "xyz=\"300 0 0\"")], CHECK),
    ("urdf-attribute-missing", URDF, &[(U, ELBOW, "<joint type=\"revolute\">")], CHECK),
    ("urdf-joint-twice joint=wrist_1", URDF, &[(U, ELBOW, "<joint name=\"wrist_1\" type=\"revolute\">")], CHECK),
    ("urdf-joint-without-link joint=shoulder_pan", URDF, &[(U, PAN, "")], CHECK),
    (
        "urdf-limits-exchanged joint=elbow",
        URDF,
        &[(U, "lower=\"-2.6\" upper=\"2.6\"", "lower=\"2.6\" upper=\"-2.6\"")],
        CHECK,
    ),
    ("urdf-no-robot", URDF, &[(U, "", "<sdf/>")], CHECK),
    ("urdf-not-number word=x", URDF, &[(U, "xyz=\"0 -0.1 0.4\"", "xyz=\"0 0 x\"")], CHECK),
    (
        "xacro-construct",
        URDF,
        &[
            (U, "</robot>", "<xacro:arm/></robot>"),
            (U, "<robot ", "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\" "),
        ],
        CHECK,
    ),
    (
        "urdf-no-moving-joint",
        "",
        &[(U, "", "<robot name=\"table\"><link name=\"a\"/></robot>")],
        "init @/new --urdf @/arm.urdf",
    ),
];

#[test]
fn of_keys_and_joints() {
    hold(KEYS);
}

#[test]
fn of_urdf_files() {
    hold(FILES);
}
