//! Beyond the standard: error ellipsoid, conformity with a limit, RP without the instrument's noise.

use crate::standards::iso9283::cloud;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, dot, minus, norm};
use etalon::standards::decision::{Conformity, DecisionRule};
use etalon::standards::iso9283::pose::ellipsoid::{Ellipsoid, ellipsoid};
use etalon::standards::iso9283::pose::noise_free::{repeatability_of_scatter, without_noise};
use etalon::standards::iso9283::pose::reference::epochs;
use etalon::standards::iso9283::pose::repeatability::pose_repeatability;
use etalon::standards::iso9283::statistics::bootstrap::Bootstrap;
use etalon::standards::iso9283::statistics::interval::Interval;
use std::f64::consts::PI;

const TESTS: usize = 2000;
const SCATTERS: [Vector; 4] = [[0.01, 0.01, 0.01], [0.01, 0.02, 0.04], [0.02, 0.02, 0.0], [0.03, 0.0, 0.0]];

fn holds(e: &Ellipsoid, d: Vector) -> bool {
    let inside: f64 =
        (0..3).filter(|&k| e.semi_axes_mm[k] > 0.0).map(|k| (dot(e.axes[k], d) / e.semi_axes_mm[k]).powi(2)).sum();
    inside <= 1.0
}

#[test]
fn the_ellipsoid_holds_the_next_position_in_95_per_cent_of_tests() {
    let motion = Pose::from_xyz_rpy([0.0; 3], [0.3, -1.1, 2.0]);
    for (trial, sigma) in SCATTERS.into_iter().enumerate() {
        for cycles in [8, 30] {
            let mut noise = Noise::new(41, trial as u64 + 100 * cycles as u64);
            let mut held = 0;
            for _ in 0..TESTS {
                let all = cloud(&mut noise, cycles + 1, [5.0, 6.0, 7.0], sigma);
                // a planar robot stays in its plane; others lie as they like
                let turn = |p: &Vector| if sigma[2] == 0.0 { *p } else { motion.apply(*p) };
                let all: Vec<Vector> = all.iter().map(turn).collect();
                let mean = [0, 1, 2].map(|k| all[..cycles].iter().map(|p| p[k]).sum::<f64>() / cycles as f64);
                held += usize::from(holds(&ellipsoid(&all[..cycles]).unwrap(), minus(all[cycles], mean)));
            }
            let coverage = 100.0 * held as f64 / TESTS as f64;
            println!("ellipsoid, scatter {sigma:?}, {cycles} cycles: {coverage} %");
            assert!((coverage - 95.0).abs() <= 1.5, "{sigma:?} {cycles}: {coverage}");
        }
    }
}

#[test]
fn the_ellipsoid_turns_and_scales_with_the_data_and_is_flat_where_they_are() {
    let points = cloud(&mut Noise::new(42, 0), 30, [5.0, 6.0, 7.0], [0.01, 0.02, 0.04]);
    let motion = Pose::from_xyz_rpy([40.0, -900.0, 120.0], [0.3, -1.1, 2.0]);
    let (still, turned) =
        (ellipsoid(&points).unwrap(), ellipsoid(&points.iter().map(|p| motion.apply(*p)).collect::<Vec<_>>()).unwrap());
    let scaled = ellipsoid(&points.iter().map(|p| p.map(|x| 3.0 * x)).collect::<Vec<_>>()).unwrap();
    for k in 0..3 {
        assert!((still.semi_axes_mm[k] - turned.semi_axes_mm[k]).abs() < 1e-9);
        assert!((3.0 * still.semi_axes_mm[k] - scaled.semi_axes_mm[k]).abs() < 1e-9);
        assert!((dot(motion.rotate(still.axes[k]), turned.axes[k]).abs() - 1.0).abs() < 1e-6);
    }
    assert!(still.semi_axes_mm[0] > still.semi_axes_mm[1] && still.semi_axes_mm[1] > still.semi_axes_mm[2]);
    assert_eq!(ellipsoid(&[[1.0, 2.0, 3.0]; 5]).unwrap().semi_axes_mm, [0.0; 3]);
    assert!(ellipsoid(&points[..4]).is_err() && ellipsoid(&points[..5]).is_ok() && ellipsoid(&points[..2]).is_err());
}

