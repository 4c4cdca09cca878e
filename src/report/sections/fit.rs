//! Goodness of fit, observability by the poses, and termination of the solver.

use crate::model::{
    Block, Cell, Columns, Figure, Section, Table, Text, number_cell, numbers, significant as digits, term,
    with_uncertainty,
};
use crate::number::{self, derived, significant};
use crate::plots::{points, residuals as plots, singular};
use crate::words::{Words, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_documents::{
    KnownValue, ObservabilitySummary, ParametersDocument, QuantityResiduals, ResidualKind, ResidualSummary, Results,
    SeriesScatter, SingularValueEntry, UncertaintyFrom,
};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let identified = results.identified.as_ref()?;
    let drawable = points::drawable(&identified.errors);
    let planar = points::planar(&drawable, results.frames.world.planar);
    Some(section_from_document(&identified.parameters, plots::pictures(&drawable, planar, words), words))
}

/// Section of a fit, with figures of its residuals.
pub(crate) fn section_from_document(document: &ParametersDocument, pictures: Vec<Figure>, words: &Words) -> Section {
    let mut section = Section::new("fit", tr!(words, "fit-and-observability"));
    section.push(Block::heading(tr!(words, "residuals-title")));
    section.push(Block::facts(residuals(&document.residuals, words)));
    insert_readings(&mut section, document, words);
    section.figures(pictures);
    if let Some(o) = &document.observability {
        section.push(Block::heading(tr!(words, "observability")));
        section.push(Block::Table(indices(o, words)));
        section.push(Block::note(Text::from(tr!(words, "scaling-label") + " ").and(Text::worded(&o.scaling, words))));
        section.push(Block::Table(singular_values(o, words)));
        section.figures(singular::picture(o, words));
    }
    let solver = &document.solver;
    let method = words.worded(&solver.method);
    let steps = tr!(words, "method-iterations", method, iterations = solver.iterations) + " ";
    let ended = Text::from(steps).and(words.tr(&solver.termination.phrase()));
    section.push(Block::heading(tr!(words, "solver")));
    section.push(Block::text(ended.clone()));
    let r = &document.residuals;
    section.summarise(tr!(words, "model-of-the-robot"), document.robot.as_str(), "");
    section.summarise(tr!(words, "residuals"), r.count, "");
    match r.position.position_rms_mm {
        Some(rms_mm) => section.summarise(tr!(words, "position-residuals-rms"), rms_mm, "mm"),
        None => section.summarise(tr!(words, "residuals-rms"), r.rms, ""),
    }
    section.summarise(tr!(words, "residuals-max"), r.max, "");
    section.summarise(tr!(words, "degrees-of-freedom"), r.degrees_of_freedom, "");
    section.summarise(tr!(words, "chi-square"), r.test.chi_square, "");
    section.summarise(tr!(words, "uncertainties-enlarged-by"), r.uncertainties_enlarged_by, "");
    section.summarise(tr!(words, "condition"), document.observability.as_ref().map(|o| o.condition), "");
    section.summarise(tr!(words, "solver"), ended, "");
    section
}

fn indices(o: &ObservabilitySummary, words: &Words) -> Table {
    let columns = Columns::<ObservabilitySummary>::new()
        .page("O1", "", |o| digits(o.o1, 4))
        .page("O2", "", |o| digits(o.o2, 4))
        .page("O3", "", |o| digits(o.o3, 4))
        .page("O4", "", |o| digits(o.o4, 4))
        .page("O5", "", |o| digits(o.o5, 4))
        .page(phrase!("condition"), "", |o| digits(o.condition, 4))
        .page(phrase!("rank"), "", |o| o.rank);
    Table::new(words, [o], columns)
}

/// Singular values in descending order, followed by the values of held parameters.
fn singular_values(o: &ObservabilitySummary, words: &Words) -> Table {
    let all = o.singular_values.iter().map(|s| ("identified", s));
    let all = all.chain(o.held_singular_values.iter().map(|s| ("held", s)));
    let rows: Vec<(usize, &str, &SingularValueEntry)> =
        all.enumerate().map(|(i, (direction, s))| (i + 1, direction, s)).collect();
    let columns = Columns::<(usize, &str, &SingularValueEntry)>::new()
        .sheet(phrase!("number"), "", |(i, ..)| *i)
        .sheet(phrase!("singular-value-scaled"), "", |(.., s)| s.value)
        .sheet(phrase!("direction"), "", |(_, direction, _)| *direction)
        .sheet(phrase!("parameters"), "", |(.., s)| s.parameters.join(", "));
    Table::new(words, &rows, columns).on(phrase!("sheet-singular-values"))
}

