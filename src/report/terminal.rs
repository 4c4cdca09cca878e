//! Report on a terminal: the verdict and, for marked sections, the contents of the page without
//! figures and notes.

use super::model::{Block, Cell, Contents, Table, Tone};
use super::words::{Words, tr};
use etalon_base::message::printable_character;

/// Text for the terminal.
pub(super) fn terminal(contents: &Contents, words: &Words) -> String {
    let mut page = Page { words, brief: contents.layout.brief, text: String::new(), section: None, heading: None };
    page.line(&contents.title);
    contents.verdict.sentences.iter().for_each(|sentence| page.line(sentence));
    page.steps(contents);
    for section in contents.sections.iter().filter(|s| s.on_terminal) {
        (page.section, page.heading) = (Some(section.title.as_str()), None);
        page.blocks(&section.blocks);
        section
            .data
            .iter()
            .filter(|table| !contents.layout.brief && table.off_page)
            .for_each(|table| page.table(table));
    }
    page.text
}

struct Page<'a> {
    words: &'a Words,
    brief: bool,
    text: String,
    /// Titles that wait for contents below them.
    section: Option<&'a str>,
    heading: Option<&'a str>,
}

impl<'a> Page<'a> {
    /// Adds a line without terminal control characters and marks of writing direction.
    fn line(&mut self, text: &str) {
        let marks = ['\u{2068}', '\u{2069}'];
        self.text.extend(text.trim_end().chars().filter(|c| !marks.contains(c)).map(printable_character));
        self.text.push('\n');
    }

    /// Adds the next steps, and the fields to complete before signing.
    fn steps(&mut self, contents: &Contents) {
        let verdict = &contents.verdict;
        if !verdict.steps.is_empty() {
            self.line("");
            self.line(&tr!(self.words, "next-steps"));
        }
        for (i, step) in verdict.steps.iter().enumerate() {
            let command = step.command.as_ref().map_or_else(String::new, |c| format!(" `{c}`"));
            self.line(&format!("{}. {} {}{command}", i + 1, step.what.plain(), step.reason.plain()));
        }
        if let Some(fields) = &verdict.to_complete {
            self.line("");
            self.line(&format!("{}: {}", fields.title, fields.fields.join(", ")));
        }
    }

    fn blocks(&mut self, blocks: &'a [Block]) {
        for block in blocks {
            match block {
                Block::Heading { text } => self.heading = Some(text),
                Block::Text { tone: Tone::Note, .. } | Block::Figures { .. } | Block::Notice { .. } => {}
                Block::Text { tone: Tone::Detail, .. } | Block::Aside { .. } if self.brief => {}
                Block::Text { text, .. } => {
                    self.titles();
                    self.line(&text.plain());
                }
                Block::Facts { rows } => {
                    self.titles();
                    rows.iter().for_each(|f| self.line(&format!("{}: {}", f.what, f.said.display().plain())));
                }
                Block::Table(table) if table.detail && self.brief => {}
                Block::Table(table) => self.table(table),
                Block::Aside { title, blocks } => {
                    self.heading = Some(title);
                    self.blocks(blocks);
                }
            }
        }
    }

    fn titles(&mut self) {
        if let Some(section) = self.section.take() {
            self.line("");
            self.line(section);
        }
        if let Some(heading) = self.heading.take() {
            self.line(heading);
        }
    }

