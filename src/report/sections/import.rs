//! Imported rows, and all rows that were rejected or unmatched.

use super::provenance::below_variable;
use crate::model::{Block, Columns, Section, Table, Text, term};
use crate::words::{Words, isolated, names, tr};
use etalon_base::message::one_line;
use etalon_base::phrase;
use etalon_documents::{Refused, Results, Source, Unmatched};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let mut section = Section::new("import", tr!(words, "import"));
    section.push(Block::Table(sources(&results.import.sources, words)));
    for source in results.import.sources.iter().filter(|s| !s.refused.is_empty()) {
        let file = isolated(&one_line(below_variable(&source.file)));
        let title = tr!(words, "refused-rows", refused = source.refused.len(), total = file);
        let columns = Columns::<Refused>::new()
            .sheet(phrase!("file"), "", |_| source.file.as_str())
            .both(phrase!("line"), "", |r| r.line)
            .both(phrase!("reason"), "", |r| Text::worded(&r.reason, words))
            .both(phrase!("text"), "", |r| Text::code(&r.text));
        let table = Table::new(words, &source.refused, columns).on(phrase!("sheet-refused-rows"));
        section.push(Block::Aside { title, blocks: vec![Block::Table(table)] });
    }
    let columns = Columns::<Unmatched>::new()
        .sheet(phrase!("file"), "", |u| u.file.as_str())
        .sheet(phrase!("line"), "", |u| u.line)
        .sheet(phrase!("checklist-key"), "", |u| u.key.as_str())
        .sheet(phrase!("reason"), "", |u| u.reason.english());
    section
        .push(Block::Table(Table::new(words, &results.import.unmatched, columns).on(phrase!("sheet-without-partner"))));
    section.push(super::messages::routine(&results.import.messages, words));
    section.whole()
}

fn sources(sources: &[Source], words: &Words) -> Table {
    let columns = Columns::<Source>::new()
        .page(phrase!("file"), "", |s| below_variable(&s.file))
        .page(phrase!("kind"), "", |s| term(words, names::kind(s.kind)))
        .page(phrase!("bytes"), "", |s| s.bytes)
        .page(phrase!("read-as"), "", |s| Text::worded(&s.dialect, words))
        .page(phrase!("rows"), "", |s| s.rows_read)
        .page(phrase!("refused"), "", |s| s.refused.len());
    Table::new(words, sources, columns)
}