/// Degrees of freedom, with the numbers of which they are the sum.
fn degrees_of_freedom(r: &ResidualSummary, words: &Words) -> String {
    match r.test.determined_parameters {
        Some(determined) => tr!(
            words,
            "degrees-of-freedom-sum",
            degrees = r.degrees_of_freedom,
            residuals = r.count,
            stated = r.test.stated_values,
            determined = derived(determined)
        ),
        None => r.degrees_of_freedom.to_string(),
    }
}

/// Adds the residuals of each quantity to a section, and known lengths and positions.
pub(super) fn insert_readings(section: &mut Section, document: &ParametersDocument, words: &Words) {
    section.push(Block::Table(readings(&document.residuals, words)));
    section.table(tr!(words, "known-values-title"), tr!(words, "known-values-note"), known(&document.known, words));
}

/// Residuals of each quantity with their stated uncertainties; empty if all readings are
/// coordinates.
fn readings(r: &ResidualSummary, words: &Words) -> Table {
    let coordinates = r.position.coordinates.iter().map(|c| (phrase!("coordinates-of-targets"), c));
    let all: Vec<(Phrase, &QuantityResiduals)> =
        coordinates.chain(r.conditions.iter().map(|c| (c.quantity.phrase(), c))).collect();
    let unit = |c: &QuantityResiduals| number::display_unit(&c.unit, c.standard_uncertainty.max(c.rms));
    let shown = move |c: &QuantityResiduals, value: f64| significant(unit(c).factor * value, 3);
    let columns = Columns::<(Phrase, &QuantityResiduals)>::new()
        .both(phrase!("quantity"), "", |(quantity, _)| term(words, quantity.clone()))
        .both(phrase!("head-values"), "", |(_, c)| c.count)
        .page(phrase!("unit"), "", move |(_, c)| unit(c).unit)
        .sheet(phrase!("unit"), "", |(_, c)| c.unit.as_str())
        .page(phrase!("head-stated-u"), "", move |(_, c)| numbers(shown(c, c.standard_uncertainty)))
        .sheet(phrase!("head-stated-u"), "", |(_, c)| c.standard_uncertainty)
        .page(phrase!("residuals-rms"), "", move |(_, c)| numbers(shown(c, c.rms)))
        .sheet(phrase!("residuals-rms"), "", |(_, c)| c.rms)
        .both(phrase!("head-residual-over-u"), "", |(_, c)| digits(c.rms / c.standard_uncertainty, 3));
    match r.conditions.is_empty() {
        true => Table::default(),
        false => Table::new(words, &all, columns).on(phrase!("sheet-readings")),
    }
}

/// Known lengths and positions with their residuals.
fn known(all: &[KnownValue], words: &Words) -> Table {
    let columns = Columns::<KnownValue>::new()
        .both(phrase!("name"), "", |k| Text::name(&k.name))
        .both(phrase!("quantity"), "", |k| term(words, k.quantity.phrase()))
        .both(phrase!("position"), "mm", |k| {
            let listed = |at: Vector| at.map(|v| words.fixed(v, 3)).join("; ");
            k.place_mm.map(|at| numbers(listed(at)))
        })
        .both(phrase!("head-stated-value"), "mm", |k| with_uncertainty(k.stated_mm, Some(k.standard_uncertainty_mm)))
        .both("U (k = 2)", "mm", |k| micrometres(2.0 * k.standard_uncertainty_mm))
        .in_unit("µm")
        .both(phrase!("head-identified-minus-stated"), "mm", |k| micrometres(k.residual_mm))
        .in_unit("µm")
        .both(phrase!("head-residual-over-u"), "", |k| digits(k.residual_mm.abs() / k.standard_uncertainty_mm, 3));
    Table::new(words, all, columns).without_empty_columns().on(phrase!("sheet-known-values"))
}

/// Length (mm), shown in µm with three significant digits.
fn micrometres(mm: f64) -> Cell {
    number_cell(mm, |mm| significant(1e3 * mm, 3))
}

/// `true` if some residuals are coordinates of targets.
pub(super) fn measures_coordinates(r: &ResidualSummary) -> bool {
    r.count > r.conditions.iter().map(|c| c.count).sum()
}

/// Probability of chi-square with the limit below which the model is rejected.
pub(super) fn criterion(r: &ResidualSummary, words: &Words) -> Option<String> {
    let p = words.decimal(number::p_value(r.p_value()?));
    Some(tr!(words, "model-criterion", p, limit = number::stated(ResidualSummary::SIGNIFICANCE)))
}

/// Position residuals and their expected size, and the ratio of all residuals to their stated
/// uncertainty.
pub(super) fn residuals_and_expected(r: &ResidualSummary, words: &Words) -> Vec<(String, Cell)> {
    let of_position = r.position.position_rms_mm.map(|mm| length(mm, words));
    let [expected, over_uncertainty] = explained(r, words);
    let chi_square = (tr!(words, "chi-square"), judged_chi_square(r, words).into());
    vec![(tr!(words, "position-residuals-rms"), of_position.into()), expected, over_uncertainty, chi_square]
}

