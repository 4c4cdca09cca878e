//! Sweeps of one joint at a time: from a table to axes, and a robot without a nominal model.

use super::table_file::TableFile;
use crate::stages::uncertainty::bounds::beyond_bound;
use etalon_base::message::{Message, Place, Problems, Result, Severity};
use etalon_base::pose::{Pose, Vector};
use etalon_base::{error, phrase, warning};
use etalon_campaign::{RobotHead, screws_text, table_text};
use etalon_documents::{
    AxesCheck, AxesDocument, AxesParameter, AxesRobot, AxesTarget, AxisEntry, AxisErrorMotion, AxisLine, AxisMotion,
    AxisPath, MotionByNoise, Provenance, ZeroAxis,
};
use etalon_formats::table::XYZ;
use etalon_identify::axes::{
    Agreement, AxesModel, AxesSettings, BaseRule, ByNoise, Change, DerivedParameters, JointAxis, Slip, Sweep,
    SweepFault, SweepReading, axis_slip, compared, joint_axis, joint_slip, start_gap,
};
use etalon_identify::{ASSUMED_MM, Extent, UncertaintyBound};
use etalon_robots::{AxisTable, Joint, Parameter, Quantity, Role};
use std::collections::BTreeMap;
use std::f64::consts::SQRT_2;

/// Convention of the robot file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TableConvention {
    /// Screw axes in the base at zero joints: represents every arm exactly.
    #[default]
    Poe,
    /// Modified Denavit-Hartenberg parameters (Craig).
    Mdh,
    /// Standard Denavit-Hartenberg parameters.
    Dh,
}

impl TableConvention {
    /// Name in the robot file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Poe => "poe",
            Self::Mdh => "mdh",
            Self::Dh => "dh",
        }
    }

    /// Convention of the table; `None` for screw axes.
    fn table_convention(self) -> Option<etalon_robots::TableConvention> {
        match self {
            Self::Poe => None,
            Self::Mdh => Some(etalon_robots::TableConvention::Modified),
            Self::Dh => Some(etalon_robots::TableConvention::Standard),
        }
    }
}

/// Data of the user that the table does not contain.
#[derive(Clone, Debug, Default)]
pub(crate) struct SweepsStated {
    /// Joints from the base; by default in the order of their numbers.
    pub joints: Vec<String>,
    /// Joints that slide.
    pub prismatic: Vec<String>,
    /// Joints that were swept in the negative direction.
    pub backwards: Vec<String>,
    /// Standard uncertainty of a coordinate (mm).
    pub standard_uncertainty_mm: Option<f64>,
    /// Convention of the robot file.
    pub convention: TableConvention,
    /// Source of the column `x_mm` in the file; by default its name.
    pub source_of_x: Option<String>,
    /// `true` if the robot is written in spite of errors.
    pub force: bool,
    /// Given bound of the uncertainties of the axes.
    pub bound: UncertaintyBound,
}

/// Uncertainty of a direction (rad) above which predictions are of little use.
const WEAK_RAD: f64 = 1e-3;
/// Radius (mm) below which all paths indicate another unit.
const SMALL_MM: f64 = 5.0;
/// Difference of first readings, in standard uncertainties, beyond which sweeps do not start from
/// one pose.
const APART: f64 = 6.0;
/// Disagreement (standard uncertainties) that is reported.
const DISAGREE: f64 = 5.0;

/// Sweeps of a table, with the names of joints and targets.
struct SweepTable {
    joints: Vec<String>,
    targets: Vec<String>,
    sweeps: Vec<Sweep>,
    checks: Vec<SweepReading>,
    prismatic: Vec<Option<bool>>,
}

/// Prefix and number of a name such as `q3`.
fn numbered(name: &str) -> Option<(&str, usize)> {
    let digits = name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    Some((&name[..digits], name[digits..].parse().ok()?))
}

