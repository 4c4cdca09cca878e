use super::*;
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, dot, minus, norm, unit};
use etalon_robots::{AxisLine, Effect, Robot, Serial};

const NOISE_MM: f64 = 0.02;

/// Readings of a joint over its travel.
#[derive(Clone, Copy)]
struct Travel {
    /// Travel (mm, rad).
    span: f64,
    /// Number of readings, evenly spaced.
    count: usize,
}

/// A drawn arm in the world: axes at joint values zero, targets there.
struct Arm {
    axes: Vec<AxisLine>,
    targets: Vec<Vector>,
}

impl Arm {
    fn drawn(noise: &mut Noise, joints: usize, targets: usize, sliding: bool) -> Self {
        let vector = |noise: &mut Noise, size: f64| [0; 3].map(|_| noise.uniform(size));
        let mut axes: Vec<AxisLine> = Vec::new();
        while axes.len() < joints {
            let i = axes.len();
            let direction = match axes.last() {
                Some(last) if i == 2 => last.direction,
                _ => unit(vector(noise, 1.0)).unwrap(),
            };
            axes.push(AxisLine { direction, point_mm: vector(noise, 600.0), prismatic: sliding && i == 3 });
        }
        let far = |t: &Vector| axes.iter().all(|a| a.prismatic || norm(minus(*t, a.foot(*t))) > 150.0);
        let mut all = Vec::new();
        while all.len() < targets {
            all.extend(Some(vector(noise, 900.0)).filter(far));
        }
        Self { axes, targets: all }
    }

    fn position(&self, joints: &[f64], target: usize) -> Vector {
        let chain = self.axes.iter().zip(joints);
        chain.fold(Pose::identity(), |pose, (axis, q)| pose.then(&axis.motion(*q))).apply(self.targets[target])
    }

    /// Readings of one joint from rest values.
    fn sweep(&self, noise: &mut Noise, rest: &[f64], joint: usize, travel: Travel) -> Sweep {
        let Travel { span, count } = travel;
        let mut readings = Vec::new();
        let start = if self.axes[joint].prismatic { 0.0 } else { noise.uniform(1.0) };
        for i in 0..count {
            let mut joints = rest.to_vec();
            joints[joint] = start + span * i as f64 / (count - 1) as f64;
            for target in 0..self.targets.len() {
                let p = self.position(&joints, target).map(|v| v + noise.gaussian(NOISE_MM));
                readings.push(SweepReading { row: readings.len() + 1, target, position_mm: p, joints: joints.clone() });
            }
        }
        Sweep { joint, readings }
    }

    /// The true axis of a joint at rest values.
    fn axis(&self, rest: &[f64], joint: usize) -> AxisLine {
        let before = self.axes.iter().zip(rest).take(joint);
        let pose = before.fold(Pose::identity(), |pose, (axis, q)| pose.then(&axis.motion(*q)));
        self.axes[joint].moved(&pose)
    }
}

/// Errors of an axis over their standard uncertainties, in the frame of its fit.
fn normalised(axis: &JointAxis, truth: &AxisLine) -> Vec<f64> {
    let inverse = axis.fit.frame.inverse();
    let d = inverse.rotate(truth.direction);
    let (a, b) = (d[0] / d[2], d[1] / d[2]);
    let (of_direction, of_point) = axis.standard_uncertainties();
    let mut all = vec![a / of_direction[0], b / of_direction[1]];
    if !axis.fit.prismatic {
        let p = inverse.apply(truth.point_mm);
        all.extend([(p[0] - a * p[2]) / of_point[0], (p[1] - b * p[2]) / of_point[1]]);
    }
    all
}

fn settings(arm: &Arm) -> AxesSettings {
    AxesSettings { prismatic: arm.axes.iter().map(|a| Some(a.prismatic)).collect(), ..AxesSettings::default() }
}

