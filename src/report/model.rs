//! Contents of a report before rendering: sections with paragraphs, tables, figures and notices,
//! all worded and typed.
//!
//! The JSON form of the contents is the input of the templates of page and PDF.

use super::number;
use super::words::{Words, tr};
use etalon_base::catalogue::{Entry, Phrase, entries};
use etalon_base::date::Date;
use etalon_base::message::one_line;
use etalon_base::phrase;
use etalon_base::pose_name::PoseName;
use etalon_documents::Acceptance;
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

/// Maximum number of rows of a table on a page; the workbook and the documents contain all rows.
const ROWS: usize = 500;
/// Maximum number of rows of a table on paper: `most` of `report.typ`.
pub(super) const PAPER_ROWS: usize = 200;
/// Minimum length (characters) of texts whose columns share the width left by other columns.
const LONG: usize = 22;

/// A whole report.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Contents {
    pub title: String,
    pub subtitle: String,
    /// Explanation of synthetic data; empty for measured data.
    pub synthetic: Vec<String>,
    pub date: Option<String>,
    /// Date of issue.
    pub issued: Option<String>,
    /// Date of files without a stated date, from `SOURCE_DATE_EPOCH`.
    #[cfg_attr(not(feature = "pdf"), expect(dead_code, reason = "pages and workbooks print stated dates alone"))]
    #[serde(skip)]
    pub built: Option<Date>,
    /// Mark across every page of a document that must not be used as a certificate.
    pub draft: Option<String>,
    /// Number of the report, shown on every page.
    pub number: Option<String>,
    /// Scope of the results; empty for unsigned reports.
    pub statement: String,
    pub version: String,
    pub verdict: Verdict,
    pub sections: Vec<Section>,
    /// `true` if the report is to be signed.
    pub signed: bool,
    /// `true` if the report has to fit on one page.
    pub compact: bool,
    /// `true` if the terminal omits parts that a page folds.
    #[serde(skip)]
    pub brief: bool,
}

impl Contents {
    /// Gives ids of messages their meaning as a tooltip and a link to their explanation, which
    /// follows the messages; a page that has to fit on one sheet has tooltips only.
    pub fn explained(mut self, words: &Words) -> Self {
        let known: BTreeMap<&str, Entry> =
            entries().into_iter().filter(Entry::is_message).map(|entry| (entry.id, entry)).collect();
        let mut ids = Vec::new();
        for block in self.sections.iter_mut().flat_map(|section| &mut section.blocks) {
            block.explain(&known, !self.compact, &mut ids);
        }
        if ids.is_empty() || self.compact {
            return self;
        }
        let at = self.sections.iter().position(|section| section.id == "messages");
        let at = at.unwrap_or(self.sections.len().saturating_sub(1));
        let blocks = ids.iter().filter_map(|id| Some(Block::text(Text::explanation(known.get(id.as_str())?, words))));
        let title = tr!(words, "explanations-of-messages");
        if let Some(section) = self.sections.get_mut(at) {
            section.push(Block::Aside { title, blocks: blocks.collect() });
        }
        self
    }

    /// Applies a common notation to each column, and the decimal mark of the language to cells and
    /// headlines; sentences and figures contain it already.
    pub fn in_language(mut self, words: &Words) -> Self {
        self.sections.iter_mut().flat_map(|s| &mut s.blocks).for_each(Block::one_notation);
        self.verdict.sentences.iter_mut().for_each(|text| *text = sentence(text));
        if words.number("0.1") == "0.1" {
            return self;
        }
        for headline in &mut self.verdict.headlines {
            (headline.before, headline.after) = (words.number(&headline.before), words.number(&headline.after));
        }
        for section in &mut self.sections {
            section.blocks.iter_mut().for_each(|block| block.numbers(words));
            let cells = section.data.iter_mut().flat_map(|table| table.rows.iter_mut().flatten());
            cells.chain(section.summary.iter_mut().map(|fact| &mut fact.said)).for_each(|cell| cell.numbers(words));
        }
        self
    }
}

/// Adds a capital at the beginning and a full stop at the end.
pub(super) fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    let end =
        if text.ends_with(|c: char| c.is_alphanumeric() || matches!(c, ')' | ']' | '`' | '%')) { "." } else { "" };
    first.chain(letters).chain(end.chars()).collect()
}

