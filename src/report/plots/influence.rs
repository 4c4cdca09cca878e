//! What the identification would change by without a pose, as bars: Cook's distances against the value from which a pose decides.

use super::axis::{Axis, range};
use super::svg::Svg;
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_documents::{InfluenceEntry, ReliabilitySummary};

const WIDTH: f64 = 380.0;
const TOP: f64 = 12.0;
const ROW: f64 = 20.0;
/// Room for a distance in numbers.
const RIGHT: f64 = 60.0;
/// Letters of the name of a pose that are drawn.
const LETTERS: usize = 14;

/// One bar for each pose of the table; none where no pose has a distance.
pub(crate) fn picture(found: &ReliabilitySummary, words: &Words) -> Option<Figure> {
    let distance = |p: &InfluenceEntry| p.cooks_distance.filter(|d| d.is_finite());
    let all: Vec<(&InfluenceEntry, f64)> = found.poses.iter().filter_map(|p| Some((p, distance(p)?))).collect();
    let largest = range(all.iter().map(|(_, d)| *d).chain([found.influential]))?.1;
    if all.is_empty() {
        return None;
    }
    let title = words.say("Cook's distance of the poses");
    let description =
        words.say("One bar for each pose of the table; the line is the value beyond which a pose is influential.");
    let name = |p: &InfluenceEntry| p.pose.to_string().chars().take(LETTERS).collect::<String>();
    let longest = all.iter().map(|(p, _)| name(p).chars().count()).max().unwrap_or(0);
    let (left, bottom) = (40.0 + 7.2 * longest as f64, TOP + ROW * all.len() as f64 + 4.0);
    let across = Axis::from_zero(largest, left, WIDTH - RIGHT);
    let mut svg = Svg::new("influence", WIDTH, bottom + 40.0, &title, &description);
    for (value, label) in across.ticks(4) {
        let x = across.at(value);
        svg.line("grid", (x, TOP), (x, bottom));
        svg.text("mid", (x, bottom + 17.0), &label);
    }
    let at = |i: usize| TOP + ROW * i as f64;
    for (i, (p, distance)) in all.iter().enumerate() {
        let y = at(i);
        let (value, end) = (number::significant(*distance, 2), across.at(*distance));
        svg.text("end", (left - 6.0, y + 14.0), &name(p));
        let tip = words.fill("pose {0}: Cook's distance {1}", &[&p.pose, &value]);
        svg.rect("cal", (left, y + 3.0), ((end - left).max(0.5), ROW - 6.0), &tip);
    }
    let x = across.at(found.influential);
    svg.line("limit", (x, TOP), (x, bottom));
    // the rim of the numbers keeps the line away from them
    for (i, (_, distance)) in all.iter().enumerate() {
        let value = words.number(&number::significant(*distance, 2));
        svg.text("start over", (across.at(*distance) + 5.0, at(i) + 14.0), &value);
    }
    svg.line("axis", (left, TOP), (left, bottom));
    svg.line("axis", (left, bottom), (WIDTH - RIGHT, bottom));
    svg.text("mid", (0.5 * (left + WIDTH - RIGHT), bottom + 35.0), &words.say("Cook's distance"));
    svg.text_upwards((14.0, 0.5 * (TOP + bottom)), &words.say("pose"));
    Some(Figure { title, svg: svg.finish(), caption: description, ..Figure::default() })
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let wide = |l: &str| l.split("width=\"").nth(1)?.split('"').next()?.parse::<f64>().ok();
        let bars: Vec<f64> = svg.lines().filter(|l| l.starts_with("<rect")).filter_map(wide).collect();
        assert_eq!(bars.len(), 2);
        assert!((bars[0] - 4.0 * bars[1]).abs() < 0.5, "{bars:?}");
        let limit = svg.lines().find(|l| l.contains("class=\"limit\"")).unwrap();
        let at = |key: &str| limit.split(key).nth(1).unwrap().split('"').next().unwrap().parse::<f64>().unwrap();
        let left: f64 =
            svg.lines().find(|l| l.starts_with("<rect")).unwrap().split('"').nth(3).unwrap().parse().unwrap();
        assert!((2.0 * (at(" x1=\"") - left) - bars[0]).abs() < 0.5, "{limit}");
        assert!(picture(&found(&[None]), &Words::default()).is_none());
    }
}
