//! Uncertainty budget: contribution of each source to the uncertainty of all parameters and errors
//! (GUM 5.1.2).

use crate::model::{Block, Cell, Columns, Section, Table, number_cell, significant, term};
use crate::number;
use crate::plots::shares;
use crate::words::{Words, names, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::{
    AccuracyDocument, BudgetSource, ErrorQuantity, Figure, FigureBudget, NominalUncertainties, OrientationBudget,
    ParameterEntry, ParametersDocument, Results, Role, UncertaintySource as Source,
};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let (parameters, accuracy) = (&results.identified.as_ref()?.parameters, &results.identified.as_ref()?.accuracy);
    if parameters.budget.is_empty() {
        return None;
    }
    let mut section = Section::new("budget", tr!(words, "uncertainty-budget"));
    let note = Block::note(tr!(words, "budget-note"));
    section.push(note);
    let figures = figures(accuracy, words);
    if !figures.is_empty() {
        section.push(Block::note(tr!(words, "budget-of-errors-note")));
    }
    section.push(Block::Table(figures));
    section.push(Block::Table(orientations(accuracy, words)));
    section.figures(shares::picture(&named(accuracy), figure, words));
    let mut of_parameters = vec![Block::facts(sources(parameters, words))];
    if let Some(nominal) = nominal(parameters) {
        of_parameters.push(Block::note(tr!(words, "budget-of-nominal-values")));
        if nominal.tolerance_factor < 1.0 && parameters.identified().any(is_default) {
            let factor = number::significant(nominal.tolerance_factor, 2);
            of_parameters.push(Block::note(tr!(words, "budget-of-default-tolerances", factor)));
        }
    }
    of_parameters.push(Block::Table(table(parameters, words)));
    section.push(Block::Aside { title: tr!(words, "budget-of-parameters"), blocks: of_parameters });
    section.push(Block::note(left_out(results, words)));
    section.push(Block::text(repeats(parameters, words)));
    Some(section)
}

/// `true` for a parameter of the robot with a default tolerance.
fn is_default(p: &ParameterEntry) -> bool {
    p.role == Role::Robot && p.tolerance.is_none()
}

/// Standard uncertainties of nominal values.
fn nominal(parameters: &ParametersDocument) -> Option<&NominalUncertainties> {
    parameters.budget.iter().find_map(|source| source.nominal.as_ref())
}

/// Sentence on errors whose uncertainty is unknown: common errors of all lengths for which the
/// campaign gives no uncertainty, and features without a redundant point; empty without such
/// errors.
pub(super) fn left_out(results: &Results, words: &Words) -> String {
    let Some(identified) = &results.identified else { return String::new() };
    let of_figures = identified.accuracy.budget.iter().flat_map(|f| &f.contributions).map(|c| c.source);
    let included: Vec<Source> = identified.parameters.budget.iter().map(|b| b.source).chain(of_figures).collect();
    let has = |source: &Source| included.contains(source);
    // lengths of fixed points replace the scale of a measuring system that nothing else uses
    let is_measured = !has(&Source::KnownPoints)
        || [Source::Instrument, Source::SingleCoordinates, Source::Residuals].iter().any(has);
    let scale = is_measured.then(|| (Source::Scale, phrase!("left-out-scale")));
    // effects of the temperature on the robot are identified
    let expansion = match identified.parameters.reference_temperature_c {
        Some(_) => phrase!("left-out-temperature-of-part"),
        None => phrase!("left-out-temperature"),
    };
    let common = scale.into_iter().chain([(Source::Temperature, expansion)]);
    let mut missing: Vec<String> = common.filter(|(source, _)| !has(source)).map(|(_, what)| words.tr(&what)).collect();
    if !has(&Source::Frame) {
        let unknown = results.features.features.iter().filter(|f| f.standard_uncertainty_mm.is_none());
        missing.extend(unknown.map(|feature| tr!(words, "left-out-feature", feature = feature.name)));
    }
    if missing.is_empty() { String::new() } else { tr!(words, "budget-left-out", sources = missing.join("; ")) }
}

