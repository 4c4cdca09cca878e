//! Visits of a pose in its plane, by approach: figure 2.7 of the thesis.

use super::plane::{Plane, WIDTH};
use super::svg::{COLOURS, SHAPES, Shape, Svg};
use crate::base::pose::{Vector, centroid, minus};
use crate::base::pose_name::PoseName;
use crate::document::{Iso9283Document, Iso9283Visit};
use crate::report::model::Figure;
use crate::report::number;
use crate::report::words::Words;
use std::collections::BTreeMap;
use std::fmt::Display;

/// Of a visit whose approach is not recorded.
const UNKNOWN: &str = "#ffffff";
/// Visits beyond this are blunders that no picture can show, in µm from the mean.
const DRAWABLE_UM: f64 = 1e9;

/// How a pose was approached: the program's own words are translated, those of a table are not.
pub(in crate::report) fn approach(name: &str, words: &Words) -> String {
    match name.strip_prefix("from pose ") {
        Some(pose) => words.fill("from pose {0}", &[&pose]),
        None => name.to_owned(),
    }
}

/// The visits of a pose.
pub(in crate::report) fn of_pose(document: &Iso9283Document, pose: PoseName) -> impl Iterator<Item = &Iso9283Visit> {
    document.visits.iter().filter(move |v| v.pose == pose)
}

/// One picture for each pose with visits.
pub(in crate::report) fn pictures(document: &Iso9283Document, words: &Words) -> Vec<Figure> {
    document
        .poses
        .iter()
        .filter_map(|p| picture(p.pose, &of_pose(document, p.pose).collect::<Vec<_>>(), words))
        .collect()
}

/// From which pose, in words.
fn approached(name: Option<&str>, words: &Words) -> String {
    name.map_or_else(|| words.say("the first"), |name| approach(name, words))
}

/// All visits of a pose in the xy plane, by approach, with their means.
fn picture(pose: PoseName, visits: &[&Iso9283Visit], words: &Words) -> Option<Figure> {
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
    let shape = |name: Option<&str>| {
        let i = groups.keys().flatten().position(|n| Some(*n) == name);
        i.map_or(Shape::Circle, |i| SHAPES[i % SHAPES.len()])
    };
    let plane = Plane::around((0, 1), &places).in_unit("µm");
    let title = words.fill("Pose {0}, {1} plane", &[&pose, &"xy"]);
    let description =
        words.fill("{0} visits about their mean, by approach; large marks are the means.", &[&visits.len()]);
    let lines = groups.len().div_ceil(2);
    let mut svg =
        Svg::new(&format!("visits-{pose}"), WIDTH, plane.height() + 20.0 * lines as f64 + 8.0, &title, &description);
    plane.draw(&mut svg, words);
    for (visit, place) in visits.iter().zip(&places) {
        let name = visit.approach.as_deref();
        let from = approached(name, words);
        let [x, y, z] = place.map(|v| number::fixed(v, 1));
        let values: [&dyn Display; 6] = [&pose, &visit.cycle, &from, &x, &y, &z];
        let tip = words.fill("pose {0}, cycle {1}, {2}: x {3}, y {4}, z {5} µm from the mean", &values);
        svg.mark(shape(name), "map", plane.at(*place), 3.0, colour(name), &tip);
    }
    for (name, places) in groups.iter().filter(|(name, _)| name.is_some()) {
        let mean = centroid(places)?;
        let [x, y, _] = mean.map(|v| number::fixed(v, 1));
        let tip = words
            .fill("mean {0}: x {1}, y {2} µm", &[&name.map_or_else(String::new, |name| approach(name, words)), &x, &y]);
        svg.mark(shape(*name), "mean", plane.at(mean), 6.5, colour(*name), &tip);
    }
    for (i, (name, places)) in groups.iter().enumerate() {
        let (x, y) = (30.0 + 180.0 * (i % 2) as f64, plane.height() + 8.0 + 20.0 * (i / 2) as f64);
        svg.mark(shape(*name), "map", (x, y), 4.5, colour(*name), "");
        svg.text("start", (x + 10.0, y + 4.0), &format!("{} ({})", approached(*name, words), places.len()));
    }
    let row = |(visit, place): (&&Iso9283Visit, &Vector)| {
        let from = approached(visit.approach.as_deref(), words);
        let [x, y, z] = place.map(|v| number::fixed(v, 1));
        vec![visit.cycle.to_string(), from, x, y, z]
    };
    Some(Figure {
        title,
        svg: svg.finish(),
        caption: match known > 1 {
            true => words.fill(
                "{0} visits about their mean; colour and form show from which pose it was approached, large marks are the means.",
                &[&visits.len()],
            ),
            false => {
                words.fill("{0} visits about their mean, all from one pose; the large mark is their mean.", &[&visits.len()])
            }
        },
        table_title: words.say("Numbers of this picture"),
        header: vec![
            words.say("cycle"),
            words.say("approached"),
            "x, µm".to_owned(),
            "y, µm".to_owned(),
            "z, µm".to_owned(),
        ],
        rows: visits.iter().zip(&places).map(row).collect(),
        ..Figure::default()
    })
}
