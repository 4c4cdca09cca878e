//! Characteristics of ISO 9283 against a second implementation, written from the formulas in another way, and by laws.

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::standards::iso9283::pose::accuracy::{angle_accuracy_rad, pose_accuracy};
use etalon::standards::iso9283::pose::coplanarity::coplanarity;
use etalon::standards::iso9283::pose::directions::{angle_variation_rad, variation};
use etalon::standards::iso9283::pose::distance::{angle_distance_rad, distance};
use etalon::standards::iso9283::pose::drift::drift;
use etalon::standards::iso9283::pose::exchangeability::exchangeability;
use etalon::standards::iso9283::pose::repeatability::{angle_repeatability_rad, pose_repeatability};
use etalon::standards::iso9283::statistics::bootstrap::Bootstrap;
use etalon::standards::iso9283::statistics::interval::{accuracy_interval, repeatability_interval};
use etalon::standards::iso9283::statistics::uncertainty_ratio::uncertainty_ratio;
use rayon::prelude::*;
use std::f64::consts::PI;

const AT: Vector = [500.0, -300.0, 800.0];

/// Positions about `at`, with a scatter that differs by axis.
pub fn cloud(noise: &mut Noise, n: usize, at: Vector, sigma: Vector) -> Vec<Vector> {
    (0..n).map(|_| [0, 1, 2].map(|k| at[k] + noise.gaussian(sigma[k]))).collect()
}

fn clouds(trial: u64, count: usize) -> Vec<Vec<Vector>> {
    let mut noise = Noise::new(11, trial);
    let shifted = |noise: &mut Noise| AT.map(|x| x + noise.uniform(0.2));
    (0..count)
        .map(|_| {
            let at = shifted(&mut noise);
            cloud(&mut noise, 30, at, [0.01, 0.03, 0.02])
        })
        .collect()
}

/// Mean distance of all pairs tells the variance without a mean: Σ(a-b)² over ordered pairs = 2 n (n-1) s².
pub fn deviation_by_pairs(values: &[f64]) -> f64 {
    let n = values.len() as f64;
    let pairs: f64 = values.iter().flat_map(|a| values.iter().map(move |b| (a - b).powi(2))).sum();
    (pairs / (2.0 * n * (n - 1.0))).sqrt()
}

/// Running mean: m += (x - m) / k.
fn running_mean(points: &[Vector]) -> Vector {
    let mut mean = [0.0; 3];
    for (k, p) in points.iter().enumerate() {
        mean = [0, 1, 2].map(|i| mean[i] + (p[i] - mean[i]) / (k + 1) as f64);
    }
    mean
}

pub fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-10, "{a} {b}");
}

