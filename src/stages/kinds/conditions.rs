//! Conditions and known things from the rows of a table.

use super::row::{LINE, Row};
use crate::stages::orientations::AngleOrder;
use etalon_base::message::{Message, Result};
use etalon_base::pose_name::PoseName;
use etalon_identify::{
    Condition, Contact, Coordinate, Distance, Fixture, JointValue, Kind, Known, On, Orientation, Seen, Settings,
    Surface,
};
use etalon_robots::{Quantity, Robot};

/// Kinds of rows.
const KINDS: [&str; 8] = ["point", "pose", "distance", "contact", "plane", "line", "sphere", "joints"];
/// Axes of the world.
const AXES: [&str; 3] = ["x", "y", "z"];

impl Row {
    /// Adds what the row states to `settings`, unless it is the position of a target alone.
    pub fn add_to(&self, settings: &mut Settings, robot: &mut dyn Robot, order: Option<AngleOrder>) -> Result<()> {
        let kind = self.kind.as_str();
        if !KINDS.contains(&kind) {
            return Err(Message::error(format!("`{kind}` is not a kind of observation"))
                .hint_names(kind, KINDS)
                .into());
        }
        if let Some(name) = &self.station {
            self.seen_whole(kind, name)?;
        }
        let Some(pose) = self.pose else {
            settings.known.push(self.known(kind, robot)?);
            return Ok(());
        };
        let kind = match kind {
            "pose" => {
                let mounting = Fixture::Mounting(&self.target).add_to(robot);
                Kind::Orientation(Orientation { world_T_body: self.orientation.pose(order)?, mounting })
            }
            "distance" => {
                let to = fixture("other", &self.other, robot)?;
                Kind::Distance(Distance { to, distance_mm: self.distance()? })
            }
            "contact" => Kind::Contact(Contact { socket: fixture("socket", &self.socket, robot)? }),
            "plane" | "line" | "sphere" => {
                let (surface, unknowns) = self.surface(kind, robot)?;
                let offset_mm = match self.offset_mm {
                    offset if kind == "line" && offset.is_nan() => 0.0,
                    offset if kind == "line" && offset != 0.0 => {
                        return Err(Message::error("`offset_mm` is of planes and spheres, not of a line").into());
                    }
                    offset if !offset.is_finite() => {
                        return Err(Message::error("`offset_mm` is missing or not a number")
                            .expected("how far the target is from the plane along that axis, or outside of the sphere: the radius of a ball, or 0")
                            .into());
                    }
                    offset => offset,
                };
                Kind::On(On { surface, unknowns, offset_mm })
            }
            "joints" => self.joint(robot)?,
            "point" if self.is_partial => {
                for axis in (0..3).filter(|&axis| !self.xyz_mm[axis].is_nan()) {
                    let kind = Kind::Coordinate(Coordinate { axis, at_mm: self.xyz_mm[axis] });
                    settings.conditions.push(self.condition(pose, kind, self.u_axes_mm[axis], robot)?);
                }
                return Ok(());
            }
            _ => match &self.station {
                Some(name) => Kind::Seen(Seen { station: station(name, robot)?, at_mm: self.xyz_mm }),
                None => return Ok(()),
            },
        };
        let stated = if kind.is_angle() { self.u_rotation_rad } else { self.u_mm };
        settings.conditions.push(self.condition(pose, kind, stated, robot)?);
        Ok(())
    }

    /// The condition with a standard uncertainty, or that of the row where it is not a number.
    fn condition(&self, pose: PoseName, kind: Kind, stated: f64, robot: &dyn Robot) -> Result<Condition> {
        let stated = if stated.is_nan() && !kind.is_angle() { self.u_mm } else { stated };
        if self.joints.iter().any(|q| !q.is_finite()) {
            return Err(Message::error("a joint value is missing or not a number").into());
        }
        let name = &self.target;
        let target = match kind {
            Kind::Joint(_) if name.is_empty() => 0,
            _ => {
                let found = robot.targets().iter().position(|target| target == name);
                found.ok_or_else(|| Message::error(format!("`{name}` is not a target of this robot")))?
            }
        };
        let standard_uncertainty = positive(stated, kind.is_angle())?;
        Ok(Condition { pose, cycle: self.cycle, joints: self.joints.clone(), target, kind, standard_uncertainty })
    }

