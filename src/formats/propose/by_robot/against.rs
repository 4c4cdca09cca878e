//! Correction of a proposal by the nominal robot: joints, units, targets, and commanded points.

use crate::propose::kinematics::{FEWEST, Origin, Outcome, Reading, Sample, confirmed, test};
use crate::propose::meaning::{Evidence, Interpretation, Meaning, PointSet, part_of_arm};
use crate::propose::table::{Column, Table, heading_without_unit, joint_columns};
use crate::propose::turned;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::FormatsDocument;
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Remarks of the test on the proposal.
#[derive(Debug, Default)]
pub(crate) struct Remarks {
    pub reasons: Vec<Phrase>,
    pub doubts: Vec<Phrase>,
    /// `true` if the robot's names of its joints name the columns.
    pub joints_named: bool,
    /// Largest residual (mm) of points that the nominal robot reproduces.
    pub reproduced_mm: Option<f64>,
}

impl Remarks {
    /// Adds the remarks to the document of a proposal.
    pub fn add_to(self, document: &mut FormatsDocument) {
        (document.facts.joints_named, document.facts.reproduced_mm) = (self.joints_named, self.reproduced_mm);
        self.reasons.into_iter().for_each(|reason| document.because(reason));
        self.doubts.into_iter().for_each(|doubt| document.doubt(doubt));
    }
}

/// Maximum number of targets in a column of targets.
const TARGETS: usize = 12;
/// Factor by which a column of targets has to reduce the residual.
const BETTER: f64 = 5.0;

/// Joints, coordinates and target column that are tried together.
#[derive(Clone)]
struct Trial {
    joints: Vec<usize>,
    points: [usize; 3],
    target: Option<usize>,
}

/// Tests the interpretation against the nominal robot. Corrects it if the kinematics of the robot
/// support another interpretation.
pub(crate) fn correct(robot: &dyn Robot, table: &mut Table, found: &mut Interpretation) -> Remarks {
    if !robot.branches().is_empty() {
        return name_by_headings(robot, table, found);
    }
    let mut remarks = Remarks::default();
    if robot.free_base().is_none() {
        remarks.doubts.push(phrase!("robot-does-not-test", model = robot.model()));
        return remarks;
    }
    let Some((trial, outcome)) = outcome(robot, table, found) else { return remarks };
    let named = |points: [usize; 3]| points.map(|at| table.called(at)).join(", ");
    match outcome {
        Outcome::Untested => remarks.doubts.push(phrase!("robot-not-tested", fewest = FEWEST)),
        Outcome::Contradicted(best) => {
            let known = if best.is_some() { "yes" } else { "no" };
            let rms_mm = best.unwrap_or(0.0);
            remarks.doubts.push(phrase!("robot-contradicts", points = named(trial.points), known, rms_mm));
        }
        Outcome::Reproduced(reading) => remarks = apply(robot, &trial, &reading, table, found),
        Outcome::Ambiguous(reading, other) => {
            let differs =
                |k: &usize| reading.order[*k] != other.order[*k] || reading.reversed[*k] != other.reversed[*k];
            let joints: Vec<String> =
                (0..reading.order.len()).filter(differs).map(|k| robot.joints()[k].name.clone()).collect();
            let doubt = match joints.is_empty() {
                true => phrase!("robot-units-ambiguous", rms_mm = other.rms_mm),
                false => phrase!("robot-ambiguous", joints, rms_mm = other.rms_mm),
            };
            remarks = apply(robot, &trial, &reading, table, found);
            remarks.doubts.insert(0, doubt);
        }
    }
    remarks
}

