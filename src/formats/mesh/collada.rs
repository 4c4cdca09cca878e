//! COLLADA 1.4: triangles and polygons of the visual scene, in metres. The direction of `up_axis`
//! is ignored, as programs of ROS do: links have their own frames.

use super::{MOST, Triangle};
use crate::xml::{Elements, Node};
use std::collections::BTreeMap;

/// Elements without geometry.
const SKIPPED: [&str; 8] = [
    "library_images",
    "library_materials",
    "library_effects",
    "library_animations",
    "library_controllers",
    "library_cameras",
    "library_lights",
    "extra",
];

/// An affine transformation, row by row.
type Affine = [[f64; 4]; 3];

/// Triangles of each geometry, by its id.
type Geometries = BTreeMap<String, Vec<Triangle>>;

/// Triangles of a file.
pub(super) fn read(text: &str) -> Option<Vec<Triangle>> {
    let xml = Elements::read("", text, |name| SKIPPED.contains(&name)).ok()?;
    let root = xml.root()?;
    let unit = root.child("asset").and_then(|asset| asset.child("unit")?.attribute("meter")?.parse::<f64>().ok());
    let unit = unit.unwrap_or(1.0);
    let mut geometries = Geometries::new();
    for node in root.all().filter(|node| node.name() == "geometry") {
        if let (Some(id), Some(mesh)) = (node.attribute("id"), node.child("mesh")) {
            geometries.insert(id.into_owned(), triangles(mesh)?);
        }
    }
    let metres: Affine = [[unit, 0.0, 0.0, 0.0], [0.0, unit, 0.0, 0.0], [0.0, 0.0, unit, 0.0]];
    let mut all = Vec::new();
    for scene in root.all().filter(|node| node.name() == "visual_scene") {
        instances(scene, &metres, &geometries, &mut all)?;
    }
    if all.is_empty() {
        geometries.values().try_for_each(|geometry| place(geometry, &metres, &mut all))?;
    }
    Some(all)
}

/// Adds the geometries of a node and of the nodes below it.
fn instances(node: Node, at: &Affine, geometries: &Geometries, all: &mut Vec<Triangle>) -> Option<()> {
    let mut at = *at;
    for child in node.children() {
        match child.name() {
            "matrix" | "translate" | "rotate" | "scale" => at = then(&at, &motion(child)?),
            "instance_geometry" => {
                let id = child.attribute("url")?;
                if let Some(geometry) = geometries.get(id.trim_start_matches('#')) {
                    place(geometry, &at, all)?;
                }
            }
            "node" => instances(child, &at, geometries, all)?,
            _ => {}
        }
    }
    Some(())
}

/// Adds the triangles of a geometry at a place; `None` if they are too many.
fn place(geometry: &[Triangle], at: &Affine, all: &mut Vec<Triangle>) -> Option<()> {
    (all.len() + geometry.len() <= MOST).then_some(())?;
    let moved = |p: [f32; 3]| {
        let [x, y, z] = p.map(f64::from);
        at.map(|row| (row[0] * x + row[1] * y + row[2] * z + row[3]) as f32)
    };
    all.extend(geometry.iter().map(|triangle| triangle.map(moved)));
    Some(())
}

/// Motion of an element of a node.
fn motion(node: Node) -> Option<Affine> {
    let v = node.numbers().ok()?;
    Some(match (node.name(), &v[..]) {
        ("matrix", [m @ .., _, _, _, _]) if m.len() == 12 => {
            [[m[0], m[1], m[2], m[3]], [m[4], m[5], m[6], m[7]], [m[8], m[9], m[10], m[11]]]
        }
        ("translate", [x, y, z]) => [[1.0, 0.0, 0.0, *x], [0.0, 1.0, 0.0, *y], [0.0, 0.0, 1.0, *z]],
        ("scale", [x, y, z]) => [[*x, 0.0, 0.0, 0.0], [0.0, *y, 0.0, 0.0], [0.0, 0.0, *z, 0.0]],
        ("rotate", [x, y, z, degrees]) => rotation([*x, *y, *z], degrees.to_radians())?,
        _ => return None,
    })
}

