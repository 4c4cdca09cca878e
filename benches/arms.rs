//! Arms beside their peers, in the same run: direct kinematics with exact Jacobian of a seven-axis arm beside Pinocchio, and the
//! identification of 35 parameters from 11,900 poses of a six-axis arm beside SciPy.

#![allow(clippy::print_stdout)] // a benchmark prints

use etalon::base::noise::Noise;
use etalon::campaign::read_robot;
use etalon::identify::{Observation, Settings, identify};
use etalon::robots::{PUBLISHED, Parameter, Quantity, Robot, Role, State};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// The allocator of the program.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Configurations of the seven-axis arm.
const CONFIGURATIONS: usize = 10_000;
/// Poses of the six-axis arm, of which seven in ten are identified on.
const POSES: usize = 17_000;

fn main() {
    kinematics();
    identification();
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Joint values of so many axes between -1.5 and 1.5 rad.
fn drawn(noise: &mut Noise, axes: usize) -> Vec<f64> {
    (0..axes).map(|_| noise.uniform(1.5)).collect()
}

fn csv(rows: impl IntoIterator<Item = Vec<f64>>) -> String {
    let line = |row: Vec<f64>| row.iter().map(|v| format!("{v:e}")).collect::<Vec<_>>().join(",") + "\n";
    rows.into_iter().map(line).collect()
}

fn python(script: &str, arguments: &[&Path]) -> Option<Vec<f64>> {
    let output = Command::new(std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned()))
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("benches").join(script))
        .args(arguments)
        .envs([("OMP_NUM_THREADS", "1"), ("OPENBLAS_NUM_THREADS", "1")])
        .output()
        .ok()
        .filter(|output| output.status.success())?;
    String::from_utf8(output.stdout).ok()?.split_whitespace().map(|number| number.parse().ok()).collect()
}

/// A robot that differs from the nominal one, and has its reflector beside the last axis.
fn truth(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
    let of = |p: &Parameter| match (p.role, p.quantity) {
        (Role::Target, _) => 50.0 + noise.uniform(5.0),
        // bending and coupling
        _ if p.name.starts_with("co") => 0.0,
        (_, Quantity::Length) => p.nominal + noise.uniform(0.5),
        _ => p.nominal + noise.uniform(1e-3),
    };
    robot.parameters().iter().map(of).collect()
}

fn kinematics() {
    let folder = tempfile::tempdir().expect("folder");
    let mut text = "name = \"Franka\"\nmodel = \"serial\"\n".to_owned();
    let published = PUBLISHED.iter().find(|arm| arm.name == "panda").expect("Franka Research 3");
    let mut franka = published.rows.to_vec();
    // up to the flange
    franka[6][3] = 107.0;
    for [alpha, a, theta, d] in &franka {
        let _ = write!(text, "[[joint]]\nalpha_deg = {alpha}\na_mm = {a}\ntheta_deg = {theta}\nd_mm = {d}\n");
    }
    let file = folder.path().join("robot.toml");
    std::fs::write(&file, text).expect("robot");
    let robot = read_robot(&file).expect("robot").build(&["tool".to_owned()]).expect("robot");
    let (parameters, mut noise) = (robot.nominal(), Noise::new(1, 0));
    let joints: Vec<Vec<f64>> = (0..CONFIGURATIONS).map(|_| drawn(&mut noise, franka.len())).collect();
    let (mut at, mut by_joint) = ([0.0; 3], [0.0; 21]);
    let mut by_parameter = vec![0.0; 3 * parameters.len()];
    let (mut positions, mut jacobians) = (0.0, 0.0);
    let mut timed = |with_parameters: bool| {
        let begun = Instant::now();
        (positions, jacobians) = (0.0, 0.0);
        let parametrised = robot.parametrised(&parameters);
        for q in &joints {
            let state = State { joints: q, loads: &[] };
            if with_parameters {
                parametrised.positions(state, &mut at);
                parametrised.jacobian(state, &mut by_parameter);
                std::hint::black_box(&by_parameter);
            } else {
                parametrised.joint_jacobian(state, &mut at, &mut by_joint);
            }
            positions += at.iter().sum::<f64>();
            jacobians += by_joint.iter().sum::<f64>();
        }
        begun.elapsed().as_secs_f64() / joints.len() as f64
    };
    let parameters_too = median((0..21).map(|_| timed(true)).collect());
    let ours = median((0..21).map(|_| timed(false)).collect());
    println!(
        "seven axes, position and Jacobian: etalon {:.2} us by joints, {:.2} us by all {} parameters",
        1e6 * ours,
        1e6 * parameters_too,
        parameters.len()
    );
    let files = ["arm.csv", "joints.csv"].map(|name| folder.path().join(name));
    let rows = franka.iter().map(|[alpha, a, theta, d]| vec![alpha.to_radians(), *a, theta.to_radians(), *d]);
    std::fs::write(&files[0], csv(rows)).expect("arm");
    std::fs::write(&files[1], csv(joints.iter().cloned())).expect("joints");
    let Some(&[theirs, calls, p, j]) = python("arms_pinocchio.py", &[&files[0], &files[1]]).as_deref() else {
        println!("  Pinocchio: not there (python3 with pin)");
        return;
    };
    println!(
        "  Pinocchio from Python {:.2} us, {:.1} times etalon; one joint {:.2} us, so that six more take {:.2} us; its sums differ by \
         {:.0e} and {:.0e}",
        1e6 * theirs,
        theirs / ours,
        1e6 * calls,
        1e6 * (theirs - calls),
        (p - positions) / positions,
        (j - jacobians) / jacobians
    );
}

