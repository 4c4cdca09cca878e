//! The table of parameters: each number with the digits that its uncertainty allows.

use super::number;
use super::words::Words;
use crate::document::{ParameterEntry, ParameterStatus};
use serde::Serialize;

#[derive(Debug, PartialEq, Serialize)]
pub(super) struct Row {
    pub name: String,
    pub unit: String,
    pub nominal: String,
    pub before: String,
    pub value: String,
    pub change: String,
    /// standard uncertainty, k = 1; empty where not identified
    pub u: String,
    /// U = 2 u
    pub expanded: String,
    pub status: String,
    pub confounded_with: Vec<String>,
}

pub(super) fn rows(parameters: &[ParameterEntry], words: &Words) -> Vec<Row> {
    parameters.iter().map(|p| row(p, words)).collect()
}

fn row(p: &ParameterEntry, words: &Words) -> Row {
    let u = p.standard_uncertainty;
    let value = |v: f64| number::with_uncertainty(v, u);
    let change = p.value - p.nominal;
    Row {
        name: p.name.clone(),
        unit: p.unit.clone(),
        nominal: value(p.nominal),
        before: value(p.before),
        value: value(p.value),
        change: if change > 0.0 { format!("+{}", value(change)) } else { value(change) },
        u: u.map_or_else(String::new, |u| number::significant(u, 2)),
        expanded: u.map_or_else(String::new, |u| number::significant(2.0 * u, 2)),
        status: status(p.status, words),
        confounded_with: p.confounded_with.clone(),
    }
}

/// Why a parameter has its value, in words.
pub(super) fn status(status: ParameterStatus, words: &Words) -> String {
    match status {
        ParameterStatus::Identified => words.say("identified"),
        ParameterStatus::Fixed => words.say("held by the campaign"),
        ParameterStatus::NotIdentifiable => words.say("held: the data cannot tell it apart"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_follow_the_uncertainty() {
        let mut p = ParameterEntry {
            name: "d".into(),
            unit: "mm".into(),
            nominal: 300.0,
            before: 300.0,
            value: 299.123_456_789,
            standard_uncertainty: Some(0.001_49),
            status: ParameterStatus::Identified,
            confounded_with: vec![],
        };
        let identified = row(&p, &Words::default());
        assert_eq!((identified.value.as_str(), identified.change.as_str()), ("299.1235", "-0.8765"));
        assert_eq!((identified.u.as_str(), identified.expanded.as_str()), ("0.0015", "0.0030"));
        (p.standard_uncertainty, p.status) = (None, ParameterStatus::NotIdentifiable);
        let held = row(&p, &Words::default());
        assert_eq!((held.value.as_str(), held.u.as_str()), ("299.1235", ""));
        assert!(held.status.contains("cannot tell it apart"));
    }
}
