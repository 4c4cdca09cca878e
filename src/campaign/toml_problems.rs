//! All problems of a TOML file at once: every entry that does not fit is reported, removed, and the rest read again.

use crate::message::{Message, Place, Problems, Result};
use serde::de::DeserializeOwned;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer, Error};

/// Reads `text` as a `T`, or reports everything in it that does not fit. Keys of the top level that are `required` are all
/// missed at once; serde would stop at the first.
pub(super) fn parse<T: DeserializeOwned>(file: &str, text: &str, required: &[&str]) -> Result<T> {
    let (value, problems) = recover(file, text, required);
    value.filter(|_| problems.0.is_empty()).ok_or(problems)
}

/// The same, with the value that is left when everything that does not fit is taken away.
pub(super) fn recover<T: DeserializeOwned>(file: &str, text: &str, required: &[&str]) -> (Option<T>, Problems) {
    let (mut root, syntax) = DeTable::parse_recoverable(text);
    if !syntax.is_empty() {
        return (None, Problems(syntax.iter().map(|e| message(file, text, e, None)).collect()));
    }
    let mut odd = Vec::new();
    root.get_ref().values().for_each(|value| not_finite(value, &mut odd));
    let missing = required.iter().filter(|key| !root.get_ref().contains_key(**key)).copied();
    let say = |key| Message::error(format!("the key `{key}` is missing")).at(Place::file(file));
    let mut removed: Vec<String> = missing.clone().map(str::to_owned).collect();
    let mut problems = Problems(missing.map(say).collect());
    problems.0.extend(odd.into_iter().map(|span| {
        let what = format!("`{}` is no measured value", text.get(span.clone()).unwrap_or(""));
        Message::error(what).at(Place::span(file, text, span)).expected("a finite number")
    }));
    loop {
        let error = match T::deserialize(Deserializer::from(root.clone())) {
            Ok(value) => return (Some(value), problems),
            Err(error) => error,
        };
        // a key that was removed because its value is wrong is missing only because of that
        let missing = quoted(&error, "missing field `");
        let consequence = missing.as_ref().is_some_and(|m| removed.contains(m));
        let span = error.span().unwrap_or(0..0);
        let key = remove(root.get_mut(), &span);
        if !consequence {
            let section = key.as_ref().filter(|key| missing.is_some() && !key.is_empty());
            problems.0.push(message(file, text, &error, section.map(String::as_str)));
        }
        match key {
            Some(key) => removed.push(key),
            None => return (None, problems),
        }
    }
}

/// Where `value` holds a number that is not finite: TOML knows `nan` and `inf`, a measurement does not.
fn not_finite(value: &Spanned<DeValue>, odd: &mut Vec<Range<usize>>) {
    match value.get_ref() {
        DeValue::Float(number) if number.as_str().contains(['n', 'i']) => odd.push(value.span()),
        DeValue::Array(array) => array.iter().for_each(|v| not_finite(v, odd)),
        DeValue::Table(table) => table.values().for_each(|v| not_finite(v, odd)),
        _ => {}
    }
}

/// Where the value of a key stands, given by the keys that lead to it; a number among them counts tables of an array.
pub(super) fn find(text: &str, path: &[&str]) -> Option<Range<usize>> {
    let (root, _) = DeTable::parse_recoverable(text);
    let (first, rest) = path.split_first()?;
    let mut value = root.get_ref().get(*first)?;
    for key in rest {
        value = match value.get_ref() {
            DeValue::Table(table) => table.get(*key)?,
            DeValue::Array(array) => array.get(key.parse::<usize>().ok()?)?,
            _ => return None,
        };
    }
    Some(value.span())
}

/// Removes the innermost entry whose key or value covers `span`; gives its key.
fn remove(table: &mut DeTable, span: &Range<usize>) -> Option<String> {
    if let Some(key) = table.iter_mut().find_map(|(_, value)| remove_within(value, span)) {
        return Some(key);
    }
    let key = table
        .iter()
        .find(|(key, value)| covers(&key.span(), span) || reaches(value, span))
        .map(|(k, _)| k.get_ref().to_string())?;
    table.remove(key.as_str()).map(|_| key)
}

fn remove_within(value: &mut Spanned<DeValue>, span: &Range<usize>) -> Option<String> {
    match value.get_mut() {
        DeValue::Table(table) => remove(table, span),
        DeValue::Array(array) => {
            if let Some(key) = array.iter_mut().find_map(|value| remove_within(value, span)) {
                return Some(key);
            }
            let element = array.iter().position(|v| covers(&v.span(), span) && v.get_ref().is_table())?;
            let rest = array.iter().enumerate().filter(|(i, _)| *i != element).map(|(_, v)| v.clone());
            *array = rest.collect();
            Some(String::new())
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

/// A TOML error in our words.
fn message(file: &str, text: &str, error: &Error, section: Option<&str>) -> Message {
    let what = error.message().lines().collect::<Vec<_>>().join(", ");
    let place = error.span().map_or_else(|| Place::file(file), |span| Place::span(file, text, span));
    if let Some(key) = quoted(error, "unknown field `") {
        let known: Vec<&str> = what.split("expected").nth(1).unwrap_or("").split('`').skip(1).step_by(2).collect();
        return Message::error(format!("unknown key `{key}`")).at(place).hint_names(&key, known);
    }
    if let Some(key) = quoted(error, "missing field `") {
        let of = section.map(|s| format!(" in `{s}`")).unwrap_or_default();
        let message = Message::error(format!("the key `{key}` is missing{of}")).at(place);
        return match key.as_str() {
            "unit" => message
                .hint("state the length unit of the file: \"mm\", \"m\", \"um\" or \"inch\"; it is never guessed"),
            "expanded_uncertainty_um" | "coverage_factor" => {
                message.hint("take both from the instrument's calibration certificate")
            }
            _ => message,
        };
    }
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
        let problems = parse::<Outer>("f.toml", text, &["name", "part"]).unwrap_err();
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
        let problems = parse::<Outer>("f.toml", "name = \n[part\nlength 3\n", &[]).unwrap_err();
        assert!(!problems.0.is_empty() && problems.0.iter().all(|m| m.place.is_some()));
    }
}
