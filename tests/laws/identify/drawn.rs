//! Drawn robots, excitations and measurements (synthetic), for laws that hold whatever is measured.

use crate::support::five_bar;
use crate::support::root;
use crate::support::scratch::Scratch;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, norm};
use etalon::campaign::read_robot;
use etalon::identify::{Effects, Observation, Prior, Settings};
use etalon::math::statistics::rms;
use etalon::robots::{Parameter, Prexyt, Quantity, Robot, Role};
use std::fmt::Write;

/// A drawn robot and what is measured of it.
pub struct Drawn {
    /// The draw in words.
    pub what: String,
    pub robot: Box<dyn Robot>,
    pub calibration: Vec<Observation>,
    pub validation: Vec<Observation>,
    /// Standard deviation of a measured coordinate, mm.
    pub noise_mm: f64,
    /// `true` if the robot bends in a way that no model describes.
    pub bends: bool,
}

impl Drawn {
    pub fn settings(&self, prior: Prior) -> Settings {
        Settings { standard_uncertainty_mm: Some(self.noise_mm), prior, effects: Effects::Usual, ..Settings::default() }
    }

    /// Root mean square error at the validation poses, mm.
    pub fn error_mm(&self, values: &[f64]) -> f64 {
        let of =
            |o: &Observation| o.misses(self.robot.as_ref(), values).map(|(_, miss)| norm(miss)).collect::<Vec<_>>();
        rms(self.validation.iter().flat_map(of))
    }
}

/// A number of the environment, or `usual`.
pub fn number(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().map_or(usual, |text| text.parse().unwrap_or_else(|_| panic!("{name}: a number")))
}

/// A whole number from `from` to `to`.
pub fn whole(noise: &mut Noise, from: usize, to: usize) -> usize {
    from + (0.5 * (1.0 + noise.uniform(1.0)) * (to - from + 1) as f64).min((to - from) as f64) as usize
}

pub fn one_of<T: Copy>(noise: &mut Noise, of: &[T]) -> T {
    of[whole(noise, 0, of.len() - 1)]
}

pub fn between(noise: &mut Noise, from: f64, to: f64) -> f64 {
    0.5 * (from + to) + noise.uniform(0.5 * (to - from))
}

/// A number between `from` and `to` whose logarithm is uniform.
pub fn between_logs(noise: &mut Noise, from: f64, to: f64) -> f64 {
    between(noise, from.ln(), to.ln()).exp()
}

/// How poses are spread over a box.
#[derive(Clone, Copy, Debug)]
pub enum Excitation {
    /// Everywhere, with this share of each range.
    Volume(f64),
    /// Each coordinate moves fully, or hardly.
    Still,
    /// Along a line, with this share of its length.
    Line(f64),
    /// Along an arc.
    Arc,
}

impl Excitation {
    pub fn drawn(noise: &mut Noise) -> Self {
        match whole(noise, 0, 5) {
            0 | 1 => Self::Volume(1.0),
            2 => Self::Volume(one_of(noise, &[0.5, 0.2, 0.05, 0.01])),
            3 => Self::Still,
            4 => Self::Line(one_of(noise, &[1.0, 0.1])),
            _ => Self::Arc,
        }
    }

    /// Gives points of the box from -1 to 1 in `n` dimensions.
    pub fn points(self, noise: &mut Noise, n: usize, count: usize) -> Vec<Vec<f64>> {
        let vector = |half: f64, noise: &mut Noise| (0..n).map(|_| noise.uniform(half)).collect::<Vec<f64>>();
        let (first, second) = (vector(1.0, noise), vector(1.0, noise));
        let widths: Vec<f64> = (0..n).map(|_| one_of(noise, &[1.0, 1.0, 1e-2, 1e-4])).collect();
        let point = |noise: &mut Noise| match self {
            Self::Volume(share) => {
                first.iter().map(|middle| middle * (1.0 - share) + noise.uniform(share)).collect::<Vec<f64>>()
            }
            Self::Still => widths.iter().map(|&half| noise.uniform(half)).collect(),
            Self::Line(share) => {
                let along = noise.uniform(share);
                first.iter().zip(&second).map(|(d, middle)| along * d + middle * (1.0 - share)).collect()
            }
            Self::Arc => {
                let (sin, cos) = noise.uniform(1.5).sin_cos();
                first.iter().zip(&second).map(|(a, b)| 0.7 * (a * cos + b * sin)).collect()
            }
        };
        (0..count).map(|_| point(noise)).collect()
    }
}

