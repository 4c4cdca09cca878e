//! Repeatability of a campaign: table 2.1 of the thesis, and its figure 2.7 for every pose.

use super::facts;
use super::number;
use super::plane::{Plane, WIDTH};
use super::points::Picture;
use super::svg::{COLOURS, Shape, Svg};
use super::words::Words;
use crate::document::{Iso9283Document, Iso9283Pose, Iso9283Visit};
use crate::pose::{Vector, centroid, minus};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Display;

#[derive(Debug, Serialize)]
pub(super) struct Section<'a> {
    pub document: &'a Iso9283Document,
    /// pose, visits, mean of x, y and z, in mm
    pub places: Vec<[String; 5]>,
    /// table 2.1, in µm
    pub rows: Vec<[String; 9]>,
    /// pose, U over RP, verdict
    pub quarter: Vec<[String; 3]>,
    pub quarter_sentence: String,
    /// pose, approach, visits, mean from that of all (x, y, z), RP, sphere, in µm
    pub approaches: Vec<Vec<String>>,
    /// pose, the two farthest apart, µm
    pub between: Vec<String>,
    pub coplanar: Vec<[String; 2]>,
    pub pictures: Vec<Picture>,
}

pub(super) fn section<'a>(document: &'a Iso9283Document, words: &Words) -> Section<'a> {
    let judged = || document.poses.iter().chain(&document.homing);
    Section {
        document,
        places: facts::places(document),
        rows: judged().map(|p| row(p, words)).collect(),
        quarter: judged().filter_map(|p| quarter(p, words)).collect(),
        quarter_sentence: quarter_sentence(document, words),
        approaches: approaches(document, words),
        between: document.approaches.iter().map(|v| between(v, words)).collect(),
        coplanar: document
            .coplanarity_of_four
            .iter()
            .map(|p| [named(p.pose, words), um(Some(p.distance_mm))])
            .collect(),
        pictures: pictures(document, words),
    }
}

/// What the first box of a test of repeatability says: its style, and a sentence.
pub(super) fn verdict(document: &Iso9283Document, words: &Words) -> (&'static str, String) {
    let worst = document.poses.iter().filter_map(|p| Some((p.rp_mm?, p.pose)));
    let worst = worst.max_by(|a, b| a.0.total_cmp(&b.0));
    let found = worst.map_or_else(String::new, |(rp, pose)| {
        words.fill("The repeatability is {0} µm, at pose {1}.", &[&um(Some(rp)), &pose])
    });
    let (class, judged) = match document.limits.first().map(|l| (l.met, um(Some(l.limit)))) {
        None => ("open", words.say("The campaign states no limit.")),
        Some((true, limit)) => ("good", words.fill("This is within the limit of {0} µm.", &[&limit])),
        Some((false, limit)) => ("bad", words.fill("This is not within the limit of {0} µm.", &[&limit])),
    };
    (class, format!("{found} {judged}"))
}

fn um(mm: Option<f64>) -> String {
    mm.map_or_else(String::new, |mm| number::fixed(1e3 * mm, 1))
}

fn named(pose: i64, words: &Words) -> String {
    if pose == 0 { words.say("homing") } else { pose.to_string() }
}

fn row(p: &Iso9283Pose, words: &Words) -> [String; 9] {
    let values = [p.enclosing_radius_mm, p.enclosing_circle_radius_mm, p.rp_mm, p.rp_xy_mm];
    let [sphere, circle, rp, xy] = values.map(um);
    let [x, y, z] = [p.rp_along_x_mm, p.rp_along_y_mm, p.rp_along_z_mm].map(um);
    [named(p.pose, words), p.cycles.to_string(), sphere, circle, rp, xy, x, y, z]
}

fn quarter(p: &Iso9283Pose, words: &Words) -> Option<[String; 3]> {
    let met = p.quarter_rule_met?;
    let ratio = p.uncertainty_over_rp.map_or_else(|| words.say("nothing to verify"), |r| number::fixed(r, 2));
    Some([named(p.pose, words), ratio, if met { "met" } else { "not met" }.to_owned()])
}

/// Whether the instrument is good enough.
fn quarter_sentence(document: &Iso9283Document, words: &Words) -> String {
    let of =
        |met: bool| document.poses.iter().filter(move |p| p.quarter_rule_met == Some(met)).map(|p| p.pose.to_string());
    let (met, missed): (Vec<String>, Vec<String>) = (of(true).collect(), of(false).collect());
    match (met.is_empty(), missed.is_empty()) {
        (true, true) => String::new(),
        (_, true) => words.say("The instrument is good enough for every pose."),
        (true, _) => {
            words.say("The instrument is good enough for no pose: the values are upper bounds of the robot's.")
        }
        _ => words.fill(
            "The instrument is good enough for pose {0}, and not for pose {1}: there the values are upper bounds of the robot's.",
            &[&met.join(", "), &missed.join(", ")],
        ),
    }
}

fn approaches(document: &Iso9283Document, words: &Words) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for v in &document.approaches {
        let all: Vec<Vector> = of_pose(document, v.pose).map(|v| v.attained_mm).collect();
        let middle = centroid(&all).unwrap_or_default();
        for a in &v.approaches {
            let mut cells = vec![v.pose.to_string(), approach(&a.name, words), a.cycles.to_string()];
            cells.extend(minus(a.mean_mm, middle).map(|d| um(Some(d))));
            cells.extend([a.rp_mm, a.enclosing_radius_mm].map(um));
            rows.push(cells);
        }
    }
    rows
}

