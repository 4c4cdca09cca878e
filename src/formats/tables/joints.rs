//! Columns of joints in tables: values, directions and assembly modes.

use crate::table::{ASSEMBLY, Table, XYZ};
use etalon_base::message::{Message, Result};
use etalon_base::{error, phrase};
use etalon_robots::{Circumstance, Joint, Quantity, Robot, Role};

/// Columns of the payload of a reading: mass, and centre of mass in the flange.
pub const PAYLOAD: [&str; 4] = ["load_kg", "load_x_mm", "load_y_mm", "load_z_mm"];

/// Column of the temperature of the robot.
const TEMPERATURE: &str = "temperature_c";
/// Absolute zero (°C).
const COLDEST_C: f64 = -273.15;

/// Suffix of columns of torques.
const TORQUE: &str = "_nm";

/// Column of a value that each reading gives.
fn stated_column(robot: &dyn Robot, value: Circumstance) -> String {
    match value {
        Circumstance::PayloadMass => PAYLOAD[0].to_owned(),
        Circumstance::PayloadCentre(axis) => PAYLOAD[1 + axis].to_owned(),
        Circumstance::Torque(joint) => robot.joints()[joint].torque_column(),
        Circumstance::Temperature => TEMPERATURE.to_owned(),
    }
}

/// Columns of the values that each reading gives in addition to joints and directions.
pub fn stated_columns(robot: &dyn Robot) -> Vec<String> {
    robot.circumstances().iter().map(|value| stated_column(robot, *value)).collect()
}

/// `true` if a column may hold a value that readings of some robot state.
pub fn is_stated_column(column: &str) -> bool {
    PAYLOAD.contains(&column) || column == TEMPERATURE || column.ends_with(TORQUE)
}

/// Returns the joint values of each row (mm or rad), followed by the directions of joints with
/// backlash, and by the other values that each reading gives.
///
/// # Errors
/// Reports all missing columns of joints and of `needed`, and values that are not directions,
/// payloads, torques or temperatures.
pub fn joint_values(robot: &dyn Robot, table: &Table, needed: &[&str]) -> Result<Vec<Vec<f64>>> {
    let columns: Vec<(String, f64)> =
        robot.joints().iter().map(|joint| joint_column(joint, table)).collect::<Result<_>>()?;
    let needed = needed.iter().map(|name| (*name, length_unit(robot, table, name)));
    let angles = angle_unit(robot, table);
    let joints = robot.joints().iter().zip(&columns);
    let joints = joints.map(|(joint, c)| (c.0.as_str(), angles.filter(|_| joint.quantity == Quantity::Angle)));
    table.require_in(needed.chain(joints))?;
    let mut rows = vec![Vec::with_capacity(columns.len() + robot.approached().len()); table.height()];
    for (column, factor) in &columns {
        let values = table.numbers(column)?;
        rows.iter_mut().zip(values).for_each(|(row, v)| row.push(factor * v));
    }
    for &k in robot.approached() {
        let joint = &robot.joints()[k];
        let column = joint.direction_column();
        if !table.has(&column) {
            return Err(error!("joint-direction-missing", joint = &joint.name, column).into());
        }
        for (i, (row, direction)) in rows.iter_mut().zip(table.numbers(&column)?).enumerate() {
            // rows of fixed points have no joint values
            if let Some(message) = wrong_direction(joint, direction).filter(|_| row[k].is_finite()) {
                return Err(message.at(table.place(i)).into());
            }
            row.push(direction);
        }
    }
    add_stated(robot, table, &mut rows)?;
    Ok(rows)
}

/// Unit that the values of missing columns of revolute joints suggest: radians if all are within a
/// turn of radians.
fn angle_unit(robot: &dyn Robot, table: &Table) -> Option<&'static str> {
    const TURN: f64 = 2.0 * std::f64::consts::PI * 1.001;
    let revolute = robot.joints().iter().filter(|joint| joint.quantity == Quantity::Angle);
    let missing = revolute.filter(|joint| table.names().all(|name| joint.factor(name).is_none()));
    let headings: Vec<&str> = missing.filter_map(|joint| table.heading_for(&joint.column())).collect();
    let mut values = headings.iter().flat_map(|heading| table.plain_numbers(heading)).peekable();
    (headings.len() > 1 && values.peek().is_some() && values.all(|v| v.abs() <= TURN)).then_some("rad")
}

/// Smallest extent of measured positions, and largest, relative to the lengths of a robot.
const EXTENT: [f64; 2] = [0.02, 4.0];

