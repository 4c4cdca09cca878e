//! Fits: a rigid motion of the points moves the answer, exact points give the truth, and no start ends beside it.

#![allow(non_snake_case)] // frames in names

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, cross, dot, minus, norm};
use etalon::fit::{self, CircleMethod, Element, Fit, FitSettings};
use std::f64::consts::PI;

/// Points on an element about z through the origin, seen over `turn_rad`, and its true sizes.
pub(super) fn points_on(element: Element, turn_rad: f64) -> Vec<Vector> {
    let mut points = Vec::new();
    for i in 0..12 {
        for j in 0..5 {
            let (angle, step) = (turn_rad * f64::from(i) / 12.0, f64::from(j) - 1.7);
            let (sin, cos) = angle.sin_cos();
            let ring = |radius: f64, z: f64| [radius * cos, radius * sin, z];
            points.push(match element {
                Element::Plane => [5.0 * f64::from(i), 7.0 * step, 0.0],
                Element::Line => [0.0, 0.0, 3.0 * f64::from(i) + 0.4 * step],
                Element::Line2d => [3.0 * f64::from(i) + 0.4 * step, 0.0, 0.0],
                Element::Circle2d | Element::Circle3d => {
                    let (sin, cos) = (angle + 0.02 * step).sin_cos();
                    [40.0 * cos, 40.0 * sin, 0.0]
                }
                Element::Sphere => {
                    let (rise, out) = (0.5 * step).sin_cos();
                    ring(40.0 * out, 40.0 * rise)
                }
                Element::Cylinder => ring(40.0, 12.0 * step),
                Element::Cone => ring(40.0 + 12.0 * step * 0.3f64.tan(), 12.0 * step),
                Element::Torus => {
                    let (rise, out) = (1.3 * step + 0.1 * f64::from(i)).sin_cos();
                    ring(40.0 + 9.0 * out, 9.0 * rise)
                }
            });
        }
    }
    points
}

pub(super) fn disturbed(points: &[Vector], sigma: f64, trial: u64) -> Vec<Vector> {
    let mut noise = Noise::new(20_261_121, trial);
    points.iter().map(|p| p.map(|x| x + noise.gaussian(sigma))).collect()
}

fn in_space() -> impl Iterator<Item = Element> {
    Element::ALL.into_iter().filter(|e| !matches!(e, Element::Line2d | Element::Circle2d))
}

fn fitted(element: Element, points: &[Vector]) -> Fit {
    fit::element(element, points, &FitSettings::default()).unwrap_or_else(|e| panic!("{element}: {e}"))
}

/// The quantities in the order of a covariance.
pub(super) fn quantities(fit: &Fit) -> [f64; fit::QUANTITIES] {
    let (p, d) = (fit.geometry.point_mm, fit.geometry.direction.unwrap_or_default());
    let [r, s, a] = [fit.geometry.radius_mm, fit.geometry.minor_radius_mm, fit.geometry.apex_angle_rad]
        .map(Option::unwrap_or_default);
    [p[0], p[1], p[2], d[0], d[1], d[2], r, s, a]
}

#[test]
fn exact_points_give_the_truth_on_whole_and_partial_turns() {
    for element in Element::ALL {
        for turn_deg in [360.0f64, 180.0, 90.0, 60.0] {
            let points = points_on(element, turn_deg.to_radians());
            let fit = fitted(element, &points);
            assert!(fit.max_mm() < 1e-12, "{element} over {turn_deg}: {:e}", fit.max_mm());
            let close = |what: &str, got: Option<f64>, truth: f64| {
                let error = (got.unwrap() - truth).abs();
                assert!(error < 1e-10, "{element} over {turn_deg}: {what} is off by {error:e}");
            };
            match element {
                Element::Circle2d | Element::Circle3d | Element::Sphere | Element::Cylinder | Element::Torus => {
                    close("radius", fit.geometry.radius_mm, 40.0);
                }
                Element::Cone => close("apex angle", fit.geometry.apex_angle_rad, 0.6),
                _ => {}
            }
            if element == Element::Torus {
                close("minor radius", fit.geometry.minor_radius_mm, 9.0);
            }
            if matches!(element, Element::Circle3d | Element::Sphere | Element::Torus | Element::Circle2d) {
                close("centre", Some(norm(fit.geometry.point_mm)), 0.0);
            }
            if matches!(element, Element::Cone) {
                let apex = fit.geometry.apex_mm().unwrap();
                close("apex", Some(norm(minus(apex, [0.0, 0.0, -40.0 / 0.3f64.tan()]))), 0.0);
            }
        }
    }
}

