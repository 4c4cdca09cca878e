//! Tests of arms with parallel or antiparallel axes and prismatic joints: equal residuals in each
//! convention, correct covariances, and the right minimum with a held length.

use crate::{Effects, Observation, Prior, Settings, Status, identify};
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, minus, norm};
use etalon_robots::{Robot, Serial, SerialJoint, TableConvention, modified_table, standard_table};
use nalgebra::DMatrix;

/// Row of a modified table: alpha (deg), a (mm), theta (deg), d (mm), and `true` for a prismatic
/// joint.
type Row = (f64, f64, f64, f64, bool);

const SCARA: &[Row] = &[
    (0.0, 0.0, 0.0, 350.0, false),
    (0.0, 400.0, 0.0, 0.0, false),
    (180.0, 300.0, 0.0, 0.0, true),
    (0.0, 0.0, 0.0, 0.0, false),
];
const ARMS: [(&str, &[Row]); 7] = [
    ("quill antiparallel", SCARA),
    (
        "quill parallel",
        &[
            (0.0, 0.0, 0.0, 350.0, false),
            (0.0, 400.0, 0.0, 0.0, false),
            (0.0, 300.0, 0.0, 0.0, true),
            (0.0, 0.0, 0.0, 0.0, false),
        ],
    ),
    (
        "quill last",
        &[
            (0.0, 0.0, 0.0, 350.0, false),
            (0.0, 400.0, 0.0, 0.0, false),
            (180.0, 300.0, 0.0, 0.0, false),
            (0.0, 0.0, 0.0, 0.0, true),
        ],
    ),
    (
        "on a column",
        &[
            (0.0, 0.0, 0.0, 0.0, true),
            (0.0, 100.0, 0.0, 350.0, false),
            (0.0, 400.0, 0.0, 0.0, false),
            (180.0, 300.0, 0.0, 0.0, false),
        ],
    ),
    (
        "cylindrical",
        &[
            (0.0, 0.0, 0.0, 200.0, false),
            (0.0, 0.0, 0.0, 300.0, true),
            (-90.0, 0.0, 0.0, 400.0, true),
            (90.0, 0.0, 0.0, 0.0, false),
        ],
    ),
    (
        "gantry",
        &[
            (0.0, 0.0, 0.0, 0.0, true),
            (90.0, 0.0, 90.0, 0.0, true),
            (90.0, 0.0, 0.0, 0.0, true),
            (180.0, 0.0, 0.0, 0.0, false),
        ],
    ),
    (
        "gantry with telescope",
        &[
            (0.0, 0.0, 0.0, 0.0, true),
            (90.0, 0.0, 90.0, 0.0, true),
            (90.0, 0.0, 0.0, 0.0, true),
            (0.0, 0.0, 0.0, 0.0, true),
            (180.0, 0.0, 0.0, 0.0, false),
        ],
    ),
];

const NOISE_MM: f64 = 0.015;

/// Errors of a SCARA: length and offset (mm), zero and tilts (rad). Axis 2 leans by half a
/// milliradian, so that a length of 0.3 mm is a height of 600 mm.
const BUILT: [[f64; 5]; 4] = [
    [0.0, 0.0, 8.727e-4, 5.236e-4, -5.236e-4],
    [0.3, 0.0, -8.727e-4, 5.236e-4, 5.236e-4],
    [-0.3, 0.2, 0.0, -5.236e-4, 5.236e-4],
    [0.0, 0.0, 8.727e-4, 5.236e-4, -5.236e-4],
];

/// Robot of the rows; `parallel` decides about the flag of Hayati's angle by row.
fn table(rows: &[Row], parallel: impl Fn(usize) -> bool, targets: &[String]) -> Serial {
    let joint = |(k, row): (usize, &Row)| SerialJoint {
        alpha_rad: row.0.to_radians(),
        a_mm: row.1,
        theta_rad: row.2.to_radians(),
        d_mm: row.3,
        prismatic: row.4,
        parallel: parallel(k),
    };
    let joints: Vec<SerialJoint> = rows.iter().enumerate().map(joint).collect();
    Serial::from_axis_table(TableConvention::Modified, &joints, targets)
}

