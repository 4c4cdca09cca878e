//! Messages: what is wrong, where, what was expected, and a hint.

use crate::catalogue::{Argument, Arguments, IntoArgument, Phrase, render, unquoted};
use crate::phrase;
use annotate_snippets::{AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Effect of a message on the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// The work stops.
    Error,
    /// The command continues; the report repeats the message.
    Warning,
}

/// Importance of a message for a reader of a report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Rank {
    /// Somebody has to act before the result is used.
    Decide,
    /// Whoever uses the result should know it.
    #[default]
    Know,
    /// Nothing is wrong; given for completeness.
    Routine,
}

/// Part of the program that answers a message besides its reader.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AnsweredBy {
    /// No part.
    #[default]
    Nobody,
    /// A next step of the verdict, which says the same.
    NextStep,
    /// The next measurements.
    Measurements,
}

/// Place of a message: a file, optionally a line and columns.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Place {
    /// File as in the campaign.
    pub file: String,
    /// Line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Column in characters, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
    /// Number of marked characters, at least 1.
    #[serde(skip)]
    pub width: usize,
    /// The line itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
}

/// One error or warning: id and arguments of its text in the catalogue, the English texts, and its
/// place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Message {
    /// Id in the catalogue; `etalon explain ID` explains it.
    #[serde(default, skip_serializing_if = "str::is_empty")]
    pub id: Cow<'static, str>,
    /// Arguments of the texts. `expected` and `hint` are texts of the catalogue that replace the
    /// message's own.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub arguments: Arguments,
    /// Texts around the message, from inside: each has the message as its argument `message`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub around: Vec<Phrase>,
    /// Error or warning.
    pub severity: Severity,
    /// Importance for a reader.
    #[serde(default)]
    pub rank: Rank,
    /// Error or remark, in one English sentence without a full stop.
    pub what: String,
    /// Place of the problem.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<Box<Place>>,
    /// Expected value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected: Option<String>,
    /// Next action.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
    /// Part of the program that answers the message. Not in documents.
    #[serde(skip)]
    pub answered_by: AnsweredBy,
}

/// Error message of an id of the catalogue: `error!("unit-missing", key = "unit")`. A variable
/// alone is its own name: `error!("no-pose", pose)`.
#[macro_export]
macro_rules! error {
    ($($call:tt)*) => { $crate::message::Message::new($crate::message::Severity::Error, $crate::phrase!($($call)*)) };
}

/// Warning of an id of the catalogue; arguments as of [`error!`](crate::error).
#[macro_export]
macro_rules! warning {
    ($($call:tt)*) => { $crate::message::Message::new($crate::message::Severity::Warning, $crate::phrase!($($call)*)) };
}

impl Place {
    /// A whole file.
    pub fn file(file: impl Into<String>) -> Self {
        Self { file: file.into(), ..Self::default() }
    }

    /// A line of a file.
    pub fn line(file: impl Into<String>, line: usize, text: impl Into<String>) -> Self {
        Self { file: file.into(), line: Some(line), text: Some(text.into()), ..Self::default() }
    }

    /// The bytes `span` of a file whose whole text is `source`.
    pub fn span(file: impl Into<String>, source: &str, span: std::ops::Range<usize>) -> Self {
        let start = floor_boundary(source, span.start);
        let end = floor_boundary(source, span.end.max(start));
        let line_start = source[..start].rfind('\n').map_or(0, |i| i + 1);
        let text = source[line_start..].lines().next().unwrap_or("");
        let within = source[start..end].lines().next().unwrap_or("");
        Self {
            file: file.into(),
            line: Some(source[..start].matches('\n').count() + 1),
            column: Some(source[line_start..start].chars().count() + 1),
            width: within.chars().count(),
            text: Some(text.to_owned()),
        }
    }

