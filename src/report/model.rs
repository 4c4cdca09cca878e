//! What a report is, before anything draws it: sections of paragraphs, tables, figures and notices, all worded and typed.
//!
//! Its JSON is what the templates of the page and of the PDF lay out.

use super::number;
use super::words::Words;
use etalon_base::message::one_line;
use etalon_base::pose_name::PoseName;
use serde::{Serialize, Serializer};

/// Rows of a table that a page shows; the workbook and the documents have all.
pub(super) const ROWS: usize = 500;
/// Characters of a text that takes a share of the width that other columns leave.
const LONG: usize = 22;

/// A whole report.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Contents {
    pub title: String,
    pub subtitle: String,
    /// why the data are synthetic; empty where they are measured
    pub synthetic: Vec<String>,
    pub date: Option<String>,
    /// Number of the report, on every page
    pub number: Option<String>,
    /// To what the results relate; empty where nobody signs them
    pub statement: String,
    pub version: String,
    pub verdict: Verdict,
    pub sections: Vec<Section>,
    /// whether somebody signs it
    pub signed: bool,
    /// whether it has to fit on one page
    pub compact: bool,
    /// whether the terminal leaves out what a page folds
    #[serde(skip)]
    pub brief: bool,
}

impl Contents {
    /// The same in one notation a column and with the decimal mark of a language: in cells, headlines and pictures; sentences have theirs.
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

/// A text with a capital at its beginning and a full stop at its end.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    let end = if text.ends_with(|c: char| c.is_alphanumeric() || c == ')') { "." } else { "" };
    first.chain(letters).chain(end.chars()).collect()
}

/// The first box: is everything met, and how much better is the robot.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Verdict {
    pub class: Grade,
    /// what the exit code follows
    #[serde(skip)]
    pub met: bool,
    pub sentences: Vec<String>,
    /// what the headlines are of
    pub about: String,
    pub headlines: Vec<Headline>,
}

/// How a verdict looks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Grade {
    Good,
    Bad,
    #[default]
    Open,
}

impl Grade {
    /// Good where `met`, bad otherwise.
    pub fn of(met: bool) -> Self {
        if met { Self::Good } else { Self::Bad }
    }
}

/// One number before and after.
#[derive(Debug, Serialize)]
pub(crate) struct Headline {
    pub what: String,
    pub before: String,
    pub after: String,
    pub unit: &'static str,
}

/// A section; its `id` names it in links and for templates.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Section {
    pub id: String,
    pub title: String,
    pub blocks: Vec<Block>,
    /// tables that only the workbook has
    #[serde(skip)]
    pub data: Vec<Table>,
    /// lines of the first sheet of the workbook
    #[serde(skip)]
    pub summary: Vec<Fact>,
    /// whether the terminal shows it
    #[serde(skip)]
    pub on_terminal: bool,
}

/// A line of facts: a name and its value.
#[derive(Debug, Serialize)]
pub(crate) struct Fact {
    pub what: String,
    pub said: Cell,
    pub unit: &'static str,
}

/// What a section is made of.
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
    /// a warning or an error: its class, and its lines
    Notice {
        class: &'static str,
        lines: Vec<Text>,
    },
    /// what only some readers want: folded on a page, an annex on paper
    Aside {
        title: String,
        blocks: Vec<Block>,
    },
}

/// How a paragraph is set.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Tone {
    Plain,
    /// plain, and left out where a terminal is brief
    #[serde(rename = "plain")]
    Detail,
    Strong,
    Note,
}

