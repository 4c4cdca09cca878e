//! Candidates that `etalon plan --generate` draws, their order, and measuring programs: everything is computed again here.

use super::{etalon, text_of};
use crate::support::root;
use crate::support::said::Says;
use etalon::base::pose::{cross, dot, minus, norm};
use etalon::controllers::commands::{Freedoms, language};
use etalon::documents::PlanDocument;
use std::collections::BTreeMap;
use std::path::Path;

/// Modified Denavit-Hartenberg parameters of an arm like an ABB IRB 120, with limits (deg).
const ARM: [[f64; 6]; 6] = [
    [0.0, 0.0, 0.0, 290.0, -165.0, 165.0],
    [-90.0, 0.0, -90.0, 0.0, -110.0, 110.0],
    [0.0, 270.0, 0.0, 0.0, -110.0, 70.0],
    [-90.0, 70.0, 0.0, 302.0, -160.0, 160.0],
    [90.0, 0.0, 0.0, 0.0, -120.0, 120.0],
    [-90.0, 0.0, 180.0, 72.0, -400.0, 400.0],
];

fn arm(rest: &str) -> String {
    let joint = |[alpha, a, theta, d, lower, upper]: &[f64; 6]| {
        format!(
            "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}\nlimits_deg = [{lower:?}, {upper:?}]\n"
        )
    };
    format!("name = \"Arm\"\nmodel = \"serial\"\n{rest}{}", ARM.iter().map(joint).collect::<String>())
}

/// Rotation (rows) and translation of the flange in the base by Craig's convention: Rx(alpha) Tx(a) Rz(theta + q) Tz(d).
fn flange(q_deg: &[f64]) -> ([[f64; 3]; 3], [f64; 3]) {
    flange_of(&ARM, q_deg)
}

fn flange_of(rows: &[[f64; 6]], q_deg: &[f64]) -> ([[f64; 3]; 3], [f64; 3]) {
    let (mut r, mut t) = ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]);
    for (row, q) in rows.iter().zip(q_deg) {
        let ((sa, ca), (st, ct)) = (row[0].to_radians().sin_cos(), (row[2] + q).to_radians().sin_cos());
        let step = [[ct, -st, 0.0], [st * ca, ct * ca, -sa], [st * sa, ct * sa, ca]];
        let shift = [row[1], -sa * row[3], ca * row[3]];
        t = std::array::from_fn(|i| t[i] + dot(r[i], shift));
        r = r.map(|of| std::array::from_fn(|j| (0..3).map(|k| of[k] * step[k][j]).sum()));
    }
    (r, t)
}

fn at(q_deg: &[f64], point: [f64; 3]) -> [f64; 3] {
    let (r, t) = flange(q_deg);
    std::array::from_fn(|i| t[i] + dot(r[i], point))
}

fn copy_robot(sample: &str, folder: &Path) {
    let robot = root().join("samples").join(sample).join("robot.toml");
    std::fs::copy(robot, folder.join("robot.toml")).unwrap();
}

/// Answer of `etalon plan` in the folder as a document, with all `count` candidates chosen.
fn all_of(folder: &Path, count: &str, options: &[&str]) -> PlanDocument {
    let fixed = ["plan", "--robot", "robot.toml", "--generate", count, "--positions", count, "--json"];
    let effort = ["--nodes", "0", "--starts", "0"];
    let answered = etalon(folder, &[&fixed[..], &effort, options].concat());
    assert!(answered.status.success(), "{}", text_of(&answered));
    serde_json::from_slice(&answered.stdout).unwrap()
}

fn joints_of(values: &BTreeMap<String, f64>, columns: &[&str]) -> Vec<f64> {
    columns.iter().map(|column| values[*column]).collect()
}

const Q: [&str; 6] = ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg"];
const SIGHT: [&str; 10] = [
    "--range",
    "q2_deg=-60:45",
    "--box",
    "x=150:600,y=-400:300,z=100:700",
    "--reflector",
    "A=30,0,60,0,1,1,45",
    "--reflector",
    "B=-30,10,60",
    "--instrument",
    "2500,-400,600",
];