/// Parameters whose uncertainty rests mostly on the tolerance of the nominal value, and the factor
/// of the default tolerances among them; empty without such a parameter.
pub(super) fn by_tolerances(parameters: &ParametersDocument, words: &Words) -> String {
    let by_tolerance: Vec<&ParameterEntry> = parameters
        .identified()
        .enumerate()
        .filter(|(k, _)| largest(&parameters.budget, *k) == Some(Source::NominalValues))
        .map(|(_, p)| p)
        .collect();
    let count = by_tolerance.len();
    let default = by_tolerance.iter().filter(|p| is_default(p)).count();
    let Some(nominal) = nominal(parameters).filter(|_| count > 0) else { return String::new() };
    let names = by_tolerance.iter().map(|p| p.name.as_str()).collect::<Vec<_>>().join(", ");
    let sentence = tr!(words, "uncertainty-by-tolerances", count, names, default);
    match default {
        0 => sentence,
        _ => {
            let factor = number::significant(nominal.tolerance_factor, 2);
            format!("{sentence} {}", tr!(words, "uncertainty-by-default-tolerances", factor))
        }
    }
}

/// Explanation of a source.
fn meaning(source: Source) -> Phrase {
    match source {
        Source::Instrument => phrase!("source-instrument-meaning"),
        Source::Contact => phrase!("source-contact-meaning"),
        Source::SingleCoordinates => phrase!("source-single-coordinates-meaning"),
        Source::Encoders => phrase!("source-encoders-meaning"),
        Source::RigidParts => phrase!("source-rigid-parts-meaning"),
        Source::KnownPoints => phrase!("source-known-points-meaning"),
        Source::NominalValues => phrase!("source-nominal-values-meaning"),
        Source::Repeatability => phrase!("source-repeatability-meaning"),
        Source::Model => phrase!("source-model-meaning"),
        Source::Residuals => phrase!("source-residuals-meaning"),
        Source::Frame => phrase!("source-frame-meaning"),
        Source::FrameOfPoses => phrase!("source-frame-of-poses-meaning"),
        Source::Scale => phrase!("source-scale-meaning"),
        Source::Temperature => phrase!("source-temperature-meaning"),
        Source::Homing => phrase!("source-homing-meaning"),
    }
}

fn sources(parameters: &ParametersDocument, words: &Words) -> Vec<(String, Cell)> {
    parameters
        .budget
        .iter()
        .map(|b| (words.tr(&names::source(b.source)), words.tr(&meaning(b.source)).into()))
        .collect()
}

fn table(document: &ParametersDocument, words: &Words) -> Table {
    let identified: Vec<(usize, &ParameterEntry)> = document.identified().enumerate().collect();
    let start = Columns::<(usize, &ParameterEntry)>::new().both(phrase!("name"), "", |(_, p)| p.name.as_str()).both(
        phrase!("unit"),
        "",
        |(_, p)| p.printed_unit(),
    );
    let columns = document.budget.iter().fold(start, |columns, source| {
        columns.both(names::source(source.source), "", |(k, p)| {
            part(source.standard_uncertainties.get(*k).copied(), p.standard_uncertainty, 1.0)
        })
    });
    let columns = match nominal(document) {
        Some(nominal) => columns.both(phrase!("head-u-nominal"), "", |(k, _)| {
            significant(nominal.standard_uncertainties.get(*k).copied().flatten(), 2)
        }),
        None => columns,
    };
    let columns = columns.both("u (k = 1)", "", |(_, p)| significant(p.standard_uncertainty, 2)).both(
        phrase!("largest"),
        "",
        |(k, _)| largest(&document.budget, *k).map_or(Cell::Missing, |s| term(words, names::source(s))),
    );
    Table::new(words, &identified, columns).on(phrase!("uncertainty-budget"))
}