/// Flange of an arm with errors of every row: length, offset and zero, and the tilts of the axis
/// about x and y.
fn flange(rows: &[Row], errors: &[[f64; 5]], q: &[f64]) -> Pose {
    let place = |pose: Pose, ((row, e), q): ((&Row, &[f64; 5]), &f64)| {
        let [turned, slid] = if row.4 { [0.0, *q] } else { [*q, 0.0] };
        let tilt = Pose::from_rotation_vector([e[3], e[4], 0.0]);
        let link = pose.turn_x(row.0.to_radians()).shift(0, row.1 + e[0]).then(&tilt);
        link.turn_z(row.2.to_radians() + e[2] + turned).shift(2, row.3 + e[1] + slid)
    };
    rows.iter().zip(errors).zip(q).fold(Pose::identity(), place)
}

/// Errors of every row: length and offset (mm), zero and tilts (rad).
fn drawn(rows: &[Row], seed: u64) -> Vec<[f64; 5]> {
    let mut noise = Noise::new(54, seed);
    rows.iter().map(|_| [0.3, 0.3, 1e-3, 6e-4, 6e-4].map(|size| noise.uniform(size))).collect()
}

/// Readings of targets on an arm with errors in all directions.
fn readings(rows: &[Row], errors: &[[f64; 5]], seed: u64, poses: i64, targets: &[[f64; 3]]) -> Vec<Observation> {
    let mut noise = Noise::new(53, seed);
    let base = Pose::from_xyz_rpy([2500.0, -800.0, -300.0], [0.0209, 0.0, 0.6458]);
    let one = |i: i64| {
        let joints: Vec<f64> =
            rows.iter().map(|row| if row.4 { 100.0 + noise.uniform(100.0) } else { noise.uniform(2.4) }).collect();
        let flange = base.then(&flange(rows, errors, &joints));
        let seen = |target: &[f64; 3]| Some(flange.apply(*target).map(|v| v + noise.gaussian(NOISE_MM)));
        let targets = targets.iter().map(seen).collect();
        Observation { pose: i.into(), cycle: 1, joints, targets, ..Observation::default() }
    };
    (0..poses).map(one).collect()
}

fn settings(hold: &[&str]) -> Settings {
    let hold = hold.iter().map(|&name| name.to_owned()).collect();
    Settings {
        standard_uncertainty_mm: Some(NOISE_MM),
        hold,
        prior: Prior::TOLERANCES,
        effects: Effects::Usual,
        ..Settings::default()
    }
}

fn misses(robot: &dyn Robot, values: &[f64], observations: &[Observation]) -> Vec<f64> {
    let of = |o: &Observation| {
        let seen = o.targets.iter().enumerate().filter_map(|(k, seen)| Some((k, (*seen)?)));
        seen.map(|(k, seen)| norm(minus(robot.position(values, &o.joints, k), seen))).collect::<Vec<f64>>()
    };
    observations.iter().flat_map(of).collect()
}

