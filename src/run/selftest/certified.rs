//! Reference campaigns (`samples/reference`), whose parameters, covariance and errors were computed
//! in 110 digits by a program that shares nothing with etalon.

use super::data::{Data, Slip};
use super::embedded::CAMPAIGNS;
use super::row::{Comparison, Rows, Subject, not_made};
use super::sample::Scratch;
use crate::run::pipeline::evaluate;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Place, Result};
use etalon_base::{error, phrase};
use etalon_documents::{AccuracySet, IdentifiedDocuments, ParameterEntry, Statistics};
use rayon::prelude::*;
use serde::Serialize;
use std::sync::LazyLock;

pub(super) const SUBJECT: Subject = Subject {
    id: "reference",
    requirement: || phrase!("selftest-reference"),
    rows,
    slips: &[
        Slip::Digit("/certified/prexyt-clean/parameters/3/value", 8),
        Slip::Digit("/certified/five-bar/parameters/0/standard_uncertainty", 6),
        Slip::Swap("/certified/prexyt-clean/parameters/6/value", "/certified/prexyt-clean/parameters/7/value"),
        Slip::Unit("/certified/serial-dh/errors/0/after", 1e-3),
    ],
};

/// Results of the campaigns, computed once for all seeded faults in the certified values.
static FOUND: LazyLock<Vec<Result<IdentifiedDocuments>>> =
    LazyLock::new(|| CAMPAIGNS.par_iter().map(|(_, _, files)| identified(files)).collect());

fn rows(data: &Data) -> Vec<Rows> {
    let mut rows = Rows::new("samples/reference");
    for ((name, _, _), found) in CAMPAIGNS.iter().zip(FOUND.iter()) {
        match found {
            Ok(found) => compare(name, &data.at(&format!("/certified/{name}")), found, &mut rows),
            Err(problems) => rows.failed(not_made(name, problems)),
        }
    }
    vec![rows]
}

fn identified(files: &[(&str, &str)]) -> Result<IdentifiedDocuments> {
    let scratch = Scratch::with(files)?;
    let campaign = scratch.read()?;
    let missing = || error!("identify-missing").at(Place::file(campaign.path.as_str()));
    Ok(evaluate(&campaign)?.results.identified.ok_or_else(missing)?)
}

/// Values with a permissible error each, of which the worst one is listed.
#[derive(Default)]
struct Worst(Option<(f64, [f64; 3])>);

impl Worst {
    fn add(&mut self, expected: f64, found: f64, permissible: f64) {
        let ratio = (found - expected).abs() / permissible;
        let ratio = if ratio.is_nan() { f64::INFINITY } else { ratio };
        if self.0.is_none_or(|(worst, _)| ratio > worst) {
            self.0 = Some((ratio, [expected, found, permissible]));
        }
    }

    fn list(self, test: Phrase, unit: &'static str, rows: &mut Rows) {
        let (expected, found, permissible) = match self.0 {
            Some((_, [expected, found, permissible])) => (expected, found, permissible),
            None => (f64::NAN, f64::NAN, 0.0),
        };
        rows.all.push(Comparison { test, source: rows.source, unit, expected, found, permissible });
    }
}

/// Values, uncertainties, covariance, residuals and errors.
fn compare(name: &str, certified: &Data, found: &IdentifiedDocuments, rows: &mut Rows) {
    let (mut values, mut uncertainties) = (Worst::default(), Worst::default());
    let relative = certified.number("/covariance/mpe_relative");
    let (mut wrong, mut count) = (0usize, 0usize);
    for expected in certified.at("/parameters").items() {
        let own = |p: &&ParameterEntry| p.name == expected.text("/name");
        let Some(p) = found.parameters.parameters.iter().find(own) else {
            wrong += 1;
            continue;
        };
        count += 1;
        let mpe = expected.number("/mpe");
        values.add(expected.number("/value"), p.value, mpe);
        if expected.number("/before").is_finite() {
            values.add(expected.number("/before"), p.before, mpe);
        }
        wrong += usize::from(!is_word(&p.status, expected.text("/status")));
        let u = expected.number("/standard_uncertainty");
        if u.is_finite() {
            uncertainties.add(u, p.standard_uncertainty.unwrap_or(f64::NAN), relative * u);
        }
    }
    values.list(phrase!("selftest-certified-values", name, count), "mm, deg, 1", rows);
    uncertainties.list(phrase!("selftest-certified-uncertainties", name), "mm, deg, 1", rows);
    rows.add(phrase!("selftest-certified-status", name), "", [0.0, wrong as f64], 0.0);
    covariance(certified, found).list(phrase!("selftest-certified-covariance", name), "", rows);
    let residuals = &found.parameters.residuals;
    let mut worst = Worst::default();
    let pairs = [("rms_mm", residuals.rms), ("chi_square", residuals.test.chi_square.unwrap_or(f64::NAN))];
    for (key, value) in pairs {
        let expected = certified.number(&format!("/residuals/{key}"));
        worst.add(expected, value, relative * expected);
    }
    worst.list(phrase!("selftest-certified-residuals", name), "", rows);
    errors(certified, &found.accuracy.sets).list(phrase!("selftest-certified-errors", name), "mm, deg", rows);
}

/// `true` if a value has this spelling in documents.
fn is_word(value: &impl Serialize, word: &str) -> bool {
    serde_json::to_value(value).is_ok_and(|value| value.as_str() == Some(word))
}

/// Covariances, relative to the standard uncertainties.
fn covariance(certified: &Data, found: &IdentifiedDocuments) -> Worst {
    let mut worst = Worst::default();
    let relative = certified.number("/covariance/mpe_relative");
    let names = certified.texts("/covariance/parameters");
    let own: Vec<&str> = found.parameters.identified().map(|p| p.name.as_str()).collect();
    let places: Vec<Option<usize>> = names.iter().map(|name| own.iter().position(|own| own == name)).collect();
    let rows: Vec<Vec<f64>> =
        certified.at("/covariance/lower_triangle").items().iter().map(|row| row.numbers("")).collect();
    let variance = |i: usize| rows.get(i).and_then(|row| row.get(i)).copied().unwrap_or(f64::NAN);
    for (i, row) in rows.iter().enumerate() {
        for (j, expected) in row.iter().enumerate() {
            let place = |k: usize| places.get(k).copied().flatten();
            let value = || Some(*found.parameters.covariance.get(place(i)?)?.get(place(j)?)?);
            worst.add(*expected, value().unwrap_or(f64::NAN), relative * (variance(i) * variance(j)).sqrt());
        }
    }
    worst
}

/// Errors before and after.
fn errors(certified: &Data, sets: &[AccuracySet]) -> Worst {
    let mut worst = Worst::default();
    for expected in certified.at("/errors").items() {
        let set = sets.iter().find(|set| is_word(&set.name, expected.text("/set")));
        let found = set.and_then(|set| set.errors.iter().find(|e| is_word(&e.quantity, expected.text("/quantity"))));
        let mpe = expected.number("/mpe");
        for side in ["before", "after"] {
            let of = |summary: &Statistics, key: &str| match key {
                "mean" => summary.mean,
                "rms" => summary.rms,
                _ => summary.max,
            };
            for key in ["mean", "rms", "max"] {
                let value = expected.number(&format!("/{side}/{key}"));
                let summary = found.map(|e| if side == "before" { &e.before } else { &e.after });
                if value.is_finite() {
                    worst.add(value, summary.map_or(f64::NAN, |summary| of(summary, key)), mpe);
                }
            }
        }
    }
    worst
}
