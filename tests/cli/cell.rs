//! `etalon cell`: tables of synthetic cells give their frames; wrong conventions are named, sound ones are not.

use crate::support::said::Says;
use etalon::base::angle_order::AngleOrder;
use etalon::base::catalogue::Argument;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::cli::{Answer, answer};
use etalon::documents::CellDocument;
use std::fmt::Write;

const FIXED: Vector = [820.0, -310.0, 245.0];

fn drawn(noise: &mut Noise, turn: f64, size: f64) -> Pose {
    let mut vector = |size: f64| [0; 3].map(|_| noise.uniform(size));
    Pose { translation_mm: vector(size), ..Pose::from_rotation_vector(vector(turn)) }
}

fn tool() -> Pose {
    Pose::from_xyz_rpy([12.5, -4.0, 183.2], [0.3, -0.2, 1.1])
}

/// Poses of a flange that looks down, with the tool centre point at the fixed point.
fn touches(count: usize, turn: f64, noise_mm: f64) -> Vec<Pose> {
    let mut noise = Noise::new(61, 0);
    let down = Pose::from_xyz_rpy([0.0; 3], [std::f64::consts::PI, 0.0, 0.0]);
    let touch = |_| {
        let turned = down.then(&drawn(&mut noise, turn, 0.0));
        let at = minus(FIXED, turned.rotate(tool().translation_mm)).map(|v| v + noise.gaussian(noise_mm));
        Pose { translation_mm: at, ..turned }
    };
    (0..count).map(touch).collect()
}

/// Poses that are spread in space.
fn spread(count: usize) -> Vec<Pose> {
    let mut noise = Noise::new(62, 0);
    (0..count)
        .map(|_| {
            let pose = drawn(&mut noise, 0.9, 400.0);
            Pose { translation_mm: [0, 1, 2].map(|k| pose.translation_mm[k] + [900.0, 0.0, 600.0][k]), ..pose }
        })
        .collect()
}

fn noisy(noise: &mut Noise, pose: &Pose, mm: f64, rad: f64) -> Pose {
    let turn = Pose::from_rotation_vector([0; 3].map(|_| noise.gaussian(rad)));
    let turned = turn.then(&Pose { translation_mm: [0.0; 3], ..*pose });
    Pose { translation_mm: pose.translation_mm.map(|v| v + noise.gaussian(mm)), ..turned }
}

/// Headings and cells of poses, by prefix and form of the orientation.
fn columns(prefix: &str, form: &str, poses: &[Pose]) -> Vec<String> {
    let names: &[&str] = match form {
        "quaternion" => &["qw", "qx", "qy", "qz"],
        "vector" => &["rx_rad", "ry_rad", "rz_rad"],
        _ => &["a_deg", "b_deg", "c_deg"],
    };
    let head =
        ["x_mm", "y_mm", "z_mm"].iter().chain(names).map(|n| format!("{prefix}{n}")).collect::<Vec<_>>().join(",");
    let row = |pose: &Pose| {
        let numbers: Vec<f64> = match form {
            "quaternion" => pose.quaternion().to_vec(),
            "vector" => pose.rotation_vector_rad().to_vec(),
            order => order.parse::<AngleOrder>().unwrap().angles(pose).map(f64::to_degrees).to_vec(),
        };
        let all = pose.translation_mm.iter().chain(&numbers).map(|v| format!("{v:.9}"));
        all.collect::<Vec<_>>().join(",")
    };
    std::iter::once(head).chain(poses.iter().map(row)).collect()
}

/// A table of columns side by side.
fn table(parts: &[Vec<String>]) -> String {
    (0..parts[0].len()).fold(String::new(), |mut out, i| {
        let _ = writeln!(out, "{}", parts.iter().map(|p| p[i].as_str()).collect::<Vec<_>>().join(","));
        out
    })
}

fn points(prefix: &str, all: &[Vector]) -> Vec<String> {
    let head = ["x_mm", "y_mm", "z_mm"].map(|n| format!("{prefix}{n}")).join(",");
    std::iter::once(head).chain(all.iter().map(|p| p.map(|v| format!("{v:.9}")).join(","))).collect()
}

fn run(table: &str, arguments: &[&str]) -> Answer {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cell.csv");
    std::fs::write(&path, table).unwrap();
    let path = path.display().to_string();
    answer(["etalon", "cell", &path].iter().chain(arguments).map(|a| (*a).into()))
}

fn with_code(code: u8, table: &str, arguments: &[&str]) -> CellDocument {
    let answer = run(table, &[arguments, &["--json"]].concat());
    assert_eq!(answer.code, code, "{}", answer.stderr);
    serde_json::from_slice(&answer.stdout).unwrap()
}

fn document(table: &str, arguments: &[&str]) -> CellDocument {
    with_code(0, table, arguments)
}

fn ids(found: &CellDocument) -> Vec<String> {
    found.messages.iter().map(|m| m.id.to_string()).collect()
}