    /// File and line as a terminal shows them, with the offending text underlined.
    fn elements(&self) -> Vec<Element<'static>> {
        let file = printable(&self.file);
        let (Some(line), Some(text)) = (self.line, &self.text) else {
            let origin = Origin::path(file);
            return vec![self.line.map_or(origin.clone(), |line| origin.line(line)).into()];
        };
        let shown = printable(&one_line(text));
        let byte = |column: usize| shown.char_indices().nth(column).map_or(shown.len(), |(at, _)| at);
        let marked = self.column.map(|column| {
            let start = column.saturating_sub(1);
            byte(start)..byte(start + self.width.max(1))
        });
        let snippet = Snippet::source(shown.clone()).line_start(line).fold(false);
        match marked {
            Some(marked) => vec![snippet.path(file).annotation(AnnotationKind::Primary.span(marked)).into()],
            None => vec![snippet.path(format!("{file}:{line}")).into()],
        }
    }

    /// This line with `width` characters marked from `column` (from 1).
    pub fn at(mut self, column: usize, width: usize) -> Self {
        self.column = Some(column);
        self.width = width;
        self
    }
}

/// A text that gives values, and the file name under which it is shown: the place of each value.
#[derive(Clone, Copy, Debug)]
pub struct SourceText<'a> {
    /// File as the user named it.
    pub name: &'a str,
    /// Its text.
    pub text: &'a str,
}

impl SourceText<'_> {
    /// Place of a value.
    pub fn place<T>(&self, value: &toml::Spanned<T>) -> Place {
        Place::span(self.name, self.text, value.span())
    }
}

fn floor_boundary(source: &str, index: usize) -> usize {
    let index = index.min(source.len());
    (0..=index).rev().find(|&i| source.is_char_boundary(i)).unwrap_or(0)
}

impl Message {
    /// Message of the catalogue.
    ///
    /// # Examples
    ///
    /// ```
    /// use etalon_base::message::Place;
    ///
    /// let place = Place::line("joints.csv", 7, "3;10,5");
    /// let message = etalon_base::error!("galil-value-too-large", parameter = "d").at(place);
    /// let lines = [
    ///     "error[galil-value-too-large]: `d` is too large for a variable of a Galil controller",
    ///     " --> joints.csv:7",
    ///     "  |",
    ///     "7 | 3;10,5",
    /// ];
    /// assert!(message.to_string().starts_with(&lines.join("\n")), "{message}");
    /// assert!(message.is("galil-value-too-large", &[("parameter", &"d")]));
    /// ```
    pub fn new(severity: Severity, text: Phrase) -> Self {
        let Phrase { id, arguments } = text;
        let rank = if severity == Severity::Error { Rank::Decide } else { Rank::Know };
        let message = Self { severity, rank, id, arguments, ..Self::error("") };
        let Texts { what, expected, hint } = message.texts("en");
        Self { what, expected, hint, ..message }
    }

    /// An error with a text that is not in the catalogue.
    pub fn error(what: impl Into<String>) -> Self {
        Self {
            id: Cow::Borrowed(""),
            arguments: Arguments::new(),
            around: Vec::new(),
            severity: Severity::Error,
            rank: Rank::Decide,
            what: what.into(),
            place: None,
            expected: None,
            hint: None,
            answered_by: AnsweredBy::Nobody,
        }
    }

