//! KUKA RSI recordings: mm and deg (A, B, C turn about Z, Y, X), and two clocks.
//!
//! The clock of the log is `IPOC`, a counter in ms that the controller advances by its
//! interpolation cycle. `Timestamp` is the wall clock of the recording computer in whole seconds.

use super::{About, Columns, LogFormat, Values};
use crate::exports::Recognised;
use etalon_base::message::{Message, Place};
use etalon_base::{phrase, warning};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// Recordings of KUKA RSI: mm, deg; `IPOC` in ms is the clock.
pub(super) struct KukaRsi;

impl LogFormat for KukaRsi {
    fn about(&self) -> About {
        About {
            name: "kuka_rsi",
            title: "KUKA RSI",
            description: "KUKA RSI recording: mm, deg; `IPOC` in ms is the clock.",
        }
    }

    fn recognise(&self, header: &[&str], _text: &str) -> Option<Recognised> {
        Recognised::by(header.contains(&"IPOC"), 0.9, phrase!("is-kuka-rsi"))
    }

    fn column_unit(&self, column: &str) -> Option<&'static str> {
        column_unit(column)
    }

    fn remark(&self, file: &str, columns: &Columns) -> Option<Message> {
        gaps(file, columns)
    }
}

/// Returns the unit of a column.
fn column_unit(column: &str) -> Option<&'static str> {
    let axis = column.trim_start_matches("AIPos_").trim_start_matches("ASPos_").trim_start_matches("AIPos.");
    let axis = axis.trim_start_matches("ASPos.");
    match column {
        "IPOC" => Some("ms"),
        "Timestamp" => Some("wall-clock"),
        _ if ["X_", "Y_", "Z_"].iter().any(|start| column.starts_with(start)) => Some("mm"),
        _ if ["A_", "B_", "C_"].iter().any(|start| column.starts_with(start)) => Some("deg"),
        _ if ["A1", "A2", "A3", "A4", "A5", "A6"].contains(&axis) => Some("deg"),
        _ => None,
    }
}

/// Returns a warning if the counter skips cycles. The cycle is the most frequent step.
fn gaps(file: &str, columns: &Columns) -> Option<Message> {
    let times = columns.columns.iter().find(|(name, _)| name == "time_s");
    let Some((_, Values::Real(times_s))) = times else { return None };
    let ms = |pair: &[f64]| ((pair[1] - pair[0]) * 1e3).round() as i64;
    let mut steps: BTreeMap<i64, usize> = BTreeMap::new();
    times_s.windows(2).for_each(|pair| *steps.entry(ms(pair)).or_default() += 1);
    let (&step, _) = steps.iter().max_by_key(|(step, n)| (**n, Reverse(**step)))?;
    let odd: Vec<usize> = (0..times_s.len() - 1).filter(|&i| ms(&times_s[i..i + 2]) != step).collect();
    let first = *odd.first()?;
    let line = columns.lines.get(first + 1).map(|&line| line as usize);
    let place = Place { line, ..Place::file(file) };
    Some(warning!("rsi-cycles-missing", count = odd.len(), step_ms = step).at(place))
}
