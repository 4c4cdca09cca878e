//! The catalogue of messages: one text for each id and language (Fluent), and an explanation above
//! the English text.
//!
//! Ids and arguments are written by [`error!`](crate::error), [`warning!`](crate::warning) and
//! [`phrase!`](crate::phrase); `tests/catalogue.rs` compares every call with the texts.

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::types::{FluentNumber, FluentNumberOptions};
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::{OnceLock, PoisonError, RwLock, RwLockReadGuard};
use unic_langid::LanguageIdentifier;

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        [$(($name, [
            include_str!(concat!("../messages/en/", $name, ".ftl")),
            include_str!(concat!("../messages/fr/", $name, ".ftl")),
            include_str!(concat!("../messages/de/", $name, ".ftl")),
        ])),*]
    };
}

/// Languages of the catalogue (ISO 639-1).
pub const LANGUAGES: [&str; 3] = ["en", "fr", "de"];

/// Files of the catalogue: name of the crate, and the texts in the order of [`LANGUAGES`].
pub const FILES: [(&str, [&str; 3]); 20] = files![
    "base",
    "campaign",
    "cli",
    "compare",
    "controllers",
    "documents",
    "exports",
    "fit",
    "formats",
    "proposals",
    "identify",
    "report",
    "reporting",
    "robots",
    "run",
    "selftest",
    "simulate",
    "stages",
    "standards",
    "view",
];

/// Named arguments of a text.
pub type Arguments = BTreeMap<String, Argument>;

/// Value of an argument. Units and decimals are part of the text.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(untagged)]
pub enum Argument {
    /// A whole number.
    Whole(i64),
    /// A finite number.
    Number(f64),
    /// A name or another text that is the same in all languages.
    Text(String),
    /// Values that the text separates by commas.
    List(Vec<Argument>),
    /// Another text of the catalogue.
    Phrase(Phrase),
}

// a non-finite number is a text
impl Eq for Argument {}

/// Text of the catalogue with its arguments.
///
/// # Examples
///
/// ```
/// use etalon_base::phrase;
///
/// let approaches = phrase!("approaches", count = 2);
/// assert_eq!(approaches.to_string(), "2 approaches");
/// assert_eq!(approaches.text("de"), "2 Anfahrrichtungen");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[schemars(description = "Text of the catalogue with its arguments.")]
pub struct Phrase {
    /// Id in the catalogue.
    pub id: Cow<'static, str>,
    /// Arguments of the text.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub arguments: Arguments,
}

/// A value that can be an argument.
pub trait IntoArgument {
    /// The value as an argument.
    fn argument(&self) -> Argument;
}

/// [`Phrase`](crate::catalogue::Phrase) of an id of the catalogue; arguments as of
/// [`error!`](crate::error).
#[macro_export]
macro_rules! phrase {
    (@value $name:ident) => { $name };
    (@value $name:ident $value:expr) => { $value };
    ($id:literal $(, $name:ident $(= $value:expr)?)* $(,)?) => {
        $crate::catalogue::Phrase::new($id)$(.with(stringify!($name), &$crate::phrase!(@value $name $($value)?)))*
    };
}

impl Phrase {
    /// Text without arguments. [`phrase!`](crate::phrase) is the usual way.
    pub fn new(id: &'static str) -> Self {
        Self { id: Cow::Borrowed(id), arguments: Arguments::new() }
    }

    /// Adds an argument.
    pub fn with(mut self, name: &str, value: &(impl IntoArgument + ?Sized)) -> Self {
        self.arguments.insert(name.to_owned(), value.argument());
        self
    }

    /// Text in a language (ISO 639-1); English if the catalogue does not have the language, the id
    /// if it does not have the text.
    pub fn text(&self, language: &str) -> String {
        render(&self.id, None, &self.arguments, language).unwrap_or_else(|| self.id.clone().into_owned())
    }
}

impl fmt::Display for Phrase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text("en"))
    }
}

impl Argument {
    /// Text in a language, in the form for lists.
    fn text(&self, language: &str) -> String {
        match self {
            Self::Whole(value) => value.to_string(),
            Self::Number(value) => marked(shortest(*value), language),
            Self::Text(text) => text.clone(),
            Self::List(all) => all.iter().map(|one| one.text(language)).collect::<Vec<_>>().join(", "),
            Self::Phrase(phrase) => phrase.text(language),
        }
    }

