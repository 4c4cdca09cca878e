//! Histograms of the errors before and after calibration, overlaid on one logarithmic axis.

use super::layer::*;

/// Number of bins.
const BINS: usize = 24;
/// Maximum number of decades; smaller errors are in the first bin.
const DECADES: f64 = 4.0;

/// Shares of the points of the deciding set, by size of their error; one figure for each quantity.
pub(crate) fn pictures(errors: &[&PointError], limits: &[LimitVerdict], words: &Words) -> Vec<Figure> {
    let all = points::by_quantity(errors).into_iter();
    all.filter_map(|(quantity, errors)| picture(quantity, &errors, limits, words)).collect()
}

fn picture(quantity: ErrorQuantity, errors: &[&PointError], limits: &[LimitVerdict], words: &Words) -> Option<Figure> {
    let deciding = errors.iter().map(|e| e.set).max()?;
    let of: Vec<&&PointError> = errors.iter().filter(|e| e.set == deciding).collect();
    let sizes = |after: bool| -> Vec<f64> {
        of.iter().map(|e| points::size(after)(e)).filter(|v| v.is_finite() && drawable(*v)).collect()
    };
    let (before, after) = (sizes(false), sizes(true));
    let high = largest(before.iter().chain(&after).copied());
    let positive = before.iter().chain(&after).copied().filter(|v| *v > 0.0);
    let low = range(positive)?[0].max(high * 10f64.powf(-DECADES));
    let axis = Axis::decades("mm", [low, high], DECADES as u8);
    let bin = |v: f64| ((axis.share(v) * BINS as f64) as usize).min(BINS - 1);
    let shares = |all: &[f64]| {
        let mut counts = [0usize; BINS];
        all.iter().for_each(|v| counts[bin(*v)] += 1);
        counts.map(|n| 100.0 * n as f64 / all.len().max(1) as f64)
    };
    let both =
        [(shares(&before), "bar-before", before_or_after(false)), (shares(&after), "bar-after", before_or_after(true))];
    let highest = largest(both.iter().flat_map(|(s, ..)| s.iter().copied()));
    let unit = axis.display_unit().unit;
    let names = [tr!(words, "error-log", unit), tr!(words, "share-of-points")];
    let mut chart = Chart::new(words, NARROW, [axis, Axis::from_zero("", highest)], names);
    let wide = (chart.frame.right - chart.frame.left) / BINS as f64;
    for (shares, class, name) in &both {
        for (i, share) in shares.iter().enumerate().filter(|(_, s)| **s > 0.0) {
            let tip = format!("{}: {} %", words.tr(name), words.fixed(*share, 1));
            let x = chart.frame.left + i as f64 * wide;
            chart.bar_up(Look::new(Shape::Square, class), (x, wide), *share, &tip);
        }
        chart.svg.legend(Look::new(Shape::Square, class), &words.tr(name));
    }
    chart.limit(limits, quantity, true, words);
    let title = tr!(words, "errors-overlaid-title", quantity = words.tr(&quantity.phrase()));
    let set = words.tr(&deciding.phrase());
    let description = tr!(words, "errors-overlaid-description", count = of.len(), set);
    Some(chart.figure(&format!("errors-overlaid-{quantity}"), title, description))
}

fn before_or_after(after: bool) -> Phrase {
    if after { etalon_base::phrase!("after") } else { etalon_base::phrase!("before") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

    /// All errors before are 1 mm and all after are 0.01 mm: one bar each, at its end of the axis.
    #[test]
    fn before_and_after_share_an_axis() {
        let errors: Vec<_> = (0..10).map(|i| point(i, [0.0; 3], [1.0, 0.0, 0.0], [0.01, 0.0, 0.0])).collect();
        let drawn = |errors: &[PointError]| pictures(&errors.iter().collect::<Vec<_>>(), &[], &Words::default());
        let svg = drawn(&errors).remove(0).svg;
        for (class, name) in [("bar-before", "before"), ("bar-after", "after")] {
            assert_eq!(svg.matches(&format!("class=\"{class}\"")).count(), 2, "a bar and its legend: {svg}");
            assert!(svg.contains(&format!("<title>{name}: 100.0 %</title>")), "{svg}");
        }
        let zeros: Vec<_> = (0..3).map(|i| point(i, [0.0; 3], [0.0; 3], [0.0; 3])).collect();
        assert!(drawn(&zeros).is_empty() && drawn(&[]).is_empty());
    }

    /// Four distances and six contacts of other sizes: a figure each, named after its quantity.
    #[test]
    fn quantities_are_not_mixed() {
        let mut errors: Vec<_> = (0..10).map(|i| point(i, [0.0; 3], [1.0, 0.0, 0.0], [0.01, 0.0, 0.0])).collect();
        for (i, p) in errors.iter_mut().enumerate() {
            p.quantity = if i < 4 { ErrorQuantity::Distance } else { ErrorQuantity::Contact };
            p.after_mm[0] = if i < 4 { 0.01 } else { 0.1 };
        }
        let all = pictures(&errors.iter().collect::<Vec<_>>(), &[], &Words::default());
        let titles: Vec<&str> = all.iter().map(|f| f.title.as_str()).collect();
        assert_eq!(titles, ["Errors before and after: distance", "Errors before and after: contact"]);
        for (figure, count) in all.iter().zip(["4 points", "6 points"]) {
            assert!(figure.caption.contains(count), "{}", figure.caption);
            assert!(figure.svg.contains("<title>after: 100.0 %</title>"), "{}", figure.svg);
        }
    }
}