#[test]
fn generated_candidates_of_an_arm_obey_limits_ranges_box_and_line_of_sight() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), arm("")).unwrap();
    let found = all_of(folder.path(), "30", &SIGHT);
    assert_eq!(found, all_of(folder.path(), "30", &SIGHT));
    let other = all_of(folder.path(), "30", &[&SIGHT[..], &["--seed", "2"]].concat());
    assert_ne!(found.choice.chosen, other.choice.chosen);
    let half = 45f64.to_radians();
    for planned in found.choice.chosen.iter().chain(&other.choice.chosen) {
        let q = joints_of(&planned.configurations[0], &Q);
        for (k, (q, row)) in q.iter().zip(&ARM).enumerate() {
            let [lower, upper] = if k == 1 { [-60.0, 45.0] } else { [row[4], row[5]] };
            assert!((lower..=upper).contains(q), "q{}: {q}", k + 1);
        }
        let [a, b] = [[30.0, 0.0, 60.0], [-30.0, 10.0, 60.0]].map(|point| at(&q, point));
        for p in [a, b] {
            let inside = p.iter().zip([[150.0, 600.0], [-400.0, 300.0], [100.0, 700.0]]);
            assert!(inside.into_iter().all(|(v, [lower, upper])| (lower..=upper).contains(v)), "{p:?}");
        }
        let axis = minus(at(&q, [30.0, 1.0, 61.0]), a);
        let to_instrument = minus([2500.0, -400.0, 600.0], a);
        let angle = norm(cross(axis, to_instrument)).atan2(dot(axis, to_instrument));
        assert!(angle <= half + 1e-9, "{} deg", angle.to_degrees());
    }
    // the first target of each candidate, by the program and by this test
    for (place, planned) in found.places.iter().zip(&found.choice.chosen) {
        let here = at(&joints_of(&planned.configurations[0], &Q), [30.0, 0.0, 60.0]);
        assert!(norm(minus(place.at_mm, here)) < 1e-6, "{here:?} {place:?}");
    }
    let generated = found.choice.generated.unwrap();
    let lost = generated.beyond_limits + generated.outside_box + generated.facing_away;
    assert_eq!(generated.draws, 30 + lost);
    assert!(generated.outside_box > 0 && generated.facing_away > 0, "{generated:?}");
    assert_eq!(generated.ranges["q2_deg"].map(f64::round), [-60.0, 45.0]);
}

/// Joint values (deg, mm) of all motions of a program: its own reading of the text, line by line.
fn motions(program: &str) -> Vec<Vec<f64>> {
    let numbers = |text: &str| -> Vec<f64> {
        let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || ".+-".contains(c)));
        words.filter_map(|word| word.parse().ok()).collect()
    };
    let of_line = |line: &str| {
        let line = line.trim();
        if let Some(rest) = line.strip_prefix("MoveAbsJ [[") {
            let (arm, rest) = rest.split_once("],[").unwrap();
            let external = numbers(rest.split_once("]]").unwrap().0).into_iter().filter(|v| *v < 9e8);
            return Some(external.chain(numbers(arm)).collect());
        }
        if let Some(rest) = line.strip_prefix("PTP {") {
            let mut fields: Vec<(&str, f64)> = rest
                .trim_end_matches('}')
                .split(',')
                .map(|field| field.split_once(' ').unwrap())
                .map(|(name, value)| (name, value.parse().unwrap()))
                .collect();
            // external axes first
            fields.sort_by_key(|(name, _)| (!name.starts_with('E'), *name));
            return Some(fields.into_iter().map(|(_, value)| value).collect());
        }
        let rest = line.strip_prefix("movej([")?;
        Some(numbers(rest.split_once(']').unwrap().0).into_iter().map(f64::to_degrees).collect())
    };
    program.lines().filter_map(of_line).collect()
}

