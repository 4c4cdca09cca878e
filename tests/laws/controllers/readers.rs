//! Readers of this test for every controller format: the error of the robot that a file describes.

use super::files::File;
use crate::support::controller_files::{
    Towers, five_bar, galil_prexyt, genhexkins, genserkins, lineardeltakins, rotarydeltakins, universal_robots,
};
use crate::support::root;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::documents::PoseSet;
use etalon::identify::Observation;
use etalon::math::statistics::rms;
use etalon::robots::{Quantity, base_pose};
use etalon::stages::evaluate::errors::point_errors;
use std::collections::BTreeMap;
use std::io::Write as _;
use std::process::{Command, Stdio};

/// Largest differences of joint values (mm or rad) that rounding leaves: of all digits, and of six decimals.
const ALL_DIGITS: f64 = 1e-8;
const SIX_DECIMALS: f64 = 1e-4;

/// Errors (mm) of the robot that a file describes, one for each way to read it: its list of parameters and its program. Empty where the
/// reader's program is not installed.
pub fn read_back(format: &str, file: &File) -> Vec<f64> {
    let found = match format {
        "json" | "csv" | "c-header" | "matlab" | "python" => vec![Some(file.rms_of_list(&list(format, file)))],
        "numpy" | "mat" | "dcc" | "qif" | "twincat" => vec![by_script(format, file)],
        "galil" => vec![by_script(format, file), galil(file)],
        "plcopen" | "siemens-scl" => vec![by_script(format, file), structured_text(file)],
        "structured-text" => vec![structured_text(file)],
        "universal-robots" => {
            vec![Some(file.rms_of_flange(|q| universal_robots(&file.text(), q)))]
        }
        "linuxcnc" => vec![Some(file.rms_of_flange(|q| genserkins(&file.text(), q)))],
        "linuxcnc-hexapod" => vec![Some(by_inverse(file, ALL_DIGITS, |pose| genhexkins(&file.text(), pose)))],
        "linuxcnc-component" => vec![component(file)],
        "linuxcnc-delta" if file.ran.robot.model() == "delta" => {
            vec![Some(by_inverse(file, ALL_DIGITS, |pose| rotarydeltakins(&file.text(), pose.translation_mm)))]
        }
        "linuxcnc-delta" => {
            vec![Some(by_inverse(file, ALL_DIGITS, |pose| lineardeltakins(&file.text(), pose.translation_mm)))]
        }
        "klipper-delta" | "reprap-delta" => {
            let text = file.text();
            let towers = if format == "klipper-delta" { Towers::klipper(&text) } else { Towers::reprap(&text) };
            vec![Some(by_inverse(file, SIX_DECIMALS, |pose| towers.joints(pose.translation_mm)))]
        }
        // the firmware has one assembly mode; its links are read in that of each measurement
        "reprap-five-bar" => vec![Some(file.rms(|o, _| five_bar(&file.text(), &o.joints, o.joints[2])))],
        "urdf" => vec![urdf(file)],
        "c-kinematics" => vec![c_code(file)],
        "python-kinematics" => vec![python_code(file)],
        _ => panic!("no reader of {format}"),
    };
    found.into_iter().flatten().collect()
}

/// `true` if a program is installed.
fn is_installed(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok()
}

fn support(script: &str) -> std::path::PathBuf {
    root().join("tests/support").join(script)
}

