//! Index and condition number over the number of configurations (thesis, fig. 4.6).

use super::layer::*;
use crate::number::significant;
use etalon_documents::{CurvePoint, PlanDocument};

/// Margin at the right for the labels and the name of the second axis.
const ROOM: f64 = 56.0;

/// Maximum condition number that is drawn; larger ones belong to singular choices.
const REGULAR: f64 = 1e9;

/// Curve of the greedy choice; `None` with fewer than two points.
pub(crate) fn curve(plan: &PlanDocument, words: &Words) -> Option<Figure> {
    let points: Vec<_> =
        plan.optimality.greedy.curve.iter().filter(|p| p.value.is_finite() && p.condition.is_finite()).collect();
    let configurations = range(points.iter().map(|p| p.configurations as f64)).filter(|_| points.len() > 1)?;
    let index = Axis::over("", range(points.iter().map(|p| p.value))?, 0.1);
    let regular = |p: &CurvePoint| p.condition < REGULAR;
    let condition = Axis::from_zero("", largest(points.iter().map(|p| p.condition).filter(|c| *c < REGULAR)));
    let axes = [Axis::over("", configurations, 0.03), index];
    let mut chart = Chart::with_room(words, ROOM, axes, NARROW, [tr!(words, "configurations"), plan.index.clone()]);
    chart.second(&condition, &tr!(words, "condition-number"));
    if let Some(knee) = plan.optimality.greedy.knee_configurations {
        chart.upright("knee", knee as f64);
        let at = (chart.at(knee as f64, 0.0).0, chart.frame.top - 4.0);
        chart.svg.text("mid", at, &tr!(words, "knee-at", count = knee));
    }
    let x = |p: &CurvePoint| p.configurations as f64;
    let of_condition = |p: &CurvePoint| (chart.at(x(p), 0.0).0, chart.frame.level(&condition, p.condition));
    let of_index = |p: &CurvePoint| chart.at(x(p), p.value);
    let of = |shown: &dyn Fn(&CurvePoint) -> bool, at: &dyn Fn(&CurvePoint) -> Place| {
        points.iter().filter(|p| shown(p)).map(|p| (*p, at(p))).collect::<Vec<_>>()
    };
    let curves =
        [(VALIDATION, "arrow-val", of(&regular, &of_condition)), (CALIBRATION, "arrow-cal", of(&|_| true, &of_index))];
    for (look, line, curve) in curves {
        chart.svg.lines(line, &curve.iter().map(|(_, at)| *at).collect::<Vec<_>>());
        for (p, at) in curve {
            let (value, condition) = (significant(p.value, 4), significant(p.condition, 3));
            let tip = tr!(
                words,
                "curve-tooltip",
                positions = p.positions,
                configurations = p.configurations,
                index = plan.index,
                value,
                condition
            );
            chart.svg.mark(look, at, 3.6, &tip);
        }
    }
    chart.svg.legend(CALIBRATION, &plan.index);
    chart.svg.legend(VALIDATION, &tr!(words, "condition-number"));
    let title = tr!(words, "curve-title", index = plan.index);
    let description = tr!(words, "curve-description");
    let singular = points.iter().filter(|p| !regular(p)).count();
    let singular = match singular {
        0 => String::new(),
        n => format!(" {}", tr!(words, "curve-singular", count = n)),
    };
    let row = |p: &&CurvePoint| {
        vec![
            p.positions.to_string(),
            p.configurations.to_string(),
            words.significant(p.value, 5),
            words.significant(p.condition, 4),
        ]
    };
    Some(Figure {
        caption: tr!(words, "curve-caption") + " " + &tr!(words, "knee-caption") + &singular,
        table_title: tr!(words, "numbers-of-the-curve"),
        header: vec![
            tr!(words, "positions"),
            tr!(words, "configurations"),
            plan.index.clone(),
            tr!(words, "condition"),
        ],
        rows: points.iter().map(row).collect(),
        ..chart.figure("curve", title, description)
    })
}
