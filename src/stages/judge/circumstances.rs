//! Values that each reading gives: torques and temperatures that do not vary, implausible
//! temperatures, torques of other signs, swapped columns.

use crate::stages::evaluate::sets::Sets;
use etalon_base::message::Message;
use etalon_base::pose::{minus, norm};
use etalon_base::{phrase, warning};
use etalon_campaign::Campaign;
use etalon_documents::{PoseSet, ReadingQuantity, ReadingValues};
use etalon_formats::tables::joints::stated_columns;
use etalon_identify::{Effects, Identification, Observation, Settings, Status, chi_square_exceeds, identify_from};
use etalon_robots::{Circumstance, Effect, Parameter, Robot};

/// Maximum range of values that count as constant, relative to the values.
const CONSTANT: f64 = 1e-6;
/// Temperatures (°C) of robots in a workshop. Fahrenheit and kelvin of a workshop are above.
const WORKSHOP_C: [f64; 2] = [0.0, 55.0];
/// Maximum payload (kg) of an arm per cube of its reach (m³). The strongest arms of the catalogues
/// have 44 kg/m³ (six axes, 2300 kg at 3.7 m) and 190 kg/m³ (a SCARA, 1 kg at 0.175 m).
const MOST_KG_PER_M3: f64 = 1000.0;
/// Maximum relative difference of a load that counts as rounding.
const ROUNDED_LOAD: f64 = 0.01;
/// Standard uncertainties by which a compliance differs from zero.
const SIGNIFICANCE: f64 = 3.0;

/// Position of each value that a reading gives behind its joint values.
fn positions(robot: &dyn Robot) -> impl Iterator<Item = (usize, Circumstance)> + '_ {
    (robot.joints().len() + robot.approached().len()..).zip(robot.circumstances().iter().copied())
}

/// Holds the parameters that need a value of the readings to vary, and names those values.
pub(crate) fn hold_constant(robot: &dyn Robot, sets: &Sets, settings: &mut Settings) -> Vec<Message> {
    let readings = || {
        let of_conditions = sets.calibration_conditions.iter().map(|c| &c.joints);
        sets.calibration.iter().map(|o| &o.joints).chain(of_conditions)
    };
    let mut messages = Vec::new();
    for (at, stated) in positions(robot) {
        let values = readings().filter_map(|joints| joints.get(at).copied());
        let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
        if low > high {
            continue;
        }
        match stated {
            Circumstance::Temperature => messages.extend(implausible_temperature(low, high)),
            Circumstance::PayloadMass => messages.extend(implausible_mass(robot, sets, high)),
            Circumstance::PayloadCentre(_) | Circumstance::Torque(_) => {}
        }
        if high - low > CONSTANT * low.abs().max(high.abs()) {
            continue;
        }
        let mut hold = |needs: &dyn Fn(&Parameter) -> bool| {
            settings.hold.extend(robot.parameters().iter().filter(|p| needs(p)).map(|p| p.name.clone()));
        };
        match stated {
            Circumstance::Torque(joint) => {
                hold(&|p| p.depends_on(stated));
                let (joint, column) = (&robot.joints()[joint].name, robot.joints()[joint].torque_column());
                messages.push(warning!("torque-constant", joint, column, value = low).routine());
            }
            Circumstance::Temperature => {
                hold(&|p| p.depends_on(stated));
                messages.push(warning!("temperature-constant", value = low));
            }
            Circumstance::PayloadMass | Circumstance::PayloadCentre(_) => {}
        }
    }
    messages
}

/// Values of the readings of a set in addition to joint values and directions of approach.
pub(crate) fn reading_values(robot: &dyn Robot, sets: &Sets, set: PoseSet) -> Vec<ReadingValues> {
    let (observations, conditions) = sets.observations_and_conditions(set);
    let states = || observations.iter().map(|o| &o.joints).chain(conditions.iter().map(|c| &c.joints));
    let column = |((at, stated), column): ((usize, Circumstance), String)| {
        let values = states().filter_map(|state| state.get(at).copied()).filter(|value| value.is_finite());
        ReadingValues::new(column, stated.into(), values.collect())
    };
    positions(robot).zip(stated_columns(robot)).filter_map(column).collect()
}

/// Returns a warning if the campaign gives one load, and readings give another load.
pub(crate) fn contradicted_load(campaign: &Campaign, robot: &dyn Robot, sets: &Sets) -> Option<Message> {
    let stated_kg = campaign.file.conditions.motion.load_kg?;
    let of_set = |set| reading_values(robot, sets, set);
    let masses = PoseSet::ALL.into_iter().flat_map(of_set).filter(|v| v.quantity == ReadingQuantity::PayloadMass);
    let [lowest_kg, highest_kg] =
        masses.map(|v| [v.lowest, v.highest]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])?;
    let differs = |kg: f64| (kg - stated_kg).abs() > ROUNDED_LOAD * kg.max(stated_kg);
    let place = || campaign.key_place(&["conditions", "load_kg"]);
    let is_contradicted = differs(lowest_kg) || differs(highest_kg);
    is_contradicted.then(|| warning!("load-elsewhere", stated_kg, lowest_kg, highest_kg).at(place()))
}

