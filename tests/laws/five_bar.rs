//! The five-bar: laws of its model, and what an identification makes of it.

use crate::linearised::linearised;
use etalon::base::noise::Noise;
use etalon::math::identify::{
    Identification, Observation, ResidualKind, Settings, fit_frames, identify, identify_from,
};
use etalon::math::robots::{FiveBar, Limits, Robot, WORKING_MODES};

/// "Actual" column of table 4.1, in the order of eq. 4.24.
pub fn truth() -> Vec<f64> {
    let deg = f64::to_radians;
    vec![
        230.010,
        230.110,
        229.880,
        230.403,
        275.102,
        230.210,
        deg(1.948),
        deg(1.306),
        deg(-0.401),
        263.391,
        75.499,
        deg(0.573),
    ]
}

/// The nominal robot with limits: a proximal link does not cross the other arm's distal link, 5 degrees away from
/// singularities of type 1, 25 from type 2.
pub fn robot() -> FiveBar {
    FiveBar::default().with_limits(Limits {
        clearance_mm: Some(0.0),
        type1_margin_rad: 5f64.to_radians(),
        type2_margin_rad: 25f64.to_radians(),
        ..Limits::default()
    })
}

/// The holes of the plate in the world: 24 × 24 at 25.4 mm, P2 the origin (section 4.2, 4.3.1).
pub fn holes() -> Vec<(usize, usize, [f64; 2])> {
    let place = |i: usize, first: f64| first + 25.4 * i as f64;
    (0..24).flat_map(|i| (0..24).map(move |j| (i, j, [place(i, -25.4), place(j, -228.6)]))).collect()
}

/// What a measurement of the true robot at `positions` says, in all working modes that reach them by the drawing.
pub fn measure(
    robot: &FiveBar,
    truth: &[f64],
    positions: &[[f64; 2]],
    noise: &mut dyn FnMut() -> f64,
) -> Vec<Observation> {
    let nominal = robot.nominal();
    let mut all = Vec::new();
    for (k, p) in positions.iter().enumerate() {
        let e = robot.to_base(truth, *p);
        for (cycle, mode) in robot.reached(&nominal, robot.to_base(&nominal, *p)).into_iter().enumerate() {
            let q = robot.inverse(truth, e, mode.branches);
            if q.iter().any(|q| !q.is_finite()) {
                continue; // the true robot is a little too short
            }
            let joints = vec![q[0], q[1], robot.assembly_at(truth, q, e)];
            let measured = [p[0] + noise(), p[1] + noise(), 0.0];
            all.push(Observation { pose: k as i64, cycle: cycle as i64 + 1, joints, targets: vec![Some(measured)] });
        }
    }
    all
}

pub fn settings(u_mm: f64) -> Settings {
    Settings {
        kind: ResidualKind::Targets,
        standard_uncertainty_mm: Some(u_mm),
        common_uncertainty_mm: None,
        hold: Vec::new(),
    }
}

/// Seven positions around the plate.
pub const SEVEN: [[f64; 2]; 7] =
    [[-25.4, 50.8], [50.8, 304.8], [177.8, 355.6], [381.0, 355.6], [533.4, 101.6], [406.4, -228.6], [101.6, -203.2]];

#[test]
fn direct_undoes_inverse_in_all_working_modes_of_disturbed_robots() {
    let robot = FiveBar::default();
    let mut reached = [0; 2];
    for seed in 0..50 {
        let mut noise = Noise::new(5, seed);
        let p: Vec<f64> = truth().iter().map(|v| v + noise.uniform(0.03) * v.abs().max(1.0)).collect();
        for i in 0..20 {
            let angle = f64::from(i) * 0.33;
            let e = [(60.0 + 15.0 * f64::from(i)) * angle.cos(), (60.0 + 15.0 * f64::from(i)) * angle.sin()];
            for mode in WORKING_MODES {
                let q = robot.inverse(&p, e, mode);
                if q.iter().any(|q| !q.is_finite()) {
                    continue;
                }
                let assembly = robot.assembly_at(&p, q, e);
                let back = robot.direct(&p, q, assembly);
                assert!((back.e[0] - e[0]).hypot(back.e[1] - e[1]) < 1e-9, "{e:?} {mode:?} {back:?}");
                let lengths = [(back.b1, p[1]), (back.b2, p[3])];
                assert!(lengths.iter().all(|(b, l)| ((back.c[0] - b[0]).hypot(back.c[1] - b[1]) - l).abs() < 1e-9));
                assert!(((back.e[0] - back.b2[0]).hypot(back.e[1] - back.b2[1]) - p[5]).abs() < 1e-9);
                reached[usize::from(assembly < 0.0)] += 1;
                let world = robot.to_world(&p, e);
                let base = robot.to_base(&p, world);
                assert!((base[0] - e[0]).abs() < 1e-10 && (base[1] - e[1]).abs() < 1e-10);
            }
        }
    }
    assert!(reached.iter().all(|n| *n > 500), "both assembly modes must occur: {reached:?}");
}

