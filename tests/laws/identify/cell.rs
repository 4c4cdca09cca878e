//! Frames of drawn cells (synthetic): coverage of their uncertainties, and false alarms.

use super::drawn::number;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus};
use etalon::identify::cell::{
    AxisReading, AxisRole, CellFrame, CellPoint, Mounting, Quality, Stated, ThreePointRole, hand_eye, linear_axis,
    object_frame, object_slips, reflector, rotary_axis, three_points, tool_axes, tool_point,
};
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, FisherSnedecor, Normal, StudentsT};

/// Noise of a coordinate (mm) and of an orientation (rad).
const NOISE: (f64, f64) = (0.05, 2e-4);

fn vector(noise: &mut Noise, size: f64) -> Vector {
    [0; 3].map(|_| noise.uniform(size))
}

fn drawn(noise: &mut Noise, turn: f64, size: f64) -> Pose {
    Pose { translation_mm: vector(noise, size), ..Pose::from_rotation_vector(vector(noise, turn)) }
}

fn noisy(noise: &mut Noise, p: Vector) -> Vector {
    p.map(|v| v + noise.gaussian(NOISE.0))
}

fn noisy_pose(noise: &mut Noise, pose: &Pose) -> Pose {
    let turn = Pose::from_rotation_vector([0; 3].map(|_| noise.gaussian(NOISE.1)));
    let turned = turn.then(&Pose { translation_mm: [0.0; 3], ..*pose });
    Pose { translation_mm: noisy(noise, pose.translation_mm), ..turned }
}

/// Counts of components and of whole results within their 95 % regions.
#[derive(Default)]
struct Coverage {
    components: [f64; 2],
    wholes: [f64; 2],
    outlier: f64,
}

impl Coverage {
    /// Errors with their covariance; without `redundancy` the uncertainty is stated.
    fn add(&mut self, error: &[f64], covariance: &DMatrix<f64>, redundancy: Option<f64>) {
        let k = match redundancy {
            None => Normal::standard().inverse_cdf(0.975),
            Some(dof) => StudentsT::new(0.0, 1.0, dof).unwrap().inverse_cdf(0.975),
        };
        for (i, e) in error.iter().enumerate() {
            self.components[0] += f64::from(u8::from(e.abs() <= k * covariance[(i, i)].sqrt()));
            self.components[1] += 1.0;
        }
        let n = error.len() as f64;
        let e = DVector::from_column_slice(error);
        let square = (e.transpose() * covariance.clone().cholesky().unwrap().solve(&e))[(0, 0)];
        let limit = n * FisherSnedecor::new(n, redundancy.unwrap_or(1e7)).unwrap().inverse_cdf(0.95);
        self.wholes[0] += f64::from(u8::from(square <= limit));
        self.wholes[1] += 1.0;
    }

    fn point(&mut self, found: &CellPoint, truth: Vector, redundancy: Option<f64>) {
        let covariance = DMatrix::from_fn(3, 3, |i, j| found.covariance_mm2[i][j]);
        self.add(&minus(found.at_mm, truth), &covariance, redundancy);
    }

    fn frame(&mut self, found: &CellFrame, truth: &Pose, redundancy: Option<f64>) {
        let shift = minus(found.pose.translation_mm, truth.translation_mm);
        let turn = found.pose.then(&truth.inverse()).rotation_vector_rad();
        let covariance = DMatrix::from_fn(6, 6, |i, j| found.covariance[i][j]);
        self.add(&[shift, turn].concat(), &covariance, redundancy);
    }

    fn count_outlying(&mut self, quality: &Quality) {
        self.outlier += f64::from(u8::from(quality.outlier().is_some()));
    }

    fn hold(&self, what: &str, within: f64) {
        let share = |[inside, count]: [f64; 2]| inside / count;
        let (single, whole) = (share(self.components), share(self.wholes));
        let outlier = self.outlier / self.wholes[1];
        println!("{what}: components {single:.4}, regions {whole:.4} of {}, outlier {outlier:.4}", self.wholes[1]);
        assert!((single - 0.95).abs() < within && (whole - 0.95).abs() < within, "{what}");
        assert!(outlier < 0.02, "{what}: {outlier}");
    }
}

fn redundancy(quality: &Quality, stated: &Stated) -> Option<f64> {
    stated.position_mm.is_none().then(|| quality.components[0].redundancy)
}

