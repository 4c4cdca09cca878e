//! Answers to tests of TraCIM, on data of our own: points of elements that are known.

use super::{etalon, text};
use std::f64::consts::TAU;
use std::fmt::Write;

/// Test data with these data sets: identification, element, points.
fn test_data(package: &str, sets: &[(&str, &str, Vec<[f64; 3]>)]) -> String {
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<tracim:tracim xmlns:{package}=\"http://tracim.ptb.de/{package}/test\" \
         xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns:tracim=\"http://tracim.ptb.de/tracim\">\n\
         <tracim:order><tracim:key>ORDER</tracim:key></tracim:order>\n<tracim:process><tracim:key>PROCESS</tracim:key></tracim:process>\n\
         <tracim:test xsi:type=\"{package}:{package}TestPackage\"><{package}:package>\n"
    );
    for (id, object, points) in sets {
        let _ = writeln!(text, "<{package}:testElement><{package}:basicID>{id}</{package}:basicID>");
        let _ =
            writeln!(text, "<{package}:computationObject>{object}</{package}:computationObject><{package}:pointCloud>");
        for [x, y, z] in points {
            let _ = writeln!(
                text,
                "<{package}:vectors><{package}:x>{x:.20}</{package}:x><{package}:y>{y:.20}</{package}:y><{package}:z>{z:.20}</{package}:z></{package}:vectors>"
            );
        }
        let _ = writeln!(text, "</{package}:pointCloud></{package}:testElement>");
    }
    text + &format!("</{package}:package></tracim:test></tracim:tracim>\n")
}

/// Answer of the program, which must succeed.
fn answer(data: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("data.xml"), data).unwrap();
    let output = etalon(folder.path(), &["fit", "--tracim", "data.xml", "--customer", "A & B"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    text(&output.stdout)
}

/// Text of the elements of a name, in order.
fn texts<'a>(xml: &'a str, tag: &str) -> Vec<&'a str> {
    xml.split(&format!("<{tag}>")).skip(1).map(|rest| rest.split("</").next().unwrap()).collect()
}

fn numbers(xml: &str, tag: &str) -> Vec<f64> {
    texts(xml, tag).iter().map(|text| text.parse().unwrap()).collect()
}

/// The part of an answer about a data set.
fn result<'a>(xml: &'a str, id: &str) -> &'a str {
    let marked = format!("<basicID>{id}</basicID>");
    xml.split("<results>").find(|part| part.contains(&marked)).unwrap()
}

fn vector(xml: &str, name: &str) -> [f64; 3] {
    ["X", "Y", "Z"].map(|axis| numbers(xml, &format!("{name}{axis}"))[0])
}

fn near(a: &[f64], b: &[f64], within: f64) {
    assert!(a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < within), "{a:?} {b:?}");
}

/// Points on circles about the axis z through (3, -2): height, radius.
fn round(circles: &[(f64, f64)]) -> Vec<[f64; 3]> {
    let at = |height: f64, radius: f64, turn: f64| [3.0 + radius * turn.cos(), -2.0 + radius * turn.sin(), height];
    circles
        .iter()
        .flat_map(|&(height, radius)| (0..12).map(move |i| at(height, radius, TAU * f64::from(i) / 12.0)))
        .collect()
}