impl File<'_> {
    fn validation(&self) -> &[Observation] {
        &self.ran.solution().sets.validation
    }

    /// Root mean square error of the positions that a reader of the file gives.
    fn rms(&self, position: impl Fn(&Observation, usize) -> Vector) -> f64 {
        let mut errors = Vec::new();
        for o in self.validation() {
            let seen = o.targets.iter().enumerate().filter_map(|(k, measured)| Some((position(o, k), (*measured)?)));
            let (read, measured): (Vec<Vector>, Vec<Vector>) = seen.unzip();
            match (self.ran.robot.model(), &read[..], &measured[..]) {
                // errors of a table are errors of its centre, by both balls
                ("prexyt", &[k, l], &[of_k, of_l]) => errors.push(minus(self.centre(k, l), self.centre(of_k, of_l))),
                _ => errors.extend(read.iter().zip(&measured).map(|(read, measured)| minus(*read, *measured))),
            }
        }
        rms(errors.into_iter().map(norm))
    }

    fn target(&self, k: usize) -> Vector {
        let first = self.ran.robot.free_base().unwrap().target_place(k);
        [0, 1, 2].map(|i| self.values[first + i])
    }

    /// The world position of a target on a flange whose pose in the base is known.
    fn in_world(&self, flange: &Pose, k: usize) -> Vector {
        base_pose(&self.values).then(flange).apply(self.target(k))
    }

    /// Error of a robot whose flange in the base is known at joint values.
    fn rms_of_flange(&self, flange: impl Fn(&[f64]) -> Pose) -> f64 {
        self.rms(|o, k| self.in_world(&flange(&o.joints), k))
    }

    /// Place of a target in the world by the outputs of code in the base: of planar robots x, y (and angle), of others a pose.
    fn by_outputs(&self, outputs: &[f64], k: usize) -> Vector {
        let value = |name: &str| self.values[self.ran.robot.index(name).unwrap()];
        match self.ran.robot.model() {
            // thesis, eq. 4.21
            "five_bar" => {
                let (sin, cos) = value("phi").sin_cos();
                let [x, y] = [outputs[0], outputs[1]];
                [value("x_o") + cos * x - sin * y, value("y_o") + sin * x + cos * y, 0.0]
            }
            // thesis, eq. 3.17 and 3.19
            "prexyt" => {
                let c = outputs[2] + value("epsilon_theta");
                let (x_c, y_c) = (value("x_c"), value("y_c"));
                let k_x = outputs[0] + value("x_o") - (x_c * c.cos() - y_c * c.sin());
                let k_y = outputs[1] + value("y_o") - (x_c * c.sin() + y_c * c.cos());
                self.ball([k_x, k_y], c, k)
            }
            _ => self.in_world(&pose(outputs), k),
        }
    }

    /// Centre of a PreXYT's platform by its balls K and L (thesis, eq. 3.17 to 3.19).
    fn centre(&self, [x, y, _]: Vector, l: Vector) -> Vector {
        let (sin, cos) = (l[1] - y).atan2(l[0] - x).sin_cos();
        let [x_c, y_c] = ["x_c", "y_c"].map(|name| self.values[self.ran.robot.index(name).unwrap()]);
        [x + cos * x_c - sin * y_c, y + sin * x_c + cos * y_c, 0.0]
    }

    /// Ball K of a PreXYT, or L in direction `c` from it.
    fn ball(&self, [x, y]: [f64; 2], c: f64, k: usize) -> Vector {
        let from = k as f64 * self.values[self.ran.robot.index("l_kl").unwrap()];
        [x + from * c.cos(), y + from * c.sin(), 0.0]
    }

    /// Error of the robot with values that the file lists by name, in their units.
    fn rms_of_list(&self, list: &BTreeMap<String, f64>) -> f64 {
        let robot = self.ran.robot.as_ref();
        let value = |p: &etalon::robots::Parameter| p.quantity.inward(list[&p.name]);
        let values: Vec<f64> = robot.parameters().iter().map(value).collect();
        let solution = self.ran.solution();
        let errors = point_errors(robot, &solution.sets, &solution.again.before, &values);
        rms(errors.iter().filter(|e| e.set == PoseSet::Validation).map(|e| norm(e.after_mm)))
    }

    /// Error of a robot by a program that answers a line of numbers for each observation; `None` if it does not start.
    fn rms_of_program(
        &self,
        command: &mut Command,
        line: impl Fn(&Observation) -> String,
        place: impl Fn(&[f64], usize) -> Vector,
    ) -> Option<f64> {
        let input: String = self.validation().iter().map(|o| line(o) + "\n").collect();
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().ok()?;
        let mut to = child.stdin.take().unwrap();
        let writer = std::thread::spawn(move || to.write_all(input.as_bytes()));
        let output = child.wait_with_output().unwrap();
        writer.join().unwrap().unwrap();
        assert!(output.status.success(), "{}: {command:?}", self.ran.name);
        let text = String::from_utf8(output.stdout).unwrap();
        let answers: Vec<Vec<f64>> =
            text.lines().map(|line| line.split(' ').filter_map(|v| v.parse().ok()).collect()).collect();
        assert_eq!(answers.len(), self.validation().len());
        let of = |o: &Observation| &answers[self.validation().iter().position(|other| std::ptr::eq(other, o)).unwrap()];
        // nothing is answered where a program finds no pose
        Some(self.rms(|o, k| if of(o).is_empty() { [f64::NAN; 3] } else { place(of(o), k) }))
    }
}