#[test]
fn a_rigid_motion_of_the_points_moves_the_fit() {
    let moved_T_here = Pose::from_xyz_rpy([310.0, -870.0, 95.0], [0.7, -1.1, 2.4]);
    for element in in_space() {
        let points = disturbed(&points_on(element, 2.0), 0.01, 1);
        let elsewhere: Vec<Vector> = points.iter().map(|&p| moved_T_here.apply(p)).collect();
        let (here, there) = (fitted(element, &points), fitted(element, &elsewhere));
        let off = norm(minus(moved_T_here.apply(here.geometry.point_mm), there.geometry.point_mm));
        assert!(off < 1e-9, "{element}: the point is off by {off:e}");
        if let (Some(d), Some(e)) = (here.geometry.direction, there.geometry.direction) {
            let d = moved_T_here.rotate(d);
            let angle = norm(cross(d, e)).atan2(if element == Element::Cone { dot(d, e) } else { dot(d, e).abs() });
            assert!(angle < 1e-10, "{element}: the direction is off by {angle:e}");
        }
        for (a, b) in quantities(&here)[6..].iter().zip(&quantities(&there)[6..]) {
            assert!((a - b).abs() < 1e-9, "{element}: a size is off by {:e}", a - b);
        }
        let (u, v) = (here.standard_uncertainty().unwrap(), there.standard_uncertainty().unwrap());
        assert!((u.point_largest_mm / v.point_largest_mm - 1.0).abs() < 1e-6, "{element}: uncertainty of the point");
        if let (Some(u), Some(v)) = (u.direction_rad, v.direction_rad) {
            assert!((u / v - 1.0).abs() < 1e-6, "{element}: uncertainty of the direction");
        }
    }
}

#[test]
fn many_points_answer_like_few_and_with_the_same_bytes_on_any_number_of_threads() {
    for element in Element::ALL {
        let few = disturbed(&points_on(element, 2.5), 1e-3, 3);
        // more than two blocks of points, and a rest that fills no group
        let many: Vec<Vector> = few.iter().cycle().take(171 * few.len()).copied().collect();
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| fitted(element, &many))
        };
        let (here, there) = (on(1), fitted(element, &few));
        assert_eq!(here, on(3), "{element}");
        for (a, b) in quantities(&here).iter().zip(quantities(&there)) {
            assert!((a - b).abs() < 1e-11, "{element}: {a} {b}");
        }
        let (residuals, others) = (here.residuals, there.residuals);
        assert!((residuals.rms - others.rms).abs() < 1e-12 && (residuals.least - others.least).abs() < 1e-11);
        assert!((here.coverage_rad.unwrap_or(0.0) - there.coverage_rad.unwrap_or(0.0)).abs() < 1e-11, "{element}");
        // what is streamed is what each point is asked for
        let squares: f64 = few.iter().map(|&p| there.residual_mm(p).powi(2)).sum();
        let largest = few.iter().map(|&p| there.residual_mm(p)).fold(f64::NEG_INFINITY, f64::max);
        assert!(((squares / few.len() as f64).sqrt() - others.rms).abs() < 1e-12, "{element}");
        assert!((largest - others.most).abs() < 1e-12, "{element}: {largest} {}", others.most);
    }
}

