//! Coverage: in drawn campaigns, 95 % intervals hold the true value in 95 %.

use crate::run::selftest::data::{Data, Slip};
use crate::run::selftest::row::{Rows, Subject};
use etalon_base::noise::Noise;
use etalon_base::phrase;
use etalon_identify::{Observation, Prior, Settings, identify};
use etalon_robots::{Prexyt, Robot};
use rayon::prelude::*;

pub(crate) const SUBJECT: Subject = Subject {
    id: "coverage",
    requirement: || phrase!("selftest-coverage"),
    rows,
    slips: &[Slip::Digit("/published/coverage/stated_mm", 1), Slip::Unit("/published/coverage/stated_mm", 1.0 / 25.4)],
};

/// Standard deviations of a normal distribution to either side that hold 95 %.
const NORMAL_95: f64 = 1.959_964;
/// Standard deviations of a share or mean by the number of draws that are permissible: of fifteen
/// numbers one exceeds them in two hundred seeds. The seed does not change.
const BY_CHANCE: f64 = 3.5;

fn rows(data: &Data) -> Vec<Rows> {
    let data = data.at("/published/coverage");
    let mut rows = Rows::new("JCGM 101:2008, 7.7");
    let (draws, seed) = (data.number("/draws"), data.number("/seed") as u64);
    let (noise_mm, stated_mm) = (data.number("/noise_mm"), data.number("/stated_mm"));
    let found: Vec<Drawn> =
        (0..draws as u64).into_par_iter().filter_map(|trial| drawn(seed, trial, [noise_mm, stated_mm])).collect();
    let mean = |of: &dyn Fn(&Drawn) -> f64| found.iter().map(of).sum::<f64>() / draws;
    let parameters = found.first().map_or(0, |drawn| drawn.held.len());
    let expected = data.number("/expected");
    let shares: Vec<f64> = (0..parameters).map(|i| mean(&|d| f64::from(u8::from(d.held[i])))).collect();
    let by_chance = BY_CHANCE * (expected * (1.0 - expected) / draws).sqrt();
    let campaigns = found.len();
    rows.add_all(
        phrase!("selftest-shares", parameters, draws = campaigns),
        "",
        [&vec![expected; parameters], &shares],
        by_chance,
    );
    let degrees = found.first().map_or(f64::NAN, |drawn| drawn.degrees_of_freedom);
    let by_chance = BY_CHANCE * (2.0 / (degrees * draws)).sqrt();
    rows.add(
        phrase!("selftest-mean-chi-square", draws = campaigns),
        "",
        [1.0, mean(&|d| d.chi_square) / degrees],
        by_chance,
    );
    vec![rows]
}

/// Result of one drawn campaign.
struct Drawn {
    /// For each parameter, `true` if its interval holds the true value.
    held: Vec<bool>,
    chi_square: f64,
    degrees_of_freedom: f64,
}

/// A table with two balls at eight corners of its workspace, five times.
fn drawn(seed: u64, trial: u64, [noise_mm, stated_mm]: [f64; 2]) -> Option<Drawn> {
    let robot = Prexyt::default();
    let mut truth = robot.nominal();
    for (name, value) in [("s", 393.93), ("gamma", 0.0828f64.to_radians()), ("delta2", 0.9996)] {
        truth[robot.index(name)?] = value;
    }
    let mut noise = Noise::new(seed, trial);
    let mut observations = Vec::new();
    for cycle in 1..=5 {
        for pose in 0..8i64 {
            let joints: Vec<f64> = [170.0, 300.0, 240.0]
                .iter()
                .enumerate()
                .map(|(i, far)| if pose >> i & 1 == 1 { *far } else { 0.0 })
                .collect();
            let targets = robot.balls(&truth, &joints);
            let targets = targets.map(|[x, y]| Some([x + noise.gaussian(noise_mm), y + noise.gaussian(noise_mm), 0.0]));
            observations.push(Observation {
                pose: pose.into(),
                cycle,
                joints,
                targets: targets.to_vec(),
                ..Observation::default()
            });
        }
    }
    let settings = Settings { standard_uncertainty_mm: Some(stated_mm), prior: Prior::None, ..Settings::default() };
    let found = identify(&robot, &observations, &settings).ok()?;
    // the given uncertainty alone: chi-square may not enlarge it
    let stated = |i: usize| Some(found.standard_uncertainty(i)? / found.uncertainty.inflation_factor);
    let held = found.free.iter().map(|&i| Some((found.values[i] - truth[i]).abs() <= NORMAL_95 * stated(i)?));
    Some(Drawn {
        held: held.collect::<Option<_>>()?,
        chi_square: found.residuals.chi_square?,
        degrees_of_freedom: found.residuals.degrees_of_freedom as f64,
    })
}
