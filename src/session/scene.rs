//! The robot at its measured poses, and the measured points with their errors.

use crate::session::covariance::{longest_axis_mm, place_covariances};
use crate::session::visits::{Base, Visit};
use crate::stages::join::ObservationTime;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_documents::{ErrorQuantity, FramesDocument, PointError, PoseSet as StoredSet};
use etalon_identify::Observation;
use etalon_robots::{JointRange, Outline, Robot, base_pose};
use etalon_view::{Instrument, JointScale, Named, NamedPose, Point, PointErrors, Pose as ShownPose, Scene, Stroke};
use std::collections::{BTreeMap, BTreeSet};

/// Micrometres per millimetre.
pub(super) const UM: f64 = 1000.0;

/// Share of the scene's size that a large error is drawn with.
const DRAWN: f64 = 0.05;

/// The scene of an identification, with the frames of the parts that have meshes.
pub(super) fn scene(base: &Base, outliers: &BTreeSet<(usize, usize)>, parts: Vec<String>) -> Scene {
    let Base { robot, found, visits, observations, .. } = *base;
    let values = &found.solution.found.values;
    let mut bodies = Bodies::default();
    let mut points = Vec::new();
    let (times, several) = (first_times(base.times), Visit::have_cycles(visits));
    let mut poses = Vec::new();
    for (at, (visit, observation)) in visits.iter().zip(observations).enumerate() {
        let joints = &observation.joints;
        let outline = robot.outline(values, joints);
        let strokes = bodies.strokes(robot, values, observation, &outline);
        let set = base.set(*visit);
        let outward = |(joint, value): (&etalon_robots::Joint, &f64)| short(joint.quantity.outward(*value), PER_MM);
        let shown = robot.joints().iter().zip(joints).map(outward).collect();
        let time_s = times.get(&(visit.pose, visit.cycle)).copied();
        let tool = tool(robot, values, joints).map(|pose| matrix(&pose));
        let parts = part_frames(robot, values, joints, &parts);
        poses.push(ShownPose { id: visit.id(several), set, joints: shown, time_s, strokes, tool, parts });
        points.extend(places(base, at, observation, outliers));
    }
    points.extend(base.conditions().filter_map(|error| {
        let pose = visits.iter().position(|visit| visit.pose == error.pose && visit.cycle == error.cycle)?;
        Some(quantity(error, pose))
    }));
    let magnification = magnification(&points, &poses);
    let frames = frames(robot, values, base.frames);
    let station = base.campaign.file.instrument.polar.map(|polar| polar.station_mm);
    let instrument = station.zip(export(base.frames)).map(|(station, world_T_export)| Instrument {
        name: base.campaign.file.instrument.name.clone(),
        at: world_T_export.apply(station),
    });
    let bodies = bodies.0.into_iter().map(|name| Named { name }).collect();
    Scene { unit: "mm", joints: joints(robot), bodies, frames, instrument, poses, points, magnification, parts }
}

/// Names of the moving parts, in the order of their first line.
#[derive(Default)]
struct Bodies(Vec<String>);

impl Bodies {
    fn index(&mut self, name: &str) -> usize {
        self.0.iter().position(|body| body == name).unwrap_or_else(|| {
            self.0.push(name.to_owned());
            self.0.len() - 1
        })
    }

    /// Lines of the robot, and lines from the flange to the measured targets.
    fn strokes(&mut self, robot: &dyn Robot, values: &[f64], at: &Observation, outline: &Outline) -> Vec<Stroke> {
        let mut strokes = Vec::new();
        for line in &outline.lines {
            let kind = if line.is_axis { "axis" } else { "link" };
            let points = line.points_mm.iter().map(|point| point.map(rounded)).collect();
            strokes.push(Stroke { body: self.index(&line.body), kind, points });
        }
        let Some(arm) = robot.free_base() else { return strokes };
        // a visit may have conditions alone
        let is_shown =
            |k: &usize| at.targets.get(*k).is_some_and(Option::is_some) || at.targets.iter().all(Option::is_none);
        for k in (0..robot.targets().len()).filter(is_shown) {
            let ends = [arm.flange(values, &at.joints, k).translation_mm, robot.position(values, &at.joints, k)];
            if ends.iter().flatten().all(|v| v.is_finite()) {
                let points = ends.map(|point| point.map(rounded)).to_vec();
                strokes.push(Stroke { body: self.index("targets"), kind: "target", points });
            }
        }
        strokes
    }
}

