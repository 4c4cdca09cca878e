//! Weaves and loads against what was drawn and what is found by hand.

use crate::standards::iso9283::close;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, dot, minus};
use etalon::standards::iso9283::load::{Loaded, compliance};
use etalon::standards::iso9283::motion::stream::Stream;
use etalon::standards::iso9283::path::weaving::{Weave, weaving};

const RATE_HZ: f64 = 500.0;

#[test]
fn a_weave_has_the_stroke_and_the_frequency_that_were_drawn() {
    let motion = Pose::from_xyz_rpy([4.0, -9.0, 12.0], [0.3, -1.1, 2.0]);
    let mut noise = Noise::new(37, 0);
    let weave = Weave { across: [0.3, 1.0, 0.0], stroke_mm: 5.0, frequency_hz: 3.0 };
    for sigma in [0.0, 0.01] {
        let points: Vec<Vector> = (0..5000)
            .map(|i| {
                let t = f64::from(i) / RATE_HZ;
                let swing = 2.6 * (std::f64::consts::TAU * 2.9 * t).sin();
                motion.apply([10.0 * t, swing, 0.0].map(|x| x + noise.gaussian(sigma)))
            })
            .collect();
        let time_s = (0..points.len()).map(|i| i as f64 / RATE_HZ).collect();
        let stream = Stream::new(time_s, points, &[]).unwrap();
        let turned = Weave { across: motion.rotate(weave.across), ..weave };
        let along = motion.rotate([1.0, 0.0, 0.0]);
        let found = weaving(&stream, 0..stream.len(), along, &turned).unwrap();
        // extremes of noisy samples lie outside by some sigma; ten seconds at 2.9 Hz have 58 turns, two do not count
        assert!((found.stroke_mm - 5.2).abs() < 1e-3 + 5.0 * sigma, "{found:?}");
        assert!((found.frequency_hz - 2.9).abs() < 1e-3 + 1.0 * sigma && (55..=57).contains(&found.turns), "{found:?}");
        close(found.ws_percent, (found.stroke_mm - 5.0) / 5.0 * 100.0);
        close(found.wf_percent, (found.frequency_hz - 3.0) / 3.0 * 100.0);
        assert!(weaving(&stream, 0..100, along, &turned).is_err() && weaving(&stream, 0..0, along, &turned).is_err());
        assert!(weaving(&stream, 0..5000, along, &Weave { across: along, ..turned }).is_err());
        assert!(weaving(&stream, 0..5000, along, &Weave { stroke_mm: f64::NAN, ..turned }).is_err());
    }
}

#[test]
fn compliance_is_the_slope_that_least_squares_by_hand_gives() {
    let motion = Pose::from_xyz_rpy([40.0, -900.0, 120.0], [0.3, -1.1, 2.0]);
    let mut noise = Noise::new(38, 0);
    let readings: Vec<Loaded> = (0..30)
        .map(|i| {
            let force_n = 10.0 * f64::from(i % 10 + 1);
            let given = [0.002 * force_n + noise.gaussian(0.001), noise.gaussian(0.5), 0.0];
            Loaded { force_n, position_mm: motion.apply(given), unloaded_mm: motion.apply([0.0; 3]) }
        })
        .collect();
    let along = motion.rotate([1.0, 0.0, 0.0]);
    let found = compliance(&readings, along).unwrap();
    let given = |r: &Loaded| dot(minus(r.position_mm, r.unloaded_mm), along);
    // the slope at which Σ (d - c F)² does not fall any more, by search
    let cost = |c: f64| readings.iter().map(|r| (given(r) - c * r.force_n).powi(2)).sum::<f64>();
    let (mut low, mut high) = (0.0, 0.01);
    for _ in 0..200 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        (low, high) = if cost(a) < cost(b) { (low, b) } else { (a, high) };
    }
    assert!((found.compliance_mm_n - low).abs() < 1e-9, "{found:?} {low}");
    let off = readings.iter().map(|r| (given(r) - found.compliance_mm_n * r.force_n).abs()).fold(0.0, f64::max);
    close(found.off_line_mm, off);
    close(found.largest_mm, readings.iter().map(given).fold(0.0, f64::max));
    let forces: f64 = readings.iter().map(|r| r.force_n.powi(2)).sum();
    close(found.standard_uncertainty_mm_n, (cost(found.compliance_mm_n) / 29.0 / forces).sqrt());
    assert!((found.compliance_mm_n - 0.002).abs() < 4.0 * found.standard_uncertainty_mm_n);
    assert!(compliance(&[], along).is_err());
    assert!(compliance(&[Loaded { force_n: 0.0, ..readings[0] }], along).is_err());
    assert!(compliance(&[Loaded { position_mm: [f64::NAN; 3], ..readings[0] }], along).is_err());
}
