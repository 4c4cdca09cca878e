//! Influence of each pose: Cook's distances as bars, with the critical value.

use super::layer::*;
use etalon_documents::ReliabilitySummary;

/// Margin at the right for a distance in digits.
const ROOM: f64 = 60.0;
/// Maximum number of characters of a pose's name.
const LETTERS: usize = 14;

/// One bar for each pose in the table; `None` if no pose has a distance.
pub(crate) fn picture(found: &ReliabilitySummary, words: &Words) -> Option<Figure> {
    let distance = |p: &etalon_documents::InfluenceEntry| p.cooks_distance.filter(|d| d.is_finite());
    let all: Vec<_> = found.poses.iter().filter_map(|p| Some((p.pose.to_string(), distance(p)?))).collect();
    let largest = range(all.iter().map(|(_, d)| *d).chain([found.influential]))?[1];
    if all.is_empty() {
        return None;
    }
    let labels = all.iter().enumerate().map(|(i, (pose, _))| (i as f64, pose.chars().take(LETTERS).collect()));
    let axes = [Axis::from_zero("", largest), Axis::rows(all.len(), labels.collect(), 0.5)];
    let names = [tr!(words, "cooks-distance"), tr!(words, "pose")];
    let mut chart = Chart::with_room(words, ROOM, axes, NARROW, names);
    for (i, (pose, distance)) in all.iter().enumerate() {
        let tip = tr!(words, "cooks-distance-tooltip", pose, distance = number::significant(*distance, 2));
        chart.bar_along(CALIBRATION, i, [0.0, *distance], &tip);
    }
    chart.upright("limit", found.influential);
    // the outline of the digits separates them from the line
    for (i, (_, distance)) in all.iter().enumerate() {
        let (x, y) = chart.at(*distance, i as f64);
        chart.svg.text("start over", (x + 5.0, y + 4.0), &words.significant(*distance, 2));
    }
    let description = tr!(words, "cooks-distance-description");
    Some(chart.figure("influence", tr!(words, "cooks-distance-of-poses"), description))
}

#[cfg(test)]
mod tests {
    use super::super::svg::numbers;
    use super::*;

    use etalon_documents::InfluenceEntry;

    fn found(distances: &[Option<f64>]) -> ReliabilitySummary {
        let of = |(i, d): (usize, &Option<f64>)| InfluenceEntry {
            pose: (i as i64).into(),
            cooks_distance: *d,
            parameter: "a_1".to_owned(),
            change_over_u: 1.0,
        };
        ReliabilitySummary {
            influential: 0.9,
            poses: distances.iter().enumerate().map(of).collect(),
            significance: 0.001,
            power: 0.8,
            sigma_mm: 0.01,
            readings: 3,
            least_redundancy: 0.9,
            median_detectable_mm: None,
            largest_detectable_mm: None,
            critical_w: 3.3,
            beyond: 0,
        }
    }

    #[test]
    fn bars_are_as_long_as_the_distances_and_the_limit_is_in_sight() {
        let svg = picture(&found(&[Some(1.8), None, Some(0.45)]), &Words::default()).unwrap().svg;
        let (bars, left) = (numbers(&svg, "rect", "width"), numbers(&svg, "rect", "x")[0]);
        assert_eq!(bars.len(), 2);
        assert!((bars[0] - 4.0 * bars[1]).abs() < 0.5, "{bars:?}");
        let limit = svg.lines().find(|l| l.contains("class=\"limit\"")).unwrap();
        assert!((2.0 * (numbers(limit, "line", "x1")[0] - left) - bars[0]).abs() < 0.5, "{limit}");
        assert!(picture(&found(&[None]), &Words::default()).is_none());
    }
}