    /// A warning with a text that is not in the catalogue.
    pub fn warning(what: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, rank: Rank::Know, ..Self::error(what) }
    }

    /// Texts in a language (ISO 639-1). English for a message that is not in the catalogue.
    pub fn texts(&self, language: &str) -> Texts {
        let part = |name: &str, english: &Option<String>| match self.arguments.get(name) {
            Some(Argument::Phrase(phrase)) => Some(phrase.text(language)),
            _ => {
                let of = |language: &str| render(&self.id, Some(name), &self.arguments, language);
                // a caller may have given another one
                let own = english.is_none() || *english == of("en");
                of(language).filter(|_| own).or_else(|| english.clone())
            }
        };
        let what = match self.sentence(language).filter(|_| !self.is_reworded()) {
            Some(text) => text,
            None => self.what.clone(),
        };
        Texts { what, expected: part("expected", &self.expected), hint: part("hint", &self.hint) }
    }

    /// The message with its texts in a language, for a terminal.
    pub fn in_language(&self, language: &str) -> Self {
        let Texts { what, expected, hint } = self.texts(language);
        Self { what, expected, hint, ..self.clone() }
    }

    /// `true` if a caller changed the English sentence: the catalogue then does not have the
    /// addition.
    fn is_reworded(&self) -> bool {
        !self.what.is_empty() && self.sentence("en").is_some_and(|english| english != self.what)
    }

    /// Sentence of the catalogue, with the texts around it.
    fn sentence(&self, language: &str) -> Option<String> {
        let text = render(&self.id, None, &self.arguments, language)?;
        let around = |inner: String, around: &Phrase| around.clone().with("message", &inner).text(language);
        Some(self.around.iter().fold(text, around))
    }

    /// Sentence of the message, to be an argument of another text or the reason in a document.
    pub fn phrase(&self) -> Phrase {
        let inner = Phrase { id: self.id.clone(), arguments: self.arguments.clone() };
        self.around.iter().fold(inner, |inner, around| around.clone().with("message", &inner))
    }

    /// `true` if this is the message of an id of the catalogue, with at least these arguments.
    pub fn is(&self, id: &str, arguments: &[(&str, &dyn IntoArgument)]) -> bool {
        let is_stated =
            |(name, value): &(&str, &dyn IntoArgument)| self.arguments.get(*name) == Some(&value.argument());
        self.id == id && arguments.iter().all(is_stated)
    }

    /// Inserts the message into a text with the argument `message`, for example its place.
    pub fn within(mut self, around: Phrase) -> Self {
        self.what = around.clone().with("message", &self.what).to_string();
        self.around.push(around);
        self
    }

    /// Ranks the message as one on which somebody has to act.
    pub fn to_decide(self) -> Self {
        Self { rank: Rank::Decide, ..self }
    }

    /// `true` for a warning on which somebody has to act, and that no step of a report answers.
    pub fn is_open_decision(&self) -> bool {
        let is_open = self.rank == Rank::Decide && self.answered_by != AnsweredBy::NextStep;
        self.severity == Severity::Warning && is_open
    }

    /// Ranks the message as given for completeness.
    pub fn routine(self) -> Self {
        Self { rank: Rank::Routine, ..self }
    }

    /// Names the part of the program that answers the message.
    pub fn answered_by(self, answered_by: AnsweredBy) -> Self {
        Self { answered_by, ..self }
    }

    /// Adds the place.
    pub fn at(mut self, place: Place) -> Self {
        self.place = Some(Box::new(place));
        self
    }

    /// Adds the expected value.
    pub fn expected(mut self, expected: impl Into<Remark>) -> Self {
        self.expected = Some(self.remark("expected", expected.into()));
        self
    }

    /// Adds a hint.
    pub fn hint(mut self, hint: impl Into<Remark>) -> Self {
        self.hint = Some(self.remark("hint", hint.into()));
        self
    }

    /// English text of a remark, whose phrase is kept among the arguments.
    fn remark(&mut self, name: &str, remark: Remark) -> String {
        match remark {
            Remark::Free(text) => text,
            Remark::Phrase(phrase) => {
                self.arguments.insert(name.to_owned(), phrase.argument());
                phrase.to_string()
            }
        }
    }

    /// A hint that proposes the nearest of the names that exist, or lists them.
    pub fn hint_names<'a>(self, wrong: &str, names: impl IntoIterator<Item = &'a str>) -> Self {
        let names: Vec<&str> = names.into_iter().collect();
        // a name without its unit: the unit is never chosen for the reader
        let in_units: Vec<String> =
            names.iter().filter(|name| is_in_unit(name, wrong)).map(|name| format!("`{name}`")).collect();
        if in_units.len() > 1 {
            return self.hint(phrase!("name-without-unit", names = in_units));
        }
        match nearest(wrong, names.iter().copied()) {
            Some(name) => match other_unit(wrong, name) {
                Some((from, factor, to)) => self.hint(phrase!("meant-in-unit", name, from, factor, to)),
                None => self.hint(phrase!("did-you-mean", name)),
            },
            None if names.is_empty() => self,
            None if names.len() > 12 => self.hint(phrase!("known-names-first", names = names[..12])),
            None => self.hint(phrase!("known-names", names)),
        }
    }
}

