//! Page one in figures: each limit with its value, uncertainty, guard band and risk as a bullet
//! graph (S. Few, Bullet Graph Design Specification, 2013), and errors before and after on one
//! axis.

use super::layer::*;
use super::svg::{proportional, width};
use crate::model::Headline;
use crate::number::DisplayUnit;
use crate::sections::limits::{judged, reached_within};
use etalon_documents::{Conformity, DecisionRule};

/// Height of a row with a line of text above and below its bar.
const ROW_HEIGHT: f64 = 62.0;
/// Height of a line of text.
const LINE: f64 = 15.0;
/// Height of a bar.
const BAR: f64 = 14.0;
/// Size of a bold letter, relative to other letters.
const BOLD: f64 = 1.1;
/// Margin at both sides.
const SIDE: f64 = 10.0;
/// Minimum right end of the scale, over the limit.
const LEAST: f64 = 1.25;
/// Maximum right end of the scale, over the limit; a larger value ends there with an arrow.
const MOST: f64 = 2.5;

/// Bullet graph of all limits on one scale: value over limit.
pub(crate) fn limits(all: &[&LimitVerdict], words: &Words) -> Option<Figure> {
    let positive: Vec<&&LimitVerdict> = all.iter().filter(|l| l.limit > 0.0).collect();
    if positive.is_empty() {
        return None;
    }
    let reach = |l: &LimitVerdict| (l.value.unwrap_or(0.0) + l.expanded_uncertainty.unwrap_or(0.0)) / l.limit;
    // only guarded acceptance has a guard band
    let guarded = positive.iter().any(|l| l.decision_rule == DecisionRule::Guarded);
    let end = (1.05 * largest(positive.iter().map(|l| reach(l)))).clamp(LEAST, MOST);
    let mut svg = Svg::new(words, NARROW, ROW_HEIGHT * positive.len() as f64);
    for (i, l) in positive.iter().enumerate() {
        limit(&mut svg, l, ROW_HEIGHT * i as f64, end, words);
    }
    svg.legend(Look::new(Shape::Square, "value"), &tr!(words, "bullet-value"));
    svg.legend(Look::new(Shape::Square, "zone-pass"), &tr!(words, "bullet-accepted"));
    let within = if guarded { tr!(words, "bullet-guard-band") } else { tr!(words, "bullet-within-u") };
    svg.legend(Look::new(Shape::Square, "zone-guard"), &within);
    svg.legend(Look::new(Shape::Square, "zone-fail"), &tr!(words, "bullet-beyond"));
    svg.legend_line("limit", &tr!(words, "limit"));
    let intervals = positive.iter().filter(|l| l.interval.is_some()).count();
    let drawn = match intervals {
        0 => "uncertainty",
        n if n == positive.len() => "interval",
        _ => "both",
    };
    let description = match guarded {
        true => tr!(words, "bullet-description", drawn),
        false => tr!(words, "bullet-description-accepted", drawn),
    };
    let title = tr!(words, "limits");
    Some(svg.figure("bullets", title, description))
}

/// One limit at the height `top`, on a scale from zero to `end` times the limit.
fn limit(svg: &mut Svg, l: &LimitVerdict, top: f64, end: f64, words: &Words) {
    let at = |share: f64| SIDE + (NARROW - 2.0 * SIDE) * (share / end).clamp(0.0, 1.0);
    let y = top + 20.0;
    let u = l.expanded_uncertainty.unwrap_or(0.0) / l.limit;
    let guard = (1.0 - u).max(0.0);
    let text = stated(l, words);
    for (class, from, to) in [("zone-pass", 0.0, guard), ("zone-guard", guard, 1.0), ("zone-fail", 1.0, end)] {
        if at(to) > at(from) {
            svg.rect(Look::new(Shape::Square, class), (at(from), y), (at(to) - at(from), BAR), "");
        }
    }
    if let Some(value) = l.value {
        let value = value / l.limit;
        let thin = (at(0.0), y + 0.3 * BAR);
        svg.rect(Look::new(Shape::Square, "value"), thin, ((at(value) - at(0.0)).max(1.5), 0.4 * BAR), &text);
        if u > 0.0 {
            let middle = y + 0.5 * BAR;
            let ends = l.interval.map_or([value - u, value + u], |ends| ends.map(|end| end / l.limit)).map(at);
            svg.line("mean", (ends[0], middle), (ends[1], middle));
            for x in ends {
                svg.line("mean", (x, middle - 4.0), (x, middle + 4.0));
            }
        }
        if value > end {
            svg.arrows("arrow-scale", &[[(at(end) - 12.0, y + 0.5 * BAR), (at(end), y + 0.5 * BAR)]]);
        }
    }
    svg.line("limit", (at(1.0), y - 4.0), (at(1.0), y + BAR + 4.0));
    let verdict = judged(l, words).display().plain();
    let room = NARROW - 2.0 * SIDE - width(&verdict) - 10.0;
    svg.text("start name-of", (SIDE, top + 12.0), &cut(&words.tr(&names::limit(l.name)), room, BOLD));
    svg.text("end name-of", (NARROW - SIDE, top + 12.0), &verdict);
    svg.text("start", (SIDE, y + BAR + 15.0), &cut(&text, NARROW - 2.0 * SIDE, 1.0));
}