#[test]
fn conformity_is_proved_only_where_the_whole_interval_is_on_one_side() {
    let interval = Interval { low_mm: 0.02, high_mm: 0.04 };
    for (limit, expected) in [
        (0.01, Conformity::NotConforming),
        (0.02, Conformity::Neither),
        (0.03, Conformity::Neither),
        (0.04, Conformity::Conforming),
        (f64::NAN, Conformity::Neither),
    ] {
        assert_eq!(DecisionRule::Guarded.judge(0.03, Some(interval), limit), expected, "{limit}");
    }
}

/// A robot exactly at its limit: either verdict is wrong, and may be given in at most 5 % of tests.
#[test]
fn a_robot_at_its_limit_is_judged_wrongly_in_no_more_tests_than_stated() {
    let bootstrap = Bootstrap::new(30, 2000, 7).unwrap();
    for (trial, sigma) in SCATTERS.into_iter().enumerate() {
        let limit = repeatability_of_scatter(sigma.map(|s| s * s));
        let mut noise = Noise::new(43, trial as u64);
        let mut counts = [0; 2];
        for _ in 0..TESTS {
            let points = cloud(&mut noise, 30, [5.0, 6.0, 7.0], sigma);
            let found = pose_repeatability(&points).unwrap();
            let interval = bootstrap.repeatability(&points, &found).unwrap();
            match DecisionRule::Guarded.judge(found.rp_mm, Some(interval), limit) {
                Conformity::Conforming => counts[0] += 1,
                Conformity::NotConforming => counts[1] += 1,
                Conformity::Neither | Conformity::NotAssessable => {}
            }
        }
        println!("scatter {sigma:?}: proved conforming {}, not conforming {} of {TESTS}", counts[0], counts[1]);
        assert!(counts.iter().all(|c| *c <= TESTS / 20), "{sigma:?} {counts:?}");
    }
}

#[test]
fn the_rp_of_gaussian_scatter_is_that_of_the_distributions_with_a_name() {
    for (variances, mean) in [
        ([4.0, 0.0, 0.0], 2.0 * (2.0 / PI).sqrt()),
        ([4.0, 4.0, 0.0], 2.0 * (PI / 2.0).sqrt()),
        ([4.0, 4.0, 4.0], 4.0 * (2.0 / PI).sqrt()),
    ] {
        let square: f64 = variances.iter().sum();
        let expected = mean + 3.0 * (square - mean * mean).sqrt();
        assert!((repeatability_of_scatter(variances) - expected).abs() < 1e-12 * expected, "{variances:?}");
    }
    // and of a million draws where it has none
    let mut noise = Noise::new(44, 0);
    let (mut sum, mut squares) = (0.0, 0.0);
    for _ in 0..1_000_000 {
        let r2: f64 = [1.0, 2.0, 0.5].iter().map(|s| noise.gaussian(*s).powi(2)).sum();
        (sum, squares) = (sum + r2.sqrt() / 1e6, squares + r2 / 1e6);
    }
    let drawn = sum + 3.0 * (squares - sum * sum).sqrt();
    assert!((repeatability_of_scatter([1.0, 4.0, 0.25]) / drawn - 1.0).abs() < 5e-3);
    assert_eq!(repeatability_of_scatter([0.0; 3]), 0.0);
}

