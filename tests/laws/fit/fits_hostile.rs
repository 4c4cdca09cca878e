//! No input makes a fit panic or answer with a number that is none.

use etalon::base::noise::Noise;
use etalon::base::pose::Vector;
use etalon::fit::{self, CircleMethod, Element, FitSettings};

fn is_sound(what: &str, element: Element, points: &[Vector], settings: &FitSettings) {
    match fit::element(element, points, settings) {
        Err(problems) => {
            let message = problems.0.first().unwrap_or_else(|| panic!("{element} of {what}: an error without words"));
            assert!(message.hint.is_some() && message.expected.is_some(), "{element} of {what}: {message}");
        }
        Ok(fit) => {
            let mut numbers: Vec<f64> =
                fit.geometry.point_mm.into_iter().chain(fit.geometry.direction.unwrap_or_default()).collect();
            numbers.extend(
                [fit.geometry.radius_mm, fit.geometry.minor_radius_mm, fit.geometry.apex_angle_rad, fit.coverage_rad]
                    .into_iter()
                    .flatten(),
            );
            numbers.extend(points.iter().map(|&p| fit.residual_mm(p)));
            numbers.extend(fit.out_of_plane_rms_mm);
            numbers.extend([fit.rms_mm(), fit.max_mm(), fit.form_mm(), fit.condition]);
            numbers.extend(fit.precision.covariance.iter().flat_map(|c| c.0).flatten());
            if let Some(u) = fit.standard_uncertainty() {
                numbers.extend(u.point_mm.into_iter().chain([u.point_largest_mm]));
                numbers
                    .extend([u.direction_rad, u.radius_mm, u.minor_radius_mm, u.apex_angle_rad].into_iter().flatten());
            }
            assert!(numbers.iter().all(|x| x.is_finite()), "{element} of {what}: {fit:?}");
            assert!(
                fit.geometry.radius_mm.is_none_or(|r| r > 0.0),
                "{element} of {what}: {:?}",
                fit.geometry.radius_mm
            );
            assert_eq!(fit.points, points.len());
            if let Some(d) = fit.geometry.direction {
                assert!((etalon::base::pose::norm(d) - 1.0).abs() < 1e-14, "{element} of {what}: {d:?}");
            }
        }
    }
}

fn hostile_sets() -> Vec<(String, Vec<Vector>)> {
    let mut sets: Vec<(String, Vec<Vector>)> = Vec::new();
    let mut noise = Noise::new(3, 0);
    let mut cloud =
        |n: usize, size: f64| -> Vec<Vector> { (0..n).map(|_| [0; 3].map(|_| noise.uniform(size))).collect() };
    for n in 0..12 {
        sets.push((format!("{n} random points"), cloud(n, 10.0)));
        sets.push((format!("{n} identical points"), vec![[3.0, -4.0, 1e3]; n]));
        sets.push((
            format!("{n} points on a line"),
            (0..n).map(|i| [i as f64 / 3.0, 1.0 - i as f64 / 7.0, i as f64]).collect(),
        ));
        sets.push((format!("{n} points in a plane"), (0..n).map(|i| [(i * i % 7) as f64, i as f64, 2.0]).collect()));
    }
    sets.push(("40 random points".into(), cloud(40, 10.0)));
    let ring = |n: usize, turn: f64, radius: f64, center: Vector| -> Vec<Vector> {
        let at = |i: usize| (turn * i as f64 / n as f64).sin_cos();
        (0..n)
            .map(|i| [center[0] + radius * at(i).1, center[1] + radius * at(i).0, center[2] + radius * (i % 4) as f64])
            .collect()
    };
    let seen = [6.0, 1.0, 0.1, 1e-3, 1e-6];
    for turn in seen {
        for radius in [1e-6, 1.0, 1e6, 1e-150, 1e90] {
            for center in [[0.0; 3], [1e6, -1e6, 1e6], [1e12; 3]] {
                sets.push((
                    format!("arc of {turn} rad, radius {radius}, at {center:?}"),
                    ring(24, turn, radius, center),
                ));
            }
        }
    }
    let good = ring(24, 5.0, 10.0, [0.0; 3]);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308, -1e200, 5e-324] {
        for k in 0..3 {
            let mut points = good.clone();
            points[7][k] = bad;
            sets.push((format!("{bad} in coordinate {k}"), points));
        }
        sets.push((format!("all {bad}"), vec![[bad; 3]; 9]));
    }
    let twice: Vec<Vector> = good.iter().chain(&good).copied().collect();
    sets.push(("every point twice".into(), twice));
    sets.push(("one outlier at 1e9".into(), good.iter().copied().chain([[1e9, 0.0, 0.0]]).collect()));
    sets.push((
        "one ulp apart".into(),
        (0..9)
            .map(|i| [1.0 + f64::EPSILON * (i % 3) as f64, f64::EPSILON * (i / 3) as f64, i as f64 * 1e-16])
            .collect(),
    ));
    sets.push(("two clusters".into(), (0..10).map(|i| if i < 5 { [0.0; 3] } else { [1.0, 2.0, 3.0] }).collect()));
    sets
}