/// Contribution, shown `factor` times as large, to the second digit of the whole; empty if smaller.
fn part(u: Option<f64>, whole: Option<f64>, factor: f64) -> Cell {
    let whole = whole.map(|u| factor * u);
    let text = |u: f64| number::with_uncertainty(factor * u, whole);
    let is_zero = |u: f64| !text(u).contains(|c: char| ('1'..='9').contains(&c));
    number_cell(u.filter(|u| !is_zero(*u)), text)
}

/// Source with the largest contribution to a parameter.
fn largest(budget: &[BudgetSource], k: usize) -> Option<Source> {
    let of = |b: &BudgetSource| b.standard_uncertainties.get(k).copied().unwrap_or(0.0);
    Some(budget.iter().max_by(|a, b| of(a).total_cmp(&of(b)))?.source)
}

/// Named figures: not those along single axes.
pub(super) fn named(document: &AccuracyDocument) -> Vec<FigureBudget> {
    document.budget.iter().filter(|f| is_named(f)).cloned().collect()
}

fn is_named(f: &FigureBudget) -> bool {
    match f.quantity {
        ErrorQuantity::Position => true,
        quantity => f.figure == Figure::Max && ErrorQuantity::OTHERS.contains(&quantity),
    }
}

fn figure(f: &FigureBudget) -> Phrase {
    names::error(f.quantity, f.figure)
}

fn figures(document: &AccuracyDocument, words: &Words) -> Table {
    let mut sources: Vec<Source> = document.budget.iter().flat_map(|f| &f.contributions).map(|c| c.source).collect();
    sources.sort_unstable();
    sources.dedup();
    let start = Columns::<FigureBudget>::new().both(phrase!("figure"), "", |f| term(words, figure(f)));
    let columns = sources.into_iter().fold(start, |columns, source| {
        let of = move |f: &FigureBudget| {
            f.contributions.iter().find(|c| c.source == source).map(|c| c.standard_uncertainty_mm)
        };
        let cell = move |f: &FigureBudget| part(of(f), Some(f.standard_uncertainty_mm), 1e3);
        columns.both(names::source(source), "mm", cell).in_unit("µm")
    });
    let whole = |f: &FigureBudget| part(Some(f.standard_uncertainty_mm), Some(f.standard_uncertainty_mm), 1e3);
    let columns = columns.both("u (k = 1)", "mm", whole).in_unit("µm");
    Table::new(words, document.budget.iter().filter(|f| is_named(f)), columns)
        .on(phrase!("sheet-budget-of-errors"))
        .without_empty_columns()
}

/// Budget of an orientation error.
fn orientations(document: &AccuracyDocument, words: &Words) -> Table {
    let start =
        Columns::<OrientationBudget>::new().both(phrase!("figure"), "", |_| term(words, phrase!("orientation")));
    let sources = document.orientation_budget.iter().flat_map(|budget| &budget.contributions).map(|c| c.source);
    let columns = sources.fold(start, |columns, source| {
        columns.both(names::source(source), "deg", move |budget: &OrientationBudget| {
            let of_source = budget.contributions.iter().find(|c| c.source == source);
            significant(of_source.map(|c| c.standard_uncertainty_deg), 2)
        })
    });
    let columns = columns.both("u (k = 1)", "deg", |b: &OrientationBudget| significant(b.standard_uncertainty_deg, 2));
    Table::new(words, &document.orientation_budget, columns).on(phrase!("sheet-budget-of-orientations"))
}

/// Sentence on repeats of poses.
fn repeats(document: &ParametersDocument, words: &Words) -> String {
    let Some(found) = document.residuals.test.repeats else { return String::new() };
    tr!(
        words,
        "lack-of-fit",
        repeats = number::fixed(1e3 * found.repeats_mm, 1),
        degrees_of_freedom = found.degrees_of_freedom,
        model = number::fixed(1e3 * found.lack_of_fit_mm, 1),
        probability = number::p_value(found.p_value)
    )
}