#[test]
fn axes_of_drawn_arms_are_found_within_their_uncertainty() {
    let (mut counts, mut inside, mut far) = (0, 0, 0);
    for trial in 0..60 {
        let mut noise = Noise::new(45, trial);
        let arm = Arm::drawn(&mut noise, 6, 1 + trial as usize % 3, trial % 4 == 0);
        let rest: Vec<f64> = arm.axes.iter().map(|_| noise.uniform(0.8)).collect();
        for joint in 0..6 {
            let degrees = 165.0 + noise.uniform(135.0);
            let span = if arm.axes[joint].prismatic { 500.0 } else { degrees.to_radians() };
            let sweep = arm.sweep(&mut noise, &rest, joint, Travel { span, count: 40 });
            let axis = joint_axis(&sweep, &settings(&arm)).unwrap();
            for z in normalised(&axis, &arm.axis(&rest, joint)) {
                counts += 1;
                inside += usize::from(z.abs() < 1.97);
                far += usize::from(z.abs() > 3.0);
            }
        }
    }
    let share = |n: usize| n as f64 / counts as f64;
    eprintln!("{counts} parameters: {:.4} within 95 %, {:.4} beyond 3 u", share(inside), share(far));
    assert!(share(far) < 0.01 && (share(inside) - 0.95).abs() < 0.02);
}

fn derived_model(arm: &Arm, sweeps: &[Sweep]) -> AxesModel {
    let axes = sweeps.iter().map(|s| joint_axis(s, &settings(arm)).unwrap()).collect();
    AxesModel::new(axes, arm.targets.len()).unwrap()
}

fn draw_sweeps(arm: &Arm, noise: &mut Noise) -> Vec<Sweep> {
    let sweep = |noise: &mut Noise, joint: usize| {
        let rest: Vec<f64> = arm.axes.iter().map(|_| noise.uniform(0.8)).collect();
        let span = if arm.axes[joint].prismatic { 500.0 } else { (165.0 + noise.uniform(135.0)).to_radians() };
        arm.sweep(noise, &rest, joint, Travel { span, count: 40 })
    };
    (0..arm.axes.len()).map(|joint| sweep(noise, joint)).collect()
}

#[test]
fn the_derived_model_predicts_new_poses_within_its_uncertainty() {
    let (mut counts, mut inside) = (0, 0);
    for trial in 0..60 {
        let mut noise = Noise::new(46, trial);
        let arm = Arm::drawn(&mut noise, 6, 1 + trial as usize % 2, trial % 3 == 0);
        let sweeps = draw_sweeps(&arm, &mut noise);
        let model = derived_model(&arm, &sweeps);
        let joints: Vec<f64> = arm.axes.iter().map(|_| noise.uniform(2.0)).collect();
        let predicted = model.predict(&joints, 0);
        let truth = arm.position(&joints, 0);
        for (k, truth) in truth.iter().enumerate() {
            counts += 1;
            let z = (predicted.position_mm[k] - truth) / predicted.covariance_mm2[k][k].sqrt();
            inside += usize::from(z.abs() < 1.97);
        }
        // the robot in its base frame moves alike
        let arm = etalon_robots::Serial::from_axes(&model.axes, &model.flange, &["T".to_owned()]);
        let flange = etalon_robots::Robot::kinematics(&arm).unwrap();
        let pose = flange.tool_pose(&etalon_robots::Robot::nominal(&arm), &joints).unwrap();
        let same = model.world_T_base.then(&pose).apply(model.targets_mm[0]);
        assert!(norm(minus(same, predicted.position_mm)) < 1e-6, "{same:?} {predicted:?}");
    }
    let share = inside as f64 / counts as f64;
    eprintln!("{counts} coordinates: {share:.4} within 95 %");
    assert!((share - 0.95).abs() < 0.04);
}

