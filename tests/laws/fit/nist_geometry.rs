//! Fits against NIST's L2 reference pairs (Algorithm Testing System, 152 of 240 pairs), all from our own starts, and
//! against references of 20 digits for arcs that NIST does not cover.

#![allow(clippy::print_stdout)] // how close each fit comes is worth saying
#![allow(clippy::excessive_precision)] // digits as published

use etalon::base::message::Result;
use etalon::base::pose::{Vector, cross, dot, minus, norm};
use etalon::fit::{self, CircleMethod, Fit, FitSettings};
use std::path::Path;

/// One reference pair: points and published answer.
struct Pair {
    name: String,
    points: Vec<Vector>,
    answer: Vec<f64>,
}

fn numbers(path: &Path) -> Vec<f64> {
    let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    text.split_whitespace().map(|word| word.parse().unwrap_or_else(|_| panic!("{}: {word}", path.display()))).collect()
}

/// A 20-digit answer less `base` as two doubles would be finer than asked: 1e-13 mm at 1000 mm is enough for 1e-9.
fn pair(folder: &Path, name: &str) -> Pair {
    let data = numbers(&folder.join(format!("{name}.ds")));
    let width = (data.len() - 1) / data[0] as usize;
    assert_eq!(data.len() - 1, width * data[0] as usize, "{name}");
    assert_eq!(width, 3, "{name}");
    let points = data[1..].chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
    Pair { name: name.to_owned(), points, answer: numbers(&folder.join(format!("{name}.fit"))) }
}

fn names(folder: &Path, prefix: &str) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .filter_map(|entry| entry.unwrap().file_name().to_str()?.strip_suffix(".ds").map(str::to_owned))
        .filter(|name| name.starts_with(prefix))
        .collect();
    names.sort();
    names
}

fn vector(v: &[f64]) -> Vector {
    [v[0], v[1], v[2]]
}

/// Angle between directions whose sign is free.
fn angle_between_lines(a: Vector, b: Vector) -> f64 {
    norm(cross(a, b)).atan2(dot(a, b).abs())
}

/// Distance of `p` from the line through `q` along `d`.
fn off_line(p: Vector, q: Vector, d: Vector) -> f64 {
    norm(cross(minus(p, q), d)) / norm(d)
}

/// Errors of one fit: location in mm, size in mm, direction in rad.
#[derive(Default)]
struct Errors([f64; 3]);

impl Errors {
    fn worst(&mut self, name: &str, other: [f64; 3], limit: f64) {
        for (i, (mine, e)) in self.0.iter_mut().zip(other).enumerate() {
            assert!(e <= limit, "{name}: {} error {e:.3e}", ["location", "size", "direction"][i]);
            *mine = mine.max(e);
        }
    }
}

fn against_nist(
    element: &str,
    prefix: &str,
    count: usize,
    fit: impl Fn(&[Vector], &FitSettings) -> Result<Fit>,
    errors: impl Fn(&Fit, &[f64]) -> [f64; 3],
) {
    let Some(geom) = crate::reference_data("geom") else { return };
    let folder = geom.join("nist_ats").join(element);
    let names = names(&folder, prefix);
    assert_eq!(names.len(), count, "{element}");
    let mut worst = Errors::default();
    let mut most = 0;
    for name in names {
        let pair = pair(&folder, &name);
        let fit = fit(&pair.points, &FitSettings::default()).unwrap_or_else(|e| panic!("{name}: {e}"));
        most = most.max(fit.solver.iterations);
        worst.worst(&pair.name, errors(&fit, &pair.answer), 1e-9);
    }
    let [location, size, direction] = worst.0;
    println!(
        "{element}: {count} sets, location {location:.1e} mm, size {size:.1e} mm, direction {direction:.1e} rad, {most} iterations at most"
    );
}

#[test]
fn planes() {
    against_nist("Plane", "pla", 30, fit::plane, |fit, answer| {
        let (point, normal) = (vector(answer), vector(&answer[3..]));
        [norm(minus(fit.geometry.point_mm, point)), 0.0, angle_between_lines(fit.geometry.direction.unwrap(), normal)]
    });
}

