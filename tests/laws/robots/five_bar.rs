//! The five-bar: laws of its model, and what an identification makes of it.

use crate::support::five_bar::{SEVEN, measure, robot, settings, truth};
use crate::support::linearised::linearised;
use etalon::base::noise::Noise;
use etalon::identify::{Identification, Observation, fit_frames, identify, identify_from};
use etalon::robots::{FiveBar, Robot, WORKING_MODES};

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
                let (sin, cos) = p[11].sin_cos(); // eq. 4.21
                let world = [p[9] + cos * e[0] - sin * e[1], p[10] + sin * e[0] + cos * e[1]];
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
        let held =
            found.identifiability.groups.iter().map(|g| g.with.iter().chain([&g.held]).copied().collect::<Vec<_>>());
        let sets = held.chain(found.identifiability.weak.iter().map(|w| w.parameters.clone()));
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
            Observation {
                pose: (k as i64).into(),
                cycle: 1,
                joints,
                targets: vec![Some(measured)],
                ..Observation::default()
            }
        };
        let one: Vec<Observation> = SEVEN.iter().enumerate().map(&mut observe).collect();
        let found = identify(&robot, &one, &settings(0.01)).expect("identified");
        println!(
            "{branches:?}: {:?}, condition {:.0}",
            told(&found),
            found.identifiability.observability.as_ref().expect("told").condition
        );
        assert!(!told(&found).is_empty());
        assert!(found.warnings.iter().any(|w| w.what.contains("identifiable")), "{:?}", found.warnings);
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
