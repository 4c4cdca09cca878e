//! Errors before and after: measured minus predicted, separately for calibration and validation
//! poses.

use crate::stages::join::ObservationTime;
use crate::stages::kinds::Observed;
use crate::stages::remedies::remedied;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use etalon_campaign::{Campaign, Limits, Selections};
use etalon_documents::ErrorQuantity::{self, Orientation, Position};
use etalon_documents::{
    AccuracyDocument, AccuracySet, DistanceStatistics, ErrorStatistics, Figure, FigureBudget, FigureContribution,
    LimitQuantity, LimitVerdict, PointError, PoseSet, ReadingReliability, RelativeAccuracy, Statistics,
};
use etalon_formats::table::{self, XYZ};
use etalon_identify::{
    self as identify, Condition, DistanceErrors, FigureUncertainty, FrameError, JudgedErrors, Observation, Settings,
    Systematic,
};
use etalon_math::statistics::{SizeStatistics, rms};
use etalon_robots::{Robot, State};
use polars::prelude::{Column, DataFrame};
use std::collections::{BTreeMap, BTreeSet};

/// Observations divided into calibration and validation.
#[derive(Clone, Debug, Default)]
pub struct Sets {
    /// For calibration.
    pub calibration: Vec<Observation>,
    /// For validation; may be empty.
    pub validation: Vec<Observation>,
    /// Conditions in addition to the positions, for calibration.
    pub calibration_conditions: Vec<Condition>,
    /// Conditions in addition to the positions, for validation.
    pub validation_conditions: Vec<Condition>,
}

impl Sets {
    /// Observations and conditions of a set.
    pub fn observations_and_conditions(&self, set: PoseSet) -> (&[Observation], &[Condition]) {
        match set {
            PoseSet::Calibration => (&self.calibration, &self.calibration_conditions),
            PoseSet::Validation => (&self.validation, &self.validation_conditions),
        }
    }
}

/// Divides observations; indices of poses count from 0 over `poses`, the remaining poses of the
/// identified log.
pub fn split(observed: &Observed, poses: &BTreeSet<PoseName>, selections: &Selections) -> Sets {
    let indices: BTreeMap<PoseName, usize> = poses.iter().enumerate().map(|(i, pose)| (*pose, i)).collect();
    let index = |pose: PoseName| indices.get(&pose).copied().unwrap_or_else(|| poses.range(..pose).count());
    let calibrates = |pose: PoseName| selections.calibrates(pose, index(pose));
    let validates = |pose: PoseName| selections.validates(pose, index(pose));
    let (observations, conditions) = (observed.observations.iter(), observed.settings.conditions.iter());
    Sets {
        calibration: observations.clone().filter(|o| calibrates(o.pose)).cloned().collect(),
        validation: observations.filter(|o| validates(o.pose)).cloned().collect(),
        calibration_conditions: conditions.clone().filter(|c| calibrates(c.pose)).cloned().collect(),
        validation_conditions: conditions.filter(|c| validates(c.pose)).cloned().collect(),
    }
}

/// Errors of every observation of both sets with two sets of parameters.
pub fn errors(robot: &dyn Robot, sets: &Sets, before: &[f64], after: &[f64]) -> Vec<PointError> {
    BeforeAfter { robot, before, after }.errors(sets)
}

/// Root mean square (mm) of the position errors of all targets; `None` without any.
pub fn position_rms_mm(robot: &dyn Robot, observations: &[Observation], values: &[f64]) -> Option<f64> {
    let of = |o: &Observation| -> Vec<f64> {
        let measured = o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)));
        measured.map(|(k, at)| norm(minus(at, robot.position(values, &o.joints, k)))).collect()
    };
    let errors: Vec<f64> = observations.iter().flat_map(of).collect();
    (!errors.is_empty()).then(|| rms(errors))
}

