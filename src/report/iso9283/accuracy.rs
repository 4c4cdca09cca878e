//! What commanded poses add: accuracy of position and orientation, distances, exchangeability.

use super::{conformity, interval, ratio, um};
use crate::document::{Iso9283Distance, Iso9283Document, Iso9283Pose};
use crate::report::part::{Column, Part, number, text};
use crate::report::words::Words;

/// Distances that a report shows; the workbook has all.
const DISTANCES: usize = 60;

pub(super) fn parts(document: &Iso9283Document, words: &Words) -> Vec<Part> {
    let mut parts = vec![positions(document, words), orientation(document, words)];
    parts.extend(distances(document, words));
    parts.retain(Part::has_rows);
    parts.extend(exchangeability(document, words));
    parts
}

fn positions(document: &Iso9283Document, words: &Words) -> Part {
    let row = |p: &Iso9283Pose| {
        p.ap_mm?;
        let [ap, x, y, z] = [p.ap_mm, p.ap_x_mm, p.ap_y_mm, p.ap_z_mm].map(um);
        let over = ratio(p.uncertainty_over_ap);
        let proved = conformity(p.ap_conformity, words);
        Some(vec![p.pose.to_string(), p.cycles.to_string(), ap, interval(p.ap_interval, words), x, y, z, over, proved])
    };
    let mut columns = vec![number(words.say("pose")), number(words.say("visits"))];
    columns.extend(["AP, µm", "95 %, µm", "AP x, µm", "AP y, µm", "AP z, µm", "U/AP"].map(number));
    columns.push(text(words.say("verdict (ISO 14253-1)")));
    let note =
        words.say("AP: distance of the mean from the commanded position, and its coordinates (ISO 9283:1998, 7.2.1).");
    let rows = document.poses.iter().filter_map(row).collect();
    Part::table(words.say("Accuracy of position"), note, columns, rows).without_empty_columns()
}

fn orientation(document: &Iso9283Document, words: &Words) -> Part {
    let row = |p: &Iso9283Pose| {
        let values = [p.ap_a_deg, p.ap_b_deg, p.ap_c_deg, p.rp_a_deg, p.rp_b_deg, p.rp_c_deg];
        values.iter().any(Option::is_some).then(|| [vec![p.pose.to_string()], values.map(deg).to_vec()].concat())
    };
    let mut columns = vec![number(words.say("pose"))];
    columns.extend(["AP a, deg", "AP b, deg", "AP c, deg", "RP a, deg", "RP b, deg", "RP c, deg"].map(number));
    let note = words.say("AP: mean minus commanded angle; RP: three standard deviations; each angle alone (ISO 9283:1998, 7.2.1 and 7.2.2).");
    let rows = document.poses.iter().filter_map(row).collect();
    Part::table(words.say("Orientation"), note, columns, rows).without_empty_columns()
}

fn distances(document: &Iso9283Document, words: &Words) -> [Part; 2] {
    let between = |d: &Iso9283Distance| vec![format!("{} – {}", d.poses[0], d.poses[1]), d.cycles.to_string()];
    let axes = |values: &[f64]| [0, 1, 2].map(|k| um(values.get(k).copied()));
    let row = |d: &Iso9283Distance| {
        let ad = [vec![um(Some(d.ad_mm))], axes(&d.ad_axes_mm).to_vec()].concat();
        let rd = [vec![um(Some(d.rd_mm))], axes(&d.rd_axes_mm).to_vec()].concat();
        [between(d), ad, rd].concat()
    };
    let shown = || document.distances.iter().take(DISTANCES);
    let columns = |titles: &[&str]| -> Vec<Column> {
        let first = [text(words.say("between poses")), number(words.say("cycles"))];
        first.into_iter().chain(titles.iter().map(|t| number(*t))).collect()
    };
    let titles = ["AD, µm", "AD x, µm", "AD y, µm", "AD z, µm", "RD, µm", "RD x, µm", "RD y, µm", "RD z, µm"];
    let note = words.say("AD: mean attained minus commanded distance; RD: three standard deviations of the attained one (ISO 9283:1998, 7.3).");
    let positions =
        Part::table(words.say("Distances between poses"), note, columns(&titles), shown().map(row).collect());
    let angles = angles(document);
    let named = |of: &str| angles.iter().map(|a| format!("{of} {a}, deg")).collect::<Vec<_>>();
    let titles = [named("AD"), named("RD")].concat();
    let turned = |d: &Iso9283Distance| {
        let values = d.ad_angles_deg.iter().chain(&d.rd_angles_deg).map(|v| deg(Some(*v)));
        between(d).into_iter().chain(values).collect()
    };
    let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
    let rows = if angles.is_empty() { Vec::new() } else { shown().map(turned).collect() };
    let turned = Part::table(String::new(), String::new(), columns(&titles), rows);
    let left_out = document.distances.len().saturating_sub(DISTANCES);
    let told = (left_out > 0).then(|| words.fill("{0} more are in the workbook.", &[&left_out]));
    [Part { sentences: told.into_iter().collect(), ..positions.without_empty_columns() }, turned]
}

/// Angles that the poses have, in their order.
pub(super) fn angles(document: &Iso9283Document) -> Vec<&'static str> {
    let has = |angle: fn(&Iso9283Pose) -> Option<f64>| document.poses.iter().any(|p| angle(p).is_some());
    let all = [("a", has(|p| p.ap_a_deg)), ("b", has(|p| p.ap_b_deg)), ("c", has(|p| p.ap_c_deg))];
    all.into_iter().filter_map(|(name, there)| there.then_some(name)).collect()
}

fn exchangeability(document: &Iso9283Document, words: &Words) -> Option<Part> {
    let e = um(Some(document.exchangeability_mm?));
    let told = words.fill(
        "E = {0} µm: the largest distance between the mean positions of two robots at one pose (ISO 9283:1998, 7.7).",
        &[&e],
    );
    Some(Part { heading: words.say("Exchangeability"), sentences: vec![told], ..Part::default() })
}

fn deg(value: Option<f64>) -> String {
    value.map_or_else(String::new, |v| crate::report::number::fixed(v, 4))
}
