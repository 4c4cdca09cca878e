//! Meshes of a robot's links for pictures: STL, OBJ and COLLADA. A mesh that cannot be read is left
//! out: no result depends on it.

mod collada;
mod obj;
mod stl;

use etalon_base::pose::Vector;
use indexmap::IndexSet;
use std::collections::BTreeSet;

/// Maximum number of triangles of a file.
const MOST: usize = 1_000_000;

/// Maximum coordinate of a packed point.
const FINEST: f64 = 65_535.0;

/// Numbers of cells along the longest side into which points are packed, until the triangles are
/// few enough.
const CELLS: [f64; 9] = [FINEST, 2048.0, 1024.0, 512.0, 256.0, 128.0, 64.0, 32.0, 16.0];

/// Corners of a triangle, in the unit of the file; of COLLADA in metres.
pub type Triangle = [[f32; 3]; 3];

/// `true` if a file has the name of a mesh that can be read.
pub fn is_mesh(file: &str) -> bool {
    ["stl", "obj", "dae"].contains(&end(file).as_str())
}

/// Extension of a name in small letters.
fn end(file: &str) -> String {
    file.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase()).unwrap_or_default()
}

/// Triangles of a file; `None` if it cannot be read, or is too large.
pub fn read(file: &str, bytes: &[u8]) -> Option<Vec<Triangle>> {
    let text = || std::str::from_utf8(bytes).ok();
    let triangles = match end(file).as_str() {
        "stl" => stl::read(bytes)?,
        "obj" => obj::read(text()?)?,
        "dae" => collada::read(text()?)?,
        _ => return None,
    };
    let whole = !triangles.is_empty() && triangles.iter().flatten().flatten().all(|v| v.is_finite());
    whole.then_some(triangles)
}

/// Triangles on a grid, each point once.
#[derive(Clone, Debug, PartialEq)]
pub struct Packed {
    /// Lowest coordinates.
    pub low: Vector,
    /// Length of the longest side: the coordinate 65,535.
    pub size: f64,
    /// Points, in parts of the length.
    pub points: Vec<[u16; 3]>,
    /// Indices of the corners.
    pub triangles: Vec<[u16; 3]>,
}

