//! Drawn arms: six, five and seven joints in all conventions, and a SCARA, with errors of manufacture and measurements of a tracker. The data are
//! synthetic.

use crate::support::scratch::Scratch;
use etalon::base::noise::Noise;
use etalon::base::pose::Pose;
use etalon::robots::{JointChain, Quantity, Role};
use std::fmt::Write as _;

/// Conventions of the description.
const CONVENTIONS: [&str; 4] = ["mdh", "dh", "poe", "urdf"];

/// A number from `from` to `to`.
fn between(noise: &mut Noise, from: f64, to: f64) -> f64 {
    0.5 * (from + to) + noise.uniform(0.5 * (to - from))
}

/// A campaign on an arm of five to seven joints, off by up to 0.5 mm and 3 mrad, of half of them with gains that are identified.
pub fn drawn(seed: u64) -> Scratch {
    let mut noise = Noise::new(42, seed);
    let n = [6, 6, 5, 7][seed as usize % 4];
    let convention = CONVENTIONS[(seed + seed / 4) as usize % 4];
    let table = if convention == "dh" { "dh" } else { "mdh" };
    let mut text = format!("name = \"arm\"\nmodel = \"serial\"\nconvention = \"{table}\"\n");
    for i in 0..n {
        let right = if noise.uniform(1.0) > 0.0 { 90.0 } else { -90.0 };
        let alpha = if i == 0 || i > 1 && noise.uniform(1.0) > 0.5 { 0.0 } else { right };
        let a = if i > 0 && (alpha == 0.0 || noise.uniform(1.0) > 0.0) {
            between(&mut noise, 40.0, 400.0).round()
        } else {
            0.0
        };
        let d = if noise.uniform(1.0) > 0.0 { between(&mut noise, 60.0, 450.0).round() } else { 0.0 };
        let theta = [0.0, 0.0, 90.0, -90.0][(2.0 + noise.uniform(2.0)).floor().clamp(0.0, 3.0) as usize];
        let _ = writeln!(text, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}");
    }
    let gains = seed % 8 < 4;
    measured(&mut noise, &text, convention, if gains { 1e-3 } else { 0.0 })
}

/// A campaign on a SCARA of four joints, as in `docs/keys`.
pub fn scara() -> Scratch {
    let text = include_str!("../../../docs/keys/robot-serial-poe.toml").to_owned()
        + "\n[[joint]]\ndirection = [0.0, 0.0, -1.0]\npoint_mm = [600.0, 0.0, 0.0]\n";
    measured(&mut Noise::new(43, 0), &text, "poe as it is", 1e-3)
}

/// A campaign on a UR10 by the Denavit-Hartenberg table of its manufacturer (support.universal-robots.com, DH parameters for calculations of
/// kinematics and dynamics), off by up to 0.5 mm and 3 mrad.
pub fn universal_robot(seed: u64) -> Scratch {
    let table = [
        [90.0, 0.0, 0.0, 127.3],
        [0.0, -612.0, 0.0, 0.0],
        [0.0, -572.3, 0.0, 0.0],
        [90.0, 0.0, 0.0, 163.941],
        [-90.0, 0.0, 0.0, 115.7],
        [0.0, 0.0, 0.0, 92.2],
    ];
    let mut text = "name = \"arm\"\nmodel = \"serial\"\nconvention = \"dh\"\n".to_owned();
    for [alpha, a, theta, d] in table {
        let _ = writeln!(text, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}");
    }
    measured(&mut Noise::new(44, seed), &text, "dh", if seed.is_multiple_of(2) { 1e-3 } else { 0.0 })
}

