//! Messages about the set-up of a synthetic arm.

use crate::support::arms::{SIX_AXES, serial};
use etalon::base::catalogue::{Argument, IntoArgument};
use etalon::base::message::{Message, Severity};
use etalon::base::noise::Noise;
use etalon::base::phrase;
use etalon::base::pose_name::PoseName;
use etalon::campaign::parse_robot;
use etalon::identify::{Effects, Observation, Prior, Settings, nominal_reading_slips, set_up_error, set_up_problem};
use etalon::robots::{Quantity, Robot, Role, Serial};
use etalon::stages::calibrate::evaluation::Judgement;
use etalon::stages::calibrate::solution::{Basis, Solution};
use etalon::stages::evaluate::sets::Sets;
use etalon::tasks::known_text;

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
fn messages(measured: (Serial, Vec<Observation>)) -> Vec<Message> {
    messages_validated(measured, Vec::new())
}

fn messages_validated((robot, calibration): (Serial, Vec<Observation>), validation: Vec<Observation>) -> Vec<Message> {
    let sets = Sets { calibration, validation, ..Sets::default() };
    let solution = Solution::new(&robot, Basis { sets, settings: settings(), ..Basis::default() }).expect("a solution");
    Judgement::new(&robot, &solution).plausibility
}

/// The messages of the altered arm contain this message, and the messages of the sound arm do not.
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
    hold("joint-zero-shifted", measured(50.0, 1.2), |all| all[30..].iter_mut().for_each(|o| o.joints[2] += 0.01));
    hold("poses-exchanged", measured(50.0, 1.2), |all| {
        let other = all[40].joints.clone();
        all[40].joints = std::mem::replace(&mut all[9].joints, other);
    });
}

fn is_error(message: &Message) -> bool {
    message.severity == Severity::Error
}

/// A reading that decides the result is an error, and the only one: the other readings describe the robot. One that decides nothing is a
/// warning.
#[test]
fn of_readings_that_decide() {
    let off = |mm: f64| {
        let (robot, mut all) = measured(50.0, 1.2);
        all[22].targets[0].as_mut().expect("measured")[0] += mm;
        messages((robot, all))
    };
    for mm in [0.5, 5.0, 300.0] {
        let found = off(mm);
        let errors: Vec<&Message> = found.iter().filter(|m| is_error(m)).collect();
        assert!(errors.len() == 1 && found[0].is("readings-decide", &[("count", &1), ("poses", &["23"])]), "{found:?}");
        assert!(found[0].hint.is_some() && found.iter().any(|m| m.is("outliers", &[])), "{found:?}");
    }
    let found = off(0.0);
    assert!(!found.iter().any(|m| is_error(m) || m.is("outliers", &[])), "{found:?}");
}

/// Base or measuring system was elsewhere at the first poses: this motion is named, and not the readings of these poses as mistakes.
#[test]
fn of_a_motion_after_the_first_poses() {
    let (robot, mut all) = measured(50.0, 1.2);
    let targets = all[..5].iter_mut().flat_map(|o| o.targets.iter_mut().flatten());
    targets.for_each(|at| *at = [at[0] + 1.2, at[1] - 1.6, at[2]]);
    let found = messages((robot, all));
    assert!(found.iter().any(|m| m.is("reference-moved", &[("pose", &"6"), ("previous", &"5")])), "{found:?}");
    assert!(!found.iter().any(|m| m.is("readings-decide", &[])), "{found:?}");
}

/// Joint values swapped between a calibration and a validation pose are named, and no third pose is.
#[test]
fn of_poses_swapped_across_the_sets() {
    let (robot, mut all) = measured(50.0, 1.2);
    let other = all[50].joints.clone();
    all[50].joints = std::mem::replace(&mut all[9].joints, other);
    let validation = all.split_off(45);
    let found = messages_validated((robot, all), validation);
    let pairs = [phrase!("pair-of-poses", first = PoseName::from(10), second = PoseName::from(51))];
    assert!(found.iter().any(|m| m.is("poses-exchanged", &[("count", &1), ("pairs", &pairs)])), "{found:?}");
    let texts: Vec<String> = found.iter().map(ToString::to_string).collect();
    let innocent = (1..=60).filter(|k| *k != 10 && *k != 51).map(|k| format!("pose {k},"));
    let accused: Vec<String> = innocent.filter(|name| texts.iter().any(|text| text.contains(name))).collect();
    assert!(accused.is_empty(), "{accused:?}: {texts:?}");
}