/// Ids of the messages of an answer that must not be loaded: the exit code is 1, and data of a controller are written by force
/// alone.
fn unfit(table: &str, arguments: &[&str]) -> Vec<String> {
    let found = with_code(1, table, arguments);
    assert!(found.errors().next().is_some());
    let kuka = [arguments, &["--controller", "kuka"]].concat();
    let withheld = run(table, &kuka);
    assert!(withheld.code == 1 && withheld.stdout.is_empty(), "{}", withheld.stderr);
    assert!(withheld.messages.iter().any(|m| m.is("cell-data-withheld", &[("maker", &"kuka")])), "{}", withheld.stderr);
    let forced = run(table, &[&kuka[..], &["--force"]].concat());
    let shown = String::from_utf8(forced.stdout).unwrap();
    assert!(
        forced.code == 1 && shown.contains("NOT FIT FOR A CONTROLLER") && shown.contains("TOOL_DATA[1]={"),
        "{shown}"
    );
    ids(&found)
}

/// Ids of the changes that a refusal names.
fn changes(table: &str, arguments: &[&str]) -> Vec<String> {
    let answer = run(table, arguments);
    assert_eq!(answer.code, 2, "{}", answer.stderr);
    let slip = answer.messages.iter().find(|m| m.id == "cell-slip").unwrap_or_else(|| panic!("{}", answer.stderr));
    let Argument::List(all) = &slip.arguments["changes"] else { panic!("{slip:?}") };
    // of orientations the way of reading them
    let id = |a: &Argument| match a {
        Argument::Phrase(phrase) => match phrase.arguments.get("what") {
            Some(Argument::Phrase(what)) => match &what.arguments["slip"] {
                Argument::Text(slip) => slip.clone(),
                other => format!("{other:?}"),
            },
            _ => phrase.id.to_string(),
        },
        _ => String::new(),
    };
    all.iter().map(id).collect()
}

#[test]
fn a_tool_point_is_found_and_wrong_conventions_are_named() {
    let poses = touches(8, 0.7, 0.05);
    let kuka = table(&[columns("flange_", "zyx", &poses)]);
    let found = document(&kuka, &["--solve", "tool-point", "--orientation", "zyx"]);
    assert!(found.messages.is_empty(), "{:?}", found.messages);
    let (at, u) = (found.points[0].xyz_mm, found.points[0].standard_uncertainty_mm.unwrap());
    assert!((0..3).all(|k| (at[k] - tool().translation_mm[k]).abs() < 4.0 * u[k] && u[k] < 0.2), "{at:?} {u:?}");
    // another order is an error of the data, and the true one is named
    assert_eq!(changes(&kuka, &["--solve", "tool-point", "--orientation", "fixed xyz"]), ["order"]);
    let radians = kuka.replace("_deg", "_rad");
    assert_eq!(changes(&radians, &["--solve", "tool-point", "--orientation", "zyx"]), ["degrees"]);
    let quaternions = table(&[columns("flange_", "quaternion", &poses)]);
    let last =
        quaternions.replace("flange_qw,flange_qx,flange_qy,flange_qz", "flange_qx,flange_qy,flange_qz,flange_qw");
    // the cells stay: the scalar is in the column of x
    assert!(
        changes(
            &last
                .replace("flange_qx,flange_qy,flange_qz,flange_qw", "flange_qw,flange_qx,flange_qy,flange_qz")
                .lines()
                .enumerate()
                .map(|(i, line)| if i == 0 {
                    line.to_owned()
                } else {
                    let c: Vec<&str> = line.split(',').collect();
                    [c[0], c[1], c[2], c[4], c[5], c[6], c[3]].join(",")
                })
                .collect::<Vec<_>>()
                .join("\n"),
            &["--solve", "tool-point"]
        ) == ["scalar-last"]
    );
    // inverse poses exchange the tool with the fixed point: residuals do not show them
    let inverse: Vec<Pose> = poses.iter().map(Pose::inverse).collect();
    let exchanged = document(&table(&[columns("flange_", "vector", &inverse)]), &["--solve", "tool-point"]);
    assert!(norm(minus(exchanged.points[1].xyz_mm, tool().translation_mm)) < 0.3);
    let back: Vec<Pose> = poses.iter().map(|p| Pose { translation_mm: p.translation_mm, ..p.inverse() }).collect();
    let named = changes(&table(&[columns("flange_", "quaternion", &back)]), &["--solve", "tool-point"]);
    assert_eq!(named, ["inverse"]);
}

#[test]
fn sound_tables_of_unusual_build_have_no_slip() {
    // small rotations, four readings, large noise
    for (count, turn, noise_mm) in [(4, 0.7, 0.05), (5, 0.05, 0.05), (12, 0.2, 1.0), (40, 1.4, 0.3), (6, 0.7, 0.0)] {
        let poses = touches(count, turn, noise_mm);
        for form in ["zyx", "fixed xyz", "zyz"] {
            let text = table(&[columns("flange_", form, &poses)]);
            let found = document(&text, &["--solve", "tool-point", "--orientation", form]);
            assert!(found.messages.is_empty(), "{count} {turn} {:?}", found.messages);
        }
        document(&table(&[columns("flange_", "vector", &poses)]), &["--solve", "tool-point"]);
    }
    // poses of an active tool, and in metres
    let tip: Vec<Pose> = touches(8, 0.7, 0.05);
    let active: Vec<Pose> =
        tip.iter().map(|p| p.then(&Pose { translation_mm: tool().translation_mm, ..Pose::identity() })).collect();
    let found = unfit(&table(&[columns("flange_", "quaternion", &active)]), &["--solve", "tool-point"]);
    assert_eq!(found, ["cell-tool-active"]);
    let metres: Vec<Pose> =
        tip.iter().map(|p| Pose { translation_mm: p.translation_mm.map(|v| v / 1000.0), ..*p }).collect();
    let text = table(&[columns("flange_", "quaternion", &metres)]);
    assert_eq!(unfit(&text, &["--solve", "tool-point"]), ["cell-unit"]);
    let millimetres = table(&[columns("flange_", "quaternion", &tip)]).replace("_mm", "_m");
    assert_eq!(unfit(&millimetres, &["--solve", "tool-point"]), ["cell-unit-large"]);
    let named = text.replace("flange_x_mm,flange_y_mm,flange_z_mm", "flange_x_m,flange_y_m,flange_z_m");
    let found = document(&named, &["--solve", "tool-point"]);
    assert!(found.messages.is_empty() && norm(minus(found.points[0].xyz_mm, tool().translation_mm)) < 0.3);
}

