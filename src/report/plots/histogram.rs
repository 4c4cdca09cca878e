//! How large the errors before and after calibration are: calibration poses against validation poses.

use super::axis::{Axis, range, step};
use super::limit_lines::LimitLines;
use super::points;
use super::svg::{Shape, Svg};
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_documents::{LimitVerdict, PointError};
use std::fmt::Display;

const WIDTH: f64 = 380.0;
const HEIGHT: f64 = 340.0;
const LEFT: f64 = 52.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 36.0;
const BOTTOM: f64 = 296.0;
const BINS: usize = 12;

/// Shares of the points by size of the position error, before and after.
pub(crate) fn histograms(errors: &[&PointError], limits: &[LimitVerdict], words: &Words) -> Vec<Figure> {
    [false, true].into_iter().filter_map(|after| histogram(errors, limits, after, words)).collect()
}

fn histogram(errors: &[&PointError], limits: &[LimitVerdict], after: bool, words: &Words) -> Option<Figure> {
    let sets = points::sets(errors);
    let size: fn(&PointError) -> f64 = if after { points::after_mm } else { points::before_mm };
    let largest_mm = range(errors.iter().map(|p| size(p)))?.1;
    let shown = number::shown("mm", largest_mm);
    let largest = if largest_mm > 0.0 { largest_mm * shown.factor } else { 1.0 };
    let width = step(largest, BINS);
    let bins = ((largest / width - 1e-9).ceil() as usize).clamp(1, BINS + 1);
    let counts = sets.iter().map(|(_, class, _)| {
        let mut counts = vec![0usize; bins];
        for p in errors.iter().filter(|p| points::class(p) == *class) {
            counts[((size(p) * shown.factor / width) as usize).min(bins - 1)] += 1;
        }
        counts
    });
    let counts: Vec<Vec<usize>> = counts.collect();
    let share = |counts: &[usize], bin: usize| 100.0 * counts[bin] as f64 / counts.iter().sum::<usize>().max(1) as f64;
    let highest = counts.iter().flat_map(|c| (0..bins).map(|bin| share(c, bin))).fold(0.0, f64::max);
    let title = match after {
        true => words.say("Sizes of the position error after calibration"),
        false => words.say("Sizes of the position error before calibration"),
    };
    let side = if after { "after" } else { "before" };
    let step_text = format!("{} {}", number::significant(width, 1), shown.unit);
    let description = words.fill("Share of the points of each set in steps of {0}.", &[&step_text]);
    let across = Axis::linear(0.0, bins as f64 * width, LEFT, WIDTH - RIGHT);
    let on_axis = |v: f64| Some(v * shown.factor).filter(|v| *v <= across.high()).map(|v| across.at(v));
    let limits = LimitLines::new(&points::limits_of(limits, "position"), on_axis);
    let height = HEIGHT + limits.height(WIDTH);
    let mut svg = Svg::new(&format!("histogram-{side}"), WIDTH, height, &title, &description);
    let up = Axis::from_zero(highest, BOTTOM, TOP);
    draw_axes(&mut svg, &across, &up, shown.unit, words);
    let decimals = number::decimals(width, 1).unwrap_or(0);
    let edge = |bin: usize| number::fixed(bin as f64 * width, decimals);
    let bin_px = (WIDTH - LEFT - RIGHT) / bins as f64;
    let bar_px = (bin_px - 3.0).max(1.0) / sets.len().max(1) as f64;
    for (i, ((_, class, name), counts)) in sets.iter().zip(&counts).enumerate() {
        for bin in 0..bins {
            let percent = share(counts, bin);
            let corner = (LEFT + 1.5 + bin as f64 * bin_px + i as f64 * bar_px, up.at(percent));
            let percent = number::fixed(percent, 1);
            let values: [&dyn Display; 6] =
                [&edge(bin), &edge(bin + 1), &shown.unit, &counts[bin], &words.say(name), &percent];
            let tip = words.fill("{0} to {1} {2}: {3} points of {4}, {5} %", &values);
            if counts[bin] > 0 {
                svg.rect(class, corner, (bar_px, BOTTOM - corner.1), &tip);
            }
        }
        let x = LEFT + 8.0 + 130.0 * i as f64;
        svg.rect(class, (x - 5.0, 11.0), (10.0, 10.0), "");
        svg.text("start", (x + 10.0, 20.0), &words.say(name));
    }
    limits.upright(&mut svg, (TOP, BOTTOM));
    limits.legend(&mut svg, HEIGHT, WIDTH);
    let mut header = vec![words.fill("from, in {0}", &[&shown.unit]), words.say("to")];
    header.extend(sets.iter().map(|s| words.fill("{0} points", &[&words.say(s.2)])));
    let row =
        |bin: usize| [edge(bin), edge(bin + 1)].into_iter().chain(counts.iter().map(|c| c[bin].to_string())).collect();
    let total = |(set, counts): (&(Shape, &str, &str), &Vec<usize>)| {
        words.fill("{0} points of {1}", &[&counts.iter().sum::<usize>(), &words.say(set.2)])
    };
    let totals: Vec<_> = sets.iter().zip(&counts).map(total).collect();
    Some(Figure {
        title,
        pair: "histogram".to_owned(),
        side,
        svg: svg.finish(),
        caption: words.fill("Share of each set in steps of {0}: {1}.", &[&step_text, &totals.join(", ")]),
        table_title: words.say("Numbers of this picture"),
        header,
        rows: (0..bins).map(row).collect(),
        ..Figure::default()
    })
}

