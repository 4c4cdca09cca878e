//! Effects of the identified parameters at the measured points.

use crate::model::{Block, Columns, Section, Table};
use crate::plots::forest;
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{ParameterInfluence, Results};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let all = &results.identified.as_ref()?.accuracy.parameter_influences;
    let mut section = Section::new("effects", tr!(words, "effects-section"));
    section.figures(forest::picture(all, words));
    let columns = Columns::<ParameterInfluence>::new()
        .both(phrase!("name"), "", |p| p.name.as_str())
        .micrometres(phrase!("change"), |p| p.change_mm)
        .micrometres("U (k = 2)", |p| p.standard_uncertainty_mm.map(|u| 2.0 * u))
        .micrometres(phrase!("tolerance"), |p| p.tolerance_mm)
        .both(phrase!("pose"), "", |p| p.pose);
    let table = Table::new(words, all, columns).on(phrase!("sheet-parameter-effects")).without_empty_columns();
    section.push(Block::Aside { title: tr!(words, "effects-of-all"), blocks: vec![Block::Table(table)] });
    section.whole()
}