/// Poses with changed positions.
fn changed(poses: &[Pose], change: impl Fn(&mut Vector)) -> Vec<Pose> {
    let mut all = poses.to_vec();
    all.iter_mut().for_each(|p| change(&mut p.translation_mm));
    all
}

#[test]
fn exchanged_axes_and_signs_are_named() {
    let solve = ["--solve", "tool-point"];
    let text = |poses: &[Pose]| table(&[columns("flange_", "quaternion", poses)]);
    for (count, turn, noise_mm) in [(8, 0.7, 0.05), (6, 0.2, 0.1), (12, 0.4, 1.0)] {
        let poses = touches(count, turn, noise_mm);
        for (a, b) in [(0, 1), (1, 2), (0, 2)] {
            let named = changes(&text(&changed(&poses, |p| p.swap(a, b))), &solve);
            assert_eq!(named, ["cell-change-axes"], "{count} {a} {b}");
        }
        for k in 0..3 {
            assert_eq!(changes(&text(&changed(&poses, |p| p[k] = -p[k])), &solve), ["cell-change-sign"], "{count} {k}");
        }
    }
    // both sides of hand and eye, and a reflector, whose coordinates are mirrored in any of these ways
    let (poses, mut noise) = (spread(10), Noise::new(66, 0));
    let world = Pose::from_xyz_rpy([3000.0, -500.0, 900.0], [0.02, -0.01, 2.2]);
    let seen: Vec<Pose> = poses.iter().map(|p| noisy(&mut noise, &world.then(p).then(&tool()), 0.05, 2e-4)).collect();
    let hand = ["--solve", "hand-eye", "--mounting", "target"];
    let both = |flange: &[Pose], seen: &[Pose]| {
        table(&[columns("flange_", "quaternion", flange), columns("", "quaternion", seen)])
    };
    let sign = |p: &mut Vector| p[2] = -p[2];
    assert_eq!(changes(&both(&changed(&poses, |p| p.swap(0, 1)), &seen), &hand), ["cell-change-axes"]);
    assert_eq!(changes(&both(&poses, &changed(&seen, sign)), &hand), ["cell-change-sign"]);
    let at = |poses: &[Pose]| poses.iter().map(|p| p.translation_mm).collect::<Vec<_>>();
    let reflector = |flange: &[Pose], seen: &[Pose]| {
        let text = table(&[columns("flange_", "quaternion", flange), points("", &at(seen))]);
        changes(&text, &["--solve", "tool-reflector"])
    };
    assert_eq!(reflector(&changed(&poses, sign), &seen), ["cell-change-sign"]);
    assert_eq!(reflector(&poses, &changed(&seen, |p| p.swap(1, 2))), ["cell-change-measured-mirrored"]);
}

/// Columns of another kind have no effect, and a column of texts, or without the letter, is no coordinate.
#[test]
fn columns_that_are_not_read_are_named() {
    let poses = touches(6, 0.7, 0.05);
    let text = table(&[columns("flange_", "quaternion", &poses)]);
    let named = text.replacen("flange_x_mm,flange_y_mm", "X,flange_y_mm", 1);
    let solve = ["--solve", "tool-point", "--column", "flange_x_mm=X"];
    assert!(document(&named, &solve).messages.is_empty());
    let rows = text.lines().enumerate().map(|(i, line)| format!("{line},{}\n", if i == 0 { "Rest" } else { "1" }));
    let found = document(&rows.collect::<String>(), &["--solve", "tool-point", "--column", "x_mm=Rest"]);
    assert_eq!(ids(&found), ["cell-columns-unused"]);
    let hint = |heading: &str, cell: &str| {
        let rows = text.lines().enumerate().map(|(i, line)| {
            let (_, rest) = line.split_once(',').unwrap();
            format!("{},{rest}", if i == 0 { heading } else { cell })
        });
        let answer = run(&rows.collect::<Vec<_>>().join("\n"), &["--solve", "tool-point"]);
        let missing = answer.messages.iter().find(|m| m.id == "column-unknown").unwrap();
        missing.hint.clone().unwrap_or_default().contains(&format!("`{heading}`, set"))
    };
    assert!(hint("X", "1.5") && hint("PosX", "1.5"));
    assert!(!hint("Punkt", "P1") && !hint("Punkt", "1") && !hint("X", "P1"));
}

