//! The error to expect over the workspace, and how well readings and poses are controlled: against draws, and against identifications again.

use crate::support::scratch::copy_sample;
use etalon::base::noise::Noise;
use etalon::base::pose::{minus, norm};
use etalon::campaign::Campaign;
use etalon::identify::{
    CRITICAL_W, Observation, Settings, ToolPoint, UncertaintyFrom, identify_again, identify_from, reliability,
};
use etalon::robots::Robot;
use etalon::run::pipeline::{self, Evaluated};
use etalon::stages::calibrate::identification::IdentifiedSolution;
use nalgebra::{DMatrix, DVector};

const DRAWS: u64 = 4000;

#[test]
fn the_map_agrees_with_draws_of_the_parameters() {
    let (name, planar) = ("prexyt-cmm", true);
    let (robot, evaluated) = evaluated(name);
    let found = evaluated.solution.unwrap();
    let accuracy = evaluated.results.identified.unwrap().accuracy;
    let map = accuracy.map.as_ref().unwrap();
    let point = ToolPoint { point_mm: map.point_mm, frame: map.frame.into(), standard_uncertainty_mm: 0.0 };
    assert!((20..=300).contains(&map.nodes.len()), "{name}: {}", map.nodes.len());

    let (values, free) = (&found.found.values, &found.found.free);
    let n = free.len();
    let covariance = DMatrix::from_row_slice(n, n, found.found.uncertainty.covariance.as_ref().unwrap());
    let scale = DMatrix::from_diagonal(&covariance.diagonal().map(f64::sqrt));
    let correlation = DMatrix::from_fn(n, n, |i, j| covariance[(i, j)] / (scale[(i, i)] * scale[(j, j)]));
    let root = &scale * correlation.cholesky().unwrap().l();
    let (mut within, mut worst) = (Vec::new(), 0.0f64);
    for node in map.nodes.iter().step_by(map.nodes.len() / 5) {
        let joint = robot.joints().iter().zip(&node.joints);
        let joints: Vec<f64> = joint.map(|(joint, v)| joint.quantity.inward(*v)).collect();
        let at = point.in_base(robot.as_ref(), values, &joints).unwrap();
        assert!(norm(minus(at, node.at_mm)) < 1e-6, "{name}: the node is at {at:?}, not at {:?}", node.at_mm);
        assert!(!planar || node.at_mm[2] == 0.0);
        let size = |trial: u64| {
            let mut noise = Noise::new(11, trial);
            let step = &root * DVector::from_fn(n, |_, _| noise.gaussian(1.0));
            // all else, as it is stated: alike in all directions
            let others = (node.standard_uncertainty_mm.powi(2) - node.parameters_mm.powi(2)).max(0.0);
            let axes = if planar { 2 } else { 3 };
            let aside: [f64; 3] = std::array::from_fn(|i| match i < axes {
                true => noise.gaussian((others / axes as f64).sqrt()),
                false => 0.0,
            });
            let mut drawn = values.clone();
            free.iter().zip(step.iter()).for_each(|(&i, step)| drawn[i] += step);
            let error = minus(point.in_base(robot.as_ref(), &drawn, &joints).unwrap(), at);
            [norm(error), norm(std::array::from_fn(|i| error[i] + aside[i]))]
        };
        let sizes: Vec<[f64; 2]> = (0..DRAWS).map(size).collect();
        let rms = (sizes.iter().map(|s| s[0] * s[0]).sum::<f64>() / DRAWS as f64).sqrt();
        worst = worst.max((rms / node.parameters_mm - 1.0).abs());
        within.push(sizes.iter().filter(|s| s[1] <= node.p95_mm).count() as f64 / DRAWS as f64);
        assert!(node.standard_uncertainty_mm >= node.parameters_mm && node.p95_mm > node.standard_uncertainty_mm);
    }
    // an estimated standard deviation of 4,000 sizes scatters by 1.1 %
    assert!(worst < 0.04, "{name}: draws differ by {worst} from the linear standard uncertainty");
    assert!(within.iter().all(|share| (share - 0.95).abs() < 0.015), "{name}: {within:?}");
}

/// Observations of a sample's poses as its identified robot makes them, with this noise.
pub(super) fn drawn(robot: &dyn Robot, found: &IdentifiedSolution, trial: u64) -> Vec<Observation> {
    let mut noise = Noise::new(12, trial);
    let mut see = |o: &Observation| {
        let at = |k: usize| robot.position(&found.found.values, &o.joints, k);
        let mut noisy = |k: usize| {
            let mut at = at(k);
            at[..robot.dimension()].iter_mut().for_each(|v| *v += noise.gaussian(U_MM));
            at
        };
        let targets = o.targets.iter().enumerate().map(|(k, seen)| seen.map(|_| noisy(k))).collect();
        Observation { targets, covariances_mm2: Vec::new(), ..o.clone() }
    };
    found.sets.calibration.iter().map(&mut see).collect()
}

pub(super) const U_MM: f64 = 0.01;

