//! Messages: what is wrong, where, what was expected, and a hint.

use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Whether the work can go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// The work stops.
    Error,
    /// The work goes on; the report repeats it.
    Warning,
}

/// How much a reader of a report has to care.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Rank {
    /// Somebody has to act before the result is used.
    Decide,
    /// Whoever uses the result should know it.
    #[default]
    Know,
    /// It is as it should be, and stated for completeness.
    Routine,
}

/// Where a message points: a file, perhaps a line, perhaps columns of it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Place {
    /// File as the campaign names it.
    pub file: String,
    /// Line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Column in characters, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
    /// How many characters are meant, at least 1.
    #[serde(skip)]
    pub width: usize,
    /// The line itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
}

/// One thing to say to the user.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Message {
    /// Error or warning.
    pub severity: Severity,
    /// How much a reader has to care.
    #[serde(default)]
    pub rank: Rank,
    /// What is wrong, in one sentence without a full stop.
    pub what: String,
    /// Where.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<Box<Place>>,
    /// What was expected there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected: Option<String>,
    /// What to do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
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

    /// The same line, pointing at `width` characters from `column` (from 1).
    pub fn at(mut self, column: usize, width: usize) -> Self {
        self.column = Some(column);
        self.width = width;
        self
    }
}

/// A text that states values, and the file that it is shown as: the place of each value.
#[derive(Clone, Copy, Debug)]
pub struct SourceText<'a> {
    /// File as the user named it.
    pub name: &'a str,
    /// Its text.
    pub text: &'a str,
}

impl SourceText<'_> {
    /// Where a value is.
    pub fn place<T>(&self, value: &toml::Spanned<T>) -> Place {
        Place::span(self.name, self.text, value.span())
    }
}

fn floor_boundary(source: &str, index: usize) -> usize {
    let index = index.min(source.len());
    (0..=index).rev().find(|&i| source.is_char_boundary(i)).unwrap_or(0)
}

impl Message {
    /// An error: the work stops.
    ///
    /// # Examples
    ///
    /// ```
    /// use etalon_base::message::{Message, Place};
    ///
    /// let message = Message::error("`10,5` is not a number")
    ///     .at(Place::line("joints.csv", 7, "3;10,5"))
    ///     .expected("an angle (deg)")
    ///     .hint("state `decimal = \",\"`");
    /// let lines = [
    ///     "error: `10,5` is not a number",
    ///     "  --> joints.csv:7",
    ///     "    7 | 3;10,5",
    ///     "  expected: an angle (deg)\n",
    ///     "hint: state `decimal = \",\"`",
    /// ];
    /// assert_eq!(message.to_string(), lines.join("\n"));
    /// ```
    pub fn error(what: impl Into<String>) -> Self {
        let (severity, rank) = (Severity::Error, Rank::Decide);
        Self { severity, rank, what: what.into(), place: None, expected: None, hint: None }
    }

    /// A warning: the work goes on.
    pub fn warning(what: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, rank: Rank::Know, ..Self::error(what) }
    }

    /// The same message, of which somebody has to act.
    pub fn to_decide(self) -> Self {
        Self { rank: Rank::Decide, ..self }
    }

    /// The same message, stated for completeness.
    pub fn routine(self) -> Self {
        Self { rank: Rank::Routine, ..self }
    }

    /// The same message with its place.
    pub fn at(mut self, place: Place) -> Self {
        self.place = Some(Box::new(place));
        self
    }

    /// The same message with what was expected.
    pub fn expected(mut self, expected: impl Into<String>) -> Self {
        self.expected = Some(expected.into());
        self
    }

    /// The same message with a hint.
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// A hint that proposes the nearest of the names that exist, or lists them.
    pub fn hint_names<'a>(self, wrong: &str, names: impl IntoIterator<Item = &'a str>) -> Self {
        let names: Vec<&str> = names.into_iter().collect();
        match nearest(wrong, names.iter().copied()) {
            Some(name) => match other_unit(wrong, name) {
                Some(unit) => self.hint(format!("`{name}` is meant in another unit: {unit}")),
                None => self.hint(format!("did you mean `{name}`?")),
            },
            None if names.is_empty() => self,
            None => {
                let more = if names.len() > 12 { ", ..." } else { "" };
                self.hint(format!("there are: {}{more}", names[..names.len().min(12)].join(", ")))
            }
        }
    }
}

