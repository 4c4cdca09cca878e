//! Document of an identification: parameters with the evidence for them.

use crate::*;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Severity};
use etalon_base::phrase;
use etalon_base::pose::{Vector, minus, norm};
use etalon_identify::{
    Condition, ConditionResiduals, Contradicted, Extrapolation, Group, Identification, Kind, Known, KnownResidual,
    Observability, Origin, Prior, RANK_TOLERANCE, ReadingKind, RigidPart, SetUpError, Settings, SingularValue, Status,
    Subject, Untested, Warning,
};
use etalon_robots::{Quantity, Robot};
use std::collections::{BTreeMap, BTreeSet};

/// Maximum size of a group whose members list all other members. The lists of larger groups would
/// grow with the square of the size.
const LISTED: usize = 100;

/// Lists for each parameter the other members of its groups. In a large group only the held
/// parameter lists all members; the others list the held parameter.
fn confounded(parameters: usize, groups: &[Group]) -> Vec<BTreeSet<usize>> {
    let mut others = vec![BTreeSet::new(); parameters];
    for group in groups {
        let members: Vec<usize> = group.with.iter().chain([&group.held]).copied().collect();
        for &i in &members {
            let listed = if members.len() <= LISTED || i == group.held { &members } else { &vec![group.held] };
            others[i].extend(listed.iter().copied().filter(|&j| j != i));
        }
    }
    others
}

/// Residuals of a quantity in the unit of the document.
pub fn quantity_residuals(found: &ConditionResiduals) -> QuantityResiduals {
    let quantity = if found.kind.is_angle() { Quantity::Angle } else { Quantity::Length };
    QuantityResiduals {
        quantity: match found.kind {
            ReadingKind::Error(kind) => kind.into(),
            ReadingKind::Orientation => ErrorQuantity::Orientation,
            ReadingKind::JointAngle | ReadingKind::JointLength => ErrorQuantity::Joint,
        },
        unit: quantity.unit().to_owned(),
        count: found.count,
        rms: quantity.outward(found.rms),
        standard_uncertainty: quantity.outward(found.standard_uncertainty),
    }
}

/// Known lengths and positions, with their residuals at all parameters.
fn known_values(robot: &dyn Robot, settings: &Settings, values: &[f64]) -> Vec<KnownValue> {
    let parameter = |i: &usize| robot.parameters()[*i].name.as_str();
    // first parameter of a point or of a surface
    let element = |i: &usize| {
        let (name, suffix) = parameter(i).rsplit_once('_').unwrap_or((parameter(i), ""));
        let is_axis = ["x", "y", "z"].contains(&suffix);
        if is_axis { name.trim_end_matches("_slope").to_owned() } else { parameter(i).to_owned() }
    };
    let of_known = |known: &Known| {
        let quantity = match known {
            Known::Place { .. } | Known::Seen { .. } => ErrorQuantity::Coordinate,
            Known::Distance { .. } | Known::Length { .. } => ErrorQuantity::Distance,
            Known::On { .. } => ErrorQuantity::Surface,
        };
        let value = move |row: KnownResidual| KnownValue {
            name: match (&row.parameters[..], quantity) {
                ([one], ErrorQuantity::Coordinate | ErrorQuantity::Distance) => parameter(one).to_owned(),
                (elements, _) => elements.iter().map(element).collect::<Vec<_>>().join(" – "),
            },
            place_mm: row.place_mm,
            quantity,
            stated_mm: row.stated_mm,
            standard_uncertainty_mm: row.standard_uncertainty_mm,
            residual_mm: row.residual_mm,
        };
        known.stated(values).into_iter().map(value)
    };
    let of_parts = settings.rigid.iter().flat_map(|part| part_distances(robot, part, values));
    settings.known.iter().flat_map(of_known).chain(of_parts).collect()
}