/// Takes the columns that are headed by all joints of a robot with several branches. The chains of
/// its targets were tested when the branches were found.
fn name_by_headings(robot: &dyn Robot, table: &Table, found: &mut Interpretation) -> Remarks {
    let mut remarks = Remarks::default();
    let Some(columns) = joint_columns(robot, table) else { return remarks };
    for taken in &mut found.taken {
        if matches!(taken.meaning, Meaning::Joint(_)) {
            taken.meaning = Meaning::Unknown;
        }
    }
    for (k, at) in columns.into_iter().enumerate() {
        found.take(at, Meaning::Joint(k), phrase!("because-joints-named"));
    }
    found.joint_names = robot.joints().iter().map(|joint| joint.name.clone()).collect();
    found.settle(Evidence::JointOrder);
    remarks.reasons.push(phrase!("because-joints-named"));
    remarks.joints_named = true;
    remarks
}

/// Returns the first trial that the robot reproduces, or the outcome of the first trial.
fn outcome(robot: &dyn Robot, table: &Table, found: &Interpretation) -> Option<(Trial, Outcome)> {
    let trials = trials(robot, table, found);
    let supported = |outcome: &Outcome| matches!(outcome, Outcome::Reproduced(_) | Outcome::Ambiguous(..));
    let plainly = |trial: &&Trial| sample(table, trial).is_some_and(|sample| supported(&test(robot, &sample, false)));
    // of many pairs of columns the first that fits as it is; otherwise the first two
    let chosen = if trials.len() > 2 { trials.iter().find(plainly) } else { None };
    let tried: Vec<&Trial> = chosen.map_or_else(|| trials.iter().take(2).collect(), |trial| vec![trial]);
    let mut first: Option<(Trial, Outcome)> = None;
    for trial in tried {
        let Some(sample) = sample(table, trial) else { continue };
        let mut outcome = test(robot, &sample, true);
        if !supported(&outcome) && sample.stated.iter().any(Option::is_some) {
            // headings may give units that the values do not have
            let free = Sample { stated: vec![None; sample.stated.len()], ..sample };
            outcome = test(robot, &free, true);
        }
        if supported(&outcome) {
            return Some(with_targets(robot, table, found, trial.clone(), outcome));
        }
        first = first.or_else(|| Some((trial.clone(), outcome)));
    }
    let (trial, outcome) = first?;
    Some(with_targets(robot, table, found, trial, outcome))
}

/// Tries columns of targets where one target does not explain the rows.
fn with_targets(
    robot: &dyn Robot,
    table: &Table,
    found: &Interpretation,
    trial: Trial,
    outcome: Outcome,
) -> (Trial, Outcome) {
    let rms = |outcome: &Outcome| match outcome {
        Outcome::Reproduced(reading) | Outcome::Ambiguous(reading, _) => reading.rms_mm,
        Outcome::Contradicted(_) | Outcome::Untested => f64::INFINITY,
    };
    if trial.target.is_some() || rms(&outcome) < 1.0 {
        return (trial, outcome);
    }
    let taken = |at: usize| trial.joints.contains(&at) || trial.points.contains(&at);
    let free = |at: usize| {
        matches!(
            found.taken[at].meaning,
            Meaning::Unknown | Meaning::Text | Meaning::Label | Meaning::Cycle | Meaning::Count
        )
    };
    let candidates =
        (0..table.columns.len()).filter(|at| !taken(*at) && free(*at) && groups(&table.columns[*at]).is_some());
    let mut best = (trial.clone(), outcome);
    for at in candidates.take(3) {
        let trial = Trial { target: Some(at), ..trial.clone() };
        let Some(sample) = sample(table, &trial) else { continue };
        let outcome = test(robot, &sample, true);
        if rms(&outcome) * BETTER < rms(&best.1) {
            best = (trial, outcome);
        }
    }
    best
}