/// Root mean square (mm) of a coordinate's residual from the mean over the targets of its pose,
/// with n − 1 for n targets; `None` where no observation shows several targets.
pub fn within_poses_rms_mm(robot: &dyn Robot, observations: &[Observation], values: &[f64]) -> Option<f64> {
    let of = |o: &Observation| -> Option<(f64, usize)> {
        let measured = o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)));
        let left: Vec<_> = measured.map(|(k, at)| minus(at, robot.position(values, &o.joints, k))).collect();
        let mean = centroid(&left)?;
        Some((left.iter().map(|r| norm(minus(*r, mean)).powi(2)).sum(), left.len() - 1))
    };
    let all = observations.iter().filter_map(of).fold((0.0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    let degrees = (robot.dimension() * all.1) as f64;
    (degrees > 0.0).then(|| (all.0 / degrees).sqrt())
}

/// Replaces the errors after calibration by those of a robot with a residual field.
pub fn correct(errors: &mut [PointError], corrected: &dyn Robot, sets: &Sets, after: &[f64]) {
    let others = self::errors(corrected, sets, after, after);
    for (error, other) in errors.iter_mut().zip(others) {
        (error.after_mm, error.after_deg) = (other.after_mm, other.after_deg);
    }
}

/// A robot with all parameters before and after an identification.
#[derive(Clone, Copy)]
struct BeforeAfter<'a> {
    robot: &'a dyn Robot,
    before: &'a [f64],
    after: &'a [f64],
}

impl BeforeAfter<'_> {
    /// Errors of every observation of both sets.
    fn errors(&self, sets: &Sets) -> Vec<PointError> {
        let Self { robot, before, after } = *self;
        let mut all = Vec::new();
        for set in PoseSet::ALL {
            let (observations, conditions) = sets.observations_and_conditions(set);
            for o in observations {
                match robot.platform() {
                    Some(platform) => {
                        let [Some(k), Some(l)] = o.targets[..] else { continue };
                        let pair = [[k[0], k[1]], [l[0], l[1]]];
                        let error = |p: &[f64]| platform.pose_error(p, &o.joints, pair).map(|r| -r);
                        let (b, a) = (error(before), error(after));
                        let at = platform.measured_pose(after, pair);
                        all.push(PointError {
                            set,
                            pose: o.pose,
                            cycle: o.cycle,
                            target: "C".to_owned(),
                            quantity: Position,
                            at_mm: [at.x_mm, at.y_mm, 0.0],
                            before_mm: [b[0], b[1], 0.0],
                            after_mm: [a[0], a[1], 0.0],
                            before_deg: Some(b[2].to_degrees()),
                            after_deg: Some(a[2].to_degrees()),
                            joints: logged(robot, &o.joints),
                            reliability: None,
                            own_redundancy: None,
                        });
                    }
                    None => all.extend(self.target_errors(o, set)),
                }
            }
            for condition in conditions {
                self.condition_error(condition, set, &mut all);
            }
        }
        all
    }

    /// Adds the error of a condition: of an orientation the angle, beside the position error of the
    /// same target.
    fn condition_error(&self, condition: &Condition, set: PoseSet, all: &mut Vec<PointError>) {
        let Self { robot, before, after } = *self;
        let target = &robot.targets()[condition.target];
        let (b, a) = (condition.error(robot, before), condition.error(robot, after));
        if condition.kind.is_orientation() {
            let same = |e: &&mut PointError| {
                e.set == set && e.pose == condition.pose && e.cycle == condition.cycle && e.target == *target
            };
            if let Some(error) = all.iter_mut().rev().find(same) {
                error.before_deg = Some(norm(b).to_degrees());
                error.after_deg = Some(norm(a).to_degrees());
            }
            return;
        }
        // the value of a joint is not an error of a target
        let Some(kind) = condition.kind.error_kind() else { return };
        all.push(PointError {
            set,
            pose: condition.pose,
            cycle: condition.cycle,
            target: target.clone(),
            quantity: kind.into(),
            at_mm: robot.position(after, &condition.joints, condition.target),
            before_mm: b,
            after_mm: a,
            before_deg: None,
            after_deg: None,
            joints: logged(robot, &condition.joints),
            reliability: None,
            own_redundancy: None,
        });
    }

    /// Errors of each target of a pose in space; with three or more on one branch, the rotation
    /// that remains between them.
    fn target_errors(&self, o: &Observation, set: PoseSet) -> Vec<PointError> {
        let Self { robot, before, after } = *self;
        let seen: Vec<(usize, Vector)> = o.targets.iter().enumerate().filter_map(|(k, t)| Some((k, (*t)?))).collect();
        let seen = &seen[..];
        let of_branch = |i: usize| {
            let same = move |k: &usize| robot.target_branch(seen[*k].0) == robot.target_branch(seen[i].0);
            (0..seen.len()).filter(same)
        };
        let predict = |p: &[f64]| -> Vec<Vector> { seen.iter().map(|s| robot.position(p, &o.joints, s.0)).collect() };
        let (b, a) = (predict(before), predict(after));
        // a rotation needs three targets that are not on one line
        let turned = |of_all: &[Vector], i: usize| {
            // one rotation a pose and branch: with its first target
            let first = of_branch(i).next() == Some(i);
            let (from, to): (Vec<Vector>, Vec<Vector>) =
                of_branch(i).filter(|_| first).map(|k| (of_all[k], seen[k].1)).unzip();
            let fitted = etalon_fit::rigid(&from, &to).ok()?;
            Some(fitted.to_T_from.angle_rad().to_degrees())
        };
        let error = |i: usize| PointError {
            set: set.to_owned(),
            pose: o.pose,
            cycle: o.cycle,
            target: robot.targets()[seen[i].0].clone(),
            quantity: Position,
            at_mm: seen[i].1,
            before_mm: minus(seen[i].1, b[i]),
            after_mm: minus(seen[i].1, a[i]),
            before_deg: turned(&b, i),
            after_deg: turned(&a, i),
            joints: logged(robot, &o.joints),
            reliability: None,
            own_redundancy: None,
        };
        (0..seen.len()).map(error).collect()
    }
}