#[test]
fn position_characteristics_agree_with_a_second_implementation() {
    for trial in 0..20 {
        let all = clouds(trial, 3);
        let accuracy = pose_accuracy(&all[0], AT).unwrap();
        let mean = running_mean(&all[0]);
        (0..3).for_each(|k| close(accuracy.deviation_mm[k], mean[k] - AT[k]));
        close(accuracy.ap_mm.powi(2), (0..3).map(|k| (mean[k] - AT[k]).powi(2)).sum());

        let found = pose_repeatability(&all[0]).unwrap();
        let radii: Vec<f64> =
            all[0].iter().map(|p| (0..3).map(|k| (p[k] - mean[k]).powi(2)).sum::<f64>().sqrt()).collect();
        close(found.mean_radius_mm, radii.iter().sum::<f64>() / 30.0);
        close(found.rp_mm, radii.iter().sum::<f64>() / 30.0 + 3.0 * deviation_by_pairs(&radii));
        for k in 0..3 {
            close(found.axis_mm[k], 3.0 * deviation_by_pairs(&all[0].iter().map(|p| p[k]).collect::<Vec<_>>()));
        }

        let varied = variation(&all).unwrap();
        let means: Vec<Vector> = all.iter().map(|g| running_mean(g)).collect();
        let worst = [(0, 1), (0, 2), (1, 2)].map(|(h, k)| norm(minus(means[h], means[k])));
        close(varied.vap_mm, worst[0].max(worst[1]).max(worst[2]));
        close(norm(minus(means[varied.between.0], means[varied.between.1])), varied.vap_mm);

        let far: Vec<Vector> = all[1].iter().map(|p| [p[0] + 400.0, p[1] - 300.0, p[2]]).collect();
        let commanded = [AT, [AT[0] + 400.0, AT[1] - 300.0, AT[2]]];
        let driven = distance(&all[0], &far, commanded).unwrap();
        let lengths: Vec<f64> = (0..30).map(|j| norm(minus(far[j], all[0][j]))).collect();
        close(driven.ad_mm, lengths.iter().sum::<f64>() / 30.0 - 500.0);
        close(driven.rd_mm, 3.0 * deviation_by_pairs(&lengths));
        // one difference is positive, the other negative: sizes are compared
        for (k, commanded) in [(0, 400.0), (1, 300.0)] {
            let along: Vec<f64> = (0..30).map(|j| (far[j][k] - all[0][j][k]).abs()).collect();
            close(driven.ad_axis_mm[k], along.iter().sum::<f64>() / 30.0 - commanded);
            close(driven.rd_axis_mm[k], 3.0 * deviation_by_pairs(&along));
        }

        let sets: Vec<Vec<Vector>> = all.iter().flat_map(|g| g.chunks(10).map(<[Vector]>::to_vec)).collect();
        let drifted = drift(1.into(), &sets, AT).unwrap();
        let (first, last) = (running_mean(&sets[0]), running_mean(&sets[8]));
        close(drifted.dap_mm, (norm(minus(last, AT)) - norm(minus(first, AT))).abs());
        close(
            drifted.drp_mm,
            (pose_repeatability(&sets[8]).unwrap().rp_mm - pose_repeatability(&sets[0]).unwrap().rp_mm).abs(),
        );

        let other = clouds(trial + 100, 3);
        let exchanged = exchangeability(&[all.clone(), other.clone()]).unwrap();
        let apart = (0..3).map(|i| norm(minus(running_mean(&all[i]), running_mean(&other[i])))).fold(0.0, f64::max);
        close(exchanged.e_mm, apart);
    }
}

#[test]
fn a_drift_that_dies_away_settles_and_one_that_goes_on_does_not() {
    let sets = |at: &dyn Fn(f64) -> f64| -> Vec<Vec<Vector>> {
        (0..30).map(|i| vec![[at(f64::from(i)), 0.0, 0.0]; 3]).collect()
    };
    // e^(-i/3): below a tenth of the first change after 3 ln 10 = 6.9 changes; five in a row end at change 12, set 13
    assert_eq!(drift(1.into(), &sets(&|i| 1.0 - (-i / 3.0).exp()), [0.0; 3]).unwrap().settled_after, Some(13));
    assert_eq!(drift(1.into(), &sets(&|i| i), [0.0; 3]).unwrap().settled_after, None);
}

#[test]
fn angles_are_the_same_on_either_side_of_half_a_turn() {
    let mut noise = Noise::new(12, 0);
    let errors: Vec<f64> = (0..30).map(|_| 0.002 + noise.gaussian(0.001)).collect();
    let mean = errors.iter().sum::<f64>() / 30.0;
    for commanded in [0.0, PI, -PI, 3.0, 100.0] {
        let folded = |a: &f64| (a + commanded).sin().atan2((a + commanded).cos());
        let attained: Vec<f64> = errors.iter().map(folded).collect();
        close(angle_accuracy_rad(&attained, commanded), mean);
        close(angle_repeatability_rad(&attained), 3.0 * deviation_by_pairs(&errors));
        let zero = vec![commanded; 30];
        close(angle_variation_rad(&[attained.clone(), zero.clone()]), mean.abs());
        // a commanded difference of 0.5 rad, attained with the errors
        let turned: Vec<f64> = errors.iter().map(|e| folded(&(e + 0.5))).collect();
        let (ad, rd) = angle_distance_rad(&turned, &zero, [commanded + 0.5, commanded]);
        close(ad, mean);
        close(rd, 3.0 * deviation_by_pairs(&errors));
    }
}

