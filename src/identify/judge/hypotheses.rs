//! Hypotheses about a set-up: every change of the table with base, targets and fixtures located,
//! alone and in pairs, and single nominal values.

use super::TOLERANCE;
use super::changes::{Change, Listing, Reading, changes, reversed_pairs};
use super::data::Data;
use super::fit::{self, Fitted, Hypothesis};
use super::place::{elsewhere, locate};
use crate::model::residuals::Residuals;
use crate::solution::placing::PLAIN;
use crate::warning::Origin;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose_name::PoseName;
use etalon_math::Options;
use etalon_robots::{Parameter, Robot, Role};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Number of nominal values that are fitted with all parameters.
const FITTED_VALUES: usize = 3;
/// Number of changes that are combined with all others.
const PAIRED: usize = 12;
/// Maximum number of poses of which a wrong one is a hypothesis: more of them show it themselves.
const FEW_POSES: usize = 16;

/// Data with base, targets and fixtures located.
pub(super) struct Case {
    pub data: Data,
    /// All parameters.
    values: Vec<f64>,
    /// Cost of the nominal robot for each residual.
    pub near: f64,
    /// Parameter without a nominal value.
    loose: Option<usize>,
}

impl Case {
    /// Locates base, targets and fixtures; `None` if the nominal robot has no pose at the joint
    /// values.
    pub fn located(robot: &dyn Robot, data: Data, anywhere: bool) -> Option<Self> {
        let (data, values) = locate(robot, data, anywhere)?;
        let near = fit::cost_for_each(robot, &data, &values);
        near.is_finite().then_some(Self { data, values, near, loose: None })
    }

    pub fn fit(&self, robot: &dyn Robot) -> Option<Fitted> {
        self.fit_within(robot, None)
    }

    /// The fit, which is given up beyond `limit`: see [`Hypothesis::limit`].
    pub fn fit_within(&self, robot: &dyn Robot, limit: Option<f64>) -> Option<Fitted> {
        Hypothesis { robot, data: &self.data, placed: &self.values, loose: self.loose, limit }.fit()
    }
}

/// A change of the set-up, with its data.
pub(super) struct Slip {
    pub what: Phrase,
    pub origin: Origin,
    /// Another robot: by another convention, or a published one.
    other: Option<Box<dyn Robot>>,
    pub listing: Listing,
    /// `true` for a reading that is left out.
    pub is_reading: bool,
    /// Joint values of other poses with the change.
    pub elsewhere: Vec<Vec<f64>>,
    pub case: Case,
}

impl Slip {
    /// A change that is not listed.
    fn new(what: Phrase, case: Case) -> Self {
        let (origin, listing) = (Origin::Named, Listing::Never);
        Self { what, origin, other: None, listing, is_reading: false, elsewhere: Vec::new(), case }
    }

    pub fn robot<'a>(&'a self, robot: &'a dyn Robot) -> &'a dyn Robot {
        self.other.as_deref().unwrap_or(robot)
    }

    /// `true` for another convention, or a published robot.
    pub fn is_other_robot(&self) -> bool {
        self.other.is_some()
    }

    /// `true` if no value of the change is fitted to the data.
    pub fn is_change(&self) -> bool {
        self.case.loose.is_none() && self.origin != Origin::WorldFrame
    }

    /// `true` for another way to make the same data of the same robot.
    pub fn is_same(&self, other: &Self) -> bool {
        let are_changes = [self, other].iter().all(|slip| slip.is_change() && !slip.is_other_robot());
        are_changes && self.case.data.is_same(&other.case.data)
    }

    /// The change with the fitted value.
    pub fn phrase(&self, robot: &dyn Robot, fitted: &Fitted) -> Phrase {
        let Some(i) = self.case.loose else { return self.what.clone() };
        let p = &robot.parameters()[i];
        let (found, nominal) = (p.quantity.outward(fitted.values[i]), p.quantity.outward(p.nominal));
        phrase!("slip-nominal", parameter = p.name, found, unit = p.quantity.unit(), nominal)
    }
}

/// Data and table of the changes of a set-up.
#[derive(Clone, Copy)]
pub(super) struct Table<'a> {
    pub robot: &'a dyn Robot,
    /// All data.
    pub data: &'a Data,
    /// Some of the data, on which changes are tried, and poses elsewhere.
    pub tried: [&'a Data; 2],
    /// Other ways of reading the orientations.
    pub readings: &'a [Reading],
}

