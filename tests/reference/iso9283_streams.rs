//! Two recordings of a robot that goes to and fro between two poses, at half and at full velocity (KIT, winter 2024/25).
//!
//! Their authors published neither the commanded path nor results of these files, and their stamps are full seconds. So the
//! sampling rate is stated here (1,000 Hz, which nothing confirms: times scale with it), the path is the straight line
//! between the two places, and what is asserted is what must hold whatever was commanded.

use super::iso9283::folder;
use etalon::base::pose::{Vector, cross, minus, norm, unit};
use etalon::documents::{Iso9283Path, Iso9283StreamDocument};
use std::path::Path;

/// Samples, and per cent of the velocity.
const RECORDINGS: [(&str, usize); 2] = [("50", 20_445), ("100", 13_545)];
/// RP of the same robot standing, as published: 0.0087 to 0.0147 mm (see `iso9283`).
const STANDING_MM: [f64; 2] = [0.008_74, 0.014_71];

fn samples(folder: &Path, velocity: &str) -> Vec<Vector> {
    let text = std::fs::read_to_string(folder.join(format!("tracker/Trajektoriezw1u2_vel{velocity}.txt"))).unwrap();
    let point = |line: &str| -> Option<Vector> {
        let cells: Vec<&str> = line.split(',').map(str::trim).collect();
        let number = |i: usize| cells.get(i)?.parse().ok();
        Some([number(3)?, number(4)?, number(5)?])
    };
    text.lines().filter_map(point).collect()
}

fn told(folder: &Path, velocity: &str, here: &Path, more: &[&str]) -> Iso9283StreamDocument {
    let stream = folder.join(format!("tracker/Trajektoriezw1u2_vel{velocity}.txt"));
    let fixed = "--columns -,-,-,x,y,z,- --delimiter comma --header 3 --unit mm --rate-hz 1000 --still-mm 0.05 --json";
    let answer = std::process::Command::new(crate::support::program())
        .args(["iso9283", "--stream"])
        .arg(stream)
        .args(fixed.split(' '))
        .args(more)
        .current_dir(here)
        .output()
        .unwrap();
    assert!(answer.status.success(), "{}", String::from_utf8_lossy(&answer.stderr));
    serde_json::from_slice(&answer.stdout).unwrap()
}

fn write_path(here: &Path, name: &str, points: &[Vector]) {
    let rows: String = points.iter().map(|[x, y, z]| format!("{x},{y},{z}\n")).collect();
    std::fs::write(here.join(name), format!("x_mm,y_mm,z_mm\n{rows}")).unwrap();
}

fn places(document: &Iso9283StreamDocument) -> [Vector; 2] {
    let of = |pose: i64| document.standstills.iter().find(|s| s.pose == Some(pose.into())).unwrap().mean_mm.clone();
    [1, 2].map(|pose| of(pose).try_into().unwrap())
}

#[test]
fn both_streams_are_cut_into_seven_stops_and_settle_within_what_the_robot_shakes() {
    let Some(folder) = folder() else { return };
    let here = tempfile::tempdir().unwrap();
    for (velocity, count) in RECORDINGS {
        let points = samples(&folder, velocity);
        assert_eq!(points.len(), count);
        let document = told(&folder, velocity, here.path(), &["--band-mm", "0.05"]);
        // the last sample of the faster recording is a point of another series, 300 mm away
        let foreign: &[usize] = if velocity == "100" { &[count + 3] } else { &[] };
        assert_eq!((document.samples, &document.left_out[..]), (count - foreign.len(), foreign));

        // by brute force: runs of samples around either place
        let [first, second] = places(&document);
        let near = |p: &Vector| norm(minus(*p, first)) < 0.1 || norm(minus(*p, second)) < 0.1;
        let runs = points.chunk_by(|a, b| near(a) == near(b)).filter(|run| near(&run[0]) && run.len() >= 200);
        let runs: Vec<Vector> = runs.map(|run| run[run.len() / 2]).collect();
        assert_eq!(document.standstills.len(), runs.len());
        for (i, (s, middle)) in document.standstills.iter().zip(&runs).enumerate() {
            assert_eq!((s.pose, s.cycle), (Some((i as i64 % 2 + 1).into()), Some(i as i64 / 2 + 1)));
            let mean: Vector = s.mean_mm.clone().try_into().unwrap();
            assert!(norm(minus(mean, *middle)) < 0.02, "{velocity}, stop {i}");
            // the tracker's noise and the hold of the robot: not above the published by more than what still swings
            assert!(s.noise_mm.unwrap() < STANDING_MM[1] + 0.005, "{velocity}, stop {i}: {:?}", s.noise_mm);
        }
        assert!(document.settling.iter().map(|s| s.arrivals).eq([3, 3]));
        for (s, p) in document.settling.iter().zip(&document.posing) {
            println!("velocity {velocity} %: {s:?} {p:?}");
            assert!((p.distance_mm - 323.81).abs() < 0.02);
            match velocity {
                // slowly it creeps in, fast it swings by a tenth of a millimetre
                "50" => assert_eq!((s.stabilisation_s, s.overshoot_mm), (0.0, 0.0)),
                _ => assert!(s.stabilisation_s > 0.0 && s.stabilisation_s < 0.1 && s.overshoot_mm < 0.12),
            }
        }
    }
}

#[test]
fn three_passes_each_way_repeat_to_some_hundredths_and_keep_the_same_path_at_both_velocities() {
    let Some(folder) = folder() else { return };
    let here = tempfile::tempdir().unwrap();
    let [first, second] = places(&told(&folder, "50", here.path(), &[]));
    write_path(here.path(), "there.csv", &[first, second]);
    write_path(here.path(), "back.csv", &[second, first]);
    let driven = |velocity: &str, path: &str| -> Iso9283Path {
        told(&folder, velocity, here.path(), &["--near-mm", "80", "--path", path]).path.unwrap()
    };
    for way in ["there.csv", "back.csv"] {
        let slow = driven("50", way);
        for (velocity, path) in [("50", slow.clone()), ("100", driven("100", way))] {
            println!("{velocity} %, {way}: AT {:.4} mm, RT {:.4} mm", path.at_mm, path.rt_mm.unwrap());
            assert_eq!((path.passes, path.incomplete), (3, 0));
            // more than the instrument and the standing robot shake, less than ten times that
            let rt = path.rt_mm.unwrap();
            assert!(rt > STANDING_MM[0] && rt < 10.0 * STANDING_MM[1], "{velocity} {rt}");
            // no sample is farther from the straight line than AT, but by its step to the nearest plane: the joints were
            // commanded, not a line
            let along = unit(minus(second, first)).unwrap();
            let points = samples(&folder, velocity);
            let off = points[..points.len() - 1].iter().map(|p| norm(cross(minus(*p, first), along)));
            assert!((path.at_mm - off.fold(0.0, f64::max)).abs() < 0.05, "{}", path.at_mm);
        }
        // the mean path of the slow passes as commanded path of the fast ones
        let mut mean: Vec<Vector> = slow.points.iter().map(|p| p.mean_mm.clone().try_into().unwrap()).collect();
        mean.dedup();
        write_path(here.path(), "mean.csv", &mean);
        let fast = driven("100", "mean.csv");
        println!("{way}: fast against slow AT {:.4} mm, RT {:.4} mm", fast.at_mm, fast.rt_mm.unwrap());
        assert!(fast.passes == 3 && fast.at_mm < 0.5, "{}", fast.at_mm);
    }
}