/// Errors of 0.1 mm to 1 mm of a robot are no refutation, with the uncertainty of the instrument alone; rows of another recording
/// are one, with a stated uncertainty and without.
#[test]
fn residuals_beyond_any_plausible_uncertainty_refute_an_answer() {
    let solve = ["--solve", "tool-point"];
    let text = |poses: &[Pose]| table(&[columns("flange_", "quaternion", poses)]);
    for noise_mm in [0.1, 0.3, 1.0] {
        let poses = touches(12, 0.7, noise_mm);
        assert!(document(&text(&poses), &solve).messages.is_empty());
        let stated = document(&text(&poses), &[&solve[..], &["--standard-uncertainty-um", "30"]].concat());
        assert_eq!(ids(&stated), ["cell-noise-larger"], "{noise_mm}");
    }
    let poses = touches(12, 0.7, 0.05);
    let mixed: Vec<Pose> =
        (0..12).map(|i| Pose { translation_mm: poses[(i + 5) % 12].translation_mm, ..poses[i] }).collect();
    assert_eq!(unfit(&text(&mixed), &solve), ["cell-refuted"]);
    for um in ["30", "1000", "5000"] {
        assert_eq!(unfit(&text(&mixed), &[&solve[..], &["--standard-uncertainty-um", um]].concat()), ["cell-refuted"]);
    }
    // a stated uncertainty of this size explains everything
    // and leaves a tool of 184 mm with U of its own size
    let huge = unfit(&text(&mixed), &[&solve[..], &["--standard-uncertainty-um", "100000"]].concat());
    assert!(huge.iter().all(|id| id == "uncertainty-beyond-bound"), "{huge:?}");
    // orientations of another recording: positions of both sides agree
    let (poses, mut noise) = (spread(12), Noise::new(67, 0));
    let world = Pose::from_xyz_rpy([3000.0, -500.0, 900.0], [0.02, -0.01, 2.2]);
    let seen: Vec<Pose> = poses.iter().map(|p| noisy(&mut noise, &world.then(p).then(&tool()), 0.05, 2e-4)).collect();
    let turned: Vec<Pose> =
        (0..12).map(|i| Pose { translation_mm: seen[i].translation_mm, ..seen[(i + 5) % 12] }).collect();
    let text = table(&[columns("flange_", "quaternion", &poses), columns("", "quaternion", &turned)]);
    let found = unfit(&text, &["--solve", "hand-eye", "--mounting", "target"]);
    assert!(found.contains(&"cell-refuted-turned".to_owned()), "{found:?}");
}

#[test]
fn a_reflector_and_a_hand_are_found_and_slips_named() {
    let poses = spread(10);
    let world = Pose::from_xyz_rpy([3000.0, -500.0, 900.0], [0.02, -0.01, 2.2]);
    let mut noise = Noise::new(63, 0);
    let seen: Vec<Pose> = poses.iter().map(|p| noisy(&mut noise, &world.then(p).then(&tool()), 0.05, 2e-4)).collect();
    let at: Vec<Vector> = seen.iter().map(|p| p.translation_mm).collect();
    let flange = columns("flange_", "quaternion", &poses);
    let found = document(&table(&[flange.clone(), points("", &at)]), &["--solve", "tool-reflector"]);
    assert!(found.messages.is_empty() && norm(minus(found.points[0].xyz_mm, tool().translation_mm)) < 0.2, "{found:?}");
    assert!(norm(minus(found.frames[0].xyz_mm, world.translation_mm)) < 1.0);
    let metres: Vec<Vector> = at.iter().map(|p| p.map(|v| v / 1000.0)).collect();
    let named = changes(&table(&[flange.clone(), points("", &metres)]), &["--solve", "tool-reflector"]);
    assert_eq!(named, ["cell-change-unit"]);
    let target = ["--solve", "hand-eye", "--mounting", "target"];
    let found = document(&table(&[flange.clone(), columns("", "quaternion", &seen)]), &target);
    assert!(found.messages.is_empty() && found.frames[0].name == "tool", "{:?}", found.messages);
    assert!(norm(minus(found.frames[0].xyz_mm, tool().translation_mm)) < 0.2);
    assert!(norm(minus(found.frames[1].xyz_mm, world.inverse().translation_mm)) < 1.0);
    assert_eq!(found.noise.len(), 2);
    // the sensor measures the target: all measured poses are inverse
    let inverse: Vec<Pose> = seen.iter().map(Pose::inverse).collect();
    let text = table(&[flange.clone(), columns("", "quaternion", &inverse)]);
    let named = changes(&text, &target);
    assert!(named.contains(&"cell-change-inverse".to_owned()), "{named:?}");
    let text = table(&[flange, columns("", "fixed xyz", &seen)]);
    let named = changes(&text, &[&target[..], &["--measured-orientation", "zyx"]].concat());
    assert_eq!(named, ["order"]);
    let all: Vec<Pose> = poses.iter().map(|p| p.then(&tool()).inverse().then(&world)).collect();
    let seen: Vec<Pose> = all.iter().map(|p| noisy(&mut noise, p, 0.05, 2e-4)).collect();
    let text = table(&[columns("flange_", "zyx", &poses), columns("", "vector", &seen)]);
    let found = document(&text, &["--solve", "hand-eye", "--mounting", "sensor", "--orientation", "zyx"]);
    assert!(found.frames[0].name == "sensor" && norm(minus(found.frames[0].xyz_mm, tool().translation_mm)) < 2.0);
}