/// A paragraph, or the text of a cell: pieces in the report's language, names, and texts that are always English.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(crate) struct Text(Vec<Run>);

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Run {
    text: String,
    mark: Mark,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
enum Mark {
    /// worded by the report
    Own,
    Name,
    English,
    Code,
}

impl Text {
    fn of(text: String, mark: Mark) -> Self {
        Self(vec![Run { text, mark }])
    }

    /// A name, kept apart from its surroundings.
    pub fn name(text: &str) -> Self {
        Self::of(one_line(text), Mark::Name)
    }

    /// A text of a document, English in every language.
    pub fn english(text: &str) -> Self {
        Self::of(text.to_owned(), Mark::English)
    }

    /// A text of a document in the language of the report; one without translation is marked as English.
    pub fn document(text: &str, words: &Words) -> Self {
        words.of_document(text).map_or_else(|| Self::english(text), Self::from)
    }

    /// A line of a file, or a checksum.
    pub fn code(text: &str) -> Self {
        Self::of(one_line(text), Mark::Code)
    }

    /// Sentences without full stop as one sentence.
    pub fn conventions(all: &[String], words: &Words) -> Self {
        let joined = all.iter().map(|c| Self::document(c, words)).reduce(|a, b| a.and("; ").and(b));
        joined.map_or_else(Self::default, |text| text.and("."))
    }

    /// The same with more behind it.
    pub fn and(mut self, more: impl Into<Self>) -> Self {
        self.0.extend(more.into().0);
        self
    }

    pub fn plain(&self) -> String {
        self.0.iter().map(|run| run.text.as_str()).collect()
    }
}

impl From<String> for Text {
    fn from(text: String) -> Self {
        Self::of(text, Mark::Own)
    }
}

impl From<&str> for Text {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

/// A picture, made once; `svg` describes it to those who cannot see it.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Figure {
    pub title: String,
    pub svg: String,
    pub caption: String,
    /// wide figures get a row of their own
    pub wide: bool,
    /// name that the figures before and after share, and which of them this is; empty where there is no other
    pub pair: String,
    pub side: &'static str,
    /// what the two are called; "before" and "after" where this is absent
    pub sides: Option<[&'static str; 2]>,
    /// its colours have a scale that both figures share, and one of its own
    pub scaled: bool,
    /// the numbers behind it; empty where another table has them
    pub table_title: String,
    pub header: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

/// The content of a cell.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    Missing,
    /// in the unit of the documents, and as a page shows it
    Number {
        value: f64,
        shown: String,
    },
    Count(i64),
    Text(Text),
    /// a term of the report: English where programs read it
    Term {
        english: String,
        shown: String,
        strong: bool,
    },
    /// several numbers in one cell
    Numbers(String),
}

impl Cell {
    pub fn is_missing(&self) -> bool {
        *self == Self::Missing
    }

    /// With the decimal mark of a language.
    fn numbers(&mut self, words: &Words) {
        if let Some(shown) = self.shown_mut() {
            *shown = words.number(shown);
        }
    }

    /// The numbers as a page shows them.
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

    /// What a page shows.
    pub fn shown(&self) -> Text {
        match self {
            Self::Missing => Text::default(),
            Self::Number { value, shown } if shown.is_empty() => number::significant(*value, 6).into(),
            Self::Number { shown, .. } | Self::Numbers(shown) | Self::Term { shown, .. } => shown.as_str().into(),
            Self::Count(value) => value.to_string().into(),
            Self::Text(text) => text.clone(),
        }
    }

    /// What a workbook holds where it holds no number.
    pub fn plain(&self) -> String {
        match self {
            Self::Term { english, .. } => english.clone(),
            _ => self.shown().plain(),
        }
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
        Text::of(name.to_owned(), Mark::Name).into()
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

/// Millimetres, shown in micrometres.
pub(crate) fn um(mm: impl Into<Option<f64>>) -> Cell {
    shown(mm, |mm| number::fixed(1e3 * mm, 1))
}

/// A number and how it is shown.
pub(crate) fn shown(value: impl Into<Option<f64>>, text: impl Fn(f64) -> String) -> Cell {
    value.into().map_or(Cell::Missing, |value| Cell::Number { value, shown: text(value) })
}

/// Several numbers, of which nothing is shown where there are none.
pub(crate) fn numbers(shown: impl Into<Option<String>>) -> Cell {
    shown.into().filter(|s| !s.is_empty()).map_or(Cell::Missing, Cell::Numbers)
}

/// A term, translated where people read it.
pub(crate) fn term(words: &Words, english: &str) -> Cell {
    Cell::Term { english: english.to_owned(), shown: words.say(english), strong: false }
}

/// The same, in bold letters.
pub(crate) fn strong_term(words: &Words, english: &str) -> Cell {
    Cell::Term { english: english.to_owned(), shown: words.say(english), strong: true }
}

/// Who shows a column.
#[derive(Clone, Copy, Debug, PartialEq)]
enum On {
    Both,
    Page,
    Sheet,
}

/// A column of records of type `T`: title, unit and content.
struct Column<'a, T> {
    title: &'a str,
    unit: &'a str,
    shown_in: &'a str,
    group: &'a str,
    on: On,
    cell: Box<dyn Fn(&'a T) -> Cell + 'a>,
}

/// The columns of a table.
pub(crate) struct Columns<'a, T>(Vec<Column<'a, T>>);

impl<'a, T> Columns<'a, T> {
    pub fn new() -> Self {
        Self(Vec::new())
    }

    fn with<C: Into<Cell>>(mut self, on: On, title: &'a str, unit: &'a str, cell: impl Fn(&'a T) -> C + 'a) -> Self {
        let cell = Box::new(move |record: &'a T| cell(record).into());
        self.0.push(Column { title, unit, shown_in: unit, group: "", on, cell });
        self
    }

    /// With a column of every face.
    pub fn both<C: Into<Cell>>(self, title: &'a str, unit: &'a str, cell: impl Fn(&'a T) -> C + 'a) -> Self {
        self.with(On::Both, title, unit, cell)
    }

    /// With a column that the workbook leaves out: it has the numbers one by one.
    pub fn page<C: Into<Cell>>(self, title: &'a str, unit: &'a str, cell: impl Fn(&'a T) -> C + 'a) -> Self {
        self.with(On::Page, title, unit, cell)
    }

    /// With a column of the workbook alone; its title is English in every language, so that programs find it.
    pub fn sheet<C: Into<Cell>>(self, title: &'a str, unit: &'a str, cell: impl Fn(&'a T) -> C + 'a) -> Self {
        self.with(On::Sheet, title, unit, cell)
    }

    /// With a column of lengths in millimetres, shown in micrometres.
    pub fn micrometres<V: Into<Option<f64>>>(self, title: &'a str, mm: impl Fn(&'a T) -> V + 'a) -> Self {
        self.both(title, "mm", move |record| um(mm(record))).shown_in("µm")
    }

    /// With a column of the workbook for each coordinate, where there is one.
    pub fn sheet_xyz(self, titles: [&'a str; 3], unit: &'a str, of: fn(&'a T) -> &'a [f64]) -> Self {
        let add = |columns: Self, (i, title)| columns.sheet(title, unit, move |record| of(record).get(i).copied());
        titles.into_iter().enumerate().fold(self, add)
    }

    /// With a column of a page for each of these angles.
    pub fn page_angles(self, titles: &'a [String], of: fn(&'a T) -> &'a [f64]) -> Self {
        let add = |columns: Self, (i, title): (usize, &'a String)| {
            columns.page(title, "deg", move |record| fixed(of(record).get(i).copied(), 4))
        };
        titles.iter().enumerate().fold(self, add)
    }

    /// With some of the columns of another table, by their titles, on a page.
    pub fn page_of(mut self, table: Self, titles: &[&str]) -> Self {
        let shown = table.0.into_iter().filter(|c| titles.contains(&c.title));
        self.0.extend(shown.map(|c| Column { on: On::Page, ..c }));
        self
    }

    /// These columns in the workbook alone.
    pub fn in_workbook(mut self) -> Self {
        self.0.iter_mut().for_each(|c| c.on = On::Sheet);
        self
    }

    /// The last column shown in another unit than that of the documents.
    pub fn shown_in(mut self, unit: &'a str) -> Self {
        self.0.iter_mut().rev().take(1).for_each(|c| c.shown_in = unit);
        self
    }

    /// The last columns below a title of their own.
    pub fn below(mut self, columns: usize, group: &'a str) -> Self {
        self.0.iter_mut().rev().take(columns).for_each(|c| c.group = group);
        self
    }
}

/// A table: its columns, and typed cells.
#[derive(Debug, Default)]
pub(crate) struct Table {
    /// its sheet of the workbook; empty where it has none. Tables of one sheet stand below each other
    pub sheet: &'static str,
    columns: Vec<Titled>,
    pub rows: Vec<Vec<Cell>>,
    /// columns that are repeated where a page is too narrow for all
    lead: usize,
    /// rows that a page shows
    most: usize,
    /// too long for a page: the terminal shows what a page would
    pub off_page: bool,
    /// whether a brief terminal leaves it out
    pub detail: bool,
}

/// The titles of a column.
#[derive(Clone, Debug)]
struct Titled {
    on: On,
    group: String,
    title: String,
    /// of the workbook: English, the unit in brackets
    sheet: String,
    unit: String,
}

impl Table {
    /// One row for each record.
    pub fn of<'a, T: 'a>(
        words: &Words,
        records: impl IntoIterator<Item = &'a T>,
        Columns(columns): Columns<'a, T>,
    ) -> Self {
        let titled = |c: &Column<T>| {
            let behind = |unit: &str| if unit.is_empty() { String::new() } else { format!(", {unit}") };
            let before = if c.group.is_empty() { String::new() } else { format!("{}, ", c.group) };
            let unit = if c.unit.is_empty() { String::new() } else { format!(" [{}]", c.unit) };
            Titled {
                on: c.on,
                group: words.say(c.group),
                title: words.say(c.title) + &behind(c.shown_in),
                sheet: format!("{before}{}{unit}", c.title),
                unit: c.unit.to_owned(),
            }
        };
        let row = |record: &'a T| columns.iter().map(|c| (c.cell)(record)).collect();
        Self {
            sheet: "",
            columns: columns.iter().map(titled).collect(),
            rows: records.into_iter().map(row).collect(),
            lead: 0,
            most: ROWS,
            off_page: false,
            detail: false,
        }
    }

    /// The same, of which a page shows the first rows.
    pub fn showing(self, most: usize) -> Self {
        Self { most, ..self }
    }

    /// The same, on the terminal instead of a page.
    pub fn not_on_page(self) -> Self {
        Self { off_page: true, ..self }
    }

    /// The same, left out where a terminal is brief.
    pub fn detail(self) -> Self {
        Self { detail: true, ..self }
    }

    /// The same with a sheet of the workbook.
    pub fn on(self, sheet: &'static str) -> Self {
        Self { sheet, ..self }
    }

    /// The same, torn where it is too wide, its first columns repeated.
    pub fn repeating(self, lead: usize) -> Self {
        Self { lead, ..self }
    }

    /// The same without the columns in which every row is empty.
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

    /// Places, titles and units of the columns that a workbook holds.
    pub fn sheet_columns(&self) -> Vec<(usize, &str, &str)> {
        let all = self.columns.iter().enumerate().filter(|(_, c)| c.on != On::Page);
        all.map(|(i, c)| (i, c.sheet.as_str(), c.unit.as_str())).collect()
    }

    /// The columns that a page shows.
    fn on_page(&self) -> Vec<usize> {
        (0..self.columns.len()).filter(|i| self.columns[*i].on != On::Sheet).collect()
    }

    /// Whether a page shows any of it.
    fn is_shown(&self) -> bool {
        !self.off_page && !self.rows.is_empty() && !self.on_page().is_empty()
    }

    /// As a page or the terminal lays it out.
    pub fn laid(&self) -> Laid<'_> {
        let places = self.on_page();
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

/// A picture with the decimal mark of a language in its texts.
fn svg_numbers(svg: &str, words: &Words) -> String {
    let piece = |piece: &str| match piece.split_once('<') {
        Some((text, tag)) if text.contains('.') => format!("{}<{tag}", words.value(text.to_owned())),
        _ => piece.to_owned(),
    };
    svg.split('>').map(piece).collect::<Vec<_>>().join(">")
}

/// SHA-256 in hexadecimal: it is copied, never broken.
pub(super) fn is_checksum(word: &str) -> bool {
    word.len() == 64 && word.bytes().all(|b| b.is_ascii_hexdigit())
}

/// A table as a page lays it out.
#[derive(Serialize)]
pub(crate) struct Laid<'a> {
    /// titles above several columns, and how many; empty without such
    pub groups: Vec<(&'a str, usize)>,
    pub header: Vec<&'a str>,
    pub numeric: Vec<bool>,
    /// texts that may need more than a line
    long: Vec<bool>,
    /// it fits on part of a page
    short: bool,
    lead: usize,
    pub rows: Vec<Vec<&'a Cell>>,
    pub left_out: usize,
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.laid().serialize(serializer)
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

    /// Every column of its tables in one notation.
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

    /// With the decimal mark of a language.
    fn numbers(&mut self, words: &Words) {
        match self {
            Self::Facts { rows } => rows.iter_mut().for_each(|fact| fact.said.numbers(words)),
            Self::Table(table) => table.rows.iter_mut().flatten().for_each(|cell| cell.numbers(words)),
            Self::Aside { blocks, .. } => blocks.iter_mut().for_each(|block| block.numbers(words)),
            Self::Figures { figures } => {
                for figure in figures {
                    figure.rows.iter_mut().flatten().for_each(|value| *value = words.value(std::mem::take(value)));
                    figure.svg = svg_numbers(&figure.svg, words);
                }
            }
            Self::Heading { .. } | Self::Text { .. } | Self::Notice { .. } => {}
        }
    }

    /// Whether it shows nothing.
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

    /// The section, shown on the terminal as well.
    pub fn on_terminal(self) -> Self {
        Self { on_terminal: true, ..self }
    }

    /// Puts a block before all others.
    pub fn begin(&mut self, block: Block) {
        self.blocks.insert(0, block);
    }

    /// Adds what is not empty.
    pub fn push(&mut self, block: Block) {
        match block {
            Block::Table(table) if !table.is_shown() && !table.is_empty() => self.data.push(table),
            block if block.is_empty() => {}
            block => self.blocks.push(block),
        }
    }

    /// Adds a table below its heading and note, if it has rows.
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

    /// A line of the first sheet of the workbook.
    pub fn summarise(&mut self, what: impl Into<String>, said: impl Into<Cell>, unit: &'static str) {
        self.summary.push(Fact { what: what.into(), said: said.into(), unit });
    }

    /// The section, if a reader finds anything in it.
    pub fn whole(self) -> Option<Self> {
        (!self.blocks.is_empty() || !self.data.is_empty()).then_some(self)
    }
}
