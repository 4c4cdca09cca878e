//! Time of a run as targets and readings grow: an arm with 20 targets a pose, each target at four poses.
//!
//! Synthetic: the arm of the sample draw-wire at drawn joint values, 0.02 mm noise. The time of four times as many
//! readings is four times as long where it is linear.

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