/// Measurements of an arm in a description, which is written in a convention. Gains are off by up to `gains` and identified, if any are.
fn measured(noise: &mut Noise, text: &str, convention: &str, gains: f64) -> Scratch {
    let effects = if gains > 0.0 { "\"all\"" } else { "[\"zeros\", \"geometry\"]" };
    let campaign = format!(
        "name = \"arm\"\nrobot = \"robot.toml\"\ncontrollers = [\"json\"]\nsynthetic = \"drawn for a test\"\n\
         [instrument]\nname = \"tracker\"\nexpanded_uncertainty_um = 20\ncoverage_factor = 2\n\
         [observations]\nfile = \"observations.csv\"\n\
         [identify]\neffects = {effects}\ncalibration = \"1-60\"\nvalidation = \"rest\"\n"
    );
    let empty = "pose,target,x_mm,y_mm,z_mm\n";
    let scratch = Scratch::with(&[("campaign.toml", &campaign), ("robot.toml", text), ("observations.csv", empty)]);
    let path = scratch.path().join("robot.toml");
    let read = || etalon::campaign::read_robot(&path).unwrap().build(&["tool".to_owned()]).unwrap();
    let mut robot = read();
    let chain = robot.joint_chain(&robot.nominal()).unwrap();
    match convention {
        "poe" => std::fs::write(&path, screws(&chain)).unwrap(),
        "urdf" => {
            std::fs::write(scratch.path().join("arm.urdf"), urdf(&chain)).unwrap();
            let text = "name = \"arm\"\nmodel = \"urdf\"\nfile = \"arm.urdf\"\nbase_link = \"base_link\"\ntool_link = \"tool\"\n";
            std::fs::write(&path, text).unwrap();
        }
        _ => {}
    }
    robot = read();
    let mut value = |p: &etalon::robots::Parameter| match (p.role, p.quantity) {
        (Role::Base, Quantity::Angle) => noise.uniform(0.3),
        (Role::Base, _) => noise.uniform(900.0),
        (Role::Target, _) => 60.0 + noise.uniform(40.0),
        (_, Quantity::Length) => p.nominal + noise.uniform(0.5),
        (_, Quantity::Angle) => p.nominal + noise.uniform(3e-3),
        (_, Quantity::Ratio) => p.nominal + noise.uniform(gains),
    };
    let truth: Vec<f64> = robot.parameters().iter().map(&mut value).collect();
    let columns: Vec<String> = robot.joints().iter().map(etalon::robots::Joint::column).collect();
    let mut table = format!("pose,target,{},x_mm,y_mm,z_mm\n", columns.join(","));
    for pose in 1..=90 {
        let q: Vec<f64> = robot.joints().iter().map(|_| noise.uniform(110.0)).collect();
        let inward: Vec<f64> = robot.joints().iter().zip(&q).map(|(j, q)| j.quantity.inward(*q)).collect();
        let at = robot.position(&truth, &inward, 0).map(|v| v + noise.gaussian(0.01));
        let row: Vec<String> = q.iter().chain(&at).map(f64::to_string).collect();
        let _ = writeln!(table, "{pose},tool,{}", row.join(","));
    }
    std::fs::write(scratch.path().join("observations.csv"), table).unwrap();
    scratch
}

/// Frames of the joints in the base, and the flange.
fn frames(chain: &JointChain) -> Vec<Pose> {
    let mut at = Pose::identity();
    let mut all: Vec<Pose> = Vec::new();
    for joint in &chain.joints {
        at = at.then(&joint.origin);
        all.push(at);
    }
    all.push(at.then(&chain.flange));
    all
}

/// Roll, pitch and yaw (rad) of Rz(yaw) Ry(pitch) Rx(roll).
fn roll_pitch_yaw(pose: &Pose) -> [f64; 3] {
    let r = &pose.rotation;
    let pitch = (-r[2][0]).atan2(r[0][0].hypot(r[1][0]));
    match r[0][0].hypot(r[1][0]) {
        level if level < 1e-9 => [0.0, pitch, (-r[0][1]).atan2(r[1][1])],
        _ => [r[2][1].atan2(r[2][2]), pitch, r[1][0].atan2(r[0][0])],
    }
}

/// The arm in screw axes.
fn screws(chain: &JointChain) -> String {
    let all = frames(chain);
    let (flange, axes) = all.split_last().unwrap();
    let mut text = "name = \"arm\"\nmodel = \"serial\"\nconvention = \"poe\"\n".to_owned();
    let rpy = roll_pitch_yaw(flange).map(f64::to_degrees);
    let _ = writeln!(text, "flange_xyz_mm = {:?}\nflange_rpy_deg = {rpy:?}", flange.translation_mm);
    for axis in axes {
        let _ = writeln!(text, "[[joint]]\ndirection = {:?}\npoint_mm = {:?}", axis.axis(2), axis.translation_mm);
    }
    text
}

/// The arm as a URDF.
fn urdf(chain: &JointChain) -> String {
    let mut text = "<robot name=\"arm\">\n  <link name=\"base_link\"/>\n".to_owned();
    let mut parent = "base_link".to_owned();
    let origins = chain.joints.iter().map(|j| &j.origin).chain([&chain.flange]);
    for (i, origin) in (1..).zip(origins) {
        let last = i > chain.joints.len();
        let (child, kind) = if last { ("tool".to_owned(), "fixed") } else { (format!("link_{i}"), "continuous") };
        let [x, y, z] = origin.translation_mm.map(|mm| mm / 1000.0);
        let [roll, pitch, yaw] = roll_pitch_yaw(origin);
        let _ = writeln!(
            text,
            "  <link name=\"{child}\"/>\n  <joint name=\"q{i}\" type=\"{kind}\">\n    <parent link=\"{parent}\"/><child link=\"{child}\"/>\n    \
             <origin xyz=\"{x:?} {y:?} {z:?}\" rpy=\"{roll:?} {pitch:?} {yaw:?}\"/><axis xyz=\"0 0 1\"/>\n  </joint>"
        );
        parent = child;
    }
    text + "</robot>\n"
}
