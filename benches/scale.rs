//! Time of a run as targets and readings grow: an arm with 20 targets a pose, each target at four poses.
//!
//! Synthetic: the arm of the sample draw-wire at drawn joint values, 0.02 mm noise. The time of four times as many
//! readings is four times as long where it is linear. Then `etalon check` of targets at one place in each pose, also as a
//! rigid part, and `etalon formats` of tables with many columns: the last figure of each line is the growth of the time
//! over that of the size, 1 where it is linear.

#![allow(clippy::print_stdout)] // a benchmark prints

use etalon::base::folder::Durability;
use etalon::base::noise::Noise;
use etalon::campaign::{Campaign, read_robot};
use etalon::robots::Role;
use etalon::run::pipeline::{Wanted, run_for};
use std::path::Path;
use std::time::Instant;

/// The allocator of the program.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Targets at each pose.
const AT_A_POSE: usize = 20;

fn main() {
    let mut first = None;
    for poses in [50, 100, 200] {
        let targets = 5 * poses;
        let folder = campaign(poses, targets);
        let campaign = Campaign::read(folder.path()).expect("campaign");
        let start = Instant::now();
        run_for(&campaign, Wanted::Documents, Durability::Later).expect("run");
        let time_s = start.elapsed().as_secs_f64();
        let parameters = std::fs::metadata(folder.path().join("out/parameters.json")).expect("parameters.json").len();
        let factor = time_s / *first.get_or_insert(time_s);
        println!(
            "{poses} poses, {targets} targets, {} readings: {time_s:.2} s ({factor:.1} times), parameters.json {:.1} MB",
            poses * AT_A_POSE,
            parameters as f64 / 1e6
        );
    }
    for (what, rigid) in [("check, targets at one place", false), ("check, a rigid part at one place", true)] {
        growth(what, &[84, 334, 1667], |targets| {
            let folder = coinciding(targets, rigid);
            drop(etalon::tasks::check(folder.path()));
        });
    }
    growth("formats, columns", &[3_000, 12_000, 50_000], |columns| {
        let folder = wide(columns);
        drop(etalon::formats::propose_file(&folder.path().join("t.csv")));
    });
}

/// Ratio of the time of each size to that of the size before it, over the ratio of the sizes.
fn growth(what: &str, sizes: &[usize], mut work: impl FnMut(usize)) {
    let mut before: Option<(f64, f64)> = None;
    for &size in sizes {
        let start = Instant::now();
        work(size);
        let (size, time_s) = (size as f64, start.elapsed().as_secs_f64());
        let ratio = before.map_or(1.0, |(other, other_s)| time_s / other_s / (size / other));
        println!("{what}, {size}: {time_s:.2} s, {ratio:.2} of linear growth");
        before = Some((size, time_s));
    }
}

/// The sample hexapod with this many targets at one place in each pose.
fn coinciding(targets: usize, rigid: bool) -> tempfile::TempDir {
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/hexapod");
    let folder = tempfile::tempdir().expect("folder");
    std::fs::create_dir(folder.path().join("exports")).expect("folder");
    for name in ["robot.toml", "encoders.csv", "exports/world.txt"] {
        std::fs::copy(sample.join(name), folder.path().join(name)).expect("copy");
    }
    let mut noise = Noise::new(59, targets as u64);
    let mut rows = std::fs::read_to_string(sample.join("exports/poses.txt")).expect("poses");
    let own: Vec<String> = rows.lines().filter(|row| row.starts_with("SMR_1_")).map(str::to_owned).collect();
    for row in own.iter().filter(|row| row.split(',').next().is_some_and(|label| label.ends_with("_1"))) {
        let cells: Vec<&str> = row.split(',').collect();
        let at: Vec<f64> = cells[1..4].iter().map(|cell| cell.parse().expect("number")).collect();
        for k in 0..targets {
            let at: Vec<String> = at.iter().map(|v| format!("{:.4}", v + noise.gaussian(0.03))).collect();
            rows += &format!("{},{}\n", cells[0].replacen("SMR_1", &format!("D{k}"), 1), at.join(","));
        }
    }
    std::fs::write(folder.path().join("exports/poses.txt"), rows).expect("poses");
    let names: Vec<String> = (0..targets).map(|k| format!("\"D{k}\"")).collect();
    let text = std::fs::read_to_string(sample.join("campaign.toml")).expect("campaign");
    let mut text = text.replace("\"SMR_3\"]", &format!("\"SMR_3\", {}]", names.join(", ")));
    if rigid {
        text += &format!("\n[[rigid]]\ntargets = [{}]\ntolerance_mm = 0.05\n", names.join(", "));
    }
    std::fs::write(folder.path().join("campaign.toml"), text).expect("campaign");
    folder
}

/// A table of four rows with this many columns.
fn wide(columns: usize) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("folder");
    let mut noise = Noise::new(59, columns as u64);
    let head: Vec<String> = (0..columns).map(|i| format!("q{i}")).collect();
    let mut text = head.join(",");
    for _ in 0..4 {
        let row: Vec<String> = (0..columns).map(|_| format!("{:.3}", noise.uniform(100.0))).collect();
        text += &format!("\n{}", row.join(","));
    }
    std::fs::write(folder.path().join("t.csv"), text).expect("table");
    folder
}

/// The campaign of the sample with these poses and targets.
fn campaign(poses: usize, targets: usize) -> tempfile::TempDir {
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/draw-wire");
    let folder = tempfile::tempdir().expect("folder");
    let names: Vec<String> = (0..targets).map(|k| format!("T{k}")).collect();
    let robot = read_robot(&sample.join("robot.toml")).expect("robot.toml").build(&names).expect("robot");
    let mut noise = Noise::new(47, poses as u64);
    let mut values = robot.nominal();
    let places = robot.parameters().iter().zip(&mut values).filter(|(p, _)| p.role == Role::Target);
    places.for_each(|(_, value)| *value = noise.uniform(100.0));
    let mut rows = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for pose in 0..poses {
        let deg: Vec<f64> = (0..6).map(|_| noise.uniform(60.0)).collect();
        let joints: Vec<f64> = deg.iter().map(|q| q.to_radians()).collect();
        let deg: Vec<String> = deg.iter().map(f64::to_string).collect();
        for k in 0..AT_A_POSE {
            let target = (pose * AT_A_POSE + k) % targets;
            let at = robot.position(&values, &joints, target).map(|v| (v + noise.gaussian(0.02)).to_string());
            rows += &format!("{},{},{},{}\n", pose + 1, names[target], deg.join(","), at.join(","));
        }
    }
    for name in ["campaign.toml", "robot.toml"] {
        let text = std::fs::read_to_string(sample.join(name)).expect("sample");
        let text = text.replace("calibration = \"1-60\"", &format!("calibration = \"1-{}\"", poses * 4 / 5));
        std::fs::write(folder.path().join(name), text).expect("copy");
    }
    std::fs::write(folder.path().join("observations.csv"), rows).expect("observations");
    folder
}
