//! Intervals of AT and RT against simulated tests whose truth is known.

use crate::compare::parameters::recorded;
use etalon::base::noise::Noise;
use etalon::compare::{Compared, compare};
use etalon::documents::CompareFamily;
use etalon::standards::iso9283::motion::stream::Stream;
use etalon::standards::iso9283::path::accuracy::path_accuracy;
use etalon::standards::iso9283::path::bootstrap::PathBootstrap;
use etalon::standards::iso9283::path::commanded::{CommandPoint, CommandedPath};
use etalon::standards::iso9283::path::passes::{Pass, passes};
use etalon::standards::iso9283::path::repeatability::path_repeatability;
use etalon::standards::iso9283::pose::noise_free::repeatability_of_scatter;
use rayon::prelude::*;

const POINTS: usize = 24;
/// Tests of each kind: `ETALON_COVERAGE_TESTS=2000` draws as many.
const TESTS: u64 = 150;
/// A standard deviation that would be no robot's; what matters is its ratio to the deviation.
const SIGMA_MM: f64 = 0.02;

/// How passes of a straight path along x deviate in y and z.
#[derive(Clone, Copy, Debug)]
struct Kind {
    name: &'static str,
    /// Mean deviation at a share of the path from 0 to 1.
    mean_mm: fn(f64) -> [f64; 2],
    /// Standard deviations of y and z there, over `SIGMA_MM`.
    scatter: fn(f64) -> [f64; 2],
    /// Share of the variance that is each point's own; the rest waves slowly along the path.
    own: f64,
}

const KINDS: [Kind; 6] = [
    Kind { name: "a wave, slow scatter", mean_mm: wave, scatter: alike, own: 0.0 },
    Kind { name: "a wave, own scatter", mean_mm: wave, scatter: alike, own: 1.0 },
    Kind { name: "a wave, both, more in the middle", mean_mm: wave, scatter: middle, own: 0.2 },
    Kind { name: "a wave, both, in one direction", mean_mm: wave, scatter: flat, own: 0.2 },
    Kind { name: "an offset, slow scatter", mean_mm: offset, scatter: alike, own: 0.0 },
    Kind { name: "an offset, own scatter", mean_mm: offset, scatter: alike, own: 1.0 },
];

fn wave(s: f64) -> [f64; 2] {
    [0.1 * s * (5.0 * s + 0.3).sin(), 0.05 * (3.0 * s).cos()]
}

fn offset(_: f64) -> [f64; 2] {
    [0.1, 0.0]
}

fn alike(_: f64) -> [f64; 2] {
    [1.0, 1.0]
}

fn middle(s: f64) -> [f64; 2] {
    [1.0 + (-((s - 0.4) / 0.1).powi(2)).exp(); 2]
}

fn flat(_: f64) -> [f64; 2] {
    [1.0, 0.1]
}

fn share(point: usize) -> f64 {
    (point as f64 + 0.5) / POINTS as f64
}

/// Deviation of one pass at every command point: offset and two waves of random size, unit variance everywhere, and what is
/// each point's own.
fn deviations(kind: &Kind, noise: &mut Noise) -> Vec<[f64; 2]> {
    let waves = [(); 2].map(|()| [(); 5].map(|()| noise.gaussian(1.0)));
    let at = |i: usize| {
        let s = share(i);
        let (mean, scatter) = ((kind.mean_mm)(s), (kind.scatter)(s));
        let shapes = [1.0, (6.0 * s).sin(), (6.0 * s).cos(), (20.0 * s).sin(), (20.0 * s).cos()];
        [0, 1].map(|k| {
            let slow: f64 = waves[k].iter().zip(shapes).map(|(w, f)| w * f).sum::<f64>() / 3f64.sqrt();
            let unit = (1.0 - kind.own).sqrt() * slow + kind.own.sqrt() * noise.gaussian(1.0);
            mean[k] + SIGMA_MM * scatter[k] * unit
        })
    };
    (0..POINTS).map(at).collect()
}

/// A recorded test of `n` passes: samples at the command planes, and the ways back far off.
fn test(kind: &Kind, n: usize, seed: u64, points: &[CommandPoint]) -> Vec<Pass> {
    let mut noise = Noise::new(17, seed);
    let mut samples = Vec::new();
    for _ in 0..n {
        let all = deviations(kind, &mut noise);
        samples.push([-5.0, all[0][0], all[0][1]]);
        for (p, d) in points.iter().zip(&all) {
            // two samples about each plane, so that the crossing is there
            samples.extend([-0.5, 0.5].map(|x| [p.position_mm[0] + x, d[0], d[1]]));
        }
        samples.extend([[1100.0, 0.0, 0.0], [1100.0, 500.0, 0.0], [-100.0, 500.0, 0.0], [-100.0, 0.0, 0.0]]);
    }
    let time_s = (0..samples.len()).map(|i| i as f64).collect();
    let found = passes(&Stream::new(time_s, samples, &[]).unwrap(), points, 10.0).unwrap();
    assert_eq!(found.complete.len(), n);
    found.complete
}