/// Rows alpha (deg), a (mm), theta (deg), d (mm) of modified parameters.
fn table(noise: &mut Noise, joints: usize) -> Vec<[f64; 4]> {
    let row = |i: usize| {
        let alpha = if i == 0 { 0.0 } else { one_of(noise, &[0.0, 90.0, -90.0, -90.0]) };
        let long = i > 0 && (alpha == 0.0 || noise.uniform(1.0) > 0.0);
        let a = if long { between(noise, 40.0, 400.0).round() } else { 0.0 };
        let d = if noise.uniform(1.0) > 0.0 { between(noise, 60.0, 450.0).round() } else { 0.0 };
        [alpha, a, one_of(noise, &[0.0, 0.0, 90.0, -90.0]), d]
    };
    (0..joints).map(row).collect()
}

/// The robot of a table, as robot.toml of a convention states it.
fn arm(rows: &[[f64; 4]], convention: &str, targets: &[String]) -> Box<dyn Robot> {
    let mut toml = match convention {
        "urdf" => "model = \"urdf\"\nfile = \"arm.urdf\"\nbase_link = \"l0\"\ntool_link = \"flange\"\n".to_owned(),
        _ => format!("model = \"serial\"\nconvention = \"{convention}\"\n"),
    };
    let mut joints = String::new();
    let mut pose = Pose::identity();
    let mut urdf = "<robot name=\"arm\">\n<link name=\"l0\"/>\n".to_owned();
    let mut origin = Pose::identity();
    for (i, &[alpha, a, theta, d]) in rows.iter().enumerate() {
        pose = pose.turn_x(alpha.to_radians()).shift(0, a).turn_z(theta.to_radians()).shift(2, d);
        origin = origin.turn_x(alpha.to_radians()).shift(0, a);
        let n = i + 1;
        let _ = writeln!(urdf, "<link name=\"l{n}\"/>\n<joint name=\"q{n}\" type=\"revolute\">{}", xml(&origin));
        let _ = writeln!(urdf, "<parent link=\"l{i}\"/><child link=\"l{n}\"/><axis xyz=\"0 0 1\"/></joint>");
        origin = Pose::identity().turn_z(theta.to_radians()).shift(2, d);
        let [next_alpha, next_a] = rows.get(n).map_or([0.0; 2], |next| [next[0], next[1]]);
        let _ = match convention {
            "poe" => {
                write!(joints, "[[joint]]\ndirection = {:?}\npoint_mm = {:?}\n", pose.axis(2), pose.translation_mm)
            }
            "dh" => {
                let [alpha, a] = [next_alpha, next_a];
                writeln!(joints, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}")
            }
            "mdh" => {
                writeln!(joints, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}")
            }
            _ => Ok(()),
        };
    }
    if convention == "poe" {
        let angles = pose.rpy_rad().map(f64::to_degrees);
        let _ = write!(toml, "flange_xyz_mm = {:?}\nflange_rpy_deg = {angles:?}\n", pose.translation_mm);
    }
    let _ = writeln!(urdf, "<link name=\"flange\"/>\n<joint name=\"end\" type=\"fixed\">{}", xml(&origin));
    let _ = write!(urdf, "<parent link=\"l{}\"/><child link=\"flange\"/></joint>\n</robot>\n", rows.len());
    let scratch = Scratch::with(&[("robot.toml", &(toml + &joints)), ("arm.urdf", &urdf)]);
    read_robot(&scratch.path().join("robot.toml")).expect("robot.toml").build(targets).expect("an arm")
}

fn xml(pose: &Pose) -> String {
    let text = |v: [f64; 3]| v.map(|v| format!("{v:?}")).join(" ");
    format!("<origin xyz=\"{}\" rpy=\"{}\"/>", text(pose.translation_mm.map(|mm| mm / 1000.0)), text(pose.rpy_rad()))
}

/// Parameters of a robot with parts up to 1 mm and 0.3 deg off nominal, base and targets anywhere where they have no nominal values.
fn truth(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
    let mut value = |(i, p): (usize, &Parameter)| match (p.role, p.quantity) {
        _ if p.tolerance.is_finite() && p.quantity == Quantity::Length => p.nominal + noise.uniform(1.0),
        _ if p.tolerance.is_finite() && p.quantity == Quantity::Angle => p.nominal + noise.uniform(0.3f64.to_radians()),
        (_, Quantity::Ratio) => p.nominal,
        (Role::Base, Quantity::Angle) => noise.uniform(1.5),
        (Role::Base, _) => noise.uniform(1500.0),
        _ => noise.uniform(90.0) + 20.0 * (i % 2) as f64,
    };
    robot.parameters().iter().enumerate().map(&mut value).collect()
}