impl Packed {
    /// Packs triangles. Points of a cell are one point, and the cells grow until at most `most`
    /// triangles have three points.
    pub fn new(triangles: &[[Vector; 3]], most: usize) -> Option<Self> {
        let corners = || triangles.iter().flatten();
        let ends = |pick: fn(f64, f64) -> f64| corners().copied().reduce(|a, b| [0, 1, 2].map(|i| pick(a[i], b[i])));
        let (low, high) = (ends(f64::min)?, ends(f64::max)?);
        let size = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        CELLS.iter().find_map(|cells| {
            let cell = |p: &Vector| [0, 1, 2].map(|i| ((p[i] - low[i]) / size * cells).round());
            let mut points = IndexSet::new();
            let mut found: BTreeSet<[u16; 3]> = BTreeSet::new();
            for triangle in triangles {
                let mut index = |p: &Vector| {
                    let at = cell(p).map(|v| (v / cells * FINEST).round() as u16);
                    u16::try_from(points.insert_full(at).0).ok()
                };
                let [a, b, c] = [index(&triangle[0])?, index(&triangle[1])?, index(&triangle[2])?];
                if a != b && b != c && c != a {
                    // the smallest corner first, in the order of the triangle
                    let turned = [[a, b, c], [b, c, a], [c, a, b]];
                    found.extend(turned.into_iter().min());
                }
                if found.len() > most {
                    return None;
                }
            }
            let (points, triangles) = (points.into_iter().collect(), found.into_iter().collect::<Vec<_>>());
            (!triangles.is_empty()).then_some(Self { low, size, points, triangles })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron of 2 × 2 × 2 with the volume 8/6.
    const CORNERS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
    const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

    /// Volume within a closed mesh (divergence theorem).
    fn volume(triangles: &[Triangle]) -> f64 {
        let of = |t: &Triangle| {
            let [a, b, c] = t.map(|p| p.map(f64::from));
            a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        };
        triangles.iter().map(of).sum::<f64>() / 6.0
    }

    fn tetrahedron() -> Vec<Triangle> {
        FACES.map(|face| face.map(|corner| CORNERS[corner])).to_vec()
    }

    #[test]
    fn every_format_has_the_same_solid() {
        let facet = |t: &Triangle| {
            let corners: String = t.iter().map(|[x, y, z]| format!("vertex {x} {y} {z}\n")).collect();
            format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
        };
        let stl = format!("solid t\n{}endsolid t\n", tetrahedron().iter().map(facet).collect::<String>());
        let mut binary = vec![b'x'; 80];
        binary.extend(4u32.to_le_bytes());
        for t in tetrahedron() {
            [[0.0; 3]].iter().chain(&t).flatten().for_each(|v| binary.extend(v.to_le_bytes()));
            binary.extend([0, 0]);
        }
        let obj = "# t\nv 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1/1 2/1/4 4//2\nf -4 -1 -2\nf 2 3 4\n";
        let dae = r##"<?xml version="1.0"?><COLLADA xmlns="x"><asset><unit meter="0.01"/></asset><library_geometries>
            <geometry id="g"><mesh><source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
            <technique_common><accessor source="#a" count="4" stride="3"/></technique_common></source>
            <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
            <triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="NORMAL" source="#n" offset="1"/>
            <p>0 9 2 9 1 9 0 9 1 9 3 9</p></triangles>
            <polylist count="2"><input semantic="VERTEX" source="#v" offset="0"/><vcount>3 3</vcount><p>0 3 2 1 2 3</p></polylist>
            </mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node><scale>100 100 100</scale>
            <node><matrix>2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1</matrix><instance_geometry url="#g"/></node></node></visual_scene>
            </library_visual_scenes></COLLADA>"##;
        for (name, bytes) in
            [("a.stl", stl.as_bytes()), ("B.STL", &binary), ("c.obj", obj.as_bytes()), ("d.dae", dae.as_bytes())]
        {
            let triangles = read(name, bytes).unwrap_or_else(|| panic!("{name}"));
            assert_eq!(triangles.len(), 4, "{name}");
            assert!((volume(&triangles) - 8.0 / 6.0).abs() < 1e-6, "{name}: {}", volume(&triangles));
        }
    }

    #[test]
    fn hostile_meshes_are_left_out() {
        let hostile: [(&str, &[u8]); 8] = [
            ("a.stl", b""),
            ("a.stl", b"solid\nfacet\nvertex 1 2\n"),
            ("a.stl", b"solid\nfacet\nvertex nan 0 0\nvertex 1 0 0\nvertex 0 1 0\n"),
            ("a.obj", b"v 0 0 0\nf 1 2 3\n"),
            ("a.obj", b"v 0 0 0\nf -1 -2 -3\n"),
            ("a.dae", b"<COLLADA>"),
            ("a.dae", b"<!DOCTYPE x [<!ENTITY a \"b\">]><COLLADA/>"),
            ("a.xyz", b"0 0 0"),
        ];
        for (name, bytes) in hostile {
            assert_eq!(read(name, bytes), None, "{name}");
        }
        let mut cut = vec![0; 84];
        cut[80..].copy_from_slice(&u32::MAX.to_le_bytes());
        assert_eq!(read("a.stl", &cut), None, "more triangles than bytes");
    }

    #[test]
    fn a_fine_mesh_is_packed_into_few_triangles_that_stay_in_place() {
        // a cylinder of 3,000 facets
        let corner = |i: usize, z: f64| {
            let angle = i as f64 / 3000.0 * std::f64::consts::TAU;
            [10.0 + 3.0 * angle.cos(), 3.0 * angle.sin(), z]
        };
        let facet = |i: usize| [[corner(i, 0.0), corner(i + 1, 0.0), corner(i, 5.0)]];
        let fine: Vec<[Vector; 3]> = (0..3000).flat_map(facet).collect();
        let packed = Packed::new(&fine, 500).unwrap();
        assert!(packed.triangles.len() <= 500 && packed.triangles.len() > 50, "{}", packed.triangles.len());
        for point in &packed.points {
            let [x, y, z] = [0, 1, 2].map(|i| packed.low[i] + f64::from(point[i]) / FINEST * packed.size);
            let beside = ((x - 10.0).hypot(y) - 3.0).abs();
            assert!(beside < 6.0 / 32.0 && (z.abs() < 0.2 || (z - 5.0).abs() < 0.2), "{x} {y} {z}");
        }
        let whole = Packed::new(&fine, 4000).unwrap();
        assert_eq!(whole.triangles.len(), 3000);
        assert_eq!(Packed::new(&[], 10), None);
        assert_eq!(Packed::new(&[[[1.0; 3]; 3]], 10), None, "a point");
    }
}
