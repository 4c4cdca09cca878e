//! Parts of a section: paragraphs, facts, tables, figures and notices.

use super::cell::Cell;
use super::table::Table;
use super::text::Text;
use crate::number;
use crate::words::Words;
use etalon_base::catalogue::Entry;
use serde::Serialize;
use std::collections::BTreeMap;

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
    pub(super) fn one_notation(&mut self) {
        match self {
            Self::Table(table) => {
                for i in table.on_page() {
                    number::one_notation(table.rows.iter_mut().filter_map(|row| row[i].display_mut()).collect());
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
    pub(super) fn numbers(&mut self, words: &Words) {
        match self {
            Self::Facts { rows } => rows.iter_mut().for_each(|fact| fact.said.numbers(words)),
            Self::Table(table) => table.rows.iter_mut().flatten().for_each(|cell| cell.numbers(words)),
            Self::Aside { blocks, .. } => blocks.iter_mut().for_each(|block| block.numbers(words)),
            Self::Figures { .. } | Self::Heading { .. } | Self::Text { .. } | Self::Notice { .. } => {}
        }
    }

    /// Adds tooltips and links to the ids of notices; `ids` collects them in the order of reading.
    pub(super) fn explain(&mut self, known: &BTreeMap<&str, Entry>, linked: bool, ids: &mut Vec<String>) {
        match self {
            Self::Aside { blocks, .. } => blocks.iter_mut().for_each(|block| block.explain(known, linked, ids)),
            Self::Notice { id, lines, .. } => {
                let Some(entry) = known.get(id.as_str()) else { return };
                lines.iter_mut().for_each(|line| line.explain(entry, linked));
                if !ids.contains(id) {
                    ids.push(id.clone());
                }
            }
            _ => {}
        }
    }

    /// `true` if the block shows nothing.
    pub(super) fn is_empty(&self) -> bool {
        match self {
            Self::Heading { .. } => false,
            Self::Text { text, .. } => text.plain().is_empty(),
            Self::Facts { rows } => rows.is_empty(),
            Self::Table(table) => !table.is_visible(),
            Self::Figures { figures } => figures.is_empty(),
            Self::Notice { lines, .. } => lines.is_empty(),
            Self::Aside { blocks, .. } => blocks.iter().all(Self::is_empty),
        }
    }
}
