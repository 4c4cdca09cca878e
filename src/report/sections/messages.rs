//! Warnings and errors, with place and remedy.

use crate::model::{Block, Columns, Section, Table, Text};
use crate::words::{Words, tr};
use etalon_base::catalogue::{Entry, Phrase, entries};
use etalon_base::message::{Message, Problems, Rank, Severity, one_line};
use etalon_base::phrase;
use etalon_documents::Results;
use std::collections::BTreeMap;

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let elsewhere = |m: &&Message| {
        m.rank == Rank::Routine
            && results
                .import
                .messages
                .iter()
                .chain(results.identified.iter().flat_map(|i| &i.parameters.messages))
                .any(|o| o == *m)
    };
    let (routine, here): (Vec<&Message>, Vec<&Message>) = results.messages().partition(elsewhere);
    let mut section = section_beside_routine(&here, routine.len(), words);
    section.data = vec![table(&results.messages().collect::<Vec<_>>(), words)];
    Some(section)
}

/// Returns the section of these messages: messages that need action first, with similar rows
/// merged.
pub(crate) fn section_from_messages(messages: &[&Message], words: &Words) -> Section {
    section_beside_routine(messages, 0, words)
}

/// Returns the section of these messages, where so many routine remarks are elsewhere.
pub(super) fn section_beside_routine(messages: &[&Message], routine_elsewhere: usize, words: &Words) -> Section {
    let mut section = Section::new("messages", tr!(words, "warnings-and-remarks"));
    if messages.is_empty() {
        section.push(Block::text(match routine_elsewhere {
            0 => tr!(words, "no-messages"),
            count => tr!(words, "no-messages-but-routine", count),
        }));
    }
    let grouped = grouped(messages);
    for (rank, title) in [(Rank::Decide, tr!(words, "decide-now")), (Rank::Know, tr!(words, "should-know"))] {
        let mut of_rank = grouped.0.iter().filter(|m| m.rank == rank).peekable();
        if of_rank.peek().is_some() {
            section.push(Block::heading(title));
        }
        of_rank.for_each(|m| section.push(notice(m, words)));
    }
    section.push(routine(&grouped.0, words));
    section.push(Block::Table(table(messages, words)));
    section
}

/// Returns the section of these messages without remedies, where so many routine remarks are
/// elsewhere: a certificate contains no opinions (ISO/IEC 17025:2017, 7.8.7).
pub(super) fn facts(messages: &[&Message], routine_elsewhere: usize, words: &Words) -> Section {
    let mut section = section_beside_routine(&[], routine_elsewhere, words);
    if messages.is_empty() {
        return section;
    }
    section.blocks.clear();
    let known: Explained = entries().into_iter().filter(Entry::is_message).map(|entry| (entry.id, entry)).collect();
    grouped(messages).0.iter().for_each(|m| section.push(fact(m, &known, words)));
    section
}

/// Explained messages by their ids.
type Explained = BTreeMap<&'static str, Entry>;

/// Messages with similar rows merged.
fn grouped(messages: &[&Message]) -> Problems {
    Problems(messages.iter().map(|m| (*m).clone()).collect()).grouped()
}

/// Routine messages, folded.
pub(super) fn routine(messages: &[Message], words: &Words) -> Block {
    let blocks = messages.iter().filter(|m| m.rank == Rank::Routine).map(|m| notice(m, words)).collect();
    Block::Aside { title: tr!(words, "routine-remarks"), blocks }
}

/// Messages for the workbook.
fn table(messages: &[&Message], words: &Words) -> Table {
    let place = |m: &Message| m.place.as_deref().cloned().unwrap_or_default();
    let columns = Columns::<Message>::new()
        .sheet(phrase!("head-severity"), "", class)
        .sheet(phrase!("rank"), "", |m| format!("{:?}", m.rank).to_lowercase())
        .sheet(phrase!("head-what"), "", |m| m.what.as_str())
        .sheet(phrase!("file"), "", move |m| place(m).file)
        .sheet(phrase!("line"), "", move |m| place(m).line)
        .sheet(phrase!("head-column"), "", move |m| place(m).column)
        .sheet(phrase!("text"), "", move |m| place(m).text)
        .sheet(phrase!("expected"), "", |m| m.expected.as_deref())
        .sheet(phrase!("head-hint"), "", |m| m.hint.as_deref());
    Table::new(words, messages.iter().copied(), columns).on(phrase!("sheet-messages"))
}

fn class(message: &Message) -> &'static str {
    if message.severity == Severity::Error { "error" } else { "warning" }
}

fn severity_name(message: &Message) -> Phrase {
    if message.severity == Severity::Error { phrase!("severity-error") } else { phrase!("severity-warning") }
}

/// A message with its place, what was expected there, and the remedy.
fn notice(m: &Message, words: &Words) -> Block {
    let lines = statement(m, words).into_iter().chain(remedy(m, words)).collect();
    Block::Notice { class: class(m), id: m.id.to_string(), lines }
}

/// A message with its consequence, and without remedy.
fn fact(m: &Message, known: &Explained, words: &Words) -> Block {
    let entry = known.get(&*m.id);
    let consequence = entry.map(|entry| Text::english(&entry.reason)).filter(|text| !text.plain().is_empty());
    let lines = statement(m, words).into_iter().chain(consequence).collect();
    Block::Notice { class: class(m), id: m.id.to_string(), lines }
}

/// Text of a message, marked if the catalogue has only the English one.
fn text(m: &Message, text: &str) -> Text {
    let english = m.texts("en");
    let all = [Some(english.what), english.expected, english.hint];
    match all.iter().flatten().any(|english| english == text) {
        true => Text::english(text),
        false => Text::from(text.to_owned()),
    }
}

/// Severity, sentence and place of a message.
fn statement(m: &Message, words: &Words) -> Vec<Text> {
    let severity = tr!(words, "with-colon", label = words.tr(&severity_name(m)));
    let mut first = Text::from(severity + " ").and(text(m, &m.texts(words.code()).what));
    if !m.id.is_empty() {
        first = first.and(" ").and(Text::code(&m.id));
    }
    let place = m.place.as_ref().map(|p| {
        let line = p.line.map(|line| format!(", {}", tr!(words, "line-number", line))).unwrap_or_default();
        let text = p.text.as_ref().map(|text| Text::from(": ").and(Text::code(&one_line(text))));
        Text::name(&p.file).and(line).and(text.unwrap_or_default())
    });
    std::iter::once(first).chain(place).collect()
}

/// Expectation and remedy of a message.
fn remedy(m: &Message, words: &Words) -> Vec<Text> {
    let texts = m.texts(words.code());
    let remark = |label: String, said: &String| Text::from(label + " ").and(text(m, said));
    let expected = texts.expected.as_ref().map(|text| remark(tr!(words, "expected-label"), text));
    let hint = texts.hint.as_ref().map(|text| remark(tr!(words, "hint-label"), text));
    expected.into_iter().chain(hint).collect()
}