/// First box: compliance with all limits, and improvement of the robot.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Verdict {
    pub class: Grade,
    /// Basis of the exit code.
    #[serde(skip)]
    pub met: bool,
    pub sentences: Vec<String>,
    /// Subject of the headlines.
    pub about: String,
    pub headlines: Vec<Headline>,
    /// Limits and headlines in figures.
    pub graphs: Vec<Figure>,
    /// Next steps, the most useful first.
    pub steps: Vec<Step>,
    /// Fields to complete before signing.
    pub to_complete: Option<ToComplete>,
}

/// A next step with its reason.
#[derive(Debug, Serialize)]
pub(crate) struct Step {
    pub what: Text,
    pub reason: Text,
    /// Command to run in the folder of the campaign.
    pub command: Option<String>,
}

/// Fields without which a report is a draft.
#[derive(Debug, Serialize)]
pub(crate) struct ToComplete {
    pub title: String,
    pub fields: Vec<String>,
}

/// Style of a verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Grade {
    Good,
    /// Accepted with a reservation.
    #[serde(rename = "warning")]
    Conditional,
    Bad,
    #[default]
    Open,
}

impl Grade {
    /// Good if `met`, otherwise bad.
    pub fn from_met(met: bool) -> Self {
        if met { Self::Good } else { Self::Bad }
    }

    /// Style of a verdict; open if nothing was judged.
    pub fn from_verdict(verdict: Option<Acceptance>) -> Self {
        match verdict {
            Some(Acceptance::Pass) => Self::Good,
            Some(Acceptance::Conditional) => Self::Conditional,
            Some(Acceptance::Fail) => Self::Bad,
            Some(Acceptance::Undecided) | None => Self::Open,
        }
    }
}

/// A number before and after calibration.
#[derive(Debug, Serialize)]
pub(crate) struct Headline {
    pub what: String,
    pub before: String,
    pub after: String,
    pub unit: &'static str,
    /// Unit of the documents, and both values in it.
    #[serde(skip)]
    pub in_documents: (&'static str, [f64; 2]),
}

/// A section; its `id` names it in links and templates.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Section {
    pub id: String,
    pub title: String,
    pub blocks: Vec<Block>,
    /// Tables for the workbook only.
    #[serde(skip)]
    pub data: Vec<Table>,
    /// Lines of the first sheet of the workbook.
    #[serde(skip)]
    pub summary: Vec<Fact>,
    /// `true` if the terminal shows the section.
    #[serde(skip)]
    pub on_terminal: bool,
    /// `true` for a section behind the evidence: folded on a page, after the signatures on paper.
    pub annex: bool,
}

/// A name with its value.
#[derive(Debug, Serialize)]
pub(crate) struct Fact {
    pub what: String,
    pub said: Cell,
    pub unit: &'static str,
}

/// Part of a section.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(crate) enum Block {
    Heading {
        text: String,
    },
    Text {
        text: Text,
        tone: Tone,
    },
    Facts {
        rows: Vec<Fact>,
    },
    Table(Table),
    Figures {
        figures: Vec<Figure>,
    },
    /// A warning or an error: class, id in the catalogue (empty if absent) and lines.
    Notice {
        class: &'static str,
        id: String,
        lines: Vec<Text>,
    },
    /// Optional reading: folded on a page, in an annex on paper.
    Aside {
        title: String,
        blocks: Vec<Block>,
    },
}

/// Style of a paragraph.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Tone {
    Plain,
    /// Plain, omitted on a brief terminal.
    #[serde(rename = "plain")]
    Detail,
    Strong,
    Note,
}