impl Table<'_> {
    /// Every change alone, with base, targets and fixtures located.
    pub fn single(&self) -> Vec<Slip> {
        let Self { robot, data, tried: [subset, probes], .. } = *self;
        let mut all: Vec<Slip> =
            self.changes().into_par_iter().filter_map(|(change, probes)| self.placed(change, probes)).collect();
        for (shift, neighbour) in [(-1, "previous"), (1, "next")] {
            let case = Case::located(robot, data.shifted(shift).subset(robot), false);
            all.extend(case.map(|case| Slip::new(phrase!("slip-neighbour", neighbour), case)));
        }
        for (what, mut other) in robot.alternatives() {
            if !add_fixtures(robot, other.as_mut()) {
                continue;
            }
            let case = Case::located(other.as_ref(), subset.clone(), false);
            let (listing, elsewhere) = (Listing::First, probes.joints());
            all.extend(case.map(|case| Slip { other: Some(other), listing, elsewhere, ..Slip::new(what, case) }));
        }
        if robot.free_base().is_none()
            && let Some((angle, [x_mm, y_mm])) = elsewhere(robot, &subset.observations)
        {
            let what = phrase!("slip-world-frame", angle_deg = angle.to_degrees(), x_mm, y_mm);
            let case = Case::located(robot, subset.clone(), true);
            all.extend(case.map(|case| Slip { origin: Origin::WorldFrame, ..Slip::new(what, case) }));
        }
        all
    }

    /// Every reading left out, if poses are few.
    pub fn without_readings(&self) -> Vec<Slip> {
        let Self { robot, data, .. } = *self;
        let few = if data.poses().len() > FEW_POSES { BTreeSet::new() } else { data.places_of_readings() };
        let without = |(pose, target): (PoseName, usize)| {
            let case = Case::located(robot, data.without(pose, target), false)?;
            let what = phrase!("slip-reading", target = robot.targets()[target], pose);
            Some(Slip { is_reading: true, ..Slip::new(what, case) })
        };
        few.into_par_iter().filter_map(without).collect()
    }

    /// Pairs of changes: each change that alone brings the nominal robot nearest, with all others,
    /// and all pairs of reversed joints.
    pub fn pairs(&self) -> Vec<Slip> {
        let near = |(change, probes): (Change, Data)| {
            let case = Case::located(self.robot, change.data.clone(), change.anywhere)?;
            Some((case.near, change, probes))
        };
        let mut first: Vec<(f64, Change, Data)> = self.changes().into_par_iter().filter_map(near).collect();
        first.sort_by(|a, b| a.0.total_cmp(&b.0));
        first.truncate(PAIRED);
        let with = |(_, first, probes): &(f64, Change, Data)| -> Vec<Slip> {
            let changed = Table { tried: [&first.data, probes], ..*self };
            let pair = |(second, probes): (Change, Data)| {
                let what = phrase!("slip-pair", first = first.what.clone(), second = second.what);
                let anywhere = first.anywhere || second.anywhere;
                self.placed(Change { what, anywhere, origin: Origin::Named, listing: Listing::Never, ..second }, probes)
            };
            changed.changes().into_iter().filter_map(pair).collect()
        };
        let reversed =
            self.tried_with(reversed_pairs).into_par_iter().filter_map(|(pair, probes)| self.placed(pair, probes));
        first.par_iter().flat_map(with).chain(reversed).collect()
    }

    /// A change with base, targets and fixtures located, and poses elsewhere with it.
    fn placed(&self, change: Change, probes: Data) -> Option<Slip> {
        let Change { what, origin, data, anywhere, listing } = change;
        let case = Case::located(self.robot, data, anywhere)?;
        Some(Slip { origin, listing, elsewhere: probes.joints(), ..Slip::new(what, case) })
    }

    /// Changes of the data, and the poses elsewhere with each.
    fn changes(&self) -> Vec<(Change, Data)> {
        self.tried_with(|robot, data| changes(robot, data, self.readings))
    }

    fn tried_with(&self, how: impl Fn(&dyn Robot, &Data) -> Vec<Change>) -> Vec<(Change, Data)> {
        let [subset, probes] = self.tried.map(|data| how(self.robot, data));
        subset.into_iter().zip(probes.into_iter().map(|probe| probe.data)).collect()
    }
}

/// Mistakes in one nominal value: each length and angle of the robot that the measurements put
/// beyond its tolerance if it is free, and no other value, with its fit.
pub(super) fn wrong_nominal(robot: &dyn Robot, stated: &Case) -> Vec<(Slip, Fitted)> {
    let (parameters, placed, data) = (robot.parameters(), &stated.values, &stated.data);
    if data.observations.is_empty() {
        return Vec::new();
    }
    let places =
        || (0..placed.len()).filter(|&i| parameters[i].role == Role::Base || parameters[i].tolerance.is_infinite());
    let with = |i: usize| {
        let mut free: Vec<usize> = places().chain([i]).collect();
        free.sort_unstable();
        let problem = Residuals::new(robot, &data.observations, &PLAIN, &free, placed).ok()?;
        let x: Vec<f64> = free.iter().map(|&i| placed[i]).collect();
        let solution = etalon_math::solve(&problem, &x, Options { iterations: 30, step: 1e-6, ..Options::default() });
        Some((solution.cost, i, problem.all(&solution.x)))
    };
    let is_nominal = |&i: &usize| {
        let p = &parameters[i];
        p.role == Role::Robot && p.tolerance.is_finite()
    };
    let nominal: Vec<usize> = (0..placed.len()).filter(is_nominal).collect();
    let mut all: Vec<(f64, usize, Vec<f64>)> = nominal.into_par_iter().filter_map(with).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.truncate(FITTED_VALUES);
    let judged = |(_, i, values): (f64, usize, Vec<f64>)| {
        let case = Case { data: data.clone(), values, near: stated.near, loose: Some(i) };
        let fitted = case.fit(robot)?;
        let p = &parameters[i];
        // if further values are beyond their tolerances too, one value is no cause
        let is_alone = (fitted.values[i] - p.nominal).abs() > p.tolerance && fitted.off < TOLERANCE;
        is_alone.then(|| (Slip::new(Phrase::new("slip-nominal"), case), fitted))
    };
    all.into_iter().filter_map(judged).collect()
}

/// Adds the parameters of fixtures to another robot; `false` if the two robots have different
/// parameters of their own.
fn add_fixtures(robot: &dyn Robot, other: &mut dyn Robot) -> bool {
    let (all, count) = (robot.parameters(), other.parameters().len());
    let alike = other.parameters().iter().zip(all).all(|(a, b)| a.role == b.role);
    let is_fixture = |p: &Parameter| p.role == Role::Fixture || p.role == Role::Target;
    let possible = alike && count <= all.len() && all[count.min(all.len())..].iter().all(is_fixture);
    if possible {
        other.definition_mut().parameters.extend(all[count..].iter().cloned());
    }
    possible
}