/// Distances of the targets of a rigid part by its stated shape.
fn part_distances(robot: &dyn Robot, part: &RigidPart, values: &[f64]) -> Vec<KnownValue> {
    let mut joints = vec![0.0; robot.joints().len()];
    joints.extend(robot.has_assembly_modes().then_some(1.0));
    let place = |(name, stated_mm): (&String, &Vector)| {
        let target = robot.targets().iter().position(|target| target == name)?;
        Some((name.clone(), *stated_mm, robot.position(values, &joints, target)))
    };
    let places: Vec<(String, Vector, Vector)> =
        part.targets.iter().zip(&part.places_mm).filter_map(place).filter(|at| norm(at.2).is_finite()).collect();
    let pairs = (0..places.len()).flat_map(|i| (i + 1..places.len()).map(move |k| (i, k)));
    let value = |(i, k): (usize, usize)| {
        let (from, to) = (&places[i], &places[k]);
        let stated_mm = norm(minus(to.1, from.1));
        KnownValue {
            name: format!("{} – {}", from.0, to.0),
            place_mm: None,
            quantity: ErrorQuantity::Distance,
            stated_mm: Some(stated_mm),
            standard_uncertainty_mm: 2f64.sqrt() * part.standard_uncertainty_mm,
            residual_mm: norm(minus(to.2, from.2)) - stated_mm,
        }
    };
    pairs.map(value).collect()
}

/// Growth of the errors beyond the measured values of a joint, in the units of its column.
fn joint_extrapolation(robot: &dyn Robot, found: &Extrapolation) -> JointExtrapolation {
    let joint = &robot.joints()[found.joint];
    let [low, high] = found.range.map(|value| joint.quantity.outward(value));
    JointExtrapolation {
        joint: joint.column(),
        low,
        high,
        distance: joint.quantity.outward(found.distance),
        position: found.position,
        orientation: found.orientation,
    }
}

/// Test of the residuals against the stated uncertainty and against repeats.
fn residual_test(settings: &Settings, found: &Identification) -> ResidualTest {
    let rejected = |chi_square| etalon_identify::chi_square_exceeds(chi_square, found.residuals.degrees_of_freedom);
    ResidualTest {
        stated_standard_uncertainty_mm: settings.standard_uncertainty_mm,
        common_standard_uncertainty_mm: settings.common_uncertainty_mm,
        joint_value_standard_uncertainty_deg: joint_value_uncertainty_deg(&settings.conditions),
        stated_values: found.residuals.stated,
        determined_parameters: Some(found.identifiability.determined),
        chi_square: found.residuals.chi_square,
        chi_square_rejected: found.residuals.chi_square.is_some_and(rejected),
        repeats: found.residuals.replicates.map(Into::into),
    }
}

