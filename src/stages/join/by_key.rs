//! Join of points and rows of the log with equal keys.

use super::unmatched::At;
use super::{Remarks, Row, Target, contradictions};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Problems, Result};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_documents::Unmatched;
use etalon_formats::JointLog;
use std::collections::{BTreeMap, BTreeSet};

/// Maximum number of names of poses in a message, and of numbers.
type Key = [Option<PoseName>; 2];
/// Indices of rows by their key.
type Keys = BTreeMap<Key, Vec<usize>>;

/// Maximum number of keys without a partner in a message.
const SHOWN: usize = 8;

/// Joins on equal keys. A key that occurs twice in the log is an error, a key without a partner a
/// warning.
pub(super) fn by_key(targets: &[Target], log: &JointLog, keys: &[&str], remarks: &mut Remarks) -> Result<Vec<Row>> {
    let number = |key: &str, [row, file]: [i64; 2], pose: Option<PoseName>, cycle: Option<i64>| match key {
        "row" => Some(row.into()),
        "file" => Some(file.into()),
        "pose" => pose,
        _ => cycle.map(PoseName::from),
    };
    // joints in several exports: a row meets the one of its file
    let several = keys == ["row"] && !log.files.is_empty();
    let keys = if several { &["row", "file"] } else { keys };
    let file = |name: &str| log.files.iter().position(|file| file == name).map_or(0, |i| i as i64 + 1);
    let measured = collected(keys, targets, |t: &Target, key| {
        number(key, [t.point.row.into(), file(&t.point.export)], t.point.pose, t.point.cycle)
    })?;
    let logged =
        collected(keys, &log.rows, |row, key| number(key, [row.row, row.file.unwrap_or(0)], row.pose, row.cycle))?;
    let name = &log.name;
    let twice = logged.iter().filter(|(_, rows)| rows.len() > 1).map(|(key, rows)| {
        let lines: Vec<usize> = rows.iter().map(|&row| log.rows[row].line).collect();
        phrase!("key-in-lines", key = in_words(keys, key), lines)
    });
    let twice: Vec<_> = twice.collect();
    if !twice.is_empty() {
        return Err(error!("log-key-twice", log = name, count = twice.len(), keys = twice).into());
    }
    misspelt(keys, (targets, &measured), (log, &logged))?;
    let mut report =
        |of: &str, at: &dyn Fn(usize, String, &Phrase) -> Unmatched, here: &Keys, there: &Keys, reason: Phrase| {
            let alone: Vec<&Key> = here.keys().filter(|key| !there.contains_key(*key)).collect();
            if !alone.is_empty() {
                let mut shown: Vec<String> = alone.iter().take(SHOWN).map(|k| format!("[{}]", listed(k))).collect();
                shown.extend((alone.len() > SHOWN).then(|| "...".to_owned()));
                let message = warning!(
                    "keys-unmatched",
                    count = alone.len(),
                    of,
                    log = name,
                    columns = keys.join(", "),
                    keys = shown
                );
                remarks.messages.push(message.routine());
            }
            for key in alone {
                remarks.unmatched.extend(here[key].iter().map(|&row| at(row, in_words(keys, key), &reason)));
            }
        };
    let point = |i: usize, key, reason: &Phrase| At::point(targets[i].point).unmatched(key, reason);
    report("points", &point, &measured, &logged, phrase!("no-row-of-key", log = name));
    let row = |i: usize, key, reason: &Phrase| At::log(log, &log.rows[i]).unmatched(key, reason);
    report("log", &row, &logged, &measured, phrase!("no-point-of-key"));
    let met = measured.iter().filter_map(|(key, rows)| Some((rows, &log.rows[*logged.get(key)?.first()?])));
    let pairs = met.flat_map(|(rows, met)| rows.iter().map(move |&i| (&targets[i], met)));
    if keys[0] == "row" {
        contradictions(log, pairs.clone().map(|(target, met)| (target.point, met)))?;
    }
    Ok(pairs.map(|(target, met)| Row::of(target, met)).collect())
}

/// Returns an error if measured points and the log both have keys without a partner, and one of
/// these is a pose with a text that the other lacks: a misspelling.
fn misspelt(keys: &[&str], (targets, measured): (&[Target], &Keys), (log, logged): (&JointLog, &Keys)) -> Result<()> {
    let alone = |here: &Keys, there: &Keys| -> Vec<(PoseName, usize)> {
        let lone = here.iter().filter(|(key, _)| !there.contains_key(*key));
        lone.filter_map(|(key, rows)| Some((key[0]?, *rows.first()?))).collect()
    };
    let (here, there) = (alone(measured, logged), alone(logged, measured));
    if keys[0] != "pose" || here.is_empty() || there.is_empty() {
        return Ok(());
    }
    let wrong = |alone: &[(PoseName, usize)], other: &Keys| {
        let unknown = |pose: PoseName| pose.number().is_none() && other.keys().all(|key| key[0] != Some(pose));
        alone.iter().copied().find(|(pose, _)| unknown(*pose))
    };
    let (of, pose, place, others) = match (wrong(&there, measured), wrong(&here, logged)) {
        (Some((pose, row)), _) => ("log", pose, At::log(log, &log.rows[row]).place(), here),
        (None, Some((pose, row))) => ("points", pose, At::point(targets[row].point).place(), there),
        (None, None) => return Ok(()),
    };
    let names: BTreeSet<String> = others.iter().map(|(pose, _)| pose.to_string()).collect();
    let message = error!("pose-misspelt", pose, log = log.name, of).at(place);
    Err(message.hint_names(&pose.to_string(), names.iter().map(String::as_str)).into())
}

/// Rows by their keys, which all rows must have.
fn collected<T>(keys: &[&str], rows: &[T], number: impl Fn(&T, &str) -> Option<PoseName>) -> Result<Keys> {
    let mut all = Keys::new();
    for key in keys {
        if rows.iter().any(|row| number(row, key).is_none()) {
            return Err(Problems::from(error!("join-key-missing", key)));
        }
    }
    for (i, row) in rows.iter().enumerate() {
        all.entry(std::array::from_fn(|k| number(row, keys.get(k)?))).or_default().push(i);
    }
    Ok(all)
}

fn listed(key: &Key) -> String {
    key.iter().flatten().map(PoseName::to_string).collect::<Vec<_>>().join(", ")
}

/// A key in words: `pose 3, cycle 1`.
fn in_words(names: &[&str], key: &Key) -> String {
    names.iter().zip(key.iter().flatten()).map(|(name, value)| format!("{name} {value}")).collect::<Vec<_>>().join(", ")
}