#[test]
fn rigid_motion_changes_nothing_and_scaling_scales() {
    let motion = Pose::from_xyz_rpy([40.0, -900.0, 120.0], [0.3, -1.1, 2.0]);
    let all = clouds(3, 6);
    let lengths = |all: &[Vec<Vector>], at: Vector| {
        let found = pose_repeatability(&all[0]).unwrap();
        let (varied, driven) = (variation(all).unwrap(), distance(&all[0], &all[1], [at, at]).unwrap());
        let drifted = drift(1.into(), all, at).unwrap();
        let accuracy = pose_accuracy(&all[0], at).unwrap();
        let bootstrap = Bootstrap::new(30, 200, 5).unwrap();
        let rp = [repeatability_interval(&all[0], &found).unwrap(), bootstrap.repeatability(&all[0], &found).unwrap()];
        let ap = accuracy_interval(&all[0], &accuracy).unwrap();
        let apart = exchangeability(&[all[..3].to_vec(), all[3..].to_vec()]).unwrap().e_mm;
        let flat = coplanarity(all).unwrap().flatness_mm;
        [
            accuracy.ap_mm,
            found.rp_mm,
            found.mean_radius_mm,
            found.enclosing_radius_mm,
            varied.vap_mm,
            driven.ad_mm,
            driven.rd_mm,
            drifted.dap_mm,
            drifted.drp_mm,
            apart,
            flat,
            rp[0].low_mm,
            rp[0].high_mm,
            rp[1].low_mm,
            rp[1].high_mm,
            ap.low_mm,
            ap.high_mm,
        ]
    };
    let mapped = |f: &dyn Fn(Vector) -> Vector| {
        let moved: Vec<Vec<Vector>> = all.iter().map(|g| g.iter().map(|p| f(*p)).collect()).collect();
        lengths(&moved, f(AT))
    };
    let still = lengths(&all, AT);
    for (i, (a, b)) in still.iter().zip(mapped(&|p| motion.apply(p))).enumerate() {
        assert!((a - b).abs() < 1e-9, "{i}: {a} {b}");
    }
    for (i, (a, b)) in still.iter().zip(mapped(&|p| p.map(|x| 3.0 * x))).enumerate() {
        assert!((3.0 * a - b).abs() < 1e-9, "{i}: {a} {b}");
    }
}

#[test]
fn without_noise_everything_is_exactly_zero() {
    let still = vec![vec![AT; 30]; 4];
    assert_eq!(pose_accuracy(&still[0], AT).unwrap().ap_mm, 0.0);
    let found = pose_repeatability(&still[0]).unwrap();
    assert_eq!((found.rp_mm, found.axis_mm, found.enclosing_radius_mm), (0.0, [0.0; 3], 0.0));
    assert_eq!(variation(&still).unwrap().vap_mm, 0.0);
    let driven = distance(&still[0], &still[1], [AT, AT]).unwrap();
    assert_eq!((driven.ad_mm, driven.rd_mm), (0.0, 0.0));
    let drifted = drift(1.into(), &still, AT).unwrap();
    assert_eq!((drifted.dap_mm, drifted.drp_mm), (0.0, 0.0));
    assert_eq!(angle_repeatability_rad(&[0.7; 30]), 0.0);
    let bootstrap = Bootstrap::new(30, 100, 1).unwrap();
    let (ap, rp) = (pose_accuracy(&still[0], AT).unwrap(), found);
    for i in [
        bootstrap.accuracy(&still[0], &ap).unwrap(),
        bootstrap.repeatability(&still[0], &rp).unwrap(),
        accuracy_interval(&still[0], &ap).unwrap(),
        repeatability_interval(&still[0], &rp).unwrap(),
    ] {
        assert_eq!((i.low_mm, i.high_mm), (0.0, 0.0));
    }
}

