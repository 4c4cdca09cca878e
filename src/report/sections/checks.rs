//! Checks of the model by its residuals: reliability of readings, influential poses, trends.

use crate::Report;
use crate::model::{Block, Cell, Columns, Section, Table, shown, significant, strong_term, term};
use crate::number;
use crate::plots::against::SIGNIFICANCE;
use crate::plots::influence;
use crate::words::Words;
use etalon_documents::{InfluenceEntry, ReliabilitySummary, ResidualTrend, RobustParameter, RobustPose, RobustSummary};

/// Maximum number of parameters in the table of a robust fit.
const SHOWN: usize = 10;

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    let (parameters, accuracy) = (report.identified?.parameters, report.identified?.accuracy);
    let mut section = Section::new("checks", words.say("Checks of the model"));
    if let Some(found) = &parameters.reliability {
        section.push(Block::text(readings(found, words)));
        section.push(Block::heading(words.say("Poses that decide")));
        section.push(Block::note(words.fill("Without a pose the parameters change by its Cook's distance, over their covariance; beyond {0} it is influential (median of F; Cook 1977).", &[&number::significant(found.influential, 2)])));
        section.push(Block::Table(poses(found, words)));
        section.figures(influence::picture(found, words));
    }
    if let Some(found) = &parameters.robust {
        section.push(Block::heading(words.say("Robust fit")));
        section.push(Block::text(robust(found, words)));
        section.push(Block::note(words.fill("Readings far from the others weigh little (Cauchy loss, c = {0} σ with σ = {1} µm; Holland & Welsch 1977); the difference is robust minus plain value, its standard uncertainty that of normal residuals or by the scatter of the poses where that is more. The table has the parameters that differ most.", &[&number::fixed(found.constant, 3), &number::significant(1e3 * found.sigma_mm, 3)])));
        section.push(Block::Table(robust_parameters(found, words)));
        section.push(Block::Table(robust_poses(found, words)));
    }
    if !accuracy.trends.is_empty() {
        section.push(Block::heading(words.say("Trends of the residuals")));
        section.push(Block::note(words.say("F tests of the mean errors of the calibration poses after identification: a parabola against a constant; p values are corrected for their number (Holm 1979). A trend is an error that the model does not describe.")));
        section.push(Block::Table(trends(&accuracy.trends, words)));
    }
    section.whole()
}

/// Reliability of the readings in sentences.
fn readings(found: &ReliabilitySummary, words: &Words) -> String {
    let um = |mm: Option<f64>| {
        mm.map_or_else(|| words.say("not detectable"), |mm| format!("{} µm", number::significant(1e3 * mm, 3)))
    };
    words.fill(
        "Reliability (Baarda 1968; significance level {0} %, power {1} %): an error of one coordinate is detected from {2} on (median), of the worst reading {3}; least redundancy {4}. Of {5} readings {6} have a residual beyond {7} of its standard deviations.",
        &[
            &number::significant(100.0 * found.significance, 1),
            &number::significant(100.0 * found.power, 2),
            &um(found.median_detectable_mm),
            &um(found.largest_detectable_mm),
            &number::fixed(found.least_redundancy, 2),
            &found.readings,
            &found.beyond,
            &number::fixed(found.critical_w, 2),
        ],
    )
}

fn poses(found: &ReliabilitySummary, words: &Words) -> Table {
    let influential = |p: &InfluenceEntry| match p.cooks_distance.is_none_or(|d| d > found.influential) {
        true => strong_term(words, "yes"),
        false => term(words, "no"),
    };
    let distance = |p: &InfluenceEntry| match p.cooks_distance {
        Some(d) => significant(d, 2),
        None => Cell::from(words.say("needed")),
    };
    let columns = Columns::<InfluenceEntry>::new()
        .both("pose", "", |p| p.pose)
        .both("Cook's distance", "", distance)
        .both("influential", "", influential)
        .both("parameter", "", |p| p.parameter.as_str())
        .both("change over u", "", |p| significant(p.change_over_u, 2));
    Table::of(words, &found.poses, columns).on("Influence of poses")
}

