//! The model as code: what a C compiler, Python and an interpreter of Structured Text make of the exported kinematics is what the program
//! computes.

use super::controllers::{disturbed, etalon, parameters};
use crate::support::controller_files::galil_prexyt;
use crate::support::root;
use crate::support::scratch::Scratch;
use etalon::base::noise::Noise;
use etalon::base::pose::Pose;
use etalon::campaign::read_robot;
use etalon::robots::{Kinematics, Quantity, Robot};
use std::io::Write;
use std::process::{Command, Stdio};

const POSES: usize = 10_000;

/// A robot that a calibration found, and its kinematics in a language.
struct Exported {
    robot: Box<dyn Robot>,
    values: Vec<f64>,
    scratch: Scratch,
}

impl Exported {
    fn new(robot: &str, format: &str) -> Self {
        let file = root().join(robot);
        let robot = read_robot(&file).unwrap().build(&["tool".to_owned()]).unwrap();
        let mut values = disturbed(robot.as_ref(), &["gain_1", "gain_5", "gain_elbow"]);
        for (value, p) in values.iter_mut().zip(robot.parameters()) {
            *value += if p.name.starts_with("compliance") || p.name.starts_with("coupling") { 3e-4 } else { 0.0 };
        }
        let scratch = Scratch::with(&[]);
        let found = parameters(&scratch, robot.as_ref(), &values);
        let (file, to) = (file.display().to_string(), scratch.path().display().to_string());
        let (code, said) = etalon(&["export", &found, "--format", format, "--robot", &file, "--to", &to]);
        assert_eq!(code, Some(0), "{said}");
        Self { robot, values, scratch }
    }

    fn arm(&self) -> &dyn Kinematics {
        self.robot.kinematics().unwrap()
    }

    fn text(&self, name: &str) -> String {
        std::fs::read_to_string(self.scratch.path().join(name)).unwrap()
    }

    /// A platform whose legs are its joints.
    fn parallel(&self) -> bool {
        ["hexapod", "delta", "delta_linear"].contains(&self.robot.model())
    }

    /// Inputs of `direct`, which are joint values and an assembly mode, or the pose from which it is looked for; its outputs there.
    fn direct(&self, count: usize) -> Vec<(Vec<f64>, Vec<f64>)> {
        let (arm, mut noise) = (self.arm(), Noise::new(19, 7));
        let mut all = Vec::new();
        let home = Pose { translation_mm: [0.0, 0.0, 400.0], ..Pose::identity() };
        while all.len() < count {
            let hexapod = (self.robot.model() == "hexapod").then(|| {
                let mut some = |range: f64| [0, 1, 2].map(|_| noise.uniform(range));
                home.then(&Pose::from_xyz_rpy(some(50.0), some(0.25)))
            });
            let mut joint = |joint: &etalon::robots::Joint| match joint.quantity {
                Quantity::Angle => (if arm.dimension() == 2 { 1.2 } else { 0.0 }) + noise.uniform(1.5),
                _ => 100.0 + noise.uniform(70.0),
            };
            let drawn = || arm.joints().iter().map(&mut joint).collect();
            let mut q: Vec<f64> = hexapod.map_or_else(drawn, |at| arm.all_joints(&self.values, &at)[0].clone());
            if arm.has_assembly_modes() {
                q.push(if all.len() % 2 == 0 { 1.0 } else { -1.0 });
            }
            let Some(pose) = arm.tool_pose(&self.values, &q) else { continue };
            if hexapod.is_some() {
                q.extend(home.translation_mm.iter().chain(home.rotation.as_flattened()));
            }
            all.push((q, self.outputs(&pose)));
        }
        all
    }

    fn outputs(&self, pose: &Pose) -> Vec<f64> {
        let r = &pose.rotation;
        match (self.arm().dimension(), self.arm().platform()) {
            (2, None) => pose.translation_mm[..2].to_vec(),
            (2, _) => vec![pose.translation_mm[0], pose.translation_mm[1], r[1][0].atan2(r[0][0])],
            _ if self.robot.model().starts_with("delta") => pose.translation_mm.to_vec(),
            _ => pose.translation_mm.iter().chain(r.as_flattened()).copied().collect(),
        }
    }

