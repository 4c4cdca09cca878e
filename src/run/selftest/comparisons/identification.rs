//! Identification: exact observations of each model give its parameters back, and a whole campaign
//! (exports, frames, join) the true values behind its files.

use crate::run::pipeline::evaluate;
use crate::run::selftest::data::{Data, Slip};
use crate::run::selftest::row::{Rows, Subject, not_made};
use crate::run::selftest::sample::{Scratch, inward, positions, robot};
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::phrase;
use etalon_documents::Results;
use etalon_identify::{Effects, Observation, Prior, Settings, identify};
use etalon_robots::{Parameter, Quantity};

pub(crate) const SUBJECT: Subject = Subject {
    id: "identification",
    requirement: || phrase!("selftest-identification"),
    rows,
    slips: &[
        Slip::Digit("/truth/parameters/s", 5),
        Slip::Swap("/truth/parameters/x_c", "/truth/parameters/y_c"),
        Slip::Unit("/truth/parameters/beta", std::f64::consts::PI / 180.0),
    ],
};

/// Poses of a simulated measurement.
const POSES: usize = 40;
/// Maximum change of a joint about the joint values of the reference data (rad, mm).
const ABOUT: [f64; 2] = [0.35, 25.0];
/// Maximum deviation of the campaign's parameters, in their standard uncertainties: of 14 normal
/// numbers one exceeds it in a thousand campaigns. The files do not change.
const LARGEST: f64 = 4.0;

fn rows(data: &Data) -> Vec<Rows> {
    let mut exact = Rows::new("exact observations");
    for item in data.at("/kinematics").items() {
        let name = item.text("/model");
        match recovered(&item) {
            Ok(error_mm) => exact.add(phrase!("selftest-recovered", name), "mm", [0.0, error_mm], 1e-6),
            Err(problems) => exact.failed(not_made(name, &problems)),
        }
    }
    vec![exact, campaign(&data.at("/truth/parameters"))]
}

/// Error of the positions by parameters that were identified from exact observations.
fn recovered(item: &Data) -> Result<f64> {
    let planar = ["prexyt", "five_bar"].contains(&item.text("/model"));
    let targets: &[&str] = match item.text("/model") {
        "prexyt" => &["K", "L"],
        "five_bar" => &["ball"],
        _ => &["ball", "second", "third"],
    };
    let robot = robot(item.text("/robot"), item.text("/urdf"), targets)?;
    let robot = robot.as_ref();
    let truth: Vec<f64> = robot.parameters().iter().enumerate().map(|(i, p)| p.nominal + deviation(i, p)).collect();
    let joints: Vec<Vec<f64>> = item.at("/joints").items().iter().map(|q| inward(robot, &q.numbers(""))).collect();
    let mut noise = Noise::new(46, 0);
    let count = robot.joints().len();
    let mut observations = Vec::new();
    for pose in 0..POSES {
        let mut q = joints[pose % joints.len()].clone();
        for (joint, q) in robot.joints().iter().zip(&mut q[..count]) {
            *q += noise.uniform(ABOUT[usize::from(joint.quantity == Quantity::Length)]);
        }
        let at: Vec<f64> = positions(robot, &truth, &q);
        if at.iter().all(|v| v.is_finite()) {
            let targets = at.chunks_exact(3).map(|p| Some([p[0], p[1], if planar { 0.0 } else { p[2] }])).collect();
            observations.push(Observation {
                pose: (pose as i64).into(),
                cycle: 1,
                joints: q,
                targets,
                ..Observation::default()
            });
        }
    }
    let settings = Settings {
        standard_uncertainty_mm: Some(0.01),
        prior: Prior::None,
        effects: Effects::All,
        ..Settings::default()
    };
    let found = identify(robot, &observations, &settings).map_err(crate::stages::remedies::remedied)?;
    let off = |q: &Vec<f64>| {
        let [a, b] = [&truth, &found.values].map(|values| positions(robot, values, q));
        a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    Ok(joints.iter().map(off).fold(0.0, |worst: f64, d| if d.is_nan() { f64::INFINITY } else { worst.max(d) }))
}

/// A deviation from nominal of the size of a manufacturing error.
fn deviation(i: usize, parameter: &Parameter) -> f64 {
    let wave = (1.7 * i as f64 + 0.4).sin();
    wave * match parameter.quantity {
        Quantity::Length => 0.2,
        Quantity::Angle => 1e-3,
        Quantity::Ratio => 2e-4,
    }
}

/// Parameters of the embedded campaign against the true values of its simulation.
fn campaign(truth: &Data) -> Rows {
    let mut rows = Rows::new("thesis, table 3.3");
    let evaluated = Scratch::campaign().and_then(|scratch| evaluate(&scratch.read()?));
    let Results { identified: Some(identified), .. } = (match evaluated {
        Ok(evaluated) => evaluated.results,
        Err(problems) => {
            rows.failed(not_made("prexyt-cmm", &problems));
            return rows;
        }
    }) else {
        rows.failed(not_made("prexyt-cmm", &""));
        return rows;
    };
    let mut largest = 0.0f64;
    for (name, value) in truth.entries() {
        let entry = identified.parameters.parameters.iter().find(|p| p.name == name);
        let ratio = entry.and_then(|p| Some((p.value - value).abs() / p.standard_uncertainty?));
        largest = largest.max(ratio.filter(|ratio| ratio.is_finite()).unwrap_or(f64::INFINITY));
    }
    rows.add(phrase!("selftest-truth", name = "prexyt-cmm"), "u", [0.0, largest], LARGEST);
    let residuals = &identified.parameters.residuals;
    let (chi, degrees) = (residuals.test.chi_square.unwrap_or(f64::NAN), residuals.degrees_of_freedom as f64);
    // three standard deviations of chi-square over its degrees of freedom
    rows.add(phrase!("selftest-chi-square"), "", [1.0, chi / degrees], 3.0 * (2.0 / degrees).sqrt());
    rows
}