    fn value(&self, language: &str) -> FluentValue<'static> {
        match self {
            // a number of Fluent is a double
            Self::Whole(value) if value.unsigned_abs() <= 1 << 53 => FluentValue::from(*value),
            Self::Number(value) => FluentValue::from(*value),
            _ => FluentValue::from(self.text(language)),
        }
    }
}

impl PartialEq<&str> for Argument {
    fn eq(&self, other: &&str) -> bool {
        matches!(self, Self::Text(text) if text == other)
    }
}

impl PartialEq<i64> for Argument {
    fn eq(&self, other: &i64) -> bool {
        matches!(self, Self::Whole(value) if value == other)
    }
}

impl PartialEq<f64> for Argument {
    fn eq(&self, other: &f64) -> bool {
        matches!(self, Self::Number(value) if value == other)
    }
}

impl<T: IntoArgument + ?Sized> IntoArgument for &T {
    fn argument(&self) -> Argument {
        (**self).argument()
    }
}

impl<T: IntoArgument + ?Sized> IntoArgument for Box<T> {
    fn argument(&self) -> Argument {
        (**self).argument()
    }
}

impl IntoArgument for str {
    fn argument(&self) -> Argument {
        Argument::Text(self.to_owned())
    }
}

impl IntoArgument for String {
    fn argument(&self) -> Argument {
        Argument::Text(self.clone())
    }
}

impl IntoArgument for char {
    fn argument(&self) -> Argument {
        Argument::Text(self.to_string())
    }
}

impl IntoArgument for f64 {
    fn argument(&self) -> Argument {
        if self.is_finite() { Argument::Number(*self) } else { Argument::Text(self.to_string()) }
    }
}

impl IntoArgument for Phrase {
    fn argument(&self) -> Argument {
        Argument::Phrase(self.clone())
    }
}

impl IntoArgument for Argument {
    fn argument(&self) -> Argument {
        self.clone()
    }
}

/// An absent text is an empty one.
impl<T: IntoArgument> IntoArgument for Option<T> {
    fn argument(&self) -> Argument {
        self.as_ref().map_or_else(|| Argument::Text(String::new()), T::argument)
    }
}

impl<T: IntoArgument> IntoArgument for [T] {
    fn argument(&self) -> Argument {
        Argument::List(self.iter().map(T::argument).collect())
    }
}

impl<T: IntoArgument> IntoArgument for Vec<T> {
    fn argument(&self) -> Argument {
        self[..].argument()
    }
}

impl<T: IntoArgument, const N: usize> IntoArgument for [T; N] {
    fn argument(&self) -> Argument {
        self[..].argument()
    }
}

macro_rules! whole {
    ($($type:ty),*) => {
        $(impl IntoArgument for $type {
            fn argument(&self) -> Argument {
                i64::try_from(*self).map_or_else(|_| Argument::Text(self.to_string()), Argument::Whole)
            }
        })*
    };
}

whole!(u8, u16, u32, u64, usize, i32, i64, i128);

type Bundle = FluentBundle<FluentResource>;

/// Texts of a language.
struct Texts {
    /// Source of the Fluent entry of each id.
    sources: BTreeMap<&'static str, &'static str>,
    /// Entries that were needed so far: parsing all of them takes longer than the calibration of
    /// a robot.
    parsed: RwLock<Bundle>,
}

/// Texts in the order of [`LANGUAGES`].
static TEXTS: [OnceLock<Texts>; LANGUAGES.len()] = [const { OnceLock::new() }; LANGUAGES.len()];

impl Texts {
    fn new(language: usize) -> Self {
        let sources = FILES.iter().flat_map(|(_, texts)| sources(texts[language])).collect();
        Self { sources, parsed: RwLock::new(bundle(language)) }
    }

    /// Bundle with the entry of a known id.
    fn with(&self, id: &str) -> Option<RwLockReadGuard<'_, Bundle>> {
        let parsed = self.parsed.read().unwrap_or_else(PoisonError::into_inner);
        if parsed.has_message(id) {
            return Some(parsed);
        }
        drop(parsed);
        let text = (*self.sources.get(id)?).to_owned();
        let resource = FluentResource::try_new(text).unwrap_or_else(|(resource, _)| resource);
        // an entry that another thread has added meanwhile is the same
        let _ = self.parsed.write().unwrap_or_else(PoisonError::into_inner).add_resource(resource);
        Some(self.parsed.read().unwrap_or_else(PoisonError::into_inner))
    }
}

