//! Outliers in fits: none is seen in clean draws (synthetic), and a few are found.

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, unit};
use etalon::fit::{Element, Fit, FitSettings, Source, element, outlying_points, robust_element};

const U_MM: f64 = 0.01;

/// Points of an element with noise, turned and shifted.
fn drawn(kind: Element, n: usize, noise: &mut Noise) -> Vec<Vector> {
    let flat = matches!(kind, Element::Line2d | Element::Circle2d);
    let turn = [0; 3].map(|_| noise.uniform(1.5));
    let placed = match flat {
        true => Pose::identity(),
        false => Pose { translation_mm: [300.0, -200.0, 500.0], ..Pose::from_rotation_vector(turn) },
    };
    let mut all = Vec::new();
    for _ in 0..n {
        let ((s, c), b, t) = (noise.uniform(3.1).sin_cos(), noise.uniform(50.0), noise.uniform(1.2));
        let exact = match kind {
            Element::Line2d | Element::Line => [b, 0.0, 0.0],
            Element::Plane => [b, noise.uniform(40.0), 0.0],
            Element::Circle2d | Element::Circle3d => [40.0 * c, 40.0 * s, 0.0],
            Element::Sphere => [25.0 * c * t.cos(), 25.0 * s * t.cos(), 25.0 * t.sin()],
            Element::Cylinder => [20.0 * c, 20.0 * s, b],
            Element::Cone => [(40.0 + 0.3 * b) * c, (40.0 + 0.3 * b) * s, b],
            Element::Torus => {
                let (u, v) = (2.5 * t).sin_cos();
                [(50.0 + 10.0 * v) * c, (50.0 + 10.0 * v) * s, 10.0 * u]
            }
        };
        let mut p = placed.apply(exact).map(|v| v + noise.gaussian(U_MM));
        p[2] = if flat { 0.0 } else { p[2] };
        all.push(p);
    }
    all
}

#[test]
#[ignore = "a long law: make laws"]
fn clean_points_cause_no_warning() {
    let (mut lost, mut warned, mut draws) = (0, 0, 0);
    for kind in Element::ALL {
        for trial in 0..56 {
            let mut noise = Noise::new(79, trial);
            let n = 3 * kind.minimum_points() + trial as usize % 60;
            let points = drawn(kind, n, &mut noise);
            let Ok(all) = element(kind, &points, &FitSettings::default()) else { continue };
            draws += 1;
            lost += robust_element(kind, &points, &FitSettings::default()).unwrap().set_aside.len();
            warned += usize::from(outlying_points(&all, &Source::from(&points), &FitSettings::default()).is_some());
        }
    }
    println!("{draws} clean draws: {lost} points set aside, {warned} warnings");
    assert!(draws > 495 && warned == 0 && lost < 10);
}

/// How the points lie on an element: evenly, over an arc (deg), on an arc with points far from it, or
/// in a cluster with points far from it.
#[derive(Clone, Copy, Debug)]
enum Build {
    Even,
    Arc(f64),
    ArcAndFar(f64, usize),
    ClusterAndFar(usize),
}

const BUILDS: [Build; 8] = [
    Build::Even,
    Build::Arc(10.0),
    Build::Arc(60.0),
    Build::ArcAndFar(3.0, 2),
    Build::ArcAndFar(30.0, 3),
    Build::ArcAndFar(60.0, 3),
    Build::ArcAndFar(90.0, 1),
    Build::ClusterAndFar(4),
];
const NOISE_MM: f64 = 0.002;

/// Points of an element so built, with noise, turned and shifted.
fn built(kind: Element, build: Build, n: usize, noise: &mut Noise) -> Vec<Vector> {
    let flat = matches!(kind, Element::Line2d | Element::Circle2d);
    let turn = [0; 3].map(|_| noise.uniform(1.5));
    let placed = match flat {
        true => Pose::identity(),
        false => Pose { translation_mm: [300.0, -200.0, 500.0], ..Pose::from_rotation_vector(turn) },
    };
    let (far, arc_deg, length_mm) = match build {
        Build::Even => (0, 360.0, 50.0),
        Build::Arc(arc) => (0, arc, 50.0 * arc / 360.0),
        Build::ArcAndFar(arc, far) => (far, arc, 10.0),
        Build::ClusterAndFar(far) => (far, 360.0, 3.0),
    };
    let half = arc_deg.to_radians() / 2.0;
    let mut all = Vec::new();
    for i in 0..n {
        let (a, b, t, y) = match i >= n - far {
            true => {
                (3.0 + noise.uniform(0.5), 100.0 + noise.uniform(20.0), noise.uniform(1.2), noise.uniform(40.0) - 80.0)
            }
            false => {
                (noise.uniform(half), noise.uniform(length_mm), noise.uniform(half.min(1.2)), noise.uniform(length_mm))
            }
        };
        let (s, c) = a.sin_cos();
        let exact = match kind {
            Element::Line2d | Element::Line => [b, 0.0, 0.0],
            Element::Plane => [b, y, 0.0],
            Element::Circle2d | Element::Circle3d => [100.0 * c, 100.0 * s, 0.0],
            Element::Sphere => [25.0 * c * t.cos(), 25.0 * s * t.cos(), 25.0 * t.sin()],
            Element::Cylinder => [20.0 * c, 20.0 * s, b],
            Element::Cone => [(60.0 + 0.3 * b) * c, (60.0 + 0.3 * b) * s, b],
            Element::Torus => {
                let (u, v) = (2.5 * t).sin_cos();
                [(50.0 + 10.0 * v) * c, (50.0 + 10.0 * v) * s, 10.0 * u]
            }
        };
        let mut p = placed.apply(exact).map(|v| v + noise.gaussian(NOISE_MM));
        p[2] = if flat { 0.0 } else { p[2] };
        all.push(p);
    }
    all
}

