//! Axes of drawn arms by sweeps of one joint at a time (synthetic), and the robot that they give.

use super::drawn::number;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm, unit};
use etalon::identify::axes::{
    AxesModel, AxesSettings, DerivedParameters, JointAxis, Sweep, SweepReading, axis_slip, joint_axis,
};
use etalon::identify::{Identification, Observation, Prior, Settings, identify};
use etalon::robots::{AxisLine, Quantity, Robot, Serial, TableConvention, modified_table, standard_table};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, StudentsT};

const NOISE_MM: f64 = 0.02;

struct Arm {
    axes: Vec<AxisLine>,
    targets: Vec<Vector>,
}

fn vector(noise: &mut Noise, size: f64) -> Vector {
    [0; 3].map(|_| noise.uniform(size))
}

impl Arm {
    /// Six axes, one pair of them parallel; targets at least 150 mm from each axis.
    fn drawn(noise: &mut Noise, trial: u64) -> Self {
        let mut axes: Vec<AxisLine> = Vec::new();
        while axes.len() < 6 {
            let direction = match axes.last() {
                Some(last) if axes.len() == 2 => last.direction,
                _ => unit(vector(noise, 1.0)).unwrap(),
            };
            let prismatic = trial.is_multiple_of(4) && axes.len() == 3;
            axes.push(AxisLine { direction, point_mm: vector(noise, 600.0), prismatic });
        }
        let far = |t: &Vector| axes.iter().all(|a| norm(minus(*t, a.foot(*t))) > 150.0);
        let mut targets = Vec::new();
        while targets.len() < 1 + trial as usize % 3 {
            targets.extend(Some(vector(noise, 900.0)).filter(far));
        }
        Self { axes, targets }
    }

    fn pose(&self, joints: &[f64]) -> Pose {
        self.axes.iter().zip(joints).fold(Pose::identity(), |pose, (axis, q)| pose.then(&axis.motion(*q)))
    }

    fn reading(&self, noise: &mut Noise, row: usize, target: usize, joints: &[f64]) -> SweepReading {
        let exact = self.pose(joints).apply(self.targets[target]);
        SweepReading { row, target, position_mm: exact.map(|v| v + noise.gaussian(NOISE_MM)), joints: joints.to_vec() }
    }

    /// Sweeps of all joints from `rest`, over arcs of 30 to 300 degrees.
    fn sweeps(&self, noise: &mut Noise, rest: &[f64], home: bool) -> Vec<Sweep> {
        let mut all = Vec::new();
        for joint in 0..self.axes.len() {
            let arc = (165.0 + noise.uniform(135.0)).to_radians();
            let span = if self.axes[joint].prismatic { 500.0 } else { arc };
            let from = if home { 0.0 } else { rest[joint] };
            let mut readings = Vec::new();
            for i in 0..40 {
                let mut joints = rest.to_vec();
                joints[joint] = from + span * f64::from(i) / 39.0;
                for target in 0..self.targets.len() {
                    readings.push(self.reading(noise, readings.len() + 1, target, &joints));
                }
            }
            all.push(Sweep { joint, readings });
        }
        all
    }

    fn settings(&self) -> AxesSettings {
        AxesSettings { prismatic: self.axes.iter().map(|a| Some(a.prismatic)).collect(), ..AxesSettings::default() }
    }

    fn measured(&self, sweeps: &[Sweep]) -> Vec<JointAxis> {
        sweeps.iter().map(|sweep| joint_axis(sweep, &self.settings()).unwrap()).collect()
    }
}

/// Errors of an axis over their standard uncertainties.
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

