//! Foreign points in fits: none is seen in clean draws (synthetic), and a few are found.

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector};
use etalon::fit::{Element, FitSettings, Source, element, foreign_points, robust_element};

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
fn clean_points_cause_no_warning() {
    let (mut lost, mut warned, mut draws) = (0, 0, 0);
    for kind in Element::ALL {
        for trial in 0..112 {
            let mut noise = Noise::new(79, trial);
            let n = 3 * kind.minimum_points() + trial as usize % 60;
            let points = drawn(kind, n, &mut noise);
            let Ok(all) = element(kind, &points, &FitSettings::default()) else { continue };
            draws += 1;
            lost += robust_element(kind, &points, &FitSettings::default()).unwrap().set_aside.len();
            warned += usize::from(foreign_points(&all, &Source::from(&points), &FitSettings::default()).is_some());
        }
    }
    println!("{draws} clean draws: {lost} points set aside, {warned} warnings");
    assert!(draws > 990 && warned == 0 && lost < 20);
}
