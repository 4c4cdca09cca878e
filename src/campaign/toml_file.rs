//! Reads a TOML file with all its problems at once, by JSON Schema: an entry that does not fit is
//! reported and removed, a missing entry is reported and replaced, and the rest is read.

use etalon_base::catalogue::{Argument, IntoArgument, Phrase};
use etalon_base::message::{Message, Place, Problems, Result, nearest};
use etalon_base::{error, phrase};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer, Error};

/// Result of reading a file with problems.
pub(super) struct Recovered<T> {
    /// Value; `None` if the file is not TOML.
    pub value: Option<T>,
    /// Problems of the file.
    pub problems: Problems,
    /// Entries with problems.
    pub unread: UnreadKeys,
}

/// Entries of a TOML file that could not be read, each by the keys that lead to it; numbers count
/// tables of an array. Their absence from the value is meaningless.
#[derive(Clone, Debug, Default)]
pub struct UnreadKeys(Vec<Vec<String>>);

impl UnreadKeys {
    /// Adds an entry.
    pub(super) fn add(&mut self, path: Vec<String>) {
        self.0.push(path);
    }

    /// `true` if exactly this entry is included.
    pub(super) fn contains(&self, path: &[String]) -> bool {
        self.0.iter().any(|keys| keys == path)
    }

    /// `true` if an entry at, above or below these keys could not be read.
    pub fn affects(&self, path: &[&str]) -> bool {
        self.0.iter().any(|keys| paths_overlap(keys, path))
    }

    /// Like [`Self::affects`], except for keys with the name `key`.
    pub fn affects_except(&self, path: &[&str], key: &str) -> bool {
        self.0.iter().any(|keys| paths_overlap(keys, path) && keys.last().is_none_or(|last| last != key))
    }

    /// `true` if an entry of this name, or an element of it, could not be read in any table.
    pub fn affects_entry(&self, key: &str) -> bool {
        let is = |name: Option<&String>| name.is_some_and(|name| name == key);
        self.0.iter().any(|keys| (keys.len() <= 2 && is(keys.first())) || is(keys.last()))
    }

    /// `true` if everything could be read.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// `true` if one path is the beginning of the other.
fn paths_overlap(keys: &[String], path: &[&str]) -> bool {
    keys.iter().zip(path).all(|(a, b)| a == b)
}

/// Reads `text` as a `T` with this schema, or reports all entries that do not fit.
pub fn parse<T: DeserializeOwned>(file: &str, text: &str, schema: &Value) -> Result<T> {
    let Recovered { value, problems, .. } = recover(file, text, schema);
    value.filter(|_| problems.0.is_empty()).ok_or(problems)
}

/// Like [`parse`], but also returns the value without the entries that do not fit.
pub(super) fn recover<T: DeserializeOwned>(file: &str, text: &str, schema: &Value) -> Recovered<T> {
    recover_with(file, text, schema, |root| T::deserialize(Deserializer::from(root)))
}

/// JSON Schemas by name, for the next file of the same kind.
static KEPT: Mutex<BTreeMap<&str, Arc<Value>>> = Mutex::new(BTreeMap::new());

/// Returns the schema of this name, from `make` if it is needed for the first time.
pub(super) fn kept_schema(name: &'static str, make: impl FnOnce() -> Value) -> Arc<Value> {
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    kept.entry(name).or_insert_with(|| Arc::new(make())).clone()
}

/// Returns the schema of this name in a list of names and texts; without it, one that allows every
/// value.
pub fn schema(name: &'static str, all: &[(&str, &str)]) -> Arc<Value> {
    let text = all.iter().find(|(listed, _)| *listed == name).map(|(_, text)| *text);
    kept_schema(name, || text.and_then(|text| serde_json::from_str(text).ok()).unwrap_or(Value::Bool(true)))
}

/// Like [`recover`], with a given schema and reader.
pub(super) fn recover_with<T>(
    file: &str,
    text: &str,
    schema: &Value,
    read: fn(Spanned<DeTable<'_>>) -> std::result::Result<T, Error>,
) -> Recovered<T> {
    let (mut root, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        return Recovered { value: None, problems: syntax(file, text, &errors), unread: UnreadKeys::default() };
    }
    let mut check = Check::new(file, text, schema);
    root.get_ref().values().for_each(|value| check.finite(value));
    let value = loop {
        check.table(root.get_mut(), &(0..0), schema);
        let error = match read(root.clone()) {
            Ok(value) => break Some(value),
            Err(error) => error,
        };
        // constraints beyond the schema are checked by the type, with its own message
        let span = error.span().map(|span| cause(&root, &error, read).unwrap_or(span));
        check.problems.push(wrong(file, text, &error, span.clone()));
        match span.and_then(|span| remove(root.get_mut(), &span)) {
            Some(path) => check.unread.add(path),
            None => break None,
        }
    };
    let (problems, unread) = check.finish();
    Recovered { value, problems, unread }
}

/// Check of a file by its JSON Schema: entries that do not fit are reported and removed, missing
/// ones are reported and replaced.
struct Check<'a> {
    file: &'a str,
    text: &'a str,
    schema: &'a Value,
    /// Keys that lead to the checked value.
    path: Vec<String>,
    problems: Vec<Message>,
    unknown: Vec<Unknown>,
    unread: UnreadKeys,
}

impl<'a> Check<'a> {
    fn new(file: &'a str, text: &'a str, schema: &'a Value) -> Self {
        let (path, problems, unknown, unread) = Default::default();
        Self { file, text, schema, path, problems, unknown, unread }
    }

