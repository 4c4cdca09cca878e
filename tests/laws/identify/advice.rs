//! Advice to identify a further effect: at fresh poses, the error falls to what the advice says. Models are incomplete, and everything is
//! drawn (synthetic). `ETALON_CAMPAIGNS` states how many campaigns of each kind.

use super::drawn::number;
use super::regional::{Campaign, LEFT_OUT, Measured, Twin};
use etalon::base::noise::Noise;
use etalon::identify::{Effects, Identification, Settings, Status, effects, identify};
use etalon::robots::Robot;
use etalon::stages::calibrate::cross_validation::LeftOut;
use etalon::stages::evaluate::sets::Sets;
use rayon::prelude::*;

/// Calibration poses, and fresh ones.
const POSES: [usize; 2] = [80, 400];
/// Ratio of errors at fresh poses and promised ones that the few calibration poses allow.
const REACHED: f64 = 1.3;

/// Errors (mm, root mean square of a position) at fresh poses without and with an advised effect, and the promised one.
fn advised(twin: &Twin, campaign: &Campaign, fresh: &Campaign) -> Vec<[f64; 3]> {
    let Campaign { observations, settings } = campaign.clone();
    let robot = &twin.robot;
    let found = identify(robot, &observations, &settings).expect("identified");
    let position_mm = |found: &Identification| 3f64.sqrt() * twin.rms_mm(fresh, &found.values);
    let kinds = effects(robot, observations.iter().map(|o| o.joints.as_slice()));
    let sets = Sets { calibration: observations, ..Sets::default() };
    let with = |effect| {
        let is_held = |&i: &usize| found.status[i] == Status::Fixed && kinds[i].map(Into::into) != Some(effect);
        let held = (0..kinds.len()).filter(is_held).map(|i| robot.parameters()[i].name.clone());
        let settings = Settings {
            effects: Effects::All,
            hold: settings.hold.iter().cloned().chain(held).collect(),
            ..settings.clone()
        };
        position_mm(&identify(robot, &sets.calibration, &settings).expect("identified"))
    };
    let left_out = LeftOut::new(robot, &sets, &settings, &found).expect("errors at left-out poses");
    let advice = left_out.unused(robot, &found);
    advice.iter().map(|proof| [position_mm(&found), with(proof.effect), proof.with_mm]).collect()
}

#[test]
#[ignore = "a long law: make laws"]
fn advised_effects_bring_what_the_advice_says() {
    let count = number("ETALON_CAMPAIGNS", 10);
    let one = |seed: u64| {
        let ratio = [5.0, 10.0, 20.0][seed as usize % 3];
        let twin = Twin::drawn(Measured::Positions, LEFT_OUT[seed as usize % LEFT_OUT.len()], ratio, 950 + seed);
        let mut noise = Noise::new(73, seed);
        let [campaign, fresh] = POSES.map(|poses| twin.observed(poses, 1.0, &mut noise));
        advised(&twin, &campaign, &fresh)
    };
    let all: Vec<[f64; 3]> = (0..4 * count).into_par_iter().flat_map(one).collect();
    let worse: Vec<_> = all.iter().filter(|[without, with, _]| with > without).collect();
    let missed: Vec<_> = all.iter().filter(|[_, with, promised]| *with > REACHED * promised).collect();
    println!(
        "{} campaigns, {} pieces of advice, {} worse, {} missed: {missed:?}",
        4 * count,
        all.len(),
        worse.len(),
        missed.len()
    );
    assert!(!all.is_empty());
    assert!(20 * worse.len() <= all.len(), "{worse:?}");
    assert!(10 * missed.len() <= all.len(), "{missed:?}");
}