/// Texts of a message in one language.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Texts {
    /// Error or remark.
    pub what: String,
    /// Expected value.
    pub expected: Option<String>,
    /// Next action.
    pub hint: Option<String>,
}

/// Expected value or hint of a message.
#[derive(Clone, Debug)]
pub enum Remark {
    /// English text that is not in the catalogue.
    Free(String),
    /// Text of the catalogue.
    Phrase(Phrase),
}

impl From<&str> for Remark {
    fn from(text: &str) -> Self {
        Self::Free(text.to_owned())
    }
}

impl From<&String> for Remark {
    fn from(text: &String) -> Self {
        Self::Free(text.clone())
    }
}

impl From<String> for Remark {
    fn from(text: String) -> Self {
        Self::Free(text)
    }
}

impl From<Phrase> for Remark {
    fn from(phrase: Phrase) -> Self {
        Self::Phrase(phrase)
    }
}

/// Units in names, by quantity: mm, rad.
const UNITS: [(&str, f64, bool); 8] = [
    ("deg", std::f64::consts::PI / 180.0, true),
    ("rad", 1.0, true),
    ("mrad", 1e-3, true),
    ("mm", 1.0, false),
    ("m", 1e3, false),
    ("cm", 10.0, false),
    ("um", 1e-3, false),
    ("inch", 25.4, false),
];

/// `true` if a name is another name with a unit behind it: `alpha_deg` for `alpha`.
fn is_in_unit(name: &str, bare: &str) -> bool {
    name.rsplit_once('_').is_some_and(|(stem, unit)| stem == bare && UNITS.iter().any(|known| known.0 == unit))
}

/// Units of two names that differ only in the unit, and the factor between them: rad, 57.29577951,
/// deg.
fn other_unit(wrong: &str, name: &str) -> Option<(&'static str, f64, &'static str)> {
    let split = |name: &str| {
        let (stem, unit) = name.rsplit_once('_')?;
        Some((stem.to_owned(), UNITS.into_iter().find(|u| u.0 == unit)?))
    };
    let ((stem, from), (other, to)) = (split(wrong)?, split(name)?);
    let factor = (1e8 * from.1 / to.1).round() / 1e8;
    (stem == other && from.0 != to.0 && from.2 == to.2).then_some((from.0, factor, to.0))
}

/// Number of lines of a file in which a message may be repeated before one represents the others.
const LISTED: usize = 3;

/// Argument whose number is the fault of a row: a row of a single field is not divided at all.
const FIELDS: &str = "fields";

/// Shapes of texts: id and arguments without what differs from row to row, which is numbers, and
/// names, which the sentence has between backticks.
#[derive(Default)]
struct Shapes<'a>(BTreeMap<&'a str, BTreeSet<&'static str>>);

impl<'a> Shapes<'a> {
    /// Shape of a message; its English text if it has no id.
    fn message_shape(&mut self, message: &'a Message) -> String {
        if message.id.is_empty() {
            return message.what.clone();
        }
        let around = message.around.iter().map(|phrase| self.text_shape(&phrase.id, &phrase.arguments));
        let around: String = around.collect();
        self.text_shape(&message.id, &message.arguments) + &around
    }

    fn text_shape(&mut self, id: &'a str, arguments: &'a Arguments) -> String {
        let kept = self.0.entry(id).or_insert_with(|| unquoted(id));
        let kept: Vec<_> = arguments.iter().filter(|(name, _)| kept.contains(name.as_str())).collect();
        let kept = kept.into_iter().map(|(name, value)| match value {
            Argument::Whole(1) if name == FIELDS => format!("{name}: 1"),
            _ => format!("{name}: {}", self.argument_shape(value)),
        });
        format!("{id}({})", kept.collect::<Vec<_>>().join("; "))
    }

