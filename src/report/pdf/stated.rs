//! What is stated rather than computed: conditions, limits, messages, inputs.

use super::paper::{Block, Section};
use crate::base::message::{Message, Severity, one_line};
use crate::document::{ImportDocument, LimitVerdict};
use crate::report::facts::Fact;
use crate::report::verdict;
use crate::report::words::Words;
use std::collections::BTreeMap;

/// Messages that stand between a reader and the results; the others are in an annex.
const SHOWN: usize = 6;

/// What the campaign states of its test.
pub(super) fn conditions(facts: Vec<Fact>, words: &Words) -> Option<Section> {
    let facts = Block::Facts { rows: facts.into_iter().map(|f| [f.what, f.text]).collect() };
    Section::of("conditions", words.say("Robot, instrument, conditions"), vec![facts])
}

/// Limits, what was reached, and whether they are met.
pub(super) fn limits<'a>(limits: impl IntoIterator<Item = &'a LimitVerdict>, words: &Words) -> Option<Section> {
    let row = |limit: &LimitVerdict| {
        let l = verdict::limit(limit);
        [l.name, l.limit, l.value, l.unit, if l.met { words.say("met") } else { words.say("not met") }]
    };
    let rows: Vec<_> = limits.into_iter().map(row).collect();
    let titles = ["limit", "#allowed", "#reached", "unit", "verdict"];
    let blocks = if rows.is_empty() { vec![] } else { vec![Block::table(words, &titles, rows)] };
    Section::of("limits", words.say("Limits"), blocks)
}

/// Every warning and error with its place and remedy: the first ones, and the annex of the others.
pub(super) fn messages(messages: &[&Message], words: &Words) -> (Option<Section>, Option<Section>) {
    let (shown, more) = messages.split_at(messages.len().min(SHOWN));
    let mut blocks = told(shown, words);
    if !more.is_empty() {
        blocks.push(Block::text(words.fill("{0} more are in the annex.", &[&more.len()])));
    } else if shown.is_empty() {
        blocks.push(Block::text(words.say("None.")));
    }
    let annex = Section::of("more-messages", words.say("More warnings and remarks"), told(more, words));
    (Section::of("messages", words.say("Warnings and remarks"), blocks), annex)
}

fn told(messages: &[&Message], words: &Words) -> Vec<Block> {
    let block = |m: &&Message| {
        let class = if m.severity == Severity::Error { "error" } else { "warning" };
        let place = m.place.as_ref().map(|p| {
            let line = p.line.map(|line| format!(", {}", words.fill("line {0}", &[&line]))).unwrap_or_default();
            let text = p.text.as_ref().map(|text| format!(": {}", one_line(text))).unwrap_or_default();
            format!("{}{line}{text}", one_line(&p.file))
        });
        let expected = m.expected.as_ref().map(|text| format!("{} {text}", words.say("expected:")));
        let hint = m.hint.as_ref().map(|text| format!("{} {text}", words.say("hint:")));
        let severity = words.fill("{0}:", &[&words.say(class)]);
        let lines = [Some(format!("{severity} {}", m.what)), place, expected, hint];
        Block::Message { class, lines: lines.into_iter().flatten().collect() }
    };
    messages.iter().map(block).collect()
}

/// Files that were read, and the checksums of all that the numbers come from.
pub(super) fn inputs(import: &ImportDocument, inputs: &BTreeMap<String, String>, words: &Words) -> Option<Section> {
    let read = import.sources.iter().map(|s| {
        let (bytes, rows, refused) = (s.bytes.to_string(), s.rows_read.to_string(), s.refused.len().to_string());
        [one_line(&s.file), words.say(&one_line(&s.kind)), bytes, s.dialect.clone(), rows, refused]
    });
    let blocks = vec![
        Block::table(words, &["file", "kind", "#bytes", "read as", "#rows", "#refused"], read),
        checksums(inputs, words),
    ];
    Section::of("inputs", words.say("Inputs"), blocks)
}

/// Checksums of all that the numbers come from.
pub(super) fn checksums(inputs: &BTreeMap<String, String>, words: &Words) -> Block {
    let rows = inputs.iter().map(|(file, sha256)| [one_line(file), sha256.clone()]);
    Block::table(words, &["input", "SHA-256"], rows)
}