#[test]
fn objects_axes_and_tool_frames_are_found() {
    let mut noise = Noise::new(64, 0);
    let object = Pose::from_xyz_rpy([950.0, 120.0, 410.0], [0.01, -0.02, 0.5]);
    let known = [[0.0; 3], [400.0, 0.0, 0.0], [400.0, 250.0, 0.0], [0.0, 250.0, 0.0], [120.0, 60.0, 60.0]];
    let at: Vec<Vector> = known.iter().map(|p| object.apply(*p).map(|v| v + noise.gaussian(0.03))).collect();
    let text = table(&[points("nominal_", &known), points("", &at)]);
    let found = document(&text, &["--solve", "object"]);
    assert!(found.messages.is_empty() && norm(minus(found.frames[0].xyz_mm, object.translation_mm)) < 0.1);
    let mut swapped = at.clone();
    swapped.swap(1, 3);
    let text = table(&[points("nominal_", &known), points("", &swapped)]);
    assert_eq!(changes(&text, &["--solve", "object"]), ["cell-change-exchanged"]);
    let mirrored: Vec<Vector> = known.iter().map(|p| [p[0], -p[1], p[2]]).collect();
    let text = table(&[points("nominal_", &mirrored), points("", &at)]);
    assert_eq!(changes(&text, &["--solve", "object"]), ["cell-change-mirrored"]);
    let named = ["point", "origin", "x", "xy"].map(str::to_owned).to_vec();
    let text = table(&[named, points("", &[at[0], at[1], at[3]])]);
    let found = document(&text, &["--solve", "three-points", "--standard-uncertainty-um", "30"]);
    assert!(found.messages.is_empty() && norm(minus(found.frames[0].xyz_mm, at[0])) < 1e-6);
    assert!(found.frames[0].standard_uncertainty_deg.unwrap().iter().all(|u| *u > 1e-3 && *u < 2e-2));
    // tool axes
    let tips = touches(5, 0.7, 0.03);
    let mut rows: Vec<(&str, Pose)> = tips.iter().map(|p| ("tip", *p)).collect();
    for (name, place) in [("z", [0.0, 0.0, 120.0]), ("x", [80.0, 0.0, 0.0])] {
        let turn = Pose { translation_mm: [0.0; 3], ..tips[1] };
        rows.push((name, Pose { translation_mm: minus(FIXED, turn.rotate(tool().apply(place))), ..turn }));
    }
    let roles = std::iter::once("point".to_owned()).chain(rows.iter().map(|r| r.0.to_owned())).collect();
    let poses: Vec<Pose> = rows.iter().map(|r| r.1).collect();
    let found = document(&table(&[roles, columns("flange_", "quaternion", &poses)]), &["--solve", "tool-axes"]);
    let pose = Pose::from_quaternion(found.frames[0].quaternion);
    assert!(pose.inverse().then(&tool()).angle_rad() < 2e-3, "{found:?}");
    // external axes
    let values: Vec<f64> = (0..8).map(|i| f64::from(i) * 25.0).collect();
    let column =
        |name: &str| std::iter::once(name.to_owned()).chain(values.iter().map(f64::to_string)).collect::<Vec<_>>();
    let slid: Vec<Vector> =
        values.iter().map(|v| object.apply([1.0005 * v, 0.0, 0.0]).map(|c| c + noise.gaussian(0.01))).collect();
    let found = document(&table(&[column("axis_mm"), points("", &slid)]), &["--solve", "linear-axis"]);
    let axis = found.axis.unwrap();
    assert!((axis.scale - 1.0005).abs() < 4.0 * axis.scale_standard_uncertainty.unwrap() && found.messages.is_empty());
    let turned: Vec<Vector> = values
        .iter()
        .map(|v| object.turn_z(v.to_radians()).apply([300.0, 0.0, 0.0]).map(|c| c + noise.gaussian(0.01)))
        .collect();
    let text = table(&[column("axis_deg"), points("", &turned)]);
    let found = document(&text, &["--solve", "rotary-axis"]);
    assert!(norm(minus(found.frames[0].xyz_mm, object.translation_mm)) < 0.1 && found.messages.is_empty());
    // values in another unit
    let radians = document(&text.replace("axis_deg", "axis_rad"), &["--solve", "rotary-axis"]);
    assert!(radians.messages.iter().any(|m| m.id == "cell-scale"), "{:?}", radians.messages);
    let column = |name: &str| {
        std::iter::once(name.to_owned()).chain(values.iter().map(|v| v.to_radians().to_string())).collect::<Vec<_>>()
    };
    let degrees = document(&table(&[column("axis_deg"), points("", &turned)]), &["--solve", "rotary-axis"]);
    let scale = degrees.axis.as_ref().unwrap().scale;
    assert!(degrees.messages.iter().any(|m| m.id == "cell-scale") && (scale - 57.296).abs() < 0.01, "{scale}");
}