#[test]
fn without_joint_values_home_is_the_start_of_every_sweep() {
    let (mut counts, mut inside) = (0, 0);
    for trial in 0..40 {
        let mut noise = Noise::new(47, trial);
        let arm = Arm::drawn(&mut noise, 6, 1, trial % 3 == 0);
        let home = vec![0.0; 6];
        let mut sweeps = Vec::new();
        for joint in 0..6 {
            let mut sweep = arm.sweep(
                &mut noise,
                &home,
                joint,
                Travel { span: if arm.axes[joint].prismatic { 400.0 } else { 2.0 }, count: 40 },
            );
            let first = sweep.readings[0].joints[joint];
            for r in &mut sweep.readings {
                let mut joints = home.clone();
                joints[joint] = r.joints[joint] - first;
                r.position_mm = arm.position(&joints, 0).map(|v| v + noise.gaussian(NOISE_MM));
                r.joints.clear();
            }
            sweeps.push(sweep);
        }
        assert!(start_gap(&sweeps).unwrap().0 < 0.2);
        let model = derived_model(&arm, &sweeps);
        let joints: Vec<f64> = (0..6).map(|_| noise.uniform(1.5)).collect();
        let (predicted, truth) = (model.predict(&joints, 0), arm.position(&joints, 0));
        for (k, truth) in truth.iter().enumerate() {
            counts += 1;
            let z = (predicted.position_mm[k] - truth) / predicted.covariance_mm2[k][k].sqrt();
            inside += usize::from(z.abs() < 1.97);
        }
        // a check pose shows a joint that was swept backwards
        let mut reversed = AxesSettings { backwards: vec![false; 6], ..settings(&arm) };
        reversed.backwards[2] = true;
        let axes = sweeps.iter().map(|s| joint_axis(s, &reversed).unwrap()).collect();
        let model = AxesModel::new(axes, 1).unwrap();
        let checks: Vec<SweepReading> = (0..4)
            .map(|row| {
                let joints: Vec<f64> = (0..6).map(|_| noise.uniform(1.0)).collect();
                let p = arm.position(&joints, 0).map(|v| v + noise.gaussian(NOISE_MM));
                SweepReading { row, target: 0, position_mm: p, joints }
            })
            .collect();
        let found = model.agreement(&checks, NOISE_MM);
        assert!(matches!(found.explained, Some((Change::Reversed(2), _))), "{trial}: {found:?}");
    }
    let share = inside as f64 / counts as f64;
    eprintln!("{counts} coordinates: {share:.4} within 95 %");
    assert!((share - 0.95).abs() < 0.05);
}

#[test]
fn outlying_points_are_set_aside_and_sound_ones_are_not() {
    let mut lost = 0;
    for trial in 0..100 {
        let mut noise = Noise::new(48, trial);
        let arm = Arm::drawn(&mut noise, 3, 2, false);
        let mut sweep = arm.sweep(&mut noise, &[0.0; 3], 1, Travel { span: 1.5, count: 30 });
        lost += joint_axis(&sweep, &settings(&arm)).unwrap().fit.used.iter().filter(|u| !**u).count();
        for i in [7, 23, 41] {
            sweep.readings[i].position_mm[i % 3] += 0.4 + 20.0 * (i % 2) as f64;
        }
        let axis = joint_axis(&sweep, &settings(&arm)).unwrap();
        // an error along the path is invisible: only those across count
        let fit = &axis.fit;
        for i in [7, 23, 41] {
            let e = fit.frame.inverse().rotate({
                let mut e = [0.0; 3];
                e[i % 3] = 1.0;
                e
            });
            let p = fit.frame.inverse().apply(sweep.readings[i].position_mm);
            let along = (p[0] * e[1] - p[1] * e[0]) / p[0].hypot(p[1]);
            assert!(!fit.used[i] || along.abs() > 0.9, "{trial}, {i}");
        }
        assert!(normalised(&axis, &arm.axis(&[0.0; 3], 1)).iter().all(|z| z.abs() < 5.0));
    }
    assert!(lost < 5, "{lost} sound readings of 6000 were set aside");
}

