//! Platforms on legs: hexapod and deltas. Direct and inverse kinematics, what of them is identifiable, and intervals that hold.

use crate::robots::models::{jacobian_is_the_numeric_derivative, joint_jacobian_is_the_numeric_derivative};
use crate::support::root;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::campaign::read_robot;
use etalon::identify::{
    Condition, Fixture, Identification, Kind, Observation, Orientation, Settings, Status, identify,
};
use etalon::robots::{Robot, Role};
use nalgebra::{Matrix3, Rotation3, Vector3};
use rayon::prelude::*;

/// A model, and the poses of its platform that are drawn.
struct Model {
    name: &'static str,
    center_mm: Vector,
    range_mm: f64,
    range_rad: f64,
    /// How many parameters of the legs base and targets take up.
    gauge: usize,
}

const HEXAPOD: Model =
    Model { name: "hexapod", center_mm: [0.0, 0.0, 400.0], range_mm: 60.0, range_rad: 0.3, gauge: 12 };
const DELTA: Model = Model { name: "delta", center_mm: [0.0, 0.0, -750.0], range_mm: 180.0, range_rad: 0.0, gauge: 12 };
const LINEAR: Model =
    Model { name: "delta_linear", center_mm: [0.0, 0.0, 150.0], range_mm: 110.0, range_rad: 0.0, gauge: 12 };
const MODELS: [&Model; 3] = [&HEXAPOD, &DELTA, &LINEAR];

impl Model {
    fn robot(&self, targets: &[&str]) -> Box<dyn Robot> {
        let file = format!("docs/keys/robot-{}.toml", self.name);
        let robot = read_robot(&root().join(file)).unwrap();
        robot.build(&targets.iter().map(|t| (*t).to_owned()).collect::<Vec<_>>()).unwrap()
    }

    /// A pose of the platform in the base.
    fn pose(&self, noise: &mut Noise) -> Pose {
        let at = self.center_mm.map(|v| v + noise.uniform(self.range_mm));
        let turn = [0; 3].map(|_| noise.uniform(self.range_rad));
        Pose { translation_mm: at, ..Pose::from_rotation_vector(turn) }
    }

    /// The legs off by half a millimetre and two milliradians, base and targets anywhere.
    fn truth(&self, robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
        let of = |p: &etalon::robots::Parameter| match (p.role, p.name.starts_with("base_r")) {
            (Role::Base, true) => noise.uniform(1.0),
            (Role::Base, false) => noise.uniform(2000.0),
            (Role::Robot, _) if p.quantity.unit() == "deg" => p.nominal + noise.uniform(2e-3),
            (Role::Robot, _) => p.nominal + noise.uniform(0.5),
            _ => noise.uniform(100.0),
        };
        robot.parameters().iter().map(of).collect()
    }

    /// Joint values of a drawn pose, by the nominal inverse kinematics.
    fn joints(&self, robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
        loop {
            let pose = self.pose(noise);
            let near = vec![0.0; robot.joints().len()];
            if let Ok(joints) = robot.kinematics().unwrap().nearest_joints(&robot.nominal(), &pose, &near) {
                return joints;
            }
        }
    }
}

#[test]
fn jacobians_of_platforms() {
    for model in MODELS {
        let robot = model.robot(&["a", "b"]);
        let mut noise = Noise::new(18, 0);
        for _ in 0..5 {
            let joints = model.joints(robot.as_ref(), &mut noise);
            jacobian_is_the_numeric_derivative(robot.as_ref(), &joints);
            joint_jacobian_is_the_numeric_derivative(robot.as_ref(), &joints);
            turns_are_the_numeric_derivative(robot.as_ref(), &joints);
        }
    }
}