/// An axis at rest is named; a scale counts with its uncertainty.
#[test]
fn an_axis_at_rest_and_a_short_arc_are_told_from_a_wrong_scale() {
    let mut noise = Noise::new(66, 0);
    let column = |name: &str, values: &[f64]| {
        std::iter::once(name.to_owned()).chain(values.iter().map(f64::to_string)).collect::<Vec<_>>()
    };
    let at: Vec<Vector> = (0..9).map(|_| [600.0, 215.0, 290.0].map(|v| v + noise.gaussian(0.01))).collect();
    let answer = run(&table(&[column("axis_mm", &[500.0; 9]), points("", &at)]), &["--solve", "linear-axis"]);
    assert!(answer.code == 2 && answer.stderr.contains("error[cell-axis-at-rest]"), "{}", answer.stderr);
    let values: Vec<f64> = (0..13).map(|i| 0.25 * f64::from(i)).collect();
    let object = Pose::from_xyz_rpy([950.0, 120.0, 410.0], [0.01, -0.02, 0.5]);
    for _ in 0..10 {
        let turned = |v: &f64| object.turn_z(v.to_radians()).apply([300.0, 0.0, 0.0]).map(|c| c + noise.gaussian(0.01));
        let at: Vec<Vector> = values.iter().map(turned).collect();
        let answer = run(&table(&[column("axis_deg", &values), points("", &at)]), &["--solve", "rotary-axis"]);
        assert!(!answer.stderr.contains("cell-scale"), "{}", answer.stderr);
        let degrees: Vec<f64> = values.iter().map(|v| v.to_radians()).collect();
        let answer = run(&table(&[column("axis_deg", &degrees), points("", &at)]), &["--solve", "rotary-axis"]);
        assert!(answer.stderr.contains("cell-scale"), "{}", answer.stderr);
    }
}

#[test]
fn an_outlying_reading_is_named_by_its_line() {
    let mut poses = touches(10, 0.7, 0.02);
    poses[6].translation_mm[1] += 1.5;
    let text = table(&[columns("flange_", "quaternion", &poses)]);
    assert_eq!(unfit(&text, &["--solve", "tool-point"]), ["cell-outlier"]);
    let found = with_code(1, &text, &["--solve", "tool-point"]);
    let outlier = found.messages.iter().find(|m| m.id == "cell-outlier").unwrap();
    assert_eq!(outlier.arguments["line"], Argument::Whole(8));
}

#[test]
fn orientations_that_do_not_fit_are_named() {
    let (poses, mut noise) = (spread(10), Noise::new(65, 0));
    let world = Pose::from_xyz_rpy([3000.0, -500.0, 900.0], [0.02, -0.01, 2.2]);
    let mut seen: Vec<Pose> =
        poses.iter().map(|p| noisy(&mut noise, &world.then(p).then(&tool()), 0.05, 2e-4)).collect();
    let solve = ["--solve", "hand-eye", "--mounting", "target", "--standard-uncertainty-um", "50"];
    let flange = columns("flange_", "quaternion", &poses);
    let text = table(&[flange.clone(), columns("", "quaternion", &seen)]);
    let found = document(&text, &[&solve[..], &["--rotation-uncertainty-deg", "0.001"]].concat());
    assert!(found.messages.iter().any(|m| m.id == "cell-noise-larger-turned"), "{:?}", found.messages);
    assert_eq!(found.noise.iter().map(|n| n.uncertainties_from.as_str()).collect::<Vec<_>>(), ["stated", "residuals"]);
    seen[3] = seen[3].turn_x(0.02);
    let text = table(&[flange, columns("", "quaternion", &seen)]);
    let found = with_code(1, &text, &solve);
    let outlier = found.messages.iter().find(|m| m.id == "cell-outlier-turned").unwrap();
    assert_eq!(outlier.arguments["line"], Argument::Whole(5));
}

#[test]
fn data_of_controllers_are_printed() {
    let poses = touches(8, 0.7, 0.05);
    let text = table(&[columns("flange_", "quaternion", &poses)]);
    for (maker, part) in [
        ("abb", "PERS tooldata grip:=[TRUE,[["),
        ("kuka", "TOOL_DATA[1]={X "),
        ("fanuc", "UTOOL[1]=PR[1]"),
        ("ur", "set_tcp(p["),
    ] {
        let answer = run(&text, &["--solve", "tool-point", "--controller", maker, "--name", "grip"]);
        let shown = String::from_utf8(answer.stdout).unwrap();
        assert!(answer.code == 0 && shown.contains(part), "{maker}: {shown}{}", answer.stderr);
    }
}