fn draw_axes(svg: &mut Svg, across: &Axis, up: &Axis, unit: &str, words: &Words) {
    for (value, label) in up.ticks(5) {
        let y = up.at(value);
        svg.line("grid", (LEFT, y), (WIDTH - RIGHT, y));
        svg.text("end", (LEFT - 6.0, y + 4.0), &label);
    }
    for (value, label) in across.ticks(6) {
        let x = across.at(value);
        svg.line("axis", (x, BOTTOM), (x, BOTTOM + 4.0));
        svg.text("mid", (x, BOTTOM + 17.0), &label);
    }
    svg.line("axis", (LEFT, BOTTOM), (WIDTH - RIGHT, BOTTOM));
    svg.line("axis", (LEFT, TOP), (LEFT, BOTTOM));
    svg.text("mid", ((LEFT + WIDTH - RIGHT) / 2.0, BOTTOM + 36.0), &words.fill("position error in {0}", &[&unit]));
    svg.text_upwards((14.0, (TOP + BOTTOM) / 2.0), &words.say("share of the set in %"));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

    #[test]
    fn every_point_is_in_one_bin() {
        let mut errors: Vec<_> =
            (0..100).map(|i| point(i, [0.0; 3], [0.1; 3], [f64::from(i as i32) * 1e-4, 0.0, 0.0])).collect();
        errors.iter_mut().skip(60).for_each(|p| p.set = "validation".to_owned());
        let picture = histogram(&errors.iter().collect::<Vec<_>>(), &[], true, &Words::default()).unwrap();
        let total = |column: usize| picture.rows.iter().map(|r| r[column].parse::<usize>().unwrap()).sum::<usize>();
        assert_eq!((total(2), total(3), picture.rows.len()), (60, 40, 10));
        assert_eq!(picture.rows[1][..3], ["1", "2", "10"].map(str::to_owned));
    }

    #[test]
    fn equal_values_and_zeros_are_drawn_and_nothing_is_not() {
        for after in [[0.0; 3], [0.5; 3]] {
            let errors = vec![point(1, [0.0; 3], [0.1; 3], after); 4];
            let picture = histogram(&errors.iter().collect::<Vec<_>>(), &[], true, &Words::default()).unwrap();
            assert_eq!(picture.svg.matches("4 points of calibration, 100.0 %").count(), 1);
        }
        assert!(histograms(&[], &[], &Words::default()).is_empty());
    }
}
