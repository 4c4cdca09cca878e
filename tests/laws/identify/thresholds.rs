//! Limits that README.md promises, met from both sides with numbers worked out by hand.

use etalon::identify::{Identification, Observation, Settings, SingularValue, Status, UncertaintyFrom, identify};
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
        Observation {
            pose: (i as i64 + 1).into(),
            cycle: 1,
            joints: q.to_vec(),
            targets: vec![moved(0), moved(1)],
            ..Observation::default()
        }
    };
    (0..count).map(observe).collect()
}

/// Identifies `d` and `l_kl` where a coordinate has the standard uncertainty `u_mm`.
fn two_lengths(observations: &[Observation], u_mm: f64) -> Identification {
    let robot = Prexyt::default();
    let names = robot.parameters().iter().map(|p| p.name.clone());
    let hold = names.filter(|name| name != "d" && name != "l_kl").collect();
    let settings = Settings { standard_uncertainty_mm: Some(u_mm), hold, ..Settings::default() };
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
    assert!(
        unknown
            .warnings
            .iter()
            .any(|w| w.is("parameter-separable-poorly", &[("parameter", &"d"), ("others", &["`l_kl`"])])),
        "{:?}",
        unknown.warnings
    );
}

/// The normal matrix [2 1; 1 1] with a unit diagonal is [1 c; c 1], c = 1/√2: singular values √(1 ± c), both parameters in each.
#[test]
fn singular_values_are_those_worked_out_by_hand_and_stay_told_where_a_parameter_is_held() {
    let robot = Prexyt::default();
    let both = [robot.index("d").unwrap(), robot.index("l_kl").unwrap()];
    let [large, small] = [1.0, -1.0].map(|sign| (1.0 + sign * 0.5f64.sqrt()).sqrt());
    let close = |s: &SingularValue, value: f64, parameters: &[usize]| {
        let mut members = s.parameters.clone();
        members.sort_unstable();
        assert!((s.value - value).abs() < 1e-9 && members == parameters, "{s:?} instead of {value} {parameters:?}");
    };
    let observations = level_poses(4, |_| 0.0);
    let known = two_lengths(&observations, 19.9).identifiability.observability.unwrap();
    close(&known.singular_values[0], large, &both);
    close(&known.singular_values[1], small, &both);
    assert!((known.condition - large / small).abs() < 1e-9 && known.held_singular_values.is_empty());
    let held = two_lengths(&observations, 20.1).identifiability.observability.unwrap();
    close(&held.singular_values[0], 1.0, &both[1..]);
    close(&held.held_singular_values[0], small, &both);
    assert_eq!((held.rank, held.singular_values.len(), held.held_singular_values.len()), (1, 1, 1));
}

#[test]
fn chi_square_rejects_once_in_a_thousand_times_at_both_ends() {
    // 8 poses of 4 coordinates and 2 parameters: 30 degrees of freedom, for which tables have 59.703 and 11.588
    let observations = level_poses(8, |i| 0.001 * (1.7 * (i * i) as f64).sin());
    let before = two_lengths(&observations, 0.001);
    assert_eq!(before.residuals.degrees_of_freedom, 30);
    let with_chi_square = |chi: f64| {
        let found = two_lengths(&observations, 0.001 * (before.residuals.chi_square.unwrap() / chi).sqrt());
        assert!((found.residuals.chi_square.unwrap() - chi).abs() < 1e-6, "{:?}", found.residuals.chi_square);
        let said = found.warnings.iter().map(|w| w.id.as_ref()).collect::<Vec<_>>().join("\n");
        (found.uncertainty.from == UncertaintyFrom::Instrument, said)
    };
    for (chi, kept, remarked) in [(11.5, true, true), (11.7, true, false), (59.6, true, false), (59.8, false, false)] {
        let (instrument, said) = with_chi_square(chi);
        assert_eq!((instrument, said.contains("instrument-uncertainty-too-large")), (kept, remarked), "{chi}: {said}");
        assert_eq!(
            (said.contains("instrument-uncertainty-too-large") || said.contains("residuals-exceed-uncertainty")),
            !kept || remarked,
            "{chi}: {said}"
        );
    }
}
