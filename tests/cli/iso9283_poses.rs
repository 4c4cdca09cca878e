//! `etalon iso9283`: tables of poses.

use super::iso9283::run;
use super::text_of;
use crate::support::said::Says;
use etalon::documents::Iso9283Document;

#[test]
fn readings_are_averaged_and_limits_judged_by_the_interval() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let mut table = "pose,cycle,reading,x_mm,y_mm,c_deg\n".to_owned();
    for cycle in 0..30 {
        let (sin, cos) = f64::from(cycle).sin_cos();
        for (reading, shake) in [(1, 0.01), (2, -0.01)] {
            let turned = 180.0 + 20.0 * shake - if reading == 1 { 360.0 } else { 0.0 };
            table += &format!("1,{cycle},{reading},{},{},{turned}\n", 100.0 + 0.1 * cos + shake, 0.1 * sin);
        }
    }
    std::fs::write(here.join("poses.csv"), &table).unwrap();
    std::fs::write(here.join("commanded.csv"), "pose,x_mm,y_mm,c_deg\n1,100,0,179.9\n").unwrap();
    let line = "iso9283 poses.csv --commanded commanded.csv";
    let pose = |options: &str| -> (Option<i32>, etalon::documents::Iso9283Pose) {
        let answered = run(here, &format!("{line} --json{options}"));
        let mut list: Vec<etalon::documents::Iso9283Pose> = serde_json::from_slice(&answered.stdout).unwrap();
        (answered.status.code(), list.remove(0))
    };
    let (_, found) = pose("");
    // two readings 0.02 mm apart: s = 0.01 √2 in x, nothing in y; their means lie on a circle of 0.1 mm
    assert_eq!((found.cycles, found.ap_conformity, found.rp_conformity), (30, None, None));
    let [x, y, z] = found.noise_mm.unwrap();
    assert!((x - 0.01 * 2f64.sqrt()).abs() < 1e-9 && y.abs() < 1e-9 && z == 0.0);
    // 179.8° and -179.8°, commanded 179.9°
    assert!((found.ap_c_deg.unwrap() - 0.1).abs() < 1e-9 && found.rp_c_deg.unwrap() < 1e-9);
    assert!(found.rp_without_noise_mm.unwrap() < found.rp_mm.unwrap());
    assert!((found.mean_radius_mm.unwrap() - 0.1).abs() < 1e-3 && found.ellipsoid.unwrap().semi_axes_mm[2] == 0.0);
    for (options, code, expected) in [
        (" --rp-limit-mm 10", 0, "Conforming"),
        (" --rp-limit-mm 0.001", 1, "NotConforming"),
        (" --ap-limit-mm 0.002", 1, "Neither"),
    ] {
        let (status, judged) = pose(options);
        let proved = judged.rp_conformity.or(judged.ap_conformity).unwrap();
        assert_eq!((status, format!("{proved:?}").as_str()), (Some(code), expected));
    }
    for (options, said) in
        [(" --rp-limit-mm 0", "--rp-limit-mm must be positive"), (" --ap-limit-mm NaN", "[option-not-positive]")]
    {
        let refused = run(here, &format!("{line}{options}"));
        assert_eq!(refused.status.code(), Some(2));
        assert!(text_of(&refused).says(said), "{}", text_of(&refused));
    }
    // two visits have no interval: nothing is proved
    std::fs::write(here.join("poses.csv"), "pose,cycle,x_mm,y_mm,c_deg\n1,1,100,0,0\n1,2,100.001,0,0\n").unwrap();
    let (status, judged) = pose(" --rp-limit-mm 10");
    assert_eq!((status, judged.rp_conformity), (Some(1), Some(etalon::documents::Conformity::Neither)));
    std::fs::write(here.join("poses.csv"), table.replacen("reading", "label", 1)).unwrap();
    assert!(text_of(&run(here, line)).says("error[pose-attained-twice] pose=1"));
}