#[test]
fn programs_move_to_the_poses_of_the_table_in_the_order_of_the_plan() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), arm("")).unwrap();
    for (file, name) in [("m.mod", "rapid"), ("m.src", "krl"), ("m.script", "urscript"), ("m.txt", "krl")] {
        let options = ["--poses", "poses.csv", "--program", file, "--dwell", "4.5"];
        let stated = if file == "m.txt" { &["--program-language", "krl"][..] } else { &[] };
        let found = all_of(folder.path(), "24", &[&SIGHT[..], &options, stated].concat());
        let program = std::fs::read_to_string(folder.path().join(file)).unwrap();
        let order = found.choice.order.as_ref().unwrap();
        let (shorter, longer) = (order.motion, order.motion_as_listed);
        assert!(shorter < 0.8 * longer, "{shorter} {longer}");
        let mut sorted = order.indices.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..24).collect::<Vec<_>>());
        // the length of the motion: largest joint motion of each leg, as a share of the span of the joint
        let q: Vec<Vec<f64>> = found.choice.chosen.iter().map(|p| joints_of(&p.configurations[0], &Q)).collect();
        let span = |j: usize| {
            let all = q.iter().map(|q| q[j]);
            all.clone().fold(f64::MIN, f64::max) - all.fold(f64::MAX, f64::min)
        };
        let leg = |w: &[usize]| (0..6).map(|j| (q[w[0]][j] - q[w[1]][j]).abs() / span(j)).fold(0.0, f64::max);
        assert!((order.indices.windows(2).map(leg).sum::<f64>() - shorter).abs() < 1e-9);

        let moved = motions(&program);
        let table = std::fs::read_to_string(folder.path().join("poses.csv")).unwrap();
        let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
        assert_eq!((moved.len(), rows.len()), (24, 24), "{program}");
        let labels = program.lines().filter(|line| line.contains(" pose ") && !line.contains('"'));
        for ((joints, row), label) in moved.iter().zip(&rows).zip(labels) {
            assert!(label.trim().ends_with(&format!("pose {}", row[0])), "{label}: {row:?}");
            for (q, cell) in joints.iter().zip(&row[1..]) {
                assert!((q - cell.parse::<f64>().unwrap()).abs() < 1e-4, "{joints:?} {row:?}");
            }
        }
        let waits = ["WaitTime \\InPos,4.5;", "WAIT SEC 4.5", "sleep(4.5)"];
        assert_eq!(program.lines().filter(|line| waits.contains(&line.trim())).count(), 24, "{program}");
        assert!(program.contains("Check for collisions and reach at low speed first."), "{program}");
        // the reader that compensates programs finds as many joint targets and no pose
        let read = language(name).unwrap().1.targets(program.as_bytes(), Freedoms::Space).unwrap();
        assert_eq!((read.joint_targets, read.targets.len()), (24, 0), "{program}");
        // the table is a table of candidates again
        let options = ["plan", "--robot", "robot.toml", "--candidates", "poses.csv", "--target", "A"];
        let again = etalon(folder.path(), &[&options[..], &["--positions", "24", "--nodes", "0"]].concat());
        assert!(again.status.success(), "{}", text_of(&again));
    }
}

#[test]
fn joints_with_backlash_arrive_from_the_planned_direction_within_their_limits() {
    let folder = tempfile::tempdir().unwrap();
    copy_robot("rail-arm", folder.path());
    let ranges =
        [[0.0, 800.0], [-90.0, 90.0], [-60.0, 60.0], [-60.0, 60.0], [-90.0, 90.0], [-90.0, 90.0], [-90.0, 90.0]];
    let columns: Vec<String> = (1..=7).map(|k| format!("q{k}_{}", if k == 1 { "mm" } else { "deg" })).collect();
    let stated: Vec<String> = columns.iter().zip(ranges).map(|(c, [a, b])| format!("{c}={a}:{b}")).collect();
    let mut options = vec!["--reflector", "A=0,0,50", "--program", "m.mod", "--poses", "p.csv"];
    stated.iter().for_each(|range| options.extend(["--range", range.as_str()]));
    let found = all_of(folder.path(), "30", &options);
    let moved = motions(&std::fs::read_to_string(folder.path().join("m.mod")).unwrap());
    assert_eq!(moved.len(), 60, "an approach and a pose each");
    let order = found.choice.order.as_ref().unwrap();
    let mut directions = [0usize; 2];
    for (pair, &index) in moved.chunks_exact(2).zip(&order.indices) {
        let values = &found.choice.chosen[index].configurations[0];
        for (k, column) in columns.iter().enumerate() {
            assert!((pair[1][k] - values[column]).abs() < 1e-4, "{pair:?} {values:?}");
            let came = pair[1][k] - pair[0][k];
            match values.get(&format!("q{}_direction", k + 1)) {
                Some(direction) => {
                    assert!((came - 2.0 * direction).abs() < 1e-4, "{came} {direction}");
                    directions[usize::from(*direction > 0.0)] += 1;
                }
                None => assert_eq!(came, 0.0),
            }
            assert!(pair.iter().all(|q| (ranges[k][0]..=ranges[k][1]).contains(&q[k])), "{pair:?}");
        }
    }
    assert!(directions.iter().all(|count| *count > 20), "{directions:?}");
    // directions are in the table, which is therefore a table of candidates again
    let table = std::fs::read_to_string(folder.path().join("p.csv")).unwrap();
    assert!(table.lines().next().unwrap().ends_with("q7_deg,q2_direction,q3_direction,q4_direction"), "{table}");
}