    /// What a row without a pose states of fixed points.
    fn known(&self, kind: &str, robot: &mut dyn Robot) -> Result<Known> {
        let name = named("target", &self.target)?;
        is_fixed_name(name, robot)?;
        let standard_uncertainty_mm = positive(self.u_mm, false)?;
        if kind == "sphere" && self.xyz_mm.iter().all(|v| v.is_nan()) {
            let parameter = Fixture::Radius(name).add_to(robot);
            return Ok(Known::Length { parameter, length_mm: self.distance()?, standard_uncertainty_mm });
        }
        if matches!(kind, "plane" | "line" | "sphere") {
            let (surface, unknowns) = self.surface(kind, robot)?;
            let place_mm = self.xyz_mm;
            if place_mm.iter().any(|v| !v.is_finite()) {
                return Err(Message::error(format!("the place of `{name}` is missing or not a number")).into());
            }
            return Ok(Known::On { surface, unknowns, place_mm, standard_uncertainty_mm });
        }
        let point = Fixture::Point(name).add_to(robot);
        match kind {
            "point" if self.xyz_mm.iter().all(|v| v.is_finite()) => {
                if let Some(name) = &self.station {
                    let (station, at_mm) = (station(name, robot)?, self.xyz_mm);
                    return Ok(Known::Seen { station, point, at_mm, standard_uncertainty_mm });
                }
                Ok(Known::Place { point, place_mm: self.xyz_mm, standard_uncertainty_mm })
            }
            "point" => Err(Message::error(format!("the place of `{name}` is missing or not a number")).into()),
            "distance" => {
                let to = fixture("other", &self.other, robot)?;
                if to == point {
                    return Err(Message::error(format!("a distance from `{name}` to itself")).into());
                }
                Ok(Known::Distance { from: point, to, distance_mm: self.distance()?, standard_uncertainty_mm })
            }
            kind => Err(Message::error(format!("a row of kind `{kind}` has no pose"))
                .hint("rows without a pose state places (`point`) and distances (`distance`) of fixed points, and places on a `plane`, `line` or `sphere`")
                .into()),
        }
    }

    /// An error where a row of another station is not a point with all coordinates and one uncertainty.
    fn seen_whole(&self, kind: &str, station: &str) -> Result<()> {
        let us = self.u_axes_mm;
        let what = match self.xyz_mm.iter().all(|v| v.is_finite()) {
            _ if kind != "point" => format!("a row of kind `{kind}` states the station `{station}`"),
            false => format!("a coordinate of what station `{station}` measured is missing or not a number"),
            true if self.has_covariance => format!("what station `{station}` measured states a covariance"),
            true if us[1..].iter().any(|u| u.to_bits() != us[0].to_bits()) => {
                format!("the coordinates that station `{station}` measured have uncertainties of their own")
            }
            true => return Ok(()),
        };
        let expected =
            "rows of kind `point` with x_mm, y_mm, z_mm and one uncertainty `u_mm`, for stations other than the first";
        Err(Message::error(what).expected(expected).into())
    }

