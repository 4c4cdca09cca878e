//! Probe compensation: centres of a ball that touches an element give back what it touched.

#![allow(non_snake_case)] // frames in names

use etalon::base::pose::{Pose, Vector, cross, dot, minus, norm};
use etalon::fit::{self, CircleMethod, Element, Fit, FitSettings, Probe, Side};

const PROBE_MM: f64 = 2.5;
const HALF_ANGLE_RAD: f64 = 0.3;

/// Where a ball of radius `lift` (outwards; negative: within) touches an element of radius 40 about z, and its centre.
fn touches(element: Element, lift: f64) -> Vec<Vector> {
    let mut centres = Vec::new();
    for i in 0..12 {
        for j in 0..5 {
            let (angle, step) = (2.5 * f64::from(i) / 12.0, f64::from(j) - 1.7);
            let (sin, cos) = angle.sin_cos();
            // the point that is touched and its outward normal, in the half plane (out, z) at this angle
            let (rise, out) = (0.5 * step).sin_cos();
            let (slant, upright) = HALF_ANGLE_RAD.sin_cos();
            let around = (1.3 * step + 0.1 * f64::from(i)).sin_cos();
            let ([r, z], [nr, nz]) = match element {
                Element::Sphere => ([40.0 * out, 40.0 * rise], [out, rise]),
                Element::Cylinder => ([40.0, 12.0 * step], [1.0, 0.0]),
                Element::Cone => ([40.0 + 12.0 * step * slant / upright, 12.0 * step], [upright, -slant]),
                Element::Torus => ([40.0 + 9.0 * around.1, 9.0 * around.0], [around.1, around.0]),
                Element::Circle2d | Element::Circle3d => ([40.0, 0.0], [1.0, 0.0]),
                Element::Plane => {
                    centres.push([5.0 * f64::from(i), 7.0 * step, lift]);
                    continue;
                }
                Element::Line | Element::Line2d => {
                    centres.push([3.0 * f64::from(i) + 0.4 * step, lift, 0.0]);
                    continue;
                }
            };
            let (r, z) = (r + lift * nr, z + lift * nz);
            centres.push([r * cos, r * sin, z]);
        }
    }
    centres
}

fn sides(element: Element) -> [(Side, f64); 2] {
    match element {
        Element::Plane => [(Side::Towards([1.0, 1.0, 3.0]), PROBE_MM), (Side::Towards([1.0, 1.0, -3.0]), -PROBE_MM)],
        Element::Line | Element::Line2d => {
            [(Side::Towards([1.0, 3.0, 0.0]), PROBE_MM), (Side::Towards([1.0, -3.0, 0.0]), -PROBE_MM)]
        }
        _ => [(Side::Outside, PROBE_MM), (Side::Inside, -PROBE_MM)],
    }
}

fn probed(element: Element, points: &[Vector], side: Side) -> Fit {
    let settings = FitSettings { probe: Some(Probe { radius_mm: PROBE_MM, side }), ..FitSettings::default() };
    fit::element(element, points, &settings).unwrap_or_else(|e| panic!("{element} {side:?}: {e}"))
}

#[test]
fn centres_on_the_parallel_surface_give_the_surface_from_both_sides() {
    let moved_T_here = Pose::from_xyz_rpy([31.0, -87.0, 9.5], [0.7, -1.1, 2.4]);
    for element in Element::ALL {
        let flat = matches!(element, Element::Line2d | Element::Circle2d);
        let place = if flat { Pose::identity() } else { moved_T_here };
        for (side, lift) in sides(element) {
            let points: Vec<Vector> = touches(element, lift).into_iter().map(|p| place.apply(p)).collect();
            let turned = match side {
                Side::Towards(d) => Side::Towards(place.rotate(d)),
                side => side,
            };
            let fit = probed(element, &points, turned);
            let close = |what: &str, error: f64, size: f64| {
                assert!(error.abs() <= 1e-12 * size, "{element} {side:?}: {what} is off by {error:e}");
            };
            let p = place.inverse().apply(fit.geometry.point_mm);
            let d = fit.geometry.direction.map(|d| place.inverse().rotate(d)).unwrap_or_default();
            match element {
                Element::Plane => close("height", p[2], 100.0),
                Element::Line | Element::Line2d => close("place", norm([0.0, p[1], p[2]]), 100.0),
                Element::Cone => {
                    let apex = place.inverse().apply(fit.geometry.apex_mm().unwrap());
                    let truth = [0.0, 0.0, -40.0 / HALF_ANGLE_RAD.tan()];
                    close("apex", norm(minus(apex, truth)), 1000.0);
                    close("apex angle", fit.geometry.apex_angle_rad.unwrap() - 2.0 * HALF_ANGLE_RAD, 1.0);
                    // the radius is that of the section at the stated point
                    let section = 40.0 + p[2] * HALF_ANGLE_RAD.tan();
                    close("radius", fit.geometry.radius_mm.unwrap() - section, 100.0);
                    close("axis", norm(cross(d, [0.0, 0.0, 1.0])), 1.0);
                }
                Element::Torus => {
                    close("centre", norm(p), 100.0);
                    close("radius", fit.geometry.radius_mm.unwrap() - 40.0, 40.0);
                    close("minor radius", fit.geometry.minor_radius_mm.unwrap() - 9.0, 40.0);
                }
                _ => {
                    let off = if element == Element::Cylinder { cross(p, d) } else { p };
                    close("place", norm(off), 100.0);
                    close("radius", fit.geometry.radius_mm.unwrap() - 40.0, 40.0);
                }
            }
            for touched in touches(element, 0.0) {
                close("a touched point", fit.residual_mm(place.apply(touched)), 100.0);
            }
            let before = fit.compensation.unwrap();
            let raw = fit::element(element, &points, &FitSettings::default()).unwrap();
            assert_eq!(
                (before.point_mm, before.radius_mm),
                (raw.geometry.point_mm, raw.geometry.radius_mm),
                "{element}"
            );
            assert_eq!(fit.residuals, raw.residuals, "{element}: no point is moved");
        }
    }
}