#[test]
#[ignore = "a long law: make laws"]
fn axes_are_within_their_uncertainty() {
    let (mut count, mut inside, mut far, mut false_alarms) = (0.0, 0.0, 0.0, 0);
    for trial in 0..number("ETALON_TRIALS", 400) {
        let mut noise = Noise::new(451, trial);
        let arm = Arm::drawn(&mut noise, trial);
        let rest: Vec<f64> = (0..6).map(|_| noise.uniform(0.8)).collect();
        let sweeps = arm.sweeps(&mut noise, &rest, false);
        for (sweep, axis) in sweeps.iter().zip(arm.measured(&sweeps)) {
            let before = arm.axes.iter().zip(&rest).take(axis.joint);
            let moved = before.fold(Pose::identity(), |pose, (axis, q)| pose.then(&axis.motion(*q)));
            let k = StudentsT::new(0.0, 1.0, axis.degrees_of_freedom).unwrap().inverse_cdf(0.975);
            for z in normalised(&axis, &arm.axes[axis.joint].moved(&moved)) {
                count += 1.0;
                inside += f64::from(u8::from(z.abs() < k));
                far += f64::from(u8::from(z.abs() > 3.0));
            }
            false_alarms += usize::from(axis_slip(sweep, &axis).is_some() || axis.smooth.is_some());
        }
    }
    println!("{count} parameters: coverage {:.4}, beyond 3 u {:.4}, slips {false_alarms}", inside / count, far / count);
    assert!((inside / count - 0.95).abs() < 0.01 && far / count < 0.01 && false_alarms == 0);
}

/// Prediction at new poses: errors against the truth, and against the identification of all sweeps
/// from the true nominal robot.
#[test]
#[ignore = "a long law: make laws"]
fn the_robot_of_the_axes_agrees_with_truth_and_identification() {
    let mut shares = [0.0; 3];
    let mut counts = [0.0; 3];
    for trial in 0..number("ETALON_TRIALS", 200) {
        let mut noise = Noise::new(452, trial);
        let arm = Arm::drawn(&mut noise, trial);
        for (k, home) in [false, true].into_iter().enumerate() {
            let rest: Vec<f64> = (0..6).map(|_| if home { 0.0 } else { noise.uniform(0.8) }).collect();
            let mut sweeps = arm.sweeps(&mut noise, &rest, home);
            let identified = (trial < 40 && !home).then(|| identified(&arm, &sweeps));
            if home {
                sweeps.iter_mut().flat_map(|s| &mut s.readings).for_each(|r| r.joints.clear());
            }
            let model = AxesModel::new(arm.measured(&sweeps), arm.targets.len()).unwrap();
            let joints: Vec<f64> = (0..6).map(|_| noise.uniform(2.0)).collect();
            let predicted = model.predict(&joints, 0);
            let truth = arm.pose(&joints).apply(arm.targets[0]);
            let mut judge = |at: Vector, k: usize| {
                for (i, at) in at.iter().enumerate() {
                    let z = (predicted.position_mm[i] - at) / predicted.covariance_mm2[i][i].sqrt();
                    shares[k] += f64::from(u8::from(z.abs() < 1.97));
                    counts[k] += 1.0;
                }
            };
            judge(truth, k);
            if let Some((robot, values)) = identified {
                judge(robot.position(&values, &joints, 0), 2);
            }
        }
    }
    let share: Vec<f64> = shares.iter().zip(counts).map(|(s, c)| s / c).collect();
    println!("within 95 %: {share:.4?} of {counts:?} (joint values, none, against identification)");
    assert!(share[..2].iter().all(|s| (s - 0.95).abs() < 0.03) && share[2] > 0.9);
}

/// Convention of the robot that the axes become.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Convention {
    Modified,
    Standard,
    Screws,
}

impl Convention {
    const ALL: [Self; 3] = [Self::Modified, Self::Standard, Self::Screws];

    fn parameters(self, model: &AxesModel) -> DerivedParameters {
        match self {
            Self::Screws => model.screw_parameters(),
            Self::Modified => model.table_parameters(TableConvention::Modified).unwrap(),
            Self::Standard => model.table_parameters(TableConvention::Standard).unwrap(),
        }
    }

