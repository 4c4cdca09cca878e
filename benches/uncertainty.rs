//! Draws of whole campaigns (`etalon uncertainty`) beside identifications by SciPy of the same observations, in the same run: the sample
//! dextar on one thread and two, and the sample prexyt-cmm as far as a million draws would take.
//!
//! `DRAWS` sets how many of each (20,000); `PYTHON` names the Python.

#![allow(clippy::print_stdout)] // a benchmark prints

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

const ETALON: &str = env!("CARGO_BIN_EXE_etalon");

fn main() {
    let folder = tempfile::tempdir().expect("folder");
    let draws: u32 = std::env::var("DRAWS").ok().and_then(|n| n.parse().ok()).unwrap_or(20_000);
    let dextar = rates("dextar", draws, folder.path());
    scipy(folder.path(), dextar);
    let [_, two] = rates("prexyt-cmm", draws, folder.path());
    println!("a million draws of prexyt-cmm on two threads: {:.0} s", 1e6 / two);
}

/// Draws a second on one thread and on two, the least that a draw costs beside the start of the program.
fn rates(sample: &str, draws: u32, folder: &Path) -> [f64; 2] {
    let campaign = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(sample);
    let answer = folder.join(format!("{sample}.json"));
    let mut answers = Vec::new();
    let rates = ["1", "2"].map(|threads| {
        let timed = |draws: u32| {
            let mut command = Command::new(ETALON);
            command.arg("uncertainty").arg(&campaign).args([
                "--resamples",
                "0",
                "--json",
                "--draws",
                &draws.to_string(),
            ]);
            let begun = Instant::now();
            let output = command.env("RAYON_NUM_THREADS", threads).output().expect("uncertainty");
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            (begun.elapsed().as_secs_f64(), output.stdout)
        };
        let (few, _) = timed(100);
        let (all, document) = timed(draws);
        let made: serde_json::Value = serde_json::from_slice(&document).expect("JSON");
        answers.push(document);
        let made = made["draws"].as_f64().expect("draws");
        (made - 100.0) / (all - few)
    });
    assert!(answers[0] == answers[1], "other numbers on two threads");
    std::fs::write(answer, &answers[0]).expect("answer");
    let [one, two] = rates;
    println!("{sample}: {one:.0} draws/s on one thread, {two:.0}/s on two, second thread {:.2} times", two / one);
    rates
}

fn scipy(folder: &Path, [one, two]: [f64; 2]) {
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/dextar");
    let campaign: PathBuf = folder.join("dextar");
    assert!(Command::new("cp").arg("-r").args([&sample, &campaign]).status().expect("cp").success());
    let run = Command::new(ETALON).args(["run", "dextar"]).current_dir(folder).output().expect("run");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let output = Command::new(std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned()))
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/uncertainty_scipy.py"))
        .arg(campaign.join("out/observations.csv"))
        .args(["24", "5"])
        .envs([("OMP_NUM_THREADS", "1"), ("OPENBLAS_NUM_THREADS", "1")])
        .output();
    let Some(output) = output.ok().filter(|output| output.status.success()) else {
        println!("  SciPy: not there (python3 with numpy and scipy)");
        return;
    };
    let text = String::from_utf8(output.stdout).expect("text");
    let (seconds, l23) = text.trim().split_once(' ').expect("two numbers");
    let (seconds, l23): (f64, f64) = (seconds.parse().expect("seconds"), l23.parse().expect("l23"));
    let parameters = std::fs::read(campaign.join("out/parameters.json")).expect("parameters");
    let parameters: serde_json::Value = serde_json::from_slice(&parameters).expect("JSON");
    let all = parameters["parameters"].as_array().expect("parameters");
    let ours = all.iter().find(|p| p["name"] == "l23").and_then(|p| p["value"].as_f64()).expect("l23");
    println!(
        "  SciPy, identification alone on one thread: {:.1} ms, {:.0}/s: etalon {:.0} times on one thread, {:.0} times on two; its l23 \
         differs by {:.0e} mm",
        1e3 * seconds,
        1.0 / seconds,
        one * seconds,
        two * seconds,
        l23 - ours
    );
}
