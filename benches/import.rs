//! Ten million rows `name x y z`, labels repeating, on two threads: into the table of points as `etalon fit` reads them, and
//! into points with their lines as `etalon run` does, beside polars and pandas from Python and `wc -l`, in the same run.
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

/// The allocator of the program.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

const TIMES: usize = 3;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    match arguments.iter().position(|a| a.starts_with("--read")) {
        Some(i) if arguments[i] == "--read-points" => return read_points(Path::new(&arguments[i + 1])),
        Some(i) => return read(Path::new(&arguments[i + 1])),
        None => {}
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
        for (name, how) in [("etalon fit", "--read"), ("etalon run", "--read-points")] {
            let mut etalon = Command::new(&own);
            etalon.args([how, path]).env("RAYON_NUM_THREADS", "2");
            show(name, &mut etalon);
        }
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
    let peak = peak_mb();
    let columns = etalon::formats::parquet::table(&cloud.table).expect("numbers");
    let sum = |name: &str| columns.numbers(name).expect("numbers").iter().sum::<f64>();
    let rows = columns.height();
    println!(
        "{seconds:6.2} s, {:5.1} million rows/s, peak {peak} MB, {} labels, sums {:.6} {:.6} {:.6}",
        rows as f64 / seconds / 1e6,
        cloud.labels.len(),
        sum("x_mm"),
        sum("y_mm"),
        sum("z_mm")
    );
}

/// Reads the file as `etalon run` does, its text included, and prints the same.
fn read_points(path: &Path) {
    let before = Instant::now();
    let bytes = etalon::formats::read_bytes(path).expect("readable");
    let text = etalon::formats::into_text(path, bytes, None, &Format::default()).expect("text");
    let (points, problems) = etalon::formats::rows(&Format::default(), "points.txt", &text.into(), Unit::Millimetre);
    let seconds = before.elapsed().as_secs_f64();
    assert!(problems.0.is_empty(), "no row is refused");
    let peak = peak_mb();
    let labels: std::collections::BTreeSet<&str> = points.iter().map(|p| &*p.label).collect();
    let sum = |axis: usize| points.iter().map(|p| p.xyz_mm[axis]).sum::<f64>();
    println!(
        "{seconds:6.2} s, {:5.1} million rows/s, peak {peak} MB, {} labels, sums {:.6} {:.6} {:.6}",
        points.len() as f64 / seconds / 1e6,
        labels.len(),
        sum(0),
        sum(1),
        sum(2)
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
