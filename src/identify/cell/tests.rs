//! Exact data give the truth back; data that do not determine an answer are rejected with the
//! reason.

use super::*;
use etalon_base::noise::Noise;
use etalon_base::pose::{minus, norm};

fn drawn(noise: &mut Noise) -> Pose {
    let vector = |noise: &mut Noise, size: f64| [0; 3].map(|_| noise.uniform(size));
    let pose = Pose::from_rotation_vector(vector(noise, 1.2));
    Pose { translation_mm: vector(noise, 600.0), ..pose }
}

fn far(a: &Pose, b: &Pose) -> f64 {
    norm(minus(a.translation_mm, b.translation_mm)) + 1000.0 * a.inverse().then(b).angle_rad()
}

/// Poses whose tool point is at a fixed point.
fn touching(noise: &mut Noise, tool: Vector, fixed: Vector, count: usize) -> Vec<Pose> {
    let touch = |noise: &mut Noise| {
        let turn = Pose { translation_mm: [0.0; 3], ..drawn(noise) };
        Pose { translation_mm: minus(fixed, turn.rotate(tool)), ..turn }
    };
    (0..count).map(|_| touch(noise)).collect()
}

#[test]
fn exact_data_give_the_frames_back() {
    let mut noise = Noise::new(1, 1);
    let (tool, world, object) = (drawn(&mut noise), drawn(&mut noise), drawn(&mut noise));
    let stated = Stated::default();
    let tip = tool_point(&touching(&mut noise, tool.translation_mm, [400.0, -300.0, 200.0], 5), &stated).unwrap();
    assert!(norm(minus(tip.tool.at_mm, tool.translation_mm)) < 1e-8);
    assert!(norm(minus(tip.fixed.at_mm, [400.0, -300.0, 200.0])) < 1e-8);
    let poses: Vec<Pose> = (0..7).map(|_| drawn(&mut noise)).collect();
    let points: Vec<Vector> = poses.iter().map(|p| world.then(p).apply(tool.translation_mm)).collect();
    let seen = reflector(&poses, &points, &stated).unwrap();
    assert!(norm(minus(seen.tool.at_mm, tool.translation_mm)) < 1e-7 && far(&seen.world_T_base.pose, &world) < 1e-6);
    let measured: Vec<Pose> = poses.iter().map(|p| world.then(p).then(&tool)).collect();
    let found = hand_eye(&poses, &measured, Mounting::Target, &stated).unwrap();
    assert!(far(&found.flange_T_hand.pose, &tool) < 1e-6 && far(&found.base_T_world.pose, &world.inverse()) < 1e-6);
    // a sensor on the robot sees a standing target
    let seen: Vec<Pose> = poses.iter().map(|p| p.then(&tool).inverse().then(&object)).collect();
    let found = hand_eye(&poses, &seen, Mounting::Sensor, &stated).unwrap();
    assert!(far(&found.flange_T_hand.pose, &tool) < 1e-6 && far(&found.base_T_world.pose, &object) < 1e-6);
    let known: Vec<Vector> = (0..4).map(|_| drawn(&mut noise).translation_mm).collect();
    let measured: Vec<Vector> = known.iter().map(|p| object.apply(*p)).collect();
    assert!(far(&object_frame(&known, &measured, &stated).unwrap().frame.pose, &object) < 1e-7);
}

#[test]
fn axes_and_three_points_give_their_frames_back() {
    let mut noise = Noise::new(2, 1);
    let (tool, object) = (drawn(&mut noise), drawn(&mut noise));
    let fixed = [400.0, -300.0, 200.0];
    let places = [[0.0; 3], [0.0; 3], [0.0; 3], [0.0; 3], [0.0, 0.0, 120.0], [80.0, 0.0, 10.0]];
    let roles = [AxisRole::Tip, AxisRole::Tip, AxisRole::Tip, AxisRole::Tip, AxisRole::Z, AxisRole::X];
    let readings: Vec<(AxisRole, Pose)> =
        roles.iter().zip(places).map(|(role, at)| (*role, touching(&mut noise, tool.apply(at), fixed, 1)[0])).collect();
    let found = tool_axes(&readings, &Stated::default()).unwrap();
    assert!(far(&found.tool.pose, &tool) < 1e-6, "{:?} {tool:?}", found.tool.pose);
    let at = |x: f64, y: f64| object.apply([x, y, 0.0]);
    let origin_x_plane = [at(0.0, 0.0), at(300.0, 0.0), at(70.0, 200.0)];
    let x_x_y = [at(50.0, 0.0), at(300.0, 0.0), at(0.0, 200.0)];
    for (points, role) in [(origin_x_plane, ThreePointRole::OriginXPlane), (x_x_y, ThreePointRole::XXY)] {
        let frame = |points: &[Vector; 3]| {
            three_points([&points[..1], &points[1..2], &points[2..]], role, Some(1.0)).unwrap().frame
        };
        assert!(far(&frame(&points).pose, &object) < 1e-9);
        // covariance by differences
        let mut expected = nalgebra::Matrix6::zeros();
        for k in 0..9 {
            let mut moved = points;
            moved[k / 3][k % 3] += 1e-4;
            let there = frame(&moved).pose;
            let shift = minus(there.translation_mm, object.translation_mm);
            let turn = there.then(&object.inverse()).rotation_vector_rad();
            let d = nalgebra::Vector6::from_iterator(shift.into_iter().chain(turn).map(|v| v / 1e-4));
            expected += d * d.transpose();
        }
        let covariance = frame(&points).covariance;
        for k in 0..36 {
            assert!((covariance[k / 6][k % 6] - expected[(k / 6, k % 6)]).abs() < 1e-4, "{role:?} {k}");
        }
    }
}