#[test]
fn gaussian_elements_are_answered() {
    let line: Vec<[f64; 3]> = (0..9).map(|i| [f64::from(i) * 0.6 + 1.0, 5.0, f64::from(i) * 0.8]).collect();
    let grid = || (0..4).flat_map(|i| (0..4).map(move |k| (f64::from(i), f64::from(k))));
    // deviations that no plane follows: a saddle
    let plane: Vec<[f64; 3]> = grid().map(|(x, y)| [x, y, 7.0 + 0.01 * (x - 1.5) * (y - 1.5)]).collect();
    let sphere = round(&[(4.0, 3.0), (0.0, 5.0), (-3.0, 4.0)]);
    let cone = round(&[(0.0, 10.0), (10.0, 8.0), (20.0, 6.0)]);
    let data = test_data(
        "gauss",
        &[
            ("b01", "LINE_3D", line),
            ("b05", "PLANE", plane),
            ("b09", "CIRCLE", round(&[(1.5, 20.0)])),
            ("b16", "CYLINDER", round(&[(0.0, 12.0), (30.0, 12.0)])),
            ("b26", "CONE", cone),
            ("b38", "SPHERE", sphere),
        ],
    );
    let xml = answer(&data);
    assert!(xml.contains("<gaussResultPackage ") && xml.contains("xmlns=\"http://tracim.ptb.de/gauss/test\""));
    assert_eq!(texts(&xml, "processKey"), ["PROCESS"]);
    assert_eq!(texts(&xml, "customer"), ["A &amp; B"]);
    assert_eq!(texts(&xml, "basicID"), ["b01", "b05", "b09", "b16", "b26", "b38"]);
    assert_eq!(texts(&xml, "computationObject")[2], "CIRCLE");
    let of = |id: &str| result(&xml, id);
    let upright = |v: [f64; 3]| near(&[v[0], v[1], v[2].abs()], &[0.0, 0.0, 1.0], 1e-12);
    near(&vector(of("b01"), "orientation"), &[0.6, 0.0, 0.8], 1e-12);
    upright(vector(of("b05"), "orientation"));
    near(&vector(of("b05"), "position")[2..], &[7.0], 1e-12);
    near(&vector(of("b09"), "position"), &[3.0, -2.0, 1.5], 1e-12);
    near(&numbers(of("b09"), "radius"), &[20.0], 1e-12);
    near(&vector(of("b16"), "position")[..2], &[3.0, -2.0], 1e-12);
    near(&numbers(of("b16"), "radius"), &[12.0], 1e-12);
    // towards decreasing radii; the radius at the position; the full angle
    near(&vector(of("b26"), "orientation"), &[0.0, 0.0, 1.0], 1e-12);
    let height = vector(of("b26"), "position")[2];
    near(&numbers(of("b26"), "radius"), &[10.0 - 0.2 * height], 1e-11);
    near(&numbers(of("b26"), "angle"), &[2.0 * 0.2f64.atan().to_degrees()], 1e-11);
    near(&vector(of("b38"), "position"), &[3.0, -2.0, 0.0], 1e-11);
    near(&numbers(of("b38"), "radius"), &[5.0], 1e-11);
    assert!(texts(of("b38"), "orientationX").is_empty() && texts(of("b01"), "radius").is_empty());
    near(&numbers(&xml, "mpe_size"), &[1e-4], 1e-18);
    near(&numbers(&xml, "mpe_angle"), &[1e-7], 1e-18);
}

#[test]
fn chebyshev_elements_are_answered() {
    // every second point is 0.01 mm outside or above
    let wavy = |radius: f64, height: f64| -> Vec<[f64; 3]> {
        let at = |i: usize| {
            let (turn, radius) = (TAU * i as f64 / 16.0, radius + 0.01 * (i % 2) as f64);
            [1.0 + radius * turn.cos(), 2.0 + radius * turn.sin(), height]
        };
        (0..16).map(at).collect()
    };
    let line: Vec<[f64; 3]> = (0..9).map(|i| [f64::from(i), 3.0 + 0.02 * f64::from(i % 2), 0.0]).collect();
    let grid = (0..5).flat_map(|i| (0..5).map(move |k| (i, k)));
    let plane: Vec<[f64; 3]> = grid.map(|(i, k)| [f64::from(i), f64::from(k), 0.03 * f64::from((i + k) % 2)]).collect();
    // six points on the axes, eight in the corners 0.01 mm further out
    let mut sphere: Vec<[f64; 3]> = (0..6)
        .map(|i| std::array::from_fn(|k| if k == i / 2 { 9.0 * (1.0 - 2.0 * (i % 2) as f64) } else { 0.0 }))
        .collect();
    let corner = 9.01 / 3f64.sqrt();
    sphere.extend((0..8).map(|i| [0, 1, 2].map(|k| if i >> k & 1 == 0 { corner } else { -corner })));
    let cylinder = [wavy(8.0, 0.0), wavy(8.0, 10.0), wavy(8.0, 20.0)].concat();
    let data = test_data(
        "chebyshev",
        &[
            ("C01", "LINE_2D", line),
            ("C09", "CIRCLE_2D", wavy(8.0, 0.0)),
            ("C17", "PLANE", plane),
            ("C27", "SPHERE", sphere),
            ("C37", "CYLINDER", cylinder),
        ],
    );
    let xml = answer(&data);
    assert!(xml.contains("<chebyshevResultPackage ") && xml.contains("xmlns=\"http://tracim.ptb.de/chebyshev/test\""));
    near(&numbers(&xml, "formDeviation"), &[0.02, 0.01, 0.03, 0.01, 0.01], 1e-9);
    let of = |id: &str| result(&xml, id);
    near(&vector(of("C01"), "position")[1..], &[3.01, 0.0], 1e-9);
    near(&vector(of("C09"), "position"), &[1.0, 2.0, 0.0], 1e-9);
    near(&numbers(of("C09"), "radius"), &[8.005], 1e-9);
    near(&vector(of("C17"), "position")[2..], &[0.015], 1e-9);
    near(&vector(of("C27"), "position"), &[0.0; 3], 1e-9);
    near(&vector(of("C27"), "orientation"), &[0.0; 3], 1e-18);
    near(&numbers(of("C27"), "radius"), &[9.005], 1e-9);
    near(&numbers(of("C37"), "radius"), &[8.005], 1e-9);
    near(&numbers(&xml, "mpe_formDeviation"), &[1e-5], 1e-18);
    assert!(texts(&xml, "mpe_angle").is_empty());
}
