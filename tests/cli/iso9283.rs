//! `etalon iso9283`: recorded motions, paths, loads and plans of tests.

use super::{etalon, text_of};
use crate::support::root;
use crate::support::said::Says;
use etalon::base::pose::Pose;
use etalon::base::pose_name::PoseName;
use etalon::documents::{Iso9283ComplianceDocument, Iso9283PlanDocument, Iso9283StreamDocument};
use std::path::Path;
use std::process::Output;

/// Synthetic: to and fro between x = 0 and x = 100 mm at 100 mm/s, half a second at each end, three times, at 100 Hz.
fn to_and_fro() -> String {
    let mut text = "time_s,x_mm,y_mm,c_deg\n".to_owned();
    let mut row = 0;
    let mut sample = |x: f64, off: f64| {
        text += &format!("{},{x},{off},{}\n", f64::from(row) / 100.0, if row % 2 == 0 { 180.0 } else { -180.0 });
        row += 1;
    };
    for pass in 0..3 {
        (0..50).for_each(|_| sample(0.0, 0.0));
        (1..100).for_each(|i| sample(f64::from(i), 0.1 * f64::from(pass)));
        (0..50).for_each(|_| sample(100.0, 0.0));
        (1..100).rev().for_each(|i| sample(f64::from(i), 0.0));
    }
    text
}

pub fn run(folder: &Path, line: &str) -> Output {
    etalon(folder, &line.split(' ').collect::<Vec<_>>())
}

#[test]
fn a_recording_tells_stops_path_and_poses_that_the_command_takes_again() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    std::fs::write(here.join("stream.csv"), to_and_fro()).unwrap();
    std::fs::write(here.join("path.csv"), "x_mm,y_mm,c_deg\n0,0,180\n100,0,180\n").unwrap();
    std::fs::write(here.join("commanded.csv"), "pose,x_mm,y_mm,c_deg\n7,0,0,180\n8,100,0,180\n").unwrap();
    let line = "iso9283 --stream stream.csv --commanded commanded.csv --path path.csv --path-points 10 --velocity-mm-s 80 \
                --band-mm 0.5 --write-poses poses.csv";
    let answered = run(here, &format!("{line} --json"));
    assert!(answered.status.success(), "{}", text_of(&answered));
    let document: Iso9283StreamDocument = serde_json::from_slice(&answered.stdout).unwrap();
    let number = |pose: PoseName| pose.number().unwrap();
    let visits: Vec<(i64, i64)> =
        document.standstills.iter().map(|s| (number(s.pose.unwrap()), s.cycle.unwrap())).collect();
    assert_eq!(visits, [(7, 1), (8, 1), (7, 2), (8, 2), (7, 3), (8, 3)]);
    let path = document.path.unwrap();
    let velocity = path.velocity.unwrap();
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{a} {b}");
    assert_eq!((path.passes, path.incomplete, path.reorientation), (3, 0, false));
    near(path.at_mm, 0.1);
    // radii 0.1, 0, 0.1 mm: mean 1/15 and three times their standard deviation 0.1/√3
    near(path.rt_mm.unwrap(), 0.2 / 3.0 + 0.3 / 3f64.sqrt());
    near(path.at_angles_deg[0], 0.0);
    near(velocity.av_percent, 25.0);
    near(velocity.rv_percent.unwrap(), 0.0);
    assert!(document.standstills.iter().all(|s| s.mean_mm.len() == 2));

    let said = text_of(&run(here, line));
    assert!(said.says("warning[few-passes] least=10 count=3") && said.matches("warning[").count() == 1, "{said}");
    let poses = run(here, "iso9283 poses.csv --commanded commanded.csv --json");
    let list: Vec<serde_json::Value> = serde_json::from_slice(&poses.stdout).unwrap();
    assert!(list.len() == 2 && list.iter().all(|p| p["ap_mm"].as_f64().unwrap() < 1e-9 && p["cycles"] == 3));
}

