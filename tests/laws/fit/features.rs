//! World frames from circles, cylinders and lines with a known truth: features and frames agree with it to 1e-9.

use crate::support::scratch::copy_sample;
use etalon::base::pose::{Pose, Vector, cross, dot, norm, unit};
use etalon::campaign::Campaign;
use etalon::documents::{FeaturesDocument, FramesDocument};
use etalon::simulate::LabelledPoint;
use etalon::simulate::Truth;
use serde::de::DeserializeOwned;

const PLANE: [Vector; 4] = [[0.0, -40.0, 0.0], [420.0, -30.0, 0.0], [400.0, 340.0, 0.0], [10.0, 330.0, 0.0]];
/// A hole over the origin, tilted.
const HOLE: (Vector, Vector, f64) = ([0.0, 0.0, 31.0], [0.1, -0.2, 1.0], 12.5);
/// A rail above the x axis that leaves the plane; projected, it is parallel to x.
const RAIL: (Vector, Vector) = ([15.0, -25.0, 8.0], [1.0, 0.0, 0.02]);
/// A shaft parallel to y, likewise.
const SHAFT: (Vector, Vector, f64) = ([-60.0, 20.0, 44.0], [0.0, 1.0, -0.01], 9.25);
/// A second hole, on the y axis.
const FAR: (Vector, Vector, f64) = ([0.0, 300.0, 12.0], [0.0, 0.3, 1.0], 4.0);

/// A point on the circle of this radius about `center`, square to `normal`.
fn on_circle(center: Vector, normal: Vector, radius_mm: f64, turn: f64) -> Vector {
    let n = unit(normal).unwrap();
    let u = unit(cross(n, [0.3, 0.9, 0.2])).unwrap();
    let v = cross(n, u);
    let (sin, cos) = turn.sin_cos();
    [0, 1, 2].map(|i| center[i] + radius_mm * (cos * u[i] + sin * v[i]))
}

fn along(point: Vector, direction: Vector, t: f64) -> Vector {
    let d = unit(direction).unwrap();
    [0, 1, 2].map(|i| point[i] + t * d[i])
}

fn points() -> Vec<LabelledPoint> {
    let at = |label: String, at_mm| LabelledPoint { label, export: "exports/world.txt".to_owned(), at_mm, repeats: 1 };
    let mut all: Vec<LabelledPoint> = PLANE.iter().map(|p| at("table".to_owned(), *p)).collect();
    for i in 0..9 {
        let turn = 0.7 * f64::from(i);
        all.push(at(format!("hole_{i}"), on_circle(HOLE.0, HOLE.1, HOLE.2, turn)));
        all.push(at(format!("far_{i}"), on_circle(FAR.0, FAR.1, FAR.2, turn)));
        all.push(at(format!("rail_{i}"), along(RAIL.0, RAIL.1, 45.0 * f64::from(i))));
    }
    for i in 0..24 {
        let (turn, height) = (0.83 * f64::from(i), 11.0 * f64::from(i));
        all.push(at("shaft".to_owned(), on_circle(along(SHAFT.0, SHAFT.1, height), SHAFT.1, SHAFT.2, turn)));
    }
    all.push(at("side".to_owned(), [200.0, 210.0, 5.0]));
    all
}

fn document<T: DeserializeOwned>(folder: &std::path::Path, name: &str) -> T {
    crate::support::document(&folder.join("out").join(name))
}

