//! A robust fit beside the plain one: silent where readings are only noisy, right where one is wrong.

use crate::identify::prediction::{U_MM, drawn, sample};
use etalon::identify::{
    Observation, RobustComparison, Settings, identify_again, identify_from, reliability, robust_comparison,
};
use etalon::robots::Robot;
use rayon::prelude::*;

fn compared(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    start: &[f64],
) -> Option<RobustComparison> {
    let plain = identify_from(robot, observations, settings, start).unwrap();
    robust_comparison(robot, observations, settings, &plain).unwrap()
}

/// At a probability of 1 % two of 200 draws are expected, and more than ten once in 10⁴ times.
#[test]
#[ignore = "a long law: make laws"]
fn noise_alone_makes_no_difference() {
    for name in ["prexyt-cmm", "column-arm"] {
        let (robot, found) = sample(name);
        for stated in [Some(U_MM), None] {
            let settings = Settings { standard_uncertainty_mm: stated, ..Settings::default() };
            let one = |trial: u64| {
                let observations = drawn(robot.as_ref(), &found, trial);
                let robust = compared(robot.as_ref(), &observations, &settings, &found.found.values).unwrap();
                let mean = robust.changes.iter().map(|c| c.over_u().powi(2)).sum::<f64>() / robust.changes.len() as f64;
                (robust.significant().is_some(), robust.disagreeing().len(), mean)
            };
            let all: Vec<(bool, usize, f64)> = (0..200).into_par_iter().map(one).collect();
            let alarms = all.iter().filter(|one| one.0).count();
            let poses: usize = all.iter().map(|one| one.1).sum();
            let square = all.iter().map(|one| one.2).sum::<f64>() / all.len() as f64;
            println!("{name} {stated:?}: {alarms} alarms and {poses} poses of 200, mean square {square:.2}");
            assert!(alarms <= 10 && poses <= 10, "{name} {stated:?}: {alarms} alarms, {poses} poses of 200");
            // the standard uncertainty of the difference is neither too small nor far too large
            assert!((0.2..1.2).contains(&square), "{name} {stated:?}: {square}");
        }
    }
}

#[test]
#[ignore = "a long law: make laws"]
fn a_gross_error_moves_the_plain_fit_alone() {
    for name in ["prexyt-cmm", "column-arm"] {
        let (robot, found) = sample(name);
        let robot = robot.as_ref();
        let settings = Settings { standard_uncertainty_mm: Some(U_MM), ..Settings::default() };
        let (mut off, mut left, mut alarms, trials) = (0.0, 0.0, 0, 40);
        for trial in 0..trials {
            let clean = drawn(robot, &found, 1000 + trial);
            let right = identify_from(robot, &clean, &settings, &found.found.values).unwrap();
            let readings = reliability(robot, &clean, &settings, &right).unwrap().unwrap().readings;
            // an error that the other readings contradict
            let controlled: Vec<(usize, usize)> = (0..clean.len())
                .flat_map(|i| (0..clean[i].targets.len()).map(move |k| (i, k)))
                .filter(|&(i, k)| readings[i][k].is_some_and(|r| r.redundancy > 0.6))
                .collect();
            let (i, k) = controlled[7 * trial as usize % controlled.len()];
            let mut wrong = clean.clone();
            wrong[i].targets[k].as_mut().unwrap()[trial as usize % 2] += 20.0 * U_MM;
            let plain = identify_again(robot, &wrong, &settings, &right).unwrap();
            let robust = compared(robot, &wrong, &settings, &right.values).unwrap();
            assert_eq!(robust.poses[0].pose, wrong[i].pose, "{name} {trial}");
            assert_eq!(robust.disagreeing().len(), 1, "{name} {trial}: {:?}", robust.disagreeing());
            assert!(robust.poses[0].weight < 0.05 && robust.poses[1].weight > 0.2, "{name} {trial}");
            alarms += usize::from(robust.significant().is_some());
            let moved = |values: &[f64]| {
                let over_u = |&i: &usize| (values[i] - right.values[i]).abs() / right.standard_uncertainty(i).unwrap();
                right.free.iter().map(over_u).fold(0.0, f64::max)
            };
            off += moved(&plain) / trials as f64;
            left += moved(&robust.values) / trials as f64;
        }
        println!("{name}: plain moved by {off:.2} u, robust by {left:.2} u, {alarms} of {trials} alarms");
        assert!(off > 2.0 && left < 1.0 && left < 0.3 * off, "{name}: plain {off} u, robust {left} u");
        assert!(alarms > 30, "{name}: {alarms} of {trials}");
    }
}
