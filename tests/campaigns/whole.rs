//! Whole campaigns: simulate → run gives the truth, the same bytes every time, whatever the number of threads.

use crate::support::documents_of;
use crate::support::root;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::campaign::Campaign;
use etalon::documents::ParameterStatus;
use etalon::run::pipeline;
use etalon::simulate::Truth;
use std::path::Path;

/// Runs the sample with its noise multiplied; gives the parameters that are off by more than `sigmas` of their u.
fn off_by(sample: &str, noise_um: f64, sigmas: f64) -> Vec<String> {
    let scratch = copy_sample(sample);
    let campaign = Campaign::read(&scratch.path()).unwrap();
    let mut truth = Truth::read(&scratch.path().join("truth.toml")).unwrap();
    truth.noise_um = Some(noise_um);
    truth.decimals = 12;
    etalon::simulate::simulate(&campaign, &truth).unwrap();
    let outcome = documents_of(&campaign).unwrap();
    let mut off = Vec::new();
    for p in &outcome.results.identified.as_ref().unwrap().parameters.parameters {
        let error = (p.value - truth.parameters[&p.name]).abs();
        assert_eq!(p.status, ParameterStatus::Identified, "{}", p.name);
        let u = if noise_um == 0.0 { 1e-9 } else { p.standard_uncertainty.unwrap() };
        if error > sigmas * u {
            off.push(format!("{}: off by {error:e}, u {u:e}", p.name));
        }
    }
    off
}

#[test]
fn a_noise_free_campaign_gives_the_truth() {
    for sample in ["prexyt-cmm", "prexyt-faroarm"] {
        let off = off_by(sample, 0.0, 1.0);
        assert!(off.is_empty(), "{sample}: {off:?}");
    }
}

#[test]
fn a_noisy_campaign_is_within_its_uncertainties() {
    for sample in ["prexyt-cmm", "prexyt-faroarm"] {
        let off = off_by(sample, 1.35, 4.0);
        assert!(off.is_empty(), "{sample}: {off:?}");
    }
}

#[test]
fn samples_are_what_their_truth_makes() {
    for sample in ["prexyt-cmm", "prexyt-faroarm", "prexyt-geometric", "prexyt-repeatability"] {
        let scratch = copy_sample(sample);
        let campaign = Campaign::read(&scratch.path()).unwrap();
        let truth = Truth::read(&scratch.path().join("truth.toml")).unwrap();
        let exports = campaign.file.exports.iter().map(|e| e.file.get_ref());
        let files: Vec<&String> = exports.chain(campaign.file.logs.iter().map(|l| l.file.get_ref())).collect();
        let committed: Vec<Vec<u8>> = files.iter().map(|f| std::fs::read(scratch.path().join(f)).unwrap()).collect();
        etalon::simulate::simulate(&campaign, &truth).unwrap();
        for (file, before) in files.iter().zip(committed) {
            let after = std::fs::read(scratch.path().join(file)).unwrap();
            assert!(before == after, "{sample}/{file} is not what truth.toml makes: run `make samples`");
        }
    }
}

fn all_bytes(scratch: &Scratch) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<_> = std::fs::read_dir(scratch.path().join("out"))
        .unwrap()
        .map(|entry| {
            let entry = entry.unwrap();
            (entry.file_name().into_string().unwrap(), std::fs::read(entry.path()).unwrap())
        })
        .collect();
    files.sort();
    files
}

/// Runs a sample on so many threads; the bytes of all that it writes.
fn run_on(sample: &str, threads: usize) -> Vec<(String, Vec<u8>)> {
    let scratch = copy_sample(sample);
    let output = std::process::Command::new(crate::support::program())
        .args(["run", "campaign"])
        .current_dir(scratch.root())
        .env("RAYON_NUM_THREADS", threads.to_string())
        .env("POLARS_MAX_THREADS", threads.to_string())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    all_bytes(&scratch)
}

fn same_bytes(sample: &str, threads: &[usize]) {
    let runs: Vec<_> = threads.iter().map(|n| run_on(sample, *n)).collect();
    let names = |run: &[(String, Vec<u8>)]| run.iter().map(|f| f.0.clone()).collect::<Vec<_>>();
    assert!(runs[0].len() > 10, "{:?}", names(&runs[0]));
    for run in &runs[1..] {
        assert_eq!(names(&runs[0]), names(run));
        for (a, b) in runs[0].iter().zip(run) {
            assert!(a == b, "{} differs between runs", a.0);
        }
    }
}

#[test]
fn same_bytes_for_any_number_of_threads() {
    same_bytes("prexyt-cmm", &[1, 2, 5]);
}

/// 2064 points and 45 parameters: large enough that factorisations are split among threads.
#[test]
fn same_bytes_for_any_number_of_threads_with_a_thousand_poses() {
    if crate::reference_data("robots/irb120_faro_ets").is_some() {
        same_bytes("abb-irb120", &[1, 5]);
    }
}

#[test]
fn report_and_controller_files_are_made_again_from_the_output_folder_alone() {
    let scratch = copy_sample("prexyt-cmm");
    pipeline::run(&Campaign::read(&scratch.path()).unwrap()).unwrap();
    let mut made =
        vec!["report.html", "report.pdf", "report.xlsx", "controller.json", "controller.csv", "etalon_parameters.h"];
    made.retain(|name| cfg!(feature = "pdf") || !name.ends_with("pdf"));
    let first = all_bytes(&scratch);
    // nothing is left of the campaign, and its output has another name
    let alone = scratch.root().join("archive");
    std::fs::rename(scratch.path().join("out"), &alone).unwrap();
    std::fs::remove_dir_all(scratch.path()).unwrap();
    for name in &made {
        std::fs::remove_file(alone.join(name)).unwrap();
    }
    for arguments in [["report", "archive"], ["export", "archive/parameters.json"]] {
        let output = std::process::Command::new(crate::support::program())
            .args(arguments)
            .current_dir(scratch.root())
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    for (name, bytes) in first.iter().filter(|(name, _)| made.contains(&name.as_str())) {
        assert!(*bytes == std::fs::read(alone.join(name)).unwrap(), "{name} differs");
    }
    assert_eq!(first.iter().filter(|(name, _)| made.contains(&name.as_str())).count(), made.len());
}

#[test]
fn every_synthetic_sample_is_made_again_from_its_truth() {
    let samples = root().join("samples");
    for sample in std::fs::read_dir(&samples).unwrap().flatten().map(|entry| entry.path()) {
        if !sample.join("truth.toml").exists() {
            continue;
        }
        let name = sample.file_name().unwrap().to_str().unwrap();
        let scratch = copy_sample(name);
        let campaign = Campaign::read(&scratch.path()).unwrap();
        let truth = etalon::simulate::Truth::read(&scratch.path().join("truth.toml")).unwrap();
        for file in etalon::simulate::simulate(&campaign, &truth).unwrap_or_else(|e| panic!("{name}: {e}")) {
            let read = |folder: &Path| std::fs::read(folder.join(&file)).unwrap();
            assert!(read(&sample) == read(&scratch.path()), "{name}: {file}");
        }
    }
}