    fn argument_shape(&mut self, argument: &'a Argument) -> String {
        match argument {
            Argument::Whole(_) | Argument::Number(_) => String::new(),
            Argument::Text(text) => text.chars().filter(|c| !c.is_ascii_digit() && !"+-.".contains(*c)).collect(),
            Argument::List(all) => all.iter().map(|one| self.argument_shape(one)).collect::<Vec<_>>().join(", "),
            Argument::Phrase(phrase) => self.text_shape(&phrase.id, &phrase.arguments),
        }
    }
}

/// `1 row`, `2 rows`.
pub fn count(n: usize, noun: &str) -> String {
    let plural = if noun.ends_with("ss") { "es" } else { "s" };
    format!("{n} {noun}{}", if n == 1 { "" } else { plural })
}

/// Maximum length (bytes) of a text that is compared with others.
const LONGEST_NAME: usize = 200;

/// The name that `wrong` may be meant as, if one is like it.
pub fn nearest<'a>(wrong: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if wrong.len() > LONGEST_NAME {
        return None;
    }
    let names = names.into_iter().filter(|name| !are_other_letters(wrong, name));
    let likeness = names.map(|name| (strsim::jaro_winkler(wrong, name), name));
    likeness.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(likeness, _)| *likeness > 0.8).map(|(_, name)| name)
}

/// `true` if names with one suffix begin with different single letters: `z_mm` is not a misspelt
/// `y_mm`.
fn are_other_letters(wrong: &str, name: &str) -> bool {
    let letter = |name: &str| name.split('_').next().filter(|stem| stem.chars().count() == 1).map(str::to_lowercase);
    letter(wrong).zip(letter(name)).is_some_and(|(a, b)| a != b)
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let level = match self.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let mut title = level.primary_title(printable(&self.what));
        if !self.id.is_empty() {
            title = title.id(self.id.as_ref());
        }
        let mut group = Group::with_title(title).elements(self.place.iter().flat_map(|place| place.elements()));
        let mut groups = Vec::new();
        if let Some(text) = &self.expected {
            let expected = Level::NOTE.with_name("expected");
            match self.place {
                Some(_) => group = group.element(expected.message(printable(text))),
                None => groups.push(Group::with_title(expected.secondary_title(printable(text)))),
            }
        }
        groups.insert(0, group);
        groups.extend(
            self.hint
                .iter()
                .map(|text| Group::with_title(Level::HELP.with_name("hint").secondary_title(printable(text)))),
        );
        // groups that are drawn together are joined by an empty line
        let drawn = groups.into_iter().map(|group| Renderer::plain().render(&[group]));
        f.write_str(&drawn.collect::<Vec<_>>().join("\n"))
    }
}

/// Replaces a character that is not safe in a line of a terminal: a control character, or a mark of
/// the direction of text (UAX #9), which could move a name to another place in the line.
pub fn printable_character(c: char) -> char {
    match c {
        '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{2028}' | '\u{2029}' => '\u{fffd}',
        c => without_control(c),
    }
}

fn without_control(c: char) -> char {
    match c {
        '\t' => ' ',
        c if c.is_control() => '\u{fffd}',
        c => c,
    }
}

/// A text within a line of a terminal.
pub fn printable(text: &str) -> String {
    text.chars().map(printable_character).collect()
}

/// Lines of a terminal: [`printable`] of each.
pub fn printable_lines(text: &str) -> String {
    text.chars().map(|c| if c == '\n' { c } else { printable_character(c) }).collect()
}

/// A line fit to be shown, cut at 200 characters.
pub fn one_line(text: &str) -> String {
    let cut = if text.chars().nth(200).is_some() { " ..." } else { "" };
    text.chars().take(200).map(without_control).collect::<String>() + cut
}

