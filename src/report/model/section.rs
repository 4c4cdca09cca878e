//! Sections of a report.

use super::block::{Block, Fact, Figure};
use super::cell::Cell;
use super::table::Table;
use super::text::Text;
use serde::Serialize;

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
            Block::Table(table) if !table.is_visible() && !table.is_empty() => self.data.push(table),
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
        if table.is_visible() {
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