#[test]
fn parallel_robots_and_tables_are_drawn_too() {
    let folder = tempfile::tempdir().unwrap();
    let sample = |name: &str| copy_robot(name, folder.path());
    // arms of 235 mm on a radius of 200 mm, rods of 800 mm, platform of 45 mm
    sample("delta");
    let options = ["--reflector", "A=0,0,-10", "--box", "x=-200:200,y=-200:200,z=-900:-600"];
    let found = all_of(folder.path(), "20", &options);
    for (planned, place) in found.choice.chosen.iter().zip(&found.places) {
        let values = &planned.configurations[0];
        assert!(
            place
                .at_mm
                .iter()
                .zip([[-200.0, 200.0], [-200.0, 200.0], [-900.0, -600.0]])
                .all(|(v, [a, b])| (a..=b).contains(v))
        );
        for (leg, azimuth) in [0f64, 120.0, 240.0].into_iter().enumerate() {
            let q = values[&format!("theta{}_deg", leg + 1)];
            assert!((-40.0..=95.0).contains(&q));
            let ((s, c), (sin, cos)) = (azimuth.to_radians().sin_cos(), q.to_radians().sin_cos());
            let out = 200.0 + 235.0 * cos - 45.0;
            let rod = [out * c - place.at_mm[0], out * s - place.at_mm[1], -235.0 * sin - place.at_mm[2] - 10.0];
            assert!((norm(rod) - 800.0).abs() < 1e-6, "{rod:?}");
        }
    }
    // base at x = 263, y = 75; motors 275 mm apart, four links of 230 mm
    sample("dextar");
    let found = all_of(folder.path(), "20", &["--box", "x=-120:120,y=150:330"]);
    for (planned, place) in found.choice.chosen.iter().zip(&found.places) {
        let [x, y] = [place.at_mm[0] - 263.0, place.at_mm[1] - 75.0];
        assert!((-120.0..=120.0).contains(&x) && (150.0..=330.0).contains(&y), "{place:?}");
        for values in &planned.configurations {
            for (column, motor) in [("theta1_deg", -137.5), ("theta2_deg", 137.5)] {
                let (s, c) = values[column].to_radians().sin_cos();
                assert!(((x - motor - 230.0 * c).hypot(y - 230.0 * s) - 230.0).abs() < 1e-6, "{values:?}");
            }
        }
    }
    assert!(found.choice.chosen.iter().any(|planned| planned.configurations.len() > 1));
    sample("prexyt-cmm");
    let found = all_of(folder.path(), "20", &["--range", "rho2_mm=10:200"]);
    for planned in &found.choice.chosen {
        let ends = [("rho1_mm", [0.0, 170.0]), ("rho2_mm", [10.0, 200.0]), ("rho3_mm", [0.0, 300.0])];
        assert!(ends.iter().all(|(column, [a, b])| (a..=b).contains(&&planned.configurations[0][*column])));
    }
    sample("hexapod");
    let found = all_of(folder.path(), "10", &["--reflector", "A=0,0,20"]);
    for planned in &found.choice.chosen {
        assert!(planned.configurations[0].values().all(|leg| (0.0..=150.0).contains(leg)), "{planned:?}");
    }
}