/// What a robot of these true parameters shows at joint values, behind what bends it; targets after the first are missing at times.
fn measured(
    robot: &dyn Robot,
    truth: &[f64],
    (joints, bent): (Vec<f64>, Vec<f64>),
    (pose, noise_mm): (i64, f64),
    noise: &mut Noise,
) -> Option<Observation> {
    let mut seen = |k: usize| {
        let at = robot.position(truth, &bent, k);
        let missing = noise_mm > 0.0 && k > 0 && noise.uniform(1.0) < -0.8;
        let mut read: Vector = at.map(|v| v + noise.gaussian(noise_mm));
        read[robot.dimension()..].fill(0.0);
        (!missing).then_some(read)
    };
    let targets: Vec<Option<Vector>> = (0..robot.targets().len()).map(&mut seen).collect();
    let reached = targets.iter().flatten().all(|p| p.iter().all(|v| v.is_finite()));
    reached.then(|| Observation { pose: pose.into(), cycle: 1, joints, targets, ..Observation::default() })
}

/// Joint values behind what no model describes: bending of joints 2 and 3 by up to 3e-4 rad, in regions of the joints.
fn bent(q: &[f64], bends: bool) -> Vec<f64> {
    let mut bent = q.to_vec();
    if bends {
        bent[1] += 3e-4 * (q[1] + 0.3).sin();
        bent[2] += 2e-4 * (q[1] + q[2]).cos();
    }
    bent
}

fn targets(count: usize) -> Vec<String> {
    (1..=count).map(|k| format!("T{k}")).collect()
}

/// An arm of 5 to 8 joints in a drawn convention, from narrow to wide excitation; half of them bend.
pub fn drawn_arm(seed: u64, most_poses: usize) -> Drawn {
    let mut noise = Noise::new(40, seed);
    let n = whole(&mut noise, 5, 8);
    let convention = one_of(&mut noise, &["mdh", "dh", "poe", "urdf"]);
    let rows = table(&mut noise, n);
    let count = whole(&mut noise, 1, 3);
    let robot = arm(&rows, convention, &targets(count));
    let truth = truth(robot.as_ref(), &mut noise);
    let width = one_of(&mut noise, &[1.0, 1.0, 0.5, 0.2, 0.05]);
    let range = |noise: &mut Noise| {
        let half = if noise.uniform(1.0) > -0.7 { 2.6 * width } else { 0.0 };
        [noise.uniform(2.6 - half), half]
    };
    let ranges: Vec<[f64; 2]> = (0..n).map(|_| range(&mut noise)).collect();
    let noise_mm = between_logs(&mut noise, 0.005, 0.1);
    let bends = noise.uniform(1.0) > 0.0;
    let poses = between_logs(&mut noise, 3.0, most_poses as f64).round() as usize;
    let mut observe = |pose: i64, sd_mm: f64| {
        let joints: Vec<f64> = ranges.iter().map(|[middle, half]| middle + noise.uniform(*half)).collect();
        let bent = bent(&joints, bends);
        measured(robot.as_ref(), &truth, (joints, bent), (pose, sd_mm), &mut noise)
            .expect("an arm reaches any joint values")
    };
    let calibration: Vec<Observation> = (1..=poses as i64).map(|i| observe(i, noise_mm)).collect();
    let mut validation: Vec<Observation> = (1..=60).map(|i| observe(1000 + i, 0.0)).collect();
    // a target that no calibration pose shows is nowhere
    for k in (0..count).filter(|&k| calibration.iter().all(|o| o.targets[k].is_none())) {
        validation.iter_mut().for_each(|o| o.targets[k] = None);
    }
    let what = format!(
        "{seed}: {convention}, {n} joints, {count} targets, {poses} poses, width {width}, noise {noise_mm:.3}, bends {bends}"
    );
    Drawn { what, robot, calibration, validation, noise_mm, bends }
}

