//! Paths, corners and velocities against a second implementation, written in another way, and by laws.

use crate::standards::iso9283::{close, deviation_by_pairs};
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, dot, minus, norm};
use etalon::standards::iso9283::motion::stream::Stream;
use etalon::standards::iso9283::path::accuracy::{
    path_accuracy, path_accuracy_on_reorientation, path_angle_accuracy_rad,
};
use etalon::standards::iso9283::path::commanded::{CommandPoint, CommandedPath};
use etalon::standards::iso9283::path::cornering::cornering;
use etalon::standards::iso9283::path::passes::{Passes, passes};
use etalon::standards::iso9283::path::repeatability::{path_angle_repeatability_rad, path_repeatability};
use etalon::standards::iso9283::path::velocity::path_velocity;

const RATE_HZ: f64 = 500.0;
/// A corner of a right angle, and one of 45°.
const PATH: [Vector; 4] = [[0.0, 0.0, 0.0], [300.0, 0.0, 0.0], [300.0, 200.0, 0.0], [400.0, 300.0, 0.0]];

fn path() -> CommandedPath {
    CommandedPath::new(PATH.to_vec(), &[vec![3.0, 3.1, 3.2, -3.0]]).unwrap()
}

/// Where a robot is that follows the corners of `PATH`, from 20 mm before its begin to 20 mm behind its end.
fn along(mm: f64) -> Vector {
    let lengths = [300.0, 200.0, 20_000f64.sqrt()];
    let mut left = mm;
    for (leg, length) in lengths.iter().enumerate() {
        if left <= *length || leg == 2 {
            let way = minus(PATH[leg + 1], PATH[leg]);
            return [0, 1, 2].map(|k| PATH[leg][k] + left / length * way[k]);
        }
        left -= length;
    }
    unreachable!()
}

const TO: f64 = 300.0 + 200.0 + 141.421_356_237_309_5;

/// Synthetic: passes at `speeds_mm_s`, each off by its own slowly waving deviation, and the ways back in a wide arc; the
/// angle goes from 3 rad on by 0.0005 rad/mm and is written within half a turn.
fn driven(noise: &mut Noise, speeds_mm_s: &[f64], off_mm: f64, sigma_mm: f64) -> (Vec<Vector>, Vec<f64>) {
    let (mut points, mut angles) = (Vec::new(), Vec::new());
    for &speed in speeds_mm_s {
        let wave = [(); 6].map(|()| noise.gaussian(off_mm));
        let tilt = noise.gaussian(0.001 * f64::from(off_mm > 0.0));
        let mut mm = -20.0;
        while mm < TO + 20.0 {
            let p = along(mm);
            points.push([0, 1, 2].map(|k| p[k] + wave[k] + wave[k + 3] * (mm / 40.0).sin() + noise.gaussian(sigma_mm)));
            let angle: f64 = 3.0 + 0.0005 * mm + tilt;
            angles.push(angle.sin().atan2(angle.cos()));
            mm += speed / RATE_HZ;
        }
        for i in 1..400 {
            let turn = f64::from(i) / 400.0;
            let (from, to) = (along(TO + 20.0), along(-20.0));
            let out = 150.0 * (std::f64::consts::PI * turn).sin();
            points.push([0, 1, 2].map(|k| from[k] + turn * (to[k] - from[k]) + if k == 2 { out } else { 0.0 }));
            angles.push(-3.0);
        }
    }
    (points, angles)
}

fn stream((points, angles): (Vec<Vector>, Vec<f64>)) -> Stream {
    let time_s = (0..points.len()).map(|i| i as f64 / RATE_HZ).collect();
    Stream::new(time_s, points, &[angles]).unwrap()
}

/// Where the straight lines between samples meet the plane: the interval is halved until nothing is left of it.
fn met(stream: &Stream, samples: std::ops::Range<usize>, plane: &CommandPoint) -> (f64, Vector, f64) {
    let at = |t: f64| -> (Vector, f64) {
        let i = ((t.floor() as usize).max(samples.start)).min(samples.end - 2);
        let share = t - i as f64;
        let mix = |a: f64, b: f64| (1.0 - share) * a + share * b;
        let (p, q) = (stream.positions_mm()[i], stream.positions_mm()[i + 1]);
        ([0, 1, 2].map(|k| mix(p[k], q[k])), mix(stream.angles_rad()[0][i], stream.angles_rad()[0][i + 1]))
    };
    // the nearest sample to begin with: other parts of the path may go through the same plane
    let away = |i: &usize| norm(minus(stream.positions_mm()[*i], plane.position_mm));
    let nearest = samples.clone().min_by(|a, b| away(a).total_cmp(&away(b))).unwrap() as f64;
    let (mut low, mut high) = (nearest - 3.0, nearest + 3.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        let beyond = dot(minus(at(middle).0, plane.position_mm), plane.tangent) > 0.0;
        (low, high) = if beyond { (low, middle) } else { (middle, high) };
    }
    let (position, angle) = at(low);
    (low / RATE_HZ, position, angle)
}

