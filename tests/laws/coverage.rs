//! Whole simulated campaigns: 95 % intervals of every parameter hold the truth in 95 of 100, and whatever the frames add is in them.

use crate::support::scratch::copy_sample;
use etalon::campaign::Campaign;
use etalon::run::check;
use etalon::simulate::{Truth, simulate, true_values};
use etalon::stages::{frames, identification, join};
use rayon::prelude::*;

const CAMPAIGNS: usize = 600;

/// For each parameter its name and the share of campaigns whose interval holds the truth.
fn coverage(sample: &str) -> Vec<(String, f64)> {
    let held: Vec<Vec<(String, bool)>> = (0..CAMPAIGNS).into_par_iter().map(|seed| one(sample, seed)).collect();
    let share = |i: usize| held.iter().filter(|all| all[i].1).count() as f64 / held.len() as f64;
    (0..held[0].len()).map(|i| (held[0][i].0.clone(), share(i))).collect()
}

/// Simulates a sample with a seed of its own and identifies it; whether each interval holds the truth.
fn one(sample: &str, seed: usize) -> Vec<(String, bool)> {
    let scratch = copy_sample(sample);
    let campaign = Campaign::read(&scratch.path()).expect("campaign");
    let mut truth = Truth::read(&scratch.path().join("truth.toml")).expect("truth");
    truth.seed = 1000 + seed as u64;
    simulate(&campaign, &truth).expect("simulated");
    let prepared = check::check(&campaign).expect("prepared");
    let robot = prepared.robot.as_ref();
    let features = frames::fit_features(&campaign, &prepared.gathered.points).expect("features");
    let placed = frames::make_frames(&campaign, &prepared.gathered.points, &features, true).expect("frames");
    let joined = join::join(&campaign, &prepared.gathered, &placed, robot).expect("joined");
    let stated = campaign.file.identify.as_ref().expect("[identify]");
    let found =
        identification::identify(&campaign, stated, robot, &joined, &placed, &Default::default()).expect("found").found;
    let values = true_values(robot, &truth.parameters).expect("truth");
    let factor = 1.96; // some hundred degrees of freedom
    let holds = |&i: &usize| {
        let u = found.standard_uncertainty(i).expect("identified");
        (robot.parameters()[i].name.clone(), (found.values[i] - values[i]).abs() <= factor * u)
    };
    found.free.iter().map(holds).collect()
}

#[test]
fn intervals_of_whole_campaigns_hold_the_truth() {
    for sample in ["prexyt-cmm", "dextar"] {
        let shares = coverage(sample);
        println!("{sample}, {CAMPAIGNS} synthetic campaigns: {shares:?}");
        // 95 ± 1.5 %, and three standard deviations of a share of so many
        let allowed = 0.015 + 3.0 * (0.95f64 * 0.05 / CAMPAIGNS as f64).sqrt();
        for (name, share) in shares {
            assert!((share - 0.95).abs() < allowed, "{sample}: {name} {share}");
        }
    }
}