fn turns_are_the_numeric_derivative(robot: &dyn Robot, joints: &[f64]) {
    let (arm, n, h) = (robot.free_base().unwrap(), robot.parameters().len(), 1e-5);
    let p: Vec<f64> = robot.nominal().iter().enumerate().map(|(i, v)| v + 0.01 * ((i * 5) % 7) as f64).collect();
    let mut turns = vec![0.0; 3 * n];
    arm.flange_turns(&p, joints, 0, &mut turns);
    for j in 0..n {
        let at = |by: f64| {
            let mut moved = p.clone();
            moved[j] += by;
            arm.flange(&moved, joints, 0)
        };
        let turned = at(h).then(&at(-h).inverse()).rotation_vector_rad();
        for i in 0..3 {
            let numeric = turned[i] / (2.0 * h);
            assert!((turns[i * n + j] - numeric).abs() < 1e-8, "{}: {numeric}", robot.parameters()[j].name);
        }
    }
}

/// Inverse kinematics of a hexapod are lengths of vectors, here by nalgebra; direct ones lead back, over the whole workspace. Beyond it
/// another assembly mode may have the same lengths: then it is that.
#[test]
fn hexapod_there_and_back() {
    let robot = HEXAPOD.robot(&["a"]);
    let arm = robot.kinematics().unwrap();
    let mut noise = Noise::new(18, 1);
    let p = HEXAPOD.truth(robot.as_ref(), &mut noise);
    let lengths = |pose: &Pose| -> Vec<f64> {
        let turn = Matrix3::from_fn(|i, j| pose.rotation[i][j]);
        let of = |leg: &[f64]| {
            let (b, a) = (Vector3::from_column_slice(&leg[..3]), Vector3::from_column_slice(&leg[3..6]));
            (turn * a + Vector3::from(pose.translation_mm) - b).norm() - leg[6]
        };
        p[9..].chunks_exact(7).map(of).collect()
    };
    let same = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    for (range_mm, range_rad, most) in [(100.0, 0.4, 0), (150.0, 0.7, 100)] {
        let wide = Model { range_mm, range_rad, ..HEXAPOD };
        let mut others = 0;
        for _ in 0..2000 {
            let pose = wide.pose(&mut noise);
            let joints = lengths(&pose);
            let there = arm.tool_pose(&p, &joints).unwrap_or_else(|| panic!("{pose:?}"));
            assert!(same(&lengths(&there), &joints), "{pose:?}");
            let back = arm.all_joints(&p, &pose);
            let off = norm(minus(there.translation_mm, pose.translation_mm));
            if off < 1e-9 && there.inverse().then(&pose).angle_rad() < 1e-11 {
                assert!(back.len() == 1 && same(&back[0], &joints), "{back:?} {joints:?}");
            } else {
                assert!(back.is_empty() && off > 1e-3, "{off:e} {pose:?}");
                others += 1;
            }
        }
        println!("{others} of 2000 poses are in another assembly mode");
        assert!(others <= most, "{others}");
    }
    // the mirrored platform has the same leg lengths and is another assembly mode
    let below = Pose { translation_mm: [0.0, 0.0, -400.0], ..Pose::identity() };
    assert!(arm.all_joints(&robot.nominal(), &below).is_empty());
    assert!(arm.tool_pose(&robot.nominal(), &[-300.0; 6]).is_none());
    let violation = arm.limit_violation(&robot.nominal(), &[75.0, 75.0, 75.0, 75.0, 75.0, 151.0]).unwrap();
    let (joint, value) = (&violation.arguments["joint"], &violation.arguments["q"]);
    assert!(violation.id == "joint-beyond-limits" && *joint == "leg6" && *value == 151.0, "{violation}");
}

