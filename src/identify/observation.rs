//! Observations: where the targets were, the joint values, and which of two assembly modes they leave.

use super::weights::{Covariance, covariances};
use etalon_base::message::{Message, Place, Result};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::table::{self, ASSEMBLY};
use etalon_robots::{Joint, Robot};
use polars::prelude::DataFrame;

/// One pose of one cycle: joint values and the targets that were measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Observation {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the repeat.
    pub cycle: i64,
    /// Joint values in mm or rad, in the robot's order, and behind them the assembly mode of robots that have several.
    pub joints: Vec<f64>,
    /// Measured positions in the world in mm, in the order of the robot's targets; `None` where not measured.
    pub targets: Vec<Option<Vector>>,
    /// Covariances of these positions in the world, where their measurement states them; empty where it does not.
    pub covariances_mm2: Vec<Option<Covariance>>,
}

impl Observation {
    /// Observations of `robot` from the tidy table (one row per pose, cycle and target), in the order of the table.
    ///
    /// Robots with assembly modes may bring several working modes to one pose and cycle: other joint values are then
    /// another observation. What was taken from the measurement is in `messages`.
    pub fn from_table(robot: &dyn Robot, table: &DataFrame, messages: &mut Vec<Message>) -> Result<Vec<Self>> {
        let joints = joint_values(robot, table, &["pose", "cycle", "target", table::XYZ[0], table::XYZ[1]])?;
        let poses = table::poses(table)?;
        let cycles = table::integers(table, "cycle")?;
        let names = table::texts(table, "target")?;
        let xyz = table::coordinates(table)?;
        if robot.dimension() == 3 && table::numbers(table, table::XYZ[2])?.iter().any(|z| z.is_nan()) {
            return Err(Message::error("observations of a robot in space lack `z_mm`").into());
        }
        let stated = stated_modes(robot, table)?;
        let covariances = covariances(table, robot.dimension())?;
        let weighted = covariances.iter().any(Option::is_some);
        let mut observations: Vec<Self> = Vec::new();
        let mut modes = Vec::new();
        let mut place = std::collections::BTreeMap::new();
        let lines = if table.column("line").is_ok() { table::integers(table, "line")? } else { Vec::new() };
        let line = |row: usize| Place { line: lines.get(row).map(|l| *l as usize), ..Place::default() };
        for row in 0..table.height() {
            let what = || format!("pose {} cycle {} of the observations", poses[row], cycles[row]);
            let target = robot.targets().iter().position(|t| *t == names[row]).ok_or_else(|| {
                let message = Message::error(format!("{}: `{}` is not a target of this robot", what(), names[row]));
                message.at(line(row)).hint_names(&names[row], robot.targets().iter().map(String::as_str))
            })?;
            let here = &joints[row];
            if here.iter().chain(&xyz[row]).any(|v| !v.is_finite()) {
                let message = Message::error(format!("{}: a value is missing or not a number", what()));
                return Err(message.at(line(row)).into());
            }
            let mode = if robot.has_assembly_modes() { here.iter().map(|q| q.to_bits()).collect() } else { Vec::new() };
            let k = *place.entry((poses[row], cycles[row], mode)).or_insert_with(|| {
                modes.push(stated[row]);
                observations.push(Self {
                    pose: poses[row],
                    cycle: cycles[row],
                    joints: here.clone(),
                    targets: vec![None; robot.targets().len()],
                    covariances_mm2: vec![None; if weighted { robot.targets().len() } else { 0 }],
                });
                observations.len() - 1
            });
            if observations[k].joints != *here {
                let message = Message::error(format!("{}: its rows disagree on the joint values", what()));
                return Err(message.at(line(row)).into());
            }
            if weighted {
                observations[k].covariances_mm2[target] = covariances[row];
            }
            if observations[k].targets[target].replace(xyz[row]).is_some() {
                return Err(Message::error(format!("{}: target `{}` occurs twice", what(), names[row]))
                    .at(line(row))
                    .hint("number repeats in the column `cycle`")
                    .into());
            }
        }
        if observations.is_empty() {
            return Err(Message::error("there are no observations").into());
        }
        if robot.has_assembly_modes() {
            messages.extend(assign_modes(robot, &mut observations, &modes)?);
        }
        Ok(observations)
    }
}

impl Observation {
    /// The measured targets that state an uncertainty, by index: root mean square of the standard uncertainties of its coordinates, mm.
    pub(super) fn uncertainties_mm(&self, dimension: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let stated = self.covariances_mm2.iter().zip(&self.targets).enumerate();
        let measured = stated.filter_map(|(k, (covariance, at))| Some((k, (*covariance)?, (*at)?)));
        let mean = move |c: Covariance| ((0..dimension).map(|i| c[i][i]).sum::<f64>() / dimension as f64).sqrt();
        measured.map(move |(k, covariance, _)| (k, mean(covariance)))
    }

