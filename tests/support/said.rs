//! Messages in what a program says, by id and arguments.

use etalon::base::catalogue::{Argument, FILES, Phrase};
use etalon::base::message::{Message, Severity};
use etalon::base::{error, phrase};
use std::collections::BTreeSet;

/// A text with messages.
pub trait Says {
    /// `true` if the text has what is expected: a message by id and arguments (`[target-twice] pose=1 cycle=2`), or a text as it is.
    ///
    /// The sentence of the catalogue with these arguments stands behind `[id]: `; arguments that are not stated are free. A value may
    /// have blanks. It is a mistake of the test if the message lacks a stated argument.
    fn says(&self, expected: &str) -> bool;

    /// `true` if the text has a phrase of the catalogue by id and arguments: `fields-like like=first-row`; or the hint or expectation of a
    /// message: `target-twice.hint line=1`.
    fn has_phrase(&self, expected: &str) -> bool;
}

/// `true` if the text has a part of a message: the hint or a reason.
pub fn has(text: &str, part: &Phrase) -> bool {
    text.contains(&part.to_string())
}

impl Says for str {
    fn says(&self, expected: &str) -> bool {
        let Some((head, id, arguments)) = by_arguments(expected) else { return self.contains(expected) };
        let (head, sentences) = (format!("{head}]: "), sentences(id, arguments));
        let is_one = |text: &str| sentences.iter().any(|sentence| has_sentence(text, sentence));
        self.lines().filter_map(|line| line.split_once(&head)).any(|(_, text)| is_one(text))
    }

    fn has_phrase(&self, expected: &str) -> bool {
        let (id, arguments) = expected.split_once(' ').unwrap_or((expected, ""));
        sentences(id, arguments).iter().any(|sentence| has_sentence(self, sentence))
    }
}

/// Stands for an argument that is not stated.
const FREE: &str = "\0";

/// Head, id and arguments of `error[id] name=value`.
fn by_arguments(expected: &str) -> Option<(&str, &str, &str)> {
    let (head, arguments) = expected.split_once("] ").filter(|(_, rest)| rest.contains('='))?;
    let id = head.strip_prefix("error").or(head.strip_prefix("warning")).unwrap_or(head).strip_prefix('[')?;
    id.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-').then_some((head, id, arguments))
}

/// Name of an argument at the start of a text.
fn name(text: &str) -> &str {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').next().unwrap_or_default()
}

/// Id, and `hint` or `expected` behind its dot.
fn id_and_attribute(id: &str) -> (&str, Option<&str>) {
    id.split_once('.').map_or((id, None), |(id, attribute)| (id, Some(attribute)))
}

/// Pattern of the English sentence of a message, or of an attribute of it.
fn pattern(id: &str) -> String {
    let (id, attribute) = id_and_attribute(id);
    let start = format!("\n{id} =");
    let rest = FILES.iter().find_map(|(_, texts)| texts[0].split_once(&start)).map(|(_, rest)| rest);
    let mut lines = rest.unwrap_or_else(|| panic!("`{id}` is not in the catalogue")).lines();
    let first = lines.next().unwrap_or_default();
    let entry = [first].into_iter().chain(lines.take_while(|line| line.starts_with([' ', '}'])));
    let is_attribute = |line: &&str| line.trim_start().starts_with('.');
    let start = attribute.map(|attribute| format!(".{attribute} ="));
    let mut entry = entry.skip_while(|line| start.as_ref().is_some_and(|start| !line.trim_start().starts_with(start)));
    let first = entry.next().unwrap_or_else(|| panic!("`{id}` lacks {attribute:?}"));
    [first].into_iter().chain(entry.take_while(|line| !is_attribute(line))).collect::<Vec<_>>().join("\n")
}