#[test]
fn intervals_of_path_accuracy_and_repeatability_cover_the_truth_as_often_as_stated() {
    let path = CommandedPath::new(vec![[0.0; 3], [1000.0, 0.0, 0.0]], &[]).unwrap();
    let points = path.command_points(POINTS);
    let stated = std::env::var("ETALON_COVERAGE_TESTS").ok().and_then(|n| n.parse().ok());
    let tests: u64 = stated.unwrap_or(TESTS);
    for kind in &KINDS {
        let shares: Vec<f64> = (0..POINTS).map(share).collect();
        let size = |s: &f64| (kind.mean_mm)(*s).iter().map(|d| d * d).sum::<f64>().sqrt();
        let variances = |s: &f64| {
            let [y, z] = (kind.scatter)(*s).map(|v| (SIGMA_MM * v).powi(2));
            repeatability_of_scatter([0.0, y, z])
        };
        let largest = |of: &dyn Fn(&f64) -> f64| shares.iter().map(of).fold(0.0, f64::max);
        let (at, rt) = (largest(&size), largest(&variances));
        let one = |seed: u64| -> [f64; 5] {
            let passes = test(kind, 10, seed, &points);
            let (accuracy, repeatability) =
                (path_accuracy(&passes, &points).unwrap(), path_repeatability(&passes, &points).unwrap());
            let bootstrap = PathBootstrap { draws: 200, seed };
            let i = bootstrap.accuracy(&passes, &points, &accuracy).unwrap();
            let j = bootstrap.repeatability(&passes, &points, &repeatability).unwrap();
            let inside = |low: f64, high: f64, truth: f64| f64::from(u8::from(low <= truth && truth <= high));
            [
                inside(i.low_mm, i.high_mm, at),
                inside(j.low_mm, j.high_mm, rt),
                repeatability.rt_mm / rt,
                (i.high_mm - i.low_mm) / at,
                (j.high_mm - j.low_mm) / rt,
            ]
        };
        let sums = (0..tests).into_par_iter().map(one).reduce(|| [0.0; 5], |a, b| [0, 1, 2, 3, 4].map(|k| a[k] + b[k]));
        let [at_held, rt_held, bias, at_width, rt_width] = sums.map(|s| s / tests as f64);
        println!(
            "{}: AT held {:.1} % (width {at_width:.2}), RT held {:.1} % (width {rt_width:.2}); RT found {bias:.2} of the true",
            kind.name,
            100.0 * at_held,
            100.0 * rt_held
        );
        // three standard deviations of a share of 95 % that is drawn
        let chance = 3.0 * (0.95 * 0.05 / tests as f64).sqrt();
        let as_stated = |held: f64| held > 0.90 - chance && held < 0.98 + chance;
        assert!(as_stated(at_held) && as_stated(rt_held), "{}: {at_held} {rt_held}", kind.name);
    }
}

/// Pairs of tests of each kind that are compared.
const PAIRS: u64 = 50;

/// A campaign with one recorded path, as `etalon compare` gets it.
fn campaign(folder: &str, (kind, seed): (&Kind, u64), points: &[CommandPoint]) -> Compared {
    let passes = test(kind, 10, seed, points);
    let (accuracy, repeatability) =
        (path_accuracy(&passes, points).unwrap(), path_repeatability(&passes, points).unwrap());
    let bootstrap = PathBootstrap { draws: 200, seed };
    let (i, j) = (
        bootstrap.accuracy(&passes, points, &accuracy).unwrap(),
        bootstrap.repeatability(&passes, points, &repeatability).unwrap(),
    );
    recorded(folder, [accuracy.at_mm, i.low_mm, i.high_mm, repeatability.rt_mm, j.low_mm, j.high_mm])
}