/// Root mean square (deg) of the standard uncertainties of observed values of revolute joints.
fn joint_value_uncertainty_deg(conditions: &[Condition]) -> Option<f64> {
    let of_joints = conditions.iter().filter(|c| matches!(c.kind, Kind::Joint(_)) && c.kind.is_angle());
    let squares: Vec<f64> = of_joints.map(|c| c.standard_uncertainty.to_degrees().powi(2)).collect();
    (!squares.is_empty()).then(|| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
}

/// Creates the document of an identification. `before` holds the values with only base and targets
/// fitted.
pub fn parameters_document(
    robot: &dyn Robot,
    settings: &Settings,
    before: &[f64],
    found: &Identification,
    inputs: &BTreeMap<String, String>,
) -> ParametersDocument {
    let name = |i: &usize| robot.parameters()[*i].name.clone();
    let confounded = confounded(robot.parameters().len(), &found.identifiability.groups);
    let parameters = robot.parameters().iter().enumerate().map(|(i, p)| ParameterEntry {
        name: p.name.clone(),
        unit: p.quantity.unit().to_owned(),
        full_unit: p.full_unit(),
        role: p.role.into(),
        meaning: Some(p.meaning).filter(|id| !id.is_empty()).map_or_else(String::new, |id| Phrase::new(id).to_string()),
        meaning_id: Some(p.meaning.to_owned()).filter(|id| !id.is_empty()),
        nominal: p.quantity.outward(p.nominal),
        tolerance: p.tolerance_is_stated.then(|| p.quantity.outward(p.tolerance)),
        before: p.quantity.outward(before[i]),
        value: p.quantity.outward(found.values[i]),
        standard_uncertainty: found.standard_uncertainty(i).map(|u| p.quantity.outward(u)),
        degrees_of_freedom: found.degrees_of_freedom(i),
        determined: found.determined(robot, i),
        status: match found.status[i] {
            Status::Identified => ParameterStatus::Identified,
            Status::Fixed => ParameterStatus::Fixed,
            Status::NotIdentifiable => ParameterStatus::NotIdentifiable,
        },
        confounded_with: confounded[i].iter().map(name).collect(),
    });
    let positions_alone = settings.kind == etalon_identify::ResidualKind::Targets && settings.conditions.is_empty();
    let n = found.free.len();
    let factor = |k: usize| robot.parameters()[found.free[k]].quantity.outward(1.0);
    let written: Vec<usize> = (0..n).filter(|&k| !found.identifiability.eliminated.contains(&found.free[k])).collect();
    let outward = |c: &Vec<f64>| {
        let row = |&i: &usize| written.iter().map(|&j| c[i * n + j] * factor(i) * factor(j)).collect();
        written.iter().map(row).collect()
    };
    let covariance = found.uncertainty.covariance.as_ref().map(outward).unwrap_or_default();
    ParametersDocument {
        schema: ParametersDocument::SCHEMA.to_owned(),
        robot: robot.model().to_owned(),
        valid_until: None,
        synthetic: None,
        links: None,
        parameters: parameters.collect(),
        reference_temperature_c: robot.reference_temperature_c(),
        reference_poses: ReferencePose::all(robot),
        sketches: robot.sketches(),
        covariance,
        covariance_without: found.identifiability.eliminated.iter().map(name).collect(),
        budget: budget(robot, found, &written, &factor),
        residuals: ResidualSummary {
            kind: settings.kind.into(),
            count: found.residuals.count,
            rms: found.residuals.rms,
            position: PositionResiduals {
                position_rms_mm: positions_alone.then(|| (robot.dimension() as f64).sqrt() * found.residuals.rms),
                coordinates: found.residuals.coordinates.as_ref().map(quantity_residuals),
                extrapolation: found.residuals.extrapolations.iter().map(|e| joint_extrapolation(robot, e)).collect(),
                ..PositionResiduals::default()
            },
            max: found.residuals.max,
            degrees_of_freedom: found.residuals.degrees_of_freedom,
            effective_degrees_of_freedom: Some(found.residuals.effective_degrees),
            test: residual_test(settings, found),
            uncertainties_from: found.uncertainty.from.into(),
            uncertainties_enlarged_by: found.uncertainty.inflation_factor,
            conditions: found.residuals.conditions.iter().map(quantity_residuals).collect(),
            between_series: found.residuals.between_series.map(|b| SeriesScatter { series: b.series, share: b.share }),
        },
        known: known_values(robot, settings, &found.values),
        reliability: None,
        robust: None,
        observability: found.identifiability.observability.as_ref().map(|o| observability_summary(robot, o)),
        solver: SolverSummary {
            method: solver_method().into(),
            iterations: found.iterations,
            termination: found.termination.into(),
            meaning: found.termination.to_string(),
        },
        untested: Vec::new(),
        messages: warning_messages(&found.warnings),
        provenance: Provenance { version: env!("CARGO_PKG_VERSION").to_owned(), inputs: inputs.clone(), seed: None },
    }
}

/// Lists the mistakes of the set-up that the data do not show.
pub fn untested_mistakes(untested: &[Untested]) -> Vec<UntestedMistake> {
    let mistake = |untested: &Untested| UntestedMistake {
        change: untested.change.clone().into(),
        stated_mm: untested.residuals_mm[0],
        changed_mm: untested.residuals_mm[1],
        flange_mm: untested.differs.0,
        flange_deg: untested.differs.1.to_degrees(),
    };
    untested.iter().map(mistake).collect()
}

/// Algorithm of the identification.
fn solver_method() -> Phrase {
    phrase!("method-levenberg-marquardt")
}

/// Converts warnings of an identification to messages that name keys of a campaign.
pub fn warning_messages(warnings: &[Warning]) -> Vec<Message> {
    warnings.iter().map(warning_message).collect()
}

/// Converts a warning or an error to a message that names keys of a campaign.
pub fn warning_message(warning: &Warning) -> Message {
    match &warning.subject {
        Subject::HeldByFrames => warning.message.clone().hint(phrase!("hold-another")),
        Subject::Shape(contradicted) => contradicted_places(contradicted),
        Subject::SetUp(found) => {
            let hint = set_up_phrase(found);
            warning.message.clone().hint(hint)
        }
        Subject::Other => warning.message.clone(),
    }
}

/// English hint at the change of the set-up, with its keys.
pub fn set_up_hint(found: &SetUpError) -> String {
    set_up_phrase(found).to_string()
}

/// Hint at the change of the set-up, with its keys.
pub fn set_up_phrase(found: &SetUpError) -> Phrase {
    found.to_check(|origin| match origin {
        Origin::Unit => Some(phrase!("set-up-origin", origin = "unit")),
        Origin::WorldFrame => Some(phrase!("set-up-origin", origin = "world-frame")),
        Origin::Named => None,
    })
}

/// Message that a measurement contradicts the given positions on a rigid part.
pub fn contradicted_places(contradicted: &Contradicted) -> Message {
    contradicted.message("[[rigid]]: `places_mm`").hint(phrase!("check-rigid-part"))
}

/// Contribution of each source to the standard uncertainties of the `written` parameters, in their
/// units.
fn budget(
    robot: &dyn Robot,
    found: &Identification,
    written: &[usize],
    factor: &dyn Fn(usize) -> f64,
) -> Vec<BudgetSource> {
    let mut by_source: BTreeMap<UncertaintySource, Vec<f64>> = BTreeMap::new();
    for (row, &k) in written.iter().enumerate().filter(|_| found.uncertainty.covariance.is_some()) {
        for (source, variance) in found.uncertainty.budget.parameter_contributions(k) {
            by_source.entry(source.into()).or_insert_with(|| vec![0.0; written.len()])[row] =
                variance.sqrt() * factor(k);
        }
    }
    let nominal = |source| match (source, found.prior) {
        (UncertaintySource::NominalValues, Prior::Tolerances { scale, .. }) => {
            let of = |&k: &usize| Some(found.prior.uncertainty(robot, found.free[k])? * factor(k));
            let standard_uncertainties = written.iter().map(of).collect();
            Some(NominalUncertainties { standard_uncertainties, tolerance_factor: scale })
        }
        _ => None,
    };
    let entry =
        |(source, standard_uncertainties)| BudgetSource { source, standard_uncertainties, nominal: nominal(source) };
    by_source.into_iter().map(entry).collect()
}

/// Summarises observability: indices with their scaling, and singular values with the names of
/// their parameters.
pub fn observability_summary(robot: &dyn Robot, o: &Observability) -> ObservabilitySummary {
    let [o1, o2, o3, o4, o5] = o.indices;
    let named = |s: &SingularValue| SingularValueEntry {
        value: s.value,
        parameters: s.parameters.iter().map(|&i| robot.parameters()[i].name.clone()).collect(),
    };
    let known = o.rank - o.eliminated;
    let scaling = match o.eliminated {
        0 => phrase!("observability-scaling"),
        coordinates => phrase!("observability-scaling-eliminated", parameters = known, coordinates),
    };
    ObservabilitySummary {
        o1,
        o2,
        o3,
        o4,
        o5,
        condition: o.condition,
        rank: o.rank,
        scaling: scaling.into(),
        singular_values: o.singular_values.iter().map(named).collect(),
        held_singular_values: o.held_singular_values.iter().map(named).collect(),
        rank_cut: RANK_TOLERANCE,
    }
}

impl ParametersDocument {
    /// `true` if no message is an error, so that the parameters may be loaded into a controller.
    pub fn is_plausible(&self) -> bool {
        self.messages.iter().all(|m| m.severity != Severity::Error)
    }
}

impl ImportDocument {
    /// SHA-256 of every input of the results, by file name.
    pub fn inputs(&self) -> BTreeMap<String, String> {
        let sha256 = |s: &Source| s.sha256_without_backup.as_ref().unwrap_or(&s.sha256).clone();
        let inputs = self.sources.iter().filter(|s| s.kind != SourceKind::Backup);
        inputs.map(|s| (s.file.clone(), sha256(s))).collect()
    }
}
