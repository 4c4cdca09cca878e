//! Targets and fixtures (sockets, anchors, surfaces, stations) of validation poses alone. Their own
//! readings locate them, with the identified robot held; the remaining redundancy counts in the
//! statistics.

use crate::stages::evaluate::errors::point_errors;
use crate::stages::evaluate::sets::Sets;
use crate::stages::remedies::remedied;
use crate::stages::truncated;
use etalon_base::catalogue::Argument;
use etalon_base::message::{Message, Result};
use etalon_base::pattern::matches_pattern;
use etalon_base::{error, phrase, warning};
use etalon_documents::{self as documents, ParameterStatus, ParametersDocument, PointError};
use etalon_identify::{
    Condition, Identification, Kind, Known, Observation, Placement, RigidPart, Settings, locate_points,
};
use etalon_robots::{FreeBase, Quantity, Robot, Role};
use std::collections::{BTreeMap, BTreeSet};

/// Maximum number of names in a message.
const NAMED: usize = 5;

/// Readings of targets and fixtures without calibration readings.
#[derive(Clone, Debug, Default)]
pub struct ValidationTargets {
    /// Parameters of each target and fixture.
    groups: Vec<Vec<usize>>,
    observations: Vec<Observation>,
    /// Weights of readings, further observations, and distances between fixtures.
    settings: Settings,
}

/// Locations of the targets and fixtures, with the identified parameters.
#[derive(Clone, Debug, Default)]
pub struct TargetLocations {
    groups: Vec<Vec<usize>>,
    /// Redundancy numbers of the readings of each group.
    redundancies: Vec<Vec<f64>>,
    /// Redundancies of all readings with a position error, in the order of the errors.
    of_errors: Vec<f64>,
    uncertainties: BTreeMap<usize, f64>,
}

impl ValidationTargets {
    /// Moves readings of targets and fixtures without calibration readings out of `sets`;
    /// `settings` hold the parameters of these targets and fixtures.
    pub(crate) fn take(robot: &dyn Robot, sets: &mut Sets, settings: &mut Settings) -> Self {
        let Some(arm) = robot.free_base() else { return Self::default() };
        let groups = unplaced(robot, arm, sets, settings);
        let places: BTreeSet<usize> = groups.iter().flatten().copied().collect();
        if places.is_empty() {
            return Self::default();
        }
        let is_separate = |k: usize| places.contains(&arm.target_place(k));
        let mut observations = Vec::new();
        for o in &mut sets.validation {
            let mut own = o.clone();
            for (k, at) in o.targets.iter_mut().enumerate() {
                *if is_separate(k) { at } else { &mut own.targets[k] } = None;
            }
            observations.extend(own.targets.iter().any(Option::is_some).then_some(own));
        }
        sets.validation.retain(|o| o.targets.iter().any(Option::is_some));
        let is_separate_condition = |c: &mut Condition| c.shows(arm).iter().flatten().any(|i| places.contains(i));
        let conditions = sets.validation_conditions.extract_if(.., is_separate_condition).collect();
        let known: Vec<Known> = settings.known.extract_if(.., |known| known.refers_to(&places)).collect();
        let target = |name: &String| robot.targets().iter().position(|t| t == name);
        let of_part = |part: &mut RigidPart| part.targets.iter().filter_map(target).any(is_separate);
        let rigid = settings.rigid.extract_if(.., of_part).collect();
        settings.hold.extend(places.iter().map(|&i| robot.parameters()[i].name.clone()));
        let own = Settings {
            standard_uncertainty_mm: settings.standard_uncertainty_mm,
            conditions,
            known,
            rigid,
            ..Settings::default()
        };
        Self { groups, observations, settings: own }
    }

    /// Returns the sets with these readings for validation.
    pub fn with_readings(&self, sets: &Sets) -> Sets {
        let mut all = sets.clone();
        all.validation.extend(self.observations.iter().cloned());
        all.validation_conditions.extend(self.settings.conditions.iter().cloned());
        all
    }

