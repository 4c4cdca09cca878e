//! Histograms of the errors before and after calibration: calibration poses compared with
//! validation poses.

use super::axis::step;
use super::layer::*;

const BINS: usize = 12;

/// Shares of the points by size of the error, before and after calibration; a pair of figures for
/// each quantity.
pub(crate) fn histograms(errors: &[&PointError], limits: &[LimitVerdict], words: &Words) -> Vec<Figure> {
    let all = points::by_quantity(errors);
    let both = all.iter().flat_map(|of_one| [false, true].map(|after| (of_one, after)));
    both.filter_map(|((quantity, errors), after)| histogram(*quantity, errors, limits, after, words)).collect()
}

/// Number of points of a set in each bin.
struct Counts {
    class: &'static str,
    name: String,
    bins: Vec<usize>,
    total: usize,
}

fn histogram(
    quantity: ErrorQuantity,
    errors: &[&PointError],
    limits: &[LimitVerdict],
    after: bool,
    words: &Words,
) -> Option<Figure> {
    let size = points::size(after);
    let largest_mm = range(errors.iter().map(|p| size(p)))?[1];
    let shown = number::display_unit("mm", largest_mm);
    let largest = if largest_mm > 0.0 { largest_mm * shown.factor } else { 1.0 };
    let width = step(largest, BINS);
    let bins = ((largest / width - 1e-9).ceil() as usize).clamp(1, BINS + 1);
    let bin = |p: &PointError| ((size(p) * shown.factor / width) as usize).min(bins - 1);
    let counted = |(look, name): (Look<'static>, Phrase)| {
        let of_set: Vec<usize> = errors.iter().filter(|p| points::look(p) == look).map(|p| bin(p)).collect();
        let bins = (0..bins).map(|bin| of_set.iter().filter(|b| **b == bin).count()).collect();
        Counts { class: look.class, name: words.tr(&name), bins, total: of_set.len() }
    };
    let sets: Vec<Counts> = points::sets(errors).into_iter().map(counted).collect();
    let share = |set: &Counts, bin: usize| 100.0 * set.bins[bin] as f64 / set.total.max(1) as f64;
    let highest = sets.iter().flat_map(|set| (0..bins).map(|bin| share(set, bin))).fold(0.0, f64::max);
    let across = Axis::linear_in(shown, 0.0, bins as f64 * width);
    let names = [tr!(words, "error-in-unit", unit = shown.unit), tr!(words, "share-of-set")];
    let mut chart = Chart::new(words, NARROW, [across, Axis::from_zero("", highest)], names);
    let decimals = number::decimals(width, 1).unwrap_or(0);
    let edge = |bin: usize| number::fixed(bin as f64 * width, decimals);
    let bin_px = (chart.frame.right - chart.frame.left) / bins as f64;
    let bar_px = (bin_px - 3.0).max(1.0) / sets.len().max(1) as f64;
    for (i, set) in sets.iter().enumerate() {
        let look = Look::new(Shape::Square, set.class);
        for bin in (0..bins).filter(|bin| set.bins[*bin] > 0) {
            let percent = number::fixed(share(set, bin), 1);
            let tip = tr!(
                words,
                "histogram-tooltip",
                from = edge(bin),
                to = edge(bin + 1),
                unit = shown.unit,
                points = set.bins[bin],
                set = set.name,
                percent
            );
            let x = chart.frame.left + 1.5 + bin as f64 * bin_px + i as f64 * bar_px;
            chart.bar_up(look, (x, bar_px), share(set, bin), &tip);
        }
        chart.svg.legend(look, &set.name);
    }
    chart.limit(limits, quantity, true, words);
    let name = words.tr(&quantity.phrase());
    let title = match after {
        true => tr!(words, "error-sizes-after", quantity = name),
        false => tr!(words, "error-sizes-before", quantity = name),
    };
    let step_text = format!("{} {}", number::significant(width, 1), shown.unit);
    let description = tr!(words, "histogram-description", step = step_text);
    let mut header = vec![tr!(words, "from-in-unit", unit = shown.unit), tr!(words, "to")];
    header.extend(sets.iter().map(|set| tr!(words, "points-of", set = set.name)));
    let row = |bin: usize| {
        [edge(bin), edge(bin + 1)]
            .map(|v| words.decimal(v))
            .into_iter()
            .chain(sets.iter().map(move |set| set.bins[bin].to_string()))
    };
    let totals: Vec<_> = sets.iter().map(|set| tr!(words, "count-of-set", count = set.total, set = set.name)).collect();
    let side = points::side(after);
    Some(Figure {
        pair: format!("histogram-{quantity}"),
        side,
        caption: tr!(words, "histogram-shares", step = step_text, totals = totals.join(", ")),
        table_title: tr!(words, "numbers-of-this-picture"),
        header,
        rows: (0..bins).map(|bin| row(bin).collect()).collect(),
        ..chart.figure(&format!("histogram-{quantity}-{side}"), title, description)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

    #[test]
    fn every_point_is_in_one_bin() {
        let mut errors: Vec<_> =
            (0..100).map(|i| point(i, [0.0; 3], [0.1; 3], [f64::from(i as i32) * 1e-4, 0.0, 0.0])).collect();
        errors.iter_mut().skip(60).for_each(|p| p.set = PoseSet::Validation);
        let picture =
            histogram(ErrorQuantity::Position, &errors.iter().collect::<Vec<_>>(), &[], true, &Words::default())
                .unwrap();
        let total = |column: usize| picture.rows.iter().map(|r| r[column].parse::<usize>().unwrap()).sum::<usize>();
        assert_eq!((total(2), total(3), picture.rows.len()), (60, 40, 10));
        assert_eq!(picture.rows[1][..3], ["1", "2", "10"].map(str::to_owned));
    }

    #[test]
    fn equal_values_and_zeros_are_drawn_and_nothing_is_not() {
        for after in [[0.0; 3], [0.5; 3]] {
            let errors = vec![point(1, [0.0; 3], [0.1; 3], after); 4];
            let picture =
                histogram(ErrorQuantity::Position, &errors.iter().collect::<Vec<_>>(), &[], true, &Words::default())
                    .unwrap();
            assert_eq!(picture.svg.matches("4 points of calibration, 100.0 %").count(), 1);
        }
        assert!(histograms(&[], &[], &Words::default()).is_empty());
    }
}
