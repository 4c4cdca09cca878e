//! Arms with two to four joints, whose geometry leaves more untold than base and targets: what is told must be right.

use etalon::base::noise::Noise;
use etalon::identify::{Identification, Observation, Settings, Status, identify};
use etalon::robots::{Quantity, Robot, Role, Serial, SerialJoint};
use std::f64::consts::FRAC_PI_2;

const NOISE_MM: f64 = 0.01;

fn turning(alpha_rad: f64, a_mm: f64, d_mm: f64, parallel: bool) -> SerialJoint {
    SerialJoint { alpha_rad, a_mm, theta_rad: 0.0, d_mm, prismatic: false, parallel }
}

fn sliding(alpha_rad: f64, theta_rad: f64, parallel: bool) -> SerialJoint {
    SerialJoint { alpha_rad, a_mm: 0.0, theta_rad, d_mm: 0.0, prismatic: true, parallel }
}

/// Two turning joints; a SCARA; three slides at right angles.
fn arms() -> [(&'static str, Vec<SerialJoint>); 3] {
    let two = vec![turning(0.0, 0.0, 0.0, false), turning(0.0, 300.0, 0.0, true)];
    let scara = vec![
        turning(0.0, 0.0, 200.0, false),
        turning(0.0, 250.0, 0.0, true),
        turning(0.0, 200.0, 0.0, true),
        sliding(0.0, 0.0, true),
    ];
    let gantry =
        vec![sliding(0.0, 0.0, false), sliding(-FRAC_PI_2, -FRAC_PI_2, false), sliding(-FRAC_PI_2, -FRAC_PI_2, false)];
    [("two joints", two), ("scara", scara), ("gantry", gantry)]
}

/// A robot that is wrong by about a millimetre and a milliradian, seen from anywhere.
fn truth(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
    let value = |p: &etalon::robots::Parameter, noise: &mut Noise| match (p.role, p.quantity) {
        (Role::Base, Quantity::Length) => noise.uniform(2000.0),
        (Role::Base, _) => noise.uniform(1.2),
        (Role::Target, _) => noise.uniform(150.0),
        (_, Quantity::Ratio) => 1.0 + noise.uniform(1e-3),
        (_, Quantity::Length) => p.nominal + noise.uniform(0.5),
        (_, Quantity::Angle) => p.nominal + noise.uniform(2e-3),
    };
    robot.parameters().iter().map(|p| value(p, noise)).collect()
}

fn observe(robot: &dyn Robot, truth: &[f64], poses: usize, sigma_mm: f64, noise: &mut Noise) -> Vec<Observation> {
    let observe = |i: usize| {
        let range = |q: &etalon::robots::Joint| if q.quantity == Quantity::Length { 200.0 } else { 1.5 };
        let joints: Vec<f64> = robot.joints().iter().map(|q| noise.uniform(range(q))).collect();
        let mut target = |k: usize| robot.position(truth, &joints, k).map(|v| v + noise.gaussian(sigma_mm));
        let targets = (0..robot.targets().len()).map(|k| Some(target(k))).collect();
        Observation { pose: (i as i64).into(), cycle: 1, joints, targets, ..Observation::default() }
    };
    (0..poses).map(observe).collect()
}

fn settings() -> Settings {
    Settings { standard_uncertainty_mm: Some(NOISE_MM), ..Settings::default() }
}

/// Root mean square distance between truth and prediction on fresh poses.
fn off_mm(robot: &dyn Robot, truth: &[f64], found: &Identification, noise: &mut Noise) -> f64 {
    let fresh = observe(robot, truth, 50, 0.0, noise);
    let mut sum = (0.0, 0);
    for o in &fresh {
        for (k, expected) in o.targets.iter().enumerate() {
            let p = robot.position(&found.values, &o.joints, k);
            sum.0 += etalon::base::pose::norm(etalon::base::pose::minus(p, expected.unwrap())).powi(2);
            sum.1 += 1;
        }
    }
    (sum.0 / f64::from(sum.1)).sqrt()
}

#[test]
fn what_is_told_is_useful_and_predicts_fresh_poses() {
    let names = ["A", "B", "C"].map(str::to_owned);
    for (name, joints) in arms() {
        for targets in [1, 3] {
            let robot = Serial::new(&joints, &names[..targets], [0.0, 0.0, -1.0], &[], &[]);
            let (mut chi_square, mut degrees) = (0.0, 0.0);
            for seed in 0..8 {
                let mut noise = Noise::new(31, seed);
                let truth = truth(&robot, &mut noise);
                let observations = observe(&robot, &truth, 60, NOISE_MM, &mut noise);
                let found = identify(&robot, &observations, &settings()).expect(name);
                chi_square += found.residuals.chi_square.unwrap();
                degrees += found.residuals.degrees_of_freedom as f64;

                // n parameters leave a prediction uncertain by the noise times √(n/m), in each of three coordinates
                let n = found.free.len() as f64;
                let expected = NOISE_MM * (3.0 * n / (n + found.residuals.degrees_of_freedom as f64)).sqrt();
                let off = off_mm(&robot, &truth, &found, &mut noise);
                assert!(off < 2.0 * expected, "{name}, {targets} targets, seed {seed}: off by {off} mm");
                for (i, p) in robot.parameters().iter().enumerate() {
                    let limit = match p.quantity {
                        Quantity::Length => 100.0,
                        Quantity::Angle => 0.2,
                        Quantity::Ratio => 0.05,
                    };
                    let u = found.standard_uncertainty(i);
                    assert_eq!(u.is_some(), found.status[i] == Status::Identified);
                    assert!(u.is_none_or(|u| u < limit), "{name}, seed {seed}: u({}) = {u:?}", p.name);
                }
            }
            let deviation = (chi_square - degrees) / (2.0 * degrees).sqrt();
            assert!(deviation.abs() < 4.0, "{name}, {targets} targets: chi-square off by {deviation} sigma");
        }
    }
}
