//! Minimum zones of circles in space, spheres, cylinders and cones: zones known by construction are found, multipliers and random
//! neighbours agree that none is narrower, a motion changes nothing, and what does not show the element is refused.

#![allow(clippy::print_stdout)] // how close each comes is worth saying

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, cross, dot, minus, norm, unit};
use etalon::fit::{self, Element, FitSettings, MinimumZone, minimum_zone};

const ELEMENTS: [Element; 3] = [Element::Sphere, Element::Cylinder, Element::Cone];
const HALF_ANGLE: f64 = 0.35;
const RADIUS_MM: f64 = 25.0;

/// A point of the element about the origin and z, `off_mm` outside; `along` between -1 and 1.
fn on_surface(element: Element, turn: f64, along: f64, off_mm: f64) -> Vector {
    let (sin, cos) = turn.sin_cos();
    let (rho, z) = match element {
        Element::Sphere => {
            let (up, out) = (0.5 * std::f64::consts::PI * along).sin_cos();
            ((RADIUS_MM + off_mm) * out, (RADIUS_MM + off_mm) * up)
        }
        Element::Cylinder => (RADIUS_MM + off_mm, 30.0 * along),
        Element::Cone => {
            let (s, c) = HALF_ANGLE.sin_cos();
            (RADIUS_MM + 30.0 * along * s + off_mm * c, 30.0 * along * c - off_mm * s)
        }
        _ => (RADIUS_MM + off_mm, 0.0),
    };
    [rho * cos, rho * sin, z]
}

/// Points whose minimum zone is known: contacts that hold it by symmetry, and others within it. Upper contacts first.
///
/// Gradients of the distance by the parameters have mean zero on either side, or the same component of the half angle.
fn constructed(element: Element, width_mm: f64, seed: u64) -> (Vec<Vector>, usize) {
    let (half, mut noise) = (0.5 * width_mm, Noise::new(71, seed));
    let quarter = std::f64::consts::FRAC_PI_2;
    let mut points = Vec::new();
    if element == Element::Sphere {
        // two poles outside, three points of the equator inside
        points.extend([1.0, -1.0].map(|along| on_surface(element, 0.0, along, half)));
        points.extend([0.0, 1.0, 2.0].map(|k| on_surface(element, k * quarter * 4.0 / 3.0, 0.0, -half)));
    } else {
        // at both ends two points outside and, a quarter turn on, two inside
        for (turn, off) in [(0.0, half), (quarter, -half)] {
            for along in [-1.0, 1.0] {
                points.extend([turn, turn + 2.0 * quarter].map(|turn| on_surface(element, turn, along, off)));
            }
        }
    }
    let contacts = points.len();
    points.extend((0..60).map(|_| {
        let (turn, along, off) = (noise.uniform(2.0 * quarter), noise.uniform(0.95), noise.uniform(0.9 * half));
        on_surface(element, turn, along, off)
    }));
    (points, contacts)
}

fn somewhere(seed: u64) -> Pose {
    Pose::identity().turn_x(0.4 + seed as f64).turn_y(1.1 * seed as f64).shift(0, 120.0).shift(2, -70.0)
}