/// Text of a paragraph or cell: pieces in the report's language, names, and English texts.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(crate) struct Text(Vec<Run>);

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Run {
    text: String,
    mark: Mark,
    /// Tooltip of an id: meaning of the message.
    #[serde(skip_serializing_if = "Option::is_none")]
    tip: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
enum Mark {
    /// Worded by the report.
    Own,
    Name,
    English,
    Code,
    /// A key or a name between backticks in a text.
    #[serde(rename = "code")]
    Key,
    /// Id of a message, which links to its explanation.
    Id,
    /// Id of a message at its explanation.
    Explained,
}

impl Text {
    /// A text; parts between backticks in a sentence are keys or names.
    fn new(text: String, mark: Mark) -> Self {
        let is_sentence = matches!(mark, Mark::Own | Mark::English);
        if !is_sentence || !text.contains('`') || !text.matches('`').count().is_multiple_of(2) {
            return Self(vec![Run { text, mark, tip: None }]);
        }
        let run = |(i, piece): (usize, &str)| Run {
            text: piece.to_owned(),
            mark: if i.is_multiple_of(2) { mark } else { Mark::Key },
            tip: None,
        };
        Self(text.split('`').enumerate().map(run).filter(|run| !run.text.is_empty()).collect())
    }

    /// A name, isolated from its surroundings.
    pub fn name(text: &str) -> Self {
        Self::new(one_line(text), Mark::Name)
    }

    /// A text of a document, in English in every language.
    pub fn english(text: &str) -> Self {
        Self::new(text.to_owned(), Mark::English)
    }

    /// A text of a document in the language of the report; English without a catalogue entry.
    pub fn worded(text: &str, phrase: Option<&Phrase>, words: &Words) -> Self {
        phrase.map_or_else(|| Self::english(text), |phrase| words.tr(phrase).into())
    }

    /// A line of a file, or a checksum.
    pub fn code(text: &str) -> Self {
        Self::new(one_line(text), Mark::Code)
    }

    /// Explanation of a message, in English in every language.
    fn explanation(entry: &Entry, words: &Words) -> Self {
        let of = |text: &str| Self::from(" ").and(Self::english(text));
        let label = |label: String| Self::from(" ").and(label);
        let id = Self::new(entry.id.to_owned(), Mark::Explained);
        id.and(": ")
            .and(Self::english(&entry.meaning))
            .and(of(&entry.reason))
            .and(label(tr!(words, "action-label")).and(of(&entry.action)))
            .and(label(tr!(words, "example-label")).and(of(&entry.example)))
    }

    /// Joins sentences without full stops to one sentence.
    pub fn conventions(all: &[String], phrases: &[Phrase], words: &Words) -> Self {
        let worded = |(i, text): (usize, &String)| Self::worded(text, phrases.get(i), words);
        let joined = all.iter().enumerate().map(worded).reduce(|a, b| a.and("; ").and(b));
        joined.map_or_else(Self::default, |text| text.and("."))
    }

    /// Appends more text.
    pub fn and(mut self, more: impl Into<Self>) -> Self {
        self.0.extend(more.into().0);
        self
    }

    pub fn plain(&self) -> String {
        let shown = |run: &Run| match run.mark {
            Mark::Key => format!("`{}`", run.text),
            _ => run.text.clone(),
        };
        self.0.iter().map(shown).collect()
    }
}

impl From<String> for Text {
    fn from(text: String) -> Self {
        Self::new(text, Mark::Own)
    }
}

impl From<&str> for Text {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

/// A figure; `svg` contains a description for people who cannot see it.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Figure {
    pub title: String,
    pub svg: String,
    pub caption: String,
    /// Caption with the figure's own scale; empty if there is one scale only.
    pub caption_own: String,
    /// Wide figures occupy a whole row.
    pub wide: bool,
    /// Name shared by the figures before and after, and position of this figure; empty for single
    /// figures.
    pub pair: String,
    pub side: &'static str,
    /// Names of the two figures; "before" and "after" if absent.
    pub sides: Option<[String; 2]>,
    /// `true` if marks have a common scale of both figures and a separate one.
    pub scaled: bool,
    /// Numbers of the figure; empty if another table contains them.
    pub table_title: String,
    pub header: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

/// Content of a cell.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    Missing,
    /// Value in the unit of the documents, and text on a page.
    Number {
        value: f64,
        shown: String,
    },
    Count(i64),
    Text(Text),
    /// A term of the report; in English where programs read it.
    Term {
        english: String,
        shown: String,
        strong: bool,
    },
    /// Several numbers in one cell.
    Numbers(String),
}

impl Cell {
    pub fn is_missing(&self) -> bool {
        *self == Self::Missing
    }

    /// Applies the decimal mark of a language.
    fn numbers(&mut self, words: &Words) {
        if let Some(shown) = self.shown_mut() {
            *shown = words.number(shown);
        }
    }

    /// Numbers as shown on a page.
    fn shown_mut(&mut self) -> Option<&mut String> {
        match self {
            Self::Number { value, shown } => {
                if shown.is_empty() {
                    *shown = number::significant(*value, 6);
                }
                Some(shown)
            }
            Self::Numbers(shown) => Some(shown),
            _ => None,
        }
    }

    fn is_number(&self) -> bool {
        matches!(self, Self::Number { .. } | Self::Count(_) | Self::Numbers(_))
    }

    /// Text on a page.
    pub fn shown(&self) -> Text {
        match self {
            Self::Missing => Text::default(),
            Self::Number { value, shown } if shown.is_empty() => number::significant(*value, 6).into(),
            Self::Number { shown, .. } | Self::Numbers(shown) | Self::Term { shown, .. } => shown.as_str().into(),
            Self::Count(value) => value.to_string().into(),
            Self::Text(text) => text.clone(),
        }
    }

    /// Text in a workbook, for cells without a number.
    pub fn plain(&self) -> String {
        self.shown().plain()
    }
}

impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Shown {
            text: Text,
            strong: bool,
        }
        Shown { text: self.shown(), strong: matches!(self, Self::Term { strong: true, .. }) }.serialize(serializer)
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number { value, shown: String::new() }
    }
}