/// Ids and sources of the entries of a file: an entry ends where another one or a comment begins.
fn sources(text: &'static str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let is_continued = |line: &&str| line.starts_with([' ', '}', '\n', '\r']);
    let mut rest = text;
    std::iter::from_fn(move || {
        loop {
            let line = rest.split_inclusive('\n').next()?;
            let whole = rest;
            rest = &rest[line.len()..];
            if let Some(id) = entry_id(line) {
                let more: usize = rest.split_inclusive('\n').take_while(is_continued).map(str::len).sum();
                rest = &rest[more..];
                return Some((id, &whole[..line.len() + more]));
            }
        }
    })
}

/// Id whose text begins on this line of a file.
fn entry_id(line: &str) -> Option<&str> {
    let (id, _) = line.starts_with(|c: char| c.is_ascii_alphabetic()).then(|| line.split_once(" ="))??;
    (!id.contains(' ')).then_some(id)
}

/// Bundle without entries.
fn bundle(language: usize) -> Bundle {
    let identifier: LanguageIdentifier = LANGUAGES[language].parse().unwrap_or_default();
    let mut bundle = FluentBundle::new_concurrent(vec![identifier]);
    bundle.set_use_isolating(false);
    bundle.set_formatter(Some(if language == 0 { point } else { comma }));
    let _ = bundle.add_function("FIXED", fixed);
    let _ = bundle.add_function("LENGTH", move |positional, _| length(positional, LANGUAGES[language]));
    let _ = bundle.add_function("SCIENTIFIC", move |positional, _| scientific(positional, LANGUAGES[language]));
    bundle
}

/// `FIXED($value, 3)`: a number with this many decimals.
fn fixed<'a>(positional: &[FluentValue<'a>], _named: &FluentArgs) -> FluentValue<'a> {
    match positional {
        [FluentValue::Number(value), FluentValue::Number(decimals)] => {
            let options =
                FluentNumberOptions { minimum_fraction_digits: Some(decimals.value as usize), ..value.options.clone() };
            FluentNumber::new(value.value, options).into()
        }
        [value, ..] => value.clone(),
        [] => FluentValue::Error,
    }
}

/// `LENGTH($value_mm)`: a length with three significant digits, in µm below 0.1 mm.
fn length<'a>(positional: &[FluentValue<'a>], language: &str) -> FluentValue<'a> {
    match positional {
        [FluentValue::Number(mm)] => {
            let (value, unit) = if mm.value.abs() < 0.1 { (1e3 * mm.value, "µm") } else { (mm.value, "mm") };
            let before = if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
            let decimals = (2 - before).clamp(0, 5) as usize;
            let space = if language == LANGUAGES[0] { ' ' } else { '\u{a0}' };
            format!("{}{space}{unit}", marked(format!("{value:.decimals$}"), language)).into()
        }
        [value, ..] => value.clone(),
        [] => FluentValue::Error,
    }
}

/// `SCIENTIFIC($value, 1)`: a number with an exponent and this many decimals.
fn scientific<'a>(positional: &[FluentValue<'a>], language: &str) -> FluentValue<'a> {
    match positional {
        [FluentValue::Number(value), FluentValue::Number(decimals)] => {
            let decimals = decimals.value as usize;
            marked(format!("{:.decimals$e}", value.value), language).into()
        }
        [value, ..] => value.clone(),
        [] => FluentValue::Error,
    }
}

fn point<M>(value: &FluentValue, _: &M) -> Option<String> {
    number(value, "en")
}

fn comma<M>(value: &FluentValue, _: &M) -> Option<String> {
    number(value, "de")
}

fn number(value: &FluentValue, language: &str) -> Option<String> {
    let FluentValue::Number(number) = value else { return None };
    let text = match number.options.minimum_fraction_digits {
        Some(decimals) if number.value.abs() < LARGE => format!("{:.decimals$}", number.value),
        _ => shortest(number.value),
    };
    Some(marked(text, language))
}

/// Smallest number that is written with an exponent: a double holds no more whole digits.
const LARGE: f64 = 1e16;
/// Largest number that is written with an exponent, except zero.
const SMALL: f64 = 1e-12;

/// A number without rounding; one with hundreds of zeros has an exponent.
fn shortest(value: f64) -> String {
    match value == 0.0 || (SMALL..LARGE).contains(&value.abs()) {
        true => value.to_string(),
        false => format!("{value:e}"),
    }
}

