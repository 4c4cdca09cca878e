//! Many PreXYT campaigns from text to parameters.json and accuracy.json, beside a script of pandas and SciPy that reads the same
//! files, in the same run; and how long the program takes to start, beside Python's import of SciPy.
//!
//! `COUNT` sets how many (200); a tenth of them is run as well, for the rate to be seen not to depend on it. `PYTHON` names the
//! Python. The campaigns are written to memory where there is `/dev/shm`: a disk is not what is measured.

#![allow(clippy::print_stdout)] // a benchmark prints

use etalon::campaign::Campaign;
use etalon::simulate::{Truth, simulate};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

const ETALON: &str = env!("CARGO_BIN_EXE_etalon");

fn main() {
    let count: usize = std::env::var("COUNT").ok().and_then(|n| n.parse().ok()).unwrap_or(200);
    let memory = Path::new("/dev/shm");
    let folder = if memory.is_dir() { tempfile::tempdir_in(memory) } else { tempfile::tempdir() }.expect("folder");
    let names = campaigns(folder.path(), count);
    let few = names[..count.div_ceil(10)].join("\n");
    std::fs::write(folder.path().join("few.txt"), few).expect("list");
    std::fs::write(folder.path().join("all.txt"), names.join("\n")).expect("list");

    let scipy = scipy(folder.path(), &names[..names.len().min(21)]);
    println!("campaigns, threads, campaigns a second, peak of memory, times the script on one thread");
    let mut alone = 0.0;
    for (list, count, threads) in [("few.txt", count.div_ceil(10), 2), ("all.txt", count, 1), ("all.txt", count, 2)] {
        let (seconds, peak) = batch(folder.path(), list, threads);
        let rate = count as f64 / seconds;
        let ratios: Vec<String> = scipy.iter().map(|(way, s)| format!("{:.1} times ({way})", rate * s)).collect();
        let ratio = if ratios.is_empty() { "SciPy is not there".to_owned() } else { ratios.join(", ") };
        let second = if list == "all.txt" && threads == 2 {
            format!(", second thread {:.2} times", rate / alone)
        } else {
            String::new()
        };
        alone = rate;
        println!("{count:6} {threads} {rate:7.0}/s {peak:>7} MB   {ratio}{second}");
    }
    start_up(folder.path(), &names[0]);
}

/// Simulated campaigns, each with its own noise; their names.
fn campaigns(folder: &Path, count: usize) -> Vec<String> {
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/prexyt-cmm");
    let mut truth = Truth::read(&sample.join("truth.toml")).expect("truth");
    let one = |i: usize| {
        let name = format!("c{i}");
        std::fs::create_dir_all(folder.join(&name).join("exports")).expect("folder");
        for file in ["campaign.toml", "robot.toml", "encoders.csv"] {
            std::fs::copy(sample.join(file), folder.join(&name).join(file)).expect("copy");
        }
        truth.seed = i as u64;
        simulate(&Campaign::read(&folder.join(&name)).expect("campaign"), &truth).expect("simulated");
        name
    };
    (0..count).map(one).collect()
}

/// Seconds and peak of memory in MB of a batch, whose results are removed.
fn batch(folder: &Path, list: &str, threads: usize) -> (f64, String) {
    let before = Instant::now();
    let mut child = Command::new(ETALON)
        .args(["batch", list, "--documents"])
        .env("RAYON_NUM_THREADS", threads.to_string())
        .current_dir(folder)
        .stdout(Stdio::null())
        .spawn()
        .expect("batch");
    let mut peak = String::from("?");
    let ended = loop {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
        if let Some(kib) =
            status.lines().find_map(|l| l.strip_prefix("VmHWM:")?.split_whitespace().next()?.parse::<f64>().ok())
        {
            peak = format!("{:.0}", kib * 1024.0 / 1e6);
        }
        match child.try_wait().expect("batch") {
            Some(status) => break status,
            None => std::thread::sleep(std::time::Duration::from_millis(5)),
        }
    };
    let seconds = before.elapsed().as_secs_f64();
    assert!(ended.code().is_some_and(|code| code < 2), "the batch failed");
    for name in std::fs::read_to_string(folder.join(list)).expect("list").lines() {
        std::fs::remove_dir_all(folder.join(name).join("out")).expect("results");
    }
    (seconds, peak)
}

