//! Geometric elements: least squares of noisy points against an independent program with 60 digits
//! (`tests/selftest/make.py`), minimum zones and smallest circles by hand.

use crate::run::selftest::data::{Data, Slip};
use crate::run::selftest::row::{Rows, Subject, not_made};
use etalon_base::phrase;
use etalon_base::pose::dot;
use etalon_fit::{CircleMethod, Element, FitSettings, element, enclosing_circle, enclosing_sphere, minimum_zone};

pub(crate) const SUBJECT: Subject = Subject {
    id: "fits",
    requirement: || phrase!("selftest-fits"),
    rows,
    slips: &[
        Slip::Digit("/fits/4/sizes/0", 9),
        Slip::Swap("/fits/5/points_mm/0/0", "/fits/5/points_mm/0/1"),
        Slip::Unit("/fits/1/points_mm", 1.0 / 25.4),
    ],
};

/// Permissible deviation of a length (mm) or direction.
const LENGTH: f64 = 1e-9;
/// Permissible relative deviation of an uncertainty.
const UNCERTAINTY: f64 = 1e-6;

fn rows(data: &Data) -> Vec<Rows> {
    let mut rows = Rows::new("tests/selftest/make.py");
    for item in data.at("/fits").items() {
        least_squares(&item, &mut rows);
    }
    vec![rows, by_hand()]
}

fn least_squares(item: &Data, rows: &mut Rows) {
    let name = item.text("/element");
    let points = item.points("/points_mm");
    let settings = FitSettings { circle: CircleMethod::Orthogonal, ..FitSettings::default() };
    let fit = match name.parse::<Element>().and_then(|kind| element(kind, &points, &settings)) {
        Ok(fit) => fit,
        Err(problems) => return rows.failed(not_made(name, &problems)),
    };
    rows.add_all(
        phrase!("selftest-fit-point", name),
        "mm",
        [&item.numbers("/point_mm"), &fit.geometry.point_mm],
        LENGTH,
    );
    if let (Some(found), &[x, y, z]) = (fit.geometry.direction, &item.numbers("/direction")[..]) {
        let sign = dot(found, [x, y, z]).signum();
        rows.add_all(phrase!("selftest-fit-direction", name), "", [&[x, y, z], &found.map(|v| sign * v)], LENGTH);
    }
    let sizes: Vec<f64> = [fit.geometry.radius_mm, fit.geometry.minor_radius_mm, fit.geometry.apex_angle_rad]
        .into_iter()
        .flatten()
        .collect();
    if !sizes.is_empty() {
        rows.add_all(phrase!("selftest-fit-size", name), "mm, rad", [&item.numbers("/sizes"), &sizes], LENGTH);
    }
    let squares = [item.number("/squares_mm2"), fit.residuals.squares];
    rows.add(phrase!("selftest-fit-squares", name), "mm²", squares, 1e-9 * squares[0]);
    let u = item.number("/radius_uncertainty_mm");
    if u.is_finite() {
        let found = fit.standard_uncertainty().and_then(|u| u.radius_mm).unwrap_or(f64::NAN);
        rows.add(phrase!("selftest-fit-uncertainty", name), "mm", [u, found], UNCERTAINTY * u);
    }
}

/// Zones and enclosing balls that need no program.
fn by_hand() -> Rows {
    let mut rows = Rows::new("geometry");
    // corners of a square on two levels: the zone is a plane across the diagonal of the levels
    let plane = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.1], [10.0, 10.0, 0.0], [0.0, 10.0, 0.1]];
    let form = minimum_zone(Element::Plane, &plane).map_or(f64::NAN, |zone| zone.form_mm);
    rows.add(phrase!("selftest-zone", name = "plane"), "mm", [0.1, form], 1e-12);
    // four points at radius 10 and four at 10.2, alternating
    let at = |i: i32, radius: f64| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::FRAC_PI_4).sin_cos();
        [3.0 + radius * cos, -2.0 + radius * sin, 0.0]
    };
    let circle: Vec<_> = (0..8).map(|i| at(i, if i % 2 == 0 { 10.0 } else { 10.2 })).collect();
    let zone = minimum_zone(Element::Circle2d, &circle)
        .map_or([f64::NAN; 2], |z| [z.form_mm, z.geometry.radius_mm.unwrap_or(0.0)]);
    rows.add_all(phrase!("selftest-zone", name = "circle2d"), "mm", [&[0.2, 10.1], &zone], 1e-10);
    // a right triangle: the circle over its longest side
    let triangle = [[0.0, 0.0], [30.0, 0.0], [0.0, 40.0], [10.0, 10.0]];
    let radius = enclosing_circle(&triangle).map_or(f64::NAN, |ball| ball.radius_mm);
    rows.add(phrase!("selftest-enclosing", name = "circle2d"), "mm", [25.0, radius], 1e-12);
    let cube: Vec<_> = (0..8).map(|i| [0, 1, 2].map(|k| f64::from(i >> k & 1) * 20.0)).collect();
    let radius = enclosing_sphere(&cube).map_or(f64::NAN, |ball| ball.radius_mm);
    rows.add(phrase!("selftest-enclosing", name = "sphere"), "mm", [10.0 * 3f64.sqrt(), radius], 1e-12);
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Swaps the name of the plane for another text.
    #[test]
    fn an_unknown_element_is_compared_with_none() {
        let slip = Slip::Swap("/fits/1/element", "/kinematics/0/model");
        let rows = rows(&slip.applied(&Data::embedded().unwrap()));
        let failed: Vec<_> = rows.iter().flat_map(|rows| &rows.all).filter(|row| !row.passes()).collect();
        assert!(failed.len() == 1 && failed[0].test.id == "selftest-not-made", "{failed:?}");
    }
}