/// Units of names, by what is measured: mm, rad.
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

/// How the units of two names differ that differ in nothing else: "1 rad is 57.29577951 deg".
fn other_unit(wrong: &str, name: &str) -> Option<String> {
    let split = |name: &str| {
        let (stem, unit) = name.rsplit_once('_')?;
        Some((stem.to_owned(), UNITS.into_iter().find(|u| u.0 == unit)?))
    };
    let ((stem, from), (other, to)) = (split(wrong)?, split(name)?);
    let factor = (1e8 * from.1 / to.1).round() / 1e8;
    (stem == other && from.0 != to.0 && from.2 == to.2).then(|| format!("1 {} is {factor} {}", from.0, to.0))
}

/// Lines of a file that a message may be repeated in before one takes the place of the others.
const LISTED: usize = 3;

/// A message without what differs from row to row: names between backticks, and numbers.
fn shape(what: &str) -> String {
    let outside = what.split('`').step_by(2).collect::<Vec<_>>().join("`");
    outside.chars().filter(|c| !c.is_ascii_digit() && !"+-.".contains(*c)).collect()
}

/// `1 row`, `2 rows`.
pub fn count(n: usize, noun: &str) -> String {
    let plural = if noun.ends_with("ss") { "es" } else { "s" };
    format!("{n} {noun}{}", if n == 1 { "" } else { plural })
}

/// Longer ones are not compared with others, bytes.
const LONGEST_NAME: usize = 200;

/// The name that `wrong` may be meant as, if one is like it.
pub fn nearest<'a>(wrong: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if wrong.len() > LONGEST_NAME {
        return None;
    }
    let likeness = names.into_iter().map(|name| (strsim::jaro_winkler(wrong, name), name));
    likeness.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(likeness, _)| *likeness > 0.8).map(|(_, name)| name)
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = match self.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        write!(f, "{kind}: {}", printable(&self.what))?;
        if let Some(place) = &self.place {
            write!(f, "\n  --> {}", printable(&place.file))?;
            if let Some(line) = place.line {
                write!(f, ":{line}")?;
            }
            if let Some(column) = place.column {
                write!(f, ":{column}")?;
            }
            if let (Some(line), Some(text)) = (place.line, &place.text) {
                write!(f, "\n{line:>5} | {}", printable(&one_line(text)))?;
                if let Some(column) = place.column {
                    let marks = "^".repeat(place.width.clamp(1, 60));
                    write!(f, "\n      | {}{marks}", " ".repeat(column.saturating_sub(1).min(200)))?;
                }
            }
        }
        if let Some(expected) = &self.expected {
            write!(f, "\n  expected: {}", printable(expected))?;
        }
        if let Some(hint) = &self.hint {
            write!(f, "\n\nhint: {}", printable(hint))?;
        }
        Ok(())
    }
}

/// A character as it may reach a terminal within a line: controls are replaced, and marks that turn the way a text reads
/// (UAX #9), with which a name leaves its place.
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