/// The errors are the noise, because the model is complete in every convention.
#[test]
fn arms_have_the_same_residuals_in_each_convention() {
    let places = [[80.0, 10.0, 25.0], [-60.0, 50.0, 40.0], [20.0, -70.0, -30.0]];
    let names = ["a", "b", "c"].map(str::to_owned);
    for (seed, (name, rows)) in (0..).zip(ARMS) {
        let observations = readings(rows, &drawn(rows, seed), seed, 60, &places);
        let nominal = table(rows, |_| false, &names);
        let (axes, home) = nominal.joint_chain(&nominal.nominal()).unwrap().axes();
        let robots = [
            Serial::from_axis_table(TableConvention::Modified, &modified_table(&axes, &home).joints, &names),
            Serial::from_axis_table(TableConvention::Standard, &standard_table(&axes, &home).joints, &names),
            Serial::from_axes(&axes, &home, &names),
        ];
        let found = robots.map(|robot| {
            let found = identify(&robot, &observations, &settings(&[])).unwrap();
            println!("{name}: {} parameters, rms {:.6} mm", found.free.len(), found.residuals.rms);
            (found.free.len(), misses(&robot, &found.values, &observations), found.residuals.rms)
        });
        for (free, misses, rms) in &found {
            assert_eq!(*free, found[2].0, "{name}");
            let off = misses.iter().zip(&found[2].1).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 0.05 * NOISE_MM, "{name}: {off}");
            // of each coordinate
            assert!(*rms < NOISE_MM * 1.1, "{name}: {rms}");
        }
    }
}

/// A covariance from residuals that are alike in regions, where a coordinate of the base is hardly
/// determined: symmetric, without negative variances, and with correlations up to 1.
#[test]
fn covariances_of_hardly_determined_parameters_are_sound() {
    for poses in [40, 200] {
        let observations = readings(SCARA, &BUILT, 7, poses, &[[80.0, 0.0, 25.0]]);
        // the tilt of the quill is missing
        let robot = table(SCARA, |k| k == 1 || k == 3, &["SMR".to_owned()]);
        let found = identify(&robot, &observations, &settings(&[])).unwrap();
        let n = found.free.len();
        let c = DMatrix::from_row_slice(n, n, found.uncertainty.covariance.as_ref().unwrap());
        println!("{:?} {:e}", found.uncertainty.from, (&c - c.transpose()).amax());
        assert!(c == c.transpose(), "{:e}", (&c - c.transpose()).amax());
        let u: Vec<f64> = (0..n).map(|k| c[(k, k)].sqrt()).collect();
        let correlations = DMatrix::from_fn(n, n, |i, j| c[(i, j)] / (u[i] * u[j]));
        assert!(correlations.amax() <= 1.0 + 1e-12, "{}", correlations.amax() - 1.0);
        let least = correlations.symmetric_eigenvalues().min();
        assert!(least > -1e-12, "{least:e}");
    }
}

/// A held length of a link between nearly parallel axes is a choice of the height of the base: the
/// residuals are the same as without.
#[test]
fn a_held_length_between_parallel_axes_costs_no_residuals() {
    for seed in 0..4 {
        let observations = readings(SCARA, &BUILT, seed, 40, &[[80.0, 0.0, 25.0]]);
        let robot = table(SCARA, |k| k > 0, &["SMR".to_owned()]);
        let free = identify(&robot, &observations, &settings(&[])).unwrap();
        let held = identify(&robot, &observations, &settings(&["a_2"])).unwrap();
        let z = robot.index("base_z").unwrap();
        println!(
            "{seed}: rms {} {}, base_z {} {}",
            free.residuals.rms, held.residuals.rms, free.values[z], held.values[z]
        );
        assert!(
            (held.residuals.rms - free.residuals.rms).abs() < 0.01 * free.residuals.rms,
            "{seed}: {} {}",
            held.residuals.rms,
            free.residuals.rms
        );
        // the height of the base by measurement: the length is identified
        let mut robot = table(SCARA, |k| k > 0, &["SMR".to_owned()]);
        let mut nominal = robot.nominal();
        nominal[z] = -300.0;
        robot.definition_mut().set_nominal(&nominal);
        let stated = identify(&robot, &observations, &settings(&["base_z"])).unwrap();
        let a = robot.index("a_2").unwrap();
        println!("{seed}: base_z {} a_2 {} rms {}", stated.values[z], stated.values[a], stated.residuals.rms);
        assert!(stated.status[a] == Status::Identified && stated.values[z] == -300.0);
        assert!((stated.values[a] - 400.3).abs() < 0.1, "{}", stated.values[a]);
    }
}