#[test]
fn a_report_states_frames_residuals_and_lines_in_three_languages() {
    let poses = touches(8, 0.7, 0.05);
    let text = table(&[columns("flange_", "quaternion", &poses)]);
    let folder = tempfile::tempdir().unwrap();
    let [page, pdf, workbook] =
        ["cell.html", "cell.pdf", "cell.xlsx"].map(|n| folder.path().join(n).display().to_string());
    let solve = ["--solve", "tool-point", "--controller", "kuka", "--name", "grip", "--number", "4"];
    let kinds = [&solve[..], &["--report", &page, "--report", &pdf, "--report", &workbook]].concat();
    let answer = run(&text, &kinds);
    let lines = String::from_utf8(answer.stdout).unwrap();
    assert!(answer.code == 0 && lines.contains("TOOL_DATA[4]={X "), "{}", answer.stderr);
    let html = std::fs::read_to_string(&page).unwrap();
    let residual = document(&text, &solve[..2]).residuals[0].length;
    for part in [
        "Tool centre point",
        "tool point in flange",
        "fixed point in base",
        "Lines for kuka",
        "TOOL_NAME[4,]=",
        &format!("{residual:.4}"),
        "U = ",
    ] {
        assert!(html.contains(part), "{part}");
    }
    assert!(std::fs::read(&pdf).unwrap().starts_with(b"%PDF") && std::fs::read(&workbook).unwrap().starts_with(b"PK"));
    for (language, title, step) in
        [("fr", "Centre d’outil", "vérifier une lecture"), ("de", "Werkzeugmittelpunkt", "einen Messwert prüfen")]
    {
        let answer = run(&text, &[&solve[..], &["--report", &page, "--language", language]].concat());
        let html = std::fs::read_to_string(&page).unwrap();
        assert!(answer.code == 0 && html.contains(title) && html.contains(step), "{language}: {}", answer.stderr);
    }
    // without redundancy the uncertainty is unknown, and the page says so
    let three = table(&[
        ["point", "origin", "x", "xy"].map(str::to_owned).to_vec(),
        points("", &[[0.0; 3], [9.0, 0.0, 0.0], [1.0, 9.0, 0.0]]),
    ]);
    run(&three, &["--solve", "three-points", "--report", &page]);
    let html = std::fs::read_to_string(&page).unwrap();
    let unknown = etalon::base::phrase!("cell-verdict-unknown", frame = "Object in points").to_string();
    assert!(html.contains(&unknown) && html.has_phrase("cell-step-measure"), "{html}");
    // a format that does not exist is refused before anything is computed
    assert_eq!(run(&three, &["--solve", "three-points", "--report", "cell.doc"]).code, 2);
}

#[test]
fn two_axes_are_written_as_the_pivots_of_a_machine() {
    let values = [-50.0, -20.0, 0.0, 30.0, 55.0];
    let about = |k: usize, at: Vector, p: Vector, deg: f64| {
        let turn = match k {
            0 => Pose::identity().turn_x(f64::to_radians(deg)),
            _ => Pose::identity().turn_z(f64::to_radians(deg)),
        };
        let turned = turn.apply(minus(p, at));
        [0, 1, 2].map(|i| turned[i] + at[i])
    };
    let head = std::iter::once("axis_deg".to_owned());
    let column: Vec<String> = head.chain(values.iter().map(f64::to_string)).collect();
    let target = [400.0, 150.0, 60.0];
    let of = |k: usize, at: Vector| -> Vec<Vector> { values.iter().map(|v| about(k, at, target, *v)).collect() };
    let (c_at, a_at) = ([310.25, 205.5, 0.0], [0.0, 212.75, -31.5]);
    let answer = run(&table(&[column.clone(), points("", &of(2, c_at))]), &["--solve", "rotary-axis", "--json"]);
    let folder = tempfile::tempdir().unwrap();
    let second = folder.path().join("c.json");
    std::fs::write(&second, answer.stdout).unwrap();
    let tilted = table(&[column, points("", &of(0, a_at))]);
    let with = second.display().to_string();
    let arguments = ["--solve", "rotary-axis", "--with", &with, "--controller", "xyzac-trt-kins"];
    let answer = run(&tilted, &arguments);
    let hal = String::from_utf8(answer.stdout).unwrap();
    for line in [
        "setp xyzac-trt-kins.x-rot-point 310.250000\n",
        "setp xyzac-trt-kins.y-rot-point 205.500000\n",
        "setp xyzac-trt-kins.z-rot-point -31.500000\n",
        "setp xyzac-trt-kins.y-offset 7.250000\n",
    ] {
        assert!(hal.contains(line), "{line}{hal}{}", answer.stderr);
    }
    // another document, and a file that is missing
    std::fs::write(&second, "{\"schema\": \"etalon/parameters/1\"}").unwrap();
    let answer = run(&tilted, &arguments);
    assert!(answer.code == 2 && answer.messages[0].id == "document-schema-other", "{}", answer.stderr);
}

/// The message about a component beyond its bound: exit code 1, and no data for a controller.
fn beyond(table: &str, arguments: &[&str], maker: &str) -> etalon::base::message::Message {
    let found = with_code(1, table, arguments);
    let withheld = run(table, &[arguments, &["--controller", maker]].concat());
    assert!(withheld.code == 1 && withheld.stdout.is_empty(), "{}", withheld.stderr);
    let message = found.errors().find(|m| m.id == "uncertainty-beyond-bound");
    message.unwrap_or_else(|| panic!("{:?}", ids(&found))).clone()
}

/// Id of the phrase in an argument.
fn phrase_id(message: &etalon::base::message::Message, argument: &str) -> String {
    let Argument::Phrase(phrase) = &message.arguments[argument] else { panic!("{message:?}") };
    phrase.id.to_string()
}