#[test]
fn zones_known_by_construction_are_found() {
    for element in ELEMENTS {
        let mut worst = 0.0f64;
        for seed in 0..40 {
            let width = [1e-4, 0.01, 0.5, 3.0][seed as usize % 4];
            let (points, contacts) = constructed(element, width, seed);
            let pose = somewhere(seed);
            let moved: Vec<Vector> = points.iter().map(|&p| pose.apply(p)).collect();
            let zone = minimum_zone(element, &moved).unwrap();
            worst = worst.max((zone.form_mm - width).abs());
            assert!((zone.form_mm - width).abs() < 2e-13, "{element} {seed}: {} {width}", zone.form_mm);
            let upper = if element == Element::Sphere { 2 } else { 4 };
            assert_eq!(zone.upper, (0..upper).collect::<Vec<_>>(), "{element} {seed}");
            assert_eq!(zone.lower, (upper..contacts).collect::<Vec<_>>(), "{element} {seed}");
            let centre = pose.apply([0.0; 3]);
            assert!((zone.geometry.radius_mm.unwrap() - RADIUS_MM).abs() < 1e-3 || element == Element::Cone);
            match zone.geometry.direction {
                None => assert!(norm(minus(zone.geometry.point_mm, centre)) < 1e-11, "{element}: {zone:?}"),
                Some(d) => {
                    assert!(norm(cross(d, minus(zone.geometry.point_mm, centre))) < 1e-11, "{element}");
                    assert!(norm(cross(d, pose.rotate([0.0, 0.0, 1.0]))) < 1e-12, "{element}");
                }
            }
            if element == Element::Cone {
                assert!((zone.geometry.apex_angle_rad.unwrap() - 2.0 * HALF_ANGLE).abs() < 1e-12);
                let apex = pose.apply([0.0, 0.0, -RADIUS_MM / HALF_ANGLE.tan()]);
                assert!(
                    norm(minus(zone.geometry.apex_mm().unwrap(), apex)) < 1e-10,
                    "{:?} {apex:?}",
                    zone.geometry.apex_mm()
                );
            }
            assert!(zone.multipliers.is_some(), "{element} {seed}");
            assert_eq!(zone.verified, element == Element::Sphere, "{element} {seed}");
        }
        println!("{element}: 40 zones known by construction, worst width off by {worst:.1e} mm");
    }
}

/// Distance of a point from an element that is given by numbers: centre; or point and direction of the axis; and half angle.
fn distance(element: Element, x: &[f64; 7], q: Vector) -> f64 {
    let w = minus(q, [x[0], x[1], x[2]]);
    if element == Element::Sphere {
        return norm(w);
    }
    let d = unit([x[3], x[4], x[5]]).unwrap();
    let (t, rho) = (dot(w, d), norm(cross(w, d)));
    if element == Element::Cone { rho * x[6].cos() - t * x[6].sin() } else { rho }
}

fn width(element: Element, x: &[f64; 7], points: &[Vector]) -> f64 {
    let all = points.iter().map(|&q| distance(element, x, q));
    let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), d| (l.min(d), h.max(d)));
    high - low
}

fn numbers(zone: &MinimumZone) -> [f64; 7] {
    let ([x, y, z], [i, j, k]) = (zone.geometry.point_mm, zone.geometry.direction.unwrap_or([0.0, 0.0, 1.0]));
    [x, y, z, i, j, k, 0.5 * zone.geometry.apex_angle_rad.unwrap_or(0.0)]
}

/// Points near the element with form deviations, over part of the turn.
fn deviating(element: Element, count: usize, noise_mm: f64, turn_rad: f64, seed: u64) -> Vec<Vector> {
    let mut noise = Noise::new(72, seed);
    let pose = somewhere(seed);
    let point = |_| {
        let (turn, along, off) = (noise.uniform(0.5 * turn_rad), noise.uniform(1.0), noise.uniform(noise_mm));
        pose.apply(on_surface(element, turn, along, off))
    };
    (0..count).map(point).collect()
}

