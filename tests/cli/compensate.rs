//! `etalon compensate`: a nominal controller that is commanded what it prints brings the identified robot to its targets.

use super::{etalon, text};
use crate::campaigns::controllers::{disturbed, parameters};
use crate::support::root;
use crate::support::said::{Says, has};
use crate::support::scratch::Scratch;
use etalon::base::phrase;
use etalon::base::pose::{Pose, minus, norm};
use etalon::campaign::read_robot;
use etalon::documents::CompensationDocument;
use std::path::PathBuf;

/// A robot that differs from its drawing as calibrations find it, in a folder.
struct Real {
    scratch: Scratch,
    robot: PathBuf,
    parameters: String,
}

impl Real {
    fn new(robot: &str) -> Self {
        let robot = root().join(robot);
        let scratch = Scratch::with(&[]);
        let model = read_robot(&robot).unwrap().build(&["tool".to_owned()]).unwrap();
        let parameters = parameters(&scratch, model.as_ref(), &disturbed(model.as_ref(), &[]));
        Self { scratch, robot, parameters }
    }

    /// The answer about a file of targets, its exit code and what stderr says.
    fn compensate(&self, name: &str, targets: &[u8], more: &[&str]) -> (Vec<u8>, Option<i32>, String) {
        std::fs::write(self.scratch.path().join(name), targets).unwrap();
        let robot = self.robot.display().to_string();
        let all = [&["compensate", name, "--robot", &robot, "--parameters", &self.parameters], more].concat();
        let output = etalon(&self.scratch.path(), &all);
        (output.stdout, output.status.code(), text(&output.stderr))
    }

    fn table(&self, targets: &str, more: &[&str]) -> (String, Option<i32>, String) {
        let (answer, code, said) = self.compensate("targets.csv", targets.as_bytes(), more);
        (text(&answer), code, said)
    }

    /// Where the identified robot is when its nominal controller, near these joints, is commanded poses.
    fn commanded(&self, poses: &str) -> Vec<Pose> {
        std::fs::write(self.scratch.path().join("commands.csv"), poses).unwrap();
        let robot = self.robot.display().to_string();
        let kinematics = |direction: &str, table: &str, more: &[&str]| {
            let all = [&["kinematics", direction, table, "--robot", &robot], more].concat();
            let output = etalon(&self.scratch.path(), &all);
            assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
            text(&output.stdout)
        };
        let joints = kinematics("inverse", "commands.csv", &["--nearest"]);
        std::fs::write(self.scratch.path().join("joints.csv"), joints).unwrap();
        let row = |line: &str| {
            let v: Vec<f64> = line.split(',').skip(1).map(|v| v.parse().unwrap()).collect();
            Pose { translation_mm: [v[0], v[1], v[2]], ..Pose::from_quaternion([v[3], v[4], v[5], v[6]]) }
        };
        let poses = kinematics("direct", "joints.csv", &["--parameters", &self.parameters]);
        poses.lines().skip(1).map(row).collect()
    }
}

fn cases() -> [(&'static str, &'static str); 5] {
    [
        (
            "samples/prexyt-cmm/robot.toml",
            "pose,x_mm,y_mm,qw,qx,qy,qz\nhome,200,150,1,0,0,0\n2,180,160,0.9998477,0,0,0.0174524\n",
        ),
        (
            "samples/dextar/robot.toml",
            "pose,x_mm,y_mm,theta1_deg,theta2_deg,assembly\n1,40,330,110,70,1\nP2,-60,300,110,70,1\n",
        ),
        (
            "samples/abb-irb120/robot.toml",
            "pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\n1,300,100,500,0,0.6,0.8,0\n2,320,-120,400,0.1,0.7,0.7,0.1\n",
        ),
        (
            "docs/keys/robot-serial-dh.toml",
            "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,20,-70,60,-50,40,30\n2,25,-75,60,-55,40,30\n",
        ),
        (
            "samples/column-arm/robot.toml",
            "pose,lift_m,shoulder_pan_rad,shoulder_lift_rad,elbow_rad,wrist_1_rad,wrist_2_rad,wrist_3_rad\n\
             a,0.3,0.5,-0.7,-1.6,-0.1,2.5,-2.1\n",
        ),
    ]
}

#[test]
fn a_nominal_controller_brings_the_identified_robot_to_the_targets() {
    for (robot, targets) in cases() {
        let real = Real::new(robot);
        let (answer, code, said) = real.table(targets, &["--json"]);
        assert_eq!(code, Some(0), "{robot}: {said}");
        let document: CompensationDocument = serde_json::from_str(&answer).unwrap();
        assert_eq!(document.targets.len(), targets.lines().count() - 1);
        let (csv, code, _) = real.table(targets, &[]);
        assert_eq!(code, Some(0));
        // the controller starts at the joints of its row
        let commands: String = csv.lines().map(|l| l.rsplitn(4, ',').last().unwrap().to_owned() + "\n").collect();
        for (at, t) in real.commanded(&commands).iter().zip(&document.targets) {
            let off = norm(minus(at.translation_mm, t.xyz_mm));
            let turned = Pose::from_quaternion(t.quaternion).inverse().then(at);
            let turned = if robot.contains("dextar") { 0.0 } else { turned.angle_rad() };
            assert!(off < 1e-6 && turned < 1e-9, "{robot}: {off} mm, {turned} rad\n{csv}");
            assert!(t.residual_mm < 1e-6 && t.residual_deg < 1e-7 && t.same_configuration, "{robot}: {csv}");
            // and without compensation it is elsewhere
            let correction = norm(minus(t.command_xyz_mm, t.xyz_mm));
            assert!(correction > 0.1 && correction < 100.0, "{robot}: {correction}");
        }
    }
}