/// Unit that the values of a missing column of a coordinate suggest: metres if the positions are a
/// point beside the robot in millimetres, and of its size in metres.
fn length_unit(robot: &dyn Robot, table: &Table, name: &str) -> Option<&'static str> {
    let place = XYZ.iter().position(|column| *column == name)?;
    let headings = XYZ[..robot.dimension().max(place + 1)].iter().filter_map(|name| table.heading_for(name));
    let range = |heading: &str| {
        let values = table.plain_numbers(heading);
        let [least, most] = [f64::min, f64::max].map(|of| values.iter().copied().reduce(of).unwrap_or(0.0));
        most - least
    };
    let extent = headings.map(range).fold(0.0, f64::hypot);
    let lengths = robot.parameters().iter().filter(|p| p.role == Role::Robot && p.quantity == Quantity::Length);
    let size_mm: f64 = lengths.map(|p| p.nominal.abs()).sum();
    let [least, most] = EXTENT.map(|share| share * size_mm);
    (extent > 0.0 && extent < least && (least..=most).contains(&(1000.0 * extent))).then_some("m")
}

/// Adds the values that each reading gives.
fn add_stated(robot: &dyn Robot, table: &Table, rows: &mut [Vec<f64>]) -> Result<()> {
    for (&stated, column) in robot.circumstances().iter().zip(&stated_columns(robot)) {
        if !table.has(column) {
            return Err(missing_column(robot, stated).into());
        }
        for (i, (row, value)) in rows.iter_mut().zip(table.numbers(column)?).enumerate() {
            // rows of fixed points have no joint values
            let is_pose = row.iter().all(|value| value.is_finite());
            if let Some(message) = wrong_value(robot, stated, value).filter(|_| is_pose) {
                return Err(message.at(table.place(i)).into());
            }
            row.push(value);
        }
    }
    Ok(())
}

/// Returns the error that a table does not have the column of a value that each reading gives.
pub fn missing_column(robot: &dyn Robot, stated: Circumstance) -> Message {
    let column = stated_column(robot, stated);
    match stated {
        Circumstance::PayloadMass | Circumstance::PayloadCentre(_) => error!("payload-column-missing", column),
        Circumstance::Torque(joint) => {
            error!("torque-column-missing", joint = &robot.joints()[joint].name, column)
        }
        Circumstance::Temperature => error!("temperature-column-missing", column),
    }
}

/// Returns the error about a value that does not suit its column.
pub fn wrong_value(robot: &dyn Robot, stated: Circumstance, value: f64) -> Option<Message> {
    let least = match stated {
        Circumstance::PayloadMass => 0.0,
        Circumstance::Temperature => COLDEST_C,
        _ => f64::NEG_INFINITY,
    };
    let wrong = !value.is_finite() || value < least;
    wrong.then(|| {
        let column = stated_column(robot, stated);
        let value = if value.is_nan() { "missing".to_owned() } else { value.to_string() };
        match stated {
            Circumstance::PayloadMass | Circumstance::PayloadCentre(_) => error!("payload-invalid", column, value),
            Circumstance::Torque(_) => error!("torque-invalid", column, value),
            Circumstance::Temperature => error!("temperature-invalid", column, value),
        }
    })
}

/// Returns the error that a value is not the direction from which a joint came.
pub fn wrong_direction(joint: &Joint, direction: f64) -> Option<Message> {
    let value = if direction.is_nan() { "missing".to_owned() } else { direction.to_string() };
    let column = joint.direction_column();
    (direction.abs() != 1.0).then(|| error!("joint-direction-invalid", joint = &joint.name, column, value))
}

/// Returns the column of a joint in one of its units, and the factor to mm or rad. If the table has
/// no such column, returns the name that it should have.
pub fn joint_column(joint: &Joint, table: &Table) -> Result<(String, f64)> {
    let mut found = table.names().filter_map(|name| Some((joint.factor(name)?, name)));
    match (found.next(), found.next()) {
        (Some((_, one)), Some((_, two))) => {
            let message = error!("joint-column-twice", joint = &joint.name, first = one, second = two);
            Err(message.at(table.header()).into())
        }
        (Some((factor, name)), None) => Ok((name.to_owned(), factor)),
        (None, _) => Ok((joint.column(), joint.quantity.inward(1.0))),
    }
}

/// Returns the assembly mode of each row; `None` for robots without modes, and without the column.
pub fn stated_modes(robot: &dyn Robot, table: &Table) -> Result<Vec<Option<f64>>> {
    if !robot.has_assembly_modes() || !table.has(ASSEMBLY) {
        return Ok(vec![None; table.height()]);
    }
    table.numbers(ASSEMBLY)?.into_iter().enumerate().map(|(row, value)| stated_mode(row, value)).collect()
}

/// Returns the assembly mode of a row (counted from 0); `None` if the value is not a number.
pub fn stated_mode(row: usize, value: f64) -> Result<Option<f64>> {
    match value {
        value if value.is_nan() => Ok(None),
        value if value.abs() == 1.0 => Ok(Some(value)),
        value => Err(error!("assembly-mode-invalid", value).within(phrase!("in-row", row = row + 1)).into()),
    }
}
