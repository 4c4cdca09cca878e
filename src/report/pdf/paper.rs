//! The report as a typesetter gets it: sections of paragraphs, tables and pictures, every number already text.

use super::printable::is_checksum;
use crate::document::Presentation;
use crate::report::part::Part;
use crate::report::points::Picture;
use crate::report::words::Words;
use serde::Serialize;

/// A whole report.
#[derive(Debug, Serialize)]
pub(super) struct Paper {
    pub title: String,
    pub subtitle: String,
    /// why the data are none of a robot's
    pub synthetic: Option<String>,
    pub date: Option<String>,
    pub version: String,
    pub labels: Labels,
    pub verdict: Verdict,
    pub sections: Vec<Section>,
    /// what is too long to stand between a reader and the signature
    pub annexes: Vec<Section>,
}

/// What the layout itself says, and in which language.
#[derive(Debug, Serialize)]
pub(super) struct Labels {
    pub lang: &'static str,
    pub synthetic: String,
    /// with places `{0}` and `{1}`
    pub page: String,
    /// what the file `logo` is; absent without one
    pub logo: Option<String>,
    pub signatures: String,
    /// who signs
    pub signs: [String; 2],
    pub line: String,
    /// what is not translated; empty in English
    pub note: String,
}

impl Labels {
    pub fn of(presentation: &Presentation, words: &Words) -> Self {
        let note = words.say("Numbers have a decimal point; texts of the campaign and messages of the program are in their own language.");
        let lang = presentation.language.code();
        Self {
            lang,
            synthetic: words.say("Synthetic data:"),
            page: words.say("page {0} of {1}"),
            logo: presentation.logo.as_ref().map(|_| words.say("Logo of the laboratory")),
            signatures: words.say("Signatures"),
            signs: [words.say("Tested by"), words.say("Approved by")],
            line: words.say("name, date, signature"),
            note: if lang == "en" { String::new() } else { note },
        }
    }
}

/// What a reader wants to know first.
#[derive(Debug, Serialize)]
pub(super) struct Verdict {
    /// `good`, `bad` or `open`
    pub class: &'static str,
    pub sentences: Vec<String>,
    /// what the headlines are about
    pub about: String,
    /// quantity, before, after, unit
    pub headlines: Vec<[String; 4]>,
}

/// A section; `id` names it for templates.
#[derive(Debug, Serialize)]
pub(super) struct Section {
    pub id: &'static str,
    pub title: String,
    pub blocks: Vec<Block>,
}

/// What a section is made of.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(super) enum Block {
    Heading {
        text: String,
    },
    Paragraph {
        text: String,
        strong: bool,
    },
    Note {
        text: String,
    },
    /// one warning or error
    Message {
        class: &'static str,
        lines: Vec<String>,
    },
    /// what, and what is said of it
    Facts {
        rows: Vec<[String; 2]>,
    },
    Table(Table),
    Pictures {
        pictures: Vec<Drawing>,
    },
}

/// A table; columns of numbers stand at the right.
#[derive(Debug, Serialize)]
pub(super) struct Table {
    /// titles above several columns, and how many; empty without such
    pub groups: Vec<(String, usize)>,
    pub header: Vec<String>,
    pub numeric: Vec<bool>,
    /// columns that share the width which others leave: texts that need more than a line, and all below a common title
    pub fluid: Vec<bool>,
    /// it fits on part of a page
    pub short: bool,
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// Letters that a column of a table may be wide before it takes a share of what others leave.
    const WIDE: usize = 22;
    /// Rows and letters of a table that is not torn apart.
    const SHORT: (usize, usize) = (15, 2000);

    fn new(header: Vec<String>, numeric: Vec<bool>, rows: Vec<Vec<String>>) -> Self {
        let letters = |cell: &String| cell.chars().count();
        let widest = |i: usize| rows.iter().filter_map(|row| row.get(i)).map(letters).max().unwrap_or(0);
        let stays = |i: usize| rows.iter().filter_map(|row| row.get(i)).any(|cell| is_checksum(cell));
        let fluid = (0..header.len()).map(|i| !numeric[i] && widest(i) > Self::WIDE && !stays(i)).collect();
        let all = rows.iter().flatten().map(letters).sum::<usize>();
        let short = rows.len() <= Self::SHORT.0 && all <= Self::SHORT.1;
        Self { groups: vec![], header, numeric, fluid, short, rows }
    }
}

