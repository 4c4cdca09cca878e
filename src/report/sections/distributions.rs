//! Distributions of a campaign's results, with its linear uncertainties for comparison (JCGM 101).

use crate::model::{Block, Cell, Columns, Section, Table, significant, strong_term, term, with_uncertainty};
use crate::model::{Text, Verdict};
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{DistributionEntry, UncertaintyDocument, UncertaintyFrom};

/// Result of the draws in sentences.
pub(crate) fn verdict(document: &UncertaintyDocument, words: &Words) -> Verdict {
    let apart = document.parameters.iter().filter(|p| p.agrees == Some(false)).count();
    let mut sentences = vec![match apart {
        0 => tr!(words, "draws-agree", draws = document.draws, parameters = document.parameters.len()),
        n => tr!(words, "draws-differ", draws = document.draws, differing = n, parameters = document.parameters.len()),
    }];
    let judged: Vec<bool> = document.errors.iter().filter_map(|e| e.agrees).collect();
    if !judged.is_empty() {
        sentences.push(match judged.iter().filter(|agrees| !**agrees).count() {
            0 => tr!(words, "errors-draws-confirm", errors = judged.len()),
            n => tr!(words, "errors-draws-larger", differing = n, errors = judged.len()),
        });
    }
    if !document.two_digits_reached {
        sentences.push(tr!(words, "draws-too-few"));
    }
    if document.uncertainties_from != UncertaintyFrom::Instrument {
        let reported = document.parameters.iter().any(|p| p.standard_uncertainty.is_some());
        sentences.push(match (reported, document.resamples > 0) {
            (true, true) => tr!(words, "draws-without-model-both"),
            (true, false) => tr!(words, "draws-without-model-report"),
            (false, true) => tr!(words, "draws-without-model-bootstrap"),
            (false, false) => tr!(words, "draws-of-stated"),
        });
    }
    Verdict { met: true, sentences, ..Verdict::default() }
}

/// Tables of parameters and errors.
pub(crate) fn sections(document: &UncertaintyDocument, words: &Words) -> Vec<Section> {
    let mut parameters = Section::new("distributions", tr!(words, "distributions-of-parameters"));
    parameters.push(Block::Table(table(&document.parameters, words).on(phrase!("sheet-distributions"))));
    parameters.push(Block::note(bootstrap(document, words)));
    let mut errors = Section::new("errors", tr!(words, "distributions-of-errors"));
    errors.push(Block::Table(table(&document.errors, words).on(phrase!("sheet-distributions-of-errors"))));
    errors.push(Block::note(Text::from(tr!(words, "largest-error-drawn"))));
    errors.push(Block::note(Text::from(tr!(words, "errors-contain-noise"))));
    [parameters, errors].into_iter().filter_map(|section| section.on_terminal().whole()).collect()
}

/// Share of the linear uncertainty below which the bootstrap contradicts it.
const CONTRADICTION: f64 = 0.5;

/// Note on the bootstrap, with the number of parameters whose uncertainty it contradicts; empty
/// without resamples.
fn bootstrap(document: &UncertaintyDocument, words: &Words) -> String {
    if document.resamples == 0 {
        return String::new();
    }
    let note = tr!(words, "bootstrap-resamples", count = document.resamples);
    let contradicts = |p: &&DistributionEntry| {
        p.bootstrap.zip(p.linear).is_some_and(|(bootstrap, linear)| bootstrap < CONTRADICTION * linear)
    };
    match document.parameters.iter().filter(contradicts).count() {
        0 => note,
        count => format!("{note} {}", tr!(words, "bootstrap-without-tolerances", count)),
    }
}

fn table(entries: &[DistributionEntry], words: &Words) -> Table {
    let agrees = |e: &DistributionEntry| match e.agrees {
        Some(true) => term(words, phrase!("yes")),
        Some(false) => strong_term(words, phrase!("no")),
        None => Cell::Missing,
    };
    let end = |e: &DistributionEntry, i: usize| {
        with_uncertainty(e.interval_95.map(|ends| ends[i]), Some(e.standard_deviation))
    };
    let quantity = |e: &DistributionEntry| e.quantity.map_or(Cell::Missing, |q| term(words, q.phrase()));
    let columns = Columns::<DistributionEntry>::new()
        .both(phrase!("quantity"), "", quantity)
        .both(phrase!("name"), "", |e| e.name.as_str())
        .both(phrase!("unit"), "", |e| e.unit.as_str())
        .both(phrase!("value"), "", |e| with_uncertainty(e.value, Some(e.standard_deviation)))
        .both(phrase!("u-linear"), "", |e| significant(e.linear, 2))
        .both(phrase!("u-draws"), "", |e| significant(e.standard_deviation, 2))
        .both("2.5 %", "", move |e| end(e, 0))
        .both("97.5 %", "", move |e| end(e, 1))
        .both(phrase!("agree"), "", agrees)
        .both(phrase!("u-report"), "", |e| significant(e.standard_uncertainty, 2))
        .both(phrase!("u-bootstrap"), "", |e| significant(e.bootstrap, 2));
    Table::new(words, entries, columns).without_empty_columns()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bootstrap_that_omits_tolerances_is_explained() {
        let entry = |linear: f64, bootstrap: f64| {
            serde_json::json!({"name": "q1_x", "unit": "mm", "value": 0.1, "linear": linear, "bootstrap": bootstrap,
                "standard_uncertainty": linear, "mean": 0.1, "standard_deviation": linear, "interval_95": [0.0, 0.2],
                "agrees": true})
        };
        let document = |parameters: Vec<serde_json::Value>| -> UncertaintyDocument {
            serde_json::from_value(serde_json::json!({
                "schema": "etalon/uncertainty/1", "robot": "serial", "draws": 500, "two_digits_reached": true,
                "resamples": 50, "uncertainties_from": "instrument", "parameters": parameters, "errors": [],
                "messages": [], "provenance": {"version": "", "inputs": {}},
            }))
            .unwrap()
        };
        let words = Words::default();
        let note = tr!(words, "bootstrap-resamples", count = 50);
        assert_eq!(bootstrap(&document(vec![entry(0.17, 0.15)]), &words), note);
        let contradicted = document(vec![entry(0.17, 0.0053), entry(0.19, 0.18), entry(0.19, 0.0089)]);
        let explained = tr!(words, "bootstrap-without-tolerances", count = 2);
        assert_eq!(bootstrap(&contradicted, &words), format!("{note} {explained}"));
        assert_eq!(bootstrap(&UncertaintyDocument { resamples: 0, ..contradicted }, &words), "");
    }
}