#[test]
fn a_target_near_the_axis_has_its_uncertainty() {
    let mut noise = Noise::new(49, 0);
    let axes = vec![AxisLine { direction: [0.0, 0.0, 1.0], point_mm: [10.0, 20.0, 0.0], prismatic: false }];
    let arm = Arm { axes, targets: vec![[12.0, 20.0, 300.0]] };
    let sweep = arm.sweep(&mut noise, &[0.0], 0, Travel { span: 5.5, count: 40 });
    let axis = joint_axis(&sweep, &AxesSettings { prismatic: vec![Some(false)], ..AxesSettings::default() }).unwrap();
    let (of_direction, of_point) = axis.standard_uncertainties();
    // by hand: a plane through points at 2 mm: u = σ / (r √(n/2))
    let expected = NOISE_MM / (2.0 * 20f64.sqrt());
    assert!((of_direction[0] / expected - 1.0).abs() < 0.5, "{of_direction:?} {expected}");
    assert!(of_point[0] < NOISE_MM, "{of_point:?}");
    assert!(normalised(&axis, &arm.axes[0]).iter().all(|z| z.abs() < 4.0));
}

#[test]
fn slips_are_named_and_sound_sweeps_are_not() {
    for trial in 0..6 {
        let mut noise = Noise::new(50, trial);
        let arm = Arm::drawn(&mut noise, 4, 2, false);
        let rest = [0.2, -0.3, 0.1, 0.4];
        let sound = arm.sweep(&mut noise, &rest, 1, Travel { span: 1.4, count: 40 });
        let axis = joint_axis(&sound, &settings(&arm)).unwrap();
        assert_eq!((joint_slip(&sound), axis_slip(&sound, &axis), axis.smooth), (None, None, None));
        // the sweep of joint 3 under the name of joint 2
        let other = Sweep { joint: 1, ..arm.sweep(&mut noise, &rest, 2, Travel { span: 1.0, count: 20 }) };
        assert_eq!(joint_slip(&other), Some(Slip::OtherJoint { moved: 2 }));
        // another joint creeps
        let mut two = sound.clone();
        for (i, r) in two.readings.iter_mut().enumerate() {
            r.joints[0] += 0.001 * i as f64;
            r.position_mm = arm.position(&r.joints, r.target);
        }
        assert!(matches!(joint_slip(&two), Some(Slip::TwoJoints { also: 0, .. })));
        two.readings.iter_mut().for_each(|r| r.joints.clear());
        let axis = joint_axis(&two, &settings(&arm)).unwrap();
        assert!(axis.smooth.is_some() || axis_slip(&two, &axis).is_some(), "{trial}");
        // degrees read as radians
        let mut degrees = sound.clone();
        degrees.readings.iter_mut().for_each(|r| r.joints[1] *= 180.0 / std::f64::consts::PI);
        let axis = joint_axis(&degrees, &settings(&arm)).unwrap();
        let slip = axis_slip(&degrees, &axis);
        assert!(matches!(slip, Some(Slip::Ratio { unit: Some("deg-as-rad"), .. })), "{trial}: {slip:?}");
        // a target that slipped by a millimetre across its path
        let mut moved = sound.clone();
        let z = arm.axis(&rest, 1).direction;
        for r in moved.readings.iter_mut().filter(|r| r.target == 1 && r.row > 44) {
            r.position_mm = [0, 1, 2].map(|i| r.position_mm[i] + z[i]);
        }
        let axis = joint_axis(&moved, &settings(&arm)).unwrap();
        let slip = axis_slip(&moved, &axis);
        assert!(matches!(slip, Some(Slip::TargetMoved { target: 1, row: 45..=47, .. })), "{trial}: {slip:?}");
    }
}

