//! Data of controllers, read back by readers that share nothing with the writers.

use super::*;
use etalon_base::pose::minus;
use etalon_documents::{CellAxisEntry, CellFrameEntry, Provenance};
use std::collections::BTreeMap;

fn options() -> CellOptions {
    CellOptions { name: "grip-1".to_owned(), number: 3, ..CellOptions::default() }
}

/// Text of a format; panics if the format rejects the answer.
fn written(maker: &str, document: &CellDocument, options: &CellOptions) -> CellText {
    write(by_name(maker).unwrap(), document, options).unwrap_or_else(|refused| panic!("{maker}: {refused:?}"))
}

/// Id of the refusal of a format.
fn refused(maker: &str, document: &CellDocument, options: &CellOptions) -> String {
    write(by_name(maker).unwrap(), document, options).unwrap_err().0[0].id.to_string()
}

/// Answer of a rotary axis through `through`, with its first target at `target` at zero.
fn axis(direction: Vector, through: Vector, target: Vector) -> CellDocument {
    let z = etalon_base::pose::unit(direction).unwrap();
    let from = minus(target, through);
    let along = etalon_base::pose::dot(from, z);
    let foot = [0, 1, 2].map(|k| through[k] + along * z[k]);
    let arm = minus(target, foot);
    let x = etalon_base::pose::unit(arm).unwrap();
    let y = etalon_base::pose::cross(z, x);
    let pose = Pose { translation_mm: foot, rotation: [0, 1, 2].map(|i| [x[i], y[i], z[i]]) };
    let mut found = document("rotary-axis", &pose);
    found.frames[0].name = "axis".to_owned();
    found.frames[0].reference = "points".to_owned();
    found.frames[0].standard_uncertainty_deg = Some([0.0005; 3]);
    found.axis = Some(CellAxisEntry {
        prismatic: false,
        direction: z,
        direction_covariance: None,
        scale: 1.0,
        scale_standard_uncertainty: Some(1e-6),
        radius_mm: Some(norm(arm)),
    });
    found
}

fn document(solve: &str, pose: &Pose) -> CellDocument {
    let frame = CellFrameEntry {
        name: "tool".to_owned(),
        reference: "flange".to_owned(),
        xyz_mm: pose.translation_mm,
        quaternion: pose.quaternion(),
        standard_uncertainty_mm: Some([0.011, 0.012, 0.013]),
        standard_uncertainty_deg: Some([0.021, 0.022, 0.023]),
        covariance: None,
    };
    CellDocument {
        schema: "etalon/cell/1".to_owned(),
        provenance: Provenance { version: "0".to_owned(), inputs: BTreeMap::new(), seed: None },
        solve: solve.to_owned(),
        readings: 8,
        frames: vec![frame],
        points: Vec::new(),
        axis: None,
        noise: Vec::new(),
        residuals: Vec::new(),
        messages: Vec::new(),
    }
}

/// Numbers of a text in their order.
fn numbers(text: &str) -> Vec<f64> {
    text.split(|c: char| !(c.is_ascii_digit() || "+-.e".contains(c))).filter_map(|t| t.parse().ok()).collect()
}