/// Samples of each pass: those with z below 50 mm, as long as there are many.
fn cut(stream: &Stream) -> Vec<std::ops::Range<usize>> {
    let low = |i: &usize| stream.positions_mm()[*i][2] < 20.0;
    let mut all: Vec<std::ops::Range<usize>> = Vec::new();
    for i in (0..stream.len()).filter(low) {
        match all.last_mut().filter(|r| r.end == i) {
            Some(range) => range.end = i + 1,
            None => all.push(i..i + 1),
        }
    }
    // the end of the way back is low as well, and runs on into the next pass
    all.into_iter().filter(|r| r.len() > 200).collect()
}

#[test]
fn accuracy_and_repeatability_of_a_path_agree_with_a_second_implementation() {
    for trial in 0..5 {
        let stream = stream(driven(&mut Noise::new(31, trial), &[250.0; 10], 0.05, 0.0));
        let points = path().command_points(37);
        let found = passes(&stream, &points, 10.0).unwrap();
        assert_eq!((found.complete.len(), found.incomplete), (10, 0));
        let cuts = cut(&stream);
        assert_eq!(cuts.len(), 10);
        let (mut at, mut rt, mut at_angle, mut rt_angle) = (0.0f64, 0.0f64, 0.0f64, 0.0f64);
        for (i, plane) in points.iter().enumerate() {
            let met: Vec<(f64, Vector, f64)> = cuts.iter().map(|c| met(&stream, c.clone(), plane)).collect();
            for (pass, (time_s, position, _)) in found.complete.iter().zip(&met) {
                assert!((pass.crossings[i].time_s - time_s).abs() < 1e-9);
                assert!(norm(minus(pass.crossings[i].position_mm, *position)) < 1e-9);
            }
            let mean = [0, 1, 2].map(|k| met.iter().map(|m| m.1[k]).sum::<f64>() / 10.0);
            let radii: Vec<f64> = met.iter().map(|m| norm(minus(m.1, mean))).collect();
            at = at.max(norm(minus(mean, plane.position_mm)));
            rt = rt.max(radii.iter().sum::<f64>() / 10.0 + 3.0 * deviation_by_pairs(&radii));
            // commanded 3, 3.1, 3.2, then the short way to -3 + 2π
            let turn = std::f64::consts::TAU;
            let commanded = match plane.along_mm {
                s if s < 300.0 => 3.0 + 0.1 * s / 300.0,
                s if s < 500.0 => 3.1 + 0.1 * (s - 300.0) / 200.0,
                s => 3.2 + (turn - 6.2) * (s - 500.0) / (TO - 500.0),
            };
            let off: Vec<f64> = met.iter().map(|m| (m.2 - commanded).sin().asin()).collect();
            at_angle = at_angle.max((off.iter().sum::<f64>() / 10.0).abs());
            rt_angle = rt_angle.max(3.0 * deviation_by_pairs(&off));
        }
        let accuracy = path_accuracy(&found.complete, &points).unwrap();
        let repeated = path_repeatability(&found.complete, &points).unwrap();
        assert!((accuracy.at_mm - at).abs() < 1e-9 && (repeated.rt_mm - rt).abs() < 1e-9);
        assert_eq!(accuracy.at_mm, accuracy.deviations_mm[accuracy.worst]);
        assert_eq!(repeated.rt_mm, repeated.points_mm[repeated.worst]);
        close(path_angle_accuracy_rad(&found.complete, &points, 0), at_angle);
        close(path_angle_repeatability_rad(&found.complete, &points, 0), rt_angle);
        let turning = path_accuracy_on_reorientation(&found.complete, &points, &path()).unwrap();
        assert_eq!(turning, accuracy);
        let straight = CommandedPath::new(PATH.to_vec(), &[vec![0.1; 4]]).unwrap();
        assert!(path_accuracy_on_reorientation(&found.complete, &points, &straight).is_err());
    }
}