fn evaluated(name: &str) -> (Box<dyn Robot>, Evaluated) {
    let scratch = copy_sample(name);
    let campaign = Campaign::read(&scratch.path()).unwrap();
    let evaluated = pipeline::evaluate(&campaign).unwrap();
    (campaign.build_robot_with(&[]).unwrap(), evaluated)
}

pub(super) fn sample(name: &str) -> (Box<dyn Robot>, IdentifiedSolution) {
    let (robot, evaluated) = evaluated(name);
    (robot, evaluated.solution.unwrap())
}

#[test]
fn errors_of_a_reading_are_detected_as_often_as_baarda_has_it() {
    let (robot, found) = sample("prexyt-cmm");
    let (robot, settings) = (robot.as_ref(), Settings { standard_uncertainty_mm: Some(U_MM), ..Settings::default() });
    let (mut detected, mut alarms, mut count) = (0.0, 0.0, 0.0);
    for trial in 0..300 {
        let mut observations = drawn(robot, &found, trial);
        let plain = identify_from(robot, &observations, &settings, &found.found.values).unwrap();
        let before = reliability(robot, &observations, &settings, &plain).unwrap().unwrap();
        let i = trial as usize % observations.len();
        let least = before.readings[i][0].unwrap();
        // the coordinate that is controlled least has the largest detectable error: both are tried, the mean of the two is no better
        observations[i].targets[0].as_mut().unwrap()[trial as usize % 2] += least.detectable_mm;
        let mut wrong = plain.clone();
        wrong.values = identify_again(robot, &observations, &settings, &plain).unwrap();
        wrong.uncertainty.from = UncertaintyFrom::Instrument;
        let after = reliability(robot, &observations, &settings, &wrong).unwrap().unwrap();
        detected += f64::from(u8::from(after.readings[i][0].unwrap().w > CRITICAL_W));
        alarms += before.readings.iter().flatten().flatten().filter(|r| r.w > CRITICAL_W).count() as f64;
        count += 2.0 * before.readings.iter().flatten().flatten().count() as f64;
        let redundancy: f64 = before.readings.iter().flatten().flatten().map(|r| r.redundancy).sum::<f64>() * 2.0;
        assert!(
            redundancy <= plain.residuals.degrees_of_freedom as f64
                && redundancy > 0.8 * plain.residuals.degrees_of_freedom as f64
        );
    }
    // 80 %, or a little more where the other coordinate has the least redundancy; 2.3 % standard deviation
    assert!((0.73..0.93).contains(&(detected / 300.0)), "{}", detected / 300.0);
    assert!((0.0005..0.0016).contains(&(alarms / count)), "{}", alarms / count);
}

/// Cook's distance by its definition: how far the positions of all readings move where a pose is left out. The parameters of the arm are weakly
/// determined, and its error is not linear in them: their change is tried with the table.
#[test]
fn the_influence_of_a_pose_is_what_the_fit_changes_by_without_it() {
    for name in ["prexyt-cmm", "column-arm"] {
        let (robot, found) = sample(name);
        let (robot, settings) =
            (robot.as_ref(), Settings { standard_uncertainty_mm: Some(U_MM), ..Settings::default() });
        let observations = drawn(robot, &found, 1);
        let plain = identify_from(robot, &observations, &settings, &found.found.values).unwrap();
        assert_eq!(plain.uncertainty.from, UncertaintyFrom::Instrument, "{name}");
        let poses = reliability(robot, &observations, &settings, &plain).unwrap().unwrap().poses;
        assert!(poses.windows(2).all(|pair| pair[0].cooks_distance >= pair[1].cooks_distance));
        let n = plain.free.len();
        for influence in poses.iter().filter(|p| p.cooks_distance.is_finite()).step_by(3).take(3) {
            let rest: Vec<Observation> = observations.iter().filter(|o| o.pose != influence.pose).cloned().collect();
            let values = identify_again(robot, &rest, &settings, &plain).unwrap();
            let seen =
                |o: &Observation| o.targets.iter().enumerate().filter(|(_, t)| t.is_some()).map(|t| t.0).collect();
            let moved = observations.iter().flat_map(|o| {
                let targets: Vec<usize> = seen(o);
                let at = |p: &[f64], k: usize| robot.position(p, &o.joints, k);
                targets
                    .into_iter()
                    .map(|k| norm(minus(at(&plain.values, k), at(&values, k))).powi(2))
                    .collect::<Vec<_>>()
            });
            let distance = moved.sum::<f64>() / (n as f64 * U_MM * U_MM);
            assert!((distance / influence.cooks_distance - 1.0).abs() < 0.02, "{name} {influence:?}: {distance}");
            let k = influence.parameter;
            let change = (plain.values[k] - values[k]).abs() / plain.standard_uncertainty(k).unwrap();
            assert!(
                name == "column-arm" || (change / influence.change_over_u - 1.0).abs() < 0.02,
                "{influence:?}: {change}"
            );
        }
    }
}
