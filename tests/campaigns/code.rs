//! The model as code: what a C compiler, Python and an interpreter of Structured Text make of the exported kinematics is what the program
//! computes.

use super::controllers::{disturbed, etalon, parameters};
use crate::support::scratch::Scratch;
use etalon::base::noise::Noise;
use etalon::campaign::read_robot;
use etalon::math::robots::{Kinematics, Quantity, Robot};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
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
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(robot);
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

    /// Joint values and, behind them, an assembly mode; the outputs of `direct` there.
    fn direct(&self, count: usize) -> Vec<(Vec<f64>, Vec<f64>)> {
        let (arm, mut noise) = (self.arm(), Noise::new(19, 7));
        let mut all = Vec::new();
        while all.len() < count {
            let joint = |joint: &etalon::math::robots::Joint| match joint.quantity {
                Quantity::Angle => (if arm.dimension() == 2 { 1.2 } else { 0.0 }) + noise.uniform(1.5),
                _ => 100.0 + noise.uniform(70.0),
            };
            let mut q: Vec<f64> = arm.joints().iter().map(joint).collect();
            if arm.has_assembly_modes() {
                q.push(if all.len() % 2 == 0 { 1.0 } else { -1.0 });
            }
            let Some(pose) = arm.tool_pose(&self.values, &q) else { continue };
            all.push((q, self.outputs(&pose)));
        }
        all
    }

    fn outputs(&self, pose: &etalon::base::pose::Pose) -> Vec<f64> {
        let r = &pose.rotation;
        match (self.arm().dimension(), self.arm().platform()) {
            (2, None) => pose.translation_mm[..2].to_vec(),
            (2, _) => vec![pose.translation_mm[0], pose.translation_mm[1], r[1][0].atan2(r[0][0])],
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
            if arm.dimension() == 3 {
                let start: Vec<f64> = q.iter().map(|q| q + noise.uniform(0.01)).collect();
                let Ok(found) = arm.nearest_joints(&self.values, &pose, &start) else { continue };
                all.push((outputs.into_iter().chain(start).collect(), found));
            } else if arm.platform().is_some() {
                all.push((outputs, q));
            } else {
                for (ways, branches) in
                    arm.all_joints(&self.values, &pose).iter().zip([[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]])
                {
                    // all four ways, or it is not known which is missing
                    if arm.all_joints(&self.values, &pose).len() == 4 {
                        all.push((outputs.iter().copied().chain(branches).collect(), ways[..n].to_vec()));
                    }
                }
            }
        }
        assert!(all.len() > count / 2, "{} of {count}", all.len());
        all
    }

    /// How far outputs are from what is expected, relative to the largest.
    fn worst(&self, found: &[Vec<f64>], cases: &[(Vec<f64>, Vec<f64>)]) -> f64 {
        assert_eq!(found.len(), cases.len());
        let off = |(found, (inputs, expected)): (&Vec<f64>, &(Vec<f64>, Vec<f64>))| {
            // seven joints reach a pose in many ways: the pose is what is compared
            let reached =
                (expected.len() == 7).then(|| self.outputs(&self.arm().tool_pose(&self.values, found).unwrap()));
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

const ROBOTS: [&str; 6] = [
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
        return println!("skipped: there is no `cc`");
    }
    for robot in ROBOTS {
        let exported = Exported::new(robot, "c-kinematics");
        let (direct, inverse) = (exported.direct(POSES), exported.inverse(POSES / 10));
        let arm = exported.arm().dimension() == 3;
        let (inputs, outputs) = (direct[0].0.len(), direct[0].1.len());
        let (wanted, joints) = (inverse[0].0.len(), inverse[0].1.len());
        let call = if arm {
            "if (!etalon_inverse(in, in + 12)) return 1; for (i = 0; i < N; i++) out[i] = in[12 + i];"
        } else {
            "etalon_inverse(in, out);"
        };
        let main = format!(
            "#include \"etalon_kinematics.c\"\n#include <stdio.h>\nenum {{ N = {joints} }};\nint main(int argc, char **argv) {{\n\
             double in[64], out[64]; int i, n = argc > 1 ? {wanted} : {inputs}, m = argc > 1 ? N : {outputs}; (void)argv;\n\
             for (;;) {{ for (i = 0; i < n; i++) if (scanf(\"%lf\", in + i) != 1) return 0;\n\
             if (argc > 1) {{ {call} }} else etalon_direct(in, out);\n\
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
        return println!("skipped: there is no `python3`");
    }
    for robot in ROBOTS {
        let exported = Exported::new(robot, "python-kinematics");
        let (direct, inverse) = (exported.direct(POSES), exported.inverse(POSES / 100));
        let script = "import sys, etalon_kinematics as e\nfor line in sys.stdin:\n  v = [float(x) for x in line.split()]\n  \
                      out = e.direct(v) if len(sys.argv) < 2 else e.inverse(v[:12], v[12:]) if len(v) > 12 else e.inverse(v)\n  \
                      print(*map(repr, out))";
        let python = |more: &[&str], cases: &[(Vec<f64>, Vec<f64>)]| {
            let mut command = Command::new("python3");
            answers(command.args(["-B", "-c", script]).args(more).current_dir(exported.scratch.path()), cases)
        };
        let off = exported.worst(&python(&[], &direct), &direct);
        let back = exported.worst(&python(&["inverse"], &inverse), &inverse);
        println!("Python, {robot}: direct {off:.1e}, inverse {back:.1e}");
        assert!(off < 1e-12 && back < 1e-11, "{robot}: {off} {back}");
    }
}

/// Runs function blocks without loops: assignments of one operation each, and roots that are guarded.
fn run_block(text: &str, block: &str, inputs: &[f64]) -> Vec<f64> {
    let begin = text.find(&format!("FUNCTION_BLOCK {block}\n")).unwrap();
    let body = text[begin..].split("END_FUNCTION_BLOCK").next().unwrap().split("valid := TRUE;\n").nth(1).unwrap();
    let mut known: BTreeMap<String, f64> = inputs.iter().enumerate().map(|(i, v)| (format!("q[{i}]"), *v)).collect();
    let mut out = Vec::new();
    let (mut skipping, mut negative) = (false, false);
    for line in body.lines().map(str::trim) {
        let atom = |text: &str| -> f64 {
            let (sign, text) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
            let bare = text.trim_matches(['(', ')']);
            sign * known.get(bare).copied().unwrap_or_else(|| {
                // a real literal: digits, a point, digits, an exponent
                assert!(bare.split(['E']).next().unwrap().contains('.'), "{line}: {bare}");
                bare.parse().unwrap()
            })
        };
        if let Some(of) = line.strip_prefix("IF ") {
            negative = atom(of.strip_suffix(" < 0.0 THEN").unwrap()) < 0.0;
            skipping = !negative;
            continue;
        }
        match line {
            "ELSE" => skipping = negative,
            "END_IF;" => skipping = false,
            _ => {}
        }
        let Some((name, value)) = line.split_once(" := ").filter(|_| !skipping) else { continue };
        let value = value.strip_suffix(';').unwrap();
        if value == "FALSE" {
            return Vec::new();
        }
        let call = value.strip_suffix(')').and_then(|v| v.split_once('(')).filter(|(name, _)| {
            !name.is_empty() && name.chars().all(|c| c.is_ascii_uppercase() || c == '_' || c == '2')
        });
        let infix = |sign: &str| value.split_once(sign).map(|(a, b)| [atom(a), atom(b)]);
        let value = match call {
            Some(("SIN", v)) => atom(v).sin(),
            Some(("COS", v)) => atom(v).cos(),
            Some(("SQRT", v)) => atom(v).sqrt(),
            Some(("ETALON_WRAP", v)) => etalon::base::scalar::Scalar::wrapped(atom(v)),
            Some(("ETALON_ATAN2", v)) => {
                let (y, x) = v.split_once(", ").unwrap();
                atom(y).atan2(atom(x))
            }
            Some((name, _)) => panic!("{name}"),
            None => match (infix(" + "), infix(" - "), infix(" * "), infix(" / ")) {
                (Some([a, b]), ..) => a + b,
                (_, Some([a, b]), ..) => a - b,
                (_, _, Some([a, b]), _) => a * b,
                (.., Some([a, b])) => a / b,
                _ => atom(value),
            },
        };
        if name.starts_with("out[") {
            out.push(value);
        }
        known.insert(name.to_owned(), value);
    }
    out
}

#[test]
fn structured_text_computes_what_the_program_does() {
    for robot in ROBOTS {
        let exported = Exported::new(robot, "structured-text");
        let text = exported.text("etalon_kinematics.st");
        for (open, close) in
            [("\nFUNCTION", "\nEND_FUNCTION"), ("IF ", "END_IF;"), ("FOR ", "END_FOR;"), ("\nVAR", "\nEND_VAR")]
        {
            let count = |word: &str| text.matches(word).count();
            let extra = if open == "IF " { count("ELSIF ") } else { 0 };
            assert_eq!(count(open) - extra, count(close), "{robot}: {open}");
        }
        assert!(text.is_ascii() && text.lines().all(|line| line.len() < 250), "{robot}");
        // a grammar of IEC 61131-3, where it is installed; it takes minutes for an arm
        let blark = || {
            Command::new("blark").args(["parse", "etalon_kinematics.st"]).current_dir(exported.scratch.path()).output()
        };
        match (exported.arm().dimension() == 2).then(blark).and_then(Result::ok) {
            Some(read) => assert!(read.status.success(), "{robot}: {}", String::from_utf8_lossy(&read.stderr)),
            None => println!("skipped: `blark` on {robot}"),
        }
        let direct = exported.direct(200);
        let run = |block: &str, cases: &[(Vec<f64>, Vec<f64>)]| -> Vec<Vec<f64>> {
            cases.iter().map(|(inputs, _)| run_block(&text, block, inputs)).collect()
        };
        let off = exported.worst(&run("FB_EtalonDirect", &direct), &direct);
        assert!(off < 1e-12, "{robot}: {off}");
        if exported.arm().dimension() == 2 {
            let inverse = exported.inverse(200);
            let back = exported.worst(&run("FB_EtalonInverse", &inverse), &inverse);
            assert!(back < 1e-10, "{robot}: {back}");
        }
    }
    // arms that do not meet: no root of a negative number, and the output is not valid
    let exported = Exported::new("samples/dextar/robot.toml", "structured-text");
    let text = exported.text("etalon_kinematics.st");
    assert!(run_block(&text, "FB_EtalonInverse", &[5000.0, 0.0, 1.0, 1.0]).is_empty());
}
