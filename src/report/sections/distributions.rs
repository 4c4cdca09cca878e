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
    let note = tr!(words, "bootstrap-resamples", count = document.resamples);
    parameters.push(Block::note(if document.resamples > 0 { Text::from(note) } else { Text::default() }));
    let mut errors = Section::new("errors", tr!(words, "distributions-of-errors"));
    errors.push(Block::Table(table(&document.errors, words).on(phrase!("sheet-distributions-of-errors"))));
    errors.push(Block::note(Text::from(tr!(words, "largest-error-drawn"))));
    [parameters, errors].into_iter().filter_map(|section| section.on_terminal().whole()).collect()
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