/// Names of the joints from the base.
fn joint_names(table: &TableFile, swept: &[String], stated: &SweepsStated) -> Result<Vec<String>> {
    let mut names: Vec<String> = Vec::new();
    for name in swept.iter().filter(|name| !name.is_empty()) {
        if !names.contains(name) {
            names.push(name.clone());
        }
    }
    if !stated.joints.is_empty() {
        let unknown = names.iter().find(|name| !stated.joints.contains(name));
        return match unknown {
            Some(joint) => Err(error!("sweep-joint-unknown", joint, known = stated.joints.join(", ")).into()),
            None => Ok(stated.joints.clone()),
        };
    }
    let Some(prefix) = names.first().and_then(|name| Some(numbered(name)?.0.to_owned())) else {
        return Err(error!("sweep-order-missing", joints = names.join(", ")).into());
    };
    // joints with a column of values and without a sweep are joints too
    let columns = table.table.names().filter_map(|c| c.rsplit_once('_')).map(|(name, _)| name);
    let more: Vec<&str> = columns.filter(|name| numbered(name).is_some_and(|(p, _)| p == prefix)).collect();
    for name in more {
        if !names.iter().any(|known| known == name) {
            names.push(name.to_owned());
        }
    }
    if !names.iter().all(|name| numbered(name).is_some_and(|(p, _)| p == prefix)) {
        return Err(error!("sweep-order-missing", joints = names.join(", ")).into());
    }
    names.sort_by_key(|name| numbered(name).map(|(_, number)| number));
    Ok(names)
}

/// Values of a joint (rad or mm) and its kind by the unit of its column; `None` without a column.
fn joint_values(table: &TableFile, name: &str) -> Result<Option<(Vec<f64>, bool)>> {
    let mut found: Option<(Vec<f64>, bool)> = None;
    for quantity in [Quantity::Angle, Quantity::Length] {
        let joint = Joint { name: name.to_owned(), quantity };
        for column in table.table.names() {
            let Some(factor) = joint.factor(column) else { continue };
            if found.is_some() {
                return Err(error!("sweep-joint-column-twice", joint = name).into());
            }
            let values = table.table.numbers(column)?.into_iter().map(|v| v * factor).collect();
            found = Some((values, quantity == Quantity::Length));
        }
    }
    Ok(found)
}

/// Reads the sweeps of a table.
fn read(file: &TableFile, stated: &SweepsStated) -> Result<SweepTable> {
    file.table.require(["joint", XYZ[0], XYZ[1], XYZ[2]])?;
    let swept: Vec<String> = file.table.texts("joint")?.iter().map(|t| t.trim().to_owned()).collect();
    let joints = joint_names(file, &swept, stated)?;
    let has_targets = file.table.has("target");
    let mut targets: Vec<String> = Vec::new();
    let positions = file.table.positions()?;
    let values: Vec<Option<(Vec<f64>, bool)>> =
        joints.iter().map(|joint| joint_values(file, joint)).collect::<Result<_>>()?;
    let mut sweeps: Vec<Sweep> = (0..joints.len()).map(|joint| Sweep { joint, readings: Vec::new() }).collect();
    let (mut checks, mut problems) = (Vec::new(), Problems::default());
    for (i, position_mm) in positions.into_iter().enumerate() {
        let row = file.table.line(i).unwrap_or(i + 1);
        let mut wrong = |message: Message| problems.0.push(message.at(file.table.place(i)));
        if position_mm.iter().any(|v| !v.is_finite()) {
            wrong(error!("table-value-missing"));
            continue;
        }
        let own: Vec<f64> = values.iter().map(|v| v.as_ref().map_or(f64::NAN, |v| v.0[i])).collect();
        let known = own.iter().filter(|v| v.is_finite()).count();
        let complete = known == own.len();
        if !complete && (known > 0 || swept[i].is_empty()) {
            wrong(error!("sweep-values-partial"));
            continue;
        }
        let name = if has_targets { file.table.text(i, "target").unwrap_or_default() } else { "target" };
        let target = targets.iter().position(|t| t == name).unwrap_or_else(|| {
            targets.push(name.to_owned());
            targets.len() - 1
        });
        let reading = SweepReading { row, target, position_mm, joints: if complete { own } else { Vec::new() } };
        match joints.iter().position(|joint| *joint == swept[i]) {
            Some(joint) => sweeps[joint].readings.push(reading),
            None => checks.push(reading),
        }
    }
    problems.check()?;
    let turns = |k: &usize| values[*k].as_ref().is_some_and(|v| !v.1);
    let turning: Vec<usize> = (0..joints.len()).filter(turns).collect();
    sweeps.iter_mut().for_each(|sweep| sweep.unwind(&turning));
    let known = sweeps.iter().flat_map(|s| &s.readings).filter(|r| !r.joints.is_empty()).count();
    if known > 0 && known < sweeps.iter().map(|s| s.readings.len()).sum() {
        return Err(error!("sweep-values-partial").into());
    }
    let prismatic = joints.iter().zip(&values).map(|(joint, values)| {
        let slides = stated.prismatic.contains(joint);
        values.as_ref().map(|v| v.1).or(slides.then_some(true)).or((!stated.prismatic.is_empty()).then_some(false))
    });
    Ok(SweepTable { prismatic: prismatic.collect(), joints, targets, sweeps, checks })
}