    /// Locates everything in both sets of parameters: `before` and `after` an identification.
    ///
    /// # Errors
    /// Fails if the readings do not locate a target.
    pub fn locate(&self, robot: &dyn Robot, before: &mut [f64], after: &mut [f64]) -> Result<TargetLocations> {
        let Some(arm) = robot.free_base().filter(|_| !self.groups.is_empty()) else {
            return Ok(TargetLocations::default());
        };
        let places = self.groups.concat();
        let place = |values: &mut [f64]| -> Result<Placement> {
            let placed = locate_points(robot, &self.observations, &self.settings, values, &places).map_err(remedied)?;
            values.copy_from_slice(&placed.values);
            Ok(placed)
        };
        place(before)?;
        let placed = place(after)?;
        let mut redundancies = vec![Vec::new(); self.groups.len()];
        let group = |shown: &[usize]| self.groups.iter().position(|g| shown.iter().any(|i| g.contains(i)));
        let mut of_errors = Vec::new();
        for (o, of_targets) in self.observations.iter().zip(&placed.observations) {
            for (shown, r) in o.shows(arm).iter().zip(of_targets.iter().flatten()) {
                extend_at(&mut redundancies, group(shown), *r);
                of_errors.push(*r);
            }
        }
        for (c, r) in self.settings.conditions.iter().zip(&placed.conditions) {
            c.shows(arm).iter().for_each(|shown| extend_at(&mut redundancies, group(shown), *r));
            if !c.kind.is_orientation() && !matches!(c.kind, Kind::Joint(_)) {
                of_errors.push(*r);
            }
        }
        Ok(TargetLocations {
            groups: self.groups.clone(),
            redundancies,
            of_errors,
            uncertainties: placed.uncertainties,
        })
    }

    /// Errors of these readings before and after.
    pub fn errors(
        &self,
        robot: &dyn Robot,
        before: &[f64],
        after: &[f64],
        locations: &TargetLocations,
    ) -> Vec<PointError> {
        let own = self.with_readings(&Sets::default());
        let mut errors = point_errors(robot, &own, before, after);
        errors.iter_mut().zip(&locations.of_errors).for_each(|(error, r)| error.control.own_redundancy = Some(*r));
        errors
    }
}

/// Adds a number to the list at an index, if there is one.
fn extend_at(lists: &mut [Vec<f64>], place: Option<usize>, number: f64) {
    if let Some(list) = place.and_then(|k| lists.get_mut(k)) {
        list.push(number);
    }
}

/// Returns the parameters of each target and fixture with validation readings only: no calibration
/// reading, no given position, no tolerance, and no rigid part with a located target.
fn unplaced(robot: &dyn Robot, arm: &dyn FreeBase, sets: &Sets, settings: &Settings) -> Vec<Vec<usize>> {
    let of = |observations: &[Observation], conditions: &[Condition]| -> Vec<Vec<usize>> {
        let conditions = conditions.iter().flat_map(|c| c.shows(arm));
        observations.iter().flat_map(|o| o.shows(arm)).chain(conditions).collect()
    };
    let mut placed: BTreeSet<usize> =
        of(&sets.calibration, &sets.calibration_conditions).into_iter().flatten().collect();
    placed.extend(settings.known.iter().flat_map(Known::places));
    for part in &settings.rigid {
        let targets = part.targets.iter().filter_map(|name| robot.targets().iter().position(|t| t == name));
        let places: Vec<usize> = targets.flat_map(|k| (0..3).map(move |axis| arm.target_place(k) + axis)).collect();
        if places.iter().any(|i| placed.contains(i)) {
            placed.extend(places);
        }
    }
    let is_known = |i: &usize| {
        let p = &robot.parameters()[*i];
        placed.contains(i)
            || p.tolerance.is_finite()
            || settings.hold.iter().any(|pattern| matches_pattern(pattern, &p.name))
    };
    let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for group in of(&sets.validation, &sets.validation_conditions) {
        if !group.iter().any(is_known) {
            groups.entry(group[0]).or_insert(group);
        }
    }
    groups.into_values().collect()
}

impl TargetLocations {
    /// `true` if an error of any of these readings is counted.
    fn is_assessed(redundancies: &[f64]) -> bool {
        redundancies.iter().any(|&r| documents::counted_share(r).is_some())
    }