impl From<i64> for Cell {
    fn from(value: i64) -> Self {
        Self::Count(value)
    }
}

impl From<PoseName> for Cell {
    fn from(pose: PoseName) -> Self {
        pose.number().map_or_else(|| Text::from(pose.to_string()).into(), Self::Count)
    }
}

impl From<usize> for Cell {
    fn from(value: usize) -> Self {
        Self::Count(value as i64)
    }
}

impl From<Text> for Cell {
    fn from(text: Text) -> Self {
        if text.0.iter().all(|run| run.text.is_empty()) { Self::Missing } else { Self::Text(text) }
    }
}

impl From<&str> for Cell {
    fn from(name: &str) -> Self {
        Text::new(name.to_owned(), Mark::Name).into()
    }
}

impl From<&String> for Cell {
    fn from(name: &String) -> Self {
        name.as_str().into()
    }
}

impl From<String> for Cell {
    fn from(name: String) -> Self {
        name.as_str().into()
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Missing, Into::into)
    }
}

/// A number with a fixed number of decimals.
pub(crate) fn fixed(value: impl Into<Option<f64>>, decimals: usize) -> Cell {
    shown(value, |v| number::fixed(v, decimals))
}

/// A number with its significant digits.
pub(crate) fn significant(value: impl Into<Option<f64>>, digits: usize) -> Cell {
    shown(value, |v| number::significant(v, digits))
}

/// A number to the second digit of its standard uncertainty.
pub(crate) fn with_uncertainty(value: impl Into<Option<f64>>, u: Option<f64>) -> Cell {
    shown(value, |v| number::with_uncertainty(v, u))
}

/// A length in mm, shown in µm.
pub(crate) fn um(mm: impl Into<Option<f64>>) -> Cell {
    shown(mm, |mm| number::fixed(1e3 * mm, 1))
}

/// A number with its text.
pub(crate) fn shown(value: impl Into<Option<f64>>, text: impl Fn(f64) -> String) -> Cell {
    value.into().map_or(Cell::Missing, |value| Cell::Number { value, shown: text(value) })
}

/// Several numbers; an empty cell without numbers.
pub(crate) fn numbers(shown: impl Into<Option<String>>) -> Cell {
    shown.into().filter(|s| !s.is_empty()).map_or(Cell::Missing, Cell::Numbers)
}

/// A term, translated where people read it.
pub(crate) fn term(words: &Words, term: Phrase) -> Cell {
    Cell::Term { english: term.to_string(), shown: words.tr(&term), strong: false }
}

/// A term in bold letters.
pub(crate) fn strong_term(words: &Words, term: Phrase) -> Cell {
    Cell::Term { english: term.to_string(), shown: words.tr(&term), strong: true }
}

/// "Yes" or "no".
pub(crate) fn yes_no(words: &Words, yes: bool) -> Cell {
    term(words, if yes { phrase!("yes") } else { phrase!("no") })
}

/// "Yes" in bold letters, or "no".
pub(crate) fn strong_yes(words: &Words, yes: bool) -> Cell {
    if yes { strong_term(words, phrase!("yes")) } else { yes_no(words, false) }
}

/// Title of a column: a symbol or name that is the same in all languages, or a text of the
/// catalogue.
#[derive(Clone, Debug)]
pub(crate) enum Title<'a> {
    Symbol(&'a str),
    Text(Phrase),
}

impl Title<'_> {
    fn shown(&self, words: &Words) -> String {
        match self {
            Self::Symbol(symbol) => (*symbol).to_owned(),
            Self::Text(phrase) => words.tr(phrase),
        }
    }
}

impl<'a> From<&'a str> for Title<'a> {
    fn from(symbol: &'a str) -> Self {
        Self::Symbol(symbol)
    }
}

impl From<Phrase> for Title<'_> {
    fn from(phrase: Phrase) -> Self {
        Self::Text(phrase)
    }
}

/// Renderers that show a column.
#[derive(Clone, Copy, Debug, PartialEq)]
enum On {
    Both,
    Page,
    Sheet,
}