#[test]
fn exchanged_joints_are_named_by_the_sweeps_themselves() {
    for trial in 0..10 {
        let mut noise = Noise::new(51, trial);
        let arm = Arm::drawn(&mut noise, 5, 1, false);
        let mut sweeps = draw_sweeps(&arm, &mut noise);
        let sound = derived_model(&arm, &sweeps);
        let found = sound.agreement(&compared(&sweeps, &sound.measured), NOISE_MM);
        assert!(found.worst < 5.0 && found.explained.is_none(), "{trial}: {}", found.worst);
        sweeps.swap(0, 3);
        for (joint, sweep) in sweeps.iter_mut().enumerate() {
            sweep.joint = joint;
            sweep.readings.iter_mut().for_each(|r| r.joints.swap(0, 3));
        }
        let wrong = derived_model(&arm, &sweeps);
        let found = wrong.agreement(&compared(&sweeps, &wrong.measured), NOISE_MM);
        assert!(matches!(found.explained, Some((Change::Exchanged([0, 3]), _))), "{trial}: {found:?}");
    }
}

#[test]
fn turning_and_sliding_are_told_by_the_path() {
    for trial in 0..20 {
        let mut noise = Noise::new(52, trial);
        let arm = Arm::drawn(&mut noise, 4, 1 + trial as usize % 2, true);
        for (joint, span) in [(2, 0.52), (3, 300.0), (1, 6.2)] {
            let sweep = arm.sweep(&mut noise, &[0.0; 4], joint, Travel { span, count: 20 });
            let axis = joint_axis(&sweep, &AxesSettings::default()).unwrap();
            assert_eq!(axis.fit.prismatic, joint == 3, "{trial} {joint}");
            assert!(dot(axis.fit.axis().direction, arm.axis(&[0.0; 4], joint).direction) > 0.99);
        }
    }
}

/// Small errors of screw axes between two measurements of one arm are within their uncertainty; six
/// of them place the base.
#[test]
fn errors_of_screw_axes_have_their_covariance() {
    let (mut inside, mut count) = (0.0, 0.0);
    for trial in 0..25 {
        let mut noise = Noise::new(454, trial);
        let arm = Arm::drawn(&mut noise, 6, 2, trial % 4 == 0);
        let rest: Vec<f64> = (0..6).map(|_| noise.uniform(0.8)).collect();
        let mut measured = || {
            let span = |joint: usize| if arm.axes[joint].prismatic { 500.0 } else { 2.0 };
            let sweeps: Vec<Sweep> = (0..6)
                .map(|joint| arm.sweep(&mut noise, &rest, joint, Travel { span: span(joint), count: 30 }))
                .collect();
            derived_model(&arm, &sweeps)
        };
        let [first, second] = [measured(), measured()];
        let [a, b] = [&first, &second].map(AxesModel::screw_parameters);
        assert_eq!((a.fixed.len(), &a.names), (6, &b.names), "{:?}", a.fixed);
        let robot = Serial::from_axes(&first.axes, &first.flange, &["T".to_owned()]);
        let errors = first.axes.iter().zip(&second.axes).flat_map(|(axis, near)| axis.errors_to(near));
        let named = robot.parameters().iter().filter(|p| p.joint.is_some() && p.effect == Effect::Geometry);
        for (p, error) in named.zip(errors) {
            let Some(k) = a.names.iter().position(|name| *name == p.name) else {
                assert!(error.abs() < 1e-6, "{}: {error:e}", p.name);
                continue;
            };
            let u = (a.covariance[(k, k)] + b.covariance[(k, k)]).sqrt();
            inside += f64::from(u8::from(error.abs() < 1.96 * u));
            count += 1.0;
        }
    }
    let share: f64 = inside / count;
    assert!(count > 400.0 && (share - 0.95).abs() < 0.035, "{share} of {count}");
}