#[test]
fn a_tool_on_the_joint_gives_the_thesis_branches() {
    // eq. 4.9: a branch index of +1 turns clockwise from the line to C
    let robot = FiveBar::default();
    let p = robot.nominal();
    for mode in WORKING_MODES {
        let q = robot.inverse(&p, [0.0, 300.0], mode);
        let at = robot.direct(&p, q, robot.assembly_at(&p, q, [0.0, 300.0]));
        let side = |a: f64, b: [f64; 2]| (0.0 - a) * b[1] - 300.0 * (b[0] - a);
        assert!(side(-137.5, at.b1) * mode[0] < 0.0 && side(137.5, at.b2) * mode[1] < 0.0, "{mode:?} {at:?}");
    }
}

#[test]
fn noise_free_identification_gives_the_truth_in_at_most_eight_steps() {
    let (robot, truth) = (robot(), truth());
    let observations = measure(&robot, &truth, &SEVEN, &mut || 0.0);
    assert!(observations.len() > 14, "{}", observations.len());
    let check = |values: &[f64]| {
        for ((p, value), truth) in robot.parameters().iter().zip(values).zip(&truth) {
            assert!((value - truth).abs() < 1e-9, "{} {value} {truth}", p.name);
        }
    };
    let from_nominal = identify_from(&robot, &observations, &settings(0.01), &robot.nominal()).expect("identified");
    check(&from_nominal.values);
    check(&identify(&robot, &observations, &settings(0.01)).expect("identified").values);
    let (values, iterations) = linearised(&robot, &observations);
    check(&values);
    println!("steps: {} in the trust region, {iterations} linearised", from_nominal.iterations);
    assert!(from_nominal.iterations <= 8 && iterations <= 8);
}

#[test]
fn the_linearised_iteration_of_the_thesis_and_the_trust_region_agree() {
    let (robot, truth) = (robot(), truth());
    for seed in 0..20 {
        let mut noise = Noise::new(6, seed);
        let observations = measure(&robot, &truth, &SEVEN, &mut || noise.gaussian(0.01));
        let found = identify(&robot, &observations, &settings(0.01)).expect("identified");
        let (values, _) = linearised(&robot, &observations);
        for ((p, a), b) in robot.parameters().iter().zip(&found.values).zip(&values) {
            assert!((a - b).abs() < 1e-10, "{} {a} {b}", p.name);
        }
    }
}

#[test]
fn one_working_mode_alone_leaves_parameters_that_are_named() {
    let robot = FiveBar::default();
    let truth = truth();
    let told = |found: &Identification| -> Vec<Vec<String>> {
        let held = found.groups.iter().map(|g| g.with.iter().chain([&g.held]).copied().collect::<Vec<_>>());
        let sets = held.chain(found.weak.iter().map(|w| w.parameters.clone()));
        let name = |i: usize| robot.parameters()[i].name.clone();
        sets.map(|set| set.into_iter().map(name).collect()).collect()
    };
    let full = measure(&robot, &truth, &SEVEN, &mut || 0.0);
    assert!(told(&identify(&robot, &full, &settings(0.01)).expect("identified")).is_empty());
    for branches in WORKING_MODES {
        let mut noise = Noise::new(7, 0);
        let mut observe = |(k, p): (usize, &[f64; 2])| {
            let e = robot.to_base(&truth, *p);
            let q = robot.inverse(&truth, e, branches);
            let joints = vec![q[0], q[1], robot.assembly_at(&truth, q, e)];
            let measured = [p[0] + noise.gaussian(0.01), p[1] + noise.gaussian(0.01), 0.0];
            Observation { pose: k as i64, cycle: 1, joints, targets: vec![Some(measured)] }
        };
        let one: Vec<Observation> = SEVEN.iter().enumerate().map(&mut observe).collect();
        let found = identify(&robot, &one, &settings(0.01)).expect("identified");
        println!(
            "{branches:?}: {:?}, condition {:.0}",
            told(&found),
            found.observability.as_ref().expect("told").condition
        );
        assert!(!told(&found).is_empty());
        assert!(found.warnings.iter().any(|w| w.what.contains("tell apart")), "{:?}", found.warnings);
    }
}

#[test]
fn frames_first_then_all_parameters() {
    // a plate that stands elsewhere than drawn: base found first, then all
    let robot = robot();
    let mut truth = truth();
    (truth[9], truth[10], truth[11]) = (270.0, 60.0, 0.03);
    let observations = measure(&robot, &truth, &SEVEN, &mut || 0.0);
    let before = fit_frames(&robot, &observations, &settings(0.01)).expect("frames");
    assert!((before[9] - 270.0).abs() < 8.0 && before[0] == 230.0, "{before:?}");
    let found = identify_from(&robot, &observations, &settings(0.01), &before).expect("identified");
    assert!(found.values.iter().zip(&truth).all(|(v, t)| (v - t).abs() < 1e-9));
}
