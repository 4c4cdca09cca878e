//! Recorded motions: standstills, arrivals and posing times against a second implementation and by laws.

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::standards::iso9283::motion::overshoot::overshoot_mm;
use etalon::standards::iso9283::motion::posing_time::posing;
use etalon::standards::iso9283::motion::stabilisation::{arrival, stabilisation_time_s};
use etalon::standards::iso9283::motion::standstill::{Standstill, Stillness, places_mm, standstills, visited};
use etalon::standards::iso9283::motion::stream::Stream;

const STILL: Stillness = Stillness { radius_mm: 0.05, duration_s: 0.2 };
const RATE_HZ: f64 = 500.0;
const PLACES: [Vector; 3] = [[100.0, 200.0, 300.0], [400.0, 150.0, 350.0], [250.0, -80.0, 500.0]];

/// Synthetic: a robot that goes from place to place, swings in like a damped spring (`amplitude` e^(-t/τ) cos ωt along the
/// way) and stands for a second; with the time at which it begins each move.
fn shuttle(noise: &mut Noise, amplitude_mm: f64, sigma_mm: f64) -> (Vec<f64>, Vec<Vector>, Vec<f64>) {
    let (mut points, mut starts) = (Vec::new(), Vec::new());
    let mut shake = |p: Vector| p.map(|x| x + noise.gaussian(sigma_mm));
    let mut at = PLACES[0];
    points.extend((0..500).map(|_| shake(at)));
    for k in [1, 2, 0, 1, 2, 0] {
        let (to, way) = (PLACES[k], minus(PLACES[k], at));
        starts.push((points.len() as f64 - 1.0) / RATE_HZ);
        for i in 1..=400 {
            let s = i as f64 / 400.0;
            let share = s * s * (3.0 - 2.0 * s);
            points.push(shake([0, 1, 2].map(|j| at[j] + share * way[j])));
        }
        let along = way.map(|x| x / norm(way));
        for i in 1..=600 {
            let t = i as f64 / RATE_HZ;
            let swing = amplitude_mm * (-t / 0.05).exp() * (60.0 * t).sin();
            points.push(shake([0, 1, 2].map(|j| to[j] + swing * along[j])));
        }
        at = to;
    }
    ((0..points.len()).map(|i| i as f64 / RATE_HZ).collect(), points, starts)
}

fn stream(amplitude_mm: f64, sigma_mm: f64) -> (Stream, Vec<f64>) {
    let (time_s, points, starts) = shuttle(&mut Noise::new(21, 0), amplitude_mm, sigma_mm);
    (Stream::new(time_s, points, &[]).unwrap(), starts)
}

fn before(all: &[Standstill], i: usize) -> Option<&Standstill> {
    i.checked_sub(1).map(|i| &all[i])
}

#[test]
fn every_stop_is_found_once_and_at_its_place() {
    for (amplitude, sigma) in [(0.0, 0.0), (1.0, 0.0), (1.0, 0.005)] {
        let (stream, _) = stream(amplitude, sigma);
        let found = standstills(&stream, &STILL).unwrap();
        assert_eq!(visited(&found, &PLACES, 1.0), [0, 1, 2, 0, 1, 2, 0].map(Some), "{amplitude} {sigma}");
        assert_eq!(places_mm(&found, 1.0).len(), 3);
        for (s, k) in found.iter().zip([0, 1, 2, 0, 1, 2, 0]) {
            // the mean of 250 samples or more
            assert!(norm(minus(s.mean_mm, PLACES[k])) <= 5.0 * sigma / 250f64.sqrt() + 1e-3 * amplitude, "{s:?}");
        }
        assert_eq!(visited(&found, &PLACES[..1], 1.0)[1], None);
    }
}

#[test]
fn a_glitch_of_one_sample_parts_no_standstill() {
    let (time_s, mut points, _) = shuttle(&mut Noise::new(21, 1), 0.0, 0.002);
    points[250][0] += 3.0;
    let stream = Stream::new(time_s, points, &[]).unwrap();
    assert_eq!(standstills(&stream, &STILL).unwrap().len(), 7);
}

