//! Parameters with the significant digits of their uncertainties, covariances and correlations.

use super::budget;
use crate::model::{
    Block, Cell, Columns, Figure, Section, Table, Text, number_cell, significant, term, with_uncertainty,
};
use crate::number;
use crate::plots::{correlation, intervals, sketch};
use crate::words::{Words, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::{ParameterEntry, ParameterStatus, ParametersDocument, Results, RobotLinks, Role};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    Some(section_from_document(&results.identified.as_ref()?.parameters, words))
}

/// Returns the section of these parameters.
pub(crate) fn section_from_document(document: &ParametersDocument, words: &Words) -> Section {
    let mut section = Section::new("parameters", tr!(words, "parameters-title"));
    let note = tr!(words, "parameters-note");
    section.push(Block::note(note));
    section.push(Block::note(links(document, words)));
    let groups = groups(&document.parameters, words);
    for (title, of) in &groups {
        section.table(title, "", table(of, words));
    }
    section.push(Block::text(effective_values(document, words)));
    section.blocks.extend(information(document, words));
    section.push(Block::Table(sheet(&document.parameters)));
    let meanings = vec![Block::Table(meanings(&document.parameters, words).detail())];
    section.push(Block::Aside { title: tr!(words, "meanings-title"), blocks: meanings });
    section.figures(sketch::pictures(&document.sketches, words));
    section.push(Block::Table(matrix(phrase!("sheet-covariance"), document, words, |c, i, j| c[i][j])));
    let correlated = |c: &[Vec<f64>], i: usize, j: usize| c[i][j] / (c[i][i] * c[j][j]).sqrt();
    section.push(Block::Table(matrix(phrase!("sheet-correlation"), document, words, correlated)));
    // without a nominal value there is no change to draw
    let drawn = groups.iter().enumerate().filter(|(_, (_, of))| has_nominal(of));
    let figures: Vec<Figure> = drawn.flat_map(|(i, (title, of))| intervals::pictures(of, i, title, words)).collect();
    section.figures(figures);
    if let Some(figure) = correlation::picture(document, words) {
        let title = figure.title.clone();
        section.push(Block::Aside { title, blocks: vec![Block::Figures { figures: vec![figure] }] });
    }
    section.push(super::messages::routine(&document.messages, words));
    section
}

/// Sentence on the links of the chain that the parameters describe; empty for a robot without a
/// URDF.
pub(super) fn links(document: &ParametersDocument, words: &Words) -> String {
    let Some(RobotLinks { base, ends, base_moves }) = &document.links else { return String::new() };
    let count = usize::from(*base_moves);
    tr!(words, "chain-of-links", base, ends = ends.join(", "), count)
}

/// Sentence on parameters that are effective rather than physical; empty if the model fits.
fn effective_values(document: &ParametersDocument, words: &Words) -> String {
    let effective = document.effective();
    if effective.is_empty() {
        return String::new();
    }
    tr!(words, "effective-parameters", names = effective.join(", "))
}

/// Notes on values and uncertainties that come mostly from nominal values.
pub(super) fn information(document: &ParametersDocument, words: &Words) -> Vec<Block> {
    let by_nominal: Vec<&str> =
        document.parameters.iter().filter(|p| p.is_from_nominal()).map(|p| p.name.as_str()).collect();
    let of_values = match by_nominal.is_empty() {
        true => String::new(),
        false => tr!(words, "values-by-nominal", count = by_nominal.len(), names = by_nominal.join(", ")),
    };
    let texts = [of_values, budget::by_tolerances(document, words)];
    texts.into_iter().filter(|text| !text.is_empty()).map(Block::text).collect()
}

/// Share (%) of an identified value that the data determine.
pub(super) fn share_of_data(p: &ParameterEntry) -> Cell {
    let share = p.determined.filter(|_| p.status == ParameterStatus::Identified);
    number_cell(share.map(|share| 100.0 * share), |percent| number::fixed(percent, 0))
}