/// Numbers between blanks.
fn numbers(values: &[f64]) -> String {
    values.iter().map(|v| format!("{v:?} ")).collect()
}

/// A pose by its place and rotation row by row; a delta does not turn.
fn pose(v: &[f64]) -> Pose {
    let rotation = if v.len() < 12 {
        Pose::identity().rotation
    } else {
        [[v[3], v[4], v[5]], [v[6], v[7], v[8]], [v[9], v[10], v[11]]]
    };
    Pose { rotation, translation_mm: [v[0], v[1], v[2]] }
}

/// Parameters of a list in a text, by name.
fn list(format: &str, file: &File) -> BTreeMap<String, f64> {
    let (text, robot) = (file.text(), file.ran.robot.as_ref());
    let number = |text: &str| text.split([',', '(', ')', ' ']).find(|v| !v.is_empty()).unwrap().parse::<f64>().unwrap();
    let after = |key: String| {
        let rest = text.split_once(&key).unwrap_or_else(|| panic!("{key}: {text}")).1;
        number(rest.lines().next().unwrap())
    };
    let value = |p: &etalon::robots::Parameter| match format {
        "json" => {
            let document: serde_json::Value = serde_json::from_str(&text).unwrap();
            document["parameters"][&p.name]["value"].as_f64().unwrap()
        }
        "csv" => {
            let row = text.lines().find(|line| line.starts_with(&format!("{},", p.name))).unwrap();
            row.split(',').nth(3).unwrap().parse().unwrap()
        }
        "matlab" => after(format!("p.{} = struct('value', ", p.name)),
        "python" => after(format!("\"{}\": (", p.name)),
        _ => {
            let unit = match p.quantity {
                Quantity::Length => "MM",
                Quantity::Angle => "DEG",
                Quantity::Ratio => "RATIO",
            };
            after(format!("#define ETALON_{}_{}_{unit} ", robot.model().to_uppercase(), p.name.to_uppercase()))
        }
    };
    robot.parameters().iter().map(|p| (p.name.clone(), value(p))).collect()
}