    fn place(&self, span: Range<usize>) -> Place {
        Place::span(self.file, self.text, span)
    }

    /// Reports non-finite numbers, which TOML allows (`nan`, `inf`), but measurements do not.
    fn finite(&mut self, value: &Spanned<DeValue>) {
        match value.get_ref() {
            DeValue::Float(number) if number.as_str().contains(['n', 'i']) => {
                let message = error!("not-a-measured-value", value = self.text.get(value.span()).unwrap_or(""));
                self.problems.push(message.at(self.place(value.span())));
            }
            DeValue::Array(array) => array.iter().for_each(|v| self.finite(v)),
            DeValue::Table(table) => table.values().for_each(|v| self.finite(v)),
            _ => {}
        }
    }

    /// Alternative schemas of a value, without `null`.
    fn alternatives(&self, schema: &'a Value) -> Vec<&'a Value> {
        let definition = schema["$ref"].as_str().and_then(|name| self.schema.pointer(name.strip_prefix('#')?));
        if let Some(definition) = definition {
            return self.alternatives(definition);
        }
        match schema.get("anyOf").or(schema.get("oneOf")).and_then(Value::as_array) {
            Some(all) => all.iter().flat_map(|s| self.alternatives(s)).collect(),
            None if schema["type"] == "null" => Vec::new(),
            None => vec![schema],
        }
    }

    /// Checks the keys of a table, and replaces missing mandatory keys.
    fn table(&mut self, table: &mut DeTable, span: &Range<usize>, schema: &'a Value) {
        let others = schema.get("additionalProperties").or(schema.get("unevaluatedProperties"));
        let others = others.unwrap_or(&Value::Bool(true));
        let mut odd = Vec::new();
        for (key, value) in table.iter_mut() {
            self.path.push(key.get_ref().to_string());
            let known = schema["properties"].get(key.get_ref().as_ref());
            let fits = match known.unwrap_or(others) {
                Value::Bool(any) => {
                    if !any {
                        self.unknown.push(Unknown::new(&self.path, key.span(), schema));
                    }
                    *any
                }
                of_value => {
                    let of_name = schema.get("propertyNames").filter(|_| known.is_none());
                    of_name.is_none_or(|names| self.choice(key.get_ref(), key.span(), names))
                        && self.value(value, of_value)
                }
            };
            if !fits {
                odd.push(key.get_ref().to_string());
                self.unread.add(self.path.clone());
            }
            self.path.pop();
        }
        odd.iter().for_each(|key| drop(table.remove(key.as_str())));
        for key in schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str) {
            if table.contains_key(key) {
                continue;
            }
            let path = [&self.path[..], &[key.to_owned()]].concat();
            // removed keys are already reported
            if !self.unread.contains(&path) {
                self.problems.push(missing(self.file, self.text, span, key, &self.path));
                self.unread.add(path);
            }
            let example = self.example(&schema["properties"][key]);
            table.insert(Spanned::new(0..0, key.to_owned().into()), Spanned::new(0..0, example));
        }
    }