/// Groups of parameters by owner (robot, base, targets, fixtures), because their magnitudes differ.
pub(crate) fn groups<'a>(parameters: &'a [ParameterEntry], words: &Words) -> Vec<(String, Vec<&'a ParameterEntry>)> {
    let all = [
        (Role::Robot, tr!(words, "parameters-of-robot")),
        (Role::Base, tr!(words, "place-of-the-base")),
        (Role::Target, tr!(words, "places-of-the-targets")),
        (Role::Fixture, tr!(words, "fixed-in-the-world")),
    ];
    let of = |role: Role| parameters.iter().filter(|p| p.role == role).collect::<Vec<_>>();
    all.into_iter().map(|(role, title)| (title, of(role))).filter(|(_, of)| !of.is_empty()).collect()
}

fn change(p: &ParameterEntry) -> Cell {
    let sign = if p.value > p.nominal { "+" } else { "" };
    number_cell(p.value - p.nominal, |v| sign.to_owned() + &number::with_uncertainty(v, p.standard_uncertainty))
}

/// Change as a multiple of its standard uncertainty; `None` if that is zero or unknown, or if the
/// nominal value is only a starting value (positions of base and targets).
fn change_over_u(p: &ParameterEntry) -> Option<f64> {
    let nominal = Some(p.nominal).filter(|_| p.role == Role::Robot || p.tolerance.is_some());
    Some((p.value - nominal?) / p.standard_uncertainty?).filter(|ratio| ratio.is_finite())
}

/// `true` if nominal values of a group are given: base and targets without nominal values start at
/// zero.
fn has_nominal(parameters: &[&ParameterEntry]) -> bool {
    parameters.iter().any(|p| p.role == Role::Robot || p.tolerance.is_some() || p.nominal != 0.0)
}

fn table(parameters: &[&ParameterEntry], words: &Words) -> Table {
    let moved = parameters.iter().any(|p| p.before != p.nominal);
    let stated = has_nominal(parameters);
    let shared = parameters.iter().any(|p| p.is_from_nominal());
    let columns = Columns::<&ParameterEntry>::new()
        .page(phrase!("name"), "", |p| p.name.as_str())
        .page(phrase!("unit"), "", |p| p.printed_unit())
        .page(phrase!("nominal"), "", move |p| stated.then(|| with_uncertainty(p.nominal, p.standard_uncertainty)))
        .page(phrase!("before"), "", move |p| moved.then(|| with_uncertainty(p.before, p.standard_uncertainty)))
        .page(phrase!("identified"), "", |p| with_uncertainty(p.value, p.standard_uncertainty))
        .page(phrase!("change"), "", move |p| stated.then(|| change(p)))
        .page("u (k = 1)", "", |p| significant(p.standard_uncertainty, 2))
        .page("U = 2u", "", |p| significant(p.standard_uncertainty.map(|u| 2.0 * u), 2))
        .page(phrase!("change-by-u"), "", |p| number_cell(change_over_u(p), number::ratio))
        .page(phrase!("tolerance"), "", |p| significant(p.tolerance, 3))
        .page(phrase!("from-data"), "%", move |p| if shared { share_of_data(p) } else { Cell::Missing })
        .page(phrase!("status"), "", |p| status(p, words))
        .page(phrase!("confounded-with"), "", |p| confounded(p, words));
    Table::new(words, parameters, columns).without_empty_columns()
}

/// Maximum number of names in a cell of a page; the workbook contains all.
const NAMES: usize = 4;

fn confounded(p: &ParameterEntry, words: &Words) -> Text {
    let names = &p.confounded_with;
    match names.len() > NAMES + 1 {
        true => {
            let more = tr!(words, "and-more", count = (names.len() - NAMES));
            Text::name(&names[..NAMES].join(", ")).and(format!(" {more}"))
        }
        false => Text::name(&names.join(", ")),
    }
}

