//! Uncertainty budget: contribution of each source to the uncertainty of all parameters and errors
//! (GUM 5.1.2).

use crate::Report;
use crate::model::{Block, Cell, Columns, Section, Table, shown, significant, term};
use crate::number;
use crate::plots::shares;
use crate::words::Words;
use etalon_documents::{
    AccuracyDocument, BudgetSource, Figure, FigureBudget, ParameterEntry, ParametersDocument,
    UncertaintySource as Source,
};

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    let (parameters, accuracy) = (report.identified?.parameters, report.identified?.accuracy);
    if parameters.budget.is_empty() {
        return None;
    }
    let mut section = Section::new("budget", words.say("Uncertainty budget"));
    let note = Block::note(words.say("Contributions to the standard uncertainties (k = 1) in the unit of each line; their squares add up to that of the last column. What several readings have in common stays common."));
    section.push(note);
    let figures = figures(accuracy, words);
    if !figures.is_empty() {
        section.push(Block::note(words.say("Errors of the validation poses: what they would scatter by if calibration and validation were made again. Limits are judged by the uncertainty of the measurement alone, because the identified parameters are what is judged.")));
    }
    section.push(Block::Table(figures));
    section.figures(shares::picture(&accuracy.budget, (name, figure), words));
    section.push(Block::facts(sources(parameters, words)));
    let of_parameters = vec![Block::Table(table(parameters, words))];
    section.push(Block::Aside { title: words.say("Uncertainty budget of the parameters"), blocks: of_parameters });
    section.push(Block::text(repeats(parameters, words)));
    Some(section)
}

/// Name of a source.
fn name(source: Source) -> &'static str {
    match source {
        Source::Instrument => "instrument",
        Source::Contact => "contact",
        Source::RigidParts => "rigid parts",
        Source::KnownPoints => "known points",
        Source::NominalValues => "nominal values",
        Source::Repeatability => "repeatability",
        Source::Model => "model",
        Source::Residuals => "residuals",
        Source::Frame => "world frame",
        Source::FrameOfPoses => "frames of poses",
        Source::Scale => "scale",
        Source::Temperature => "temperature",
        Source::Homing => "homing",
    }
}

/// Explanation of a source.
fn meaning(source: Source) -> &'static str {
    match source {
        Source::Instrument => "the stated uncertainty of each reading",
        Source::Contact => "how well the robot finds a measured point again, as stated",
        Source::RigidParts => "stated shapes of parts that carry targets",
        Source::KnownPoints => "stated places and lengths of fixed points",
        Source::NominalValues => "nominal values of the parameters, by their tolerances",
        Source::Repeatability => "what repeats of a pose scatter beyond the instrument",
        Source::Model => "what residuals exceed all of this by: errors of the robot that the model does not describe",
        Source::Residuals => "scatter of the residuals; no uncertainty is stated",
        Source::Frame => "points that define the world frame, in common to all poses",
        Source::FrameOfPoses => "points of the frame that was measured again at each pose",
        Source::Scale => "scale of the measuring system, in common to all lengths",
        Source::Temperature => "temperature, by the expansion of robot and part, in common to all lengths",
        Source::Homing => "joint values after homing, in common to all poses",
    }
}

fn sources(parameters: &ParametersDocument, words: &Words) -> Vec<(String, Cell)> {
    parameters.budget.iter().map(|b| (words.say(name(b.source)), words.say(meaning(b.source)).into())).collect()
}

fn table(document: &ParametersDocument, words: &Words) -> Table {
    let identified: Vec<(usize, &ParameterEntry)> = document.identified().enumerate().collect();
    let start = Columns::<(usize, &ParameterEntry)>::new().both("name", "", |(_, p)| p.name.as_str()).both(
        "unit",
        "",
        |(_, p)| p.unit.as_str(),
    );
    let columns = document.budget.iter().fold(start, |columns, source| {
        columns.both(name(source.source), "", |(k, p)| {
            part(source.standard_uncertainties.get(*k).copied(), p.standard_uncertainty, 1.0)
        })
    });
    let columns =
        columns.both("u (k = 1)", "", |(_, p)| significant(p.standard_uncertainty, 2)).both("largest", "", |(k, _)| {
            largest(&document.budget, *k).map_or(Cell::Missing, |s| term(words, name(s)))
        });
    Table::of(words, &identified, columns).on("Uncertainty budget")
}

/// Contribution, shown `factor` times as large, to the second digit of the whole; empty if smaller.
fn part(u: Option<f64>, whole: Option<f64>, factor: f64) -> Cell {
    let whole = whole.map(|u| factor * u);
    let shows = |u: &f64| whole.is_none_or(|whole| factor * u > 0.005 * whole);
    shown(u.filter(shows), |u| number::with_uncertainty(factor * u, whole))
}

/// Source with the largest contribution to a parameter.
fn largest(budget: &[BudgetSource], k: usize) -> Option<Source> {
    let of = |b: &BudgetSource| b.standard_uncertainties.get(k).copied().unwrap_or(0.0);
    Some(budget.iter().max_by(|a, b| of(a).total_cmp(&of(b)))?.source)
}

fn figures(document: &AccuracyDocument, words: &Words) -> Table {
    let mut sources: Vec<Source> = document.budget.iter().flat_map(|f| &f.contributions).map(|c| c.source).collect();
    sources.sort_unstable();
    sources.dedup();
    let start = Columns::<FigureBudget>::new().both("figure", "", |f| term(words, figure(f)));
    let columns = sources.into_iter().fold(start, |columns, source| {
        let of = move |f: &FigureBudget| {
            f.contributions.iter().find(|c| c.source == source).map(|c| c.standard_uncertainty_mm)
        };
        let cell = move |f: &FigureBudget| part(of(f), Some(f.standard_uncertainty_mm), 1e3);
        columns.both(name(source), "mm", cell).shown_in("µm")
    });
    let whole = |f: &FigureBudget| part(Some(f.standard_uncertainty_mm), Some(f.standard_uncertainty_mm), 1e3);
    let columns = columns.both("u (k = 1)", "mm", whole).shown_in("µm");
    Table::of(words, &document.budget, columns).on("Budget of errors")
}

fn figure(f: &FigureBudget) -> &'static str {
    match f.figure {
        Figure::Mean => "mean position error, validation",
        Figure::Rms => "root mean square position error, validation",
        Figure::Max => "largest position error, validation",
    }
}

/// Sentence on repeats of poses.
fn repeats(document: &ParametersDocument, words: &Words) -> String {
    let Some(found) = document.residuals.repeats else { return String::new() };
    words.fill(
        "Repeats of a pose scatter by {0} µm a coordinate ({1} degrees of freedom); beside that the model leaves {2} µm at a pose (F test of lack of fit: {3}).",
        &[&number::fixed(1e3 * found.repeats_mm, 1), &found.degrees_of_freedom, &number::fixed(1e3 * found.lack_of_fit_mm, 1), &number::p_value(found.p_value)],
    )
}