/// All problems found in one pass: returned by a stage instead of its document.
///
/// # Examples
///
/// ```
/// use etalon_base::message::{Message, Problems};
///
/// let mut problems = Problems(vec![Message::warning("pose 4 has 29 cycles")]);
/// let warnings = problems.clone().check().expect("a warning does not stop the work");
/// assert_eq!(warnings.len(), 1);
///
/// problems.0.push(Message::error("pose 7 has no commanded position"));
/// let both = problems.check().expect_err("an error does");
/// assert_eq!(both.0.len(), 2);
/// ```
#[derive(Clone, Debug, Default)]
pub struct Problems(pub Vec<Message>);

impl Problems {
    /// `Ok` unless an error is among the messages.
    pub fn check(self) -> std::result::Result<Vec<Message>, Self> {
        if self.0.iter().any(|m| m.severity == Severity::Error) { Err(self) } else { Ok(self.0) }
    }

    /// Inserts each message into a text with the argument `message`.
    pub fn within(self, around: &Phrase) -> Self {
        Self(self.0.into_iter().map(|message| message.within(around.clone())).collect())
    }

    /// Returns the value of a result; the problems of a failed result are added to these problems.
    pub fn keep<T>(&mut self, result: Result<T>) -> Option<T> {
        result.map_err(|more| self.0.extend(more.0)).ok()
    }

    /// Merges messages that are repeated in more than three rows of a data file: the first remains,
    /// with the next two lines and the number of others. Names and numbers in a message may differ.
    /// Statements are not rows, and several messages about one line are not merged.
    pub fn grouped(self) -> Self {
        let mut lines: BTreeMap<(String, String), Vec<usize>> = BTreeMap::new();
        let mut shapes = Shapes::default();
        let keys = self.0.iter().map(|message| {
            let place = message.place.as_ref()?;
            Some(((place.file.clone(), shapes.message_shape(message)), place.line?))
        });
        let keys: Vec<Option<((String, String), usize)>> = keys.collect();
        for (key, line) in keys.iter().flatten() {
            lines.entry(key.clone()).or_default().push(*line);
        }
        // several cells of a row are one row
        lines.values_mut().for_each(|lines| lines.dedup());
        lines.retain(|(file, _), lines| {
            let distinct = lines.iter().collect::<BTreeSet<_>>().len() == lines.len();
            lines.len() > LISTED && distinct && !file.ends_with(".toml")
        });
        let mut messages = self.0;
        let mut keys = keys.into_iter();
        messages.retain_mut(|message| {
            let Some((key, _)) = keys.next().flatten() else { return true };
            let Some(lines) = lines.get_mut(&key) else { return true };
            // the first takes the lines of the rest
            let [_, second, third, rest @ ..] = &std::mem::take(lines)[..] else { return false };
            let around = phrase!("also-in-lines", second, third, more = rest.len());
            *message = message.clone().within(around);
            true
        });
        Self(messages)
    }

    /// [Grouped](Self::grouped) messages about this file and its text, unless they name another
    /// file; shows the lines that they name.
    pub fn in_text(self, file: &str, text: &str) -> Self {
        let mut grouped = self.grouped();
        for message in &mut grouped.0 {
            let place = message.place.get_or_insert_default();
            if place.file.is_empty() || (place.file == file && place.text.is_none()) {
                let shown = |line: usize| text.lines().nth(line.saturating_sub(1)).unwrap_or("");
                **place = place.line.map_or_else(|| Place::file(file), |line| Place::line(file, line, shown(line)));
            }
        }
        grouped
    }

    /// Adds this place to messages without a place, and its file to messages with a line alone.
    pub fn at(mut self, place: &Place) -> Self {
        for message in &mut self.0 {
            let own = message.place.get_or_insert_with(|| Box::new(place.clone()));
            if own.file.is_empty() {
                own.file.clone_from(&place.file);
            }
        }
        self
    }
}