/// All parameters for the workbook.
fn sheet(parameters: &[ParameterEntry]) -> Table {
    let words = &Words::default();
    let columns = Columns::<ParameterEntry>::new()
        .sheet(phrase!("name"), "", |p| p.name.as_str())
        .sheet(phrase!("unit"), "", |p| p.printed_unit())
        .sheet(phrase!("nominal"), "", |p| p.nominal)
        .sheet(phrase!("before"), "", |p| p.before)
        .sheet(phrase!("identified"), "", |p| p.value)
        .sheet(phrase!("change"), "", |p| p.value - p.nominal)
        .sheet("u (k = 1)", "", |p| p.standard_uncertainty)
        .sheet("U = 2u", "", |p| p.standard_uncertainty.map(|u| 2.0 * u))
        .sheet(phrase!("change-by-u"), "", change_over_u)
        .sheet(phrase!("tolerance"), "", |p| p.tolerance)
        .sheet(phrase!("from-data"), "%", share_of_data)
        .sheet(phrase!("status"), "", |p| status(p, words))
        .sheet(phrase!("confounded-with"), "", |p| Text::name(&p.confounded_with.join(", ")))
        .sheet(phrase!("head-meaning"), "", |p| p.meaning.as_str());
    Table::new(words, parameters, columns).on(phrase!("parameters-title"))
}

/// Meanings of parameters, with equal meanings in one row.
fn meanings(parameters: &[ParameterEntry], words: &Words) -> Table {
    let mut rows: Vec<(String, Vec<&str>)> = Vec::new();
    for p in parameters.iter().filter(|p| !p.meaning.is_empty()) {
        let meaning = words.by_id(p.meaning_id.as_deref(), &p.meaning);
        match rows.iter_mut().find(|(other, _)| *other == meaning) {
            Some((_, names)) => names.push(&p.name),
            None => rows.push((meaning, vec![&p.name])),
        }
    }
    let columns = Columns::<(String, Vec<&str>)>::new()
        .page(phrase!("parameters"), "", |(_, names)| Text::name(&names.join(", ")))
        .page(phrase!("meaning-and-sign"), "", |(meaning, _)| Text::from(meaning.as_str()));
    Table::new(words, &rows, columns)
}

/// Origin of a parameter's value in words.
pub(super) fn status(p: &ParameterEntry, words: &Words) -> Cell {
    match p.status {
        ParameterStatus::Identified if p.is_from_nominal() => term(words, phrase!("from-nominal-value")),
        ParameterStatus::Identified => term(words, phrase!("identified")),
        ParameterStatus::Fixed => term(words, phrase!("held-by-the-campaign")),
        ParameterStatus::NotIdentifiable => term(words, phrase!("held-not-identifiable")),
        ParameterStatus::PlacedByValidation => term(words, phrase!("placed-by-validation-poses")),
    }
}

