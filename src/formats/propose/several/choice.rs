//! Choice of the join of an export with a log.

use super::keys::{Join, Keys};
use super::part::Part;
use super::tested::tested;
use crate::propose::kinematics::Outcome;
use crate::propose::labels::NUMBER;
use etalon_robots::Robot;
use std::collections::BTreeMap;

/// Returns the join by which the most rows of an export have a row of the log. Where a robot is
/// given, the join must not contradict its kinematics.
pub(in crate::propose) fn best_join(robot: Option<&dyn Robot>, export: &Part, keys: &Keys, log: &Part) -> Option<Join> {
    let of_log = Keys::new(log);
    let both = |a: &Option<Vec<String>>, b: &Option<Vec<String>>| {
        a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(a, b)| format!("{a}\u{1}{b}")).collect()).next()
    };
    let by_key = |by: &'static str, mine: &Option<Vec<String>>, of_log: &Option<Vec<String>>| {
        let (mine, of_log) = (mine.as_ref()?, of_log.as_ref()?);
        let mut at: BTreeMap<&str, usize> = BTreeMap::new();
        for (i, key) in of_log.iter().enumerate() {
            if at.insert(key, i).is_some() {
                return None; // a key of the log names one row
            }
        }
        // a stationary point has no key
        let moves = |key: &&String| !key.trim_start_matches('\u{1}').is_empty();
        let pairs: Vec<(usize, usize)> =
            mine.iter().enumerate().filter_map(|(i, key)| Some((i, *at.get(key.as_str())?))).collect();
        let keys = mine.iter().filter(moves).count();
        Some(Join { by, keys, matching: pairs.len(), pairs, form: None, names_poses: false })
    };
    // labels of the log that name poses
    let by_name = |mine: &Option<Vec<String>>, form: Option<String>| {
        Some(Join { form, names_poses: true, ..by_key("pose", mine, &of_log.labels)? })
    };
    let rest = keys.labels.as_deref().and_then(behind_common_beginning);
    let (form, rest) = rest.map(|(form, rest)| (Some(form), Some(rest))).unwrap_or_default();
    let of_form = |(form, targets): &(String, Vec<String>)| form.contains("{pose}") && targets.len() > 1;
    let several_targets = keys.form.as_ref().is_some_and(of_form);
    let named = keys.poses.clone().filter(|_| !keys.by_row);
    let row = (keys.rows == of_log.rows && keys.still.is_empty()).then(|| Join {
        by: "row",
        keys: keys.rows,
        matching: keys.rows,
        pairs: (0..keys.rows).map(|i| (i, i)).collect(),
        form: None,
        names_poses: false,
    });
    let all = [
        by_key("pose, cycle", &both(&named, &keys.cycles), &both(&of_log.poses, &of_log.cycles)),
        by_key("pose", &named, &of_log.poses),
        by_name(&named, None),
        by_key("label", &keys.labels, &of_log.labels).filter(|_| several_targets),
        by_name(&keys.labels, Some(NUMBER.to_owned())),
        by_name(&rest, form),
        by_key("pose", &keys.poses, &of_log.poses),
        row,
        by_time(keys, &of_log),
    ];
    let enough = |join: &Join| join.matching * 2 > join.keys;
    let mut usable: Vec<Join> = all.into_iter().flatten().filter(enough).collect();
    let fits = |join: &Join| {
        robot.is_none_or(|robot| {
            tested(robot, export, log, join).is_none_or(|(_, outcome)| !matches!(outcome, Outcome::Contradicted(_)))
        })
    };
    let at = usable.iter().position(fits).unwrap_or(0);
    (!usable.is_empty()).then(|| usable.swap_remove(at))
}

/// Joins each time of an export with the nearest row of the log, as far as the times overlap.
fn by_time(keys: &Keys, log: &Keys) -> Option<Join> {
    let (mine, logged) = (keys.times.as_ref()?, log.times.as_ref()?);
    let (first, last) = (logged.first()?, logged.last()?);
    let nearest = |time: f64| {
        let after = logged.partition_point(|t| *t < time).min(logged.len() - 1);
        let before = after.saturating_sub(1);
        if (logged[before] - time).abs() < (logged[after] - time).abs() { before } else { after }
    };
    let within = |(_, time): &(usize, &f64)| (*first..=*last).contains(*time);
    let pairs: Vec<(usize, usize)> = mine.iter().enumerate().filter(within).map(|(i, t)| (i, nearest(*t))).collect();
    Some(Join { by: "time", keys: mine.len(), matching: pairs.len(), pairs, form: None, names_poses: false })
}

/// Returns the labels behind a beginning that all have (`A::`), and their form (`A::{pose}`).
fn behind_common_beginning(labels: &[String]) -> Option<(String, Vec<String>)> {
    let (first, others) = labels.split_first()?;
    let common = |other: &String| first.bytes().zip(other.bytes()).take_while(|(a, b)| a == b).count();
    let length = others.iter().map(common).min()?;
    let (at, separator) = first.char_indices().rfind(|(at, c)| *at < length && !c.is_alphanumeric())?;
    let beginning = &first[..at + separator.len_utf8()];
    let rest = labels.iter().map(|label| label.strip_prefix(beginning).map(str::to_owned)).collect::<Option<_>>()?;
    Some((format!("{beginning}{{pose}}"), rest))
}
