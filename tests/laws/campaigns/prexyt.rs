//! The PreXYT against the thesis' table 3.1 and an independent implementation's sensitivity study.

use crate::support::said::Says;
use etalon::base::noise::Noise;
use etalon::identify::{Observation, ResidualKind, Settings, identify};
use etalon::robots::{PlanarPose, Prexyt, Robot};
use etalon::simulate::study::{Frame, Landing};

/// "Actual" column of table 3.1, in the order of the model; the balls are 146 mm apart.
fn truth() -> Vec<f64> {
    let deg = f64::to_radians;
    vec![
        deg(1.204),
        deg(-1.523),
        deg(-0.954),
        393.564,
        0.648,
        120.473,
        73.513,
        -72.822,
        23.246,
        -30.052,
        0.986,
        0.994,
        0.976,
        146.0,
    ]
}

fn poses(file: &str) -> Option<Vec<[f64; 3]>> {
    let path = crate::reference_data("prexyt")?.join(file);
    let mut reader = csv::Reader::from_path(path).expect("reference file");
    let row = |r: csv::StringRecord| [1, 2, 3].map(|i| r[i].parse().expect("number"));
    Some(reader.records().map(|r| row(r.expect("row"))).collect())
}

fn measure(robot: &Prexyt, poses: &[[f64; 3]], noise: &mut dyn FnMut() -> f64) -> Vec<Observation> {
    let truth = truth();
    let observe = |(i, q): (usize, &[f64; 3])| {
        let balls = robot.balls(&truth, q).map(|[x, y]| Some([x + noise(), y + noise(), 0.0]));
        Observation {
            pose: (i as i64 + 1).into(),
            cycle: 1,
            joints: q.to_vec(),
            targets: balls.to_vec(),
            ..Observation::default()
        }
    };
    poses.iter().enumerate().map(observe).collect()
}

fn settings(kind: ResidualKind) -> Settings {
    Settings { kind, standard_uncertainty_mm: Some(0.015 / 3f64.sqrt()), ..Settings::default() }
}

/// Largest xy error over the workspace of 170 mm at 0 and ±15 degrees, as the balls measure it (the reference's README).
fn largest_error(robot: &Prexyt, identified: &[f64]) -> f64 {
    let truth = truth();
    let mut worst = 0.0f64;
    let rings = (0..=8).flat_map(|r| (0..24).map(move |a| (r as f64 / 8.0 * 85.0, f64::from(a) * 15f64.to_radians())));
    for (radius, angle) in rings {
        for theta in [-15.0, 0.0, 15.0f64] {
            let command = PlanarPose {
                x_mm: 201.0 + radius * angle.cos(),
                y_mm: 137.5 + radius * angle.sin(),
                theta_rad: theta.to_radians(),
            };
            let [k, l] = robot.balls(&truth, &robot.inverse(identified, command));
            let reached = robot.measured(identified, k, l);
            worst = worst.max((reached.x_mm - command.x_mm).hypot(reached.y_mm - command.y_mm));
        }
    }
    worst
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    0.5 * (values[(values.len() - 1) / 2] + values[values.len() / 2])
}

#[test]
fn noise_free_gives_the_truth() {
    let Some(poses) = poses("eight_poses_theta_0_33.csv") else { return };
    let robot = Prexyt::default();
    let observations = measure(&robot, &poses, &mut || 0.0);
    for kind in [ResidualKind::Pose, ResidualKind::Targets] {
        let found = identify(&robot, &observations, &settings(kind)).expect("identified");
        for (i, (value, truth)) in found.values.iter().zip(truth()).enumerate() {
            if kind == ResidualKind::Pose && robot.parameters()[i].name == "l_kl" {
                continue;
            }
            assert!((value - truth).abs() < 1e-9, "{kind:?} {} {value} {truth}", robot.parameters()[i].name);
        }
    }
}

#[test]
fn hundred_seeds_are_as_good_as_an_independent_implementation() {
    let Some(poses) = poses("eight_poses_theta_0_33.csv") else { return };
    let robot = Prexyt::default();
    for (kind, reference_um) in [(ResidualKind::Pose, 11.6), (ResidualKind::Targets, 9.9)] {
        let mut errors = Vec::new();
        let mut pulls: Vec<f64> = Vec::new();
        for seed in 0..100 {
            let mut noise = Noise::new(1, seed);
            let observations = measure(&robot, &poses, &mut || noise.uniform(0.015));
            let found = identify(&robot, &observations, &settings(kind)).expect("identified");
            errors.push(1000.0 * largest_error(&robot, &found.values));
            let pull = |&i: &usize| (found.values[i] - truth()[i]) / found.standard_uncertainty(i).expect("identified");
            pulls.extend(found.free.iter().map(pull));
        }
        let median = median(errors);
        let spread = (pulls.iter().map(|p| p * p).sum::<f64>() / pulls.len() as f64).sqrt();
        println!(
            "{kind:?}: median of the largest error {median:.2} um (independent: {reference_um}), spread over covariance {spread:.3}"
        );
        assert!(median <= 1.05 * reference_um, "{kind:?} {median}");
        assert!((spread - 1.0).abs() < 0.1, "{kind:?} {spread}");
    }
}

