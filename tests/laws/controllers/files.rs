//! Controller files of drawn arms and of the other kinds of robots: read back by a reader of this test and evaluated at the validation poses, a
//! file has the error that it states, and is not worse than nominal. The data are synthetic. `ETALON_ARMS` is the number of arms.

use crate::support::documents_of;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::campaign::Campaign;
use etalon::controllers::{self, Description, Exporter, Given};
use etalon::documents::{ControllersDocument, PoseSet};
use etalon::identify::Observation;
use etalon::math::statistics::rms;
use etalon::robots::{Quantity, Robot, Role, base_pose};
use etalon::run::pipeline::Outcome;
use etalon::stages::controller_files::identify_again;
use etalon::stages::evaluate;
use etalon::stages::identification::Identified;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::{Command, Stdio};

/// Largest relative difference of the error that a file states and that of its reader.
const AGREES: f64 = 0.02;
/// Formats of which this test has a reader for arms.
const OF_ARMS: [&str; 9] = [
    "json",
    "csv",
    "c-header",
    "matlab",
    "python",
    "universal-robots",
    "linuxcnc",
    "c-kinematics",
    "python-kinematics",
];

fn number(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(default)
}

/// A number from `from` to `to`.
fn between(noise: &mut Noise, from: f64, to: f64) -> f64 {
    0.5 * (from + to) + noise.uniform(0.5 * (to - from))
}

/// A campaign on an arm of five to seven joints, off by up to 0.5 mm and 3 mrad, of half of them with gains that are identified.
fn drawn(seed: u64) -> Scratch {
    let mut noise = Noise::new(42, seed);
    let n = [6, 6, 5, 7][seed as usize % 4];
    let gains = seed % 8 < 4;
    let mut text = "name = \"arm\"\nmodel = \"serial\"\n".to_owned();
    for i in 0..n {
        let right = if noise.uniform(1.0) > 0.0 { 90.0 } else { -90.0 };
        let alpha = if i == 0 || i > 1 && noise.uniform(1.0) > 0.5 { 0.0 } else { right };
        let a = if i > 0 && (alpha == 0.0 || noise.uniform(1.0) > 0.0) {
            between(&mut noise, 40.0, 400.0).round()
        } else {
            0.0
        };
        let d = if noise.uniform(1.0) > 0.0 { between(&mut noise, 60.0, 450.0).round() } else { 0.0 };
        let theta = [0.0, 0.0, 90.0, -90.0][(2.0 + noise.uniform(2.0)).floor().clamp(0.0, 3.0) as usize];
        let _ = writeln!(text, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}");
    }
    let effects = if gains { "\"all\"" } else { "[\"zeros\", \"geometry\"]" };
    let campaign = format!(
        "name = \"arm\"\nrobot = \"robot.toml\"\ncontrollers = [\"json\"]\nsynthetic = \"drawn for a test\"\n\
         [instrument]\nname = \"tracker\"\nexpanded_uncertainty_um = 20\ncoverage_factor = 2\n\
         [observations]\nfile = \"observations.csv\"\n\
         [identify]\neffects = {effects}\ncalibration = \"1-60\"\nvalidation = \"rest\"\n"
    );
    let empty = "pose,target,x_mm,y_mm,z_mm\n";
    let scratch = Scratch::with(&[("campaign.toml", &campaign), ("robot.toml", &text), ("observations.csv", empty)]);
    let file = etalon::campaign::read_robot(&scratch.path().join("robot.toml")).unwrap();
    let robot = file.build(&["tool".to_owned()]).unwrap();
    let mut value = |p: &etalon::robots::Parameter| match (p.role, p.quantity) {
        (Role::Base, Quantity::Angle) => noise.uniform(0.3),
        (Role::Base, _) => noise.uniform(900.0),
        (Role::Target, _) => 60.0 + noise.uniform(40.0),
        (_, Quantity::Length) => p.nominal + noise.uniform(0.5),
        (_, Quantity::Angle) => p.nominal + noise.uniform(3e-3),
        (_, Quantity::Ratio) => p.nominal + if gains { noise.uniform(1e-3) } else { 0.0 },
    };
    let truth: Vec<f64> = robot.parameters().iter().map(&mut value).collect();
    let columns: Vec<String> = (1..=n).map(|i| format!("q{i}_deg")).collect();
    let mut table = format!("pose,target,{},x_mm,y_mm,z_mm\n", columns.join(","));
    for pose in 1..=90 {
        let q: Vec<f64> = (0..n).map(|_| noise.uniform(110.0)).collect();
        let q_rad: Vec<f64> = q.iter().map(|q| q.to_radians()).collect();
        let at = robot.position(&truth, &q_rad, 0).map(|v| v + noise.gaussian(0.01));
        let row: Vec<String> = q.iter().chain(&at).map(f64::to_string).collect();
        let _ = writeln!(table, "{pose},tool,{}", row.join(","));
    }
    std::fs::write(scratch.path().join("observations.csv"), table).unwrap();
    scratch
}