/// Errors of the measured points without orientations, for many sets of parameters.
pub(super) struct PointErrors<'a> {
    robot: &'a dyn Robot,
    sets: &'a Sets,
    /// Loads at each observation; empty if bending is not modelled.
    loads: Vec<Vec<f64>>,
}

impl<'a> PointErrors<'a> {
    pub fn new(robot: &'a dyn Robot, sets: &'a Sets) -> Self {
        let observations = || PoseSet::ALL.into_iter().flat_map(|set| sets.observations_and_conditions(set).0);
        let loads = robot.loads().map_or_else(Vec::new, |at| observations().map(|o| at(&o.joints)).collect());
        Self { robot, sets, loads }
    }

    /// Pose and error (mm) of each point with these parameters.
    pub fn with(&self, values: &[f64]) -> Vec<(PoseName, Vector)> {
        let (robot, bound) = (self.robot, self.robot.parametrised(values));
        let d = robot.dimension();
        let mut predicted = vec![0.0; d * robot.targets().len()];
        let mut loads = self.loads.iter();
        let mut all = Vec::new();
        for set in PoseSet::ALL {
            let (observations, conditions) = self.sets.observations_and_conditions(set);
            for o in observations {
                let loads = loads.next().map_or(&[][..], Vec::as_slice);
                if let Some(platform) = robot.platform() {
                    if let [Some(k), Some(l)] = o.targets[..] {
                        let [x, y, _] = platform.pose_error(values, &o.joints, [[k[0], k[1]], [l[0], l[1]]]);
                        all.push((o.pose, [-x, -y, 0.0]));
                    }
                    continue;
                }
                bound.positions(State { joints: &o.joints, loads }, &mut predicted);
                let measured = predicted.chunks_exact(d).zip(&o.targets).filter_map(|(p, at)| Some((p, (*at)?)));
                all.extend(
                    measured.map(|(p, at)| (o.pose, minus(at, [0, 1, 2].map(|i| p.get(i).copied().unwrap_or(0.0))))),
                );
            }
            let of_points = conditions.iter().filter(|c| c.kind.error_kind().is_some());
            all.extend(of_points.map(|c| (c.pose, c.error(robot, values))));
        }
        all
    }
}

/// Adds the time of each observation (s) from the first, as the last of the quantities against
/// which errors are drawn; `true` if there are times.
pub fn with_times(errors: &mut [PointError], times: &[ObservationTime]) -> bool {
    if times.is_empty() {
        return false;
    }
    let first = times.iter().map(|t| t.time_s).filter(|t| t.is_finite()).fold(f64::INFINITY, f64::min);
    // the centre of a platform has the time of its first target
    let mut of_pose = BTreeMap::new();
    let mut of_target = BTreeMap::new();
    for t in times {
        of_pose.entry((t.pose, t.cycle)).or_insert(t.time_s - first);
        of_target.entry((t.pose, t.cycle, t.target.as_str())).or_insert(t.time_s - first);
    }
    for e in errors {
        let own = of_target.get(&(e.pose, e.cycle, e.target.as_str()));
        e.joints.push(own.or(of_pose.get(&(e.pose, e.cycle))).copied().unwrap_or(f64::NAN));
    }
    true
}