#[test]
fn the_spread_of_each_parameter_is_its_stated_uncertainty_and_chi_square_has_its_mean() {
    let Some(poses) = poses("eight_poses_theta_0_33.csv") else { return };
    let robot = Prexyt::default();
    const SEEDS: u64 = 1000; // the spread itself is uncertain by 1/√(2·1000) = 2.2 %
    for kind in [ResidualKind::Pose, ResidualKind::Targets] {
        let mut squares = vec![0.0; robot.parameters().len()];
        let (mut chi_square, mut degrees) = (0.0, 0);
        for seed in 0..SEEDS {
            let mut noise = Noise::new(3, seed);
            let observations = measure(&robot, &poses, &mut || noise.gaussian(0.005));
            let settings = Settings { kind, standard_uncertainty_mm: Some(0.005), ..Settings::default() };
            let found = identify(&robot, &observations, &settings).expect("identified");
            // once in a thousand chi-square rejects by chance: that enlarges, and is not what is tested here
            for &i in found.free.iter().filter(|_| found.uncertainty.inflation_factor == 1.0) {
                let pull = (found.values[i] - truth()[i]) / found.standard_uncertainty(i).expect("identified");
                squares[i] += pull * pull / SEEDS as f64;
            }
            chi_square += found.residuals.chi_square.expect("stated") / SEEDS as f64;
            degrees = found.residuals.degrees_of_freedom;
        }
        for (p, square) in robot.parameters().iter().zip(&squares).filter(|s| *s.1 > 0.0) {
            assert!(
                (square.sqrt() - 1.0).abs() < 0.08,
                "{kind:?} {}: spread over uncertainty {}",
                p.name,
                square.sqrt()
            );
        }
        // the mean of N has a standard deviation of √(2·dof/N)
        let deviation = (chi_square - degrees as f64) / (2.0 * degrees as f64 / SEEDS as f64).sqrt();
        assert!(deviation.abs() < 4.0, "{kind:?}: mean chi-square {chi_square} for {degrees} degrees of freedom");
    }
}

#[test]
fn read_as_three_sigma_and_averaged_over_five_runs_the_balls_measure_two_micrometres() {
    let Some(poses) = poses("eight_poses_theta_0_33.csv") else { return };
    let robot = Prexyt::default();
    for kind in [ResidualKind::Pose, ResidualKind::Targets] {
        let error = |trial: u64| {
            let mut mean = vec![0.0; robot.parameters().len()];
            for run in 0..5 {
                let mut noise = Noise::new(4, 5 * trial + run);
                let observations = measure(&robot, &poses, &mut || noise.gaussian(0.005));
                let found = identify(&robot, &observations, &settings(kind)).expect("identified");
                mean.iter_mut().zip(&found.values).for_each(|(m, v)| *m += v / 5.0);
            }
            1000.0 * largest_error(&robot, &mean)
        };
        let mut errors: Vec<f64> = (0..100).map(error).collect();
        errors.sort_by(f64::total_cmp);
        let (low, median, high) = (errors[5], median(errors.clone()), errors[94]);
        println!("{kind:?}: largest error {median:.2} um (median), 90 % between {low:.2} and {high:.2}; thesis 2.2");
        // as the balls measure it; the true C in the base frame, which is table 3.2's error, is about four times as far off: `make thesis`
        assert!(low < 2.2 && 2.2 < high, "{low} {high}");
    }
}

/// Table 3.2 from table 3.1: the error is the true C in the base frame minus the commanded one.
#[test]
fn table_3_2_follows_from_table_3_1() {
    // what set 2₂ identified, l_kl as in truth(); printed largest and RMS errors: xy, x, y in um
    let deg = f64::to_radians;
    let identified = vec![
        deg(1.203),
        deg(-1.523),
        deg(-0.954),
        393.537,
        0.648,
        120.119,
        73.166,
        -72.826,
        23.256,
        -30.061,
        0.986,
        0.994,
        0.976,
        146.0,
    ];
    let printed = [[369.2, 362.4], [357.3, 354.5], [93.6, 74.9]];
    let robot = Prexyt::default();
    let mut errors: Vec<[f64; 2]> = Vec::new();
    let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    for i in 0..1000 {
        let (radius, angle) = (85.0 * ((f64::from(i) + 0.5) / 1000.0).sqrt(), golden * f64::from(i));
        for theta in [-15.0, 0.0, 15.0f64] {
            let (x_mm, y_mm) = (201.0 + radius * angle.cos(), 137.5 + radius * angle.sin());
            let joints = robot.inverse(&robot.nominal(), PlanarPose { x_mm, y_mm, theta_rad: theta.to_radians() });
            let landing = Landing::new(&robot, &truth(), &identified, Frame::Base, &joints).expect("reached");
            errors.push([landing.error_mm[0], landing.error_mm[1]].map(|e| 1000.0 * e));
        }
    }
    let sizes = [|e: &[f64; 2]| e[0].hypot(e[1]), |e: &[f64; 2]| e[0].abs(), |e: &[f64; 2]| e[1].abs()];
    for (size, [max, rms]) in sizes.into_iter().zip(printed) {
        let found = errors.iter().map(size).fold(0.0, f64::max);
        let mean = errors.iter().map(|e| size(e).powi(2)).sum::<f64>() / errors.len() as f64;
        println!("largest {found:.1} [{max}], RMS {:.1} [{rms}] um", mean.sqrt());
        // parameters are printed to 0.5 um and 0.0005 degrees, which is 2 um at 201 mm
        assert!((found - max).abs() < 2.0 && (mean.sqrt() - rms).abs() < 2.0, "{found} {mean}");
    }
}