#[test]
fn a_narrow_box_names_the_region_and_a_reversed_axis_its_remedy() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), arm("")).unwrap();
    let refused = |options: &[&str]| {
        let fixed = ["plan", "--robot", "robot.toml", "--generate", "10", "--positions", "5"];
        let answered = etalon(folder.path(), &[&fixed[..], options].concat());
        assert_eq!(answered.status.code(), Some(2), "{}", text_of(&answered));
        text_of(&answered)
    };
    // metres in place of millimetres
    let said = refused(&["--reflector", "A=0,0,60", "--box", "x=0.2:0.6,y=-0.3:0.3,z=0.1:0.5"]);
    assert!(said.contains("[no-candidate-generated]") && said.contains(" mm)"), "{said}");
    // the arm looks forward along x within a small region, its reflector backwards
    let ranges = ["q1_deg=-5:5", "q2_deg=-5:5", "q3_deg=-5:5", "q4_deg=-5:5", "q5_deg=-5:5", "q6_deg=-5:5"];
    let mut options = vec!["--instrument", "5000,0,600", "--reflector", "A=0,0,60,0,0,-1,40"];
    ranges.iter().for_each(|range| options.extend(["--range", *range]));
    let said = refused(&options);
    assert!(said.contains("[no-candidate-generated]") && said.contains("20000 of them"), "{said}");
    let neither = etalon(folder.path(), &["plan", "--robot", "robot.toml", "--positions", "5"]);
    assert_eq!(neither.status.code(), Some(2));
    let both = refused(&["--candidates", "c.csv"]);
    assert!(both.contains("--candidates"), "{both}");
}

/// Poses of the frames after each joint of the arm: rotation (rows) and translation.
fn frames(q_deg: &[f64]) -> Vec<([[f64; 3]; 3], [f64; 3])> {
    (1..=6).map(|count| flange_of(&ARM[..count], q_deg)).collect()
}

/// `true` if a point of the line of sight is nearer to the line between `ends` than `radius`, by points 0.5 mm apart.
fn crosses(from: [f64; 3], to: [f64; 3], ends: [[f64; 3]; 2], radius: f64) -> bool {
    let axis = minus(ends[1], ends[0]);
    let steps = (2.0 * norm(minus(to, from))).ceil();
    (0..=steps as usize).any(|k| {
        let p: [f64; 3] = std::array::from_fn(|i| from[i] + (k as f64 / steps) * (to[i] - from[i]));
        let share = (dot(minus(p, ends[0]), axis) / dot(axis, axis)).clamp(0.0, 1.0);
        norm(std::array::from_fn(|i| p[i] - ends[0][i] - share * axis[i])) < radius
    })
}

#[test]
fn reflectors_are_hidden_by_stated_bodies_and_by_links_of_the_arm() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), arm("")).unwrap();
    let view = ["--reflector", "A=30,0,60", "--instrument", "1200,-400,300"];
    let bodies = [
        "--obstacle",
        "column=cylinder:60,700,-200,0,700,-200,3000",
        "--obstacle",
        "table=box:600,600,400,900,300,200,30",
        "--link",
        "q3=60",
        // the upper arm by its ends at joint values zero: from (0, 0, 290) to (0, 0, 560)
        "--link",
        "q2=110,0,0,290,0,0,560",
    ];
    let found = all_of(folder.path(), "200", &[&view[..], &bodies].concat());
    let eye = [1200.0, -400.0, 300.0];
    for planned in &found.choice.chosen {
        let q = joints_of(&planned.configurations[0], &Q);
        let target = at(&q, [30.0, 0.0, 60.0]);
        let of = |k: usize, p: [f64; 3]| {
            let (r, t) = frames(&q)[k];
            std::array::from_fn(|i| t[i] + dot(r[i], p))
        };
        // axis 4 begins at Rx(-90) Tx(70) Tz(302) = (70, 302, 0) of frame 3, axis 3 at (270, 0, 0) of frame 2
        for (ends, radius) in [
            ([of(2, [0.0; 3]), of(2, [70.0, 302.0, 0.0])], 60.0),
            ([of(1, [0.0; 3]), of(1, [270.0, 0.0, 0.0])], 110.0),
            ([[700.0, -200.0, 0.0], [700.0, -200.0, 3000.0]], 60.0),
        ] {
            assert!(!crosses(eye, target, ends, radius - 0.01), "{q:?}");
        }
    }
    let generated = found.choice.generated.unwrap();
    let hidden: Vec<(&str, bool, usize)> =
        generated.obstacles.iter().map(|o| (o.name.as_str(), o.is_link, o.hidden)).collect();
    assert!(matches!(hidden[..], [("column", false, _), ("table", false, _), ("q3", true, _), ("q2", true, _)]));
    assert!(hidden.iter().all(|(.., count)| *count > 0), "{hidden:?}");
    let lost: usize = hidden.iter().map(|(.., count)| count).sum();
    assert_eq!(generated.draws, 200 + generated.beyond_limits + lost);
    // without the bodies every draw within the limits is a candidate
    let all = all_of(folder.path(), "60", &view[..2]).choice.generated.unwrap();
    assert_eq!(all.draws, 60 + all.beyond_limits);
}

