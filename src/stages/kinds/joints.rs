//! The value of a joint from a home switch or a second encoder.

use super::kind::spatial_arm_message;
use super::{Cells, Facts, Row, RowKind, Simulated};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_identify::{JointValue, Kind};
use etalon_robots::{Quantity, Robot};

pub(super) struct Joints;

impl RowKind for Joints {
    fn facts(&self) -> Facts {
        let numbers = vec!["value_deg", "value_mm"];
        Facts { name: "joints", numbers, is_of_robot: true, ..Facts::default() }
    }

    fn observed(&self, row: &Row, robot: &mut dyn Robot) -> Result<Vec<(Kind, f64)>> {
        let joint = joint(&row.cells, robot)?;
        value(robot, &robot.nominal(), &vec![0.0; robot.joints().len()], joint)?;
        let quantity = robot.joints()[joint].quantity;
        let column = column(quantity);
        let missing = || error!("number-missing", column);
        let stated = row.cells.number(column).filter(|value| value.is_finite()).ok_or_else(missing)?;
        let is_angle = quantity == Quantity::Angle;
        let value = if is_angle { stated.to_radians() } else { stated };
        Ok(vec![(Kind::Joint(JointValue { joint, value, is_angle }), f64::NAN)])
    }

    fn simulated(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<Simulated> {
        let joint = joint(cells, robot)?;
        Ok(Simulated::anywhere(move |at| {
            let value = value(at.robot, at.values, at.joints, joint)?;
            let quantity = at.robot.joints()[joint].quantity;
            let sigma = if quantity == Quantity::Angle { at.sigma_rad.clone()? } else { at.sigma_mm };
            Ok(vec![(column(quantity), quantity.outward(value + at.noise.gaussian(sigma)))])
        }))
    }
}

/// Column of the value.
fn column(quantity: Quantity) -> &'static str {
    if quantity == Quantity::Angle { "value_deg" } else { "value_mm" }
}

/// The joint that the cells name.
fn joint(cells: &Cells, robot: &dyn Robot) -> Result<usize> {
    let name = cells.name("joint")?;
    let names = || robot.joints().iter().map(|joint| joint.name.as_str());
    let unknown = || error!("not-of-this-robot", name, kind = "joint").hint_names(name, names());
    Ok(names().position(|other| other == name).ok_or_else(unknown)?)
}

/// Motion of the joint at logged joint values (mm or rad).
fn value(robot: &dyn Robot, values: &[f64], joints: &[f64], joint: usize) -> Result<f64> {
    let value = robot.free_base().and_then(|arm| arm.joint_value(values, joints, joint, &mut |_, _| ()));
    Ok(value.ok_or_else(|| spatial_arm_message("joints", robot))?)
}