/// Two robots, each well repeatable, half a millimetre apart: what one does is not what both do together.
#[test]
fn robots_approaches_and_cycles_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("commanded.csv"), "pose,x_mm,y_mm\n1,0,0\n2,100,0\n").unwrap();
    let table = |robots: &[(&str, f64)], ways: &[(&str, f64)]| {
        let mut noise = etalon::base::noise::Noise::new(11, 0);
        let mut text = "pose,cycle,x_mm,y_mm,robot,approach\n".to_owned();
        for (cycle, pose) in (1..=8).flat_map(|cycle| [1, 2].map(|pose| (cycle, pose))) {
            for ((robot, off), (way, aside)) in robots.iter().flat_map(|r| ways.iter().map(move |w| (r, w))) {
                let [x, y] = [off + 100.0 * f64::from(pose - 1), *aside].map(|v| v + noise.gaussian(0.001));
                text += &format!("{pose},{cycle},{x},{y},{robot},{way}\n");
            }
        }
        text
    };
    let answer = |text: &str| {
        std::fs::write(folder.path().join("poses.csv"), text).unwrap();
        let done = run(folder.path(), "iso9283 poses.csv --commanded commanded.csv --drift-set 4 --json");
        let document: Iso9283Document = serde_json::from_slice(&done.stdout).unwrap_or_else(|e| panic!("{e}"));
        (document, text_of(&done))
    };
    let both = table(&[("A", 0.0), ("B", 0.5)], &[("east", 0.0)]);
    let (all, _) = answer(&both);
    let of_a: String = both.lines().filter(|line| !line.contains(",B,")).map(|line| line.to_owned() + "\n").collect();
    let (one, _) = answer(&of_a);
    assert!(all.poses == one.poses && all.distances == one.distances && all.drifts == one.drifts);
    assert!((all.robot.exchangeability_mm.unwrap() - 0.5).abs() < 0.01 && one.robot.exchangeability_mm.is_none());
    assert!(all.conventions.iter().any(|c| c.english() == "2 robots: all results except exchangeability refer to `A`"));

    // two ways a cycle: sets of drift are of cycles, and what is no RP of the standard is said
    let (ways, said) = answer(&table(&[("A", 0.0)], &[("east", 0.0), ("west", 0.1)]));
    assert!(said.says("warning[several-approaches] poses=1, 2"), "{said}");
    assert!(ways.drifts.iter().all(|d| d.ap_mm.len() == 2), "{:?}", ways.drifts);
    assert!(ways.approaches[0].approaches.iter().all(|a| a.rp_mm.unwrap() < 0.01), "{:?}", ways.approaches);

    // a typing error in a title is told
    let typed = table(&[("A", 0.0)], &[("east", 0.0)]).replacen("approach", "aproach", 1);
    let (_, said) = answer(&typed);
    assert!(said.contains("warning[columns-not-read]") && said.has_phrase("did-you-mean name=approach"), "{said}");
}

/// Four poses far from the origin; the robot passes them one way, or one way and back in turn. Each way is 0.05, -0.02 and
/// 0.03 mm off, to either side.
fn passes(back: bool) -> Vec<String> {
    let places = [[612.5, -400.0, 355.0], [350.0, -620.0, 210.0], [350.0, -180.0, 800.0], [900.0, -620.0, 210.0]];
    let mut rows = Vec::new();
    for cycle in 1..=30 {
        let is_back = back && cycle % 2 == 0;
        let side = if is_back { -1.0 } else { 1.0 };
        for k in 0..4 {
            let pose = if is_back { 3 - k } else { k };
            let [x, y, z] = places[pose];
            let (x, y, z) = (x + 0.05 * side, y - 0.02 * side, z + 0.03 * side);
            rows.push(format!("{},{cycle},{x:.4},{y:.4},{z:.4}\n", pose + 1));
        }
    }
    rows
}

