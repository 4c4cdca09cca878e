//! Distributions of a campaign's results beside its linear uncertainties (JCGM 101).

use crate::model::{Block, Cell, Columns, Section, Table, significant, strong_term, term, with_uncertainty};
use crate::model::{Text, Verdict};
use crate::words::Words;
use etalon_documents::{DistributionEntry, UncertaintyDocument, UncertaintyFrom};

/// Result of the draws in sentences.
pub(crate) fn verdict(document: &UncertaintyDocument, words: &Words) -> Verdict {
    let apart = document.parameters.iter().filter(|p| p.agrees == Some(false)).count();
    let mut sentences = vec![match apart {
        0 => words.fill("Linear propagation and {0} draws agree for all {1} parameters.", &[&document.draws, &document.parameters.len()]),
        n => words.fill("Linear propagation and {0} draws differ for {1} of {2} parameters by more than half of the second digit of the standard uncertainty.", &[&document.draws, &n, &document.parameters.len()]),
    }];
    if !document.two_digits_reached {
        sentences.push(words.say("The draws do not suffice for two digits of every standard uncertainty: allow more."));
    }
    if document.uncertainties_from != UncertaintyFrom::Instrument {
        let reported = document.parameters.iter().any(|p| p.standard_uncertainty.is_some());
        sentences.push(match (reported, document.resamples > 0) {
            (true, true) => words.say("Draws contain what is stated; the model leaves out more: the report's standard uncertainties and the bootstrap contain that."),
            (true, false) => words.say("Draws contain what is stated; the model leaves out more: the report's standard uncertainties contain that."),
            (false, true) => words.say("Draws contain what is stated; the model leaves out more: the bootstrap contains that."),
            (false, false) => words.say("Draws contain what is stated, and not what the model leaves out."),
        });
    }
    Verdict { met: true, sentences, ..Verdict::default() }
}

/// Tables of parameters and errors.
pub(crate) fn sections(document: &UncertaintyDocument, words: &Words) -> Vec<Section> {
    let mut parameters = Section::new("distributions", words.say("Distributions of the parameters"));
    parameters.push(Block::Table(table(&document.parameters, words).on("Distributions")));
    let note = words.fill("Bootstrap: {0} resamples of poses and cycles.", &[&document.resamples]);
    parameters.push(Block::note(if document.resamples > 0 { Text::from(note) } else { Text::default() }));
    let mut errors = Section::new("errors", words.say("Distributions of the errors of the validation poses"));
    errors.push(Block::Table(table(&document.errors, words).on("Distributions of errors")));
    [parameters, errors].into_iter().filter_map(|section| section.on_terminal().whole()).collect()
}

fn table(entries: &[DistributionEntry], words: &Words) -> Table {
    let agrees = |e: &DistributionEntry| match e.agrees {
        Some(true) => term(words, "yes"),
        Some(false) => strong_term(words, "no"),
        None => Cell::Missing,
    };
    let end = |e: &DistributionEntry, i: usize| {
        with_uncertainty(e.interval_95.map(|ends| ends[i]), Some(e.standard_deviation))
    };
    let columns = Columns::<DistributionEntry>::new()
        .both("name", "", |e| e.name.as_str())
        .both("unit", "", |e| e.unit.as_str())
        .both("value", "", |e| with_uncertainty(e.value, Some(e.standard_deviation)))
        .both("u, linear", "", |e| significant(e.linear, 2))
        .both("u, draws", "", |e| significant(e.standard_deviation, 2))
        .both("2.5 %", "", move |e| end(e, 0))
        .both("97.5 %", "", move |e| end(e, 1))
        .both("agree", "", agrees)
        .both("u, report", "", |e| significant(e.standard_uncertainty, 2))
        .both("u, bootstrap", "", |e| significant(e.bootstrap, 2));
    Table::of(words, entries, columns).without_empty_columns()
}