/// Axes of all joints of a table, and the robot that follows from them.
pub(crate) fn axes(file: &TableFile, stated: &SweepsStated) -> Result<AxesDocument> {
    let table = read(file, stated).map_err(|problems| file.place(problems))?;
    derive(&table, stated, file).map_err(|problems| file.place(problems))
}

fn derive(table: &SweepTable, stated: &SweepsStated, file: &TableFile) -> Result<AxesDocument> {
    for name in stated.prismatic.iter().chain(&stated.backwards) {
        if !table.joints.contains(name) {
            return Err(error!("sweep-joint-unknown", joint = name, known = table.joints.join(", ")).into());
        }
    }
    let settings = AxesSettings {
        standard_uncertainty_mm: stated.standard_uncertainty_mm,
        prismatic: table.prismatic.clone(),
        backwards: table.joints.iter().map(|joint| stated.backwards.contains(joint)).collect(),
    };
    let (mut messages, mut problems, mut measured) = (Vec::new(), Problems::default(), Vec::new());
    let values = table.sweeps.iter().flat_map(|s| &s.readings).any(|r| !r.joints.is_empty());
    if values && !stated.backwards.is_empty() {
        return Err(error!("sweep-sign-by-values").into());
    }
    for sweep in table.sweeps.iter().filter(|sweep| !sweep.readings.is_empty()) {
        match axis(table, sweep, &settings) {
            Ok((axis, more)) => {
                measured.push(axis);
                messages.extend(more);
            }
            Err(message) => problems.0.push(message),
        }
    }
    problems.check()?;
    let radii = || measured.iter().flat_map(|m: &JointAxis| &m.fit.paths).map(|p| p.radius_mm);
    let largest = radii().fold(0.0, f64::max);
    if largest > 0.0 && largest < SMALL_MM {
        let source = stated.source_of_x.as_deref().unwrap_or(XYZ[0]);
        messages.push(error!("sweep-unit", radius_mm = largest, source));
    }
    messages.extend(measured.iter().filter_map(|axis| beyond_axis_bound(table, stated.bound, axis)));
    let entries = measured.iter().map(|m| entry(table, m)).collect();
    let fit = stated.force || messages.iter().all(|m| m.severity != Severity::Error);
    let (robot, checks) = robot(table, stated, measured, &mut messages)?;
    let robot = robot.filter(|_| fit);
    let inputs = BTreeMap::from([(file.name.clone(), etalon_base::files::sha256(file.text().as_bytes()))]);
    Ok(AxesDocument {
        schema: "etalon/axes/1".to_owned(),
        provenance: Provenance { version: env!("CARGO_PKG_VERSION").to_owned(), inputs, seed: None },
        joint_values: values,
        axes: entries,
        robot,
        checks,
        messages,
    })
}

/// Axis of one sweep, with warnings.
fn axis(
    table: &SweepTable,
    sweep: &Sweep,
    settings: &AxesSettings,
) -> std::result::Result<(JointAxis, Vec<Message>), Message> {
    let joint = &table.joints[sweep.joint];
    if let Some(slip) = joint_slip(sweep) {
        return Err(slip_message(table, sweep.joint, slip));
    }
    let axis = joint_axis(sweep, settings).map_err(|fault| match fault {
        SweepFault::TooFew { needed, readings } => error!("sweep-few", joint, needed, readings),
        SweepFault::Undetermined => error!("sweep-undetermined", joint),
    })?;
    if let Some(slip) = axis_slip(sweep, &axis) {
        return Err(slip_message(table, sweep.joint, slip));
    }
    let mut messages = Vec::new();
    let aside: Vec<String> = set_aside(sweep_rows(sweep, &axis)).iter().map(usize::to_string).collect();
    if !aside.is_empty() {
        messages.push(warning!("sweep-outliers", joint, count = aside.len(), lines = aside.join(", ")));
    }
    if let Some(smooth) = axis.smooth {
        let (rms_um, noise_um) = (1000.0 * smooth.rms_mm, 1000.0 * smooth.noise_mm);
        messages.push(warning!("sweep-smooth", joint, rms_um, noise_um));
    }
    let (of_direction, _) = axis.standard_uncertainties();
    let u_mrad = 1000.0 * of_direction[0].max(of_direction[1]);
    if u_mrad > 1000.0 * WEAK_RAD {
        messages.push(warning!("sweep-weak", joint, u_mrad));
    }
    Ok((axis, messages))
}