/// A lost decimal mark and a lost sign are named with the coordinate that agrees, before the identification and after it.
#[test]
fn of_coordinates_with_another_decimal_mark() {
    for (factor, row) in [(10.0, 7), (1e4, 33), (-1.0, 12)] {
        let (robot, mut all) = measured(50.0, 1.2);
        let at = all[row].targets[1].as_mut().expect("measured");
        let right_mm = at[0];
        at[0] *= factor;
        let slips = nominal_reading_slips(&robot, &all, &settings());
        let [wrong] = &slips.coordinates[..] else { panic!("{factor}: {slips:?}") };
        assert_eq!((wrong.axis, wrong.target.as_str(), wrong.pose), (0, "B", PoseName::from(row as i64 + 1)));
        assert!((wrong.changed_mm - right_mm).abs() < 1e-9 * right_mm.abs(), "{wrong:?}");
        let sets = Sets { calibration: all, ..Sets::default() };
        match Solution::new(&robot, Basis { sets, settings: settings(), ..Basis::default() }) {
            Ok(solution) => {
                let found = Judgement::new(&robot, &solution).plausibility;
                let named: [(&str, &dyn IntoArgument); 2] = [("count", &1), ("coordinates", &[wrong.phrase()])];
                assert!(found.iter().any(|m| m.is("coordinates-wrong", &named)), "{factor}: {found:?}");
            }
            // least squares ends without a result
            Err(problems) => {
                let Argument::Phrase(reason) = &problems.0[0].arguments["reason"] else { panic!("{problems:?}") };
                let named: [(&str, &dyn IntoArgument); 2] = [("wrong", &1), ("coordinates", &[wrong.phrase()])];
                assert!(reason.id == "readings-contradict", "{reason:?}");
                assert!(named.iter().all(|(key, value)| reason.arguments[*key] == value.argument()), "{reason:?}");
            }
        }
    }
}

/// Joint values in gon are named, and no other change is.
#[test]
fn of_joints_in_gon() {
    let (robot, mut observations) = measured(50.0, 1.2);
    observations.iter_mut().flat_map(|o| &mut o.joints).for_each(|q| *q /= 0.9);
    let found = set_up_error(&robot, &observations, &settings()).expect("gon");
    let gon = phrase!("slip-unit", quantity = "all-joints", slip = "gon-deg");
    assert!(found.changes.len() == 1 && found.changes[0].0 == gon, "{found:?}");
}

/// A robot that needs a length beyond its tolerance, where the table of a published robot agrees: this robot is named. The right
/// robot is not questioned.
#[test]
fn of_another_published_robot() {
    let build = |name: &str| {
        let text = known_text(name).expect("a published robot");
        parse_robot("robot.toml".as_ref(), &text).expect("robot.toml").build(&["A".to_owned()]).expect("a robot")
    };
    let (truth, given) = (build("ur10"), build("ur10e"));
    let mut noise = Noise::new(91, 1);
    let mut values = truth.nominal();
    for (p, v) in truth.parameters().iter().zip(&mut values).filter(|(p, _)| p.role == Role::Target) {
        *v = if p.name.ends_with('z') { 60.0 } else { 40.0 };
    }
    let observation = |pose: i64| {
        let joints: Vec<f64> = (0..6).map(|_| noise.uniform(1.2)).collect();
        let at = truth.position(&values, &joints, 0).map(|v| v + noise.gaussian(NOISE_MM));
        Observation { pose: pose.into(), cycle: 1, joints, targets: vec![Some(at)], ..Observation::default() }
    };
    let observations: Vec<Observation> = (1..=60).map(observation).collect();
    let named = |robot: &dyn Robot| set_up_error(robot, &observations, &settings());
    let found = named(given.as_ref()).expect("another robot");
    let alternatives: Vec<_> = given.alternatives().into_iter().map(|(what, _)| what).collect();
    assert!(found.changes.iter().all(|(what, _)| alternatives.contains(what)), "{found:?}");
    assert!(named(truth.as_ref()).is_none());
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