/// English sentences of a message, one for each variant that the stated arguments leave open.
fn sentences(id: &str, arguments: &str) -> Vec<String> {
    let pattern = pattern(id);
    let free = pattern.split('$').skip(1).map(|rest| (name(rest).to_owned(), Argument::Text(FREE.to_owned())));
    let (id, attribute) = id_and_attribute(id);
    let mut phrase = Phrase { id: id.to_owned().into(), arguments: free.collect() };
    let mut stated: Vec<(&str, String)> = Vec::new();
    for word in arguments.split(' ').filter(|word| !word.is_empty()) {
        match (word.split_once('='), stated.last_mut()) {
            (Some((name, value)), _) => stated.push((name, value.to_owned())),
            (None, Some((_, value))) => *value += &format!(" {word}"),
            (None, None) => panic!("`{word}` is no argument of `{id}`"),
        }
    }
    let value = |text: &str| match (text.parse::<i64>(), text.parse::<f64>()) {
        (Ok(whole), _) if whole.to_string() == text => Argument::Whole(whole),
        (_, Ok(number)) if number.is_finite() && number.to_string() == text => Argument::Number(number),
        _ => Argument::Text(text.to_owned()),
    };
    for (name, text) in &stated {
        let known = phrase.arguments.insert((*name).to_owned(), value(text));
        assert!(known.is_some(), "`{id}` lacks the argument `{name}`");
    }
    let keys: Vec<&str> = pattern.split('[').skip(1).filter_map(|rest| Some(rest.split_once(']')?.0)).collect();
    let mut phrases = vec![phrase];
    let selects = |(name, rest): &(&str, &str)| {
        rest[name.len()..].trim_start().starts_with("->") && stated.iter().all(|(stated, _)| stated != name)
    };
    let open = pattern.split('$').skip(1).map(|rest| (name(rest), rest)).filter(selects);
    // an argument may choose at several places
    let selectors: BTreeSet<&str> = open.map(|(name, _)| name).collect();
    for name in selectors {
        let variants = |phrase: Phrase| {
            let of = |key: &&str| phrase.clone().with(name, &value(if *key == "one" { "1" } else { key }));
            keys.iter().map(of).chain([phrase.clone()]).collect::<Vec<_>>()
        };
        phrases = phrases.into_iter().flat_map(variants).collect();
    }
    let text = |phrase: Phrase| match attribute {
        None => phrase.text("en"),
        Some("hint") => Message::new(Severity::Error, phrase).hint.unwrap_or_default(),
        Some(_) => Message::new(Severity::Error, phrase).expected.unwrap_or_default(),
    };
    phrases.into_iter().map(text).collect()
}

/// `true` if a text has the parts between free arguments, one behind the other, the last one up to the end of a word.
fn has_sentence(text: &str, sentence: &str) -> bool {
    let parts: Vec<&str> = sentence.split(FREE).collect();
    let mut rest = text;
    parts.iter().enumerate().all(|(i, part)| {
        let ends = |end: &str| {
            let number = end.strip_prefix('.').unwrap_or(end);
            i + 1 < parts.len()
                || part.is_empty()
                || !end.starts_with(char::is_alphanumeric) && {
                    number == end || !number.starts_with(|c: char| c.is_ascii_digit())
                }
        };
        let after = rest.match_indices(part).map(|(at, _)| &rest[at + part.len()..]).find(|end| ends(end));
        rest = after.unwrap_or_default();
        after.is_some()
    })
}

#[test]
fn a_message_is_said_by_its_id_and_its_arguments() {
    let twice = phrase!("target-twice", target = "K", pose = 1, cycle = 12);
    let said = format!("warning: x\nerror[target-twice]: {twice}\n --> o.txt:1");
    for expected in
        ["[target-twice]", "[target-twice] pose=1", "error[target-twice] target=K pose=1 cycle=12", "o.txt:1"]
    {
        assert!(said.says(expected), "{expected}");
    }
    for expected in
        ["[target-twice] pose=12", "[target-twice] cycle=1", "[target-twice] target=L", "warning[target-twice] pose=1"]
    {
        assert!(!said.says(expected), "{expected}");
    }
    assert!(said.has_phrase("target-twice pose=1") && !said.has_phrase("target-twice pose=2"), "{said}");
    let hinted = error!("no-feature-fitted", kind = "plane", seen = "sphere").to_string();
    assert!(
        hinted.has_phrase("no-feature-fitted.hint seen=sphere")
            && !hinted.has_phrase("no-feature-fitted.hint seen=cone")
    );
    assert!(
        hinted.has_phrase("no-feature-fitted.expected") && hinted.has_phrase("no-feature-fitted kind=plane"),
        "{hinted}"
    );
    let missing = format!("error[key-missing]: {}", phrase!("key-missing", key = "name", has_section = "no"));
    assert!(missing.says("[key-missing] key=name") && !missing.says("[key-missing] key=nam"));
    let variant = format!("error[quote-unmatched]: {}", phrase!("quote-unmatched", fault = "behind"));
    assert!(variant.says("[quote-unmatched] fault=behind") && !variant.says("[quote-unmatched] fault=open"));
}

#[test]
#[should_panic(expected = "lacks the argument `poses`")]
fn an_argument_that_the_message_lacks_is_a_mistake_of_the_test() {
    "".says("[target-twice] poses=1");
}
