//! Smallest enclosing circles and spheres against answers of 20 digits, the inputs that broke other libraries among
//! them, and the large sets of hbf/miniball.

#![allow(clippy::print_stdout)] // how close each comes is worth saying
#![allow(clippy::excessive_precision)] // digits as published

use etalon::base::pose::{Vector, minus, norm};
use etalon::fit::{Enclosing, enclosing_circle, enclosing_sphere};
use std::path::Path;

fn numbers(path: &Path, header: usize) -> Vec<Vec<f64>> {
    let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let lines = text.lines().skip(header).filter(|line| !line.trim().is_empty() && !line.starts_with("//"));
    let split = |line: &str| {
        let words = line.split(|c: char| c == ',' || c.is_whitespace()).filter(|w| !w.is_empty());
        words.map(|w| w.parse().unwrap_or_else(|e| panic!("{w:?}: {e}"))).collect()
    };
    lines.map(split).collect()
}

fn padded(row: &[f64]) -> Vector {
    [row[0], row[1], row.get(2).copied().unwrap_or(0.0)]
}

/// Every point inside the ball as reported, to rounding; and the support on its surface.
fn encloses(name: &str, ball: &Enclosing, points: &[Vector]) {
    let size = points.iter().flatten().fold(ball.radius_mm, |m, x| m.max(x.abs()));
    for (i, &p) in points.iter().enumerate() {
        let beyond = norm(minus(p, ball.center_mm)) - ball.radius_mm;
        assert!(beyond <= 4.0 * f64::EPSILON * size, "{name}: point {i} is {beyond:e} outside");
        assert!(
            !ball.support.contains(&i) || beyond > -1e-12 * size,
            "{name}: point {i} is {beyond:e} inside: {ball:?}"
        );
    }
}

#[test]
fn circles_and_spheres_of_twenty_digits() {
    let Some(geom) = crate::reference_data("geom") else { return };
    let text = std::fs::read_to_string(geom.join("derived_minimum_circle/minimum_enclosing_reference.csv")).unwrap();
    let (mut rows, mut worst) = (0, 0.0f64);
    for line in text.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let (name, dimension) = (cells[0], cells[2].parse::<usize>().unwrap());
        let number = |i: usize| cells[i].parse::<f64>().ok();
        let nist = name.strip_prefix("nist_");
        let data = match nist {
            Some(set) if set.starts_with("cir") => numbers(&geom.join(format!("nist_ats/Circle2d/{set}.ds")), 1),
            Some(set) => numbers(&geom.join(format!("nist_ats/Sphere/{set}.ds")), 1),
            None => numbers(&geom.join(format!("derived_minimum_circle/{name}.csv")), 1),
        };
        assert_eq!(data.len(), cells[1].parse::<usize>().unwrap(), "{name}");
        let points: Vec<Vector> = data.iter().map(|row| padded(row)).collect();
        // NIST's circles lie in any coordinate plane: the axis that does not vary is left out
        let flat = (0..3).find(|&k| points.iter().all(|p| p[k] == points[0][k])).unwrap_or(2);
        let (i, j) = ([1, 0, 0][flat], [2, 2, 1][flat]);
        let (ball, center) = if dimension == 2 {
            let ball = enclosing_circle(&points.iter().map(|p| [p[i], p[j]]).collect::<Vec<_>>()).unwrap();
            let expected = if nist.is_some() { [number(4 + i), number(4 + j)] } else { [number(4), number(5)] };
            (ball, [expected[0].unwrap(), expected[1].unwrap(), 0.0])
        } else {
            let ball = enclosing_sphere(&points).unwrap();
            encloses(name, &ball, &points);
            (ball, [number(4).unwrap(), number(5).unwrap(), number(6).unwrap()])
        };
        let radius = number(7).unwrap();
        // the answer of a double cannot be finer than its coordinates: relative to the larger of radius and distance
        let size = norm(center).max(radius);
        let error = (ball.radius_mm - radius).abs().max(norm(minus(ball.center_mm, center))) / size;
        assert!(error < 1e-12, "{name}: {error:e}, support {:?}", ball.support);
        assert!(
            (ball.radius_mm / radius - 1.0).abs() < 1e-12 + 8.0 * f64::EPSILON * size / radius,
            "{name}: radius {}",
            ball.radius_mm
        );
        worst = worst.max(error);
        rows += 1;
    }
    assert_eq!(rows, 65);
    println!("enclosing circles and spheres: {rows} sets, worst relative error {worst:.1e}");
}

#[test]
fn large_and_cospherical_sets() {
    let Some(geom) = crate::reference_data("geom") else { return };
    // centre and squared radius as in hbf/miniball's tests (random_points_3 to more digits, computed with 50); the large circle's centre is exactly zero
    let sets: [(&str, Vector, f64); 5] = [
        (
            "almost_cospherical_points_3",
            [-1.560_872_013_424_903_18e-12, -4.714_460_264_529_535_92e-12, 3.675_804_723_872_446_65e-12],
            1.000_000_000_150_685_69,
        ),
        ("cocircular_points_large_radius_2", [0.0; 3], 1.128_305_502_495_112_83e18),
        ("cocircular_points_small_radius_2", [0.0; 3], 3.728_702_916_375_125e15),
        (
            "longitude_latitude_model_3",
            [1.095_296_437_051_281_93e-12, 7.764_871_341_282_957_63e-12, 2.097_824_851_521_827_32e-16],
            1.000_000_000_158_332_01,
        ),
        (
            "random_points_3",
            [0.016_109_310_303_442_159_6, -0.003_394_037_999_126_822_72, -0.003_313_784_124_079_350_45],
            0.686_700_124_388_323_403,
        ),
    ];
    for (name, center, squared) in sets {
        let points: Vec<Vector> =
            numbers(&geom.join(format!("miniball/{name}.data")), 1).iter().map(|row| padded(row)).collect();
        let start = std::time::Instant::now();
        let ball = if name.ends_with('2') {
            enclosing_circle(&points.iter().map(|p| [p[0], p[1]]).collect::<Vec<_>>()).unwrap()
        } else {
            enclosing_sphere(&points).unwrap()
        };
        let took = start.elapsed();
        encloses(name, &ball, &points);
        let radius = squared.sqrt();
        let errors = (norm(minus(ball.center_mm, center)) / radius, (ball.radius_mm / radius - 1.0).abs());
        println!(
            "{name}: {} points, centre {:.1e}, radius {:.1e} relative, {} steps, {took:?}",
            points.len(),
            errors.0,
            errors.1,
            ball.iterations
        );
        assert!(errors.0 < 1e-12 && errors.1 < 1e-12, "{name}: {errors:?}");
    }
}