#[test]
fn means_off_a_plane_are_found_by_brute_force_too() {
    // the corners of a square, two of them lifted: the best plane passes through all but ±0.05
    let corners = [[0.0, 0.0, 0.1], [100.0, 0.0, 0.0], [100.0, 100.0, 0.1], [0.0, 100.0, 0.0]];
    let flat = coplanarity(&corners.map(|p| vec![p; 2])).unwrap();
    let normal = flat.normal.map(f64::abs);
    assert!((flat.flatness_mm - 0.1).abs() < 1e-12 && (normal[2] - 1.0).abs() < 1e-12, "{flat:?}");
    assert!(coplanarity(&[vec![AT; 2], vec![AT; 2], vec![AT; 2]]).is_err());
}

#[test]
fn the_quarter_rule_says_yes_up_to_a_quarter() {
    assert!(uncertainty_ratio(0.010, 0.040).met && !uncertainty_ratio(0.010, 0.039).met);
    assert!(!uncertainty_ratio(0.010, 0.0).met && uncertainty_ratio(0.010, -0.5).met);
}

#[test]
fn too_little_or_unusable_data_are_refused() {
    let nan = vec![[0.0, f64::NAN, 0.0]; 3];
    assert!(pose_accuracy(&[], AT).is_err() && pose_accuracy(&nan, AT).is_err());
    assert!(pose_repeatability(&[AT]).is_err() && pose_repeatability(&nan).is_err());
    assert!(variation(&[vec![AT]]).is_err() && variation(&[vec![AT], vec![]]).is_err());
    assert!(distance(&[AT, AT], &[AT], [AT, AT]).is_err());
    assert!(drift(1.into(), &[vec![AT, AT]], AT).is_err() && exchangeability(&[vec![vec![AT]], vec![]]).is_err());
    assert!(Bootstrap::new(2, 10, 1).is_err());
}

/// Intervals hold the truth in 95 ± 1.5 % of 2,000 simulated tests of 30 cycles, in closed form and by bootstrap: for
/// scatter that is alike in all directions, that differs, of a planar robot, and nearly in one direction.
#[test]
fn intervals_of_accuracy_and_repeatability_cover_the_truth() {
    const TESTS: usize = 2000;
    let bootstrap = Bootstrap::new(30, 2000, 7).unwrap();
    let scatters = [[0.01, 0.01, 0.01], [0.01, 0.02, 0.04], [0.02, 0.02, 0.0], [0.03, 0.003, 0.003]];
    scatters.into_par_iter().enumerate().for_each(|(trial, sigma)| {
        let mut noise = Noise::new(13, trial as u64);
        // the truth by brute force: mean + 3 s of a million radii about the true mean
        let (mut sum, mut squares) = (0.0, 0.0);
        for _ in 0..1_000_000 {
            let r2: f64 = sigma.iter().map(|s| noise.gaussian(*s).powi(2)).sum();
            (sum, squares) = (sum + r2.sqrt(), squares + r2);
        }
        let (mean, square) = (sum / 1e6, squares / 1e6);
        let rp = mean + 3.0 * (square - mean * mean).sqrt();
        let offset = [0.03, -0.02, if sigma[2] > 0.0 { 0.05 } else { 0.0 }];
        let ap = norm(offset);
        let mut held = [0usize; 4];
        for _ in 0..TESTS {
            let points = cloud(&mut noise, 30, offset, sigma);
            let (accuracy, found) = (pose_accuracy(&points, [0.0; 3]).unwrap(), pose_repeatability(&points).unwrap());
            let intervals = [
                (bootstrap.repeatability(&points, &found).unwrap(), rp),
                (repeatability_interval(&points, &found).unwrap(), rp),
                (bootstrap.accuracy(&points, &accuracy).unwrap(), ap),
                (accuracy_interval(&points, &accuracy).unwrap(), ap),
            ];
            for (count, (i, truth)) in held.iter_mut().zip(intervals) {
                *count += usize::from(i.low_mm <= truth && truth <= i.high_mm);
            }
        }
        let coverage = held.map(|h| 100.0 * h as f64 / TESTS as f64);
        println!(
            "scatter {sigma:?}: RP bootstrap {}, closed {}; AP bootstrap {}, closed {} %",
            coverage[0], coverage[1], coverage[2], coverage[3]
        );
        assert!(coverage.iter().all(|c| (c - 95.0).abs() <= 1.5), "{sigma:?}: {coverage:?}");
    });
}
