//! The report of a test by ISO 9283 alone.

use super::paper::{Labels, Paper, Verdict};
use super::{annex, iso9283, places, stated};
use crate::report::words::Words;
use crate::report::{Report, facts};

/// What stands in it, in the order of reading.
pub(super) fn paper(report: &Report, words: &Words) -> Paper {
    let found = crate::report::iso9283::verdict(report.tested, words);
    let (messages, more) = stated::messages(&report.messages(), words);
    let before = [
        stated::conditions(facts::facts(report.campaign, report.tested, words), words),
        stated::limits(report.limits(), words),
        messages,
    ];
    let after = [
        places::section(report.features, &report.frames.world, words),
        stated::inputs(report.import, &report.import.inputs(), words),
    ];
    Paper {
        title: report.campaign.name.clone(),
        subtitle: crate::report::iso9283::title(report.tested, words),
        synthetic: report.campaign.synthetic.clone(),
        date: report.campaign.date.clone(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        labels: Labels::of(&report.campaign.report, words),
        verdict: Verdict { class: found.class, sentences: found.sentences, about: String::new(), headlines: vec![] },
        sections: before
            .into_iter()
            .flatten()
            .chain(iso9283::sections(report.tested, words))
            .chain(after.into_iter().flatten())
            .collect(),
        annexes: [annex::refused(report.import, words), more].into_iter().flatten().collect(),
    }
}
