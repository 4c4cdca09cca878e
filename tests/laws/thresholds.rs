//! Limits that README.md promises, met from both sides with numbers worked out by hand.

use etalon::identify::{Identification, Observation, ResidualKind, Settings, Status, UncertaintyFrom, identify};
use etalon::robots::{Prexyt, Robot};

/// Poses at theta = 0 of the nominal PreXYT, and of K and L what `error_mm` makes of them.
///
/// With all held but `d` and `l_kl`, K and L move with `d` along x alone, and L with `l_kl` likewise: n poses have the
/// normal matrix [2n n; n n] / u², so that u(d) = u / √n and u(l_kl) = √2 u / √n.
fn level_poses(count: usize, error_mm: impl Fn(usize) -> f64) -> Vec<Observation> {
    let robot = Prexyt::default();
    let observe = |i: usize| {
        let q = [20.0 * i as f64, 15.0 * i as f64, 15.0 * i as f64];
        let balls = robot.balls(&robot.nominal(), &q);
        let moved =
            |k: usize| Some([balls[k][0] + error_mm(4 * i + 2 * k), balls[k][1] + error_mm(4 * i + 2 * k + 1), 0.0]);
        Observation { pose: i as i64 + 1, cycle: 1, joints: q.to_vec(), targets: vec![moved(0), moved(1)] }
    };
    (0..count).map(observe).collect()
}

/// Identifies `d` and `l_kl` where a coordinate has the standard uncertainty `u_mm`.
fn two_lengths(observations: &[Observation], u_mm: f64) -> Identification {
    let robot = Prexyt::default();
    let names = robot.parameters().iter().map(|p| p.name.clone());
    let hold = names.filter(|name| name != "d" && name != "l_kl").collect();
    let settings = Settings {
        kind: ResidualKind::Targets,
        standard_uncertainty_mm: Some(u_mm),
        common_uncertainty_mm: None,
        hold,
    };
    identify(&robot, observations, &settings).unwrap()
}

#[test]
fn a_length_of_the_robot_is_identified_up_to_10_mm_and_held_beyond() {
    let d = Prexyt::default().index("d").unwrap();
    let observations = level_poses(4, |_| 0.0);
    let known = two_lengths(&observations, 19.9);
    assert!((known.standard_uncertainty(d).unwrap() - 9.95).abs() < 1e-6, "{known:?}");
    let unknown = two_lengths(&observations, 20.1);
    assert_eq!(unknown.status[d], Status::NotIdentifiable);
    assert!(unknown.warnings.iter().any(|w| w.what.contains("`d` from `l_kl` only")), "{:?}", unknown.warnings);
}

#[test]
fn chi_square_rejects_once_in_a_thousand_times_at_both_ends() {
    // 8 poses of 4 coordinates and 2 parameters: 30 degrees of freedom, for which tables have 59.703 and 11.588
    let observations = level_poses(8, |i| 0.001 * (1.7 * (i * i) as f64).sin());
    let before = two_lengths(&observations, 0.001);
    assert_eq!(before.degrees_of_freedom, 30);
    let with_chi_square = |chi: f64| {
        let found = two_lengths(&observations, 0.001 * (before.chi_square.unwrap() / chi).sqrt());
        assert!((found.chi_square.unwrap() - chi).abs() < 1e-6, "{:?}", found.chi_square);
        let said = found.warnings.iter().map(|w| w.what.as_str()).collect::<Vec<_>>().join("\n");
        (found.uncertainty_from == UncertaintyFrom::Instrument, said)
    };
    for (chi, kept, remarked) in [(11.5, true, true), (11.7, true, false), (59.6, true, false), (59.8, false, false)] {
        let (instrument, said) = with_chi_square(chi);
        assert_eq!((instrument, said.contains("stated uncertainty is larger")), (kept, remarked), "{chi}: {said}");
        assert_eq!(
            said.contains("times what the instrument's uncertainty explains"),
            !kept || remarked,
            "{chi}: {said}"
        );
    }
}