/// Sweep of a perfect axis by three balls 200 mm apart, one metre from it; `axial` moves the axis
/// along itself.
fn distant_balls(noise: &mut Noise, noise_mm: f64, axial: impl Fn(usize) -> f64) -> Sweep {
    let balls = [[1000.0, 0.0, 300.0], [1000.0, 200.0, 300.0], [1100.0, 60.0, 450.0]];
    let axis = AxisLine { direction: [0.0, 0.6, 0.8], point_mm: [200.0, -100.0, 50.0], prismatic: false };
    let mut readings = Vec::new();
    for i in 0..24 {
        let angle = 0.06 * i as f64;
        for (target, ball) in balls.into_iter().enumerate() {
            let at = axis.motion(angle).apply(ball);
            let position_mm = [0, 1, 2].map(|k| at[k] + axial(i) * axis.direction[k] + noise.gaussian(noise_mm));
            readings.push(SweepReading { row: readings.len() + 1, target, position_mm, joints: Vec::new() });
        }
    }
    Sweep { joint: 0, readings }
}

/// Error motions of a perfect axis are what noise alone gives, within two standard uncertainties;
/// error motions of a defective axis are larger.
#[test]
fn a_perfect_axis_has_the_error_motions_of_noise() {
    let mut noise = Noise::new(31, 0);
    let (mut inside, mut count, mut largest) = ([0.0; 4], [0.0; 4], 0.0f64);
    let mut add = |k: usize, value: f64, by: ByNoise| {
        assert!(by.deviation > 0.0 && by.expected > by.deviation);
        count[k] += 1.0;
        inside[k] += f64::from(u8::from((value - by.expected).abs() < 2.0 * by.deviation));
    };
    for trial in 0..150 {
        let sweep = distant_balls(&mut noise, 0.015, |_| 0.0);
        let stated = (trial % 2 == 0).then_some(0.015);
        let settings = AxesSettings { standard_uncertainty_mm: stated, ..AxesSettings::default() };
        let motion = joint_axis(&sweep, &settings).unwrap().error_motion;
        for path in 0..3 {
            add(0, motion.radial_mm[path], motion.noise.paths[path]);
            add(1, motion.face_mm[path], motion.noise.paths[path]);
        }
        // a reading that is excluded leaves a step without three targets
        let (Some(axial), Some(tilt)) = (motion.axial_mm, motion.tilt_rad) else { continue };
        add(2, axial, motion.noise.axial.unwrap());
        add(3, tilt, motion.noise.tilt.unwrap());
        largest = largest.max(axial);
    }
    assert!(count[2] > 140.0, "{count:?}");
    // the lever of one metre enlarges 15 µm to tenths of a millimetre
    assert!(largest > 0.1, "{largest}");
    let shares = [0, 1, 2, 3].map(|k| inside[k] / count[k]);
    assert!(shares.iter().all(|share| *share > 0.9), "{shares:?}");
    let sweep = distant_balls(&mut noise, 0.015, |i| (1.3 * i as f64).sin());
    let settings = AxesSettings { standard_uncertainty_mm: Some(0.015), ..AxesSettings::default() };
    let motion = joint_axis(&sweep, &settings).unwrap().error_motion;
    let (face, by) = (motion.face_mm[0], motion.noise.paths[0]);
    assert!(face > by.expected + 10.0 * by.deviation, "{face} {by:?}");
    let (axial, by) = (motion.axial_mm.unwrap(), motion.noise.axial.unwrap());
    assert!(axial > by.expected + 3.0 * by.deviation, "{axial} {by:?}");
}

/// Means and standard deviations of ranges of normal values: factors d2 and d3 of control charts
/// (ASTM E2587).
#[test]
fn ranges_of_noise_are_those_of_control_charts() {
    for (n, d2, d3) in [(2, 1.128, 0.853), (5, 2.326, 0.864), (10, 3.078, 0.797), (25, 3.931, 0.708)] {
        let found = noise::range_of_normal(n, 1.0);
        assert!((found.expected - d2).abs() < 0.01 && (found.deviation - d3).abs() < 0.01, "{n} {found:?}");
    }
}