#[test]
fn means_of_approaches_on_the_terminal_are_those_of_the_document() {
    let folder = tempfile::tempdir().unwrap();
    let table = "pose,cycle,x_mm,y_mm,z_mm\n".to_owned() + &passes(true).concat();
    std::fs::write(folder.path().join("poses.csv"), table).unwrap();
    let done = run(folder.path(), "iso9283 pose poses.csv --all --json");
    let document: Iso9283Document = serde_json::from_slice(&done.stdout).unwrap();
    let of_pose = document.approaches.iter().find(|v| v.pose == etalon::base::pose_name::PoseName::from(2)).unwrap();
    let printed = String::from_utf8(run(folder.path(), "iso9283 pose poses.csv --all").stdout).unwrap();
    for (from, expected) in [("from pose 1", [0.05, -0.02, 0.03]), ("from pose 3", [-0.05, 0.02, -0.03])] {
        let approach = of_pose.approaches.iter().find(|a| a.name == from).unwrap();
        assert_eq!(approach.cycles, 15);
        let off = etalon::base::pose::minus(approach.mean_mm, of_pose.mean_mm.unwrap());
        assert!(off.iter().zip(expected).all(|(found, stated)| (found - stated).abs() < 1e-9), "{off:?}");
        let is_row = |line: &&str| line.trim_start().starts_with("2 ") && line.contains(from);
        let rows: Vec<String> = printed.lines().filter(is_row).map(|row| row.replace('\u{2212}', "-")).collect();
        let texts = expected.map(|mm: f64| format!("{:.1}", 1e3 * mm));
        let shows = |row: &String| row.split_whitespace().collect::<Vec<_>>().windows(3).any(|three| three == texts);
        assert!(rows.iter().any(shows), "{texts:?} in {printed}");
    }
    // 2 hypot(50, 20, 30) µm
    assert!((of_pose.vap_mm - 0.1232883).abs() < 1e-6, "{}", of_pose.vap_mm);
}

#[test]
fn a_missing_reading_is_no_approach() {
    let folder = tempfile::tempdir().unwrap();
    let answer = |rows: &[String]| {
        let table = "pose,cycle,x_mm,y_mm,z_mm\n".to_owned() + &rows.concat();
        std::fs::write(folder.path().join("poses.csv"), table).unwrap();
        let done = run(folder.path(), "iso9283 pose poses.csv --all --json");
        let document: Iso9283Document = serde_json::from_slice(&done.stdout).unwrap();
        (document, text_of(&done))
    };
    let counts = |document: &Iso9283Document| -> Vec<Vec<(String, usize)>> {
        let of_pose = |v: &etalon::documents::Iso9283Variation| {
            v.approaches.iter().map(|a| (a.name.clone(), a.cycles)).collect::<Vec<_>>()
        };
        document.approaches.iter().map(of_pose).collect()
    };
    let lost = |row: &String| !row.starts_with("3,17,");
    // one way: no pose has a second approach, and every visit counts for RP
    let (whole, said) = answer(&passes(false));
    assert!(whole.approaches.is_empty() && !said.contains("approach-unknown"), "{said}");
    let (gap, said) = answer(&passes(false).into_iter().filter(lost).collect::<Vec<_>>());
    assert!(gap.approaches.is_empty(), "{:?}", counts(&gap));
    assert!(said.says("warning[approach-unknown] count=1"), "{said}");
    assert_eq!(gap.poses.iter().map(|p| p.cycles).collect::<Vec<_>>(), [30, 30, 29, 30]);
    // both ways: the approaches remain, with one visit fewer
    let (whole, said) = answer(&passes(true));
    assert!(!said.contains("approach-unknown"), "{said}");
    let (gap, said) = answer(&passes(true).into_iter().filter(lost).collect::<Vec<_>>());
    assert!(said.says("warning[approach-unknown] count=1"), "{said}");
    let (mut expected, found) = (counts(&whole), counts(&gap));
    let names = |all: &[Vec<(String, usize)>]| all.iter().flatten().map(|(name, _)| name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&expected), names(&found));
    // poses 3 and 4 of cycle 17, which goes 1, 2, 3, 4
    expected[2][0].1 -= 1;
    expected[3].iter_mut().filter(|(name, _)| name == "from pose 3").for_each(|(_, count)| *count -= 1);
    assert_eq!(found, expected);
}

