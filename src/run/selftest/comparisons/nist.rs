//! Reference data of NIST (Algorithm Testing System): fitted elements, where `ETALON_REFERENCE` has
//! the data.

use crate::run::selftest::row::{Rows, requirement_result};
use etalon_base::pose::{Vector, cross, dot, minus, norm};
use etalon_base::{files, phrase};
use etalon_documents::SelftestRequirement;
use etalon_fit::{Element, Fit, FitSettings, element};
use std::path::{Path, PathBuf};

/// Comparisons with NIST's data; `None` without them.
pub(crate) fn requirement() -> Option<SelftestRequirement> {
    let folder = PathBuf::from(std::env::var_os("ETALON_REFERENCE")?).join("geom/nist_ats");
    if !folder.is_dir() {
        return None;
    }
    let mut rows = Rows::new("NIST ATS");
    for (name, prefix, kind, errors) in ELEMENTS {
        compare_element(&folder.join(name), prefix, kind, errors, &mut rows);
    }
    Some(requirement_result("nist", phrase!("selftest-nist"), vec![rows]))
}

/// Errors of a fit against the published answer (mm, rad).
type Errors = fn(&Fit, &[f64]) -> f64;

// circles of the folder Circle2d lie in planes of any axis: they are fitted in space
const ELEMENTS: [(&str, &str, Element, Errors); 6] = [
    ("Circle2d", "cir2d", Element::Circle3d, circle),
    ("Circle3d", "cir", Element::Circle3d, circle),
    ("Plane", "pla", Element::Plane, plane),
    ("Sphere", "sph", Element::Sphere, sphere),
    ("Cylinder", "cyl", Element::Cylinder, cylinder),
    ("Cone", "con", Element::Cone, cone),
];

fn compare_element(folder: &Path, prefix: &str, kind: Element, errors: Errors, rows: &mut Rows) {
    let found = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let wanted = |path: &PathBuf| {
        path.extension().is_some_and(|e| e == "ds")
            && path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(prefix))
    };
    let (mut count, mut worst) = (0usize, 0.0f64);
    for path in found.filter(wanted) {
        let answer = numbers(&path.with_extension("fit"));
        let points = numbers(&path);
        let points: Vec<Vector> =
            points.get(1..).unwrap_or_default().chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
        let fit = element(kind, &points, &FitSettings::default()).ok().filter(|_| answer.len() >= 4);
        let error = fit.map_or(f64::INFINITY, |fit| errors(&fit, &answer));
        count += 1;
        worst = if error.is_nan() { f64::INFINITY } else { worst.max(error) };
    }
    if count > 0 {
        rows.add(phrase!("selftest-nist-sets", name = kind.name(), count), "mm, rad", [0.0, worst], 1e-9);
    }
}

fn numbers(path: &Path) -> Vec<f64> {
    let text = files::read_text(path).unwrap_or_default();
    text.split_whitespace().map(|word| word.parse().unwrap_or(f64::NAN)).collect()
}

fn vector(v: &[f64]) -> Vector {
    [v[0], v[1], v[2]]
}

/// Angle between directions whose sign is free.
fn angle(a: Vector, b: Vector) -> f64 {
    norm(cross(a, b)).atan2(dot(a, b).abs())
}

fn plane(fit: &Fit, answer: &[f64]) -> f64 {
    let normal = fit.geometry.direction.filter(|_| answer.len() >= 6);
    normal.map_or(f64::INFINITY, |n| {
        norm(minus(fit.geometry.point_mm, vector(answer))).max(angle(n, vector(&answer[3..])))
    })
}

fn sphere(fit: &Fit, answer: &[f64]) -> f64 {
    let diameter = fit.geometry.radius_mm.map_or(f64::INFINITY, |r| (2.0 * r - answer[3]).abs());
    norm(minus(fit.geometry.point_mm, vector(answer))).max(diameter)
}

fn cylinder(fit: &Fit, answer: &[f64]) -> f64 {
    let (Some(axis), Some(radius), true) = (fit.geometry.direction, fit.geometry.radius_mm, answer.len() >= 7) else {
        return f64::INFINITY;
    };
    let (point, direction) = (vector(answer), vector(&answer[3..]));
    let beside = norm(cross(minus(fit.geometry.point_mm, point), direction)) / norm(direction);
    beside.max((2.0 * radius - answer[6]).abs()).max(angle(axis, direction))
}

fn circle(fit: &Fit, answer: &[f64]) -> f64 {
    let (Some(normal), Some(radius), true) = (fit.geometry.direction, fit.geometry.radius_mm, answer.len() >= 7) else {
        return f64::INFINITY;
    };
    let centre = norm(minus(fit.geometry.point_mm, vector(answer)));
    centre.max((2.0 * radius - answer[6]).abs()).max(angle(normal, vector(&answer[3..])))
}

/// NIST gives the orthogonal distance from a point of the axis to the surface, and the full apex
/// angle in degrees.
fn cone(fit: &Fit, answer: &[f64]) -> f64 {
    let (Some(axis), Some(apex), Some(opening), true) =
        (fit.geometry.direction, fit.geometry.apex_mm(), fit.geometry.apex_angle_rad, answer.len() >= 8)
    else {
        return f64::INFINITY;
    };
    let (point, direction) = (vector(answer), vector(&answer[3..]));
    let from_apex = minus(point, apex);
    let beside = norm(cross(from_apex, axis));
    let distance = (norm(from_apex) * (opening / 2.0).sin() - answer[6]).abs();
    beside.max(distance).max(angle(axis, direction)).max((opening - answer[7].to_radians()).abs())
}