fn python() -> Command {
    Command::new(std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned()))
}

/// Seconds of a campaign of the script, by the way in which it is written; the answers of the first campaign are compared.
fn scipy(folder: &Path, names: &[String]) -> Vec<(String, f64)> {
    assert!(Command::new(ETALON).args(["run", "c0"]).current_dir(folder).output().expect("run").status.success());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/batch_scipy.py");
    let threads = [("OMP_NUM_THREADS", "1"), ("OPENBLAS_NUM_THREADS", "1")];
    let output = python().arg(script).arg("8").args(names).current_dir(folder).envs(threads).output();
    let Some(output) = output.ok().filter(|output| output.status.success()) else { return Vec::new() };
    let parameters = std::fs::read(folder.join("c0/out/parameters.json")).expect("parameters");
    let parameters: serde_json::Value = serde_json::from_slice(&parameters).expect("JSON");
    let all = parameters["parameters"].as_array().expect("parameters");
    let ours = all.iter().find(|p| p["name"] == "s").and_then(|p| p["value"].as_f64()).expect("s");
    let of = |line: &str| {
        let (way, numbers) = line.split_once(": ").expect("a name");
        let (seconds, s_mm) = numbers.split_once(' ').expect("two numbers");
        let [seconds, s_mm] = [seconds, s_mm].map(|number| number.parse::<f64>().expect("a number"));
        println!(
            "pandas and SciPy, {way}: {:.1} ms, {:.0}/s; its s differs by {:.1e} mm",
            1e3 * seconds,
            1.0 / seconds,
            s_mm - ours
        );
        (way.to_owned(), seconds)
    };
    String::from_utf8_lossy(&output.stdout).lines().map(of).collect()
}

/// Median of starts of the program, of a run with its report and of one without, beside Python's import of SciPy.
fn start_up(folder: &Path, campaign: &str) {
    let median = |command: &mut dyn FnMut() -> Command, times: usize| {
        let mut all: Vec<f64> = (0..times)
            .map(|_| {
                let _ = std::fs::remove_dir_all(folder.join(campaign).join("out"));
                let before = Instant::now();
                let ended = command().current_dir(folder).stdout(Stdio::null()).stderr(Stdio::null()).status();
                ended.ok().filter(std::process::ExitStatus::success).map(|_| before.elapsed().as_secs_f64())
            })
            .collect::<Option<_>>()?;
        all.sort_by(f64::total_cmp);
        Some(all[times / 2])
    };
    let of = |arguments: &'static [&'static str]| {
        move || {
            let mut command = Command::new(ETALON);
            command.args(arguments);
            command
        }
    };
    let import = median(
        &mut || {
            let mut p = python();
            p.args(["-c", "import scipy.optimize"]);
            p
        },
        5,
    );
    let help = median(&mut of(&["--help"]), 21).expect("help");
    let documents = median(&mut of(&["batch", "c0", "--documents"]), 11).expect("batch");
    let run = median(&mut of(&["run", "c0"]), 5).expect("run");
    let beside = |seconds: f64| {
        import.map_or_else(String::new, |i| format!(", import of SciPy takes {:.1} times as long", i / seconds))
    };
    if let Some(import) = import {
        println!("python -c 'import scipy.optimize': {:.0} ms", 1e3 * import);
    }
    println!("etalon --help: {:.1} ms{}", 1e3 * help, beside(help));
    println!("one campaign, documents alone: {:.0} ms{}", 1e3 * documents, beside(documents));
    println!("one campaign with report.html, .pdf and .xlsx: {:.0} ms{}", 1e3 * run, beside(run));
}
