//! Grouped greedy choice for O1 (thesis, section 4.5) on the candidates of the sample dextar, beside NumPy with one singular
//! value decomposition per candidate, in the same run.
//!
//! Both get the same scaled Jacobian and the same two positions to start from, and must choose the same positions.

#![allow(clippy::print_stdout)] // a benchmark prints

use etalon::campaign::read_robot;
use etalon::formats;
use etalon::identify::plan::search::greedy;
use etalon::identify::plan::{Criterion, candidate_pool};
use etalon::identify::{Settings, sensitivity};
use etalon::stages::candidates::configurations;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// The allocator of the program.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

const POSITIONS: usize = 15;
const ROUNDS: usize = 201;

fn main() {
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/dextar");
    let robot = read_robot(&sample.join("robot.toml")).expect("robot").build(&[]).expect("robot");
    let text = std::fs::read_to_string(sample.join("candidates.csv")).expect("candidates");
    let table = formats::observations("candidates.csv", &text).expect("candidates");
    let observations = configurations(robot.as_ref(), &table).expect("configurations").observations;
    let settings = Settings::default();
    let known = sensitivity(robot.as_ref(), &observations, &settings).expect("sensitivity");
    let mut members: Vec<Vec<usize>> = Vec::new();
    for (k, o) in observations.iter().enumerate() {
        match members.last_mut() {
            Some(last) if observations[last[0]].pose == o.pose => last.push(k),
            _ => members.push(vec![k]),
        }
    }
    let pool = candidate_pool(&known, &members, Criterion::O1);
    let full: Vec<usize> = (0..members.len()).filter(|&c| members[c].len() == 4).collect();
    let start = [full[0], full[full.len() - 1]];
    let mut times = Vec::new();
    let mut chosen = Vec::new();
    for _ in 0..ROUNDS {
        let before = Instant::now();
        chosen = greedy(&pool, &start, POSITIONS).chosen;
        times.push(before.elapsed().as_secs_f64() * 1e3);
    }
    times.sort_by(f64::total_cmp);
    let ours = times[ROUNDS / 2];
    println!("{POSITIONS} of {} candidates, {} configurations", members.len(), observations.len());
    println!("etalon: {ours:.3} ms (median of {ROUNDS})");

    let mut rows = String::new();
    for (c, candidate) in pool.candidates.iter().enumerate() {
        for row in candidate.rows.row_iter() {
            let cells: Vec<String> = row.iter().map(|v| format!("{v:e}")).collect();
            let _ = writeln!(rows, "{c},{}", cells.join(","));
        }
    }
    let folder = tempfile::tempdir().expect("folder");
    let file = folder.path().join("rows.csv");
    std::fs::write(&file, rows).expect("rows");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/plan_numpy.py");
    let arguments = [POSITIONS, start[0], start[1]].map(|v| v.to_string());
    let answered = Command::new(std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned()))
        .arg(script)
        .arg(&file)
        .args(arguments)
        .output();
    let text = match answered {
        Ok(output) if output.status.success() => String::from_utf8_lossy(&output.stdout).into_owned(),
        _ => return println!("Python with NumPy is not there: no comparison"),
    };
    let mut words = text.split_whitespace();
    let theirs: f64 = words.next().and_then(|w| w.parse().ok()).expect("time");
    let same = words.map(|w| w.parse().expect("candidate")).collect::<Vec<usize>>() == chosen;
    println!("NumPy:  {theirs:.3} ms, {:.0} times; same choice: {same}", theirs / ours);
    assert!(same, "both must choose the same");
}
