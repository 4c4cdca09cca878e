//! Excluded readings and rows, each with its reason, which the report repeats.

use crate::stages::kinds::Observed;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, Exclude, Identify, Selection, StatedPoses};
use etalon_identify::{Condition, Observation, Settings};
use etalon_robots::Robot;
use std::collections::BTreeSet;
use toml::Spanned;

/// A rule of exclusion, and the place where it is given.
#[derive(Clone, Debug)]
pub struct Exclusion {
    /// The rule.
    pub rule: Exclude,
    /// Place of the statement.
    pub place: Place,
}

impl Exclusion {
    /// The rules of a campaign.
    pub fn from_campaign(campaign: &Campaign, stated: &Identify) -> Vec<Self> {
        let rule = |rule: &Spanned<Exclude>| Self { rule: rule.get_ref().clone(), place: campaign.place(rule) };
        stated.exclude.iter().map(rule).collect()
    }

    /// Returns a predicate that is `true` for the readings that the rule selects, by pose, cycle
    /// and target; `None` for a rule without poses.
    pub fn covering(&self) -> Option<impl Fn(PoseName, i64, &str) -> bool + '_> {
        let Exclude { poses, cycle: only, target: of, .. } = &self.rule;
        let Ok(Selection::Named(named)) = Selection::parse(poses.as_ref()?) else { return None };
        Some(move |pose: PoseName, cycle: i64, target: &str| {
            named.iter().any(|named| named.contains(pose))
                && only.is_none_or(|only| only == cycle)
                && of.as_ref().is_none_or(|of| of == target)
        })
    }

    /// The rule given by an option `POSES: REASON`.
    ///
    /// # Errors
    /// Fails if an option gives no reason.
    pub fn parse_option(option: &str, text: &str) -> Result<(StatedPoses, String)> {
        let (named, reason) = text.split_once(':').unwrap_or((text, ""));
        if reason.trim().is_empty() {
            return Err(error!("exclusion-option-without-reason", option, text).into());
        }
        Ok((StatedPoses::Text(named.trim().to_owned()), reason.trim().to_owned()))
    }
}

/// Excludes the readings of the excluded poses, and names them with their reasons. The readings of
/// each rule must exist, regardless of other rules.
pub fn exclude(rules: &[Exclusion], robot: &dyn Robot, observed: &mut Observed) -> Result<Vec<Message>> {
    let Observed { observations, settings: Settings { conditions, .. } } = observed;
    let (mut messages, mut problems) = (Vec::new(), Problems::default());
    let measured = readings(observations, conditions);
    let mut excluded: BTreeSet<usize> = BTreeSet::new();
    for Exclusion { rule, place } in rules {
        let Some(poses) = &rule.poses else { continue };
        match excluded_readings(rule, poses, robot, &measured) {
            Ok(readings) => {
                let Exclude { cycle, target, reason, .. } = rule;
                let poses = poses.to_string();
                let several = if poses.trim().parse::<i64>().is_ok() { 1 } else { 2 };
                let mut of = vec![phrase!("exclusion-poses", count = several, poses)];
                of.extend(cycle.map(|cycle| phrase!("exclusion-cycle", cycle)));
                of.extend(target.as_ref().map(|target| phrase!("exclusion-target", target)));
                messages.push(warning!("excluded-readings", count = readings.len(), of, reason).routine());
                excluded.extend(readings);
            }
            Err(message) => problems.0.push(message.at(place.clone())),
        }
    }
    let out: Vec<Source> = excluded.iter().map(|&i| measured[i].source).collect();
    for source in &out {
        if let Source::Target(observation, target) = *source {
            observations[observation].targets[target] = None;
        }
    }
    observations.retain(|o| o.targets.iter().any(Option::is_some));
    let mut condition = 0..;
    conditions.retain(|_| condition.next().is_some_and(|i| !out.contains(&Source::Condition(i))));
    if let (true, Some(first)) = (observations.is_empty() && conditions.is_empty(), rules.first()) {
        problems.0.push(error!("exclusions-leave-nothing").at(first.place.clone()));
    }
    problems.check()?;
    Ok(messages)
}

/// Index of a reading: a target of an observation, or a condition.
#[derive(Clone, Copy, PartialEq)]
enum Source {
    Target(usize, usize),
    Condition(usize),
}

/// Reading in the terms of rules.
struct Reading {
    pose: PoseName,
    cycle: i64,
    target: usize,
    source: Source,
}

/// All readings.
fn readings(observations: &[Observation], conditions: &[Condition]) -> Vec<Reading> {
    let of_target = |(i, o): (usize, &Observation)| {
        let (pose, cycle) = (o.pose, o.cycle);
        let measured = o.targets.iter().enumerate().filter(|(_, measured)| measured.is_some());
        let reading = |(target, _)| Reading { pose, cycle, target, source: Source::Target(i, target) };
        measured.map(reading).collect::<Vec<_>>()
    };
    let of_condition = |(i, c): (usize, &Condition)| Reading {
        pose: c.pose,
        cycle: c.cycle,
        target: c.target,
        source: Source::Condition(i),
    };
    let targets = observations.iter().enumerate().flat_map(of_target);
    targets.chain(conditions.iter().enumerate().map(of_condition)).collect()
}

/// Indices of the readings that a rule excludes.
fn excluded_readings(
    rule: &Exclude,
    poses: &StatedPoses,
    robot: &dyn Robot,
    measured: &[Reading],
) -> std::result::Result<BTreeSet<usize>, Message> {
    let Exclude { cycle, target, reason, .. } = rule;
    let Ok(Selection::Named(named)) = Selection::parse(poses) else {
        return Err(error!("exclusion-names-nothing", stated = poses.to_string(), of = "poses"));
    };
    if let Some(target) = target.as_ref().filter(|target| !robot.targets().contains(target)) {
        let message = error!("not-of-this-robot", name = target, kind = "target");
        return Err(message.hint_names(target, robot.targets().iter().map(String::as_str)));
    }
    if reason.trim().is_empty() {
        return Err(error!("exclusion-without-reason"));
    }
    let mut all = BTreeSet::new();
    for poses in named {
        let here = |r: &Reading| {
            let target = target.as_ref().is_none_or(|target| *target == robot.targets()[r.target]);
            poses.contains(r.pose) && cycle.is_none_or(|cycle| cycle == r.cycle) && target
        };
        let mut excluded = (0..measured.len()).filter(|&i| here(&measured[i])).peekable();
        if excluded.peek().is_none() {
            return Err(error!("exclusion-matches-nothing", of = "poses", name = poses.name));
        }
        all.extend(excluded);
    }
    Ok(all)
}

/// The data rows, from 1, that a rule excludes.
///
/// # Errors
/// Fails if a rule has no reason or no numbers, or names no row.
pub fn excluded_rows(
    stated: &StatedPoses,
    reason: &str,
    rows: impl Iterator<Item = i64> + Clone,
) -> std::result::Result<BTreeSet<i64>, Message> {
    let Ok(Selection::Named(named)) = Selection::parse(stated) else {
        return Err(error!("exclusion-names-nothing", stated = stated.to_string(), of = "rows"));
    };
    if reason.trim().is_empty() {
        return Err(error!("exclusion-without-reason"));
    }
    let mut excluded = BTreeSet::new();
    for range in named {
        let before = excluded.len();
        excluded.extend(rows.clone().filter(|row| range.contains((*row).into())));
        if excluded.len() == before {
            return Err(error!("exclusion-matches-nothing", of = "rows", name = range.name));
        }
    }
    Ok(excluded)
}