/// Stated uncertainties and none, by turns.
fn stated(trial: u64) -> Stated {
    match trial % 2 {
        0 => Stated { position_mm: Some(NOISE.0), rotation_rad: Some(NOISE.1), measured_mm: Vec::new() },
        _ => Stated::default(),
    }
}

fn trials(usual: u64) -> u64 {
    number("ETALON_TRIALS", usual)
}

/// Pose of the flange whose place touches the fixed point, with noise.
fn touch(noise: &mut Noise, place: Vector, fixed: Vector, turn: f64) -> Pose {
    let pose = drawn(noise, turn, 0.0);
    Pose { translation_mm: noisy(noise, minus(fixed, pose.rotate(place))), ..pose }
}

#[test]
fn tool_points_and_tool_frames_are_within_their_uncertainty() {
    let (mut points, mut frames) = (Coverage::default(), Coverage::default());
    for trial in 0..trials(3000) {
        let mut noise = Noise::new(501, trial);
        let (stated, tool, fixed) = (stated(trial), drawn(&mut noise, 1.5, 250.0), vector(&mut noise, 900.0));
        let count = 4 + trial as usize % 7;
        let turn = 0.3 + noise.uniform(0.2) + 0.1 * (trial % 10) as f64;
        let poses: Vec<Pose> = (0..count).map(|_| touch(&mut noise, tool.translation_mm, fixed, turn)).collect();
        let tip = tool_point(&poses, &stated).unwrap();
        points.count_outlying(&tip.quality);
        points.point(&tip.tool, tool.translation_mm, redundancy(&tip.quality, &stated));
        let mut readings: Vec<(AxisRole, Pose)> = poses.iter().map(|p| (AxisRole::Tip, *p)).collect();
        for (role, place) in [(AxisRole::Z, [0.0, 0.0, 150.0]), (AxisRole::X, [90.0, 0.0, 20.0])] {
            readings.push((role, touch(&mut noise, tool.apply(place), fixed, turn)));
        }
        let axes = tool_axes(&readings, &stated).unwrap();
        frames.count_outlying(&axes.quality);
        frames.frame(&axes.tool, &tool, redundancy(&axes.quality, &stated));
    }
    points.hold("tool-point", 0.02);
    frames.hold("tool-axes", 0.02);
}

#[test]
fn reflectors_are_within_their_uncertainty() {
    let (mut tools, mut bases) = (Coverage::default(), Coverage::default());
    for trial in 0..trials(2000) {
        let mut noise = Noise::new(502, trial);
        let (stated, tool, world) = (stated(trial), vector(&mut noise, 200.0), drawn(&mut noise, 1.7, 2000.0));
        let count = 6 + trial as usize % 8;
        let poses: Vec<Pose> = (0..count).map(|_| drawn(&mut noise, 1.0, 600.0)).collect();
        let points: Vec<Vector> = poses.iter().map(|p| noisy(&mut noise, world.then(p).apply(tool))).collect();
        let fit = reflector(&poses, &points, &stated).unwrap();
        assert!(!fit.ambiguous, "trial {trial}");
        tools.count_outlying(&fit.quality);
        tools.point(&fit.tool, tool, redundancy(&fit.quality, &stated));
        bases.frame(&fit.world_T_base, &world, redundancy(&fit.quality, &stated));
    }
    tools.hold("tool-reflector", 0.02);
    bases.hold("base of tool-reflector", 0.02);
}

#[test]
#[ignore = "a long law: make laws"]
fn hands_and_eyes_are_within_their_uncertainty() {
    let mut all = [[Coverage::default(), Coverage::default()], [Coverage::default(), Coverage::default()]];
    for trial in 0..trials(2000) {
        let mut noise = Noise::new(503, trial);
        let stated = stated(trial / 2);
        let (hand, other) = (drawn(&mut noise, 1.7, 150.0), drawn(&mut noise, 1.7, 1000.0));
        let count = 8 + trial as usize % 8;
        let poses: Vec<Pose> = (0..count).map(|_| drawn(&mut noise, 0.9, 500.0)).collect();
        let sensor = trial % 2 == 1;
        let seen = |p: &Pose| match sensor {
            true => p.then(&hand).inverse().then(&other),
            false => other.inverse().then(p).then(&hand),
        };
        let measured: Vec<Pose> = poses.iter().map(|p| noisy_pose(&mut noise, &seen(p))).collect();
        let mounting = if sensor { Mounting::Sensor } else { Mounting::Target };
        let fit = hand_eye(&poses, &measured, mounting, &stated).unwrap();
        assert!(!fit.ambiguous, "trial {trial}");
        // two standard deviations: each with its own redundancy, near that of positions
        let redundancy = redundancy(&fit.quality, &stated);
        let [of_hand, of_other] = &mut all[usize::from(sensor)];
        of_hand.count_outlying(&fit.quality);
        of_hand.frame(&fit.flange_T_hand, &hand, redundancy);
        of_other.frame(&fit.base_T_world, &other, redundancy);
    }
    for (what, pair) in ["reflector moves", "sensor moves"].into_iter().zip(&all) {
        pair[0].hold(&format!("hand-eye, hand, {what}"), 0.03);
        pair[1].hold(&format!("hand-eye, other, {what}"), 0.03);
    }
}