/// Everything that is wrong, found in one pass: what a stage returns instead of its document.
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

    /// The value of a result; its problems are added to these.
    pub fn keep<T>(&mut self, result: Result<T>) -> Option<T> {
        result.map_err(|more| self.0.extend(more.0)).ok()
    }

    /// The same messages, with one in place of those that are repeated in more than three rows of a file of data: the first, with the
    /// next two lines and how many more there are. Names and numbers in a message may differ. Statements are no rows, and neither are
    /// several messages about one line.
    pub fn grouped(self) -> Self {
        let mut lines: BTreeMap<(String, String), Vec<usize>> = BTreeMap::new();
        let key = |message: &Message| {
            let place = message.place.as_ref()?;
            Some(((place.file.clone(), shape(&message.what)), place.line?))
        };
        for (key, line) in self.0.iter().filter_map(key) {
            lines.entry(key).or_default().push(line);
        }
        // several cells of a row are one row
        lines.values_mut().for_each(|lines| lines.dedup());
        lines.retain(|(file, _), lines| {
            let distinct = lines.iter().collect::<BTreeSet<_>>().len() == lines.len();
            lines.len() > LISTED && distinct && !file.ends_with(".toml")
        });
        let mut messages = self.0;
        messages.retain_mut(|message| {
            let Some((key, _)) = key(message) else { return true };
            let Some(lines) = lines.get_mut(&key) else { return true };
            // the first takes the lines of the rest
            let [_, second, third, rest @ ..] = &std::mem::take(lines)[..] else { return false };
            let more = count(rest.len(), "more row");
            message.what.push_str(&format!("; also in lines {second}, {third} and {more}"));
            true
        });
        Self(messages)
    }

    /// The same messages, [`grouped`](Self::grouped), about this file and its text, where they name no other file: the line that they
    /// name is shown.
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

    /// The same messages, at this place where they have none, and in its file where they have a line alone.
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
    fn a_span_is_shown_with_its_line_and_a_hint() {
        let source = "name = \"x\"\nrobto = 1\n";
        let message = Message::error("unknown key `robto`")
            .at(Place::span("campaign.toml", source, 11..16))
            .hint_names("robto", ["robot", "name"]);
        let text = "error: unknown key `robto`\n  --> campaign.toml:2:1\n    2 | robto = 1\n      | ^^^^^\n\nhint: did you mean `robot`?";
        assert_eq!(message.to_string(), text);
    }

    #[test]
    fn a_message_that_every_row_repeats_is_one_with_its_count() {
        let row = |line: usize| {
            Message::error(format!("`v{line}` is not a number")).at(Place::line("a.csv", line, format!("v{line}")))
        };
        let other = Message::error("`a.csv` has 12000 rows");
        let all =
            |rows: usize| Problems((2..2 + rows).map(row).chain([other.clone(), other.clone()]).collect()).grouped();
        assert_eq!(all(3).0.len(), 3 + 2);
        let grouped = all(11_993);
        assert_eq!(grouped.0.len(), 1 + 2);
        assert_eq!(grouped.0[0].what, "`v2` is not a number; also in lines 3, 4 and 11990 more rows");
        assert_eq!(grouped.clone().grouped().0, grouped.0);
        assert!(all(4).to_string().contains("also in lines 3, 4 and 1 more row\n"));
        // signs differ as digits do
        let signed = |line: usize| {
            let off = if line.is_multiple_of(2) { "+0.5" } else { "-0.5" };
            Message::warning(format!("off by {off} mm")).at(Place::line("a.csv", line, ""))
        };
        assert_eq!(Problems((1..6).map(signed).collect()).grouped().0.len(), 1);
        // several about one line, and statements
        let columns = |c: usize| Message::error(format!("no column `c{c}`")).at(Place::line("a.csv", 1, ""));
        assert_eq!(Problems((0..9).map(columns).collect()).grouped().0.len(), 9);
        let stated =
            |line: usize| Message::error(format!("`k{line}` is stated twice")).at(Place::line("c.toml", line, ""));
        assert_eq!(Problems((1..9).map(stated).collect()).grouped().0.len(), 8);
        // another file, another message
        let elsewhere = |line: usize| Message::error("is not a number").at(Place::line("b.csv", line, ""));
        assert_eq!(Problems((1..3).map(elsewhere).chain((1..4).map(row)).collect()).grouped().0.len(), 5);
    }

    #[test]
    fn spans_off_the_end_or_inside_a_character_do_no_harm() {
        for span in [(0, 99), (1, 2), (5, 3), (50, 60)] {
            let span = span.0..span.1;
            let _ = Message::error("e").at(Place::span("f", "äöü\nß", span)).to_string();
        }
    }
}
