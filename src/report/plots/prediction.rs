//! The error to expect at a point of the tool over the workspace: a cell for each node, of nodes behind one another the largest.

use super::axis::range;
use super::map::{Scale, level, scales};
use super::plane::{self, Plane, WIDTH};
use super::svg::{Place, Svg};
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_documents::{MapNode, PredictionMap};
use std::collections::BTreeMap;

/// Nodes beyond this are not places of a robot, mm.
const DRAWABLE_MM: f64 = 1e7;
/// Nodes less apart than this, in units of the picture, lie behind one another.
const NEAR: f64 = 1.0;

/// Nominal minus identified model, and expected error with the identified one, in every plane of the workspace.
pub(crate) fn pictures(map: &PredictionMap, planar: bool, words: &Words) -> Vec<Figure> {
    let small = |n: &&MapNode| n.at_mm.iter().chain([&n.before_mm, &n.p95_mm]).all(|v| v.abs() < DRAWABLE_MM);
    let nodes: Vec<&MapNode> = map.nodes.iter().filter(small).collect();
    let largest = |size: fn(&MapNode) -> f64| range(nodes.iter().map(|n| size(n))).map_or(0.0, |r| r.1);
    let sides = [false, true].map(|identified| Side { identified, largest_mm: largest(size(identified)) });
    let common = Scale::to(sides.iter().map(|s| s.largest_mm).fold(0.0, f64::max));
    let drawn = if nodes.is_empty() { &[][..] } else { plane::planes(planar) };
    let pair = |&axes| sides.each_ref().map(|side| picture(&nodes, map.spacing_mm, axes, side, &common, words));
    drawn.iter().flat_map(pair).collect()
}

/// One of the two pictures.
struct Side {
    identified: bool,
    largest_mm: f64,
}

fn size(identified: bool) -> fn(&MapNode) -> f64 {
    if identified { |n| n.standard_uncertainty_mm } else { |n| n.before_mm }
}

fn picture(
    nodes: &[&MapNode],
    spacing_mm: f64,
    axes: (usize, usize),
    side: &Side,
    common: &Scale,
    words: &Words,
) -> Figure {
    let (size, own, name) = (size(side.identified), Scale::to(side.largest_mm), plane::name(axes));
    let title = match side.identified {
        false => words.fill("Tool point: nominal minus identified model, {0} plane", &[&name]),
        true => words.fill("Tool point: error to expect with the identified parameters, {0} plane", &[&name]),
    };
    let largest = length(side.largest_mm);
    let mut description = words.fill("A cell every {0} mm in the base frame, where the calibration poses reach; colour from 0 to {1}, one scale for both pictures; largest {2}.", &[&number::stated(spacing_mm), &common.top(), &largest]);
    if axes != (0, 1) || nodes.iter().any(|n| n.at_mm[2] != nodes[0].at_mm[2]) {
        description += &format!(" {}", words.say("Of cells behind one another the largest is drawn."));
    }
    let places: Vec<_> = nodes.iter().map(|n| n.at_mm).collect();
    let plane = Plane::around(axes, &places);
    let key = if side.identified { "identified" } else { "nominal" };
    let id = format!("prediction-{key}-{name}");
    let mut svg = Svg::new(&id, WIDTH, plane.height() + 26.0, &title, &description);
    plane.draw(&mut svg, words);
    let mut cells: BTreeMap<(i64, i64), &MapNode> = BTreeMap::new();
    for node in nodes {
        let (x, y) = plane.at(node.at_mm);
        let cell = cells.entry(((x / NEAR) as i64, (y / NEAR) as i64)).or_insert(node);
        if size(node) > size(cell) {
            *cell = node;
        }
    }
    let edge = (plane.scale * spacing_mm).clamp(4.0, 40.0);
    for node in cells.values() {
        let (x, y): Place = plane.at(node.at_mm);
        let class = format!("map o{} w{}", level(common.share(size(node))), level(own.share(size(node))));
        svg.rect(&class, (x - 0.5 * edge, y - 0.5 * edge), (edge, edge), &tooltip(node, words));
    }
    scales(&mut svg, [common, &own], plane.height());
    Figure {
        title,
        pair: format!("prediction-{name}"),
        side: if side.identified { "after" } else { "before" },
        sides: Some(["nominal minus identified", "expected"]),
        scaled: true,
        svg: svg.finish(),
        caption: description,
        ..Figure::default()
    }
}

fn length(mm: f64) -> String {
    let shown = number::shown("mm", mm);
    format!("{} {}", number::significant(mm * shown.factor, 3), shown.unit)
}

fn tooltip(n: &MapNode, words: &Words) -> String {
    let [x, y, z] = n.at_mm.map(number::stated);
    let [difference, expected, p95] = [n.before_mm, n.standard_uncertainty_mm, n.p95_mm].map(length);
    let values: [&dyn std::fmt::Display; 6] = [&x, &y, &z, &difference, &expected, &p95];
    words.fill("x {0}, y {1}, z {2} mm: nominal minus identified {3}; expected {4} (k = 1), 95 % at most {5}", &values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_documents::ToolFrame;

    fn node(at_mm: [f64; 3], before_mm: f64, after_mm: f64) -> MapNode {
        let (joints, parameters_mm, p95_mm) = (vec![], after_mm, 2.0 * after_mm);
        MapNode { at_mm, joints, before_mm, parameters_mm, standard_uncertainty_mm: after_mm, p95_mm }
    }

    fn drawn(nodes: Vec<MapNode>, planar: bool) -> Vec<Figure> {
        let (definition, point_mm, frame) = (String::new(), [0.0; 3], ToolFrame::Flange);
        let map = PredictionMap { definition, point_mm, frame, spacing_mm: 20.0, nodes };
        pictures(&map, planar, &Words::default())
    }

    #[test]
    fn every_plane_has_a_cell_for_each_place_and_the_largest_of_those_behind_one_another() {
        let nodes =
            vec![node([0.0; 3], 0.2, 0.002), node([20.0, 0.0, 0.0], 0.4, 0.004), node([0.0, 0.0, 20.0], 0.3, 0.006)];
        assert_eq!(drawn(nodes.clone(), true).len(), 2);
        let figures = drawn(nodes, false);
        let cells: Vec<_> = figures.iter().map(|f| f.svg.matches("<rect").count()).collect();
        assert_eq!(cells, [2, 2, 3, 3, 2, 2]);
        assert!(figures[1].svg.contains("x 0, y 0, z 20 mm") && !figures[1].svg.contains("x 0, y 0, z 0 mm"));
        assert!(
            figures[1].svg.contains("nominal minus identified 300 µm; expected 6.00 µm (k = 1), 95 % at most 12.0 µm")
        );
        // 400 µm are the darkest of the common scale, on which 6 µm are the lightest; of their own they are dark
        assert!(figures[2].svg.contains("class=\"map o15 w15\"") && figures[3].svg.contains("class=\"map o0 w15\""));
        assert!(
            figures[0].caption.contains("Of cells behind one another") && figures[0].caption.contains("0 to 400 µm")
        );
    }

    #[test]
    fn places_of_no_robot_are_not_drawn() {
        assert!(drawn(vec![node([f64::NAN; 3], 0.1, 0.1), node([0.0; 3], 1e300, 0.1)], false).is_empty());
    }
}
