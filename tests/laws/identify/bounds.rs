//! Answers within their bounds are near the truth, in drawn cells from good to degenerate
//! (synthetic).

use crate::support::arms::{SIX_AXES, serial};
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::identify::cell::{
    AxisReading, CellFrame, Measure, Stated, ThreePointRole, rotary_axis, three_points, tool_point,
};
use etalon::identify::{Extent, Observation, Settings, UncertaintyBound, fit_frames, identify};
use etalon::robots::{Quantity, Robot, Role, Serial};

/// Errors beyond this multiple of the bound are what no accepted answer may have: U = 2 u is at most
/// the bound, and an error of 5 u does not occur in these draws.
const MOST: f64 = 2.5;

/// Counts of answers: accepted, refused.
#[derive(Default)]
struct Judged {
    accepted: usize,
    refused: usize,
}

impl Judged {
    /// Judges an answer whose errors (mm, rad) are known.
    fn add(&mut self, errors: &[(f64, Quantity)], covariance: &[f64], extent: &Extent) {
        let quantities: Vec<Quantity> = errors.iter().map(|e| e.1).collect();
        let bound = UncertaintyBound::default();
        if bound.exceeded(&quantities, covariance, extent).is_some() {
            self.refused += 1;
            return;
        }
        self.accepted += 1;
        for (error, quantity) in errors {
            let (limit, _) = bound.bound(*quantity, extent);
            assert!(error.abs() <= MOST * limit, "{error} beyond {limit}: {covariance:?}");
        }
    }
}

fn frame_errors(frame: &CellFrame, truth: &Pose) -> Vec<(f64, Quantity)> {
    let shift = minus(frame.pose.translation_mm, truth.translation_mm);
    let turn = frame.pose.then(&truth.inverse()).rotation_vector_rad();
    let lengths = shift.into_iter().map(|v| (v, Quantity::Length));
    lengths.chain(turn.into_iter().map(|v| (v, Quantity::Angle))).collect()
}

fn noisy(noise: &mut Noise, p: Vector, u_mm: f64) -> Vector {
    p.map(|v| v + noise.gaussian(u_mm))
}

/// A number between 10^from and 10^to, evenly in its logarithm.
fn drawn(noise: &mut Noise, from: f64, to: f64) -> f64 {
    let middle = 0.5 * (from + to);
    10f64.powf(middle + noise.uniform(0.5 * (to - from)))
}

#[test]
fn accepted_tool_points_are_within_their_bounds() {
    let (mut noise, mut judged) = (Noise::new(201, 0), Judged::default());
    for _ in 0..400 {
        let (turn, u_mm) = (drawn(&mut noise, -4.0, 0.0), drawn(&mut noise, -3.0, 0.0));
        let (tool, fixed) = ([30.0, -20.0, 180.0], [800.0, 100.0, 300.0]);
        let poses: Vec<Pose> = (0..8)
            .map(|_| {
                let turned = Pose::from_rotation_vector([0; 3].map(|_| noise.uniform(turn)));
                Pose { translation_mm: noisy(&mut noise, minus(fixed, turned.rotate(tool)), u_mm), ..turned }
            })
            .collect();
        let stated = Stated { position_mm: Some(u_mm), ..Stated::default() };
        let Ok(found) = tool_point(&poses, &stated) else {
            judged.refused += 1;
            continue;
        };
        let positions: Vec<Vector> = poses.iter().map(|p| p.translation_mm).collect();
        let spread =
            Extent::from_points(&positions, found.quality.standard_uncertainty(Measure::Position, &stated).unwrap());
        let extent = Extent { length_mm: spread.length_mm.max(norm(found.tool.at_mm)), ..spread };
        let errors = minus(found.tool.at_mm, tool).map(|v| (v, Quantity::Length));
        judged.add(&errors, found.tool.covariance_mm2.as_flattened(), &extent);
    }
    assert!(judged.accepted > 80 && judged.refused > 80, "{} {}", judged.accepted, judged.refused);
}

#[test]
fn accepted_frames_of_three_points_are_within_their_bounds() {
    let (mut noise, mut judged) = (Noise::new(202, 0), Judged::default());
    for _ in 0..600 {
        let truth = Pose { translation_mm: [200.0, -100.0, 50.0], ..Pose::from_rotation_vector([0.4, -0.2, 0.7]) };
        let (length, height) = (drawn(&mut noise, -2.0, 3.0), drawn(&mut noise, -2.0, 3.0));
        let u_mm = drawn(&mut noise, -3.0, 0.0);
        let touched = [[0.0; 3], [length, 0.0, 0.0], [0.3 * length, height, 0.0]]
            .map(|p| [noisy(&mut noise, truth.apply(p), u_mm)]);
        let of = |k: usize| &touched[k][..];
        let Ok(found) = three_points([of(0), of(1), of(2)], ThreePointRole::OriginXPlane, Some(u_mm)) else {
            judged.refused += 1;
            continue;
        };
        let extent = Extent::from_points(touched.as_flattened(), u_mm);
        judged.add(&frame_errors(&found.frame, &truth), found.frame.covariance.as_flattened(), &extent);
    }
    assert!(judged.accepted > 100 && judged.refused > 100, "{} {}", judged.accepted, judged.refused);
}