/// A decimal number with the decimal mark of a language.
fn marked(text: String, language: &str) -> String {
    if language == "en" { text } else { text.replace('.', ",") }
}

/// Text of an id, or of an attribute of it.
pub(crate) fn render(id: &str, attribute: Option<&str>, arguments: &Arguments, language: &str) -> Option<String> {
    let index = LANGUAGES.iter().position(|known| *known == language).unwrap_or_default();
    // arguments that are phrases are rendered before the lock is held
    let mut values = FluentArgs::with_capacity(arguments.len());
    for (name, argument) in arguments {
        values.set(name.as_str(), argument.value(LANGUAGES[index]));
    }
    let bundle = TEXTS[index].get_or_init(|| Texts::new(index)).with(id)?;
    let message = bundle.get_message(id)?;
    let pattern = match attribute {
        Some(name) => message.get_attribute(name)?.value(),
        None => message.value()?,
    };
    Some(bundle.format_pattern(pattern, Some(&values), &mut Vec::new()).into_owned())
}

/// Arguments that the English sentence of an id has outside backticks: no names.
pub(crate) fn unquoted(id: &str) -> BTreeSet<&'static str> {
    let start = format!("\n{id} =");
    let rest = FILES.iter().find_map(|(_, texts)| texts[0].split_once(&start)).map_or("", |(_, rest)| rest);
    // attributes and the next entry are no part of the sentence
    let of_sentence = |line: &&str| line.starts_with([' ', '}']) && !line.trim_start().starts_with('.');
    let lines = rest.lines().enumerate().take_while(|(i, line)| *i == 0 || of_sentence(line));
    let sentence = lines.flat_map(|(_, line)| [line, "\n"]).flat_map(|line| line.split_inclusive('`'));
    let mut inside = false;
    let mut names = BTreeSet::new();
    for piece in sentence {
        if !inside {
            names.extend(piece.split('$').skip(1).map(|rest| &rest[..name_length(rest)]));
        }
        inside ^= piece.ends_with('`');
    }
    names
}

/// Length of the name of an argument at the start of a text.
fn name_length(text: &str) -> usize {
    text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(text.len())
}

/// One text of the catalogue in English, and its explanation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Entry {
    /// Id of the message.
    pub id: &'static str,
    /// Name of the crate that reports the message.
    pub file: &'static str,
    /// Meaning of the message; empty for a phrase, which is part of other texts.
    pub meaning: String,
    /// Consequence of the message.
    pub reason: String,
    /// Action to take.
    pub action: String,
    /// Input that causes the message.
    pub example: String,
}

impl Entry {
    /// `true` if the entry is a complete message rather than a part of other texts.
    pub fn is_message(&self) -> bool {
        !self.meaning.is_empty()
    }

    /// English text of the entry, or of an attribute, with `{name}` for each argument.
    pub fn pattern(&self, attribute: Option<&str>) -> Option<String> {
        let source = FILES.iter().find(|(file, _)| *file == self.file).map_or("", |(_, texts)| texts[0]);
        let named = source.split('$').skip(1).map(|rest| {
            let end = name_length(rest);
            (rest[..end].to_owned(), Argument::Text(format!("{{{}}}", &rest[..end])))
        });
        render(self.id, attribute, &named.collect(), "en")
    }
}

/// All texts of the catalogue, file by file.
pub fn entries() -> Vec<Entry> {
    FILES.iter().flat_map(|(file, texts)| file_entries(file, texts[0])).collect()
}

fn file_entries(file: &'static str, text: &'static str) -> Vec<Entry> {
    let (mut all, mut entry, mut last) = (Vec::new(), Entry::default(), None);
    for line in text.lines() {
        if let Some(id) = entry_id(line) {
            all.push(Entry { id, file, ..std::mem::take(&mut entry) });
        } else if let Some(comment) = line.strip_prefix("# ") {
            let labelled = comment.split_once(": ").and_then(|(label, rest)| Some((part(label)?, rest)));
            let (part, rest) = labelled.map_or((last, comment), |(part, rest)| (Some(part), rest));
            last = part;
            let Some(part) = part else { continue };
            let text = part(&mut entry);
            if !text.is_empty() {
                text.push(' ');
            }
            text.push_str(rest);
        } else if line.is_empty() {
            (entry, last) = (Entry::default(), None);
        }
    }
    all
}

type Part = fn(&mut Entry) -> &mut String;

