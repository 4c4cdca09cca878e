//! All problems of a TOML file at once: an entry that does not fit is reported and removed, a missing one is reported and
//! filled in, and the rest is read again.

use etalon_base::message::{Message, Place, Problems, Result, nearest};
use etalon_robots::MODELS;
use serde::de::DeserializeOwned;
use std::ops::Range;
use std::sync::LazyLock;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer, Error};

/// What is left of a file.
pub(super) struct Recovered<T> {
    /// The value; none where the file is not TOML.
    pub value: Option<T>,
    /// What does not fit.
    pub problems: Problems,
    /// Where that is in the file.
    pub unread: UnreadKeys,
}

/// Entries of a TOML file that did not read, each by the keys that lead to it; a number counts tables of an array. Their
/// absence from the value means nothing.
#[derive(Clone, Debug, Default)]
pub struct UnreadKeys(Vec<Vec<String>>);

impl UnreadKeys {
    /// Adds an entry.
    pub(super) fn add(&mut self, path: Vec<String>) {
        self.0.push(path);
    }

    /// Whether exactly this entry is among them.
    pub(super) fn contains(&self, path: &[String]) -> bool {
        self.0.iter().any(|keys| keys == path)
    }

    /// Whether something at, above or below these keys did not read.
    pub fn affects(&self, path: &[&str]) -> bool {
        self.0.iter().any(|keys| meet(keys, path))
    }

    /// The same, except for keys of this name.
    pub fn affects_except(&self, path: &[&str], key: &str) -> bool {
        self.0.iter().any(|keys| meet(keys, path) && keys.last().is_none_or(|last| last != key))
    }

    /// Whether the entry itself, or an element of it, did not read, or one of this name in any table.
    pub fn affects_entry(&self, key: &str) -> bool {
        let is = |name: Option<&String>| name.is_some_and(|name| name == key);
        self.0.iter().any(|keys| (keys.len() <= 2 && is(keys.first())) || is(keys.last()))
    }

    /// Whether everything read.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// Whether one path leads to the other.
fn meet(keys: &[String], path: &[&str]) -> bool {
    keys.iter().zip(path).all(|(a, b)| a == b)
}

/// Reads `text` as a `T`, or reports everything in it that does not fit.
pub fn parse<T: DeserializeOwned>(file: &str, text: &str) -> Result<T> {
    let Recovered { value, problems, .. } = recover(file, text);
    value.filter(|_| problems.0.is_empty()).ok_or(problems)
}

/// The same, with the value that is left.
pub(super) fn recover<T: DeserializeOwned>(file: &str, text: &str) -> Recovered<T> {
    recover_with(file, text, &[], |root| T::deserialize(Deserializer::from(root)))
}

/// The same of what `read` makes of the file, where serde cannot name all keys at its top: `top` does.
pub(super) fn recover_with<T>(
    file: &str,
    text: &str,
    top: &[&str],
    read: fn(Spanned<DeTable<'_>>) -> std::result::Result<T, Error>,
) -> Recovered<T> {
    let (mut root, errors) = DeTable::parse_recoverable(text);
    let mut unread = UnreadKeys::default();
    if !errors.is_empty() {
        return Recovered { value: None, problems: syntax(file, text, &errors), unread };
    }
    let mut odd = Vec::new();
    root.get_ref().values().for_each(|value| not_finite(value, &mut odd));
    let mut problems = Problems::default();
    problems.0.extend(odd.into_iter().map(|span| {
        let what = format!("`{}` is not a measured value", text.get(span.clone()).unwrap_or(""));
        Message::error(what).at(Place::span(file, text, span)).expected("a finite number")
    }));
    let mut unknown: Vec<Unknown> = Vec::new();
    let mut filled: Vec<Placeholder> = Vec::new();
    let mut meant = Vec::new();
    let value = loop {
        let error = match read(root.clone()) {
            Ok(value) => break Some(value),
            Err(error) => error,
        };
        let span = error.span().unwrap_or(0..0);
        let placeholder = if let Some(key) = quoted(&error, "missing field `") {
            let section = table_at(root.get_ref(), &span).unwrap_or_default();
            let path = [&section[..], std::slice::from_ref(&key)].concat();
            if filled.iter().any(|p| p.path == path) {
                break None;
            }
            // what was removed, or is in a table that is filled in itself, is reported already
            if !unread.contains(&path) && span.start <= text.len() {
                problems.0.push(missing(file, text, &span, &key, &section));
            }
            unread.add(path.clone());
            let at = text.len() + 1 + 2 * filled.len();
            filled.push(Placeholder { path, span: at..at + 1, tries: TRIES.iter() });
            filled.last_mut()
        } else if span.start <= text.len() {
            let Some(path) = remove(root.get_mut(), &span) else {
                problems.0.push(wrong(file, text, &error));
                break None;
            };
            match Unknown::of(&error, &path, span, top) {
                Some(key) => {
                    meant.extend(key.meant());
                    unknown.push(key);
                }
                None => problems.0.push(wrong(file, text, &error)),
            }
            unread.add(path);
            continue;
        } else {
            filled.iter_mut().find(|p| p.span == span)
        };
        if placeholder.and_then(|p| p.insert(root.get_mut())).is_none() {
            break None;
        }
    };
    meant.into_iter().for_each(|path| unread.add(path));
    if !unknown.is_empty() {
        let top = top.iter().map(|key| (*key).to_owned()).chain(top_level(read)).collect::<Vec<_>>();
        problems.0.extend(unknown_keys(file, text, &top, unknown));
    }
    problems.0.sort_by_key(|m| m.place.as_ref().and_then(|p| p.line));
    Recovered { value, problems, unread }
}

/// Values to fill in for what is missing, of every kind and of every choice that has no default: one of them fits.
static TRIES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let choices = ["mm", "polyworks", "row", MODELS[0].name, "blank"].map(|name| format!("\"{name}\""));
    ["\"\"", "1", "[]", "{}"].map(str::to_owned).into_iter().chain(choices).collect()
});