    /// Inputs of `inverse` and what it finds: of closed forms a pose (and working mode) and joints, of others pose, start and joints.
    fn inverse(&self, count: usize) -> Vec<(Vec<f64>, Vec<f64>)> {
        let (arm, mut noise) = (self.arm(), Noise::new(19, 8));
        let n = arm.joints().len();
        let mut all = Vec::new();
        for (q, outputs) in self.direct(count) {
            let pose = arm.tool_pose(&self.values, &q).unwrap();
            if arm.dimension() == 3 && !self.parallel() {
                let start: Vec<f64> = q.iter().map(|q| q + noise.uniform(0.01)).collect();
                let Ok(found) = arm.nearest_joints(&self.values, &pose, &start) else { continue };
                all.push((outputs.into_iter().chain(start).collect(), found));
                continue;
            }
            let ways = arm.all_joints(&self.values, &pose);
            // legs or arms with two branches: all ways, or it is not known which is missing
            let branches = match self.robot.model() {
                "delta" => 3,
                "five_bar" => 2,
                _ => 0,
            };
            if ways.len() == 1 << branches {
                for (k, way) in ways.iter().enumerate() {
                    let signs = (0..branches).rev().map(|bit| if k >> bit & 1 == 0 { 1.0 } else { -1.0 });
                    all.push((outputs.iter().copied().chain(signs).collect(), way[..n].to_vec()));
                }
            }
        }
        assert!(all.len() > count / 2, "{} of {count}", all.len());
        all
    }

    /// How far outputs are from what is expected, relative to the largest.
    fn worst(&self, found: &[Vec<f64>], cases: &[(Vec<f64>, Vec<f64>)]) -> f64 {
        assert_eq!(found.len(), cases.len());
        let farther = found.iter().zip(cases).filter(|(found, (inputs, expected))| is_farther(inputs, found, expected));
        let farther = farther.count();
        assert!(farther <= 1 + cases.len() / 100, "{farther} of {} are other solutions", cases.len());
        let off = |(found, (inputs, expected)): (&Vec<f64>, &(Vec<f64>, Vec<f64>))| {
            // seven joints reach a pose in many ways: the pose is what is compared
            let is_other = expected.len() == 7 || is_farther(inputs, found, expected);
            let reached = is_other.then(|| self.outputs(&self.arm().tool_pose(&self.values, found).unwrap()));
            let (found, expected) = reached.as_ref().map_or((found, &expected[..]), |reached| (reached, &inputs[..12]));
            assert!(found.len() >= expected.len(), "{inputs:?}: {found:?}");
            let size = expected.iter().fold(1.0f64, |m, v| m.max(v.abs()));
            found
                .iter()
                .zip(expected)
                .map(|(a, b)| (a - b).abs() / size)
                .fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
        };
        found.iter().zip(cases).map(off).fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
    }
}

/// `true` if six joints of an arm are another solution of a pose than that of the program, and farther from the start: near a singular pose
/// the steps of the code may end there, while the program looks for the nearest.
fn is_farther(inputs: &[f64], found: &[f64], expected: &[f64]) -> bool {
    if expected.len() != 6 || inputs.len() != 18 || found.len() != 6 {
        return false;
    }
    let from_start = |q: &[f64]| q.iter().zip(&inputs[12..]).map(|(q, start)| (q - start).powi(2)).sum::<f64>().sqrt();
    from_start(found) > from_start(expected) + 1e-6
}

const ROBOTS: [&str; 9] = [
    "samples/hexapod/robot.toml",
    "samples/delta/robot.toml",
    "docs/keys/robot-delta_linear.toml",
    "samples/prexyt-cmm/robot.toml",
    "samples/dextar/robot.toml",
    "samples/abb-irb120/robot.toml",
    "docs/keys/robot-serial-dh.toml",
    "docs/keys/robot-serial-poe.toml",
    "samples/column-arm/robot.toml",
];

