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
    assert!((all.exchangeability_mm.unwrap() - 0.5).abs() < 0.01 && one.exchangeability_mm.is_none());
    assert!(all.conventions.iter().any(|c| c == "2 robots: all results except exchangeability refer to `A`"));

    // two ways a cycle: sets of drift are of cycles, and what is no RP of the standard is said
    let (ways, said) = answer(&table(&[("A", 0.0)], &[("east", 0.0), ("west", 0.1)]));
    assert!(said.says("warning[several-approaches] poses=1, 2"), "{said}");
    assert!(ways.drifts.iter().all(|d| d.ap_mm.len() == 2), "{:?}", ways.drifts);
    assert!(ways.approaches[0].approaches.iter().all(|a| a.rp_mm.unwrap() < 0.01), "{:?}", ways.approaches);

    // a typing error in a title is told
    let typed = table(&[("A", 0.0)], &[("east", 0.0)]).replacen("approach", "aproach", 1);
    let (_, said) = answer(&typed);
    assert!(said.contains("warning[columns-not-read]") && said.contains("did you mean `approach`?"), "{said}");
}
