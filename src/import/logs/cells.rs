//! The cells of a column as values.

use super::super::split::{WHOLE, number};
use super::sheet::Sheet;
use super::{Values, Wanted, galil};
use crate::base::message::{Message, Problems};
use crate::base::table::{ASSEMBLY, LABEL};
use crate::import::format::Decimal;
use crate::import::format::Log;
use crate::import::format::LogFormat;

/// Whether a field is a number, in this decimal mark or with more digits than a number can keep.
pub(super) fn is_number(field: &str, decimal: Decimal) -> bool {
    number(field, decimal).is_ok()
}

/// The values of one column, in mm, deg and s; those that do not read are reported.
pub(super) fn read(sheet: &Sheet, log: &Log, wanted: &Wanted, at: usize, problems: &mut Problems) -> Values {
    if wanted.name == LABEL {
        return Values::Text(sheet.rows.iter().map(|row| row.fields.get(at).cloned().unwrap_or_default()).collect());
    }
    let nanoseconds = wanted.key.get_ref() == "time_ns";
    let before = problems.0.len();
    let mut read = Vec::with_capacity(sheet.rows.len());
    for row in &sheet.rows {
        let cell = row.fields.get(at).map(String::as_str).unwrap_or("");
        match if nanoseconds { seconds(cell) } else { number(cell, log.decimal) } {
            Ok(value) => read.push(value),
            Err(message) => {
                let unread = "every row needs its values: read it from the controller again, or remove the row";
                let hint = message.hint.clone().unwrap_or_else(|| unread.to_owned());
                problems.0.push(message.at(sheet.cell(row, at)).hint(hint));
            }
        }
    }
    if problems.0.len() > before {
        return Values::Real(read);
    }
    if log.format == LogFormat::Galil && wanted.is_joint() {
        galil::check_counts(sheet, at, &read, problems);
    }
    let (whole, modes) = (matches!(wanted.name.as_str(), "pose" | "cycle"), wanted.name == ASSEMBLY);
    for (value, row) in read.iter().zip(&sheet.rows) {
        let message = if modes && value.abs() != 1.0 {
            let hint = "leave the column out of `columns` if it is not known: then the nearer solution is taken";
            Message::error(format!("{value} is no assembly mode")).expected("1 or -1").hint(hint)
        } else if whole && (value.fract() != 0.0 || value.abs() > WHOLE) {
            Message::error(format!("{} {value} is no whole number", wanted.name))
        } else {
            continue;
        };
        problems.0.push(message.at(sheet.cell(row, at)));
    }
    let value = |read: f64| if nanoseconds { read } else { wanted.value(read) };
    Values::Real(read.into_iter().map(value).collect())
}

/// Seconds of whole nanoseconds. Nineteen digits are more than a number of 64 bits keeps, so that seconds are split off
/// first.
fn seconds(cell: &str) -> std::result::Result<f64, Message> {
    let wrong = |_| Message::error(format!("`{cell}` is no whole number of nanoseconds"));
    let ns: i64 = cell.parse().map_err(wrong)?;
    Ok(ns.div_euclid(1_000_000_000) as f64 + ns.rem_euclid(1_000_000_000) as f64 * 1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nineteen_digits_of_nanoseconds_keep_the_microsecond() {
        assert!((seconds("1651499784376123456").unwrap() - 1651499784.376123).abs() < 1e-6);
        assert_eq!(seconds("-1500000000").unwrap(), -1.5);
        assert!(seconds("1.5").is_err() && seconds("").is_err());
    }
}
