//! Residuals after calibration: all components by pose, and residuals of the calibration poses
//! against a normal distribution.

use super::by_pose;
use super::layer::*;
use statrs::distribution::{ContinuousCDF, Normal};

/// Maximum number of legible marks.
const LIMIT: usize = 200;
/// Minimum number of residuals that show a distribution.
const FEWEST: usize = 10;

/// Residuals by pose, and against the normal distribution.
pub(crate) fn pictures(errors: &[&PointError], planar: bool, words: &Words) -> Vec<Figure> {
    let axes = if planar { 2 } else { 3 };
    let largest = largest(errors.iter().flat_map(|p| &p.after_mm[..axes]).map(|v| v.abs()));
    if largest <= 0.0 {
        return vec![];
    }
    let up = Axis::both_ways(number::display_unit("mm", largest), largest);
    [Some(by_poses(errors, axes, &up, words)), quantiles(errors, axes, &up, words)].into_iter().flatten().collect()
}

fn by_poses(errors: &[&PointError], axes: usize, up: &Axis, words: &Words) -> Figure {
    // each error has a mark for each axis
    let drawn = points::thin(&points::readable(errors), points::MARKS / axes, points::after_mm);
    let poses = by_pose::poses(&drawn);
    let name = tr!(words, "measured-minus-predicted-in", unit = up.display_unit().unit);
    let mut chart = Chart::new(words, WIDE, [by_pose::across(&poses), up.clone()], [tr!(words, "pose"), name]);
    chart.level("axis", 0.0);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate().take(axes) {
        // side by side
        let aside = 0.22 * (axis as f64 - 0.5 * (axes - 1) as f64);
        for p in &drawn {
            let at = chart.at(by_pose::place(&poses, p) + aside, p.after_mm[axis]);
            chart.svg.mark(Look::group(axis), at, 2.6, &points::tooltip(p, words));
        }
        chart.svg.legend(Look::group(axis), name);
    }
    let title = tr!(words, "residuals-by-pose");
    let description = tr!(words, "residuals-by-pose-description");
    let note = tr!(words, "residuals-pattern");
    let caption = note + &points::how_many(drawn.len(), errors.len(), words);
    Figure { caption, ..chart.figure("residuals", title, description) }
}

/// Sorted residuals over the quantiles of a normal distribution; noise lies on a line.
fn quantiles(errors: &[&PointError], axes: usize, up: &Axis, words: &Words) -> Option<Figure> {
    let calibration = errors.iter().filter(|p| !points::is_validation(p));
    let mut all: Vec<(f64, &PointError)> =
        calibration.flat_map(|p| p.after_mm[..axes].iter().map(|v| (*v, *p))).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (count, normal) = (all.len(), Normal::new(0.0, 1.0).ok()?);
    if count < FEWEST {
        return None;
    }
    let mean = all.iter().map(|r| r.0).sum::<f64>() / count as f64;
    let deviation = (all.iter().map(|r| (r.0 - mean).powi(2)).sum::<f64>() / (count - 1) as f64).sqrt();
    // plotting positions of Blom (1958)
    let quantile = |i: usize| normal.inverse_cdf((i as f64 + 0.625) / (count as f64 + 0.25));
    let (across, shown) = (Axis::both_ways(number::display_unit("", 0.0), -quantile(0)), up.display_unit());
    let (widest, reach) = (across.ends().1, up.ends().1);
    let names = [tr!(words, "normal-quantile"), tr!(words, "measured-minus-predicted-in", unit = shown.unit)];
    let mut chart = Chart::new(words, NARROW, [across, up.clone()], names);
    // clipped at the edge of the figure
    let end = |q: f64| if deviation > 0.0 { q.signum() * q.abs().min((reach - mean.abs()) / deviation) } else { q };
    let [from, to] = [-widest, widest].map(|q| chart.at(end(q), mean + deviation * end(q)));
    chart.svg.line("knee", from, to);
    let stride = count.div_ceil(LIMIT);
    for (i, (value, p)) in all.iter().enumerate().filter(|(i, _)| i % stride == 0 || *i + 1 == count) {
        let at = chart.at(quantile(i), *value);
        chart.svg.mark(CALIBRATION, at, 2.4, &points::tooltip(p, words));
    }
    let title = tr!(words, "residuals-against-normal");
    let description = tr!(words, "quantiles-description");
    let decimals = number::decimals(deviation * shown.factor, 2).unwrap_or(0);
    let [mean, deviation] =
        [mean, deviation].map(|v| format!("{} {}", number::fixed(v * shown.factor, decimals), shown.unit));
    let caption = tr!(words, "residuals-summary", count, mean, deviation);
    Some(Figure { caption, ..chart.figure("quantiles", title, description) })
}

#[cfg(test)]
mod tests {
    use super::super::svg::numbers;
    use super::*;
    use crate::tests::demo::point;

    #[test]
    fn normal_residuals_lie_on_the_line_and_a_blunder_does_not() {
        let normal = Normal::new(0.0, 1.0).unwrap();
        let drawn = |i: i64| 0.003 * normal.inverse_cdf((i as f64 + 0.625) / 40.25);
        let mut errors: Vec<_> =
            (0..20).map(|i| point(i, [0.0; 3], [0.1; 3], [drawn(2 * i), drawn(2 * i + 1), 0.0])).collect();
        let off = |errors: &[PointError]| {
            let all: Vec<_> = errors.iter().collect();
            let svg = pictures(&all, true, &Words::default()).remove(1).svg;
            let line = svg.lines().find(|l| l.contains("class=\"knee\"")).unwrap();
            let [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map(|end| numbers(line, "line", end)[0]);
            let below = |(x, y): (f64, f64)| (y1 + (y2 - y1) / (x2 - x1) * (x - x1) - y).abs();
            let (x, y) = (numbers(&svg, "circle", "cx"), numbers(&svg, "circle", "cy"));
            assert_eq!(x.len(), 40);
            x.into_iter().zip(y).map(below).fold(0.0, f64::max)
        };
        assert!(off(&errors) < 4.0, "{}", off(&errors));
        errors[7].after_mm[0] = 0.03;
        assert!(off(&errors) > 40.0, "{}", off(&errors));
    }

    #[test]
    fn signs_are_kept_and_nothing_to_draw_draws_nothing() {
        let errors =
            [point(1, [0.0; 3], [0.1; 3], [0.004, 0.0, 0.0]), point(2, [0.0; 3], [0.1; 3], [-0.004, 0.0, 0.0])];
        let pictures = pictures(&errors.iter().collect::<Vec<_>>(), true, &Words::default());
        assert_eq!(pictures.len(), 1);
        assert!(pictures[0].svg.contains("(x 4.0, ") && pictures[0].svg.contains("(x -4.0, "));
        assert!(super::pictures(&[], true, &Words::default()).is_empty());
    }
}