/// Part of an explanation by its label.
fn part(label: &str) -> Option<Part> {
    match label {
        "Means" => Some(|entry| &mut entry.meaning),
        "Matters" => Some(|entry| &mut entry.reason),
        "Do" => Some(|entry| &mut entry.action),
        "Example" => Some(|entry| &mut entry.example),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_has_the_decimals_of_the_text_and_the_mark_of_the_language() {
        let steep = crate::phrase!("deviation-steep", change = 2.5, from = 0.0, to = 10.25);
        assert_eq!(steep.to_string(), "the deviation changes by 2.5 from 0 to 10.25");
        assert!(steep.text("de").contains("10,25"));
        let length = |value: f64| crate::phrase!("quaternion-length", target = "p1.5", length = value);
        assert!(length(0.5).to_string().contains("p1.5") && length(0.5).to_string().contains("0.5000"));
        assert!(length(0.5).text("fr").contains("p1.5") && length(0.5).text("fr").contains("0,5000"));
        assert!(length(f64::NAN).to_string().contains("NaN"));
    }

    #[test]
    fn a_length_is_in_micrometres_below_a_tenth_of_a_millimetre() {
        let drift = |change_mm: f64| crate::phrase!("positions-drift", pose = 1, change_mm);
        for (mm, shown) in [(0.0579, "57.9 µm"), (0.1, "0.100 mm"), (0.00234, "2.34 µm"), (12.5, "12.5 mm")] {
            assert!(drift(mm).to_string().contains(&format!(" {shown} ")), "{}", drift(mm));
        }
        assert!(drift(0.0579).text("de").contains("57,9\u{a0}µm"));
    }

    #[test]
    fn a_ratio_has_no_unit_and_no_number_has_hundreds_of_digits() {
        let beyond = |value: f64, unit: &str| {
            crate::phrase!("value-beyond-tolerance", parameter = "p", value, unit, nominal = 1.0, tolerance = 0.05)
        };
        assert_eq!(beyond(-0.99959, "1").to_string(), "`p` = -0.9996 (nominal 1, tolerance 0.050)");
        assert_eq!(beyond(1.2, "mm").to_string(), "`p` = 1.200 mm (nominal 1 mm, tolerance 0.050 mm)");
        assert!(beyond(-2.5e300, "mm").text("de").starts_with("`p` = -2,5e300\u{a0}mm ("));
        let step = |step: f64| crate::phrase!("column-step", column = "x", step, unit = "mm").to_string();
        let written = [1e300, 1e-300, 1e15, 0.000001, 0.0].map(step);
        let shown = ["1e300", "1e-300", "1000000000000000", "0.000001", "0"].map(|step| format!("x to {step} mm"));
        assert_eq!(written, shown);
    }

    #[test]
    fn entries_read_one_by_one_are_those_of_the_files() {
        for (file, texts) in &FILES {
            for text in texts {
                let whole = FluentResource::try_new((*text).to_owned()).expect(file);
                let singles: Vec<FluentResource> =
                    sources(text).map(|(id, source)| FluentResource::try_new(source.to_owned()).expect(id)).collect();
                assert!(whole.entries().eq(singles.iter().flat_map(FluentResource::entries)), "{file}");
            }
        }
    }

    #[test]
    fn an_unknown_id_or_language_does_no_harm() {
        assert_eq!(Phrase::new("no-such-id").text("de"), "no-such-id");
        assert_eq!(crate::phrase!("approaches", count = 1).text("it"), "1 approach");
    }

    #[test]
    fn arguments_read_back_as_they_were_written() {
        let inner = crate::phrase!("approaches", count = 3);
        let phrase =
            Phrase::new("x").with("a", &1).with("b", &1.0).with("c", "1").with("d", &["p", "q"]).with("e", &inner);
        let text = toml::to_string(&phrase).unwrap();
        assert_eq!(toml::from_str::<Phrase>(&text).unwrap(), phrase, "{text}");
    }

    #[test]
    fn an_explanation_is_read_by_its_labels() {
        let text = "# Means: one\n# more\n# Example: `a: b`\nan-id = text\n    .hint = h\n\nother = x\n";
        let all = file_entries("base", text);
        assert_eq!((all[0].id, all[0].meaning.as_str(), all[0].example.as_str()), ("an-id", "one more", "`a: b`"));
        assert!(all[0].is_message() && !all[1].is_message() && all.len() == 2);
    }
}