    /// `true` if a value meets a schema after removal of tables that do not fit.
    fn value(&mut self, value: &mut Spanned<DeValue>, schema: &'a Value) -> bool {
        let (span, all) = (value.span(), self.alternatives(schema));
        let of_kind = all.iter().copied().find(|s| is_of_kind(s, value.get_ref()));
        match (value.get_mut(), of_kind) {
            (_, None) => return self.odd_kind(value, &all),
            (DeValue::String(text), _) => return self.choice(text, span, schema),
            (DeValue::Table(table), Some(schema)) => self.table(table, &span, schema),
            (DeValue::Array(array), Some(schema)) => {
                let (count, limit) = (array.len() as u64, |key| schema[key].as_u64());
                if limit("minItems").is_some_and(|n| count < n) || limit("maxItems").is_some_and(|n| count > n) {
                    return self.odd_kind(value, &all);
                }
                for (i, element) in array.iter_mut().enumerate() {
                    let schema = schema["prefixItems"].get(i).unwrap_or(&schema["items"]);
                    self.path.push(i.to_string());
                    let fits = schema.is_null() || self.value(element, schema);
                    self.path.pop();
                    if !fits {
                        return false;
                    }
                }
            }
            _ => {}
        }
        true
    }

    /// Reports a value of a wrong kind.
    fn odd_kind(&mut self, value: &Spanned<DeValue>, all: &[&Value]) -> bool {
        let kind = |kind: &str, length: usize| phrase!("kind-of-value", kind, length).argument();
        let found = match value.get_ref() {
            DeValue::Integer(number) => number.as_str().argument(),
            DeValue::Float(number) => number.as_str().argument(),
            DeValue::Boolean(truth) => truth.to_string().argument(),
            DeValue::String(_) => kind("text", 0),
            DeValue::Datetime(_) => kind("date", 0),
            DeValue::Array(array) => kind("list", array.len()),
            DeValue::Table(_) => kind("table", 0),
        };
        let name = self.path.iter().rfind(|key| key.parse::<usize>().is_err());
        let element = if self.path.last() == name { "no" } else { "yes" };
        let key = name.map_or("", String::as_str);
        let message = error!("value-of-other-kind", element, key, found).at(self.place(value.span()));
        let expected = joined(&all.iter().flat_map(|s| kinds(s)).collect::<Vec<_>>());
        self.problems.push(message.expected(expected));
        false
    }

    /// `true` if a schema lists the text, or lists no texts.
    fn choice(&mut self, text: &str, span: Range<usize>, schema: &'a Value) -> bool {
        let texts = self.alternatives(schema).into_iter().filter(|s| is_of_kind(s, &DeValue::String(text.into())));
        let lists: Option<Vec<Vec<&Value>>> = texts.map(listed).collect();
        let Some(known) = lists.map(|lists| lists.concat()) else { return true };
        if known.iter().any(|v| **v == text) {
            return true;
        }
        let names: Vec<&str> = known.iter().filter_map(|v| v.as_str()).collect();
        let message = error!("unknown-variant", text).at(self.place(span));
        let expected = joined(&self.alternatives(schema).into_iter().flat_map(kinds).collect::<Vec<_>>());
        let message = message.expected(expected);
        self.problems.push(match nearest(text, names.iter().copied()) {
            Some(_) => message.hint_names(text, names),
            None => message,
        });
        false
    }