#[test]
fn targets_that_the_robot_does_not_reach_are_refused_by_name() {
    let real = Real::new("samples/prexyt-cmm/robot.toml");
    let table = "pose,x_mm,y_mm,qw,qx,qy,qz\nhome,200,150,1,0,0,0\nfar,900,150,1,0,0,0\n";
    let (csv, code, said) = real.table(table, &[]);
    assert!(
        code == Some(1) && said.contains("target far: rho1 =") && said.has_phrase("actuator-beyond-travel"),
        "{said}"
    );
    assert!(csv.contains("\nhome,") && !csv.contains("\nfar,"), "{csv}");
    for format in ["rapid", "krl", "urscript", "gcode"] {
        let (list, code, said) = real.table(table, &["--format", format]);
        assert!(code == Some(2) && list.is_empty() && said.contains("target far: "), "{format}: {said}");
    }
    let arm = Real::new("samples/abb-irb120/robot.toml");
    let (_, code, said) = arm.table("pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\nfar,3000,0,500,1,0,0,0\n", &[]);
    assert!(code == Some(1) && said.says("[target-unreachable] target=far reason=out of reach"), "{said}");
    // what does not go together
    for (more, part) in [
        (&["--format", "mecaprol"][..], "error[mecaprol-other-robot]"),
        (&["--format", "galil"], "--counts-per-unit"),
        (&["--tool", "1,2"], "expected x,y,z"),
        (&["--tool", "1,2,3,1,1,0,0"], "unit quaternion"),
    ] {
        let (_, code, said) = real.table(table, more);
        assert!(code == Some(2) && said.says(part), "{more:?}: {said}");
    }
}

#[test]
fn tool_object_and_world_are_applied() {
    let real = Real::new("samples/abb-irb120/robot.toml");
    let tool = Pose { translation_mm: [10.0, -20.0, 150.0], ..Pose::from_quaternion([0.5, 0.5, -0.5, 0.5]) };
    let object = Pose { translation_mm: [250.0, 60.0, 300.0], ..Pose::from_quaternion([0.8, 0.0, 0.0, 0.6]) };
    let flange = Pose { translation_mm: [300.0, 100.0, 500.0], ..Pose::from_quaternion([0.0, 0.6, 0.8, 0.0]) };
    let row = |pose: &Pose| {
        let v: Vec<String> = pose.translation_mm.iter().chain(&pose.quaternion()).map(|v| format!("{v:?}")).collect();
        format!("pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\n1,{}\n", v.join(","))
    };
    let command = |table: &str, more: &[&str]| {
        let (answer, code, said) = real.table(table, &[&["--json"], more].concat());
        assert_eq!(code, Some(0), "{said}");
        let document: CompensationDocument = serde_json::from_str(&answer).unwrap();
        let t = document.targets[0].clone();
        (Pose { translation_mm: t.command_xyz_mm, ..Pose::from_quaternion(t.command_quaternion) }, t.joints)
    };
    let (plain, joints) = command(&row(&flange), &[]);
    let in_object = object.inverse().then(&flange).then(&tool);
    let (shifted, same) =
        command(&row(&in_object), &["--tool", "10,-20,150,0.5,0.5,-0.5,0.5", "--object", "250,60,300,0.8,0,0,0.6"]);
    assert!(joints.iter().zip(&same).all(|(a, b)| (a - b).abs() < 1e-9), "{joints:?} {same:?}");
    let back = object.then(&shifted).then(&tool.inverse());
    assert!(norm(minus(back.translation_mm, plain.translation_mm)) < 1e-9);
    // the base is at the world's origin in this file, but for what `base_*` states
    let (world, _) = command(&row(&flange), &["--frame", "world"]);
    assert!(norm(minus(world.translation_mm, plain.translation_mm)) < 1e-9);
    let with_base = std::fs::read_to_string(&real.parameters).unwrap();
    let mut document: serde_json::Value = serde_json::from_str(&with_base).unwrap();
    let base = |p: &&mut serde_json::Value| p["name"] == "base_x";
    document["parameters"].as_array_mut().unwrap().iter_mut().find(base).unwrap()["value"] = 25.0.into();
    std::fs::write(&real.parameters, document.to_string()).unwrap();
    let moved = Pose { translation_mm: [325.0, 100.0, 500.0], ..flange };
    let (world, _) = command(&row(&moved), &["--frame", "world"]);
    assert!(norm(minus(world.translation_mm, plain.translation_mm)) < 1e-9);
}

