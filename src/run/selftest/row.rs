//! Tests of a requirement: comparisons of values with their references.

use super::data::{Data, Slip};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::{SelftestCheck, SelftestRequirement};

/// Comparison of a value with its reference.
#[derive(Debug)]
pub(super) struct Comparison {
    pub test: Phrase,
    pub source: &'static str,
    pub unit: &'static str,
    pub expected: f64,
    pub found: f64,
    pub permissible: f64,
}

impl Comparison {
    /// `true` if the deviation is permissible; a value that is not finite fails.
    pub fn passes(&self) -> bool {
        (self.found - self.expected).abs() <= self.permissible
    }
}

/// Rows of one source.
#[derive(Debug)]
pub(super) struct Rows {
    pub source: &'static str,
    pub all: Vec<Comparison>,
}

impl Rows {
    pub fn new(source: &'static str) -> Self {
        Self { source, all: Vec::new() }
    }

    /// Adds a comparison.
    pub fn add(&mut self, test: Phrase, unit: &'static str, [expected, found]: [f64; 2], permissible: f64) {
        self.all.push(Comparison { test, source: self.source, unit, expected, found, permissible });
    }

    /// Adds the comparison of several values, by the one with the largest deviation. Lists of
    /// different lengths, and empty lists, fail.
    pub fn add_all(&mut self, test: Phrase, unit: &'static str, [expected, found]: [&[f64]; 2], permissible: f64) {
        let apart = |i: &usize| {
            let deviation = (found[*i] - expected[*i]).abs();
            if deviation.is_nan() { f64::INFINITY } else { deviation }
        };
        let same = expected.len() == found.len();
        let worst = (0..expected.len()).filter(|_| same).max_by(|i, j| apart(i).total_cmp(&apart(j)));
        let pair = worst.map_or([f64::NAN; 2], |i| [expected[i], found[i]]);
        self.add(test, unit, pair, permissible);
    }

    /// Adds a test that could not be made.
    pub fn failed(&mut self, test: Phrase) {
        self.add(test, "", [f64::NAN; 2], 0.0);
    }
}

/// A requirement with its tests.
pub(super) struct Subject {
    pub id: &'static str,
    pub requirement: fn() -> Phrase,
    pub rows: fn(&Data) -> Vec<Rows>,
    /// Seeded faults in the reference data, each of which must fail a comparison.
    pub slips: &'static [Slip],
}

/// Result of the tests of a requirement.
pub(super) fn requirement_result(id: &str, requirement: Phrase, rows: Vec<Rows>) -> SelftestRequirement {
    let checks: Vec<SelftestCheck> = rows.into_iter().flat_map(|rows| rows.all).map(check).collect();
    SelftestRequirement {
        id: id.to_owned(),
        requirement: requirement.into(),
        pass: !checks.is_empty() && checks.iter().all(|c| c.pass),
        checks,
    }
}

fn check(row: Comparison) -> SelftestCheck {
    let finite = |value: f64| value.is_finite().then_some(value);
    SelftestCheck {
        pass: row.passes(),
        test: row.test.into(),
        source: row.source.to_owned(),
        unit: row.unit.to_owned(),
        expected: finite(row.expected),
        found: finite(row.found),
        deviation: finite(row.found - row.expected),
        permissible: row.permissible,
    }
}

/// Name of a test that could not be made, with its reason.
pub(super) fn not_made(name: &str, reason: &dyn std::fmt::Display) -> Phrase {
    phrase!("selftest-not-made", name, reason = reason.to_string())
}
