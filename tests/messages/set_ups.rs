//! Messages about the set-up of a synthetic arm.

use crate::support::arms::{SIX_AXES, serial};
use etalon::base::message::Message;
use etalon::base::noise::Noise;
use etalon::identify::{Effects, Observation, Prior, Settings, set_up_problem};
use etalon::robots::{Quantity, Robot, Role, Serial};
use etalon::stages::calibrate::evaluation::Judgement;
use etalon::stages::calibrate::solution::{Basis, Solution};
use etalon::stages::evaluate::sets::Sets;

const NOISE_MM: f64 = 0.02;
/// An arm with two targets, of which the second is `off_axis_mm` from the axis of the last joint, at 60 poses in which the wrist turns by
/// up to `wrist_rad`.
fn measured(off_axis_mm: f64, wrist_rad: f64) -> (Serial, Vec<Observation>) {
    let robot = serial(&SIX_AXES, &["A", "B"], &[]);
    let mut noise = Noise::new(90, 1);
    let value = |p: &etalon::robots::Parameter| match (p.role, p.quantity) {
        (Role::Base, Quantity::Length) => 800.0,
        (Role::Base, _) => 0.4,
        (Role::Target, _) if p.name.ends_with('z') => 60.0,
        (Role::Target, _) => off_axis_mm * if p.name.starts_with('B') { 1.0 } else { 0.5 },
        (_, Quantity::Length) => p.nominal + 0.3,
        (_, Quantity::Angle) => p.nominal + 1e-3,
        _ => p.nominal,
    };
    let truth: Vec<f64> = robot.parameters().iter().map(value).collect();
    let observation = |pose: i64| {
        let range = |k: usize| if k < 3 { 1.2 } else { wrist_rad };
        let joints: Vec<f64> = (0..6).map(|k| noise.uniform(range(k))).collect();
        let targets = [0, 1].map(|k| Some(robot.position(&truth, &joints, k).map(|v| v + noise.gaussian(NOISE_MM))));
        Observation { pose: pose.into(), cycle: 1, joints, targets: targets.to_vec(), ..Observation::default() }
    };
    let observations = (1..=60).map(observation).collect();
    (robot, observations)
}

fn settings() -> Settings {
    Settings {
        standard_uncertainty_mm: Some(NOISE_MM),
        prior: Prior::TOLERANCES,
        effects: Effects::Usual,
        ..Settings::default()
    }
}

/// Messages of an identification of the arm.
fn messages((robot, observations): (Serial, Vec<Observation>)) -> Vec<Message> {
    let sets = Sets { calibration: observations, ..Sets::default() };
    let solution = Solution::new(&robot, Basis { sets, settings: settings(), ..Basis::default() }).expect("a solution");
    Judgement::new(&robot, &solution).plausibility
}

/// The messages of an arm that is altered have this one, and those of the arm as it is do not.
fn hold(id: &str, sound: (Serial, Vec<Observation>), alter: impl Fn(&mut Vec<Observation>)) {
    let (robot, mut observations) = (sound.0.clone(), sound.1.clone());
    alter(&mut observations);
    let [with, without] = [(robot, observations), sound].map(messages);
    assert!(with.iter().any(|m| m.is(id, &[])), "{id}: {with:?}");
    assert!(!without.iter().any(|m| m.is(id, &[])), "{id}: {without:?}");
}

#[test]
fn of_changes_of_a_set_up() {
    // from pose 31 on, the second target is 1 mm farther out
    let (_, slipped) = measured(50.0, 1.2);
    let (robot, _) = measured(50.0, 1.2);
    let direction = |o: &Observation| {
        let [a, b] = [0, 1].map(|k| o.targets[k].expect("measured"));
        let between = [0, 1, 2].map(|i| b[i] - a[i]);
        let length = between.iter().map(|v| v * v).sum::<f64>().sqrt();
        between.map(|v| v / length)
    };
    hold("target-shifted", (robot, slipped), |all| {
        for o in &mut all[30..] {
            let along = direction(o);
            let at = o.targets[1].as_mut().expect("measured");
            (0..3).for_each(|i| at[i] += along[i]);
        }
    });
    hold("poses-exchanged", measured(50.0, 1.2), |all| {
        let other = all[40].joints.clone();
        all[40].joints = std::mem::replace(&mut all[9].joints, other);
    });
}

#[test]
fn of_a_set_up_that_a_change_explains_better() {
    let (robot, mut observations) = measured(50.0, 0.04);
    let problem = |observations: &[Observation]| set_up_problem(&robot, observations, &settings()).0;
    assert!(problem(&observations).is_none());
    observations.iter_mut().for_each(|o| o.joints.swap(4, 5));
    let found = problem(&observations).expect("exchanged joints");
    assert!(found.is("set-up-contradicted", &[]), "{found:?}");
}

#[test]
fn of_what_the_data_do_not_show() {
    let has = |messages: &[Message]| messages.iter().any(|m| m.is("set-up-untested", &[]));
    let (on_axis, beside) = (messages(measured(0.0, 1.2)), messages(measured(50.0, 1.2)));
    assert!(has(&on_axis) && !has(&beside), "{on_axis:?} {beside:?}");
}