/// Shortens a text to a width; `size` is the size of its letters relative to plain letters.
fn cut(text: &str, room: f64, size: f64) -> String {
    let fits = |text: &str| size * proportional(text) <= room;
    if fits(text) {
        return text.to_owned();
    }
    let letters: Vec<char> = text.chars().collect();
    let shortened = |n: usize| letters[..n].iter().chain(&['…']).collect::<String>();
    (0..letters.len()).rev().map(shortened).find(|text| fits(text)).unwrap_or_default()
}

/// Value with its uncertainty, limit, and risk.
fn stated(l: &LimitVerdict, words: &Words) -> String {
    let DisplayUnit { unit, factor } = number::display_unit(&l.unit, l.limit);
    let allowed = number::derived(l.limit * factor);
    let Some(value) = l.value.filter(|_| l.conformity != Conformity::NotAssessable) else {
        return tr!(words, "bullet-not-measured", limit = allowed, unit);
    };
    let reached = reached_within(l, value, factor, words);
    match l.risk() {
        Some(risk) => {
            let risk = number::percent(100.0 * risk);
            tr!(words, "bullet-value-limit-risk", value = reached, unit, limit = allowed, risk)
        }
        None if l.lacks_coverage() => tr!(words, "bullet-value-limit-drift", value = reached, unit, limit = allowed),
        None => tr!(words, "bullet-value-limit", value = reached, unit, limit = allowed),
    }
}

/// Error before and after calibration with its unit.
fn before_and_after(h: &Headline, words: &Words) -> String {
    let [before, after] = [&h.before, &h.after].map(|number| words.decimal(number.clone()));
    format!("{before} → {after} {}", h.unit)
}

/// Lines of a name, each within the width of the figure.
fn lines(name: &str) -> Vec<String> {
    let fits = |text: &str| BOLD * proportional(text) <= NARROW - 2.0 * SIDE;
    let mut all: Vec<String> = Vec::new();
    for word in name.split(' ') {
        match all.last_mut() {
            Some(line) if fits(&format!("{line} {word}")) => *line = format!("{line} {word}"),
            _ => all.push(word.to_owned()),
        }
    }
    all
}

/// Height of a row; a name that does not fit beside its numbers is above them.
fn row(h: &Headline, words: &Words) -> f64 {
    let beside = BOLD * proportional(&h.what) + width(&before_and_after(h, words)) + 30.0 <= NARROW;
    if beside { 40.0 } else { 40.0 + LINE * lines(&h.what).len() as f64 }
}