#[test]
fn hostile_recordings_and_paths_are_refused_with_their_line() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let good = to_and_fro();
    std::fs::write(here.join("path.csv"), "x_mm,y_mm,c_deg\n0,0,180\n100,0,180\n").unwrap();
    let stamped = |line: &str| good.replacen("\n0.02,", line, 1);
    for (stream, options, said) in [
        (String::new(), "", "error[data-rows-missing]"),
        ("time_s,x_mm,y_mm\n".to_owned(), "", "error[data-rows-missing]"),
        ("time_s,x_mm,y_mm\n0,1,2\n".to_owned(), "", "error[stream-too-short]"),
        (good.replacen("time_s", "clock_s", 1), "", "error[recording-time-missing]"),
        (stamped("\n0.01,"), "", "stream.csv:4"),
        (stamped("\n0.005,"), "", "error[time-not-increasing]"),
        (stamped("\nNaN,"), "", "error[stream-value-missing]"),
        (stamped("\n,"), "", "stream.csv:4"),
        (stamped("\n0.02,1e200,0,180\n0.021,"), "", "error[coordinate-missing]"),
        (good.clone(), "--rate-hz 1000000", "error[recording-implausible]"),
        (good.clone(), "--rate-hz 5", "error[rate-contradicts-stamps]"),
        (good.clone(), "--rate-hz 0", "error[option-not-positive]: --rate-hz"),
        (good.clone(), "--still-mm NaN", "error[option-not-positive]: --still-mm"),
        (good.clone(), "--band-mm -1", "unexpected argument"),
        (good.clone(), "--near-mm inf", "error[option-not-positive]: --near-mm"),
        (good.clone(), "--path path.csv --path-points 1", "error[path-points-out-of-range]: --path-points"),
        (good.clone(), "--path far.csv", "error[path-without-pass]"),
        (good.clone(), "--path spatial.csv", "error[coordinates-differ]"),
        (good.clone(), "--path point.csv", "error[commanded-point-repeated]"),
        (good.clone(), "--path nowhere.csv", "error[input-missing] file=nowhere.csv"),
        (good.clone(), "--commanded twice.csv", "error[pose-commanded-twice] pose=1"),
        (good.clone(), "--columns x,y --delimiter comma", "error[option-unit-missing]"),
        (
            good.clone(),
            "--path path.csv --weave-stroke-mm 2 --weave-hz 3 --weave-across 1,0,0",
            "error[weave-direction]",
        ),
    ] {
        std::fs::write(here.join("stream.csv"), &stream).unwrap();
        std::fs::write(here.join("spatial.csv"), "x_mm,y_mm,z_mm\n0,0,0\n1,0,0\n").unwrap();
        std::fs::write(here.join("point.csv"), "x_mm,y_mm,c_deg\n0,0,180\n0,0,180\n").unwrap();
        std::fs::write(here.join("twice.csv"), "pose,x_mm,y_mm,c_deg\n1,0,0,180\n1,0,0,180\n").unwrap();
        std::fs::write(here.join("far.csv"), "x_mm,y_mm,c_deg\n0,50,180\n100,50,180\n").unwrap();
        let refused = run(here, format!("iso9283 --stream stream.csv {options}").trim_end());
        assert_eq!(refused.status.code(), Some(2), "{options} {said}: {}", text_of(&refused));
        assert!(refused.stdout.is_empty() && text_of(&refused).says(said), "{said}: {}", text_of(&refused));
    }
}

#[test]
fn a_loaded_robot_gives_way_by_what_the_table_says() {
    let folder = tempfile::tempdir().unwrap();
    let mut table = "direction,cycle,force_n,x_mm,y_mm,z_mm\n".to_owned();
    for (direction, sign, mm_n) in [("+x", 1.0, 0.001), ("-x", -1.0, 0.002)] {
        for cycle in 1..=3 {
            for step in 0..=10 {
                let force = 10.0 * f64::from(step);
                table += &format!("{direction},{cycle},{force},{},5,9\n", 500.0 + sign * mm_n * force);
            }
        }
    }
    let answer = |table: &str| {
        std::fs::write(folder.path().join("loads.csv"), table).unwrap();
        run(folder.path(), "iso9283 --compliance loads.csv --json")
    };
    let document: Iso9283ComplianceDocument = serde_json::from_slice(&answer(&table).stdout).unwrap();
    let told: Vec<(&str, usize, usize)> =
        document.directions.iter().map(|d| (d.direction.as_str(), d.readings, d.cycles)).collect();
    assert_eq!(told, [("+x", 30, 3), ("-x", 30, 3)]);
    for (d, mm_n) in document.directions.iter().zip([0.001, 0.002]) {
        assert!((d.compliance_mm_n - mm_n).abs() < 1e-12 && d.off_line_mm < 1e-9 && d.force_n == 100.0, "{d:?}");
        assert!((d.largest_mm - 100.0 * mm_n).abs() < 1e-9);
    }
    let planar = "direction,cycle,force_n,x_mm,y_mm\n+z,1,0,500,5\n+z,1,10,500,5\n";
    assert!(text_of(&answer(planar)).says("error[load-direction-unmeasured] direction=+z"));
    for (from, to, said) in [
        ("+x,1,10,", "up,1,10,", "error[load-direction-unknown]: `up`"),
        ("+x,1,10,", "+x,1,-10,", "error[force-not-a-number]: `-10`"),
        ("+x,1,0,", "+x,1,5,", "[unloaded-position-missing]"),
        ("force_n", "force", "error[column-unknown]"),
        ("+x,1,10,500.01", "+x,1,10,", "error[coordinate-missing]"),
    ] {
        let refused = answer(&table.replacen(from, to, 1));
        assert_eq!(refused.status.code(), Some(2), "{said}");
        assert!(text_of(&refused).says(said), "{said}: {}", text_of(&refused));
    }
}