/// The numbers that a program answers to lines of numbers.
fn answers(command: &mut Command, cases: &[(Vec<f64>, Vec<f64>)]) -> Vec<Vec<f64>> {
    let line = |(inputs, _): &(Vec<f64>, Vec<f64>)| inputs.iter().map(|v| format!("{v:?} ")).collect::<String>() + "\n";
    let input: String = cases.iter().map(line).collect();
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut to = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || to.write_all(input.as_bytes()));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines().map(|line| line.split(' ').filter_map(|v| v.parse().ok()).collect()).collect()
}

#[test]
fn c99_computes_what_the_program_does() {
    if Command::new("cc").arg("--version").output().is_err() {
        return crate::support::skipped("cc");
    }
    for robot in ROBOTS {
        let exported = Exported::new(robot, "c-kinematics");
        let (direct, inverse) = (exported.direct(POSES), exported.inverse(POSES / 10));
        let arm = exported.arm().dimension() == 3 && !exported.parallel();
        let (inputs, outputs) = (direct[0].0.len(), direct[0].1.len());
        let (wanted, joints) = (inverse[0].0.len(), inverse[0].1.len());
        let call = if arm {
            "if (!etalon_inverse(in, in + 12)) return 1; for (i = 0; i < N; i++) out[i] = in[12 + i];"
        } else {
            "etalon_inverse(in, out);"
        };
        let there = if robot.contains("hexapod") {
            "if (!etalon_direct(in, in + N)) return 1; for (i = 0; i < m; i++) out[i] = in[N + i];"
        } else {
            "etalon_direct(in, out);"
        };
        let main = format!(
            "#include \"etalon_kinematics.c\"\n#include <stdio.h>\nenum {{ N = {joints} }};\nint main(int argc, char **argv) {{\n\
             double in[64], out[64]; int i, n = argc > 1 ? {wanted} : {inputs}, m = argc > 1 ? N : {outputs}; (void)argv;\n\
             for (;;) {{ for (i = 0; i < n; i++) if (scanf(\"%lf\", in + i) != 1) return 0;\n\
             if (argc > 1) {{ {call} }} else {{ {there} }}\n\
             for (i = 0; i < m; i++) printf(\"%.17g \", out[i]);\nprintf(\"\\n\"); }}\n}}\n"
        );
        let folder = exported.scratch.path();
        std::fs::write(folder.join("main.c"), main).unwrap();
        let flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O1", "-o", "main", "main.c", "-lm"];
        let compiled = Command::new("cc").args(flags).current_dir(&folder).output().unwrap();
        assert!(compiled.status.success(), "{robot}: {}", String::from_utf8_lossy(&compiled.stderr));
        let off = exported.worst(&answers(&mut Command::new(folder.join("main")), &direct), &direct);
        let back = exported.worst(&answers(Command::new(folder.join("main")).arg("inverse"), &inverse), &inverse);
        println!("C99, {robot}: direct {off:.1e}, inverse {back:.1e}");
        assert!(off < 1e-12 && back < 1e-11, "{robot}: {off} {back}");
    }
}

#[test]
fn python_computes_what_the_program_does() {
    if Command::new("python3").arg("--version").output().is_err() {
        return crate::support::skipped("python3");
    }
    for robot in ROBOTS {
        let exported = Exported::new(robot, "python-kinematics");
        let (direct, inverse) = (exported.direct(POSES), exported.inverse(POSES / 100));
        let direct_of = if robot.contains("hexapod") { "e.direct(v[:6], v[6:])" } else { "e.direct(v)" };
        let script = "import sys, etalon_kinematics as e\nfor line in sys.stdin:\n  v = [float(x) for x in line.split()]\n  \
                      out = DIRECT if len(sys.argv) < 2 else e.inverse(v[:12], v[12:]) if len(v) > 12 else e.inverse(v)\n  \
                      print(*map(repr, out))"
            .replace("DIRECT", direct_of);
        let python = |more: &[&str], cases: &[(Vec<f64>, Vec<f64>)]| {
            let mut command = Command::new("python3");
            answers(command.args(["-B", "-c", &script]).args(more).current_dir(exported.scratch.path()), cases)
        };
        let off = exported.worst(&python(&[], &direct), &direct);
        let back = exported.worst(&python(&["inverse"], &inverse), &inverse);
        println!("Python, {robot}: direct {off:.1e}, inverse {back:.1e}");
        assert!(off < 1e-12 && back < 1e-11, "{robot}: {off} {back}");
    }
}