/// A picture.
#[derive(Debug, Serialize)]
pub(super) struct Drawing {
    pub title: String,
    pub caption: String,
    pub wide: bool,
    pub svg: String,
}

impl Section {
    /// A section, if there is anything in it.
    pub fn of(id: &'static str, title: String, blocks: Vec<Block>) -> Option<Self> {
        (!blocks.is_empty()).then_some(Self { id, title, blocks })
    }
}

impl Block {
    pub fn heading(text: impl Into<String>) -> Self {
        Self::Heading { text: text.into() }
    }

    pub fn text(text: impl Into<String>) -> Self {
        Self::Paragraph { text: text.into(), strong: false }
    }

    pub fn strong(text: impl Into<String>) -> Self {
        Self::Paragraph { text: text.into(), strong: true }
    }

    pub fn note(text: impl Into<String>) -> Self {
        Self::Note { text: text.into() }
    }

    /// A table with one line of titles: `#` before one marks a column of numbers.
    pub fn table<R: IntoIterator<Item = String>>(
        words: &Words,
        titles: &[&str],
        rows: impl IntoIterator<Item = R>,
    ) -> Self {
        Self::grouped(words, &[], titles, rows)
    }

    /// The same with titles above several columns.
    pub fn grouped<R: IntoIterator<Item = String>>(
        words: &Words,
        groups: &[(&str, usize)],
        titles: &[&str],
        rows: impl IntoIterator<Item = R>,
    ) -> Self {
        let table = Table::new(
            titles.iter().map(|t| words.say(t.trim_start_matches('#'))).collect(),
            titles.iter().map(|t| t.starts_with('#')).collect(),
            rows.into_iter().map(|row| row.into_iter().collect()).collect(),
        );
        if groups.is_empty() {
            return Self::Table(table);
        }
        let fluid = groups.iter().flat_map(|(title, columns)| vec![!title.is_empty(); *columns]).collect();
        let groups = groups.iter().map(|(title, columns)| (words.say(title), *columns)).collect();
        Self::Table(Table { groups, fluid, ..table })
    }

    /// What the HTML page shows of a piece of a section.
    pub fn part(part: Part) -> Vec<Self> {
        let mut blocks = Vec::new();
        blocks.extend((!part.heading.is_empty()).then(|| Self::heading(part.heading)));
        blocks.extend((!part.strong.is_empty()).then(|| Self::strong(part.strong)));
        blocks.extend(part.sentences.into_iter().map(Self::text));
        blocks.extend((!part.note.is_empty()).then(|| Self::note(part.note)));
        if !part.rows.is_empty() {
            let (header, numeric) = part.columns.into_iter().map(|c| (c.title, c.number)).unzip();
            blocks.push(Self::Table(Table::new(header, numeric, part.rows)));
        }
        let said = part.conventions.join("; ");
        blocks.extend((!said.is_empty()).then(|| Self::note(format!("{said}."))));
        blocks.extend(Self::pictures(part.pictures));
        blocks
    }

    /// The pictures of the HTML page, with the style that it has there.
    pub fn pictures(pictures: Vec<Picture>) -> Option<Self> {
        let drawing = |p: Picture| Drawing { svg: styled(&p.svg), title: p.title, caption: p.caption, wide: p.wide };
        (!pictures.is_empty()).then(|| Self::Pictures { pictures: pictures.into_iter().map(drawing).collect() })
    }
}

/// An inline picture as a file of its own.
pub(super) fn styled(svg: &str) -> String {
    const STYLE: &str = concat!(
        "<style>text { font-family: 'Libertinus Serif'; font-size: 12px }\n",
        include_str!("../picture.css"),
        "</style>"
    );
    match svg.split_once('>') {
        Some((open, rest)) => format!("{open} xmlns=\"http://www.w3.org/2000/svg\">{STYLE}{rest}"),
        None => String::new(),
    }
}