/// Stands for an entry that is missing, so that the rest can be read.
struct Placeholder {
    path: Vec<String>,
    /// Behind the end of the text.
    span: Range<usize>,
    tries: std::slice::Iter<'static, String>,
}

impl Placeholder {
    /// Puts the next value to try in its place, if there is one.
    fn insert(&mut self, root: &mut DeTable) -> Option<()> {
        let value = DeValue::parse(self.tries.next()?).ok()?.into_inner();
        let (key, section) = self.path.split_last()?;
        let mut table = root;
        let mut section = section.iter();
        while let Some(key) = section.next() {
            table = match table.get_mut(key.as_str())?.get_mut() {
                DeValue::Table(table) => table,
                DeValue::Array(array) => {
                    let index = section.next()?.parse::<usize>().ok()?;
                    match array.get_mut(index)?.get_mut() {
                        DeValue::Table(table) => table,
                        _ => return None,
                    }
                }
                _ => return None,
            };
        }
        table.insert(Spanned::new(0..0, key.clone().into()), Spanned::new(self.span.clone(), value));
        Some(())
    }
}

/// The keys that lead to the table at `span`; those of the file are none.
fn table_at(table: &DeTable, span: &Range<usize>) -> Option<Vec<String>> {
    table.iter().find_map(|(key, value)| {
        let mut path = within(value, span)?;
        path.insert(0, key.get_ref().to_string());
        Some(path)
    })
}

fn within(value: &Spanned<DeValue>, span: &Range<usize>) -> Option<Vec<String>> {
    match value.get_ref() {
        DeValue::Table(table) => table_at(table, span).or_else(|| (value.span() == *span).then(Vec::new)),
        DeValue::Array(array) => array.iter().enumerate().find_map(|(i, value)| {
            let mut path = within(value, span)?;
            path.insert(0, i.to_string());
            Some(path)
        }),
        _ => None,
    }
}

/// Where `value` holds a number that is not finite: TOML has `nan` and `inf`, a measurement does not.
fn not_finite(value: &Spanned<DeValue>, odd: &mut Vec<Range<usize>>) {
    match value.get_ref() {
        DeValue::Float(number) if number.as_str().contains(['n', 'i']) => odd.push(value.span()),
        DeValue::Array(array) => array.iter().for_each(|v| not_finite(v, odd)),
        DeValue::Table(table) => table.values().for_each(|v| not_finite(v, odd)),
        _ => {}
    }
}

/// The span of the value of a key, given by the keys that lead to it; a number among them counts tables of an array.
pub(super) fn find(text: &str, path: &[&str]) -> Option<Range<usize>> {
    Stated::of(text).find(path)
}

/// What a text states, for several keys to be found in it.
pub(super) struct Stated<'t>(Spanned<DeTable<'t>>);

impl<'t> Stated<'t> {
    pub fn of(text: &'t str) -> Self {
        Self(DeTable::parse_recoverable(text).0)
    }

