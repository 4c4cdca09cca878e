//! Every covariance that a fit states is what 10,000 repeated measurements show, entry by entry.

use crate::fit::fits::{disturbed, points_on, quantities};
use etalon::base::pose::{Pose, Vector, centroid, dot, minus};
use etalon::fit::{self, CircleMethod, Element, Fit, FitSettings, Probe, Side};
use rayon::prelude::*;

const TRIALS: u64 = 10_000;
const N: usize = fit::QUANTITIES;
type Matrix = [[f64; N]; N];
type Drawn = ([f64; N], Matrix);

/// 5 % of what the two quantities vary; what is stated as fixed does not vary.
fn is_what_repetition_shows(element: Element, settings: FitSettings) {
    // a turned frame, so that no component is zero by luck; noise small against the size: to first order
    let turned = Pose::from_xyz_rpy([30.0, -20.0, 10.0], [0.4, 0.8, -0.5]);
    let flat = matches!(element, Element::Line2d | Element::Circle2d);
    let place = |p: Vector| if flat { p } else { turned.apply(p) };
    let points: Vec<Vector> = points_on(element, 2.5).into_iter().map(place).collect();
    let truth = fit::element(element, &points, &settings).unwrap();
    let middle = centroid(&points).unwrap();
    let trial = |trial: u64| {
        let points = disturbed(&points, 1e-3, trial);
        let fit = fit::element(element, &points, &settings).unwrap();
        let fit = slid(fit, minus(middle, centroid(&points).unwrap()));
        error_and_covariance(&fit, &truth)
    };
    // the sum is taken in order, so that it has the same bytes on any number of threads
    let all: Vec<Drawn> = (0..TRIALS).into_par_iter().map(trial).collect();
    let mean = |value: &dyn Fn(&Drawn) -> f64| all.iter().map(value).sum::<f64>() / TRIALS as f64;
    let stated = |i: usize, j: usize| mean(&|(_, c)| c[i][j]);
    for i in 0..N {
        for j in 0..=i {
            let size = (stated(i, i) * stated(j, j)).sqrt();
            let (shown, stated) = (mean(&|(e, _)| e[i] * e[j]), stated(i, j));
            let error = (shown - stated).abs();
            assert!(
                error <= 0.05 * size + 1e-15,
                "{element} {settings:?} [{i}][{j}]: shown {shown:e}, stated {stated:e}"
            );
        }
    }
    assert!((0..3).map(|i| stated(i, i)).sum::<f64>() > 0.0, "{element}: something must be uncertain");
}

/// The same element stated at the centroid of the true points: its point moved along the element by `by`.
fn slid(mut fit: Fit, by: Vector) -> Fit {
    let Some(d) = fit.geometry.direction else { return fit };
    let along = dot(by, d);
    match fit.element {
        Element::Plane => (0..3).for_each(|k| fit.geometry.point_mm[k] += by[k] - along * d[k]),
        Element::Line | Element::Line2d | Element::Cylinder | Element::Cone => {
            (0..3).for_each(|k| fit.geometry.point_mm[k] += along * d[k]);
            let widening = fit.geometry.apex_angle_rad.map_or(0.0, |angle| (angle / 2.0).tan());
            fit.geometry.radius_mm = fit.geometry.radius_mm.map(|r| r + along * widening);
        }
        _ => {}
    }
    fit
}

/// How far a fit is from the truth, and the covariance that it states; noise may turn a free sign, which is no error.
fn error_and_covariance(fit: &Fit, truth: &Fit) -> Drawn {
    let turned = dot(fit.geometry.direction.unwrap_or_default(), truth.geometry.direction.unwrap_or_default()) < 0.0;
    let sign = |i: usize| if turned && (3..6).contains(&i) { -1.0 } else { 1.0 };
    let (q, q0, c) = (quantities(fit), quantities(truth), fit.precision.covariance.unwrap().0);
    let error = std::array::from_fn(|i| sign(i) * q[i] - q0[i]);
    (error, std::array::from_fn(|i| std::array::from_fn(|j| sign(i) * sign(j) * c[i][j])))
}

fn by_probe(side: Side) -> FitSettings<'static> {
    FitSettings { probe: Some(Probe { radius_mm: 8.0, side }), ..FitSettings::default() }
}

#[test]
fn of_straight_elements_with_and_without_a_probe() {
    for element in [Element::Line2d, Element::Line, Element::Plane] {
        is_what_repetition_shows(element, FitSettings::default());
        is_what_repetition_shows(element, by_probe(Side::Towards([1.0, 2.0, 3.0])));
    }
}

#[test]
fn of_circles_and_spheres() {
    for element in [Element::Circle2d, Element::Circle3d, Element::Sphere] {
        is_what_repetition_shows(element, FitSettings::default());
    }
    is_what_repetition_shows(
        Element::Circle3d,
        FitSettings { circle: CircleMethod::Orthogonal, ..FitSettings::default() },
    );
}

#[test]
fn of_a_cylinder() {
    is_what_repetition_shows(Element::Cylinder, FitSettings::default());
}

#[test]
fn of_a_cone() {
    is_what_repetition_shows(Element::Cone, FitSettings::default());
}

#[test]
fn of_a_cone_by_a_probe() {
    is_what_repetition_shows(Element::Cone, by_probe(Side::Inside));
}

#[test]
#[ignore = "a long law: make laws"]
fn of_a_torus() {
    is_what_repetition_shows(Element::Torus, FitSettings::default());
}
