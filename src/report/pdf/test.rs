//! The report of a test of repeatability alone.

use super::paper::{Labels, Paper, Verdict};
use super::{annex, iso9283, places, stated, streams};
use crate::report::words::Words;
use crate::report::{TestReport, facts, test_messages};

/// What stands in it, in the order of reading.
pub(super) fn paper(report: &TestReport, words: &Words) -> Paper {
    let (class, sentence) = crate::report::iso9283::verdict(report.iso9283, words);
    let (messages, more) = stated::messages(&test_messages(report), words);
    let sections = [
        stated::conditions(facts::facts(report.campaign, Some(report.iso9283), words), words),
        stated::limits(&report.iso9283.limits, words),
        messages,
        iso9283::section(report.iso9283, words),
        report.streams.and_then(|d| streams::section(d, words)),
        places::section(report.features, &report.frames.world, words),
        stated::inputs(report.import, &report.import.inputs(), words),
    ];
    Paper {
        title: report.campaign.name.clone(),
        subtitle: words.say("Report on repeatability"),
        synthetic: report.campaign.synthetic.clone(),
        date: report.campaign.date.clone(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        labels: Labels::of(&report.campaign.report, words),
        verdict: Verdict { class, sentences: vec![sentence], about: String::new(), headlines: vec![] },
        sections: sections.into_iter().flatten().collect(),
        annexes: [annex::refused(report.import, words), more].into_iter().flatten().collect(),
    }
}
