//! Galil array upload as CSV: names of the arrays in alphabetical order, then one row per index.
//!
//! Values are encoder counts; shorter arrays leave empty cells at their ends. There is no clock:
//! the command `RC` of the controller sets the period. Source: galil.com, "Comma-Separated Values
//! (CSV Files)".

use super::{About, LogFormat, Wanted};
use crate::exports::Recognised;
use etalon_base::message::{Message, Problems};
use etalon_base::{error, phrase};
use etalon_documents::Refused;
use etalon_tables::sheet::Sheet;

/// Array uploads of a Galil controller: encoder counts, no clock.
pub(super) struct Galil;

impl LogFormat for Galil {
    fn about(&self) -> About {
        About {
            name: "galil",
            title: "Galil arrays",
            description: "Galil array upload: encoder counts, arrays in alphabetical order, no clock.",
        }
    }

    /// Recognises whole numbers under names in alphabetical order. The evidence is weak: points in
    /// whole mm look alike.
    fn recognise(&self, header: &[&str], text: &str) -> Option<Recognised> {
        let whole = |cell: &str| cell.trim().is_empty() || cell.trim().parse::<i64>().is_ok();
        let words = header.iter().all(|name| name.starts_with(|c: char| c.is_ascii_alphabetic()));
        let rows = text.lines().skip(1).take(100);
        let counts = rows.clone().count() > 0 && rows.flat_map(|row| row.split(',')).all(whole);
        let what = phrase!("is-galil-arrays");
        Recognised::by(words && counts && header.len() > 1 && header.is_sorted(), 0.3, what)
    }

    fn has_stable_order(&self) -> bool {
        false
    }

    fn statement(&self, wanted: &Wanted) -> Option<Message> {
        states_counts(wanted)
    }

    fn cut(&self, sheet: &mut Sheet, wanted: &[(usize, &Wanted)], problems: &mut Problems) -> Vec<Refused> {
        cut(sheet, wanted, problems)
    }

    fn check_joint(&self, sheet: &Sheet, at: usize, read: &[f64], problems: &mut Problems) {
        check_counts(sheet, at, read, problems);
    }

    fn is_sorted(&self) -> bool {
        true
    }
}

/// Returns the error that a joint has no value of an encoder count.
fn states_counts(wanted: &Wanted) -> Option<Message> {
    let missing = wanted.is_joint() && wanted.column.per_count.is_none();
    missing.then(|| error!("count-value-missing", key = wanted.key.get_ref()))
}

/// Removes the rows after the end of a wanted array; an empty cell before the end is an error.
fn cut(sheet: &mut Sheet, wanted: &[(usize, &Wanted)], problems: &mut Problems) -> Vec<Refused> {
    let filled = |at: usize| sheet.rows.iter().rposition(|row| row.fields.get(at).is_some_and(|f| !f.is_empty()));
    let ends: Vec<usize> = wanted.iter().map(|(at, _)| filled(*at).map_or(0, |last| last + 1)).collect();
    let (shortest, longest) = (ends.iter().min().copied().unwrap_or(0), ends.iter().max().copied().unwrap_or(0));
    for row in &sheet.rows[..shortest] {
        for (at, wanted) in wanted.iter().filter(|(at, _)| row.fields.get(*at).is_some_and(|f| f.is_empty())) {
            let message = error!("galil-array-hole", column = wanted.key.get_ref());
            problems.0.push(message.at(sheet.cell(row, *at)));
        }
    }
    let ended = |i: usize| {
        let short = wanted.iter().zip(&ends).filter(|(_, end)| **end <= i).map(|((_, w), _)| w.key.get_ref().as_str());
        phrase!("galil-array-ended", columns = short.collect::<Vec<_>>())
    };
    let refused = (shortest..longest).map(|i| {
        let row = &sheet.rows[i];
        Refused::new(row.line, row.text, ended(i))
    });
    let refused = refused.collect();
    sheet.rows.truncate(shortest);
    if sheet.rows.is_empty() {
        problems.0.push(error!("galil-array-empty").at(sheet.place()));
    }
    refused
}

/// Checks that counts are whole numbers of 32 bits and do not wrap (jump by more than half the
/// range).
fn check_counts(sheet: &Sheet, at: usize, counts: &[f64], problems: &mut Problems) {
    const RANGE: f64 = 4_294_967_296.0;
    for (row, count) in sheet.rows.iter().zip(counts) {
        if count.fract() != 0.0 || count.abs() > RANGE / 2.0 {
            problems.0.push(error!("not-a-count", value = count).at(sheet.cell(row, at)));
        }
    }
    for (i, pair) in counts.windows(2).enumerate().filter(|(_, pair)| (pair[1] - pair[0]).abs() > RANGE / 2.0) {
        let message = error!("counter-wrapped", from = pair[0], to = pair[1]);
        problems.0.push(message.at(sheet.cell(&sheet.rows[i + 1], at)));
    }
}