/// x touched 0.03 mm from the origin: the direction of x is open (U of 135 deg and more).
#[test]
fn three_points_that_hardly_differ_are_not_loadable() {
    let touched = |x: f64| format!("point,x_mm,y_mm,z_mm\norigin,100,200,50\nx,{x},200.01,50\nxy,100,300,50\n");
    let solve = ["--solve", "three-points", "--standard-uncertainty-um", "50"];
    let message = beyond(&touched(100.03), &solve, "kuka");
    assert_eq!(phrase_id(&message, "component"), "bound-rotation");
    assert_eq!(phrase_id(&message, "cause"), "bound-open-rotation");
    // without a statement a fine instrument is assumed
    let unstated = with_code(1, &touched(100.03), &["--solve", "three-points"]);
    assert!(ids(&unstated).iter().any(|id| id == "uncertainty-beyond-bound"), "{unstated:?}");
    assert!(unstated.frames[0].covariance.is_none(), "nothing shows the uncertainty");
    // sound: a small work piece, a large one, and collinear points of the old threshold
    document(&touched(600.0), &solve);
    let small = "point,x_mm,y_mm,z_mm\norigin,100,200,50\nx,105,200,50\nxy,101,204,50\n";
    document(small, &["--solve", "three-points"]);
    document(small, &solve);
    let narrow = "point,x_mm,y_mm,z_mm\norigin,0,0,0\nx,1000,0,0\nxy,500,0.9,0\n";
    document(narrow, &["--solve", "three-points", "--standard-uncertainty-um", "1"]);
    assert_eq!(phrase_id(&beyond(narrow, &solve, "abb"), "cause"), "bound-open-rotation");
}

/// A target on the axis: its direction and x axis are open (34 to 40 deg).
#[test]
fn a_target_on_the_axis_does_not_make_a_rotary_axis() {
    let mut noise = Noise::new(71, 0);
    let mut turned = |radius: f64| {
        let at = (0..12).map(|i| {
            let angle = f64::from(i) * 30f64.to_radians();
            [600.0 + radius * angle.cos(), radius * angle.sin() - 200.0, 110.0].map(|v| v + noise.gaussian(0.01))
        });
        let all: Vec<Vector> = at.collect();
        let values = std::iter::once("axis_deg".to_owned()).chain((0..12).map(|i| format!("{}", 30 * i)));
        table(&[values.collect(), points("", &all)])
    };
    let solve = ["--solve", "rotary-axis"];
    let on_axis = turned(0.005);
    beyond(&on_axis, &solve, "abb-moc");
    let stated = run(&on_axis, &["--solve", "rotary-axis", "--uncertainty-bound", "200 deg, 5 mm", "--json"]);
    let found: CellDocument = serde_json::from_slice(&stated.stdout).unwrap();
    assert!(found.errors().all(|m| m.id != "uncertainty-beyond-bound" || phrase_id(m, "component") == "bound-ratio"));
    document(&turned(40.0), &solve);
    // a stated bound is stricter than the default
    let strict = with_code(1, &turned(40.0), &[&solve[..], &["--uncertainty-bound", "1 um"]].concat());
    assert!(strict.errors().any(|m| m.is("uncertainty-beyond-bound", &[("source", &"stated")])), "{:?}", ids(&strict));
    let unreadable = run(&turned(40.0), &[&solve[..], &["--uncertainty-bound", "0.5"]].concat());
    assert_eq!(unreadable.code, 2, "{}", unreadable.stderr);
}

/// Orientations that differ by 0.1 deg: the tool point is open (13 mm).
#[test]
fn orientations_that_hardly_differ_do_not_make_a_tool_point() {
    let pivot = |turn_deg: f64| table(&[columns("flange_", "quaternion", &touches(10, turn_deg.to_radians(), 0.02))]);
    let solve = ["--solve", "tool-point"];
    let message = beyond(&pivot(0.1), &solve, "kuka");
    assert_eq!(phrase_id(&message, "cause"), "bound-open-translation");
    // few degrees suffice where the touches are good
    document(&pivot(8.0), &solve);
}

#[test]
fn all_missing_columns_of_a_problem_are_named_at_once() {
    let three = |prefix: &str| ["x_mm", "y_mm", "z_mm"].map(|name| format!("{prefix}{name}")).to_vec();
    let flange = [three("flange_"), vec!["cell-orientation-missing".to_owned()]].concat();
    let own = |name: &str| vec![name.to_owned()];
    let problems = [
        ("tool-point", flange.clone()),
        ("tool-reflector", [flange.clone(), three("")].concat()),
        ("tool-axes", [own("point"), flange.clone()].concat()),
        ("hand-eye", [own("cell-mounting-missing"), flange, three(""), own("cell-orientation-missing")].concat()),
        ("object", [three("nominal_"), three("")].concat()),
        ("three-points", [own("point"), three("")].concat()),
        ("rotary-axis", [own("cell-axis-missing"), three("")].concat()),
    ];
    for (problem, expected) in problems {
        let answer = run("note\na\n", &["--solve", problem]);
        let named = answer.messages.iter().map(|m| match m.arguments.get("column") {
            Some(Argument::Text(column)) if m.id == "column-unknown" => column.to_string(),
            _ => m.id.to_string(),
        });
        assert_eq!(named.collect::<Vec<_>>(), expected, "{problem}");
    }
}