    fn robot(self, model: &AxesModel, targets: usize) -> Serial {
        let names: Vec<String> = (0..targets).map(|t| format!("T{t}")).collect();
        let (axes, flange) = (&model.axes, &model.flange);
        match self {
            Self::Modified => {
                Serial::from_axis_table(TableConvention::Modified, &modified_table(axes, flange).joints, &names)
            }
            Self::Standard => {
                Serial::from_axis_table(TableConvention::Standard, &standard_table(axes, flange).joints, &names)
            }
            Self::Screws => Serial::from_axes(axes, flange, &names),
        }
    }
}

/// The robot of the axes with what is known before any pose: by the sweeps, or by a drawing.
fn known_before(model: &AxesModel, targets: usize, convention: Convention, drawing: Option<&mut Noise>) -> Serial {
    let known = convention.parameters(model);
    let priors = known.independent_uncertainties();
    let mut robot = convention.robot(model, targets);
    let mut drawing = drawing;
    for (name, by_sweeps) in known.names.iter().zip(priors) {
        let p =
            robot.definition_mut().parameters.iter_mut().find(|p| p.name == *name).expect("a parameter of the robot");
        let s = match (&mut drawing, p.quantity) {
            (None, _) => by_sweeps,
            (Some(noise), quantity) => {
                let s = if quantity == Quantity::Length { 0.5 } else { 1e-3 };
                p.nominal += noise.gaussian(s);
                s
            }
        };
        let t = p.quantity.outward(3f64.sqrt() * s);
        p.state_tolerance(t);
    }
    for (name, ..) in &known.fixed {
        let p = robot.definition_mut().parameters.iter_mut().find(|p| p.name == *name).unwrap();
        p.state_tolerance(1e-6);
    }
    robot
}

/// Standard uncertainties (mm) of the first target at joint values, by the identified parameters.
fn uncertainty_mm(robot: &Serial, found: &Identification, joints: &[f64]) -> Vector {
    let (free, covariance) = (&found.free, found.uncertainty.covariance.as_ref().expect("a covariance"));
    let by = |&i: &usize| {
        let moved = |h: f64| {
            let mut values = found.values.clone();
            values[i] += h;
            robot.position(&values, joints, 0)
        };
        minus(moved(1e-5), moved(-1e-5)).map(|d| d / 2e-5)
    };
    let by: Vec<Vector> = free.iter().map(by).collect();
    let n = free.len();
    let variance = |axis: usize| -> f64 {
        let pairs = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        pairs.map(|(i, j)| by[i][axis] * by[j][axis] * covariance[i * n + j]).sum()
    };
    [0, 1, 2].map(|axis| variance(axis).sqrt())
}

/// Axes as prior information of a few poses: positions at new poses are nearer to the truth than by the axes alone, and than by
/// the poses with the tolerances of a drawing; and they are within their uncertainty.
#[test]
fn axes_and_few_poses_predict_better_than_either() {
    let trials = number("ETALON_TRIALS", 120);
    let all: Vec<Few> = (0..trials).into_par_iter().map(few_poses).collect();
    for (k, convention) in Convention::ALL.into_iter().enumerate() {
        let of = all.iter().enumerate().filter(|(trial, _)| trial / 3 % 3 == k).map(|(_, few)| few);
        let sum = of.fold(Few::default(), |sum, few| Few {
            squares: [0, 1, 2].map(|i| sum.squares[i] + few.squares[i]),
            inside: sum.inside + few.inside,
            count: sum.count + few.count,
            held: sum.held + few.held,
        });
        let ([axes, poses, both], share) = (sum.squares.map(|s| (s / sum.count * 3.0).sqrt()), sum.inside / sum.count);
        println!(
            "{convention:?}: rms by axes {axes:.4}, poses {poses:.4}, both {both:.4} mm; within 95 %: {share:.4}, held {}",
            sum.held
        );
        assert_eq!(sum.held, 0, "{convention:?}");
        assert!(both < 0.9 * axes && both < 0.9 * poses, "{convention:?}: {axes} {poses} {both}");
        assert!(share > 0.94, "{convention:?}: {share}");
    }
}