/// A column of records of type `T`: title, unit and content.
struct Column<'a, T> {
    title: Title<'a>,
    unit: &'a str,
    shown_in: &'a str,
    group: Title<'a>,
    decisive: bool,
    on: On,
    cell: Box<dyn Fn(&'a T) -> Cell + 'a>,
}

/// The columns of a table.
pub(crate) struct Columns<'a, T>(Vec<Column<'a, T>>);

impl<'a, T> Columns<'a, T> {
    pub fn new() -> Self {
        Self(Vec::new())
    }

    fn with<C: Into<Cell>>(mut self, on: On, title: Title<'a>, unit: &'a str, cell: impl Fn(&'a T) -> C + 'a) -> Self {
        let cell = Box::new(move |record: &'a T| cell(record).into());
        self.0.push(Column { title, unit, shown_in: unit, group: "".into(), decisive: false, on, cell });
        self
    }

    /// Adds a column for all renderers.
    pub fn both<C: Into<Cell>>(
        self,
        title: impl Into<Title<'a>>,
        unit: &'a str,
        cell: impl Fn(&'a T) -> C + 'a,
    ) -> Self {
        self.with(On::Both, title.into(), unit, cell)
    }

    /// Adds a column that the workbook omits, because other columns contain the numbers separately.
    pub fn page<C: Into<Cell>>(
        self,
        title: impl Into<Title<'a>>,
        unit: &'a str,
        cell: impl Fn(&'a T) -> C + 'a,
    ) -> Self {
        self.with(On::Page, title.into(), unit, cell)
    }

    /// Adds a column for the workbook only.
    pub fn sheet<C: Into<Cell>>(
        self,
        title: impl Into<Title<'a>>,
        unit: &'a str,
        cell: impl Fn(&'a T) -> C + 'a,
    ) -> Self {
        self.with(On::Sheet, title.into(), unit, cell)
    }

    /// Adds a column of lengths in mm, shown in µm.
    pub fn micrometres<V: Into<Option<f64>>>(self, title: impl Into<Title<'a>>, mm: impl Fn(&'a T) -> V + 'a) -> Self {
        self.both(title, "mm", move |record| um(mm(record))).shown_in("µm")
    }

    /// Adds a workbook column for each existing coordinate.
    pub fn sheet_xyz(self, titles: [impl Into<Title<'a>>; 3], unit: &'a str, of: fn(&'a T) -> &'a [f64]) -> Self {
        let add = |columns: Self, (i, title)| columns.sheet(title, unit, move |record| of(record).get(i).copied());
        titles.into_iter().enumerate().fold(self, add)
    }

    /// Adds a page column for each angle.
    pub fn page_angles(self, titles: &'a [String], of: fn(&'a T) -> &'a [f64]) -> Self {
        let add = |columns: Self, (i, title): (usize, &'a String)| {
            columns.page(title.as_str(), "deg", move |record| fixed(of(record).get(i).copied(), 4))
        };
        titles.iter().enumerate().fold(self, add)
    }

    /// Adds the columns of another table with these titles to the page.
    pub fn page_columns(mut self, table: Self, titles: &[&str]) -> Self {
        let english = Words::default();
        let shown = table.0.into_iter().filter(|c| titles.contains(&c.title.shown(&english).as_str()));
        self.0.extend(shown.map(|c| Column { on: On::Page, ..c }));
        self
    }

    /// Restricts the columns to the workbook.
    pub fn in_workbook(mut self) -> Self {
        self.0.iter_mut().for_each(|c| c.on = On::Sheet);
        self
    }

    /// Shows the last column in another unit.
    pub fn shown_in(mut self, unit: &'a str) -> Self {
        self.0.iter_mut().rev().take(1).for_each(|c| c.shown_in = unit);
        self
    }

    /// Makes the last column the second one of a page, so that a narrow screen shows it.
    pub fn decisive(mut self) -> Self {
        self.0.iter_mut().rev().take(1).for_each(|c| c.decisive = true);
        self
    }

    /// Adds a common title above the last columns.
    pub fn below(mut self, columns: usize, group: impl Into<Title<'a>>) -> Self {
        let group = group.into();
        self.0.iter_mut().rev().take(columns).for_each(|c| c.group = group.clone());
        self
    }
}

/// A table: columns and typed cells.
#[derive(Debug, Default)]
pub(crate) struct Table {
    /// Name of the sheet of the workbook, if any. Tables of one sheet are placed below each other.
    pub sheet: Option<Phrase>,
    columns: Vec<Titled>,
    pub rows: Vec<Vec<Cell>>,
    /// Number of first columns that are repeated if a page is too narrow.
    lead: usize,
    /// Maximum number of rows on a page.
    most: usize,
    /// `true` if the table is too long for a page, but shown on the terminal.
    pub off_page: bool,
    /// `true` if a brief terminal omits the table.
    pub detail: bool,
}

/// Titles of a column.
#[derive(Clone, Debug)]
struct Titled {
    on: On,
    decisive: bool,
    group: String,
    title: String,
    /// Title in the workbook, with the unit in brackets.
    sheet: String,
    /// Title in the workbook in English, by which a chart finds its columns.
    key: String,
    unit: String,
}

impl Table {
    /// Creates a table with one row per record.
    pub fn new<'a, T: 'a>(
        words: &Words,
        records: impl IntoIterator<Item = &'a T>,
        Columns(columns): Columns<'a, T>,
    ) -> Self {
        let english = Words::default();
        let titled = |c: &Column<T>| {
            let behind = |unit: &str| if unit.is_empty() { String::new() } else { format!(", {unit}") };
            let in_workbook = |words: &Words| {
                let [group, title] = [&c.group, &c.title].map(|title| title.shown(words));
                let before = if group.is_empty() { String::new() } else { format!("{group}, ") };
                let unit = if c.unit.is_empty() { String::new() } else { format!(" [{}]", c.unit) };
                format!("{before}{title}{unit}")
            };
            Titled {
                on: c.on,
                decisive: c.decisive,
                group: c.group.shown(words),
                title: c.title.shown(words) + &behind(c.shown_in),
                sheet: in_workbook(words),
                key: in_workbook(&english),
                unit: c.unit.to_owned(),
            }
        };
        let row = |record: &'a T| columns.iter().map(|c| (c.cell)(record)).collect();
        Self {
            sheet: None,
            columns: columns.iter().map(titled).collect(),
            rows: records.into_iter().map(row).collect(),
            lead: 0,
            most: ROWS,
            off_page: false,
            detail: false,
        }
    }

    /// Limits the number of rows on a page.
    pub fn showing(self, most: usize) -> Self {
        Self { most, ..self }
    }

    /// Shows the table on the terminal instead of a page.
    pub fn not_on_page(self) -> Self {
        Self { off_page: true, ..self }
    }

    /// Omits the table on a brief terminal.
    pub fn detail(self) -> Self {
        Self { detail: true, ..self }
    }

    /// Places the table on a sheet of the workbook.
    pub fn on(self, sheet: Phrase) -> Self {
        Self { sheet: Some(sheet), ..self }
    }

    /// Splits the table if it is too wide, repeating its first columns.
    pub fn repeating(self, lead: usize) -> Self {
        Self { lead, ..self }
    }

    /// Removes columns in which every row is empty.
    pub fn without_empty_columns(mut self) -> Self {
        let kept: Vec<bool> =
            (0..self.columns.len()).map(|i| self.rows.iter().any(|row| !row[i].is_missing())).collect();
        fn keep<T>(all: &mut Vec<T>, kept: &[bool]) {
            let mut kept = kept.iter();
            all.retain(|_| kept.next() == Some(&true));
        }
        keep(&mut self.columns, &kept);
        self.rows.iter_mut().for_each(|row| keep(row, &kept));
        self
    }

    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Index of each column in a workbook, with its title, its English title and its unit.
    pub fn sheet_columns(&self) -> Vec<(usize, [&str; 3])> {
        let all = self.columns.iter().enumerate().filter(|(_, c)| c.on != On::Page);
        all.map(|(i, c)| (i, [c.sheet.as_str(), &c.key, &c.unit])).collect()
    }

    /// Indices of the columns on a page.
    fn on_page(&self) -> Vec<usize> {
        (0..self.columns.len()).filter(|i| self.columns[*i].on != On::Sheet).collect()
    }

    /// `true` if a page shows any part of the table.
    fn is_shown(&self) -> bool {
        !self.off_page && !self.rows.is_empty() && !self.on_page().is_empty()
    }

    /// Layout for the terminal.
    pub fn laid(&self) -> Laid<'_> {
        self.laid_out(self.on_page())
    }

    /// Layout for a page: the deciding column is beside the name.
    fn laid_on_page(&self) -> Laid<'_> {
        let mut places = self.on_page();
        if let Some(i) = places.iter().position(|i| self.columns[*i].decisive).filter(|i| *i > 1) {
            places[1..=i].rotate_right(1);
        }
        self.laid_out(places)
    }

    fn laid_out(&self, places: Vec<usize>) -> Laid<'_> {
        let rows: Vec<Vec<&Cell>> =
            self.rows.iter().take(self.most).map(|row| places.iter().map(|i| &row[*i]).collect()).collect();
        let any = |i: usize, is: &dyn Fn(&Cell) -> bool| rows.iter().any(|row| is(row[i]));
        let letters = |cell: &Cell| cell.plain().chars().count();
        let checksum = |cell: &Cell| is_checksum(&cell.plain());
        let numeric: Vec<bool> = (0..places.len()).map(|i| any(i, &Cell::is_number)).collect();
        let long = |i: usize| !numeric[i] && any(i, &|c| letters(c) > LONG) && !any(i, &checksum);
        let mut groups: Vec<(&str, usize)> = Vec::new();
        for i in &places {
            let group = self.columns[*i].group.as_str();
            match groups.last_mut().filter(|(title, _)| *title == group) {
                Some((_, count)) => *count += 1,
                None => groups.push((group, 1)),
            }
        }
        if groups.iter().all(|(title, _)| title.is_empty()) {
            groups.clear();
        }
        let all: usize = rows.iter().flatten().map(|cell| letters(cell)).sum();
        Laid {
            groups,
            header: places.iter().map(|i| self.columns[*i].title.as_str()).collect(),
            long: (0..places.len()).map(long).collect(),
            short: rows.len() <= 15 && all <= 2000,
            lead: self.lead,
            left_out: self.rows.len() - rows.len(),
            numeric,
            rows,
        }
    }
}

/// `true` for a SHA-256 in hexadecimal digits, which must not be broken, as it is copied.
pub(super) fn is_checksum(word: &str) -> bool {
    word.len() == 64 && word.bytes().all(|b| b.is_ascii_hexdigit())
}

/// Layout of a table on a page.
#[derive(Serialize)]
pub(crate) struct Laid<'a> {
    /// Titles above several columns, with the number of columns; empty if none.
    pub groups: Vec<(&'a str, usize)>,
    pub header: Vec<&'a str>,
    pub numeric: Vec<bool>,
    /// `true` for texts that may need several lines.
    long: Vec<bool>,
    /// `true` if the table fits on part of a page.
    short: bool,
    lead: usize,
    pub rows: Vec<Vec<&'a Cell>>,
    pub left_out: usize,
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.laid_on_page().serialize(serializer)
    }
}

impl Block {
    pub fn heading(text: impl Into<String>) -> Self {
        Self::Heading { text: text.into() }
    }

