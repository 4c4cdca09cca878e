//! Effect of each parameter at the point that it moves most: change with its interval, and the
//! given tolerance (forest plot).

use super::intervals::shortened_to;
use super::layer::*;
use etalon_documents::ParameterInfluence;

/// Maximum number of rows; a table has all parameters.
pub(crate) const ROWS: usize = 10;
/// Maximum number of letters of a name.
const LETTERS: usize = 34;
/// Margin at the right for the numbers.
const ROOM: f64 = 150.0;

pub(crate) fn picture(all: &[ParameterInfluence], words: &Words) -> Option<Figure> {
    let shown_rows = &all[..all.len().min(ROWS)];
    let expanded = |p: &ParameterInfluence| 2.0 * p.standard_uncertainty_mm.unwrap_or(0.0);
    let ends = |p: &ParameterInfluence| p.change_mm.abs() + expanded(p);
    // a tolerance far beyond all changes would leave nothing to see
    let reach = largest(shown_rows.iter().map(ends));
    if shown_rows.is_empty() || !drawable(reach) || reach <= 0.0 {
        return None;
    }
    let shown = number::display_unit("mm", reach);
    let labels = shown_rows.iter().enumerate().map(|(i, p)| (i as f64, shortened_to(LETTERS, &p.name))).collect();
    let axes = [Axis::both_ways(shown, reach), Axis::rows(shown_rows.len(), labels, 0.5)];
    let name = tr!(words, "effect-at-worst-pose", unit = shown.unit);
    let mut chart = Chart::with_room(words, ROOM, axes, WIDE, [name.as_str(), ""]);
    for (i, p) in shown_rows.iter().enumerate() {
        if let Some(tolerance) = p.tolerance_mm.filter(|t| t.is_finite()) {
            chart.bar_along(Look::new(Shape::Square, "zone-pass"), i, [-tolerance, tolerance], "");
        }
    }
    chart.upright("axis", 0.0);
    for (i, p) in shown_rows.iter().enumerate() {
        let at = |v: f64| chart.at(v, i as f64);
        let (middle, left, right) = (at(p.change_mm), at(p.change_mm - expanded(p)), at(p.change_mm + expanded(p)));
        chart.svg.line("interval", left, right);
        // U has two digits, and the change as many decimals
        let expanded = p.standard_uncertainty_mm.map(|u| 2.0 * u * shown.factor);
        let with_uncertainty = |v: f64| words.decimal(number::with_uncertainty(v, expanded));
        let value = with_uncertainty(p.change_mm * shown.factor);
        let half = expanded.map_or_else(|| "–".to_owned(), with_uncertainty);
        let tip = tr!(words, "effect-tooltip", name = p.name, value, half, unit = shown.unit, pose = p.pose);
        chart.svg.mark(CALIBRATION, middle, 3.4, &tip);
        chart.svg.text("end", (WIDE - 4.0, middle.1 + 4.0), &format!("{value} ± {half}"));
    }
    chart.svg.legend(CALIBRATION, &tr!(words, "change-with-interval"));
    if shown_rows.iter().any(|p| p.tolerance_mm.is_some()) {
        chart.svg.legend(Look::new(Shape::Square, "zone-pass"), &tr!(words, "stated-tolerance"));
    }
    let title = tr!(words, "effects-title");
    let description = tr!(words, "effects-description", count = shown_rows.len(), total = all.len());
    Some(chart.figure("effects", title, description))
}

#[cfg(test)]
mod tests {
    use super::super::svg::numbers;
    use super::*;

    #[test]
    fn the_largest_effects_are_drawn_with_their_intervals_and_tolerances() {
        let of = |i: i64, change_mm: f64| ParameterInfluence {
            name: format!("p{i}"),
            pose: i.into(),
            change_mm,
            standard_uncertainty_mm: Some(0.005),
            tolerance_mm: (i == 0).then_some(0.05),
        };
        let all: Vec<_> = (0..15).map(|i| of(i, 0.19 / (1.0 + i as f64))).collect();
        let svg = picture(&all, &Words::default()).unwrap().svg;
        // the legend has a mark too
        assert_eq!(svg.matches("<circle class=\"cal\"").count(), ROWS + 1, "{svg}");
        assert!(svg.contains("p0: 190 ± 10 µm at pose 0"), "{svg}");
        // tolerance of 50 µm on an axis of ±200 µm: a quarter of it
        let bars = numbers(&svg, "rect", "width");
        let lines = numbers(&svg, "line", "x2");
        let widest = lines.iter().copied().fold(0.0, f64::max) - lines.iter().copied().fold(WIDE, f64::min);
        assert!((bars[0] / widest - 0.25).abs() < 0.05, "{bars:?} {widest}");
        assert!(picture(&[], &Words::default()).is_none());
    }
}