/// Any robot, measured in any way.
pub fn drawn_problem(seed: u64) -> Drawn {
    let mut noise = Noise::new(41, seed);
    let kind = whole(&mut noise, 0, 9);
    let poses = between_logs(&mut noise, 3.0, 500.0).round() as usize;
    let noise_mm = between_logs(&mut noise, 0.002, 0.2);
    let excitation = Excitation::drawn(&mut noise);
    let bends = kind < 6 && noise.uniform(1.0) > 0.3;
    let (name, robot, joints) = match kind {
        0..6 => {
            let n = whole(&mut noise, 5, 8);
            let convention = one_of(&mut noise, &["mdh", "dh", "poe", "urdf"]);
            let robot = arm(&table(&mut noise, n), convention, &targets(one_of(&mut noise, &[1, 2, 3])));
            let points = excitation.points(&mut noise, n, poses);
            let joints = points.into_iter().map(|q| q.iter().map(|v| 2.6 * v).collect()).collect();
            (convention, robot, joints)
        }
        6 => table_problem(&mut noise, excitation, poses),
        7 => five_bar_problem(&mut noise, excitation, poses),
        8 => platform_problem(&mut noise, ("delta", [0.0, 0.0, -750.0], 180.0, 0.0), excitation, poses),
        _ => platform_problem(&mut noise, ("hexapod", [0.0, 0.0, 400.0], 60.0, 0.3), excitation, poses),
    };
    let truth = truth(robot.as_ref(), &mut noise);
    let observe = |(i, q): (usize, &Vec<f64>)| {
        measured(robot.as_ref(), &truth, (q.clone(), bent(q, bends)), (i as i64 + 1, noise_mm), &mut noise)
    };
    let calibration: Vec<Observation> = joints.iter().enumerate().filter_map(observe).collect();
    let what = format!(
        "{seed}: {name}, {} joints, {} targets, {} poses, {excitation:?}, noise {noise_mm:.4}, bends {bends}",
        robot.joints().len(),
        robot.targets().len(),
        calibration.len()
    );
    Drawn { what, robot, calibration, validation: Vec::new(), noise_mm, bends }
}

type Problem = (&'static str, Box<dyn Robot>, Vec<Vec<f64>>);

fn table_problem(noise: &mut Noise, excitation: Excitation, poses: usize) -> Problem {
    let points = excitation.points(noise, 3, poses);
    let joints = points.iter().map(|p| vec![85.0 + 80.0 * p[0], 150.0 + 140.0 * p[1], 150.0 + 140.0 * p[2]]);
    ("prexyt", Box::new(Prexyt::default()), joints.collect())
}

fn five_bar_problem(noise: &mut Noise, excitation: Excitation, poses: usize) -> Problem {
    let robot = five_bar::robot();
    let nominal = robot.nominal();
    let points = excitation.points(noise, 2, poses);
    let joints = |p: &Vec<f64>| {
        let e = robot.to_base(&nominal, [250.0 + 250.0 * p[0], 60.0 + 300.0 * p[1]]);
        robot.reached(&nominal, e).first().map(|mode| vec![mode.joints_rad[0], mode.joints_rad[1], mode.assembly])
    };
    let mut joints: Vec<Vec<f64>> = points.iter().filter_map(joints).collect();
    if joints.len() < 3 {
        // these positions are out of reach: others
        let all = Excitation::Volume(1.0).points(noise, 2, 20 * poses.max(5));
        let e = |p: &Vec<f64>| robot.to_base(&nominal, [250.0 + 250.0 * p[0], 60.0 + 300.0 * p[1]]);
        let reached = all.iter().filter_map(|p| {
            let mode = robot.reached(&nominal, e(p)).first().copied()?;
            Some(vec![mode.joints_rad[0], mode.joints_rad[1], mode.assembly])
        });
        joints = reached.take(poses).collect();
    }
    ("five_bar", Box::new(robot), joints)
}

fn platform_problem(
    noise: &mut Noise,
    (name, center, range_mm, range_rad): (&'static str, Vector, f64, f64),
    excitation: Excitation,
    poses: usize,
) -> Problem {
    let file = root().join(format!("docs/keys/robot-{name}.toml"));
    let robot = read_robot(&file).expect("robot.toml").build(&targets(whole(noise, 1, 3))).expect("a platform");
    let (nominal, near) = (robot.nominal(), vec![0.0; robot.joints().len()]);
    let joints = |p: Vec<f64>| {
        let turn = [0, 1, 2].map(|i| range_rad * p[3 + i]);
        let translation_mm = [0, 1, 2].map(|i| center[i] + range_mm * p[i]);
        let pose = Pose { translation_mm, ..Pose::from_rotation_vector(turn) };
        robot.kinematics().and_then(|k| k.nearest_joints(&nominal, &pose, &near).ok())
    };
    let mut reached: Vec<Vec<f64>> = excitation.points(noise, 6, poses).into_iter().filter_map(joints).collect();
    if reached.len() < 3 {
        // these poses are out of reach: others
        let all = Excitation::Volume(1.0).points(noise, 6, 20 * poses.max(5));
        reached = all.into_iter().filter_map(joints).take(poses).collect();
    }
    (name, robot, reached)
}