/// How a pose was approached: the program's own words are translated, those of a table are not.
fn approach(name: &str, words: &Words) -> String {
    match name.strip_prefix("from pose ") {
        Some(pose) => words.fill("from pose {0}", &[&pose]),
        None => name.to_owned(),
    }
}

fn between(v: &crate::document::Iso9283Variation, words: &Words) -> String {
    let [a, b] = &v.between;
    let isolated = |name: &str| format!("\u{2068}{}\u{2069}", approach(name, words));
    words.fill(
        "Pose {0}: the means {1} and {2} lie {3} µm apart, the farthest of all approaches.",
        &[&v.pose, &isolated(a), &isolated(b), &um(Some(v.vap_mm))],
    )
}

fn of_pose(document: &Iso9283Document, pose: i64) -> impl Iterator<Item = &Iso9283Visit> {
    document.visits.iter().filter(move |v| v.pose == pose)
}

/// Of a visit from nobody knows where.
const UNKNOWN: &str = "#ffffff";
/// Visits beyond this are blunders that no picture can show, in µm from the mean.
const DRAWABLE_UM: f64 = 1e9;

fn pictures(document: &Iso9283Document, words: &Words) -> Vec<Picture> {
    document
        .poses
        .iter()
        .filter_map(|p| picture(p.pose, &of_pose(document, p.pose).collect::<Vec<_>>(), words))
        .collect()
}

/// All visits of a pose in the xy plane, by approach, with their means.
fn picture(pose: i64, visits: &[&Iso9283Visit], words: &Words) -> Option<Picture> {
    let middle = centroid(&visits.iter().map(|v| v.attained_mm).collect::<Vec<_>>())?;
    let from_middle = |v: &&Iso9283Visit| minus(v.attained_mm, middle).map(|d| 1e3 * d);
    let places: Vec<Vector> = visits.iter().map(from_middle).collect();
    if !places.iter().flatten().all(|v| v.abs() < DRAWABLE_UM) {
        return None;
    }
    let mut groups: BTreeMap<Option<&str>, Vec<Vector>> = BTreeMap::new();
    for (visit, place) in visits.iter().zip(&places) {
        groups.entry(visit.approach.as_deref()).or_default().push(*place);
    }
    let known = groups.keys().flatten().count();
    let colour = |name: Option<&str>| {
        let i = groups.keys().flatten().position(|n| Some(*n) == name);
        i.map_or(UNKNOWN, |i| COLOURS[i % COLOURS.len()])
    };
    let plane = Plane::around((0, 1), &places).in_unit("µm");
    let title = words.fill("Pose {0}, {1} plane", &[&pose, &"xy"]);
    let description = words.fill("{0} visits about their mean, by approach; diamonds are the means.", &[&visits.len()]);
    let lines = groups.len().div_ceil(2);
    let mut svg =
        Svg::new(&format!("visits-{pose}"), WIDTH, plane.height() + 20.0 * lines as f64 + 8.0, &title, &description);
    plane.draw(&mut svg, words);
    for (visit, place) in visits.iter().zip(&places) {
        let name = visit.approach.as_deref();
        let from = name.map_or_else(|| words.say("the first"), |name| approach(name, words));
        let [x, y, z] = place.map(|v| number::fixed(v, 1));
        let values: [&dyn Display; 6] = [&pose, &visit.cycle, &from, &x, &y, &z];
        let tip = words.fill("pose {0}, cycle {1}, {2}: x {3}, y {4}, z {5} µm from the mean", &values);
        svg.mark(Shape::Circle, "map", plane.at(*place), 3.0, colour(name), &tip);
    }
    for (name, places) in groups.iter().filter(|(name, _)| name.is_some()) {
        let mean = centroid(places)?;
        let [x, y, _] = mean.map(|v| number::fixed(v, 1));
        let tip = words
            .fill("mean {0}: x {1}, y {2} µm", &[&name.map_or_else(String::new, |name| approach(name, words)), &x, &y]);
        svg.mark(Shape::Diamond, "mean", plane.at(mean), 6.5, colour(*name), &tip);
    }
    for (i, (name, places)) in groups.iter().enumerate() {
        let (x, y) = (30.0 + 180.0 * (i % 2) as f64, plane.height() + 8.0 + 20.0 * (i / 2) as f64);
        svg.mark(Shape::Circle, "map", (x, y), 4.5, colour(*name), "");
        svg.text(
            "start",
            (x + 10.0, y + 4.0),
            &format!(
                "{} ({})",
                name.map_or_else(|| words.say("the first"), |name| approach(name, words)),
                places.len()
            ),
        );
    }
    Some(Picture {
        title,
        svg: svg.finish(),
        caption: match known > 1 {
            true => words.fill(
                "{0} visits about their mean; colour says from which pose it was approached, diamonds are the means.",
                &[&visits.len()],
            ),
            false => {
                words.fill("{0} visits about their mean, all from one pose; diamonds are the means.", &[&visits.len()])
            }
        },
        ..Picture::default()
    })
}