/// Values of the joints in mm or deg.
fn logged(robot: &dyn Robot, joints: &[f64]) -> Vec<f64> {
    robot.joints().iter().zip(joints).map(|(joint, value)| joint.quantity.outward(*value)).collect()
}

/// Judged parameters, the observations that judge them, and those that locate base, targets and
/// fixtures.
#[derive(Clone, Copy)]
pub struct Judged<'a> {
    /// Robot.
    pub robot: &'a dyn Robot,
    /// All parameters.
    pub values: &'a [f64],
    /// Indices of the parameters of base, targets and fixtures that were fitted to the calibration
    /// poses.
    pub set_up: &'a [usize],
    /// All observations, including those of separately located targets.
    pub sets: &'a Sets,
    /// Weights of the observations.
    pub settings: &'a Settings,
}

/// Uncertainties of measured errors. The parameters are under test and contribute nothing.
#[derive(Clone, Debug, Default)]
pub struct ErrorUncertainty {
    /// Budget of each figure of lengths.
    pub figures: Vec<FigureBudget>,
    /// Standard uncertainty of an orientation (deg); `None` if unknown.
    pub orientation_deg: Option<f64>,
    /// Standard uncertainty of a coordinate (mm).
    coordinate_mm: f64,
}

impl ErrorUncertainty {
    /// Propagates the uncertainty of instrument, frames, scale, temperature and homing to the
    /// errors of the deciding poses.
    ///
    /// # Errors
    /// Fails if residuals cannot be evaluated.
    pub fn new(campaign: &Campaign, judged: Judged, systematic: &Systematic) -> Result<Self> {
        let Judged { robot, values, set_up, sets, settings } = judged;
        let instrument = &campaign.file.instrument;
        let coordinate_mm = settings.coordinate_uncertainty_mm();
        let validates =
            !sets.validation.is_empty() || sets.validation_conditions.iter().any(|c| c.kind.error_kind().is_some());
        let (observations, conditions) =
            sets.observations_and_conditions(if validates { PoseSet::Validation } else { PoseSet::Calibration });
        let errors = JudgedErrors {
            robot,
            values,
            set_up,
            calibration: &sets.calibration,
            observations,
            conditions,
            position_mm: instrument.position_uncertainty_mm(),
        };
        let planar = robot.dimension() == 2;
        let all = || sets.calibration.iter().chain(&sets.validation);
        let turned = |o| rotation_per_mm(robot, o);
        let of_targets = all().filter_map(turned).reduce(f64::max).map(|per_mm| (per_mm * coordinate_mm).to_degrees());
        let stated = instrument.rotation_uncertainty_rad().map(|u| 3f64.sqrt() * u.to_degrees());
        let of_frame = frame_rotation_rad(systematic, planar).to_degrees();
        Ok(Self {
            figures: budgets(errors.figures(settings, systematic).map_err(remedied)?),
            orientation_deg: stated.or(of_targets).map(|u| u.hypot(of_frame)),
            coordinate_mm,
        })
    }

    /// Expanded uncertainty (k = 2) of a figure.
    fn expanded(&self, quantity: ErrorQuantity, figure: Figure) -> Option<f64> {
        if quantity == Orientation {
            return self.orientation_deg.map(|u| 2.0 * u);
        }
        let of_figure = |b: &&FigureBudget| b.quantity == quantity && b.figure == figure;
        let budget = self.figures.iter().find(of_figure).map(|b| 2.0 * b.standard_uncertainty_mm);
        // positions of another station have no axes of their own
        let coordinate = (ErrorQuantity::AXES.contains(&quantity) && self.coordinate_mm > 0.0).then_some(2.0);
        budget.or(coordinate.map(|k| k * self.coordinate_mm))
    }
}

/// Errors of the distances between the deciding poses, with robot and parameters `before` and with
/// the judged ones; `None` without two poses of one target.
///
/// # Errors
/// Fails if residuals cannot be evaluated.
pub fn relative(
    campaign: &Campaign,
    judged: Judged,
    before: (&dyn Robot, &[f64]),
    systematic: &Systematic,
) -> Result<Option<RelativeAccuracy>> {
    let Judged { robot, values, set_up, sets, settings } = judged;
    let set = if sets.validation.is_empty() { PoseSet::Calibration } else { PoseSet::Validation };
    let errors = JudgedErrors {
        robot,
        values,
        set_up,
        calibration: &sets.calibration,
        observations: sets.observations_and_conditions(set).0,
        conditions: &[],
        position_mm: campaign.file.instrument.position_uncertainty_mm(),
    };
    let found = errors.distances(before.0, before.1, settings, systematic).map_err(remedied)?;
    Ok(found.map(|found| RelativeAccuracy {
        set,
        available: found.available,
        all: distances(found.all),
        steps: found.steps.into_iter().map(distances).collect(),
    }))
}