/// On average what is left is the RP that an instrument without noise finds in the same tests.
#[test]
fn noise_is_removed_from_rp_without_bias() {
    for (trial, sigma) in SCATTERS.into_iter().enumerate() {
        let mut noise = Noise::new(45, trial as u64);
        // a planar instrument measures no z
        let shake: Vector = sigma.map(|s| if s > 0.0 { 0.01 } else { 0.0 });
        let (mut clean, mut found, mut freed, mut read) = (0.0, 0.0, 0.0, 0.0);
        for _ in 0..TESTS {
            let positions = cloud(&mut noise, 30, [5.0, 6.0, 7.0], sigma);
            let visits: Vec<Vec<Vector>> = positions.iter().map(|p| cloud(&mut noise, 2, *p, shake)).collect();
            let free = without_noise(&visits).unwrap();
            clean += pose_repeatability(&positions).unwrap().rp_mm / TESTS as f64;
            found += free.found.rp_mm / TESTS as f64;
            freed += free.rp_mm / TESTS as f64;
            read += free.noise_mm[0].powi(2) / TESTS as f64;
        }
        println!("scatter {sigma:?}: RP {found:.5}, without noise {freed:.5}, of the robot {clean:.5} mm");
        assert!((freed / clean - 1.0).abs() < 0.01 && found / clean > 1.015, "{sigma:?}");
        assert!((read.sqrt() / 0.01 - 1.0).abs() < 0.01);
    }
}

#[test]
fn without_readings_there_is_no_noise_to_remove_and_noise_alone_leaves_nothing() {
    let mut noise = Noise::new(46, 0);
    let single: Vec<Vec<Vector>> = cloud(&mut noise, 30, [0.0; 3], [0.01; 3]).into_iter().map(|p| vec![p]).collect();
    assert!(without_noise(&single).is_err() && without_noise(&[]).is_err());
    assert!(without_noise(&[vec![], vec![[0.0; 3]], vec![[0.0; 3]]]).is_err());
    // the same place read three times, each time the same
    let exact: Vec<Vec<Vector>> = single.iter().map(|p| vec![p[0]; 3]).collect();
    let free = without_noise(&exact).unwrap();
    assert!((free.rp_mm / free.found.rp_mm - 1.0).abs() < 1e-12 && free.noise_mm.iter().all(|n| *n < 1e-15));
    // a robot that stands still: what is left is less than half of what the noise makes
    let still: Vec<Vec<Vector>> = (0..30).map(|_| cloud(&mut noise, 4, [0.0; 3], [0.01; 3])).collect();
    let free = without_noise(&still).unwrap();
    assert!(free.rp_mm < 0.6 * free.found.rp_mm, "{free:?}");
    assert_eq!(without_noise(&vec![vec![[1.0; 3]; 2]; 5]).unwrap().rp_mm, 0.0);
}

#[test]
fn reference_targets_take_out_exactly_how_the_set_up_moved() {
    let nests: Vec<Vector> = vec![[0.0, 0.0, 0.0], [900.0, 0.0, 10.0], [0.0, 700.0, -20.0], [500.0, 600.0, 300.0]];
    let moved = |k: f64| Pose::from_xyz_rpy([0.05 * k, -0.02 * k, 0.01 * k], [1e-5 * k, 2e-5 * k, -3e-5 * k]);
    let sets: Vec<Vec<Vector>> =
        (0..4).map(|k| nests.iter().map(|p| moved(f64::from(k)).apply(*p)).collect()).collect();
    let found = epochs(&sets).unwrap();
    assert_eq!((found[0].first_T_now, found[0].moved_mm), (Pose::identity(), 0.0));
    let p = [400.0, -300.0, 800.0];
    for (k, epoch) in found.iter().enumerate() {
        let back = epoch.first_T_now.apply(moved(k as f64).apply(p));
        assert!(norm(minus(back, p)) < 1e-9 && epoch.rms_mm < 1e-9);
        let farthest = nests.iter().zip(&sets[k]).map(|(a, b)| norm(minus(*a, *b))).fold(0.0, f64::max);
        assert_eq!(epoch.moved_mm, farthest);
    }
    let line = vec![vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]; 2];
    assert!(
        epochs(&[]).is_err() && epochs(&line).is_err() && epochs(&[nests[..2].to_vec(), nests[..2].to_vec()]).is_err()
    );
    assert!(
        epochs(&[nests.clone(), nests[..3].to_vec()]).is_err() && epochs(&[nests, vec![[f64::NAN; 3]; 4]]).is_err()
    );
}