/// A joint of a delta's platform is a rod's length from elbow or carriage, here by rotations of nalgebra; and of all ways the one of the
/// joints that were set is found.
#[test]
fn deltas_there_and_back() {
    let mut noise = Noise::new(18, 2);
    for model in [&DELTA, &LINEAR] {
        let robot = model.robot(&["a"]);
        let arm = robot.kinematics().unwrap();
        let p = model.truth(robot.as_ref(), &mut noise);
        let turn = |axis: usize, angle: f64| {
            Rotation3::from_axis_angle(&[Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()][axis], angle)
        };
        let mut ways = 0;
        for _ in 0..2000 {
            let joints = model.joints(robot.as_ref(), &mut noise);
            let pose = arm.tool_pose(&p, &joints).unwrap();
            let azimuths = if model.name == "delta" { [0.0, 120.0, 240.0] } else { [210.0, 330.0, 90.0f64] };
            for (leg, p) in p[9..].chunks_exact((p.len() - 9) / 3).enumerate() {
                let azimuth = turn(2, azimuths[leg].to_radians());
                let (end, rod, radius) = if model.name == "delta" {
                    let motor = turn(2, p[3]) * turn(0, p[4]);
                    let elbow = motor * turn(1, joints[leg] + p[6]) * Vector3::new(p[5], 0.0, 0.0);
                    (Vector3::new(p[0], p[1], p[2]) + elbow, p[7], p[8])
                } else {
                    let carriage = turn(1, p[1]) * turn(0, p[2]) * Vector3::new(0.0, 0.0, joints[leg] + p[0]);
                    (Vector3::new(p[3], p[4], 0.0) + carriage, p[5], p[6])
                };
                let to = Vector3::from(pose.translation_mm) + azimuth * Vector3::new(radius, 0.0, 0.0);
                assert!(((to - azimuth * end).norm() - rod).abs() < 1e-9);
                assert!(to.z < (azimuth * end).z, "the platform is below");
            }
            assert!(pose.angle_rad() == 0.0);
            let back = arm.all_joints(&p, &pose);
            let same = |q: &Vec<f64>| q.iter().zip(&joints).all(|(a, b)| (a - b).abs() < 1e-9);
            assert_eq!(back.iter().filter(|q| same(q)).count(), 1, "{back:?} {joints:?}");
            ways = ways.max(back.len());
        }
        println!("{}: {ways} ways to a pose at most", model.name);
        let tilted = Pose { translation_mm: model.center_mm, ..Pose::from_rotation_vector([0.01, 0.0, 0.0]) };
        assert!(arm.all_joints(&p, &tilted).is_empty());
        let beside = Pose { translation_mm: [1100.0, 0.0, -200.0], ..Pose::identity() };
        assert!(arm.all_joints(&p, &beside).is_empty());
    }
}

/// A simulated campaign: positions of three targets, or a body of one target and its orientation.
struct Campaign {
    robot: Box<dyn Robot>,
    truth: Vec<f64>,
    observations: Vec<Observation>,
    settings: Settings,
}

const U_MM: f64 = 0.02;
const U_RAD: f64 = 1e-4;

/// What is measured of a platform: points or poses, at so many random poses.
#[derive(Clone, Copy)]
struct Design<'a> {
    model: &'a Model,
    kind: &'a str,
    count: usize,
}

impl Design<'_> {
    /// A campaign with errors of measurement or without; parameters called `nominal` are as drawn.
    fn campaign(self, seed: [u64; 2], errors: f64, nominal: &[String]) -> Campaign {
        let Self { model, kind, count } = self;
        let mut noise = Noise::new(seed[0], seed[1]);
        let mut robot = model.robot(if kind == "pose" { &["a"] } else { &["a", "b", "c"] });
        let mounting = if kind == "pose" { Some(Fixture::Mounting("a").add_to(robot.as_mut())) } else { None };
        let mut truth = model.truth(robot.as_ref(), &mut noise);
        if let Some(first) = mounting {
            truth[first..].fill(0.3);
        }
        for (value, p) in truth.iter_mut().zip(robot.parameters()).filter(|(_, p)| nominal.contains(&p.name)) {
            *value = p.nominal;
        }
        let (mut observations, mut conditions) = (Vec::new(), Vec::new());
        for i in 0..count {
            let joints = model.joints(robot.as_ref(), &mut noise);
            let pose = (i as i64 + 1).into();
            let mut seen = |k| Some(robot.position(&truth, &joints, k).map(|v| v + errors * noise.gaussian(U_MM)));
            let targets = (0..robot.targets().len()).map(&mut seen).collect();
            observations.push(Observation {
                pose,
                cycle: 1,
                joints: joints.clone(),
                targets,
                ..Observation::default()
            });
            let Some(mounting) = mounting else { continue };
            let turn = |v: Vector| Rotation3::from_scaled_axis(Vector3::from(v));
            let flange = robot.free_base().unwrap().flange(&truth, &joints, 0).rotation;
            let flange = Rotation3::from_matrix_unchecked(Matrix3::from_fn(|i, j| flange[i][j]));
            let body = turn([0; 3].map(|_| errors * noise.gaussian(U_RAD))) * flange * turn([0.3; 3]);
            let rotation = std::array::from_fn(|i| std::array::from_fn(|j| body[(i, j)]));
            let kind = Kind::Orientation(Orientation {
                frame_T_body: Pose { rotation, translation_mm: [0.0; 3] },
                station: None,
                mounting,
            });
            conditions.push(Condition { pose, cycle: 1, joints, target: 0, kind, standard_uncertainty: U_RAD });
        }
        let settings = Settings { standard_uncertainty_mm: Some(U_MM), conditions, ..Settings::default() };
        Campaign { robot, truth, observations, settings }
    }
}