#[test]
fn external_axes_are_found() {
    let mut noise = Noise::new(3, 1);
    let axis = drawn(&mut noise);
    let reading = |target: usize, value: f64, position_mm: Vector| AxisReading { target, value, position_mm };
    for (sign, ratio) in [(1.0, 1.001), (-1.0, 0.999)] {
        let at = |p: Vector, v: f64| axis.turn_z(sign * ratio * v).apply(p);
        let values: Vec<f64> = (0..9).map(|i| 0.4 * f64::from(i) - 1.0).collect();
        let mut all: Vec<AxisReading> = values.iter().map(|v| reading(0, *v, at([250.0, 0.0, 0.0], *v))).collect();
        all.extend(values.iter().map(|v| reading(1, *v, at([-90.0, 200.0, 70.0], *v))));
        let found = rotary_axis(&all, &Stated::default()).unwrap();
        let expected = if sign > 0.0 { axis } else { axis.turn_x(std::f64::consts::PI) };
        assert!(far(&found.frame.pose, &expected) < 1e-6, "{:?} {expected:?}", found.frame.pose);
        assert!((found.ratio - ratio).abs() < 1e-9 && (found.radius_mm - 250.0).abs() < 1e-7);
        let along = |v: f64| axis.shift(2, 1.0002 * sign * v).translation_mm;
        let all: Vec<AxisReading> = values.iter().map(|v| reading(0, 500.0 * v, along(500.0 * v))).collect();
        let found = linear_axis(&all, &Stated::default()).unwrap();
        assert!((found.scale - 1.0002).abs() < 1e-9);
        assert!(norm(minus(found.direction, axis.axis(2).map(|v| sign * v))) < 1e-9);
    }
}

#[test]
fn what_is_not_determined_is_named() {
    let mut noise = Noise::new(4, 1);
    let stated = Stated::default();
    let (tool, fixed) = ([30.0, -20.0, 150.0], [400.0, -300.0, 200.0]);
    // turns about one axis of the flange
    let axis = [0.0, 0.6, 0.8];
    let base = drawn(&mut noise);
    let about = |angle: f64| {
        let turn = base.then(&Pose::from_rotation_vector(axis.map(|v| v * angle)));
        Pose { translation_mm: minus(fixed, turn.rotate(tool)), ..turn }
    };
    let poses: Vec<Pose> = (0..6).map(|i| about(0.4 * f64::from(i))).collect();
    let along = |fault: CellFault| match fault {
        CellFault::OneAxis { direction } => assert!(norm(minus(direction, axis)) < 1e-6, "{direction:?}"),
        other => panic!("{other:?}"),
    };
    along(tool_point(&poses, &stated).unwrap_err());
    along(hand_eye(&poses, &poses, Mounting::Target, &stated).unwrap_err());
    assert_eq!(tool_point(&[poses[0]; 4], &stated).unwrap_err(), CellFault::SameOrientation);
    assert_eq!(tool_point(&poses[..2], &stated).unwrap_err(), CellFault::TooFew { needed: 3, readings: 2 });
    let line: Vec<Vector> = (0..4).map(|i| [f64::from(i), 2.0 * f64::from(i), 0.0]).collect();
    assert!(matches!(object_frame(&line, &line, &stated), Err(CellFault::Collinear { .. })));
    assert_eq!(object_frame(&[[1.0; 3]; 3], &line[..3], &stated).unwrap_err(), CellFault::Coincident);
    // the reflector stays at one point: the base is open
    let many = touching(&mut noise, tool, fixed, 5);
    assert_eq!(reflector(&many, &[[1.0, 2.0, 3.0]; 5], &stated).unwrap_err(), CellFault::Coincident);
}

#[test]
fn an_outlying_reading_and_slips_are_found() {
    let mut noise = Noise::new(5, 1);
    let object = drawn(&mut noise);
    let known: Vec<Vector> = (0..8).map(|_| drawn(&mut noise).translation_mm).collect();
    let sound: Vec<Vector> = known.iter().map(|p| object.apply(*p).map(|v| v + noise.gaussian(0.02))).collect();
    let stated = Stated::default();
    let fit = object_frame(&known, &sound, &stated).unwrap();
    assert!(fit.quality.outlier().is_none() && object_slips(&known, &sound, &stated, &fit.quality).is_empty());
    let mut outlier = sound.clone();
    outlier[5][1] += 0.5;
    let fit = object_frame(&known, &outlier, &stated).unwrap();
    assert_eq!(fit.quality.outlier().map(|r| r.reading), Some(5));
    let slip = |known: &[Vector], measured: &[Vector]| {
        let fit = object_frame(known, measured, &stated).unwrap();
        object_slips(known, measured, &stated, &fit.quality).into_iter().map(|a| a.change).collect::<Vec<_>>()
    };
    let metres: Vec<Vector> = sound.iter().map(|p| p.map(|v| v / 1000.0)).collect();
    assert_eq!(slip(&known, &metres), [ObjectSlip::Unit(1e3)]);
    let mirrored: Vec<Vector> = known.iter().map(|p| [p[0], -p[1], p[2]]).collect();
    assert_eq!(slip(&mirrored, &sound), [ObjectSlip::Mirrored(2)]);
    let mut exchanged = known.clone();
    exchanged.swap(2, 6);
    assert_eq!(slip(&exchanged, &sound), [ObjectSlip::Exchanged([2, 6])]);
}