fn distances(errors: DistanceErrors) -> DistanceStatistics {
    let expanded = |k: usize| errors.standard_uncertainties_mm.map(|u| 2.0 * u[k]);
    DistanceStatistics {
        from_mm: errors.range_mm[0],
        to_mm: errors.range_mm[1],
        pairs: errors.pairs,
        expanded_rms_mm: expanded(0),
        expanded_p95_mm: expanded(1),
        expanded_max_mm: expanded(2),
        before: documented(errors.sizes_mm[0]),
        after: documented(errors.sizes_mm[1]),
    }
}

/// Largest standard uncertainty (rad) of the rotation of a frame that is measured again at each
/// pose; the base absorbs the part that is common to all poses.
fn frame_rotation_rad(systematic: &Systematic, planar: bool) -> f64 {
    let axes = if planar { 5..6 } else { 3..6 };
    let of = |frame: &FrameError| axes.clone().map(|i| frame.covariance[i][i]).sum::<f64>();
    systematic.frames.iter().filter(|f| f.pose.is_some()).map(of).fold(0.0, f64::max).sqrt()
}

/// Standard uncertainty of the rotation of the targets of an observation, rad for 1 mm of a
/// coordinate: the root of the trace of the inverse of Σ(|r|²I - r rᵀ), r from their centroid;
/// planar robots rotate about z alone. The largest of all branches.
fn rotation_per_mm(robot: &dyn Robot, o: &Observation) -> Option<f64> {
    let of_branch = |branch: usize| {
        let own = o.targets.iter().enumerate().filter(|(k, _)| robot.target_branch(*k) == branch);
        body_rotation_per_mm(&own.filter_map(|(_, at)| *at).collect::<Vec<_>>(), robot.dimension() == 2)
    };
    (0..robot.branches().len().max(1)).filter_map(of_branch).reduce(f64::max)
}

/// [`rotation_per_mm`] of the targets of one body.
fn body_rotation_per_mm(measured: &[Vector], planar: bool) -> Option<f64> {
    let middle = centroid(measured)?;
    let arms = measured.iter().map(|p| nalgebra::Vector3::from(minus(*p, middle)));
    let inertia: nalgebra::Matrix3<f64> =
        arms.map(|r| nalgebra::Matrix3::identity() * r.norm_squared() - r * r.transpose()).sum();
    let trace = if planar { inertia[(2, 2)].recip() } else { inertia.try_inverse()?.trace() };
    Some(trace.sqrt()).filter(|u| u.is_finite())
}

/// Definition of the errors by the quantities that were measured.
fn error_of_targets(sets: &[AccuracySet]) -> Phrase {
    let measured = |quantity| sets.iter().any(|s| s.error_statistics(quantity).is_some());
    match (measured(ErrorQuantity::Position), measured(ErrorQuantity::Orientation)) {
        (true, true) => phrase!("error-of-targets"),
        (true, false) => phrase!("error-of-positions"),
        (false, _) => phrase!("error-of-quantities"),
    }
}

/// Statistics of the errors, and the verdict on the campaign's limits.
pub fn evaluate(
    robot: &dyn Robot,
    errors: &[PointError],
    limits: &Limits,
    uncertainty: ErrorUncertainty,
) -> AccuracyDocument {
    let planar = robot.dimension() == 2;
    let mut sets = Vec::new();
    for name in PoseSet::ALL {
        let of: Vec<&PointError> = errors.iter().filter(|e| e.set == name && e.own_share().is_some()).collect();
        if !of.is_empty() {
            sets.push(accuracy_set(name, &of, planar, &uncertainty));
        }
    }
    let verdicts = verdicts(limits, sets.last(), &uncertainty);
    let (point, error) = match robot.platform() {
        // parameters that shift balls and tool alike do not show in these errors
        Some(_) => (phrase!("platform-as-measured"), phrase!("error-of-platform")),
        None => (phrase!("targets-as-measured"), error_of_targets(&sets)),
    };
    let definition = phrase!("error-definition", error, values = phrase!("values-of-identification"));
    AccuracyDocument {
        schema: "etalon/accuracy/1".to_owned(),
        campaign: None,
        provenance: None,
        definition: definition.to_string(),
        definition_phrase: Some(definition),
        point: point.to_string(),
        point_phrase: Some(point),
        joints: robot.joints().iter().map(|joint| joint.column()).collect(),
        sets,
        validation_distance: None,
        relative: None,
        placed_apart: Vec::new(),
        effects: Vec::new(),
        budget: uncertainty.figures,
        trends: Vec::new(),
        parameter_influences: Vec::new(),
        limits: verdicts,
        tool: None,
        map: None,
        field: None,
        given: None,
    }
}

