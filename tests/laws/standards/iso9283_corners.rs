//! Corners of a commanded path: what is told of them, and that they part no pass.

use etalon::base::pose::{Vector, minus, norm};
use etalon::standards::iso9283::motion::stream::Stream;
use etalon::standards::iso9283::path::commanded::CommandedPath;
use etalon::standards::iso9283::path::cornering::cornering;
use etalon::standards::iso9283::path::passes::passes;
use etalon::standards::iso9283::path::velocity::path_velocity;

const RATE_HZ: f64 = 500.0;

/// A corner rounded by an arc of radius r is missed by r (√2 - 1); one that is overrun by a half-circle of radius r leaves
/// the second leg by r.
#[test]
fn round_off_and_overshoot_of_a_corner_are_those_drawn() {
    let corner = CommandedPath::new(vec![[0.0; 3], [100.0, 0.0, 0.0], [100.0, 100.0, 0.0]], &[]).unwrap();
    let points = corner.command_points(40);
    let corners = corner.corners(0.5);
    assert_eq!(corners.len(), 1);
    let drawn = |turn: &dyn Fn(f64) -> Vector| {
        let straight = |from: Vector, to: Vector| {
            (0..2000).map(move |i| [0, 1, 2].map(|k| from[k] + f64::from(i) / 2000.0 * (to[k] - from[k])))
        };
        let turned: Vec<Vector> = (0..=2000).map(|i| turn(f64::from(i) / 2000.0)).collect();
        let ends = (turned[0], turned[2000]);
        straight([-5.0, 0.0, 0.0], ends.0)
            .chain(turned)
            .chain(straight(ends.1, [100.0, 105.0, 0.0]))
            .collect::<Vec<_>>()
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    let measure = |all: Vec<Vector>, limit: f64| {
        // a curve ends where the next begins: the same place twice, but later
        let time_s = (0..all.len()).map(|i| i as f64 / RATE_HZ).collect();
        let stream = Stream::new(time_s, all, &[]).unwrap();
        let found = passes(&stream, &points, 15.0).unwrap();
        assert_eq!(found.complete.len(), 1);
        cornering(&stream, &found.complete, &points, &corners[0], Some(limit)).unwrap()
    };
    let round = measure(
        drawn(&|t| {
            let (sin, cos) = (quarter * t).sin_cos();
            [95.0 + 5.0 * sin, 5.0 - 5.0 * cos, 0.0]
        }),
        0.1,
    );
    assert!((round.round_off_mm - 5.0 * (2f64.sqrt() - 1.0)).abs() < 1e-4 && round.overshoot_mm < 1e-12, "{round:?}");
    // on the arc 0.1 mm of the second leg are left where 5 (1 - sin) = 0.1
    let left = 5.0 - 5.0 * (1.0f64 - 0.98 * 0.98).sqrt();
    assert!((round.stabilisation_mm.unwrap() - left).abs() < 0.01, "{round:?} {left}");

    let over = measure(
        drawn(&|t| {
            let (sin, cos) = (2.0 * quarter * t).sin_cos();
            [100.0 + 2.0 * sin, 2.0 - 2.0 * cos, 0.0]
        }),
        0.1,
    );
    assert!((over.overshoot_mm - 2.0).abs() < 1e-3 && over.round_off_mm < 1e-3, "{over:?}");
    assert_eq!(measure(drawn(&|_| [100.0, 0.0, 0.0]), 0.1).round_off_mm, 0.0);
    // one sample at the corner, and the next far off: the way between counts
    let coarse = vec![[-5.0, 0.0, 0.0], [99.5, 0.0, 0.0], [100.0, 105.0, 0.0]];
    let rough = measure(coarse, 0.1);
    assert!((rough.round_off_mm - 0.5).abs() < 0.01, "{rough:?}");
}

#[test]
fn command_points_are_left_on_both_sides_of_a_corner_however_short_a_leg_is() {
    let short = CommandedPath::new(vec![[0.0; 3], [8.0, 0.0, 0.0], [8.0, 200.0, 0.0]], &[]).unwrap();
    let points = short.command_points_beside(208, 0.5, 10.0);
    let before = points.iter().filter(|p| p.along_mm < 8.0).count();
    // up to two of eight millimetres are left out before it, and ten behind it
    assert_eq!((before, points.iter().filter(|p| p.along_mm < 18.0).count()), (6, 6));
}

/// Three cycles round a corner with a wide arc, the second leg farther out each time: planes near the corner are gone through
/// in another order than they are commanded, and no pass may be made of two.
#[test]
fn a_widely_rounded_corner_parts_no_pass() {
    let corner = CommandedPath::new(vec![[0.0; 3], [200.0, 0.0, 0.0], [200.0, 200.0, 0.0]], &[]).unwrap();
    for (radius, near_mm) in [(5.0, 10.0), (15.0, 10.0), (25.0, 10.0), (60.0, 25.0)] {
        let mut all: Vec<Vector> = Vec::new();
        for cycle in 0..3 {
            let out = f64::from(cycle);
            let line = |from: Vector, to: Vector| {
                let steps = (norm(minus(to, from)) / 0.5).ceil() as usize;
                (0..steps).map(move |i| [0, 1, 2].map(|k| from[k] + i as f64 / steps as f64 * (to[k] - from[k])))
            };
            let from = [200.0 - radius, 0.0, 0.0];
            all.extend(line([-20.0, 0.0, 0.0], from));
            let steps = (std::f64::consts::PI * radius) as usize;
            all.extend((0..steps).map(|i| {
                let (sin, cos) = (i as f64 / steps as f64 * std::f64::consts::FRAC_PI_2).sin_cos();
                [from[0] + (radius + out) * sin, radius * (1.0 - cos), 0.0]
            }));
            all.extend(line([200.0 + out, radius, 0.0], [200.0 + out, 220.0, 0.0]));
            all.extend(line([200.0 + out, 220.0, 0.0], [-20.0, 220.0, 50.0]));
            all.extend(line([-20.0, 220.0, 50.0], [-20.0, 0.0, 0.0]));
        }
        let time_s = (0..all.len()).map(|i| i as f64 / RATE_HZ).collect();
        let stream = Stream::new(time_s, all, &[]).unwrap();
        let points = corner.command_points_beside(50, 0.5, near_mm);
        let found = passes(&stream, &points, near_mm).unwrap();
        assert_eq!((found.complete.len(), found.incomplete), (3, 0), "{radius}");
        for (cycle, pass) in found.complete.iter().enumerate() {
            assert!(pass.crossings.windows(2).all(|c| c[0].time_s < c[1].time_s), "{radius}");
            let end = pass.crossings[points.len() - 1].position_mm;
            assert!((end[0] - 200.0 - cycle as f64).abs() < 1e-9, "{radius}: {end:?}");
        }
        // from sample to sample it is half a millimetre; no velocity is told across the corner
        let velocity = path_velocity(&found.complete, &points, 0.5 * RATE_HZ, 0.5).unwrap();
        assert!(radius > near_mm || velocity.fv_mm_s < 0.02 * velocity.mean_mm_s, "{radius}: {velocity:?}");
        let round = cornering(&stream, &found.complete, &points, &corner.corners(0.5)[0], None).unwrap();
        assert!((round.round_off_mm - radius * (2f64.sqrt() - 1.0)).abs() < 1.5, "{radius}: {round:?}");
    }
}