#[test]
fn every_element_of_every_hostile_set() {
    for (what, points) in hostile_sets() {
        for element in Element::ALL {
            is_sound(&what, element, &points, &FitSettings::default());
        }
        is_sound(
            &what,
            Element::Circle3d,
            &points,
            &FitSettings { circle: CircleMethod::Orthogonal, ..FitSettings::default() },
        );
    }
}

#[test]
fn held_values_and_weights_that_make_no_sense_are_refused_or_harmless() {
    for (what, points) in hostile_sets() {
        for element in Element::ALL {
            let weights: Vec<f64> = (0..points.len()).map(|i| 10f64.powi(i as i32 % 9)).collect();
            is_sound(&what, element, &points, &FitSettings { weights: Some(&weights), ..FitSettings::default() });
        }
    }
    let points: Vec<Vector> = hostile_sets().pop().map(|s| s.1).unwrap_or_default();
    for element in Element::ALL {
        for radius in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300, 1e300, 5.0] {
            is_sound(
                "a held radius",
                element,
                &points,
                &FitSettings { radius_mm: Some(radius), ..FitSettings::default() },
            );
        }
        for axis in [[0.0; 3], [f64::NAN, 1.0, 0.0], [f64::INFINITY, 0.0, 0.0], [1e-200, 0.0, 0.0], [1.0, 2.0, 2.0]] {
            is_sound("a held axis", element, &points, &FitSettings { axis: Some(axis), ..FitSettings::default() });
        }
        for weights in [vec![], vec![0.0; points.len()], vec![-1.0; points.len()], vec![f64::NAN; points.len()]] {
            let settings = FitSettings { weights: Some(&weights), ..FitSettings::default() };
            assert!(fit::element(element, &points, &settings).is_err(), "{element}: {weights:?}");
        }
    }
}

#[test]
fn rigid_and_enclosing_of_every_hostile_set() {
    let sets = hostile_sets();
    for (what, points) in &sets {
        if let Ok(fit) = fit::rigid(points, points) {
            let rotation = fit.to_T_from.rotation.as_flattened().iter();
            let numbers = rotation
                .chain(&fit.to_T_from.translation_mm)
                .chain([&fit.centroid_uncertainty_mm, &fit.rotation_uncertainty_rad]);
            assert!(numbers.chain(fit.residuals_mm.as_flattened()).all(|x| x.is_finite()), "rigid of {what}: {fit:?}");
        }
        assert!(fit::rigid(points, &[]).is_err(), "rigid of {what} to nothing");
        let flat: Vec<[f64; 2]> = points.iter().map(|p| [p[0], p[1]]).collect();
        for ball in [fit::enclosing_sphere(points), fit::enclosing_circle(&flat)].into_iter().flatten() {
            let finite = ball.radius_mm.is_finite() && ball.center_mm.iter().all(|x| x.is_finite());
            assert!(finite && !ball.support.is_empty() && ball.support.len() <= 4, "{what}: {ball:?}");
        }
        for element in Element::ALL {
            let Ok(zone) = fit::minimum_zone(element, points) else { continue };
            let numbers = zone.geometry.point_mm.iter().chain(&zone.residuals_mm).chain(&zone.geometry.radius_mm);
            assert!(numbers.chain([&zone.form_mm]).all(|x| x.is_finite()), "{element} of {what}: {zone:?}");
            assert!(zone.form_mm >= 0.0 && !zone.upper.is_empty() && !zone.lower.is_empty(), "{element} of {what}");
        }
        let usable = !points.is_empty() && points.iter().flatten().all(|x| x.abs() <= 1e100);
        assert_eq!(fit::enclosing_sphere(points).is_ok(), usable, "{what}");
    }
    let line: Vec<Vector> = (0..9).map(|i| [i as f64, 2.0 * i as f64, 0.0]).collect();
    assert!(fit::rigid(&line, &line).is_err());
    assert!(fit::rigid(&[[1.0; 3]; 5], &[[1.0; 3]; 5]).is_err());
}
