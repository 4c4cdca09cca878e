//! Readings and rows that are left out, each with its reason, which the report repeats.

use crate::stages::kinds::Observed;
use etalon_base::message::{Message, Place, Problems, Result, count};
use etalon_base::pose_name::PoseName;
use etalon_campaign::{Campaign, Exclude, Identify, Selection, StatedPoses};
use etalon_identify::{Condition, Observation, Settings};
use etalon_robots::Robot;
use std::collections::BTreeSet;
use toml::Spanned;

/// A rule of exclusion, and where it is stated.
#[derive(Clone, Debug)]
pub struct Exclusion {
    /// The rule.
    pub rule: Exclude,
    /// Where it is stated.
    pub place: Place,
}

impl Exclusion {
    /// The rules of a campaign.
    pub fn of_campaign(campaign: &Campaign, stated: &Identify) -> Vec<Self> {
        let rule = |rule: &Spanned<Exclude>| Self { rule: rule.get_ref().clone(), place: campaign.place(rule) };
        stated.exclude.iter().map(rule).collect()
    }

    /// Returns a predicate that is `true` of the readings that the rule names, by pose, cycle and target; `None` of a rule that
    /// names no poses.
    pub fn covering(&self) -> Option<impl Fn(PoseName, i64, &str) -> bool + '_> {
        let Exclude { poses, cycle: only, target: of, .. } = &self.rule;
        let Ok(Selection::Named(named)) = Selection::parse(poses.as_ref()?) else { return None };
        Some(move |pose: PoseName, cycle: i64, target: &str| {
            named.iter().any(|named| named.contains(pose))
                && only.is_none_or(|only| only == cycle)
                && of.as_ref().is_none_or(|of| of == target)
        })
    }

    /// The rule that an option `POSES: REASON` states.
    ///
    /// # Errors
    /// An option without a reason.
    pub fn of_option(option: &str, text: &str) -> Result<(StatedPoses, String)> {
        let (named, reason) = text.split_once(':').unwrap_or((text, ""));
        if reason.trim().is_empty() {
            let message = Message::error(format!("{option} {text:?} states no reason"));
            return Err(message.expected("what is left out, and why: \"13, 20-22: ball loose\"").into());
        }
        Ok((StatedPoses::Text(named.trim().to_owned()), reason.trim().to_owned()))
    }
}

/// Leaves out the readings of the poses that are excluded, and names them with their reasons. What a rule names must have been measured,
/// whatever other rules exclude.
pub fn exclude(rules: &[Exclusion], robot: &dyn Robot, observed: &mut Observed) -> Result<Vec<Message>> {
    let Observed { observations, settings: Settings { conditions, .. } } = observed;
    let (mut messages, mut problems) = (Vec::new(), Problems::default());
    let measured = readings(observations, conditions);
    let mut excluded: BTreeSet<usize> = BTreeSet::new();
    for Exclusion { rule, place } in rules {
        let Some(poses) = &rule.poses else { continue };
        match readings_of(rule, poses, robot, &measured) {
            Ok(readings) => {
                let Exclude { cycle, target, reason, .. } = rule;
                let of = target.as_ref().map_or(String::new(), |target| format!(" of `{target}`"));
                let cycle = cycle.map_or(String::new(), |cycle| format!(", cycle {cycle}"));
                let poses = poses.to_string();
                let of_poses = if poses.trim().parse::<i64>().is_ok() { "pose" } else { "poses" };
                let readings_left_out = count(readings.len(), "reading");
                let what = format!("excluded: {readings_left_out}{of}, {of_poses} {poses}{cycle}: {reason}");
                messages.push(Message::warning(what).routine());
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
        problems.0.push(Message::error("the exclusions leave no reading").at(first.place.clone()));
    }
    problems.check()?;
    Ok(messages)
}

/// Where a reading is: a target of an observation, or a condition.
#[derive(Clone, Copy, PartialEq)]
enum Source {
    Target(usize, usize),
    Condition(usize),
}

/// What rules name of a reading.
struct Reading {
    pose: PoseName,
    cycle: i64,
    target: usize,
    source: Source,
}

/// Everything that was measured.
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

/// The readings that a rule excludes, by their indices.
fn readings_of(
    rule: &Exclude,
    poses: &StatedPoses,
    robot: &dyn Robot,
    measured: &[Reading],
) -> std::result::Result<BTreeSet<usize>, Message> {
    let Exclude { cycle, target, reason, .. } = rule;
    let Ok(Selection::Named(named)) = Selection::parse(poses) else {
        let message = Message::error(format!("`{poses}` names no poses to exclude"));
        return Err(message.expected("names and ranges like \"13, 20-22, home\""));
    };
    if let Some(target) = target.as_ref().filter(|target| !robot.targets().contains(target)) {
        let message = Message::error(format!("`{target}` is not a target of this robot"));
        return Err(message.hint_names(target, robot.targets().iter().map(String::as_str)));
    }
    if reason.trim().is_empty() {
        return Err(Message::error("an exclusion needs its reason"));
    }
    let mut all = BTreeSet::new();
    for poses in named {
        let here = |r: &Reading| {
            let target = target.as_ref().is_none_or(|target| *target == robot.targets()[r.target]);
            poses.contains(r.pose) && cycle.is_none_or(|cycle| cycle == r.cycle) && target
        };
        let mut excluded = (0..measured.len()).filter(|&i| here(&measured[i])).peekable();
        if excluded.peek().is_none() {
            let what = format!(
                "this exclusion leaves no reading out at pose {}: there is none of this pose, cycle and target",
                poses.name
            );
            return Err(Message::error(what));
        }
        all.extend(excluded);
    }
    Ok(all)
}

/// The data rows, from 1, that a rule leaves out.
///
/// # Errors
/// A rule without a reason or without numbers, or one that names no row.
pub fn excluded_rows(
    stated: &StatedPoses,
    reason: &str,
    rows: impl Iterator<Item = i64> + Clone,
) -> std::result::Result<BTreeSet<i64>, Message> {
    let Ok(Selection::Named(named)) = Selection::parse(stated) else {
        let message = Message::error(format!("`{stated}` names no rows to exclude"));
        return Err(message.expected("numbers and ranges like \"13, 20-22\", counted from the first row of data"));
    };
    if reason.trim().is_empty() {
        return Err(Message::error("an exclusion needs its reason"));
    }
    let mut excluded = BTreeSet::new();
    for range in named {
        let before = excluded.len();
        excluded.extend(rows.clone().filter(|row| range.contains((*row).into())));
        if excluded.len() == before {
            return Err(Message::error(format!("there is no row {} to exclude", range.name)));
        }
    }
    Ok(excluded)
}