/// Matrix of the identified parameters with their names at the side and the top; without columns if
/// empty.
fn matrix(
    name: Phrase,
    document: &ParametersDocument,
    words: &Words,
    entry: fn(&[Vec<f64>], usize, usize) -> f64,
) -> Table {
    let covariance = &document.covariance;
    let identified: Vec<(usize, &ParameterEntry)> = document.identified().enumerate().collect();
    let size = identified.len();
    let fits = size > 0 && covariance.len() == size && covariance.iter().all(|row| row.len() == size);
    if !fits {
        return Table::default();
    }
    let named = Columns::<(usize, &ParameterEntry)>::new().sheet(phrase!("name"), "", |(_, p)| p.name.as_str()).sheet(
        phrase!("unit"),
        "",
        |(_, p)| p.printed_unit(),
    );
    let columns = identified
        .iter()
        .fold(named, |columns, (j, p)| columns.sheet(p.name.as_str(), "", move |(i, _)| entry(covariance, *i, *j)));
    Table::new(words, &identified, columns).on(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;
    use etalon_documents::{BudgetSource, NominalUncertainties, UncertaintySource};

    #[test]
    fn digits_follow_the_uncertainty() {
        let mut p = ParameterEntry {
            name: "d".into(),
            unit: "mm".into(),
            full_unit: None,
            role: Role::Robot,
            meaning: String::new(),
            meaning_id: None,
            tolerance: None,
            nominal: 300.0,
            before: 300.0,
            value: 299.123_456_789,
            standard_uncertainty: Some(0.001_49),
            determined: None,
            degrees_of_freedom: None,
            status: ParameterStatus::Identified,
            confounded_with: vec![],
        };
        let row = |p: &ParameterEntry| {
            let table = table(&[p], &Words::default());
            table.rows[0].iter().map(Cell::plain).collect::<Vec<_>>()
        };
        assert_eq!(row(&p)[3..], ["299.1235", "-0.8765", "0.0015", "0.0030", "-588", "identified"]);
        (p.standard_uncertainty, p.status) = (None, ParameterStatus::NotIdentifiable);
        assert_eq!(row(&p)[3..], ["299.1235", "-0.8765", "held: not separately identifiable"]);
        // a base that was found from the measurements did not move there from zero
        (p.role, p.nominal, p.before, p.value) = (Role::Base, 0.0, 448.63, 450.02);
        (p.standard_uncertainty, p.status) = (Some(0.22), ParameterStatus::Identified);
        assert_eq!(row(&p)[2..], ["448.63", "450.02", "0.22", "0.44", "identified"]);
        assert_eq!(change_over_u(&p), None);
        p.tolerance = Some(1.0);
        assert_eq!(change_over_u(&p).map(|r| r.round()), Some(2046.0), "a stated place is a claim");
    }

    #[test]
    fn values_that_data_do_not_determine_are_marked() {
        let (words, mut document) = (Words::default(), Documents::demo().parameters);
        let shown =
            |document: &ParametersDocument| serde_json::to_string(&section_from_document(document, &words)).unwrap();
        let marked = tr!(words, "from-nominal-value");
        document.parameters[1].determined = Some(0.62);
        assert!(!shown(&document).contains(&marked) && information(&document, &words).is_empty());
        document.parameters[1].determined = Some(0.16);
        let page = shown(&document);
        assert!(page.contains(&marked) && page.contains("\"16\""), "{page}");
        assert!(page.contains(&tr!(words, "values-by-nominal", count = 1, names = "gamma")), "{page}");
        // a value that is held comes from nothing else
        document.parameters[1].status = ParameterStatus::Fixed;
        assert!(!shown(&document).contains(&marked));
    }

    /// Two of eleven identified values have no smaller contribution than their tolerance, one of
    /// them a default.
    #[test]
    fn uncertainties_by_tolerances_are_named() {
        let (words, mut document) = (Words::default(), Documents::demo().parameters);
        assert!(information(&document, &words).is_empty());
        let by_nominal = |k: usize, u: f64| if k < 2 { 3.0 * u } else { 0.0 };
        let standard_uncertainties: Vec<f64> =
            document.identified().enumerate().map(|(k, p)| by_nominal(k, p.standard_uncertainty.unwrap())).collect();
        let nominal = standard_uncertainties.iter().map(|u| Some(*u)).collect();
        document.parameters[0].tolerance = Some(0.1);
        document.budget.push(BudgetSource {
            source: UncertaintySource::NominalValues,
            standard_uncertainties,
            nominal: Some(NominalUncertainties { standard_uncertainties: nominal, tolerance_factor: 0.044 }),
        });
        let blocks = serde_json::to_string(&information(&document, &words)).unwrap();
        let sentences = [
            tr!(words, "uncertainty-by-tolerances", count = 2, names = "beta, gamma", default = 1),
            tr!(words, "uncertainty-by-default-tolerances", factor = "0.044"),
        ];
        assert!(blocks.contains(&sentences.join(" ")), "{blocks}");
    }
}
