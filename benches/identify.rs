//! Identification of the IRB 120 (688 poses, 45 and 39 parameters) beside SciPy, in the same run.
//!
//! The job: observations in, base and reflectors unknown, all parameters with their covariance out. For SciPy the time of
//! its last fit alone is told too, which begins with base and reflectors already found and ends without covariance.

#![allow(clippy::print_stdout)] // a benchmark prints

use etalon::campaign::Campaign;
use etalon::identify::{Settings, identify};
use etalon::run::walk::{Observed as Walked, observed};
use etalon::stages::evaluate::sets::split;
use etalon::stages::kinds::Observed;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// The allocator of the program.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() {
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/abb-irb120");
    let campaign = Campaign::read(&sample).expect("sample");
    if let Some(name) = campaign.missing_variable() {
        println!("skipped: {name} is not set");
        return;
    }
    let Walked { robot, mut joined, .. } = observed(&campaign).expect("observed");
    let observations = joined.observations[0].1.positions(robot.as_ref(), &mut Vec::new()).expect("observations");
    let stated = campaign.file.identify.as_ref().expect("[identify]");
    let selections = campaign.selections(stated).expect("selections");
    let observed = Observed { observations, settings: campaign.settings(stated) };
    let sets = split(&observed, &observed.poses(), &selections);
    let folder = tempfile::tempdir().expect("folder");
    let csv = folder.path().join("observations.csv");
    std::fs::write(&csv, joined.observations.swap_remove(0).1.into_table().to_csv().expect("csv")).expect("csv");

    for (what, extra) in [("45 parameters", 6), ("39 parameters", 0)] {
        let mut settings: Settings = campaign.settings(stated);
        if extra == 0 {
            settings.hold = vec!["compliance_*".into(), "coupling_*".into()];
        }
        let mut times: Vec<f64> = (0..15)
            .map(|_| {
                let start = Instant::now();
                let found = identify(robot.as_ref(), &sets.calibration, &settings).expect("identified");
                std::hint::black_box(found);
                start.elapsed().as_secs_f64()
            })
            .collect();
        times.sort_by(f64::total_cmp);
        let ours = times[times.len() / 2];
        println!("{what}: etalon {:.1} ms (median of {})", ours * 1e3, times.len());
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/identify_scipy.py");
        let output = Command::new(std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned()))
            .arg(script)
            .arg(&csv)
            .arg(extra.to_string())
            .output();
        let Some(output) = output.ok().filter(|o| o.status.success()) else {
            println!("  SciPy: not there (python3 with numpy and scipy)");
            continue;
        };
        for line in String::from_utf8_lossy(&output.stdout).lines() {
            let Some((name, seconds)) = line.rsplit_once(": ") else { continue };
            let seconds: f64 = seconds.parse().expect("seconds");
            println!("  SciPy {name}: {:.0} ms, {:.1} times etalon", seconds * 1e3, seconds / ours);
        }
    }
}