/// Returns the sweep of an axis by targets at these radii, whose bearing deviates by functions of
/// the angle (radial, axial; mm).
fn with_run_out(
    noise: &mut Noise,
    radii: &[f64],
    travel: Travel,
    noise_mm: f64,
    run_out: &dyn Fn(f64) -> [f64; 2],
) -> Sweep {
    let Travel { span: arc, count } = travel;
    let place = Pose::from_xyz_rpy([300.0, -200.0, 700.0], [0.4, -0.3, 1.0]);
    let mut readings = Vec::new();
    for i in 0..count {
        let angle = arc * i as f64 / (count - 1) as f64 - 0.5 * arc;
        let [radial, axial] = run_out(angle);
        for (target, radius) in radii.iter().enumerate() {
            let at = [(radius + radial) * angle.cos(), (radius + radial) * angle.sin(), 40.0 * target as f64 + axial];
            let position_mm = place.apply(at).map(|v| v + noise.gaussian(noise_mm));
            readings.push(SweepReading { row: readings.len() + 1, target, position_mm, joints: vec![angle] });
        }
    }
    Sweep { joint: 0, readings }
}

fn truth_of_run_out() -> AxisLine {
    let place = Pose::from_xyz_rpy([300.0, -200.0, 700.0], [0.4, -0.3, 1.0]);
    AxisLine { direction: place.axis(2), point_mm: place.translation_mm, prismatic: false }
}

/// Smooth deviations (low harmonics of the bearing, a wave of the gear) are no mistake; the axis is
/// within its uncertainty although neighbours deviate alike.
#[test]
fn axes_with_run_out_are_within_their_uncertainty() {
    let (mut inside, mut count, mut reported) = (0, 0, 0);
    for trial in 0..40 {
        let mut noise = Noise::new(460, trial);
        let arc = [1.75, 3.1, 6.2][trial as usize % 3];
        let waves: Vec<[f64; 5]> = (2..7)
            .map(|n| {
                [
                    f64::from(n),
                    noise.gaussian(0.002),
                    noise.gaussian(0.002),
                    noise.gaussian(0.002),
                    noise.gaussian(0.002),
                ]
            })
            .collect();
        let run_out = |angle: f64| {
            let sum = |k: usize| {
                waves.iter().map(|w| w[k] * (w[0] * angle).cos() + w[k + 1] * (w[0] * angle).sin()).sum::<f64>()
            };
            [sum(1), sum(3)]
        };
        let sweep = with_run_out(&mut noise, &[400.0], Travel { span: arc, count: 60 }, 0.0005, &run_out);
        let axis = joint_axis(&sweep, &AxesSettings::default()).unwrap();
        assert_eq!(axis_slip(&sweep, &axis), None, "{trial}");
        reported += usize::from(axis.smooth.is_some());
        for z in normalised(&axis, &truth_of_run_out()) {
            inside += usize::from(z.abs() < 2.0);
            count += 1;
        }
    }
    assert!(reported > 35 && inside as f64 > 0.93 * f64::from(count), "{reported} {inside} of {count}");
}

/// A step is a target that moved, also beside run-out of a tenth of it.
#[test]
fn a_step_is_no_run_out() {
    for trial in 0..4 {
        let mut noise = Noise::new(461, trial);
        let run_out = |angle: f64| [0.003 * (4.0 * angle).sin(), 0.0];
        let mut sweep = with_run_out(&mut noise, &[400.0], Travel { span: 1.9, count: 60 }, 0.001, &run_out);
        sweep.readings[33..].iter_mut().for_each(|r| r.position_mm[2] += 0.1);
        let axis = joint_axis(&sweep, &AxesSettings::default()).unwrap();
        let slip = axis_slip(&sweep, &axis);
        assert!(matches!(slip, Some(Slip::TargetMoved { row: 33..=35, .. })), "{slip:?}");
    }
}