impl Campaign {
    fn identify(&self) -> Identification {
        identify(self.robot.as_ref(), &self.observations, &self.settings).unwrap_or_else(|e| panic!("{e:?}"))
    }

    fn held(&self, found: &Identification) -> Vec<String> {
        let all = self.robot.parameters().iter().zip(&found.status);
        all.filter(|(_, s)| **s == Status::NotIdentifiable).map(|(p, _)| p.name.clone()).collect()
    }
}

/// What base, targets and mounting take up is found and held, as many as the frames are free; all else is the truth again.
#[test]
fn platforms_without_noise_give_the_truth() {
    for model in MODELS {
        for kind in ["point", "pose"] {
            let design = Design { model, kind, count: 60 };
            let first = design.campaign([19, 0], 0.0, &[]);
            let held = first.held(&first.identify());
            println!("{} by {kind}: held {held:?}", model.name);
            assert_eq!(held.len(), model.gauge, "{} by {kind}: {held:?}", model.name);
            // with these as drawn, the others are determined
            let campaign = design.campaign([19, 1], 0.0, &held);
            let found = campaign.identify();
            assert_eq!(campaign.held(&found), held);
            for &i in &found.free {
                let off = (found.values[i] - campaign.truth[i]).abs();
                assert!(
                    off < 1e-9,
                    "{} by {kind}: {} is off by {off:e}",
                    model.name,
                    campaign.robot.parameters()[i].name
                );
            }
        }
    }
}

fn draws() -> u64 {
    std::env::var("ETALON_DRAWS").map_or(60, |n| n.parse().unwrap())
}

#[test]
fn intervals_of_platforms_hold() {
    for model in MODELS {
        for kind in ["point", "pose"] {
            let design = Design { model, kind, count: 50 };
            let first = design.campaign([20, 0], 0.0, &[]);
            let held = first.held(&first.identify());
            let one = |trial: u64| {
                let campaign = design.campaign([20, trial + 1], 1.0, &held);
                let found = campaign.identify();
                let chi_square = found.residuals.chi_square.unwrap() / found.residuals.degrees_of_freedom as f64;
                let holds = |&&i: &&usize| {
                    let u = found.standard_uncertainty(i).unwrap();
                    (found.values[i] - campaign.truth[i]).abs() < 1.959_964 * u
                };
                [chi_square, found.free.iter().filter(holds).count() as f64 / found.free.len() as f64]
            };
            let all: Vec<[f64; 2]> = (0..draws()).into_par_iter().map(one).collect();
            let mean = |k: usize| all.iter().map(|d| d[k]).sum::<f64>() / draws() as f64;
            println!("{} by {kind}: chi-square {:.3}, {:.1} % of intervals hold", model.name, mean(0), 100.0 * mean(1));
            assert!((mean(0) - 1.0).abs() < 0.05, "{} by {kind}: chi-square {}", model.name, mean(0));
            assert!((mean(1) - 0.95).abs() < 0.015, "{} by {kind}: {}", model.name, mean(1));
        }
    }
}