/// A length to a micrometre: lines are drawn, not measured.
fn rounded(mm: f64) -> f64 {
    (mm * UM).round() / UM
}

/// A value (mm, deg or µm) to a billionth of a metre or of a turn: pages of thousands of poses stay
/// small.
fn short(value: f64, per_unit: f64) -> f64 {
    (value * per_unit).round() / per_unit
}

/// Steps of a millimetre or degree, and of a micrometre, to which values are rounded.
const PER_MM: f64 = 1e6;
const PER_UM: f64 = 1e3;

/// Five digits of a covariance.
fn digits(value: f64) -> f64 {
    let scale = 10f64.powf(4.0 - value.abs().max(f64::MIN_POSITIVE).log10().floor());
    if scale.is_finite() { short(value, scale) } else { value }
}

/// Pose of flange or platform in the world.
fn tool(robot: &dyn Robot, values: &[f64], joints: &[f64]) -> Option<Pose> {
    let pose = match (robot.free_base(), robot.kinematics()) {
        (Some(arm), _) => arm.flange(values, joints, 0),
        (None, Some(kinematics)) => {
            let platform = kinematics.tool_pose(values, joints)?;
            kinematics.base_in_world(values).map_or(platform, |base| base.then(&platform))
        }
        (None, None) => return None,
    };
    pose.translation_mm.iter().chain(pose.rotation.as_flattened()).all(|v| v.is_finite()).then_some(pose)
}

/// A pose as 16 numbers, row by row.
fn matrix(pose: &Pose) -> Vec<f64> {
    rows(pose).chain([0.0, 0.0, 0.0, 1.0]).collect()
}

/// The first three rows of a pose.
fn rows(pose: &Pose) -> impl Iterator<Item = f64> {
    (0..3).flat_map(|i| [&pose.rotation[i][..], &[pose.translation_mm[i]]].concat())
}

/// Frames of these parts: they are drawn, not measured.
fn part_frames(robot: &dyn Robot, values: &[f64], joints: &[f64], parts: &[String]) -> Vec<Vec<f64>> {
    if parts.is_empty() {
        return Vec::new();
    }
    let all = robot.part_frames(values, joints);
    let frame = |part: &String| all.iter().find(|(name, _)| name == part).map(|(_, pose)| *pose);
    let drawn = |pose: Pose| rows(&pose).map(|v| short(v, 1e5)).collect();
    parts.iter().filter_map(frame).map(drawn).collect()
}

/// Joints with their limits.
fn joints(robot: &dyn Robot) -> Vec<JointScale> {
    let scale = |(i, joint): (usize, &etalon_robots::Joint)| {
        let [lower, upper] = match robot.joint_range(i) {
            JointRange::Limits(ends) => ends.map(|end| Some(joint.quantity.outward(end)).filter(|end| end.is_finite())),
            JointRange::Endless | JointRange::Unstated => [None, None],
        };
        JointScale { name: joint.name.clone(), unit: joint.quantity.unit(), lower, upper }
    };
    robot.joints().iter().enumerate().map(scale).collect()
}

/// Frame of the exports in the world, if it is one for all poses.
fn export(frames: &FramesDocument) -> Option<Pose> {
    match &frames.world.poses[..] {
        [only] if only.pose.is_none() => Some(only.export_T_world.inverse()),
        _ => None,
    }
}

/// World, base and frame of the exports.
fn frames(robot: &dyn Robot, values: &[f64], frames: &FramesDocument) -> Vec<NamedPose> {
    let base = match robot.free_base() {
        Some(_) => Some(base_pose(values)),
        None => robot.kinematics().and_then(|kinematics| kinematics.base_in_world(values)),
    };
    let all = [("world", Some(Pose::identity())), ("base", base), ("export", export(frames))];
    all.into_iter().filter_map(|(name, pose)| Some(NamedPose { name: name.to_owned(), pose: matrix(&pose?) })).collect()
}

