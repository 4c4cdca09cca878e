//! Parameters as points with their intervals: what calibration changed, and how well it is known.

use super::axis::{Axis, range};
use super::svg::{Shape, Svg};
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_documents::{ParameterEntry, ParameterStatus};

const WIDTH: f64 = 380.0;
/// room for the half width of an interval, in numbers
const RIGHT: f64 = 84.0;
const TOP: f64 = 12.0;
const ROW: f64 = 20.0;
/// Letters of a name that are drawn: a long one loses its middle, as its end often distinguishes it.
pub(super) const LETTERS: usize = 14;
const LAST: usize = 5;
/// of a figure below the axis
const FIGURE: f64 = 7.6;

/// One picture for each unit that occurs.
pub(crate) fn pictures(parameters: &[&ParameterEntry], group: (usize, &str), words: &Words) -> Vec<Figure> {
    let mut units: Vec<&str> = parameters.iter().map(|p| p.unit.as_str()).collect();
    units.sort_unstable();
    units.dedup();
    units.into_iter().enumerate().filter_map(|(i, unit)| picture(parameters, unit, group, i, words)).collect()
}

fn picture(
    parameters: &[&ParameterEntry],
    unit: &str,
    (key, group): (usize, &str),
    index: usize,
    words: &Words,
) -> Option<Figure> {
    let change = |p: &ParameterEntry| p.value - p.nominal;
    let expanded = |p: &ParameterEntry| 2.0 * p.standard_uncertainty.unwrap_or(0.0);
    let drawable = |p: &&&ParameterEntry| {
        p.unit == unit && p.status == ParameterStatus::Identified && change(p).is_finite() && expanded(p).is_finite()
    };
    let all: Vec<&ParameterEntry> = parameters.iter().filter(drawable).copied().collect();
    let largest = range(all.iter().flat_map(|p| [change(p) - expanded(p), change(p) + expanded(p)]).map(f64::abs))?.1;
    let shown = number::shown(unit, largest);
    let unit = if shown.unit.is_empty() { unit } else { shown.unit };
    let bottom = TOP + ROW * all.len() as f64 + 6.0;
    // a ratio has no unit to name
    let (title, along) = match unit {
        "1" => (words.fill("{0}: change of the ratios, with ± 2u", &[&group]), words.say("identified minus nominal")),
        _ => (
            words.fill("{0}: change in {1}, with ± 2u", &[&group, &unit]),
            words.fill("identified minus nominal in {0}", &[&unit]),
        ),
    };
    let description = words.say("One mark for each identified parameter: identified minus nominal; the line is ± 2u.");
    let mut svg = Svg::new(&format!("intervals-{key}-{index}"), WIDTH, bottom + 40.0, &title, &description);
    let name = |p: &ParameterEntry| shortened(&p.name);
    let longest = all.iter().map(|p| name(p).chars().count()).max().unwrap_or(0);
    let left = 20.0 + 8.4 * longest as f64;
    let reach = Axis::from_zero(largest * shown.factor, 0.0, 1.0).high();
    let across = Axis::linear(-reach, reach, left, WIDTH - RIGHT);
    for (value, label) in apart(&across) {
        let x = across.at(value);
        svg.line("grid", (x, TOP), (x, bottom));
        svg.text("mid", (x, bottom + 15.0), &label);
    }
    svg.line("axis", (across.at(0.0), TOP), (across.at(0.0), bottom));
    svg.text("mid", ((left + WIDTH - RIGHT) / 2.0, bottom + 33.0), &along);
    let expanded_shown = |p: &ParameterEntry| number::significant(expanded(p) * shown.factor, 2);
    let mut halves: Vec<String> = all.iter().map(|p| expanded_shown(p)).collect();
    number::one_notation(halves.iter_mut().collect());
    for ((i, p), half) in all.iter().enumerate().zip(&halves) {
        let y = TOP + ROW * (i as f64 + 0.5);
        let at = |v: f64| (across.at(v * shown.factor), y);
        svg.text("end", (left - 8.0, y + 4.0), &name(p));
        svg.line("interval", at(change(p) - expanded(p)), at(change(p) + expanded(p)));
        let u = p.standard_uncertainty.map(|u| u * shown.factor);
        let value = number::with_uncertainty(change(p) * shown.factor, u);
        let tip = words.fill("{0}: {1} ± {2} {3}", &[&p.name, &value, &half, &if unit == "1" { "" } else { unit }]);
        svg.mark(Shape::Circle, "cal", at(change(p)), 3.4, "", &tip);
        svg.text("end", (WIDTH - 4.0, y + 4.0), &format!("± {half}"));
    }
    Some(Figure {
        title,
        svg: svg.finish(),
        caption: words.say("Identified minus nominal; the line through a mark is ± 2u, often narrower than the mark. Values are in the table above."),
        ..Figure::default()
    })
}