#[test]
fn the_held_radius_is_that_of_what_was_touched() {
    for element in [Element::Circle2d, Element::Circle3d, Element::Sphere, Element::Cylinder] {
        for circle in [CircleMethod::Projected, CircleMethod::Orthogonal] {
            for (side, lift) in sides(element) {
                let probe = Some(Probe { radius_mm: PROBE_MM, side });
                let settings = FitSettings { radius_mm: Some(40.0), probe, circle, ..FitSettings::default() };
                let fit = fit::element(element, &touches(element, lift), &settings).unwrap();
                assert!((fit.geometry.radius_mm.unwrap() - 40.0).abs() < 1e-13, "{element} {side:?}");
                assert!(fit.max_mm() < 1e-12, "{element} {side:?}: {:e}", fit.max_mm());
            }
        }
    }
}

#[test]
fn a_wrong_side_and_a_probe_that_does_not_fit_are_refused_with_a_hint() {
    let refused = |element: Element, radius_mm: f64, side: Side, held: Option<f64>, id: &str| {
        let probe = Some(Probe { radius_mm, side });
        let settings = FitSettings { probe, radius_mm: held, ..FitSettings::default() };
        let message = fit::element(element, &touches(element, 0.0), &settings).unwrap_err();
        assert!(message.0[0].is(id, &[]) && message.0[0].hint.is_some(), "{element} {side:?}: {message}");
    };
    let up = Side::Towards([0.0, 0.0, 1.0]);
    for element in Element::ALL {
        let straight = matches!(element, Element::Plane | Element::Line | Element::Line2d);
        let (right, wrong) = if straight { (up, Side::Inside) } else { (Side::Inside, up) };
        refused(
            element,
            2.0,
            wrong,
            None,
            if straight { "probe-side-needs-direction" } else { "probe-side-needs-inside" },
        );
        for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            refused(element, radius, right, None, "probe-radius-not-positive");
        }
        match element {
            Element::Plane => {
                refused(element, 2.0, Side::Towards([1.0, 2.0, 1e-3]), None, "probe-direction-along-element")
            }
            Element::Line | Element::Line2d => {
                refused(element, 2.0, Side::Towards([1.0, 1e-3, 0.0]), None, "probe-direction-along-element")
            }
            _ => refused(element, 1e3, Side::Outside, None, "probe-larger-than-element"),
        }
        if straight {
            refused(element, 2.0, Side::Towards([0.0; 3]), None, "probe-direction-zero");
            refused(element, 2.0, Side::Towards([f64::NAN, 0.0, 1.0]), None, "probe-direction-zero");
        }
    }
    refused(Element::Sphere, 50.0, Side::Inside, Some(40.0), "held-radius-below-probe");
    let fit = probed(Element::Sphere, &touches(Element::Sphere, PROBE_MM), Side::Outside);
    assert!(fit.compensated(Some(Probe { radius_mm: 1.0, side: Side::Inside })).is_err(), "never twice");
}

#[test]
fn the_directions_of_plane_and_line_say_the_side_whichever_way_the_element_points() {
    for element in [Element::Plane, Element::Line, Element::Line2d] {
        for (side, lift) in sides(element) {
            let mut points = touches(element, lift);
            let one = probed(element, &points, side);
            points.reverse();
            let other = probed(element, &points, side);
            assert!(norm(minus(one.geometry.point_mm, other.geometry.point_mm)) < 1e-12, "{element}");
            let touched = minus(one.compensation.unwrap().point_mm, one.geometry.point_mm);
            let Side::Towards(to) = side else { panic!("{element} has directions") };
            assert!((norm(touched) - PROBE_MM).abs() < 1e-13 && dot(touched, to) > 0.0, "{element}: {touched:?}");
        }
    }
}
