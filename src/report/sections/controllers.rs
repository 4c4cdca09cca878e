//! Controller files of formats that omit identified parameters: their values, and errors with these
//! values.

use crate::model::{Block, Columns, Section, Table, Text, significant};
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{ControllerErrors, ControllerFiles, Results, WrittenParameter};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let document = results.controllers.as_ref().filter(|document| !document.files.is_empty())?;
    let mut section = Section::new("controllers", tr!(words, "controller-files"));
    section.push(Block::note(tr!(words, "formats-without-all-parameters")));
    let rows: Vec<(&ControllerFiles, &ControllerErrors)> =
        document.files.iter().flat_map(|files| files.errors.iter().map(move |errors| (files, errors))).collect();
    let columns = Columns::<(&ControllerFiles, &ControllerErrors)>::new()
        .both(phrase!("formats"), "", |(f, _)| Text::name(&f.formats.join(", ")))
        .both(phrase!("parameters-left-out"), "", |(f, _)| Text::name(&f.left_out.join(", ")))
        .page(phrase!("report-poses"), "", |(_, e)| Text::name(&words.tr(&e.set.phrase())))
        .sheet(phrase!("report-poses"), "", |(_, e)| e.set.name())
        .both(phrase!("nominal-rms"), "mm", |(_, e)| significant(e.nominal.rms_mm, 3))
        .both(phrase!("nominal-max"), "mm", |(_, e)| significant(e.nominal.max_mm, 3))
        .both(phrase!("identified-rms"), "mm", |(_, e)| significant(e.identified.rms_mm, 3))
        .both(phrase!("identified-max"), "mm", |(_, e)| significant(e.identified.max_mm, 3))
        .both(phrase!("this-file-rms"), "mm", |(_, e)| significant(e.written.rms_mm, 3))
        .both(phrase!("this-file-max"), "mm", |(_, e)| significant(e.written.max_mm, 3));
    section.push(Block::Table(Table::new(words, &rows, columns).on(phrase!("controller-files"))));
    let identified = results.identified.as_ref().map(|identified| &identified.parameters);
    let printed_unit =
        |v: &WrittenParameter| identified.map_or(v.unit.as_str(), |p| p.printed_unit(&v.name, &v.unit)).to_owned();
    let values: Vec<(&ControllerFiles, &WrittenParameter)> =
        document.files.iter().flat_map(|files| files.values.iter().map(move |value| (files, value))).collect();
    let columns = Columns::<(&ControllerFiles, &WrittenParameter)>::new()
        .sheet(phrase!("formats"), "", |(f, _)| f.formats.join(", "))
        .sheet(phrase!("name"), "", |(_, v)| v.name.as_str())
        .sheet(phrase!("unit"), "", |(_, v)| printed_unit(v))
        .sheet(phrase!("value"), "", |(_, v)| v.value)
        .sheet("u (k = 1)", "", |(_, v)| v.standard_uncertainty);
    section.push(Block::Table(Table::new(words, &values, columns).on(phrase!("sheet-controller-values"))));
    section.whole()
}