/// Times (s) of the poses from the first one.
fn first_times(times: &[ObservationTime]) -> BTreeMap<(etalon_base::pose_name::PoseName, i64), f64> {
    let first = times.iter().map(|t| t.time_s).filter(|t| t.is_finite()).fold(f64::INFINITY, f64::min);
    let mut all = BTreeMap::new();
    for t in times.iter().filter(|t| t.time_s.is_finite()) {
        all.entry((t.pose, t.cycle)).or_insert(t.time_s - first);
    }
    all
}

/// Measured places of the targets at a pose.
fn places(base: &Base, pose: usize, observation: &Observation, outliers: &BTreeSet<(usize, usize)>) -> Vec<Point> {
    let Base { robot, found, .. } = *base;
    let solution = &found.solution;
    let covariances = place_covariances(robot, &solution.found, &observation.joints);
    let measured = observation.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)));
    let point = |(k, measured): (usize, Vector)| {
        let error = |values: &[f64]| minus(measured, robot.position(values, &observation.joints, k));
        let (before, after) = (error(&solution.before), error(&solution.found.values));
        let covariance = covariances.as_ref().map(|all| all[k]).filter(|c| c.iter().all(|v| v.is_finite()));
        let mut errors = in_um(before, after);
        errors.uncertainty_um = covariance.map(|c| short(2.0 * UM * longest_axis_mm(&c), PER_UM));
        errors.covariance_um2 =
            covariance.map(|c| [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|at| digits(c[at] * UM * UM)));
        Point {
            pose,
            target: robot.targets()[k].clone(),
            kind: "position".to_owned(),
            measured: measured.map(|mm| short(mm, PER_MM)),
            errors,
            outlier: outliers.contains(&(pose, k)).then_some(true),
            used: base.uses(base.visits[pose], k),
        }
    };
    measured.map(point).collect()
}

/// Errors (mm) in µm; errors that are not finite are omitted.
fn in_um(before: Vector, after: Vector) -> PointErrors {
    let finite = |v: Vector| v.iter().all(|v| v.is_finite()).then(|| v.map(|mm| mm * UM));
    let (before, after) = (finite(before), finite(after));
    let size = |um: Option<Vector>| um.map(|um| short(norm(um), PER_UM));
    PointErrors {
        before: before.map(|um| um.map(|um| short(um, PER_UM))),
        after: after.map(|um| um.map(|um| short(um, PER_UM))),
        magnitude_before_um: size(before),
        magnitude_after_um: size(after),
        ..PointErrors::default()
    }
}

/// A measured quantity other than a position.
fn quantity(error: &PointError, pose: usize) -> Point {
    Point {
        pose,
        target: error.target.clone(),
        kind: error.quantity.to_string(),
        // the place is the computed one: of a position, the measured one lies off by the error
        measured: match error.quantity {
            ErrorQuantity::Position => [0, 1, 2].map(|i| error.at_mm[i] + error.after_mm[i]),
            _ => error.at_mm,
        },
        errors: in_um(error.before_mm, error.after_mm),
        outlier: None,
        used: StoredSet::ALL.contains(&error.set),
    }
}

/// Magnification of arrows: a round number with which a large error before calibration is a
/// twentieth of the scene.
fn magnification(points: &[Point], poses: &[ShownPose]) -> f64 {
    let drawn = poses.iter().flat_map(|pose| &pose.strokes).flat_map(|stroke| &stroke.points);
    let all: Vec<&Vector> = points.iter().map(|point| &point.measured).chain(drawn).collect();
    let extent = |i: usize| {
        let ends = all.iter().map(|p| p[i]).fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(v), b.max(v)));
        ends.1 - ends.0
    };
    let size = (0..3).map(extent).fold(0.0, f64::max);
    let mut errors: Vec<f64> = points.iter().filter_map(|point| point.errors.magnitude_before_um).collect();
    errors.sort_by(f64::total_cmp);
    let large = errors.get(errors.len() * 19 / 20).copied().unwrap_or(0.0) / UM;
    let wanted = DRAWN * size / large;
    if !wanted.is_finite() || wanted <= 1.0 {
        return 1.0;
    }
    let decade = 10f64.powf(wanted.log10().floor());
    [5.0, 2.0, 1.0].map(|step| step * decade).into_iter().find(|round| *round <= wanted).unwrap_or(decade)
}