#[test]
fn an_arm_between_instrument_and_reflector_hides_it() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), arm("")).unwrap();
    // stretched forwards: shoulder (0, 0, 290), elbow (0, 0, 560), wrist (302, 0, 630), reflector (434, 0, 630)
    let ranges: Vec<String> = (1..=6).map(|k| format!("q{k}_deg=-3:3")).collect();
    let mut options = vec!["--reflector", "A=0,0,60", "--link", "q3=60"];
    ranges.iter().for_each(|range| options.extend(["--range", range.as_str()]));
    let in_front = all_of(folder.path(), "20", &[&options[..], &["--instrument", "3000,0,630"]].concat());
    assert_eq!(in_front.choice.generated.unwrap().draws, 20);
    let fixed = ["plan", "--robot", "robot.toml", "--generate", "20", "--positions", "20"];
    let behind = etalon(folder.path(), &[&fixed[..], &options, &["--instrument", "-3000,0,630"]].concat());
    assert_eq!(behind.status.code(), Some(2));
    let said = text_of(&behind);
    assert!(
        said.contains("[no-candidate-generated]") && said.has_phrase("draws-hidden count=20000 obstacle=q3"),
        "{said}"
    );
}

/// Joint values (deg) of a FANUC program in the order of its motions: lines by number, positions by name.
fn fanuc_motions(text: &str) -> Vec<Vec<f64>> {
    let (head, rest) = text.split_once("/MN\n").unwrap();
    let (steps, positions) = rest.split_once("/POS\n").unwrap();
    assert!(head.starts_with("/PROG  M\n/ATTR\n") && positions.ends_with("/END\n"), "{text}");
    let mut moved = Vec::new();
    for (number, step) in steps.lines().enumerate() {
        let (at, step) = step.split_at(5);
        assert_eq!(at, format!("{:4}:", number + 1));
        let step = step.trim_end().strip_suffix(';').expect("end of a step").trim();
        match step.strip_prefix("J P[") {
            Some(rest) => {
                let (name, how) = rest.split_once(']').unwrap();
                assert_eq!(how.trim(), "10% FINE");
                moved.push(name.parse::<usize>().unwrap());
            }
            None => assert!(step.strip_prefix('!').is_none_or(|remark| remark.len() <= 32), "{step}"),
        }
    }
    assert!(head.contains(&format!("LINE_COUNT\t= {};", steps.lines().count())));
    let of = |name: usize| {
        let (_, rest) = positions.split_once(&format!("P[{name}]{{\n   GP1:\n\tUF : 0, UT : 1,\t\n")).unwrap();
        let fields = rest.split_once("\n};").unwrap().0.split(',').enumerate();
        let value = |(k, field): (usize, &str)| {
            let field = field.trim().strip_prefix(&format!("J{}=", k + 1)).expect("joint");
            field.strip_suffix(" deg").expect("unit").trim().parse::<f64>().unwrap()
        };
        fields.map(value).collect::<Vec<f64>>()
    };
    moved.into_iter().map(of).collect()
}