/// How often AT and RT are called changed, in per cent, where `later` drives the second test of each pair.
fn called_changed(kind: &Kind, later: &Kind, pairs: u64, points: &[CommandPoint]) -> [f64; 2] {
    let one = |pair: u64| -> [f64; 2] {
        let (a, b) = (campaign("a", (kind, 2 * pair), points), campaign("b", (later, 2 * pair + 1), points));
        let document = compare(&[a, b]).unwrap();
        [CompareFamily::PathAccuracy, CompareFamily::PathRepeatability].map(|family| {
            let trend = document.trends.iter().find(|t| t.family == family).unwrap();
            f64::from(u8::from(trend.changes[0].significant == Some(true)))
        })
    };
    let sums = (0..pairs).into_par_iter().map(one).reduce(|| [0.0; 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
    sums.map(|s| 100.0 * s / pairs as f64)
}

#[test]
fn at_and_rt_of_an_unchanged_robot_are_called_changed_as_seldom_as_the_comparison_says() {
    let path = CommandedPath::new(vec![[0.0; 3], [1000.0, 0.0, 0.0]], &[]).unwrap();
    let points = path.command_points(POINTS);
    let stated = std::env::var("ETALON_COVERAGE_TESTS").ok().and_then(|n| n.parse().ok());
    let pairs: u64 = stated.unwrap_or(PAIRS);
    let mut sums = [0.0; 2];
    for kind in &KINDS {
        let [at, rt] = called_changed(kind, kind, pairs, &points);
        println!("{}: AT called changed in {at:.1} %, RT in {rt:.1} % of {pairs} pairs", kind.name);
        sums = [sums[0] + at, sums[1] + rt];
    }
    let [at, rt] = sums.map(|s| s / KINDS.len() as f64);
    println!("all: AT {at:.2} %, RT {rt:.2} %");
    // of 300 pairs a share of 5 % is drawn with a standard deviation of 1.3 %
    assert!(at < 9.0 && rt < 9.0, "{at} {rt}");
}

#[test]
fn a_path_that_is_driven_twice_as_far_off_or_twice_as_coarse_is_called_changed() {
    let path = CommandedPath::new(vec![[0.0; 3], [1000.0, 0.0, 0.0]], &[]).unwrap();
    let points = path.command_points(POINTS);
    let once = Kind { name: "once", mean_mm: wave, scatter: alike, own: 0.2 };
    let coarse = Kind { scatter: |_| [3.0, 3.0], ..once };
    let off = Kind { mean_mm: |s| wave(s).map(|v| 2.0 * v), ..once };
    let [_, rt] = called_changed(&once, &coarse, 40, &points);
    let [at, _] = called_changed(&once, &off, 40, &points);
    assert!(at > 90.0 && rt > 90.0, "{at} {rt}");
}

#[test]
fn passes_that_agree_exactly_leave_nothing_open_and_two_tell_no_interval() {
    let path = CommandedPath::new(vec![[0.0; 3], [1000.0, 0.0, 0.0]], &[]).unwrap();
    let points = path.command_points(POINTS);
    let rigid = Kind { name: "rigid", mean_mm: offset, scatter: |_| [0.0; 2], own: 0.0 };
    let bootstrap = PathBootstrap { draws: 100, seed: 1 };
    let all = test(&rigid, 3, 0, &points);
    let (accuracy, repeatability) = (path_accuracy(&all, &points).unwrap(), path_repeatability(&all, &points).unwrap());
    let i = bootstrap.accuracy(&all, &points, &accuracy).unwrap();
    assert!((i.low_mm - 0.1).abs() < 1e-9 && (i.high_mm - 0.1).abs() < 1e-9, "{i:?}");
    let j = bootstrap.repeatability(&all, &points, &repeatability).unwrap();
    assert!(j.low_mm.abs() < 1e-9 && j.high_mm.abs() < 1e-9, "{j:?}");
    assert!(bootstrap.accuracy(&all[..2], &points, &accuracy).is_err());
}

/// Larger by a factor, larger by the factor: both intervals, with the same seed.
#[test]
fn intervals_scale_with_the_data_and_repeat_with_the_seed() {
    let path = CommandedPath::new(vec![[0.0; 3], [1000.0, 0.0, 0.0]], &[]).unwrap();
    let points = path.command_points(POINTS);
    let twice = Kind { name: "twice", mean_mm: |s| wave(s).map(|v| 2.0 * v), scatter: |_| [2.0, 2.0], own: 0.2 };
    let once = Kind { mean_mm: wave, scatter: alike, ..twice };
    let both = [once, twice].map(|kind| {
        let all = test(&kind, 10, 5, &points);
        let bootstrap = PathBootstrap { draws: 200, seed: 4 };
        let i = bootstrap.accuracy(&all, &points, &path_accuracy(&all, &points).unwrap()).unwrap();
        let j = bootstrap.repeatability(&all, &points, &path_repeatability(&all, &points).unwrap()).unwrap();
        [i.low_mm, i.high_mm, j.low_mm, j.high_mm]
    });
    for (one, two) in both[0].iter().zip(both[1]) {
        assert!((two / one - 2.0).abs() < 1e-6, "{both:?}");
    }
}