    /// Returns a warning that names them.
    ///
    /// # Errors
    /// Fails if no reading of the validation poses can be judged.
    pub fn message(&self, robot: &dyn Robot, sets: &Sets) -> Result<Option<Message>> {
        if self.groups.is_empty() {
            return Ok(None);
        }
        let all = self.groups.iter().zip(&self.redundancies);
        let uncontrolled: Vec<&Vec<usize>> = all.filter(|(_, r)| !Self::is_assessed(r)).map(|(g, _)| g).collect();
        let (kind, count) = kind_and_count(robot, &self.groups);
        let unplaced = phrase!("unplaced", kind, count, names = names(robot, self.groups.iter()));
        let nothing = uncontrolled.len() == self.groups.len();
        if nothing && sets.validation.is_empty() && sets.validation_conditions.is_empty() {
            return Err(error!("validation-leaves-nothing", unplaced).into());
        }
        let message = match uncontrolled[..] {
            [] => warning!("placed-by-validation", unplaced),
            _ => {
                let names = names(robot, uncontrolled.iter().copied());
                warning!("placed-by-validation-unjudged", unplaced, names).to_decide()
            }
        };
        Ok(Some(message))
    }

    /// Entries of `accuracy.json`.
    pub fn documents(&self, robot: &dyn Robot) -> Vec<documents::SelfLocated> {
        let of = |(group, r): (&Vec<usize>, &Vec<f64>)| documents::SelfLocated {
            name: name(robot, group),
            readings: r.len(),
            redundancy: r.iter().sum::<f64>() / r.len().max(1) as f64,
            is_assessed: Self::is_assessed(r),
        };
        self.groups.iter().zip(&self.redundancies).map(of).collect()
    }

    /// Marks the located parameters in the document, with the uncertainty of their readings and the
    /// residuals `found`.
    pub fn mark(&self, robot: &dyn Robot, found: &Identification, document: &mut ParametersDocument) {
        let stated = document.residuals.test.stated_standard_uncertainty_mm.unwrap_or(0.0);
        let readings = found.residuals.count as f64;
        let shown = found.residuals.rms * (readings / found.residuals.degrees_of_freedom.max(1) as f64).sqrt();
        let unit = if stated > 0.0 { stated } else { 1.0 };
        for &i in self.groups.iter().flatten() {
            let p = &robot.parameters()[i];
            let Some(entry) = document.parameters.iter_mut().find(|entry| entry.name == p.name) else { continue };
            entry.status = ParameterStatus::NotIdentifiable;
            if let Some(u) = self.uncertainties.get(&i) {
                entry.status = ParameterStatus::PlacedByValidation;
                entry.standard_uncertainty = Some(p.quantity.outward(u * stated.max(shown) / unit));
            }
        }
    }
}

/// Kind of the groups (`targets`, `fixtures` or `both`), and their number.
fn kind_and_count(robot: &dyn Robot, groups: &[Vec<usize>]) -> (&'static str, usize) {
    let all = |role: Role| groups.iter().all(|g| robot.parameters()[g[0]].role == role);
    let kind = match () {
        () if all(Role::Target) => "targets",
        () if all(Role::Fixture) => "fixtures",
        () => "both",
    };
    (kind, groups.len())
}

/// Names of the first groups.
fn names<'g>(robot: &dyn Robot, groups: impl Iterator<Item = &'g Vec<usize>>) -> Vec<Argument> {
    truncated(groups.map(|g| format!("`{}`", name(robot, g))), NAMED)
}

/// Common prefix of all parameters of a target or fixture.
fn name(robot: &dyn Robot, group: &[usize]) -> String {
    let names: Vec<&str> = group.iter().map(|&i| robot.parameters()[i].name.as_str()).collect();
    let mut common = names[0];
    while !names.iter().all(|name| name.starts_with(common)) {
        let last = common.chars().next_back().map_or(1, char::len_utf8);
        common = &common[..common.len() - last];
    }
    let turns = group.iter().all(|&i| robot.parameters()[i].quantity == Quantity::Angle);
    let common = if turns { common.strip_suffix("_r").unwrap_or(common) } else { common };
    common.trim_end_matches('_').to_owned()
}