#[test]
fn spheres() {
    against_nist("Sphere", "sph", 30, fit::sphere, |fit, answer| {
        [
            norm(minus(fit.geometry.point_mm, vector(answer))),
            (2.0 * fit.geometry.radius_mm.unwrap() - answer[3]).abs(),
            0.0,
        ]
    });
}

#[test]
fn cylinders() {
    against_nist("Cylinder", "cyl", 30, fit::cylinder, |fit, answer| {
        let (point, axis) = (vector(answer), vector(&answer[3..]));
        assert!(norm(minus(fit.geometry.point_mm, point)) < 1e-9, "the foot of the centroid");
        let direction = angle_between_lines(fit.geometry.direction.unwrap(), axis);
        [
            off_line(fit.geometry.point_mm, point, axis),
            (2.0 * fit.geometry.radius_mm.unwrap() - answer[6]).abs(),
            direction,
        ]
    });
}

#[test]
fn cones() {
    against_nist("Cone", "con", 30, fit::cone, |fit, answer| {
        let (point, axis) = (vector(answer), vector(&answer[3..]));
        let half_angle = fit.geometry.apex_angle_rad.unwrap() / 2.0;
        // NIST states the orthogonal distance from the foot of the centroid to the surface
        assert!(norm(minus(fit.geometry.point_mm, point)) < 1e-9, "the foot of the centroid");
        let size = (fit.geometry.radius_mm.unwrap() * half_angle.cos() - answer[6]).abs();
        let opening = (2.0 * half_angle - answer[7].to_radians()).abs();
        let direction =
            norm(cross(fit.geometry.direction.unwrap(), axis)).atan2(dot(fit.geometry.direction.unwrap(), axis));
        [off_line(fit.geometry.point_mm, point, axis), size, direction.max(opening)]
    });
}

/// The plane that a set of NIST's 2-D circles lies in: the axes that vary, and the one that does not.
fn coordinate_plane(normal: &[f64]) -> (usize, usize, usize) {
    let k = (0..3).find(|&k| normal[k].abs() == 1.0).unwrap();
    ((k + 1) % 3, (k + 2) % 3, k)
}

fn circle_in_its_plane(pair: &Pair) -> (Result<Fit>, [f64; 2]) {
    let (i, j, _) = coordinate_plane(&pair.answer[3..6]);
    let flat: Vec<[f64; 2]> = pair.points.iter().map(|p| [p[i], p[j]]).collect();
    (fit::circle2d(&flat, &FitSettings::default()), [pair.answer[i], pair.answer[j]])
}

#[test]
fn circles_in_the_plane() {
    let Some(geom) = crate::reference_data("geom") else { return };
    let folder = geom.join("nist_ats/Circle2d");
    let names = names(&folder, "cir2d");
    assert_eq!(names.len(), 30);
    let mut worst = Errors::default();
    for name in names {
        let pair = pair(&folder, &name);
        let (fit, centre) = circle_in_its_plane(&pair);
        let fit = fit.unwrap_or_else(|e| panic!("{name}: {e}"));
        let location = (fit.geometry.point_mm[0] - centre[0]).hypot(fit.geometry.point_mm[1] - centre[1]);
        worst.worst(&name, [location, (2.0 * fit.geometry.radius_mm.unwrap() - pair.answer[6]).abs(), 0.0], 1e-9);
    }
    println!("Circle2d: 30 sets, location {:.1e} mm, size {:.1e} mm", worst.0[0], worst.0[1]);
}

#[test]
fn circles_in_space() {
    against_nist("Circle3d", "cir", 2, fit::circle3d, |fit, answer| {
        let direction = angle_between_lines(fit.geometry.direction.unwrap(), vector(&answer[3..]));
        [
            norm(minus(fit.geometry.point_mm, vector(answer))),
            (2.0 * fit.geometry.radius_mm.unwrap() - answer[6]).abs(),
            direction,
        ]
    });
}

/// Published digits are exact, the fit is a double: on noisy short arcs the minimum is only as sharp as its curvature.
fn allowed(stated: Option<f64>) -> f64 {
    stated.map_or(1e-9, |u| (1e-3 * u).max(1e-9))
}