/// Six arms' flanges stand so: the middle angle at a right angle. Thirty cycles with 0.005° of noise about each axis; the
/// first and the last angle are as a controller finds them.
fn poses_of_flange(middle_deg: f64) -> [String; 2] {
    use etalon::base::noise::Noise;
    use etalon::base::pose::Pose;
    let mut noise = Noise::new(59, 6);
    let cube = [[400.0, 0.0, 350.0], [500.0, 100.0, 450.0], [300.0, -100.0, 250.0]];
    let [mut attained, mut commanded] =
        ["pose,cycle", "pose"].map(|key| format!("{key},x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n"));
    for (pose, [x, y, z]) in (1..).zip(cube) {
        commanded += &format!("{pose},{x},{y},{z},30,{middle_deg},170\n");
        let turned = Pose::from_xyz_rpy([0.0; 3], [30.0, middle_deg, 170.0].map(f64::to_radians));
        for cycle in 1..=30 {
            let off = [0, 1, 2].map(|_| noise.gaussian(0.005f64.to_radians()));
            // at a pitch of a right angle yaw is arbitrary, and roll follows it
            let [a, b, c] = Pose::from_rotation_vector(off).then(&turned).rpy_rad().map(f64::to_degrees);
            let [x, y, z] = [x, y, z].map(|v| v + noise.gaussian(0.01));
            attained += &format!("{pose},{cycle},{x},{y},{z},{a},{b},{c}\n");
        }
    }
    [attained, commanded]
}

/// With the middle angle at a right angle the angles of the other two are noise: no path reports them, each says so, and
/// with a stated order rotation vectors have the true scatter.
#[test]
fn angles_at_a_right_angle_are_not_reported_on_any_path() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let write = |middle_deg: f64| {
        let [attained, commanded] = poses_of_flange(middle_deg);
        std::fs::write(here.join("poses.csv"), attained).unwrap();
        std::fs::write(here.join("commanded.csv"), commanded).unwrap();
    };
    let answer = |options: &[&str]| -> (Iso9283Document, String) {
        let line = [&["iso9283", "pose", "poses.csv", "--all", "--json"], options].concat();
        let output = super::etalon(here, &line);
        assert_eq!(output.status.code(), Some(0), "{}", text_of(&output));
        (serde_json::from_slice(&output.stdout).unwrap(), text_of(&output))
    };
    let (order, of) = (["--rotation-order", "Rz(c) Ry(b) Rx(a)"], ["--commanded", "commanded.csv"]);
    for middle_deg in [90.0, -90.0, 89.99] {
        write(middle_deg);
        for options in [vec![], of.to_vec(), order.to_vec(), [of, order].concat()] {
            let (document, said) = answer(&options);
            assert!(said.contains("warning[angles-not-separable]"), "{options:?}: {said}");
            for p in &document.poses {
                let angles = [p.ap_a_deg, p.ap_b_deg, p.ap_c_deg, p.rp_a_deg, p.rp_b_deg, p.rp_c_deg];
                assert_eq!(angles, [None; 6], "{options:?}");
                assert_eq!(p.rp_rotation_deg.is_some(), options.contains(&order[0]), "{options:?}");
                let rp = p.rp_rotation_deg.iter().flatten();
                assert!(rp.into_iter().all(|rp| (0.008..0.024).contains(rp)), "{:?}", p.rp_rotation_deg);
                let ap = p.ap_rotation_deg.iter().flatten();
                assert!(ap.into_iter().all(|ap| ap.abs() < 4.0 * 0.005 / 30f64.sqrt()), "{:?}", p.ap_rotation_deg);
            }
            assert!(document.distances.iter().all(|d| d.ad_angles_deg.is_empty() && d.rd_angles_deg.is_empty()));
            assert!(document.distances.iter().filter_map(|d| d.ad_rotation_deg).all(|ad| ad.abs() < 0.03));
        }
    }
    // the reference targets moved: their compensation needs no angles that are separable
    write(90.0);
    let nests =
        "cycle,target,x_mm,y_mm,z_mm\n1,A,0,0,0\n1,B,900,0,0\n1,C,0,700,50\n2,A,0,0,0\n2,B,900,0,0\n2,C,0,700,50.001\n";
    std::fs::write(here.join("nests.csv"), nests).unwrap();
    let (document, said) = answer(&[&of[..], &order, &["--reference", "nests.csv"]].concat());
    assert!(said.contains("warning[angles-not-separable]") && document.poses[0].rp_rotation_deg.is_some(), "{said}");
    // away from the right angle, angles are reported
    write(45.0);
    let (document, said) = answer(&[of, order].concat());
    assert!(!said.contains("angles-not-separable") && document.poses[0].rp_a_deg.is_some(), "{said}");
}