#[test]
fn objects_are_within_their_uncertainty() {
    let (mut objects, mut three, mut slips) = (Coverage::default(), Coverage::default(), 0);
    for trial in 0..trials(3000) {
        let mut noise = Noise::new(504, trial);
        let (stated, object) = (stated(trial), drawn(&mut noise, 1.7, 1000.0));
        let known: Vec<Vector> = (0..3 + trial as usize % 8).map(|_| vector(&mut noise, 300.0)).collect();
        let measured: Vec<Vector> = known.iter().map(|p| noisy(&mut noise, object.apply(*p))).collect();
        let fit = object_frame(&known, &measured, &stated).unwrap();
        objects.count_outlying(&fit.quality);
        objects.frame(&fit.frame, &object, redundancy(&fit.quality, &stated));
        if trial % 5 < 2 {
            slips += object_slips(&known, &measured, &stated, &fit.quality).len();
        }
        let role = if trial % 3 == 0 { ThreePointRole::XXY } else { ThreePointRole::OriginXPlane };
        let places = match role {
            ThreePointRole::OriginXPlane => [[0.0; 3], [400.0, 0.0, 0.0], [120.0, 250.0, 0.0]],
            ThreePointRole::XXY => [[50.0, 0.0, 0.0], [400.0, 0.0, 0.0], [0.0, 250.0, 0.0]],
        };
        let repeats = if stated.position_mm.is_some() { 1 } else { 3 };
        let readings =
            places.map(|p| (0..repeats).map(|_| noisy(&mut noise, object.apply(p))).collect::<Vec<Vector>>());
        let points = [&readings[0][..], &readings[1], &readings[2]];
        let fit = three_points(points, role, stated.position_mm).unwrap();
        let freedom = stated.position_mm.is_none().then(|| fit.repeats.unwrap().1 as f64);
        three.frame(&fit.frame, &object, freedom);
    }
    objects.hold("object", 0.02);
    three.hold("three-points", 0.02);
    assert_eq!(slips, 0);
}

#[test]
fn external_axes_are_within_their_uncertainty() {
    let (mut lines, mut turns) = (Coverage::default(), Coverage::default());
    for trial in 0..trials(1500) {
        let mut noise = Noise::new(505, trial);
        let (stated, axis) = (stated(trial), drawn(&mut noise, 1.7, 1000.0));
        let targets = [[250.0, 0.0, 0.0], vector(&mut noise, 400.0)];
        let scale = 1.0 + noise.uniform(2e-3);
        let (mut along, mut about) = (Vec::new(), Vec::new());
        for i in 0..6 + trial as usize % 6 {
            for (target, place) in targets.iter().enumerate().take(1 + trial as usize % 2) {
                let (length, angle) = (150.0 * i as f64 - 300.0, 0.25 * i as f64 - 0.6);
                let at = axis.apply([place[0], place[1], place[2] + scale * length]);
                along.push(AxisReading { target, value: length, position_mm: noisy(&mut noise, at) });
                let at = axis.turn_z(scale * angle).apply(*place);
                about.push(AxisReading { target, value: angle, position_mm: noisy(&mut noise, at) });
            }
        }
        let line = linear_axis(&along, &stated).unwrap();
        lines.count_outlying(&line.quality);
        let d = line.direction_covariance;
        // two directions across the axis, and the scale
        let [x, y] = [axis.axis(0), axis.axis(1)];
        let dot = |a: Vector, b: Vector| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
        let of = |a: Vector, b: Vector| (0..9).map(|k| a[k / 3] * d[k / 3][k % 3] * b[k % 3]).sum::<f64>();
        let u2 = line.scale_standard_uncertainty.powi(2);
        let covariance =
            DMatrix::from_row_slice(3, 3, &[of(x, x), of(x, y), 0.0, of(y, x), of(y, y), 0.0, 0.0, 0.0, u2]);
        let error = [dot(line.direction, x), dot(line.direction, y), line.scale - scale];
        lines.add(&error, &covariance, redundancy(&line.quality, &stated));
        let turn = rotary_axis(&about, &stated).unwrap();
        turns.count_outlying(&turn.quality);
        turns.frame(&turn.frame, &axis, redundancy(&turn.quality, &stated));
    }
    lines.hold("linear-axis", 0.02);
    turns.hold("rotary-axis", 0.02);
}