/// A campaign that was run.
struct Ran {
    name: String,
    scratch: Scratch,
    robot: Box<dyn Robot>,
    description: Option<(String, String)>,
    outcome: Outcome,
}

impl Ran {
    fn new(name: impl Into<String>, scratch: Scratch) -> Self {
        let name = name.into();
        let campaign = Campaign::read(&scratch.path()).unwrap();
        let outcome = documents_of(&campaign).unwrap_or_else(|problems| panic!("{name}: {problems}"));
        let targets: Vec<String> = match (campaign.file.observations.first(), name.as_str()) {
            (None, _) => Vec::new(),
            (_, "linear-delta") => (1..=3).map(|k| format!("SMR_{k}")).collect(),
            _ => vec!["tool".to_owned()],
        };
        let robot = campaign.build_robot_with(&targets).unwrap();
        let description = campaign.robot.description().map(|(file, text)| (file.to_owned(), text.to_owned()));
        Self { name, scratch, robot, description, outcome }
    }

    fn found(&self) -> &Identified {
        self.outcome.identified.as_ref().unwrap()
    }

    fn given<'a>(&'a self, controllers: Option<&'a ControllersDocument>) -> Given<'a> {
        let found = self.found();
        Given {
            robot: Some(self.robot.as_ref()),
            description: self.description.as_ref().map(|(file, text)| Description { file, text }),
            accuracy: Some(&found.accuracy),
            controllers,
            ..Given::parameters(&found.parameters)
        }
    }

    /// The file of a format with the values that it holds (all parameters; base and targets as fitted to them) and its stated error;
    /// `None` where it is refused as worse than nominal, or the format cannot hold the robot.
    fn file(&self, format: &str) -> Option<File<'_>> {
        let exporter: &dyn Exporter = controllers::by_name(format).unwrap();
        let again = identify_again(&self.given(None), self.robot.as_ref(), self.found(), &[(format, exporter)]);
        let given = self.given(again.as_ref());
        let statement = given.statement(exporter).unwrap();
        let bytes = exporter.write(&given).ok()?;
        let file = again.as_ref().and_then(|document| document.files.first());
        let own = |p: &etalon::robots::Parameter| {
            let entry = || self.found().parameters.parameters.iter().find(|e| e.name == p.name).map(|e| e.value);
            let held = file.map(|file| file.values.iter().find(|v| v.name == p.name).unwrap().value);
            p.quantity.inward(held.or_else(entry).unwrap_or(p.nominal))
        };
        let values = self.robot.parameters().iter().map(own).collect();
        let errors = statement.errors.unwrap_or_else(|| panic!("{}: {format} states no error", self.name));
        Some(File { ran: self, bytes, values, stated: errors.written.rms_mm, nominal: errors.nominal.rms_mm })
    }
}

