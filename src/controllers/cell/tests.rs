//! Data of controllers, read back by readers that share nothing with the writers.

use super::*;
use etalon_base::pose::minus;
use etalon_documents::{CellFrameEntry, Provenance};
use std::collections::BTreeMap;

fn document(solve: &str, pose: &Pose) -> CellDocument {
    let frame = CellFrameEntry {
        name: "tool".to_owned(),
        reference: "flange".to_owned(),
        xyz_mm: pose.translation_mm,
        quaternion: pose.quaternion(),
        standard_uncertainty_mm: Some([0.011, 0.012, 0.013]),
        standard_uncertainty_deg: Some([0.021, 0.022, 0.023]),
        covariance: None,
    };
    CellDocument {
        schema: "etalon/cell/1".to_owned(),
        provenance: Provenance { version: "0".to_owned(), inputs: BTreeMap::new(), seed: None },
        solve: solve.to_owned(),
        readings: 8,
        frames: vec![frame],
        points: Vec::new(),
        axis: None,
        noise: Vec::new(),
        residuals: Vec::new(),
        messages: Vec::new(),
    }
}

/// Numbers of a text in their order.
fn numbers(text: &str) -> Vec<f64> {
    text.split(|c: char| !(c.is_ascii_digit() || "+-.e".contains(c))).filter_map(|t| t.parse().ok()).collect()
}

/// Rotation matrix of elementary rotations, written out.
fn rotation(axis: char, deg: f64) -> [[f64; 3]; 3] {
    let (s, c) = deg.to_radians().sin_cos();
    match axis {
        'x' => [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
        'y' => [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
        _ => [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
    }
}

fn product(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

fn zyx(z: f64, y: f64, x: f64) -> [[f64; 3]; 3] {
    product(product(rotation('z', z), rotation('y', y)), rotation('x', x))
}

/// Position (mm) and rotation matrix of the data of a maker.
fn read(maker: &str, text: &str) -> (Vector, [[f64; 3]; 3]) {
    let line = |start: &str| text.lines().map(str::trim).find(|l| l.starts_with(start)).unwrap_or_default().to_owned();
    match maker {
        "abb" => {
            let data = line("PERS");
            let n = numbers(data.split_once(":=").unwrap().1);
            let [w, x, y, z] = [n[3], n[4], n[5], n[6]];
            assert!((w * w + x * x + y * y + z * z - 1.0).abs() < 1e-9);
            let rotation = [
                [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
                [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
                [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z],
            ];
            ([n[0], n[1], n[2]], rotation)
        }
        "kuka" => {
            let data = line("TOOL_DATA[3]") + &line("BASE_DATA[3]");
            let n = numbers(data.split_once('=').unwrap().1);
            ([n[0], n[1], n[2]], zyx(n[3], n[4], n[5]))
        }
        "fanuc" => {
            let element = |i: usize| {
                let start = format!("PR[3,{i}]=");
                let row = text.lines().find(|l| l.contains(&start)).unwrap();
                numbers(row.split_once(&start).unwrap().1)[0]
            };
            assert!(text.contains("UTOOL[3]=PR[3]") || text.contains("UFRAME[3]=PR[3]"));
            ([1, 2, 3].map(element), zyx(element(6), element(5), element(4)))
        }
        _ => {
            let data = line("set_tcp(p[") + &line("global");
            let n = numbers(data.split_once("p[").unwrap().1);
            let v = [n[3], n[4], n[5]];
            let angle = norm(v);
            // Rodrigues
            let k = [[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]];
            let square = product(k, k);
            let (a, b) = (angle.sin() / angle, (1.0 - angle.cos()) / (angle * angle));
            let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
            let rotation =
                std::array::from_fn(|i| std::array::from_fn(|j| unit(i, j) + a * k[i][j] + b * square[i][j]));
            ([n[0], n[1], n[2]].map(|v| 1000.0 * v), rotation)
        }
    }
}

#[test]
fn data_read_back_are_the_frame() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let poses = [
        Pose::from_xyz_rpy([12.5, -0.004, 150.25], [0.3, -0.7, 2.9]),
        Pose::from_xyz_rpy([-1200.0, 30.0, 0.5], [-3.0, 1.1, -0.2]),
        // a pitch of a right angle
        Pose::from_xyz_rpy([1.0, 2.0, 3.0], [0.4, quarter, 0.0]),
        Pose::from_xyz_rpy([1.0, 2.0, 3.0], [0.4, -quarter, 0.1]),
    ];
    for (pose, solve) in poses.iter().zip(["hand-eye", "object", "tool-axes", "three-points"]) {
        let data = CellData::new(&document(solve, pose), "grip-1", 3).unwrap();
        for maker in names() {
            let text = by_name(maker).unwrap().text(&data);
            let (at, rotation) = read(maker, &text);
            assert!(norm(minus(at, pose.translation_mm)) < 2e-6, "{maker}: {text}");
            let off = (0..9).map(|k| (rotation[k / 3][k % 3] - pose.rotation[k / 3][k % 3]).abs()).fold(0.0, f64::max);
            assert!(off < 3e-8, "{maker}: {off}\n{text}");
            assert!(text.contains("0.011000") || maker == "fanuc", "{maker} states the uncertainty: {text}");
        }
    }
    assert!(CellData::new(&document("linear-axis", &poses[0]), "a", 1).is_none());
}

#[test]
fn names_are_those_of_the_language() {
    let data = CellData::new(&document("hand-eye", &Pose::identity()), "1 grip; ! \"x\"", 2).unwrap();
    let abb = by_name("abb").unwrap().text(&data);
    assert!(abb.contains("PERS tooldata P1_grip_____x_:=[TRUE,[["), "{abb}");
    let fanuc = by_name("fanuc").unwrap().text(&data);
    assert!(fanuc.lines().all(|line| line.len() < 60), "{fanuc}");
    assert!(fanuc.contains("0.011000") || fanuc.replace([' ', '\n', ';', '!', ':'], "").contains("0.0110"), "{fanuc}");
}