#[test]
fn multipliers_and_random_neighbours_agree_that_none_is_narrower() {
    for element in ELEMENTS {
        let (mut global, mut local, mut all) = (0, 0, 0);
        for seed in 0..60 {
            let count = [12, 40, 300][seed as usize % 3];
            let turn = [std::f64::consts::TAU, 3.0][seed as usize / 3 % 2];
            let points = deviating(element, count, [0.005, 0.3][seed as usize / 6 % 2], turn, seed);
            let zone = minimum_zone(element, &points).unwrap_or_else(|e| panic!("{element} {seed}: {e}"));
            let least_squares = fit::element(element, &points, &FitSettings::default()).unwrap().form_mm();
            assert!(zone.form_mm <= least_squares + 1e-12, "{element} {seed}: {} {least_squares}", zone.form_mm);
            all += 1;
            global += usize::from(zone.verified);
            let x = numbers(&zone);
            assert!((width(element, &x, &points) - zone.form_mm).abs() < 1e-11, "{element} {seed}");
            let Some(multipliers) = &zone.multipliers else { continue };
            local += 1;
            // the certificate, by numeric derivatives of a distance that is written down anew
            for (side, weights) in [(&zone.upper, &multipliers.upper), (&zone.lower, &multipliers.lower)] {
                assert!(side.len() == weights.len() && weights.iter().all(|l| *l >= 0.0), "{element} {seed}");
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-11, "{element} {seed}: {weights:?}");
            }
            for k in (0..7).filter(|k| *k < 3 || (element != Element::Sphere && *k < 6) || (element == Element::Cone)) {
                let mean = |side: &[usize], weights: &[f64]| {
                    let slope = |i: usize| {
                        let at = |h: f64| {
                            let mut x = x;
                            x[k] += h;
                            distance(element, &x, points[i])
                        };
                        (at(1e-5) - at(-1e-5)) / 2e-5
                    };
                    side.iter().zip(weights).map(|(&i, l)| l * slope(i)).sum::<f64>()
                };
                let (upper, lower) = (mean(&zone.upper, &multipliers.upper), mean(&zone.lower, &multipliers.lower));
                assert!((upper - lower).abs() < 1e-5, "{element} {seed}: {k}: {upper} {lower}");
            }
            let mut noise = Noise::new(73, seed);
            for trial in 0..2000 {
                let size = 10f64.powi(-(trial % 6) - 1);
                let mut y = x;
                for (k, y) in y.iter_mut().enumerate() {
                    *y += noise.gaussian(if k < 3 { size } else { size / 30.0 });
                }
                // a large step may lead to another valley
                let near = size < 0.05 || zone.verified;
                let found = width(element, &y, &points);
                assert!(!near || found > zone.form_mm - 1e-12, "{element} {seed}: {found} {}", zone.form_mm);
            }
        }
        println!("{element}: {all} zones, {local} with multipliers, {global} proved the narrowest of all");
        assert!(local >= all - 3, "{element}: {local} of {all}");
        assert!(element != Element::Sphere || global >= all * 2 / 3, "{element}: {global} of {all}");
    }
}

#[test]
fn a_motion_leaves_width_contacts_and_multipliers() {
    for element in ELEMENTS.into_iter().chain([Element::Circle3d]) {
        for seed in 0..12 {
            let points = deviating(element, 50, 0.02, std::f64::consts::TAU, seed);
            let pose = Pose::identity().shift(0, 40.0).turn_z(0.3 + seed as f64).turn_x(0.7).shift(1, -90.0);
            let moved: Vec<Vector> = points.iter().map(|&p| pose.apply(p)).collect();
            let (before, after) = (minimum_zone(element, &points).unwrap(), minimum_zone(element, &moved).unwrap());
            assert!((before.form_mm - after.form_mm).abs() < 1e-12, "{element} {seed}");
            assert_eq!((&before.upper, &before.lower), (&after.upper, &after.lower), "{element} {seed}");
            let off = minus(pose.apply(before.geometry.point_mm), after.geometry.point_mm);
            assert!(norm(off) < 1e-9, "{element} {seed}: {off:?}");
            // twice as large
            let larger: Vec<Vector> = points.iter().map(|p| p.map(|x| 2.0 * x)).collect();
            assert!((minimum_zone(element, &larger).unwrap().form_mm - 2.0 * before.form_mm).abs() < 1e-12);
        }
    }
}