/// Errors at new poses.
#[derive(Default)]
struct Few {
    /// Sums of squares (mm²) by the axes, by poses with a drawing, and by both axes and poses.
    squares: [f64; 3],
    /// Coordinates within 1.96 standard uncertainties, and all of them.
    inside: f64,
    count: f64,
    /// Parameters that the axes determine, but the identification holds.
    held: usize,
}

fn few_poses(trial: u64) -> Few {
    let mut noise = Noise::new(453, trial);
    let arm = Arm::drawn(&mut noise, trial);
    let rest: Vec<f64> = (0..6).map(|_| noise.uniform(0.8)).collect();
    let model = AxesModel::new(arm.measured(&arm.sweeps(&mut noise, &rest, false)), arm.targets.len()).unwrap();
    let (convention, targets) = (Convention::ALL[trial as usize / 3 % 3], arm.targets.len());
    let pose = |noise: &mut Noise| -> Vec<f64> { (0..6).map(|_| noise.uniform(2.0)).collect() };
    let poses: Vec<Vec<f64>> = (0..14).map(|_| pose(&mut noise)).collect();
    let mut observed = |i: usize| Observation {
        pose: (i as i64).into(),
        joints: poses[i].clone(),
        targets: (0..targets).map(|t| Some(arm.reading(&mut noise, 0, t, &poses[i]).position_mm)).collect(),
        ..Observation::default()
    };
    let measured: Vec<Observation> = (0..poses.len()).map(&mut observed).collect();
    let settings =
        Settings { standard_uncertainty_mm: Some(NOISE_MM), prior: Prior::TOLERANCES, ..Settings::default() };
    let robots =
        [known_before(&model, targets, convention, None), known_before(&model, targets, convention, Some(&mut noise))];
    let found = [0, 1].map(|k| identify(&robots[k], &measured, &settings).unwrap_or_else(|e| panic!("{trial} {e:?}")));
    // what a convention fixes is held; what the axes determine is not
    let determined = convention.parameters(&model).names;
    let is_held = |name: &&String| !found[0].free.contains(&robots[0].index(name).unwrap());
    let mut few = Few { held: determined.iter().filter(is_held).count(), ..Few::default() };
    for _ in 0..10 {
        let joints = pose(&mut noise);
        let truth = arm.pose(&joints).apply(arm.targets[0]);
        let of = |k: usize| robots[k].position(&found[k].values, &joints, 0);
        let at = [model.position(&joints, 0), of(1), of(0)];
        at.iter().zip(&mut few.squares).for_each(|(at, sum)| *sum += norm(minus(*at, truth)).powi(2));
        let u = uncertainty_mm(&robots[0], &found[0], &joints);
        for axis in 0..3 {
            few.inside += f64::from(u8::from((at[2][axis] - truth[axis]).abs() < 1.96 * u[axis]));
            few.count += 1.0;
        }
    }
    few
}

/// Identification of all readings from the true robot as nominal one.
fn identified(arm: &Arm, sweeps: &[Sweep]) -> (Serial, Vec<f64>) {
    let names: Vec<String> = (0..arm.targets.len()).map(|t| format!("T{t}")).collect();
    let robot = Serial::from_axes(&arm.axes, &Pose::identity(), &names);
    let mut observations = Vec::new();
    for (pose, readings) in sweeps.iter().flat_map(|s| s.readings.chunks(arm.targets.len())).enumerate() {
        observations.push(Observation {
            pose: (pose as i64).into(),
            joints: readings[0].joints.clone(),
            targets: readings.iter().map(|r| Some(r.position_mm)).collect(),
            ..Observation::default()
        });
    }
    let settings =
        Settings { standard_uncertainty_mm: Some(NOISE_MM), prior: Prior::TOLERANCES, ..Settings::default() };
    let found = identify(&robot, &observations, &settings).unwrap_or_else(|e| panic!("{e:?}"));
    (robot, found.values)
}