/// The bytes of a program between the numbers of its targets, and these numbers.
fn apart(program: &[u8], targets: &[&str]) -> (Vec<u8>, Vec<f64>) {
    let (mut rest, mut numbers) = (Vec::new(), Vec::new());
    for line in program.split_inclusive(|b| *b == b'\n') {
        if !targets.iter().any(|t| line.windows(t.len()).any(|w| w == t.as_bytes())) {
            rest.extend_from_slice(line);
            continue;
        }
        let text: String = line.iter().map(|&b| b as char).collect();
        let cut = text.find(['[', '{']).unwrap();
        let (head, tail) = text.split_at(cut);
        rest.extend_from_slice(head.as_bytes());
        let mut word = String::new();
        for c in tail.chars() {
            if c.is_ascii_digit() || "+-.".contains(c) || ("eE".contains(c) && !word.is_empty()) {
                word.push(c);
            } else if !word.is_empty() {
                numbers.push(word.parse().unwrap_or(f64::NAN));
                word.clear();
            }
        }
    }
    (rest, numbers)
}

/// A program of the IRB 120: its comments in Latin-1, lines that end in CR LF, targets on several kinds of lines.
fn irb120_programs() -> [(&'static str, Vec<u8>, [&'static str; 2]); 3] {
    let latin = |text: &str| text.chars().map(|c| c as u8).collect::<Vec<u8>>();
    let rapid = "MODULE Main\r\n! Ziel f\u{fc}r [[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]\r\n\
        CONST robtarget pA:=[[300, 100.0,5E+02],[0,0.6,0.8,0],[0,0,0,0],[9E+09,9E9,9E9,9E9,9E9,9E9]];\r\n\
        CONST robtarget pB:=[[320,-120,400],[0,0.6,0.8,0],[-1,-1,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\r\n\
        CONST jointtarget jHome:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\r\n\
        PROC main()\r\n MoveAbsJ jHome,v100,fine,tool0;\r\n MoveL pA,v100,fine,tool0;\r\n\
        TPWrite \"[[7,7,7],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]\";\r\n\tMoveL Offs(pB,0,0,10),v100,z10,tool0\\WObj:=wobj0;\r\n\
        ENDPROC\r\nENDMODULE\r\n";
    let krl = "&ACCESS RVP\r\nDEF main()\r\n; gr\u{fc}n {X 1,Y 2,Z 3,A 4,B 5,C 6}\r\nDECL FRAME F={X 9,Y 9,Z 9,A 0,B 0,C 0}\r\n\
        $BASE=$NULLFRAME\r\nPTP {A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0}\r\nDECL E6POS XA={X 300, Y 100.0,Z 500,A 180.0,B 0,C -180,S 2,T 2,E1 0.0}\r\n\
        LIN {POS: x 320,y -120,z 400,a 170,b 0,c 180} C_DIS\r\nEND\r\n";
    let script = "def main(): # p[1,2,3,4,5,6]\r\n  set_payload(1.5, [0,0,0.1])\r\n  wp = p[0.3, .1, 0.5, 3.0, 0.5, 0]\r\n\
        movej([0, -1.57, 1.57, 0, 1.57, 0], a=1.4)\r\n  movel(wp, v=0.25)\r\n\
        movej(get_inverse_kin(p[0.320,-0.12,4e-1,2.9,0.4,0.1]), a=1)\r\n  movel(pose_trans(wp, p[0,0,0.1,0,0,0]))\r\nend\r\n";
    [
        ("main.mod", latin(rapid), ["pA:=", "pB:="]),
        ("main.src", latin(krl), ["XA=", "POS: "]),
        ("main.script", latin(script), ["wp = p", "get_inverse_kin("]),
    ]
}

#[test]
fn programs_have_other_targets_and_nothing_else_changed() {
    let real = Real::new("samples/abb-irb120/robot.toml");
    for (name, program, marks) in irb120_programs() {
        let (new, code, said) = real.compensate(name, &program, &[]);
        assert!(matches!(code, Some(0 | 1)), "{name}: {said}");
        assert!(has(&said, &phrase!("targets-compensated", count = 2, left = 1)), "{name}: {said}");
        // a controller of Universal Robots computes with its own calibration
        assert_eq!(said.says("[controller-calibrated]"), name.ends_with("script"), "{name}: {said}");
        let (rest, old_numbers) = apart(&program, &marks);
        let (new_rest, new_numbers) = apart(&new, &marks);
        assert_eq!(rest, new_rest, "{name}: {}", String::from_utf8_lossy(&new));
        assert_eq!(old_numbers.len(), new_numbers.len(), "{name}: {}", String::from_utf8_lossy(&new));
        // configuration data and external axes are kept, positions moved by what a calibration corrects
        let kept = match name {
            "main.mod" => 7..17,
            "main.src" => 6..10,
            _ => 12..13,
        };
        assert_eq!(old_numbers[kept.clone()], new_numbers[kept], "{name}: {new_numbers:?}");
        let unit = if name.ends_with("script") { 1000.0 } else { 1.0 };
        let moved = old_numbers.iter().zip(&new_numbers).take(3).map(|(a, b)| unit * (a - b).abs());
        assert!(moved.clone().all(|v| v < 50.0) && moved.sum::<f64>() > 0.1, "{name}: {new_numbers:?}");
        // a list of the same language has the same numbers
        let (answer, _, said) = real.compensate(name, &program, &["--json"]);
        let document: CompensationDocument = serde_json::from_slice(&answer).unwrap_or_else(|e| panic!("{e}: {said}"));
        let numbers: Vec<f64> = document.targets[0].command_xyz_mm.iter().map(|v| v / unit).collect();
        assert!(
            numbers.iter().zip(&new_numbers).all(|(a, b)| (a - b).abs() < 1e-9),
            "{name}: {numbers:?} {new_numbers:?}"
        );
        for t in &document.targets {
            assert!(t.residual_mm < 2e-6 && t.residual_deg < 1e-7, "{name}: {answer:?}");
        }
    }
    // what a program computes from a target is named
    let (name, program, _) = &irb120_programs()[0];
    assert!(real.compensate(name, program, &[]).2.says("warning[poses-computed-by-program] names=Offs"));
}