/// Runs the sample with the world frame `world`; what it found, and where the world truly is in the exports.
fn run(world: &str) -> (FeaturesDocument, FramesDocument, Pose) {
    let scratch = copy_sample("prexyt-cmm");
    let path = scratch.path().join("campaign.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let (head, rest) = text.split_once("[feature.rails]").unwrap();
    let tail = &rest[rest.find("[identify]").unwrap()..];
    let features = "[feature.table]\nplane = [\"table\"]\n[feature.hole]\ncircle = [\"hole_*\"]\n\
                    [feature.far]\ncircle = [\"far_*\"]\n[feature.rail]\nline = [\"rail_*\"]\n\
                    [feature.shaft]\ncylinder = [\"shaft\"]\n";
    std::fs::write(&path, format!("{head}{features}[frame.world]\nplane = \"table\"\n{world}\n{tail}")).unwrap();
    let mut truth = Truth::read(&scratch.path().join("truth.toml")).unwrap();
    (truth.noise_um, truth.decimals, truth.cycles, truth.points) = (Some(0.0), 13, 1, points());
    let campaign = Campaign::read(&scratch.path()).unwrap();
    etalon::simulate::simulate(&campaign, &truth).unwrap();
    let outcome = crate::support::documents_of(&campaign).unwrap();
    for p in &outcome.results.identified.as_ref().unwrap().parameters.parameters {
        assert!((p.value - truth.parameters[&p.name]).abs() < 1e-8, "{}: {}", p.name, p.value);
    }
    let rpy = truth.export_T_world.rpy_deg.map(f64::to_radians);
    let placed = Pose::from_xyz_rpy(truth.export_T_world.xyz_mm, rpy);
    (document(&scratch.path(), "features.json"), document(&scratch.path(), "frames.json"), placed)
}

fn close(found: Vector, expected: Vector, what: &str) {
    let off = (0..3).map(|i| (found[i] - expected[i]).abs()).fold(0.0, f64::max);
    assert!(off < 1e-9, "{what}: {found:?} is off by {off:e} from {expected:?}");
}

fn frame_is_true(world: &str) {
    let (_, frames, placed) = run(world);
    let found = frames.world.poses[0].export_T_world;
    close(found.translation_mm, placed.translation_mm, world);
    for row in 0..3 {
        close(found.rotation[row], placed.rotation[row], world);
    }
}

#[test]
fn a_circle_is_the_origin_and_a_line_the_x_axis() {
    frame_is_true("origin = \"hole\"\nx_axis = [\"rail\"]\ntowards = \"side\"");
}

#[test]
fn a_cylinder_is_the_y_axis() {
    frame_is_true("origin = \"hole\"\ny_axis = [\"shaft\"]\ntowards = \"side\"");
}

#[test]
fn two_circles_are_the_y_axis() {
    frame_is_true("origin = \"hole\"\ny_axis = [\"hole\", \"far\"]\ntowards = \"side\"");
}

#[test]
fn two_labels_are_the_x_axis() {
    frame_is_true("origin = \"hole\"\nx_axis = [\"rail_0\", \"rail_8\"]\ntowards = \"far\"");
}

/// Name, element, number of points, a point, direction and radius of a feature.
type Truly = (&'static str, &'static str, usize, Vector, Vector, Option<f64>);

#[test]
fn features_agree_with_the_truth() {
    let (features, _, placed) = run("origin = \"hole\"\nx_axis = [\"rail\"]\ntowards = \"side\"");
    let feature = |name: &str| features.features.iter().find(|f| f.name == name).unwrap();
    let turned = |d: Vector| {
        let d = unit(d).unwrap();
        placed.rotation.map(|row| dot(row, d))
    };
    let expected: [Truly; 5] = [
        ("table", "plane", 4, PLANE[0], [0.0, 0.0, 1.0], None),
        ("hole", "circle", 9, HOLE.0, HOLE.1, Some(HOLE.2)),
        ("far", "circle", 9, FAR.0, FAR.1, Some(FAR.2)),
        ("rail", "line", 9, RAIL.0, RAIL.1, None),
        ("shaft", "cylinder", 24, SHAFT.0, SHAFT.1, Some(SHAFT.2)),
    ];
    for (name, element, count, point, direction, radius_mm) in expected {
        let f = feature(name);
        assert_eq!((f.element.as_str(), f.points), (element, count));
        let d = turned(direction);
        let same_way = if dot(f.direction, d) < 0.0 { -1.0 } else { 1.0 };
        close(f.direction.map(|v| v * same_way), d, name);
        // from a point of the element: nothing along the normal of a plane, nothing across an axis, nothing at a centre
        let p = placed.apply(point);
        let apart = [0, 1, 2].map(|i| f.point_mm[i] - p[i]);
        let height = dot(apart, d);
        let off = match element {
            "plane" => height.abs(),
            "circle" => norm(apart),
            _ => norm([0, 1, 2].map(|i| apart[i] - height * d[i])),
        };
        assert!(off < 1e-9, "{name}: its point is off by {off:e}");
        assert_eq!(f.radius_mm.is_some(), radius_mm.is_some(), "{name}");
        let off = f.radius_mm.zip(radius_mm).map_or(0.0, |(found, truly)| (found - truly).abs());
        assert!(off < 1e-9, "{name}: its radius is off by {off:e}");
        assert!(f.max_mm < 1e-9, "{name}: {:e}", f.max_mm);
    }
}