/// Joint values of an INFORM job by the pulses of its positions, in the order of its motions.
fn inform_motions(text: &str, pulses: &[f64]) -> Vec<Vec<f64>> {
    assert!(text.lines().count() == text.matches("\r\n").count() && text.starts_with("/JOB\r\n//NAME M\r\n//POS\r\n"));
    let lines: Vec<&str> = text.lines().collect();
    let position = |line: &&str| line.strip_prefix('C').and_then(|l| l.split_once('=')).is_some();
    let positions: Vec<&str> = lines.iter().copied().filter(position).collect();
    assert!(lines.contains(&format!("///NPOS {},0,0,0,0,0", positions.len()).as_str()));
    let order: Vec<usize> = ["///POSTYPE PULSE", "///PULSE", positions[0], "//INST", "///GROUP1 RB1", "NOP", "END"]
        .map(|part| lines.iter().position(|line| *line == part).expect(part))
        .to_vec();
    assert!(order.is_sorted() && order[6] + 1 == lines.len());
    let motions = lines.iter().filter_map(|line| line.strip_prefix("MOVJ C"));
    let of = |motion: &str| {
        let (name, how) = motion.split_once(' ').unwrap();
        assert_eq!(how, "VJ=10.00 PL=0");
        let values = positions.iter().find_map(|line| line.strip_prefix(&format!("C{name}="))).expect("position");
        let values = values.split(',').zip(pulses).map(|(value, per)| value.parse::<i64>().unwrap() as f64 / per);
        values.collect()
    };
    motions.map(of).collect()
}

/// Joint values (deg) of a Karel program in the order of its motions.
fn karel_motions(text: &str) -> Vec<Vec<f64>> {
    let (head, rest) = text.split_once("\nROUTINE drive(a, b, c, d, e, f : REAL)\nBEGIN\n").unwrap();
    let (routine, body) = rest.split_once("\nEND drive\n").unwrap();
    let (declared, variables) = head.split_once("\nVAR\n").unwrap();
    assert!(declared.starts_with("PROGRAM M\n") && declared.lines().skip(1).all(|line| line.starts_with("-- ")));
    assert_eq!(variables, "  joints : ARRAY[6] OF REAL\n  goal : JOINTPOS\n  status : INTEGER");
    // the arguments of the routine are the joints in their order
    let set: Vec<&str> = routine.lines().filter_map(|line| line.trim().strip_prefix("joints[")).collect();
    assert_eq!(set, ["1] = a", "2] = b", "3] = c", "4] = d", "5] = e", "6] = f"]);
    assert!(
        routine.trim_end().ends_with("MOVE TO goal") && body.trim().starts_with("BEGIN\n") && body.ends_with("END M\n")
    );
    let words = |line: &str| line.trim_end_matches(')').split(", ").map(|word| word.parse().unwrap()).collect();
    body.lines().filter_map(|line| line.trim().strip_prefix("drive(")).map(words).collect()
}

/// Joint values of a G-code program by the letters of its axes.
fn gcode_motions(text: &str, letters: &str) -> Vec<Vec<f64>> {
    let words = |line: &str| -> Vec<f64> {
        let words: Vec<&str> = line.split(' ').collect();
        assert_eq!(words.len(), letters.len());
        words
            .iter()
            .zip(letters.chars())
            .map(|(word, letter)| word.strip_prefix(letter).unwrap().parse().unwrap())
            .collect()
    };
    assert!(
        text.lines()
            .all(|line| !line.starts_with('(') || (line.ends_with(')') && line.matches(['(', ')']).count() == 2))
    );
    text.lines().filter_map(|line| line.strip_prefix("G53 G1 ")).map(words).collect()
}