    pub fn text(text: impl Into<Text>) -> Self {
        Self::Text { text: text.into(), tone: Tone::Plain }
    }

    pub fn detail(text: impl Into<Text>) -> Self {
        Self::Text { text: text.into(), tone: Tone::Detail }
    }

    pub fn strong(text: impl Into<Text>) -> Self {
        Self::Text { text: text.into(), tone: Tone::Strong }
    }

    pub fn note(text: impl Into<Text>) -> Self {
        Self::Text { text: text.into(), tone: Tone::Note }
    }

    /// Facts that have a value.
    pub fn facts(rows: Vec<(String, Cell)>) -> Self {
        let fact = |(what, said): (String, Cell)| Fact { what, said, unit: "" };
        Self::Facts { rows: rows.into_iter().filter(|(_, said)| !said.is_missing()).map(fact).collect() }
    }

    /// Applies a common notation to every column of the tables.
    fn one_notation(&mut self) {
        match self {
            Self::Table(table) => {
                for i in table.on_page() {
                    number::one_notation(table.rows.iter_mut().filter_map(|row| row[i].shown_mut()).collect());
                }
            }
            Self::Figures { figures } => {
                for figure in figures {
                    let columns = figure.rows.iter().map(Vec::len).max().unwrap_or(0);
                    for i in 0..columns {
                        number::one_notation(figure.rows.iter_mut().filter_map(|row| row.get_mut(i)).collect());
                    }
                }
            }
            Self::Aside { blocks, .. } => blocks.iter_mut().for_each(Self::one_notation),
            _ => {}
        }
    }