/// Verdicts on the limits of errors, at the deciding poses. A limit is not assessable if its
/// quantity was not measured there.
fn verdicts(limits: &Limits, judged: Option<&AccuracySet>, uncertainty: &ErrorUncertainty) -> Vec<LimitVerdict> {
    let rule = limits.decision_rule.unwrap_or_default();
    let verdict = |(name, limit): (LimitQuantity, f64)| {
        let (quantity, figure) = name.limited_error()?;
        Some(match judged.and_then(|set| set.error_statistics(quantity)) {
            Some(errors) => {
                let expanded = uncertainty.expanded(quantity, figure);
                LimitVerdict::judge(name, limit, figure.value_in(&errors.after), expanded, rule)
            }
            None => LimitVerdict::not_assessable(name, limit, rule),
        })
    };
    limits.stated().filter_map(verdict).collect()
}

fn accuracy_set(name: PoseSet, errors: &[&PointError], planar: bool, uncertainty: &ErrorUncertainty) -> AccuracySet {
    let poses: BTreeSet<PoseName> = errors.iter().map(|e| e.pose).collect();
    let of = |quantity| errors.iter().copied().filter(|e| e.quantity == quantity).collect::<Vec<&PointError>>();
    let positions = of(Position);
    let mut quantities = vec![statistics(Position, "mm", &positions, &|v, _| Some(norm(v)))];
    for (axis, quantity) in ErrorQuantity::AXES.into_iter().enumerate().take(if planar { 2 } else { 3 }) {
        quantities.push(statistics(quantity, "mm", &positions, &move |v, _| Some(v[axis].abs())));
    }
    quantities.push(statistics(Orientation, "deg", errors, &|_, deg| deg.map(f64::abs)));
    let other = |quantity| statistics(quantity, "mm", &of(quantity), &|v, _| Some(norm(v)));
    quantities.extend(ErrorQuantity::OTHERS.map(other));
    quantities.retain(|of| of.count > 0);
    for of in &mut quantities {
        of.expanded_uncertainty = uncertainty.expanded(of.quantity, Figure::Max);
    }
    AccuracySet { name, poses: poses.len(), count: errors.len(), errors: quantities }
}

/// Budgets of figures from the variances (mm²) of each source.
fn budgets(figures: Vec<FigureUncertainty>) -> Vec<FigureBudget> {
    let contribution = |(source, variance): (identify::UncertaintySource, f64)| FigureContribution {
        source: source.into(),
        standard_uncertainty_mm: variance.sqrt(),
    };
    let of = |FigureUncertainty { kind, figure, contributions }| FigureBudget {
        quantity: kind.into(),
        figure: figure.into(),
        standard_uncertainty_mm: contributions.iter().map(|(_, v)| v).sum::<f64>().sqrt(),
        contributions: contributions.into_iter().map(contribution).collect(),
    };
    figures.into_iter().map(of).collect()
}

type Size<'a> = &'a dyn Fn(Vector, Option<f64>) -> Option<f64>;

fn statistics(quantity: ErrorQuantity, unit: &str, errors: &[&PointError], size: Size) -> ErrorStatistics {
    let of = |pick: &dyn Fn(&PointError) -> Option<f64>| {
        summarise(errors.iter().filter_map(|e| Some(pick(e)? / e.own_share()?)).collect())
    };
    ErrorStatistics {
        quantity,
        count: errors.iter().filter(|e| size(e.after_mm, e.after_deg).is_some()).count(),
        unit: unit.to_owned(),
        before: of(&|e| size(e.before_mm, e.before_deg)),
        after: of(&|e| size(e.after_mm, e.after_deg)),
        expanded_uncertainty: None,
    }
}