/// A controller file.
struct File<'a> {
    ran: &'a Ran,
    bytes: Vec<u8>,
    values: Vec<f64>,
    /// Root mean squares (mm) at the validation poses, stated for the file and for nominal values.
    stated: f64,
    nominal: f64,
}

impl File<'_> {
    fn text(&self) -> String {
        String::from_utf8(self.bytes.clone()).unwrap()
    }

    fn validation(&self) -> &[Observation] {
        &self.ran.found().sets.validation
    }

    /// Root mean square error of the positions that a reader of the file gives.
    fn rms(&self, position: impl Fn(&Observation, usize) -> Vector) -> f64 {
        let (mut squares, mut count) = (0.0, 0);
        for o in self.validation() {
            for (k, measured) in o.targets.iter().enumerate() {
                let Some(measured) = measured else { continue };
                squares += norm(minus(*measured, position(o, k))).powi(2);
                count += 1;
            }
        }
        (squares / f64::from(count)).sqrt()
    }

    fn target(&self, k: usize) -> Vector {
        let first = self.ran.robot.free_base().unwrap().target_place(k);
        [0, 1, 2].map(|i| self.values[first + i])
    }

    /// The world position of a target on a flange whose pose in the base is known.
    fn in_world(&self, flange: &Pose, k: usize) -> Vector {
        base_pose(&self.values).then(flange).apply(self.target(k))
    }

    /// Error of the robot with values that the file lists by name, in their units.
    fn rms_of_list(&self, list: &BTreeMap<String, f64>) -> f64 {
        let robot = self.ran.robot.as_ref();
        let value = |p: &etalon::robots::Parameter| p.quantity.inward(list[&p.name]);
        let values: Vec<f64> = robot.parameters().iter().map(value).collect();
        let found = self.ran.found();
        let errors = evaluate::errors(robot, &found.sets, &found.again.before, &values);
        rms(errors.iter().filter(|e| e.set == PoseSet::Validation).map(|e| norm(e.after_mm)))
    }

    /// Positions by a program that answers joint values with a pose: place, then rotation row by row.
    fn rms_of_program(&self, command: &mut Command) -> f64 {
        let line = |o: &Observation| o.joints.iter().map(|q| format!("{q:?} ")).collect::<String>() + "\n";
        let input: String = self.validation().iter().map(line).collect();
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success());
        let text = String::from_utf8(output.stdout).unwrap();
        let poses: Vec<Pose> = text.lines().map(pose_of_line).collect();
        assert_eq!(poses.len(), self.validation().len());
        let by_joints: Vec<(&[f64], &Pose)> = self.validation().iter().map(|o| &o.joints[..]).zip(&poses).collect();
        self.rms(|o, k| self.in_world(by_joints.iter().find(|(q, _)| **q == o.joints[..]).unwrap().1, k))
    }
}

fn pose_of_line(line: &str) -> Pose {
    let v: Vec<f64> = line.split(' ').filter_map(|v| v.parse().ok()).collect();
    let rotation = if v.len() < 12 {
        Pose::identity().rotation
    } else {
        [[v[3], v[4], v[5]], [v[6], v[7], v[8]], [v[9], v[10], v[11]]]
    };
    Pose { rotation, translation_mm: [v[0], v[1], v[2]] }
}