    /// For each measured target its index, and its measured position minus where `values` put it, mm.
    pub fn misses<'o>(&'o self, robot: &'o dyn Robot, values: &'o [f64]) -> impl Iterator<Item = (usize, Vector)> + 'o {
        let measured = self.targets.iter().enumerate().filter_map(|(k, target)| Some((k, (*target)?)));
        measured.map(move |(k, target)| (k, minus(target, robot.position(values, &self.joints, k))))
    }
}

/// Joint values of each row of a table, in mm or rad, and behind them the directions of the joints that came from one side. Columns that are
/// `needed` beside them are missed with theirs.
pub fn joint_values(robot: &dyn Robot, table: &DataFrame, needed: &[&str]) -> Result<Vec<Vec<f64>>> {
    let columns: Vec<(String, f64)> =
        robot.joints().iter().map(|joint| joint_column(joint, table)).collect::<Result<_>>()?;
    let needed = needed.iter().map(|name| (*name).to_owned());
    table::require(table, &needed.chain(columns.iter().map(|c| c.0.clone())).collect::<Vec<_>>())?;
    let mut rows = vec![Vec::with_capacity(columns.len() + robot.approached().len()); table.height()];
    for (column, factor) in &columns {
        let values = table::numbers(table, column)?;
        rows.iter_mut().zip(values).for_each(|(row, v)| row.push(factor * v));
    }
    for &k in robot.approached() {
        let Joint { name, .. } = &robot.joints()[k];
        let column = robot.joints()[k].direction_column();
        let expected = format!("+1 where `{name}` came from below, -1 from above, in a column `{column}`");
        if table.column(&column).is_err() {
            let what = format!("`backlash` of joint `{name}` needs the direction from which it came");
            let hint =
                "a campaign takes it from a log with times; or remove the joint from `backlash` of the robot file";
            return Err(Message::error(what).expected(expected).hint(hint).into());
        }
        for (i, (row, direction)) in rows.iter_mut().zip(table::numbers(table, &column)?).enumerate() {
            // rows about fixed points alone have no joint values
            if direction.abs() != 1.0 && row[k].is_finite() {
                let line = table::integers(table, "line").ok().map(|lines| lines[i] as usize);
                let what = if direction.is_nan() { "missing".to_owned() } else { direction.to_string() };
                let message = Message::error(format!("`{column}` is {what}")).expected(expected);
                return Err(message.at(Place { line, ..Place::default() }).into());
            }
            row.push(direction);
        }
    }
    Ok(rows)
}

/// The directions from which a joint came to `values` that follow each other, those of its last motions by more than `still`: `None`
/// before the first.
pub fn directions(values: impl Iterator<Item = f64>, still: f64) -> Vec<Option<f64>> {
    let (mut last, mut direction) = (None, None);
    let next = |value: f64| {
        let from = *last.get_or_insert(value);
        if (value - from).abs() > still {
            direction = Some((value - from).signum());
            last = Some(value);
        }
        direction
    };
    values.map(next).collect()
}

/// The column of a joint, in one of its units, and what takes its values to mm or rad; without one the column that is missing.
pub fn joint_column(joint: &Joint, table: &DataFrame) -> Result<(String, f64)> {
    let names = table.get_column_names().into_iter().map(|name| name.to_string());
    let mut found = names.filter_map(|name| Some((joint.factor(&name)?, name)));
    match (found.next(), found.next()) {
        (Some((_, one)), Some((_, two))) => {
            let message = Message::error(format!("the table has joint `{}` twice: `{one}` and `{two}`", joint.name));
            Err(message.at(Place { line: Some(1), ..Place::default() }).hint("leave one of them out").into())
        }
        (Some((factor, name)), None) => Ok((name, factor)),
        (None, _) => Ok((joint.column(), joint.quantity.inward(1.0))),
    }
}

/// The farther position must be off by this many times what the nearer one is, to be distinguished from it.
const CLEAR: f64 = 2.0;