#[test]
fn g_code_keeps_its_modal_words() {
    let real = Real::new("samples/prexyt-cmm/robot.toml");
    let program = "%\nN10 G21 G90 (X9 Y9)\nG0 X200 Y150 C0 F100\nG1 X205.5 ; X1\n G1 Y155 Z-3\nC1.5\nM2\n%\n";
    let (new, code, said) = real.compensate("part.ngc", program.as_bytes(), &[]);
    assert_eq!(code, Some(0), "{said}");
    let new = text(&new);
    let lines: Vec<&str> = new.lines().collect();
    assert!(lines[..2] == ["%", "N10 G21 G90 (X9 Y9)"] && lines[6..] == ["M2", "%"], "{new}");
    assert!(lines[2].ends_with(" F100") && lines[3].ends_with(" ; X1") && lines[4].ends_with(" Z-3"), "{new}");
    let word = |line: &str, letter: char| -> f64 {
        line.split(' ').find_map(|w| w.strip_prefix(letter)).unwrap().parse().unwrap()
    };
    // block by block what a table of the same targets has
    let table = "pose,x_mm,y_mm,qw,qx,qy,qz\n1,200,150,1,0,0,0\n2,205.5,150,1,0,0,0\n3,205.5,155,1,0,0,0\n\
                 4,205.5,155,0.99991433160379,0,0,0.013089595571344\n";
    let document: CompensationDocument = serde_json::from_str(&real.table(table, &["--json"]).0).unwrap();
    for (line, t) in lines[2..6].iter().zip(&document.targets) {
        let angle = 2.0 * t.command_quaternion[3].atan2(t.command_quaternion[0]).to_degrees();
        for (letter, value) in [('X', t.command_xyz_mm[0]), ('Y', t.command_xyz_mm[1]), ('C', angle)] {
            assert!((word(line, letter) - value).abs() < 1e-6, "{line}: {letter} {value}");
        }
    }
    for (program, part) in [
        ("G21 G90\nG0 X200 Y150 C0\nG2 X1 Y1 I1 J1\n", "error[movement-not-compensated]: `G2`"),
        ("G20\nG0 X1 Y1 C0\n", "error[movement-not-compensated]: `G20`"),
        ("G91\nG0 X1 Y1 C0\n", "error[movement-not-compensated]: `G91`"),
        ("G0 X200 Y150\n", "error[coordinate-unknown]: `C`"),
        ("G0 X[#1+2] Y150 C0\n", "error[coordinate-not-number]: `X`"),
        ("G55 G0 X200 Y150 C0\n", "[program-frames]"),
        ("G0 X900 Y150 C0\n", "target line 1: rho1 = "),
    ] {
        let (new, code, said) = real.compensate("part.ngc", program.as_bytes(), &[]);
        assert!(code == Some(2) && new.is_empty() && said.says(part), "{program}: {said}");
    }
}

#[test]
fn programs_that_cannot_be_compensated_target_by_target_are_refused() {
    let real = Real::new("samples/abb-irb120/robot.toml");
    let target = "[[300,100,500],[0,0.6,0.8,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
    for (name, program, part) in [
        ("a.mod", format!("MoveL {target},v10,fine,tGrip;"), "uses `tGrip`"),
        (
            "a.mod",
            format!("MoveL {target},v10,fine,tool0\\WObj:=w1;\nMoveL {target},v10,fine,tool0\\WObj:=w2;"),
            "one program for each",
        ),
        ("a.mod", target.replace("0.6", "0.9"), "error[quaternion-length]"),
        ("a.src", "PTP {X 300}\n".to_owned(), "error[move-incomplete]"),
        ("a.src", "FOLD {TOOL_NO 3,BASE_NO 0}\nPTP {X 300,Y 0,Z 500,A 0,B 0,C 0}".to_owned(), "uses `TOOL_NO 3`"),
        ("a.src", format!("CIRC HELP, GOAL\n{KRL_TARGET}"), "error[movement-not-compensated] command=CIRC"),
        ("a.src", format!("{KRL_TARGET}\nscirc {{X 1}}, {{X 2}}"), "error[movement-not-compensated] command=scirc"),
        ("a.src", format!("{KRL_TARGET}\nLIN_REL {{Z 50}}"), "error[movement-not-compensated] command=LIN_REL"),
        ("a.src", format!("{KRL_TARGET}\nSPTP_REL {{A1 5}}"), "a.src:2"),
        ("a.src", format!("$TOOL={{Z 150}}\n{KRL_TARGET}"), "error[move-incomplete] command=$TOOL={Z 150}"),
        ("a.src", format!("$BASE = {{FRAME: Z 150}}\n{KRL_TARGET}"), "error[move-incomplete]"),
        ("a.src", format!("$TOOL=$NULLFRAME\n$TOOL.Z=150\n{KRL_TARGET}"), "error[move-incomplete] command=$TOOL.Z=150"),
        ("a.src", format!("$TOOL={{X 0,Y 0,Z 150,A 0,B 0,C 0}}\n{KRL_TARGET}"), "error[program-frames]"),
        ("a.src", format!("{KRL_TARGET}\n$TOOL=TOOL_DATA[3]\n{KRL_TARGET}\n$TOOL=$NULLFRAME"), "one program for each"),
        ("a.mod", format!("MoveC p1, {target},v10,fine,tool0;"), "error[movement-not-compensated] command=MoveC"),
        ("a.mod", format!("PROC main()\n IF a THEN movec\\Conc, p1, {target},v10,fine,tool0;"), "a.mod:2"),
        (
            "a.script",
            "movec(via, p[0.3,0.1,0.5,3.0,0.5,0])".to_owned(),
            "error[movement-not-compensated] command=movec",
        ),
        ("a.script", "set_tcp(p[0,0,0.1,0,0,0])\nmovel(p[0.3,0.1,0.5,3.0,0.5,0])".to_owned(), "uses `p[0,0,0.1"),
    ] {
        let (new, code, said) = real.compensate(name, program.as_bytes(), &[]);
        assert!(code == Some(2) && new.is_empty() && said.says(part), "{program}: {said}");
    }
    let tool = format!("MoveL {target},v10,fine,tGrip;");
    assert_eq!(real.compensate("a.mod", tool.as_bytes(), &["--tool", "0,0,-10"]).1, Some(0));
}