/// From every sample: the first that is within the band, the first of those after which no sample is outside.
#[test]
fn settling_overshoot_and_posing_time_agree_with_brute_force() {
    for sigma in [0.0, 0.004] {
        let (stream, starts) = stream(1.5, sigma);
        let found = standstills(&stream, &STILL).unwrap();
        let mut counted = 0;
        for band in [0.03, 0.1, 0.5] {
            for (i, s) in found.iter().enumerate().skip(1) {
                let arrived = arrival(&stream, before(&found, i), s, band).unwrap();
                let away = |j: usize| norm(minus(stream.positions_mm()[j], s.mean_mm));
                let range = found[i - 1].samples.end..s.middle().end;
                let entered = range.clone().filter(|&j| away(j) <= band).min().unwrap();
                let kept = |&j: &usize| (j..range.end).all(|j| away(j) <= band);
                let settled = range.clone().filter(kept).min().unwrap();
                assert_eq!((arrived.entered, arrived.settled), (entered, settled));
                let seconds = (settled - entered) as f64 / RATE_HZ;
                assert!((arrived.stabilisation_s - seconds).abs() < 1e-9);
                let largest = (entered..range.end).map(away).fold(0.0, f64::max);
                let expected = if largest > band { largest } else { 0.0 };
                assert_eq!(overshoot_mm(&stream, before(&found, i), s, &arrived), expected);
                let way = posing(&stream, &found[i - 1], s, &arrived);
                let was_there = |j: usize| norm(minus(stream.positions_mm()[j], found[i - 1].mean_mm)) <= band;
                let left = (found[i - 1].middle().start..settled).filter(|&j| was_there(j)).max().unwrap();
                assert!((way.time_s - (settled - left) as f64 / RATE_HZ).abs() < 1e-9);
                // it leaves the band some samples after it begins to move
                let late = left as f64 / RATE_HZ - starts[i - 1];
                assert!((-1e-9..0.04).contains(&late), "{late}");
                counted += usize::from(expected > 0.0);
            }
        }
        assert_eq!(counted, 18, "the swing of 0.9 mm leaves every band");
    }
}

#[test]
fn a_damped_spring_settles_when_its_formula_says() {
    let (stream, _) = stream(2.0, 0.0);
    let found = standstills(&stream, &STILL).unwrap();
    let band = 0.2;
    let arrivals: Vec<_> = (1..7).map(|i| arrival(&stream, before(&found, i), &found[i], band).unwrap()).collect();
    // the last time that |2 e^(-t/0.05) sin 60 t| is 0.2, by steps of a microsecond; the move ends at t = 0
    let swing = |t: f64| 2.0 * (-t / 0.05f64).exp() * (60.0 * t).sin();
    let last = (0..1_000_000).rev().map(|i| f64::from(i) * 1e-6).find(|&t| swing(t).abs() > band).unwrap();
    let largest = (0..1_000_000).map(|i| swing(f64::from(i) * 1e-6).abs()).fold(0.0, f64::max);
    // the band is entered this long before the move ends: 3 (1-s)² of the way is left at its end
    for (i, a) in arrivals.iter().enumerate() {
        let way = norm(minus(found[i + 1].mean_mm, found[i].mean_mm));
        let share = (band / (3.0 * way)).sqrt();
        let expected = share * 400.0 / RATE_HZ + last;
        assert!((a.stabilisation_s - expected).abs() < 1.5 / RATE_HZ + 0.002, "{} {expected}", a.stabilisation_s);
        let overshoot = overshoot_mm(&stream, before(&found, i + 1), &found[i + 1], a);
        assert!((overshoot - largest).abs() < 0.01, "{overshoot} {largest}");
    }
    let mean = arrivals.iter().map(|a| a.stabilisation_s).sum::<f64>() / 6.0;
    assert_eq!(stabilisation_time_s(&arrivals), Some(mean));
    assert_eq!(stabilisation_time_s(&[]), None);
}

#[test]
fn without_swing_and_noise_settling_and_overshoot_are_exactly_zero() {
    let (stream, _) = stream(0.0, 0.0);
    let found = standstills(&stream, &STILL).unwrap();
    for (i, s) in found.iter().enumerate().skip(1) {
        let arrived = arrival(&stream, before(&found, i), s, 0.1).unwrap();
        assert_eq!(arrived.stabilisation_s, 0.0);
        assert_eq!(overshoot_mm(&stream, before(&found, i), s, &arrived), 0.0);
    }
    assert_eq!(arrival(&stream, None, &found[0], 0.1), None, "the recording begins where the robot stands");
}

#[test]
fn a_band_narrower_than_the_noise_tells_no_settling() {
    let (stream, _) = stream(0.0, 0.01);
    let found = standstills(&stream, &STILL).unwrap();
    assert!((1..7).all(|i| arrival(&stream, before(&found, i), &found[i], 0.01).is_none()));
    assert!((1..7).all(|i| arrival(&stream, before(&found, i), &found[i], 0.06).is_some()));
}

#[test]
fn rigid_motion_changes_no_settling_and_scaling_scales_it() {
    let motion = Pose::from_xyz_rpy([40.0, -900.0, 120.0], [0.3, -1.1, 2.0]);
    let (time_s, points, _) = shuttle(&mut Noise::new(21, 2), 1.0, 0.004);
    let told = |f: &dyn Fn(Vector) -> Vector, length: f64, time: f64| -> Vec<[f64; 3]> {
        let stamps = time_s.iter().map(|t| time * t).collect();
        let stream = Stream::new(stamps, points.iter().map(|p| f(*p)).collect(), &[]).unwrap();
        let still = Stillness { radius_mm: length * STILL.radius_mm, duration_s: time * STILL.duration_s };
        let found = standstills(&stream, &still).unwrap();
        let of = |i: usize| {
            let band = 0.1 * length;
            let arrived = arrival(&stream, before(&found, i), &found[i], band)?;
            let overshoot = overshoot_mm(&stream, before(&found, i), &found[i], &arrived) / length;
            let way = posing(&stream, &found[i - 1], &found[i], &arrived);
            Some([overshoot, arrived.stabilisation_s / time, way.time_s / time])
        };
        (1..found.len()).map(|i| of(i).unwrap()).collect()
    };
    let still = told(&|p| p, 1.0, 1.0);
    assert_eq!(still.len(), 6);
    for other in [told(&|p| motion.apply(p), 1.0, 1.0), told(&|p| p.map(|x| 3.0 * x), 3.0, 1.0), told(&|p| p, 1.0, 2.0)]
    {
        for (a, b) in still.iter().flatten().zip(other.iter().flatten()) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
    }
}