#[test]
fn a_path_without_deviation_has_none() {
    let stream = stream(driven(&mut Noise::new(32, 0), &[100.0, 100.0, 100.0], 0.0, 0.0));
    let points = path().command_points(50);
    let Passes { complete, .. } = passes(&stream, &points, 10.0).unwrap();
    assert_eq!(complete.len(), 3);
    // corners are cut between two samples of 0.2 mm; of the planes none is there
    assert!(path_accuracy(&complete, &points).unwrap().at_mm < 1e-9);
    assert!(path_repeatability(&complete, &points).unwrap().rt_mm < 1e-9);
    let points = CommandedPath::new(PATH[..2].to_vec(), &[vec![0.0; 2]]).unwrap().command_points(30);
    let complete = passes(&stream, &points, 10.0).unwrap().complete;
    let velocity = path_velocity(&complete, &points, 100.0, 0.5).unwrap();
    assert!(velocity.av_percent.abs() < 1e-6 && velocity.rv_percent < 1e-6 && velocity.fv_mm_s < 1e-6, "{velocity:?}");
}

#[test]
fn noise_of_a_slow_robot_makes_no_pass_more_and_none_less() {
    // 0.01 mm a sample, 0.02 mm of noise: every plane is gone through many times
    let line = CommandedPath::new(vec![[0.0; 3], [2.0, 0.0, 0.0]], &[]).unwrap();
    let mut noise = Noise::new(33, 0);
    let points: Vec<Vector> = (0..1200)
        .map(|i| [f64::from((i % 300).min(250)) * 0.01 - 0.2, 0.0, 0.0].map(|x| x + noise.gaussian(0.02)))
        .collect();
    let time_s = (0..points.len()).map(|i| i as f64 / RATE_HZ).collect();
    let stream = Stream::new(time_s, points, &[]).unwrap();
    let found = passes(&stream, &line.command_points(20), 0.3).unwrap();
    assert_eq!(found.complete.len(), 4);
}

#[test]
fn a_pass_that_is_left_does_not_count() {
    let mut noise = Noise::new(34, 0);
    let (mut points, mut angles) = driven(&mut noise, &[250.0], 0.0, 0.0);
    let half = points[..700].to_vec();
    let home: Vec<Vector> = (0..700).rev().map(|i| [half[i][0], half[i][1], 60.0]).collect();
    let (more, turned) = driven(&mut noise, &[250.0], 0.0, 0.0);
    angles = [angles, vec![3.0; 1400], turned].concat();
    points = [points, half, home, more].concat();
    let points_of_path = path().command_points(20);
    let found = passes(&stream((points, angles)), &points_of_path, 10.0).unwrap();
    assert_eq!((found.complete.len(), found.incomplete), (2, 1));
}

/// Shortly before its end a closed path comes by its begin again: what goes through the first plane there ends no pass.
#[test]
fn passes_of_a_closed_path_are_found_though_the_robot_strays_through_its_first_plane() {
    let square =
        CommandedPath::new(vec![[0.0; 3], [100.0, 0.0, 0.0], [100.0, 100.0, 0.0], [0.0, 100.0, 0.0], [0.0; 3]], &[])
            .unwrap();
    let planes = square.command_points(200);
    let mut points: Vec<Vector> = Vec::new();
    for _ in 0..3 {
        let side = |from: [f64; 2], to: [f64; 2]| {
            (0..100).map(move |i| {
                let at = [0, 1].map(|k| from[k] + f64::from(i) / 100.0 * (to[k] - from[k]));
                // on the last millimetres of the last side it strays by 3 mm
                let stray = if from == [0.0, 100.0] && at[1] < 4.0 { 3.0 } else { 0.0 };
                [at[0] + stray, at[1], 0.0]
            })
        };
        let corners = [[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0], [0.0, 0.0]];
        corners.windows(2).for_each(|c| points.extend(side(c[0], c[1])));
    }
    points.extend([[0.0, 0.0, 0.0], [0.0, -5.0, 0.0]]);
    let time_s = (0..points.len()).map(|i| i as f64 / RATE_HZ).collect();
    let found = passes(&Stream::new(time_s, points, &[]).unwrap(), &planes, 5.0).unwrap();
    assert_eq!((found.complete.len(), found.incomplete), (3, 0));
}