    /// Applies the decimal mark of a language.
    fn numbers(&mut self, words: &Words) {
        match self {
            Self::Facts { rows } => rows.iter_mut().for_each(|fact| fact.said.numbers(words)),
            Self::Table(table) => table.rows.iter_mut().flatten().for_each(|cell| cell.numbers(words)),
            Self::Aside { blocks, .. } => blocks.iter_mut().for_each(|block| block.numbers(words)),
            Self::Figures { .. } | Self::Heading { .. } | Self::Text { .. } | Self::Notice { .. } => {}
        }
    }

    /// Adds tooltips and links to the ids of notices; `ids` collects them in the order of reading.
    fn explain(&mut self, known: &BTreeMap<&str, Entry>, linked: bool, ids: &mut Vec<String>) {
        match self {
            Self::Aside { blocks, .. } => blocks.iter_mut().for_each(|block| block.explain(known, linked, ids)),
            Self::Notice { id, lines, .. } => {
                let Some(entry) = known.get(id.as_str()) else { return };
                let runs = lines.iter_mut().flat_map(|line| &mut line.0);
                for run in runs.filter(|run| run.mark == Mark::Code && run.text == *id) {
                    run.tip = Some(entry.meaning.replace('`', ""));
                    run.mark = if linked { Mark::Id } else { Mark::Code };
                }
                if !ids.contains(id) {
                    ids.push(id.clone());
                }
            }
            _ => {}
        }
    }