/// A target on the axis says nothing of the angle: the other one compares motion and joint values,
/// and a confusion of units is still named.
#[test]
fn a_target_on_the_axis_does_not_spoil_the_ratio() {
    for trial in 0..6 {
        let mut noise = Noise::new(462, trial);
        let mut sweep = with_run_out(&mut noise, &[0.0, 60.0], Travel { span: 2.4, count: 25 }, 0.01, &|_| [0.0; 2]);
        let axis =
            joint_axis(&sweep, &AxesSettings { prismatic: vec![Some(false)], ..AxesSettings::default() }).unwrap();
        let ratio = axis.travel.unwrap().ratio;
        assert_eq!(axis_slip(&sweep, &axis), None, "{ratio:?}");
        assert!((ratio.value - 1.0).abs() < 4.0 * ratio.standard_uncertainty, "{ratio:?}");
        assert!(ratio.standard_uncertainty < 1e-3, "{ratio:?}");
        sweep.readings.iter_mut().for_each(|r| r.joints[0] = r.joints[0].to_degrees());
        let axis =
            joint_axis(&sweep, &AxesSettings { prismatic: vec![Some(false)], ..AxesSettings::default() }).unwrap();
        assert!(matches!(axis_slip(&sweep, &axis), Some(Slip::Ratio { unit: Some("deg-as-rad"), .. })));
    }
}

/// A short arc has an uncertain ratio, which is no mistake.
#[test]
fn a_ratio_counts_with_its_uncertainty() {
    let mut differs = 0;
    for trial in 0..30 {
        let mut noise = Noise::new(463, trial);
        let sweep = with_run_out(&mut noise, &[300.0], Travel { span: 0.05, count: 20 }, 0.01, &|_| [0.0; 2]);
        let axis =
            joint_axis(&sweep, &AxesSettings { prismatic: vec![Some(false)], ..AxesSettings::default() }).unwrap();
        let ratio = axis.travel.unwrap().ratio;
        assert_eq!(axis_slip(&sweep, &axis), None, "{ratio:?}");
        differs += usize::from((ratio.value - 1.0).abs() > 0.02);
    }
    assert!(differs > 5, "{differs}");
}

/// Unwraps joint values that a controller wraps at half a turn, so that the motion is continuous. A
/// joint at rest near half a turn does not move.
#[test]
fn wrapped_joint_values_are_unwound() {
    let mut noise = Noise::new(464, 0);
    let mut sweep = with_run_out(&mut noise, &[200.0], Travel { span: 4.0, count: 30 }, 0.01, &|_| [0.0; 2]);
    let turn = |v: f64| v - std::f64::consts::TAU * (v / std::f64::consts::TAU).round();
    for (i, r) in sweep.readings.iter_mut().enumerate() {
        let rest = std::f64::consts::PI + 1e-5 * (i % 3) as f64 - 1e-5;
        r.joints = vec![turn(r.joints[0] + 3.0), turn(rest)];
    }
    assert!(joint_slip(&sweep).is_some());
    sweep.unwind(&[0, 1]);
    assert_eq!(joint_slip(&sweep), None);
    let axis = joint_axis(&sweep, &AxesSettings::default()).unwrap();
    assert_eq!(axis_slip(&sweep, &axis), None);
    assert!((axis.rest[1].abs() - std::f64::consts::PI).abs() < 1e-4, "{:?}", axis.rest);
}

/// One axis has a base by convention alone: no parameter is left that its sweep determines.
#[test]
fn one_axis_has_a_robot_without_free_parameters() {
    let mut noise = Noise::new(465, 0);
    let sweep = with_run_out(&mut noise, &[200.0], Travel { span: 4.0, count: 30 }, 0.01, &|_| [0.0; 2]);
    let model = AxesModel::new(vec![joint_axis(&sweep, &AxesSettings::default()).unwrap()], 1).unwrap();
    let parameters = model.screw_parameters();
    assert!(parameters.names.is_empty() && parameters.independent_uncertainties().is_empty());
}