const KRL_TARGET: &str = "PTP {X 300,Y 100,Z 500,A 180,B 0,C -180}";

#[test]
fn a_tool_of_the_program_and_that_of_the_option_are_one() {
    let real = Real::new("samples/abb-irb120/robot.toml");
    let zero = "$TOOL={X 0,Y 0,Z 0,A 0,B 0,C 0}";
    let literal = "$TOOL = {FRAME: X 0,Y 0.0,Z -10,A 90,B 0,C 0}";
    let turned = ["--tool", "0,0,-10,0.70710678,0,0,0.70710678"];
    for (head, more) in [
        // zero, as a frame or in numbers, is the flange
        ("$TOOL=$NULLFRAME", &[][..]),
        (zero, &[]),
        (zero, &["--tool", "0,0,0"]),
        // initialised, then set
        ("$TOOL=$NULLFRAME\n$BASE=$NULLFRAME\n\n$TOOL=TOOL_DATA[3]", &["--tool", "0,0,-10"]),
        (literal, &turned),
        // a comment, a text and a name are no movement
        ("; CIRC LIN_REL\nDECL CHAR TEXT[8]\nTEXT[]=\"LIN_REL\"\nDECL INT CIRCLES", &[]),
        // $BASE is relative to a world, in which the robot may stand anywhere
        ("$BASE=$NULLFRAME", &["--object", "0,0,10"]),
    ] {
        let program = format!("{head}\n{KRL_TARGET}\n");
        let (new, code, said) = real.compensate("a.src", program.as_bytes(), more);
        assert!(code == Some(0) && text(&new).starts_with(head), "{program}: {said}");
    }
    for (head, more) in [
        (zero, &["--tool", "0,0,150"][..]),
        ("$TOOL=$NULLFRAME", &["--tool", "0,0,150"]),
        (literal, &["--tool", "0,0,-10"]),
        ("$TOOL={X 0,Y 0,Z -100,A 90,B 0,C 0}", &turned),
    ] {
        let program = format!("{head}\n{KRL_TARGET}\n");
        let (new, code, said) = real.compensate("a.src", program.as_bytes(), more);
        assert!(
            code == Some(2) && new.is_empty() && said.says("error[program-frame-other] option=tool"),
            "{program}: {said}"
        );
    }
    // the hint can be used as it is
    let hint = real.compensate("a.src", format!("{literal}\n{KRL_TARGET}\n").as_bytes(), &["--tool", "0,0,1"]).2;
    let pose = hint
        .lines()
        .filter(|line| line.starts_with("hint: "))
        .find_map(|line| line.rsplit_once("--tool "))
        .unwrap()
        .1
        .trim();
    let program = format!("{literal}\n{KRL_TARGET}\n");
    assert_eq!(real.compensate("a.src", program.as_bytes(), &["--tool", pose]).1, Some(0), "{hint}");
}

