//! Origin of the numbers: program, seed, and all inputs with their checksums.

use crate::model::{Block, Cell, Columns, Section, Table, Text};
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{Provenance, Results, Source};

/// Path of an input below the folder that an environment variable names: `$NAME/path`.
pub(super) fn below_variable(name: &str) -> &str {
    name.strip_prefix('$').and_then(|rest| rest.split_once('/')).map_or(name, |(_, path)| path)
}

/// Results whose formulas have a source.
#[derive(Clone, Copy)]
pub(crate) struct Evaluated {
    /// Frames and parameters were identified.
    pub identification: bool,
    /// Characteristics of ISO 9283 were evaluated.
    pub characteristics: bool,
}

impl Evaluated {
    /// An identification, or an answer about identified parameters.
    pub const IDENTIFICATION: Self = Self { identification: true, characteristics: false };
    /// Campaigns of any kind.
    pub const ANY: Self = Self { identification: true, characteristics: true };

    /// Sources of the formulas.
    fn formulas(self, words: &Words) -> String {
        let all = [
            self.identification.then(|| tr!(words, "formulas-of-identification")),
            self.characteristics.then(|| tr!(words, "formulas-of-characteristics")),
            Some(tr!(words, "formulas-of-uncertainties")),
        ];
        all.into_iter().flatten().collect::<Vec<_>>().join("; ")
    }
}

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let evaluated = Evaluated {
        identification: results.identified.is_some() || results.geometric.is_some(),
        characteristics: !results.tested.is_empty(),
    };
    Some(section_from_provenance(&results.provenance(), evaluated, &results.import.sources, words))
}

/// Section of the provenance; `sources` adds information about inputs that this campaign read.
pub(crate) fn section_from_provenance(
    provenance: &Provenance,
    evaluated: Evaluated,
    sources: &[Source],
    words: &Words,
) -> Section {
    let mut section = Section::new("provenance", tr!(words, "provenance"));
    section.push(Block::facts(vec![
        (tr!(words, "written-by"), format!("etalon {}", provenance.version).into()),
        (tr!(words, "sources-of-the-formulas"), evaluated.formulas(words).into()),
        (tr!(words, "seed"), provenance.seed.map(|seed| seed.to_string()).into()),
    ]));
    let source = |name: &str| sources.iter().find(|s| s.file == name);
    let rows: Vec<(&String, &String, Option<&Source>)> =
        provenance.inputs.iter().map(|(name, sha256)| (name, sha256, source(name))).collect();
    let columns = Columns::<(&String, &String, Option<&Source>)>::new()
        .both(phrase!("file"), "", |(name, ..)| Cell::from(below_variable(name)))
        .both("SHA-256", "", |(_, sha256, _)| Text::code(sha256))
        .sheet(phrase!("kind"), "", |r| r.2.map(|s| s.kind.name()))
        .sheet(phrase!("bytes"), "", |r| r.2.map(|s| s.bytes))
        .sheet(phrase!("read-as"), "", |r| r.2.map(|s| s.dialect.english()))
        .sheet(phrase!("rows"), "", |r| r.2.map(|s| s.rows_read))
        .sheet(phrase!("head-refused"), "", |r| r.2.map(|s| s.refused.len()));
    section.push(Block::Table(Table::new(words, &rows, columns).on(phrase!("sheet-inputs"))));
    if let Some(campaign) = sources.iter().find(|source| source.sha256_without_backup.is_some()) {
        section.push(Block::note(tr!(words, "hash-without-backup", file = campaign.file)));
    }
    section
}