    /// The plane, line or sphere of a row, and its parameters.
    fn surface(&self, kind: &str, robot: &mut dyn Robot) -> Result<(Surface, [usize; 4])> {
        if kind == "sphere" {
            let name = named("sphere", &self.sphere)?;
            is_fixed_name(name, robot)?;
            let (first, radius) = (Fixture::Point(name).add_to(robot), Fixture::Radius(name).add_to(robot));
            return Ok((Surface::Sphere, [first, first + 1, first + 2, radius]));
        }
        let name = match kind {
            "plane" => named(kind, &self.plane)?,
            _ => named(LINE, &self.line_name)?,
        };
        let axis = AXES.iter().position(|axis| *axis == self.axis).ok_or_else(|| match kind {
            "plane" => {
                Message::error(format!("the plane `{name}` needs the axis of the world that is nearest to its normal"))
                    .expected("x, y or z in the column `axis`: z for a table, x or y for a wall")
            }
            _ => Message::error(format!("the line `{name}` needs the axis of the world that is nearest to it"))
                .expected("x, y or z in the column `axis`"),
        })?;
        Ok(match kind {
            "plane" => {
                let first = Fixture::Plane(name, axis).add_to(robot);
                (Surface::Plane { axis }, [first, first + 1, first + 2, first + 2])
            }
            _ => {
                let first = Fixture::Line(name, axis).add_to(robot);
                (Surface::Line { axis }, [first, first + 1, first + 2, first + 3])
            }
        })
    }

    /// The value of a joint as it is.
    fn joint(&self, robot: &dyn Robot) -> Result<Kind> {
        let name = named("joint", &self.joint)?;
        let names = || robot.joints().iter().map(|j| j.name.as_str());
        let Some(joint) = names().position(|other| other == name) else {
            let what = format!("`{name}` is not a joint of this robot");
            return Err(Message::error(what).hint_names(name, names()).into());
        };
        let modelled = robot
            .free_base()
            .and_then(|arm| arm.joint_value(&robot.nominal(), &vec![0.0; robot.joints().len()], joint, &mut |_, _| ()));
        if modelled.is_none() {
            let what = format!("values of joints are for arms in space, not for `{}`", robot.model());
            return Err(Message::error(what).into());
        }
        let is_angle = robot.joints()[joint].quantity == Quantity::Angle;
        let value = if is_angle { self.value_rad } else { self.value_mm };
        if !value.is_finite() {
            let column = if is_angle { "value_deg" } else { "value_mm" };
            return Err(Message::error(format!("`{column}` is missing or not a number"))
                .expected("the value of the joint by the switch or second encoder")
                .into());
        }
        Ok(Kind::Joint(JointValue { joint, value, is_angle }))
    }

    fn distance(&self) -> Result<f64> {
        let d = self.distance_mm;
        match d.is_finite() && d > 0.0 {
            true => Ok(d),
            false => {
                Err(Message::error("`distance_mm` is missing or not a length").expected("a length above 0").into())
            }
        }
    }
}

/// The first parameter of a station.
fn station(name: &str, robot: &mut dyn Robot) -> Result<usize> {
    is_fixed_name(name, robot)?;
    Ok(Fixture::Station(name).add_to(robot))
}

/// The first parameter of the fixed point that a column names.
fn fixture(column: &str, name: &str, robot: &mut dyn Robot) -> Result<usize> {
    let name = named(column, name)?;
    is_fixed_name(name, robot)?;
    Ok(Fixture::Point(name).add_to(robot))
}

fn is_fixed_name(name: &str, robot: &dyn Robot) -> Result<()> {
    match robot.targets().iter().any(|target| target == name) || name == "base" {
        true => Err(Message::error(format!("`{name}` is a target on the robot, not a fixed point"))
            .hint("give fixed points names of their own; rows about them alone have no pose")
            .into()),
        false => Ok(()),
    }
}

fn named<'a>(column: &str, name: &'a str) -> Result<&'a str> {
    match name.is_empty() {
        true => Err(Message::error(format!("the column `{column}` is empty or missing")).into()),
        false => Ok(name),
    }
}

fn positive(standard_uncertainty: f64, is_angle: bool) -> Result<f64> {
    let (column, option) = match is_angle {
        true => ("urot_deg", "--rotation-uncertainty-deg"),
        false => ("u_mm", "--standard-uncertainty-um"),
    };
    match standard_uncertainty {
        u if u > 0.0 && u.is_finite() => Ok(u),
        u if !u.is_nan() => Err(Message::error(format!("`{column}` = {u} is not a standard uncertainty")).into()),
        _ => Err(Message::error("the row has no standard uncertainty")
            .hint(format!("state {option}, or a column `{column}`"))
            .into()),
    }
}
