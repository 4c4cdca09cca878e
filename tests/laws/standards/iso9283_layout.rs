//! The test laid out: what the standard says of cube, plane, poses and paths holds in every workspace.

use etalon::base::pose::{Vector, cross, dot, minus, norm, unit};
use etalon::standards::iso9283::plan::layout::{PLANES, layout};
use etalon::standards::iso9283::plan::programme::programme;

const LOW: Vector = [300.0, -250.0, 100.0];
const HIGH: Vector = [900.0, 350.0, 500.0];

fn middle(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]))
}

#[test]
fn the_largest_cube_is_in_the_workspace_and_its_diagonal_planes_are_the_four_of_the_standard() {
    for (i, (name, corners)) in PLANES.iter().enumerate() {
        assert_eq!(corners.map(|k| format!("C{}", k + 1)).join("-"), *name);
        let test = layout(LOW, HIGH, i).unwrap();
        assert_eq!((test.side_mm, test.corners_mm.len()), (400.0, 8));
        for p in &test.corners_mm {
            assert!((0..3).all(|k| p[k] >= LOW[k] && p[k] <= HIGH[k]));
        }
        let [a, b, c, d] = corners.map(|k| test.corners_mm[k]);
        // a rectangle of one side and one diagonal of a face, through the centre
        let sides = [norm(minus(b, a)), norm(minus(c, b))];
        assert!((sides[0] - 400.0).abs() < 1e-9 && (sides[1] - 400.0 * 2f64.sqrt()).abs() < 1e-9, "{name} {sides:?}");
        assert!(dot(minus(b, a), minus(c, b)).abs() < 1e-6 && norm(minus(middle(a, c), middle(b, d))) < 1e-9);
        assert!(norm(minus(test.poses_mm[0], [600.0, 50.0, 300.0])) < 1e-9);
    }
}

#[test]
fn poses_lie_on_the_diagonals_a_tenth_from_their_ends() {
    for plane in 0..4 {
        let test = layout(LOW, HIGH, plane).unwrap();
        let corners = test.plane.map(|k| test.corners_mm[k]);
        let diagonal = norm(minus(corners[2], corners[0]));
        assert!((diagonal - 400.0 * 3f64.sqrt()).abs() < 1e-9);
        for k in 0..4 {
            let (p, corner, opposite) = (test.poses_mm[k + 1], corners[k], corners[(k + 2) % 4]);
            assert!((norm(minus(p, corner)) - 0.1 * diagonal).abs() < 1e-9);
            assert!((norm(minus(p, opposite)) - 0.9 * diagonal).abs() < 1e-9);
        }
        let linear = test.linear();
        assert!((norm(minus(linear[1], linear[0])) - 0.8 * diagonal).abs() < 1e-9);
    }
}

#[test]
fn circles_lie_in_the_test_plane_about_its_centre_and_close() {
    for plane in 0..4 {
        let test = layout(LOW, HIGH, plane).unwrap();
        let [a, b, c, _] = test.plane.map(|k| test.corners_mm[k]);
        let normal = unit(cross(minus(b, a), minus(c, b))).unwrap();
        for (circle, diameter) in test.circles(72).iter().zip([320.0, 32.0]) {
            assert_eq!((circle.len(), circle[0]), (73, circle[72]));
            for p in circle {
                let d = minus(*p, test.poses_mm[0]);
                assert!((norm(d) - 0.5 * diameter).abs() < 1e-9 && dot(d, normal).abs() < 1e-9);
            }
        }
        assert_eq!(test.rectangle().len(), 5);
        let poses = test.posing();
        let steps: Vec<f64> = poses.windows(2).map(|p| norm(minus(p[1], p[0]))).collect();
        // P2 and P4 are 277 mm from the centre: -10, +20, -50, +100 and -200 end at -140, +500 would end at +360
        assert!(steps.iter().zip([10.0, 20.0, 50.0, 100.0, 200.0]).all(|(a, b)| (a - b).abs() < 1e-9));
        assert_eq!(steps.len(), 5);
    }
}

#[test]
fn a_planar_robot_gets_a_square_and_no_workspace_gets_nothing() {
    let test = layout([0.0, 0.0, 7.0], [300.0, 200.0, 7.0], 0).unwrap();
    assert_eq!((test.side_mm, test.corners_mm.len(), test.plane), (200.0, 4, [0, 1, 2, 3]));
    assert_eq!(test.poses_mm[0], [150.0, 100.0, 7.0]);
    assert!(test.circles(8)[0].iter().all(|p| p[2] == 7.0));
    let nan = [f64::NAN; 3];
    for (low, high, plane) in [(HIGH, LOW, 0), (LOW, LOW, 0), (LOW, nan, 0), (nan, HIGH, 0), (LOW, HIGH, 4)] {
        assert!(layout(low, high, plane).is_err());
    }
    assert!(programme().iter().all(|item| item.cycles >= 3 && !item.clause.is_empty()));
}
