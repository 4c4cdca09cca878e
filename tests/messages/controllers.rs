//! Messages about files for controllers, and about results of runs.

use super::{CHECK, Case, hold};

const ARM: &str = "draw-wire+out";
const TABLE: &str = "prexyt-cmm+out";
const COMMENT: &str = "! approach\nMoveL p1";
const LEADS: &str = "prexyt-geometric+out";
const RAPID: &str = "MODULE m\nCONST robtarget p1 := [[300,0,400],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\nPROC main()\nMoveL p1, v10, fine, tGrip;\nENDPROC\nENDMODULE\n";

const VERIFY: &str = "verify @/out/observations.csv --robot @/robot.toml --parameters @/out/parameters.json";

const CASES: &[Case] = &[
    ("controller-format-unknown name=jsn", ARM, &[], "export @/out/parameters.json --format jsn"),
    ("nothing-to-load-by-run", "field-arm+out", &[], "export @/out/parameters.json --to @/files"),
    ("controller-format-unknown name=rapid", ARM, &[], "export @/out/parameters.json --format rapid"),
    ("linuxcnc-joint-offsets", ARM, &[], "export @/out/parameters.json --robot @/robot.toml --format linuxcnc"),
    (
        "linuxcnc-distant-normal first=2 second=3",
        ARM,
        &[],
        "export @/out/parameters.json --robot @/robot.toml --format linuxcnc",
    ),
    ("template-name", ARM, &[("t.txt", "", "")], "export @/out/parameters.json --template @/t.txt"),
    (
        "template-without-holds",
        ARM,
        &[("t.txt.j2", "", "{{ etalon }}")],
        "export @/out/parameters.json --template @/t.txt.j2",
    ),
    // screw axes have no zeros of joints
    (
        "template-holds-unknown pattern=theta_* hint=convert-to-denavit-hartenberg",
        "probe-poses+out",
        &[("t.txt.j2", "", "{# holds: theta_* #}\n")],
        "export @/out/parameters.json --robot @/robot.toml --template @/t.txt.j2",
    ),
    (
        "template-holds-unknown pattern=thta_*",
        ARM,
        &[("t.txt.j2", "", "{# holds: thta_* #}\n")],
        "export @/out/parameters.json --robot @/robot.toml --template @/t.txt.j2",
    ),
    (
        "template-parameters-unread",
        ARM,
        &[("t.txt.j2", "", "{# holds: theta_* #}\n{{ parameter[\"theta_2\"].value }}\n")],
        "export @/out/parameters.json --robot @/robot.toml --template @/t.txt.j2 --to @/files",
    ),
    (
        "robot-missing",
        ARM,
        &[("t.txt.j2", "", "{# holds: theta_* #}\n")],
        "export @/out/parameters.json --template @/t.txt.j2",
    ),
    (
        "controller-template-failed",
        ARM,
        &[("t.txt.j2", "", "{# holds: * #}\n{{ parameter[\"theta_9\"].value }}\n")],
        "export @/out/parameters.json --robot @/robot.toml --template @/t.txt.j2",
    ),
    (
        "controller-template-failed",
        ARM,
        &[("t.txt.j2", "", "{# holds: * #}\n{% for %}\n")],
        "export @/out/parameters.json --template @/t.txt.j2",
    ),
    (
        "controller-template-failed",
        ARM,
        &[(
            "t.txt.j2",
            "",
            "{# holds: * #}\n{% for i in range(9000) %}{% for j in range(9000) %}x{% endfor %}{% endfor %}\n",
        )],
        "export @/out/parameters.json --template @/t.txt.j2",
    ),
    (
        "template-name-reserved file=parameters.json",
        ARM,
        &[("parameters.json.j2", "", "{# holds: * #}\n")],
        "export @/out/parameters.json --template @/parameters.json.j2",
    ),
    ("template-without-holds", ARM, &[("t.txt.j2", "", "x"), ("campaign.toml", "[\"json\"]", "[\"t.txt.j2\"]")], CHECK),
    ("robot-option-missing", ARM, &[], "axis-table @/out/parameters.json --axis q1_deg=0:100:10"),
    (
        "table-of-turning-joints",
        ARM,
        &[],
        "axis-table @/out/parameters.json --robot @/robot.toml --axis q1_deg=0:90:10 --corrected q2_deg",
    ),
    ("lead-of-one-axis", LEADS, &[], "axis-table @/out/geometric.json --axis rho1_mm=0:100:10 --corrected rho2_mm"),
    ("deviation-unknown", LEADS, &[], "axis-table @/out/geometric.json --axis rho1_mm=0:500:10"),
    ("file-changed-since-run", TABLE, &[("out/parameters.json", "+", " ")], "report @"),
    ("file-changed-since-run", TABLE, &[("out/controller.json", "+", " ")], "report @ --certificate"),
    (
        "counts-missing",
        TABLE,
        &[("t.csv", "", "pose,rho1_mm,rho2_mm,rho3_mm\n1,10,20,20\n")],
        "compensate @/t.csv --robot @/robot.toml --parameters @/out/parameters.json --format galil",
    ),
    (
        "joints-in-world",
        TABLE,
        &[("t.csv", "", "pose,rho1_mm,rho2_mm,rho3_mm\n1,10,20,20\n")],
        "compensate @/t.csv --robot @/robot.toml --parameters @/out/parameters.json --frame world",
    ),
    (
        "target-unreachable",
        ARM,
        &[("p.mod", "", RAPID), ("p.mod", "tGrip", "tool0"), ("p.mod", "[300,0,400]", "[9300,0,400]")],
        "compensate @/p.mod --robot @/robot.toml --parameters @/out/parameters.json",
    ),
    (
        "program-frames",
        ARM,
        &[("p.mod", "", RAPID)],
        "compensate @/p.mod --robot @/robot.toml --parameters @/out/parameters.json",
    ),
    (
        "program-frames",
        ARM,
        &[("p.mod", "", RAPID), ("p.mod", "MoveL p1", COMMENT)],
        "compensate @/p.mod --robot @/robot.toml --parameters @/out/parameters.json",
    ),
    (
        "working-mode-missing",
        "dextar+out",
        &[("p.ngc", "", "G1 X300 Y300 F100\n")],
        "compensate @/p.ngc --robot @/robot.toml --parameters @/out/parameters.json",
    ),
    (
        "nominal-pose-unreachable",
        "dextar+out",
        &[("t.csv", "", "pose,theta1_deg,theta2_deg,assembly\n1,180,0,1\n")],
        "compensate @/t.csv --robot @/robot.toml --parameters @/out/parameters.json",
    ),
    (
        "calibrated-targets-missing",
        "delta+out",
        &[(
            "t.csv",
            "",
            "pose,target,theta1_deg,theta2_deg,theta3_deg,x_mm,y_mm,z_mm\n1,NEW,10,20,30,100,100,100\n2,NEW,20,20,30,100,110,100\n",
        )],
        "verify @/t.csv --robot @/robot.toml --parameters @/out/parameters.json",
    ),
    (
        "changes-undetected",
        "column-arm+out",
        &[],
        "verify --candidates @/out/observations.csv --positions 3 --uncertainty-bound 1um --robot @/robot.toml --parameters @/out/parameters.json",
    ),
    ("prior-of-conditions", ARM, &[], "validate @ --parameters @/out/parameters.json --frames prior"),
    ("hash-of-other-format", ARM, &[], "export @/out/parameters.json --format json --controller-hash calib_1"),
    (
        "program-in-world",
        ARM,
        &[("p.mod", "", RAPID), ("p.mod", "tGrip", "tool0")],
        "compensate @/p.mod --robot @/robot.toml --parameters @/out/parameters.json --frame world",
    ),
    (
        "subroutine-not-compensated",
        ARM,
        &[("p.ngc", "", "#1 = 10\nG1 X1 Y1 Z1 F100\n")],
        "compensate @/p.ngc --robot @/robot.toml --parameters @/out/parameters.json",
    ),
    (
        "kinds-without-uncertainty",
        "probe-poses",
        &[],
        "identify --robot @/robot.toml --observations @/observations.csv --rotation-uncertainty-deg 0.02",
    ),
    (
        "pose-residuals-without-uncertainty",
        "prexyt-cmm+out",
        &[],
        "identify --robot @/robot.toml --observations @/out/observations.csv --pose-residuals",
    ),
    ("campaign-twice", TABLE, &[], "compare @ @"),
    ("file-not-of-run", TABLE, &[("out/manifest.json", "\"residuals.parquet\"", "\"other.parquet\"")], "report @"),
    (
        "calibration-without-residuals",
        TABLE,
        &[
            ("out/manifest.json", "", ""),
            ("out/parameters.json", "\"degrees_of_freedom\": 146", "\"degrees_of_freedom\": 0"),
            (
                "out/parameters.json",
                "\"stated_standard_uncertainty_mm\": 0.00135",
                "\"stated_standard_uncertainty_mm\": null",
            ),
        ],
        VERIFY,
    ),
    (
        "motions-alike",
        TABLE,
        &[(
            "out/observations.csv",
            "",
            "pose,cycle,target,x_mm,y_mm,rho1_mm,rho2_mm,rho3_mm\n1,1,K,66.8766,342.3231,0,300,300\n1,1,L,212.8986,342.6089,0,300,300\n",
        )],
        VERIFY,
    ),
    (
        "verify-without-observations",
        ARM,
        &[(
            "out/observations.csv",
            "",
            "kind,pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\npoint,1,ball,10,20,30,40,50,60,,,\n",
        )],
        VERIFY,
    ),
    ("readings-of-calibration count=590 rows=590", TABLE, &[], VERIFY),
    (
        "campaign-without-observations",
        TABLE,
        &[],
        "verify @/out/observations.csv --robot @/robot.toml --parameters @/out/parameters.json --like @",
    ),
    (
        "campaign-with-several-observations count=2",
        "probe-poses+out",
        &[("campaign.toml", "[observations]\n", "[[observations]]\nfile = \"observations.csv\"\n[[observations]]\n")],
        "verify @/out/observations.csv --robot @/robot.toml --parameters @/out/parameters.json --like @",
    ),
    (
        "verify-quantity-without-residuals quantity=orientation",
        "column-arm+out",
        &[(
            "few.csv",
            "",
            "pose,target,x_mm,y_mm,z_mm,qw,qx,qy,qz,urot_deg,lift_m,shoulder_pan_rad,shoulder_lift_rad,elbow_rad,wrist_1_rad,wrist_2_rad,wrist_3_rad\n1,SMR_1,100,200,300,1,0,0,0,0.01,0.6,0.5,-0.6,-1.6,-0.1,2.5,-2.1\n",
        )],
        "verify @/few.csv --robot @/robot.toml --parameters @/out/parameters.json",
    ),
];

#[test]
fn of_results() {
    hold(CASES);
}