/// Comparison with the robust fit in sentences.
fn robust(found: &RobustSummary, words: &Words) -> String {
    let largest = found.parameters.iter().max_by(|a, b| a.difference_over_u.total_cmp(&b.difference_over_u));
    let Some(largest) = largest else { return String::new() };
    let numbers: [&dyn std::fmt::Display; 3] =
        [&largest.name, &number::significant(largest.difference_over_u, 2), &number::significant(found.critical, 2)];
    let differs = match largest.difference_over_u > found.critical {
        true => words.fill("A robust fit differs from the plain one: {0} by {1} standard uncertainties of the difference, where chance explains {2}.", &numbers),
        false => words.fill("A robust fit agrees with the plain one: {0} differs most, by {1} standard uncertainties of the difference, where chance explains {2}.", &numbers),
    };
    let poses = words.fill(
        "Poses with a residual beyond {0} σ, which disagree with the others: {1}.",
        &[&number::significant(found.critical_residual, 2), &found.disagreeing],
    );
    format!("{differs} {poses}")
}

/// Parameters with the largest differences.
fn robust_parameters(found: &RobustSummary, words: &Words) -> Table {
    let mut most: Vec<&RobustParameter> = found.parameters.iter().collect();
    most.sort_by(|a, b| b.difference_over_u.total_cmp(&a.difference_over_u));
    let most: Vec<RobustParameter> = most.into_iter().take(SHOWN).cloned().collect();
    let beyond = |p: &RobustParameter| match p.difference_over_u > found.critical {
        true => strong_term(words, "yes"),
        false => term(words, "no"),
    };
    let u = |p: &RobustParameter| Some((p.difference / p.difference_over_u).abs()).filter(|u| u.is_finite());
    let columns = Columns::<RobustParameter>::new()
        .both("parameter", "", |p| p.name.as_str())
        .both("robust", "", move |p| shown(p.value, |v| number::with_uncertainty(v, u(p))))
        .both("difference", "", move |p| shown(p.difference, |v| number::with_uncertainty(v, u(p))))
        .both("unit", "", |p| p.unit.as_str())
        .both("difference over u", "", |p| significant(p.difference_over_u, 2))
        .both("differs", "", beyond);
    Table::of(words, &most, columns).on("Robust fit")
}

/// Poses with the smallest weights.
fn robust_poses(found: &RobustSummary, words: &Words) -> Table {
    let beyond = |p: &RobustPose| match p.residual_over_sigma > found.critical_residual {
        true => strong_term(words, "yes"),
        false => term(words, "no"),
    };
    let columns = Columns::<RobustPose>::new()
        .both("pose", "", |p| p.pose)
        .both("weight", "", |p| significant(p.weight, 2))
        .both("residual over σ", "", |p| significant(p.residual_over_sigma, 2))
        .both("disagrees", "", beyond);
    Table::of(words, &found.poses, columns).on("Robust fit, poses")
}

fn trends(all: &[ResidualTrend], words: &Words) -> Table {
    let name = |t: &ResidualTrend| match t.against.as_str() {
        "reach_mm" => term(words, "distance from the base"),
        "order" => term(words, "order of the measurement"),
        joint => joint.into(),
    };
    let verdict = |t: &ResidualTrend| match t.p_value < SIGNIFICANCE {
        true => strong_term(words, "yes"),
        false => term(words, "no"),
    };
    let columns = Columns::<ResidualTrend>::new()
        .both("against", "", name)
        .micrometres("explained", |t| t.explained_mm)
        .both("F", "", |t| significant(t.f, 3))
        .both("p value", "", |t| shown(t.p_value, number::probability))
        .both("trend", "", verdict);
    Table::of(words, all, columns).on("Trends of residuals")
}
