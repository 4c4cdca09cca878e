//! Checks of the model by its residuals: reliability of readings, influential poses, trends.

use crate::model::{Block, Cell, Columns, Section, Table, Text, number_cell, significant, strong_yes, term};
use crate::number;
use crate::plots::against::SIGNIFICANCE;
use crate::plots::influence;
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{
    InfluenceEntry, ParametersDocument, ReliabilitySummary, ResidualTrend, Results, RobustParameter, RobustPose,
    RobustSummary,
};

/// Maximum number of parameters in the table of a robust fit.
const SHOWN: usize = 10;

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let (parameters, accuracy) = (&results.identified.as_ref()?.parameters, &results.identified.as_ref()?.accuracy);
    let mut section = Section::new("checks", tr!(words, "checks-of-the-model"));
    if let Some(found) = &parameters.reliability {
        section.push(Block::text(readings(found, words)));
        section.push(Block::heading(tr!(words, "poses-that-decide")));
        section.push(Block::note(tr!(words, "cooks-distance-note", limit = number::significant(found.influential, 2))));
        section.push(Block::Table(poses(found, words)));
        section.figures(influence::picture(found, words));
    }
    if let Some(found) = &parameters.robust {
        section.push(Block::heading(tr!(words, "robust-fit")));
        section.push(Block::text(robust(found, words)));
        section.push(Block::note(tr!(
            words,
            "robust-fit-note",
            c = number::fixed(found.constant, 3),
            sigma = number::significant(1e3 * found.sigma_mm, 3)
        )));
        section.push(Block::Table(robust_parameters(parameters, found, words)));
        section.push(Block::Table(robust_poses(found, words)));
    }
    if !accuracy.trends.is_empty() {
        section.push(Block::heading(tr!(words, "trends-of-the-residuals")));
        section.push(Block::note(tr!(words, "trends-note")));
        section.push(Block::Table(trends(&accuracy.trends, words)));
        if accuracy.field.is_none() && accuracy.trends.iter().any(|t| t.p_value < SIGNIFICANCE) {
            section.push(Block::note(tr!(words, "trends-suggest-field")));
        }
    }
    section.whole()
}

/// Reliability of the readings in sentences.
fn readings(found: &ReliabilitySummary, words: &Words) -> String {
    let um = |mm: Option<f64>| {
        mm.map_or_else(|| tr!(words, "not-detectable"), |mm| format!("{} µm", number::significant(1e3 * mm, 3)))
    };
    tr!(
        words,
        "reliability-note",
        significance = number::significant(100.0 * found.significance, 1),
        power = number::significant(100.0 * found.power, 2),
        median = um(found.median_detectable_mm),
        largest = um(found.largest_detectable_mm),
        redundancy = number::fixed(found.least_redundancy, 2),
        readings = found.readings,
        beyond = found.beyond,
        factor = number::fixed(found.critical_w, 2)
    )
}

fn poses(found: &ReliabilitySummary, words: &Words) -> Table {
    let influential = |p: &InfluenceEntry| strong_yes(words, p.cooks_distance.is_none_or(|d| d > found.influential));
    let distance = |p: &InfluenceEntry| match p.cooks_distance {
        Some(d) => significant(d, 2),
        None => Cell::from(tr!(words, "needed")),
    };
    let columns = Columns::<InfluenceEntry>::new()
        .both(phrase!("pose"), "", |p| p.pose)
        .both(phrase!("cooks-distance"), "", distance)
        .both(phrase!("influential"), "", influential)
        .both(phrase!("parameter"), "", |p| p.parameter.as_str())
        .both(phrase!("change-over-u"), "", |p| significant(p.change_over_u, 2));
    Table::new(words, &found.poses, columns).on(phrase!("sheet-influence-of-poses"))
}

/// Comparison with the robust fit in sentences.
fn robust(found: &RobustSummary, words: &Words) -> String {
    let largest = found.parameters.iter().max_by(|a, b| a.difference_over_u.total_cmp(&b.difference_over_u));
    let Some(largest) = largest else { return String::new() };
    let differs = match largest.difference_over_u > found.critical {
        true => tr!(
            words,
            "robust-fit-difference",
            parameter = largest.name,
            difference = number::significant(largest.difference_over_u, 2),
            chance = number::significant(found.critical, 2)
        ),
        false => tr!(
            words,
            "robust-fit-agrees",
            parameter = largest.name,
            difference = number::significant(largest.difference_over_u, 2),
            chance = number::significant(found.critical, 2)
        ),
    };
    let poses = tr!(
        words,
        "robust-fit-poses",
        factor = number::significant(found.critical_residual, 2),
        poses = found.disagreeing
    );
    format!("{differs} {poses}")
}

/// Parameters with the largest differences.
fn robust_parameters(document: &ParametersDocument, found: &RobustSummary, words: &Words) -> Table {
    let mut most: Vec<&RobustParameter> = found.parameters.iter().collect();
    most.sort_by(|a, b| b.difference_over_u.total_cmp(&a.difference_over_u));
    let most: Vec<RobustParameter> = most.into_iter().take(SHOWN).cloned().collect();
    let beyond = |p: &RobustParameter| strong_yes(words, p.difference_over_u > found.critical);
    let u = |p: &RobustParameter| Some((p.difference / p.difference_over_u).abs()).filter(|u| u.is_finite());
    let columns = Columns::<RobustParameter>::new()
        .both(phrase!("parameter"), "", |p| p.name.as_str())
        .both(phrase!("robust"), "", move |p| number_cell(p.value, |v| number::with_uncertainty(v, u(p))))
        .both(phrase!("difference"), "", move |p| number_cell(p.difference, |v| number::with_uncertainty(v, u(p))))
        .both(phrase!("unit"), "", |p| document.printed_unit(&p.name, &p.unit))
        .both(phrase!("difference-over-u"), "", |p| significant(p.difference_over_u, 2))
        .both(phrase!("differs"), "", beyond);
    Table::new(words, &most, columns).on(phrase!("robust-fit"))
}

/// Poses with the smallest weights.
fn robust_poses(found: &RobustSummary, words: &Words) -> Table {
    let beyond = |p: &RobustPose| strong_yes(words, p.residual_over_sigma > found.critical_residual);
    let columns = Columns::<RobustPose>::new()
        .both(phrase!("pose"), "", |p| p.pose)
        .both(phrase!("weight"), "", |p| significant(p.weight, 2))
        .both(phrase!("residual-over"), "", |p| significant(p.residual_over_sigma, 2))
        .both(phrase!("disagrees"), "", beyond);
    Table::new(words, &found.poses, columns).on(phrase!("sheet-robust-fit-poses"))
}

fn trends(all: &[ResidualTrend], words: &Words) -> Table {
    let name = |t: &ResidualTrend| match t.against.as_str() {
        "reach_mm" => term(words, phrase!("distance-from-the-base")),
        "order" => term(words, phrase!("order-of-the-measurement")),
        joint => Text::name(joint.rsplit_once('_').map_or(joint, |(name, _)| name)).into(),
    };
    let verdict = |t: &ResidualTrend| strong_yes(words, t.p_value < SIGNIFICANCE);
    let columns = Columns::<ResidualTrend>::new()
        .both(phrase!("against"), "", name)
        .micrometres(phrase!("explained"), |t| t.explained_mm)
        .both("F", "", |t| significant(t.f, 3))
        .both(phrase!("p-value"), "", |t| number_cell(t.p_value, number::probability))
        .both(phrase!("trend"), "", verdict);
    Table::new(words, all, columns).on(phrase!("sheet-trends-of-residuals"))
}