/// Error about an axis whose direction or point exceeds its bound, relative to the readings of its
/// sweep.
fn beyond_axis_bound(table: &SweepTable, bound: UncertaintyBound, axis: &JointAxis) -> Option<Message> {
    let joint = &table.joints[axis.joint];
    let points: Vec<Vector> = table.sweeps[axis.joint].readings.iter().map(|r| r.position_mm).collect();
    let u_mm = if axis.standard_uncertainty_mm.is_finite() { axis.standard_uncertainty_mm } else { ASSUMED_MM };
    let extent = Extent::from_points(&points, u_mm);
    let direction = || (phrase!("bound-axis-direction", joint), Quantity::Angle);
    let point = || (phrase!("bound-axis-point", joint), Quantity::Length);
    let components = if axis.fit.prismatic {
        vec![direction(), direction()]
    } else {
        vec![direction(), direction(), point(), point()]
    };
    let n = components.len();
    let covariance: Vec<f64> = (0..n * n).map(|at| axis.covariance[(at / n, at % n)]).collect();
    let case = if axis.fit.prismatic { "travel" } else { "turn" };
    beyond_bound(bound, &extent, &components, &covariance, phrase!("bound-remedy", case))
}

fn sweep_rows<'a>(sweep: &'a Sweep, axis: &'a JointAxis) -> impl Iterator<Item = (usize, bool)> + 'a {
    sweep.readings.iter().zip(&axis.fit.used).map(|(r, used)| (r.row, *used))
}

/// Lines of the readings that are not used.
fn set_aside(rows: impl Iterator<Item = (usize, bool)>) -> Vec<usize> {
    rows.filter(|(_, used)| !used).map(|(row, _)| row).collect()
}

fn slip_message(table: &SweepTable, joint: usize, slip: Slip) -> Message {
    let name = |j: usize| &table.joints[j];
    let joint = name(joint);
    match slip {
        Slip::OtherJoint { moved } => error!("sweep-other-joint", joint, moved = name(moved)),
        Slip::TwoJoints { also, by } => {
            let slides = table.prismatic[also] == Some(true);
            let by =
                if slides { phrase!("sweep-by-length", by) } else { phrase!("sweep-by-angle", by = by.to_degrees()) };
            error!("sweep-two-joints", joint, also = name(also), by)
        }
        Slip::Ratio { ratio, unit } => {
            let (u, ratio) = (ratio.standard_uncertainty, ratio.value);
            error!("sweep-ratio", joint, ratio, u, unit = unit.unwrap_or("none"))
        }
        Slip::TargetMoved { target, row, deviations_mm: [before, after] } => {
            let (before_um, after_um) = (1000.0 * before, 1000.0 * after);
            error!("sweep-target-moved", joint, target = &table.targets[target], row, before_um, after_um)
                .at(Place { line: Some(row), ..Place::default() })
        }
        Slip::Many { aside, readings } => error!("sweep-many-outliers", joint, aside, readings),
    }
}

