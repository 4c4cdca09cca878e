//! Visits of a pose by approach, in each plane: figure 2.7 of the thesis.

use super::plane::{self, Plane, WIDTH};
use super::svg::{COLOURS, Place, SHAPES, Shape, Svg};
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_documents::{Iso9283Document, Iso9283Pose, Iso9283Visit};
use std::collections::BTreeMap;
use std::fmt::Display;

/// Of a visit whose approach is not recorded.
const UNKNOWN: &str = "#ffffff";
/// Visits beyond this are blunders that no picture can show, in µm from the mean.
const DRAWABLE_UM: f64 = 1e9;

/// How a pose was approached: the program's own words are translated, those of a table are not.
pub(crate) fn approach(name: &str, words: &Words) -> String {
    match name.strip_prefix("from pose ") {
        Some(pose) => words.fill("from pose {0}", &[&pose]),
        None => name.to_owned(),
    }
}

/// The visits of a pose.
pub(crate) fn of_pose(document: &Iso9283Document, pose: PoseName) -> impl Iterator<Item = &Iso9283Visit> {
    document.visits.iter().filter(move |v| v.pose == pose)
}

/// Where a pose was commanded, in µm from the mean of its visits; none where it was not.
fn commanded_um(pose: &Iso9283Pose) -> Option<Vector> {
    let at = [pose.ap_x_mm?, pose.ap_y_mm?, pose.ap_z_mm.unwrap_or(0.0)].map(|v| -1e3 * v);
    at.iter().all(|v| v.abs() < DRAWABLE_UM).then_some(at)
}

/// One picture for each pose with visits, and for each plane in which they scatter.
pub(crate) fn pictures(document: &Iso9283Document, words: &Words) -> Vec<Figure> {
    let of_one = |p: &Iso9283Pose| {
        let visits: Vec<&Iso9283Visit> = of_pose(document, p.pose).collect();
        let planar = visits.iter().all(|v| v.attained_mm[2] == visits[0].attained_mm[2]);
        plane::planes(planar).iter().filter_map(|axes| picture(p, &visits, *axes, words)).collect::<Vec<_>>()
    };
    document.poses.iter().flat_map(of_one).collect()
}

/// From which pose, in words.
fn approached(name: Option<&str>, words: &Words) -> String {
    name.map_or_else(|| words.say("the first"), |name| approach(name, words))
}

/// The commanded point: a cross, or an arrow in its direction where it is outside of the picture.
fn commanded(svg: &mut Svg, plane: &Plane, at: Vector, (x, y): Place, words: &Words) {
    let [dx, dy, dz] = at.map(|v| number::fixed(v, 1));
    let tip = words.fill("commanded: x {0}, y {1}, z {2} µm from the mean", &[&dx, &dy, &dz]);
    if plane.contains(at) {
        svg.cross("commanded", plane.at(at), 6.0);
        svg.mark(Shape::Circle, "before", plane.at(at), 2.4, "", &tip);
    } else {
        let (from, to) = plane.towards(at);
        svg.arrow("commanded", from, to);
        svg.mark(Shape::Square, "before", to, 2.4, "", &tip);
    }
    svg.cross("commanded", (x, y), 4.5);
    svg.text("start", (x + 10.0, y + 4.0), &words.fill("commanded, {0} µm away", &[&number::fixed(norm(at), 1)]));
}

/// All visits of a pose in a plane, by approach, with their means and the commanded point.
fn picture(of: &Iso9283Pose, visits: &[&Iso9283Visit], axes: (usize, usize), words: &Words) -> Option<Figure> {
    let pose = of.pose;
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
    let group = |name: Option<&str>| groups.keys().flatten().position(|n| Some(*n) == name);
    let colour = |name: Option<&str>| group(name).map_or(UNKNOWN, |i| COLOURS[i % COLOURS.len()]);
    let shape = |name: Option<&str>| group(name).map_or(Shape::Circle, |i| SHAPES[i % SHAPES.len()]);
    let plane = Plane::around(axes, &places).in_unit("µm");
    let name = plane::name(axes);
    let title = words.fill("Pose {0}, {1} plane", &[&pose, &name]);
    let description =
        words.fill("{0} visits about their mean, by approach; large marks are the means.", &[&visits.len()]);
    let point = commanded_um(of);
    let legend = |i: usize| (30.0 + 180.0 * (i % 2) as f64, plane.height() + 8.0 + 20.0 * (i / 2) as f64);
    // the commanded point has a line of its own: its words are long
    let lines = groups.len().div_ceil(2) + usize::from(point.is_some());
    let id = format!("visits-{pose}-{name}");
    let mut svg = Svg::new(&id, WIDTH, plane.height() + 20.0 * lines as f64 + 8.0, &title, &description);
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
        let [x, y, z] = mean.map(|v| number::fixed(v, 1));
        let from = name.map_or_else(String::new, |name| approach(name, words));
        let tip = words.fill("mean {0}: x {1}, y {2}, z {3} µm", &[&from, &x, &y, &z]);
        svg.mark(shape(*name), "mean", plane.at(mean), 6.5, colour(*name), &tip);
    }
    for (i, (name, places)) in groups.iter().enumerate() {
        let (x, y) = legend(i);
        svg.mark(shape(*name), "map", (x, y), 4.5, colour(*name), "");
        svg.text("start", (x + 10.0, y + 4.0), &format!("{} ({})", approached(*name, words), places.len()));
    }
    if let Some(at) = point {
        commanded(&mut svg, &plane, at, legend(2 * groups.len().div_ceil(2)), words);
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
        // all planes have the same numbers
        rows: visits.iter().zip(&places).map(row).take(if axes == (0, 1) { usize::MAX } else { 0 }).collect(),
        ..Figure::default()
    })
}