#[test]
fn accepted_rotary_axes_are_within_their_bounds() {
    let (mut noise, mut judged) = (Noise::new(203, 0), Judged::default());
    for _ in 0..300 {
        let truth = Pose { translation_mm: [600.0, -200.0, 110.0], ..Pose::from_rotation_vector([0.2, 0.1, -0.4]) };
        let (radius, arc) = (drawn(&mut noise, -2.5, 2.5), drawn(&mut noise, -1.0, 0.8));
        let u_mm = drawn(&mut noise, -3.0, -1.0);
        let readings: Vec<AxisReading> = (0..12)
            .map(|i| {
                let value = arc * (f64::from(i) / 11.0 - 0.5);
                let at = truth.turn_z(value).apply([radius, 0.0, 0.0]);
                AxisReading { target: 0, value, position_mm: noisy(&mut noise, at, u_mm) }
            })
            .collect();
        let stated = Stated { position_mm: Some(u_mm), ..Stated::default() };
        let Ok(found) = rotary_axis(&readings, &stated) else {
            judged.refused += 1;
            continue;
        };
        let points: Vec<Vector> = readings.iter().map(|r| r.position_mm).collect();
        let u_mm = found.quality.standard_uncertainty(Measure::Position, &stated).unwrap();
        let extent = Extent::from_points(&points, u_mm);
        judged.add(&frame_errors(&found.frame, &truth), found.frame.covariance.as_flattened(), &extent);
    }
    assert!(judged.accepted > 50 && judged.refused > 50, "{} {}", judged.accepted, judged.refused);
}

/// An arm of six axes with errors, its base at `base_mm` in the world, and positions of its target; the flange turns by at most
/// `turn_rad` about each axis.
fn measured(base_mm: Vector, turn_rad: f64, seed: u64) -> (Serial, Vec<Observation>) {
    let robot = serial(&SIX_AXES, &["ball"], &[]);
    let mut noise = Noise::new(205, seed);
    let value = |(i, p): (usize, &etalon::robots::Parameter)| match (p.role, p.quantity) {
        (Role::Base, Quantity::Length) => base_mm[i],
        (Role::Base, _) => 0.1,
        (Role::Target, _) => 50.0,
        (_, Quantity::Length) => p.nominal + noise.uniform(1.0),
        (_, Quantity::Angle) => p.nominal + noise.uniform(3e-3),
        (_, Quantity::Ratio) => p.nominal,
    };
    let truth: Vec<f64> = robot.parameters().iter().enumerate().map(value).collect();
    let nominal = robot.nominal();
    let arm = robot.kinematics().expect("an arm");
    let mut observations = Vec::new();
    while observations.len() < 80 {
        let down = Pose::from_rotation_vector([0.0, std::f64::consts::PI, 0.0]);
        let turned = Pose::from_rotation_vector([0; 3].map(|_| noise.uniform(turn_rad))).then(&down);
        let place = [360.0 + noise.uniform(110.0), noise.uniform(200.0), 330.0 + noise.uniform(110.0)];
        let start = [0.0, 0.3, 0.2, 0.0, 1.0, 0.0];
        let Ok(joints) = arm.nearest_joints(&nominal, &Pose { translation_mm: place, ..turned }, &start) else {
            continue;
        };
        let at = noisy(&mut noise, robot.position(&truth, &joints, 0), 0.02);
        let pose = (observations.len() as i64 + 1).into();
        observations.push(Observation { pose, joints, targets: vec![Some(at)], ..Observation::default() });
    }
    (robot, observations)
}

/// Errors of the robot over the small turns of a tool: base and target stay where a robot can be, and are left to their rough estimates.
#[test]
fn a_tool_that_hardly_turns_leaves_base_and_target_nearby() {
    let settings = Settings { standard_uncertainty_mm: Some(0.02), ..Settings::default() };
    for (seed, turn_rad) in [0.003, 0.01, 0.03, 0.1].into_iter().enumerate() {
        let (robot, observations) = measured([500.0, -300.0, 200.0], turn_rad, seed as u64);
        for values in [
            fit_frames(&robot, &observations, &settings).expect("frames"),
            identify(&robot, &observations, &settings).expect("identified").values,
        ] {
            let far_mm = norm([values[0] - 500.0, values[1] + 300.0, values[2] - 200.0]);
            println!("turned by {turn_rad} rad: base off by {far_mm:.1} mm");
            assert!(far_mm < 3000.0, "turned by {turn_rad} rad: base off by {far_mm} mm");
        }
    }
}

/// The bound is a share of the measured extent, wherever the base is in the world.
#[test]
fn the_extent_is_that_of_the_targets_wherever_the_base_is() {
    let settings = Settings { standard_uncertainty_mm: Some(0.02), ..Settings::default() };
    let [near, far] = [[0.0; 3], [40_000.0, -30_000.0, 2_000.0]].map(|base_mm| {
        let (robot, observations) = measured(base_mm, 1.0, 7);
        let found = identify(&robot, &observations, &settings).expect("identified");
        found.extent(&robot, &observations, &settings).length_mm
    });
    println!("extent {near:.1} mm and {far:.1} mm");
    assert!((300.0..1500.0).contains(&near) && (near / far - 1.0).abs() < 0.02, "{near} {far}");
}