pub(super) fn shortened(name: &str) -> String {
    let count = name.chars().count();
    if count <= LETTERS {
        return name.to_owned();
    }
    name.chars().take(LETTERS - 1 - LAST).chain(['…']).chain(name.chars().skip(count - LAST)).collect()
}

/// As many ticks as have room for their labels, counted from zero; at least one on either side of it, as the axis reaches as far
/// below zero as above.
fn apart(axis: &Axis) -> Vec<(f64, String)> {
    let mut all = axis.ticks(5);
    let [first, second, ..] = &all[..] else { return all };
    let (lowest, step) = (first.0, second.0 - first.0);
    let letters = all.iter().map(|(_, label)| label.chars().count()).max().unwrap_or(0);
    let room = axis.at(lowest + step) - axis.at(lowest);
    let outermost = (-lowest / step).round() as i64;
    let every = (FIGURE * (letters + 1) as f64 / room).ceil().clamp(1.0, outermost.max(1) as f64) as i64;
    let count = |value: f64| (value / step).round() as i64;
    all.retain(|(value, _)| count(*value) % every == 0);
    // nothing but a zero, which needs less room than its neighbours
    all.iter_mut().filter(|(value, _)| count(*value) == 0).for_each(|(_, label)| *label = "0".to_owned());
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;

    #[test]
    fn every_identified_parameter_is_drawn_once_in_its_unit() {
        let parameters = Documents::demo().parameters.parameters;
        let all: Vec<_> = parameters.iter().collect();
        let pictures = pictures(&all, (0, "Robot"), &Words::default());
        let identified = parameters.iter().filter(|p| p.status == ParameterStatus::Identified).count();
        assert_eq!(pictures.iter().map(|p| p.svg.matches("<circle").count()).sum::<usize>(), identified);
        assert!(pictures.iter().any(|p| p.title.contains("in deg")) && pictures.len() == 3);
        assert!(pictures[1].svg.contains("beta: 0.12346 ± 0.00074 deg"), "{}", pictures[1].svg);
    }

    #[test]
    fn names_keep_their_ends_and_labels_their_distance() {
        assert_eq!(shortened("shoulder_pan_z"), "shoulder_pan_z");
        assert_eq!(shortened("shoulder_lift_rx"), "shoulder…ft_rx");
        let narrow = Axis::linear(-0.0002, 0.0002, 138.0, 296.0);
        let labels: Vec<String> = apart(&narrow).into_iter().map(|(_, label)| label).collect();
        assert_eq!(labels, ["-0.0002", "0", "0.0002"]);
        // of the IRB 120: no room for three labels of this length beside each other
        let narrower = Axis::linear(-0.0003, 0.0003, 121.0, 296.0);
        let labels: Vec<String> = apart(&narrower).into_iter().map(|(_, label)| label).collect();
        assert_eq!(labels, ["-0.0002", "0", "0.0002"]);
    }
}
