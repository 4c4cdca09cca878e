//! Repeatability against a laser-tracker exercise whose authors printed their results (KIT, winter 2024/25).

use etalon::base::pose::{Vector, centroid, cross, minus, norm, unit};
use etalon::standards::iso9283::pose::repeatability::{PoseRepeatability, angle_repeatability_rad, pose_repeatability};
use std::path::{Path, PathBuf};

/// Two poses that the robot shuttles between, and the first approached from arbitrary directions.
const SERIES: [(&str, &str); 3] = [("pose1", "0.0120"), ("pose2", "0.0134"), ("anfahrt_pose1", "0.4085")];

pub fn folder() -> Option<PathBuf> {
    crate::reference_data("robots/kit_iso9283_tracker")
}

/// Positions of the three reflectors, ten visits each.
fn visits(folder: &Path, series: &str) -> [Vec<Vector>; 3] {
    let mut targets: [Vec<Vector>; 3] = Default::default();
    for line in std::fs::read_to_string(folder.join(format!("tracker/{series}.txt"))).unwrap().lines() {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.trim().parse().unwrap()).collect();
        targets[cells[0] as usize - 1].push([cells[1], cells[2], cells[3]]);
    }
    assert!(targets.iter().all(|t| t.len() == 10), "{series}");
    targets
}

/// What the results print a row for: the middle of the reflectors, then each of them.
fn rows(folder: &Path, series: &str) -> [Vec<Vector>; 4] {
    let [a, b, c] = visits(folder, series);
    let middle = (0..10).map(|j| centroid(&[a[j], b[j], c[j]]).unwrap()).collect();
    [middle, a, b, c]
}

/// The numbers of the rows that begin with `start`, as they are printed.
fn published(folder: &Path, file: &str, start: &str) -> Vec<String> {
    let text = std::fs::read_to_string(folder.join(format!("results/{file}.txt"))).unwrap();
    let rows = text.lines().filter(|line| line.starts_with(start));
    rows.map(|line| line.split(':').nth(1).unwrap().split_whitespace().next().unwrap().to_owned()).collect()
}

/// Compares four printed numbers of each series with `of` the positions.
fn agrees(folder: &Path, start: &str, of: impl Fn(PoseRepeatability) -> f64) {
    for (series, _) in SERIES {
        let found = rows(folder, series).map(|points| format!("{:.4}", of(pose_repeatability(&points).unwrap())));
        // the last row on standard deviations is one of orientation
        let printed = published(folder, &format!("{series}_results"), start);
        assert_eq!(found.as_slice(), &printed[..4], "{series}");
    }
}

#[test]
fn repeatability_of_the_middle_and_of_each_target_agrees_with_kit_to_every_printed_digit() {
    let Some(folder) = folder() else { return };
    agrees(&folder, "Pos. repeat.", |found| {
        // mean + 3 s holds every visit here, and no ball is larger than the farthest from the mean
        assert!(found.enclosing_radius_mm < found.rp_mm && found.enclosing_radius_mm > found.mean_radius_mm);
        found.rp_mm
    });
    for (series, expected) in SERIES {
        assert_eq!(published(&folder, &format!("{series}_results"), "Pos. repeat.")[0], expected);
    }
}

#[test]
fn standard_deviations_of_position_agree_with_kit_to_every_printed_digit() {
    let Some(folder) = folder() else { return };
    agrees(&folder, "Std. of ", |found| norm(found.axis_mm) / 3.0);
}

/// They take the angles between the plane of the reflectors and the axes, which are not the standard's a, b, c.
#[test]
fn repeatability_of_angles_agrees_with_kit_to_every_printed_digit() {
    let Some(folder) = folder() else { return };
    for (series, _) in SERIES {
        let [a, b, c] = visits(&folder, series);
        let normals: Vec<Vector> =
            (0..10).map(|j| unit(cross(minus(b[j], a[j]), minus(c[j], a[j]))).unwrap()).collect();
        let found = [0, 1, 2].map(|k| {
            let angles: Vec<f64> = normals.iter().map(|n| n[k].acos()).collect();
            format!("{:.4}", angle_repeatability_rad(&angles).to_degrees())
        });
        assert_eq!(found.as_slice(), published(&folder, &format!("{series}_results"), "Orient. repeat."), "{series}");
    }
}

#[test]
fn repeatability_of_a_standing_robot_agrees_with_kit_to_every_printed_digit() {
    let Some(folder) = folder() else { return };
    for series in [
        "Pose1Stationaer_fest",
        "Pose1Stationaer_freedrive",
        "PoseAussenStationaer_fest",
        "PoseAussenStationaer_freedrive",
    ] {
        let text = std::fs::read_to_string(folder.join(format!("tracker/{series}.txt"))).unwrap();
        let point = |line: &str| -> Option<Vector> {
            let cells: Vec<&str> = line.split(',').map(str::trim).collect();
            let number = |i: usize| cells.get(i)?.parse().ok();
            Some([number(3)?, number(4)?, number(5)?])
        };
        let points: Vec<Vector> = text.lines().filter_map(point).collect();
        assert!(points.len() > 2400, "{series}: {}", points.len());
        let found = format!("{:.5}", pose_repeatability(&points).unwrap().rp_mm);
        assert_eq!([found].as_slice(), published(&folder, "kin_stat_pos_repeat", series), "{series}");
    }
}

#[test]
fn the_command_prints_what_kit_print() {
    let Some(folder) = folder() else { return };
    for (series, _) in SERIES {
        let (mut poses, mut commanded) = ("pose,cycle,x_mm,y_mm,z_mm\n".to_owned(), "pose,x_mm,y_mm,z_mm\n".to_owned());
        for (pose, points) in (1..).zip(rows(&folder, series)) {
            commanded += &format!("{pose},2296,-2416,-442\n");
            for (cycle, [x, y, z]) in (1..).zip(points) {
                poses += &format!("{pose},{cycle},{x},{y},{z}\n");
            }
        }
        let here = tempfile::tempdir().unwrap();
        std::fs::write(here.path().join("poses.csv"), poses).unwrap();
        std::fs::write(here.path().join("commanded.csv"), commanded).unwrap();
        let answer = std::process::Command::new(crate::support::program())
            .args(["iso9283", "poses.csv", "--commanded", "commanded.csv", "--json"])
            .current_dir(here.path())
            .output()
            .unwrap();
        let list: Vec<serde_json::Value> = serde_json::from_slice(&answer.stdout).unwrap();
        let found: Vec<String> = list.iter().map(|p| format!("{:.4}", p["rp_mm"].as_f64().unwrap())).collect();
        assert_eq!(found, published(&folder, &format!("{series}_results"), "Pos. repeat."), "{series}");
    }
}