#[test]
fn as_many_equations_as_parameters_tell_no_uncertainty() {
    let Some(poses) = poses("eight_poses_theta_0_33.csv") else { return };
    let robot = Prexyt::default();
    let observations = measure(&robot, &poses[..1], &mut || 0.0);
    // 4 coordinates for 4 parameters
    let kept = ["epsilon_theta", "x_o", "y_o", "l_kl"];
    let hold = robot.parameters().iter().map(|p| p.name.clone()).filter(|n| !kept.contains(&n.as_str())).collect();
    let settings = Settings { hold, ..Settings::default() };
    let found = identify(&robot, &observations, &settings).expect("identified");
    assert_eq!((found.residuals.degrees_of_freedom, found.residuals.chi_square), (0, None));
    assert!(found.free.iter().all(|&i| found.standard_uncertainty(i).is_none()));
    assert!(found.warnings.iter().any(|w| w.is("no-redundant-observations", &[])), "{:?}", found.warnings);
}

#[test]
fn full_model_finds_its_redundant_parameters() {
    let Some(poses) = poses("eight_poses_theta_0_33.csv") else { return };
    let robot = Prexyt::new(true);
    let reduced = Prexyt::default();
    let observations = measure(&reduced, &poses, &mut || 0.0);
    let found = identify(&robot, &observations, &settings(ResidualKind::Pose)).expect("identified");
    let name = |i: usize| robot.parameters()[i].name.as_str();
    let groups: Vec<(&str, Vec<&str>)> = found
        .identifiability
        .groups
        .iter()
        .map(|g| (name(g.held), g.with.iter().map(|&i| name(i)).collect()))
        .collect();
    println!("{groups:?}");
    assert_eq!(groups, [("alpha", vec!["delta1"]), ("h", vec!["d1"])]);
    for (i, truth) in truth().iter().enumerate().take(13) {
        assert!((found.values[i] - truth).abs() < 1e-9);
    }
}

#[test]
fn a_single_theta_is_warned_of() {
    let (Some(good), Some(bad)) = (poses("eight_poses_theta_0_33.csv"), poses("eight_poses_theta_17.csv")) else {
        return;
    };
    let robot = Prexyt::default();

    for kind in [ResidualKind::Pose, ResidualKind::Targets] {
        let (mut predicted, mut off) = (Vec::new(), Vec::new());
        for seed in 0..100 {
            let mut noise = Noise::new(2, seed);
            let observations = measure(&robot, &bad, &mut || noise.uniform(0.015));
            let found = identify(&robot, &observations, &settings(kind)).expect("identified");
            let names: Vec<Vec<&str>> = found
                .identifiability
                .weak
                .iter()
                .map(|w| w.parameters.iter().map(|&i| robot.parameters()[i].name.as_str()).collect())
                .collect();
            let said = found
                .warnings
                .iter()
                .any(|w| w.hint.as_deref().is_some_and(|h| h.has_phrase("measure-different-angles")));
            assert!(said, "{:?}", found.warnings);
            assert_eq!(names, [["d", "x_c"]], "{kind:?} {seed}");
            predicted.push(found.standard_uncertainty(6).expect("identified"));
            off.push((found.values[6] - truth()[6]).hypot(found.values[7] - truth()[7]));
        }
        // thirty repeats make the same two parameters better known, not better told apart
        let mut noise = Noise::new(2, 0);
        let cycle = |cycle| {
            let measured = measure(&robot, &bad, &mut || noise.uniform(0.015));
            measured.into_iter().map(move |o| Observation { cycle, ..o })
        };
        let repeated: Vec<Observation> = (1..=30).flat_map(cycle).collect();
        let found = identify(&robot, &repeated, &settings(kind)).expect("identified");
        let weak: Vec<&[usize]> = found.identifiability.weak.iter().map(|w| &w.parameters[..]).collect();
        assert_eq!(weak, [[robot.index("d").unwrap(), robot.index("x_c").unwrap()]], "{kind:?}");

        let mut noise = Noise::new(2, 0);
        let found = identify(&robot, &measure(&robot, &good, &mut || noise.uniform(0.015)), &settings(kind))
            .expect("identified");
        assert!(found.identifiability.weak.is_empty(), "{:?}", found.identifiability.weak);

        let (off, predicted) = (median(off), median(predicted));
        println!("{kind:?}: C is off by {off:.2} mm (median), u(x_c) predicted {predicted:.2} mm");
        assert!(off > 0.2 && off < 2.0 * predicted);
    }
}