impl From<Message> for Problems {
    fn from(message: Message) -> Self {
        Self(vec![message])
    }
}

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, message) in self.clone().grouped().0.iter().enumerate() {
            if i > 0 {
                f.write_str("\n\n")?;
            }
            write!(f, "{message}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Problems {}

/// A document, or everything that is wrong.
pub type Result<T> = std::result::Result<T, Problems>;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_axis_is_not_a_misspelt_name() {
        assert_eq!(nearest("z_mm", ["x_mm", "y_mm"]), None);
        assert_eq!(nearest("z_mm", ["x_mm", "Z_mm"]), Some("Z_mm"));
        assert_eq!(nearest("y_mn", ["x_mm", "y_mm"]), Some("y_mm"));
        assert_eq!(nearest("coverage_facter", ["name", "coverage_factor"]), Some("coverage_factor"));
    }

    #[test]
    fn a_name_without_its_unit_has_every_unit_in_the_hint() {
        let hint = |wrong: &str| {
            let known = ["alpha_deg", "alpha_rad", "a_mm", "a_m", "name"];
            Message::error("unknown key").hint_names(wrong, known).arguments["hint"].clone()
        };
        let units = |names: [&str; 2]| phrase!("name-without-unit", names).argument();
        assert_eq!(hint("alpha"), units(["`alpha_deg`", "`alpha_rad`"]));
        assert_eq!(hint("a"), units(["`a_mm`", "`a_m`"]));
        assert_eq!(hint("nome"), phrase!("did-you-mean", name = "name").argument());
    }

    #[test]
    fn a_span_is_printed_with_its_line_and_a_hint() {
        let source = "name = \"x\"\nrobto = 1\n";
        let message = Message::error("unknown key `robto`")
            .at(Place::span("campaign.toml", source, 11..16))
            .hint_names("robto", ["robot", "name"]);
        let lines = [
            "error: unknown key `robto`",
            " --> campaign.toml:2:1",
            "  |",
            "2 | robto = 1",
            "  | ^^^^^",
            "hint: did you mean `robot`?",
        ];
        assert_eq!(message.to_string(), lines.join("\n"));
        assert_eq!(message.texts("de").hint.as_deref(), Some("war `robot` gemeint?"));
    }

    #[test]
    fn a_line_is_printed_whole_where_no_column_is_known() {
        let message = crate::error!("locked", process = "17", file = "a.csv").at(Place::line("a.csv", 7, "3;10,5"));
        let lines = [
            "error[locked]: process 17 is writing `a.csv`",
            " --> a.csv:7",
            "  |",
            "7 | 3;10,5",
            "  |",
            "  = expected: nothing",
            "hint: wait until it has ended",
        ];
        assert_eq!(message.expected("nothing").to_string(), lines.join("\n"));
        let unplaced = crate::error!("counts-too-large", of = "rows", counts = "3", most = 2).to_string();
        assert_eq!(unplaced, "error[counts-too-large]: too many rows: 3\nexpected: at most 2");
        let file = crate::error!("cannot-encode", format = "CSV", reason = "r").at(Place::file("a.csv"));
        assert_eq!(file.to_string(), "error[cannot-encode]: cannot write CSV: r\n--> a.csv");
    }

    #[test]
    fn a_message_and_what_is_around_it_have_every_language() {
        let message = crate::error!("counts-too-large", of = "rows", counts = "3 poses", most = 2).within(phrase!(
            "also-in-lines",
            second = 3,
            third = 4,
            more = 1
        ));
        assert!(message.is("counts-too-large", &[("most", &2)]) && !message.is("counts-too-large", &[("most", &3)]));
        assert_eq!(message.texts("en").what, message.what);
        let german = message.texts("de");
        assert_eq!(german.what, "zu viele rows: 3 poses; ebenso in den Zeilen 3, 4 und 1 weiteren Zeile");
        assert_eq!(german.expected.as_deref(), Some("höchstens 2"));
        let reworded = Message { what: format!("set A: {}", message.what), ..message.clone() };
        assert_eq!(reworded.texts("de").what, reworded.what);
        let other = crate::error!("locked", process = "1", file = "f").hint("another hint");
        assert_eq!(other.texts("fr").hint.as_deref(), Some("another hint"));
        assert_eq!(Message::error("free").hint("text").texts("fr").hint.as_deref(), Some("text"));
    }

    /// A cell that is not a number, in a line of a file.
    fn row(file: &str, line: usize) -> Message {
        let message = crate::error!("not-a-number", text = format!("v{line}"), decimal = ".", thousands = "none");
        message.at(Place::line(file, line, format!("v{line}")))
    }

    #[test]
    fn a_message_that_every_row_repeats_is_one_with_its_count() {
        let other = crate::error!("one-campaign");
        let all = |rows: usize| {
            let rows = (2..2 + rows).map(|line| row("a.csv", line));
            Problems(rows.chain([other.clone(), other.clone()]).collect()).grouped()
        };
        assert_eq!(all(3).0.len(), 3 + 2);
        let grouped = all(11_993);
        assert_eq!(grouped.0.len(), 1 + 2);
        assert!(grouped.0[0].is("not-a-number", &[("text", &"v2")]), "{grouped}");
        assert_eq!(grouped.0[0].around, [phrase!("also-in-lines", second = 3, third = 4, more = 11_990)]);
        assert_eq!(grouped.clone().grouped().0, grouped.0);
        // several about one line, and statements
        let count = |all: &mut dyn Iterator<Item = Message>| Problems(all.collect()).grouped().0.len();
        assert_eq!(count(&mut (0..9).map(|_| row("a.csv", 1))), 9);
        assert_eq!(count(&mut (1..9).map(|line| row("c.toml", line))), 8);
        // another file
        assert_eq!(count(&mut (1..3).map(|line| row("b.csv", line)).chain((1..4).map(|line| row("a.csv", line)))), 5);
    }

    #[test]
    fn messages_of_one_id_are_one_unless_their_words_differ() {
        let count = |message: &dyn Fn(usize) -> Message| {
            let all = (1..7).map(|line| message(line).at(Place::line("a.csv", line, "")));
            Problems(all.collect()).grouped().0.len()
        };
        let even = |line: usize| line.is_multiple_of(2);
        // numbers and names differ from row to row, and so do hints
        let signed = |line: usize| if even(line) { 0.5 } else { -0.5 };
        assert_eq!(count(&|line| crate::warning!("quaternion-length", target = "K", length = signed(line))), 1);
        assert_eq!(count(&|line| crate::error!("target-formula", target = format!("K{line}"))), 1);
        assert_eq!(
            count(&|line| crate::error!("no-pose-measured").hint(phrase!("did-you-mean", name = format!("p{line}")))),
            1
        );
        // words of the sentence, another sentence inside, and another text around
        let kind = |line: usize| if even(line) { "first" } else { "second" };
        assert_eq!(count(&|line| crate::error!("row-without-point", reason = kind(line))), 6);
        let reason =
            |line: usize| if even(line) { phrase!("row-at-origin") } else { phrase!("row-without-coordinates") };
        assert_eq!(count(&|line| crate::error!("row-without-point", reason = reason(line))), 6);
        let around =
            |line: usize| if even(line) { phrase!("in-file", file = "f") } else { phrase!("of-name", name = "f") };
        assert_eq!(count(&|line| crate::error!("no-pose-measured").within(around(line))), 6);
        // a stored message without an id
        assert_eq!(count(&|line| Message::error(format!("row {line}"))), 6);
        assert_eq!(count(&|_| Message::error("the same")), 1);
    }

    #[test]
    fn spans_off_the_end_or_inside_a_character_do_no_harm() {
        for span in [(0, 99), (1, 2), (5, 3), (50, 60)] {
            let span = span.0..span.1;
            let _ = Message::error("e").at(Place::span("f", "äöü\nß", span)).to_string();
        }
    }
}