#[test]
fn weights_count_like_repeated_points_and_held_values_stay() {
    for element in Element::ALL {
        let points = disturbed(&points_on(element, 2.0), 0.01, 4);
        let weights: Vec<f64> = (0..points.len()).map(|i| if i % 3 == 0 { 2.0 } else { 1.0 }).collect();
        let twice: Vec<Vector> =
            points.iter().zip(&weights).flat_map(|(p, w)| std::iter::repeat_n(*p, *w as usize)).collect();
        let weighted =
            fit::element(element, &points, &FitSettings { weights: Some(&weights), ..FitSettings::default() }).unwrap();
        let (a, b) = (quantities(&weighted), quantities(&fitted(element, &twice)));
        for (i, (a, b)) in a.iter().zip(&b).enumerate() {
            assert!((a - b).abs() < 1e-9, "{element} quantity {i}: {a} {b}");
        }
    }
    for element in [Element::Circle2d, Element::Circle3d, Element::Sphere, Element::Cylinder] {
        let points = disturbed(&points_on(element, 1.0), 0.01, 5);
        let settings = FitSettings { radius_mm: Some(40.0), ..FitSettings::default() };
        let held = fit::element(element, &points, &settings).unwrap();
        let free = fitted(element, &points);
        assert!((held.geometry.radius_mm.unwrap() - 40.0).abs() < 1e-13, "{element}");
        let (u, v) = (held.standard_uncertainty().unwrap(), free.standard_uncertainty().unwrap());
        assert!(u.radius_mm == Some(0.0) && u.point_largest_mm < v.point_largest_mm, "{element}: {u:?} {v:?}");
    }
    for element in [Element::Plane, Element::Line, Element::Circle3d, Element::Cylinder, Element::Cone, Element::Torus]
    {
        let points = disturbed(&points_on(element, 1.0), 0.01, 6);
        let settings = FitSettings { axis: Some([0.0, 0.0, 2.0]), ..FitSettings::default() };
        let held = fit::element(element, &points, &settings).unwrap();
        assert_eq!(held.geometry.direction.map(|d| d.map(f64::abs)), Some([0.0, 0.0, 1.0]), "{element}");
        assert_eq!(held.standard_uncertainty().unwrap().direction_rad, Some(0.0), "{element}");
    }
}

#[test]
fn a_rigid_best_fit_finds_the_motion_and_its_uncertainty() {
    let to_T_from = Pose::from_xyz_rpy([310.0, -870.0, 95.0], [0.7, -1.1, 2.4]);
    let from = [[0.0, 0.0, 0.0], [200.0, 10.0, 0.0], [180.0, 150.0, 5.0], [-20.0, 120.0, 60.0], [90.0, 60.0, 0.0]];
    let to: Vec<Vector> = from.iter().map(|&p| to_T_from.apply(p)).collect();
    let fit = fit::rigid(&from, &to).unwrap();
    let left = fit.to_T_from.inverse().then(&to_T_from);
    assert!(
        norm(left.translation_mm) < 1e-12 && left.angle_rad() < 1e-15 && fit.distances_mm().iter().all(|d| *d < 1e-12),
        "{left:?}"
    );

    // a mirror image has no proper rotation: the best one leaves residuals, and is still a rotation
    let mirrored: Vec<Vector> = from.iter().map(|p| [-p[0], p[1], p[2]]).collect();
    let r = fit::rigid(&from, &mirrored).unwrap().to_T_from.rotation;
    assert!((dot(r[0], cross(r[1], r[2])) - 1.0).abs() < 1e-14);

    let (mut centroid, mut stated, mut worst_axis, mut stated_angle) = (0.0, 0.0, 0.0, 0.0);
    let middle = etalon::base::pose::centroid(&from).unwrap();
    // the axis about which the points lie closest: about it a rotation is known least
    let spread = fit::line(&from, &FitSettings::default()).unwrap();
    let trials = 6000;
    for trial in 0..trials {
        let fit = fit::rigid(&from, &disturbed(&to, 1e-3, trial)).unwrap();
        let e = minus(fit.to_T_from.apply(middle), to_T_from.apply(middle));
        centroid += dot(e, e) / 3.0;
        let turn = to_T_from.inverse().then(&fit.to_T_from).rotation;
        let vector = [turn[2][1], turn[0][2], turn[1][0]];
        worst_axis += dot(vector, spread.geometry.direction.unwrap()).powi(2);
        stated += fit.centroid_uncertainty_mm.powi(2);
        stated_angle += fit.rotation_uncertainty_rad.powi(2);
    }
    assert!((centroid / stated - 1.0).abs() < 0.05, "centroid: {}", (centroid / stated).sqrt());
    assert!((worst_axis / stated_angle - 1.0).abs() < 0.05, "rotation: {}", (worst_axis / stated_angle).sqrt());
}

