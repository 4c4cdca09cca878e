//! A QKM HL6 with a FARO tracker (real data): 46 poses, each with one of three reflectors of the tool, whose places relative to each
//! other were measured beforehand.

use crate::support::arms::serial;
use etalon::base::pose::{minus, norm};
use etalon::identify::{Observation, RigidPart, Settings, fit_frames, identify_from};
use etalon::robots::{Robot, Serial};

/// Nominal geometry by the README of the set.
fn arm() -> Serial {
    let rows = [
        [0.0, 0.0, 0.0, 491.0],
        [-90.0, 0.0, -90.0, 0.0],
        [0.0, 350.0, -90.0, 0.0],
        [-90.0, 0.0, 0.0, 350.0],
        [90.0, 0.0, 0.0, 0.0],
        [-90.0, 0.0, 0.0, 84.0],
    ];
    serial(&rows, &["SMR_1", "SMR_2", "SMR_3"], &[])
}

fn numbers(file: &str) -> Option<Vec<Vec<f64>>> {
    let folder = crate::reference_data("robots/qkm_polyworks")?;
    let text = std::fs::read_to_string(folder.join(file)).unwrap();
    let row = |line: &str| line.split([' ', '\t', ',']).filter_map(|cell| cell.trim().parse().ok()).collect();
    Some(text.lines().filter(|line| !line.trim().is_empty()).map(row).collect())
}

fn observations() -> Option<Vec<Observation>> {
    let (angles, points) = (numbers("data_points_cali__c_angles.txt")?, numbers("data_points_cali__c_poses.txt")?);
    let observation = |(i, (q, p)): (usize, (&Vec<f64>, &Vec<f64>))| {
        let mut targets = vec![None; 3];
        targets[q[6] as usize - 1] = Some([p[0], p[1], p[2]]);
        Observation {
            pose: (i as i64).into(),
            cycle: 1,
            joints: q[..6].iter().map(|q| q.to_radians()).collect(),
            targets,
            ..Observation::default()
        }
    };
    Some(angles.iter().zip(&points).enumerate().map(observation).collect())
}

fn settings(rigid: Vec<RigidPart>) -> Settings {
    Settings { standard_uncertainty_mm: Some(0.01), rigid, ..Settings::default() }
}

fn plate() -> Option<RigidPart> {
    let places = numbers("data_points_cali__re_smr.txt")?;
    Some(RigidPart {
        targets: ["SMR_1", "SMR_2", "SMR_3"].map(str::to_owned).to_vec(),
        places_mm: places.iter().map(|p| [p[0], p[1], p[2]]).collect(),
        standard_uncertainty_mm: 0.01,
        tolerance_mm: 1.0,
        weight: 1.0,
    })
}

fn errors(robot: &Serial, values: &[f64], observations: &[Observation]) -> Vec<f64> {
    let of = |o: &Observation| {
        let (k, at) = o.targets.iter().enumerate().find_map(|(k, t)| Some((k, (*t)?))).unwrap();
        norm(minus(at, robot.position(values, &o.joints, k)))
    };
    observations.iter().map(of).collect()
}

#[test]
fn a_reflector_seen_once_has_its_place_from_the_others() {
    let (Some(all), Some(part)) = (observations(), plate()) else { return };
    let robot = arm();
    let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
    // of each reflector one reading is used in turn, and the others are predicted
    let of_target = |rigid: &[RigidPart], target: usize| -> f64 {
        let settings = settings(rigid.to_vec());
        let seen = all.iter().filter(|o| o.targets[target].is_some());
        let errors = seen.map(|once| {
            let (used, left): (Vec<_>, Vec<_>) =
                all.iter().cloned().partition(|o| o.targets[target].is_none() || o.pose == once.pose);
            let before = fit_frames(&robot, &used, &settings).unwrap();
            mean(&errors(&robot, &identify_from(&robot, &used, &settings, &before).unwrap().values, &left))
        });
        mean(&errors.collect::<Vec<f64>>())
    };
    let of = |rigid: &[RigidPart]| mean(&[0, 1, 2].map(|target| of_target(rigid, target)));
    let (alone_mm, with_mm) = (of(&[]), of(&[part]));
    println!(
        "mean error of a reflector seen once: {alone_mm:.3} mm, with the stated shape {with_mm:.3} mm (0.298 and 0.216)"
    );
    assert!(with_mm < 0.23 && with_mm < 0.85 * alone_mm, "{alone_mm} {with_mm}");
}