/// The robot from its axes, and check poses; `None` with the reason among the messages.
fn robot(
    table: &SweepTable,
    stated: &SweepsStated,
    measured: Vec<JointAxis>,
    messages: &mut Vec<Message>,
) -> Result<(Option<AxesRobot>, Vec<AxesCheck>)> {
    let swept: Vec<usize> = measured.iter().map(|m| m.joint).collect();
    let missing: Vec<&str> =
        (0..table.joints.len()).filter(|j| !swept.contains(j)).map(|j| table.joints[j].as_str()).collect();
    if !missing.is_empty() {
        messages.push(warning!("sweep-joint-missing", joints = missing.join(", "), count = missing.len()));
        return Ok((None, Vec::new()));
    }
    let u_mm = measured.iter().map(|m| m.standard_uncertainty_mm).fold(0.0, f64::max);
    let values = measured.iter().all(|m| !m.rest.is_empty());
    if !values
        && let Some((gap_mm, [a, b], target)) = start_gap(&table.sweeps)
        && gap_mm > (APART * SQRT_2 * u_mm).max(1e-6)
    {
        let [first, second] = [a, b].map(|j| &table.joints[j]);
        messages.push(warning!("sweep-starts-apart", first, second, target = &table.targets[target], gap_mm));
        return Ok((None, Vec::new()));
    }
    let Some(model) = AxesModel::new(measured, table.targets.len()) else {
        messages.push(warning!("sweep-target-unswept"));
        return Ok((None, Vec::new()));
    };
    if values {
        let found = model.agreement(&compared(&table.sweeps, &model.measured), u_mm);
        disagreement(table, &found, false, messages)?;
    }
    let found = model.agreement(&table.checks, u_mm);
    disagreement(table, &found, true, messages)?;
    let check = |p: &etalon_identify::axes::CheckedPose| AxesCheck {
        line: p.row,
        target: table.targets[p.target].clone(),
        distance_mm: p.distance_mm,
        standard_uncertainty_mm: p.standard_uncertainty_mm,
    };
    let checks = found.poses.iter().map(check).collect();
    Ok((Some(described(table, stated, &model, messages)), checks))
}

/// Reports sweeps or check poses that contradict the robot.
fn disagreement(table: &SweepTable, found: &Agreement, checks: bool, messages: &mut Vec<Message>) -> Result<()> {
    let ratio = |p: &&etalon_identify::axes::CheckedPose| p.distance_mm / p.standard_uncertainty_mm;
    let Some(worst) = found.poses.iter().max_by(|a, b| ratio(a).total_cmp(&ratio(b))) else { return Ok(()) };
    if found.worst <= DISAGREE {
        return Ok(());
    }
    let place = Place { line: Some(worst.row), ..Place::default() };
    let stated_mm = etalon_math::statistics::rms(found.poses.iter().map(|p| p.distance_mm));
    match &found.explained {
        Some((Change::Exchanged([a, b]), left_mm)) => {
            let [first, second] = [a, b].map(|j| &table.joints[*j]);
            Err(error!("sweeps-exchanged", first, second, stated_mm, left_mm = *left_mm).into())
        }
        Some((Change::Reversed(j), left_mm)) => {
            Err(error!("sweep-reversed", joint = &table.joints[*j], stated_mm, left_mm = *left_mm).into())
        }
        None => {
            let (distance_mm, u_mm) = (worst.distance_mm, worst.standard_uncertainty_mm);
            let what = if checks { "checks" } else { "sweeps" };
            messages.push(warning!("sweeps-disagree", what, distance_mm, u_mm).at(place));
            Ok(())
        }
    }
}

fn rule_name(rule: BaseRule) -> &'static str {
    match rule {
        BaseRule::CommonNormal => "common-normal",
        BaseRule::Meeting => "meeting",
        BaseRule::Parallel => "parallel",
        BaseRule::Sliding => "sliding",
        BaseRule::Target => "target",
    }
}

/// Warnings of a base and a flange that a table cannot hold.
pub(crate) fn not_held(table: &AxisTable) -> Vec<Message> {
    let mut messages = Vec::new();
    for (id, pose) in [(true, &table.base), (false, &table.flange)] {
        let (angle_deg, shift_mm) = (pose.angle_rad().to_degrees(), etalon_base::pose::norm(pose.translation_mm));
        if angle_deg > 1e-9 || shift_mm > 1e-9 {
            messages.push(match id {
                true => warning!("table-base-not-held", angle_deg, shift_mm),
                false => warning!("table-flange-not-held", angle_deg, shift_mm),
            });
        }
    }
    messages
}

/// Warnings of the angles between axes that a table cannot hold.
fn tilts_not_held<'a>(table: &'a AxisTable, joints: &'a [String]) -> impl Iterator<Item = Message> + 'a {
    table.tilts.iter().map(|tilt| {
        let joint = joints.get(tilt.row).map_or("none", String::as_str);
        warning!("table-tilt-not-held", joint, angle_mrad = 1000.0 * tilt.angle_rad)
    })
}