#[test]
fn short_arcs_in_the_plane() {
    let Some(geom) = crate::reference_data("geom") else { return };
    let folder = geom.join("derived_short_arc");
    let names = names(&folder, "circle2d");
    assert!(names.len() >= 19, "{}", names.len());
    for name in names {
        let pair = pair(&folder, &name);
        let (fit, centre) = circle_in_its_plane(&pair);
        let fit = fit.unwrap_or_else(|e| panic!("{name}: {e}"));
        let u = fit.standard_uncertainty();
        let location = (fit.geometry.point_mm[0] - centre[0]).hypot(fit.geometry.point_mm[1] - centre[1]);
        let size = (fit.geometry.radius_mm.unwrap() - pair.answer[6] / 2.0).abs();
        println!(
            "{name}: {} points, {:.0} deg, centre {location:.1e} mm, radius {size:.1e} mm of {:.6} ± {:.1e}, {} iterations, {} warnings, condition {:.1e}",
            pair.points.len(),
            fit.coverage_deg().unwrap(),
            fit.geometry.radius_mm.unwrap(),
            u.map_or(f64::NAN, |u| u.radius_mm.unwrap()),
            fit.solver.iterations,
            fit.warnings.len(),
            fit.condition
        );
        assert!(location <= allowed(u.map(|u| u.point_largest_mm)), "{name}: centre {location:.3e}");
        assert!(size <= allowed(u.and_then(|u| u.radius_mm)), "{name}: radius {size:.3e}");
    }
}

#[test]
fn short_arcs_in_space_by_both_definitions() {
    let Some(geom) = crate::reference_data("geom") else { return };
    let folder = geom.join("derived_short_arc");
    let names = names(&folder, "circle3d");
    assert!(names.len() >= 4, "{}", names.len());
    for name in names {
        let pair = pair(&folder, &name);
        let full = numbers(&folder.join(format!("{name}.odr3d.fit")));
        for (circle, answer) in [(CircleMethod::Projected, &pair.answer), (CircleMethod::Orthogonal, &full)] {
            let fit = fit::circle3d(&pair.points, &FitSettings { circle, ..FitSettings::default() }).unwrap();
            let location = norm(minus(fit.geometry.point_mm, vector(answer)));
            let direction = angle_between_lines(fit.geometry.direction.unwrap(), vector(&answer[3..]));
            let size = (fit.geometry.radius_mm.unwrap() - answer[6] / 2.0).abs();
            println!(
                "{name} {circle:?}: centre {location:.1e} mm, radius {size:.1e} mm, normal {direction:.1e} rad, {} iterations",
                fit.solver.iterations
            );
            assert!(location < 1e-9 && size < 1e-9 && direction < 1e-9, "{name} {circle:?}");
        }
    }
}

#[test]
fn lines_in_space() {
    let Some(geom) = crate::reference_data("geom") else { return };
    let folder = geom.join("derived_short_arc");
    let names = names(&folder, "line3d");
    assert!(!names.is_empty());
    for name in names {
        let pair = pair(&folder, &name);
        let fit = fit::line(&pair.points, &FitSettings::default()).unwrap();
        let (point, axis) = (vector(&pair.answer), vector(&pair.answer[3..]));
        let (off, direction) =
            (off_line(fit.geometry.point_mm, point, axis), angle_between_lines(fit.geometry.direction.unwrap(), axis));
        println!("{name}: off {off:.1e} mm, direction {direction:.1e} rad");
        assert!(off < 1e-9 && direction < 1e-9, "{name}: {off:.3e} {direction:.3e}");
    }
}