#[test]
fn tool_data_of_a_rapid_program_and_the_tool_of_the_option_are_one() {
    let real = Real::new("samples/abb-irb120/robot.toml");
    let program = |declared: &str| {
        format!(
            "MODULE Main\n  {declared}\n  PROC main()\n    MoveL [[300,100,500],[0,0.70710678,0,0.70710678],[0,0,0,0],\
             [9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]], v100, fine, tGrip;\n  ENDPROC\nENDMODULE\n"
        )
    };
    let load = "[1,[0,0,50],[1,0,0,0],0,0,0]";
    let ten = &["--tool", "0,0,10"][..];
    for (declared, more, passes) in [
        (format!("PERS tooldata tGrip:=[TRUE,[[0,0,10],[1,0,0,0]],{load}];"), ten, true),
        // names have no case, and other tools do not belong to the movement
        (format!("TASK PERS ToolData TGRIP := [ true, [[0,0,10],[1,0,0,0]], {load} ];"), ten, true),
        (format!("PERS tooldata tOther:=[TRUE,[[0,0,99],[1,0,0,0]],{load}];"), ten, true),
        (format!("PERS tooldata tGrip:=[TRUE,[[0,0,0],[1,0,0,0]],{load}];"), &[], true),
        // a tool that stands beside the robot has another meaning
        (format!("PERS tooldata tGrip:=[FALSE,[[0,0,99],[1,0,0,0]],{load}];"), ten, true),
        (format!("PERS tooldata tGrip:=[TRUE,[[0,0,100],[1,0,0,0]],{load}];"), ten, false),
        (format!("PERS tooldata tGrip:=[TRUE,[[0,0,10],[0,1,0,0]],{load}];"), ten, false),
    ] {
        let text = program(&declared);
        let (new, code, said) = real.compensate("a.mod", text.as_bytes(), more);
        match passes {
            true => assert!(code == Some(0) && !new.is_empty(), "{text}: {said}"),
            false => assert!(code == Some(2) && said.says("error[program-frame-other] option=tool"), "{text}: {said}"),
        }
    }
}

#[test]
fn programs_of_synthetic_parameters_say_so() {
    let real = Real::new("samples/abb-irb120/robot.toml");
    let (main, program, _) = &irb120_programs()[1];
    let (measured, ..) = real.compensate(main, program, &[]);
    let found = std::fs::read_to_string(&real.parameters).unwrap();
    let mut document: serde_json::Value = serde_json::from_str(&found).unwrap();
    document["synthetic"] = "made with seed 7".into();
    std::fs::write(&real.parameters, document.to_string()).unwrap();
    let (synthetic, ..) = real.compensate(main, program, &[]);
    let line = "; SYNTHETIC DATA, not of a measured robot: made with seed 7\r\n";
    let latin = |bytes: &[u8]| bytes.iter().map(|&b| b as char).collect::<String>();
    // after the line that KRL requires first; nothing else differs
    assert!(latin(&synthetic).starts_with(&format!("&ACCESS RVP\r\n{line}DEF main()")), "{}", latin(&synthetic));
    assert_eq!(latin(&synthetic).replace(line, ""), latin(&measured));
    let (list, ..) = real.compensate(main, program, &["--format", "rapid"]);
    assert!(
        text(&list).lines().any(|l| l == "! SYNTHETIC DATA, not of a measured robot: made with seed 7"),
        "{}",
        text(&list)
    );
    assert!(!latin(&measured).contains("SYNTHETIC"));
}

/// A five-bar and a PreXYT: every byte but the numbers of the targets stays, and these equal the numbers of a table of the same targets.
#[test]
fn programs_of_mecaprol_and_galil_have_other_targets_alone() {
    let five_bar = Real::new("samples/dextar/robot.toml");
    let program = b"! MoveC X1 Y2; gr\xfcn\r\nSTART;\r\nCFGLIN V150.0 A150.0;\r\nTCS Z-42.5; ! pen\r\nMoveC X40.00 Y330 S100 M1;\r\nMoveZ Z2.0;\r\n\
                    MoveJ A0.0 B0.0;\r\n MoveC X-60. Y+300.25\r\nOutput ON;\r\nEND;\r\n";
    let start = ["--start", "110,70,1"];
    let (new, code, said) = five_bar.compensate("face.mp", program, &start);
    assert!(code == Some(0) && has(&said, &phrase!("targets-compensated", count = 2, left = 1)), "{said}");
    let table = "pose,x_mm,y_mm,theta1_deg,theta2_deg,assembly\n1,40,330,110,70,1\n2,-60,300.25,110,70,1\n";
    let document: CompensationDocument = serde_json::from_str(&five_bar.table(table, &["--json"]).0).unwrap();
    let xy = |i: usize| document.targets[i].command_xyz_mm.map(|v| format!("{v:.6}").trim_end_matches('0').to_owned());
    let bytes = |text: &str| text.chars().map(|c| c as u8).collect::<Vec<u8>>();
    let old: String = program.iter().map(|&b| b as char).collect();
    let expected = old.replace("X40.00 Y330 ", &format!("X{} Y{} ", xy(0)[0], xy(0)[1]));
    let expected = expected.replace("X-60. Y+300.25", &format!("X{} Y{}", xy(1)[0], xy(1)[1]));
    assert_eq!(new, bytes(&expected), "{}", String::from_utf8_lossy(&new));
    for (program, more, part) in [
        ("MoveC X40 Y330;", &[][..], "--start"),
        ("MoveC X40;", &start, "error[move-incomplete]"),
        ("WCS X20 Y60 Z0 W0;\nMoveC X40 Y330;", &start, "uses `WCS X20 Y60 Z0 W0`"),
        ("MoveC X40 Y330 M1;\nMoveC X40 Y330 M2;", &start, "error[working-mode-changes]"),
        ("MoveC X4000 Y330;", &start, "[target-unreachable] reason=out of reach"),
    ] {
        let (new, code, said) = five_bar.compensate("face.mp", program.as_bytes(), more);
        assert!(code == Some(2) && new.is_empty() && said.says(part), "{program}: {said}");
    }
    let object = [&start[..], &["--object", "20,60,0"]].concat();
    let (new, code, said) = five_bar.compensate("face.mp", b"WCS X20 Y60 Z0 W0;\nMoveC X20 Y270;\n", &object);
    let expected = format!("WCS X20 Y60 Z0 W0;\nMoveC X{:.3}", document.targets[0].command_xyz_mm[0] - 20.0);
    assert!(code == Some(0) && text(&new).starts_with(&expected), "{said}{}", text(&new));

    let table = Real::new("samples/prexyt-cmm/robot.toml");
    let counts = ["--counts-per-unit", "1000,-2000,500"];
    let program = "REM PA 1,2,3\n#PAGE\nPALLET=4;' PA 7,7,7\nSP 1000,1000,1000;PA 100000, -200000,+52000;BGABC;AM\n PA 90000,-220000,56000\nEN\n";
    let (new, code, said) = table.compensate("table.dmc", program.as_bytes(), &counts);
    assert!(code == Some(0) && said.contains("2 targets compensated"), "{said}");
    let rows = "pose,rho1_mm,rho2_mm,rho3_mm\n1,100,100,104\n2,90,110,112\n";
    let document: CompensationDocument = serde_json::from_str(&table.table(rows, &["--json"]).0).unwrap();
    let n = |i: usize| -> Vec<String> {
        let all = document.targets[i].joints.iter().zip([1000.0, -2000.0, 500.0]);
        all.map(|(q, counts)| format!("{}", (q * counts).round())).collect()
    };
    let expected = program.replace("100000, -200000,+52000", &format!("{}, {},{}", n(0)[0], n(0)[1], n(0)[2]));
    let expected = expected.replace("90000,-220000,56000", &n(1).join(","));
    assert_eq!(text(&new), expected);
    for (program, part) in [
        ("PA 100000,-200000\n", "error[move-incomplete]"),
        ("PA AX,AY,AZ\n", "error[move-incomplete]"),
        ("PAX=100\n", "error[move-incomplete]"),
        ("PA 1000,-2000,500;PR 1,1,1\n", "error[movement-not-compensated]: `PR 1,1,1`"),
        ("PA 900000000,-200000,52000\n", "target line 1: "),
    ] {
        let (new, code, said) = table.compensate("table.dmc", program.as_bytes(), &counts);
        assert!(code == Some(2) && new.is_empty() && said.says(part), "{program}: {said}");
    }
    assert!(table.compensate("table.dmc", b"PA 1,2,3\n", &[]).2.contains("--counts-per-unit"));
}