/// Errors before and after calibration; errors of the same unit are on one axis.
pub(crate) fn before_after(all: &[Headline], title: &str, words: &Words) -> Option<Figure> {
    let units = ["mm", "deg"].into_iter().filter(|unit| all.iter().any(|h| h.in_documents.0 == *unit));
    if all.is_empty() {
        return None;
    }
    let rows = |unit: &str| all.iter().filter(|h| h.in_documents.0 == unit).map(|h| row(h, words)).sum::<f64>();
    let height = units.clone().map(|unit| rows(unit) + 44.0).sum();
    let mut svg = Svg::new(words, NARROW, height);
    let mut top = 0.0;
    for unit in units {
        let of_unit: Vec<&Headline> = all.iter().filter(|h| h.in_documents.0 == unit).collect();
        let values = of_unit.iter().flat_map(|h| h.in_documents.1);
        let axis = Axis::from_zero(unit, largest(values));
        let at = |v: f64| SIDE + axis.share(v) * (NARROW - 2.0 * SIDE);
        let bottom = top + of_unit.iter().map(|h| row(h, words)).sum::<f64>() + 6.0;
        for (v, label) in axis.ticks(5) {
            svg.line("grid", (at(v), top + 18.0), (at(v), bottom));
            let half = 0.5 * width(&label) + 2.0;
            let inside = at(v).clamp(half, NARROW - half);
            svg.number("mid", (inside, bottom + 14.0), &label);
        }
        svg.line("axis", (SIDE, bottom), (NARROW - SIDE, bottom));
        let shown = if axis.display_unit().unit.is_empty() { unit } else { axis.display_unit().unit };
        svg.text("mid", (0.5 * NARROW, bottom + 30.0), &tr!(words, "error-in-unit", unit = shown));
        for h in of_unit {
            let ([before, after], numbers) = (h.in_documents.1, before_and_after(h, words));
            for (i, line) in lines(&h.what).iter().enumerate() {
                let y = top + 14.0 + LINE * i as f64;
                svg.text("start name-of", (SIDE, y), &cut(line, NARROW - 2.0 * SIDE, BOLD));
            }
            top += row(h, words);
            let y = top - 12.0;
            svg.text("end", (NARROW - SIDE, y - 14.0), &numbers);
            svg.line("leader", (at(before), y), (at(after), y));
            svg.mark(Look::new(Shape::Circle, "before"), (at(before), y), 5.0, &numbers);
            svg.mark(CALIBRATION, (at(after), y), 5.0, &numbers);
        }
        top = bottom + 38.0;
    }
    svg.legend(Look::new(Shape::Circle, "before"), &tr!(words, "before"));
    svg.legend(CALIBRATION, &tr!(words, "after"));
    Some(svg.figure("before-after", title.to_owned(), tr!(words, "before-after-description")))
}

#[cfg(test)]
mod tests {
    use super::super::svg::numbers;
    use super::*;
    use etalon_documents::LimitQuantity;

    fn guarded_verdict(limit: f64, value: f64, u: f64) -> LimitVerdict {
        LimitVerdict::judge(LimitQuantity::PositionMaxMm, limit, value, Some(u), DecisionRule::Guarded)
    }

    /// Value 0.8 of the limit, U = 0.1: accepted to 0.9 of it on a scale that ends at 1.25.
    #[test]
    fn bar_zones_and_limit_are_on_one_scale() {
        let l = guarded_verdict(0.1, 0.08, 0.01);
        let svg = limits(&[&l], &Words::default()).unwrap().svg;
        let room = NARROW - 2.0 * SIDE;
        let widths = numbers(&svg, "rect", "width");
        for (i, share) in [0.9, 0.1, 0.25, 0.8].into_iter().enumerate() {
            assert!((widths[i] - room * share / LEAST).abs() < 0.11, "{i}: {widths:?}");
        }
        assert!(svg.contains("80 ± 10 µm, limit 100 µm, risk &lt; 0.1 %"), "{svg}");
        // twice as much moves the bar and no zone
        let larger = limits(&[&guarded_verdict(0.1, 0.082, 0.01)], &Words::default()).unwrap().svg;
        assert!(numbers(&larger, "rect", "width")[3] > widths[3]);
    }

    /// RP of the sample pose-test, 57.8 to 90.2 µm about 71.6 µm: the ends are drawn, and no
    /// symmetric form is stated.
    #[test]
    fn an_asymmetric_interval_is_drawn_and_stated_by_its_ends() {
        let quantity = LimitQuantity::RepeatabilityMaxMm;
        let l = LimitVerdict::judge(quantity, 0.1, 0.0716, Some(0.0186), DecisionRule::Guarded);
        let text = |l: &LimitVerdict| stated(l, &Words::default());
        assert!(text(&l).starts_with("72 ± 19 µm"), "{}", text(&l));
        let l = l.within_interval(0.0578, 0.0902);
        assert!(text(&l).starts_with("72 (58 to 90) µm, limit 100 µm"), "{}", text(&l));
        let svg = limits(&[&l], &Words::default()).unwrap().svg;
        let at = |share: f64| SIDE + (NARROW - 2.0 * SIDE) * share / LEAST;
        let drawn = numbers(&svg, "line", "x1");
        assert!(drawn.iter().any(|x| (x - at(0.578)).abs() < 0.1), "{drawn:?}");
    }

    #[test]
    fn the_caption_says_what_is_drawn() {
        let u = LimitVerdict::judge(LimitQuantity::AccuracyMaxMm, 0.4, 0.342, Some(0.026), DecisionRule::Guarded);
        let ends = u.clone().within_interval(0.305, 0.368);
        let words = Words::default();
        for (all, drawn) in [(vec![&u, &u], "uncertainty"), (vec![&ends], "interval"), (vec![&u, &ends], "both")] {
            let caption = limits(&all, &words).unwrap().caption;
            assert_eq!(caption, tr!(words, "bullet-description", drawn));
        }
    }