    /// [`find`]
    pub fn find(&self, path: &[&str]) -> Option<Range<usize>> {
        let (first, rest) = path.split_first()?;
        let mut value = self.0.get_ref().get(*first)?;
        for key in rest {
            value = match value.get_ref() {
                DeValue::Table(table) => table.get(*key)?,
                DeValue::Array(array) => array.get(key.parse::<usize>().ok()?)?,
                _ => return None,
            };
        }
        Some(value.span())
    }
}

/// Removes the innermost entry whose key or value covers `span`; gives the keys that lead to it.
fn remove(table: &mut DeTable, span: &Range<usize>) -> Option<Vec<String>> {
    for (key, value) in table.iter_mut() {
        if let Some(mut path) = remove_within(value, span) {
            path.insert(0, key.get_ref().to_string());
            return Some(path);
        }
    }
    let key = table
        .iter()
        .find(|(key, value)| covers(&key.span(), span) || reaches(value, span))
        .map(|(k, _)| k.get_ref().to_string())?;
    table.remove(key.as_str()).map(|_| vec![key])
}

fn remove_within(value: &mut Spanned<DeValue>, span: &Range<usize>) -> Option<Vec<String>> {
    match value.get_mut() {
        DeValue::Table(table) => remove(table, span),
        DeValue::Array(array) => {
            for (i, value) in array.iter_mut().enumerate() {
                if let Some(mut path) = remove_within(value, span) {
                    path.insert(0, i.to_string());
                    return Some(path);
                }
            }
            let element = array.iter().position(|v| covers(&v.span(), span) && v.get_ref().is_table())?;
            let rest = array.iter().enumerate().filter(|(i, _)| *i != element).map(|(_, v)| v.clone());
            *array = rest.collect();
            Some(vec![element.to_string()])
        }
        _ => None,
    }
}

/// Whether `value`, or an element of it, covers `span`.
fn reaches(value: &Spanned<DeValue>, span: &Range<usize>) -> bool {
    covers(&value.span(), span)
        || matches!(value.get_ref(), DeValue::Array(array) if array.iter().any(|v| covers(&v.span(), span)))
}

fn covers(outer: &Range<usize>, span: &Range<usize>) -> bool {
    outer.start <= span.start && span.end <= outer.end && !span.is_empty()
}

/// The text between `start` and the next backtick in the message.
fn quoted(error: &Error, start: &str) -> Option<String> {
    let (_, rest) = error.message().split_once(start)?;
    Some(rest.split('`').next().unwrap_or("").to_owned())
}

/// That a key of a section is missing.
pub(super) fn missing(file: &str, text: &str, span: &Range<usize>, key: &str, section: &[String]) -> Message {
    let name = section.iter().rfind(|key| key.parse::<usize>().is_err());
    let of = name.map(|s| format!(" in `{s}`")).unwrap_or_default();
    let place = if section.is_empty() { Place::file(file) } else { Place::span(file, text, span.clone()) };
    let message = Message::error(format!("the key `{key}` is missing{of}")).at(place);
    let hint = match (key, section) {
        ("unit", _) => "state the length unit of the file: \"mm\", \"m\", \"um\" or \"inch\"; it is never guessed",
        ("expanded_uncertainty_um" | "coverage_factor" | "instrument", _) => {
            "[instrument] states name, expanded_uncertainty_um and coverage_factor: take them from its calibration certificate"
        }
        ("file", _) => "name the file, in the folder of the campaign",
        (_, []) => "`etalon init FOLDER` writes a campaign with all keys to copy from",
        _ => return message,
    };
    message.hint(hint)
}

/// A TOML error in our words.
fn wrong(file: &str, text: &str, error: &Error) -> Message {
    let what = error.message().lines().collect::<Vec<_>>().join(", ");
    let place = error.span().map_or_else(|| Place::file(file), |span| Place::span(file, text, span));
    match what.split_once(", expected ") {
        Some((what, expected)) => {
            let words = match expected {
                "f64" => "a number",
                "i64" | "u64" | "usize" => "a whole number",
                other => other,
            };
            Message::error(what).at(place).expected(words)
        }
        None => Message::error(what).at(place),
    }
}

/// Errors of a file that is not TOML. Duplicate keys are one error: mostly, the head of a table is missing.
fn syntax(file: &str, text: &str, errors: &[Error]) -> Problems {
    let (twice, others): (Vec<&Error>, Vec<&Error>) =
        errors.iter().partition(|e| e.message().contains("duplicate key"));
    let mut problems: Vec<Message> = others.into_iter().map(|e| wrong(file, text, e)).collect();
    if let Some(first) = twice.first() {
        let hint = "a table among several begins with its head in double brackets, like `[[joint]]`: is one missing before it?";
        let more = if twice.len() > 1 { format!(", and {} keys after it", twice.len() - 1) } else { String::new() };
        let message = wrong(file, text, first).hint(hint);
        problems.push(Message { what: format!("this table has the key twice{more}"), ..message });
    }
    problems.sort_by_key(|m| m.place.as_ref().and_then(|p| p.line));
    Problems(problems)
}

