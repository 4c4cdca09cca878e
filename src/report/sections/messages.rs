//! Every warning and error, with its place and its remedy.

use crate::base::message::{Message, Severity, one_line};
use crate::report::Report;
use crate::report::model::{Block, Columns, Section, Table, Text};
use crate::report::words::Words;

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    Some(of(&report.messages(), words))
}

/// The section of these messages.
pub(in crate::report) fn of(messages: &[&Message], words: &Words) -> Section {
    let mut section = Section::new("messages", words.say("Warnings and remarks"));
    if messages.is_empty() {
        section.push(Block::text(words.say("None.")));
    }
    for m in messages {
        section.push(notice(m, words));
    }
    let place = |m: &Message| m.place.as_deref().cloned().unwrap_or_default();
    let columns = Columns::<Message>::new()
        .sheet("severity", "", class)
        .sheet("what", "", |m| m.what.as_str())
        .sheet("file", "", move |m| place(m).file)
        .sheet("line", "", move |m| place(m).line)
        .sheet("column", "", move |m| place(m).column)
        .sheet("text", "", move |m| place(m).text)
        .sheet("expected", "", |m| m.expected.as_deref())
        .sheet("hint", "", |m| m.hint.as_deref());
    section.push(Block::Table(Table::of(words, messages.iter().copied(), columns).on("Messages")));
    section
}

fn class(message: &Message) -> &'static str {
    if message.severity == Severity::Error { "error" } else { "warning" }
}

fn notice(m: &Message, words: &Words) -> Block {
    let severity = words.fill("{0}:", &[&words.say(class(m))]);
    let mut lines = vec![Text::from(severity + " ").and(Text::english(&m.what))];
    lines.extend(m.place.as_ref().map(|p| {
        let line = p.line.map(|line| format!(", {}", words.fill("line {0}", &[&line]))).unwrap_or_default();
        let text = p.text.as_ref().map(|text| Text::from(": ").and(Text::code(&one_line(text))));
        Text::name(&p.file).and(line).and(text.unwrap_or_default())
    }));
    let remark = |what: String, said: &String| Text::from(what + " ").and(Text::english(said));
    lines.extend(m.expected.as_ref().map(|text| remark(words.say("expected:"), text)));
    lines.extend(m.hint.as_ref().map(|text| remark(words.say("hint:"), text)));
    Block::Notice { class: class(m), lines }
}