#[test]
fn a_circle_in_space_has_the_roundness_of_its_plane_and_a_flatness() {
    // a ring whose zone is known (four contacts in turns), and heights whose plane zone is known: four corners, two up, two down
    let pose = somewhere(5);
    let quarter = std::f64::consts::FRAC_PI_2;
    let mut ring: Vec<Vector> = Vec::new();
    for k in 0..4 {
        let turn = f64::from(k) * quarter;
        let [x, y, _] = on_surface(Element::Circle3d, turn, 0.0, if k % 2 == 0 { 0.05 } else { -0.05 });
        ring.push([x, y, 0.0]);
        let [x, y, _] = on_surface(Element::Circle3d, turn + 0.5 * quarter, 0.0, 0.0);
        ring.push([x, y, if k % 2 == 0 { 0.1 } else { -0.1 }]);
    }
    let moved: Vec<Vector> = ring.iter().map(|&p| pose.apply(p)).collect();
    let zone = minimum_zone(Element::Circle3d, &moved).unwrap();
    assert!((zone.form_mm - 0.1).abs() < 1e-12 && zone.verified, "{zone:?}");
    assert_eq!((&zone.upper[..], &zone.lower[..]), (&[0, 4][..], &[2, 6][..]));
    let plane = zone.plane.as_ref().unwrap();
    assert!((plane.form_mm - 0.2).abs() < 1e-12 && plane.verified, "{plane:?}");
    assert!(norm(minus(zone.geometry.point_mm, pose.apply([0.0; 3]))) < 1e-11);
    assert!(norm(cross(zone.geometry.direction.unwrap(), pose.rotate([0.0, 0.0, 1.0]))) < 1e-12);
}

#[test]
fn what_does_not_show_the_element_is_refused_by_name() {
    let flat: Vec<Vector> = (0..40).map(|i| [f64::from(i % 8), f64::from(i / 8), 0.0]).collect();
    let line: Vec<Vector> = (0..9).map(|i| [f64::from(i), 2.0 * f64::from(i), 0.0]).collect();
    let mut noise = Noise::new(74, 0);
    let rough: Vec<Vector> = flat.iter().map(|p| [p[0], p[1], noise.uniform(1e-3)]).collect();
    for element in ELEMENTS {
        for points in [&flat[..], &line, &[[1.0; 3]; 9], &flat[..2], &[]] {
            let message = minimum_zone(element, points).unwrap_err().0.remove(0);
            assert!(message.hint.is_some() && message.expected.is_some(), "{element}: {message}");
        }
        let found = minimum_zone(element, &rough);
        assert!(found.is_err() || found.unwrap().form_mm < 2e-3, "{element}");
    }
    for points in [&line[..], &[[1.0; 3]; 9], &flat[..2]] {
        assert!(minimum_zone(Element::Circle3d, points).is_err());
    }
    for element in [Element::Line, Element::Torus] {
        let message = minimum_zone(element, &flat).unwrap_err().0.remove(0);
        assert!(message.is("zone-unsupported", &[]), "{message}");
    }
    // exactly round: no width
    for element in ELEMENTS {
        let points = deviating(element, 30, 0.0, std::f64::consts::TAU, 1);
        let zone = minimum_zone(element, &points).unwrap();
        assert!(zone.form_mm < 1e-12, "{element}: {}", zone.form_mm);
    }
}

#[test]
fn ten_thousand_points_of_a_solid_take_little_time() {
    for element in ELEMENTS {
        for (turn, noise_mm) in [(std::f64::consts::TAU, 0.01), (1.5, 0.002)] {
            let points = deviating(element, 10_000, noise_mm, turn, 3);
            let start = std::time::Instant::now();
            let zone = minimum_zone(element, &points).unwrap();
            println!(
                "{element}, turn {turn:.1}: {:?}, {} steps, {} mm",
                start.elapsed(),
                zone.iterations,
                zone.form_mm
            );
            assert!(zone.multipliers.is_some() && zone.form_mm <= 2.0 * noise_mm && zone.form_mm > 1.8 * noise_mm);
            assert!(start.elapsed().as_secs() < 60);
        }
    }
}