/// Returns a warning if temperatures (°C) are unusual in a workshop.
fn implausible_temperature(low: f64, high: f64) -> Option<Message> {
    let [least, most] = WORKSHOP_C;
    (low < least || high > most).then(|| {
        let [from_fahrenheit, to_fahrenheit] = [low, high].map(|v| (v - 32.0) / 1.8);
        let [from_kelvin, to_kelvin] = [low, high].map(|v| v - 273.15);
        let hint = phrase!("temperature-units", from_fahrenheit, to_fahrenheit, from_kelvin, to_kelvin);
        warning!("temperature-questioned", low, high, least, most).hint(hint).to_decide()
    })
}

/// Returns a warning if a payload of `high_kg` is too heavy for an arm of the reach that the
/// readings show with nominal parameters: compliances by masses in grams are a thousand times too
/// small.
fn implausible_mass(robot: &dyn Robot, sets: &Sets, high_kg: f64) -> Option<Message> {
    let nominal = robot.nominal();
    let origin = robot.base_origin(&nominal);
    let of_observation = |o: &Observation| -> f64 {
        let measured = o.targets.iter().enumerate().filter(|(_, at)| at.is_some());
        let at = |k: usize| norm(minus(robot.position(&nominal, &o.joints, k), origin));
        measured.map(|(k, _)| at(k)).fold(0.0, f64::max)
    };
    let of_conditions = sets.calibration_conditions.iter();
    let of_conditions = of_conditions.map(|c| norm(minus(robot.position(&nominal, &c.joints, c.target), origin)));
    let reach_mm = sets.calibration.iter().map(of_observation).chain(of_conditions).fold(0.0, f64::max);
    let (reach_m, in_grams_kg) = (reach_mm / 1000.0, high_kg / 1000.0);
    let most_kg = MOST_KG_PER_M3 * reach_m.powi(3);
    (reach_m > 0.0 && high_kg > most_kg).then(|| warning!("load-questioned", high_kg, reach_m, in_grams_kg).to_decide())
}

/// Temperature (°C) of a reading, if the robot's readings state one.
pub(crate) fn temperature(robot: &dyn Robot, joints: &[f64]) -> Option<f64> {
    let (at, _) = positions(robot).find(|(_, stated)| *stated == Circumstance::Temperature)?;
    joints.get(at).copied()
}

/// Compliances of joints under their torques that the data determine.
fn by_torque<'a>(robot: &'a dyn Robot, found: &'a Identification) -> impl Iterator<Item = (&'a Parameter, f64)> + 'a {
    let own = found.free.iter().filter(|&&i| robot.parameters()[i].effect == Effect::Torque);
    let significant =
        own.filter(|&&i| found.values[i].abs() > SIGNIFICANCE * found.standard_uncertainty(i).unwrap_or(f64::INFINITY));
    significant.map(|&i| (&robot.parameters()[i], found.values[i]))
}

/// Returns a warning if some joints yield with their torques and others against them.
pub(crate) fn torque_signs(robot: &dyn Robot, found: &Identification) -> Option<Message> {
    let named = |sign: f64| -> Vec<String> {
        let of_sign = by_torque(robot, found).filter(|(_, value)| value * sign > 0.0);
        of_sign.map(|(p, _)| format!("`{}`", p.name)).collect()
    };
    let (positive, negative) = (named(1.0), named(-1.0));
    (!positive.is_empty() && !negative.is_empty())
        .then(|| warning!("torque-signs-differ", positive, negative).to_decide())
}

/// Returns a warning if the readings as given are not explained, and are explained with the
/// torques of two joints swapped.
pub(crate) fn exchanged_torques(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Option<Message> {
    let torques: Vec<(usize, usize)> = positions(robot)
        .filter_map(|(at, stated)| if let Circumstance::Torque(joint) = stated { Some((at, joint)) } else { None })
        .collect();
    let settings = with_torques(robot, settings, found);
    let explains = |observations: &[Observation]| -> bool {
        let again = identify_from(robot, observations, &settings, &found.values).ok();
        again.is_some_and(|f| {
            f.residuals.chi_square.is_some_and(|c| !chi_square_exceeds(c, f.residuals.degrees_of_freedom))
        })
    };
    if torques.len() < 2 || explains(observations) {
        return None;
    }
    let pairs = (0..torques.len()).flat_map(|i| (i + 1..torques.len()).map(move |k| (i, k)));
    let explained = pairs.map(|(i, k)| (torques[i], torques[k])).find(|((a, _), (b, _))| {
        let mut exchanged = observations.to_vec();
        exchanged.iter_mut().for_each(|o| o.joints.swap(*a, *b));
        explains(&exchanged)
    });
    let ((_, first), (_, second)) = explained?;
    let [first, second] = [first, second].map(|joint| robot.joints()[joint].torque_column());
    Some(warning!("torques-exchanged", first, second).to_decide())
}

/// Settings that also identify bending by torques.
fn with_torques(robot: &dyn Robot, settings: &Settings, found: &Identification) -> Settings {
    let held = robot.parameters().iter().zip(&found.status);
    let held = held.filter(|(p, status)| **status == Status::Fixed && p.effect != Effect::Torque);
    let hold = settings.hold.iter().cloned().chain(held.map(|(p, _)| p.name.clone())).collect();
    Settings { effects: Effects::All, hold, ..settings.clone() }
}