/// A piece of an element with form error, anywhere in space: points, and the root mean square of their true distances.
fn a_piece(element: Element, turn_deg: f64, ratio: f64, relative: f64, trial: u64) -> (Vec<Vector>, f64) {
    let mut noise = Noise::new(11, trial);
    let place = std::array::from_fn(|_| noise.uniform(500.0));
    let pose = Pose::from_xyz_rpy(place, std::array::from_fn(|_| noise.uniform(1.5)));
    let half_angle = [0.02f64, 0.5, 1.3][trial as usize % 3];
    let (mut points, mut squares) = (Vec::new(), 0.0);
    for _ in 0..40 {
        let (sin, cos) = noise.uniform(turn_deg.to_radians() / 2.0).sin_cos();
        let (h, form) = (noise.uniform(20.0 * ratio), noise.gaussian(40.0 * relative));
        let (out, z) = match element {
            Element::Cone => {
                // along the slant, short of the apex
                let h = h.clamp(-30.0 / half_angle.sin(), 30.0 / half_angle.sin());
                (40.0 + h * half_angle.sin() + form * half_angle.cos(), h * half_angle.cos() - form * half_angle.sin())
            }
            Element::Torus => {
                let (rise, out) = noise.uniform(3.1).sin_cos();
                (40.0 + (12.0 + form) * out, (12.0 + form) * rise)
            }
            _ => (40.0 + form, h),
        };
        points.push(pose.apply([out * cos, out * sin, z]));
        squares += form * form;
    }
    (points, (squares / 40.0).sqrt())
}

#[test]
fn no_start_ends_in_a_worse_minimum_than_the_truth() {
    let mut trial = 0;
    for element in [Element::Cylinder, Element::Cone, Element::Torus] {
        for turn in [35.0, 90.0, 360.0] {
            for ratio in [0.3, 1.0, 20.0] {
                for relative in [1e-5, 1e-3] {
                    trial += 1;
                    let (points, truth) = a_piece(element, turn, ratio, relative, trial);
                    let rms = fitted(element, &points).rms_mm();
                    assert!(
                        rms <= truth,
                        "{element} {turn} deg, ratio {ratio}, noise {relative}: {rms:e} over {truth:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn residuals_of_a_circle_by_orthogonal_distances_are_distances_from_the_curve() {
    let mut noise = Noise::new(14, 0);
    let points: Vec<Vector> = (0..400)
        .map(|_| {
            let (sin, cos) = noise.uniform(PI).sin_cos();
            [20.0 * cos + noise.gaussian(0.001), 20.0 * sin + noise.gaussian(0.001), noise.gaussian(0.1)]
        })
        .collect();
    let settings = FitSettings { circle: CircleMethod::Orthogonal, ..FitSettings::default() };
    let circle = fit::element(Element::Circle3d, &points, &settings).unwrap();
    let (n, radius) = (circle.geometry.direction.unwrap(), circle.geometry.radius_mm.unwrap());
    let distances = points.iter().map(|&p| {
        let w = minus(p, circle.geometry.point_mm);
        (norm(cross(n, w)) - radius).hypot(dot(n, w))
    });
    let (squares, most) = distances.fold((0.0, 0.0f64), |(squares, most), d| (squares + d * d, most.max(d)));
    assert!(
        (circle.rms_mm() - (squares / 400.0).sqrt()).abs() < 1e-12 && circle.rms_mm() > 0.09,
        "{}",
        circle.rms_mm()
    );
    assert!((circle.max_mm() - most).abs() < 1e-12 && (circle.form_mm() - 2.0 * most).abs() < 1e-12);
    assert!((circle.residual_mm([0.0, 0.0, 30.0]) - 36.0).abs() < 0.1);
}

#[test]
fn a_cone_of_points_of_a_plane_is_below_180_deg_and_is_said_to_be_a_plane() {
    let (mut fits, mut planes) = (0, 0);
    for trial in 0..60 {
        let mut noise = Noise::new(15, trial);
        let turn = Pose::from_xyz_rpy([10.0, -20.0, 30.0], [0; 3].map(|_| noise.uniform(3.0)));
        let points: Vec<Vector> = (0..50 + 10 * trial)
            .map(|_| turn.apply([noise.uniform(50.0), noise.uniform(40.0), noise.gaussian(0.005)]))
            .collect();
        let Ok(cone) = fit::element(Element::Cone, &points, &FitSettings::default()) else { continue };
        let (angle, axis) = (cone.geometry.apex_angle_rad.unwrap(), cone.geometry.direction.unwrap());
        assert!(angle > 0.0 && angle < PI && cone.geometry.radius_mm.unwrap() > 0.0, "{trial}: {cone:?}");
        // one micrometre along the axis the section is larger
        let inside = [0, 1, 2].map(|k| cone.geometry.point_mm[k] + 1e-3 * axis[k]);
        assert!(cone.residual_mm(inside) < cone.residual_mm(cone.geometry.point_mm), "{trial}");
        fits += 1;
        planes += usize::from(cone.warnings.iter().any(|w| w.id == "cone-is-plane"));
    }
    // most planes have no cone at all
    assert!(fits >= 10 && 10 * planes >= 9 * fits, "{planes} of {fits}");
}