#[test]
fn what_a_person_must_know_is_said() {
    let Some(geom) = crate::reference_data("geom") else { return };
    let said = |fit: &Fit, id: &str| fit.warnings.iter().any(|w| w.is(id, &[]) && w.hint.is_some());
    // six points: two cones go through all of them, and NIST says that its answer may not be the only one
    let cone = fit::cone(&pair(&geom.join("nist_ats/Cone"), "con7").points, &FitSettings::default()).unwrap();
    assert!(said(&cone, "element-ambiguous") && said(&cone, "element-without-redundancy"), "{:?}", cone.warnings);
    assert!(cone.precision.covariance.is_none() && cone.precision.degrees_of_freedom == 0);
    // ten degrees of arc with 0.8 mm of noise on a radius of 163 mm
    let arc = circle_in_its_plane(&pair(&geom.join("derived_short_arc"), "circle2d_nist21_10deg")).0.unwrap();
    assert!(said(&arc, "radius-uncertain"), "{:?}", arc.warnings);
    // and nothing where there is nothing to say
    for (folder, name) in [("Cone", "con1"), ("Cone", "con30")] {
        let fit = fit::cone(&pair(&geom.join("nist_ats").join(folder), name).points, &FitSettings::default()).unwrap();
        assert!(fit.warnings.is_empty(), "{name}: {:?}", fit.warnings);
    }
    let fit = circle_in_its_plane(&pair(&geom.join("derived_short_arc"), "circle2d_nist22_35deg")).0.unwrap();
    assert!(fit.warnings.is_empty() && (fit.coverage_deg().unwrap() - 35.0).abs() < 1.0, "{:?}", fit.warnings);
    let cylinder =
        fit::cylinder(&pair(&geom.join("nist_ats/Cylinder"), "cyl1").points, &FitSettings::default()).unwrap();
    assert!(cylinder.warnings.is_empty(), "{:?}", cylinder.warnings);
}

#[test]
fn published_small_sets() {
    let Some(geom) = crate::reference_data("geom") else { return };
    let read = |name: &str| -> Vec<Vec<f64>> {
        let text = std::fs::read_to_string(geom.join("published_small").join(name)).unwrap();
        let row = |line: &str| line.split(',').map(|w| w.trim().parse().ok()).collect::<Option<Vec<f64>>>();
        text.lines().filter_map(row).collect()
    };
    let flat = |name: &str| read(name).iter().map(|row| [row[0], row[1]]).collect::<Vec<_>>();
    // 20-digit minima of classic circles (Gander, Golub & Strebel 1994; Coope 1993; the SciPy cookbook)
    let circles = [
        ("GGS6.csv", [4.739_782_410_906_074, 2.983_532_699_292_475_2], 4.714_226_037_792_109_7),
        ("Coope8.csv", [3.043_238_251_582_542_2, 0.745_678_313_458_604_05], 4.105_855_837_954_331_1),
        ("scipycookbook6.csv", [10.500_086_213_944_377, 9.659_949_505_836_43], 23.333_527_646_182_877),
    ];
    for (name, center, radius) in circles {
        let fit = fit::circle2d(&flat(name), &FitSettings::default()).unwrap();
        let off = (fit.geometry.point_mm[0] - center[0]).hypot(fit.geometry.point_mm[1] - center[1]);
        let size = (fit.geometry.radius_mm.unwrap() - radius).abs();
        println!("{name}: centre {off:.1e}, radius {size:.1e}");
        assert!(off < 1e-9 && size < 1e-9, "{name}: {off:e} {size:e}");
    }
    // a line of the imagingbook, A x + B y + C = 0
    let line = fit::line2d(&flat("line2d_burger5.csv"), &FitSettings::default()).unwrap();
    let (p, d) = (line.geometry.point_mm, line.geometry.direction.unwrap());
    let (a, b, c) = (-0.496_890_043_790_261_8, -0.867_813_507_835_705_2, 7.244_827_854_073_206);
    assert!((a * d[0] + b * d[1]).abs() < 1e-12 && (a * p[0] + b * p[1] + c).abs() < 1e-12, "{p:?} {d:?}");
    // the cylinder on which SciPy ended at R = 69.9 (issue 21720)
    let points: Vec<Vector> = read("scipy21720_cylinder18.csv").iter().map(|row| vector(row)).collect();
    let fit = fit::cylinder(&points, &FitSettings::default()).unwrap();
    let axis = [0.240_617_938_604_659_03, -0.874_686_150_287_861_48, 0.420_745_940_106_669_51];
    let foot = [-69.714_201_690_161_028, -265.575_359_072_883_57, -39.377_789_038_400_328];
    let errors = [
        norm(minus(fit.geometry.point_mm, foot)),
        (fit.geometry.radius_mm.unwrap() - 90.076_866_678_021_767).abs(),
        angle_between_lines(fit.geometry.direction.unwrap(), axis),
    ];
    println!("scipy 21720: {errors:?}");
    assert!(errors.iter().all(|e| *e < 1e-9), "{errors:?}");
}