/// The assembly mode that each row of a table states; all `None` for robots without, or without the column.
pub fn stated_modes(robot: &dyn Robot, table: &DataFrame) -> Result<Vec<Option<f64>>> {
    if !robot.has_assembly_modes() || table.column(ASSEMBLY).is_err() {
        return Ok(vec![None; table.height()]);
    }
    let mode = |(row, value): (usize, f64)| match value {
        value if value.is_nan() => Ok(None),
        value if value.abs() == 1.0 => Ok(Some(value)),
        value => Err(Message::error(format!("row {} states the assembly mode {value}", row + 1))
            .expected("1, -1 or nothing in the column `assembly`")
            .into()),
    };
    table::numbers(table, ASSEMBLY)?.into_iter().enumerate().map(mode).collect()
}

/// Appends to the joint values of every observation its assembly mode: as `stated`, or the one whose position at nominal
/// parameters is nearer to the measured one. Gives a message that says what was taken.
fn assign_modes(
    robot: &dyn Robot,
    observations: &mut [Observation],
    stated: &[Option<f64>],
) -> Result<Option<Message>> {
    let nominal = robot.nominal();
    let (mut taken, mut least_clear): ([usize; 2], Option<(PoseName, f64, f64)>) = ([0, 0], None);
    for (o, stated) in observations.iter_mut().zip(stated) {
        let mode = match stated {
            Some(mode) => *mode,
            None => {
                let (mode, near_mm, far_mm) = nearer(robot, &nominal, o)?;
                taken[usize::from(mode < 0.0)] += 1;
                if least_clear.is_none_or(|(_, near, far)| near_mm / far_mm > near / far) {
                    least_clear = Some((o.pose, near_mm, far_mm));
                }
                mode
            }
        };
        o.joints.push(mode);
    }
    Ok(least_clear.map(|(pose, near_mm, far_mm)| {
        Message::warning(format!(
            "the assembly mode of {} observations was taken from the measurement: {} in mode +1, {} in mode -1; least \
             clear is pose {pose}, {near_mm:.1} mm from one and {far_mm:.1} mm from the other",
            taken[0] + taken[1],
            taken[0],
            taken[1]
        ))
        .hint("state a column `assembly` with 1 or -1 where the log has it")
    }))
}

/// Observations that the parameters `values` put far from where they were measured in the assembly mode that they state,
/// and near in the other; how far in both, in mm. Empty where most are: the base is then elsewhere.
pub(super) fn misplaced<'o>(
    robot: &dyn Robot,
    observations: &'o [Observation],
    values: &[f64],
) -> Vec<(&'o Observation, (f64, f64))> {
    if !robot.has_assembly_modes() {
        return Vec::new();
    }
    let both = |o: &'o Observation| {
        let mode = *o.joints.last()?;
        let (stated, other) = (off(robot, values, o, mode), off(robot, values, o, -mode));
        (CLEAR * other < stated).then_some((o, (stated, other)))
    };
    let wrong: Vec<_> = observations.iter().filter_map(both).collect();
    if 2 * wrong.len() < observations.len() { wrong } else { Vec::new() }
}

/// How far the farthest target was measured from where `values` put it in an assembly mode, mm.
fn off(robot: &dyn Robot, values: &[f64], o: &Observation, mode: f64) -> f64 {
    let mut joints = o.joints[..robot.joints().len()].to_vec();
    joints.push(mode);
    let miss =
        |(k, measured): (usize, &Option<Vector>)| Some(norm(minus((*measured)?, robot.position(values, &joints, k))));
    let larger = |worst: f64, d: f64| if d > worst || d.is_nan() { d } else { worst };
    o.targets.iter().enumerate().filter_map(miss).fold(0.0, larger)
}

/// The mode that fits better, and by how much both are off.
fn nearer(robot: &dyn Robot, nominal: &[f64], o: &Observation) -> Result<(f64, f64, f64)> {
    let (plus, minus) = (off(robot, nominal, o, 1.0), off(robot, nominal, o, -1.0));
    let (mode, near_mm, far_mm) = if minus < plus { (-1.0, minus, plus) } else { (1.0, plus, minus) };
    let at = || format!("pose {} cycle {}", o.pose, o.cycle);
    if !near_mm.is_finite() || !far_mm.is_finite() {
        return Err(Message::error(format!(
            "{}: with nominal parameters the arms do not meet at these joint values",
            at()
        ))
        .hint("check unit, sign and offset of the joints, and the nominal parameters")
        .into());
    }
    if CLEAR * near_mm >= far_mm {
        let what = format!(
            "{}: both assembly modes fit equally well, {near_mm:.2} mm and {far_mm:.2} mm from the measured position",
            at()
        );
        return Err(Message::error(what)
            .hint("state a column `assembly` with 1 or -1; or state the place of the base (x_o, y_o, phi) under [nominal]")
            .into());
    }
    Ok((mode, near_mm, far_mm))
}