/// Returns the number of the target of each row, if a column has few values that each occur often.
fn groups(column: &Column) -> Option<Vec<usize>> {
    let groups: Vec<usize> = if column.is_numeric() {
        if !column.is_whole() {
            return None;
        }
        let mut values: Vec<i64> = column.numbers().map(|v| v as i64).collect();
        values.sort_unstable();
        values.dedup();
        let of = |v: &f64| values.binary_search(&(*v as i64)).unwrap_or(TARGETS);
        column.values.iter().map(of).collect()
    } else {
        let mut known: Vec<&str> = Vec::new();
        let mut groups = Vec::with_capacity(column.cells.len());
        for cell in &column.cells {
            let at = known.iter().position(|known| **known == **cell).unwrap_or(known.len());
            if at == known.len() {
                known.push(cell);
            }
            if at > TARGETS {
                return None;
            }
            groups.push(at);
        }
        groups
    };
    let count = groups.iter().max()? + 1;
    let often = |group: usize| groups.iter().filter(|at| **at == group).count() >= 6;
    ((2..=TARGETS).contains(&count) && (0..count).all(often)).then_some(groups)
}

/// Returns each run of this number of columns with numbers.
fn consecutive(table: &Table, count: usize) -> Vec<Vec<usize>> {
    let numeric: Vec<usize> = (0..table.columns.len()).filter(|i| table.columns[*i].is_numeric()).collect();
    numeric.windows(count.max(1)).map(<[usize]>::to_vec).collect()
}

/// Returns the columns that may be the joints of the robot: the columns with their headings, or
/// runs of columns without another meaning if these are too few.
pub(crate) fn joint_lists(robot: &dyn Robot, table: &Table, found: &Interpretation) -> Vec<Vec<usize>> {
    let count = robot.joints().len();
    let named = table.columns.iter().any(|column| column.name.is_some());
    let joints = found.joint_columns();
    let is_open = |i: &usize| matches!(found.taken[*i].meaning, Meaning::Unknown | Meaning::Joint(_));
    match joints.len() >= count {
        true => vec![joints],
        false if named => consecutive(table, count).into_iter().filter(|all| all.iter().all(&is_open)).collect(),
        false => consecutive(table, count),
    }
}

/// Returns the joints and points to try, the proposed ones first.
fn trials(robot: &dyn Robot, table: &Table, found: &Interpretation) -> Vec<Trial> {
    let named = table.columns.iter().any(|column| column.name.is_some());
    let joint_lists = joint_lists(robot, table, found);
    let whole = |set: &PointSet| match set.columns {
        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
        _ => None,
    };
    let mut points: Vec<[usize; 3]> = found.points.iter().chain(&found.commanded.alone).filter_map(whole).collect();
    if !named {
        points.extend(consecutive(table, 3).into_iter().filter_map(|all| <[usize; 3]>::try_from(all).ok()));
    }
    let target = found.first(Meaning::Target).filter(|at| groups(&table.columns[*at]).is_some());
    let pairs = joint_lists.iter().flat_map(|joints| points.iter().map(move |points| (joints, points)));
    let apart = pairs.filter(|(joints, points)| points.iter().all(|at| !joints.contains(at)));
    apart.take(200).map(|(joints, points)| Trial { joints: joints.clone(), points: *points, target }).collect()
}

fn sample(table: &Table, trial: &Trial) -> Option<Sample> {
    let values = |at: usize| table.columns[at].values.clone();
    let unit = |at: &usize| table.columns[*at].heading.unit.filter(|unit| ["deg", "rad", "mm", "m"].contains(unit));
    let targets = match trial.target {
        Some(at) => groups(&table.columns[at])?,
        None => vec![0; table.rows],
    };
    let sample = Sample {
        joints: trial.joints.iter().map(|at| values(*at)).collect(),
        stated: trial.joints.iter().map(unit).collect(),
        points: trial.points.map(values),
        targets,
    };
    Some(sample.finite())
}

