//! Drawn arms with one slip each: nearly all are refused or warned about, and most by the right cause; without the slip no cause is named. The
//! data are synthetic. `ETALON_SLIPS` is the number of arms, `ETALON_SLIPS_FIRST` the first seed.

use super::drawn::{Drawn, drawn_arm, number};
use super::set_ups::{Bench, Slip, slips_of_joints, slips_of_points, spoilt};
use crate::identify::set_ups::messages_alone;
use etalon::base::message::{Message, Problems, Rank, Severity};
use etalon::base::noise::Noise;
use etalon::identify::{Effects, Observation, Prior, Settings, chi_square_exceeds};
use etalon::robots::Robot;
use etalon::stages::calibrate::solution::{Basis, Solution};
use etalon::stages::evaluate::sets::Sets;
use etalon::stages::observe::repeats::stale;
use rayon::prelude::*;

/// Words of a message that names a cause.
const NAMES_A_CAUSE: &str = "check that first";
/// Most poses of an arm.
const POSES: usize = 120;
/// Fewest poses of an arm: fewer show no slip.
const FEWEST: usize = 20;
/// Chi-square beyond that without the slip, relatively, that the slip shows by.
const SHOWS: f64 = 1.5;

/// What is said of observations, and chi-square for each degree of freedom of a result whose parameters are within their tolerances.
struct Said {
    messages: Vec<Message>,
    chi_square: Option<f64>,
    exceeds: bool,
}

fn said(robot: &dyn Robot, observations: &[Observation], u_mm: f64) -> Said {
    let settings = Settings {
        standard_uncertainty_mm: Some(u_mm),
        prior: Prior::TOLERANCES,
        effects: Effects::Usual,
        ..Settings::default()
    };
    let sets = Sets { calibration: observations.to_vec(), ..Sets::default() };
    let mut messages = stale(robot, observations);
    let solution = match Solution::new(robot, Basis { sets, settings, ..Basis::default() }) {
        Ok(solution) => solution,
        Err(Problems(problems)) => {
            messages.extend(problems);
            return Said { messages, chi_square: None, exceeds: true };
        }
    };
    let found = &solution.found;
    let within = |(p, value): (&etalon::robots::Parameter, &f64)| (value - p.nominal).abs() <= p.tolerance;
    let within = robot.parameters().iter().zip(&found.values).all(within);
    let chi_square =
        found.residuals.chi_square.filter(|_| within).map(|c| c / found.residuals.degrees_of_freedom as f64);
    let exceeds = found.residuals.chi_square.is_none_or(|c| chi_square_exceeds(c, found.residuals.degrees_of_freedom));
    messages.extend(messages_alone(robot, &solution));
    Said { messages, chi_square, exceeds }
}

fn text(messages: &[Message]) -> String {
    messages.iter().map(|m| format!("{m}\n")).collect()
}

/// An arm with one slip.
struct Outcome {
    name: String,
    /// A cause is named without the slip.
    named_without: bool,
    /// A robot within its tolerances explains the data with the slip as well as those without: they cannot show it.
    hidden: bool,
    refused: bool,
    warned: bool,
    named: bool,
    text: String,
}

fn outcome(seed: u64) -> Option<Outcome> {
    let case = drawn_arm(seed, POSES);
    if case.calibration.len() < FEWEST {
        return None;
    }
    let Drawn { what: drawn, robot, calibration, noise_mm, .. } = case;
    let bench = Bench { name: "drawn arm", robot, observations: calibration, u_mm: noise_mm };
    let robot = bench.robot.as_ref();
    let without = said(robot, &bench.observations, noise_mm);
    let mut slips: Vec<(String, Vec<Observation>, Vec<String>)> = Vec::new();
    for Slip { what, change, culprits } in slips_of_joints(&bench).into_iter().chain(slips_of_points(&bench)) {
        let mut observations = bench.observations.clone();
        observations.iter_mut().for_each(change);
        slips.push((what, observations, culprits));
    }
    slips.extend(spoilt(&bench));
    let which = (0.5 * (1.0 + Noise::new(41, seed).uniform(1.0)) * slips.len() as f64) as usize;
    let (what, observations, culprits) = slips.swap_remove(which.min(slips.len() - 1));
    let with = said(robot, &observations, noise_mm);
    let hidden = match (with.chi_square, without.chi_square) {
        (Some(with), Some(without)) => with < SHOWS * without.max(1.0),
        _ => false,
    };
    let text_with = text(&with.messages);
    let decide = |m: &Message| m.rank == Rank::Decide && !without.messages.contains(m);
    Some(Outcome {
        name: format!("{what} of {drawn}"),
        named_without: text(&without.messages).contains(NAMES_A_CAUSE),
        hidden,
        refused: with.messages.iter().any(|m| m.severity == Severity::Error),
        warned: with.exceeds && !without.exceeds || with.messages.iter().any(decide),
        named: culprits.iter().any(|culprit| text_with.contains(culprit)),
        text: text_with,
    })
}

#[test]
fn slips_of_drawn_arms_are_named_and_sound_arms_are_not() {
    let (first, count) = (number("ETALON_SLIPS_FIRST", 0), number("ETALON_SLIPS", 24));
    let all: Vec<Outcome> = (first..first + count).into_par_iter().filter_map(outcome).collect();
    let shown: Vec<&Outcome> = all.iter().filter(|o| !o.hidden).collect();
    let noticed = shown.iter().filter(|o| o.refused || o.warned).count();
    let named = shown.iter().filter(|o| o.named).count();
    for o in shown.iter().filter(|o| !o.named) {
        let noticed = if o.refused {
            "refused"
        } else if o.warned {
            "warned"
        } else {
            "IN SILENCE"
        };
        println!("{} [{noticed}]\n{}", o.name, o.text);
    }
    all.iter().filter(|o| o.named_without).for_each(|o| println!("a cause is named without a slip: {}", o.name));
    println!(
        "{} arms, {} hidden; of {} shown {noticed} are refused or warned of, {named} by name",
        all.len(),
        all.len() - shown.len(),
        shown.len()
    );
    assert!(!all.iter().any(|o| o.named_without));
    assert!(100 * noticed >= 95 * shown.len(), "{noticed} of {}", shown.len());
    assert!(100 * named >= 90 * shown.len(), "{named} of {}", shown.len());
}
