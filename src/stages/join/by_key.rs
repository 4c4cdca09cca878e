//! Join of points and rows of the log with equal keys.

use super::unmatched::At;
use super::{Remarks, Row, Target, contradictions};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Problems, Result};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_documents::Unmatched;
use etalon_formats::JointLog;
use std::collections::BTreeSet;

/// Values of the keys of a row.
type Key = [Option<PoseName>; 2];
/// Rows of one key, with the key.
type Group<'k> = &'k [(Key, usize)];

/// Rows by their keys.
struct Keys {
    /// Keys with the indices of their rows, sorted.
    rows: Vec<(Key, usize)>,
}

impl Keys {
    /// Rows with equal keys, key by key.
    fn groups(&self) -> impl Iterator<Item = Group<'_>> + Clone {
        self.rows.chunk_by(|a, b| a.0 == b.0)
    }

    /// The first row of a key.
    fn first(&self, key: &Key) -> Option<usize> {
        let at = self.rows.partition_point(|(other, _)| other < key);
        self.rows.get(at).filter(|(other, _)| other == key).map(|(_, row)| *row)
    }

    /// The rows whose keys have no row there, key by key.
    fn without<'k>(&'k self, there: &Keys) -> Vec<Group<'k>> {
        self.groups().filter(|rows| there.first(&rows[0].0).is_none()).collect()
    }
}

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
    let twice = logged.groups().filter(|rows| rows.len() > 1).map(|rows| {
        let lines: Vec<usize> = rows.iter().map(|&(_, row)| log.rows[row].line).collect();
        phrase!("key-in-lines", key = in_words(keys, &rows[0].0), lines)
    });
    let twice: Vec<_> = twice.collect();
    if !twice.is_empty() {
        let same = |pair: &[(Key, usize)]| log.rows[pair[0].1].joints == log.rows[pair[1].1].joints;
        let are_repeats = logged.groups().all(|rows| rows.windows(2).all(same));
        let message = error!("log-key-twice", log = name, count = twice.len(), keys = twice);
        let message = match (are_repeats, keys.contains(&"cycle")) {
            (true, _) => message.hint(phrase!("remove-repeated-rows")),
            (false, true) => message.hint(phrase!("remove-invalid-rows")),
            (false, false) => message,
        };
        return Err(message.into());
    }
    let alone = [measured.without(&logged), logged.without(&measured)];
    misspelt(keys, targets, &measured, log, &logged)?;
    let mut report = |of: &str, at: &dyn Fn(usize, String, &Phrase) -> Unmatched, alone: &[Group], reason: Phrase| {
        if !alone.is_empty() {
            let shown = alone.iter().take(SHOWN).map(|rows| format!("[{}]", listed(&rows[0].0)));
            let mut shown: Vec<String> = shown.collect();
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
        let rows = alone.iter().copied().flatten();
        remarks.unmatched.extend(rows.map(|(key, row)| at(*row, in_words(keys, key), &reason)));
    };
    let point = |i: usize, key, reason: &Phrase| At::point(targets[i].point).unmatched(key, reason);
    report("points", &point, &alone[0], phrase!("no-row-of-key", log = name));
    let row = |i: usize, key, reason: &Phrase| At::log(log, &log.rows[i]).unmatched(key, reason);
    report("log", &row, &alone[1], phrase!("no-point-of-key"));
    let met = measured.groups().filter_map(|rows| Some((rows, &log.rows[logged.first(&rows[0].0)?])));
    let pairs = met.flat_map(|(rows, met)| rows.iter().map(move |&(_, i)| (&targets[i], met)));
    if keys[0] == "row" {
        contradictions(log, pairs.clone().map(|(target, met)| (target.point, met)))?;
    }
    Ok(pairs.map(|(target, met)| Row::new(target, met)).collect())
}

/// Returns an error if measured points and the log both have keys without a partner, and one of
/// these is a pose with a text that the other does not have: a misspelling.
fn misspelt(keys: &[&str], targets: &[Target], measured: &Keys, log: &JointLog, logged: &Keys) -> Result<()> {
    let posed = |lone: &[Group]| -> Vec<(PoseName, usize)> {
        lone.iter().filter_map(|rows| Some((rows[0].0[0]?, rows[0].1))).collect()
    };
    if keys[0] != "pose" {
        return Ok(());
    }
    let (here, there) = (posed(&measured.without(logged)), posed(&logged.without(measured)));
    if here.is_empty() || there.is_empty() {
        return Ok(());
    }
    let wrong = |alone: &[(PoseName, usize)], other: &Keys| {
        let unknown =
            |pose: PoseName| pose.number().is_none() && other.rows.iter().all(|(key, _)| key[0] != Some(pose));
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
    for key in keys {
        if rows.iter().any(|row| number(row, key).is_none()) {
            return Err(Problems::from(error!("join-key-missing", key)));
        }
    }
    let key = |row: &T| std::array::from_fn(|k| number(row, keys.get(k)?));
    let mut rows: Vec<(Key, usize)> = rows.iter().enumerate().map(|(i, row)| (key(row), i)).collect();
    rows.sort_unstable();
    Ok(Keys { rows })
}

fn listed(key: &Key) -> String {
    key.iter().flatten().map(PoseName::to_string).collect::<Vec<_>>().join(", ")
}

/// A key in words: `pose 3, cycle 1`.
fn in_words(names: &[&str], key: &Key) -> String {
    names.iter().zip(key.iter().flatten()).map(|(name, value)| format!("{name} {value}")).collect::<Vec<_>>().join(", ")
}