#[test]
fn fanuc_karel_inform_and_gcode_programs_read_back_as_the_poses_of_the_table() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), arm("")).unwrap();
    let pulses = [1435.6, -1422.2, 1000.0, 800.5, -750.25, 500.0];
    let stated = pulses.map(|p| p.to_string()).join(",");
    for (file, more, step, waits) in [
        (
            "m.ls",
            vec!["--trigger", "5"],
            0.001,
            ["WAIT   2.25(sec) ;", "DO[5]=ON ;", "WAIT   2.25(sec) ;", "DO[5]=OFF ;"],
        ),
        ("m.kl", vec!["--trigger", "5"], 1e-4, ["DELAY 2250", "DOUT[5] = ON", "DELAY 2250", "DOUT[5] = OFF"]),
        (
            "m.jbi",
            vec!["--trigger", "5", "--pulses", &stated],
            0.002,
            ["TIMER T=2.25", "DOUT OT#(5) ON", "TIMER T=2.25", "DOUT OT#(5) OFF"],
        ),
        ("m.ngc", vec!["--trigger", "5", "--axes", "xyzabc"], 1e-6, ["G4 P2.25", "M64 P5", "G4 P2.25", "M65 P5"]),
        (
            "m.mod",
            vec!["--trigger", "doProbe"],
            1e-6,
            ["WaitTime \\InPos,2.25;", "SetDO doProbe,1;", "WaitTime \\InPos,2.25;", "SetDO doProbe,0;"],
        ),
        ("m.src", vec!["--trigger", "5"], 1e-6, ["WAIT SEC 2.25", "$OUT[5]=TRUE", "WAIT SEC 2.25", "$OUT[5]=FALSE"]),
        (
            "m.script",
            vec!["--trigger", "5"],
            1e-6,
            ["sleep(2.25)", "set_standard_digital_out(5, True)", "sleep(2.25)", "set_standard_digital_out(5, False)"],
        ),
    ] {
        let options = ["--poses", "poses.csv", "--program", file, "--dwell", "4.5"];
        let found = all_of(folder.path(), "12", &[&SIGHT[..], &options, &more].concat());
        let program = std::fs::read_to_string(folder.path().join(file)).unwrap();
        let moved = match file {
            "m.ls" => fanuc_motions(&program),
            "m.kl" => karel_motions(&program),
            "m.jbi" => inform_motions(&program, &pulses),
            "m.ngc" => gcode_motions(&program, "XYZABC"),
            _ => motions(&program),
        };
        // the table has the values that are commanded, not those between the steps of the controller
        let table = std::fs::read_to_string(folder.path().join("poses.csv")).unwrap();
        let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
        assert_eq!((moved.len(), rows.len()), (12, 12), "{program}");
        for (joints, row) in moved.iter().zip(&rows) {
            assert!(joints.iter().zip(&row[1..]).all(|(q, c)| (q - c.parse::<f64>().unwrap()).abs() < 2e-6), "{row:?}");
        }
        // and they are the nearest steps to the poses without a program
        let exact = all_of(folder.path(), "12", &SIGHT);
        for (with, without) in found.choice.chosen.iter().zip(&exact.choice.chosen) {
            let apart = Q.map(|q| (with.configurations[0][q] - without.configurations[0][q]).abs());
            assert!(apart.iter().all(|d| *d <= 0.5 * step + 1e-9), "{file} {apart:?}");
        }
        let said: Vec<&str> = program.lines().map(|line| line.split_once(":  ").map_or(line, |p| p.1).trim()).collect();
        let block = |stop: &[&str]| stop == waits;
        assert_eq!(said.windows(4).filter(|w| block(w)).count(), 12, "{program}");
        let stated = found.choice.program.unwrap();
        assert_eq!((stated.file.as_str(), stated.dwell_s), (file, 4.5));
    }
}

#[test]
fn gcode_moves_the_joints_of_any_machine() {
    let folder = tempfile::tempdir().unwrap();
    copy_robot("delta", folder.path());
    let options = ["--reflector", "A=0,0,-10", "--program", "m.ngc", "--axes", "ABC"];
    let found = all_of(folder.path(), "8", &options);
    let moved = gcode_motions(&std::fs::read_to_string(folder.path().join("m.ngc")).unwrap(), "ABC");
    for (joints, planned) in moved.iter().zip(found.in_order()) {
        let values = joints_of(&planned.configurations[0], &["theta1_deg", "theta2_deg", "theta3_deg"]);
        assert!(joints.iter().zip(&values).all(|(a, b)| (a - b).abs() < 1e-6), "{joints:?} {values:?}");
    }
    assert_eq!(moved.len(), 8);
}

#[test]
fn the_operators_sheet_has_set_up_labels_in_order_and_boxes() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), arm("")).unwrap();
    let options = ["--report", "r.html", "--program", "m.ls", "--trigger", "7"];
    let found = all_of(folder.path(), "6", &[&SIGHT[..], &options].concat());
    let html = std::fs::read_to_string(folder.path().join("r.html")).unwrap();
    let (_, sheet) = html.split_once("id=\"sheet\"").expect("sheet");
    // the boxes of five steps and of six poses
    assert_eq!(sheet.matches("[   ]").count(), 11);
    for part in ["2500, -400, 600", "30, 0, 60", "m.ls (fanuc)", "output 7"] {
        assert!(sheet.contains(part), "{part}");
    }
    let labels = found.in_order().into_iter().map(|p| sheet.find(&format!("A_{0}_1, B_{0}_1", p.pose)).expect("label"));
    assert!(labels.collect::<Vec<_>>().is_sorted());
}
