//! Contents of a report before rendering: sections with paragraphs, tables, figures and notices,
//! all worded and typed.
//!
//! The JSON form of the contents is the input of the templates of page and PDF.

mod block;
mod cell;
mod columns;
mod contents;
mod section;
mod table;
mod text;
mod verdict;

pub(crate) use block::{Block, Fact, Figure, Tone};
pub(crate) use cell::{
    Cell, fixed, number_cell, numbers, significant, strong_term, strong_yes, term, um, with_uncertainty, yes_no,
};
pub(crate) use columns::Columns;
pub(crate) use contents::{Contents, Dates, Layout};
pub(crate) use section::Section;
#[cfg(feature = "pdf")]
pub(crate) use table::is_checksum;
pub(crate) use table::{PAPER_ROWS, Table};
pub(crate) use text::Text;
pub(crate) use verdict::{Grade, Headline, Step, StepFile, ToComplete, Verdict, sentence};