    /// Adds a table without its empty columns: texts at the left, numbers at the right.
    fn table(&mut self, table: &Table) {
        self.titles();
        let laid = table.laid();
        let rows: Vec<Vec<String>> =
            laid.rows.iter().map(|row| row.iter().map(|cell| terminal_text(cell)).collect()).collect();
        let groups: Vec<&str> = laid.groups.iter().flat_map(|(title, count)| vec![*title; *count]).collect();
        let kept: Vec<usize> = (0..laid.header.len()).filter(|i| rows.iter().any(|row| !row[*i].is_empty())).collect();
        let wide = |i: &usize| rows.iter().map(|row| letters(&row[*i])).chain([letters(laid.header[*i])]).max();
        let mut widths: Vec<usize> = kept.iter().filter_map(wide).collect();
        let words = |i: &usize| rows.iter().flat_map(|row| row[*i].split(' ')).map(letters).max().unwrap_or(0);
        let least = |(i, width): (&usize, &usize)| match laid.numeric[*i] {
            true => *width,
            false => words(i).max(letters(laid.header[*i])).max(NARROWEST).min(*width),
        };
        let least: Vec<usize> = kept.iter().zip(&widths).map(least).collect();
        narrow(&mut widths, &least);
        // a title above several columns starts with the first of them
        let title = |i: usize| groups.get(kept[i]).copied().unwrap_or_default();
        let first = |i: usize| i == 0 || title(i - 1) != title(i);
        for i in (0..kept.len()).filter(|i| first(*i)) {
            let last = (i + 1..kept.len()).find(|j| first(*j)).unwrap_or(kept.len());
            let room = widths[i..last].iter().sum::<usize>() + 2 * (last - i - 1);
            widths[i] += letters(title(i)).saturating_sub(room);
        }
        if !groups.is_empty() {
            let mut above = String::new();
            for i in 0..kept.len() {
                let from: usize = widths[..i].iter().map(|w| w + 2).sum();
                if first(i) && !title(i).is_empty() {
                    above += &" ".repeat(from - letters(&above));
                    above += title(i);
                }
            }
            self.line(&above);
        }
        let line = |cells: Vec<&str>| {
            let set = |(k, cell): (usize, &str)| {
                let space = " ".repeat(widths[k].saturating_sub(letters(cell)));
                if laid.numeric[kept[k]] { space + cell } else { cell.to_owned() + &space }
            };
            cells.into_iter().enumerate().map(set).collect::<Vec<_>>().join("  ")
        };
        self.line(&line(kept.iter().map(|i| laid.header[*i]).collect()));
        for row in &rows {
            let cells: Vec<Vec<&str>> = kept.iter().zip(&widths).map(|(i, width)| wrapped(&row[*i], *width)).collect();
            let lines = cells.iter().map(Vec::len).max().unwrap_or(0);
            for k in 0..lines {
                self.line(&line(cells.iter().map(|cell| cell.get(k).copied().unwrap_or_default()).collect()));
            }
        }
        if laid.left_out > 0 {
            self.line(&tr!(self.words, "rows-in-workbook", count = laid.left_out));
        }
    }
}

/// Maximum width of a table; longer texts are wrapped.
const WIDTH: usize = 100;
/// Minimum width of a column whose texts are wrapped.
const NARROWEST: usize = 20;

/// Narrows the widest columns, down to `least`, until the table is not wider than [`WIDTH`]. A
/// table that cannot be this narrow is left as it is.
fn narrow(widths: &mut [usize], least: &[usize]) {
    let table = |widths: &[usize]| widths.iter().sum::<usize>() + 2 * widths.len().saturating_sub(1);
    if table(least) > WIDTH {
        return;
    }
    while table(widths) > WIDTH {
        let widest = (0..widths.len()).filter(|i| widths[*i] > least[*i]).max_by_key(|i| widths[*i]);
        let Some(widest) = widest else { return };
        widths[widest] -= 1;
    }
}

/// Lines of a text, broken between words; a longer word has a line of its own.
fn wrapped(text: &str, width: usize) -> Vec<&str> {
    let (mut lines, mut from, mut end, mut start) = (Vec::new(), 0, 0, 0);
    for word in text.split(' ') {
        if end > from && letters(&text[from..start + word.len()]) > width {
            lines.push(&text[from..end]);
            from = start;
        }
        end = start + word.len();
        start = end + 1;
    }
    lines.push(&text[from..end]);
    lines
}

/// Text of a cell, in capitals instead of bold letters.
fn terminal_text(cell: &Cell) -> String {
    match cell {
        Cell::Term { shown, strong: true, .. } => shown.to_uppercase(),
        cell => cell.display().plain(),
    }
}

fn letters(text: &str) -> usize {
    text.chars().filter(|c| !matches!(c, '\u{2068}' | '\u{2069}')).count()
}