    /// Value that meets a schema.
    fn example(&self, schema: &'a Value) -> DeValue<'static> {
        let all = self.alternatives(schema);
        let Some(schema) = all.first() else { return DeValue::Boolean(false) };
        let array =
            |all: Vec<DeValue<'static>>| DeValue::Array(all.into_iter().map(|v| Spanned::new(0..0, v)).collect());
        let of_json = |v: &Value| match v {
            Value::Array(all) => {
                array(all.iter().filter_map(Value::as_str).map(|v| DeValue::String(v.to_owned().into())).collect())
            }
            other => DeValue::String(other.as_str().unwrap_or_default().to_owned().into()),
        };
        match (listed(schema).and_then(|all| all.first().copied()), schema_type(schema)) {
            (Some(choice), _) => of_json(choice),
            (_, "number" | "integer") => DeValue::parse("1").map_or(DeValue::Boolean(false), Spanned::into_inner),
            (_, "boolean") => DeValue::Boolean(false),
            (_, "array") => {
                let count = schema["minItems"].as_u64().unwrap_or(0) as usize;
                let each = |i: usize| schema["prefixItems"].get(i).unwrap_or(&schema["items"]);
                array((0..count).map(|i| self.example(each(i))).collect())
            }
            (_, "object") => {
                let required = schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str);
                let entry = |key: &str| {
                    let example = Spanned::new(0..0, self.example(&schema["properties"][key]));
                    (Spanned::new(0..0, key.to_owned().into()), example)
                };
                DeValue::Table(required.map(entry).collect())
            }
            _ => DeValue::String("".into()),
        }
    }

    fn finish(mut self) -> (Problems, UnreadKeys) {
        let meant: Vec<_> = self.unknown.iter().filter_map(Unknown::meant).collect();
        meant.into_iter().for_each(|path| self.unread.add(path));
        let top = known_keys(self.schema);
        let unknown = unknown_keys(self.file, self.text, &top, std::mem::take(&mut self.unknown));
        self.problems.extend(unknown);
        self.problems.sort_by_key(|m| m.place.as_ref().and_then(|p| p.line));
        (Problems(self.problems), self.unread)
    }
}

/// Type of a schema, apart from `null`.
fn schema_type(schema: &Value) -> &str {
    match &schema["type"] {
        Value::Array(all) => all.iter().filter_map(Value::as_str).find(|t| *t != "null").unwrap_or(""),
        other => other.as_str().unwrap_or(""),
    }
}

/// Values that a schema lists, if any.
fn listed(schema: &Value) -> Option<Vec<&Value>> {
    schema.get("const").map(|v| vec![v]).or_else(|| Some(schema.get("enum")?.as_array()?.iter().collect()))
}

/// `true` if a value is of the kind that a schema requires, independent of its contents.
fn is_of_kind(schema: &Value, value: &DeValue) -> bool {
    // a schema without a type lists values of any type, or allows all values
    let lists = |is: fn(&Value) -> bool| listed(schema).is_none_or(|all| all.into_iter().any(is));
    match (value, schema_type(schema)) {
        (DeValue::Integer(number), "integer") => {
            let value = i128::from_str_radix(&number.as_str().replace('_', ""), number.radix()).ok();
            schema["minimum"].as_i64().zip(value).is_none_or(|(least, value)| value >= i128::from(least))
        }
        (DeValue::Integer(_) | DeValue::Float(_), "number") => true,
        (DeValue::Boolean(_), "boolean") | (DeValue::Table(_), "object") | (DeValue::Array(_), "array") => true,
        (DeValue::String(_), kind) => kind == "string" || kind.is_empty() && lists(Value::is_string),
        (DeValue::Array(_), "") => lists(Value::is_array),
        (_, "") => lists(|_| false),
        _ => false,
    }
}

/// Requirements of a schema in words.
fn kinds(schema: &Value) -> Vec<Argument> {
    let kind = |kind: &str, key: &str| {
        let limit = schema[key].as_u64().map_or_else(|| "none".argument(), |limit| limit.argument());
        vec![phrase!("kind-expected", kind, limit).argument()]
    };
    match (listed(schema), schema_type(schema)) {
        (Some(all), _) => {
            let shown = |v: &Value| v.as_str().map_or_else(|| v.to_string(), |v| format!("`{v}`"));
            all.into_iter().map(|v| shown(v).argument()).collect()
        }
        (_, "string") => kind("text", ""),
        (_, "number") => kind("number", ""),
        (_, "integer") => kind("whole", "minimum"),
        (_, "boolean") => ["`true`", "`false`"].map(|truth| truth.argument()).to_vec(),
        (_, "array") => kind("list", "minItems"),
        _ => kind("table", ""),
    }
}

/// Alternatives as one text.
fn joined(all: &[Argument]) -> Phrase {
    let (last, first) = all.split_last().map_or(("".argument(), all), |(last, first)| (last.clone(), first));
    let first = if first.is_empty() { "none".argument() } else { first.argument() };
    phrase!("alternatives", first, last)
}

/// Keys of a table; a schema `true` allows keys that are reported elsewhere.
fn known_keys(schema: &Value) -> Vec<String> {
    let all = schema["properties"].as_object().into_iter().flatten();
    all.filter(|(_, value)| !value.is_boolean()).map(|(key, _)| key.clone()).collect()
}

/// Span of a key's value, given by the keys that lead to it; numbers count tables of an array.
pub(super) fn find(text: &str, path: &[&str]) -> Option<Range<usize>> {
    Stated::parse(text).find(path)
}

/// Parsed text in which several keys can be found.
pub(super) struct Stated<'t>(Spanned<DeTable<'t>>);