/// Parameters of a list in a text, by name.
fn list(format: &str, text: &str, robot: &dyn Robot) -> BTreeMap<String, f64> {
    let number = |text: &str| text.split([',', '(', ')', ' ']).find(|v| !v.is_empty()).unwrap().parse::<f64>().unwrap();
    let after = |key: String| {
        let rest = text.split_once(&key).unwrap_or_else(|| panic!("{key}: {text}")).1;
        number(rest.lines().next().unwrap())
    };
    let value = |p: &etalon::robots::Parameter| match format {
        "json" => {
            let document: serde_json::Value = serde_json::from_str(text).unwrap();
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

/// The flange by a calibration of Universal Robots: six frames of `xyz` (m) and `rpy`.
fn universal_robots(file: &File) -> f64 {
    let text = file.text();
    let numbers: Vec<f64> =
        text.lines().filter_map(|line| line.strip_prefix("    ")?.split_once(": ")?.1.parse().ok()).collect();
    let nominal = file.ran.robot.joint_chain(&file.ran.robot.nominal()).unwrap().flange;
    let joint = |pose: Pose, (f, q): (&[f64], &f64)| {
        pose.then(&Pose::from_xyz_rpy([f[0], f[1], f[2]].map(|m| 1000.0 * m), [f[3], f[4], f[5]])).turn_z(*q)
    };
    let flange = |q: &[f64]| numbers.chunks_exact(6).zip(q).fold(Pose::identity(), joint).then(&nominal);
    file.rms(|o, k| file.in_world(&flange(&o.joints), k))
}

/// The flange by genserkins: Rx(ALPHA) Tx(A) Rz(theta) Tz(D).
fn linuxcnc(file: &File) -> f64 {
    let text = file.text();
    let after = |key: String| -> f64 {
        let rest = text.lines().find_map(|line| line.strip_prefix(&key)).unwrap_or_else(|| panic!("{key}: {text}"));
        rest.split(' ').next().unwrap().parse().unwrap()
    };
    let set = |name: &str, i: usize| after(format!("setp genserkins.{name}-{i} "));
    let theta = |i: usize| after(format!("# joint {i}: at its zero genserkins has ")).to_radians();
    let framed = |name: &str| {
        let line = text.lines().find(|l| l.starts_with(&format!("# {name}: "))).unwrap();
        let v: Vec<f64> = line.split([' ', ',']).filter_map(|v| v.parse().ok()).collect();
        Pose::from_xyz_rpy([v[0], v[1], v[2]], [v[3], v[4], v[5]].map(f64::to_radians))
    };
    let (base, end) = (framed("first frame in the base"), framed("flange in the last frame"));
    let flange = |q: &[f64]| {
        let link = |pose: Pose, i: usize| {
            pose.turn_x(set("ALPHA", i)).shift(0, set("A", i)).turn_z(theta(i) + q[i]).shift(2, set("D", i))
        };
        (0..6).fold(base, link).then(&end)
    };
    file.rms(|o, k| file.in_world(&flange(&o.joints), k))
}

/// The C code, compiled; `None` without a compiler.
fn c_code(file: &File) -> Option<f64> {
    Command::new("cc").arg("--version").output().ok()?;
    let folder = file.ran.scratch.root().join("c");
    std::fs::create_dir_all(&folder).unwrap();
    let (inputs, hexapod) = (file.validation()[0].joints.len(), file.ran.robot.model() == "hexapod");
    let (start, call) = match hexapod {
        true => (
            "for (i = 0; i < 12; i++) in[N+i] = 0; in[N+2] = 400; in[N+3] = in[N+7] = in[N+11] = 1;",
            "if (!etalon_direct(in, in + N)) return 1; for (i = 0; i < 12; i++) out[i] = in[N + i];",
        ),
        false => ("", "etalon_direct(in, out);"),
    };
    // a delta moves its platform without turning it
    let outputs = if file.ran.robot.model().starts_with("delta") { 3 } else { 12 };
    let main = format!(
        "#include \"etalon_kinematics.c\"\n#include <stdio.h>\nenum {{ N = {inputs} }};\nint main(void) {{ double in[64] = {{0}}, out[12] = {{0}}; int i;\n\
         for (;;) {{ for (i = 0; i < N; i++) if (scanf(\"%lf\", in + i) != 1) return 0;\n{start} {call}\n\
         for (i = 0; i < {outputs}; i++) printf(\"%.17g \", out[i]);\nprintf(\"\\n\"); }}\n}}\n"
    );
    std::fs::write(folder.join("etalon_kinematics.c"), &file.bytes).unwrap();
    std::fs::write(folder.join("main.c"), main).unwrap();
    let flags = ["-std=c99", "-O1", "-o", "main", "main.c", "-lm"];
    assert!(Command::new("cc").args(flags).current_dir(&folder).status().unwrap().success(), "{}", file.ran.name);
    Some(file.rms_of_program(&mut Command::new(folder.join("main"))))
}

/// The Python code; `None` without Python.
fn python_code(file: &File) -> Option<f64> {
    Command::new("python3").arg("--version").output().ok()?;
    let folder = file.ran.scratch.root().join("python");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("etalon_kinematics.py"), &file.bytes).unwrap();
    let script = "import sys, etalon_kinematics as e\nfor line in sys.stdin:\n  print(*map(repr, e.direct([float(x) for x in line.split()])))";
    Some(file.rms_of_program(Command::new("python3").args(["-B", "-c", script]).current_dir(folder)))
}

/// The number behind a text.
fn after(text: &str, key: &str) -> f64 {
    let rest = text.split_once(key).unwrap_or_else(|| panic!("{key}: {text}")).1;
    rest.split(|c: char| !"0123456789.-+e".contains(c)).find(|v| !v.is_empty()).unwrap().parse().unwrap()
}

/// The stated error where the joints that a file gives at the platform's poses are those of its values, not a number elsewhere.
fn by_inverse(file: &File, joints: impl Fn(&Pose) -> Vec<f64>) -> f64 {
    let arm = file.ran.robot.kinematics().unwrap();
    let same = |o: &Observation| {
        let pose = arm.tool_pose(&file.values, &o.joints).unwrap();
        joints(&pose).iter().zip(&o.joints).all(|(a, b)| (a - b).abs() < 1e-4)
    };
    if file.validation().iter().all(same) {
        file.rms(|o, k| arm.position(&file.values, &o.joints, k))
    } else {
        f64::NAN
    }
}

/// Struts by genhexkins: |t + R platform - base|, less what LinuxCNC adds to the joint values.
fn hexapod(file: &File) -> f64 {
    let text = file.text();
    let end = |leg: usize, end: &str| {
        ["x", "y", "z"].map(|axis| after(&text, &format!("setp genhexkins.{end}.{leg}.{axis} ")))
    };
    let joint = |pose: &Pose, leg: usize| {
        let strut = norm(minus(pose.apply(end(leg, "platform")), end(leg, "base")));
        strut - after(&text, &format!("# joint {leg}: its position in LinuxCNC is the joint value + "))
    };
    by_inverse(file, |pose| (0..6).map(|leg| joint(pose, leg)).collect())
}

/// Carriages of three upright towers: z + sqrt(L2 - level distance2), as Klipper's `delta.py` has them.
fn klipper(file: &File) -> f64 {
    let text = file.text();
    let sections: Vec<&str> = text.split("[stepper_").skip(1).collect();
    let all = |key: &str| -> Vec<f64> { sections.iter().map(|section| after(section, key)).collect() };
    let (radius, angles) = (after(&text, "delta_radius: "), all("angle: "));
    let (rods, heights) = (all("arm_length: "), all("position_endstop: "));
    let (x0, y0, turned) =
        (after(&text, "in the base: x "), after(&text, " mm, y "), after(&text, "turned by ").to_radians());
    by_inverse(file, |pose| {
        let (sin, cos) = turned.sin_cos();
        let [x, y, z] = pose.translation_mm;
        let (x, y) = (cos * (x - x0) + sin * (y - y0), cos * (y - y0) - sin * (x - x0));
        let carriage = |i: usize| {
            let (sin, cos) = angles[i].to_radians().sin_cos();
            let level = (x - radius * cos).powi(2) + (y - radius * sin).powi(2);
            z + (rods[i].powi(2) - level).sqrt() - heights[i] - (rods[i].powi(2) - radius.powi(2)).sqrt()
        };
        (0..3).map(carriage).collect()
    })
}

/// The URDF as the program reads one.
fn urdf(file: &File) -> f64 {
    let folder = file.ran.scratch.path();
    std::fs::write(folder.join("calibrated.urdf"), &file.bytes).unwrap();
    let toml = std::fs::read_to_string(folder.join("robot.toml")).unwrap();
    std::fs::write(folder.join("calibrated.toml"), toml.replace("arm.urdf", "calibrated.urdf")).unwrap();
    let read = etalon::campaign::read_robot(&folder.join("calibrated.toml")).unwrap();
    let read = read.build(file.ran.robot.targets()).unwrap();
    let mut values = read.nominal();
    for (value, p) in values.iter_mut().zip(read.parameters()).filter(|(_, p)| p.role != Role::Robot) {
        *value = file.values[file.ran.robot.index(&p.name).unwrap()];
    }
    file.rms(|o, k| read.position(&values, &o.joints, k))
}

/// The error of a file as its reader has it; `None` where the reader's program is not installed.
fn read_back(format: &str, file: &File) -> Option<f64> {
    match format {
        "json" | "csv" | "c-header" | "matlab" | "python" => {
            Some(file.rms_of_list(&list(format, &file.text(), file.ran.robot.as_ref())))
        }
        "universal-robots" => Some(universal_robots(file)),
        "linuxcnc" => Some(linuxcnc(file)),
        "linuxcnc-hexapod" => Some(hexapod(file)),
        "klipper-delta" => Some(klipper(file)),
        "urdf" => Some(urdf(file)),
        "c-kinematics" => c_code(file),
        _ => python_code(file),
    }
}

/// What is wrong with the files of a campaign, and how many were read, refused, or cannot hold the robot.
fn wrong(ran: &Ran, formats: &[&str]) -> (Vec<String>, [usize; 2]) {
    let (mut wrong, mut counts) = (Vec::new(), [0; 2]);
    for format in formats {
        let Some(file) = ran.file(format) else {
            counts[1] += 1;
            continue;
        };
        let Some(read) = read_back(format, &file) else { continue };
        counts[0] += 1;
        let (stated, nominal) = (file.stated, file.nominal);
        if (read / stated - 1.0).abs() > AGREES || read.is_nan() {
            wrong.push(format!("{}: {format} states {stated:.6} mm, and has {read:.6} mm", ran.name));
        }
        if read > nominal {
            wrong.push(format!("{}: {format} has {read:.6} mm, nominal {nominal:.6} mm", ran.name));
        }
    }
    (wrong, counts)
}

fn judge(all: &[(Vec<String>, [usize; 2])]) {
    let sum = |i: usize| all.iter().map(|(_, counts)| counts[i]).sum::<usize>();
    let wrong: Vec<&String> = all.iter().flat_map(|(wrong, _)| wrong).collect();
    println!("{} files read back, {} refused or not for the robot, {} wrong", sum(0), sum(1), wrong.len());
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(sum(0) > 0);
}

#[test]
fn files_of_drawn_arms_are_as_accurate_as_they_say() {
    let arms = number("ETALON_ARMS", 8);
    let of_arm = |seed: u64| wrong(&Ran::new(format!("arm {seed}"), drawn(seed)), &OF_ARMS);
    let all: Vec<_> = (0..arms).into_par_iter().map(of_arm).collect();
    judge(&all);
}

#[test]
fn files_of_other_robots_are_as_accurate_as_they_say() {
    let lists = ["json", "csv", "c-header", "matlab", "python"];
    let robots: [(&str, &[&str]); 6] = [
        ("prexyt-cmm", &[]),
        ("dextar", &[]),
        ("hexapod", &["c-kinematics", "linuxcnc-hexapod"]),
        ("delta", &["c-kinematics"]),
        ("linear-delta", &["c-kinematics", "klipper-delta"]),
        ("column-arm", &["c-kinematics", "urdf"]),
    ];
    let of_robot =
        |(sample, more): &(&str, &[&str])| wrong(&Ran::new(*sample, copy_sample(sample)), &[&lists[..], more].concat());
    let all: Vec<_> = robots.par_iter().map(of_robot).collect();
    judge(&all);
}