/// Rotation matrix of elementary rotations, written out.
fn rotation(axis: char, deg: f64) -> [[f64; 3]; 3] {
    let (s, c) = deg.to_radians().sin_cos();
    match axis {
        'x' => [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
        'y' => [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
        _ => [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
    }
}

fn product(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

fn zyx(z: f64, y: f64, x: f64) -> [[f64; 3]; 3] {
    product(product(rotation('z', z), rotation('y', y)), rotation('x', x))
}

/// Position (mm) and rotation matrix of the data of a maker.
fn read(maker: &str, text: &str) -> (Vector, [[f64; 3]; 3]) {
    let line = |start: &str| text.lines().map(str::trim).find(|l| l.starts_with(start)).unwrap_or_default().to_owned();
    match maker {
        "abb" => {
            let data = line("PERS");
            let n = numbers(data.split_once(":=").unwrap().1);
            let [w, x, y, z] = [n[3], n[4], n[5], n[6]];
            assert!((w * w + x * x + y * y + z * z - 1.0).abs() < 1e-9);
            let rotation = [
                [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
                [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
                [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z],
            ];
            ([n[0], n[1], n[2]], rotation)
        }
        "kuka" => {
            let data = line("TOOL_DATA[3]") + &line("BASE_DATA[3]");
            let n = numbers(data.split_once('=').unwrap().1);
            ([n[0], n[1], n[2]], zyx(n[3], n[4], n[5]))
        }
        "fanuc" => {
            let element = |i: usize| {
                let start = format!("PR[3,{i}]=");
                let row = text.lines().find(|l| l.contains(&start)).unwrap();
                numbers(row.split_once(&start).unwrap().1)[0]
            };
            assert!(text.contains("UTOOL[3]=PR[3]") || text.contains("UFRAME[3]=PR[3]"));
            ([1, 2, 3].map(element), zyx(element(6), element(5), element(4)))
        }
        "yaskawa" => {
            let lines: Vec<&str> = text.lines().collect();
            assert_eq!(lines[..2], ["//TOOL 3", "///NAME grip_1"]);
            assert_eq!(lines[3..], ["0.000,0.000,0.000", "0.000", "0.000,0.000,0.000", "0.000,0,1"]);
            let n: Vec<f64> = lines[2].split(',').map(|v| v.parse().unwrap()).collect();
            ([n[0], n[1], n[2]], zyx(n[5], n[4], n[3]))
        }
        "abb-moc" => {
            let attributes =
                text.lines().filter(|l| !l.starts_with('#')).collect::<Vec<_>>().join(" ").replace('\\', " ");
            let value = |name: &str| -> f64 {
                let rest = attributes.split_once(&format!("-base_frame_{name} ")).unwrap().1;
                rest.split_whitespace().next().unwrap().parse().unwrap()
            };
            assert!(attributes.contains("-name \"grip_1\""), "{text}");
            let [w, x, y, z] = ["u0", "u1", "u2", "u3"].map(|u| value(&format!("orient_{u}")));
            let matrix = [
                [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
                [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
                [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
            ];
            (["x", "y", "z"].map(|axis| 1000.0 * value(&format!("pos_{axis}"))), matrix)
        }
        "kuka machine" => {
            let data = line("MACHINE_DEF[3]={NAME[] \"grip_1\",COOP_KRC_INDEX 1,PARENT[] \"WORLD\",ROOT {");
            let (root, rest) = data.split_once("ROOT {").unwrap().1.split_once('}').unwrap();
            assert_eq!(rest, ",MECH_TYPE #EBSYS,GEOMETRY[] \" \"}");
            let n = numbers(root);
            ([n[0], n[1], n[2]], zyx(n[3], n[4], n[5]))
        }
        _ => {
            let data = line("set_tcp(p[") + &line("global");
            let n = numbers(data.split_once("p[").unwrap().1);
            let v = [n[3], n[4], n[5]];
            let angle = norm(v);
            // Rodrigues
            let k = [[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]];
            let square = product(k, k);
            let (a, b) = (angle.sin() / angle, (1.0 - angle.cos()) / (angle * angle));
            let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
            let rotation =
                std::array::from_fn(|i| std::array::from_fn(|j| unit(i, j) + a * k[i][j] + b * square[i][j]));
            ([n[0], n[1], n[2]].map(|v| 1000.0 * v), rotation)
        }
    }
}

#[test]
fn data_read_back_are_the_frame() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let poses = [
        Pose::from_xyz_rpy([12.5, -0.004, 150.25], [0.3, -0.7, 2.9]),
        Pose::from_xyz_rpy([-1200.0, 30.0, 0.5], [-3.0, 1.1, -0.2]),
        // a pitch of a right angle
        Pose::from_xyz_rpy([1.0, 2.0, 3.0], [0.4, quarter, 0.0]),
        Pose::from_xyz_rpy([1.0, 2.0, 3.0], [0.4, -quarter, 0.1]),
    ];
    let held = |solve: &str, maker: &str| match maker {
        "yaskawa" => matches!(solve, "hand-eye" | "tool-axes"),
        "abb-moc" => matches!(solve, "object" | "three-points"),
        _ => true,
    };
    for (pose, solve) in poses.iter().zip(["hand-eye", "object", "tool-axes", "three-points"]) {
        let found = document(solve, pose);
        for maker in ["abb", "abb-moc", "kuka", "fanuc", "ur", "yaskawa"] {
            if !held(solve, maker) {
                assert_eq!(refused(maker, &found, &options()), "cell-no-controller-data");
                continue;
            }
            let text = written(maker, &found, &options()).text;
            let (at, rotation) = read(maker, &text);
            // TOOL.CND has three decimals of mm and four of deg
            let [mm, rad] = if maker == "yaskawa" { [9e-4, 3e-6] } else { [9e-5, 3e-8] };
            assert!(norm(minus(at, pose.translation_mm)) < mm, "{maker}: {text}");
            let off = (0..9).map(|k| (rotation[k / 3][k % 3] - pose.rotation[k / 3][k % 3]).abs()).fold(0.0, f64::max);
            assert!(off < rad, "{maker}: {off}\n{text}");
            let states = text.contains("0.011000") || matches!(maker, "fanuc" | "yaskawa");
            assert!(states, "{maker} states the uncertainty: {text}");
        }
    }
    for maker in names() {
        assert_eq!(refused(maker, &document("linear-axis", &poses[0]), &options()), "cell-no-controller-data");
    }
    assert_eq!(written("yaskawa", &document("hand-eye", &poses[0]), &options()).messages[0].id, "cell-loads-replaced");
}

#[test]
fn a_rotary_axis_is_the_base_frame_of_its_unit() {
    let found = axis([0.1, -0.2, 1.0], [1500.0, -700.0, 20.0], [1700.0, -650.0, 333.0]);
    let pose = Pose { translation_mm: found.frames[0].xyz_mm, ..Pose::from_quaternion(found.frames[0].quaternion) };
    for (maker, reader, kind) in [("abb-moc", "abb-moc", "SINGLE:"), ("kuka", "kuka machine", "; z of ROOT")] {
        let text = written(maker, &found, &options()).text;
        let (at, rotation) = read(reader, &text);
        assert!(norm(minus(at, pose.translation_mm)) < 9e-5 && text.contains(kind), "{text}");
        let off = (0..9).map(|k| (rotation[k / 3][k % 3] - pose.rotation[k / 3][k % 3]).abs()).fold(0.0, f64::max);
        assert!(off < 3e-8, "{maker}: {off}\n{text}");
    }
    // the robot itself, and more kinematics than the controller has
    for number in [0, 1, 8] {
        assert_eq!(refused("kuka", &found, &CellOptions { number, ..options() }), "cell-machine-number");
    }
    // the base of the robot of a reflector's readings
    let mut reflector = document("tool-reflector", &pose);
    (reflector.frames[0].name, reflector.frames[0].reference) = ("base".to_owned(), "world".to_owned());
    let text = written("abb-moc", &reflector, &options()).text;
    assert!(text.contains("ROBOT:") && norm(minus(read("abb-moc", &text).0, pose.translation_mm)) < 9e-5, "{text}");
}

/// Value of a `setp` line.
fn pin(text: &str, name: &str) -> f64 {
    let start = format!("setp {name} ");
    text.lines().find_map(|l| l.strip_prefix(&start)).map_or(0.0, |v| v.parse().unwrap())
}

fn times(m: [[f64; 3]; 3], v: Vector) -> Vector {
    [0, 1, 2].map(|i| (0..3).map(|k| m[i][k] * v[k]).sum())
}

/// Joint positions of `xyzac-trt-kins` and `xyzbc-trt-kins` by the terms of trtfuncs.c
/// (`xyzacKinematicsInverse`, `xyzbcKinematicsInverse`), without a tool.
fn trt_joints(text: &str, kins: &str, w: Vector, tilt_deg: f64, c_deg: f64) -> Vector {
    let of = |name: &str| pin(text, &format!("{kins}.{name}"));
    let con = if of("conventional-directions") == 1.0 { -1.0 } else { 1.0 };
    let ((sa, ca), (sc, cc)) = ((con * tilt_deg).to_radians().sin_cos(), (con * c_deg).to_radians().sin_cos());
    let [xr, yr, zr] = ["x", "y", "z"].map(|axis| of(&format!("{axis}-rot-point")));
    let [dx, dy, dz] = ["x", "y", "z"].map(|axis| of(&format!("{axis}-offset")));
    let [x, y, z] = [w[0] - xr, w[1] - yr, w[2] - zr];
    if kins == "xyzac-trt-kins" {
        [
            cc * x - sc * y + xr,
            sc * ca * x + cc * ca * y - sa * z - ca * dy + sa * dz + dy + yr,
            sc * sa * x + cc * sa * y + ca * z - sa * dy - ca * dz + dz + zr,
        ]
    } else {
        let (dpx, dpz) = (-ca * dx - sa * dz + dx, sa * dx - ca * dz + dz);
        [
            cc * ca * x - sc * ca * y + sa * z + dpx + xr,
            sc * x + cc * y + yr,
            -cc * sa * x + sc * sa * y + ca * z + dpz + zr,
        ]
    }
}

/// A point on the table at zero, moved by both axes: the table about its axis, then both by the
/// tilting axis, each through its point.
fn moved(w: Vector, [c_at, tilt_at]: [Vector; 2], axis: char, sense: f64, [tilt, c]: [f64; 2]) -> Vector {
    let about = |m: [[f64; 3]; 3], at: Vector, v: Vector| {
        let turned = times(m, minus(v, at));
        [0, 1, 2].map(|k| turned[k] + at[k])
    };
    let on_table = about(rotation('z', sense * c), c_at, w);
    about(rotation(axis, sense * tilt), tilt_at, on_table)
}

/// Positions of the tool that follow a point of the table, as the formulas of LinuxCNC and grblHAL
/// compute them from the written pivots.
#[test]
fn pivots_of_tilting_tables_move_the_tool_with_the_part() {
    let (c_at, w) = ([310.25, 205.5, 40.0], [350.0, 180.0, 95.0]);
    for (kins, letter, k, tilt_at) in
        [("xyzac-trt-kins", 'x', 0, [0.0, 212.75, -31.5]), ("xyzbc-trt-kins", 'y', 1, [305.125, 0.0, -31.5])]
    {
        for sense in [1.0, -1.0] {
            let mut along = [0.0; 3];
            along[k] = sense;
            let table = axis([0.0, 0.0, sense], c_at, [400.0, 205.5, 60.0]);
            let second = axis(along, tilt_at, [400.0, 300.0, 60.0]);
            for (first, second) in [(&table, &second), (&second, &table)] {
                let options = CellOptions { second: Some(second.clone()), ..options() };
                let found = written(kins, first, &options);
                assert!(found.messages.is_empty(), "{:?}", found.messages);
                for angles in [[0.0, 0.0], [25.0, 0.0], [0.0, -130.0], [-40.0, 77.0]] {
                    let seen = moved(w, [c_at, tilt_at], letter, sense, angles);
                    let joints = trt_joints(&found.text, kins, w, angles[0], angles[1]);
                    assert!(norm(minus(seen, joints)) < 1e-5, "{kins} {sense} {angles:?}: {seen:?} {joints:?}");
                }
                if kins == "xyzac-trt-kins" && sense > 0.0 {
                    grblhal_follows(first, &options, [c_at, tilt_at], w);
                }
            }
        }
    }
}

/// `rtcp_forward` of grblHAL's rtcp_ac.c, with a frame of the part as `rtcp_ac_measure` takes it.
fn grblhal_follows(first: &CellDocument, options: &CellOptions, at: [Vector; 2], w: Vector) {
    let text = written("grblhal", first, options).text;
    let setting =
        |n: usize| -> f64 { text.lines().find_map(|l| l.strip_prefix(&format!("${n}="))).unwrap().parse().unwrap() };
    let (a, c) = ([640, 641, 642].map(setting), [643, 644, 645].map(setting));
    let p = [0, 1, 2].map(|k| w[k] - a[k] - c[k]);
    for [tilt, turn] in [[0.0, 0.0], [25.0, 0.0], [-40.0, 77.0]] {
        let turned = times(rotation('z', turn), p);
        let tilted = times(rotation('x', tilt), [0, 1, 2].map(|k| turned[k] + c[k]));
        let seen = moved(w, at, 'x', 1.0, [tilt, turn]);
        assert!(norm(minus(seen, [0, 1, 2].map(|k| tilted[k] + a[k]))) < 2e-3, "{text}");
    }
}

#[test]
fn pivot_lengths_of_tilting_heads_hold_the_end_of_the_tool() {
    // a target at the end of a tool of 80 mm, 250.5 mm below the axis B
    let (pivot, tool_mm, length) = ([120.0, -40.0, 600.0], 80.0, 250.5);
    for (sense, kins) in [(-1.0, "maxkins"), (1.0, "maxkins"), (-1.0, "5axiskins")] {
        let found = axis([0.0, sense, 0.0], pivot, [120.0, -40.0, 600.0 - length]);
        let options = CellOptions { tool_length_mm: Some(tool_mm), ..options() };
        let text = written(kins, &found, &options).text;
        let l = pin(&text, &format!("{kins}.pivot-length")) + tool_mm;
        // maxkins.c, max_forward with joints[8] the tool, and 5axiskins.c, s2r, for C = 0
        let con = if pin(&text, "maxkins.conventional-directions") == 1.0 { 1.0 } else { -1.0 };
        for b in [-30.0f64, 0.0, 47.0] {
            let (s, c) = b.to_radians().sin_cos();
            let tip = [-con * l * s, l - l * c];
            let target = times(rotation('y', sense * b), [0.0, 0.0, -length]);
            assert!((tip[0] - target[0]).abs() < 1e-5 && (tip[1] - l - target[2]).abs() < 1e-5, "{kins} {b} {text}");
        }
    }
}

#[test]
fn wrong_axes_of_machines_are_refused() {
    let table = axis([0.0, 0.0, 1.0], [310.0, 205.0, 0.0], [400.0, 205.0, 60.0]);
    let tilting = |direction| axis(direction, [0.0, 212.0, -31.0], [400.0, 300.0, 60.0]);
    let with = |second: &CellDocument| CellOptions { second: Some(second.clone()), ..options() };
    let a = tilting([1.0, 0.0, 0.0]);
    assert_eq!(refused("xyzac-trt-kins", &table, &options()), "cell-second-axis-missing");
    assert_eq!(refused("grblhal", &a, &options()), "cell-second-axis-missing");
    // the kinematics of another machine, and points in another frame
    assert_eq!(refused("xyzbc-trt-kins", &table, &with(&a)), "cell-axis-direction");
    assert_eq!(refused("xyzac-trt-kins", &table, &with(&tilting([1.0, 0.2, 0.0]))), "cell-axis-direction");
    assert_eq!(refused("xyzac-trt-kins", &table, &with(&table)), "cell-axis-direction");
    let back = tilting([-1.0, 0.0, 0.0]);
    assert_eq!(refused("xyzac-trt-kins", &table, &with(&back)), "cell-axis-sense");
    let negative = axis([0.0, 0.0, -1.0], [310.0, 205.0, 0.0], [400.0, 205.0, 60.0]);
    assert_eq!(refused("grblhal", &negative, &with(&back)), "cell-axis-sense");
    // a small tilt is given, one within its uncertainty is not
    let leaning = written("xyzac-trt-kins", &table, &with(&tilting([1.0, 0.0, 0.002])));
    assert_eq!(leaning.messages[0].id, "cell-axis-tilted");
    assert!(written("xyzac-trt-kins", &table, &with(&tilting([1.0, 0.0, 2e-5]))).messages.is_empty());
    let head = |direction| axis(direction, [120.0, -40.0, 600.0], [120.0, -40.0, 350.0]);
    let tool = |mm| CellOptions { tool_length_mm: Some(mm), ..options() };
    assert_eq!(refused("maxkins", &head([0.0, -1.0, 0.0]), &options()), "cell-tool-length-missing");
    assert_eq!(refused("maxkins", &head([0.0, -1.0, 0.0]), &tool(900.0)), "cell-pivot-above");
    assert_eq!(refused("maxkins", &head([1.0, 0.0, 0.0]), &tool(80.0)), "cell-axis-direction");
    assert_eq!(refused("5axiskins", &head([0.0, 1.0, 0.0]), &tool(80.0)), "cell-axis-sense");
}

#[test]
fn names_are_those_of_the_language() {
    let options = CellOptions { name: "1 grip; ! \"x\"".to_owned(), number: 2, ..CellOptions::default() };
    let found = document("hand-eye", &Pose::identity());
    let abb = written("abb", &found, &options).text;
    assert!(abb.contains("PERS tooldata P1_grip_____x_:=[TRUE,[["), "{abb}");
    let fanuc = written("fanuc", &found, &options).text;
    assert!(fanuc.lines().all(|line| line.len() < 60), "{fanuc}");
    assert!(fanuc.contains("0.011000") || fanuc.replace([' ', '\n', ';', '!', ':'], "").contains("0.0110"), "{fanuc}");
}