    /// `true` if the block shows nothing.
    fn is_empty(&self) -> bool {
        match self {
            Self::Heading { .. } => false,
            Self::Text { text, .. } => text.plain().is_empty(),
            Self::Facts { rows } => rows.is_empty(),
            Self::Table(table) => !table.is_shown(),
            Self::Figures { figures } => figures.is_empty(),
            Self::Notice { lines, .. } => lines.is_empty(),
            Self::Aside { blocks, .. } => blocks.iter().all(Self::is_empty),
        }
    }
}

impl Section {
    pub fn new(id: impl Into<String>, title: impl Into<String>) -> Self {
        Self { id: id.into(), title: title.into(), ..Self::default() }
    }

    /// Shows the section on the terminal too.
    pub fn on_terminal(self) -> Self {
        Self { on_terminal: true, ..self }
    }

    /// Moves the section behind the evidence.
    pub fn annex(self) -> Self {
        Self { annex: true, ..self }
    }

    /// Inserts a block before all others.
    pub fn begin(&mut self, block: Block) {
        self.blocks.insert(0, block);
    }

    /// Adds a block unless it is empty.
    pub fn push(&mut self, block: Block) {
        match block {
            Block::Table(table) if !table.is_shown() && !table.is_empty() => self.data.push(table),
            Block::Aside { title, blocks } => {
                let mut inner = Self::default();
                blocks.into_iter().for_each(|block| inner.push(block));
                self.data.append(&mut inner.data);
                if !inner.blocks.is_empty() {
                    self.blocks.push(Block::Aside { title, blocks: inner.blocks });
                }
            }
            block if block.is_empty() => {}
            block => self.blocks.push(block),
        }
    }

    /// Adds a table with heading and note, if it has rows.
    pub fn table(&mut self, heading: impl Into<String>, note: impl Into<Text>, table: Table) {
        let heading = heading.into();
        if table.is_shown() {
            if !heading.is_empty() {
                self.push(Block::heading(heading));
            }
            self.push(Block::note(note));
        }
        self.push(Block::Table(table));
    }

    pub fn figures(&mut self, figures: impl IntoIterator<Item = Figure>) {
        self.push(Block::Figures { figures: figures.into_iter().collect() });
    }

    /// Adds a line to the first sheet of the workbook.
    pub fn summarise(&mut self, what: impl Into<String>, said: impl Into<Cell>, unit: &'static str) {
        self.summary.push(Fact { what: what.into(), said: said.into(), unit });
    }

    /// Returns the section unless it is empty.
    pub fn whole(self) -> Option<Self> {
        (!self.blocks.is_empty() || !self.data.is_empty()).then_some(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_between_backticks_is_code_on_a_page_and_stays_as_it_is_in_plain_text() {
        let text = Text::english("log `read_back` has 2 rows of `a`");
        let json = serde_json::to_value(&text).unwrap();
        let marks: Vec<_> = json.as_array().unwrap().iter().map(|run| run["mark"].as_str().unwrap()).collect();
        assert_eq!(marks, ["english", "code", "english", "code"]);
        assert!(!json.to_string().contains('`'), "{json}");
        assert_eq!(text.plain(), "log `read_back` has 2 rows of `a`");
        for odd in ["a ` b", "plain", ""] {
            assert_eq!(Text::from(odd).plain(), odd);
        }
        // a name is kept as it is
        assert_eq!(serde_json::to_value(Text::name("`x`")).unwrap()[0]["text"], "`x`");
    }
}