impl<'t> Stated<'t> {
    pub fn parse(text: &'t str) -> Self {
        Self(DeTable::parse_recoverable(text).0)
    }

    /// Finds a value like [`find`].
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

/// Place of the entry that causes the error of its section. Keys that many sections share are read
/// when the section is complete; their errors have the place of the section.
fn cause<T>(
    root: &Spanned<DeTable>,
    error: &Error,
    read: fn(Spanned<DeTable<'_>>) -> std::result::Result<T, Error>,
) -> Option<Range<usize>> {
    let mut entries = Vec::new();
    add_entries(root.get_ref(), &mut Vec::new(), &error.span()?, &mut entries);
    let is_cause = |path: &[String]| {
        let mut without = root.clone();
        remove_at(without.get_mut(), path);
        match read(without) {
            Ok(_) => true,
            Err(other) => other.message() != error.message() && !other.message().starts_with("missing field"),
        }
    };
    entries.into_iter().find(|(path, _)| is_cause(path)).map(|(_, span)| span)
}

/// Adds the keys and the place of each entry of the tables at `span`.
fn add_entries(
    table: &DeTable,
    path: &mut Vec<String>,
    span: &Range<usize>,
    entries: &mut Vec<(Vec<String>, Range<usize>)>,
) {
    for (key, value) in table.iter() {
        path.push(key.get_ref().to_string());
        let tables: Vec<(Option<usize>, &Spanned<DeValue>)> = match value.get_ref() {
            DeValue::Array(array) => array.iter().enumerate().map(|(i, value)| (Some(i), value)).collect(),
            _ => vec![(None, value)],
        };
        for (i, value) in tables {
            let DeValue::Table(table) = value.get_ref() else { continue };
            path.extend(i.map(|i| i.to_string()));
            if value.span() == *span {
                let entry = |(key, value): (&Spanned<_>, &Spanned<DeValue>)| {
                    let key: &std::borrow::Cow<str> = key.get_ref();
                    ([&path[..], &[key.to_string()]].concat(), value.span())
                };
                entries.extend(table.iter().map(entry));
            }
            add_entries(table, path, span, entries);
            path.truncate(path.len() - usize::from(i.is_some()));
        }
        path.pop();
    }
}

/// Removes the entry with these keys; numbers count tables of an array.
fn remove_at(table: &mut DeTable, path: &[String]) {
    match path {
        [] => {}
        [key] => drop(table.remove(key.as_str())),
        [key, rest @ ..] => match (table.get_mut(key.as_str()).map(Spanned::get_mut), rest) {
            (Some(DeValue::Table(table)), _) => remove_at(table, rest),
            (Some(DeValue::Array(array)), [i, rest @ ..]) => {
                let element = i.parse::<usize>().ok().and_then(|i| array.get_mut(i));
                if let Some(DeValue::Table(table)) = element.map(Spanned::get_mut) {
                    remove_at(table, rest);
                }
            }
            _ => {}
        },
    }
}

/// Removes the innermost entry whose key or value covers `span`; returns the keys that lead to it.
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

/// `true` if `value`, or an element of it, covers `span`.
fn reaches(value: &Spanned<DeValue>, span: &Range<usize>) -> bool {
    covers(&value.span(), span)
        || matches!(value.get_ref(), DeValue::Array(array) if array.iter().any(|v| covers(&v.span(), span)))
}

fn covers(outer: &Range<usize>, span: &Range<usize>) -> bool {
    outer.start <= span.start && span.end <= outer.end && !span.is_empty()
}

/// Message for a missing key of a section.
pub(super) fn missing(file: &str, text: &str, span: &Range<usize>, key: &str, section: &[String]) -> Message {
    let name = section.iter().rfind(|key| key.parse::<usize>().is_err());
    let (has_section, section_name) = name.map_or(("no", ""), |name| ("yes", name.as_str()));
    let place = if section.is_empty() { Place::file(file) } else { Place::span(file, text, span.clone()) };
    let message = error!("key-missing", key, has_section, section = section_name).at(place);
    let hint = match (key, section) {
        ("unit", _) => phrase!("state-unit"),
        ("expanded_uncertainty_um" | "coverage_factor" | "instrument", _) => phrase!("state-instrument"),
        ("file", _) => phrase!("state-file"),
        (_, []) => phrase!("copy-keys"),
        _ => return message,
    };
    message.hint(hint)
}

/// Message for an error of the TOML syntax, or of a type that rejects a value.
fn wrong(file: &str, text: &str, error: &Error, span: Option<Range<usize>>) -> Message {
    let what = error.message().lines().collect::<Vec<_>>().join(", ");
    let place = span.map_or_else(|| Place::file(file), |span| Place::span(file, text, span));
    match what.split_once(", expected ") {
        Some((reason, expected)) => error!("toml-invalid", reason).at(place).expected(expected),
        None => error!("toml-invalid", reason = what).at(place),
    }
}

/// Errors of a file that is not TOML. Duplicate keys are reported once, as the header of a table is
/// usually missing.
fn syntax(file: &str, text: &str, errors: &[Error]) -> Problems {
    let (twice, others): (Vec<&Error>, Vec<&Error>) =
        errors.iter().partition(|e| e.message().contains("duplicate key"));
    let mut problems: Vec<Message> = others.into_iter().map(|e| wrong(file, text, e, e.span())).collect();
    if let Some(first) = twice.first() {
        let place = wrong(file, text, first, first.span()).place;
        problems.push(Message { place, ..error!("table-key-twice", more = twice.len() - 1) });
    }
    problems.sort_by_key(|m| m.place.as_ref().and_then(|p| p.line));
    Problems(problems)
}

/// A key that is unknown in its section.
struct Unknown {
    key: String,
    section: Vec<String>,
    span: Range<usize>,
    known: Vec<String>,
}

impl Unknown {
    /// Creates the error for the key at `path` in a table with this schema.
    fn new(path: &[String], span: Range<usize>, table: &Value) -> Self {
        let (key, section) =
            path.split_last().map_or_else(Default::default, |(key, rest)| (key.clone(), rest.to_vec()));
        Self { key, section, span, known: known_keys(table) }
    }

    /// Entry for which the key may be a misspelling.
    fn meant(&self) -> Option<Vec<String>> {
        let name = nearest(&self.key, self.known.iter().map(String::as_str))?;
        Some([&self.section[..], &[name.to_owned()]].concat())
    }

    /// `true` if the key is similar to none of the known keys.
    fn stray(&self) -> bool {
        self.meant().is_none()
    }
}

/// Keys of earlier versions and of other sections, each with a hint of its own.
const REMEDIES: [&str; 2] = ["base_turn_y_deg", "station"];

/// Errors for unknown keys; several keys of one section without similar known keys share one error.
fn unknown_keys(file: &str, text: &str, top: &[String], mut unknown: Vec<Unknown>) -> Vec<Message> {
    unknown.sort_by_key(|key| key.span.start);
    let groups = unknown.chunk_by(|a, b| a.section == b.section && a.stray() && b.stray());
    let message = |group: &[Unknown]| {
        let first = group.first()?;
        let names: Vec<String> = group.iter().map(|key| format!("`{}`", key.key)).collect();
        let message = error!("unknown-key", count = names.len(), keys = names);
        let message = message.at(Place::span(file, text, first.span.clone()));
        Some(if first.stray() && !first.section.is_empty() && top.contains(&first.key) {
            message.hint(phrase!("key-belongs-at-top", key = first.key))
        } else if names.len() > 1 {
            message.hint(phrase!("table-head-missing"))
        } else if REMEDIES.contains(&first.key.as_str()) {
            message.hint(phrase!("key-remedy", key = first.key))
        } else {
            message.hint_names(&first.key, first.known.iter().map(String::as_str))
        })
    };
    groups.filter_map(message).collect()
}

#[cfg(all(test, feature = "schemas"))]
mod tests {
    use super::*;
    use schemars::{JsonSchema, schema_for};
    use serde::Deserialize;

    #[derive(Debug, Deserialize, JsonSchema)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code)]
    struct Inner {
        length: f64,
        unit: String,
    }

    #[derive(Debug, Deserialize, JsonSchema)]
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
        let problems = parse::<Outer>("f.toml", text, schema_for!(Outer).as_value()).unwrap_err();
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

    #[derive(Debug, Deserialize, JsonSchema)]
    #[serde(rename_all = "lowercase")]
    enum Unit {
        Millimetre,
        Metre,
    }

    #[derive(Debug, Deserialize, JsonSchema)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code)]
    struct Kinds {
        unit: Unit,
        point: [f64; 3],
        date: Option<String>,
        count: usize,
        part: Inner,
    }

    #[test]
    fn a_value_that_does_not_fit_is_told_with_what_the_schema_asks_for() {
        let text = "unit = \"milimetre\"\npoint = [1, 2]\ndate = 2026-01-01\ncount = -1\n";
        let Recovered { value, problems, unread } = recover::<Kinds>("f.toml", text, schema_for!(Kinds).as_value());
        let said: Vec<String> = problems.0.iter().map(Message::to_string).collect();
        for parts in [
            ["f.toml:1", "unknown value `milimetre`", "`millimetre` or `metre`", "did you mean `millimetre`?"],
            ["f.toml:2", "`point` is a list of 2", "expected: a list of 3", "point = [1, 2]"],
            ["f.toml:3", "`date` is a date without quotation marks", "expected: a text", "date = 2026"],
            ["f.toml:4", "`count` is -1", "expected: a whole number from 0", "count = -1"],
            ["f.toml", "the key `part` is missing", "hint", ""],
        ] {
            assert!(said.iter().any(|said| parts.iter().all(|part| said.contains(part))), "{parts:?}: {said:?}");
        }
        assert_eq!(said.len(), 5, "{said:?}");
        // missing entries are replaced; a table gets all its mandatory keys
        assert!(value.is_some() && unread.affects(&["part"]) && unread.affects(&["point"]));
    }

    #[test]
    fn syntax_errors_have_places() {
        let problems = parse::<Outer>("f.toml", "name = \n[part\nlength 3\n", &Value::Bool(true)).unwrap_err();
        assert!(!problems.0.is_empty() && problems.0.iter().all(|m| m.place.is_some()));
    }
}