#[test]
fn a_plan_writes_tables_that_the_command_takes_and_targets() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let line = "iso9283 --plan --workspace-mm 300,-250,100,900,350,500 --orientation-deg 180,0,90 --reorientation-deg \
                0,10,0 --test-plane C2-C3-C8-C5 --write test";
    let answered = run(here, &format!("{line} --json"));
    assert!(answered.status.success(), "{}", text_of(&answered));
    let document: Iso9283PlanDocument = serde_json::from_slice(&answered.stdout).unwrap();
    assert_eq!((document.side_mm, document.test_plane.as_str()), (400.0, "C2-C3-C8-C5"));
    let read = |name: &str| std::fs::read_to_string(here.join("test").join(name)).unwrap();
    assert_eq!(read("poses.csv").lines().count(), 6);
    assert!(read("poses.csv").starts_with("pose,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n1,600,50,300,180,0,90\n"));
    assert_eq!(read("circle-large.csv").lines().count(), 74);
    assert!(read("reorientation.csv").lines().nth(2).unwrap().ends_with(",180,10,90"));
    assert!(read("programme.csv").contains("\"7.2.1, 7.2.2\",\"P5 P4 P3 P2 P1\",100 50 10,30,yes"));
    let targets: serde_json::Value = serde_json::from_str(&read("poses.json")).unwrap();
    assert_eq!(targets["targets"][0]["coordinates"]["x_mm"], 600.0);
    assert!(read("rectangle.h").contains("#define ETALON_ISO9283_RECTANGLE_TARGETS 5"));
    // P1 attained as commanded
    std::fs::write(
        here.join("attained.csv"),
        read("poses.csv")
            .replace("pose,", "pose,cycle,")
            .replace("\n1,", "\n1,1,")
            .lines()
            .take(2)
            .collect::<Vec<_>>()
            .join("\n"),
    )
    .unwrap();
    let poses = run(here, "iso9283 attained.csv --commanded test/poses.csv --json");
    let list: Vec<serde_json::Value> = serde_json::from_slice(&poses.stdout).unwrap();
    assert_eq!((list.len(), list[0]["ap_mm"].as_f64()), (1, Some(0.0)));

    let planar = run(here, "iso9283 --plan --workspace-mm 0,0,300,200 --orientation-deg 45 --json");
    let planar: Iso9283PlanDocument = serde_json::from_slice(&planar.stdout).unwrap();
    assert_eq!(planar.places[0].points[0].keys().collect::<Vec<_>>(), ["c_deg", "x_mm", "y_mm"]);

    for (options, said) in [
        ("", "--workspace-mm"),
        (" --workspace-mm 1,2,3", "error[workspace-numbers]"),
        (" --workspace-mm 0,0,0,0,0,0", "error[workspace-not-box]"),
        (" --workspace-mm 0,0,0,NaN,1,1", "error[workspace-not-box]"),
        (" --workspace-mm 0,0,0,1,1,1 --test-plane C1-C2", "error[test-plane-unknown]"),
        (" --workspace-mm 0,0,1,1 --test-plane C1-C2-C7-C8", "error[planar-test-plane]"),
        (" --workspace-mm 0,0,0,1,1,1 --orientation-deg 1,2", "error[angle-count]"),
        (" --workspace-mm 0,0,0,1,1,1 --reorientation-deg 1,2,3", "error[reorientation-alone]"),
    ] {
        let refused = run(here, &format!("iso9283 --plan{options}"));
        assert_eq!(refused.status.code(), Some(2), "{options}");
        assert!(text_of(&refused).says(said), "{said}: {}", text_of(&refused));
    }
    let nothing = run(here, "iso9283");
    assert_eq!(nothing.status.code(), Some(2));
}