/// Corrects the interpretation to one that the robot supports.
fn apply(
    robot: &dyn Robot,
    trial: &Trial,
    reading: &Reading,
    table: &mut Table,
    found: &mut Interpretation,
) -> Remarks {
    let mut remarks = name_joints(robot, &trial.joints, reading, table, found);
    let value = |row: usize, k: usize| table.columns[trial.joints[k]].values.get(row).copied().unwrap_or(f64::NAN);
    let flanges: Vec<_> = (0..table.rows).map(|row| turned::flange(robot, reading, &|k| value(row, k))).collect();
    remarks.reasons.extend(turned::order(&flanges, &reading.base_R_world, table, found));
    if let (Some(at), None) = (trial.target, found.first(Meaning::Target)) {
        found.take(at, Meaning::Target, phrase!("why-targets-fit"));
        remarks.reasons.push(phrase!("robot-finds-targets", column = table.called(at)));
    }
    let placed = found.points.iter().chain(&found.commanded.alone).any(|set| set.columns == trial.points.map(Some));
    if !placed {
        for taken in &mut found.taken {
            if matches!(taken.meaning, Meaning::Point(..)) {
                taken.meaning = Meaning::Unknown;
            }
        }
        found.points = vec![PointSet { tag: String::new(), columns: trial.points.map(Some) }];
        for (axis, at) in trial.points.into_iter().enumerate() {
            found.take(at, Meaning::Point(0, axis), phrase!("why-robot-reproduces"));
        }
    }
    let mut kept: Vec<PointSet> = Vec::new();
    let sets: Vec<(PointSet, bool)> = found.points.iter().map(|set| (set.clone(), true)).collect();
    let called = found.commanded.alone.iter().map(|set| (set.clone(), false));
    let sets: Vec<(PointSet, bool)> = sets.into_iter().chain(called).collect();
    for (set, measured) in sets {
        let [Some(x), Some(y), Some(z)] = set.columns else {
            kept.extend(Some(set).filter(|_| measured));
            continue;
        };
        let points = [x, y, z];
        let of_set = sample(table, &Trial { points, ..trial.clone() });
        let fitted = of_set.and_then(|sample| confirmed(robot, &sample, reading));
        if let Some(fitted) = &fitted {
            described(table, points, fitted, measured, &mut remarks);
        }
        let origin = fitted.map_or(Origin::Measured, |fitted| fitted.origin);
        if measured && origin == Origin::Commanded {
            for (axis, at) in points.into_iter().enumerate() {
                found.take(at, Meaning::Commanded(axis), phrase!("why-robot-computes"));
            }
        } else if measured {
            for (axis, at) in points.into_iter().enumerate() {
                found.taken[at].meaning = Meaning::Point(kept.len(), axis);
            }
            kept.push(set);
        }
    }
    let before = std::mem::replace(&mut found.points, kept);
    let now = |number: usize| found.points.iter().position(|set| Some(set) == before.get(number));
    found.orientations.of_points =
        found.orientations.of_points.iter().filter_map(|(n, at)| Some((now(*n)?, *at))).collect();
    remarks
}

/// Names the joints according to the interpretation.
pub(crate) fn name_joints(
    robot: &dyn Robot,
    tried: &[usize],
    reading: &Reading,
    table: &mut Table,
    found: &mut Interpretation,
) -> Remarks {
    let mut remarks = Remarks::default();
    let of_robot = |k: usize| robot.joints()[k].name.clone();
    let columns: Vec<usize> = reading.order.iter().map(|i| tried[*i]).collect();
    let plain = columns.windows(2).all(|pair| pair[0] < pair[1]) || tried.starts_with(&columns);
    for taken in &mut found.taken {
        if matches!(taken.meaning, Meaning::Joint(_)) {
            // a joint of another axis, or no joint: nothing says that it is commanded
            taken.meaning = Meaning::Unknown;
            taken.why = Some(phrase!("why-fits-without"));
        }
    }
    for (k, at) in columns.iter().enumerate() {
        let unit = reading.units[k];
        if let Some(stated) = table.columns[*at].heading.unit.filter(|stated| *stated != unit) {
            let column = table.called(*at);
            remarks.doubts.push(phrase!("robot-contradicts-unit", column, stated, unit));
        }
        table.columns[*at].heading.unit = Some(unit);
        let way = if reading.reversed[k] { "reversed" } else { "forward" };
        found.take(*at, Meaning::Joint(k), phrase!("why-kinematics-fit", unit, way));
        if reading.reversed[k] {
            found.reversed.push(*at);
            remarks.reasons.push(phrase!("robot-reverses", column = table.called(*at), joint = of_robot(k)));
        }
    }
    let called: Vec<String> = columns.iter().map(|at| table.called(*at)).collect();
    if contradicts(robot, &columns, table) {
        remarks.doubts.push(phrase!("robot-contradicts-order", columns = called));
    } else if !plain {
        remarks.reasons.push(phrase!("robot-orders", columns = called));
    }
    found.joint_names = (0..columns.len()).map(of_robot).collect();
    found.by_kinematics = true;
    found.settle(Evidence::JointOrder);
    remarks
}

