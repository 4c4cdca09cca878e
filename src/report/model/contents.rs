//! Whole contents of a report.

use super::block::Block;
use super::section::Section;
use super::text::Text;
use super::verdict::{Verdict, sentence};
use crate::words::{Words, tr};
use etalon_base::catalogue::{Entry, entries};
use etalon_base::date::Date;
use serde::Serialize;
use std::collections::BTreeMap;

/// A whole report.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Contents {
    pub title: String,
    pub subtitle: String,
    /// Explanation of synthetic data; empty for measured data.
    pub synthetic: Vec<String>,
    #[serde(flatten)]
    pub dates: Dates,
    /// Mark across every page of a document that must not be used as a certificate.
    pub draft: Option<String>,
    /// Number of the report, shown on every page.
    pub number: Option<String>,
    /// Scope of the results; empty for unsigned reports.
    pub statement: String,
    pub version: String,
    pub verdict: Verdict,
    pub sections: Vec<Section>,
    #[serde(flatten)]
    pub layout: Layout,
}

/// Dates of a report.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Dates {
    /// Date of the measurements.
    pub date: Option<String>,
    /// Date of issue.
    pub issued: Option<String>,
    /// Date of files without a given date, from `SOURCE_DATE_EPOCH`.
    #[serde(skip)]
    pub built: Option<Date>,
}

/// Layout of a report.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub(crate) struct Layout {
    /// `true` if the report is to be signed.
    pub signed: bool,
    /// `true` if the report has to fit on one page.
    pub compact: bool,
    /// `true` if the terminal omits parts that a page folds.
    #[serde(skip)]
    pub brief: bool,
}

impl Contents {
    /// Gives ids of messages their meaning as a tooltip and a link to their explanation, which
    /// follows the messages; a page that has to fit on one sheet has tooltips only.
    pub fn explained(mut self, words: &Words) -> Self {
        let known: BTreeMap<&str, Entry> =
            entries().into_iter().filter(Entry::is_message).map(|entry| (entry.id, entry)).collect();
        let mut ids = Vec::new();
        for block in self.sections.iter_mut().flat_map(|section| &mut section.blocks) {
            block.explain(&known, !self.layout.compact, &mut ids);
        }
        if ids.is_empty() || self.layout.compact {
            return self;
        }
        let at = self.sections.iter().position(|section| section.id == "messages");
        let at = at.unwrap_or(self.sections.len().saturating_sub(1));
        let blocks = ids.iter().filter_map(|id| Some(Block::text(Text::explanation(known.get(id.as_str())?, words))));
        let title = tr!(words, "explanations-of-messages");
        if let Some(section) = self.sections.get_mut(at) {
            section.push(Block::Aside { title, blocks: blocks.collect() });
        }
        self
    }

    /// Applies a common notation to each column, and the decimal mark of the language to cells and
    /// headlines; sentences and figures contain it already.
    pub fn in_language(mut self, words: &Words) -> Self {
        self.sections.iter_mut().flat_map(|s| &mut s.blocks).for_each(Block::one_notation);
        self.verdict.sentences.iter_mut().for_each(|text| *text = sentence(text));
        if words.number("0.1") == "0.1" {
            return self;
        }
        for headline in &mut self.verdict.headlines {
            (headline.before, headline.after) = (words.number(&headline.before), words.number(&headline.after));
        }
        for section in &mut self.sections {
            section.blocks.iter_mut().for_each(|block| block.numbers(words));
            let cells = section.data.iter_mut().flat_map(|table| table.rows.iter_mut().flatten());
            cells.chain(section.summary.iter_mut().map(|fact| &mut fact.said)).for_each(|cell| cell.numbers(words));
        }
        self
    }
}
