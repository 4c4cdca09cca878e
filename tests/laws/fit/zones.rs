//! Minimum zones: no choice of contact points makes a narrower one, a motion changes nothing, and what cannot be answered
//! is refused.

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, cross, dot, minus, norm, unit};
use etalon::fit::{self, Element, FitSettings, MinimumZone, minimum_zone};

const ELEMENTS: [Element; 3] = [Element::Line2d, Element::Plane, Element::Circle2d];

fn spread(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    high - low
}

fn across(points: &[Vector], normal: Vector) -> f64 {
    unit(normal).map_or(f64::INFINITY, |n| spread(points.iter().map(|&p| dot(minus(p, points[0]), n))))
}

fn ring(points: &[Vector], center: Vector) -> f64 {
    let width = spread(points.iter().map(|p| (p[0] - center[0]).hypot(p[1] - center[1])));
    if width.is_nan() { f64::INFINITY } else { width }
}

/// Where the bisectors of two pairs cross.
fn bisected(pairs: [[Vector; 2]; 2]) -> Vector {
    let row = |[p, q]: [Vector; 2]| {
        let d = minus(q, p);
        (d[0], d[1], 0.5 * (d[0] * (p[0] + q[0]) + d[1] * (p[1] + q[1])))
    };
    let ((a, b, e), (c, d, f)) = (row(pairs[0]), row(pairs[1]));
    let determinant = a * d - b * c;
    [(e * d - b * f) / determinant, (a * f - e * c) / determinant, 0.0]
}

/// The narrowest zone over every choice of points that can hold one, and the narrowest strip.
fn by_force(element: Element, points: &[Vector]) -> (f64, f64) {
    let pairs: Vec<[Vector; 2]> = (0..points.len()).flat_map(|j| (0..j).map(move |i| [points[i], points[j]])).collect();
    let left = |[p, q]: &[Vector; 2]| [p[1] - q[1], q[0] - p[0], 0.0];
    let strip = pairs.iter().map(|pair| across(points, left(pair))).fold(f64::INFINITY, f64::min);
    let mut least = if element == Element::Line2d { strip } else { f64::INFINITY };
    for (k, &one) in pairs.iter().enumerate() {
        for &two in &pairs[..k] {
            // pairs that share a point are three points: normal of a face, centre of a circle through three
            least = least.min(match element {
                Element::Plane => across(points, cross(minus(one[1], one[0]), minus(two[1], two[0]))),
                Element::Circle2d => ring(points, bisected([one, two])),
                _ => least,
            });
        }
    }
    (least, strip)
}

/// Infinite where there is no least-squares circle: scattered points may have none.
fn least_squares_form(element: Element, points: &[Vector]) -> f64 {
    fit::element(element, points, &FitSettings::default()).map_or(f64::INFINITY, |fit| fit.form_mm())
}

/// Points all about, or near to the element with form deviations of `noise_mm`.
fn cloud(element: Element, count: usize, noise_mm: Option<f64>, turn_rad: f64, seed: u64) -> Vec<Vector> {
    let mut noise = Noise::new(40, seed);
    let point = |i: usize| {
        let Some(deviation) = noise_mm else { return [0; 3].map(|_| noise.gaussian(10.0)) };
        let (off, along, side) = (noise.uniform(deviation), noise.uniform(50.0), noise.uniform(30.0));
        match element {
            Element::Plane => [along, side, off],
            Element::Circle2d => {
                let (sin, cos) = (turn_rad * i as f64 / count as f64).sin_cos();
                [(40.0 + off) * cos + 3.0, (40.0 + off) * sin - 7.0, 0.0]
            }
            _ => [along, 0.3 * along + off, 0.0],
        }
    };
    let mut points: Vec<Vector> = (0..count).map(point).collect();
    if element != Element::Plane {
        points.iter_mut().for_each(|p| p[2] = 0.0);
    }
    points
}