#[test]
fn velocities_are_those_driven() {
    // each pass at its own speed: mean and standard deviation of the speeds
    let speeds = [198.0, 203.0, 200.5, 201.0, 196.0];
    let stream = stream(driven(&mut Noise::new(35, 0), &speeds, 0.0, 0.0));
    let points = CommandedPath::new(PATH[..2].to_vec(), &[vec![0.0; 2]]).unwrap().command_points(30);
    let found = passes(&stream, &points, 10.0).unwrap().complete;
    let velocity = path_velocity(&found, &points, 200.0, 0.5).unwrap();
    close(velocity.mean_mm_s, 199.7);
    close(velocity.av_percent, -0.15);
    assert!((velocity.rv_percent - 3.0 * deviation_by_pairs(&speeds) / 2.0).abs() < 1e-9);
    assert!(velocity.fv_mm_s < 1e-6);

    // faster by 10 % in the second half
    let line = CommandedPath::new(vec![[0.0; 3], [100.0, 0.0, 0.0]], &[]).unwrap();
    let at = |i: i32| -> f64 { if i < 300 { f64::from(i) * 0.2 - 10.0 } else { 50.0 + f64::from(i - 300) * 0.22 } };
    let time_s = (0..600).map(|i| f64::from(i) / RATE_HZ).collect();
    let stepped = Stream::new(time_s, (0..600).map(|i| [at(i), 0.0, 0.0]).collect(), &[]).unwrap();
    let points = line.command_points(40);
    let found = passes(&stepped, &points, 1.0).unwrap().complete;
    let velocity = path_velocity(&found, &points, 100.0, 0.5).unwrap();
    assert!((velocity.fv_mm_s - 10.0).abs() < 1e-6 && velocity.rv_percent.is_nan(), "{velocity:?}");
    assert!(path_velocity(&found, &points, 100.0, 0.01).is_err() && path_velocity(&found, &points, 0.0, 0.5).is_err());
}

#[test]
fn rigid_motion_changes_no_path_and_scaling_scales_it() {
    let motion = Pose::from_xyz_rpy([40.0, -900.0, 120.0], [0.3, -1.1, 2.0]);
    let (points, _) = driven(&mut Noise::new(36, 0), &[250.0, 251.0, 249.0], 0.05, 0.002);
    let told = |f: &dyn Fn(Vector) -> Vector, length: f64| {
        let time_s = (0..points.len()).map(|i| i as f64 / RATE_HZ).collect();
        let stream = Stream::new(time_s, points.iter().map(|p| f(*p)).collect(), &[]).unwrap();
        let path = CommandedPath::new(PATH.map(f).to_vec(), &[]).unwrap();
        let planes = path.command_points(37);
        let found = passes(&stream, &planes, 10.0 * length).unwrap().complete;
        assert_eq!(found.len(), 3);
        let velocity = path_velocity(&found, &planes, 250.0 * length, 0.4).unwrap();
        let corner = cornering(&stream, &found, &planes, &path.corners(0.5)[0], Some(0.3 * length)).unwrap();
        let lengths = [
            path_accuracy(&found, &planes).unwrap().at_mm,
            path_repeatability(&found, &planes).unwrap().rt_mm,
            velocity.mean_mm_s,
            velocity.fv_mm_s,
            corner.round_off_mm,
            corner.overshoot_mm,
            corner.stabilisation_mm.unwrap(),
        ];
        (lengths.map(|l| l / length), [velocity.av_percent, velocity.rv_percent])
    };
    let still = told(&|p| p, 1.0);
    assert!(still.0.iter().all(|l| *l > 0.0), "{still:?}");
    for other in [told(&|p| motion.apply(p), 1.0), told(&|p| p.map(|x| 3.0 * x), 3.0)] {
        for (a, b) in still.0.iter().chain(&still.1).zip(other.0.iter().chain(&other.1)) {
            assert!((a - b).abs() < 1e-8, "{a} {b}");
        }
    }
}

#[test]
fn paths_that_are_none_are_refused() {
    assert!(CommandedPath::new(vec![], &[]).is_err() && CommandedPath::new(vec![[0.0; 3]], &[]).is_err());
    assert!(CommandedPath::new(vec![[0.0; 3]; 2], &[]).is_err(), "no length");
    assert!(CommandedPath::new(vec![[0.0; 3], [f64::NAN, 0.0, 0.0]], &[]).is_err());
    assert!(CommandedPath::new(PATH.to_vec(), &[vec![0.0; 3]]).is_err());
    assert!(CommandedPath::new(PATH.to_vec(), &[vec![0.0, f64::INFINITY, 0.0, 0.0]]).is_err());
    let stream = Stream::new(vec![0.0, 1.0], vec![[0.0; 3]; 2], &[]).unwrap();
    let points = path().command_points(10);
    for near in [0.0, -1.0, f64::NAN] {
        assert!(passes(&stream, &points, near).is_err());
    }
    assert!(passes(&stream, &points[..1], 1.0).is_err());
    assert!(path_accuracy(&[], &points).is_err() && path_repeatability(&[], &points).is_err());
    assert!(path_velocity(&[], &points, 1.0, 0.5).is_err());
    assert!(cornering(&stream, &[], &points, &path().corners(0.5)[0], None).is_err());
}