/// 300 mm along x, then 100 mm along y, in two seconds, with 4 µm of noise; the robot stands for a second before and after.
#[test]
fn a_move_around_a_corner_has_a_path_longer_than_its_distance() {
    let mut noise = Noise::new(21, 3);
    let corner = |u: f64| if u <= 300.0 { [u, 0.0, 0.0] } else { [300.0, u - 300.0, 0.0] };
    let driven = |i: i32| (400.0 * (f64::from(i) / RATE_HZ - 1.0) / 2.0).clamp(0.0, 400.0);
    let points: Vec<Vector> = (0..2000).map(|i| corner(driven(i)).map(|x| x + noise.gaussian(0.004))).collect();
    let stream = Stream::new((0..2000).map(|i| f64::from(i) / RATE_HZ).collect(), points, &[]).unwrap();
    let found = standstills(&stream, &STILL).unwrap();
    let [from, to] = &found[..] else { panic!("{found:?}") };
    let way = posing(&stream, from, to, &arrival(&stream, Some(from), to, 0.03).unwrap());
    assert!((way.distance_mm - 300f64.hypot(100.0)).abs() < 0.01, "{way:?}");
    // noise lengthens each step of 0.4 mm by its square over the step: 0.04 µm
    assert!((way.path_mm - 400.0).abs() < 0.1, "{way:?}");
}

#[test]
fn unusable_streams_are_refused_and_jumps_left_out() {
    let points = vec![[0.0, 0.0, 0.0]; 4];
    let of = |time: &[f64], points: &[Vector], angles: &[Vec<f64>]| Stream::new(time.to_vec(), points.to_vec(), angles);
    assert!(of(&[], &[], &[]).is_err() && of(&[0.0], &points[..1], &[]).is_err());
    assert!(of(&[0.0, 1.0], &points, &[]).is_err() && of(&[0.0, 1.0, 2.0, 3.0], &points, &[vec![0.0]]).is_err());
    for (times, sample) in [([0.0, 1.0, 1.0, 2.0], 2), ([0.0, 1.0, 0.5, 2.0], 2), ([0.0, f64::NAN, 2.0, 3.0], 1)] {
        assert_eq!(of(&times, &points, &[]).unwrap_err().sample, sample);
    }
    let mut infinite = points.clone();
    infinite[3][1] = f64::INFINITY;
    assert_eq!(of(&[0.0, 1.0, 2.0, 3.0], &infinite, &[]).unwrap_err().sample, 3);

    let still = of(&[0.0, 1.0, 2.0, 3.0], &points, &[]).unwrap();
    for (radius_mm, duration_s) in [(0.0, 1.0), (1.0, 0.0), (f64::NAN, 1.0), (1.0, f64::NAN), (-1.0, 1.0)] {
        assert!(standstills(&still, &Stillness { radius_mm, duration_s }).is_err());
    }
    assert_eq!(standstills(&still, &Stillness { radius_mm: 1.0, duration_s: 9.0 }).unwrap(), []);

    // 20 m/s is the fastest: 20 mm in a millisecond are reached, 21 are not; the way back counts from the last that is
    let far: Vec<Vector> = [0.0, 20.0, 41.0, 0.0].map(|x| [x, 0.0, 0.0]).to_vec();
    let (kept, jumps) = of(&[0.0, 1e-3, 2e-3, 3e-3], &far, &[vec![0.0, 0.1, 0.2, 0.3]]).unwrap().without_jumps();
    assert_eq!((jumps, kept.len(), kept.angles_rad()[0].clone()), (vec![2], 3, vec![0.0, 0.1, 0.3]));
    // a jump at the beginning is one, and not all that follows
    let begun: Vec<Vector> = [0.0, 2000.0, 2000.1, 2000.2].map(|x| [x, 0.0, 0.0]).to_vec();
    assert_eq!(of(&[0.0, 1e-3, 2e-3, 3e-3], &begun, &[]).unwrap().without_jumps().1, [0]);
    let second: Vec<Vector> = [0.0, 2000.0, 0.1, 0.2].map(|x| [x, 0.0, 0.0]).to_vec();
    assert_eq!(of(&[0.0, 1e-3, 2e-3, 3e-3], &second, &[]).unwrap().without_jumps().1, [1]);
}