/// Numbers of a member of the reference values.
fn rows<const N: usize>(value: &serde_json::Value) -> Vec<[f64; N]> {
    serde_json::from_value::<Vec<Vec<f64>>>(value.clone()).unwrap().into_iter().map(|r| r.try_into().unwrap()).collect()
}

fn pose_of(row: [f64; 7]) -> Pose {
    let [x, y, z, q @ ..] = row;
    Pose { translation_mm: [x, y, z], ..Pose::from_quaternion(q) }
}

fn poses_of(value: &serde_json::Value) -> Vec<Pose> {
    rows::<7>(value).into_iter().map(pose_of).collect()
}

fn numbers<const N: usize>(value: &serde_json::Value) -> [f64; N] {
    serde_json::from_value::<Vec<f64>>(value.clone()).unwrap().try_into().unwrap()
}

/// Position (mm) and orientation (mrad) by which two poses differ.
fn apart(a: &Pose, b: &Pose) -> f64 {
    let shift = minus(a.translation_mm, b.translation_mm);
    shift.iter().map(|v| v.abs()).fold(0.0, f64::max) + 1e3 * a.then(&b.inverse()).angle_rad()
}

/// The same equations solved by SciPy (cell_scipy.py).
#[test]
fn solutions_are_those_of_scipy() {
    let all: serde_json::Value = serde_json::from_str(include_str!("cell_scipy.json")).unwrap();
    let own = &all["tool_point"];
    let tip = tool_point(&poses_of(&own["poses"]), &Stated::default()).unwrap();
    let off = |a: Vector, b: Vector| minus(a, b).iter().map(|v| v.abs()).fold(0.0, f64::max);
    assert!(off(tip.tool.at_mm, numbers(&own["tool"])) < 1e-7 && off(tip.fixed.at_mm, numbers(&own["fixed"])) < 1e-7);
    let covariance = rows::<3>(&own["covariance"]);
    for k in 0..9 {
        let (found, expected) = (tip.tool.covariance_mm2[k / 3][k % 3], covariance[k / 3][k % 3]);
        assert!((found - expected).abs() < 1e-7 * covariance[0][0], "{found} {expected}");
    }
    let own = &all["tool_reflector"];
    let fit = reflector(&poses_of(&own["poses"]), &rows::<3>(&own["points"]), &Stated::default()).unwrap();
    assert!(off(fit.tool.at_mm, numbers(&own["tool"])) < 1e-5, "{:?}", fit.tool);
    assert!(apart(&fit.world_T_base.pose, &pose_of(numbers(&own["world_T_base"]))) < 1e-5);
    assert!((fit.quality.components[0].deviation - own["deviation"].as_f64().unwrap()).abs() < 1e-9);
    let own = &all["hand_eye"];
    let stated = Stated { position_mm: Some(0.05), rotation_rad: Some(2e-4), measured_mm: Vec::new() };
    let (poses, measured) = (poses_of(&own["poses"]), poses_of(&own["measured"]));
    let fit = hand_eye(&poses, &measured, Mounting::Target, &stated).unwrap();
    assert!(fit.quality.components.iter().all(|c| c.agrees));
    assert!(apart(&fit.flange_T_hand.pose, &pose_of(numbers(&own["hand"]))) < 1e-5);
    assert!(apart(&fit.base_T_world.pose, &pose_of(numbers(&own["base_T_world"]))) < 1e-5);
    let own = &all["object"];
    let stated = Stated { measured_mm: rows::<3>(&own["u"]), ..Stated::default() };
    let fit = object_frame(&rows::<3>(&own["known"]), &rows::<3>(&own["measured"]), &stated).unwrap();
    assert!(apart(&fit.frame.pose, &pose_of(numbers(&own["frame"]))) < 1e-5);
}