/// A key that a section does not have.
struct Unknown {
    key: String,
    section: Vec<String>,
    span: Range<usize>,
    known: Vec<String>,
}

impl Unknown {
    /// The unknown key at `path` that the error is about, if it is.
    fn of(error: &Error, path: &[String], span: Range<usize>, top: &[&str]) -> Option<Self> {
        let key = quoted(error, "unknown field `")?;
        let (_, section) = path.split_last()?;
        let top = top.iter().filter(|_| section.is_empty()).map(|key| (*key).to_owned());
        Some(Self { key, section: section.to_vec(), span, known: top.chain(known(error)).collect() })
    }

    /// The entry that the key may be meant as.
    fn meant(&self) -> Option<Vec<String>> {
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
fn top_level<T>(read: fn(Spanned<DeTable<'_>>) -> std::result::Result<T, Error>) -> Vec<String> {
    let mut odd = DeTable::new();
    odd.insert(Spanned::new(0..0, "?".into()), Spanned::new(0..0, DeValue::Boolean(true)));
    read(Spanned::new(0..0, odd)).err().map(|e| known(&e)).unwrap_or_default()
}

/// What to do about keys that were read once, or that belong elsewhere.
const REMEDIES: [(&str, &str); 2] = [
    (
        "base_turn_y_deg",
        "delete it: base_rx, base_ry and base_rz are a rotation vector, and no orientation of the base is singular",
    ),
    (
        "station",
        "stations of an instrument are a column `station` of a table of observations: [observations] instead of exports and log",
    ),
];

/// One error for each unknown key; for several of one section that are like no key of it, one error in all.
fn unknown_keys(file: &str, text: &str, top: &[String], mut unknown: Vec<Unknown>) -> Vec<Message> {
    unknown.sort_by_key(|key| key.span.start);
    let groups = unknown.chunk_by(|a, b| a.section == b.section && a.stray() && b.stray());
    let message = |group: &[Unknown]| {
        let first = group.first()?;
        let names: Vec<String> = group.iter().map(|key| format!("`{}`", key.key)).collect();
        let s = if names.len() > 1 { "s" } else { "" };
        let message = Message::error(format!("unknown key{s} {}", names.join(", ")));
        let message = message.at(Place::span(file, text, first.span.clone()));
        Some(if first.stray() && !first.section.is_empty() && top.contains(&first.key) {
            message.hint(format!("`{}` belongs at the top, before the first section", first.key))
        } else if names.len() > 1 {
            message.hint("is the head of their table missing, like `[section]` or `[[joint]]`?")
        } else if let Some((_, remedy)) = REMEDIES.iter().find(|(key, _)| *key == first.key) {
            message.hint(*remedy)
        } else {
            message.hint_names(&first.key, first.known.iter().map(String::as_str))
        })
    };
    groups.filter_map(message).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code)]
    struct Inner {
        length: f64,
        unit: String,
    }

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code)]
    struct Outer {
        name: String,
        part: Inner,
        #[serde(default)]
        list: Vec<Inner>,
    }

    #[test]
    fn all_problems_at_once_with_their_places() {
        let text = "nmae = \"x\"\n[part]\nlength = \"long\"\nunit = 3\ncolour = 1\n[[list]]\nlength = 1.0\n";
        let problems = parse::<Outer>("f.toml", text).unwrap_err();
        let said: Vec<String> =
            problems.0.iter().map(|m| format!("{} {:?}", m.what, m.place.as_ref().and_then(|p| p.line))).collect();
        for part in [
            "unknown key `nmae` Some(1)",
            "Some(3)",
            "Some(4)",
            "unknown key `colour` Some(5)",
            "`unit` is missing",
            "`name` is missing",
        ] {
            assert!(said.iter().any(|s| s.contains(part)), "{part}: {said:?}");
        }
        assert_eq!(said.len(), 6, "{said:?}");
    }

    #[test]
    fn syntax_errors_have_places() {
        let problems = parse::<Outer>("f.toml", "name = \n[part\nlength 3\n").unwrap_err();
        assert!(!problems.0.is_empty() && problems.0.iter().all(|m| m.place.is_some()));
    }
}
