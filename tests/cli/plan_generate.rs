//! Candidates that `etalon plan --generate` draws, their order, and measuring programs: everything is computed again here.

use super::{etalon, text_of};
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
    let (mut r, mut t) = ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]);
    for (row, q) in ARM.iter().zip(q_deg) {
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
    let robot = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(sample).join("robot.toml");
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
    assert_ne!(found.chosen, other.chosen);
    let half = 45f64.to_radians();
    for planned in found.chosen.iter().chain(&other.chosen) {
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
    for (place, planned) in found.places.iter().zip(&found.chosen) {
        let here = at(&joints_of(&planned.configurations[0], &Q), [30.0, 0.0, 60.0]);
        assert!(norm(minus(place.at_mm, here)) < 1e-6, "{here:?} {place:?}");
    }
    let generated = found.generated.unwrap();
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
        let stated = if file == "m.txt" { &["--language", "krl"][..] } else { &[] };
        let found = all_of(folder.path(), "24", &[&SIGHT[..], &options, stated].concat());
        let program = std::fs::read_to_string(folder.path().join(file)).unwrap();
        let order = found.order.as_ref().unwrap();
        let (shorter, longer) = (order.motion, order.motion_as_listed);
        assert!(shorter < 0.8 * longer, "{shorter} {longer}");
        let mut sorted = order.indices.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..24).collect::<Vec<_>>());
        // the length of the motion: largest joint motion of each leg, as a share of the span of the joint
        let q: Vec<Vec<f64>> = found.chosen.iter().map(|p| joints_of(&p.configurations[0], &Q)).collect();
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
    let order = found.order.as_ref().unwrap();
    let mut directions = [0usize; 2];
    for (pair, &index) in moved.chunks_exact(2).zip(&order.indices) {
        let values = &found.chosen[index].configurations[0];
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
    for (planned, place) in found.chosen.iter().zip(&found.places) {
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
    for (planned, place) in found.chosen.iter().zip(&found.places) {
        let [x, y] = [place.at_mm[0] - 263.0, place.at_mm[1] - 75.0];
        assert!((-120.0..=120.0).contains(&x) && (150.0..=330.0).contains(&y), "{place:?}");
        for values in &planned.configurations {
            for (column, motor) in [("theta1_deg", -137.5), ("theta2_deg", 137.5)] {
                let (s, c) = values[column].to_radians().sin_cos();
                assert!(((x - motor - 230.0 * c).hypot(y - 230.0 * s) - 230.0).abs() < 1e-6, "{values:?}");
            }
        }
    }
    assert!(found.chosen.iter().any(|planned| planned.configurations.len() > 1));
    sample("prexyt-cmm");
    let found = all_of(folder.path(), "20", &["--range", "rho2_mm=10:200"]);
    for planned in &found.chosen {
        let ends = [("rho1_mm", [0.0, 170.0]), ("rho2_mm", [10.0, 200.0]), ("rho3_mm", [0.0, 300.0])];
        assert!(ends.iter().all(|(column, [a, b])| (a..=b).contains(&&planned.configurations[0][*column])));
    }
    sample("hexapod");
    let found = all_of(folder.path(), "10", &["--reflector", "A=0,0,20"]);
    for planned in &found.chosen {
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