/// Direction across an element at a point.
fn across(fit: &Fit, p: Vector) -> Vector {
    let distance = |k: usize, h: f64| {
        let mut q = p;
        q[k] += h;
        fit.residual_mm(q)
    };
    unit([0, 1, 2].map(|k| distance(k, 1e-4) - distance(k, -1e-4))).unwrap()
}

/// Draws of each element and build: few, so that an element takes seconds.
const DRAWS: u64 = 7;

#[test]
#[ignore = "a long law: make laws"]
fn sound_points_are_kept_however_they_lie() {
    let (mut fits, mut lost) = (0, Vec::new());
    for kind in Element::ALL {
        for build in BUILDS {
            for trial in 0..DRAWS {
                let mut noise = Noise::new(91, trial);
                let n = 30 + trial as usize % 40;
                let points = built(kind, build, n, &mut noise);
                let Ok(found) = robust_element(kind, &points, &FitSettings::default()) else { continue };
                fits += 1;
                if !found.set_aside.is_empty() {
                    lost.push((kind, build, trial));
                }
            }
        }
    }
    // 504 fits: 0.5 are expected, more than three once in 570 times
    println!("{fits} fits, sound points lost in {lost:?}");
    assert!(fits > 490 && lost.len() < 4, "{lost:?}");
}

#[test]
#[ignore = "a long law: make laws"]
fn outlying_points_are_found_however_the_others_lie() {
    // share of outliers, their distance in standard deviations, and the share that is found
    for (share, deviations, least) in [(0.0, 8.0, 0.97), (0.1, 10.0, 0.97), (0.25, 20.0, 0.97)] {
        let (mut there, mut found, mut wrong) = (0, 0, 0);
        for kind in Element::ALL {
            for build in [Build::Even, Build::Arc(60.0), Build::ArcAndFar(60.0, 3)] {
                for trial in 0..4 {
                    let mut noise = Noise::new(92, trial);
                    let n = 48 + trial as usize % 40;
                    let mut points = built(kind, build, n, &mut noise);
                    let count = ((share * n as f64) as usize).max(1);
                    let Ok(clean) = element(kind, &points, &FitSettings::default()) else { continue };
                    for p in points.iter_mut().take(count) {
                        let side = if noise.uniform(1.0) > 0.0 { 1.0 } else { -1.0 };
                        let by = side * deviations * NOISE_MM * (1.5 + noise.uniform(0.5));
                        let d = across(&clean, *p);
                        *p = [0, 1, 2].map(|k| p[k] + by * d[k]);
                    }
                    let Ok(robust) = robust_element(kind, &points, &FitSettings::default()) else { continue };
                    there += count;
                    found += robust.set_aside.iter().filter(|i| **i < count).count();
                    wrong += robust.set_aside.iter().filter(|i| **i >= count).count();
                }
            }
        }
        println!("{share} at {deviations} deviations: {found} of {there} found, {wrong} sound points set aside");
        assert!(found as f64 >= least * there as f64 && wrong < 5, "{share}: {found} of {there}, {wrong}");
    }
}

/// An outlier far from all others is found where other points control it.
#[test]
fn an_outlying_point_is_found_at_leverage_if_others_control_it() {
    for kind in Element::ALL {
        let mut noise = Noise::new(93, 1);
        let mut points = built(kind, Build::ArcAndFar(60.0, 5), 60, &mut noise);
        let clean = element(kind, &points, &FitSettings::default()).unwrap();
        let d = across(&clean, points[57]);
        points[57] = [0, 1, 2].map(|k| points[57][k] + 0.2 * d[k]);
        let found = robust_element(kind, &points, &FitSettings::default()).unwrap();
        assert_eq!(found.set_aside, [57], "{kind}");
    }
}

/// Without noise, on a grid, and with coordinates rounded to micrometres no point is an outlier;
/// tiny and huge units make no difference.
#[test]
#[ignore = "a long law: make laws"]
fn exact_and_rounded_points_are_sound() {
    for kind in Element::ALL {
        for (name, rounding_mm, size) in [
            ("exact", 0.0, 1.0),
            ("rounded", 1e-3, 1.0),
            ("coarse", 0.01, 1.0),
            ("tiny", 0.0, 1e-6),
            ("huge", 0.0, 1e6),
        ] {
            for build in [Build::Even, Build::Arc(60.0), Build::ArcAndFar(30.0, 3)] {
                let mut noise = Noise::new(94, 0);
                let points = built(kind, build, 60, &mut noise);
                let fit = element(kind, &points, &FitSettings::default()).unwrap();
                // onto the element, then rounded
                let exact = |p: &Vector| {
                    let (mut q, d) = (*p, across(&fit, *p));
                    if !matches!(kind, Element::Line | Element::Circle3d) {
                        let off = fit.residual_mm(q);
                        q = [0, 1, 2].map(|k| q[k] - off * d[k]);
                    }
                    q.map(|v| size * if rounding_mm > 0.0 { (v / rounding_mm).round() * rounding_mm } else { v })
                };
                let points: Vec<Vector> = points.iter().map(exact).collect();
                let found = robust_element(kind, &points, &FitSettings::default()).unwrap();
                assert_eq!(found.set_aside, [0; 0], "{kind} {name} {build:?}");
            }
        }
    }
}