/// The robot as a document, with its robot.toml.
fn described(table: &SweepTable, stated: &SweepsStated, model: &AxesModel, messages: &mut Vec<Message>) -> AxesRobot {
    let mut comments = vec![
        phrase!("axes-comment-method").to_string(),
        phrase!("axes-comment-base", rule = rule_name(model.rule)).to_string(),
    ];
    let renamed = (1..).zip(&table.joints).filter(|(i, name)| **name != format!("q{i}"));
    comments.extend(renamed.map(|(number, name)| phrase!("axes-comment-joint", number, name).to_string()));
    if model.measured.iter().any(|m| m.rest.is_empty()) {
        comments.push(phrase!("axes-comment-zero").to_string());
    }
    let convention = stated.convention.table_convention();
    let rows = convention.map(|convention| convention.table(&model.axes, &model.flange));
    // base and flange are free; a table may have its own
    let (base, flange) = rows.as_ref().map_or((Pose::identity(), Pose::identity()), |rows| (rows.base, rows.flange));
    let into_base = base.inverse();
    let world_T_base = model.world_T_base.then(&base);
    let base_T_flange = into_base.then(&model.flange).then(&flange.inverse());
    let targets_mm: Vec<Vector> = model.targets_mm.iter().map(|at| flange.apply(*at)).collect();
    for (name, at) in table.targets.iter().zip(&targets_mm) {
        let [x, y, z] = *at;
        comments.push(phrase!("axes-comment-target", name, x, y, z).to_string());
    }
    let name = phrase!("axes-robot-name").to_string();
    let head = RobotHead { name: &name, comments: &comments, limits: &[] };
    let robot_toml = match convention.zip(rows.as_ref()) {
        None => screws_text(head, &model.axes, &model.flange),
        Some((convention, rows)) => {
            messages.extend(tilts_not_held(rows, &table.joints));
            table_text(head, convention, rows)
        }
    };
    let derived = match convention {
        None => Some(model.screw_parameters()),
        Some(convention) => model.table_parameters(convention),
    };
    let (parameters, covariance) = derived.map(parameters).unwrap_or_default();
    let robot_toml = robot_toml + &tolerances(&parameters);
    let zero = model.axes.iter().zip(&model.uncertainties).zip(&table.joints).map(|((axis, u), joint)| ZeroAxis {
        joint: joint.clone(),
        direction: into_base.rotate(axis.direction),
        point_mm: (!axis.prismatic).then(|| into_base.apply(axis.point_mm)),
        direction_standard_uncertainty_deg: u[0].to_degrees(),
        point_standard_uncertainty_mm: (!axis.prismatic).then_some(u[1]),
    });
    let targets = table.targets.iter().zip(&targets_mm).zip(&model.target_uncertainties_mm);
    AxesRobot {
        base_rule: rule_name(model.rule).to_owned(),
        base_xyz_mm: world_T_base.translation_mm,
        base_quaternion: world_T_base.quaternion(),
        axes: zero.collect(),
        flange_xyz_mm: base_T_flange.translation_mm,
        flange_quaternion: base_T_flange.quaternion(),
        targets: targets
            .map(|((target, xyz), u)| AxesTarget { target: target.clone(), xyz_mm: *xyz, standard_uncertainty_mm: *u })
            .collect(),
        convention: stated.convention.name().to_owned(),
        parameters,
        covariance,
        robot_toml,
    }
}

/// Minimum prior standard uncertainty of a parameter, in standard uncertainties from the sweeps:
/// error alone exceeds a tolerance of 4.3 of them once in 50 000 parameters.
const LEAST_PRIOR: f64 = 2.5;

/// Tolerance (mm, deg) of parameters that a convention fixes. Of parameters that poses cannot
/// separate, a run holds those with the smallest tolerances.
const FIXED: f64 = 1e-6;

/// Parameters of the robot, and their covariance.
fn parameters(found: DerivedParameters) -> (Vec<AxesParameter>, Vec<Vec<f64>>) {
    let factor: Vec<f64> = found.quantities.iter().map(|quantity| quantity.outward(1.0)).collect();
    let of = |(k, s): (usize, f64)| {
        let u = found.covariance[(k, k)].sqrt();
        let half_width = 3f64.sqrt() * s.max(LEAST_PRIOR * u);
        let usual = Parameter::new(found.names[k].clone(), found.quantities[k], Role::Robot, 0.0).tolerance;
        AxesParameter {
            name: found.names[k].clone(),
            unit: found.quantities[k].unit().to_owned(),
            value: factor[k] * found.values[k],
            standard_uncertainty: factor[k] * u,
            tolerance: (half_width < usual).then_some(factor[k] * half_width),
        }
    };
    let fixed = found.fixed.iter().map(|(name, quantity, value)| AxesParameter {
        name: name.clone(),
        unit: quantity.unit().to_owned(),
        value: quantity.outward(*value),
        standard_uncertainty: 0.0,
        tolerance: Some(FIXED),
    });
    let known = found.independent_uncertainties().into_iter().enumerate().map(of);
    let parameters = known.chain(fixed).collect();
    let row = |i: usize| (0..factor.len()).map(|j| factor[i] * factor[j] * found.covariance[(i, j)]).collect();
    (parameters, (0..factor.len()).map(row).collect())
}