#[test]
fn reference_targets_carry_positions_back_and_must_be_there_from_the_first_cycle_on() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    // from cycle 3 on everything is 0.5 mm farther along x
    let shift = |cycle: i32| if cycle < 3 { 0.0 } else { 0.5 };
    let poses: String = (1..=5).map(|c| format!("1,{c},{},0,0\n", 100.0 + shift(c))).collect();
    let nests = |cycle: i32| -> String {
        let at = [("a", [0, 0, 0]), ("b", [900, 0, 0]), ("c", [0, 700, 0])];
        at.map(|(name, [x, y, z])| format!("{cycle},{name},{},{y},{z}\n", f64::from(x) + shift(cycle))).concat()
    };
    std::fs::write(here.join("poses.csv"), format!("pose,cycle,x_mm,y_mm,z_mm\n{poses}")).unwrap();
    std::fs::write(here.join("commanded.csv"), "pose,x_mm,y_mm,z_mm\n1,100,0,0\n").unwrap();
    let answer = |rows: &str| {
        std::fs::write(here.join("nests.csv"), format!("cycle,target,x_mm,y_mm,z_mm\n{rows}")).unwrap();
        run(here, "iso9283 poses.csv --commanded commanded.csv --reference nests.csv --all --json")
    };
    let answered = answer(&(nests(1) + &nests(3)));
    let document: etalon::documents::Iso9283Document = serde_json::from_slice(&answered.stdout).unwrap();
    assert!(document.poses[0].ap_mm.unwrap() < 1e-9 && document.poses[0].rp_mm.unwrap() < 1e-9);
    assert_eq!(
        document.recorded.reference.iter().map(|e| (e.cycle, e.moved_mm)).collect::<Vec<_>>(),
        [(1, 0.0), (3, 0.5)]
    );
    for (rows, said) in [
        (nests(3), "error[cycle-before-reference-targets] cycle=1"),
        (nests(1) + &nests(3).replace("3,c,", "3,d,"), "error[reference-targets-differ]"),
        (nests(1) + &nests(1), "error[reference-target-twice]"),
        (nests(1).replace(",700,", ",0,"), "nests.csv"),
    ] {
        let refused = answer(&rows);
        assert_eq!(refused.status.code(), Some(2), "{said}");
        assert!(text_of(&refused).says(said), "{said}: {}", text_of(&refused));
    }
}

/// From cycle 4 on the instrument stands elsewhere, turned by half a radian: position, orientation and targets move as one
/// rigid body. Carried back, the test is the one without.
#[test]
fn an_instrument_that_was_turned_changes_neither_position_nor_orientation() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let moved = Pose::from_xyz_rpy([30.0, -20.0, 10.0], [0.02, -0.03, 0.5]);
    let attained = |cycle: i32| {
        let j = f64::from(cycle);
        Pose::from_xyz_rpy(
            [100.0 + 0.01 * j * j, 200.0, 300.0 - 0.02 * j],
            [0.1 + 0.001 * j * j, -0.2, 3.1 + 0.0003 * j],
        )
    };
    let write = |name: &str, moves: bool| {
        let now = |cycle: i32, pose: Pose| if moves && cycle > 3 { moved.then(&pose) } else { pose };
        let row = |cycle: i32| {
            let pose = now(cycle, attained(cycle));
            let ([x, y, z], [a, b, c]) = (pose.translation_mm, pose.rpy_rad().map(f64::to_degrees));
            format!("1,{cycle},{x},{y},{z},{a},{b},{c}\n")
        };
        let poses: String = (1..=6).map(row).collect();
        std::fs::write(here.join(name), format!("pose,cycle,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n{poses}")).unwrap();
        let nest = |cycle: i32| {
            let at = [("a", [0.0, 0.0, 0.0]), ("b", [900.0, 0.0, 0.0]), ("c", [0.0, 700.0, 50.0])];
            let places = at.map(|(name, p)| (name, now(cycle, Pose::identity()).apply(p)));
            places.map(|(name, [x, y, z])| format!("{cycle},{name},{x},{y},{z}\n")).concat()
        };
        std::fs::write(here.join("nests.csv"), format!("cycle,target,x_mm,y_mm,z_mm\n{}{}", nest(1), nest(4))).unwrap();
    };
    let (a, b, c) = (0.1f64.to_degrees(), -(0.2f64.to_degrees()), 3.1f64.to_degrees());
    let commanded = format!("pose,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n1,100,200,300,{a},{b},{c}\n");
    std::fs::write(here.join("commanded.csv"), commanded).unwrap();
    let arguments = ["iso9283", "poses.csv", "--commanded", "commanded.csv", "--all", "--json"];
    let answer = |more: &[&str]| {
        let output = super::etalon(here, &[&arguments[..], more].concat());
        let document: etalon::documents::Iso9283Document = serde_json::from_slice(&output.stdout).unwrap();
        (document, text_of(&output))
    };
    write("poses.csv", false);
    let (still, _) = answer(&[]);
    write("poses.csv", true);
    let order = ["--reference", "nests.csv", "--rotation-order", "Rz(c) Ry(b) Rx(a)"];
    let (back, _) = answer(&order);
    let numbers = |d: &etalon::documents::Iso9283Document| {
        let p = &d.poses[0];
        [p.ap_mm, p.rp_mm, p.ap_a_deg, p.ap_b_deg, p.ap_c_deg, p.rp_a_deg, p.rp_b_deg, p.rp_c_deg].map(|v| v.unwrap())
    };
    for (found, expected) in numbers(&back).iter().zip(numbers(&still)) {
        assert!((found - expected).abs() < 1e-9, "{found} instead of {expected}");
    }
    assert!(
        back.conventions
            .iter()
            .any(|c| c.english() == "drift of positions and orientations is compensated by reference targets")
    );
    // without the order the drift of positions alone is compensated, and that is told
    let (half, said) = answer(&order[..2]);
    assert!((half.poses[0].ap_mm.unwrap() - still.poses[0].ap_mm.unwrap()).abs() < 1e-9);
    assert!(half.poses[0].rp_c_deg.unwrap() > 10.0 && said.contains("warning[angles-not-compensated]"), "{said}");
}