/// Residuals, contacts and their condition, whatever the search found.
fn is_held(zone: &MinimumZone, points: &[Vector], size_mm: f64) {
    let half = 0.5 * zone.form_mm;
    let rounding = 1e-13 * size_mm;
    for (i, r) in zone.residuals_mm.iter().enumerate() {
        assert!(r.abs() <= half + rounding, "point {i}: {r} of {half}");
        assert_eq!((r - half).abs() <= rounding, zone.upper.contains(&i) || half <= rounding, "point {i}: {r}");
        assert_eq!((r + half).abs() <= rounding, zone.lower.contains(&i) || half <= rounding, "point {i}: {r}");
        let (q, c) = (points[i], zone.geometry.point_mm);
        let measured = match (zone.element, zone.geometry.direction) {
            (Element::Plane, Some(n)) => dot(minus(q, c), n),
            (Element::Line2d, Some(d)) => (q[1] - c[1]) * d[0] - (q[0] - c[0]) * d[1],
            _ => (q[0] - c[0]).hypot(q[1] - c[1]) - zone.geometry.radius_mm.unwrap(),
        };
        assert!((measured - r).abs() < rounding, "{:?} point {i}: {measured} {r}", zone.element);
    }
    let held = zone.upper.len() + zone.lower.len();
    assert!(half <= rounding || held >= if zone.element == Element::Line2d { 3 } else { 4 }, "{zone:?}");
}

#[test]
fn no_choice_of_contact_points_is_narrower() {
    let mut compared = [0; 3];
    for (kind, element) in ELEMENTS.into_iter().enumerate() {
        for seed in 0..400 {
            let count = 4 + seed as usize % 9;
            let noise_mm = [None, Some(0.01), Some(3.0)][seed as usize / 9 % 3];
            let turn = [std::f64::consts::TAU, 3.0, 1.5][seed as usize / 27 % 3];
            let points = cloud(element, count, noise_mm, turn, seed);
            let (least, strip) = by_force(element, &points);
            // a circle that is no better than a line is none
            if element == Element::Circle2d && least > strip * (1.0 - 1e-9) {
                assert!(minimum_zone(element, &points).is_err(), "{element} {seed}: {least} {strip}");
                continue;
            }
            let zone = minimum_zone(element, &points).unwrap_or_else(|e| panic!("{element} {seed}: {e}"));
            let error = (zone.form_mm - least).abs();
            // coordinates of 50 mm are rounded to 1e-14 mm
            assert!(error <= 1e-12 * least + 5e-14, "{element} {seed}: {} {least}", zone.form_mm);
            assert!(zone.verified, "{element} {seed}: not proved");
            assert!(zone.form_mm <= least_squares_form(element, &points) + 1e-13);
            is_held(&zone, &points, 100.0);
            compared[kind] += 1;
        }
    }
    println!("minimum zones of lines, planes, circles against all contact sets: {compared:?}");
    assert!(compared.iter().all(|c| *c >= 250), "{compared:?}");
}

#[test]
fn a_motion_leaves_the_width_and_the_contacts() {
    for element in ELEMENTS {
        for seed in 0..30 {
            let points = cloud(element, 60, Some(0.02), 2.0, seed);
            let before = minimum_zone(element, &points).unwrap();
            let pose = Pose::identity().shift(0, 120.0).turn_z(0.3 + seed as f64);
            let pose = if element == Element::Plane { pose.turn_x(1.1).shift(2, -40.0).turn_y(0.4) } else { pose };
            let moved: Vec<Vector> = points.iter().map(|&p| pose.apply(p)).collect();
            let after = minimum_zone(element, &moved).unwrap();
            assert!((after.form_mm - before.form_mm).abs() < 5e-13, "{element}: {} {}", after.form_mm, before.form_mm);
            // a normal may point the other way: then the sides are exchanged
            let contacts = |zone: &MinimumZone| {
                let mut both = [zone.upper.clone(), zone.lower.clone()];
                both.sort();
                both
            };
            assert_eq!(contacts(&after), contacts(&before), "{element}");
            if let (Some(a), Some(b), true) =
                (after.geometry.direction, before.geometry.direction, element == Element::Plane)
            {
                assert!(norm(cross(a, pose.rotate(b))) < 1e-12, "{element}");
            }
            if element == Element::Circle2d {
                assert!(norm(minus(after.geometry.point_mm, pose.apply(before.geometry.point_mm))) < 1e-11);
                assert!((after.geometry.radius_mm.unwrap() - before.geometry.radius_mm.unwrap()).abs() < 1e-11);
            }
        }
    }
}

