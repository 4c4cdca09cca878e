//! Repeatability of a campaign: table 2.1 of the thesis, and its figure 2.7 for every pose.

use super::facts;
use super::number;
use super::plane::{Plane, WIDTH};
use super::points::Picture;
use super::svg::{Shape, Svg};
use crate::document::{Iso9283Document, Iso9283Pose, Iso9283Visit};
use crate::pose::{Vector, centroid, minus};
use serde::Serialize;
use std::collections::BTreeMap;

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

pub(super) fn section(document: &Iso9283Document) -> Section<'_> {
    let judged = || document.poses.iter().chain(&document.homing);
    Section {
        document,
        places: facts::places(document),
        rows: judged().map(row).collect(),
        quarter: judged().filter_map(quarter).collect(),
        quarter_sentence: quarter_sentence(document),
        approaches: approaches(document),
        between: document.approaches.iter().map(between).collect(),
        coplanar: document.coplanarity_of_four.iter().map(|p| [named(p.pose), um(Some(p.distance_mm))]).collect(),
        pictures: pictures(document),
    }
}

/// What the first box of a test of repeatability says: its style, and a sentence.
pub(super) fn verdict(document: &Iso9283Document) -> (&'static str, String) {
    let worst = document.poses.iter().filter_map(|p| Some((p.rp_mm?, p.pose)));
    let worst = worst.max_by(|a, b| a.0.total_cmp(&b.0));
    let found = worst
        .map_or_else(String::new, |(rp, pose)| format!("The repeatability is {} µm, at pose {pose}.", um(Some(rp))));
    match document.limits.first() {
        None => ("open", format!("{found} The campaign states no limit.")),
        Some(l) => {
            let word = if l.met { "within" } else { "not within" };
            let class = if l.met { "good" } else { "bad" };
            (class, format!("{found} This is {word} the limit of {} µm.", um(Some(l.limit))))
        }
    }
}

fn um(mm: Option<f64>) -> String {
    mm.map_or_else(String::new, |mm| number::fixed(1e3 * mm, 1))
}

fn named(pose: i64) -> String {
    if pose == 0 { "homing".to_owned() } else { pose.to_string() }
}

fn row(p: &Iso9283Pose) -> [String; 9] {
    let values = [p.enclosing_radius_mm, p.enclosing_circle_radius_mm, p.rp_mm, p.rp_xy_mm];
    let [sphere, circle, rp, xy] = values.map(um);
    let [x, y, z] = [p.rp_along_x_mm, p.rp_along_y_mm, p.rp_along_z_mm].map(um);
    [named(p.pose), p.cycles.to_string(), sphere, circle, rp, xy, x, y, z]
}

fn quarter(p: &Iso9283Pose) -> Option<[String; 3]> {
    let met = p.quarter_rule_met?;
    let ratio = p.uncertainty_over_rp.map_or_else(|| "nothing to verify".to_owned(), |r| number::fixed(r, 2));
    Some([named(p.pose), ratio, if met { "met" } else { "not met" }.to_owned()])
}

/// Whether the instrument is good enough.
fn quarter_sentence(document: &Iso9283Document) -> String {
    let of =
        |met: bool| document.poses.iter().filter(move |p| p.quarter_rule_met == Some(met)).map(|p| p.pose.to_string());
    let (met, missed): (Vec<String>, Vec<String>) = (of(true).collect(), of(false).collect());
    match (met.is_empty(), missed.is_empty()) {
        (true, true) => String::new(),
        (_, true) => "The instrument is good enough for every pose.".to_owned(),
        (true, _) => {
            "The instrument is good enough for no pose: the values are upper bounds of the robot's.".to_owned()
        }
        _ => format!(
            "The instrument is good enough for pose {}, and not for pose {}: there the values are upper bounds of the robot's.",
            met.join(", "),
            missed.join(", ")
        ),
    }
}

fn approaches(document: &Iso9283Document) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for v in &document.approaches {
        let all: Vec<Vector> = of_pose(document, v.pose).map(|v| v.attained_mm).collect();
        let middle = centroid(&all).unwrap_or_default();
        for a in &v.approaches {
            let mut cells = vec![v.pose.to_string(), a.name.clone(), a.cycles.to_string()];
            cells.extend(minus(a.mean_mm, middle).map(|d| um(Some(d))));
            cells.extend([a.rp_mm, a.enclosing_radius_mm].map(um));
            rows.push(cells);
        }
    }
    rows
}

fn between(v: &crate::document::Iso9283Variation) -> String {
    let [a, b] = &v.between;
    format!(
        "Pose {}: the means {a} and {b} lie {} µm apart, the farthest of all approaches.",
        v.pose,
        um(Some(v.vap_mm))
    )
}

fn of_pose(document: &Iso9283Document, pose: i64) -> impl Iterator<Item = &Iso9283Visit> {
    document.visits.iter().filter(move |v| v.pose == pose)
}

/// Colours that every eye tells apart (Okabe & Ito 2008), and one for a visit from nobody knows where.
const COLOURS: [&str; 6] = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9"];
const UNKNOWN: &str = "#ffffff";
/// Visits beyond this are blunders that no picture can show, in µm from the mean.
const DRAWABLE_UM: f64 = 1e9;

fn pictures(document: &Iso9283Document) -> Vec<Picture> {
    document.poses.iter().filter_map(|p| picture(p.pose, &of_pose(document, p.pose).collect::<Vec<_>>())).collect()
}

/// All visits of a pose in the xy plane, by approach, with their means.
fn picture(pose: i64, visits: &[&Iso9283Visit]) -> Option<Picture> {
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
    let title = format!("Pose {pose}, xy plane");
    let description = format!("{} visits about their mean, by approach; diamonds are the means.", visits.len());
    let lines = groups.len().div_ceil(2);
    let mut svg =
        Svg::new(&format!("visits-{pose}"), WIDTH, plane.height() + 20.0 * lines as f64 + 8.0, &title, &description);
    plane.draw(&mut svg);
    for (visit, place) in visits.iter().zip(&places) {
        let name = visit.approach.as_deref();
        let tip = format!("cycle {}, {}", visit.cycle, name.unwrap_or("the first"));
        svg.mark(Shape::Circle, "map", plane.at(*place), 3.0, colour(name), &tip);
    }
    for (name, places) in groups.iter().filter(|(name, _)| name.is_some()) {
        let mean = centroid(places)?;
        let tip = format!("mean {}: {:.1}, {:.1} µm", name.unwrap_or_default(), mean[0], mean[1]);
        svg.mark(Shape::Diamond, "mean", plane.at(mean), 6.5, colour(*name), &tip);
    }
    for (i, (name, places)) in groups.iter().enumerate() {
        let (x, y) = (30.0 + 180.0 * (i % 2) as f64, plane.height() + 8.0 + 20.0 * (i / 2) as f64);
        svg.mark(Shape::Circle, "map", (x, y), 4.5, colour(*name), "");
        svg.text("start", (x + 10.0, y + 4.0), &format!("{} ({})", name.unwrap_or("the first"), places.len()));
    }
    let approaches = if known > 1 { "colour says from which pose it was approached" } else { "all from one pose" };
    Some(Picture {
        title,
        svg: svg.finish(),
        caption: format!("{} visits about their mean; {approaches}, diamonds are the means.", visits.len()),
        wide: false,
        table_title: String::new(),
        header: vec![],
        rows: vec![],
    })
}