/// Mean, root mean square, 95 % (linear between order statistics, as spreadsheets do) and maximum
/// of sizes.
pub(super) fn summarise(mut sizes: Vec<f64>) -> Statistics {
    documented(SizeStatistics::new(&mut sizes))
}

fn documented(sizes: SizeStatistics) -> Statistics {
    let SizeStatistics { mean, rms, p95, max } = sizes;
    Statistics { mean, rms, p95, max }
}

/// The errors as a table: `set pose cycle target x_mm y_mm z_mm before_* after_*`, the columns
/// `joints`, `own_redundancy`, and `redundancy w detectable_mm`.
pub fn to_table(errors: &[PointError], joints: &[String]) -> Result<DataFrame> {
    let text =
        |name: &str, f: fn(&PointError) -> &str| Column::new(name.into(), errors.iter().map(f).collect::<Vec<_>>());
    let whole =
        |name: &str, f: fn(&PointError) -> i64| Column::new(name.into(), errors.iter().map(f).collect::<Vec<_>>());
    let mut columns = vec![
        text("set", |e| e.set.name()),
        table::pose_column("pose", &errors.iter().map(|e| Some(e.pose)).collect::<Vec<_>>()),
        whole("cycle", |e| e.cycle),
        text("target", |e| &e.target),
        text(QUANTITY, |e| e.quantity.as_ref()),
    ];
    for (prefix, of) in VECTORS {
        for (axis, name) in XYZ.iter().enumerate() {
            let values: Vec<f64> = errors.iter().map(|e| of(e)[axis]).collect();
            columns.push(Column::new(format!("{prefix}{name}").into(), values));
        }
    }
    columns.push(Column::new("before_deg".into(), errors.iter().map(|e| e.before_deg).collect::<Vec<_>>()));
    columns.push(Column::new("after_deg".into(), errors.iter().map(|e| e.after_deg).collect::<Vec<_>>()));
    for (k, name) in joints.iter().enumerate() {
        let values: Vec<f64> = errors.iter().map(|e| e.joints.get(k).copied().unwrap_or(f64::NAN)).collect();
        columns.push(Column::new(name.as_str().into(), values));
    }
    let own: Vec<Option<f64>> = errors.iter().map(|e| e.own_redundancy).collect();
    columns.push(Column::new(OWN_REDUNDANCY.into(), own));
    for (name, of) in RELIABILITY {
        columns.push(Column::new(name.into(), errors.iter().map(|e| e.reliability.map(of)).collect::<Vec<_>>()));
    }
    table::frame(errors.len(), columns)
}

/// Column of the quantities of errors.
const QUANTITY: &str = "quantity";

/// Column of the redundancy of readings that locate their own target.
const OWN_REDUNDANCY: &str = "own_redundancy";