    #[test]
    fn a_limit_without_coverage_has_no_risk() {
        let l = LimitVerdict::judge(LimitQuantity::AccuracyMaxMm, 0.4, 0.342, Some(0.026), DecisionRule::Guarded);
        let text = |l: &LimitVerdict| stated(l, &Words::default());
        assert!(text(&l).contains("risk < 0.1 %"), "{}", text(&l));
        let l = l.without_coverage();
        let (value, unit) = ("342 ± 26", "µm");
        assert_eq!(text(&l), tr!(Words::default(), "bullet-value-limit-drift", value, unit, limit = "400"));
    }

    /// Without a guard band the legend names none.
    #[test]
    fn only_guarded_acceptance_has_a_guard_band() {
        let of = |rule| {
            let l = LimitVerdict::judge(LimitQuantity::PositionMaxMm, 0.1, 0.095, Some(0.01), rule);
            limits(&[&l], &Words::default()).unwrap().svg.contains("guard band")
        };
        assert!(of(DecisionRule::Guarded) && !of(DecisionRule::SimpleAcceptance) && !of(DecisionRule::SharedRisk));
    }

    /// An angle to four decimals is shown to its last character; a text without end is cut.
    #[test]
    fn the_line_of_a_limit_is_drawn_whole() {
        let quantity = LimitQuantity::OrientationMaxDeg;
        let l = LimitVerdict::judge(quantity, 0.2525, 0.1376, Some(0.0062), DecisionRule::Guarded);
        let svg = limits(&[&l], &Words::default()).unwrap().svg;
        assert!(svg.contains("0.1376 ± 0.0062 deg, limit 0.2525 deg, risk &lt; 0.1 %<"), "{svg}");
        let cut = cut(&"n".repeat(200), 100.0, 1.0);
        assert!(cut.ends_with('…') && proportional(&cut) <= 100.0 && cut.len() > 10, "{cut}");
    }

    #[test]
    fn a_value_far_beyond_its_limit_ends_with_an_arrow_and_an_unmeasured_one_has_no_bar() {
        let svg = limits(&[&guarded_verdict(0.1, 3.0, 0.01)], &Words::default()).unwrap().svg;
        assert!(svg.contains("arrow-scale"), "{svg}");
        let l = LimitVerdict::not_assessable(LimitQuantity::DistanceMaxMm, 0.1, DecisionRule::Guarded);
        let svg = limits(&[&l], &Words::default()).unwrap().svg;
        // the legend alone
        assert_eq!(svg.matches("class=\"value\"").count(), 1, "{svg}");
        assert!(svg.contains("not measured, limit 100 µm"), "{svg}");
        assert!(limits(&[], &Words::default()).is_none());
    }

    /// The name of the tool point's line is too long for one line; its end is what is compared.
    #[test]
    fn a_long_name_is_drawn_whole() {
        let what = tr!(Words::default(), "tool-point-headline");
        let headline = Headline {
            what: what.clone(),
            before: "1350.0".to_owned(),
            after: "10.3".to_owned(),
            unit: "µm",
            in_documents: ("mm", [1.35, 0.0103]),
        };
        let svg = before_after(&[headline], "title", &Words::default()).unwrap().svg;
        assert!(!svg.contains('…'), "{svg}");
        assert!(what.split(' ').all(|word| svg.contains(&word.replace('>', "&gt;"))), "{svg}");
    }

    /// Two lengths and an angle: one axis for each unit, and two marks for each error.
    #[test]
    fn errors_of_one_unit_share_an_axis() {
        let of = |unit: &'static str, before, after| Headline {
            what: "error".to_owned(),
            before: "1".to_owned(),
            after: "2".to_owned(),
            unit,
            in_documents: (unit, [before, after]),
        };
        let all = [of("mm", 0.4, 0.1), of("deg", 0.2, 0.1), of("mm", 0.2, 0.1)];
        let svg = before_after(&all, "title", &Words::default()).unwrap().svg;
        assert_eq!(svg.matches("class=\"axis\"").count(), 2, "{svg}");
        let places = numbers(&svg, "circle", "cx");
        // 0.4 and 0.1, 0.2 and 0.1 mm on one scale; then the angle, then the legend
        let share = |k: usize| places[k] - SIDE;
        assert!((share(0) / share(1) - 4.0).abs() < 0.02 && (share(2) / share(3) - 2.0).abs() < 0.02, "{places:?}");
        assert_eq!(places.len(), 8);
    }
}