/// An interpreter of its own, in Python, runs the blocks of all three dialects: it shares nothing with the exporter.
#[test]
fn structured_text_computes_what_the_program_does() {
    if Command::new("python3").arg("--version").output().is_err() {
        return crate::support::skipped("python3");
    }
    let interpreter = root().join("tests/support/structured_text.py");
    for robot in ROBOTS {
        for (format, file) in [
            ("structured-text", "etalon_kinematics.st"),
            ("siemens-scl", "etalon_parameters.scl"),
            ("plcopen", "etalon_parameters_plcopen.xml"),
        ] {
            let exported = Exported::new(robot, format);
            let text = exported.text(file);
            assert!(text.is_ascii() && text.lines().all(|line| line.len() < 250), "{robot}");
            // a grammar of IEC 61131-3, where it is installed; it takes minutes for an arm
            let blark = || Command::new("blark").args(["parse", file]).current_dir(exported.scratch.path()).output();
            match (format == "structured-text" && text.len() < 20_000).then(blark).and_then(Result::ok) {
                Some(read) => assert!(read.status.success(), "{robot}: {}", String::from_utf8_lossy(&read.stderr)),
                None => crate::support::skipped("blark"),
            }
            let run = |block: &str, cases: &[(Vec<f64>, Vec<f64>)]| {
                let mut command = Command::new("python3");
                let command = command.arg("-B").arg(&interpreter).args([file, block]);
                exported.worst(&answers(command.current_dir(exported.scratch.path()), cases), cases)
            };
            // every pose in one dialect, enough of them in the others
            let count = if format == "structured-text" { POSES } else { POSES / 20 };
            let off = run("FB_EtalonDirect", &exported.direct(count));
            let back = run("FB_EtalonInverse", &exported.inverse(count / 100));
            println!("{format}, {robot}: direct {off:.1e}, inverse {back:.1e}");
            assert!(off < 1e-12 && back < 1e-10, "{robot}: {off} {back}");
            // arms that do not meet: no root of a negative number, and the output is not valid
            if robot.contains("dextar") {
                let far = [(vec![5000.0, 0.0, 1.0, 1.0], Vec::new())];
                let mut command = Command::new("python3");
                let command = command.arg("-B").arg(&interpreter).args([file, "FB_EtalonInverse"]);
                assert!(answers(command.current_dir(exported.scratch.path()), &far)[0].is_empty());
            }
        }
    }
}

#[test]
fn a_galil_controller_finds_the_joints_of_a_prexyt() {
    let exported = Exported::new("samples/prexyt-cmm/robot.toml", "galil");
    let text = exported.text("etalon_parameters.dmc");
    assert!(text.lines().all(|line| line.starts_with("REM ") || line.len() <= 80), "{text}");
    let mut noise = Noise::new(19, 9);
    let mut worst = 0f64;
    for i in 0..2 * POSES {
        let pose = [noise.uniform(400.0) + 300.0, noise.uniform(400.0) + 300.0, noise.uniform(20f64.to_radians())];
        let found = galil_prexyt(&text, pose, i % 2 == 0).unwrap();
        let there = Pose { translation_mm: [pose[0], pose[1], 0.0], ..Pose::identity() }.turn_z(pose[2]);
        let q = exported.arm().all_joints(&exported.values, &there).remove(0);
        for (q, found) in q.iter().zip(&found) {
            worst = worst.max((found - q).abs() * 1e3);
        }
    }
    println!("Galil, PreXYT: joint values off by {worst:.4} um at most");
    assert!(worst < 0.05, "{worst}");
}
