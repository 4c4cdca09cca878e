//! Calls from Python beside the same calls of the library: identification of the IRB 120 (688 poses), and a cylinder of
//! 1,000,000 points.
//!
//! `PYTHON` names an interpreter that has the wheel (`make python`). Both sides read the same files, and alternate.

#![allow(clippy::print_stdout)] // a benchmark prints

use etalon::campaign::{Campaign, read_robot};
use etalon::fit::{Element, FitSettings, element};
use etalon::run::walk::{Observed, observed};
use etalon::tasks::{self, IdentifyOptions, Inputs, Table};
use std::hint::black_box;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Instant;

const ROUNDS: usize = 15;
const POINTS: u32 = 1_000_000;

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().expect("folder");
    let Some(mut python) = peer(root, folder.path()) else {
        println!("skipped: PYTHON names no interpreter with the wheel (make python)");
        return;
    };
    cylinder(&mut python, folder.path());
    identification(&mut python, &root.join("samples/abb-irb120"), folder.path());
    python.kill().and_then(|()| python.wait()).expect("end of Python");
}

/// Python, which answers a line with the seconds of the call that the line names.
fn peer(root: &Path, folder: &Path) -> Option<Child> {
    let python = std::env::var("PYTHON").ok()?;
    let has_wheel = Command::new(&python).args(["-c", "import etalon"]).current_dir(folder).output().ok()?;
    let script = root.join("benches/python_calls.py");
    let mut start = Command::new(&python);
    start.arg(script).current_dir(folder).stdin(Stdio::piped()).stdout(Stdio::piped());
    has_wheel.status.success().then(|| start.spawn().expect("Python"))
}

fn cylinder(python: &mut Child, folder: &Path) {
    // a spiral of radius 25 mm over 100 mm with waves of 10 um
    let point = |i: u32| {
        let angle = f64::from(i) * 2.399_963_229_728_653;
        let radius = 25.0 + 0.010 * (7.0 * angle).sin();
        [radius * angle.cos(), radius * angle.sin(), 100.0 * f64::from(i) / f64::from(POINTS)]
    };
    let points: Vec<[f64; 3]> = (0..POINTS).map(point).collect();
    let bytes: Vec<u8> = points.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
    std::fs::write(folder.join("points.bin"), bytes).expect("points");
    let ours = || drop(black_box(element(Element::Cylinder, &points, &FitSettings::default()).expect("cylinder")));
    report("cylinder of 1,000,000 points", python, "cylinder", ours);
}

fn identification(python: &mut Child, sample: &Path, folder: &Path) {
    let campaign = Campaign::read(sample).expect("sample");
    if let Some(name) = campaign.missing_variable() {
        println!("IRB 120: skipped, {name} is not set");
        return;
    }
    let Observed { mut joined, .. } = observed(&campaign).expect("observed");
    let observations = joined.observations.swap_remove(0).1.into_table();
    let csv = String::from_utf8(observations.to_csv().expect("csv")).expect("UTF-8");
    std::fs::write(folder.join("observations.csv"), &csv).expect("observations");
    let robot = read_robot(&sample.join("robot.toml")).expect("robot");
    let toml = std::fs::read_to_string(sample.join("robot.toml")).expect("robot");
    std::fs::write(folder.join("robot.toml"), &toml).expect("robot");
    let given = Inputs {
        robot: &robot,
        stated: Table::Text { name: "robot", text: &toml },
        table: Table::Text { name: "observations", text: &csv },
    };
    let ours = || drop(black_box(tasks::identify(&given, &IdentifyOptions::default()).expect("identified")));
    report("identify, IRB 120, 688 poses", python, "identify", ours);
}

/// Medians of alternating calls.
fn report(what: &str, python: &mut Child, call: &str, ours: impl Fn()) {
    let mut answers = BufReader::new(python.stdout.take().expect("stdout"));
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..ROUNDS {
        let start = Instant::now();
        ours();
        times[0].push(start.elapsed().as_secs_f64());
        writeln!(python.stdin.as_mut().expect("stdin"), "{call}").expect("call");
        let mut answer = String::new();
        answers.read_line(&mut answer).expect("answer");
        times[1].push(answer.trim().parse().expect("seconds"));
    }
    python.stdout = Some(answers.into_inner());
    let [ours, peer] = times.map(|mut of| {
        of.sort_by(f64::total_cmp);
        of[ROUNDS / 2]
    });
    println!("{what}: library {:.1} ms, from Python {:.1} ms, {:.2} times", ours * 1e3, peer * 1e3, peer / ours);
}