/// `true` if the headings of columns, in the order of the joints, name the joints in another order:
/// by numbers, by the names in robot.toml, or by the parts of an arm. Headings or robot file are
/// wrong.
fn contradicts(robot: &dyn Robot, columns: &[usize], table: &Table) -> bool {
    let column = |at: &usize| &table.columns[*at];
    let is_unsorted = |places: &[Option<usize>]| places.iter().all(Option::is_some) && !places.is_sorted();
    let by_number: Vec<Option<usize>> = columns.iter().map(|at| joint_number(&table.called(*at))).collect();
    // an external axis has a number of its own: `A1, A2, E1`
    let is_unique = by_number.iter().collect::<BTreeSet<_>>().len() == by_number.len();
    let by_part: Vec<Option<usize>> = columns.iter().map(|at| part_of_arm(&column(at).heading)).collect();
    let name = |at: &usize| column(at).name.as_deref().map(heading_without_unit);
    let by_name = |at: &usize| robot.joints().iter().position(|joint| Some(joint.name.as_str()) == name(at));
    let is_other = |(k, at): (usize, &usize)| by_name(at).is_some_and(|named| named != k);
    is_unique && is_unsorted(&by_number) || is_unsorted(&by_part) || columns.iter().enumerate().any(is_other)
}

/// Describes how well the robot reproduces points, and gives their unit.
pub(crate) fn described(
    table: &mut Table,
    points: [usize; 3],
    fitted: &Reading,
    measured: bool,
    remarks: &mut Remarks,
) {
    let named = points.map(|at| table.called(at)).join(", ");
    let Reading { rms_mm, rows, unit, origin, .. } = fitted;
    remarks.reasons.push(phrase!("robot-reproduces", points = named, rms_mm = *rms_mm, rows = *rows, unit = *unit));
    let residual_mm = Some(*rms_mm).filter(|rms_mm| rms_mm.is_finite());
    remarks.reproduced_mm = remarks.reproduced_mm.into_iter().chain(residual_mm).reduce(f64::max);
    for at in points {
        let heading = &mut table.columns[at].heading;
        let stated = heading.unit.filter(|stated| stated != unit && !heading.bare_metre);
        heading.unit = Some(unit);
        heading.bare_metre = false;
        heading.fitted = true;
        if let Some(stated) = stated {
            let column = table.called(at);
            remarks.doubts.push(phrase!("robot-contradicts-unit", column, stated, unit = *unit));
        }
    }
    let points = points.map(|at| table.called(at)).join(", ");
    match origin {
        Origin::Commanded if measured => remarks.doubts.push(phrase!("points-commanded", points, rms_mm = *rms_mm)),
        Origin::Undecided if measured => {
            remarks.doubts.push(phrase!("points-perhaps-commanded", points, rms_mm = *rms_mm))
        }
        _ => {}
    }
}

/// First number in a heading.
fn joint_number(heading: &str) -> Option<usize> {
    let digits = heading.trim_start_matches(|c: char| !c.is_ascii_digit());
    digits.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()
}