/// Table `tolerance` of robot.toml, with two digits that are rounded up.
fn tolerances(parameters: &[AxesParameter]) -> String {
    let stated = parameters.iter().filter_map(|p| Some((&p.name, p.tolerance?)));
    let line = |(name, tolerance): (&String, f64)| {
        let digit = 10f64.powf(tolerance.log10().floor() - 1.0);
        let decimals = (1.0 - tolerance.log10().floor()).max(0.0) as usize;
        format!("{name} = {:.decimals$}\n", (tolerance / digit).ceil() * digit)
    };
    let lines: String = stated.map(line).collect();
    match lines.is_empty() {
        true => lines,
        false => format!("\n# {}\n[tolerance]\n{lines}", phrase!("axes-comment-tolerance")),
    }
}

fn by_noise(noise: ByNoise, factor: f64) -> MotionByNoise {
    MotionByNoise { expected: factor * noise.expected, standard_uncertainty: factor * noise.deviation }
}

fn entry(table: &SweepTable, axis: &JointAxis) -> AxisEntry {
    let sweep = &table.sweeps[axis.joint];
    let (of_direction, of_point) = axis.standard_uncertainties();
    let slides = axis.fit.prismatic;
    let own = axis.fit.axis();
    let path = |(i, path): (usize, &etalon_identify::axes::Path)| AxisPath {
        target: table.targets[path.target].clone(),
        readings: path.readings,
        radius_mm: (!slides).then_some(path.radius_mm),
        radius_standard_uncertainty_mm: (!slides).then(|| axis.radius_uncertainty_mm(i)),
        height_mm: (!slides).then_some(path.height_mm),
        arc_deg: (!slides).then(|| path.span.to_degrees()),
        length_mm: slides.then_some(path.span),
        radial_error_motion_mm: axis.error_motion.radial_mm[i],
        face_error_motion_mm: axis.error_motion.face_mm[i],
        by_noise: axis.error_motion.noise.paths.get(i).map(|noise| by_noise(*noise, 1.0)),
    };
    AxisEntry {
        joint: table.joints[axis.joint].clone(),
        prismatic: slides,
        readings: sweep.readings.len(),
        set_aside: set_aside(sweep_rows(sweep, axis)),
        line: AxisLine {
            direction: own.direction,
            point_mm: own.point_mm,
            covariance: axis.point_direction_covariance(),
            direction_standard_uncertainty_deg: of_direction[0].max(of_direction[1]).to_degrees(),
            point_standard_uncertainty_mm: (!slides).then(|| of_point[0].max(of_point[1])),
        },
        coordinate_standard_uncertainty_mm: axis.standard_uncertainty_mm,
        degrees_of_freedom: axis.degrees_of_freedom.is_finite().then_some(axis.degrees_of_freedom as usize),
        paths: axis.fit.paths.iter().enumerate().map(path).collect(),
        error_motion: AxisErrorMotion {
            axial_error_motion_mm: axis.error_motion.axial_mm,
            tilt_error_motion_deg: axis.error_motion.tilt_rad.map(f64::to_degrees),
            axial_by_noise: axis.error_motion.noise.axial.map(|noise| by_noise(noise, 1.0)),
            tilt_by_noise: axis.error_motion.noise.tilt.map(|noise| by_noise(noise, 1f64.to_degrees())),
        },
        motion: AxisMotion {
            ratio: axis.travel.map(|t| t.ratio.value),
            ratio_standard_uncertainty: axis.travel.map(|t| t.ratio.standard_uncertainty),
            motion_rms: axis.travel.map(|t| if slides { t.rms } else { t.rms.to_degrees() }),
        },
    }
}