/// Configuration data hold quarter turns of joint 1: where its correction leads over the border, the configuration is another.
#[test]
fn a_command_in_another_configuration_is_named() {
    let real = Real::new("samples/abb-irb120/robot.toml");
    let robot = read_robot(&real.robot).unwrap().build(&["tool".to_owned()]).unwrap();
    let arm = robot.kinematics().unwrap();
    let mut codes = Vec::new();
    for (q1, quarter) in [(89.999f64, 0), (90.001, 1)] {
        let q = [q1, 20.0, -10.0, 30.0, 60.0, 20.0].map(f64::to_radians);
        let pose = arm.tool_pose(&arm.nominal(), &q).unwrap();
        let ([x, y, z], [w, a, b, c]) = (pose.translation_mm, pose.quaternion());
        let target = format!("[[{x},{y},{z}],[{w},{a},{b},{c}],[{quarter},0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
        let (_, code, said) = real.compensate("a.mod", format!("MoveL {target},v10,fine,tool0;").as_bytes(), &[]);
        assert_eq!(code == Some(2), said.contains("error[configuration-changed]"), "{said}");
        codes.push(code);
    }
    // the correction of joint 1 has one sign
    codes.sort();
    assert_eq!(codes, [Some(0), Some(2)]);
}

/// A locale with a decimal comma changes no file.
#[test]
fn numbers_have_a_point_in_every_locale() {
    let real = Real::new("samples/prexyt-cmm/robot.toml");
    let robot = real.robot.display().to_string();
    let written = |locale: &str| {
        let to = real.scratch.path().join(locale);
        let mut command = std::process::Command::new(crate::support::program());
        command.args(["export", &real.parameters, "--robot", &robot, "--to"]).arg(&to);
        let formats = ["csv", "json", "matlab", "galil", "structured-text", "c-kinematics"];
        formats.iter().for_each(|format| _ = command.args(["--format", format]));
        let output = command.env("LC_ALL", locale).env("LANG", locale).output().unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
        let mut files: Vec<PathBuf> = std::fs::read_dir(to).unwrap().map(|e| e.unwrap().path()).collect();
        files.sort();
        files.iter().map(|file| std::fs::read(file).unwrap()).collect::<Vec<_>>()
    };
    let written_in_c = written("C");
    assert!(written_in_c.len() == 6 && written_in_c == written("de_DE.UTF-8"));
}

#[test]
fn counts_and_lists() {
    let real = Real::new("samples/prexyt-cmm/robot.toml");
    let table = "pose,x_mm,y_mm,qw,qx,qy,qz\n1,200,150,1,0,0,0\n";
    let (list, code, said) = real.table(table, &["--format", "galil", "--counts-per-unit", "1000,-1000,500"]);
    assert_eq!(code, Some(0), "{said}");
    let document: CompensationDocument = serde_json::from_str(&real.table(table, &["--json"]).0).unwrap();
    let j = &document.targets[0].joints;
    let counts = format!("PA {:.0},{:.0},{:.0};BG ABC;AM ABC\n", j[0] * 1000.0, j[1] * -1000.0, j[2] * 500.0);
    assert!(list.starts_with("REM Written by etalon ") && list.contains(&counts) && list.ends_with("EN\n"), "{list}");
    // its residual is that of whole counts
    let rounded = real.table(table, &["--format", "galil", "--counts-per-unit", "10,10,10", "--json"]).0;
    let document: CompensationDocument = serde_json::from_str(&rounded).unwrap();
    let off = document.targets[0].residual_mm;
    assert!(off > 1e-3 && off < 0.2, "{off}");
    let (joints, code, _) = real.table(table, &["--format", "joints"]);
    assert!(code == Some(0) && joints.starts_with("pose,rho1_mm,rho2_mm,rho3_mm,residual_mm,"), "{joints}");
    // fewer decimals have a residual
    let (coarse, ..) = real.table(table, &["--format", "gcode", "--decimals", "2", "--json"]);
    let document: CompensationDocument = serde_json::from_str(&coarse).unwrap();
    assert!(document.targets[0].residual_mm > 1e-4, "{coarse}");
    let five_bar = Real::new("samples/dextar/robot.toml");
    let table = "pose,x_mm,y_mm,theta1_deg,theta2_deg,assembly\n1,40,330,110,70,1\n";
    let (list, code, said) = five_bar.table(table, &["--format", "mecaprol"]);
    assert!(code == Some(0) && list.contains("\nMoveC X") && list.ends_with("; ! 1\nEND;\n"), "{said}{list}");
}

#[test]
fn parameters_that_failed_their_checks_compensate_nothing() {
    let real = Real::new("samples/prexyt-cmm/robot.toml");
    let bad = std::fs::read_to_string(&real.parameters).unwrap().replace("step_vanished", "lost_patience");
    std::fs::write(&real.parameters, bad).unwrap();
    let (_, code, said) = real.table("pose,x_mm,y_mm,qw,qx,qy,qz\n1,200,150,1,0,0,0\n", &[]);
    assert!(code == Some(2) && said.says("error[parameters-not-converged]"), "{said}");
}

/// At B = ±90 deg, where A and C have one effect, the commanded angles have the orientation of the pose.
#[test]
fn angles_at_a_right_angle_of_pitch_are_those_of_the_pose() {
    use etalon::controllers::commands::{DECIMALS, Freedoms, language, stated, written};
    use std::f64::consts::FRAC_PI_2;
    for (name, language) in ["krl", "gcode"].map(|name| language(name).unwrap()) {
        for (k, pitch) in [(1.0, FRAC_PI_2), (2.0, FRAC_PI_2), (1.5, -FRAC_PI_2), (-1.0, -FRAC_PI_2)] {
            // the pose is a product with rounding errors, as after a compensation
            let frame = Pose::from_xyz_rpy([10.0, 20.0, 30.0], [0.7 * k, -0.4, 0.3 * k]);
            let pose = Pose::from_xyz_rpy([500.0, -200.0, 700.0], [0.4, pitch, -1.1 * k]);
            let pose = frame.inverse().then(&frame.then(&pose));
            let back = stated(language, &written(language, &pose, Freedoms::Space, DECIMALS), Freedoms::Space);
            assert!(pose.inverse().then(&back).angle_rad() < 1e-7, "{name} {k} {pitch}");
        }
    }
}

/// At a wrist singularity a small correction may need long motions of joints 4 and 6: such a command is an error by name, and no
/// answer leaves the joints of its row in silence.
#[test]
fn commands_at_wrist_singularities_keep_the_configuration_or_are_errors() {
    let real = Real::new("docs/keys/robot-serial-dh.toml");
    let mut noise = etalon::base::noise::Noise::new(59, 3);
    let mut stated = Vec::new();
    let mut table = "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n".to_owned();
    for k in 0..12 {
        let mut q = [20.0, -70.0, 60.0, -50.0, 0.0, 30.0].map(|v| v + noise.uniform(15.0));
        // half of the rows are away from the singularity
        q[4] = if k % 2 == 0 { 0.0 } else { 40.0 };
        table += &format!("{k},{}\n", q.map(|v| format!("{v:?}")).join(","));
        stated.push(q);
    }
    let (answer, code, said) = real.table(&table, &["--json"]);
    let document: CompensationDocument = serde_json::from_str(&answer).unwrap();
    assert_eq!(document.targets.len(), stated.len(), "{said}");
    for (k, (t, stated)) in document.targets.iter().zip(&stated).enumerate() {
        let moved = t.joints.iter().zip(stated).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert_eq!(t.same_configuration, moved <= 0.5f64.to_degrees(), "{k}: {moved} deg {:?}", t.joints);
        assert!(k % 2 == 0 || t.same_configuration, "{k}: {said}");
    }
    let changed = document.targets.iter().any(|t| !t.same_configuration);
    assert_eq!(code, Some(if changed { 1 } else { 0 }), "{said}");
    assert!(changed && said.contains("error[configuration-changed]"), "{said}");
}
