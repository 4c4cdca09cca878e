//! Change of each parameter by calibration, as a point with its interval.

use super::layer::*;
use etalon_documents::{ParameterEntry, ParameterStatus};

/// Margin at the right for the half-width of an interval in digits.
const ROOM: f64 = 84.0;
/// Maximum number of characters of a name. Long names lose their middle, as their end often
/// distinguishes them.
pub(super) const LETTERS: usize = 14;
/// Number of characters at the end of a long name.
const LAST: usize = 5;

/// One figure for each unit; `key` is the number of the group in the ids of its figures.
pub(crate) fn pictures(parameters: &[&ParameterEntry], key: usize, group: &str, words: &Words) -> Vec<Figure> {
    let mut units: Vec<&str> = parameters.iter().map(|p| p.printed_unit()).collect();
    units.sort_unstable();
    units.dedup();
    let picture = |(i, unit)| picture(parameters, unit, group, &format!("intervals-{key}-{i}"), words);
    units.into_iter().enumerate().filter_map(picture).collect()
}

fn picture(parameters: &[&ParameterEntry], unit: &str, group: &str, id: &str, words: &Words) -> Option<Figure> {
    let change = |p: &ParameterEntry| p.value - p.nominal;
    let expanded = |p: &ParameterEntry| 2.0 * p.standard_uncertainty.unwrap_or(0.0);
    let drawable = |p: &&&ParameterEntry| {
        p.printed_unit() == unit
            && p.status == ParameterStatus::Identified
            && change(p).is_finite()
            && expanded(p).is_finite()
    };
    let all: Vec<&ParameterEntry> = parameters.iter().filter(drawable).copied().collect();
    if all.is_empty() {
        return None;
    }
    let reach = largest(all.iter().map(|p| change(p).abs() + expanded(p)));
    let shown = number::display_unit(unit, reach);
    let unit = if shown.unit.is_empty() { unit } else { shown.unit };
    // ratios are dimensionless
    let (title, along) = match unit {
        "1" => (tr!(words, "intervals-of-ratios-title", group), tr!(words, "identified-minus-nominal")),
        _ => (tr!(words, "intervals-title", group, unit), tr!(words, "identified-minus-nominal-in", unit)),
    };
    let labels = all.iter().enumerate().map(|(i, p)| (i as f64, shortened(&p.name))).collect();
    let axes = [Axis::both_ways(shown, reach), Axis::rows(all.len(), labels, 0.5)];
    let mut chart = Chart::with_room(words, ROOM, axes, NARROW, [along.as_str(), ""]);
    chart.upright("axis", 0.0);
    let mut halves: Vec<String> = all.iter().map(|p| number::significant(expanded(p) * shown.factor, 2)).collect();
    number::one_notation(halves.iter_mut().collect());
    for ((i, p), half) in all.iter().enumerate().zip(&halves) {
        let at = |v: f64| chart.at(v, i as f64);
        let (middle, ends) = (at(change(p)), [-1.0, 1.0].map(|side| at(change(p) + side * expanded(p))));
        chart.svg.line("interval", ends[0], ends[1]);
        let u = p.standard_uncertainty.map(|u| u * shown.factor);
        let value = number::with_uncertainty(change(p) * shown.factor, u);
        let tip = tr!(
            words,
            "value-tooltip",
            name = p.name,
            value,
            uncertainty = half,
            unit = if unit == "1" { "" } else { unit }
        );
        chart.svg.mark(CALIBRATION, middle, 3.4, &tip);
        chart.svg.number("end", (NARROW - 4.0, middle.1 + 4.0), &format!("± {half}"));
    }
    let description = tr!(words, "intervals-description");
    let caption = tr!(words, "intervals-caption");
    Some(Figure { caption, ..chart.figure(id, title, description) })
}

/// Shortens a long name by its middle.
pub(super) fn shortened(name: &str) -> String {
    shortened_to(LETTERS, name)
}

/// Shortens a name to a number of letters by its middle.
pub(super) fn shortened_to(letters: usize, name: &str) -> String {
    let count = name.chars().count();
    if count <= letters {
        return name.to_owned();
    }
    name.chars().take(letters - 1 - LAST).chain(['…']).chain(name.chars().skip(count - LAST)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;

    #[test]
    fn every_identified_parameter_is_drawn_once_in_its_unit() {
        let parameters = Documents::demo().parameters.parameters;
        let all: Vec<_> = parameters.iter().collect();
        let pictures = pictures(&all, 0, "Robot", &Words::default());
        let identified = parameters.iter().filter(|p| p.status == ParameterStatus::Identified).count();
        assert_eq!(pictures.iter().map(|p| p.svg.matches("<circle").count()).sum::<usize>(), identified);
        assert!(pictures.iter().any(|p| p.title.contains("(deg)")) && pictures.len() == 3);
        assert!(pictures[1].svg.contains("beta: 0.12346 ± 0.00074 deg"), "{}", pictures[1].svg);
    }

    #[test]
    fn long_names_keep_their_ends() {
        assert_eq!(shortened("shoulder_pan_z"), "shoulder_pan_z");
        assert_eq!(shortened("shoulder_lift_rx"), "shoulder…ft_rx");
    }
}