/// Parameters that a script in Python lists.
fn by_script(format: &str, file: &File) -> Option<f64> {
    let mut command = Command::new("python3");
    let command = command.arg("-B").arg(support("parameter_lists.py")).args([format, &file.write()]);
    let output = command.current_dir(file.ran.scratch.root()).output().ok()?;
    assert!(output.status.success(), "{format}: {}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let all: BTreeMap<String, f64> = text
        .lines()
        .map(|line| line.split_once('\t').unwrap())
        .map(|(name, value)| (name.to_lowercase(), value.parse().unwrap()))
        .collect();
    let own = |p: &etalon::robots::Parameter| (p.name.clone(), all[&p.name.to_lowercase()]);
    let parameters = file.ran.robot.parameters();
    assert_eq!(all.len(), parameters.len(), "{format}: {text}");
    Some(file.rms_of_list(&parameters.iter().map(own).collect()))
}

/// Inputs of code for the direct kinematics: joint values and assembly mode; of a hexapod a pose behind them from which it is looked for.
fn inputs(file: &File, o: &Observation) -> String {
    let start = [0.0, 0.0, 400.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    let hexapod = file.ran.robot.model() == "hexapod";
    numbers(&o.joints[..file.coded()]) + &numbers(if hexapod { &start } else { &[] })
}

/// The function block for the direct kinematics, interpreted.
fn structured_text(file: &File) -> Option<f64> {
    let mut command = Command::new("python3");
    let command = command.arg("-B").arg(support("structured_text.py")).args([&file.write(), "FB_EtalonDirect"]);
    let command = command.current_dir(file.ran.scratch.root());
    file.rms_of_program(command, |o| inputs(file, o), |out, k| file.by_outputs(out, k))
}

/// The inverse kinematics of a PreXYT in a program; `None` for other robots.
fn galil(file: &File) -> Option<f64> {
    let planar = |pose: &Pose| {
        let ([x, y, _], r) = (pose.translation_mm, pose.rotation);
        galil_prexyt(&file.text(), [x, y, r[1][0].atan2(r[0][0])], true).unwrap()
    };
    (file.ran.robot.model() == "prexyt").then(|| by_inverse(file, SIX_DECIMALS, planar))
}

/// The C code, compiled; `None` without a compiler.
fn c_code(file: &File) -> Option<f64> {
    let (inputs_of, hexapod) = (file.coded(), file.ran.robot.model() == "hexapod");
    let (read, call) = match hexapod {
        true => (
            18,
            "if (!etalon_direct(in, in + 6)) { printf(\"\\n\"); continue; } for (i = 0; i < 12; i++) out[i] = in[6 + i];",
        ),
        false => (inputs_of, "etalon_direct(in, out);"),
    };
    // a delta moves its platform without turning it
    let outputs = match file.ran.robot.model() {
        "five_bar" => 2,
        "delta" | "delta_linear" | "prexyt" => 3,
        _ => 12,
    };
    let main = format!(
        "#include \"etalon_kinematics.c\"\n#include <stdio.h>\nint main(void) {{ double in[64] = {{0}}, out[12] = {{0}}; int i;\n\
         for (;;) {{ for (i = 0; i < {read}; i++) if (scanf(\"%lf\", in + i) != 1) return 0;\n{call}\n\
         for (i = 0; i < {outputs}; i++) printf(\"%.17g \", out[i]);\nprintf(\"\\n\"); }}\n}}\n"
    );
    let mut program = compiled(file, &[("main.c", &main)])?;
    file.rms_of_program(&mut program, |o| inputs(file, o), |out, k| file.by_outputs(out, k))
}

/// The program of a file beside these sources in C, of which the first is compiled; `None` without a compiler.
fn compiled(file: &File, sources: &[(&str, &str)]) -> Option<Command> {
    if !is_installed("cc") {
        return None;
    }
    file.write();
    let folder = file.ran.scratch.root();
    for (name, text) in sources {
        std::fs::write(folder.join(name), text).unwrap();
    }
    let flags = ["-std=c99", "-D_GNU_SOURCE", "-O1", "-I.", "-o", "program", sources[0].0, "-lm"];
    assert!(Command::new("cc").args(flags).current_dir(folder).status().unwrap().success(), "{}", file.ran.name);
    Some(Command::new(folder.join("program")))
}

/// LinuxCNC's own names, as far as a component uses them.
const KINEMATICS_H: &str = "typedef struct { struct { double x, y, z; } tran; double a, b, c, u, v, w; } EmcPose;\n\
    typedef unsigned long KINEMATICS_FORWARD_FLAGS, KINEMATICS_INVERSE_FLAGS;\n\
    typedef enum { KINEMATICS_IDENTITY = 1, KINEMATICS_FORWARD_ONLY, KINEMATICS_INVERSE_ONLY, KINEMATICS_BOTH } KINEMATICS_TYPE;\n\
    #define EXPORT_SYMBOL(name) extern int etalon_unused\n#define KINS_NOT_SWITCHABLE\n";

/// A kinematics component as halcompile builds it: declarations before `;;` become variables, C code follows. World positions are x, y, z
/// and c, b, a (deg) about z, y, x: of a planar robot of its tool or ball K, of an arm of its flange in the base.
fn component(file: &File) -> Option<f64> {
    let text = file.text();
    let (declared, code) = text.split_once("\n;;\n").unwrap();
    let mode = |line: &str| Some(line.strip_prefix("modparam int ")?.split_once(" \"")?.0.to_owned());
    let modes: Vec<String> = declared.lines().filter_map(mode).collect();
    let assembly = modes.iter().any(|mode| mode.starts_with("assembly "));
    let robot = file.ran.robot.as_ref();
    let joints = robot.joints().len();
    let variables: String = modes.iter().map(|mode| format!("static int {mode};\n")).collect();
    let scan = if assembly { "if (scanf(\"%d\", &assembly) != 1) return 0;" } else { "" };
    let main = format!(
        "{variables}{code}\n#include <stdio.h>\nint main(void) {{ double q[9] = {{0}}; EmcPose p = {{{{0}}}}; int i;\n\
         for (;;) {{ for (i = 0; i < {joints}; i++) if (scanf(\"%lf\", q + i) != 1) return 0;\n{scan}\n\
         if (kinematicsForward(q, &p, 0, 0)) {{ printf(\"\\n\"); continue; }}\n\
         printf(\"%.17g %.17g %.17g %.17g %.17g %.17g\\n\", p.tran.x, p.tran.y, p.tran.z, p.a, p.b, p.c); }}\n}}\n"
    );
    let headers = [("main.c", main.as_str()), ("rtapi_math.h", "#include <math.h>\n"), ("kinematics.h", KINEMATICS_H)];
    let mut program = compiled(file, &headers)?;
    let line = |o: &Observation| {
        let outward: Vec<f64> = robot.joints().iter().zip(&o.joints).map(|(j, q)| j.quantity.outward(*q)).collect();
        numbers(&outward) + &if assembly { format!("{}", o.joints[joints] as i32) } else { String::new() }
    };
    let place = |p: &[f64], k: usize| match robot.model() {
        "five_bar" => [p[0], p[1], 0.0],
        "prexyt" => file.ball([p[0], p[1]], p[5].to_radians(), k),
        _ => file.in_world(&Pose::from_xyz_rpy([p[0], p[1], p[2]], [p[3], p[4], p[5]].map(f64::to_radians)), k),
    };
    file.rms_of_program(&mut program, line, place)
}

/// The Python code; `None` without Python.
fn python_code(file: &File) -> Option<f64> {
    file.write();
    let direct = if file.ran.robot.model() == "hexapod" { "v[:6], v[6:]" } else { "v" };
    let script = format!(
        "import sys, etalon_kinematics as e\nfor line in sys.stdin:\n  v = [float(x) for x in line.split()]\n  print(*map(repr, e.direct({direct}) or []))"
    );
    let mut command = Command::new("python3");
    let command = command.args(["-B", "-c", &script]).current_dir(file.ran.scratch.root());
    file.rms_of_program(command, |o| inputs(file, o), |out, k| file.by_outputs(out, k))
}

/// The stated error if the file's joints at the platform's poses follow from its values; otherwise not a number.
fn by_inverse(file: &File, within: f64, joints: impl Fn(&Pose) -> Vec<f64>) -> f64 {
    let arm = file.ran.robot.kinematics().unwrap();
    let same = |o: &Observation| {
        let pose = arm.tool_pose(&file.values, &o.joints).unwrap();
        joints(&pose).iter().zip(&o.joints).all(|(a, b)| (a - b).abs() < within)
    };
    if file.validation().iter().all(same) {
        file.rms(|o, k| arm.position(&file.values, &o.joints, k))
    } else {
        f64::NAN
    }
}

/// The URDF by its specification.
fn urdf(file: &File) -> Option<f64> {
    let robot = file.ran.robot.as_ref();
    let mut command = Command::new("python3");
    let command = command.arg("-B").arg(support("urdf_direct.py")).args([&file.write(), "base_link", "tool"]);
    let line = |o: &Observation| {
        let value = |(joint, q): (&etalon::robots::Joint, &f64)| {
            let metres = joint.quantity == Quantity::Length;
            (joint.name.clone(), serde_json::Value::from(if metres { q / 1000.0 } else { *q }))
        };
        serde_json::Value::Object(robot.joints().iter().zip(&o.joints).map(value).collect()).to_string()
    };
    let command = command.current_dir(file.ran.scratch.root());
    file.rms_of_program(command, line, |out, k| file.in_world(&pose(out), k))
}