/// Tables in metres are refused by name on every path, tables in another frame are told.
#[test]
fn metres_in_a_column_of_millimetres_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let write = |name: &str, text: &str| std::fs::write(here.join(name), text).unwrap();
    let cube = [[400.0, 0.0, 350.0], [500.0, 100.0, 450.0], [300.0, 100.0, 450.0], [300.0, -100.0, 250.0]];
    let attained = |factor: f64, robot: &str| -> String {
        let row = |(pose, cycle): (usize, usize)| {
            let [x, y, z] = cube[pose].map(|v| (v + 0.01 * cycle as f64) * factor);
            format!("{},{cycle},{robot},{x},{y},{z}\n", pose + 1)
        };
        (0..4).flat_map(|pose| (0..5).map(move |cycle| (pose, cycle))).map(row).collect()
    };
    let head = "pose,cycle,robot,x_mm,y_mm,z_mm\n";
    let commanded: String = (1..).zip(cube).map(|(pose, [x, y, z])| format!("{pose},{x},{y},{z}\n")).collect();
    write("commanded.csv", &format!("pose,x_mm,y_mm,z_mm\n{commanded}"));
    let line = "iso9283 pose poses.csv --commanded commanded.csv";
    for (text, code, said) in [
        (attained(1.0, "A"), 0, "warning[few-cycles]"),
        (attained(1e-3, "A"), 2, "error[positions-in-other-unit] table=attained unit=m"),
        (attained(1.0 / 25.4, "A"), 2, "error[positions-in-other-unit] table=attained unit=inch"),
        (attained(1e3, "A"), 2, "error[positions-in-other-unit] table=commanded unit=m"),
        (attained(1.0, "A") + &attained(1e-3, "B"), 2, "error[positions-in-other-unit] table=robot robot=B unit=m"),
    ] {
        write("poses.csv", &format!("{head}{text}"));
        let output = run(here, line);
        assert_eq!(output.status.code(), Some(code), "{said}: {}", text_of(&output));
        assert!(text_of(&output).says(said), "{said}: {}", text_of(&output));
    }
    // robots among each other, without commanded poses
    let output = run(here, "iso9283 pose poses.csv");
    assert!(text_of(&output).says("error[positions-in-other-unit] table=robot robot=B"), "{}", text_of(&output));
    // a recording in metres: of a path, and of poses
    let row = |i: usize| format!("{},{},0.1,0.2\n", i as f64 / 100.0, 0.001 * i as f64);
    write("motion.csv", &format!("time_s,x_mm,y_mm,z_mm\n{}", (0..400).map(row).collect::<String>()));
    write("path.csv", "x_mm,y_mm,z_mm\n50,100,200\n350,100,200\n");
    write("places.csv", "pose,x_mm,y_mm,z_mm\n1,100,100,200\n2,300,100,200\n");
    for options in ["--path path.csv", "--commanded places.csv", "--path path.csv --commanded places.csv"] {
        let output = run(here, &format!("iso9283 path motion.csv {options}"));
        assert_eq!(output.status.code(), Some(2), "{options}: {}", text_of(&output));
        assert!(text_of(&output).says("error[positions-in-other-unit] table=attained unit=m"), "{}", text_of(&output));
    }
}