#[test]
fn zones_that_can_be_drawn() {
    // surfmetjs' ring: +-1 and +-2 on the axes, centre 0, width 1
    let ring = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [2.0, 0.0], [-2.0, 0.0], [0.0, 2.0], [0.0, -2.0]];
    let zone = minimum_zone(Element::Circle2d, &ring.map(|[x, y]| [x, y, 0.0])).unwrap();
    assert!((zone.form_mm - 1.0).abs() < 1e-15 && norm(zone.geometry.point_mm) < 1e-15 && zone.verified, "{zone:?}");
    assert!((zone.geometry.radius_mm.unwrap() - 1.5).abs() < 1e-15);
    assert_eq!((zone.upper, zone.lower), (vec![4, 5, 6, 7], vec![0, 1, 2, 3]));
    // corners of a box of 3 x 2 x 1, with points inside
    let mut corners: Vec<Vector> =
        (0..8).map(|i| [f64::from(i & 1) * 3.0, f64::from(i >> 1 & 1) * 2.0, f64::from(i >> 2 & 1)]).collect();
    corners.extend([[1.0, 1.0, 0.5], [2.0, 0.7, 0.2]]);
    let zone = minimum_zone(Element::Plane, &corners).unwrap();
    assert!((zone.form_mm - 1.0).abs() < 1e-14 && zone.verified, "{zone:?}");
    assert!(norm(minus(zone.geometry.direction.unwrap(), [0.0, 0.0, 1.0])) < 1e-14);
    // a cube has three such places, a regular tetrahedron is held by its edges: width = edge / sqrt(2)
    let cube: Vec<Vector> = (0..8).map(|i| [0, 1, 2].map(|k| f64::from(i >> k & 1))).collect();
    let zone = minimum_zone(Element::Plane, &cube).unwrap();
    assert!((zone.form_mm - 1.0).abs() < 1e-14 && zone.verified, "{zone:?}");
    let tetrahedron = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let zone = minimum_zone(Element::Plane, &tetrahedron).unwrap();
    assert!((zone.form_mm - 2.0).abs() < 1e-14 && zone.verified && zone.upper.len() == 2, "{zone:?}");
    // a triangle: its least height, over the longest side
    let zone = minimum_zone(Element::Line2d, &[[0.0; 3], [4.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.5, 0.0]]).unwrap();
    assert!((zone.form_mm - 1.0).abs() < 1e-15 && zone.verified, "{zone:?}");
}