/// The PreXYT's travel is 170, 300 and 300 mm: of a square that is wider not all is reached, and what is, is where the model says.
#[test]
fn a_plan_says_what_the_robot_reaches_and_with_which_joint_values() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let answer = |robot: &str, workspace: &str| {
        let robot = root().join(format!("samples/{robot}/robot.toml"));
        // a folder each: nothing is written over what is there
        let to = if workspace == "350,250,430,330" { "test" } else { workspace };
        let arguments = [
            "iso9283",
            "--plan",
            "--json",
            "--write",
            to,
            "--robot",
            robot.to_str().unwrap(),
            "--workspace-mm",
            workspace,
        ];
        super::etalon(here, &arguments)
    };
    let inside = answer("dextar", "350,250,430,330");
    assert_eq!(inside.status.code(), Some(0), "{}", text_of(&inside));
    let document: Iso9283PlanDocument = serde_json::from_slice(&inside.stdout).unwrap();
    let robot = etalon::campaign::read_robot(&root().join("samples/dextar/robot.toml"))
        .unwrap()
        .build(&["tool".to_owned()])
        .unwrap();
    for places in &document.places {
        for (point, joints) in places.points.iter().zip(&places.joints) {
            let joints = joints.as_ref().unwrap();
            let q = [joints["theta1_deg"].to_radians(), joints["theta2_deg"].to_radians(), joints["assembly"]];
            let [x, y, _] = robot.position(&robot.nominal(), &q, 0);
            assert!((x - point["x_mm"]).abs() < 1e-9 && (y - point["y_mm"]).abs() < 1e-9, "{} {point:?}", places.name);
        }
    }
    let again = answer("dextar", "350,250,430,330");
    assert!(again.status.code() == Some(2) && text_of(&again).contains("error[file-exists]"), "{}", text_of(&again));
    let table = std::fs::read_to_string(here.join("test/poses-joints.csv")).unwrap();
    assert!(table.starts_with("pose,assembly,theta1_deg,theta2_deg\n1,") && table.lines().count() == 6, "{table}");
    let outside = answer("dextar", "300,200,2300,2200");
    assert_eq!(outside.status.code(), Some(1));
    let document: Iso9283PlanDocument = serde_json::from_slice(&outside.stdout).unwrap();
    assert!(document.unreached.iter().any(|u| u.places == "poses" && u.point == 5), "{:?}", document.unreached);
    assert!(text_of(&outside).contains("warning[test-point-unreached]"));

    let table = answer("prexyt-cmm", "150,50,1150,1050");
    assert_eq!(table.status.code(), Some(1), "{}", text_of(&table));
    assert!(text_of(&table).has_phrase("actuator-beyond-travel"), "{}", text_of(&table));
    let arm = answer("abb-irb120", "300,-250,900,350");
    assert!(arm.status.code() == Some(2) && text_of(&arm).contains("model `serial`"), "{}", text_of(&arm));
}