/// Name of a column, and the number in it.
type ReliabilityColumn = (&'static str, fn(ReadingReliability) -> f64);

const RELIABILITY: [ReliabilityColumn; 3] =
    [("redundancy", |r| r.redundancy), ("w", |r| r.w), ("detectable_mm", |r| r.detectable_mm)];

/// Prefix of three columns, and the vector in them.
type VectorColumns = (&'static str, fn(&PointError) -> Vector);

const VECTORS: [VectorColumns; 3] = [("", |e| e.at_mm), ("before_", |e| e.before_mm), ("after_", |e| e.after_mm)];

/// The errors from such a table.
pub fn from_table(frame: &DataFrame) -> Result<Vec<PointError>> {
    let set = |name: &String| -> Result<PoseSet> {
        let unknown = || error!("pose-set-unknown", name);
        Ok(PoseSet::ALL.into_iter().find(|set| set.name() == name).ok_or_else(unknown)?)
    };
    let sets = table::texts(frame, "set")?.iter().map(set).collect::<Result<Vec<_>>>()?;
    let targets = table::texts(frame, "target")?;
    let (poses, cycles) = (table::poses(frame)?, table::integers(frame, "cycle")?);
    let vectors = |prefix: &str| -> Result<Vec<Vector>> {
        let [x, y, z] = XYZ.map(|axis| table::numbers(frame, &format!("{prefix}{axis}")));
        Ok(x?.into_iter().zip(y?).zip(z?).map(|((x, y), z)| [x, y, z]).collect())
    };
    let (at, before, after) = (vectors("")?, vectors("before_")?, vectors("after_")?);
    let (before_deg, after_deg) = (table::numbers(frame, "before_deg")?, table::numbers(frame, "after_deg")?);
    let quantity = |name: &String| name.parse().map_err(|_| error!("error-quantity-unknown", name));
    let quantities: Vec<ErrorQuantity> =
        table::texts(frame, QUANTITY)?.iter().map(quantity).collect::<std::result::Result<_, _>>()?;
    let known = ["set", "pose", "cycle", "target", QUANTITY, "before_deg", "after_deg"];
    let of_reading = |name: &str| name == OWN_REDUNDANCY || RELIABILITY.iter().any(|column| column.0 == name);
    let is_joint =
        |name: &str| !known.contains(&name) && !of_reading(name) && !XYZ.iter().any(|axis| name.ends_with(axis));
    let names = frame.get_column_names().into_iter().map(|name| name.as_str()).filter(|name| is_joint(name));
    let joints = names.map(|name| table::numbers(frame, name)).collect::<Result<Vec<_>>>()?;
    let [redundancy, w, detectable] = RELIABILITY.map(|(name, _)| table::numbers(frame, name).unwrap_or_default());
    let own = table::numbers(frame, OWN_REDUNDANCY).unwrap_or_default();
    let reliability = |i: usize| {
        let redundancy = *redundancy.get(i).filter(|r| r.is_finite())?;
        Some(ReadingReliability { redundancy, w: *w.get(i)?, detectable_mm: *detectable.get(i)? })
    };
    let error = |i: usize| PointError {
        set: sets[i],
        pose: poses[i],
        cycle: cycles[i],
        target: targets[i].clone(),
        quantity: quantities[i],
        at_mm: at[i],
        before_mm: before[i],
        after_mm: after[i],
        before_deg: Some(before_deg[i]).filter(|d| d.is_finite()),
        after_deg: Some(after_deg[i]).filter(|d| d.is_finite()),
        joints: joints.iter().map(|values| values[i]).collect(),
        reliability: reliability(i),
        own_redundancy: own.get(i).copied().filter(|r| r.is_finite()),
    };
    Ok((0..frame.height()).map(error).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_definition_of_errors_names_what_was_measured() {
        let zero = summarise(Vec::new());
        let error = |quantity, unit: &str| ErrorStatistics {
            quantity,
            count: 1,
            unit: unit.to_owned(),
            before: zero,
            after: zero,
            expanded_uncertainty: None,
        };
        let id = |errors: Vec<ErrorStatistics>| {
            error_of_targets(&[AccuracySet { name: PoseSet::Validation, poses: 1, count: 1, errors }]).id
        };
        assert_eq!(id(vec![error(Position, "mm"), error(Orientation, "deg")]), "error-of-targets");
        assert_eq!(id(vec![error(Position, "mm")]), "error-of-positions");
        assert_eq!(id(vec![error(ErrorQuantity::Distance, "mm")]), "error-of-quantities");
    }

    #[test]
    fn each_error_has_the_time_of_its_target_and_a_platform_that_of_the_pose() {
        let time = |pose: i64, target: &str, time_s| ObservationTime {
            pose: pose.into(),
            cycle: 1,
            target: target.to_owned(),
            time_s,
        };
        let times = [time(1, "a", 1e9), time(1, "b", 1e9 + 2.0), time(2, "a", 1e9 + 60.0)];
        let error = |pose: i64, target: &str| PointError {
            set: PoseSet::Calibration,
            pose: pose.into(),
            cycle: 1,
            target: target.to_owned(),
            quantity: Position,
            at_mm: [0.0; 3],
            before_mm: [0.0; 3],
            after_mm: [0.0; 3],
            before_deg: None,
            after_deg: None,
            joints: vec![7.0],
            reliability: None,
            own_redundancy: None,
        };
        let mut errors = [error(1, "b"), error(2, "C"), error(3, "a")];
        assert!(with_times(&mut errors, &times));
        assert_eq!((&errors[0].joints[..], &errors[1].joints[..]), (&[7.0, 2.0][..], &[7.0, 60.0][..]));
        assert!(errors[2].joints[1].is_nan(), "a pose that was not observed has no time");
        assert!(!with_times(&mut errors, &[]) && errors[0].joints.len() == 2);
    }
}
