//! Certificate: one page of the report for the customer (ISO/IEC 17025:2017, 7.8.4), from the same
//! facts, verdict and errors.

use super::{conditions, errors, limits};
use crate::Report;
use crate::model::{Block, Contents, Section, Verdict};
use crate::words::{Words, tr};
use etalon_documents::AccuracyDocument;

/// Contents of the page, from the contents of the report.
pub(crate) fn contents(report: &Report, whole: Contents, words: &Words) -> Contents {
    let title = match report.identified {
        Some(_) => tr!(words, "calibration-certificate"),
        None => tr!(words, "test-certificate"),
    };
    let mut facts = Section::new("conditions", tr!(words, "item-customer-traceability"));
    facts.push(Block::facts(conditions::of_certificate(report, words)));
    let of_set = report.identified.and_then(|i| {
        // from the decisive poses
        let set = i.accuracy.sets.iter().rfind(|s| s.count > 0)?;
        let accuracy = AccuracyDocument {
            sets: vec![set.clone()],
            tool: None,
            map: None,
            placed_apart: Vec::new(),
            effects: Vec::new(),
            validation_distance: None,
            ..i.accuracy.clone()
        };
        let mut section = errors::of(&accuracy, &[], words);
        section.title = tr!(words, "results-before-and-after");
        Some(section)
    });
    Contents {
        subtitle: format!("{}. {}", whole.title, whole.subtitle),
        title,
        sections: [Some(facts), of_set, limits::section(report, words)].into_iter().flatten().collect(),
        statement: format!("{} {}", whole.statement, tr!(words, "certificate-reproduction")),
        // the table contains them
        verdict: Verdict { about: String::new(), headlines: Vec::new(), ..whole.verdict },
        compact: true,
        ..whole
    }
}
