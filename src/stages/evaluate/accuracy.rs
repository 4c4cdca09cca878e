//! Accuracy: statistics of errors, their uncertainty, and the verdicts on their limits.

use crate::stages::evaluate::sets::Sets;
use crate::stages::remedies::remedied;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_campaign::{Campaign, Limits};
use etalon_documents::ErrorQuantity::{self, Orientation, Position};
use etalon_documents::{
    AccuracyDocument, AccuracySet, DistanceStatistics, ErrorStatistics, Figure, FigureBudget, FigureContribution,
    LimitQuantity, LimitVerdict, OrientationBudget, OrientationContribution, PointError, PoseSet, RelativeAccuracy,
    Statistics, UncertaintySource,
};
use etalon_identify::{
    self as identify, DistanceErrors, FigureUncertainty, FrameError, JudgedErrors, Observation, Settings, Systematic,
};
use etalon_math::statistics::SizeStatistics;
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Judged parameters, the observations that judge them, and the observations that locate base,
/// targets and fixtures.
#[derive(Clone, Copy)]
pub struct Judged<'a> {
    /// Robot.
    pub robot: &'a dyn Robot,
    /// All parameters.
    pub values: &'a [f64],
    /// Indices of the parameters of base, targets and fixtures that were fitted to the calibration
    /// poses.
    pub set_up: &'a [usize],
    /// All observations, including observations of separately located targets.
    pub sets: &'a Sets,
    /// Weights of the observations.
    pub settings: &'a Settings,
}

/// Uncertainties of measured errors. The parameters are under test and contribute nothing.
#[derive(Clone, Debug, Default)]
pub struct ErrorUncertainty {
    /// Budget of each figure of lengths.
    pub figures: Vec<FigureBudget>,
    /// Budget of an orientation; `None` if unknown.
    pub orientation: Option<OrientationBudget>,
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
            orientation: stated.or(of_targets).map(|u| orientation_budget(u, of_frame)),
            coordinate_mm,
        })
    }

    /// Expanded uncertainty (k = 2) of a figure.
    fn expanded(&self, quantity: ErrorQuantity, figure: Figure) -> Option<f64> {
        if quantity == Orientation {
            return self.orientation.as_ref().map(|budget| 2.0 * budget.standard_uncertainty_deg);
        }
        let of_figure = |b: &&FigureBudget| b.quantity == quantity && b.figure == figure;
        let budget = self.figures.iter().find(of_figure).map(|b| 2.0 * b.standard_uncertainty_mm);
        // positions of another station have no axes of their own
        let coordinate = (ErrorQuantity::AXES.contains(&quantity) && self.coordinate_mm > 0.0).then_some(2.0);
        budget.or(coordinate.map(|k| k * self.coordinate_mm))
    }
}

/// A robot with values of all parameters.
#[derive(Clone, Copy)]
pub struct RobotValues<'a> {
    /// Robot.
    pub robot: &'a dyn Robot,
    /// All parameters.
    pub values: &'a [f64],
}

/// Errors of the distances between the deciding poses, with the robot `before` and with the judged
/// parameters; `None` without two poses of one target.
///
/// # Errors
/// Fails if residuals cannot be evaluated.
pub fn relative(
    campaign: &Campaign,
    judged: Judged,
    before: RobotValues,
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
    let found = errors.distances(before.robot, before.values, settings, systematic).map_err(remedied)?;
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

/// Budget of an orientation from the standard uncertainties (deg) of its measurement and of the
/// frame that is measured again at each pose.
fn orientation_budget(measured_deg: f64, of_frame_deg: f64) -> OrientationBudget {
    let all = [(UncertaintySource::Instrument, measured_deg), (UncertaintySource::FrameOfPoses, of_frame_deg)];
    let contribution =
        |(source, standard_uncertainty_deg)| OrientationContribution { source, standard_uncertainty_deg };
    OrientationBudget {
        standard_uncertainty_deg: measured_deg.hypot(of_frame_deg),
        contributions: all.into_iter().filter(|(_, u)| *u > 0.0).map(contribution).collect(),
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
        let of: Vec<&PointError> =
            errors.iter().filter(|e| e.set == name && e.statistics_divisor().is_some()).collect();
        if !of.is_empty() {
            sets.push(accuracy_set(name, &of, planar, &uncertainty));
        }
    }
    let verdicts = verdicts(limits, sets.last(), &uncertainty);
    let measures_orientations = sets.iter().any(|set| set.error_statistics(Orientation).is_some());
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
        definition: definition.into(),
        point: point.into(),
        joints: robot.joints().iter().map(|joint| joint.column()).collect(),
        sets,
        validation_distance: None,
        relative: None,
        placed_apart: Vec::new(),
        effects: Vec::new(),
        left_out: None,
        orientation_budget: uncertainty.orientation.filter(|_| measures_orientations),
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
    AccuracySet { name, poses: poses.len(), count: errors.len(), errors: quantities, readings: Vec::new() }
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
        summarise(errors.iter().filter_map(|e| Some(pick(e)? / e.statistics_divisor()?)).collect())
    };
    let counted = || errors.iter().filter(|e| size(e.after_mm, e.after_deg).is_some());
    ErrorStatistics {
        quantity,
        count: counted().count(),
        poses: counted().map(|e| e.pose).collect::<BTreeSet<_>>().len(),
        unit: unit.to_owned(),
        before: of(&|e| size(e.before_mm, e.before_deg)),
        after: of(&|e| size(e.after_mm, e.after_deg)),
        expanded_uncertainty: None,
    }
}

/// Mean, root mean square, 95 % (linear between order statistics, as spreadsheets do) and maximum
/// of sizes.
pub(crate) fn summarise(mut sizes: Vec<f64>) -> Statistics {
    documented(SizeStatistics::new(&mut sizes))
}

fn documented(sizes: SizeStatistics) -> Statistics {
    let SizeStatistics { mean, rms, p95, max } = sizes;
    Statistics { mean, rms, p95, max }
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
            poses: 1,
            unit: unit.to_owned(),
            before: zero,
            after: zero,
            expanded_uncertainty: None,
        };
        let id = |errors: Vec<ErrorStatistics>| {
            error_of_targets(&[AccuracySet {
                name: PoseSet::Validation,
                poses: 1,
                count: 1,
                errors,
                readings: Vec::new(),
            }])
            .id
        };
        assert_eq!(id(vec![error(Position, "mm"), error(Orientation, "deg")]), "error-of-targets");
        assert_eq!(id(vec![error(Position, "mm")]), "error-of-positions");
        assert_eq!(id(vec![error(ErrorQuantity::Distance, "mm")]), "error-of-quantities");
    }
}
