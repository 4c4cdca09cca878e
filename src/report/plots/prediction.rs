//! Expected error at the tool point over the workspace: a cell for each node, with the largest of
//! overlapping nodes.

use super::layer::*;
use super::map::{class, length, scale, scales, top};
use etalon_documents::{MapNode, PredictionMap};
use std::collections::BTreeMap;

/// Maximum plausible coordinate of a node (mm).
const DRAWABLE_MM: f64 = 1e7;
/// Distance within which nodes overlap (units of the figure).
const NEAR: f64 = 1.0;

/// Nominal minus identified model, and expected error with the identified model, in every plane of
/// the workspace.
pub(crate) fn pictures(map: &PredictionMap, planar: bool, words: &Words) -> Vec<Figure> {
    let small = |n: &&MapNode| n.at_mm.iter().chain([&n.before_mm, &n.p95_mm]).all(|v| v.abs() < DRAWABLE_MM);
    let nodes: Vec<&MapNode> = map.nodes.iter().filter(small).collect();
    let common = scale(nodes.iter().flat_map(|n| [size(false)(n), size(true)(n)]));
    let grid = Grid { nodes, spacing_mm: map.spacing_mm };
    let drawn = if grid.nodes.is_empty() { &[][..] } else { Seen::planes(planar) };
    let pair = |&seen| [false, true].map(|identified| picture(&grid, seen, identified, &common, words));
    drawn.iter().flat_map(pair).collect()
}

fn size(identified: bool) -> fn(&MapNode) -> f64 {
    if identified { |n| n.standard_uncertainty_mm } else { |n| n.before_mm }
}

/// Nodes of a map that can be drawn.
struct Grid<'a> {
    nodes: Vec<&'a MapNode>,
    /// Distance between neighbouring nodes (mm).
    spacing_mm: f64,
}

fn picture(grid: &Grid, seen: Seen, identified: bool, common: &Axis, words: &Words) -> Figure {
    let Grid { nodes, spacing_mm } = grid;
    let size = size(identified);
    let own = scale(nodes.iter().map(|n| size(n)));
    let mut map = Workspace::new(seen, &nodes.iter().map(|n| n.at_mm).collect::<Vec<_>>(), words);
    let mut cells: BTreeMap<(i64, i64), &MapNode> = BTreeMap::new();
    for node in nodes {
        let (x, y) = map.at(node.at_mm).at;
        let cell = cells.entry(((x / NEAR) as i64, (y / NEAR) as i64)).or_insert(node);
        if size(node) > size(cell) {
            *cell = node;
        }
    }
    let edge = (map.scale * spacing_mm).clamp(4.0, 40.0);
    for node in cells.values() {
        let (x, y) = map.at(node.at_mm).at;
        let class = class([common, &own], size(node));
        let look = Look::new(Shape::Square, &class);
        map.svg.rect(look, (x - 0.5 * edge, y - 0.5 * edge), (edge, edge), &tooltip(node, words));
    }
    scales(&mut map.svg, Shape::Square, [common, &own]);
    let name = seen.name();
    let title = match identified {
        false => tr!(words, "prediction-difference-title", plane = name),
        true => tr!(words, "prediction-expected-title", plane = name),
    };
    let largest = length(super::axis::largest(nodes.iter().map(|n| size(n))));
    let spacing = number::stated(*spacing_mm);
    let mut description = tr!(
        words,
        "prediction-description",
        spacing = spacing.clone(),
        colour = top(common),
        largest = largest.clone()
    );
    let mut of_own = tr!(words, "prediction-own-scale", spacing, colour = top(&own), largest);
    if seen != XY || nodes.iter().any(|n| n.at_mm[2] != nodes[0].at_mm[2]) {
        let behind = format!(" {}", tr!(words, "prediction-behind"));
        description += &behind;
        of_own += &behind;
    }
    let key = if identified { "identified" } else { "nominal" };
    Figure {
        pair: format!("prediction-{name}"),
        side: points::side(identified),
        sides: Some([tr!(words, "nominal-minus-identified"), tr!(words, "expected")]),
        scaled: true,
        caption_own: of_own,
        ..map.figure(&format!("prediction-{key}-{name}"), title, description)
    }
}

fn tooltip(n: &MapNode, words: &Words) -> String {
    let [x, y, z] = n.at_mm.map(number::stated);
    let [difference, expected, p95] = [n.before_mm, n.standard_uncertainty_mm, n.p95_mm].map(length);
    tr!(words, "prediction-tooltip", x, y, z, difference, expected, largest = p95)
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_documents::ToolFrame;

    fn node(at_mm: [f64; 3], before_mm: f64, after_mm: f64) -> MapNode {
        let (joints, parameters_mm, p95_mm) = (vec![], after_mm, 2.0 * after_mm);
        MapNode {
            at_mm,
            joints,
            before_mm,
            parameters_mm,
            standard_uncertainty_mm: after_mm,
            with_field_mm: None,
            p95_mm,
        }
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
            figures[1].svg.contains("nominal minus identified 300 µm; expected 6.00 µm (k = 1), 95 % within 12.0 µm")
        );
        // 400 µm is the darkest colour on the common scale, and 6 µm the lightest; on their own
        // scale both are dark
        assert!(figures[2].svg.contains("class=\"map o15 w15\"") && figures[3].svg.contains("class=\"map o0 w15\""));
        let behind = tr!(Words::default(), "prediction-behind");
        assert!(figures[0].caption.contains(&behind) && figures[0].caption.contains("0 to 400 µm"));
    }

    #[test]
    fn places_of_no_robot_are_not_drawn() {
        assert!(drawn(vec![node([f64::NAN; 3], 0.1, 0.1), node([0.0; 3], 1e300, 0.1)], false).is_empty());
    }
}