/// Poses of an IRB 120 with one reflector: 0.05 mm of noise, every parameter off by a thousandth of a radian, half a millimetre.
fn identification() {
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/abb-irb120/robot.toml");
    let robot = read_robot(&sample).expect("robot").build(&["R1".to_owned()]).expect("robot");
    let compliance = |name: &&String| name.starts_with("compliance_");
    let names: Vec<String> = robot.parameters().iter().map(|p| p.name.clone()).collect();
    let last = names.iter().rfind(compliance).expect("bending").clone();
    let settings = Settings { hold: vec!["coupling_*".to_owned(), last], ..Settings::default() };
    let mut noise = Noise::new(2, 0);
    let truth = truth(robot.as_ref(), &mut noise);
    let mut at = [0.0; 3];
    let mut observations = Vec::with_capacity(POSES);
    let mut table = "pose,target,x_mm,y_mm,z_mm,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n".to_owned();
    for pose in 1..=POSES {
        let joints = drawn(&mut noise, 6);
        robot.positions(&truth, &joints, &mut at);
        let target = at.map(|v| v + noise.gaussian(0.05));
        let degrees = joints.iter().map(|q| q.to_degrees());
        let cells: Vec<String> = target.into_iter().chain(degrees).map(|v| v.to_string()).collect();
        let _ = writeln!(table, "{pose},R1,{}", cells.join(","));
        if (pose - 1) % 10 < 7 {
            let pose = (pose as i64).into();
            observations.push(Observation {
                pose,
                cycle: 1,
                joints,
                targets: vec![Some(target)],
                ..Observation::default()
            });
        }
    }
    let mut parameters = 0;
    let times = (0..5).map(|_| {
        let begun = Instant::now();
        let found = identify(robot.as_ref(), &observations, &settings).expect("identified");
        parameters = found.free.len();
        begun.elapsed().as_secs_f64()
    });
    let ours = median(times.collect());
    println!("{} poses, {parameters} parameters: etalon {:.0} ms (median of 5)", observations.len(), 1e3 * ours);
    let folder = tempfile::tempdir().expect("folder");
    let file = folder.path().join("observations.csv");
    std::fs::write(&file, table).expect("observations");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/identify_scipy.py");
    let mut command = Command::new(std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned()));
    let Some(output) = command.arg(script).arg(&file).arg("2").output().ok().filter(|o| o.status.success()) else {
        println!("  SciPy: not there (python3 with numpy and scipy)");
        return;
    };
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let Some((name, seconds)) = line.rsplit_once(": ") else { continue };
        let seconds: f64 = seconds.parse().expect("seconds");
        println!("  SciPy {name}: {:.0} ms, {:.1} times etalon", seconds * 1e3, seconds / ours);
    }
}
