//! Keys that nobody knows: what they may be meant as, and where they may belong.

use super::toml_problems::quoted;
use crate::base::message::{Message, Place, nearest};
use serde::de::DeserializeOwned;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer, Error};

/// A key that a section does not have.
pub(super) struct Unknown {
    key: String,
    section: Vec<String>,
    span: Range<usize>,
    known: Vec<String>,
}

impl Unknown {
    /// The unknown key at `path` that the error is about, if it is.
    pub fn of(error: &Error, path: &[String], span: Range<usize>) -> Option<Self> {
        let key = quoted(error, "unknown field `")?;
        let (_, section) = path.split_last()?;
        Some(Self { key, section: section.to_vec(), span, known: known(error) })
    }

    /// The entry that the key may be meant as.
    pub fn meant(&self) -> Option<Vec<String>> {
        let name = nearest(&self.key, self.known.iter().map(String::as_str))?;
        Some([&self.section[..], &[name.to_owned()]].concat())
    }

    /// Whether the key is like none of those that are known here.
    fn stray(&self) -> bool {
        self.meant().is_none()
    }
}

/// Names between backticks after "expected".
fn known(error: &Error) -> Vec<String> {
    let expected = error.message().split("expected").nth(1).unwrap_or("");
    expected.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// Keys of the top level of a `T`.
fn top_level<T: DeserializeOwned>() -> Vec<String> {
    let mut odd = DeTable::new();
    odd.insert(Spanned::new(0..0, "?".into()), Spanned::new(0..0, DeValue::Boolean(true)));
    T::deserialize(Deserializer::from(Spanned::new(0..0, odd))).err().map(|e| known(&e)).unwrap_or_default()
}

/// One error for each unknown key; for several of one section that are like no key of it, one error in all.
pub(super) fn messages<T: DeserializeOwned>(file: &str, text: &str, mut unknown: Vec<Unknown>) -> Vec<Message> {
    let top = top_level::<T>();
    unknown.sort_by_key(|key| key.span.start);
    let groups = unknown.chunk_by(|a, b| a.section == b.section && a.stray() && b.stray());
    let message = |group: &[Unknown]| {
        let first = group.first()?;
        let names: Vec<String> = group.iter().map(|key| format!("`{}`", key.key)).collect();
        let s = if names.len() > 1 { "s" } else { "" };
        let message = Message::error(format!("unknown key{s} {}", names.join(", ")));
        let message = message.at(Place::span(file, text, first.span.clone()));
        Some(if first.stray() && !first.section.is_empty() && top.contains(&first.key) {
            message.hint(format!("`{}` stands at the top, before the first section", first.key))
        } else if names.len() > 1 {
            message.hint("is the head of their table missing, like `[section]` or `[[joint]]`?")
        } else {
            message.hint_names(&first.key, first.known.iter().map(String::as_str))
        })
    };
    groups.filter_map(message).collect()
}