#[test]
fn few_flat_round_and_identical_points() {
    let line: Vec<Vector> = (0..9).map(|i| [f64::from(i), 2.0 * f64::from(i), 0.0]).collect();
    let zone = minimum_zone(Element::Line2d, &line).unwrap();
    assert!(zone.form_mm < 1e-14 && zone.verified, "{zone:?}");
    for element in [Element::Plane, Element::Circle2d] {
        for points in [&line[..], &[[1.0; 3]; 7], &line[..2], &[]] {
            let message = minimum_zone(element, points).unwrap_err().0.remove(0);
            assert!(message.hint.is_some() && message.expected.is_some(), "{message}");
        }
    }
    assert!(minimum_zone(Element::Line2d, &[[1.0; 3]; 7]).is_err());
    let two = minimum_zone(Element::Line2d, &line[3..5]).unwrap();
    assert!(two.form_mm < 1e-15 && two.verified);
    let three = [[0.0, 0.0, 1.0], [5.0, 0.0, 2.0], [1.0, 7.0, -3.0]];
    let zone = minimum_zone(Element::Plane, &three).unwrap();
    assert!(zone.form_mm < 1e-14 && zone.verified, "{zone:?}");
    let zone = minimum_zone(Element::Circle2d, &three).unwrap();
    assert!(zone.form_mm < 1e-14 && zone.verified, "{zone:?}");
    // exactly flat and round, every point twice
    let grid: Vec<Vector> = (0..800).map(|i| [f64::from(i / 2 % 20), f64::from(i / 40), 3.0]).collect();
    let zone = minimum_zone(Element::Plane, &grid).unwrap();
    assert!(
        zone.form_mm < 1e-13 && zone.verified && zone.geometry.direction == Some([0.0, 0.0, 1.0]),
        "{}",
        zone.form_mm
    );
    let round = |i: i32| [(f64::from(i / 2) * 0.03).cos() * 9.0 + 2.0, (f64::from(i / 2) * 0.03).sin() * 9.0, 0.0];
    let zone = minimum_zone(Element::Circle2d, &(0..400).map(round).collect::<Vec<_>>()).unwrap();
    assert!(
        zone.form_mm < 1e-13 && zone.verified && (zone.geometry.radius_mm.unwrap() - 9.0).abs() < 1e-13,
        "{zone:?}"
    );
    // two flat grids one above the other: a thousand points hold either side
    let slab: Vec<Vector> =
        (0..2000).map(|i| [f64::from(i % 40), f64::from(i / 40 % 25), f64::from(i / 1000)]).collect();
    let zone = minimum_zone(Element::Plane, &slab).unwrap();
    assert!((zone.form_mm - 1.0).abs() < 1e-14 && zone.verified && zone.upper.len() == 1000, "{}", zone.form_mm);
}

#[test]
fn ten_thousand_points_take_little_time() {
    for element in ELEMENTS {
        for (what, noise_mm, turn) in [("full", 0.01, std::f64::consts::TAU), ("short", 0.002, 0.6)] {
            let points = cloud(element, 10_000, Some(noise_mm), turn, 1);
            let start = std::time::Instant::now();
            let zone = minimum_zone(element, &points).unwrap();
            println!("{element} {what}: {:?}, {} zones, {} mm", start.elapsed(), zone.iterations, zone.form_mm);
            assert!(zone.verified && zone.form_mm <= least_squares_form(element, &points));
            assert!(zone.form_mm < 2.0 * noise_mm && zone.form_mm > 1.9 * noise_mm, "{}", zone.form_mm);
            is_held(&zone, &points, 200.0);
            assert!(start.elapsed().as_secs() < 60);
        }
    }
}

#[test]
fn points_that_hardly_show_the_element_are_answered_or_refused_in_little_time() {
    let start = std::time::Instant::now();
    // the width of a ball is nearly the same in all directions
    let mut noise = Noise::new(41, 0);
    let ball: Vec<Vector> = (0..3000).filter_map(|_| unit([0; 3].map(|_| noise.gaussian(1.0)))).collect();
    let zone = minimum_zone(Element::Plane, &ball).unwrap();
    assert!(zone.form_mm > 1.98 && zone.form_mm < 2.0 && zone.verified, "{} {}", zone.form_mm, zone.iterations);
    is_held(&zone, &ball, 1.0);
    // a straight row of points, with and without a bend that is below its rounding
    let straight: Vec<Vector> = (0..3000).map(|_| [noise.uniform(50.0), noise.uniform(1e-3), 0.0]).collect();
    let bend: Vec<Vector> = (0..10).map(|i| [f64::from(i), 1e-7 * f64::from(i * i), 0.0]).collect();
    for points in [&straight, &bend] {
        let message = minimum_zone(Element::Circle2d, points).unwrap_err().0.remove(0);
        assert!(message.is("zone-straight", &[]), "{message}");
    }
    println!("a ball and two straight rows: {:?}", start.elapsed());
    assert!(start.elapsed().as_secs() < 200);
}