/// Rotation about an axis (Rodrigues).
fn rotation(axis: [f64; 3], angle: f64) -> Option<Affine> {
    let [x, y, z] = etalon_base::pose::unit(axis)?;
    let (s, c) = angle.sin_cos();
    let d = 1.0 - c;
    Some([
        [c + x * x * d, x * y * d - z * s, x * z * d + y * s, 0.0],
        [y * x * d + z * s, c + y * y * d, y * z * d - x * s, 0.0],
        [z * x * d - y * s, z * y * d + x * s, c + z * z * d, 0.0],
    ])
}

/// The second motion in the frame that the first one reached.
fn then(first: &Affine, second: &Affine) -> Affine {
    first.map(|row| {
        let of = |column: usize| (0..3).map(|k| row[k] * second[k][column]).sum::<f64>();
        [of(0), of(1), of(2), of(3) + row[3]]
    })
}

/// Triangles of a mesh.
fn triangles(mesh: Node) -> Option<Vec<Triangle>> {
    let id = |text: &str| text.trim_start_matches('#').to_owned();
    let mut points: BTreeMap<String, Vec<[f32; 3]>> = BTreeMap::new();
    for source in mesh.children().filter(|node| node.name() == "source") {
        let (Some(name), Some(array)) = (source.attribute("id"), source.child("float_array")) else { continue };
        let accessor = source.child("technique_common").and_then(|common| common.child("accessor"));
        let stride = accessor.and_then(|accessor| accessor.attribute("stride")?.parse::<usize>().ok());
        let rows = array.numbers().ok()?;
        let rows = rows.chunks_exact(stride.unwrap_or(3).max(1)).filter_map(|row| row.get(..3));
        points.insert(name.into_owned(), rows.map(|row| [row[0], row[1], row[2]].map(|v| v as f32)).collect());
    }
    let vertices = mesh.child("vertices")?;
    let position = vertices.children().find(|input| input.attribute("semantic").as_deref() == Some("POSITION"))?;
    let points = points.get(&id(&position.attribute("source")?))?;
    let mut all = Vec::new();
    for part in mesh.children() {
        let inputs: Vec<Node> = part.children().filter(|node| node.name() == "input").collect();
        let offset = |input: &Node| input.attribute("offset").and_then(|offset| offset.parse::<usize>().ok());
        let is_vertex = |input: &&Node| input.attribute("semantic").as_deref() == Some("VERTEX");
        let Some(at) = inputs.iter().find(is_vertex).and_then(offset) else { continue };
        let stride = inputs.iter().filter_map(offset).max().unwrap_or(0).checked_add(1)?;
        let mut counts = part.child("vcount").map_or_else(|| Some(Vec::new()), whole)?.into_iter();
        for list in part.children().filter(|node| node.name() == "p") {
            let corners =
                whole(list)?.chunks_exact(stride).map(|c| points.get(c[at]).copied()).collect::<Option<Vec<_>>>()?;
            let mut rest = &corners[..];
            while !rest.is_empty() {
                let count = match part.name() {
                    "triangles" => 3,
                    "polylist" => counts.next()?,
                    "polygons" => rest.len(),
                    _ => break,
                };
                let polygon = rest.get(..count.max(1))?;
                rest = &rest[polygon.len()..];
                let (first, others) = polygon.split_first()?;
                all.extend(others.windows(2).map(|pair| [*first, pair[0], pair[1]]));
                (all.len() <= MOST).then_some(())?;
            }
        }
    }
    Some(all)
}

/// Whole numbers in the text of an element.
fn whole(node: Node) -> Option<Vec<usize>> {
    node.text().split_ascii_whitespace().map(|word| word.parse().ok()).collect()
}