/// Chi-square with its expected value, its probability, and the limit of the probability.
fn judged_chi_square(r: &ResidualSummary, words: &Words) -> Option<String> {
    let (value, expected) = (significant(r.test.chi_square?, 4), r.degrees_of_freedom);
    Some(match criterion(r, words) {
        Some(criterion) => tr!(words, "expected-value-judged", value, expected, criterion),
        None => tr!(words, "expected-value", value, expected),
    })
}

/// Expected size of the position residuals, and the ratio of all residuals to their stated
/// uncertainty; without readings other than positions, the ratio explains the positions.
fn explained(r: &ResidualSummary, words: &Words) -> [(String, Cell); 2] {
    let ratio = r.times_uncertainty();
    let of_positions = ratio.filter(|ratio| *ratio > 0.0 && r.conditions.is_empty());
    let expected = r.position.position_rms_mm.zip(of_positions).map(|(mm, ratio)| length(mm / ratio, words));
    let ratio = ratio.map(|ratio| words.decimal(significant(ratio, 3)));
    [
        (tr!(words, "position-residuals-expected-rms"), expected.into()),
        (tr!(words, "residuals-over-uncertainty"), ratio.into()),
    ]
}

/// Length with three significant digits.
fn length(mm: f64, words: &Words) -> String {
    format!("{} mm", words.decimal(significant(mm, 3)))
}

fn residuals(r: &ResidualSummary, words: &Words) -> Vec<(String, Cell)> {
    let three = |v: f64| significant(v, 3);
    // readings other than positions, for example distances
    let readings =
        r.kind == ResidualKind::Targets && (r.position.position_rms_mm.is_none() || !r.conditions.is_empty());
    let count = match r.kind {
        ResidualKind::Pose => tr!(words, "pose-coordinates", count = r.count),
        ResidualKind::Targets if readings => tr!(words, "measured-values", count = r.count),
        ResidualKind::Targets => tr!(words, "target-coordinates", count = r.count),
    };
    let from = match r.uncertainties_from {
        UncertaintyFrom::Instrument => tr!(words, "from-the-instrument"),
        UncertaintyFrom::Residuals => tr!(words, "from-residuals"),
        UncertaintyFrom::ResidualsByPose => tr!(words, "from-residuals-by-pose"),
        UncertaintyFrom::ResidualsByRegion => {
            let scatter = r.between_series.unwrap_or(SeriesScatter { series: 0, share: 0.0 });
            let percent = (100.0 * scatter.share).round() as usize;
            tr!(words, "from-residuals-by-region", series = scatter.series, percent)
        }
        UncertaintyFrom::Nothing => tr!(words, "unknown-without-redundancy"),
    };
    let beside = if r.test.stated_standard_uncertainty_mm.is_some() { "instrument" } else { "residuals" };
    let enlarged = match r.uncertainties_enlarged_by {
        1.0 => String::new(),
        by => format!(", {}", tr!(words, "uncertainty-inflation", factor = three(by), beside)),
    };
    let own = match (
        r.test.stated_standard_uncertainty_mm.map(derived),
        r.test.common_standard_uncertainty_mm.map(derived),
    ) {
        (Some(own), Some(common)) => Some(tr!(words, "coordinate-uncertainty-in-common", uncertainty = own, common)),
        // in the table of readings
        (Some(_), None) if !r.conditions.is_empty() => None,
        (Some(own), None) if readings => Some(tr!(words, "reading-uncertainty", uncertainty = own)),
        (own, _) => own.map(|own| tr!(words, "coordinate-uncertainty", uncertainty = own)),
    };
    let both = tr!(words, "rms-and-max-values", rms = three(r.rms), max = three(r.max));
    let of_position = r.position.position_rms_mm.map(|mm| length(mm, words));
    let alone = r.position.position_rms_mm.is_some() && !readings;
    let [of_both, of_max] = if alone { [None, Some(length(r.max, words))] } else { [Some(both), None] };
    let before = r.position.position_rms_before_mm.map(|mm| length(mm, words));
    let [expected, over_uncertainty] = explained(r, words);
    vec![
        (tr!(words, "residuals"), count.into()),
        (tr!(words, "position-residuals-rms"), of_position.into()),
        expected,
        (tr!(words, "position-residuals-before-rms"), before.into()),
        (tr!(words, "rms-and-max"), of_both.into()),
        (tr!(words, "largest-residual-of-a-coordinate"), of_max.into()),
        (tr!(words, "degrees-of-freedom"), degrees_of_freedom(r, words).into()),
        (tr!(words, "stated-uncertainty"), own.into()),
        (tr!(words, "chi-square"), judged_chi_square(r, words).into()),
        over_uncertainty,
        (tr!(words, "uncertainties"), format!("{from}{enlarged}").into()),
    ]
}
