//! Ten million rows `name x y z`, labels repeating, into the table of points on two threads, beside polars and pandas from
//! Python and `wc -l`, in the same run.
//!
//! Each reader runs in a process of its own, so that its peak of memory is its own. `ROWS` sets another number of rows.

#![allow(clippy::print_stdout)] // a benchmark prints

use etalon::formats::Format;
use etalon::formats::cloud;
use etalon::formats::dialect::Unit;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

const TIMES: usize = 3;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(i) = arguments.iter().position(|a| a == "--read") {
        return read(Path::new(&arguments[i + 1]));
    }
    let rows: usize = std::env::var("ROWS").ok().and_then(|rows| rows.parse().ok()).unwrap_or(10_000_000);
    let folder = tempfile::tempdir().expect("folder");
    let file = folder.path().join("points.txt");
    write(&file, rows);
    let size = std::fs::metadata(&file).expect("file").len();
    println!("{rows} rows, {:.0} MB; columns take {:.0} MB", size as f64 / 1e6, rows as f64 * 28.0 / 1e6);
    let path = file.to_str().expect("path");
    let python = std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/import_peers.py");
    let own = std::env::current_exe().expect("program");
    for round in 1..=TIMES {
        println!("round {round}");
        let before = Instant::now();
        let counted = Command::new("wc").args(["-l", path]).output().is_ok();
        if counted {
            println!("  wc -l      {:6.2} s", before.elapsed().as_secs_f64());
        }
        let mut etalon = Command::new(&own);
        etalon.args(["--read", path]).env("RAYON_NUM_THREADS", "2");
        show("etalon", &mut etalon);
        for peer in ["polars", "pandas"] {
            let mut command = Command::new(&python);
            command.args([script, peer, path]).env("POLARS_MAX_THREADS", "2");
            show(peer, &mut command);
        }
    }
}

/// What a reader prints; or that it is not there.
fn show(name: &str, command: &mut Command) {
    match command.output() {
        Ok(output) if output.status.success() => print!("  {name:10} {}", String::from_utf8_lossy(&output.stdout)),
        _ => println!("  {name:10} is not there: left out"),
    }
}

/// Reads the file, and prints seconds, rows a second, sums and the peak of memory.
fn read(path: &Path) {
    let before = Instant::now();
    let cloud = cloud(path, &Format::default(), Unit::Millimetre).expect("readable").expect("plain");
    let seconds = before.elapsed().as_secs_f64();
    let sum = |name: &str| etalon::formats::table::numbers(&cloud.table, name).expect("numbers").iter().sum::<f64>();
    let peak = peak_mb();
    let rows = cloud.table.height();
    println!(
        "{seconds:6.2} s, {:5.1} million rows/s, peak {peak} MB, {} labels, sums {:.6} {:.6} {:.6}",
        rows as f64 / seconds / 1e6,
        cloud.labels.len(),
        sum("x_mm"),
        sum("y_mm"),
        sum("z_mm")
    );
}

/// Peak of the process' memory in MB, where the system tells it.
fn peak_mb() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kib = peak.and_then(|p| p.split_whitespace().next()?.parse::<f64>().ok());
    kib.map_or_else(|| "?".to_owned(), |kib| format!("{:.0}", kib * 1024.0 / 1e6))
}

/// Rows of a few thousand labels and coordinates in the size of a robot's workspace, six decimals.
fn write(path: &Path, rows: usize) {
    let mut file = std::io::BufWriter::new(std::fs::File::create(path).expect("file"));
    let mut state = 88_172_645_463_325_252u64;
    let mut number = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64 * 6000.0 - 3000.0
    };
    let mut line = String::new();
    for i in 0..rows {
        line.clear();
        let _ = writeln!(line, "P{} {:.6} {:.6} {:.6}", i % 4096, number(), number(), number());
        file.write_all(line.as_bytes()).expect("written");
    }
    file.flush().expect("written");
}
